"""Interactive pages in a browser: what is chosen by the keyboard is shown, and nothing else is asked for."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import DESKTOP, Viewer, assert_readable, assert_readable_in_the_dark
from cli import kurbel, printed
from playwright.sync_api import Page, Request
from programs import wait_until

MANIFEST = """
title = "Motion"
lang = "en"
formats = ["html"]

[defaults]
interactive = true

[[chapter]]
title = "Cranks"
[[chapter.part]]
run = "table --ratio 1:4;1:5 --angle 0..180:30"
name = "motion"
[[chapter.part]]
run = "delta --eps 2..4"
name = "evenness"
[[chapter.part]]
run = "collate roetscher-112"
name = "printed"
"""
# The figures of the table that is seen, row by row.
ROWS = """() => [...document.querySelectorAll('.live-page .scroll')].filter(one => one.offsetHeight).flatMap(
    one => [...one.querySelectorAll('tbody tr')].map(row => [...row.cells].map(cell => cell.textContent)))"""
VALUES = "() => [...document.querySelectorAll('.live-value')].map(one => one.textContent)"
MARKED = "() => document.querySelector('tr[aria-current]').cells[0].textContent"


def written(folder: Path, *words: str) -> Path:
    path = folder / "page.html"
    printed(*words, "--interactive", "-o", str(path))
    return path


def records(*words: str) -> list[list[str]]:
    """Return what a command prints as data, as it is set on a page in German."""
    found = printed(*words, "-f", "csv").records()
    return [[text.replace("-", "−").replace(".", ",") for text in list(one.values())] for one in found]


@pytest.fixture(scope="module")
def offset(tmp_path_factory: pytest.TempPathFactory) -> Path:
    words = ("table", "--ratio=1:3..6", "--offset=0..0.5:0.1", "--angle=0..180:30")
    return written(tmp_path_factory.mktemp("offset"), *words)


@pytest.fixture
def requests(viewer: Viewer) -> Iterator[list[str]]:
    """What a page asks for, itself aside."""
    asked: list[str] = []

    def listener(request: Request) -> None:
        asked.append(request.url)

    viewer.page.on("request", listener)
    yield asked
    viewer.page.remove_listener("request", listener)


def press(page: Page, slider: str, *keys: str) -> None:
    page.focus(f"input[id$=-{slider}]")
    for key in keys:
        page.keyboard.press(key)


def test_the_keyboard_chooses_and_the_table_is_what_is_printed_for_that_step(
    viewer: Viewer, offset: Path, requests: list[str]
) -> None:
    page = viewer.open(offset)
    press(page, "ratio", "End", "ArrowLeft")
    press(page, "offset", "ArrowRight", "ArrowRight", "ArrowRight")
    press(page, "phi", "Home", *["ArrowRight"] * 8)
    chosen = ("table", "--ratio=1:5", "--offset=0.3")
    shown = [row[1:] for row in records(*chosen, "--angle=0..180:30")]
    assert page.evaluate(ROWS) == shown
    assert [page.evaluate(VALUES)] == records(*chosen, "--angle=40", "--columns=x,c,p")
    assert page.evaluate(MARKED) == "30"
    assert page.locator("input[id$=-offset]").get_attribute("aria-valuetext") == "0,3"
    assert page.get_by_label("Kurbelverhältnis").count() == 1
    # What is chosen stands in the address, and opens the page again.
    assert page.evaluate("location.hash") == "#ratio=1:5&offset=0,3&phi=40"
    assert "R:L = 1:5" in page.title()
    assert page.locator("h1").text_content() == page.title()
    page.reload()
    assert page.evaluate(ROWS) == shown
    assert viewer.complaints == []
    assert [url for url in requests if url.partition("#")[0] != offset.as_uri()] == []


@pytest.mark.slow
def test_a_figure_in_a_curve_is_that_of_the_step_it_names(viewer: Viewer, tmp_path: Path) -> None:
    # The true greatest velocity, 1,0198 at 79,1°, is none of the figures of the steps.
    page = viewer.open(written(tmp_path, "table", "--columns=c"))
    labels = page.locator(".live-extreme").all_text_contents()
    named = [re.findall(r"(\S+) \((\d+)°\)", one) for one in labels]
    assert named == [[("−1,0197", "280")], [("1,0197", "80")]]


@pytest.mark.slow
def test_an_address_may_have_points_and_what_it_does_not_know(viewer: Viewer, offset: Path) -> None:
    page = viewer.open(offset)
    page.evaluate("location.hash = '#offset=0.2&phi=7&ratio=1:9&x&%E0'")
    wait_until(lambda: page.evaluate("document.querySelector('input[id$=-offset]').value") == "2")
    assert page.evaluate("document.querySelector('input[id$=-ratio]').value") == "0"
    assert viewer.complaints == []


@pytest.mark.slow
def test_the_crank_turns_until_it_is_stopped(viewer: Viewer, offset: Path) -> None:
    page = viewer.open(offset)
    x = "document.querySelector('.live-crank').getAttribute('x2')"
    before = page.evaluate(x)
    page.get_by_role("button", name="Drehen").click()
    wait_until(lambda: page.evaluate(x) != before)
    wait_until(lambda: page.evaluate("Number(document.querySelector('.live-along').value) > 14"))
    page.get_by_role("button", name="Anhalten").click()
    assert page.get_by_role("button", name="Drehen").is_visible()
    stopped = page.evaluate(x)
    page.wait_for_timeout(100)
    assert page.evaluate(x) == stopped


@pytest.mark.slow
def test_nothing_turns_for_those_who_ask_for_that(viewer: Viewer, offset: Path) -> None:
    viewer.page.emulate_media(reduced_motion="reduce")
    page = viewer.open(offset)
    assert not page.get_by_role("button").is_visible()
    page.emulate_media(reduced_motion="no-preference")
    wait_until(page.get_by_role("button", name="Drehen").is_visible)


@pytest.mark.slow
@pytest.mark.parametrize(
    "words",
    [
        ("table", "--angle=0..180:30"),
        ("table", "--mechanism=beam", "--beam=3", "--lang=en"),
        ("turning", "--eps=2..4", "--lang=en"),
        ("delta", "--eps=2;4", "--detail"),
    ],
    ids=" ".join,
)
def test_everybody_can_use_a_page_on_a_telephone_too(
    viewer: Viewer, tmp_path: Path, words: tuple[str, ...]
) -> None:
    page = written(tmp_path, *words)
    assert_readable(viewer, page)
    press(viewer.page, "ratio" if viewer.page.locator("[id$=-ratio]").count() else "phi", "End")
    assert (viewer.misfits(), viewer.complaints) == ([], [])
    assert_readable_in_the_dark(viewer, page)


@pytest.mark.slow
def test_paper_has_the_step_that_is_chosen_and_no_sliders(viewer: Viewer, offset: Path) -> None:
    page = viewer.open(offset)
    press(page, "ratio", "End")
    page.emulate_media(media="print")
    assert not page.locator(".live-along").is_visible()
    assert not page.get_by_role("button").is_visible()
    assert page.locator(".live-chosen").all_inner_texts() == ["1:6", "0", "60°"]
    assert page.evaluate(ROWS)[3] == records("table", "--ratio=1:6", "--angle=90")[0][1:]


@pytest.mark.slow
def test_without_a_script_a_page_is_the_table_of_its_first_step(viewer: Viewer, offset: Path) -> None:
    browser = viewer.page.context.browser
    assert browser is not None
    context = browser.new_context(java_script_enabled=False, viewport={"width": DESKTOP, "height": 800})
    page = context.new_page()
    page.goto(offset.as_uri())
    assert page.locator("input:visible, button:visible, svg:visible").count() == 0
    first = records("table", "--ratio=1:3", "--offset=0", "--angle=30")[0][1:]
    assert page.locator("tbody tr").nth(1).locator("th, td").all_inner_texts() == first
    context.close()


@pytest.mark.slow
def test_a_handbook_has_several_interactive_tables_and_one_script(viewer: Viewer, tmp_path: Path) -> None:
    (tmp_path / "handbook.toml").write_text(MANIFEST, encoding="utf-8")
    assert kurbel("handbook", "build", str(tmp_path)).code == 0
    handbook = tmp_path / "pages" / "handbook.html"
    assert_readable(viewer, handbook)
    page = viewer.open(handbook)
    assert page.locator("script:not([type])").count() == 1
    # Nothing can be chosen of what a book printed.
    assert page.locator(".live").count() == 2
    press(page, "evenness-ratio", "Home")
    press(page, "motion-ratio", "End")
    for name, ratio in (("motion", "1:5"), ("evenness", "1:3")):
        assert ratio in (page.locator(f"#tab-{name} caption").first.text_content() or "")
    assert (viewer.misfits(), viewer.violations(), viewer.complaints) == ([], [], [])
