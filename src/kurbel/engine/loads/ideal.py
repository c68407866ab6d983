"""Steam by its ideal card: cut-off, expansion, back pressure; bounds that other loads have, too."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from math import floor
from typing import ClassVar

from kurbel.drive.load import STEAM
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind, floats
from kurbel.kernel.circle import Numeric
from kurbel.kernel.law import Constant, Law, Line, Piece, Polytrope, Stroke
from kurbel.kernel.steam import Expansion, best_back, power
from kurbel.reading.notation import about, check_bounds, plain, too_small

LARGEST_EXPANSION = 10**6
ANY_EXPONENT = "be above 0 and at most 10, for the pressure"
# What numbers of steam must be.
RULES = {
    "back": "lie within 0..1, for it is a share of the steam pressure before cut-off",
    "clearance": "lie within 0..10, for it is a share of the volume swept in a stroke",
    "exponent": f"{ANY_EXPONENT} falls as the steam expands",
}
# The work of the expansion is a quotient by n - 1.
LEAST_CURVE = Fraction(1, 10**6)
# Below this share of Q no mean force drives anything, and δ, counted in it, grows beyond all bounds.
LEAST_WORK = 1e-9


@dataclass(frozen=True, slots=True)
class Steam:
    """Expansion ratio ε (cut-off after the share 1/ε of the stroke), back pressure b = R/Q, exponent n of
    p V^n = const, clearance as a share of the stroke.

    `back` None is the best back pressure, that of the steam at the end of the stroke: 1/ε for n = 1 without
    clearance. From the share `release` of the stroke on the pressure falls evenly to the back pressure. On
    the return the exhaust closes at the share `cushion`, and what is left is compressed by the same law;
    `lead` before its end steam enters, and the pressure rises evenly to that of the steam. Valid for ε >= 1,
    0 <= b <= 1, n > 0, κ >= 0, as long as work is left and no more than the steam pressure is reached by
    compression.
    """

    name: ClassVar[str] = STEAM
    driven: ClassVar[bool] = False

    expansion: Fraction
    back: Fraction | None = None
    exponent: Fraction = Fraction(1)
    clearance: Fraction = Fraction(0)
    release: Fraction = Fraction(1)
    cushion: Fraction = Fraction(1)
    lead: Fraction = Fraction(0)

    @property
    def plain(self) -> bool:
        """Whether the exhaust is open over the whole return stroke and no longer."""
        return self.release == self.cushion == 1 and not self.lead

    def strokes(self, kind: Kind, double: bool) -> tuple[Stroke, Stroke]:
        """Return the force of both strokes, on a kind of number; single-acting, the return idles, or
        compresses."""
        numbers = self.numbers(kind.of, kind.exponent)
        other, idle = Constant(numbers.back), Constant(kind.of(Fraction(0)))
        if self.plain:
            acting = Stroke(numbers, other)
            return acting, acting if double else Stroke(idle, idle)
        behind, before = self._laws(numbers, kind)
        if double:
            return Stroke(behind, before), Stroke(behind, before)
        return Stroke(behind, other), Stroke(other, before)

    def __post_init__(self) -> None:
        if self.expansion < 1:
            raise ProblemError(too_small(self.expansion))
        if self.expansion > LARGEST_EXPANSION:
            raise ProblemError(
                f"expansion ratio ε is {about(self.expansion)}; at most {LARGEST_EXPANSION} is allowed"
            )
        check_bounds("back pressure b", self.back, RULES["back"])
        check_exponent(self.exponent, "exponent n", RULES["exponent"])
        check_clearance(self.clearance)
        if not self.plain:
            self._check_valves()
        self._check_work()

    def numbers(
        self, of: Callable[[Fraction], Numeric], exponent_of: Callable[[Fraction], Numeric] | None = None
    ) -> Expansion:
        """Return the same in a kind of number, which may want its exponents in another."""
        cut_off, clearance = of(1 / self.expansion), of(self.clearance)
        exponent = (exponent_of or of)(self.exponent)
        back = best_back(cut_off, exponent, clearance) if self.back is None else of(self.back)
        return Expansion(cut_off, back, exponent, clearance)

    def mean(self, kind: Kind, **found: Numeric) -> Numeric:
        """Return the mean pressure on an end that works, with `found` numbers in the place of some."""
        known = self.numbers(kind.of, kind.exponent)._replace(**found)
        if self.back is None:
            known = known._replace(back=best_back(known.cut_off, known.exponent, known.clearance))
        if self.plain:
            return known.whole() - known.back
        behind, before = self._laws(known, kind)
        return behind.whole() - before.whole()

    def least(self, name: str) -> Fraction:
        """Return the least clearance in which compression reaches no more than the steam pressure, near
        below it; 0 of other numbers."""
        if name != "clearance" or self.plain or not self.back:
            return Fraction(0)
        grown = float(self.back) ** (-1 / float(self.exponent))
        least = (float(1 - self.cushion) - float(self.lead) * grown) / (grown - 1) if grown > 1 else 0.0
        return max(Fraction(0), Fraction(least).limit_denominator(10**9) - Fraction(1, 10**8))

    def kept(self, numbers: Expansion, kind: Kind) -> Numeric:
        """Return the volume that what is left in the cylinder fills at the steam pressure."""
        share = power(numbers.back, kind.exponent(1 / self.exponent))
        return (numbers.clearance + kind.of(1 - self.cushion)) * share

    def _laws(self, numbers: Expansion, kind: Kind) -> tuple[Law, Law]:
        """Return the pressure in the end that the piston leaves, and in the other."""
        whole, one = 1 + numbers.clearance, kind.of(Fraction(1))
        release, cushion, entry = (kind.of(at) for at in (self.release, self.cushion, 1 - self.lead))
        room = numbers.cut_off + numbers.clearance
        expanding = Polytrope(one, room, numbers.exponent, numbers.clearance, 1)
        behind: list[tuple[Numeric, Piece]] = [(numbers.cut_off, Constant(one))]
        if 1 / self.expansion < self.release:
            behind.append((release, expanding))
        if self.release < 1:
            level = power(room / (release + numbers.clearance), numbers.exponent)
            behind.append((one, Line(level, numbers.back, release, one)))
        before: list[tuple[Numeric, Piece]] = [(cushion, Constant(numbers.back))]
        closed = whole - cushion
        if self.cushion < 1 - self.lead:
            before.append((entry, Polytrope(numbers.back, closed, numbers.exponent, whole, -1)))
        if self.lead:
            level = numbers.back * power(closed / (whole - entry), numbers.exponent)
            before.append((one, Line(level, one, entry, one)))
        return _law(behind), _law(before)

    def _check_valves(self) -> None:
        """Raise ProblemError for points of the stroke that no valve gear has in this order."""
        for what, share in (("release", self.release), ("cushioning", self.cushion)):
            if not 0 < share <= 1:
                raise ProblemError(
                    f"{what} is at {about(share)} of the stroke; it must be above 0 and at most 1"
                )
        check_bounds("lead", self.lead, "be 0 or more and below 1", " of the stroke")
        if self.release * self.expansion < 1:
            raise ProblemError(
                f"release at {about(self.release)} of the stroke comes before the cut-off at"
                f" {about(1 / self.expansion)}; it must not"
            )
        if self.lead and self.cushion == 1:
            raise ProblemError(
                f"with a lead of {about(self.lead)} the exhaust must be closed before steam enters, at"
                f" {about(1 - self.lead)} of the return stroke; add --cushion {about(100 * (1 - self.lead))}%"
            )
        if self.cushion + self.lead > 1:
            raise ProblemError(
                f"the exhaust closes at {about(self.cushion)} of the return stroke, behind the lead, with"
                f" which steam enters at {about(1 - self.lead)}; it must not"
            )
        left = self.lead + self.clearance
        if self.cushion < 1 and not left:
            raise ProblemError(
                "cushioning needs a clearance, in which steam is compressed; add --clearance 5%"
            )
        numbers = self.numbers(float)
        if (
            left
            and (
                most := numbers.back
                * float((1 - self.cushion + self.clearance) / left) ** float(numbers.exponent)
            )
            > 1
        ):
            raise ProblemError(
                f"by cushioning from {about(self.cushion)} of the return stroke the steam left would reach"
                f" {most:.4g} times the steam pressure; begin later, or give a larger clearance or lead"
            )

    def _check_work(self) -> None:
        if self.mean(floats()) > LEAST_WORK:
            return
        ratio = plain(self.expansion)
        limit = floor(1e6 * self.numbers(float).work(1.0)) / 1e6
        if self.back is None:
            raise ProblemError(
                f"expansion ratio ε = {ratio} at its best back pressure, that of the steam at the end of the"
                " stroke, leaves no work; give a lower one, for example --back 0"
            )
        raise ProblemError(
            f"back pressure b = {about(self.back)} leaves no work at ε = {ratio}; b must be below"
            f" {limit:g}, or the mean force P would not be above 0"
        )


def _law(ends: list[tuple[Numeric, Piece]]) -> Law:
    """Return the pieces with the shares at which they end; one that fills the stroke has no corner."""
    return Law(tuple(piece for _, piece in ends), tuple(end for end, _ in ends[:-1]))


def check_exponent(
    exponent: Fraction, what: str, rule: str = f"{ANY_EXPONENT} rises as the volume shrinks"
) -> None:
    """Raise ProblemError unless p V^n = const can have it."""
    check_bounds(what, exponent, rule)
    if 0 < abs(exponent - 1) < LEAST_CURVE:
        raise ProblemError(
            f"{what} is {about(exponent)}, nearer to 1 than 10^-6; write 1, Mariotte's law,"
            " whose results have the same six figures"
        )


def check_clearance(clearance: Fraction) -> None:
    """Raise ProblemError unless a cylinder can have it."""
    check_bounds("clearance", clearance, RULES["clearance"])
