"""Rotating masses: against the sums of their pulls and moments, taken from what is printed."""

from __future__ import annotations

import cmath
import math
from typing import Any

import pytest
from cli import printed, refusal
from hypothesis import given, settings
from hypothesis import strategies as st

import kurbel

Rows = dict[str, dict[str, str]]
Vectors = list[tuple[complex, float]]


def page(*words: str, solution: str = "1") -> Rows:
    rows = printed("rotor", *words, "--digits=9", "--format=csv").records()
    return {row["line"]: row for row in rows if row["solution"] == solution}


def unbalance(row: dict[str, str]) -> complex:
    """Return m r e^iα of a printed line, from mass and radius."""
    return cmath.rect(
        float(row["mass_kg"]) * float(row["radius_mm"]) / 1000, math.radians(float(row["angle"] or 0))
    )


def vectors(rows: Rows, *keys: str) -> Vectors:
    return [
        (unbalance(row), float(row["plane_mm"]) / 1000)
        for key, row in rows.items()
        if key.rpartition("_")[0] in keys
    ]


def total(masses: Vectors, about: float | None = None) -> complex:
    return sum((pull * (1 if about is None else plane - about) for pull, plane in masses), 0j)


def said(row: dict[str, str], column: str) -> complex:
    return cmath.rect(float(row[column]), math.radians(float(row["angle"] or 0)))


def listed(values: Any, unit: str = "") -> str:
    return ";".join(f"{value}{unit}" for value in values)


MASSES = st.lists(
    st.tuples(
        st.integers(1, 400), st.integers(20, 900), st.integers(0, 1440).map(lambda n: n / 4),
        st.integers(-900, 1900),
    ),
    min_size=1,
    max_size=6,
)  # fmt: skip
PLANES = st.tuples(st.integers(-900, 400), st.integers(401, 1900))


@settings(max_examples=12, deadline=None)
@given(
    masses=MASSES, planes=st.tuples(st.integers(-900, 400), st.integers(401, 1900)), turns=st.integers(1, 50)
)
def test_balancing_masses_leave_neither_a_pull_nor_a_couple_and_bearings_take_the_rest(
    masses: list[tuple[int, int, float, int]], planes: tuple[int, int], turns: int
) -> None:
    mass, radius, angle, plane = (listed(one) for one in zip(*masses, strict=True))
    words = (
        f"--masses={mass}kg", f"--radii={radius}mm", f"--angles={angle}", f"--planes={plane}mm",
        f"--speed={turns}/s", "--about=170mm",
    )  # fmt: skip
    rows = page(*words, f"--balance-planes={listed(planes)}mm", "--balance-radii=250mm")
    own = [(cmath.rect(m * r / 1000, math.radians(a)), z / 1000) for m, r, a, z in masses]
    square = (2 * math.pi * turns) ** 2
    assert abs(said(rows["unbalance"], "unbalance_kgm") - total(own)) < 1e-6
    assert abs(said(rows["couple"], "moment_nm") - square * total(own, 0.17)) < 1e-6 * square
    added = vectors(rows, "balance")
    assert [plane for _, plane in added] == [plane / 1000 for plane in planes]
    assert abs(total(own + added)) < 1e-6
    assert abs(total(own + added, -1.3)) < 1e-6
    assert (rows["left_unbalance"]["unbalance_kgm"], rows["left_couple"]["moment_kgm2"]) == ("0", "0")
    held = page(*words, "--bearings=-0.3;2.1m")
    near, far = (said(held[f"bearing_{number}"], "unbalance_n") for number in (1, 2))
    assert abs(near + far - square * total(own)) < 1e-6 * square
    assert abs(-0.3 * near + 2.1 * far - square * total(own, 0)) < 1e-6 * square


