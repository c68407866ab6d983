"""The labels of rows as headers, for readers that do not see the page.

Typst makes headers of whole rows only: what would make one of a single cell (`pdf.header-cell`) is a feature
that its package for Python does not switch on. The tables mark the labels of their rows by a dotted line on
the left that has no thickness and is not drawn; here these cells become headers (TH) of their rows, and the
other cells of the row refer to them, as they do to the heads of their columns.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterator, Sequence
from itertools import accumulate
from typing import NamedTuple


class Edit(NamedTuple):
    start: int
    end: int
    text: bytes


def with_row_headers(made: bytes) -> bytes:
    """Return the PDF that Typst made with the labels of rows as headers.

    What it says of suspects is left out: "false", the default, is what some readers take for a mistake.
    """
    edits = sorted([*_suspects(made), *_row_headers(made)])
    return _edited(made, edits)


_SUSPECTS = re.compile(rb"(?<=/MarkInfo<</Marked true)/Suspects false(?=>>)")
# Parts of the structure stand on one line each. The empty groups are places for what is added.
_CELL = re.compile(
    rb"^([0-9]+) 0 obj\n<</Type/StructElem/S/T(D)/P [0-9]+ 0 R()/A\[<</O/Table()/Headers\[[^]\n]*()\]"
    rb"(?:/RowSpan ([0-9]+))?(?:.*?/BorderStyle\[/[A-Z][a-z]+/[A-Z][a-z]+/(Dashed)/)?",
    re.MULTILINE,
)
_ROW = re.compile(rb"^[0-9]+ 0 obj\n<</Type/StructElem/S/TR/P [0-9]+ 0 R/K\[([^]]*)\]", re.MULTILINE)
_NAMES = re.compile(rb"/IDTree<</Names\[()")
_KID = re.compile(rb"([0-9]+) 0 R")


def _suspects(made: bytes) -> Iterator[Edit]:
    yield from (Edit(*found.span(), b"") for found in _SUSPECTS.finditer(made))


def _row_headers(made: bytes) -> Iterator[Edit]:
    cells = {found[1]: found for found in _CELL.finditer(made)}
    labels = {number for number, cell in cells.items() if cell[7]}
    names = _NAMES.search(made)
    if not labels or not names:
        return
    for number in labels:
        cell = cells[number]
        yield Edit(*cell.span(2), b"H")
        yield Edit(*cell.span(3), b"/ID(%s)" % _name(number))
        yield Edit(*cell.span(4), b"/Scope/Row")
        yield Edit(*cell.span(7), b"None")
    # Of a label that stands for several rows, how many of them are left.
    lasting: dict[bytes, int] = {}
    for row in _ROW.finditer(made):
        numbers = [number for number in _KID.findall(row[1]) if number in cells]
        lasting |= {number: int(cells[number][6] or 1) for number in numbers if number in labels}
        headers = b"".join(b"(%s)" % _name(number) for number in lasting)
        yield from (Edit(*cells[number].span(5), headers) for number in numbers if number not in labels)
        lasting = {number: left - 1 for number, left in lasting.items() if left > 1}
    entries = sorted((_name(number), number) for number in labels)
    yield Edit(*names.span(1), b"".join(b"(%s)%s 0 R" % entry for entry in entries))


def _name(number: bytes) -> bytes:
    """Return the name of a header; those of Typst begin with a U, and names are in their order."""
    return b"R" + number


_TABLE = re.compile(
    rb"\nxref\n0 [0-9]+\n((?:[0-9]{10} [0-9]{5} [nf]\r?[ \n]\n?)+)trailer.*?\nstartxref\n([0-9]+)", re.DOTALL
)
_PLACE = re.compile(rb"([0-9]{10})(?= [0-9]{5} n)")


def _edited(made: bytes, edits: Sequence[Edit]) -> bytes:
    """Return the file after the edits, which are in order, its table of places anew."""
    table = _TABLE.search(made, made.rfind(b"\nxref\n"))
    if table is None:
        return made
    starts = [edit.start for edit in edits]
    moved = [0, *accumulate(len(edit.text) - (edit.end - edit.start) for edit in edits)]

    def place(old: bytes) -> int:
        return int(old) + moved[bisect_left(starts, int(old))]

    places = _PLACE.sub(lambda found: b"%010d" % place(found[1]), table[1])
    whole = [*edits, Edit(*table.span(1), places), Edit(*table.span(2), b"%d" % place(table[2]))]
    pieces, at = [], 0
    for start, end, text in whole:
        pieces += [made[at:start], text]
        at = end
    return b"".join([*pieces, made[at:]])
