"""reStructuredText: docutils and Sphinx read it without a warning and show all characters and spans."""

from __future__ import annotations

import io
import re
import shlex
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import manifests
import pytest
from docutils import nodes
from docutils.core import publish_doctree, publish_string
from docutils.parsers.rst import roles
from docutils.utils import unescape
from hypothesis import example, given, settings
from hypothesis import strategies as st
from page_formats import page_format
from pages import command, default_page
from prose_sample import SAMPLE, TEXTS, Parts, parsed, shown
from readers import model_cells

from kurbel.formats.documents import set_prose
from kurbel.formats.render import render
from kurbel.formats.rst.writer import GridCell, escape, finish, grid_lines, role
from kurbel.page.formula import FUNCTIONS, GREEK, SIGNS, SYMBOLS, parse_formula
from kurbel.page.layouts import LANGUAGES, layout_names
from kurbel.page.table import head_rows


def _reference(name: str, raw: str, text: str, *others: Any, **more: Any) -> Any:
    """Stand in for the role of Sphinx, which docutils does not have."""
    return [nodes.inline(raw, unescape(text).split(" <")[0])], []


@pytest.fixture(scope="module", autouse=True)
def _role_of_sphinx() -> None:
    roles.register_local_role("ref", _reference)


def read(source: str) -> nodes.document:
    """Return the document as docutils reads it; a warning fails."""
    said = io.StringIO()
    options = {
        "warning_stream": said,
        "_disable_config": True,
        "doctitle_xform": False,
        "file_insertion_enabled": False,
    }
    document: nodes.document = publish_doctree(source, settings_overrides=options)
    assert said.getvalue() == "", source
    for remark in [*document.findall(nodes.system_message)]:
        remark.parent.remove(remark)
    return document


def letters(node: nodes.Node) -> str:
    return "".join(node.astext().split())


def prose(text: str) -> str:
    return set_prose(parsed(text), page_format("rst"), ",", Parts("rst"))


_PRINTED = st.text(st.characters(exclude_categories=("C", "Zl", "Zp")))
# What docutils itself puts there, or takes away: marks of lists, the words of links.
_LIST = re.compile(r"<(?:li|ol|ul|hr|pre|a)\b")


@example("```")
@example("    \xa0")
@example("a::\n\nhttp://b.c/d mailto:e@f\n\n.. g\n\n>>> h\n\n|i| j_ [k]_")
@example("a[](#delta)b *[](#drive)* `` c`` [](#start)")
@example("[](HTTP:)0")
@example("\\\\\\")
@example("=&#10;=")
@example("`\\ :`")
@example("0|0\n-|-")
@example("```0\u00a0```")
@example("a *b*c **d *e*** `` `f ``g")
@example("- a\n\n> b\n\n> c\n\n1. d\n\n\n1) e")
@example('# x `a\tb` y\n\n`c\td` `e`\n\n| `f\tg` | h |\n|-|-|\n| `i\tj` | $"k\tl"$ |')
@example("```\na\u2028b\u2029c\n```\n\n# `d\u2028e`\n\n- `f\u2029g`\n\nh\u2028i")
@settings(max_examples=100, deadline=None)
@given(TEXTS)
def test_any_text_is_read_without_a_warning_and_shows_its_characters(text: str) -> None:
    text = text.replace("$", "")
    if blocks := parsed(text):
        seen = letters(read(prose(text)))
        page = set_prose(blocks, page_format("html"), ",", Parts("html"))
        if not _LIST.search(page):
            assert seen == shown(page)


@given(_PRINTED, _PRINTED)
def test_prose_beside_markup_is_printed_as_it_is(before: str, after: str) -> None:
    before, after = (" ".join(text.split()) for text in (before, after))
    source = finish(escape(before) + role("sup", "x") + escape(after))
    assert letters(read(f"Wort {source}\n")) == "".join(f"Wort{before}x{after}".split())


def test_docutils_makes_mathml_of_every_sign_of_a_formula() -> None:
    functions = [f"{name} x" for name in FUNCTIONS]
    sums, values = [f"a {sign} b" for sign in SIGNS], [f"a + {symbol}" for symbol in SYMBOLS if symbol != '"']
    shapes = ["[(1 + x)/(sqrt(2))]^2", 'x_(max) = 1.5 "m/s"']
    formulas = [*GREEK, *functions, *sums, *values, *shapes]
    lines = [
        finish(page_format("rst").writer.formula(parse_formula(one), ",", display=True)) for one in formulas
    ]
    said = io.StringIO()
    options = {"warning_stream": said, "_disable_config": True, "math_output": "MathML"}
    page = publish_string("\n\n".join(lines), writer="html5", settings_overrides=options).decode()
    assert said.getvalue() == ""
    assert page.count("<math ") == len(formulas)
    assert ">…</m" in page


