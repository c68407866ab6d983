"""`kurbel power`: mean pressures by quadrature of the card, powers and sizes by arithmetic of this file."""

from __future__ import annotations

from math import log, pi
from pathlib import Path
from pickle import dumps, loads

import pytest
from cli import kurbel, printed, refusal
from mpmath import mpf, nstr, workdps
from scipy.integrate import quad

from kurbel import power as typed_power
from kurbel import typeset

STEAM = ("--pressure=8bar", "--back=1.1bar", "--clearance=8%")
SIZES = ("--bore=300mm", "--stroke=450mm", "--speed=200/min")


def record(*words: str) -> dict[str, float]:
    (row,) = printed("power", *words, "--digits=9", "-f", "csv").records()
    # The first column is of what acts on the piston.
    return {key: float(value) for key, value in [*row.items()][1:]}


def test_the_exhaust_pressure_of_an_otto_cycle_is_a_pressure() -> None:
    words = ("--compression=6", "--peak-pressure=34.5bar")
    own, exhaust = (
        record(*words, "--suction-pressure=1.03bar", *more)["mean_pressure"]
        for more in ((), ("--exhaust-pressure=1.2bar",))
    )
    assert own - exhaust == pytest.approx(1.2 - 1.03, abs=2e-9)
    said = "the peak pressure 34.5bar is compared with the suction pressure; add --suction-pressure"
    assert refusal("power", *words) == said


def test_the_diagram_factor_is_found_from_the_power() -> None:
    mean = (10 * (1 + log(6)) / 6 - 0.55) * 1e5
    steam = ("--eps=6", "--pressure=10bar", "--back=0.55bar", "--unknown=diagram_factor")
    sizes = ("--bore=250mm", "--speed=210/min")
    factor = 45e3 / (2 * 3.5 * pi / 4 * 0.25**2 * 0.375 * mean)
    found = record(*steam, *sizes, "--stroke=375mm", "--power=45kW")
    assert found["diagram_factor"] == pytest.approx(factor, abs=1e-9)
    assert found["mean_pressure"] == pytest.approx(factor * mean / 1e5, abs=1e-9)
    brake = record(*steam, *sizes, "--stroke-bore=1.5", "--brake-power=36kW", "--efficiency=80%")
    assert brake["diagram_factor"] == found["diagram_factor"]
    assert refusal("power", *steam, *sizes, "--power=45kW").endswith("and pressure; add --stroke")
    assert "makes an indicated power of 52.868 kW, less than the 53 kW that are given" in refusal(
        "power", *steam, *sizes, "--stroke=375mm", "--power=53kW"
    )


def test_power_and_steam_of_a_double_acting_engine() -> None:
    mean = 0.8 * (8 * (1 / 3 + (1 / 3 + 0.08) * log(1.08 / (1 / 3 + 0.08))) - 1.1)
    swept, turns = pi / 4 * 0.3**2 * 0.45, 200 / 60
    watts = 2 * turns * swept * mean * 1e5
    # The clearance keeps steam of 1.1 bar, by Mariotte's law.
    steam = 2 * turns * swept * (1 / 3 + 0.08 * (1 - 1.1 / 8)) / 0.24
    words = ("--eps=3", *STEAM, *SIZES, "--diagram-factor=0.8", "--efficiency=85%")
    found = record(*words, "--specific-volume=0.24 m3/kg")
    expected = {
        "indicated_power": watts / 1000, "brake_power": 0.85 * watts / 1000, "piston_speed": 2 * 0.45 * turns,
        "mean_torque": 0.85 * watts / (2 * pi * turns), "brake_pressure": 0.85 * mean, "steam": 3600 * steam,
        "steam_per_kwh": 3.6e6 * steam / watts, "steam_per_brake_kwh": 3.6e6 * steam / watts / 0.85,
    }  # fmt: skip
    assert {key: found[key] for key in expected} == pytest.approx(expected, rel=1e-8)
    assert record(*words, f"--specific-volume={1 / 0.24:.20f} kg/m3")["steam"] == pytest.approx(
        found["steam"]
    )


def test_a_rod_lessens_the_area_of_its_end() -> None:
    words = ("--mean-pressure=4bar", "--working-strokes=2", *SIZES)
    found = record(*words, "--piston-rod=60mm", "--tail-rod=45mm")
    areas = pi / 4 * (0.3**2 - 0.06**2) + pi / 4 * (0.3**2 - 0.045**2)
    assert found["indicated_power"] == pytest.approx(4e5 * areas * 0.45 * 200 / 60 / 1000, rel=1e-8)
    said = refusal("power", words[0], "--working-strokes=1", *SIZES, "--piston-rod=60mm")
    assert "lessen the area of an end of a double-acting piston" in said


