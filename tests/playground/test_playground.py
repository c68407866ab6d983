"""The playground in a browser: the bytes of the machine, everybody's keys and screens, and no network."""

from __future__ import annotations

import functools
import http.server
import json
import os
import shlex
import shutil
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from hashlib import sha256
from pathlib import Path
from typing import Any

import pytest
from browser import DESKTOP, TELEPHONE, Viewer
from cli import kurbel, printed
from places import ROOT
from playwright.sync_api import Dialog, Page, expect
from programs import PATIENCE
from tools import missing, require
from typeset import words_of_pdf

BUILD = ROOT / "docs" / "playground" / "build.py"
FORMATS = ("csv", "text", "html", "latex", "typst")
FIRST = "kurbel table --ratio 1:5 --lang en"


class Server:
    """A server on this machine that notes what it was asked for."""

    def __init__(self, folder: Path, answer: Callable[[str], str] = str) -> None:
        self.asked: list[str] = []
        asked = self.asked

        class Handler(http.server.SimpleHTTPRequestHandler):
            def log_message(self, *words: Any) -> None:
                asked.append(self.path)

            def do_POST(self) -> None:
                question = self.rfile.read(int(self.headers["Content-Length"])).decode()
                self.send_response(200)
                self.end_headers()
                self.wfile.write(answer(question).encode())

            def end_headers(self) -> None:
                # Who is let in from everywhere shows that it was the page that did not ask.
                self.send_header("Access-Control-Allow-Origin", "*")
                super().end_headers()

        made = functools.partial(Handler, directory=str(folder))
        self._server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), made)
        self.address = f"http://127.0.0.1:{self._server.server_port}"
        self._thread = threading.Thread(target=self._server.serve_forever)
        self._thread.start()

    def __enter__(self) -> Server:
        return self

    def __exit__(self, *error: object) -> None:
        self._server.shutdown()
        self._server.server_close()
        self._thread.join()


# In place of Python in the browser: the same side in Python, on this machine.
STAND_IN = """const answered = async words => (await fetch(new URL("ask", import.meta.url),
    { method: "POST", body: JSON.stringify(words) })).json();
onmessage = async ({ data: { number, action, words } }) => {
    const nothing = { written: [], gone: [], files: [] };
    const answer = action === "put" ? nothing : await answered([action, ...words]);
    if (action === "run") answer.out = new TextEncoder().encode(answer.out);
    postMessage({ kind: "answer", number, answer });
};
postMessage({ kind: "ready" });
"""
ANSWERS = """import json, sys
import console
for line in sys.stdin:
    action, *words = json.loads(line)
    answer = getattr(console, action)(*words)
    if action == "run":
        code, out, err, later = answer
        answer = {"code": code, "out": out.decode(), "err": err, "later": later,
                  "written": [], "gone": [], "files": []}
    print(json.dumps(answer), flush=True)
"""


def test_a_line_is_typed_completed_and_answered(viewer: Viewer, tmp_path: Path) -> None:
    folder = shutil.copytree(BUILD.with_name("page"), tmp_path / "docs" / "playground")
    (folder / "worker.js").write_text(STAND_IN, encoding="utf-8")
    (folder / "service.js").write_text("", encoding="utf-8")
    python = subprocess.Popen(
        [sys.executable, "-c", ANSWERS], cwd=tmp_path, env=os.environ | {"PYTHONPATH": str(BUILD.parent)},
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
    )  # fmt: skip

    def answer(question: str) -> str:
        assert python.stdin and python.stdout
        print(question, file=python.stdin, flush=True)
        return python.stdout.readline()

    viewer.page.context.set_offline(False)
    with Server(tmp_path, answer) as server:
        opened(viewer, server)
        assert printed(*shlex.split(FIRST)[1:]).out == viewer.page.text_content("#screen")
        viewer.page.fill("#line", "kurbel delt")
        viewer.page.press("#line", "Tab")
        expect(viewer.page.locator("#line")).to_have_value("kurbel delta ")
        assert "--eps needs a value" in typed(viewer.page, "kurbel delta --eps", "Failed, exit code 2")
        assert viewer.violations() == viewer.misfits() == viewer.complaints == []
        viewer.page.goto("about:blank")
    viewer.page.context.set_offline(True)
    python.communicate()


