"""Options that say nothing of the power of a cylinder, each refused with what would help."""

from collections.abc import Mapping
from typing import Any

from kurbel.commands.loads import OWN, PARTS
from kurbel.commands.machines import cards_of
from kurbel.commands.options import is_given

# What makes a power of the mean pressure.
SIZES = ("power", "brake_power", "bore", "stroke", "speed", "stroke_bore", "piston_speed")
# What tells how much steam is taken.
OF_STEAM = ("specific_volume", "steam_density")
# What describes a load further than its mean pressure.
OF_LOADS = ("pressure", "exponent", "clearance", "single_acting", "other_side", *PARTS)


def _steam(name: str) -> str:
    return f"--{name} is for the steam that an ideal card takes; add --eps"


def _over_angle(values: Mapping[str, Any]) -> bool:
    return any(hasattr(load.card, "angles") for load in cards_of(values))


def needless(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse what says nothing of the load that is given."""
    refused: dict[str, str] = {}
    if values["eps"] is None or not is_given(values["eps"]):
        refused |= {name: _steam(name.replace("_", "-")) for name in OF_STEAM}
        refused["back"] = "--back is that of steam; add --eps"
    if not is_given(values["card"]):
        refused["ratio"] = (
            "--ratio is for an indicator card over the crank angle, --card; the work of a stroke does not"
            " depend on it"
        )
    else:
        if values["pressure"] is not None:
            refused["pressure"] = "an indicator card has its own pressures; leave --pressure out"
        if is_given(values["ratio"]) and not _over_angle(values):
            refused["ratio"] = (
                "--ratio is for a card over the crank angle, and this one is over the stroke; leave it out"
            )
    if values["mean_pressure"] is None:
        refused["working_strokes"] = "--working-strokes is for --mean-pressure; other loads say it themselves"
    elif not any(is_given(values[key]) for key in OWN):
        why = "says what a mean pressure follows from, and --mean-pressure gives that itself; leave it out"
        refused |= {name: f"--{name.replace('_', '-')} {why}" for name in OF_LOADS}
        counted = "is counted by --working-strokes where --mean-pressure is given; leave it out"
        refused |= {name: f"--{name.replace('_', '-')} {counted}" for name in ("single_acting", "two_stroke")}
    if is_given(values["pump"]) and values["delivery_pressure"] is None:
        refused["suction_pressure"] = (
            "--suction-pressure of a pump is taken off what it delivers; add --delivery-pressure"
        )
    if not any(is_given(values[name]) for name in ("pressure", *SIZES)):
        why = "is for the steam taken, and nothing tells how much; add --pressure, or bore, stroke and speed"
        refused |= {name: f"--{name.replace('_', '-')} {why}" for name in OF_STEAM if name not in refused}
    if not any(is_given(values[name]) for name in SIZES):
        why = "is for the power, and nothing tells it; add --bore, --stroke and --speed, or --power"
        refused |= {name: f"--{name} {why}" for name in ("cylinders", "cranks")}
    return refused
