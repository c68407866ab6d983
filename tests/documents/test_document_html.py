"""The handbook as one HTML page: on a screen, on a telephone, in the dark, on paper, and read aloud."""

from __future__ import annotations

import re
import subprocess
from collections import Counter
from functools import cache
from pathlib import Path
from typing import Literal

import handbook
import pytest
from browser import DESKTOP, TELEPHONE, Viewer
from tools import require

import kurbel
from kurbel.documents.document import Chapter, Document, Item
from kurbel.documents.markdown import parse_prose
from kurbel.errors import ChoiceError
from kurbel.formats.documents import document_files
from kurbel.formats.html.document import NAME, css_string
from kurbel.formats.html.svg import COLOURS
from kurbel.formats.render import render

# The names of the tables and figures that the page prints at A4, 170 mm of 210 mm wide, in points.
MARGIN, PAPER = 20 / 25.4 * 72, 210 / 25.4 * 72


@cache
def fragments() -> dict[str, str]:
    drawings = {name: handbook.figure(name, "svg").decode() for name in handbook.FIGURES}
    return handbook.fragments("html") | drawings


def set_page(document: Document) -> str:
    return document_files(document, "html", fragments())[NAME]


@cache
def page() -> str:
    return set_page(handbook.document())


@cache
def small_page() -> str:
    """Return the page without its longest table, over which axe is slow."""
    chapters = tuple(
        chapter._replace(items=tuple(item for item in chapter.items if item.name != "feinweg"))
        for chapter in handbook.document().chapters
    )
    return set_page(handbook.document()._replace(chapters=chapters))


# How far below the top of a formula its next sign begins, in pixels.
BEHIND = """[...document.querySelectorAll('.prose math, figcaption math')].map(math => {
  const sign = document.createRange()
  sign.setStart(math.nextSibling, 0)
  sign.setEnd(math.nextSibling, 1)
  return sign.getBoundingClientRect().top - math.getBoundingClientRect().top
})"""

# On a screen ----------------------------------------------------------------------------------------------


def unfold(viewer: Viewer) -> None:
    """Open the contents: axe does not know that a style sheet can show them."""
    viewer.page.evaluate("document.querySelector('details').open = true")


def test_everybody_can_read_the_page_on_a_telephone(viewer: Viewer) -> None:
    viewer.open(small_page(), TELEPHONE)
    unfold(viewer)
    assert viewer.violations() == []
    assert viewer.misfits() == []
    assert viewer.smallest_font() >= 12
    assert viewer.complaints == []


def test_everybody_can_read_the_page_in_the_dark(viewer: Viewer) -> None:
    viewer.open(small_page(), DESKTOP, "dark")
    unfold(viewer)
    assert viewer.violations("color-contrast", "scrollable-region-focusable", "landmark-unique") == []
    assert viewer.complaints == []


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_curves_stand_out_from_the_paper(viewer: Viewer, scheme: Literal["light", "dark"]) -> None:
    """WCAG 2.2, 1.4.11: lines that one must see have at least 3:1; those of the grid need not."""
    opened = viewer.open(page(), DESKTOP, scheme)
    names = [name for name in COLOURS.values() if name not in ("paper", "pale")]
    paper, *lines = (
        luminance(opened.evaluate(f"getComputedStyle(document.body).getPropertyValue('--{name}')"))
        for name in ("paper", *names)
    )
    contrasts = [(max(line, paper) + 0.05) / (min(line, paper) + 0.05) for line in lines]
    assert min(contrasts) >= 3
    assert len(contrasts) == 7


def luminance(colour: str) -> float:
    """Return the relative luminance of #rrggbb as WCAG defines it."""
    shares = [int(colour.strip()[place : place + 2], 16) / 255 for place in (1, 3, 5)]
    linear = [one / 12.92 if one <= 0.04045 else ((one + 0.055) / 1.055) ** 2.4 for one in shares]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


@pytest.mark.parametrize("width", [320, 360, 800, 1120, DESKTOP])
def test_nothing_but_tables_scrolls_sideways(viewer: Viewer, width: int) -> None:
    viewer.open(page(), width)
    unfold(viewer)
    assert viewer.misfits() == []


def test_the_page_asks_for_nothing_from_elsewhere(viewer: Viewer, tmp_path: Path) -> None:
    asked: list[str] = []
    file = tmp_path / NAME
    file.write_text(page(), encoding="utf-8")
    viewer.page.on("request", lambda request: asked.append(request.url))
    viewer.open(file)
    assert [url for url in asked if not url.startswith("data:")] == [file.as_uri()]
    assert "<script" not in page()
    assert "@import" not in page()


