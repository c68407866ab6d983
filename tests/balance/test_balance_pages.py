"""Pages of harmonics and of balance: against the motion itself, textbooks' series, and summed forces."""

from __future__ import annotations

import math
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from cli import printed, refusal
from numpy.typing import NDArray
from pages import BALANCES, BEAMS, cells, shown

import kurbel
from kurbel.balance.angles.page import quantities as angle_quantities
from kurbel.balance.arrangement import usual
from kurbel.balance.page import balance_registry
from kurbel.balance.words import ENGINES
from kurbel.errors import KurbelError
from kurbel.exact.numerals import Number
from kurbel.motion.evaluation import METHODS
from kurbel.page.labels import plain
from kurbel.page.layouts import LANGUAGES
from kurbel.page.table import Table

STEPS = 256
TURN = 2 * np.pi * np.arange(STEPS) / STEPS
HALF_UNIT = 0.5 + 1e-6
ZERO = "0"


def motion(key: str, phi: Any, ratio: float) -> Any:
    """Return path, velocity or acceleration from the triangle of crank, rod and slide."""
    sine, cosine = np.sin(phi), np.cos(phi)
    slant = np.sqrt(1 - (ratio * sine) ** 2)
    return {
        "x": 1 - cosine + (1 - slant) / ratio,
        "c": sine + ratio * sine * cosine / slant,
        "p": cosine + ratio * (cosine**2 - sine**2) / slant + ratio**3 * (sine * cosine) ** 2 / slant**3,
    }[key]


def fourier(key: str, ratio: float, order: int) -> float:
    wave = np.sin if key == "c" else np.cos
    mean = (motion(key, TURN, ratio) * wave(order * TURN)).mean()
    return float(mean * (2 if order else 1))


@pytest.mark.parametrize("key", ["x", "c", "p"])
def test_harmonics_are_those_of_the_motion(key: str) -> None:
    page = printed("harmonics", "--ratio=1:3;1:4,5", f"--quantity={key}", "--orders=9", "-f", "csv")
    records = page.records()
    orders = [0, 1, 2, 4, 6, 8] if key == "x" else [1, 2, 4, 6, 8]
    assert [int(record["order"]) for record in records] == orders * 2
    assert [record["ratio"] for record in records] == ["1:3"] * len(orders) + ["1:4.5"] * len(orders)
    for record in records:
        true = fourier(key, 1 / float(record["ratio"].removeprefix("1:")), int(record["order"]))
        assert abs(float(record["value"]) - true) < HALF_UNIT * 1e-6


@pytest.mark.parametrize("lang", LANGUAGES)
def test_every_harmonic_stands_under_its_order_and_ratio(lang: str) -> None:
    page = kurbel.harmonics_table(["1:4", "1:5"], quantity="c", orders=4, lang=lang)
    assert cells(page) == {
        ("", shown(order), "$C_k$, $R:L$", ratio): shown(value) for order, ratio, value in page.records.rows
    }


def notes(page: Table) -> str:
    return "\n".join(plain(note.text) for note in page.notes)


def test_the_series_are_those_of_the_textbooks() -> None:
    # B_2 = λ + λ³/4 + 15 λ⁵/128, B_4 = -(λ³/4 + 3 λ⁵/16), B_6 = 9 λ⁵/128 in all of them.
    text = notes(kurbel.harmonics_table())
    assert "B₁ = 1; B₂ = λ + λ³/4 + 15 λ⁵/128 + …; B₄ = − λ³/4 − 3 λ⁵/16 − " in text
    assert "B₆ = 9 λ⁵/128 + " in text
    assert "p R/v² = B₁ cos φ + B₂ cos 2 φ + B₄ cos 4 φ + …" in text
    # The first-order motion: x/R = 1 - cos φ + ½ λ sin² φ, c/v = sin φ + ½ λ sin 2φ, p = cos φ + λ cos 2φ.
    for key, formulas in {
        "x": "A₀ = 1 + λ/4; A₁ = − 1; A₂ = − λ/4",
        "c": "C₁ = 1; C₂ = λ/2",
        "p": "B₁ = 1; B₂ = λ",
    }.items():
        assert notes(kurbel.harmonics_table(quantity=key, method="series")).endswith(
            f"Mit λ = R/L: {formulas}\nUngerade Ordnungen über 1 sind 0"
        )
    assert "…" not in notes(kurbel.harmonics_table(method="series"))


