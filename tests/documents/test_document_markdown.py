"""The Markdown of a handbook, as GitHub reads it: every link leads somewhere, every cell is the table's."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cache

import pytest
from handbook import FIGURES, TABLES, document, fragments, table
from markdown_it import MarkdownIt
from markdown_it.token import Token
from page_formats import page_format

from kurbel.documents.document import Chapter, Document, Item
from kurbel.documents.markdown import parse_prose
from kurbel.errors import ChoiceError
from kurbel.formats.documents import document_files
from kurbel.formats.page import page
from kurbel.page.labels import plain

READER = MarkdownIt("gfm-like", {"linkify": False})


@cache
def pages() -> dict[str, str]:
    return document_files(document(), "markdown", fragments("markdown"))


def inlines(text: str) -> Iterator[Token]:
    for token in READER.parse(text):
        yield from token.children or ()


def links(text: str) -> list[str]:
    return [str(one.attrs["href"]) for one in inlines(text) if one.type == "link_open"]


def anchors(text: str) -> list[str]:
    return [
        found[1]
        for one in inlines(text)
        if one.type == "html_inline" and (found := re.fullmatch(r'<a id="([^"<>]+)">', one.content))
    ]


def words(text: str) -> str:
    """Return what a reader sees of a page, without its tables' layout."""
    blocks = ("".join(map(_seen, token.children or ())) for token in READER.parse(text))
    return " ".join(" ".join(blocks).split())


def _seen(token: Token) -> str:
    if token.type in ("text", "code_inline"):
        return token.content
    return " " if token.type in ("softbreak", "hardbreak") else ""


def test_there_is_an_index_and_a_page_for_each_chapter() -> None:
    assert list(pages()) == [
        "markdown/index.md",
        "markdown/01-bewegung.md",
        "markdown/02-gleichgang.md",
        "markdown/03-beispiele.md",
        "markdown/04-zeichen.md",
        "markdown/04-register.md",
    ]


def test_every_link_leads_to_an_anchor_and_every_anchor_is_there_once() -> None:
    there = {(path, name) for path, text in pages().items() for name in ("", *anchors(text))}
    assert {name for _, name in there} == {
        "",
        *(f"tab-{name}" for name in TABLES),
        *(f"fig-{name}" for name in FIGURES),
        *(f"sec-{chapter.name}" for chapter in document().chapters),
    }
    for path, text in pages().items():
        assert len(anchors(text)) == len(set(anchors(text)))
        assert len(links(text)) >= 2
        for link in links(text):
            file, _, anchor = link.partition("#")
            target = posixpath.normpath(posixpath.join(posixpath.dirname(path), file or path))
            assert (target, anchor) in there, link


def test_the_index_names_every_table_and_figure() -> None:
    text = words(pages()["markdown/index.md"])
    assert text.startswith("Tafeln des Kurbeltriebs für Handbücher und Vorlesungen A. Setzer Inhalt Bewegung")
    for number, name in enumerate(TABLES, 1):
        word = "Table" if table(name).lang == "en" else "Tabelle"
        mark = "." if word == "Table" else ","
        assert f"{word} {number}: {plain(table(name).caption, mark)}" in text
    assert "Figure 2: The drive at φ = 30°" in text


def test_references_have_the_number_of_what_they_name() -> None:
    text = pages()["markdown/02-gleichgang.md"]
    assert "siehe Tabelle 5 und Tabelle 3." in words(text)
    assert links(text)[:2] == ["02-gleichgang.md#tab-delta", "01-bewegung.md#tab-path"]


def test_a_reference_to_nothing_is_answered_with_the_nearest_name() -> None:
    chapter = Chapter("Eins", "eins", 1, (Item("text", blocks=parse_prose("[](#einz)")),))
    with pytest.raises(ChoiceError, match=r'^there is no .* "einz" \(did you mean eins\?\)'):
        document_files(Document("T", "de", "comma", (chapter,)), "markdown", {})


def test_headings_of_texts_stand_right_below_that_of_the_chapter() -> None:
    text = Item("text", blocks=parse_prose("# Eins\n\n## Zwei"))
    pages = Document("T", "de", "comma", (Chapter("Kapitel", "k", 1, (text,)),))
    page = document_files(pages, "markdown", {})["markdown/01-k.md"]
    assert re.findall(r"^#.*", page, re.MULTILINE) == ["# Kapitel", "## Eins", "### Zwei"]
    appendix = document_files(pages, "latex", {})["appendix.tex"]
    assert r"\subsection{Eins}" in appendix
    assert r"\subsubsection{Zwei}" in appendix


def test_every_cell_is_the_tables() -> None:
    text = "\n".join(pages().values())
    rows: list[list[str]] = []
    for token in READER.parse(text):
        if token.type == "tr_open":
            rows.append([])
        elif token.type == "inline" and rows and token.level > 3:
            rows[-1].append("".join(one.content for one in token.children or () if one.type == "text"))
    found = {tuple(row) for row in rows}
    form = page_format("text")
    for name in ("weg", "path", "feinweg", "delta"):
        ready = page(table(name), form.writer, form.decimal_mark(table(name).lang))
        for panel in ready.panels:
            for group in panel.groups:
                for row in group.rows:
                    assert tuple(cell.text.replace("\u00a0", " ") for cell in row) in found


def test_a_page_leads_to_its_neighbours() -> None:
    last_lines = [list(words(text.rpartition("---")[2]).split(" · ")) for text in list(pages().values())[1:]]
    assert last_lines == [
        ["Inhalt", "Gleichgang →"],
        ["← Bewegung des Kolbens, x/R", "Inhalt", "Beispiele und Reihen →"],
        ["← Gleichgang", "Inhalt", "Formelzeichen →"],
        ["← Beispiele und Reihen", "Inhalt", "Register →"],
        ["← Formelzeichen", "Inhalt"],
    ]


NASTY = (
    r"\input{/etc/passwd} \$x # y #",
    '<script>alert(1)</script> "q" <!-- c -->',
    "[a](javascript:alert) ![b](http://c) | % & &amp; _d_ ^ ~~e~~ `f`",
    "1. - * + > Größe φ *y* **z** \\\\ [^",
    "Wort " * 60,
)


def test_what_the_manifest_says_is_printed_and_not_obeyed() -> None:
    figure = Item("figure", "f", 1, "de", NASTY[2])
    chapters = tuple(Chapter(words, f"c{place}", place, (figure,)) for place, words in enumerate(NASTY, 1))
    made = document_files(Document(NASTY[1], "de", "comma", chapters, NASTY[3], NASTY[0]), "markdown", {})
    shown = {path: words(text) for path, text in made.items()}
    for text in (*NASTY[:4], NASTY[4].strip()):
        printed = " ".join(plain(text).split())
        assert printed in shown["markdown/index.md"], text
    for place, text in enumerate(NASTY, 1):
        assert shown[f"markdown/0{place}-c{place}.md"].startswith(" ".join(plain(text).split()))
    for path, text in made.items():
        assert all(re.match(r"(0[1-5]-c[1-5]|index)\.md", link) for link in links(text)), path
        html = [one.content for one in inlines(text) if one.type == "html_inline"]
        assert all(re.fullmatch(r'<a id="(sec|fig)-[a-z0-9]+">|</a>', one) for one in html)
        assert not [one for one in READER.parse(text) if one.type == "html_block" and "script" in one.content]
        pictures = [one for one in inlines(text) if one.type == "image"]
        assert [one.attrs["src"] for one in pictures] == ([] if "index" in path else ["../figures/f.svg"])
