"""What a reader sees of an HTML page: what belongs together, six columns on a telephone, one face for all."""

from __future__ import annotations

from typing import Literal

import pytest
from browser import TELEPHONE, Viewer
from pages import default_page

import kurbel
from kurbel.formats.render import render


def motion() -> str:
    """Return the page of six columns in three pairs, in two groups of 19 rows."""
    return render(kurbel.table(ratio="1:5;1:4", step=10, to=180), "html", standalone=True)


# What belongs together ------------------------------------------------------------------------------------

# The space between each column and the next, from the widest contents of both, in em.
GAPS = """() => {
    const extent = cell => {
        const range = document.createRange();
        range.selectNodeContents(cell);
        return range.getBoundingClientRect();
    };
    const columns = [], size = parseFloat(getComputedStyle(document.querySelector('td')).fontSize);
    for (const row of document.querySelectorAll('thead tr:last-child, tr:not(.group):has(td)')) {
        const cells = [...row.children];
        cells.slice(-6).forEach((cell, place) => (columns[place] ||= []).push(extent(cell)));
    }
    const side = (boxes, name, most) => most(...boxes.map(box => box[name]));
    return columns.slice(1).map((boxes, place) =>
        (side(boxes, 'left', Math.min) - side(columns[place], 'right', Math.max)) / size);
}"""


def test_a_pair_stands_closer_than_its_neighbours(viewer: Viewer) -> None:
    within, between, second, further, third = viewer.open(motion()).evaluate(GAPS)
    # The spanners of the second and the third pair are wider than what is below them.
    assert [within, second, third] == pytest.approx([1.3] * 3, abs=2 / 16)
    assert min(between, further) >= 2.6 - 0.15


SHADOWS = """document.querySelector('.scroll').scrollLeft = %d;
new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(
    [...document.querySelectorAll('.row')].filter(one => one.offsetHeight)
        .map(one => getComputedStyle(one).boxShadow.replace(/^rgba\\(0, 0, 0, 0\\).*/, 'none'))))))"""


def test_a_rule_beside_the_stub_is_seen_only_where_figures_are_behind_it(viewer: Viewer) -> None:
    page = viewer.open(render(default_page("forces"), "html", standalone=True), 700)
    assert set(page.evaluate(SHADOWS % 0)) == {"none"}
    left = page.locator("thead .corner").first.bounding_box()
    shadows = set(page.evaluate(SHADOWS % 60))
    assert len(shadows) == 1
    assert "none" not in shadows
    assert page.locator("thead .corner").first.bounding_box() == left
    viewer.open(motion())
    assert set(page.evaluate(SHADOWS % 60)) == {"none"}


def test_a_small_pause_parts_rows_that_stand_in_line(viewer: Viewer) -> None:
    rows = "[...document.querySelector('tbody').querySelectorAll('.row')].map(one => one.offsetHeight)"
    _first, *heights = viewer.open(motion()).evaluate(rows)
    usual, paused = heights[0], heights[2]
    assert paused - usual == pytest.approx(0.4 * 16, abs=1.1)
    assert heights[:-1] == [usual, usual, paused] * 5 + [usual, usual]
    assert viewer.page.locator("tr:not(:has(td, th))").count() == 0


# On a telephone -------------------------------------------------------------------------------------------

# Figures that are not wholly in view when the table has been scrolled to its end, and whether the head is.
END = """() => {
    const region = document.querySelector('.scroll'), box = one => one.getBoundingClientRect();
    region.scrollIntoView(); region.scrollTop = 1e6;
    const head = document.querySelector('thead tr:last-child th:last-child');
    const place = box(head), view = box(region);
    const seen = document.elementFromPoint((place.left + place.right) / 2, (place.top + place.bottom) / 2);
    const cut = [...document.querySelectorAll('td')].filter(cell => {
        const range = document.createRange(); range.selectNodeContents(cell);
        return box(range).left < view.left || box(range).right > view.right + 0.5;
    });
    const last = box(document.querySelector('tbody:last-of-type tr:last-child td'));
    return {cut: cut.length, scrolled: region.scrollTop, head: head.contains(seen),
        last: last.bottom <= view.bottom + 1 && last.bottom <= innerHeight && last.top > place.bottom};
}"""


