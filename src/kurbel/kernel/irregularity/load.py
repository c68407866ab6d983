"""The forces of the double-acting engine over a stroke: cut-off, expansion, clearance, for arrays.

Forces are in units of the pressure of the steam at the end of the stroke, Q/ε for Mariotte's law without
clearance. The volume counts in units of that at the end of the stroke, 1 - κ₁ σ/2 at the path σ from the
outer dead centre, κ₁ = 1/(1 + κ).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from kurbel.kernel.circle import Number

TWO_OVER_PI = 0.6366197723675814


class Load(NamedTuple):
    """What acts on the piston of an engine."""

    expansion: Number
    """ε: the cut-off comes after the share 1/ε of the stroke."""
    back: Number
    net: Number
    """Steam less back pressure before the cut-off."""
    mean: Number
    """P, the mean tangential force."""
    forgone: Number
    """Half the work in a stroke that steam admitted to its end would do beyond this."""
    over: Number
    """u/(1 - u) at the share u from the end where the steam has expanded to the back pressure; 0 if never."""
    dead: Number = 0.0
    """1 - κ₁, the volume that is left at the inner dead centre."""
    swept: Number = 1.0
    """κ₁; on the return stroke, which begins at the outer dead centre, -κ₁ with 1 for `dead`."""
    bend: Number = 1.0
    """By how much slower than without clearance, by Mariotte's law, the pressure falls where it is b."""
    exponent: Number = None
    """n of p V^n = const, None for 1 everywhere."""

    @property
    def plain(self) -> bool:
        """Whether there is no clearance and the steam expands by Mariotte's law."""
        return self.exponent is None and isinstance(self.swept, float)


def load(expansion: Number, back: Number = None, clearance: Number = None, exponent: Number = None) -> Load:
    """Return the forces for ε, the back pressure b = R/Q, the clearance κ as a share of the stroke and n.

    None for b is the best one, for κ 0, for n 1. Source: Weisbach-Herrmann, § 150, P = (2/π)(1 + ln ε - εb)
    Q/ε; clearance and exponent re-derived.
    """
    if clearance is None and exponent is None:
        logarithm = np.log(expansion)
        forgone = (expansion - 1) - logarithm
        if back is None:
            return Load(expansion, 1.0, expansion - 1, TWO_OVER_PI * logarithm, forgone, 0.0)
        loss = expansion * back
        mean = TWO_OVER_PI * (logarithm + (1 - loss))
        return Load(expansion, loss, expansion * (1 - back), mean, forgone, np.maximum(loss - 1, 0))
    return _expanding(expansion, back, 0.0 if clearance is None else clearance, exponent)


def _expanding(expansion: Number, back: Number, clearance: Number, exponent: Number) -> Load:
    # The steam grows to 1 + growth times its volume at cut-off, the pressure falls from 1 + rise to 1.
    growth = (expansion - 1) / (1 + clearance * expansion)
    logarithm = np.log1p(growth)
    rise = growth if exponent is None else np.expm1(exponent * logarithm)
    gain = logarithm if exponent is None else exponent * risen(logarithm, exponent)
    whole = 1 + clearance
    swept, dead = 1 / whole, clearance / whole
    best, forgone = whole * gain - clearance * rise, whole * (rise - gain)
    # Nothing but b takes digits away: this is a sum of what vanishes where nothing expands.
    loss = 1.0 if back is None else (1 + rise) * back
    net = rise if back is None else (1 + rise) * (1 - back)
    mean = TWO_OVER_PI * (best + (1 - loss))
    above = np.maximum(loss, 1)
    share = whole * ((above - 1) / above if exponent is None else -np.expm1(-np.log(above) / exponent))
    over = share / (1 - share)
    bend = _bend(above, over, swept, exponent)
    return Load(expansion, loss, net, mean, forgone, over, dead, swept, bend, exponent)


def _bend(above: Number, over: Number, swept: Number, exponent: Number) -> Number:
    cube = ((1 + over) / above) ** 3
    if exponent is None:
        return cube / swept
    return cube * above ** (1 - 1 / exponent) / (exponent * swept)


def risen(logarithm: Number, exponent: Number) -> Number:
    """Return the work (V^(1-n) - 1)/(n - 1) for -ln V, which is this itself for n = 1."""
    curve = (exponent - 1) * logarithm
    straight = curve == 0
    return logarithm * np.where(straight, 1.0, np.expm1(curve) / np.where(straight, 1.0, curve))


def work_left(share: Number, load: Load) -> Number:
    """Return half the work of the expanding steam from a share, from the outer dead centre, to that end."""
    if load.plain:
        return -np.log1p(-share)
    logarithm = -np.log1p(-load.swept * share)
    if load.exponent is not None:
        logarithm = risen(logarithm, load.exponent)
    return logarithm / load.swept


def raised(volume: Number, whole: Number, exponent: Number) -> Number:
    """Return w (V/w)^n, which is V for Mariotte's law."""
    return volume if exponent is None else whole * (volume / whole) ** exponent


def curved(volume: Number, exponent: Number) -> Number:
    """Return n V, the volume itself for Mariotte's law."""
    return volume if exponent is None else exponent * volume
