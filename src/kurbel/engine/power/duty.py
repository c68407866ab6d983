"""Power, bore, stroke, speed and pressure: those that are given make the others known.

In their relations powers of variables are multiplied; each known one makes another known. A quantity is a
product of them, of what else is given and of what acts on the piston.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache, partial
from typing import NamedTuple

from kurbel.engine.power.source import Acting, GivenPressure
from kurbel.errors import ProblemError
from kurbel.exact.real import Product
from kurbel.page.quantity import Formula, Quantity, entry, with_symbol
from kurbel.reading.notation import about
from kurbel.reading.units import Speed

POWER, BORE, STROKE, SPEED, PRESSURE, FACTOR = VARIABLES = (
    *("power", "bore", "stroke", "speed", "pressure"),
    "diagram_factor",
)
# Their units on pages, in watts, metres, turns a second and pascals.
UNITS = {
    POWER: Fraction(1000),
    BORE: Fraction(1, 1000),
    STROKE: Fraction(1, 1000),
    SPEED: Fraction(1, 60),
    PRESSURE: Fraction(10**5),
}
MOST_CYLINDERS = 24
# What a quantity needs beside the variables in it.
STEAMED, GIVES, EFFICIENT, FACTORED, UNITLESS = "steam", "delivery", "efficiency", "factor", "share"
ASKED = "asked"


@dataclass(frozen=True, slots=True)
class Term:
    """A known number times powers of variables that are not known."""

    known: Product
    powers: Mapping[str, Fraction] = field(default_factory=dict)

    def __mul__(self, other: Term | int) -> Term:
        if isinstance(other, int):
            return Term(self.known * other, self.powers)
        names = dict.fromkeys((*self.powers, *other.powers))
        powers = {one: self.power(one) + other.power(one) for one in names}
        return Term(self.known * other.known, {one: power for one, power in powers.items() if power})

    def __truediv__(self, other: Term | int) -> Term:
        if isinstance(other, int):
            return Term(self.known / other, self.powers)
        return self * other ** Fraction(-1)

    def __pow__(self, exponent: Fraction) -> Term:
        return Term(self.known**exponent, {one: power * exponent for one, power in self.powers.items()})

    def power(self, name: str) -> Fraction:
        """Return the exponent of a variable."""
        return self.powers.get(name, Fraction(0))

    def solved_for(self, name: str) -> Term:
        """Return the variable with which this term is 1."""
        return self._without(name) ** (-1 / self.power(name))

    def put(self, name: str, value: Term) -> Term:
        """Return the term with a value in the place of a variable."""
        power = self.power(name)
        return self._without(name) * value**power if power else self

    def _without(self, name: str) -> Term:
        return Term(self.known, {one: power for one, power in self.powers.items() if one != name})


def number(value: Fraction | int, pi: int = 0) -> Term:
    """Return a rational number above 0 times a power of π."""
    return Term(Product.of(value, pi))


def variable(name: str) -> Term:
    """Return a variable that is not known."""
    return Term(Product.of(1), {name: Fraction(1)})


@dataclass(frozen=True, kw_only=True)
class Duty:
    """What is given beside that which acts on the piston; None is not.

    `power` is the indicated one in watts; `brake_power` that at the shaft, which with the mechanical
    efficiency η is η times the indicated one, of a driven machine the indicated one by η. `diagram_factor`
    multiplies the mean pressure; it is to be found if `factor_asked`. `pressure` is what mean pressures
    count in, and `pressure_option` gives it. `specific_volume` in m³/kg is that of the steam at admission.
    The rods by their diameters in metres lessen the area of one end each, of a double-acting piston whose
    bore is given. Mean pressures that are given are `ends`: of all, or of the ends at the cover and at the
    crank.
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
    diagram_factor: Fraction = Fraction(1)
    factor_asked: bool = False
    efficiency: Fraction | None = None
    specific_volume: Fraction | None = None
    cylinders: int = 1
    piston_rod: Fraction | None = None
    tail_rod: Fraction | None = None
    ends: tuple[Fraction, ...] = ()

    def __post_init__(self) -> None:
        if not 1 <= self.cylinders <= MOST_CYLINDERS:
            raise ProblemError(
                f"the engine has {self.cylinders} cylinders; 1 to {MOST_CYLINDERS} are allowed"
            )
        for what, share in (("diagram factor", self.diagram_factor), ("efficiency", self.efficiency)):
            if share is not None and not 0 < share <= 1:
                raise ProblemError(f"the {what} is {about(share)}; it must be above 0 and at most 1")
        for what, value in (("stroke over bore", self.stroke_bore), ("piston speed", self.piston_speed)):
            if value is not None and not 0 < value <= 1000:
                raise ProblemError(f"the {what} is {about(value)}; it must be above 0 and at most 1000")
        self._check_rods()
        if self.brake_power is not None:
            if self.power is not None:
                raise ProblemError(
                    "--power is the indicated power and --brake-power that at the shaft; leave one out"
                )
            if self.efficiency is None:
                raise ProblemError(
                    "--brake-power is that at the shaft, of which the indicated power follows by the"
                    " mechanical efficiency; add --efficiency, or give the indicated power as --power"
                )

    def _check_rods(self) -> None:
        for what, rod in (("piston rod", self.piston_rod), ("tail rod", self.tail_rod)):
            if rod is None:
                continue
            if self.bore is None:
                raise ProblemError(f"the {what} lessens the area of a piston whose size is known; add --bore")
            if not 0 < rod < self.bore:
                raise ProblemError(
                    f"the {what} is {about(1000 * rod)} mm; it must be above 0 and below the bore,"
                    f" {about(1000 * self.bore)} mm"
                )

    def _of_ends(self) -> Fraction | None:
        """Return the mean of the pressures given, by the areas of the ends."""
        if len(self.ends) < 2 or self.bore is None:
            return sum(self.ends, Fraction(0)) / len(self.ends) if self.ends else None
        areas = [self.bore**2 - (rod or 0) ** 2 for rod in (self.tail_rod, self.piston_rod)]
        return sum((one * area for one, area in zip(self.ends, areas, strict=True)), Fraction(0)) / sum(areas)

    @property
    def open_area(self) -> Fraction:
        """The mean area of both ends of the piston in that of the bore."""
        rods = sum((rod**2 for rod in (self.piston_rod, self.tail_rod) if rod is not None), Fraction(0))
        return 1 - rods / 2 / self.bore**2 if self.bore is not None else Fraction(1)

    @property
    def sized(self) -> bool:
        """Whether anything of the power, the sizes or the speed is given."""
        names = ("power", "brake_power", "bore", "stroke", "speed", "stroke_bore", "piston_speed")
        return any(getattr(self, name) is not None for name in names)

    def given(self, source: Acting | GivenPressure) -> dict[str, Term]:
        """Return what is given, by the names of variables."""
        found = {name: getattr(self, name) for name in (POWER, BORE, STROKE, PRESSURE)}
        found[PRESSURE] = source.pressure or self._of_ends() or found[PRESSURE]
        known = {name: number(value) for name, value in found.items() if value is not None}
        if not self.factor_asked:
            known[FACTOR] = number(self.diagram_factor)
        if self.brake_power is not None:
            known[POWER] = number(self.brake_power) / self.to_brake(source.driven)
        if self.speed is not None:
            turns = number(self.speed.value)
            known[SPEED] = turns if self.speed.turns else turns / number(2, pi=1)
        return known

    def to_brake(self, driven: bool) -> Term:
        """Return what times the indicated power is that at the shaft."""
        assert self.efficiency is not None
        return number(1 / self.efficiency if driven else self.efficiency)

    def relations(self, source: Acting | GivenPressure) -> dict[str, tuple[Term, str]]:
        """Return terms that are 1, by the option that errors name, each with the variable it tells first.

        N = z k p_i A S n, A the mean area of both ends, with k working strokes of a cylinder in a turn;
        S = (S/d) d; c_m = 2 S n.
        """
        found = {}
        bore, stroke, speed = variable(BORE), variable(STROKE), variable(SPEED)
        if self.stroke_bore is not None:
            found["--stroke-bore"] = stroke / bore / number(self.stroke_bore), STROKE
        if self.piston_speed is not None:
            found["--piston-speed"] = stroke * speed * number(2 / self.piston_speed), SPEED
        times = source.strokes * self.cylinders * self.open_area
        rate = number(times / 4, pi=1) * Term(source.mean) * variable(FACTOR)
        volume = bore * bore * stroke * speed
        found["--power"] = rate * variable(PRESSURE) * volume / variable(POWER), POWER
        return found


