"""A construction as an HTML page whose steps are clicked through."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from kurbel.books.constructions import model
from kurbel.books.constructions.model import Construction
from kurbel.formats.html.lesson import lesson
from kurbel.page.build import build

if TYPE_CHECKING:
    from kurbel.books.constructions.page import ConstructionRequest

_STEP = re.compile(r"step-(\d+)-")


def construction_page(request: ConstructionRequest, svg: str, decimal: str | None) -> str:
    """Return the page of a construction of which this is the drawing, an SVG file."""
    shown, table = request.construction, build(request)
    # The steps stand beside the drawing; below the table would be a second list of them.
    below = replace(table, notes=table.notes[len(shown.steps) :])
    texts = [shown.said(step.text[request.lang]) for step in shown.steps]
    return lesson(svg, dict(_parts(shown, svg)), texts, below, decimal)


def _parts(shown: Construction, svg: str) -> Iterator[tuple[str, int]]:
    """Yield the ids of the drawing that belong to a step, with its number."""
    ends = {one.ends: one.letters for one in shown.lengths}
    for number, step in enumerate(shown.steps, 1):
        for one in step.drawn:
            if isinstance(one, model.Measure):
                yield f"length-{one.letters}", number
            elif isinstance(one, model.Arrow | model.Line) and (one.start, one.end) in ends:
                yield f"length-{ends[one.start, one.end]}", number
    for name in re.findall(r'<g id="(step-[^"]+)">', svg):
        if found := _STEP.match(name):
            yield name, int(found[1])
