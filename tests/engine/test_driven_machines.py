"""Pages of driven machines and gas engines: what they mirror, what they say, and what they refuse."""

from __future__ import annotations

import math
import re
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from cli import printed, refusal
from mpmath import mp

import kurbel
from kurbel.drive.crank import Crank
from kurbel.engine.engine import Diagram, Engine, Steam
from kurbel.engine.loads.compressor import Compressor
from kurbel.engine.loads.pump import Pump
from kurbel.engine.turn import turn_of

PUMPED = ("--bore=1m", "--delivery-pressure=0.605bar")
FIFTH = Crank(Fraction(1, 5))


def records(page: Any) -> list[dict[str, Any]]:
    keys = [field.key for field in page.records.fields]
    return [dict(zip(keys, row, strict=True)) for row in page.records.rows]


def numbers(page: Any, key: str) -> list[float]:
    return [row[key].scaled / 10 ** row[key].decimals for row in records(page)]


def extremes(engine: Engine, method: str = "exact") -> list[tuple[float, float]]:
    turn = turn_of(engine, method)
    return [(float(peak.place), float(peak.energy)) for great in (0, 1) for peak in turn.peaks(bool(great))]


@pytest.mark.parametrize("method", ["exact", "series"])
@pytest.mark.parametrize("ratio", [Fraction(2), Fraction(9, 2)])
def test_an_isothermal_compressor_is_the_steam_engine_turned_back(ratio: Fraction, method: str) -> None:
    """Air is compressed as steam at its best back pressure expands, by Q = ε p₁: W(φ) = ε W(360° - φ)."""
    steam = extremes(Engine(FIFTH, Steam(ratio)), method)
    for (place, energy), (own, mirrored) in zip(
        extremes(Engine(FIFTH, Compressor(ratio)), method), steam, strict=True
    ):
        assert place == pytest.approx(2 - own, rel=1e-12)
        assert energy == pytest.approx(float(ratio) * mirrored, rel=1e-12)


def test_a_pump_exchanges_the_extremes_of_full_pressure() -> None:
    least, greatest = extremes(Engine(FIFTH, Pump()))
    other_least, other_greatest = extremes(Engine(FIFTH, Steam(Fraction(1), Fraction(0))))
    assert least == pytest.approx((other_greatest[0], -other_greatest[1]), rel=1e-12)
    assert greatest == pytest.approx((other_least[0], -other_least[1]), rel=1e-12)


def test_the_same_card_driven_has_the_same_irregularity_with_the_extremes_exchanged(tmp_path: Path) -> None:
    """Forces turn round where p_forward and p_return are exchanged, each seen from the stroke's other end."""
    shares = [place / 40 for place in range(41)]
    forward = [8 / max(1, 3 * share) for share in shares]
    back = [1.5 + 0.5 * share**2 for share in shares]

    def turn(there: list[float], behind: list[float]) -> Any:
        path = tmp_path / "card.csv"
        rows = zip(shares, there, behind, strict=True)
        lines = [f"{share},{one:.6f},{other:.6f}" for share, one, other in rows]
        path.write_text("position,p_forward [bar],p_return [bar]\n" + "\n".join(lines))
        from kurbel.engine.card.file import read_card

        return turn_of(Engine(FIFTH, Diagram(read_card(str(path)), unit=8e5)), "exact")

    driving = turn(forward, back)
    # On the stroke the pressure behind is now what was before, and the other way round.
    driven = turn([*reversed(back)], [*reversed(forward)])
    assert driven.mean_force() == pytest.approx(-driving.mean_force(), rel=1e-9)
    assert driven.irregularity() == pytest.approx(driving.irregularity(), rel=1e-6)
    for greatest in (False, True):
        own, other = driven.extreme(greatest), driving.extreme(not greatest)
        assert (own.place, own.energy) == pytest.approx((other.place, -other.energy), rel=1e-5)


