"""Golden pages: every layout as text in both languages, read by eye against the books and the formulas."""

from __future__ import annotations

import pytest
from cli import printed
from golden import assert_golden
from pages import COMMANDS, command, default_page
from places import GOLDEN

from kurbel.formats.registry import FORMATS, BytesFormat
from kurbel.formats.render import render
from kurbel.page.layouts import LANGUAGES, layout, layout_names

# Two rows show how a page is laid out, one of them with signs; that its figures are right is tested where
# they are computed. Other options and quantities stand in tests/transcripts/printed.
ROWS = {
    **{
        name: ("--angle=0;150",)
        for name in layout_names()
        if "angle" in layout(name).down + layout(name).across
    },
    **dict.fromkeys(("kolbenwege", "roetscher-112"), ("--angle=0;150", "--ratio=1:5;1:4")),
    **dict.fromkeys(("over-path", "forces-path", "pressures"), ("--shares=0;0.8",)),
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
    **{
        f"{name}.{lang}.txt": (*command(name), *ROWS.get(name, ()), f"--lang={lang}")
        for name in layout_names()
        for lang in LANGUAGES
    },
    **{f"{RICH}{suffix}": (*command(RICH), "-f", form) for suffix, form in SUFFIXES.items()},
}


@pytest.mark.parametrize("name", PAGES)
def test_page_is_golden(name: str) -> None:
    assert_golden(f"layouts/{name}", printed(*PAGES[name]).out)


def test_no_golden_page_is_left_behind() -> None:
    assert {path.name for path in (GOLDEN / "layouts").iterdir()} == {*PAGES, "keys.txt"}


def test_keys_of_records_are_golden() -> None:
    asked = {name: (*command(name), *ROWS.get(name, ()), "-f", "csv") for name in layout_names()}
    heads = {name: printed(*words).out.partition("\n")[0] for name, words in asked.items()}
    assert_golden("layouts/keys.txt", "".join(f"{name}: {head}\n" for name, head in heads.items()))


@pytest.mark.parametrize("about", COMMANDS)
def test_page_from_python_is_that_of_the_command_line(about: str) -> None:
    name = next(name for name in layout_names() if layout(name).subject == about)
    lang = LANGUAGES[len(name) % 2]
    assert printed(*command(name), f"--lang={lang}").out == render(default_page(name, lang), "text")
