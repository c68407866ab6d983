"""The piston force of an indicator card over the share of the stroke travelled, and its work.

Forces are in units of Q, the greatest p_forward of the card times the piston's area; work in units of Q times
the whole stroke. The share counts from the dead centre at which the stroke begins, 0 to 1.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from kurbel.engine.card import Card
from kurbel.engine.card_curve import Curve, curve
from kurbel.errors import ProblemError


class CardStroke(NamedTuple):
    """The pressures behind the piston and before it over the share of the stroke travelled, in units of Q."""

    behind: Curve
    before: Curve

    def force(self, share: Any) -> Any:
        """Return the net force in the direction of travel; share is a float or a float64 array."""
        return _at(self.behind.pressure, share) - _at(self.before.pressure, share)

    def work(self, share: Any) -> Any:
        """Return the work from the dead centre on, the exact integral of the force."""
        return _at(self.behind.area, share) - _at(self.before.area, share)


def card_strokes(
    card: Card, double_acting: bool, other_side: float | None = None, unit: float | None = None
) -> tuple[CardStroke, CardStroke]:
    """Return the outstroke and the return stroke of a piston whose cylinder end gave the card.

    Double-acting: both ends give this card, each from its own dead centre, so that the pressure before the
    piston is p_return at the position 1 - share; the strokes are alike. Single-acting: the other face has
    the pressure other_side in Pa throughout, which counts from the zero of the card. Piston rods and unequal
    ends are left out. `unit` in Pa stands in for the card's own greatest p_forward. Derived by us.
    """
    scale = card.admission if unit is None else unit
    driving = _scaled(card.positions, card.forward, scale)
    # The end that exhausts comes back: its positions run from 1 to 0.
    coming = tuple(1 - position for position in reversed(card.positions))
    exhausting = _scaled(coming, card.back[::-1], scale)
    if double_acting:
        both = CardStroke(driving, exhausting)
        return both, both
    if other_side is None:
        raise ProblemError(
            "a single-acting piston has a pressure on its other face, which the card does not tell;"
            " give it as --other-side, for example 1bar"
        )
    other = _scaled((0.0, 1.0), (other_side, other_side), scale)
    return CardStroke(driving, other), CardStroke(other, exhausting)


def _scaled(positions: tuple[float, ...], pressures: tuple[float, ...], scale: float) -> Curve:
    return curve(positions, [pressure / scale for pressure in pressures])


def _at(polynomial: Any, share: Any) -> Any:
    # x/2 may exceed 1 by rounding; outside the card the cubic would go on.
    if isinstance(share, (int, float)):
        return float(polynomial(min(max(share, 0.0), 1.0)))
    return polynomial(np.clip(share, 0.0, 1.0))
