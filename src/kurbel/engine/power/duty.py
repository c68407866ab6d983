"""Power, bore, stroke, speed and pressure: those that are given make the others known.

In their relations powers of variables are multiplied; each known one makes another known. A quantity is a
product of them, of what else is given and of what acts on the piston.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from typing import NamedTuple

from kurbel.drive.at import known
from kurbel.engine.power.source import ActingPressure, Compound, GivenPressure, whole, work_of
from kurbel.errors import ProblemError
from kurbel.exact.real import Product, Term, number, variable
from kurbel.reading.notation import about, check_bounds
from kurbel.reading.units import MassFlow, Speed

POWER, BORE, STROKE, SPEED, PRESSURE, FACTOR, EFFICIENCY, CONSUMED, HEAT, THERMAL = VARIABLES = (
    *("power", "bore", "stroke", "speed", "pressure", "diagram_factor"),
    *("efficiency", "consumption", "heating_value", "thermal_efficiency"),
)
# What the power is made of.
MADE = VARIABLES[:6]
# What units of pages, in which they are no SI units, are of those.
SIZES = {
    **{"bar": Fraction(10**5), "kW": Fraction(1000), "mm": Fraction(1, 1000), "l": Fraction(1, 1000)},
    **{"kg/h": Fraction(1, 3600), "kg/min": Fraction(1, 60), "m³/min": Fraction(1, 60)},
    **{'$"min"^(-1)$': Fraction(1, 60), "kg/kWh": Fraction(1, 3600 * 1000), "kJ/kg": Fraction(1000)},
}
MOST_CYLINDERS = 24
# Of air, in J/(kg K), as most textbooks have it.
GAS_CONSTANT = 287
HALF = Fraction(1, 2)
# What a load has of its own, open as long as a number of it is sought, and its pressure then.
MEAN, DELIVERED, OPEN_PRESSURE = "mean", "delivered", "open pressure"


@dataclass(frozen=True, kw_only=True)
class Duty:
    """What is given beside that which acts on the piston; None is not.

    `power` is the indicated one in watts; `brake_power` that at the shaft, which with the mechanical
    efficiency η is η times the indicated one, of a driven machine the indicated one by η; `brake_torque` in
    N m has it by the speed. `diagram_factor` multiplies the mean pressure. `unknown` is what is asked for:
    the diagram factor, another of the variables, or a number of the load. `pressure` is what mean pressures
    count in, and `pressure_option` gives it. `specific_volume` in m³/kg is that of the steam at admission.
    The rods by their diameters in metres lessen the area of one end each, of a double-acting piston whose
    bore is given. Mean pressures that are given are `ends`: of all, or of the ends at the cover and at the
    crank. `delivery` is that of all cylinders in m³/s, in the state of suction, or if that is given, of free
    air, by its pressure in Pa and its temperature in K, or its mass. `consumption` of fuel or steam is in
    kg/s, or per joule at the shaft, where anything of that is given, else per joule indicated; of its
    `heating_value` in J/kg `thermal_efficiency` is the share that becomes that work. Of a `compound` engine
    the bore is that of the low-pressure cylinder.
    """

    power: Fraction | None = None
    brake_power: Fraction | None = None
    bore: Fraction | None = None
    stroke: Fraction | None = None
    speed: Speed | None = None
    pressure: Fraction | None = None
    pressure_option: str = "--pressure"
    stroke_bore: Fraction | None = None
    piston_speed: Fraction | None = None
    swept_volume: Fraction | None = None
    diagram_factor: Fraction = Fraction(1)
    unknown: str = ""
    delivery: Fraction | MassFlow | None = None
    suction_temperature: Fraction | None = None
    free_air: tuple[Fraction, Fraction] | None = None
    efficiency: Fraction | None = None
    brake_torque: Fraction | None = None
    consumption: MassFlow | None = None
    heating_value: Fraction | None = None
    thermal_efficiency: Fraction | None = None
    specific_volume: Fraction | None = None
    cylinders: int = 1
    piston_rod: Fraction | None = None
    tail_rod: Fraction | None = None
    ends: tuple[Fraction, ...] = ()
    compound: Compound | None = None

    def __post_init__(self) -> None:
        if not 1 <= self.cylinders <= MOST_CYLINDERS:
            raise ProblemError(
                f"the engine has {self.cylinders} cylinders; 1 to {MOST_CYLINDERS} are allowed"
            )
        shares = ("diagram_factor", "efficiency", "thermal_efficiency")
        for what, share in ((name.replace("_", " "), getattr(self, name)) for name in shares):
            check_bounds(f"the {what}", share, "be above 0 and at most 1")
        for what, size in (("bore", self.bore), ("stroke", self.stroke)):
            check_bounds(f"the {what}", size, "be above 0", " m")
        for what, value in (("stroke over bore", self.stroke_bore), ("piston speed", self.piston_speed)):
            check_bounds(f"the {what}", value, "be above 0 and at most 1000")
        self._check_rods()
        self._check_states()

    def _check_rods(self) -> None:
        for what, rod in (("piston rod", self.piston_rod), ("tail rod", self.tail_rod)):
            if rod is None:
                continue
            if self.bore is None and self.stroke_bore is not None:
                raise ProblemError(
                    f"the {what} lessens the area of a piston whose size is known; add --bore, or --stroke in"
                    " the place of --stroke-bore"
                )
            if self.bore is not None and not 0 < rod < self.bore:
                raise ProblemError(
                    f"the {what} is {about(1000 * rod)} mm; it must be above 0 and below the bore,"
                    f" {about(1000 * self.bore)} mm"
                )

    def _check_states(self) -> None:
        if self.burnt in ([HEAT], [THERMAL]):
            other = "--thermal-efficiency" if self.heating_value else "--heating-value"
            raise ProblemError(
                f"{option_of(self, self.burnt[0])} goes with what is consumed; add --consumption, or {other}"
            )
        if isinstance(self.delivery, MassFlow) and (
            self.pressure is None or self.suction_temperature is None
        ):
            missing = "--suction-pressure" if self.pressure is None else "--suction-temperature"
            raise ProblemError(f"the volume of a mass of air follows by its state; add {missing}")

    @property
    def factor_asked(self) -> bool:
        """Whether the diagram factor is to be found."""
        return self.unknown == FACTOR

    def _of_ends(self) -> Fraction | None:
        """Return the mean of the pressures given, by the areas of the ends."""
        if len(self.ends) < 2 or self.bore is None:
            return sum(self.ends, Fraction(0)) / len(self.ends) if self.ends else None
        areas = [self.bore**2 - (rod or 0) ** 2 for rod in (self.tail_rod, self.piston_rod)]
        return sum((one * area for one, area in zip(self.ends, areas, strict=True)), Fraction(0)) / sum(areas)

    @property
    def open_area(self) -> Fraction:
        """The mean area of both ends of the piston in that of the bore."""
        return 1 - self._rods / 2 / self.bore**2 if self.bore is not None else Fraction(1)

    @property
    def _rods(self) -> Fraction:
        """The squares of the rods' diameters."""
        return sum((rod**2 for rod in (self.piston_rod, self.tail_rod) if rod is not None), Fraction(0))

    @property
    def braked(self) -> bool:
        """Whether anything of the power at the shaft is given, so that the efficiency tells the other one."""
        return self.brake_power is not None or self.brake_torque is not None

    @property
    def shafted(self) -> bool:
        """Whether the power at the shaft is another one than the indicated."""
        return self.braked or self.efficiency is not None

    @property
    def burnt(self) -> list[str]:
        """What is given of the fuel, or of the heat of the steam."""
        return [name for name in (CONSUMED, HEAT, THERMAL) if getattr(self, name) is not None]

    def whole_bore(self, bore: Term) -> Term:
        """Return the bore of a piston whose mean area is that of another bore without rods."""
        if self.bore is not None or not self._rods or bore.powers:
            return bore
        return Term((bore.known ** Fraction(2)).plus(Product.of(self._rods / 2)) ** HALF)

    @property
    def sized(self) -> bool:
        """Whether anything of the power, the sizes or the speed is given."""
        sizes = ("bore", "stroke", "speed", "stroke_bore", "piston_speed", "swept_volume")
        names = ("power", "brake_power", "brake_torque", *sizes, "delivery")
        return any(getattr(self, name) is not None for name in names)

    def given(self, source: ActingPressure | GivenPressure) -> dict[str, Term]:
        """Return what is given, by the names of variables."""
        found = {
            name: getattr(self, name) for name in (POWER, BORE, STROKE, PRESSURE, EFFICIENCY, HEAT, THERMAL)
        }
        if self.consumption is not None and not self.consumption.of_work:
            found[CONSUMED] = self.consumption.mass
        own = self._of_ends() if isinstance(source, GivenPressure) else source.pressure
        found[PRESSURE] = own or found[PRESSURE]
        known = {name: number(value) for name, value in found.items() if value is not None}
        if source.sought is not None and source.sought.over is not None:
            known[PRESSURE] = number(source.sought.over) / Term(Product.about(source.sought.number))
        if not self.factor_asked:
            known[FACTOR] = number(self.diagram_factor)
        if self._brake_tells:
            known[POWER] = number(self.brake_power or 1) / Results(self, source, known).brake()
        if self.speed is not None:
            turns = number(self.speed.value)
            known[SPEED] = turns if self.speed.turns else turns / number(2, pi=1)
        return known

    def freed(self) -> Term:
        """Return what times a volume in the state of suction is that of free air, 1 where none is given."""
        if self.free_air is None or self.pressure is None or self.suction_temperature is None:
            return number(1)
        pressure, temperature = self.free_air
        return number(self.pressure * temperature / (pressure * self.suction_temperature))

    def mass_of_air(self) -> Term:
        """Return the mass in kg of a cubic metre in the state of suction."""
        assert self.pressure is not None and self.suction_temperature is not None
        return number(self.pressure / (GAS_CONSTANT * self.suction_temperature))

    @property
    def _brake_tells(self) -> bool:
        """Whether the power at the shaft tells the indicated one at once."""
        return self.brake_power is not None and self.efficiency is not None and self.power is None


