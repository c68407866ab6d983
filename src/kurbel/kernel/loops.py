"""Loops that numba compiles: the same bits as the functions on arrays, without the arrays in between."""

from __future__ import annotations

import math
import sys
from collections import Counter
from collections.abc import Callable, Sequence
from functools import cache, lru_cache
from hashlib import sha256
from importlib import import_module
from importlib.util import find_spec
from textwrap import indent
from threading import Lock
from types import FunctionType
from typing import Any, NamedTuple

from kurbel.kernel.circle import circle
from kurbel.kernel.trace import Tape, UntraceableError

# Older ones know no NumPy 2.
OLDEST = (0, 61)
# Columns of a loop: 8 take 4 ns a place. Of 16 the compiler no longer proves that they lie apart: 49 ns.
ROWS = 8


def loop(functions: Sequence[Callable[..., object]], others: int = 0) -> Callable[..., None]:
    """Return what fills a row with each function, at arrays of angles in degrees and of so many others.

    It takes these arrays and then the rows, all of them contiguous float64 arrays of one size. It holds no
    lock while it runs and has no threads of its own. Needs numba; raises UntraceableError.
    """
    import numpy as np

    texts = [written(functions[start : start + ROWS], others) for start in range(0, len(functions), ROWS)]
    runs = [(compiled(text._replace(constants=())), np.array(text.constants)) for text in texts]

    def fill(*arrays: object) -> None:
        inputs, rows = arrays[: others + 1], arrays[others + 1 :]
        for place, (run, constants) in enumerate(runs):
            run(constants, *inputs, *rows[place * ROWS : (place + 1) * ROWS])

    return fill


@cache
def installed() -> bool:
    """Whether there is a numba that works, which is asked without loading it only if there is none."""
    if find_spec("numba") is None:
        return False
    try:
        numba = _numba()
        # NUMBA_DISABLE_JIT leaves loops to Python, a hundred times slower than arrays.
        return bool(numba.version_info.short >= OLDEST and not numba.config.DISABLE_JIT)
    except (ImportError, OSError):
        # It refuses a NumPy that it does not know, and its compiler is a shared library.
        return False


def _numba() -> Any:
    return import_module("numba")


@lru_cache(maxsize=256)
def compiled(text: LoopSource) -> Callable[..., None]:
    """Return the loop as machine code, from numba's cache on disk if it is there."""
    numba = _numba()
    read, filled = (numba.types.Array(numba.float64, 1, "C", readonly=one) for one in (True, False))
    signature = numba.void(read, *[read] * text.reads, *[filled] * text.fills)
    # No fastmath: each operation is done as NumPy does it.
    options: dict[str, object] = {"nogil": True, "error_model": "numpy"}
    try:
        found: Callable[..., None] = numba.njit(signature, cache=True, **options)(_function(text))
    except (RuntimeError, OSError):
        # There is no place for the cache, or no room in it.
        found = numba.njit(signature, **options)(_function(text))
    return found


def _function(text: LoopSource) -> FunctionType:
    import numpy as np

    # numba caches by file and name: this file stands for the lines, and the name has all of them in it.
    names: dict[str, Any] = {
        "sqrt": math.sqrt,
        "int64": np.int64,
        "float64": np.float64,
        "__name__": __name__,
    }
    exec(compile(text.text, __file__, "exec"), names)
    return names[text.name]


class LoopSource(NamedTuple):
    """A loop as text: its name, its lines, how many arrays it reads and fills, and the floats it is given."""

    name: str
    text: str
    reads: int
    fills: int
    constants: tuple[float, ...]


def written(functions: Sequence[Callable[..., object]], others: int = 0) -> LoopSource:
    """Return the loop that fills an array with each function of a crank angle's circle and so many others.

    The function of the loop takes the constants, the arrays of angles in degrees and of the others, and the
    arrays to fill. Its name is that of its text: one that is found again is the same loop.
    Raises UntraceableError.
    """
    tape = Tape()
    inputs = [tape.input(f"a{place}") for place in range(others + 1)]
    point = circle(inputs[0])
    return _loop(tape, len(inputs), [function(point, *inputs[1:]) for function in functions])


