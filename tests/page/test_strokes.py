"""Outstroke and return stand side by side up to 180°; beyond, a page is of whole turns."""

from __future__ import annotations

import json
from collections.abc import Iterator
from math import radians
from pathlib import Path

import pytest
from cli import printed, refusal

import kurbel
from kurbel.page.table import Table

PAGES = (
    "table --ratio 1:5",
    "table --ratio 1:5 --offset 0.3",
    "table --layout kolbenwege",
    "table --layout blau-fd",
    "table --mechanism arc --ratio 1:5 --rocker 6",
    "table --mechanism beam --ratio 1:5 --beam 3",
    "forces --ratio 1:5",
    "forces --ratio 1:5 --force 10kN --stroke 600mm",
    "forces --mechanism arc --ratio 1:5 --rocker 6",
    "forces --mechanism beam --ratio 1:5 --beam 3",
)
each_page = pytest.mark.parametrize("words", PAGES)
NAMES = ("Outstroke", "Return", "Hingang", "Rückgang")


def rows(*words: str) -> list[dict[str, str]]:
    return printed(*words, "-f", "csv").records()


def heads(table: Table) -> Iterator[str]:
    for panel in table.panels:
        for column in panel.columns:
            yield from (*column.spanners, *column.heading)


@each_page
@pytest.mark.parametrize("run", ["--step=45", "--from=90"])
def test_a_run_of_both_strokes_ends_with_them(words: str, run: str) -> None:
    found = rows(*words.split(), run)
    assert {row["phi"] for row in found} >= {"90", "180"}
    assert max(float(row["phi"]) for row in found) == 180
    page = printed(*words.split(), run, "--lang=en").out
    assert "Outstroke" in page
    assert "Return" in page


@each_page
@pytest.mark.parametrize(
    "angles", ["--to=360 --step=45", "--angle=45;225", "--from=200 --step=20", "--angle=-20"]
)
@pytest.mark.parametrize("lang", ["de", "en"])
def test_beyond_a_stroke_no_head_names_one(words: str, angles: str, lang: str) -> None:
    asked = (*words.split(), *angles.split(), f"--lang={lang}")
    found = json.loads(printed(*asked, "-f", "json").out)
    names = [column["key"] + column["name"].title() for column in found["columns"]]
    assert not [name for name in names if "_return" in name or any(one in name for one in NAMES)]
    head, *_ = printed(*asked, "-f", "html").out.split("</thead>")
    assert not [name for name in NAMES if name in head]


@pytest.mark.parametrize("words", ["table --ratio 2:7", "forces --ratio 2:7", "table --layout kolbenwege"])
def test_the_whole_turn_goes_through_the_return_stroke(words: str) -> None:
    """The straight crank stands alike before and after a dead centre, and goes the other way."""
    found = rows(*words.split(), "--to=360", "--step=30")
    turn = {(row.get("ratio"), int(row["phi"])): row for row in found}
    assert len(found[0]) >= 3
    odd = {"c", "guide_force", "tangential_force"}
    for (ratio, angle), row in turn.items():
        mirrored = turn[ratio, 360 - angle]
        for key in row.keys() - {"ratio", "phi"}:
            sign = -1 if key in odd else 1
            assert float(row[key]) == sign * float(mirrored[key])


def test_one_stroke_alone_goes_through_the_turn_or_ends_with_it() -> None:
    table = kurbel.table("1:5", step=60, columns="phi,x", lang="en")
    assert (len([*table.records.rows]), [*heads(table)]) == (7, ["Piston path", "$x/R$"])
    table = kurbel.table("1:5", step=60, columns="phi,x_return", lang="en")
    assert (len([*table.records.rows]), [*heads(table)]) == (4, ["Piston path", "Return", "$x/R$"])


def test_angles_of_a_layout_end_with_the_return_stroke_that_is_asked_for() -> None:
    words = "forces --stroke 600mm --rod 1500mm --speed 120/min --reciprocating 200kg --vertical --columns"
    assert rows(*words.split(), "torque_nm,torque_return_nm")[-1]["phi"] == "180"
    assert rows(*words.split(), "torque_nm")[-1]["phi"] == "360"


@pytest.mark.parametrize("angles", ["--to=360", "--angle=200", "--angle=-1"])
def test_the_return_stroke_beyond_its_end_is_refused_with_what_goes_on(angles: str) -> None:
    assert refusal("table", "--ratio=1:5", "--columns=phi,x_return_mm", "--stroke=1m", angles) == (
        "column x_return_mm is of the return stroke, which ends at 180°, and other angles were given; leave"
        " it out, for x_mm goes on through the whole turn"
    )


