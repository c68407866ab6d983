"""The combined load of the rod, against Newton's equations on a fine grid and against mpmath."""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Sequence
from fractions import Fraction

import flint
import numpy as np
import pytest
from cli import printed, refusal
from mpmath import mp
from numpy.testing import assert_allclose
from numpy.typing import NDArray
from places import CARDS
from rod_curve import Body, Drive, loads

from kurbel.drive.crank import Crank
from kurbel.drive.crank_forces import CRANK_FORCES
from kurbel.drive.rod import Moving, Rod
from kurbel.engine.engine import Engine, Load, Steam
from kurbel.engine.loads.compressor import Compressor
from kurbel.engine.loads.gas import GasCycle
from kurbel.engine.rodload.load import PULL, SIGNS, THRUST, RodLoad
from kurbel.engine.rodload.quantities import ENDS
from kurbel.engine.turn import Turn
from kurbel.reading.units import Speed

SHEET = ("forces", "--layout=rod-load", "--lang=en", "-f", "csv")
MASSES = ("--bore=300mm", "--pressure=8bar", "--stroke=600mm", "--speed=170/min", "--reciprocating=210kg")
BITS = 120
PRESSURE, BORE, RADIUS = Fraction(100_000), Fraction(3, 10), Fraction(1, 4)

Array = NDArray[np.float64]
Pressures = Sequence[Callable[[Array], Array]]


def _steam(rng: random.Random) -> tuple[Steam, bool, Pressures]:
    expansion, clearance = Fraction(rng.randint(12, 70), 10), Fraction(rng.randint(0, 9), 100)
    exponent, back = Fraction(rng.choice([100, 113, 130]), 100), Fraction(rng.randint(2, 12), 100)
    double = rng.random() < 0.6
    cut_off, space = 1 / float(expansion), float(clearance)

    def driving(share: Array) -> Array:
        volume = np.maximum(share, cut_off) + space
        return np.asarray(((cut_off + space) / volume) ** float(exponent) - float(back))

    idle = driving if double else np.zeros_like
    return Steam(expansion, back, exponent, clearance), double, (driving, idle)


def _compressor(rng: random.Random) -> tuple[Compressor, bool, Pressures]:
    ratio, clearance = Fraction(rng.randint(15, 60), 10), Fraction(rng.randint(2, 9), 100)
    exponent, loss = Fraction(rng.choice([100, 125, 140]), 100), Fraction(rng.randint(1, 9), 100)
    double, space, n = rng.random() < 0.6, float(clearance), float(exponent)
    low, high = 1 - float(loss), float(ratio) * 1.04

    def leaving(share: Array) -> Array:
        expanded = high * (space / (space + share)) ** n
        return np.maximum(expanded, low)

    def coming(share: Array) -> Array:
        compressed = low * ((1 + space) / (1 + space - share)) ** n
        return np.minimum(compressed, high)

    strokes: Pressures = (
        (lambda share: leaving(share) - coming(share),) * 2
        if double
        else (lambda share: leaving(share) - 1, lambda share: 1 - coming(share))
    )
    return Compressor(ratio, exponent, clearance, loss, Fraction(4, 100)), double, strokes


def _gas(rng: random.Random) -> tuple[GasCycle, bool, Pressures]:
    compression, n = Fraction(rng.randint(50, 140), 10), 1.35
    cut_off = Fraction(rng.randint(12, 25), 10)
    peak = Fraction(math.ceil(float(compression) ** n) + rng.randint(1, 20))
    space = 1 / (float(compression) - 1)

    def fired(share: Array) -> Array:
        volume = np.maximum(space + share, space * float(cut_off))
        return np.asarray(float(peak) * (space * float(cut_off) / volume) ** n - 1)

    def compressed(share: Array) -> Array:
        return np.asarray(1 - ((1 + space) / (1 + space - share)) ** n)

    def pushed(share: Array) -> Array:
        return 0 * share - 0.2

    cycle = GasCycle(compression, "dual", peak, cut_off, exponent=Fraction(27, 20), exhaust=Fraction(12, 10))
    return cycle, False, (fired, pushed, np.zeros_like, compressed)


