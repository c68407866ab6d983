"""What a page of a driven machine says of its signs: only of what is printed on it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from kurbel.engine.quantities import EXTREMES
from kurbel.engine.request import BY_STROKE
from kurbel.exact.numerals import Label
from kurbel.page.quantity import AND, Quantity, words

if TYPE_CHECKING:
    from kurbel.engine.request import EngineRequest

WORDS = {
    "signs": words(
        "Die Welle treibt den Kolben: $T$ zählt in der Drehrichtung, Arbeit als abgegeben; das Mittel $P$ ist"
        " negativ"
        "|The shaft drives the piston: $T$ counts as the crank turns, work as delivered; the mean $P$ is"
        " negative"
    ),
    "magnitude": words("$δ$ im Betrag von $P$|$δ$ in the magnitude of $P$"),
    "mean": words("$P r$ im Betrag|$P r$ as a magnitude"),
    "exchanged": words(
        "größte und kleinste Geschwindigkeit haben gegen die Kraftmaschine die Plätze getauscht"
        "|greatest and least speed have changed places with those of a driving machine"
    ),
    "supplied": words("{names} positiv, als zugeführt|{names} positive, as supplied"),
    "turning_sense": words(
        "Dreht der Kurbelzapfen im inneren Totpunkt nach oben, trägt bei liegender Maschine die obere"
        " Gleitbahn; Arbeitsmaschinen drehen daher anders herum als Kraftmaschinen, und die untere trägt"
        "|Where the crank pin rises at the inner dead centre, the upper guide face of a horizontal machine is"
        " loaded; driven machines therefore turn the other way than driving ones, which loads the lower one"
    ),
}
SUPPLIED = {
    "power": words("Leistungen|powers"),
    "indicated_power": words("Leistungen|powers"),
    "mean_pressure": words("mittlere Drücke|mean pressures"),
    "mean_pressure_kpa": words("mittlere Drücke|mean pressures"),
}
# What is counted in the mean torque.
IN_MEAN = ("mean_torque", "swing_share", "number")
# Pages that state the convention as a whole, as long as no columns of them are chosen.
OF_ALL = (*BY_STROKE, "compressor")


def convention(request: EngineRequest) -> Iterator[Label]:
    """Yield the lines of a driven machine: how it counts, and which guide face is loaded."""
    shown = [column.quantity for column in request.page_columns]
    yield "; ".join(_clauses(request, shown))
    guided = any(one.key.startswith("guide_force") for one in shown)
    whole = request.layout.subject in OF_ALL and not request.columns
    if request.mechanism.crosshead and (guided or whole):
        yield WORDS["turning_sense"][request.lang]


def _clauses(request: EngineRequest, shown: list[Quantity]) -> Iterator[Label]:
    lang = request.lang
    yield WORDS["signs"][lang]
    if any(one.key == "delta" for one in shown):
        yield WORDS["magnitude"][lang]
    counted = any(one.key in IN_MEAN and one.of != "cylinder" for one in shown)
    if counted or (request.wheel is not None and request.wheel.number is not None):
        yield WORDS["mean"][lang]
    # Those of a list of cylinders have their signs.
    named = [SUPPLIED[one.key][lang] for one in shown if one.key in SUPPLIED and one.of != "cylinder"]
    if named:
        yield WORDS["supplied"][lang].format(names=AND[lang].join(dict.fromkeys(named)))
    if any(one.key == "delta" or one.of in EXTREMES or _of_extreme(one) for one in shown):
        yield WORDS["exchanged"][lang]


def _of_extreme(one: Quantity) -> bool:
    """Whether it is an extreme of the speed under a given flywheel, or made of both."""
    return one.of == "evenness" and one.key != "number"
