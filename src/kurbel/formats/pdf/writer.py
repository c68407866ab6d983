"""PDF by Typst, a compiler that comes as a Python package. Needs the extra `pdf`.

The same source is the same bytes on every day, in every time zone, locale and folder, given one version of
the package: only the fonts that it and kurbel bring along are used, no clock is read, and no Typst package is
found here or fetched, whatever a template of one's own writes.
"""

from __future__ import annotations

import os
import re
from bisect import bisect_left
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, nullcontext, suppress
from itertools import accumulate
from pathlib import Path
from threading import Lock
from typing import NamedTuple, cast

import kurbel.formats.typst
from kurbel.errors import LayoutError, OutputError, ProblemError
from kurbel.formats.pdf import STANDARDS, Standard
from kurbel.formats.render import render
from kurbel.formats.writer import CompiledWriter
from kurbel.page.table import Table
from kurbel.reading.environment import source_date_epoch
from kurbel.reading.names import checks_keywords


class Edit(NamedTuple):
    start: int
    end: int
    text: bytes


def with_row_headers(made: bytes) -> bytes:
    """Return the PDF that Typst made with the labels of rows as headers.

    What it says of suspects is left out: "false", the default, is what some readers take for a mistake.
    """
    suspects = (Edit(*found.span(), b"") for found in _SUSPECTS.finditer(made))
    edits = sorted([*suspects, *_row_headers(made)])
    return _edited(made, edits)


_SUSPECTS = re.compile(rb"(?<=/MarkInfo<</Marked true)/Suspects false(?=>>)")
# Parts of the structure stand on one line each. The empty groups are places for what is added.
_CELL = re.compile(
    rb"^([0-9]+) 0 obj\n<</Type/StructElem/S/T(D)/P [0-9]+ 0 R()/A\[<</O/Table()/Headers\[[^]\n]*()\]"
    rb"(?:/RowSpan ([0-9]+))?(?:.*?/BorderStyle\[/[A-Z][a-z]+/[A-Z][a-z]+/(Dashed)/)?",
    re.MULTILINE,
)
_ROW = re.compile(rb"^[0-9]+ 0 obj\n<</Type/StructElem/S/TR/P [0-9]+ 0 R/K\[([^]]*)\]", re.MULTILINE)
_NAMES = re.compile(rb"/IDTree<</Names\[()")
_KID = re.compile(rb"([0-9]+) 0 R")


def _row_headers(made: bytes) -> Iterator[Edit]:
    cells = {found[1]: found for found in _CELL.finditer(made)}
    labels = {number for number, cell in cells.items() if cell[7]}
    names = _NAMES.search(made)
    if not labels or not names:
        return
    for number in labels:
        cell = cells[number]
        yield Edit(*cell.span(2), b"H")
        yield Edit(*cell.span(3), b"/ID(%s)" % _name(number))
        yield Edit(*cell.span(4), b"/Scope/Row")
        yield Edit(*cell.span(7), b"None")
    # Of a label that stands for several rows, how many of them are left.
    lasting: dict[bytes, int] = {}
    for row in _ROW.finditer(made):
        numbers = [number for number in _KID.findall(row[1]) if number in cells]
        lasting |= {number: int(cells[number][6] or 1) for number in numbers if number in labels}
        headers = b"".join(b"(%s)" % _name(number) for number in lasting)
        yield from (Edit(*cells[number].span(5), headers) for number in numbers if number not in labels)
        lasting = {number: left - 1 for number, left in lasting.items() if left > 1}
    entries = sorted((_name(number), number) for number in labels)
    yield Edit(*names.span(1), b"".join(b"(%s)%s 0 R" % entry for entry in entries))


def _name(number: bytes) -> bytes:
    """Return the name of a header; those of Typst begin with a U, and names are in their order."""
    return b"R" + number


_TABLE = re.compile(
    rb"\nxref\n0 [0-9]+\n((?:[0-9]{10} [0-9]{5} [nf]\r?[ \n]\n?)+)trailer.*?\nstartxref\n([0-9]+)", re.DOTALL
)
_AT = re.compile(rb"([0-9]{10})(?= [0-9]{5} n)")


