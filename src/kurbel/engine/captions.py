"""What a page about engines says of itself: caption, units, steam and cranks, in both languages."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product

from kurbel.engine.axes import expansion_label, named_expansion
from kurbel.engine.engine import Load, Steam
from kurbel.engine.quantities import AT_ANGLE, ENGINE_METHODS, EXTREMES, FORCES
from kurbel.engine.request import OVER_ANGLE, EngineRequest
from kurbel.exact.numerals import Label, Number, number_text
from kurbel.page.quantity import AND, FOR, Quantity, enumerated_letters, filled, words
from kurbel.page.table import Note
from kurbel.reading.notation import plain, ratio_text

# The mark of the two extremes that make δ.
MAKES_DELTA = "a"
ERRORS = words("geschätzter Fehler|estimated error")
PLAIN_CAPTION = words(
    "{quantities} der Dampfmaschine{for_engine}; {method}"
    "|{quantities} of the steam engine{for_engine}; {method}"
)
WORDS = {
    "makes_delta": words("aus diesen beiden folgt $δ$|$δ$ follows from these two"),
    "delta": words(
        '$δ = (v_"max" - v_"min")/v_1$; $P$ mittlere Umfangskraft,'
        " $m_1$ Schwungmasse am Kurbelhalbmesser $r$, $v_1$ Kurbelgeschwindigkeit im inneren Totpunkt"
        '|$δ = (v_"max" - v_"min")/v_1$; $P$ mean tangential force,'
        " $m_1$ flywheel mass at the crank radius $r$, $v_1$ crank-pin velocity at the inner dead centre"
    ),
    "forces": words(
        "$Q$ Dampfkraft auf den Kolben vor der Absperrung, $r$ Kurbelhalbmesser"
        "|$Q$ steam force on the piston before cut-off, $r$ crank radius"
    ),
    "card_forces": words(
        "$Q$ größter Druck des Diagramms mal Kolbenfläche, $r$ Kurbelhalbmesser"
        "|$Q$ greatest pressure of the card times piston area, $r$ crank radius"
    ),
    "card": words(
        "Druck aus dem Diagramm, monoton interpoliert; gedruckt sind nur so viele Stellen, wie seine"
        " Punkte tragen, für die übrigen vor dem Komma Nullen"
        "|pressure from the card, interpolated monotonically; only as many digits as its points support"
        " are printed, zeros for the others before the decimal mark"
    ),
    "framed": words(
        "{letters} positiv in der Richtung des Hinganges und nach der Seite, auf der dort der"
        " Kurbelzapfen läuft"
        "|{letters} positive in the direction of the outstroke and towards the side on which the"
        " crank pin then runs"
    ),
    "all_cranks": words(", von allen Kurbeln|, of all cranks"),
    "first_crank": words("die übrigen der ersten Kurbel|the others of the first crank"),
    "massless": words("ohne Massen|without masses"),
    "load": words('$Q = π/4 d^2 p$, $d = {bore} "mm"$, $p = {pressure} "kPa"$'),
    "card_load": words('$d = {bore} "mm"$'),
    "flywheel": words(
        "$(ΔW)/(P r)$ ist $δ$ in $(P r)/(m_1 v_1^2)$, $J = (ΔW)/(δ ω^2)$;"
        " $P$ mittlere Umfangskraft am Kurbelhalbmesser $r$"
        "|$(ΔW)/(P r)$ is $δ$ in $(P r)/(m_1 v_1^2)$, $J = (ΔW)/(δ ω^2)$;"
        " $P$ mean tangential force at the crank radius $r$"
    ),
    "radius": words('$ρ = {radius} "m"$'),
    "turn": words(
        "Winkel vom Totpunkt des Hubes, in der Umdrehung vom inneren Totpunkt"
        "|Angles from the dead centre of the stroke, over the turn from the inner one"
    ),
    "whole_turn": words(
        "Winkel vom inneren Totpunkt der ersten Kurbel|Angles from the inner dead centre of the first crank"
    ),
    "mariotte": words("Expansion nach Mariotte|Expansion by Mariotte's law"),
    "polytropic": words(
        'Expansion nach $p V^n = "const"$, $n = {exponent}$|Expansion by $p V^n = "const"$, $n = {exponent}$'
    ),
    "uncut": words("Volldruck über den ganzen Hub|Full pressure over the whole stroke"),
    "clearance": words(
        "schädlicher Raum ${clearance}$ des Hubraumes|clearance ${clearance}$ of the swept volume"
    ),
    "best": words(
        "Gegendruck $R_b = Q/ε$, der vorteilhafteste|back pressure $R_b = Q/ε$, the most favourable"
    ),
    "best_end": words(
        "Gegendruck gleich der Endspannung des Dampfes, der vorteilhafteste"
        "|back pressure equal to the steam's at the end of the stroke, the most favourable"
    ),
    "back": words("Gegendruck $R_b = {back}$|back pressure $R_b = {back}$"),
    "single": words("einfachwirkend|single-acting"),
    "cranks": words(
        "Kurbeln um {angles} hinter der ersten, Zylinder gleich"
        "|cranks {angles} behind the first, cylinders alike"
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
    lang = request.lang
    methods = dict.fromkeys(method for column in request.page_columns for method in column.methods)
    parts = {
        "{quantities}": ", ".join(_names(request)),
        "{for_engine}": _joined(list(_common(request)), lang),
        "{method}": AND[lang].join(ENGINE_METHODS[one].caption[lang] for one in methods),
    }
    return filled((PLAIN_CAPTION if request.columns else request.layout.caption)[lang], parts.items())


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


def _common(request: EngineRequest) -> Iterator[Label]:
    shown = (*request.layout.across, *request.layout.stub)
    if len(request.steams) == 1 and "expansion" not in shown:
        yield named_expansion(request, 0)
    if len(request.ratios) == 1 and "ratio" not in shown:
        yield _named_ratio(request, 0)


def _named_ratio(request: EngineRequest, index: int) -> Label:
    return f"${request.layout.ratio_symbol} = {ratio_text(request.ratios[index])}$"


def notes(request: EngineRequest) -> Iterator[Label | Note]:
    """Yield the lines below the table: its own, the units, the method, the engine."""
    lang, subject, columns = request.lang, request.layout.subject, request.page_columns
    peaks = any(one.quantity.of in EXTREMES and not one.quantity.minutes for one in columns)
    if peaks and len(request.spans) > 1 and subject == "strokes":
        yield Note(WORDS["makes_delta"][lang], MAKES_DELTA)
    yield from (note[lang] for note in request.layout.notes)
    if any(len(column.methods) > 1 for column in columns):
        yield WORDS["difference"][lang]
    if subject in ("irregularity", "strokes"):
        yield WORDS["delta"][lang]
    if subject == "flywheel":
        yield WORDS["flywheel"][lang]
        radius = request.flywheels[0].radius
        if radius is not None:
            yield WORDS["radius"][lang].format(radius=plain(radius))
    if subject == "strokes":
        yield WORDS["turn" if request.first.plain else "whole_turn"][lang]
    if subject in ("strokes", *OVER_ANGLE):
        yield WORDS["card_forces" if request.carded else "forces"][lang]
    yield from _directions(request, [column.quantity for column in columns])
    newtons = any(column.quantity.needs in ("load", "torque") for column in columns)
    if request.load is not None and (request.first.crank.moving or newtons):
        yield _load(request.load, lang)
    if any(column.methods == ("weisbach",) for column in columns):
        yield WORDS["weisbach"][lang]
    yield "; ".join(_engine(request, lang))
    yield from request.mechanism.loaded_notes(request.drives, lang)
    if request.first.crank.moving is not None:
        yield from request.mechanism.masses_notes(request.first.crank, request.layout.ratio_symbol, lang)
    if request.carded:
        yield from _errors(request)


def _directions(request: EngineRequest, shown: Sequence[Quantity]) -> Iterator[Label]:
    """The directions of what is shown: of all forces and the torque on one line, with whose they are."""
    lang = request.lang
    torques = [one for one in shown if one.needs == "torque"]
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


def _force_directions(
    request: EngineRequest, forces: Sequence[Quantity], torques: Sequence[Quantity]
) -> Iterator[Label]:
    lang, several = request.lang, len(request.cranks) > 1
    framed = [one.symbol.strip("$") for one in forces if FORCES[one.key.removesuffix("_n")].framed]
    if framed:
        yield WORDS["framed"][lang].format(letters=enumerated_letters([*dict.fromkeys(framed)], lang))
    yield from dict.fromkeys(one.direction[lang] for one in forces if one.direction)
    for one in torques:
        if one.direction:
            yield one.direction[lang] + (WORDS["all_cranks"][lang] if several else "")
    if several:
        yield WORDS["first_crank"][lang]
    if request.first.crank.moving is None:
        yield WORDS["massless"][lang]


def _load(load: Load, lang: str) -> Label:
    bore = plain(1000 * load.bore)
    if load.pressure is None:
        return WORDS["card_load"][lang].format(bore=bore)
    return WORDS["load"][lang].format(bore=bore, pressure=plain(load.pressure / 1000))


def _engine(request: EngineRequest, lang: str) -> Iterator[Label]:
    if request.carded:
        yield WORDS["card"][lang]
    else:
        yield from _steam(request, lang)
    engine = request.first
    if not engine.double:
        yield WORDS["single"][lang]
    if len(engine.cranks) > 1:
        angles = ", ".join(f"${plain(angle)}°$" for angle in engine.cranks[1:])
        yield WORDS["cranks"][lang].format(angles=angles)


def _steam(request: EngineRequest, lang: str) -> Iterator[Label]:
    steam = request.first.ideal
    if all(isinstance(one, Steam) and one.expansion == 1 for one in request.steams):
        yield WORDS["uncut"][lang]
    elif steam.exponent == 1:
        yield WORDS["mariotte"][lang]
    else:
        yield WORDS["polytropic"][lang].format(exponent=plain(steam.exponent))
    if steam.clearance:
        yield WORDS["clearance"][lang].format(clearance=plain(steam.clearance))
    if steam.back is not None:
        yield WORDS["back"][lang].format(back=f"{plain(steam.back)} Q" if steam.back else "0")
    else:
        yield WORDS["best" if steam.exponent == 1 and not steam.clearance else "best_end"][lang]


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
    cards = [expansion_label(request, steam)] if len(request.steams) > 1 else []
    ratios = [_named_ratio(request, ratio)] if len(request.ratios) > 1 else []
    return _joined([*cards, *ratios], request.lang)
