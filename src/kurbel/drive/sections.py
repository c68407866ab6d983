"""The sections of a machine's file and their entries, each the option of the same name.

Fields are called as the options, and in the file as `name` says where that differs.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, get_type_hints

from msgspec import Struct, defstruct, field

from kurbel.reading.toml_file import MOST_BITS, Fault, about

ONE: Mapping[str, Any] = {"type": ["string", "number"]}


class Several(tuple[str, ...]):
    """One value or several, as they would be typed."""

    MUST = 'text such as "600mm", a number or a list'
    SCHEMA: ClassVar[Mapping[str, Any]] = {"anyOf": [ONE, {"type": "array", "items": ONE, "minItems": 1}]}

    @classmethod
    def read(cls, given: Any, _: str) -> Several:
        values = given if isinstance(given, list) else [given]
        if not values or not all(map(_is_value, values)):
            raise Fault(cls.MUST)
        if len(values) > 1 and issubclass(cls, One):
            raise Fault("one value")
        return cls(map(str, values))


class One(Several):
    """One value."""

    MUST = 'text such as "600mm", a number'
    SCHEMA = ONE


class Joined(Several):
    """Several values, which their option takes in one text."""


class File(One):
    """A file beside the machine's."""

    @classmethod
    def read(cls, given: Any, name: str) -> Several:
        return _of_files(super().read(given, name))


class Files(Several):
    """Files beside the machine's."""

    @classmethod
    def read(cls, given: Any, name: str) -> Several:
        return _of_files(super().read(given, name))


def _of_files(names: Several) -> Several:
    if any("\0" in one for one in names):
        raise Fault("the name of a file, and none has a NUL in it")
    return names


def _is_value(given: Any) -> bool:
    if isinstance(given, bool) or not isinstance(given, str | int | float):
        return False
    return not isinstance(given, int) or given.bit_length() < MOST_BITS


class Section(Struct, forbid_unknown_fields=True):
    """A section of the file; an entry that is left out is None."""


class Crank(Section):
    ratio: Annotated[Several | None, about('crank ratio R:L, such as "1:5"')] = None
    stroke: Annotated[One | None, about('stroke 2R, such as "600mm"')] = None
    crank: Annotated[One | None, about('or crank radius R, such as "300mm"')] = field(
        name="radius", default=None
    )
    true_stroke: Annotated[One | None, about("or the way of the piston of an offset crank")] = None
    time_ratio: Annotated[One | None, about("with that, the time of the outstroke over the return's")] = None
    rod: Annotated[One | None, about('length of the rod, such as "1500mm"')] = None
    speed: Annotated[One | None, about('speed, such as "120/min"')] = None
    offset: Annotated[One | None, about("offset e as a share of R, or a length")] = None
    mechanism: Annotated[One | None, about('crank drive, such as "arc"; straight or offset by itself')] = None
    rocker: Annotated[One | None, about("length of the arc crank's rocker in units of R")] = None
    pivot: Annotated[One | None, about('its pivot along and across the slide, such as "5;6"')] = None
    circuit: Annotated[One | None, about("1 or -1, the two ways to assemble the arc crank's links")] = None
    beam: Annotated[One | None, about("arm of the beam engine's beam in units of R")] = None
    vertical: Annotated[bool | None, about("whether the cylinder stands above the shaft, for weights")] = None
    slope: Annotated[
        One | None, about("or by how many degrees the slide rises from the shaft to the cylinder")
    ] = None
    gravity: Annotated[One | None, about('acceleration of gravity, by itself "9.80665m/s²"')] = None
    efficiency: Annotated[One | None, about('mechanical efficiency, such as "85%"')] = None
    cranks: Annotated[Joined | None, about("angles in degrees by which several cranks follow the first")] = (
        field(name="angles", default=None)
    )


