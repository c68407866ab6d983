"""Pages of Markdown and HTML as their readers see them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise
from xml.etree import ElementTree

from markdown_it import MarkdownIt

from kurbel.exact.numerals import Number, number_text
from kurbel.formats.render import render
from kurbel.page.labels import mark_text, plain
from kurbel.page.table import DITTO, Panel, Table


def markdown_tables(text: str) -> list[list[list[str]]]:
    """Return the cells of all tables, as a reader of GitHub's Markdown sees them."""
    tables: list[list[list[str]]] = []
    tokens = MarkdownIt("gfm-like", {"linkify": False}).parse(text)
    for before, token in pairwise(tokens):
        if before.type == "table_open":
            tables.append([])
        if token.type == "tr_open":
            tables[-1].append([])
        if before.type in ("th_open", "td_open"):
            children = token.children or []
            tables[-1][-1].append("".join(child.content for child in children))
    return tables


def model_cells(panel: Panel, decimal: str = ",") -> Iterator[list[list[str]]]:
    """Yield the body of each group as text, worked out from the model alone."""
    above: dict[int, str] = {}
    for group in panel.groups:
        rows = []
        for row in group.rows:
            texts = []
            for place, cell in enumerate(row.stub + row.cells):
                if cell.value is DITTO:
                    text = above[place]
                elif isinstance(cell.value, Number):
                    text = number_text(cell.value, decimal, "−")
                else:
                    text = plain(cell.value, decimal) if isinstance(cell.value, str) else "–"
                above[place] = text
                texts.append(text + "".join(map(mark_text, cell.notes)))
            rows.append(texts)
        yield rows


def fragment(table: Table) -> ElementTree.Element:
    """Return the fragment as a tree; ElementTree refuses what is not well formed."""
    text = render(table, "html")
    return ElementTree.fromstring(re.sub(r"<(br|col)( [^>]*)?>", r"<\1\2/>", text[text.index("<figure") :]))
