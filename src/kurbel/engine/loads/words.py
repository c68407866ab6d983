"""What pages say of compressors, pumps and gas engines."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from kurbel.drive.load import figure
from kurbel.engine.axes import LoadWords, kilopascals, millimetres, number_label
from kurbel.engine.loads.gas import DIESEL, DUAL, OTTO
from kurbel.engine.loads.pump import DIFFERENTIAL, DOUBLE, SINGLE
from kurbel.exact.numerals import Label
from kurbel.page.quantity import words

if TYPE_CHECKING:
    from kurbel.engine.engine import Load
    from kurbel.engine.loads.compressor import Compressor
    from kurbel.engine.loads.gas import GasCycle
    from kurbel.engine.loads.pump import Pump
    from kurbel.engine.request import EngineRequest

WORDS = {
    "isothermal": words("Verdichtung nach Mariotte (--exponent)|Compression by Mariotte's law (--exponent)"),
    "polytropic": words(
        'Verdichtung nach $p V^n = "const"$, $n = {exponent}$'
        '|Compression by $p V^n = "const"$, $n = {exponent}$'
    ),
    "clearance": words(
        "schädlicher Raum ${clearance}$ des Hubraumes, aus dem die Luft sich wieder ausdehnt"
        "|clearance ${clearance}$ of the swept volume, out of which the air expands again"
    ),
    "unclear": words("ohne schädlichen Raum (--clearance)|no clearance (--clearance)"),
    "lossless": words(
        "Ventile ohne Verluste (--suction-loss, --delivery-loss)"
        "|valves without losses (--suction-loss, --delivery-loss)"
    ),
    "suction_loss": words(
        "im Zylinder beim Saugen $p_1 (1 - {share})$|in the cylinder at suction $p_1 (1 - {share})$"
    ),
    "delivery_loss": words("beim Ausschieben $p_2 (1 + {share})$|at delivery $p_2 (1 + {share})$"),
    "other_side": words("auf der anderen Kolbenseite ${share} p_1$|on the other face ${share} p_1$"),
    "same_side": words(
        "auf der anderen Kolbenseite $p_1$ (--other-side)|on the other face $p_1$ (--other-side)"
    ),
    "above": words(
        "Saugdruck ${head}$ über dem der anderen Kolbenseite"
        "|suction pressure ${head}$ above that on the other face"
    ),
    "below": words(
        "Saugdruck ${head}$ unter dem der anderen Kolbenseite"
        "|suction pressure ${head}$ below that on the other face"
    ),
    "no_suction_head": words(
        "Saugdruck gleich dem auf der anderen Kolbenseite (--suction-pressure)"
        "|suction pressure that on the other face (--suction-pressure)"
    ),
    "ring": words(
        "Ringfläche ${share}$ der Kolbenfläche{usual}, stets unter dem Förderdruck"
        "|ring ${share}$ of the piston's area{usual}, always under the delivery pressure"
    ),
    "both": words(
        "Exponent der Verdichtung und der Ausdehnung ${exponent}$"
        "|exponent of compression and expansion ${exponent}$"
    ),
    "unraised": words("Auspuffdruck $p_1$ (--exhaust-pressure)|exhaust pressure $p_1$ (--exhaust-pressure)"),
    "apart": words(
        "Exponent der Verdichtung ${compression}$, der Ausdehnung ${expansion}$"
        "|exponent of compression ${compression}$, of expansion ${expansion}$"
    ),
    "peak": words("Höchstdruck ${peak} p_1$|peak pressure ${peak} p_1$"),
    "cut_off": words("Einspritzverhältnis ${cut_off}$|cut-off ratio ${cut_off}$"),
    "heat": words("Wärme $q = {heat} R T_1$|heat $q = {heat} R T_1$"),
    "exhaust": words("Auspuffdruck ${exhaust} p_1$|exhaust pressure ${exhaust} p_1$"),
    "four": words(
        "Viertakt (sonst --two-stroke), 0° im inneren Totpunkt bei der Zündung"
        "|four-stroke (else --two-stroke), 0° at the inner dead centre of firing"
    ),
    "two": words(
        "Zweitakt, 0° im inneren Totpunkt bei der Zündung|two-stroke, 0° at the inner dead centre of firing"
    ),
}
KINDS = {
    DOUBLE: words("doppeltwirkend|double-acting"),
    SINGLE: words("einfachwirkend|single-acting"),
    DIFFERENTIAL: words("Differentialpumpe|differential"),
}
PUMPS = {
    DOUBLE: words("Pumpe doppeltwirkend (sonst --pump single)|Double-acting pump (else --pump single)"),
    SINGLE: words("Pumpe einfachwirkend|Single-acting pump"),
    DIFFERENTIAL: words("Differentialpumpe|Differential pump"),
}
CYCLES = {
    OTTO: words("Otto-Prozess (--cycle)|Otto cycle (--cycle)"),
    DIESEL: words("Diesel-Prozess|Diesel cycle"),
    DUAL: words("gemischter Prozess (Seiliger)|dual cycle (Seiliger)"),
}


def _compressor_lines(request: EngineRequest, lang: str) -> Iterator[Label]:
    load: Compressor = _first(request)
    if load.exponent == 1:
        yield WORDS["isothermal"][lang]
    else:
        yield WORDS["polytropic"][lang].format(exponent=figure(load.exponent))
    if load.clearance:
        yield WORDS["clearance"][lang].format(clearance=figure(load.clearance))
    else:
        yield WORDS["unclear"][lang]
    if load.suction_loss:
        yield WORDS["suction_loss"][lang].format(share=figure(load.suction_loss))
    if load.delivery_loss:
        yield WORDS["delivery_loss"][lang].format(share=figure(load.delivery_loss))
    if not (load.suction_loss or load.delivery_loss):
        yield WORDS["lossless"][lang]
    if not request.double:
        said = "same_side" if load.other_side == 1 else "other_side"
        yield WORDS[said][lang].format(share=figure(load.other_side))


def _pump_lines(request: EngineRequest, lang: str) -> Iterator[Label]:
    load: Pump = _first(request)
    yield PUMPS[load.kind][lang]
    if load.kind == DIFFERENTIAL:
        usual = " (--small-area)" if load.small_area == Fraction(1, 2) else ""
        yield WORDS["ring"][lang].format(share=figure(load.small_area), usual=usual)
    if load.kind != DOUBLE:
        yield _suction(load, request.first.load, lang)


def _suction(pump: Pump, known: Load | None, lang: str) -> Label:
    """The suction pressure against that on the other face: in kPa, or in what the pump makes."""
    if not pump.suction:
        return WORDS["no_suction_head"][lang]
    head = abs(pump.suction)
    said = f"{figure(head)} (p_d - p_s)" if known is None else kilopascals(known, head)
    return WORDS["above" if pump.suction > 0 else "below"][lang].format(head=said)


def _gas_lines(request: EngineRequest, lang: str) -> Iterator[Label]:
    load: GasCycle = _first(request)
    yield CYCLES[load.cycle][lang]
    yield WORDS["two" if load.two_stroke else "four"][lang]
    for key in ("peak", "cut_off", "heat"):
        if (value := getattr(load, key)) is not None:
            yield WORDS[key][lang].format(**{key: figure(value)})
    if load.expansion_exponent in (None, load.exponent):
        usual = " (--exponent)" if load.exponent == Fraction(7, 5) else ""
        yield WORDS["both"][lang].format(exponent=figure(load.exponent)) + usual
    else:
        assert load.expansion_exponent is not None
        exponents = figure(load.exponent), figure(load.expansion_exponent)
        yield WORDS["apart"][lang].format(compression=exponents[0], expansion=exponents[1])
    if not load.two_stroke:
        said = "unraised" if load.exhaust == 1 else "exhaust"
        yield WORDS[said][lang].format(exhaust=figure(load.exhaust))


def _first(request: EngineRequest) -> Any:
    return request.steams[0]


def _of_suction(_: Any, load: Load) -> Label:
    return f"$Q = π/4 d^2 p_1$, $d = {millimetres(load.bore)}$, $p_1 = {kilopascals(load)}$"


def _of_pump(pump: Pump, load: Load) -> Label:
    return (
        f"$Q = π/4 d^2 (p_d - p_s)$, $d = {millimetres(load.bore)}$,"
        f" $p_s = {kilopascals(load, pump.suction)}$, $p_d = {kilopascals(load, pump.suction + 1)}$"
    )


COMPRESSOR_WORDS = LoadWords(
    key="pressure_ratio",
    name=words("Druckverhältnis|Pressure ratio"),
    symbol="$Π$",
    number=lambda load: load.ratio,
    label=lambda load, lang: number_label(load.ratio),
    machine=words("des Kompressors|of the compressor"),
    several="pressure ratios",
    forces=words(
        "$Q$ Saugdruck $p_1$ mal Kolbenfläche, $Π = p_2/p_1$, $r$ Kurbelhalbmesser"
        "|$Q$ suction pressure $p_1$ times piston area, $Π = p_2/p_1$, $r$ crank radius"
    ),
    newtons=_of_suction,
    lines=_compressor_lines,
    layout="compressor",
    pressure=" and --suction-pressure",
)
PUMP_WORDS = LoadWords(
    key="pump",
    name=words("Pumpe|Pump"),
    symbol="",
    number=lambda load: None,
    label=lambda load, lang: KINDS[load.kind][lang],
    machine=words("der Kolbenpumpe|of the piston pump"),
    several="pumps",
    forces=words(
        "$Q$ Förderdruck $p_d$ weniger Saugdruck $p_s$, mal Kolbenfläche, $r$ Kurbelhalbmesser"
        "|$Q$ delivery pressure $p_d$ less suction pressure $p_s$, times piston area, $r$ crank radius"
    ),
    newtons=_of_pump,
    lines=_pump_lines,
    halved=False,
    captioned=False,
    tag=lambda load: load.kind,
    layout="pump",
    pressure=" and --delivery-pressure",
)
GAS_WORDS = LoadWords(
    key="compression",
    name=words("Verdichtungsverhältnis|Compression ratio"),
    symbol="$ε$",
    number=lambda load: load.compression,
    label=lambda load, lang: number_label(load.compression),
    machine=words("der Gasmaschine|of the gas engine"),
    several="compression ratios",
    forces=words(
        "$Q$ Saugdruck $p_1$ mal Kolbenfläche, $r$ Kurbelhalbmesser"
        "|$Q$ suction pressure $p_1$ times piston area, $r$ crank radius"
    ),
    newtons=_of_suction,
    lines=_gas_lines,
    layout="gas-cycle",
    halved=False,
    pressure=" and --suction-pressure",
)
