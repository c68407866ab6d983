"""The handbook in Typst: its PDF read back, what it refers to, and that no title is obeyed."""

from __future__ import annotations

import csv
import io
import re
import subprocess
from collections.abc import Callable, Mapping
from dataclasses import replace
from itertools import chain
from pathlib import Path
from typing import Any

import handbook
import pages
import pytest
from everything import AWKWARD
from tools import require, require_library

import kurbel
from kurbel.documents.document import Chapter, Document, Item
from kurbel.documents.markdown import parse_prose
from kurbel.documents.prose import Heading, Index, Listing, Paragraph, Quote, Term, Text, stepwise
from kurbel.formats.documents import document_files
from kurbel.formats.pdf import Standard
from kurbel.formats.pdf.by_typst import compile_typst
from kurbel.formats.render import render
from kurbel.page.layouts import layout_names
from kurbel.page.table import Table

require_library("typst")

# What would be obeyed, were it not escaped, and more than a line.
NASTY = AWKWARD + r' ]#read("/etc/passwd") = @x <y> // /* \\u{41} #panic() ' + "lange Wörter " * 20 + "Ende"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The output folder of the sample handbook, its PDF included."""
    folder = tmp_path_factory.mktemp("handbook")
    tables = handbook.fragments("typst")
    handbook.write_folder(folder, document_files(handbook.document(), "typst", tables), tables, ".typ")
    (folder / "handbook.pdf").write_bytes(made(folder, "ua-1", "a-2b"))
    return folder


def made(folder: Path, *standards: Standard) -> bytes:
    source = (folder / "handbook.typ").read_text(encoding="utf-8")
    return compile_typst(source, root=str(folder), standards=standards)


def small(folder: Path, *items: Item, tables: Mapping[str, Table] | None = None, **changes: Any) -> bytes:
    """Return the PDF of a handbook with one chapter."""
    document = Document("Titel", "de", "comma", (Chapter("Kapitel", "kapitel", 1, items),))
    fragments = {name: render(table, "typst") for name, table in (tables or {}).items()}
    source = document_files(document._replace(**changes), "typst", fragments)["handbook.typ"]
    for name, text in fragments.items():
        (folder / "tables").mkdir(exist_ok=True)
        (folder / f"tables/{name}.typ").write_text(text, encoding="utf-8")
    return compile_typst(source, root=str(folder), standards=("ua-1", "a-2b"))


def item(name: str, table: Table, number: int = 1) -> Item:
    return Item("table", name, number, table.lang, table.caption)


def read(pdf: bytes, *options: str) -> str:
    """Return the text of a PDF, its white space as single spaces."""
    command = [require("pdftotext"), *options, "-", "-"]
    text = subprocess.run(command, input=pdf, capture_output=True, check=True).stdout.decode()
    return " ".join(text.split())


def read_pages(pdf: Path) -> list[str]:
    """Return the text of each page."""
    command = [require("pdftotext"), "-layout", str(pdf), "-"]
    text = subprocess.run(command, capture_output=True, check=True).stdout.decode()
    return [" ".join(page.split()) for page in text.rstrip("\f").split("\f")]


@pytest.fixture(scope="module")
def page_text(folder: Path) -> Callable[[int], str]:
    """The text of a page, line by line as it is printed."""
    pdf = (folder / "handbook.pdf").read_bytes()
    return lambda number: read(pdf, "-layout", "-f", str(number), "-l", str(number))


@pytest.mark.parametrize(("name", "mark"), [("weg", ","), ("path", "."), ("feinweg", ",")])
def test_tables_have_the_digits_of_the_csv(folder: Path, name: str, mark: str) -> None:
    text = read((folder / "handbook.pdf").read_bytes(), "-layout")
    rows = list(csv.reader(io.StringIO(render(handbook.table(name), "csv"))))[1:]
    lines = [" ".join(row[1:]).replace("-", "−").replace(".", mark) for row in rows]
    assert len(lines) == {"weg": 19, "path": 13, "feinweg": 181}[name]
    assert [line for line in lines if line not in text] == []


def test_references_are_in_the_language_of_the_text_and_captions_in_that_of_the_table(folder: Path) -> None:
    text = read((folder / "handbook.pdf").read_bytes())
    assert "gilt Tabelle 2. Den Verlauf zeigt Abbildung 1," in text
    assert "steht in dem Abschnitt über den Gleichgang." in text
    assert "siehe Tabelle 5 und Tabelle 3." in text
    assert "Table 3. Piston path" in text
    assert "Figure 2. The drive" in text
    assert "Tabelle 4. Kolbenweg" in text


def test_the_compiler_warns_of_nothing(folder: Path) -> None:
    from typst import Compiler

    compiler = Compiler(str(folder / "handbook.typ"), root=str(folder), ignore_system_fonts=True)
    _, warnings = compiler.compile_with_warnings(format="pdf")
    assert [warning.message for warning in warnings] == []


def test_bookmarks_are_the_chapters_and_their_sections(folder: Path) -> None:
    command = [require("pdftohtml"), "-xml", "-i", "-stdout", str(folder / "handbook.pdf")]
    told = subprocess.run(command, capture_output=True, check=True, text=True).stdout
    outline = re.findall(r'<item page="\d+">(.*?)</item>', told)
    assert outline == [
        "1 Bewegung des Kolbens, x/R",
        "1.1 Zum Gebrauch",
        "2 Gleichgang",
        "3 Beispiele und Reihen",
        "Formelzeichen",
        "Register",
    ]


def test_heads_stand_on_all_pages_but_the_first_and_those_that_begin_a_chapter(
    page_text: Callable[[int], str],
) -> None:
    head = "1 Bewegung des Kolbens, 𝑥/𝑅 Tafeln des Kurbeltriebs"
    assert page_text(1).startswith("Tafeln des Kurbeltriebs für Handbücher und Vorlesungen A. Setzer Inhalt")
    assert page_text(2).startswith("1 Bewegung des Kolbens, 𝑥/𝑅 Die Tafeln")
    assert page_text(4).startswith(head)
    assert page_text(4).endswith(" 4")
    assert not page_text(1).endswith(" 1")


def test_lists_give_numbers_captions_and_pages(page_text: Callable[[int], str]) -> None:
    text = re.sub(r"( \.)+", " ...", page_text(1))
    assert "Tabellenverzeichnis 1 Kolbenweg" in text
    assert "Abbildungsverzeichnis 1 Weg, Geschwindigkeit und Beschleunigung, 𝑅:𝐿 = 1:5 ... 4" in text


def test_a_list_stands_clear_of_the_one_before(folder: Path) -> None:
    pdf = (folder / "handbook.pdf").read_bytes()
    command = [require("pdftotext"), "-bbox", "-l", "1", "-", "-"]
    boxes = subprocess.run(command, input=pdf, capture_output=True, check=True).stdout.decode()
    words = re.findall(r'yMin="([\d.]+)" xMax="[\d.]+" yMax="([\d.]+)">([^<]*)<', boxes)
    top = next(float(top) for top, _, word in words if word == "Abbildungsverzeichnis")
    above = max(float(bottom) for other, bottom, _ in words if float(other) < top)
    # A line of the heading's own size.
    assert top - above > 18


def test_the_index_gives_the_pages_and_a_long_table_has_its_head_on_each(folder: Path) -> None:
    pages = read_pages(folder / "handbook.pdf")
    words = next(number for number, page in enumerate(pages, 1) if "hängt von der Füllung ab" in page)
    first, last = (
        next(number for number, page in enumerate(pages, 1) if caption in page.casefold())
        for caption in ("tabelle 1. ", "abbildung 1. ")
    )
    assert f"Füllung, {words}" in pages[-1]
    # Table 2 stands between them.
    assert f"Kolbenweg, {first}–{last} u. ö." in pages[-1]
    assert last == first + 2
    rows = [page for page in pages if "mm Tabelle 1" in page]
    assert len(rows) > 1
    assert all("Zeichen Größe Einheit zuerst" in page for page in rows)
    assert sum(page.count("mm Tabelle 1") for page in rows) == 90


def test_the_columns_of_an_index_end_alike_on_its_last_page(tmp_path: Path) -> None:
    words = {letter: [f"{letter}wort{number}" for number in range(50)] for letter in "ABCD"}
    groups = tuple((one, tuple(Term(word, ("kapitel",)) for word in each)) for one, each in words.items())
    pdf = small(tmp_path, Item("text", lang="de", blocks=(Index(groups),)))
    assert re.findall(r"\wwort\d+(?=, 2)", read(pdf, "-raw")) == [*chain(*words.values())]
    # The contents stand on the first page and the index on the two after it.
    command = [require("pdftotext"), "-bbox", "-f", "3", "-", "-"]
    boxes = subprocess.run(command, input=pdf, capture_output=True, check=True).stdout.decode()
    places = re.findall(r'xMin="([\d.]+)".* yMax="([\d.]+)">\wwort', boxes)
    left, right = (
        max(float(bottom) for at, bottom in places if (float(at) > 210 / 25.4 * 36) == side)
        for side in (False, True)
    )
    assert abs(left - right) < 30


def test_the_file_tells_title_author_keywords_and_language(folder: Path) -> None:
    command = [require("pdfinfo"), str(folder / "handbook.pdf")]
    told = subprocess.run(command, capture_output=True, check=True, text=True).stdout
    assert re.search(r"^Title: +Tafeln des Kurbeltriebs$", told, re.MULTILINE)
    assert re.search(r"^Author: +A. Setzer$", told, re.MULTILINE)
    assert re.search(r"^Subject: +für Handbücher und Vorlesungen$", told, re.MULTILINE)
    assert "Bewegung des Kolbens, x/R, Gleichgang" in told
    assert b"<dc:language><rdf:Bag><rdf:li>de</rdf:li>" in (folder / "handbook.pdf").read_bytes()


def test_the_handbook_complies_with_the_standards_for_readers_and_archives(folder: Path) -> None:
    pdf = (folder / "handbook.pdf").read_bytes()
    assert b"<pdfaid:part>2</pdfaid:part>" in pdf
    assert b"<pdfuaid:part>1</pdfuaid:part>" in pdf


def test_nasty_words_are_printed_as_they_are(tmp_path: Path) -> None:
    table = replace(kurbel.table("1:5", angle="0..90:30"), key="nasty", caption=NASTY)
    drawing = '<svg xmlns="http://www.w3.org/2000/svg" width="90" height="60"/>'
    (tmp_path / "figures").mkdir()
    (tmp_path / "figures/f.svg").write_text(drawing, encoding="utf-8")
    text = Item("text", blocks=(Paragraph((Text(NASTY.replace(r"\$", "$")),)),))
    chapters = (
        Chapter(NASTY, "kapitel", 1, (text, item("nasty", table), Item("figure", "f", 1, "en", NASTY))),
    )
    document = Document(NASTY, "de", "comma", chapters, NASTY, NASTY)
    pdf = small(tmp_path, tables={"nasty": table}, **document._asdict())
    printed = "".join(read(pdf).split())
    piece = '50%&$,a|b,#_{}~^\\,<script>alert(1)</script>,[x]*y*`z`--,,"q"]#read("/etc/passwd")=@x<y>///*'
    # Title, subtitle, author, contents, both lists, the chapter's title, the text, both captions.
    assert printed.count(piece) == 10
    assert "root:" not in printed


def test_the_same_handbook_is_the_same_file_elsewhere(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    import shutil
    import time

    monkeypatch.setenv("TZ", "Asia/Tokyo")
    monkeypatch.setenv("LC_ALL", "C")
    monkeypatch.chdir(tmp_path)
    time.tzset()
    elsewhere = tmp_path / "another place"
    shutil.copytree(folder, elsewhere)
    assert made(elsewhere, "ua-1", "a-2b") == (folder / "handbook.pdf").read_bytes()
    monkeypatch.undo()
    time.tzset()


def test_a_table_too_wide_to_read_stands_on_a_page_turned_on_its_side(tmp_path: Path) -> None:
    ratios = [f"1:{number}" for number in range(2, 14)]
    wide = kurbel.table(ratios, layout="kolbenwege", angle="0..180:30", label="wide")
    narrow = kurbel.table("1:5", angle="0..180:30", label="narrow")
    tables = {"narrow": replace(narrow, key="narrow"), "wide": replace(wide, key="wide")}
    text = Item("text", blocks=parse_prose("Siehe [](#wide) und [](#narrow)."))
    pdf = small(tmp_path, text, item("narrow", narrow), item("wide", wide, 2), tables=tables)
    path = tmp_path / "x.pdf"
    path.write_bytes(pdf)
    told = subprocess.run(
        [require("pdfinfo"), "-l", "9", str(path)], capture_output=True, check=True, text=True
    )
    sizes = re.findall(r"size: +(\d+)\S* x (\d+)", told.stdout)
    assert sizes == [("595", "841"), ("595", "841"), ("841", "595")]
    assert "Siehe Tabelle 2 und Tabelle 1." in read(pdf)


def test_a_handbook_without_chapters_subtitle_and_author_compiles(tmp_path: Path) -> None:
    assert "Titel Inhalt" in read(small(tmp_path, chapters=()))


@pytest.mark.slow
def test_all_layouts_make_a_handbook(tmp_path: Path) -> None:
    tables = {
        name: replace(page, key=name, layout=page.layout or page.key)
        for place, name in enumerate(layout_names())
        for page in [pages.default_page(name, ("de", "en")[place % 2])]
    }
    items = [item(name, table, number) for number, (name, table) in enumerate(tables.items(), 1)]
    text = read(small(tmp_path, *items, tables=tables))
    heads = [f"{('Tabelle', 'Table')[place % 2]} {place + 1}." for place in range(len(items))]
    assert [head for head in heads if head not in text] == []


def test_headings_skip_no_level() -> None:
    words = (Text("x"),)
    levels = [3, 1, 4, 2, 2, 6]
    above: list[int] = []
    found = stepwise(tuple(Heading(level, words) for level in levels), above)
    assert [block.level for block in found if isinstance(block, Heading)] == [1, 1, 2, 2, 2, 3]
    inner = stepwise((Quote((Heading(6, words),)), Listing(None, True, ((Heading(5, words),),))), above)
    assert inner == (Quote((Heading(3, words),)), Listing(None, True, ((Heading(3, words),),)))


def test_texts_and_chapters_have_their_own_language(tmp_path: Path) -> None:
    weg = replace(kurbel.table("1:5", angle="0..180:30"), key="weg")
    blocks = parse_prose("See [](#weg) and [](#paths), $R = 0.5$.")
    chapters = (
        Chapter("Wege", "wege", 1, (Item("text", lang="en", blocks=blocks), item("weg", weg))),
        Chapter("Paths of $1.5$", "paths", 2, (Item("text", lang="de", blocks=blocks),), "en"),
    )
    text = read(small(tmp_path, tables={"weg": weg}, chapters=chapters, decimal=""))
    assert "See Table 1 and § 2, 𝑅 = 0.5." in text
    assert "See Tabelle 1 and § 2, 𝑅 = 0,5." in text
    assert "2 Paths of 1.5" in text


def test_texts_that_skip_levels_comply_with_the_standard_for_readers(tmp_path: Path) -> None:
    blocks = stepwise(parse_prose("### Tief\n\n> ###### Tiefer\n\n# Oben\n\n- #### Liste"), [])
    assert "1.1 Tief" in read(small(tmp_path, Item("text", blocks=blocks)))
