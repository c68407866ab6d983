r"""Labels in reStructuredText, and what its templates read.

Markup stands apart from letters beside it. What is set here has an escaped space, which is not printed, on
both sides; `finish` removes those that are not needed: "x\ :math:`R`\ , y" becomes "x\ :math:`R`, y".
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import accumulate
from typing import NamedTuple
from unicodedata import combining, east_asian_width

from kurbel.formats.formula import TEX_OBEYED, TexMath, has_bar
from kurbel.formats.page import Page, PagePanel
from kurbel.formats.spacing import Span, shared
from kurbel.formats.writer import PageWriter, WriteOptions
from kurbel.page.formula import Formula
from kurbel.page.table import Table


class Writer(PageWriter):
    def escape(self, prose: str) -> str:
        return escape(prose)

    def note_mark(self, mark: str, target: str = "") -> str:
        """Return a raised mark without a link: a name of a note could be used but once in a document."""
        return role("sup", f"{escape(mark)})")

    def formula(self, formula: Formula, mark: str, display: bool = False) -> str:
        r"""Return a formula in TeX's notation in its role: :math:`x/R`, :math:`\frac{1}{4{,}5}\cos\varphi`.

        `display` gives fractions their full size.
        """
        size = r"\displaystyle " if display and has_bar(formula.content) else ""
        # docutils, which makes MathML of formulas, does not know \dots.
        tex = TexMath(mark, lambda text: text.translate(_UPRIGHT), dots=r"\ldots")
        return role("math", size + tex.set(formula.content))

    def finish(self, label: str) -> str:
        return finish(label)

    def filters(self) -> Mapping[str, Callable[..., object]]:
        return {"finish": finish, "grid_table": grid_table, "left_columns": left_columns}

    def values(self, table: Table, ready: Page, mark: str, wishes: WriteOptions) -> dict[str, object]:
        # The value of an option is no prose.
        return {"name": table.key}


# In a role it would end the formula.
_UPRIGHT = str.maketrans(TEX_OBEYED | {"`": "‘"})
_OBEYED = re.compile(r"[\\*`|_]|:(?=:)|(?<=\S)@(?=\S)|(?<=http|ttps|ilto|:ftp|file):(?=\S)")
# At the start of a line these make a list, a field, an option, a comment or a line across the page.
_START = re.compile(
    r"^ *(?=(?:[-+•‣⁃]|\.\.|>>>)(?: |$)|:[^:]|--?[A-Za-z]|/[A-Za-z]|=+ |\+-"
    r"|([!-/:-@\[\]^{-~])(?:\1{3}|\1*$)|\(?(?:[0-9]+|#|[A-Za-z]|[ivxlcdmIVXLCDM]+)[.)](?: |$))"
)
# Within code a backslash is one.
_ESCAPED = re.compile(r"(?<=\\ )``.+?``|\\(.)", re.DOTALL)
_TWICE = re.compile(r"(?<=[`*_])(?:\\ )+(?=\\ [:`*])")
_OPENING = re.compile(r":[a-z]+:`|[`*]")
# What may touch markup before it and behind it.
_BEFORE, _BEHIND = frozenset(("", *" \n'\"([{<-/:")), frozenset(("", *" \n'\")]}>-/\\:.,;!?"))


def escape(prose: str) -> str:
    """Return prose of which every character is printed and none obeyed."""
    escaped = _START.sub(r"\g<0>\\", _OBEYED.sub(r"\\\g<0>", prose))
    # Nothing but backslashes would be a line across the page.
    return escaped if escaped.strip("\\ ") or not escaped.strip() else f"\\ {escaped}"


def role(name: str, text: str) -> str:
    """Return text in a role, such as sup, apart from what stands beside it."""
    return f"\\ :{name}:`{text}`\\ "


def finish(text: str) -> str:
    """Return what was set without the escaped spaces that nothing needs."""
    single = _TWICE.sub("", text)

    def kept(match: re.Match[str]) -> str:
        if match[1] != " ":
            return match[0]
        before, behind = single[: match.start()][-1:], single[match.end() :][:1]
        opens, closes = bool(_OPENING.match(single, match.end())), before in ("`", "*", "_")
        apart = (opens and before not in _BEFORE) or (closes and behind not in _BEHIND)
        return match[0] if apart or not (opens or closes) else ""

    return _ESCAPED.sub(kept, single)


class GridCell(NamedTuple):
    """A cell by its place, counted from 0, and its extent; figures stand at the right of it."""

    row: int
    column: int
    lines: tuple[str, ...]
    down: int = 1
    across: int = 1
    right: bool = False

    @property
    def width(self) -> int:
        return max(map(width_of, self.lines), default=0)


def grid_table(panel: PagePanel) -> list[str]:
    """Return the lines of a panel."""
    head = [
        GridCell(row, cell.first, lines, cell.down, cell.across)
        for row, cells in enumerate(panel.head)
        for cell in cells
        for lines in [(cell.text,) if cell.kind == "spanner" else _block(cell.lines)]
    ]
    return grid_lines([*head, *_body(panel)], len(panel.head))


def _block(lines: Sequence[str]) -> tuple[str, ...]:
    """Return the lines of a heading as they stay apart."""
    return tuple(f"| {line}".rstrip() for line in lines) if len(lines) > 1 else tuple(lines)


def _body(panel: PagePanel) -> Iterator[GridCell]:
    row = len(panel.head)
    for group in panel.groups:
        if group.label:
            yield GridCell(row, 0, (group.label,), across=len(panel.columns))
            row += 1
        for cells in group.rows:
            for place, cell in enumerate(cells):
                if cell.down:
                    right = panel.columns[place].align == "right"
                    yield GridCell(row, place, (finish(cell.text + cell.marks),), cell.down, right=right)
            row += 1


def left_columns(panel: PagePanel) -> list[int]:
    """Return the columns of words, counted from 1 and from the right: at the left rows share cells."""
    last = len(panel.columns)
    return [last - place for place, column in enumerate(panel.columns) if column.align == "left"]


def width_of(text: str) -> int:
    """Return how many places a text takes where all letters are of one width."""
    return sum(0 if combining(one) else 1 + (east_asian_width(one) in "WF") for one in text)


def grid_lines(cells: Sequence[GridCell], heads: int) -> list[str]:
    """Return the lines of cells that cover a rectangle; so many rows are its head."""
    across = _edges([Span(cell.column, cell.across, cell.width + 2) for cell in cells])
    along = _edges([Span(cell.row, cell.down, len(cell.lines)) for cell in cells])
    canvas = [[" "] * (across[-1] + 1) for _ in range(along[-1] + 1)]
    for cell in cells:
        left, right = across[cell.column], across[cell.column + cell.across]
        for row in (cell.row, cell.row + cell.down):
            _fill(canvas[along[row]], left + 1, ("=" if 0 < row == heads else "-") * (right - left - 1))
        for line in canvas[along[cell.row] + 1 : along[cell.row + cell.down]]:
            _fill(line, left, "|")
            _fill(line, right, "|")
        for line, text in zip(canvas[along[cell.row] + 1 :], cell.lines, strict=False):
            blanks = right - left - 3 - width_of(text) if cell.right else 0
            _fill(line, left + 2 + blanks, text)
    for cell in cells:
        for row in (cell.row, cell.row + cell.down):
            for column in (cell.column, cell.column + cell.across):
                canvas[along[row]][across[column]] = "+"
    return ["".join(line) for line in canvas]


def _fill(line: list[str], place: int, text: Iterable[str]) -> None:
    """Put text into a line of places; what takes two of them, or none, leaves the line as long as it is."""
    for one in text:
        width = width_of(one)
        if width:
            line[place] = one
            line[place + 1 : place + width] = [""] * (width - 1)
        else:
            line[place - 1] += one
        place += width


def _edges(extents: Sequence[Span[int]]) -> list[int]:
    """Return where the lines stand that part rows or columns: each extent begins, covers many, needs room."""
    count = max(extent.first + extent.across for extent in extents)
    # What covers several comes last, when it is known how much room they have without it.
    rooms = shared([1] * count, sorted(extents, key=lambda extent: extent.across), [1] * count)
    return [0, *accumulate(room + 1 for room in rooms)]
