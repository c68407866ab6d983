"""The degree of irregularity δ for very many engines at once, block by block on all cores."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import inf
from typing import Any, TypeAlias, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kurbel.errors import NotationError, ProblemError
from kurbel.exact.bulk import in_blocks
from kurbel.kernel.half_tangent import load
from kurbel.kernel.irregularity import METHODS
from kurbel.reading import notation
from kurbel.reading.given import choose

Floats: TypeAlias = NDArray[np.float64]
Reader: TypeAlias = Callable[[slice], Any]

# Of each the least value, the bound that it does not reach, and why.
LIMITS: Mapping[str, tuple[float, float, str]] = {
    "eps": (
        1, inf,
        "it must be finite and 1 (no expansion) or more, for the cut-off comes after the share 1/ε of the"
        " stroke",
    ),
    "ratio": (
        0, 1,
        "it must be 0 (infinite rod) or more and below 1, or the rod is too short to pass the dead centre",
    ),
    "back": (
        0, 1.0000000000000002,
        "it must lie within 0..1, for it is a share of the steam pressure before cut-off",
    ),
}  # fmt: skip


@overload
def delta(eps: float, ratio: float | str, back: float | None = None, *, method: str = "exact") -> float: ...
@overload
def delta(
    eps: ArrayLike, ratio: ArrayLike, back: ArrayLike | None = None, *, method: str = "exact"
) -> float | Floats: ...
def delta(
    eps: ArrayLike, ratio: ArrayLike, back: ArrayLike | None = None, *, method: str = "exact"
) -> float | Floats:
    """Return the degree of irregularity δ of the double-acting steam engine with one crank.

    δ = (v_max - v_min)/v_1 over a whole turn, in units of P r/(m_1 v_1²). `eps` is the expansion ratio ε
    (cut-off after the path 2r/ε, then Mariotte's law), `ratio` is R:L, one value also as text such as
    "1:5", and `back` the back pressure b = R_b/Q, None the best one, 1/ε. They broadcast: numbers alone
    give a float, arrays an array of the broadcast shape. `method` is "exact", "series" (first-order
    kinematics) or "weisbach" (first order, at the angles of his equations).

    Bulk: NumPy on all cores, memory bounded by the output and a fixed block a core. The relative error is
    at most 2e-15 (1 + εb/N) with N = 1 + ln ε - εb, and 2e-15 for the default b, up to ε = 10^12.
    Valid for ε >= 1, 0 <= R:L < 1, 0 <= b <= 1 and N > 0, for P is (2/π)(N/ε) Q. Raises KurbelError.
    Source: Weisbach-Herrmann, § 150.

    >>> delta([2, 3], "1:5").round(6).tolist()
    [1.281865, 1.374452]
    """
    formula = METHODS[choose(method, METHODS, "method")]
    given = [_checked(eps, "eps")]
    given += [_checked(float(notation.ratio(ratio)) if isinstance(ratio, str) else ratio, "ratio")]
    given += [] if back is None else [_checked(back, "back")]
    try:
        shape = np.broadcast_shapes(*(values.shape for values in given))
    except ValueError:
        shapes = ", ".join(str(values.shape) for values in given)
        raise ProblemError(f"eps, ratio and back have the shapes {shapes}; they do not broadcast") from None
    out = np.empty(shape)
    readers = [_reader(values, shape) for values in given]

    def fill(block: slice) -> None:
        expansion, crank, *backs = (read(block) for read in readers)
        forces = load(expansion, *backs)
        _check_mean(forces.mean, block.start, shape)
        out.reshape(-1)[block] = formula(crank, forces)

    in_blocks(fill, out.size)
    return out if shape else float(out)


def _reader(values: Floats, shape: tuple[int, ...]) -> Reader:
    """Return what gives a slice of the values, broadcast to the shape and counted in one row."""
    if values.size == 1:
        return lambda block: values.reshape(1)
    if values.shape == shape and values.flags.c_contiguous:
        return values.reshape(-1).__getitem__
    # A slice of the flat iterator is a copy of that slice alone.
    spread = np.broadcast_to(values, shape)
    return lambda block: spread.flat[block]


def _numbers(given: ArrayLike, name: str) -> Floats:
    try:
        values = np.asarray(given)
        if values.dtype.kind == "O":
            # astype would read None as NaN.
            values = np.asarray(np.frompyfunc(float, 1, 1)(values))
        elif values.dtype.kind not in "iuf":
            raise TypeError
        return values.astype(np.float64, copy=False)
    except (TypeError, ValueError, OverflowError):
        raise NotationError(f"{name} must be a number or an array of numbers") from None


def _checked(given: ArrayLike, name: str) -> Floats:
    """Return the numbers of this name if all lie between their limits."""
    values = _numbers(given, name)
    least, below, why = LIMITS[name]
    # Extremes make no array. NaN, if there is one, is both of them, and no comparison holds.
    if values.size and not (values.min() >= least and values.max() < below):
        first = int(((values >= least) & (values < below)).argmin())
        raise ProblemError(f"{name}{_index(first, values.shape)} is {values.flat[first]:.15g}; {why}")
    return values


def _check_mean(mean: Floats, start: int, shape: tuple[int, ...]) -> None:
    if mean.min() > 0:
        return
    # Where nothing but one-element arrays was given, all of the block is computed once.
    first = _index(start + int((mean > 0).argmin()), shape)
    raise ProblemError(
        f"back{first} leaves no work: the mean force P would not be above 0; b must be below (1 + ln ε)/ε,"
        " as its default 1/ε is for ε above 1 only"
    )


def _index(position: int, shape: tuple[int, ...]) -> str:
    """Return the index of an element, as it is written behind the name of the array."""
    return f"[{', '.join(str(one) for one in np.unravel_index(position, shape))}]" if shape else ""
