"""Each layout in each class: on pages of its own, within the margins, in type of 7 pt and more."""

from __future__ import annotations

import re
import subprocess
from collections import Counter
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pages import default_page
from rows import text_of_pdf
from tex import compiled, complaints
from tools import require
from typeset import narrowest_figure, words_of_pdf

import kurbel
from kurbel.exact.numerals import Number, number_text
from kurbel.formats.render import render
from kurbel.page.layouts import LANGUAGES, layout_names
from kurbel.page.table import Table

DPI = 36
POINT = DPI / 72.27
# Some that are turned or too high for large type, one of three pages, one of two panels, and a narrow one.
SAMPLE = ("machine-forces", "speed", "turning", "formulas", "roetscher-112", "kolbenwege", "delta-tafel")
CLASSES = (
    *(
        ("article", f"{paper},{size}")
        for paper in ("letterpaper", "a4paper")
        for size in ("10pt", "11pt", "12pt")
    ),
    ("report", "letterpaper,10pt"),
    ("scrartcl", "11pt"),
    ("scrbook", "11pt"),
    ("memoir", "10pt"),
)
LENGTHS = ("oddsidemargin", "evensidemargin", "topmargin", "headheight", "headsep", "textwidth", "textheight")


def document(name: str, options: str, inputs: list[Table]) -> str:
    babel = {"de": "ngerman", "en": "english"}
    body = "".join(
        f"\\clearpage\\selectlanguage{{{babel[page.lang]}}}\n\\input{{{page.key}}}\n" for page in inputs
    )
    lengths = " ".join(rf"\the\{length}" for length in LENGTHS)
    return rf"""\documentclass[{options}]{{{name}}}
\usepackage{{iftex}}
\iftutex\usepackage{{fontspec}}\else\usepackage[T1]{{fontenc}}\fi
\usepackage{{lmodern}}
\usepackage[english,ngerman]{{babel}}
\usepackage{{amsmath,array,booktabs,graphicx,longtable,lscape,siunitx}}
\sisetup{{group-digits=none}}
\pagestyle{{empty}}
\begin{{document}}
\typeout{{lengths {lengths}}}
{body}\end{{document}}
"""


def set_in(name: str, options: str, engine: str, pages: list[Table], folder: Path, **wishes: Any) -> str:
    """Set the pages in a class, each beginning a page; return the log."""
    for page in pages:
        (folder / f"{page.key}.tex").write_text(render(page, "latex", **wishes), encoding="utf-8")
    runs = 4 if wishes.get("longtable") else 2
    return compiled(engine, document(name, options, pages), folder, runs=runs)


def figures(text: str) -> Counter[str]:
    return Counter(re.findall(r"\d+[.,]\d+", text))


def figures_of(pages: list[Table]) -> Counter[str]:
    """Return the numbers with decimals that stand in the cells of the pages."""
    cells = (
        cell.value
        for page in pages
        for panel in page.panels
        for row in panel.rows()
        for cell in (*row.stub, *row.cells)
    )
    (lang,) = {page.lang for page in pages}
    mark = {"de": ",", "en": "."}[lang]
    return Counter(
        number_text(value, mark).lstrip("-−")
        for value in cells
        if isinstance(value, Number) and value.decimals
    )


def assert_within_the_margins(folder: Path, log: str) -> None:
    """Check that all ink is where the text of a page may stand, so none where its foot does."""
    found = re.search(r"^lengths (.*)", log, re.MULTILINE)
    assert found
    lengths = map(float, re.findall(r"(-?[\d.]+)pt", found[1]))
    odd, even, top, head, separation, width, height = lengths
    above = 72.27 + top + head + separation
    command = [require("pdftoppm"), "-gray", "-r", str(DPI), "page.pdf"]
    made = subprocess.run(command, cwd=folder, capture_output=True, check=True).stdout
    number, at = 0, 0
    while at < len(made):
        number += 1
        start = re.compile(rb"P5\s+(\d+)\s+(\d+)\s+255\s").match(made, at)
        assert start
        columns, rows = int(start[1]), int(start[2])
        picture = np.frombuffer(made, np.uint8, columns * rows, start.end()).reshape(rows, columns)
        at = start.end() + columns * rows
        left = 72.27 + (odd if number % 2 or "scrartcl" in log.split("\n")[0] else even)
        inked = [np.flatnonzero((picture < 200).any(axis=axis)) / POINT for axis in (0, 1)]
        for ink, first, room in zip(inked, (left, above), (width, height), strict=True):
            assert len(ink), f"page {number} is empty"
            assert first - 4 <= ink[0] and ink[-1] <= first + room + 4, f"page {number}"


