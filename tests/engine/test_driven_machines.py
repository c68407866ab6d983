"""Compressors, pumps, gas cycles: work and efficiency in closed form, a card driven, a machine in a file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from cli import printed, records
from figures import rows
from machines import machine
from mpmath import mp, mpf
from numpy.testing import assert_allclose

import kurbel

DIGITS = 25


def one(**options: Any) -> dict[str, Any]:
    """Return the one row of a page to many digits."""
    columns = [key for key in options.pop("columns").split(",")]
    (row,) = rows(kurbel.delta(**options, columns=columns, digits=DIGITS))
    return {key: mpf(row[key]) for key in columns}


@pytest.fixture(autouse=True)
def precise() -> Any:
    with mp.workdps(40):
        yield


@pytest.mark.parametrize(
    ("ratio", "exponent", "clearance", "suction", "delivery"),
    [("2", "1", "1/20", "0", "0"), ("5", "7/5", "1/25", "0", "0"), ("11/2", "6/5", "0", "0", "0"),
     ("7/2", "27/20", "1/16", "1/25", "1/15"), ("8", "1", "0.142857", "0", "0")],
)  # fmt: skip
def test_a_compressor_sucks_and_works_as_in_the_textbook(
    ratio: str, exponent: str, clearance: str, suction: str, delivery: str
) -> None:
    """n/(n - 1) (Π^((n-1)/n) - 1) of the air that is sucked, whatever the clearance; n = 1: ln Π."""
    options = {
        "pressure_ratio": ratio, "exponent": exponent, "clearance": clearance, "suction_loss": suction,
        "delivery_loss": delivery,
    }  # fmt: skip
    found = one(**options, columns="work,mean_pressure,volumetric_efficiency,delivered")
    rise, power, space, lost, beyond = (
        mp.fdiv(*_fraction(text)) for text in (ratio, exponent, clearance, suction, delivery)
    )
    low = 1 - lost
    inside = rise * (1 + beyond) / low
    drawn = 1 + space - space * inside ** (1 / power)
    each = mp.log(inside) if power == 1 else power / (power - 1) * (inside ** ((power - 1) / power) - 1)
    wanted = {"volumetric_efficiency": drawn, "delivered": drawn * low, "mean_pressure": each * low * drawn}
    wanted["work"] = -4 * wanted["mean_pressure"]
    assert drawn > 0
    for key, value in wanted.items():
        assert abs(found[key] - value) < mpf(10) ** -DIGITS, key


def _fraction(text: str) -> tuple[mpf, mpf]:
    above, _, below = text.partition("/")
    return mpf(above), mpf(below or 1)


@pytest.mark.parametrize(
    "options",
    [
        {"compression": "6", "peak_pressure": "28", "exponent": "27/20", "expansion_exponent": "5/4",
         "exhaust_pressure": "11/10"},
        {"compression": "16", "cycle": "diesel", "cut_off": "11/5"},
        {"compression": "14", "cycle": "dual", "peak_pressure": "70", "heat": "7"},
        {"compression": "15", "heat": "9", "exponent": "4/3", "two_stroke": True},
        {"compression": "15", "cycle": "diesel", "heat": "8", "exponent": "4/3", "two_stroke": True},
        {"pressure_ratio": "7/2", "exponent": "27/20", "clearance": "1/16", "single_acting": True,
         "other_side": "1.25bar", "suction_pressure": "1bar"},
        {"pump": "single"},
        {"pump": "differential", "small_area": "2/5"},
    ],
)  # fmt: skip
def test_the_work_of_a_cycle_is_that_of_its_pressures(options: dict[str, Any]) -> None:
    # The work is that of a turn, in Q R.
    found, turn = one(**options, columns="work,mean_force"), machine(**options).turn
    span = 2 * float(mp.pi)
    assert_allclose(
        [float(found["mean_force"]), float(found["work"])], [turn.mean, turn.mean * span], rtol=1e-12
    )


def test_the_efficiency_of_a_gas_cycle_is_work_over_heat() -> None:
    for told in (
        {"cycle": "otto", "heat": "9"},
        {"cycle": "diesel", "heat": "8"},
        {"cycle": "dual", "heat": "11", "peak_pressure": "80"},
    ):
        found = one(compression="15", exponent="4/3", two_stroke=True, **told, columns="efficiency,work")
        # The work is in Q R, the heat of the whole volume in two of these and clearance.
        assert abs(found["efficiency"] - found["work"] / (mpf(told["heat"]) * 2 * (1 + mpf(1) / 14))) < mpf(
            "1e-24"
        )
    otto = one(compression="6", peak_pressure="40", columns="efficiency")
    assert abs(otto["efficiency"] - (1 - mpf(6) ** mpf("-0.4"))) < mpf("1e-24")
    # η q/(R T₁) ε/(ε - 1), for a cycle sweeps V₁ (1 - 1/ε).
    whole = one(compression="5", heat="10", columns="mean_pressure")
    assert abs(whole["mean_pressure"] - (1 - mpf(5) ** mpf("-0.4")) * 10 * mpf(5) / 4) < mpf("1e-24")


def test_work_power_and_delivery_are_those_of_the_textbook() -> None:
    """p₁ V ln Π of two ends a turn; V n of each, in a minute."""
    found = one(
        pressure_ratio=3, bore="0.9m", stroke="0.8m", suction_pressure="1bar", speed="60/min",
        columns="mean_pressure_kpa,indicated_power,delivery",
    )  # fmt: skip
    swept = mp.pi / 4 * mpf("0.81") * mpf("0.8")
    assert abs(found["mean_pressure_kpa"] - 100 * mp.log(3)) < mpf("1e-22")
    assert abs(found["indicated_power"] - 200 * swept * mp.log(3)) < mpf("1e-21")
    assert abs(found["delivery"] - 120 * swept) < mpf("1e-22")


def test_the_same_card_driven_has_the_same_irregularity_with_the_extremes_exchanged(tmp_path: Path) -> None:
    """Forces turn round where both pressures are exchanged, each seen from the other end."""
    shares = [place / 40 for place in range(41)]
    forward = [8 / max(1, 3 * share) for share in shares]
    back = [1.5 + 0.5 * share**2 for share in shares]

    def turn(name: str, there: list[float], behind: list[float]) -> dict[str, float]:
        path = tmp_path / name
        lines = (
            f"{share},{one:.6f},{other:.6f}" for share, one, other in zip(shares, there, behind, strict=True)
        )
        path.write_text("position,p_forward [bar],p_return [bar]\n" + "\n".join(lines))
        *_, row = records(
            "delta", f"--card={path}", "--columns=mean_force,delta,alpha_min,alpha_max", "--digits=6"
        )
        return {key: float(row[key]) for key in ("mean_force", "delta", "alpha_min", "alpha_max")}

    driving = turn("driving.csv", forward, back)
    # On the stroke the pressure behind is now what was before, and the other way round.
    driven = turn("driven.csv", [*reversed(back)], [*reversed(forward)])
    # Q is of the greatest pressure before the piston, 2 bar and 8.
    assert driven["mean_force"] == pytest.approx(-driving["mean_force"] * 8 / 2, abs=1e-4)
    assert driven["delta"] == pytest.approx(driving["delta"], abs=2e-4)
    assert (driven["alpha_min"], driven["alpha_max"]) == pytest.approx(
        (driving["alpha_max"], driving["alpha_min"]), abs=1e-3
    )


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
