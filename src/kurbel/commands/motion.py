"""The crank drive that options describe, and the crank angles; the motion of the piston over them, and the
dead centres between which it goes."""

from collections.abc import Collection, Mapping, Sequence
from fractions import Fraction
from typing import Annotated, Any, Unpack

from kurbel.commands import parameters as option
from kurbel.commands.options import FLAG, Columns, Option, is_given
from kurbel.commands.parameters import Given, Sheet
from kurbel.commands.subject import makes_table
from kurbel.drive.crank import Described
from kurbel.drive.mechanisms import MECHANISMS, MOTIONS
from kurbel.errors import ProblemError
from kurbel.motion import mechanism as mechanisms
from kurbel.motion.mechanism import Mechanism
from kurbel.page.axes import shifted
from kurbel.page.layouts import Layout, layout_of
from kurbel.page.subject import Question
from kurbel.reading import notation
from kurbel.reading.given import as_angle, as_angles, as_names, as_numbers

HALF_TURN, FULL_TURN = Fraction(180), Fraction(360)
STEP = Fraction(10)


def meant(values: Mapping[str, Any], **instead: Any) -> Mechanism:
    """Return which crank drive options describe: where it is not said, by the layout, else by the offset."""
    values = {**values, **instead}
    mechanism, offset, layout = values["mechanism"], values["offset"], values.get("layout")
    if not mechanism and layout is not None:
        subject = layout_of(layout, MOTIONS, values["layouts"]).subject
        fitting = [name for name, one in MECHANISMS.items() if one.subject == subject]
        mechanism = fitting[0] if len(fitting) == 1 else None
    return mechanisms.mechanism(mechanism or ("straight" if offset is None else "offset"))


def described(given: Mapping[str, Any], **more: Any) -> tuple[Mechanism, Described]:
    """Return which crank drive options describe, and how; raise ProblemError if they do not say enough."""
    chosen, said = meant(given), Described.of(given, **more)
    chosen.check(said)
    return chosen, said


def sheet_of(given: Mapping[str, Any]) -> dict[str, Any]:
    """Return how the page is to be printed, and from where its angles count."""
    asked = {name: given[name] for name in Sheet.__annotations__ if name in given}
    return asked if given.get("zero") is None else {**asked, "zero": zero_of(given)}


def zero_of(given: Mapping[str, Any]) -> Fraction:
    """Return the angle φ that the page calls 0."""
    zero = given.get("zero")
    named = zero.strip().lower() if isinstance(zero, str) else ""
    if zero is None or named == "inner":
        return Fraction(0)
    if named != "outer":
        return as_angle(zero, "zero")
    if given.get("offset") is not None or given.get("mechanism") not in (None, "straight"):
        raise ProblemError(
            "--zero outer is for dead centres on the slide direction; of another drive give the angle, 180"
            " for the slide direction itself"
        )
    return HALF_TURN


def of_other_mechanisms(
    values: Mapping[str, Any], chosen: Mechanism | None = None, shared: Collection[str] = ()
) -> dict[str, str]:
    """Return what was given that describes other crank drives alone, with the sentences that refuse it."""
    given = [name for name, value in values.items() if is_given(value)]
    return mechanisms.of_other_mechanisms(chosen or meant(values), given, shared)


def ratios_of(page: Layout, ratio: Given | None) -> tuple[Fraction, ...]:
    """Return the crank ratios, or the layout's own."""
    return Described(ratio=ratio).ratios(page.ratios)


def angles_of(page: Layout, given: Mapping[str, Any]) -> Sequence[Fraction]:
    """Return the angles that are listed, or those of a run, or the layout's own, as φ."""
    return shifted(_counted_angles(page, given), zero_of(given))


def _counted_angles(page: Layout, given: Mapping[str, Any]) -> Sequence[Fraction]:
    angle, step = given["angle"], given["step"]
    if all(given[name] is None for name in ("from_", "to", "step")):
        return as_angles(page.angles if angle is None else angle)
    if angle is not None:
        raise ProblemError(
            "--angle lists the angles and --from, --to, --step run through them; use one or the other"
        )
    first, last = ends_of(given)
    if step is not None:
        return notation.progression(first, last, as_angle(step, "step"))
    return notation.progression(first, last, min(STEP, last - first) if last > first else STEP)


