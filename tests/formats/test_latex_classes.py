"""Fragments in documents of authors: four classes, two engines, and what the page then looks like."""

from __future__ import annotations

import re
import subprocess
from functools import cache
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from everything import everything
from numpy.typing import NDArray
from tex import compiled, complaints
from tools import require
from typeset import has_pauses, words_of_pdf

import kurbel
from kurbel.formats.render import render
from kurbel.page.table import Table

# Widths in points of what is measured, in pixels of the picture.
DPI = 144
PIXEL = 72.27 / DPI
CAPTION = r"\usepackage[font=small,labelfont=bf]{caption}"
# Two whole engines and four classes; one of each is in every run.
DOCUMENTS = (
    pytest.param("article", "pdflatex", ""),
    pytest.param("article", "lualatex", CAPTION, marks=pytest.mark.slow),
    pytest.param("scrbook", "pdflatex", CAPTION, marks=pytest.mark.slow),
    pytest.param("scrbook", "lualatex", "", marks=pytest.mark.slow),
    pytest.param("memoir", "pdflatex", "", marks=pytest.mark.slow),
    pytest.param("memoir", "lualatex", CAPTION, marks=pytest.mark.slow),
    pytest.param("beamer", "pdflatex", "", marks=pytest.mark.slow),
    pytest.param("beamer", "lualatex", CAPTION, marks=pytest.mark.slow),
)
SKIPS = r"\the\abovecaptionskip \the\belowcaptionskip \the\leftskip"
LENGTHS = SKIPS + r" \the\tabcolsep \the\cmidrulekern \the\linewidth \the\hsize"


@cache
def pages(small: bool) -> tuple[Table, ...]:
    """Return two pages of one layout, one with all parts, a narrow one, and one that is turned."""
    if small:
        angles = "0..180:60"
        return (
            kurbel.table(angle=angles),
            kurbel.delta(lang="en"),
            kurbel.table(angle=angles, layout="blau-kolbenwege"),
        )
    return (
        kurbel.table(),
        kurbel.table(ratio="1:4"),
        everything(),
        kurbel.table(layout="lueger-kolbenbewegung"),
        kurbel.table(layout="kolbenwege"),
    )


def document(name: str, more: str) -> str:
    inputs = [f"\\input{{{page.anchor}}}" for page in pages(name == "beamer")]
    if name == "beamer":
        body = "".join(f"\\begin{{frame}}\n{one}\n\\end{{frame}}\n" for one in inputs)
    else:
        body = "Text\n\\clearpage\n" + "\\clearpage\n".join(f"{one}\n" for one in inputs)
    # What nobody asks for other fonts has, where some signs exist as bitmaps only.
    fonts = "" if name == "article" else r"\usepackage[T1]{fontenc}\usepackage{lmodern}"
    hyperref = "" if name == "beamer" else r"\usepackage{hyperref}"
    return rf"""\documentclass{{{name}}}
\usepackage{{iftex}}
\iftutex\usepackage{{fontspec}}\fi
{fonts}
\usepackage[english,ngerman]{{babel}}
\usepackage{{amsmath,array,booktabs,graphicx}}
{more}
{hyperref}
\pagestyle{{empty}}
\begin{{document}}
\typeout{{before {LENGTHS}}}
{body}\typeout{{behind {LENGTHS}}}
\end{{document}}
"""


@pytest.mark.parametrize(("name", "engine", "more"), DOCUMENTS)
def test_fragments_are_set_in_every_class_without_a_warning(
    name: str, engine: str, more: str, tmp_path: Path
) -> None:
    for page in pages(name == "beamer"):
        (tmp_path / f"{page.anchor}.tex").write_text(render(page, "latex"), encoding="utf-8")
    log = compiled(engine, document(name, more), tmp_path, runs=2)
    assert complaints(log) == []
    before, behind = re.search(r"^before (.*)", log, re.M), re.search(r"^behind (.*)", log, re.M)
    assert before and behind and before[1] == behind[1]
    if name != "beamer":
        assert_caption_stands_free(ink(tmp_path, 1), ink(tmp_path, 2))
    if name == "article":
        # A grave accent as a sign, on the page with every part, is there in no other way.
        command = [require("pdffonts"), "-l", "3", "page.pdf"]
        fonts = subprocess.run(command, cwd=tmp_path, capture_output=True, check=True)
        assert b"Type 1" in fonts.stdout or b"CID Type 0C" in fonts.stdout
        assert b"Type 3" not in fonts.stdout
        assert_it_is_turned(ink(tmp_path, 1 + len(pages(False))))


