"""The beam engine's dead centres: the book's, and those of the linkage itself, which mpmath closes."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from typing import Any

import flint
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from mpmath import mp

from kurbel.errors import ProblemError
from kurbel.exact.numerals import Number, degrees_text, number_text
from kurbel.kernel import beam
from kurbel.linkage.beam.engine import (
    APPROXIMATE,
    EXACT,
    BeamEngine,
    certified,
    chord_square,
    registry,
    value,
)
from kurbel.page.labels import parse

FIFTH = Fraction(1, 5)
BOOK = BeamEngine(Fraction(3), FIFTH)
# Beams of all lengths, rods from long to nearly too short; the last two nearly come into line.
ENGINES = [
    BOOK,
    BeamEngine(Fraction(7, 2), Fraction(2, 9)),
    BeamEngine(Fraction(13, 10), Fraction(11, 20)),
    BeamEngine(Fraction(40), Fraction(1, 30)),
    BeamEngine(Fraction(10**8), FIFTH),
    BeamEngine(Fraction(9, 4), Fraction(7, 8)),
    BeamEngine(Fraction(1011, 1000), FIFTH),
]
DIGITS = 60

# mpmath has no types.
Real = Any


class Linkage:
    """The four-bar closed by Newton's method on coordinates: pivot at 0, y upwards, the shaft at x > 0."""

    def __init__(self, engine: BeamEngine) -> None:
        self.arm = mp.mpf(engine.arm.numerator) / engine.arm.denominator
        self.rod = mp.mpf(engine.ratio.denominator) / engine.ratio.numerator
        self.swing = self._swing()
        self.height = self._height(self.swing)
        self.upper = mp.findroot(self._standstill, (self.swing, mp.pi / 2 + self._guess(1)))
        self.lower = mp.findroot(self._standstill, (-self.swing, 3 * mp.pi / 2 + self._guess(-1)))

    def _swing(self) -> Real:
        """The least swing with which both dead centres close: beyond it the shaft is not below the beam."""
        least = mp.asin(1 / self.arm)
        step = min((mp.pi / 2 - least) / 4000, least / 1000)
        while self._misses(least + step) < 0:
            least += step
        return mp.findroot(self._misses, (least, least + step), "anderson")

    def _height(self, swing: Real) -> Real:
        half = self.arm * (1 - mp.cos(swing)) / 2
        return self.arm * mp.sin(swing) + mp.sqrt((self.rod - 1) ** 2 - half**2)

    def _misses(self, swing: Real) -> Real:
        """How far the lower dead centre, if it closes, leaves the upper one from closing, in squares."""
        half = self.arm * (1 - mp.cos(swing)) / 2
        above = self._height(swing) + self.arm * mp.sin(swing)
        return above**2 + half**2 - (self.rod + 1) ** 2

    def _guess(self, side: int) -> Real:
        """Where Newton's method starts to look for the standstill."""
        return mp.asin(self.arm * (1 - mp.cos(self.swing)) / 2 / (self.rod + side))

    def _shaft(self, swing: Real, height: Real) -> tuple[Real, Real]:
        return self.arm * (mp.cos(swing) + 1) / 2, -height

    def _end(self, turn: Real) -> tuple[Real, Real]:
        return self.arm * mp.cos(turn), self.arm * mp.sin(turn)

    def _rod(self, turn: Real, crank: Real) -> tuple[Real, Real]:
        """The rod from the crank pin to the beam's end, the crank counted from the horizontal."""
        x, y = self._shaft(self.swing, self.height)
        end = self._end(turn)
        return end[0] - x - mp.cos(crank), end[1] - y - mp.sin(crank)

    def open(self, turn: Real, crank: Real) -> Real:
        return mp.hypot(*self._rod(turn, crank)) - self.rod

    def _standstill(self, turn: Real, crank: Real) -> list[Real]:
        """The linkage is closed, and the pin moves square to the rod: the beam stands still."""
        across, up = self._rod(turn, crank)
        return [self.open(turn, crank), up * mp.cos(crank) - across * mp.sin(crank)]

    def path(self, side: int) -> Real:
        """The way of the beam's end to the vertical crank, which lies inwards of the dead centre."""
        dead = self.upper[0] if side > 0 else self.lower[0]
        crank = side * mp.pi / 2
        inwards = side * mp.mpf(10) ** -30
        while mp.sign(self.open(dead - 2 * inwards, crank)) == mp.sign(self.open(dead, crank)):
            inwards *= 2
        bracket = (dead - inwards, dead - 2 * inwards)
        return self.arm * abs(dead - mp.findroot(lambda turn: self.open(turn, crank), bracket, "anderson"))

    def value(self, key: str) -> Real:
        minutes = 10800 / mp.pi
        mu, nu = self.upper[1] - mp.pi / 2, self.lower[1] - 3 * mp.pi / 2
        return {
            "mu": lambda: mu * minutes,
            "nu": lambda: nu * minutes,
            "distance_1": lambda: (self.lower[1] - self.upper[1]) * minutes,
            "distance_2": lambda: (2 * mp.pi - self.lower[1] + self.upper[1]) * minutes,
            "path_1": lambda: self.path(1),
            "path_2": lambda: self.path(-1),
        }[key]()


