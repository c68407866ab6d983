"""Conditions on a crank drive: all crank angles of the turn at which they hold."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from kurbel.drive.at import known, turn_time, turned
from kurbel.drive.crank import Crank
from kurbel.drive.mechanisms import MECHANISMS
from kurbel.errors import ChoiceError, NoRootError, ProblemError
from kurbel.exact.certify import NEVER_TIES, ball, ball_circle, pi, rounded
from kurbel.exact.course import Course, Target, closed_forms, form_text
from kurbel.exact.kind import balls
from kurbel.exact.numerals import MOST_DIGITS, Number, exact_text, nearest, number_text
from kurbel.exact.place import Place
from kurbel.kernel.circle import Numeric
from kurbel.motion.drives import Drive, condition_names
from kurbel.motion.evaluation import OUT, RETURN, Needs
from kurbel.motion.mechanism import mechanism
from kurbel.reading.amounts import UNITS
from kurbel.reading.given import (
    SHARE,
    as_acceleration,
    as_displacement,
    as_signed_force,
    as_torque,
    as_velocity,
)
from kurbel.reading.names import otherwise
from kurbel.reading.where import (
    DEAD_CENTRE,
    EXTREMES,
    LEANING,
    MAX,
    MEASURED,
    MIN,
    MOST,
    OF_SLIDES,
    VALUE,
    Condition,
    read_condition,
)

if TYPE_CHECKING:
    from flint import arb

STROKES = (OUT, RETURN)
RIGHT = Fraction(90)
# ψ of so many degrees has a rational sine (Niven).
RATIONAL_SINES = {Fraction(0): Fraction(0), Fraction(30): Fraction(1, 2), Fraction(-30): Fraction(-1, 2)}
TORQUE = "torque"
OF_STROKE = {OUT: "the outstroke", RETURN: "the return stroke"}


@dataclass(frozen=True, eq=False)
class Root:
    """A place at which a condition holds, on the stroke on which it was found.

    `known` has the columns that the condition itself settles.
    """

    drive: Drive
    condition: Condition
    stroke: int
    place: Place
    known: Mapping[str, Fraction]

    def number(self, column: str, decimals: int, rounding: str, times: Fraction = Fraction(1)) -> Number:
        """Return what a column shows of the place, times a factor."""
        if column in self.known:
            return nearest(times * self.known[column], decimals, rounding)
        if self.place.degrees is None and Needs.TIME in self.drive.entries[column].needs:
            return self._time(decimals, rounding, times)
        scaled = self.drive.digits(column, self.stroke, self.place, decimals, rounding, times)
        return Number(scaled, decimals)

    def _time(self, decimals: int, rounding: str, times: Fraction) -> Number:
        """Return the time since the dead centre where the stroke begins, at an irrational angle."""
        crank = self.drive.crank

        def seconds() -> Numeric:
            numbers = balls()
            beyond = turned(crank, self.stroke, 180 * self.place.half_turns(), numbers)
            return beyond * turn_time(crank, numbers) * numbers.of(times)

        return Number(rounded(seconds, decimals, rounding, NEVER_TIES), decimals)

    def angle(self, over_turn: bool, share: int, decimals: int, rounding: str) -> Number:
        """Return φ of the stroke, or that of the whole turn from 0 to 360°, in parts of a degree."""
        turned = self._turned() if over_turn else 0
        degrees = self.place.degrees
        if degrees is not None:
            return nearest(share * (degrees + turned), decimals, rounding)

        def parts() -> arb:
            return share * (180 * self.place.half_turns() + turned)

        return Number(rounded(parts, decimals, rounding, NEVER_TIES), decimals)

    def _turned(self) -> int:
        """Return what leads from φ of the stroke to the turn's."""
        turned = 180 if self.stroke == RETURN else 0
        degrees = 180 * float(self.place.half_turns().mid()) + turned
        return turned + (360 if degrees < 0 else -360 if degrees > 360 else 0)


