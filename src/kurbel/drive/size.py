"""The size of a crank given in another way than by its stroke 2R.

The crank of a piston whose true stroke is given: that of an offset crank is longer than 2R.

R is irrational as a rule. It is taken to so many decimals of a metre that no page shows the difference.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import isqrt
from typing import NamedTuple

from kurbel.errors import ProblemError
from kurbel.exact.numerals import about, exact_text
from kurbel.reading import units
from kurbel.reading.given import as_length, as_ratios, as_share
from kurbel.reading.notation import check_bounds, number
from kurbel.reading.units import split

# How a stroke is written that is not 2R: crank:300mm is R, true:600mm the way of the piston.
CRANK, TRUE = "crank:", "true:"
# The mechanisms whose crank the way of the piston makes; the first is not said.
SLIDES = (None, "straight", "offset")


def is_written(stroke: object) -> bool:
    """Whether a stroke is written by the crank or by the way of the piston."""
    return isinstance(stroke, str) and stroke.startswith((CRANK, TRUE))


def in_strokes(given: Mapping[str, object]) -> dict[str, object]:
    """Return the stroke as 2R where it is written in another way, with the rod where the time ratio makes it.

    Raises KurbelError.
    """
    stroke, ratio = given.get("stroke"), given.get("time_ratio")
    if isinstance(stroke, str) and stroke.startswith(TRUE):
        radius, rod = found({**given, "stroke": stroke.removeprefix(TRUE)})
        return {"stroke": 2 * radius, "time_ratio": None, **({} if rod is None else {"rod": rod})}
    if ratio is not None:
        if given.get("mechanism") not in SLIDES:
            raise ProblemError(
                "--time-ratio makes the straight or the offset crank; leave it out: that of another mechanism"
                " follows from its lengths, `kurbel deadcentres --columns time_ratio`"
            )
        raise ProblemError(
            "--time-ratio makes the crank and the rod of the way of the piston; add --stroke true:600mm"
        )
    return {"stroke": _doubled(stroke.removeprefix(CRANK)) if isinstance(stroke, str) else stroke}


def _doubled(crank: str) -> str:
    radius = as_length(crank, "crank radius")
    check_bounds("the crank radius", radius, "be above 0", " m")
    value, unit = split(crank)
    return f"{exact_text(2 * value)}{unit}"


DECIMALS = 40
_PRECISION = 300


class Offset(NamedTuple):
    """e in metres, or as a share of R."""

    metres: Fraction | None
    share: Fraction = Fraction(0)


def found(given: Mapping[str, object]) -> tuple[Fraction, Fraction | None]:
    """Return R, and L if the time ratio makes it, in metres, of the options of a crank drive.

    Raises ProblemError for what no crank does, or what is not enough to find one.
    """
    radius, rod = _sizes(given)
    if not radius or rod == 0:
        raise ProblemError(f"the true stroke {given['stroke']} is too small to find a crank of")
    return radius, rod


def _sizes(given: Mapping[str, object]) -> tuple[Fraction, Fraction | None]:
    stroke, offset = as_length(given["stroke"], "true stroke"), _offset(given.get("offset"))
    if given.get("mechanism") not in SLIDES:
        raise ProblemError(
            "a true stroke is that of the straight and the offset crank; write --stroke crank:300mm"
        )
    check_bounds("the true stroke", stroke, "be above 0", " m")
    rod, ratios = given.get("rod"), given.get("ratio")
    if given.get("time_ratio") is not None:
        if rod is not None or ratios:
            raise ProblemError(
                "--time-ratio and a true stroke make the crank and the rod; leave --rod and --ratio out"
            )
        return by_time_ratio(stroke, offset, as_share(given["time_ratio"], "time ratio"))
    if offset == Offset(None):
        return stroke / 2, None
    if rod is not None:
        return by_rod(stroke, offset, as_length(rod, "rod")), None
    listed = as_ratios(ratios) if ratios else ()
    if len(listed) != 1:
        raise ProblemError(
            "a true stroke needs the rod to find the crank of an offset one; add --rod, one --ratio or"
            " --time-ratio"
        )
    return by_ratio(stroke, offset, listed[0]), None


def by_rod(stroke: Fraction, offset: Offset, rod: Fraction) -> Fraction:
    """Return R of S, e and L: R² = S²/4 (4L² - 4e² - S²)/(4L² - S²), with e = εR
    R² = S²/4 (4L² - S²)/(4L² - S² (1 - ε²)).

    Re-derived: of the distances a, b of the dead centres a - b = S, a² - b² = 4LR, a² + b² = 2(L² + R² - e²).
    """
    rest = 4 * rod**2 - stroke**2
    if offset.metres is None:
        square = stroke**2 / 4 * rest / (rest + (stroke * offset.share) ** 2) if rest > 0 else Fraction(-1)
    else:
        square = stroke**2 / 4 * (rest - 4 * offset.metres**2) / rest if rest > 0 else Fraction(-1)
    # a - b and a + b are exchanged in these: a + b = 4LR/S is the greater one.
    if square <= 0 or 16 * rod**2 * square < stroke**4:
        raise ProblemError(
            f"no crank makes a stroke of {about(stroke)} m with a rod of {about(rod)} m so far off the slide;"
            " the rod must be longer, or the stroke or the offset smaller"
        )
    return root(square)


def by_ratio(stroke: Fraction, offset: Offset, ratio: Fraction) -> Fraction:
    """Return R of S, e and λ = R/L, by the same with L = R/λ; λ = 0 is the infinite rod, of which S = 2R.

    4R⁴/(λS)² - (1 + 1/λ²) R² + S²/4 + e² = 0, whose greater root it is: the other has S and R in the ratio of
    the rod.
    """
    if not ratio:
        return stroke / 2
    if offset.metres is None:
        side = offset.share**2
        outer, inner = root((1 / ratio + 1) ** 2 - side), root((1 / ratio - 1) ** 2 - side)
        return rounded(stroke / (outer - inner))
    middle = 1 + 1 / ratio**2
    leading = 4 / (ratio * stroke) ** 2
    under = middle**2 - 4 * leading * (stroke**2 / 4 + offset.metres**2)
    square = (middle + root(under)) / (2 * leading) if under >= 0 else Fraction(0)
    if 16 * square**2 < ratio**2 * stroke**4:
        raise ProblemError(
            f"no crank makes a stroke of {about(stroke)} m with this ratio so far off the slide; the offset"
            " must be smaller"
        )
    return root(square)


def by_time_ratio(stroke: Fraction, offset: Offset, ratio: Fraction) -> tuple[Fraction, Fraction]:
    """Return R and L of S, e and the time of the outstroke over that of the return.

    Between the dead centres the crank turns Δ = 180° (Q - 1)/(Q + 1) more than half a turn; seen from the
    shaft the stroke has this angle, so that L ± R are sides of a triangle on S of the height e:
    R² = S²/4 - S e/2 tan Δ/2, L² = S²/4 + S e/2 cot Δ/2. Re-derived.
    """
    if offset.metres is None or not offset.metres:
        raise ProblemError("--time-ratio needs the offset as a length; add it, for example --offset 50mm")
    if ratio <= 0 or (ratio > 1) != (offset.metres > 0) or ratio == 1:
        raise ProblemError(
            f"the time of the outstroke over that of the return is {about(ratio)}; with an offset above 0 it"
            " is above 1, with one below 0 between 0 and 1"
        )
    tangent = _tangent(90 * (ratio - 1) / (ratio + 1))
    half, area = stroke**2 / 4, stroke * offset.metres / 2
    crank, rod = half - area * tangent, half + area / tangent
    if crank <= 0 or 16 * crank * rod < stroke**4:
        raise ProblemError(
            f"no crank makes a stroke of {about(stroke)} m with this offset and time ratio; the time ratio"
            " must be nearer to 1, or the offset smaller"
        )
    return root(crank), root(rod)


def root(square: Fraction) -> Fraction:
    """Return the root of a fraction, exact where it is rational."""
    exact = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    return exact if exact**2 == square else Fraction(isqrt(int(square * 10 ** (2 * DECIMALS))), 10**DECIMALS)


def rounded(value: Fraction) -> Fraction:
    """Return a number to so many decimals, exact if it has fewer figures."""
    return value if value.denominator < 10**DECIMALS else Fraction(round(value * 10**DECIMALS), 10**DECIMALS)


def _tangent(degrees: Fraction) -> Fraction:
    from kurbel.exact.certify import at_bits, ball_circle

    with at_bits(_PRECISION):
        circle = ball_circle(degrees)
        middle = (circle.sine / circle.cosine).mid()
        return Fraction(str(middle.str(60, radius=False)))


def _offset(given: object) -> Offset:
    if given is None:
        return Offset(None)
    text = str(given).strip().removesuffix("R")
    if isinstance(given, str) and units.is_measure(text):
        return Offset(units.displacement(given, "offset"))
    return Offset(None, number(text, "offset"))