def rows_of(formula: Callable[..., Sequence[object]], reads: int) -> Callable[..., Any]:
    """Return what gives a row for each result of a formula at arrays of so many numbers, all of one size.

    Floats of the formula are numbers that never change. Needs numba; raises UntraceableError.
    """
    import numpy as np

    tape = Tape()
    with tape.law():
        text = _loop(tape, reads, formula(*(tape.input(f"a{place}") for place in range(reads))))
    run = compiled(text)

    def rows(*arrays: object) -> Any:
        inputs = [np.require(one, np.float64, ("C", "A")) for one in arrays]
        found = np.empty((text.fills, len(inputs[0])))
        run(np.empty(0), *inputs, *found)
        return found

    return rows


def _loop(tape: Tape, reads: int, results: Sequence[object]) -> LoopSource:
    inputs, found = [f"a{place}" for place in range(reads)], [tape.name(one) for one in results]
    rows = [f"row{place}" for place in range(len(found))]
    each = [f"{name} = of_{name}[i]" for name in inputs]
    each += [*tape.lines, *(f"{row}[i] = {result}" for row, result in zip(rows, found, strict=True))]
    body = [f"k{place} = constants[{place}]" for place in range(len(tape.constants))]
    body += ["for i in range(len(of_a0)):", indent("\n".join(each), "    ")]
    lines = indent("\n".join(body), "    ")
    name = f"loop_{sha256(lines.encode()).hexdigest()[:24]}"
    arguments = ", ".join(["constants", *(f"of_{name}" for name in inputs), *rows])
    return LoopSource(name, f"def {name}({arguments}):\n{lines}\n", reads, len(rows), tuple(tape.constants))


def traceable(function: Callable[..., object], others: int = 0) -> bool:
    """Whether the function is arithmetic, which writes itself down."""
    try:
        written([function], others)
    except UntraceableError:
        return False
    return True


# Cells that NumPy does while numba is loaded (0.4 s) and while it compiles a loop (0.3 s), on two cores.
LOADING = 50_000_000
COMPILING = 30_000_000
# Below this many neither the formulas are written down nor anything is counted.
FEWEST = 50_000

_done: Counter[str] = Counter()
_counting = Lock()


def chosen(
    functions: Sequence[Callable[..., object] | None], others: int, cells: int, fast: bool | None
) -> tuple[Callable[..., None], list[int]] | None:
    """Return a loop and the functions that it has, by their places; None where NumPy is to do so many cells.

    None among the functions is one for NumPy, as is one that is more than arithmetic. `fast` is whether numba
    is to be taken where it is installed, None if it is to pay. No bit depends on it.
    """
    if not _worth_loading(cells, fast):
        return None
    places = [place for place, one in enumerate(functions) if one is not None and traceable(one, others)]
    ours = [one for place in places if (one := functions[place]) is not None]
    if not ours:
        return None
    if fast is None and not _reached(written(ours, others).name, cells, COMPILING):
        return None
    return loop(ours, others), places


def of_all(cells: int) -> bool | None:
    """Return what `fast` is to be of a part of so many cells in all: True if these pay, else None."""
    return True if cells >= LOADING + COMPILING else None


def pays(what: str, cells: int, fast: bool | None) -> bool:
    """Whether a loop of this name is to do what NumPy does in the time of so many cells."""
    return _worth_loading(cells, fast) and bool(fast or _reached(what, cells, COMPILING))


def _worth_loading(cells: int, fast: bool | None) -> bool:
    if fast is False or (fast is None and cells < FEWEST) or find_spec("numba") is None:
        return False
    if fast is None and not (_is_loaded() or _reached("", cells, LOADING)):
        return False
    return installed()


def _is_loaded() -> bool:
    return "numba" in sys.modules


def _reached(what: str, cells: int, enough: int) -> bool:
    with _counting:
        _done[what] += cells
        return _done[what] >= enough
