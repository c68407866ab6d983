"""Compressors, pumps and gas cycles: strokes against pressures of the textbook, work against closed forms."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction as F
from functools import partial
from typing import Any

import flint
import pytest
from energy_curve import real
from flint import arb
from mpmath import mp

from kurbel.engine.loads.compressor import Compressor
from kurbel.engine.loads.gas import GasCycle
from kurbel.engine.loads.pump import Pump
from kurbel.errors import ProblemError
from kurbel.exact.kind import balls, floats

SHARES = tuple(F(count, 89) for count in (1, 2, 7, 30, 44, 60, 71, 83, 88))
COMPRESSORS = (
    Compressor(F(4)),
    Compressor(F(7, 2), F(27, 20), F(1, 16), F(1, 25), F(1, 15), other_side=F(5, 4)),
    Compressor(F(9), F(13, 10), F(1, 30), other_side=F(2, 3)),
)
CYCLES = (
    GasCycle(F(6), peak=F(28), exponent=F(27, 20), expansion_exponent=F(5, 4), exhaust=F(11, 10)),
    GasCycle(F(16), "diesel", cut_off=F(11, 5)),
    GasCycle(F(14), "dual", peak=F(70), heat=F(7), exhaust=F(21, 20)),
)


def air(load: Compressor, coming: bool, share: Any) -> Any:
    """The pressure in an end, which lies between suction and delivery, in units of p₁."""
    clearance, exponent = real(load.clearance), real(load.exponent)
    suction = 1 - real(load.suction_loss)
    delivery = real(load.ratio) * (1 + real(load.delivery_loss))
    if coming:
        room = clearance + 1 - share
        return min(delivery, suction * ((1 + clearance) / room) ** exponent) if room else delivery
    return max(suction, delivery * (clearance / (clearance + share)) ** exponent)


def gas(load: GasCycle, expanding: bool, share: Any) -> Any:
    """The pressure of compression and of expansion, the latter from the heat supplied step by step."""
    clearance = 1 / (real(load.compression) - 1)
    exponent = real(load.exponent)
    expansion = exponent if load.expansion_exponent is None else real(load.expansion_exponent)
    if not expanding:
        return ((1 + clearance) / (clearance + 1 - share)) ** exponent
    compressed = ((1 + clearance) / clearance) ** exponent
    peak = compressed if load.peak is None else real(load.peak)
    growth = mp.mpf(1) if load.cut_off is None else real(load.cut_off)
    if load.heat is not None:
        # What of the heat is left beyond the rise at one volume moves the piston at the peak pressure.
        left = real(load.heat) * (1 + clearance) - (peak - compressed) * clearance / (exponent - 1)
        growth = 1 + left * (exponent - 1) / exponent / (peak * clearance)
    return min(peak, peak * (clearance * growth / (clearance + share)) ** expansion)


def check_strokes(load: Any, double: bool, forces: list[Callable[[Any], Any]], corners: list[Any]) -> None:
    for found, expected in zip(load.strokes(floats(), double), forces, strict=True):
        for share in SHARES:
            assert float(found.force(float(share))) == pytest.approx(
                float(expected(real(share))), 1e-12, 1e-12
            )
    with flint.ctx.workprec(120), mp.workdps(30):
        for found, expected in zip(load.strokes(balls(), double), forces, strict=True):
            work = mp.quad(expected, sorted({mp.mpf(0), *corners, mp.mpf(1)}))
            assert found.work(arb(1)).overlaps(arb(f"{mp.nstr(work, 28)} +/- 1e-24"))


def corners_of(load: Any, double: bool) -> list[Any]:
    with flint.ctx.workprec(120):
        found = [corner for stroke in load.strokes(balls(), double) for corner in stroke.corners]
        return [mp.mpf(corner.mid().str(30, radius=False)) for corner in found]


@pytest.mark.parametrize("load", COMPRESSORS, ids=range(len(COMPRESSORS)))
def test_a_compressor_has_the_pressures_of_its_ends(load: Compressor) -> None:
    with mp.workdps(30):
        one, other = partial(air, load, False), partial(air, load, True)
        both = [lambda share: one(share) - other(share)] * 2
        check_strokes(load, True, both, corners_of(load, True))
        beyond = real(load.other_side)
        single = [lambda share: one(share) - beyond, lambda share: beyond - other(share)]
        check_strokes(load, False, single, corners_of(load, False))


@pytest.mark.parametrize("load", COMPRESSORS, ids=range(len(COMPRESSORS)))
def test_the_volumetric_efficiency_is_the_share_on_which_air_is_sucked(load: Compressor) -> None:
    with mp.workdps(30):
        inside = real(load.ratio * (1 + load.delivery_loss) / (1 - load.suction_loss))
        clearance = real(load.clearance)
        expected = 1 + clearance - clearance * inside ** (1 / real(load.exponent))
        assert float(load.volumetric_efficiency(floats())) == pytest.approx(float(expected), 1e-14)
        drawn = expected * (1 - real(load.suction_loss))
        assert float(load.delivered(floats())) == pytest.approx(float(drawn), 1e-14)


@pytest.mark.parametrize("ratio", [F(2), F(5), F(11, 2)])
def test_the_work_of_a_compressor_without_losses_is_the_closed_one(ratio: F) -> None:
    """n/(n - 1) (Π^((n-1)/n) - 1) of the air that is sucked, whatever the clearance; n = 1: ln Π."""
    for exponent, clearance in ((F(1), F(1, 20)), (F(7, 5), F(1, 25)), (F(6, 5), F(0))):
        load = Compressor(ratio, exponent, clearance)
        power = float(exponent)
        each = power / (power - 1) * (float(ratio) ** ((power - 1) / power) - 1) if power != 1 else None
        each = float(mp.log(real(ratio))) if each is None else each
        drawn = float(load.volumetric_efficiency(floats()))
        assert -load.strokes(floats(), True)[0].work(1.0) == pytest.approx(each * drawn, 1e-13)


@pytest.mark.parametrize("load", CYCLES, ids=range(len(CYCLES)))
def test_a_gas_cycle_has_the_pressures_of_the_textbook(load: GasCycle) -> None:
    with mp.workdps(30):
        forces = [
            lambda share: gas(load, True, share) - 1,
            lambda share: 1 - real(load.exhaust),
            lambda share: mp.mpf(0),
            lambda share: 1 - gas(load, False, share),
        ]
        check_strokes(load, False, forces, corners_of(load, False))


def test_the_efficiency_is_work_over_heat() -> None:
    for cycle, told in (
        ("otto", {"heat": F(9)}),
        ("diesel", {"heat": F(8)}),
        ("dual", {"heat": F(11), "peak": F(80)}),
    ):
        load = GasCycle(F(15), cycle, exponent=F(4, 3), two_stroke=True, **told)
        work = sum(float(stroke.work(1.0)) for stroke in load.strokes(floats(), False))
        volume = 1 + 1 / 14
        assert float(load.efficiency(floats())) == pytest.approx(work / (float(told["heat"]) * volume), 1e-12)
    otto = GasCycle(F(6), peak=F(40), exponent=F(7, 5))
    assert float(otto.efficiency(floats())) == pytest.approx(1 - 6**-0.4, 1e-14)


def test_a_pump_moves_the_same_with_each_kind() -> None:
    """The work of a turn is what is delivered, against the pressure that the pump makes."""
    suction = F(-1, 7)
    delivers = {"double": 2, "single": 1, "differential": 1}
    for kind, times in delivers.items():
        load = Pump(kind, suction, F(2, 5))
        assert sum(float(one.work(1.0)) for one in load.strokes(floats(), load.double)) == pytest.approx(
            -times
        )
    out, back = Pump("single", suction).strokes(floats(), False)
    assert (out.force(0.3), back.force(0.3)) == pytest.approx((-1 / 7, -6 / 7))
    # The ring takes a share of what the piston delivers and gives it back on the outstroke.
    out, back = Pump("differential", F(0), F(2, 5)).strokes(floats(), False)
    assert (out.force(0.3), back.force(0.3)) == pytest.approx((-0.4, -0.6))
    out, back = Pump("differential").strokes(floats(), False)
    assert out.force(0.3) == back.force(0.3) == -0.5


@pytest.mark.parametrize(
    ("build", "said"),
    [
        (lambda: Compressor(F(1, 2)), "pressure ratio Π is 0.5; it must be above 1,"),
        (lambda: Compressor(F(8), clearance=F(1, 4)), "it must be below 0.142857, or Π below 5"),
        (lambda: Compressor(F(8), suction_loss=F(1)), "suction loss is 1; it must be 0 or more and below 1,"),
        (lambda: Pump(small_area=F(1)), "the small area is 1; it must be above 0 and below 1,"),
        (lambda: GasCycle(F(5)), "the Otto cycle needs --heat or --peak-pressure, for example"),
        (lambda: GasCycle(F(5), peak=F(4)), "it must be at least the 9.51827 times of the gas compressed"),
        (lambda: GasCycle(F(5), "diesel", cut_off=F(6)), "the cut-off ratio is 6; it must lie within 1..5,"),
        (lambda: GasCycle(F(5), "diesel", cut_off=F(1)), "leaves no work at ε = 5; supply more heat"),
    ],
)
def test_what_does_not_run_is_refused_with_the_bound(build: Callable[[], object], said: str) -> None:
    with pytest.raises(ProblemError) as caught:
        build()
    assert said in str(caught.value)


def test_the_bounds_of_clearance_and_ratio_are_those_that_leave_nothing() -> None:
    """Just below the bounds of the sentence something is delivered."""
    assert Compressor(F(8), clearance=F(142857, 10**6)).volumetric_efficiency(floats()) > 0
    assert Compressor(F(4999, 1000), clearance=F(1, 4)).volumetric_efficiency(floats()) > 0
