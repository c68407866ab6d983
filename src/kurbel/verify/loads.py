"""What presses on a piston over the share of its stroke that is gone: steam, air, water and gas cycles.

A pressure is constant, or follows p Vⁿ = const, from corner to corner. Both have closed antiderivatives:
∫ ds = s, and with V = a ± s, dV = ± ds,

    ∫ k (g/V)ⁿ ds = ± k gⁿ V^(1 - n)/(1 - n),    for n = 1  ± k g log V,

for the slopes of these by s are the pressures again. Values, slopes and integrals are enclosed throughout;
where an interval holds a corner they are the hull of what either side gives.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import accumulate
from typing import TypeVar

from kurbel.errors import ProblemError
from kurbel.verify.jets import Jet, angle_of, hulled
from kurbel.verify.numbers import Number, hull, number, pi, spread

# Typed: a fraction or a decimal.
Given = Fraction | str | int
Share = TypeVar("Share", Number, Jet)


@dataclass(frozen=True)
class Piece:
    """k (g/(a + σ s))ⁿ."""

    height: Number
    grown: Number
    room: Number
    sense: int
    exponent: Fraction

    def value(self, share: Share) -> Share:
        return self.height * (self._volume(share) / self.grown).power(-self.exponent)

    def integral(self, low: Number, high: Number) -> Number:
        """∫ from one share to another."""
        begin, end = self._volume(low), self._volume(high)
        if self.exponent == 1:
            return self.height * self.grown * (end / begin).log() * self.sense
        left = 1 - self.exponent
        ends = [one * (self.grown / one).power(self.exponent) for one in (begin, end)]
        return self.height * (ends[1] - ends[0]) / (left * self.sense)

    def _volume(self, share: Share) -> Share:
        return self.room + share * self.sense


@dataclass(frozen=True)
class Cubic:
    """c₀ + c₁ h + c₂ h² + c₃ h³ or less, h the share from where it begins."""

    begin: Number | Fraction
    terms: Jet

    def value(self, share: Jet) -> Jet:
        return self.terms.at(share - self.begin)

    def integral(self, low: Number, high: Number) -> Number:
        whole = angle_of(number(0), self.terms)
        return whole.at(high - self.begin) - whole.at(low - self.begin)


@dataclass(frozen=True)
class Pressure:
    """Pieces with the share at which each ends, the last at 1; the pressure does not leap between them."""

    pieces: tuple[tuple[Number, Piece | Cubic], ...]

    def value(self, share: Number) -> Number:
        return self.course(Jet([share])).value

    def course(self, share: Jet, near: Number | None = None) -> Jet:
        """The pressure with its slopes by what the share has slopes by; of the piece alone that is `near`."""
        if near is not None:
            return hulled([self.pieces[k][1].value(share) for k, _ in self._touched(near)])
        touched = self._touched(share.value)
        return hulled([self.pieces[k][1].value(Jet([at, *share.terms[1:]])) for k, at in touched])

    def integral(self, share: Number) -> Number:
        """∫ from 0 to a share."""
        touched = ((self._whole[k], self.pieces[k][1], self._begins[k], at) for k, at in self._touched(share))
        return hull([done + piece.integral(begin, at) for done, piece, begin, at in touched])

    @cached_property
    def _begins(self) -> list[Number]:
        return [number(0), *(end for end, _ in self.pieces)]

    @cached_property
    def _whole(self) -> list[Number]:
        """∫ up to where each piece begins."""
        parts = (piece.integral(self._begins[k], end) for k, (end, piece) in enumerate(self.pieces))
        return list(accumulate(parts, initial=number(0)))

    def _touched(self, share: Number) -> list[tuple[int, Number]]:
        """The pieces on which a share, or part of an interval of shares, may lie."""
        found: list[tuple[int, Number]] = []
        first = bisect_left(self.pieces[:-1], share.low, key=lambda one: one[0].high)
        for index in range(first, len(self.pieces)):
            begin, end = self._begins[index : index + 2]
            found.append((index, _within(share, begin, end)))
            if (share - end).side() in (0, -1):
                break
        return found


@dataclass(frozen=True)
class Stroke:
    """The net force on the piston in its direction of travel: pressures times areas."""

    sides: tuple[tuple[Fraction, Pressure], ...] = ()

    def force(self, share: Number) -> Number:
        return self.course(Jet([share])).value

    def slope(self, share: Number) -> Number:
        return self.course(Jet([share, number(1)])).slope()

    def course(self, share: Jet, near: Number | None = None) -> Jet:
        """The force with its slopes by what the share has slopes by."""
        return sum((pressure.course(share, near) * area for area, pressure in self.sides), share * 0)

    def work(self, share: Number) -> Number:
        """∫ of the force from the beginning of the stroke to a share."""
        return sum((pressure.integral(share) * area for area, pressure in self.sides), number(0))


Load = Callable[[], tuple[Stroke, ...]]


def _within(share: Number, low: Number, high: Number) -> Number:
    """The part of an interval of shares that lies on a piece."""
    if share.exact is not None:
        return share
    begin, end = max(share.low, low.low), min(share.high, high.high)
    return spread(begin, end) if begin <= end else share


def constant(height: Number | Fraction | int) -> Pressure:
    return Pressure(((number(1), _level(height)),))


def _level(height: Number | Fraction | int) -> Piece | Cubic:
    return Cubic(Fraction(0), Jet([number(height), number(0)]))


def _line(one: tuple[Number, Number], other: tuple[Number, Number]) -> Piece | Cubic:
    """The straight line through two points."""
    return Cubic(one[0], Jet([one[1], (other[1] - one[1]) / (other[0] - one[0])]))


def disc(bore: Given) -> Number:
    """π/4 d²."""
    return pi() / 4 * (Fraction(bore) * Fraction(bore))


def steam(
    eps: Given,
    *,
    back: Given | None = None,
    exponent: Given = 1,
    clearance: Given = 0,
    release: Given = 1,
    cushion: Given = 1,
    lead: Given = 0,
    single_acting: bool = False,
    bore: Given = 1,
    piston_rod: Given = 0,
    tail_rod: Given = 0,
) -> Load:
    """Full pressure, 1, up to the cut-off after 1/ε of the stroke, then expansion with the clearance.

    Without a back pressure it is that of the steam at the end of the stroke. The tail rod takes of the area
    on which the steam drives the outstroke, the piston rod of the other; a single-acting engine has no force
    on the return, but for compression. From the release on the pressure falls along a line to the back
    pressure; on the return it is that up to the cushioning, then compressed, and with the lead rises along a
    line to 1.
    """
    cut, room, power = 1 / Fraction(eps), Fraction(clearance), Fraction(exponent)
    head, crank = (1 - (Fraction(one) / Fraction(bore)) ** 2 for one in (tail_rod, piston_rod))

    def pressures() -> tuple[Stroke, ...]:
        expanding = Piece(number(1), number(cut + room), number(room), 1, power)
        pieces = [(number(cut), _level(1)), (number(1), expanding)]
        driving = Pressure(tuple(pieces if cut < 1 else pieces[:1]))
        behind = driving.value(number(1)) if back is None else number(Fraction(back))
        against = constant(behind)
        opened, closed, entry = Fraction(release), Fraction(cushion), 1 - Fraction(lead)
        if opened < 1:
            falling = _line((number(opened), driving.value(number(opened))), (number(1), behind))
            first = [(number(cut), _level(1)), (number(opened), expanding)][: 1 + (cut < opened)]
            driving = Pressure((*first, (number(1), falling)))
        idle = closed == entry == 1
        if not idle:
            squeezed = Piece(behind, number(1 - closed + room), number(1 + room), -1, power)
            last = [(number(closed), _level(behind)), (number(entry), squeezed)][: 1 + (closed < entry)]
            if entry < 1:
                risen = squeezed.value(number(entry))
                last.append((number(1), _line((number(entry), risen), (number(1), number(1)))))
            against = Pressure(tuple(last))
        if single_acting:
            face = constant(behind)
            after = Stroke() if idle else Stroke(((crank, face), (-head, against)))
            return Stroke(((head, driving), (-crank, face))), after
        return Stroke(((head, driving), (-crank, against))), Stroke(((crank, driving), (-head, against)))

    return pressures


def card(
    courses: Sequence[Sequence[Sequence[Fraction]]],
    *,
    other: Given | None = None,
    bore: Given = 1,
    piston_rod: Given = 0,
    tail_rod: Given = 0,
) -> Load:
    """What is measured in one end on each stroke of a cycle: cubics with the share at which each begins.

    The other end has the same on the other stroke, or its face the pressure `other`.
    """
    areas = [1 - (Fraction(one) / Fraction(bore)) ** 2 for one in (tail_rod, piston_rod)]

    def pressures() -> tuple[Stroke, ...]:
        found = []
        for cubics in courses:
            ends = [number(one[0]) for one in (*cubics[1:], [Fraction(1)])]
            pieces = (Cubic(begin, Jet([*map(number, terms)])) for begin, *terms in cubics)
            found.append(Pressure(tuple(zip(ends, pieces, strict=True))))
        pairs = [found, found]
        if other is not None:
            face = constant(Fraction(other))
            pairs = [[one, face][:: 1 - k % 2 * 2] for k, one in enumerate(found)]
        return tuple(Stroke(((areas[k % 2], a), (-areas[k % 2 - 1], b))) for k, (a, b) in enumerate(pairs))

    return pressures


def compressor(
    ratio: Given,
    *,
    exponent: Given = 1,
    clearance: Given = 0,
    suction_loss: Given = 0,
    delivery_loss: Given = 0,
    single_acting: bool = False,
    other: Given = 1,
    expansion_exponent: Given | None = None,
) -> Load:
    """In suction pressures. Behind the piston what the clearance holds expands down to suction, before it
    the air is compressed up to delivery; single-acting, `other` presses on the other face."""
    low, high = 1 - Fraction(suction_loss), Fraction(ratio) * (1 + Fraction(delivery_loss))
    room, power = Fraction(clearance), Fraction(exponent)
    whole = 1 + room

    def pressures() -> tuple[Stroke, ...]:
        grown = number(high / low).power(1 / power)
        coming = Pressure(
            (
                (whole - whole / grown, Piece(number(low), number(whole), number(whole), -1, power)),
                (number(1), _level(high)),
            )
        )
        leaving = constant(low)
        if room:
            again = Fraction(expansion_exponent or exponent)
            regrown = number(high / low).power(1 / again)
            expanding = Piece(number(high), number(room), number(room), 1, again)
            leaving = Pressure((((regrown - 1) * room, expanding), (number(1), _level(low))))
        one = Fraction(1)
        if not single_acting:
            return (Stroke(((one, leaving), (-one, coming))),) * 2
        face = constant(Fraction(other))
        return Stroke(((one, leaving), (-one, face))), Stroke(((one, face), (-one, coming)))

    return pressures


def pump(kind: str = "double", *, suction: Given = 0, delivery: Given = 1, small_area: Given = "1/2") -> Load:
    """In the difference of delivery and suction, which count from the other face. The double pump lifts on
    both strokes; the single one sucks on the outstroke and delivers on the return; of the differential one
    a small area on the other side is open to the delivery."""
    if kind not in ("double", "single", "differential"):
        raise ProblemError(f'there is no pump "{kind}"')
    span = Fraction(delivery) - Fraction(suction)
    low, high = Fraction(suction) / span, Fraction(delivery) / span
    ring = Fraction(small_area) * high if kind == "differential" else Fraction(0)
    forces = (Fraction(-1),) * 2 if kind == "double" else (low - ring, ring - high)
    return lambda: tuple(Stroke(((one, constant(1)),)) for one in forces)


def gas(
    compression: Given,
    *,
    cycle: str = "otto",
    exponent: Given = "1.4",
    expansion_exponent: Given | None = None,
    peak: Given | None = None,
    cut_off: Given = 1,
    heat: Given | None = None,
    exhaust: Given = 1,
    two_stroke: bool = False,
) -> Load:
    """In suction pressures, which press on the other face as well: expansion, exhaust, suction and
    compression; of two strokes the first and the last.

    Up to the peak heat is supplied at one volume, beyond it at one pressure until the volume has grown
    `cut_off` times. With γ the exponent of compression, Δp (V) at one volume takes V Δp/(γ - 1) and ΔV at one
    pressure γ p ΔV/(γ - 1); the charge of volume 1 + c at 1 takes `heat` (1 + c) in all.
    """
    squeeze, power = Fraction(compression), Fraction(exponent)
    room, outward = 1 / (squeeze - 1), Fraction(expansion_exponent or exponent)
    whole = 1 + room

    def pressures() -> tuple[Stroke, ...]:
        squeezed = number(squeeze).power(power)
        top, burnt = number(Fraction(peak)) if peak is not None else squeezed, number(Fraction(cut_off))
        if heat is not None:
            supplied = Fraction(heat) * whole * (power - 1) / room
            top = squeezed + supplied if cycle == "otto" else top
            burnt = 1 + (supplied - (top - squeezed)) / (top * power) if cycle != "otto" else number(1)
        volume = burnt * room
        expanding = Piece(top, volume, number(room), 1, outward)
        pieces = [(volume - room, _level(top)), (number(1), expanding)]
        driving = Pressure(tuple(pieces[1:] if burnt.rational == 1 else pieces))
        pressed = Pressure(((number(1), Piece(number(1), number(whole), number(whole), -1, power)),))
        one = Fraction(1)
        face = (one, constant(1))
        first, last = Stroke(((one, driving), (-one, constant(1)))), Stroke((face, (-one, pressed)))
        if two_stroke:
            return first, last
        return first, Stroke(((1 - Fraction(exhaust), constant(1)),)), Stroke(), last

    return pressures
