"""What stands at the wrong place of a command line: an option twice, a value without its option."""

from __future__ import annotations

from pathlib import Path

import pytest
from cli import kurbel, printed, refusal

PAGE = ("table", "--ratio=1:5", "--angle=30")


@pytest.mark.parametrize(
    "words",
    [
        ("--method", "exact", "infinite"),
        ("--lang", "de", "en"),
        ("--layout", "verfahren", "kinematics"),
        ("--format", "csv", "json"),
        ("--output", "one.csv", "other.csv"),
        ("--digits", "3", "4"),
        ("--decimal", "comma", "point"),
        ("--speed", "120/min", "2/s"),
    ],
    ids=lambda words: words[0],
)
def test_an_option_of_one_value_is_refused_with_two(words: tuple[str, str, str]) -> None:
    flag, one, other = words
    sentence = f"{flag} is given as {one} and as {other}, and takes one value"
    assert refusal(*PAGE, flag, one, flag, other).startswith(sentence)


def test_two_methods_are_told_where_they_stand_side_by_side() -> None:
    both = ("--method", "exact", "--method", "series")
    assert "; --layout verfahren prints exact and series side by side" in refusal(*PAGE, *both)
    assert "; --infinite draws the infinite rod beside the other" in refusal("plot", "--ratio=1:5", *both)
    # Where a page has several methods they are several values.
    assert printed("delta", "--eps=4", *both, "-f", "csv").out.startswith(
        "epsilon,ratio,delta_exact,delta_series,"
    )


def test_the_same_twice_is_once() -> None:
    twice = printed(*PAGE, "--lang", "en", "--lang", "EN", "--digits", "3", "--digits", "3", "-f", "csv")
    assert twice.out == printed(*PAGE, "--lang", "en", "--digits", "3", "-f", "csv").out


def test_a_list_of_several_options_stays_one() -> None:
    lists = printed("table", "--ratio=1:4", "--ratio=1:5", "--columns=x", "--columns=c", "-f", "csv")
    assert lists.out == printed("table", "--ratio=1:4;1:5", "--columns=x,c", "-f", "csv").out


def test_a_variable_gives_way_without_a_word() -> None:
    assert printed(*PAGE, "--lang", "en", KURBEL_LANG="de").out == printed(*PAGE, "--lang", "en").out


@pytest.mark.parametrize(
    ("words", "right"),
    [
        (("table", "1:5"), "--ratio 1:5"),
        (("table", "1:3..6"), "--ratio 1:3..6"),
        (("plot", "1:5"), "--ratio 1:5"),
        (("example", "blau", "33", "1:5"), "--ratio 1:5"),
        (("solve", "v=max"), "--where v=max"),
        (("table", "0..180:10"), "--angle 0..180:10"),
        (("table", "120 min^-1"), "--speed '120 min^-1'"),
        (("table", "600mm"), "--stroke 600mm"),
        (("forces", "10kN"), "--force 10kN"),
        (("balance", "V8"), "--engine V8"),
        (("harmonics", "velocity"), "--quantity velocity"),
        (("table", "phi,x"), "--columns phi,x"),
        (("table", "English"), "--lang English"),
        (("table", "latex"), "--format latex"),
        (("table", "page.html"), "--output page.html"),
        (("table", "engine.toml"), "--machine engine.toml"),
        (("table", "verfahren"), "--layout verfahren"),
        (("table", "arc"), "--mechanism arc"),
    ],
    ids=lambda one: one if isinstance(one, str) else " ".join(one),
)
def test_a_value_without_its_option_is_told_the_option(
    words: tuple[str, ...], right: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    command, text = words[0], words[-1]
    sentence = f'"{text}" stands behind no option; write {right}; see kurbel {command} --help'
    assert refusal(*words) == sentence
    # There is such an option.
    assert "no option" not in kurbel(command, *words[1:-1], right.split()[0], text).err


@pytest.mark.parametrize(
    ("words", "value"),
    [
        (("table", "--stroke", "600", "mm"), "'600 mm'"),
        (("table", "--stroke=600mm", "--speed=120", "min^-1"), "'120 min^-1'"),
        (("table", "--columns", "x,", "c"), "'x, c'"),
    ],
)
def test_a_value_that_the_shell_parted_is_shown_in_quotes(words: tuple[str, ...], value: str) -> None:
    assert f'"{words[-1]}" stands behind no option; a value with a space needs quotes: {value};' in refusal(
        *words
    )


@pytest.mark.parametrize("words", [("table", "foo"), ("delta", "4"), ("table", ""), ("table", "x" * 5000)])
def test_any_other_word_is_one_too_many(words: tuple[str, str]) -> None:
    said = refusal(*words)
    assert said.endswith(f"and kurbel {words[0]} needs no such word; see kurbel {words[0]} --help")
    assert len(said) < 200


def test_a_value_in_place_of_a_command_is_told_the_command() -> None:
    assert refusal("1:5") == 'there is no command "1:5"; write kurbel table --ratio 1:5'
    assert refusal("p=0") == 'there is no command "p=0"; write kurbel solve --ratio 1:5 --where p=0'
    assert printed("solve", "--ratio=1:5", "--where=p=0").out
