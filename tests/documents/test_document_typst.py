"""The handbook in Typst: its PDF read back, what it refers to, and that no title is obeyed."""

from __future__ import annotations

import csv
import io
import re
import shutil
import time
from pathlib import Path

import pytest
from cli import printed
from everything import AWKWARD
from manifests import ENGLISH, built, chapter, keys_of, pages_of, run, text, told
from tools import require_library

from kurbel.page.layouts import layout_names

require_library("typst")

# What would be obeyed, were it not escaped, and more than a line.
NASTY = AWKWARD + r' ]#read("/etc/passwd") = @x <y> // /* \\u{41} #panic() ' + "lange Wörter " * 20 + "Ende"
PIECE = '50%&$,a|b,#_{}~^\\,<script>alert(1)</script>,[x]*y*`z`--,,"q"]#read("/etc/passwd")=@x<y>///*'
TOP = 'title = "Titel"\nformats = ["pdf"]\n'
STANDARDS = '[pdf]\nstandards = ["ua-1", "a-2b"]\n'


def pdf_of(folder: Path, *chapters: str, top: str = TOP) -> Path:
    """Return the PDF of a handbook of these chapters."""
    return built(folder, f"{top}{STANDARDS}{''.join(chapters)}") / "handbook.pdf"


def read(pdf: Path, *options: str) -> str:
    """Return the text of a PDF, its white space as single spaces."""
    return " ".join(told("pdftotext", pdf, *options).split())


@pytest.fixture(scope="module")
def pages(sample: Path) -> list[str]:
    return pages_of(sample / "handbook.pdf")


def test_tables_have_the_digits_of_the_csv(sample: Path, pages: list[str]) -> None:
    whole = " ".join(pages)
    for name, count in {"weg": 19, "path": 13, "feinweg": 181}.items():
        rows = [*csv.reader(io.StringIO((sample / f"tables/{name}.csv").read_text()))][1:]
        mark = "." if name in ENGLISH else ","
        lines = [" ".join(row[1:]).replace("-", "−").replace(".", mark) for row in rows]
        assert len(lines) == count
        assert [line for line in lines if line not in whole] == []


def test_references_are_in_the_language_of_the_text_and_captions_in_that_of_the_table(sample: Path) -> None:
    whole = read(sample / "handbook.pdf")
    assert "gilt Tabelle 2. Den Verlauf zeigt Abbildung 1," in whole
    assert "steht in dem Abschnitt über den Gleichgang." in whole
    assert "siehe Tabelle 5 und Tabelle 3." in whole
    assert "Table 3. Piston path" in whole
    assert "Figure 2. Crank drive" in whole
    assert "Tabelle 4. Kolbenweg" in whole


def test_the_compiler_warns_of_nothing(sample: Path) -> None:
    from typst import Compiler

    compiler = Compiler(str(sample / "handbook.typ"), root=str(sample), ignore_system_fonts=True)
    _, warnings = compiler.compile_with_warnings(format="pdf")
    assert [warning.message for warning in warnings] == []


def test_bookmarks_heads_and_lists_are_those_of_the_chapters(sample: Path, pages: list[str]) -> None:
    outline = told("pdftohtml", sample / "handbook.pdf", "-xml", "-i", "-stdout")
    assert re.findall(r'<item page="\d+">(.*?)</item>', outline) == [
        "Formelzeichen",
        "1 Bewegung des Kolbens, x/R",
        "1.1 Zum Gebrauch",
        "2 Gleichgang",
        "3 Beispiele und Reihen",
        "Register",
    ]
    assert pages[0].startswith("Tafeln des Kurbeltriebs für Handbücher und Vorlesungen A. Setzer Inhalt")
    assert not pages[0].endswith(" 1")
    first = next(
        number for number, page in enumerate(pages) if page.startswith("1 Bewegung des Kolbens, 𝑥/𝑅 Die")
    )
    # The head is not on the page that begins a chapter.
    assert pages[first + 1].startswith("1 Bewegung des Kolbens, 𝑥/𝑅 Tafeln des Kurbeltriebs")
    assert pages[first + 1].endswith(f" {first + 2}")
    listed = re.sub(r"( \.)+", " ...", " ".join(pages[:2]))
    assert "Tabellenverzeichnis 1 Kolbenweg" in listed
    figure = next(number for number, page in enumerate(pages, 1) if "Abbildung 1. " in page)
    assert "Abbildungsverzeichnis 1 Kolbenweg, Kolbengeschwindigkeit und" in listed
    assert f"genaue Formeln ... {figure} 2 Crank drive" in listed
    boxes = told("pdftotext", sample / "handbook.pdf", "-bbox", "-l", "1")
    words = re.findall(r'yMin="([\d.]+)" xMax="[\d.]+" yMax="([\d.]+)">([^<]*)<', boxes)
    top = next(float(top) for top, _, word in words if word == "Tabellenverzeichnis")
    # A list stands clear of the one before by a line of the heading's own size.
    assert top - max(float(bottom) for other, bottom, _ in words if float(other) < top) > 18


