"""Plain text on terminals of any width: read by eye, with nothing lost where a page is parted."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from golden import assert_golden
from pages import default_page

import kurbel
from kurbel import collate, example, table
from kurbel.formats.render import render
from kurbel.page.table import Table

# What belongs together stands together: pairs, pauses, groups at the left, captions as wide as tables;
# panels are parted between spanners, units repeated where they have room; what has none becomes a note.
PAGES: dict[str, tuple[Callable[[], Table], int | None]] = {
    "pairs.de": (table, 80),
    "pairs.en": (lambda: table(lang="en"), None),
    "without-pauses": (lambda: table(angle="0;30;60"), None),
    "groups": (lambda: table(ratio="1:4;1:5", angle="0;90"), None),
    "narrow-caption": (lambda: table(columns="phi,x"), None),
    "wide-caption": (lambda: table(columns="phi,x,c,p,psi"), None),
    "panels": (lambda: table(layout="verfahren", angle="30;90"), 80),
    "units-44": (lambda: kurbel.delta("2", layout="delta-detail"), 44),
    "units-36": (lambda: kurbel.delta("2", layout="delta-detail"), 36),
    "units-26": (lambda: kurbel.delta("2", layout="delta-detail"), 26),
    "nowhere": (lambda: table(angle="30;90"), 10),
    "collation-60.de": (lambda: collate("blau-33"), 60),
    "collation-80.en": (lambda: collate("blau-33", lang="en"), 80),
    "collation-120.de": (lambda: collate("blau-33"), 120),
    "collation-panels.en": (lambda: collate("weisbach-150", lang="en"), 60),
    "formulas": (lambda: default_page("formulas"), None),
    "formulas-52": (lambda: default_page("formulas"), 52),
    "example-60": (lambda: example("blau", "33"), 60),
}


@pytest.mark.parametrize("name", PAGES)
def test_page_is_golden(name: str) -> None:
    page, width = PAGES[name]
    assert_golden(f"terminals/{name}.txt", render(page(), "text", width=width))


CODE = re.compile("\x1b\\[[0-9;]*m")


def test_colours_name_verdicts_and_move_nothing() -> None:
    for name in ("blau-33", "roetscher-112"):
        page = collate(name)
        coloured = render(page, "text", width=60, colours=True)
        assert CODE.sub("", coloured) == render(page, "text", width=60)
        ends = [line.count("\x1b[0m") for line in coloured.splitlines()]
        assert [len(CODE.findall(line)) for line in coloured.splitlines()] == [2 * count for count in ends]
    verdicts = render(collate("blau-33"), "text", colours=True)
    assert len(dict(re.findall("\x1b\\[([0-9;]+)m(richtig|letzte|eine)\\b", verdicts))) == 3
    assert "\x1b" not in render(kurbel.solve("p=0"), "text", colours=True)


# By what narrow pages do: spanners of pairs and of three, one level and two, units in a column, wide cells of
# words, formulas, blocks of angles, ratios across, notes for long texts, and units in the heads.
NARROW = {
    "kinematics": 40, "verfahren": 60, "ensslin-forces": 80, "delta-detail": 40, "collation": 60,
    "formulas": 80, "roetscher-112": 40, "kolbenwege": 40, "machine-forces": 60, "rod-points": 120,
}  # fmt: skip


@pytest.mark.parametrize("name", NARROW)
def test_no_line_is_wider_than_the_terminal_and_no_figure_is_lost(name: str) -> None:
    whole = render(default_page(name), "text")
    for width in (NARROW[name], 80):
        narrow = render(default_page(name), "text", width=width)
        assert max(map(len, narrow.splitlines())) <= width
        # The stub repeats in every panel.
        assert set(figures(narrow)) == set(figures(whole))
        assert len(figures(narrow)) >= len(figures(whole))
    assert render(default_page(name), "text", width=200) == whole


def figures(text: str) -> list[str]:
    return sorted(word for word in text.split() if word.removeprefix("−").replace(",", "").isdigit())
