"""Pages of the rod's inertia: against Newton and Euler, and searched for extremes."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from math import isqrt
from pathlib import Path
from time import process_time
from typing import Any

import flint
import numpy as np
import pytest
from cli import printed, records
from drives import ARCS, BEAMS, Drive, slide
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp
from pages import shown

import kurbel
from kurbel import verify
from kurbel.exact.search import Jet, ball_jets

FORCES = ("guide", "pin_x", "pin_y", "pin", "torque")
MODELS = {"exact": "", "two-mass": "_two_mass", "railway": "_railway"}


@pytest.fixture(autouse=True)
def digits() -> Iterator[None]:
    with mp.workdps(30), flint.ctx.workprec(200):
        yield


def square_root(number: Fraction) -> Fraction:
    """Return it to 60 figures."""
    return Fraction(isqrt(int(number * 10**120)), 10**60)


def newton(drive: verify.Drive, a: str, k: str, mass: str = "1") -> dict[str, verify.Bodies]:
    """Return the rod of each model: two masses at the pins have k² = a b, in the railway rule a = 6/10."""
    centre, rule = Fraction(a), Fraction(6, 10)
    rods = {"exact": (centre, Fraction(k)), "two-mass": (centre, square_root(centre * (1 - centre)))}
    rods["railway"] = rule, square_root(rule * (1 - rule))
    return {
        model: verify.bodies(drive, rod_mass=mass, centre=share, gyration=gyration)
        for model, (share, gyration) in rods.items()
    }


def reaction(heavy: verify.Bodies, force: str, degrees: Fraction | str) -> verify.Value:
    """Return the force of the guide on B, that of the crank pin on A, or the torque that the rod gives."""
    names = {"guide": "guide_force_n", "pin": "crank_pin_force_n", "torque": "torque_nm"}
    if key := {**names, "resultant": "rod_inertia_n", "arm": "rod_arm_n"}.get(force):
        return heavy.value(key, degrees)
    if force == "pin_x":
        return heavy.value("bearing_along_n", degrees)
    return -heavy.value("bearing_across_n", degrees)


# Over the crank angle.


@pytest.mark.parametrize("drive", [slide("1:5"), slide("2:7", "0.4"), ARCS[2], ARCS[8], BEAMS[0]], ids=str)
def test_every_cell_is_the_reaction_of_its_model(drive: Drive) -> None:
    keys = {f"inertia_{force}{end}": (force, model) for force in FORCES for model, end in MODELS.items()}
    asked = ("--centre=0.65", "--gyration=0,35", "--angle=37;151;262.5", f"--columns=phi,{','.join(keys)}")
    heavy = newton(drive.true, "0.65", "0.35")
    for row in records("inertia", *drive.words, *asked, "--digits=12"):
        for key, (force, model) in keys.items():
            true = reaction(heavy[model], force, row["phi"])
            assert true.confirms(row[key]) == verify.CONFIRMED, (key, row["phi"])


def test_the_parts_of_the_acceleration_make_up_that_of_the_crank_pin() -> None:
    rod = ("--ratio=1:3", "--centre=0.6", "--gyration=0.4", "--offset=0.3")
    words = ("inertia", *rod, "--step=17", "--digits=20")
    keys = [f"{part}_acceleration" for part in ("common", "turning", "stretching")]
    records = printed(*words, "--columns=phi," + ",".join(keys), "-f", "csv").records()
    assert len(records) == 22
    with mp.workdps(30):
        for record in records:
            phi, common, turning, stretching = (mp.mpf(record[key]) for key in ("phi", *keys))
            phi = mp.radians(phi)
            psi = mp.asin((mp.sin(phi) - mp.mpf("0.3")) / 3)
            # The pin runs on a circle: its acceleration is R ω² towards the shaft.
            assert mp.almosteq(mp.cos(phi), -_along(common, turning, stretching, psi), abs_eps=1e-18)
            assert mp.almosteq(mp.sin(phi), -_across(turning, stretching, psi), abs_eps=1e-18)


def _along(common: Any, turning: Any, stretching: Any, psi: Any) -> Any:
    """X of the acceleration of the pin: p₂ against X, p₄ square to the rod against Y, p₅ along it."""
    return -common - turning * mp.sin(psi) + stretching * mp.cos(psi)


def _across(turning: Any, stretching: Any, psi: Any) -> Any:
    return -turning * mp.cos(psi) - stretching * mp.sin(psi)


@pytest.mark.parametrize(("speed", "omega", "turns"), [("120/min", "2", True), ("12.5rad/s", "12.5", False)])
def test_newtons_are_those_of_mass_radius_and_speed(speed: str, omega: str, turns: bool) -> None:
    size = ("--stroke=600mm", "--rod=1500mm", "--rod-mass=0.1t", f"--speed={speed}", "--angle=68")
    keys = {f"inertia_{one}_{'nm' if one == 'torque' else 'n'}": one for one in (*FORCES, "resultant")}
    keys["inertia_arm"] = "arm"
    drive = slide("1:5", radius="0.3", speed=omega, turns=turns).true
    heavy = newton(drive, "0.6", "0.48", "100")["exact"]
    asked = ("--centre=60%", "--gyration=0.48", "--digits=6", f"--columns={','.join(keys)}")
    (row,) = records("inertia", *size, *asked)
    for key, force in keys.items():
        assert reaction(heavy, force, "68").confirms(row[key]) == verify.CONFIRMED, key


@pytest.mark.parametrize("ratio", ["1:5", "1:4;1:3"])
def test_the_page_says_the_greatest_errors_of_what_it_shows(ratio: str) -> None:
    rod = ("--centre=0.7", "--gyration=0.4", f"--ratio={ratio}")
    columns = "--columns=ratio,force,model,error_percent"
    sheet = printed("inertia", *rod, "--layout=inertia-errors", columns, "-f", "csv").records()
    of = {(one["ratio"], one["force"], one["model"]): one["error_percent"] for one in sheet}
    said = " ".join(printed("inertia", *rod, "--angle=30", "--lang=en").out.split())
    for each in ratio.split(";"):
        where = f" for R:L = {each}" if ";" in ratio else ""
        guide, pin = (
            [of[each, force, model] for model in ("two-mass", "railway")] for force in ("guide", "pin")
        )
        assert len({*guide, *pin}) == 4
        assert (
            f"greatest error in % of the greatest exact force of the turn{where}:"
            f" two masses N {guide[0]}, P {pin[0]}; 6/10, 4/10 N {guide[1]}, P {pin[1]}"
        ) in said
    alone = printed("inertia", *rod, "--angle=30", "--lang=en", "--columns=phi,inertia_guide").out
    assert "greatest error" not in alone


# Places from A and masses. 3/5 at 90°: cos ψ = 4/5, tan ψ = 3/4, p = -3/4, (1 - λ²)/cos⁴ ψ = 25/16.
# m_B is 2/5 and k² - a b = -1/10: 0.225, 0.15, 0.06875, -0.825, -0.66875.
TENTH = "0,21 0.4,25 1,14"
# m_B is 2/5 and k² - a b = -0.128: 0.225 - 0.2 and -0.825 + 0.2.
EIGHTH = "0,29 0.6,40 1,6"
# All of it about B, k² = 0.28: 3/4 along and -9/16 - 7/16 across.
ABOUT_B = "-0.5,7 1,47 1.5,21"


@pytest.mark.parametrize(
    ("rod", "key", "digits", "away", "even"),
    [
        (TENTH, "guide_two_mass", 2, "0.23", "0.22"),
        (TENTH, "guide", 0, "0", "0"),
        (TENTH, "guide", 4, "0.0688", "0.0688"),
        (TENTH, "pin_y_two_mass", 2, "-0.83", "-0.82"),
        (TENTH, "pin_y", 4, "-0.6688", "-0.6688"),
        (EIGHTH, "guide", 2, "0.03", "0.02"),
        (EIGHTH, "pin_y", 2, "-0.63", "-0.62"),
        (ABOUT_B, "pin", 1, "1.3", "1.2"),
    ],
)
def test_ties_of_the_pages_are_proved(
    rod: str, key: str, digits: int, away: str, even: str, tmp_path: Path
) -> None:
    path = tmp_path / "rod.csv"
    path.write_text("position,mass\n" + rod.replace(" ", "\n") + "\n", encoding="utf-8")
    about = ("--ratio=3:5", f"--rod-file={path}", "--angle=90", f"--digits={digits}")
    for rounding, expected in (("half-away", away), ("half-even", even)):
        asked = (*about, f"--columns=inertia_{key}", f"--rounding={rounding}")
        assert records("inertia", *asked) == [{f"inertia_{key}": expected}]


# Slopes of a kernel formula.


@settings(max_examples=15, deadline=None)
@given(values=st.lists(st.floats(0.1, 3), min_size=3, max_size=3), time=st.floats(0.2, 3))
def test_jets_are_derivatives(values: list[float], time: float) -> None:
    one, two, three = (flint.arb(value) for value in values)

    def formula(sine: Any, cosine: Any, versine: Any, root: Callable[[Any], Any]) -> Any:
        return 1 - (one * sine + two) / root(three + versine) * cosine + 2 / (4 + sine) - (3 - cosine) * -sine

    found = formula(*ball_jets(flint.arb(time) / flint.arb.pi())[:3], lambda number: number**0.5)
    assert isinstance(found, Jet)
    one, two, three = map(mp.mpf, values)

    def true(at: Any) -> Any:
        return formula(mp.sin(at), mp.cos(at), 1 - mp.cos(at), mp.sqrt)

    for order, value in enumerate((found.value, found.slope, found.bend)):
        expected = mp.diff(true, mp.mpf(time), order)
        assert abs(mp.mpf(value.mid().str(40, radius=False)) - expected) < 1e-9 * (1 + abs(expected))


# The greatest forces of a turn.


SAMPLES = 4096


def turn_of(ratio: float, offset: float, centre: float, gyration: float) -> dict[str, Any]:
    """Solve Newton's equations of two point masses all round a turn; accelerations by Fourier series."""
    time = np.arange(SAMPLES) * 2 * np.pi / SAMPLES
    pin = np.exp(1j * time)
    across = offset - pin.imag
    rod = np.sqrt(ratio**-2 - across**2) + 1j * across
    force, moment = np.zeros(SAMPLES, complex), np.zeros(SAMPLES)
    for share in (1 - centre + gyration, 1 - centre - gyration):
        pull = second_derivative(pin + share * rod) / 2
        force += pull
        moment += (np.conj(share * rod) * pull).imag
    guide = moment / rod.real
    push = force - 1j * guide
    return {
        "guide": guide, "pin_x": push.real, "pin_y": push.imag, "pin": abs(push),
        "torque": -(np.conj(pin) * push).imag, "vector": push,
    }  # fmt: skip


