"""What pages of the beam engine as a crank drive say of themselves, in both languages."""

from __future__ import annotations

from collections.abc import Mapping

from kurbel.exact.numerals import Label
from kurbel.linkage.arc.captions import WORDS as ARC_WORDS
from kurbel.linkage.arc.captions import Speech, length_text, printed
from kurbel.linkage.beam.crank import BeamCrank
from kurbel.linkage.quantities import FORCES
from kurbel.page.quantity import Words, words

PLACES = 4
# In place of what other pages say of a rocker and a crosshead.
NAMES: Mapping[str, str] = {
    "Weg auf dem Bogen": "Kolbenweg",
    "Path along the arc": "Piston path",
    "Geschwindigkeit": "Kolbengeschwindigkeit",
    "Velocity": "Piston velocity",
    "Beschleunigung": "Kolbenbeschleunigung",
    "Acceleration": "Piston acceleration",
    "Schwingenwinkel": "Balancierwinkel",
    "Rocker angle": "Beam angle",
    "Drehung der Schwinge": "Drehung des Balanciers",
    "Turn of the rocker": "Turn of the beam",
    "Winkelgeschwindigkeit der Schwinge": "Winkelgeschwindigkeit des Balanciers",
    "Angular velocity of the rocker": "Angular velocity of the beam",
    "Winkelbeschleunigung der Schwinge": "Winkelbeschleunigung des Balanciers",
    "Angular acceleration of the rocker": "Angular acceleration of the beam",
    "Schwingenkraft": "Balancierkraft",
    "Rocker force": "Beam force",
    "Kraft am Schwingenzapfen": "Kraft am Balancierzapfen",
    "Rocker-pin force": "Beam-pin force",
    **{
        said: said.replace("der Schwinge", "des Balanciers").replace("the rocker", "the beam")
        for said in FORCES["guide_force"].direction.split("|")
    },
    "$G$ Betrag am Zapfen von Stange und Schwinge": "$G$ Betrag am Zapfen von Stange und Balancier",
    "$G$ magnitude at the pin of rod and rocker": "$G$ magnitude at the pin of rod and beam",
    "Führung": "Balancier",
    "Guide": "Beam",
    "Führungsdruck": "Balancierkraft",
    "Guide force": "Beam force",
    "$N$ auf den Kreuzkopf": "$N$ längs des Balanciers auf das Stangenende",
    "$N$ on the crosshead": "$N$ along the beam on the rod's end",
    "$S$ am Kreuzkopf, positiv als Druck": "$S$ am Balancier, positiv als Druck",
    "$S$ at the crosshead, positive as thrust": "$S$ at the beam, positive as thrust",
    "Kraft am Kreuzkopfzapfen": "Kraft am Balancierzapfen",
    "Crosshead-pin force": "Beam-pin force",
    "$B$ Betrag am Kreuzkopfzapfen": "$G$ Betrag am Balancierzapfen",
    "$B$ magnitude at the crosshead pin": "$G$ magnitude at the beam pin",
    "$B$": "$G$",
    "$B$ in N": "$G$ in N",
    "$B$ in $Q$": "$G$ in $Q$",
}  # fmt: skip
_PIN = {"de": ("Schwingenzapfen", "Balancierzapfen"), "en": ("rocker pin", "beam pin")}
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
    "rocker": words("Balancier um seinen Drehpunkt|beam about its pivot"),
    "connecting_rod": {
        lang: ARC_WORDS["connecting_rod"][lang].replace(*names) for lang, names in _PIN.items()
    },
}


def _lengths(drive: BeamCrank) -> Mapping[str, Label | None]:
    height = printed(drive.height, PLACES) if drive.crank.ratio else None
    return {"a": length_text(drive.arm), "D": height, "H": printed(drive.distance, PLACES)}


SPEECH = Speech(WORDS, _lengths, further=("piston", "swing"))