@cache
def linkage(engine: BeamEngine) -> Linkage:
    with mp.workdps(DIGITS):
        return Linkage(engine)


def true_value(key: str, engine: BeamEngine) -> Real:
    with mp.workdps(DIGITS):
        return linkage(engine).value(key)


def shown(key: str, engine: BeamEngine, exact: bool) -> str:
    decimals = 0 if registry()[key].minutes else 5
    number = printed(key, engine, exact, decimals)
    return degrees_text(Fraction(number.scaled, 60)) if decimals == 0 else number_text(number, ",")


def printed(key: str, engine: BeamEngine, exact: bool, decimals: int, rounding: str = "half-away") -> Number:
    """The value to so many decimals, of angles in minutes."""
    quantity, method = registry()[key], EXACT if exact else APPROXIMATE
    return certified(quantity, engine, method, decimals, rounding, times=60 if quantity.minutes else 1)


@pytest.mark.parametrize(
    ("key", "printed"),
    [
        ("mu", "0°48'"),
        ("nu", "1°12'"),
        ("distance_1", "180°24'"),
        ("distance_2", "179°36'"),
        ("path_1", "0,00010"),
        ("path_2", "0,00022"),
    ],
)
def test_the_approximation_prints_what_weisbach_printed(key: str, printed: str) -> None:
    assert shown(key, BOOK, exact=False) == printed


@pytest.mark.parametrize(("key", "part"), [("mu", 72), ("nu", 48)])
def test_the_approximate_slants_are_the_parts_of_a_radian_in_the_book(key: str, part: int) -> None:
    with mp.workdps(DIGITS):
        minutes = mp.mpf(10800) / part / mp.pi
        assert printed(key, BOOK, False, 30).scaled == int(mp.nint(minutes * mp.mpf(10) ** 30))


@pytest.mark.parametrize(
    ("key", "true"),
    [
        ("mu", "0°49'"),
        ("nu", "1°14'"),
        ("distance_1", "180°25'"),
        ("distance_2", "179°35'"),
        ("path_1", "0,00013"),
        ("path_2", "0,00020"),
    ],
)
def test_the_linkage_of_the_book_has_other_last_figures(key: str, true: str) -> None:
    assert shown(key, BOOK, exact=True) == true


@pytest.mark.parametrize("engine", ENGINES, ids=str)
@pytest.mark.parametrize("key", registry())
def test_every_digit_is_that_of_the_closed_linkage(key: str, engine: BeamEngine) -> None:
    expected = true_value(key, engine)
    with mp.workdps(DIGITS):
        assert printed(key, engine, True, 30).scaled == int(mp.nint(expected * mp.mpf(10) ** 30))


