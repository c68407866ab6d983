"""What a sweep is: a command, the options that are the same everywhere, and the axes of those that vary."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, replace
from fractions import Fraction
from functools import cached_property
from math import prod
from pkgutil import resolve_name
from shlex import quote
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from kurbel.commands.options import is_given
from kurbel.commands.part import Origin, Values, flag_of
from kurbel.exact.numerals import exact_text, ratio_text
from kurbel.motion.motion_page import AngleQuestion
from kurbel.page.subject import Question

if TYPE_CHECKING:
    from kurbel.commands.subject import Command
    from kurbel.sweeps.condition import KeptPlaces

Floats = NDArray[np.float64]
Places = NDArray[np.int64]
# Values of a column: numbers, whole numbers of the last decimal, texts; None where there is nothing.
Cell: TypeAlias = Floats | list[int | None] | list[str | None] | list[str]
# More rows than these nobody waits for.
MOST_ROWS = 10**12


class Axis(NamedTuple):
    """An option that varies, by its name, and its values as the command takes them, one at a time.

    `values` may be any sequence that is never written out, such as a `Progression`; they are exact.
    """

    option: str
    values: Sequence[Any]


def text_of(value: object, option: str = "") -> str:
    """Return a value of an option as text that the command line takes."""
    if option == "ratio" and isinstance(value, Fraction) and value >= 0:
        return ratio_text(value)
    if isinstance(value, bool):
        return str(value).lower()
    return exact_text(value) if isinstance(value, Fraction) else str(value)


class Points(NamedTuple):
    """Rows by their points, and which record of its point each is; points that follow each other have a
    `first` one."""

    places: Places
    records: Places
    first: int | None = None

    def __len__(self) -> int:
        return len(self.places)


@dataclass(frozen=True)
class Plan:
    """A sweep as it was asked for.

    `command` is the place of the function, "kurbel.commands.engine:delta", and `given` are the values
    of its options by their names on the command line, with underscores, without those that vary. Of these
    `defaults` come from elsewhere, such as a machine's file, and give way where they say nothing. The axes of
    a group are linked: they go through their values together. The rows are the product of the groups, of
    which the last varies fastest. `digits` asks for certified decimals in place of floats, `bounds` for a
    column beside each of floats that says how far from the true value they may lie; a `strict` sweep ends at
    the first point that is refused. Points at which `only` does not hold are left out. `design` tells how the
    values of linked axes were chosen. Where crank angles go beyond those of a stroke, every point is asked as
    one of `whole_turns`.

    Points are counted on the whole grid; the length is that of those that are left.
    """

    command: str
    given: Mapping[str, object]
    groups: tuple[tuple[Axis, ...], ...]
    digits: int | None = None
    bounds: bool = False
    defaults: tuple[str, ...] = ()
    strict: bool = False
    only: str = ""
    design: str = ""
    whole_turns: bool = False

    @property
    def sizes(self) -> tuple[int, ...]:
        """How many places each group has."""
        return tuple(len(group[0].values) for group in self.groups)

    @property
    def axes(self) -> Mapping[str, Axis]:
        """The axes by the names of their options."""
        return {axis.option: axis for group in self.groups for axis in group}

    @property
    def held(self) -> bool:
        """Whether crank angles are given by what holds there, so that every point has its own."""
        given = self.given.get("angle")
        several = given if isinstance(given, list | tuple) else [given]
        return any(isinstance(one, str) and "=" in one for one in several)

    @property
    def carded(self) -> bool:
        """Whether an indicator card is among what is given."""
        cylinders = self.given.get("cylinder")
        described = [self.given, *(cylinders if isinstance(cylinders, list | tuple) else ())]
        return "card" in self.axes or any(is_given(one.get("card")) for one in described)

    def __len__(self) -> int:
        return prod(self.sizes) if self.kept is None else len(self.kept)

    def point(self, place: int) -> int:
        """Return one of the points that are left, by its place among them."""
        return place if self.kept is None else int(self.kept.points(np.array([place]))[0])

    @cached_property
    def kept(self) -> KeptPlaces | None:
        """The points that are left, where not all are."""
        if not self.only:
            return None
        from kurbel.sweeps.condition import kept_of

        return kept_of(self)

    def __getstate__(self) -> dict[str, object]:
        # What follows from it is found again where it goes.
        return {one.name: getattr(self, one.name) for one in fields(self)}

    def at(self, point: int) -> dict[str, object]:
        """Return the values of the options that vary, at a point."""
        found: dict[str, object] = {}
        for group, size in zip(reversed(self.groups), reversed(self.sizes), strict=True):
            point, place = divmod(point, size)
            found = {axis.option: axis.values[place] for axis in group} | found
        return found

    def in_words(self, point: int) -> str:
        """Return a point in the words of the command line."""
        values = self.at(point).items()
        return " ".join(f"{flag_of(name)} {quote(text_of(value, name))}" for name, value in values)

    def question(self, point: int, digits: int, **instead: object) -> Question:
        """Return what the command asks at a point, with other values `instead` of some.

        Raises KurbelError where it is refused.
        """
        values = {**self.at(point), **instead}
        origins = {name: Origin.TYPED for name in (*self.given, *values)}
        told = {**self._everywhere, **values, "digits": digits}
        origins |= dict.fromkeys(self.defaults, Origin.MACHINE)
        question: Question = self.asking.ask(Values(told, origins))
        if self.whole_turns and isinstance(question, AngleQuestion):
            return replace(question, whole_turns=True)
        return question

    @property
    def asking(self) -> Command:
        """The command behind the function."""
        found: Command = resolve_name(self.command).command
        return found

    @cached_property
    def _everywhere(self) -> Mapping[str, object]:
        # Files are in the language of --lang, else in English.
        return {**self.asking.defaults, "lang": "en", **self.given}