def assert_caption_stands_free(text: NDArray[np.bool_], page: NDArray[np.bool_]) -> None:
    """Check that a float begins where text does, and that its caption stays clear of the table's rule."""
    top, lines = rows(text)[0], rows(page)
    # Of text the first baseline, of a float the upper edge of its first line stands at the top.
    assert -5 <= (lines[0][0] - top[0]) * PIXEL <= 2
    rule = next(place for place, (start, end) in enumerate(lines) if page[start:end].any(axis=0).mean() > 0.4)
    assert 1 <= rule <= 3
    assert 4 <= (lines[rule][0] - lines[rule - 1][1]) * PIXEL <= 14
    # The caption is no wider than the rule is long, and its lines are of nearly one length.
    extents = [np.flatnonzero(page[start:end].any(axis=0)) for start, end in lines[: rule + 1]]
    widths = [columns[-1] - columns[0] for columns in extents]
    assert max(widths[:-1]) <= widths[-1]
    assert min(widths[:-1]) >= 0.75 * max(widths[:-1])
    middles = [(columns[0] + columns[-1]) / 2 for columns in extents[:-1]]
    assert max(middles) - min(middles) <= 3 / PIXEL


def assert_it_is_turned(page: NDArray[np.bool_]) -> None:
    """Check that a table stands in the middle of the page, higher than it is wide, within the paper."""
    height, width = (np.flatnonzero(page.any(axis=axis)) for axis in (1, 0))
    assert height[-1] - height[0] > 1.5 * (width[-1] - width[0])
    assert abs(width[0] + width[-1] - page.shape[1]) * PIXEL <= 20
    assert (page.shape[0] - height[-1]) * PIXEL > 72


def rows(page: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return the first and the last row of pixels of every line that has ink."""
    inked = np.flatnonzero(np.diff(np.concatenate(([0], page.any(axis=1), [0]))))
    return [(int(start), int(end)) for start, end in inked.reshape(-1, 2)]


def ink(folder: Path, number: int) -> NDArray[np.bool_]:
    """Return where a page of the document has ink."""
    command = [require("pdftoppm"), "-gray", "-r", str(DPI), "-f", str(number), "-singlefile", "page.pdf"]
    subprocess.run([*command, str(number)], cwd=folder, check=True)
    content = (folder / f"{number}.pgm").read_bytes()
    head = re.match(rb"P5\s+(\d+)\s+(\d+)\s+255\s", content)
    assert head
    picture = np.frombuffer(content[head.end() :], np.uint8).reshape(int(head[2]), int(head[1]))
    return picture < 128


def test_pairs_and_pauses_show_what_belongs_together(tmp_path: Path) -> None:
    compiled("pdflatex", render(kurbel.table(lang="en"), "latex", standalone=True), tmp_path, runs=1)
    words = words_of_pdf(tmp_path / "page.pdf")
    heads = [(word.left, word.right) for word in words if word.text in ("Outstroke", "Return")]
    assert len(heads) == 6
    gaps = [right[0] - left[1] for left, right in pairwise(heads)]
    # In the last pair the figures have signs, and are wider than one of the headings.
    within, between = gaps[:4:2], gaps[1::2]
    # 1.3 and 2.6 em of 9.25 pt, the unit of small type; PDF counts points of 1/72 inch.
    assert np.allclose(within, 1.3 * 9.25 * 72 / 72.27, atol=1)
    assert min(between) >= 2 * 1.3 * 9.25 * 72 / 72.27 - 1
    assert has_pauses(words, least=0.3 * 9.25)


@pytest.mark.slow
def test_fragments_are_set_in_a_tagged_document(tmp_path: Path) -> None:
    for page in pages(False):
        (tmp_path / f"{page.anchor}.tex").write_text(render(page, "latex"), encoding="utf-8")
    text = "\\DocumentMetadata{lang=de,testphase=phase-II}\n" + document("article", "")
    log = compiled("lualatex", text, tmp_path, runs=2)
    # This kernel does not know yet that a paragraph may stand in another one, as in any minipage.
    assert [
        one for one in complaints(log) if "Package tagpdf Warning: The rule between parent" not in one
    ] == []
    told = subprocess.run([require("pdfinfo"), "page.pdf"], cwd=tmp_path, capture_output=True, check=True)
    assert re.search(rb"^Tagged: +yes$", told.stdout, re.MULTILINE)
