"""Long columns: all values in floats, those too near to a rounding boundary in more digits or in balls; and
the records over crank angles, a chunk of angles at a time.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from importlib import import_module
from math import inf, lcm
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.drive.at import gain, known
from kurbel.drive.crank import Crank, largest
from kurbel.exact.kind import floats
from kurbel.exact.numerals import Number
from kurbel.kernel.circle import Circle, Numeric
from kurbel.motion.evaluation import LOADED, MOST_DECIMALS, Needs, columns_in_balls, fits_page, value
from kurbel.page.axes import angle_decimals, angle_number, shifted
from kurbel.page.build import Rows, records_of
from kurbel.page.quantity import Column
from kurbel.page.subject import Question
from kurbel.page.table import Records, Value
from kurbel.reading.given import found_at
from kurbel.reading.notation import Progression

if TYPE_CHECKING:
    import numpy as np

    from kurbel.exact.bulk import AngleColumn

# Floats are worth their while as long as few of them are doubtful.
DOUBTFUL_SHARE = 0.1
# Of what is known of quantities that have no arcs.
ARITHMETIC = {Needs.LENGTH, Needs.SPEED, Needs.MEAN_SPEED}
LARGEST_DENOMINATOR = 2**46
# So many cells take balls as long as sums of two floats take for the first.
MANY = 200
# So many angles of records are computed at a time.
CHUNK = 1 << 15


def is_long(columns: Sequence[Column], cranks: Sequence[Crank], angles: Sequence[Fraction]) -> bool:
    """Whether so many cells, to so few decimals, are worth NumPy's start-up: `columns_in_floats`."""
    if fits_page(columns, cranks, angles):
        return False
    # A float beside a dead centre does not tell for certain which way friction acts.
    if any(crank.has_friction or crank.pinned for crank in cranks):
        return False
    if any(column.quantity.exists for column in columns):
        return False
    if max(column.places for column in columns) > MOST_DECIMALS:
        return False
    reach = float(largest(angles))
    pairs = [(column, crank) for column in columns for crank in cranks]
    fit = all(suits_floats(*pair, reach) or suits_doubles(*pair, angles) for pair in pairs)
    return fit and has_arrays()


def suits_floats(column: Column, crank: Crank, reach: float) -> bool:
    """Whether few cells would be doubtful in floats, of angles up to so many degrees."""
    return 2 * float_bound(column, crank, reach) * 10.0**column.places < DOUBTFUL_SHARE


def suits_doubles(column: Column, crank: Crank, angles: Sequence[Fraction]) -> bool:
    """Whether the formula is arithmetic, which sums of two floats do as well, and its digits fit 64 bits."""
    quantity = column.quantity
    plain = ARITHMETIC.issuperset(quantity.needs) and not quantity.in_degrees and not crank.acceleration
    if not plain or (crank.loaded and LOADED in quantity.formulas) or not isinstance(angles, Progression):
        return False
    denominator = lcm(angles.start.denominator, angles.step.denominator)
    if denominator > LARGEST_DENOMINATOR or largest(angles) * denominator >= 2**60:
        return False
    return greatest_value(column, crank) * 10.0**column.places < 2.0**60


def has_arrays() -> bool:
    """Whether there is NumPy; in a browser there is none, and balls do what floats would do sooner."""
    try:
        import_module("numpy")
    except ImportError:
        return False
    return True


def float_bound(column: Column, crank: Crank, largest_angle: float) -> float:
    """Return how far a float of this column can lie from the true value at the exact angle.

    The kernel's own error is a few units in the last place (tests/kernel); rounding λ and the
    angle to floats adds their share times the slope. Powers of 1/(1 - sin² ψ) cover the growth of all of them
    up to the slope of the acceleration as λ nears 1.
    """
    in_radians = max(largest_angle, 360.0) / 57
    return float((16 + 4 * in_radians) * 2.0**-53 * greatest_value(column, crank))


def greatest_value(column: Column, crank: Crank) -> float:
    """Return what no value of the column, nor its slopes over λ and the angle, exceeds by much."""
    if Needs.EVEN in column.quantity.needs:
        # Most tables have no forces of a rod.
        from kurbel.motion.inertia import has_poles

        if has_poles(column.quantity, crank):
            return inf
    if Needs.ARM in column.quantity.needs:
        # Over a force that nearly vanishes.
        return inf
    steepest = float(crank.ratio) * (1 + abs(float(crank.offset)))
    growth = (1 - min(steepest, 1 - 1e-12) ** 2) ** -3.5
    quantity = column.quantity
    scale = abs(float(quantity.scale(crank, floats()))) if quantity.scale else 1.0
    if Needs.FORCE in quantity.needs and crank.force is not None:
        scale *= float(crank.force.growth)
    if LOADED in quantity.formulas and crank.loaded:
        # A force is a sum of few products of these with powers of 1/cos ψ.
        scale *= 8 * float(greatest_load(crank))
    if crank.acceleration:
        scale *= 1 + abs(float(gain(crank, floats())))
    return float(growth * quantity.bound * scale)