def second_derivative(places: Any) -> Any:
    return np.fft.ifft(-(np.fft.fftfreq(SAMPLES, 1 / SAMPLES) ** 2) * np.fft.fft(places))


# From half a step beside its greatest value a sample lacks a few millionths.
NEAR = 1e-5


def errors(*words: str) -> dict[tuple[str, str], dict[str, str]]:
    columns = "force,model,greatest,greatest_phi,error,error_percent,error_phi"
    rows = records("inertia", *words, "--layout=inertia-errors", f"--columns={columns}")
    return {(row["force"], row["model"]): row for row in rows}


@pytest.mark.parametrize(("ratio", "offset"), [("0.2", "0"), ("0.3", "0.6"), ("0.75", "0")])
def test_greatest_forces_and_errors_are_those_of_a_search_of_newton_s_reactions(
    ratio: str, offset: str
) -> None:
    about = (f"--ratio={ratio}", f"--offset={offset}", "--centre=0.65", "--gyration=0.35", "--digits=9")
    turns = {
        model: turn_of(float(ratio), float(offset), centre, (second - centre**2) ** 0.5)
        for model, heavy in newton(slide(ratio).true, "0.65", "0.35").items()
        for _, centre, second in [[float(one / heavy.moments[0]) for one in heavy.moments]]
    }
    for (force, model), row in errors(*about).items():
        samples, value = abs(turns[model][force]), float(row["greatest"])
        assert value * (1 - NEAR) < samples.max() < value * (1 + 1e-8), (model, force)
        if row["greatest_phi"]:
            assert samples[place_of(row["greatest_phi"])] > value * (1 - NEAR), (model, force)
        if model == "exact":
            assert row["error"] == row["error_percent"] == row["error_phi"] == ""
            continue
        name = "vector" if force == "pin" else force
        missed = abs(turns[model][name] - turns["exact"][name])
        percent = 100 * missed.max() / abs(turns["exact"][name]).max()
        assert float(row["error"]) == pytest.approx(missed.max(), rel=NEAR, abs=1e-8), (model, force)
        assert float(row["error_percent"]) == pytest.approx(percent, rel=3 * NEAR, abs=0.0051), (model, force)
        if row["error_phi"]:
            assert missed[place_of(row["error_phi"])] > missed.max() * (1 - NEAR), (model, force)