def assert_pages_are_fit(pages: list[Table], folder: Path, log: str) -> None:
    assert complaints(log) == []
    assert_within_the_margins(folder, log)
    assert narrowest_figure(folder) > 0.98
    assert figures_of(pages) - figures("\n".join(text_of_pdf(folder).splitlines())) == Counter()


def test_a_sample_of_layouts_is_set_whole(tmp_path: Path) -> None:
    pages = [default_page(name, "en", name) for name in SAMPLE]
    log = set_in("article", "letterpaper,10pt", "pdflatex", pages, tmp_path)
    assert_pages_are_fit(pages, tmp_path, log)
    assert "Package kurbel Info: tab:machine-forces is set in type of 8pt" in log
    # Three pages of formulas, and two of each that is turned and higher than a line is long.
    assert "(11 pages" in log
    # Both parts of a turned table stand at the head of their pages, which is on the left.
    words = words_of_pdf(tmp_path / "page.pdf")
    heads = [min(word.left for word in words if word.page == page) for page in (1, 2)]
    assert heads == pytest.approx([heads[0]] * 2, abs=3)


@pytest.mark.slow
@pytest.mark.parametrize("longtable", [False, True], ids=["table", "longtable"])
@pytest.mark.parametrize("engine", ["pdflatex", "lualatex"])
@pytest.mark.parametrize(("name", "options"), CLASSES)
def test_each_layout_is_set_whole(
    name: str, options: str, engine: str, longtable: bool, tmp_path: Path
) -> None:
    lang = LANGUAGES[(len(name) + len(options) + len(engine)) % 2]
    pages = [default_page(one, lang, one) for one in layout_names()]
    log = set_in(name, options, engine, pages, tmp_path, longtable=longtable)
    assert_pages_are_fit(pages, tmp_path, log)


# Groups of such lengths that pages end within them and between them.
@pytest.mark.parametrize(("longtable", "step"), [(False, 30), (True, 45)], ids=["table", "longtable"])
def test_a_group_that_goes_on_is_named_at_the_head_of_the_page(
    longtable: bool, step: int, tmp_path: Path
) -> None:
    angles = f"0..180:{step}"
    page = kurbel.table(ratio="1:3..7:0.1", angle=angles, columns="x,c", lang="en", label="groups")
    log = set_in("article", "letterpaper,10pt", "pdflatex", [page], tmp_path, longtable=longtable)
    assert complaints(log) == []
    sheets = text_of_pdf(tmp_path).rstrip("\f").split("\f")
    assert len(sheets) >= 5
    tops = set()
    for before, after in pairwise(sheets):
        lines = [line.split() for line in after.splitlines() if line.strip()]
        head = next(place for place, words in enumerate(lines) if "x/R" in words)
        first = " ".join(lines[head + 1])
        last = re.findall(r"1:[0-9.]+", before)[-1]
        rows = [line.split() for line in before.splitlines() if re.match(r"\s*\d+\s+\d\.\d+", line)]
        goes_on = rows[-1][0] != "180"
        assert ("continued" in first) == goes_on
        assert (last in first) == goes_on
        tops.add(goes_on)
    assert tops == {True, False}


@pytest.mark.parametrize(("ratio", "lengths"), [("1:5", range(26, 36)), ("1:4;1:5", range(11, 18))])
def test_notes_stand_below_rows_of_their_table(ratio: str, lengths: range, tmp_path: Path) -> None:
    pages = [
        kurbel.table(ratio, angle=f"0..{last}:1", columns="x,c", lang="en", label=f"to-{last}")
        for last in lengths
    ]
    for page in pages:
        (tmp_path / f"{page.anchor}.tex").write_text(render(page, "latex", longtable=True), encoding="utf-8")
    inputs = "".join(f"\\clearpage\\input{{{page.anchor}}}\n" for page in pages)
    text = document("article", "letterpaper,10pt", []).replace(r"\end{document}", inputs + r"\end{document}")
    assert complaints(compiled("pdflatex", text, tmp_path, runs=3)) == []
    # Of the lengths some fill the page with their rows, so that their notes go on.
    sheets = text_of_pdf(tmp_path).rstrip("\f").split("\f")
    assert len(pages) < len(sheets) < 2 * len(pages)
    for sheet in sheets:
        rows = re.findall(r"^ *\d+ +\d\.\d{4}", sheet, re.MULTILINE)
        assert len(rows) >= 3
    assert sum("sin" in sheet for sheet in sheets) == len(pages)


