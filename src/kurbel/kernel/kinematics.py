"""Kinematics of the crank drive: piston path, velocity and acceleration, rod angle and its slopes.

Every function takes the `Circle` of the crank angle and the crank ratio λ = R/L and returns a number of
the same kind as the circle's: a float, an array or a ball. Units are the crank radius R, the crank-pin
velocity v and v²/R. The crank angle φ counts from the inner dead centre (crosshead farthest from the
shaft), for the return stroke from the outer one.

A negative ratio is the return stroke, the lower sign of the books: at 180° + α both sin φ and cos φ
change their signs, which leaves the formulas as they are but for the sign of λ. An offset changes its
sign with the ratio; None is the straight crank, whose formulas leave floats more digits. Ratio 0 is the
infinite rod. Valid for |λ| < 1, with an offset e = ηR for |η| <= 1/|λ| - 1; outside, the rod is too short
to pass the dead centre and the root of a negative number appears.
"""

from typing import Generic, NamedTuple

from kurbel.kernel.circle import Circle, Kind, Numeric, cosine_of, root


def rod_sine(circle: Circle[Numeric], ratio: Numeric, offset: Numeric = 0) -> Numeric:
    """Return sin ψ = λ (sin φ - η) of the rod angle ψ, positive while the pin is on the positive side.

    offset is η = e/R. Source: Rötscher, eq. (285), with the offset.
    """
    return ratio * (circle.sine - offset)


def rod_cosine(circle: Circle[Numeric], ratio: Numeric) -> Numeric:
    """Return w = cos ψ of the straight crank, 0 < w <= 1."""
    # 1 - (λ sin φ)² loses digits as λ nears 1; this sum of two squares does not. A float's ** 2 is
    # libm's pow: one square in a thousand would differ from NumPy's in the last place.
    across = ratio * circle.cosine
    return root((1 - ratio) * (1 + ratio) + across * across)


class RodDirection(NamedTuple, Generic[Kind]):
    """sin ψ and cos ψ of the rod angle ψ, of one kind of number."""

    sine: Kind
    cosine: Kind


def rod_slant(
    circle: Circle[Numeric], ratio: Numeric, offset: Numeric | None = None
) -> RodDirection[Numeric]:
    """Return the direction of the rod, ψ positive as in `rod_sine`."""
    if offset is None:
        return RodDirection(ratio * circle.sine, rod_cosine(circle, ratio))
    sine = rod_sine(circle, ratio, offset)
    return RodDirection(sine, cosine_of(sine))


def piston_path(circle: Circle[Numeric], ratio: Numeric, offset: Numeric | None = None) -> Numeric:
    """Return the piston path x = 1 - cos φ + (1 - cos ψ)/λ from the dead centre, in units of R.

    Floats: at most 1.6 ulp from the true value for |λ| <= 1/3, else 4/(1 - |λ|) ulp.
    Source: Rötscher, eq. (285), rewritten. With an offset it is `offset_path`.
    """
    if offset is not None:
        return offset_path(circle, ratio, offset)
    # The textbook (1 - cos ψ)/λ divides by zero for an infinite rod and keeps half its digits at
    # λ = 1e-4. λ sin² φ/(1 + cos ψ) does neither, but its four roundings reach 3 ulp on the return
    # stroke, where it is half as large as x. Near the dead centre it is λ (1 - cos φ), rounded once, but
    # for a small share.
    sine = ratio * circle.sine
    w = rod_cosine(circle, ratio)
    slant = ratio * circle.versine
    share = (circle.versine - sine * sine / (1 + w)) / (1 + w)
    return circle.versine + (slant - slant * share + circle.versine_tail)


def rod_versine(circle: Circle[Numeric], ratio: Numeric) -> Numeric:
    """Return (1 - cos ψ)/λ, the share of the piston path that the rod's slant adds, in units of R.

    Blau's fd and Rötscher's GF. Floats: at most 3 ulp from the true value for |λ| <= 0.99. Source: Rötscher,
    the circle about K, rewritten as GF = CF²/(L + L cos ψ).
    """
    # (1 - cos ψ)/λ divides by zero for an infinite rod and keeps half its digits at λ = 1e-4.
    return ratio * circle.sine * circle.sine / (1 + rod_cosine(circle, ratio))


