"""The power of a cylinder, the sizes that a power asks for, and the pressures on its piston."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import TypeGuard

from kurbel.commands.options import Choice, Count, Option, alone, measure, word
from kurbel.commands.part import CommandOptions, Values, flag_of
from kurbel.commands.parts.drive import Linked, MachineKeys, settle_sizes
from kurbel.commands.parts.engine import Cylinder
from kurbel.commands.parts.engine import Engine as EnginePart
from kurbel.commands.parts.loads import KINDS, Loads
from kurbel.commands.parts.masses import Masses
from kurbel.commands.parts.performance import Losses
from kurbel.commands.parts.sheet import Layouts, Sheet, columns_option, layout_option
from kurbel.commands.subject import function
from kurbel.drive.crank import Crank
from kurbel.drive.load import CARD, MASSES, PUMP
from kurbel.drive.load import Load as Acting
from kurbel.engine.engine import Engine, Load
from kurbel.engine.power.duty import Duty, equation
from kurbel.engine.power.power_page import PowerRequest
from kurbel.engine.power.source import ActingPressure, GivenPressure, as_compound
from kurbel.engine.power.unknown import UNKNOWNS, sought
from kurbel.engine.pressures import PressureDrive, PressuresRequest
from kurbel.engine.request import EngineRequest
from kurbel.errors import ProblemError
from kurbel.motion.mechanism import uncomputed
from kurbel.page.layouts import Layout, layout
from kurbel.page.subject import Question
from kurbel.reading.given import (
    as_angles,
    as_brake_torque,
    as_consumption,
    as_delivery,
    as_free_air,
    as_heating_value,
    as_length,
    as_mean_pressure,
    as_number,
    as_power,
    as_pressure,
    as_ratios,
    as_share,
    as_shares,
    as_speed,
    as_temperature,
    as_velocity,
    as_volume,
)
from kurbel.reading.notation import about

NEEDED = (
    "the power needs what acts on the piston: --eps with --pressure, --mean-pressure with --working-strokes,"
    " --card, --pressure-ratio, --pump or --compression"
)
# What makes a power of the mean pressure.
SIZES = (
    *("power", "brake_power", "brake_torque", "bore", "stroke", "speed", "stroke_bore", "piston_speed"),
    *("swept_volume", "delivery"),
)
# What gives a delivery.
GIVING = ("pressure_ratio", "pump")
# The layouts over the stroke and over the crank angle, and what they are about.
PRESSURES, ABOUT = ("pressures", "pressures-turn"), ("pressures", "pressures over the angle")


class PowerOptions(MachineKeys, Loads, Losses, Layouts, Sheet, CommandOptions):
    """Print the mean effective pressure and the power of an engine, a compressor or a pump, or the bore,
    stroke or speed that a power asks for, and the steam taken.

    \b
    kurbel power --machine engine.toml  # of a machine
    kurbel power --power 50kW --mean-pressure 3bar --speed 120/min --stroke 600mm \
--working-strokes 2  # the bore for a power
    kurbel power --eps 4 --pressure 8bar --bore 300mm --stroke 600mm --speed 2/s  # of an ideal card
    kurbel power --eps 3 --pressure 8bar --back 1.1bar --clearance 8% --diagram-factor 0.8
    kurbel power --eps 3 --pressure 8bar --back 1.1bar --power 75kW --stroke-bore 1.5 --speed 250/min
    kurbel power --mean-pressure 5bar --working-strokes 2 --bore 300mm --stroke 450mm --speed 200/min
    kurbel power --compression 6 --heat 10 --suction-pressure 1bar --cylinders 4 --power 30kW \
