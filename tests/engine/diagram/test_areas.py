"""Diagrams by their areas: the swing by hand, the letters, and what is refused."""

from __future__ import annotations

from math import pi

import pytest
from cli import printed

from kurbel.engine.diagram.areas import given_areas
from kurbel.errors import KurbelError
from kurbel.exact.kind import floats

SEVEN = "+52;−124;+92;-140;+85;-72;+107"


def test_the_swing_of_areas_is_the_range_of_their_sums() -> None:
    """Sums 0, 52, -72, 20, -120, -35, -107: from +52 to -120, 172 mm² of 500 N m times 6°."""
    found = given_areas([SEVEN], "500 N m; 6°", None)
    assert found.swing(floats()) == pytest.approx(172 * 500 * pi / 30, rel=1e-15)
    assert [one.letter for one in found.extremes(greatest=True)] == ["b"]
    assert [one.letter for one in found.extremes(greatest=False)] == ["e"]


@pytest.mark.parametrize("scale", ["52,5J", "1mm = 105 N m; 0.5 rad", "0.0525 kN m"])
def test_scales_are_energies_or_a_torque_and_an_angle(scale: str) -> None:
    assert given_areas([SEVEN], scale).swing(floats()) == pytest.approx(172 * 52.5, rel=1e-15)


def test_areas_with_their_unit_need_no_scale() -> None:
    found = given_areas(["35J;-410J;0.285kJ", "90 N m"])
    assert found.swing(floats()) == pytest.approx(410)


def test_levels_that_are_reached_twice_are_named_twice() -> None:
    found = given_areas(["3;-3;3;-3"], "1J")
    assert [one.letter for one in found.extremes(greatest=True)] == ["b", "d"]
    assert [one.letter for one in found.extremes(greatest=False)] == ["a", "c"]


def test_letters_go_on_after_z() -> None:
    words = ("turning", f"--areas={'1;-1;' * 13}2;-2", "--area-scale=1J")
    assert [row["point"] for row in printed(*words, "-f=csv").records()][25:] == ["z", "a₁", "b₁"]
    assert "am größten bei b₁, am kleinsten bei a; c;" in printed(*words).out


@pytest.mark.parametrize(
    ("areas", "scale", "sentence"),
    [
        ("+35;-410;+285;-325", "1J", "the areas sum to -415;"),
        ("+35;-35", None, "the areas have no scale; add the energy of a unit of area, --area-scale 52.36J"),
        ("35", "1J", "a diagram has at least two areas"),
        ("0;0", "1J", "the torque never leaves its mean"),
        ("1;-1", "-2J", "the scale of the areas is -2 J; it must be above 0"),
        ("1;-1", "1 N m; 2; 3", "has 3 parts"),
    ],
)
def test_what_is_no_diagram_is_told_why(areas: str, scale: str | None, sentence: str) -> None:
    with pytest.raises(KurbelError, match=sentence.replace("+", r"\+")):
        given_areas([areas], scale)
