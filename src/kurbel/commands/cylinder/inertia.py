"""The forces of the moving rod alone, over the crank angle."""

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Annotated, Any, Unpack

from kurbel.commands import parameters as option
from kurbel.commands.cylinder import engines
from kurbel.commands.machines import check_whole, rod_of
from kurbel.commands.old_motion import angles_of, meant, of_other_mechanisms, over_strokes, sheet_of
from kurbel.commands.options import Option, is_given
from kurbel.commands.subject import makes_table
from kurbel.drive.crank import Described
from kurbel.errors import ProblemError
from kurbel.motion.mechanism import Mechanism
from kurbel.page.layouts import Layout, layout_of
from kurbel.page.subject import Question
from kurbel.reading.given import Exact, as_length, as_names, as_ratios, as_speed

MASSES = ("rod masses", "pin masses")
INERTIA, ROCKER_INERTIA = ("inertia", "inertia errors", *MASSES), "rocker inertia"


class Rods(option.Run, option.AnyDrive, engines.MovingRod, option.Sheet, total=False):
    """A crank drive with a moving rod."""

    layouts: option.Layouts
    gravity: Annotated[
        Exact | None,
        Option("Acceleration of gravity, for --pendulum: 9.81; default 9.80665m/s².", "G", unit="m/s²"),
    ]


