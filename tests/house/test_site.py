"""The site of the documentation as its readers have it: links, screens, screen readers, search, and LaTeX."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from filecmp import dircmp
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest
from browser import DESKTOP, TELEPHONE, Viewer
from cli import kurbel
from places import ROOT
from tools import require

# What is loaded with a page; where other links lead needs a click.
LOADED = {"script": "src", "img": "src", "link": "href", "iframe": "src", "source": "src"}


def built(folder: Path) -> Path:
    site = folder / "site"
    done = subprocess.run(
        [sys.executable, str(ROOT / "docs" / "generate" / "website.py"), str(site)],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    return site


def read(site: Path) -> list[Path]:
    """Return the pages; the theme has templates of its own among its scripts."""
    return sorted(path for path in site.rglob("*.html") if "_static" not in path.parts)


@pytest.fixture(scope="module")
def sample(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A site of one page and what it looks like, and of two that are to be found; it takes a second."""
    source = tmp_path_factory.mktemp("a sample")
    for name in ("_static", "_templates"):
        shutil.copytree(ROOT / "docs" / name, source / name)
    shutil.copy(ROOT / "docs" / "conf.py", source)
    page = (ROOT / "docs" / "howto" / "latex.md").read_text(encoding="utf-8")
    (source / "latex.md").write_text(re.sub(r"\]\([^)]*\)", "](index.md)", page), encoding="utf-8")
    (source / "a.md").write_text("# A file\n\n## The longtable\n\nIts longtable.\n", encoding="utf-8")
    (source / "b.md").write_text("# Longtables of many rows\n\nThey break.\n", encoding="utf-8")
    (source / "index.md").write_text("# kurbel\n\n```{toctree}\nlatex\na\nb\n```\n", encoding="utf-8")
    words = ("-W", "-n", "-q", "-b", "html", str(source), str(source / "site"))
    done = subprocess.run(
        [sys.executable, "-m", "sphinx", *words], capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stderr) == (0, "")
    return source / "site"


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The site without the playground, which is built without a warning."""
    return built(tmp_path_factory.mktemp("site"))


class Page(HTMLParser):
    """What a page links to, what is loaded with it, and the places in it."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.links: list[str] = []
        self.loaded: list[str] = []
        self.places: set[str] = set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        self.places.update(filter(None, (given.get("id"), given.get("name"))))
        if address := given.get(LOADED.get(tag, "")):
            self.loaded.append(address)
        if tag == "a" and (address := given.get("href")):
            self.links.append(address)


@pytest.mark.slow
def test_every_link_leads_somewhere_and_nothing_is_loaded_from_elsewhere(site: Path) -> None:
    pages = {path: Page(path) for path in read(site)}
    assert len(pages) > 150
    for path, page in pages.items():
        for address in (*page.links, *page.loaded):
            scheme, host, name, _, place = urlsplit(address)
            if scheme or host:
                assert address in page.links and scheme in ("http", "https"), f"{path} loads {address}"
                continue
            target = (path.parent / unquote(name)).resolve() if name else path
            assert target.is_file(), f"{path.relative_to(site)} links to {address}"
            if place and target in pages:
                assert unquote(place) in pages[target].places, f"{path.relative_to(site)} links to {address}"
    for style in site.rglob("*.css"):
        assert not re.search(r"url\(\s*[\"']?(https?:)?//", style.read_text(encoding="utf-8")), style


@pytest.mark.slow
def test_man_shows_every_manual_page_without_a_warning(site: Path) -> None:
    files = sorted(map(str, (site.parent / "man").glob("man[15]/*.[15]")))
    assert len(files) > 25
    said = subprocess.run([require("mandoc"), "-T", "lint", "-W", "error", *files], capture_output=True)
    assert (said.returncode, said.stdout, said.stderr) == (0, b"", b"")
    settings = os.environ | {"LC_ALL": "C.UTF-8", "MANWIDTH": "80", "MANPAGER": "cat"}
    # A cell of a table may be too narrow for a line as long as the others: that is no fault of the page.
    man = [require("man"), "--no-justification", "--warnings", "-l"]
    for file in files:
        done = subprocess.run([*man, file], capture_output=True, env=settings)
        assert (done.returncode, done.stderr) == (0, b""), file
    # Other pages have no address there.
    assert not any("<>" in Path(file).read_text(encoding="utf-8") for file in files)
    table = (site.parent / "man" / "man1" / "kurbel-table.1").read_text(encoding="utf-8")
    # Copied from a page that is typeset it is still an option, and no word with hyphens.
    assert r"\-\-ratio" in table


@pytest.mark.slow
def test_two_builds_are_the_same_bytes(site: Path, tmp_path: Path) -> None:
    def differing(pair: dircmp[str]) -> Iterator[str]:
        yield from (*pair.left_only, *pair.right_only, *pair.diff_files, *pair.funny_files)
        for inner in pair.subdirs.values():
            yield from differing(inner)

    # Traces of the build for the next one.
    again = dircmp(site, built(tmp_path), ignore=[".buildinfo"])
    assert [*differing(again)] == []