def test_the_index_gives_the_pages_and_a_long_table_has_its_head_on_each(pages: list[str]) -> None:
    def place(words: str) -> int:
        return next(number for number, page in enumerate(pages, 1) if words in page)

    assert f"Füllung, {place('hängt von der Füllung ab')}" in pages[-1]
    tables = [place(f"{name}. ") for name in ("Tabelle 1", "Abbildung 1", "Table 3", "Tabelle 4")]
    assert tables == sorted(tables)
    entry = re.search(r"Kolbenweg, ([\d–, ]+\d)", pages[-1])
    assert entry
    named = {
        number
        for part in entry[1].split(", ")
        for ends in [[int(one) for one in part.split("–")]]
        for number in range(ends[0], ends[-1] + 1)
    }
    assert {tables[0], tables[2], tables[3]} <= named
    rows = [page for page in pages if "Zeichen Größe Einheit zuerst" in page]
    assert len(rows) == 2


def test_the_columns_of_an_index_end_alike_on_its_last_page(tmp_path: Path) -> None:
    words = [f"{letter}wort{number}" for letter in "ABCD" for number in range(50)]
    marked = " ".join(f"[{word}](index:)" for word in words)
    pdf = pdf_of(tmp_path, chapter("Kapitel", text(marked)), top=f'{TOP}matter = ["index"]\n')
    assert {*words} == {*re.findall(r"\wwort\d+(?=, \d)", read(pdf, "-raw"))}
    boxes = told("pdftotext", pdf, "-bbox", "-f", str(len(pages_of(pdf))))
    places = re.findall(r'xMin="([\d.]+)".* yMax="([\d.]+)">\wwort', boxes)
    left, right = (
        max(float(bottom) for at, bottom in places if (float(at) > 210 / 25.4 * 36) == side)
        for side in (False, True)
    )
    assert abs(left - right) < 30


def test_the_file_tells_title_author_keywords_language_and_standards(sample: Path) -> None:
    fields = told("pdfinfo", sample / "handbook.pdf")
    assert re.search(r"^Title: +Tafeln des Kurbeltriebs$", fields, re.MULTILINE)
    assert re.search(r"^Author: +A. Setzer$", fields, re.MULTILINE)
    assert re.search(r"^Subject: +für Handbücher und Vorlesungen$", fields, re.MULTILINE)
    assert "Bewegung des Kolbens, x/R, Gleichgang" in fields
    pdf = (sample / "handbook.pdf").read_bytes()
    assert b"<dc:language><rdf:Bag><rdf:li>de</rdf:li>" in pdf
    assert b"<pdfaid:part>2</pdfaid:part>" in pdf
    assert b"<pdfuaid:part>1</pdfuaid:part>" in pdf


