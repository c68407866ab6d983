"""A drawing inside of an HTML page: SVG that shares its ids and its style with nothing around it."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from kurbel.plot_style import image

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_ID = re.compile(r'(\bid="|\bhref="#|\burl\(#)')
_TITLE = re.compile(r"<title>(.*?)</title>", re.DOTALL)
# A style element would be of the whole page. These two properties are inherited as well.
_STYLE = re.compile(r'\s*<defs>\s*<style type="text/css">\*\{(.*?)\}</style>\s*</defs>', re.DOTALL)
_METADATA = re.compile(r"\s*<metadata>.*?</metadata>", re.DOTALL)


def inline_svg(figure: Figure, title: str, name: str) -> str:
    """Return the svg element of a figure, whose ids all begin with the name.

    The title, plain text, is what a screen reader says.
    """
    text = image(figure, "svg", title).decode()
    text = _METADATA.sub("", text[text.index("<svg") :])
    style = _STYLE.search(text)
    assert style
    text = _ID.sub(rf"\g<1>{name}-", text.replace(style[0], "", 1))
    text = _TITLE.sub(rf'<title id="{name}-title">\1</title>', text, count=1)
    opening = (
        f'<svg role="img" aria-labelledby="{name}-title" style="{style[1]}; max-width: 100%; height: auto"'
    )
    # Spaces at the ends of lines are what other tools of an author take away.
    return re.sub(r"[ \t]+$", "", text.replace("<svg", opening, 1), flags=re.MULTILINE)
