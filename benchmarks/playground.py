"""The playground from an empty browser to its first table, beside Pyodide alone from there to 1 + 1.

Both are loaded from this machine, in a worker, by Debian's Chromium; nothing is kept between runs. It needs
what `make playground` builds, and so is measured only where it is named: python -m benchmarks playground.
"""

from __future__ import annotations

import functools
import http.server
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from playwright.sync_api import sync_playwright

from benchmarks.race import Race, Row, Taken

BUILT = Path(__file__).parents[1] / "build" / "site" / "playground"
# What somebody writes who has Pyodide alone.
WORKER = """import { loadPyodide } from "./pyodide/pyodide.mjs";
const FOLDER = new URL("pyodide/", import.meta.url).href;
const python = await loadPyodide({ lockFileContents: { info: INFO, packages: {} }, packageBaseUrl: FOLDER });
postMessage(python.runPython("1 + 1"));"""
INFO = '{abi_version: "2026_0", arch: "wasm32", platform: "emscripten_5_0_3", python: "3.14.2"}'
ALONE = """<!doctype html><title>Pyodide</title><p id="status"></p><script>
new Worker("alone.js", { type: "module" }).onmessage = event => {
    document.getElementById("status").textContent = `Done, ${event.data}`;
};</script>"""
ADDED = {
    "alone.html": ("text/html", ALONE),
    "alone.js": ("text/javascript", WORKER.replace("INFO", INFO)),
}


class Quiet(http.server.SimpleHTTPRequestHandler):
    """The playground's folder, and beside it what is ADDED."""

    def log_message(self, *words: object) -> None:
        pass

    def do_GET(self) -> None:
        kind, text = ADDED.get(self.path.lstrip("/"), ("", ""))
        if not text:
            super().do_GET()
            return
        self.send_response(200)
        self.send_header("Content-Type", kind)
        self.end_headers()
        self.wfile.write(text.encode())


@dataclass(frozen=True)
class Page:
    """A page that says when it is done, in a browser that has nothing yet."""

    name: str
    needs: str = "playwright"
    cores: int = 0

    @contextmanager
    def ready(self) -> Iterator[Callable[[], Taken]]:
        made = functools.partial(Quiet, directory=str(BUILT))
        with http.server.ThreadingHTTPServer(("127.0.0.1", 0), made) as server:
            threading.Thread(target=server.serve_forever, daemon=True).start()
            yield functools.partial(_seconds, f"http://127.0.0.1:{server.server_port}/{self.name}")
            server.shutdown()


def _seconds(address: str) -> Taken:
    with sync_playwright() as playwright:
        page = playwright.chromium.launch(
            executable_path="/usr/bin/chromium", args=["--no-sandbox"]
        ).new_page()
        begun = time.perf_counter()
        page.goto(address)
        page.locator("#status", has_text="Done").wait_for(timeout=300_000)
        taken = time.perf_counter() - begun
    return Taken(taken, taken, 0)


def races(quick: bool) -> Iterator[Race]:
    alone = "Pyodide alone, to 1 + 1"
    yield Race(
        {"playground": Page("index.html"), alone: Page("alone.html")},
        [Row("the playground, to its first table", "playground", alone)],
    )