def place_of(degrees: str) -> int:
    return round(float(degrees) / 360 * SAMPLES) % SAMPLES


def test_a_rod_nearly_as_long_as_the_crank_is_searched_in_few_pieces() -> None:
    heavy = newton(slide("0.9999999").true, "0.65", "0.35")["exact"]
    begun = process_time()
    found = errors("--ratio=0.9999999", "--centre=0.65", "--gyration=0.35", "--digits=30")
    # Pieces that grow in number like 1/√(1 - λ) take a minute.
    assert process_time() - begun < 10
    for name in ("guide", "torque"):
        row = found[name, "exact"]
        value = float(row["greatest"])
        assert abs(float(reaction(heavy, name, row["greatest_phi"]))) == pytest.approx(value, rel=1e-12), name
        # Beside 90°, where the forces are greatest, the peaks are as wide as the rod's cosine.
        beside = [90 + Fraction(step, 175) for step in range(-5, 6)]
        assert all(abs(float(reaction(heavy, name, at))) < value * (1 + 1e-12) for at in beside), name


@pytest.mark.parametrize(
    ("ratio", "centre", "gyration"), [("0.2", "0.6", "0.48"), ("0.85", "0.3", "0.6"), ("0.01", "0.95", "0.3")]
)
def test_two_masses_are_wrong_by_their_couple_at_right_angles(ratio: str, centre: str, gyration: str) -> None:
    # (k² - a b) (1 - λ²)/cos⁴ ψ is greatest at 90°: |k² - a b|/(1 - λ²), for the guide and the pin alike.
    found = errors(f"--ratio={ratio}", f"--centre={centre}", f"--gyration={gyration}", "--digits=20")
    lam, a, k = (Fraction(one) for one in (ratio, centre, gyration))
    for name in ("guide", "pin_y", "pin"):
        row = found[name, "two-mass"]
        assert abs(Fraction(row["error"]) - abs(k**2 - a * (1 - a)) / (1 - lam**2)) <= Fraction(1, 2 * 10**20)
        assert float(row["error_phi"]) == 90


