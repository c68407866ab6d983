"""The crank drive that options describe, and the crank angles; the motion of the piston over them."""

from collections.abc import Collection, Mapping, Sequence
from fractions import Fraction
from typing import Annotated, Any, Unpack

from kurbel.commands import parameters as option
from kurbel.commands.options import is_given
from kurbel.commands.parameters import Given, Sheet
from kurbel.commands.subject import makes_table
from kurbel.drive.crank import Described
from kurbel.drive.mechanisms import MECHANISMS, MOTIONS
from kurbel.errors import ProblemError
from kurbel.motion import mechanism as mechanisms
from kurbel.motion.mechanism import Mechanism
from kurbel.page.layouts import Layout, layout_of
from kurbel.page.subject import Question
from kurbel.reading import notation
from kurbel.reading.given import as_angle, as_angles, as_names

FULL_TURN = Fraction(360)
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
    """Return how the page is to be printed."""
    return {name: given[name] for name in Sheet.__annotations__ if name in given}


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
    """Return the angles that are listed, or those of a run, or the layout's own."""
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


class Motion(option.Run, option.Linked, option.Sheet, total=False):
    """A crank drive that moves, at crank angles."""

    method: option.Method
    speed: option.Speed
    layouts: option.Layouts


def some(drives: Sequence[Any]) -> Sequence[Any]:
    """Return the drives; raise ProblemError where a list of crank ratios was empty."""
    if not drives:
        raise ProblemError("no crank ratio was given; give one, such as 1:5")
    return drives


@makes_table(
    foreign=of_other_mechanisms,
    order="angle from_ to step columns offset stroke rod method speed mechanism rocker pivot",
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
