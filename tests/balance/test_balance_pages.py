"""Pages of harmonics and of balance: against the motion itself, textbooks' series, and summed forces."""

from __future__ import annotations

import math
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from cli import printed, records, refusal
from numpy.typing import NDArray
from pages import shown

import kurbel
from kurbel.exact.numerals import Number
from kurbel.page.table import Table

STEPS = 256
TURN = 2 * np.pi * np.arange(STEPS) / STEPS
HALF_UNIT = 0.5 + 1e-6
ZERO = "0"


def motion(key: str, phi: Any, ratio: float) -> Any:
    """Return path, velocity or acceleration from the triangle of crank, rod and slide."""
    sine, cosine = np.sin(phi), np.cos(phi)
    slant = np.sqrt(1 - (ratio * sine) ** 2)
    return {
        "x": 1 - cosine + (1 - slant) / ratio,
        "c": sine + ratio * sine * cosine / slant,
        "p": cosine + ratio * (cosine**2 - sine**2) / slant + ratio**3 * (sine * cosine) ** 2 / slant**3,
    }[key]


def fourier(key: str, ratio: float, order: int) -> float:
    wave = np.sin if key == "c" else np.cos
    mean = (motion(key, TURN, ratio) * wave(order * TURN)).mean()
    return float(mean * (2 if order else 1))


@pytest.mark.parametrize("key", ["x", "c", "p"])
def test_harmonics_are_those_of_the_motion(key: str) -> None:
    page = printed("harmonics", "--ratio=1:3;1:4,5", f"--quantity={key}", "--orders=9", "-f", "csv")
    records = page.records()
    orders = [0, 1, 2, 4, 6, 8] if key == "x" else [1, 2, 4, 6, 8]
    assert [int(record["order"]) for record in records] == orders * 2
    assert [record["ratio"] for record in records] == ["1:3"] * len(orders) + ["1:4.5"] * len(orders)
    for record in records:
        true = fourier(key, 1 / float(record["ratio"].removeprefix("1:")), int(record["order"]))
        assert abs(float(record["value"]) - true) < HALF_UNIT * 1e-6


def test_what_is_zero_by_proof_has_no_decimals() -> None:
    assert values(kurbel.harmonics("1:4", method="series")) == ["1.000000", "0.250000", "0", "0"]
    assert values(kurbel.harmonics("1:∞")) == ["1.000000", "0", "0", "0"]
    single = kurbel.balance("inline-1", ratio="1:∞", columns="greatest")
    assert values(single) == ["1.0000", "0", "0", "0"]
    assert values(kurbel.harmonics("1:100")) == ["1.000000", "0.010000", "0.000000", "0.000000"]


def values(page: Table, column: int = -1) -> list[str]:
    return [shown(row[column]) for row in page.records.rows]


# Balance -----------------------------------------------------------------------------------------

SQUARE = ("--cranks=0;0;90;90", "--positions=3;3;5;5", "--banks=-30;45;-30;45", "--share=0,3")


def pushed(ratio: float, moments: bool) -> NDArray[np.complex128]:
    """Return the force of the pistons and counterweights of SQUARE over a turn, or their moment."""
    total = np.zeros(STEPS, complex)
    for crank, position, bank in zip((0, 0, 90, 90), (-1, -1, 1, 1), (-30, 45, -30, 45), strict=True):
        pin, slide = TURN + math.radians(crank), math.radians(bank)
        piston = motion("p", pin - slide, ratio) * np.exp(1j * slide)
        total += (position if moments else 1) * (piston - 0.3 * np.exp(1j * pin))
    return total


def test_an_engine_of_ones_own_has_the_forces_of_its_pistons() -> None:
    columns = "residual,order,along,across,forward,backward,greatest,least"
    words = ("balance", *SQUARE, "--orders=4", "--ratio=1:4", f"--columns={columns}", "-f", "csv")
    records = printed(*words).records()
    heads = [(record["residual"], int(record["order"])) for record in records]
    assert heads == [(residual, order) for residual in ("force", "moment") for order in (1, 2, 4)]
    for (residual, order), record in zip(heads, records, strict=True):
        total = pushed(0.25, residual == "moment")
        forward, backward = ((total * np.exp(turn * order * TURN)).mean() for turn in (-1j, 1j))
        true = {
            "along": abs(forward + backward.conjugate()),
            "across": abs(forward - backward.conjugate()),
            "forward": abs(forward),
            "backward": abs(backward),
            "greatest": abs(forward) + abs(backward),
            "least": abs(abs(forward) - abs(backward)),
        }
        for key, value in true.items():
            assert abs(float(record[key]) - value) < HALF_UNIT * 1e-4, (residual, order, key)


