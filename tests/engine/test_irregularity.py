"""δ in bulk: against § 150 in mpmath, a walk along the curve of excess work, and the certified pages."""

from __future__ import annotations

import doctest
import sys
import tracemalloc
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from itertools import product
from typing import Any

import numpy as np
import pytest
from cli import printed
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp
from numpy.typing import NDArray
from pace import within

import kurbel
from kurbel import compute_delta
from kurbel.kernel import kinematics
from kurbel.kernel.circle import circle
from kurbel.kernel.irregularity import (
    METHODS,
    MOST_STEPS,
    engine,
    exact,
    extremes,
    first_order,
)

# mpmath has no types.
Real = Any
Floats = NDArray[np.float64]

DIGITS = 30
ACCURACY = 2e-15

EDGES = [
    (1 + 1e-9, 0.3, None),
    (1 + 1e-9, 0.3, 0.5),
    (1.0, 0.4, 0.0),
    (1.0, 0.0, 0.999),
    (1.0001, 0.99, 0.9999),
    (1.12, 0.2, 0.1),
    (1.14, 0.2, 0.1),
    (1.13, 0.0, 0.0),
    (8.5, 0.999, 0.0),
    (8.5, 0.999999, 1e-9),
    (9.0, 0.9999999, 0.01),
    (5.0, 1 - 1e-9, None),
    (3.0, 0.0, None),
    (3.0, 1e-9, 0.2),
    (3.0, 1e-18, 0.45),
    (1e6, 0.2, None),
    (1e12, 0.95, 0.0),
    (1000.0, 0.99, 0.0079),
]


class Paper:
    """One engine in the formulas of § 150 as printed, s and c by the textbook, both strokes from α = 0."""

    def __init__(self, eps: float, ratio: float, back: float | None, method: str) -> None:
        self.eps, self.ratio, self.method = mp.mpf(eps), mp.mpf(ratio), method
        self.back = 1 / self.eps if back is None else mp.mpf(back)
        self.mean = 2 / mp.pi * ((1 + mp.log(self.eps)) / self.eps - self.back)

    def path(self, angle: Real, rod: Real) -> Real:
        if self.method != "exact" or not rod:
            return 1 - mp.cos(angle) + rod / 2 * mp.sin(angle) ** 2
        return 1 - mp.cos(angle) + (1 - mp.sqrt(1 - (rod * mp.sin(angle)) ** 2)) / rod

    def velocity(self, angle: Real, rod: Real) -> Real:
        if self.method != "exact":
            return mp.sin(angle) + rod / 2 * mp.sin(2 * angle)
        psi = mp.asin(rod * mp.sin(angle))
        return mp.sin(angle + psi) / mp.cos(psi)

    def force(self, angle: Real, rod: Real) -> Real:
        """Tangential force of the expanding steam less its mean."""
        pressure = 2 / (self.eps * self.path(angle, rod)) - self.back
        return pressure * self.velocity(angle, rod) - self.mean

    def surplus(self, angle: Real, rod: Real) -> Real:
        """The same before the cut-off."""
        return (1 - self.back) * self.velocity(angle, rod) - self.mean

    def relation(self, angle: Real, rod: Real) -> Real:
        square, loss = mp.sin(angle / 2) ** 2, self.eps * self.back
        bracket = 1 - rod * square - loss * square * (1 + rod * mp.cos(angle))
        return mp.cot(angle / 2) * mp.pi * bracket - (1 + mp.log(self.eps) - loss)

    def work(self, angle: Real, rod: Real) -> Real:
        path, cut_off = self.path(angle, rod), 2 / self.eps
        steam = path if path <= cut_off else cut_off * (1 + mp.log(path / cut_off))
        return steam - self.back * path - self.mean * angle

    def extremes(self, rod: Real) -> tuple[Real, Real]:
        first = between(lambda angle: self.surplus(angle, rod), mp.mpf(0), mp.pi / 2)
        cut_off = mp.pi
        if self.eps > 1:
            cut_off = between(lambda angle: self.path(angle, rod) - 2 / self.eps, mp.mpf(0), mp.pi)
        if self.eps == 1 or self.force(cut_off, rod) <= 0:
            last = between(lambda angle: self.surplus(angle, rod), mp.pi / 2, mp.pi)
        elif self.method == "weisbach":
            last = between(lambda angle: self.relation(angle, rod), mp.mpf(10) ** -9, mp.pi)
        else:
            last = between(lambda angle: self.force(angle, rod), cut_off, mp.pi)
        return self.work(first, rod), self.work(last, rod)

    @property
    def irregularity(self) -> float:
        least, greatest = zip(*map(self.extremes, (self.ratio, -self.ratio)), strict=True)
        return float((max(greatest) - min(least)) / self.mean)


