"""x, c and p at ten million angles: kurbel beside NumPy, numexpr, a numba loop, and writing the result.

The peers compute the textbook formulas, as one would write them; one of them as one would write them who
knows NumPy and the formulas: half angles, products for powers, blocks that fit a cache, arrays that are
there, a thread for each core. How far kurbel and this one are off is compared, too.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache, partial
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from benchmarks.race import ALONE, Contestant, Race, Row, Run, Task, cores_here

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Columns = NDArray[np.float64]
    Errors = Callable[[Any], Mapping[str, float]]

RATIO = 0.2345
CELLS = 100_000_000
# Of ten arrays so long half a megabyte.
BLOCK = 8192
LEAST = (0.0, 0.0, 1.0)
# Cells whose true values are computed, and what is told of their errors.
SAMPLES = 4000
GREATEST, OF_MOST = "greatest error", "error of nine cells in ten at most"
TEXTBOOK, CAREFUL = "NumPy, textbook", "NumPy, with care"
BARE, BARE_ALONE = "without numba", "without numba, on one core"
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


def careful_numpy(order: str, count: int) -> Run:
    from concurrent.futures import ThreadPoolExecutor

    import numpy as np

    given, cores = angles(order, count), cores_here()

    def fill(part: slice, out: Columns) -> None:
        room = np.empty((6, BLOCK))
        for start in range(part.start, part.stop, BLOCK):
            block = slice(start, min(start + BLOCK, part.stop))
            half, sine, cosine, versine, w, slant = room[:, : block.stop - start]
            x, c, p = out[:, block]
            # sin φ, cos φ and 1 - cos φ by half the angle, of which the last keeps its digits
            np.multiply(given[block], np.pi / 360, out=half)
            np.sin(half, out=versine)
            np.cos(half, out=sine)
            sine *= versine
            sine *= 2
            versine *= versine
            versine *= 2
            np.subtract(1, versine, out=cosine)
            np.multiply(sine, RATIO, out=slant)
            np.multiply(slant, slant, out=w)
            np.subtract(1, w, out=w)
            np.sqrt(w, out=w)
            # x = 1 - cos φ + λ sin² φ/(1 + w)
            slant *= sine
            np.add(w, 1, out=x)
            np.divide(slant, x, out=x)
            x += versine
            # c = sin φ (1 + λ cos φ/w)
            np.divide(cosine, w, out=c)
            c *= RATIO
            c += 1
            c *= sine
            # p = cos φ + λ (2 cos² φ - 1 + (λ sin² φ)²)/w³
            np.multiply(cosine, cosine, out=p)
            p *= 2
            p -= 1
            slant *= slant
            p += slant
            np.multiply(w, w, out=half)
            half *= w
            p /= half
            p *= RATIO
            p += cosine

    pool = ThreadPoolExecutor(cores)
    edges = [count * core // cores for core in range(cores + 1)]
    parts = [slice(start, end) for start, end in pairwise(edges)]

    def columns() -> Columns:
        out = np.empty((3, count))
        list(pool.map(lambda part: fill(part, out), parts))
        return out

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


def errors(order: str, count: int, result: Any) -> dict[str, float]:
    """Return by how many units in the last place some of the cells are off, by mpmath's textbook formulas.

    Of p, which crosses zero where its formula cancels, the units are those of max(|p|, 1).
    """
    import numpy as np

    step = count // SAMPLES
    columns = np.array([one[::step] for one in (result.values() if isinstance(result, dict) else result)])
    off = [
        abs(float(mine - one)) / float(np.spacing(max(abs(float(one)), least)))
        for angle, own in zip(angles(order, count)[::step].tolist(), columns.T.tolist(), strict=True)
        for mine, one, least in zip(own, truth(angle), LEAST, strict=True)
    ]
    return {GREATEST: max(off), OF_MOST: sorted(off)[len(off) * 9 // 10]}


@cache
def truth(angle: float) -> tuple[Any, ...]:
    from mpmath import mp, mpf

    with mp.workdps(40):
        phi, ratio = mp.radians(mpf(angle)), mpf(RATIO)
        sine, cosine = mp.sin(phi), mp.cos(phi)
        w = mp.sqrt(1 - (ratio * sine) ** 2)
        return (
            1 - cosine + (1 - w) / ratio,
            sine + ratio * sine * cosine / w,
            cosine + ratio * (mp.cos(2 * phi) + ratio**2 * sine**4) / w**3,
        )


def races(quick: bool) -> Iterator[Race]:
    count, told, fewer = (10**6, "10⁶", "10⁵") if quick else (10**7, "10⁷", "10⁶")
    for order in ORDERS:
        what, of = f"x, c and p at {told} angles {order}", (order, count)
        yield _on_one_core(what, of, partial(errors, *of) if order == "at random" else None)
        yield _on_all_cores(what, of, fewer if order == "in order" else "")


def _on_one_core(what: str, of: tuple[str, int], off: Errors | None) -> Race:
    """Each on one core, where what else runs does not change how much processor time it takes."""
    more: Any = {"sums": total, "errors": off, "cores": 1}
    alone, bare = f"{what}, on one core", f"{what}, {BARE}, on one core"
    return Race(
        {
            TEXTBOOK: Task(textbook_numpy, of, **more),
            CAREFUL: Task(careful_numpy, of, **more),
            BARE: Task(by_kurbel, of, ("numba",), **more),
            "kurbel": Task(by_kurbel, of, **more),
        },
        [
            *(
                Row(name, mine, beside, times=of[1])
                for name, mine in ((alone, "kurbel"), (bare, BARE))
                for beside in (TEXTBOOK, CAREFUL)
            ),
            *(
                Row(f"{what}: {one}", "kurbel", beside, error=one)
                for beside in (TEXTBOOK, CAREFUL)
                for one in (GREATEST, OF_MOST)
                if off
            ),
        ],
        rounds=9,
        clock="processor",
    )


def _on_all_cores(what: str, of: tuple[str, int], fewer: str) -> Race:
    count, bare = of[1], f"{what}, {BARE}"
    few = f"kurbel, at {fewer} angles"
    contestants: dict[str, Contestant] = {
        CAREFUL: Task(careful_numpy, of, sums=total),
        "numexpr, textbook": Task(textbook_numexpr, of, sums=total, needs="numexpr"),
        "numba's loop, textbook": Task(textbook_numba, of, sums=total, needs="numba"),
        "pure write of the result": Task(pure_write, of, needs="numba"),
        BARE: Task(by_kurbel, of, ("numba",), total),
        "kurbel": Task(by_kurbel, of, sums=total),
    }
    rows = [
        Row(what, "kurbel", CAREFUL, times=count),
        Row(bare, BARE, CAREFUL, times=count),
        Row(what, "kurbel", "numexpr, textbook", times=count),
        Row(what, "kurbel", "numba's loop, textbook", 1 / 2, count),
        Row(what, "kurbel", "pure write of the result", times=count),
    ]
    if fewer:
        contestants |= {
            ALONE: Task(by_kurbel, of, cores=1),
            BARE_ALONE: Task(by_kurbel, of, ("numba",), cores=1),
            few: Task(by_kurbel, (of[0], count // 10)),
        }
        rows += [
            Row(what, "kurbel", ALONE, times=count),
            Row(bare, BARE, BARE_ALONE, times=count),
            Row(what, "kurbel", few, times=count, its_times=count // 10),
        ]
    return Race(contestants, rows, rounds=9)
