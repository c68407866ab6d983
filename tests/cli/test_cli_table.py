"""`kurbel table` and the lists: what is asked for is what is printed. Whole pages stand in transcripts."""

from __future__ import annotations

import json
import subprocess
import sys
from fractions import Fraction
from typing import Any

import pytest
from cli import column, kurbel, printed, records
from hypothesis import given, settings
from hypothesis import strategies as st

from kurbel import verify

NINTHS = verify.drive("2/9")
SIZED_DRIVE = verify.drive("2/9", radius="0.3", speed="2", turns=True)
MOTION = {"x": 4, "x_return": 4, "c": 4, "c_return": 4, "p": 4, "p_return": 4}
SIZED = {"x_mm": 2, "x_return_mm": 2, "c_mps": 3, "c_return_mps": 3, "p_mps2": 2, "p_return_mps2": 2}


@pytest.mark.parametrize(
    ("words", "drive", "places", "method"),
    [
        *((f"--method {method}", NINTHS, MOTION, method) for method in ("exact", "series", "infinite")),
        *((f"--digits {count}", NINTHS, dict.fromkeys(MOTION, count), "exact") for count in (0, 7, 50)),
        ("--offset -0,25", verify.drive("2/9", "-1/4"), MOTION, "exact"),
        *(
            (f"--stroke 600mm --rod 1350mm --offset {length}", verify.drive("2/9", share, radius="0.3"),
             MOTION | {"x_mm": 2}, "exact")
            for length, share in (("75mm", "1/4"), ("-7,5cm", "-1/4"), ("0mm", "0"))
        ),
        ("--stroke 600mm --rod 1350mm --speed 120/min", SIZED_DRIVE, SIZED, "exact"),
        ("--stroke 600mm --rod 1350mm --speed 12.5rad/s",
         verify.drive("2/9", radius="0.3", speed="12.5"), SIZED, "exact"),
        ("--rod 1350mm", SIZED_DRIVE, {"x_mm": 2}, "exact"),
    ],
)  # fmt: skip
def test_a_page_has_the_digits_of_the_reference(
    words: str, drive: Any, places: dict[str, int], method: str
) -> None:
    ratio = [] if "--stroke" in words else ["--ratio", "1:4,5"]
    (row,) = records(
        "table", *ratio, *words.split(), "--angle", "50", "--columns", ",".join(["phi", *places])
    )
    found = {key: drive.value(key, 50, method).digits(count) for key, count in places.items()}
    assert row == {"phi": "50", **found}


def test_ratios_are_repeated_listed_and_run_through_in_the_order_typed() -> None:
    words = ("--ratio", "1:4,5;1:3", "-r", "1:5..6:0,5", "--angle", "60", "--digits", "6")
    rods = {"1:4.5": "9/2", "1:3": "3", "1:5": "5", "1:5.5": "11/2", "1:6": "6"}
    assert [(row["ratio"], row["x"]) for row in records("table", *words)] == [
        (ratio, verify.drive(1 / Fraction(rod)).value("x", 60).digits(6)) for ratio, rod in rods.items()
    ]


def test_ties_are_rounded_as_asked() -> None:
    # p = 1 + 1/8 at the inner dead centre.
    words = ("table", "--ratio", "1:8", "--angle", "0", "--digits", "2")
    assert column("p", *words) == ["1.13"]
    assert column("p", *words, "--rounding", "half-even") == ["1.12"]


def test_every_page_has_the_rows_of_csv_with_the_decimal_mark_of_the_language() -> None:
    words = ("table", "--ratio", "1:4;1:6", "--angle", "50;70")
    rows = records(*words)
    assert json.loads(printed(*words, "-f", "json").out, parse_float=str, parse_int=str)["rows"] == rows
    for form in ("text", "markdown", "latex", "html"):
        for more, mark in (((), ","), (("--lang", "en"), "."), (("--decimal", "point"), ".")):
            page = printed(*words, "-f", form, *more).out
            assert all(row["x_return"].replace(".", mark) in page for row in rows), (form, more)


