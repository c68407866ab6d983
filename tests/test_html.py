"""HTML pages in a browser."""

from __future__ import annotations

import html
import re
import subprocess
from pathlib import Path

from everything import everything
from tools import require

from kurbel.render import render

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
# A window cannot be as narrow as a telephone, but a frame can.
_MEASURE = """<!DOCTYPE html><body><iframe style="width: {width}px; height: 640px; border: 0" srcdoc="{page}"
onload="const d = this.contentDocument; document.title = [d.documentElement.scrollWidth, d.body.scrollWidth,
  Math.max(...[...d.querySelectorAll('.scroll')].map(e => e.scrollWidth)),
  d.querySelector('caption').textContent.length,
  d.querySelectorAll('td, th').length].join(' ')"></iframe>"""


def measured(page: str, width: int, folder: Path) -> list[int]:
    """Return the widths of page, body and widest table, the length of the caption and the count of cells."""
    chromium = require("chromium")
    frame = folder / "frame.html"
    frame.write_text(_MEASURE.format(width=width, page=html.escape(page)), encoding="utf-8")
    dom = subprocess.run(
        [chromium, *_FLAGS, f"--user-data-dir={folder / 'profile'}", "--dump-dom", frame.as_uri()],
        capture_output=True,
        text=True,
        timeout=60,
        check=True,
    ).stdout
    title = re.search("<title>(.*?)</title>", dom)
    assert title, dom[:500]
    return [int(number) for number in title.group(1).split()]


def test_page_does_not_overflow_a_narrow_screen(tmp_path: Path) -> None:
    document, body, table, caption, cells = measured(
        render(everything(), "html", standalone=True), 360, tmp_path
    )
    assert document <= 360
    assert body <= 360
    assert table > 360
    assert caption == 96
    assert cells == 55
