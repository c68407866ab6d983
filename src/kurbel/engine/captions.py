"""What a page about engines says of itself: caption, units, steam and cranks, in both languages."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from kurbel.drive.crank_forces import CRANK_FORCES
from kurbel.engine.axes import CARD, expansion_label
from kurbel.engine.engine import Engine, Load, Steam
from kurbel.engine.quantities import EngineQuantity, engine_registry
from kurbel.engine.request import ENGINE_METHODS, OVER_ANGLE, EngineColumn, EngineRequest
from kurbel.exact.numerals import Label, Number, number_text
from kurbel.motion.drive_notes import moving_notes
from kurbel.page import axes as page_axes
from kurbel.page.labels import plain as plain_label
from kurbel.page.table import Field
from kurbel.page.words import enumerated_letters
from kurbel.reading.notation import plain, ratio_text

Words = Mapping[str, str]
WORDS: Mapping[str, Words] = {
    "for": {"de": " für ", "en": " for "},
    "and": {"de": " und ", "en": " and "},
    "makes_delta": {"de": "aus diesen beiden folgt $δ$", "en": "$δ$ follows from these two"},
    "delta": {
        "de": '$δ = (v_"max" - v_"min")/v_1$; $P$ mittlere Umfangskraft,'
        " $m_1$ Schwungmasse am Kurbelhalbmesser $r$, $v_1$ Kurbelgeschwindigkeit im inneren Totpunkt",
        "en": '$δ = (v_"max" - v_"min")/v_1$; $P$ mean tangential force,'
        " $m_1$ flywheel mass at the crank radius $r$, $v_1$ crank-pin velocity at the inner dead centre",
    },
    "forces": {
        "de": "$Q$ Dampfkraft auf den Kolben vor der Absperrung, $r$ Kurbelhalbmesser",
        "en": "$Q$ steam force on the piston before cut-off, $r$ crank radius",
    },
    "card_forces": {
        "de": "$Q$ größter Druck des Diagramms mal Kolbenfläche, $r$ Kurbelhalbmesser",
        "en": "$Q$ greatest pressure of the card times piston area, $r$ crank radius",
    },
    "card": {
        "de": "Druck aus dem Diagramm, monoton interpoliert; gedruckt sind nur so viele Stellen, wie seine"
        " Punkte tragen, für die übrigen vor dem Komma Nullen",
        "en": "pressure from the card, interpolated monotonically; only as many digits as its points support"
        " are printed, zeros for the others before the decimal mark",
    },
    "framed": {
        "de": "{letters} positiv in der Richtung des Hinganges und nach der Seite, auf der dort der"
        " Kurbelzapfen läuft",
        "en": "{letters} positive in the direction of the outstroke and towards the side on which the"
        " crank pin then runs",
    },
    "guide_force": {"de": "$N$ auf den Kreuzkopf", "en": "$N$ on the crosshead"},
    "rod_force": {
        "de": "$S$ am Kreuzkopf, positiv als Druck",
        "en": "$S$ at the crosshead, positive as thrust",
    },
    "crosshead_pin_force": {
        "de": "$B$ Betrag am Kreuzkopfzapfen",
        "en": "$B$ magnitude at the crosshead pin",
    },
    "crank_pin_force": {"de": "$K$ Betrag am Kurbelzapfen", "en": "$K$ magnitude at the crank pin"},
    "tangential_force": {"de": "$T$ in der Drehrichtung", "en": "$T$ as the crank turns"},
    "radial_force": {"de": "$Z$ nach der Welle hin", "en": "$Z$ towards the shaft"},
    "bearing": {
        "de": "$H$ auf das Hauptlager, von dieser Kurbel allein",
        "en": "$H$ on the main bearing, of this crank alone",
    },
    "torque_nm": {"de": "$M_d$ an der Welle", "en": "$M_d$ on the shaft"},
    "all_cranks": {"de": "$M_d$ an der Welle, von allen Kurbeln", "en": "$M_d$ on the shaft, of all cranks"},
    "first_crank": {"de": "die übrigen der ersten Kurbel", "en": "the others of the first crank"},
    "massless": {"de": "ohne Massen", "en": "without masses"},
    "load": {
        "de": '$Q = π/4 d^2 p$, $d = {bore} "mm"$, $p = {pressure} "kPa"$',
        "en": '$Q = π/4 d^2 p$, $d = {bore} "mm"$, $p = {pressure} "kPa"$',
    },
    "card_load": {"de": '$d = {bore} "mm"$', "en": '$d = {bore} "mm"$'},
    "energy": {
        "de": "$W$ Arbeit des Überschusses seit dem inneren Totpunkt der ersten Kurbel",
        "en": "$W$ work of the excess since the inner dead centre of the first crank",
    },
    "flywheel": {
        "de": "$(ΔW)/(P r)$ ist $δ$ in $(P r)/(m_1 v_1^2)$, $J = (ΔW)/(δ ω^2)$;"
        " $P$ mittlere Umfangskraft am Kurbelhalbmesser $r$",
        "en": "$(ΔW)/(P r)$ is $δ$ in $(P r)/(m_1 v_1^2)$, $J = (ΔW)/(δ ω^2)$;"
        " $P$ mean tangential force at the crank radius $r$",
    },
    "radius": {"de": '$ρ = {radius} "m"$', "en": '$ρ = {radius} "m"$'},
    "turn": {
        "de": "Winkel vom Totpunkt des Hubes, in der Umdrehung vom inneren Totpunkt",
        "en": "Angles from the dead centre of the stroke, over the turn from the inner one",
    },
    "whole_turn": {
        "de": "Winkel vom inneren Totpunkt der ersten Kurbel",
        "en": "Angles from the inner dead centre of the first crank",
    },
    "mariotte": {"de": "Expansion nach Mariotte", "en": "Expansion by Mariotte's law"},
    "polytropic": {
        "de": 'Expansion nach $p V^n = "const"$, $n = {exponent}$',
        "en": 'Expansion by $p V^n = "const"$, $n = {exponent}$',
    },
    "uncut": {"de": "Volldruck über den ganzen Hub", "en": "Full pressure over the whole stroke"},
    "clearance": {
        "de": "schädlicher Raum ${clearance}$ des Hubraumes",
        "en": "clearance ${clearance}$ of the swept volume",
    },
    "best": {
        "de": "Gegendruck $R_b = Q/ε$, der vorteilhafteste",
        "en": "back pressure $R_b = Q/ε$, the most favourable",
    },
    "best_end": {
        "de": "Gegendruck gleich der Endspannung des Dampfes, der vorteilhafteste",
        "en": "back pressure equal to the steam's at the end of the stroke, the most favourable",
    },
    "back": {"de": "Gegendruck $R_b = {back}$", "en": "back pressure $R_b = {back}$"},
    "single": {"de": "einfachwirkend", "en": "single-acting"},
    "cranks": {
        "de": "Kurbeln um {angles} hinter der ersten, Zylinder gleich",
        "en": "cranks {angles} behind the first, cylinders alike",
    },
    "errors": {"de": "geschätzter Fehler", "en": "estimated error"},
    "less": {"de": ", Unterschied", "en": ", difference"},
    "difference": {
        "de": "Unterschied: genauer Wert weniger Näherung, vor dem Runden gebildet.",
        "en": "Difference: exact value less approximation, taken before rounding.",
    },
    "weisbach": {
        "de": "$sin α_1 = P/(Q - R_b) ± r/(2 l) sin 2 α_1$,"
        " $P tan(α_2/2) = 2 Q/ε (1 ± r/l q) - 2 R_b q (1 ∓ r/l cos α_2)$, $q = sin^2(α_2/2)$;"
        " oberes Zeichen: Rückgang, unteres Zeichen: Hingang",
        "en": "$sin α_1 = P/(Q - R_b) ± r/(2 l) sin 2 α_1$,"
        " $P tan(α_2/2) = 2 Q/ε (1 ± r/l q) - 2 R_b q (1 ∓ r/l cos α_2)$, $q = sin^2(α_2/2)$;"
        " upper sign: return stroke, lower sign: outstroke",
    },
    "chosen": {
        "de": "{quantities} der Dampfmaschine{for_engine}; {method}",
        "en": "{quantities} of the steam engine{for_engine}; {method}",
    },
    "epsilon": {"de": "Expansionsverhältnis", "en": "Expansion ratio"},
    "stroke": {"de": "Hub", "en": "Stroke"},
    "target": {"de": "Ungleichförmigkeitsgrad, zulässiger", "en": "Degree of irregularity allowed"},
}


def caption(request: EngineRequest) -> Label:
    """Return the layout's caption with what all its engines have in common, and the method."""
    lang = request.lang
    methods = dict.fromkeys(method for column in request.page_columns for method in column.methods)
    parts = {
        "{quantities}": ", ".join(_names(request)),
        "{for_engine}": _joined(list(_common(request)), lang, WORDS["for"][lang]),
        "{method}": WORDS["and"][lang].join(ENGINE_METHODS[one].caption[lang] for one in methods),
    }
    text = WORDS["chosen"][lang] if request.columns else request.layout.caption[lang]
    for place, part in parts.items():
        text = text.replace(place, part)
    return text


