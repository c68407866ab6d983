"""What a page about engines says of itself: caption, units, steam and cranks, in both languages."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import product

from kurbel.engine.axes import engine_lines, load_label, named_load
from kurbel.engine.quantities import AT_ANGLE, ENGINE_METHODS, FORCES
from kurbel.engine.request import BY_STROKE, OF_FORCES, OF_IRREGULARITY, OF_LOAD, OVER_ANGLE, EngineRequest
from kurbel.exact.numerals import Label, Number, exact_text, number_text
from kurbel.page.quantity import AND, FOR, Quantity, enumerated_letters, filled, words
from kurbel.page.table import Note
from kurbel.reading.amounts import amount
from kurbel.reading.notation import ratio_text

# The mark of the two extremes that make δ.
MAKES_DELTA = "a"
# What is in units of Q on pages of whole turns, which otherwise are not.
OF_WORK = ("work", "mean_pressure")
OF_DELTA = ("delta", "v_min", "v_max")
ERRORS = words("geschätzter Fehler|estimated error")
PLAIN_CAPTION = words("{quantities} {machine}{for_engine}; {method}")
# Whose pages say in which angles their solutions are.
SOLVED = "loaded roots"
# What the tangential force is of.
OF_EFFORT = ("tangential", "torque")
# What is of the speed under a given flywheel.
OF_RUNS = ("speed", "evenness")
FIRST_ORDER = words("erste Ordnung nach Weisbach|first order by Weisbach")
DRIVEN = words("der Arbeitsmaschine|of the driven machine")
# Forces that count to a side; all others of the frame count along the slide.
ACROSS = ("guide_force", "bearing_across")
WORDS = {
    "first_order": words(
        "Erste Ordnung, $φ$ vom inneren Totpunkt: Weg und Arbeit mit $1 - cos φ + 1/2 λ sin^2 φ$"
        "|First order, $φ$ from the inner dead centre: path and work with $1 - cos φ + 1/2 λ sin^2 φ$"
    ),
    "first_order_masses": words(
        "Massen mit $p$ als $cos φ + λ cos 2 φ$, $ε_L$ als $-λ sin φ$"
        "|masses with $p$ as $cos φ + λ cos 2 φ$, $ε_L$ as $-λ sin φ$"
    ),
    "first_order_forces": words(
        "Kräfte beim genauen Winkel $ψ$ der Stange, $T$ mit $sin(φ + ψ)/(cos ψ)$"
        "|forces at the exact angle $ψ$ of the rod, $T$ with $sin(φ + ψ)/(cos ψ)$"
    ),
    "first_order_energy": words(
        "Energie der Massen mit $c$ als $sin φ + 1/2 λ sin 2 φ$, $ω_L$ als $λ cos φ$"
        "|energy of the masses with $c$ as $sin φ + 1/2 λ sin 2 φ$, $ω_L$ as $λ cos φ$"
    ),
    "first_order_work": words(
        "daher wächst $W$ nicht genau mit $T - P$|hence $W$ does not quite grow with $T - P$"
    ),
    "first_order_mean": words(
        "$P$ aus der Arbeit, daher nicht genau das Mittel von $T$"
        "|$P$ from the work, hence not quite the mean of $T$"
    ),
    "makes_delta": words("aus diesen beiden folgt $δ$|$δ$ follows from these two"),
    "delta": words('$δ = (v_"max" - v_"min")/v_1$'),
    "mean_force": words("$P$ mittlere Umfangskraft|$P$ mean tangential force"),
    "flywheel_mass": words(
        "$m_1$ Schwungmasse {at_radius}, $v_1$ Kurbelgeschwindigkeit im inneren Totpunkt"
        "|$m_1$ flywheel mass {at_radius}, $v_1$ crank-pin velocity at the inner dead centre"
    ),
    "at_crank_radius": words("am Kurbelhalbmesser $r$|at the crank radius $r$"),
    "at_radius": words("bei $r$|at $r$"),
    "framed": words(
        "{letters} positiv in der Richtung des Hinganges und nach der Seite, auf der dort der"
        " Kurbelzapfen läuft"
        "|{letters} positive in the direction of the outstroke and towards the side on which the"
        " crank pin then runs"
    ),
    "framed along": words(
        "{letters} positiv in der Richtung des Hinganges|{letters} positive in the direction of the outstroke"
    ),
    "framed across": words(
        "{letters} positiv nach der Seite, auf der beim Hingang der Kurbelzapfen läuft"
        "|{letters} positive towards the side on which the crank pin runs on the outstroke"
    ),
    "all_cranks": words(", von allen Kurbeln|, of all cranks"),
    "first_crank": words("die übrigen der ersten Kurbel|the others of the first crank"),
    "massless": words("ohne Massen|without masses"),
    "flywheel": words(
        "$(ΔW)/(P r)$ ist $δ$ in $(P r)/(m_1 v_1^2)$, $J = (ΔW)/(δ ω^2)$;"
        " $P$ mittlere Umfangskraft {at_radius}"
        "|$(ΔW)/(P r)$ is $δ$ in $(P r)/(m_1 v_1^2)$, $J = (ΔW)/(δ ω^2)$;"
        " $P$ mean tangential force {at_radius}"
    ),
    "true_inertia": words(
        "mit $J_δ$ bleibt die Geschwindigkeit der Maschine mit ihren Massen genau in $ω (1 ± δ/2)$"
        "|with $J_δ$ the speed of the machine with its masses stays exactly within $ω (1 ± δ/2)$"
    ),
    "radius": words("$ρ = {radius}$"),
    "turn": words(
        "Winkel vom Totpunkt des Hubes, in der Umdrehung vom inneren Totpunkt"
        "|Angles from the dead centre of the stroke, over the turn from the inner one"
    ),
    "whole_turn": words(
        "Winkel vom inneren Totpunkt der ersten Kurbel|Angles from the inner dead centre of the first crank"
    ),
    "from_slide": words(
        "$α$ vom inneren Totpunkt, $φ$ anderer Seiten von der Schubrichtung: $φ = α + φ_i$"
        "|$α$ from the inner dead centre, $φ$ of other pages from the slide direction: $φ = α + φ_i$"
    ),
    "strokes_from_slide": words(
        "$φ$ anderer Seiten von der Schubrichtung: $φ = α + φ_i$, wo Rückgang steht $φ = α + φ_o$"
        "|$φ$ of other pages from the slide direction: $φ = α + φ_i$, where Return stands $φ = α + φ_o$"
    ),
    "over_slide": words(
        "$φ$ von der Schubrichtung, der innere Totpunkt bei $φ_i$; $α$ anderer Seiten in der Umdrehung von"
        " dort: $φ = α + φ_i$"
        "|$φ$ from the slide direction, the inner dead centre at $φ_i$; $α$ of other pages over the turn from"
        " there: $φ = α + φ_i$"
    ),
    "difference": words(
        "Unterschied: genauer Wert weniger Näherung, vor dem Runden gebildet."
        "|Difference: exact value less approximation, taken before rounding."
    ),
    "weisbach": words(
        "$sin α_1 = P/(Q - R_b) ± r/(2 l) sin 2 α_1$,"
        " $P tan(α_2/2) = 2 Q/ε (1 ± r/l q) - 2 R_b q (1 ∓ r/l cos α_2)$, $q = sin^2(α_2/2)$;"
        " oberes Zeichen: Rückgang, unteres Zeichen: Hingang"
        "|$sin α_1 = P/(Q - R_b) ± r/(2 l) sin 2 α_1$,"
        " $P tan(α_2/2) = 2 Q/ε (1 ± r/l q) - 2 R_b q (1 ∓ r/l cos α_2)$, $q = sin^2(α_2/2)$;"
        " upper sign: return stroke, lower sign: outstroke"
    ),
}


def caption(request: EngineRequest) -> Label:
    """Return the layout's caption with what all its engines have in common, and the method."""
    methods = dict.fromkeys(method for column in request.page_columns for method in column.methods)
    parts = {"{quantities}": ", ".join(_names(request)), **about_engines(request, methods)}
    text = PLAIN_CAPTION if request.columns else request.layout.caption
    return filled(text[request.lang], parts.items())


