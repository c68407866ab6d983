"""HTML pages in a browser: every layout on a desktop and a telephone, in light and dark, and printed."""

from __future__ import annotations

import re
import subprocess
from functools import cache
from pathlib import Path

import pytest
from browser import TELEPHONE, Viewer, assert_readable, assert_readable_in_the_dark
from everything import everything
from pages import default_page
from rows import assert_rows_stand_in
from tools import require

import kurbel
from kurbel.formats.html.writer import BREAK, hyphenated
from kurbel.formats.render import render
from kurbel.page.labels import plain
from kurbel.page.layouts import LANGUAGES, layout_names
from kurbel.page.table import Table

EXAMPLES = [("blau", "33"), ("uebung", "12"), ("weisbach", "149")]
each_example = pytest.mark.parametrize(("source", "number"), EXAMPLES)
each_name = pytest.mark.parametrize("name", layout_names())
each_language = pytest.mark.parametrize("lang", LANGUAGES)


@cache
def default_document(name: str, lang: str = "de") -> str:
    return document(default_page(name, lang))


def document(table: Table) -> str:
    return render(table, "html", standalone=True)


# What the languages do not share is words.
@pytest.mark.parametrize("lang", ["de", pytest.param("en", marks=pytest.mark.slow)])
@each_name
def test_everybody_can_read_every_layout(viewer: Viewer, name: str, lang: str) -> None:
    assert_readable(viewer, default_document(name, lang))
    assert name in SCROLLING or not viewer.page.evaluate(CUT)


# The formulas of a book are longer than the screen is wide.
SCROLLING = ["formulas"]
CUT = "[...document.querySelectorAll('.scroll')].some(one => one.scrollWidth > one.clientWidth + 1)"


@pytest.mark.slow
@each_name
def test_every_layout_is_good_in_the_dark(viewer: Viewer, name: str) -> None:
    assert_readable_in_the_dark(viewer, default_document(name))


@each_language
@each_example
def test_everybody_can_read_an_example(viewer: Viewer, source: str, number: str, lang: str) -> None:
    page = document(kurbel.example_table(source, number, lang=lang))
    assert_readable(viewer, page)
    assert_readable_in_the_dark(viewer, page)


