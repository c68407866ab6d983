"""HTML pages in a real browser: what it complains of, who can read them, and what does not fit the screen."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Literal

from places import TESTS
from playwright.sync_api import Browser, ConsoleMessage, Error, Page, sync_playwright
from programs import PATIENCE
from tools import missing, require

AXE = TESTS / "node_modules" / "axe-core" / "axe.min.js"
# The axe rules for WCAG 2.0 to 2.2, levels A and AA, and those of good practice.
RULES = ("wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22a", "wcag22aa", "best-practice")
_FLAGS = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
)
DESKTOP, TELEPHONE = 1280, 360


@contextmanager
def launched() -> Iterator[Viewer]:
    """Start Debian's Chromium; skip the test where it or axe is missing, or fail it where nothing may be."""
    chromium = require("chromium")
    if not AXE.exists():
        missing("axe-core (make tools)")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=_FLAGS)
        yield Viewer(browser)
        browser.close()


class Viewer:
    """A browser with one tab, in which one page after the other is opened."""

    def __init__(self, browser: Browser) -> None:
        self.page: Page = browser.new_page()
        self.page.set_default_timeout(1000 * PATIENCE)
        # No page may need anything from elsewhere.
        self.page.context.set_offline(True)
        self.complaints: list[str] = []
        self.page.on("console", self._console)
        self.page.on("pageerror", self._page_error)
        self.page.on("requestfailed", lambda request: self.complaints.append(f"failed: {request.url}"))

    def _console(self, message: ConsoleMessage) -> None:
        self.complaints.append(f"{message.type}: {message.text}")

    def _page_error(self, error: Error) -> None:
        self.complaints.append(f"error: {error.message}")

    def open(
        self,
        page: str | Path,
        width: int = DESKTOP,
        scheme: Literal["light", "dark"] = "light",
        media: Literal["screen", "print"] = "screen",
    ) -> Page:
        """Open the text of a page or a file, and forget the complaints about those before."""
        # The page before may still have something to say.
        self.page.goto("about:blank")
        self.complaints.clear()
        self.page.set_viewport_size({"width": width, "height": 800})
        self.page.emulate_media(color_scheme=scheme, media=media)
        if isinstance(page, Path):
            self.page.goto(page.absolute().as_uri())
        else:
            self.page.set_content(page)
        self.page.wait_for_function("width => innerWidth === width", arg=width)
        return self.page

    def violations(self, *rules: str) -> list[str]:
        """Return what axe finds in the open page: rule, help and element; by default with all RULES."""
        if not self.page.evaluate("typeof axe === 'object'"):
            self.page.evaluate(AXE.read_text(encoding="utf-8"))
        only = {"type": "rule", "values": rules} if rules else {"type": "tag", "values": RULES}
        # Axe would load style sheets again, which a page from a file may not.
        options = {"runOnly": only, "resultTypes": ["violations", "incomplete"], "preload": False}
        found = self.page.evaluate(_AXE_RUN, options)
        return [f"{rule}: {text}: {target}" for rule, text, target in found]

    def misfits(self) -> list[str]:
        """Return what does not fit the width of the screen, outside regions that scroll sideways.

        A region is a misfit too if it scrolls and the keyboard does not reach it.
        """
        found: list[str] = self.page.evaluate(_MISFITS)
        return found

    def smallest_font(self) -> float:
        """Return the size in pixels of the smallest letters, raised and lowered ones aside."""
        size: float = self.page.evaluate(_SMALLEST_FONT)
        return size

    def lost(self) -> list[str]:
        """Return what one does not see when every `.scroll` region is scrolled to its right end.

        The caption, the names of groups and of rows must be in view then, and the last figure of every row.
        """
        found: list[str] = self.page.evaluate(_LOST)
        return found

    def picture(self, path: Path) -> None:
        """Write the whole page as a PNG, to be looked at."""
        self.page.screenshot(path=path, full_page=True)


# axe-core sees no text in MathML (its bug 3285): a cell or heading with only a formula would count as empty.
_AXE_RUN = """async options => {
    const seen = node => document.querySelector(node.target[0]).querySelector('math')?.textContent.trim();
    return (await axe.run(document, options)).violations.flatMap(rule => rule.nodes
        .filter(node => !(['empty-table-header', 'empty-heading'].includes(rule.id) && seen(node)))
        .map(node => [rule.id, rule.help, node.target.join(' ')]));
}"""
# A position that sticks or hangs does not widen the page; an element cut by its region does not either.
_MISFITS = """() => {
    const root = document.documentElement, width = root.clientWidth, found = [];
    if (root.scrollWidth > width) found.push(`the page is ${root.scrollWidth} px wide, the screen ${width}`);
    for (const element of document.body.querySelectorAll('*')) {
        const style = getComputedStyle(element);
        const scrolls = ['auto', 'scroll'].includes(style.overflowX);
        const name = element.tagName.toLowerCase() + (element.className && '.' + element.className);
        if (scrolls && element.scrollWidth > element.clientWidth && element.tabIndex < 0)
            found.push(`${name} scrolls, but not by keyboard`);
        const box = element.getBoundingClientRect(), inside = element.parentElement.closest('.scroll');
        if (!inside && box.width && (box.right > width + 1 || box.left < -1))
            found.push(`${name} reaches from ${box.left} to ${box.right} px of ${width}`);
    }
    return found;
}"""
_LOST = """() => [...document.querySelectorAll('.scroll')].filter(one => one.offsetHeight).flatMap(region => {
    region.scrollLeft = 1e6;
    const view = region.getBoundingClientRect();
    const is_lost = element => {
        element.scrollIntoView({block: 'center', inline: 'nearest'});
        region.scrollLeft = 1e6;
        const box = element.getBoundingClientRect();
        const top = document.elementFromPoint((box.left + box.right) / 2, (box.top + box.bottom) / 2);
        return box.left < view.left - 1 || box.right > view.right + 1 || !element.contains(top);
    };
    const seen = 'caption > span, .group > th > span, .row, tbody tr > td:last-child';
    return [...region.querySelectorAll(seen)].filter(is_lost).map(lost => `${lost.textContent} is lost`);
})"""
_SMALLEST_FONT = """() => {
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT), sizes = [];
    while (walker.nextNode()) {
        const element = walker.currentNode.parentElement;
        if (walker.currentNode.data.trim() && !element.closest('sup, sub, math'))
            sizes.push(parseFloat(getComputedStyle(element).fontSize));
    }
    return Math.min(...sizes);
}"""


def assert_readable(viewer: Viewer, page: str | Path) -> None:
    """Check that everybody can read a page, on a telephone too, and leave it open there."""
    viewer.open(page, TELEPHONE)
    assert viewer.misfits() == []
    assert viewer.smallest_font() >= 12
    assert viewer.violations() == []
    assert viewer.complaints == []


def assert_readable_in_the_dark(viewer: Viewer, page: str | Path) -> None:
    """Check that a page fits a desktop and keeps its contrasts where readers ask for a dark one."""
    viewer.open(page, DESKTOP, "dark")
    assert viewer.misfits() == []
    assert viewer.violations("color-contrast") == []
    assert viewer.complaints == []