def about_engines(request: EngineRequest, methods: Iterable[str]) -> Mapping[str, Label]:
    """Return what captions say of the engines, by the places where they say it."""
    lang = request.lang
    return {
        "{machine}": (DRIVEN if request.carded and request.driven else request.words.machine)[lang],
        "{for_engine}": _joined(list(common(request)), lang),
        "{method}": AND[lang].join(_method(request, one) for one in methods),
    }


def _method(request: EngineRequest, method: str) -> Label:
    """What captions say of a method; Weisbach's speed takes none of his equations for the angles."""
    of_angles = any(column.quantity.of not in OF_RUNS for column in request.page_columns)
    said = ENGINE_METHODS[method].caption if method != "weisbach" or of_angles else FIRST_ORDER
    return said[request.lang]


def _names(request: EngineRequest) -> list[str]:
    names = [
        f"{column.quantity.name[request.lang]} {column.quantity.symbol}" for column in request.page_columns
    ]
    first, *others = dict.fromkeys(names)
    return [first[:1].upper() + first[1:], *(inner(name, request.lang) for name in others)]


def inner(name: str, lang: str) -> str:
    """Return a name as it is within a sentence: German nouns keep their capital."""
    return name[:1].lower() + name[1:] if lang == "en" else name


def _joined(parts: list[str], lang: str) -> str:
    return FOR[lang] + ", ".join(parts) if parts else ""