def piston_velocity(circle: Circle[Numeric], ratio: Numeric, offset: Numeric | None = None) -> Numeric:
    """Return the piston velocity c = sin(φ + ψ)/cos ψ away from the dead centre, in units of v.

    Floats: at most 1.8 ulp from the true value for |λ| <= 1/3, else 4/(1 - |λ|) ulp; of an offset crank as
    close as `offset_path`. Re-derived: the slope of Rötscher, eq. (285), c = sin φ + cos φ tan ψ.
    """
    if offset is not None:
        lean = rod_slant(circle, ratio, offset)
        return circle.sine + circle.cosine * (lean.sine / lean.cosine)
    # sin ψ cos φ/cos ψ outright reaches 2.2 ulp where it takes half of sin φ away; 1/cos ψ is
    # 1 + (1 - cos ψ)/cos ψ, and the last share is small there.
    sine = ratio * circle.sine
    w = rod_cosine(circle, ratio)
    slant = sine * circle.cosine
    share = sine * sine / ((1 + w) * w)
    return circle.sine + (slant + (slant * share + circle.sine_tail))


def piston_acceleration(circle: Circle[Numeric], ratio: Numeric, offset: Numeric | None = None) -> Numeric:
    """Return the piston acceleration p = cos φ + λ (cos 2φ + λ² sin⁴ φ)/cos³ ψ, in units of v²/R, of the
    offset crank cos φ - sin φ tan ψ + λ cos² φ/cos³ ψ.

    Positive away from the dead centre. Floats: at most 2 ulp of max(|p|, 1) from the true value for
    |λ| <= 1/3, 10 ulp for |λ| <= 0.99; of an offset crank as close as `offset_path`. Re-derived: the slope of
    the velocity.
    """
    if offset is not None:
        sine, w = rod_slant(circle, ratio, offset)
        turning = ratio * circle.cosine * circle.cosine / (w * w * w)
        return circle.cosine + (turning - circle.sine * (sine / w))
    # cos 2φ + λ² sin⁴ φ is cos² φ - (sin φ cos ψ)²; the product of sum and difference keeps its
    # digits where it passes through zero.
    w = rod_cosine(circle, ratio)
    across = circle.sine * w
    return circle.cosine + ratio * ((circle.cosine - across) * (circle.cosine + across)) / (w * w * w)


def piston_path_first_order(circle: Circle[Numeric], ratio: Numeric) -> Numeric:
    """Return x = 1 - cos φ + ½ λ sin² φ from the dead centre, in units of R.

    Floats: at most 1.6 ulp from the true value for |λ| <= 1/3, else 4/(1 - |λ|) ulp.
    Source: Blau, eq. (22), with sin² φ written as (1 - cos φ)(2 - (1 - cos φ)).
    """
    slant = ratio * circle.versine
    return circle.versine + (slant - slant * circle.versine / 2 + circle.versine_tail)


def piston_velocity_first_order(circle: Circle[Numeric], ratio: Numeric) -> Numeric:
    """Return c = sin φ + ½ λ sin 2φ, in units of v.

    Floats: at most 1.8 ulp from the true value for |λ| <= 1/3, else 4/(1 - |λ|) ulp.
    Source: Blau, eq. (25).
    """
    return circle.sine + (circle.sine * (ratio * circle.cosine) + circle.sine_tail)


def piston_acceleration_first_order(circle: Circle[Numeric], ratio: Numeric) -> Numeric:
    """Return p = cos φ + λ cos 2φ, in units of v²/R.

    Floats: at most 2 ulp of max(|p|, 1) from the true value for |λ| <= 1/3, 3 ulp for |λ| < 1.
    Source: Blau, eq. (26).
    """
    # 1 - 2 sin² φ would not be zero at 45°.
    return circle.cosine + ratio * ((circle.cosine - circle.sine) * (circle.cosine + circle.sine))


def dead_centre_sine(ratio: Numeric, offset: Numeric) -> Numeric:
    """Return sin φ_i = λη/(1 + λ) = e/(L + R), the inner dead centre of the offset crank.

    For the return stroke (-λ, -η) it is the sine of φ_o - 180°, e/(L - R). The rod then lies in line
    with the crank, hence also sin ψ_i = -sin φ_i.
    """
    return ratio * offset / (1 + ratio)


