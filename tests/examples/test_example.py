"""Worked examples: every printed figure is the book's, every recomputed one that of the formula."""

from __future__ import annotations

import csv
import re
import tomllib
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import cache
from typing import Any

import pytest
from cli import printed, records
from expansion import Expansion
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp
from places import SOURCES
from registers import BOOKS as SOURCE
from registers import printed_values, register

import kurbel

BOOKS = SOURCES / "examples"
EXAMPLES = [
    *(("blau", str(number)) for number in range(31, 36)),
    ("uebung", "12"),
    ("weisbach", "149"),
    ("weisbach", "150"),
]
Real = Any
Given = Mapping[str, Fraction]


@pytest.fixture(autouse=True)
def bits() -> Iterator[None]:
    with mp.workprec(640):
        yield


# What each step is, worked out with no root of a quadratic: cos α is where the acceleration is the target.


def real(value: Fraction) -> Real:
    return mp.mpf(value.numerator) / value.denominator


def at(angle: Callable[[Given], Real]) -> dict[str, Callable[[Given], Real]]:
    """Return the values of the motion at an angle in radians."""

    def path(given: Given) -> Real:
        here = angle(given)
        return 1 - mp.cos(here) + real(given["ratio"]) / 2 * mp.sin(here) ** 2

    return {
        "cosine": lambda given: mp.cos(angle(given)),
        "cosine_again": lambda given: mp.cos(angle(given)),
        "turned": lambda given: -mp.cos(angle(given)),
        "versine": lambda given: 1 - mp.cos(angle(given)),
        "sine": lambda given: mp.sin(angle(given)),
        "square": lambda given: (1 - mp.cos(2 * angle(given))) / 2,
        "share": lambda given: path(given) - 1 + mp.cos(angle(given)),
        "sum": lambda given: path(given) + mp.cos(angle(given)),
        "path": path,
        "stroke": lambda given: path(given) / 2,
        "alpha": lambda given: mp.degrees(angle(given)),
        "half_rod": lambda given: 1 / (2 * real(given["ratio"])),
    }


def cosines(target: Callable[[Given], Real]) -> Callable[[Given], list[Real]]:
    """Return the roots of cos α + λ cos 2α = target, searched on both sides of the vertex."""

    def found(given: Given) -> list[Real]:
        ratio = real(given["ratio"])

        def excess(cosine: Real) -> Real:
            return cosine + ratio * (2 * cosine**2 - 1) - target(given)

        vertex = -1 / (4 * ratio)
        return [
            mp.findroot(excess, (vertex, vertex + reach), "anderson") for reach in (9 / ratio, -9 / ratio)
        ]

    return found


def position(target: Callable[[Given], Real]) -> dict[str, Callable[[Given], Real]]:
    roots = cosines(target)
    return at(lambda given: mp.acos(roots(given)[0])) | {
        "other": lambda given: roots(given)[1],
        "other_alpha": lambda given: mp.degrees(mp.re(mp.acos(roots(given)[1]))),
        "root": lambda given: 2 * (roots(given)[0] - roots(given)[1]),
        "quarter_root": lambda given: (roots(given)[0] - roots(given)[1]) / 2,
        "numerator": lambda given: 4 * roots(given)[0],
        "dead_centre": lambda given: 1 + real(given["ratio"]),
        "vertex": lambda given: (roots(given)[0] + roots(given)[1]) / 2,
        "vertex_square": lambda given: (roots(given)[0] + roots(given)[1]) ** 2 / 4,
        "vertex_radicand": lambda given: (roots(given)[0] - roots(given)[1]) ** 2 / 4,
    }


def start(given: Given) -> Real:
    """One sixth of the acceleration at the dead centre, by eq. (26)."""
    return (1 + real(given["ratio"])) / 6


def lean(given: Given, side: int) -> Real:
    rod = 1 / real(given["ratio"])
    return 1 / (4 * real(given["beam"]) * (rod + side))


def force(given: Given) -> Real:
    return real(given.get("force", Fraction(1)))


