"""The example handbooks, German and English: each shows all that kurbel has, in its own language alone."""

from __future__ import annotations

import pytest
from places import ROOT

from kurbel.books.examples.source import numbers_of, source_keys
from kurbel.books.source import books
from kurbel.cli.asking import asked
from kurbel.handbook.manifest import Manifest, Part, read_manifest
from kurbel.page.layouts import layout_names
from kurbel.page.table import Table

FOLDERS = {"de": "appendix", "en": "appendix-en"}


@pytest.fixture(scope="module", params=FOLDERS)
def manifest(request: pytest.FixtureRequest) -> Manifest:
    return read_manifest(str(ROOT / "examples" / FOLDERS[request.param] / "handbook.toml"))


def made(part: Part, manifest: Manifest, monkeypatch: pytest.MonkeyPatch) -> object:
    monkeypatch.chdir(manifest.folder)
    return asked(part.words, {**part.options, "label": part.name}).made


def test_every_layout_is_there_in_the_one_language(
    manifest: Manifest, monkeypatch: pytest.MonkeyPatch
) -> None:
    parts = [part for part in manifest.parts() if part.words and part.words[0] != "plot"]
    tables = [made(part, manifest, monkeypatch) for part in parts]
    shown = {(table.layout, table.lang) for table in tables if isinstance(table, Table)}
    assert {(name, manifest.lang) for name in layout_names()} <= shown
    assert {lang for _, lang in shown} == {manifest.lang}


def test_every_source_is_collated_and_every_example_worked(manifest: Manifest) -> None:
    words = {part.words[:3] for part in manifest.parts()}
    collated = {one[1] for one in words if one[:1] == ("collate",)}
    worked = {one[1:] for one in words if one[:1] == ("example",)}
    assert collated == {table.key for book in books(None) for table in book.all_tables}
    assert worked == {(key, number) for key in source_keys() for number in numbers_of(key)}


def test_both_have_the_same_chapters_of_the_same_parts() -> None:
    german, english = (
        [
            [part.words and part.words[0] for part in chapter.parts]
            for chapter in read_manifest(str(ROOT / "examples" / folder / "handbook.toml")).chapters
        ]
        for folder in FOLDERS.values()
    )
    assert german == english


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