def test_escaped_spaces_stand_only_where_markup_would_join_its_neighbours() -> None:
    x, sup = role("math", "x"), role("sup", "a)")
    assert finish(x) == ":math:`x`"
    assert finish(f"Weg {x}, a") == "Weg :math:`x`, a"
    assert finish(f"({x}): 0,5{sup}") == "(:math:`x`): 0,5\\ :sup:`a)`"
    assert finish(f"a{x}{sup}b") == r"a\ :math:`x`\ :sup:`a)`\ b"


def test_sample_has_all_its_blocks() -> None:
    document = read(prose(SAMPLE))
    kinds = (nodes.section, nodes.bullet_list, nodes.enumerated_list, nodes.block_quote, nodes.literal_block)
    counts = [len([*document.findall(kind)]) for kind in kinds]
    # Two lists in a row stay two.
    assert counts == [2, 2, 2, 2, 2]
    (numbered,) = (one for one in document.findall(nodes.enumerated_list) if one.get("start"))
    assert numbered["start"] == 7
    assert 'if (a < b) { x = "y"; }  # 100 %\n    weiter' in document.astext()


@pytest.mark.parametrize("wide", ["字", "Ａ"])
def test_grid_of_cells_of_any_extent(wide: str) -> None:
    cells = [
        GridCell(0, 0, ("a", "b"), down=2),
        GridCell(0, 1, ("wide",), across=2),
        GridCell(1, 1, ("c",)),
        GridCell(1, 2, ("",)),
        GridCell(2, 0, (wide,)),
        GridCell(2, 1, ("1",), right=True),
        GridCell(2, 2, ("e\u0301",)),
    ]
    assert grid_lines(cells, 2) == [
        "+----+-------+",
        "| a  | wide  |",
        "| b  +---+---+",
        "|    | c |   |",
        "+====+===+===+",
        f"| {wide} | 1 | e\u0301 |",
        "+----+---+---+",
    ]


@pytest.mark.parametrize(("place", "name"), [*enumerate(layout_names()[::2])])
def test_cells_and_spans_are_those_of_the_model(place: int, name: str) -> None:
    table = default_page(name, LANGUAGES[place % 2])
    groups = [*read(render(table, "rst", decimal="comma")).findall(nodes.tgroup)]
    assert len(groups) == len(table.panels)
    for panel, group in zip(table.panels, groups, strict=True):
        head, body = (next(group.findall(kind)) for kind in (nodes.thead, nodes.tbody))
        spans = [[_extent(entry) for entry in row.findall(nodes.entry)] for row in head.findall(nodes.row)]
        assert spans == [[(cell.across, cell.down) for cell in row] for row in head_rows(panel)]
        rows = iter([*row.findall(nodes.entry)] for row in body.findall(nodes.row))
        for part, texts in zip(panel.groups, model_cells(panel), strict=True):
            if part.label:
                (label,) = next(rows)
                assert _extent(label) == (len(panel.stub + panel.columns), 1)
            for row, expected in zip(part.rows, texts, strict=True):
                _assert_figures(next(rows), expected, len(row.stub))


def _extent(entry: nodes.entry) -> tuple[int, int]:
    return entry.get("morecols", 0) + 1, entry.get("morerows", 0) + 1


def _assert_figures(entries: list[nodes.entry], expected: list[str], stubs: int) -> None:
    """Compare the figures of a row; formulas are set otherwise, and what a row shares stands above it."""
    for entry, text in zip(entries[::-1], expected[::-1], strict=False):
        if re.fullmatch(r"[−0-9,]+", text):
            assert letters(entry) == text
    assert len(expected) - stubs <= len(entries) <= len(expected)


# Sphinx, once for all that it reads.


def everything() -> str:
    """The manifest of the sample with every page in both languages, and with the sample of texts."""
    names = {"#delta": "#solve-de", "#drive": "#stellung", "#start": "#gleichgang"}
    words = re.sub("|".join(names), lambda found: names[found[0]], SAMPLE)
    pages = [
        manifests.run(f"{name}-{lang}", shlex.join(command(name)), lang=lang)
        for lang in LANGUAGES
        for name in layout_names()
    ]
    every = manifests.chapter("Alle Tafeln: *_`", manifests.text(words), *pages, name="alle")
    few = re.sub(r"\[pdf\].*\n.*", "", re.sub("formats = .*", 'formats = ["rst"]', manifests.SAMPLE))
    return re.sub("title = .*", "title = \"Tafeln 'der' Kurbel, $x/R$\"", few, count=1) + every


