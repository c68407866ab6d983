"""δ with the moving masses, against the kinetic energy of the bodies themselves."""

from __future__ import annotations

import math
from fractions import Fraction

import flint
import numpy as np
import pytest
from cli import printed, refusal
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from kurbel.drive.crank import Crank
from kurbel.drive.rod import Moving, Rod
from kurbel.engine.engine import Engine, Load, Steam
from kurbel.engine.turn import Turn, turn_of
from kurbel.errors import ProblemError
from kurbel.exact.certify import ball
from kurbel.kernel.circle import circle
from kurbel.kernel.rod import Loaded, Masses, kinetic_energy, torque_slope
from kurbel.reading.units import Speed

GRID = 72_001
# Mass of piston and crosshead, rod, its centre from the crosshead pin and radius of gyration in L.
PISTON, ROD, CENTRE, GYRATION = 300.0, 150.0, 0.6, 0.3
RADIUS, BORE, PRESSURE, TURNS = 0.3, 0.3, 8e5, 2.0


def moved(ratio: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return crank angles, kinetic energy in J and piston path, from positions and their differences."""
    angles = np.linspace(0, 2 * math.pi, GRID)
    omega, length = 2 * math.pi * TURNS, RADIUS / ratio
    pin = RADIUS * np.exp(1j * angles)
    slant = np.arcsin(ratio * np.sin(angles))
    head = RADIUS * np.cos(angles) + length * np.cos(slant)
    centre = head + CENTRE * (pin - head)

    def speed(place: np.ndarray) -> np.ndarray:
        slope: np.ndarray = omega * np.gradient(place, angles, edge_order=2)
        return slope

    energy = PISTON * speed(head) ** 2 + ROD * abs(speed(centre)) ** 2
    energy += ROD * (GYRATION * length) ** 2 * speed(slant) ** 2
    return angles, energy / 2, head[0] - head


def brute_irregularity(ratio: float, expansion: float) -> float:
    angles, energy, path = moved(ratio)
    force = math.pi / 4 * BORE**2 * PRESSURE
    share = path / (2 * RADIUS)
    out = angles <= math.pi
    travelled = np.where(out, share, 1 - share)
    back = 1 / expansion
    steam = np.minimum(travelled, 1 / expansion) - back * travelled
    steam += np.log(np.maximum(travelled * expansion, 1)) / expansion
    whole = (1 + math.log(expansion)) / expansion - back
    work = 2 * RADIUS * force * (steam + np.where(out, 0, whole))
    mean = 2 * RADIUS * force * whole / math.pi
    excess = work - mean * angles - (energy - energy[0])
    return float((excess.max() - excess.min()) / mean)


TWO_A_SECOND = Speed(Fraction(2))


def heavy(ratio: Fraction, speed: Speed = TWO_A_SECOND) -> Crank:
    connecting = Rod.from_crosshead(Fraction("0.6"), Fraction("0.3"), Fraction(150))
    moving = Moving(Fraction(300), connecting)
    return Crank(ratio, radius=Fraction("0.3"), speed=speed, moving=moving)


LOAD = Load(Fraction("0.3"), Fraction(800_000))


@pytest.mark.parametrize(("ratio", "expansion"), [("1/5", 4), ("1/5", 2), ("1/3", 6), ("2/9", 3)])
def test_irregularity_with_masses_is_that_of_the_moving_bodies(ratio: str, expansion: int) -> None:
    engine = Engine(heavy(Fraction(ratio)), Steam(Fraction(expansion)), load=LOAD)
    brute = brute_irregularity(float(Fraction(ratio)), float(expansion))
    assert math.isclose(float(Turn(engine, "exact").irregularity()), brute, rel_tol=1e-6)


def test_speed_in_radians_is_the_same_speed() -> None:
    radians = Fraction(4 * math.pi)
    steam, ratio = Steam(Fraction(4)), Fraction(1, 5)
    turns = Turn(Engine(heavy(ratio), steam, load=LOAD), "exact")
    same = Turn(Engine(heavy(ratio, Speed(radians, turns=False)), steam, load=LOAD), "exact")
    assert math.isclose(float(turns.irregularity()), float(same.irregularity()), rel_tol=1e-14)


def test_next_to_no_mass_changes_next_to_nothing() -> None:
    crank, steam = Crank(Fraction(1, 5)), Steam(Fraction(4))
    light = Crank(Fraction(1, 5), radius=Fraction(1), speed=TWO_A_SECOND, moving=Moving(Fraction(1, 10**9)))
    load = Load(Fraction(1), Fraction(10**6))
    with_mass = Turn(Engine(light, steam, load=load), "exact").irregularity()
    assert abs(float(with_mass - Turn(Engine(crank, steam), "exact").irregularity())) < 1e-10


@settings(max_examples=60, deadline=None)
@given(st.floats(0, 360), st.floats(-0.9, 0.9), st.floats(-1, 1))
def test_torque_takes_the_energy_and_its_slope_is_right(degrees: float, ratio: float, couple: float) -> None:
    masses, step = Masses(0.3, 0.7, couple), 1e-3
    at = [circle(degrees + offset * math.degrees(step)) for offset in (-2, -1, 1, 2)]
    weights = np.array([1, -8, 8, -1]) / (12 * step)
    energy = [kinetic_energy(one, ratio, masses) for one in at]
    torque = [Loaded(one, ratio, masses).torque() for one in at]
    here = circle(degrees)
    scale = (1 - abs(ratio)) ** -3
    assert_allclose(Loaded(here, ratio, masses).torque(), -weights @ energy, rtol=0, atol=1e-8 * scale)
    assert_allclose(torque_slope(here, ratio, masses), weights @ torque, rtol=0, atol=1e-7 * scale)


def test_every_extreme_is_enclosed_with_masses_too() -> None:
    turn = Turn(Engine(heavy(Fraction(1, 5)), Steam(Fraction(4)), load=LOAD), "exact")
    before = flint.ctx.prec
    flint.ctx.prec = 200
    try:
        for piece, root, function, _ in turn.extrema:
            low, high = function(ball(root.low)), function(ball(root.high))
            assert (low < 0) == bool(root.rising)
            assert (high > 0) == bool(root.rising)
            assert piece.start <= root.low < root.high <= piece.end
    finally:
        flint.ctx.prec = before
    assert len(turn.extrema) == 6


def test_weisbach_has_no_formulas_for_masses() -> None:
    engine = Engine(heavy(Fraction(1, 5)), Steam(Fraction(4)), load=LOAD)
    with pytest.raises(ProblemError, match='method "weisbach" has no formulas for the masses; use exact or'):
        turn_of(engine, "weisbach")


WORDS = (
    "--eps 4 --reciprocating 300kg --rod-mass 150kg --centre 0.6 --gyration 0.3 --stroke 600mm"
    " --speed 120/min --bore 300mm --pressure 8bar"
)


def test_delta_of_the_command_line_is_that_of_the_moving_bodies() -> None:
    (record,) = printed("delta", *WORDS.split(), "-f", "csv", "--digits", "6").records()
    assert math.isclose(float(record["delta"]), brute_irregularity(0.2, 4), rel_tol=2e-6)


def test_flywheel_takes_the_same_masses_and_the_power_of_the_steam() -> None:
    words = ("--delta", "1:100", "-f", "csv", "--digits", "6")
    (record,) = printed("flywheel", *WORDS.split(), *words).records()
    assert math.isclose(float(record["swing_share"]), brute_irregularity(0.2, 4), rel_tol=2e-6)
    # Two strokes of Q 2R [(1 + ln ε)/ε - 1/ε] in a turn, at two turns a second.
    force = math.pi / 4 * BORE**2 * PRESSURE
    power = 2 * 2 * RADIUS * force * math.log(4) / 4 * TURNS
    assert math.isclose(float(record["power"]), power, rel_tol=1e-9)
    torque = power / (2 * math.pi * TURNS)
    assert math.isclose(float(record["mean_torque"]), torque, rel_tol=1e-9)
    swing = brute_irregularity(0.2, 4) * torque
    assert math.isclose(float(record["swing"]), swing, rel_tol=2e-6)
    assert math.isclose(float(record["inertia"]), swing / 0.01 / (2 * math.pi * TURNS) ** 2, rel_tol=2e-6)


def test_a_power_beside_masses_is_refused() -> None:
    said = refusal("flywheel", *WORDS.split(), "--delta", "1:100", "--power", "50kW")
    assert said == "with masses the power follows from pressure, bore, stroke and speed; leave --power out"


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (
            "--reciprocating 3kg",
            "--reciprocating needs --stroke, --speed, --bore, --pressure to become a force",
        ),
        (
            "--centre 0.6 --gyration 0.3",
            "the rod's masses are shares; add its mass in kg, --rod-mass",
        ),
        ("--reciprocating 3", 'reciprocating mass "3" has no unit; write a mass such as 200kg'),
        (
            "--rod-mass 3kg",
            "the rod's masses are not known; give its centre and its gyration, such as --centre 0.6"
            " --gyration 0.4, or --rod-file",
        ),
    ],
)
def test_masses_that_cannot_be_weighed_are_answered_with_a_sentence(words: str, sentence: str) -> None:
    size = "--stroke 600mm --speed 120/min --bore 300mm --pressure 8bar"
    given = words.split() + ([] if "needs --stroke" in sentence else size.split())
    assert refusal("delta", *given) == sentence