def test_work_power_and_delivery_are_those_of_the_textbook() -> None:
    """p₁ V ln Π of two ends a turn; V n of each, in a minute."""
    page = kurbel.delta_table(
        pressure_ratio=3, bore=0.9, stroke=0.8, suction_pressure=100_000, speed="60/min",
        columns="work,mean_pressure,mean_pressure_kpa,indicated_power,delivery",
    )  # fmt: skip
    area, length = math.pi / 4 * 0.9**2, 0.8
    assert numbers(page, "work") == [pytest.approx(-4 * math.log(3), abs=5e-5)]
    assert numbers(page, "mean_pressure") == [pytest.approx(math.log(3), abs=5e-5)]
    assert numbers(page, "mean_pressure_kpa") == [pytest.approx(100 * math.log(3), abs=0.05)]
    assert numbers(page, "indicated_power") == [pytest.approx(200 * area * length * math.log(3), rel=1e-4)]
    assert numbers(page, "delivery") == [pytest.approx(2 * area * length * 60, rel=1e-4)]


def test_the_mean_pressure_of_a_gas_engine_is_that_of_its_heat() -> None:
    """η q/(R T₁) ε/(ε - 1), for a cycle sweeps V₁ (1 - 1/ε)."""
    page = kurbel.delta_table(compression="5;7", heat=10, digits=6)
    expected = [float((1 - mp.mpf(ratio) ** mp.mpf("-0.4")) * 10 * ratio / (ratio - 1)) for ratio in (5, 7)]
    assert numbers(page, "mean_pressure") == pytest.approx(expected, abs=1e-6)


@pytest.mark.parametrize(
    ("words", "printed_as"),
    [
        # Half-way between two printed numbers, and rounded away from zero.
        (("--eps=1", "--back=0.15", "--columns=mean_pressure,work", "--digits=1"), "0.9,3.4"),
        (("--eps=1", "--back=0.1875", "--single-acting", "--columns=work", "--digits=2"), "1.63"),
        (("--pressure-ratio=2.25", "--clearance=5%", "--columns=delivered", "--digits=3"), "0.938"),
        (("--pump", *PUMPED, "--columns=stroke,mean_pressure_kpa", "--digits=0"), "turn,61"),
    ],
)  # fmt: skip
def test_ties_of_work_and_pressure_are_settled(words: tuple[str, ...], printed_as: str) -> None:
    assert printed("delta", *words, "-f", "csv").out.splitlines()[-1] == printed_as


# What a page of a driven machine may say of its signs, in both languages.
SIGNS, MAGNITUDE = (
    ("Die Welle treibt den Kolben", "The shaft drives the piston"),
    ("δ im Betrag", "δ in the mag"),
)
TORQUE, PRESSURE = (
    ("P r im Betrag", "P r as a magnitude"),
    ("mittlere Drücke positiv", "mean pressures positive"),
)
EXCHANGED, GUIDE = ("die Plätze getauscht", "have changed places"), ("die obere Gleitbahn", "the upper guide")
POWER = ("Leistungen positiv", "powers positive")
CLAUSES = (SIGNS, MAGNITUDE, TORQUE, PRESSURE, EXCHANGED, GUIDE, POWER)
SIZES = ("--bore=300mm", "--stroke=600mm", "--speed=60/min", "--suction-pressure=1bar")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("delta", "--pressure-ratio=2..3"), (SIGNS, MAGNITUDE, PRESSURE, EXCHANGED, GUIDE)),
        (("delta", "--pump", "--detail"), (SIGNS, MAGNITUDE, EXCHANGED, GUIDE)),
        (("delta", "--pump", "--columns=work"), (SIGNS,)),
        (("delta", "--pressure-ratio=3", *SIZES, "--columns=indicated_power"), (SIGNS, POWER)),
        (("turning", "--pump", "--step=90"), (SIGNS,)),
        (("turning", "--pump", "--step=90", "--flywheel=50"), (SIGNS, TORQUE)),
        (("delta", "--pump", "--flywheel=50"), (SIGNS, TORQUE, EXCHANGED)),
        (("forces", "--pump=single", "--step=90"), (SIGNS, GUIDE)),
        (("forces", "--pump=single", "--step=90", "--columns=phi,piston_force"), (SIGNS,)),
        (
            ("flywheel", "--pressure-ratio=3", "--power=5kW", "--speed=60/min", "--delta=1:50"),
            (SIGNS, TORQUE, POWER),
        ),
    ],
)
def test_a_page_of_a_driven_machine_says_how_it_counts_what_it_prints(
    words: tuple[str, ...], said: tuple[tuple[str, str], ...]
) -> None:
    for place, lang in enumerate(("de", "en")):
        text = re.sub(r"\s+", " ", printed(*words, f"--lang={lang}").out)
        assert [clause for clause in CLAUSES if clause[place] in text] == [
            clause for clause in CLAUSES if clause in said
        ]
        assert "Dampfmaschine" not in text
        assert "steam" not in text