def solved(duty: Duty, source: Acting | GivenPressure) -> Mapping[str, Term]:
    """Return the variables, each in terms of what is given and of those that are not known.

    Raises ProblemError where what is given contradicts itself.
    """
    known = duty.given(source)
    found = dict(known)
    for option, (relation, told) in duty.relations(source).items():
        for name, value in found.items():
            relation = relation.put(name, value)
        free = [name for name in (told, *VARIABLES) if name in relation.powers]
        if not free:
            _check(option, relation, duty, known)
            continue
        value = relation.solved_for(free[0])
        found = {name: one.put(free[0], value) for name, one in found.items()} | {free[0]: value}
    return {name: found.get(name, variable(name)) for name in VARIABLES}


def lacking(duty: Duty, *terms: Term) -> list[str]:
    """Return the options that would make all terms known, nothing where they are."""
    free = [name for name in VARIABLES if any(name in term.powers for term in terms)]
    return [option_of(duty, name) for name in free]


def option_of(duty: Duty, name: str) -> str:
    """Return the option that gives a variable."""
    return duty.pressure_option if name == PRESSURE else f"--{name.replace('_', '-')}"


def _check(option: str, relation: Term, duty: Duty, known: Mapping[str, Term]) -> None:
    """Raise ProblemError for a relation, all of whose variables are known, that does not hold."""
    if relation.known.rational == 1:
        return
    off = float(relation.known)
    if option == "--power":
        shown = "--power" if duty.brake_power is None else "--brake-power"
        power = float(known[POWER].known) / 1000
        # Of steam, whose ideal card makes more.
        steamed = duty.pressure is not None and duty.pressure_option == "--pressure"
        asked = ", or take --diagram-factor ?" if off > 1 and steamed and duty.diagram_factor == 1 else ""
        raise ProblemError(
            f"bore, stroke, speed and pressure make an indicated power of {power * off:.5g} kW, and {shown}"
            f" asks for {power:.5g} kW; leave {shown} or one of the others out{asked}"
        )
    if option == "--stroke-bore":
        given, what, unit = duty.stroke_bore, "stroke and bore are in the ratio", ""
    else:
        given, what, unit = duty.piston_speed, "stroke and speed make a piston speed of", " m/s"
    assert given is not None
    raise ProblemError(
        f"{what} {off * float(given):.5g}{unit}, and {option} is {about(given)}{unit}; leave one of them out"
    )


