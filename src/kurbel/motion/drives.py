"""Drives as conditions see them: courses of their quantities over both strokes, with certified digits.

The straight or offset crank is one of them; the others stand in their packages.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache, cached_property, lru_cache
from math import inf
from typing import Any

import flint
from flint import arb

from kurbel.drive.crank import Crank
from kurbel.drive.moved import DeadCentres
from kurbel.errors import ProblemError
from kurbel.exact.certify import NEVER_TIES, TieBits, ball, half_turn_circle, pi, rounded
from kurbel.exact.course import Course
from kurbel.exact.kind import Kind, balls, surds
from kurbel.exact.numerals import Label
from kurbel.exact.place import SQUARE, Centre, Field, Place, SecondRootError, Surd, exact_place
from kurbel.exact.search import Jet, ball_jets, between, jets, slopes
from kurbel.exact.terms import vanishes
from kurbel.kernel import kinematics
from kurbel.kernel.circle import Circle, Numeric
from kurbel.motion.captions import FormulaContext, formula_lines
from kurbel.motion.evaluation import LOADED, OUT, Needs, certified, is_known, is_transcendental, typed, value
from kurbel.motion.motion_quantities import registry
from kurbel.motion.notes import drive_notes, force_notes, loaded_notes
from kurbel.page.quantity import Column, Formula, Quantity, multiplied, words
from kurbel.reading.given import SHARE
from kurbel.reading.notation import ratio_text

ONE = Fraction(1)
AT_REST = ("velocity", "tangential_force", "tangential_force_n", "torque", "torque_nm")
# What paths and their shares are at dead centres, where that is rational: a stroke √a - √b with an irrational
# root is not.
PATHS: Mapping[str, tuple[Fraction | None, Fraction | None]] = {
    **dict.fromkeys(("x", "path"), (Fraction(0), None)),
    **dict.fromkeys(("x_stroke", "path_stroke"), (Fraction(0), ONE)),
}


def condition_names(entries: Iterable[Quantity]) -> Mapping[str, str]:
    """Return the names that conditions may give quantities, further names last, and what they stand for."""
    named = [entry.names for entry in entries if entry.names]
    return {names[0]: names[0] for names in named} | {name: names[0] for names in named for name in names[1:]}


class Drive(ABC):
    """A crank drive by one method: what can be asked of it, and what can be shown where it holds.

    A stroke is OUT or RETURN; everything on it counts from the dead centre where it begins, in its direction.
    `entries` are the outstroke's quantities, which stand for either stroke.
    """

    method = "exact"
    # Whether it has a rod, of a length over that of the crank.
    has_rod = True
    # An angle about the middle of both strokes.
    centre: Centre = SQUARE
    # The velocity of the piston, and all that is zero at dead centres where what acts does so along its way.
    velocity = "velocity"
    at_rest: tuple[str, ...] = AT_REST

    def __init__(self, drive: Any, entries: Mapping[str, Quantity]) -> None:
        self.drive, self.entries = drive, entries
        self.course = cache(self._course)
        self._surd = cache(self._surd_of)

    @property
    def crank(self) -> Crank:
        found: Crank = self.drive.crank
        return found

    @property
    def ratio(self) -> Fraction:
        return self.crank.ratio

    @property
    def where(self) -> str:
        """What sentences say of it."""
        return f" for R:L = {ratio_text(self.ratio)}" if self.has_rod else ""

    @property
    def is_straight(self) -> bool:
        """Whether both dead centres lie on the slide direction, for the drive says nothing else."""
        return bool(type(self.drive).dead_angle is DeadCentres.dead_angle)

    @property
    def stroke(self) -> Label:
        """The stroke as pages print it where the drive is straight, nothing where no line holds it."""
        return "2 R"

    def at_dead_centre(self, stroke: int) -> Fraction | None:
        """Return the acceleration where the stroke begins, in v²/R, where it is known to be rational."""
        return None

    @property
    def names(self) -> Mapping[str, str]:
        """The names of quantities in conditions, and what they stand for; under a force also its columns."""
        found = {**condition_names(self.entries.values()), **{key: key for key in self.pushed}}
        return {**found, **{name: name for name in self.in_newtons}} if self._is_heavy else found

    @cached_property
    def in_newtons(self) -> Mapping[str, str]:
        """The columns in N and N m that a piston force calls up, by the quantities that they show."""
        needs = {Needs.FORCE, Needs.MASSES} if self._is_heavy else {Needs.FORCE}
        found = [one.key for one in self.entries.values() if not needs.isdisjoint(one.needs)]
        return {key.removesuffix("_nm").removesuffix("_n"): key for key in found}

    @property
    def _is_heavy(self) -> bool:
        """Whether more than a given force acts; linkages are asked with none."""
        return bool(getattr(self.crank, "loaded", False))

    @property
    def _acts(self) -> bool:
        """Whether forces are known in newtons."""
        return self.crank.force is not None or self._is_heavy

    @cached_property
    def pushed(self) -> tuple[str, ...]:
        """Those that are known, of a force that is given."""
        return tuple(key for key in self.in_newtons.values() if self._acts and key in self.columns)

    @cached_property
    def columns(self) -> Mapping[str, Quantity]:
        """What can be shown, as far as it is known."""
        return {
            key: one
            for key, one in self.entries.items()
            if is_known(one, self.crank)
            and (self.method in one.formulas or (self._is_heavy and LOADED in one.formulas))
        }

    def column_of(self, quantity: str) -> str:
        """Return the column that shows a quantity of conditions."""
        if quantity in self.pushed:
            return quantity
        named = (key for key, entry in self.entries.items() if entry.names[:1] == (quantity,))
        # The force on a pin has no share of the piston force beside it.
        return next(named, None) or self.in_newtons[quantity]

    def digits(
        self, column: str, stroke: int, place: Place, decimals: int, rounding: str, times: Fraction = ONE
    ) -> int:
        """Return the column's value at a place, times a factor, times 10**decimals, rounded correctly."""
        quantity = multiplied(self.entries[column]._replace(stroke=stroke), times)
        if place.degrees is not None:
            return self.certified(quantity, place.degrees, decimals, rounding)
        ties = ties_at(place, self._surd(column, stroke), times)

        def at() -> arb:
            return ball(self.value(quantity, half_turn_circle(place.half_turns()), balls()))

        return rounded(at, decimals, rounding, ties)

    def value(self, quantity: Quantity, circle: Circle[Any], numbers: Kind) -> Numeric:
        """Return a quantity of a stroke on any kind of number."""
        return value(quantity, self.method, self.drive, circle, numbers)

    def certified(self, quantity: Quantity, degrees: Fraction, decimals: int, rounding: str) -> int:
        """Return it at an exact angle times 10**decimals, rounded correctly."""
        return certified(quantity, self.method, self.drive, degrees, decimals, rounding)

    def is_free(self, quantity: Quantity) -> bool:
        """Whether it is algebraic and needs no root for the dead centre."""
        return not is_transcendental(quantity, self.crank)

    def ends(self, stroke: int) -> tuple[Place, Place]:
        """Return the dead centres of the stroke, from that where it begins; where both lie on the slide
        direction exactly."""
        if self.is_straight:
            places = (exact_place(Fraction(at), SQUARE, flint.fmpz_poly([1 - 2 * at, 1])) for at in (0, 1))
        else:
            jet = self.jet(self.asked(self.velocity, stroke))
            zero = None if jet is None else jet.value.norm()
            places = (Place(angle, self.centre, zero) for angle in self.dead_angles(stroke))
        begin, end = places
        return begin, end

    def dead_angles(self, stroke: int) -> tuple[Callable[[], arb], Callable[[], arb]]:
        """Return the same in half turns."""

        def begin() -> arb:
            return ball(self.drive.dead_angle(stroke, balls())) / 180

        return begin, lambda: begin() + 1 + stroke * ball(self.drive.lead(balls())) / 180

    def formula_lines(self, question: FormulaContext, columns: Sequence[Column]) -> Iterator[Label]:
        """Yield the formulas that stand before what was found."""
        return iter(())

    @abstractmethod
    def closing_lines(self, question: Any) -> Iterable[Label]:
        """Return what a page says of the drives below all else."""

    def asked(self, quantity: str, stroke: int) -> Quantity:
        """Return what a condition on a quantity is about."""
        return self.entries[self.column_of(quantity)]._replace(stroke=stroke)

    def jet(self, quantity: Quantity) -> Jet | None:
        """Return the quantity and its slopes as functions of tan ½(φ - φ₀), None if it takes two roots."""
        if not self.is_free(quantity):
            return None
        field = Field()
        try:
            found = self.value(quantity, jets(field.circle(self.centre.tangent)), surds(field))
        except SecondRootError:
            return None
        assert isinstance(found, Jet)
        return found

    def _surd_of(self, column: str, stroke: int) -> Surd | None:
        jet = self.jet(self.entries[column]._replace(stroke=stroke))
        return None if jet is None else jet.value

    def _course(self, quantity: str, stroke: int) -> Course:
        one = self.asked(quantity, stroke)
        jet = self.jet(one)
        if jet is None and not one.rises:
            return self.by_balls(one, stroke)
        at, slope, _ = self._slopes(one)
        course = Course(at, self._rise(one) if one.key in PATHS else slope, *self.ends(stroke))
        if jet is not None:
            return replace(course, formula=jet.value, formula_slope=jet.slope)

        def is_exactly(half_turns: Fraction, wanted: Fraction) -> bool:
            def difference(kind: Kind) -> Numeric:
                return self.value(one, kind.circle(180 * half_turns), kind) - kind.of(wanted)

            return vanishes(difference)

        return replace(course, ends=PATHS.get(one.key, (None, None)), is_exactly=is_exactly)

    def _slopes(self, quantity: Quantity) -> tuple[Callable[[arb], arb], ...]:
        """Return a quantity, its slope and the slope of that, over half turns in balls."""

        def at(half_turns: arb) -> arb:
            return ball(self.value(quantity, half_turn_circle(half_turns), balls()))

        return at, *slopes(lambda half_turns: self.value(quantity, ball_jets(half_turns), balls()))

    def _rise(self, path: Quantity) -> Callable[[arb], arb]:
        """Return the slope of a path, or of its share of the stroke, over half turns: the velocity."""
        velocity, share = self.asked(self.velocity, path.stroke), PATHS[path.key][1]
        whole = lru_cache(2)(lambda bits: ball(self.drive.way(balls())) if share else 1)

        def rise(half_turns: arb) -> arb:
            found = ball(self.value(velocity, half_turn_circle(half_turns), balls()))
            return found * pi() / whole(flint.ctx.prec)

        return rise

    def by_balls(self, quantity: Quantity, stroke: int) -> Course:
        """Return the course of a quantity, proved by balls where it rises and falls: all zeros of its slope
        are enclosed. At dead centres those `at_rest` are known to be zero, and what balls know to be so."""
        at, slope, bend = self._slopes(quantity)
        ends = self.ends(stroke)
        zero = quantity.key in self.at_rest
        first, last = (Fraction(0) if zero or at(place.half_turns()) == 0 else None for place in ends)
        inner = tuple(place for place in between(slope, bend, *ends, proved=True) if place not in ends)
        return Course(at, slope, *ends, ends=(first, last), inner=inner)


