"""Kinematics of the slotted lever (Kurbelschleife): a block on the crank pin slides in a lever and turns it.

The lever's pivot lies D R beside the shaft, square to the slide direction. For D > 1 the lever swings
(crank and slotted lever), for D < 1 it is carried round (Whitworth). At its arm of B R hangs a rod, which
moves a ram along a line h R above the pivot, on the side of the shaft; of the infinite rod the ram has the
way of the arm's end along the slide.

Units are R, the crank-pin velocity v and v²/R, ω and ω². The crank angle φ counts from the slide direction,
so that the pin is farthest from the pivot at 90°, in the middle of the slow stroke, the outstroke. With D and
λ = R/L negative, and h and the arm's height counted as before, everything is in the frame of the return: φ
from 180° and the way from the outer dead centre. λ is negative on the outstroke where the ram is drawn.

Numbers are floats, arrays, balls or separation bounds. Floats: at most 20 ulp of max(|value|, 1) while D is
not within 0.2 of 1. Derived by us.
"""

from __future__ import annotations

from typing import Generic, NamedTuple

from kurbel.kernel.circle import Circle, Kind, Numeric, cosine_of, root


class Lever(NamedTuple, Generic[Kind]):
    """A slotted lever at a crank angle, all of one kind of number.

    `reach` is from the pivot to the block; `sine` and `cosine` are of the lever's angle from the line of
    centres, the sine positive in the direction of the stroke; `turning` and `gain` are its angular velocity
    and acceleration as the crank turns; `slide` is the velocity of the block away from the pivot; `slant` and
    `slant_cosine` are those of the rod from the slide, `pull` the way of the ram for a turn of the lever.
    """

    reach: Kind
    sine: Kind
    cosine: Kind
    turning: Kind
    gain: Kind
    slide: Kind
    slant: Kind
    slant_cosine: Kind
    pull: Kind


class Links(NamedTuple, Generic[Kind]):
    """D, B, h and λ, D and λ with the sign of the stroke, and that sign."""

    pivot: Kind
    arm: Kind
    height: Kind
    ratio: Kind
    stroke: int


def lever(circle: Circle[Numeric], links: Links[Numeric]) -> Lever[Numeric]:
    """Return where the drive stands at a crank angle."""
    pivot, arm, height, ratio, stroke = links
    square = 1 + pivot * pivot + 2 * pivot * circle.sine
    reach = root(square)
    sine, cosine = -circle.cosine / reach, stroke * (circle.sine + pivot) / reach
    slant = ratio * (height - arm * cosine)
    slant_cosine = cosine_of(slant)
    return Lever(
        reach,
        sine,
        cosine,
        (1 + pivot * circle.sine) / square,
        pivot * (pivot * pivot - 1) * circle.cosine / (square * square),
        pivot * circle.cosine / reach,
        slant,
        slant_cosine,
        arm * (cosine - sine * (slant / slant_cosine)),
    )


def velocity(at: Lever[Numeric], links: Links[Numeric]) -> Numeric:
    """Return the velocity of the ram in units of v, positive in the direction of the stroke."""
    return links.stroke * at.turning * at.pull


def acceleration(at: Lever[Numeric], links: Links[Numeric]) -> Numeric:
    """Return the acceleration of the ram in units of v²/R."""
    bent, across = at.slant / at.slant_cosine, links.arm * at.sine
    drawn = links.arm * (at.sine + at.cosine * bent)
    drawn += links.ratio * across * across / (at.slant_cosine * at.slant_cosine * at.slant_cosine)
    return links.stroke * at.gain * at.pull - at.turning * at.turning * drawn


def rod_velocity(at: Lever[Numeric], links: Links[Numeric]) -> Numeric:
    """Return the angular velocity of the rod in units of ω, positive against the sense of the crank."""
    return links.ratio * links.arm * at.sine * at.turning / at.slant_cosine


def rod_acceleration(at: Lever[Numeric], links: Links[Numeric]) -> Numeric:
    """Return the angular acceleration of the rod in units of ω², likewise."""
    turning, bent = rod_velocity(at, links), at.slant / at.slant_cosine
    lifted = at.sine * at.gain + links.stroke * at.cosine * at.turning * at.turning
    return links.ratio * links.arm * lifted / at.slant_cosine + links.stroke * bent * turning * turning


def coriolis(at: Lever[Numeric]) -> Numeric:
    """Return the acceleration of Coriolis at the block, square to the lever as it turns, in units of v²/R."""
    return 2 * at.turning * at.slide


def block_force(at: Lever[Numeric]) -> Numeric:
    """Return the force between lever and block, of a force 1 on the ram in the direction of the stroke."""
    return at.pull / at.reach


def radial_force(at: Lever[Numeric], circle: Circle[Numeric], links: Links[Numeric]) -> Numeric:
    """Return the force along the crank at its pin, positive towards the shaft."""
    return links.stroke * block_force(at) * links.pivot * circle.cosine / at.reach


def dead_lever(links: Links[Numeric], swings: bool) -> tuple[Numeric, Numeric]:
    """Return sine and cosine of the lever's angle where the stroke begins.

    A lever that swings is there square to the crank. One that is carried round is in line with the rod.
    """
    if swings:
        sine = -1 / (links.stroke * links.pivot)
        return sine, cosine_of(sine)
    cosine = -links.height * links.ratio / (1 - links.arm * links.ratio)
    return -cosine_of(cosine), cosine


def dead_crank_sine(links: Links[Numeric], swings: bool) -> Numeric:
    """Return the sine of the crank angle there, which lies within ±90°."""
    if swings:
        return -1 / links.pivot
    sine, cosine = dead_lever(links, swings)
    along = links.stroke * links.pivot
    reach = along * cosine + root(1 - along * along * sine * sine)
    return links.stroke * (reach * cosine - along)


def path(at: Lever[Numeric], links: Links[Numeric], swings: bool) -> Numeric:
    """Return the way of the ram from the dead centre where the stroke begins, in units of R."""
    sine, cosine = dead_lever(links, swings)
    # As a difference of L cos σ it would lose the digits of λ.
    height = links.height - links.arm * cosine
    begun = links.ratio * height
    now = links.height - links.arm * at.cosine
    rod = links.ratio * (height - now) * (height + now) / (at.slant_cosine + cosine_of(begun))
    return links.arm * (at.sine - sine) + rod
