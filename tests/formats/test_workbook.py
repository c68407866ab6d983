"""Tables as workbooks, read from their XML: numbers are numbers, text is text, the page is as printed."""

from __future__ import annotations

import io
import re
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from zipfile import ZipFile

import pytest
from cli import kurbel as ran
from cli import printed, refusal
from everything import everything
from hypothesis import given, settings
from hypothesis import strategies as st
from pages import default_page
from pytest import MonkeyPatch
from tools import require_library
from workbooks import sheets_of, xlsx_sheets

import kurbel
from kurbel.exact.numerals import Number
from kurbel.formats.registry import FORMATS, WorkbookFormat
from kurbel.formats.sheet import LONGEST_NAME, sheet_name
from kurbel.formats.workbook import records_sheet
from kurbel.page.table import Field, Records
from kurbel.reading.environment import how_to_install

BOOKS = [form for form in FORMATS.values() if isinstance(form, WorkbookFormat)]
each_book = pytest.mark.parametrize("form", BOOKS, ids=lambda form: form.name)


@pytest.fixture(autouse=True)
def undated(monkeypatch: MonkeyPatch) -> None:
    require_library("xlsxwriter")
    monkeypatch.delenv("SOURCE_DATE_EPOCH", raising=False)


@each_book
def test_every_part_of_a_table_has_its_cell(form: WorkbookFormat) -> None:
    page, values = sheets_of(form.content(everything(), None)).values()
    # Spanners over their columns, headings beside them over several rows.
    assert (page.values[2, 3], page.spans[2, 3]) == ("Genaue Werteᵃ⁾", (1, 5))
    assert (page.values[3, 3], page.spans[3, 3]) == ("Kolbenweg", (1, 2))
    assert (page.values[2, 0], page.spans[2, 0]) == ("R:L", (3, 1))
    assert page.values[4, 4] == "Rückgang\nx/R"
    # Two groups under their labels; a continued cell, and no value, are empty or have their mark.
    assert page.row(5) == ["Erste Gruppe, λ\u00a0=\u00a01/5 & 100 %"]
    assert page.row(6) == ["1:5", 0, 0, 0, 0, "0°0′", "1\u00a0−\u00a0cos\u00a0φ"]
    assert page.row(7)[:4] == [60, 0.576, 0.424, -0.954]
    assert page.row(8) == [180, 2, "–", -12.5, "–ᵇ⁾"]
    # Below the second panel stand the notes and the source.
    assert page.row(14)[2:] == [1.2, 1.173]
    assert page.row(20) == ["Quelle: F. Rötscher, Die Maschinenelemente, § 14"]
    assert values.row(0) == ["ratio", "phi", "x", "remark"]
    assert values.row(2) == ["1:4,5", -90, -0.005]
    assert values.row(3) == ["1:4", 0]


def test_a_page_of_ods_is_as_high_as_its_name_says() -> None:
    (form,) = (form for form in BOOKS if form.name == "ods")
    with ZipFile(io.BytesIO(form.content(everything(), None))) as file:
        styles = file.read("styles.xml").decode()
    for orientation, width, height in (("portrait", "210mm", "297mm"), ("landscape", "297mm", "210mm")):
        page = re.search(rf'<style:page-layout-properties[^>]*orientation="{orientation}"[^>]*>', styles)
        assert page is not None
        assert f'fo:page-width="{width}"' in page[0]
        assert f'fo:page-height="{height}"' in page[0]


def test_cells_are_upright_in_which_letters_are_italic() -> None:
    page, _ = xlsx_sheets(BOOKS[0].content(kurbel.table("1:5", layout="kolbenwege"), None)).values()
    assert "φ in °" in page.values.values()
    assert not page.slanted
    # Nor are they low where a letter is.
    page, _ = xlsx_sheets(BOOKS[0].content(default_page("machine-forces"), None)).values()
    assert "Hx in kN" in page.values.values()
    assert not page.lowered


def test_marks_of_missing_values_are_centred_and_other_texts_of_the_body_are_not() -> None:
    page, _ = xlsx_sheets(BOOKS[0].content(everything(), None)).values()
    assert {page.values[place] for place in page.centred if 6 <= place[0] <= 8} == {"–", "–ᵇ⁾"}


def test_numbers_have_the_printed_decimals_and_hang_their_marks_behind() -> None:
    form = FORMATS["xlsx"]
    assert isinstance(form, WorkbookFormat)
    content = form.content(everything(), None)
    page, values = sheets_of(content).values()
    assert page.formats[7, 3] == "0.000"
    # A mark of a note is no text of the cell; whoever has none leaves room for it.
    assert page.formats[7, 6] == '0.000"ᵇ⁾"'
    assert page.formats[6, 6] == "0.000_ᵇ_⁾"
    # An integer among fractions stands where their integers do.
    assert page.formats[8, 3] == "0_,_0_0_0"
    # A ratio that somebody types over remains text.
    assert page.formats[6, 0] == values.formats[1, 0] == "@"
    # Nothing but letters of formulas is italic.
    with ZipFile(io.BytesIO(content)) as file:
        assert b"<i/>" not in file.read("xl/styles.xml")


