"""`kurbel delta`, `kurbel turning` and `kurbel flywheel`: the steam engine and how evenly it turns."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, TypeVar

import click

from kurbel.cli.machine import machine_option
from kurbel.cli.masses import is_heavy, load_of, mass_options, with_masses
from kurbel.cli.options import (
    Columns,
    Name,
    in_order,
    layout_option,
    output_options,
    sheet_of,
    typed,
    without_outdone,
)
from kurbel.errors import ProblemError
from kurbel.reading import notation

if TYPE_CHECKING:
    from kurbel.engine.engine import Diagram, Steam
    from kurbel.page.layouts import Layout

# What gives way, where it only comes from the environment, to what is typed.
RIVALS = (
    ("eps", {"card"}),
    ("back", {"card"}),
    ("exponent", {"card"}),
    ("clearance", {"card"}),
    ("pressure", {"card"}),
    ("card", {"eps"}),
)
Command = TypeVar("Command", bound=Callable[..., Any])


def _method_names() -> tuple[str, ...]:
    from kurbel.engine.request import ENGINE_METHODS

    return tuple(ENGINE_METHODS)


EPS = click.option("--eps", multiple=True, metavar="ε",
                   help="Expansion ratio, cut-off after 1/ε of the stroke: 4; lists 2;3;4, ranges 2..6."
                   )  # fmt: skip
STEAM = (
    click.option("--back", metavar="B",
                 help="Back pressure as a share of the steam pressure: 0.1, 10%; default: the best, to"
                 " which the steam expands."),
    click.option("--exponent", metavar="N", help="n of p Vⁿ = const.; default 1, Mariotte's law."),
    click.option("--clearance", metavar="C", help="Clearance as a share of the swept volume: 0.05, 5%."),
    click.option("--card", multiple=True, metavar="FILE", type=click.Path(),
                 help="Indicator card: CSV with position, p_forward [bar], p_return [bar]."),
    click.option("--other-side", metavar="PRESSURE",
                 help="With --card and --single-acting: pressure on the piston's other face, 1bar."),
    click.option("--single-acting", is_flag=True,
                 help="Steam works on the outstroke only; on the return both faces have the back"
                 " pressure."),
)  # fmt: skip
CRANKS = click.option("--cranks", metavar="ANGLES",
                      help="Angles by which the cranks follow the first, with cylinders alike: 0;90 or"
                      " 0;120;240.")  # fmt: skip
STEAM_NAMES = ("eps", "back", "exponent", "clearance", "card", "other_side", "single_acting")
# What a page without forces takes for the masses' sake alone.
ONLY_MASSES = ("stroke", "bore", "pressure")
# --eps, the steam or a card, but neither ratio nor method.
steam_options = in_order((EPS, *STEAM))


def engine_conditions(options: Mapping[str, Any]) -> bool:
    """Whether there is steam, or an indicator card."""
    return bool(options["eps"] or options["card"])


def engine_options(command: Command) -> Command:
    """Add what describes the engine: --eps, --ratio, --back and so on, and --method."""
    options = (
        EPS,
        click.option("-r", "--ratio", multiple=True, metavar="R:L",
                     help="Crank ratio: 1:5, 1:4,5; lists and ranges 1:3..6; 1:∞ is the infinite rod."),
        *STEAM,
        CRANKS,
        click.option("--method", type=Name("method", _method_names), multiple=True,
                     help="exact (default), series (first order) or weisbach (his equations of § 150)."),
    )  # fmt: skip
    return in_order(options)(command)


def columns_option(layout: str, example: str) -> Callable[[Command], Command]:
    return click.option(
        "--columns", type=Columns(layout), multiple=True, metavar="NAMES",
        help=f"Columns and their order: {example}; `kurbel quantities` lists them.",
    )  # fmt: skip


@click.command()
@machine_option
@engine_options
@mass_options
@click.option("--speed", metavar="SPEED", help="Speed: 120/min, 12.5rad/s.")
@click.option("--detail", is_flag=True, help="All that leads to δ: angles and speeds of both strokes.")
@columns_option("weisbach-150", "epsilon,delta,mean_force")
@layout_option("", "irregularity", "strokes")
@output_options
def delta(**options: Any) -> None:
    """Print the degree of irregularity δ of a steam engine over the expansion ratio ε.

    \b
    kurbel delta --eps 2..6
    kurbel delta --eps 2 --detail
    kurbel delta --eps 2..6 --method exact --method series --method weisbach
    kurbel delta --eps 2..8 --ratio '1:4;1:5;1:∞' --back 0.1 -f latex -o anhang.tex
    kurbel delta --eps 4 --cranks '0;90' --detail
    """  # fmt: skip
    _check_masses(options, ("speed", *ONLY_MASSES))
    print_engine(options, _delta_layout(without_outdone(options, RIVALS)), ("irregularity", "strokes"))


def _delta_layout(options: Mapping[str, Any]) -> str:
    """The layout named, or the one that shows what was asked for."""
    if options["detail"]:
        if options["layout"] not in (None, "delta-detail"):
            raise ProblemError(
                f"--detail is layout delta-detail, and --layout names {options['layout']}; leave one out"
            )
        return "delta-detail"
    if options["layout"]:
        return str(options["layout"])
    several = len(set(options["method"])) > 1
    by_stroke = "alpha_cutoff" in notation.names(options["columns"], "columns", "epsilon,delta")
    if (options["card"] or by_stroke) and not several:
        return "delta-detail"
    if several:
        return "delta-verfahren"
    return "delta-tafel" if len(notation.ratios(options["ratio"])) > 1 else "weisbach-150"


@click.command()
@machine_option
@engine_options
@mass_options
@click.option("--speed", metavar="SPEED", help="Speed: 120/min, 12.5rad/s.")
@click.option("--angle", multiple=True, metavar="ANGLES",
              help="Crank angles in degrees: 22.5, 2°30', lists 0;45;90, ranges 0..360:10.")  # fmt: skip
@click.option("--step", metavar="ANGLE", help="Step of the angles through the whole turn; default 10.")
@columns_option("turning", "phi,tangential,energy")
@layout_option("turning", "turning")
@output_options
def turning(**options: Any) -> None:
    """Print the turning effort of a steam engine: tangential force and excess energy over the crank angle.

    \b
    kurbel turning --eps 4 --ratio 1:5
    kurbel turning --eps 4 --cranks '0;90' --step 15
    kurbel turning --eps 4 --step 0.5 -f csv -o drehkraft.csv
    """  # fmt: skip
    from kurbel.page.layouts import layout_of

    _check_masses(options, ("speed", *ONLY_MASSES))
    if options["angle"] and options["step"] is not None:
        raise ProblemError("--angle lists the angles and --step runs through the turn; use one or the other")
    if options["step"] is not None:
        angles: Sequence[Fraction] = notation.progression(
            Fraction(0), Fraction(360), notation.angle(options["step"], "step")
        )
    else:
        angles = notation.angles(options["angle"] or layout_of(options["layout"], ("turning",)).angles)
    print_engine(options, options["layout"], ("turning",), angles=angles)


@click.command()
@machine_option
@engine_options
@mass_options
@click.option("--power", metavar="POWER",
              help="Power of the engine: 50kW, 68PS; with masses it follows from the steam.")  # fmt: skip
@click.option("--speed", metavar="SPEED", required=True, help="Speed: 120/min, 12.5rad/s.")
@click.option("--delta", multiple=True, metavar="δ", required=True,
              help="Degree of irregularity to keep: 1:100, 0.01; lists 1:50;1:100.")  # fmt: skip
@click.option("--radius", metavar="LENGTH", help="Radius at which the mass of the rim is wanted: 1.5m.")
@columns_option("flywheel", "target,swing,inertia")
@layout_option("flywheel", "flywheel")
@output_options
def flywheel(**options: Any) -> None:
    """Print the flywheel that keeps a steam engine even: energy swing, moment of inertia, mass.

    \b
    kurbel flywheel --power 50kW --speed 120/min --delta 1:100 --eps 4 --ratio 1:5
    kurbel flywheel --power 50kW --speed 120/min --delta '1:50;1:100' --eps 4 --radius 1.5m
    """  # fmt: skip
    from kurbel.drive.flywheel import Flywheel
    from kurbel.reading.units import length, speed

    _check_masses(options, ONLY_MASSES)
    watts, turns = _power(options), speed(options["speed"])
    radius = None if options["radius"] is None else length(options["radius"], "radius")
    wheels = [Flywheel(watts, turns, each, radius) for each in notation.irregularities(options["delta"])]
    print_engine(options, options["layout"], ("flywheel",), flywheels=tuple(wheels))


def _power(options: Mapping[str, Any]) -> Fraction | None:
    """Return the power in watts; with masses it follows from the steam, against which they are weighed."""
    from kurbel.reading.units import power

    if is_heavy(options):
        if options["power"] is not None and typed("power"):
            raise ProblemError(
                "with masses the power follows from pressure, bore, stroke and speed; leave --power out"
            )
        return None
    if options["power"] is None:
        raise ProblemError("a flywheel needs the power of the engine; add --power, for example --power 50kW")
    return power(options["power"])


def _check_masses(options: Mapping[str, Any], names: tuple[str, ...]) -> None:
    """Refuse what is for the masses where there are none."""
    for name in names:
        if not is_heavy(options) and options[name] is not None and typed(name):
            raise ProblemError(f"--{name} is for moving masses; add --reciprocating or a rod, --rod-mass")


def print_engine(options: dict[str, Any], name: str, subjects: tuple[str, ...], **rest: Any) -> None:
    from kurbel.cli.printing import Printing, print_table
    from kurbel.engine.request import EngineRequest
    from kurbel.page.layouts import layout_of

    printing = Printing.chosen(options)
    page = layout_of(name, subjects)
    options = without_outdone(options, RIVALS)
    engines = engines_of(page, options)
    request = EngineRequest(
        layout=page,
        **engines,
        methods=tuple(dict.fromkeys(options["method"])),
        **sheet_of(options, "epsilon,delta"),
        load=load_of(options),
        **rest,
    )
    print_table(request, printing)


def engines_of(page: Layout, options: Mapping[str, Any]) -> dict[str, Any]:
    """Return what the options say of engines, as EngineRequest takes it."""
    from kurbel.cli.table import cranks_of

    beside = ("bore",) if options["card"] else ("bore", "pressure")
    # A flywheel has the speed too, which is no speed of the piston without its masses.
    drives = cranks_of(page, {**options, "speed": None})
    return {
        "steams": _diagrams(options) if options["card"] else _steams(page, options),
        "drives": with_masses(drives, options, beside),
        "double": not options["single_acting"],
        "cranks": notation.crank_angles("0" if options["cranks"] is None else options["cranks"]),
    }


def _diagrams(options: Mapping[str, Any]) -> list[Diagram]:
    from kurbel.engine.card_file import read_card
    from kurbel.engine.engine import Diagram
    from kurbel.reading.units import pressure

    for name in ("eps", "back", "exponent", "clearance"):
        if options[name] not in (None, ()):
            raise ProblemError(
                f"--{name} describes an ideal card, and --card gives a measured one; leave one out"
            )
    if options["other_side"] is not None and not options["single_acting"]:
        raise ProblemError("--other-side is for --single-acting; double-acting, the other end works as well")
    other = None if options["other_side"] is None else float(pressure(options["other_side"], "other side"))
    return [Diagram(read_card(file), other) for file in options["card"]]


def _steams(page: Layout, options: Mapping[str, Any]) -> list[Steam]:
    from kurbel.engine.engine import Steam

    if options["other_side"] is not None:
        raise ProblemError("--other-side is for --card; of an ideal card --back is the pressure there")
    back = None if options["back"] is None else notation.share(options["back"], "back pressure")
    exponent = notation.number("1" if options["exponent"] is None else options["exponent"], "exponent")
    clearance = notation.share("0" if options["clearance"] is None else options["clearance"], "clearance")
    expansions = notation.numbers(options["eps"] or page.expansions, "expansion ratio")
    return [Steam(expansion, back, exponent, clearance) for expansion in expansions]
