"""δ in bulk with clearance and an exponent: against the definition in mpmath and the certified pages."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import flint
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp

from kurbel.drive.crank import Crank
from kurbel.engine.engine import Engine, Steam
from kurbel.engine.irregularity import delta
from kurbel.engine.turn import turn_of
from kurbel.errors import ProblemError

# mpmath has no types.
Real = Any
DIGITS = 30
ACCURACY = 4e-15


class Cylinder:
    """One engine by p V^n = const from the volume at cut-off on, clearance included, as on paper."""

    def __init__(
        self, eps: float, ratio: float, back: float | None, clearance: float, exponent: float
    ) -> None:
        self.ratio, self.cut, self.dead = mp.mpf(ratio), 1 / mp.mpf(eps), mp.mpf(clearance)
        self.exponent = mp.mpf(exponent)
        end = self.pressure(mp.mpf(1))
        self.back = end if back is None else mp.mpf(back)
        self.gained = self.steam(mp.mpf(1))
        self.work = self.gained - self.back
        self.mean = 2 / mp.pi * self.work

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

    def path(self, angle: Real, rod: Real, series: bool) -> Real:
        if series or not rod:
            return 1 - mp.cos(angle) + rod / 2 * mp.sin(angle) ** 2
        return 1 - mp.cos(angle) + (1 - mp.sqrt(1 - (rod * mp.sin(angle)) ** 2)) / rod

    def velocity(self, angle: Real, rod: Real, series: bool) -> Real:
        if series:
            return mp.sin(angle) + rod / 2 * mp.sin(2 * angle)
        psi = mp.asin(rod * mp.sin(angle))
        return mp.sin(angle + psi) / mp.cos(psi)

    def irregularity(self, series: bool) -> tuple[float, float]:
        """Return δ, and how much larger a relative error of it is than one of the works it is made of."""
        found = []
        for rod in (self.ratio, -self.ratio):

            def excess(angle: Real, rod: Real = rod) -> Real:
                share = self.path(angle, rod, series) / 2
                speed = self.velocity(angle, rod, series)
                return (self.pressure(share) - self.back) * speed - self.mean

            def energy(angle: Real, rod: Real = rod) -> Real:
                share = self.path(angle, rod, series) / 2
                return 2 * (self.steam(share) - self.back * share) - self.mean * angle

            grid = [mp.pi * step / 90 for step in range(91)]
            signs = [excess(angle) > 0 for angle in grid]
            turns = [place for place in range(90) if signs[place] != signs[place + 1]]
            assert len(turns) <= 2
            found += [energy(_zero(excess, grid[turn], grid[turn + 1])) for turn in turns]
        total = (max(found) - min(found)) / self.mean
        return float(total), float((self.gained + self.back) / self.work)


def _zero(function: Any, low: Real, high: Real) -> Real:
    rising = function(high) > 0
    for _ in range(42):
        middle = (low + high) / 2
        low, high = (low, middle) if (function(middle) > 0) == rising else (middle, high)
    return low


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
            cylinder = Cylinder(eps, ratio, back, clearance or 0, exponent or 1)
            expected, condition = cylinder.irregularity(method == "series")
        found = delta(eps, ratio, back, clearance=clearance, exponent=exponent, method=method)
        assert abs(found / expected - 1) <= ACCURACY * condition


def walked(eps: float, ratio: float, back: float, clearance: float, exponent: float) -> tuple[float, float]:
    """Return δ on a grid of both strokes, and by how much the curve may rise above its grid."""
    angle, cut, begin = np.linspace(0, np.pi, 20_001), 1 / eps, 1 / eps + clearance
    rest = 1 - exponent

    def steam(share: Any) -> Any:
        grown = np.maximum((share + clearance) / begin, 1)
        return np.minimum(share, cut) + begin * (np.log(grown) if rest == 0 else (grown**rest - 1) / rest)

    work = float(steam(np.array(1.0))) - back
    strokes = []
    for rod in (ratio, -ratio):
        drop = np.sin(angle) ** 2 * rod
        share = (1 - np.cos(angle) + drop / (1 + np.sqrt(1 - (rod * np.sin(angle)) ** 2))) / 2
        strokes.append(2 * (steam(share) - back * share) - 2 / np.pi * work * angle)
    mean, energy = 2 / np.pi * work, np.array(strokes)
    return float(np.ptp(energy)) / mean, float(np.abs(np.diff(energy, 2)).max()) / 4 / mean


@given(
    eps=st.floats(1.05, 300),
    ratio=st.floats(0, 0.95),
    share=st.floats(0, 0.9),
    clearance=st.floats(0, 10),
    exponent=st.sampled_from([1.0, 0.05, 0.5, 0.97, 1.2, 1.41, 4.0]),
)
def test_the_curve_of_excess_work_never_leaves_the_range(
    eps: float, ratio: float, share: float, clearance: float, exponent: float
) -> None:
    # The mean pressure of the steam is above that at the end of the stroke.
    end = ((1 / eps + clearance) / (1 + clearance)) ** exponent
    back = share * end
    found = delta(eps, ratio, back, clearance=clearance, exponent=exponent)
    grid, resolution = walked(eps, ratio, back, clearance, exponent)
    assert grid * (1 - 1e-12) <= found <= grid * (1 + 1e-12) + 1.5 * resolution


def test_they_agree_with_the_certified_pages() -> None:
    for eps, ratio, back, clearance, exponent in [
        ("3.5", "0.3", None, "0.04", "1.13"),
        ("12", "0.2", "0.1", "0.6", "1"),
    ]:
        steam = Steam(
            Fraction(eps), None if back is None else Fraction(back), Fraction(exponent), Fraction(clearance)
        )
        with flint.ctx.workprec(120):
            certified = float(turn_of(Engine(Crank(Fraction(ratio)), steam), "exact").irregularity())
        number = None if back is None else float(back)
        found = delta(float(eps), float(ratio), number, clearance=float(clearance), exponent=float(exponent))
        np.testing.assert_allclose(found, certified, rtol=1e-14, atol=0)


def test_no_clearance_and_exponent_1_are_the_plain_engine() -> None:
    eps, ratio, back = np.linspace(1.1, 40, 50), np.linspace(0, 0.9, 50), 0.02
    plain = np.asarray(delta(eps, ratio, back))
    kinds: list[dict[str, Any]] = [{"clearance": 0}, {"exponent": 1}, {"clearance": 0, "exponent": 1}]
    for more in kinds:
        np.testing.assert_allclose(np.asarray(delta(eps, ratio, back, **more)), plain, rtol=2e-14, atol=0)


# numba takes seconds to compile all of them.
LOOPS = [
    ("exact", "back"),
    *(
        pytest.param(method, kind, marks=pytest.mark.slow)
        for method in ("exact", "series")
        for kind in ("best", "back", "clearance", "exponent")
        if (method, kind) != ("exact", "back")
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
    plain = np.asarray(delta(eps, ratio, back, fast=False, **more))
    assert np.isfinite(plain).all()
    assert (
        np.asarray(delta(eps, ratio, back, fast=True, **more)).view(np.int64) == plain.view(np.int64)
    ).all()


SENTENCES = [
    ({"clearance": [0.1, -0.1]}, "clearance[1] is -0.1; it must lie within 0..10"),
    ({"clearance": 11}, "clearance is 11; it must lie within 0..10"),
    ({"exponent": 0}, "exponent is 0; it must be above 0 and at most 10"),
    ({"exponent": [1, np.nan]}, "exponent[1] is nan; it must be above 0"),
    ({"clearance": 0.1, "method": "weisbach"}, 'method "weisbach" has neither clearance nor exponent; use'),
    ({"clearance": [0.1, 0.2]}, "eps, ratio and clearance have the shapes (3,), (), (2,); they do not"),
    ({"back": 0.9, "clearance": 0.01}, "back[1] leaves no work: the mean force P would not be above 0"),
]


@pytest.mark.parametrize(("more", "sentence"), SENTENCES)
def test_a_cylinder_that_cannot_be_is_named_in_one_sentence(more: Any, sentence: str) -> None:
    with pytest.raises(ProblemError) as raised:
        delta([1.2, 2, 3], 0.2, **more)
    assert str(raised.value).startswith(sentence)