def _edited(made: bytes, edits: Sequence[Edit]) -> bytes:
    """Return the file after the edits, which are in order, its table of places anew."""
    table = _TABLE.search(made, made.rfind(b"\nxref\n"))
    if table is None:
        return made
    starts = [edit.start for edit in edits]
    moved = [0, *accumulate(len(edit.text) - (edit.end - edit.start) for edit in edits)]

    def place(old: bytes) -> int:
        return int(old) + moved[bisect_left(starts, int(old))]

    places = _AT.sub(lambda found: b"%010d" % place(found[1]), table[1])
    whole = [*edits, Edit(*table.span(1), places), Edit(*table.span(2), b"%d" % place(table[2]))]
    pieces, at = [], 0
    for start, end, text in whole:
        pieces += [made[at:start], text]
        at = end
    return b"".join([*pieces, made[at:]])


# Beside those that the package brings along: the letters of formulas, of the family of the text.
FONTS = os.path.join(os.path.dirname(kurbel.formats.typst.__file__), "fonts")
LETTERS = "Libertinus Math"
# Below a file there are no folders: no package lies here, and none can be put here.
_NO_PACKAGES = os.path.join(os.path.abspath(__file__), "packages")
# Typst has no switch against its fetching of packages, but it asks these variables for a proxy. One of this
# kind is refused before anything is opened, and no program can listen at port 0.
_PROXIES = {
    **dict.fromkeys(("https_proxy", "HTTPS_PROXY"), "socks4://127.0.0.1:0"),
    "no_proxy": "",
    "NO_PROXY": "",
}
_OFFLINE = Lock()
_OF_PACKAGES = re.compile(r"package not found|failed to download package")
_UNDATED = "#set document(date: none)\n"
_PLACE = re.compile(r"┌─ (.+):([0-9]+):[0-9]+$", re.MULTILINE)
# What the compiler calls a document that is no file.
_MAIN = "__typst_py_bytes__.typ"


# The memory of Typst in bytes: its own, that of a table, and of a cell, a block of content in the source. It
# took 2.6 GB for 10,000 rows of seven columns, 1.65 GB for a handbook of 200 tables, 7.7 GB for one of 1,000.
OWN, A_TABLE, A_CELL = 60 << 20, 3 << 19, 37 << 10
# What is not worth a word.
MUCH = 1 << 30
_INCLUDED = re.compile(r'include "(tables/[^"/\\]+\.typ)"')


def needed_for(cells: int, tables: int) -> int:
    """Return about how many bytes of memory a document takes."""
    return OWN + A_TABLE * tables + A_CELL * cells


def remarks(cells: int, tables: int = 1) -> Iterator[str]:
    """Yield what is to be known, before it begins, of a document of so many cells; one that is too large is
    refused."""
    needed = needed_for(cells, tables)
    if MUCH < needed <= _most():
        yield f"a PDF of {cells} cells takes Typst about {_gigabytes(needed)} of memory"


def _check_memory(source: str, root: str | None) -> None:
    """Raise LayoutError for a document for which the free memory of this machine is not enough."""
    cells, tables = source.count("["), _INCLUDED.findall(source)
    for name in tables:
        with suppress(OSError, ValueError):
            cells += Path(root or "", name).read_text(encoding="utf-8").count("[")
    needed = needed_for(cells, len(tables) or 1)
    if needed > _most():
        raise LayoutError(
            f"a PDF of about {cells} cells takes Typst {_gigabytes(needed)} of memory, and"
            f" {_gigabytes(_most())} are free; make several of it, print fewer rows, or have a TeX set its"
            " LaTeX"
        )


def _most() -> float:
    """Return the memory of the largest document that is tried."""
    free = free_memory()
    return float("inf") if free is None else max(free, MUCH)


def free_memory() -> int | None:
    """Return how many bytes of memory are free, None where the system does not say."""
    with suppress(OSError):
        found = re.search(r"MemAvailable:\s+([0-9]+) kB", Path("/proc/meminfo").read_text(encoding="ascii"))
        if found:
            return int(found[1]) << 10
    return None


def _gigabytes(count: float) -> str:
    return f"{count / 10**9:.1f} GB"


@checks_keywords
def typeset_pdf(page: Table, *, decimal: str | None = None, standards: Sequence[Standard] = ()) -> bytes:
    """Return the page as a PDF document; needs the extra `pdf`.

    `decimal` is "comma" or "point", by default the mark of the page's language; `standards` are what the
    file is to comply with: "a-2b" for archives, "ua-1" for readers who do not see it. The date of the file is
    SOURCE_DATE_EPOCH; without that variable it has none, or 1970-01-01 where PDF/A demands one. Raises
    KurbelError. Source of the standards: ISO 19005-2 (a-2b), ISO 14289-1 (ua-1).
    """
    if not isinstance(page, Table):
        raise ProblemError(f"a {type(page).__name__} cannot be set; make a page, such as kurbel.table()")
    return compile_typst(render(page, "typst", decimal=decimal, standalone=True), standards=standards)


