"""A construction as an HTML page whose steps are clicked through."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING

from kurbel.formats.html.lesson import lesson
from kurbel.page.build import build
from kurbel.plot.construct.steps import step_of

if TYPE_CHECKING:
    from kurbel.books.constructions.page import ConstructionRequest

_ID = re.compile(r'<g id="([^"]+)">')


def construction_page(request: ConstructionRequest, svg: str, decimal: str | None) -> str:
    """Return the page of a construction of which this is the drawing, an SVG file."""
    shown, table = request.construction, build(request)
    # The steps stand beside the drawing; below the table would be a second list of them.
    below = replace(table, notes=table.notes[len(shown.steps) :])
    texts = [shown.overlined(step.text[request.lang]) for step in shown.steps]
    step = step_of(shown)
    parts = {name: step(name) for name in _ID.findall(svg)}
    return lesson(svg, parts, texts, below, decimal)
