"""What is asked for of a page, with all choices made: layout, language, digits and columns."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import prod
from typing import ClassVar

from kurbel.errors import ProblemError
from kurbel.exact.numerals import MOST_DIGITS, ROUNDINGS, Label
from kurbel.page.arrange import Axis, Place
from kurbel.page.layouts import Layout, LayoutColumn
from kurbel.page.quantity import Column, Quantity
from kurbel.page.subject import Subject, subject
from kurbel.page.table import Field, Value
from kurbel.reading.choices import choose
from kurbel.reading.notation import MOST_ROWS


@dataclass(frozen=True, kw_only=True)
class Question:
    """A layout that is asked for, with the digits, the language and the columns of its page.

    `digits` None leaves the decimals to the layout and the quantities, no `columns` the columns to the
    layout. What a subject asks beside that are the fields of its own question.
    """

    layout: Layout
    digits: int | None = None
    rounding: str = "half-away"
    lang: str = "de"
    columns: tuple[str, ...] = ()
    label: str = ""

    # Whether records of the axes alone say something.
    axes_suffice: ClassVar[bool] = False

    def __post_init__(self) -> None:
        check_rounding(self.digits, self.rounding)
        check_label(self.label)
        self.check()
        if not self.page_columns and not self.axes_suffice:
            raise ProblemError(self.no_column)
        if len(self) > MOST_ROWS:
            raise ProblemError(f"{self.too_long()}; at most 10^9 are allowed")

    def too_long(self) -> str:
        """Return the half of a sentence that refuses so many records."""
        return f"the table would have {len(self)} rows"

    def check(self) -> None:
        """Raise a KurbelError for what the subject cannot answer."""

    def missing(self, quantity: Quantity) -> str:
        """Return the sentence that refuses a column of the quantity, nothing if it is known."""
        return ""

    @property
    def subject(self) -> Subject:
        return subject(self.layout.subject)

    @property
    def no_column(self) -> str:
        """Why a page without a column beside its axes is refused, with an example."""
        return f"there is no column beside the axes; add one, such as {next(iter(self.subject.quantities()))}"

    @property
    def axis_keys(self) -> tuple[str, ...]:
        """The keys of the axes in records."""
        return self.subject.axis_keys

    @property
    def key(self) -> str:
        """The name of the table for cross references."""
        return self.label or self.layout.key

    @property
    def source(self) -> Label:
        """The line that says where the page comes from."""
        return self.layout.source[self.lang]

    @cached_property
    def axes(self) -> Mapping[str, Axis]:
        return {name: axis(self) for name, axis in self.subject.axes.items()}

    def __len__(self) -> int:
        """How many records there are."""
        return prod(axis.count for name, axis in self.axes.items() if name != "column")

    @cached_property
    def page_columns(self) -> tuple[Column, ...]:
        """The columns asked for, else the layout's as far as they are known."""
        if not self.columns:
            return tuple(self.column(one) for one in self.layout.columns if self.shows(one))
        # The axes of the question may have other keys than its subject states.
        others = self.subject.column_keys(self.layout)[len(self.subject.axis_keys) :]
        allowed = dict.fromkeys((*self.axis_keys, *others))
        keys = dict.fromkeys(choose(key, allowed, "column") for key in self.columns)
        chosen = self.chosen([key for key in keys if key not in self.axis_keys])
        for column in chosen:
            if missing := self.missing(self.entry(column.quantity)):
                raise ProblemError(missing)
        return tuple(map(self.column, chosen))

    def shows(self, column: LayoutColumn) -> bool:
        """Whether the layout's column is shown where none were asked for."""
        if column.unless and not self.missing(self.entry(column.unless)):
            return False
        return not self.missing(self.entry(column.quantity))

    def chosen(self, keys: Sequence[str]) -> list[LayoutColumn]:
        """Return the columns of these keys, with the heads of the layout where they are its own."""
        own = {column.key: column for column in self.layout.columns}
        return [own.get(key, LayoutColumn(key, key)) for key in keys]

    def entry(self, key: str) -> Quantity:
        return self.subject.quantities()[key]

    def methods_of(self, column: LayoutColumn) -> tuple[str, ...]:
        """Return the methods by which a column is computed."""
        return ("exact",)

    def column(self, column: LayoutColumn) -> Column:
        quantity, lang = self.entry(column.quantity), self.lang
        spanners = quantity.spanners if column.spanners is None else column.spanners
        heading = (quantity.heading,) if column.heading is None else column.heading
        return Column(
            column.key,
            quantity,
            self.methods_of(column),
            self.decimals(column, quantity),
            tuple(one[lang] for one in spanners),
            tuple(one[lang] for one in heading),
        )

    def decimals(self, column: LayoutColumn, quantity: Quantity) -> int | None:
        """Return the decimals asked for, else the layout's, else the quantity's own."""
        own = quantity.decimals if column.decimals is None else column.decimals
        return own if self.digits is None else self.digits

    def field(self, column: Column) -> Field:
        """Return what a column is in records."""
        one, lang = column.quantity, self.lang
        return Field(
            column.key,
            one.full_name(lang),
            one.symbol,
            one.plain_unit(lang),
            column.decimals,
            " - ".join(column.methods),
        )

    def number(self, column: Column, place: Place, times: int = 1) -> Value:
        """Return what stands at a place, times a factor; None where the column says nothing of it."""
        return self.subject.number(self, column, place, times)


def check_rounding(digits: int | None, rounding: str) -> None:
    """Raise a KurbelError unless so many decimals can be printed, and rounded in this way."""
    if digits is not None and (not isinstance(digits, int) or not 0 <= digits <= MOST_DIGITS):
        raise ProblemError(f"digits is {digits}; it must be a whole number from 0 to {MOST_DIGITS}")
    choose(rounding, ROUNDINGS, "rounding")


def check_label(label: str) -> None:
    """Raise a KurbelError unless cross references can bear the label."""
    if any(not (one.isascii() and (one.isalnum() or one in "-.:")) for one in str(label)):
        raise ProblemError(f'label "{str(label)[:40]}" may have letters, digits and the signs -.: only')
