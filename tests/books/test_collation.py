"""Printed tables and their verdicts: against values worked out elsewhere, and evidence for each verdict."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from fractions import Fraction
from functools import cache
from pathlib import Path
from time import process_time
from typing import Any

import pytest
from cli import kurbel, printed, records, refusal
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp
from places import ROOT, SOURCES
from registers import BOOKS, rows_of

import kurbel as library
from kurbel.books.book_values import Expression
from kurbel.books.printed_value import printed_value

TABLES = (*(f"blau-3{number}" for number in range(1, 6)), "roetscher-112", "weisbach-149", "weisbach-150")
VALUES = "place;formula;printed\n"


@cache
def collated(key: str) -> list[dict[str, str]]:
    return records("collate", key)


def own(folder: Path, values: str) -> str:
    """Write a book of one table, author-1, and return its folder."""
    (folder / "author").mkdir(parents=True)
    (folder / "author" / "source.toml").write_text('citation = "Author"\n[tables.1]\n', encoding="utf-8")
    (folder / "author" / "1.csv").write_text(values, encoding="utf-8")
    return str(folder)


def verdicts(folder: Path, rows: Iterable[str], heads: str = VALUES) -> list[dict[str, str]]:
    """Return what the cells of a book of one's own are found to be."""
    values = heads + "".join(f"{row}\n" for row in rows)
    return records("collate", "author-1", "--sources", own(folder, values))


# Printed values and expressions -----------------------------------------------------------------------------


@given(st.integers(-(10**9), 10**9), st.integers(0, 8), st.sampled_from(",."))
def test_decimals_stand_for_themselves(scaled: int, decimals: int, mark: str) -> None:
    digits = str(abs(scaled)).rjust(decimals + 1, "0")
    text = f"{digits[:-decimals]}{mark}{digits[-decimals:]}" if decimals else digits
    found = printed_value(("-" if scaled < 0 else "") + text)
    assert (found.scaled, found.decimals) == (scaled, decimals)
    assert found.standing_for(scaled) == ("-" if scaled < 0 else "") + text


@given(st.integers(0, 400), st.integers(0, 59), st.booleans())
def test_angles_stand_for_themselves(degrees: int, minutes: int, half: bool) -> None:
    text = f"{degrees}°{minutes}{'½' if half else ''}'"
    found = printed_value(text)
    assert found.value == degrees + Fraction(2 * minutes + half, 120)
    assert found.standing_for(found.scaled) == text


@settings(max_examples=50)
@given(st.text(max_size=12))
def test_what_is_no_printed_value_is_told(text: str) -> None:
    try:
        found = printed_value(text)
    except library.KurbelError as error:
        assert "is no printed value" in str(error)
    else:
        assert re.fullmatch(r"\s*[-−]?\d.*", text, re.DOTALL)
        assert isinstance(found.value, Fraction)


def by_python(text: str, names: dict[str, Any]) -> Any:
    """The same in mpmath, by Python's own evaluation."""
    functions = {
        "sin": lambda degrees: mp.sin(mp.radians(degrees)),
        "cos": lambda degrees: mp.cos(mp.radians(degrees)),
        "sqrt": mp.sqrt, "ln": mp.log, "arccos": lambda value: mp.degrees(mp.acos(value)),
    }  # fmt: skip
    numbers = re.sub(r"(?<!\w)\d+(\.\d+)?", lambda match: f"mpf('{match[0]}')", text).replace("^", "**")
    return eval(numbers, {"mpf": mp.mpf, **functions}, names)


def test_expressions_have_the_value_of_their_formula(tmp_path: Path) -> None:
    texts = (
        "1 - cos(45) + 0.1 * sin(45)^2", "(sqrt(41) - 5) / 4", "arccos(0.186) - 79", "ln(2) / 3 - -2",
        "2 * (1 + ln(4)) / 4^2", "cos(22.5)*sin(-30)",
    )  # fmt: skip
    found = verdicts(tmp_path, (f"a{number};{text};0,000000000000" for number, text in enumerate(texts)))
    with mp.workdps(30):
        for row, text in zip(found, texts, strict=True):
            value = mp.mpf(row["recomputed"].replace(",", "."))
            assert abs(value - by_python(text, {})) <= mp.mpf("0.5e-12"), text


@settings(max_examples=200)
@given(st.text(alphabet="0123456789.+-*/^() abcosqrtln_", max_size=30))
def test_no_text_does_anything_else(text: str) -> None:
    try:
        Expression(text)
    except library.KurbelError as error:
        assert str(error)


