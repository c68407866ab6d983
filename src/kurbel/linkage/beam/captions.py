"""What pages of the beam engine as a crank drive say of themselves, in both languages."""

from __future__ import annotations

from collections.abc import Mapping

from kurbel.exact.numerals import Label, exact_text
from kurbel.linkage.arc.captions import WORDS as ARC_WORDS
from kurbel.linkage.arc.captions import Speech, printed
from kurbel.linkage.arc.names import NAMES as ARC_NAMES
from kurbel.linkage.arc.quantities import OF_TURN
from kurbel.linkage.beam.crank import BeamCrank
from kurbel.linkage.quantities import FORCES
from kurbel.page.quantity import Words, words

PLACES = 4
# What stands for the rocker in the words of other pages, the longer words first.
_PARTS = (
    ("der Schwinge auf ihr Ende", "des Balanciers auf sein Ende"),
    ("an der Schwinge", "am Balancier"),
    ("der Schwinge", "des Balanciers"),
    ("Schwingen", "Balancier"),
    ("Schwinge", "Balancier"),
    ("rocker", "beam"),
    ("Rocker", "Beam"),
)


def _of_beam(said: str) -> str:
    for rocker, beam in _PARTS:
        said = said.replace(rocker, beam)
    return said


_SAID = (
    "Schwingenwinkel|Rocker angle|Drehung der Schwinge|Turn of the rocker",
    "Winkelgeschwindigkeit der Schwinge|Angular velocity of the rocker",
    "Winkelbeschleunigung der Schwinge|Angular acceleration of the rocker",
    "|".join(OF_TURN.values()),
    *(text for one in FORCES.values() for text in (one.name, one.direction)),
)
NAMES: Mapping[str, str] = {
    "Weg auf dem Bogen": "Kolbenweg",
    "Path along the arc": "Piston path",
    "Geschwindigkeit": "Kolbengeschwindigkeit",
    "Velocity": "Piston velocity",
    "Beschleunigung": "Kolbenbeschleunigung",
    "Acceleration": "Piston acceleration",
    **{said: _of_beam(said) for texts in _SAID for said in texts.split("|")},
    **{said: _of_beam(of_rocker) for said, of_rocker in ARC_NAMES.items()},
}
"""What pages call the parts of the drive, in place of what they say of a rocker and of a crosshead."""
WORDS: Mapping[str, Words] = {
    **ARC_WORDS,
    "closure": words(
        "{closure}; Arm $a$ des Balanciers, dessen Drehpunkt $D$ über und $H$ neben der Welle liegt"
        "|{closure}; arm $a$ of the beam, whose pivot lies $D$ above the shaft and $H$ beside it"
    ),
    "angles": words(
        "$φ$ und $ψ$ von der Senkrechten durch die Welle, $θ$ von der Waagrechten; $φ$ und $θ$ im Drehsinn"
        " der Kurbel, $ψ$ im entgegengesetzten"
        "|$φ$ and $ψ$ from the vertical through the shaft, $θ$ from the horizontal; $φ$ and $θ$ in the"
        " crank's sense, $ψ$ in the opposite one"
    ),
    "force": words(
        "$F$ auf den Kolben, in der Richtung des Hubes|$F$ on the piston, in the direction of the stroke"
    ),
    "piston": words(
        "Der Kolben am anderen Ende des Balanciers, an gleichem Arm, hat den Weg des Stangenendes auf seinem"
        " Bogen; Watts Geradführung ist als vollkommen genommen"
        "|The piston at the other end of the beam, on an arm as long, has the path of the rod's end along its"
        " arc; Watt's linkage is taken as perfect"
    ),
    "swing": words(
        "Der Balancier schwingt gleich weit über und unter die Waagrechte, die Welle liegt unter der Mitte"
        " der Pfeilhöhe seines Bogens"
        "|The beam swings alike above and below the horizontal, and the shaft lies below the middle of the"
        " sagitta of its arc"
    ),
    "reciprocating": words("am Kolben|at the piston"),
    "held": words(
        "$N$ ohne die Masse am Kolben, die der andere Arm des Balanciers auf ihrem Bogen hält"
        "|$N$ without the mass at the piston, which the other arm of the beam keeps on its arc"
    ),
    "rocker": words("Balancier um seinen Drehpunkt|beam about its pivot"),
    "connecting_rod": {
        # The arm of the beam is a.
        lang: _of_beam(said).replace("$a = ", "$a_S = ").replace("- a b", "- a_S b_S")
        for lang, said in ARC_WORDS["connecting_rod"].items()
    },
}


def _lengths(drive: BeamCrank) -> Mapping[str, Label | None]:
    height = printed(drive.height, PLACES) if drive.crank.ratio else None
    return {"a": exact_text(drive.arm), "D": height, "H": printed(drive.distance, PLACES)}


SPEECH = Speech(WORDS, _lengths, further=("piston", "swing"))
