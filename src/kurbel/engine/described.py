"""The lines below a table about an engine itself: its load, its drive, its cranks and its masses."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from kurbel.exact.numerals import Label
from kurbel.page.quantity import words
from kurbel.reading.notation import plain

if TYPE_CHECKING:
    from kurbel.engine.request import EngineRequest

WORDS = {
    "single": words("einfachwirkend|single-acting"),
    "cranks": words(
        "Kurbeln um {angles} hinter der ersten, Zylinder gleich"
        "|cranks {angles} behind the first, cylinders alike"
    ),
}


def engine_notes(request: EngineRequest) -> Iterator[Label]:
    """Yield the lines about the engine itself: its load, its drive, its masses."""
    lang = request.lang
    if request.assembly is None:
        yield "; ".join(_engine(request, lang))
    else:
        from kurbel.engine.cylinders.words import cylinder_notes

        yield from cylinder_notes(request.assembly, request.numbers, lang)
    yield from request.mechanism.loaded_notes(request.drives, lang)
    if request.driven:
        from kurbel.engine.loads.convention import convention

        yield from convention(request)
    if request.assembly is not None:
        from kurbel.engine.cylinders.words import masses_notes

        yield from masses_notes(request, lang)
    elif request.first.crank.moving is not None:
        yield from request.mechanism.masses_notes(request.first.crank, request.layout.ratio_symbol, lang)


def _engine(request: EngineRequest, lang: str) -> Iterator[Label]:
    yield from request.words.lines(request, lang)
    engine = request.first
    if not engine.double and request.words.halved:
        yield WORDS["single"][lang]
    if len(engine.cranks) > 1:
        angles = ", ".join(f"${plain(angle)}°$" for angle in engine.cranks[1:])
        yield WORDS["cranks"][lang].format(angles=angles)