def _names(request: EngineRequest) -> list[str]:
    names = [
        f"{column.quantity.name[request.lang]} {column.quantity.symbol}" for column in request.page_columns
    ]
    first, *others = dict.fromkeys(names)
    return [first[:1].upper() + first[1:], *(inner(name, request.lang) for name in others)]


def inner(name: str, lang: str) -> str:
    """Return a name as it is within a sentence: German nouns keep their capital."""
    return name[:1].lower() + name[1:] if lang == "en" else name


def _joined(parts: list[str], lang: str, before: str) -> str:
    return before + ", ".join(parts) if parts else ""


def _common(request: EngineRequest) -> Iterator[Label]:
    shown = (*request.layout.across, *request.layout.stub)
    if len(request.steams) == 1 and "expansion" not in shown:
        label = expansion_label(request, 0)
        yield label if request.carded else f"$ε = {label.strip('$')}$"
    if len(request.ratios) == 1 and "ratio" not in shown:
        yield f"${request.layout.ratio_symbol} = {ratio_text(request.ratios[0])}$"


def notes(request: EngineRequest) -> Iterator[Label]:
    """Yield the lines below the table: its own, the units, the method, the engine."""
    lang, subject = request.lang, request.layout.subject
    yield from (note[lang] for note in request.layout.notes)
    if any(len(column.methods) > 1 for column in request.page_columns):
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
    shown = {column.quantity.key.removesuffix("_n") for column in request.page_columns}
    if "energy" in shown:
        yield WORDS["energy"][lang]
    shown |= {"torque_nm"} & {column.quantity.key for column in request.page_columns}
    if shown & {*CRANK_FORCES, "torque_nm"}:
        yield "; ".join(_signs(request, shown))
    if request.load is not None and (request.first.crank.moving or _newtons(request)):
        yield _load(request.load, lang)
    if any(column.methods == ("weisbach",) for column in request.page_columns):
        yield WORDS["weisbach"][lang]
    yield "; ".join(_engine(request, lang))
    if request.first.crank.moving is not None:
        yield from moving_notes(request.first.crank, request.layout.ratio_symbol, lang)


