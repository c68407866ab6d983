"""A table that is too wide for a telephone, a second time in panels below each other, as a terminal has it.

It is cut from the finished table, so that no figure can differ. The style sheet shows one of both.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import accumulate, pairwise
from typing import NamedTuple

from kurbel.formats.html.writer import Widths
from kurbel.formats.page import WORDS
from kurbel.formats.spacing import added

_FIGURE = re.compile(r'<figure class="kurbel"[^>]* lang="([^"]*)"')
_REGION = re.compile(
    r'<div class="scroll broad"([^>]*)>\n<table style="([^"]*)">\n(.*?)</table>\n</div>\n', re.DOTALL
)
_CAPTION = re.compile(r'<caption id="([^"]*)">(.*?)</caption>\n', re.DOTALL)
_COLUMNS = re.compile(r"<colgroup>(.*?)</colgroup>\n", re.DOTALL)
_COLUMN = re.compile(r"<col[^>]*>")
_SECTION = re.compile(r"<(thead|tbody)>(.*?)</\1>", re.DOTALL)
_ROW = re.compile(r"(<tr[^>]*>)(.*?)</tr>", re.DOTALL)
_CELL = re.compile(r"<(t[hd])\b([^>]*)>(.*?)</\1>", re.DOTALL)
_SPAN = re.compile(r' (col|row)span="(\d+)"')
_COLSPAN = re.compile(r' colspan="\d+"')
_ID = re.compile(r' (id|headers)="([^"]*)"')
_MEASURE = re.compile(r"--(\w+): ([\d.]+)")


def with_panels(page: str) -> str:
    """Return a page with panels for telephones after each table that needs them."""
    lang = next((found[1] for found in _FIGURE.finditer(page)), "")
    word = WORDS.get(lang, WORDS["en"])["continued"]
    # Regions have names of their own.
    several = page.count('<div class="scroll') > 1
    return _REGION.sub(lambda region: region[0] + "".join(_panels(region, word, several)), page)


class _Cell(NamedTuple):
    tag: str
    said: str
    content: str
    across: int
    down: int


def _panels(region: re.Match[str], word: str, several: bool) -> Iterator[str]:
    attributes, style, inner = region.groups()
    sizes = [len(_COLUMN.findall(group[1])) for group in _COLUMNS.finditer(inner)]
    widths = _measured(style, sum(sizes))
    caption = _CAPTION.search(inner)
    shares = _shares(widths, sizes)
    if caption is None or len(shares) < 2:
        return
    for number, kept in enumerate(shares, 1):
        own = f"{caption[1]}-s{number}"
        count = f" {number - 1}" if several or len(shares) > 2 else ""
        said = f"<span>({word}{count})</span>" if number > 1 else caption[2]
        called = attributes if number == 1 else attributes.replace(caption[1], f"{caption[1]} {own}", 1)
        yield f'<div class="scroll narrow"{called}>\n<table style="{_of(widths, kept).style}">\n'
        yield f'<caption id="{own}">{said}</caption>\n'
        yield from _colgroups(sizes, kept)
        yield from (_section(section, kept, f"-s{number}") for section in _SECTION.finditer(inner))
        yield "</table>\n</div>\n"


def _measured(style: str, count: int) -> Widths:
    said = {name: float(value) for name, value in _MEASURE.findall(style)}
    leasts, gaps, shifts, mores = (
        tuple(said.get(f"{kind}{place}", 0.0) for place in range(count, 0, -1)) for kind in "lgsm"
    )
    return Widths(said.get("wide", 0.0), leasts, gaps, shifts, mores)


def _of(widths: Widths, kept: Sequence[int]) -> Widths:
    """Return the widths of some of the columns, of which no whole heads are known."""
    columns = (widths.leasts, widths.gaps, widths.shifts, widths.mores)
    leasts, gaps, shifts, mores = (tuple(one[place] for place in kept) for one in columns)
    return Widths(added(leasts), leasts, gaps, shifts, mores)


def _shares(widths: Widths, sizes: Sequence[int]) -> list[list[int]]:
    """Return the columns of each panel: as few panels as fit, parted between spanners if that is enough.

    The first of the sizes is that of the stub, which all panels have. Nothing where no panels fit.
    """
    stub, count = list(range(sizes[0])), sum(sizes)
    for blocks in (sizes[1:], [1] * (count - sizes[0])):
        starts = list(accumulate(blocks, initial=sizes[0]))
        for pieces in range(2, len(blocks) + 1):
            ends = [starts[-(-len(blocks) * piece // pieces)] for piece in range(pieces + 1)]
            shares = [[*stub, *range(start, end)] for start, end in pairwise(ends)]
            if not any(_of(widths, share).broad for share in shares):
                return shares
    return []


def _colgroups(sizes: Sequence[int], kept: Sequence[int]) -> Iterator[str]:
    for start, end in pairwise(accumulate(sizes, initial=0)):
        if count := len(set(range(start, end)) & set(kept)):
            yield f"<colgroup>{'<col>' * count}</colgroup>\n"


def _section(section: re.Match[str], kept: Sequence[int], end: str) -> str:
    """Return the head or a group of the rows with the columns that are kept; its ids have another end."""
    rows = _ROW.findall(section[2])
    cells = _placed([[_cell(*found) for found in _CELL.findall(content)] for _, content in rows])
    cut = zip(rows, cells, strict=True)
    lines = "".join(f"{_renamed(tag, end)}{''.join(_cut(row, kept, end))}</tr>\n" for (tag, _), row in cut)
    return f"<{section[1]}>\n{lines}</{section[1]}>\n"


def _cell(tag: str, said: str, content: str) -> _Cell:
    spans = {kind: int(count) for kind, count in _SPAN.findall(said)}
    return _Cell(tag, said, content, spans.get("col", 1), spans.get("row", 1))


def _placed(rows: Sequence[Sequence[_Cell]]) -> Iterator[list[tuple[int, _Cell]]]:
    """Yield the cells of each row with their columns, past those that reach down from the rows above."""
    taken: dict[int, int] = {}
    for row in rows:
        placed, place = [], 0
        reaching = {column: left - 1 for column, left in taken.items() if left > 1}
        for cell in row:
            while place in reaching:
                place += 1
            placed.append((place, cell))
            reaching |= {place + step: cell.down for step in range(cell.across)}
            place += cell.across
        yield placed
        taken = reaching


def _cut(row: Sequence[tuple[int, _Cell]], kept: Sequence[int], end: str) -> Iterator[str]:
    for place, cell in row:
        if across := len(set(range(place, place + cell.across)) & set(kept)):
            spans = "" if across == 1 else f' colspan="{across}"'
            said = _renamed(_COLSPAN.sub("", cell.said), end)
            yield f"<{cell.tag}{said}{spans}>{cell.content}</{cell.tag}>"


def _renamed(said: str, end: str) -> str:
    return _ID.sub(lambda ids: f' {ids[1]}="{" ".join(name + end for name in ids[2].split())}"', said)
