"""Forces of steam, compressors, pumps and gas cycles over the stroke, from kurbel's options for them.

They are the textbooks' diagrams: a net force on the piston in its direction of travel, over the share of the
stroke that is gone, in units of Q.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any, NamedTuple, TypeAlias

import numpy as np

# NumPy's operators lose the types of arrays.
Grid: TypeAlias = Any
Force = Callable[[Grid], Grid]
Options = Mapping[str, Any]
UNITS = {
    "mm": 1e-3, "cm": 1e-2, "m": 1.0, "bar": 1e5, "MPa": 1e6, "kPa": 1e3, "Pa": 1.0, "kg": 1.0, "t": 1e3,
    "kN": 1e3, "N": 1.0, "rad/s": 1.0, "/min": math.tau / 60, "/s": math.tau, "%": 1e-2, "kgm2": 1.0, "": 1.0,
}  # fmt: skip


class Stroke(NamedTuple):
    """A net force in Q over the share of the stroke, and the shares at which it has a corner."""

    force: Force
    corners: tuple[float, ...] = ()


def number(value: Any, otherwise: float = 0.0) -> float:
    """Return what is typed, 8bar, 3/10 or 5%, in SI units; None is something else."""
    if value is None:
        return otherwise
    found = re.fullmatch(r"([-+\d.e/]*\d)\s*(.*)", str(value))
    if not found:
        return float(value)
    return float(Fraction(found[1])) * UNITS[found[2]]


def strokes(options: Options) -> tuple[Stroke, ...]:
    """Return the strokes of a cycle, of a turn or two, under the load that the options describe."""
    double = not options.get("single_acting")
    if "pressure_ratio" in options:
        return _compressor(options, double)
    if "pump" in options:
        return _pump(options)
    if "compression" in options:
        return _gas(options)
    return _steam(options, double)


def pressure_of(options: Options) -> float:
    """Return the pressure in Pa that Q is of."""
    if "pump" in options:
        low, high = (number(options.get(f"{side}_pressure")) for side in ("suction", "delivery"))
        return high - low
    return number(options.get("pressure", options.get("suction_pressure", "1bar")))


def _steam(options: Options, double: bool) -> tuple[Stroke, ...]:
    """Full pressure up to the cut-off, then p V^n = const; on areas that rods leave, less the friction."""
    cut_off, clearance = 1 / number(options["eps"]), number(options.get("clearance"))
    exponent = number(options.get("exponent"), 1.0)
    best = ((cut_off + clearance) / (1 + clearance)) ** exponent
    back, bore = number(options.get("back"), best), number(options.get("bore"), 1.0)
    head, crank = (1 - (number(options.get(rod)) / bore) ** 2 for rod in ("tail_rod", "piston_rod"))
    rubbed = 0.0
    if "friction" in options:
        rubbed = number(options["friction"]) / (math.pi / 4 * bore**2 * pressure_of(options))

    def acting(share: Grid, area: float, other: float) -> Grid:
        full = (cut_off + clearance) / (np.maximum(share, cut_off) + clearance)
        return area * full**exponent - other * back - rubbed

    corners = (cut_off,)
    out = Stroke(lambda share: acting(share, head, crank), corners)
    idle = Stroke(lambda share: np.full_like(share, -rubbed))
    return out, Stroke(lambda share: acting(share, crank, head), corners) if double else idle


def _compressor(options: Options, double: bool) -> tuple[Stroke, ...]:
    """Expansion of what is left, suction; compression, delivery."""
    exponent, clearance = number(options.get("exponent"), 1.0), number(options.get("clearance"))
    low = 1 - number(options.get("suction_loss"))
    high = number(options["pressure_ratio"]) * (1 + number(options.get("delivery_loss")))
    other = number(options.get("other_side"), 1.0)
    if "other_side" in options:
        other /= pressure_of(options)
    left = number(options.get("expansion_exponent"), exponent)
    grown, whole = (high / low) ** (1 / exponent), 1 + clearance
    corners = (clearance * ((high / low) ** (1 / left) - 1), whole - whole / grown)

    def leaving(share: Grid) -> Grid:
        if not clearance:
            return np.full_like(share, low)
        return np.maximum(low, high * (clearance / (clearance + share)) ** left)

    def coming(share: Grid) -> Grid:
        with np.errstate(divide="ignore"):
            return np.minimum(high, low * (whole / (whole - share)) ** exponent)

    if double:
        return (Stroke(lambda share: leaving(share) - coming(share), corners),) * 2
    return Stroke(lambda share: leaving(share) - other, corners), Stroke(
        lambda share: other - coming(share), corners
    )


def _pump(options: Options) -> tuple[Stroke, ...]:
    """Suction and delivery on both faces, in the pressure between both."""
    kind = options["pump"]
    low = number(options.get("suction_pressure"))
    suction = low / pressure_of(options) if kind != "double" and "delivery_pressure" in options else 0.0
    other = number(options.get("small_area"), 0.5) * (suction + 1) if kind == "differential" else 0.0
    if kind in ("double", True):
        return (Stroke(lambda share: np.full_like(share, -1)),) * 2
    return Stroke(lambda share: np.full_like(share, suction - other)), Stroke(
        lambda share: np.full_like(share, other - suction - 1)
    )


def _gas(options: Options) -> tuple[Stroke, ...]:
    """Expansion, exhaust, suction and compression; of two strokes the first and the last."""
    compression, exponent = number(options["compression"]), number(options.get("exponent"), 1.4)
    grown = number(options.get("expansion_exponent"), exponent)
    clearance, whole = 1 / (compression - 1), compression / (compression - 1)
    squeezed = compression**exponent
    peak, burnt = number(options.get("peak_pressure"), squeezed), number(options.get("cut_off"), 1.0)
    if "heat" in options:
        # Heat at one volume first, the whole of it in an Otto cycle; the rest at the peak pressure.
        heat = number(options["heat"]) * whole * (exponent - 1)
        if options.get("cycle", "otto") == "otto":
            peak = squeezed + heat / clearance
        burnt = 1 + (heat / clearance - peak + squeezed) / (exponent * peak)
    volume, exhaust = clearance * burnt, number(options.get("exhaust_pressure"), 1.0)

    def expansion(share: Grid) -> Grid:
        return peak * (volume / np.maximum(clearance + share, volume)) ** grown - 1

    def compressed(share: Grid) -> Grid:
        return 1 - (whole / (whole - share)) ** exponent

    first, last = Stroke(expansion, (volume - clearance,)), Stroke(compressed)
    if options.get("two_stroke"):
        return first, last
    return first, Stroke(lambda share: np.full_like(share, 1 - exhaust)), Stroke(np.zeros_like), last