def test_the_torque_of_the_flywheel_of_a_driven_machine_is_called_supplied() -> None:
    sizes: dict[str, Any] = {"power": 5000, "speed": 1, "delta": "1:50", "lang": "en"}
    for load, name in (("pressure_ratio", "Mean torque supplied"), ("eps", "Mean torque")):
        fields = kurbel.flywheel_table(**{load: 3, **sizes}).records.fields
        assert [field.name for field in fields if field.key == "mean_torque"] == [name]


def test_a_page_of_a_gas_engine_says_nothing_of_driven_machines() -> None:
    assert "treibt den Kolben" not in printed("delta", "--compression=6", "--heat=9").out


def test_sizes_show_the_columns_that_they_make_known() -> None:
    known = ["mean_pressure_kpa", "delivery", "indicated_power"]
    page = kurbel.delta_table(
        pressure_ratio=3, bore=0.3, stroke=0.6, speed=1, suction_pressure=100_000, digits=8
    )
    # By Mariotte's law p ln Π on each of two faces, a piston of π/4 0.09 m², a stroke of 0.6 m, 1/s.
    swept, pressure = math.pi / 4 * 0.09 * 0.6, 100 * math.log(3)
    for key, true in zip(known, (pressure, 120 * swept, 2 * pressure * swept), strict=True):
        assert numbers(page, key) == [pytest.approx(true, rel=1e-4)]
    for words, keys in (
        (("delta", "--pressure-ratio=3", "--bore=300mm", "--suction-pressure=1bar"), known[:1]),
        (("delta", "--pressure-ratio=3"), []),
        (("delta", "--compression=6", "--heat=9", *SIZES), [known[0], known[2]]),
        (("delta", "--pump", *SIZES, "--delivery-pressure=6bar"), known),
    ):
        head = printed(*words, "-f", "csv").out.splitlines()[0].split(",")
        assert {*known} & {*head} == {*keys}


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (
            ("delta", "--pressure-ratio=3", "--speed=60/min"),
            "--speed says nothing on this page by itself; add --stroke, --bore, --suction-pressure",
        ),
        (
            (
                "delta",
                "--pump",
                "--bore=90mm",
                "--delivery-pressure=6bar",
                "--stroke=1m",
                "--speed=1/s",
                "--detail",
            ),
            "--speed says nothing on this page; add --reciprocating, or a column such as indicated_power",
        ),
        (
            ("turning", "--layout=turning-path", "--bore=300mm"),
            "--bore says nothing on this page by itself; add --pressure",
        ),
        (
            ("turning", "--compression=6", "--heat=9", "--stroke=300mm"),
            "--stroke says nothing on this page; add --reciprocating, or a column such as pin_path_mm",
        ),
        (
            ("delta", "--pump", "--columns=indicated_power"),
            "column indicated_power needs --stroke, --speed, --bore and --delivery-pressure; leave it out,",
        ),
    ],
)
def test_sizes_that_say_nothing_are_refused_with_what_is_missing(
    words: tuple[str, ...], sentence: str
) -> None:
    assert refusal(*words).startswith(sentence)


