"""HTML pages in a browser: on a desktop and a telephone, in light and dark, and printed."""

from __future__ import annotations

import re
import subprocess
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from browser import TELEPHONE, Viewer, assert_readable, assert_readable_in_the_dark
from everything import everything
from pages import default_page
from rows import assert_rows_stand_in
from tools import require

import kurbel
from kurbel.documents import document as documents
from kurbel.formats.documents import document_files
from kurbel.formats.html.document import NAME
from kurbel.formats.html.writer import BREAK, hyphenated
from kurbel.formats.render import render
from kurbel.page.labels import plain
from kurbel.page.layouts import LANGUAGES, layout_names
from kurbel.page.table import Table

# Pages that differ in their parts: units in a column, several panels, angles across, words, formulas, marks.
SOME = ("delta-detail", "ensslin-forces", "roetscher-112", "firing", "formulas", "collation", "kolbenwege")


@cache
def default_document(name: str, lang: str = "de") -> str:
    return document(default_page(name, lang))


def document(table: Table) -> str:
    return render(table, "html", standalone=True)


@pytest.mark.parametrize(
    ("name", "lang"),
    [
        pytest.param(name, lang, marks=() if (name in SOME and lang == "de") else pytest.mark.slow)
        for name in layout_names()
        for lang in LANGUAGES
    ],
)
def test_everybody_can_read_a_layout(viewer: Viewer, name: str, lang: str) -> None:
    page = default_document(name, lang)
    assert_readable_in_the_dark(viewer, page)
    assert_readable(viewer, page)


# The formulas of a book are longer than the screen is wide.
SCROLLING = ["formulas"]
CUT = "[...document.querySelectorAll('.scroll')].some(one => one.scrollWidth > one.clientWidth + 1)"


@pytest.mark.parametrize("name", [*layout_names()[::4], *SCROLLING])
def test_a_telephone_shows_every_layout_with_its_caption_and_names_of_rows(viewer: Viewer, name: str) -> None:
    assert name in SCROLLING or not viewer.open(default_document(name), TELEPHONE).evaluate(CUT)
    assert viewer.misfits() == []
    assert viewer.lost() == []
    assert viewer.complaints == []


@pytest.mark.parametrize(
    ("source", "number", "lang"),
    [("blau", "33", "de"), pytest.param("uebung", "12", "en", marks=pytest.mark.slow)],
)
def test_everybody_can_read_an_example(viewer: Viewer, source: str, number: str, lang: str) -> None:
    page = document(kurbel.example(source, number, lang=lang))
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


# On a narrow screen ---------------------------------------------------------------------------------------


def test_long_formulas_do_not_hide_the_figures_behind_them(viewer: Viewer) -> None:
    for table in (kurbel.example("blau", "33"), default_page("roetscher-112")):
        page = viewer.open(document(table), TELEPHONE)
        assert viewer.lost() == []
        room = page.evaluate("""() => {
            const rows = [...document.querySelectorAll('.row')].filter(one => one.offsetHeight);
            const stub = rows[0]?.getBoundingClientRect();
            return innerWidth - (stub && stub.left < 20 ? stub.right : 0);
        }""")
        assert room > TELEPHONE / 2


@pytest.mark.parametrize("lang", ["de", pytest.param("en", marks=pytest.mark.slow)])
def test_long_words_of_heads_know_where_to_break(lang: str) -> None:
    columns = [
        one for name in layout_names() for panel in default_page(name, lang).panels for one in panel.columns
    ]
    labels = {label for one in columns for label in (*one.heading, *one.spanners)}
    words = {word for label in labels for word in re.findall(r"[^\W\d_]{11,}", plain(label))}
    assert len(words) >= 3
    assert {word for word in words if BREAK not in hyphenated(word, lang)} == set()


def test_the_keyboard_scrolls_a_wide_table(viewer: Viewer) -> None:
    # Where a wide table is in one piece.
    page = viewer.open(default_document("roetscher-112"), 700)
    # Whether it is wider than the window depends on the faces that the machine has.
    page.add_style_tag(content="table { letter-spacing: 0.2em }")
    assert page.evaluate("(one => one.scrollWidth > one.clientWidth)(document.querySelector('.scroll'))")
    page.keyboard.press("Tab")
    page.keyboard.press("ArrowRight")
    page.wait_for_function("document.querySelector('.scroll').scrollLeft > 0")
    assert page.evaluate("document.activeElement.className") == "scroll broad"