def columns_in_floats(
    columns: Sequence[Column], crank: Crank, angles: Sequence[Fraction], rounding: str
) -> list[np.ndarray]:
    """Return the same as int64 arrays: all values in floats, certified where they are doubtful."""
    from kurbel.exact.bulk import evaluate

    degrees = float_angles(angles)
    reach = float(abs(degrees).max())
    rough = [suits_floats(column, crank, reach) for column in columns]
    values = evaluate(
        [on_floats(one, crank) for one, fit in zip(columns, rough, strict=True) if fit], degrees
    )
    left, sharp = iter(values), DoubtfulCells(crank, angles, rounding)
    return [
        sharp.settled(column, *_rounded(column, next(left), float_bound(column, crank, reach), rounding))
        if fit
        else sharp.column(column)
        for column, fit in zip(columns, rough, strict=True)
    ]


def _rounded(
    column: Column, values: np.ndarray, bound: float, rounding: str
) -> tuple[np.ndarray, np.ndarray]:
    """Return the digits of floats and the rows in which these are doubtful."""
    from kurbel.exact.bulk import nearest

    scaled, doubtful = nearest(values, column.places, bound, half_even=rounding == "half-even")
    return scaled, doubtful.nonzero()[0]


class DoubtfulCells:
    """Cells that floats do not settle: many of them in sums of two floats, what those leave in balls."""

    def __init__(self, crank: Crank, angles: Sequence[Fraction], rounding: str) -> None:
        self.crank, self.angles, self.rounding = crank, angles, rounding

    def settled(self, column: Column, scaled: np.ndarray, rows: np.ndarray) -> np.ndarray:
        """Return the digits with those of these rows settled."""
        if len(rows) >= MANY and suits_doubles(column, self.crank, self.angles):
            scaled[rows] = self._digits(column, self._circle(rows), rows)
        else:
            for row in rows.tolist():
                scaled[row] = self._in_balls(column, row)
        return scaled

    def column(self, column: Column) -> np.ndarray:
        """Return the digits of all rows."""
        import numpy as np

        rows = np.arange(len(self.angles))
        if suits_doubles(column, self.crank, self.angles):
            return self._digits(column, self._all, rows)
        return self.settled(column, np.zeros(len(rows), np.int64), rows)

    @cached_property
    def _all(self) -> Circle[Numeric]:
        return self._circle(slice(None))

    def _circle(self, rows: np.ndarray | slice) -> Circle[Any]:
        from kurbel.exact.doubles import circle

        assert isinstance(self.angles, Progression)
        numerators, denominator = integer_angles(self.angles)
        return circle(numerators[rows], denominator)

    def _digits(self, column: Column, point: Circle[Numeric], rows: np.ndarray) -> np.ndarray:
        from kurbel.exact.doubles import numbers, settled

        found = value(column.quantity, column.method, self.crank, point, numbers())
        return settled(found, len(rows), column.places, lambda row: self._in_balls(column, int(rows[row])))

    def _in_balls(self, column: Column, row: int) -> int:
        [[digits]] = columns_in_balls([column], self.crank, [self.angles[row]], self.rounding)
        return known(digits)


def on_floats(column: Column, crank: Crank) -> Callable[[Circle[Numeric]], Numeric] | AngleColumn:
    """Return the column as a function of the circle of floats or arrays, a time as one of the angle."""
    if Needs.TIME in column.quantity.needs:
        from kurbel.exact.bulk import AngleColumn

        return AngleColumn(
            lambda degrees: value(column.quantity, column.method, crank, None, floats(), degrees)
        )
    return lambda circle: value(column.quantity, column.method, crank, circle, floats())


def float_angles(angles: Sequence[Fraction]) -> np.ndarray:
    """Return the angles as floats, each at most one unit in the last place off."""
    import numpy as np

    if isinstance(angles, Progression):
        numerators, denominator = integer_angles(angles)
        if max(abs(int(numerators[0])), abs(int(numerators[-1])), denominator) < 2**53:
            return numerators / denominator
    return np.array([float(angle) for angle in angles])


