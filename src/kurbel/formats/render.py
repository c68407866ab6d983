"""From a table to text in a format, and to a file, by Jinja: templates only arrange.

A format that is written without templates saves the first table on a terminal the third of its time that
loading Jinja takes. A file is written whole or not at all: into a temporary file beside the target, renamed
at the end. That has no name where the system knows such files, and nothing is left of a killed run; elsewhere
it is locked while it is written, and the next run removes what has no lock.
"""

from __future__ import annotations

import os
import re
import stat
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext, suppress
from functools import cache, partial
from importlib.util import cache_from_source
from typing import TYPE_CHECKING, BinaryIO, TypeAlias

from kurbel.errors import ChoiceError, OutputError
from kurbel.formats.page import blank, page
from kurbel.formats.registry import BytesFormat, PageFormat, RecordsFormat, by_name
from kurbel.formats.writer import WriteOptions
from kurbel.page import labels
from kurbel.page.layouts import template_folder
from kurbel.page.table import Table

if TYPE_CHECKING:
    from pathlib import Path

    from jinja2 import BytecodeCache, Environment

    from kurbel.formats.writer import Place

# Folders of a user's, the first outdoes the others.
Folders: TypeAlias = tuple[str, ...]
_LEFT_OVER = r"\..*\.[0-9a-f]{12}\.part"
# Where opened files are found by their numbers.
_OPENED = "/proc/self/fd"


def render(
    table: Table,
    format: str,
    *,
    decimal: str | None = None,
    standalone: bool = False,
    longtable: bool = False,
    siunitx: bool = False,
    plain: bool = False,
    excel: bool = False,
    width: int | None = None,
    templates: str | None = None,
    colours: bool = False,
    place: Place = "",
) -> str:
    """Return the table as text in the named format.

    `decimal` is "comma" or "point"; by default it follows the language of the table, and is a point in CSV
    and JSON. `standalone` makes a document of what is otherwise a fragment, in the formats that have
    documents; `longtable` lets a table break over pages, in the formats where it would not, and `siunitx`
    leaves its numbers to that package, and `plain` is what an author would type, in LaTeX. With `excel` CSV
    is as Excel opens it: with a byte order mark, the decimal mark of the language, and no ratio that would be
    a time. JSON has only points. Plain text is fitted into `width` characters; with `colours` it has verdicts
    in the colours of terminals. HTML is for a `place` other than a document of the author's.

    `templates` is a folder whose templates outdo ours of the same names; by default it is the one that the
    table's layout lies in, if that is the user's. They run in a sandbox; one that cannot be used is a
    LayoutError with its line.
    """
    form, folders = by_name(format), folders_of(templates, *table.templates)
    if isinstance(form, RecordsFormat):
        form = form.for_excel if excel else form
        return "".join(form.writer.rows(table, form.decimal_name(table.lang, decimal), folders))
    if not isinstance(form, PageFormat):
        assert isinstance(form, BytesFormat)
        raise ChoiceError(form.no_text.format(name=form.name))
    mark, writer = form.decimal_mark(table.lang, decimal), form.writer
    place = "document" if standalone else place
    stepped = table.steps is not None and "interactive" in form.takes
    if stepped:
        place = place or "step"
    ready = page(table, writer, mark)
    wishes = WriteOptions(longtable, siunitx, plain, width, colours, place)
    values = {"page": ready, **writer.values(table, ready, mark, wishes)}

    def filled(name: str, more: dict[str, object]) -> str:
        return filled_by(form, template_of(table, name, folders), values | more, folders)

    fragment = filled(form.name, {})
    if stepped:
        set_page = partial(render, format=format, decimal=decimal, templates=templates, place=place)
        with as_one_page(folders):
            around = writer.stepped(table, fragment, set_page, mark, place)
            fragment = filled(f"{form.name}.steps", around)
    if standalone and "standalone" in form.takes:
        title = writer.escape(labels.plain(table.caption, mark))
        return filled(f"{form.name}.document", {"fragment": fragment, "title": title})
    return fragment


def in_notebook(table: Table) -> str:
    """Return the table as HTML with the look of a page of its own, to stand among the cells of a notebook."""
    form = by_name("html")
    assert isinstance(form, PageFormat)
    fragment = render(table, form.name, place="document")
    return filled_by(form, "base/html.notebook.jinja", {"fragment": fragment}, ())


def as_one_page(folders: Folders | str | None) -> AbstractContextManager[None]:
    """Have the templates of a user's within the time of one page for all of it."""
    if not folders:
        return nullcontext()
    from kurbel.formats.templates import one_page

    return one_page()


