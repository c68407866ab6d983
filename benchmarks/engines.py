"""The irregularity δ of a million engines: kurbel beside a loop of SciPy's brentq over the same equations.

The loop runs over some of the engines and has its time scaled; both must agree on these.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import acos, asin, cos, log, pi, sin, sqrt
from typing import TYPE_CHECKING, Any, NamedTuple

from benchmarks.race import Race, Row, Run, Task

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

SAMPLE = 500


class Engines(NamedTuple):
    """Expansion ratios, crank ratios and back pressures, one of each an engine."""

    eps: Floats
    ratio: Floats
    back: Floats


def engines(count: int) -> Engines:
    """Return engines of any expansion, rod and back pressure that leave a mean force."""
    import numpy as np

    random = np.random.default_rng(150)
    eps = np.exp(random.uniform(np.log(1.05), np.log(100), count))
    most = (1 + np.log(eps)) / eps
    return Engines(eps, random.uniform(0, 0.9, count), random.uniform(0, 0.98, count) * most)


def by_brentq(eps: float, ratio: float, back: float) -> float:
    """δ as one would write it for a single engine: two roots a stroke, in math functions."""
    from scipy.optimize import brentq

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


def the_loop(count: int) -> Run:
    given = engines(count)
    rows = list(zip(*(column[chosen(count)].tolist() for column in given), strict=True))
    return lambda: [by_brentq(*row) for row in rows]


def by_kurbel(count: int) -> Run:
    import kurbel

    given = engines(count)
    return lambda: kurbel.delta(*given, fast=True)


def chosen(count: int) -> slice:
    """Return which engines the loop runs over."""
    return slice(0, count, max(1, count // SAMPLE))


def sum_of_chosen(result: Any) -> float:
    """Return the sum of what the loop runs over."""
    return float(sum(result if isinstance(result, list) else result[chosen(len(result))]))


def races(quick: bool) -> Iterator[Race]:
    count, told = (10**5, "10⁵") if quick else (10**6, "10⁶")
    what = f"δ of {told} engines"

    yield Race(
        {
            "loop of brentq": Task(the_loop, (count,), sums=sum_of_chosen, share=SAMPLE / count),
            "without numba": Task(by_kurbel, (count,), ("numba",), sum_of_chosen),
            "kurbel": Task(by_kurbel, (count,), sums=sum_of_chosen),
        },
        (
            Row(what, "kurbel", "loop of brentq", 1 / 1800, count),
            Row(f"{what}, without numba", "without numba", "loop of brentq", times=count),
        ),
    )
