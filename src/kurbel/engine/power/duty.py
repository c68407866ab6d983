"""Power, bore, stroke, speed and pressure: those that are given make the others known."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from kurbel.engine.power.relation import Term, number, variable
from kurbel.errors import ProblemError
from kurbel.reading.notation import about

if TYPE_CHECKING:
    from kurbel.engine.power.source import Acting, GivenPressure
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
