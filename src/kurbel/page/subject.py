"""What a page is about: its axes, its quantities, its words, and what it needs computed once."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from typing import Any

from kurbel.exact.numerals import Label
from kurbel.page.arrange import Axis, Grid, Place
from kurbel.page.layouts import Layout
from kurbel.page.quantity import Column, Quantity
from kurbel.page.registry import SUBJECTS
from kurbel.page.table import Note, Records, Value


def _nothing(question: Any) -> Iterable[Label]:
    return ()


def _everywhere(question: Any, place: Place) -> bool:
    return True


def _no_marks(question: Any, column: Column, place: Place) -> tuple[str, ...]:
    return ()


def _alone(question: Any, column: Column) -> tuple[Column, ...]:
    return ()


@dataclass(frozen=True, kw_only=True)
class Subject:
    """What pages of one kind are about, as data; grid, records, fields, keys and checks follow from it.

    `axes` by their names, outermost first, each made of the question; "column" is that of the quantities.
    `number` is what stands at a place, times a factor; the question keeps what it computed once. `layout`
    is the default layout, `command` what prints its pages, `sample` the same with all that a page needs.
    `of` is what the quantities are numbers of that a layout can show beside its own, all if it is empty;
    its own stand first in lists unless all come in the order of the quantities. `exists` leaves out
    places that a grid has too many, `marks` are those of notes at a place, `beside` the columns that
    follow one in records, `rows` the records where they are long or others than the page's, and `grid`
    the page where it is that of another layout.
    """

    key: str
    layout: str
    command: str
    axes: Mapping[str, Callable[[Any], Axis]]
    axis_keys: tuple[str, ...]
    quantities: Callable[[], Mapping[str, Quantity]]
    number: Callable[[Any, Column, Place, int], Value]
    caption: Callable[[Any], Label]
    notes: Callable[[Any], Iterable[Label | Note]]
    page_notes: Callable[[Any], Iterable[Label]] = _nothing
    sample: str = ""
    own_first: bool = True
    of: tuple[str, ...] = ()
    exists: Callable[[Any, Place], bool] = _everywhere
    marks: Callable[[Any, Column, Place], tuple[str, ...]] = _no_marks
    beside: Callable[[Any, Column], tuple[Column, ...]] = _alone
    rows: Callable[[Any], Records] | None = None
    grid: Callable[[Any], tuple[Layout, Grid]] | None = None

    @property
    def whole(self) -> bool:
        """Whether its axes belong together, for at some of their places there is nothing."""
        return self.exists is not _everywhere

    def fitting(self) -> list[str]:
        """Return the keys of the quantities that any layout can show."""
        return [key for key, one in self.quantities().items() if not self.of or one.of in self.of]

    def column_keys(self, layout: Layout) -> tuple[str, ...]:
        """Return what --columns can choose from; a page whose heads state formulas has its own only."""
        own = [column.key for column in layout.columns]
        others = [] if layout.fixed else self.fitting()
        keys = [*own, *others] if self.own_first or layout.fixed else others
        return tuple(dict.fromkeys((*self.axis_keys, *keys)))


@cache
def subject(key: str) -> Subject:
    """Return what pages are about that say so."""
    module, _, name = SUBJECTS[key].partition(":")
    found = getattr(import_module(module), name)
    assert isinstance(found, Subject)
    return found
