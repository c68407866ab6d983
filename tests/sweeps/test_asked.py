"""What a sweep asks: lists, ranges, links, conditions and designs, and the sentences that refuse them."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from decimal import Decimal
from fractions import Fraction
from itertools import product
from math import cos, radians, sin, sqrt
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from cli import kurbel, printed, refusal

import kurbel as library

# Sixty pounds a square inch.
PSI = float(60 * Fraction("0.45359237") * Fraction("9.80665") / Fraction("0.0254") ** 2)
SOME_SECONDS = 2.0
PI = Decimal("3.14159265358979323846264338327950288")


def swept(*words: str) -> list[dict[str, str]]:
    result = kurbel("sweep", *words, "-f", "csv", "-o", "-")
    assert result.code == 0, result.err
    return list(csv.DictReader(result.out.splitlines()))


def eps_and_back(*words: str) -> list[tuple[str, str]]:
    return [(row["epsilon"], row["back"]) for row in swept("delta", *words)]


@pytest.mark.parametrize("free", ["first", "last"])
def test_linked_options_go_together_whatever_a_third_one_does(free: str) -> None:
    linked = ("--eps=2;3;4", "--back=0.1;0.05;0.02")
    words = ("--ratio=1:4;1:∞", *linked) if free == "first" else (*linked, "--ratio=1:4;1:∞")
    rows = swept("delta", *words, "--zip=back,eps")
    found = {tuple(float(row[key]) for key in ("epsilon", "back", "ratio")): row["delta"] for row in rows}
    pairs, ratios = ((2, 0.1), (3, 0.05), (4, 0.02)), (0.25, 0)
    places = [(*pair, ratio) for ratio in ratios for pair in pairs]
    assert [*found] == (places if free == "first" else [(*pair, ratio) for pair in pairs for ratio in ratios])
    for (eps, back, ratio), value in found.items():
        single = ("delta", f"--eps={eps}", f"--back={back}", f"--ratio={ratio}", "--digits=15", "-f=csv")
        assert float(value) == pytest.approx(float(printed(*single).records()[0]["delta"]), rel=1e-13)


def test_a_column_has_the_unit_of_the_si_whatever_was_typed() -> None:
    rows = swept("power", "--eps=2", "--stroke=1m", "--bore=40..50cm:10cm;600mm", "--pressure=5bar;60psi",
                 "--speed=100;120/min", "--columns=indicated_power")  # fmt: skip
    assert [float(row["bore"]) for row in rows[::4]] == [0.4, 0.5, 0.6]
    assert [float(row["pressure"]) for row in rows[:4:2]] == [5e5, PSI]
    assert [float(row["speed"]) for row in rows[:2]] == [100 / 60, 2]


@pytest.mark.parametrize(
    ("speeds", "own"),
    [
        ("100..130:15/min", [100, 115, 130]),
        ("2;2.1/s", [120, 126]),
        ("10;11rad/s", [float(Decimal(60 * one) / (2 * PI)) for one in (10, 11)]),
    ],
)
def test_an_axis_is_in_the_unit_of_the_commands_own_column(speeds: str, own: list[float]) -> None:
    engine: dict[str, Any] = {
        "eps": "3",
        "pressure": "8bar",
        "back": "1.1bar",
        "stroke": "450mm",
        "bore": "11in;300mm",
    }
    rows = swept("power", *(f"--{name}={text}" for name, text in engine.items()), f"--speed={speeds}")
    assert [float(row["speed"]) for row in rows] == own * 2
    assert [float(row["bore"]) for row in rows[:: len(own)]] == [279.4, 300]
    found = library.sweep("power", **engine, speed=speeds)["speed"]
    assert (found.attrs["unit"], found.values.tolist()) == ("min⁻¹", own)


@pytest.mark.parametrize("digits", [(), ("--digits=9",)], ids=["floats", "certified"])
def test_angles_typed_one_by_one_are_numbers(digits: Sequence[str]) -> None:
    rows = swept("table", "--ratio=1:4;1:5", "--angle=30", "--angle=82°30'", "--columns=x", *digits)
    assert [(float(row["ratio"]), float(row["phi"])) for row in rows] == [*product((0.25, 0.2), (30, 82.5))]
    for row in rows:
        share, angle = float(row["ratio"]), radians(float(row["phi"]))
        path = 1 - cos(angle) + (1 - sqrt(1 - (share * sin(angle)) ** 2)) / share
        assert float(row["x"]) == pytest.approx(path, abs=1e-9, rel=0)


def test_a_column_that_is_another_thing_than_the_axis_stays() -> None:
    rows = swept("deadcentres", "--stroke=500mm;600mm", "--ratio=1:4", "--offset=0.2")
    one = kurbel(
        "deadcentres", "--stroke=500mm", "--ratio=1:4", "--offset=0.2", "-f", "csv", "--digits=12"
    ).out
    assert [float(row["stroke_given"]) for row in rows] == [0.5, 0.6]
    assert f"{float(rows[0]['stroke']):.12f}" == next(csv.DictReader(one.splitlines()))["stroke"]


def exactly(text: str, eps: Sequence[Fraction], back: Sequence[Fraction]) -> list[tuple[Fraction, Fraction]]:
    """What a condition keeps, by Python's own evaluation of exact numbers."""
    numbers = text.replace("0.1", "Fraction(1, 10)")
    found = product(eps, back)
    return [
        one
        for one in found
        if eval(numbers, {"Fraction": Fraction}, dict(zip(("eps", "back"), one, strict=True)))
    ]


