"""A page in a notebook looks as its standalone HTML does, under JupyterLab's rules for all tables."""

from __future__ import annotations

from typing import Any

import pytest
from browser import Viewer

import kurbel

# Those of JupyterLab 4 that would be seen, with the values that its light theme gives to its variables.
JUPYTER = """
.jp-RenderedHTMLCommon { color: #333; font-family: sans-serif; font-size: 14px; line-height: 1.6; }
.jp-RenderedHTMLCommon ul:not(.list-inline) { padding-left: 2em; }
.jp-RenderedHTMLCommon ul { list-style: disc; }
.jp-RenderedHTMLCommon * + ul { margin-top: 0.5em; }
.jp-RenderedHTMLCommon table { border-collapse: collapse; border: none; color: #111; font-size: 12px;
    table-layout: fixed; margin: 0 auto 1em; }
.jp-RenderedHTMLCommon thead { border-bottom: 1px solid #bdbdbd; vertical-align: bottom; }
.jp-RenderedHTMLCommon :is(td, th, tr) { vertical-align: middle; padding: 0.5em; line-height: normal;
    white-space: normal; max-width: none; border: none; }
:not(.jp-RenderedMarkdown).jp-RenderedHTMLCommon :is(td, th, tr) { text-align: right; }
.jp-RenderedHTMLCommon th { font-weight: bold; }
.jp-RenderedHTMLCommon tbody tr:nth-child(even) { background: #f5f5f5; }
"""
# Of each cell its place in the table and what one sees of it, and of the notes too.
LOOK = """() => {
    const table = document.querySelector('table').getBoundingClientRect();
    const rows = ['backgroundColor', 'borderBottomWidth'];
    const cells = [...rows, 'textAlign', 'borderTopWidth', 'borderTopColor', 'fontSize', 'fontFamily',
        'fontWeight', 'lineHeight', 'color', 'backgroundImage', 'paddingLeft', 'listStyleType'];
    const seen = document.querySelectorAll('caption, thead, tr, th, td, .notes, .notes li');
    return [...seen].filter(one => one.offsetHeight).map(one => {
        const box = one.getBoundingClientRect(), style = getComputedStyle(one);
        const place = [box.left - table.left, box.top - table.top, box.width, box.height];
        const names = one.matches('thead, tr') ? rows : cells;
        return [one.className, ...place.map(Math.round), ...names.map(name => style[name])];
    });
}"""


@pytest.mark.parametrize(
    "page",
    [
        kurbel.table("1:4;1:5", step=30, method="series"),
        kurbel.forces("1:5", eps=4, step=45, lang="en"),
        kurbel.collate("roetscher-112"),
    ],
    ids=lambda page: page.key,
)
def test_a_notebook_shows_the_page_as_its_own_page_looks(viewer: Viewer, page: Any) -> None:
    alone = viewer.open(page.typeset("html", standalone=True)).evaluate(LOOK)
    head = f"<!DOCTYPE html><style>{JUPYTER} body {{ margin: 0 }}</style>"
    cell = f'{head}<div class="jp-RenderedHTMLCommon">{page._repr_html_()}</div>'
    notebook = viewer.open(cell).evaluate(LOOK)
    assert len(alone) > 20
    assert notebook == alone
    assert viewer.complaints == []
