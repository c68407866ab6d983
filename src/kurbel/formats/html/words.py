"""Long words of heads, where a telephone may break them, and how wide letters are."""

from __future__ import annotations

from collections.abc import Mapping

WORDS: Mapping[str, str] = {
    "de": """
        Ab-stand Ab-stände Aus-geglichener Balancier-kraft Balancier-winkel Be-lastung Beschleu-nigung
        Beschleunigungs-druck Dreh-moment Dreh-zahl Druck-verhältnis Expansions-verhältnis Führungs-druck
        Geschwin-digkeit Haupt-lager Hin-gang Kolben-beschleunigung Kolben-druck Kolben-geschwindigkeit
        Kolben-kraft Kolben-weg Kolben-wege Kreuz-kopf Kreuzkopf-zapfen Kurbel-verhältnis Kurbel-winkel
        Kurbel-zapfen Kurbel-zapfens Liefe-rung Massen-kraft Massen-kräfte Mechanis-mus Nach-lauf
        Radial-kraft Rück-gang Schubstangen-winkel Schwer-punkt Schwingen-kraft Schwingen-winkel
        Stangen-kraft Stangen-verhältnis Tangen-tial-kraft Um-drehung Umfangs-kraft
        Ungleich-förmigkeits-grad Unter-schied ver-bleibender Verdichtungs-verhältnis Wellen-linie
        Winkel-beschleunigung Wirkungs-grad Zapfen-kraft Zünd-folge Zünd-winkel Über-schuss
        Überschuss-arbeit
    """,
    "en": """
        Accelera-tion accelera-tion Ampli-tude Compres-sion Cross-head cross-head Cylin-der Deliv-ery
        Differ-ence direc-tion Effi-ciency Expan-sion Inter-val Inter-vals irregu-larity Magni-tude
        magni-tude Out-stroke Pres-sure pres-sure Remain-ing Tangen-tial tangen-tial Veloc-ity veloc-ity
    """,
}

# In em, of DejaVu Serif, by and large.
_CHARACTERS = (
    ("ijltfI.,:;'|!()[]/ \u00a0\u2008°′", 0.38),
    ("mwMW−±+=<>", 0.9),
    ("ABCDEGHKLNOPQRUVXYÄÖÜΔ", 0.77),
)
WIDTHS = {character: width for characters, width in _CHARACTERS for character in characters}
OTHERS = 0.62
