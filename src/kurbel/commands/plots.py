"""Drawings of the motion, the mechanism to scale, and the forces, also those of an engine."""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple, TypeAlias, TypedDict, Unpack

from kurbel.commands import parameters as option
from kurbel.commands.drawn.film import Filmed, curves_of, moving_mechanism, polar_of, still
from kurbel.commands.drawn.size import Sized, page_size
from kurbel.commands.drives.given import ANGLE, AXES, PATH
from kurbel.commands.old_motion import described, ends_of, meant, method_of, of_other_mechanisms, some
from kurbel.commands.options import FLAG, Choice, Columns, Option, is_given
from kurbel.commands.shown import Drawing, mark_of
from kurbel.commands.subject import draws
from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.motion.mechanism import Mechanism
from kurbel.page.layouts import Layout, layout
from kurbel.reading import notation
from kurbel.reading.given import Exact, as_angle, as_angles, as_names, found_at

if TYPE_CHECKING:
    from kurbel.motion.drives import Drive
    from kurbel.motion.page import AngleQuestion

# The columns that a drive has by itself.
Keys: TypeAlias = Callable[[Mechanism, Crank], tuple[str, ...]]
# The page whose quantities can be drawn.
LAYOUT = "kinematics"
# The crank ratio in all drawings.
RATIO = "R:L"
# Where the crank stands beside the path of a point, unless it is said.
POSITION = "60"
# The method that is drawn beside another.
INFINITE = "infinite"
# So many steps of the range make a curve smooth, half degrees over the turn; over many turns a wider step
# than this shows.
STEPS, WIDEST = 720, Fraction(5)

DrawnColumns = Annotated[
    option.Names,
    Option(
        "Quantities to draw: x,c,p or rod_force,guide_force; `kurbel quantities` lists them.",
        "NAMES",
        Columns(LAYOUT),
        many=True,
    ),
]
CurveStep = Annotated[
    Exact | None,
    option.STEP._replace(help=f"Step of the angles; default 1/{STEPS} of their range, at most {WIDEST}°."),
]
DrawnSpeed = Annotated[
    Exact | None,
    option.SPEED._replace(help="Speed, for m/s and m/s², and for masses: 120/min, 12.5rad/s."),
]
DrawnForce = Annotated[
    Exact | None,
    option.FORCE._replace(help="Piston force, to draw forces in N and N m: 10kN."),
]
DrawnPoint = Annotated[
    option.Given | None,
    option.ROD_POINT._replace(
        help="Draw the paths of points of the rod beside the mechanism, with --columns their motion over the"
        " crank angle: 0.5, 0.5,0.1, '0;0.5;1'."
    ),
]
AxisUnits = Annotated[
    str | None,
    option.UNITS._replace(
        help="Units of the axes: metric, imperial or a list, 'cm;kN'. Default: metric; of what is given in"
        " imperial units alone these."
    ),
]
LabelLang = Annotated[str, option.LANG._replace(help="Language of the labels: de or en.")]


def _of_motion(values: Mapping[str, Any]) -> dict[str, str]:
    chosen = meant(values)
    refused = of_other_mechanisms(values, chosen)
    if not chosen.crosshead:
        refused["force"] = f"--force says nothing about {chosen.title}; leave it out"
    if not chosen.crosshead or is_given(values.get("offset")):
        refused["infinite"] = (
            "--infinite is for the straight crank alone; leave it out, or the offset or mechanism"
        )
    return {**refused, **still(values)}


def _of_mechanism(values: Mapping[str, Any]) -> dict[str, str]:
    return {**of_other_mechanisms(values), **still(values)}


def _of_forces(values: Mapping[str, Any]) -> dict[str, str]:
    """Refuse what describes other crank drives."""
    return {**of_other_mechanisms(values, shared=("stroke",)), **still(values)}


def _of_sliding(values: Mapping[str, Any]) -> dict[str, str]:
    """Refuse what a crank drive with a crosshead does not have, the only one with a polar diagram."""
    chosen = meant(values)
    if chosen.crosshead:
        return {**of_other_mechanisms(values, chosen), **still(values)}
    return {
        "mechanism": f"the polar diagram of {chosen.title} is not drawn; leave --mechanism out",
        **of_other_mechanisms(values, meant(values, mechanism=None)),
    }


class Positions(option.AnyDrive, Sized, Filmed, total=False):
    """A crank drive to scale."""

    ratio: option.Ratios
    lang: LabelLang
    units: AxisUnits
    decimal: option.Decimal


class Over(TypedDict, total=False):
    """What curves run over."""

    over: Annotated[
        str,
        Option(
            "What curves run over: angle (default), or path, the piston's, both strokes in one curve, such as"
            " the velocity ellipse; with --turning the crank pin's path on its developed circle.",
            kind=Choice("axis", AXES), default=ANGLE,
        ),
    ]  # fmt: skip


class Curves(option.AnyDrive, Sized, Filmed, total=False):
    """A crank drive over its crank angle, under a piston force."""

    method: option.Method
    order: option.Order
    from_: option.From
    to: option.To
    step: CurveStep
    force: DrawnForce
    lang: LabelLang
    units: AxisUnits
    decimal: option.Decimal


class OverCurves(Over, Curves, total=False):
    """The same, over its angle or its path."""


