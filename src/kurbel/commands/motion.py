"""The crank drive that options describe, and the crank angles; the motion of the piston over them, or over
its path."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, Annotated, Any, Unpack

from kurbel.commands import parameters as option
from kurbel.commands.drives.given import APPROXIMATE, FORCES_OVER_PATH, OVER_PATH, PATH
from kurbel.commands.options import is_given
from kurbel.commands.parameters import Given, Sheet
from kurbel.commands.subject import makes_table
from kurbel.drive.crank import Described
from kurbel.drive.mechanisms import MECHANISMS, MOTIONS
from kurbel.errors import ProblemError
from kurbel.motion import mechanism as mechanisms
from kurbel.motion.mechanism import Mechanism
from kurbel.page.axes import shifted
from kurbel.page.layouts import Layout, layout_of
from kurbel.page.layouts import layout as layout_named
from kurbel.page.subject import Question
from kurbel.reading import notation
from kurbel.reading.given import as_angle, as_angles, as_names

if TYPE_CHECKING:
    from kurbel.motion.page import AngleQuestion

HALF_TURN, FULL_TURN = Fraction(180), Fraction(360)
STEP = Fraction(10)
# What pages about points of the rod are about.
POINTS = "rod points"


def meant(values: Mapping[str, Any], **instead: Any) -> Mechanism:
    """Return which crank drive options describe: where it is not said, by the layout, else by the offset."""
    values = {**values, **instead}
    mechanism, offset, layout = values["mechanism"], values["offset"], values.get("layout")
    if not mechanism and layout is not None:
        subject = layout_of(layout, (*MOTIONS, OVER_PATH, POINTS, *APPROXIMATE), values["layouts"]).subject
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


def angles_of(page: Layout, given: Mapping[str, Any], turn: Fraction = FULL_TURN) -> Sequence[Fraction]:
    """Return the angles that are listed, or those of a run, or the layout's own, as φ; a run without an end
    is of so much of a `turn`."""
    return shifted(_counted_angles(page, given, turn), zero_of(given))


def over_strokes(question: "AngleQuestion", given: Mapping[str, Any]) -> "AngleQuestion":
    """Return the question over both strokes, where these stand side by side at all of its angles; else over
    whole turns. Where no last angle is given, both strokes end at 180°."""
    from kurbel.motion.page import is_beyond

    if not is_beyond(question.angles):
        return question
    ended = question.zero or given["to"] is not None or given["angle"] is not None
    if ended or not question.has_return or not 0 <= question.angles[0] <= HALF_TURN:
        return replace(question, whole_turns=True)
    angles = angles_of(question.layout, given, HALF_TURN)
    # Angles of a layout have no end to be given.
    return replace(
        question, angles=tuple(one for one in angles if one <= HALF_TURN) if is_beyond(angles) else angles
    )


def _counted_angles(page: Layout, given: Mapping[str, Any], turn: Fraction) -> Sequence[Fraction]:
    angle, step = given["angle"], given["step"]
    if all(given[name] is None for name in ("from_", "to", "step")):
        return as_angles(page.angles if angle is None else angle)
    if angle is not None:
        raise ProblemError(
            "--angle lists the angles and --from, --to, --step run through them; use one or the other"
        )
    first, last = ends_of(given, turn)
    if step is not None:
        return notation.progression(first, last, as_angle(step, "step"))
    return notation.progression(first, last, min(STEP, last - first) if last > first else STEP)


def ends_of(given: Mapping[str, Any], turn: Fraction = FULL_TURN) -> tuple[Fraction, Fraction]:
    """Return the first and the last angle, by default those of the whole turn, or of so much of it."""
    start, stop = given["from_"], given["to"]
    first = Fraction(0) if start is None else as_angle(start, "first angle")
    return first, turn if stop is None else as_angle(stop, "last angle")


def is_over_path(values: Mapping[str, Any]) -> bool:
    """Whether a page over the piston's path is asked for, by --over or by its layout. Raises ProblemError
    where the two contradict each other."""
    name = values["layout"]
    if name is None:
        return bool(values["over"] == PATH)
    over = layout_named(name, values["layouts"]).subject in (OVER_PATH, FORCES_OVER_PATH)
    if values["over"] == PATH and not over:
        raise ProblemError(
            f"layout {name} is not over the path; leave --over out, or --layout, for a page of its own"
        )
    return over


def needless_over(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Return what says nothing of the axis that a page runs over."""
    if not is_over_path(values):
        return {"shares": "--shares are those of the stroke, with --over path; add that"}
    why = "is for pages over the crank angle; with --over path give shares of the stroke"
    return {
        "angle": f"--angle {why}, --shares '0;50%;100%' or --step 5%",
        "zero": f"--zero {why}, which count from the dead centre where the stroke begins",
        "acceleration": "--acceleration is at crank angles of a turn; leave it out, or --over path",
    }


