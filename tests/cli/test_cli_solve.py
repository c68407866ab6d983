"""`kurbel solve` as a user types it: pages, records, defaults and sentences about mistakes."""

from __future__ import annotations

import json
from typing import Any

import pytest
from cli import printed, refusal

import kurbel
from kurbel.errors import KurbelError

MACHINE = ("--stroke=600mm", "--rod=1500mm", "--speed=120/min")


def records(*words: str) -> list[dict[str, str]]:
    return printed("solve", *words, "-f", "csv").records()


def test_records_have_both_angles_and_the_motion_there() -> None:
    out, back = records("--ratio=1:5", "--method=series", "--where=p=0")
    assert out == {
        "ratio": "1:5", "condition": "p = 0", "stroke": "outstroke", "phi": "79.2724", "phi_turn": "79.2724",
        "x": "0.9104", "x_stroke": "0.4552", "c": "1.0191", "p": "0.0000",
    }  # fmt: skip
    assert (back["stroke"], back["phi"], back["phi_turn"]) == ("return", "100.7276", "280.7276")


def test_cut_off_counts_on_each_stroke_from_its_own_dead_centre() -> None:
    out, back = records("--ratio=1:5", "--where=s=25%")
    # x = R/2: by the triangle of 1, 5 and 5.5 cos φ is 25/44, by that of 1, 5 and 4.5 it is 5/12.
    assert (out["phi"], back["phi"]) == ("55.3765", "65.3757")
    assert out["x_stroke"] == back["x_stroke"] == "0.2500"
    assert (out["x"], back["x"]) == ("0.5000", "0.5000")


def test_conditions_and_ratios_are_combined_in_order() -> None:
    found = records("--ratio=1:5;1:4", "--where=p=0", "--where=c=max", "--where=p = 0")
    assert [(one["ratio"], one["condition"]) for one in found[::2]] == [
        ("1:5", "p = 0"), ("1:5", "c = max"), ("1:4", "p = 0"), ("1:4", "c = max"),
    ]  # fmt: skip


def test_values_may_have_units_of_the_machine() -> None:
    out, back = records(*MACHINE, "--where=x = 0,2 m")
    assert (out["x_mm"], back["x_mm"]) == ("200.00", "200.00")
    found = records(*MACHINE, "--where=c = 10.8 km/h")
    assert [one["c_mps"] for one in found] == 4 * ["3.000"]
    found = records(*MACHINE, "--where=p = 20 m/s^2")
    assert [one["p_mps2"] for one in found] == 2 * ["20.00"]
    assert {one["condition"] for one in found} == {"p = 20 m/s^2"}


def test_the_quantity_of_a_condition_has_a_column() -> None:
    (first, *_) = records("--where=psi=5", "--where=guide_force=0.1")
    assert first["psi"] == "5.000"
    assert "guide_force" in first
    (first, *_) = records("--where=psi=5", "--columns=phi,x_percent")
    assert list(first) == ["stroke", "phi", "x_percent"]


def test_the_arc_crank_is_known_by_its_quantities_and_their_letters() -> None:
    arc = ("--mechanism=arc", "--rocker=6", "--ratio=1:5")
    assert records(*arc, "--where=acceleration=0") == records(*arc, "--where=p=0")
    (first, _) = records(*arc, "--where=p=0")
    assert (first["condition"], first["acceleration"]) == ("acceleration = 0", "0.0000")


def test_a_method_of_the_infinite_rod_needs_no_ratio() -> None:
    found = records("--method=infinite", "--ratio=1:4;1:5", "--where=c=0.5")
    assert [(one["ratio"], one["phi"]) for one in found] == [
        ("1:∞", "30.0000"), ("1:∞", "150.0000"), ("1:∞", "30.0000"), ("1:∞", "150.0000"),
    ]  # fmt: skip


def test_digits_are_as_many_as_asked_for() -> None:
    (first, _) = records("--ratio=1:5", "--where=p=0", "--digits=30")
    assert first["p"] == f"0.{30 * '0'}"
    assert len(first["phi"].partition(".")[2]) == 30


def test_json_tells_the_method() -> None:
    page = json.loads(printed("solve", "--where=p=0", "--method=series", "-f", "json").out)
    assert [column["method"] for column in page["columns"] if column["key"] == "x"] == ["series"]
    assert len(page["rows"]) == 2


