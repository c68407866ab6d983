"""The irregularity δ of a million engines: kurbel beside a loop of SciPy's brentq over the same equations.

The loop runs over some of the engines and has its time scaled; both must agree on these.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import acos, asin, cos, log, pi, sin, sqrt
from typing import TYPE_CHECKING, Any, NamedTuple

from benchmarks.race import ALONE, Race, Row, Run, Task

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

SAMPLE = 500
# The greatest expansion, crank ratio and clearance. With more of all three the steam may push harder than
# on the average at two places, and the loop, which looks for one, is wrong.
MOST, MOST_WITH_CLEARANCE = (100, 0.9, 0), (20, 0.4, 0.1)


class Engines(NamedTuple):
    """Expansion ratios, crank ratios, back pressures and clearances, one of each an engine."""

    eps: Floats
    ratio: Floats
    back: Floats
    clearance: Floats


def engines(count: int, has_clearance: bool) -> Engines:
    """Return engines of any expansion, rod and back pressure that leave a mean force."""
    import numpy as np

    random = np.random.default_rng(150)
    most_eps, most_ratio, most_clearance = MOST_WITH_CLEARANCE if has_clearance else MOST
    eps = np.exp(random.uniform(np.log(1.05), np.log(most_eps), count))
    pressure = (1 + np.log(eps)) / eps
    ratio, back = random.uniform(0, most_ratio, count), random.uniform(0, 0.98, count) * pressure
    return Engines(eps, ratio, back, random.uniform(0, most_clearance, count))


def by_brentq(eps: float, ratio: float, back: float, clearance: float) -> float:
    """δ as one would write it for a single engine: two roots a stroke, in math functions."""
    from scipy.optimize import brentq

    # Volumes in units of that of half a stroke.
    cut, dead = 2 / eps, 2 * clearance

    def expanded(path: float) -> float:
        """The work of the steam up to a place behind the cut-off."""
        return cut + (cut + dead) * log((path + dead) / (cut + dead))

    mean = (expanded(2) - 2 * back) / pi
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
            return ((cut + dead) / (path(angle) + dead) - back) * velocity(angle) - mean

        first = brentq(surplus, 0, pi / 2)
        least.append((1 - back) * path(first) - mean * first)
        cut_off = acos(1 - cut * (2 - rod * cut) / (2 * (1 + rod * (1 - cut))))
        if expanding(cut_off) > 0:
            last = brentq(expanding, cut_off, pi)
            work = expanded(path(last))
        else:
            last = brentq(surplus, pi / 2, pi)
            work = path(last)
        greatest.append(work - back * path(last) - mean * last)
    return float(max(greatest) - min(least)) / mean


def the_loop(count: int, has_clearance: bool) -> Run:
    given = engines(count, has_clearance)
    rows = list(zip(*(column[chosen(count)].tolist() for column in given), strict=True))
    return lambda: [by_brentq(*row) for row in rows]


def by_kurbel(count: int, has_clearance: bool) -> Run:
    import kurbel

    eps, ratio, back, clearance = engines(count, has_clearance)
    if has_clearance:
        return lambda: kurbel.compute_delta(eps, ratio, back, clearance=clearance, fast=True)
    return lambda: kurbel.compute_delta(eps, ratio, back, fast=True)


def chosen(count: int) -> slice:
    """Return which engines the loop runs over."""
    return slice(0, count, max(1, count // SAMPLE))


def sum_of_chosen(result: Any) -> float:
    """Return the sum of what the loop runs over."""
    return float(sum(result if isinstance(result, list) else result[chosen(len(result))]))


def races(quick: bool) -> Iterator[Race]:
    count, told = (10**5, "10⁵") if quick else (10**6, "10⁶")
    for has_clearance in (False, True):
        what, of = f"δ of {told} engines{' with clearance' * has_clearance}", (count, has_clearance)
        yield Race(
            {
                "loop of brentq": Task(the_loop, of, sums=sum_of_chosen, share=SAMPLE / count, cores=1),
                "without numba": Task(by_kurbel, of, ("numba",), sum_of_chosen, cores=1),
                "kurbel": Task(by_kurbel, of, sums=sum_of_chosen, cores=1),
            },
            (
                Row(f"{what}, on one core", "kurbel", "loop of brentq", 1 / 400, count),
                Row(f"{what}, without numba, on one core", "without numba", "loop of brentq", times=count),
            ),
            clock="processor",
        )
        yield Race(
            {"kurbel": Task(by_kurbel, of), ALONE: Task(by_kurbel, of, cores=1)},
            [Row(what, "kurbel", ALONE, times=count)],
        )
