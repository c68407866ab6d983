"""The acceleration pressure and that on the piston: against machines.py and the energy of the masses."""

from __future__ import annotations

import numpy as np
import pytest
from cli import printed
from drawings import drawn
from machines import machine
from places import ROOT

import kurbel as api

RATIO, STROKE, BORE, EPS, PRESSURE = "1:4.3", "0.58", "0.27", "3.7", "7.4"
MASSES = (f"--stroke={STROKE}m", f"--bore={BORE}m", "--speed=126/min", "--reciprocating=231kg")
STEAM = (f"--eps={EPS}", f"--pressure={PRESSURE}bar")
SHARES = ("0", "0.13", "0.3125", "0.6", "1")
each_offset = pytest.mark.parametrize("offset", ["0", "0.7"])


@each_offset
def test_the_pressures_at_a_share_of_the_stroke_are_those_of_its_equations_of_motion(offset: str) -> None:
    given = {one[2:].partition("=")[0]: one.partition("=")[2] for one in (*MASSES, *STEAM)}
    engine = machine(ratio=RATIO, offset=offset, **given)
    words = ("pressures", f"--ratio={RATIO}", f"--offset={offset}", *MASSES, *STEAM)
    rows = printed(*words, f"--shares={';'.join(SHARES)}", "--digits=7", "--format=csv").records()
    assert [(row["stroke"], row["share"]) for row in rows] == [
        (stroke, f"{float(share):.4f}") for stroke in "12" for share in SHARES
    ]
    inner, outer = engine.dead_centres
    for stroke, (sign, begin, end) in enumerate(((1, inner, outer), (-1, outer, inner + 360))):
        between = engine.angles_of(stroke, [float(share) for share in SHARES[1:-1]])
        angles = np.array([begin, *between, end])
        # A dead centre is that of the stroke itself.
        own = np.clip(angles, begin + 1e-9, end - 1e-9)
        forces = {key: sign * float(PRESSURE) * value for key, value in engine.rod(own).items()}
        expected = {
            "crank_angle": angles,
            "gas_pressure": forces["piston_force"],
            "inertia_pressure": -forces["inertia_force"],
            "left_pressure": forces["crosshead_load"],
        }
        for key, values in expected.items():
            found = [float(row[key]) for row in rows[5 * stroke : 5 * stroke + 5]]
            np.testing.assert_allclose(found, values, rtol=0, atol=6e-8, err_msg=key)


@each_offset
def test_what_the_masses_take_on_a_stroke_they_give_back(offset: str) -> None:
    # At both dead centres they stand still: the acceleration pressure works nothing from one to the other.
    # Near these an offset makes it a function of the root of the share.
    nodes, weights = np.polynomial.legendre.leggauss(24)
    angles = np.pi / 2 * (nodes + 1)
    shares = ";".join(f"{share:.15f}" for share in (1 - np.cos(angles)) / 2)
    words = ("pressures", f"--ratio={RATIO}", f"--offset={offset}", *MASSES, f"--shares={shares}")
    rows = printed(*words, "--columns=inertia_pressure", "--digits=12", "--format=csv").records()
    taken = np.array([float(row["inertia_pressure"]) for row in rows]).reshape(2, -1)
    assert np.abs(taken).max() > 1
    np.testing.assert_allclose(taken @ (weights * np.sin(angles)), 0, rtol=0, atol=1e-9)


def test_over_the_crank_angle_they_are_those_at_the_path_gone_there() -> None:
    machine = (
        f"--ratio={RATIO}",
        "--offset=0.7",
        *MASSES,
        *STEAM,
        "--rod-mass=90kg",
        "--centre=0.6",
        "--gyration=0.3",
    )
    keys = ("gas_pressure", "inertia_pressure", "left_pressure")
    over_angle = printed(
        "pressures", *machine, "--angle=3;41.5;250;359", "--digits=12", "-f", "csv"
    ).records()
    for row in over_angle:
        shares = (f"--shares={row['x_stroke']}", "--digits=8", "--format=csv")
        there = min(
            printed("pressures", *machine, *shares).records(),
            key=lambda one: abs((float(one["crank_angle"]) - float(row["phi"]) + 180) % 360 - 180),
        )
        assert float(there["crank_angle"]) % 360 == pytest.approx(float(row["phi"]), abs=1e-6)
        for key in keys:
            assert float(row[key]) == pytest.approx(float(there[key]), abs=1e-7)


def test_an_indicator_card_has_the_pressures_of_its_points_as_far_as_they_tell() -> None:
    card = ("--card", str(ROOT / "tests" / "cards" / "ideal-2.csv"))
    shares = ("--shares=0.005;0.25;0.6;0.9;1", "--columns=gas_pressure,left_pressure", "-f", "csv")
    measured = printed("pressures", *card, *MASSES, *shares).records()
    ideal = printed("pressures", "--eps=2", "--pressure=8bar", *MASSES, *shares).records()
    for one, other in zip(measured, ideal, strict=True):
        for key in ("gas_pressure", "left_pressure"):
            digits = len(one[key].partition(".")[2])
            assert digits >= 1
            assert float(one[key]) == pytest.approx(float(other[key]), abs=0.51 * 10**-digits + 0.001)
    turned = ("--angle=0;75;180;255", "--columns=phi,gas_pressure", "-f", "csv")
    assert [row["gas_pressure"] for row in printed("pressures", *card, *turned).records()] == ["4.000"] * 4
    wavy = (
        str(ROOT / "tests" / "cards" / "condenser.csv"),
        "--shares=0.5",
        "--columns=gas_pressure",
        "-f",
        "csv",
    )
    # 3,66 and -0,86 kp/cm² at half the stroke.
    assert [row["gas_pressure"] for row in printed("pressures", "--card", *wavy).records()] == ["4.4", "4.4"]


