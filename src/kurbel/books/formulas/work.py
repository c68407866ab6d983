"""How much work is done for a step from one formula to another: a source may ask for years of it."""

from __future__ import annotations

# In what a product of two terms costs, or an operation with balls: each about a second and half a one. The
# proofs of the books take 50,000 at the most, their points 30,000.
MOST_OF_PROOFS, MOST_AT_POINTS = 100_000, 500_000
# Bits of a coefficient for which a product costs as much again.
BITS_OF_PRODUCT = 500


class UnprovableError(ArithmeticError):
    """What is not within reach of these proofs."""


class Work:
    """The work that is left; what asks for more is not settled."""

    def __init__(self, left: float) -> None:
        self.left = left

    def spend(self, amount: float) -> None:
        """Count work that is about to be done. Raises UnprovableError where there is too much."""
        self.left -= amount
        if self.left < 0:
            raise UnprovableError("too much work")
