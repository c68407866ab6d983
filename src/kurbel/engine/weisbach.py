"""A turn of the engine with the angles of Weisbach's own relations."""

from __future__ import annotations

from functools import partial

import flint

from kurbel.engine.cylinder import SIGNS
from kurbel.engine.turn import Extremum, Piece, Turn, circle, stationary
from kurbel.exact.certify import at_bits, ball
from kurbel.exact.search import EQUAL_BITS
from kurbel.kernel import steam
from kurbel.kernel.circle import Number


class WeisbachTurn(Turn):
    """A turn with the angles of Weisbach's own relations, for Mariotte's law and one double-acting crank.

    α₁ is the first zero of the first-order excess, as sin α₁ = P/(Q - R) ± ½λ sin 2α₁ says; α₂ comes from
    cot(α₂/2), or where the speed turns before the cut-off from the second zero. Where it turns shortly after
    the cut-off, his simplified cot(α₂/2) may place α₂ shortly before. Source: § 150.
    """

    def _stationary(self, piece: Piece) -> list[Extremum]:
        zeros = super()._stationary(piece)
        if not self._turns_beyond_cut_off(piece):
            return zeros
        relation, slope = partial(self._relation, piece, 0), partial(self._relation, piece, 1)
        return [zeros[0], *stationary(piece, relation, slope)]

    @property
    def expands_first(self) -> bool:
        """Whether on both strokes the speed is greatest beyond the cut-off, where his cot(α₂/2) holds."""
        return all(map(self._turns_beyond_cut_off, self.pieces))

    def _turns_beyond_cut_off(self, piece: Piece) -> bool:
        (_, stroke, begun) = piece.strokes[0]
        with at_bits(EQUAL_BITS):
            return bool(self.excess(piece, self.cut_off(stroke) + ball(begun)) > 0)

    def _relation(self, piece: Piece, part: int, at: Number) -> Number:
        """His equation for α₂ as a function with that zero, or its slope over the half turns."""
        (_, stroke, begun) = piece.strokes[0]
        angle = at - ball(begun)
        acting = self.part.ideal.numbers(ball)
        loss = acting.back / acting.cut_off
        work = acting.work(flint.arb(1)) / acting.cut_off
        ratio = ball(SIGNS[stroke] * self.engine.crank.ratio)
        half = (angle / 2).sin_cos_pi()
        relation = steam.weisbach_maximum(half, circle(angle), ratio, loss, work, flint.arb.pi())
        return relation[part] * (flint.arb.pi() if part else 1)