# Greatest forces and moments of the first two orders in units of m R ω² and λ m R ω², of the distance of
# neighbours. The free moments of three and five cylinders are the tables' 1.732, 0.449 and 4.980.
TEXTBOOKS = [
    ("inline-1", "1.000 1.000 0 0"),
    ("inline-2-360", "2.000 2.000 0 0"),
    ("inline-2-180", "0 2.000 1.000 0"),
    ("inline-3", "0 0 1.732 1.732"),
    ("inline-4", "0 4.000 0 0"),
    ("inline-5", "0 0 0.449 4.980"),
    ("inline-6", "0 0 0 0"),
    ("v2-90", "1.000 1.414 0 0"),
    ("v6-90", "0 0 1.732 2.449"),
    ("v8-90", "0 0 3.162 0"),
    ("v12-60", "0 0 0 0"),
    ("boxer-2", "0 0 1.000 1.000"),
    ("boxer-4", "0 0 0 2.000"),
]


@pytest.mark.parametrize(("name", "expected"), TEXTBOOKS)
def test_usual_engines_have_the_residuals_of_the_textbooks(name: str, expected: str) -> None:
    rows = records("balance", f"--engine={name}", "--ratio=1:4", "--method=series", "--columns=greatest",
                   "--digits=6")  # fmt: skip
    for row, text in zip(rows, expected.split(), strict=True):
        assert (row["greatest"] == "0") == (text == "0")
        unit = 0.25 if row["order"] == "2" else 1
        assert float(row["greatest"]) / unit == pytest.approx(float(text), abs=5e-4)


def test_every_usual_engine_has_its_textbook() -> None:
    names = refusal("balance", "--engine=none").partition("choose from ")[2].split(", ")
    assert {name for name, _ in TEXTBOOKS} == {*names}


def test_four_in_line_keep_four_times_the_second_harmonic() -> None:
    page = kurbel.balance("inline-4", ratio="1:5", orders=6, digits=12, columns="factor,along")
    for row in list(page.records.rows)[1:4]:
        factor, along = (Decimal(cell.scaled) for cell in row[-2:] if isinstance(cell, Number))
        assert abs(4 * abs(factor) - along) <= 2
        assert along


def test_a_counterweight_halves_the_force_of_one_cylinder_and_turns_the_rest_across() -> None:
    page = kurbel.balance("inline-1", share="50%", columns="along,across")
    assert [tuple(map(shown, row)) for row in page.records.rows][:2] == [
        ("force", "1", "0.5000", "0.5000"),
        ("force", "2", "0.2020", "0"),
    ]
    # Two rods on a pin of a V of 90° bring two halves: the first order is balanced.
    assert values(kurbel.balance("v2-90", share=Fraction(1, 2), columns="greatest"))[0] == ZERO


def test_a_named_engine_is_that_of_its_cranks() -> None:
    own = kurbel.balance(cranks=[0, 180, 180, 0], banks="0;180;0;180", positions=[7, 8, 9, 10])
    assert list(own.records.rows) == list(kurbel.balance("boxer-4").records.rows)
    even = kurbel.balance(cranks="0;240;120")
    assert list(even.records.rows) == list(kurbel.balance("inline-3").records.rows)
    assert "3 Zylinder" in even.caption


def test_moments_are_about_the_middle_wherever_positions_count_from() -> None:
    for positions in ("0;0;1;1", "-8;-8;-7;-7"):
        page = kurbel.balance(cranks="0;0;90;90", positions=positions, banks="-45;45;-45;45")
        # Each pair pushes with 1, the pairs square to each other and ½ from the middle.
        assert values(page, -2) == ["1.4142", ZERO, "0.7071", "0.2857"]


def test_an_engine_of_the_environment_gives_way_to_cranks() -> None:
    words = ("balance", "--cranks", "0;240;120", "-f", "csv")
    assert printed(*words, KURBEL_BALANCE_ENGINE="inline-6").out == printed(*words).out
