"""Numbers that take the branches of a formula as a place within one of them takes them.

A formula with periods, as of steam before and beyond its cut-off, compares its argument with their ends. A
ball that reaches over an end gets both branches, and a slope that holds both tells nothing. Between two ends
all places take the same branch: one of them, the witness, decides for the number beside it, and the branch
goes on beyond its own ends.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from operator import add, mul, neg, sub, truediv
from typing import Any


@dataclass(frozen=True, slots=True)
class Branched:
    """A number of any kind and the witness that decides its comparisons, both run through one formula.

    The witness is a ball; where it overlaps what it is compared with, the comparison raises ArithmeticError.
    """

    number: Any
    witness: Any

    def __add__(self, other: Any) -> Branched:
        return self._with(add, other)

    def __radd__(self, other: Any) -> Branched:
        return _branched(other)._with(add, self)

    def __sub__(self, other: Any) -> Branched:
        return self._with(sub, other)

    def __rsub__(self, other: Any) -> Branched:
        return _branched(other)._with(sub, self)

    def __mul__(self, other: Any) -> Branched:
        return self._with(mul, other)

    def __rmul__(self, other: Any) -> Branched:
        return _branched(other)._with(mul, self)

    def __truediv__(self, other: Any) -> Branched:
        return self._with(truediv, other)

    def __rtruediv__(self, other: Any) -> Branched:
        return _branched(other)._with(truediv, self)

    def __neg__(self) -> Branched:
        return Branched(neg(self.number), neg(self.witness))

    def __pow__(self, exponent: Any) -> Branched:
        return Branched(self.number**exponent, self.witness**exponent)

    def __lt__(self, other: Any) -> bool:
        return self._below(other)

    def __le__(self, other: Any) -> bool:
        return self._below(other)

    def __gt__(self, other: Any) -> bool:
        return not self._below(other)

    def __ge__(self, other: Any) -> bool:
        return not self._below(other)

    def max(self, other: Any) -> Branched:
        """Return the one of which the witness is larger."""
        return _branched(other) if self._below(other) else self

    def min(self, other: Any) -> Branched:
        """Return the one of which the witness is smaller."""
        return self if self._below(other) else _branched(other)

    def union(self, other: Any) -> Branched:
        """Raise ArithmeticError: no branch holds what another one has beside it."""
        raise ArithmeticError("a branch is one of several, and never holds two")

    def rad(self) -> Any:
        """Return how near comparisons are decided, as of a ball."""
        return self.witness.rad()

    def _below(self, other: Any) -> bool:
        apart = self.witness - _branched(other).witness
        if apart.contains(0):
            raise ArithmeticError("the witness of a branch lies at its end")
        return bool(apart < 0)

    def _with(self, operation: Callable[[Any, Any], Any], other: Any) -> Branched:
        by = _branched(other)
        return Branched(operation(self.number, by.number), operation(self.witness, by.witness))


def _branched(number: Any) -> Branched:
    return number if isinstance(number, Branched) else Branched(number, number)
