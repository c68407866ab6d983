"""Steam by its ideal card: cut-off, expansion, back pressure; bounds that other loads have, too."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from math import floor
from typing import Any, ClassVar

from kurbel.drive.load import STEAM
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind
from kurbel.kernel.steam import Expansion, IdleStroke, best_back
from kurbel.kernel.turning import Stroke
from kurbel.reading.notation import about, plain, too_small

LARGEST_EXPANSION = 10**6
LARGEST_EXPONENT = 10
LARGEST_CLEARANCE = 10
# The work of the expansion is a quotient by n - 1.
LEAST_CURVE = Fraction(1, 10**6)
# Below this share of Q no mean force drives anything, and δ, counted in it, grows beyond all bounds.
LEAST_WORK = 1e-9


@dataclass(frozen=True, slots=True)
class Steam:
    """Expansion ratio ε (cut-off after the share 1/ε of the stroke), back pressure b = R/Q, exponent n of
    p V^n = const, clearance as a share of the stroke.

    `back` None is the best back pressure, that of the steam at the end of the stroke: 1/ε for n = 1 without
    clearance. Valid for ε >= 1, 0 <= b <= 1, n > 0, κ >= 0, as long as work is left.
    """

    name: ClassVar[str] = STEAM
    driven: ClassVar[bool] = False

    expansion: Fraction
    back: Fraction | None = None
    exponent: Fraction = Fraction(1)
    clearance: Fraction = Fraction(0)

    def strokes(self, kind: Kind, double: bool) -> tuple[Stroke, Stroke]:
        """Return the force of both strokes, on a kind of number; single-acting, the return idles."""
        acting: Stroke = self.numbers(kind.of, kind.exponent)
        return acting, acting if double else IdleStroke()

    def __post_init__(self) -> None:
        if self.expansion < 1:
            raise ProblemError(too_small(self.expansion))
        if self.expansion > LARGEST_EXPANSION:
            raise ProblemError(
                f"expansion ratio ε is {about(self.expansion)}; at most {LARGEST_EXPANSION} is allowed"
            )
        if self.back is not None and not 0 <= self.back <= 1:
            raise ProblemError(
                f"back pressure b is {about(self.back)}; it must lie within 0..1,"
                " for it is a share of the steam pressure before cut-off"
            )
        check_exponent(self.exponent, "exponent n", "falls as the steam expands")
        check_clearance(self.clearance)
        self._check_work()

    def numbers(
        self, of: Callable[[Fraction], Any], exponent_of: Callable[[Fraction], Any] | None = None
    ) -> Expansion:
        """Return the same in a kind of number, which may want its exponents in another."""
        cut_off, clearance = of(1 / self.expansion), of(self.clearance)
        exponent = (exponent_of or of)(self.exponent)
        back = best_back(cut_off, exponent, clearance) if self.back is None else of(self.back)
        return Expansion(cut_off, back, exponent, clearance)

    def mean(self, kind: Kind, **found: Any) -> Any:
        """Return the mean pressure on an end that works, with `found` numbers in the place of some."""
        known = self.numbers(kind.of, kind.exponent)._replace(**found)
        if self.back is None:
            known = known._replace(back=best_back(known.cut_off, known.exponent, known.clearance))
        return known.whole()

    def _check_work(self) -> None:
        acting = self.numbers(float)
        if acting.work(1.0) > LEAST_WORK:
            return
        ratio = plain(self.expansion)
        limit = floor(1e6 * acting._replace(back=0.0).work(1.0)) / 1e6
        if self.back is None:
            raise ProblemError(
                f"expansion ratio ε = {ratio} at its best back pressure, that of the steam at the end of the"
                " stroke, leaves no work; give a lower one, for example --back 0"
            )
        raise ProblemError(
            f"back pressure b = {about(self.back)} leaves no work at ε = {ratio}; b must be below"
            f" {limit:g}, or the mean force P would not be above 0"
        )


def check_exponent(exponent: Fraction, what: str, how: str = "rises as the volume shrinks") -> None:
    """Raise ProblemError unless p V^n = const can have it."""
    if not 0 < exponent <= LARGEST_EXPONENT:
        raise ProblemError(
            f"{what} is {about(exponent)}; it must be above 0 and at most {LARGEST_EXPONENT},"
            f" for the pressure {how}"
        )
    if 0 < abs(exponent - 1) < LEAST_CURVE:
        raise ProblemError(
            f"{what} is {about(exponent)}, nearer to 1 than 10^-6; write 1, Mariotte's law,"
            " whose results have the same six figures"
        )


def check_clearance(clearance: Fraction) -> None:
    """Raise ProblemError unless a cylinder can have it."""
    if not 0 <= clearance <= LARGEST_CLEARANCE:
        raise ProblemError(
            f"clearance is {about(clearance)}; it must lie within 0..{LARGEST_CLEARANCE},"
            " for it is a share of the volume swept in a stroke"
        )
