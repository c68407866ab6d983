"""What the page of the power says of itself: what is given, the relations, and what acts on the piston."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from kurbel.drive.load import CARD, COMPRESSOR, GAS, PUMP, STEAM, figure
from kurbel.engine.axes import WORDS as AXES
from kurbel.engine.axes import best_back
from kurbel.engine.captions import DRIVEN
from kurbel.engine.power.duty import Duty
from kurbel.engine.power.source import Acting, GivenPressure
from kurbel.exact.numerals import Label
from kurbel.page.quantity import words
from kurbel.reading.amounts import amount

if TYPE_CHECKING:
    from kurbel.engine.power.page import PowerRequest

__all__ = ["DRIVEN", "notes"]
# What the relation of the power is made of.
POWERED = ("indicated_power", "brake_power", "bore", "stroke", "speed", "mean_torque")
# What the pressure is that mean pressures count in, by the load.
PRESSURES = {
    STEAM: words("Dampfdruck vor der Absperrung|steam pressure before cut-off"),
    COMPRESSOR: words("Saugdruck|suction pressure"),
    GAS: words("Saugdruck|suction pressure"),
    PUMP: words("Förderdruck weniger Saugdruck|delivery pressure less suction pressure"),
    CARD: words("der größte Druck des Diagramms|the greatest pressure of the card"),
}
WORDS = {
    "power": words(
        "$N_i = z k p_i A S n$, $A = {area}$; Zylinder $z = {cylinders}$, wirksame Hübe eines Zylinders in"
        " der Umdrehung $k = {strokes}$"
        "|$N_i = z k p_i A S n$, $A = {area}$; cylinders $z = {cylinders}$, working strokes of a cylinder"
        " in a turn $k = {strokes}$"
    ),
    "factor": words(
        "$p_i = φ_d p_m$, Völligkeitsgrad des Diagramms $φ_d = {factor}$"
        "|$p_i = φ_d p_m$, diagram factor $φ_d = {factor}$"
    ),
    "factor_found": words(
        "$p_i = φ_d p_m$, Völligkeitsgrad des Diagramms $φ_d$ aus der Leistung"
        "|$p_i = φ_d p_m$, diagram factor $φ_d$ from the power"
    ),
    "efficiency": words(
        "$N_e = η N_i$, mechanischer Wirkungsgrad $η = {efficiency}$"
        "|$N_e = η N_i$, mechanical efficiency $η = {efficiency}$"
    ),
    "supplied": words(
        "Die Welle treibt den Kolben; Drücke und Leistungen positiv, als zugeführt"
        "|The shaft drives the piston; pressures and powers positive, as supplied"
    ),
    "efficiency_supplied": words(
        "$N_e = N_i/η$, mechanischer Wirkungsgrad $η = {efficiency}$"
        "|$N_e = N_i/η$, mechanical efficiency $η = {efficiency}$"
    ),
    "ends": words(
        "$p_i$ am Deckel ${cover}$, an der Kurbel ${crank}$, im Mittel nach den Flächen"
        "|$p_i$ at the cover ${cover}$, at the crank ${crank}$, the mean by their areas"
    ),
    "given": words("Gegeben: {given}|Given: {given}"),
    "steam": words(
        "Dampf eines wirksamen Hubes {volume} $V_h/v$, $v = {specific}$ vor der Absperrung"
        "|Steam of a working stroke {volume} $V_h/v$, $v = {specific}$ before cut-off"
    ),
    "kept": words(
        "; der schädliche Raum enthält noch Dampf vom Gegendruck $p_b$"
        "|; the clearance still keeps steam of the back pressure $p_b$"
    ),
    "clearance": words(
        "schädlicher Raum $κ = {clearance}$ des Hubraumes|clearance $κ = {clearance}$ of the swept volume"
    ),
    "back": words("Gegendruck $p_b = {back} p$|back pressure $p_b = {back} p$"),
    "ideal": words("ideales Diagramm (--diagram-factor)|ideal card (--diagram-factor)"),
    "card": words(
        "Druck aus dem Diagramm; gedruckt sind nur so viele Stellen, wie seine Punkte tragen"
        "|pressure from the card; only as many digits as its points support are printed"
    ),
}


def notes(request: PowerRequest) -> Iterator[Label]:
    """Yield the lines below the table."""
    lang, duty, source = request.lang, request.duty, request.sources[0]
    shown = {column.key for column in request.page_columns}
    yield from (note[lang] for note in request.layout.notes)
    if isinstance(source, Acting) and "relative_pressure" in shown:
        yield f"$p$ {PRESSURES[source.name][lang]}"
    if given := ", ".join(_given(duty, source)):
        yield WORDS["given"][lang].format(given=given)
    if len(duty.ends) > 1:
        cover, crank = (amount(one, "bar") for one in duty.ends)
        yield WORDS["ends"][lang].format(cover=cover, crank=crank)
    if not shown.isdisjoint(POWERED):
        strokes = figure(source.strokes)
        area = "".join(_area(duty))
        yield WORDS["power"][lang].format(cylinders=duty.cylinders, strokes=strokes, area=area)
    if duty.factor_asked:
        yield WORDS["factor_found"][lang]
    if duty.diagram_factor != 1:
        yield WORDS["factor"][lang].format(factor=figure(duty.diagram_factor))
    if duty.efficiency is not None:
        said = "efficiency_supplied" if request.driven else "efficiency"
        yield WORDS[said][lang].format(efficiency=figure(duty.efficiency))
    if not isinstance(source, Acting):
        return
    if duty.specific_volume is not None and not shown.isdisjoint(("steam", "steam_per_kwh")):
        yield _steam_taken(source, duty, lang)
    lines = [*(_steam_lines(source, lang) if source.steamed else _lines(request, lang))]
    if source.steamed and duty.diagram_factor == 1 and not duty.factor_asked:
        lines.append(WORDS["ideal"][lang])
    yield "; ".join(lines)
    if request.driven:
        yield WORDS["supplied"][lang]


def _given(duty: Duty, source: Acting | GivenPressure) -> Iterator[Label]:
    """Yield what is given as it stands in formulas, but for what the table has."""
    if duty.pressure is not None and not isinstance(source, GivenPressure):
        yield f"$p = {amount(duty.pressure, 'bar')}$"
    if duty.stroke_bore is not None:
        yield f"$S/d = {figure(duty.stroke_bore)}$"
    if duty.speed is not None and not duty.speed.turns:
        yield f'$ω = {figure(duty.speed.value)} "rad/s"$'


def _area(duty: Duty) -> Iterator[str]:
    """Yield the mean area of both ends, less half of that of each rod."""
    rods = [rod for rod in (duty.piston_rod, duty.tail_rod) if rod is not None]
    if not rods:
        yield "π/4 d^2"
        return
    taken = " - ".join(f"1/2 ({amount(rod, 'mm')})^2" for rod in rods)
    yield f"π/4 (d^2 - {taken})"


def _steam_taken(source: Acting, duty: Duty, lang: str) -> Label:
    steam, volume = source.load, duty.specific_volume
    assert volume is not None
    kept = "p_b/p" if steam.exponent == 1 else f"(p_b/p)^(1/{figure(steam.exponent)})"
    taken = f"$[1/ε + κ (1 - {kept})]$" if steam.clearance else "$1/ε$"
    said = WORDS["steam"][lang].format(volume=taken, specific=amount(volume, "m³/kg"))
    return said + (WORDS["kept"][lang] if steam.clearance else "")


def _steam_lines(source: Acting, lang: str) -> Iterator[Label]:
    steam = source.load
    if steam.expansion == 1:
        yield AXES["uncut"][lang]
    elif steam.exponent == 1:
        yield AXES["mariotte"][lang]
    else:
        yield AXES["polytropic"][lang].format(exponent=figure(steam.exponent))
    if steam.clearance:
        yield WORDS["clearance"][lang].format(clearance=figure(steam.clearance))
    elif steam.expansion != 1:
        yield AXES["unclear"][lang]
    if steam.back is None:
        yield best_back(steam, "p_b", "p", lang)
    else:
        yield WORDS["back"][lang].format(back=figure(steam.back))
    yield AXES["double" if source.engine.double else "single"][lang]


def _lines(request: PowerRequest, lang: str) -> Iterator[Label]:
    source = request.sources[0]
    if source.carded:
        yield WORDS["card"][lang]
    else:
        yield from request.words.lines(request, lang)
    if request.words.halved:
        yield AXES["double" if request.double else "single"][lang]
