"""Pages of the rod's inertia: against Newton's equations of point masses, searched in mpmath for extremes."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any

import flint
import numpy as np
import pytest
from bodies import Body, Drive, Mass, Real, few, reactions, spread
from cli import printed, refusal
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp
from pages import shown

import kurbel
from kurbel.drive.crank import Crank
from kurbel.drive.rod import Rod
from kurbel.errors import KurbelError, ProblemError
from kurbel.exact.jet import Jet, ball_jets
from kurbel.kernel.rod import Masses
from kurbel.motion.bulk import columns_in_floats
from kurbel.motion.evaluation import certified, columns_in_balls, is_known
from kurbel.motion.inertia import ROD_FORCES, inertia_registry
from kurbel.motion.inertia_peak import Peak
from kurbel.page.quantity import bare
from kurbel.reading import notation
from kurbel.reading.notation import Progression
from kurbel.reading.units import Speed

# Names that tests/kernel/test_rod.py gives the forces.
NEWTON = {"guide": "guide", "pin_x": "along", "pin_y": "across", "pin": "pin", "torque": "torque"}
RAILWAY = [Mass(mp.mpf(0), mp.mpf("0.6")), Mass(mp.mpf(1), mp.mpf("0.4"))]


@pytest.fixture(autouse=True)
def digits() -> Iterator[None]:
    before = flint.ctx.prec
    flint.ctx.prec = 200
    with mp.workdps(30):
        yield
    flint.ctx.prec = before


def bodies(from_crosshead: str, gyration: str) -> dict[str, Body]:
    """Return what each model is, as point masses; Ensslin's a counts from the crosshead."""
    centre = 1 - mp.mpf(from_crosshead)
    return {
        "exact": spread(centre, mp.mpf(gyration) ** 2),
        "two-mass": [Mass(mp.mpf(0), 1 - centre), Mass(mp.mpf(1), centre)],
        "railway": RAILWAY,
    }


def key_of(force: str, model: str, unit: str = "") -> str:
    return f"inertia_{force}" + {"exact": "", "two-mass": "_two_mass", "railway": "_railway"}[model] + unit


# Over the crank angle.


def test_every_cell_is_newton_s_reaction_of_its_model() -> None:
    models = bodies("0.65", "0.35")
    keys = {key_of(force, model): (force, model) for force in NEWTON for model in models}
    for ratio, offset in (("1:5", "0"), ("1:3,5", "0.4")):
        drive = Drive(1 / mp.mpf(ratio[2:].replace(",", ".")), mp.mpf(offset))
        words = ("inertia", f"--ratio={ratio}", f"--offset={offset}", "--centre=0.65", "--gyration=0,35")
        records = printed(
            *words, "--angle=37;151;262.5", "--columns=phi," + ",".join(keys), "-f", "csv"
        ).records()
        for record in records:
            time = mp.mpf(record["phi"]) * mp.pi / 180
            for key, (force, model) in keys.items():
                true = reactions(drive, models[model], time)[NEWTON[force]]
                assert abs(mp.mpf(record[key]) - true) <= mp.mpf("0.00005"), (key, record["phi"])


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


def test_newtons_are_those_of_mass_radius_and_speed() -> None:
    keys = [key_of(force, "exact", "_nm" if force == "torque" else "_n") for force in NEWTON]
    words = (
        "inertia",
        "--centre=60%",
        "--gyration=0.48",
        "--stroke=600mm",
        "--rod=1500mm",
        "--rod-mass=0.1t",
    )
    for speed, omega in (("120/min", 4 * mp.pi), ("12.5rad/s", mp.mpf("12.5"))):
        (record,) = printed(
            *words, f"--speed={speed}", "--angle=68", "--columns=" + ",".join(keys), "-f", "csv"
        ).records()
        true = reactions(Drive(mp.mpf("0.2"), mp.mpf(0)), bodies("0.6", "0.48")["exact"], 68 * mp.pi / 180)
        for key, force in zip(keys, NEWTON.values(), strict=True):
            scale = 100 * mp.mpf("0.3") * omega**2 * (mp.mpf("0.3") if force == "torque" else 1)
            assert abs(mp.mpf(record[key]) - scale * true[force]) <= mp.mpf("0.0501"), (speed, key)


def test_centre_counts_from_the_crosshead_so_that_six_tenths_is_the_railway_rule() -> None:
    table = kurbel.inertia_table(centre=0.6, gyration=0.48, angle="25;140")
    for row in table.records.rows:
        _, _, guide, two, railway, pin, pin_two, pin_railway = row
        assert (two, pin_two) == (railway, pin_railway)
        assert guide != two
        assert pin != pin_two
    assert any("$a = 0.6 L$ vom Kreuzkopfzapfen" in note.text for note in table.notes)