def test_a_pressure_that_lies_half_way_is_rounded_away() -> None:
    # 8 bar (1/(4 · 0.5) - 1/4) = 2 bar, and 5 bar of it 1.25.
    words = ("pressures", "--eps=4", "--bore=1m", "--pressure=5bar", "--shares=0.5", "--columns=gas_pressure")
    assert [row["gas_pressure"] for row in printed(*words, "--digits=1", "-f", "csv").records()] == [
        "1.3",
        "1.3",
    ]


def test_the_drawing_lays_the_masses_under_the_diagram_of_each_stroke(tmp_path: object) -> None:
    drawing = drawn(
        api.pressures, eps=4, ratio="1:5", stroke=0.6, bore=0.3, pressure=800_000, speed=2, reciprocating=300
    )
    names = [axes.get_title(loc="left") for axes in drawing.figure.axes]
    assert [name.partition(":")[0] for name in names] == ["Hingang", "Rückgang"]
    out, back = (
        [line.get_xydata() for line in axes.lines if line.get_gid() and "curve" in line.get_gid()]
        for axes in drawing.figure.axes
    )
    for steam, masses, left in (out, back):
        np.testing.assert_allclose(steam[:, 1] - masses[:, 1], left[:, 1], rtol=0, atol=1e-9)
        assert (steam[0, 0], steam[-1, 0]) == (0, 1)
    # A return stroke begins on the right; cut-off is a point of the curve.
    assert (out[0][0, 1], back[0][-1, 1]) == (6, 6)
    assert 0.25 in out[0][:, 0]
    assert 0.75 in back[0][:, 0]


# Over the developed crank circle ------------------------------------------------------------------


def test_the_work_of_the_tangential_pressure_over_the_developed_circle_is_that_on_the_piston() -> None:
    machine = (f"--ratio={RATIO}", f"--stroke={STROKE}m", f"--bore={BORE}m", *STEAM)
    words = (
        "turning",
        *machine,
        "--columns=pin_path_mm,tangential_kpa",
        "--step=0.1",
        "--digits=6",
        "-f",
        "csv",
    )
    rows = printed(*words).records()
    path, pressure = (
        np.array([float(row[key]) for row in rows]) for key in ("pin_path_mm", "tangential_kpa")
    )
    assert path[-1] == pytest.approx(np.pi * 1000 * float(STROKE), abs=1e-6)
    # Mariotte: p (1 + ln ε)/ε less the back pressure p/ε, over both strokes.
    eps = float(EPS)
    worked = 2 * 100 * float(PRESSURE) * np.log(eps) / eps * 1000 * float(STROKE)
    assert np.trapezoid(pressure, path) == pytest.approx(worked, rel=1e-6)
    radii = printed("turning", *STEAM[:1], "--angle=30;200", "--columns=pin_path", "-f", "csv").records()
    assert [row["pin_path"] for row in radii] == ["0.5236", "3.4907"]


def test_a_tangential_pressure_that_lies_half_way_is_rounded_away() -> None:
    # At 90° the piston of R:L = 3:5 has gone 2/3: 901 kPa (1/(2 · 2/3) - 1/2) = 225.25 kPa.
    steam = ("--eps=2", "--back=0.5", "--ratio=3:5", "--bore=300mm", "--pressure=9.01bar")
    words = ("turning", *steam, "--columns=tangential_kpa", "--angle=90", "--digits=1", "-f", "csv")
    assert printed(*words).records() == [{"tangential_kpa": "225.3"}]


def test_the_turning_effort_is_drawn_over_the_path_of_the_pin() -> None:
    by_angle, by_path = (
        drawn(api.turning, 4, ratio="1:5", over_path=path).figure.axes for path in (False, True)
    )
    assert [one.get_xlim() for one in by_path] == [(0, pytest.approx(2 * np.pi))] * 2
    assert by_path[-1].get_xlabel() == "Weg des Kurbelzapfens $s/R$"
    for one, other in zip(by_angle, by_path, strict=True):
        angles, path = (axes.lines[0].get_xydata() for axes in (one, other))
        np.testing.assert_allclose(np.radians(angles[:, 0]), path[:, 0], rtol=1e-12, atol=0)
        assert (angles[:, 1] == path[:, 1]).all()


@pytest.mark.parametrize(
    "drive", [("--offset=0.5",), ("--mechanism=beam", "--beam=4"), ("--offset=0",)], ids=str
)
def test_the_page_says_where_its_angles_begin(drive: tuple[str, ...]) -> None:
    words = ("pressures", "--ratio=1:5", "--bore=300mm", *drive, *STEAM)
    first = printed(*words, "--shares=0", "--columns=crank_angle", "-f", "csv").records()[0]["crank_angle"]
    page = " ".join(printed(*words, "--lang=en").out.split())
    said = f"φ from the slide direction, the inner dead centre at φᵢ = {first}°"
    assert (said in page) == (float(first) != 0)
