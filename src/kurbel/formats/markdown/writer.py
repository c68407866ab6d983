"""Labels in Markdown, and pipe tables: what Markdown, as GitHub reads it, can show of a page.

They know one heading row and no spans. So spanners are written before the headings under them, stub cells
are repeated, and every labelled group is a table of its own under its label: a label row among the figures
would sit in the first column, which is narrow, and an extra column would repeat it on every line.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from itertools import chain
from typing import NamedTuple

from kurbel.formats.page import PageCell, PagePanel
from kurbel.formats.writer import PageWriter
from kurbel.page.formula import Formula
from kurbel.page.labels import formula_plain, mark_text

_FIGURES = re.compile(r"[0-9][0-9.,]*°?")


class Writer(PageWriter):
    def escape(self, prose: str) -> str:
        return escape(prose)

    def note_mark(self, mark: str, target: str = "") -> str:
        # An anchor in Markdown is HTML, which many readers drop: there is no link.
        return escape(mark_text(mark))

    def formula(self, formula: Formula, mark: str, display: bool = False) -> str:
        # Dollar signs are left alone, since many readers of Markdown print them.
        return escape(formula_plain(formula, mark))

    def filters(self) -> Mapping[str, Callable[..., object]]:
        return {"parts": parts, "pipe_table": pipe_table}


_OBEYED = re.compile(r"[\\`*_\[\]<>|~$]|&(?=[#A-Za-z])")
# At the start of a line these make a list or a heading.
_START = re.compile(r"^( *)([-+=]|#+|[0-9]+(?=[.)](?: |$)))(?=[ .)]|$)")


def escape(prose: str) -> str:
    """Return prose of which every character is printed and none obeyed."""
    return _START.sub(_escape_start, _OBEYED.sub(r"\\\g<0>", prose))


def _escape_start(match: re.Match[str]) -> str:
    space, start = match.groups()
    return f"{space}{start}\\" if start.isdigit() else f"{space}\\{start}"


class Part(NamedTuple):
    """Rows of a panel that are a table of their own, and the label that stands over it."""

    label: str
    rows: Sequence[Sequence[PageCell]]


def parts(panel: PagePanel) -> list[Part]:
    """Return a table for each group, or one for all of them if none has a label."""
    if any(group.label for group in panel.groups):
        return [Part(group.label, group.rows) for group in panel.groups]
    return [Part("", panel.rows)]


def pipe_table(rows: Sequence[Sequence[PageCell]], panel: PagePanel) -> str:
    """Return rows of a panel below its heads, as a pipe table."""
    from tabulate import tabulate

    with _counted_letters():
        return tabulate(
            [[cell.text + cell.marks for cell in row] for row in rows],
            headers=_headings(panel),
            tablefmt="pipe",
            colalign=[column.align for column in panel.columns],
            disable_numparse=True,
        )


@contextmanager
def _counted_letters() -> Iterator[None]:
    """Let tabulate count letters, and give heads no more room than figures.

    Where a library for it is installed it counts the places that letters take on a terminal, and the same
    page would have other bytes.
    """
    import tabulate

    before = tabulate.WIDE_CHARS_MODE, tabulate.MIN_PADDING
    tabulate.WIDE_CHARS_MODE, tabulate.MIN_PADDING = False, 0
    try:
        yield
    finally:
        tabulate.WIDE_CHARS_MODE, tabulate.MIN_PADDING = before


def _headings(panel: PagePanel) -> list[str]:
    """Return the heads of each column on one line: the spanners, its own heading, the symbol of all."""
    names: list[list[str]] = [[] for _ in panel.columns]
    symbols: list[list[str]] = [[] for _ in panel.columns]
    for cell in chain.from_iterable(panel.spanners):
        name, *symbol = cell.lines
        for place in range(cell.first, cell.last + 1):
            names[place].append(name)
            symbols[place] += symbol
    return [
        " ".join(text for text in (*above, _one_line(column.heading), *below) if text)
        for above, column, below in zip(names, panel.columns, symbols, strict=True)
    ]


def _one_line(lines: Sequence[str]) -> str:
    """Join the lines of a heading; two figures, as in 10 / 350, would run into one number."""
    figures = len(lines) > 1 and all(_FIGURES.fullmatch(line) for line in lines)
    return (" / " if figures else " ").join(line for line in lines if line)
