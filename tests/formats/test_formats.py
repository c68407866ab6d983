"""The registry of formats."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from kurbel.errors import ChoiceError
from kurbel.formats.format import PageFormat
from kurbel.formats.registry import FORMATS, by_name, for_suffix


def test_every_format_is_found_by_each_of_its_suffixes() -> None:
    suffixes = [suffix for entry in FORMATS.values() for suffix in entry.suffixes]
    assert len(suffixes) == len(set(suffixes)) == 10
    for entry in FORMATS.values():
        for suffix in entry.suffixes:
            assert for_suffix(f"a.b{suffix.upper()}") is entry


def test_every_page_format_is_a_folder_with_its_templates() -> None:
    for entry in FORMATS.values():
        if isinstance(entry, PageFormat):
            folder = Path(entry.templates)
            assert folder.parent.name == entry.name
            # Plain text is a grid and no template.
            assert (folder / f"{entry.name}.jinja").exists() == (entry.name != "text")
            assert (folder / f"{entry.name}.document.jinja").exists() == entry.standalone


def test_unknown_choices_are_sentences() -> None:
    with pytest.raises(ChoiceError) as caught:
        by_name("docx")
    assert str(caught.value) == (
        "format is 'docx'; it must be one of text, markdown, latex, html, typst, rst, pdf, csv, json"
    )
    with pytest.raises(ChoiceError) as caught:
        for_suffix("out/page.docx")
    assert str(caught.value) == (
        "the file name 'out/page.docx' names no format; its suffix must be one of"
        " .txt, .md, .tex, .html, .htm, .typ, .rst, .pdf, .csv, .json"
    )
    with pytest.raises(ChoiceError) as caught:
        by_name("text").decimal_mark("de", "semicolon")
    assert str(caught.value) == "decimal mark is 'semicolon'; it must be comma or point"


@pytest.mark.parametrize(("name", "german"), [("text", ","), ("latex", ","), ("csv", "."), ("json", ".")])
def test_decimal_mark_follows_the_language_on_pages_only(name: str, german: str) -> None:
    assert by_name(name).decimal_mark("de") == german
    assert by_name(name).decimal_mark("en") == "."
    assert by_name(name).decimal_mark("en", "comma") == ","


def test_registry_is_cheap_to_import() -> None:
    code = (
        "import sys, kurbel.formats;"
        "print({'jinja2', 'numpy', 'json', 'csv', 'kurbel.page.formula'} & set(sys.modules))"
    )
    assert subprocess.check_output([sys.executable, "-c", code], text=True) == "set()\n"