def test_what_is_zero_by_proof_has_no_decimals() -> None:
    assert values(kurbel.harmonics_table("1:4", method="series")) == ["1.000000", "0.250000", "0", "0"]
    assert values(kurbel.harmonics_table("1:∞")) == ["1.000000", "0", "0", "0"]
    single = kurbel.balance_table("inline-1", ratio="1:∞", columns="greatest")
    assert values(single) == ["1.0000", "0", "0", "0"]
    tiny = values(kurbel.harmonics_table("1:100"))
    assert tiny == ["1.000000", "0.010000", "0.000000", "0.000000"]


def values(page: Table, column: int = -1) -> list[str]:
    return [shown(row[column]) for row in page.records.rows]


@pytest.mark.parametrize("make", [kurbel.harmonics_table, kurbel.balance_table])
def test_an_infinite_rod_has_no_ratios(make: Any) -> None:
    page = make(ratio=["1:4", "1:5"], method="infinite")
    assert {row[0] for row in page.records.rows} | {row[1] for row in page.records.rows} >= {"$1:∞$"}
    assert page.caption.endswith(METHODS["infinite"].caption["de"])
    assert "λ" not in notes(page)
    assert len(page.panels[0].columns) in (1, 5)


# Balance -----------------------------------------------------------------------------------------

SQUARE = ("--cranks=0;0;90;90", "--positions=3;3;5;5", "--banks=-30;45;-30;45", "--share=0,3")


def pushed(ratio: float, moments: bool) -> NDArray[np.complex128]:
    """Return the force of the pistons and counterweights of SQUARE over a turn, or their moment."""
    total = np.zeros(STEPS, complex)
    for crank, position, bank in zip((0, 0, 90, 90), (-1, -1, 1, 1), (-30, 45, -30, 45), strict=True):
        pin, slide = TURN + math.radians(crank), math.radians(bank)
        piston = motion("p", pin - slide, ratio) * np.exp(1j * slide)
        total += (position if moments else 1) * (piston - 0.3 * np.exp(1j * pin))
    return total


def test_an_engine_of_ones_own_has_the_forces_of_its_pistons() -> None:
    columns = "residual,order,along,across,forward,backward,greatest,least"
    words = ("balance", *SQUARE, "--orders=4", "--ratio=1:4", f"--columns={columns}", "-f", "csv")
    records = printed(*words).records()
    heads = [(record["residual"], int(record["order"])) for record in records]
    assert heads == [(residual, order) for residual in ("force", "moment") for order in (1, 2, 4)]
    for (residual, order), record in zip(heads, records, strict=True):
        total = pushed(0.25, residual == "moment")
        forward, backward = ((total * np.exp(turn * order * TURN)).mean() for turn in (-1j, 1j))
        true = {
            "along": abs(forward + backward.conjugate()),
            "across": abs(forward - backward.conjugate()),
            "forward": abs(forward),
            "backward": abs(backward),
            "greatest": abs(forward) + abs(backward),
            "least": abs(abs(forward) - abs(backward)),
        }
        for key, value in true.items():
            assert abs(float(record[key]) - value) < HALF_UNIT * 1e-4, (residual, order, key)


# Greatest forces and moments of the first two orders for λ = 1/4 to first order, as textbooks tabulate them.
@pytest.mark.parametrize(
    ("engine", "expected"),
    [
        ("inline-1", ["1.000", "0.250", "0", "0"]),
        ("inline-2-180", ["0", "0.500", "1.000", "0"]),
        ("inline-3", ["0", "0", "1.732", "0.433"]),
        ("inline-4", ["0", "1.000", "0", "0"]),
        ("inline-6", ["0", "0", "0", "0"]),
        ("v2-90", ["1.000", "0.354", "0", "0"]),
        ("v8-90", ["0", "0", "3.162", "0"]),
        ("boxer-4", ["0", "0", "0", "0.500"]),
    ],
)
def test_engines_have_the_forces_and_moments_of_the_tables(engine: str, expected: list[str]) -> None:
    page = kurbel.balance_table(engine, ratio="1:4", method="series", digits=3, columns="greatest")
    assert values(page) == expected


