"""Drawings of the motion, the mechanism to scale, and the forces, also those of an engine."""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Annotated, Any

from kurbel.commands import parameters as option
from kurbel.commands.cranks import (
    LINKAGES,
    MECHANISMS,
    arc_cranks,
    check_needed,
    cranks_of,
    ends_of,
    mechanism_of,
    of_other_mechanisms,
    radius_of,
)
from kurbel.commands.options import Columns, Option
from kurbel.commands.shown import Drawing, mark_of
from kurbel.commands.subject import draws
from kurbel.errors import ProblemError
from kurbel.page.layouts import Layout, layout_of
from kurbel.reading import notation
from kurbel.reading.given import Exact, as_angle, as_angles, as_force, as_names

if TYPE_CHECKING:
    from kurbel.drive.crank import Crank
    from kurbel.linkage.arc import ArcCrank
    from kurbel.motion.question import Request

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
    name = mechanism_of(values["mechanism"], values["offset"])
    refused = of_other_mechanisms(name)
    if name in LINKAGES:
        refused["force"] = f"--force says nothing about the {name} crank; leave it out"
    return refused


def _of_forces(values: Mapping[str, Any]) -> dict[str, str]:
    """Refuse what describes other crank drives."""
    return of_other_mechanisms(mechanism_of(values["mechanism"], values["offset"]), ("stroke",))


def _of_sliding(values: Mapping[str, Any]) -> dict[str, str]:
    """Refuse what a crank drive with a crosshead does not have, the only one with a polar diagram."""
    name = values["mechanism"]
    if name not in LINKAGES:
        return of_other_mechanisms(mechanism_of(name, values["offset"]))
    return {
        "mechanism": f"the polar diagram of the {name} crank is not drawn; leave --mechanism out",
        **of_other_mechanisms(mechanism_of(None, values["offset"])),
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
    from kurbel.plot.curves import motion_keys, motion_panels
    from kurbel.plot.drawings import curves_drawing

    mark, angles = mark_of(lang, decimal), curve_angles(from_, to, step)
    name = mechanism_of(mechanism, offset)
    check_needed(name, offset, rocker)
    if name in LINKAGES:
        from kurbel.linkage.page import LinkageRequest
        from kurbel.plot.curves import ARC_MOTION

        page = page_of(MECHANISMS[name].layout)
        cranks: tuple[ArcCrank, ...] = ()
        if name == "arc":
            cranks = arc_cranks(page, ratio, offset, rocker, pivot, method)
        names = as_names(columns, "path,velocity") or (ARC_MOTION if name == "arc" else ())
        question = LinkageRequest(layout=page, angles=angles, cranks=cranks, lang=lang, columns=names)
        return Drawing.of(curves_drawing(question, motion_panels(question), mark), lang, mark)
    across = offset if name == "offset" else None
    newtons = None if force is None else as_force(force)
    drives = cranks_of(page_of(LAYOUT), ratio, stroke, rod, across, speed, method=method, force=newtons)
    request = _request(drives, angles, columns, motion_keys, method, lang)
    return Drawing.of(curves_drawing(request, motion_panels(request), mark), lang, mark)


@draws(foreign=lambda values: of_other_mechanisms(mechanism_of(values["mechanism"], values["offset"])))
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
    from kurbel.plot.drawings import arc_drawing, mechanism_drawing, parallel_drawing

    mark, angles = mark_of(lang, decimal), as_angles(positions)
    name = mechanism_of(mechanism, offset)
    check_needed(name, offset, rocker)
    if name == "parallel":
        made = parallel_drawing(angles, lang, mark)
    elif name == "arc":
        arcs = arc_cranks(page_of(MECHANISMS[name].layout), ratio, offset, rocker, pivot, None)
        made = arc_drawing(only(arcs, "positions", "ratios"), angles, lang, mark)
    else:
        across = offset if name == "offset" else None
        crank = only(cranks_of(page_of(LAYOUT), ratio, stroke, rod, across), "positions", "ratios")
        made = mechanism_drawing(crank, angles, lang, mark)
    return Drawing.of(made, lang, mark)


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
    from kurbel.plot.curves import force_keys, motion_panels
    from kurbel.plot.drawings import curves_drawing

    mark, angles = mark_of(lang, decimal), curve_angles(from_, to, step)
    name = mechanism_of(mechanism, offset)
    check_needed(name, offset, rocker)
    if name in LINKAGES:
        from kurbel.linkage.page import LinkageRequest
        from kurbel.linkage.parallel import ParallelCrank
        from kurbel.page.subject import subject

        page, newtons = page_of(f"forces-{name}"), None if force is None else as_force(force)
        parallel = ParallelCrank(radius_of(stroke), newtons)
        arcs: tuple[ArcCrank, ...] = ()
        if name == "arc":
            arcs = arc_cranks(page, ratio, offset, rocker, pivot, method, stroke, newtons)
        known = subject(page.subject).quantities()
        own = (key for key in force_keys((arcs[0] if arcs else parallel).crank) if key in known)
        names = as_names(columns, "rod_force,guide_force") or tuple(own)
        question = LinkageRequest(
            layout=page, angles=angles, cranks=arcs, parallel=parallel, lang=lang, columns=names
        )
        return Drawing.of(curves_drawing(question, motion_panels(question), mark), lang, mark)
    cranks = _pushed(mechanism, ratio, stroke, rod, offset, method, force)
    request = _request(cranks, angles, columns, force_keys, method, lang)
    return Drawing.of(curves_drawing(request, motion_panels(request), mark), lang, mark)


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
    crank = only(_pushed(mechanism, ratio, stroke, rod, offset, method, force), "polar", "ratios")
    request = _request((crank,), angles, (), pin_force_keys, method, lang)
    return Drawing.of(polar_drawing(request, pin_force(request), mark), lang, mark)


def _pushed(
    mechanism: str | None,
    ratio: option.Given | None,
    stroke: Exact | None,
    rod: Exact | None,
    offset: Exact | None,
    method: str | None,
    force: Exact | None,
) -> tuple["Crank", ...]:
    """Return the cranks under a piston force."""
    name = mechanism_of(mechanism, offset)
    check_needed(name, offset, None)
    across = offset if name == "offset" else None
    newtons = None if force is None else as_force(force)
    return cranks_of(page_of(LAYOUT), ratio, stroke, rod, across, method=method, force=newtons)


def _request(
    cranks: tuple["Crank", ...],
    angles: Sequence[Fraction],
    columns: option.Names,
    keys: Callable[["Crank"], tuple[str, ...]],
    method: str | None,
    lang: str,
) -> "Request":
    """Return what is asked for of the columns named, or of those that a crank has by itself."""
    from kurbel.motion.question import Request

    names = as_names(columns, "x,c,p") or keys(cranks[0])
    page = layout_of(LAYOUT, ("motion",))
    return Request(layout=page, cranks=cranks, angles=angles, method=method, lang=lang, columns=names)


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