def test_of_driven_machines_the_shaft_has_more_to_give() -> None:
    sizes = ("--suction-pressure=-0.3bar", "--delivery-pressure=5bar", *SIZES, "--efficiency=80%")
    found = record("--pump", *sizes)
    flow = 2 * pi / 4 * 0.3**2 * 0.45 * 200
    assert found["delivery"] == pytest.approx(flow, rel=1e-8)
    assert found["brake_power"] == pytest.approx(5.3e5 * flow / 60 / 800, rel=1e-8)


def test_a_card_gives_its_power_with_the_digits_that_it_has(tmp_path: Path) -> None:
    # Straight lines: 6 bar falls to 2 bar, against 1 bar.
    lines = [f"{at / 20:.2f},{6 - at / 5:.2f},1.00" for at in range(21)]
    path = tmp_path / "card.csv"
    path.write_text("position,p_forward [bar],p_return [bar]\n" + "\n".join(lines) + "\n", encoding="utf-8")
    (row,) = printed("power", f"--card={path}", *SIZES, "-f", "csv").records()
    watts = 2 * pi / 4 * 0.3**2 * 0.45 * 200 / 60 * 3e5
    for key, value in (("mean_pressure", 3.0), ("indicated_power", watts / 1000)):
        assert abs(float(row[key]) - value) <= 0.51 * 10 ** -len(row[key].partition(".")[2])
        assert len(row[key].replace(".", "")) == 2


@pytest.mark.parametrize(("rounding", "printed_power"), [("half-away", "0.563"), ("half-even", "0.562")])
def test_a_power_half_way_between_two_figures_is_one(rounding: str, printed_power: str) -> None:
    # π of the area and π of the speed cancel: 2 · 5 bar · d² S ω/8 = 562.5 W.
    words = ("--eps=1", "--pressure=10bar", "--back=0.5", "--bore=100mm", "--stroke=50mm", "--speed=9rad/s")
    row = printed(
        "power", *words, "--columns=indicated_power", "--digits=3", f"--rounding={rounding}", "-f", "csv"
    )
    assert row.records() == [{"indicated_power": printed_power}]


def test_a_machine_says_what_it_knows(tmp_path: Path) -> None:
    assert kurbel("power", "--machine=examples/engine.toml").code == 0
    path = tmp_path / "engine.toml"
    path.write_text(
        '[crank]\nratio = "1:5"\nstroke = "450mm"\nspeed = "200/min"\nefficiency = "85%"\n[steam]\neps = 3\n'
        'bore = "300mm"\npressure = "8bar"\nback = "1.1bar"\nclearance = "8%"\ndiagram_factor = 0.8\n'
        'specific_volume = "0.24 m3/kg"\n',
        encoding="utf-8",
    )
    words = ("--eps=3", *STEAM, *SIZES, "--diagram-factor=0.8", "--efficiency=85%")
    typed = printed("power", *words, "--specific-volume=0.24 m3/kg").out
    assert printed("power", f"--machine={path}").out == typed


@pytest.mark.parametrize("way", ["work", "load", "250mm"])
def test_the_cylinders_of_a_compound_engine_part_the_diagram_at_the_receiver(way: str) -> None:
    words = ("--eps=12", "--pressure=15bar", "--back=0.25bar", "--bore=400mm")
    found = record(*words, "--stroke=600mm", "--speed=2/s", f"--compound={way}")
    volume, level = found["low_cut_off"], found["receiver_pressure"]
    assert level * volume == pytest.approx(15 / 12)
    assert (found["high_bore"] / 400) ** 2 == pytest.approx(volume)
    high = 15 / 12 + quad(lambda share: 15 / 12 / share, 1 / 12, volume)[0] - level * volume
    low = level * volume + quad(lambda share: 15 / 12 / share, volume, 1)[0] - 0.25
    assert found["high_power"] / found["low_power"] == pytest.approx(high / low)
    assert high + low == pytest.approx(found["mean_pressure"])
    loads = (15 - level) * volume, level - 0.25
    parts = {"work": high / low, "load": loads[0] / loads[1], "250mm": found["high_bore"] / 250}
    assert parts[way] == pytest.approx(1)