@pytest.mark.parametrize(
    "text",
    [
        "eps*back < 1",
        "eps*back - 1 >= 0",
        "not eps*back == 1 and 0.1 < back <= eps - 0.1",
        "back**2 + 1 > eps/2 or (eps - 2)**2 == back + 0.1*3",
        "1/eps - 1/(eps + 0.1) < 0.1*back",
    ],
)
def test_a_condition_holds_where_exact_numbers_say_so(text: str) -> None:
    eps = [1 + Fraction(place, 10) for place in range(40)]
    back = [Fraction(place, 20) for place in range(20)]
    kept = eps_and_back("--eps=1..4.9:0.1", "--back=0..0.95:0.05", f"--only={text}")
    assert [(Fraction(one), Fraction(two)) for one, two in kept] == exactly(text, eps, back)
    assert 0 < len(kept) < len(eps) * len(back)


def test_a_dataset_has_the_reasons_of_what_is_refused() -> None:
    found = library.sweep("harmonics", ratio="0.2..1.09:0.01")
    assert found["refused"].any() and found["reason"].values[-1, 0]


@pytest.mark.parametrize(
    ("text", "count"),
    [
        # What floats would take for 0, for infinite or for 1.
        ("ratio*1e-400 > 0", 3),
        ("eps < 1e999", 3),
        ("eps**1000 > 10**500", 1),
        ("(1 + eps/10**20)**70 > 1", 3),
        ("2**1000 < eps**1000 <= 3**1000", 1),
    ],
)
def test_large_and_small_numbers_are_exact(text: str, count: int) -> None:
    assert len(swept("delta", "--eps=2..4", "--ratio=1:5", f"--only={text}")) == count


def test_a_sobol_design_is_scipys_between_the_ends_and_can_be_typed_again() -> None:
    from scipy.stats import qmc

    words = ("delta", "--ratio=1:3..8", "--back=0..20%")
    found = swept(*words, "--eps=1..10", "--sample=sobol:16", "--seed=7")
    unit = qmc.Sobol(3, seed=7).random(16)
    # In the order of the options, by the length of the rod and not by the ratio.
    order = [*found[0]][:3]
    assert {*order} == {"epsilon", "ratio", "back"}
    sampled = {"epsilon": 1 + 9 * unit[:, 2], "ratio": 3 + 5 * unit[:, 0], "back": 0.2 * unit[:, 1]}
    for key, expected in sampled.items():
        values = [1 / float(one[key]) if key == "ratio" else float(one[key]) for one in found]
        np.testing.assert_allclose(values, expected, rtol=0, atol=1e-5)
    # Typed again, one of them is the same engine.
    one = found[5]
    again = ("--eps", one["epsilon"], "--ratio", f"1:{1 / float(one['ratio']):.9g}", "--back", one["back"])
    assert swept("delta", *again)[0]["delta"] == one["delta"]
    random = [swept("delta", "--eps=1..10", "--sample=random:5", f"--seed={seed}") for seed in (1, 2)]
    assert random[0] != random[1]
    drawn = swept("delta", "--eps=1..10", "--sample=random:5")
    assert drawn == swept("delta", "--eps=1..10", "--sample=random:5", "--seed=0")
    same = library.sweep("delta", eps="1..10", sample="random:5")
    assert [*map(float, same["epsilon"])] == [float(one["epsilon"]) for one in drawn]
    methods = swept("delta", "--eps=2..3", "--method=exact;series", "--sample=lhs:8")
    assert {one["method"] for one in methods} == {"exact", "series"}
    # Several cranks of one engine are one value, several engines an axis.
    lhs = ("delta", "--eps=2..4", "--sample=lhs:4")
    assert "cranks" not in swept(*lhs, "--cranks=0;90")[0]
    assert {one["cranks"] for one in swept(*lhs, "--cranks=0;90", "--cranks=0;180")} == {"0;90", "0;180"}