@draws(foreign=_of_motion)
def plot_motion(
    ratio: option.Ratios = None,
    *,
    columns: DrawnColumns = (),
    speed: DrawnSpeed = None,
    infinite: Annotated[
        bool, Option("Draw the motion with a rod of infinite length as well, dotted.", kind=FLAG)
    ] = False,
    point: DrawnPoint = None,
    **given: Unpack[OverCurves],
) -> Drawing:
    """Draw path, velocity and acceleration over the crank angle, or what the columns name; over the path
    velocity and acceleration. Of points of the rod their velocity and acceleration."""
    from kurbel.plot.curves import motion_keys

    if point is not None and is_given(point):
        from kurbel.commands.points.drawn import points_drawn

        return points_drawn(point, columns, infinite, {**given, "ratio": ratio, "speed": speed})
    about = {**given, "ratio": ratio, "speed": speed}
    return _drawn(about, columns, motion_keys, "plot", beside=INFINITE if infinite else "")


@draws(foreign=_of_mechanism)
def plot_mechanism(
    positions: Annotated[
        option.Given | None,
        Option(
            "Draw the mechanism to scale at these crank angles: 30, or '30;90;150'.",
            "ANGLES",
            unit="degrees",
            many=True,
        ),
    ] = None,
    *,
    point: DrawnPoint = None,
    **given: Unpack[Positions],
) -> Drawing:
    """Draw the mechanism to scale at crank angles, the first one strong, with the paths of points of its
    rod."""
    from kurbel.commands.points.asked import rod_points
    from kurbel.plot.coupler.paths import coupled

    if positions is None and point is None:
        raise ProblemError("no crank angle was given; give one, such as 30, or '30;90;150'")
    lang, mark = given["lang"], mark_of(given["lang"], given["decimal"])
    angles = as_angles(POSITION if positions is None else positions)
    chosen, said = described(given)
    flag = "point" if positions is None else "positions"
    drive = only(chosen.drives(said, page_of(chosen.layout).ratios), flag, "ratios")
    points = () if point is None else rod_points(chosen, drive, point)
    paths = coupled(points, found_at(chosen.moving)(drive)) if points else ()
    drawn = found_at(chosen.drawing)(drive, angles, lang, mark, page_size(given), paths)
    if given["animate"]:
        return moving_mechanism(chosen, drive, angles, given, drawn, points)
    return Drawing.of(drawn, lang, mark)


@draws(foreign=_of_forces)
def plot_forces(
    ratio: option.Ratios = None, *, columns: DrawnColumns = (), **given: Unpack[OverCurves]
) -> Drawing:
    """Draw the forces in the crank drive under a constant piston force."""
    from kurbel.plot.curves import force_keys

    return _drawn({**given, "ratio": ratio}, columns, force_keys, "plot forces")


@draws(foreign=_of_sliding)
def plot_polar(ratio: option.Ratios = None, **given: Unpack[Curves]) -> Drawing:
    """Draw the polar diagram of the force on the crank pin under a constant piston force."""
    from kurbel.plot.curves import pin_force, pin_force_keys

    asked = _asked({**given, "ratio": ratio}, (), pin_force_keys, "polar")
    force = pin_force(asked.question, asked.solved[0])
    return polar_of(asked.question, force, given)


def _drawn(
    given: Mapping[str, Any], columns: option.Names, keys: Keys, command: str, beside: str = ""
) -> Drawing:
    from kurbel.plot.curves import around, motion_panels

    mark, asked = mark_of(given["lang"], given["decimal"]), _asked(given, columns, keys, command)
    alike = {**given, "method": beside, "order": None}
    dotted = _asked(alike, columns, keys, command).question if beside else None
    if given["over"] == PATH:
        from kurbel.commands.over.drawn import drawn_over

        found = drawn_over(asked.question, asked.solved, dotted, mark, page_size(given))
        return Drawing.of(found, given["lang"], mark)
    panels = motion_panels(asked.question, dotted, asked.solved)
    return curves_of(asked.question, panels, around(asked.question, asked.solved, dotted), given)


class Asked(NamedTuple):
    """What is asked for of drives, and these as conditions see them."""

    question: "AngleQuestion"
    solved: "tuple[Drive, ...]"


def _asked(given: Mapping[str, Any], columns: option.Names, keys: Keys, command: str) -> Asked:
    """Return what is asked for of the columns named, or of those that a drive has by itself."""
    angles, (chosen, said) = curve_angles(given), described(given)
    forces = command == "plot forces" and not chosen.crosshead
    page = page_of(chosen.forces_layout if forces else chosen.layout)
    drives = some(chosen.drives(said, page.ratios))
    if command == "polar":
        only(drives, "polar", "ratios")
    method = method_of(given)
    named, crank = as_names(columns, chosen.examples.get(command, "")), chosen.crank(drives[0])
    names = named or keys(chosen, crank)
    if given.get("over") == PATH:
        from kurbel.commands.over.drawn import names_over

        names = names_over(chosen, crank, names, bool(named))
    question = chosen.question(
        drives,
        method,
        layout=page,
        angles=angles,
        lang=given["lang"],
        units=given["units"],
        columns=names,
    )
    # What rests on no conditions has no drives for them.
    return Asked(question, chosen.solved(drives, method) if chosen.conditions() else ())


def page_of(name: str) -> Layout:
    """Return the layout of what is drawn, with the crank ratio as in all drawings, whatever its book has."""
    own: dict[str, Any] = vars(layout(name)) | {"ratio_symbol": RATIO}
    return Layout(**own)


def only(given: Sequence[Any], flag: str, what: str) -> Any:
    if len(given) > 1:
        raise ProblemError(f"--{flag} draws one crank drive, and {len(given)} {what} were given; choose one")
    return some(given)[0]


def curve_angles(given: Mapping[str, Any]) -> Sequence[Fraction]:
    """Return the angles of a run, by themselves close enough for smooth curves."""
    first, last = ends_of(given)
    if given["step"] is None:
        return notation.progression(first, last, min((last - first) / STEPS or WIDEST, WIDEST))
    return notation.progression(first, last, as_angle(given["step"], "step"))