class Found(NamedTuple):
    """What is found of a source: the variables, in terms of what is given."""

    duty: Duty
    source: Acting | GivenPressure
    variables: Mapping[str, Term]

    @property
    def acting(self) -> Acting:
        assert isinstance(self.source, Acting)
        return self.source

    def mean(self) -> Term:
        """Return the mean pressure in units of the pressure that Q is of."""
        return Term(self.source.mean)

    def rate(self) -> Term:
        """Return the working strokes of all cylinders in a second."""
        return self.of(SPEED) * number(self.source.strokes * self.duty.cylinders)

    def swept(self) -> Term:
        """Return the volume of a stroke in m³, the mean of both ends."""
        return number(self.duty.open_area / 4, pi=1) * self.of(BORE) ** Fraction(2) * self.of(STROKE)

    def pressure(self) -> Term:
        """Return the mean pressure in Pa."""
        return self.of(PRESSURE) * self.of(FACTOR) * self.mean()

    def brake(self) -> Term:
        """Return what times the indicated power is that at the shaft."""
        return self.duty.to_brake(self.source.driven)

    def steam(self) -> Term:
        """Return the steam of a second in kg."""
        volume = self.duty.specific_volume
        assert volume is not None
        return Term(self.acting.steam_taken) * self.swept() * self.rate() / number(volume)

    def steam_of_work(self) -> Term:
        """Return the steam of a joule of indicated work in kg."""
        return self.steam() / self.of(POWER)

    def delivery(self) -> Term:
        """Return what is delivered in a second in m³, in the state of suction."""
        return Term(self.acting.delivered) * self.swept() * self.rate()

    def of(self, name: str) -> Term:
        """Return a variable in its SI unit, the speed in turns a second."""
        return self.variables[name]


@cache
def registry() -> Mapping[str, Quantity]:
    """Return every quantity by its key; a kernel takes what is found and returns a product in SI units."""
    return {one.key: one._replace(spanners=(one.name,)) for one in _entries()}


