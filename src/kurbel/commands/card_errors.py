"""How far an indicator card lets a number be off, computed a second time.

What every second point of the card gives, twice, is compared with what all points give: the number itself,
and the work of a stroke, which bounds what is off where a difference vanishes by chance. As many times as
twice the points have come nearer to the truth all points are nearer still; what does not come nearer is
noise, of which the error is twice that. The last place in which pressures are written comes on top.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from kurbel.errors import ProblemError
from kurbel.verify import Number, Turn, Value
from kurbel.verify.loads import Stroke
from kurbel.verify.numbers import largest, number
from kurbel.verify.zeros import Place

if TYPE_CHECKING:
    from kurbel.commands.recomputed import Row
    from kurbel.commands.second import SecondComputation
    from kurbel.engine.card.card import PistonCard

# Places of a stroke, and the most by which twice the points are nearer to the truth.
SAMPLES, MOST_GAIN = 720, 8
# A slope is taken over so many degrees on both sides.
BESIDE = Fraction(18, 100)
ROUNDED = Fraction(1, 10**12)


def error_of(second: SecondComputation, key: str, method: str, row: Row) -> Value:
    """Return how far a number of a turn may be off. Raises ProblemError for one that is none."""
    if key not in ("mean_force", "delta", *_ANGLES, *_OF_WORK):
        raise ProblemError(f"how far a card lets {key} be off is not computed a second time")
    turn, at = second.turn(method, row), second.place(row)
    stroke = row.get("stroke", "turn")

    def found() -> Number:
        halves = [second.turn(method, row, card=one) for one in second.card.halves()]
        step = Fraction(second.card.resolution) / Fraction(second.card.admission)
        best, *coarser = (one.value(key, at, stroke=stroke).recipe() for one in (turn, *halves))
        shown = largest([abs(best - one) for one in coarser])
        if key in _ANGLES:
            force = _root_mean_square(_between(second, second.card, Stroke.force)) + step
            away = [Place(_near(best, turn, stroke) + side * BESIDE) for side in (1, -1)]
            slope = (turn.known.force(away[0]) - turn.known.force(away[1])) / (2 * BESIDE)
            return largest([shown, 2 * force / abs(slope)])
        apart, gain = second.once(row, lambda: _gained(second), "gain of the card")
        cranks = len(turn.cranks)
        off: Number = number({"mean_force": 2}.get(key, 4) * cranks)
        if key == "delta":
            off = (4 + turn.known.delta() * Fraction(64, 100)) * cranks / abs(turn.known.mean)
        noisy = 1 if gain.low >= MOST_GAIN else 2
        whole: Number = largest([shown, off * apart]) * noisy / gain
        return whole + off * step / 2 + (abs(best) + 1) * ROUNDED

    return Value(found)


_ANGLES = ("alpha_min", "alpha_max")
_OF_WORK = ("v_min", "v_max", "tangential", "tangential_excess", "energy")


def _near(angle: Number, turn: Turn, stroke: str) -> Fraction:
    """The crank angle from the slide direction of one that counts from a dead centre."""
    known = turn.known.crank
    begin = known.inner + (known.lead if stroke == "return" else 0)
    return (angle + begin).middle


def _gained(second: SecondComputation) -> tuple[Number, Number]:
    """The greatest difference of the work of a stroke from that by half the points, and how many times
    greater that of half the points is."""
    before = [one for half in second.card.halves() for one in _between(second, half, Stroke.work)]
    apart = largest(_between(second, second.card, Stroke.work))
    gain = largest(before) / apart
    most = number(MOST_GAIN)
    return apart, most if gain.low >= MOST_GAIN else largest([gain, number(1)])


def _between(
    second: SecondComputation, card: PistonCard, of: Callable[[Stroke, Number], Number]
) -> list[Number]:
    """The differences over the strokes from those of half its points; strokes that are alike count once."""
    shares, own = [number(Fraction(k, SAMPLES)) for k in range(SAMPLES + 1)], second.measured(card)()
    values = {stroke: [of(stroke, share) for share in shares] for stroke in own}
    return [
        abs(value - of(coarse, share))
        for half in card.halves()
        for stroke, coarse in dict(zip(own, second.measured(half)(), strict=True)).items()
        for share, value in zip(shares, values[stroke], strict=True)
    ]


def _root_mean_square(found: Sequence[Number]) -> Number:
    total = sum((one * one for one in found), number(0))
    return (total / len(found)).root()
