"""When numba is worth loading: once NumPy has taken about as long as that would."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable, Sequence
from importlib.util import find_spec
from threading import Lock
from typing import Any

# Cells that NumPy does while numba is loaded (0.4 s) and while it compiles a loop (0.3 s), on two cores.
LOADING = 50_000_000
COMPILING = 30_000_000
# Below this many neither the formulas are written down nor anything is counted.
FEWEST = 50_000

_done: Counter[str] = Counter()
_counting = Lock()


def chosen(
    functions: Sequence[Callable[..., Any] | None], others: int, cells: int, fast: bool | None
) -> tuple[Callable[..., None], list[int]] | None:
    """Return a loop and the functions that it has, by their places; None where NumPy is to do so many cells.

    None among the functions is one for NumPy, as is one that is more than arithmetic. `fast` is whether numba
    is to be taken where it is installed, None if it is to pay. No bit depends on it.
    """
    if fast is False or (fast is None and cells < FEWEST) or find_spec("numba") is None:
        return None
    if fast is None and not (_is_loaded() or _reached("", cells, LOADING)):
        return None
    from kurbel.kernel.fast import loops
    from kurbel.kernel.fast.loops import traceable, written

    if not loops.installed():
        return None
    places = [place for place, one in enumerate(functions) if one is not None and traceable(one, others)]
    ours = [one for place in places if (one := functions[place]) is not None]
    if not ours:
        return None
    if fast is None and not _reached(written(ours, others).name, cells, COMPILING):
        return None
    return loops.loop(ours, others), places


def of_all(cells: int) -> bool | None:
    """Return what `fast` is to be of a part of so many cells in all: True if these pay, else None."""
    return True if cells >= LOADING + COMPILING else None


def pays(what: str, cells: int, fast: bool | None) -> bool:
    """Whether a loop of this name is to do what NumPy does in the time of so many cells."""
    if fast is False or (fast is None and cells < FEWEST) or find_spec("numba") is None:
        return False
    if fast is None and not (_is_loaded() or _reached("", cells, LOADING)):
        return False
    from kurbel.kernel.fast import loops

    return loops.installed() and bool(fast or _reached(what, cells, COMPILING))


def _is_loaded() -> bool:
    return "numba" in sys.modules


def _reached(what: str, cells: int, enough: int) -> bool:
    with _counting:
        _done[what] += cells
        return _done[what] >= enough
