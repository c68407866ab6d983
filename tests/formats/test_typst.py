"""Typst: nothing in prose is obeyed, and the fragments of a handbook compile in one document."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from cli import printed
from everything import everything, tall, wide
from hypothesis import example, given, settings
from hypothesis import strategies as st
from pages import all_pages
from rows import assert_rows_stand_in, text_of_pdf
from tools import require_library
from typeset import broken_formulas, least_type, page_width, words_of_pdf

from kurbel import KurbelError
from kurbel.exact.numerals import Number
from kurbel.formats.render import render
from kurbel.formats.typst.writer import Writer
from kurbel.formats.typst.writer import escape as escape_typst
from kurbel.formats.typst.writer import string as string_typst
from kurbel.page.formula import Formula
from kurbel.page.labels import formula_plain, parse
from kurbel.page.table import DITTO, Cell, Column, Group, Panel, Row

require_library("typst")

WRITER = Writer()

HEAD = (
    '#set text(font: "Libertinus Serif")\n#show math.equation: set text(font: "New Computer Modern Math")\n'
)
# What Typst obeys, and what stands beside it.
_SIGNS = st.sampled_from(
    [*"#$*_@<>`\\[]/~-.,'\"=+:;(){}!?&|^%", *"a1 ", "--", "...", "//", "/*", "*/", "https://"]
)
_PROSE = st.one_of(
    st.lists(_SIGNS).map("".join), st.text(st.characters(codec="utf-8", exclude_categories=["C"]))
)


def queried(document: str, selector: str = "<found>", field: str = "value") -> list[Any]:
    """Return that field of all elements of a document, in order."""
    import typst

    found = typst.query(document.encode(), selector, field=field, ignore_system_fonts=True)
    return list(json.loads(found))


def words_of(content: Any) -> Iterator[str]:
    """Yield the text of content that is nothing but text and spaces."""
    if content["func"] == "sequence":
        for child in content["children"]:
            yield from words_of(child)
    else:
        # A character after a backslash is a symbol.
        assert content["func"] in ("text", "symbol", "space")
        yield " " if content["func"] == "space" else str(content["text"])


def in_typst(pieces: list[str]) -> list[str]:
    """Return what Typst prints of content in square brackets."""
    document = "".join(f"#metadata([{piece}]) <found>\n" for piece in pieces)
    return ["".join(words_of(content)) for content in queried(document)]


@settings(max_examples=60, deadline=None)
@example(
    ["= a", "+ a", "- a", "/ a: b", "1. a", "12. a", "#a", "@a", "<a>", "*a*", "_a_", "`a`", "$a$", "[a]"]
)
@example(
    [
        *("http://a", "a // b", "/* a */", "a -- b", "-1", "a-1", "a-?", "a...b", "'a'"),
        *("a'a", '"a"', "a~b", "\\", "a \\", "-¼", "-Ⅳ"),
    ]
)
@given(st.lists(_PROSE, min_size=1, max_size=20))
def test_no_prose_is_obeyed(texts: list[str]) -> None:
    prose = [re.sub(r"[ \u2028\u2029]+", " ", text).strip(" ") for text in texts]
    assert in_typst([escape_typst(one) for one in prose]) == list(map(in_print, prose))


def in_print(prose: str) -> str:
    """Return prose whose apostrophes between letters are those of print."""
    return re.sub(r"(?<=[^\W\d_])'(?=[^\W\d_])", "’", prose)


def test_an_apostrophe_within_a_word_is_that_of_print_and_a_prime_is_not() -> None:
    made = printed("delta", "--ratio=1:5", "--lang=en", "-f", "typst").out
    assert "Mariotte’s law" in made
    assert escape_typst("r' and 5'") == r"r\' and 5\'"


@settings(max_examples=30, deadline=None)
@given(st.lists(_PROSE, min_size=1, max_size=20))
def test_no_prose_is_obeyed_beside_marks_and_formulas(texts: list[str]) -> None:
    prose = [re.sub(r"[ \u2028\u2029]+", " ", text) for text in texts]
    before, after = WRITER.note_mark("a"), WRITER.formula(formula("x"), ".")
    pieces = [f"{before}{escape_typst(one)}{after}" for one in prose]
    contents = queried("".join(f"#metadata([{piece}]) <found>\n" for piece in pieces))
    for one, content in zip(prose, contents, strict=True):
        first, *middle, last = content["children"]
        assert (first["func"], last["func"]) == ("super", "equation")
        assert "".join(word for child in middle for word in words_of(child)) == in_print(one)


@given(st.text(st.characters(codec="utf-8", exclude_categories=["C"])))
@settings(max_examples=50, deadline=None)
def test_strings_of_code_are_the_text(text: str) -> None:
    assert queried(f"#metadata({string_typst(text)}) <found>") == [text]


def formula(source: str) -> Formula:
    (part,) = parse(f"${source}$")
    assert isinstance(part, Formula)
    return part


_PIECES = st.sampled_from(
    [*"()[]/_^ -<>±·×:°'", "sin", "max", "xy", "x", "φ", "2", "4.5", '"#a$"', "sqrt(2)"]
)


@settings(max_examples=40, deadline=None)
@given(st.lists(st.lists(_PIECES, min_size=1, max_size=8).map("".join), min_size=10))
def test_any_formula_is_understood_and_has_its_text(sources: list[str]) -> None:
    formulas = list(understood(sources))
    document = "\n".join(WRITER.formula(one, ",", display) for one in formulas for display in (False, True))
    texts = [formula_plain(one, ",") for one in formulas]
    assert queried(document, "math.equation", "alt") == [text for text in texts for _ in range(2)]


def understood(sources: list[str]) -> Iterator[Formula]:
    for source in sources:
        try:
            yield formula(source)
        except (KurbelError, ValueError):
            continue


def compiled(document: str, folder: Path, *standards: str) -> list[str]:
    """Compile a document of the files in a folder without a warning and return the text of its pages."""
    import typst

    (folder / "page.typ").write_text(document, encoding="utf-8")
    made, warnings = typst.Compiler(
        str(folder / "page.typ"), root=str(folder), ignore_system_fonts=True
    ).compile_with_warnings(format="pdf", pdf_standards=list(standards), timestamp=0)  # type: ignore[arg-type]
    assert [warning.message for warning in warnings] == []
    assert isinstance(made, bytes)
    (folder / "page.pdf").write_bytes(made)
    return text_of_pdf(folder).split("\f")[:-1]


@pytest.mark.slow
def test_all_shipped_layouts_compile_in_one_archivable_and_accessible_handbook(tmp_path: Path) -> None:
    pages = all_pages()
    assert len(pages) >= 32
    document = '#set document(title: "Handbuch")\n#set text(lang: "de")\n' + HEAD
    document += "#show outline.entry: it => { show math.equation: box; it }\n"
    document += "#outline(target: figure.where(kind: table))\n"
    (tmp_path / "tables").mkdir()
    for page in pages:
        (tmp_path / "tables" / f"{page.key}.typ").write_text(render(page, "typst"), encoding="utf-8")
        document += f'#pagebreak()\n= {page.key}\n#include "tables/{page.key}.typ"\nSiehe @tab-{page.key}.\n'
    texts = "\f".join(compiled(document, tmp_path, "a-2b", "ua-1")).split("Siehe Tabelle ")
    assert list(broken_formulas(words_of_pdf(tmp_path / "page.pdf"))) == []
    assert len(texts) == len(pages) + 1
    for number, (page, text) in enumerate(zip(pages, texts, strict=False), 1):
        assert f"Tabelle {number}: " in text
        assert_rows_stand_in(text.splitlines(), page, angles=False)


@pytest.mark.parametrize("lang", ["de", "en"])
def test_page_with_every_part_is_archivable_and_accessible(lang: str, tmp_path: Path) -> None:
    (text,) = compiled(render(everything(lang=lang), "typst", standalone=True), tmp_path, "a-2b", "ua-1")
    assert {"de": "Tabelle 1. ", "en": "Table 1. "}[lang] in text
    # Lines may break anywhere.
    signs = r"""50 % & $, a|b, #_{}~^\, <script>alert(1)</script>, [x] *y* `z` -- ,, "q" """
    assert "".join(signs.split()) in "".join(text.split())


