"""The formulas as transcribed: every token stands in the books' lines, and the forms are made of the same.

tests/sources/formulas has those of the sections as they stand in the transcription of the books, in LaTeX.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping

import pytest
from places import SOURCES
from registers import FORMULAS, formulas, letters_of

TABLES = {key: formulas(key) for key in FORMULAS}
ROWS = [(key, row) for key in FORMULAS for row in TABLES[key]]
FUNCTIONS = ("sin", "cos", "cot", "arctan", "sqrt", "log", "nat", "min", "max")
GREEK = {
    "alpha": "α", "varepsilon": "ε", "varphi": "φ", "psi": "ψ", "pi": "π", "omega": "ω", "mu": "μ", "nu": "ν",
    "Delta": "Δ", "partial": "∂",
}  # fmt: skip
# As forms name them; what the books call small or differently has a letter of its own.
NAMES = {
    "alpha": "α", "eps": "ε", "phi": "φ", "psi": "ψ", "pi": "π", "omega": "ω", "ln": "log nat", "d": "Δ α",
    "t": "Δ t", "pm": "", "m": "m 1", "E": "L",
}  # fmt: skip
# Letters that stand for a part of the printed formula.
SHORT = ("x", "c", "y", "g", "u")
TOKEN = re.compile(r"[A-Za-zα-ωΔ∂]+|\d+(?:,\d+)?|[±∓+=-]")
MARKUP = re.compile(
    r"\\text ?\{(?!nat)[^}]*\}|\\(?:operatorname|text|dots|left|right|quad|cdot|frac|bar|overline|bcancel)"
    r"|\\(?:begin|end)\{aligned\}|&|\(\d+\)$"
)
# Printed in another place or as a part of another formula: v in v:c_m, GF in x = FA ± GF.
ELSEWHERE = {"quotient_v", "gf"}
# A form that is solved, multiplied or rearranged, or that stands for the words of the book.
REARRANGED = {
    "blau": {"af", "fd_return", "x_fd", "x_next", "c_next", "p_difference", "start"},
    "roetscher": {"cf", "cf_square", "gf_quotient"},
    "weisbach": {
        "work_strokes", "force", "force_quotient", "cut_off", "cut_off_cosine", "full", "full_speed",
        "least_slope", "greatest_slope", "least_share", "least_steam", "least", "least_best",
        "speed_square", "greatest_near", "fast",
    },
    "uebung": set(),
}  # fmt: skip


def tokens(text: str) -> list[str]:
    """Return the signs of a formula in their order: letters one by one, functions whole."""
    found: list[str] = []
    for token in TOKEN.findall(text.replace("−", "-").replace("…", "")):
        found += [token] if token in FUNCTIONS or not token[0].isalpha() else [*token]
    return found


def of_latex(text: str) -> list[str]:
    text = text.replace(r"\pm", "±").replace(r"\mp", "∓").replace("cotg", "cot")
    text = MARKUP.sub(" ", text)
    for name in FUNCTIONS:
        text = re.sub(rf"\\{name}(?![a-z])", f" {name} ", text)
    for name, letter in GREEK.items():
        text = re.sub(rf"\\{name}(?![a-z])", f" {letter} ", text)
    return tokens(text)


def of_label(text: str) -> list[str]:
    return tokens(re.sub(r"(\d)\.(\d)", r"\1,\2", text))


def of_form(form: str, forms: Mapping[str, str]) -> Iterator[str]:
    """Yield the signs of a form but for its operations."""
    for token in re.findall(r"[A-Za-z_]\w*|\d+(?:\.\d+)?", form):
        if token in SHORT and token in forms:
            yield from of_form(forms[token], forms)
        elif token in NAMES:
            yield from NAMES[token].split()
        elif token in FUNCTIONS or token[0].isdigit():
            yield token.replace(".", ",")
        else:
            yield from token.replace("_", "")


def book_of(key: str) -> str:
    """Return the signs of the section in one line."""
    book, name = key.split("-")
    folder = "examples" if name == "solutions" else "formulas"
    lines = (SOURCES / folder / f"{book}.tex").read_text(encoding="utf-8").splitlines()
    return " ".join(token for line in lines if not line.startswith("%") for token in of_latex(line))


@pytest.mark.parametrize("key", TABLES)
def test_every_formula_is_printed_so_in_its_book(key: str) -> None:
    book = f" {book_of(key)} "
    missing = {row["place"] for row in TABLES[key] if f" {' '.join(of_label(row['printed']))} " not in book}
    assert missing <= ELSEWHERE


def sides(row: Mapping[str, str]) -> Iterator[Counter[str]]:
    """Yield the signs of what a form may be: the last member, both sides, the first where the last is 0."""
    members = [
        Counter(one for one in of_label(part) if one not in "+-±∓") for part in row["printed"].split("=")
    ]
    yield members[-1]
    if len(members) > 1:
        yield members[-2] + members[-1]
        if members[-1] == Counter("0"):
            yield members[-2]


def test_forms_are_made_of_what_is_printed() -> None:
    for key, row in ROWS:
        if row["place"] in REARRANGED[key.split("-")[0]]:
            continue
        assert Counter(of_form(row["form"], letters_of(key))) in [*sides(row)], (key, row)