@pytest.mark.parametrize(
    ("masses", "radii", "angles", "planes", "ways"),
    [
        ("?;10;5;4kg", "100;125;200;150mm", "?;0;?;?", "0;0.6;1.2;1.8m", 2),
        ("?;31;52;43kg", "180;240;120;150mm", "?;0;97;211", "?;0;310mm;?", 1),
        ("17;?;23kg;?", "110;90;70;130mm", "15;?;140;?", "0;200;450;900mm", 1),
    ],
)
def test_what_is_asked_for_balances_the_others(
    masses: str, radii: str, angles: str, planes: str, ways: int
) -> None:
    words = (f"--masses={masses}", f"--radii={radii}", f"--angles={angles}", f"--planes={planes}", "-r1:4")
    pages = [page(*words, solution=str(way)) for way in range(1, ways + 1)]
    found = [vectors(rows, "mass") for rows in pages]
    assert not page(*words, solution=str(ways + 1))
    for way in found:
        assert abs(total(way)) < 1e-7
        assert abs(total(way, 0)) < 1e-7
    for rows, way in zip(pages, found, strict=True):
        second = [(pull**2 / abs(pull) / 4, plane) for pull, plane in way]
        assert abs(said(rows["second_unbalance"], "unbalance_kgm") - total(second)) < 1e-7
        assert abs(said(rows["second_couple"], "moment_kgm2") - total(second, 0)) < 1e-7
    assert len({tuple(way) for way in found}) == ways


def test_a_triangle_of_masses_has_the_angles_of_the_triangle() -> None:
    # 3, 4 and 5 at one radius; what closes is a right angle between 3 and 4.
    words = ("--masses=3;4;5kg", "--radii=100mm", "--angles=0;?;?")
    first, second = (page(*words, solution=way) for way in ("1", "2"))
    third = math.degrees(math.acos(3 / 5))
    assert {float(rows["mass_2"]["angle"]) for rows in (first, second)} == {90, 270}
    assert {round(float(rows["mass_3"]["angle"]), 9) for rows in (first, second)} == {
        round(180 - third, 9), round(180 + third, 9)
    }  # fmt: skip
    line = page("--masses=3;4;7kg", "--radii=100mm", "--angles=0;?;?")
    assert [float(line[f"mass_{number}"]["angle"]) for number in (2, 3)] == [0, 180]


def test_a_direction_half_way_between_two_printed_ones_is_rounded_away() -> None:
    rows = printed(
        "rotor", "--masses=2;2kg", "--radii=1m", "--angles=0;45", "--digits=0", "--format=csv"
    ).records()
    assert rows[-1]["angle"] == "23"


def test_a_plane_may_be_a_number_of_metres_from_python() -> None:
    found = kurbel.rotor([3, 4], radii=0.1, angles=[0, 90], planes=[0, 1], about=0.17)
    words = ("--masses=3;4kg", "--radii=0.1m", "--angles=0;90", "--planes=0;1m", "--about=0.17m")
    assert kurbel.typeset(found, "csv") == printed("rotor", *words, "-f", "csv").out


def test_without_planes_nothing_is_said_of_couples() -> None:
    rows = page("--masses=3;4kg", "--radii=100mm", "--angles=0;90")
    assert [*rows] == ["mass_1", "mass_2", "unbalance"]
    assert "moment_kgm2" not in rows["unbalance"]


def test_a_mass_that_is_asked_for_may_have_the_unit_of_all() -> None:
    said = ("--radii=300mm", "--angles=?;0;120;?", "--planes=0;450;1200;1650mm")
    rows = page("--masses=?;400;400;?kg", *said)
    assert rows == page("--masses=?;400;400kg;?", *said)
    # Moments about the outer planes.
    for key, pull in (("1", 120 * (1200 + 450 * 1j) / 1650), ("4", 120 * (450 + 1200 * 1j) / 1650)):
        real, turned = pull.real, pull.imag * cmath.rect(1, math.radians(120))
        assert unbalance(rows[f"mass_{key}"]) == pytest.approx(-(real + turned), abs=1e-7)
    refused = refusal("rotor", "--masses=3;4g;?kg", "--radii=300mm", "--angles=0;120;?")
    assert 'mass "3" has no unit' in refused


def test_keys_of_records_say_the_unit_which_need_not_be_the_one_that_was_typed() -> None:
    words = ("--masses=3;2lb", "--radii=5in", "--angles=0;90", "--planes=0;10in", "--speed=1/s")
    row = page(*words)["mass_2"]
    assert (float(row["mass_kg"]), float(row["radius_mm"]), float(row["plane_mm"])) == (0.90718474, 127, 254)
    assert row.keys() >= {"unbalance_kgm", "moment_kgm2", "unbalance_n", "moment_nm"}
    row = page(*words, "--units=imperial")["mass_2"]
    assert (float(row["mass_lb"]), float(row["radius_in"]), float(row["plane_in"])) == (2, 5, 10)
    assert row.keys() >= {"unbalance_lbft", "moment_lbft2", "unbalance_lbf", "moment_lbfft"}