def test_no_error_is_left_if_k_squared_is_a_b() -> None:
    table = kurbel.inertia(
        centre=Fraction(9, 10), gyration=Fraction(3, 10), layout="inertia-errors",
        columns="force,model,error,error_percent,error_phi",
    )  # fmt: skip
    rows = {(force, model): rest for force, model, *rest in table.records.rows}
    for force in FORCES:
        assert rows[force, "exact"] == [None, None, None]
        two, percent, place = rows[force, "two-mass"]
        assert (shown(two), shown(percent), place) == ("0.0000", "0.00", None)
        assert all(float(shown(value)) for value in rows[force, "railway"])


def test_a_tie_of_the_greatest_force_is_proved() -> None:
    # At the dead centre X is 1 + λ b; here 1.0625. The couple's greatest error is 0.0096/0.96.
    for rounding, expected in (("half-away", "1.063"), ("half-even", "1.062")):
        words = ("--ratio=1:4", "--centre=0.75", "--gyration=0.3", "--digits=3", f"--rounding={rounding}")
        records = printed("inertia", *words, "--layout=inertia-errors", "-f", "csv").records()
        assert [row["greatest"] for row in records if row["force"] == "pin_x"][:2] == [expected] * 2
    round_numbers = ("--centre=0.6", "--gyration=0.48", "--digits=30", "--columns=force,model,error")
    records = printed("inertia", *round_numbers, "--layout=inertia-errors", "-f", "csv").records()
    guide = [row["error"] for row in records if row["force"] == "guide"]
    assert guide == ["", "0.01" + 28 * "0", "0.01" + 28 * "0"]


