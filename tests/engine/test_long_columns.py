"""Long columns of engines: the digits of short ones, and of the bodies' equations of motion, row by row."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from cli import printed, records
from figures import figures
from machines import machine

import kurbel
from kurbel.motion.long import LongColumns

ENGINES = (
    ("--eps=3", "--ratio=1:4", "--back=0.1", "--clearance=5%", "--exponent=1.3", "--cranks=0;77"),
    ("--pressure-ratio=3", "--ratio=1:5", "--offset=0.3", "--suction-loss=3%", "--clearance=4%"),
    ("--eps=4", "--ratio=1:5", "--flywheel=50", "--speed=120/min",
     "--columns=phi,tangential,speed,rpm,delta"),
)  # fmt: skip


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
    long = records("turning", *words, "--step=0.05", "--digits=5")
    assert 0 < len(settled) < len(long) / 50
    found = {Fraction(record["phi"]): record for record in long}
    for record in records("turning", *words, "--digits=5", "--angle=0;12.35;77;90;180;291.05;360"):
        assert {**found[Fraction(record["phi"])], "phi": ""} == {**record, "phi": ""}


def test_a_row_at_a_dead_centre_has_the_force_of_the_stroke_that_begins_there() -> None:
    # By e λ / (1 + λ) = 1/2 this offset crank is in its inner dead centre at 30°.
    words = (
        "--eps=3",
        "--back=0.1",
        "--ratio=1:4",
        "--offset=2.5",
        "--columns=phi,piston_force,tangential_force,rod_force",
        "--digits=5",
    )
    found = {Fraction(one["phi"]): one["piston_force"] for one in records("forces", *words, "--step=0.05")}
    assert found[Fraction(30)] == "0.90000"
    assert found[Fraction("29.95")] == "-0.23333"


MASSES = {
    "stroke": "600mm", "bore": "300mm", "speed": "2/s", "reciprocating": "200kg", "rod_mass": "100kg",
    "centre": "0.4", "gyration": "0.33", "rotating": "50kg",
}  # fmt: skip
FORCES = (
    "rod_force", "guide_force", "crank_pin_force", "radial_force", "bearing_force", "inertia_force",
    "crosshead_load",
)  # fmt: skip
LOADS: dict[str, dict[str, Any]] = {
    "steam": {"eps": "3.1", "back": "0", "exponent": "1.2", "clearance": "7%", "pressure": "8bar"},
    "idle": {"eps": "1", "back": "0", "single_acting": True, "ratio": "1:2.5", "pressure": "8bar"},
    "compressor": {
        "pressure_ratio": "2.7", "exponent": "1.3", "clearance": "4%", "suction_loss": "5%", "offset": "0.3",
        "suction_pressure": "8bar",
    },
}  # fmt: skip


@pytest.mark.parametrize("load", LOADS)
def test_long_columns_of_heavy_engines_have_the_figures_of_their_bodies(load: str) -> None:
    """Beside the dead centres and a corner of the load, too, where floats do not tell the stroke."""
    options, near, digits = {**LOADS[load], **MASSES}, Fraction(1, 2**38), 9
    one = machine(**options)
    (corner, *_) = one.angles_of(0, one.strokes[0].corners)
    for begin, step, count in (
        (Fraction(-40), Fraction(1, 8), 3000),
        (Fraction(corner) - 500 * near, near, 1000),
    ):
        asked = f"{begin}..{begin + count * step}:{step}"
        page = kurbel.forces(**options, angle=asked, columns=("phi", *FORCES), digits=digits)
        angles = np.array([float(begin + place * step) for place in range(count + 1)])
        true = one.rod(angles)
        # In the dead centre itself the stroke that begins counts.
        beside = np.abs((angles - one.dead_centres[0] + 90) % 180 - 90) > 1e-9
        wanted = np.column_stack([true[key] for key in FORCES])
        assert np.abs(figures(page, FORCES) - wanted)[beside].max() < 0.51 * 10.0**-digits + 1e-11


def test_records_of_several_engines_stream_in_their_order() -> None:
    words = ("forces", "--eps=2;4", "--ratio=1:4;1:5", "--step=0.25", "-f", "csv")
    columns = "--columns=epsilon,ratio,phi,rod_force,guide_force,tangential_force,radial_force"
    found = printed(*words, columns).records()
    assert [record["epsilon"] for record in found[::1441]] == ["2", "2", "4", "4"]
    assert [record["ratio"] for record in found[::1441]] == ["1:4", "1:5", "1:4", "1:5"]
    assert found[1441 + 4]["phi"] == "1.00"
