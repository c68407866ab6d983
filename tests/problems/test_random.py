"""A few random problems of every kind; tests/support/random_problems.py draws as many as one likes."""

from __future__ import annotations

import pytest
from random_problems import KINDS, check


@pytest.mark.parametrize("name", KINDS)
def test_a_random_problem_has_the_digits_of_another_computation(name: str) -> None:
    check(name, "test")
