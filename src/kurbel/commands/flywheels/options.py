"""The options of a flywheel without an engine: where its swing comes from, the flywheel, its rim."""

from typing import Annotated, TypedDict

from kurbel.commands.diagram.given import Diagram
from kurbel.commands.options import Option
from kurbel.reading.given import Exact

One = Exact | None


class Swing(TypedDict, total=False):
    """What the energy swing is known from."""

    swing: Annotated[
        One, Option("Energy swing, from the least speed to the greatest: 5kJ.", "ENERGY", unit="J")
    ]
    energy_fluctuation: Annotated[
        One, Option("The same as a share of the work of a cycle: 0.1, 10%.", "SHARE")
    ]
    work: Annotated[One, Option("Work of a cycle, of a press that of a stroke: 10kJ.", "ENERGY", unit="J")]


class Press(TypedDict, total=False):
    """A press, between whose strokes the motor makes good what they took of the flywheel."""

    strokes: Annotated[One, Option("Press: working strokes, 30/min.", "SPEED", unit="strokes a second")]
    share: Annotated[One, Option("Press: share of the cycle in which it works, 1/4; 0 for a blow.", "SHARE")]
    duration: Annotated[
        One, Option("Press: how long a stroke takes, in place of the share: 1s.", "TIME", unit="s")
    ]
    hole: Annotated[
        One,
        Option(
            "Press: diameter of the hole and thickness of the plate, whose work it does: '38mm x 32mm'.",
            "SIZES",
        ),
    ]
    shear_energy: Annotated[
        One, Option("Press: energy of a sheared area, for --hole: 7J/mm².", "ENERGY", unit="J/m²")
    ]
    shear_strength: Annotated[
        One,
        Option(
            "Press: strength of the plate, for --hole, whose work is ½ π d t² τ: 300MPa.", "STRESS", unit="Pa"
        ),
    ]
    efficiency: Annotated[
        One, Option("Press: efficiency from the motor, whose power is --power: 95%.", "SHARE")
    ]


class Body(TypedDict, total=False):
    """The flywheel itself, and how it turns."""

    greatest_speed: Annotated[
        One,
        Option("Greatest speed: 225/min; --speed 200..225/min has both.", "SPEED", unit="turns a second"),
    ]
    least_speed: Annotated[One, Option("Least speed: 200/min.", "SPEED", unit="turns a second")]
    inertia: Annotated[One, Option("Moment of inertia of the flywheel: 1200kgm2.", "J", unit="kg m²")]
    mass: Annotated[
        One,
        Option("Mass of the flywheel, which with --radius gives the inertia: 6.5t.", "MASS", unit="kg"),
    ]


class Rim(TypedDict, total=False):
    """The rim that makes the moment of inertia, or a disc."""

    rim_diameter: Annotated[One, Option("Mean diameter of the rim: 2m.", "LENGTH", unit="m")]
    rim_speed: Annotated[
        One,
        Option(
            "Speed of the rim at its mean diameter: 25m/s, or 26..28m/s; with δ its mass needs no --speed.",
            "VELOCITY",
            unit="m/s",
        ),
    ]
    rim_section: Annotated[
        One,
        Option("Section of the rim: breadth to thickness, 2:1, both, '400mm x 200mm', or 800cm².", "SECTION"),
    ]
    rim_breadth: Annotated[One, Option("Breadth of the rim, along the shaft: 300mm.", "LENGTH", unit="m")]
    rim_thickness: Annotated[
        One, Option("Thickness of the rim, along the radius: 150mm.", "LENGTH", unit="m")
    ]
    density: Annotated[One, Option("Density of rim or disc: 7200kg/m³.", "DENSITY", unit="kg/m³")]
    hoop_stress: Annotated[
        One,
        Option(
            "Hoop stress ρ v² that the rim may have: 6MPa; without --rim-diameter the greatest is found.",
            "STRESS", unit="Pa",
        ),
    ]  # fmt: skip
    rim_share: Annotated[
        One, Option("Share of the rim in the moment of inertia, beside arms and hub: 92%.", "SHARE")
    ]
    disc_diameter: Annotated[One, Option("Solid disc: its diameter, 600mm.", "LENGTH", unit="m")]
    disc_thickness: Annotated[One, Option("Solid disc: its thickness, 80mm.", "LENGTH", unit="m")]


class Wheel(Diagram, Swing, Press, Body, Rim, total=False):
    """A flywheel without an engine."""