@pytest.mark.parametrize("engine", ENGINES, ids=str)
def test_the_turning_crank_swings_the_beam_between_its_dead_centres(engine: BeamEngine) -> None:
    machine = linkage(engine)
    arm, rod, swing = float(machine.arm), float(machine.rod), float(machine.swing)
    x, y = arm * (np.cos(swing) + 1) / 2, -float(machine.height)
    cranks = np.linspace(0, 2 * np.pi, 7201) + float(machine.upper[1])
    pin = x + np.cos(cranks) + 1j * (y + np.sin(cranks))
    apart = np.abs(pin)
    # The triangle of pivot, pin and beam's end closes for every crank angle, always on one side.
    cosine = (arm**2 + apart**2 - rod**2) / (2 * arm * apart)
    assert (np.abs(cosine) < 1).all()
    turn = np.angle(pin) + np.arccos(cosine)
    np.testing.assert_allclose([turn.max(), turn.min()], [swing, -swing], rtol=0, atol=1e-5)
    lowest = cranks[turn.argmin()] - cranks[0]
    np.testing.assert_allclose(
        lowest * 10800 / np.pi, float(true_value("distance_1", engine)), rtol=0, atol=6
    )


def turns(arm: float, rod: float) -> bool:
    """Whether a shaft can be placed so that the beam swings symmetrically while the crank turns (Grashof)."""
    swing = np.linspace(np.arcsin(1 / arm), np.pi / 2, 100_001)[:-1] if arm > 1 else np.empty(0)
    half, chord = arm * (1 - np.cos(swing)) / 2, arm * np.sin(swing)
    closing = half < rod - 1
    half, chord, swing = half[closing], chord[closing], swing[closing]
    for side in (1, -1):
        height = chord + side * np.sqrt((rod - 1) ** 2 - half**2)
        misses = (height + chord) ** 2 + half**2 - (rod + 1) ** 2
        for found in np.flatnonzero(np.diff(np.sign(misses))):
            x, y = arm * np.cos(swing[found]) + half[found], -height[found]
            longest = sorted((arm, rod, np.hypot(x, y)))
            below = y * arm * np.cos(swing[found]) + x * chord[found]
            if longest[0] > 1 and 1 + longest[2] < longest[0] + longest[1] and below < 0:
                return True
    return False


@settings(max_examples=150, deadline=None)
@given(thousandths=st.integers(500, 6000), percent=st.integers(2, 99))
def test_the_engine_is_built_if_and_only_if_its_crank_turns(thousandths: int, percent: int) -> None:
    arm, ratio = Fraction(thousandths, 1000), Fraction(percent, 100)
    assume(abs(beam.turning_margin(arm, ratio)) > Fraction(1, 200) * (1 - ratio))
    if turns(float(arm), float(1 / ratio)):
        assert BeamEngine(arm, ratio).arm == arm
    else:
        with pytest.raises(ProblemError):
            BeamEngine(arm, ratio)


@pytest.mark.parametrize("engine", ENGINES, ids=str)
def test_the_half_chord_is_enclosed_at_every_precision(engine: BeamEngine) -> None:
    with mp.workdps(DIGITS):
        square = mp.nstr((linkage(engine).arm * mp.sin(linkage(engine).swing)) ** 2, 45)
    for bits in (80, 160, 1000):
        with flint.ctx.workprec(bits):
            enclosed = chord_square(engine)
            assert enclosed.overlaps(flint.arb(f"{square} +/- 1e-40"))
            assert enclosed.rad() < flint.arb(2) ** (20 - bits)


