"""The picture at the top of README.md: a page and its drawing side by side, on white."""

from __future__ import annotations

import io
import sys
from importlib import import_module
from pathlib import Path

from gallery import page_or_drawing
from pictures import picture_of

from kurbel.commands.shown import Drawing

PLACE = Path(__file__).parents[1] / "_static" / "page-and-drawing.png"
PAGE = ("table", "--ratio", "1:5", "--lang", "en")
HEIGHT, GAP, MARGIN = 720, 60, 30


def picture() -> bytes:
    """Return the PNG, grey, of the page of the README and of the same page as a drawing."""
    images = import_module("PIL.Image")
    drawing = page_or_drawing((*PAGE, "-f", "svg"))
    assert isinstance(drawing, Drawing)
    parts = [
        images.open(io.BytesIO(content)).convert("LA")
        for content in (picture_of(page_or_drawing(PAGE)).content, drawing.image("png"))
    ]
    parts = [one.resize((round(one.width * HEIGHT / one.height), HEIGHT)) for one in parts]
    width = sum(one.width for one in parts) + GAP + 2 * MARGIN
    sheet = images.new("L", (width, HEIGHT + 2 * MARGIN), 255)
    left = MARGIN
    for one in parts:
        sheet.paste(one.getchannel("L"), (left, MARGIN), one.getchannel("A"))
        left += one.width + GAP
    stream = io.BytesIO()
    sheet.quantize(16).save(stream, "PNG", optimize=True)
    return stream.getvalue()


if __name__ == "__main__":
    PLACE.write_bytes(picture())
    sys.exit()