# Verdicts -------------------------------------------------------------------------------------------------

# Formula, way, what is printed, and what that is found to be.
FOUND = [
    ("0.355", "", "0,355", "0,355", "right", ""),
    ("0.355", "", "0,356", "0,355", "last_place", ""),
    ("0.355", "mid_6 / 2", "0,356", "0,355", "last_place", "follows"),
    ("0.355", "slip - 0.194", "0,356", "0,355", "last_place", ""),
    ("0.355", "mid_7 / 2", "0,357", "0,355", "rounded_on_the_way", ""),
    ("0.355", "mid_8 / 2", "0,357", "0,355", "digit", "7:5"),
    ("79 + 16 / 60", "", "79°20'", "79°16′", "coarser_place", "0°10′"),
    ("79 + 14 / 60", "", "79°20'", "79°14′", "unexplained", ""),
    ("0.364", "", "0,360", "0,364", "digit", "0:4"),
    ("0.355", "", "-0,355", "0,355", "sign", ""),
    ("-0.014", "", "0,014", "-0,014", "sign", ""),
    ("0.991", "", "0,981", "0,991", "digit", "8:9"),
    ("32 + 5.5 / 60", "", "32°51½'", "32°5½'", "digit", "1+"),
    ("0.55", "", "0,47", "0,55", "unexplained", ""),
    ("1.2435", "", "1,2345", "1,2435", "exchanged", ""),
    ("12 + 50 / 60", "", "21°50'", "12°50′", "exchanged", ""),
    ("slip - 0.2175", "slip - 0.2621", "0,2879", "0,2825", "carried_over", "slip"),
    ("0.2825", "", "0,2879", "0,2825", "unexplained", ""),
    # Digits that another stands between are not exchanged.
    ("0.513", "", "0,315", "0,513", "unexplained", ""),
    # A quotient is right only as the value itself.
    ("1 / 72", "", "1/72", "1/72", "right", ""),
    ("1 / 71", "", "1/72", "1/71", "digit", "2:1"),
    ("1 / 3", "", "1/4", "1/3", "digit", "4:3"),
    ("5", "", "1/72", "5", "unexplained", ""),
    ("1 / 3", "", "-1/3", "1/3", "sign", ""),
    ("12 / 31", "", "12/13", "12/31", "exchanged", ""),
    ("sqrt(2)", "", "7/5", "1,414214", "unexplained", ""),
    ("sqrt(2)^2 / 4", "", "1/2", "1/2", "right", ""),
    ("-cos(60)", "", "1/2", "-0,500000", "sign", ""),
    ("0.12345678901234567890", "", "0,12345678901234567890", "0,12345678901234567890", "right", ""),
]


def test_the_first_verdict_that_the_evidence_bears_out_is_given(tmp_path: Path) -> None:
    rows = [f"a{number};{formula};{way};{text}" for number, (formula, way, text, *_) in enumerate(FOUND)]
    heads = "place;formula;way;printed\n"
    before = ["slip;0.5;;0,55", "mid_6;0.7122;;0,712", "mid_7;0.7139;;0,714", "mid_8;0.7161;;0,716"]
    slip, *right = (found := verdicts(tmp_path, [*before, *rows], heads))[:4]
    assert (slip["verdict"], {one["verdict"] for one in right}) == ("digit", {"right"})
    keys = ("recomputed", "verdict", "detail")
    for row, (*_, recomputed, kind, detail) in zip(found[4:], FOUND, strict=True):
        assert tuple(row[key] for key in keys) == (recomputed, kind, detail), row
        assert (row["difference"] == "0") == (kind == "right")


# The books ------------------------------------------------------------------------------------------------


def test_formulas_of_cells_have_the_value_that_mpmath_gives() -> None:
    count = 0
    for key in ("blau-31", "blau-32", "blau-33", "blau-34", "blau-35", "weisbach-149"):
        book, name = key.split("-")
        values: dict[str, Any] = {}
        found = {row["place"]: row["recomputed"] for row in collated(key)}
        for cell in rows_of(BOOKS / book / f"{name}.csv"):
            if not cell["formula"]:
                continue
            with mp.workdps(30):
                values[cell["place"]] = value = by_python(cell["formula"], values)
                scaled = printed_value(found[cell["place"]])
                unit = Fraction(scaled.unit)
                off = abs(value - mp.mpf(scaled.value.numerator) / scaled.value.denominator)
                assert off <= mp.mpf("1e-20") + (
                    0 if scaled.exact else mp.mpf(unit.numerator) / unit.denominator / 2
                )
            count += 1
    assert count == 56