def test_an_offset_crank_has_its_dead_centres_below_the_table() -> None:
    page = " ".join(printed("solve", "--ratio=1:4", "--offset=0.5", "--where=x=0", "--lang=en").out.split())
    assert "Outstroke 5°44′ 5°44′ 0.0000 0.0000" in page
    assert "Return 9°36′ 189°36′ 0.0000" in page
    assert "dead centres at φᵢ = 5.739° and φₒ = 189.594°" in page


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ((), 'no condition was given; write one as --where p=0 or --where "s = 25%"'),
        (("--where=p>0",), 'condition "p>0" cannot be read; write it as p=0, s=25%, x=1.1, "x = 200 mm"'),
        (("--where=y=0",), 'there is no quantity "y"; choose from x, s, fd, c, p, psi,'),
        (("--where=x = 200 mm",), 'condition "x = 200 mm" is in mm and needs --stroke'),
        (("--where=c = 3 m/s", "--stroke=1m"), 'condition "c = 3 m/s" is in m/s and needs --stroke and'),
        (("--where=x = 2 kg", "--stroke=1m"), 'x "2 kg" is in kilogram; it must be a length such as 600mm'),
        (("--where=x = 2 blah", "--stroke=1m"), 'x "2 blah" has the unknown unit blah; write a length'),
        (("--where=p=0", "--columns=x_mm"), "column x_mm is in mm and needs --stroke"),
        (("--where=p=0", "--columns=chord"), "column chord belongs to another mechanism or method"),
        (("--where=p=0", "--columns=nothing"), 'there is no column "nothing"'),
        (("--where=p=0", "--columns=phi"), "there is no column beside the angle; add one, such as phi_turn"),
        (("--where=psi=0", "--method=infinite"), "psi is the same at every crank angle for R:L = 1:∞"),
        (("--where=guide_force=0", "--method=series"), 'method "series" has no formula for guide_force; use'),
        (("--where=p=0", "--method=series", "--offset=0.1"), 'method "series" has no formulas for an offset'),
        (("--where=p=0", "--mechanism=parallel"), "the rod of the parallel crank moves as the piston with"),
        (("--where=p=0", "--mechanism=arc"), "the arc crank needs the length of its rocker; add --rocker"),
        (("--where=x=1mm", "--mechanism=arc", "--rocker=6"), 'condition "x=1mm" has a unit, which only'),
        (("--where=p=0", "--layout=kinematics"), "layout kinematics is about something else"),
        (("--where=p=0", "--ratio=2"), "crank ratio R:L is 2; it must be below 1"),
    ],
)  # fmt: skip
def test_wrong_usage_is_answered_with_a_sentence(words: tuple[str, ...], said: str) -> None:
    assert refusal("solve", *words).startswith(said)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        # arcsin(1/5) = 11.5369590328...°
        (
            ("--where=psi=11.53696",),
            "psi = 11.53696 is reached nowhere for R:L = 1:5; psi lies between 0.000000° and 11.536959° on",
        ),
        (("--where=p=2",), "p = 2 is reached nowhere for R:L = 1:5; p lies between -0.8000 and 1.2000 v²/R"),
        (
            ("--where=s=120%",),
            "s = 120% is reached nowhere for R:L = 1:5; s lies between 0% and 100% on both",
        ),
        (
            ("--where=x = 700 mm", *MACHINE),
            "x = 700 mm is reached nowhere for R:L = 1:5; x lies between 0.00 and 600.00 mm on both strokes",
        ),
        (
            ("--where=p=0", "--where=c=1.02", "--ratio=1:5;1:4", "-o-"),
            "c = 1.02 is reached nowhere for R:L = 1:5; c lies between 0.0000 and 1.0198 v on both strokes",
        ),
        (
            ("--where=rocker=30", "--mechanism=arc", "--rocker=6"),
            "rocker = 30 is reached nowhere for R:L = 1:5; rocker lies between -9.603° and 9.588° on both",
        ),
    ],
)
def test_a_condition_without_a_root_fails_with_the_range(words: tuple[str, ...], said: str) -> None:
    assert refusal("solve", *words, code=1).startswith(said)


def test_a_failure_leaves_no_file(tmp_path: Any) -> None:
    path = tmp_path / "page.txt"
    refusal("solve", "--where=p=2", f"--output={path}", code=1)
    assert not path.exists()


def test_the_library_gives_the_page_of_the_command_line() -> None:
    table = kurbel.solve_table(
        ["p = 0", "s = 25%"], ratio="1:4", mechanism="arc", rocker=6, pivot=(4, 6), lang="en"
    )
    words = ("--where=p=0", "--where=s=25%", "--ratio=1:4", "--mechanism=arc", "--rocker=6", "--pivot=4;6")
    assert kurbel.typeset(table) == printed("solve", *words, "--lang=en").out
    table = kurbel.solve_table("x = 200 mm", ratio="1:5", stroke=0.6, speed=2)
    assert kurbel.typeset(table, "csv") == printed("solve", *MACHINE, "--where=x = 200 mm", "-f", "csv").out


@pytest.mark.parametrize(
    "choices",
    [
        {"where": []},
        {"where": "p"},
        {"where": [0]},
        {"where": "p = 0", "ratio": []},
        {"where": "p = 0", "method": "fast"},
        {"where": "p = 0", "mechanism": "arc", "rocker": 6, "method": "series"},
        {"where": "p = 0", "mechanism": "arc", "rocker": 6, "stroke": 0},
        {"where": "p = 0", "mechanism": "arc", "rocker": 6, "pivot": "5"},
        {"where": "p = 0", "columns": "y"},
        {"where": "p = 2"},
        {"where": "p = 0", "layout": "forces"},
    ],
)
def test_wrong_input_from_python_is_refused(choices: dict[str, Any]) -> None:
    with pytest.raises(KurbelError):
        kurbel.solve_table(**choices)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (
            ("--ratio=1:3", "--method=series", "--where=p=-0.7"),
            "cos φ = (−15 ± √5)/20, hence −0.6382 and −0.8618",
        ),
        (("--ratio=1:3", "--method=series", "--where=p=min"), "Outstroke: cos φ = −3/4"),
        (("--ratio=1:5", "--where=s=25%"), "Outstroke: cos φ = 25/44 Return: cos φ = 5/12"),
        (
            ("--ratio=1:5", "--method=series", "--where=p=1.2"),
            "Outstroke: cos φ = 1; −7/2 unusable, beyond ±1",
        ),
        (("--ratio=1:5", "--where=p=0"), None),
        (("--ratio=1:5", "--where=p=max"), None),
        (("--ratio=1:5", "--where=psi=0"), None),
        (("--ratio=1:4", "--offset=0.5", "--where=p=0"), None),
    ],
)
def test_closed_forms_stand_below_the_table_where_they_say_something(
    words: tuple[str, ...], said: str | None
) -> None:
    page = " ".join(printed("solve", *words, "--lang=en").out.split())
    assert said in page if said else "stroke: cos φ" not in page
