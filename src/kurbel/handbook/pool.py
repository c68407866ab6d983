"""Work across cores, or by the workers of a cluster, each piece by itself: one that kills its process takes
no other along.

Workers need not see the folder of the handbook. What one cannot make, or makes of files that are others than
here, is made on this machine. So is what templates, layouts or constructions of one's own set, which may be
others there.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import closing
from functools import partial
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from kurbel.errors import KurbelError
from kurbel.page.quantity import Letter
from kurbel.reading.environment import HAS_PROCESSES
from kurbel.sweeps.hands import taken
from kurbel.sweeps.versions import LIBRARIES, content_of

if TYPE_CHECKING:
    from kurbel.handbook.manifest import Part

# Fewer pieces than these are done before another process has loaded the libraries.
WORTH_A_PROCESS = 4
# A piece whose process was ended is given to another: what is there of memory is not its fault alone.
TRIES = 2
# What ended the processes of so many pieces will end those of the rest.
MOST_KILLED = 3
KILLED = "its process was ended, for want of memory or from outside"
NOT_TRIED = "not tried, for others like it were stopped"
# Of what no sentence of ours is about.
FAULT = "which is a fault of kurbel: please report it with the command or the text of this part"
LONGEST_FAULT = 300
# A document that templates of one's own wrote has so many to be set by Typst; a TeX is stopped by itself.
PDF_PATIENCE = 300.0
PDF_STOPPED = f"Typst was stopped after {PDF_PATIENCE:.0f} s"


class Task(NamedTuple):
    """A part that is to be made, with all that a process of its own needs to make it.

    `templates` is a folder of one's own. A `terse` caption does not say that formulas are exact, for the page
    on notation does. With `verify` its numbers are computed a second time. Files that the command names may
    lie `outside` of the folder where that is allowed.
    """

    part: Part
    folder: str
    templates: str | None
    machine: str | None
    formats: tuple[str, ...]
    figures: tuple[str, ...]
    terse: bool
    verify: bool
    outside: bool


class Verified(NamedTuple):
    """How many numbers of a table a second computation confirms, of how many."""

    confirmed: int
    cells: int


class ListEntry(NamedTuple):
    """What documents say of a table or a figure; `letters` and `source` are for their lists, `rounding` is
    that of its numbers, and `verified` what a second computation says of them."""

    kind: Literal["table", "figure"]
    caption: str
    lang: str
    letters: tuple[Letter, ...] = ()
    source: str = ""
    rounding: str = ""
    verified: Verified | None = None


class BuiltFiles(NamedTuple):
    """What a part or a document became: its files by their paths in the output folder.

    `inputs` are the files that it was made of.
    """

    files: Mapping[str, bytes]
    inputs: tuple[str, ...] = ()
    about: ListEntry | None = None


class WorkPiece(NamedTuple):
    """A piece of the work: a part, in its line of the manifest, or a document.

    `key` tells what it is made of; `make`, which goes to other processes, raises KurbelError if it cannot.
    With `apart` it is not made in this process. `killed` is said of one whose process ends; `owner` is the
    build that it is of.
    """

    name: str
    key: str
    make: partial[BuiltFiles]
    owner: Any
    line: int = 0
    apart: bool = False
    killed: str = KILLED


# Works pieces by so many processes.
Answer = tuple[WorkPiece, BuiltFiles | str]
Worked = Callable[[Iterable[WorkPiece], int], Iterator[Answer]]


def by_whom(scheduler: str | None) -> Worked:
    """Return what works the pieces: the cluster of a scheduler, or the cores of this machine."""
    return worked if scheduler is None else partial(worked_by, scheduler)


def worked(pieces: Iterable[WorkPiece], jobs: int) -> Iterator[Answer]:
    """Yield each piece with what it became, or a sentence why it became nothing, as they are done."""
    pieces = [*pieces]
    by_themselves = any(piece.apart for piece in pieces) or (jobs > 1 and len(pieces) >= WORTH_A_PROCESS)
    if by_themselves and HAS_PROCESSES:
        yield from _worked_apart(pieces, jobs)
    else:
        for piece in pieces:
            yield piece, tried(piece.make)


def _piece(makes: Sequence[Callable[[], BuiltFiles]], number: int) -> BuiltFiles | str:
    return tried(makes[number])


def tried(make: Callable[[], BuiltFiles]) -> BuiltFiles | str:
    """Return what is made, or why nothing is."""
    try:
        return make()
    except KurbelError as error:
        return str(error)
    except MemoryError:
        return "it needs more memory than there is"
    except Exception as error:
        from traceback import extract_tb

        # A fault of the program costs this piece, and is told; the others know nothing of it.
        said = " ".join(f"{type(error).__name__}: {error}".split())[:LONGEST_FAULT]
        place, line, *_ = extract_tb(error.__traceback__)[-1]
        return f"{said} ({os.path.basename(place)}, line {line}), {FAULT}"


def _worked_apart(pieces: Sequence[WorkPiece], jobs: int) -> Iterator[Answer]:
    # Later than most imports: a handbook without changes needs no processes.
    from kurbel.sweeps.hands import Processes

    def killed(number: int) -> str:
        return pieces[number].killed

    # One at a time to each, or it could not be told which of them ended its process.
    make = partial(_piece, [piece.make for piece in pieces])
    hands = Processes(make, min(jobs, len(pieces)), ahead=1, tries=TRIES, ended=killed)
    left, count = dict(enumerate(pieces)), 0
    with closing(taken(hands, len(pieces))) as done:
        for number, made in done:
            piece = left.pop(number)
            yield piece, made
            count += made == KILLED
            if count == MOST_KILLED:
                break
    for piece in left.values():
        yield piece, NOT_TRIED


# What pages are made by beside numbers.
OF_PAGES = ("jinja2", "markdown-it-py", "tabulate", "matplotlib", "xlsxwriter")


class WorkerResult(NamedTuple):
    """What a worker made, or why it could not, and what the files it was made of are there."""

    made: BuiltFiles | str
    inputs: tuple[str, ...] = ()


def _part(makes: Sequence[partial[BuiltFiles]], number: int) -> WorkerResult:
    # The precision of balls is that of the process.
    from kurbel.exact.certify import BALLS

    with BALLS:
        made = tried(makes[number])
    return WorkerResult(made, () if isinstance(made, str) else _inputs(makes[number], made))


def worked_by(scheduler: str, pieces: Iterable[WorkPiece], jobs: int) -> Iterator[Answer]:
    """Yield each piece with what it became, or a sentence why it became nothing, as they are done.

    Raises KurbelError where the cluster cannot be used.
    """
    from kurbel.sweeps.cluster import Cluster

    here: list[WorkPiece] = []
    there: list[WorkPiece] = []
    for piece in pieces:
        (here if _has_own_pages(piece) else there).append(piece)
    if there:
        makes, name = [*map(_absolute, there)], f"handbook-{os.urandom(8).hex()}"
        cluster = Cluster(scheduler, partial(_part, makes), name, {}, (*LIBRARIES, *OF_PAGES))
        for number, one in taken(cluster, len(there)):
            piece = there[number]
            if isinstance(one.made, str) or one.inputs != _inputs(makes[number], one.made):
                here.append(piece)
            else:
                yield piece, one.made
    yield from worked(here, jobs)


def _has_own_pages(piece: WorkPiece) -> bool:
    task: Task = piece.make.args[0]
    options = task.part.options
    return bool(task.templates or options.get("layouts") or options.get("constructions"))


def _absolute(piece: WorkPiece) -> partial[BuiltFiles]:
    """Return what makes a part, of files in the same folder wherever it is made."""
    task: Task = piece.make.args[0]
    return partial(piece.make.func, task._replace(folder=os.path.abspath(task.folder)))


def _inputs(make: partial[BuiltFiles], made: BuiltFiles) -> tuple[str, ...]:
    folder = make.args[0].folder
    return tuple(content_of(os.path.join(folder, path)) for path in made.inputs)
