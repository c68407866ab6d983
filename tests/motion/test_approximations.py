"""Rötscher's steps to GF, and the greatest errors of the series, against kurbel.verify."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import islice
from pathlib import Path
from random import Random
from typing import Any

import pytest
from cli import kurbel, printed

from kurbel import verify
from kurbel.exact.kind import balls
from kurbel.kernel import series


def errors_csv(*options: str) -> list[dict[str, str]]:
    return printed("table", "--layout=series-errors", *options, "-f", "csv").records()


def steps_csv(*options: str) -> list[dict[str, str]]:
    return printed("table", "--layout=roetscher-gf", *options, "-f", "csv").records()


# Greatest errors ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("ratio", "order"), [("0.237", 1), ("0.31", 3), ("0.2", 5), ("0.43", 7), ("0.77", 9)]
)
def test_greatest_errors_are_those_of_a_search_over_the_turn(ratio: str, order: int) -> None:
    (record,) = errors_csv(f"--ratio={ratio}", f"--order={order}", "--lang=en")
    drive = verify.drive(ratio)
    for key in ("x", "c", "p"):
        place = Fraction(record[f"error_{key}_phi"])

        def error(angle: Fraction | int, key: str = key) -> float:
            return abs(float(drive.value(key, angle, "difference", order=order)))

        # Where it errs most a hair beside it errs as much, to the digits that are shown.
        there = drive.value(key, place, "difference", order=order)
        digits = len(record[f"error_{key}"].partition(".")[2])
        assert record[f"error_{key}"] == there.digits(digits).removeprefix("-"), key
        # The same is found at four places of the turn.
        beside = [place + side * Fraction(1, 1000) for side in (-1, 1)]
        assert max(map(error, [*range(0, 91, 6), *beside])) <= error(place), key


def test_first_order_errs_by_an_eighth_and_a_half_of_the_third_power() -> None:
    # The first terms that are left out: λ³/8 of x and -λ³/2 of p at 90°, √27/32 λ³ of c at 60°.
    (record,) = errors_csv("--ratio=1:1000000", "--order=1", "--digits=40")
    for key, share, place in (("x", 1 / 8, 90), ("c", 27**0.5 / 32, 60), ("p", 1 / 2, 90)):
        assert float(record[f"error_{key}"]) == pytest.approx(share * 1e-18, rel=1e-9)
        assert float(record[f"error_{key}_phi"]) == pytest.approx(place, abs=1e-6)


def test_errors_have_the_digits_and_the_units_that_are_asked_for() -> None:
    exact = {"x": Fraction(1, 3) - Fraction(3, 10), "p": Fraction(3, 4) - Fraction(3, 5)}
    # At λ = 3:5 the root at 90° is 4/5.
    (record,) = errors_csv("--ratio=3:5", "--order=1", "--digits=30")
    for key, value in exact.items():
        assert abs(Fraction(record[f"error_{key}"]) - value) <= Fraction(1, 2 * 10**30)
    (record,) = errors_csv("--ratio=3:5", "--order=1", "--stroke=1m", "--digits=3", "--columns=error_x_mm")
    assert record == {"error_x_mm": "16.667"}
    ties = [errors_csv("--ratio=3:5", "--order=1", "--digits=1", "--columns=error_p", f"--rounding={one}")
            for one in ("half-away", "half-even")]  # fmt: skip
    assert ties == [[{"error_p": "0.2"}], [{"error_p": "0.2"}]]
    assert errors_csv("--ratio=1:∞", "--columns=error_x,error_c_phi") == [
        {"order": str(order), "error_x": "0", "error_c_phi": ""} for order in (1, 3, 5, 7, 9)
    ]


# Exact and first order side by side ----------------------------------------------------------------


@pytest.mark.parametrize("ratio", ["1:3.7", "1:∞"])
def test_every_difference_is_that_of_the_unrounded_values(ratio: str) -> None:
    drive = verify.drive("0" if ratio.endswith("∞") else ratio)
    words = ("--layout=verfahren", f"--ratio={ratio}", "--angle=0;33;60;90;147.25;180", "--digits=7")
    for row in printed("table", *words, "-f", "csv").records():
        for column in row.keys() - {"ratio", "phi"}:
            key, _, method = column.partition("_")
            value = drive.value(key, row["phi"], method)
            assert value.confirms(row[column]) == verify.CONFIRMED, (row["phi"], column)


LAYOUT = """\
title = "Gain"
caption = "Gain"
ratios = ["4:5"]
angles = ["90"]
down = ["ratio", "angle"]
stub = ["angle"]
across = ["column"]
columns = [{ quantity = "x_mm", method = "exact", key = "exact" },
           { quantity = "x_mm", method = "series", key = "series" },
           { quantity = "x_mm", method = "difference", key = "gain" }]
