"""What pages have in common, whatever they are about: how they are asked for and put together."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from kurbel.exact.numerals import Label
from kurbel.page.arrange import Grid, Place, panels
from kurbel.page.layouts import Layout
from kurbel.page.old_axes import RatioAxis
from kurbel.page.question import check_label, check_rounding
from kurbel.page.table import Field, Note, Records, Table, Value


@dataclass(frozen=True, kw_only=True)
class Sheet:
    """A layout that is asked for, with the digits, the language and the columns of its page.

    `digits` None leaves the decimals to the quantities, no `columns` the columns to the layout.
    """

    layout: Layout
    digits: int | None = None
    rounding: str = "half-away"
    lang: str = "de"
    columns: tuple[str, ...] = ()
    label: str = ""

    def __post_init__(self) -> None:
        check_rounding(self.digits, self.rounding)
        check_label(self.label)

    def decimals_of(self, own: int) -> int:
        """Return the decimals asked for, else a quantity's own."""
        return own if self.digits is None else self.digits

    def chosen(self, known: Callable[[str], bool] = lambda key: True) -> tuple[str, ...]:
        """Return the keys of the columns asked for, else the layout's that do not give way to a known one."""
        own = (one for one in self.layout.columns if not (one.unless and known(one.unless)))
        return self.columns or tuple(column.quantity for column in own)


class Heads(NamedTuple):
    """What stands over a column."""

    spanners: tuple[Label, ...]
    heading: tuple[Label, ...]


class LetteredRatioAxis(RatioAxis):
    """Crank ratios with their letters, for heads that stand alone."""

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (self.over_group(place),)


class Rows:
    """Records that are computed as they are asked for: so many, the named values of each."""

    def __init__(
        self, count: int, names: Sequence[str], records: Callable[[], Iterator[Mapping[str, Value]]]
    ) -> None:
        self._count = count
        self._names = names
        self._records = records

    def __len__(self) -> int:
        return self._count

    def __iter__(self) -> Iterator[tuple[Value, ...]]:
        for record in self._records():
            yield tuple(record[name] for name in self._names)


def records_of(
    count: int,
    names: Sequence[str],
    fields: Mapping[str, Field],
    records: Callable[[], Iterator[Mapping[str, Value]]],
) -> Records:
    """Return the named fields and their values, of so many records."""
    return Records(tuple(fields[name] for name in names), Rows(count, names, records))


def table_of(
    sheet: Sheet, caption: Label, grid: Grid | None, records: Records, notes: Iterable[Label | Note]
) -> Table:
    """Return the table; without a grid only its records."""
    layout, lang = sheet.layout, sheet.lang
    return Table(
        key=sheet.label or layout.key,
        layout=layout.key,
        lang=lang,
        caption=caption,
        panels=() if grid is None else panels(layout, grid),
        records=records,
        notes=tuple(note if isinstance(note, Note) else Note(note) for note in notes),
        source=layout.source[lang],
        templates=layout.folder,
    )