class Relation(NamedTuple):
    """What variables make, how much it must be, None where nothing says so, and the variable that it tells
    first; sentences count it in a unit."""

    made: Term
    given: Term | Fraction | None
    told: str
    unit: str = ""

    def needed(self) -> Term:
        """Return how much it must be."""
        return self.given if isinstance(self.given, Term) else number(known(self.given))


def relations(of: Results) -> Mapping[str, Relation]:
    """Return what holds between the variables, none of which the results know, by options for sentences.

    N = z k p_i A S n, A the mean area of both ends, with k working strokes of a cylinder in a turn;
    S = (S/d) d; c_m = 2 S n; V = z k v A S n, v the share of the swept volume that a stroke delivers.
    """
    duty, acting = of.duty, isinstance(of.source, ActingPressure)
    delivery, consumed = duty.delivery if acting else None, duty.consumption
    found = {
        "--stroke-bore": Relation(of.of(STROKE) / of.of(BORE), duty.stroke_bore, STROKE),
        "--piston-speed": Relation(of.piston_speed(), duty.piston_speed, SPEED, "m/s"),
        "--swept-volume": Relation(of.swept(), duty.swept_volume, BORE, "l"),
    }
    if acting:
        found["--mean-pressure"] = Relation(of.pressure(), duty._of_ends(), FACTOR, "bar")
    if isinstance(delivery, MassFlow):
        air = of.delivery() * duty.mass_of_air()
        found["--delivery"] = Relation(air, delivery.mass, BORE, "kg/min")
    elif delivery is not None:
        free = of.delivery() * duty.freed()
        found["--delivery"] = Relation(free, delivery, BORE, "m³/min")
    whole, brake = of.pressure() * of.swept() * of.rate(), of.of(POWER) * of.brake()
    braked = None if duty._brake_tells else duty.brake_power
    found["--power"] = Relation(whole, of.of(POWER), POWER, "kW")
    found["--brake-power"] = Relation(brake, braked, POWER, "kW")
    found["--brake-torque"] = Relation(of.torque(), duty.brake_torque, SPEED, "N m")
    if consumed is not None and consumed.of_work:
        found["--consumption"] = Relation(of.worked() * number(consumed.mass), of.of(CONSUMED), CONSUMED)
    if len(duty.burnt) > 1:
        share = of.worked() / (of.of(CONSUMED) * of.of(HEAT))
        found["--thermal-efficiency"] = Relation(share, of.of(THERMAL), THERMAL)
    return {option: one for option, one in found.items() if one.given is not None}