# A build of a handbook, and what is left of it when a file is deleted.
BUILDER = """let files = ["book/.kurbel/state.json", "book/pages/handbook.html"];
onmessage = ({ data: { number, action, words } }) => {
    const isBuilt = action === "run" && words[0].includes("build"), nothing = new Uint8Array();
    const gone = action === "remove" ? words : [];
    files = files.filter(path => !gone.includes(path));
    const written = isBuilt ? files.map(path => [path, nothing]) : [];
    const listed = isBuilt || gone.length ? files : [];
    postMessage({ kind: "answer", number,
        answer: { code: 0, out: nothing, err: "", written, gone, files: listed } });
};
postMessage({ kind: "ready" });
"""
LEAVING = """() => {
    const event = new Event("beforeunload", { cancelable: true });
    dispatchEvent(event);
    return event.defaultPrevented;
}"""


def test_nothing_is_lost_unasked_and_what_a_build_keeps_for_itself_is_not_shown(
    viewer: Viewer, tmp_path: Path
) -> None:
    folder = shutil.copytree(BUILD.with_name("page"), tmp_path / "docs" / "playground")
    (folder / "worker.js").write_text(BUILDER, encoding="utf-8")
    (folder / "service.js").write_text("", encoding="utf-8")
    viewer.page.context.set_offline(False)
    with Server(tmp_path) as server:
        opened(viewer, server)
        tab = viewer.page
        asked: list[str] = []

        def refused(dialog: Dialog) -> None:
            asked.append(dialog.message)
            dialog.dismiss()

        assert tab.evaluate(LEAVING) is False
        typed(tab, "kurbel handbook build book")
        assert tab.locator("#own li > span").all_text_contents() == ["book/pages/handbook.html"]
        assert tab.text_content("#viewed") == "book/pages/handbook.html"
        assert tab.evaluate(LEAVING) is True
        # Who says no keeps the file.
        tab.once("dialog", refused)
        tab.get_by_role("button", name="Delete book").click()
        expect(tab.locator("#own li")).to_have_count(1)
        assert asked == ["book/pages/handbook.html was not downloaded. Delete it?"]
        with tab.expect_download():
            tab.get_by_role("button", name="Download book").click()
        assert tab.evaluate(LEAVING) is False
        # What was downloaded may go.
        tab.get_by_role("button", name="Delete book").click()
        expect(tab.locator("#own li")).to_have_count(0)
        assert len(asked) == 1
        tab.goto("about:blank")
    viewer.page.context.set_offline(True)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder in which the site's folder has a playground."""
    require("npm")
    require("node")
    if not (ROOT / "build" / "playground" / "locked").exists():
        missing("Pyodide (make tools)")
    top = tmp_path_factory.mktemp("site")
    subprocess.run([sys.executable, str(BUILD), str(top / "docs" / "playground")], check=True)
    return top


@pytest.fixture(scope="module")
def server(folder: Path) -> Iterator[Server]:
    with Server(folder) as server:
        yield server


@pytest.fixture
def page(viewer: Viewer, server: Server) -> Iterator[Page]:
    """The playground, as it is opened, with its first table."""
    viewer.page.context.set_offline(False)
    opened(viewer, server)
    yield viewer.page
    viewer.page.goto("about:blank")
    viewer.page.context.set_offline(True)


def opened(viewer: Viewer, server: Server, link: str = "") -> None:
    viewer.complaints.clear()
    viewer.page.set_viewport_size({"width": DESKTOP, "height": 800})
    viewer.page.emulate_media(color_scheme="light", media="screen")
    viewer.page.goto("about:blank")
    viewer.page.goto(f"{server.address}/docs/playground/{link}")
    ended(viewer.page, "Ready" if link else "Done")