def test_no_sign_after_a_formula_begins_a_line(viewer: Viewer) -> None:
    page = viewer.open(default_document("engine-forces"))
    ends = page.evaluate("""() => {
        const caption = document.querySelector('caption > span'), found = [];
        for (let width = 150; width < 600; width += 15) {
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
    assert len(ends) == 60
    assert all(ends)


# What screen readers are told -----------------------------------------------------------------------------


def test_heads_that_are_formulas_have_names(viewer: Viewer) -> None:
    """What axe cannot judge: the browser gives every head to screen readers, those of MathML alone too."""
    page = viewer.open(default_document("solve"))
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

PRINTED = ["kinematics", "delta-verfahren", "solve", "roetscher-112"]


@pytest.mark.parametrize("name", PRINTED)
def test_print_has_every_figure(viewer: Viewer, name: str, tmp_path: Path) -> None:
    table = default_page(name)
    viewer.open(document(table), media="print").pdf(path=tmp_path / "page.pdf", format="A4")
    words = [require("pdftotext"), "-layout", "page.pdf", "-"]
    text = subprocess.run(words, cwd=tmp_path, check=True, capture_output=True, text=True).stdout
    assert_rows_stand_in(text.splitlines(), table, angles=False)


# Widths, reckoned from the text --------------------------------------------------------------------------

# What each table is reckoned to need, and what it takes, in units of its type. The widest
# face of the style sheet is DejaVu Serif.
RECKONED = """[...document.querySelectorAll(':not(.narrow) > table')].map(table => {
    const style = getComputedStyle(table), said = name => parseFloat(style.getPropertyValue(name));
    table.style.minWidth = 0;
    return [said('--wide') + said('--gaps'), table.offsetWidth / parseFloat(style.fontSize)];
})"""


def test_widths_are_reckoned_about_right_and_rather_too_wide(viewer: Viewer) -> None:
    names = layout_names()
    page = "".join(render(default_page(name), "html", standalone=True) for name in names[::4])
    found = viewer.open(page, 3000).evaluate(RECKONED)
    assert len(found) >= len(names[::4]) > 10
    assert all(0.65 < taken / reckoned < 1.2 for reckoned, taken in found), found


OUTSIDE = """[...document.querySelectorAll('table')].filter(table => {
    const box = table.getBoundingClientRect(), paper = document.querySelector('main').getBoundingClientRect();
    return box.left < paper.left - 1 || box.right > paper.right + 1;
}).map(table => table.closest('figure').id)"""
SMALLEST = (
    "Math.min(...[...document.querySelectorAll('td')].map(one => parseFloat(getComputedStyle(one).fontSize)))"
)
# The width between the margins of A4, and 6 points, in pixels.
TYPE_AREA, SMALLEST_TYPE = 643, 8


def test_no_layout_is_wider_than_the_paper_or_smaller_than_one_can_read(viewer: Viewer) -> None:
    names = layout_names()[::2]
    items = [documents.Item("table", name, number, "de", name) for number, name in enumerate(names, 1)]
    chapters = (documents.Chapter("Alle", "alle", 1, tuple(items)),)
    tables = {name: replace(default_page(name), key=name, layout=name) for name in names}
    fragments = {name: render(table, "html") for name, table in tables.items()}
    page = document_files(documents.Document("Tafeln", "de", "comma", chapters), "html", fragments)[NAME]
    viewer.open(page, TYPE_AREA, media="print")
    assert viewer.page.locator("table").count() >= len(names) > 20
    assert viewer.page.evaluate(OUTSIDE) == []
    assert viewer.page.evaluate(SMALLEST) >= SMALLEST_TYPE
    viewer.open(page.replace("--wide:", "--any:"), TYPE_AREA, media="print")
    # How many would be depends on the faces that the machine has.
    assert viewer.page.evaluate(OUTSIDE) != []
