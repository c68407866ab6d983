"""The registry of formats."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from cli import printed, refusal

import kurbel.formats
from kurbel.errors import ChoiceError
from kurbel.formats.registry import FORMATS, PageFormat, by_name, for_suffix
from kurbel.page.layouts import template_folder


def test_every_format_is_found_by_each_of_its_suffixes() -> None:
    suffixes = [suffix for entry in FORMATS.values() for suffix in entry.suffixes]
    assert len(suffixes) == len(set(suffixes)) == 13
    for entry in FORMATS.values():
        for suffix in entry.suffixes:
            assert for_suffix(f"a.b{suffix.upper()}") is entry


def test_every_page_format_has_its_templates() -> None:
    folder = Path(template_folder()) / "base"
    for entry in FORMATS.values():
        if isinstance(entry, PageFormat):
            assert (folder / f"{entry.name}.jinja").exists()
            assert (folder / f"{entry.name}.document.jinja").exists() == entry.standalone


def test_unknown_choices_are_sentences() -> None:
    with pytest.raises(ChoiceError) as caught:
        by_name("docx")
    assert str(caught.value) == (
        "format is 'docx'; it must be one of text, markdown, latex, html, typst, rst, pdf, xlsx, ods, csv,"
        " dat, json"
    )
    with pytest.raises(ChoiceError) as caught:
        for_suffix("out/page.docx")
    assert str(caught.value) == (
        "the file name 'out/page.docx' names no format; its suffix must be one of"
        " .txt, .md, .tex, .html, .htm, .typ, .rst, .pdf, .xlsx, .ods, .csv, .dat, .json;"
        " Word takes -f html through pandoc, see docs/howto/word.md"
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


# Where one of these words is no format: a text of a handbook, its section [pdf], files of printed values, a
# drawing, a library and its option; and what Python's notebooks call the shapes of a table.
OTHERS = {
    "__init__": {"pdf"},
    "books.source": {".csv"},
    "cli.handbook_list": {"text"},
    # What stands in a drawing; a page to be clicked through is a drawing, too, and so is one that moves.
    "cli.plot": {"text"},
    "cli.construct": {"text", "html"},
    "commands.drawn.film": {"html"},
    "commands.diagram.given": {".csv"},
    # A kind of option.
    "commands.options": {"text"},
    "commands.shown": {"html", ".html", ".htm", "latex", "markdown"},
    "documents.document": {"text"},
    "documents.markdown": {"html", "text"},
    "formats.documents": {"text"},
    # What is printed where nobody asks for a format.
    "formats.registry": {"text"},
    "handbook.init": {"typst"},
    "handbook.manifest": {"text", "pdf"},
    "handbook.matter.matter": {"text"},
    # The pages of notation are prose, which is written so.
    "handbook.matter.notation": {".md"},
    "handbook.model": {"text", "pdf"},
    "handbook.pages": {"text"},
    "handbook.problems": {"text"},
    "plot.lettering": {"text"},
    "plot.construct.lesson": {"html"},
    # The letters of PGF are LaTeX's.
    "plot.paper.pgf": {"latex"},
    "plot.style": {"pdf", "html"},
    # A form of the columns of sweeps, which know no tables.
    "sweeps.files.forms": {"csv", ".csv"},
    # The file in which a scheduler says where it is.
    "sweeps.work.cluster": {".json"},
}


def test_nothing_outside_of_its_folder_names_a_format() -> None:
    package = Path(kurbel.formats.__file__).parents[1]
    named: dict[str, set[str]] = {}
    for path in package.rglob("*.py"):
        parts = path.relative_to(package).with_suffix("").parts
        if not (parts[0] == "formats" and parts[1] in FORMATS):
            found = names_in(ast.parse(path.read_text(encoding="utf-8")))
            named |= {".".join(parts): found} if found else {}
    assert named == OTHERS


def names_in(module: ast.Module) -> set[str]:
    """Return the formats whose names or suffixes are words of a module, and whose folders it reads."""
    words = set(FORMATS) | {suffix for entry in FORMATS.values() for suffix in entry.suffixes}
    found = set()
    for node in ast.walk(module):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            found |= {node.value} & words
        if isinstance(node, ast.Import | ast.ImportFrom):
            source = node.module if isinstance(node, ast.ImportFrom) else None
            for name in [f"{source}.{alias.name}" if source else alias.name for alias in node.names]:
                if name.startswith("kurbel.formats."):
                    found |= {name.split(".")[2]} & set(FORMATS)
    return found


def test_the_words_of_formats_are_found_in_a_module() -> None:
    source = (
        "from kurbel.formats.latex import page\nfrom kurbel.formats import html\nx = {'typst': ['.md']}\n"
    )
    assert names_in(ast.parse(source)) == {"latex", "html", "typst", ".md"}


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
    with pytest.raises(ChoiceError, match=r"\.txt, \.tab, \.md"):
        for_suffix("page.docx")


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
@pytest.mark.parametrize("wanted", ["text", "tabs", "csv"])
def test_a_folder_of_which_no_format_is_made_is_named_in_one_sentence(
    text: str, said: str, wanted: str, tmp_path: Path
) -> None:
    (tmp_path / "tabs" / "__init__.py").write_text(text)
    answer = refusal("table", "--ratio=1:5", "-f", wanted, code=1)
    assert re.search(said, answer), answer


def test_a_format_elsewhere_is_gone_with_its_folder() -> None:
    assert "tabs" not in FORMATS
    assert len(FORMATS) == 12