def solved(duty: Duty, source: ActingPressure | GivenPressure) -> Mapping[str, Term]:
    """Return the variables, each in terms of what is given and of those that are not known.

    Raises ProblemError where what is given contradicts itself.
    """
    return _eliminated(duty, source)[0]


def equation(duty: Duty, source: ActingPressure, opened_pressure: bool) -> tuple[Term | None, list[str]]:
    """Return what must be 1 for a number of the load that is sought: a product of what the load makes of it,
    and of its pressure where that is `opened_pressure`; None where too little is given, with the options that
    are missing."""
    found, left = _eliminated(duty, source, opened=True, open_pressure=opened_pressure)
    return left[0] if left else None, [option_of(duty, name) for name, one in found.items() if one.powers]


def _eliminated(
    duty: Duty, source: ActingPressure | GivenPressure, opened: bool = False, open_pressure: bool = False
) -> tuple[Mapping[str, Term], list[Term]]:
    """Return the variables, and of what the load makes the relations that are left."""
    found, left = duty.given(source), []
    if open_pressure:
        found[PRESSURE] = variable(OPEN_PRESSURE)
    for option, relation in relations(Results(duty, source, {}, opened)).items():
        holds, needed = (
            reduce(lambda one, name: one.put(name, found[name]), found, term)
            for term in (relation.made / relation.needed(), relation.needed())
        )
        free = [name for name in (relation.told, *VARIABLES) if name in holds.powers]
        if not free:
            if holds.powers:
                left.append(holds)
            elif not holds.known.equals(Product.of(1)):
                raise ProblemError(_contradiction(option, relation, needed, float(holds.known), duty))
            continue
        value = holds.solved_for(free[0])
        found = {name: one.put(free[0], value) for name, one in found.items()} | {free[0]: value}
    return {name: found.get(name, variable(name)) for name in dict.fromkeys((*MADE, *found))}, left


