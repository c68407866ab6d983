"""The straight or offset crank as courses of its quantities over both strokes, with certified digits."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache, cached_property
from math import inf
from typing import TYPE_CHECKING, Any, Protocol

import flint

from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact.certify import (
    MOST_TIE_BITS,
    NEVER_TIES,
    TieBits,
    ball,
    ball_circle,
    ball_degrees,
    half_turn_circle,
    pi,
    rounded,
)
from kurbel.exact.course import Course
from kurbel.exact.jet import Jet, ball_jets, jets
from kurbel.exact.kind import Kind, balls, bounds, surds
from kurbel.exact.place import SQUARE, Place, exact_place
from kurbel.exact.surd import Field, SecondRootError, Surd
from kurbel.kernel import kinematics
from kurbel.kernel.circle import Circle
from kurbel.motion.evaluation import OUT, is_known, is_transcendental, value
from kurbel.motion.evaluation import certified as certified_of_slide
from kurbel.motion.quantities import registry
from kurbel.page.quantity import Quantity

if TYPE_CHECKING:
    from flint import arb

# From a circle and a kind of number to a value of that kind.
Formula = Callable[[Circle[Any], Kind], Any]


def condition_names(entries: Iterable[Quantity]) -> Mapping[str, str]:
    """Return the names that conditions may give quantities, further names last, and what they stand for."""
    known = [entry.names for entry in entries if entry.names]
    return {names[0]: names[0] for names in known} | {name: names[0] for names in known for name in names[1:]}


def column_named(columns: Mapping[str, Quantity], name: str) -> str:
    """Return the column that shows what a condition calls by its first name."""
    return next(key for key, entry in columns.items() if entry.names[:1] == (name,))


class Drive(Protocol):
    """A crank drive by one method: what can be asked of it, and what can be shown where it holds.

    A stroke is OUT or RETURN; everything on it counts from the dead centre where it begins, in its direction.
    """

    method: str

    @property
    def ratio(self) -> Fraction: ...
    @property
    def names(self) -> Mapping[str, str]:
        """The names of quantities in conditions, and what they stand for."""
        ...

    @property
    def columns(self) -> Mapping[str, Quantity]: ...
    def column_of(self, quantity: str) -> str:
        """Return the column that shows a quantity of conditions."""
        ...

    def course(self, quantity: str, stroke: int) -> Course: ...
    def digits(self, column: str, stroke: int, place: Place, decimals: int, rounding: str) -> int:
        """Return the column's value at a place times 10**decimals, rounded correctly."""
        ...


