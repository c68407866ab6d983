"""The page of the power: the mean pressure, the power, the sizes that it asks for, and the steam taken."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

from kurbel.engine.axes import LoadAxis, LoadWords, words_of
from kurbel.engine.digits import FLOAT_ERROR, supported
from kurbel.engine.engine import Engine
from kurbel.engine.power import notes
from kurbel.engine.power.duty import FACTOR as DIAGRAM_FACTOR
from kurbel.engine.power.duty import POWER, PRESSURE, Duty, lacking, option_of, solved
from kurbel.engine.power.quantities import (
    ASKED,
    EFFICIENT,
    FACTOR,
    GIVES,
    STEAMED,
    UNITLESS,
    Found,
    registry,
)
from kurbel.engine.power.relation import Term
from kurbel.engine.power.source import Acting, GivenPressure
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, Number
from kurbel.exact.product import Product
from kurbel.page.axes import ColumnAxis, Place
from kurbel.page.quantity import Column, Quantity, words
from kurbel.page.subject import Question, Subject

GIVEN_WORDS = LoadWords(
    key="load",
    name=words("mittlerer Druck|Mean pressure"),
    symbol="",
    number=lambda source: None,
    label=lambda source, lang: words("gegeben|given")[lang],
    machine=words("der Maschine|of the engine"),
    several="mean pressures",
    forces=words(""),
    newtons=lambda source, load: "",
    lines=lambda request, lang: iter(()),
    tag=lambda source: "given",
)


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class PowerRequest(Question):
    """What is asked for: the power of what acts on a piston, each of the `sources`, as far as `duty` tells
    it, or the sizes that it needs."""

    sources: Sequence[Acting | GivenPressure]
    duty: Duty

    no_column = "there is no column beside the axes; add one, such as mean_pressure"

    def check(self) -> None:
        if len(self.duty.ends) > 1 and any(one.strokes != 2 for one in self.sources):
            raise ProblemError(
                "two mean pressures are those of both ends of a double-acting piston; add --working-strokes 2"
            )
        if self.duty.open_area != 1 and any(one.strokes != 2 for one in self.sources):
            raise ProblemError(
                "--piston-rod and --tail-rod lessen the area of an end of a double-acting piston; leave them"
                " out"
            )
        if self.duty.factor_asked:
            self._check_factor()
        found = self.found(0).variables
        touched = [one for name, one in found.items() if name != PRESSURE and set(one.powers) != {name}]
        asked = [found[POWER]] if found[POWER].powers else touched
        free = lacking(self.duty, *asked)
        if free and self.duty.sized and not self.columns:
            raise ProblemError(
                f"this does not tell the power, or the sizes for it; add {' and '.join(free)}"
                f"{_instead(free, self.duty)}"
            )

    def _check_factor(self) -> None:
        """Raise ProblemError where the diagram factor does not follow, or would be above 1."""
        for index, source in enumerate(self.sources):
            if not isinstance(source, Acting) or not source.steamed:
                raise ProblemError("--diagram-factor ? is that of the ideal card of steam; add --eps")
            found = self.found(index).variables
            missing = [option_of(self.duty, name) for name, one in found.items() if one.powers]
            if missing := [option for option in missing if option != "--diagram-factor"]:
                raise ProblemError(
                    "the diagram factor is found from power, bore, stroke, speed and pressure; add"
                    f" {' and '.join(missing)}"
                )
            factor = found[DIAGRAM_FACTOR].known
            if factor.exceeds(Product.of(1)):
                power = float(found[POWER].known) / 1000
                raise ProblemError(
                    f"the ideal card makes an indicated power of {power / float(factor):.5g} kW, less than"
                    f" the {power:.5g} kW that are given; the diagram factor is at most 1"
                )

    @property
    def steams(self) -> list[Any]:
        """What acts on the pistons, for the words about it."""
        return [one.load if isinstance(one, Acting) else one for one in self.sources]

    @property
    def first(self) -> Engine:
        """The engine that the words are about."""
        source = self.sources[0]
        assert isinstance(source, Acting)
        return source.engine

    @property
    def double(self) -> bool:
        return self.first.double

    @cached_property
    def words(self) -> LoadWords:
        source = self.sources[0]
        return words_of(source.name) if isinstance(source, Acting) else GIVEN_WORDS

    @cached_property
    def driven(self) -> bool:
        return self.sources[0].driven

    @cached_property
    def found(self) -> Any:
        """Return what is found of a source, by its index."""
        return lru_cache(None)(self._found)

    def _found(self, index: int) -> Found:
        source = self.sources[index]
        return Found(self.duty, source, solved(self.duty, source))

    @property
    def axis_keys(self) -> tuple[str, ...]:
        return (self.words.key,)

    def missing(self, quantity: Quantity) -> str:
        source, duty = self.sources[0], self.duty
        acting = source if isinstance(source, Acting) else None
        lacks = {
            STEAMED: ("steam with --eps", acting is None or not acting.steamed),
            GIVES: ("a compressor or a pump", acting is None or not hasattr(acting.load, "delivered")),
            EFFICIENT: ("the mechanical efficiency, --efficiency", duty.efficiency is None),
            FACTOR: ("--diagram-factor", duty.diagram_factor == 1 and not duty.factor_asked),
            ASKED: ("--diagram-factor ?", not duty.factor_asked),
            UNITLESS: ("what acts on the piston", acting is None),
        }
        needed = [lacks[one][0] for one in quantity.needs.split() if lacks[one][1]]
        if STEAMED in quantity.needs and not needed and duty.specific_volume is None:
            needed = ["--specific-volume"]
        if not needed:
            needed = lacking(duty, quantity.formulas["exact"].kernel(self.found(0)))
        return f"column {quantity.key} needs {' and '.join(needed)}; leave it out, or give that" * bool(
            needed
        )


def _instead(free: Sequence[str], duty: Duty) -> str:
    """Return what may stand in the place of options that are missing."""
    given = {"--stroke": duty.stroke_bore, "--speed": duty.piston_speed}
    options = {"--stroke": "--stroke-bore", "--speed": "--piston-speed"}
    ways = [options[one] for one in free if one in given and given[one] is None]
    return f", or in place of one {' or '.join(ways)}" if ways else ""


def _number(request: PowerRequest, column: Column, place: Place, times: int) -> Number | None:
    """The printed number at a place, of a card as far as its points tell it."""
    found = request.found(place["expansion"])
    term: Term = column.quantity.formulas["exact"].kernel(found)
    apart = found.source.apart(term.known) if found.source.carded else 0.0
    if not apart:
        return term.known.number(column.decimals, request.rounding, times)
    best = times * float(term.known)
    return supported(
        best, apart * abs(best) + FLOAT_ERROR * (abs(best) + 1), column.decimals, request.rounding
    )


class _Columns(ColumnAxis):
    """The quantities, headed by what is across."""

    def __init__(self, request: PowerRequest) -> None:
        super().__init__(request)
        self.said = " ".join(filter(None, (request.words.name[request.lang], request.words.symbol)))

    def stub_heading(self) -> Label:
        return self.said


def _caption(request: PowerRequest) -> Label:
    driven = request.driven and request.sources[0].carded
    machine = (notes.DRIVEN if driven else request.words.machine)[request.lang]
    return request.layout.caption[request.lang].replace("{machine}", machine)


SUBJECT = Subject(
    key="power",
    layout="power",
    command="power",
    axes={"expansion": LoadAxis, "column": _Columns},
    axis_keys=("epsilon",),
    quantities=registry,
    number=_number,
    caption=_caption,
    notes=notes.notes,
    letters=True,
)
