"""Printed formulas: what is proved is so by mpmath, what is refuted differs, and nothing else is proved."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from functools import cache
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory
from time import process_time
from typing import Any

import pytest
from cli import kurbel, printed, records
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp
from places import ROOT
from registers import FORMULAS as KEYS
from registers import formulas, letters_of

from kurbel.books.formula_page import formula_lines, room_beside
from kurbel.page.labels import plain, rows_of

FUNCTIONS = {
    "sin": mp.sin, "cos": mp.cos, "tan": mp.tan, "cot": mp.cot, "sqrt": mp.sqrt, "ln": mp.log,
    "arcsin": mp.asin, "arctan": mp.atan, "pi": mp.pi, "mpf": mp.mpf,
}  # fmt: skip
HEADS = "place;label;printed;follows;relation;letter;form"


@pytest.fixture(autouse=True)
def digits() -> Iterator[None]:
    with mp.workdps(40):
        yield


@cache
def collated(key: str) -> list[dict[str, str]]:
    """Return the steps of a section: the file's rows, what they are found to be, and the form before each."""
    steps, before = [], ""
    forms: dict[str, str] = {}
    for row, found in zip(formulas(key), records("collate", key), strict=True):
        assert row["place"] == found["place"]
        follows = forms.get(row["follows"], before)
        forms[row["place"]] = before = row["form"]
        steps.append(row | {"before": follows, "verdict": found["verdict"], "detail": found["detail"]})
    return steps


def steps_found(*kinds: str) -> list[tuple[str, dict[str, str]]]:
    return [(key, row) for key in KEYS for row in collated(key) if row["verdict"] in kinds]


def own(folder: Path, rows: Iterable[str], letters: Mapping[str, str] | None = None) -> str:
    """Write a section of formulas of one's own, author-eq, and return its folder."""
    made = ", ".join(f'{name} = "{text}"' for name, text in (letters or {}).items())
    (folder / "author").mkdir(parents=True)
    book = f'citation = "Author"\n[formulas.eq]\nletters = {{ {made} }}\n'
    (folder / "author" / "source.toml").write_text(book, encoding="utf-8")
    (folder / "author" / "eq.csv").write_text("\n".join((HEADS, *rows, "")), encoding="utf-8")
    return str(folder)


def verdicts(folder: Path, steps: Iterable[tuple[str, ...]]) -> list[dict[str, str]]:
    """Return what steps are found to be: before, form, relation and letter, else equal and none."""
    rows = []
    for number, (before, form, *rest) in enumerate(steps):
        relation, letter = (*rest, *("equal", "")[len(rest) :])[:2]
        rows += [f"one_{number};;a;;;;{before}", f"two_{number};;a;;{relation};{letter};{form}"]
    return records("collate", "author-eq", "--sources", own(folder, rows))[1::2]


def by_mpmath(text: str, values: Mapping[str, Any], forms: Mapping[str, str]) -> Any:
    """Return a form's value by Python's own evaluation, with letters made of others worked out first."""
    if slope := re.fullmatch(r"slope\((.*), (\w+)\)", text):
        with mp.workdps(60):
            return mp.diff(lambda at: by_mpmath(slope[1], {**values, slope[2]: at}, forms), values[slope[2]])

    class Letters(dict[str, Any]):
        def __missing__(self, name: str) -> Any:
            self[name] = by_mpmath(forms[name], values, forms)
            return self[name]

    exact = re.sub(r"(?<![\w.])\d+(\.\d+)?", lambda match: f"mpf('{match[0]}')", text).replace("^", "**")
    return eval(exact, {}, Letters({**FUNCTIONS, **values}))


def numbers(key: str, row: Mapping[str, str], seed: int) -> dict[str, Any]:
    """Return numbers for the letters, below 1, with a crank shorter than its rod."""
    chosen, made = Random(seed), letters_of(key)
    wanted, seen = [row["before"], row["form"], row["letter"]], set[str]()
    while wanted:
        for name in {*re.findall(r"[A-Za-z_]\w*", wanted.pop())} - {*FUNCTIONS, "slope"} - seen:
            seen.add(name)
            wanted.append(made.get(name, ""))
    return {
        name: mp.mpf(chosen.randint(200, 900)) / 1000
        for name in sorted(seen - made.keys() | {row["letter"]} - {""})
    }


# The books ------------------------------------------------------------------------------------------------


