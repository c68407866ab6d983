"""The precision of balls, which flint has once for the process: of several threads one computes at a time.

Python's own lock lets one thread into flint at once, too, so that none waits who would not wait anyway.
"""

from __future__ import annotations

import os
from threading import RLock

import flint

BALLS = RLock()
# Those of floats, for what becomes one.
FLOAT_BITS = 53
if hasattr(os, "register_at_fork"):
    # A process that begins while another thread computes would wait for that thread, which it has not.
    os.register_at_fork(before=BALLS.acquire, after_in_parent=BALLS.release, after_in_child=BALLS.release)


class at_bits:
    """Within it balls have so many bits, and no other thread has others.

    An iterator that yields within it is to be run to its end, or left, in one thread.
    """

    __slots__ = ("_before", "_bits")

    def __init__(self, bits: int) -> None:
        self._bits = bits

    def __enter__(self) -> None:
        BALLS.acquire()
        self._before = flint.ctx.prec
        flint.ctx.prec = self._bits

    def __exit__(self, *_: object) -> None:
        flint.ctx.prec = self._before
        BALLS.release()