def ends_of(given: Mapping[str, Any]) -> tuple[Fraction, Fraction]:
    """Return the first and the last angle, by default those of the whole turn."""
    start, stop = given["from_"], given["to"]
    first = Fraction(0) if start is None else as_angle(start, "first angle")
    return first, FULL_TURN if stop is None else as_angle(stop, "last angle")


class Motion(option.Run, option.AnyDrive, option.Sheet, total=False):
    """A crank drive that moves, at crank angles."""

    method: option.Method
    speed: option.Speed
    acceleration: option.Acceleration
    layouts: option.Layouts


def some(drives: Sequence[Any]) -> Sequence[Any]:
    """Return the drives; raise ProblemError where a list of crank ratios was empty."""
    if not drives:
        raise ProblemError("no crank ratio was given; give one, such as 1:5")
    return drives


@makes_table(
    foreign=of_other_mechanisms,
    order="angle from_ to step zero columns offset stroke crank true_stroke"
    " time_ratio rod method speed acceleration mechanism"
    " rocker pivot circuit beam",
)
def table(
    ratio: option.Ratios = None,
    *,
    columns: Annotated[option.Names, option.columns_over_angle("kinematics", "phi,x,c,p")] = (),
    layout: Annotated[str | None, option.layout_option(*MOTIONS)] = None,
    **given: Unpack[Motion],
) -> Question:
    """Print a table of piston path, velocity and acceleration.

    \b
    kurbel table --ratio 1:5
    kurbel table --ratio '1:4;1:4,5' --step 15 --to 180 -f latex -o anhang.tex
    kurbel table --layout roetscher-112 --ratio 1:5 --ratio 1:4,5 --ratio 1:4
    kurbel table --stroke 600mm --rod 1500mm --speed 120/min
    kurbel table --mechanism arc --ratio 1:5 --rocker 6
    \f
    >>> import kurbel
    >>> page = kurbel.table("1:5", angle=[0, 45, 90], columns=["phi", "x", "c"])
    >>> print(kurbel.typeset(page, "csv"), end="")
    phi,x,c
    0,0.0000,0.0000
    45,0.3431,0.8081
    90,1.1010,1.0000
    >>> page = kurbel.table("1:5", mechanism="arc", rocker=6, angle="0;90", columns="phi,path,rocker")
    >>> print(kurbel.typeset(page, "csv"), end="")
    phi,path,rocker
    0,0.0001,9.587
    90,1.1049,-0.963
    """
    chosen, said = described({**given, "layout": layout}, ratio=ratio)
    page = layout_of(layout or chosen.layout, (chosen.subject,), given["layouts"])
    return chosen.question(
        chosen.drives(said, page.ratios),
        given["method"],
        layout=page,
        angles=angles_of(page, given),
        columns=as_names(columns, chosen.examples["table"]),
        **sheet_of(given),
    )


BEAM, DRIVE = "dead centres", "drive dead centres"
_OF_DRIVES = ("mechanism", "offset", "rocker", "pivot", "circuit", "speed")
_LENGTHS = ("stroke", "rod")


def _of_beam(values: Mapping[str, Any]) -> bool:
    """Whether dead centres are those of a beam engine, and not of a crank drive that is described."""
    if values["layout"]:
        return layout_of(values["layout"], (BEAM, DRIVE), values["layouts"]).subject == BEAM
    if is_given(values["mechanism"]):
        return False
    of_beam = is_given(values["beam"]) or values["exact"]
    return of_beam or not any(is_given(values[name]) for name in (*_OF_DRIVES, *_LENGTHS))


def _no_dead_centres(values: Mapping[str, Any]) -> Mapping[str, str]:
    if _of_beam(values):
        why = "does not belong to the beam engine; leave --beam and --exact out for a crank drive"
        return {name: f"--{name} {why}" for name in _OF_DRIVES}
    why = "is for the beam engine, and a crank drive was described; leave one of the two out"
    of_beam = {name: f"--{name} {why}" for name in ("beam", "exact")}
    chosen = meant(values, layout=None)
    if "beam" in chosen.takes:
        del of_beam["beam"]
    return of_beam | of_other_mechanisms(values, chosen, ("stroke", "speed"))


def _lone_length(values: Mapping[str, Any]) -> Mapping[str, str]:
    if not _of_beam(values) or all(is_given(values[name]) for name in _LENGTHS):
        return {}
    why = "gives the ratio of the beam engine only where both are known, --stroke and --rod; add the other"
    return {name: f"--{name} {why}" for name in _LENGTHS}


