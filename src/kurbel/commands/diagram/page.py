"""What `turning` asks for where a turning-moment diagram is given in place of an engine."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from kurbel.commands.diagram.given import DRIVES, LOADS, areas_of, excess_of
from kurbel.commands.old_motion import STEP
from kurbel.commands.options import is_given
from kurbel.commands.parameters import Names, Sheet
from kurbel.errors import ProblemError
from kurbel.page.layouts import layout_of
from kurbel.page.subject import Question
from kurbel.reading import notation
from kurbel.reading.given import as_angle, as_angles, as_crank_angles, as_inertia, as_names, as_speed

PAGES = ("torques", "areas")
EXAMPLE = "phi,excess_energy"


def diagram_asked(given: Mapping[str, Any], columns: Names) -> Question:
    """Return what is asked for of the diagram that options describe. Raises KurbelError."""
    from kurbel.engine.diagram.page import AreasRequest, TorquesRequest

    of_areas = is_given(given["areas"]) or given["layout"] == "areas"
    page = layout_of(given["layout"] or PAGES[of_areas], PAGES[of_areas:][:1], given["layouts"])
    about: dict[str, Any] = {
        "layout": page,
        **_wheel(given),
        "columns": as_names(columns, "point,excess_energy" if of_areas else EXAMPLE),
        **{name: given[name] for name in Sheet.__annotations__},
    }
    if of_areas:
        for name in ("angle", "step"):
            if is_given(given[name]):
                raise ProblemError(f"--{name} is of crank angles, which areas do not have; leave it out")
        return AreasRequest(areas=areas_of(given), **about)
    excess = excess_of(given)
    return TorquesRequest(excess=excess, angles=angles_of(given, excess.cycle), **_of_torques(given), **about)


def _of_torques(given: Mapping[str, Any]) -> dict[str, Any]:
    """Return what was not given of both torques, and the cranks."""
    driven, loaded = (any(is_given(given[name]) for name in names) for names in (DRIVES, LOADS))
    return {
        "constant": "" if driven and loaded else "load" if driven else "drive",
        "cranks": as_crank_angles(given["cranks"]) if is_given(given["cranks"]) else (),
    }


def _wheel(given: Mapping[str, Any]) -> dict[str, Any]:
    """Return the flywheel and its speed, as far as they are known."""
    return {
        "inertia": None if given["inertia"] is None else as_inertia(given["inertia"], "moment of inertia"),
        "speed": None if given["speed"] is None else as_speed(given["speed"]),
    }


def angles_of(given: Mapping[str, Any], cycle: Fraction) -> Sequence[Fraction]:
    """Return the crank angles of a page, by themselves over the whole cycle."""
    if given["angle"] is not None and given["step"] is not None:
        raise ProblemError("--angle lists the angles and --step runs through the turn; use one or the other")
    if given["angle"] is not None:
        return as_angles(given["angle"])
    step = STEP if given["step"] is None else as_angle(given["step"], "step")
    return notation.progression(Fraction(0), cycle, min(step, cycle) if given["step"] is None else step)
