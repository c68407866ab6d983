"""Long columns of engines: floats within their bounds of the balls, and the same digits."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import partial
from typing import Any

import flint
import pytest
from cli import printed
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st

from kurbel.drive.crank import Crank
from kurbel.drive.rod import Moving, Rod
from kurbel.engine.engine import Engine, Load, Steam
from kurbel.engine.loads.compressor import Compressor
from kurbel.engine.long.turn import EnclosedTurn
from kurbel.engine.quantities import Where, engine_registry, value
from kurbel.engine.turn import Turn, turn_of
from kurbel.exact.enclosures.digits import column
from kurbel.motion.long.columns import LongColumns
from kurbel.motion.long.places import Places
from kurbel.reading.notation import Progression
from kurbel.reading.units import Speed

# Newtons of these engines are below 10^7, and everything else below 100.
LARGEST_BOUND = 1e-6
# Degrees.
NEAR = Fraction(1, 2**38)
KEYS = (
    "tangential", "tangential_excess", "energy", "torque_nm", "tangential_kpa", "pin_path", "rod_force",
    "guide_force", "crank_pin_force_n", "radial_force", "bearing_force", "inertia_force", "crosshead_load",
)  # fmt: skip


@pytest.fixture(autouse=True)
def precision() -> Iterator[None]:
    before = flint.ctx.prec
    flint.ctx.prec = 160
    yield
    flint.ctx.prec = before


def shares(low: int, high: int) -> st.SearchStrategy[Fraction]:
    return st.integers(low, high).map(lambda count: Fraction(count, 100))


@st.composite
def engines(draw: st.DrawFn) -> Engine:
    steam: Any = Steam(draw(shares(100, 600)), Fraction(0), draw(shares(80, 160)), draw(shares(0, 20)))
    if draw(st.booleans()):
        steam = Compressor(draw(shares(150, 500)), draw(shares(80, 160)), draw(shares(0, 5)), Fraction(1, 20))
    moving = Moving(Fraction(200), Rod(Fraction(2, 5), Fraction(1, 9), Fraction(100)), Fraction(50))
    offset = draw(st.sampled_from([Fraction(0), Fraction(3, 10)]))
    crank = Crank(draw(shares(0, 70)), offset, Fraction(3, 10), Speed(Fraction(2), turns=True), moving=moving)
    cranks = (Fraction(0), *draw(st.lists(st.integers(1, 359).map(Fraction), max_size=2)))
    return Engine(crank, steam, draw(st.booleans()), cranks, Load(Fraction(3, 10), Fraction(800_000)))


@settings(max_examples=5, deadline=None)
@given(engine=engines(), start=st.integers(-400, 400), step=st.sampled_from(["90", "7/3", "0.1"]))
def test_balls_lie_within_the_bounds_of_floats(engine: Engine, start: int, step: str) -> None:
    turn = turn_of(engine, "exact")
    assert isinstance(turn, Turn)
    enclosed, angles = EnclosedTurn(turn), Progression(Fraction(start), Fraction(step), 4)
    corners = [beside(180 * corner) for corner in turn.corners()][:2]
    for run in (angles, *corners):
        where: Any = Where(half_turns=Places(run))
        for key in KEYS:
            quantity = engine_registry()[key]
            found = column(partial(value, quantity, enclosed, where), len(run))
            assert found is not None
            for near, bound, angle in zip(found.value, found.error, run, strict=True):
                true: arb = value(quantity, turn, Where(half_turns=angle / 180))
                assert not abs(arb(float(near)) - true).lower() > float(bound), (key, angle)
                # Where a float does not tell the stroke, or on which side of a leap it is, it says so.
                assert bound < LARGEST_BOUND or run is not angles or angle % 90 == 0, (key, angle)


def beside(corner: Fraction) -> Progression:
    """Return angles before a corner and behind it, and between them as near as integers of 64 bits are."""
    return Progression(round(corner / NEAR) * NEAR - NEAR, NEAR, 3)


ENGINES = (
    ("--eps=3", "--ratio=1:4", "--back=0.1", "--clearance=5%", "--exponent=1.3", "--cranks=0;77"),
    ("--pressure-ratio=3", "--ratio=1:5", "--offset=0.3", "--suction-loss=3%", "--clearance=4%"),
    (
        "--eps=4",
        "--ratio=1:5",
        "--flywheel=50",
        "--speed=120/min",
        "--columns=phi,tangential,speed,rpm,delta",
    ),
)


@pytest.mark.parametrize("words", ENGINES, ids=lambda words: words[0])
def test_long_tables_have_the_digits_of_short_ones(
    words: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    settled: list[int] = []
    exactly = LongColumns.exactly

    def counted(self: LongColumns, *asked: Any) -> Any:
        settled.append(0)
        return exactly(self, *asked)

    monkeypatch.setattr(LongColumns, "exactly", counted)
    long = printed("turning", *words, "--step=0.05", "--digits=5", "-f", "csv").records()
    assert 0 < len(settled) < len(long) / 50
    rows = {record["phi"]: record for record in long}
    short = printed("turning", *words, "--digits=5", "--angle=0;12.35;77;90;180;291.05;360", "-f", "csv")
    for record in short.records():
        (own,) = (row for phi, row in rows.items() if Fraction(phi) == Fraction(record["phi"]))
        assert {**own, "phi": ""} == {**record, "phi": ""}


def test_records_of_several_engines_stream_in_their_order() -> None:
    words = ("forces", "--eps=2;4", "--ratio=1:4;1:5", "--step=0.25", "-f", "csv")
    columns = "--columns=epsilon,ratio,phi,rod_force,guide_force,tangential_force,radial_force"
    records = printed(*words, columns).records()
    assert [record["epsilon"] for record in records[::1441]] == ["2", "2", "4", "4"]
    assert [record["ratio"] for record in records[::1441]] == ["1:4", "1:5", "1:4", "1:5"]
    assert records[1441 + 4]["phi"] == "1.00"
