"""The lines below a table about engines: units, directions, signs, the method, the engine."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product

from kurbel.drive.at import CRANK_FORCES, known
from kurbel.engine.captions import cylinder_notes, joined, load_label, masses_notes, named_ratio
from kurbel.engine.engine_quantities import AT_ANGLE, DIRECTIONS, EXTREMES, OF_RUNS, Needs
from kurbel.engine.loads.words import engine_lines
from kurbel.engine.request import BY_STROKE, OF_FORCES, OF_IRREGULARITY, OF_LOAD, OVER_ANGLE, EngineRequest
from kurbel.exact.numerals import Label, Number, exact_text, number_text
from kurbel.motion.notes import turns_label
from kurbel.page.quantity import AND, Of, Quantity, Texts, enumerated_letters, words
from kurbel.page.table import Note
from kurbel.reading.amounts import amount

ENGINE = Texts("engine", "engine")
SIGNS = Texts("engine", "signs")
SUPPLIED = Texts("engine", "supplied")

# The mark of the two extremes that make δ.
MAKES_DELTA = "a"
# What is in units of Q on pages of whole turns, which otherwise are not.
OF_WORK = ("work", "mean_pressure")
OF_DELTA = ("delta", "v_min", "v_max")
ERRORS = words("geschätzter Fehler|estimated error")
# Whose pages say in which angles their solutions are.
SOLVED = "loaded roots"
# What the tangential force is of.
OF_EFFORT = ("tangential", "torque")
# Forces that count to a side; all others of the frame count along the slide.
ACROSS = ("guide_force", "bearing_across")
# What is counted in the mean torque.
IN_MEAN = ("mean_torque", "swing_share", "number")
# Pages that state the convention as a whole, as long as no columns of them are chosen.
OF_ALL = (*BY_STROKE, "compressor")


def notes(request: EngineRequest) -> Iterator[Label | Note]:
    """Yield the lines below the table: its own, the units, the method, the engine."""
    lang, subject, columns = request.lang, request.layout.subject, request.page_columns
    if marks_delta(request):
        yield Note(ENGINE["makes_delta"][lang], MAKES_DELTA)
    if any(len(column.methods) > 1 for column in columns):
        yield ENGINE["difference"][lang]
    if subject in OF_IRREGULARITY:
        yield from _of_delta(request)
    if subject == "flywheel":
        yield ENGINE["flywheel"][lang].format(at_radius=at_radius(request))
        if any(column.key == "inertia_true" for column in columns):
            yield ENGINE["true_inertia"][lang]
        radius = request.flywheels[0].radius
        if radius is not None:
            yield ENGINE["radius"][lang].format(radius=amount(radius, "m", exact_text))
    if subject in BY_STROKE:
        yield ENGINE["turn" if request.first.plain else "whole_turn"][lang]
    yield from _zero(request)
    if _says_forces(request):
        yield request.words.forces[lang]
    yield from _directions(request, [column.quantity for column in columns])
    needs = {need for column in columns for need in column.quantity.needs}
    alike = request.assembly is None
    # The power of an engine that is not given follows from its sizes.
    powered = alike and any(one.power is None for one in request.flywheels)
    newtons = powered or needs & {Needs.LOAD, Needs.TORQUE, Needs.POWER}
    if alike and request.load is not None and (request.first.crank.loaded or newtons):
        yield request.words.newtons(request.steams[0], request.load)
    if request.first.crank.moving is None:
        if powered:
            yield _radius(request)
        elif Needs.POWER in needs:
            yield _sized(request)
    if _by_weisbach(request):
        yield ENGINE["weisbach"][lang]
    yield from engine_notes(request)
    yield from _first_order(request)
    if request.carded and subject not in OF_FORCES:
        yield from _errors(request)


def _zero(request: EngineRequest) -> Iterator[Label]:
    """Where angles of a drive begin whose inner dead centre is not where φ begins."""
    subject, columns = request.layout.subject, request.page_columns
    shown = subject in OVER_ANGLE or any(one.quantity.minutes for one in columns)
    if shown and subject != SOLVED and not from_dead_centre(request, columns[0].methods[0]):
        by_stroke = subject in BY_STROKE and request.first.plain
        of_slide = subject in (*OVER_ANGLE, *OF_FORCES)
        said = "over_slide" if of_slide else "strokes_from_slide" if by_stroke else "from_slide"
        yield ENGINE[said][request.lang]


def _first_order(request: EngineRequest) -> Iterator[Label]:
    """What is of first order and what is not, of all that the page shows."""
    shown = [one.quantity for one in request.page_columns if "series" in one.methods]
    heavy = any(part.crank.moving is not None for part in request.first.parts)
    slanting = any(part.crank.ratio for part in request.first.parts) or any(request.ratios)
    efforts = [one for one in shown if one.of in (Of.CRANK, Of.ORDER) or one.key.startswith(OF_EFFORT)]
    said = {
        "first_order_masses": heavy and efforts,
        "first_order_energy": heavy and len(efforts) < len(shown),
        "first_order_forces": efforts,
        "first_order_work": slanting and efforts and any(one.key == "energy" for one in shown),
        "first_order_mean": slanting and any(one.of is Of.ORDER for one in shown),
    }
    if shown:
        parts = ["first_order", *(part for part, holds in said.items() if holds)]
        yield "; ".join(ENGINE[part][request.lang] for part in parts)


def engine_notes(request: EngineRequest) -> Iterator[Label]:
    """Yield the lines about the engine itself: its load, its drive, its masses."""
    lang = request.lang
    if request.assembly is None:
        yield "; ".join(engine_lines(request.steams, request.first.parts[0], lang))
    else:
        yield from cylinder_notes(request.assembly, request.numbers, lang)
    yield from request.mechanism.loaded_notes(request.drives, lang)
    if request.driven:
        yield from convention(request)
    if request.assembly is not None:
        yield from masses_notes(request, lang)
    elif request.first.crank.loaded:
        shown = [one.key for one in request.page_columns]
        crank, letters = request.first.crank, request.layout.ratio_symbol
        yield from request.mechanism.masses_notes(crank, letters, lang, shown)


def marks_delta(request: EngineRequest) -> bool:
    """Whether the page marks the extremes of which the δ on it is made."""
    shown = {column.quantity.key for column in request.page_columns}
    by_stroke = request.layout.subject in BY_STROKE and request.first.plain
    return by_stroke and "delta" in shown and not shown.isdisjoint(OF_DELTA[1:])


def _of_delta(request: EngineRequest) -> Iterator[Label]:
    """What δ is, if it is printed, and the letters of the units that it and its extremes have."""
    lang, shown = request.lang, {column.quantity.key for column in request.page_columns}
    letters = ["mean_force"] if "delta" in shown or _by_weisbach(request) else []
    if not shown.isdisjoint(OF_DELTA):
        letters.append("flywheel_mass")
    said = ", ".join(ENGINE[one][lang] for one in letters).replace("{at_radius}", at_radius(request))
    if said:
        yield f"{ENGINE['delta'][lang]}; {said}" if "delta" in shown else said


def _by_weisbach(request: EngineRequest) -> bool:
    """Whether the page prints Weisbach's equations, and numbers by them alone."""
    return any(
        column.methods == ("weisbach",) and column.quantity.of not in OF_RUNS
        for column in request.page_columns
    )


