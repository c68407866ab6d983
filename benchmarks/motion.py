"""x, c and p at ten million angles: kurbel beside NumPy, numexpr, a numba loop, and writing the result.

The peers compute the textbook formulas, as one would write them.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from benchmarks.race import Race, Row, Run, Task

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Columns = NDArray[np.float64]

RATIO = 0.2345
CELLS = 100_000_000
ORDERS = ("in order", "at random")


def angles(order: str, count: int) -> Columns:
    """Return so many angles of one turn, in degrees."""
    import numpy as np

    if order == "in order":
        return np.linspace(0, 360, count)
    return np.random.default_rng(1).uniform(0, 360, count)


def textbook_numpy(order: str, count: int) -> Run:
    import numpy as np

    given = angles(order, count)

    def columns() -> Columns:
        phi = np.radians(given)
        sine, cosine = np.sin(phi), np.cos(phi)
        w = np.sqrt(1 - (RATIO * sine) ** 2)
        x = 1 - cosine + (1 - w) / RATIO
        c = sine + RATIO * sine * cosine / w
        p = cosine + RATIO * (np.cos(2 * phi) + RATIO**2 * sine**4) / w**3
        return np.stack([x, c, p])

    return columns


def textbook_numexpr(order: str, count: int) -> Run:
    import numexpr
    import numpy as np

    given = angles(order, count)

    def columns() -> Columns:
        out = np.empty((3, count))
        phi = np.radians(given)
        names = {"phi": phi, "r": RATIO}
        w = "sqrt(1 - (r*sin(phi))**2)"
        numexpr.evaluate(f"1 - cos(phi) + (1 - {w})/r", names, out=out[0])
        numexpr.evaluate(f"sin(phi) + r*sin(phi)*cos(phi)/{w}", names, out=out[1])
        numexpr.evaluate(f"cos(phi) + r*(cos(2*phi) + r**2*sin(phi)**4)/{w}**3", names, out=out[2])
        return out

    return columns


def textbook_numba(order: str, count: int) -> Run:
    import math

    import numba
    import numpy as np

    given = angles(order, count)

    @numba.njit(parallel=True)  # type: ignore[untyped-decorator, unused-ignore]
    def fill(given: Any, out: Any) -> None:
        for i in numba.prange(len(given)):
            phi = math.radians(given[i])
            sine, cosine = math.sin(phi), math.cos(phi)
            w = math.sqrt(1 - (RATIO * sine) ** 2)
            out[0, i] = 1 - cosine + (1 - w) / RATIO
            out[1, i] = sine + RATIO * sine * cosine / w
            out[2, i] = cosine + RATIO * (math.cos(2 * phi) + RATIO**2 * sine**4) / w**3

    def columns() -> Columns:
        out = np.empty((3, count))
        fill(given, out)
        return out

    return columns


def by_kurbel(order: str, count: int) -> Run:
    import kurbel

    given = angles(order, count)

    def columns() -> dict[str, Columns]:
        return kurbel.compute(given, RATIO)

    # It takes numba once NumPy has had so many cells to do that this pays.
    for _ in range(-(-CELLS // (3 * count))):
        columns()
    return columns


def pure_write(order: str, count: int) -> Run:
    """The result is written to new memory, by all cores; there is nothing to compute."""
    import numba
    import numpy as np

    given = angles(order, count)

    @numba.njit(parallel=True)  # type: ignore[untyped-decorator, unused-ignore]
    def fill(given: Any, out: Any) -> None:
        for i in numba.prange(len(given)):
            out[0, i] = out[1, i] = out[2, i] = given[i]

    def columns() -> Columns:
        out = np.empty((3, count))
        fill(given, out)
        return out

    return columns


def total(result: Any) -> float:
    """Return the sum of all columns, which are an array or stand by their keys."""
    columns = result.values() if isinstance(result, dict) else result
    return float(sum(abs(column).sum() for column in columns))


def races(quick: bool) -> Iterator[Race]:
    count, told = (10**6, "10⁶") if quick else (10**7, "10⁷")
    for order in ORDERS:
        what = f"x, c and p at {told} angles {order}"
        of = (order, count)
        yield Race(
            {
                "NumPy, textbook": Task(textbook_numpy, of, sums=total),
                "numexpr, textbook": Task(textbook_numexpr, of, sums=total, needs="numexpr"),
                "numba's loop, textbook": Task(textbook_numba, of, sums=total, needs="numba"),
                "pure write of the result": Task(pure_write, of, needs="numba"),
                "without numba": Task(by_kurbel, of, ("numba",), total),
                "kurbel": Task(by_kurbel, of, sums=total),
            },
            (
                Row(what, "kurbel", "NumPy, textbook", times=count),
                Row(what, "kurbel", "numexpr, textbook", times=count),
                Row(what, "kurbel", "numba's loop, textbook", 1 / 5, count),
                Row(what, "kurbel", "pure write of the result", 1 / 0.4, count),
                Row(f"{what}, without numba", "without numba", "NumPy, textbook", times=count),
            ),
            rounds=9,
        )
