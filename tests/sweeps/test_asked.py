"""What a sweep asks: lists, ranges, links, conditions and designs, and the sentences that refuse them."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from decimal import Decimal
from fractions import Fraction
from itertools import product
from math import cos, radians, sin, sqrt
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np
import pytest
from cli import kurbel, printed, refusal
from scipy.stats import qmc

from kurbel.errors import KurbelError
from kurbel.sweeps.asked import planned
from kurbel.sweeps.dataset import sweep
from kurbel.sweeps.kept import MOST_TRIED
from kurbel.sweeps.only import Condition
from kurbel.sweeps.rows import Sweep
from kurbel.sweeps.work.identity import identity_of

# Sixty pounds a square inch.
PSI = float(60 * Fraction("0.45359237") * Fraction("9.80665") / Fraction("0.0254") ** 2)
SOME_SECONDS = 2.0
PI = Decimal("3.14159265358979323846264338327950288")
DELTA = "kurbel.commands.engine:delta_table"


def points(**given: Any) -> list[dict[str, Any]]:
    """The combinations of a sweep of δ, in order."""
    more = {name: given.pop(name) for name in ("linked", "only", "sample", "seed") if name in given}
    plan = planned(DELTA, given, **more)
    return [plan.at(plan.point(place)) for place in range(len(plan))]


def swept(*words: str) -> list[dict[str, str]]:
    result = kurbel("sweep", *words, "-f", "csv", "-o", "-")
    assert result.code == 0, result.err
    return list(csv.DictReader(result.out.splitlines()))


def test_the_last_axis_is_the_fastest_and_linked_ones_go_together() -> None:
    assert points(ratio="1:4;1:5", eps="2..3") == [
        {"ratio": Fraction(1, ratio), "eps": eps} for ratio, eps in product((4, 5), ("2", "3"))
    ]
    linked = points(eps="2;3", ratio=["1:4", "1:5"], back="0.1..0.2:0,1", linked=[["back", "eps"]])
    assert [(one["eps"], one["ratio"], one["back"]) for one in linked] == [
        (eps, Fraction(1, ratio), back) for eps, back in (("2", "0.1"), ("3", "0.2")) for ratio in (4, 5)
    ]


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
    found = sweep("power", **engine, speed=speeds)["speed"]
    assert (found.attrs["unit"], found.values.tolist()) == ("min⁻¹", own)


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
    kept = points(eps="1..4.9:0.1", back="0..0.95:0.05", only=text)
    assert [(Fraction(one["eps"]), Fraction(one["back"])) for one in kept] == exactly(text, eps, back)
    assert 0 < len(kept) < len(eps) * len(back)


def test_a_card_in_the_words_of_a_cylinder_is_a_part_of_the_sweep(tmp_path: Path) -> None:
    card, head = tmp_path / "card.csv", "position [%];p_forward [bar];p_return [bar]\n"
    card.write_text(head + "".join(f"{place};8.0;1.5\n" for place in range(0, 101, 10)))
    asked = Sweep(planned(DELTA, {"ratio": "1:4;1:5", "cylinder": f"card={card}"}))
    told = identity_of(asked)
    assert identity_of(asked) == told
    card.write_text(card.read_text().replace("8.0", "7.0"))
    assert identity_of(asked) != told


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("__import__('os').getpid() > 1", "cannot be read"),
        ("[1][0] < eps", "cannot be read"),
        ("eps if eps else 1", "cannot be read"),
        ("eps *", "cannot be read"),
        ("eps*back", "compares nothing"),
        ("eps < 'a'", "a word is compared with a number"),
        ("eps < bak", "did you mean back?"),
        ("1 < 2", "names no option"),
        ("eps > 99", "holds at no combination"),
        ("(" * 500 + "eps" + ")" * 500 + " < 1", "characters"),
        ("(" * 245 + "eps" + ")" * 245 + "<1", "has more than 100 brackets within each other"),
    ],
)
def test_a_condition_that_cannot_be_used_is_told_so(text: str, said: str) -> None:
    with pytest.raises(KurbelError, match=said.replace("?", "[?]")):
        points(eps="2..4", back="0;0.1", only=text)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--digits=3", "--bounds"), "leave one of --bounds and --digits out"),
        (("--zip=eps",), "--zip eps links one option to nothing"),
    ],
)
def test_what_would_do_nothing_is_refused(words: Sequence[str], said: str) -> None:
    assert said in refusal("sweep", "delta", "--eps=2;3", "--back=0;0.1", *words, "-ox.csv")


def test_what_is_computed_in_balls_has_short_parts_and_a_dataset_its_reasons() -> None:
    plan = planned("kurbel.commands.orders.harmonics:harmonics_table", {"ratio": "0.001..1.1:0.001"})
    # Four records each: some seconds in all.
    assert len(Sweep(plan)) / Sweep(plan).rows_at_once > 8
    found = sweep("harmonics", ratio="0.2..1.09:0.01")
    assert found["refused"].any() and found["reason"].values[-1, 0]


def test_a_power_without_end_is_no_condition_that_takes_long() -> None:
    # Its exact value would have more figures than there is memory for.
    endless, nine = Condition("eps**eps**eps**99 < 1"), {"eps": np.array([9.0])}
    assert not endless.holds(nine, lambda place: {"eps": Fraction(9)}, 1).any()


@pytest.mark.parametrize(
    "text",
    [
        "((((ratio**64)**64)**64)**64)**64 == 0",
        "((((1 + ratio)**64)**64)**64)**64 == (((1 + ratio)**64)**64)**128",
        "ratio**-99999999999 * ratio == 1",
        "(1 + ratio/10**50)**(10**9) == 1",
    ],
)
def test_a_number_that_would_outgrow_all_is_refused_before_it_is_computed(text: str) -> None:
    before = process_time()
    with pytest.raises(KurbelError, match=r"more than 3000 figures|beyond 10\^308"):
        points(eps="2..4", ratio="1:5", only=text)
    assert process_time() - before < SOME_SECONDS


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
    assert len(points(eps="2..4", ratio="1:5", only=text)) == count


def test_too_many_rows_are_refused_before_any_is_computed() -> None:
    said = refusal(
        "sweep", "delta", "--eps=1..1000:0.001", "--back=0..1:0.001", "--clearance=0..1:0.001", "-ox.csv"
    )
    assert said.startswith("the sweep would have 1000999999001 rows") or "10^12" in said
    with pytest.raises(KurbelError, match="10\\^7 are tried"):
        points(eps="1..1000:0.001", back="0..1:0.001", only="back < eps")
    assert MOST_TRIED == 5 * 10**7


def test_a_sobol_design_is_scipys_between_the_ends_and_can_be_typed_again() -> None:
    found = points(eps="1..10", ratio="1:3..8", back="0..20%", sample="sobol:16", seed=7)
    unit = qmc.Sobol(3, seed=7).random(16)
    lengths = [1 / one["ratio"] for one in found]
    np.testing.assert_allclose([float(one["eps"]) for one in found], 1 + 9 * unit[:, 0], rtol=0, atol=1e-5)
    np.testing.assert_allclose([*map(float, lengths)], 3 + 5 * unit[:, 1], rtol=0, atol=1e-5)
    backs = [float(one["back"].removesuffix("%")) for one in found]
    np.testing.assert_allclose(backs, 20 * unit[:, 2], rtol=0, atol=1e-4)
    # Typed again, one of them is the same engine.
    again = points(eps=found[5]["eps"], ratio=f"1:{float(lengths[5])};1:2", back=found[5]["back"])
    assert again[0]["ratio"] == found[5]["ratio"]
    assert points(eps="1..10", sample="random:5", seed=1) != points(eps="1..10", sample="random:5", seed=2)
    assert {one["method"] for one in points(eps="2..3", method="exact;series", sample="lhs:8")} == {
        "exact",
        "series",
    }


def test_a_path_in_strokes_and_in_per_cent_is_that_of_the_textbook() -> None:
    for row in swept("table", "--ratio=1:4", "--angle=0..360:15", "--columns=x,x_stroke,x_percent"):
        angle = radians(float(row["phi"]))
        path = 1 - cos(angle) + 4 - sqrt(16 - sin(angle) ** 2)
        found = [float(row[key]) for key in ("x", "x_stroke", "x_percent")]
        assert found == pytest.approx([path, path / 2, 50 * path], rel=1e-12, abs=1e-15)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["delta", "--eps=2;3", "--back=0.1", "--zip=eps,back"], "there is no option with several values"),
        (["delta", "--eps=2;3", "--back=0;0.1;0.2", "--zip=eps,back"], "2 of --eps, 3 of --back"),
        (["delta", "--eps=1..10", "--sample=sobol:100"], "a power of two, 64 or 128"),
        (["delta", "--eps=1..10:1", "--sample=sobol:64"], "has a step"),
        (["delta", "--eps=2", "--sample=sobol:64"], "needs something that varies"),
        (["delta", "--eps=2;3", "--seed=3"], "--seed is of a sample"),
        (["delta", "--eps=2;;3"], "has an empty place"),
        (["delta", "--bore=300mm..20kg"], "has the units mm and kg"),
        (["delta", "--back=abc;0.1"], "is no number"),
        (["delta", "--eps=2;3", "--lang=xy"], "there is no language"),
        (["delta", "--eps=2;3", "--caption=A"], "there is no option"),
        (
            ["delta", "--eps=2;3", "--digits=3", "-f", "netcdf"],
            "NetCDF and Zarr have no decimals; write .parq",
        ),
        (["detla", "--eps=2;3"], "did you mean delta?"),
        (["collate"], "there is no command that can be swept"),
        (["table", "--ratio=1;2;3", "--angle=0"], "crank ratio"),
    ],
)
def test_what_cannot_be_swept_is_one_sentence(words: list[str], said: str, tmp_path: Path) -> None:
    assert said in refusal("sweep", *words, "-o", str(tmp_path / "sweep.csv"))
    assert not [*tmp_path.iterdir()]


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


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("eps = ", "epps = ", 'line 7: there is no option of kurbel delta "epps" (did you mean eps?)'),
        ('"delta"', '"detla"', 'line 1: there is no command that can be swept "detla" (did you mean delta?)'),
        ("command", "comand", 'line 1: there is no key of a sweep "comand"'),
        ('"40%"', '"abc"', 'line 10: back "abc" is no number'),
        ("exponent = 1.1", "exponent = [1, 2]", "line 13: exponent has several values; put it under [axes]"),
        ("back = [0, 0.1,", "back = [[0], 0.1,", "line 10: back is a list; it must be a text"),
        (
            'only = ["eps*back < 1"]',
            "digits = 99",
            "line 3: digits is 99; it must be a whole number from 0 to 50",
        ),
        ("command", "comm and", "cannot read the sweep"),
    ],
)
def test_what_is_amiss_in_a_file_is_told_with_its_line(old: str, new: str, said: str, tmp_path: Path) -> None:
    (tmp_path / "sweep.toml").write_text(FILE.replace(old, new, 1))
    assert said in refusal("sweep", str(tmp_path / "sweep.toml"), code=1)
    assert [path.name for path in tmp_path.iterdir()] == ["sweep.toml"]
