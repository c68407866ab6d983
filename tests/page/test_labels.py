"""The notation of labels: what is printed for it in each format, and what it refuses."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest
from golden import assert_golden
from hypothesis import given
from hypothesis import strategies as st
from page_formats import page_format
from places import GOLDEN

import kurbel
from kurbel import KurbelError
from kurbel.formats.registry import FORMATS, PageFormat
from kurbel.page.formula import Formula
from kurbel.page.labels import Mark, Prose, formula_plain, mark_text, parse, plain
from kurbel.page.quantity import Texts

PACKAGE = Path(kurbel.__file__).parent


def formula(source: str) -> Formula:
    (part,) = parse(f"${source}$")
    assert isinstance(part, Formula)
    return part


def test_formulas_and_marks_are_golden_in_every_notation() -> None:
    """The first line of each block is a formula as it is typed."""
    written = (GOLDEN / "formulas.txt").read_text(encoding="utf-8").strip("\n").split("\n\n")
    writers = {name: form.writer for name, form in FORMATS.items() if isinstance(form, PageFormat)}
    found = []
    for source in (block.splitlines()[0] for block in written):
        one = formula(source)
        lines = (f"    {name}: {writer.formula(one, ',')}".rstrip() for name, writer in writers.items())
        found.append("\n".join((source, f"    plain: {formula_plain(one, ',')}", *lines)))
    assert_golden("formulas.txt", "\n\n".join(found) + "\n")
    marks = {name: writer.note_mark("a") for name, writer in writers.items()}
    assert (marks["latex"], marks["typst"]) == (r"\textsuperscript{a)}", "#super[a)];")
    assert [mark_text(one) for one in ("a", "12", "*")] == ["ᵃ⁾", "¹²⁾", "*)"]


def test_only_a_formula_with_a_bar_needs_height_of_its_own() -> None:
    assert "displaystyle" not in page_format("latex").writer.formula(formula("x/R"), ".", display=True)
    assert "displaystyle" not in page_format("html").writer.formula(formula("x/R"), ".", display=True)
    latex, html = (
        page_format(name).writer.formula(formula("R (1/4 cos φ)"), ".", display=True)
        for name in ("latex", "html")
    )
    assert latex.startswith(r"$\displaystyle ")
    assert html.startswith('<math displaystyle="true">')


def test_label_falls_into_prose_formulas_and_marks() -> None:
    assert parse(r"5 \$ a[^b] $x$") == (Prose("5 $ a"), Mark("b"), Prose(" "), formula("x"))


def test_white_space_is_one_space_and_no_break_spaces_stay() -> None:
    assert plain("a\n\t b\u00a0c\u2028d") == "a b\u00a0c d"


def test_angle_in_prose_has_primes() -> None:
    assert plain("2°30'") == "2°30′"
    assert plain("0°0'20\" or 'so'") == "0°0′20″ or 'so'"


_PIECES = st.sampled_from(["$", "\\", *"()[]/_^ -±:°'", "sin", "cos", "x", "φ", "2", "4.5", '"', "[^a]"])


@given(st.one_of(st.text(), st.lists(_PIECES).map(lambda pieces: f"${''.join(pieces)}$")))
def test_any_label_is_set_in_every_notation_or_refused(label: str) -> None:
    try:
        parts = parse(label)
    except KurbelError:
        return
    writers = [entry.writer for entry in FORMATS.values() if isinstance(entry, PageFormat)]
    for part in parts:
        if isinstance(part, Formula):
            assert all(writer.formula(part, ",", True) for writer in writers)
    assert "\n" not in plain(label)


@given(st.text(alphabet="-,'<>|` a"))
def test_latex_prose_has_no_ligatures(prose: str) -> None:
    escaped = page_format("latex").writer.escape(prose)
    assert not any(pair in escaped for pair in ("--", ",,", "''", "<<", ">>", "`"))
    # In OT1, the encoding where nothing is said, these are ¡, ¿ and a dash.
    assert not set("<>|") & set(escaped)


@pytest.mark.parametrize(
    ("prose", "escaped"),
    [
        ("1. a", "1\\. a"),
        ("- a", "\\- a"),
        ("# a", "\\# a"),
        ("-5", "-5"),
        ("2.5", "2.5"),
        ("&amp;", "\\&amp;"),
    ],
)
def test_markdown_prose_starts_no_list(prose: str, escaped: str) -> None:
    assert page_format("markdown").writer.escape(prose) == escaped


@pytest.mark.parametrize("package", sorted(PACKAGE.rglob("texts.toml")), ids=lambda file: file.parent.name)
def test_a_text_has_the_same_places_in_both_languages(package: Path) -> None:
    for section in tomllib.loads(package.read_text("utf-8")):
        for key, text in Texts(".".join(package.parent.relative_to(PACKAGE).parts), section).items():
            de, en = (sorted(re.findall(r"\{\w+\}", text[lang])) for lang in ("de", "en"))
            assert de == en, key