def test_everybody_can_read_a_page_with_every_part(viewer: Viewer, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    page.write_text(document(everything()), encoding="utf-8")
    assert_readable_in_the_dark(viewer, page)
    assert_readable(viewer, page)
    assert viewer.page.locator(":not(.narrow) > table :is(td, th)").count() == 55
    assert viewer.page.locator(".narrow:visible").count() == 2
    assert not viewer.page.evaluate(CUT)


# Each names the fault of a page that has just this one.
FAULTS = {
    "image-alt": '<img src="data:image/gif;base64,R0lGODlhAQABAAAAACw=">',
    "color-contrast": '<p style="color: #bbb">pale</p>',
    "empty-table-header": "<table><tr><th></th><td>1</td></tr></table>",
    "px of 360": '<p style="width: 500px">wide</p>',
    "scrolls, but not by keyboard": '<div style="overflow-x: auto"><p style="width: 500px">wide</p></div>',
    "console": "<script>console.log('console')</script>",
    "no such name": "<script>throw new Error('no such name')</script>",
    "is lost": '<div class="scroll" tabindex="0"><p style="width: 500px" class="row">wide</p></div>',
    "failed": '<img alt="x" src="http://example.invalid/x.png">',
}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_is_found(viewer: Viewer, fault: str) -> None:
    viewer.open(
        f'<!DOCTYPE html><html lang="en"><title>x</title><main><h1>x</h1>{FAULTS[fault]}</main></html>',
        TELEPHONE,
    )
    found = viewer.misfits() + viewer.lost() + viewer.violations() + viewer.complaints
    assert any(fault in line for line in found), found


# On a narrow screen ---------------------------------------------------------------------------------------


def test_long_formulas_do_not_hide_the_figures_behind_them(viewer: Viewer) -> None:
    for table in (kurbel.example_table("blau", "33"), default_page("roetscher-112")):
        page = viewer.open(document(table), TELEPHONE)
        assert viewer.lost() == []
        room = page.evaluate("""() => {
            const rows = [...document.querySelectorAll('.row')].filter(one => one.offsetHeight);
            const stub = rows[0]?.getBoundingClientRect();
            return innerWidth - (stub && stub.left < 20 ? stub.right : 0);
        }""")
        assert room > TELEPHONE / 2


@each_name
def test_caption_and_names_of_rows_stay_in_view(viewer: Viewer, name: str) -> None:
    viewer.open(default_document(name), TELEPHONE)
    assert viewer.lost() == []


@pytest.mark.parametrize("lang", ["de", pytest.param("en", marks=pytest.mark.slow)])
def test_long_words_of_heads_know_where_to_break(lang: str) -> None:
    columns = [
        one for name in layout_names() for panel in default_page(name, lang).panels for one in panel.columns
    ]
    labels = {label for one in columns for label in (*one.heading, *one.spanners)}
    words = {word for label in labels for word in re.findall(r"[^\W\d_]{11,}", plain(label))}
    assert len(words) >= 3
    assert {word for word in words if BREAK not in hyphenated(word, lang)} == set()


# Where a wide table is in one piece.
TABLET = 700


def test_the_keyboard_scrolls_a_wide_table(viewer: Viewer) -> None:
    page = viewer.open(document(default_page("roetscher-112")), TABLET)
    page.keyboard.press("Tab")
    page.keyboard.press("ArrowRight")
    page.wait_for_function("document.querySelector('.scroll').scrollLeft > 0")
    assert page.evaluate("document.activeElement.className") == "scroll broad"


def test_no_sign_after_a_formula_begins_a_line(viewer: Viewer) -> None:
    page = viewer.open(document(default_page("engine-forces")))
    ends = page.evaluate("""() => {
        const caption = document.querySelector('caption > span'), found = [];
        for (let width = 150; width < 600; width += 3) {
            caption.style.width = width + 'px';
            for (const formula of caption.querySelectorAll('math')) {
                const sign = formula.nextSibling;
                if (!sign || !/^[,;]/.test(sign.data)) continue;
                const range = document.createRange();
                range.setStart(sign, 0); range.setEnd(sign, 1);
                found.push(range.getBoundingClientRect().left >= formula.getBoundingClientRect().right - 1);
            }
        }
        return found;
    }""")
    assert len(ends) == 300
    assert all(ends)


# What screen readers are told -----------------------------------------------------------------------------


@each_language
def test_heads_that_are_formulas_have_names(viewer: Viewer, lang: str) -> None:
    """What axe cannot judge: the browser gives every head to screen readers, those of MathML alone too."""
    page = viewer.open(document(default_page("solve", lang)))
    session = page.context.new_cdp_session(page)
    nodes = session.send("Accessibility.getFullAXTree")["nodes"]
    session.detach()
    heads = [node for node in nodes if node.get("role", {}).get("value") in ("columnheader", "rowheader")]
    assert len(heads) == page.locator("th:visible").count()
    by_id = {node["nodeId"]: node for node in nodes}

    def said(node: dict[str, object]) -> str:
        children = node.get("childIds", [])
        name = node.get("name", {})
        assert isinstance(children, list)
        assert isinstance(name, dict)
        return str(name.get("value", "")) + "".join(
            said(by_id[child]) for child in children if child in by_id
        )

    assert all(said(node).strip() for node in heads)


# In print -------------------------------------------------------------------------------------------------

PRINTED = ["kinematics", "engine-forces", "delta-verfahren", "solve", "roetscher-112", "machine-forces"]


@each_language
@pytest.mark.parametrize("name", PRINTED)
def test_print_has_every_figure(viewer: Viewer, name: str, lang: str, tmp_path: Path) -> None:
    table = default_page(name, lang)
    page = viewer.open(document(table), media="print")
    page.pdf(path=tmp_path / "page.pdf", format="A4")
    words = [require("pdftotext"), "-layout", "page.pdf", "-"]
    text = subprocess.run(words, cwd=tmp_path, check=True, capture_output=True, text=True).stdout
    assert_rows_stand_in(text.splitlines(), table, angles=False)
