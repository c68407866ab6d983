"""Pieces of a handbook that end their process, and one that does not; other processes find them by name."""

from __future__ import annotations

import os
import signal
from pathlib import Path

from kurbel.handbook.pool import BuiltFiles


def deadly(once: str = "") -> BuiltFiles:
    """Make a piece that ends its process: always, or if a file is there, which then is gone."""
    if once and not Path(once).exists():
        return harmless()
    if once:
        Path(once).unlink()
    os.kill(os.getpid(), signal.SIGKILL)
    raise AssertionError


def harmless() -> BuiltFiles:
    return BuiltFiles({"x": b"x"})
