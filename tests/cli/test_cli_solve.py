"""`kurbel solve` as a user types it: pages, records, defaults and sentences about mistakes."""

from __future__ import annotations

import json

from cli import printed

import kurbel

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


def test_values_may_have_units_of_the_machine() -> None:
    out, back = records(*MACHINE, "--where=x = 0,2 m")
    assert (out["x_mm"], back["x_mm"]) == ("200.00", "200.00")
    found = records(*MACHINE, "--where=c = 10.8 km/h")
    assert [one["c_mps"] for one in found] == 4 * ["3.000"]
    found = records(*MACHINE, "--where=p = 20 m/s^2")
    assert [one["p_mps2"] for one in found] == 2 * ["20.00"]
    assert {one["condition"] for one in found} == {"p = 20 m/s^2"}


def test_the_arc_crank_is_known_by_its_quantities_and_their_letters() -> None:
    arc = ("--mechanism=arc", "--rocker=6", "--ratio=1:5")
    assert records(*arc, "--where=acceleration=0") == records(*arc, "--where=p=0")
    (first, _) = records(*arc, "--where=p=0")
    assert (first["condition"], first["acceleration"]) == ("acceleration = 0", "0.0000")


def test_json_tells_the_method() -> None:
    page = json.loads(printed("solve", "--where=p=0", "--method=series", "-f", "json").out)
    assert [column["method"] for column in page["columns"] if column["key"] == "x"] == ["series"]
    assert len(page["rows"]) == 2


def test_the_library_gives_the_page_of_the_command_line() -> None:
    table = kurbel.solve(
        ["p = 0", "s = 25%"], ratio="1:4", mechanism="arc", rocker=6, pivot=(4, 6), lang="en"
    )
    words = ("--where=p=0", "--where=s=25%", "--ratio=1:4", "--mechanism=arc", "--rocker=6", "--pivot=4;6")
    assert kurbel.typeset(table) == printed("solve", *words, "--lang=en").out
    table = kurbel.solve("x = 200 mm", ratio="1:5", stroke=0.6, speed=2)
    assert kurbel.typeset(table, "csv") == printed("solve", *MACHINE, "--where=x = 200 mm", "-f", "csv").out


def test_the_time_at_a_root_is_that_since_its_stroke_began() -> None:
    # At two turns a second; the offset crank's strokes begin at its dead centres.
    (ends,) = printed("deadcentres", "--ratio=1:4", "--offset=0.5", "--columns=phi_i,phi_o", "--digits=9",
                      "-f", "csv").records()  # fmt: skip
    words = ("--ratio=1:4", "--offset=0.5", "--stroke=600mm", "--speed=120/min", "--where=s=30%")
    for row, begun in zip(
        records(*words, "--columns=phi_turn,time", "--digits=9"), ends.values(), strict=True
    ):
        since = (float(row["phi_turn"]) - float(begun)) % 360 / 720
        assert abs(float(row["time"]) - since) < 1e-8
