"""The handbook as one HTML page: on a screen, on a telephone, in the dark, on paper, and read aloud."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path
from typing import Literal

import manifests
import pytest
from browser import DESKTOP, TELEPHONE, Viewer
from cli import printed

MARGIN, PAPER = 20 / 25.4 * 72, 210 / 25.4 * 72
# How far below the top of a formula its next sign begins, in pixels.
BEHIND = """[...document.querySelectorAll('.prose math, figcaption math')].map(math => {
  const sign = document.createRange()
  sign.setStart(math.nextSibling, 0)
  sign.setEnd(math.nextSibling, 1)
  return sign.getBoundingClientRect().top - math.getBoundingClientRect().top
})"""


def page_of(folder: Path, *chapters: str, **keys: str) -> str:
    """Return the page of a handbook of these chapters."""
    top = manifests.keys_of(**({"title": "Tafeln"} | keys))
    pages = manifests.built(folder, f'{top}formats = ["html"]\n{"".join(chapters)}')
    return (pages / "handbook.html").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def page(sample: Path) -> str:
    return (sample / "handbook.html").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def short(tmp_path_factory: pytest.TempPathFactory) -> str:
    """A page with every kind of item and few rows, over which axe is quick."""
    runs = {"weg": "table --angle 0..180:60", "delta": "delta --eps 2..3", "blau": "example blau 33"}
    runs |= {"kurven": "table --ratio 1:5 -f drawing"}
    parts = [manifests.run(name, run) for name, run in runs.items()]
    chapters = manifests.chapter("Wege, $x$", manifests.text("# Kopf\n\nSiehe [](#delta), $x/R$.\n"), *parts)
    return page_of(tmp_path_factory.mktemp("short"), 'matter = ["symbols", "index"]\n', chapters)


def unfold(viewer: Viewer) -> None:
    """Open the contents: axe does not know that a style sheet can show them."""
    viewer.page.evaluate("document.querySelector('details').open = true")


# On a screen ----------------------------------------------------------------------------------------------


def test_everybody_can_read_the_page_on_a_telephone(viewer: Viewer, short: str) -> None:
    viewer.open(short, TELEPHONE)
    unfold(viewer)
    assert viewer.violations() == []
    assert viewer.misfits() == []
    assert viewer.smallest_font() >= 12
    assert viewer.complaints == []


def test_everybody_can_read_the_page_in_the_dark(viewer: Viewer, short: str) -> None:
    viewer.open(short, DESKTOP, "dark")
    unfold(viewer)
    assert viewer.violations("color-contrast", "scrollable-region-focusable", "landmark-unique") == []
    assert viewer.complaints == []


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_curves_stand_out_from_the_paper(
    viewer: Viewer, short: str, scheme: Literal["light", "dark"]
) -> None:
    """WCAG 2.2, 1.4.11: lines that one must see have at least 3:1; those of the grid need not."""
    opened = viewer.open(short, DESKTOP, scheme)
    names = {*re.findall(r"--(\w+): #", short)} - {"paper", "pale", "rule"}
    colours = [
        opened.evaluate(f"getComputedStyle(document.body).getPropertyValue('--{name}')")
        for name in ("paper", *sorted(names))
    ]
    paper, *lines = map(luminance, colours)
    contrasts = [(max(line, paper) + 0.05) / (min(line, paper) + 0.05) for line in lines]
    assert min(contrasts) >= 3
    assert len(contrasts) == 9


def luminance(colour: str) -> float:
    """Return the relative luminance of #rrggbb as WCAG defines it."""
    shares = [int(colour.strip()[place : place + 2], 16) / 255 for place in (1, 3, 5)]
    linear = [one / 12.92 if one <= 0.04045 else ((one + 0.055) / 1.055) ** 2.4 for one in shares]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def test_nothing_but_tables_scrolls_sideways(viewer: Viewer, page: str) -> None:
    opened = viewer.open(page)
    unfold(viewer)
    for width in (320, 360, 800, 1120, DESKTOP):
        opened.set_viewport_size({"width": width, "height": 800})
        assert viewer.misfits() == [], width


