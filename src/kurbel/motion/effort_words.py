"""What pages say of the weight of the moving masses, in both languages."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from kurbel.drive.load import figure
from kurbel.exact.numerals import Label
from kurbel.page.quantity import words

if TYPE_CHECKING:
    from kurbel.drive.rod import Moving
    from kurbel.drive.slope import Slope

WORDS = {
    "weight": words(
        "Gewicht von {parts}: Schubrichtung unter ${angle}°$ gegen die Waagerechte, {where}, $g = {gravity}"
        ' "m/s"^2$'
        "|Weight of {parts}: slide at ${angle}°$ to the horizontal, {where}, $g = {gravity}"
        ' "m/s"^2$'
    ),
    "reciprocating": words("Kolben und Kreuzkopf|piston and crosshead"),
    "rod": words("Schubstange|rod"),
    "all": words("Kolben, Kreuzkopf und Schubstange|piston, crosshead and rod"),
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
    yield WORDS["weight"][lang].format(
        parts=WORDS[parts][lang],
        angle=figure(moving.slope.angle),
        where=_where(moving.slope, lang),
        gravity=figure(moving.slope.gravity),
    )


def _where(slope: Slope, lang: str) -> str:
    # What is below has a negative sine.
    side = slope.angle % 360
    height = "level" if side in (0, 180) else "above" if side < 180 else "below"
    turning = "" if slope.upright else WORDS["over" if slope.over else "under"][lang]
    return WORDS[height][lang] + turning