def test_a_path_in_strokes_and_in_per_cent_is_that_of_the_textbook() -> None:
    for row in swept("table", "--ratio=1:4", "--angle=0..360:15", "--columns=x,x_stroke,x_percent"):
        angle = radians(float(row["phi"]))
        path = 1 - cos(angle) + 4 - sqrt(16 - sin(angle) ** 2)
        found = [float(row[key]) for key in ("x", "x_stroke", "x_percent")]
        assert found == pytest.approx([path, path / 2, 50 * path], rel=1e-12, abs=1e-15)


def test_a_strict_sweep_ends_and_names_the_combination(tmp_path: Path) -> None:
    words = ["sweep", "delta", "--eps=2;3", "--ratio=1:4", "--back=0;0.9", "-o", str(tmp_path / "x.parquet")]
    assert "of which 2 were refused" in kurbel(*words).err
    (tmp_path / "x.parquet").unlink()
    said = refusal(*words, "--strict", code=1)
    assert said.endswith("this is of --eps 2 --back 0.9, and --strict ends there")
    assert not [*tmp_path.iterdir()]


def test_a_dry_run_says_what_it_would_be_and_writes_nothing(tmp_path: Path) -> None:
    target = tmp_path / "x.parquet"
    words = ["--eps=1..10:0.5", "--ratio=1:3..8:0.5", "--back=0..0,5:0,1"]
    said = kurbel("sweep", "delta", *words, "-o", str(target), "--dry-run").out.splitlines()
    told = {line.split()[0]: line.split(maxsplit=1)[1] for line in said}
    assert told["rows"] == "1254 (19 of --eps x 11 of --ratio x 6 of --back)"
    assert told["columns"] == "epsilon, ratio, back, delta, reason"
    assert told["refused"].startswith("--eps ") and "leaves no work" in told["refused"]
    assert {"parts", "size", "time"} <= {*told}
    assert not [*tmp_path.iterdir()]


FILE = """\
command = "delta"
output = "found.csv"
only = ["eps*back < 1"]
zip = ["eps,ratio"]

[axes]
eps = "2..3"
ratio = ["1:4", "1:5"]
single-acting = [false, true]
back = [0, 0.1, "40%"]

[options]
exponent = 1.1
"""


def test_a_file_says_the_same_as_words_and_what_is_typed_outdoes_it(tmp_path: Path) -> None:
    (tmp_path / "sweep.toml").write_text(FILE)
    result = kurbel("sweep", str(tmp_path / "sweep.toml"))
    assert result.code == 0, result.err
    rows = list(csv.DictReader((tmp_path / "found.csv").read_text().splitlines()))
    assert [(row["epsilon"], row["ratio"], row["single_acting"], row["back"]) for row in rows] == [
        (eps, ratio, acting, back)
        for (eps, ratio), acting, back in product(
            (("2", "0.25"), ("3", "0.2")), ("false", "true"), ("0", "0.1", "0.4")
        )
        if float(eps) * float(back) < 1
    ]
    single = kurbel("delta", "--eps=3", "--ratio=1:5", "--single-acting", "--back=0.1", "--exponent=1.1",
                    "--digits=20", "-fcsv").out.split(",")[-1]  # fmt: skip
    (row,) = [
        row for row in rows if (row["epsilon"], row["single_acting"], row["back"]) == ("3", "true", "0.1")
    ]
    assert float(row["delta"]) == float(single)
    typed = swept(str(tmp_path / "sweep.toml"), "--eps=4;5", "--back=0")
    assert {(row["epsilon"], row["ratio"]) for row in typed} == {("4", "0.25"), ("5", "0.2")}


def test_a_file_may_name_a_machine_with_a_ratio_and_without(tmp_path: Path) -> None:
    (tmp_path / "m.toml").write_text('[crank]\nstroke = "600mm"\nspeed = "120/min"\n')
    for words, swept_by in (
        ("table --angle=30 --columns=x_mm,c_mps", "--ratio=1:4;1:5"),
        ("locomotive --gauge=1.5m --reciprocating=300kg --revolving=160kg --spacing=0.7m", "--share=0;0.5"),
    ):
        command, *options = words.replace("--", "").split()
        lines = (f'{key} = "{value}"' for key, value in (one.split("=") for one in options))
        key, value = swept_by[2:].split("=")
        (tmp_path / "s.toml").write_text(
            f'command = "{command}"\n[options]\nmachine = "m.toml"\n'
            + "\n".join(lines)
            + f"\n[axes]\n{key} = {value.split(';')}\n"
        )
        typed = swept(*words.split(), f"--machine={tmp_path / 'm.toml'}", swept_by)
        assert swept(str(tmp_path / "s.toml")) == typed
