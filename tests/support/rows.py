"""The figures of a page, wherever it is printed: every row in a line."""

from __future__ import annotations

import re
import subprocess
from html import unescape
from pathlib import Path

from tools import require

from kurbel.exact.numerals import Number, number_text
from kurbel.page.labels import plain
from kurbel.page.table import Row, Table


def text_of_pdf(folder: Path) -> str:
    subprocess.run([require("pdftotext"), "-layout", "page.pdf", "page.txt"], cwd=folder, check=True)
    return (folder / "page.txt").read_text(encoding="utf-8")


def lines_of_pdf(folder: Path) -> list[list[str]]:
    """Return the lines of each page, by the places of its words.

    Signs above the line, such as those of degrees, part lines for `pdftotext -layout`; here they are lines of
    their own.
    """
    subprocess.run([require("pdftotext"), "-bbox", "page.pdf"], cwd=folder, check=True)
    pages = (folder / "page.html").read_text(encoding="utf-8").split("<page ")[1:]
    return [_lines(_WORD.findall(page)) for page in pages]


_WORD = re.compile(r'xMin="([\d.]+)" yMin="([\d.]+)" xMax="([\d.]+)" yMax="([\d.]+)">(.*)</word>')


def _lines(words: list[tuple[str, ...]]) -> list[str]:
    """Return words as lines; those of a line have their middles at nearly one height."""
    found: list[list[tuple[float, str]]] = []
    last = float("-inf")
    for height, along, text in sorted(_placed(words)):
        if height - last > SAME_LINE:
            found.append([])
        last = height
        found[-1].append((along, text))
    return [unescape(" ".join(text for _, text in sorted(line))) for line in found]


def _placed(words: list[tuple[str, ...]]) -> list[tuple[float, float, str]]:
    """Return words with the height of their middles and where they begin, as one reads them: a wide table is
    turned to the left."""
    boxes = [
        (float(left), float(up), float(right), float(down), text) for left, up, right, down, text in words
    ]
    # A letter of a formula is taller than wide, whichever way it is read.
    long = [box for box in boxes if len(box[4]) > 3]
    wide = sum(right - left for left, _, right, _, _ in long)
    tall = sum(down - up for _, up, _, down, _ in long)
    if wide >= tall:
        return [((up + down) / 2, left, text) for left, up, _, down, text in boxes]
    return [((left + right) / 2, -down, text) for left, _, right, down, text in boxes]


# In points; the lines of a table are at least 9 apart.
SAME_LINE = 2.0


def assert_rows_stand_in(lines: list[str], page: Table, angles: bool = True) -> None:
    """Check that the figures of every row of the page stand in a line, from left to right and going down.

    Of a page without any its words do, wherever a formula between them puts them.
    """
    below = iter(lines)
    rows = [row_of_figures(row, page.lang, angles) for panel in page.panels for row in panel.rows()]
    if not any(rows):
        return assert_words_follow(" ".join(map(written, lines)), page)
    for row in rows:
        pattern = re.compile(".*?".join(rf"(?<![\d.,]){re.escape(figure)}(?!\d|[.,]\d)" for figure in row))
        assert any(pattern.search(written(line)) for line in below), f"{page.key} has no row {row}"


def assert_words_follow(text: str, page: Table) -> None:
    """Check that the labels of the page that have no formula stand in the text, one after the other."""
    labels = [
        cell.value
        for panel in page.panels
        for row in panel.rows()
        for cell in row.stub + row.cells
        if isinstance(cell.value, str) and "$" not in cell.value
    ]
    assert any(labels)
    at = 0
    for label in labels:
        word = written(plain(label))
        assert word in text[at:], f'{page.key} has no "{word}" after {text[:at][-80:]!r}'
        at = text.index(word, at) + len(word)


def row_of_figures(row: Row, lang: str, angles: bool) -> list[str]:
    """Return the numbers and angles of a row in the notation of the language."""
    mark = {"de": ",", "en": "."}[lang]
    return [
        number_text(cell.value, mark) if isinstance(cell.value, Number) else written(plain(cell.value))
        for cell in row.stub + row.cells
        if isinstance(cell.value, Number)
        or (angles and isinstance(cell.value, str) and ANGLE.fullmatch(cell.value))
    ]


ANGLE = re.compile(r"\$\d+°\d+'\$")


def written(line: str) -> str:
    """Return the line with one minus sign and one prime for all."""
    return line.replace("−", "-").replace("′", "'")