def test_an_infinite_rod_has_its_greatest_torque_at_45_degrees() -> None:
    # -(b - (k² - a b)) sin φ cos φ and, of two masses, -b sin φ cos φ.
    words = ("--ratio=1:∞", "--centre=0.65", "--gyration=0.35", "--layout=inertia-errors", "-f", "csv")
    records = {(row["force"], row["model"]): row for row in printed("inertia", *words).records()}
    assert records["torque", "exact"]["greatest"] == "0.2275"
    assert records["torque", "two-mass"]["greatest"] == "0.1750"
    assert records["torque", "exact"]["greatest_phi"] == "45.0000"
    assert records["guide", "two-mass"]["greatest"] == "0.0000"
    assert records["guide", "two-mass"]["greatest_phi"] == ""
    assert records["guide", "two-mass"]["error_percent"] == "100.00"
    # With k² = a b no force is at the guide, and nothing is divided by it.
    table = kurbel.inertia("1:∞", centre=0.9, gyration=0.3, layout="inertia-errors")
    guide = next(row[3:] for row in table.records.rows if row[1:3] == ("guide", "exact"))
    assert [*map(shown, guide)] == ["0.0000", "None", "None", "None"]


def test_a_mass_that_only_rotates_presses_alike_everywhere() -> None:
    row = errors("--ratio=1:5", "--centre=1", "--gyration=0.4")["pin", "two-mass"]
    assert (row["greatest"], row["greatest_phi"]) == ("1.0000", "")
    # Of an infinite rod with k² - a b = a the force at the pin turns with constant magnitude.
    row = errors("--ratio=1:∞", "--centre=0.6", "--gyration=0.8", "--digits=20")["pin", "exact"]
    assert row["greatest_phi"] == ""
    assert row["greatest"] == "1." + 20 * "0"


def test_a_flat_top_at_the_dead_centre_is_settled() -> None:
    # X is 3/7 (cos φ + ...) with X'' = 0 at 180° for λ = 1/3, b = 9/11 of the mass at the crosshead.
    row = errors("--ratio=1:3", "--centre=2/11", "--gyration=0.4", "--digits=20")["pin_x", "exact"]
    assert float(row["greatest_phi"]) == 0
    assert abs(Fraction(row["greatest"]) - Fraction(14, 11)) <= Fraction(1, 2 * 10**20)


# The rod as it is given.


def test_a_rod_file_gives_the_page_of_its_centre_and_gyration(tmp_path: Path) -> None:
    path = tmp_path / "rod.csv"
    path.write_text("position,mass\n0,13\n1,7\n", encoding="utf-8")
    words = ("inertia", "--ratio=1:4", "-f", "csv", "--columns=phi,inertia_guide,inertia_guide_two_mass")
    records = printed(*words, f"--rod-file={path}").records()
    for record in records:
        assert record["inertia_guide"] == record["inertia_guide_two_mass"]
    two = printed(*words, "--centre=0.65", "--gyration=0.3").records()
    column = "inertia_guide_two_mass"
    assert [record[column] for record in records] == [record[column] for record in two]


def test_a_rod_file_in_lengths_takes_the_length_of_the_rod(tmp_path: Path) -> None:
    path = tmp_path / "rod.csv"
    path.write_text("position [mm];mass [kg]\n0;60\n1500;40\n", encoding="utf-8")
    lengths = ("--stroke=600mm", "--rod=1500mm", "--speed=120/min")
    out = printed("inertia", f"--rod-file={path}", *lengths, "--lang=en").out
    assert "M = 100 kg" in out
    assert "a = 0.6 L from the crosshead pin" in out
    assert "N in N" in out


def test_several_rods_on_a_page_are_those_of_their_own_pages() -> None:
    rods = {"centre": ("0.62", "0.7"), "gyration": ("0.31", "0.34")}
    for layout in ("inertia", "inertia-errors"):
        words = ("inertia", "--ratio=1:4", f"--layout={layout}")
        both = records(*words, *(f"--{name}={';'.join(values)}" for name, values in rods.items()))
        for place in (0, 1):
            own = records(*words, *(f"--{name}={values[place]}" for name, values in rods.items()))
            found = [{**row, "ratio": "1:4"} for row in both if row["rod"] == str(place + 1)]
            assert found == [{**row, "rod": str(place + 1)} for row in own]