def lacking(duty: Duty, *terms: Term) -> list[str]:
    """Return the options that would make all terms known, nothing where they are."""
    free = [name for name in VARIABLES if any(name in term.powers for term in terms)]
    return [option_of(duty, name) for name in free]


def option_of(duty: Duty, name: str) -> str:
    """Return the option that gives a variable."""
    return duty.pressure_option if name == PRESSURE else f"--{name.replace('_', '-')}"


_SAID = {"--power": "an indicated power", "--stroke-bore": "a stroke over bore"}


def _contradiction(option: str, relation: Relation, needed: Term, off: float, duty: Duty) -> str:
    """Return the sentence for a relation that does not hold, by so many times what is needed."""
    what = _SAID.get(option, f"a {option[2:].replace('-', ' ')}")
    value, unit = float(needed.known) / float(SIZES.get(relation.unit, 1)), f" {relation.unit}".rstrip()
    unknown = "ask for another by --unknown"
    if option == "--power":
        # Of steam, whose ideal card makes more.
        ideal = duty.pressure is not None and duty.pressure_option == "--pressure"
        if off > 1 and ideal and duty.diagram_factor == 1:
            unknown = "take --unknown diagram_factor"
        option = option if duty.brake_power is None else "--brake-power"
    return (
        f"what is given makes {what} of {value * off:.5g}{unit}, and {option} asks for"
        f" {value:.5g}{unit}; leave one of them out, or {unknown}"
    )


