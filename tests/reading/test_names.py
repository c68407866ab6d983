"""One name for one thing: capitals, other words, letters of formulas, and the nearest name."""

from __future__ import annotations

import pytest
from cli import kurbel, printed, refusal
from hypothesis import given, settings
from hypothesis import strategies as st

import kurbel as library
from kurbel.page.layouts import SUBJECTS
from kurbel.page.subject import subject
from kurbel.reading.names import near, otherwise

WORDS = (("x", "path", "position"), ("c", "v", "velocity"), ("p", "a", "acceleration"))
MECHANISMS = {
    "straight": ("--ratio=1:5",),
    "offset": ("--ratio=1:5", "--offset=0.3"),
    "arc": ("--ratio=1:5", "--mechanism=arc", "--rocker=6"),
    "beam": ("--ratio=1:5", "--mechanism=beam", "--beam=3"),
    "parallel": ("--mechanism=parallel",),
}
KEYS = {name: tuple(subject(name).quantities()) for name in SUBJECTS}


def data(*words: str) -> str:
    return printed(*words, "-f", "csv").out


@pytest.mark.parametrize("drive", MECHANISMS.values(), ids=MECHANISMS)
def test_path_velocity_and_acceleration_have_the_same_names_in_every_mechanism(
    drive: tuple[str, ...],
) -> None:
    pages = {
        data("table", *drive, "--angle=30;75", f"--columns={','.join(names)}")
        for names in (*zip(*WORDS, strict=True), ("Weg", "Geschwindigkeit", "BESCHLEUNIGUNG"))
    }
    assert len(pages) == 1
    # The angle and three different columns.
    assert len(set(pages.pop().splitlines()[1].split(","))) == 4


@pytest.mark.parametrize("mechanism", ["straight", "arc"])
def test_conditions_know_them_too(mechanism: str) -> None:
    drive = MECHANISMS[mechanism]
    pages = {data("solve", *drive, f"--where={word}=0", f"--columns=phi,{word}") for word in WORDS[2]}
    assert len(pages) == 1


def test_the_velocity_of_a_rocker_is_that_of_its_turn() -> None:
    drive = MECHANISMS["arc"]
    for own, other in (("turn_velocity", "rocker_velocity"), ("turn_acceleration", "rocker_acceleration")):
        columns = [data("table", *drive, "--angle=30;75", f"--columns=phi,{one}") for one in (own, other)]
        assert columns[0] == columns[1]


def test_other_commands_know_them_too() -> None:
    for word in ("c", "v", "Velocity"):
        assert data("harmonics", "--ratio=1:5", f"--quantity={word}") == data(
            "harmonics", "--ratio=1:5", "--quantity=c"
        )
    found = library.compute([30, 75], "1:5", "velocity,v,c")
    assert [*found] == ["velocity", "v", "c"]
    assert len({tuple(values) for values in found.values()}) == 1
    assert library.certified("Acceleration", "1:5", 30) == library.certified("p", "1:5", 30)


def test_units_and_strokes_stand_behind_any_word() -> None:
    assert data(
        "table",
        "--ratio=1:5",
        "--stroke=1m",
        "--speed=2/s",
        "--columns=phi,Path_mm,velocity_return_mps,a_mps2",
    ).startswith("phi,x_mm,c_return_mps,p_mps2\n")


@pytest.mark.parametrize(
    ("written", "name"),
    [
        ("i4", "inline-4"), ("Inline 4", "inline-4"), ("R6", "inline-6"), ("V8", "v8-90"), ("B4", "boxer-4"),
    ],
)  # fmt: skip
def test_engines_are_known_as_they_are_called(written: str, name: str) -> None:
    assert data("firing", "--engine", written) == data("firing", "--engine", name)


def test_what_could_be_two_engines_is_asked_back() -> None:
    assert "(did you mean inline-2-180 or inline-2-360?)" in refusal("balance", "--engine", "i2")


@pytest.mark.parametrize("lang", ["EN", "English", "en_US.UTF-8"])
def test_languages_have_many_names(lang: str) -> None:
    page = ("table", "--ratio=1:5", "--angle=30")
    assert printed(*page, "--lang", lang).out == printed(*page, "--lang", "en").out
    assert printed(*page, KURBEL_LANG=lang).out == printed(*page, "--lang", "en").out


def test_capitals_say_the_same() -> None:
    page = ("table", "--ratio=1:5", "--angle=30")
    for words in (
        ("-f", "CSV"),
        ("-f", "Csv", "--method", "Exact"),
        ("-f", "csv", "--mechanism", "STRAIGHT"),
    ):
        assert printed(*page, *words).out == data(*page)
    assert kurbel("TABLE", *page[1:]).out == printed(*page).out
    assert (
        library.typeset(library.table("1:5", angle=30, lang="EN", columns="Velocity"), "CSV") == "c\n0.5870\n"
    )


@pytest.mark.parametrize("name", ["flywheel sizing", "locomotive", "torques"])
def test_letters_changed_about_are_put_right(name: str) -> None:
    for key in KEYS[name]:
        typed = key[:2] + key[3] + key[2] + key[4:] if len(key) > 5 else key
        if typed != key and "_" not in key[2:4]:
            assert near(typed, KEYS[name]) == [key], typed


@pytest.mark.parametrize(
    ("typed", "of"),
    [
        ("acceleration", ("ratio", "phi", "rod_velocity")),
        ("velocity", ("delivery", "rod_acceleration")),
        ("position", ("psi_return", "condition")),
        ("mean_force", ("bearing_force", "rod_force")),
        ("angle", ("lang", "delta")),
        ("3", ("31", "35")),
        ("", ("x",)),
        ("zzz", ("x", "s", "psi")),
    ],
)
def test_no_suggestion_leads_away(typed: str, of: tuple[str, ...]) -> None:
    assert near(typed, of) == []


def test_a_misspelt_word_is_answered_with_that_word() -> None:
    said = refusal("table", "--ratio=1:5", "--columns=phi,accelration")
    assert 'there is no column "accelration" (did you mean acceleration?)' in said
    # Files that are checked have one spelling, which they are told.
    assert near("accelration", ("x", "p")) == ["p"]


@settings(deadline=None, max_examples=40)
@given(st.text(max_size=80), st.sampled_from(sorted(KEYS)))
def test_any_text_is_a_name_of_the_list_or_none(text: str, name: str) -> None:
    assert otherwise(text, KEYS[name]) in (None, *KEYS[name])
    assert {*near(text, KEYS[name])} <= {*KEYS[name]}
