"""Every cell of a sweep is what the single command says at its point, read back by other programs."""

from __future__ import annotations

from itertools import cycle
from pathlib import Path
from random import Random

import pytest
from cli import refusal
from random_sweeps import KINDS, alone, deviations, drawn
from small_parts import small


def wrong(seed: int, count: int, folder: Path) -> list[str]:
    random = Random(seed)
    found: list[str] = []
    for number in range(count):
        asked, more, form = drawn(random, [*KINDS][number % len(KINDS)])
        found += deviations(asked, more, folder, form)
    return found


WAYS: tuple[tuple[list[str], str], ...] = (
    ([], "nc"),
    (["--bounds"], "arrow"),
    (["--digits", "8"], "parquet"),
)


@pytest.mark.parametrize("name", ["refused_motion", "delta", "harmonics"])
def test_cells_are_what_the_single_command_says(name: str, tmp_path: Path) -> None:
    random = Random(name)
    for more, form in WAYS:
        assert [*deviations(KINDS[name](random), more, tmp_path, form)] == []


def test_the_random_sweeps_are_of_every_command_that_can_be_swept() -> None:
    commands = refusal("sweep", "nothing").split("; choose from ")[1].split(", ")
    assert {kind.line.split()[0] for kind in KINDS.values()} == {*commands}


@pytest.mark.parametrize("name", KINDS)
def test_each_option_is_swept_alone(name: str, tmp_path: Path) -> None:
    asked = KINDS[name]._replace(optional=frozenset())(Random(name))
    for one, (more, form) in zip(alone(asked), cycle(WAYS), strict=False):
        assert [*deviations(one, more, tmp_path, form)] == []


@pytest.mark.parametrize(
    "rows", [(0, 404), (50, 150), (50, 90), (99, 102), (100, 303), (101, 202), (350, 404)]
)
def test_rows_that_begin_and_end_anywhere_have_the_values_of_their_places(rows: tuple[int, int]) -> None:
    # Of 101 rows alike the values are written in one go.
    sweep = small(eps=["2;3"], back=["0;10%"], ratio=["1:3..8:0.05"])
    points = [(eps, back, 3 + place / 20) for eps in (2, 3) for back in (0, 0.1) for place in range(101)]
    found = sweep.varied(*rows)
    rods = [1 / ratio for ratio in found["ratio"]]
    own = list(zip(found["epsilon"], found["back"], rods, strict=True))
    assert own == [pytest.approx(point) for point in points[slice(*rows)]]


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_a_thousand_random_sweeps_are_what_the_single_command_says(seed: int, tmp_path: Path) -> None:
    assert wrong(seed, 250, tmp_path) == []
