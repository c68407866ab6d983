"""The shipped layouts as an editor uses them: fragments in one LaTeX document, HTML in a browser."""

from __future__ import annotations

import csv
import io
import re
import subprocess
from pathlib import Path

import pytest
from pages import default_page
from test_latex import ENGINES, compiled, complaints
from test_render import fragment
from tools import require, require_library

from kurbel import make_engine_table, make_table, typeset_pdf
from kurbel.exact.numerals import Number, number_text
from kurbel.formats.render import render
from kurbel.page.labels import plain
from kurbel.page.layouts import LANGUAGES, layout_names
from kurbel.page.table import Row, Table

PREAMBLE = r"""\documentclass{article}
\usepackage{iftex}
\iftutex\usepackage{fontspec}\else\usepackage[T1]{fontenc}\usepackage[utf8]{inputenc}\fi
\usepackage{lmodern}
\usepackage[a4paper,textwidth=16cm,textheight=25cm]{geometry}
\usepackage[english,ngerman]{babel}
\usepackage{amsmath,array,booktabs,graphicx,longtable}
\begin{document}
"""


def all_pages() -> list[Table]:
    return [
        *(default_page(name, lang, f"{name}-{lang}") for name in layout_names() for lang in LANGUAGES),
        make_table(radius="0.3", speed=2, label="machine"),
        make_table(offset="0.1", lang="en", label="offset"),
        make_engine_table(methods="weisbach", label="weisbach"),
        make_engine_table(layout="delta-detail", ratios="1:4;1:5", cranks="0;90", label="cranks"),
        make_engine_table(layout="turning", expansions="2;4", angles="0..360:30", label="engines"),
        make_engine_table(back="0.1", exponent="1.13", clearance="0.05", double_acting=False, label="steam"),
    ]


@pytest.mark.parametrize("longtable", [False, True], ids=["table", "longtable"])
@pytest.mark.parametrize("engine", ENGINES)
def test_all_shipped_layouts_compile_in_one_document(engine: str, longtable: bool, tmp_path: Path) -> None:
    pages = all_pages()
    assert len(pages) >= 32
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
    for page, text in zip(pages, text_of_pdf(tmp_path).split("\f"), strict=False):
        # The prime of an angle is a zero in the text of a PDF.
        assert_rows_stand_in(text.splitlines(), page, angles=False)


FIGURE = re.compile(r"(?<![\w.,])[−-]?[0-9]+(?:[.,][0-9]+)?(?![\w.,])")


def rows_of_figures(lines: list[str]) -> list[list[str]]:
    """Return the figures of each line that has a whole row of them, in the notation of CSV."""
    rows = [FIGURE.findall(line) for line in lines]
    return [[figure.replace("−", "-").replace(",", ".") for figure in row] for row in rows if len(row) == 7]


def by_latex(page: Table, folder: Path) -> list[str]:
    compiled("pdflatex", render(page, "latex", standalone=True), folder)
    return text_of_pdf(folder).splitlines()


def by_typst(page: Table, folder: Path) -> list[str]:
    require_library("typst")
    (folder / "page.pdf").write_bytes(typeset_pdf(page))
    return text_of_pdf(folder).splitlines()


def text_of_pdf(folder: Path) -> str:
    subprocess.run([require("pdftotext"), "-layout", "page.pdf", "page.txt"], cwd=folder, check=True)
    return (folder / "page.txt").read_text(encoding="utf-8")


def in_html(page: Table) -> list[str]:
    return [" ".join("".join(cell.itertext()) for cell in row) for row in fragment(page).iter("tr")]


@pytest.mark.parametrize("lang", LANGUAGES)
@pytest.mark.parametrize("form", ["latex", "pdf", "html", "markdown", "text"])
def test_the_same_digits_stand_in_every_format(form: str, lang: str, tmp_path: Path) -> None:
    page = make_table(lang=lang)
    records = list(csv.reader(io.StringIO(render(page, "csv"))))[1:]
    if form in ("latex", "pdf"):
        lines = {"latex": by_latex, "pdf": by_typst}[form](page, tmp_path)
    else:
        lines = in_html(page) if form == "html" else render(page, form).splitlines()
    assert rows_of_figures(lines) == [record[1:] for record in records]
    assert len(records) == 19


@pytest.mark.parametrize("form", ["html", "markdown", "text"])
def test_every_page_has_its_rows_in_every_format(form: str) -> None:
    for page in all_pages():
        lines = in_html(page) if form == "html" else render(page, form).splitlines()
        assert_rows_stand_in(lines, page)


def assert_rows_stand_in(lines: list[str], page: Table, angles: bool = True) -> None:
    """Check that the figures of every row of the page stand in a line, from left to right and going down."""
    below = iter(lines)
    rows = [row_of_figures(row, page.lang, angles) for panel in page.panels for row in panel.rows()]
    assert any(rows)
    for row in rows:
        pattern = re.compile(".*?".join(rf"(?<![\d.,]){re.escape(figure)}(?!\d|[.,]\d)" for figure in row))
        assert any(pattern.search(written(line)) for line in below), f"{page.key} has no row {row}"


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