class Steam(Section):
    eps: Annotated[Several | None, about("expansion ratio ε")] = None
    back: Annotated[
        One | None, about("back pressure as a share of the steam pressure, or as a pressure above vacuum")
    ] = None
    exponent: Annotated[One | None, about("n of p Vⁿ = const.")] = None
    clearance: Annotated[One | None, about("clearance as a share of the swept volume")] = None
    pressure: Annotated[One | None, about('steam pressure before cut-off, such as "8bar"')] = None
    bore: Annotated[One | None, about('bore of the cylinder, such as "300mm"')] = None
    piston_rod: Annotated[One | None, about('diameter of the piston rod, such as "50mm"')] = None
    tail_rod: Annotated[One | None, about("that of a rod through the cover")] = None
    single_acting: Annotated[bool | None, about("whether steam works on the outstroke only")] = None
    diagram_factor: Annotated[One | None, about("area of the real card in that of the ideal one")] = None
    specific_volume: Annotated[
        One | None, about('specific volume of the steam before cut-off, such as "0.24 m3/kg"')
    ] = None
    card: Annotated[Files | None, about("indicator card, a CSV file beside this one")] = None
    other_side: Annotated[One | None, about("pressure on the other face of a single-acting piston")] = None


class Compressor(Section):
    pressure_ratio: Annotated[Several | None, about("pressure ratio p₂/p₁")] = None
    exponent: Annotated[One | None, about("n of p Vⁿ = const.")] = None
    clearance: Annotated[One | None, about("clearance as a share of the swept volume")] = None
    suction_loss: Annotated[One | None, about("loss of the suction valves, a share of p₁")] = None
    delivery_loss: Annotated[One | None, about("loss of the delivery valves, a share of p₂")] = None
    suction_pressure: Annotated[One | None, about('suction pressure p₁, such as "1bar"')] = None
    bore: Annotated[One | None, about('bore of the cylinder, such as "400mm"')] = None
    single_acting: Annotated[bool | None, about("whether one end compresses only")] = None
    other_side: Annotated[One | None, about("pressure on the other face of a single-acting piston")] = None


class Pump(Section):
    pump: Annotated[One, about("double, single or differential")] = field(
        name="kind", default=One(("double",))
    )
    suction_pressure: Annotated[
        One | None, about('suction pressure above that on the other face, such as "-0.3bar"')
    ] = None
    delivery_pressure: Annotated[
        One | None, about('delivery pressure above that on the other face, such as "6bar"')
    ] = None
    small_area: Annotated[One | None, about("ring of a differential pump, a share of the piston's area")] = (
        None
    )
    bore: Annotated[One | None, about('bore of the cylinder, such as "200mm"')] = None


class Gas(Section):
    compression: Annotated[Several | None, about("compression ratio")] = None
    cycle: Annotated[One | None, about("otto, diesel or dual")] = None
    peak_pressure: Annotated[One | None, about("greatest pressure in suction pressures")] = None
    cut_off: Annotated[One | None, about("volume when the heat is supplied, in least volumes")] = None
    heat: Annotated[One | None, about("heat supplied in R T₁, for a kilogram")] = None
    exponent: Annotated[One | None, about("n of p Vⁿ = const.")] = None
    expansion_exponent: Annotated[One | None, about("n of the expansion where it is another")] = None
    exhaust_pressure: Annotated[One | None, about("exhaust pressure in suction pressures")] = None
    two_stroke: Annotated[bool | None, about("whether the cycle has two strokes")] = None
    suction_pressure: Annotated[One | None, about('suction pressure p₁, such as "1bar"')] = None
    bore: Annotated[One | None, about('bore of the cylinder, such as "200mm"')] = None


class Masses(Section):
    reciprocating: Annotated[One | None, about('mass of piston and crosshead, such as "300kg"')] = None
    rod_mass: Annotated[One | None, about('mass of the connecting rod, such as "150kg"')] = field(
        name="rod", default=None
    )
    centre: Annotated[
        One | None, about("its centre of mass from the crosshead pin, in rod lengths or a length")
    ] = None
    gyration: Annotated[
        One | None, about("its radius of gyration about that, in rod lengths or a length")
    ] = None
    pendulum: Annotated[One | None, about('or the time of a full swing about a pin, such as "1.8s"')] = None
    pendulum_from: Annotated[One | None, about("that pin: crosshead or crank")] = None
    friction: Annotated[One | None, about('friction of piston and crosshead, such as "500N"')] = None
    rotating: Annotated[One | None, about("mass of the crank itself at its pin, less counterweights")] = None
    rocker_inertia: Annotated[
        One | None, about('moment of inertia of a rocker about its pivot, such as "20kg m²"')
    ] = field(name="rocker", default=None)
    rod_file: Annotated[File | None, about("its masses, a CSV file beside this one")] = field(
        name="file", default=None
    )