def test_page_has_columns_in_newtons_if_mass_length_and_speed_are_known() -> None:
    rod: dict[str, Any] = {"centre": 0.6, "gyration": 0.48, "rod_mass": 100}
    both = kurbel.inertia_table(**rod, stroke=0.6, speed=2)
    assert [column.spanners[1] for column in both.panels[0].columns] == ["$N$ in N"] * 3 + ["$P$ in N"] * 3
    for missing in ({"rod_mass": None, "stroke": 0.6, "speed": 2}, {"stroke": 0.6}, {}):
        assert len(kurbel.inertia_table(**{**rod, **missing}).panels[0].columns) == 6
    assert "$N$ in N" not in str(kurbel.inertia_table(**rod).panels)


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


def test_caption_speaks_of_the_rod_whatever_force_is_chosen() -> None:
    own = kurbel.inertia_table(centre=0.6, gyration=0.48)
    chosen = kurbel.inertia_table(centre=0.6, gyration=0.48, columns="phi,inertia_pin_x,inertia_torque")
    assert chosen.caption == own.caption
    mixed = kurbel.inertia_table(centre=0.6, gyration=0.48, columns="phi,x,inertia_torque")
    assert mixed.caption.startswith("Kolbenweg und Drehmoment")


# 3/5 at 90°: cos ψ = 4/5, tan ψ = 3/4, p = -3/4, (1 - λ²)/cos⁴ ψ = 25/16.
@pytest.mark.parametrize(
    ("force", "model", "exact", "decimals"),
    [
        ("guide", "two-mass", "0.225", 2),
        ("guide", "exact", "0.15", 0),
        ("guide", "exact", "0.06875", 4),
        ("pin_y", "two-mass", "-0.825", 2),
        ("pin_y", "exact", "-0.66875", 4),
    ],
)
def test_ties_of_the_pages_are_proved(force: str, model: str, exact: str, decimals: int) -> None:
    # Two fifths at the crosshead pin, k² - a b = -1/10.
    crank = Crank(Fraction(3, 5), rod=Rod(Fraction(2, 5), Fraction(24, 100) - Fraction(1, 10)))
    found = [
        certified(inertia_registry()[key_of(force, model)], "exact", crank, Fraction(90), decimals, rounding)
        for rounding in ("half-away", "half-even")
    ]
    scaled = abs(Fraction(exact)) * 10**decimals
    if scaled.denominator != 2:
        assert found == [0, 0]
        return
    sign = -1 if exact.startswith("-") else 1
    below = int(scaled)
    assert found == [sign * (below + 1), sign * (below + below % 2)]


@pytest.mark.parametrize("ratio", ["1/5", "2/3", "0.99", "0"])
@pytest.mark.parametrize("offset", ["0", "0.3"])
def test_long_columns_have_the_digits_of_balls(ratio: str, offset: str) -> None:
    lam = Fraction(ratio)
    eta = Fraction(offset) if lam < Fraction(1, 2) else Fraction(0)
    rod = Rod.from_crosshead(Fraction(65, 100), Fraction(35, 100), Fraction(100))
    crank = Crank(lam, eta, Fraction(3, 10), Speed(Fraction(2)), rod=rod)
    angles = Progression(Fraction(1, 7), Fraction(73, 10), 50)
    # A rod without end has no couple in newton metres.
    known = [one for one in inertia_registry().values() if is_known(one, crank)]
    assert len(known) > 35
    columns = [bare(quantity, "exact", 9) for quantity in known]
    floats = columns_in_floats(columns, crank, angles, "half-away")
    balls = columns_in_balls(columns, crank, angles, "half-away")
    for column, one, other in zip(columns, floats, balls, strict=True):
        assert one.tolist() == other, column.quantity.key


def test_a_long_table_streams() -> None:
    words = ("inertia", "--ratio=1:4", "--centre=0.65", "--gyration=0.35", "-f", "csv")
    records = printed(*words, "--step=0.1", "--columns=phi,inertia_guide,inertia_pin").records()
    long = {record["phi"]: record for record in records}
    assert len(long) == 3601
    for record in printed(*words, "--angle=12.3;200.1", "--columns=phi,inertia_guide,inertia_pin").records():
        assert long[record["phi"]] == record


# Slopes of a kernel formula.