@each_book
def test_letters_below_the_line_are_lowered_and_rules_of_spanners_do_not_touch(form: WorkbookFormat) -> None:
    content = form.content(default_page("machine-forces"), None)
    page, _ = sheets_of(content).values()
    texts = [text for text in page.values.values() if isinstance(text, str)]
    assert [text for text in texts if "_" in text] == []
    assert {"Hx in kN", "Hy in kN"} <= {text.replace("\u00a0", " ").split("\n")[-1] for text in texts}
    lowered = {"xlsx": b'<vertAlign val="subscript"/>', "ods": b'style:text-position="sub 65%"'}
    part = {"xlsx": "xl/sharedStrings.xml", "ods": "content.xml"}
    with ZipFile(io.BytesIO(content)) as file:
        assert lowered[form.name] in file.read(part[form.name])
    spanners = [place for place, (_, across) in page.spans.items() if across > 1 and place[0] == 2]
    assert len(spanners) == 2
    for row, column in spanners:
        assert (row, column - 1) not in page.values
        assert not any(column - other - page.spans[row, other][1] == 0 for _, other in spanners)


@each_book
@pytest.mark.parametrize("text", ["=1+1", "-1", "@SUM(1)", "1:5", "https://a.b", "1e5"])
def test_no_text_is_a_formula_a_number_or_a_link(form: WorkbookFormat, text: str) -> None:
    content = form.content(everything(caption=text), None)
    page, values = sheets_of(content).values()
    assert page.values[0, 0] == text
    assert page.formulas == values.formulas == 0
    assert b"hyperlink" not in b"".join(ZipFile(io.BytesIO(content)).read(name) for name in names(content))


def names(content: bytes) -> list[str]:
    return [name for name in ZipFile(io.BytesIO(content)).namelist() if "sheet" in name or "content" in name]


@each_book
def test_the_same_table_is_the_same_bytes_of_the_day_that_is_asked_for(
    form: WorkbookFormat, monkeypatch: MonkeyPatch
) -> None:
    first = form.content(everything(), None)
    monkeypatch.setattr("time.time", lambda: 2e9)
    assert form.content(everything(), None) == first
    assert b"1980-01-01T00:00:00Z" in about(first)
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1000000000")
    assert b"2001-09-09T01:46:40Z" in about(form.content(everything(), None))
    # A zip file ends with the year 2107, what is said in it does not.
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "253402300799")
    assert b"9999-12-31T23:59:59Z" in about(form.content(everything(), None))


def about(content: bytes) -> bytes:
    with ZipFile(io.BytesIO(content)) as file:
        return file.read("meta.xml" if "meta.xml" in file.namelist() else "docProps/core.xml")


def test_panels_of_the_same_rows_are_one_table() -> None:
    page, _ = sheets_of(BOOKS[-1].content(kurbel.table("1:5", layout="roetscher-112"), None)).values()
    heads = [text for (row, _), text in sorted(page.values.items()) if row == 2]
    assert heads[-1] == "180\n180"
    assert len(heads) == 2 + 19


@each_book
def test_a_column_that_no_spreadsheet_keeps_is_text_with_every_digit(
    form: WorkbookFormat, tmp_path: Path
) -> None:
    target = tmp_path / f"tafel{form.suffixes[0]}"
    said = ran(
        "table", "--ratio=1:5", "--angle=0;60", "--digits=20", "--columns=phi,x", "-o", str(target)
    ).err
    assert "keeps 15 figures of a number" in said
    page, values = sheets_of(target.read_bytes()).values()
    # 1 - cos φ + (1 - sqrt(1 - (λ sin φ)²))/λ by mpmath.
    assert page.row(4) == [60, "0,57557109910194763913"]
    assert [values.row(1), values.row(2)] == [[0, "0,00000000000000000000"], [60, "0,57557109910194763913"]]


def test_without_its_library_the_command_that_installs_it_is_named(
    monkeypatch: MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setitem(sys.modules, "xlsxwriter", None)
    sentence = f"Excel's workbooks need XlsxWriter; install it with: {how_to_install('office')}"
    assert refusal("table", "-o", str(tmp_path / "tafel.xlsx"), code=1) == sentence
    assert list(tmp_path.iterdir()) == []
    # OpenDocument needs none.
    printed("table", "--ratio=1:5", "-o", str(tmp_path / "tafel.ods"))


def test_what_no_sheet_holds_is_refused() -> None:
    class Many:
        def __iter__(self) -> Iterator[tuple[Number]]:
            return iter([(Number(1, 0),)] * (1 << 20))

    with pytest.raises(
        kurbel.KurbelError, match="a sheet of 1048576 records is too long; at most 1048575 are in one"
    ):
        records_sheet(Records((Field("x", "Weg"),), Many()), ",", "Werte")
    page = replace(everything(), caption="x" * 40_000)
    for form in BOOKS:
        with pytest.raises(kurbel.KurbelError, match=r"a text of 40000 characters, .* has at most 32767"):
            form.content(page, None)


@settings(deadline=None, max_examples=20)
@given(st.lists(st.text(max_size=60), max_size=5))
def test_every_name_of_a_sheet_is_one_that_excel_takes(wanted: list[str]) -> None:
    taken: set[str] = set()
    for text in [*wanted, "History", "a" * 80, "a" * 80, "[x]:*?/\\'"]:
        name = sheet_name(text, taken)
        assert 0 < len(name.encode("utf-16-le")) // 2 <= LONGEST_NAME
        assert not set(name) & set("[]:*?/\\")
        assert name[0] != "'" != name[-1]
        assert name.lower() not in taken | {"history"}
        taken.add(name.lower())