def ties_at(place: Place, surd: Surd | None, times: Fraction = ONE) -> TieBits | None:
    """Return what proves that a value at the place, times a factor, lies on a boundary, or NEVER_TIES."""
    if surd is None or place.polynomial is None:
        return NEVER_TIES

    def tie_bits(boundary: Fraction) -> float:
        # The boundary is that of the magnitude.
        own = boundary / times
        return 0.0 if place.vanishes(surd - own) or place.vanishes(surd + own) else inf

    return tie_bits


class SlideDrive(Drive):
    """The straight or offset crank."""

    velocity = "c"

    def __init__(self, crank: Crank, method: str = "exact") -> None:
        super().__init__(crank, slide_columns())
        self.method = method

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (self.crank, self.method)

    @property
    def is_straight(self) -> bool:
        return not (self.crank.offset and self.crank.ratio)

    def at_dead_centre(self, stroke: int) -> Fraction | None:
        # p = 1 ± λ by every formula.
        return 1 + stroke * self.ratio if self.is_straight else None

    def digits(
        self,
        column: str,
        stroke: int,
        place: Place,
        decimals: int,
        rounding: str,
        times: Fraction = Fraction(1),
    ) -> int:
        # No ball tells which way a piston goes that rests: friction is that of the stroke which begins there.
        way = self._way_from(stroke, place) if self.crank.has_friction and place.degrees is None else None
        if way is None:
            return super().digits(column, stroke, place, decimals, rounding, times)
        quantity = multiplied(self.entries[column]._replace(stroke=stroke), times)

        def at() -> arb:
            circle = half_turn_circle(place.half_turns())
            return ball(value(quantity, self.method, self.crank, circle, balls(), way=way))

        return rounded(at, decimals, rounding, NEVER_TIES)

    def _way_from(self, stroke: int, place: Place) -> int | None:
        """Return which way the piston goes from a dead centre of the stroke, None of another place."""
        course = self.course(SHARE, stroke)
        return {course.begin: 1, course.end: -1}.get(place)

    def jet(self, quantity: Quantity) -> Jet | None:
        """Return the quantity with its slopes; what masses add to a force has no rational numbers in it."""
        loaded = self.crank.loaded and LOADED in quantity.formulas
        return None if loaded else super().jet(quantity)

    @property
    def at_rest(self) -> tuple[str, ...]:  # type: ignore[override]
        # In a dead centre what acts on the piston has no torque; across that of the straight crank nothing
        # acts, and balls know it.
        moving = self.crank.moving
        return AT_REST if self.crank.effort is None and (moving is None or moving.rod is None) else ()

    def asked(self, quantity: str, stroke: int) -> Quantity:
        """Return what a condition is about: of the rod angle its sine."""
        found = super().asked(quantity, stroke)
        if quantity != "psi":
            return found
        sine = Formula(lambda at: kinematics.rod_sine(at.circle, at.ratio, at.offset or 0))
        return found._replace(formulas=dict.fromkeys(found.formulas, sine), unit=words(""))

    def formula_lines(self, question: FormulaContext, columns: Sequence[Column]) -> Iterator[Label]:
        return formula_lines(question, columns)

    def closing_lines(self, question: FormulaContext) -> Iterator[Label]:
        crank, lang = question.cranks[0], question.lang
        yield from force_notes(question.cranks, lang)
        if crank.loaded:
            yield from loaded_notes(crank, question.layout.ratio_symbol, lang)
        yield from drive_notes(question.cranks, lang)


@cache
def slide_columns() -> Mapping[str, Quantity]:
    """Return what can be shown of a place of the straight or offset crank."""
    return {key: one for key, one in registry().items() if one.stroke == OUT}


def slide_drives(cranks: Sequence[Crank], method: str) -> tuple[SlideDrive, ...]:
    """Return the drives of these cranks by a method; that of the infinite rod makes all ratios 1:∞."""
    if method != "exact" and any(crank.offset for crank in cranks):
        raise ProblemError(
            f'method "{typed(method)}" has no formulas for an offset crank;'
            " use exact, or leave the offset out"
        )
    if method == "infinite":
        cranks = tuple(dict.fromkeys(replace(crank, ratio=Fraction(0)) for crank in cranks))
    return tuple(SlideDrive(crank, method) for crank in cranks)