@few
@given(values=st.lists(st.floats(0.1, 3), min_size=3, max_size=3), time=st.floats(0.2, 3))
def test_jets_are_derivatives(values: list[float], time: float) -> None:
    one, two, three = (flint.arb(value) for value in values)

    def formula(sine: Any, cosine: Any, versine: Any, root: Callable[[Any], Any]) -> Any:
        return 1 - (one * sine + two) / root(three + versine) * cosine + 2 / (4 + sine) - (3 - cosine) * -sine

    circle = ball_jets(flint.arb(time) / flint.arb.pi())
    found = formula(*circle[:3], lambda number: number**0.5)
    assert isinstance(found, Jet)
    one, two, three = map(mp.mpf, values)

    def true(at: Real) -> Real:
        return formula(mp.sin(at), mp.cos(at), 1 - mp.cos(at), mp.sqrt)

    for order, value in enumerate((found.value, found.slope, found.bend)):
        expected = mp.diff(true, mp.mpf(time), order)
        assert abs(mp.mpf(value.mid().str(40, radius=False)) - expected) < 1e-9 * (1 + abs(expected))


# The greatest forces of a turn.


SAMPLES = 4096


def turn_of(ratio: float, offset: float, body: Body) -> dict[str, Any]:
    """Solve Newton's equations of the body at many places of a turn; accelerations by Fourier series."""
    time = np.arange(SAMPLES) * 2 * np.pi / SAMPLES
    pin = np.exp(1j * time)
    across = offset - pin.imag
    rod = np.sqrt(ratio**-2 - across**2) + 1j * across
    force, moment = np.zeros(SAMPLES, complex), np.zeros(SAMPLES)
    for share, mass, _ in ([float(part) for part in point] for point in body):
        pull = mass * second_derivative(pin + share * rod)
        force += pull
        moment += (np.conj(share * rod) * pull).imag
    guide = moment / rod.real
    push = force - 1j * guide
    return {
        "guide": guide, "pin_x": push.real, "pin_y": push.imag, "pin": abs(push),
        "torque": -(np.conj(pin) * push).imag, "vector": push,
    }  # fmt: skip


def second_derivative(places: Any) -> Any:
    orders = np.fft.fftfreq(SAMPLES, 1 / SAMPLES)
    return np.fft.ifft(-(orders**2) * np.fft.fft(places))


# From half a step beside its greatest value a sample lacks a few millionths.
NEAR = 1e-5


@pytest.mark.parametrize(("ratio", "offset"), [("0.2", "0"), ("0.3", "0.6"), ("0.75", "0")])
def test_greatest_forces_are_found_in_a_search_of_newton_s_reactions(ratio: str, offset: str) -> None:
    rod = Rod.from_crosshead(Fraction(65, 100), Fraction(35, 100))
    crank = Crank(Fraction(ratio), Fraction(offset), rod=rod)
    for model, body in bodies("0.65", "0.35").items():
        turn = turn_of(float(ratio), float(offset), body)
        for name, force in ROD_FORCES.items():
            peak, samples = Peak(force, crank, rod.masses(model, Fraction)), abs(turn[name])
            value = float(peak.value())
            assert value * (1 - NEAR) < samples.max() < value * (1 + 1e-9), (model, name)
            place = round(float(peak.degrees()) / 360 * SAMPLES) % SAMPLES
            assert value * (1 - NEAR) < samples[place] < value * (1 + 1e-9), (model, name)


# A search whose pieces grow in number like 1/√(1 - λ) looks at more than 50,000 places.
FEW_PLACES = 4000