def common(request: EngineRequest) -> Iterator[Label]:
    shown = (*request.layout.across, *request.layout.stub)
    if len(request.steams) == 1 and "expansion" not in shown and request.words.captioned:
        yield named_load(request, 0)
    if len(request.ratios) == 1 and "ratio" not in shown and request.assembly is None:
        yield _named_ratio(request, 0)


def _named_ratio(request: EngineRequest, index: int) -> Label:
    return f"${request.layout.ratio_symbol} = {ratio_text(request.ratios[index])}$"


def notes(request: EngineRequest) -> Iterator[Label | Note]:
    """Yield the lines below the table: its own, the units, the method, the engine."""
    lang, subject, columns = request.lang, request.layout.subject, request.page_columns
    if marks_delta(request):
        yield Note(WORDS["makes_delta"][lang], MAKES_DELTA)
    yield from (note[lang] for note in request.layout.notes)
    if any(len(column.methods) > 1 for column in columns):
        yield WORDS["difference"][lang]
    if subject in OF_IRREGULARITY:
        yield from _of_delta(request)
    if subject == "flywheel":
        yield WORDS["flywheel"][lang].format(at_radius=at_radius(request))
        if any(column.key == "inertia_true" for column in columns):
            yield WORDS["true_inertia"][lang]
        radius = request.flywheels[0].radius
        if radius is not None:
            yield WORDS["radius"][lang].format(radius=amount(radius, "m", exact_text))
    if subject in BY_STROKE:
        yield WORDS["turn" if request.first.plain else "whole_turn"][lang]
    yield from _zero(request)
    if _says_forces(request):
        yield request.words.forces[lang]
    yield from _directions(request, [column.quantity for column in columns])
    needs = {column.quantity.needs for column in columns}
    alike = request.assembly is None
    # The power of an engine that is not given follows from its sizes.
    powered = alike and any(one.power is None for one in request.flywheels)
    newtons = powered or needs & {"load", "torque", "power", "flow"}
    if alike and request.load is not None and (request.first.crank.loaded or newtons):
        yield request.words.newtons(request.steams[0], request.load)
    if request.first.crank.moving is None:
        if powered:
            yield _radius(request)
        elif needs & {"power", "flow"}:
            yield _sized(request)
    if _by_weisbach(request):
        yield WORDS["weisbach"][lang]
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
        yield WORDS[said][request.lang]


def _first_order(request: EngineRequest) -> Iterator[Label]:
    """What is of first order and what is not, of all that the page shows."""
    shown = [one.quantity for one in request.page_columns if "series" in one.methods]
    heavy = any(part.crank.moving is not None for part in request.first.parts)
    slanting = any(part.crank.ratio for part in request.first.parts) or any(request.ratios)
    efforts = [one for one in shown if one.of in ("crank", "order") or one.key.startswith(OF_EFFORT)]
    said = {
        "first_order_masses": heavy and efforts,
        "first_order_energy": heavy and len(efforts) < len(shown),
        "first_order_forces": efforts,
        "first_order_work": slanting and efforts and any(one.key == "energy" for one in shown),
        "first_order_mean": slanting and any(one.of == "order" for one in shown),
    }
    if shown:
        parts = ["first_order", *(part for part, holds in said.items() if holds)]
        yield "; ".join(WORDS[part][request.lang] for part in parts)


def engine_notes(request: EngineRequest) -> Iterator[Label]:
    """Yield the lines about the engine itself: its load, its drive, its masses."""
    lang = request.lang
    if request.assembly is None:
        yield "; ".join(engine_lines(request, lang))
    else:
        from kurbel.engine.cylinders.words import cylinder_notes

        yield from cylinder_notes(request.assembly, request.numbers, lang)
    yield from request.mechanism.loaded_notes(request.drives, lang)
    if request.driven:
        from kurbel.engine.loads.convention import convention

        yield from convention(request)
    if request.assembly is not None:
        from kurbel.engine.cylinders.words import masses_notes

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
    said = ", ".join(WORDS[one][lang] for one in letters).replace("{at_radius}", at_radius(request))
    if said:
        yield f"{WORDS['delta'][lang]}; {said}" if "delta" in shown else said