def read_on(drive: Drive, text: str) -> Condition:
    """Return a condition on a drive; one in kN or N m is about the column in N or N m."""
    whose = f"{OF_SLIDES}, forces and torque" if drive.pushed else OF_SLIDES
    try:
        found = read_condition(text, drive.names, (*MEASURED, *drive.in_newtons), whose)
    except ChoiceError as error:
        name = text.partition("=")[0].strip()
        if "did you mean" not in str(error) and (other := _of_other(name)):
            raise ChoiceError(f'there is no quantity "{name}" of this drive; {other} has it') from None
        raise
    if not found.unit and found.quantity in drive.in_newtons and getattr(drive.crank, "loaded", False):
        # Beside masses no force is a share of another.
        if found.kind == VALUE and found.value:
            raise ProblemError(f'condition "{found}" needs a unit beside masses; write it in N or N m')
        return replace(found, quantity=drive.in_newtons[found.quantity])
    if not found.unit or found.quantity in MEASURED:
        return found
    column = drive.in_newtons[found.quantity]
    if column not in drive.columns:
        options = " and ".join(drive.entries[column].options)
        raise ProblemError(f'condition "{found}" is in {found.unit} and needs {options}')
    reader = as_torque if found.quantity == TORQUE else as_signed_force
    value = reader(f"{exact_text(found.value)} {found.unit}", found.quantity)
    return Condition(column, VALUE, value)


def _of_other(name: str) -> str:
    """Return the options of a drive whose conditions have a quantity of this name, nothing if none has."""
    for key, one in MECHANISMS.items():
        if otherwise(name, [*condition_names(mechanism(key).conditions().values())]):
            return f"--mechanism {key}{one.options}"
    return ""


def solve(drive: Drive, condition: Condition) -> tuple[Root, ...]:
    """Return where the condition holds, in the order of the turn: proved to be all places.

    A dead centre belongs to the stroke that begins there, if the condition holds on both. Raises NoRootError
    where it holds nowhere, and ProblemError where it holds throughout.
    """
    course = drive.course(condition.quantity, OUT)
    if course.is_constant:
        raise ProblemError(
            f"{condition.quantity} is the same at every crank angle{drive.where}; ask for another quantity"
        )
    found = [root for stroke in STROKES for root in _on_stroke(drive, condition, stroke)]
    begun = {root.stroke for root in found if root.place is _course(root).begin}
    kept = [root for root in found if root.place is not _course(root).end or -root.stroke not in begun]
    if not kept:
        raise NoRootError(_no_root(drive, condition))
    return tuple(kept)


def at_share(drive: Drive, share: Fraction, stroke: int) -> Root:
    """Return where the piston has gone a share of a stroke: one place, for between the dead centres it goes
    one way."""
    (root,) = _on_stroke(drive, Condition(SHARE, VALUE, share), stroke)
    return root


def _course(root: Root) -> Course:
    return root.drive.course(root.condition.quantity, root.stroke)


def _on_stroke(drive: Drive, condition: Condition, stroke: int) -> Iterator[Root]:
    course = drive.course(condition.quantity, stroke)
    if condition.kind in EXTREMES:
        greatest = condition.kind != MIN
        leans = condition.kind == MAX and condition.quantity in LEANING
        measure = {"measure": abs} if leans or condition.kind == MOST else {}
        places = course.greatest(1 if greatest else -1, **measure)
    else:
        places = course.roots(target_of(drive, condition, stroke))
    for place in places:
        yield Root(drive, condition, stroke, place, _known(drive, condition))


def target_of(drive: Drive, condition: Condition, stroke: int) -> Target:
    """Return the value that a condition asks for on a stroke, in units of the drive's course."""
    value = condition.value
    if condition.kind == DEAD_CENTRE:
        return _share_at_dead_centre(drive, condition, stroke)
    if condition.quantity == "psi":
        return _sine(value)
    if condition.unit:
        return MEASURES[condition.quantity].target(drive.crank, condition)
    return Target.rational(value)


def _share_at_dead_centre(drive: Drive, condition: Condition, stroke: int) -> Target:
    share, course = condition.value, drive.course(condition.quantity, stroke)
    if not share:
        return Target.rational(share)
    if (whole := drive.at_dead_centre(stroke)) is not None:
        return Target.rational(share * whole)
    return Target(lambda: ball(share) * course.value(course.begin.half_turns()), None, share == 1)


def _sine(degrees: Fraction) -> Target:
    if abs(degrees) >= RIGHT:
        # No rod stands so steep.
        return Target.rational(Fraction(2 if degrees > 0 else -2))
    return Target(lambda: ball_circle(degrees).sine, RATIONAL_SINES.get(degrees))


