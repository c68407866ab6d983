"""A crank that is itself accelerated: which of its values may lie on a rounding boundary, and what pages say.

Of a speed in turns ω² has the factor π², and an acceleration is x'' ω² + x' α, or x'' + x' α/ω². With a part
of either kind that is not zero it is transcendental.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from kurbel.drive.at import gain
from kurbel.drive.load import figure
from kurbel.exact.numerals import Label
from kurbel.motion.captions import digits_text, signed, strokes_of
from kurbel.motion.evaluation import DIFFERENCE, LOADED
from kurbel.motion.inertia import ROD_MODELS
from kurbel.page.quantity import words

if TYPE_CHECKING:
    from kurbel.motion.page import Request
    from kurbel.page.quantity import Column

# What has ω or ω² for a factor.
_IN_SECONDS = ("speed", "inertia", "couple", "masses")
WORDS = {
    "first_order": words(
        "Näherung der Massenkräfte: $(p R)/v^2 = cos {angle} {±} λ cos 2 {angle}$,"
        " $ε_L/ω^2 = {turned}λ sin {angle}$; der Stangenwinkel $ψ$, mit dem die Stange drückt, ist genau"
        "|Forces of the masses to first order: $(p R)/v^2 = cos {angle} {±} λ cos 2 {angle}$,"
        " $ε_L/ω^2 = {turned}λ sin {angle}$; the angle $ψ$ at which the rod pushes is exact"
    ),
    "crank": words(
        'Kurbel mit der Winkelbeschleunigung $α = {given} "rad/s"^2$, $α/ω^2 = {share}$'
        '|Crank with the angular acceleration $α = {given} "rad/s"^2$, $α/ω^2 = {share}$'
    ),
    "p": words("zu $(p R)/v^2$ kommt $c/v · α/ω^2$|to $(p R)/v^2$ comes $c/v · α/ω^2$"),
    "rod_acceleration": words("zu $ε_L/ω^2$ kommt $ω_L/ω · α/ω^2$|to $ε_L/ω^2$ comes $ω_L/ω · α/ω^2$"),
    "common_acceleration": words("zu $p_2$ kommt $c/v · R α$|to $p_2$ comes $c/v · R α$"),
    "turning_acceleration": words(
        "von $p_4$ geht $(cos {angle})/(cos ψ) · R α$ ab|from $p_4$ goes $(cos {angle})/(cos ψ) · R α$"
    ),
    "torque": words(
        "$M_d$ und $T$ ohne das, was Kurbel und Schwungrad beschleunigt"
        "|$M_d$ and $T$ without what accelerates crank and flywheel"
    ),
}


def lines(page: Request, columns: Sequence[Column]) -> Iterator[Label]:
    """Yield what pages say of how masses and cranks are accelerated, if not exactly and evenly."""
    lang, crank = page.lang, page.cranks[0]
    heavy = [one for one in columns if LOADED in one.quantity.formulas or one.quantity.of in ROD_MODELS]
    if any(one.method in ("series", DIFFERENCE) for one in heavy) and (crank.moving or crank.rod):
        yield signed(WORDS["first_order"][lang], page, strokes_of(columns)[1], False)
    if not crank.acceleration:
        return
    share = digits_text(lambda kind: gain(crank, kind), 4)
    said = [WORDS["crank"][lang].format(given=figure(crank.acceleration), share=share)]
    formulated = ("common_acceleration", "turning_acceleration") if page.layout.formulas else ()
    for key in ("p", "rod_acceleration", *formulated, "torque"):
        named = ("tangential_force", "torque", "inertia_torque") if key == "torque" else (key,)
        if any(_stem(column.quantity.key) in named for column in columns):
            said.append(signed(WORDS[key][lang], page, "+", False))
    yield "; ".join(said)


def _stem(key: str) -> str:
    for part in ("_mps2", "_radps2", "_nm", "_n", "_return", "_two_mass", "_railway"):
        key = key.removesuffix(part)
    return key