def test_the_page_asks_for_nothing_from_elsewhere(viewer: Viewer, sample: Path, page: str) -> None:
    asked: list[str] = []
    file = sample / "handbook.html"
    viewer.page.on("request", lambda request: asked.append(request.url))
    viewer.open(file)
    assert [url for url in asked if not url.startswith("data:")] == [file.as_uri()]
    assert "<script" not in page
    assert "@import" not in page
    # A link leads to number and caption.
    viewer.page.emulate_media(reduced_motion="reduce")
    viewer.page.locator("nav a[href='#tab-delta']").click()
    number = viewer.page.locator("#tab-delta-number").bounding_box()
    assert number
    assert 0 <= number["y"] < 100
    viewer.page.emulate_media(reduced_motion="no-preference")
    # Else the next page begins at the same place.
    viewer.page.goto("about:blank")


def test_the_policy_of_the_page_lets_no_script_run(viewer: Viewer, short: str) -> None:
    viewer.open(short.replace("</main>", "<script>document.title = 'run'</script></main>"))
    assert viewer.page.title() == "Tafeln"
    assert any("Content Security Policy" in line for line in viewer.complaints)


def test_every_link_has_its_one_target(page: str) -> None:
    """Notes too: the same layout comes twice, in two languages."""
    ids = Counter(re.findall(r'\sid="([^"]*)"', page))
    assert [name for name, count in ids.items() if count > 1] == []
    targets = re.findall(r'href="#([^"]*)"', page) + re.findall(r"url\(#([^)]*)\)", page)
    targets += " ".join(re.findall(r'aria-labelledby="([^"]*)"', page)).split()
    assert len(targets) > 100
    assert set(targets) <= ids.keys()


def test_numbers_name_tables_and_figures(viewer: Viewer, page: str) -> None:
    opened = viewer.open(page)
    assert opened.get_by_role("region", name="Table 3 Piston path").locator("table").count() == 1
    assert opened.get_by_role("region", name="Tabelle 2 Werte für").count() == 2
    assert opened.locator("#tab-path").get_attribute("lang") == "en"
    drawing = opened.get_by_role("img", name="Figure 2: Crank drive for R:L = 1:5")
    assert drawing.evaluate("one => one.closest('[lang]').lang") == "en"
    assert opened.locator("#fig-stellung figcaption").text_content() == "Figure 2 Crank drive for R:L=1:5"
    # Beside the text the contents stand open.
    assert not opened.locator("summary").is_visible()
    links = opened.get_by_role("navigation", name="Inhalt").get_by_role("link").all_inner_texts()
    assert [" ".join(text.split())[:18] for text in links[:4]] == [
        "Formelzeichen",
        "1 Bewegung des Kol",
        "Tabelle 1 Kolbenwe",
        "Tabelle 2 Werte fü",
    ]
    assert len(links) == 5 + len(manifests.TABLES) + len(manifests.FIGURES)


def test_the_keyboard_reaches_all_without_a_script(viewer: Viewer, short: str) -> None:
    opened = viewer.open(short, TELEPHONE)
    focused = "document.activeElement.getAttribute('href')"
    assert not opened.locator("nav a").first.is_visible()
    opened.keyboard.press("Tab")
    assert opened.evaluate(focused) == "#main"
    opened.keyboard.press("Tab")
    opened.keyboard.press("Enter")
    assert opened.locator("nav a").last.is_visible()
    opened.keyboard.press("Tab")
    assert opened.evaluate(focused) == "#sec-symbols"


# In print -------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def paper(viewer: Viewer, page: str, tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("print") / "handbook.pdf"
    viewer.open(page, media="print").pdf(path=file, prefer_css_page_size=True, print_background=True)
    return file


def figures(text: str) -> set[str]:
    """Return the numbers with decimals."""
    return set(re.findall(r"-?\d+[.]\d+", text.replace("−", "-")))


def test_every_figure_of_a_table_is_printed_and_nothing_is_cut_off(sample: Path, paper: Path) -> None:
    """A cell that is cut off is not in the text of the PDF."""
    there = figures(manifests.told("pdftotext", paper).replace(",", "."))
    for name, count in {"weg": 90, "zusammenstellung": 90, "path": 25, "delta": 5, "feinweg": 850}.items():
        wanted = figures((sample / f"tables/{name}.csv").read_text().replace(",", " "))
        assert len(wanted) >= count
        # Its page prints what is exactly zero as 0.
        assert wanted - ({"0.000"} if name == "zusammenstellung" else set()) <= there
    boxes = manifests.told("pdftotext", paper, "-bbox")
    sizes = set(re.findall(r'<page width="([\d.]+)" height="([\d.]+)"', boxes))
    assert {(round(float(width)), round(float(height))) for width, height in sizes} == {(595, 842)}
    assert max(float(right) for right in re.findall(r'xMax="([\d.]+)"', boxes)) < PAPER - MARGIN + 1
    assert min(float(left) for left in re.findall(r'xMin="([\d.]+)"', boxes)) > MARGIN - 1