def test_the_page_on_the_books_counts_the_verdicts() -> None:
    text = (ROOT / "docs" / "books" / "index.md").read_text(encoding="utf-8")
    counted = [row["verdict"] for key in TABLES for row in collated(key) if row["verdict"]]
    told = {
        name.strip(): int(count)
        for name, count in re.findall(r"^\| ([a-z ]+) \| (\d+) \|", text, re.MULTILINE)
    }
    names = {
        "coarser_place": "right to a coarser place",
        "digit": "one digit",
        "exchanged": "two digits exchanged",
        "carried_over": "slip carried over",
    }
    for kind in {*counted}:
        assert told[names.get(kind, kind.replace("_", " "))] == counted.count(kind)
    assert f"{len(counted)} printed values" in text


def test_deviating_cells_bear_marks_that_the_apparatus_explains() -> None:
    table = library.collate("roetscher-112")
    cells = [cell for panel in table.panels for row in panel.rows() for cell in row.cells]
    marks = [mark for cell in cells for mark in cell.notes]
    assert marks == [chr(ord("a") + number) for number in range(14)]
    explained = {note.mark: note.text for note in table.notes if note.mark}
    assert list(explained) == marks
    assert "1:4$, $30°$: $0.981$] $0.991$, $-10$, eine Ziffer: 8 für 9" in explained["m"]


def test_only_deviations_leaves_what_is_right_and_strict_fails_where_something_deviates(
    tmp_path: Path,
) -> None:
    deviating = [row for row in collated("roetscher-112") if row["verdict"] != "right"]
    assert records("collate", "roetscher-112", "--only=deviations") == deviating
    assert (len(deviating), len(collated("roetscher-112"))) == (14, 54)
    assert kurbel("collate", "weisbach-149", "--strict").code == 0
    result = kurbel("collate", "blau-32", "--strict")
    failure = "kurbel: printed values deviate (1), and --strict fails then\n"
    assert (result.code, result.err) == (1, failure)
    assert "0,356" in result.out
    for name in ("apparat.csv", "apparat.svg"):
        whole = tmp_path / name
        result = kurbel("collate", "blau-32", "--strict", "-o", str(whole))
        assert (result.code, result.err) == (1, failure)
        assert "0,356" in whole.read_text(encoding="utf-8") or name.endswith(".svg")


def test_how_blau_came_to_a_last_place_is_said() -> None:
    """0,911/2 and 0,895/2 are ties; α to ten minutes; sin 69°30' is 0,93667; 1,757/2 is no 0,878."""
    known = {
        ("blau-33", "stroke_a"): ("last_place", "follows"),
        ("blau-33", "stroke_b"): ("last_place", "follows"),
        ("blau-33", "alpha_a"): ("coarser_place", "0°10′"),
        ("blau-34", "alpha"): ("coarser_place", "0°10′"),
        ("blau-34", "sin_alpha"): ("last_place", "follows"),
        ("blau-31", "stroke_135"): ("last_place", ""),
    }
    for (key, place), verdict in known.items():
        (row,) = (one for one in collated(key) if one["place"] == place)
        assert (row["verdict"], row["detail"]) == verdict
    assert Fraction("0.911") / 2 == Fraction("0.4555") and Fraction("0.895") / 2 == Fraction("0.4475")
    for cosine, tens in (((mp.sqrt(33) - 5) / 4, 79 * 6 + 2), ((mp.sqrt(41) - 5) / 4, 69 * 6 + 3)):
        assert mp.nint(mp.degrees(mp.acos(cosine)) * 6) == tens
    assert mp.nstr(mp.sin(mp.radians(69.5)), 3) == "0.937"
    assert mp.nstr(mp.sqrt(1 - ((mp.sqrt(41) - 5) / 4) ** 2), 3) == "0.936"


def test_weisbach_is_not_called_right_about_his_second_angle_without_the_true_one() -> None:
    true = {row["cell"]: row for row in rows_of(SOURCES / "weisbach" / "150.csv")}
    for lang in ("de", "en"):
        said = " ".join(printed("collate", "weisbach-150", f"--lang={lang}").out.split())
        for method in ("series", "exact"):
            for cell in ("alpha_max", "alpha_max_return"):
                assert true[cell][method].replace("'", "′") in said


