"""The words of worked examples in both languages."""

from __future__ import annotations

from collections.abc import Mapping

WORDS: Mapping[str, Mapping[str, str]] = {
    "part": {"de": "Teil", "en": "Part"},
    "step": {"de": "Schritt", "en": "Step"},
    "difference": {
        "de": "neu berechnet weniger gedruckt, in Einheiten der letzten Stelle",
        "en": "recomputed less printed, in units of the last place",
    },
    "line": {"de": "Rechnung", "en": "Working"},
    "symbol": {"de": "Größe", "en": "Quantity"},
    "printed": {"de": "gedruckt", "en": "printed"},
    "recomputed": {"de": "neu berechnet", "en": "recomputed"},
    "computed": {"de": "berechnet", "en": "computed"},
    "unusable": {"de": "unbrauchbar", "en": "unusable"},
    "and": {"de": "und", "en": "and"},
    "printed_source": {"de": "neu berechnet", "en": "computed anew"},
    "own_source": {"de": "mit anderen Zahlen", "en": "with other numbers"},
    "letters_source": {"de": "neu gesetzt", "en": "set anew"},
    "differs": {"de": "weicht ab", "en": "differs"},
    "unit": {
        "de": "weicht um 1 Einheit der letzten Stelle ab",
        "en": "differs by 1 unit of the last place",
    },
    "units": {
        "de": "weicht um {units} Einheiten der letzten Stelle ab",
        "en": "differs by {units} units of the last place",
    },
    "arc": {"de": "weicht um {arc} ab", "en": "differs by {arc}"},
    "added": {"de": "[ ] steht nicht im Buch", "en": "[ ] is not in the book"},
    "rounded_printed": {
        "de": "Rechnung mit den gedruckten Zahlen; neu berechnet ist der wahre Wert der Größe, einmal"
        " auf die gedruckten Stellen gerundet",
        "en": "working with the printed figures; recomputed is the true value of the quantity, rounded once"
        " to the printed places",
    },
    "rounded_own": {
        "de": "jede Zahl ist der wahre Wert ihrer Größe, einmal gerundet; aus gerundeten Zahlen einer"
        " Zeile kann eine andere letzte Stelle folgen",
        "en": "every figure is the true value of its quantity, rounded once; from the rounded figures of a"
        " line another last place may follow",
    },
}