def test_pages_have_heads_and_numbers_and_chapters_begin_on_new_ones(paper: Path) -> None:
    first, *others = manifests.told("pdftotext", paper, "-layout").rstrip("\f").split("\f")
    assert first.count("Tafeln des Kurbeltriebs") == 1
    for number, one in enumerate(others, 2):
        assert one.lstrip().startswith("Tafeln des Kurbeltriebs")
        assert one.split()[-1] == str(number)
    for heading, head in {
        "1 +Bewegung des Kolbens, .*": "1 Bewegung des Kolbens",
        "2 +Gleichgang": "2 Glei",
    }.items():
        (begin,) = [
            one for one in others if re.search(rf"^ *{heading}\s*$", one.split("\n", 1)[1], re.MULTILINE)
        ]
        # A B behind an escaped sign is not taken for one of its digits.
        assert head in begin.split("\n", 1)[0]
    long = [one for one in others if re.search(r"^ *\d*[1379] +\d,\d{4} +\d,\d{4} ", one, re.MULTILINE)]
    assert len(long) > 1
    assert all("Kolbengeschwindigkeit" in one for one in long)


# From a manifest ------------------------------------------------------------------------------------------

HOSTILE = (
    "</style></title><script>alert(1)</script><img src=x onerror=alert(2)> "
    '"quoted" & javascript:alert(3) {{ 7 * 7 }} {% 0 %} \\0"}; a{} ü𝄞</style>'
)


def test_no_line_begins_with_the_sign_behind_a_formula(viewer: Viewer, tmp_path: Path) -> None:
    words = "Weg $x$, Zeit $t$; Kraft $F$: Druck ($p$), " * 12
    drawing = manifests.run("kurven", "table --ratio 1:5 -f drawing", caption=words.strip())
    opened = viewer.open(page_of(tmp_path, manifests.chapter("Zeichen", manifests.text(words), drawing)))
    for width in range(320, 420, 10):
        opened.set_viewport_size({"width": width, "height": 800})
        drops = opened.evaluate(BEHIND)
        assert len(drops) == 96
        assert max(drops) < 10


def test_what_a_manifest_says_is_text(viewer: Viewer, tmp_path: Path) -> None:
    runs = {"weg": "table --angle 0;90", "kurven": "table --ratio 1:5 -f drawing"}
    parts = [manifests.run(name, run, caption=HOSTILE) for name, run in runs.items()]
    chapter = manifests.chapter(HOSTILE, manifests.text(HOSTILE), *parts)
    page = page_of(tmp_path, chapter, title=HOSTILE, subtitle=HOSTILE, author=HOSTILE)
    opened = viewer.open(page)
    assert viewer.complaints == []
    assert opened.evaluate("document.querySelectorAll('script, img, [onerror]').length") == 0
    assert opened.evaluate("[...document.links].every(one => one.getAttribute('href').startsWith('#'))")
    assert opened.title() == HOSTILE
    for place in ("h1", ".subtitle", ".author", "h2 > :last-child", "nav .chapter > :last-child"):
        assert opened.locator(place).text_content() == HOSTILE
    assert opened.locator("meta[name=author]").get_attribute("content") == HOSTILE
    assert opened.locator("svg title").text_content() == f"Abbildung 1: {HOSTILE}"
    assert (opened.locator("figcaption").text_content() or "").endswith(HOSTILE)
    assert viewer.misfits() == []
    # The running head is a string of CSS: what it makes of it is what the title is.
    (string,) = re.findall(r'@top-left { content: "((?:\\.|[^"\\])*)"', page)
    opened = viewer.open(f'<style>p::before {{ content: "{string}"; }}</style><p></p>')
    found = opened.evaluate("getComputedStyle(document.querySelector('p'), '::before').content")
    assert re.sub(r"\\([\"\\])", r"\1", found[1:-1]) == HOSTILE


def test_marks_of_neighbouring_rows_can_be_told_apart_by_a_finger(viewer: Viewer) -> None:
    viewer.open(printed("example", "weisbach", "150", "-f", "html", "--standalone").out, TELEPHONE)
    assert viewer.page.locator("td sup a").count() > 4
    assert viewer.violations("target-size") == []
