"""The page of the power: the mean pressure, the power, the sizes that it asks for, and the steam taken."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

from kurbel.drive.at import known
from kurbel.drive.load import COMPRESSOR
from kurbel.engine.captions import DRIVEN
from kurbel.engine.digits import FLOAT_ERROR, supported
from kurbel.engine.engine import Engine
from kurbel.engine.engine_page import LoadAxis
from kurbel.engine.loads.words import LoadWords, best_back, valve_lines, words_of
from kurbel.engine.power.duty import (
    BORE,
    EFFICIENCY,
    FACTOR,
    POWER,
    PRESSURE,
    THERMAL,
    Duty,
    Results,
    lacking,
    option_of,
    solved,
)
from kurbel.engine.power.power_quantities import Needs, registry
from kurbel.engine.power.source import ActingPressure, Compound, GivenPressure, whole
from kurbel.engine.power.unknown import UNKNOWNS
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, Number, figure
from kurbel.exact.real import Product, Term
from kurbel.page.axes import ColumnAxis, Place
from kurbel.page.quantity import Column, Quantity, Texts, words
from kurbel.page.subject import LEAVE_OUT, Question, Subject
from kurbel.reading.amounts import amount
from kurbel.reading.units import MassFlow

OF_STEAM = Texts("engine.loads", "of_steam")
COUNTED_IN = Texts("engine", "counted_in")
POWER_TEXTS = Texts("engine", "power_texts")

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
    lines=lambda loads, engine, lang: iter(()),
    tag=lambda source: "given",
)
_EFFICIENCIES = {EFFICIENCY: "mechanical", THERMAL: "thermal"}
# What the relation of the power is made of.
POWERED = ("indicated_power", "brake_power", "bore", "stroke", "speed", "mean_torque")


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class PowerRequest(Question):
    """What is asked for: the power of what acts on a piston, each of the `sources`, as far as `duty` tells
    it, or the sizes that it needs."""

    sources: Sequence[ActingPressure | GivenPressure]
    duty: Duty

    no_column = "there is no column beside the axes; add one, such as mean_pressure"
    advice = LEAVE_OUT

    def check(self) -> None:
        ends = self.duty.ends
        strokes = [one.strokes for one in self.sources]
        given = all(isinstance(one, GivenPressure) for one in self.sources)
        if len(ends) > 1 and not all(one == 2 or (one == 1 and given) for one in strokes):
            raise ProblemError(
                "two mean pressures are those of both ends of a double-acting piston; add --working-strokes"
                " 2, or 1 where it works in four strokes"
            )
        rods = self.duty.piston_rod is not None or self.duty.tail_rod is not None
        if rods and len(ends) < 2 and any(one != 2 for one in strokes):
            raise ProblemError(
                "--piston-rod and --tail-rod lessen the area of an end of a double-acting piston; leave them"
                " out"
            )
        if self.duty.factor_asked:
            self._check_factor()
        if self.duty.compound is not None:
            self._check_compound(self.duty.compound)
        self._check_shares()
        found = self.found(0).variables
        # A volume that is given needs neither the bore nor the stroke.
        loose = (PRESSURE, BORE) if self.duty.swept_volume is not None else (PRESSURE,)
        touched = [one for name, one in found.items() if name not in loose and set(one.powers) != {name}]
        asked = [found[POWER]] if found[POWER].powers else touched
        free = lacking(self.duty, *asked)
        if unknown := found.get(self.duty.unknown):
            asked, free = [unknown], lacking(self.duty, unknown)
        sought = self.sources[0].sought is not None
        if free == ["--efficiency"] and self.duty.brake_power is not None:
            raise ProblemError(
                "--brake-power is that at the shaft, of which the indicated power follows by the mechanical"
                " efficiency; add --efficiency, or give the indicated power as --power"
            )
        if free and self.duty.sized and not sought and not self.columns:
            raise ProblemError(
                f"this does not tell the power, or the sizes for it; add {' and '.join(free)}"
                f"{_instead(free, self.duty)}"
            )

    def _check_shares(self) -> None:
        """Raise ProblemError for an efficiency that follows and is above 1, or fuel of a driven machine."""
        if self.duty.burnt and self.driven:
            raise ProblemError(
                f"{option_of(self.duty, self.duty.burnt[0])} is of an engine, and here the shaft drives the"
                " piston; leave it out"
            )
        for index in range(len(self.sources)):
            found = self.found(index).variables
            for name in (EFFICIENCY, THERMAL):
                share = found.get(name)
                if share and not share.powers and share.known.exceeds(Product.of(1)):
                    raise ProblemError(
                        f"what is given makes a {_EFFICIENCIES[name]} efficiency of {float(share.known):.5g};"
                        " it is at most 1"
                    )

    def _check_compound(self, compound: Compound) -> None:
        """Raise ProblemError where the high-pressure cylinder would not be the smaller one."""
        for index, source in enumerate(self.sources):
            assert isinstance(source, ActingPressure)
            compound.check(source.load)
            own, all_ = self.found(index).expanded(), whole(source)
            if own.powers or (own.known.exceeds(Product.of(1)) and all_.exceeds(own.known)):
                continue
            raise ProblemError(
                f"the steam would expand {float(own.known):.5g} times in the high-pressure cylinder, and"
                f" {float(all_):.5g} times in all; it must be above 1 and below that, for the low-pressure"
                " cylinder is the larger one"
            )

    def _check_factor(self) -> None:
        """Raise ProblemError where the diagram factor does not follow, or would be above 1."""
        for index, source in enumerate(self.sources):
            if not isinstance(source, ActingPressure) or not source.steamed:
                raise ProblemError("--unknown diagram_factor is that of the ideal card of steam; add --eps")
            found = self.found(index).variables
            factor, free = found[FACTOR].known, [name for name, one in found.items() if one.powers]
            if found[FACTOR].powers and (missing := [option_of(self.duty, one) for one in free[:-1]]):
                raise ProblemError(
                    "the diagram factor is found from power, bore, stroke, speed and pressure, or from"
                    f" --mean-pressure and pressure; add {' and '.join(missing)}"
                )
            if factor.exceeds(Product.of(1)):
                if self.duty.ends:
                    raise ProblemError(
                        f"the mean pressure that is given is {float(factor):.5g} times that of the ideal"
                        " card; the diagram factor is at most 1"
                    )
                power = float(found[POWER].known) / 1000
                raise ProblemError(
                    f"the ideal card makes an indicated power of {power / float(factor):.5g} kW, less than"
                    f" the {power:.5g} kW that are given; the diagram factor is at most 1"
                )

    @property
    def steams(self) -> list[Any]:
        """What acts on the pistons, for the words about it."""
        return [one.load if isinstance(one, ActingPressure) else one for one in self.sources]

    @property
    def first(self) -> Engine:
        """The engine that the words are about."""
        source = self.sources[0]
        assert isinstance(source, ActingPressure)
        return source.engine

    @cached_property
    def words(self) -> LoadWords:
        source = self.sources[0]
        return words_of(source.name) if isinstance(source, ActingPressure) else GIVEN_WORDS

    @cached_property
    def driven(self) -> bool:
        return self.sources[0].driven

    @cached_property
    def found(self) -> Callable[[int], Results]:
        """Return what is found of a source, by its index."""
        return lru_cache(None)(self._found)

    def _found(self, index: int) -> Results:
        source = self.sources[index]
        return Results(self.duty, source, solved(self.duty, source))

    @property
    def axis_keys(self) -> tuple[str, ...]:
        return (self.words.key,)

    @property
    def acting(self) -> ActingPressure | None:
        """What acts on the piston, where its pressure is not given."""
        source = self.sources[0]
        return source if isinstance(source, ActingPressure) else None

    @property
    def machine(self) -> Any:
        """The load."""
        return self.acting and self.acting.load

    @property
    def compressor(self) -> Any:
        return self.machine if self.machine is not None and self.machine.name == COMPRESSOR else None

    def missing(self, quantity: Quantity) -> str:
        if said := super().missing(quantity):
            return said
        if Needs.STEAM in quantity.needs and self.duty.specific_volume is None:
            return self.needing(quantity, ["--specific-volume"])
        return self.needing(quantity, lacking(self.duty, quantity.formulas["exact"].kernel(self.found(0))))


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
    apart = source.apart(term.known) if isinstance(source := found.source, ActingPressure) else 0.0
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
    machine = (DRIVEN if driven else request.words.machine)[request.lang]
    return request.layout.caption[request.lang].replace("{machine}", machine)


def notes(request: PowerRequest) -> Iterator[Label]:
    """Yield the lines below the table."""
    lang, duty, source = request.lang, request.duty, request.sources[0]
    shown = {column.key for column in request.page_columns}
    if isinstance(source, ActingPressure) and "relative_pressure" in shown:
        yield f"$p$ {COUNTED_IN[source.name][lang]}"
    if given := ", ".join(_given(duty, source)):
        yield POWER_TEXTS["given"][lang].format(given=given)
    if len(duty.ends) > 1:
        cover, crank = (amount(one, "bar") for one in duty.ends)
        yield POWER_TEXTS["ends"][lang].format(cover=cover, crank=crank)
    if not shown.isdisjoint(POWERED):
        strokes = figure(source.strokes)
        area = "".join(_area(duty))
        yield POWER_TEXTS["power"][lang].format(cylinders=duty.cylinders, strokes=strokes, area=area)
    if duty.factor_asked:
        yield POWER_TEXTS["factor_found"][lang]
    if source.sought is not None:
        about = UNKNOWNS[duty.unknown]
        yield POWER_TEXTS["sought"][lang].format(symbol=about.symbol, bounds=about.bounds[lang])
    if duty.compound is not None:
        yield POWER_TEXTS["compound"][lang]
    if duty.diagram_factor != 1:
        yield POWER_TEXTS["factor"][lang].format(factor=figure(duty.diagram_factor))
    if duty.efficiency is not None:
        said = "efficiency_supplied" if request.driven else "efficiency"
        yield POWER_TEXTS[said][lang].format(efficiency=figure(duty.efficiency))
    elif "efficiency" in shown:
        yield POWER_TEXTS["efficiency_found"][lang]
    if "consumption" in shown and len(duty.burnt) > 1:
        yield POWER_TEXTS["burnt_at_shaft" if duty.shafted else "burnt"][lang]
    if not shown.isdisjoint(("air_mass", "work_per_mass")) or isinstance(duty.delivery, MassFlow):
        yield POWER_TEXTS["air"][lang]
    if not isinstance(source, ActingPressure):
        return
    if duty.specific_volume is not None and not shown.isdisjoint(("steam", "steam_per_kwh")):
        yield _steam_taken(source, duty, lang)
    if source.name == COMPRESSOR:
        yield from _air_lines(source, duty, shown, lang)
    if source.steamed:
        lines = [*_steam_lines(source, lang)]
    elif source.carded:
        lines = [POWER_TEXTS["card"][lang]]
    else:
        lines = [*request.words.lines(request.steams, request.first, lang)]
    if request.words.halved:
        lines.append(OF_STEAM["double" if request.first.double else "single"][lang])
    if source.steamed and duty.diagram_factor == 1 and not duty.factor_asked:
        lines.append(POWER_TEXTS["ideal"][lang])
    yield "; ".join(lines)
    if request.driven:
        yield POWER_TEXTS["supplied"][lang]


def _air_lines(source: ActingPressure, duty: Duty, shown: set[str], lang: str) -> Iterator[Label]:
    if duty.suction_temperature is not None:
        yield POWER_TEXTS["warm"][lang].format(temperature=figure(duty.suction_temperature))
    if duty.free_air is not None:
        pressure, temperature = duty.free_air
        yield POWER_TEXTS["free"][lang].format(
            pressure=amount(pressure, "bar"), temperature=figure(temperature)
        )
    if (stages := source.load.stages) > 1:
        load = source.load
        best = "stages" if load.cooled == 1 and load.between is None else "given_stages"
        said = [best, *(["further_stages"] if stages > 2 else [])]
        kelvin = load.cooled * (duty.suction_temperature or 1)
        cooled = POWER_TEXTS["as_sucked"][lang] if load.cooled == 1 else f'${figure(kelvin)} "K"$'
        pressed = POWER_TEXTS["as_perfect"][lang] if load.between is None else ""
        room = POWER_TEXTS["own_room"][lang] if load.later_clearance is None else ""
        yield "; ".join(
            POWER_TEXTS[key][lang].format(stages=stages, cooled=cooled, pressed=pressed, room=room)
            for key in said
        )
        if load.later_clearance is not None:
            yield POWER_TEXTS["second_room"][lang].format(share=figure(load.later_clearance))
    if not shown.isdisjoint(("compression_heat", "cooler_heat")):
        yield POWER_TEXTS["heats"][lang]
    if not shown.isdisjoint(("isothermal_power", "isothermal_efficiency", "adiabatic_efficiency")):
        yield POWER_TEXTS["ideal_air"][lang]


def _given(duty: Duty, source: ActingPressure | GivenPressure) -> Iterator[Label]:
    """Yield what is given as it stands in formulas, but for what the table has."""
    if duty.pressure is not None and not isinstance(source, GivenPressure):
        yield f"$p = {amount(duty.pressure, 'bar')}$"
    if duty.stroke_bore is not None:
        yield f"$S/d = {figure(duty.stroke_bore)}$"
    if duty.swept_volume is not None:
        yield f"$V_h = {amount(duty.swept_volume, 'l')}$"
    if isinstance(duty.delivery, MassFlow):
        yield f'$"ṁ" = {amount(duty.delivery.mass, "kg/min")}$'
    elif duty.delivery is not None:
        yield f"$V = {amount(duty.delivery, 'm³/min')}$"
    if duty.speed is not None and not duty.speed.turns:
        yield f'$ω = {figure(duty.speed.value)} "rad/s"$'


def _area(duty: Duty) -> Iterator[str]:
    """Yield the mean area of both ends, less half of that of each rod."""
    rods = [rod for rod in (duty.piston_rod, duty.tail_rod) if rod is not None]
    if not rods:
        yield "π/4 d^2"
        return
    taken = " - ".join(f"1/2 ({amount(rod, 'mm')})^2" for rod in rods)
    yield f"π/4 (d^2 - {taken})"


def _steam_taken(source: ActingPressure, duty: Duty, lang: str) -> Label:
    steam, volume = source.load, known(duty.specific_volume)
    kept = "p_b/p" if steam.exponent == 1 else f"(p_b/p)^(1/{figure(steam.exponent)})"
    taken = f"$[1/ε + κ (1 - {kept})]$" if steam.clearance else "$1/ε$"
    if steam.cushion != 1:
        taken = f"$[1/ε + κ - (1 - {figure(steam.cushion)} + κ) {kept}]$"
    said = POWER_TEXTS["steam"][lang].format(volume=taken, specific=amount(volume, "m³/kg"))
    return said + (POWER_TEXTS["kept"][lang] if steam.clearance else "")


def _steam_lines(source: ActingPressure, lang: str) -> Iterator[Label]:
    steam = source.load
    if steam.expansion == 1:
        yield OF_STEAM["uncut"][lang]
    elif steam.exponent == 1:
        yield OF_STEAM["mariotte"][lang]
    else:
        yield OF_STEAM["polytropic"][lang].format(exponent=figure(steam.exponent))
    if steam.clearance:
        yield POWER_TEXTS["clearance"][lang].format(clearance=figure(steam.clearance))
    elif steam.expansion != 1:
        yield OF_STEAM["unclear"][lang]
    if steam.back is None:
        yield best_back(steam, "p_b", "p", lang)
    else:
        yield POWER_TEXTS["back"][lang].format(back=figure(steam.back))
    yield from valve_lines(steam, lang)


SUBJECT = Subject(
    key="power",
    layout="power",
    command="power",
    axes={"expansion": LoadAxis, "column": _Columns},
    axis_keys=("epsilon",),
    quantities=registry,
    number=_number,
    caption=_caption,
    notes=notes,
    letters=True,
)
