"""Names for cross references: two pages of one layout in one document have two."""

from __future__ import annotations

import re

import pytest
from cli import printed

import kurbel


def label(*words: str) -> str:
    found = re.search(r"\\label\{tab:(.*?)\}", printed(*words, "--format=latex").out)
    assert found
    return found[1]


def test_page_with_its_defaults_has_the_name_of_the_layout_in_every_language() -> None:
    assert label("table") == label("table", "--lang=en") == kurbel.table().anchor == "kinematics"
    assert label("table", "--ratio=1:4", "--label=mine") == "mine"


@pytest.mark.parametrize(
    ("words", "page"),
    [
        (("table", "--ratio=1:4"), kurbel.table(ratio="1:4")),
        (("table", "--ratio", "1:4", "--ratio", "1:5"), kurbel.table(ratio=["1:4", "1:5"])),
        (("table", "--method=series", "--digits=5"), kurbel.table(digits=5, method="series")),
        (("delta", "--eps=4.5"), kurbel.delta_table("4.5")),
        (("turning", "--torque=5 + sin(φ)"), kurbel.turning_table(torque="5 + sin(φ)")),
        (("collate", "blau-33"), kurbel.collation_table("blau-33")),
    ],
)
def test_the_command_line_and_python_give_one_page_one_name(
    words: tuple[str, ...], page: kurbel.Table
) -> None:
    assert label(*words) == page.anchor
    assert re.fullmatch(r"[A-Za-z0-9.-]{1,80}", page.anchor)


def test_other_values_give_other_names() -> None:
    pages = (
        *(kurbel.table(ratio=ratio, angle=60) for ratio in ("1:4", "1:4.5", ["1:4", "1:5"], "1:45")),
        *(kurbel.table(ratio="1:4", angle=60, offset=offset) for offset in ("0.1", "-0.1")),
        *(kurbel.delta_table(eps=eps) for eps in ("4;5", "4.5")),
        *(kurbel.turning_table(torque=f"5 {sign} sin(φ)") for sign in "+-"),
    )
    assert len({page.anchor for page in pages}) == len(pages)
    assert kurbel.table(ratio="1:4").anchor == "kinematics-ratio-1-4"
    # What programs read of a table stays as it is.
    assert '"table": "kinematics"' in kurbel.table(ratio="1:4").typeset("json")
