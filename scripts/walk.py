"""Walk through the modules that a command enters: which, in their order, and from which floor to which.

python scripts/walk.py [COMMAND ...]      by default the three commands below

A module is entered where one of its functions runs; what runs only as it is imported does not count. A
template is no module.
"""

from __future__ import annotations

import io
import os
import sys
import tempfile
from contextlib import redirect_stdout
from pathlib import Path
from types import FrameType
from typing import Any

from tabulate import tabulate

import kurbel
from kurbel.cli import main

PACKAGE = os.path.dirname(os.path.abspath(kurbel.__file__)) + os.sep
WALKS = ("table --ratio 1:5", "delta --eps 4", "handbook build .")
MANIFEST = 'title = "Tafel"\n[[chapter]]\ntitle = "Weg"\n[[chapter.part]]\nrun = "table --ratio 1:5"\n'


class Walk:
    """The modules entered, and the steps from one to another."""

    def __init__(self) -> None:
        self.rooms: dict[str, None] = {}
        self.steps: dict[tuple[str, str], int] = {}

    def __call__(self, frame: FrameType, event: str, argument: Any) -> None:
        if event != "call":
            return
        room = room_of(frame)
        if room is None or is_imported(frame):
            return
        self.rooms.setdefault(room)
        before = frame.f_back
        while before is not None and room_of(before) is None:
            before = before.f_back
        if before is not None and (caller := room_of(before)) not in (None, room):
            step = (str(caller), room)
            self.steps[step] = self.steps.get(step, 0) + 1


def is_imported(frame: FrameType | None) -> bool:
    """Whether this runs because a module of kurbel is imported."""
    while frame is not None:
        if frame.f_code.co_name == "<module>" and room_of(frame):
            return True
        frame = frame.f_back
    return False


def room_of(frame: FrameType) -> str | None:
    path = frame.f_code.co_filename
    if not (path.startswith(PACKAGE) and path.endswith(".py")):
        return None
    return path.removeprefix(PACKAGE).removesuffix(".py")


def walked(words: list[str]) -> Walk:
    """Run a command of the command line and return where it went."""
    walk = Walk()
    sys.argv = ["kurbel", *words]
    with redirect_stdout(io.TextIOWrapper(io.BytesIO(), encoding="utf-8")):
        sys.setprofile(walk)
        try:
            main()
        except SystemExit as end:
            sys.setprofile(None)
            assert end.code == 0, f"kurbel {' '.join(words)} ended with {end.code}"
        finally:
            sys.setprofile(None)
    return walk


def report(commands: list[str]) -> None:
    rows = []
    for command in commands:
        walk = walked(command.split())
        rows.append((f"kurbel {command}", len(walk.rooms), len(walk.steps)))
        print(f"\nkurbel {command}: {', '.join(walk.rooms)}")
    print()
    print(tabulate(rows, ("command", "modules entered", "steps between two"), disable_numparse=True))


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        Path("handbook.toml").write_text(MANIFEST, encoding="utf-8")
        report(sys.argv[1:] or list(WALKS))
