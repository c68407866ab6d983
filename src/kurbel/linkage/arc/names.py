"""What pages of engines call the parts of a crank drive whose piston works at the end of a rocker."""

from __future__ import annotations

from collections.abc import Mapping

from kurbel.exact.numerals import Label
from kurbel.page.quantity import Column, Quantity, Words

# In place of what they say of a crosshead; the letter of the rocker is B.
NAMES: Mapping[str, str] = {
    "Führung": "Schwinge",
    "Guide": "Rocker",
    "Führungsdruck": "Schwingenkraft",
    "Guide force": "Rocker force",
    "$N$ auf den Kreuzkopf": "$N$ längs der Schwinge auf ihr Ende",
    "$N$ on the crosshead": "$N$ along the rocker on its end",
    "$S$ am Kreuzkopf, positiv als Druck": "$S$ am Schwingenende, positiv als Druck",
    "$S$ at the crosshead, positive as thrust": "$S$ at the rocker's end, positive as thrust",
    "Kraft am Kreuzkopfzapfen": "Kraft am Schwingenzapfen",
    "Crosshead-pin force": "Rocker-pin force",
    "$B$ Betrag am Kreuzkopfzapfen": "$G$ Betrag am Schwingenzapfen",
    "$B$ magnitude at the crosshead pin": "$G$ magnitude at the rocker pin",
    "Kreuzkopfzapfen": "Schwingenzapfen",
    "Crosshead pin": "Rocker pin",
    "Stange am Kreuzkopf": "Stange an der Schwinge",
    "Rod at the crosshead": "Rod at the rocker",
    "am Kreuzkopfzapfen: längs der Führung": "am Schwingenzapfen: längs seines Bogens",
    "at the crosshead pin: along the slide": "at the rocker pin: along its arc",
    "Last am Kreuzkopfzapfen": "Last am Schwingenzapfen",
    "Load at the crosshead pin": "Load at the rocker pin",
    "$F_B = F + F_m$ längs der Führung": "$F_B = F + F_m$ längs des Bogens",
    "$F_B = F + F_m$ along the slide": "$F_B = F + F_m$ along the arc",
    "$F_m$ der hin- und hergehenden Massen, ohne die Stange": "$F_m$ der Massen am Schwingenende, ohne die"
    " Stange",
    "$F_m$ of the reciprocating masses, without the rod": "$F_m$ of the masses at the rocker's end, without"
    " the rod",
    "$B$": "$G$",
    "$B$ in N": "$G$ in N",
    "$B$ in $Q$": "$G$ in $Q$",
}


def named(quantity: Quantity, names: Mapping[str, str]) -> Quantity:
    """Return a quantity by the names of another drive."""
    return quantity._replace(
        name=_words(quantity.name, names),
        symbol=_label(quantity.symbol, names),
        heading=_words(quantity.heading, names),
        spanners=tuple(_words(one, names) for one in quantity.spanners),
        direction=None if quantity.direction is None else _words(quantity.direction, names),
    )


def headed(column: Column, names: Mapping[str, str]) -> Column:
    """Return a column under the heads of another drive."""
    return column._replace(
        spanners=tuple(_label(one, names) for one in column.spanners),
        heading=tuple(_label(one, names) for one in column.heading),
    )


def _words(words: Words, names: Mapping[str, str]) -> Words:
    return {lang: _label(one, names) for lang, one in words.items()}


def _label(label: Label, names: Mapping[str, str]) -> Label:
    return names.get(label, label)
