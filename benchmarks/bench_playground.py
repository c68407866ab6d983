"""Time the playground from an empty browser to its first table, beside Pyodide alone from there to 1 + 1.

make playground; python benchmarks/bench_playground.py build/site/playground

Both are loaded from this machine, in a worker, by Debian's Chromium, in turn; nothing is kept between runs.
"""

from __future__ import annotations

import functools
import http.server
import sys
import threading
import time

from playwright.sync_api import Browser, sync_playwright

RUNS = 5
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


def main() -> int:
    made = functools.partial(Quiet, directory=sys.argv[1])
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), made)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    address = f"http://127.0.0.1:{server.server_port}"
    taken: dict[str, list[float]] = {"alone.html": [], "index.html": []}
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path="/usr/bin/chromium", args=["--no-sandbox"])
        for _ in range(RUNS):
            for page, times in taken.items():
                times.append(seconds(browser, f"{address}/{page}"))
        browser.close()
    # What else runs on a machine only ever adds.
    alone, table = (min(times) for times in taken.values())
    for page, times in taken.items():
        print(f"{page:11} {' '.join(f'{one:6.2f}' for one in times)} s")
    print(f"Pyodide alone {alone:.2f} s, the first table {table:.2f} s: {table / alone:.2f} times as long")
    return 0


def seconds(browser: Browser, address: str) -> float:
    """Return how long a page takes in a browser that has nothing yet until it is done."""
    context = browser.new_context()
    page = context.new_page()
    begun = time.perf_counter()
    page.goto(address)
    page.locator("#status", has_text="Done").wait_for(timeout=300_000)
    taken = time.perf_counter() - begun
    context.close()
    return taken


if __name__ == "__main__":
    sys.exit(main())