def ended(page: Page, word: str = "Done") -> None:
    expect(page.locator("#status")).to_contain_text(word, timeout=1000 * PATIENCE)


def typed(page: Page, line: str, word: str = "Done") -> str:
    """Type a command, and return what stands on the screen when it has ended so."""
    page.fill("#line", line)
    page.press("#line", "Enter")
    expect(page.locator("#run")).to_be_enabled(timeout=1000 * PATIENCE)
    ended(page, word)
    return page.text_content("#screen") or ""


def written(page: Page, lines: list[str]) -> list[str]:
    """Return the SHA-256 of what each command would hand to a pipe, run one after another in a worker."""
    return list(page.evaluate(_WRITTEN, lines))


_WRITTEN = """async lines => {
    const { Kurbel } = await import(new URL("kurbel.js", location.href));
    const kurbel = new Kurbel(() => {}), sums = [];
    await kurbel.ready;
    for (const line of lines) {
        const { code, err, written } = await kurbel.ask("run", `${line} > made`, 80);
        const sum = await crypto.subtle.digest("SHA-256", written.find(([path]) => path === "made")[1]);
        const digits = [...new Uint8Array(sum)].map(byte => byte.toString(16).padStart(2, "0")).join("");
        sums.push(`${code} ${err} ${digits}`);
    }
    return sums;
}"""


@pytest.mark.slow
def test_every_layout_has_the_same_bytes_as_on_the_machine(page: Page) -> None:
    layouts = json.loads(printed("layouts", "-f", "json").out)["rows"]
    lines = [f"{one['command']} -f {form}" for one in layouts for form in FORMATS]
    assert len(lines) >= 5 * 61
    there = dict(zip(lines, written(page, lines), strict=True))
    here = {line: kurbel(*shlex.split(line)[1:]) for line in lines}
    assert [line for line in lines if there[line] != _told(here[line])] == []


def _told(result: Any) -> str:
    return f"{result.code} {result.err} {sha256(result.out.encode()).hexdigest()}"


@pytest.mark.slow
def test_a_pdf_says_there_what_it_says_here(page: Page, tmp_path: Path) -> None:
    for line in (FIRST, "kurbel delta --layout delta-tafel"):
        typed(page, f"{line} -o there.pdf")
        with page.expect_download() as download:
            page.click("button[aria-label='Download there.pdf']")
        printed(*shlex.split(line)[1:], "-o", str(tmp_path / "here.pdf"))
        assert words_of_pdf(Path(download.value.path())) == words_of_pdf(tmp_path / "here.pdf")


@pytest.mark.slow
def test_everybody_can_read_the_page(viewer: Viewer, page: Page) -> None:
    typed(page, "kurbel collate roetscher-112 --lang en")
    typed(page, f"{FIRST} --standalone -o table.html")
    assert page.frame_locator("#shown iframe").locator("td", has_text="1.1010").count() == 1
    for details in page.locator("details").all():
        details.evaluate("one => one.open = true")
    for width, scheme in ((DESKTOP, "light"), (DESKTOP, "dark"), (TELEPHONE, "light")):
        page.set_viewport_size({"width": width, "height": 800})
        page.emulate_media(color_scheme=scheme)  # type: ignore[arg-type]
        assert viewer.violations() == []
        assert viewer.misfits() == []
        assert viewer.smallest_font() >= 12
    assert viewer.complaints == []


