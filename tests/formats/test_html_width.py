"""The width of a table reckoned from its text, against what a browser makes of it."""

from __future__ import annotations

from dataclasses import replace

import pytest
from browser import Viewer
from pages import default_page

from kurbel.documents.document import Chapter, Document, Item
from kurbel.formats.documents import document_files
from kurbel.formats.html.document import NAME, width_in_ems
from kurbel.formats.render import render
from kurbel.page.layouts import layout_names

LETTER, BETWEEN = 0.64, 1.1


def cells(*rows: str) -> str:
    return f"<table>{''.join(f'<tr>{row}</tr>' for row in rows)}</table>"


@pytest.mark.parametrize(
    ("table", "letters", "columns"),
    [
        (cells("<td>12</td><td>1</td>", "<td>1</td><td>123</td>"), 5, 2),
        (cells("<td rowspan=2>123</td><td>1</td>", "<td>12345</td>"), 8, 2),
        (cells("<th colspan=2>12</th>", "<td>12</td><td>12</td>"), 4, 2),
        (cells("<td>1234<br>12</td>"), 4, 1),
        (cells("<td><mfrac><mn>12</mn><mn>34</mn></mfrac></td>"), 2, 1),
        (f"<caption>123456</caption>{cells('<td>1</td>')}<p>1234567</p>{cells('<td>123</td>')}", 3, 1),
        ("<p>no table</p>", 0, 0),
    ],
)
def test_width_is_that_of_the_widest_cell_of_each_column(table: str, letters: int, columns: int) -> None:
    assert width_in_ems(table) == pytest.approx(LETTER * letters + BETWEEN * columns, rel=1e-12)


def test_a_cell_across_columns_widens_them() -> None:
    table = cells("<th colspan=2>1234567890</th>", "<td>1</td><td>1</td>")
    assert width_in_ems(table) == pytest.approx(LETTER * 10 + BETWEEN, rel=1e-12)


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
    viewer.open(page.replace("--ems:", "--em:"), TYPE_AREA, media="print")
    assert len(viewer.page.evaluate(OUTSIDE)) > 3
