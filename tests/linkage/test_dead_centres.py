"""Dead centres, stroke and times as fields: against the slide and the links enclosed."""

from __future__ import annotations

from decimal import Decimal, localcontext
from typing import Any

import pytest
from cli import printed, records
from drives import slide

from kurbel.verify import CONFIRMED

SLIDES = [("1:5", "0.7"), ("1:3.1", "-1.9"), ("1:9", "0"), ("1:1.6", "0.55")]
FIELDS = (
    "phi_i", "phi_o", "lead", "time_ratio", "stroke", "stroke_mm", "transmission", "v_mps", "c_m_mps", 
    "v_c_m", "outstroke_time", "return_time",
)  # fmt: skip


@pytest.mark.parametrize(("ratio", "offset"), SLIDES)
def test_the_slide_rests_at_the_dead_centres_and_goes_the_stroke_between_them(
    ratio: str, offset: str
) -> None:
    drive = slide(ratio, offset, radius="0.17", speed="97/60", turns=True)
    asked = (*drive.words, "--stroke=340mm", "--speed=97/min", "--digits=12", f"--columns={','.join(FIELDS)}")
    (row,) = records("deadcentres", *asked)
    for key in FIELDS:
        assert drive.true.value(key).confirms(row[key]) == CONFIRMED, key


def test_a_page_of_the_motion_has_the_speeds_of_the_turn_as_fields() -> None:
    words = ("--ratio=1:3.1", "--offset=-1.9", "--stroke=340mm", "--speed=97/min")
    keys = ("v_mps", "c_m_mps", "v_c_m")
    columns = ("--digits=12", f"--columns={','.join(keys)}")
    beside = records("deadcentres", *words, *columns)
    rows = records("table", *words, "--angle=7;170", f"{columns[1]},x_return", columns[0])
    assert [{key: row[key] for key in keys} for row in rows] == beside * 2
    for size, key, value in (
        # Of so many radians a second the pin's speed is a short number, and the mean has π: ω R = 2.55 m/s.
        ("--stroke=340mm --speed=15rad/s", "v_mps", "2.6"),
        ("--stroke=340mm --speed=15rad/s", "c_m_mps", "1.6"),
        # 1.25 lies half-way.
        ("--stroke=300mm --speed=125/min", "c_m_mps", "1.3"),
    ):
        asked = (*size.split(), "--angle=7", f"--columns={key}", "--digits=1")
        assert records("table", *asked) == [{key: value}]
    page = printed("table", "--stroke=1m", "--speed=1/s", "--columns", ",".join(keys)).out
    assert "v = S π n/60, cₘ = S n/30, v:cₘ = π:2" in page


def test_a_machine_has_the_dead_centres_of_its_crank_or_of_its_beam(tmp_path: Any) -> None:
    file = tmp_path / "engine.toml"
    file.write_text('[crank]\nstroke = "600mm"\nrod = "1200mm"\nspeed = "120/min"\noffset = 0.5\n')
    machine = f"--machine={file}"
    typed = ("--stroke=600mm", "--rod=1200mm", "--speed=120/min", "--offset=0.5")
    assert printed("deadcentres", machine).out == printed("deadcentres", *typed).out
    assert (
        printed("deadcentres", machine, "--beam=4").out
        == printed("deadcentres", "--beam=4", "--ratio=1:4").out
    )


@pytest.mark.parametrize(
    ("column", "words", "tie", "beside"),
    [
        ("v_mps", "--stroke={}mm --speed=1rad/s --digits=1", ("2500", "1.2"), ("2500.0001", "1.3")),
        ("v_mps", "--mechanism=arc --rocker=6 --stroke={}mm --speed=1rad/s --digits=1", ("2500", "1.2"),
         ("2500.0001", "1.3")),
        ("c_m_mps", "--stroke={}mm --speed=60/min --digits=1", ("625", "1.2"), ("625.0001", "1.3")),
        ("outstroke_time", "--stroke=1m --speed={}/min --digits=1", ("120", "0.2"), ("119.999", "0.3")),
        ("return_time", "--stroke=1m --speed={}/min --digits=1", ("120", "0.2"), ("119.999", "0.3")),
        ("stroke_mm", "--stroke={}mm --digits=0", ("600.5", "600"), ("600.5001", "601")),
        # (13/4 + 1)² - (9/5)² and (13/4 - 1)² - (9/5)² are the squares of 3.85 and 1.35.
        ("stroke", "--ratio=4:13 --offset={} --digits=0", ("1.8", "2"), ("1.8001", "3")),
    ],
)  # fmt: skip
def test_a_value_half_way_is_rounded_as_one_and_its_neighbour_is_not(
    column: str, words: str, tie: tuple[str, str], beside: tuple[str, str]
) -> None:
    for given, value in (tie, beside):
        asked = (*words.format(given).split(), f"--columns={column}", "--rounding=half-even", "--format=csv")
        assert printed("deadcentres", *asked).records() == [{column: value}]


@pytest.mark.parametrize(
    ("column", "words", "power"),
    [
        # What has π or an arc lies on no boundary, however near a length of many figures brings it.
        ("v_mps", "--stroke={}m --speed=2/s", 1),
        ("c_m_mps", "--stroke={}m --speed=3rad/s", 1),
        ("outstroke_time", "--stroke=1m --speed={}rad/s", -1),
        ("return_time", "--stroke=1m --speed={}/s --offset=0.7", -1),
        ("stroke_mm", "--stroke={}m --mechanism=arc --rocker=6", 1),
        ("c_m_mps", "--stroke={}m --speed=2/s --mechanism=arc --rocker=6", 1),
    ],
)
def test_a_value_next_to_a_boundary_is_rounded_to_its_own_side(column: str, words: str, power: int) -> None:
    def shown(given: Decimal, digits: int) -> str:
        asked = (
            *words.format(f"{given:.45f}").split(),
            f"--columns={column}",
            f"--digits={digits}",
            "-f=csv",
        )
        ((value,),) = (
            row.values() for row in printed("deadcentres", *asked, "--rounding=half-even").records()
        )
        return value

    with localcontext(prec=60):
        given = (Decimal("6.5") / Decimal(shown(Decimal(1), 48))) ** power
        beside = [given * (1 + side * power * Decimal("1e-40")) for side in (-1, 1)]
    assert [shown(one, 0) for one in beside] == ["6", "7"]