def test_what_the_books_have_wrong_is_known() -> None:
    """v = 2Rπn/60 is not Sπn/30 with S = 2R; 5/4 in 33 a); 1 ± r/l sin² α/2 of § 150 is of first order."""
    right = steps_found("proved", "order")
    assert {
        (key, row["place"]): (row["verdict"], row["detail"])
        for key in KEYS
        for row in collated(key)
        if row["relation"] and (key, row) not in right
    } == {
        ("blau-equations", "v_stroke"): ("factor", "2"),
        ("blau-solutions", "a_halved"): ("other_equation", ""),
        ("weisbach-equations", "greatest_near"): ("only_nearly", "2"),
    }
    proved, nearly = len(steps_found("proved")), len(steps_found("order"))
    assert (proved, nearly) == (72, 8)
    text = " ".join((ROOT / "docs" / "books" / "index.md").read_text(encoding="utf-8").split())
    assert f"Of {proved + nearly + 3} steps in" in text
    assert f"{proved} are proved and {nearly} are the approximations" in text and "Three are wrong" in text


def test_what_is_proved_of_the_books_is_so_by_mpmath() -> None:
    count = 0
    for key, row in steps_found("proved"):
        for sign in (1, -1):
            values = numbers(key, row, count) | {"pm": sign}
            forms = dict(letters_of(key))
            if row["relation"] == "root":
                values.pop(row["letter"], None)
                forms[row["letter"]] = row["form"]
                assert abs(by_mpmath(row["before"], values, forms)) < mp.mpf(10) ** -35
            else:
                sides = [by_mpmath(row[form], dict(values), forms) for form in ("before", "form")]
                if row["relation"] == "same":
                    values[row["letter"]] += mp.mpf("0.05")
                    others = [by_mpmath(row[form], dict(values), forms) for form in ("before", "form")]
                    sides = [sides[0] * others[1], sides[1] * others[0]]
                assert mp.almosteq(*sides, rel_eps=mp.mpf(10) ** -30), (key, row)
            count += 1
    assert count == 144


def test_the_order_of_an_approximation_is_that_of_its_difference_by_mpmath() -> None:
    for key, row in steps_found("order", "only_nearly"):
        values = numbers(key, row, 1) | {"pm": 1}
        apart = []
        for small in (mp.mpf("1e-5"), mp.mpf("1e-6")):
            values[row["letter"]] = small
            left, right = (by_mpmath(row[form], dict(values), letters_of(key)) for form in ("before", "form"))
            apart.append(abs((left - right) / left))
        order = mp.log10(apart[0] / apart[1])
        assert abs(order - int(row["detail"])) < mp.mpf("0.01"), (key, row)


def test_no_other_formula_is_proved_in_place_of_a_proved_one(tmp_path: Path) -> None:
    for key in KEYS:
        steps = [
            row for one, row in steps_found("proved") if one == key and row["relation"] in ("equal", "root")
        ]
        rows = []
        for row in steps:
            asked = f"a;;{row['relation']};{row['letter']};{row['form']} + 1 / 1000"
            rows += [f"{row['place']}_0;;a;;;;{row['before']}", f"{row['place']};;{asked}"]
        folder = own(tmp_path / key, rows, letters_of(key)) if rows else ""
        found = records("collate", "author-eq", "--sources", folder)[1::2] if rows else []
        for row, other in zip(steps, found, strict=True):
            assert other["verdict"] == ("no_root" if row["relation"] == "root" else "wrong"), (key, row)


def test_pages_say_it_in_both_languages_and_fit_a_terminal() -> None:
    for words, sentences in (
        (("blau-equations",), ("v = 2 R π n/60 = S π n/30 falsch: 2 mal so groß",)),
        (
            ("weisbach-equations", "--lang=en"),
            (
                "an approximation only, order (r/l)²",
                "19 steps: 16 proved, 2 approximation, 1 an approximation only",
            ),
        ),
    ):
        page = printed("collate", *words).out
        assert max(map(len, page.splitlines())) <= 80
        assert all(one in " ".join(page.split()) for one in sentences)
    places = [one["printed"].removeprefix("'") for one in records("collate", "uebung-equations")]
    assert places == [row["printed"] for row in collated("uebung-equations")]
    strict = kurbel("collate", "blau-solutions", "--strict", "--only=deviations", "-f", "csv")
    assert strict.code == 1
    assert strict.out.splitlines()[1:] == [
        "blau-solutions,a_halved,cos^2 α + 5/4 cos α - 1/2 = 0,a_cosine,same,alpha,other_equation,"
    ]
    assert kurbel("collate", "roetscher-equations", "--strict").code == 0


