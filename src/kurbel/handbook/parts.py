"""What a build of a handbook is about: the tasks, what they give, and the report."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Literal, NamedTuple

from kurbel.formats.registry import FORMATS
from kurbel.handbook.manifest import Manifest, Part
from kurbel.handbook.model import COMPILED, ENGINES

PDF = COMPILED.name
KILLED = "its process was ended, for want of memory or from outside"
# Templates of one's own have so many seconds for a page, and so much memory.
PATIENCE, GIGABYTES = 10.0, 4
STOPPED = f"its templates were stopped after {PATIENCE:.0f} s, or at {GIGABYTES} gigabytes"
# A document that they wrote has so many to be set by Typst; a TeX is stopped by itself.
PDF_PATIENCE = 300.0
PDF_STOPPED = f"Typst was stopped after {PDF_PATIENCE:.0f} s"


class Task(NamedTuple):
    """A part that is to be made, with all that a process of its own needs to make it.

    Templates of one's own have `patience` in seconds.
    """

    part: Part
    folder: str
    machine: str | None
    templates: str | None
    formats: tuple[str, ...]
    figures: tuple[str, ...]
    patience: float


class Made(NamedTuple):
    """What a part or a document became: its files by their paths in the output folder.

    `inputs` are the files that it was made of, `about` what documents say of a table or figure: its kind,
    caption and language.
    """

    files: Mapping[str, bytes]
    inputs: tuple[str, ...] = ()
    about: tuple[Literal["table", "figure"], str, str] | tuple[()] = ()


# Makes a part, or says in a sentence why it cannot be made.
Maker = Callable[[Task], Made | str]


class Failure(NamedTuple):
    """A part or a document that could not be made."""

    line: int
    name: str
    said: str


@dataclass
class Built:
    """What a build did, file by file, and what failed."""

    written: list[str] = field(default_factory=list)
    unchanged: list[str] = field(default_factory=list)
    removed: list[str] = field(default_factory=list)
    failures: list[Failure] = field(default_factory=list)


def formats_of(manifest: Manifest) -> tuple[str, ...]:
    """Return the formats of the tables: a PDF brings along what it is set from."""
    wanted = manifest.formats
    if PDF in wanted:
        wanted = (*wanted, ENGINES[manifest.engine].source)
    return tuple(name for name in FORMATS if name in wanted and name != PDF)


def task_of(manifest: Manifest, part: Part) -> Task:
    """Return what makes the part."""
    formats = formats_of(manifest)
    # What documents are made of beside their own format.
    figures = tuple(sorted({FORMATS[name].figures for name in formats} - {""}))
    return Task(part, manifest.folder, manifest.machine, manifest.templates, formats, figures, PATIENCE)