def _newtons(request: EngineRequest) -> bool:
    return any(column.quantity.needs in ("load", "torque") for column in request.page_columns)


def _signs(request: EngineRequest, shown: set[str]) -> Iterator[Label]:
    """The directions of the forces shown, and whose they are."""
    lang, registry = request.lang, engine_registry()
    # S is a thrust or a pull, which a direction in the frame does not say.
    framed = [key for key, force in CRANK_FORCES.items() if force.framed and key != "rod_force"]
    letters = [registry[key].symbol.strip("$") for key in framed if key in shown]
    if letters:
        yield WORDS["framed"][lang].format(letters=enumerated_letters(letters, lang))
    words = ("guide_force", "rod_force", "crosshead_pin_force", "crank_pin_force", "tangential_force")
    yield from (WORDS[key][lang] for key in (*words, "radial_force") if key in shown)
    if any(key.startswith("bearing") for key in shown):
        yield WORDS["bearing"][lang]
    several = len(request.cranks) > 1
    if "torque_nm" in shown:
        yield WORDS["all_cranks" if several else "torque_nm"][lang]
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
    yield from _cranks(request.first, lang)


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


def _cranks(engine: Engine, lang: str) -> Iterator[Label]:
    if not engine.double:
        yield WORDS["single"][lang]
    if len(engine.cranks) > 1:
        angles = ", ".join(f"${plain(angle)}°$" for angle in engine.cranks[1:])
        yield WORDS["cranks"][lang].format(angles=angles)


def errors(
    request: EngineRequest, expansion: int, ratio: int, errors: list[tuple[EngineQuantity, Number]]
) -> Label:
    """Return the line on the errors of one card and ratio."""
    lang = request.lang
    said = ", ".join(f"{one.symbol} ${number_text(error)}$ {one.unit}".rstrip() for one, error in errors)
    apart = []
    if len(request.steams) > 1:
        apart.append(expansion_label(request, expansion))
    if len(request.ratios) > 1:
        apart.append(f"${request.layout.ratio_symbol} = {ratio_text(request.ratios[ratio])}$")
    return WORDS["errors"][lang] + _joined(apart, lang, WORDS["for"][lang]) + ": " + said


def field(request: EngineRequest, column: EngineColumn) -> Field:
    """Return what a column is in records."""
    lang, quantity = request.lang, column.quantity
    name = quantity.name[lang] + (WORDS["less"][lang] if len(column.methods) > 1 else "")
    unit, methods = plain_label(quantity.unit), " - ".join(column.methods)
    return Field(column.key, name, quantity.symbol, unit, column.decimals, methods)


def error_field(request: EngineRequest, column: EngineColumn) -> Field:
    """Return the same of the error of a column."""
    own = field(request, column)
    name = f"{WORDS['errors'][request.lang]}: {own.name}"
    return own._replace(key=f"{own.key}_error", name=name, decimals=None)


def axis_fields(request: EngineRequest) -> dict[str, Field]:
    """Return what the axes are in records."""
    lang, layout = request.lang, request.layout
    fields = {
        "epsilon": Field("epsilon", WORDS["epsilon"][lang], "$ε$", "", request.expansion_decimals),
        "card": Field("card", CARD[lang]),
        "ratio": Field("ratio", page_axes.RATIO[lang], f"${layout.ratio_symbol}$"),
        "stroke": Field("stroke", WORDS["stroke"][lang]),
        "phi": Field("phi", page_axes.PHI[lang], f"${layout.angle_symbol}$", "°", request.angle_decimals),
    }
    if layout.subject == "flywheel":
        fields["target"] = Field("target", WORDS["target"][lang], "$δ$")
    return fields