class SizedQuantity(NamedTuple):
    """A quantity that may be asked for in mm, m/s or m/s²: R and ω to these powers make it one in R, v, v²/R.

    `column` shows it, in so many parts of a metre.
    """

    column: str
    parts: int
    read: Callable[[str, str], Fraction]
    speed: int

    def metres(self, condition: Condition) -> Fraction:
        """Return the value of the condition in metres and seconds."""
        return self.read(f"{exact_text(condition.value)} {condition.unit}", condition.quantity)

    def target(self, crank: Crank, condition: Condition) -> Target:
        value = self.metres(condition) / known(crank.radius)
        if not self.speed:
            return Target.rational(value)
        speed = known(crank.speed)
        value /= speed.value**self.speed
        if not speed.turns or not value:
            return Target.rational(value)
        return Target(lambda: ball(value) / (2 * pi()) ** self.speed)


MEASURES = {
    "x": SizedQuantity("x_mm", 1000, as_displacement, 0),
    "c": SizedQuantity("c_mps", 1, as_velocity, 1),
    "p": SizedQuantity("p_mps2", 1, as_acceleration, 2),
}


def _known(drive: Drive, condition: Condition) -> Mapping[str, Fraction]:
    """Return what the condition says of the columns."""
    value, quantity = condition.value, condition.quantity
    if condition.kind != VALUE:
        return {}
    if condition.unit:
        measure = MEASURES[quantity]
        return {measure.column: measure.parts * measure.metres(condition)}
    column = drive.column_of(quantity)
    return {column: value, "x_percent": 100 * value} if column == "x_stroke" else {column: value}


def _no_root(drive: Drive, condition: Condition) -> str:
    ranges = {stroke: _range(drive, condition, stroke) for stroke in STROKES}
    if len(set(ranges.values())) == 1:
        where = f"{ranges[OUT]} on both strokes"
    else:
        where = " and ".join(f"{found} on {OF_STROKE[stroke]}" for stroke, found in ranges.items())
    return (
        f"{condition} is reached nowhere{drive.where};"
        f" {condition.quantity} lies {where}{_unusable(drive, condition)}{_with_unit(drive, condition)}"
    )


def _with_unit(drive: Drive, condition: Condition) -> str:
    """Return the condition with the unit that a bare number has not, where the drive has its measures."""
    measure = MEASURES.get(condition.quantity)
    if condition.unit or condition.kind != VALUE or measure is None or measure.column not in drive.columns:
        return ""
    (unit,) = (one.symbol for one in UNITS.values() if measure.column.endswith(f"_{one.ending}"))
    return f'; in {unit} write "{condition} {unit}"'


def _unusable(drive: Drive, condition: Condition) -> str:
    """Return the cosines beyond ±1 to which a condition without a root of its own leads, if any."""
    said = []
    for stroke in STROKES:
        formula = drive.course(condition.quantity, stroke).formula
        if not drive.is_straight or formula is None or not formula.is_rational:
            return ""
        forms = closed_forms(formula, target_of(drive, condition, stroke))
        if forms:
            values = " and ".join(map(form_text, forms))
            said.append(f"cos φ = {values} on {OF_STROKE[stroke]}")
    return f"; unusable, beyond ±1: {', '.join(said)}" if said else ""


def _range(drive: Drive, condition: Condition, stroke: int) -> str:
    """Return what a quantity covers on a stroke: between -0.8000 and 1.2000 v²/R."""
    if condition.quantity == SHARE:
        return "between 0% and 100%"
    column = drive.columns[column_of(drive, condition)]
    course, unit = drive.course(condition.quantity, stroke), column.plain_unit("en")
    value = _known(drive, condition).get(column.key)
    for decimals in range(column.decimals or 0, MOST_DIGITS + 1):
        ends = [
            drive.digits(column.key, stroke, course.greatest(side)[0], decimals, "half-away")
            for side in (-1, 1)
        ]
        # A value that is not reached must not lie between the ends as they are rounded.
        if value is None or not ends[0] <= value * 10**decimals <= ends[1]:
            break
    least, most = (number_text(Number(one, decimals)) for one in ends)
    return f"between {least}° and {most}°" if unit == "°" else f"between {least} and {most} {unit}"


def column_of(drive: Drive, condition: Condition) -> str:
    """Return the column that shows what a condition is about, in its unit."""
    return MEASURES[condition.quantity].column if condition.unit else drive.column_of(condition.quantity)
