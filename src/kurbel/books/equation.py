"""What a step from one printed formula to another is found to be: by proof, and by its values at points, in
balls, which prove that two values differ, and in power series of a small letter."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import cached_property
from random import Random
from typing import NamedTuple

from flint import arb, arb_series

from kurbel.books.form import Algebra, Form, Letters, Value
from kurbel.books.proof import MOST_AT_POINTS, MOST_OF_PROOFS, PARTS, Quotient, Symbols, UnprovableError, Work
from kurbel.exact.certify import Kept, at_bits, ball
from kurbel.exact.numerals import MOST_FIGURES
from kurbel.exact.separation import TooLargeError

BITS = 256
# Letters are eighths up to 3/2: angles of the first quadrant, ratios on both sides of 1.
EIGHTHS = 12
POINTS = 8
# Points at which formulas have no value are passed over.
MOST_POINTS = 400
# Of their range, to part roots.
CELLS = 96
# Of a power series.
TERMS = 12
# What an operation with such a series costs, in those with balls.
OF_SERIES = 10
# Beyond this, numbers are not told apart.
LARGEST = ball(Fraction(10**MOST_FIGURES))
_NAMES = {"ln": "log", "arcsin": "asin", "arctan": "atan"}


class Balls:
    """The algebra of balls."""

    def __init__(self, work: Work) -> None:
        self.work = work

    @cached_property
    def pi(self) -> arb:
        return arb.pi()

    def spend(self, operations: float) -> None:
        self.work.spend(operations)

    def of(self, value: Fraction) -> arb:
        return ball(value)

    def apply(self, function: str, value: arb) -> arb:
        found: arb = getattr(value, _NAMES.get(function, function))()
        return found


class Series:
    """The algebra of power series in a small letter, with balls for coefficients."""

    def __init__(self, work: Work) -> None:
        self.work = work

    @cached_property
    def pi(self) -> arb_series:
        return self.constant(arb.pi())

    def spend(self, operations: float) -> None:
        self.work.spend(OF_SERIES * operations)

    def of(self, value: Fraction) -> arb_series:
        return self.constant(ball(value))

    def constant(self, value: arb) -> arb_series:
        return arb_series([value], TERMS)

    @property
    def small(self) -> arb_series:
        return arb_series([0, 1], TERMS)

    def apply(self, function: str, value: arb_series) -> arb_series:
        if function == "cot":
            sine, cosine = value.sin_cos()
            return cosine / sine
        found: arb_series = getattr(value, _NAMES.get(function, function))()
        return found


def points(letters: frozenset[str]) -> Iterator[Mapping[str, Fraction]]:
    """Yield points for letters, always the same: fractions that differ as far as there are enough."""
    chosen = Random(" ".join(sorted(letters)))
    for _ in range(MOST_POINTS):
        yield {name: Fraction(chosen.randint(1, EIGHTHS), 8) for name in sorted(letters)}


def at_points(
    letters: frozenset[str], value_at: Callable[[Mapping[str, Fraction]], Kept | None]
) -> Iterator[Kept]:
    """Yield what is found at the first points where there is something, at high precision."""
    found = 0
    with at_bits(BITS):
        for point in points(letters):
            value = value_at(point)
            if value is not None:
                found += 1
                yield value
            if found == POINTS or (not letters and found):
                return


def is_moderate(value: arb) -> bool:
    """Whether a ball is of a number that is computed: of so many figures, or places, at the most."""
    return bool(abs(value) < LARGEST and (0 in value or abs(value) * LARGEST > 1))


def cells() -> Iterator[arb]:
    """Yield balls that cover what letters are chosen from."""
    for index in range(CELLS):
        yield arb(2 * index + 1, 1) * EIGHTHS / (16 * CELLS)


def ends(cell: arb) -> tuple[arb, arb]:
    """Return the ends of a ball."""
    return arb(cell.lower()), arb(cell.upper())


def order_of(series: arb_series) -> int | None:
    """Return the power of the first term that is certainly there, None without one."""
    for power, coefficient in enumerate(series.coeffs()):
        if 0 not in coefficient:
            return power
    return None


# How a formula follows from one before it: it begins; it is equal; it is so but for what the book neglects;
# it is the same equation for a letter; its value of a letter solves the equation.
BEGINS, EQUAL, NEARLY, SAME, ROOT = "", "equal", "nearly", "same", "root"
RELATIONS = (BEGINS, EQUAL, NEARLY, SAME, ROOT)
# What needs a letter: the small one, or the unknown.
OF_LETTER = (NEARLY, SAME, ROOT)
# The sign ±, which is worked with both.
SIGN = "pm"
# A wrong formula may be off by a simple factor.
MOST_FACTOR = 12

STARTS, HOLDS, AGREES, ORDER = "starts", "proved", "agrees", "order"
UNSETTLED, ONLY_NEARLY, FACTOR, WRONG = "unsettled", "only_nearly", "factor", "wrong"
FAR, OTHER, NO_ROOT = "far", "other_equation", "no_root"
# From what is right to what is wrong.
KINDS = (STARTS, HOLDS, AGREES, ORDER, UNSETTLED, ONLY_NEARLY, FACTOR, FAR, WRONG, OTHER, NO_ROOT)
FINE = (STARTS, HOLDS, AGREES, ORDER)
Point = Mapping[str, Fraction]


# The point of what is found of no point.
NOWHERE: Point = {}


class Finding(NamedTuple):
    """What is found: the kind, and what belongs to it.

    `order` is the power of the small letter in the relative difference, `factor` how many times too great a
    formula is, `point` one at which both sides, as balls, differ.
    """

    kind: str
    order: int = 0
    factor: Fraction = Fraction(1)
    point: Point = NOWHERE
    sides: tuple[arb, ...] = ()


class Step(NamedTuple):
    """A formula that follows from another, with the forms of the letters in both."""

    before: Form
    form: Form
    relation: str
    letter: str
    forms: Mapping[str, Form]

    def letters(self) -> frozenset[str]:
        """Return the letters that stand for any number."""
        free: set[str] = set()
        waiting = [*self.before.letters, *self.form.letters, *([self.letter] if self.letter else [])]
        seen: set[str] = set()
        while waiting:
            name = waiting.pop()
            if name in seen:
                continue
            seen.add(name)
            if name in self.forms and name != self.letter:
                waiting += self.forms[name].letters
            else:
                free.add(name)
        return frozenset(free)

    def sides(self, algebra: Algebra[Value], given: Mapping[str, Value]) -> tuple[Value, Value]:
        """Return what must be equal."""
        letters = Letters(algebra, given, self.forms)
        if self.relation == ROOT:
            solved = Letters(algebra, given, {**self.forms, self.letter: self.form})
            return solved.of(self.before), algebra.of(Fraction(0))
        if self.relation == SAME:
            other = Letters(algebra, {**given, self.letter: given[_OTHER]}, self.forms)
            left = letters.of(self.before) * other.of(self.form)
            return left, letters.of(self.form) * other.of(self.before)
        return letters.of(self.before), letters.of(self.form)


# A second value of the unknown.
_OTHER = "other"
_NOTHING = Form("0")


class StepWork(NamedTuple):
    """The work that is left of a step."""

    proofs: Work
    points: Work


def found(step: Step) -> Finding:
    """Return what the step is; of both signs the worse. What takes too much work is not settled."""
    works = StepWork(Work(MOST_OF_PROOFS), Work(MOST_AT_POINTS))
    letters = step.letters()
    free = (letters | {_OTHER} if step.relation == SAME else letters) - {SIGN}
    if step.relation == ROOT:
        free -= {step.letter}
    signs = (1, -1) if SIGN in letters else (1,)
    return max((_found(step, free, sign, works) for sign in signs), key=lambda one: KINDS.index(one.kind))


def _found(step: Step, free: frozenset[str], sign: int, works: StepWork) -> Finding:
    if _proved(step, free, sign, works.proofs):
        # Nothing is a multiple of every equation, and says none.
        nothing = (step._replace(before=_NOTHING, form=one, relation=EQUAL) for one in step[:2])
        empty = step.relation == SAME and any(_proved(one, free, sign, works.proofs) for one in nothing)
        return Finding(UNSETTLED if empty else HOLDS)
    try:
        return _computed(step, free, sign, works)
    except UnprovableError:
        return Finding(UNSETTLED)


def _computed(step: Step, free: frozenset[str], sign: int, works: StepWork) -> Finding:
    """Return what the step is by its values at points. Raises UnprovableError for too much work."""
    if step.relation == SAME:
        return Finding(OTHER if any(_other_roots(step, free - {_OTHER}, sign, works.points)) else UNSETTLED)
    if step.relation == NEARLY:
        return _nearly(_order(step, free - {step.letter}, sign, works.points))
    at_all = tuple(_at_points(step, free, sign, works.points))
    apart = next((one for one in at_all if one.kind == WRONG), None)
    if apart is None:
        return at_all[0] if at_all else Finding(UNSETTLED)
    if step.relation == ROOT:
        return apart._replace(kind=NO_ROOT)
    return _unequal(step, free, sign, apart, works)


def _nearly(order: int | None) -> Finding:
    """Return what an approximation of the book is."""
    if order is None:
        return Finding(UNSETTLED)
    return Finding(ORDER, order=order) if order > 0 else Finding(FAR)


def _unequal(step: Step, free: frozenset[str], sign: int, apart: Finding, works: StepWork) -> Finding:
    """Return what is to be said of two sides that differ at a point."""
    order = _order(step, free - {step.letter}, sign, works.points) if step.letter else None
    if order is not None and order > 0:
        return Finding(ONLY_NEARLY, order=order)
    factor = _factor(step, free, sign, apart, works.proofs)
    return apart if factor is None else Finding(FACTOR, factor=factor)


def _proved(step: Step, free: frozenset[str], sign: int, work: Work, times: Fraction = Fraction(1)) -> bool:
    """Return whether both sides, the first so many times, are the same quotient of polynomials."""
    for parts in PARTS:
        symbols = Symbols(parts, work)
        given = {name: symbols.letter() for name in sorted(free)}
        try:
            left, right = step.sides(symbols, {**given, SIGN: symbols.of(Fraction(sign))})
            same: bool = Quotient.equals(left * symbols.of(times), right)
        except (UnprovableError, TooLargeError):
            continue
        return same
    return False


def _at_points(step: Step, free: frozenset[str], sign: int, work: Work) -> Iterator[Finding]:
    """Yield for points whether the sides differ there for certain, or else agree."""

    def at(point: Point) -> Finding | None:
        balls = Balls(work)
        given = {name: balls.of(value) for name, value in point.items()}
        left, right = step.sides(balls, {**given, SIGN: balls.of(Fraction(sign))})
        apart = left - right
        if not (is_moderate(left) and is_moderate(right)):
            return None
        return Finding(AGREES) if 0 in apart else Finding(WRONG, point=point, sides=(left, right))

    return at_points(free, at)


def _other_roots(step: Step, free: frozenset[str], sign: int, work: Work) -> Iterator[bool]:
    """Yield for points whether the first equation has a root where the second has none, for certain."""

    def at(point: Point) -> bool | None:
        balls = Balls(work)
        given = {name: balls.of(value) for name, value in point.items()} | {SIGN: balls.of(Fraction(sign))}

        def value(form: Form, unknown: arb) -> arb:
            return Letters(balls, {**given, step.letter: unknown}, step.forms).of(form)

        for cell in cells():
            below, above, first, last = value(step.before, cell), value(step.form, cell), *ends(cell)
            falls = value(step.before, first) * value(step.before, last) < 0
            if falls and below.is_finite() and above.is_finite() and 0 not in above:
                return True
        return False

    return at_points(free, at)


def _order(step: Step, free: frozenset[str], sign: int, work: Work) -> int | None:
    """Return the power of the small letter in the relative difference, None where none is found."""

    def at(point: Point) -> int | None:
        series = Series(work)
        given = {name: series.of(value) for name, value in point.items()}
        try:
            left, right = step.sides(
                series, {**given, step.letter: series.small, SIGN: series.of(Fraction(sign))}
            )
        except (ValueError, ZeroDivisionError):
            return None
        apart, first = order_of(left - right), order_of(left)
        return None if apart is None or first is None else apart - first

    return min(at_points(free, at), default=None)


def _factor(step: Step, free: frozenset[str], sign: int, apart: Finding, work: Work) -> Fraction | None:
    """Return how many times too great the formula is, if that is one simple number everywhere, by proof."""
    left, right = apart.sides
    with at_bits(BITS):
        for bottom in range(1, MOST_FACTOR + 1):
            whole = (right * bottom / left).unique_fmpz() if 0 not in left else None
            if whole is not None and whole != 0:
                factor = Fraction(int(whole), bottom)
                return factor if _proved(step, free, sign, work, factor) else None
    return None
