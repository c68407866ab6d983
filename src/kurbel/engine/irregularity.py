"""The degree of irregularity δ for very many engines at once, block by block on all cores."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeAlias, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kurbel.engine.loads.ideal import LARGEST_EXPANSION, LEAST_CURVE
from kurbel.engine.loads.ideal import RULES as STEAM_RULES
from kurbel.errors import NotationError, ProblemError
from kurbel.exact.bulk import broadcast_shape, in_blocks
from kurbel.kernel.irregularity import METHODS, TWO_OVER_PI, engine, irregularity
from kurbel.kernel.loops import pays
from kurbel.reading.given import as_ratio_array, choose
from kurbel.reading.names import checks_keywords
from kurbel.reading.notation import bounds

Floats: TypeAlias = NDArray[np.float64]

# An engine takes NumPy as long as so many cells of a table of the motion.
CELLS = 12
# Of the work done and taken, in units of what is left: beyond it balls decide.
LARGEST_STRAIN = 1e9
# By what share a float can be off where all work is left, and by what for the rounding of its inputs.
UNITS, ROUNDED = 8e-15, 3e-16

# What each number must be.
RULES = {
    "eps": "be finite and 1 (no expansion) or more, for the cut-off comes after the share 1/ε of the stroke",
    "ratio": "be 0 (infinite rod) or more and below 1, or the rod is too short to pass the dead centre",
    **STEAM_RULES,
}


@overload
def compute_delta(
    eps: float,
    ratio: float | str,
    back: float | None = None,
    *,
    clearance: float | None = None,
    exponent: float | None = None,
    method: str = "exact",
    fast: bool | None = None,
) -> float: ...
@overload
def compute_delta(
    eps: ArrayLike,
    ratio: ArrayLike,
    back: ArrayLike | None = None,
    *,
    clearance: ArrayLike | None = None,
    exponent: ArrayLike | None = None,
    method: str = "exact",
    fast: bool | None = None,
) -> float | Floats: ...
@checks_keywords
def compute_delta(
    eps: ArrayLike,
    ratio: ArrayLike,
    back: ArrayLike | None = None,
    *,
    clearance: ArrayLike | None = None,
    exponent: ArrayLike | None = None,
    method: str = "exact",
    fast: bool | None = None,
) -> float | Floats:
    """Return the degree of irregularity δ of the double-acting steam engine with one crank.

    δ = (v_max - v_min)/v_1 over a whole turn, in units of P r/(m_1 v_1²). `eps` is the expansion ratio ε
    (cut-off after the path 2r/ε, then p V^n = const), `ratio` is R:L, also as text such as "1:5" or
    "1:4;1:5", `back` the back pressure b = R_b/Q, None the best one, that of the steam at the end of the
    stroke (1/ε), `clearance` κ as a share of the stroke, None for 0, `exponent` n, None for 1 (Mariotte's
    law). They broadcast: numbers alone give a float, arrays an array of the broadcast shape. `method` is
    "exact", "series" (first-order kinematics) or "weisbach" (first order, at the angles of his equations,
    which have neither clearance nor exponent).

    Bulk: on all cores, memory bounded by the output and a fixed block a core; by numba, where it is
    installed, once there is so much to do that this pays, with the same bits: `fast` True takes it at once,
    False never. Without clearance and exponent the relative error is at most 2e-15 (1 + εb/N) with
    N = 1 + ln ε - εb, and 2e-15 for the default b; with them it is at most
    4e-15 (S + b)/(S - b), S being the mean pressure of the steam over the stroke, in units of Q.
    Valid for ε >= 1, 0 <= R:L < 1, 0 <= b <= 1, 0 <= κ <= 10, 0 < n <= 10 and a mean force P above 0, which
    is (2/π)(N/ε) Q without clearance and exponent. Raises KurbelError.
    Source: Weisbach-Herrmann, § 150; clearance and exponent are ours.

    >>> compute_delta([2, 3], "1:5").round(6).tolist()
    [1.281865, 1.374452]
    """
    motion = METHODS[choose(method, METHODS, "method")]
    if np.asarray(ratio).dtype.kind == "U":
        ratio = as_ratio_array(ratio)
    further = {"back": back, "clearance": clearance, "exponent": exponent}
    asked = {"eps": eps, "ratio": ratio} | {name: one for name, one in further.items() if one is not None}
    given = {name: _checked(one, name) for name, one in asked.items()}
    if method == "weisbach" and (np.any(given.get("clearance", 0)) or np.any(given.get("exponent", 1) != 1)):
        raise ProblemError('method "weisbach" has neither clearance nor exponent; use exact or series')
    shape = broadcast_shape(given)
    out = np.empty(shape)
    rows = {name: _row(values, shape) for name, values in given.items()}
    by_numba = pays(f"δ {method}", CELLS * out.size, fast)

    def fill(block: slice) -> None:
        those = engine(**{name: row[block] for name, row in rows.items()})
        if not those.mean.min() > 0:
            first = _index(block.start + int((those.mean > 0).argmin()), shape)
            raise ProblemError(
                f"back{first} leaves no work: the mean force P would not be above 0; b must be below the mean"
                " pressure of the steam, (1 + ln ε)/ε without clearance, as its default is for ε above 1 only"
            )
        out.reshape(-1)[block] = irregularity(motion, those, by_numba)

    in_blocks(fill, out.size)
    return out if shape else float(out)


def enclosed_delta(given: Mapping[str, Any], method: str) -> tuple[Floats, Floats]:
    """Return δ of engines as `compute_delta` does, and by how much each may be off the δ of its exact inputs.

    `given` has an array of each input's floats or one for all, of ε an array, of `back` None for the best
    one. Both are no numbers where an input is not valid, or so little work is left that balls must decide.
    """
    eps, clearance, exponent = given["eps"], given["clearance"], given["exponent"]
    with np.errstate(all="ignore"):
        those = engine(**given)
        # The pressures of the steam and against it, added up, for what the first is above the second.
        strain = 1 + 2 * TWO_OVER_PI * those.back / those.mean
        stretch = exponent * np.log((1 + clearance) / (1 / eps + clearance))
        share = (UNITS + ROUNDED * stretch) * (1 + strain) + ROUNDED / (1 - given["ratio"])
    good = (those.mean > 0) & (strain < LARGEST_STRAIN) & (eps <= LARGEST_EXPANSION)
    good &= (exponent == 1) | (np.abs(exponent - 1) > float(2 * LEAST_CURVE))
    for name, one in given.items():
        good &= one is None or _within(one, name)
    found = np.full(len(good), np.nan)
    own: dict[str, Any] = {name: one[good] if np.ndim(one) else one for name, one in given.items()}
    found[good] = compute_delta(**own, method=method)
    return found, share * found


def _row(values: Floats, shape: tuple[int, ...]) -> Any:
    """Return what has slices of the values, broadcast to the shape and counted in one row."""
    spread = np.broadcast_to(values, shape)
    # A slice of the flat iterator is a copy of that slice alone.
    return spread.reshape(-1) if values.size == 1 or spread.flags.c_contiguous else spread.flat


def _checked(given: ArrayLike, name: str) -> Floats:
    """Return the numbers of this name if all lie between their limits."""
    try:
        values = np.asarray(given)
        if values.dtype.kind == "O":
            # astype would read None as NaN.
            values = np.asarray(np.frompyfunc(float, 1, 1)(values))
        elif values.dtype.kind not in "iuf":
            raise TypeError
        values = values.astype(np.float64, copy=False)
    except (TypeError, ValueError, OverflowError):
        raise NotationError(f"{name} must be a number or an array of numbers") from None
    # Extremes make no array. NaN, if there is one, is both of them, and no comparison holds.
    if values.size and not (_within(values.min(), name) and _within(values.max(), name)):
        first = int(_within(values, name).argmin())
        where, what = _index(first, values.shape), f"{values.flat[first]:.15g}"
        raise ProblemError(f"{name}{where} is {what}; it must {RULES[name]}")
    return values


def _within(values: Any, name: str) -> Any:
    """Return where the numbers of this name lie between their limits."""
    outside = [beyond(values, float(bound)) for beyond, bound in bounds(RULES[name])]
    return np.isfinite(values) & ~np.any(outside, axis=0)


def _index(position: int, shape: tuple[int, ...]) -> str:
    """Return the index of an element, as it is written behind the name of the array."""
    return str([*map(int, np.unravel_index(position, shape))]) if shape else ""
