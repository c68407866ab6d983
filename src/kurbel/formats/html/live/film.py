"""A drawing that moves in HTML: its SVG with a slider that leads it to each degree, and a page of its own."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from kurbel.exact.numerals import Label
from kurbel.formats.html import FORMAT
from kurbel.formats.html.live.block import WORDS as TURNING
from kurbel.formats.html.live.block import Setter, as_json
from kurbel.formats.html.live.pages import RUNS
from kurbel.formats.html.svg import inline
from kurbel.formats.render import render_document
from kurbel.page.axes import PHI
from kurbel.page.labels import plain

# What the file of a drawing that moves says of its run: first and last angle, that of the start, seconds.
RUN = re.compile(RUNS + r'([^"]*)"')
WORDS: Mapping[str, Mapping[str, str]] = {
    "de": {"choose": "Kurbelwinkel wählen", "numbers": "Werte beim Kurbelwinkel"},
    "en": {"choose": "Choose the crank angle", "numbers": "Values at the crank angle"},
}
KEY = "film"


def film_page(svg: str, title: Label, lang: str, mark: str, spoken: Sequence[tuple[Any, ...]]) -> str:
    """Return a page of its own: the drawing, its slider, and the printed numbers at each degree."""
    writer = FORMAT.writer
    said = writer.escape(plain(title, mark))
    drawing = film_block(svg, KEY, plain(title, mark), lang, mark, spoken)
    values = {"page": {"lang": lang, "key": KEY}, "title": said, "fragment": drawing}
    return render_document(FORMAT, "film", values)


def film_block(
    svg: str, name: str, title: str, lang: str, mark: str, spoken: Sequence[tuple[Any, ...]] = ()
) -> str:
    """Return the drawing of a file that moves as part of a page of ours, with what leads it."""
    found = RUN.search(svg)
    assert found is not None
    first, last, start, seconds = map(float, found[1].split())
    setter = Setter(FORMAT.writer, mark)
    columns = [[setter.value(value) for value in values] for *_, values in spoken]
    data = {"first": first, "last": last, "start": start, "seconds": seconds, "mark": mark, "values": columns}
    values = {
        "key": name, "lang": lang, "words": {**TURNING[lang], **WORDS[lang]},
        "label": f"{PHI[lang]} {setter.label('$φ$')}",
        "first": f"{first:g}", "last": f"{last:g}", "start": f"{start:g}",
        "quantities": [
            (setter.label(said), setter.label(symbol), setter.unit(unit)) for said, symbol, unit, _ in spoken
        ],
        "drawing": inline(svg, name, title, own_page=True),
        "data": as_json(data),
    }  # fmt: skip
    return render_document(FORMAT, "film.block", values)