"""


def test_a_difference_half_way_is_rounded_as_one_and_its_neighbours_are_not(tmp_path: Path) -> None:
    (tmp_path / "gain").mkdir()
    (tmp_path / "gain" / "layout.toml").write_text(LAYOUT, encoding="utf-8")
    words = ("table", f"--layouts={tmp_path}", "--layout=gain", "--digits=0", "-f", "csv")
    # At λ = 4:5 and 90° x/R is 3/2, and to first order 7/5: a tenth of 25 mm.
    for stroke, away, even in (
        ("50", "3", "2"),
        ("50.0001", "3", "3"),
        ("49.9999", "2", "2"),
        ("70", "4", "4"),
    ):
        for rounding, gain in (("half-away", away), ("half-even", even)):
            (row,) = printed(*words, f"--stroke={stroke}mm", f"--rounding={rounding}").records()
            assert row["gain"] == gain, (stroke, rounding)


# Rötscher's steps --------------------------------------------------------------------------------


def steps(drive: verify.Drive, angle: Fraction) -> Iterator[verify.Value]:
    """Yield CF²/(2 L - GF) in units of R, with CF = R sin φ and L = R/λ, again and again."""

    def after(found: Callable[[], verify.Number]) -> Callable[[], verify.Number]:
        def next_one() -> verify.Number:
            lift = drive.pin(angle, 0).value().y
            gone: verify.Number = lift * lift / (2 * drive.rod - found())
            return gone

        return next_one

    def nothing() -> verify.Number:
        return drive.rod * 0

    found: Callable[[], verify.Number] = nothing
    while True:
        yield verify.Value(found)
        found = after(found)


def test_steps_and_their_number_are_those_of_the_equation_itself() -> None:
    random = Random(1047)
    for _ in range(6):
        ratio, angle = Fraction(random.randint(100, 960), 1000), Fraction(random.randint(1, 17999), 100)
        digits = random.randint(1, 20)
        names = [f"gf_{step}" for step in range(1, 10)]
        (record,) = steps_csv(
            f"--ratio={float(ratio)}", f"--angle={float(angle)}", f"--digits={digits}",
            "--columns=" + ",".join((*names, "gf", "gf_steps")),
        )  # fmt: skip
        drive = verify.drive(ratio)
        exact = drive.value("fd", angle)
        assert exact.confirms(record["gf"]) == verify.CONFIRMED
        count = int(record["gf_steps"])
        found = list(islice(steps(drive, angle), max(count + 1, 12)))
        for name, value in zip(names, found[1:], strict=False):
            assert value.confirms(record[name]) == verify.CONFIRMED, name
        # Steps rise: what the last but one lacks, all before it lack.
        same = [
            value.scaled(digits) == exact.scaled(digits) for value in found[max(count - 1, 0) : count + 1]
        ]
        assert same == ([False, True] if count else [True])
        # Each step leaves less than the share GF/(2 L - GF) of what the last left.
        true = left = exact.near()
        share = true / (2 / ratio - true)
        for value in found[1:12]:
            lacking = true - value.near()
            assert 0 < lacking < share * left
            left = lacking


def test_the_closed_form_is_that_of_the_steps() -> None:
    kind = balls()
    circle, ratio = kind.circle(Fraction(371, 7)), kind.of(Fraction(3, 7))
    for steps in range(6):
        closed: Any = series.closed(circle, ratio, steps)
        assert closed.overlaps(series.after(circle, ratio, steps))


def test_steps_never_reach_a_value_half_way_that_is_rounded_up() -> None:
    # At λ = 4:5 and 90° GF is exactly ½ R, and all steps are below it: 2/5, 10/21, …
    half = ("--ratio=4:5", "--angle=90", "--columns=gf_steps")
    for more, count in (
        (("--digits=0",), ""),
        (("--digits=0", "--rounding=half-even"), "0"),
        (("--digits=1",), "2"),
    ):
        assert steps_csv(*half, *more) == [{"gf_steps": count}]
    page = printed(
        "table", "--layout=roetscher-gf", "--ratio=4:5", "--angle=90", "--digits=0", "--lang=en"
    ).out
    assert "half-way between" in page


def test_orders_are_listed_or_repeated_and_each_stands_once() -> None:
    errors = ("table", "--layout=series-errors")
    for words, listed in (
        (("--order=3", "--order=9", "--order=3"), "3;9"),
        (("--order=1", "--order=1"), "1"),
    ):
        assert printed(*errors, *words).out == printed(*errors, f"--order={listed}").out
    page = ("table", "--method=series", "--angle=30", "--order=3")
    assert printed(*page, "--order=3").out == printed(*page).out


# What is refused ---------------------------------------------------------------------------------


def test_steps_until_decimals_stand_can_be_swept(tmp_path: Path) -> None:
    words = ("sweep", "table", "--layout=roetscher-gf", "--ratio=1:4;1:5", "--angle=0;90", "-o")
    counted = []
    for digits in ((), ("--digits=6",), ("--digits=2",)):
        assert kurbel(*words, str(tmp_path / "gf.csv"), "--restart", *digits).code == 0
        rows = (tmp_path / "gf.csv").read_text(encoding="utf-8").splitlines()[1:]
        counted.append([float(row.split(",")[-2]) for row in rows])
    # At 1:5 and 90° four steps give six places, as on the page; more decimals take more steps.
    assert counted[1] == [0, 4, 0, 4]
    assert all(more >= some >= few for more, some, few in zip(*counted, strict=True))
    assert counted[0] != counted[1] != counted[2]
