"""Workbooks as plain values: what stands in which cell, and how it looks."""

from __future__ import annotations

import re
from collections.abc import Container, Mapping
from typing import Literal, NamedTuple, TypeAlias

from kurbel.errors import LayoutError
from kurbel.exact.numerals import Number
from kurbel.formats.spacing import em
from kurbel.formats.writer import PageWriter
from kurbel.page import formula as tree
from kurbel.page.labels import formula_plain

# What Excel can hold; other programs hold as much.
MOST_ROWS, MOST_COLUMNS = 1 << 20, 1 << 14
LONGEST_TEXT, LONGEST_NAME = 32_767, 31
# A spreadsheet keeps no more figures of a number, and shows no more decimals.
MOST_FIGURES, MOST_DECIMALS = 15, 30

Rule: TypeAlias = Literal["", "thin", "heavy"]


class CellLook(NamedTuple):
    """How a cell looks: which part of the page it is, and what rules are above and below it.

    What is `indented` keeps clear of figures on its left; what `wraps` stands beside a text of several lines.
    A number has so many `decimals`; behind it stands `after`, a mark of a note, and then empty space as wide
    as the characters of `blank`, so that decimal marks stand in line.
    """

    part: Literal["caption", "head", "group", "body", "note", "source", "key", "entry"] = "body"
    align: Literal["left", "center", "right"] = "left"
    above: Rule = ""
    below: Rule = ""
    indented: bool = False
    wraps: bool = False
    decimals: int = 0
    after: str = ""
    blank: str = ""


class SheetCell(NamedTuple):
    """A cell at its place, counted from 0, which may reach over others; a `link` leads to a sheet."""

    row: int
    column: int
    value: Number | str | None
    look: CellLook
    across: int = 1
    down: int = 1
    link: str = ""


class Picture(NamedTuple):
    """A picture (PNG) below a row, with its size in points and words for those who do not see it."""

    row: int
    content: bytes
    width: float
    height: float
    words: str


class Sheet(NamedTuple):
    """A sheet: its cells in the order of their rows, the widths of its columns in figures, and the heights in
    points of those rows that are not as high as a line.

    The first rows and columns that are `frozen` stay in view; the rows of `head`, from one to before another,
    stand on every page of paper. A sheet of `records` has one line for the keys of its columns, and a filter.
    `mark` is the decimal mark of its numbers, where the file can say it.
    """

    name: str
    cells: tuple[SheetCell, ...]
    widths: tuple[float, ...]
    heights: Mapping[int, float] = {}
    frozen: tuple[int, int] = (0, 0)
    head: tuple[int, int] = (0, 0)
    records: bool = False
    mark: str = "."
    pictures: tuple[Picture, ...] = ()

    @property
    def rows(self) -> int:
        return max((cell.row + cell.down for cell in self.cells), default=0)

    @property
    def columns(self) -> int:
        return max((cell.column + cell.across for cell in self.cells), default=0)

    @property
    def landscape(self) -> bool:
        """Whether paper is turned: the columns are wider than a page."""
        return sum(self.widths) > 95


class Workbook(NamedTuple):
    """Sheets in their order; `epoch` is the time that it is of, in seconds since 1970."""

    title: str
    author: str
    lang: str
    epoch: int
    sheets: tuple[Sheet, ...]


class Run(NamedTuple):
    """A piece of a text; letters of formulas are italic, and indices are `low`."""

    text: str
    italic: bool = False
    low: bool = False


# Around letters of formulas and around indices, until a cell is written; no text that is typed may have them.
_ON, _OFF, _LOW, _LEVEL = _MARKS = "\ue000\ue001\ue002\ue003"
_MARK = re.compile(f"([{_MARKS}])")
# What XML cannot have.
_CONTROL = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff]")


class SheetWriter(PageWriter):
    """Sets labels as plain text, in which letters of formulas are marked as italic, and indices as low."""

    def escape(self, prose: str) -> str:
        return _MARK.sub("\ufffd", prose)

    def formula(self, formula: tree.Formula, mark: str, display: bool = False) -> str:
        return _plain(_slanted(formula.content), mark).replace(" ", "\u00a0")