def _one_arm(beam: Given | None) -> Fraction | None:
    """Return the arm of a beam engine that is described as a crank drive."""
    if not is_given(beam) or beam is None:
        return None
    first, *others = as_numbers(beam, "beam arm")
    if others:
        raise ProblemError(
            f"--mechanism beam is one engine, and {1 + len(others)} arms were given; leave --mechanism out"
            " for the angles of § 149"
        )
    return first


class Turned(option.Linked, option.Sheet, total=False):
    """A crank drive that turns evenly."""

    speed: Annotated[
        Given | None, option.SPEED._replace(help="Speed, for columns in m/s: 120/min, 12.5rad/s.")
    ]
    layouts: option.Layouts


@makes_table(
    foreign=_no_dead_centres,
    needless=_lone_length,
    order="ratio exact mechanism offset rocker pivot circuit stroke crank true_stroke"
    " time_ratio rod speed columns",
)
def dead_centres_table(
    beam: Annotated[
        Given | None,
        Option("Arm of the beam in crank radii: 3; lists 3;4, ranges 3..6:0.5.", "A:R", many=True),
    ] = None,
    *,
    ratio: Annotated[
        Given | None,
        option.RATIO._replace(help="Crank ratio: 1:5; lists and ranges 1:3..6."),
    ] = None,
    exact: Annotated[
        bool,
        Option("From the true geometry of the linkage; default: the formulas of § 149.", kind=FLAG),
    ] = False,
    columns: Annotated[
        option.Names,
        option.columns_option("weisbach-149", "mu,nu,path_1", ".")._replace(
            kind=Columns("weisbach-149", "dead-centres")
        ),
    ] = (),
    layout: Annotated[str | None, option.layout_option(BEAM, DRIVE)] = None,
    **given: Unpack[Turned],
) -> Question:
    """Print the dead centres of a beam engine: angles μ and ν of the rod, their distance, the small paths.

    Of another crank drive that is described: its dead centres, stroke and times, and with --stroke and
    --speed the crank-pin velocity and the mean piston speed.

    \b
    kurbel deadcentres --beam 3 --ratio 1:5
    kurbel deadcentres --beam 3 --ratio 1:5 --exact
    kurbel deadcentres --mechanism arc --ratio 1:5 --rocker 6
    kurbel deadcentres --ratio 1:4 --offset 0.5 --stroke 600mm --speed 120/min
    \f
    >>> import kurbel
    >>> page = kurbel.dead_centres_table(3, ratio="1:5", columns="mu,path_1")
    >>> print(kurbel.typeset(page, "csv"), end="")
    mu,path_1
    0.7958,0.00010
    >>> page = kurbel.dead_centres_table(ratio="1:4", offset=0.5, columns="phi_i,phi_o,time_ratio")
    >>> print(kurbel.typeset(page, "csv"), end="")
    phi_i,phi_o,time_ratio
    5.739,189.594,1.0438
    """
    values = {**given, "ratio": ratio, "beam": beam, "exact": exact, "layout": layout}
    if _of_beam(values):
        from kurbel.linkage.beam.page import BeamRequest

        page = layout_of(layout or "weisbach-149", (BEAM,), given["layouts"])
        known = is_given(given["stroke"]) and is_given(given["rod"])
        lengths = (given["stroke"], given["rod"]) if known else ()
        return BeamRequest(
            layout=page,
            arms=as_numbers(page.arms if beam is None else beam, "beam arm"),
            ratios=tuple(crank.ratio for crank in Described(ratio, *lengths).cranks(page.ratios)),
            exact=exact,
            columns=as_names(columns, "mu,nu"),
            **sheet_of(given),
        )
    from kurbel.linkage.dead_centres import DeadCentresRequest, drives_of

    page = layout_of(layout or "dead-centres", (DRIVE,), given["layouts"])
    chosen, said = described({**given, "beam": _one_arm(beam), "layout": None}, ratio=ratio)
    drives = drives_of(chosen, said, page.ratios)
    return DeadCentresRequest(
        layout=page,
        mechanism=chosen.name,
        drives=drives,
        columns=as_names(columns, "phi_i,phi_o"),
        **sheet_of(given),
    )
