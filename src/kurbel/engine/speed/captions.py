"""What a page about an engine with a given flywheel says beside what it says of the engine."""

from __future__ import annotations

from collections.abc import Iterator

from kurbel.drive.wheel import SQUARE, Wheel
from kurbel.engine import captions
from kurbel.engine.request import EngineRequest
from kurbel.exact.numerals import Label, exact_text
from kurbel.motion.captions import turns_label
from kurbel.page.quantity import words
from kurbel.page.table import Note
from kurbel.reading.amounts import amount

WORDS = {
    "root": words("$v/v_1 = sqrt(1 + 2 W/(m_1 v_1^2))$"),
    "first_order": words(
        "$v/v_1 = 1 + W/(m_1 v_1^2)$, erste Ordnung nach Weisbach"
        "|$v/v_1 = 1 + W/(m_1 v_1^2)$, to first order, by Weisbach"
    ),
    "square_law": words(
        "$J ω (d ω)/(d φ) = (T - P ω^2/Ω^2) r$ im Beharrungszustand, $Ω^2$ Mittel von $ω^2$ über den Winkel"
        "|$J ω (d ω)/(d φ) = (T - P ω^2/Ω^2) r$ in steady state, $Ω^2$ the mean of $ω^2$ over the angle"
    ),
    "letters": words(
        "$v_1$ Kurbelgeschwindigkeit im inneren Totpunkt, $m_1 = J/r^2$ Schwungmasse {at_radius},"
        " $P$ mittlere Umfangskraft"
        "|$v_1$ crank-pin velocity at the inner dead centre, $m_1 = J/r^2$ flywheel mass {at_radius},"
        " $P$ mean tangential force"
    ),
    "masses": words(
        "$1/2 (J + J_φ) ω^2 = 1/2 (J + J_0) ω_1^2 + W_p$; $J$ mit allem, was gleichförmig umläuft, $J_φ$ der"
        " übrigen bewegten Massen beim Winkel $φ$, $J_0$ im inneren Totpunkt, $W_p$ Überschussarbeit des"
        " Kolbendruckes allein"
        "|$1/2 (J + J_φ) ω^2 = 1/2 (J + J_0) ω_1^2 + W_p$; $J$ with all that turns evenly, $J_φ$ of the other"
        " moving masses at the angle $φ$, $J_0$ at the inner dead centre, $W_p$ excess work of the pressure"
        " on the piston alone"
    ),
    "even": words(
        "$T$ und $W$ mit dem Moment der Massen bei gleichförmiger Drehung; flywheel druckt $J_δ$, das ein $δ$"
        " bei wahrer Geschwindigkeit hält"
        "|$T$ and $W$ with the torque of the masses at uniform rotation; flywheel prints $J_δ$, which keeps a"
        " $δ$ at the true speed"
    ),
    "mean": words(
        '$n$ gegeben als Mittel $1/2 (n_"max" + n_"min")$|$n$ given as the mean $1/2 (n_"max" + n_"min")$'
    ),
    "constant": words(
        "Widerstandsmoment gleichbleibend (--resistance)|constant resisting torque (--resistance)"
    ),
    "square": words(
        "Widerstandsmoment wie das Quadrat der Geschwindigkeit|resisting torque as the square of the speed"
    ),
    "constant_driven": words(
        "Antriebsmoment gleichbleibend (--resistance)|constant driving torque (--resistance)"
    ),
    "delta_mean": words('$δ_m = (v_"max" - v_"min")/v_m$, $v_m = 1/2 (v_"max" + v_"min")$'),
    "delta_first": words(
        '$δ_1 = (v_"max" - v_"min")/v_1$, nach Weisbach|$δ_1 = (v_"max" - v_"min")/v_1$, by Weisbach'
    ),
}


def notes(request: EngineRequest) -> Iterator[Label | Note]:
    """Yield the lines below the table: the law of the speed, the flywheel, the definitions, the engine."""
    lang = request.lang
    methods = dict.fromkeys(method for column in request.page_columns for method in column.methods)
    laws = dict.fromkeys("first_order" if one == "weisbach" else "root" for one in methods)
    heavy, wheel = request.first.crank.moving is not None, request.wheel
    assert wheel is not None
    others = {"masses": heavy, "square_law": wheel.resistance == SQUARE}
    own = [law for law, holds in others.items() if holds]
    yield "; ".join([WORDS[law][lang] for law in own or laws])
    yield WORDS["letters"][lang].format(at_radius=captions.at_radius(request))
    if heavy:
        yield WORDS["even"][lang]
    keys = {column.key.rpartition("_")[2] for column in request.page_columns if "_" in column.key}
    yield from (WORDS[f"delta_{one}"][lang] for one in ("mean", "first") if one in keys)
    yield "; ".join(_wheel(request, wheel, lang))
    yield from captions.notes(request)


def _wheel(request: EngineRequest, wheel: Wheel, lang: str) -> Iterator[Label]:
    if wheel.number is not None:
        yield f"$(m_1 v_1^2)/(P r) = {exact_text(wheel.number)}$"
    if wheel.inertia is not None:
        yield f"$J = {amount(wheel.inertia, 'kg m²', exact_text)}$"
    if wheel.speed is not None:
        yield f"{turns_label(wheel.speed)}, {WORDS['mean'][lang]}"
    if wheel.power is not None and wheel.inertia is not None:
        yield f"$N = {amount(wheel.power, 'W', exact_text)}$"
    yield WORDS["constant_driven" if request.driven else wheel.resistance][lang]
