"""The turn of a steam engine: places and sizes of its extreme speeds against energy_curve.py and § 150."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache
from typing import Any

import flint
import pytest
from energy_curve import Curve, Exact, Plant, real
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from mpmath import mp

from kurbel.drive.crank import Crank
from kurbel.engine.engine import Engine, Steam
from kurbel.engine.turn import Turn, place, turn_of
from kurbel.errors import ProblemError

FIFTH = Fraction(1, 5)
BITS = 200
DIGITS = 60
# Simpson's sums over 0.01° lose to the kink at cut-off less than 1e-6 Q R in energy and of P.
GRID_ENERGY = 1e-6


@pytest.fixture(autouse=True)
def precision() -> Iterator[None]:
    before, digits = flint.ctx.prec, mp.dps
    flint.ctx.prec, mp.dps = BITS, DIGITS
    yield
    flint.ctx.prec, mp.dps = before, digits


def turn(plant: Plant) -> Turn:
    steam = Steam(plant.expansion, plant.back, plant.exponent, plant.clearance)
    found = turn_of(Engine(Crank(plant.ratio), steam, plant.double, plant.cranks), plant.method)
    assert isinstance(found, Turn)
    return found


def hundredths(low: int, high: int) -> st.SearchStrategy[Fraction]:
    return st.integers(low, high).map(lambda count: Fraction(count, 100))


expansions = st.one_of(hundredths(100, 300), hundredths(100, 5000))
ratios = hundredths(0, 90)
backs = st.one_of(st.none(), hundredths(0, 80))
later_cranks = st.lists(st.integers(0, 3600).map(lambda count: Fraction(count, 10)), max_size=3)


@st.composite
def plants(draw: st.DrawFn) -> Plant:
    plant = Plant(
        expansion=draw(expansions),
        ratio=draw(ratios),
        back=draw(backs),
        exponent=draw(st.one_of(st.just(Fraction(1)), hundredths(50, 200))),
        clearance=draw(st.one_of(st.just(Fraction(0)), hundredths(0, 30))),
        double=draw(st.booleans()),
        cranks=(Fraction(0), *draw(later_cranks)),
        method=draw(st.sampled_from(("exact", "series"))),
    )
    assume(leaves_work(plant))
    return plant


def leaves_work(plant: Plant) -> bool:
    exact = Exact(plant)
    with mp.workdps(15):
        return bool(mp.quad(exact.pressure, [0, exact.cut_off, 1]) > 1e-3)


def stationary(turn: Turn) -> list[tuple[float, bool | None]]:
    """The degrees at which kurbel finds the speed stationary, and whether the excess rises there."""
    return [(180 * float(place(one)), one.root.rising) for one in turn.extrema]


@settings(max_examples=50, deadline=None)
@given(plants())
def test_turn_agrees_with_a_walk_in_steps_of_a_hundredth_of_a_degree(plant: Plant) -> None:
    found, curve = turn(plant), Curve(plant)
    assert abs(float(found.mean_force()) - curve.mean_force) < GRID_ENERGY
    swing = float(found.extreme(greatest=True).energy - found.extreme(greatest=False).energy)
    assert abs(swing - float(curve.energy.max() - curve.energy.min())) < GRID_ENERGY
    assert abs(float(found.irregularity()) * curve.mean_force - swing) < GRID_ENERGY * (1 + swing)


@settings(max_examples=50, deadline=None)
@given(plants())
def test_no_stationary_place_is_missed_and_none_invented(plant: Plant) -> None:
    curve = Curve(plant)
    # A rise and a fall between two steps of the walk are not seen by it.
    found = without_close_pairs(stationary(turn(plant)), curve.step)
    walked = without_close_pairs(curve.stationary(), curve.step)
    assert [rising for _, rising in found] == [rising for _, rising in walked]
    for (kurbel, _), (walk, _) in zip(found, walked, strict=True):
        assert abs(kurbel - walk) < curve.step


def without_close_pairs(places: list[Any], step: float) -> list[Any]:
    kept: list[Any] = []
    for one in places:
        if kept and one[0] - kept[-1][0] < 2 * step and one[1] != kept[-1][1]:
            kept.pop()
        else:
            kept.append(one)
    return kept


@settings(max_examples=50, deadline=None)
@given(plants())
def test_places_of_the_extremes_have_the_extreme_energies(plant: Plant) -> None:
    found, curve = turn(plant), Curve(plant)
    for greatest, extreme in ((True, curve.energy.max()), (False, curve.energy.min())):
        degrees = 180 * float(found.extreme(greatest).place)
        index = round(degrees / curve.step)
        assert abs(float(curve.energy[index]) - float(extreme)) < 1e-5


HARD = (
    Plant(Fraction(2), FIFTH),
    Plant(Fraction(2), FIFTH, method="series"),
    Plant(Fraction(47, 3), Fraction(9, 10), Fraction(0)),
    Plant(Fraction(1), FIFTH, Fraction(0), method="series"),
    Plant(Fraction(3), FIFTH, Fraction(1, 7), Fraction(13, 10), Fraction(1, 20), double=False),
    Plant(
        Fraction(7, 3),
        Fraction(2, 9),
        None,
        Fraction(3, 4),
        Fraction(1, 9),
        cranks=(Fraction(0), Fraction(90)),
    ),
    Plant(Fraction(50), Fraction(0), None, Fraction(1, 2), Fraction(3, 10), double=False),
    Plant(
        Fraction(4), Fraction(1, 4), Fraction(1, 10), double=False, cranks=(Fraction(0), Fraction(1407, 10))
    ),
)


@pytest.mark.parametrize("plant", HARD, ids=str)
def test_balls_hold_the_values_of_sixty_digits(plant: Plant) -> None:
    found, exact = turn(plant), exact_of(plant)
    for greatest in (True, False):
        peak = found.extreme(greatest)
        angle = exact.stationary(near_of(plant, 180 * float(peak.place)))
        assert_holds(peak.place, angle / mp.pi)
        assert_holds(peak.energy, exact.energy(angle))
    assert_holds(found.mean_force(), exact.mean_force)


@lru_cache
def exact_of(plant: Plant) -> Exact:
    """The plant in sixty digits; its mean force is integrated but once."""
    return Exact(plant)


def near_of(plant: Plant, degrees: float) -> float:
    """The walk's place next to kurbel's: mpmath starts from the former."""
    return min((walked for walked, _ in Curve(plant).stationary()), key=lambda one: abs(one - degrees))


def assert_holds(ball: Any, value: Any) -> None:
    assert ball.rad() < flint.arb("1e-54")
    assert ball.overlaps(flint.arb(f"{mp.nstr(value, DIGITS)} +/- 1e-56"))


@pytest.mark.parametrize("plant", HARD, ids=str)
@pytest.mark.parametrize(
    "degrees", [Fraction(0), Fraction(37, 3), Fraction(90), Fraction(180), Fraction(911, 3)]
)
def test_force_and_energy_at_an_angle_are_those_of_sixty_digits(plant: Plant, degrees: Fraction) -> None:
    found, exact = turn(plant), exact_of(plant)
    angle = real(degrees) * mp.pi / 180
    force, energy = exact.force(angle), exact.energy(angle)
    for half_turns in (degrees / 180, degrees / 180 + 2, degrees / 180 - 2):
        assert_holds(found.tangential_force(half_turns), force)
        assert_holds(found.energy_at(half_turns), energy)


@pytest.mark.parametrize("plant", HARD, ids=str)
def test_precision_narrows_the_balls_and_keeps_what_they_hold(plant: Plant) -> None:
    found = turn(plant)
    with flint.ctx.workprec(100):
        wide = found.irregularity()
    with flint.ctx.workprec(500):
        narrow = found.irregularity()
    assert wide.contains(narrow)
    assert narrow.rad() < flint.arb("1e-140")


@pytest.mark.parametrize("plant", HARD, ids=str)
def test_precision_in_force_is_left_as_it_was(plant: Plant) -> None:
    turn(plant).irregularity()
    assert flint.ctx.prec == BITS


def test_constant_force_and_infinite_rod_have_the_closed_form() -> None:
    # Q(1 - cos α) - P α with P/Q = 2/π is least at sin α = 2/π and greatest half a turn less that angle on.
    found = turn(Plant(Fraction(1), Fraction(0), Fraction(0)))
    least = mp.asin(2 / mp.pi)
    swing = 2 * mp.cos(least) - 2 / mp.pi * (mp.pi - 2 * least)
    assert_holds(found.extreme(greatest=False).place, least / mp.pi)
    assert_holds(found.extreme(greatest=True).place, 1 - least / mp.pi)
    assert_holds(found.mean_force(), 2 / mp.pi)
    assert_holds(found.irregularity(), swing * mp.pi / 2)


@pytest.mark.parametrize("expansion", [Fraction(1), Fraction(7, 3)])
@pytest.mark.parametrize("method", ["exact", "series", "weisbach"])
def test_infinite_rod_makes_both_strokes_alike(expansion: Fraction, method: str) -> None:
    found = turn(Plant(expansion, Fraction(0), Fraction(1, 8), method=method))
    for greatest in (True, False):
        out, back = (found.extreme(greatest, stroke) for stroke in (0, 1))
        assert abs(out.place - back.place) < flint.arb("1e-54")
        assert abs(out.energy - back.energy) < flint.arb("1e-54")
        assert found.extreme(greatest).energy.overlaps(out.energy)


def test_place_in_a_stroke_counts_from_its_own_dead_centre() -> None:
    found = turn(Plant(Fraction(2), FIFTH))
    within = [found.extreme(greatest, stroke).place for stroke in (0, 1) for greatest in (False, True)]
    over = [place(one) for one in found.extrema]
    begun = [there - here for here, there in zip(within, over, strict=True)]
    assert all(start.overlaps(flint.arb(dead)) for start, dead in zip(begun, (0, 0, 1, 1), strict=True))


def test_extreme_of_the_turn_is_the_more_extreme_of_the_strokes() -> None:
    found = turn(Plant(Fraction(2), FIFTH))
    greatest = [found.extreme(True, stroke).energy for stroke in (0, 1)]
    least = [found.extreme(False, stroke).energy for stroke in (0, 1)]
    assert found.extreme(True).energy.overlaps(max(greatest))
    assert found.extreme(False).energy.overlaps(min(least))


few = settings(max_examples=15, deadline=None)


def several(plant: Plant, *degrees: int) -> Turn:
    return turn(plant._replace(cranks=tuple(map(Fraction, degrees))))


@few
@given(plants(), st.integers(2, 5))
def test_cranks_at_one_angle_are_as_irregular_as_one(plant: Plant, count: int) -> None:
    one, together = several(plant, 0), several(plant, *[0] * count)
    assert together.irregularity().overlaps(one.irregularity())
    assert together.mean_force().overlaps(count * one.mean_force())


@few
@given(plants())
def test_two_opposite_cranks_on_infinite_rods_are_as_irregular_as_one(plant: Plant) -> None:
    plant = plant._replace(ratio=Fraction(0), double=True)
    assert several(plant, 0, 180).irregularity().overlaps(several(plant, 0).irregularity())


@few
@given(plants())
def test_two_opposite_single_acting_cranks_on_infinite_rods_are_a_double_acting_one(plant: Plant) -> None:
    plant = plant._replace(ratio=Fraction(0))
    double, halves = several(plant._replace(double=True), 0), several(plant._replace(double=False), 0, 180)
    assert halves.irregularity().overlaps(double.irregularity())


@few
@given(plants(), st.integers(2, 4))
def test_evenly_spaced_cranks_repeat_their_speeds(plant: Plant, count: int) -> None:
    found = several(plant, *(360 * crank // count for crank in range(count)))
    places = stationary(found)
    part = 360 / count
    first = [one for one in places if one[0] < part]
    assert len(places) == count * len(first)
    for index, (degrees, rising) in enumerate(places):
        within, repeat = first[index % len(first)], index // len(first)
        assert rising == within[1]
        assert math.isclose(degrees, within[0] + repeat * part, abs_tol=1e-9)


@few
@given(plants(), st.integers(0, 3))
def test_irregularity_does_not_depend_on_which_crank_is_the_first(plant: Plant, index: int) -> None:
    cranks = plant.cranks
    first = index % len(cranks)
    others = (crank - cranks[first] for crank in (*cranks[first:], *cranks[:first]))
    shifted = plant._replace(cranks=tuple(others))
    assert turn(shifted).irregularity().overlaps(turn(plant).irregularity())


@few
@given(plants())
def test_whole_turns_and_backward_angles_are_the_same_cranks(plant: Plant) -> None:
    moved = plant._replace(cranks=(plant.cranks[0], *(crank - 720 for crank in plant.cranks[1:])))
    assert turn(moved).irregularity().overlaps(turn(plant).irregularity())


@pytest.mark.parametrize("method", ["exact", "series"])
@pytest.mark.parametrize("returning", [False, True])
def test_cut_off_is_where_the_path_is_the_share(method: str, returning: bool) -> None:
    plant = Plant(Fraction(7, 3), Fraction(2, 9), method=method)
    angle = Exact(plant).cut_off_angle(returning)
    assert_holds(turn(plant).cut_off(int(returning)), angle / mp.pi)


def test_without_expansion_the_cut_off_is_the_end_of_the_stroke() -> None:
    found = turn(Plant(Fraction(1), FIFTH, Fraction(0)))
    assert [found.cut_off(stroke) for stroke in (0, 1)] == [1, 1]


# His equations as § 150 prints them; the upper sign is the return stroke.
SIGNS = {0: -1, 1: 1}


@st.composite
def weisbach_plants(draw: st.DrawFn) -> Plant:
    plant = Plant(draw(expansions), draw(hundredths(0, 60)), draw(backs), method="weisbach")
    assume(leaves_work(plant))
    return plant


@few
@given(weisbach_plants())
def test_weisbach_angles_of_the_least_speed_fulfil_his_equation(plant: Plant) -> None:
    found, exact = turn(plant), Exact(plant)
    expansion, half, back = real(plant.expansion), real(plant.ratio) / 2, exact.back
    for stroke, upper in SIGNS.items():
        angle = angle_of(found.extreme(False, stroke).place)
        force = 2 / (mp.pi * (1 - back)) * ((1 + mp.log(expansion)) / expansion - back)
        assert abs(mp.sin(angle) - force - upper * half * mp.sin(2 * angle)) < mp.mpf("1e-50")


@few
@given(weisbach_plants())
def test_weisbach_angles_of_the_greatest_speed_fulfil_his_equation(plant: Plant) -> None:
    found, exact = turn(plant), Exact(plant)
    expansion, ratio, back = real(plant.expansion), real(plant.ratio), exact.back
    for stroke, upper in SIGNS.items():
        if not turns_beyond_cut_off(plant, stroke):
            continue
        angle = angle_of(found.extreme(True, stroke).place)
        square = mp.sin(angle / 2) ** 2
        bracket = 1 + upper * ratio * square
        bracket -= expansion * back * square * (1 - upper * ratio * mp.cos(angle))
        right = (1 + mp.log(expansion) - expansion * back) / (mp.pi * bracket)
        assert abs(mp.cot(angle / 2) - right) < mp.mpf("1e-45")


@few
@given(weisbach_plants())
def test_weisbach_angles_before_cut_off_are_those_of_the_series(plant: Plant) -> None:
    found, series = turn(plant), turn(plant._replace(method="series"))
    for stroke in SIGNS:
        if not turns_beyond_cut_off(plant, stroke):
            assert found.extreme(True, stroke).place.overlaps(series.extreme(True, stroke).place)


def turns_beyond_cut_off(plant: Plant, stroke: int) -> bool:
    series = Exact(plant._replace(method="series"))
    if plant.expansion == 1:
        return False
    angle = stroke * mp.pi + series.cut_off_angle(bool(stroke))
    return bool(series.power(angle) > 2 / mp.pi * mp.quad(series.pressure, [0, series.cut_off, 1]))


def angle_of(place: Any) -> Any:
    return mp.mpf(place.mid().str(DIGITS + 5, radius=False)) * mp.pi


def test_weisbach_best_back_pressure_has_his_simpler_equations() -> None:
    found = turn(Plant(Fraction(3), FIFTH, method="weisbach"))
    for stroke, upper in SIGNS.items():
        least, greatest = (angle_of(found.extreme(which, stroke).place) for which in (False, True))
        right = mp.log(3) / mp.pi + upper * mp.sin(2 * least) / 10
        assert abs(mp.sin(least) - right) < mp.mpf("1e-50")
        bracket = mp.cos(greatest / 2) ** 2 * (1 + upper * mp.mpf("0.4") * mp.sin(greatest / 2) ** 2)
        assert abs(mp.cot(greatest / 2) - mp.log(3) / (mp.pi * bracket)) < mp.mpf("1e-50")


@pytest.mark.parametrize(
    "other",
    [
        {"double": False},
        {"cranks": (Fraction(0), Fraction(90))},
        {"exponent": Fraction(11, 10)},
        {"clearance": Fraction(1, 20)},
    ],
    ids=lambda other: next(iter(other)),
)
def test_weisbach_refuses_what_his_equations_do_not_cover(other: dict[str, Any]) -> None:
    with pytest.raises(ProblemError) as raised:
        turn(Plant(Fraction(2), FIFTH, Fraction(1, 10), method="weisbach", **other))
    assert str(raised.value) == (
        'method "weisbach" is for one double-acting crank, exponent 1 and no clearance, as in § 150;'
        " use exact or series"
    )
