"""Constructions in files that only they have: the page with steps to click through, and PGF for LaTeX."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest
from browser import TELEPHONE, Viewer, assert_readable, assert_readable_in_the_dark
from cli import printed
from playwright.sync_api import Page
from tex import compiled, complaints

import kurbel

PREAMBLE = r"""\documentclass{article}
\usepackage[T1]{fontenc}
\usepackage{lmodern,amsmath,pgf}
\usepackage[a4paper,margin=15mm]{geometry}
\begin{document}
"""
# The steps of what is seen of the drawing, and of what has the colour of the present step.
SEEN = """() => [...new Set([...document.querySelectorAll('svg [data-step]')]
    .filter(one => getComputedStyle(one).visibility === 'visible')
    .map(one => Number(one.dataset.step)))].sort()"""
PRESENT = "() => [...new Set([...document.querySelectorAll('.lesson-now')].map(one => one.dataset.step))]"
SAID = "() => [...document.querySelectorAll('[aria-current]')].map(one => one.id)"


def test_a_page_has_the_parts_and_the_sentence_of_every_step() -> None:
    drawing = kurbel.plot_construction("roetscher-1047-circle", ratio="1:3", angle=70, lang="en")
    page = drawing.image("html").decode()
    sentences = re.findall(r'<li id="step-(\d+)">', page)
    assert sentences == [str(number) for number in range(1, 7)]
    assert {*re.findall(r'data-step="(\d+)"', page)} == {*sentences}
    # All that is drawn belongs to a step: lines, discs, texts, leaders.
    svg = drawing.image().decode()
    drawn = re.findall(r'<g id="((?:line2d|patch|text)_\d+)">', svg)
    assert set(drawn) <= {"patch_1"}
    assert "lesson-later" not in re.sub(r"(?s)<style>.*?</style>|<script>.*?</script>", "", page)
    assert "//" not in re.sub(r"(?s)<script>.*?</script>|<style>.*?</style>|<!--.*?-->", "", page)


@pytest.mark.parametrize("name", ["ensslin-6", "radinger"])
def test_a_length_that_is_a_line_of_its_own_waits_for_its_step(name: str) -> None:
    drawing = kurbel.plot_construction(name)
    drawn = re.findall(r'<g id="(?:step|length)-[^"]+">', drawing.image().decode())
    assert drawing.image("html").decode().count("data-step=") == len(drawn)


def test_a_drawing_up_to_a_step_has_what_the_whole_one_has_in_its_place() -> None:
    whole, first, all_steps = (
        kurbel.plot_construction("blau-9", ratio="1:4", angle=50, steps=last).image().decode()
        for last in (None, 3, 5)
    )
    assert all_steps == whole
    kept = set(re.findall(r'<g id="([^"]+)">', first))
    assert {"step-3-1", "length-ad", "step-3-d"} < kept
    assert not {one for one in kept if re.match(r"step-[45]|length-(?!ad$)", one)}
    assert first.splitlines()[3] == whole.splitlines()[3]
    for name in ("length-ad", "step-2-1", "step-1-A"):
        place = re.compile(rf'<g id="{name}">(.*?)</g>', re.DOTALL)
        assert place.findall(first) == place.findall(whole)


def test_pgf_has_letters_as_text_and_nothing_of_the_machine(tmp_path: Path) -> None:
    first, second = (
        kurbel.plot_construction("blau-9", ratio="1:4", angle=50).image("pgf").decode() for _ in range(2)
    )
    assert first == second
    assert r"$\overline{fd}$" in first
    assert str(Path.home()) not in first
    assert "ttf" not in first
    assert "includegraphics" not in first


@pytest.mark.slow
@pytest.mark.parametrize("engine", ["pdflatex", "lualatex"])
def test_latex_sets_every_construction(engine: str, tmp_path: Path) -> None:
    names = [line.split()[0] for line in printed("construct").out.splitlines()]
    for name in names:
        kurbel.plot_construction(name).save(tmp_path / f"{name}.pgf")
    kurbel.turning(eps=4, ratio="1:5").save(tmp_path / "turning.pgf")
    text = "\n\n".join(rf"\noindent\input{{{name}.pgf}}" for name in (*names, "turning"))
    log = compiled(engine, f"{PREAMBLE}{text}\n\\end{{document}}\n", tmp_path)
    assert complaints(log) == []
    assert "Output written" in log


@pytest.fixture
def page(viewer: Viewer, tmp_path: Path) -> Page:
    path = tmp_path / "fig9.html"
    kurbel.plot_construction("blau-9", ratio="1:4", angle=50).save(path)
    return viewer.open(path)


@pytest.mark.slow
def test_steps_are_gone_through_by_keys_and_buttons(page: Page, viewer: Viewer) -> None:
    assert page.evaluate(SEEN) == [1]
    page.keyboard.press("ArrowRight")
    page.click(".lesson-next")
    assert (page.evaluate(SEEN), page.evaluate(PRESENT)) == ([1, 2, 3], ["3"])
    assert page.evaluate(SAID) == ["step-3"]
    assert page.text_content(".lesson-at") == "Schritt 3 von 5"
    page.keyboard.press("ArrowLeft")
    assert page.evaluate(SEEN) == [1, 2]
    page.click("#step-4")
    assert page.evaluate(SEEN) == [1, 2, 3, 4]
    assert page.url.endswith("#step-4")
    page.click(".lesson-all")
    assert (page.evaluate(SEEN), page.evaluate(PRESENT)) == ([1, 2, 3, 4, 5], [])
    page.keyboard.press("ArrowRight")
    assert page.text_content(".lesson-at") == "Alle 5 Schritte"
    page.click(".lesson-start")
    page.emulate_media(media="print")
    assert page.evaluate(SEEN) == [1, 2, 3, 4, 5]
    assert viewer.complaints == []


@pytest.mark.slow
def test_without_a_script_the_whole_drawing_is_there(page: Page, viewer: Viewer) -> None:
    context = page.context.browser.new_context(java_script_enabled=False)  # type: ignore[union-attr]
    still = context.new_page()
    still.goto(page.url)
    assert still.locator("svg [data-step]:visible").count() > 20
    assert not still.locator(".lesson-choices").is_visible()
    context.close()


@pytest.mark.slow
@pytest.mark.parametrize("name", ["blau-9", "forces"])
def test_everybody_can_read_the_page(name: str, viewer: Viewer, tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    kurbel.plot_construction(name, ratio="1:4", lang="en").save(path)
    assert_readable(viewer, path)
    assert_readable_in_the_dark(viewer, path)
    viewer.open(path, TELEPHONE)
    assert viewer.lost() == []


@pytest.mark.parametrize("name", ["roetscher-1047-circle", "forces"])
def test_a_letter_is_nearest_to_its_own_point(name: str) -> None:
    figure = kurbel.plot_construction(name, ratio="1:4", angle=50).figure
    (axes,) = figure.axes
    # Discs of points bear their letters.
    marks = (one for one in axes.patches if re.fullmatch(r"step-\d+-[A-Z](_\d|')?", str(one.get_gid())))
    points = {str(one.get_gid()).split("-")[2]: one.get_extents() for one in marks}
    boxes = {}
    for text in axes.texts:
        letter = text.get_text().strip("$").replace("^{\\prime}", "'").replace("{", "").replace("}", "")
        if letter in points:
            boxes[letter] = text.get_window_extent()
    assert len(boxes) == len(points) > 5
    for letter, box in boxes.items():
        middle = ((box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2)
        apart = {
            one: math.dist(middle, (at.x0 + at.width / 2, at.y0 + at.height / 2))
            for one, at in points.items()
        }
        assert min(apart, key=lambda one: apart[one]) == letter
