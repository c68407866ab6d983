"""Free forces in newtons and moments in newton metres: what mass, radius, speed and spacing make of them.

Along its slide a rod is exactly two masses at its pins that keep its centre of mass (Ensslin): to and fro
goes the share at the crosshead pin, and that at the crank pin turns.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from kurbel.balance.arrangement import Factor
from kurbel.drive.crank import Crank, known
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Label
from kurbel.motion.captions import moving_notes
from kurbel.page.quantity import Words, words
from kurbel.reading.amounts import amount
from kurbel.reading.notation import about

IN_NEWTONS = "_n"
WORDS: Mapping[str, Words] = {
    "rod": words(
        " mit dem Teil der Schubstange am Kreuzkopfzapfen| with the rod's share at the crosshead pin"
    ),
}


@dataclass(frozen=True, slots=True)
class Weighed:
    """The crank of each cylinder with its masses, its radius and the speed; `spacing` is the unit of length
    of the positions in metres, None where it is not known."""

    crank: Crank
    spacing: Fraction | None = None

    def __post_init__(self) -> None:
        if self.spacing is not None and self.spacing <= 0:
            raise ProblemError(
                f"the spacing of the cranks is {about(self.spacing)} m; it must be above 0, for it is the"
                " unit of the positions"
            )
        if not self.mass:
            raise ProblemError(
                "no mass goes to and fro; add that of piston and crosshead, --reciprocating 300kg"
            )

    @property
    def mass(self) -> Fraction:
        """m in kg, what goes to and fro in a cylinder."""
        return Fraction(known(self.crank.moving).joined.crosshead)

    def knows(self, residual: str) -> bool:
        """Whether the unit of this residual is known."""
        return residual == "force" or self.spacing is not None

    def times(self, factor: Factor, residual: str) -> Factor:
        """Return a factor in units of m R ω² in newtons, for a moment in newton metres."""
        arm = Fraction(1) if residual == "force" else known(self.spacing)
        exact = self.mass * arm
        if isinstance(factor, Fraction) and not known(self.crank.speed).turns:
            return factor * exact * known(self.crank.radius) * known(self.crank.speed).value ** 2

        def on_balls(kind: Kind) -> Any:
            own = kind.of(factor) if isinstance(factor, Fraction) else factor(kind)
            return own * kind.of(exact) * self.crank.pin_acceleration(kind)

        return on_balls

    def notes(self, ratio_symbol: str, lang: str) -> Iterator[Label]:
        """Yield the lines about masses, size and speed."""
        yield from moving_notes(self.crank, ratio_symbol, lang)
        rod = WORDS["rod"][lang] if known(self.crank.moving).rod is not None else ""
        spacing = "" if self.spacing is None else f", $a = {amount(self.spacing, 'mm')}$"
        yield f"$m = {amount(self.mass, 'kg')}${rod}{spacing}"
