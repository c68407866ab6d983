"""How wide a table of an HTML page is, reckoned from its text: print has no bars to scroll by."""

from __future__ import annotations

from collections.abc import Iterator
from html.parser import HTMLParser
from typing import NamedTuple

# In units of the type's size, for the widest of the faces that the style sheet names.
_LETTER, _BETWEEN = 0.64, 1.1


def width_in_ems(fragment: str) -> float:
    """Return about how wide the widest table of a fragment is, in units of the size of its type.

    Rather too wide than too narrow: letters count like figures, a formula like its letters on one line but
    for fractions, whose two halves stand above each other.
    """
    reader = _Reader()
    reader.feed(fragment)
    reader.close()
    return max((_width(table) for table in reader.tables), default=0.0)


class _Cell(NamedTuple):
    across: int
    down: int
    letters: float


def _width(rows: list[list[_Cell]]) -> float:
    columns: dict[int, float] = {}
    # A cell across several columns comes last, when it is known how wide they are without it.
    for place, cell in sorted(_placed(rows), key=lambda placed: placed[1].across):
        over = range(place, place + cell.across)
        lacking = _LETTER * cell.letters + _BETWEEN - sum(columns.get(column, 0.0) for column in over)
        for column in over:
            columns[column] = columns.get(column, 0.0) + max(0.0, lacking) / cell.across
    return sum(columns.values())


def _placed(rows: list[list[_Cell]]) -> Iterator[tuple[int, _Cell]]:
    """Yield each cell with the number of its column, past those that reach down from the rows above."""
    taken: dict[int, int] = {}
    for row in rows:
        place = 0
        reaching = {column: left - 1 for column, left in taken.items() if left > 1}
        for cell in row:
            while place in reaching:
                place += 1
            yield place, cell
            reaching |= {place + step: cell.down for step in range(cell.across)}
            place += cell.across
        taken = reaching


class _Reader(HTMLParser):
    """Collects the cells of all tables by their rows."""

    def __init__(self) -> None:
        super().__init__()
        self.tables: list[list[list[_Cell]]] = []
        self.spans = (1, 1)
        self.lines: list[float] = []
        self.fractions = 0

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag == "table":
            self.tables.append([])
        elif tag == "tr":
            self.tables[-1].append([])
        elif tag in ("td", "th"):
            given = dict(attrs)
            self.spans = int(given.get("colspan") or 1), int(given.get("rowspan") or 1)
            self.lines = [0.0]
        elif tag == "br":
            self.lines.append(0.0)
        elif tag == "mfrac":
            self.fractions += 1

    def handle_endtag(self, tag: str) -> None:
        if tag in ("td", "th"):
            self.tables[-1][-1].append(_Cell(*self.spans, max(self.lines)))
            self.lines = []
        elif tag == "mfrac":
            self.fractions -= 1

    def handle_data(self, text: str) -> None:
        if self.lines:
            self.lines[-1] += len(text.strip("\n")) / 2**self.fractions