def test_six_columns_and_their_head_are_seen_together(viewer: Viewer) -> None:
    found = viewer.open(motion(), TELEPHONE).evaluate(END)
    assert viewer.page.locator("tbody:first-of-type tr:nth-child(2) td:visible").count() == 6
    assert found.pop("scrolled") > 100
    assert found == {"cut": 0, "head": True, "last": True}
    assert viewer.smallest_font() >= 12


PANELS = """() => [...document.querySelectorAll('.scroll')].map(region => ({
    seen: region.offsetHeight > 0, cut: region.scrollWidth > region.clientWidth + 1,
    rows: [...region.querySelectorAll('tbody tr')].map(row => [...row.children].map(one => one.textContent)),
}))"""


def test_a_wide_table_goes_on_in_panels_with_the_same_figures(viewer: Viewer) -> None:
    viewer.open(render(default_page("forces"), "html", standalone=True), TELEPHONE)
    whole, *panels = viewer.page.evaluate(PANELS)
    assert len(panels) > 1
    assert [panel["seen"] and not panel["cut"] for panel in panels] == [True] * len(panels)
    assert not whole["seen"]
    joined = [
        [row[0][0], *(cell for one in row for cell in one[1:])]
        for row in zip(*[one["rows"] for one in panels], strict=True)
    ]
    assert joined == whole["rows"]
    assert viewer.page.get_by_role("table").count() == len(panels)
    ids = viewer.page.evaluate("[...document.querySelectorAll('[id]')].map(one => one.id)")
    named = viewer.page.evaluate(
        "[...document.querySelectorAll('td')].flatMap(one => one.headers.split(' '))"
    )
    assert len(ids) == len(set(ids))
    assert set(named) <= set(ids)
    assert render(default_page("forces"), "html").count("<table") == 1
    viewer.page.set_viewport_size({"width": 1280, "height": 800})
    assert [one["seen"] for one in viewer.page.evaluate(PANELS)] == [True] + [False] * len(panels)


def test_tab_goes_from_the_table_to_each_of_its_groups(viewer: Viewer) -> None:
    page = viewer.open(motion(), TELEPHONE)
    stops = []
    for _ in range(3):
        page.keyboard.press("Tab")
        stops.append(page.evaluate("document.activeElement.textContent.trim().slice(0, 9)"))
    assert stops[1:] == ["R:L=1:5", "R:L=1:4"]
    label, head = page.locator(":focus").bounding_box(), page.locator("thead").bounding_box()
    assert label
    assert head
    assert head["y"] + head["height"] <= label["y"] + 1 < 800


# The heights of all headings that are in view, in lines.
LINES = """[...document.querySelectorAll('.alike')].filter(one => one.offsetHeight).map(one =>
    Math.round(one.offsetHeight / parseFloat(getComputedStyle(one).lineHeight)))"""


@pytest.mark.parametrize("width", [TELEPHONE, 640])
def test_heads_of_one_row_break_alike(viewer: Viewer, width: int) -> None:
    wide = render(default_page("forces"), "html", standalone=True)
    for page in (motion(), wide):
        lines = viewer.open(page, width).evaluate(LINES)
        assert len(lines) >= 6
        assert len(set(lines)) == 1
        assert viewer.misfits() == []
    # Panels of two pairs have room for whole words there.
    assert (lines[0] == 2) == (width < 500)


# Words that break -----------------------------------------------------------------------------------------


# Where each piece of text stands.
TOPS = """one => [...one.childNodes].filter(node => node.data?.trim()).map(node => {
    const range = document.createRange();
    range.selectNode(node);
    return range.getBoundingClientRect().top;
})"""


