"""x, c and p for ten million angles: kurbel beside NumPy, numexpr and numba, in one run.

The peers compute the textbook formulas. Run: python benchmarks/bench_kernel.py [number of angles]
"""

from __future__ import annotations

import statistics
import sys
import time
from collections.abc import Callable
from importlib import import_module
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kurbel.exact.bulk import evaluate
from kurbel.kernel import kinematics

RATIO = 0.2345
REPEATS = 5
Columns = NDArray[np.float64]


def naive(angles: Columns) -> Columns:
    phi = np.radians(angles)
    sine, cosine = np.sin(phi), np.cos(phi)
    w = np.sqrt(1 - (RATIO * sine) ** 2)
    x = 1 - cosine + (1 - w) / RATIO
    c = sine + RATIO * sine * cosine / w
    p = cosine + RATIO * (np.cos(2 * phi) + RATIO**2 * sine**4) / w**3
    return np.stack([x, c, p])


def with_numexpr() -> Callable[[Columns], Columns]:
    numexpr = import_module("numexpr")

    def columns(angles: Columns) -> Columns:
        out = np.empty((3, len(angles)))
        phi = np.radians(angles)
        names = {"phi": phi, "r": RATIO}
        w = "sqrt(1 - (r*sin(phi))**2)"
        numexpr.evaluate(f"1 - cos(phi) + (1 - {w})/r", names, out=out[0])
        numexpr.evaluate(f"sin(phi) + r*sin(phi)*cos(phi)/{w}", names, out=out[1])
        numexpr.evaluate(f"cos(phi) + r*(cos(2*phi) + r**2*sin(phi)**4)/{w}**3", names, out=out[2])
        return out

    return columns


def with_numba() -> Callable[[Columns], Columns]:
    import math

    numba = import_module("numba")

    @numba.njit(parallel=True)  # type: ignore[untyped-decorator, unused-ignore]
    def fill(angles: Any, out: Any) -> None:
        for i in numba.prange(len(angles)):
            phi = math.radians(angles[i])
            sine, cosine = math.sin(phi), math.cos(phi)
            w = math.sqrt(1 - (RATIO * sine) ** 2)
            out[0, i] = 1 - cosine + (1 - w) / RATIO
            out[1, i] = sine + RATIO * sine * cosine / w
            out[2, i] = cosine + RATIO * (math.cos(2 * phi) + RATIO**2 * sine**4) / w**3

    def columns(angles: Columns) -> Columns:
        out = np.empty((3, len(angles)))
        fill(angles, out)
        return out

    return columns


FUNCTIONS = [
    lambda point: kinematics.piston_path(point, RATIO),
    lambda point: kinematics.piston_velocity(point, RATIO),
    lambda point: kinematics.piston_acceleration(point, RATIO),
]


def kurbel(angles: Columns) -> Columns:
    return evaluate(FUNCTIONS, angles)


def contestants() -> dict[str, Callable[[Columns], Columns] | None]:
    """Return the functions to time; None for a peer that is not installed."""
    return {
        "NumPy, textbook": naive,
        "numexpr": with_numexpr() if find_spec("numexpr") else None,
        "numba, parallel": with_numba() if find_spec("numba") else None,
        "kurbel": kurbel,
    }


def medians(angles: Columns) -> dict[str, float | None]:
    """Time all of them in turn, so that a busy moment of the machine strikes everyone."""
    functions = contestants()
    seconds: dict[str, list[float]] = {name: [] for name in functions}
    for repeat in range(REPEATS + 1):
        for name, function in functions.items():
            if function is None:
                continue
            start = time.perf_counter()
            function(angles)
            # The first round compiles and touches the memory.
            if repeat:
                seconds[name].append(time.perf_counter() - start)
    return {name: statistics.median(times) if times else None for name, times in seconds.items()}


def main() -> None:
    count = int(float(sys.argv[1])) if len(sys.argv) > 1 else 10**7
    orders = {
        "in order": np.linspace(0, 360, count),
        "at random": np.random.default_rng(1).uniform(0, 360, count),
    }
    for order, angles in orders.items():
        print(f"{count:,} angles {order}: x, c, p")
        results = medians(angles)
        base = results["NumPy, textbook"] or 1.0
        for name, seconds in results.items():
            if seconds is None:
                print(f"  {name:18} not installed")
            else:
                rate, gain = count / seconds / 1e6, base / seconds
                print(f"  {name:18} {seconds * 1e3:7.0f} ms {rate:6.1f} M/s {gain:6.2f} x")


if __name__ == "__main__":
    main()