def test_four_in_line_keep_four_times_the_second_harmonic() -> None:
    page = kurbel.balance_table("inline-4", ratio="1:5", orders=6, digits=12, columns="factor,along")
    for row in list(page.records.rows)[1:4]:
        factor, along = (Decimal(cell.scaled) for cell in row[-2:] if isinstance(cell, Number))
        assert abs(4 * abs(factor) - along) <= 2
        assert along


def test_a_counterweight_halves_the_force_of_one_cylinder_and_turns_the_rest_across() -> None:
    page = kurbel.balance_table("inline-1", share="50%", columns="along,across")
    assert [tuple(map(shown, row)) for row in page.records.rows][:2] == [
        ("force", "1", "0.5000", "0.5000"),
        ("force", "2", "0.2020", "0"),
    ]
    assert "von jeder Masse m den Teil 0.5 aus" in notes(page)
    assert "Gegengewichte" not in notes(kurbel.balance_table("inline-1"))
    # Two rods on a pin of a V of 90° bring two halves: the first order is balanced.
    assert values(kurbel.balance_table("v2-90", share=Fraction(1, 2), columns="greatest"))[0] == ZERO


def test_a_named_engine_is_that_of_its_cranks() -> None:
    own = kurbel.balance_table(cranks=[0, 180, 180, 0], banks="0;180;0;180", positions=[7, 8, 9, 10])
    assert list(own.records.rows) == list(kurbel.balance_table("boxer-4").records.rows)
    even = kurbel.balance_table(cranks="0;240;120")
    assert list(even.records.rows) == list(kurbel.balance_table("inline-3").records.rows)
    assert "3 Zylinder" in even.caption
    assert "Kurbeln: 0°; 240°; 120°\nLagen in a: −1; 0; 1" in notes(even)


def test_moments_are_about_the_middle_wherever_positions_count_from() -> None:
    for positions in ("0;0;1;1", "-8;-8;-7;-7"):
        page = kurbel.balance_table(cranks="0;0;90;90", positions=positions, banks="-45;45;-45;45")
        # Each pair pushes with 1, the pairs square to each other and ½ from the middle.
        assert values(page, -2) == ["1.4142", ZERO, "0.7071", "0.2857"]


@pytest.mark.parametrize("lang", LANGUAGES)
@pytest.mark.parametrize("engine", list(usual()))
def test_every_engine_has_a_name_and_a_page(engine: str, lang: str) -> None:
    page = kurbel.balance_table(engine, ratio=["1:4", "1:5"], lang=lang)
    assert ENGINES[engine][LANGUAGES.index(lang)] in page.caption
    assert len(cells(page)) == 2 * 2 * 2 * 5
    assert "{" not in notes(page) + page.caption


def test_cells_of_a_page_are_its_records() -> None:
    # With masses every column is known.
    weighed: dict[str, Any] = {"reciprocating": 2, "stroke": 0.09, "speed": 50, "spacing": 0.1}
    columns = list(balance_registry())
    page = kurbel.balance_table("v6-90", ratio=["1:4", "1:5"], orders=4, columns=columns, **weighed)
    heads = {
        key: tuple(one["de"] for one in (*column.spanners, column.heading))
        for key, column in balance_registry().items()
    }
    groups = {"force": "Kräfte in $m R ω^2$", "moment": "Momente in $m R ω^2 a$"}
    expected = {}
    axes = ["ratio", "residual", "order"]
    assert [field.key for field in page.records.fields] == axes + columns
    keys = [
        (ratio, residual, order) for ratio in ("1:4", "1:5") for residual in groups for order in (1, 2, 4)
    ]
    for (ratio, residual, order), row in zip(keys, page.records.rows, strict=True):
        assert [shown(value) for value in row[:3]] == [f"${ratio}$", residual, str(order)]
        for key, value in zip(columns, row[3:], strict=True):
            group = f"$R:L = {ratio}$, {groups[residual]}"
            expected[group, str(order), *heads[key]] = shown(value)
    assert cells(page) == expected


def test_an_engine_of_the_environment_gives_way_to_cranks() -> None:
    words = ("balance", "--cranks", "0;240;120", "-f", "csv")
    assert printed(*words, KURBEL_BALANCE_ENGINE="inline-6").out == printed(*words).out


