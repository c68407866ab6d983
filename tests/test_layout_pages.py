"""Golden pages: every layout as text in both languages, read by eye against the books and the formulas."""

from __future__ import annotations

import pytest
from cli import printed
from golden import FOLDER, assert_golden

from kurbel.layouts import LANGUAGES, layout_names

MACHINE = ("--stroke=600mm", "--rod=1500mm", "--speed=120/min")
PAGES = {
    **{
        f"{name}.{lang}": (f"--layout={name}", f"--lang={lang}")
        for name in layout_names()
        for lang in LANGUAGES
    },
    "kinematics-units.de": MACHINE,
    "kinematics-units.en": (*MACHINE, "--lang=en"),
    "kinematics-offset.de": ("--ratio=1:4", "--offset=0,5", "--step=15"),
    "kinematics-offset.en": ("--ratio=1:4", "--offset=0,5", "--step=15", "--lang=en"),
}


@pytest.mark.parametrize("name", PAGES)
def test_page_is_golden(name: str) -> None:
    assert_golden(f"layouts/{name}.txt", printed("table", *PAGES[name]).out)


def test_csv_of_the_default_table_is_golden() -> None:
    assert_golden("layouts/kinematics.csv", printed("table", "--ratio=1:5", "-f", "csv").out)


def test_no_golden_page_is_left_behind() -> None:
    files = {path.name for path in (FOLDER / "layouts").iterdir()}
    assert files == {f"{name}.txt" for name in PAGES} | {"kinematics.csv"}
