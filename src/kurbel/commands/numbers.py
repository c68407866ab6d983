"""Certified digits and arrays of floats, without a page."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from decimal import Context, Decimal
from fractions import Fraction
from typing import TYPE_CHECKING

from kurbel.commands.part import Values
from kurbel.commands.parts.drive import Series
from kurbel.drive.crank import LARGEST_ANGLE, Crank, check_angles
from kurbel.errors import ChoiceError, NotationError, ProblemError
from kurbel.motion.evaluation import METHODS
from kurbel.motion.evaluation import certified as scaled
from kurbel.motion.motion_quantities import registry
from kurbel.page.quantity import Quantity, bare
from kurbel.page.subject import check_rounding
from kurbel.reading import notation
from kurbel.reading.given import (
    Exact,
    allowed_name,
    as_angle,
    as_fraction,
    as_names,
    as_ratio,
    as_ratio_array,
)
from kurbel.reading.names import checks_keywords

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


@checks_keywords
def certified(
    quantity: str,
    ratio: Exact,
    angle: Exact,
    *,
    digits: int | None = None,
    method: str = "exact",
    order: int | None = None,
    offset: Exact = 0,
    rounding: str = "half-away",
) -> Decimal:
    """Return one value, correctly rounded to so many decimals.

    `quantity` is a key such as "x", "c_return", "psi" (units of R, v, v²/R; degrees); `ratio` is R:L and
    `angle` the crank angle in degrees from the inner dead centre, on the return stroke from the outer
    one; `offset` is e/R. Valid for 0 <= R:L < 1 and |e| < L - R. Raises KurbelError for anything else.
    Source: Rötscher, eq. (285), of the exact motion; Blau, eqs. (22), (25) and (26), of x, c and p by series.

    >>> certified("c", "1:4,5", "22°30'", digits=6)
    Decimal('0.461536')
    """
    chosen = _quantity(quantity)
    check_rounding(digits, rounding)
    method = _method(method, order)
    decimals = bare(chosen, method, chosen.decimals).places if digits is None else digits
    crank, at = Crank(as_ratio(ratio), as_fraction(offset)), as_angle(angle)
    check_angles((at,))
    number = scaled(chosen, method, crank, at, decimals, rounding)
    return Decimal(number).scaleb(-decimals, context=Context(prec=max(50, len(str(number)))))


@checks_keywords
def compute(
    angles: ArrayLike,
    ratio: Exact | ArrayLike | None = None,
    columns: str | Sequence[str] = ("x", "c", "p"),
    *,
    method: str = "exact",
    order: int | None = None,
    offset: Exact = 0,
    **given: object,
) -> dict[str, NDArray[np.float64]]:
    """Return each quantity as an array of floats; `angles`, in degrees, and `ratio` broadcast.

    A ratio is a number or text, and several are a list, an array, or one text, "1:4;1:5".

    `columns` are keys of `kurbel quantities` that are of a crank angle, and `given` the options of `table`,
    `forces`, `inertia` or `turning` that they need: lengths, speed, force, masses, another
    mechanism, steam and other loads, torques, or the file of a `machine`. Units are those of the columns;
    angles beyond a turn go on.

    Bulk: NumPy on all cores, memory bounded by the output and a fixed block a core; with the extra `fast`
    numba once that pays, to the same bits. For the straight
    crank x, c and ψ are at most 2 units in the last place from the true value up to R:L = 1:3, and p at
    most 2 units of max(|p|, 1); `kurbel.kernel.kinematics` states the bounds beyond. At a dead centre, where
    a load changes sides, a value is that of the stroke that begins. Raises KurbelError.
    Sources of x, c, p and ψ are those of `certified`; other columns have theirs in `kurbel.kernel`.

    >>> compute([0, 90, 180], "1:5")["p"].tolist()
    [1.2, -0.20412414523193154, -0.8]
    >>> compute([[0], [90], [180]], "1:4;1:5", "p")["p"].round(3).tolist()
    [[1.25, 1.2], [-0.258, -0.204], [-0.75, -0.8]]
    >>> compute([30, 60], "1:4", "torque_nm", stroke="600mm", force="10kN")["torque_nm"].round(1).tolist()
    [1827.3, 2930.7]
    >>> compute([30, 60], "1:5", "tangential", eps=4)["tangential"].round(4).tolist()
    [0.4403, 0.5902]
    """
    import numpy as np

    from kurbel.exact.bulk import broadcast_shape

    degrees, keys = _degrees(angles), as_names(columns)
    ratios = np.asarray(None) if ratio is None else as_ratio_array(ratio)
    shape = broadcast_shape({"angles": degrees, "ratio": ratios})
    named, method = method, _method(method, order)
    is_plain = not given and all(map(_is_plain, keys))

    def rows(one: Fraction | None, at: NDArray[np.float64]) -> Iterable[NDArray[np.float64]]:
        if is_plain:
            return _of_motion(keys, at, one, method, offset)
        from kurbel.commands.arrays import arrays

        _check_degrees(at)
        told = {
            "ratio": one,
            "offset": offset or None,
            "method": None if named == "exact" else named,
            "order": order,
        }
        return arrays(keys, at, {**{name: one for name, one in told.items() if one is not None}, **given})

    if ratios.size == 1:
        found = [row.reshape(shape) for row in rows(ratios.item(), degrees.ravel())]
    else:
        degrees, found = np.broadcast_to(degrees, shape).ravel(), [np.empty(shape) for _ in keys]
        for one, where in _places(ratios, shape):
            for out, row in zip(found, rows(one, degrees[where]), strict=True):
                out.reshape(-1)[where] = row
    return dict(zip(keys, found, strict=True))


def _places(
    ratios: NDArray[np.object_], shape: tuple[int, ...]
) -> Iterator[tuple[Fraction, NDArray[np.intp]]]:
    """Return each ratio with its places among those of the broadcast shape, counted in one row."""
    import numpy as np

    distinct, index = np.unique(ratios, return_inverse=True)
    index = np.broadcast_to(index.reshape(ratios.shape), shape).ravel()
    order = np.argsort(index, kind="stable")
    bounds = np.searchsorted(index[order], np.arange(1, len(distinct)))
    return zip(distinct.tolist(), np.split(order, bounds), strict=False)


def _of_motion(
    keys: Sequence[str], degrees: NDArray[np.float64], ratio: Fraction | None, method: str, offset: Exact
) -> NDArray[np.float64]:
    from kurbel.exact.bulk import evaluate
    from kurbel.motion.bulk import on_floats

    if ratio is None:
        raise ProblemError("compute needs the crank ratio; write it as 1:5")
    crank = Crank(ratio, as_fraction(offset))
    functions = [on_floats(bare(_quantity(key), method, 0), crank) for key in keys]
    return evaluate(functions, degrees, check=_check_degrees)


def _method(method: str, order: int | None) -> str:
    named = allowed_name(method, METHODS, "method")
    return Series(Values({"method": named, "order": order}, {})).series() or named


def _quantity(key: str) -> Quantity:
    known = [name for name, quantity in registry().items() if not quantity.needs]
    return registry()[allowed_name(key, known, "quantity")]


def _is_plain(key: str) -> bool:
    """Whether a column, by any word for it, says something of a crank of which only the ratio is known."""
    try:
        return key is None or bool(_quantity(key))
    except ChoiceError:
        return False


def _degrees(angles: ArrayLike) -> NDArray[np.float64]:
    import numpy as np

    if isinstance(angles, str):
        angles = [float(angle) for angle in notation.angles([angles])]
    try:
        if np.iscomplexobj(angles):
            raise TypeError
        degrees = np.asarray(angles, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        raise NotationError("angles must be numbers of degrees, or text such as 0..180:10") from None
    return degrees


def _check_degrees(degrees: NDArray[np.float64]) -> None:
    # Both extremes are NaN where one of the angles is.
    if degrees.size and not (degrees.min() >= -LARGEST_ANGLE and degrees.max() <= LARGEST_ANGLE):
        raise ProblemError(f"angles must be finite and within {LARGEST_ANGLE}° of zero")
