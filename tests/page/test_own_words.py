"""Words of one's own: --caption, --note and --source of every page."""

from __future__ import annotations

import json

import pytest
from cli import kurbel, printed
from hypothesis import given, settings
from hypothesis import strategies as st
from pages import COMMANDS

import kurbel as library

# A page of each command that prints tables.
PAGES = (
    *{words[0]: words for words in reversed([*COMMANDS.values()])}.values(),
    ("collate", "blau-32", "--only", "deviations"),
    ("example", "blau", "33"),
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


def test_python_takes_words_by_the_same_names() -> None:
    page = library.table("1:5", angle="0;90", caption="Weg", note=["a", "b"], source="")
    assert (page.caption, page.source, [note.text for note in page.notes[-2:]]) == ("Weg", "", ["a", "b"])
    assert library.table("1:5", angle="0;90", note="a").notes[-1].text == "a"


@settings(deadline=None, max_examples=25)
@given(st.sampled_from(["caption", "note", "source"]), st.text(max_size=12))
def test_no_words_end_in_a_traceback(name: str, text: str) -> None:
    result = kurbel("table", "--angle", "0", "--columns", "x", f"--{name}={text}", "-f", "latex")
    assert (result.code, result.err) == (0, "") or (result.code == 2 and result.err.startswith("kurbel: "))