def _of_rods(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse what describes other crank drives."""
    return of_other_mechanisms(values, _rod_drive(values), ("stroke", "speed"))


def _rod_drive(values: Mapping[str, Any]) -> Mechanism:
    """Return which crank drive is meant; raise ProblemError for one without a rod that swings."""
    chosen = meant(values, layout=None)
    if not (chosen.crosshead or "rocker_inertia" in chosen.takes):
        raise ProblemError(
            f"{chosen.title} has no rod that swings; its inertia is computed of the straight, offset and arc"
            " crank and of the beam engine"
        )
    return chosen


_MOVING = ("speed", "offset", "mechanism", "acceleration", "method")


def _at_rest(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse what says nothing about the masses that stand in for a rod."""
    layout = values["layout"]
    about = (*INERTIA, ROCKER_INERTIA)
    unswung = {}
    if values["pendulum"] is None:
        unswung["gravity"] = "--gravity is for the time of a swing; add --pendulum, or leave it out"
    if layout is None or layout_of(layout, about, values["layouts"]).subject not in MASSES:
        return unswung
    said = f"layout {layout} is of the rod by itself"
    refused = {name: f"{said}; leave --{name} out" for name in _MOVING}
    return {**unswung, **refused, **_lengthless(values, said)}


def _lengthless(values: Mapping[str, Any], said: str) -> Mapping[str, str]:
    """Refuse stroke and ratio where they do not make the length of the rod, both together or beside it."""
    known = values["rod"] is not None
    missing = {"ratio": "stroke", "stroke": "ratio"}
    return {
        name: f"{said}, whose length --rod gives; leave --{name} out"
        if known
        else f"{said}, whose length --stroke and --ratio give together; add --{other}, or leave --{name} out"
        for name, other in missing.items()
        if known or not is_given(values[other])
    }


@makes_table(
    foreign=_of_rods,
    needless=_at_rest,
    order="angle from_ to step zero columns offset stroke crank true_stroke"
    " time_ratio rod mechanism rocker pivot circuit beam"
    " rod_mass centre gyration rod_file speed acceleration method",
)
def inertia_table(
    ratio: option.Ratios = None,
    *,
    columns: Annotated[
        option.Names, option.columns_over_angle("inertia", "phi,inertia_guide,inertia_pin")
    ] = (),
    speed: Annotated[
        Exact | None,
        option.SPEED._replace(help="Speed, for columns in N and N m: 120/min, 12.5rad/s."),
    ] = None,
    acceleration: option.Acceleration = None,
    method: Annotated[str | None, option.FIRST_ORDER] = None,
    layout: Annotated[str | None, option.layout_option(*INERTIA, ROCKER_INERTIA)] = None,
    **given: Unpack[Rods],
) -> Question:
    """Print the forces that the moving rod calls up at guide and crank pin, and the torque.

    Exact, by two masses at the pins that keep the centre of mass, and by the railway rule, 6/10 of the mass
    rotating and 4/10 reciprocating. Layout inertia-errors has the greatest forces and errors of a turn,
    rod-masses the masses themselves, and those that are dynamically equivalent.

    \b
    kurbel inertia --ratio 1:5 --centre 0.65 --gyration 0.35
    kurbel inertia --rod-file rod.csv --stroke 600mm --speed 120/min
    kurbel inertia --centre 0.65 --gyration 0.35 --layout inertia-errors
    kurbel inertia --rod 500mm --centre 325mm --pendulum 1.3s --pendulum-from crosshead --layout rod-masses
    kurbel inertia --centre 0.65 --gyration 0.35 --mechanism arc --rocker 6
    \f
    >>> import kurbel
    >>> page = kurbel.inertia_table("1:5", centre=0.6, gyration=0.48, angle=90, columns="inertia_guide")
    >>> print(kurbel.typeset(page, "csv"), end="")
    inertia_guide
    0.0067
    """
    if not (chosen := _rod_drive(given)).crosshead:
        return _rocker_inertia(
            chosen, layout, Described.of(given, ratio=ratio, method=method), speed, columns, given
        )
    page = layout_of(layout or "inertia", INERTIA, given["layouts"])
    if page.subject in MASSES:
        return _masses(page, ratio, columns, given)
    said = Described.of(given, ratio=ratio, speed=speed, method=method, acceleration=acceleration)
    cranks = tuple(replace(crank, rod=rod_of(given, crank.rod_length)) for crank in said.cranks(page.ratios))
    if page.subject == "inertia errors":
        from kurbel.motion.inertia_page import ErrorsRequest

        check_whole(page, given)
        for name in (key for key in ("method", "acceleration") if getattr(said, key) is not None):
            raise ProblemError(
                f"layout {page.key} is of a whole even turn, by the exact formulas; leave --{name} out, or"
                " use --layout inertia"
            )
        names = as_names(columns, "greatest,error_percent")
        return ErrorsRequest(layout=page, cranks=cranks, columns=names, **sheet_of(given))
    from kurbel.motion.page import Request

    angles, names = angles_of(page, given), as_names(columns)
    question = Request(
        layout=page, cranks=cranks, angles=angles, columns=names, method=method, **sheet_of(given)
    )
    return over_strokes(question, given)


def _masses(
    page: Layout,
    ratio: option.Given | None,
    columns: option.Names,
    given: Mapping[str, Any],
) -> Question:
    """Return what is asked for of the masses that stand in for the rod, at rest."""
    from kurbel.motion.rod_masses import RodMassesRequest

    check_whole(page, given)
    length = _length(ratio, given)
    rod, names = rod_of(given, length), as_names(columns, "model,crosshead_mass")
    return RodMassesRequest(layout=page, rod=rod, length=length, columns=names, **sheet_of(given))


def _length(ratio: option.Given | None, given: Mapping[str, Any]) -> Fraction | None:
    """Return the length of the rod in metres, given or by the stroke and one ratio, None if not known."""
    if given["rod"] is not None:
        return as_length(given["rod"], "rod")
    ratios = () if ratio is None else as_ratios(ratio)
    if given["stroke"] is None or len(ratios) != 1 or not ratios[0]:
        return None
    return as_length(given["stroke"], "stroke") / 2 / ratios[0]


def _rocker_inertia(
    chosen: Mechanism,
    layout: str | None,
    said: Described,
    speed: Exact | None,
    columns: option.Names,
    given: Mapping[str, Any],
) -> Question:
    """Return what is asked for of the rod that moves a rocker."""
    from kurbel.linkage.arc.inertia import RockerInertiaRequest

    chosen.check(said)
    page = layout_of(layout or "inertia-rocker", (ROCKER_INERTIA,), given["layouts"])
    turns = None if speed is None else as_speed(speed)
    drives = []
    for drive in chosen.drives(said, page.ratios):
        crank = chosen.crank(drive)
        rod = rod_of(given, crank.rod_length)
        drives.append(drive.of(replace(crank, rod=rod, speed=turns)))
    angles, names = angles_of(page, given), as_names(columns, "phi,inertia_guide")
    for name in names:
        if name.startswith("inertia_mollier"):
            raise ProblemError(
                f"column {name} is a force along a slide, and {chosen.title} has none; leave it out"
            )
    return RockerInertiaRequest(
        layout=page, drives=tuple(drives), angles=angles, columns=names, **sheet_of(given)
    )
