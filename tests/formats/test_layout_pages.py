"""Golden pages: every layout as text in both languages, read by eye against the books and the formulas."""

from __future__ import annotations

from functools import cache

import pytest
from cli import printed
from golden import assert_golden
from pages import command, page_of
from places import GOLDEN

import kurbel
from kurbel.formats.registry import FORMATS, BytesFormat
from kurbel.page.layouts import layout, layout_names
from kurbel.page.table import Table

# Two rows show how a page is laid out, one of them with signs; that its figures are right is tested where
# they are computed. Other options and quantities stand in tests/transcripts/printed.
ROWS = {
    **{
        name: ("--angle=0;150",)
        for name in layout_names()
        if "angle" in layout(name).down + layout(name).across
    },
    **dict.fromkeys(("kolbenwege", "roetscher-112"), ("--angle=0;150", "--ratio=1:5;1:4")),
    **dict.fromkeys(("over-path", "forces-path"), ("--angle=s=0;s=80%",)),
    "pressures": ("--shares=0;0.8",),
    "series-errors": ("--order=1;3",),
    **dict.fromkeys(("delta-tafel", "delta-flywheel"), ("--eps=2;4",)),
    **dict.fromkeys(("delta-verfahren", "weisbach-150"), ("--eps=4",)),
    **dict.fromkeys(("collation", "formulas"), ("--only=deviations",)),
    **dict.fromkeys(("harmonics", "torque-harmonics", "excitation", "balance"), ("--orders=2",)),
    "balance-angle": (),
    "roetscher-gf": ("--angle=0;60",),
}
# A page whose cells are not all alike: angles beside numbers, a note, units and places without a value.
RICH = "delta-detail"
SUFFIXES = {
    entry.suffixes[0]: name
    for name, entry in FORMATS.items()
    if name != "text" and not isinstance(entry, BytesFormat)
}
PAGES = {
    **{f"{name}.en.txt": (*command(name), *ROWS.get(name, ()), "--lang=en") for name in layout_names()},
    **{f"{RICH}{suffix}": (*command(RICH), "-f", form) for suffix, form in SUFFIXES.items()},
}


@pytest.mark.parametrize("name", PAGES)
def test_page_is_golden(name: str) -> None:
    assert_golden(f"layouts/{name}", printed(*PAGES[name]).out)


@cache
def german_page(name: str) -> Table:
    """Return a page from Python, which the command line prints in English."""
    return page_of(name, lang="de", **dict(word[2:].split("=", 1) for word in ROWS.get(name, ())))


@pytest.mark.parametrize("name", layout_names())
def test_page_from_python_is_golden(name: str) -> None:
    assert_golden(f"layouts/{name}.de.txt", kurbel.typeset(german_page(name), "text"))


def test_keys_of_records_are_golden() -> None:
    pages = {name: kurbel.typeset(german_page(name), "csv") for name in layout_names()}
    heads = (f"{name}: {page.splitlines()[0]}\n" for name, page in pages.items())
    assert_golden("layouts/keys.txt", "".join(heads))


def test_no_golden_page_is_left_behind() -> None:
    german = {f"{name}.de.txt" for name in layout_names()}
    assert {path.name for path in (GOLDEN / "layouts").iterdir()} == {*PAGES, *german, "keys.txt"}
