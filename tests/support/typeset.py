"""What stands where in a PDF, as poppler reads it: words, their size, and formulas that a line end cuts."""

from __future__ import annotations

import html
import re
import subprocess
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

from tools import require


class Word(NamedTuple):
    """A word on a page, in points from its upper left corner."""

    page: int
    left: float
    top: float
    right: float
    bottom: float
    text: str

    @property
    def middle(self) -> float:
        return (self.top + self.bottom) / 2

    @property
    def size(self) -> float:
        """The size of the type, of which poppler gives ascent and descent: those of Libertinus Serif."""
        return (self.bottom - self.top) / (0.894 + 0.246)


_PAGE = re.compile(r"<page |<word ([^>]*)>(.*?)</word>")


def words_of_pdf(path: Path) -> list[Word]:
    """Return all words of a PDF in their order."""
    command = [require("pdftotext"), "-bbox", str(path), "-"]
    made = subprocess.run(command, stdout=subprocess.PIPE, check=True, encoding="utf-8").stdout
    words, page = [], 0
    for found in _PAGE.finditer(made):
        page += found[1] is None
        if found[1] is not None:
            left, top, right, bottom = (float(number) for number in re.findall(r'"([\d.]+)"', found[1]))
            words.append(Word(page, left, top, right, bottom, html.unescape(found[2])))
    return words


_FIGURE = re.compile(r"[−-]?\d+[,.]\d+")


def least_type(words: list[Word]) -> float:
    """Return the size of the smallest type of any number with decimals."""
    return min(word.size for word in words if _FIGURE.fullmatch(word.text))


def has_pauses(words: list[Word], least: float) -> bool:
    """Tell whether the rows of 30°, 60° to 150° stand further off than the others, by so much at least."""
    tops = [next(word.top for word in words if word.text == str(angle)) for angle in range(10, 180, 10)]
    steps = [below - above for above, below in pairwise(tops)]
    pauses, others = steps[1::3], steps[::3] + steps[2::3]
    return max(pauses) - min(pauses) < 0.1 and min(pauses) > max(others) + least


# What cannot end a formula, and how far away, in points, the rest of it is at most.
_OPEN = re.compile(r"[±=+·<>≈≤≥]$|(?<=.)−$|^−$")
_NEAR, _LINE = 120.0, 16.0


def broken_formulas(words: list[Word]) -> Iterator[str]:
    """Yield the lines that end in a sign to which more belongs: nothing stands near on its right."""
    pages: dict[int, list[Word]] = {}
    for word in words:
        pages.setdefault(word.page, []).append(word)
    for page, those in pages.items():
        for word in those:
            if _OPEN.search(word.text) and not any(_follows(word, other) for other in those):
                line = [one.text for one in those if abs(one.middle - word.middle) < 1]
                yield f"page {page}: {' '.join(line)}"


def _follows(word: Word, other: Word) -> bool:
    return -1 < other.left - word.right < _NEAR and abs(other.middle - word.middle) < _LINE


def page_width(path: Path) -> float:
    """Return the width of the first page, in millimetres."""
    made = subprocess.run(
        [require("pdfinfo"), str(path)], stdout=subprocess.PIPE, check=True, encoding="utf-8"
    )
    found = re.search(r"Page size: +([\d.]+) x", made.stdout)
    assert found
    return float(found[1]) / 72 * 25.4


# A figure of Latin Modern in 7 pt, its own design, which is wider than larger type made smaller.
_FIGURE_OF_7_POINTS = 3.985 * 72 / 72.27


def narrowest_figure(folder: Path) -> float:
    """Return the width of the smallest figures of any number of page.pdf, as a share of those of 7 pt.

    Words may be turned.
    """
    numbers = [
        word for word in words_of_pdf(folder / "page.pdf") if re.fullmatch(r"\d+[.,]\d{2,}", word.text)
    ]
    assert numbers
    widths = ((max(word.right - word.left, word.bottom - word.top), len(word.text) - 1) for word in numbers)
    # The mark is 5/9 as wide as a figure.
    return min(width / (figures + 5 / 9) for width, figures in widths if figures > 3) / _FIGURE_OF_7_POINTS
