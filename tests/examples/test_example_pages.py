"""The pages of the worked examples, read by eye: golden, one in every format."""

from __future__ import annotations

import json
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest
from cli import printed
from golden import assert_golden
from places import GOLDEN
from readers import fragment
from tex import PREAMBLE, compiled, complaints, each_engine, each_kind_of_table

import kurbel
from kurbel.formats.registry import FORMATS
from kurbel.formats.render import render
from kurbel.page.layouts import LANGUAGES
from kurbel.page.table import Table

EXAMPLES = [(line.split()[0], line.split()[1]) for line in printed("example").out.splitlines()]
SHORT = "uebung-12"
TEXTS = {
    **{f"{key}-{number}": (key, number) for key, number in EXAMPLES},
    "blau-31-own": ("blau", "31", "--ratio=1:4,5", "--angle=30;120"),
    "blau-33-own": ("blau", "33", "--ratio=1:4,5"),
    "blau-34-own": ("blau", "34", "--ratio=1:4,5"),
    "blau-35-own": ("blau", "35", "--ratio=1:4,5;5:6"),
    "uebung-12-own": ("uebung", "12", "--ratio=1:5", "--force=10kN"),
    "weisbach-149-own": ("weisbach", "149", "--ratio=1:4"),
    "weisbach-150-own": ("weisbach", "150", "--eps=4", "--back=0,1"),
}
# The book's numbers in German, others of two examples in both languages; a short one in every format.
BOTH = (SHORT, f"{SHORT}-own", "blau-31-own")
BOOKS = [f"{key}-{number}" for key, number in EXAMPLES]
PAGES = {
    **{
        f"{name}.{lang}.txt": (*words, f"--lang={lang}")
        for name, words in TEXTS.items()
        for lang in LANGUAGES
        if name in BOTH or (lang == "de" and name in BOOKS)
    },
    **{
        f"{SHORT}{entry.suffixes[0]}": (*TEXTS[SHORT], "-f", form)
        for form, entry in FORMATS.items()
        if form not in ("text", "json") and entry.kind in ("page", "records")
    },
}


@pytest.mark.parametrize("name", PAGES)
def test_page_is_golden(name: str) -> None:
    assert_golden(f"examples/{name}", printed("example", *PAGES[name]).out)


def test_no_golden_page_is_left_behind() -> None:
    assert {path.name for path in (GOLDEN / "examples").iterdir()} == set(PAGES)


@pytest.mark.parametrize("name", TEXTS)
@pytest.mark.parametrize("lang", LANGUAGES)
def test_a_page_fits_a_terminal_of_80_columns(name: str, lang: str) -> None:
    lines = printed("example", *TEXTS[name], f"--lang={lang}").out.splitlines()
    assert max(map(len, lines)) <= 80


def pages() -> list[Table]:
    return [
        *(
            kurbel.example(key, number, lang=lang, label=f"{key}-{number}-{lang}")
            for key, number in EXAMPLES
            for lang in LANGUAGES
        ),
        kurbel.example("blau", 33, ratio="1:4,5", label="own"),
        kurbel.example("blau", 35, ratio="5:6", label="roots"),
        kurbel.example("uebung", 12, ratio="2:9", force=10000, label="forces"),
        kurbel.example("weisbach", 150, eps=4, back="0.1", label="steam"),
    ]


@each_kind_of_table
@each_engine
def test_examples_compile_in_one_document(engine: str, longtable: bool, tmp_path: Path) -> None:
    inputs = ""
    for page in pages():
        text = render(page, "latex", longtable=longtable)
        (tmp_path / f"{page.key}.tex").write_text(text, encoding="utf-8")
        babel = {"de": "ngerman", "en": "english"}[page.lang]
        inputs += f"\\selectlanguage{{{babel}}}\n\\input{{{page.key}}}\n\\clearpage\n"
    log = compiled(engine, f"{PREAMBLE}{inputs}\\end{{document}}\n", tmp_path, runs=4)
    assert complaints(log) == []


def test_html_is_well_formed_and_has_a_row_for_each_step() -> None:
    for page in pages():
        tree = fragment(page)
        rows = sum(len(list(panel.rows())) for panel in page.panels)
        body = [row for row in tree.iter("tr") if row.get("class") != "group" and row.find("td") is not None]
        assert len(body) == rows or not page.panels[0].columns
        for fraction in tree.iter("mfrac"):
            assert len(fraction) == 2, ElementTree.tostring(fraction)


def test_markdown_and_json_hold_the_figures() -> None:
    for page in pages()[::5]:
        data = json.loads(render(page, "json"))
        assert [row["line"] for row in data["rows"]]
        text = render(page, "markdown")
        widths = {len(re.split(r"(?<!\\)\|", line)) for line in text.splitlines() if line.startswith("|")}
        assert len(widths) == 1
