"""Drawings inside a page: they look like their files, whatever else stands on the page."""

from __future__ import annotations

import re
from functools import cache

import pytest
from browser import Viewer
from cli import printed
from manifests import FIGURES

from kurbel.formats.html.document import COLOURS, inline

SIZE = "svg { display: block; width: 600px; height: auto; }"
ITSELF = "".join(f"--{name}: {colour};" for colour, name in COLOURS.items())


@cache
def drawing(name: str) -> str:
    return printed(*FIGURES[name].removesuffix(" -f drawing").split(), "-f", "svg").out


def picture(viewer: Viewer, body: str) -> bytes:
    viewer.open(f"<!DOCTYPE html><style>:root {{ {ITSELF} }} {SIZE} body {{ margin: 0; }}</style>{body}", 600)
    return viewer.page.screenshot()


def bare(svg: str) -> str:
    return svg[svg.index("<svg") :]


@pytest.mark.parametrize("name", FIGURES)
def test_a_drawing_looks_as_in_its_file(viewer: Viewer, name: str) -> None:
    found = picture(viewer, inline(drawing(name), "fig-a", "A", own_page=True))
    assert found == picture(viewer, bare(drawing(name)))
    assert found != picture(viewer, "")


def test_a_drawing_looks_the_same_beside_others(viewer: Viewer) -> None:
    """Ids of one drawing, such as that of a clipping path, occur in the next with another meaning."""
    first, second = (inline(drawing(name), f"fig-{name}", name, own_page=True) for name in FIGURES)
    for one, other in ((first, second), (second, first)):
        hidden = f'<div style="position: absolute; top: 200vh">{other}</div>'
        assert picture(viewer, hidden + one) == picture(viewer, one)


@pytest.mark.parametrize("name", FIGURES)
def test_ids_are_the_drawings_own_and_all_are_used(name: str) -> None:
    svg = inline(drawing(name), "fig-a", 'Title "<&>"', own_page=True)
    ids = re.findall(r'\bid="([^"]*)"', svg)
    used = re.findall(r"url\(#([^)]*)\)", svg) + re.findall(r'href="#([^"]*)"', svg)
    assert len(ids) == len(set(ids)) > 10
    assert all(one.startswith("fig-a-") for one in ids)
    assert {*used, "fig-a-title"} == set(ids)


@pytest.mark.parametrize("name", FIGURES)
def test_what_only_files_need_is_gone(name: str) -> None:
    """A colour without a name would be the same on dark paper, and hard to see."""
    svg = inline(drawing(name), "fig-a", 'Title "<&>"', own_page=True)
    assert re.match('<svg [^>]*style="stroke-linejoin: round', svg)
    assert re.findall("<style|metadata|xmlns|<!|<[?]|#[0-9a-f]{6}", svg) == []
    assert '<title id="fig-a-title">Title "&lt;&amp;&gt;"</title>' in svg
