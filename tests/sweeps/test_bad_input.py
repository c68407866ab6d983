"""What a sweep is given by mistake is told in a sentence, and is never taken for something else."""

from __future__ import annotations

import os
from collections.abc import Sequence

import numpy as np
import pytest
from cli import kurbel as command

import kurbel
from kurbel.errors import NotationError


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