def test_a_rod_nearly_as_long_as_the_crank_is_searched_in_few_pieces(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    rod = Rod.from_crosshead(Fraction(65, 100), Fraction(35, 100))
    crank = Crank(1 - Fraction(1, 10**7), rod=rod)
    looked: list[int] = []
    at = Peak._at

    def counted(self: Peak, *words: Any) -> Any:
        looked.append(0)
        return at(self, *words)

    monkeypatch.setattr(Peak, "_at", counted)
    drive, body = Drive(1 - mp.mpf(10) ** -7, mp.mpf(0)), bodies("0.65", "0.35")["exact"]
    with mp.workdps(60):
        # Beside 90°, where the forces are greatest, the peaks are as wide as the rod's cosine.
        beside = [reactions(drive, body, mp.pi / 2 + mp.mpf(step) / 10000) for step in range(-5, 6)]
    for name in ("guide", "torque"):
        looked.clear()
        peak = Peak(ROD_FORCES[name], crank, rod.masses("exact", Fraction))
        value, place = float(peak.value()), mp.mpf(peak.degrees().mid().str(60, radius=False))
        assert len(looked) < FEW_PLACES, name
        with mp.workdps(60):
            there = reactions(drive, body, place / 180 * mp.pi)[NEWTON[name]]
        assert abs(abs(there) / value - 1) < 1e-12, name
        assert max(abs(one[NEWTON[name]]) for one in beside) < value * (1 + 1e-12), name


@pytest.mark.parametrize("ratio", ["1:4", "1:1,5"])
def test_percents_are_those_of_a_search_of_newton_s_reactions(ratio: str) -> None:
    words = (f"--ratio={ratio}", "--centre=0.55", "--gyration=0.4", "--layout=inertia-errors", "-f", "csv")
    models = bodies("0.55", "0.4")
    lam = float(notation.ratio(ratio))
    turns = {model: turn_of(lam, 0.0, body) for model, body in models.items()}
    for record in printed("inertia", *words).records():
        if record["model"] == "exact":
            assert (record["error_percent"], record["error_phi"]) == ("", "")
            continue
        name = "vector" if record["force"] == "pin" else record["force"]
        errors = abs(turns[record["model"]][name] - turns["exact"][name])
        percent = 100 * errors.max() / abs(turns["exact"][name]).max()
        assert abs(float(record["error_percent"]) - percent) < 0.005 + 3 * NEAR * percent, record
        if record["error_phi"]:
            place = round(float(record["error_phi"]) / 360 * SAMPLES)
            assert errors[place] > errors.max() * (1 - NEAR)


@settings(max_examples=15, deadline=None)
@given(
    ratio=st.integers(1, 90), centre=st.integers(5, 95), square=st.integers(1, 60),
    offset=st.integers(-9, 9),
)  # fmt: skip
def test_two_masses_are_wrong_by_their_couple_at_right_angles(
    ratio: int, centre: int, square: int, offset: int
) -> None:
    # (k² - a b) (1 - λ²)/cos⁴ ψ is greatest at 90°: |k² - a b|/(1 - λ²), for the guide and the pin alike.
    rod = Rod(Fraction(centre, 100), Fraction(square, 100))
    masses: Masses[Any] = Masses(Fraction(0), Fraction(0), rod.couple)
    lam = Fraction(ratio, 100)
    for name in ("guide", "pin_y", "pin"):
        peak = Peak(ROD_FORCES[name], Crank(lam, rod=rod), masses)
        if not rod.couple:
            assert peak.vanishes
            continue
        assert peak.exact_degrees == 90
        assert peak.value().overlaps(
            flint.arb(1) * flint.fmpq(*(abs(rod.couple) / (1 - lam**2)).as_integer_ratio())
        )
        assert peak.separation() is not None


def test_no_error_is_left_if_k_squared_is_a_b() -> None:
    table = kurbel.inertia_table(
        centre=Fraction(9, 10), gyration=Fraction(3, 10), layout="inertia-errors",
        columns="force,model,error,error_percent,error_phi",
    )  # fmt: skip
    rows = {(force, model): rest for force, model, *rest in table.records.rows}
    for force in NEWTON:
        assert rows[force, "exact"] == [None, None, None]
        two, percent, place = rows[force, "two-mass"]
        assert (shown(two), shown(percent), place) == ("0.0000", "0.00", None)
        assert all(float(shown(value)) for value in rows[force, "railway"])


def test_forces_along_the_slide_are_the_same_for_rod_and_two_masses() -> None:
    rod: dict[str, Any] = {"centre": 0.65, "gyration": 0.35}
    columns = "inertia_pin_x,inertia_pin_x_two_mass"
    page = kurbel.inertia_table("1:3;1:∞", **rod, angle="0..180:7", columns=columns)
    rows = list(page.records.rows)
    assert all(one == other for *_, one, other in rows)
    assert len({row[-1] for row in rows}) > 20
    sheet = kurbel.inertia_table(**rod, layout="inertia-errors")
    (row,) = [row for row in sheet.records.rows if row[1:3] == ("pin_x", "two-mass")]
    assert shown(row[-2]) == "0.00"


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


def test_nothing_is_divided_by_a_force_that_is_zero() -> None:
    # Of an infinite rod with k² = a b no force is at the guide.
    table = kurbel.inertia_table("1:∞", centre=0.9, gyration=0.3, layout="inertia-errors")
    rows = {row[1:3]: row[3:] for row in table.records.rows}
    for model in ("exact", "railway"):
        assert list(map(shown, rows["guide", model])) == ["0.0000", "None", "None", "None"]


def test_a_mass_that_only_rotates_presses_alike_everywhere() -> None:
    table = kurbel.inertia_table("1:5", centre=1, gyration=0.4, layout="inertia-errors")
    rows = {row[1:3]: list(map(shown, row[3:5])) for row in table.records.rows}
    assert rows["pin", "two-mass"] == ["1.0000", "None"]
    # Of an infinite rod with k² - a b = a the force at the pin turns with constant magnitude.
    rod = Rod(Fraction(1, 8), Fraction(15, 64))
    assert rod.couple == rod.centre
    peak = Peak(ROD_FORCES["pin"], Crank(Fraction(0), rod=rod), rod.masses("exact", Fraction))
    assert peak.is_level
    assert not peak.vanishes
    assert peak.value().overlaps(flint.arb(1))


def test_a_flat_top_at_the_dead_centre_is_settled() -> None:
    # X is 3/7 (cos φ + ...) with X'' = 0 at 180° for λ = 1/3, b = 9/11 of the mass at the crosshead.
    rod = Rod(Fraction(9, 11), Fraction(1, 5))
    crank = Crank(Fraction(1, 3), rod=rod)
    peak = Peak(ROD_FORCES["pin_x"], crank, rod.masses("exact", Fraction))
    assert peak.exact_degrees == 0
    assert peak.value().overlaps(flint.arb(1) + flint.arb(flint.fmpq(3, 11)))


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
    assert "the rod's length is not known" in refusal("inertia", f"--rod-file={path}", code=1)
    said = refusal("inertia", f"--rod-file={path}", *lengths, "--rod-mass=5kg")
    assert said == "the rod's file has its mass in kg; leave the mass out"


GIVEN = ("--centre=0.6", "--gyration=0.4")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ((), "the rod's masses are not known; give its centre and its gyration, such as --centre 0.6"),
        (("--centre=0.6",), "the rod's masses are not known; give its centre and its gyration"),
        (("--rod-file=x.csv", "--centre=0.6"), "the rod's file has its masses; leave centre"),
        (("--centre=1.2", "--gyration=0.4"), "the rod's centre of mass is 1.2 L from the crosshead pin; it"),
        (("--centre=x", "--gyration=0.4"), 'centre of mass "x" is not a number'),
        (("--centre=0.5", "--gyration=0"), "the rod's radius of gyration k is 0 L; it must be above 0"),
        (
            ("--centre=0.5", "--gyration=2"),
            "the rod's k² is 4 L²; with the centre of mass 0.5 L from the crank",
        ),
        ((*GIVEN, "--rod-mass=3m"), 'rod mass "3m" is in meter; it must be a mass such as 200kg'),
        ((*GIVEN, "--rod-mass=0kg"), 'rod mass "0kg" is out of range; it must be above 0'),
        (
            (*GIVEN, "--columns=inertia_pin_n"),
            "column inertia_pin_n is in N and needs --rod-mass and --stroke and",
        ),
        (
            (*GIVEN, "--layout=kinematics"),
            "layout kinematics is about something else; choose from ensslin-forces, ",
        ),
        (
            (*GIVEN, "--layout=inertia-errors", "--step=5"),
            "layout inertia-errors is of the whole turn; leave --st",
        ),
        (
            (*GIVEN, "--layout=inertia-errors", "--columns=x"),
            'there is no column "x"; choose from ratio, force',
        ),
        (
            (*GIVEN, "--layout=inertia-errors", "--columns=greatest_n"),
            "column greatest_n is in N, N m and needs --rod-mass and --stroke and --speed",
        ),
        (
            (*GIVEN, "--layout=inertia-errors", "--columns=ratio"),
            "there is no column beside the axes; add one",
        ),
        ((*GIVEN, "--speed=120/min"), "a speed needs a length to give m/s; add --stroke"),
    ],
)
def test_wrong_input_is_answered_with_a_sentence(words: tuple[str, ...], said: str) -> None:
    assert refusal("inertia", *words).startswith(said)


def test_forces_of_the_rod_are_on_its_own_pages_only() -> None:
    assert refusal("table", "--layout=inertia").startswith(
        "layout inertia is about something else; choose from"
    )
    assert refusal("table", "--columns=inertia_guide").startswith('there is no column "inertia_guide"')
    with pytest.raises(KurbelError, match=r"^layout inertia is about something else"):
        kurbel.table(layout="inertia")
    with pytest.raises(
        ProblemError, match=r"^layout inertia-errors is of the whole turn; leave --angle out$"
    ):
        kurbel.inertia_table(centre=0.6, gyration=0.4, layout="inertia-errors", angle=10)
