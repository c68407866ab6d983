"""What a value of a book is, with every digit certified: a number, a quantity of kurbel's by its methods, or
what a formula makes of others.

A formula, "1 - cos(45) + 0.1 * sin(45)^2", "v_max - v_min", has numbers, names of other cells, + - * / ^,
brackets and the functions sin, cos (of degrees), arccos (in degrees), sqrt and ln. It is evaluated on balls,
or on separation bounds to tell whether its value can be a tie.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from functools import cache
from math import inf, isqrt
from typing import Any, Generic, NamedTuple, NoReturn

from flint import arb

from kurbel.books.form import UNREAD, Value
from kurbel.books.printed_value import PrintedValue, Units
from kurbel.drive.at import known
from kurbel.drive.crank import Crank
from kurbel.engine.cylinder import TurnPlace
from kurbel.engine.engine import Engine
from kurbel.engine.engine_quantities import ENGINE_METHODS, SPANS, applies, engine_registry
from kurbel.engine.engine_quantities import value as engine_value
from kurbel.engine.loads.ideal import Steam
from kurbel.engine.turn import turn_of
from kurbel.errors import NotationError
from kurbel.exact.certify import NEVER_TIES, TieBits, ball, ball_circle, ball_degrees, rounded, vanishes
from kurbel.exact.kind import Kind, balls, separation_of
from kurbel.exact.numerals import Label
from kurbel.exact.separation import Separation, circle_separation, power
from kurbel.kernel.circle import Circle, Numeric, root
from kurbel.linkage import beam_engine as beam
from kurbel.motion import evaluation
from kurbel.motion.motion_quantities import registry as motion_registry
from kurbel.page.quantity import Quantity, words
from kurbel.reading.arithmetic import OPERATIONS, POWERS, parsed, wrong_power
from kurbel.reading.given import choose
from kurbel.reading.notation import angle, number, plain, ratio, ratio_text

FUNCTIONS = ("sin", "cos", "sqrt", "ln", "arccos")


class Numbers(NamedTuple, Generic[Value]):
    """A kind of number: of a fraction, sine and cosine of exact degrees, logarithm, arc and root."""

    of: Callable[[Fraction], Value]
    circle: Callable[[Fraction], Circle[Value]]
    ln: Callable[[Value], Value]
    arccos: Callable[[Value], Value]
    root: Callable[[Value], Value]


class IrrationalError(ArithmeticError):
    """A value is not of the kind, or not known to be."""


def irrational(value: object) -> NoReturn:
    """Raise IrrationalError: what stands for a function whose values are not of the kind."""
    raise IrrationalError


def fraction_root(square: Fraction) -> Fraction:
    """Return the square root; raise IrrationalError if it is no fraction."""
    root = Fraction(isqrt(max(square.numerator, 0)), isqrt(square.denominator))
    return root if root * root == square else irrational(square)


class Expression:
    """An expression that was read once; `names` are the other cells in it, `transcendental` has a logarithm
    or an arc.

    `numbers` stand in place of their names, also in sines and cosines. With `later` those of names in sines
    and cosines are to come, by `with_numbers`.
    """

    def __init__(
        self, text: str, numbers: Mapping[str, Fraction] | None = None, *, later: bool = False
    ) -> None:
        self.text = text
        self._tree = parsed(text, "expression", UNREAD.format(text[:60]), numbers or {})
        _check(self._tree, text, later)
        named = {node.id for node in ast.walk(self._tree) if isinstance(node, ast.Name)}
        self.names = frozenset(named - {*FUNCTIONS})
        self.transcendental = bool(named & {"ln", "arccos"})

    def with_numbers(self, numbers: Mapping[str, Fraction]) -> Expression:
        """Return the same with numbers in place of their names."""
        return Expression(self.text, numbers)

    def value(self, kind: Numbers[Value], cell: Callable[[str], Value]) -> Value:
        """Return the value on a kind of number, with those of the cells that it names."""
        return _value(self._tree, kind, cell)

    def fraction(self) -> Fraction:
        """Return the value where there are no cells; raise IrrationalError if it is no fraction."""
        return self.value(FRACTIONS, irrational)


def _check(tree: ast.expr, text: str, later: bool) -> None:
    """Raise NotationError for anything but numbers, names, the four operations, powers and functions."""
    match tree:
        case ast.Constant(value=Fraction()) | ast.Name():
            return
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            _check(inner, text, later)
        case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=height)) if height in POWERS:
            _check(left, text, later)
        case ast.BinOp(op=ast.Pow(), right=ast.Constant(value=Fraction() as height)):
            raise wrong_power(text, height)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATIONS:
            _check(left, text, later)
            _check(right, text, later)
        case ast.Call(func=ast.Name(id=name), args=[inner], keywords=[]) if name in FUNCTIONS:
            _check(inner, text, later)
            names = any(isinstance(node, ast.Name) for node in ast.walk(inner))
            if name in ("sin", "cos") and not (later and names):
                _written_out(inner, text)
        case _:
            raise NotationError(
                f'"{text[:60]}" has what no expression may; it has numbers, names of cells, + - * / ^,'
                f" brackets, {', '.join(FUNCTIONS)}"
            )


def _written_out(tree: ast.expr, text: str) -> Fraction:
    """Return a number written out, as the argument of sin and cos must be."""
    match tree:
        case ast.Constant(value=Fraction() as value):
            return value
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            return -_written_out(inner, text)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATIONS:
            try:
                return Fraction(OPERATIONS[type(op)](_written_out(left, text), _written_out(right, text)))
            except ZeroDivisionError:
                raise NotationError(f'"{text[:60]}" divides by zero') from None
    raise NotationError(f'"{text[:60]}" has a sine or cosine of no number; write its degrees out')


def _value(tree: ast.expr, kind: Numbers[Value], cell: Callable[[str], Value]) -> Value:
    match tree:
        case ast.Constant(value=Fraction() as value):
            return kind.of(value)
        case ast.Name(id=name):
            return cell(name)
        case ast.UnaryOp(operand=inner):
            return -_value(inner, kind, cell)
        case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=Fraction() as height)):
            return power(_value(left, kind, cell), int(height))
        case ast.BinOp(left=left, op=op, right=right):
            found: Value = OPERATIONS[type(op)](_value(left, kind, cell), _value(right, kind, cell))
            return found
        case ast.Call(func=ast.Name(id="sin"), args=[inner]):
            return kind.circle(_written_out(inner, "")).sine
        case ast.Call(func=ast.Name(id="cos"), args=[inner]):
            return kind.circle(_written_out(inner, "")).cosine
        case ast.Call(func=ast.Name(id=name), args=[inner]):
            functions = {"ln": kind.ln, "arccos": kind.arccos, "sqrt": kind.root}
            return functions[name](_value(inner, kind, cell))
    raise AssertionError(tree)


BALLS = Numbers(ball, ball_circle, lambda value: value.log(), lambda value: 90 - ball_degrees(value), root)
FRACTIONS: Numbers[Fraction] = Numbers(lambda value: value, irrational, irrational, irrational, fraction_root)
BOUNDS = Numbers(Separation.rational, circle_separation, irrational, irrational, lambda value: value**0.5)


class TrueValue(NamedTuple):
    """What a cell is: its ball at the precision in force, its separation bound, None without one.

    `rational` is the value itself where it is known to be a fraction.
    """

    value: Callable[[], arb]
    bound: Callable[[], Separation] | None = None
    rational: Fraction | None = None

    def in_units(self, printed: PrintedValue) -> Units | None:
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
            return float((known(self.bound)() - Separation.rational(boundary * unit)).bits())

        ties: TieBits | None = NEVER_TIES if self.bound is None else tie_bits
        return rounded(lambda: self.value() / ball(unit), 0, "half-away", ties)

    def written_as(self, printed: PrintedValue) -> PrintedValue:
        """Return the value as another is printed; one in place of a quotient is rational."""
        units = self.in_units(printed)
        assert units is not None
        return printed.with_units(units)

    def equals(self, value: Fraction) -> bool:
        """Return whether it is this number itself."""
        bits = inf if self.bound is None else (self.bound() - Separation.rational(value)).bits()
        return vanishes(lambda: self.value() - ball(value), float(bits))


def constant(value: Fraction) -> TrueValue:
    """Return what is a rational number."""
    return TrueValue(lambda: ball(value), lambda: Separation.rational(value), value)


def formula_truth(formula: Expression, cells: Callable[[str], TrueValue]) -> TrueValue:
    """Return what a formula makes of the cells that it names."""
    rational = _rational(formula, cells)
    if rational is not None:
        return constant(rational)

    def bound(name: str) -> Separation:
        return known(cells(name).bound)()

    algebraic = not formula.transcendental and all(cells(name).bound is not None for name in formula.names)
    return TrueValue(
        lambda: formula.value(BALLS, lambda name: cells(name).value()),
        (lambda: formula.value(BOUNDS, bound)) if algebraic else None,
    )


def _rational(formula: Expression, cells: Callable[[str], TrueValue]) -> Fraction | None:
    """Return the value if fractions and roots of squares alone make it."""

    def fraction(name: str) -> Fraction:
        found = cells(name).rational
        return irrational(name) if found is None else found

    try:
        return formula.value(FRACTIONS, fraction)
    except IrrationalError:
        return None
    except ZeroDivisionError:
        raise NotationError(f'"{formula.text[:60]}" divides by zero') from None


def kept(truth: TrueValue) -> TrueValue:
    """Return the same, computed once for each precision."""
    from flint import ctx

    at = cache(lambda precision: truth.value())
    return TrueValue(lambda: at(ctx.prec), truth.bound and cache(truth.bound), truth.rational)


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


def _motion_truth(key: str, method: str, ratio: Fraction, phi: Fraction) -> TrueValue:
    quantity, crank = motion_registry()[key], Crank(ratio)
    choose(method, evaluation.METHODS, "method")
    if not evaluation.is_known(quantity, crank):
        raise NotationError(f"the quantity {key} has a unit, and no lengths are known; choose one without")

    def run(kind: Kind) -> Numeric:
        return evaluation.value(quantity, method, crank, kind.circle(phi), kind)

    # A method without a formula is told here, before anything is computed.
    evaluation.kernel_of(quantity, method, crank)
    algebraic = not evaluation.is_transcendental(quantity, crank)
    return TrueValue(lambda: ball(run(balls())), cache(lambda: separation_of(run)) if algebraic else None)


def _engine_truth(
    key: str,
    method: str,
    ratio: Fraction,
    epsilon: Fraction,
    back: Fraction | None = None,
    stroke: str = "turn",
) -> TrueValue:
    quantity, spans = engine_registry()[key], {name: span for span, (name, _) in SPANS.items()}
    where, turn = TurnPlace(spans[choose(stroke, spans, "stroke")]), engine_turn(ratio, epsilon, back, method)
    if not applies(quantity, where):
        raise NotationError(f"{key} is no quantity of {stroke}")

    return TrueValue(lambda: ball(engine_value(quantity, turn, where)))


@cache
def engine_turn(ratio: Fraction, epsilon: Fraction, back: Fraction | None, method: str) -> Any:
    """Return the turn of an engine by a method."""
    choose(method, ENGINE_METHODS, "method")
    return turn_of(Engine(Crank(ratio), Steam(epsilon, back)), method)


def _beam_truth(key: str, method: str, ratio: Fraction, arm: Fraction) -> TrueValue:
    choose(method, FAMILIES["arm"].methods, "method")
    engine = beam.BeamEngine(arm, ratio)
    return TrueValue(lambda: beam.value(beam.registry()[key], engine, method))


class QuantityFamily(NamedTuple):
    """Quantities that go by one axis beside the crank ratio: their methods, and the truth of one from the
    numbers by axis, of which some may be left out."""

    registry: Callable[[], Mapping[str, Quantity]]
    methods: Iterable[str]
    truth: Callable[..., TrueValue]
    free: tuple[str, ...] = ()


# By the axis that they go by.
FAMILIES: dict[str, QuantityFamily] = {
    "phi": QuantityFamily(motion_registry, evaluation.METHODS, _motion_truth),
    "epsilon": QuantityFamily(engine_registry, ENGINE_METHODS, _engine_truth, ("back", "stroke")),
    "arm": QuantityFamily(beam.registry, ("exact", "approximate"), _beam_truth),
}


def keys_by(axis: str) -> list[str]:
    """Return the keys of the quantities that an axis and the crank ratio settle."""
    crank, entries = Crank(Fraction(1, 5)), FAMILIES[axis].registry().items()
    return [key for key, one in entries if axis != "phi" or evaluation.is_known(one, crank)]


def methods_of(quantity: str) -> tuple[str, ...]:
    """Return the methods by which a quantity can be recomputed."""
    found = (one for one in reversed(FAMILIES.values()) if quantity in one.registry())
    return tuple(next(found, FAMILIES["phi"]).methods)


def quantity_truth(quantity: str, method: str, at: Mapping[str, Any]) -> TrueValue:
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