@pytest.mark.slow
def test_the_keyboard_alone_does_all(page: Page) -> None:
    keys = page.keyboard
    page.locator("#line").focus()
    keys.press("Control+A")
    keys.type("kurbel delt")
    keys.press("Tab")
    expect(page.locator("#line")).to_have_value("kurbel delta ")
    keys.type("--eps")
    keys.press("Enter")
    ended(page, "Failed, exit code 2")
    assert "--eps needs a value" in (page.text_content("#screen") or "")
    keys.press("ArrowUp")
    keys.press("ArrowUp")
    expect(page.locator("#line")).to_have_value(FIRST)
    keys.press("Escape")
    keys.press("Tab")
    expect(page.locator("#run")).to_be_focused()
    keys.press("Enter")
    ended(page)
    assert "1.1010" in (page.text_content("#screen") or "")


@pytest.mark.slow
def test_a_link_fills_in_its_command_and_runs_nothing(viewer: Viewer, page: Page, server: Server) -> None:
    opened(viewer, server, "#kurbel%20table%20--ratio%201:4")
    assert page.input_value("#line") == "kurbel table --ratio 1:4"
    assert page.text_content("#screen") == ""
    page.click("#run")
    ended(page)
    assert "R:L = 1:4" in (page.text_content("#screen") or "")


@pytest.mark.slow
def test_files_go_in_and_out_and_outlive_a_stop(page: Page) -> None:
    machine = b'[crank]\nratio = "1:3"\nstroke = "400mm"\n'
    page.set_input_files("#upload", {"name": "own.toml", "mimeType": "text/plain", "buffer": machine})
    ended(page, "own.toml: opened")
    line = "kurbel table --machine own.toml --lang en"
    assert "R:L = 1:3" in typed(page, line)
    page.fill("#line", "kurbel table --ratio 1:5 --step 0.001 --digits 50 -f csv -o long.csv")
    page.press("#line", "Enter")
    expect(page.locator("#status")).to_have_text("Running …", timeout=1000 * PATIENCE)
    page.click("#stop")
    ended(page, "Stopped")
    assert "R:L = 1:3" in typed(page, line)
    page.click("button[aria-label='Delete own.toml']")
    expect(page.locator("#own li")).to_have_count(0)
    assert "own.toml" in typed(page, line, "Failed, exit code")


@pytest.mark.slow
def test_what_needs_other_libraries_says_so(page: Page) -> None:
    assert "as sweeps, drawings and indicator cards do" in typed(
        page, "kurbel table --ratio 1:5 -o motion.svg", "Failed, exit code 1"
    )
    # Interactive pages draw what moves without them.
    typed(page, "kurbel turning --eps 2..4 --interactive -o turning.html")


@pytest.mark.slow
def test_it_opens_without_a_network_and_connects_to_nothing_else(
    viewer: Viewer, folder: Path, tmp_path: Path
) -> None:
    context = viewer.page.context
    context.set_offline(False)
    requests: list[str] = []
    context.on("request", lambda request: requests.append(request.url))
    with Server(folder) as server, Server(tmp_path) as other:
        opened(viewer, server)
        assert viewer.page.evaluate(_CONNECTS, other.address) == ["refused", "refused"]
        assert other.asked == []
        viewer.page.evaluate("navigator.serviceWorker.ready.then(() => true)")
    # The server is gone.
    context.set_offline(True)
    opened(viewer, server)
    assert "1.1010" in (viewer.page.text_content("#screen") or "")
    # What is loaded for the first PDF was never asked for.
    said = typed(viewer.page, "kurbel table -o table.pdf", "This did not work")
    assert "typst.tar.gz is loaded when it is first needed, and cannot be now: no network" in said
    mine = (server.address, "blob:", "data:", "about:", other.address)
    assert [url for url in requests if not url.startswith(mine)] == []


# From the page, and from a worker that begins as that of the page.
_CONNECTS = """async address => {
    const asked = `fetch("${address}").then(() => "answered", () => "refused")`;
    const source = new Blob([`${asked}.then(postMessage)`], { type: "text/javascript" });
    const worker = new Worker(URL.createObjectURL(source), { type: "module" });
    const said = new Promise(resolve => { worker.onmessage = event => resolve(event.data); });
    return [await fetch(address).then(() => "answered", () => "refused"), await said];
}"""