SQUARE = {
    "alpha": lambda given: mp.degrees(mp.atan(real(given["ratio"]))),
    "rod": lambda given: 1 / mp.cos(mp.atan(real(given["ratio"]))),
    "rod_n": lambda given: force(given) / mp.cos(mp.atan(real(given["ratio"]))),
    "guide": lambda given: real(given["ratio"]),
    "guide_n": lambda given: force(given) * mp.tan(mp.atan(real(given["ratio"]))),
    "torque": lambda given: 1 / mp.cos(mp.atan(real(given["ratio"]))),
    "torque_n": lambda given: force(given) / mp.cos(mp.atan(real(given["ratio"]))),
}
BEAM = {
    "mu_radians": lambda given: lean(given, 1),
    "nu_radians": lambda given: lean(given, -1),
    "mu": lambda given: mp.degrees(lean(given, 1)),
    "nu": lambda given: mp.degrees(lean(given, -1)),
    "distance_1": lambda given: 180 + mp.degrees(lean(given, -1) - lean(given, 1)),
    "distance_2": lambda given: 180 - mp.degrees(lean(given, -1) - lean(given, 1)),
    "path_1": lambda given: 1 - mp.cos(lean(given, 1)),
    "path_2": lambda given: 1 - mp.cos(lean(given, -1)),
}


STEAM_KEYS = ("alpha_min", "v_min", "alpha_max", "v_max")


def steam(given: Given) -> Expansion:
    back = real(given["back"]) if "back" in given else None
    return Expansion(real(given["ratio"]), real(given["eps"]), back)


def of_steam(key: str) -> Callable[[Given], Real]:
    """Return a value of § 150, angles in degrees."""
    return lambda given: (mp.degrees if "alpha" in key else mp.mpf)(steam(given).value(key))


STEAM = {
    **{key: of_steam(key) for key in ("sum", "mean_force", "divisor", "delta")},
    **{f"{key}{stroke}": of_steam(f"{key}{stroke}") for key in STEAM_KEYS for stroke in ("", "_return")},
    "least": of_steam("v_min_return"),
    "greatest": of_steam("v_max"),
}
VALUES: Mapping[tuple[str, str], Mapping[str, Callable[[Given], Real]]] = {
    ("blau", "31"): at(lambda given: mp.radians(real(given["angle"]))),
    ("blau", "32"): at(lambda given: mp.radians(real(given["angle"]))),
    ("blau", "33"): position(lambda given: mp.mpf(0)),
    ("blau", "34"): position(start),
    ("blau", "35"): position(lambda given: -start(given)),
    ("uebung", "12"): SQUARE,
    ("weisbach", "149"): BEAM,
    ("weisbach", "150"): STEAM,
}


def worked(*words: str) -> list[dict[str, str]]:
    return records("example", *words)


@cache
def parts_of(key: str, number: str) -> dict[str, Given]:
    """Return what is given in the parts of an example by their letters."""
    with (SOURCE / key / f"{number}.toml").open("rb") as file:
        parts = tomllib.load(file)["part"]
    return {
        part.get("letter", ""): {
            name: Fraction(part[name].replace(":", "/"))
            for name in ("ratio", "angle", "beam", "eps", "back")
            if name in part
        }
        for part in parts
    }


def as_printed(value: Real, like: str) -> str:
    """Return the value written as the figure `like` is, rounded half away from zero."""
    if "/" in like:
        return like if abs(value - real(Fraction(like.replace("−", "-")))) < mp.mpf(2) ** -500 else "no"
    sign = "-" if value < 0 else ""
    if "°" not in like:
        decimals = len(like.partition(".")[2])
        digits = str(to_nearest(abs(value) * 10**decimals)).rjust(decimals + 1, "0")
        text = f"{digits[:-decimals]}.{digits[-decimals:]}" if decimals else digits
        return sign * any(one in text for one in "123456789") + text
    if "′" not in like:
        return f"{to_nearest(value)}°"
    halves = to_nearest(value * (120 if "½" in like else 60)) * (1 if "½" in like else 2)
    minutes, half = divmod(halves, 2)
    return f"{minutes // 60}°{minutes % 60}{'½' * half}′"


def to_nearest(value: Real) -> int:
    """Round half up; a value that is a tie within 600 bits is one."""
    return int(mp.floor(value + mp.mpf("0.5") + mp.mpf(2) ** -400))


def assert_true(key: tuple[str, str], given: Given, rows: list[dict[str, str]]) -> None:
    steps = [row for row in rows if row["step"]]
    assert steps
    for row in steps:
        value = VALUES[key][row["step"]](given)
        assert row["recomputed"] == as_printed(value, row["recomputed"]), (key, given, row)


@pytest.mark.parametrize(("key", "number"), EXAMPLES)
def test_recomputed_figures_are_those_of_the_formulas(key: str, number: str) -> None:
    rows, parts = worked(key, number), parts_of(key, number)
    assert any(parts.values()) == (key != "uebung")
    for letter, numbers in parts.items():
        if numbers:
            own = [row for row in rows if row["part"] == letter]
            assert_true((key, number), numbers, own)
            for row in own:
                if row["printed"] and "/" not in row["printed"]:
                    places = ["½" in row[name] for name in ("printed", "recomputed")]
                    assert places[0] >= places[1]
                    assert len(row["printed"].partition(".")[2]) == len(row["recomputed"].partition(".")[2])


