"""Colours of a terminal for what a cell is to be taken as."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from kurbel.formats.page import PageCell
from kurbel.formats.text.writer import Grid
from kurbel.page.table import Tone

# Green, yellow, cyan and bold red: the colours that a terminal's theme makes legible on its ground.
CODES: Mapping[Tone, str] = {"right": "32", "near": "33", "other": "36", "wrong": "1;31"}


def painted(line: str, cells: Sequence[PageCell], grid: Grid) -> str:
    """Return the line of a row with its colours; all stands where it stood."""
    # From the right, for codes move what stands behind them.
    for cell, left, width in reversed([*zip(cells, grid.lefts, grid.widths, strict=False)]):
        text = line[left : left + width].strip()
        if cell.tone and text:
            start = line.index(text, left)
            end = start + len(text)
            line = f"{line[:start]}\x1b[{CODES[cell.tone]}m{line[start:end]}\x1b[0m{line[end:]}"
    return line
