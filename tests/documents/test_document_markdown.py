"""The Markdown of a handbook, as GitHub reads it: every link leads somewhere, every cell is the table's."""

from __future__ import annotations

import csv
import io
import posixpath
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from manifests import CHAPTERS, ENGLISH, FIGURES, TABLES, built, chapter, keys_of, run
from markdown_it import MarkdownIt
from markdown_it.token import Token

from kurbel.page.labels import plain

READER = MarkdownIt("gfm-like", {"linkify": False})


def pages_in(folder: Path) -> dict[str, str]:
    return {path.name: path.read_text(encoding="utf-8") for path in sorted(folder.glob("markdown/*.md"))}


@pytest.fixture(scope="module")
def pages(sample: Path) -> dict[str, str]:
    return pages_in(sample)


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


def test_every_link_leads_to_an_anchor_and_every_anchor_is_there_once(pages: dict[str, str]) -> None:
    there = {(path, name) for path, text in pages.items() for name in ("", *anchors(text))}
    assert {name for _, name in there if not name.startswith("at-")} == {
        "",
        *(f"tab-{name}" for name in TABLES),
        *(f"fig-{name}" for name in FIGURES),
        *(f"sec-{name}" for name in (*CHAPTERS, "symbols", "index")),
    }
    for path, text in pages.items():
        assert len(anchors(text)) == len(set(anchors(text)))
        assert len(links(text)) >= 2
        for link in links(text):
            file, _, anchor = link.partition("#")
            assert (posixpath.normpath(file or path), anchor) in there, link
    # Each page leads to its neighbours.
    last_lines = [words(text.rpartition("---")[2]) for name, text in pages.items() if name != "index.md"]
    assert last_lines == [
        "Inhalt · Bewegung des Kolbens, x/R →",
        "← Formelzeichen · Inhalt · Gleichgang →",
        "← Bewegung des Kolbens, x/R · Inhalt · Beispiele und Reihen →",
        "← Gleichgang · Inhalt · Register →",
        "← Beispiele und Reihen · Inhalt",
    ]


def test_the_index_names_every_table_and_references_have_their_numbers(
    sample: Path, pages: dict[str, str]
) -> None:
    text = words(pages["index.md"])
    assert text.startswith("Tafeln des Kurbeltriebs für Handbücher und Vorlesungen A. Setzer Inhalt Formel")
    for number, name in enumerate(TABLES, 1):
        word = "Table" if name in ENGLISH else "Tabelle"
        (page,) = [page for page in pages.values() if f'<a id="tab-{name}">' in page]
        assert f"{word} {number}: " in text
        assert f"{word} {number}" in page
    assert "Figure 2: Crank drive for R:L = 1:5" in text
    # Headings of texts stand right below that of the chapter.
    assert "\n## Zum Gebrauch\n" in pages["01-bewegung.md"]
    assert "\\subsection{Zum Gebrauch}" in (sample / "appendix.tex").read_text(encoding="utf-8")
    assert "<h3>Zum Gebrauch</h3>" in (sample / "handbook.html").read_text(encoding="utf-8")
    second = pages["02-gleichgang.md"]
    assert "siehe Tabelle 5 und Tabelle 3." in words(second)
    assert links(second)[:2] == ["02-gleichgang.md#tab-delta", "01-bewegung.md#tab-path"]


def test_every_number_is_the_tables(sample: Path, pages: dict[str, str]) -> None:
    rows: list[list[str]] = []
    for token in READER.parse("\n".join(pages.values())):
        if token.type == "tr_open":
            rows.append([])
        elif token.type == "inline" and rows and token.level > 3:
            rows[-1].append("".join(one.content for one in token.children or () if one.type == "text"))
    found = {tuple(row) for row in rows}
    for name, count in {"weg": 19, "path": 13, "feinweg": 181}.items():
        text = (sample / f"tables/{name}.csv").read_text()
        lines = [row[1:] for row in csv.reader(io.StringIO(text))][1:]
        mark = "." if name in ENGLISH else ","
        assert len(lines) == count
        for line in lines:
            assert tuple(cell.replace("-", "−").replace(".", mark) for cell in line) in found


NASTY = (
    r"\input{/etc/passwd} \$x # y #",
    '<script>alert(1)</script> "q" <!-- c -->',
    "[a](javascript:alert) ![b](http://c) | % & &amp; _d_ ^ ~~e~~ `f`",
    "1. - * + > Größe φ *y* **z** \\\\ [^",
    "Wort " * 60,
)


def test_what_the_manifest_says_is_printed_and_not_obeyed(tmp_path: Path) -> None:
    chapters = [
        chapter(words, run(f"f{place}", "table -f drawing", caption=NASTY[2]), name=f"c{place}")
        for place, words in enumerate(NASTY, 1)
    ]
    top = keys_of(title=NASTY[1], subtitle=NASTY[3], author=NASTY[0])
    made = pages_in(built(tmp_path, f'{top}formats = ["markdown"]\n{"".join(chapters)}'))
    shown = {path: words(text) for path, text in made.items()}
    printed = [" ".join(plain(text).split()) for text in NASTY]
    for place, text in enumerate(printed, 1):
        assert text in shown["index.md"], text
        assert shown[f"0{place}-c{place}.md"].startswith(text)
    for path, text in made.items():
        assert all(re.match(r"(0[1-5]-c[1-5]|index)\.md", link) for link in links(text)), path
        html = [one.content for one in inlines(text) if one.type == "html_inline"]
        assert all(re.fullmatch(r'<a id="(sec|fig)-[a-z0-9]+">|</a>', one) for one in html)
        assert not [one for one in READER.parse(text) if one.type == "html_block" and "script" in one.content]
        pictures = [one.attrs["src"] for one in inlines(text) if one.type == "image"]
        assert pictures == ([] if "index" in path else [f"../figures/f{path[1]}.svg"])
