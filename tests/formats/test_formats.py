"""The registry of formats."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from cli import printed, refusal

import kurbel.formats
from kurbel.formats.registry import FORMATS, PageFormat, by_name, for_suffix
from kurbel.page.layouts import template_folder


def test_every_format_is_found_by_each_of_its_suffixes() -> None:
    suffixes = [suffix for entry in FORMATS.values() for suffix in entry.suffixes]
    assert len(suffixes) == len(set(suffixes))
    for entry in FORMATS.values():
        for suffix in entry.suffixes:
            assert for_suffix(f"a.b{suffix.upper()}") is entry


def test_every_page_format_has_its_templates() -> None:
    folder = Path(template_folder()) / "base"
    for entry in FORMATS.values():
        if isinstance(entry, PageFormat):
            assert (folder / f"{entry.name}.jinja").exists()
            assert (folder / f"{entry.name}.document.jinja").exists() == ("standalone" in entry.takes)


@pytest.mark.parametrize(("name", "german"), [("text", ","), ("latex", ","), ("csv", "."), ("json", ".")])
def test_decimal_mark_follows_the_language_on_pages_only(name: str, german: str) -> None:
    assert by_name(name).decimal_mark("de") == german
    assert by_name(name).decimal_mark("en") == "."
    assert by_name(name).decimal_mark("en", "comma") == ","


@pytest.fixture
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """A folder of formats with one, `tabs`."""
    (tmp_path / "tabs" / "base").mkdir(parents=True)
    (tmp_path / "tabs" / "__init__.py").write_text(TABS)
    (tmp_path / "tabs" / "writer.py").write_text(WRITER)
    (tmp_path / "tabs" / "base" / "tabs.jinja").write_text(
        "{% for group in page.panels[0].groups %}{% for row in group.rows %}\n"
        "{{ row|map(attribute='text')|join('\\t') }}\n{% endfor %}{% endfor %}"
    )
    monkeypatch.setattr(kurbel.formats, "__path__", [*kurbel.formats.__path__, str(tmp_path)])
    yield
    for name in ("tabs", "tabs.writer"):
        sys.modules.pop(f"kurbel.formats.{name}", None)


TABS = """
from kurbel.formats.registry import PageFormat

FORMAT = PageFormat(name="tabs", rank=15, suffixes=(".tab",), media="rows")
"""
WRITER = "from kurbel.formats.writer import PageWriter as Writer\n"


@pytest.mark.usefixtures("elsewhere")
def test_a_folder_elsewhere_is_a_format(tmp_path: Path) -> None:
    assert [*FORMATS][:3] == ["text", "tabs", "markdown"]
    target = tmp_path / "table.tab"
    printed("table", "--ratio=1:5", "--step=180", "--columns=phi,x", "-o", str(target))
    assert target.read_text() == "0\t0,0000\n180\t2,0000\n360\t0,0000\n"
    assert ".txt, .tab, .md" in refusal("table", "-o", "page.odt")


@pytest.mark.usefixtures("elsewhere")
@pytest.mark.parametrize(
    ("text", "said"),
    [
        (TABS.replace('"tabs"', '"tab"'), "the format folder tabs is 'tab'; its name must be 'tabs'"),
        (TABS.replace("rank=15, ", ""), "tabs cannot be read: TypeError: .* argument: 'rank'"),
        (
            "import no_such_module",
            "tabs cannot be read: ModuleNotFoundError: No module named 'no_such_module'",
        ),
        ("FORMAT = 1", "the format folder tabs is 1; its name must be 'tabs'"),
        ("", "tabs cannot be read: AttributeError: "),
    ],
)
def test_a_folder_of_which_no_format_is_made_is_named_in_one_sentence(
    text: str, said: str, tmp_path: Path
) -> None:
    (tmp_path / "tabs" / "__init__.py").write_text(text)
    for wanted in ("text", "tabs", "csv"):
        answer = refusal("table", "--ratio=1:5", "-f", wanted, code=1)
        assert re.search(said, answer), answer
