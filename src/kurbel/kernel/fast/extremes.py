"""The extreme speeds of very many engines in loops: the kernel's formulas, written out once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import Any, TypeAlias

import numpy as np

from kurbel.kernel.circle import Number
from kurbel.kernel.fast.loops import compiled, written_formula
from kurbel.kernel.fast.trace import Traced
from kurbel.kernel.irregularity import extremes as kernel
from kurbel.kernel.irregularity.extremes import Arithmetic, Extremes
from kurbel.kernel.irregularity.half_tangent import Motion, Place
from kurbel.kernel.irregularity.load import Load

Floats: TypeAlias = tuple[tuple[str, float], ...]

# What the extremes ask of a load, and what δ does.
FORCES = ("back", "net", "mean", "over", "dead", "swept", "bend")
WORK = ("back", "net", "mean", "forgone")


def extremes(kind: type[Motion], ratio: Number, load: Load) -> Extremes:
    """Return what `kernel.irregularity.extremes.extremes` returns, to the bit."""
    if load.exponent is not None:
        # Powers are those of NumPy.
        return kernel.extremes(kind, ratio, load)
    # Without clearance nothing asks where the cut-off is.
    arrays, floats = _sorted(load, FORCES if load.plain else ("expansion", *FORCES))
    motion: Any = kind
    rows = _filled(_extremes(motion, tuple(arrays), floats), 8, [ratio, *arrays.values()])
    return Extremes(Place(*rows[:3]), Place(*rows[3:6]), *rows[6:])


def irregularity(load: Load, *given: Number) -> Number:
    """Return what `kernel.irregularity.extremes.irregularity` returns, to the bit."""
    arrays, floats = _sorted(load, WORK)
    return _filled(_irregularity(tuple(arrays), floats), 1, [*given, *arrays.values()])[0]


BY_LOOPS = Arithmetic(extremes, irregularity)


def _sorted(load: Load, names: Sequence[str]) -> tuple[dict[str, Number], Floats]:
    given = {name: getattr(load, name) for name in names}
    arrays = {name: one for name, one in given.items() if not isinstance(one, float)}
    return arrays, tuple((name, one) for name, one in given.items() if isinstance(one, float))


def _filled(run: Callable[..., None], rows: int, given: Sequence[Number]) -> list[Any]:
    size = max(one.size for one in given)
    arrays = [np.require(np.broadcast_to(one, size), np.float64, ("C", "A")) for one in given]
    filled = [np.empty(size) for _ in range(rows)]
    run(np.empty(0), *arrays, *filled)
    return filled


def _load(arrays: Sequence[str], floats: Floats, numbers: Sequence[Traced]) -> Load:
    unknown: dict[str, Any] = dict.fromkeys(Load._fields)
    return Load(**unknown | dict(floats) | dict(zip(arrays, numbers, strict=True)))


@lru_cache(maxsize=64)
def _extremes(kind: Any, arrays: tuple[str, ...], floats: Floats) -> Callable[..., None]:
    def formula(ratio: Traced, *more: Traced) -> list[Traced]:
        falling, rising, *rest = kernel.extremes(kind, ratio, _load(arrays, floats, more))
        return [*falling, *rising, *rest]

    return compiled(written_formula(formula, 1 + len(arrays)))


@lru_cache(maxsize=64)
def _irregularity(arrays: tuple[str, ...], floats: Floats) -> Callable[..., None]:
    def formula(*numbers: Traced) -> list[Traced]:
        return [kernel.irregularity(_load(arrays, floats, numbers[6:]), *numbers[:6])]

    return compiled(written_formula(formula, 6 + len(arrays)))