class Results(NamedTuple):
    """What is found of a source: the variables, in terms of what is given; what the load makes is `opened` as
    long as a number of it is sought."""

    duty: Duty
    source: ActingPressure | GivenPressure
    variables: Mapping[str, Term]
    opened: bool = False

    @property
    def acting(self) -> ActingPressure:
        assert isinstance(self.source, ActingPressure)
        return self.source

    def mean(self) -> Term:
        """Return the mean pressure in units of the pressure that Q is of."""
        return variable(MEAN) if self.opened else Term(self.source.mean)

    def rate(self) -> Term:
        """Return the working strokes of all cylinders in a second."""
        return self.of(SPEED) * number(self.source.strokes * self.duty.cylinders)

    def swept(self) -> Term:
        """Return the volume of a stroke in m³, the mean of both ends."""
        return number(self.duty.open_area / 4, pi=1) * self.of(BORE) ** Fraction(2) * self.of(STROKE)

    def piston_speed(self) -> Term:
        """Return the mean one in m/s."""
        return number(2) * self.of(STROKE) * self.of(SPEED)

    def pressure(self) -> Term:
        """Return the mean pressure in Pa."""
        return self.of(PRESSURE) * self.of(FACTOR) * self.mean()

    def brake(self) -> Term:
        """Return what times the indicated power is that at the shaft."""
        return self.of(EFFICIENCY) ** Fraction(-1 if self.source.driven else 1)

    def torque(self) -> Term:
        """Return the mean torque at the shaft in N m."""
        return self.of(POWER) * self.brake() / self.of(SPEED) / number(2, pi=1)

    def worked(self) -> Term:
        """Return the power in W that consumption counts in."""
        return self.of(POWER) * self.of_work()

    def of_work(self) -> Term:
        """Return what times the indicated power is that which consumption counts in."""
        return self.brake() if self.duty.shafted else number(1)

    def steam(self) -> Term:
        """Return the steam of a second in kg."""
        volume = known(self.duty.specific_volume)
        return Term(self.acting.steam_taken) * self.swept() * self.rate() / number(volume)

    def steam_of_work(self) -> Term:
        """Return the steam of a joule of indicated work in kg."""
        return self.steam() / self.of(POWER)

    def delivery(self) -> Term:
        """Return what is delivered in a second in m³, in the state of suction."""
        made = variable(DELIVERED) if self.opened else Term(self.acting.delivered)
        return made * self.swept() * self.rate()

    def of_load(self, name: str) -> Term:
        """Return what a compressor knows by a name."""
        return Term(self.acting.of_load(name))

    def in_work(self, name: str) -> Term:
        """Return a work that a compressor knows by a name, in the indicated one."""
        return self.of_load(name) / (self.mean() * self.of(FACTOR))

    def ideal(self, name: str) -> Term:
        """Return the power in W that takes so much of a stroke, in p₁ and the swept volume."""
        return self.of_load(name) * self.of(PRESSURE) * self.swept() * self.rate()

    def expanded(self) -> Term:
        """Return how many times the steam expands in the high-pressure cylinder."""
        return known(self.duty.compound).expansion(self.acting, self.of(PRESSURE), self.of(BORE))

    def filled(self) -> Term:
        """Return the high-pressure cylinder as a share of the low-pressure one."""
        return self.expanded() / Term(whole(self.acting))

    def shared(self, high: bool) -> Term:
        """Return the share of the high-pressure cylinder in the work, or of the other."""
        return work_of(self.duty.compound, self.acting, self.expanded(), high)

    def pressed(self, high: bool) -> Term:
        """Return the mean pressure in Pa of such a cylinder."""
        own = self.pressure() * self.shared(high)
        return own / self.filled() if high else own

    def sought(self) -> Term:
        """Return the number of the load that was asked for."""
        return Term(Product.about(known(self.acting.sought).number))

    def of(self, name: str) -> Term:
        """Return a variable in its SI unit, the speed in turns a second."""
        return self.variables.get(name, variable(name))