def test_a_broken_word_is_whole_when_copied(viewer: Viewer) -> None:
    page = viewer.open(motion(), TELEPHONE)
    spanner = page.locator(".spanner", has_text="Kolbengeschwindigkeit")
    first, second = spanner.evaluate(TOPS)[:2]
    assert first + 10 < second
    copied = "one => { getSelection().selectAllChildren(one); return getSelection().toString(); }"
    assert "Kolbengeschwindigkeit" in spanner.evaluate(copied)
    assert "Kolbengeschwindigkeit" in spanner.inner_text()


# Faces ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("scheme", "media"), [("light", "screen"), ("dark", "screen"), ("light", "print")])
def test_formulas_have_the_face_and_the_colour_of_the_text(
    viewer: Viewer, scheme: Literal["light", "dark"], media: Literal["screen", "print"]
) -> None:
    page = viewer.open(motion(), scheme=scheme, media=media)
    session = page.context.new_cdp_session(page)
    session.send("DOM.enable")
    session.send("CSS.enable")
    root = session.send("DOM.getDocument")["root"]["nodeId"]

    def faces(selector: str) -> set[str]:
        found = session.send("DOM.querySelectorAll", {"nodeId": root, "selector": selector})["nodeIds"]
        fonts = [
            session.send("CSS.getPlatformFontsForNode", {"nodeId": node})["fonts"] for node in found[:12]
        ]
        return {font["familyName"] for one in fonts for font in one}

    used = {name: faces(selector) for name, selector in FORMULAS.items()}
    expected = dict.fromkeys(FORMULAS, faces("td"))
    session.detach()
    assert used == expected
    assert len(used["letters"]) == 1
    colours = (
        "['.notes li', '.notes math', 'td'].map(one => getComputedStyle(document.querySelector(one)).color)"
    )
    assert len(set(page.evaluate(colours))) == 1


FORMULAS = {
    "letters": ".notes mi",
    "figures": ".notes mn",
    "signs": ".notes mo:not([stretchy])",
    "text": ".notes li",
}


def test_no_formula_is_broken_or_cut(viewer: Viewer) -> None:
    page = viewer.open(motion(), TELEPHONE)
    shapes = page.evaluate(
        "[...document.querySelectorAll('.notes math')].map(one => [one.getClientRects().length,"
        " one.getBoundingClientRect().right])"
    )
    assert len(shapes) >= 5
    assert all(pieces == 1 and right <= TELEPHONE for pieces, right in shapes)


# The judge ------------------------------------------------------------------------------------------------

FAULTY = """<!DOCTYPE html><html><head><title>Faulty</title><style>
.scroll { overflow-x: auto; width: 200px } .scroll div { width: 900px }
</style></head><body><main><h1 style="color: #bbb; background: #fff">Pale</h1>
<p style="font-size: 9px">Small</p><img src="data:image/gif;base64,R0lGODlhAQABAAAAACw=">
<p style="width: 2000px">Wide</p><div class="scroll"><div>
<table><caption><span>Far</span></caption><tr><td>1</td><td>2</td></tr></table></div></div>
<script>console.error("told"); undefined.thrown</script></main></body></html>"""


def test_a_page_with_faults_is_found_faulty_in_each_respect(viewer: Viewer) -> None:
    viewer.open(FAULTY, TELEPHONE)
    wide, *misfits = viewer.misfits()
    assert wide.endswith("px wide, the screen 360")
    assert [one.partition(" reaches")[0] for one in misfits] == [
        "p",
        "div.scroll scrolls, but not by keyboard",
    ]
    found = {one.partition(":")[0] for one in viewer.violations()}
    assert {"html-has-lang", "color-contrast", "image-alt"} <= found
    assert {one.partition(":")[0] for one in viewer.violations("color-contrast")} == {"color-contrast"}
    assert viewer.smallest_font() == 9
    assert viewer.lost() == ["Far is lost", "2 is lost"]
    assert [one.partition(":")[0] for one in viewer.complaints] == ["error", "error"]
    viewer.open(FAULTY.replace("<html>", '<html lang="en">'), TELEPHONE)
    assert "html-has-lang" not in {one.partition(":")[0] for one in viewer.violations()}
