"""`kurbel construct`: which file is a drawing, which a table, and what is refused."""

from __future__ import annotations

from pathlib import Path

import pytest
from cli import printed, refusal

from kurbel.books.constructions.registry import CONSTRUCTIONS


def test_without_a_name_the_constructions_are_listed() -> None:
    rows = printed("construct", "--lang=en", "-f", "csv").records()
    assert [one["construction"] for one in rows] == list(CONSTRUCTIONS)
    assert printed("construct", "--help").out.count("after Blau, Fig. 9") == 1


@pytest.mark.parametrize("suffix", ["svg", "png", "pdf", "pgf", "html", "htm"])
def test_a_file_of_a_drawing_is_one(suffix: str, tmp_path: Path) -> None:
    path = tmp_path / f"fig.{suffix}"
    printed("construct", "forces", "--ratio=1:3", "-o", str(path))
    start = {"png": b"\x89PNG", "pdf": b"%PDF", "pgf": b"% ", "svg": b"<?xml"}.get(suffix, b"<!DOCTYPE html>")
    content = path.read_bytes()
    assert content.startswith(start)
    assert b"<table" not in content if suffix == "svg" else True


def test_the_table_is_that_of_a_drawing_format_where_it_is_asked_for(tmp_path: Path) -> None:
    path = tmp_path / "fig.html"
    printed("construct", "blau-9", "--table", "-o", str(path))
    page = path.read_text(encoding="utf-8")
    assert page.count("<table") == 1
    assert "<svg" not in page


def test_a_file_says_its_format_also_where_the_environment_has_another(tmp_path: Path) -> None:
    environment = {"KURBEL_FORMAT": "csv"}
    assert printed("construct", "blau-9", **environment).out.startswith("length,symbol,")
    printed("construct", "blau-9", "-o", str(tmp_path / "fig.svg"), **environment)
    assert (tmp_path / "fig.svg").read_bytes().startswith(b"<?xml")


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ("--angle=5", "--angle is for a construction, and none is named; name one, such as blau-9, or leave"),
        ("blau-22", 'there is no construction "blau-22"; choose from blau-9, '),
        ("blau-9 --columns=true -o a.svg", "--columns is for the table; add --table, or leave it out"),
        ("blau-9 --width=80", "--width is for the drawing; name a file for it, such as -o kurbel.svg"),
        ("blau-9 -o a.gif", 'the file name "a.gif" names neither a drawing nor a table; its suffix'),
        ("blau-9 --ratio=1:3;1:4", "a construction is of one drive, and 2 ratios were given; choose one"),
        ("blau-9 --ratio=0", "a rod of infinite length cannot be drawn; give a finite one, such as 1:5"),
        ("blau-9 --ratio=1:30 -o a.svg", "the rod is too long to be drawn; drawn to scale it may be"),
        ("blau-9 --offset=0.2", "that the strokes differ by twice the same length fd holds for the"),
        ("forces --mechanism=arc --rocker=6", "the triangle of forces has one side square to a straight"),
        (
            "forces --ratio=1:1.001 --angle=90 -o a.svg",
            "drawn to scale R would be 3.1 mm long, too short to be seen, for the whole is ",
        ),
        ("ensslin-2 --point=0.5,0.1", "point 0.5,0.1 lies beside the axis of the rod, where Ensslin's"),
        (
            "velocity --mechanism=beam --beam=3",
            "construction velocity holds for the straight, offset and arc crank",
        ),
        ("blau-9 --steps=9 -o a.svg", "construction blau-9 has 5 steps, and step 9 was asked for"),
        ("blau-9 --steps=2 -o a.html", "an HTML page goes through all steps; leave --steps out"),
        ("forces --angle=5;6", 'angle "5;6" is not an angle in degrees; write it as 22.5 or'),
        ("forces -o a.html --text", "--text is for SVG, whose letters are outlines without it; leave"),
    ],
)
def test_what_cannot_be_constructed_is_refused(words: str, sentence: str) -> None:
    assert refusal("construct", *words.split()).startswith(sentence)
    assert not Path("a.svg").exists()
