"""What a sweep is given by mistake is told in a sentence, and is never taken for something else."""

from __future__ import annotations

import os
from collections.abc import Sequence

import numpy as np
import pytest
from cli import kurbel as command
from cli import printed, refusal

import kurbel
from kurbel.errors import ChoiceError, NotationError


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


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (
            ("--only", "9**9**9 > eps**9**9"),
            'condition "9**9**9 > eps**9**9" has powers beyond 10^308, which are not computed; write it with'
            " smaller ones",
        ),
        (
            ("--only", "eps < (0-9)**(9**9**9 - 9**9**9)"),
            'condition "eps < (0-9)**(9**9**9 - 9**9**9)" has powers beyond 10^308, which are not computed;'
            " write it with smaller ones",
        ),
        (
            ("--only", "eps < 1e99999"),
            'number "1e99999" is beyond the numbers that are read, up to 10^999',
        ),
        (("--back", "0;1e309"), "--back goes beyond 10^300, which no column holds"),
        (("--back", "1e309", "--only", "back < 2"), "--back goes beyond 10^300, which no column holds"),
        (
            ("--scheduler", ""),
            "--scheduler is empty; give an address, tcp://HOST:8786, or leave it out for this machine",
        ),
    ],
)
def test_what_cannot_be_meant_is_refused(words: Sequence[str], sentence: str) -> None:
    result = command("sweep", "delta", "--eps", "2..6", *words, "-f", "csv", "-o", os.devnull)
    assert (result.code, result.err) == (2, f"kurbel: {sentence}\n")


def test_the_angles_of_a_sweep_have_one_step() -> None:
    result = command("sweep", "table", "--step", "10;20", "-f", "csv", "-o", os.devnull)
    sentence = "--step takes one value, 2 were given; several angles are --angle 0;45;90 or --angle 0..360:10"
    assert (result.code, result.err) == (2, f"kurbel: {sentence}\n")


def test_a_sweep_has_the_cylinders_of_its_command() -> None:
    page = "--digits=3", "--columns=tangential", "--step=90", "-fcsv"
    sized = "bore=300mm pressure=6bar stroke=400mm"
    words = "forces", f"--cylinder=angle=90 eps=4 {sized} single-acting", f"--cylinder=eps=2 {sized}", *page
    swept = command("sweep", *words, "-o-").records()
    assert [row["tangential"] for row in swept] == [row["tangential"] for row in printed(*words).records()]
    assert refusal("sweep", "forces", "--cylinder=angle=90", "-ox.csv") == refusal(
        "forces", "--cylinder=angle=90"
    )
    with pytest.raises(ChoiceError, match="did you mean angle"):
        kurbel.sweep("forces", cylinder="angl=90")


def test_a_sweep_has_more_ratios_than_a_page() -> None:
    words = ("--ratio", "0.2..0.4:0.00001", "--angle", "90", "--columns", "x")
    result = command("sweep", "table", *words, "-f", "csv", "-o", os.devnull)
    assert result.err == f"kurbel: {os.devnull}: 20001 rows\n"


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        ([], "eps is an empty list; give values, or leave it out"),
        (np.array([]), "eps is an empty list; give values, or leave it out"),
        (np.array([[2.0, 3.0]]), "eps is an array of 2 dimensions; give a list of values"),
    ],
)
def test_values_that_are_no_list_of_values_are_refused(given: object, sentence: str) -> None:
    with pytest.raises(NotationError) as raised:
        kurbel.sweep("delta", eps=given)
    assert str(raised.value) == sentence
