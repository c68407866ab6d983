"""Files of users in TOML: whatever stands in one, it is read or answered with a sentence naming the file."""

from __future__ import annotations

import copy
import json
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from cli import kurbel as kurbel_in
from hypothesis import example, given, settings
from hypothesis import strategies as st

import kurbel
from kurbel.books.source import all_tables
from kurbel.commands.machine_file import read_machine
from kurbel.handbook.manifest import read_manifest

MACHINE = (Path(__file__).parents[2] / "examples" / "engine.toml").read_text(encoding="utf-8")
HANDBOOK = """\
title = "Tafeln"
lang = "de"
formats = ["text", "html"]
[pdf]
standards = ["a-2b"]
[defaults]
ratio = "1:5"
[[chapter]]
title = "Weg"
[chapter.defaults]
step = 30
[[chapter.part]]
text = "Der Weg $x$."
[[chapter.part]]
name = "weg"
run = "table --ratio 1:5"
"""
SOURCE = """\
citation = "A. Author, A Book"
[stated]
de = "alles"
en = "all"
[inferred]
de = "nichts"
en = "nothing"
[tables.1]
method = "series"
title.de = "Tafel 1"
title.en = "Table 1"
notes.de = ["Eins."]
notes.en = ["One."]
"""
FILES = {"machine.toml": MACHINE, "handbook.toml": HANDBOOK, "source.toml": SOURCE}
WORDS = ("", "x", "1:5", "∞", "-1kg", "600 mm", "de", "pdf", "../up", "$", "$x", "\x1b[31m", "\n", "a" * 300)
VALUES = st.recursive(
    st.booleans()
    | st.integers(-(2**70), 2**70)
    | st.floats()
    | st.sampled_from(WORDS)
    | st.text(st.characters(exclude_categories=["Cs"]), max_size=5),
    lambda inner: (
        st.lists(inner, max_size=3) | st.dictionaries(st.sampled_from(("de", "en", "ratio", "run")), inner)
    ),
    max_leaves=5,
)


def places(value: Any, here: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Yield the place of each key and of each entry of a list."""
    inner = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, one in inner:
        yield (*here, key)
        yield from places(one, (*here, key))


def toml(value: Any) -> str:
    match value:
        case dict():
            return "{" + ", ".join(f"{json.dumps(key)} = {toml(one)}" for key, one in value.items()) + "}"
        case list():
            return "[" + ", ".join(map(toml, value)) + "]"
        case float():
            return repr(value)
    # JSON leaves U+007F as it is, which TOML forbids.
    return json.dumps(value).replace("\x7f", "\\u007f")


def written(value: dict[str, Any]) -> str:
    return "".join(f"{json.dumps(key)} = {toml(one)}\n" for key, one in value.items())


def read(path: Path) -> list[str]:
    """Return the names of what the file has."""
    match path.name:
        case "machine.toml":
            return sorted(read_machine(str(path)))
        case "handbook.toml":
            return [part.name for part in read_manifest(str(path)).parts()]
    return [key for key in all_tables(path.parent.parent) if key.startswith("book")]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("toml") / "book"
    folder.mkdir()
    return folder


ENTRIES = "bore centre delta eps gyration pressure ratio reciprocating rod_mass rotating speed stroke"


@pytest.mark.parametrize(
    ("name", "made"),
    [("machine.toml", ENTRIES.split()), ("handbook.toml", ["", "weg"]), ("source.toml", ["book-1"])],
)
def test_the_files_that_are_spoilt_below_are_good(folder: Path, name: str, made: list[str]) -> None:
    for text in (FILES[name], written(tomllib.loads(FILES[name]))):
        (folder / name).write_text(text, encoding="utf-8")
        assert read(folder / name) == made


@settings(max_examples=120)
@given(data=st.data(), name=st.sampled_from([*FILES]))
def test_a_value_of_any_kind_is_read_or_answered_with_its_file(
    folder: Path, data: st.DataObject, name: str
) -> None:
    given_values = tomllib.loads(FILES[name])
    spoilt = copy.deepcopy(given_values)
    place = data.draw(st.sampled_from([*places(given_values)]))
    home = spoilt
    for key in place[:-1]:
        home = home[key]
    how = data.draw(st.sampled_from(("another value", "left out", "another key")))
    if how == "another value":
        home[place[-1]] = data.draw(VALUES)
    else:
        value = home.pop(place[-1])
        if how == "another key" and isinstance(home, dict):
            home[data.draw(st.text(st.characters(exclude_categories=["Cs"]), max_size=8))] = value
    path = folder / name
    path.write_text(written(spoilt), encoding="utf-8")
    try:
        read(path)
    except kurbel.KurbelError as error:
        said = str(error)
        assert str(path) in said
        assert len(said) < 1000


@given(text=st.text(max_size=80) | st.text("[]{}=.,\"'\n#x1", max_size=80), name=st.sampled_from([*FILES]))
@example(text="\ufeff", name="machine.toml")
@example(text="[" * 5000, name="machine.toml")
@example(text="x = " + "{a = " * 3000, name="handbook.toml")
@example(text="x = 1" + "0" * 5000, name="source.toml")
def test_any_text_is_read_or_answered_with_its_file(folder: Path, text: str, name: str) -> None:
    path = folder / name
    path.write_bytes(text.encode("utf-8", "surrogatepass"))
    try:
        read(path)
    except kurbel.KurbelError as error:
        assert str(path) in str(error)
        assert "Traceback" not in str(error)


@settings(max_examples=30)
@given(data=st.data())
def test_a_machine_that_is_read_is_computed_or_refused(folder: Path, data: st.DataObject) -> None:
    machine = tomllib.loads(MACHINE)
    section, key = data.draw(st.sampled_from([place for place in places(machine) if len(place) == 2]))
    machine[section][key] = data.draw(VALUES)
    path = folder / "machine.toml"
    path.write_text(written(machine), encoding="utf-8")
    for command in ("delta", "forces --step 90", "flywheel"):
        came = kurbel_in(*command.split(), "--machine", str(path), "-f", "csv")
        assert came.code in (0, 1, 2), came
        assert came.code == 0 or came.err.startswith("kurbel: "), came
