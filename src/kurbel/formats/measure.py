"""How wide columns are: by their own texts, and by what spanners above them need, in the metric of a format.

A metric is a function that returns the width of a text: characters, or em, such as those of Computer Modern
here, where they are nearly the same in all sizes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import reduce
from itertools import chain, zip_longest
from operator import add
from typing import TYPE_CHECKING, Generic, NamedTuple, TypeVar

from kurbel.page.table import HeadCell

if TYPE_CHECKING:
    from kurbel.formats.page import PagePanel

# Characters, or em.
Length = TypeVar("Length", int, float)

_CHARACTERS = (
    ("ilI,.:;[]'’!|", 0.28),
    ("fj- ", 0.33),
    ("rst()₀₁₂₃₄₅₆₇₈₉", 0.39),
    ("cez?°⁻⁰¹²³⁴⁵⁶⁷⁸⁹⁾ₘ", 0.46),
    ("kqvxySbdhnpuüµJ", 0.55),
    ("LFEPBCTRAHNUVXYDwφψαωZ", 0.72),
    ("KOQG+−±=ÄÖÜΔΠΣΦΨΩ", 0.78),
    ("mM%½", 0.85),
    ("—∞W", 1.0),
)
_EM = {character: width for characters, width in _CHARACTERS for character in characters}


def added(lengths: Iterable[Length]) -> Length:
    """Return the sum, added one after the other.

    From Python 3.12 on sum() carries what floats lose, and a length here and there had another last digit.
    """
    return reduce(add, lengths, 0)


def em(text: str) -> float:
    """Return the width of a text; a character that is not listed is as wide as a digit."""
    return added([_EM.get(character, 0.5) for character in text])


def bodies(panel: PagePanel, width: Callable[[str], Length]) -> list[Length]:
    """Return the width of the widest cell of each column, of figures with room for the longest fraction."""
    cells = [[row[place] for row in panel.rows] for place in range(len(panel.columns))]
    return [max((width(cell.text + cell.tail) for cell in column), default=0) for column in cells]


def headings(panel: PagePanel, width: Callable[[str], Length]) -> list[Length]:
    """Return the width of the widest line of the heading of each column."""
    return [max(map(width, column.heading), default=0) for column in panel.columns]


def widest(panels: Iterable[Sequence[Length]]) -> list[Length]:
    """Return for each column the largest of what the panels have."""
    return [max(column) for column in zip_longest(*panels, fillvalue=0)]


class Span(NamedTuple, Generic[Length]):
    """What stands over several columns, or rows, and how wide it is."""

    first: int
    across: int
    width: Length


def spans(panel: PagePanel, width: Callable[[HeadCell], Length]) -> Iterator[Span[Length]]:
    """Yield the spanners of a panel, the innermost first."""
    for cell in chain.from_iterable(reversed(panel.spanners)):
        yield Span(cell.first, cell.across, width(cell))


def shared(columns: Sequence[Length], spans: Iterable[Span[Length]], gaps: Sequence[Length]) -> list[Length]:
    """Return the widths of columns that share evenly what the spanners above them lack; the gap before each
    column serves those that reach over it."""
    widths = list(columns)
    for span in spans:
        below = slice(span.first, span.first + span.across)
        lacking = span.width - added(gaps[below][1:]) - added(widths[below])
        for step in range(span.across):
            widths[span.first + step] += _share(lacking, span.across, step)
    return widths


def _share(lacking: Length, across: int, step: int) -> Length:
    # Of characters, which are not divided, the first columns have one more.
    return max(-((step - lacking) // across) if isinstance(lacking, int) else lacking / across, 0)


class Room(NamedTuple):
    """A width, of which `gaps` take a share that grows and shrinks with them."""

    em: float
    gaps: float = 0.0

    def at(self, unit: float = 1.0) -> float:
        """Return the width with gaps of so many units."""
        return self.em + unit * self.gaps

    def __bool__(self) -> bool:
        return bool(self.em)


def overhangs(
    columns: Sequence[float], spans: Iterable[Span[float]], gaps: Sequence[float], unit: float = 1.0
) -> tuple[list[Room], list[Room]]:
    """Return how far spanners that are wider than what is below them reach over each column, left and right.

    Room there keeps the gaps between the columns below as they are, however wide the spanner is; of these, so
    many `unit`s serve the spanner.
    """
    left, right = ([Room(0.0) for _ in columns] for _ in range(2))
    for first, across, width in spans:
        below, last = slice(first, first + across), first + across - 1
        hanging = [*left[below], *right[below]]
        em = width - added(columns[below]) - added(one.em for one in hanging)
        taken = added(gaps[below][1:]) + added(one.gaps for one in hanging)
        if em > unit * taken:
            for side, place in ((left, first), (right, last)):
                side[place] = Room(side[place].em + em / 2, side[place].gaps - taken / 2)
    return left, right