def test_a_cycle_of_four_strokes_is_printed_over_two_turns() -> None:
    page = kurbel.turning_table(compression=6, heat=9, step=90)
    assert numbers(page, "phi") == [90.0 * place for place in range(9)]
    assert numbers(page, "energy")[-1] == 0
    turn = kurbel.turning_table(compression=6, heat=9, two_stroke=True, step=90)
    assert numbers(turn, "phi") == [90.0 * place for place in range(5)]


COMPRESSOR = """
[crank]
ratio = "1:4"
stroke = "800mm"
speed = "60/min"

[compressor]
pressure_ratio = 2.5
exponent = 1.3
clearance = "4%"
suction_pressure = "1bar"
bore = "900mm"

[masses]
reciprocating = "900kg"
"""


def test_a_machine_may_be_a_compressor_and_what_is_typed_outdoes_it(tmp_path: Path) -> None:
    path = tmp_path / "gebläse.toml"
    path.write_text(COMPRESSOR, encoding="utf-8")
    typed = (
        "--ratio=1:4", "--stroke=800mm", "--speed=60/min", "--pressure-ratio=2.5", "--exponent=1.3",
        "--clearance=4%", "--suction-pressure=1bar", "--bore=900mm", "--reciprocating=900kg",
    )  # fmt: skip
    machine = f"--machine={path}"
    assert printed("delta", machine, "-f", "csv").out == printed("delta", *typed, "-f", "csv").out
    # Steam that is typed takes nothing of the compressor but the bore.
    steam = ("--eps=4", "--pressure=8bar", "-f", "csv")
    others = [word for word in typed if not word.startswith(("--pre", "--exp", "--cle", "--suc"))]
    assert printed("delta", machine, *steam).out == printed("delta", *others, *steam).out
    path.write_text(COMPRESSOR + "[pump]\n", encoding="utf-8")
    assert refusal("delta", machine, code=1).endswith(
        "[compressor] and [pump] are two loads of one piston; leave one out"
    )


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--pressure-ratio=0.5",), "pressure ratio Π is 0.5; it must be above 1, for it is the delivery"),
        (("--pressure-ratio=8", "--clearance=0.2"), "leaves nothing to deliver at Π = 8: the air left in it"),
        (("--pressure-ratio=4", "--back=0.1"), "--back does not belong to a compressor; it is for steam"),
        (("--pressure-ratio=4", "--eps=4"), "--eps and --pressure-ratio describe two loads; leave one out"),
        (("--pressure-ratio=4", "--method=weisbach"), 'method "weisbach" has equations for steam alone'),
        (("--suction-loss=4%",), "--suction-loss is for a compressor; add --pressure-ratio"),
        (("--pressure-ratio=4", "--other-side=1bar"), "--other-side is for --single-acting; double-acting,"),
        (("--pressure-ratio=4", "--layout=weisbach-150"), "which a compressor does not have; use --layout c"),
        (("--layout=compressor", "--eps=4"), "layout compressor is of a compressor; add --pressure-ratio"),
        (("--pump=single", "--suction-pressure=-1bar"), "compared with what the pump makes; add --delivery-"),
        (("--pump", "--bore=1m", "--suction-pressure=3bar", "--delivery-pressure=2bar"), "a pump raises"),
        (("--pump", "--small-area=0.4"), "--small-area is for --pump differential, which has a ring"),
        (("--pump=triple",), 'there is no pump "triple"; choose from double,'),
        (("--compression=6",), "the Otto cycle needs --heat or --peak-pressure, for example"),
        (("--eps=4", "--columns=efficiency"), "needs the cycle of a gas engine, --compression, with one"),
        (("--eps=4", "--columns=volumetric_efficiency"), "needs a compressor, with --pressure-ratio; leave"),
    ],
)  # fmt: skip
def test_what_is_not_driven_so_is_answered_with_a_sentence(words: tuple[str, ...], said: str) -> None:
    assert said in refusal("delta", *words)
