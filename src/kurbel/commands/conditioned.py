"""Places at which a condition holds, and numbers with which it holds at a place, computed a second time.

Where the angle is what is printed, the condition is put back: other columns of the row stand at the place
that was found, not at the printed one.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from math import factorial
from typing import TYPE_CHECKING

from kurbel import verify
from kurbel.commands.recomputed import at_angle, dead, of_engine, weighed
from kurbel.commands.solve import OF_MOTION
from kurbel.errors import ProblemError
from kurbel.reading import units
from kurbel.reading.given import SHARE
from kurbel.reading.notation import number
from kurbel.reading.where import (
    DEAD_CENTRE,
    EXTREMES,
    LEANING,
    MAX,
    MIN,
    MOST,
    VALUE,
    Condition,
    read_condition,
)
from kurbel.verify import Number, Value
from kurbel.verify.extremes import Sloping, summits
from kurbel.verify.jets import Jet
from kurbel.verify.numbers import number as exactly
from kurbel.verify.numbers import spread
from kurbel.verify.zeros import FoundAngle, Place, around, root

if TYPE_CHECKING:
    from kurbel.commands.recomputed import Row
    from kurbel.commands.second import SecondComputation

RETURN = "return"
# Conditions on the torque of all cranks.
OF_TURN = ("tangential", "torque", "tangential_excess")
_UNIT = "_(stroke|percent|mm|mps|mps2|radps|radps2|n|nm)$"
_MEASURED = {
    "x": (units.displacement, "mm"), "c": (units.velocity, "mps"), "p": (units.acceleration, "mps2"),
    "torque": (units.signed_torque, "nm"),
}  # fmt: skip


def of_condition(second: SecondComputation, key: str, method: str, row: Row) -> Value:
    condition, phi = _condition(second, row), row.get("phi", row.get("phi_turn"))
    if phi is None:
        raise ProblemError("the row does not say its crank angle; add phi to the columns")
    back = row.get("stroke") == RETURN
    near = number(phi) - (180 if back and "phi" not in row else 0)
    if second.asked.is_engine():
        place = _on_engine(second, condition, method, near, row)
        if key == "phi":
            return place.value
        if key in ("tangential", "energy", "tangential_excess"):
            return second.turn(method, row).value(key, place)
        return of_engine(second, key, method, place, row)
    drive = second.pushed(row)
    place = _on_drive(second, drive, condition, method, back, near, row)
    if key == "phi":
        return place.value
    if key == "phi_turn":
        return Value(lambda: _in_turn(place().angle + (180 if back else 0)))
    name, target = _target(second, drive, condition, method, back)
    (stem, unit), (own, other) = _parted(key), _parted(name)
    if condition.kind in EXTREMES or stem != own:
        column = _course(second, drive, key, method, back, row)
        return Value(lambda: column(place(), 0))
    return Value(lambda: target() if unit == other else target() * drive.unit(unit) / drive.unit(other))


def _parted(key: str) -> tuple[str, str]:
    """A quantity and its unit."""
    stem = re.sub(_UNIT, "", key)
    return stem, key[len(stem) + 1 :]


def of_unknown(second: SecondComputation, key: str, printed: Fraction, row: Row) -> Value:
    """A number other than the angle, in SI units: near the printed one that with which what the condition is
    about, itself computed a second time, passes through its value."""
    condition, method, whole = _condition(second, row), _method(second), second.instead({})
    at = whole.place(row) if "phi" in row else whole.placed(whole.listed[0], row)
    if condition.kind == MAX:
        # On the outstroke of the straight crank the velocity has one extreme.
        condition = replace(condition, quantity="p", kind=VALUE)
    near = 1 / printed if key == "rod_ratio" else printed

    def missed(share: Place) -> Number:
        """With so many percent of the printed number."""
        tried = second.instead({str(second.options["unknown"]): near * share.degrees / 100})
        column, target = _target(tried, tried.pushed({}), condition, method, False)
        return at_angle(tried, column, method, at, {}).recipe() - target()

    place = second.spot((key, near, at), lambda: root(missed, Fraction(100)))
    found = Value(lambda: place().angle * near / 100)
    return Value(lambda: 1 / found.recipe()) if key == "rod_ratio" else found


def angle_at(second: SecondComputation, condition: Condition, near: Fraction, row: Row) -> FoundAngle:
    """The crank angle near another one at which a condition holds."""
    method = _method(second)
    if condition.quantity not in OF_MOTION:
        return _on_engine(second, condition, method, near, row)
    drive = second.pushed(row)
    turns, since = divmod(near - drive.dead_degrees(1).middle, 360)
    back = since >= (drive.dead_degrees(-1) - drive.dead_degrees(1)).middle
    turned = 360 * turns + 180 * back
    place = _on_drive(second, drive, condition, method, back, near - turned, row)
    return FoundAngle(lambda: place().turned(Fraction(turned)))


def _method(second: SecondComputation) -> str:
    given = second.options.get("method") or "exact"
    method = str(given[0] if isinstance(given, tuple | list) else given)
    return f"{method}-{second.options['order']}" if "order" in second.options else method


def _condition(second: SecondComputation, row: Row) -> Condition:
    listed = second.options.get("where")
    texts = list(map(str, listed)) if isinstance(listed, list | tuple) else [str(listed)]
    where = row.get("condition", texts[0] if len(texts) == 1 else "")
    if not where:
        raise ProblemError("the row does not say its condition")
    about = where.partition("=")[0].strip().strip("|")
    return read_condition(where, {about: about}, (about,))


def _on_drive(
    second: SecondComputation, drive: verify.Drive, condition: Condition, method: str, back: bool,
    near: Fraction, row: Row,
) -> FoundAngle:  # fmt: skip
    name, target = _target(second, drive, condition, method, back)
    over = _course(second, drive, name, method, back, row)

    def found() -> FoundAngle:
        if condition.kind in EXTREMES:
            return FoundAngle(lambda: _extreme(over, condition, drive, back, near))
        return root(lambda at: over(at, 0) - target(), near, lambda at: over(at, 1))

    return second.spot((drive, method, condition, back, near), found)


def _course(
    second: SecondComputation, drive: verify.Drive, key: str, method: str, back: bool, row: Row
) -> Sloping:
    """A column over the crank angle of a stroke, with its slopes."""
    if second.asked.is_heavy():
        heavy = weighed(second, drive, second.push(), method, row)
        if heavy.knows(key):
            return lambda at, more: heavy.at(key.rpartition("_")[0], at, -1 if back else 1, more)
    return drive.over(key, method, back=back).value


def _extreme(over: Sloping, condition: Condition, drive: verify.Drive, back: bool, near: Fraction) -> Place:
    """The place, of those of a stroke at which a quantity has its extreme, that is nearest to an angle."""

    def course(at: Place, order: int) -> Jet:
        found = Jet([over(at, k) / factorial(k) for k in range(order + 1)])
        if condition.kind == MOST or (condition.kind == MAX and condition.quantity in LEANING):
            return found * found
        return -found if condition.kind == MIN else found

    ends = [dead(drive, outer, back) for outer in (back, not back)]
    found = summits(course, *(one.middle for one in ends))
    angle = min((one.angle for one in found), key=lambda one: abs(one.middle - near))
    # The dead centres themselves are not known better.
    off = max(one.high - one.low for one in ends)
    return around(angle + spread(-off, off) if off else angle)


def _in_turn(angle: Number) -> Number:
    middle = angle.middle
    return angle + 360 if middle < 0 else angle - 360 if middle > 360 else angle


def _target(
    second: SecondComputation, drive: verify.Drive, condition: Condition, method: str, back: bool
) -> tuple[str, Callable[[], Number]]:
    """The column that a condition is about, and the value that it asks for."""
    name, value, unit = condition.quantity, condition.value, condition.unit
    if condition.kind == DEAD_CENTRE:
        course = drive.over(name, method, back=back)
        return name, lambda: course.value(around(dead(drive, back, back))) * value
    of_force = (second.asked.is_heavy() or second.asked.is_engine()) and name not in OF_MOTION
    if name == SHARE:
        name = "x_stroke" if drive.rocker is None else "path_stroke"
    elif unit or (of_force and not name.endswith(("_n", "_nm"))):
        read, ending = _MEASURED.get(name, (units.signed_force, "n"))
        name = f"{name}_{ending}"
        if unit:
            value = read(f"{value.numerator}/{value.denominator} {unit}", name)
            value *= 1000 if ending == "mm" else 1
    return name, lambda: exactly(value)


def _on_engine(
    second: SecondComputation, condition: Condition, method: str, near: Fraction, row: Row
) -> FoundAngle:
    turn = second.turn(method, row)
    if condition.quantity not in OF_TURN or condition.unit:
        raise ProblemError(f"conditions on {condition.quantity} of engines are not computed a second time")

    def missed(at: Place) -> Number:
        if condition.kind in EXTREMES:
            return turn.known.force(at, 1)
        mean = turn.known.mean if condition.quantity == "tangential_excess" else 0
        return turn.known.force(at, true=True) - mean - condition.value

    return second.spot((turn, condition, near), lambda: root(missed, near))
