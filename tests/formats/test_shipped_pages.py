"""The shipped layouts as an editor uses them: fragments in one LaTeX document, HTML in a browser."""

from __future__ import annotations

import csv
import io
import re
from pathlib import Path

import pytest
from pages import all_pages, default_page
from readers import fragment
from rows import assert_rows_stand_in, lines_of_pdf, text_of_pdf
from tex import PREAMBLE, compiled, complaints, each_engine, each_kind_of_table
from tools import require_library
from typeset import narrowest_figure

from kurbel import table, typeset_pdf
from kurbel.formats.registry import FORMATS
from kurbel.formats.render import render
from kurbel.page.layouts import layout_names
from kurbel.page.table import Table

# The pages that kurbel says to be longer than one of paper.
TALL = ("formulas-de", "formulas-en")


@pytest.mark.slow
@each_kind_of_table
@each_engine
def test_all_shipped_layouts_compile_in_one_document(engine: str, longtable: bool, tmp_path: Path) -> None:
    pages = [page for page in all_pages() if page.key not in TALL]
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
    assert narrowest_figure(tmp_path) > 0.98
    for page, lines in zip(pages, lines_of_pdf(tmp_path), strict=True):
        # The prime of an angle is a zero in the text of a PDF.
        assert_rows_stand_in(lines, page, angles=False)


@pytest.mark.slow
@each_engine
def test_layouts_longer_than_a_page_break_and_fit_the_line(engine: str, tmp_path: Path) -> None:
    assert tuple(page.key for page in all_pages() if FORMATS["latex"].is_tall(page)) == TALL
    for page in all_pages():
        if page.key in TALL:
            text = render(page, "latex", longtable=True, standalone=True)
            assert complaints(compiled(engine, text, tmp_path, runs=3)) == []
            assert_rows_stand_in(text_of_pdf(tmp_path).splitlines(), page, angles=False)


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


def in_html(page: Table) -> list[str]:
    return [" ".join("".join(cell.itertext()) for cell in row) for row in fragment(page).iter("tr")]


@pytest.mark.parametrize(
    ("form", "lang"), [("latex", "de"), ("pdf", "en"), ("html", "en"), ("markdown", "de"), ("text", "de")]
)
def test_the_same_digits_stand_in_every_format(form: str, lang: str, tmp_path: Path) -> None:
    page = table(lang=lang)
    records = list(csv.reader(io.StringIO(render(page, "csv"))))[1:]
    if form in ("latex", "pdf"):
        lines = {"latex": by_latex, "pdf": by_typst}[form](page, tmp_path)
    else:
        lines = in_html(page) if form == "html" else render(page, form).splitlines()
    assert rows_of_figures(lines) == [record[1:] for record in records]
    assert len(records) == 19


@pytest.mark.parametrize("form", ["html", "text"])
def test_pages_have_their_rows(form: str) -> None:
    """Markdown and reStructuredText are read cell by cell."""
    for name in layout_names()[::2]:
        page = default_page(name)
        lines = in_html(page) if form == "html" else render(page, form).splitlines()
        assert_rows_stand_in(lines, page)
