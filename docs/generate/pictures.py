"""Pictures of tables and drawings for the gallery: ink on nothing, so that dark pages can turn it round."""

from __future__ import annotations

import io
from importlib import import_module
from typing import Any, NamedTuple

from kurbel.commands.shown import Drawing, Table

# A table is set by Typst on a page of this width, and cut out of it.
PAGE = """#set page(width: 170mm, height: auto, margin: 4mm, fill: none)
#set text(font: "Libertinus Serif", size: 10pt)
"""
# Screens with two dots a pixel show it sharp.
DOTS_PER_INCH, DOTS = 192, 2
SMALL = (480, 300)


class Picture(NamedTuple):
    """A picture as a file, its size in pixels, and a small one of its upper part."""

    suffix: str
    content: bytes
    width: int
    height: int
    small: bytes


def picture_of(made: Table | Drawing) -> Picture:
    return _of_drawing(made) if isinstance(made, Drawing) else _of_table(made)


def _of_table(table: Table) -> Picture:
    """Return a PNG in a few shades of black."""
    text = PAGE + table.typeset("typst")
    page = _opened(import_module("typst").compile(text.encode(), format="png", ppi=DOTS_PER_INCH))
    shade = page.getchannel("A")
    ink = _merged(
        "LA", (_images().new("L", shade.size), shade.point([17 * round(one / 17) for one in range(256)]))
    )
    ink = ink.crop(shade.getbbox())
    width, height = (size // DOTS for size in ink.size)
    return Picture(".png", _written(ink), width, height, _small(ink))


def _of_drawing(drawing: Drawing) -> Picture:
    """Return the SVG, and of its PNG a small one without the white ground."""
    paper = _opened(drawing.image("png")).convert("RGB")
    chops = import_module("PIL.ImageChops")
    # As little white is taken away as leaves one of the three colours full.
    grounds = chops.darker(chops.darker(*paper.split()[:2]), paper.getchannel("B"))
    ink = _merged("RGBA", (*paper.split(), chops.invert(grounds)))
    width, height = drawing.figure.get_size_inches()
    return Picture(".svg", drawing.image("svg"), round(96 * width), round(96 * height), _small(ink))


def _small(ink: Any) -> bytes:
    """Return the upper part of a picture in its width."""
    width, height = SMALL
    scale = width / ink.width
    upper = ink.crop((0, 0, ink.width, min(ink.height, round(height / scale))))
    return _written(upper.resize((width, round(upper.height * scale))))


def _opened(content: bytes) -> Any:
    return _images().open(io.BytesIO(content))


def _merged(mode: str, channels: tuple[Any, ...]) -> Any:
    return _images().merge(mode, channels)


def _written(picture: Any) -> bytes:
    stream = io.BytesIO()
    picture.save(stream, "PNG", optimize=True)
    return stream.getvalue()


def _images() -> Any:
    return import_module("PIL.Image")
