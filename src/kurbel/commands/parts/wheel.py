"""What makes the size of a flywheel: where its swing comes from, its body, its rim, a press."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import ClassVar, NamedTuple

from kurbel.commands.options import Option, alone, amount, measure
from kurbel.commands.part import Part, Rivals, flag_of
from kurbel.commands.parts.drive import Speed
from kurbel.commands.parts.press import Press, in_one_unit, sides_of
from kurbel.engine.diagram.sizing import Known
from kurbel.errors import NotationError, ProblemError
from kurbel.exact.numerals import about
from kurbel.exact.real import Product
from kurbel.reading.given import (
    as_area,
    as_density,
    as_duration,
    as_energy,
    as_inertia,
    as_irregularities,
    as_length,
    as_mass,
    as_number,
    as_power,
    as_ratio,
    as_share,
    as_speed,
    as_stress,
    as_torque,
    as_velocity,
    as_work,
)
from kurbel.reading.units import OfTurns

# The options that give figures by themselves, and what these are called where it is not the option's name.
PLAIN = (
    "swing", "energy_fluctuation", "work", "turns", "power", "inertia", "mass", "radius", "rim_diameter",
    "rim_speed", "rim_breadth", "rim_thickness", "density", "hoop_stress", "rim_share", "disc_diameter",
    "disc_thickness", "poisson", "run_up_torque", "run_up_time", "run_up_turns",
)  # fmt: skip
FIGURES = {"rim_breadth": "breadth", "rim_thickness": "thickness"}
# What they are where they are written as shares of a diameter.
SHARES = {
    "rim_breadth": "breadth_share",
    "rim_thickness": "thickness_share",
    "disc_thickness": "disc_share",
}
SPEEDS = {"speed": "omega", "greatest_speed": "omega_max", "least_speed": "omega_min"}
_RANGE = re.compile(r"(.+?)\.\.(.+)")
_SQUARE = re.compile(r"(?<=[a-z])2$")


class ShareOf(NamedTuple):
    """A share of a diameter, in the place of a length."""

    share: Fraction


def _size(given: object, what: str) -> Fraction | ShareOf:
    """Return a length in metres, or what is written as 20% of a diameter. Raises KurbelError."""
    if isinstance(given, str) and given.strip().endswith("%"):
        return ShareOf(as_share(given, what))
    return as_length(given, what)


class Swing(Part):
    """What the energy swing is known from."""

    topic = "wheel"

    swing = measure(
        as_energy, "Energy swing, from the least speed to the greatest: 5kJ.", "ENERGY",
        what="energy swing",
    )  # fmt: skip
    energy_fluctuation = measure(
        as_share, "The same as a share of the work of a cycle: 0.1, 10%.", "SHARE",
        what="coefficient of fluctuation of energy",
    )  # fmt: skip
    work = measure(
        as_work,
        "Work of a cycle, of a press that of a stroke: 10kJ; or its factors, '350kN x 200mm x 15%',"
        " '1200J/cm² x 8cm x 2cm', '2kNm x 144/min x 0.6s'.", "ENERGY",
        what="work of a cycle", topic="press",
    )  # fmt: skip


class Body(Part):
    """The flywheel itself, and how it turns."""

    topic = "wheel"

    greatest_speed = amount(
        "Greatest speed: 225/min; --speed 200..225/min has both.", "SPEED", unit="turns a second"
    )
    least_speed = amount("Least speed: 200/min.", "SPEED", unit="turns a second")
    inertia = measure(
        as_inertia, "Moment of inertia of the flywheel: 1200kgm2.", "J",
        what="moment of inertia", machine="flywheel",
    )  # fmt: skip
    run_up_torque = measure(
        as_torque, "From rest to its --speed under a constant torque: 20 N m.", "TORQUE",
        what="torque of running up",
    )  # fmt: skip
    run_up_time = measure(
        as_duration, "How long it takes from rest to its --speed: 12s.", "TIME",
        what="time of running up",
    )  # fmt: skip
    run_up_turns = amount("How many turns it makes meanwhile: 40.", "TURNS")
    mass = measure(
        as_mass,
        "Mass of the flywheel, which with --radius gives the inertia: 6.5t.",
        "MASS",
        machine="flywheel",
    )


class Rim(Part):
    """The rim that makes the moment of inertia, or a disc."""

    topic = "rim"
    section = "flywheel"

    rim_diameter = measure(
        as_length, "Mean diameter of the rim: 2m.", "LENGTH", what="mean diameter of the rim"
    )
    rim_speed = measure(
        as_velocity,
        "Speed of the rim at its mean diameter: 25m/s, or 26..28m/s; with δ its mass needs no --speed.",
        "VELOCITY", what="speed of the rim", machine="",
    )  # fmt: skip
    rim_section = amount(
        "Section of the rim: breadth to thickness, 2:1, both, '400mm x 200mm', or 800cm².",
        "SECTION",
        whole=True,
    )
    rim_breadth = measure(
        _size, "Breadth of the rim, along the shaft: 300mm, or a share of its mean diameter, 20%.", "LENGTH",
        unit="m", what="breadth of the rim",
    )  # fmt: skip
    rim_thickness = measure(
        _size, "Thickness of the rim, along the radius: 150mm, or a share of its mean diameter, 10%.",
        "LENGTH", unit="m", what="thickness of the rim",
    )  # fmt: skip
    density = measure(as_density, "Density of rim or disc: 7200kg/m³.", "DENSITY")
    hoop_stress = measure(
        as_stress,
        "Hoop stress ρ v² that the rim may have: 6MPa; without --rim-diameter the greatest is found.",
        "STRESS", usual="MPa",
    )  # fmt: skip
    rim_share = measure(
        as_share, "Share of the rim in the moment of inertia, beside arms and hub: 92%.", "SHARE",
        what="share of the rim",
    )  # fmt: skip
    disc_diameter = measure(
        as_length,
        "Solid disc: its diameter, 600mm.",
        "LENGTH",
        what="diameter of the disc",
        topic="disc",
    )
    disc_thickness = measure(
        _size,
        "Solid disc: its thickness, 80mm, or a share of its diameter, 10%.",
        "LENGTH",
        unit="m",
        what="thickness of the disc",
        topic="disc",
    )

    poisson = measure(
        as_share, "Solid disc: Poisson's ratio, for the greatest stress in it: 0.3.", "RATIO",
        what="Poisson's ratio", topic="disc",
    )  # fmt: skip


class Wheel(Swing, Press, Body, Rim, Speed):
    """A flywheel by all that sizes it; what is given of it are figures of its relations, in SI units."""

    topic = "wheel"

    # It is given by its inertia, its mass or its sizes, or is to keep an irregularity.
    rivals: ClassVar[Rivals] = (
        *(("inertia", other) for other in ("mass", "rim_diameter", "disc_diameter", "delta")),
        *((other, "inertia") for other in ("mass", "disc_diameter", "delta")),
        ("speed", "least_speed"),
        ("delta", "least_speed"),
    )

    power = measure(
        as_power,
        "Power of the engine: 50kW, 68PS; left out, it follows from pressure, bore, stroke and speed.",
        "POWER", machine="flywheel", topic="work",
    )  # fmt: skip
    speed = Speed.speed.but(help="Speed: 120/min, 12.5rad/s; without an engine also 200..225/min.")
    delta: Option[Sequence[Fraction] | None] = measure(
        alone(as_irregularities),
        "Degree of irregularity to keep: 1:100, 0.01, ±0.5%; lists '1:50;1:100'.", "δ", many=True,
        machine="flywheel",
    )  # fmt: skip
    radius = measure(
        as_length, "Radius at which the mass of the rim is wanted, or the radius of gyration: 1.5m.",
        "LENGTH", machine="flywheel",
    )  # fmt: skip

    def figures(self, *only: str) -> Iterator[tuple[str, Known]]:
        """Yield what is given of the flywheel, or by these options alone, but for δ and the press. Raises
        KurbelError."""
        for name in only or (*PLAIN, *SPEEDS, "rim_section"):
            if self.says(name) and (name != "turns" or self.has_turns()):
                for figure, value in self._figures_of(name):
                    yield figure, Known(value, (flag_of(name),))

    def has_turns(self) -> bool:
        """Whether turns are those of the cycle of a work."""
        return self.says("energy_fluctuation", "work", "hole", "power", "strokes", "share", "columns")

    def _figures_of(self, name: str) -> Iterator[tuple[str, Product]]:
        """Yield what an option gives: one figure, of a range or of two sides two."""
        option, value = self.options()[name], self.raw(name)
        if name == "rim_section":
            yield from _section(value)
        elif name in ("speed", "rim_speed") and (ends := _ends(value)):
            yield from _of_speeds(ends) if name == "speed" else _of_rim_speeds(ends)
        elif name in SPEEDS:
            yield SPEEDS[name], omega_of(value)
        else:
            what = "number of turns of a cycle" if name == "turns" else option.what or name.replace("_", " ")
            number = (option.read or as_number)(value, what)
            if isinstance(number, ShareOf):
                yield SHARES[name], _above_zero(number.share, what, "")
                return
            if isinstance(number, OfTurns):
                yield name, _above_zero(number.share, what, "J") * Product.of(1, 1)
                return
            assert isinstance(number, Fraction)
            if name == "rim_share" and number > 1:
                raise ProblemError(f"the {what} is {about(number)}; it must be at most 1, the whole flywheel")
            if name == "poisson":
                if not 0 <= number <= Fraction(1, 2):
                    raise ProblemError(f"{what} is {about(number)}; it must be 0 to 0.5")
                yield "disc_bulge", Product.of((3 + number) / 8)
                return
            # What a motor gives is more than what the press takes.
            figure = "motor" if name == "power" and self.says("efficiency") else FIGURES.get(name, name)
            yield figure, _above_zero(number, what, option.unit)


def _above_zero(value: Fraction, name: str, unit: str) -> Product:
    if value <= 0:
        raise ProblemError(f"the {name} is {f'{about(value)} {unit}'.strip()}; it must be above 0")
    return Product.of(value)


def _ends(speed: object) -> list[str]:
    """Return the two speeds of "200..225/min", none of another text."""
    ends = _RANGE.fullmatch(speed) if isinstance(speed, str) else None
    return in_one_unit(ends.groups()) if ends else []


def _of_speeds(ends: Sequence[str]) -> Iterator[tuple[str, Product]]:
    """Yield the least and the greatest speed."""
    first, second = map(omega_of, ends)
    low, high = (second, first) if first.exceeds(second) else (first, second)
    yield "omega_min", low
    yield "omega_max", high


def _of_rim_speeds(ends: Sequence[str]) -> Iterator[tuple[str, Product]]:
    """Yield the mean speed of a rim and δ, of its least and its greatest speed."""
    low, high = sorted(as_velocity(end, "speed of the rim") for end in ends)
    if low <= 0 or low == high:
        raise ProblemError(
            f"the speed of the rim runs from {about(low)} m/s to {about(high)} m/s; the least must be above 0"
            " and below the greatest"
        )
    yield "rim_speed", Product.of((low + high) / 2)
    yield "delta", Product.of(2 * (high - low) / (low + high))


def omega_of(speed: object) -> Product:
    """Return ω in 1/s of a speed of rotation."""
    turns = as_speed(speed)
    return Product.of(2 * turns.value, 1) if turns.turns else Product.of(turns.value)


def _section(section: object) -> Iterator[tuple[str, Product]]:
    """Yield what the section of a rim gives: breadth and thickness, its area, or the ratio of both."""
    if section is None:
        return
    name = "section of the rim"
    if sides := sides_of(section):
        for figure, side in zip(("breadth", "thickness"), sides, strict=True):
            what = f"{figure} of the rim"
            yield figure, _above_zero(as_length(side, what), what, "m")
    elif isinstance(section, str) and any(map(str.isalpha, section)):
        yield "section", _above_zero(as_area(_SQUARE.sub("²", section.strip()), name), name, "m²")
    else:
        yield "proportion", _above_zero(_ratio(section), "ratio of breadth to thickness of the rim", "")


def _ratio(section: object) -> Fraction:
    try:
        return as_ratio(section)
    except NotationError:
        raise NotationError(
            f'section of the rim "{str(section)[:40]}" cannot be read; write breadth to thickness, 2:1, both,'
            " 400mm x 200mm, or 800cm²"
        ) from None