def integer_angles(angles: Progression) -> tuple[np.ndarray, int]:
    """Return the numerators of all angles over one denominator; Python integers where 62 bits are too few."""
    import numpy as np

    denominator = lcm(angles.start.denominator, angles.step.denominator)
    first, step = int(angles.start * denominator), int(angles.step * denominator)
    last = first + step * len(angles)
    kind = np.int64 if max(abs(first), abs(last)) < 2**62 else object
    return first + step * np.arange(len(angles), dtype=kind), denominator


def greatest_load(crank: Crank) -> Fraction:
    """Return a bound of the forces in newtons that piston force and moving masses call up, but for the rod's
    slant: without the factor (2π)² where the speed counts turns."""
    moving, speed = crank.moving, crank.speed
    force = abs(crank.force.first) * crank.force.growth if crank.force else Fraction(0)
    if crank.effort is not None:
        force += crank.effort.greatest
        if crank.effort.shaft and speed is not None:
            force += crank.effort.shaft.power / known(crank.radius) / speed.value
    if moving is None or speed is None:
        return force
    pin, crosshead, couple, _ = moving.joined
    masses = abs(pin) + crosshead + abs(Fraction(couple)) + moving.reciprocating + abs(moving.rotating)
    factor = 40 if speed.turns else 1
    weight = 2 * masses * moving.slope.gravity if moving.slope else 0
    return force + weight + masses * known(crank.radius) * speed.value**2 * factor


def worthwhile(question: Question, columns: str) -> Any:
    """Return the long columns of a question, by the place of their class; None where there is no NumPy or
    floats would settle too few digits."""
    if not has_arrays():
        return None
    found = found_at(columns)(question)
    return found if found.is_worth() else None


def long_records(question: Any) -> Records:
    """Return the records over the crank angle, in chunks where long columns are worth it."""
    records = records_of(question)
    if question.long is None:
        return records
    from kurbel.motion.long import LongRows

    return records._replace(rows=LongRows(question, [field.key for field in records.fields]))


class Chunk(NamedTuple):
    """Records that differ in their angle alone: what stands for the other axes, the angles, the scaled digits
    of the columns, and how many of these are decimals, each by its key."""

    others: Mapping[str, Value]
    angles: Sequence[Fraction]
    scaled: Mapping[str, Any]
    decimals: Mapping[str, int]


class RecordRows(Rows):
    """The records of a question over crank angles, the innermost axis, a chunk of angles at a time."""

    question: Any

    def __init__(self, question: Any, keys: Sequence[str]) -> None:
        super().__init__(question, {}, {column.key: column for column in question.page_columns}, keys)

    def __iter__(self) -> Iterator[tuple[Value, ...]]:
        zero, of_angles = self.question.zero, angle_decimals(self.counted)
        for others, angles, scaled, decimals in self.chunks():
            for row, angle in enumerate(angles):
                axes = {**others, "phi": angle_number(angle - zero, of_angles)}
                yield tuple(
                    axes[key] if key in axes else scaled_number(scaled[key][row], decimals[key])
                    for key in self.keys
                )

    @property
    def bulk(self) -> bool:
        """Whether they are computed in arrays."""
        return bool(self.question.bulk)

    @property
    def counted(self) -> Sequence[Fraction]:
        """The angles as the page counts them."""
        return shifted(self.question.angles, -self.question.zero)

    @property
    def stub_values(self) -> Sequence[Value]:
        """All that stands for places of the other axes."""
        axis = self.question.axes["ratio"]
        return [axis.value({"ratio": place}) for place in range(axis.count)]

    def chunks(self) -> Iterator[Chunk]:
        """Yield the records in their order, ratio by ratio."""
        question = self.question
        decimals = {key: column.places for key, column in self.columns.items()}
        # What fits one chunk is computed once for the page and for all its records.
        kept = len(question) <= CHUNK and not question.layout.pairs
        for number, crank in enumerate(question.cranks):
            axis = question.axes["ratio"]
            ratio: Mapping[str, Value] = {axis.key: axis.value({"ratio": number})}
            for start in range(0, len(question.angles), CHUNK):
                part = question.angles[start : start + CHUNK]
                values = question.values[number] if kept else question.scaled(crank, part)
                yield Chunk(ratio, part, dict(zip(self.columns, values, strict=True)), decimals)


def scaled_number(scaled: int | None, decimals: int, times: int = 1) -> Number | None:
    """Return scaled digits as a number, None where there is none."""
    return None if scaled is None else Number(int(scaled) * times, decimals)