def render_document(
    form: PageFormat, name: str, values: Mapping[str, object], templates: str | None = None
) -> str:
    """Return what a template for whole documents, such as "index" in Markdown, makes of the values.

    `templates` is a folder of the user's, as in `render`.
    """
    return filled_by(form, f"base/{name}.{form.name}.jinja", values, folders_of(templates, pages=False))


def pieces(form: RecordsFormat, template: str, values: Mapping[str, object]) -> Iterator[str]:
    """Yield what a template of kurbel's for a format of records makes of the values, as they come."""
    yield from environment_of(form, ()).get_template(template).generate(values)


def filled_by(
    form: PageFormat | RecordsFormat, template: str, values: Mapping[str, object], folders: Folders
) -> str:
    if not folders:
        return environment_of(form, folders).get_template(template).render(values)
    from kurbel.formats.templates import filled_apart

    return filled_apart(form.name, template, values, folders)


def template_of(table: Table, name: str, folders: Sequence[str]) -> str:
    """Return the template of a page: that of its layout, if it has its own, here or in a user's folder."""
    own = f"{table.layout or table.key}/{name}.jinja"
    return own if has_template((*folders, template_folder()), own) else f"base/{name}.jinja"


def has_template(folders: Sequence[str], template: str) -> bool:
    """Tell whether one of the folders has a template."""
    return any(os.path.exists(f"{folder}/{template}") for folder in folders)


def folders_of(*folders: str | None, pages: bool = True) -> Folders:
    """Return those of a user's folders that have templates.

    Raises LayoutError for one that is none, or has a template for nothing; where no pages are set nobody
    knows all layouts.
    """
    given = dict.fromkeys(filter(None, folders))
    if not given:
        return ()
    from kurbel.formats.templates import check_layouts, has_templates

    found = tuple(folder for folder in given if has_templates(folder))
    if pages:
        check_layouts(found, tuple(given))
    return found


@cache
def environment_of(form: PageFormat | RecordsFormat, folders: Folders) -> Environment:
    """Return what loads the templates of a format; those of a user's folders run in a sandbox."""
    from jinja2 import BaseLoader, Environment, FileSystemLoader, StrictUndefined

    kind: type[Environment] = Environment
    ours = template_folder(), form.home
    loader: BaseLoader = FileSystemLoader(ours)
    if folders:
        from kurbel.formats.templates import Loader, Sandbox

        kind, loader = Sandbox, Loader(folders, ours)
    # No autoescape: every string of a page is finished text of its format, formulas included.
    environment = kind(
        loader=loader,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        auto_reload=bool(folders),
        bytecode_cache=None if folders else _compiled(),
        **form.writer.delimiters,
    )
    environment.filters.update(blank=blank, **form.writer.filters())
    return environment


@cache
def _compiled() -> BytecodeCache:
    """Return what keeps our templates compiled as Python keeps its modules: in __pycache__ beside them, or
    where PYTHONPYCACHEPREFIX says; not where PYTHONDONTWRITEBYTECODE forbids it, nor in a closed folder."""
    from pickle import UnpicklingError

    from jinja2.bccache import Bucket, FileSystemBytecodeCache

    class Compiled(FileSystemBytecodeCache):
        def load_bytecode(self, bucket: Bucket) -> None:
            # One that was cut off is compiled anew.
            with suppress(OSError, EOFError, UnpicklingError):
                super().load_bytecode(bucket)

        def dump_bytecode(self, bucket: Bucket) -> None:
            if sys.dont_write_bytecode:
                return
            with suppress(OSError):
                os.makedirs(self.directory, exist_ok=True)
                super().dump_bytecode(bucket)

    return Compiled(os.path.dirname(cache_from_source(f"{template_folder()}/templates.py")))


@contextmanager
def whole_file(target: str) -> Iterator[BinaryIO]:
    """Give a binary stream that becomes the file `target` when the block ends without an exception.

    "-" is standard output. A link keeps pointing to its file; a device or a pipe is written directly.
    """
    if target == "-":
        yield sys.stdout.buffer
        sys.stdout.buffer.flush()
        return
    if "\0" in target:
        raise OutputError("cannot write a file with a NUL in its name")
    # Later than most imports: the first table on a terminal is there sooner without it.
    from pathlib import Path

    try:
        descriptor = _descriptor(target)
        if descriptor is not None:
            with os.fdopen(os.dup(descriptor), "wb") as stream:
                yield stream
        # Asked of the target as it was given: a link such as /dev/fd/.. may lead to a pipe that has no path.
        elif (path := Path(target)).exists() and not path.is_file() and not path.is_dir():
            with open(target, "wb") as device:
                yield device
        else:
            yield from _replaced(Path(os.path.realpath(target)))
    except BrokenPipeError:
        raise
    except OSError as error:
        raise OutputError(f"cannot write {target}: {error.strerror or error}") from error


