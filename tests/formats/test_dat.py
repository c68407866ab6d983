"""Columns of numbers, read by those who plot: held against CSV, and plotted by pgfplots."""

from __future__ import annotations

import csv
import io
import re
from dataclasses import replace
from pathlib import Path

import pytest
from everything import everything
from tex import compiled, complaints

import kurbel
from kurbel.formats.render import render


def test_fields_are_those_of_csv_and_curves_are_parted_by_a_blank_line() -> None:
    page = kurbel.table(ratio="1:5;1:4", angle="0..180:60", lang="de")
    lines = render(page, "dat").splitlines()
    assert [line.split(" ") for line in lines if line] == list(csv.reader(io.StringIO(render(page, "csv"))))
    assert [place for place, line in enumerate(lines) if not line] == [5]


def test_words_are_one_word_and_a_missing_value_is_nan() -> None:
    head, *rows = [line.split() for line in render(everything(), "dat").splitlines() if line]
    assert all(len(row) == len(head) == 4 for row in rows)
    assert rows[0] == ["1:5", "60", "0.500", "sagt_a;b_,_c"]
    assert rows[2][2:] == ["nan", "nan"]


@pytest.mark.parametrize("sign", '#%{}\\"$&~^ \t')
def test_what_tex_obeys_as_it_reads_a_word_is_not_in_it(sign: str) -> None:
    page = everything()
    label = sign.replace("$", r"\$").join(("a", "b", "", "c"))
    records = page.records._replace(rows=[("1:5", None, None, label)])
    _, row = render(replace(page, records=records), "dat").splitlines()
    assert row == "1:5 nan nan a_b_c"


@pytest.mark.slow
def test_pgfplots_draws_the_points_with_two_curves(tmp_path: Path) -> None:
    page = kurbel.table(ratio="1:5;1:4", angle="0..180:60", lang="de")
    (tmp_path / "drive.dat").write_text(render(page, "dat"), encoding="utf-8")
    text = r"""\documentclass{article}
\usepackage{pgfplotstable}
\pgfplotsset{compat=1.18}
\begin{document}
\pgfplotstableread{drive.dat}\drive
\pgfplotstablegetrowsof\drive\typeout{rows \pgfplotsretval}
\pgfplotstablegetelem{5}{x}\of\drive\typeout{x \pgfplotsretval}
\begin{tikzpicture}\begin{axis}\addplot table[x=phi,y=c_return]{drive.dat};\end{axis}\end{tikzpicture}
\end{document}
"""
    log = compiled("pdflatex", text, tmp_path)
    # pgfplots up to 1.18 has a stray ` in its code for blank lines (pgfplotsplothandlerappendjumpmarker`).
    assert [one for one in complaints(log) if "There is no ` in font nullfont" not in one] == []
    assert re.search(r"^rows 8$", log, re.MULTILINE)
    # R:L = 1:4 at 60°: 1 - cos φ + (1 - sqrt(1 - λ² sin² φ))/λ.
    assert re.search(r"^x 0\.5949$", log, re.MULTILINE)