def test_layouts_and_quantities_are_listed_in_two_languages_a_line_each() -> None:
    for name in ("layouts", "quantities"):
        lines, english = (printed(name, "--lang", lang).out.splitlines() for lang in ("de", "en"))
        assert [line.split()[0] for line in lines] == [line.split()[0] for line in english]
        assert lines != english
        assert all(len(line.split()) > 2 for line in lines)


@pytest.mark.parametrize(
    ("given", "same"),
    [
        ("table", "table --ratio 1:5 --angle 0..180:10"),
        ("table --stroke 600mm --rod 1350mm", "table --stroke 600mm --ratio 1:4,5"),
        ("table --stroke 1m --speed 720deg/s", "table --stroke 1m --speed 120/min"),
        ("table --offset 0,2R", "table --offset 0.2"),
        ("table -f md", "table -f markdown"),
        ("table -f tex", "table -f latex"),
        ("table --lang en --digits 3 --lang EN --digits 3", "table --lang en --digits 3"),
        ("harmonics --stroke 600mm --rod 1m", "harmonics --ratio 3:10"),
        ("delta --eps 4 --stroke 600mm --offset 60mm", "delta --eps 4 --offset 0.2"),
        ("flywheel --eps 4 --power 9kW --speed 90/min --delta 1:50 --stroke 600mm --rod 1m",
         "flywheel --eps 4 --power 9kW --speed 90/min --delta 1:50 --ratio 3:10"),
    ],
)  # fmt: skip
def test_two_ways_of_typing_are_one_page(given: str, same: str) -> None:
    assert printed(*given.split()).out == printed(*same.split()).out


def test_a_label_is_the_name_of_the_reference() -> None:
    words = ("table", "--angle", "90", "-f")
    assert r"\label{tab:eins}" in printed(*words, "latex", "--label", "eins").out
    assert 'id="tab-eins"' in printed(*words, "html", "--label", "eins").out


def test_a_page_that_a_document_asks_for_leaves_the_help_of_its_command() -> None:
    code = (
        "import sys; from kurbel.cli import main; from kurbel.cli.asking import asked;"
        " asked(['balance'], {}); sys.argv = ['kurbel', 'balance', '-h']; main()"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.startswith("Usage: kurbel balance ")


def test_without_a_command_the_help_is_shown_as_an_error() -> None:
    for words, start in (((), "Usage: kurbel "), (("handbook",), "Usage: kurbel handbook [OPTIONS] COMMAND")):
        result = kurbel(*words)
        assert (result.code, result.out, result.err) == (2, "", printed(*words, "-h").out)
        assert result.err.startswith(start)


@settings(max_examples=20)
@given(
    rod=st.fractions(min_value=Fraction(11, 10), max_value=20, max_denominator=10),
    share=st.fractions(min_value=Fraction(-9, 10), max_value=Fraction(9, 10), max_denominator=10),
    seconds=st.sampled_from([(-360 * 3600, 720 * 3600), (0, 180 * 3600)]).flatmap(
        lambda ends: st.lists(st.integers(*ends), min_size=1, max_size=3, unique=True)
    ),
    decimals=st.integers(0, 30),
)
def test_every_digit_of_a_random_table_is_that_of_the_reference(
    rod: Fraction, share: Fraction, seconds: list[int], decimals: int
) -> None:
    angles = [Fraction(count, 3600) for count in seconds]
    written = ";".join(
        f"{'-' * (count < 0)}{abs(count) // 3600}°{abs(count) % 3600 // 60}'{abs(count) % 60}\""
        for count in seconds
    )
    # Numbers on the command line are decimals; e = share of R to 12 places.
    offset = round((rod - 1) * share, 12)
    # The return stroke ends at 180°.
    both = all(0 <= angle <= 180 for angle in angles)
    keys = ("x", *["x_return"] * both, "c", "p", "psi")
    words = f"--ratio {rod.denominator}:{rod.numerator} --offset {float(offset):.12f} --digits {decimals}"
    rows = records("table", *words.split(), "--columns", ",".join(keys), f"--angle={written}")
    drive = verify.drive(1 / rod, offset)
    for row, angle in zip(rows, angles, strict=True):
        for key in keys:
            assert row[key] == drive.value(key, angle).digits(decimals), (words, angle, key)