OWN = [
    *(("blau", number, {"ratio": ratio}) for number in ("33", "34", "35") for ratio in
      ("1:4.5", "1:12", "5:6", "99:100")),
    *(("blau", number, {"ratio": "1:4.5", "angle": angle}) for number in ("31", "32")
      for angle in ("0", "101.3", "270")),
    ("uebung", "12", {"ratio": "2:9", "force": "10000"}),
    ("uebung", "12", {"ratio": "3:4", "force": "1234.5"}),
    ("weisbach", "149", {"ratio": "1:4", "beam": "3"}),
    ("weisbach", "149", {"ratio": "1:5", "beam": "2.5"}),
    ("weisbach", "150", {"ratio": "1:5", "eps": "3"}),
    ("weisbach", "150", {"ratio": "1:4", "eps": "2.5", "back": "0.2"}),
    ("weisbach", "150", {"ratio": "1:5", "eps": "4", "back": "0.1"}),
]  # fmt: skip


@pytest.mark.parametrize(("key", "number", "own"), OWN, ids=str)
def test_other_numbers_are_worked_in_the_same_steps(key: str, number: str, own: dict[str, str]) -> None:
    words = [f"--{name}={value + 'N' * (name == 'force')}" for name, value in own.items()]
    rows = worked(key, number, *words)
    given = {
        name: Fraction(*map(Fraction, value.split(":"))) if ":" in value else Fraction(value)
        for name, value in own.items()
    }
    assert_true((key, number), given, rows)
    assert not any(row["printed"] for row in rows)


RATIOS = st.fractions(Fraction(1, 60), Fraction(59, 60), max_denominator=83)


@settings(max_examples=15, deadline=None)
@given(RATIOS, st.sampled_from(["33", "34", "35"]))
def test_any_ratio_is_worked(ratio: Fraction, number: str) -> None:
    text = kurbel.typeset(kurbel.example("blau", number, ratio=ratio), "csv")
    rows = [row for row in csv.DictReader(text.splitlines())]
    with mp.workprec(640):
        assert_true(("blau", number), {"ratio": ratio}, rows)


# Which figures differ from print: recomputed less printed, in units of the last place.
DIFFERENT = {
    ("blau", "31", "c", "stroke"): "1",
    ("blau", "32", "a", "path"): "-1",
    ("blau", "33", "a", "half_rod"): "",
    ("blau", "33", "a", "alpha"): "-4",
    ("blau", "33", "a", "path"): "-1",
    ("blau", "33", "a", "stroke"): "-1",
    ("blau", "33", "b", "path"): "-1",
    ("blau", "33", "b", "stroke"): "-1",
    ("blau", "34", "", "alpha"): "-2",
    ("blau", "34", "", "sine"): "-1",
    ("weisbach", "150", "", "alpha_min_return"): "-92",
    ("weisbach", "150", "", "alpha_min"): "1",
    ("weisbach", "150", "", "v_min"): "254",
    ("weisbach", "150", "", "sum"): "-54",
    ("weisbach", "150", "", "mean_force"): "1",
    ("weisbach", "150", "", "delta"): "-24",
}


def test_the_figures_that_differ_are_known() -> None:
    found = {
        (key, number, row["part"], row["step"]): row["difference"]
        for key, number in EXAMPLES
        for row in worked(key, number)
        if row["printed"] and row["printed"] != row["recomputed"]
    }
    assert found == DIFFERENT


# The lines of the book as transcribed, in LaTeX; of the page every figure, powers and indices included.
FIGURE = re.compile(r"[0-9]+(?:,[0-9]+)?")
SMALL = str.maketrans({small: f" {digit} " for digit, small in enumerate("₀₁₂₃₄₅₆₇₈₉")} | {"²": " 2 "})


def book_lines(key: str) -> dict[tuple[str, str], str]:
    """Return the book's working of each part."""
    text = (BOOKS / f"{key}.tex").read_text(encoding="utf-8")
    parts: dict[tuple[str, str], str] = {}
    for block in text.split("% ")[1:]:
        head, lines = block.split("\n", 1)
        number, _, letter = head.partition(" ")
        parts[number, letter] = lines
    return parts


def figures_of_book(lines: str) -> list[str]:
    # In § 149 a raised 0 is the sign of degrees, which the page has.
    return FIGURE.findall(lines.replace("^0", " ").replace(r"m v_1", "m_1 v_1"))


