"""LaTeX pages compile with both engines, without a single warning."""

from __future__ import annotations

import re
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from everything import everything, tall, wide
from tex import PREAMBLE, compiled, complaints, each_engine
from tools import missing, require

from kurbel.formats.registry import FORMATS
from kurbel.formats.render import render


@each_engine
def test_page_with_every_part_compiles_without_warnings(engine: str, tmp_path: Path) -> None:
    # The label of the table needs a second run.
    log = compiled(engine, render(everything(), "latex", standalone=True), tmp_path, runs=2)
    assert complaints(log) == []
    assert "Output written on page.pdf (1 page" in log


@pytest.mark.parametrize("decimals", [4, 8])
def test_twelve_columns_fit_the_page(decimals: int, tmp_path: Path) -> None:
    log = compiled("pdflatex", render(wide(decimals), "latex", standalone=True), tmp_path, runs=2)
    assert complaints(log) == []


def test_table_longer_than_a_page_breaks_and_repeats_its_head(tmp_path: Path) -> None:
    text = render(tall(), "latex", standalone=True)
    assert text.count(r"\begin{longtable}") == 2
    assert r"\tablename~\thetable\ (continued)" in text
    log = compiled("pdflatex", text, tmp_path, runs=3)
    assert complaints(log) == []
    assert "(4 pages" in log


@pytest.mark.parametrize(
    "wishes", [{}, {"longtable": True}, {"plain": True}], ids=["table", "longtable", "plain"]
)
def test_a_table_has_a_heavy_rule_on_each_side_and_a_thin_one_below_its_heads(
    wishes: dict[str, Any], tmp_path: Path
) -> None:
    text = render(replace(tall(6), panels=tall(6).panels[:1]), "latex", **wishes)
    compiled("pdflatex", f"{PREAMBLE}\\pagestyle{{empty}}{text}\\end{{document}}\n", tmp_path, runs=2)
    command = [require("pdftoppm"), "-gray", "-r", "600", "-l", "1", "page.pdf"]
    made = subprocess.run(command, cwd=tmp_path, capture_output=True, check=True).stdout
    start = re.match(rb"P5\s+(\d+)\s+(\d+)\s+255\s", made)
    assert start
    ink = np.frombuffer(made, np.uint8, offset=start.end()).reshape(int(start[2]), int(start[1])) < 200
    # A rule goes through the middle of the page, unbroken for 1 cm; no letter does.
    middle = ink.shape[1] // 2
    lines = np.flatnonzero(ink[:, middle - 120 : middle + 120].all(axis=1))
    rules = np.split(lines, np.flatnonzero(np.diff(lines) > 1) + 1)
    top, below, bottom = map(len, rules)
    assert abs(top - bottom) <= 1 and min(top, bottom) > below + 1
    assert rules[1][0] - rules[0][-1] < rules[2][0] - rules[1][-1]


def test_longtable_has_every_part_too(tmp_path: Path) -> None:
    fragment = render(everything(), "latex", longtable=True)
    assert fragment.startswith("% Packages: amsmath, array, booktabs, longtable\n")
    text = render(everything(), "latex", standalone=True, longtable=True)
    assert complaints(compiled("pdflatex", text, tmp_path, runs=3)) == []


def test_awkward_prose_is_printed_as_it_was_written(tmp_path: Path) -> None:
    program = require("pdftotext")
    compiled("pdflatex", render(everything(), "latex", standalone=True), tmp_path)
    subprocess.run([program, "-layout", "page.pdf"], cwd=tmp_path, check=True)
    text = " ".join((tmp_path / "page.txt").read_text(encoding="utf-8").split())
    assert r"50 % & $, a|b, #_{}~^\, <script>alert(1)</script>, [x] *y* `z` -" in text


def test_columns_of_siunitx_have_the_numbers_as_they_are_typed() -> None:
    text = render(everything(), "latex", siunitx=True)
    assert text.startswith("% Packages: amsmath, array, booktabs, graphicx, siunitx\n")
    # Figures with a sign, two digits before the mark and three behind it; angles and words are left alone.
    assert text.count("S[table-format=-2.3]") == 1
    assert r"60 & 0,576 & 0,424 & -0,954{\rlap{\textsuperscript{b)}}} & 9$^\circ$58" in text
    assert r"\sisetup{output-decimal-marker={,}}" in text
    assert "siunitx" not in render(everything(), "latex")


@pytest.mark.slow
@each_engine
def test_siunitx_sets_its_columns_without_warnings(engine: str, tmp_path: Path) -> None:
    if not subprocess.run([require("kpsewhich"), "siunitx.sty"], capture_output=True, check=False).stdout:
        missing("siunitx")
    text = render(everything(), "latex", standalone=True, siunitx=True)
    assert complaints(compiled(engine, text, tmp_path, runs=2)) == []


def test_table_wider_than_paper_is_pointed_out() -> None:
    said = "the table is wider than a line of 16 cm in type of 7 pt; LaTeX turns it"
    assert list(FORMATS["latex"].remarks(wide(8), False)) == [said]
    assert list(FORMATS["latex"].remarks(wide(4), False)) == []
    assert list(FORMATS["html"].remarks(wide(8), False)) == []


@pytest.mark.slow
def test_type_below_7_points_is_pointed_out_in_the_log(tmp_path: Path) -> None:
    (tmp_path / "table.tex").write_text(render(wide(2), "latex"), encoding="utf-8")
    text = (
        PREAMBLE.replace("textwidth=16cm", "textwidth=7cm,textheight=6cm") + "\\input{table}\\end{document}\n"
    )
    log = compiled("pdflatex", text, tmp_path)
    # The log breaks its lines.
    said = "Package kurbel Warning: The line is too short for tab:wide: its type is"
    assert complaints(log)[0].startswith(said)