def test_nasty_words_are_printed_as_they_are(tmp_path: Path) -> None:
    runs = {"nasty": "table --angle 0..90:30", "f": "table -f drawing"}
    parts = (run(name, asked, caption=NASTY) for name, asked in runs.items())
    top = keys_of(title=NASTY, subtitle=NASTY, author=NASTY) + 'formats = ["pdf"]\n'
    words = re.sub(r"([!-/:-@\[-`{-~])", r"\\\1", NASTY.replace(r"\$", "$"))
    pdf = pdf_of(tmp_path, chapter(NASTY, text(words), *parts), top=top)
    shown = "".join(read(pdf).split())
    # Title, subtitle, author, contents, both lists, the chapter's title, the text, both captions.
    assert shown.count(PIECE) == 10
    assert "root:" not in shown


def test_the_same_handbook_is_the_same_file_elsewhere(
    sample: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TZ", "Asia/Tokyo")
    monkeypatch.setenv("LC_ALL", "C")
    monkeypatch.chdir(tmp_path)
    time.tzset()
    elsewhere = tmp_path / "another place"
    shutil.copytree(sample.parent, elsewhere, ignore=shutil.ignore_patterns("handbook.pdf"))
    pages = built(elsewhere, (sample.parent / "handbook.toml").read_text(encoding="utf-8"))
    assert (pages / "handbook.pdf").read_bytes() == (sample / "handbook.pdf").read_bytes()
    monkeypatch.undo()
    time.tzset()


def test_a_table_too_wide_to_read_stands_on_a_page_turned_on_its_side(tmp_path: Path) -> None:
    ratios = ";".join(f"1:{number}" for number in range(2, 14))
    narrow = run("narrow", "table --ratio 1:5 --angle 0..180:30")
    wide = run("wide", f"table --ratio {ratios!r} --layout kolbenwege --angle 0..180:30")
    pdf = pdf_of(tmp_path, chapter("Kapitel", text("Siehe [](#wide) und [](#narrow)."), narrow, wide))
    sizes = re.findall(r"size: +(\d+)\S* x (\d+)", told("pdfinfo", pdf, "-l", "9"))
    assert sizes == [("595", "841"), ("595", "841"), ("841", "595")]
    assert "Siehe Tabelle 2 und Tabelle 1." in read(pdf)


@pytest.mark.slow
def test_all_layouts_make_a_handbook(tmp_path: Path) -> None:
    """Each with the command line that is listed for it."""
    lines = [
        line.split(" kurbel ")[1]
        for line in printed("layouts", COLUMNS="1000").out.splitlines()
        if " kurbel " in line
    ]
    assert len(lines) == len(layout_names())
    parts = [run(f"t{place}", line, lang=("de", "en")[place % 2]) for place, line in enumerate(lines)]
    whole = read(pdf_of(tmp_path, chapter("Alle", *parts)))
    heads = [f"{('Tabelle', 'Table')[place % 2]} {place + 1}." for place in range(len(parts))]
    assert [head for head in heads if head not in whole] == []


def test_headings_skip_no_level_and_texts_and_chapters_have_their_own_language(tmp_path: Path) -> None:
    """Without a level that is skipped the standard for readers is kept."""
    steep = "### A\n\n> ###### B\n\n# C\n\n- #### D\n\n#### E\n\n## F\n\n## G\n\n###### H\n"
    words = "See [](#weg) and [](#paths), $R = 0.5$."
    weg = run("weg", "table --angle 0..180:30")
    first = chapter("Wege", text(steep), text(words, lang="en"), weg, name="wege")
    second = chapter("Paths of $1.5$", text(words, lang="de"), name="paths", lang="en")
    pdf = pdf_of(tmp_path, first, second, top=TOP.replace("]", ', "markdown"]'))
    page = (tmp_path / "pages/markdown/01-wege.md").read_text(encoding="utf-8")
    levels = {name: len(signs) - 1 for signs, name in re.findall(r"(#+) ([A-H])$", page, re.MULTILINE)}
    assert levels == dict(A=1, B=2, C=1, D=2, E=2, F=2, G=2, H=3)
    whole = read(pdf)
    assert "See Table 1 and § 2, 𝑅 = 0.5." in whole
    assert "See Tabelle 1 and § 2, 𝑅 = 0,5." in whole
    assert "2 Paths of 1.5" in whole
