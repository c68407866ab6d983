"""Printed formulas: what is proved is so by mpmath, what is refuted differs, and nothing else is proved."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import cache
from pathlib import Path
from random import Random
from time import process_time
from typing import Any

import pytest
from cli import kurbel, printed
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp
from places import ROOT as HOME

from kurbel import collation_table
from kurbel.books.formulas.equation import (
    AGREES,
    EQUAL,
    FACTOR,
    FAR,
    HOLDS,
    NEARLY,
    NO_ROOT,
    ONLY_NEARLY,
    ORDER,
    OTHER,
    ROOT,
    SAME,
    UNSETTLED,
    WRONG,
    Finding,
    Step,
    found,
)
from kurbel.books.formulas.form import Form
from kurbel.books.formulas.lines import LONGEST, formula_lines, room_beside, word_lines
from kurbel.books.formulas.table import Collated, FormulaTable
from kurbel.books.source import all_tables
from kurbel.errors import NotationError
from kurbel.formats.render import render
from kurbel.page.labels import plain
from kurbel.page.table import DITTO

TABLES = {key: table for key, table in all_tables().items() if isinstance(table, FormulaTable)}
FUNCTIONS = {
    "sin": mp.sin, "cos": mp.cos, "tan": mp.tan, "cot": mp.cot, "sqrt": mp.sqrt, "ln": mp.log,
    "arcsin": mp.asin, "arctan": mp.atan, "pi": mp.pi, "mpf": mp.mpf,
}  # fmt: skip


@pytest.fixture(autouse=True)
def digits() -> Iterator[None]:
    with mp.workdps(40):
        yield


def by_mpmath(text: str, values: Mapping[str, Any], forms: Mapping[str, Form]) -> Any:
    """Return a form's value by Python's own evaluation, with letters made of others worked out first."""
    if slope := re.fullmatch(r"slope\((.*), (\w+)\)", text):
        with mp.workdps(60):
            return mp.diff(lambda at: by_mpmath(slope[1], {**values, slope[2]: at}, forms), values[slope[2]])

    class Letters(dict[str, Any]):
        def __missing__(self, name: str) -> Any:
            self[name] = by_mpmath(forms[name].text, values, forms)
            return self[name]

    exact = re.sub(r"(?<![\w.])\d+(\.\d+)?", lambda match: f"mpf('{match[0]}')", text).replace("^", "**")
    return eval(exact, {}, Letters({**FUNCTIONS, **values}))


def step_of(table: FormulaTable, one: Collated) -> Step:
    before = next(row for row in table.rows() if row.place == one.row.follows)
    return Step(before.form, one.row.form, one.row.relation, one.row.letter, table.forms)


def numbers(step: Step, seed: int) -> dict[str, Any]:
    """Return numbers for the letters, below 1, with a crank shorter than its rod."""
    chosen = Random(seed)
    return {name: mp.mpf(chosen.randint(200, 900)) / 1000 for name in sorted(step.letters())}


@cache
def collated(key: str) -> tuple[Collated, ...]:
    return tuple(TABLES[key].collated())


def steps_found(kind: str) -> list[tuple[str, Collated]]:
    return [(key, one) for key in TABLES for one in collated(key) if one.finding.kind == kind]


# The books ------------------------------------------------------------------------------------------------


def test_what_the_books_have_wrong_is_known() -> None:
    """v = 2Rπn/60 is not Sπn/30 with S = 2R; 5/4 in 33 a); 1 ± r/l sin² α/2 of § 150 is of first order."""
    wrong: dict[tuple[str, str], tuple[str, Fraction | int, int]] = {
        (key, one.row.place): (one.finding.kind, one.finding.factor, one.finding.order)
        for key in TABLES
        for one in collated(key)
        if one.row.relation and one.finding.kind not in (HOLDS, ORDER)
    }
    assert wrong == {
        ("blau-equations", "v_stroke"): (FACTOR, 2, 0),
        ("blau-solutions", "a_halved"): (OTHER, 1, 0),
        ("weisbach-equations", "greatest_near"): (ONLY_NEARLY, 1, 2),
    }
    assert (len(steps_found(HOLDS)), len(steps_found(ORDER))) == (72, 8)


def test_velocity_and_acceleration_of_blau_are_the_slopes_of_his_path() -> None:
    forms = TABLES["blau-equations"].forms
    acceleration = "v^2 / R * (cos(alpha) + pm * R / L * cos(2 * alpha))"
    for slope, printed_one in (("omega * slope(x, alpha)", "c"), ("omega * slope(c, alpha)", acceleration)):
        assert found(Step(Form(slope), Form(printed_one), EQUAL, "", forms)).kind == HOLDS


def test_the_page_on_the_books_counts_the_steps() -> None:
    text = " ".join((HOME / "docs" / "books" / "index.md").read_text(encoding="utf-8").split())
    proved, nearly = len(steps_found(HOLDS)), len(steps_found(ORDER))
    steps = sum(1 for key in TABLES for one in collated(key) if one.row.relation)
    assert f"Of {steps} steps in" in text
    assert f"{proved} are proved and {nearly} are the approximations" in text
    assert steps - proved - nearly == 3 and "Three are wrong" in text


def test_what_is_proved_of_the_books_is_so_by_mpmath() -> None:
    count = 0
    for key, one in steps_found(HOLDS):
        step = step_of(TABLES[key], one)
        for sign in (1, -1):
            values = numbers(step, count) | {"pm": sign}
            forms = dict(step.forms)
            if one.row.relation == ROOT:
                values.pop(step.letter, None)
                forms[step.letter] = step.form
                assert abs(by_mpmath(step.before.text, values, forms)) < mp.mpf(10) ** -35
            else:
                sides = [by_mpmath(form.text, values, forms) for form in (step.before, step.form)]
                if one.row.relation == SAME:
                    values[step.letter] += mp.mpf("0.05")
                    others = [by_mpmath(form.text, values, forms) for form in (step.before, step.form)]
                    sides = [sides[0] * others[1], sides[1] * others[0]]
                assert mp.almosteq(*sides, rel_eps=mp.mpf(10) ** -30), (key, one.row.place)
            count += 1
    assert count > 100


def test_the_order_of_an_approximation_is_that_of_its_difference_by_mpmath() -> None:
    for key, one in [*steps_found(ORDER), *steps_found(ONLY_NEARLY)]:
        step = step_of(TABLES[key], one)
        values = numbers(step, 1) | {"pm": 1}
        apart = []
        for small in (mp.mpf("1e-5"), mp.mpf("1e-6")):
            values[step.letter] = small
            left, right = (by_mpmath(form.text, values, step.forms) for form in (step.before, step.form))
            apart.append(abs((left - right) / left))
        assert abs(mp.log10(apart[0] / apart[1]) - one.finding.order) < mp.mpf("0.01"), (key, one.row.place)


def test_no_other_formula_is_proved_in_place_of_a_proved_one() -> None:
    for key, one in steps_found(HOLDS):
        step = step_of(TABLES[key], one)
        if one.row.relation == EQUAL:
            other = step._replace(form=Form(f"{step.form.text} + 1 / 1000"), letter="")
            assert found(other).kind == WRONG, (key, one.row.place)
        if one.row.relation == ROOT:
            other = step._replace(form=Form(f"{step.form.text} + 1 / 1000"))
            assert found(other).kind == NO_ROOT, (key, one.row.place)


def test_pages_say_it_in_both_languages() -> None:
    german = " ".join(printed("collate", "blau-equations").out.split())
    assert "v = 2 R π n/60 = S π n/30 falsch: 2 mal so groß" in german
    english = " ".join(printed("collate", "weisbach-equations", "--lang=en").out.split())
    assert "an approximation only, order (r/l)²" in english
    assert "19 steps: 16 proved, 2 approximation, 1 an approximation only" in english
    strict = kurbel("collate", "blau-solutions", "--strict", "--only=deviations", "-f", "csv")
    assert strict.code == 1
    assert strict.out.splitlines()[1:] == [
        "blau-solutions,a_halved,cos^2 α + 5/4 cos α - 1/2 = 0,a_cosine,same,alpha,other_equation,"
    ]
    assert kurbel("collate", "roetscher-equations", "--strict").code == 0


# Steps ----------------------------------------------------------------------------------------------------


def of(before: str, form: str, relation: str = EQUAL, letter: str = "", **forms: str) -> Finding:
    return found(Step(Form(before), Form(form), relation, letter, {k: Form(v) for k, v in forms.items()}))


@pytest.mark.parametrize(
    ("before", "form"),
    [
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
    ],
)
def test_identities_are_proved(before: str, form: str) -> None:
    assert of(before, form).kind == HOLDS


@pytest.mark.parametrize(
    ("before", "form", "kind"),
    [
        # The root of a square may be of either sign.
        ("sqrt((a - b)^2)", "a - b", WRONG),
        ("sqrt(cos(a + b)^2)", "cos(a + b)", WRONG),
        ("sqrt(a^2 + b^2)", "a + b", WRONG),
        ("slope(sin(a)^2, a)", "2 * sin(a)", WRONG),
        ("a + pm * b", "a + b", FACTOR),
        ("sin(a)", "a", WRONG),
        ("a", "a + 1 / 10^9 / 10^9 / 10^9", WRONG),
        # True, and not within reach of quotients of polynomials.
        ("ln(a * b)", "ln(a) + ln(b)", AGREES),
        ("sqrt(3 + 2 * sqrt(2))", "1 + sqrt(2)", AGREES),
        # Without a value anywhere.
        ("sqrt(-a - 1)", "ln(-a)", UNSETTLED),
    ],
)
def test_what_is_not_proved_is_refuted_or_left_open(before: str, form: str, kind: str) -> None:
    assert of("2 * a", "a").factor == Fraction(1, 2)
    if kind == FACTOR:
        assert of(before, form).kind == WRONG
    else:
        assert of(before, form).kind == kind


def test_a_refutation_has_a_point_at_which_both_sides_differ() -> None:
    finding = of("sin(a)", "a * b")
    a, b = (mp.mpf(finding.point[name].numerator) / finding.point[name].denominator for name in "ab")
    left, right = (mp.mpf(side.mid().str(30, radius=False)) for side in finding.sides)
    assert mp.almosteq(left, mp.sin(a), 1e-20) and mp.almosteq(right, a * b, 1e-20)


@pytest.mark.parametrize(
    ("before", "form", "relation", "letter", "kind", "order"),
    [
        ("sin(a)", "a", NEARLY, "a", ORDER, 2),
        ("sin(a)", "a - a^3 / 6", NEARLY, "a", ORDER, 4),
        ("sin(a)", "2 * a", NEARLY, "a", FAR, 0),
        ("sqrt(1 + a)", "1 + a / 2", EQUAL, "a", ONLY_NEARLY, 2),
        ("sqrt(1 + a)", "2 + a", EQUAL, "a", WRONG, 0),
        ("(1 + a) * b", "b", NEARLY, "a", ORDER, 1),
        ("1 / a", "1 / a", NEARLY, "a", HOLDS, 0),
        # Series that begin with 1/a are not formed.
        ("1 / a", "1 / sin(a)", NEARLY, "a", UNSETTLED, 0),
        ("a^2 - b", "3 * b - 3 * a^2", SAME, "a", HOLDS, 0),
        ("a^2 - b", "a^2 - 2 * b", SAME, "a", OTHER, 0),
        ("a - b", "(a - b) / (1 + a)", SAME, "a", UNSETTLED, 0),
        ("a - b", "a - a", SAME, "a", UNSETTLED, 0),
        ("a^2 - 2 * b * a + c", "b + pm * sqrt(b^2 - c)", ROOT, "a", HOLDS, 0),
        ("a^2 - 2 * b * a + c", "b + pm * sqrt(b^2 + c)", ROOT, "a", NO_ROOT, 0),
    ],
)
def test_relations_are_told_apart(
    before: str, form: str, relation: str, letter: str, kind: str, order: int
) -> None:
    finding = of(before, form, relation, letter)
    assert (finding.kind, finding.order) == (kind, order)


LETTERS = st.sampled_from(["a", "b", "sin(a)", "cos(2*b)", "sqrt(a + b)", "pi", "ln(b)", "3/7"])
FORMS = st.recursive(
    LETTERS,
    lambda one: st.tuples(one, st.sampled_from("+-*/"), one).map(lambda part: f"({' '.join(part)})"),
    max_leaves=5,
)


@settings(max_examples=60, deadline=None)
@given(FORMS, FORMS, FORMS)
def test_products_of_sums_are_sums_of_products(one: str, two: str, three: str) -> None:
    before = f"{one} * ({two} + {three})"
    kind = of(before, f"{one} * {two} + {three} * {one}").kind
    assert kind in (HOLDS, UNSETTLED)
    if kind == HOLDS:
        assert of(before, f"{one} * {two} + {three} * {one} + 1/97").kind in (WRONG, FACTOR, UNSETTLED)


@pytest.mark.parametrize(
    "text", ["", "a b", "x.y", "sin", "sin(a, b)", "sinh(a)", "a^b", "a^10", "2^(1/2)", "'a'", "a[0]", "f(a)",
             "a if b else c", "a == b", "slope(a)", "slope(a, 2)", "slope(a, pi)", "slope"],
)  # fmt: skip
def test_what_is_no_form_is_refused(text: str) -> None:
    with pytest.raises(NotationError):
        Form(text)


# Formulas of one's own ------------------------------------------------------------------------------------

BOOK = """
citation = "A. Author, A Book"
[formulas.eq]
title.de = "Gleichungen"
title.en = "Equations"
letters = { S = "2 * R" }
"""
HEADS = "place;label;printed;follows;relation;letter;form\n"
ROWS = f"{HEADS}v;(1);v = 2 π R n;;;;2*pi*R*n\nv_stroke;;= π S n;;equal;;pi*S*n\n"


def own(folder: Path, book: str = BOOK, rows: str = ROWS) -> str:
    (folder / "author").mkdir()
    (folder / "author" / "source.toml").write_text(book, encoding="utf-8")
    (folder / "author" / "eq.csv").write_text(rows, encoding="utf-8")
    return str(folder)


def test_formulas_of_ones_own_are_a_section_and_a_file(tmp_path: Path) -> None:
    folder = own(tmp_path)
    assert "author-eq  Gleichungen" in printed("sources", "--sources", folder).out
    words = ("collate", "author-eq", "--sources", folder, "-f", "csv", "--columns", "place,relation,verdict")
    assert [tuple(one.values()) for one in printed(*words).records()] == [
        ("v", "", ""),
        ("v_stroke", "equal", "proved"),
    ]


@pytest.mark.parametrize(
    ("book", "rows", "sentence"),
    [
        (BOOK, "", "is empty; it starts with its heads, place;label;printed"),
        (BOOK, HEADS, "has no printed formula below its heads"),
        (BOOK, ROWS.replace(";form", ";from"), 'line 1: there is no column "from" (did you mean form?)'),
        (BOOK, ROWS.replace("label;", "place;"), "line 1: a column stands there twice"),
        (BOOK, ROWS.replace("pi*S*n", "pi*S*"), 'line 3: "pi*S*" is no expression'),
        (BOOK, ROWS.replace("pi*S*n", "sinh(S)"), 'line 3: "sinh(S)" has what no form may; it has numbers'),
        (BOOK, ROWS.replace("pi*S*n", "(1+S)^9999"), '"(1+S)^9999" has the power 9999; powers are whole'),
        (BOOK, ROWS.replace("pi*S*n", "((S+n)^20+n)^20"), "has the power 20; powers are whole numbers from"),
        (BOOK, ROWS.replace("equal", "equals"), 'there is no relation "equals" (did you mean equal?)'),
        (BOOK, ROWS.replace("equal", "nearly"), "line 3: the relation nearly of v_stroke needs a letter"),
        (BOOK, ROWS.replace(";;equal", ";w;equal"), "line 3: w is no formula above v_stroke"),
        (BOOK, ROWS.replace("v_stroke;", "v;"), "line 3: the place v is given twice"),
        (BOOK, ROWS.replace("v_stroke;", "v stroke;"), 'line 3: the place "v stroke" is no name'),
        (BOOK, ROWS.replace(";;;;2*", ";;equal;;2*"), "line 2: v follows from none; leave its relation out"),
        (BOOK, ROWS.replace("= π S n", "= π (S"), "cannot be set"),
        (BOOK, ROWS.replace("= π S n", ""), "line 3: v_stroke has no printed formula"),
        (BOOK.replace('"2 * R"', '"2 *"'), ROWS, 'line 6: "2 *" is no expression'),
        (BOOK.replace('"2 * R"', '"slope(R^2, R)"'), ROWS, "line 6: S has a slope; write it in the formula"),
        (BOOK, ROWS.replace("pi*S*n", "slope(" * 5 + "S" + ", S)" * 5), "has more than 4 slopes"),
        (BOOK.replace('"2 * R"', '"2 * S"'), ROWS, "line 6: S is made of itself, by way of other letters"),
        (
            BOOK.replace('S = "2 * R"', ", ".join(f'a{n} = "a{n - 1}"' for n in range(1, 99))),
            ROWS,
            "line 6: more than 20 letters are made of one another",
        ),
        (BOOK.replace("letters", "leters"), ROWS, 'there is no key of formulas "leters" (did'),
        (BOOK.replace("formulas.eq", 'formulas."../eq"'), ROWS, 'the table "../eq" cannot be a file'),
        (BOOK + "[tables.eq]\n", ROWS, 'there is a table "eq" of values; give one another name'),
    ],
)  # fmt: skip
def test_formulas_that_cannot_be_used_are_answered_with_a_sentence(
    book: str, rows: str, sentence: str, tmp_path: Path
) -> None:
    result = kurbel("collate", "author-eq", "--sources", own(tmp_path, book, rows))
    assert result.code in (1, 2)
    assert sentence in result.err
    assert "Traceback" not in result.err


@pytest.mark.parametrize(
    ("rows", "verdict"),
    [
        ("R;;R = R;;;;R\nw;;= R;;equal;;R + 1/10^9/10^9/10^9\n", "their difference is 1.000 · 10⁻²⁷"),
        (
            "R;;R = 7;;;;(7^8)^9\nw;;= 7;;equal;;(7^8)^9 + 10^9\n",
            "worked out both sides are about 7.032 · 10⁶⁰, their",
        ),
        ("R;;R = 7;;;;(7^8)^9\nw;;= 7;;equal;;(5^9)^9\n", "worked out it is 4.136 · 10⁵⁶, not 7.032 · 10⁶⁰"),
        ("R;;R = R;;;;4\nw;;= R;;equal;;9001/3000\n", "it is 3.000, not 4.000"),
    ],
)
def test_sides_that_differ_are_told_apart_at_a_glance(rows: str, verdict: str, tmp_path: Path) -> None:
    page = " ".join(
        printed(
            "collate", "author-eq", "--sources", own(tmp_path, rows=HEADS + rows), "--lang=en"
        ).out.split()
    )
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
    made = ", ".join(f'{name} = "{text}"' for name, text in letters.items())
    rows = f"{HEADS}one;(1);a;;;;{before}\ntwo;;b;;equal;;{form}\n"
    folder = own(tmp_path, BOOK.replace('S = "2 * R"', made), rows)
    begun = process_time()
    found = printed("collate", "author-eq", "--sources", folder, "-f", "csv", "--columns", "verdict")
    assert process_time() - begun < SOME_SECONDS
    assert [*found.records()][-1]["verdict"] == verdict
    if verdict == "wrong":
        assert "wrong: " in printed("collate", "author-eq", "--sources", folder, "--lang", "en").out


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
    for key in TABLES:
        for one in collated(key):
            lines = [plain(line) for line in formula_lines(one.row.printed)]
            whole = plain(f"${one.row.printed}$")
            assert "".join(lines).translate(outer) == whole.translate(outer)
            assert max(map(len, lines)) <= LONGEST
            broken += len(lines) > 1
    assert broken > 25


def test_a_finding_goes_on_below_a_formula_with_its_own_formulas_whole() -> None:
    said = "wrong: at $a = 1$, $b = 2$ it is $1.5$, not $2.5$"
    assert word_lines(said, 16) == ("wrong: at $a = 1$,", "$b = 2$ it is $1.5$,", "not $2.5$")
    assert word_lines("proved", 3) == ("proved",)
    assert [room_beside(["x" * long]) for long in (1, 45, 60)] == [50, 23, 16]


@pytest.mark.parametrize("lang", ["de", "en"])
@pytest.mark.parametrize("key", TABLES)
def test_pages_of_formulas_fit_and_records_have_each_formula_whole(key: str, lang: str) -> None:
    page = collation_table(key, lang=lang)
    assert max(map(len, render(page, "text").splitlines())) <= 80
    assert [record[2] for record in page.records.rows] == [one.row.printed for one in collated(key)]
    places = [row.stub[0].value for row in page.panels[0].rows()]
    assert len([place for place in places if place is not DITTO]) == len(collated(key)) <= len(places)
