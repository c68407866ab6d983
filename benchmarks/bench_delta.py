"""The irregularity δ of a million engines: kurbel beside a loop of SciPy's brentq over the same equations.

The loop is timed on some engines drawn from the million, and its time scaled. Both must agree on these.
Run: python benchmarks/bench_delta.py [number of engines]
"""

from __future__ import annotations

import sys
import time
import tracemalloc
from collections.abc import Callable
from math import acos, asin, cos, log, pi, sin, sqrt
from statistics import median
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq
from tabulate import tabulate

from kurbel.engine.irregularity import delta

SAMPLE = 500
REPEATS = 7
AGREEMENT = 1e-12
LEAST_GAIN = 200


class Engines(NamedTuple):
    """Expansion ratios, crank ratios and back pressures, one of each an engine."""

    eps: NDArray[np.float64]
    ratio: NDArray[np.float64]
    back: NDArray[np.float64]


def engines(count: int) -> Engines:
    """Return engines of any expansion, rod and back pressure that leave a mean force."""
    random = np.random.default_rng(150)
    eps = np.exp(random.uniform(np.log(1.05), np.log(100), count))
    most = (1 + np.log(eps)) / eps
    return Engines(eps, random.uniform(0, 0.9, count), random.uniform(0, 0.98, count) * most)


def by_brentq(eps: float, ratio: float, back: float) -> float:
    """δ as one would write it for a single engine: two roots a stroke, in math functions."""
    mean = 2 / pi * ((1 + log(eps)) / eps - back)
    share = mean / (1 - back)
    least, greatest = [], []
    for rod in (ratio, -ratio):

        def velocity(angle: float, rod: float = rod) -> float:
            sine = sin(angle)
            return sine + rod * sine * cos(angle) / sqrt(1 - (rod * sine) ** 2)

        def path(angle: float, rod: float = rod) -> float:
            psi = asin(rod * sin(angle))
            return 1 - cos(angle) + sin(angle) * sin(psi) / (1 + cos(psi))

        def surplus(angle: float) -> float:
            return velocity(angle) - share

        def expanding(angle: float) -> float:
            return (2 / (eps * path(angle)) - back) * velocity(angle) - mean

        first = brentq(surplus, 0, pi / 2)
        least.append((1 - back) * path(first) - mean * first)
        cut = 2 / eps
        cut_off = acos(1 - cut * (2 - rod * cut) / (2 * (1 + rod * (1 - cut))))
        if expanding(cut_off) > 0:
            last = brentq(expanding, cut_off, pi)
            work = cut * (1 + log(path(last) / cut))
        else:
            last = brentq(surplus, pi / 2, pi)
            work = path(last)
        greatest.append(work - back * path(last) - mean * last)
    return float(max(greatest) - min(least)) / mean


def seconds(function: Callable[[], object], repeats: int) -> float:
    """Return the median time after one round that is not counted."""
    times = []
    for _ in range(repeats + 1):
        start = time.perf_counter()
        function()
        times.append(time.perf_counter() - start)
    return median(times[1:])


def peak(function: Callable[[], object]) -> int:
    """Return the most bytes allocated at once during a call."""
    tracemalloc.start()
    function()
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    return most


def main() -> None:
    count = int(float(sys.argv[1])) if len(sys.argv) > 1 else 10**6
    given = engines(count)
    chosen = slice(0, count, max(1, count // SAMPLE))
    rows = list(zip(*(column[chosen].tolist() for column in given), strict=True))
    bulk = seconds(lambda: delta(*given), REPEATS)
    loop = seconds(lambda: [by_brentq(*row) for row in rows], REPEATS) / len(rows) * count
    expected = np.array([by_brentq(*row) for row in rows])
    error = float(np.max(np.abs(np.asarray(delta(*given))[chosen] / expected - 1)))
    print(f"δ of {count:,} engines; the loop timed on {len(rows)} of them")
    body = [
        ("loop of brentq", f"{loop * 1e3:.0f}", f"{loop / count * 1e9:.0f}", "1"),
        ("kurbel", f"{bulk * 1e3:.0f}", f"{bulk / count * 1e9:.0f}", f"{loop / bulk:.0f}"),
    ]
    headers = ("", "ms", "ns an engine", "times as fast")
    print(tabulate(body, headers=headers, disable_numparse=True, colalign=("left",) + ("right",) * 3))
    print(f"greatest relative difference {error:.1e}")
    most, result = peak(lambda: delta(*given)) / 1e6, count * 8 / 1e6
    print(f"peak memory {most:.0f} MB, of which the result {result:.0f} MB")
    assert error <= AGREEMENT, f"they differ by {error:.1e}"
    assert count < 10**5 or loop / bulk >= LEAST_GAIN, f"only {loop / bulk:.0f} times as fast"


if __name__ == "__main__":
    main()
