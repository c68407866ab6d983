"""The example handbook, "Tafeln des Kurbeltriebs": it shows all that kurbel has, and it is whole."""

from __future__ import annotations

import pytest
from places import ROOT

from kurbel.books.source import books
from kurbel.cli.asking import asked
from kurbel.examples.source import numbers_of, source_keys
from kurbel.handbook.manifest import Manifest, Part, read_manifest
from kurbel.page.layouts import LANGUAGES, layout_names
from kurbel.page.table import Table

FOLDER = ROOT / "examples" / "appendix"


@pytest.fixture(scope="module")
def manifest() -> Manifest:
    return read_manifest(str(FOLDER / "handbook.toml"))


def made(part: Part, monkeypatch: pytest.MonkeyPatch) -> object:
    monkeypatch.chdir(FOLDER)
    return asked(part.words, {**part.options, "label": part.name}).made


def test_every_layout_is_there_in_both_languages(manifest: Manifest, monkeypatch: pytest.MonkeyPatch) -> None:
    tables = [made(part, monkeypatch) for part in manifest.parts() if part.words and part.words[0] != "plot"]
    shown = {(table.layout, table.lang) for table in tables if isinstance(table, Table)}
    assert {(name, lang) for name in layout_names() for lang in LANGUAGES} <= shown


def test_every_source_is_collated_and_every_example_worked(manifest: Manifest) -> None:
    words = {part.words[:3] for part in manifest.parts()}
    collated = {one[1] for one in words if one[:1] == ("collate",)}
    worked = {one[1:] for one in words if one[:1] == ("example",)}
    assert collated == {table.key for book in books(None) for table in book.all_tables}
    assert worked == {(key, number) for key in source_keys() for number in numbers_of(key)}


@pytest.mark.slow
def test_every_kind_of_drawing_is_there(manifest: Manifest) -> None:
    drawn = " ".join(" ".join(part.words) for part in manifest.parts() if part.words[:1] == ("plot",))
    for option in (
        "--positions",
        "--forces",
        "--polar",
        "--pressures",
        "--turning",
        "--columns",
        "--mechanism",
    ):
        assert option in drawn
