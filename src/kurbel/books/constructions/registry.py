"""The constructions by their names on the command line, and where each stands."""

from __future__ import annotations

from collections.abc import Mapping

from kurbel.books.constructions.model import Construction
from kurbel.reading.given import choose, found_at

CONSTRUCTIONS: Mapping[str, str] = {
    "blau-9": "kurbel.books.constructions.blau:FIG_9",
    "roetscher-1047-line": "kurbel.books.constructions.roetscher:ON_THE_LINE",
    "roetscher-1047-circle": "kurbel.books.constructions.roetscher:BESIDE_THE_PIN",
    "forces": "kurbel.books.constructions.triangle:TRIANGLE",
    # Another construction is one more line here.
}


def construction(name: str) -> Construction:
    """Return the construction of that name; raise ChoiceError where there is none."""
    found = found_at(CONSTRUCTIONS[choose(name, CONSTRUCTIONS, "construction")])
    assert isinstance(found, Construction)
    return found
