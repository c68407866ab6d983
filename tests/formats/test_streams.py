"""Long records: column by column in floats they are the lines that are made one by one for a few angles."""

from __future__ import annotations

import json

import pytest
from cli import printed, refusal

# With so many angles of two ratios and five columns a table is computed column by column.
DRIVE = ("table", "--ratio=2:9;1:4", "--offset=0.1", "--columns=ratio,phi,x,c,p,psi,rod_velocity")


@pytest.mark.parametrize("form", ["csv", "json", "dat"])
def test_long_records_are_those_of_their_parts(form: str) -> None:
    def lines(start: float, stop: float) -> list[str]:
        words = (*DRIVE, f"--angle={start}..{stop}:0.0625", "--decimal=point", "-f", form)
        found = printed(*words).out.replace("]", "").replace("},\n", "}\n").splitlines()
        return [line for line in found if line.startswith(("1:4", "2:9", '{"ratio"'))]

    whole = lines(-30, 149.9375)
    parts = [lines(start, start + 29.9375) for start in range(-30, 150, 30)]
    halves = [[part[: len(part) // 2] for part in parts], [part[len(part) // 2 :] for part in parts]]
    assert whole == [line for half in halves for part in half for line in part]
    assert len(whole) == 2 * 16 * 180


def test_all_angles_of_a_list_have_the_same_decimals() -> None:
    lines = printed("table", "--columns=phi,x", "--angle=0..20000;0.5", "-f", "csv").out.splitlines()[1:]
    assert {len(line.split(",")[0].partition(".")[2]) for line in lines} == {1}
    assert len(lines) == 20002


@pytest.mark.parametrize(
    "options",
    [
        "--from 0 --to 1e-18 --step 2e-22",
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


@pytest.mark.parametrize("form", ["csv", "json", "dat"])
def test_of_a_long_table_that_is_refused_nothing_is_printed(form: str) -> None:
    words = ("table", "--offset=0.1", "--columns=x,fd", "--step=0.01", "-f", form)
    assert refusal(*words) == "fd has no formula for an offset crank; leave the offset out"
