"""Words of one's own: --caption, --note and --source of every page."""

from __future__ import annotations

import json

import pytest
from cli import kurbel, printed, refusal
from hypothesis import given, settings
from hypothesis import strategies as st

import kurbel as library
from kurbel.cli.app import command_of
from kurbel.cli.asking import printing_commands
from kurbel.cli.tables import TableCommand

# A page of each kind of question: what says its own words, and what makes its own table.
PAGES = (
    ("table", "--angle", "0;90"),
    ("delta", "--eps", "4"),
    ("firing", "--cranks", "0;180;180;0"),
    ("collate", "blau-32", "--only", "deviations"),
    ("collate", "blau-equations"),
    ("example", "blau", "33"),
    ("turning", "--torque", "5000 + 1500 sin(3φ)", "--angle", "0;30"),
    ("solve", "--where", "c=max"),
)
WORDS = ("--caption", r"Weg $x/R$ [^§], 5 \$", "--note", "Ein Satz; noch einer, 1:5", "--source", "Heft 3")
MARKED = ("--note", "[^§] nach Blau")


@pytest.mark.parametrize("words", PAGES, ids=" ".join)
def test_a_page_says_what_is_to_be_said_of_it(words: tuple[str, ...]) -> None:
    own = json.loads(printed(*words, "-f", "json").out)
    page = json.loads(printed(*words, *WORDS, *MARKED, "-f", "json").out)
    notes = [{"mark": "", "text": "Ein Satz; noch einer, 1:5"}, {"mark": "§", "text": "nach Blau"}]
    said = {"caption": "Weg x/R §), 5 $", "source": "Heft 3", "notes": own["notes"] + notes}
    assert page == own | said
    # Nothing but the words is another, and no word is obeyed by a format.
    text = printed(*words, *WORDS, *MARKED).out
    assert "Weg x/R §), 5 $" in text
    assert "Quelle: Heft 3" in text or "Source: Heft 3" in text


def test_every_command_that_prints_tables_takes_words() -> None:
    commands = {name: command_of(name) for name in printing_commands()}
    tables = {name: one for name, one in commands.items() if isinstance(one, TableCommand)}
    assert {*commands} - {*tables} == {"plot"}
    for name, command in tables.items():
        assert {"caption", "note", "source"} <= {one.name for one in command.params}, name


def test_an_empty_source_leaves_out_the_line() -> None:
    book = ("table", "--layout", "roetscher-112", "--angle", "0;90")
    assert "Quelle:" in printed("collate", "roetscher-112").out
    assert "Quelle:" not in printed("collate", "roetscher-112", "--source", "").out
    assert json.loads(printed(*book, "--source", "", "-f", "json").out)["source"] == ""


def test_python_takes_words_by_the_same_names() -> None:
    page = library.table("1:5", angle="0;90", caption="Weg", note=["a", "b"], source="Heft")
    assert (page.caption, page.source, [note.text for note in page.notes[-2:]]) == ("Weg", "Heft", ["a", "b"])
    assert library.table("1:5", angle="0;90", note="a").notes[-1].text == "a"


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("--caption", "$x"), r'the caption "$x" cannot be set: a formula needs a second $'),
        (("--caption", " "), "the caption is empty; give its words, or leave --caption out"),
        (("--caption", "x [^b]"), "the mark [^b] has no note; give it one, as --note '[^b] ...'"),
        (("--note", "[^a b] x"), "the mark [^a b] has a space; a mark is a word or a number"),
        (("--note", "[^b]"), "a note is empty; give its words, or leave --note out"),
        (("--note", "[^b] x", "--note", "[^b] y"), "two notes have the mark b; give yours another"),
        (("--source", "x" * 2001), "the source has 2001 characters; at most 2000 are set"),
        (("--caption", "a\x1b[31mb"), "the caption has a character that cannot be printed"),
    ],
)
def test_words_that_cannot_be_set_are_refused(words: tuple[str, ...], sentence: str) -> None:
    assert sentence in refusal("table", "--angle", "0;90", *words)


def test_a_mark_of_the_page_cannot_be_given_again() -> None:
    page = ("example", "blau", "33")
    mark = next(one["mark"] for one in json.loads(printed(*page, "-f", "json").out)["notes"] if one["mark"])
    assert f"two notes have the mark {mark}" in refusal(*page, "--note", f"[^{mark}] x")


@settings(deadline=None, max_examples=25)
@given(st.sampled_from(["caption", "note", "source"]), st.text(max_size=12))
def test_no_words_end_in_a_traceback(name: str, text: str) -> None:
    result = kurbel("table", "--angle", "0", "--columns", "x", f"--{name}={text}", "-f", "latex")
    assert (result.code, result.err) == (0, "") or (result.code == 2 and result.err.startswith("kurbel: "))
