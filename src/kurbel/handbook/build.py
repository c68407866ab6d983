"""A build of a handbook: tables, figures, documents; only what changed is made anew, nothing is half done."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from functools import cached_property, partial
from typing import NamedTuple

from kurbel.errors import ChoiceError, HandbookError, KurbelError
from kurbel.formats.registry import FORMATS, BytesFormat
from kurbel.handbook.folder import UNKNOWN, BuiltPart, Folder, digest, fingerprint, glance, is_own, key_of
from kurbel.handbook.manifest import Manifest, Part
from kurbel.handbook.model import COMPILED
from kurbel.handbook.pages import Failure, document_of, fragment_paths, make_document, make_pdf
from kurbel.handbook.pool import KILLED, PDF_STOPPED, Answer, BuiltFiles, Task, Worked, WorkPiece, worked
from kurbel.reading.given import check_inside, is_inside
from kurbel.reading.names import did_you_mean
from kurbel.sweeps.versions import content_of

PDF = COMPILED.name
WAITING = "another build of this handbook is under way; waiting for its end"
# Makes a part; raises KurbelError if it cannot be made.
Maker = Callable[[Task], BuiltFiles]
# Is given what comes of the steps and how many there are, and passes it on.
Bar = Callable[[Iterator[Answer], int], Iterable[Answer]]


class Handbook(NamedTuple):
    """A manifest, its folder as it was named, and the folder that it is built into.

    `names` are what is asked for, and `only` the parts that have them; None is all.
    """

    given: str
    manifest: Manifest
    folder: Folder
    names: tuple[str, ...] = ()
    only: frozenset[str] | None = None


def build(
    handbooks: Sequence[Handbook],
    make: Maker,
    jobs: int,
    bar: Bar,
    tell: Callable[[str], None] = lambda _: None,
    by: Worked = worked,
) -> list[Build]:
    """Build what changed and return the builds, which know what was done.

    `make` makes a part, perhaps in another process, `by` whom it is worked; `bar` sees the parts pass as they
    are made; `tell` is told what is worth a word before it begins. Parts that fail are in the report of their
    build, and the others are built; a folder that cannot be used ends its own build alone.
    """
    builds = [Build(one.manifest, one.folder, one.only) for one in handbooks]
    with ExitStack() as held:
        # In the same order always, or two builds would wait for one another.
        for one in sorted(builds, key=lambda one: os.path.realpath(one.folder.path)):
            with one.ending():
                held.enter_context(one.folder.locked(partial(tell, WAITING)))
        _work(builds, lambda one: one.parts(make), jobs, bar, by)
        for one in builds:
            _work([one], Build.documents)
        # Typst takes much memory to set many pages, in a process of its own.
        _work(builds, lambda one: one.pdf(tell), jobs)
        for one in builds:
            if not one.ended:
                with one.ending():
                    one.finish()
    return builds


def _work(
    builds: Iterable[Build],
    pieces: Callable[[Build], list[WorkPiece]],
    jobs: int = 1,
    bar: Bar = lambda steps, _: steps,
    by: Worked = worked,
) -> None:
    """Have the pieces of the builds worked, and give each build its own."""
    work: list[WorkPiece] = []
    for one in builds:
        if not one.ended:
            with one.ending():
                work += pieces(one)
    for piece, made in bar(by(work, jobs), len(work)):
        piece.owner.take(piece, made)


class Build:
    """One build of a manifest into a folder: what it did, file by file, what failed, and what ended it.

    With names of parts in `only` nothing but these is made, no document, and all else stays as it is.
    """

    def __init__(self, manifest: Manifest, folder: Folder, only: Collection[str] | None = None) -> None:
        self.written: list[str] = []
        self.unchanged: list[str] = []
        self.removed: list[str] = []
        self.failures: list[Failure] = []
        self.ended: KurbelError | None = None
        self.manifest = manifest
        self.folder = folder
        self.only = only
        self.new: dict[str, BuiltPart] = {}
        self.started = time.time_ns()
        self.templates = manifest.templates and os.path.join(manifest.folder, manifest.templates)
        # Beside a layout there may be templates of its own.
        self.apart = manifest.templates is not None or manifest.layouts is not None
        # A PDF brings along what it is set from.
        source = {COMPILED.source} if PDF in manifest.formats else set()
        self.formats = tuple(name for name in FORMATS if name in {*manifest.formats, *source} - {PDF})
        # What documents are made of beside their own format.
        figures = tuple(sorted({FORMATS[name].figures for name in self.formats} - {""}))
        self.given = manifest.machine, self.formats, figures, "notation" in manifest.matter, manifest.verify
        self.outside = manifest.outside

    @cached_property
    def old(self) -> dict[str, BuiltPart]:
        """What the last build made; it is read once the folder is locked."""
        return self.folder.state()

    @cached_property
    def print(self) -> str:
        """What tells the programs and templates by which all is made from others."""
        if self.templates and not os.path.isdir(self.templates):
            raise HandbookError(f"{self.manifest.path}: there is no folder {self.templates} with templates")
        if self.templates and not self.outside:
            check_inside(self.templates, self.manifest.folder, self.templates)
        return key_of(fingerprint(), self.templates and content_of(self.templates))

    @contextmanager
    def ending(self) -> Iterator[None]:
        """Note what ends this build in the block, which ends no other one."""
        try:
            yield
        except KurbelError as error:
            self.ended = error

    def part_key(self, part: Part) -> str:
        return key_of(self.print, part._replace(line=0), *self.given)

    def novelty(self, part: Part) -> str:
        """Return in a word why a part must be made, or that it need not be."""
        if self.is_made(part.name, self.part_key(part)):
            return "unchanged"
        return "changed" if part.name in self.old else "new"

    def is_made(self, name: str, key: str) -> bool:
        """Tell whether it lies there as it would be made again; then it counts as made."""
        done = self.old.get(name)
        if (
            done is None
            or done.key != key
            or any(self.is_other(path, hashed) for path, hashed in done.inputs.items())
            or not all(self.folder.has(path, hashed) for path, hashed in done.files.items())
        ):
            return False
        self.new[name] = done
        return True

    def is_other(self, path: str, hashed: str) -> bool:
        """Tell whether an input is not what it was, or may be read no longer."""
        file = self.input(path)
        return content_of(file) != hashed or not (self.outside or is_inside(file, self.manifest.folder))

    def input(self, path: str) -> str:
        return os.path.join(self.manifest.folder, path)

    def parts(self, make: Maker) -> list[WorkPiece]:
        """Return the parts that `make` must make."""
        given = self.manifest.folder, self.templates, *self.given, self.outside
        return [
            WorkPiece(part.name, key, partial(make, Task(part, *given)), self, part.line)
            for part in self.manifest.parts()
            if part.words
            and (self.only is None or part.name in self.only)
            and not self.is_made(part.name, key := self.part_key(part))
        ]

    def take(self, piece: WorkPiece, one: BuiltFiles | str) -> None:
        """Write what was made of a part or a document, or note what kept it from being made."""
        try:
            if isinstance(one, str):
                raise HandbookError(one)
            for path, content in one.files.items():
                if self.folder.write(path, content) and not is_own(path):
                    self.written.append(path)
        except KurbelError as error:
            self.fail(piece.name, str(error), piece.line)
            return
        files = {path: digest(content) for path, content in one.files.items()}
        inputs = {path: self.hash_of_input(path) for path in one.inputs}
        self.new[piece.name] = BuiltPart(piece.key, inputs, files, one.about)

    def hash_of_input(self, path: str) -> str:
        """Return the hash of a file that a part was made of, or nothing if it was saved since.

        Then nobody knows which of the two the part was made of, and the next build makes it anew.
        """
        saved = max(time for time, _ in glance(self.input(path)).values())
        return content_of(self.input(path)) if saved < self.started else UNKNOWN

    def fail(self, name: str, said: str, line: int = 0) -> None:
        """Note what failed; what an earlier build made of it stays."""
        self.failures.append(Failure(line, name, said))
        self.keep(name)

    def keep(self, name: str) -> None:
        """Leave what an earlier build made as it is."""
        if name in self.old:
            self.new[name] = self.old[name]

    def finish(self) -> None:
        """Remove what is no longer built, and keep what this build knows for the next."""
        # Of earlier builds, also of those on another machine.
        earlier, files = self.folder.contents() | _hashes(self.old), _hashes(self.new)
        self.unchanged += [path for path in files.keys() - {*self.written} if not is_own(path)]
        if self.only is not None:
            self.new, files = self.old | self.new, earlier | files
        for path, hashed in earlier.items():
            # What somebody changed by hand is not ours to remove.
            if path not in files and self.folder.has(path, hashed):
                self.folder.remove(path)
                self.removed += [] if is_own(path) else [path]
        self.folder.list_contents(files)
        self.folder.keep_state(self.new)

    def documents(self) -> list[WorkPiece]:
        """Return the documents whose contents changed, of the parts as they are now."""
        if self.only is not None:
            return []
        made = {name: done.about for name, done in self.new.items() if done.about}
        document = document_of(self.manifest, made, self.failures)
        content, hashes, epoch = key_of(document), _hashes(self.new), os.environ.get("SOURCE_DATE_EPOCH")
        pieces = []
        for name in (name for name in self.formats if FORMATS[name].figures):
            paths = fragment_paths(document, name)
            dated = epoch if isinstance(FORMATS[name], BytesFormat) else None
            used = {path: hashes.get(path) for path in paths.values()}
            key = key_of(self.print, name, content, used, *([dated] if dated else []))
            if self.is_made(_named(name), key):
                continue
            read = self.read(_named(name), [*paths.values()])
            if read is not None:
                contents = {stem: read[path] for stem, path in paths.items()}
                work = partial(make_document, document, name, contents, self.templates)
                pieces.append(WorkPiece(_named(name), key, work, self))
        return pieces

    def read(self, name: str, paths: Collection[str]) -> dict[str, bytes] | None:
        """Return what a document is made of; it fails where a file is no longer what was made."""
        hashes, read = _hashes(self.new), {}
        try:
            for path in paths:
                if path not in hashes:
                    # Its part failed, and an earlier build made it in other formats only.
                    raise HandbookError(f"{path} could not be made")
                content = self.folder.read(path)
                if content is None or digest(content) != hashes[path]:
                    raise HandbookError(
                        f"{path} was changed or removed while the handbook was built; build it again"
                    )
                read[path] = content
        except KurbelError as error:
            self.fail(name, str(error))
            return None
        return read

    def pdf(self, tell: Callable[[str], None]) -> list[WorkPiece]:
        """Return the PDF if anything that it is made of changed."""
        if PDF not in self.manifest.formats or self.only is not None:
            return []
        standards = self.manifest.pdf.standards
        source, name = _named(COMPILED.source), _named(PDF)
        if source not in self.new or any(failure.name == source for failure in self.failures):
            self.keep(name)
            return []
        hashes = _hashes(self.new)
        # In order: they were made in any.
        used = {path: hashes[path] for path in sorted(hashes) if path.endswith(COMPILED.sources)}
        key = key_of(self.print, standards, os.environ.get("SOURCE_DATE_EPOCH"), used)
        if self.is_made(name, key) or (read := self.read(name, used)) is None:
            return []
        cells = sum(content.count(b"[") for content in read.values())
        for remark in COMPILED.writer.remarks(cells, len(read)):
            tell(f"{self.folder.path}: {remark}")
        work = partial(make_pdf, self.folder.path, standards, self.apart)
        killed = PDF_STOPPED if self.apart else KILLED
        return [WorkPiece(name, key, work, self, 0, True, killed)]


def _hashes(state: Mapping[str, BuiltPart]) -> dict[str, str]:
    return {path: hashed for done in state.values() for path, hashed in done.files.items()}


def _named(name: str) -> str:
    """Return under which name the state has a document: no part can be called so."""
    return f"document in {name}"


def part_from(one: Handbook, others: Iterable[Handbook]) -> None:
    """Raise HandbookError if another is built into the same folder: each would remove the other's files."""
    for other in others:
        if os.path.realpath(other.folder.path) == os.path.realpath(one.folder.path):
            raise HandbookError(
                f"{one.manifest.path} and {other.manifest.path} are both built into {one.folder.path};"
                ' give one of them another folder with output = "..."'
            )


def chosen(handbooks: Sequence[Handbook], names: Sequence[str]) -> list[Handbook]:
    """Return the handbooks which have something of these names, and that only; without names all of them."""
    if not names:
        return [*handbooks]
    known = [_parts(one.manifest) for one in handbooks]
    for name in names:
        if not any(name in parts for parts in known):
            near = did_you_mean(name, [one for parts in known for one in parts])
            raise ChoiceError(
                f'--only: there is no table, figure or chapter "{name[:60]}"{near}; kurbel handbook list'
                " names them"
            )
    found = [
        (one, parts, tuple(filter(parts.__contains__, names)))
        for one, parts in zip(handbooks, known, strict=True)
    ]
    return [
        one._replace(names=own, only=frozenset().union(*(parts[name] for name in own)))
        for one, parts, own in found
        if own
    ]


def _parts(manifest: Manifest) -> Mapping[str, frozenset[str]]:
    """Return tables and figures by their names, and those of a chapter by its own, if no other has that."""
    own = {part.name: frozenset((part.name,)) for part in manifest.parts() if part.words}
    return {
        chapter.name: frozenset(part.name for part in chapter.parts if part.words)
        for chapter in manifest.chapters
    } | own
