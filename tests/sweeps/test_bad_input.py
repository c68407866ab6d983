"""What a sweep is given by mistake is told in a sentence, and is never taken for something else."""

from __future__ import annotations

import os
from collections.abc import Sequence

import pytest
from cli import kurbel as command
from cli import printed


@pytest.mark.parametrize(
    ("condition", "epsilon"),
    [
        ("eps > 1:4 and eps**2 < 20", [2, 3, 4]),
        # A root of what is below zero is as little as a division by zero.
        ("(eps-4)**0.5 < 1.1", [4, 5]),
        # Beyond all floats.
        ("9**9**9**9 > eps and (0-9)**999 < eps", [2, 3, 4, 5, 6]),
        # At 4 it is one.
        ("1/(eps-3) < 1", [2, 5, 6]),
        # Constants are what is written, where no float is.
        ("eps < 1e400 and -1e400 < eps < 4", [2, 3]),
        ("1e-400*(eps - 3) > 0", [4, 5, 6]),
        ("1e-400 == 0 or eps > 5", [6]),
        ("(eps*1e-323)*1e300 >= 3e-23", [3, 4, 5, 6]),
        ("eps - 2 < 1e-400**-2 and eps <= 1/(1/1e400)", [2, 3, 4, 5, 6]),
    ],
)
def test_a_condition_leaves_what_it_says(condition: str, epsilon: Sequence[int]) -> None:
    result = command("sweep", "delta", "--eps", "2..6", "--only", condition, "-f", "csv", "-o", "-")
    found = [float(row["epsilon"]) for row in result.records()]
    assert found == epsilon, result.err


def test_a_condition_may_name_what_is_the_same_everywhere() -> None:
    fixed = "--angle=30", "--columns=x", "--only=ratio*angle > 6"
    assert len(command("sweep", "table", "--ratio=1:3..6", *fixed, "-fcsv", "-o-").records()) == 2


def test_a_sweep_has_the_cylinders_of_its_command() -> None:
    page = "--digits=3", "--columns=tangential", "--step=90", "-fcsv"
    sized = "bore=300mm pressure=6bar stroke=400mm"
    words = "forces", f"--cylinder=angle=90 eps=4 {sized} single-acting", f"--cylinder=eps=2 {sized}", *page
    swept = command("sweep", *words, "-o-").records()
    assert [row["tangential"] for row in swept] == [row["tangential"] for row in printed(*words).records()]


def test_a_sweep_has_more_ratios_than_a_page() -> None:
    words = ("--ratio", "0.2..0.4:0.00001", "--angle", "90", "--columns", "x")
    result = command("sweep", "table", *words, "-f", "csv", "-o", os.devnull)
    assert result.err == f"kurbel: {os.devnull}: 20001 rows\n"