def at_radius(request: EngineRequest) -> Label:
    """Where masses and forces at the crank pin are; r is explained once on a page."""
    return ENGINE["at_radius" if _says_forces(request) else "at_crank_radius"][request.lang]


def _says_forces(request: EngineRequest) -> bool:
    """Whether the page says what Q and r are."""
    return request.layout.subject in (*BY_STROKE, *OF_FORCES, *OF_LOAD, *OVER_ANGLE) or any(
        one.quantity.key in OF_WORK for one in request.page_columns
    )


def _sized(request: EngineRequest) -> Label:
    """The speed that makes a power of the work, and the radius where cylinders do not have their strokes."""
    turns = turns_label(known(request.first.crank.speed))
    return f"{_radius(request)}, {turns}" if request.assembly is None else turns


def _radius(request: EngineRequest) -> Label:
    radius = known(request.first.crank.radius)
    return f"${request.layout.ratio_symbol[0]} = {amount(radius, 'mm', exact_text)}$"


def from_dead_centre(request: EngineRequest, method: str) -> bool:
    """Whether φ, which counts from the slide direction, counts from the inner dead centre, too."""
    return all(request.turn(0, one, method).cylinder.drive.regular for one in range(len(request.drives)))


def _directions(request: EngineRequest, shown: Sequence[Quantity]) -> Iterator[Label]:
    """The directions of what is shown: of all forces and the torque on one line, with whose they are."""
    lang = request.lang
    torques = [one for one in shown if Needs.TORQUE in one.needs and one.of is Of.ANGLE]
    yield from dict.fromkeys(
        one.direction[lang] for one in shown if one.of is Of.ANGLE and one.direction and one not in torques
    )
    # The force on the piston, which has none, comes first.
    in_order = ["piston_force", *DIRECTIONS]
    forces = sorted(
        (one for one in shown if one.of is Of.CRANK),
        key=lambda one: in_order.index(one.key.removesuffix("_n")),
    )
    if forces or torques:
        yield "; ".join(_force_directions(request, forces, torques))


