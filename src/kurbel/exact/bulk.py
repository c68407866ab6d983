"""Kernel columns for very many angles, or engines, block by block on all cores."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kurbel.kernel.circle import Circle, circle

# A block and its two or three dozen intermediate columns (13 to 18 MB a thread) stay in the last-level cache.
# Measured on two cores: with 16384 places threads wait for each other between calls (x, c and p 40 % slower,
# δ of a million engines 163 ms for 96 ms).
BLOCK = 65536

# Just below the largest size that glibc's malloc may keep for itself, 32 MiB.
LARGEST_KEPT = (1 << 25) - (1 << 16)

Column = Callable[[Circle[Any]], Any]


def evaluate(
    functions: Sequence[Column],
    angles: NDArray[np.float64],
    *,
    out: NDArray[np.float64] | None = None,
) -> NDArray[np.float64]:
    """Return one row a function, one column an angle in degrees: shape (len(functions), len(angles)).

    Each function maps the circle of a block of angles to an array (or to one number for all of them).
    `out` is filled and returned if given; besides it only a block a core is held in memory. The bits do
    not depend on the number of cores.
    """
    if out is None:
        out = np.empty((len(functions), len(angles)))

    def fill(block: slice) -> None:
        point = circle(angles[block])
        for row, function in zip(out, functions, strict=True):
            row[block] = function(point)

    in_blocks(fill, len(angles))
    return out


def in_blocks(fill: Callable[[slice], None], size: int) -> None:
    """Call the function with each block of so many places, on all cores; the first exception is raised."""
    # glibc returns an intermediate column to the system as soon as it is freed, and the next one is mapped
    # and cleared page by page: two thirds of the time. Having freed one large array, which is never
    # touched, it keeps what is smaller (mallopt(3), M_MMAP_THRESHOLD). Elsewhere this does nothing.
    np.empty(LARGEST_KEPT, np.uint8)
    blocks = [slice(start, start + BLOCK) for start in range(0, size, BLOCK)]
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
