"""The shipped layouts as an editor uses them: fragments in one LaTeX document, HTML in a browser."""

from __future__ import annotations

import csv
import io
import re
import subprocess
from fractions import Fraction
from pathlib import Path

import pytest
from test_latex import ENGINES, compiled, complaints
from test_render import fragment
from tools import require

from kurbel import notation
from kurbel.build import build
from kurbel.layouts import LANGUAGES, layout, layout_names
from kurbel.problem import Crank, Speed
from kurbel.render import render
from kurbel.request import Request
from kurbel.table import Table

PREAMBLE = r"""\documentclass{article}
\usepackage{iftex}
\iftutex\usepackage{fontspec}\else\usepackage[T1]{fontenc}\usepackage[utf8]{inputenc}\fi
\usepackage{lmodern}
\usepackage[a4paper,textwidth=16cm,textheight=25cm]{geometry}
\usepackage[english,ngerman]{babel}
\usepackage{amsmath,array,booktabs,graphicx,longtable}
\begin{document}
"""


def shipped(name: str, lang: str, **machine: object) -> Table:
    page = layout(name)
    cranks = tuple(Crank(ratio, **machine) for ratio in notation.ratios(page.ratios))  # type: ignore[arg-type]
    label = "-".join((name, lang, *machine))
    return build(Request(page, cranks, notation.angles(page.angles), lang=lang, label=label))


def all_pages() -> list[Table]:
    pages = [shipped(name, lang) for name in layout_names() for lang in LANGUAGES]
    machine = {"radius": Fraction(3, 10), "speed": Speed(Fraction(2))}
    return [
        *pages,
        shipped("kinematics", "de", **machine),
        shipped("kinematics", "en", offset=Fraction(1, 10)),
    ]


@pytest.mark.parametrize("longtable", [False, True], ids=["table", "longtable"])
@pytest.mark.parametrize("engine", ENGINES)
def test_all_shipped_layouts_compile_in_one_document(engine: str, longtable: bool, tmp_path: Path) -> None:
    pages = all_pages()
    assert len(pages) >= 14
    for page in pages:
        text = render(page, "latex", longtable=longtable)
        (tmp_path / f"{page.key}.tex").write_text(text, encoding="utf-8")
    babel = {"de": "ngerman", "en": "english"}
    inputs = "".join(
        f"\\selectlanguage{{{babel[page.lang]}}}\n\\input{{{page.key}}}\n\\clearpage\n" for page in pages
    )
    log = compiled(engine, f"{PREAMBLE}{inputs}\\end{{document}}\n", tmp_path, runs=3 if longtable else 2)
    assert complaints(log) == []
    assert f"Output written on page.pdf ({len(pages)} pages" in log


FIGURE = re.compile(r"(?<![\w.,])[−-]?[0-9]+(?:[.,][0-9]+)?(?![\w.,])")


def rows_of_figures(lines: list[str]) -> list[list[str]]:
    """Return the figures of each line that has a whole row of them, in the notation of CSV."""
    rows = [FIGURE.findall(line) for line in lines]
    return [[figure.replace("−", "-").replace(",", ".") for figure in row] for row in rows if len(row) == 7]


def in_pdf(page: Table, folder: Path) -> list[str]:
    program = require("pdftotext")
    compiled("pdflatex", render(page, "latex", standalone=True), folder)
    subprocess.run([program, "-layout", "page.pdf", "page.txt"], cwd=folder, check=True)
    return (folder / "page.txt").read_text(encoding="utf-8").splitlines()


def in_html(page: Table) -> list[str]:
    return [" ".join("".join(cell.itertext()) for cell in row) for row in fragment(page).iter("tr")]


@pytest.mark.parametrize("lang", LANGUAGES)
@pytest.mark.parametrize("form", ["pdf", "html", "markdown", "text"])
def test_the_same_digits_stand_in_every_format(form: str, lang: str, tmp_path: Path) -> None:
    page = shipped("kinematics", lang)
    records = list(csv.reader(io.StringIO(render(page, "csv"))))[1:]
    if form == "pdf":
        lines = in_pdf(page, tmp_path)
    else:
        lines = in_html(page) if form == "html" else render(page, form).splitlines()
    assert rows_of_figures(lines) == [record[1:] for record in records]
    assert len(records) == 19
