"""How long something takes, in beats: the processor time of a loop that is always the same.

A slow or busy machine, or one that counts lines, is as slow at the beat.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from time import process_time


def _beat() -> float:
    before = process_time()
    sum(number * number % 7 for number in range(300_000))
    return process_time() - before


@contextmanager
def within(beats: float) -> Iterator[None]:
    """Fail where what is done takes more than so many beats; there are some 30 in a second."""
    first, before = _beat(), process_time()
    yield
    took = process_time() - before
    assert took < beats * max(first, _beat())