@pytest.mark.parametrize(("decimals", "width"), [(3, 210), (8, 297), (30, 500)])
def test_twelve_columns_fit_their_page_in_type_that_can_be_read(
    decimals: int, width: int, tmp_path: Path
) -> None:
    page = wide(decimals)
    (text,) = compiled(render(page, "typst", standalone=True), tmp_path)
    assert_rows_stand_in(text.splitlines(), page)
    words = words_of_pdf(tmp_path / "page.pdf")
    assert 7 <= least_type(words) <= 9.6
    # 12 columns of 30 decimals, each 15 em wide, in type of 7 points take 45 cm.
    assert page_width(tmp_path / "page.pdf") >= width
    assert max(word.right for word in words) <= (page_width(tmp_path / "page.pdf") - 29) * 72 / 25.4


def test_table_longer_than_a_page_breaks_and_repeats_its_heads(tmp_path: Path) -> None:
    pages = compiled(render(tall(200), "typst", standalone=True), tmp_path, "ua-1")
    assert len(pages) == 9
    assert [page.count("Table 1 (continued)") for page in pages] == [0] + [1] * 7 + [0]
    assert [page.split()[-1] for page in pages] == [str(number) for number in range(1, 10)]
    assert all(re.search("Gruppe|Source", page) for page in pages)
    numbers = [int(found) for page in pages for found in re.findall(r"^ *(\d+) +0[.]", page, re.MULTILINE)]
    assert numbers == [*range(200), *range(200)]


