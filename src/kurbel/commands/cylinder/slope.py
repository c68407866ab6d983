"""The slope of the cylinder, by which the moving masses have a weight, as options describe it."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Annotated, Any, TypedDict

from kurbel.commands.options import FLAG, Option, is_given
from kurbel.errors import ProblemError
from kurbel.reading.given import Exact, as_angle, as_gravity

if TYPE_CHECKING:
    from kurbel.drive.slope import Slope

LYING = ("vertical", "slope", "gravity")


class Lying(TypedDict, total=False):
    """How the cylinder stands."""

    vertical: Annotated[
        bool,
        Option(
            "The cylinder stands above the shaft: piston, crosshead and rod have a weight.",
            kind=FLAG, default=False,
        ),
    ]  # fmt: skip
    slope: Annotated[
        Exact | None,
        Option(
            "Angle by which the slide rises from the shaft to the cylinder: 30; 90 is --vertical, -90 below"
            " the shaft. It counts in the sense of rotation: 180-30 with the crank pin below on the"
            " outstroke.",
            "ANGLE", unit="degrees",
        ),
    ]  # fmt: skip
    gravity: Annotated[
        Exact | None,
        Option(
            "Acceleration of gravity, for the weight: 9.81; default 9.80665m/s².", "G", unit="m/s²"
        ),
    ]  # fmt: skip


def slope_of(given: Mapping[str, Any]) -> "Slope | None":
    """Return how the slide rises, None where weight does not count; a cylinder of several leans by its
    `bank` from that."""
    if not is_given(given.get("vertical")) and given.get("slope") is None:
        return None
    from kurbel.drive.slope import STANDARD_GRAVITY, VERTICAL, Slope

    angle = VERTICAL if given.get("slope") is None else as_angle(given["slope"], "slope")
    if is_given(given.get("vertical")) and angle != VERTICAL:
        raise ProblemError(
            f"--vertical is a slope of 90, and --slope says {given['slope']}; leave one of the two out"
        )
    gravity = given.get("gravity")
    found = Slope(angle, STANDARD_GRAVITY if gravity is None else as_gravity(gravity))
    lean = as_angle(given.get("bank") or 0, "bank")
    return Slope((angle + lean + 180) % 360 - 180, found.gravity) if lean else found


def needless_of_slope(values: Mapping[str, Any], heavy: bool) -> Mapping[str, str]:
    """Return what says something of a weight where nothing has one, with the sentences that refuse it."""
    if not heavy:
        why = "is for the weight of moving masses; add --reciprocating or a rod, --rod-mass"
        return {name: f"--{name} {why}" for name in LYING}
    # By gravity a rod that swings tells its radius of gyration, too.
    if any(is_given(values.get(name)) for name in ("vertical", "slope", "pendulum")):
        return {}
    return {"gravity": "--gravity is for weights; add --vertical or --slope, by which the cylinder stands"}


def check_crosshead(chosen: Any, slope: "Slope | None") -> None:
    """Raise ProblemError for a weight in a drive of which it is not computed."""
    if slope is not None and not chosen.crosshead:
        raise ProblemError(
            f"{chosen.title} with the weight of its masses is not computed, for its rocker or axles have"
            " weights that are not given; leave --vertical and --slope out"
        )