@pytest.mark.parametrize("of_load", [_steam, _compressor, _gas])
def test_extremes_and_reversal_are_those_of_newtons_equations_on_a_fine_grid(
    of_load: Callable[[random.Random], tuple[Steam, bool, Pressures]],
) -> None:
    rng = random.Random(of_load.__name__)
    for _ in range(3):
        load, double, pressures = of_load(rng)
        ratio, offset = Fraction(rng.randint(12, 35), 100), Fraction(rng.choice([0, 17, 40]), 100)
        masses = [Fraction(rng.randint(20, 400)), Fraction(rng.randint(30, 200))]
        centre, square = Fraction(rng.randint(50, 80), 100), Fraction(rng.randint(6, 12), 100)
        speed = Fraction(rng.randint(20, 60))
        moving = Moving(masses[0], Rod(centre, square, masses[1]))
        crank = Crank(ratio, offset=offset, radius=RADIUS, speed=Speed(speed, turns=False), moving=moving)
        turn = Turn(Engine(crank, load, double, load=Load(BORE, PRESSURE)), "exact")
        unit = float(RADIUS * speed**2) / (math.pi / 4 * float(BORE**2 * PRESSURE))
        one, rod = (float(mass) * unit for mass in masses)
        body = Body(rod, float(centre), float(square))
        wanted = loads(Drive(float(ratio), float(offset), one, body), pressures)
        for end, (force, _) in ENDS.items():
            found = _found(RodLoad(turn, CRANK_FORCES[force]))
            scale = max(wanted[end].thrust, wanted[end].pull)
            # Between two samples a corner may be missed by the step times the slope.
            assert_allclose(found[:2], wanted[end][:2], rtol=0, atol=5e-4 * scale)
            assert_allclose(found[2:4], wanted[end][4:], rtol=0, atol=2e-3)


def _found(load: RodLoad) -> list[float]:
    with flint.ctx.workprec(BITS):
        greatest = [load.greatest(sign) or 0 for sign in SIGNS]
        return [*map(float, greatest), *(180 * float(load.angle(sign)) for sign in SIGNS)]


def test_many_digits_of_an_extreme_and_of_a_reversal_are_those_of_mpmath() -> None:
    found = printed(*SHEET, "--eps=3", "--back=0.07", "--ratio=2:9", *MASSES, "--digits=25").records()
    with mp.workdps(40):
        ratio, speed = mp.mpf(2) / 9, 2 * mp.pi * mp.mpf(170) / 60
        inertia = 210 * mp.mpf("0.3") * speed**2
        whole = mp.pi / 4 * mp.mpf("0.3") ** 2 * 800_000

        def path(angle: mp.mpf) -> mp.mpf:
            return 1 - mp.cos(angle) + (1 - mp.sqrt(1 - (ratio * mp.sin(angle)) ** 2)) / ratio

        def load(angle: mp.mpf, back: bool = False) -> mp.mpf:
            share = (2 - path(angle) if back else path(angle)) / 2
            net = (mp.mpf(1) / 3 / share if 3 * share > 1 else 1) - mp.mpf("0.07")
            return whole * net * (-1 if back else 1) - inertia * mp.diff(path, angle, 2)

        slide = found[0]
        # The thrust is greatest at cut-off: there the masses still press more and more.
        cut_off = mp.findroot(lambda angle: path(angle) - mp.mpf(2) / 3, 1.1)
        assert mp.almosteq(load(cut_off), mp.mpf(slide["thrust_n"]), abs_eps=mp.mpf("1e-24"))
        assert mp.almosteq(180 * cut_off / mp.pi, mp.mpf(slide["phi_thrust"]), abs_eps=mp.mpf("1e-24"))
        # So is the pull on the return.
        back = mp.findroot(lambda angle: 2 - path(angle) - mp.mpf(2) / 3, 4.4)
        assert mp.almosteq(-load(back, True), mp.mpf(slide["pull_n"]), abs_eps=mp.mpf("1e-24"))
        ends = [mp.mpf(0), mp.pi]
        if load(mp.mpf(0)) < 0:
            ends[0] = mp.findroot(load, 0.4)
        assert load(mp.pi) > 0
        assert load(mp.pi, True) < 0
        assert load(2 * mp.pi, True) < 0
        thrust = 180 * (ends[1] - ends[0]) / mp.pi
        assert mp.almosteq(thrust, mp.mpf(slide["thrust_angle"]), abs_eps=mp.mpf("1e-23"))


