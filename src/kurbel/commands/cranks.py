"""The crank drives that options describe, and the crank angles: for all commands that have them."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from kurbel.drive.crank import Crank
from kurbel.errors import NotationError, ProblemError
from kurbel.page.layouts import Folder, Layout, layout_of
from kurbel.reading import notation, units
from kurbel.reading.given import (
    Exact,
    as_angle,
    as_angles,
    as_fraction,
    as_length,
    as_number,
    as_ratios,
    as_speed,
)

if TYPE_CHECKING:
    from kurbel.commands.parameters import Given
    from kurbel.linkage.arc import ArcCrank

FULL_TURN = Fraction(360)
STEP = Fraction(10)


class Mechanism(NamedTuple):
    """A crank drive: what its pages are about, their default layout, the options that describe it alone."""

    subject: str
    layout: str
    takes: tuple[str, ...]


_SLIDE = ("ratio", "stroke", "rod", "speed", "method")
MECHANISMS = {
    "straight": Mechanism("motion", "kinematics", _SLIDE),
    "offset": Mechanism("motion", "kinematics", (*_SLIDE, "offset")),
    "arc": Mechanism("arc crank", "arc", ("ratio", "offset", "rocker", "pivot", "method")),
    "parallel": Mechanism("parallel crank", "parallel", ()),
}
# The crank drives without a crosshead.
LINKAGES = tuple(name for name, one in MECHANISMS.items() if one.subject != "motion")
_LENGTHS = ("stroke", "rod", "speed")


def mechanism_of(
    mechanism: str | None, offset: Exact | None, layout: str | None = None, layouts: Folder | None = None
) -> str:
    """Return which crank drive is meant: where it is not said, by the layout, else by the offset."""
    if mechanism:
        return mechanism
    if layout is not None:
        subject = layout_of(layout, [one.subject for one in MECHANISMS.values()], layouts).subject
        fitting = [name for name, one in MECHANISMS.items() if one.subject == subject]
        if len(fitting) == 1:
            return fitting[0]
    return "straight" if offset is None else "offset"


def of_other_mechanisms(name: str, shared: Collection[str] = ()) -> dict[str, str]:
    """Return the options that describe other crank drives alone, each with the sentence that refuses it;
    those that all of them share in a command are not among them."""
    refused = {}
    for option in {option: None for one in MECHANISMS.values() for option in one.takes}:
        takers = [other for other, one in MECHANISMS.items() if option in one.takes]
        if name not in takers and option not in shared:
            unit = ", whose page is in units of R and v" if option in _LENGTHS else ""
            others = " or ".join(filter(None, (", ".join(takers[:-1]), takers[-1])))
            refused[option] = (
                f"--{option} does not belong to the {name} crank{unit}; it is for --mechanism {others}"
            )
    return refused


def check_needed(name: str, offset: Exact | None, rocker: Exact | None) -> None:
    """Raise ProblemError for a crank drive without what makes it one."""
    if name == "offset" and offset is None:
        raise ProblemError("the offset crank needs the offset e; add --offset, for example --offset 0.5")
    if name == "arc" and rocker is None:
        raise ProblemError(
            "the arc crank needs the length of its rocker; add --rocker, for example --rocker 6"
        )


def cranks_of(
    page: Layout,
    ratio: Given | None,
    stroke: Exact | None,
    rod: Exact | None,
    offset: Exact | None = None,
    speed: Exact | None = None,
    *,
    method: str | None = None,
    force: Fraction | None = None,
) -> tuple[Crank, ...]:
    """Return the cranks that these describe, of the layout's ratios if nothing gives one."""
    if ratio is not None and stroke is not None and rod is not None:
        raise ProblemError("--stroke and --rod already give the ratio; leave --ratio out")
    if method == "infinite" and rod is not None and stroke is None:
        raise ProblemError("--rod gives the rod a length, but --method infinite takes none; use --stroke")
    radius = radius_of(stroke)
    length = None if rod is None else as_length(rod, "rod")
    if length is not None and length <= 0:
        raise ProblemError(f"the length of the rod is {notation.about(length)} m; it must be above 0")
    if radius is not None and length is not None:
        values: Sequence[Fraction] = (radius / length,)
    else:
        values = ratios_of(page, ratio)
        if length is not None and 0 in values:
            raise ProblemError(
                "--rod gives the rod a length, but ratio 1:∞ asks for an infinite one; leave one out"
            )
    turns = None if speed is None else as_speed(speed)
    return tuple(
        Crank(value, _offset(offset, size), size, turns, force)
        for value in values
        for size in [length * value if length is not None and radius is None else radius]
    )