def test_the_policy_of_the_page_lets_no_script_run(viewer: Viewer) -> None:
    assert viewer.complaints == []
    viewer.open(page().replace("</main>", "<script>document.title = 'run'</script></main>"))
    assert viewer.page.title() == "Tafeln des Kurbeltriebs"
    assert any("Content Security Policy" in line for line in viewer.complaints)


def test_every_link_has_its_one_target() -> None:
    ids = Counter(re.findall(r'\sid="([^"]*)"', page()))
    assert [name for name, count in ids.items() if count > 1] == []
    targets = re.findall(r'href="#([^"]*)"', page()) + re.findall(r"url\(#([^)]*)\)", page())
    targets += " ".join(re.findall(r'aria-labelledby="([^"]*)"', page())).split()
    assert len(targets) > 100
    assert set(targets) <= ids.keys()


def test_a_table_in_both_languages_has_notes_of_its_own(viewer: Viewer) -> None:
    """The same layout twice: the names of notes come from the names of tables."""
    found = viewer.open(page()).locator("#tab-weg .notes li, #tab-path .notes li")
    names = [one.get_attribute("id") for one in found.all()]
    assert len(names) == len(set(names))
    assert viewer.page.locator("#tab-path").get_attribute("lang") == "en"


def test_numbers_name_tables_and_figures(viewer: Viewer) -> None:
    opened = viewer.open(page())
    assert opened.get_by_role("region", name="Table 3 Piston path").locator("table").count() == 1
    assert opened.get_by_role("region", name="Tabelle 2 Werte für").count() == 2
    drawing = opened.get_by_role("img", name="Figure 2: The drive at φ = 30°")
    assert drawing.evaluate("one => one.closest('[lang]').lang") == "en"
    assert opened.locator("#fig-stellung figcaption").text_content() == "Figure 2 The drive at φ=30°"


def test_a_link_leads_to_number_and_caption(viewer: Viewer, tmp_path: Path) -> None:
    file = tmp_path / NAME
    file.write_text(page(), encoding="utf-8")
    viewer.page.emulate_media(reduced_motion="reduce")
    viewer.open(file)
    viewer.page.locator("nav a[href='#tab-delta']").click()
    number = viewer.page.locator("#tab-delta-number").bounding_box()
    assert number
    assert 0 <= number["y"] < 100
    viewer.page.emulate_media(reduced_motion="no-preference")
    # Else the next page begins at the same place.
    viewer.page.goto("about:blank")


def test_the_keyboard_reaches_all_without_a_script(viewer: Viewer) -> None:
    opened = viewer.open(page(), 360)
    assert not opened.locator("nav a").first.is_visible()
    opened.keyboard.press("Tab")
    assert opened.evaluate("document.activeElement.getAttribute('href')") == "#main"
    opened.keyboard.press("Tab")
    opened.keyboard.press("Enter")
    assert opened.locator("nav a").last.is_visible()
    opened.keyboard.press("Tab")
    assert opened.evaluate("document.activeElement.getAttribute('href')") == "#sec-bewegung"


def test_the_contents_stand_open_beside_the_text(viewer: Viewer) -> None:
    opened = viewer.open(page())
    assert not opened.locator("summary").is_visible()
    opened.keyboard.press("Tab")
    opened.keyboard.press("Tab")
    assert opened.evaluate("document.activeElement.getAttribute('href')") == "#sec-bewegung"
    links = opened.get_by_role("navigation", name="Inhalt").get_by_role("link").all_inner_texts()
    assert [re.sub(r"\s+", " ", text)[:18] for text in links[:3]] == [
        "1 Bewegung des Kol",
        "Tabelle 1 Kolbenwe",
        "Tabelle 2 Werte fü",
    ]
    chapters = len(handbook.document().chapters)
    assert len(links) == chapters + len(handbook.TABLES) + len(handbook.FIGURES)


# In print -------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def printed(viewer: Viewer, tmp_path_factory: pytest.TempPathFactory) -> Path:
    require("pdftotext")
    file = tmp_path_factory.mktemp("print") / "handbook.pdf"
    viewer.open(page(), media="print").pdf(path=file, prefer_css_page_size=True, print_background=True)
    return file


def text_of(printed: Path, *options: str) -> str:
    command = ["pdftotext", *options, str(printed), "-"]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


@pytest.mark.parametrize("name", handbook.TABLES)
def figures(text: str) -> set[str]:
    """Return the numbers with decimals."""
    return set(re.findall(r"-?\d+[.]\d+", text.replace("−", "-")))


@pytest.mark.parametrize(
    ("name", "count"), [("weg", 90), ("zusammenstellung", 90), ("path", 25), ("delta", 5)]
)
def test_every_figure_of_a_table_is_printed(printed: Path, name: str, count: int) -> None:
    """A cell that is cut off is not in the text of the PDF."""
    wanted = figures(render(handbook.table(name), "csv").replace(",", " "))
    assert len(wanted) >= count
    assert wanted <= figures(text_of(printed).replace(",", "."))