def _direction(request: EngineRequest, force: Quantity) -> Label:
    """The direction of a force; the load at the crosshead is the sum of all that acts there."""
    said, crank = known(force.direction)[request.lang], request.first.crank
    others = (" + F_G" if crank.weighed else "") + (" + F_R" if crank.has_friction else "")
    return said.replace("F + F_m", f"F + F_m{others}")


def _force_directions(
    request: EngineRequest, forces: Sequence[Quantity], torques: Sequence[Quantity]
) -> Iterator[Label]:
    lang, several = request.lang, len(request.cranks) > 1
    # S is a thrust or a pull, which a direction in the frame does not say.
    frame = {key for key, one in CRANK_FORCES.items() if one.framed} - {"rod_force", "pin_rod_force"}
    framed = [one for one in forces if one.key.removesuffix("_n") in frame]
    if framed:
        ways = {one.key.removesuffix("_n") in ACROSS for one in framed}
        said = "framed" if len(ways) == 2 else "framed across" if ways == {True} else "framed along"
        letters = dict.fromkeys(one.symbol.strip("$") for one in framed)
        yield ENGINE[said][lang].format(letters=enumerated_letters([*letters], lang))
    yield from dict.fromkeys(_direction(request, one) for one in forces if one.direction)
    for one in torques:
        if one.direction:
            yield one.direction[lang] + (ENGINE["all_cranks"][lang] if several else "")
    if several:
        yield ENGINE["first_crank"][lang]
    if request.first.crank.moving is None:
        yield ENGINE["massless"][lang]


def _errors(request: EngineRequest) -> Iterator[Label]:
    """The errors of what is printed of whole turns, a line for each card and ratio."""
    columns = [
        error
        for column in request.page_columns
        if column.quantity.of not in AT_ANGLE and not column.quantity.minutes
        for error in request.subject.beside(request, column)
    ]
    last = {"stroke": len(request.spans) - 1, **({"target": 0} if request.flywheels else {})}
    for steam, ratio in product(range(len(request.steams)), range(len(request.ratios))):
        # A card of which no figure is to be trusted is refused here, whatever is printed of it.
        request.turn(steam, ratio, request.page_columns[0].methods[0])
        place = {"expansion": steam, "ratio": ratio, **last}
        numbers = [(column.quantity, request.number(column, place)) for column in columns]
        said = [
            f"{one.symbol} ${number_text(error)}$ {one.unit[request.lang]}".rstrip()
            for one, error in numbers
            if isinstance(error, Number)
        ]
        if said:
            yield ERRORS[request.lang] + _apart(request, steam, ratio) + ": " + ", ".join(said)


def _apart(request: EngineRequest, steam: int, ratio: int) -> Label:
    """What tells an engine from the others of the page."""
    cards = [load_label(request, steam)] if len(request.steams) > 1 else []
    ratios = [named_ratio(request, ratio)] if len(request.ratios) > 1 else []
    return joined([*cards, *ratios], request.lang)


def convention(request: EngineRequest) -> Iterator[Label]:
    """Yield the lines of a driven machine: how it counts, and which guide face is loaded."""
    shown = [column.quantity for column in request.page_columns]
    yield "; ".join(_clauses(request, shown))
    guided = any(one.key.startswith("guide_force") for one in shown)
    whole = request.layout.subject in OF_ALL and not request.columns
    if request.mechanism.crosshead and (guided or whole):
        yield SIGNS["turning_sense"][request.lang]


def _clauses(request: EngineRequest, shown: list[Quantity]) -> Iterator[Label]:
    lang = request.lang
    yield SIGNS["signs"][lang]
    if any(one.key == "delta" for one in shown):
        yield SIGNS["magnitude"][lang]
    counted = any(one.key in IN_MEAN and one.of is not Of.CYLINDER for one in shown)
    if counted or (request.wheel is not None and request.wheel.number is not None):
        yield SIGNS["mean"][lang]
    # Those of a list of cylinders have their signs.
    named = [SUPPLIED[one.key][lang] for one in shown if one.key in SUPPLIED and one.of is not Of.CYLINDER]
    if named:
        yield SIGNS["supplied"][lang].format(names=AND[lang].join(dict.fromkeys(named)))
    # Of the speed under a given flywheel extremes, and what is made of both.
    even = (one.of is Of.EVENNESS and one.key != "number" for one in shown)
    if any(one.key == "delta" or one.of in EXTREMES for one in shown) or any(even):
        yield SIGNS["exchanged"][lang]