def test_what_is_too_long_for_floats_names_the_option_that_helps(tmp_path: Path) -> None:
    page = kurbel.table(angle="0..360:1", lang="en", label="long")
    (tmp_path / "long.tex").write_text(render(page, "latex"), encoding="utf-8")
    text = document("article", "10pt", [page]).replace("{kinematics}", "{long}")
    log = compiled(
        "pdflatex", text.replace(r"\begin{document}", "\\textheight4cm\n\\begin{document}"), tmp_path
    )
    # The log breaks its lines.
    said = "Package kurbel Warning: tab:long is too long for floats; --longtable sets it"
    assert [one.startswith(said) for one in complaints(log) if "kurbel" in one] == [True]


# As an author types it.
BY_HAND = r"""\begin{table}[htbp]
\centering\small
\caption{Piston path and piston velocity for $R{:}L=1{:}4$; exact formulas}\label{tab:motion}
\begin{tabular}{@{}rrrrr@{}}
\toprule
 & \multicolumn{2}{c}{Piston path $x/R$} & \multicolumn{2}{c}{Piston velocity $c/v$} \\
\cmidrule(lr){2-3}\cmidrule(l){4-5}
$\varphi$ in $^\circ$ & Outstroke & Return & Outstroke & Return \\
\midrule
0 & 0.0000 & 0.0000 & 0.0000 & 0.0000 \\
30 & 0.1653 & 0.1026 & 0.6091 & 0.3909 \\
60 & 0.5949 & 0.4051 & 0.9769 & 0.7551 \\
90 & 1.1270 & 0.8730 & 1.0000 & 1.0000 \\
120 & 1.5949 & 1.4051 & 0.7551 & 0.9769 \\
150 & 1.8974 & 1.8347 & 0.3909 & 0.6091 \\
180 & 2.0000 & 2.0000 & 0.0000 & 0.0000 \\
\bottomrule
\end{tabular}

\smallskip\footnotesize
$\displaystyle x/R=1-\cos\varphi\pm\frac{1-\cos\psi}{\lambda}$,
$\displaystyle c/v=\sin\varphi\pm\frac{\lambda\sin\varphi\cos\varphi}{\cos\psi}$,
$\sin\psi=\lambda\sin\varphi$, $\lambda=R/L$

upper sign: outstroke, lower sign: return stroke
\end{table}
"""
MACHINERY = re.compile(r"box|minipage|newcommand|dimen|dimexpr|\\def|hspace|rule\[|\\if|csname")


def test_the_plain_form_is_as_short_as_one_that_is_typed() -> None:
    page = kurbel.table("1:4", angle="0..180:30", columns="x,x_return,c,c_return", lang="en", label="motion")
    text = render(page, "latex", plain=True)
    for line in BY_HAND.splitlines():
        if re.match(r"\d+ &", line):
            assert line in text
    assert len(text) <= 1.1 * len(BY_HAND)


@pytest.mark.parametrize("siunitx", [False, pytest.param(True, marks=pytest.mark.slow)])
@pytest.mark.parametrize("longtable", [False, pytest.param(True, marks=pytest.mark.slow)])
def test_the_plain_form_has_every_figure_and_no_machinery(
    longtable: bool, siunitx: bool, tmp_path: Path
) -> None:
    names = ("kinematics", "blau-kolbenwege", "delta-tafel", "balance", "harmonics")
    pages = [default_page(name, "en", name) for name in names]
    log = set_in(
        "article", "a4paper", "pdflatex", pages, tmp_path, plain=True, longtable=longtable, siunitx=siunitx
    )
    assert complaints(log) == []
    assert figures_of(pages) - figures(text_of_pdf(tmp_path)) == Counter()
    for page in pages:
        assert not MACHINERY.findall((tmp_path / f"{page.key}.tex").read_text(encoding="utf-8"))
