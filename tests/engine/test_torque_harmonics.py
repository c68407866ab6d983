"""Harmonics of the tangential force: against sums over fine grids, the force itself, and openTorsion."""

from __future__ import annotations

from cmath import exp
from fractions import Fraction
from math import pi
from pathlib import Path
from time import process_time
from typing import Any

import flint
import numpy as np
import opentorsion
import pytest
from cli import printed, refusal
from energy_curve import Curve, Plant
from gas import drawn

from kurbel.drive.crank import Crank
from kurbel.engine.engine import Engine, Steam
from kurbel.engine.harmonics.fourier import spectrum_of
from kurbel.engine.loads.gas import GasCycle
from kurbel.engine.turn import turn_of

DIGITS = 6
MOST_SECONDS = 10
HALF_UNIT = 0.5 * 10.0**-DIGITS
MACHINE = ("--bore=300mm", "--pressure=8bar", "--stroke=600mm", "--speed=120/min")


def waves(records: list[dict[str, str]], cylinder: str = "all", unit: str = "") -> dict[float, complex]:
    """Return a_k - i b_k by the orders."""
    return {
        float(one["order"]): complex(float(one[f"cosine{unit}"]), -float(one[f"sine{unit}"]))
        for one in records
        if one["cylinder"] == cylinder
    }


def summed(force: Any, degrees: Any, order: float) -> complex:
    """Return a_k - i b_k of a force on a grid over a cycle, whose end is not on it."""
    return complex(2 * (force * np.exp(-1j * order * np.radians(degrees))).mean())


@pytest.mark.parametrize(
    ("plant", "words"),
    [
        (Plant(Fraction(4), Fraction(1, 5)), ("--eps=4", "--ratio=1:5")),
        (
            Plant(Fraction(5, 2), Fraction(1, 4), Fraction(1, 10), Fraction(5, 4), Fraction(1, 20), False),
            ("--eps=2.5", "--ratio=1:4", "--back=10%", "--exponent=1.25", "--clearance=5%",
             "--single-acting"),
        ),
        (
            Plant(Fraction(3), Fraction(1, 6), cranks=(Fraction(0), Fraction(100))),
            ("--eps=3", "--ratio=1:6", "--cranks=0;100"),
        ),
    ],
)  # fmt: skip
def test_harmonics_of_steam_are_those_of_the_turning_force(plant: Plant, words: tuple[str, ...]) -> None:
    columns = "--columns=cylinder,order,cosine,sine,amplitude,phase"
    page = printed("harmonics", "--quantity=torque", *words, columns, f"--digits={DIGITS}", "-f", "csv")
    curve = Curve(plant)
    found = waves(page.records())
    assert [*found] == [1, 2, 3, 4, 5, 6]
    for order, wave in found.items():
        true = summed(curve.excess[:-1], curve.angles[:-1], order)
        assert abs(wave.real - true.real) < HALF_UNIT + 1e-7
        assert abs(wave.imag - true.imag) < HALF_UNIT + 1e-7
    for record in page.records():
        turned = float(record["amplitude"]) * exp(1j * np.radians(float(record["phase"])))
        wave = complex(float(record["cosine"]), -float(record["sine"]))
        assert abs(turned - wave) < 4 * HALF_UNIT
        assert -180 < float(record["phase"]) <= 180


@pytest.mark.parametrize("offset", [Fraction(0), Fraction(2, 5)])
def test_halves_of_a_gas_engine_are_those_of_its_two_turns(offset: Fraction) -> None:
    gas = drawn(4)._replace(
        ratio=0.25, offset=float(offset), compression=6.0, exponent=1.25, suction=1.0, exhaust=1.25
    )
    cycle = GasCycle(Fraction(6), peak=Fraction(30), exponent=Fraction(5, 4), exhaust=Fraction(5, 4))
    gas = gas._replace(peak=30.0)
    engine = Engine(Crank(Fraction(1, 4), offset), cycle, double=False)
    spectrum = spectrum_of(turn_of(engine, "exact"))
    count = 400_000
    degrees = gas.dead_centres[0] + (np.arange(count) + 0.5) * 720 / count
    pressure, slope = gas.over_angle(degrees)
    for order in (Fraction(1, 2), Fraction(1), Fraction(3, 2), Fraction(4)):
        wave = spectrum.engine(order)
        assert wave is not None
        true = summed((pressure - 1) * slope, degrees, float(order))
        assert abs(complex(float(wave.cosine), -float(wave.sine)) - true) < 2e-6


