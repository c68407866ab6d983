"""A build of a handbook: tables, figures, documents; only what changed is made anew, nothing is half done."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Collection, Iterable, Mapping
from functools import partial
from typing import Any

from kurbel.errors import HandbookError, KurbelError
from kurbel.formats.registry import FORMATS
from kurbel.handbook.folder import Done, Folder, digest, key_of
from kurbel.handbook.inputs import UNKNOWN, digest_of, fingerprint, glance
from kurbel.handbook.manifest import Manifest, Part
from kurbel.handbook.model import COMPILED, ENGINES
from kurbel.handbook.pages import Failure, document_of, fragment_paths, make_document, make_pdf
from kurbel.handbook.pool import KILLED, PATIENCE, PDF_STOPPED, STOPPED, Made, Piece, Task, worked

PDF = COMPILED.name
# Makes a part; raises KurbelError if it cannot be made.
Maker = Callable[[Task], Made]
# Is given what comes of the steps and how many there are, and passes it on.
Bar = Callable[[Iterable[Any], int], Iterable[Any]]


def build(
    manifest: Manifest,
    folder: Folder,
    make: Maker,
    jobs: int,
    bar: Bar,
    waiting: Callable[[], None] = lambda: None,
) -> Build:
    """Build what changed and return the build, which knows what was done.

    `make` makes a part, perhaps in another process; `bar` sees the parts pass as they are made; `waiting` is
    called if another build of the same folder is under way. Parts that fail are in the report, and the others
    are built. Raises KurbelError where the folder cannot be used.
    """
    with folder.locked(waiting):
        one = Build(manifest, folder)
        one.make_parts(make, jobs, bar)
        one.make_documents()
        one.finish()
        return one


class Build:
    """One build of a manifest into a folder: what it did, file by file, and what failed."""

    def __init__(self, manifest: Manifest, folder: Folder) -> None:
        self.written: list[str] = []
        self.unchanged: list[str] = []
        self.removed: list[str] = []
        self.failures: list[Failure] = []
        self.manifest = manifest
        self.folder = folder
        self.old = folder.state()
        self.new: dict[str, Done] = {}
        self.started = time.time_ns()
        self.templates = manifest.templates and os.path.join(manifest.folder, manifest.templates)
        if self.templates and not os.path.isdir(self.templates):
            raise HandbookError(f"{manifest.path}: there is no folder {self.templates} with templates")
        # Beside a layout there may be templates of its own.
        self.apart = manifest.templates is not None or manifest.layouts is not None
        self.print = key_of(fingerprint(), self.templates and digest_of(self.templates))
        # A PDF brings along what it is set from.
        source = {ENGINES[manifest.pdf.engine].source} if PDF in manifest.formats else set()
        self.formats = tuple(name for name in FORMATS if name in {*manifest.formats, *source} - {PDF})
        # What documents are made of beside their own format.
        self.figures = tuple(sorted({FORMATS[name].figures for name in self.formats} - {""}))

    def part_key(self, part: Part) -> str:
        machine = self.manifest.machine
        return key_of(self.print, part._replace(line=0), machine, self.formats, self.figures)

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
            or any(digest_of(self.input(path)) != hashed for path, hashed in done.inputs.items())
            or not all(self.folder.has(path, hashed) for path, hashed in done.files.items())
        ):
            return False
        self.new[name] = done
        return True

    def input(self, path: str) -> str:
        return os.path.join(self.manifest.folder, path)

    def make_parts(self, make: Maker, jobs: int, bar: Bar) -> None:
        given = self.manifest.folder, self.manifest.machine, self.templates, self.formats, self.figures
        pieces = [
            Piece(part.name, key, partial(make, Task(part, *given, PATIENCE)), part.line)
            for part in self.manifest.parts()
            if part.words and not self.is_made(part.name, key := self.part_key(part))
        ]
        made = worked(pieces, jobs, self.apart, STOPPED if self.apart else KILLED)
        self.take(bar(made, len(pieces)))

    def take(self, made: Iterable[tuple[Piece, Made | str]]) -> None:
        """Write what was made of parts or documents, or note what kept them from being made."""
        for piece, one in made:
            try:
                if isinstance(one, str):
                    raise HandbookError(one)
                for path, content in one.files.items():
                    if self.folder.write(path, content):
                        self.written.append(path)
            except KurbelError as error:
                self.fail(piece.name, str(error), piece.line)
                continue
            files = {path: digest(content) for path, content in one.files.items()}
            inputs = {path: self.hash_of_input(path) for path in one.inputs}
            self.new[piece.name] = Done(piece.key, inputs, files, one.about)

    def hash_of_input(self, path: str) -> str:
        """Return the hash of a file that a part was made of, or nothing if it was saved since.

        Then nobody knows which of the two the part was made of, and the next build makes it anew.
        """
        saved = max(time for time, _ in glance(self.input(path)).values())
        return digest_of(self.input(path)) if saved < self.started else UNKNOWN

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
        files = _hashes(self.new)
        # Of earlier builds, also of those on another machine.
        for path, hashed in (self.folder.contents() | _hashes(self.old)).items():
            # What somebody changed by hand is not ours to remove.
            if path not in files and self.folder.has(path, hashed):
                self.folder.remove(path)
                self.removed.append(path)
        self.folder.list_contents(files)
        self.folder.keep_state(self.new)
        self.unchanged += files.keys() - {*self.written}

    def make_documents(self) -> None:
        """Make the documents whose contents changed, from the parts as they are now."""
        made = {name: done.about for name, done in self.new.items() if done.about}
        document = document_of(self.manifest, made, self.failures)
        content, hashes = key_of(document), _hashes(self.new)
        pieces = []
        for name in (name for name in self.formats if FORMATS[name].figures):
            paths = fragment_paths(document, name)
            key = key_of(self.print, name, content, {path: hashes.get(path) for path in paths.values()})
            if self.is_made(_named(name), key):
                continue
            read = self.read(_named(name), [*paths.values()])
            if read is not None:
                # Drawings in PDF are files beside the document and no text.
                texts = {stem: read[path].decode("utf-8", "replace") for stem, path in paths.items()}
                work = partial(make_document, document, name, texts, self.templates)
                pieces.append(Piece(_named(name), key, work))
        self.take(worked(pieces, 1, self.apart, STOPPED))
        if PDF in self.manifest.formats:
            self.make_pdf()

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

    def make_pdf(self) -> None:
        """Set the PDF if anything that it is made of changed."""
        engine, standards = self.manifest.pdf.engine, self.manifest.pdf.standards
        source, name = _named(ENGINES[engine].source), _named(PDF)
        if source not in self.new or any(failure.name == source for failure in self.failures):
            self.keep(name)
            return
        hashes = _hashes(self.new)
        used = {path: hashes[path] for path in hashes if path.endswith(ENGINES[engine].suffixes)}
        key = key_of(
            self.print, engine, standards, os.environ.get("SOURCE_DATE_EPOCH"), _program(engine), used
        )
        if self.is_made(name, key) or self.read(name, used) is None:
            return
        work = partial(make_pdf, self.folder.path, engine, standards, self.apart)
        # Typst takes much memory to set many pages, in a process of its own. A TeX is one by itself, and is
        # ended by whoever started it: the end of this build must reach it.
        stopped = PDF_STOPPED if self.apart else KILLED
        self.take(worked([Piece(name, key, work)], 1, ENGINES[engine].grows, stopped))


def _hashes(state: Mapping[str, Done]) -> dict[str, str]:
    return {path: hashed for done in state.values() for path, hashed in done.files.items()}


def _named(name: str) -> str:
    """Return under which name the state has a document: no part can be called so."""
    return f"document in {name}"


def _program(engine: str) -> list[Any]:
    """Return what tells a TeX from another: its program, not its packages. The fingerprint tells a Typst."""
    import shutil

    path = shutil.which(engine)
    return [] if path is None else [path, os.stat(path).st_mtime_ns]
