"""Arrays: kernel columns for very many places, block by block on all cores, and floats rounded."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from kurbel.errors import ProblemError
from kurbel.kernel.circle import circle
from kurbel.kernel.loops import chosen

Integers: TypeAlias = NDArray[np.int64]

# A block and its two or three dozen intermediate columns (13 to 18 MB a thread) stay in the last-level cache.
# Measured on two cores: with 16384 places threads wait for each other between calls (x, c and p 40 % slower,
# δ of a million engines 163 ms for 96 ms).
BLOCK = 65536

# Just below the largest size that glibc's malloc may keep for itself, 32 MiB.
LARGEST_KEPT = (1 << 25) - (1 << 16)

# 2**-53 is the rounding of a product, relative to it; a little more covers the rounding of the test itself.
PRODUCT_ERROR = 1.2e-16
LARGEST = 2.0**52


class AngleColumn(NamedTuple):
    """A column of the angle itself, in degrees, and not of its circle."""

    of: Callable[[NDArray[np.float64]], Any]


def broadcast_shape(given: Mapping[str, NDArray[Any]]) -> tuple[int, ...]:
    """Return the shape of all of them together. Raises ProblemError."""
    try:
        return np.broadcast_shapes(*(values.shape for values in given.values()))
    except ValueError:
        *names, last = given
        shapes = ", ".join(str(values.shape) for values in given.values())
        named = f"{', '.join(names)} and {last}"
        raise ProblemError(f"{named} have the shapes {shapes}; they do not broadcast") from None


# Loops of numba hold no intermediate columns; with blocks of 65536 threads wait for each other (8 % slower).
LONG_BLOCK = 1 << 18

Column = Callable[..., Any]


def evaluate(
    functions: Sequence[Column | AngleColumn],
    angles: NDArray[np.float64],
    *others: NDArray[np.float64],
    fast: bool | None = None,
    check: Callable[[NDArray[np.float64]], None] | None = None,
) -> NDArray[np.float64]:
    """Return one row a function, one column an angle in degrees: shape (len(functions), len(angles)).

    Each function maps the circle of a block of angles, and the same block of each of the others, or the
    angles, to an array (or to one number for all of them).
    `check` may refuse a block of angles, while it is at hand, by an exception.
    Besides them only a block a core is held in memory. The bits depend neither on the number of cores nor on
    `fast`: whether numba computes, where it is installed; None leaves that to `kernel/loops.py`.
    """
    out = np.empty((len(functions), len(angles)))
    formulas = [None if isinstance(one, AngleColumn) else one for one in functions]
    loop = chosen(formulas, len(others), out.size, fast)
    done = [] if loop is None else loop[1]
    if loop is not None:
        run, inputs = loop[0], [np.require(one, np.float64, ["C", "A"]) for one in (angles, *others)]
        arrays = [*inputs, *(out[row] for row in done)]

        def compiled(block: slice) -> None:
            if check is not None:
                check(angles[block])
            run(*(one[block] for one in arrays))

        in_blocks(compiled, len(angles), LONG_BLOCK)
    rows = [(one, out[row]) for row, one in enumerate(functions) if row not in done]
    if rows:

        def plain(block: slice) -> None:
            if check is not None:
                check(angles[block])
            _fill(rows, block, angles, others)

        in_blocks(plain, len(angles))
    return out


def _fill(
    rows: Sequence[tuple[Column | AngleColumn, NDArray[np.float64]]],
    block: slice,
    angles: NDArray[np.float64],
    others: Sequence[NDArray[np.float64]],
) -> None:
    point, more = None, [one[block] for one in others]
    for function, row in rows:
        if isinstance(function, AngleColumn):
            row[block] = function.of(angles[block])
        else:
            point = circle(angles[block]) if point is None else point
            row[block] = function(point, *more)


def in_blocks(fill: Callable[[slice], None], size: int, each: int = BLOCK) -> None:
    """Call the function with each block of so many places, on all cores; the first exception is raised."""
    # glibc returns an intermediate column to the system as soon as it is freed, and the next one is mapped
    # and cleared page by page: two thirds of the time. Having freed one large array, which is never
    # touched, it keeps what is smaller (mallopt(3), M_MMAP_THRESHOLD). Elsewhere this does nothing.
    np.empty(LARGEST_KEPT, np.uint8)
    blocks = [slice(start, start + each) for start in range(0, size, each)]
    workers = min(cores(), len(blocks))
    if workers < 2:
        for block in blocks:
            fill(block)
        return
    with ThreadPoolExecutor(workers) as pool:
        # The list asks for every result in order, so that the first exception is raised here.
        list(pool.map(fill, blocks))


def cores() -> int:
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def nearest(
    values: NDArray[np.float64],
    decimals: int,
    bound: float | NDArray[np.float64],
    half_even: bool = False,
) -> tuple[Integers, NDArray[np.bool_]]:
    """Return values * 10**decimals rounded to the nearest integer, and where that is doubtful.

    Every value lies within `bound` of the true one. Where the mask is False the integer is certainly the
    true value rounded; where it is True a rounding boundary lies within reach, and the integer is that of
    the float (half away from zero, or half to even). Beyond 2**52, where floats have no halves, and for
    infinities and NaN the integer is 0 and doubtful. decimals: 0 to 18.
    """
    scale = float(10**decimals)
    with np.errstate(over="ignore"):
        product = values * scale
    magnitude = np.abs(product)
    beyond = ~(magnitude < LARGEST)
    if beyond.any():
        product[beyond] = magnitude[beyond] = 0
    rounded = np.rint(product)
    # How far the half-integers are: exact, both numbers being multiples of the product's last place.
    distance = np.abs(product - rounded)
    np.subtract(0.5, distance, out=distance)
    magnitude *= PRODUCT_ERROR
    magnitude += np.multiply(bound, scale * (1 + 1e-15))
    doubtful = ~(distance > magnitude)
    doubtful |= beyond
    if not half_even:
        ties = np.flatnonzero(doubtful)
        ties = ties[distance.flat[ties] == 0]
        rounded.flat[ties] = product.flat[ties] + np.copysign(0.5, product.flat[ties])
    return rounded.astype(np.int64), doubtful