# Steps ----------------------------------------------------------------------------------------------------

IDENTITIES = [
    ("(a + b)^2 - (a - b)^2", "4*a*b"),
    ("(a^3 - b^3) / (a - b)", "a^2 + a*b + b^2"),
    ("sin(a + b)", "sin(a)*cos(b) + cos(a)*sin(b)"),
    ("cos(2*a)", "1 - 2*sin(a)^2"),
    ("sin(a/2)^2", "(1 - cos(a)) / 2"),
    ("cos(a/4)^2", "(1 + cos(a/2)) / 2"),
    ("tan(a) * cot(a)", "1"),
    ("sin(a + pi)", "-sin(a)"),
    ("cos(a - pi/2)", "sin(a)"),
    ("sqrt(a^2*b + a^3)", "a * sqrt(b + a)"),
    ("sqrt(33/16)", "sqrt(33) / 4"),
    ("sqrt(8) * sqrt(2)", "4"),
    ("1 / (sqrt(a) - sqrt(b))", "(sqrt(a) + sqrt(b)) / (a - b)"),
    ("sin(2*arctan(a))", "2*a / (1 + a^2)"),
    ("cos(arcsin(a))", "sqrt(1 - a^2)"),
    ("ln((a^2 - b^2) / (a - b))", "ln(b + a)"),
    ("pm * a * pm", "a"),
    ("slope(sin(a + b)^2, a)", "sin(2 * (a + b))"),
    ("slope(a^2 * ln(a), a) - 2 * a * ln(a)", "a"),
    ("slope(cos(a) / a, a)", "-sin(a) / a - cos(a) / a^2"),
    ("slope(sqrt(a^2 + b), a)", "a / sqrt(b + a^2)"),
    ("slope(arcsin(a) + arctan(a), a)", "1 / sqrt(1 - a^2) + 1 / (1 + a^2)"),
    ("slope(tan(a) + cot(a), a)", "1 / cos(a)^2 - 1 / sin(a)^2"),
    ("slope(slope(a^3 * b, a), b)", "3 * a^2"),
    ("slope((-a)^2, a)", "2 * a"),
]
OTHERS = [
    # The root of a square may be of either sign.
    ("sqrt((a - b)^2)", "a - b", "wrong"),
    ("sqrt(cos(a + b)^2)", "cos(a + b)", "wrong"),
    ("sqrt(a^2 + b^2)", "a + b", "wrong"),
    ("slope(sin(a)^2, a)", "2 * sin(a)", "wrong"),
    ("a + pm * b", "a + b", "wrong"),
    ("sin(a)", "a", "wrong"),
    ("a", "a + 1 / 10^9 / 10^9 / 10^9", "wrong"),
    # True, and not within reach of quotients of polynomials.
    ("ln(a * b)", "ln(a) + ln(b)", "agrees"),
    ("sqrt(3 + 2 * sqrt(2))", "1 + sqrt(2)", "agrees"),
    # Without a value anywhere.
    ("sqrt(-a - 1)", "ln(-a)", "unsettled"),
    ("2 * a", "a", "factor"),
]
RELATIONS = [
    ("sin(a)", "a", "nearly", "a", "order", 2),
    ("sin(a)", "a - a^3 / 6", "nearly", "a", "order", 4),
    ("sin(a)", "2 * a", "nearly", "a", "far", 0),
    ("sqrt(1 + a)", "1 + a / 2", "equal", "a", "only_nearly", 2),
    ("sqrt(1 + a)", "2 + a", "equal", "a", "wrong", 0),
    ("(1 + a) * b", "b", "nearly", "a", "order", 1),
    ("1 / a", "1 / a", "nearly", "a", "proved", 0),
    # Series that begin with 1/a are not formed.
    ("1 / a", "1 / sin(a)", "nearly", "a", "unsettled", 0),
    ("a^2 - b", "3 * b - 3 * a^2", "same", "a", "proved", 0),
    ("a^2 - b", "a^2 - 2 * b", "same", "a", "other_equation", 0),
    ("a - b", "(a - b) / (1 + a)", "same", "a", "unsettled", 0),
    ("a - b", "a - a", "same", "a", "unsettled", 0),
    ("a - a", "a - b", "same", "a", "unsettled", 0),
    ("a^2 - 2 * b * a + c", "b + pm * sqrt(b^2 - c)", "root", "a", "proved", 0),
    ("a^2 - 2 * b * a + c", "b + pm * sqrt(b^2 + c)", "root", "a", "no_root", 0),
]


