"""Drawings of a steam engine: the forces in its crank drive, and its turning effort."""

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from kurbel.commands import parameters as option
from kurbel.commands.cranks import cranks_of
from kurbel.commands.machines import GivenRod, GivenSteam, Masses, engine_question
from kurbel.commands.plots import CurveStep, DrawnColumns, DrawnSpeed, LabelLang, curve_angles, only, page_of
from kurbel.commands.shown import Drawing, mark_of
from kurbel.commands.subject import draws
from kurbel.errors import ProblemError
from kurbel.reading.given import Exact, as_names

if TYPE_CHECKING:
    from kurbel.engine.request import EngineRequest

# The pages whose forces can be drawn, without masses and with them.
ENGINE_LAYOUT, MACHINE_LAYOUT = "engine-forces", "machine-forces"


@draws()
def plot_engine_forces(
    eps: option.Eps = None,
    *,
    ratio: option.Ratios = None,
    columns: DrawnColumns = (),
    method: option.Method = None,
    from_: option.From = None,
    to: option.To = None,
    step: CurveStep = None,
    stroke: option.Stroke = None,
    rod: option.Rod = None,
    speed: DrawnSpeed = None,
    back: option.Back = None,
    exponent: option.Exponent = None,
    clearance: option.Clearance = None,
    card: option.Card = None,
    other_side: option.OtherSide = None,
    single_acting: option.SingleActing = False,
    bore: option.Bore = None,
    pressure: option.Pressure = None,
    reciprocating: option.Reciprocating = None,
    rod_mass: option.RodMass = None,
    centre: option.Centre = None,
    gyration: option.Gyration = None,
    rod_file: option.RodFile = None,
    rotating: option.Rotating = None,
    lang: LabelLang = "de",
    decimal: option.Decimal = None,
) -> Drawing:
    """Draw the forces in the crank drive of a steam engine, those of the first crank."""
    from kurbel.plot.drawings import engine_forces_drawing
    from kurbel.plot.engine import FORCES

    mark, angles = mark_of(lang, decimal), curve_angles(from_, to, step)
    steam = GivenSteam(eps, back, exponent, clearance, card, other_side, single_acting, bore, pressure)
    masses = Masses(reciprocating, GivenRod(rod_mass, centre, gyration, rod_file), rotating)
    question = _force_question(
        steam, masses, (ratio, stroke, rod), speed, method, angles, lang, FORCES, columns
    )
    return Drawing.of(engine_forces_drawing(question, mark), lang, mark)


@draws()
def plot_engine_polar(
    eps: option.Eps = None,
    *,
    ratio: option.Ratios = None,
    method: option.Method = None,
    from_: option.From = None,
    to: option.To = None,
    step: CurveStep = None,
    stroke: option.Stroke = None,
    rod: option.Rod = None,
    speed: DrawnSpeed = None,
    back: option.Back = None,
    exponent: option.Exponent = None,
    clearance: option.Clearance = None,
    card: option.Card = None,
    other_side: option.OtherSide = None,
    single_acting: option.SingleActing = False,
    bore: option.Bore = None,
    pressure: option.Pressure = None,
    reciprocating: option.Reciprocating = None,
    rod_mass: option.RodMass = None,
    centre: option.Centre = None,
    gyration: option.Gyration = None,
    rod_file: option.RodFile = None,
    rotating: option.Rotating = None,
    lang: LabelLang = "de",
    decimal: option.Decimal = None,
) -> Drawing:
    """Draw the polar diagram of the force on the crank pin of a steam engine."""
    from kurbel.plot.drawings import engine_polar_drawing
    from kurbel.plot.engine import PIN_FORCE

    mark, angles = mark_of(lang, decimal), curve_angles(from_, to, step)
    steam = GivenSteam(eps, back, exponent, clearance, card, other_side, single_acting, bore, pressure)
    masses = Masses(reciprocating, GivenRod(rod_mass, centre, gyration, rod_file), rotating)
    question = _force_question(steam, masses, (ratio, stroke, rod), speed, method, angles, lang, PIN_FORCE)
    only(question.steams, "polar", "cards" if question.carded else "expansion ratios")
    only(question.drives, "polar", "ratios")
    return Drawing.of(engine_polar_drawing(question, mark), lang, mark)


@draws()
def plot_turning(
    eps: option.Eps = None,
    *,
    ratio: option.Ratios = None,
    method: option.Method = None,
    from_: option.From = None,
    to: option.To = None,
    step: CurveStep = None,
    stroke: option.Stroke = None,
    rod: option.Rod = None,
    speed: DrawnSpeed = None,
    back: option.Back = None,
    exponent: option.Exponent = None,
    clearance: option.Clearance = None,
    card: option.Card = None,
    other_side: option.OtherSide = None,
    single_acting: option.SingleActing = False,
    cranks: option.Cranks = None,
    bore: option.Bore = None,
    pressure: option.Pressure = None,
    reciprocating: option.Reciprocating = None,
    rod_mass: option.RodMass = None,
    centre: option.Centre = None,
    gyration: option.Gyration = None,
    rod_file: option.RodFile = None,
    rotating: option.Rotating = None,
    lang: LabelLang = "de",
    decimal: option.Decimal = None,
) -> Drawing:
    """Draw the turning effort of a steam engine: tangential force, its mean and the excess energy."""
    from kurbel.plot.drawings import turning_drawing
    from kurbel.plot.turning import COLUMNS

    mark, angles = mark_of(lang, decimal), curve_angles(from_, to, step)
    steam = GivenSteam(eps, back, exponent, clearance, card, other_side, single_acting, bore, pressure)
    masses = Masses(reciprocating, GivenRod(rod_mass, centre, gyration, rod_file), rotating)
    page = page_of("turning")
    drives = cranks_of(page, ratio, stroke, rod)
    question = engine_question(
        page, steam, masses, drives, speed, cranks, _engine_method(method),
        angles=angles, lang=lang, columns=COLUMNS,
    )  # fmt: skip
    return Drawing.of(turning_drawing(question, mark), lang, mark)


def _force_question(
    steam: GivenSteam,
    masses: Masses,
    lengths: tuple[option.Given | None, Exact | None, Exact | None],
    speed: Exact | None,
    method: str | None,
    angles: Sequence[Fraction],
    lang: str,
    keys: tuple[str, ...],
    columns: option.Names = (),
) -> "EngineRequest":
    """Return what is asked for of the forces named, or of these, in newtons where the load is known."""
    from kurbel.plot.engine import known_forces

    names = as_names(columns, "piston_force,tangential_force")
    page = page_of(MACHINE_LAYOUT if masses.first else ENGINE_LAYOUT)
    return engine_question(
        page, steam, masses, cranks_of(page, *lengths), speed, None, _engine_method(method),
        angles=angles, lang=lang, columns=names or known_forces(keys, newtons=steam.load is not None),
    )  # fmt: skip


def _engine_method(method: str | None) -> tuple[str, ...]:
    if method == "infinite":
        raise ProblemError("--method infinite is for the motion alone; of engines write --ratio 1:∞")
    return (method,) if method else ()