def _by_weisbach(request: EngineRequest) -> bool:
    """Whether the page prints Weisbach's equations, and numbers by them alone."""
    return any(
        column.methods == ("weisbach",) and column.quantity.of not in OF_RUNS
        for column in request.page_columns
    )


def at_radius(request: EngineRequest) -> Label:
    """Where masses and forces at the crank pin are; r is explained once on a page."""
    return WORDS["at_radius" if _says_forces(request) else "at_crank_radius"][request.lang]


def _says_forces(request: EngineRequest) -> bool:
    """Whether the page says what Q and r are."""
    return request.layout.subject in (*BY_STROKE, *OF_FORCES, *OF_LOAD, *OVER_ANGLE) or any(
        one.quantity.key in OF_WORK for one in request.page_columns
    )


def _sized(request: EngineRequest) -> Label:
    """The speed that makes a power of the work, and the radius where cylinders do not have their strokes."""
    from kurbel.motion.captions import turns_label

    crank = request.first.crank
    assert crank.speed is not None
    if request.assembly is not None:
        return turns_label(crank.speed)
    return f"{_radius(request)}, {turns_label(crank.speed)}"


def _radius(request: EngineRequest) -> Label:
    radius = request.first.crank.radius
    assert radius is not None
    return f"${request.layout.ratio_symbol[0]} = {amount(radius, 'mm', exact_text)}$"


def from_dead_centre(request: EngineRequest, method: str) -> bool:
    """Whether φ, which counts from the slide direction, counts from the inner dead centre, too."""
    return all(request.turn(0, one, method).cylinder.drive.regular for one in range(len(request.drives)))


def _directions(request: EngineRequest, shown: Sequence[Quantity]) -> Iterator[Label]:
    """The directions of what is shown: of all forces and the torque on one line, with whose they are."""
    lang = request.lang
    torques = [one for one in shown if one.needs == "torque" and one.of == "angle"]
    yield from dict.fromkeys(
        one.direction[lang] for one in shown if one.of == "angle" and one.direction and one not in torques
    )
    in_order = [*FORCES]
    forces = sorted(
        (one for one in shown if one.of == "crank"),
        key=lambda one: in_order.index(one.key.removesuffix("_n")),
    )
    if forces or torques:
        yield "; ".join(_force_directions(request, forces, torques))


def _direction(request: EngineRequest, force: Quantity) -> Label:
    """The direction of a force; the load at the crosshead is the sum of all that acts there."""
    assert force.direction is not None
    said, crank = force.direction[request.lang], request.first.crank
    others = (" + F_G" if crank.weighed else "") + (" + F_R" if crank.rubbed else "")
    return said.replace("F + F_m", f"F + F_m{others}")


def _force_directions(
    request: EngineRequest, forces: Sequence[Quantity], torques: Sequence[Quantity]
) -> Iterator[Label]:
    lang, several = request.lang, len(request.cranks) > 1
    framed = [one for one in forces if FORCES[one.key.removesuffix("_n")].framed]
    if framed:
        ways = {one.key.removesuffix("_n") in ACROSS for one in framed}
        said = "framed" if len(ways) == 2 else "framed across" if ways == {True} else "framed along"
        letters = dict.fromkeys(one.symbol.strip("$") for one in framed)
        yield WORDS[said][lang].format(letters=enumerated_letters([*letters], lang))
    yield from dict.fromkeys(_direction(request, one) for one in forces if one.direction)
    for one in torques:
        if one.direction:
            yield one.direction[lang] + (WORDS["all_cranks"][lang] if several else "")
    if several:
        yield WORDS["first_crank"][lang]
    if request.first.crank.moving is None:
        yield WORDS["massless"][lang]


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
            if isinstance(error, Number) and error.scaled
        ]
        if said:
            yield ERRORS[request.lang] + _apart(request, steam, ratio) + ": " + ", ".join(said)


def _apart(request: EngineRequest, steam: int, ratio: int) -> Label:
    """What tells an engine from the others of the page."""
    cards = [load_label(request, steam)] if len(request.steams) > 1 else []
    ratios = [_named_ratio(request, ratio)] if len(request.ratios) > 1 else []
    return _joined([*cards, *ratios], request.lang)