def _plain(nodes: tree.Nodes, mark: str = ".") -> str:
    return formula_plain(tree.Formula(nodes), mark)


def _slanted(nodes: tree.Nodes) -> tree.Nodes:
    return tuple(map(_slanted_node, nodes))


def _slanted_node(node: tree.Node) -> tree.Node:
    match node:
        case tree.Variable(text) if text not in tree.CAPITALS:
            return tree.Variable(f"{_ON}{text}{_OFF}")
        case tree.Group(content, fences):
            return tree.Group(_slanted(content), fences)
        case tree.Root(content):
            return tree.Root(_slanted(content))
        case tree.Overline(content):
            return tree.Overline(_slanted(content))
        case tree.Fraction(top, bottom):
            return tree.Fraction(_slanted(top), _slanted(bottom))
        case tree.Script(base, index, power):
            if all(isinstance(node, tree.Numeral) for node in index):
                # Small figures are characters of their own; not all letters have small ones.
                return tree.Script(_slanted_node(base), index, power)
            raised = _plain((tree.Script(tree.Upright(""), (), power),)) if power else ""
            # One node, as it was, for what stands beside several is set in parentheses.
            return tree.Upright(
                f"{_plain((_slanted_node(base),))}{_LOW}{_plain(_slanted(index))}{_LEVEL}{raised}"
            )
    return node


def runs(text: str) -> tuple[Run, ...]:
    """Return the pieces of a text that was set."""
    found: list[Run] = []
    italic = low = False
    for piece in _MARK.split(text):
        if piece in _MARKS and piece:
            italic = piece == _ON if piece in (_ON, _OFF) else italic
            low = piece == _LOW if piece in (_LOW, _LEVEL) else low
        elif piece:
            run = Run(_CONTROL.sub("\ufffd", piece), italic, low)
            if found and found[-1][1:] == run[1:]:
                run = run._replace(text=found.pop().text + run.text)
            found.append(run)
    return tuple(found)


def bare(text: str) -> str:
    """Return a text that was set without its marks."""
    return _MARK.sub("", text)


def figures_wide(text: str) -> float:
    """Return the width of a text that was set, in figures; of several lines that of the widest."""
    return max(em(line) for line in bare(text).split("\n")) / em("0")


def is_kept(number: Number) -> bool:
    """Tell whether a spreadsheet keeps every figure of a number."""
    return len(str(abs(number.scaled))) <= MOST_FIGURES and number.decimals <= MOST_DECIMALS


def checked_text(text: str) -> str:
    """Return a text that fits in a cell; raise LayoutError for a longer one."""
    if len(text) > LONGEST_TEXT:
        raise LayoutError(
            f'a text of {len(text)} characters, "{bare(text)[:40]}…", is too long for a spreadsheet;'
            f" a cell of one has at most {LONGEST_TEXT}"
        )
    return text


def quoted(name: str) -> str:
    """Return the name of a sheet as it stands in an address."""
    return "'" + name.replace("'", "''") + "'"


_FOREIGN = re.compile(r"[\[\]:*?/\\\x00-\x1f]+")


def sheet_name(wanted: str, taken: Container[str]) -> str:
    """Return a name that every spreadsheet takes for a sheet; those `taken` are in small letters."""
    # Excel counts as UTF-16 does, keeps "history" for itself, and takes no apostrophe at either end.
    plain = " ".join(_FOREIGN.sub(" ", wanted).split()).strip("' -") or "1"
    name, number = _cut(plain, LONGEST_NAME), 1
    while name.lower() in taken or name.lower() == "history":
        number += 1
        end = f" ({number})"
        name = _cut(plain, LONGEST_NAME - len(end)) + end
    return name


def _cut(text: str, longest: int) -> str:
    units = text.encode("utf-16-le", "replace")[: 2 * longest]
    return units.decode("utf-16-le", "ignore").rstrip("' -")
