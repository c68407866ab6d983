"""Markdown pages of all layouts, as a reader of GitHub's Markdown sees them."""

from __future__ import annotations

import re

import pytest
from markdown_it import MarkdownIt
from pages import default_page
from readers import markdown_tables, model_cells

import kurbel
from kurbel.formats.render import render
from kurbel.page.labels import plain
from kurbel.page.layouts import LANGUAGES, layout_names
from kurbel.page.table import Panel, Table

MARKS = {"de": ",", "en": "."}


def assert_read(table: Table) -> None:
    """Check that a reader sees every cell and head of the model, and the prose around them."""
    text = render(table, "markdown")
    mark = MARKS[table.lang]
    found = markdown_tables(text)
    # This reader drops no-break spaces, which indent a line, from the ends of a cell.
    assert [row for rows in found for row in rows[1:]] == [
        [cell.strip() for cell in row]
        for panel in table.panels
        for rows in model_cells(panel, mark)
        for row in rows
    ]
    for rows in found:
        assert {len(row) for row in rows} == {len(rows[0])}
    heads = [heads_of(panel, mark) for panel in table.panels]
    assert [rows[0] for rows in found] == [
        head
        for panel, head in zip(table.panels, heads, strict=True)
        for _ in range(len(panel.groups) if any(group.label for group in panel.groups) else 1)
    ]
    prose = prose_of(text)
    for label in (table.caption, table.source, *(note.text for note in table.notes)):
        assert plain(label, mark) in prose
    for panel in table.panels:
        for group in panel.groups:
            assert plain(group.label, mark) in prose


def heads_of(panel: Panel, mark: str) -> list[str]:
    """Return the head of each column, from the outermost spanner down; two figures have a stroke between."""
    heads = []
    for column in panel.stub + panel.columns:
        lines = [plain(line, mark) for line in column.heading if line]
        figures = len(lines) > 1 and all(re.fullmatch(r"[0-9][0-9.,]*°?", line) for line in lines)
        heading = (" / " if figures else " ").join(lines)
        heads.append(" ".join([*(plain(spanner, mark) for spanner in column.spanners), heading]).strip())
    return heads


def prose_of(text: str) -> str:
    """Return all that is not in a table, without marks of emphasis."""
    tokens = MarkdownIt("gfm-like", {"linkify": False}).parse(text)
    inline = [token for token in tokens if token.type == "inline"]
    return "\n".join("".join(child.content for child in token.children or []) for token in inline)


@pytest.mark.parametrize(("place", "name"), [*enumerate(layout_names()[1::2])])
def test_every_layout_is_read_cell_by_cell(place: int, name: str) -> None:
    assert_read(default_page(name, LANGUAGES[place % 2]))


@pytest.mark.parametrize(("source", "number"), [("blau", "33"), ("uebung", "12"), ("weisbach", "149")])
def test_an_example_is_read_cell_by_cell(source: str, number: str) -> None:
    for lang in LANGUAGES:
        assert_read(kurbel.example(source, number, lang=lang))
