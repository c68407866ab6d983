"""The width of a table reckoned from its text, against what a browser makes of it."""

from __future__ import annotations

from dataclasses import replace

from browser import Viewer
from pages import default_page

from kurbel.documents.document import Chapter, Document, Item
from kurbel.formats.documents import document_files
from kurbel.formats.html.document import NAME
from kurbel.formats.render import render
from kurbel.page.layouts import layout_names

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
    names = layout_names()
    items = [Item("table", name, number, "de", name) for number, name in enumerate(names, 1)]
    chapters = (Chapter("Alle", "alle", 1, tuple(items)),)
    tables = {name: replace(default_page(name), key=name, layout=name) for name in names}
    fragments = {name: render(table, "html") for name, table in tables.items()}
    page = document_files(Document("Tafeln", "de", "comma", chapters), "html", fragments)[NAME]
    viewer.open(page, TYPE_AREA, media="print")
    assert viewer.page.locator("table").count() >= len(names) > 20
    assert viewer.page.evaluate(OUTSIDE) == []
    assert viewer.page.evaluate(SMALLEST) >= SMALLEST_TYPE
    viewer.open(page.replace("--wide:", "--any:"), TYPE_AREA, media="print")
    assert len(viewer.page.evaluate(OUTSIDE)) > 3