def test_the_sum_of_the_harmonics_returns_the_force() -> None:
    engine = Engine(
        Crank(Fraction(1, 4)), Steam(Fraction(3), Fraction(1, 10)), cranks=(Fraction(0), Fraction(90))
    )
    turn = turn_of(engine, "exact")
    spectrum = spectrum_of(turn)
    with flint.ctx.workprec(70):
        found = [(order, spectrum.engine(Fraction(order))) for order in range(1, 61)]
    assert found[1][1] is None
    # The force has corners, so that orders fall as 1/k², those of the energy as 1/k³.
    decay = max(
        order**2 * abs(complex(float(wave.cosine), float(wave.sine))) for order, wave in found if wave
    )

    def sums(half_turns: Fraction) -> tuple[float, float]:
        angle, force, energy = pi * float(half_turns), float(turn.mean_force()), 0.0
        for order, wave in found:
            if wave is not None:
                across, along = np.sin(order * angle), np.cos(order * angle)
                force += float(wave.cosine) * along + float(wave.sine) * across
                energy += (float(wave.cosine) * across - float(wave.sine) * along) / order
        return force, energy

    _, begun = sums(Fraction(0))
    for half_turns in (Fraction(1, 7), Fraction(5, 6), Fraction(13, 9), Fraction(9, 5)):
        force, energy = sums(half_turns)
        assert force == pytest.approx(float(turn.tangential_force(half_turns)), abs=decay / 60)
        assert energy - begun == pytest.approx(float(turn.energy_at(half_turns)), abs=decay / 60**2)


def test_a_star_of_cranks_that_adds_up_to_nothing_leaves_exactly_nothing() -> None:
    words = ("--eps=4", "--cranks=0;120;240", "--columns=cylinder,order,star,amplitude,phase", "-f", "csv")
    records = printed("harmonics", "--quantity=torque", *words).records()
    whole = [record for record in records if record["cylinder"] == "all"]
    assert [record["star"] for record in whole] == ["0", "0", "3.0000", "0", "0", "3.0000"]
    assert [record["amplitude"] == "0" for record in whole] == [True, True, False, True, True, False]
    assert [record["phase"] == "" for record in whole] == [True, True, False, True, True, False]
    assert {record["star"] for record in records if record["cylinder"] == "1"} == {"1.0000"}


def test_masses_alone_change_the_sine_terms_of_the_torque() -> None:
    # The torque of reciprocating masses is odd: its orders 1 to 4 by λ are in every textbook of engines.
    words = ("--quantity=torque", "--eps=4", "--ratio=1:4", *MACHINE, "-f", "csv", "--digits=3",
             "--columns=cylinder,order,cosine_nm,sine_nm", "--orders=4")  # fmt: skip
    heavy, light = (
        waves(printed("harmonics", *words, *more).records(), unit="_nm")
        for more in (("--reciprocating=300kg",), ())
    )
    ratio, moment = 0.25, 300 * 0.3**2 * (2 * pi * 2) ** 2
    # -m r² ω² (∂/∂φ)(c²/2) with c = sin φ + ½ λ sin 2φ + O(λ³): ¼λ, -½, -¾λ, -¼λ².
    for order, factor in {1: ratio / 4, 2: -0.5, 3: -3 * ratio / 4, 4: -(ratio**2) / 4}.items():
        change = heavy[order] - light[order]
        assert abs(change.real) < 2e-3
        assert -change.imag == pytest.approx(factor * moment, abs=moment * ratio**3)


def test_a_card_has_the_harmonics_of_the_engine_that_it_was_drawn_from(tmp_path: Path) -> None:
    gas = drawn(0)
    shares = np.linspace(0, 1, 161) ** 2
    rows = (
        ",".join(
            [f"{share:.8f}", *(f"{gas.pressure(stroke, at):.5f}" for stroke, at in enumerate(travelled))]
        )
        for share in shares
        for travelled in [(share, 1 - share, share, 1 - share)]
    )
    card = tmp_path / "gas.csv"
    head = "position,p_expansion [bar],p_exhaust [bar],p_suction [bar],p_compression [bar]"
    card.write_text("\n".join([head, *rows]), encoding="utf-8")
    page = printed(
        "harmonics", "--quantity=torque", f"--card={card}", "--single-acting", "--other-side=1bar",
        f"--ratio={gas.ratio!r}", "--orders=3", "--digits=8", "-f", "csv",
    )  # fmt: skip
    count = 200_000
    degrees = (np.arange(count) + 0.5) * 720 / count
    pressure, slope = gas.over_angle(degrees)
    for record in page.records():
        true = summed((pressure - 1) / gas.peak * slope, degrees, float(record["order"]))
        for key, value in (("cosine", true.real), ("sine", -true.imag), ("amplitude", abs(true))):
            error = float(record[f"{key}_error"])
            places = len(record[key].partition(".")[2])
            assert abs(float(record[key]) - value) <= error + 0.5 * 10.0**-places
            assert error < 1e-3
        away = (float(record["phase"]) - np.degrees(np.angle(true)) + 180) % 360 - 180
        places = len(record["phase"].partition(".")[2])
        assert abs(away) <= float(record["phase_error"]) + 0.5 * 10.0**-places