def ratios_of(page: Layout, ratio: Given | None) -> tuple[Fraction, ...]:
    """Return the crank ratios, or the layout's own."""
    return as_ratios(page.ratios if ratio is None else ratio)


def _offset(value: Exact | None, radius: Fraction | None) -> Fraction:
    """e/R from a share of R or a length, which may be negative."""
    if value is None:
        return Fraction(0)
    if not isinstance(value, str):
        return as_fraction(value)
    share = value.strip().removesuffix("R")
    if not units.is_measure(share):
        return notation.number(share, "offset")
    displacement = units.displacement(value, "offset")
    if radius is None:
        raise NotationError(
            f'offset "{value[:40]}" is a length, but no length of the crank is known;'
            " add --stroke or give e as a share of R"
        )
    return displacement / radius


def arc_cranks(
    page: Layout,
    ratio: Given | None,
    offset: Exact | None,
    rocker: Exact | None,
    pivot: str | tuple[Exact, Exact] | None,
    method: str | None,
    stroke: Exact | None = None,
    force: Fraction | None = None,
) -> tuple[ArcCrank, ...]:
    """Return the arc cranks that these describe, of the layout's ratios if none are there."""
    from kurbel.linkage.arc import ArcCrank

    if method not in (None, "exact"):
        raise ProblemError(
            f'method "{method}" has no formulas for the arc crank; use exact,'
            " with --ratio 1:∞ for the infinite rod"
        )
    check_needed("arc", offset, rocker)
    assert rocker is not None
    across = Fraction(0) if offset is None else _radii(offset, "offset")
    arm, places = _radii(rocker, "rocker"), _pivot(pivot)
    radius = radius_of(stroke)
    return tuple(
        ArcCrank(Crank(value, across, radius, force=force), arm, *places) for value in ratios_of(page, ratio)
    )


def radius_of(stroke: Exact | None) -> Fraction | None:
    """Return R in metres of 2R."""
    return None if stroke is None else as_length(stroke, "stroke") / 2


def _pivot(given: str | tuple[Exact, Exact] | None) -> tuple[Fraction, Fraction] | tuple[()]:
    """D and H from "5;6" or a pair."""
    if given is None:
        return ()
    parts = given.split(";") if isinstance(given, str) else given
    if not isinstance(parts, Sequence) or len(parts) != 2:
        raise NotationError(
            f'pivot "{str(given)[:40]}" is not a place; write its distance from the shaft along and across'
            " the slide in units of R as D;H, for example 5;6"
        )
    distance, height = (_radii(part, "pivot") for part in parts)
    return distance, height


def _radii(value: Exact, what: str) -> Fraction:
    """A length in units of R: 6, 6R."""
    if not isinstance(value, str):
        return as_fraction(value)
    share = value.strip().removesuffix("R")
    if units.is_measure(share):
        raise NotationError(
            f'{what} "{value[:40]}" has a unit; lengths of the arc crank are in units of R, for example 6'
        )
    return as_number(share, what)


def angles_of(
    page: Layout, angle: Given | None, start: Exact | None, stop: Exact | None, step: Exact | None
) -> Sequence[Fraction]:
    """Return the angles that are listed, or those of a run, or the layout's own."""
    if start is None and stop is None and step is None:
        return as_angles(page.angles if angle is None else angle)
    if angle is not None:
        raise ProblemError(
            "--angle lists the angles and --from, --to, --step run through them; use one or the other"
        )
    first, last = ends_of(start, stop)
    if step is not None:
        return notation.progression(first, last, as_angle(step, "step"))
    return notation.progression(first, last, min(STEP, last - first) if last > first else STEP)


def ends_of(start: Exact | None, stop: Exact | None) -> tuple[Fraction, Fraction]:
    """Return the first and the last angle, by default those of the whole turn."""
    first = Fraction(0) if start is None else as_angle(start, "first angle")
    return first, FULL_TURN if stop is None else as_angle(stop, "last angle")