# Near the line of beam, pivot and shaft the root, hence everything, is ill-conditioned: no floats there.
@pytest.mark.parametrize("engine", ENGINES[:-2], ids=str)
def test_floats_and_arrays_keep_their_digits(engine: BeamEngine) -> None:
    arm, ratio = float(engine.arm), float(engine.ratio)
    # Newton's method rises from below towards the root of a concave function.
    square = 1.0
    for _ in range(20):
        square -= beam.closure(square, arm, ratio) / beam.closure_slope(square, arm, ratio)
    sides = np.array([ratio, -ratio])
    slants = np.arcsin(beam.lean_sine(square, arm, sides)) * 10800 / np.pi
    paths = 2 * arm * np.arctan(beam.swing_tangent(square, arm, sides))
    for keys, found in ((("mu", "nu"), slants), (("path_1", "path_2"), paths)):
        expected = [float(true_value(key, engine)) for key in keys]
        np.testing.assert_allclose(found, expected, rtol=1e-14, atol=0)
    for formula in (beam.lean_sine, beam.swing_tangent):
        assert [formula(square, arm, one) for one in (ratio, -ratio)] == list(formula(square, arm, sides))


def test_long_beams_and_rods_need_no_exact_geometry() -> None:
    engine = BeamEngine(Fraction(10**6), Fraction(1, 10**6))
    for key in ("mu", "nu", "path_1", "path_2"):
        with flint.ctx.workprec(200):
            shares = [value(registry()[key], engine, method) for method in (EXACT, APPROXIMATE)]
            assert abs(shares[0] / shares[1] - 1) < 1e-5


@pytest.mark.parametrize("exact", [False, True])
def test_an_infinite_rod_stays_vertical(exact: bool) -> None:
    engine = BeamEngine(Fraction(1001, 1000), Fraction(0))
    values = [printed(key, engine, exact, 9).scaled for key in registry()]
    assert values == [0, 0, 10800 * 10**9, 10800 * 10**9, 0, 0]
    even = [printed(key, engine, exact, 9, "half-even").scaled for key in registry()]
    assert even == values


@pytest.mark.parametrize("key", registry())
def test_symbols_are_labels_and_names_differ(key: str) -> None:
    quantity = registry()[key]
    assert quantity.key == key
    assert parse(quantity.symbol)
    for language in ("de", "en"):
        rows = [(one.name[language], one.symbol) for one in registry().values()]
        assert rows.count((quantity.name[language], quantity.symbol)) == 1


def sentence(arm: Fraction, ratio: Fraction) -> str:
    with pytest.raises(ProblemError) as raised:
        BeamEngine(arm, ratio)
    return str(raised.value)


@pytest.mark.parametrize(
    ("arm", "said"), [(Fraction(1), "1"), (Fraction(-3), "-3"), (Fraction(1, 3), "0.333333333333333")]
)
def test_a_beam_shorter_than_the_crank_is_refused(arm: Fraction, said: str) -> None:
    assert sentence(arm, FIFTH) == (
        f"beam arm a is {said} r; it must be longer than the crank radius r,"
        " for the beam's end rises and falls by r at least"
    )


def test_the_message_names_an_arm_with_which_the_crank_turns() -> None:
    assert sentence(Fraction(201, 200), FIFTH) == (
        "beam arm a = 1.005 r is too short for r:l = 1:5; the crank turns with an arm of 1.010598 r"
        " or a longer rod, otherwise beam, pivot and shaft come into line"
    )
    assert turns(1.01061, 5)
    assert BeamEngine(Fraction(1010598, 10**6), FIFTH)
    assert sentence(Fraction(1010597, 10**6), FIFTH)
    assert BeamEngine(Fraction(201, 200), Fraction(1, 9))
    assert len(sentence(Fraction(2), 1 - Fraction(1, 10**300))) < 200


def test_the_ratio_is_that_of_any_crank() -> None:
    assert sentence(Fraction(3), Fraction(1)).startswith("crank ratio R:L is 1; it must be below 1")
    assert sentence(Fraction(3), -FIFTH).startswith("crank ratio R:L is -0.2; it must not be negative")