class SlideDrive:
    """The straight or offset crank."""

    def __init__(self, crank: Crank, method: str = "exact") -> None:
        self.crank = crank
        self.method = method
        self.ratio = crank.ratio
        self.course = cache(self._course)
        self._surd = cache(self._surd_of)

    @property
    def is_straight(self) -> bool:
        """Whether both dead centres lie on the slide direction."""
        return not (self.crank.offset and self.crank.ratio)

    @property
    def names(self) -> Mapping[str, str]:
        return slide_names()

    @cached_property
    def columns(self) -> Mapping[str, Quantity]:
        return {
            key: one
            for key, one in registry().items()
            if one.stroke == OUT and is_known(one, self.crank) and self.method in one.formulas
        }

    def column_of(self, quantity: str) -> str:
        return column_named(registry(), quantity)

    def digits(self, column: str, stroke: int, place: Place, decimals: int, rounding: str) -> int:
        quantity = _of_stroke(column, stroke)
        if place.degrees is not None:
            return certified_of_slide(quantity, self.method, self.crank, place.degrees, decimals, rounding)
        formula = self._formula(quantity)
        ties = NEVER_TIES
        if not is_transcendental(quantity, self.crank):
            ties = ties_at(place, self._surd(column, stroke))
        return rounded(
            lambda: formula(half_turn_circle(place.half_turns()), balls()), decimals, rounding, ties
        )

    def _formula(self, quantity: Quantity) -> Formula:
        return lambda circle, numbers: value(quantity, self.method, self.crank, circle, numbers)

    def _asked(self, quantity: str, stroke: int) -> Formula:
        """Return the formula that a condition is about: of the rod angle its sine."""
        if quantity != "psi":
            return self._formula(_of_stroke(self.column_of(quantity), stroke))

        def rod_sine(circle: Circle[Any], numbers: Kind) -> Any:
            ratio, offset = numbers.of(stroke * self.crank.ratio), numbers.of(stroke * self.crank.offset)
            return kinematics.rod_sine(circle, ratio, offset)

        return rod_sine

    def _course(self, quantity: str, stroke: int) -> Course:
        formula = self._asked(quantity, stroke)

        def at(half_turns: arb) -> arb:
            found: arb = formula(half_turn_circle(half_turns), balls())
            return found

        def slope(half_turns: arb) -> arb:
            found: arb = formula(ball_jets(half_turns), balls()).slope * pi()
            return found

        begin, end = self._ends(stroke)
        try:
            jet = _as_surds(formula)
        except SecondRootError:
            # A stroke √a - √b with an irrational root is irrational.
            ends = (Fraction(0), Fraction(1) if self.column_of(quantity) == "x_stroke" else None)
            return Course(at, slope, begin, end, ends=ends, is_exactly=self._exactly(formula))
        return Course(at, slope, begin, end, jet.value, jet.slope)

    def _ends(self, stroke: int) -> tuple[Place, Place]:
        if self.is_straight:
            return _straight_ends()
        velocity = _as_surds(self._asked("c", stroke)).value.norm()

        def dead_centre(side: int) -> arb:
            numbers = (ball(side * one) for one in (self.crank.ratio, self.crank.offset))
            return ball_degrees(kinematics.dead_centre_sine(*numbers)) / 180

        return (
            Place(lambda: dead_centre(stroke), SQUARE, velocity),
            Place(lambda: 1 + dead_centre(-stroke), SQUARE, velocity),
        )

    def _exactly(self, formula: Formula) -> Callable[[Fraction, Fraction], bool]:
        def is_exactly(half_turns: Fraction, wanted: Fraction) -> bool:
            kind = bounds()
            bits = (formula(kind.circle(180 * half_turns), kind) - kind.of(wanted)).bits()
            if bits > MOST_TIE_BITS:
                return False
            with flint.ctx.workprec(int(bits) + 64):
                apart = formula(ball_circle(180 * half_turns), balls()) - ball(wanted)
                return bool(abs(apart) < ball(2) ** -int(bits + 1))

        return is_exactly

    def _surd_of(self, column: str, stroke: int) -> Surd | None:
        try:
            found: Surd = _as_surds(self._formula(_of_stroke(column, stroke))).value
            return found
        except SecondRootError:
            return None


@cache
def slide_names() -> Mapping[str, str]:
    """Return the names that conditions on the straight or offset crank may give quantities."""
    return condition_names(registry().values())


def slide_drives(cranks: Sequence[Crank], method: str) -> tuple[SlideDrive, ...]:
    """Return the drives of these cranks by a method; that of the infinite rod makes all ratios 1:∞."""
    if method != "exact" and any(crank.offset for crank in cranks):
        raise ProblemError(
            f'method "{method}" has no formulas for an offset crank; use exact, or leave the offset out'
        )
    if method == "infinite":
        cranks = tuple(dict.fromkeys(replace(crank, ratio=Fraction(0)) for crank in cranks))
    return tuple(SlideDrive(crank, method) for crank in cranks)


def ties_at(place: Place, surd: Surd | None) -> TieBits | None:
    """Return what proves that a value at the place lies on a rounding boundary, or NEVER_TIES."""
    if surd is None or place.polynomial is None:
        return NEVER_TIES

    def tie_bits(boundary: Fraction) -> float:
        # The boundary is that of the magnitude.
        return 0.0 if place.vanishes(surd - boundary) or place.vanishes(surd + boundary) else inf

    return tie_bits


def _of_stroke(column: str, stroke: int) -> Quantity:
    return registry()[column]._replace(stroke=stroke)


def _as_surds(formula: Formula) -> Jet:
    """Return a formula and its slopes as functions of tan ½(φ - 90°)."""
    field = Field()
    found = formula(jets(field.circle(SQUARE.tangent)), surds(field))
    assert isinstance(found, Jet)
    return found


def _straight_ends() -> tuple[Place, Place]:
    begin, end = (exact_place(Fraction(at), SQUARE, flint.fmpz_poly([1 - 2 * at, 1])) for at in (0, 1))
    return begin, end
