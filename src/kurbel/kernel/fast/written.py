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
    inputs = [tape.input(f"a{place}") for place in range(others + 1)]
    point = circle(inputs[0])
    return _loop(tape, len(inputs), [function(point, *inputs[1:]) for function in functions])


def written_formula(formula: Callable[..., Sequence[Any]], reads: int) -> Written:
    """Return the loop that fills an array with each result of a formula of so many numbers.

    Floats of the formula are numbers that never change. Raises UntraceableError.
    """
    tape = Tape()
    with tape.law():
        return _loop(tape, reads, formula(*(tape.input(f"a{place}") for place in range(reads))))


def _loop(tape: Tape, reads: int, results: Sequence[Any]) -> Written:
    inputs, found = [f"a{place}" for place in range(reads)], [tape.name(one) for one in results]
    rows = [f"row{place}" for place in range(len(found))]
    each = [f"{name} = of_{name}[i]" for name in inputs]
    each += [*tape.lines, *(f"{row}[i] = {result}" for row, result in zip(rows, found, strict=True))]
    body = [f"k{place} = constants[{place}]" for place in range(len(tape.constants))]
    body += ["for i in range(len(of_a0)):", indent("\n".join(each), "    ")]
    lines = indent("\n".join(body), "    ")
    name = f"loop_{sha256(lines.encode()).hexdigest()[:24]}"
    arguments = ", ".join(["constants", *(f"of_{name}" for name in inputs), *rows])
    return Written(name, f"def {name}({arguments}):\n{lines}\n", reads, len(rows), tuple(tape.constants))


def traceable(function: Callable[..., Any], others: int = 0) -> bool:
    """Whether the function is arithmetic, which writes itself down."""
    try:
        written([function], others)
    except UntraceableError:
        return False
    return True
