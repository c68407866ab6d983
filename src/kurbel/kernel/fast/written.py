"""Formulas that wrote themselves down, as the text of a loop over arrays."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from hashlib import sha256
from textwrap import indent
from typing import Any, NamedTuple

from kurbel.kernel.circle import circle
from kurbel.kernel.fast.trace import Tape, UntraceableError


class Written(NamedTuple):
    """A loop as text: its name, its lines, how many arrays it reads and fills, and the floats it is given."""

    name: str
    text: str
    reads: int
    fills: int
    constants: tuple[float, ...]


def written(functions: Sequence[Callable[..., Any]], others: int = 0) -> Written:
    """Return the loop that fills an array with each function of a crank angle's circle and so many others.

    The function of the loop takes the constants, the arrays of angles in degrees and of the others, and the
    arrays to fill. Its name is that of its text: one that is found again is the same loop.
    Raises UntraceableError.
    """
    tape = Tape()
    inputs = [f"a{place}" for place in range(others + 1)]
    degrees, *more = (tape.input(name) for name in inputs)
    point = circle(degrees)
    results = [tape.name(function(point, *more)) for function in functions]
    rows = [f"row{place}" for place in range(len(results))]
    each = [f"{name} = of_{name}[i]" for name in inputs]
    each += [*tape.lines, *(f"{row}[i] = {result}" for row, result in zip(rows, results, strict=True))]
    body = [f"k{place} = constants[{place}]" for place in range(len(tape.constants))]
    body += ["for i in range(len(of_a0)):", indent("\n".join(each), "    ")]
    lines = indent("\n".join(body), "    ")
    name = f"loop_{sha256(lines.encode()).hexdigest()[:24]}"
    arguments = ", ".join(["constants", *(f"of_{name}" for name in inputs), *rows])
    text = f"def {name}({arguments}):\n{lines}\n"
    return Written(name, text, len(inputs), len(rows), tuple(tape.constants))


def traceable(function: Callable[..., Any], others: int = 0) -> bool:
    """Whether the function is arithmetic, which writes itself down."""
    try:
        written([function], others)
    except UntraceableError:
        return False
    return True