def test_identities_are_proved_and_what_is_not_is_refuted_or_left_open(tmp_path: Path) -> None:
    steps = [*((*one, "proved") for one in IDENTITIES), *OTHERS]
    for step, found in zip(steps, verdicts(tmp_path, (one[:2] for one in steps)), strict=True):
        assert found["verdict"] == step[2], step
    assert found["detail"] == "1/2"


def test_relations_are_told_apart(tmp_path: Path) -> None:
    for step, found in zip(RELATIONS, verdicts(tmp_path, (one[:4] for one in RELATIONS)), strict=True):
        assert found["verdict"] == step[4], step
        assert not step[5] or found["detail"] == str(step[5]), step


def test_a_refutation_has_a_point_at_which_both_sides_differ(tmp_path: Path) -> None:
    folder = own(tmp_path, ("one;;a;;;;sin(a)", "two;;a;;equal;;a * b"))
    page = " ".join(printed("collate", "author-eq", "--sources", folder, "--lang=en").out.split())
    said = re.search(r"wrong: at a = (\S+), b = (\S+) it is ([\d.]+), not ([\d.]+)", page)
    assert said
    a, b = (mp.mpf(Fraction(one).numerator) / Fraction(one).denominator for one in said.groups()[:2])
    for text, value in zip(said.groups()[2:], (a * b, mp.sin(a)), strict=True):
        assert abs(mp.mpf(text) - value) <= mp.mpf("0.5000001") * mp.mpf(10) ** -len(text.partition(".")[2])


LETTERS = st.sampled_from(["a", "b", "sin(a)", "cos(2*b)", "sqrt(a + b)", "pi", "ln(b)", "3/7"])
FORMS = st.recursive(
    LETTERS,
    lambda one: st.tuples(one, st.sampled_from("+-*/"), one).map(lambda part: f"({' '.join(part)})"),
    max_leaves=5,
)


@settings(max_examples=6, deadline=None)
@given(st.tuples(FORMS, FORMS, FORMS))
def test_products_of_sums_are_sums_of_products(forms: tuple[str, str, str]) -> None:
    one, two, three = forms
    before, after = f"{one} * ({two} + {three})", f"{one} * {two} + {three} * {one}"
    with TemporaryDirectory() as folder:
        true, false = verdicts(Path(folder) / "own", ((before, after), (before, f"{after} + 1/97")))
    assert true["verdict"] in ("proved", "unsettled")
    assert false["verdict"] in ("wrong", "factor", "unsettled") or true["verdict"] == "unsettled"


# Formulas of one's own ------------------------------------------------------------------------------------


def test_sides_that_differ_are_told_apart_at_a_glance(tmp_path: Path) -> None:
    for number, (before, form, verdict) in enumerate(
        (
            ("R", "R + 1/10^9/10^9/10^9", "their difference is 1.000 · 10⁻²⁷"),
            ("(7^8)^9", "(7^8)^9 + 10^9", "worked out both sides are about 7.032 · 10⁶⁰, their"),
            ("(7^8)^9", "(5^9)^9", "worked out it is 4.136 · 10⁵⁶, not 7.032 · 10⁶⁰"),
            ("4", "9001/3000", "it is 3.000, not 4.000"),
        )
    ):
        folder = own(tmp_path / str(number), (f"one;;R;;;;{before}", f"two;;= R;;equal;;{form}"))
        page = " ".join(printed("collate", "author-eq", "--sources", folder, "--lang=en").out.split())
        assert verdict in page
        assert "1 step: 1 wrong" in page


# Of letters by others, from sin(φ + R + L) on.
NESTED = {"a": "sin(phi+R+L)", "b": "(a+R+L)^9", "c": "(b+sin(a)+L)^9"}
TOWER = {"a0": "1.2^9"} | {f"a{n}": f"a{n - 1}^9" for n in range(1, 6)}
THREEFOLD = "slope(slope(slope({},phi),phi),phi)"
PRODUCT = THREEFOLD.format("(sin(phi+R)+L)^9*cos(phi+L)^9")
SUM = "+".join(f"x{n}" for n in range(60))
SOME_SECONDS = 2.0