def foreign_over(values: Mapping[str, Any]) -> Mapping[str, str]:
    """Return what belongs to other crank drives, and over the path what runs over angles."""
    refused = of_other_mechanisms(values)
    if not is_over_path(values):
        return refused
    from kurbel.commands.over.path import not_shares

    return {**refused, **not_shares(values)}


def method_of(given: Mapping[str, Any]) -> str | None:
    """Return the method, of a series by its order."""
    if not is_given(given.get("order")):
        method: str | None = given["method"]
        return method
    from kurbel.commands.drives.orders import by_order

    return by_order(given)


class Motion(option.Run, option.Over, option.AnyDrive, option.Sheet, total=False):
    """A crank drive that moves, at crank angles or over its path."""

    method: option.Method
    order: option.Order
    speed: option.Speed
    acceleration: option.Acceleration
    layouts: option.Layouts


def some(drives: Sequence[Any]) -> Sequence[Any]:
    """Return the drives; raise ProblemError where a list of crank ratios was empty."""
    if not drives:
        raise ProblemError("no crank ratio was given; give one, such as 1:5")
    return drives


@makes_table(
    foreign=foreign_over,
    needless=needless_over,
    order="point angle from_ to step zero over shares columns offset stroke crank true_stroke"
    " time_ratio rod method order speed acceleration mechanism"
    " rocker pivot circuit beam",
)
def table(
    ratio: option.Ratios = None,
    *,
    columns: Annotated[option.Names, option.columns_over_angle("kinematics", "phi,x,c,p")] = (),
    layout: Annotated[str | None, option.layout_option(*MOTIONS, OVER_PATH, POINTS, *APPROXIMATE)] = None,
    point: option.RodPoint = None,
    **given: Unpack[Motion],
) -> Question:
    """Print a table of piston path, velocity and acceleration.

    \b
    kurbel table --ratio 1:5
    kurbel table --ratio '1:4;1:4,5' --step 15 --to 180 -f latex -o anhang.tex
    kurbel table --layout roetscher-112 --ratio 1:5 --ratio 1:4,5 --ratio 1:4
    kurbel table --stroke 600mm --rod 1500mm --speed 120/min
    kurbel table --mechanism arc --ratio 1:5 --rocker 6
    kurbel table --ratio 1:5 --over path --step 5%
    kurbel table --ratio 1:5 --point 0.5
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
    >>> page = kurbel.table("1:5", over="path", shares="0;50%", columns="share,phi,c,c_return")
    >>> print(kurbel.typeset(page, "csv"), end="")
    share,phi,c,c_return
    0.0,0.0000,0.0000,0.0000
    0.5,84.2608,1.0153,1.0153
    """
    chosen, said = described({**given, "layout": layout}, ratio=ratio)
    if point is not None and is_given(point):
        from kurbel.commands.points.asked import points_question

        return points_question(chosen, said, point, layout, columns, given)
    _check_pointless(layout, given)
    if is_over_path({**given, "layout": layout}):
        from kurbel.commands.over.path import over_path

        page = layout_of(layout or "over-path", (OVER_PATH,), given["layouts"])
        return over_path(chosen, said, page, {**given, "method": method_of(given), "columns": columns})
    # A linkage has none of these pages: they are refused by themselves, and not offered in place of others.
    asked = layout is not None and layout_named(layout, given["layouts"]).subject in APPROXIMATE
    subjects = (chosen.subject, *APPROXIMATE) if chosen.crosshead or asked else (chosen.subject,)
    page = layout_of(layout or chosen.layout, subjects, given["layouts"])
    if page.subject in APPROXIMATE:
        from kurbel.commands.drives.approximate import approximations

        return approximations(chosen, said, page, {**given, "columns": columns})
    question = chosen.question(
        chosen.drives(said, page.ratios),
        method_of(given),
        layout=page,
        angles=angles_of(page, given),
        columns=as_names(columns, chosen.examples["table"]),
        **sheet_of(given),
    )
    return over_strokes(question, given)


def _check_pointless(name: str | None, given: Mapping[str, Any]) -> None:
    if name is not None and layout_named(name, given["layouts"]).subject == POINTS:
        raise ProblemError(
            f"layout {name} is about points of the rod, and none was given; add --point, for example"
            " --point 0.5"
        )
