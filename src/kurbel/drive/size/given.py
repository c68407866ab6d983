"""The size of a crank given in another way than by its stroke 2R."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from kurbel.errors import ProblemError
from kurbel.exact.numerals import about, exact_text, nearest, number_text
from kurbel.reading.given import Exact, as_fraction, as_length
from kurbel.reading.units import split

# An irrational crank radius is told to more places than these.
NEAR = Fraction(1, 10**30)


def in_strokes(given: Mapping[str, Any]) -> dict[str, Any]:
    """Return the options with the stroke 2R that another option makes in place of that: the crank radius, in
    its unit, or the true stroke, with the rod where the time ratio makes it.

    Raises ProblemError where a stroke is given, too, and is another one.
    """
    others = ("crank", "true_stroke", "time_ratio")
    left = {name: value for name, value in given.items() if name not in others}
    if (crank := given.get("crank")) is not None:
        left["stroke"] = _agreed(given.get("stroke"), crank)
    if given.get("true_stroke") is None:
        if given.get("time_ratio") is not None:
            raise ProblemError("--time-ratio makes the crank and the rod of the stroke; add --true-stroke")
        return left
    from kurbel.drive.size.true_stroke import found

    radius, rod = found(given)
    if (stroke := left.get("stroke")) is not None and abs(as_length(stroke, "stroke") / radius - 2) > NEAR:
        raise ProblemError(
            f"the stroke 2R is {_shown(stroke)}, and the true stroke {_shown(given['true_stroke'])} takes one"
            f" of {number_text(nearest(2000 * radius, 3))} mm; leave one of the two out"
        )
    return {**left, "stroke": 2 * radius, **({} if rod is None else {"rod": rod})}


def _agreed(stroke: Exact | None, crank: Exact) -> Exact:
    """Return the stroke that the crank radius makes, if no other one is given."""
    radius = as_length(crank, "crank radius")
    if radius <= 0:
        raise ProblemError(f"the crank radius is {about(radius)} m; it must be above 0")
    if stroke is not None and as_length(stroke, "stroke") != 2 * radius:
        raise ProblemError(
            f"the stroke 2R is {_shown(stroke)} and the crank R is {_shown(crank)}, which makes a stroke of"
            f" {_shown(_doubled(crank))}; leave one of the two out"
        )
    return _doubled(crank)


def _doubled(length: Exact) -> Exact:
    if not isinstance(length, str):
        return 2 * as_fraction(length)
    value, unit = split(length)
    return f"{exact_text(2 * value)}{unit}"


def _shown(length: Exact) -> str:
    return length.strip() if isinstance(length, str) else f"{about(as_fraction(length))} m"
