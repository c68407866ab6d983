"""Dead centres, stroke and times as fields: against the slide and the links that mpmath closes."""

from __future__ import annotations

from decimal import Decimal, localcontext
from fractions import Fraction
from typing import Any

import pytest
from cli import printed, refusal
from links import CRANKS, DIGITS, Real, links, shown
from mpmath import mp
from textbook import real

from kurbel.linkage.arc.crank import ArcCrank

KEYS = ("phi_i", "phi_o", "lead", "time_ratio", "stroke", "transmission", "v_c_m")
SLIDES = [("5", "0.7"), ("3.1", "-1.9"), ("9", "0"), ("1.6", "0.55")]


def fields(*words: str) -> dict[str, Real]:
    (row,) = printed("deadcentres", *words, "--digits=12", "--format=csv").records()
    return {key: mp.mpf(value) for key, value in row.items() if key != "ratio"}


def agrees(found: dict[str, Real], expected: dict[str, Real]) -> None:
    for key, value in expected.items():
        assert abs(found[key] - value) < mp.mpf("0.51e-12"), key


@pytest.mark.parametrize(("rod", "offset"), SLIDES)
def test_the_slide_rests_at_the_dead_centres_and_goes_the_stroke_between_them(rod: str, offset: str) -> None:
    found = fields(f"--ratio=1:{rod}", f"--offset={offset}", "--stroke=340mm", "--speed=97/min")
    with mp.workdps(DIGITS):
        length, e = real(Fraction(rod)), real(Fraction(offset))

        def position(angle: Real) -> Real:
            return mp.cos(angle) + mp.sqrt(length**2 - (mp.sin(angle) - e) ** 2)

        inner, outer = (mp.findroot(lambda a: mp.diff(position, a), start) for start in (0, mp.pi))
        stroke, apart = position(inner) - position(outer), mp.degrees(outer - inner)
        pin = mp.mpf("0.17") * 97 * mp.pi / 30
        # The time of a turn is 60 s/n, of which each way takes its share.
        mean = 2 * stroke * mp.mpf("0.17") / (mp.mpf(60) / 97)
        agrees(
            found,
            {
                "phi_i": mp.degrees(inner),
                "phi_o": mp.degrees(outer),
                "lead": apart - 180,
                "time_ratio": apart / (360 - apart),
                "stroke": stroke,
                "stroke_mm": 170 * stroke,
                "transmission": mp.degrees(mp.acos((1 + abs(e)) / length)),
                "v_mps": pin,
                "c_m_mps": mean,
                "v_c_m": pin / mean,
            },
        )


@pytest.mark.parametrize("crank", [one for one in CRANKS if one.circuit == 1], ids=shown)
def test_the_rocker_rests_at_the_dead_centres_and_swings_between_them(crank: ArcCrank) -> None:
    machine = links(crank)
    place = [] if crank.distance is None else [f"--pivot={float(crank.distance)};{float(crank.pivot_height)}"]
    offset = [f"--offset={float(crank.crank.offset)}"] if crank.crank.offset else []
    words = (f"--ratio=1:{float(1 / crank.crank.ratio)}", f"--rocker={float(crank.rocker)}", *place, *offset)
    found = fields("--mechanism=arc", *words, "--stroke=2m", "--speed=1rad/s")
    with mp.workdps(DIGITS):
        (inner, high), (outer, low) = machine.inner, machine.outer
        apart = mp.degrees(outer - inner) % 360
        swing = abs(mp.arg(mp.expj(high - low)))
        # The crank-pin goes a metre a second, a turn takes 2π seconds.
        mean = 2 * swing * machine.rocker / (2 * mp.pi)
        expected = {
            "swing": mp.degrees(swing),
            "stroke": swing * machine.rocker,
            "time_ratio": apart / (360 - apart),
        }
        agrees(
            found, {**expected, "lead": apart - 180, "v_mps": mp.mpf(1), "c_m_mps": mean, "v_c_m": 1 / mean}
        )
        for key, angle in (("phi_i", inner), ("phi_o", outer)):
            turns = (found[key] - mp.degrees(angle)) / 360
            assert abs(turns - mp.nint(turns)) < mp.mpf("1e-14")


def test_a_page_of_the_motion_has_the_speeds_of_the_turn_as_fields() -> None:
    words = (
        "table",
        "--ratio=1:3.1",
        "--offset=-1.9",
        "--stroke=340mm",
        "--angle=7;170",
        "--digits=12",
        "--format=csv",
    )
    keys = ("v_mps", "c_m_mps", "v_c_m")
    beside = fields("--ratio=1:3.1", "--offset=-1.9", "--stroke=340mm", "--speed=97/min")
    rows = printed(*words, "--speed=97/min", f"--columns={','.join(keys)},x_return").records()
    assert [[mp.mpf(row[key]) for key in keys] for row in rows] == [[beside[key] for key in keys]] * 2
    # Of so many radians a second the pin's speed is a short number, and the mean has π: ω R = 2.55 m/s.
    (row,) = printed(
        "table",
        "--angle=7",
        "--stroke=340mm",
        "--speed=15rad/s",
        "--columns=v_mps,c_m_mps",
        "--digits=1",
        "-f",
        "csv",
    ).records()
    assert row == {"v_mps": "2.6", "c_m_mps": "1.6"}
    (row,) = printed(
        "table",
        "--angle=7",
        "--stroke=300mm",
        "--speed=125/min",
        "--columns=c_m_mps",
        "--digits=1",
        "-f",
        "csv",
    ).records()
    # 1.25 lies half-way.
    assert row == {"c_m_mps": "1.3"}
    assert (
        "v = S π n/60, cₘ = S n/30, v:cₘ = π:2"
        in printed("table", "--stroke=1m", "--speed=1/s", "--columns", ",".join(keys)).out
    )


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


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (
            ("--beam=3", "--offset=0.1"),
            "--offset does not belong to the beam engine; leave --beam and --exact",
        ),
        (("--offset=0.1", "--exact", "--layout=dead-centres"), "--exact is for the beam engine, and a crank"),
        (
            ("--beam=3", "--stroke=1m"),
            "--stroke gives the ratio of the beam engine only where both are known",
        ),
        (
            ("--mechanism=parallel",),
            "the parallel crank has no stroke between dead centres; the straight crank",
        ),
        (
            ("--offset=0.1", "--columns=swing"),
            "column swing is of a rocker; add --mechanism arc, for example",
        ),
        (("--offset=0.1", "--columns=c_m_mps"), "column c_m_mps is in m/s and needs --stroke and --speed"),
        (
            ("--offset=0.1", "--rocker=6"),
            "--rocker does not belong to the offset crank; it is for --mechanism",
        ),
        (
            ("--offset=5",),
            "offset e = 5 R is too large for R:L = 1:5; the crank turns only if |e| < L - R = 4",
        ),
    ],
)
def test_what_has_no_dead_centres_is_refused_with_a_sentence(words: tuple[str, ...], sentence: str) -> None:
    assert refusal("deadcentres", *words).startswith(sentence)
