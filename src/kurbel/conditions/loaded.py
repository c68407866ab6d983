"""Conditions on the forces of an engine: all crank angles of its cycle at which they hold, with proof.

Between two neighbouring dead centres or corners of the load a force is smooth; there all its zeros and
extremes are enclosed (engine/segments). Angles are half turns from the inner dead centre of the first crank.

Conditions on the forces of an engine become a table of the crank angles at which they hold.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property, lru_cache, partial
from itertools import product
from operator import pos
from typing import NamedTuple, cast

from flint import arb

from kurbel.conditions.solve_page import WORDS as SOLVED
from kurbel.conditions.solve_page import RootAxis, RootsQuestion, condition_axis, exists
from kurbel.drive.at import CRANK_FORCES, CrankForce
from kurbel.engine.captions import about_engines
from kurbel.engine.cylinder import AnyTurn, Cylinder, cranks_of
from kurbel.engine.engine_page import LoadAxis
from kurbel.engine.engine_quantities import engine_registry
from kurbel.engine.notes import from_dead_centre, notes
from kurbel.engine.request import EngineRequest
from kurbel.engine.segments import At, Segment, extreme_value, extremes, is_level, segments, zeros
from kurbel.engine.turn import Turn, turn_ties
from kurbel.errors import NoRootError, ProblemError
from kurbel.exact.certify import NEVER_TIES, TieBits, at_bits, ball, rounded
from kurbel.exact.numerals import Label, Number, exact_text, nearest, number_text
from kurbel.exact.place import Place as FoundPlace
from kurbel.exact.place import fraction
from kurbel.exact.search import EQUAL_BITS, Jet, jet_of
from kurbel.kernel.circle import Numeric
from kurbel.page.axes import ColumnAxis, Place, RatioAxis
from kurbel.page.quantity import Column, Of, Texts, filled
from kurbel.page.subject import Subject
from kurbel.page.table import Note
from kurbel.reading import units
from kurbel.reading.where import EXTREMES, MIN, MOST, VALUE, Condition

TORQUE = "torque"
# Decimals in which sentences say what a force covers.
RANGE_DECIMALS, UNIT_DECIMALS = 4, 1
RANGE_BITS = 128


class ConditionQuantity(NamedTuple):
    """What a condition can be about: the column that shows it in Q or Q r, the one in N or N m or nothing,
    and how a text in these is read."""

    column: str
    measured: str = ""
    read: Callable[[str, str], Fraction] = units.signed_force


# By their names in conditions.
ASKED: Mapping[str, ConditionQuantity] = {
    "torque": ConditionQuantity("tangential", "torque_nm", units.signed_torque),
    "tangential": ConditionQuantity("tangential"),
    "tangential_excess": ConditionQuantity("tangential_excess"),
    "energy": ConditionQuantity("energy"),
    **{key: ConditionQuantity(key, f"{key}_n") for key in CRANK_FORCES},
}
NAMES = {name: name for name in ASKED}
MEASURED = tuple(name for name, asked in ASKED.items() if asked.measured)


class TurnForces:
    """The forces of a turn as conditions see them."""

    def __init__(self, turn: Turn) -> None:
        self.turn = turn
        self.places = cache(self._places)
        self.quantity = cache(self._quantity)

    @cached_property
    def segments(self) -> list[Segment]:
        return segments(self.turn, cranks_of(self.turn.engine), self.turn.cycle)

    def _quantity(self, column: str) -> Callable[[Segment, arb], Jet]:
        """Return what a column in Q or Q r shows, with its slopes."""
        if column in CRANK_FORCES:
            return partial(_crank_force, CRANK_FORCES[column])
        return {"tangential": _tangential, "tangential_excess": _excess, "energy": _energy}[column]

    def target(self, condition: Condition) -> arb:
        """Return the value that is asked for, in Q or Q r."""
        if not condition.unit:
            return ball(condition.value)
        return ball(measured(condition)) / self._unit(condition)

    def _unit(self, condition: Condition) -> arb:
        """Return Q r in N m or Q in N, of a condition with a unit, else 1."""
        if not condition.unit:
            return ball(1)
        return ball(self.turn.torque_unit() if condition.quantity == TORQUE else self.turn.force_unit())

    def _places(self, condition: Condition) -> tuple[At, ...]:
        """Return where the condition holds over the cycle, in order; raise NoRootError if nowhere."""
        quantity = self.quantity(ASKED[condition.quantity].column)
        if condition.kind in EXTREMES:
            sign, measure = -1 if condition.kind == MIN else 1, abs if condition.kind == MOST else pos
            found = extremes(self.segments, quantity, sign, measure)
        else:
            found = [
                At(segment, place)
                for segment in self.segments
                for place in self._on_segment(segment, quantity, condition)
            ]
        # A dead centre belongs to the stroke that begins there, the last one to the first.
        kept = {id(one.place): one for one in found}
        if id(self.segments[0].start) in kept:
            kept.pop(id(self.segments[-1].end), None)
        if not kept:
            raise NoRootError(self._nowhere(condition, quantity))
        return tuple(sorted(kept.values(), key=lambda one: float(one.place.half_turns().mid())))

    def _on_segment(
        self, segment: Segment, quantity: Callable[[Segment, arb], Jet], condition: Condition
    ) -> list[FoundPlace]:
        with at_bits(EQUAL_BITS):
            start, end = (place.half_turns() for place in (segment.start, segment.end))
            apart = quantity(segment, (start + end) / 2).value - self.target(condition)
            degrees = [fraction((180 * at).mid()) for at in (start, end)]
        if apart.contains(0) and is_level(segment, quantity):
            low, high = (number_text(nearest(at, 2)) for at in degrees)
            raise ProblemError(
                f"{condition} holds at every crank angle from {low}° to {high}°; ask for another value"
            )
        return zeros(segment, quantity, lambda half_turns: self.target(condition))

    def _nowhere(self, condition: Condition, quantity: Callable[[Segment, arb], Jet]) -> str:
        units_of = ("N m", "Q r") if condition.quantity in (TORQUE, "energy") else ("N", "Q")
        with at_bits(RANGE_BITS):
            ends = [
                fraction(
                    (
                        self._unit(condition)
                        * extreme_value(extremes(self.segments, quantity, sign), quantity, sign)
                    ).mid()
                )
                for sign in (-1, 1)
            ]
        decimals = UNIT_DECIMALS if condition.unit else RANGE_DECIMALS
        least, most = (number_text(nearest(end, decimals)) for end in ends)
        said = f"{condition.quantity} lies between {least} and {most} {units_of[not condition.unit]}"
        jumps = ", and may jump at a dead centre" if condition.quantity in CRANK_FORCES else ""
        part, unit = self.turn.part, units_of[0]
        known = condition.quantity in MEASURED and part.pressure is not None
        known = known and (unit != "N m" or self.turn.engine.crank.radius is not None)
        hint = "" if condition.unit or not known else f'; in {unit} write "{condition} {unit}"'
        return f"{condition} is reached nowhere; {said}{jumps}{hint}"


def measured(condition: Condition) -> Fraction:
    """Return the value of a condition with a unit in N or N m."""
    asked = ASKED[condition.quantity]
    return asked.read(f"{exact_text(condition.value)} {condition.unit}", condition.quantity)


def _crank_force(force: CrankForce, segment: Segment, half_turns: arb) -> Jet:
    """A force of the first crank."""
    crank = next(segment.cranks(half_turns))
    return jet_of(crank.cylinder.force(force, crank.stroke, crank.angle))


def _total(of: Callable[[Cylinder, int, Numeric], Numeric], segment: Segment, half_turns: arb) -> Jet:
    """What all cranks have together."""
    found = [of(crank.cylinder, crank.stroke, crank.angle) for crank in segment.cranks(half_turns)]
    return sum(map(jet_of, found), Jet(0, 0, 0))


_tangential: Callable[[Segment, arb], Jet] = partial(_total, Cylinder.effort)


def _excess(segment: Segment, half_turns: arb) -> Jet:
    return _tangential(segment, half_turns) - jet_of(segment.turn.mean_force())


def _energy(segment: Segment, half_turns: arb) -> Jet:
    """The work of the excess, whose slope is the power above its mean."""
    turn = segment.turn
    excess = _total(Cylinder.power, segment, half_turns) - jet_of(turn.mean_force())
    cylinders = turn.cylinders
    since = sum(
        cylinders[part].energy(stroke, half_turns - ball(segment.middle - angle))
        for part, stroke, angle in segment.standing
    )
    before = sum(cylinders[part].energy(*standing) for part, *standing in turn.begun())
    return Jet(since - before, excess.value, excess.slope)


KEPT = 64
WORDS = Texts("conditions", "loaded")


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class LoadedRequest(RootsQuestion, EngineRequest):
    """What is asked for: where the forces of these engines fulfil the conditions."""

    def check(self) -> None:
        super().check()
        if not self.conditions:
            raise ProblemError(
                'no condition was given; write one as --where torque=max or --where "torque=0"'
            )
        if self.carded:
            raise ProblemError(
                "conditions under an indicator card are not solved: between its points nothing is proved;"
                " give ideal steam, such as --eps 4, or print the forces over the turn, kurbel forces --card"
            )
        for condition in self.conditions:
            column = self.column_of(condition)
            if missing := self.missing(self.entry(column)):
                raise ProblemError(f'condition "{condition}" is in {condition.unit}: {missing}')

    def each(self) -> Iterator[Sequence[At]]:
        asked = product(range(len(self.steams)), range(len(self.drives)), range(len(self.conditions)))
        for expansion, ratio, condition in asked:
            yield self.roots({"expansion": expansion, "ratio": ratio, "condition": condition})

    @cached_property
    def loaded(self) -> Callable[[AnyTurn], TurnForces]:
        return lru_cache(KEPT)(lambda turn: TurnForces(cast("Turn", turn)))

    def at(self, place: Place) -> TurnForces:
        """Return the forces of the engine at a place."""
        return self.loaded(self.turn(place["expansion"], place["ratio"], self.method))

    @property
    def method(self) -> str:
        return self.methods[0] if self.methods else "exact"

    def roots(self, place: Place) -> Sequence[At]:
        return self.at(place).places(self.conditions[place["condition"]])

    def column_of(self, condition: Condition) -> str:
        """Return the column that shows what a condition is about, in its unit."""
        asked = ASKED[condition.quantity]
        return asked.measured if condition.unit else asked.column

    def measured(self, condition: Condition) -> str:
        return ASKED[condition.quantity].measured

    def in_letters(self, condition: Condition) -> Label:
        """Return a condition in letters: T = 0.5 Q; M_d greatest."""
        shown = self.entry(self.column_of(condition))
        symbol = shown.symbol.strip("$")
        if condition.kind in EXTREMES:
            return SOLVED[condition.kind][self.lang].format(symbol=symbol)
        unit = f'"{condition.unit}"' if condition.unit else shown.unit[self.lang].strip("$")
        value = exact_text(condition.value)
        return f"${symbol} = {value} {unit}$" if condition.value else f"${symbol} = 0$"

    def angle(self, place: Place, share: int, decimals: int) -> Number:
        found = self.roots(place)[place["root"]].place
        if found.exact is not None:
            return nearest(share * 180 * found.exact, decimals, self.rounding)
        scaled = rounded(lambda: share * 180 * found.half_turns(), decimals, self.rounding, NEVER_TIES)
        return Number(scaled, decimals)


def _number(question: LoadedRequest, column: Column, place: Place, times: int) -> Number:
    condition = question.conditions[place["condition"]]
    decimals, rounding = column.places, question.rounding
    if condition.kind == VALUE and column.key == question.column_of(condition):
        value = measured(condition) if condition.unit else condition.value
        if question.units is not None:
            value *= question.units.times(question.entry(column.key).plain_unit("en"))
        return nearest(times * value, decimals, rounding)
    loaded, at = question.at(place), question.roots(place)[place["root"]]
    # The same in Q or Q r has this key.
    key = "tangential" if column.key == "torque_nm" else column.key.removesuffix("_n")
    turn = loaded.turn
    scale = column.quantity.scale or (lambda turn: 1)

    def found() -> Numeric:
        return times * at.value(loaded.quantity(key)) * scale(turn)

    ties: TieBits | None = NEVER_TIES
    if key in CRANK_FORCES and at.place.exact is not None:
        _, stroke, standing = at.segment.standing[0]
        angle = at.place.exact - at.segment.middle + standing
        ties = turn_ties(
            lambda on: times * on.cylinder.force(CRANK_FORCES[key], stroke, angle) * scale(on), [turn]
        )
    return Number(rounded(found, decimals, rounding, ties), decimals)


def _caption(question: LoadedRequest) -> Label:
    one = len(question.conditions) == 1
    said = f", {question.in_letters(question.conditions[0])}" if one else ""
    parts = {**about_engines(question, [question.method]), "{condition}": said}
    return filled(question.layout.caption[question.lang], parts.items())


def _notes(question: LoadedRequest) -> Iterator[Label | Note]:
    lang = question.lang
    regular = from_dead_centre(question, question.method)
    yield WORDS["angles" if regular else "angles_off"][lang]
    if question.assembly is not None:
        yield WORDS["cylinder"][lang].format(number=(*question.numbers, 1)[0])
    if any(condition.kind in EXTREMES for condition in question.conditions):
        yield WORDS["extremes"][lang]
    yield from notes(question)


SUBJECT = Subject(
    key="loaded roots",
    layout="solve-load",
    command="solve --eps 4",
    axes={
        "expansion": LoadAxis,
        "ratio": RatioAxis,
        "condition": condition_axis,
        "root": RootAxis,
        "column": ColumnAxis,
    },
    axis_keys=("epsilon", "ratio", "condition", "phi"),
    quantities=engine_registry,
    number=_number,
    caption=_caption,
    notes=_notes,
    of=(Of.CRANK, Of.ANGLE),
    exists=exists,
    letters=True,
    listed=tuple,
)
