"""What is refused about engines leaves nothing behind; the sentences stand in tests/transcripts/refused."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from cli import answered, kurbel, refusal
from hypothesis import given, settings
from hypothesis import strategies as st

from kurbel.formats.registry import FORMATS
from kurbel.reading import units
from kurbel.reading.environment import how_to_install

WHEEL = ("flywheel", "--speed=120/min", "--delta=1:100", "--eps=4")
WRONG = (
    ("delta", "--eps", "0.5"),
    ("delta", "--back", "0.9"),
    ("delta", "--method", "weisbach", "--single-acting"),
    ("turning", "--eps=4", "--columns", "foo"),
    (*WHEEL, "--power", "50kg"),
    ("solve", "--where=p=2"),
)


def test_without_pint_a_flywheel_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    units.registry.cache_clear()
    monkeypatch.setitem(sys.modules, "pint", None)
    assert refusal(*WHEEL, "--power", "68PS", code=1) == (
        f"quantities with units need pint; install it with: {how_to_install('units')}"
    )
    assert kurbel(*WHEEL, "--power", "50kW").code == 0


@pytest.mark.parametrize(
    ("words", "form"), [*((WRONG[0], form) for form in FORMATS), *((words, "text") for words in WRONG[1:])]
)
def test_nothing_is_written_on_an_error(words: tuple[str, ...], form: str, tmp_path: Path) -> None:
    old, new = tmp_path / "old", tmp_path / "new"
    old.write_text("as it was")
    for path in (old, new):
        refusal(*words, "-f", form, "-o", str(path), code=1 if "solve" in words else 2)
    assert [path.name for path in tmp_path.iterdir()] == ["old"]
    assert old.read_text() == "as it was"


OPTIONS = ("eps", "ratio", "back", "exponent", "clearance", "cranks", "method", "columns", "digits")
VALUES = st.one_of(
    st.text(st.sampled_from("0123456789.,:;/°'-+e∞% abn\n"), max_size=8),
    st.sampled_from(["2..4", "1:4", "0.1", "10%", "0;90", "series", "weisbach", "delta,back", "5"]),
)


@settings(deadline=None, max_examples=80)
@given(st.lists(st.tuples(st.sampled_from(OPTIONS), VALUES), min_size=1, max_size=3))
def test_whatever_is_typed_is_answered_with_a_page_or_a_sentence(typed: list[tuple[str, str]]) -> None:
    words = [f"--{option}={value}" for option, value in typed]
    answered("delta", "--eps", "3", *words, "--digits", "2")