def test_nothing_is_cut_off_at_the_right(printed: Path) -> None:
    boxes = text_of(printed, "-bbox")
    sizes = set(re.findall(r'<page width="([\d.]+)" height="([\d.]+)"', boxes))
    assert {(round(float(width)), round(float(height))) for width, height in sizes} == {(595, 842)}
    rights = [float(right) for right in re.findall(r'xMax="([\d.]+)"', boxes)]
    lefts = [float(left) for left in re.findall(r'xMin="([\d.]+)"', boxes)]
    assert max(rights) < PAPER - MARGIN + 1
    assert min(lefts) > MARGIN - 1


def test_pages_have_heads_and_numbers_and_chapters_begin_on_new_ones(printed: Path) -> None:
    first, *others = text_of(printed, "-layout").rstrip("\f").split("\f")
    assert first.count("Tafeln des Kurbeltriebs") == 1
    # A B behind an escaped sign is not taken for one of its digits.
    assert "1 Bewegung des Kolbens" in others[0].split("\n", 1)[0]
    for number, one in enumerate(others, 2):
        assert one.lstrip().startswith("Tafeln des Kurbeltriebs")
        assert one.split()[-1] == str(number)
    begins = [
        one for one in others if re.search(r"^ *2 +Gleichgang\s*$", one.split("\n", 1)[1], re.MULTILINE)
    ]
    assert len(begins) == 1
    assert "2 Gleichgang" in begins[0].split("\n", 1)[0]


def test_a_table_longer_than_a_page_repeats_its_head(printed: Path) -> None:
    pages = text_of(printed, "-layout").split("\f")
    long = [one for one in pages if re.search(r"^ *\d*[2468] +\d,\d{4} +\d,\d{4} ", one, re.MULTILINE)]
    assert len(long) > 1
    assert all("Kolbengeschwindigkeit" in one for one in long)


# From a manifest ------------------------------------------------------------------------------------------

HOSTILE = (
    "</style></title><script>alert(1)</script><img src=x onerror='alert(2)'> "
    '"quoted" & javascript:alert(3) {{ 7 * 7 }} {% 0 %} \\0'
)


def test_no_line_begins_with_the_sign_behind_a_formula(viewer: Viewer) -> None:
    words = "Weg $x$, Zeit $t$; Kraft $F$: Druck ($p$), " * 12
    drawing = handbook.document().homes()["kurven"][1]
    assert drawing
    items = (Item("text", blocks=parse_prose(words)), drawing._replace(caption=words))
    chapters = (Chapter("Zeichen", "zeichen", 1, items),)
    opened = viewer.open(set_page(handbook.document()._replace(chapters=chapters)))
    for width in range(320, 420, 10):
        opened.set_viewport_size({"width": width, "height": 800})
        drops = opened.evaluate(BEHIND)
        assert len(drops) == 96
        assert max(drops) < 10


def test_what_a_manifest_says_is_text(viewer: Viewer) -> None:
    text = Item("text", blocks=parse_prose(HOSTILE))
    table = handbook.document().homes()["weg"][1]
    drawing = handbook.document().homes()["kurven"][1]
    assert table
    assert drawing
    items = (text, table._replace(caption=HOSTILE), drawing._replace(caption=HOSTILE))
    chapters = (Chapter(HOSTILE, "bewegung", 1, items),)
    base = handbook.document()
    hostile = base._replace(title=HOSTILE, subtitle=HOSTILE, author=HOSTILE, chapters=chapters)
    opened = viewer.open(set_page(hostile))
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


def test_the_running_head_is_a_string(viewer: Viewer) -> None:
    """What CSS makes of the string is what the title is, whatever signs it has."""
    text = HOSTILE + "\"}; a{} 'ü\u2028𝄞\n</style>"
    opened = viewer.open(f'<style>p::before {{ content: "{css_string(text)}"; }}</style><p></p>')
    found = opened.evaluate("getComputedStyle(document.querySelector('p'), '::before').content")
    assert re.sub(r"\\([\"\\])", r"\1", found[1:-1]).replace("\\a ", "\n") == text


def test_marks_of_neighbouring_rows_can_be_told_apart_by_a_finger(viewer: Viewer) -> None:
    page = kurbel.example_table("weisbach", 150)
    viewer.open(render(page, "html", standalone=True), TELEPHONE)
    assert viewer.page.locator("td sup a").count() > 4
    assert viewer.violations("target-size") == []


def test_a_reference_to_nothing_is_named() -> None:
    text = Item("text", blocks=parse_prose("See [](#dleta)."))
    chapters = (*handbook.document().chapters, Chapter("Mehr", "mehr", 4, (text,)))
    with pytest.raises(ChoiceError, match="delta"):
        set_page(handbook.document()._replace(chapters=chapters))
