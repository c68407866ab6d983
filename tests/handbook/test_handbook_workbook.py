"""A handbook as one workbook: a sheet for each page, its contents, and builds that make only what changed."""

from __future__ import annotations

from pathlib import Path
from zipfile import ZipFile

import pytest
from cli import Result, kurbel
from manifests import chapter, run, text
from tools import require_library
from workbooks import sheets_of

WAYS = run("wege", "table --ratio 1:5 --angle 0;90", caption="=1+1")
MANIFEST = f"""\
title = "Tafeln"
author = "A. & B."
formats = ["xlsx", "ods"]
{chapter("Wege für $R:L$", text("Siehe [](#wege)."), WAYS)}
{chapter("Words", text("Nothing but words."))}
{chapter("Irregularity", run("irregularity-of-engines-with-a-long-name", "deadcentres"), lang="en")}
"""
NAMES = ["Inhalt", "Tab. 1 wege", "Table 2 irregularity-of-engines"]


@pytest.fixture(autouse=True)
def library(monkeypatch: pytest.MonkeyPatch) -> None:
    require_library("xlsxwriter")
    monkeypatch.delenv("SOURCE_DATE_EPOCH", raising=False)


def build(folder: Path, **environment: str) -> Result:
    return kurbel("handbook", "build", str(folder), "--jobs", "1", **environment)


def test_each_page_has_a_sheet_and_a_line_in_the_contents(tmp_path: Path) -> None:
    (tmp_path / "handbook.toml").write_text(MANIFEST, encoding="utf-8")
    assert "2 written, 0 unchanged" in build(tmp_path).err
    for suffix in ("xlsx", "ods"):
        sheets = sheets_of((tmp_path / f"pages/handbook.{suffix}").read_bytes())
        assert [*sheets] == NAMES
        contents, german, english = sheets.values()
        # A chapter without a table is none of a workbook.
        assert [*contents.values.values()] == [
            "Tafeln",
            "A. & B.",
            "1  Wege für R:L",
            "Tabelle 1",
            "=1+1",
            "3  Irregularity",
            "Table 2",
            english.values[0, 0].partition(": ")[2],  # type: ignore[union-attr]
        ]
        assert german.values[0, 0] == "Tabelle 1: =1+1"
        assert str(english.values[0, 0]).startswith("Table 2: Dead centres")
        assert german.row(5)[:3] == [90, 1.101, 0.899]
        assert "Inhalt" in german.values.values()
    links = ZipFile(tmp_path / "pages/handbook.xlsx").read("xl/worksheets/sheet1.xml").decode()
    assert links.count(f"location=\"'{NAMES[1]}'!A1\"") == 1


@pytest.mark.slow
def test_a_build_makes_only_what_changed_and_a_check_finds_what_is_stale(tmp_path: Path) -> None:
    manifest = tmp_path / "handbook.toml"
    manifest.write_text(MANIFEST, encoding="utf-8")
    build(tmp_path)
    made = (tmp_path / "pages/handbook.ods").read_bytes()
    assert "0 written, 2 unchanged" in build(tmp_path).err
    assert sorted(path.name for path in (tmp_path / "pages").iterdir()) == [
        ".kurbel", "contents.json", "handbook.ods", "handbook.xlsx"
    ]  # fmt: skip
    assert ".kurbel" not in (tmp_path / "pages/contents.json").read_text()
    assert kurbel("handbook", "check", str(tmp_path), "--jobs", "1").code == 0
    # Another day is another file, and the first one again the first.
    assert "2 written" in build(tmp_path, SOURCE_DATE_EPOCH="1000000000").err
    assert (tmp_path / "pages/handbook.ods").read_bytes() != made
    build(tmp_path)
    assert (tmp_path / "pages/handbook.ods").read_bytes() == made
    manifest.write_text(MANIFEST.replace("0;90", "0;60"), encoding="utf-8")
    stale = kurbel("handbook", "check", str(tmp_path), "--jobs", "1")
    assert stale.code == 1
    assert [line.rpartition("/")[2] for line in stale.out.splitlines() if not line.startswith(" ")] == [
        "handbook.ods: differs", "handbook.xlsx: differs"
    ]  # fmt: skip
    # With no workbook left, nothing waits for one.
    manifest.write_text(MANIFEST.replace('"xlsx", "ods"', '"csv"'), encoding="utf-8")
    assert "2 removed" in build(tmp_path).err
    assert not (tmp_path / "pages/.kurbel/sheets").exists()


@pytest.mark.slow
def test_a_drawing_is_a_sheet_with_its_words(tmp_path: Path) -> None:
    require_library("matplotlib")
    drawing = '[[chapter.part]]\nrun = "table --ratio 1:5 -f drawing"\nname = "bild"\n'
    (tmp_path / "handbook.toml").write_text(f"{MANIFEST}\n{drawing}", encoding="utf-8")
    assert build(tmp_path).code == 0
    for suffix, words in (("xlsx", "xl/drawings/drawing1.xml"), ("ods", "content.xml")):
        path = tmp_path / f"pages/handbook.{suffix}"
        assert [*sheets_of(path.read_bytes())][3] == "Fig. 1 bild"
        with ZipFile(path) as file:
            assert sum(name.endswith(".png") for name in file.namelist()) == 1
            assert "Piston path" in file.read(words).decode()