@pytest.mark.parametrize("height", [110, 117, 124])
def test_no_page_ends_within_an_equation(height: int, tmp_path: Path) -> None:
    # A line of the working, what goes on with it, and a second figure of it.
    lines = [
        one
        for number in range(12)
        for one in (f"$a_{number} = 1$", "\N{NO-BREAK SPACE}$= 2$", DITTO, f"$c_{number} = 4$")
    ]
    rows = tuple(Row((Cell(line),), (Cell(Number(500 + place, 0)),)) for place, line in enumerate(lines))
    panel = Panel((Column("line", ("Rechnung",)),), (Column("x", ("x",)),), (Group(rows),))
    page = replace(everything(), panels=(panel,), notes=(), caption="", source="")
    source = f"{HEAD}#set page(width: 150mm, height: {height}mm)\n{render(page, 'typst')}"
    pages = compiled(source, tmp_path)
    assert len(pages) > 1
    figures = [[int(one) - 500 for one in re.findall(r" (5\d\d)$", text, re.MULTILINE)] for text in pages]
    assert [one for page in figures for one in page] == [*range(48)]
    assert {page[0] % 4 for page in figures} <= {0, 3}


def test_table_shorter_than_a_page_moves_to_the_next_with_its_caption(tmp_path: Path) -> None:
    (tmp_path / "table.typ").write_text(render(everything(), "typst"), encoding="utf-8")
    above, below = compiled(f'{HEAD}Oben #v(20cm)\n#include "table.typ"', tmp_path)
    assert (above.split(), "Jeder Teil einer Tafel" in below) == (["Oben"], True)


def test_page_may_be_as_large_as_its_table_and_have_no_rows(tmp_path: Path) -> None:
    written, size = render(everything(), "typst"), "#set page(width: auto, height: auto)"
    (text,) = compiled(f"{HEAD}{size}\n{written}", tmp_path)
    assert "Befund" in printed("collate", "uebung-equations", "--only=deviations", "--format=typst").out
    assert_rows_stand_in(text.splitlines(), everything(), angles=False)


def test_fragment_sets_nothing_outside_itself(tmp_path: Path) -> None:
    values = "(text.size, text.lang, text.number-width, par.leading, super.size, figure.caption.position)"
    asked = f"#context [#metadata(repr({values})) <found>]\n"
    before, after = queried(f"{asked}{render(everything(lang='en'), 'typst')}{asked}")
    assert before == after
