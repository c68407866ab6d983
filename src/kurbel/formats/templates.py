"""Templates of a user's folder: what lies in one, a copy of kurbel's own to begin with, and how they run, in
Jinja's sandbox, with errors that name file and line.

They run in a process of their own, which ends where they take too long, and has little memory. One serves all
pages of the process that started it, and ends with it. In a browser, which has no processes, they run in
place.
"""

from __future__ import annotations

import atexit
import json
import os
import pickle
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from tempfile import TemporaryDirectory
from threading import Lock
from time import process_time
from traceback import walk_tb
from typing import Any

from jinja2 import BaseLoader, Environment, TemplateNotFound, TemplateSyntaxError
from jinja2.loaders import split_template_path
from jinja2.sandbox import ImmutableSandboxedEnvironment

from kurbel.errors import KurbelError, LayoutError, OutputError
from kurbel.formats.registry import Format, PageFormat, RecordsFormat, by_name
from kurbel.formats.render import environment_of
from kurbel.page.layouts import layout_file, layout_names, template_folder
from kurbel.reading.environment import HAS_PROCESSES
from kurbel.reading.given import choose
from kurbel.reading.names import did_you_mean

BASE, SUFFIX = "base", ".jinja"
# What is around a page: a document of its own, sliders.
MORE = (["document"], ["steps"])


def has_templates(folder: str) -> bool:
    """Tell whether a user's folder has templates, or files that ours include.

    Raises LayoutError for a folder that is none, and for a template of no page, which would be ignored.
    """
    if not os.path.isdir(folder):
        raise LayoutError(f"there is no folder {folder} with templates")
    own = [place for place in _names("", folder) if os.path.exists(layout_file(folder, place))]
    allowed = {**dict.fromkeys((*layout_names(), *own), page_templates()), BASE: _names(BASE)}
    for place, names in allowed.items():
        for name in _names(place, folder):
            if name.endswith(SUFFIX) and name not in names:
                near = did_you_mean(name, names)
                raise LayoutError(
                    f"{folder}/{place}/{name} is a template of nothing{near}; what others include stands in"
                    " another folder"
                )
    return bool(_names(BASE, folder) or _of_layouts(folder))


def check_layouts(folders: Iterable[str], known: Sequence[str]) -> None:
    """Raise LayoutError for a template whose layout is neither kurbel's nor in one of the known folders."""
    for folder in folders:
        for place, name in _of_layouts(folder):
            if any(os.path.exists(layout_file(one, place)) for one in (template_folder(), *known)):
                continue
            raise LayoutError(
                f"{folder}/{place}/{name} is of no layout{did_you_mean(place, layout_names())}; --layouts"
                " names the folder of one's own"
            )


def _of_layouts(folder: str) -> list[tuple[str, str]]:
    """Return the layouts for which a folder has templates, each with the name of one."""
    pages = page_templates()
    return [
        (place, name)
        for place in _names("", folder)
        if place != BASE
        for name in _names(place, folder)
        if name in pages
    ]


def is_set_by_template(form: Format) -> bool:
    """Tell whether pages in a format are set by a template, its own or that of the format it is made of."""
    return form.kind in ("compiled", "document") or f"{form.name}{SUFFIX}" in _names(BASE)


def page_templates() -> list[str]:
    """Return the names of the templates by which pages are set, not those of whole handbooks."""
    names = {name: name.split(".") for name in _names(BASE) if name.endswith(SUFFIX)}
    formats = {parts[0] for parts in names.values() if len(parts) == 2}
    return [name for name, parts in names.items() if parts[0] in formats and parts[1:-1] in ([], *MORE)]


def copied(name: str, folder: str) -> str:
    """Write the layout of that name, with a copy of the templates of its pages, into a folder of a user's.

    Returns the new folder. Raises ChoiceError for a layout that there is not, OutputError for a folder that
    has it already.
    """
    ours, target = template_folder(), os.path.join(folder, choose(name, layout_names(), "layout"))
    if os.path.lexists(target):
        raise OutputError(f"{target} is there already; name another folder, or remove it")
    try:
        os.makedirs(folder, exist_ok=True)
        with TemporaryDirectory(dir=folder, prefix=f".{name}.") as place:
            made = os.path.join(place, name)
            shutil.copytree(os.path.join(ours, name), made)
            for template in page_templates():
                if not os.path.exists(os.path.join(made, template)):
                    shutil.copyfile(os.path.join(ours, BASE, template), os.path.join(made, template))
            os.rename(made, target)
    except OSError as error:
        raise OutputError(f"cannot write {target}: {error.strerror or error}") from error
    return target


def _names(place: str, folder: str = "") -> list[str]:
    """Return what lies at a place of a folder, by default of ours, nothing where that is no folder."""
    path = os.path.join(folder or template_folder(), place)
    return sorted(os.listdir(path)) if os.path.isdir(path) else []


