"""The time against the square of the speed, enclosed with proof: Gauss's rule, and how far it can be off.

The speed itself has an integral in it, which flint's integration would have to take at every complex point.
The rule takes it at real points alone. Its error is at most 64 B ρ^(-2n)/(15 (1 - ρ^-2)) over -1..1, where B
bounds the integrand on the ellipse about ±1 with half axes of sum ρ; on a box around it B comes from balls.
Source: Trefethen, Approximation Theory and Approximation Practice, theorem 19.3.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

import flint
from flint import acb, arb

from kurbel.engine.speed.integral import Span
from kurbel.engine.speed.square import Decay
from kurbel.errors import ProblemError
from kurbel.exact.certify import ball
from kurbel.exact.continued import Continued
from kurbel.exact.roots import interval

# The sum of the half axes, and so many bits that a point of the rule gains, 2 log2 ρ.
AXES, GAIN = 4, 4
# Parts are halved until their ellipse is free of zeros and cuts.
MOST_HALVINGS = 12


class Part(NamedTuple):
    """A part of a span that one rule spans."""

    span: Span
    start: Fraction
    end: Fraction


class LaggingClock:
    """The time over a cycle of a solution, at the precision in force, in half turns at the speed √2."""

    def __init__(self, decay: Decay) -> None:
        self.decay, self.turn = decay, decay.turn
        self._known: dict[Part, arb] = {}
        self.parts = tuple(self._all_parts())

    def time(self, half_turns: Fraction) -> arb:
        """Return the time since the dead centre, which may lie in the gap before the first piece."""
        start, cycle = self.turn.pieces[0].start, self.turn.cycle
        before, rest = divmod(half_turns - start, cycle)
        last = self.parts[-1]
        begun = arb(0) if last.span.smooth else self._over(last).union(arb(0))
        time = begun + self._within(start + rest)
        return time + int(before) * self._within(start + cycle) if before else time

    def _within(self, place: Fraction) -> arb:
        total = arb(0)
        for part in self.parts:
            if part.start < place:
                total += self._over(part._replace(end=min(part.end, place)))
        return total

    def _over(self, part: Part) -> arb:
        if part not in self._known:
            self._known[part] = self._rule(part) if part.span.smooth else self._gap(part)
        return self._known[part]

    def _all_parts(self) -> Iterator[Part]:
        for span in self.decay.lagged.spans:
            if span.smooth:
                yield from self._halved(Part(span, span.start, span.end), MOST_HALVINGS)
            else:
                yield Part(span, span.start, span.end)

    def _halved(self, part: Part, halvings: int) -> Iterator[Part]:
        if self._bound(part).is_finite():
            yield part
            return
        if not halvings:
            raise ProblemError(
                "the time is not settled, for the speed nearly vanishes; give a heavier flywheel"
            )
        middle = (part.start + part.end) / 2
        yield from self._halved(part._replace(end=middle), halvings - 1)
        yield from self._halved(part._replace(start=middle), halvings - 1)

    def _bound(self, part: Part) -> arb:
        """A bound of 1/√h on a box around the ellipse; not finite where it may vanish or have a cut."""
        half = ball((part.end - part.start) / 2)
        long, short = (half * (AXES + sign * arb(1) / AXES) / 2 for sign in (1, -1))
        middle = (part.start + part.end) / 2
        away = acb(interval_of(long), interval_of(short))
        reference = float((part.span.start + part.span.end) / 2)
        place = Continued(acb(ball(middle)) + away, reference)
        slowness: acb = 1 / self.decay.continued(part.span.pieces[0], place, middle).sqrt(analytic=True)
        return slowness.abs_upper() if slowness.is_finite() else arb("nan")

    def _rule(self, part: Part) -> arb:
        """Gauss's rule with so many points that its error is below the precision."""
        points = flint.ctx.prec // GAIN + 4
        half, middle = ball((part.end - part.start) / 2), ball((part.start + part.end) / 2)
        (piece,), total = part.span.pieces, arb(0)
        for index in range(points):
            at, weight = arb.legendre_p_root(points, index, weight=True)
            total += weight / self.decay.level(piece, middle + half * at).sqrt()
        share = arb(AXES) ** (-2 * points)
        error = 64 * self._bound(part) * share / (15 * (1 - arb(AXES) ** -2))
        return half * (total + arb(0, error.upper()))

    def _gap(self, part: Part) -> arb:
        """The time over a gap."""
        over, cycle, width = interval(part.span.start, part.span.end), self.turn.cycle, part.end - part.start
        levels = [
            self.decay.level(piece, over - cycle * (piece.end < part.span.start))
            for piece in part.span.pieces
        ]
        whole = levels[0]
        for other in levels[1:]:
            whole = whole.union(other)
        found: arb = ball(width) / whole.sqrt()
        return found


def interval_of(half: arb) -> arb:
    """Return the ball from -half to half."""
    return arb(0, half.upper())
