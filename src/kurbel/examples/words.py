"""The words of worked examples in both languages."""

from __future__ import annotations

from collections.abc import Mapping

from kurbel.page.quantity import Words, words

WORDS: Mapping[str, Words] = {
    "part": words("Teil|Part"),
    "step": words("Schritt|Step"),
    "difference": words(
        "neu berechnet weniger gedruckt, in Einheiten der letzten Stelle"
        "|recomputed less printed, in units of the last place"
    ),
    "line": words("Rechnung|Working"),
    "symbol": words("Größe|Quantity"),
    "printed": words("gedruckt|printed"),
    "recomputed": words("neu berechnet|recomputed"),
    "computed": words("berechnet|computed"),
    "unusable": words("unbrauchbar|unusable"),
    "and": words("und|and"),
    "printed_source": words("neu berechnet|computed anew"),
    "own_source": words("mit anderen Zahlen|with other numbers"),
    "letters_source": words("neu gesetzt|set anew"),
    "differs": words("weicht ab|differs"),
    "unit": words("weicht um 1 Einheit der letzten Stelle ab|differs by 1 unit of the last place"),
    "units": words(
        "weicht um {units} Einheiten der letzten Stelle ab|differs by {units} units of the last place"
    ),
    "arc": words("weicht um {arc} ab|differs by {arc}"),
    "added": words("[ ] steht nicht im Buch|[ ] is not in the book"),
    "rounded_printed": words(
        "Rechnung mit den gedruckten Zahlen; neu berechnet ist der wahre Wert der Größe, einmal auf die "
        "gedruckten Stellen gerundet"
        "|working with the printed figures; recomputed is the true value of the quantity, rounded once to "
        "the printed places"
    ),
    "rounded_own": words(
        "jede Zahl ist der wahre Wert ihrer Größe, einmal gerundet; aus gerundeten Zahlen einer Zeile kann "
        "eine andere letzte Stelle folgen"
        "|every figure is the true value of its quantity, rounded once; from the rounded figures of a line "
        "another last place may follow"
    ),
}