def _descriptor(target: str) -> int | None:
    """The number of the open stream that the target names: opened by name, a file behind it would be cut."""
    names = {"/dev/stdout": 1, "/dev/stderr": 2}
    folder, _, number = target.rpartition("/")
    if folder in ("/dev/fd", "/proc/self/fd") and number.isdecimal() and len(number) < 6:
        return int(number)
    return names.get(target)


def _replaced(path: Path) -> Iterator[BinaryIO]:
    _check(path)
    _swept(os.fspath(path.parent))
    handle, name = _temporary(path)
    try:
        with os.fdopen(handle, "wb") as stream:
            yield stream
            stream.flush()
            os.fsync(handle)
            if not name:
                name = _temporary_name(path)
                # With the descriptor of a folder the system follows the link that the opened file is.
                os.link(f"{_OPENED}/{handle}", name, src_dir_fd=handle)
            os.chmod(name, _mode(path))
            if os.name == "nt":
                # Windows renames no open file.
                stream.close()
            os.replace(name, path)
    except BaseException:
        if name:
            with suppress(FileNotFoundError):
                os.unlink(name)
        raise


def _temporary(path: Path) -> tuple[int, str]:
    """Return a new file beside the path, open and locked, and its name, if it has one."""
    if hasattr(os, "O_TMPFILE") and os.path.isdir(_OPENED):
        # File systems of other machines know no files without names.
        with suppress(OSError):
            handle = os.open(path.parent, os.O_WRONLY | os.O_TMPFILE, 0o600)
            # For the moment in which it has a name, but not yet that of the target.
            _is_ours(handle)
            return handle, ""
    while True:
        name = _temporary_name(path)
        handle = os.open(name, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
        # Before it was locked, another run may have taken it for one that was left behind.
        if _is_ours(handle) and os.path.exists(name):
            return handle, name
        os.close(handle)


def _temporary_name(path: Path) -> str:
    # Random, for the number of a process is another one's in another container. The target's name is cut, for
    # with the additions it must not be longer than file names may be.
    return os.fspath(path.with_name(f".{path.name[:40]}.{os.urandom(6).hex()}.part"))


def _is_ours(handle: int) -> bool:
    """Lock an open file against its removal by other runs; tell whether none of them has locked it.

    Windows removes no open file anyway; on a file system without locks nothing is removed.
    """
    if sys.platform == "win32":
        return True
    import fcntl

    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        return not isinstance(error, BlockingIOError)
    return True


def remove_left_over(folder: str) -> None:
    """Remove what killed runs left half written in a folder, and nothing that is being written."""
    # Nothing is left over in a folder that cannot be read, or for whoever may not remove it.
    with suppress(OSError):
        for name in filter(partial(re.fullmatch, _LEFT_OVER), os.listdir(folder)):
            with suppress(OSError):
                _remove_unless_written(os.path.join(folder, name))


# Once for each folder.
_swept = cache(remove_left_over)


def _remove_unless_written(path: str) -> None:
    if sys.platform == "win32":
        os.unlink(path)
        return
    import fcntl

    # A link, a pipe or a folder of that name is not ours.
    handle = os.open(path, os.O_RDWR | os.O_NOFOLLOW | os.O_NONBLOCK)
    try:
        if stat.S_ISREG(os.fstat(handle).st_mode):
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
            os.unlink(path)
    finally:
        os.close(handle)


def _check(path: Path) -> None:
    if path.is_dir():
        raise IsADirectoryError(21, "it is a directory; name a file in it")
    if path.parent.exists() and not path.parent.is_dir():
        raise NotADirectoryError(20, f"{path.parent} is not a directory")
    if not path.parent.is_dir():
        raise FileNotFoundError(2, f"the directory {path.parent} does not exist")
    if path.exists() and not os.access(path, os.W_OK):
        raise PermissionError(13, "the file is read-only")


def _mode(path: Path) -> int:
    """The mode of the old file, or what a new file would get."""
    if path.exists():
        return stat.S_IMODE(path.stat().st_mode)
    mask = os.umask(0)
    os.umask(mask)
    return 0o666 & ~mask
