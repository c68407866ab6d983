"""What pages say of weight, of pressures on both sides of the piston and of friction, in both languages."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

from kurbel.drive.load import figure
from kurbel.drive.rod import STANDARD_GRAVITY
from kurbel.exact.numerals import Label
from kurbel.page.quantity import words
from kurbel.reading.amounts import amount

if TYPE_CHECKING:
    from kurbel.drive.effort import Areas, Effort
    from kurbel.drive.rod import Moving, Slope

WORDS = {
    "weight": words(
        "Gewicht {parts}: Schubrichtung unter ${angle}°$ gegen die Waagerechte, {where}, $g = {gravity}$"
        "|Weight of {parts}: slide at ${angle}°$ to the horizontal, {where}, $g = {gravity}$"
    ),
    "pressures": words(
        "$F = π/4 ({cover} p_D - {other} p_K)$ zur Welle hin: $p_D = {head}$ auf der"
        " Deckelseite, $p_K = {crank}$ auf der Kurbelseite, über dem Druck der Umgebung"
        "|$F = π/4 ({cover} p_D - {other} p_K)$ towards the shaft: $p_D = {head}$ on the"
        " side of the cover, $p_K = {crank}$ on that of the crank, above the surroundings"
    ),
    "difference": words(
        "$F = π/4 d^2 Δp$ zur Welle hin: auf der Deckelseite $Δp = {head}$ mehr"
        "|$F = π/4 d^2 Δp$ towards the shaft: $Δp = {head}$ more on the side of the cover"
    ),
    "rods": words(
        "{rods}: Kolbenstange und durchgeführte Stange auf ihrer Seite von der Kolbenfläche abgezogen; auf"
        " ihren Querschnitt wirkt kein Druck, auch nicht der der Luft"
        "|{rods}: areas of piston rod and tail rod taken off on their sides of the piston; no pressure acts"
        " on their sections, not even that of the atmosphere"
    ),
    "pins": words(
        "$M_R$ weniger dem, was die Zapfen nehmen, mit Reibungskreisen $d/2 sin ρ$, $tan ρ = {friction}$:"
        " Kreuzkopfzapfen $d = {crosshead}$, Kurbelzapfen $d = {crank}$, Welle $d = {shaft}$"
        "|$M_R$ less what the pins take, with circles of friction $d/2 sin ρ$, $tan ρ = {friction}$:"
        " crosshead pin $d = {crosshead}$, crank pin $d = {crank}$, shaft $d = {shaft}$"
    ),
    "friction": words("Reibung ${force}$ gegen die Bewegung|Friction ${force}$ against the motion"),
    "reciprocating": words("von Kolben und Kreuzkopf|piston and crosshead"),
    "rod": words("der Schubstange|rod"),
    "all": words("von Kolben, Kreuzkopf und Schubstange|piston, crosshead and rod"),
    "above": words("Zylinder über der Welle|cylinder above the shaft"),
    "below": words("Zylinder unter der Welle|cylinder below the shaft"),
    "level": words("Zylinder neben der Welle|cylinder beside the shaft"),
    "over": words(
        ", Kurbelzapfen auf dem Hingang über der Welle|, crank pin above the shaft on the outstroke"
    ),
    "under": words(
        ", Kurbelzapfen auf dem Hingang unter der Welle|, crank pin below the shaft on the outstroke"
    ),
}


def weight_notes(moving: Moving, lang: str) -> Iterator[Label]:
    """Yield the line about the weight of moving masses, if it counts."""
    if moving.slope is None:
        return
    parts = "all" if moving.rod and moving.reciprocating else "rod" if moving.rod else "reciprocating"
    said = WORDS["weight"][lang].format(
        parts=WORDS[parts][lang],
        angle=figure(moving.slope.angle),
        where=_where(moving.slope, lang),
        gravity=amount(moving.slope.gravity, "m/s²"),
    )
    yield said + usual_gravity(moving.slope.gravity)


def usual_gravity(gravity: Fraction) -> str:
    """Return the option that gives another acceleration of gravity than the standard one."""
    return " (--gravity)" if gravity == STANDARD_GRAVITY else ""


def _where(slope: Slope, lang: str) -> str:
    # What is below has a negative sine.
    side = slope.angle % 360
    height = "level" if side in (0, 180) else "above" if side < 180 else "below"
    turning = "" if slope.upright else WORDS["over" if slope.over else "under"][lang]
    return WORDS[height][lang] + turning


def effort_notes(effort: Effort, lang: str) -> Iterator[Label]:
    """Yield the lines about pressures on the piston and about friction."""
    pressures = effort.pressures
    if pressures is not None:
        areas = pressures.areas
        yield ", ".join(_areas(areas))
        yield WORDS["difference" if pressures.difference else "pressures"][lang].format(
            cover="(d^2 - d_D^2)" if areas.tail else "d^2",
            other="(d^2 - d_K^2)" if areas.rod else "d^2",
            head=amount(pressures.head, "kPa"),
            crank=amount(pressures.crank, "kPa"),
        )
    if effort.areas is not None:
        yield WORDS["rods"][lang].format(rods=", ".join([*_areas(effort.areas)][1:]))
    if effort.pins is not None:
        yield WORDS["pins"][lang].format(
            friction=figure(effort.pins.friction),
            **{name: amount(getattr(effort.pins, name), "mm") for name in ("crosshead", "crank", "shaft")},
        )
    if effort.friction:
        yield WORDS["friction"][lang].format(force=amount(effort.friction, "N"))


def _areas(areas: Areas) -> Iterator[Label]:
    yield f"$d = {amount(areas.bore, 'mm')}$"
    if areas.rod:
        yield f"$d_K = {amount(areas.rod, 'mm')}$"
    if areas.tail:
        yield f"$d_D = {amount(areas.tail, 'mm')}$"
