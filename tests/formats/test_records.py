"""Records for programs, read back by the readers they are for."""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Iterator
from dataclasses import replace
from decimal import Decimal
from itertools import islice

import pytest
from cli import printed
from everything import everything
from golden import assert_golden
from hypothesis import given
from hypothesis import strategies as st
from pages import command

from kurbel.exact.numerals import Number
from kurbel.formats.csv.writer import Writer as CsvWriter
from kurbel.formats.json.writer import Writer as JsonWriter
from kurbel.formats.render import render
from kurbel.page.labels import plain
from kurbel.page.table import Field, Records, Table


class Endless:
    """Rows that never end and count how many were asked for."""

    asked = 0

    def __iter__(self) -> Iterator[tuple[Number]]:
        while True:
            self.asked += 1
            yield (Number(self.asked, 1),)


def endless() -> Table:
    return Table("endless", "de", "", (), Records((Field("x", "Weg"),), Endless()))


def test_csv_and_json_are_golden() -> None:
    for name in ("csv", "json"):
        assert_golden(f"everything.{name}", render(everything(), name))
    assert json.loads(render(Table("none", "en", "", (), Records((), ())), "json"))["rows"] == []


def test_csv_for_excel_has_its_marks_and_no_text_that_is_a_time_or_a_day() -> None:
    words = (
        "table",
        "--ratio=1:4.5",
        "--step=90",
        "--to=90",
        "--columns=ratio,phi,p",
        "-f",
        "csv",
        "--excel",
    )
    german = printed(*words).out
    assert german == "\ufeffratio;phi;p\n1∶4,5;0;1,2222\n1∶4,5;90;-0,2279\n"
    assert printed(*words, "--lang=en").out == german.replace(",", ".").replace(";", ",")
    # Ten thousand rows are made column by column, and look alike.
    many = printed(*words[:2], "--step=0.01", *words[4:]).out.splitlines()
    assert [many[0], many[1], many[9001]] == ["\ufeffratio;phi;p", "1∶4,5;0,00;1,2222", "1∶4,5;90,00;-0,2279"]
    rows = [(text,) for text in ("1-3-2", "2/3", "0.5", "1 - 2", "2°30'", "6:8", "a:b")]
    table = replace(everything(), records=Records((Field("x", "Weg"),), rows))
    assert render(table, "csv", excel=True).split("\n")[1:-1] == [
        "1‐3‐2", "2∕3", "0,5", "1 - 2", "2°30′", "6∶8", "a:b"
    ]  # fmt: skip


def test_csv_with_decimal_comma_separates_by_semicolon() -> None:
    text = render(everything(), "csv", decimal="comma")
    rows = list(csv.reader(io.StringIO(text, newline=""), delimiter=";"))
    assert rows[1] == ["1:5", "60", "0,500", 'sagt "a;b", c']
    assert rows[2] == ["1:4,5", "-90", "-0,005", ""]
    assert "\r" not in text


def test_json_numbers_have_exactly_the_printed_digits() -> None:
    content = json.loads(render(everything(), "json", decimal="comma"), parse_float=Decimal)
    assert [str(row["x"]) for row in content["rows"]] == ["0.500", "-0.005", "None"]
    assert [row["phi"] for row in content["rows"]] == [60, -90, 0]
    assert [column["key"] for column in content["columns"]] == ["ratio", "phi", "x", "remark"]
    assert content["table"] == "everything"
    assert content["notes"][1]["mark"] == "a"


FORMULAS = (
    "=1+1",
    "=cmd|' /C calc'!A0",
    "+1+1",
    "-2-3",
    "@SUM(A1)",
    "-x",
    "+5/4+A1",
    "-",
    "=",
    " =1+1",
    "\t=1",
    "\r@a",
)


@pytest.mark.parametrize("text", FORMULAS)
def test_text_that_a_spreadsheet_would_run_is_written_as_text(text: str) -> None:
    assert cell_of_csv(text) == "'" + re.sub(r"\s", " ", text)


@pytest.mark.parametrize(
    "text",
    ["-0,0667", "+5/4", "-2°30'", "-32°51½'", "-2°30'15\"", "+15 %", "-7", "1-1", "a=b", "1:5", "−x", "'=1"],
)
def test_figures_and_other_text_are_written_as_they_are(text: str) -> None:
    assert cell_of_csv(text) == plain(text)


@given(st.text("=+-@ \t\r\n,;.:/°'\"%0123456789Ax", max_size=12), st.sampled_from(["comma", "point"]))
def test_no_text_in_csv_is_a_formula(text: str, decimal: str) -> None:
    cell = cell_of_csv(text, decimal)
    assert cell in (plain(text), f"'{plain(text)}")
    assert_harmless(cell)


def cell_of_csv(text: str, decimal: str = "point") -> str:
    records = Records((Field("remark", "Bemerkung"), Field("x", "Weg")), ((text, Number(-5, 1)),))
    table = Table("t", "de", "", (), records)
    lines = io.StringIO("".join(CsvWriter().rows(table, decimal)), newline="")
    cell, number = list(csv.reader(lines, delimiter=";" if decimal == "comma" else ","))[1]
    # A number is never changed.
    assert number == {"comma": "-0,5", "point": "-0.5"}[decimal]
    return cell


def assert_harmless(cell: str) -> None:
    """Check that a cell has no operator, function or name after a sign at its beginning."""
    if cell.strip()[:1] in ("=", "@"):
        raise AssertionError(f"{cell!r} is a formula")
    if cell.strip()[:1] in ("+", "-"):
        assert set(cell[1:]) <= set("0123456789.,/°'′″½\" %"), f"{cell!r} is a formula"
        assert cell.count("/") <= 1


def csv_of(words: tuple[str, ...]) -> list[list[str]]:
    return list(csv.reader(io.StringIO(printed(*words, "-f", "csv").out, newline="")))


COMMANDS = {
    "long": ("table", "--ratio=1:4,5;0", "--step=0.1", "--offset=0.2"),
    "example": ("example", "blau", "33"),
    "equations": ("collate", "blau-equations"),
    "angles": ("collate", "blau-33"),
    "construction": ("construct", "blau-9", "--table"),
    "rotor": command("rotor"),
    "firing": command("firing-orders"),
}


@pytest.mark.parametrize("name", COMMANDS)
def test_no_command_writes_a_formula_into_csv(name: str) -> None:
    head, *records = csv_of(COMMANDS[name])
    assert records
    cells = [cell for record in (head, *records) for cell in record]
    for cell in cells:
        assert_harmless(cell)
    assert name != "example" or "'= R(1.097 − 0.186)" in cells


def test_records_are_streamed() -> None:
    table = endless()
    assert "".join(islice(CsvWriter().rows(table, "point"), 60)).startswith("x\n0.1\n0.2\n0.3\n")
    assert isinstance(table.records.rows, Endless)
    assert table.records.rows.asked < 60
    assert '{"x": 0.1},\n{"x": 0.2}' in "".join(islice(JsonWriter().rows(endless(), "point"), 20))
