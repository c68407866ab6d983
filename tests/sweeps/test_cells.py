"""Every cell of a sweep is what the single command says at its point, read back by other programs."""

from __future__ import annotations

from pathlib import Path
from random import Random

import pytest
from random_sweeps import KINDS, READERS, deviations, drawn

from kurbel.cli.sweeps.group import TABLES


def wrong(seed: int, count: int, folder: Path) -> list[str]:
    random = Random(seed)
    found: list[str] = []
    for number in range(count):
        asked, more, form = drawn(random, [*KINDS][number % len(KINDS)])
        found += deviations(asked, more, folder, form)
    return found


@pytest.mark.parametrize("name", ["refused_motion", "delta", "harmonics"])
def test_cells_are_what_the_single_command_says(name: str, tmp_path: Path) -> None:
    random = Random(name)
    for more, form in (([], "nc"), (["--bounds"], "arrow"), (["--digits", "8"], "parquet")):
        assert [*deviations(KINDS[name](random), more, tmp_path, form)] == []


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_a_thousand_random_sweeps_are_what_the_single_command_says(seed: int, tmp_path: Path) -> None:
    assert wrong(seed, 250, tmp_path) == []


def test_random_sweeps_are_of_every_command() -> None:
    random = Random(1)
    # Firing orders and locomotives are tried by themselves: they have no options of numbers in common.
    assert {draw(random).command for draw in KINDS.values()} == {*TABLES} - {"firing", "locomotive"}
    assert {*READERS} == {"parquet", "arrow", "nc"}