--stroke-bore 1 --speed 3000/min
    \f
    >>> import kurbel
    >>> page = kurbel.power("1", pressure=5e5, back=0.2, bore=0.2, stroke=0.3, speed=2,
    ...                           columns="mean_pressure,indicated_power")
    >>> print(kurbel.typeset(page, "csv"), end="")
    mean_pressure,indicated_power
    4.0000,15.080
    """

    topic = "work"

    unnamed = "eps"
    sequence = (
        "mean_pressure working_strokes pressure back exponent clearance single_acting card ratio bore"
        " piston_rod tail_rod stroke speed power brake_power stroke_bore piston_speed cylinders"
        " diagram_factor efficiency specific_volume delivery unknown stages"
        " suction_temperature free_air brake_torque consumption heating_value thermal_efficiency"
        " intercooling intermediate_pressure swept_volume second_clearance"
    )
    in_short = (
        "power mean_pressure eps pressure card bore stroke speed machine cylinders efficiency brake_power"
    )

    mean_pressure = measure(
        lambda value, what: _ends(value, what),
        "The mean effective pressure itself, with --working-strokes: 5bar; '3.5bar;3.2bar' of the ends at the"
        " cover and at the crank; of a card its area by its length times the scale of its spring,"
        " '1200mm²/75mm x 0.15bar/mm'.",
        "PRESSURE",
        unit="Pa",
    )
    working_strokes = measure(
        as_number,
        "With --mean-pressure: working strokes of a cylinder in a turn: 2 of a double-acting one, 1, or 0.5"
        " of four strokes.",
        "NUMBER",
    )
    ratio = Linked.ratio.but(help="Crank ratio, for a card over the crank angle: 1:5.")
    stroke = measure(as_length, "Stroke of the piston: 450mm.", "LENGTH", topic="crank")
    cranks = EnginePart.cranks.but()
    speed = measure(
        alone(as_speed), "Speed: 120/min, 12.5rad/s.", "SPEED", unit="turns a second", topic="crank"
    )
    power = measure(
        alone(as_power), "Indicated power, to find the sizes or the speed: 75kW, 100PS.", "POWER", unit="W"
    )
    brake_power = measure(
        alone(as_power),
        "The power at the shaft: with --efficiency in the place of --power, with both powers the mechanical"
        " efficiency follows.",
        "POWER",
        unit="W",
    )
    brake_torque = measure(
        as_brake_torque,
        "Torque at the shaft, which with the speed tells that: 300Nm, or a brake's load, less that of its"
        " spring, on its arm, '1370N - 145N x 0.61m'.",
        "TORQUE",
    )
    consumption = measure(
        as_consumption,
        "Fuel or steam consumed: '4 kg/h', or '0.25 kg/kWh' at the shaft, indicated where nothing of the"
        " shaft is given.",
        "FLOW",
        unit="kg/s",
    )
    heating_value = measure(
        as_heating_value, "Heating value of the fuel, or heat of the steam: 43MJ/kg, 2400kJ/kg.", "HEAT",
    )  # fmt: skip
    thermal_efficiency = measure(
        as_share, "Thermal efficiency, at the shaft or indicated as --consumption: 28%.", "SHARE"
    )
    stroke_bore = measure(
        as_share, "Stroke over bore, where sizes are to be found: 1.5.", "RATIO", what="stroke over bore"
    )
    piston_speed = measure(
        as_velocity, "Mean piston speed in place of the stroke or the speed: 3m/s.", "VELOCITY"
    )
    swept_volume = measure(
        as_volume, "Swept volume of a cylinder, of both ends the mean, in place of bore and stroke: '1.5 l'.",
        "VOLUME",
    )  # fmt: skip
    cylinders = measure(as_number, "Number of cylinders alike; default 1.", "NUMBER", topic="cylinders")
    delivery = measure(
        as_delivery,
        "Delivery of a compressor or a pump, in the state of suction, to find sizes: '2 m3/min'; with"
        " --suction-temperature also as a mass of air, '4 kg/min'.",
        "FLOW", unit="m³/s", topic="compressor",
    )  # fmt: skip
    stages: Option[int] = Option(
        "Stages of a compressor, with perfect intercooling and the best intermediate pressure: 2.", "N",
        Count("stages", 1, 6), default=1, topic="compressor",
    )  # fmt: skip
    intercooling = measure(
        as_temperature,
        "Temperature to which the air is cooled between the stages: 35°C; default: that of suction.",
        "TEMPERATURE", topic="compressor",
    )  # fmt: skip
    intermediate_pressure = measure(
        as_pressure, "Pressure between two stages, in the place of the best: 4bar.", "PRESSURE",
        topic="compressor",
    )  # fmt: skip
    second_clearance = measure(
        as_share, "Clearance of the second stage: 5%; default: that of the first.", "SHARE",
        topic="compressor",
    )  # fmt: skip
    suction_temperature = measure(
        as_temperature, "Temperature of suction of a compressor: 30°C, 303K.", "TEMPERATURE",
        topic="compressor",
    )  # fmt: skip
    free_air = measure(
        as_free_air, "State of free air, in which --delivery then counts: '1.013bar 15°C'.", "STATE",
        topic="compressor", whole=True,
    )  # fmt: skip
    compound = measure(
        as_compound,
        "Compound engine of the hypothetical diagram, of which --bore is the low-pressure cylinder and --eps"
        " the whole expansion; the high-pressure one by equal work, by equal load on both pistons, by its"
        " bore, 250mm, by the pressure of the receiver, 2.4bar, or by its own expansion, 2.5.",
        "HOW", topic="steam",
    )  # fmt: skip
    unknown = word(
        "What is asked for of a power, a mean pressure or a delivery: eps, pressure, back, clearance,"
        " pressure_ratio or diagram_factor; bore, stroke, speed and power follow without it.",
        kind=Choice("unknown", "kurbel.engine.power.unknown:NAMES"),
        topic="question",
    )
    columns = columns_option("power", "mean_pressure,indicated_power")
    layout = layout_option("power").but(default="power")

    @classmethod
    def settle(cls, values: Values) -> None:
        unknown = values.values.get("unknown")
        if isinstance(unknown, str) and not values.typed(unknown):
            values.drop(unknown)
        settle_sizes(values)

    def question(self) -> Question:
        page, unknown = self.page("power", "power"), self.unknown
        if unknown is not None and self.says(unknown):
            raise ProblemError(
                f"{flag_of(unknown)} is given and asked for, as --unknown; leave one of the two out"
            )
        duty = self._probed(unknown)._duty() if self._is_sought(unknown) else self._duty()
        if unknown == "pressure":
            duty = replace(duty, pressure=None)
        return PowerRequest(
            sources=self._sources(page, duty),
            duty=duty,
            **self.on_page(page, "mean_pressure,indicated_power"),
        )

    def unread(self, option: Option[object]) -> str:
        name, flag = option.name, flag_of(option.name)
        load, sized = any(map(self.says, KINDS)), self.says(*SIZES)
        if name == "specific_volume" and not self.says("eps"):
            return f"{flag} is for the steam that an ideal card takes; add --eps"
        if name == "specific_volume":
            return (
                f"{flag} is for the steam taken, and nothing tells how much; add --pressure, or bore, stroke"
                " and speed"
            )
        if name in ("cylinders", "cranks") and not sized:
            return (
                f"{flag} is for the power, and nothing tells it; add --bore, --stroke and --speed, or --power"
            )
        if name in (
            *("stages", "intercooling", "intermediate_pressure", "second_clearance"),
            *("suction_temperature", "free_air"),
        ):
            return f"{flag} is of a compressor; add --pressure-ratio"
        if name == "compound":
            return f"{flag} is of the steam of an ideal card in two cylinders; add --eps"
        if name == "delivery":
            return f"{flag} is that of a compressor or a pump; add --pressure-ratio or --pump"
        if name == "working_strokes":
            return f"{flag} is for --mean-pressure; other loads say it themselves"
        if self.says("mean_pressure") and not load:
            if name in ("single_acting", "two_stroke"):
                return f"{flag} is counted by --working-strokes where --mean-pressure is given; leave it out"
            return (
                f"{flag} says what a mean pressure follows from, and --mean-pressure gives that itself; leave"
                " it out"
            )
        if name == "ratio" and self.says("card"):
            return "--ratio is for a card over the crank angle, and this one is over the stroke; leave it out"
        if name == "ratio":
            return (
                "--ratio is for an indicator card over the crank angle, --card; the work of a stroke does not"
                " depend on it"
            )
        if name == "pressure" and self.says("card"):
            return "an indicator card has its own pressures; leave --pressure out"
        if name == "back":
            return "--back is that of steam; add --eps"
        if name == "suction_pressure":
            return "--suction-pressure of a pump is taken off what it delivers; add --delivery-pressure"
        return ""

    def _duty(self) -> Duty:
        """Return what is given, with the pressure that mean pressures count in."""
        factor = self.diagram_factor
        cylinders = self._count() if self.says(*SIZES) else 1
        free, warm = self._air()
        duty = partial(
            Duty, bore=self.bore, stroke=self.stroke, speed=self.speed, power=self.power,
            brake_power=self.brake_power, brake_torque=self.brake_torque, consumption=self.consumption,
            heating_value=self.heating_value, thermal_efficiency=self.thermal_efficiency,
            stroke_bore=self.stroke_bore, piston_speed=self.piston_speed, swept_volume=self.swept_volume,
            cylinders=cylinders, piston_rod=self.piston_rod, tail_rod=self.tail_rod,
            unknown=self.unknown or "", delivery=self.delivery if self.says(*GIVING) else None,
            free_air=free, suction_temperature=warm,
            efficiency=self.efficiency, diagram_factor=Fraction(1) if factor is None else factor,
            specific_volume=self._volume() if self.says("eps") or self.unknown == "eps" else None,
            ends=self.mean_pressure or (),
            compound=self.compound if self.says("eps") or self.unknown == "eps" else None,
        )  # fmt: skip
        if self.says("mean_pressure") and not self.says("unknown"):
            return duty()
        names = [name for name in self.weighing() if name != "bore"]
        name = names[0] if names else "pressure"
        pressure = as_pressure(self.raw(name), name.replace("_", " ")) if names and self.says(name) else None
        if name == "delivery_pressure" and pressure is not None and self.says("suction_pressure"):
            pressure -= self.suction_pressure or 0
        if pressure is not None and pressure <= 0:
            raise ProblemError(f"{flag_of(name)} is {self.raw(name)}; it must be above 0")
        return duty(pressure=pressure, pressure_option=flag_of(name))

    def _air(self) -> tuple[tuple[Fraction, Fraction] | None, Fraction | None]:
        """Return the state of free air and the temperature of suction of a compressor."""
        if not self.says("pressure_ratio"):
            return None, None
        free, warm = self.free_air, self.suction_temperature
        if free is not None and (warm is None or not self.says("suction_pressure")):
            missing = "--suction-pressure" if warm is not None else "--suction-temperature"
            raise ProblemError(f"free air is compared with the state of suction; add {missing}")
        return free, warm

    def staged(self) -> Mapping[str, object]:
        cooled, between, suction = self.intercooling, self.intermediate_pressure, self.suction_pressure
        if (cooled is not None or between is not None) and (
            self.stages == 1 or (between is not None and self.stages > 2)
        ):
            option = "--intercooling" if between is None else "--intermediate-pressure"
            raise ProblemError(f"{option} is between {'two ' if between else ''}stages; add --stages 2")
        warm = self.suction_temperature
        if cooled is not None and warm is None:
            raise ProblemError(
                "--intercooling is compared with the temperature of suction; add --suction-temperature"
            )
        if between is not None and suction is None:
            raise ProblemError(
                "--intermediate-pressure is compared with the suction pressure; add --suction-pressure"
            )
        return {
            "stages": self.stages,
            "later_clearance": self._second_clearance(),
            "cooled": None if cooled is None else cooled / (warm or 1),
            "between": None if between is None else between / _above_zero(suction, "suction pressure"),
        }

    def _second_clearance(self) -> Fraction | None:
        if self.second_clearance is not None and self.stages != 2:
            raise ProblemError("--second-clearance is of the second of two stages; add --stages 2")
        return self.second_clearance

    def _count(self) -> int:
        """Return how many cylinders there are, one for each crank where these are given."""
        of_cranks = len(self.cranks) if self.cranks else None
        number = self.cylinders
        if number is None:
            return of_cranks or 1
        if number.denominator != 1:
            raise ProblemError(f"the number of cylinders is {about(number)}; it must be a whole number")
        if of_cranks not in (None, number):
            raise ProblemError(
                f"--cylinders is {number}, and --cranks has {of_cranks} of them; leave one out"
            )
        return int(number)

    def _volume(self) -> Fraction | None:
        """Return the specific volume of the steam, if there is anything that tells how much is taken."""
        if not self.says("pressure", *SIZES):
            return None
        volume = self.specific_volume
        if volume is not None and volume <= 0:
            raise ProblemError("the specific volume of steam must be above 0")
        return volume

    def _sources(self, page: Layout, duty: Duty) -> Sequence[ActingPressure | GivenPressure]:
        """Return where the mean pressures come from."""
        named = self.load_names()
        if self._is_sought(unknown := self.unknown):
            return self._sought(page, duty, unknown)
        if self.says("mean_pressure") and not (named and unknown):
            if named:
                raise ProblemError(
                    f"{flag_of(named[0])} and --mean-pressure are two mean pressures; leave one out"
                )
            strokes = self.working_strokes
            if strokes is None:
                raise ProblemError(
                    "--mean-pressure needs the working strokes of a turn; add --working-strokes: 2 of a"
                    " double-acting cylinder, 1 of a single-acting one, 0.5 of one in four strokes"
                )
            return [GivenPressure(strokes)]
        if not named:
            raise ProblemError(NEEDED)
        return self._acting(page, duty)

    def _is_sought(self, unknown: str | None) -> TypeGuard[str]:
        """Whether what is asked for is a number of the load, and not a factor of its relations: the steam
        pressure is one where the back pressure is a share of it."""
        return unknown in UNKNOWNS and (unknown != "pressure" or self._back_is_pressure())

    def _probed(self, unknown: str, found: Fraction | None = None) -> PowerOptions:
        """Return the same with a value of what is asked for: that which was found, or one with which there is
        a load to begin with. Raises ProblemError for none."""
        asked = UNKNOWNS[unknown]
        if unknown not in asked.loads and not self.says(*asked.loads):
            raise ProblemError(
                f"--unknown {unknown} is a number of a load; add {' or '.join(map(flag_of, asked.loads))}"
            )
        values = asked.probes if found is None else (found,)
        for value in values:
            tried = PowerOptions(self.values.instead({unknown: value}, own=True))
            try:
                count = len(tried.loads(layout("power")))
            except ProblemError:
                if value == values[-1]:
                    raise
                continue
            if count != 1:
                raise ProblemError(f"--unknown is of one load, and {count} were given; give one")
            break
        return tried

    def _sought(self, page: Layout, duty: Duty, unknown: str) -> Sequence[ActingPressure]:
        """Return what acts on the piston with every number of it that does what is given."""
        over = as_pressure(self.raw("back"), "back pressure") if unknown == "pressure" else None
        [source] = self._probed(unknown)._acting(page, duty)
        relation, missing = equation(duty, source, over is not None)
        if relation is None:
            raise ProblemError(
                f"--unknown {unknown} is found from a power, a mean pressure or a delivery; add"
                f" {' and '.join(missing)}"
            )
        return [
            replace(one, sought=found)
            for found in sought(source.load, unknown, relation, over)
            for one in self._probed(unknown, found.near)._acting(page, duty)
        ]

    def _acting(self, page: Layout, duty: Duty) -> Sequence[ActingPressure]:
        loads = self.loads(page)
        double = getattr(loads[0], "double", None)
        double = not self.single_acting if double is None else double
        return [ActingPressure(self._engine(load, double, duty)) for load in loads]

    def _engine(self, load: Acting, double: bool, duty: Duty) -> Engine:
        """Return an engine on which the load acts; of work alone the crank ratio says nothing."""
        over_angle = load.name == CARD and hasattr(getattr(load, "card", None), "angles")
        if over_angle and not self.says("ratio"):
            raise ProblemError("a card over the crank angle needs the crank ratio; add --ratio, such as 1:5")
        ratios = as_ratios(self.ratio) if over_angle else (Fraction(0),)
        if len(ratios) != 1:
            raise ProblemError(
                f"{len(ratios)} crank ratios were given; a card was taken from an engine of one"
            )
        size = None
        if load.name == PUMP and duty.bore is not None and duty.pressure is not None:
            size = Load(duty.bore, duty.pressure)
        return Engine(Crank(ratios[0]), load, double, load=size)


def _ends(given: object, what: str) -> tuple[Fraction, ...]:
    """Return the mean pressures of one or both ends of the piston. Raises KurbelError."""
    parts = given.split(";") if isinstance(given, str) else [given]
    if len(parts) > 2:
        raise ProblemError(f"{len(parts)} mean pressures were given; a piston has two ends")
    return tuple(_above_zero(one, what) for one in parts)


def _above_zero(pressure: object, what: str) -> Fraction:
    found = as_mean_pressure(pressure, what)
    if found <= 0:
        raise ProblemError(f"the {what} is {str(pressure)[:40]}; it must be above 0")
    return found


power = function(PowerOptions, "power")


class PressuresOptions(Cylinder, Layouts, Sheet, CommandOptions):
    """Print the acceleration pressure over the stroke, beside the pressure on the piston.

    The masses that go to and fro take it from steam or gas, per piston area, and give it back; without
    --eps or --card it stands alone.

    \b
    kurbel pressures --machine engine.toml  # of a machine
    kurbel pressures --machine engine.toml --shares '25%;50%'  # at two places
    kurbel pressures --reciprocating 300kg --stroke 600mm --bore 300mm --speed 120/min
    kurbel pressures --machine engine.toml --angle 0..360:15
    \f
    >>> import kurbel
    >>> masses = {"reciprocating": 300, "stroke": 0.6, "bore": 0.3, "speed": 2}
    >>> page = kurbel.pressures("1:5", shares="0;0.5;1", columns="share,inertia_pressure", **masses)
    >>> print(kurbel.typeset(page, "csv"), end="")
    stroke,share,inertia_pressure
    1,0.0,2.413
    1,0.5,-0.201
    1,1.0,-1.608
    2,0.0,1.608
    2,0.5,0.201
    2,1.0,-2.413
    """

    # What the acceleration pressure has nothing of.
    without = (
        *("friction", "piston_rod", "tail_rod", "rotating", "rocker_inertia"),
        *("slope", "gravity"),
    )
    unnamed = "ratio"
    sequence = (
        "eps back exponent clearance card other_side single_acting bore pressure ratio mechanism offset"
        " rocker pivot circuit beam stroke time_ratio rod speed reciprocating rod_mass"
        " centre gyration rod_file shares angle columns"
    )
    in_short = "eps bore pressure card ratio stroke rod speed machine reciprocating shares columns"

    columns = columns_option("pressures", "share,gas_pressure,inertia_pressure")
    speed = Cylinder.speed.but(help="Speed, for the masses: 120/min, 12.5rad/s.")
    shares = measure(
        as_shares,
        "Shares of the stroke: 0.25, lists '0;0.5;1', ranges; default 0..1:0.1.", "SHARES", many=True,
        what="share of the stroke", topic="angles",
    )  # fmt: skip
    angle = measure(
        alone(as_angles),
        "Crank angles in place of these, with layout pressures-turn: 0..360:10.", "ANGLES", unit="degrees",
        many=True, topic="angles",
    )  # fmt: skip
    layout = layout_option(*ABOUT)

    def question(self) -> Question:
        if self.says("shares") and self.says("angle"):
            raise ProblemError(
                "--shares and --angle are two pages, over the stroke or the angle; leave one out"
            )
        page = self.page(PRESSURES[self.says("angle")], *ABOUT)
        over_angle = page.subject == ABOUT[1]
        other, axis = ("shares", "crank angle") if over_angle else ("angle", "stroke")
        if self.says(other):
            raise ProblemError(
                f"layout {page.key} is over the {axis}; leave --{other} out, or use --layout"
                f" {PRESSURES[not over_angle]}"
            )
        shares, angles = self.shares, self.angle
        return PressuresRequest(
            pressed=self._pressed(page),
            shares=as_shares("0..1:0.1", "share") if shares is None else shares,
            angles=as_angles(page.angles or "0") if angles is None else angles,
            **self.on_page(page, "share,inertia_pressure"),
        )

    def _pressed(self, page: Layout) -> PressureDrive:
        """Return the one cylinder that is described, with its masses, its load or both."""
        if self.load_names():
            if self.says("card") and not self.is_heavy():
                self.refuse("bore")
            engines = self.engines(layout("engine-forces"))
            about = EngineRequest(layout=layout("engine-forces"), **engines)
            _check_one(about.steams, "loads")
            _check_one(about.drives, "crank ratios")
            return PressureDrive(about.drives[0], self.bore, about.first.parts[0])
        chosen, described = self.described(
            beside=("stroke",), leaving=("speed", "method", *self.lone_lengths())
        )
        if sentence := uncomputed(chosen, MASSES):
            raise ProblemError(sentence)
        drives = self.weighed(chosen, chosen.drives(described, page.ratios), "bore", even=True)
        _check_one(drives, "crank ratios")
        return PressureDrive(drives[0], self.bore)

    def unread(self, option: Option[object]) -> str:
        return f"--bore is for {Masses.title}; add {Masses.add}" if option.name == "bore" else ""

    def is_sized(self) -> bool:
        return self.compares_lengths() or self.is_heavy()

    def has_speed(self) -> bool:
        return False


def _check_one(found: Sequence[object], what: str) -> None:
    if len(found) != 1:
        raise ProblemError(
            f"pressures are those of one cylinder, and {len(found)} {what} were given; give one"
        )


pressures = function(PressuresOptions, "pressures")
