"""What a value of a book is, with every digit certified: a number, a quantity of kurbel's by its methods, or
what a formula makes of others."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from functools import cache
from math import inf
from typing import Any, NamedTuple

from flint import arb

from kurbel.books.expression import Expression, IrrationalError, Kind, fraction_root, irrational
from kurbel.books.printed_value import Printed, Units
from kurbel.drive.crank import Crank
from kurbel.engine.engine import Engine, Steam
from kurbel.engine.quantities import ENGINE_METHODS, SPANS, Where, applies, engine_registry
from kurbel.engine.quantities import value as engine_value
from kurbel.engine.turn import turn_of
from kurbel.errors import NotationError
from kurbel.exact.certify import NEVER_TIES, TieBits, ball, ball_circle, ball_degrees, rounded, vanishes
from kurbel.exact.kind import balls, bounds
from kurbel.exact.numerals import Label
from kurbel.exact.separation import Separation, circle_separation
from kurbel.linkage.beam import engine as beam
from kurbel.motion import evaluation
from kurbel.motion.quantities import registry as motion_registry
from kurbel.page.quantity import Quantity, words
from kurbel.reading.given import choose
from kurbel.reading.notation import angle, number, plain, ratio, ratio_text

BALLS = Kind(ball, ball_circle, lambda value: value.log(), lambda value: 90 - ball_degrees(value))
FRACTIONS = Kind(lambda value: value, irrational, irrational, irrational, fraction_root)
BOUNDS = Kind(Separation.rational, circle_separation, irrational, irrational)


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


STROKES = {
    "outstroke": words("Hingang|outstroke"),
    "return": words("Rückgang|return"),
    "turn": words("Umdrehung|turn"),
}


class Axis(NamedTuple):
    """What printed values go by: its name, how it is read, and how it is said in a language."""

    name: str
    read: Callable[[str], Any]
    said: Callable[[Any, str], Label]


AXES: Mapping[str, Axis] = {
    "ratio": Axis("crank ratio", ratio, lambda value, lang: f"${ratio_text(value)}$"),
    "phi": Axis("angle", lambda text: angle(text, "angle"), lambda value, lang: f"${plain(value)}°$"),
    "epsilon": Axis(
        "expansion ratio",
        lambda text: number(text, "expansion ratio"),
        lambda value, lang: f"$ε = {plain(value)}$",
    ),
    "arm": Axis(
        "beam arm", lambda text: number(text, "beam arm"), lambda value, lang: f"$a = {plain(value)} r$"
    ),
    "stroke": Axis("stroke", str, lambda value, lang: STROKES[value][lang]),
}


def _motion_truth(key: str, method: str, ratio: Fraction, phi: Fraction) -> Truth:
    quantity, crank = motion_registry()[key], Crank(ratio)
    choose(method, evaluation.METHODS, "method")
    if not evaluation.is_known(quantity, crank):
        raise NotationError(f"the quantity {key} has a unit, and no lengths are known; choose one without")

    def run(kind: Any) -> Any:
        return evaluation.value(quantity, method, crank, kind.circle(phi), kind)

    # A method without a formula is told here, before anything is computed.
    evaluation.kernel_of(quantity, method, crank)
    algebraic = not evaluation.is_transcendental(quantity, crank)
    return Truth(lambda: run(balls()), cache(lambda: run(bounds())) if algebraic else None)


def _engine_truth(
    key: str,
    method: str,
    ratio: Fraction,
    epsilon: Fraction,
    back: Fraction | None = None,
    stroke: str = "turn",
) -> Truth:
    quantity, spans = engine_registry()[key], {name: span for span, (name, _) in SPANS.items()}
    where, turn = Where(spans[choose(stroke, spans, "stroke")]), engine_turn(ratio, epsilon, back, method)
    if not applies(quantity, where):
        raise NotationError(f"{key} is no quantity of {stroke}")

    def value() -> Any:
        found = engine_value(quantity, turn, where)
        return ball(found) if isinstance(found, Fraction) else found

    return Truth(value)


@cache
def engine_turn(ratio: Fraction, epsilon: Fraction, back: Fraction | None, method: str) -> Any:
    """Return the turn of an engine by a method."""
    choose(method, ENGINE_METHODS, "method")
    return turn_of(Engine(Crank(ratio), Steam(epsilon, back)), method)


def _beam_truth(key: str, method: str, ratio: Fraction, arm: Fraction) -> Truth:
    choose(method, FAMILIES["arm"].methods, "method")
    engine = beam.BeamEngine(arm, ratio)
    return Truth(lambda: beam.value(beam.registry()[key], engine, method))


class Family(NamedTuple):
    """Quantities that go by one axis beside the crank ratio: their methods, and the truth of one from the
    numbers by axis, of which some may be left out."""

    registry: Callable[[], Mapping[str, Quantity]]
    methods: Iterable[str]
    truth: Callable[..., Truth]
    free: tuple[str, ...] = ()


# By the axis that they go by.
FAMILIES: dict[str, Family] = {
    "phi": Family(motion_registry, evaluation.METHODS, _motion_truth),
    "epsilon": Family(engine_registry, ENGINE_METHODS, _engine_truth, ("back", "stroke")),
    "arm": Family(beam.registry, ("exact", "approximate"), _beam_truth),
}


def keys_by(axis: str) -> list[str]:
    """Return the keys of the quantities that an axis and the crank ratio settle."""
    crank, entries = Crank(Fraction(1, 5)), FAMILIES[axis].registry().items()
    return [key for key, one in entries if axis != "phi" or evaluation.is_known(one, crank)]


def methods_of(quantity: str) -> tuple[str, ...]:
    """Return the methods by which a quantity can be recomputed."""
    found = (one for one in reversed(FAMILIES.values()) if quantity in one.registry())
    return tuple(next(found, FAMILIES["phi"]).methods)


def quantity_truth(quantity: str, method: str, at: Mapping[str, Any]) -> Truth:
    """Return a quantity of the motion, of an engine or of a beam engine.

    `at` has the numbers by axis: ratio and phi; ratio and epsilon, perhaps the back pressure and the name of
    a stroke; or ratio and arm.
    """
    by = next((axis for axis in ("epsilon", "arm") if axis in at), "phi")
    family, needed = FAMILIES[by], ("ratio", by)
    choose(quantity, family.registry(), "quantity")
    for axis in needed:
        if axis not in at:
            raise NotationError(f"there is no {axis}, which the quantity {quantity} needs")
    for axis in at:
        if axis not in (*needed, *family.free):
            raise NotationError(f"the quantity {quantity} has no {axis}; leave it out")
    return family.truth(quantity, method, **at)


def quantity_label(key: str, lang: str) -> Label:
    """Return how a quantity is written at the head of its column."""
    quantity = next(one.registry()[key] for one in FAMILIES.values() if key in one.registry())
    heading = quantity.heading[lang]
    if key not in motion_registry():
        return quantity.symbol
    return heading if "$" in heading else f"{quantity.symbol} {heading}"