# Templates of one's own have so many seconds of processor time for a page, and so much memory.
PATIENCE, GIGABYTES = 10.0, 4
_PROGRAM = (
    "import signal, sys; signal.signal(signal.SIGINT, signal.SIG_IGN); sys.path[:] = sys.argv[1:];"
    " from kurbel.formats.templates import serve; serve()"
)
# What is left of the seconds, where several pages are one.
_LEFT: ContextVar[list[float] | None] = ContextVar("left", default=None)


@contextmanager
def one_page() -> Iterator[None]:
    """Have all templates of the block within the time of one page."""
    if _LEFT.get() is not None:
        yield
        return
    token = _LEFT.set([PATIENCE])
    try:
        yield
    finally:
        _LEFT.reset(token)


def filled_apart(form: str, template: str, values: Mapping[str, object], folders: Sequence[str]) -> str:
    """Return what a template of the folders makes of the values for a format.

    Raises LayoutError for whatever is wrong with it, and where it is stopped.
    """
    if not HAS_PROCESSES:
        return filled(form, template, values, folders)
    with one_page():
        left = _LEFT.get()
        assert left is not None
        request = (os.getcwd(), max(left[0], 0.01), GIGABYTES, form, template, values, folders)
        answer = _PROCESS.answer(pickle.dumps(request))
        if answer is None:
            named = " and ".join(folders)
            raise LayoutError(
                f"the templates of {named} were stopped after {PATIENCE:g} s, or at {GIGABYTES} gigabytes"
            )
        text, error, seconds = answer
        left[0] -= seconds
        if error:
            raise LayoutError(error)
        return str(text)


class _Process:
    """The process, which is started where it is needed, and anew where it was ended."""

    def __init__(self) -> None:
        self.process: subprocess.Popen[bytes] | None = None
        self.owner = 0
        self.lock = Lock()

    def answer(self, request: bytes) -> Any:
        """Return what it answers, or None if it was ended."""
        with self.lock:
            process = self._started()
            assert process.stdin is not None and process.stdout is not None
            with suppress(OSError):
                process.stdin.write(len(request).to_bytes(8, "big") + request)
                process.stdin.flush()
                if line := process.stdout.readline():
                    return json.loads(line)
            self.end()
            return None

    def _started(self) -> subprocess.Popen[bytes]:
        # A copy of this process would read answers that are not its own.
        if self.process is None or self.owner != os.getpid():
            self.owner = os.getpid()
            self.process = subprocess.Popen(
                [sys.executable, "-c", _PROGRAM, *sys.path], stdin=subprocess.PIPE, stdout=subprocess.PIPE
            )
            atexit.register(self.end)
        return self.process

    def end(self) -> None:
        """End it; it reads the end of its input."""
        process, self.process = self.process, None
        if process is not None and self.owner == os.getpid():
            atexit.unregister(self.end)
            with suppress(OSError):
                process.communicate()


_PROCESS = _Process()


def serve() -> None:
    """Answer requests until there are no more."""
    requests, answers = sys.stdin.buffer, sys.stdout.buffer
    while size := requests.read(8):
        folder, seconds, gigabytes, *page = pickle.loads(requests.read(int.from_bytes(size, "big")))
        os.chdir(folder)
        text, error, before = "", "", process_time()
        with deadline(seconds, gigabytes):
            try:
                text = filled(*page)
            except KurbelError as found:
                error = str(found)
        answers.write(json.dumps((text, error, process_time() - before)).encode() + b"\n")
        answers.flush()


@contextmanager
def deadline(seconds: float, gigabytes: float | None) -> Iterator[None]:
    """End this process, which is one that was started for this, where the block takes longer.

    Too much memory, if it is limited, is a MemoryError. The seconds are of processor time where the system
    counts it, so that a busy machine ends nothing; either way even a process that is inside of one long
    operation is ended.
    """
    if gigabytes is not None:
        _limit_memory(gigabytes)
    with _processor_watch(seconds) if hasattr(signal, "setitimer") else _clock_watch(seconds):
        yield


@contextmanager
def _processor_watch(seconds: float) -> Iterator[None]:
    signal.signal(signal.SIGPROF, signal.SIG_DFL)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)


@contextmanager
def _clock_watch(seconds: float) -> Iterator[None]:
    import faulthandler

    with open(os.devnull, "w") as nowhere:
        faulthandler.dump_traceback_later(seconds, exit=True, file=nowhere)
        try:
            yield
        finally:
            faulthandler.cancel_dump_traceback_later()


def _limit_memory(gigabytes: float) -> None:
    try:
        import resource
    except ImportError:
        return
    _, hard = resource.getrlimit(resource.RLIMIT_AS)
    most = int(gigabytes * (1 << 30))
    resource.setrlimit(resource.RLIMIT_AS, (most if hard < 0 else min(most, hard), hard))