# One's own ------------------------------------------------------------------------------------------------


def written(folder: Path, text: str | bytes) -> str:
    path = folder / "scan.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return str(path)


@pytest.mark.parametrize(
    ("text", "options"),
    [
        ("phi;1:4;1:5\n30;0,981;0,966\n80;-0,034;\n", ("--quantity=p",)),
        ("phi,printed\n30,0.981\n80,-0.034\n", ("--quantity=p", "--ratio=1:4")),
        ("# a comment\nφ\tp\n30\t0,981\n80\t−0,034\n", ("--ratio=0.25",)),
        ("\ufeffphi;p\r\n30;0,981\r\n\r\n80;-0,034\r\n", ("--ratio=1:4",)),
    ],
)
def test_a_transcription_is_read_however_it_is_written(
    text: str, options: tuple[str, ...], tmp_path: Path
) -> None:
    words = ("collate", "--csv", written(tmp_path, text), *options, "--method=series", "-f", "csv")
    found = {
        (one["ratio"], one["phi"]): (one["recomputed"].replace(",", "."), one["verdict"])
        for one in printed(*words).records()
    }
    assert found["1:4", "30"] == ("0.991", "digit")
    assert found["1:4", "80"] == ("-0.061", "unexplained")
    assert found.get(("1:5", "30"), ("0.966", "right")) == ("0.966", "right")


def test_another_formula_is_found(tmp_path: Path) -> None:
    # x of an infinite rod and by the first order at 50°, where the exact path is asked for.
    text = f"phi;x\n50;{1 - math.cos(math.radians(50)):.4f}\n130;1.7015\n"
    words = ("collate", "--csv", written(tmp_path, text), "--ratio=1:5", "-f", "csv")
    infinite, series = printed(*words).records()
    assert (infinite["verdict"], infinite["detail"]) == ("other_formula", "infinite")
    assert (series["verdict"], series["detail"]) == ("other_formula", "series")
    # p at 45° is 0.7071 by both, and 0.7092 exactly: the nearer formula is named.
    words = ("collate", "--csv", written(tmp_path, "phi;p\n45;0.7071\n"), "--ratio=1:5", "-f", "csv")
    (both,) = printed(*words).records()
    assert (both["recomputed"], both["verdict"]) == ("0.7092", "other_formula")
    assert both["detail"] == "series"


def test_a_long_transcription_has_the_verdicts_of_a_short_one(tmp_path: Path) -> None:
    lines = [f"{step / 100:.2f};{1 - math.cos(math.radians(step / 100)):.5f}" for step in range(0, 9001)]
    lines[777] = "7.77;0.00919"
    long = printed("collate", "--csv", written(tmp_path, "phi;x\n" + "\n".join(lines)), "--ratio=1:∞",
                   "--only=deviations", "-f", "csv").records()  # fmt: skip
    assert [one["phi"] for one in long] == ["7.77"]
    few = written(tmp_path, f"phi;x\n{lines[777]}\n")
    (short,) = records("collate", "--csv", few, "--ratio=1:∞")
    assert short["verdict"] == long[0]["verdict"]


SOME_SECONDS = 2.0
POWERS = "".join(f"a{n};a{n - 1}^9;1\n" for n in range(1, 9))
TOO_LARGE = "a number of more than 3000 figures would come out"


LONG = "".join(f"a{n};a{n - 1};1\n" for n in range(1, 200))


@pytest.mark.parametrize(
    ("rows", "sentence"),
    [
        ("a;((((1.1^9)^9)^9)^9)^9;1,1\n", f"line 2: a: {TOO_LARGE}"),
        (f"a0;1.2;1,2\n{POWERS}", f"line 6: a4: {TOO_LARGE}"),
        (f"a0;sqrt(2);1,4\n{POWERS}", "line 7: a5: a value has more than 3000 figures"),
        (f"a0;1;1\n{LONG}", "more than 50 cells build on one another"),
        (f"a;1;0,{'0' * 5000}\n", "a printed value of 5002 characters is too long"),
        (f"a;{'(' * 400};1\n", "has more than 100 brackets within each other"),
        # A sum of fractions grows as a product does.
        ("a0;1/3+1;1\n" + "".join(f"a{n};1/a{n - 1}+a{n - 1};1\n" for n in range(1, 40)), TOO_LARGE),
    ],
    ids=["nested", "by-reference", "irrational", "deep", "long", "brackets", "sums"],
)
def test_a_formula_that_outgrows_all_ends_with_a_sentence(rows: str, sentence: str, tmp_path: Path) -> None:
    folder = own(tmp_path, f"{VALUES}{rows}")
    before = process_time()
    result = kurbel("collate", "author-1", "--sources", folder)
    assert process_time() - before < SOME_SECONDS
    assert (result.code, sentence in result.err, "Traceback" in result.err) == (1, True, False)