@pytest.mark.parametrize(
    ("letters", "before", "form", "verdict"),
    [
        ({}, "((10^9)^9)^9", "((11^9)^9)^9", "wrong"),
        ({}, "((10^9)^9)^9", "2", "wrong"),
        ({}, "2", "((0.1^9)^9)^9", "wrong"),
        ({}, "(((10^9)^9)^9)^9", "2", "unsettled"),
        ({}, "2", "(((0.1^9)^9)^9)^9", "unsettled"),
        (TOWER, "a5", "2*a5", "unsettled"),
        (NESTED, THREEFOLD.format("c"), f"{THREEFOLD.format('c')}+1", "wrong"),
        ({}, PRODUCT, PRODUCT, "agrees"),
        ({}, f"({SUM})^9", f"({SUM})^9+1", "wrong"),
        ({f"a{n}": f"(a{n - 1}+R)^9+sin(a{n - 1})" for n in range(1, 20)},
         "slope(slope(slope(slope(a19,R),R),R),R)", "R", "unsettled"),
    ],
)  # fmt: skip
def test_no_formula_of_ones_own_is_computed_for_long(
    letters: Mapping[str, str], before: str, form: str, verdict: str, tmp_path: Path
) -> None:
    folder = own(tmp_path, (f"one;;a;;;;{before}", f"two;;b;;equal;;{form}"), letters)
    begun = process_time()
    found = records("collate", "author-eq", "--sources", folder, "--columns=verdict")
    assert process_time() - begun < SOME_SECONDS
    assert found[-1]["verdict"] == verdict


# In lines -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("formula", "lines"),
    [
        ("y = (a + b · c − d · e + f · g)/(h)", ["y = (a + b · c", "− d · e + f · g)/(h)"]),
        ("y = 1/(a + b · c − d · e + f · g)", ["y = 1/(a + b · c", "− d · e + f · g)"]),
        ("(a · b − c · d)/(a + b · c − d)", ["(a · b − c · d)", "/(a + b · c − d)"]),
        ("y = sqrt(a + b · c − d · e + f · g)", ["y = √(a + b · c", "− d · e + f · g)"]),
        ("a · b · sin(a) · −b · c · d", ["a · b · sin(a) · −b", "· c · d"]),
        ("a · b · c · d · R:L · e", ["a · b · c · d · R:L", "· e"]),
        ("p · (a + b) = q · (c − d) · (e − f)", ["p · (a + b)", "= q · (c − d)", "· (e − f)"]),
        # A power, an index and what has one are not broken.
        ("y = (a + b · c − d · e)^2", ["y", "= (a + b · c − d · e)²"]),
        ("y = x^(a + b · c − d · e) + f", ["y", "= x^(a + b · c − d · e)", "+ f"]),
        ("a b c d e f g h i k l m n o", ["a b c d e f g h i k l m n o"]),
    ],
)
def test_a_long_formula_is_broken_at_relations_sums_products_and_then_in_brackets(
    formula: str, lines: list[str]
) -> None:
    assert [plain(line) for line in formula_lines(formula, 20)] == lines


def test_the_lines_of_a_formula_are_the_formula() -> None:
    """Joined they read as the whole does but for parentheses about a fraction's parts; none is too long."""
    outer = str.maketrans("", "", "() ")
    broken = 0
    for key in KEYS:
        for row in collated(key):
            lines = [plain(line) for line in formula_lines(row["printed"])]
            assert "".join(lines).translate(outer) == plain(f"${row['printed']}$").translate(outer)
            broken += len(lines) > 1
    assert broken > 25


def test_a_finding_goes_on_below_a_formula_with_its_own_formulas_whole() -> None:
    said = "wrong: at $a = 1$, $b = 2$ it is $1.5$, not $2.5$"
    rows = rows_of(said, 16, lambda one: len(plain(one)))
    assert rows == ["wrong: at $a = 1$,", "$b = 2$ it is $1.5$,", "not $2.5$"]
    assert rows_of("proved", 3, len) == ["proved"]
    assert [room_beside(["x" * long]) for long in (1, 45, 60)] == [50, 23, 16]
