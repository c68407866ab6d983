"""Harmonics of the tangential force: against quadrature over the turn, and openTorsion."""

from __future__ import annotations

from cmath import rect
from math import isclose, radians
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from cli import printed, records
from drawn_machines import Draw
from figures import rows
from machines import machine
from pace import within

import kurbel

DIGITS = 7
MACHINE = ("--bore=300mm", "--pressure=8bar", "--stroke=600mm", "--speed=120/min")
HEAVY = {"bore": "300mm", "pressure": "8bar", "stroke": "600mm", "speed": "120/min", "reciprocating": "300kg"}
COLUMNS = ("order", "cosine", "sine", "amplitude", "phase")


def waves(options: dict[str, Any], orders: int) -> list[list[float]]:
    """Return order, cosine, sine, amplitude and phase of all cylinders together."""
    page = kurbel.harmonics(
        quantity="torque", columns=("cylinder", *COLUMNS), orders=orders, digits=DIGITS, **options
    )
    own = [row for row in rows(page) if row.get("cylinder", "all") == "all"]
    return [[float(row[key] or 0) for key in COLUMNS] for row in own]


@pytest.mark.parametrize(
    "options",
    [
        {"eps": "4"},
        {"eps": "2.5", "ratio": "1:4", "back": "10%", "exponent": "1.25", "clearance": "5%",
         "single_acting": True, "method": "series"},
        {"eps": "3", "ratio": "1:6", "cranks": "0;100"},
        {"eps": "4", "ratio": "1:4", **HEAVY},
        {"compression": "6", "peak_pressure": "30", "exponent": "1.25", "exhaust_pressure": "1.25",
         "offset": "0.4", "ratio": "1:4"},
        Draw(3).machine("arc", "compressor"),
        Draw(8).machine("beam", "pump"),
    ],
)  # fmt: skip
def test_harmonics_are_those_of_the_turning_force(options: dict[str, Any]) -> None:
    turn, found = machine(**options).turn, waves(options, 5)
    assert [one[0] for one in found][-1] == 5
    for order, cosine, sine, amplitude, phase in found:
        true = turn.harmonic(order)
        assert abs(cosine - true.real) < 0.51 * 10.0**-DIGITS
        assert abs(-sine - true.imag) < 0.51 * 10.0**-DIGITS
        assert abs(rect(amplitude, radians(phase)) - true) < 4 * 10.0**-DIGITS
        assert -180 < phase <= 180


def test_a_star_of_cranks_that_adds_up_to_nothing_leaves_exactly_nothing() -> None:
    words = ("--eps=4", "--cranks=0;120;240", "--columns=cylinder,order,star,amplitude,phase")
    found = records("harmonics", "--quantity=torque", *words)
    whole = [record for record in found if record["cylinder"] == "all"]
    assert [record["star"] for record in whole] == ["0", "0", "3.0000", "0", "0", "3.0000"]
    assert [record["amplitude"] == "0" for record in whole] == [True, True, False, True, True, False]
    assert [record["phase"] == "" for record in whole] == [True, True, False, True, True, False]
    assert {record["star"] for record in found if record["cylinder"] == "1"} == {"1.0000"}


@pytest.mark.parametrize("method", ["exact", "series"])
def test_a_card_has_the_harmonics_of_the_engine_that_it_was_drawn_from(method: str, tmp_path: Path) -> None:
    options = {"ratio": "1:5", "compression": "7", "exponent": "1.3", "peak_pressure": "28",
               "exhaust_pressure": "1.1", "method": method}  # fmt: skip
    gas = machine(**options)
    shares = np.linspace(0, 1, 161) ** 2
    # Whatever the stroke, positions count from the inner dead centre; the other face is at 1 bar.
    signs = ((1, shares), (-1, 1 - shares), (1, shares), (-1, 1 - shares))
    pressures = [
        1 + sign * one.force(at) for one, (sign, at) in zip(gas.strokes, signs, strict=True)
    ]  # fmt: skip
    points = zip(shares, *pressures, strict=True)
    head = "position,p_expansion [bar],p_exhaust [bar],p_suction [bar],p_compression [bar]"
    card = tmp_path / "gas.csv"
    lines = (",".join([f"{share:.8f}", *(f"{one:.5f}" for one in own)]) for share, *own in points)
    card.write_text("\n".join([head, *lines]), encoding="utf-8")
    page = records(
        "harmonics", "--quantity=torque", f"--card={card}", "--single-acting", "--other-side=1bar",
        "--ratio=1:5", f"--method={method}", "--orders=3", "--digits=8",
    )  # fmt: skip
    for record in page:
        true = gas.turn.harmonic(float(record["order"])) / 28
        values = {"cosine": true.real, "sine": -true.imag, "amplitude": abs(true)}
        away = (float(record["phase"]) - np.degrees(np.angle(true)) + 180) % 360 - 180
        values["phase"] = float(record["phase"]) - away
        for key, value in values.items():
            error, places = float(record[f"{key}_error"]), len(record[key].partition(".")[2])
            assert abs(float(record[key]) - value) <= error + 0.5 * 10.0**-places
            assert key == "phase" or error < 1e-3


@pytest.mark.parametrize("words", ["--eps=4 --mechanism=beam --beam=3", "--compression=6 --peak-pressure=30"])
def test_a_hundred_orders_keep_nobody_waiting(words: str) -> None:
    with within(300):
        page = records("harmonics", "--quantity=torque", *words.split(), "--orders=100")
    assert float(page[-1]["order"]) == 100


def test_open_torsion_reads_the_excitation(tmp_path: Path) -> None:
    import opentorsion

    words = ("--eps=4", "--cranks=0;90", *MACHINE, "--orders=40", "--digits=6")
    path = tmp_path / "excitation.csv"
    printed("harmonics", "--layout=excitation", *words, "-o", str(path))
    table = np.genfromtxt(path, delimiter=",", names=True, dtype=None, encoding="utf-8")
    omegas = np.unique(table["omega_k"])
    excitation = opentorsion.PeriodicExcitation(2, omegas)
    for node, cylinder in enumerate(np.unique(table["cylinder"])):
        own = table[table["cylinder"] == cylinder]
        excitation.add_sines(node, own["omega_k"], own["amplitude_nm"], own["phase_rad"])
    matrix, degrees = excitation.excitation_matrix(), np.array([20, 77, 150, 203, 290])
    # The rows of openTorsion are torques of nodes, Re U e^(iωt); both together, and the mean, turn the shaft.
    turn, whole = machine(eps=4, cranks="0;90").turn, np.pi / 4 * 0.09 * 8e5 * 0.3
    times = np.radians(degrees) / omegas[0]
    swings = np.array([(matrix * np.exp(1j * omegas * time)).real.sum() for time in times])
    assert np.abs(swings - whole * turn.at(turn.excess, degrees)).max() < 0.01 * whole * turn.mean
    assert isclose(omegas[0], 4 * np.pi, rel_tol=1e-6)


@pytest.mark.parametrize(
    ("drive", "begin"),
    [
        ("--offset=0", "from the inner dead centre of the first crank"),
        ("--offset=0.5", "of the first crank from the slide direction"),
    ],
)
def test_the_page_says_from_where_the_angles_count(drive: str, begin: str) -> None:
    page = ("--eps=4", drive, "--lang=en", "-f", "markdown")
    assert f"φ {begin}" in printed("harmonics", "--quantity=torque", "--orders=1", *page).out
    assert f"φ {begin}" in printed("solve", "--where=torque=max", *page).out
