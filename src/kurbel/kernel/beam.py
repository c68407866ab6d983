"""The dead centres of the beam engine: a beam (Balancier) on a pivot, rod and crank.

Lengths are in units of the crank radius r: arm is a/r, ratio is λ = r/l of crank and rod; λ = 0 is the
infinite rod. Numbers are floats, arrays or balls. The beam's end swings from q above the horizontal through
its pivot to q below it, and the vertical through the shaft halves the sagitta e of this arc. At the upper
dead centre crank and rod are stretched (l + r), at the lower one folded (l - r); the rod leans by μ and ν
towards the pivot. A negative ratio is the lower dead centre, as it is the return stroke elsewhere.

The book takes q = r, e = q²/2a, sin μ = μ and, for the beam's small paths, an infinite rod. The true
geometry, re-derived here, is a function of q²/r², the square of the half chord, which is the lesser root of
`closure`. Valid for 0 <= λ < 1 where `turning_margin` is above 0.

Source: Weisbach-Herrmann, § 149.
"""

from kurbel.kernel.circle import Numeric, cosine_of, root


def approximate_lean(arm: Numeric, ratio: Numeric) -> Numeric:
    """Return μ = r²/(4a(l + r)) in radians, for a negative ratio ν = r²/(4a(l - r)).

    Source: § 149.
    """
    return abs(ratio) / (4 * arm * (1 + ratio))


def approximate_path(half_sine: Numeric) -> Numeric:
    """Return 1 - cos μ from sin ½μ, the beam's path while the crank turns by μ. Source: § 149."""
    return 2 * half_sine * half_sine


def turning_margin(arm: Numeric, ratio: Numeric) -> Numeric:
    """Return a number above 0 if the crank turns, 0 if beam, pivot and shaft come into line, else below 0.

    It is 4a(l - r)(a + l - r)² - r l(a + 2(l - r))² over r l³. Where it is 0, the beam's end, its pivot and
    the shaft lie in line at the lower dead centre. For λ < 1 it rises through 0 once as the arm grows, and
    for a > r once as the rod grows; for a <= r it is never above 0. Re-derived.
    """
    short = 1 - ratio
    reach = arm * ratio + short
    span = reach + short
    return 4 * arm * short * reach * reach - span * span


def highest_square(arm: Numeric, ratio: Numeric) -> Numeric:
    """Return the q²/r² that puts the beam's lower end in line with its pivot and the shaft, l - r before it.

    The lesser of this and l/r bounds the root of `closure` from above, if the crank turns. Re-derived.
    """
    short = 1 - ratio
    reach = arm * ratio + short
    span = reach + short
    return 4 * arm * arm * short * reach / (span * span)


def closure(square: Numeric, arm: Numeric, ratio: Numeric) -> Numeric:
    """Return (q² - r²)(l² - q²)/(q² l²) - e²/(4 l²), which is 0 if the beam swings symmetrically.

    Both dead centres, (h ± q)² + ¼e² = (l ± r)², give the height h = l r/q of the pivot above the shaft and
    this. It is concave in q² < a², not above 0 at q = r and, if the crank turns, above 0 at the lesser
    of l r and `highest_square`. Re-derived.
    """
    slant = ratio * sagitta(square, arm) / 2
    return (square - 1) * (1 - ratio * ratio * square) / square - slant * slant


def closure_slope(square: Numeric, arm: Numeric, ratio: Numeric) -> Numeric:
    """Return the slope of `closure` over q²/r²."""
    bend = sagitta(square, arm) / (4 * _chord_distance(square, arm))
    return 1 / (square * square) - ratio * ratio * (1 + bend)


def sagitta(square: Numeric, arm: Numeric) -> Numeric:
    """Return e = a - √(a² - q²) of the arc of the beam's end."""
    # The difference keeps half the digits at a = 10^4 r and none at 10^8 r.
    return square / (arm + _chord_distance(square, arm))


def lean_sine(square: Numeric, arm: Numeric, ratio: Numeric) -> Numeric:
    """Return sin μ = ½e/(l + r), for a negative ratio sin ν = ½e/(l - r). Re-derived."""
    return abs(ratio) * sagitta(square, arm) / (2 * (1 + ratio))


def swing_tangent(square: Numeric, arm: Numeric, ratio: Numeric) -> Numeric:
    """Return tan ½δ of the beam's turn δ between its dead centre and the position with vertical crank.

    The beam's end moves by a δ along its arc. Re-derived.
    """
    # Turned back by δ from the dead centre C, the beam's end is at the distance l from the pin B of the
    # vertical crank: w sin δ - p (1 - cos δ) = η with p = C·B and w = B×C from the pivot, and η the excess of
    # ½|CB|² over ½l². Here all three times λ, so that the infinite rod has them. Of the two roots this
    # keeps C on its side of the line from pivot to pin, which the turning crank never makes it cross; the
    # quadratic formula is turned over, or its difference would leave no digit of δ for a long beam.
    chord, distance = root(square), _chord_distance(square, arm)
    shaft = distance + sagitta(square, arm) / 2
    inner = ratio * (distance * shaft + chord) - 1
    outer = distance * (1 / chord - ratio) + ratio * chord * shaft
    lean = lean_sine(square, arm, ratio)
    excess = (1 + ratio) * (lean * lean / (1 + cosine_of(lean)))
    return excess / (outer + root(outer * outer - excess * (2 * inner + excess)))


def _chord_distance(square: Numeric, arm: Numeric) -> Numeric:
    """Return the distance of the chord from the pivot."""
    chord = root(square)
    return root((arm - chord) * (arm + chord))
