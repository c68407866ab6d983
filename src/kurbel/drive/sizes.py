"""The size of a crank given in another way than by its stroke 2R."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from kurbel.errors import ProblemError
from kurbel.exact.numerals import about, exact_text
from kurbel.reading.given import Exact, as_fraction, as_length
from kurbel.reading.units import split


def in_strokes(given: Mapping[str, Any]) -> dict[str, Any]:
    """Return the options with the stroke 2R that the crank radius makes, in the unit of that, without it.

    Raises ProblemError where a stroke is given, too, and is another one.
    """
    left = {name: value for name, value in given.items() if name != "crank"}
    crank, stroke = given.get("crank"), given.get("stroke")
    if crank is None:
        return left
    radius = as_length(crank, "crank radius")
    if radius <= 0:
        raise ProblemError(f"the crank radius is {about(radius)} m; it must be above 0")
    if stroke is not None and as_length(stroke, "stroke") != 2 * radius:
        raise ProblemError(
            f"the stroke 2R is {_shown(stroke)} and the crank R is {_shown(crank)}, which makes a stroke of"
            f" {_shown(_doubled(crank))}; leave one of the two out"
        )
    return {**left, "stroke": _doubled(crank)}


def _doubled(length: Exact) -> Exact:
    if not isinstance(length, str):
        return 2 * as_fraction(length)
    value, unit = split(length)
    return f"{exact_text(2 * value)}{unit}"


def _shown(length: Exact) -> str:
    return length.strip() if isinstance(length, str) else f"{about(as_fraction(length))} m"
