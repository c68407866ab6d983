"""Angles that count from the book's zero: the same rows under other angles."""

from __future__ import annotations

import json

import pytest
from cli import printed
from hypothesis import given, settings
from hypothesis import strategies as st


@pytest.mark.parametrize(
    "words",
    [
        "table --ratio 2:7",
        "table --ratio 2:7 --offset 0.3",
        "table --mechanism arc --ratio 1:4 --rocker 5",
        "table --mechanism parallel",
        "forces --ratio 2:7 --force 3kN",
        "forces --eps 3",
        "inertia --centre 0.6 --gyration 0.3",
    ],
)
@settings(max_examples=3, deadline=None)
@given(zero=st.integers(-3600, 3600), angle=st.integers(0, 720))
def test_a_row_is_that_of_the_angle_and_the_zero_together(words: str, zero: int, angle: int) -> None:
    """All in halves of a degree."""
    asked = (*words.split(), "-f", "json")
    moved = rows(*asked, f"--angle={angle / 2}", f"--zero={zero}/2")
    plain = rows(*asked, f"--angle={(angle + zero) / 2}")
    assert [row.pop("phi") for row in moved] == [angle / 2] * len(moved)
    assert [row.pop("phi") for row in plain] == [(angle + zero) / 2] * len(plain)
    assert moved == plain


def rows(*words: str) -> list[dict[str, float]]:
    found: list[dict[str, float]] = json.loads(printed(*words).out)["rows"]
    return found


def test_a_run_counts_from_the_outer_dead_centre_and_says_so() -> None:
    asked = ("table", "--ratio", "1:4", "--zero", "outer", "--lang", "en")
    run = printed(*asked, "--step", "1/8", "--to", "90", "--columns", "phi,x", "-f", "csv").records()
    assert [run[0]["phi"], run[-1]["phi"], len(run)] == ["0.000", "90.000", 721]
    long = printed(*asked, "--step", "0.01", "--columns", "phi,x,c", "-f", "csv").records()
    assert [row["phi"] for row in (long[0], long[1], long[-1])] == ["0.00", "0.01", "360.00"]
    assert long[9000]["x"] == "1.1270"
