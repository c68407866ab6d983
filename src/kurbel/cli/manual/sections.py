"""The sections of a command's help: which option stands under which head, the most used first.

What another command calls by the same name has the name of its command before it: "plot.positions".
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TypeGuard

import click

ASKED = "What is asked"
CRANK = "The crank"
LOAD = "The load"
CYLINDERS = "Several cylinders"
POWER = "Power and work"
WHEEL = "The flywheel"
PRESS = "A press"
ROTOR = "The masses of the rotor"
BALANCING = "What balances"
PAGE = "The page"

SECTIONS: Mapping[str, str] = {
    ASKED: "forces turning polar pressures plot.positions point where unknown quantity orders order intervals"
    " at of detail exact csv only strict sources over infinite table steps",
    CRANK: "ratio stroke rod speed machine method table.order plot.order solve.order mechanism offset"
    " crank true_stroke time_ratio acceleration rocker pivot circuit beam axles driven",
    "The crank angles": "angle step from to zero shares",
    LOAD: "force eps bore pressure back card clearance exponent single_acting other_side",
    "A compressor, a pump or a gas engine": "pressure_ratio suction_pressure suction_loss delivery_loss pump"
    " delivery_pressure small_area compression cycle peak_pressure heat cut_off expansion_exponent"
    " exhaust_pressure two_stroke",
    POWER: "power mean_pressure working_strokes brake_power efficiency stroke_bore piston_speed"
    " diagram_factor specific_volume steam_density",
    WHEEL: "delta flywheel inertia resistance mass radius rim_diameter rim_speed rim_section rim_breadth"
    " rim_thickness density hoop_stress rim_share disc_diameter disc_thickness swing energy_fluctuation"
    " greatest_speed least_speed",
    PRESS: "work flywheel.strokes flywheel.share duration hole shear_energy shear_strength",
    "A diagram without an engine": "torque torque_file triangles areas area_scale load_torque"
    " load_torque_file turns",
    CYLINDERS: "engine cranks positions banks cylinder cylinders spacing about firing.strokes",
    ROTOR: "masses radii angles planes bearings rotor.about rotor.speed",
    "The locomotive": "locomotive.cranks locomotive.spacing locomotive.positions locomotive.stroke"
    " locomotive.crank gauge locomotive.speed velocity wheel wheel_load hammer_blow locomotive.axles",
    BALANCING: "share balance_planes balance_radii balance_radius revolving_share",
    "Masses and weight": "reciprocating rod_mass centre gyration rod_file pendulum pendulum_from rotating"
    " revolving rocker_inertia vertical slope gravity",
    "Pressures and friction": "head_pressure crank_pressure pressure_difference piston_rod tail_rod friction"
    " pin_friction crosshead_pin crank_pin shaft",
    PAGE: "lang layout columns units decimal digits rounding caption note source label layouts templates"
    " width height animate seconds",
    "The output": "output format interactive standalone longtable siunitx excel text help",
}
# The section that a command begins with, where it is not the first of these.
LEADING: Mapping[str, str] = {
    **dict.fromkeys(("table", "forces", "inertia", "harmonics"), CRANK),
    **dict.fromkeys(("delta", "turning", "pressures"), LOAD),
    "power": POWER,
    "flywheel": WHEEL,
    "balance": CYLINDERS,
    "rotor": ROTOR,
    "locomotive": BALANCING,
}


def sections(command: click.Command) -> Iterator[tuple[str, Sequence[click.Option]]]:
    """Yield the heads of a command's help with the options below them."""
    options = {_name(one): one for one in command.get_params(click.Context(command)) if _is_option(one)}
    own: Mapping[str, str] = getattr(command, "sections", {})
    further = {one for listed in own.values() for one in listed.split()}
    for title in sorted(SECTIONS, key=lambda one: one != LEADING.get(command.name or "")):
        listed = [name for name in names(title, command.name or "") if name not in further]
        listed += own.get(title, "").split()
        if found := [options[name] for name in listed if name in options]:
            yield title, found
    for title in set(own).difference(SECTIONS):
        yield title, [options[name] for name in own[title].split()]


def titled(params: Sequence[click.Parameter], heads: Mapping[str, str]) -> Mapping[str, list[click.Option]]:
    """Return options below their heads."""
    options = {_name(one): one for one in params if _is_option(one)}
    found = {
        title: [options[name] for name in listed.split() if name in options]
        for title, listed in heads.items()
    }
    return {title: listed for title, listed in found.items() if listed}


def _is_option(one: click.Parameter) -> TypeGuard[click.Option]:
    return isinstance(one, click.Option)


def _name(option: click.Option) -> str:
    # What click calls its own is another word in other versions.
    return "help" if "--help" in option.opts else option.name or ""


def names(title: str, command: str) -> Iterator[str]:
    """Yield the names of the options below a head of the command's help."""
    others = {one for own, listed in SECTIONS.items() if own != title for one in listed.split()}
    for name in SECTIONS[title].split():
        of, _, own = name.rpartition(".")
        if of == command or (not of and f"{command}.{name}" not in others):
            yield own