def built(folder: Path) -> Path:
    """Build a handbook of every page by Sphinx, without a warning, and return the folder of its pages."""
    pages = manifests.built(folder, everything())
    words = ("-m", "sphinx", "-W", "--keep-going", "-n", "-q", "-b", "html", "rst", "site")
    done = subprocess.run([sys.executable, *words], cwd=pages, capture_output=True, text=True)
    assert (done.returncode, done.stderr, done.stdout) == (0, "", "")
    return pages / "site"


class Page(HTMLParser):
    """The ids of a page, what its links lead to, and its text."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.ids: set[str] = set()
        self.links: dict[str, str] = {}
        self.link = ""
        self.text = ""
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        self.ids.add(given.get("id") or "")
        self.link = (given.get("href") or "") if tag == "a" else self.link

    def handle_data(self, data: str) -> None:
        self.text += data
        self.links.setdefault(data.strip(), self.link)


@pytest.mark.slow
def test_sphinx_builds_every_page_and_its_references_lead_to_their_parts(tmp_path: Path) -> None:
    site = built(tmp_path)
    first = Page(site / "01-bewegung.html")
    assert first.links["Tabelle 2"] == "#tab-zusammenstellung"
    assert first.links["dem Abschnitt über den Gleichgang"] == "02-gleichgang.html#sec-gleichgang"
    assert {"tab-weg", "fig-kurven", "sec-bewegung"} <= first.ids
    assert "Tabelle 1. Kolbenweg" in first.text
    assert "Abbildung 1. Kolbenweg, Kolbengeschwindigkeit" in first.text
    every = Page(site / "04-alle.html")
    assert {f"tab-{name}-{lang}" for name in layout_names() for lang in LANGUAGES} <= every.ids
    assert every.links["die Skizze"] == "02-gleichgang.html#fig-stellung"
    index = Page(site / "index.html")
    assert index.links["2. Gleichgang"] == "02-gleichgang.html"
    assert index.links["Tabelle 5"] == "02-gleichgang.html#tab-delta"
    assert index.links["Figure 2"] == "02-gleichgang.html#fig-stellung"
    assert "Tafeln 'der' Kurbel, x/R" in index.text
    assert (site / "_static/kurbel.css").read_text().count("nth-last-child") == 30


def document(folder: Path, *chapters: str, **keys: str) -> Path:
    """Build a handbook in reStructuredText, and return the folder of its pages."""
    top = manifests.keys_of(**({"title": "Buch"} | keys))
    return manifests.built(folder, f'{top}formats = ["rst"]\n{"".join(chapters)}') / "rst"


def test_document_names_its_captions_for_those_who_do_not_see_the_figure(tmp_path: Path) -> None:
    figure = manifests.run("stellung", "plot --positions 30 --ratio 1:5", caption="The drive at $φ = 30°$")
    pages = document(tmp_path, manifests.chapter("Kurz", figure))
    assert {path.name for path in pages.iterdir()} == {"index.rst", "conf.py", "kurbel.css", "01-kurz.rst"}
    text = (pages / "01-kurz.rst").read_text(encoding="utf-8")
    assert re.findall(":alt: (.*)", text) == ["The drive at φ = 30°"]
    compile((pages / "conf.py").read_text(encoding="utf-8"), "conf.py", "exec")


def test_blanks_around_a_title_are_not_printed(tmp_path: Path) -> None:
    blank = manifests.chapter(" $x/R$ Kopf ", manifests.text("Wort"))
    pages = document(tmp_path, blank, title=" Buch ", subtitle=" Unter", author=" Wer")
    texts = [path.read_text(encoding="utf-8") for path in (pages / "index.rst", *pages.glob("01-*.rst"))]
    seen = [read(text.split(".. toctree")[0]) for text in texts]
    assert [title.astext() for one in seen for title in one.findall(nodes.title)] == ["Buch", "x/R Kopf"]
    assert not [quote for one in seen for quote in one.findall(nodes.block_quote)]


def test_headings_in_lists_and_quotations_are_no_sections(tmp_path: Path) -> None:
    text = manifests.text("> ## a\n\n### b\n\n- # c\n\n#### d\n\n# e")
    source = (document(tmp_path, manifests.chapter("Kopf", text)) / "01-kopf.rst").read_text(encoding="utf-8")
    seen = read(f"Buch\n####\n\n{source}")
    assert [title.astext() for title in seen.findall(nodes.rubric)] == ["a", "c"]
    assert [title.astext() for title in seen.findall(nodes.title)] == ["Buch", "Kopf", "b", "d", "e"]