NAMES = ", ".join(usual())
COUNT = "does not say up to which one; write a whole number from 1 to 100"
SHARE = "it must lie within 0..1, for it is a share of the reciprocating mass"


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (
            ("--engine", "inlin4"),
            f'there is no engine "inlin4" (did you mean inline-4?); choose from {NAMES}',
        ),
        (("--engine", ""), f'there is no engine ""; choose from {NAMES}'),
        (
            ("--cranks", "0;180", "--positions", "0;1;2"),
            "the number of positions is 3 and that of cranks 2; every cylinder needs one of each",
        ),
        (
            ("--cranks", "0;180", "--banks", "0"),
            "the number of banks is 1 and that of cranks 2; every cylinder needs one of each",
        ),
        (
            ("--positions", "0;1"),
            "positions and banks are those of the cylinders in --cranks; give these, for example --cranks"
            " '0;180;180;0'",
        ),
        (
            ("--engine", "boxer-2", "--cranks", "0;180"),
            "--engine has its cranks and --cranks gives others; leave one of the two out",
        ),
        (("--cranks", "0..24:1"), "25 cylinders were given; an engine has 1 to 24"),
        (
            ("--cranks", "0;90", "--positions", "1;1"),
            "cylinders 1 and 2 are both at position 0 in the bank at 0°; they must differ in one of the two",
        ),
        (("--cranks", "0;x"), 'angle "x" is not an angle in degrees; write it as 22.5 or 22°30\''),
        (
            ("--cranks", "0;90", "--positions", "0;x"),
            'position "x" is not a number; write it as 4.5 or 4,5',
        ),
        (("--share", "1.5"), f"share of the counterweights is 1.5; {SHARE}"),
        (("--share=-10%",), f"share of the counterweights is -0.1; {SHARE}"),
        (("--orders", "0"), f'orders "0" {COUNT}'),
        (("--orders", "101"), f'orders "101" {COUNT}'),
        (("--orders", "two"), f'orders "two" {COUNT}'),
        (("--columns", "order"), "there is no column beside the axes; add one, such as along"),
        (
            ("--layout", "harmonics"),
            "layout harmonics is about something else; choose from balance, balance-angle, balance-greatest",
        ),
        (
            ("--columns", "alog"),
            'there is no column "alog" (did you mean along?); choose from ratio, residual, order, '
            + ", ".join(balance_registry()),
        ),
        (
            ("--ratio", "1:1"),
            "crank ratio R:L is 1; it must be below 1, or the rod is too short to pass the dead centre",
        ),
    ],
)
def test_engines_that_cannot_be_balanced_are_refused(words: tuple[str, ...], sentence: str) -> None:
    assert refusal("balance", *words) == sentence


def test_harmonics_that_are_not_known_are_refused() -> None:
    assert refusal("harmonics", "--orders=101") == f'orders "101" {COUNT}'
    assert refusal("harmonics", "--quantity=y") == 'there is no quantity "y"; choose from x, c, p, torque'
    assert refusal("harmonics", "--method=blau").startswith('there is no method "blau"; choose from exact')
    for orders in (0, 101, 2.5, "two"):
        said = f"^orders up to {orders} were asked for; the last must be a whole number from 1 to 100$"
        for make in (kurbel.harmonics_table, kurbel.balance_table):
            with pytest.raises(KurbelError, match=said):
                make(orders=orders)  # type: ignore[arg-type]
    with pytest.raises(KurbelError, match=r"^no crank ratio was given; write one as --ratio 1:5$"):
        kurbel.harmonics_table([])


@pytest.mark.parametrize("name", BALANCES)
def test_pages_are_not_made_as_pages_of_something_else(name: str) -> None:
    with pytest.raises(KurbelError, match=f"^layout {name} is about something else; choose from "):
        kurbel.table(layout=name)
    fitting = "balance, balance-angle, balance-greatest"
    with pytest.raises(
        KurbelError, match=f"^layout {BEAMS[0]} is about something else; choose from {fitting}$"
    ):
        kurbel.balance_table(layout=BEAMS[0])


def test_every_column_of_the_balance_is_listed_with_its_command() -> None:
    lines = [line.split() for line in printed("quantities", "--lang=en").out.splitlines()]
    listed = {line[0] for line in lines if "balance" in line}
    assert listed == {*balance_registry(), *angle_quantities(), "greatest_phi"}
    assert [line[-1] for line in lines if line[0] == "value"] == ["x", "c", "p"]