@pytest.mark.parametrize("layout", ["verfahren", "ordnungen"])
def test_a_caption_of_the_outstroke_is_not_that_of_a_turn(layout: str) -> None:
    page = ("table", "--layout", layout, "--lang=en", "--step=90")
    assert printed(*page, "--to=180").out.startswith(" Outstroke of the piston")
    assert printed(*page).out.startswith(" Piston path, piston velocity")


def test_directions_of_forces_beyond_the_dead_centre_are_those_of_the_outstroke() -> None:
    said = "beyond the outer dead centre directions remain those of the outstroke"
    for words in ("forces --ratio 1:5", "forces --mechanism arc --ratio 1:5 --rocker 6"):
        assert said in printed(*words.split(), "--angle=200", "--lang=en").out.replace("\n", "")
        assert said not in printed(*words.split(), "--angle=100", "--lang=en").out
    assert said not in printed("forces", "--mechanism=parallel", "--angle=200", "--lang=en").out


def test_heads_in_words_of_ones_own_give_way_to_the_quantitys(tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "layout.toml").write_text(
        """\
title = "Weg"
caption = "Weg"
ratios = ["1:5"]
angles = ["0..180:60"]
down = ["ratio", "angle"]
stub = ["angle"]
across = ["column"]
columns = [
    { quantity = "x", spanners = [], heading = ["hin"] },
    { quantity = "x_return", spanners = [], heading = ["her"] },
    { quantity = "psi", spanners = [], heading = ["Winkel"] },
]
""",
        encoding="utf-8",
    )
    page = kurbel.table(layouts=tmp_path, layout="mine")
    assert [*heads(page)] == ["hin", "her", "Winkel"]
    page = kurbel.table(layouts=tmp_path, layout="mine", to=360)
    assert [*heads(page)] == ["Kolbenweg", "$x/R$", "Winkel"]


def test_angles_from_another_zero_are_of_the_whole_turn() -> None:
    found = rows("table", "--ratio=1:5", "--zero=outer", "--step=90")
    assert [(row["phi"], row["x"]) for row in found][1:3] == [("90", "1.1010"), ("180", "0.0000")]
    assert len(found) == 5
    assert "x_return" not in found[0]


ROCKERS = (("arc", "--rocker=6", 6), ("arc", "--rocker=6 --pivot=5;-6", 6), ("beam", "--beam=4", 4))


@pytest.mark.parametrize(("mechanism", "links", "arm"), ROCKERS)
def test_the_rocker_turns_with_the_sign_that_the_page_states(mechanism: str, links: str, arm: int) -> None:
    drive = ("table", f"--mechanism={mechanism}", *links.split(), "--ratio=1:5", "--digits=9")
    width, keys = 1e-3, "path,turn_velocity"
    for angle in (90, 270):
        near = ";".join(str(angle + shift * width) for shift in (-1, 0, 1))
        rows = printed(*drive, f"--angle={near}", f"--columns={keys}", "-f", "csv").records()
        # The path grows on the outstroke.
        slope = (float(rows[2]["path"]) - float(rows[0]["path"])) / radians(2 * width) / arm
        assert float(rows[1]["turn_velocity"]) == pytest.approx(slope, abs=1e-4)
        assert (slope > 0) == (angle < 180)
    (there, back) = (
        float(printed(*drive, f"--angle={angle}", "--columns=phi," + key, "-f", "csv").records()[0][key])
        for angle, key in ((270, "turn_velocity"), (90, "turn_velocity_return"))
    )
    assert there == -back < 0


@pytest.mark.parametrize(("mechanism", "links", "arm"), ROCKERS)
@pytest.mark.parametrize(
    ("lang", "said", "radians_said"),
    [
        ("de", "jenseits des äußeren Totpunkts bleiben die Richtungen die des Hingangs", "in x im Bogenmaß"),
        ("en", "beyond the outer dead centre directions remain those of the outstroke", "in x in radians"),
    ],
)
def test_pages_of_rockers_say_whose_direction_and_whose_radians(
    mechanism: str, links: str, arm: int, lang: str, said: str, radians_said: str
) -> None:
    def page(*words: str) -> str:
        drive = ("table", f"--mechanism={mechanism}", *links.split(), "--ratio=1:5", f"--lang={lang}")
        return " ".join(printed(*drive, *words).out.split())

    assert page("--columns=phi,turn_velocity", "--angle=270").count(said) == 1
    assert page("--columns=phi,turn_velocity,rod_force", "--angle=270").count(said) == 1
    assert said not in page("--columns=phi,turn_velocity,turn_velocity_return", "--angle=90")
    assert radians_said not in page("--columns=phi,turn_velocity", "--angle=90")
    assert radians_said in page("--columns=phi,x,turn_velocity", "--angle=90")