def test_a_back_pressure_is_its_share_of_the_steam_pressure() -> None:
    for words in (("delta",), ("forces", "--step=90"), ("solve", "--where=torque=max")):
        share = printed(*words, "--eps=3", "--back=0.15", "-f", "csv").out
        assert printed(*words, "--eps=3", "--back=1.2bar", "--pressure=8bar", "-f", "csv").out == share


MACHINE = """
crank = {ratio = "1:4", stroke = "450mm", speed = "200/min"}
%s
flywheel = {delta = "1:100"}
"""
HEAT = 12 * (1 - 6**-0.4)


@pytest.mark.parametrize(
    ("load", "options", "joules"),
    [
        # In a turn, of the swept volume in m³.
        (
            'steam = {eps = 3, pressure = "8bar", back = "1.1bar", bore = "300mm"}',
            ("--piston-rod=60mm",),
            2 * (8e5 * (1 + log(3)) / 3 - 1.1e5) * (1 - (60 / 300) ** 2 / 2),
        ),
        (
            'gas = {compression = 6, heat = 12, suction_pressure = "0.9bar", bore = "300mm"}',
            ("--cranks=0;120;240",),
            3 / 2 * HEAT * 0.9e5 / (1 - 1 / 6),
        ),
        ('pump = {kind = "single", delivery_pressure = "6bar", bore = "300mm"}', (), 6e5),
    ],
)
def test_a_flywheel_takes_the_power_of_its_engine(
    load: str, options: tuple[str, ...], joules: float, tmp_path: Path
) -> None:
    machine = tmp_path / "engine.toml"
    machine.write_text(MACHINE % load, encoding="utf-8")
    words = (f"--machine={machine}", *options)
    power = joules * pi / 4 * 0.3**2 * 0.45 * 200 / 60
    assert record(*words)["indicated_power"] == pytest.approx(power / 1e3, abs=1e-9)
    (row,) = printed("flywheel", *words, "--columns=power,mean_torque", "--digits=6", "-f", "csv").records()
    assert float(row["power"]) == pytest.approx(power, abs=1e-6)
    assert float(row["mean_torque"]) == pytest.approx(power / (2 * pi * 200 / 60), abs=1e-6)
    assert "r = 225 mm" in printed("flywheel", *words).out


def test_the_work_of_a_turn_with_cushioned_steam_is_that_of_its_card() -> None:
    # The mean tangential force times 2 π, by quadrature of the torque over the angle.
    steam = ("--eps=3", "--back=0.14", "--clearance=8%", "--release=90%", "--cushion=80%", "--lead=1%")
    rows = printed(
        "forces", *steam, "--exponent=1.2", "--ratio=1:5", "--angle=0.5..359.5", "--digits=9",
        "--columns=tangential_force", "-f", "csv",
    ).records()  # fmt: skip
    assert len(rows) == 360
    mean = record(*steam, "--exponent=1.2")["relative_pressure"]
    # Two strokes of 2 R in units of Q R; kinks leave the sum of the midpoints to a thousandth.
    assert sum(float(row["tangential_force"]) for row in rows) * pi / 180 == pytest.approx(4 * mean, rel=1e-3)


def test_cushioning_to_a_pressure_has_fifty_right_digits() -> None:
    options = ("--pressure=8bar", "--back=1bar", "--cushion=3bar", "--clearance=5%", "--exponent=1.13")
    (row,) = printed("power", "--eps=4", *options, "--digits=50", "-f", "csv").records()
    with workdps(80):
        room, n = mpf(5) / 100, mpf(113) / 100
        filled, left = room + mpf(1) / 4, room * mpf(3) ** (1 / n)
        drive = mpf(1) / 4 + filled / (n - 1) * (1 - (filled / (1 + room)) ** (n - 1))
        resist = (1 + room - left + left / (n - 1) * ((left / room) ** (n - 1) - 1)) / 8
        assert row["relative_pressure"] == nstr(drive - resist, 50)


def test_a_page_that_asks_for_a_cut_off_is_the_same_elsewhere() -> None:
    page = typed_power(unknown="eps", pressure=8e5, back=0.2, mean_pressure=3e5, columns="epsilon,cut_off")
    assert typeset(loads(dumps(page)), "csv") == typeset(page, "csv") == "epsilon,cut_off\n4.2593,0.23478\n"
