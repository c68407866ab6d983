"""Drawings of the motion, the mechanism to scale, and the forces, also those of an engine."""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from importlib import import_module
from typing import TYPE_CHECKING, Annotated, Any

from kurbel.commands import parameters as option
from kurbel.commands.cranks import ends_of, meant, mechanism_of, of_other_mechanisms
from kurbel.commands.options import Columns, Option
from kurbel.commands.shown import Drawing, mark_of
from kurbel.commands.subject import draws
from kurbel.drive.crank import Described
from kurbel.errors import ProblemError
from kurbel.motion.mechanism import Mechanism
from kurbel.page.layouts import Layout
from kurbel.reading import notation
from kurbel.reading.given import Exact, as_angle, as_angles, as_force, as_names

if TYPE_CHECKING:
    from kurbel.drive.crank import Crank

# The page whose quantities can be drawn.
LAYOUT = "kinematics"
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
LabelLang = Annotated[str, option.LANG._replace(help="Language of the labels: de or en.")]


def _of_motion(values: Mapping[str, Any]) -> dict[str, str]:
    chosen = meant(values)
    refused = of_other_mechanisms(values, chosen)
    if not chosen.crosshead:
        refused["force"] = f"--force says nothing about {chosen.title}; leave it out"
    return refused


def _of_forces(values: Mapping[str, Any]) -> dict[str, str]:
    """Refuse what describes other crank drives."""
    return of_other_mechanisms(values, shared=("stroke",))


def _of_sliding(values: Mapping[str, Any]) -> dict[str, str]:
    """Refuse what a crank drive with a crosshead does not have, the only one with a polar diagram."""
    chosen = meant(values)
    if chosen.crosshead:
        return of_other_mechanisms(values, chosen)
    return {
        "mechanism": f"the polar diagram of {chosen.title} is not drawn; leave --mechanism out",
        **of_other_mechanisms(values, mechanism_of(None, values["offset"])),
    }


@draws(foreign=_of_motion)
def plot_motion(
    ratio: option.Ratios = None,
    *,
    columns: DrawnColumns = (),
    method: option.Method = None,
    from_: option.From = None,
    to: option.To = None,
    step: CurveStep = None,
    offset: option.Offset = None,
    stroke: option.Stroke = None,
    rod: option.Rod = None,
    speed: DrawnSpeed = None,
    force: DrawnForce = None,
    mechanism: option.Mechanism = None,
    rocker: option.Rocker = None,
    pivot: option.Pivot = None,
    lang: LabelLang = "de",
    decimal: option.Decimal = None,
) -> Drawing:
    """Draw path, velocity and acceleration over the crank angle, or what the columns name."""
    from kurbel.plot.curves import motion_keys

    said = Described(ratio, stroke, rod, speed, method, offset, rocker, pivot, _newtons(force))
    return _drawn(mechanism, said, columns, motion_keys, curve_angles(from_, to, step), lang, decimal, "plot")


@draws(foreign=of_other_mechanisms)
def plot_mechanism(
    positions: Annotated[
        option.Given,
        Option(
            "Draw the mechanism to scale at these crank angles: 30, or 30;90;150.",
            "ANGLES",
            unit="degrees",
            many=True,
        ),
    ],
    *,
    ratio: option.Ratios = None,
    offset: option.Offset = None,
    stroke: option.Stroke = None,
    rod: option.Rod = None,
    mechanism: option.Mechanism = None,
    rocker: option.Rocker = None,
    pivot: option.Pivot = None,
    lang: LabelLang = "de",
    decimal: option.Decimal = None,
) -> Drawing:
    """Draw the mechanism to scale at crank angles, the first one strong."""
    mark, angles = mark_of(lang, decimal), as_angles(positions)
    chosen = mechanism_of(mechanism, offset)
    said = Described(ratio, stroke, rod, None, None, offset, rocker, pivot)
    chosen.check(said)
    drive = only(chosen.drives(said, page_of(chosen.layout).ratios), "positions", "ratios")
    module, _, name = chosen.drawing.partition(":")
    return Drawing.of(getattr(import_module(module), name)(drive, angles, lang, mark), lang, mark)


