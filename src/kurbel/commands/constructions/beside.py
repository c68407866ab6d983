"""What some constructions take beside their drive, and how it is read: a point of the rod, masses, steam."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Annotated, Any

from kurbel.books.constructions.beside import ALONE, CENTRE, GYRATION, TAKEN, Beside
from kurbel.books.constructions.model import Construction
from kurbel.commands.options import Option
from kurbel.commands.parameters import EPS, Given
from kurbel.errors import ProblemError
from kurbel.exact.numerals import exact_text
from kurbel.reading.given import Exact, as_share_or_length
from kurbel.reading.notation import about

if TYPE_CHECKING:
    from kurbel.drive.rod import Rod
    from kurbel.engine.engine import Steam

# How far beyond its pins a rod is drawn, in its lengths.
FARTHEST = 1
UNKNOWN = "that of the rod is not known; add --stroke, or give a share of the rod's length"

Point = Annotated[
    Exact | None,
    Option(
        "Ensslin's Figs. 2 and 4: the point of the rod, in rod lengths from the crosshead pin: 0.5, 50%, or a"
        " length.",
        "SHARE",
    ),
]
Centre = Annotated[
    Exact | None,
    Option(
        "Ensslin's Figs. 5 to 7: centre of mass of the rod from the crosshead pin, in rod lengths; default:"
        " 0.65; or a length.",
        "A", unit="rod lengths",
    ),
]  # fmt: skip
Gyration = Annotated[
    Exact | None,
    Option(
        "Radius of gyration about it, in rod lengths; default: 0.35; or a length.", "K", unit="rod lengths"
    ),
]
Eps = Annotated[
    Given | None,
    EPS._replace(
        help="Radinger: expansion ratio, cut-off after 1/ε of the stroke: 4; default: a constant force."
    ),
]
Back = Annotated[
    Exact | None,
    Option("Back pressure as a share of the steam pressure: 0.1; default: the best.", "B"),
]


def foreign(shown: Construction) -> dict[str, str]:
    """Return what a construction does not take beside its drive, with the sentences that refuse it."""
    return {
        name: f"construction {shown.name} takes no --{name}; leave it out"
        for name in TAKEN
        if name not in shown.takes
    }


def read(given: Mapping[str, Any], drive: Any) -> Beside:
    """Return what is given beside the drive."""
    point, rod = ALONE.point, _rod(given, drive)
    if given["point"] is not None:
        point = _point(given["point"], drive)
        if not -FARTHEST <= point <= 1 + FARTHEST:
            raise ProblemError(
                f"the point of the rod is {about(point)} L from the crosshead pin; it must lie within -1..2,"
                " at most a rod's length beyond its pins"
            )
    return Beside(point, rod, _steam(given))


def _point(given: Exact, drive: Any) -> Fraction:
    from kurbel.motion.points.point import points_of

    points = points_of(given, [drive.crank])
    if len(points) != 1:
        raise ProblemError(f"a construction is of one point of the rod; {len(points)} are given")
    (point,) = points
    if point.beside:
        raise ProblemError(
            f"point {point.text} lies beside the axis of the rod, where Ensslin's figures have no point;"
            f" write {exact_text(point.share)}, or take kurbel table --point {point.text}"
        )
    return point.share


def _rod(given: Mapping[str, Any], drive: Any) -> Rod | None:
    centre, gyration = given["centre"], given["gyration"]
    if centre is None and gyration is None:
        return None
    from kurbel.drive.rod import Rod

    crank = drive.crank
    length = None if crank.radius is None else crank.radius / crank.ratio

    def share(value: Exact | None, what: str, usual: Fraction) -> Fraction:
        return usual if value is None else as_share_or_length(value, what, length, UNKNOWN)

    return Rod.from_crosshead(
        share(centre, "centre of mass", CENTRE), share(gyration, "radius of gyration", GYRATION)
    )


def _steam(given: Mapping[str, Any]) -> Steam | None:
    eps, back = given["eps"], given["back"]
    if eps is None:
        if back is not None:
            raise ProblemError("--back is for steam that expands; add its expansion ratio, such as --eps 4")
        return None
    from kurbel.engine.engine import Steam
    from kurbel.reading.given import as_expansions, as_share

    share = None if back is None else as_share(back, "back pressure")
    return Steam(_only(as_expansions(eps), "expansion ratio"), share)


def _only(values: Sequence[Fraction], what: str) -> Fraction:
    if len(values) != 1:
        raise ProblemError(f"a construction is of one {what}; {len(values)} are given")
    return values[0]