@pytest.mark.parametrize(
    "words",
    [
        ("--eps=4", "--mechanism=beam", "--beam=3"),
        ("--eps=4", "--mechanism=arc", "--rocker=3"),
        ("--compression=6", "--peak-pressure=30"),
    ],
)
def test_a_hundred_orders_keep_nobody_waiting(words: tuple[str, ...]) -> None:
    before = process_time()
    page = printed("harmonics", "--quantity=torque", *words, "--orders=100", "-f", "csv")
    assert process_time() - before < MOST_SECONDS
    assert float(page.records()[-1]["order"]) == 100


def test_open_torsion_reads_the_excitation(tmp_path: Path) -> None:
    words = ("--eps=4", "--cranks=0;90", *MACHINE, "--orders=40", f"--digits={DIGITS}")
    path = tmp_path / "excitation.csv"
    printed("harmonics", "--layout=excitation", *words, "-o", str(path))
    table = np.genfromtxt(path, delimiter=",", names=True, dtype=None, encoding="utf-8")
    omegas = np.unique(table["omega_k"])
    excitation = opentorsion.PeriodicExcitation(2, omegas)
    for node, cylinder in enumerate(np.unique(table["cylinder"])):
        own = table[table["cylinder"] == cylinder]
        excitation.add_sines(node, own["omega_k"], own["amplitude_nm"], own["phase_rad"])
    matrix = excitation.excitation_matrix()
    # The rows of openTorsion are torques of nodes, Re U e^(iωt); both together, and the mean, turn the shaft.
    turned = printed(
        "forces", "--eps=4", "--cranks=0;90", "--bore=300mm", "--pressure=8bar", "--stroke=600mm",
        "--columns=phi,torque_nm", "--angle=20;77;150;203;290", "-f", "csv",
    ).records()  # fmt: skip
    swings = []
    for record in turned:
        time = np.radians(float(record["phi"])) / omegas[0]
        swings.append(float((matrix * np.exp(1j * omegas * time)).real.sum()) - float(record["torque_nm"]))
    mean = -np.mean(swings)
    assert np.ptp(swings) < 0.01 * mean


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("--eps=4", "--eps is for the harmonics of the torque; add --quantity torque"),
        ("--offset=0.2", "harmonics of the motion are known for the straight crank, without --offset"),
        ("--stroke=600mm", "--stroke gives the ratio with --rod"),
        ("--quantity=torque --method=infinite", "is that of --ratio 1:∞; leave --method out"),
        ("--quantity=torque --eps=4 --columns=star", "column star needs several cranks with cylinders alike"),
        ("--quantity=torque --eps=4 --columns=frequency", "column frequency needs --speed"),
        ("--layout=excitation --eps=4 --speed=120/min", "column amplitude_nm needs --stroke, --bore"),
    ],
)  # fmt: skip
def test_what_has_no_harmonics_is_refused(words: str, said: str) -> None:
    assert said in refusal("harmonics", *words.split())


@pytest.mark.parametrize(
    ("drive", "begin"),
    [
        ("--offset=0", "from the inner dead centre of the first crank"),
        ("--offset=0.5", "of the first crank from the slide direction"),
        ("--mechanism=beam --beam=3", "of the first crank from the slide direction"),
    ],
)
def test_the_page_says_from_where_the_angles_count(drive: str, begin: str) -> None:
    page = ("--eps=4", *drive.split(), "--lang=en", "-f", "markdown")
    assert f"φ {begin}" in printed("harmonics", "--quantity=torque", "--orders=1", *page).out
    assert f"φ {begin}" in printed("solve", "--where=torque=max", *page).out