def test_a_load_that_only_thrusts_has_no_pull_and_no_reversal() -> None:
    slide = printed(*SHEET, "--eps=4", "--single-acting").records()[0]
    assert (slide["thrust"], slide["phi_thrust"], slide["thrust_angle"]) == ("0.7500", "0.000", "180.00")
    assert (slide["pull"], slide["phi_pull"], slide["pull_angle"]) == ("", "", "0.00")
    assert (slide["reversal_angle"], slide["reversal_share"]) == ("0.00", "0.00")


def test_a_double_zero_at_the_dead_centre_is_no_change_of_the_sign() -> None:
    # At the best back pressure the steam ends its stroke with no force and no slope.
    found = printed(*SHEET, "--eps=5", "--ratio=1:3").records()
    assert [one["reversal_unbroken"] for one in found] == ["180.00"] * 3


def test_a_load_half_way_between_two_printed_ones_is_a_tie() -> None:
    words = (*SHEET, "--eps=4", "--back=0.35", "--digits=1", "--columns=thrust")
    assert printed(*words, "--rounding=half-even").records()[0]["thrust"] == "0.6"
    assert printed(*words).records()[0]["thrust"] == "0.7"


def test_the_longest_reversal_goes_on_over_the_dead_centre() -> None:
    # Masses of 1e4 Q make the load alone: it pulls about the inner dead centre, as far as p is above zero.
    turn = Turn(_fast(), "exact")
    load = RodLoad(turn, CRANK_FORCES["crosshead_load"])
    with flint.ctx.workprec(BITS):
        pull, whole = (180 * float(value) for value in (load.unbroken(PULL), load.angle(PULL)))
        thrust = 180 * float(load.unbroken(THRUST))
    assert_allclose(pull, whole, rtol=0, atol=1e-12)

    def place(angle: float) -> mp.mpf:
        return mp.cos(angle) + mp.sqrt(1 / mp.mpf("0.09") - mp.sin(angle) ** 2)

    zero = mp.findroot(lambda angle: mp.diff(place, angle, 2), 1.3)
    assert_allclose([pull, pull + thrust], [2 * math.degrees(zero), 360], rtol=0, atol=0.02)


def _fast() -> Engine:
    moving = Moving(Fraction(5000))
    crank = Crank(Fraction(3, 10), radius=RADIUS, speed=Speed(Fraction(300), turns=False), moving=moving)
    return Engine(crank, Steam(Fraction(4)), load=Load(BORE, PRESSURE))


def test_a_card_has_the_load_of_the_ideal_steam_that_it_was_drawn_from() -> None:
    card = ("--card", str(CARDS / "ideal-2.csv"), "--bore=300mm", *MASSES[2:])
    drawn, ideal = (printed(*SHEET, *words).records() for words in (card, ("--eps=2", *MASSES)))
    for one, other in zip(drawn, ideal, strict=True):
        for key in ("thrust_n", "pull_n", "thrust_angle", "reversal_share"):
            error = float(one[f"{key}_error"])
            assert abs(float(one[key]) - float(other[key])) <= error + 10.0 ** -len(one[key].split(".")[1])


def test_what_the_sheet_of_the_rod_does_not_take_is_said_in_a_sentence() -> None:
    assert "layout rod-load is of the whole turn; leave --step out" in refusal(*SHEET, "--eps=4", "--step=5")
    assert "layout rod-load is of a steam engine; add --eps or --card" in refusal(*SHEET)