OURS = "kurbel"
LONGEST_FILE, LONGEST_PAGE = 1_000_000, 10_000_000


def filled(form: str, template: str, values: Mapping[str, object], folders: Sequence[str]) -> str:
    """Return what the template makes of the values for a format.

    Raises LayoutError, with the file and the line, for whatever is wrong with a template of the folders.
    """
    found = by_name(form)
    assert isinstance(found, PageFormat | RecordsFormat)
    try:
        text = environment_of(found, tuple(folders)).get_template(template).render(values)
        if len(text) > LONGEST_PAGE:
            reason = f"the result would have more than {LONGEST_PAGE} characters"
            raise _refused(template, None, reason, folders)
        return text
    except KurbelError:
        raise
    except TemplateSyntaxError as error:
        file = error.filename or error.name or template
        raise _refused(file, error.lineno, error.message, folders) from None
    except Exception as error:
        # Whatever a template does with what it is given, such as 1/0 or "a".b(), is its own mistake.
        place = _place(error, folders) or (template, 0)
        raise _refused(*place, _reason(error), folders) from None


def _reason(error: Exception) -> str:
    if isinstance(error, TemplateNotFound):
        return f"there is no template {error.name}"
    if isinstance(error, RecursionError):
        return "it calls itself without end"
    if isinstance(error, MemoryError):
        return "it needs more memory than there is"
    return str(error) or type(error).__name__


def _place(error: Exception, folders: Sequence[str]) -> tuple[str, int] | None:
    """Return the file and line of a user's template that ran last."""
    found = [(frame.f_code.co_filename, line) for frame, line in walk_tb(error.__traceback__)]
    return next((one for one in reversed(found) if _folder_of(one[0], folders)), None)


def _refused(file: str, line: int | None, reason: str | None, folders: Sequence[str]) -> LayoutError:
    if folder := _folder_of(file, folders):
        file = os.path.join(folder, os.path.relpath(file, os.path.realpath(folder)))
    elif not os.path.isabs(file):
        file = os.path.join(folders[0], file)
    words = " ".join((reason or "it is not understood").split())
    where = f"{file}{f', line {line}' if line else ''}"
    return LayoutError(f"the template {where} cannot be used: {words[:300]}")


def _folder_of(path: str, folders: Sequence[str]) -> str:
    """Return which of the folders a file lies in, nothing if none."""
    return next((folder for folder in folders if _is_within(path, folder)), "")


def _is_within(path: str, folder: str) -> bool:
    return path.startswith(os.path.join(os.path.realpath(folder), ""))


class Loader(BaseLoader):
    """Loads templates from a user's folders, and from ours those that they do not have.

    Behind "kurbel/" a name is that of one of ours: kurbel/base/latex.jinja is what a user's base/latex.jinja
    may extend.
    """

    def __init__(self, folders: Sequence[str], ours: Sequence[str]) -> None:
        self.folders = folders
        self.ours = ours

    def get_source(self, environment: Environment, template: str) -> tuple[str, str, Callable[[], bool]]:
        path = self._path(template)
        found = path, _stamp(path)
        with open(path, encoding="utf-8") as file:
            text = file.read(LONGEST_FILE + 1)
        if len(text) > LONGEST_FILE:
            raise LayoutError(f"the template {path} is longer than {LONGEST_FILE} characters")
        return text, path, lambda: (now := self._path(template), _stamp(now)) == found

    def _path(self, template: str) -> str:
        """Return the file of a template; one outside the folders is refused, however it is reached."""
        parts = split_template_path(template)
        folders = (*self.folders, *self.ours)
        if parts[0] == OURS:
            folders, parts = (*self.ours,), parts[1:]
        for folder in folders:
            path = os.path.realpath(os.path.join(folder, *parts))
            if not os.path.isfile(path):
                continue
            if not _is_within(path, folder):
                raise LayoutError(
                    f"the template {os.path.join(folder, template)} is a link that leads out of {folder}"
                )
            return path
        raise TemplateNotFound(template)


def _stamp(path: str) -> tuple[int, int]:
    status = os.stat(path)
    return status.st_mtime_ns, status.st_size


def _fixed(value: object) -> object:
    """Return what is to be printed; refuse what would be another text every time."""
    if " at 0x" in str(value):
        raise ValueError("it prints an object with its place in memory, which is another one every time")
    return value


class Sandbox(ImmutableSandboxedEnvironment):
    def __init__(self, *args: object, **options: object) -> None:
        super().__init__(*args, finalize=_fixed, **options)
        # They are different every time, and a page is the same for the same values.
        del self.globals["lipsum"], self.filters["random"]
