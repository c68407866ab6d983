"""The masses of cylinders that are not alike, and where these lie, as they are given."""

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Annotated, Any, TypedDict

from kurbel.commands import parameters as option
from kurbel.commands.options import Option, is_given
from kurbel.drive.crank import known
from kurbel.errors import ProblemError
from kurbel.reading.given import Exact, as_length, as_number, as_places, as_share
from kurbel.reading.measures import as_measures

if TYPE_CHECKING:
    from kurbel.drive.crank import Crank


class Revolving(TypedDict, total=False):
    """Masses that turn with the cranks, and their counterweights."""

    revolving: Annotated[
        option.Given | None,
        Option(
            "Mass that turns with each crank at its radius: 1.5kg, or '1.5;2kg'; default: balanced apart.",
            "MASSES", unit="kg",
        ),
    ]  # fmt: skip
    revolving_share: Annotated[
        Exact | None,
        Option("Share of it that counterweights balance: 1, 50%; default 0.", "SHARE"),
    ]
    balance_radius: Annotated[
        Exact | None,
        Option("Radius of the counterweights, for their masses: 300mm.", "LENGTH", unit="m"),
    ]


def needless_of_revolving(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Return the sentences that refuse what says nothing without its masses."""
    if not is_given(values["reciprocating"]) and not is_given(values.get("rod_mass")):
        why = "is for moving masses; add --reciprocating, or take kurbel rotor for masses that only turn"
        return {name: f"--{name.replace('_', '-')} {why}" for name in Revolving.__annotations__}
    refused = {}
    if not is_given(values["revolving"]):
        refused["revolving_share"] = "--revolving-share is of --revolving; add that"
    if values["revolving_share"] is None and not as_share(values["share"]):
        refused["balance_radius"] = (
            "--balance-radius is that of counterweights, which balance a share of the masses; add --share 0.5"
            " or --revolving-share 1"
        )
    return refused


def check_known(given: Mapping[str, Any]) -> None:
    """Raise ProblemError for what is asked for by a ?, with the command that finds it."""
    for name in ("cranks", "positions", "reciprocating"):
        value = given[name]
        if isinstance(value, str | Sequence) and any("?" in str(one) for one in value):
            raise ProblemError(
                f"--{name} has a ?, which kurbel rotor finds: in the first order masses that go to and fro"
                " balance like masses at their cranks; give them there as --masses, --radii, --angles and"
                " --planes, then here what was found"
            )


def reciprocating_of(given: Mapping[str, Any]) -> tuple[Fraction, ...]:
    """Return the masses of piston and crosshead in kg: none, one of all cylinders, or one of each."""
    masses = given["reciprocating"]
    return () if masses is None else as_measures(masses, "mass", "reciprocating mass")


def unlike(crank: "Crank", masses: tuple[Fraction, ...], given: Mapping[str, Any]) -> dict[str, Any]:
    """Return what sets cylinders apart from the one whose crank this is, as `Weighed` takes it."""
    joined = known(crank.moving).joined
    found: dict[str, Any] = {}
    if len(masses) > 1:
        share = joined.crosshead - masses[0]
        found["each"] = tuple(mass + share for mass in masses)
    if given["revolving"] is not None:
        turning = as_measures(given["revolving"], "mass", "revolving mass")
        found["revolving"] = tuple(mass + joined.pin for mass in turning)
    if given["revolving_share"] is not None:
        found["revolving_share"] = as_share(given["revolving_share"], "revolving share")
    if given["balance_radius"] is not None:
        found["balance_radius"] = as_length(given["balance_radius"], "balance radius")
    return found


def positions_of(positions: option.Given | None) -> tuple[tuple[Fraction, ...], bool]:
    """Return the positions, and whether they were given as lengths and are in metres."""
    from kurbel.reading.units import is_measure

    if positions is None:
        return (), False
    if isinstance(positions, str):
        parts: list[Any] = positions.split(";")
    else:
        parts = [*positions] if isinstance(positions, Iterable) else [positions]
    if any(isinstance(part, str) and is_measure(part) for part in parts):
        return as_measures(positions, "displacement", "position"), True
    return tuple(as_places(positions, "position")), False


def position_of(about: Exact, in_metres: bool) -> Fraction:
    """Return one position in the unit of the others."""
    if in_metres:
        (position,) = as_measures(about, "displacement", "about")
        return position
    if positions_of(about)[1]:
        raise ProblemError(f"--about {about} is a length, and the positions are numbers; give both alike")
    return as_number(about, "about")