def unreadable(viewer: Viewer, site: Path) -> list[str]:
    """Return what is amiss on a telephone in the light, on a desktop in the dark, and by keyboard."""
    found: list[str] = []
    for path in read(site):
        viewer.open(path, TELEPHONE)
        own = [one for one in viewer.complaints if not one.startswith("log: [PST]")]
        own += [*viewer.page.evaluate(_MISFITS), *viewer.violations()]
        # The page itself sees that readers ask for a dark one.
        viewer.page.emulate_media(color_scheme="dark")
        viewer.page.set_viewport_size({"width": DESKTOP, "height": 800})
        viewer.page.wait_for_selector("html[data-theme=dark]", state="attached")
        # Colours change by degrees.
        viewer.page.evaluate("Promise.all(document.getAnimations().map(one => one.finished))")
        own += [*viewer.page.evaluate(_MISFITS), *viewer.violations("color-contrast")]
        found += [f"{path.relative_to(site)}: {one}" for one in own]
        # What it still loads is given up here, and is no complaint about the next page.
        viewer.page.goto("about:blank")
    return found


def test_a_page_looks_as_all_do_is_found_and_has_lines_to_be_copied(viewer: Viewer, sample: Path) -> None:
    assert unreadable(viewer, sample) == []
    assert any("latex" in link for link in searched(viewer, sample, "caption"))
    tab = viewer.open(sample / "latex.html")
    assert (
        tab.locator(".highlight-console button.copybtn").count()
        == tab.locator(".highlight-console").count()
        > 0
    )


def test_the_page_that_is_called_so_is_found_first(viewer: Viewer, sample: Path) -> None:
    assert searched(viewer, sample, "longtable")[0].partition("?")[0].endswith("b.html")


def test_the_name_keeps_clear_of_the_search_on_a_telephone(viewer: Viewer, sample: Path) -> None:
    tab = viewer.open(sample / "latex.html", TELEPHONE)
    name, button = (
        tab.locator(one).bounding_box() for one in (".navbar-brand", ".search-button-field:visible")
    )
    assert name
    assert button
    assert name["x"] + name["width"] + 16 <= button["x"]


@pytest.mark.slow
def test_everybody_can_read_every_page(viewer: Viewer, site: Path) -> None:
    assert unreadable(viewer, site) == []


# What scrolls sideways must be no more than a part of the page, and reached by the keyboard.
_MISFITS = """() => {
    const root = document.documentElement;
    const wide = root.scrollWidth > root.clientWidth ? [`the page is ${root.scrollWidth} px wide`] : [];
    const scrolls = element => element.clientWidth && element.scrollWidth > element.clientWidth + 1
        && ['auto', 'scroll'].includes(getComputedStyle(element).overflowX);
    return [...document.body.querySelectorAll('*')]
        .filter(element => scrolls(element) && element.tabIndex < 0)
        .map(element => `${element.tagName}.${element.className} scrolls, but not by keyboard`).concat(wide);
}"""


def searched(viewer: Viewer, site: Path, asked: str) -> list[str]:
    """Return what the search finds without a server."""
    tab = viewer.open(site / "search.html")
    tab.locator("input[type=search]:visible").first.fill(asked)
    tab.keyboard.press("Enter")
    # Links come one after the other.
    tab.wait_for_function("document.querySelector('.search-summary')?.textContent.includes('finished')")
    return list(tab.eval_on_selector_all("ul.search li a", "links => links.map(link => link.href)"))


@pytest.mark.slow
@pytest.mark.parametrize(("asked", "page"), [("hammer blow", "locomotive"), ("--time-ratio", "given")])
def test_the_search_finds_a_page(viewer: Viewer, site: Path, asked: str, page: str) -> None:
    assert any(page in link for link in searched(viewer, site, asked))


@pytest.mark.slow
def test_the_search_for_flywheels_finds_their_page_first(viewer: Viewer, site: Path) -> None:
    assert "subjects/flywheels.html" in searched(viewer, site, "flywheel")[0]


@pytest.mark.slow
def test_three_clicks_lead_from_the_first_page_to_a_table_in_a_latex_document(
    viewer: Viewer, site: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    tab = viewer.open(site / "index.html")
    tab.context.grant_permissions(["clipboard-read", "clipboard-write"])
    tab.get_by_role("navigation").get_by_role("link", name="How-to").first.click()
    tab.locator("article").get_by_role("link", name="Tables in LaTeX").click()
    tab.locator(".highlight-console").first.hover()
    tab.locator(".highlight-console button.copybtn").first.click()
    typed = tab.evaluate("navigator.clipboard.readText()")
    document = tab.locator(".highlight-latex pre").first.inner_text()
    monkeypatch.chdir(tmp_path)
    program, *words = re.split(r"\s+", typed.strip())
    assert program == "kurbel"
    assert kurbel(*words).code == 0
    (tmp_path / "paper.tex").write_text(document, encoding="utf-8")
    run = [require("pdflatex"), "-interaction=nonstopmode", "-halt-on-error", "paper.tex"]
    for _ in range(2):
        done = subprocess.run(run, cwd=tmp_path, capture_output=True, check=False)
        assert done.returncode == 0, done.stdout.decode("latin-1")[-2000:]
    text = subprocess.run(
        [require("pdftotext"), "-layout", "paper.pdf", "-"],
        cwd=tmp_path, capture_output=True, text=True, check=True,
    ).stdout  # fmt: skip
    # The path at the dead centre and half a turn later, and what the document says of the table.
    assert "as Table 1 says" in text
    assert re.search(r"^\s*180\s+2\.0000", text, re.MULTILINE)
