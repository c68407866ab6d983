"""Pieces of a handbook made by the workers of a cluster, which need not see its folder.

What a worker cannot make, or makes of files that are others than here, is made on this machine. So is what
templates, layouts or constructions of one's own set, which may be others there.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from functools import partial
from typing import Any, NamedTuple

from kurbel.handbook.inputs import digest_of
from kurbel.handbook.pool import Made, Piece, Task, tried, worked
from kurbel.sweeps.hands import BALLS, taken

# What pages are made by beside numbers.
OF_PAGES = ("jinja2", "markdown-it-py", "tabulate", "matplotlib", "xlsxwriter")


class Elsewhere(NamedTuple):
    """What a worker made, or why it could not, and what the files it was made of are there."""

    made: Made | str
    inputs: tuple[str, ...] = ()


class Parts:
    """The parts by their numbers; it goes to the workers."""

    def __init__(self, pieces: Iterable[Piece]) -> None:
        self.makes = [_absolute(piece) for piece in pieces]

    def __call__(self, number: int) -> Elsewhere:
        make = self.makes[number]
        # The precision of balls is that of the process.
        with BALLS:
            made = tried(make)
        return Elsewhere(made, () if isinstance(made, str) else _inputs(make, made))


def worked_by(scheduler: str, pieces: Iterable[Piece], jobs: int) -> Iterator[tuple[Piece, Made | str]]:
    """Yield each piece with what it became, or a sentence why it became nothing, as they are done.

    Raises KurbelError where the cluster cannot be used.
    """
    from kurbel.sweeps.cluster import Cluster
    from kurbel.sweeps.versions import LIBRARIES

    here: list[Piece] = []
    there: list[Piece] = []
    for piece in pieces:
        (here if _has_own_pages(piece) else there).append(piece)
    if there:
        parts, name = Parts(there), f"handbook-{os.urandom(8).hex()}"
        cluster = Cluster(scheduler, parts, name, {}, (*LIBRARIES, *OF_PAGES))
        for number, one in taken(cluster, len(there)):
            piece = there[number]
            if isinstance(one.made, str) or one.inputs != _inputs(parts.makes[number], one.made):
                here.append(piece)
            else:
                yield piece, one.made
    yield from worked(here, jobs)


def _has_own_pages(piece: Piece) -> bool:
    make: Any = piece.make
    task: Task = make.args[0]
    options = task.part.options
    return bool(task.templates or options.get("layouts") or options.get("constructions"))


def _absolute(piece: Piece) -> partial[Made]:
    """Return what makes a part, of files in the same folder wherever it is made."""
    make: Any = piece.make
    task: Task = make.args[0]
    return partial(make.func, task._replace(folder=os.path.abspath(task.folder)))


def _inputs(make: partial[Made], made: Made) -> tuple[str, ...]:
    folder = make.args[0].folder
    return tuple(digest_of(os.path.join(folder, path)) for path in made.inputs)
