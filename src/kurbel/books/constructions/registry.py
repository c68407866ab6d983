"""The constructions by their names on the command line, and where each stands."""

from __future__ import annotations

from collections.abc import Mapping

from kurbel.books.constructions.model import Construction
from kurbel.errors import ChoiceError
from kurbel.reading.given import choose, found_at

CONSTRUCTIONS: Mapping[str, str] = {
    "blau-9": "kurbel.books.constructions.blau:FIG_9",
    "roetscher-1047-line": "kurbel.books.constructions.roetscher:ON_THE_LINE",
    "roetscher-1047-circle": "kurbel.books.constructions.roetscher:BESIDE_THE_PIN",
    "forces": "kurbel.books.constructions.triangle:TRIANGLE",
    "velocity": "kurbel.books.constructions.rates.velocity:VELOCITY",
    "acceleration": "kurbel.books.constructions.rates.acceleration:ACCELERATION",
    "klein": "kurbel.books.constructions.rates.klein:KLEIN",
    "rittershaus": "kurbel.books.constructions.rates.rittershaus:RITTERSHAUS",
    "autenrieth": "kurbel.books.constructions.rates.autenrieth:AUTENRIETH",
    "kuhn": "kurbel.books.constructions.rates.kuhn:KUHN",
    "ensslin-1": "kurbel.books.constructions.ensslin.accelerations:FIG_1",
    "ensslin-2": "kurbel.books.constructions.ensslin.accelerations:FIG_2",
    "ensslin-3": "kurbel.books.constructions.ensslin.alone:FIG_3",
    "ensslin-4": "kurbel.books.constructions.ensslin.alone:FIG_4",
    "ensslin-5": "kurbel.books.constructions.ensslin.common:FIG_5",
    "ensslin-6": "kurbel.books.constructions.ensslin.turning:FIG_6",
    "ensslin-7": "kurbel.books.constructions.ensslin.stretching:FIG_7",
    "weisbach-149": "kurbel.books.constructions.weisbach:BEAM",
    "radinger": "kurbel.books.constructions.radinger:TANGENTIAL",
    # Another construction is one more line here.
}

# Ensslin (1907) names these, too; no text that says their steps was found, so they are not drawn.
UNFOUND: Mapping[str, str] = {
    "mohr": "Mohr",
    "mehmke": "Mehmke",
    "bour-pröll": "Bour and Pröll",
    "bour-proell": "Bour and Pröll",
    "pröll": "Bour and Pröll",
    "proell": "Bour and Pröll",
    "bour": "Bour and Pröll",
}


def unfound(name: object) -> str:
    """Return the sentence for a construction that has no source, nothing for others."""
    author = UNFOUND.get(name.casefold()) if isinstance(name, str) else None
    if author is None:
        return ""
    return (
        f"the construction of {author} is not drawn, for no source that says its steps was found; klein,"
        " rittershaus and autenrieth give the same length"
    )


def construction(name: str) -> Construction:
    """Return the construction of that name; raise ChoiceError where there is none."""
    if sentence := unfound(name):
        raise ChoiceError(sentence)
    found = found_at(CONSTRUCTIONS[choose(name, CONSTRUCTIONS, "construction")])
    assert isinstance(found, Construction)
    return found
