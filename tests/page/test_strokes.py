"""Outstroke and return stand side by side up to 180°; beyond, a page is of whole turns."""

from __future__ import annotations

import json
from math import radians

import pytest
from cli import printed

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
NAMES = ("Outstroke", "Return", "Hingang", "Rückgang")


def rows(*words: str) -> list[dict[str, str]]:
    return printed(*words, "-f", "csv").records()


@pytest.mark.parametrize(("place", "words"), [*enumerate(PAGES)])
def test_a_run_of_both_strokes_ends_with_them(place: int, words: str) -> None:
    run = ("--step=45", "--from=90")[place % 2]
    found = rows(*words.split(), run)
    assert {row["phi"] for row in found} >= {"90", "180"}
    assert max(float(row["phi"]) for row in found) == 180
    page = printed(*words.split(), run, "--lang=en").out
    assert "Outstroke" in page
    assert "Return" in page


ANGLES = ("--to=360 --step=45", "--angle=45;225", "--from=200 --step=20", "--angle=-20")


@pytest.mark.parametrize(("place", "words"), [*enumerate(PAGES)])
def test_beyond_a_stroke_no_head_names_one(place: int, words: str) -> None:
    asked = (*words.split(), *ANGLES[place % 4].split(), f"--lang={('de', 'en')[place % 2]}")
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
