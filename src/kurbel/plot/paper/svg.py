"""The last touch of an SVG file: what it shows in words, and black in the colour of the page's text."""

from __future__ import annotations

import re
from html import escape

from kurbel.plot.paper.letters import joined
from kurbel.plot.style import BLACK, PALE

_ROOT = re.compile(r"<svg\b[^>]*>")
# Light lines and areas are black ones that hardly cover, so that they are faint on dark pages too.
_FAINT = "{0}: currentColor; {0}-opacity: 0.16"
# Fonts like those of the drawing, for text that is set anew where these are not to be had.
_FACE, _LIKE = "'STIXGeneral'", "'STIXGeneral', 'STIX Two Text', 'Times New Roman', serif"


def finished(svg: str, about: str, text: bool) -> str:
    """Return the file with a description for readers that do not see it, beside the title that it has, and,
    where it has `text`, with that in words. Only inside `style`.

    Lines and letters that were black have the colour of the text of a page that the file is part of; by
    itself they are black.
    """
    svg = joined(svg) if text else svg
    for part in ("stroke", "fill"):
        svg = svg.replace(f"{part}: {PALE}", _FAINT.format(part))
    svg = svg.replace(BLACK, "currentColor").replace(_FACE, _LIKE)
    svg = _ROOT.sub(lambda root: f'{root[0][:-1]} role="img" fill="currentColor">', svg, count=1)
    told = f" <desc>{escape(about, quote=False)}</desc>\n" if about else ""
    return svg.replace(" <metadata>", f"{told} <metadata>", 1)