def compile_typst(source: str, *, root: str | None = None, standards: Sequence[Standard] = ()) -> bytes:
    """Return the PDF of a document for Typst.

    `root` is the folder of the files that it includes; without one it can read none. `standards` are what
    the file is to comply with, such as "a-2b" for archives and "ua-1" for readers that do not see it.
    The file's date is SOURCE_DATE_EPOCH. Without that variable the file has none, unless the source sets
    one; PDF/A demands a date, which then is 1970-01-01. Raises LayoutError for a source with mistakes.
    """
    from tempfile import TemporaryDirectory

    _check(standards)
    _check_memory(source, root)
    epoch = source_date_epoch()
    undated = epoch is None and not any(name.startswith("a-") for name in standards)
    if root is not None and not os.path.isdir(root):
        raise OutputError(f"the folder {root} does not exist")
    with (
        TemporaryDirectory() if root is None else nullcontext(root) as folder,
        _mistakes_as_sentences(folder, undated),
    ):
        from typst import Compiler, Fonts

        document = (_UNDATED * undated + source).encode()
        fonts = Fonts(include_system_fonts=False, font_paths=[FONTS])
        compiler = Compiler(
            document,
            root=folder,
            font_paths=fonts,
            sys_inputs={"letters": LETTERS},
            package_path=_NO_PACKAGES,
            package_cache_path=_NO_PACKAGES,
        )
        with offline():
            made = compiler.compile(format="pdf", pdf_standards=list(standards), timestamp=epoch or 0)
    assert isinstance(made, bytes)
    return with_row_headers(made)


def _check(standards: Sequence[Standard]) -> None:
    unknown = [name for name in standards if name not in STANDARDS]
    if unknown:
        raise ProblemError(f"PDF standard is {unknown[0]!r}; it must be one of {', '.join(STANDARDS)}")
    if sum(name.startswith("a-") for name in standards) > 1:
        raise ProblemError(
            f"PDF standards are {', '.join(standards)}; only one of them may be a PDF/A (a-...)"
        )


@contextmanager
def offline() -> Iterator[None]:
    """Keep Typst from the network.

    The variables are those of the process, which Python knows nothing of: other threads' requests have the
    proxy that they had.
    """
    with _OFFLINE:
        for name, value in _PROXIES.items():
            os.putenv(name, value)
        try:
            yield
        finally:
            for name in _PROXIES:
                if name in os.environ:
                    os.putenv(name, os.environ[name])
                else:
                    os.unsetenv(name)


@contextmanager
def _mistakes_as_sentences(folder: str, lines_before: int) -> Iterator[None]:
    try:
        from typst import TypstError
    except ImportError:
        from kurbel.reading.environment import missing_extra

        raise missing_extra("PDF needs typst", "pdf") from None
    try:
        yield
    except TypstError as error:
        mistake = " ".join(error.message.split())
        if _OF_PACKAGES.match(mistake):
            mistake = "it imports a package (@...); packages come from the network and are not used"
        where = _place(error.diagnostic, folder, lines_before)
        raise LayoutError(f"Typst cannot set the document{where}: {mistake}") from None


def _place(diagnostic: str, folder: str, lines_before: int) -> str:
    """Return the file, unless it is the document itself, and the line that a mistake is in."""
    found = _PLACE.search(diagnostic)
    if not found:
        return ""
    path, line = found[1], int(found[2])
    if os.path.basename(path) == _MAIN:
        return f", line {line - lines_before}"
    return f", {os.path.relpath(path, folder)}, line {line}"


class Writer(CompiledWriter):
    def compiled(self, table: Table, decimal: str | None) -> bytes:
        return typeset_pdf(table, decimal=decimal)

    def remarks(self, cells: int, tables: int = 1) -> Iterator[str]:
        return remarks(cells, tables)

    def whole(self, folder: str, standards: Sequence[str], read: Callable[[str], str]) -> bytes:
        kept = cast("Sequence[Standard]", standards)
        return compile_typst(read("handbook.typ"), root=folder, standards=kept)
