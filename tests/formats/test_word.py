"""HTML as pandoc makes a document of Word of it, by the filter in examples/word.lua."""

from __future__ import annotations

import io
import subprocess
from xml.etree.ElementTree import Element, fromstring
from zipfile import ZipFile

import pytest
from everything import everything
from pages import default_page
from places import ROOT
from rows import assert_rows_stand_in
from tools import require

from kurbel.formats.render import render
from kurbel.page.table import Table

W = "{http://schemas.openxmlformats.org/wordprocessingml/2006/main}"
M = "{http://schemas.openxmlformats.org/officeDocument/2006/math}"
PAGES = ("kinematics", "kolbenwege", "delta-tafel", "firing", "verfahren", "forces")


def word(page: Table, standalone: bool = False) -> Element:
    """Return what Word reads of the document."""
    html = render(page, "html", standalone=standalone)
    words = ["-f", "html", "-t", "docx", "-L", str(ROOT / "examples" / "word.lua"), "-o", "-"]
    done = subprocess.run([require("pandoc"), *words], input=html.encode(), capture_output=True, check=True)
    assert done.stderr == b""
    with ZipFile(io.BytesIO(done.stdout)) as file:
        return fromstring(file.read("word/document.xml"))


def text(element: Element) -> str:
    return "".join(one.text or "" for one in element.iter() if one.tag in (f"{W}t", f"{M}t"))


def aligned(cell: Element) -> str | None:
    found = cell.find(f".//{W}jc")
    return None if found is None else found.get(f"{W}val")


def test_heads_are_merged_and_every_formula_is_an_equation() -> None:
    made = word(everything())
    first, second = made.iter(f"{W}tbl")
    head = [row for row in first.iter(f"{W}tr") if row.find(f"{W}trPr/{W}tblHeader") is not None]
    spans = [
        [(text(cell), int(span.get(f"{W}val", 0)))]
        for row in head
        for cell in row.iter(f"{W}tc")
        if (span := cell.find(f"{W}tcPr/{W}gridSpan")) is not None and span.get(f"{W}val") != "1"
    ]
    assert spans == [[("Genaue Wertea)", 4)], [("Kolbenweg", 2)]]
    merged = [one.get(f"{W}val") for one in first.iter(f"{W}vMerge")]
    assert merged.count("restart") == 3 + 1 + 2
    equations = [text(one) for one in made.iter(f"{M}oMath")]
    assert [one for one in ("R:L", "φ", "x/R", "c/v", "ψ", "λ=1/5") if one not in equations] == []
    assert len(head) == 3
    assert "1:4,5" in text(first)
    assert "0°0′" in text(first)
    assert not [*made.iter(f"{W}numPr")], "a note has a bullet"
    for note in ("a) Auf", "Quelle: F. Rötscher"):
        assert [one for one in made.iter(f"{W}p") if text(one).startswith(note)], note
    last = [*second.iter(f"{W}tr")][-1]
    assert [text(cell) for cell in last.iter(f"{W}tc")] == ["", "90", "−0,014", "–"]
    # The mark of a note leads to it.
    targets = {one.get(f"{W}name") for one in made.iter(f"{W}bookmarkStart")}
    links = [one.get(f"{W}anchor") for one in made.iter(f"{W}hyperlink")]
    assert len(links) == 4
    assert targets.issuperset(links)


@pytest.mark.slow
@pytest.mark.parametrize("name", PAGES)
def test_every_row_has_its_figures_at_the_right(name: str) -> None:
    page = default_page(name, "de")
    made = word(page, standalone=True)
    # The table for telephones is left out.
    assert len([*made.iter(f"{W}tbl")]) == len(page.panels)
    cells = [[*row.iter(f"{W}tc")] for row in made.iter(f"{W}tr")]
    assert_rows_stand_in([" ".join(map(text, row)) for row in cells], page)
    figures = [
        cell for row in cells for cell in row if text(cell).replace(",", "").replace("−", "").isdigit()
    ]
    assert len(figures) > 10
    assert {aligned(cell) for cell in figures} == {"right"}
