"""The excess energy of torques by formula and by points: quadrature, dense sampling, and books' examples."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import radians
from typing import Any, TypeAlias

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kurbel.engine.diagram.excess import Excess
from kurbel.engine.diagram.formula import torque_of
from kurbel.engine.diagram.points import points_of, torque_through
from kurbel.engine.diagram.torque import Torque, own_cycle
from kurbel.errors import KurbelError
from kurbel.exact.kind import balls, floats, settled

Array: TypeAlias = Any
# A single cylinder of a turn: a triangle with its peak at 60°.
TRIANGLE = "0:0; 60:90; 180:0; 360:0"


def waved(text: str, turns: Fraction | None = None) -> Torque:
    waves = torque_of(text)
    return Torque.of(waves, own_cycle(waves, turns, "torque"))


def lined(text: str, turns: Fraction | None = None) -> Torque:
    return torque_through(points_of(text), turns)


def swing_of(excess: Excess) -> float:
    return float(excess.swing(floats()))


def places(excess: Excess, *, greatest: bool) -> list[float]:
    found = excess.extremes(greatest=greatest)
    return [float(one.degrees(floats())) for one in found if one.degrees is not None]


def sampled(torque: Callable[[Array], Array], degrees: float) -> float:
    """Return the swing of the energy of a torque by the trapezoidal rule over 200,000 angles."""
    angles = np.linspace(0.0, radians(degrees), 200_001)
    values = torque(angles)
    steps = (values[1:] + values[:-1]) / 2 * np.diff(angles)
    energy = np.concatenate([[0.0], np.cumsum(steps)])
    energy -= energy[-1] * angles / angles[-1]
    return float(energy.max() - energy.min())


def test_one_sine_over_its_mean_swings_by_twice_its_amplitude_over_its_order() -> None:
    excess = Excess.between(waved("5000 + 1500 sin(3φ)"), None)
    assert settled(excess.swing, 30, algebraic=excess.algebraic) == 1000 * 10**30
    assert [one.exact for one in excess.extremes(greatest=True)] == [60, 180, 300]
    assert [one.exact for one in excess.extremes(greatest=False)] == [0, 120, 240]


def test_a_tie_at_an_angle_that_is_no_rational_number_is_one() -> None:
    """E = -(a/2) cos 2φ - b cos φ is least at 0° or 180°, greatest at cos φ = -b/2a: the swing of a = 10,
    b = 1 is a/2 + a/2 + b + b²/4a = 11.025, a tie at two decimals, which a bisection of digits never ends."""
    excess = Excess.between(waved("10 sin 2φ + sin φ"), None)
    assert excess.algebraic
    assert settled(excess.swing, 2, "half-even") == 1102
    assert settled(excess.swing, 2, "half-away") == 1103


def test_the_swing_between_two_sines_is_that_of_mpmath() -> None:
    """sin φ (1500 (3 - 4 sin² φ) - 600) is 0 at sin² φ = 13/20; the work from there to 180° less it."""
    excess = Excess.between(waved("5000 + 1500 sin(3φ)"), waved("5000 + 600 sin φ"))
    with mpmath.workdps(40):
        turn = mpmath.asin(mpmath.sqrt(mpmath.mpf(13) / 20))
        work = mpmath.quad(lambda t: 1500 * mpmath.sin(3 * t) - 600 * mpmath.sin(t), [mpmath.pi - turn, turn])
        true = int(mpmath.nint(work * mpmath.mpf(10) ** 25))
    assert settled(excess.swing, 25) == true
    degrees = float(mpmath.degrees(turn))
    assert places(excess, greatest=True) == pytest.approx([degrees, 360 - degrees], rel=1e-14)
    assert places(excess, greatest=False) == pytest.approx([180 - degrees, 180 + degrees], rel=1e-14)


waves = st.lists(st.tuples(st.integers(-9, 9), st.integers(1, 6), st.integers(0, 71)), min_size=1, max_size=4)


@settings(max_examples=8, deadline=None)
@given(waves, st.integers(1, 5))
def test_random_waves_swing_as_they_do_when_sampled(parts: list[tuple[int, int, int]], load: int) -> None:
    text = " ".join(f"{a:+d} sin({order}φ + {5 * phase})" for a, order, phase in parts)

    def torque(angles: Array) -> Array:
        sines = (a * np.sin(order * angles + np.radians(5 * phase)) for a, order, phase in parts)
        return sum(sines) - load * np.cos(angles)

    excess = Excess.between(waved(f"40 {text}"), waved(f"40 + {load} cos φ"))
    assert swing_of(excess) == pytest.approx(sampled(torque, 360), rel=1e-7)


@settings(max_examples=8, deadline=None)
@given(st.lists(st.integers(-20, 90), min_size=3, max_size=8), st.sampled_from([0, 12]))
def test_random_lines_swing_as_they_do_when_sampled(levels: list[int], load: int) -> None:
    levels = [levels[0], levels[0] + 30, *levels]
    angles = [720 * number // (len(levels) - 1) for number in range(len(levels))]
    drive = lined("; ".join(f"{angle}:{level}" for angle, level in zip(angles, levels, strict=True)))
    areas = (
        Fraction(levels[n] + levels[n + 1], 2) * (angles[n + 1] - angles[n]) for n in range(len(levels) - 1)
    )
    mean = Fraction(sum(areas)) / 720
    excess = Excess.between(drive, waved(f"{mean.numerator}/{mean.denominator} + {load} sin 2φ"))

    def torque(at: Array) -> Array:
        return np.interp(np.degrees(at), angles, levels) - load * np.sin(2 * at)

    assert swing_of(excess) == pytest.approx(sampled(torque, 720), rel=1e-6)


def test_three_cranks_of_a_triangle_have_the_swing_of_the_drawing() -> None:
    """Each turn's work is 90/2 π = 141.37 J, three of them; the sum runs between 45 and 90 N m about its mean
    67.5, with a triangle of 60° and 22.5 N m above it: 11.78 J."""
    excess = Excess.between(lined(TRIANGLE).superposed([Fraction(0), Fraction(120), Fraction(240)]), None)
    assert float(excess.work(floats())) == pytest.approx(3 * 45 * np.pi)
    assert swing_of(excess) == pytest.approx(22.5 * radians(60) / 2, rel=1e-14)
    assert [one.exact for one in excess.extremes(greatest=True)] == [90, 210, 330]


def test_a_load_that_jumps_has_its_extremes_at_the_jumps() -> None:
    """A punch takes 10 kN m over a tenth of each turn; the motor gives the mean, 1 kN m, and so stores what
    nine tenths of a turn bring."""
    excess = Excess.between(None, lined("0:10kNm; 36:10kNm; 36:0; 360:0"))
    assert float(excess.mean_torque(floats())) == 1000
    assert swing_of(excess) == pytest.approx(0.9 * 2000 * np.pi)
    assert [one.exact for one in excess.extremes(greatest=True)] == [0]
    assert [one.exact for one in excess.extremes(greatest=False)] == [36]


def test_energies_over_the_turn_are_quadratures() -> None:
    excess = Excess.between(lined(TRIANGLE), waved("22.5 + 3 sin 2φ"))

    def torque(at: mpmath.mpf) -> mpmath.mpf:
        degrees = mpmath.degrees(at)
        line = degrees * 1.5 if degrees < 60 else max(0, 135 - degrees * 0.75)
        return line - mpmath.mpf("22.5") - 3 * mpmath.sin(2 * at)

    corners = [0, mpmath.pi / 3, mpmath.pi, mpmath.radians(250)]
    true = mpmath.quad(torque, corners)
    assert float(excess.energy(Fraction(250), balls()).mid()) == pytest.approx(float(true), rel=1e-12)


@pytest.mark.parametrize(("text", "swing"), [("cos φ - cos φ sin φ", 2.0), ("sin φ (1 - cos φ)", 2.0)])
def test_zeros_that_fall_together_are_one(text: str, swing: float) -> None:
    """1 - sin φ is 0 twice at 90°, beside cos φ: E = sin φ - ½ sin² φ, from -3/2 to 1/2. 1 - cos φ is 0
    twice at 0°, beside sin φ: E = ½ (1 - cos φ)², from 0 to 2."""
    excess = Excess.between(waved(f"{text} + 5"), None)
    assert all(one.exact is not None for way in (True, False) for one in excess.extremes(greatest=way))
    assert swing_of(excess) == pytest.approx(swing)


def test_means_that_are_equal_by_algebra_are_equal() -> None:
    """cos 36° - cos 72° is ½, of which neither part is rational."""
    assert swing_of(Excess.between(waved("cos 36 - cos 72 + sin φ"), waved("1/2 - sin φ"))) == pytest.approx(
        4
    )


def test_waves_of_cranks_that_come_to_nothing_are_left_out() -> None:
    drive = waved("sin φ + 3 sin 3φ").superposed([Fraction(0), Fraction(120), Fraction(240)])
    assert swing_of(Excess.between(drive, None)) == pytest.approx(6)
    with pytest.raises(KurbelError, match="the same everywhere; the speed does not vary"):
        Excess.between(waved("sin φ").superposed([Fraction(0), Fraction(120), Fraction(240)]), None)


@pytest.mark.parametrize(
    ("make", "why"),
    [
        (
            lambda: Excess.between(waved("500 + sin φ"), waved("495 + cos φ")),
            "is 500 and that of the load 495",
        ),
        (lambda: Excess.between(None, None), "no torque was given; add --torque"),
        (lambda: Excess.between(waved("5"), None), "the speed does not vary"),
        (lambda: waved("sin(φ/2)", Fraction(1)), "comes again after 720°, and a cycle of 1 turns has 360°"),
        (lambda: waved("sin(0.123φ)"), "comes again after 1000 turns; at most 100"),
        (lambda: lined("0:0; 60:90; 180:0"), "end at 180°, and no number of turns was given"),
        (lambda: lined("0:0; 60:90; 180:0", Fraction(1)), "run from 0° to 180°, and the cycle to 360°"),
        (lambda: lined("0:0; 60:90; 180:0", Fraction(1, 3)), "end at 180°, and a cycle of 1/3 turns at 120°"),
        (lambda: lined("0:0; 60:90; 30:5; 360:0"), "has 30° behind 60°"),
        (lambda: lined("0:0; 60:1; 60:2; 60:3; 360:0"), "more than two points at 60°"),
        (lambda: lined("5:0; 5:3"), "at one angle only"),
        (lambda: lined("-30:0; 360:3"), "begins at -30°"),
        (lambda: lined("0:0; 60; 360:3"), 'the part "60", which is no point'),
    ],
)
def test_what_is_no_diagram_is_told_why(make: Callable[[], object], why: str) -> None:
    with pytest.raises(KurbelError) as told:
        make()
    assert why in str(told.value)


def test_points_without_the_ends_of_the_cycle_are_joined_across_them() -> None:
    """From 350° with 10 N m to 10° with 30 of the next turn: 20 N m at 0°."""
    torque = lined("10:30; 100:0; 200:0; 300:5; 350:10", Fraction(1))
    assert float(torque.at(Fraction(0), floats())) == pytest.approx(20)
    assert float(torque.at(Fraction(355), floats())) == pytest.approx(15)
