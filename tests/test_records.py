"""Records for programs, read back by the readers they are for."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Iterator
from decimal import Decimal
from itertools import islice

from everything import everything
from golden import assert_golden

from kurbel.records import csv_rows, json_rows
from kurbel.render import render
from kurbel.table import Field, Number, Records, Table


class Endless:
    """Rows that never end and count how many were asked for."""

    asked = 0

    def __iter__(self) -> Iterator[tuple[Number]]:
        while True:
            self.asked += 1
            yield (Number(self.asked, 1),)


def endless() -> Table:
    return Table("endless", "de", "", (), Records((Field("x", "Weg"),), Endless()))


def test_csv_is_golden() -> None:
    assert_golden("everything.csv", render(everything(), "csv"))


def test_json_is_golden() -> None:
    assert_golden("everything.json", render(everything(), "json"))


def test_csv_is_read_back_cell_by_cell() -> None:
    rows = list(csv.reader(io.StringIO(render(everything(), "csv"), newline="")))
    assert rows == [
        ["ratio", "phi", "x", "remark"],
        ["1:5", "60", "0.500", 'sagt "a;b", c'],
        ["1:4,5", "-90", "-0.005", ""],
        ["1:4", "0", "", ""],
    ]


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


def test_json_of_no_records_is_still_json() -> None:
    table = Table("none", "en", "", (), Records((), ()))
    assert json.loads(render(table, "json"))["rows"] == []


def test_records_are_streamed() -> None:
    table = endless()
    assert list(islice(csv_rows(table.records), 3)) == ["x\n", "0.1\n", "0.2\n"]
    assert isinstance(table.records.rows, Endless)
    assert table.records.rows.asked == 2
    assert '{"x": 0.3},\n{"x": 0.4}' in "".join(islice(json_rows(table), 20))
