"""The forces of a drive over the piston's path: which loads they are those of."""

from collections.abc import Mapping
from typing import Any

from kurbel.commands.cylinder.effort import rubbed
from kurbel.commands.machines import is_heavy, weighed
from kurbel.commands.over.path import over_path
from kurbel.drive.crank import Described
from kurbel.errors import ProblemError
from kurbel.motion.mechanism import Mechanism
from kurbel.page.layouts import Layout
from kurbel.page.subject import Question

PISTON = "piston"


def check_piston(about: str, values: Mapping[str, Any]) -> None:
    """Raise ProblemError for forces over the path that are not those of a piston force or of masses."""
    if about == "tangent":
        raise ProblemError("--at tangent is one position, with a path of its own; leave --over path out")
    if about != PISTON:
        raise ProblemError(
            "forces of an engine are not set over the path; kurbel pressures sets its pressures over the"
            " stroke, and --over-path -o forces.svg draws the forces over it"
        )
    if values["axles"] is not None:
        raise ProblemError("coupled axles have no piston; leave --axles or --over path out")


def loaded_path(chosen: Mechanism, said: Described, page: Layout, given: Mapping[str, Any]) -> Question:
    """Return what is asked for of the forces in drives that were described, with their masses."""
    if is_heavy(given) and not chosen.crosshead:
        raise ProblemError(
            f"forces of moving masses are not set over the path for {chosen.title}; print them over the turn,"
            " without --over"
        )
    drives = weighed(chosen, chosen.drives(said, page.ratios), given)
    return over_path(chosen, said, page, given, rubbed(chosen, drives, given))
