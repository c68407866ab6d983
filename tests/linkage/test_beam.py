"""The beam engine: its dead centres by § 149 and by its links enclosed, conditions, machines."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from cli import printed, records, refusal
from drives import BEAMS, Drive, beam
from mpmath import mp

from kurbel.kernel import beam as kernel
from kurbel.verify import CONFIRMED, Value

KEYS = ("mu", "nu", "distance_1", "distance_2", "path_1", "path_2")
# Beams of all lengths, rods from long to nearly too short; the last two nearly come into line.
DRIVES = [
    *BEAMS, beam("1.3", "20/11"), beam("40", "30"), beam("100000000", "5"), beam("9/4", "8/7"),
    beam("1.011", "5"),
]  # fmt: skip
EACH = pytest.mark.parametrize("drive", DRIVES, ids=str)


def dead_centres(*words: str) -> dict[str, str]:
    (row,) = records("deadcentres", *words, f"--columns={','.join(KEYS)}")
    return row


@EACH
def test_every_digit_is_that_of_the_closed_linkage(drive: Drive) -> None:
    found, links = dead_centres(*drive.words[1:], "--exact", "--digits=30"), drive.true
    # The rod leans by μ and ν, and the beam moves by the path up to the vertical crank.
    true = (
        links.value("phi_i"), Value(lambda: links.dead_degrees(-1) - 180),
        Value(lambda: links.dead_degrees(-1) - links.dead_degrees(1)),
        Value(lambda: links.dead_degrees(1) - links.dead_degrees(-1) + 360),
        links.value("path", 0), links.value("path_return", 0),
    )  # fmt: skip
    for key, expected in zip(KEYS, true, strict=True):
        assert expected.confirms(found[key]) == CONFIRMED, key


@pytest.mark.parametrize("words", [("--mechanism=beam",), ("--exact",)], ids=str)
def test_the_drive_and_the_linkage_of_the_book_have_one_geometry(words: tuple[str, ...]) -> None:
    keys, place = (("phi_i", "phi_o", "lead"), 180) if "beam" in words[0] else (("mu", "nu", "distance_1"), 0)
    asked = ("--beam=3", "--ratio=1:5", "--digits=9", f"--columns={','.join(keys)}")
    (row,) = records("deadcentres", *asked, *words)
    inner, outer, apart = (Fraction(row[key]) for key in keys)
    assert (inner, outer - place) == (Fraction("0.819487142"), Fraction("1.229283111"))
    assert apart + place == Fraction("180.409795969")


def test_the_approximate_slants_are_the_parts_of_a_radian_in_the_book() -> None:
    found = dead_centres("--beam=3", "--ratio=1:5", "--digits=30")
    with mp.workdps(50):
        for key, part in (("mu", 72), ("nu", 48)):
            assert abs(mp.mpf(found[key]) - 180 / mp.pi / part) < mp.mpf("0.501e-30")


# Near the line of beam, pivot and shaft the root, hence everything, is ill-conditioned: no floats there.
@pytest.mark.parametrize("drive", DRIVES[:-2], ids=str)
def test_floats_and_arrays_keep_their_digits(drive: Drive) -> None:
    found = dead_centres(*drive.words[1:], "--exact", "--digits=40")
    assert drive.true.rocker
    arm, ratio = float(drive.true.rocker), float(drive.true.ratio)
    # Newton's method rises from below towards the root of a concave function.
    square = 1.0
    for _ in range(20):
        square -= float(kernel.closure(square, arm, ratio) / kernel.closure_slope(square, arm, ratio))
    sides = np.array([ratio, -ratio])
    slants = np.degrees(np.arcsin(np.asarray(kernel.lean_sine(square, arm, sides))))
    paths = 2 * arm * np.arctan(np.asarray(kernel.swing_tangent(square, arm, sides)))
    for keys, values in ((("mu", "nu"), slants), (("path_1", "path_2"), paths)):
        np.testing.assert_allclose(values, [float(found[key]) for key in keys], rtol=1e-14, atol=0)
    for formula in (kernel.lean_sine, kernel.swing_tangent):
        alone = [formula(square, arm, one) for one in (ratio, -ratio)]
        assert alone == np.asarray(formula(square, arm, sides)).tolist()


def test_long_beams_and_rods_need_no_exact_geometry() -> None:
    long = ("--beam=1000000", "--ratio=1:1000000", "--digits=40")
    true, approximate = dead_centres(*long, "--exact"), dead_centres(*long)
    for key in KEYS:
        assert abs(Fraction(true[key]) / Fraction(approximate[key]) - 1) < 1e-5


@pytest.mark.parametrize("more", [(), ("--exact",), ("--rounding=half-even",)])
def test_an_infinite_rod_stays_vertical(more: tuple[str, ...]) -> None:
    found = dead_centres("--beam=1.001", "--ratio=1:∞", "--digits=9", *more)
    assert [float(one) for one in found.values()] == [0, 0, 180, 180, 0, 0]


def test_a_condition_that_holds_nowhere_is_told_the_range() -> None:
    drive, asked = BEAMS[0], (*BEAMS[0].words, "--columns=phi_turn", "--digits=9")
    assert records("solve", *asked, "--where", "c=max") == records("solve", *asked, "--where", "p=0")
    said = refusal("solve", *drive.words, "--where", "c=1.1", code=1)
    assert said.startswith(
        "velocity = 1.1 is reached nowhere for R:L = 1:5; velocity lies between 0.0000 and"
    )


MACHINE = """
[crank]
mechanism = "beam"
beam = 3
ratio = "1:5"
stroke = "1.2m"
speed = "30/min"

[steam]
eps = 3
bore = "800mm"
pressure = "3bar"

[masses]
reciprocating = "900kg"
rocker = "9000kg m²"
"""
DRIVE = (*BEAMS[0].words, "--stroke=1.2m", "--speed=30/min")
LOADED = ("--eps=3", "--bore=800mm", "--pressure=3bar", "--reciprocating=900kg", "--rocker-inertia=9000kg m²")


PAGES = {
    "delta": LOADED,
    "deadcentres": (),
    "solve --where c=max": (),
    "inertia --centre 0.6 --gyration 0.4": (),
}


@pytest.mark.parametrize("asked", PAGES)
def test_a_machine_may_be_a_beam_engine(asked: str, tmp_path: Path) -> None:
    path = tmp_path / "engine.toml"
    path.write_text(MACHINE, encoding="utf-8")
    words = asked.split()
    assert printed(*words, f"--machine={path}").out == printed(*words, *DRIVE, *PAGES[asked]).out
