"""What a value of a book is: by a formula, or as a quantity of kurbel's, with every digit certified."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import cache
from math import inf
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.books.expression import Expression, IrrationalError, Kind, fraction_root, irrational
from kurbel.books.printed_value import Printed, Units
from kurbel.errors import NotationError
from kurbel.exact.certify import NEVER_TIES, TieBits, ball, ball_circle, ball_degrees, rounded, vanishes
from kurbel.exact.kind import balls, bounds
from kurbel.exact.separation import Separation, circle_separation
from kurbel.kernel.circle import Circle
from kurbel.reading.choices import choose

if TYPE_CHECKING:
    from flint import arb

BALLS = Kind(ball, ball_circle, lambda value: value.log(), lambda value: 90 - ball_degrees(value))
FRACTIONS = Kind(lambda value: value, irrational, irrational, irrational, fraction_root)
BOUNDS = Kind(
    Separation.rational, lambda degrees: Circle(*circle_separation(degrees)), irrational, irrational
)


class Truth(NamedTuple):
    """What a cell is: its ball at the precision in force, its separation bound, None without one.

    `rational` is the value itself where it is known to be a fraction.
    """

    value: Callable[[], arb]
    bound: Callable[[], Separation] | None = None
    rational: Fraction | None = None

    def in_units(self, printed: Printed) -> Units | None:
        """Return how many units of the printed value's last place it is, rounded half away from zero.

        A quotient has none, and is the value itself: None where that is irrational.
        Where there is no bound no value is a tie. Nor is an angle one, an odd number of quarters or halves of
        a minute or degree: those here are rational over π, or have a cosine of at most degree 2 over the
        rationals, and those odd numbers one of a higher degree.
        """
        unit = printed.unit
        if printed.exact:
            if self.rational is not None:
                return self.rational / unit
            return next(
                (sign * printed.scaled for sign in (1, -1) if self.equals(sign * printed.value)), None
            )

        def tie_bits(boundary: Fraction) -> float:
            assert self.bound is not None
            return float((self.bound() - Separation.rational(boundary * unit)).bits())

        ties: TieBits | None = NEVER_TIES if self.bound is None else tie_bits
        return rounded(lambda: self.value() / ball(unit), 0, "half-away", ties)

    def written_as(self, printed: Printed) -> Printed:
        """Return the value as another is printed; one in place of a quotient is rational."""
        units = self.in_units(printed)
        assert units is not None
        return printed.with_units(units)

    def equals(self, value: Fraction) -> bool:
        """Return whether it is this number itself."""
        bits = inf if self.bound is None else (self.bound() - Separation.rational(value)).bits()
        return vanishes(lambda: self.value() - ball(value), float(bits))


def constant(value: Fraction) -> Truth:
    """Return what is a rational number."""
    return Truth(lambda: ball(value), lambda: Separation.rational(value), value)


def formula_truth(formula: Expression, cells: Callable[[str], Truth]) -> Truth:
    """Return what a formula makes of the cells that it names."""
    rational = _rational(formula, cells)
    if rational is not None:
        return constant(rational)

    def bound(name: str) -> Separation:
        found = cells(name).bound
        assert found is not None
        return found()

    algebraic = not formula.transcendental and all(cells(name).bound is not None for name in formula.names)
    return Truth(
        lambda: formula.value(BALLS, lambda name: cells(name).value()),
        (lambda: formula.value(BOUNDS, bound)) if algebraic else None,
    )


def _rational(formula: Expression, cells: Callable[[str], Truth]) -> Fraction | None:
    """Return the value if fractions and roots of squares alone make it."""

    def fraction(name: str) -> Fraction:
        found = cells(name).rational
        return irrational(name) if found is None else found

    try:
        value: Fraction = formula.value(FRACTIONS, fraction)
    except IrrationalError:
        return None
    except ZeroDivisionError:
        raise NotationError(f'"{formula.text[:60]}" divides by zero') from None
    return value


def kept(truth: Truth) -> Truth:
    """Return the same, computed once for each precision."""
    from flint import ctx

    at = cache(lambda precision: truth.value())
    return Truth(lambda: at(ctx.prec), truth.bound and cache(truth.bound), truth.rational)


def methods_of(quantity: str) -> tuple[str, ...]:
    """Return the methods by which a quantity can be recomputed."""
    from kurbel.engine.quantities import engine_registry
    from kurbel.linkage.beam import registry as beam_registry
    from kurbel.motion.evaluation import METHODS

    if quantity in beam_registry():
        return ("exact", "approximate")
    return ("exact", "series", "weisbach") if quantity in engine_registry() else tuple(METHODS)


def quantity_truth(quantity: str, method: str, at: Mapping[str, Any]) -> Truth:
    """Return a quantity of the motion, of an engine or of a beam engine.

    `at` has the numbers by axis: ratio and phi; ratio and epsilon, perhaps the back pressure and the name of
    a stroke; or ratio and arm.
    """
    from kurbel.engine.quantities import engine_registry
    from kurbel.linkage.beam import registry as beam_registry
    from kurbel.motion.quantities import registry

    if "epsilon" in at:
        choose(quantity, engine_registry(), "quantity")
        _check_axes(quantity, at, ("ratio", "epsilon"), ("back", "stroke"))
        return _engine_truth(quantity, method, **at)
    if "arm" in at:
        choose(quantity, beam_registry(), "quantity")
        _check_axes(quantity, at, ("ratio", "arm"))
        return _beam_truth(quantity, method, **at)
    choose(quantity, registry(), "quantity")
    _check_axes(quantity, at, ("ratio", "phi"))
    return _motion_truth(quantity, method, **at)


def _check_axes(
    quantity: str, at: Mapping[str, Any], needed: Sequence[str], free: Sequence[str] = ()
) -> None:
    for axis in needed:
        if axis not in at:
            raise NotationError(f"there is no {axis}, which the quantity {quantity} needs")
    for axis in at:
        if axis not in (*needed, *free):
            raise NotationError(f"the quantity {quantity} has no {axis}; leave it out")


def _motion_truth(key: str, method: str, ratio: Fraction, phi: Fraction) -> Truth:
    from kurbel.drive.crank import Crank
    from kurbel.motion.evaluation import METHODS, is_known, is_transcendental, kernel_of, value
    from kurbel.motion.quantities import registry

    quantity, crank = registry()[key], Crank(ratio)
    choose(method, METHODS, "method")
    if not is_known(quantity, crank):
        raise NotationError(f"the quantity {key} has a unit, and no lengths are known; choose one without")

    def run(kind: Any) -> Any:
        return value(quantity, method, crank, kind.circle(phi), kind)

    # A method without a formula is told here, before anything is computed.
    kernel_of(quantity, method, crank)
    bound = None
    if not is_transcendental(quantity, crank):
        bound = cache(lambda: run(bounds()))
    return Truth(lambda: run(balls()), bound)


def _engine_truth(
    key: str,
    method: str,
    ratio: Fraction,
    epsilon: Fraction,
    back: Fraction | None = None,
    stroke: str = "turn",
) -> Truth:
    from kurbel.engine.quantities import SPANS, Where, applies, engine_registry
    from kurbel.engine.quantities import value as value_of

    quantity, spans = engine_registry()[key], {name: span for span, (name, _) in SPANS.items()}
    where, turn = Where(spans[choose(stroke, spans, "stroke")]), engine_turn(ratio, epsilon, back, method)
    if not applies(quantity, where):
        raise NotationError(f"{key} is no quantity of {stroke}")

    def value() -> Any:
        found = value_of(quantity, turn, where)
        return ball(found) if isinstance(found, Fraction) else found

    return Truth(value)


@cache
def engine_turn(ratio: Fraction, epsilon: Fraction, back: Fraction | None, method: str) -> Any:
    """Return the turn of an engine by a method."""
    from kurbel.drive.crank import Crank
    from kurbel.engine.engine import Engine, Steam
    from kurbel.engine.quantities import ENGINE_METHODS
    from kurbel.engine.turn import turn_of

    choose(method, ENGINE_METHODS, "method")
    return turn_of(Engine(Crank(ratio), Steam(epsilon, back)), method)


def _beam_truth(key: str, method: str, ratio: Fraction, arm: Fraction) -> Truth:
    from kurbel.linkage.beam import BeamEngine, registry, value

    choose(method, ("exact", "approximate"), "method")
    engine = BeamEngine(arm, ratio)
    return Truth(lambda: value(registry()[key], engine, method))