def offset_path(circle: Circle[Numeric], ratio: Numeric, offset: Numeric) -> Numeric:
    """Return the piston path of the offset crank from its own dead centre, in units of R.

    The slide line passes the shaft at e = ηR, on the side of the crank pin during the outstroke. φ counts
    from the line through the shaft along the slide, so x = 0 at φ_i (`dead_centre_sine`). The return
    stroke (-λ, -η) counts from the outer dead centre. Floats: at most 3 ulp of max(|x|, 1) from the true
    value while |sin ψ| <= ½, 12 ulp while it is <= 0.9. Re-derived.
    """
    # With the dead centre's angles: x = cos φ_i - cos φ + (cos ψ_i - cos ψ)/λ. The last term is
    # rewritten as a quotient, as in piston_path, so that no 1/λ is left.
    dead_sine = dead_centre_sine(ratio, offset)
    dead_cosine = cosine_of(dead_sine)
    dead_versine = dead_sine * dead_sine / (1 + dead_cosine)
    sine, cosine = rod_slant(circle, ratio, offset)
    slant = (circle.sine - dead_sine) * (sine - dead_sine) / (cosine + dead_cosine)
    return (circle.versine - dead_versine) + slant


def rod_velocity(circle: Circle[Numeric], ratio: Numeric, offset: Numeric | None = None) -> Numeric:
    """Return the angular velocity of the rod, the slope of ψ: λ cos φ/cos ψ, in units of ω.

    Positive as ψ grows, against the sense of the crank, in the frame of the outstroke on either stroke.
    Floats: at most 3 ulp from the true value for |λ| <= 0.99; of an offset crank as close as `offset_path`.
    Re-derived: a slope of sin ψ = λ (sin φ - η).
    """
    # No zero is to have a sign, here and below.
    return ratio * circle.cosine / rod_slant(circle, ratio, offset).cosine + 0


def rod_acceleration(circle: Circle[Numeric], ratio: Numeric, offset: Numeric | None = None) -> Numeric:
    """Return the angular acceleration of the rod, -λ (1 - λ²) sin φ/cos³ ψ, in units of ω², signed as ψ; of
    the offset crank -λ (sin φ - λ sin ψ (1 - η sin φ))/cos³ ψ.

    Floats: at most 6 ulp from the true value for |λ| <= 0.99; of an offset crank as close as `offset_path`.
    Re-derived: the slope of the velocity.
    """
    return 0 - ratio * rod_turning(circle, ratio, *rod_slant(circle, ratio, offset), offset)


def rod_velocity_first_order(circle: Circle[Numeric], ratio: Numeric) -> Numeric:
    """Return λ cos φ, in units of ω: the rod's angular velocity to first order in λ. Re-derived."""
    return ratio * circle.cosine + 0


def rod_acceleration_first_order(circle: Circle[Numeric], ratio: Numeric) -> Numeric:
    """Return -λ sin φ, in units of ω²: the rod's angular acceleration to first order in λ. Re-derived."""
    return 0 - ratio * circle.sine


def rod_turning(
    circle: Circle[Numeric], ratio: Numeric, slant: Numeric, cosine: Numeric, offset: Numeric | None
) -> Numeric:
    """Return -L ψ̈ in units of R ω², from sin ψ and cos ψ: (sin φ - λ sin ψ (1 - η sin φ))/cos³ ψ.

    Of the straight crank, offset None, that is (1 - λ²) sin φ/cos³ ψ. It has a value for the infinite rod,
    which does not turn. Re-derived.
    """
    if offset is None:
        above = circle.sine * ((1 - ratio) * (1 + ratio))
    else:
        above = circle.sine - ratio * slant * (1 - offset * circle.sine)
    return above / (cosine * cosine * cosine)


def stroke(ratio: Numeric, offset: Numeric = 0) -> Numeric:
    """Return the piston stroke √((L + R)² - e²) - √((L - R)² - e²) in units of R; 2 for the straight crank.

    The sign of the ratio does not matter. Re-derived from the two dead centres.
    """
    # The textbook difference of two long sides loses digits for a long rod: at λ = 1e-8 half of them.
    side = (ratio * offset) * (ratio * offset)
    outer = (1 + ratio) * (1 + ratio) - side
    inner = (1 - ratio) * (1 - ratio) - side
    return 4 / (root(outer) + root(inner))


def mean_piston_speed(stroke: Numeric, speed: Numeric) -> Numeric:
    """Return c_m = S n/30 in m/s, from the stroke S in m and the speed n in 1/min."""
    return stroke * speed / 30


def mean_piston_velocity(stroke: Numeric, pi: Numeric = 3.141592653589793) -> Numeric:
    """Return c_m = S/π in units of v, from the stroke S in units of R; 2/π for the straight crank.

    Balls pass their own π.
    """
    return stroke / pi