def test_cells_that_name_others_often_are_computed_once_and_headed_by_their_places(tmp_path: Path) -> None:
    rows = [
        "a0;sqrt(1);1",
        *(f"a{n};(a{n - 1} + a{n - 1}) / 2;1" for n in range(1, 50)),
        "root_2;sqrt(2);1,4",
    ]
    assert [row["verdict"] for row in verdicts(tmp_path, rows)] == ["right"] * 51
    assert " root 2      1,4" in printed("collate", "author-1", "--sources", str(tmp_path)).out


def test_a_quotient_of_ones_own_is_held_to_the_method(tmp_path: Path) -> None:
    file = tmp_path / "$own$.csv"
    file.write_text("phi;p\n90;-1/4\n", encoding="utf-8")
    words = ("collate", "--csv", str(file), "--ratio=1:4")
    (exact,) = printed(*words, "-f", "csv").records()
    # -λ/√(1 - λ²), by hand.
    assert (exact["recomputed"], exact["verdict"], exact["detail"]) == (
        "-0,258199",
        "other_formula",
        "series",
    )
    (series,) = printed(*words, "--method=series", "-f", "csv").records()
    assert (series["recomputed"], series["verdict"]) == ("-1/4", "right")
    assert printed(*words).out.startswith(" Kollation von $own$.csv")


def test_a_transcription_can_go_by_expansion_ratios(tmp_path: Path) -> None:
    # The printed values, and those of tests/sources/weisbach, worked out with mpmath.
    path = written(tmp_path, "eps;1:5\n2;1,305\n3;1,374\n4;1,421\n5;1,453\n6;1,477\n")
    words = ("collate", "--csv", path, "--quantity=delta", "-f", "csv")
    exact = [(one["epsilon"], one["recomputed"], one["verdict"]) for one in printed(*words).records()]
    assert exact == [
        ("2", "1,282", "unexplained"), ("3", "1,374", "right"), ("4", "1,423", "other_formula"),
        ("5", "1,454", "last_place"), ("6", "1,478", "last_place"),
    ]  # fmt: skip
    own = [one["verdict"] for one in printed(*words, "--method=weisbach").records()]
    assert own == ["unexplained", "last_place", "right", "right", "right"]


def test_a_transcription_can_go_by_the_arm_of_the_beam(tmp_path: Path) -> None:
    path = written(tmp_path, "arm;mu;nu;path_1\n3;0°48';1°12';0,00010\n")
    words = ("collate", "--csv", path, "--ratio=1:5", "-f", "csv")
    found = [(one["quantity"], one["recomputed"]) for one in printed(*words).records()]
    assert found == [("mu", "0°49′"), ("nu", "1°14′"), ("path_1", "0,00013")]
    assert [one["verdict"] for one in printed(*words, "--method=approximate").records()] == ["right"] * 3


def test_sources_say_what_is_stated_and_what_is_inferred() -> None:
    said = printed("sources", "--lang=en").out
    assert "    Inferred: Author and title are not in the copy.\n" in said
    assert "    Stated: Title and equations (1) to (11).\n" in said


def test_every_book_says_what_it_states_and_what_was_inferred() -> None:
    for lang, words in (("de", ("Belegt: ", "Erschlossen: ")), ("en", ("Stated: ", "Inferred: "))):
        page = printed("sources", f"--lang={lang}").out
        assert page.count(f"    {words[0]}") == page.count(f"    {words[1]}") == 5


def test_a_byte_that_is_no_utf_8_is_named_with_its_line(tmp_path: Path) -> None:
    words = ("collate", "--csv", written(tmp_path, b"phi;p\n0;\xff\n"), "--ratio=1:4")
    sentence = "line 2: the byte 0xff is not UTF-8; save the transcription as CSV in UTF-8"
    assert sentence in refusal(*words, code=1)
