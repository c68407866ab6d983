"""What pages say of engines and of what they leave unbalanced."""

from __future__ import annotations

from collections.abc import Mapping

from kurbel.exact.numerals import Label
from kurbel.page.quantity import Words, words

UNITS: Mapping[str, Label] = {"force": "$m R ω^2$", "moment": "$m R ω^2 a$"}
ENGINES: Mapping[str, tuple[str, str]] = {
    "inline-1": ("Einzylindermotor", "single cylinder"),
    "inline-2-180": ("Zweizylinder-Reihenmotor, Kurbeln gegenläufig", "inline twin, cranks opposite"),
    "inline-2-360": ("Zweizylinder-Reihenmotor, Kurbeln gleichläufig", "inline twin, cranks alike"),
    "inline-3": ("Dreizylinder-Reihenmotor", "inline three"),
    "inline-4": ("Vierzylinder-Reihenmotor", "inline four"),
    "inline-5": ("Fünfzylinder-Reihenmotor", "inline five"),
    "inline-6": ("Sechszylinder-Reihenmotor", "inline six"),
    "v2-90": ("V2-Motor von 90°", "90° V twin"),
    "v6-90": ("V6-Motor von 90°", "90° V6"),
    "v8-90": ("V8-Motor von 90°", "90° V8"),
    "v12-60": ("V12-Motor von 60°", "60° V12"),
    "boxer-2": ("Zweizylinder-Boxermotor", "flat twin"),
    "boxer-4": ("Vierzylinder-Boxermotor", "flat four"),
}
WORDS: Mapping[str, Words] = {
    "force": words("Kräfte|Forces"),
    "moment": words("Momente|Moments"),
    "in": words("{residual} in {unit}"),
    "residual": words("Kraft oder Moment|Force or moment"),
    "cylinders": words("{count} Zylinder|{count} cylinders"),
    "cranks": words("Kurbeln: |Cranks: "),
    "banks": words("Zylinderachsen: |Axes of the cylinders: "),
    "positions": words("Lagen in $a$: |Positions in $a$: "),
    "lengths": words("Lagen: |Positions: "),
    "length": words("$a = 1 {unit}$"),
    "symbols": words(
        "$m$ hin- und hergehende Masse eines Zylinders, $R$ Kurbelhalbmesser, $ω$ Winkelgeschwindigkeit"
        "|$m$ reciprocating mass of a cylinder, $R$ crank radius, $ω$ angular velocity"
    ),
    "balanced": words(
        "; die umlaufenden Massen gelten als ausgeglichen (--revolving)"
        "|; rotating masses are taken as balanced (--revolving)"
    ),
    "share": words(
        "Gegengewichte, der Kurbel gegenüber umlaufend, gleichen von jeder Masse $m$ den Teil {share} aus"
        "|Counterweights, opposite the crank and turning with it, balance the share {share} of every mass $m$"
    ),
    "spacing": words("$a$ Abstand benachbarter Kurbeln|$a$ distance of neighbouring cranks"),
    "unit": words("$a$ Längeneinheit der Lagen|$a$ unit of length of the positions"),
    "middle": words(
        "; Momente um die Mitte, in der Richtung der Kräfte des Paares"
        "|; moments about the middle, in the direction of the forces of the couple"
    ),
    "about": words(
        "; Momente um die Lage {position}, in der Richtung der Kräfte des Paares"
        "|; moments about the position {position}, in the direction of the forces of the couple"
    ),
    "angles": words(
        "Winkel zählen im Drehsinn von der Bezugslinie, der Zylinderachse oder beim V der Mittellinie"
        "|Angles count in the sense of rotation from the line of reference, the cylinder axis or of a V the "
        "middle line"
    ),
    "zero": words(
        "Beträge enthalten den Faktor $B_k$; 0 ohne Dezimalen ist genau 0"
        "|Magnitudes include the factor $B_k$; 0 without decimals is exactly 0"
    ),
}