class Cylinder(Paper):
    """One engine by p V^n = const from the volume at cut-off on, clearance included, as on paper."""

    def __init__(
        self, eps: float, ratio: float, back: float | None, clearance: float, exponent: float, method: str
    ) -> None:
        super().__init__(eps, ratio, back, method)
        self.cut, self.dead = 1 / self.eps, mp.mpf(clearance)
        self.exponent = mp.mpf(exponent)
        self.back = self.pressure(mp.mpf(1)) if back is None else mp.mpf(back)
        self.gained = self.steam(mp.mpf(1))
        self.mean = 2 / mp.pi * (self.gained - self.back)

    def pressure(self, share: Real) -> Real:
        return 1 if share <= self.cut else ((self.cut + self.dead) / (share + self.dead)) ** self.exponent

    def steam(self, share: Real) -> Real:
        """Return the work of the steam up to a share of the stroke."""
        if share <= self.cut:
            return share
        begin, volume, rest = self.cut + self.dead, share + self.dead, 1 - self.exponent
        if rest == 0:
            return self.cut + begin * mp.log(volume / begin)
        return self.cut + begin**self.exponent * (volume**rest - begin**rest) / rest

    def both(self) -> tuple[float, float]:
        """Return δ, and how much larger a relative error of it is than one of the works it is made of."""
        found = []
        for rod in (self.ratio, -self.ratio):

            def excess(angle: Real, rod: Real = rod) -> Real:
                share = self.path(angle, rod) / 2
                return (self.pressure(share) - self.back) * self.velocity(angle, rod) - self.mean

            def energy(angle: Real, rod: Real = rod) -> Real:
                share = self.path(angle, rod) / 2
                return 2 * (self.steam(share) - self.back * share) - self.mean * angle

            grid = [mp.pi * step / 90 for step in range(91)]
            signs = [excess(angle) > 0 for angle in grid]
            turns = [place for place in range(90) if signs[place] != signs[place + 1]]
            assert len(turns) <= 2
            found += [energy(between(excess, grid[turn], grid[turn + 1])) for turn in turns]
        total = (max(found) - min(found)) / self.mean
        return float(total), float((self.gained + self.back) / (self.gained - self.back))


