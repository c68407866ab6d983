"""The example handbooks, German and English: each shows all that kurbel has, in its own language alone."""

from __future__ import annotations

import json
import re
import shlex
import tomllib
from typing import Any

import pytest
from cli import kurbel, printed
from places import ROOT

from kurbel.page.layouts import layout_names

FOLDERS = {"de": "appendix", "en": "appendix-en"}


def parts(lang: str) -> list[dict[str, Any]]:
    """Return the parts of a handbook, of which none says another language."""
    text = (ROOT / "examples" / FOLDERS[lang] / "handbook.toml").read_text(encoding="utf-8")
    manifest = tomllib.loads(text)
    found = [part for chapter in manifest["chapter"] for part in chapter["part"]]
    assert {manifest["lang"]} == {one.get("lang", lang) for one in (*manifest["chapter"], *found)}
    return found


def runs(lang: str, *commands: str) -> list[list[str]]:
    words = [shlex.split(part["run"]) for part in parts(lang) if "run" in part]
    return [one for one in words if not commands or one[0] in commands]


@pytest.mark.parametrize("lang", FOLDERS)
def test_every_example_worked_and_every_drawing_drawn(lang: str) -> None:
    books = {tuple(line.split()[:2]) for line in printed("example").out.splitlines()}
    assert {tuple(one[1:3]) for one in runs(lang, "example")} == books
    drawn = " ".join(" ".join(one) for one in runs(lang) if one[0] == "plot" or "drawing" in one)
    for word in ("--positions", "forces", "--polar", "pressures", "turning", "--columns", "--mechanism"):
        assert word in drawn


def test_every_source_is_collated_and_every_layout_is_there(monkeypatch: pytest.MonkeyPatch) -> None:
    sources = re.findall(r"^    ([a-z]+-\S+)  ", printed("sources", COLUMNS="1000").out, re.MULTILINE)
    assert len(sources) > 10
    assert {one[1] for one in runs("de", "collate")} == {*sources}
    monkeypatch.chdir(ROOT / "examples" / FOLDERS["de"])
    missing = {*layout_names()} - {one[one.index("--layout") + 1] for one in runs("de") if "--layout" in one}
    # Commands with the same options have the same layout.
    asked = {
        " ".join([words[0], *(one for one in words if one.startswith("--"))]): words
        for words in runs("de")
        if words[0] != "plot" and not {"--layout", "drawing"} & {*words}
    }
    found = {json.loads(kurbel(*words, "-f", "json").out or "{}").get("table") for words in asked.values()}
    # The records of these have the names of what they are of.
    assert missing - found == {"collation", "construction", "formulas"}
    assert ["construct", "blau-9", "--table"] in runs("de")


def test_both_have_the_same_parts() -> None:
    german, english = ([[*part] for part in parts(lang)] for lang in FOLDERS)
    assert german == english
    # Words of a caption or of a drawing's file may differ, and the decimals.
    same = [[word.replace(",", ".") for word in one] for one in runs("de")], runs("en")
    assert [(a, b) for a, b in zip(*same, strict=True) if a[0] != b[0] or len(a) != len(b)] == []
