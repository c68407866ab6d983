"""What commands that are no parts yet ask of a drive and of crank angles."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from kurbel.commands.drives.given import APPROXIMATE, FORCES_OVER_PATH, OVER_PATH, PATH
from kurbel.commands.options import is_given
from kurbel.commands.parameters import Given, Sheet
from kurbel.drive.crank import Described
from kurbel.drive.mechanisms import MECHANISMS, MOTIONS
from kurbel.errors import ProblemError
from kurbel.motion import mechanism as mechanisms
from kurbel.motion.mechanism import Mechanism
from kurbel.page.axes import shifted
from kurbel.page.layouts import Layout, layout_of
from kurbel.page.layouts import layout as layout_named
from kurbel.reading import notation
from kurbel.reading.given import as_angle, as_angles

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


def some(drives: Sequence[Any]) -> Sequence[Any]:
    """Return the drives; raise ProblemError where a list of crank ratios was empty."""
    if not drives:
        raise ProblemError("no crank ratio was given; give one, such as 1:5")
    return drives