class Flywheel(Section):
    power: Annotated[One | None, about('power, such as "50kW"')] = None
    delta: Annotated[Several | None, about('degree of irregularity to keep, such as "1:100"')] = None
    radius: Annotated[One | None, about("radius at which the mass of the rim is wanted")] = None
    flywheel: Annotated[One | None, about("the flywheel itself, by its number m₁v₁²/(P r)")] = field(
        name="number", default=None
    )
    inertia: Annotated[One | None, about('or by its moment of inertia, such as "1200kgm2"')] = None
    resistance: Annotated[One | None, about("torque that it turns against: constant or square")] = None
    mass: Annotated[One | None, about('mass, which with the radius makes the inertia, such as "6.5t"')] = None
    rim_diameter: Annotated[One | None, about('mean diameter of the rim, such as "2m"')] = None
    rim_section: Annotated[One | None, about('breadth to thickness, "2:1", or both, "400mm x 200mm"')] = None
    rim_breadth: Annotated[One | None, about("breadth of the rim, along the shaft")] = None
    rim_thickness: Annotated[One | None, about("thickness of the rim, along the radius")] = None
    rim_share: Annotated[One | None, about("share of the rim in the moment of inertia")] = None
    density: Annotated[One | None, about('density of rim or disc, such as "7200kg/m³"')] = None
    hoop_stress: Annotated[One | None, about('hoop stress that the rim may have, such as "6MPa"')] = None
    disc_diameter: Annotated[One | None, about("diameter of a solid disc")] = None
    disc_thickness: Annotated[One | None, about("its thickness")] = None


# What all cylinders have in common, or what is another thing in a cylinder's table.
_OF_ALL = (
    *("speed", "cranks", "pump", "vertical", "slope", "gravity"),
    *("efficiency", "diagram_factor", "specific_volume"),
)
_ONE = One | None


def _of_cylinders() -> Iterator[tuple[str, Any, None]]:
    """Yield the entries of a cylinder: what sets its place, and those of all sections about one."""
    yield "angle", Annotated[_ONE, about("angle in degrees by which its crank follows the first")], None
    yield "bank", Annotated[_ONE, about("angle by which its axis leans, in the sense of rotation")], None
    yield "fires", Annotated[_ONE, about("its place in the firing order, 1 for the first")], None
    yield "pump", Annotated[_ONE, about("double, single or differential, of a pump")], None
    seen = dict.fromkeys(_OF_ALL)
    for section in (Crank, Steam, Compressor, Pump, Gas, Masses):
        for name, kind in get_type_hints(section, include_extras=True).items():
            if name not in seen:
                seen[name] = None
                yield name, kind, None


if TYPE_CHECKING:

    class Cylinder(Section):
        """A cylinder of an engine: its entries are those of the sections, which all others share."""
else:
    Cylinder = defstruct("Cylinder", [*_of_cylinders()], bases=(Section,), module=__name__)


class Machine(Section):
    NOUN: ClassVar = "section"

    crank: Crank | None = None
    steam: Steam | None = None
    compressor: Compressor | None = None
    pump: Pump | None = None
    gas: Gas | None = None
    masses: Masses | None = None
    flywheel: Flywheel | None = None
    cylinder: tuple[Cylinder, ...] | None = None


# What acts on the piston.
LOADS = ("steam", "compressor", "pump", "gas")
SECTIONS: Mapping[str, type[Section]] = {
    "crank": Crank,
    "steam": Steam,
    "compressor": Compressor,
    "pump": Pump,
    "gas": Gas,
    "masses": Masses,
    "flywheel": Flywheel,
}