@draws(foreign=_of_forces)
def plot_forces(
    ratio: option.Ratios = None,
    *,
    columns: DrawnColumns = (),
    method: option.Method = None,
    from_: option.From = None,
    to: option.To = None,
    step: CurveStep = None,
    offset: option.Offset = None,
    stroke: option.Stroke = None,
    rod: option.Rod = None,
    force: DrawnForce = None,
    mechanism: option.Mechanism = None,
    rocker: option.Rocker = None,
    pivot: option.Pivot = None,
    lang: LabelLang = "de",
    decimal: option.Decimal = None,
) -> Drawing:
    """Draw the forces in the crank drive under a constant piston force."""
    from kurbel.plot.curves import force_keys

    said = Described(ratio, stroke, rod, None, method, offset, rocker, pivot, _newtons(force))
    return _drawn(
        mechanism, said, columns, force_keys, curve_angles(from_, to, step), lang, decimal, "plot forces"
    )


@draws(foreign=_of_sliding)
def plot_polar(
    ratio: option.Ratios = None,
    *,
    method: option.Method = None,
    from_: option.From = None,
    to: option.To = None,
    step: CurveStep = None,
    offset: option.Offset = None,
    stroke: option.Stroke = None,
    rod: option.Rod = None,
    force: DrawnForce = None,
    mechanism: option.Mechanism = None,
    rocker: option.Rocker = None,
    pivot: option.Pivot = None,
    lang: LabelLang = "de",
    decimal: option.Decimal = None,
) -> Drawing:
    """Draw the polar diagram of the force on the crank pin under a constant piston force."""
    from kurbel.plot.curves import pin_force, pin_force_keys
    from kurbel.plot.drawings import polar_drawing

    mark, angles = mark_of(lang, decimal), curve_angles(from_, to, step)
    chosen = mechanism_of(mechanism, offset)
    said = Described(ratio, stroke, rod, None, method, offset, force=_newtons(force))
    chosen.check(said)
    page = page_of(chosen.layout)
    crank = only(chosen.drives(said, page.ratios), "polar", "ratios")
    names = pin_force_keys(chosen, crank)
    question = chosen.question((crank,), method, layout=page, angles=angles, lang=lang, columns=names)
    return Drawing.of(polar_drawing(question, pin_force(question), mark), lang, mark)


def _newtons(force: Exact | None) -> Fraction | None:
    return None if force is None else as_force(force)


def _drawn(
    mechanism: str | None,
    said: Described,
    columns: option.Names,
    keys: Callable[[Mechanism, "Crank"], tuple[str, ...]],
    angles: Sequence[Fraction],
    lang: str,
    decimal: str | None,
    command: str,
) -> Drawing:
    """Draw the columns named, or those that a drive has by itself."""
    from kurbel.plot.curves import motion_panels
    from kurbel.plot.drawings import curves_drawing

    mark, chosen = mark_of(lang, decimal), mechanism_of(mechanism, said.offset)
    chosen.check(said)
    forces = command == "plot forces" and not chosen.crosshead
    page = page_of(chosen.forces_layout if forces else chosen.layout)
    drives = chosen.drives(said, page.ratios)
    names = as_names(columns, chosen.examples[command]) or keys(chosen, chosen.crank(drives[0]))
    question = chosen.question(drives, said.method, layout=page, angles=angles, lang=lang, columns=names)
    return Drawing.of(curves_drawing(question, motion_panels(question), mark), lang, mark)


def page_of(name: str) -> Layout:
    from kurbel.page.layouts import layout

    return layout(name)


def only(given: Sequence[Any], flag: str, what: str) -> Any:
    if len(given) > 1:
        raise ProblemError(f"--{flag} draws one crank drive, and {len(given)} {what} were given; choose one")
    return given[0]


def curve_angles(start: Exact | None, stop: Exact | None, step: Exact | None) -> Sequence[Fraction]:
    """Return the angles of a run, by themselves close enough for smooth curves."""
    first, last = ends_of(start, stop)
    if step is None:
        return notation.progression(first, last, min((last - first) / STEPS or WIDEST, WIDEST))
    return notation.progression(first, last, as_angle(step, "step"))
