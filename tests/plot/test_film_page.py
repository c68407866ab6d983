"""Pages of drawings that move in a browser: led by the keyboard, still for those who ask for that."""

from __future__ import annotations

import cmath
import math
from pathlib import Path

import pytest
from browser import DESKTOP, Viewer, assert_readable, assert_readable_in_the_dark
from cli import printed
from drawings import MM
from playwright.sync_api import Page
from programs import wait_until

# Where the ends of a line are on the screen, in units of the drawing.
ENDS = """key => {
    const path = document.querySelector(`[id$=film-${key}] path`), root = path.ownerSVGElement;
    const matrix = root.getScreenCTM().inverse().multiply(path.getScreenCTM());
    return [0, path.getTotalLength()].map(at => {
        const {x, y} = path.getPointAtLength(at).matrixTransform(matrix);
        return [x, y];
    });
}"""
TIMES = "() => document.getAnimations().map(one => one.currentTime)"


@pytest.fixture(scope="module")
def turn(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("film") / "turn.html"
    printed("plot", "--animate", "--ratio=1:3", "--lang=en", "-o", str(path))
    return path


def ends(page: Page, key: str) -> list[complex]:
    return [complex(x, -y) / MM for x, y in page.evaluate(ENDS, key)]


@pytest.mark.slow
def test_the_keyboard_leads_the_links_to_their_places_and_the_numbers_with_them(
    viewer: Viewer, turn: Path
) -> None:
    page = viewer.open(turn)
    page.focus(".film-slider")
    page.keyboard.press("Home")
    for _ in range(7):
        page.keyboard.press("ArrowRight")
    page.keyboard.press("PageUp")
    angle = int(page.locator(".film-slider").input_value())
    assert angle > 7
    assert page.locator(".film-slider").get_attribute("aria-valuetext") == f"{angle}°"
    assert page.get_by_role("slider", name="Crank angle").count() == 1
    shaft, pin = ends(page, "crank-1")
    start, end = ends(page, "rod-1")
    radius, turned = abs(pin - shaft), cmath.rect(1, math.radians(angle))
    assert abs(pin - shaft - radius * turned) < 0.01
    assert abs(start - pin) < 0.01
    assert abs(end - shaft - radius * (turned.real + math.sqrt(9 - turned.imag**2))) < 0.01
    records = printed("table", "--ratio=1:3", f"--angle={angle}", "--columns=x,c,p", "-f", "csv").records()
    shown = page.locator(".film-value").all_text_contents()
    assert [one.replace("\u2212", "-") for one in shown] == [*records[0].values()]
    assert viewer.complaints == []


def test_it_turns_until_it_is_stopped_at_a_whole_degree(viewer: Viewer, turn: Path) -> None:
    page = viewer.open(turn)
    before = ends(page, "rod-1")
    wait_until(lambda: abs(ends(page, "rod-1")[0] - before[0]) > 1)
    page.get_by_role("button", name="Stop").click()
    page.get_by_role("button", name="Turn").wait_for()
    stopped = page.evaluate(TIMES)
    page.wait_for_timeout(100)
    assert page.evaluate(TIMES) == stopped
    assert len(set(stopped)) == 1


@pytest.mark.slow
def test_page_and_file_stand_still_for_those_who_ask_for_that(
    viewer: Viewer, turn: Path, tmp_path: Path
) -> None:
    viewer.page.emulate_media(reduced_motion="reduce")
    page = viewer.open(turn)
    assert not page.get_by_role("button").is_visible()
    times = page.evaluate(TIMES)
    page.wait_for_timeout(100)
    assert page.evaluate(TIMES) == times
    page.focus(".film-slider")
    page.keyboard.press("End")
    assert page.locator(".film-angle").text_content() == "360°"
    alone = tmp_path / "turn.svg"
    printed("plot", "--animate", "--positions=40", "--ratio=1:3", "-o", str(alone))
    page.goto(alone.as_uri())
    first = page.evaluate(ENDS, "rod-1")
    page.wait_for_timeout(100)
    assert page.evaluate(ENDS, "rod-1") == first
    page.emulate_media(reduced_motion="no-preference")
    wait_until(lambda: page.evaluate(ENDS, "rod-1") != first)


@pytest.mark.slow
def test_everybody_can_read_it(viewer: Viewer, turn: Path) -> None:
    viewer.page.emulate_media(reduced_motion="reduce")
    assert_readable(viewer, turn)
    assert_readable_in_the_dark(viewer, turn)
    viewer.open(turn, DESKTOP, media="print")
    assert not viewer.page.locator(".film-play").is_visible()
    viewer.page.emulate_media(reduced_motion="no-preference")