def _entries() -> Iterator[Quantity]:
    theory = "theoretischer mittlerer Druck|Theoretical mean pressure"
    yield _entry("relative_pressure", "bezogener mittlerer Druck|Relative mean pressure", "$p_m/p$", "",
                 1, lambda found: found.mean(), UNITLESS)  # fmt: skip
    yield _entry("theoretical_pressure", theory, "$p_m$", "bar", UNITS[PRESSURE],
                 lambda found: found.of(PRESSURE) * found.mean(), FACTORED)  # fmt: skip
    yield _entry("diagram_factor", "Völligkeitsgrad des Diagramms|Diagram factor", "$φ_d$", "", 1,
                 partial(_variable, FACTOR), ASKED)  # fmt: skip
    yield _entry("mean_pressure", "mittlerer indizierter Druck|Mean effective pressure", "$p_i$", "bar",
                 UNITS[PRESSURE], Found.pressure)  # fmt: skip
    for key, name, symbol, unit in (
        (PRESSURE, "Druck|Pressure", "$p$", "bar"),
        (BORE, "Bohrung|Bore", "$d$", "mm"),
        (STROKE, "Hub|Stroke", "$S$", "mm"),
        (SPEED, "Drehzahl|Speed", "$n$", '$"min"^(-1)$'),
    ):
        yield _entry(key, name, symbol, unit, UNITS[key], partial(_variable, key))
    yield _entry("piston_speed", "mittlere Kolbengeschwindigkeit|Mean piston speed", "$c_m$", "m/s", 1,
                 lambda found: number(2) * found.of(STROKE) * found.of(SPEED))  # fmt: skip
    yield _entry("stroke_work", "Arbeit eines wirksamen Hubes|Work of a working stroke", "$A_h$", "J", 1,
                 lambda found: found.pressure() * found.swept())  # fmt: skip
    yield _entry("indicated_power", "indizierte Leistung|Indicated power", "$N_i$", "kW", UNITS[POWER],
                 lambda found: found.of(POWER))  # fmt: skip
    yield _entry("brake_power", "Leistung an der Welle|Power at the shaft", "$N_e$", "kW", UNITS[POWER],
                 lambda found: found.of(POWER) * found.brake(), EFFICIENT)  # fmt: skip
    yield _entry("brake_pressure", "mittlerer effektiver Druck|Brake mean effective pressure", "$p_e$", "bar",
                 UNITS[PRESSURE], lambda found: found.pressure() * found.brake(), EFFICIENT)  # fmt: skip
    yield _entry("mean_torque", "mittleres Drehmoment an der Welle|Mean torque at the shaft", "$M_e$", "N m",
                 1, lambda found: found.of(POWER) * found.brake() / found.of(SPEED) / number(2, pi=1),
                 EFFICIENT)  # fmt: skip
    yield _entry("steam", "Dampfverbrauch|Steam taken", "$D$", "kg/h", Fraction(1, 3600), Found.steam,
                 STEAMED)  # fmt: skip
    kwh = Fraction(1, 3600 * 1000)
    yield _entry("steam_per_kwh", "Dampf je kWh, indiziert|Steam per kWh, indicated", "$D/N_i$", "kg/kWh",
                 kwh, Found.steam_of_work, STEAMED)  # fmt: skip
    yield _entry("steam_per_brake_kwh", "Dampf je kWh an der Welle|Steam per kWh at the shaft", "$D/N_e$",
                 "kg/kWh", kwh, lambda found: found.steam_of_work() / found.brake(),
                 f"{STEAMED} {EFFICIENT}")  # fmt: skip
    yield _entry("delivery", "Fördermenge|Delivery", "$V$", "m³/min", Fraction(1, 60),
                 Found.delivery, GIVES)  # fmt: skip


def _variable(name: str, found: Found) -> Term:
    return found.of(name)


def _entry(
    key: str, name: str, symbol: str, unit: str, size: Fraction | int, kernel: Callable[[Found], Term],
    needs: str = "",
) -> Quantity:  # fmt: skip
    formula = Formula(lambda found: kernel(found) / number(size))
    own = entry(key, name, symbol, unit, None, {"exact": formula}, needs=needs)
    return own._replace(heading=with_symbol(own))
