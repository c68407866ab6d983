"""The speed over the turn with a given flywheel: against its energies and against the equation of motion."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from cli import kurbel, printed, records
from figures import figures
from machines import machine
from numpy.testing import assert_allclose
from places import CARDS

import kurbel as library

MACHINE = (
    "--stroke 600mm --bore 300mm --pressure 8bar --speed 120/min --reciprocating 300kg --rod-mass 150kg"
    " --centre 0.6 --gyration 0.3"
)
HEAVY = {
    "stroke": "600mm", "bore": "300mm", "pressure": "8bar", "speed": "120/min", "reciprocating": "300kg",
    "rod_mass": "150kg", "centre": "0.6", "gyration": "0.3",
}  # fmt: skip
STEAM = {"eps": "4", "back": "1/7"}
SQUARE = {"resistance": "square"}
ANGLES = (61, 103, 203, 341)


def numbers(command: str) -> list[dict[str, float]]:
    found = records(*command.split())
    return [
        {key: float(value) for key, value in one.items() if value[-1:].isdigit() and ":" not in value}
        for one in found
    ]


@pytest.mark.parametrize(
    ("options", "wheel"),
    [
        ({**STEAM}, {"flywheel": "3"}),
        ({**STEAM, "ratio": "2:7", "single_acting": True, "cranks": "0;90"}, {"flywheel": "20"}),
        ({"eps": "3", "ratio": "1:4", "offset": "0.2", "cranks": "0;140"}, {"flywheel": "2"}),
        ({**STEAM, "exponent": "1.13", "clearance": "5%", "ratio": "1:∞"}, {"flywheel": "3"}),
        ({"compression": "8", "peak_pressure": "30", "ratio": "1:4", "offset": "0.1"}, {"flywheel": "30"}),
        ({"pressure_ratio": "3", "mechanism": "arc", "rocker": "6"}, {"flywheel": "9"}),
        ({"pump": "double", "cranks": "0;90"}, {"flywheel": "3"}),
        ({**STEAM, **HEAVY}, {"inertia": "150kgm2"}),
        (
            {**STEAM, **HEAVY, "ratio": "2:7", "offset": "0.2", "cranks": "0;100", "slope": "35"},
            {"inertia": "60kgm2"},
        ),
        pytest.param({**STEAM, **HEAVY, "ratio": "1:4"}, {"flywheel": "5"}, marks=pytest.mark.slow),
        ({**STEAM}, {"flywheel": "8", **SQUARE}),
        ({"eps": "3", "ratio": "1:4", "offset": "0.2"}, {"flywheel": "10", **SQUARE}),
        # So light that the greatest speed is more than twice, ten times and nine times the least.
        ({**STEAM}, {"flywheel": "0.7", **SQUARE}),
        ({**STEAM, **HEAVY, "ratio": "1:3", "reciprocating": "900kg"}, {"inertia": "9kgm2"}),
        ({"eps": "5", "ratio": "1:4", "cranks": "0;180"}, {"flywheel": "0.0133", **SQUARE}),
        pytest.param(
            {"eps": "3", "mechanism": "arc", "rocker": "6", "cranks": "0;70"},
            {"flywheel": "9", **SQUARE},
            marks=pytest.mark.slow,
        ),
        pytest.param(
            {"compression": "8", "peak_pressure": "30", "cranks": "0;360"},
            {"flywheel": "30", **SQUARE},
            marks=pytest.mark.slow,
        ),
    ],
)  # fmt: skip
def test_speed_and_time_are_those_of_the_equation_of_motion(
    options: dict[str, Any], wheel: dict[str, Any]
) -> None:
    # The number of a flywheel is of the speed at the dead centre, the speed is the mean of both extremes.
    options, omega = {"speed": "120/min"} | options, 4 * math.pi
    unit = math.pi / 4 * 0.3**2 * 8e5 * 0.3 / omega**2
    if "flywheel" in wheel:
        speed = machine(**options).speed(number=float(wheel["flywheel"]), square="resistance" in wheel)
    else:
        speed = machine(**options).speed(inertia=float(wheel["inertia"].removesuffix("kgm2")) / unit)
    page = library.turning(**options, **wheel, angle=ANGLES, columns="omega,time", digits=9)
    speeds, times = speed.at(ANGLES)
    wanted = np.column_stack([speeds * omega, times / omega])
    assert_allclose(figures(page, ("omega", "time")), wanted, rtol=0, atol=2e-9)
    columns = ("speed_min", "speed_max", "delta_mean")
    page = library.delta(**options, **wheel, columns=columns, digits=9)
    least, greatest = speed.least / speed.first, speed.greatest / speed.first
    assert_allclose(figures(page, columns)[-1], [least, greatest, speed.delta], rtol=0, atol=2e-9)


def test_flywheel_and_delta_are_inverse() -> None:
    about = "--eps 3 --power 50kW --speed 120/min"
    (wheel,) = numbers(f"flywheel {about} --delta 1:37 --columns inertia --digits 20")
    (page,) = numbers(
        f"delta {about} --inertia {wheel['inertia']!r}kgm2 --columns one_to_mean,number --digits 9"
    )
    assert_allclose(page["one_to_mean"], 37, rtol=1e-12)
    # A wheel given by its number has the speeds of the one that has this number.
    (by_number,) = numbers(f"delta --eps 3 --flywheel {page['number']!r} --columns one_to_mean --digits 9")
    assert_allclose(by_number["one_to_mean"], 37, rtol=1e-9)


def test_against_the_square_of_the_speed_a_number_is_its_inertia() -> None:
    asked = "delta --eps 3 --resistance square --digits 9 --columns"
    wheel = "--inertia 100kgm2 --power 50kW --speed 120/min"
    (page,) = numbers(f"{asked} number,delta_mean,delta_first {wheel}")
    (by_number,) = numbers(f"{asked} delta_mean,delta_first --flywheel {page['number']!r}")
    assert_allclose([page[key] for key in by_number], [*by_number.values()], rtol=0, atol=3e-9)


def test_heavy_flywheel_has_the_irregularity_of_first_order() -> None:
    (page,) = numbers("delta --eps 4 --flywheel 1e9 --columns delta_mean,delta_first,delta --digits 18")
    assert_allclose([page["delta_mean"] * 1e9, page["delta_first"] * 1e9], page["delta"], rtol=1e-8)


def test_weisbachs_speed_is_one_and_his_work_over_the_number() -> None:
    for row in numbers(
        "turning --eps 2 --flywheel 7 --method weisbach --columns phi,energy,speed --digits 12"
    ):
        mean = 2 / math.pi * math.log(2) / 2
        assert_allclose(row["speed"], 1 + row["energy"] / mean / 7, atol=3e-12)
    (page,) = numbers("delta --eps 2 --flywheel 7 --method weisbach --columns delta,delta_first --digits 12")
    assert_allclose(page["delta_first"], page["delta"] / 7, rtol=1e-11)


HEAVY_CARD = MACHINE.replace("--pressure 8bar", "")


@pytest.mark.parametrize(
    ("masses", "wheel"),
    [("", "--flywheel 3"), ("", "--flywheel 3 --resistance square"), (HEAVY_CARD, "--flywheel 3"),
     (HEAVY_CARD, "--inertia 20kgm2")],
)  # fmt: skip
def test_card_of_the_ideal_engine_has_its_speed_and_time_but_for_the_errors(masses: str, wheel: str) -> None:
    speed = "" if masses else "--speed 120/min"
    steam = f"--eps 2 --back 0.5 {'--pressure 8bar' if masses else ''}"
    for page in (
        "turning --angle 0;30;215;360;400 --columns speed,rpm,time,angular_acceleration",
        "delta --columns phi_min,speed_min,phi_max,speed_max,delta_mean",
    ):
        asked = f"{page} --digits 9 {wheel} {speed} {masses}"
        by_card = records(*f"{asked} --card {CARDS / 'ideal-2.csv'}".split())
        for card, ideal in zip(by_card, numbers(f"{asked} {steam}"), strict=True):
            for key in (one for one in ideal if f"{one}_error" in card):
                last = 10.0 ** -len(card[key].partition(".")[2])
                assert abs(float(card[key]) - ideal[key]) <= float(card[f"{key}_error"]) + last / 2
                assert key.startswith("phi") or last < 1e-3


def test_bounds_of_the_flywheel_are_where_the_speed_vanishes() -> None:
    # The bound is rounded up to three figures, so that 0.3 % less will not do.
    for flywheel, passes in (("0.369", True), ("0.3679", False)):
        result = kurbel(*f"turning --eps 4 --flywheel {flywheel} --columns phi,speed".split())
        assert (result.code == 0) is passes


@pytest.mark.parametrize("lang", ["de", "en"])
def test_every_column_of_a_flywheel_is_printed(lang: str) -> None:
    wheel = ("--inertia=900kgm2", "--power=50kW", "--speed=120/min", "--eps=3", f"--lang={lang}", "--columns")
    assert len(printed("turning", *wheel, "phi,speed,omega,rpm,time", "--step=90").out.splitlines()) > 9
    page = "number,phi_min,speed_min,phi_max,speed_max,delta_mean,one_to_mean,delta_first"
    assert len(printed("delta", *wheel, page).out.splitlines()) > 9
