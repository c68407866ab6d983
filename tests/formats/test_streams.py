"""Long records: chunk by chunk and column by column they are the lines that were made one by one."""

from __future__ import annotations

import json
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import pytest
from cli import printed

from kurbel.drive.crank import Crank
from kurbel.formats import streams
from kurbel.formats.registry import RecordsFormat, by_name
from kurbel.motion import evaluation
from kurbel.motion import page as motion_page
from kurbel.motion.page import Request
from kurbel.page import axes
from kurbel.page.build import build
from kurbel.page.layouts import layout
from kurbel.reading import notation

ANGLES = {
    "a run": notation.progression(Fraction(-7), Fraction(500), Fraction(1, 8)),
    "a list": notation.angles(["0..300;0.125;2..9:0.25"]),
}


def streamed(request: Request, format_name: str, decimal: str = "point") -> bytes:
    form = by_name(format_name)
    assert isinstance(form, RecordsFormat)
    return b"".join(streams.record_chunks(request, form, decimal))


def asked(angles: Sequence[Fraction], digits: int | None = None) -> Request:
    cranks = (Crank(Fraction(2, 9)), Crank(Fraction(1, 4), Fraction(1, 10)))
    return Request(layout=layout("kinematics"), cranks=cranks, angles=angles, digits=digits)


@pytest.mark.parametrize("angles", ANGLES.values(), ids=[*ANGLES])
@pytest.mark.parametrize(("format_name", "decimal"), [("csv", "point"), ("csv", "comma"), ("json", "point")])
def test_columns_of_floats_and_lines_of_balls_are_the_same_bytes(
    angles: Sequence[Fraction], format_name: str, decimal: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(motion_page, "CHUNK", 1000)
    one_by_one = streamed(asked(angles), format_name, decimal)
    monkeypatch.setattr(evaluation, "PAGE_CELLS", 0)
    assert asked(angles).angles is angles
    assert streamed(asked(angles), format_name, decimal) == one_by_one
    assert one_by_one.count(b"\n") > 2 * len(angles)


def test_the_page_and_the_records_of_a_table_are_computed_once(monkeypatch: pytest.MonkeyPatch) -> None:
    computed: list[Crank] = []
    original = evaluation.columns_in_balls

    def counted(columns: Any, crank: Crank, angles: Sequence[Fraction], rounding: str) -> list[list[int]]:
        computed.append(crank)
        return original(columns, crank, angles, rounding)

    monkeypatch.setattr(motion_page, "columns_in_balls", counted)
    request = asked(notation.angles(["0..180:10"]))
    table = build(request)
    assert [*table.records.rows] == [*table.records.rows]
    assert computed == list(request.cranks)


def test_all_angles_of_a_list_have_the_same_decimals(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(evaluation, "PAGE_CELLS", 0)
    monkeypatch.setattr(motion_page, "CHUNK", 10)
    lines = streamed(asked(notation.angles(["0..50;0.5"])), "csv").decode().splitlines()[1:]
    assert {len(line.split(",")[1].partition(".")[2]) for line in lines} == {1}


def test_a_list_of_angles_is_looked_through_a_few_times_only(monkeypatch: pytest.MonkeyPatch) -> None:
    looks: list[int] = []
    original = axes.angle_decimals

    def counted(angles: Sequence[Fraction]) -> int | None:
        looks.append(len(angles))
        return original(angles)

    for module in (motion_page, axes, streams):
        monkeypatch.setattr(module, "angle_decimals", counted)
    request = asked(notation.angles(["0..200;0.5"]))
    streamed(request, "csv")
    build(request)
    # Once a row would be 404 times for the records alone.
    assert len(looks) < 10


@pytest.mark.parametrize(
    "options",
    [
        "--from 0 --to 1e-17 --step 1e-22",
        "--stroke 1e-30mm --rod 5e-30mm --columns phi,x_mm --digits 40 --from 0 --to 30 --step 0.01",
        "--columns phi,x --angle 0;1400;0.0000000000000001;1..20000",
    ],
)
def test_numbers_beyond_64_bits_are_printed_too(options: str) -> None:
    lines = printed("table", *options.split(), "-f", "csv").out.splitlines()
    assert len(lines) > 3000
    assert "nan" not in "".join(lines)


def test_long_json_is_one_object() -> None:
    found = json.loads(printed("table", "--step", "0.05", "-f", "json", "--columns", "phi,x,c,ratio").out)
    assert len(found["rows"]) == 7201
    assert found["rows"][600] == {"phi": 30.0, "x": 0.159, "c": 0.587, "ratio": "1:5"}