def between(function: Callable[[Real], Real], low: Real, high: Real) -> Real:
    """Return the zero between two places, by halving: nothing is trusted but the signs."""
    rising = function(high) > 0
    assert rising != (function(low) > 0)
    # Work is stationary there: half the digits of the angle are enough for all of δ.
    while high - low > mp.mpf(10) ** -(DIGITS // 2 + 3) * high:
        middle = (low + high) / 2
        if (function(middle) > 0) == rising:
            high = middle
        else:
            low = middle
    return low


def on_paper(eps: float, ratio: float, back: float | None, method: str) -> float:
    # The mean force of an engine that hardly works takes digits away.
    with mp.workdps(DIGITS + 20):
        return Paper(eps, ratio, back, method).irregularity


def condition(eps: float, back: float | None) -> float:
    """Return how much larger a relative error of δ is than one of b."""
    return 1.0 if back is None else 1 + eps * back / (1 + float(np.log(eps)) - eps * back)


def random_engine(random: np.random.Generator, kind: int) -> tuple[float, float, float | None]:
    """Return ε, λ, b with b, by its kind, absent, below the best or beyond it."""
    eps = float(np.exp(random.uniform(np.log(1.0001), np.log(1000))))
    most = (1 + np.log(eps)) / eps
    backs = None, random.uniform(0, 1 / eps), random.uniform(1 / eps, most - 0.01 * (most - 1 / eps))
    return eps, float(random.uniform(0, 0.99)), backs[kind]


def assert_on_paper(eps: float, ratio: float, back: float | None, method: str) -> None:
    expected = on_paper(eps, ratio, back, method)
    found = compute_delta(eps, ratio, back, method=method)
    assert abs(found / expected - 1) <= ACCURACY * condition(eps, back), (eps, ratio, back, found, expected)


@pytest.mark.parametrize(("method", "kind"), [*product(METHODS, range(3))])
def test_random_engines_are_those_on_paper(method: str, kind: int) -> None:
    random = np.random.default_rng(kind)
    for _ in range(6):
        assert_on_paper(*random_engine(random, kind), method)


def test_the_largest_expansions_keep_all_digits() -> None:
    # Their cut-off is at 1e-150 of a turn, where 1 - cos α needs 300 digits.
    with mp.workdps(340):
        expected = Paper(1e300, 0.5, None, "series").irregularity
    np.testing.assert_allclose(compute_delta(1e300, 0.5, method="series"), expected, rtol=ACCURACY, atol=0)


@pytest.mark.parametrize("method", ["exact", "series"])
@pytest.mark.parametrize(("eps", "ratio", "back"), EDGES)
def test_edges_are_those_on_paper(eps: float, ratio: float, back: float | None, method: str) -> None:
    assert_on_paper(eps, ratio, back, method)


@pytest.mark.parametrize(("eps", "ratio", "back"), [edge for edge in EDGES if edge[1] <= 0.5])
def test_edges_of_weisbachs_equations_are_those_on_paper(
    eps: float, ratio: float, back: float | None
) -> None:
    assert_on_paper(eps, ratio, back, "weisbach")


def test_weisbachs_greatest_speed_may_be_that_of_the_return_stroke() -> None:
    with mp.workdps(DIGITS):
        paper = Paper(1.35, 0.9, 0.958, "weisbach")
        assert paper.extremes(-paper.ratio)[1] > paper.extremes(paper.ratio)[1]
    assert_on_paper(1.35, 0.9, 0.958, "weisbach")


@pytest.mark.parametrize("method", METHODS)
def test_it_agrees_with_the_certified_pages(method: str) -> None:
    plain: list[dict[str, Any]] = [
        {"eps": "1.12", "ratio": "0.21", "back": "0.15"},
        {"eps": "3.5", "ratio": "0.3"},
        {"eps": "3.5", "ratio": "0.85", "back": "0.4"},
        # The least speed comes after the cut-off; the ratio is 1 - 2**-17.
        {"eps": "1000000", "ratio": "0.99999237060546875"},
    ]
    volumes: list[dict[str, Any]] = [
        {"eps": "3.5", "ratio": "0.3", "clearance": "0.04", "exponent": "1.13"},
        {"eps": "12", "ratio": "0.2", "back": "0.1", "clearance": "0.6", "exponent": "1"},
    ]
    for options in plain if method == "weisbach" else plain + volumes:
        page = kurbel.delta(**options, method=method, columns="delta", digits=18)
        numbers: dict[str, Any] = {key: float(value) for key, value in options.items()}
        certified = float(kurbel.typeset(page, "csv").split()[-1])
        np.testing.assert_allclose(compute_delta(**numbers, method=method), certified, rtol=1e-14, atol=0)


def walked(
    eps: float, ratio: float, back: float, method: str, clearance: float, exponent: float
) -> tuple[float, float]:
    """Return δ on a grid of both strokes, and by how much the curve may rise above its grid."""
    angle, cut, begin = np.linspace(0, np.pi, 20_001), 1 / eps, 1 / eps + clearance
    rest = 1 - exponent

    def steam(share: Any) -> Any:
        grown = np.maximum((share + clearance) / begin, 1)
        return np.minimum(share, cut) + begin * (np.log(grown) if rest == 0 else (grown**rest - 1) / rest)

    mean, strokes = 2 / np.pi * (float(steam(np.array(1.0))) - back), []
    for rod in (ratio, -ratio):
        drop = np.sin(angle) ** 2 * rod
        slant = drop / 2 if method == "series" else drop / (1 + np.sqrt(1 - (rod * np.sin(angle)) ** 2))
        share = (1 - np.cos(angle) + slant) / 2
        strokes.append(2 * (steam(share) - back * share) - mean * angle)
    energy = np.array(strokes)
    return float(np.ptp(energy)) / mean, float(np.abs(np.diff(energy, 2)).max()) / 4 / mean


@given(
    eps=st.floats(1.05, 300),
    ratio=st.floats(0, 0.95),
    share=st.floats(0, 0.95),
    method=st.sampled_from(["exact", "series"]),
    clearance=st.one_of(st.just(0.0), st.floats(0, 10)),
    exponent=st.sampled_from([1.0, 0.05, 0.5, 0.97, 1.2, 1.41, 4.0]),
)
def test_the_curve_of_excess_work_never_leaves_the_range(
    eps: float, ratio: float, share: float, method: str, clearance: float, exponent: float
) -> None:
    # The mean pressure of the steam is above that at the end of the stroke.
    end = ((1 / eps + clearance) / (1 + clearance)) ** exponent
    back = share * ((1 + np.log(eps)) / eps if clearance == 0 and exponent == 1 else end)
    found = compute_delta(eps, ratio, back, clearance=clearance, exponent=exponent, method=method)
    grid, resolution = walked(eps, ratio, back, method, clearance, exponent)
    assert grid * (1 - 1e-12) <= found <= grid * (1 + 1e-12) + 1.5 * resolution


@pytest.mark.parametrize("motion", [exact, first_order])
@given(ratio=st.floats(0, 0.95), tangent=st.floats(1e-6, 100))
def test_the_unknown_stands_for_an_angle_and_a_place(motion: Any, ratio: float, tangent: float) -> None:
    path: Any = kinematics.piston_path
    velocity: Any = kinematics.piston_velocity
    if motion is first_order:
        path, velocity = kinematics.piston_path_first_order, kinematics.piston_velocity_first_order
    place, step = motion(ratio, tangent), 1e-5
    # From the inner dead centre, the rod makes the angle of the other sign count.
    angle, rest = np.degrees(2 * np.arctan(place.angle)), np.degrees(2 * np.arctan(1 / place.angle))
    assert 2 * place.share == pytest.approx(path(circle(float(angle)), -ratio), rel=1e-12)
    assert 2 * place.rest == pytest.approx(path(circle(float(rest)), ratio), rel=1e-12)
    assert place.velocity == pytest.approx(velocity(circle(float(rest)), ratio), rel=1e-11)
    before, after = motion(ratio, tangent * (1 - step)), motion(ratio, tangent * (1 + step))
    assert place.fall == pytest.approx((after.share - before.share) / (2 * step), rel=1e-6, abs=1e-10)
    rise = np.log(after.velocity / before.velocity) / (2 * step)
    assert place.rise == pytest.approx(rise, rel=1e-6, abs=1e-8)


@pytest.mark.parametrize("motion", METHODS.values())
def test_few_engines_need_more_steps_and_those_end_at_the_root(motion: Any) -> None:
    eps, ratio, back = many(20_000)
    assert np.mean(extremes(motion, engine(eps, 0.95 * ratio, back))[0] > 0) < 0.01
    random = np.random.default_rng(8)
    eps = np.exp(random.uniform(0.01, 30, 20_000))
    ratio = 1 - 10 ** random.uniform(-15, -1, eps.size)
    back = 10 ** random.uniform(-12, -0.01, eps.size) * (1 + np.log(eps)) / eps
    assert (extremes(motion, engine(eps, ratio, back), MOST_STEPS)[0] <= 0).all()


@pytest.mark.parametrize("method", ["exact", "series"])
def test_hard_engines_are_those_on_paper(method: str) -> None:
    random = np.random.default_rng(10)
    for _ in range(8):
        eps, short = np.exp(random.uniform(0.01, 7)), 10 ** random.uniform(-9, -1)
        spare = 10 ** random.uniform(-6, -0.01)
        assert_on_paper(float(eps), 1 - short, float((1 - spare) * (1 + np.log(eps)) / eps), method)


@given(
    st.lists(st.tuples(st.floats(1.01, 1e6), st.floats(0, 0.999999), st.floats(0, 0.9999)), max_size=20),
    st.sampled_from(list(METHODS)),
)
def test_an_engine_has_the_same_bits_alone_and_among_others(
    engines: list[tuple[float, float, float]], method: str
) -> None:
    rows = [(eps, ratio, share * (1 + np.log(eps)) / eps) for eps, ratio, share in engines]
    together = compute_delta(*(np.array([row[place] for row in rows]) for place in range(3)), method=method)
    assert np.asarray(together).tolist() == [compute_delta(*row, method=method) for row in rows]


# Cut-off long before the greatest force and long behind it, slow and steep expansion, least speed on either
# side of the cut-off, hardly any expansion, a long rod and one near R:L = 1.
ENGINES = [
    (4.0, 0.2, None, 0.04, 1.0),
    (6.0, 0.25, 0.1, 0.07, 1.13),
    (50.0, 0.2, None, 0.3, 1.0),
    (100.0, 0.3, 0.1, 10.0, 1.0),
    (27.9, 0.254, 0.6396, 3.4, 0.2),
    (36.9, 0.008, 0.0407, 0.0122, 3.0),
    (72.4, 0.586, None, 0.0512, 3.0),
    (1.0001, 0.5, None, 0.05, 1.0),
    (1.02, 0.0, None, 0.05, 1.3),
    (3.0, 0.99, 0.2, 0.04, 1 + 1e-9),
    (300.0, 0.4, 0.0, 0.001, 0.9),
    (4.7, 0.21, 0.1, None, 1.3),
    (3.3, 0.26, None, None, 0.9),
    (5.2, 0.23, 0.05, 0.06, None),
]


@pytest.mark.parametrize("engine", ENGINES, ids=str)
def test_clearance_and_exponent_are_those_of_the_definition(engine: Any) -> None:
    eps, ratio, back, clearance, exponent = engine
    for method in ("exact", "series"):
        with mp.workdps(DIGITS):
            expected, condition = Cylinder(eps, ratio, back, clearance or 0, exponent or 1, method).both()
        found = compute_delta(eps, ratio, back, clearance=clearance, exponent=exponent, method=method)
        assert abs(found / expected - 1) <= 2 * ACCURACY * condition


def test_no_clearance_and_exponent_1_are_the_plain_engine() -> None:
    eps, ratio, back = np.linspace(1.1, 40, 50), np.linspace(0, 0.9, 50), 0.02
    kinds: list[dict[str, Any]] = [{"clearance": 0}, {"exponent": 1}, {"clearance": 0, "exponent": 1}]
    for more, method in product(kinds, METHODS):
        plain = np.asarray(compute_delta(eps, ratio, back, method=method))
        assert (np.asarray(compute_delta(eps, ratio, back, **more, method=method)) == plain).all()
    # Among others, too.
    mixed = np.asarray(compute_delta(eps, ratio, back, exponent=np.tile([1.0, 1.2], 25)))
    assert (mixed[::2] == np.asarray(compute_delta(eps, ratio, back))[::2]).all()


# numba takes seconds to compile all of them.
ALL = ["best", "back", "clearance", "exponent"]
LOOPS = [
    ("exact", "back"),
    *(
        pytest.param(method, kind, marks=pytest.mark.slow)
        for method, kinds in [("exact", ALL[:1] + ALL[2:]), ("series", ALL), ("weisbach", ["best", "back"])]
        for kind in kinds
    ),
]


@pytest.mark.parametrize(("method", "kind"), LOOPS)
def test_a_loop_has_the_same_bits_as_arrays(method: str, kind: str) -> None:
    random = np.random.default_rng(17)
    eps = np.concatenate([np.exp(random.uniform(1e-9, 7, 20_000)), 10.0 ** random.uniform(0, 200, 5_000)])
    ratio = 1 - 10 ** random.uniform(-12, 0, eps.size)
    more: dict[str, Any] = {"method": method}
    if kind in ("clearance", "exponent"):
        more["clearance"] = random.uniform(0, 2, eps.size)
    if kind == "exponent":
        eps, more["exponent"] = np.minimum(eps, 1000), 1.2
    back = None if kind == "best" else random.uniform(0, 0.5, eps.size) * (1 + np.log(eps)) / eps
    plain = np.asarray(compute_delta(eps, ratio, back, fast=False, **more))
    assert np.isfinite(plain).all()
    assert (
        np.asarray(compute_delta(eps, ratio, back, fast=True, **more)).view(np.int64) == plain.view(np.int64)
    ).all()


def many(count: int) -> tuple[Floats, Floats, Floats]:
    random = np.random.default_rng(count)
    eps = random.uniform(1.1, 50, count)
    return eps, random.uniform(0, 0.999, count), random.uniform(0, 0.98, count) * (1 + np.log(eps)) / eps


@pytest.mark.parametrize("method", METHODS)
def test_order_and_blocks_do_not_matter(method: str, monkeypatch: pytest.MonkeyPatch) -> None:
    engines = many(5000)
    order = np.random.default_rng(0).permutation(5000)
    whole = np.asarray(compute_delta(*engines, method=method))
    assert (np.asarray(compute_delta(*(one[order] for one in engines), method=method)) == whole[order]).all()
    monkeypatch.setattr("kurbel.exact.bulk.BLOCK", 617)
    assert (np.asarray(compute_delta(*engines, method=method)) == whole).all()


def test_arrays_broadcast_however_they_lie_in_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("kurbel.exact.bulk.BLOCK", 7)
    eps, ratio = np.linspace(1.5, 6, 8)[::2, None], np.linspace(0, 0.4, 5)
    back = np.linspace(0, 0.1, 20).reshape(5, 4).T
    found = np.asarray(compute_delta(eps, ratio, back))
    assert found.shape == (4, 5)
    for row, column in np.ndindex(4, 5):
        assert found[row, column] == compute_delta(
            float(eps[row, 0]), float(ratio[column]), float(back[row, column])
        )


def test_numbers_give_a_float_and_arrays_an_array() -> None:
    assert type(compute_delta(2, "1:5")) is float
    assert type(compute_delta(np.float64(2), Fraction(1, 5), Decimal("0.5"))) is float  # type: ignore[call-overload]
    assert np.asarray(compute_delta([2], 0.2)).shape == (1,)
    assert np.asarray(compute_delta([[2]], [0.2])).shape == (1, 1)
    assert np.asarray(compute_delta([], 0.2)).shape == (0,)
    assert np.asarray(compute_delta(np.full((0, 3), 2.0), [0.1, 0.2, 0.3], 0.1)).shape == (0, 3)


def test_a_ratio_may_be_text() -> None:
    assert compute_delta(3, "1:4,5") == compute_delta(3, 1 / 4.5)


def test_the_arguments_are_left_as_they_are() -> None:
    engines = many(100)
    copies = [one.copy() for one in engines]
    compute_delta(*engines)
    for one, copy in zip(engines, copies, strict=True):
        assert (one == copy).all()


def test_memory_is_bounded_by_the_result_and_a_block_a_core(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("kurbel.exact.bulk.cores", lambda: 2)
    peaks = []
    for count in (200_000, 1_000_000):
        eps, ratio = np.linspace(1.1, 9, count), np.linspace(0, 0.5, count)
        tracemalloc.start()
        compute_delta(eps, ratio, 0.05)
        peaks.append(tracemalloc.get_traced_memory()[1] - 8 * count)
        tracemalloc.stop()
    assert peaks[1] < peaks[0] + 1e6
    assert peaks[1] < 64e6


def test_the_first_bad_engine_of_all_blocks_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("kurbel.exact.bulk.BLOCK", 10)
    back = np.full(100, 0.3)
    back[[37, 38, 91]] = 0.9
    with pytest.raises(kurbel.KurbelError, match=r"^back\[37\] leaves no work"):
        compute_delta(2, 0.2, back)


def test_the_example_of_the_docstring_is_true() -> None:
    result = doctest.testmod(sys.modules[compute_delta.__module__])
    assert (result.failed, result.attempted) == (0, 1)


def test_ten_thousand_engines_have_the_digits_of_each_alone() -> None:
    with within(240):
        many = printed("delta", "--eps=1.001..11:0.001", "--digits=10", "-f", "csv").records()
    assert len(many) == 10_000
    # So few are settled in balls.
    few = printed("delta", "--eps=1.001..11:0.1", "--digits=10", "-f", "csv").records()
    assert few == many[::100]
    for record in many[1234::2345]:
        true = on_paper(float(record["epsilon"]), 0.2, None, "exact")
        assert abs(float(record["delta"]) - true) < 0.5e-10 + 1e-15


def test_of_an_infinite_rod_the_ratio_is_0() -> None:
    (row,) = printed(
        "delta", "--eps=4", "--ratio=1:∞", "--columns=delta", "--digits=9", "-f", "csv"
    ).records()
    assert float(compute_delta(4, 0)) == pytest.approx(float(row["delta"]), abs=1e-9)