@pytest.mark.parametrize(("key", "number"), EXAMPLES)
def test_the_figures_of_the_working_are_those_of_the_book(key: str, number: str) -> None:
    rows = printed("example", key, number, "-f", "csv", "--decimal", "comma").records(";")
    for letter in parts_of(key, number):
        lines = [row["line"] for row in _firsts(rows, letter)]
        page = " ".join(line for line in lines if not line.startswith("["))
        page = page.replace("½", " 1 2").translate(SMALL)
        assert FIGURE.findall(page) == figures_of_book(book_lines(key)[number, letter])


def _firsts(rows: list[dict[str, str]], letter: str) -> Iterator[dict[str, str]]:
    """Yield one record for each line."""
    before = None
    for row in rows:
        if row["part"] == letter and row["line"] != before:
            yield row
        before = row["line"]


def test_every_printed_value_stands_in_its_example() -> None:
    counted = 0
    for key, number in EXAMPLES:
        shown = (row["printed"].replace("−", "-").replace("′", "'").replace(".", ",")
                 for row in worked(key, number) if row["printed"])  # fmt: skip
        values = printed_values(f"{key}-{number}") if key != "uebung" else {}
        # The table of δ at the end of § 150 is none of the example's steps.
        held = [text for place, text in values.items() if "table" not in place]
        assert Counter(shown) == Counter(held), (key, number)
        counted += len(held)
    assert counted == 86


def test_figures_of_section_150_are_those_of_its_register() -> None:
    cells = {row["place"].split("/2/")[-1]: row for row in register(SOURCES / "weisbach" / "150.csv")}
    for row in worked("weisbach", "150"):
        if row["step"]:
            cell = cells[row["step"]]
            assert row["printed"].replace(".", ",").replace("′", "'") == cell["printed"]
            assert row["recomputed"].replace(".", ",").replace("′", "'") == cell["weisbach"]


def test_the_unusable_root_is_named_and_a_second_usable_one_worked() -> None:
    rows = worked("blau", "35", "--ratio=1:4,5", "--lang=en")
    assert [row["line"] for row in rows if row["step"] == "other"] == ["cos α = −2.2684, unusable"]
    assert not [row for row in rows if row["step"] == "other_alpha"]
    both = worked("blau", "35", "--ratio=5:6", "--lang=en")
    assert [row["line"] for row in both if row["step"].startswith("other")] == [
        "cos α = −0.9377",
        "α = 159°40′",
    ]
    edge = worked("blau", "35", "--ratio=5:7")
    assert [row["recomputed"] for row in edge if row["step"] == "other_alpha"] == ["180°0′"]


def test_numbers_of_the_book_bring_its_printed_figures() -> None:
    rows = worked("blau", "33", "--ratio=1:4;1:6")
    assert {row["part"] for row in rows} == {"b", "R:L = 1:6"}
    assert all(bool(row["printed"]) == (row["part"] == "b") for row in rows if row["step"] == "alpha")


def test_ties_are_rounded_away_from_zero() -> None:
    # 1 + 1/8 · 1/2 = 1.0625 and 1.125/2 = 0.5625, as the book has them too.
    rows = {(row["part"], row["step"]): row["recomputed"] for row in worked("blau", "32")}
    assert rows["a", "sum"] == "1.063"
    assert rows["b", "stroke"] == "0.563"


def test_from_python_it_is_the_same_page() -> None:
    table = kurbel.example("blau", 33, ratio="1:4,5", lang="en")
    assert kurbel.typeset(table, "text") == printed("example", "blau", "33", "--ratio=1:4,5", "--lang=en").out
    steam = kurbel.example("weisbach", 150, eps=4, back="10%")
    assert kurbel.typeset(steam, "text") == printed("example", "weisbach", "150", "--eps=4", "--back=10%").out
    forces = kurbel.example("uebung", 12, ratio="1:4", force=5000)
    assert kurbel.typeset(forces, "text") == printed("example", "uebung", "12", "-r1:4", "--force=5kN").out
    with pytest.raises(kurbel.KurbelError, match="no source"):
        kurbel.example("x", 1)


def test_without_a_number_the_examples_are_listed() -> None:
    lines = printed("example").out.splitlines()
    assert [tuple(line.split()[:2]) for line in lines] == EXAMPLES
    assert printed("example", "weisbach", "--lang=en").out.splitlines() == [
        "weisbach  149  Dead centres of the beam engine                 --ratio --beam",
        "weisbach  150  Degree of irregularity of the expansion engine  --eps --ratio --back",
    ]
