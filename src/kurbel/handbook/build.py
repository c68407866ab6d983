"""A build of a handbook: tables, figures, documents; only what changed is made anew, nothing is half done."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from kurbel.errors import HandbookError, KurbelError
from kurbel.formats.registry import FORMATS
from kurbel.handbook.folder import Folder, digest
from kurbel.handbook.manifest import Manifest, Part
from kurbel.handbook.model import ENGINES
from kurbel.handbook.pages import (
    KILLED,
    PDF,
    PDF_STOPPED,
    STOPPED,
    Built,
    Entry,
    Failure,
    Made,
    Maker,
    PageTask,
    PdfTask,
    PlannedChapter,
    document_of,
    entry_of_text,
    formats_of,
    fragment_paths,
    make_document,
    make_pdf,
    task_of,
)
from kurbel.handbook.pool import Killed, worked
from kurbel.handbook.state import (
    CONTENTS,
    UNKNOWN,
    Done,
    contents_in,
    contents_of,
    digest_of,
    fingerprint,
    is_fresh,
    key_of,
    latest_change,
    read_state,
    write_state,
)

if TYPE_CHECKING:
    from kurbel.documents.document import Document


def build(
    manifest: Manifest,
    folder: Folder,
    make: Maker,
    jobs: int,
    start: Callable[[int], Callable[[], None]] = lambda count: lambda: None,
    waiting: Callable[[], None] = lambda: None,
) -> Built:
    """Build what changed and return what was done.

    `make` makes a part, perhaps in another process; `start` is told how many steps there are and returns what
    is called after each; `waiting` is called if another build of the same folder is under way. Parts that
    fail are in the report, and the others are built. Raises KurbelError where the folder cannot be used.
    """
    with folder.locked(waiting):
        one = Build(manifest, folder, make, jobs)
        parts = [*one.stale()]
        step = start(len(parts))
        one.make_parts(parts, step)
        one.make_documents()
        return one.finish()


class Build:
    """One build of a manifest into a folder."""

    def __init__(self, manifest: Manifest, folder: Folder, make: Maker, jobs: int) -> None:
        self.manifest = manifest
        self.folder = folder
        self.make = make
        self.jobs = jobs
        self.old = read_state(folder)
        self.new: dict[str, Done] = {}
        self.built = Built()
        self.started = time.time_ns()
        base = manifest.folder
        self.formats = formats_of(manifest)
        self.templates = manifest.templates and os.path.join(base, manifest.templates)
        if self.templates and not os.path.isdir(self.templates):
            raise HandbookError(f"{manifest.path}: there is no folder {self.templates} with templates")
        # Beside a layout there may be templates of its own.
        self.apart = manifest.templates is not None or manifest.layouts is not None
        self.print = key_of(fingerprint(), self.templates and digest_of(self.templates))

    def part_key(self, part: Part) -> str:
        task = task_of(self.manifest, part)
        return key_of(self.print, part._replace(line=0), task.machine, task.formats, task.figures)

    def stale(self) -> Iterator[Part]:
        """Yield the parts that must be made; the others count as made."""
        for part in self.manifest.parts():
            if part.words and not self.is_made(part.name, self.part_key(part)):
                yield part

    def is_made(self, name: str, key: str) -> bool:
        """Tell whether it lies there as it would be made again; then it counts as made."""
        done = self.old.get(name)
        if done is None or not is_fresh(done, key, self.manifest.folder, self.folder):
            return False
        self.new[name] = done
        return True

    def novelty(self, part: Part) -> str:
        """Return in a word why a part must be made."""
        return "changed" if part.name in self.old else "new"

    def make_parts(self, parts: Sequence[Part], step: Callable[[], None]) -> None:
        tasks = [task_of(self.manifest, part) for part in parts]
        for task, made in worked(self.make, tasks, self.jobs, apart=self.apart):
            step()
            self.take(task.part.name, self.part_key(task.part), made, STOPPED, task.part.line)

    def take(self, name: str, key: str, made: Made | str | Killed, stopped: str, line: int = 0) -> None:
        """Write what was made of a part or a document, or note what kept it from being made."""
        if isinstance(made, Killed) and not made.tried:
            made = "not tried, for others like it were stopped"
        elif isinstance(made, Killed):
            made = stopped if self.apart else KILLED
        if isinstance(made, str):
            self.fail(line, name, made)
            return
        try:
            files = self.write(made.files)
        except KurbelError as error:
            self.fail(line, name, str(error))
            return
        inputs = {path: self.hash_of_input(path) for path in made.inputs}
        self.new[name] = Done(key, inputs, files, made.about)

    def hash_of_input(self, path: str) -> str:
        """Return the hash of a file that a part was made of, or nothing if it was saved since.

        Then nobody knows which of the two the part was made of, and the next build makes it anew.
        """
        whole = os.path.join(self.manifest.folder, path)
        return digest_of(whole) if latest_change(whole) < self.started else UNKNOWN

    def write(self, files: Mapping[str, bytes]) -> dict[str, str]:
        """Write the files and return their hashes."""
        for path, content in files.items():
            changed = self.folder.write(path, content)
            (self.built.written if changed else self.built.unchanged).append(path)
        return {path: digest(content) for path, content in files.items()}

    def fail(self, line: int, name: str, said: str) -> None:
        """Note what failed; what an earlier build made of it stays."""
        self.built.failures.append(Failure(line, name, said))
        self.keep(name)

    def keep(self, name: str) -> None:
        """Leave what an earlier build made as it is."""
        if name in self.old:
            self.new[name] = self.old[name]

    def finish(self) -> Built:
        """Remove what is no longer built, and keep what this build knows for the next."""
        files = self.hashes()
        # Of earlier builds, also of those on another machine.
        left_behind = contents_in(self.folder) | _hashes(self.old)
        for path, hashed in left_behind.items():
            # What somebody changed by hand is not ours to remove.
            if path not in files and self.folder.has(path, hashed):
                self.folder.remove(path)
                self.built.removed.append(path)
        self.folder.write(CONTENTS, contents_of(files))
        write_state(self.folder, self.new)
        touched = {*self.built.written, *self.built.unchanged}
        self.built.unchanged += [path for path in files if path not in touched]
        return self.built

    def planned(self) -> list[PlannedChapter]:
        """Return the chapters with what their parts have become."""
        names = [plan.name for plan in self.manifest.chapters]
        names += [part.name for part in self.manifest.parts() if part.words]
        return [
            PlannedChapter(plan, tuple(self.entry(part, names) for part in plan.parts))
            for plan in self.manifest.chapters
        ]

    def entry(self, part: Part, names: Sequence[str]) -> Entry:
        if not part.words:
            entry = entry_of_text(self.manifest, part, names)
            if entry.said:
                self.built.failures.append(Failure(part.line, part.file or "text", entry.said))
            return entry
        if part.name in self.new:
            return Entry(part, about=self.new[part.name].about)
        said = next(failure.said for failure in self.built.failures if failure.name == part.name)
        return Entry(part, said=said)

    def make_documents(self) -> None:
        """Make the documents whose contents changed, from the parts as they are now."""
        chapters = self.planned()
        keys = {name: self.stale_key(name, chapters) for name in self.formats if FORMATS[name].figures}
        stale = {name: key for name, key in keys.items() if key is not None}
        if stale:
            document = document_of(self.manifest, chapters)
            tasks = [*self.page_tasks(document, chapters, stale)]
            for task, made in worked(make_document, tasks, 1, apart=self.apart):
                self.take(_named(task.format), stale[task.format], made, STOPPED)
        if PDF in self.manifest.formats:
            self.make_pdf()

    def stale_key(self, name: str, chapters: Sequence[PlannedChapter]) -> str | None:
        """Return the key of a document that must be made; one that need not be counts as made."""
        hashes = self.hashes()
        used = {path: hashes.get(path, "") for path in fragment_paths(chapters, name).values()}
        head = self.manifest._replace(path="", chapters=())
        key = key_of(self.print, name, head, _raw(chapters), used)
        return None if self.is_made(_named(name), key) else key

    def hashes(self) -> dict[str, str]:
        """Return all files made so far with their hashes."""
        return _hashes(self.new)

    def page_tasks(
        self, document: Document, chapters: Sequence[PlannedChapter], names: Iterable[str]
    ) -> Iterator[PageTask]:
        """Yield the documents that can be made."""
        for name in names:
            paths = fragment_paths(chapters, name)
            read = self.read(_named(name), paths.values())
            if read is not None:
                # Drawings in PDF are files beside the document and no text.
                texts = {stem: read[path].decode("utf-8", "replace") for stem, path in paths.items()}
                yield PageTask(name, document, texts, self.templates)

    def read(self, name: str, paths: Iterable[str]) -> dict[str, bytes] | None:
        """Return what a document is made of; it fails where a file is no longer what was made."""
        hashes = self.hashes()
        try:
            return {path: self.folder.made(path, hashes[path]) for path in paths}
        except KurbelError as error:
            self.fail(0, name, str(error))
            return None

    def make_pdf(self) -> None:
        """Set the PDF if anything that it is made of changed."""
        engine, standards = self.manifest.engine, self.manifest.standards
        source = _named(ENGINES[engine].source)
        if source not in self.new or any(failure.name == source for failure in self.built.failures):
            self.keep(_named(PDF))
            return
        hashes = self.hashes()
        used = {path: hashes[path] for path in hashes if path.endswith(ENGINES[engine].suffixes)}
        key = key_of(
            self.print, engine, standards, os.environ.get("SOURCE_DATE_EPOCH"), _program(engine), used
        )
        if self.is_made(_named(PDF), key):
            return
        if self.read(_named(PDF), used) is None:
            return
        task = PdfTask(self.folder.path, engine, standards, self.apart)
        # Typst takes much memory to set many pages, in a process of its own. A TeX is one by itself, and is
        # ended by whoever started it: the end of this build must reach it.
        apart = ENGINES[engine].grows
        for _, made in worked(make_pdf, [task], 1, apart=apart):
            self.take(_named(PDF), key, made, PDF_STOPPED)


def _hashes(state: Mapping[str, Done]) -> dict[str, str]:
    return {path: hashed for done in state.values() for path, hashed in done.files.items()}


def _named(name: str) -> str:
    """Return under which name the state has a document: no part can be called so."""
    return f"document in {name}"


def _raw(chapters: Sequence[PlannedChapter]) -> list[Any]:
    return [
        (plan._replace(parts=()), [(*entry[1:], entry.part.name, entry.part.options) for entry in entries])
        for plan, entries in chapters
    ]


def _program(engine: str) -> list[Any]:
    """Return what tells a TeX from another: its program, not its packages. The fingerprint tells a Typst."""
    import shutil

    path = shutil.which(engine)
    return [] if path is None else [path, os.stat(path).st_mtime_ns]
