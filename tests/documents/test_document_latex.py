"""The LaTeX of a handbook: it compiles without a warning, says what it was given, and obeys none of it."""

from __future__ import annotations

import re
import subprocess
import zlib
from functools import cache
from pathlib import Path

import pytest
from handbook import TABLES, document, fragments, small, table, write_folder
from tex import compiled, complaints
from tools import require

from kurbel.documents.document import Chapter, Document, Item
from kurbel.documents.markdown import parse_prose
from kurbel.errors import TexError
from kurbel.exact.numerals import Number
from kurbel.formats.documents import document_files
from kurbel.formats.pdf.by_tex import compile_tex
from kurbel.page.labels import plain
from kurbel.page.table import Cell

NASTY = (
    r"\input{/etc/passwd} \$x",
    "a # b <script>alert(1)</script>",
    "[a](javascript:alert) | % & _ ^ ~ `",
    "Größe φ λ ² − ° {x} *y* \\\\[1em] -- ,, <<",
    "Wort " * 60,
)


@cache
def tables() -> dict[str, str]:
    return fragments("latex")


def written(pages: Document, folder: Path, **more: str) -> Path:
    folder.mkdir(exist_ok=True)
    texts = tables() | more
    write_folder(folder, document_files(pages, "latex", texts), texts, ".tex")
    return folder


def log_of(engine: str, folder: Path, runs: int) -> str:
    return compiled(engine, "\\input{handbook}\n", folder, runs)


def pages_of(pdf: Path) -> list[str]:
    """Return the words of each page, with single spaces between them."""
    done = subprocess.run(
        [require("pdftotext"), "-layout", str(pdf), "-"], capture_output=True, check=True, encoding="utf-8"
    )
    return [" ".join(page.split()) for page in done.stdout.split("\f")]


def text_of(pdf: Path) -> str:
    return " ".join(pages_of(pdf))


def unpacked(pdf: bytes) -> bytes:
    """Return all that the streams of a PDF hold."""
    streams = re.findall(rb"/FlateDecode\s*>>\s*stream\r?\n(.*?)\r?\nendstream", pdf, re.DOTALL)
    return pdf + b"".join(zlib.decompressobj().decompress(stream) for stream in streams)


def printed(cell: Cell, mark: str) -> str:
    """Return a number as the PDF has it."""
    assert isinstance(cell.value, Number)
    digits = f"{abs(cell.value.scaled):0{cell.value.decimals + 1}}"
    whole, fraction = digits[: len(digits) - cell.value.decimals], digits[len(digits) - cell.value.decimals :]
    return ("−" if cell.value.scaled < 0 else "") + whole + (mark + fraction if fraction else "")


def test_the_article_has_every_digit_and_every_reference(tmp_path: Path) -> None:
    assert complaints(log_of("pdflatex", written(document(), tmp_path), runs=3)) == []
    pages = pages_of(tmp_path / "page.pdf")
    text = " ".join(pages)
    words = set(text.split())
    for name in ("weg", "path", "feinweg", "delta"):
        mark = "," if table(name).lang == "de" else "."
        cells = [cell for panel in table(name).panels for row in panel.rows() for cell in row.cells]
        numbers = {printed(cell, mark) for cell in cells if isinstance(cell.value, Number)}
        assert len(numbers) > 4
        assert numbers <= words, name
    assert "für andere Verhältnisse gilt Tabelle 2. Den Verlauf zeigt Abbildung 1, und" in text
    assert "siehe Tabelle 5 und Tabelle 3." in text
    # A caption speaks the language of its table.
    assert "Table 3: Piston path" in text
    assert "Figure 2: The drive" in text
    places = [text.index(f"{word} {number}:") for number, word in _captions()]
    assert places == sorted(places)
    listed = re.search(r"6 Dead centres of the beam engine; approximations of § 149[ .]+([0-9]+) 7 ", text)
    page = next(number for number, page in enumerate(pages, 1) if "Table 6: Dead centres" in page)
    assert listed and int(listed[1]) == page
    # Each page once in the index.
    words_at = next(number for number, page in enumerate(pages, 1) if "hängt von der Füllung ab" in page)
    captions = ("Tabelle 1: ", "Tabelle 2: ", "Abbildung 1: ")
    at = [next(number for number, page in enumerate(pages, 1) if one in page) for one in captions]
    index = pages[-2] + pages[-1]
    assert f"Füllung, {words_at}" in index
    assert f"Kolbenweg, {', '.join(map(str, dict.fromkeys(at)))} u. ö." in index
    assert sum(page.count("Zeichen Größe Einheit zuerst") for page in pages) > 1


def _captions() -> list[tuple[int, str]]:
    return [
        (number, "Table" if table(name).lang == "en" else "Tabelle") for number, name in enumerate(TABLES, 1)
    ]


def test_what_the_manifest_says_is_printed_and_not_obeyed(tmp_path: Path) -> None:
    chapters = tuple(Chapter(words, f"c{place}", place, ()) for place, words in enumerate(NASTY, 1))
    figure = Item("figure", "kurven", 1, "de", NASTY[0] + NASTY[2])
    heading = Item("text", blocks=parse_prose("# Kopf -- ,, <<"))
    # Longer than the page, which is scaled to it and not printed over its foot.
    tall = Item("table", "lang", 1, "de", "Lang")
    long = "\\begin{table}\n\\caption{Lang}\\label{tab:lang}\n\\rule{1cm}{240mm}\n\\end{table}\n"
    chapters = (chapters[0]._replace(items=(heading, figure, tall)), *chapters[1:])
    folder = written(Document(NASTY[3], "de", "comma", chapters, NASTY[2], NASTY[1]), tmp_path, lang=long)
    log = log_of("pdflatex", folder, runs=3)
    # TeX says of a line of sixty equal words that it is not full.
    assert [line for line in complaints(log) if "Underfull" not in line] == []
    text = text_of(folder / "page.pdf")
    for words in NASTY[:3]:
        assert text.count(" ".join(plain(words).split())) >= 2, words
    assert r"{x} *y* \\[1em] -- ,, <<" in text
    assert "Kopf -- ,, <<" in text
    assert "root:" not in text


def test_the_pdf_says_its_title_author_and_language(tmp_path: Path) -> None:
    folder = written(small()._replace(title=NASTY[3], author=NASTY[0]), tmp_path)
    pdf = compile_tex(str(folder), "handbook", "pdflatex")
    (tmp_path / "read.pdf").write_bytes(pdf)
    done = subprocess.run(
        [require("pdfinfo"), "-enc", "UTF-8", str(tmp_path / "read.pdf")],
        capture_output=True,
        check=True,
        encoding="utf-8",
    )
    fields = dict(line.split(":", 1) for line in done.stdout.splitlines() if ":" in line)
    assert fields["Title"].strip() == plain(NASTY[3])
    assert fields["Author"].strip() == plain(NASTY[0])
    assert "CreationDate" not in fields
    assert re.search(rb"/Lang ?\(de\)", unpacked(pdf))


HOST = r"""\documentclass[ngerman]{scrreprt}
\usepackage[T1]{fontenc}
\usepackage{lmodern}
\usepackage[textwidth=16cm]{geometry}
\usepackage{babel}
\usepackage{amsmath,array,booktabs,graphicx,longtable,hyperref,cleveref}
\begin{document}
\listoftables
\chapter{Eins}
\begin{table}\caption{Eigene}\label{tab:own}\end{table}
\appendix
\chapter{Tafeln}
Siehe \cref{tab:path}, \cref{fig:stellung} und \cref{sec:kurz}.
\newcommand{\kurbelpath}{tafeln/}
\input{\kurbelpath appendix}
\end{document}
"""


@pytest.mark.slow
def test_the_appendix_goes_into_a_report_from_another_folder(tmp_path: Path) -> None:
    written(small(), tmp_path / "tafeln")
    log = compiled("pdflatex", HOST, tmp_path, runs=3)
    assert complaints(log) == []
    # The host's babel does not have the language of the table.
    assert "Tabelle A.1.: Piston path" in " ".join(pages_of(tmp_path / "page.pdf"))
    text = text_of(tmp_path / "page.pdf")
    assert "Siehe Tabelle A.1, Abb. A.1 und Anhang A.1." in text
    # The host's own list has all tables, the appendix's list its own.
    first, second = (place.start() for place in re.finditer("Tabellenverzeichnis", text))
    assert "Eigene" in text[first:second]
    assert re.match(r"Tabellenverzeichnis A\.1\. Piston path", text[second:])


def test_thirty_tables_in_a_row_are_not_too_many(tmp_path: Path) -> None:
    """They are floats here, in a class that does not print them where they are."""
    names = [f"t{number}" for number in range(30)]
    items = tuple(Item("table", name, number, "en", "Many") for number, name in enumerate(names, 1))
    pages = Document("Viele", "de", "comma", (Chapter("Viele", "viele", 1, items),))
    short = {
        name: f"\\begin{{table}}[htbp]\n\\caption{{Many}}\\label{{tab:{name}}}\n"
        "\\rule{1cm}{6cm}\n\\end{table}\n"
        for name in names
    }
    write_folder(tmp_path, document_files(pages, "latex", short), short, ".tex")
    host = "\\documentclass{article}\n\\begin{document}\n\\input{appendix}\n\\end{document}\n"
    assert complaints(compiled("pdflatex", host, tmp_path, runs=3)) == []
    text = text_of(tmp_path / "page.pdf")
    places = [text.index(f"Table {number}: ") for number in range(1, 31)]
    assert places == sorted(places)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("first", "second"),
    [("pdflatex", "latexmk"), ("lualatex", "lualatex")],
)
def test_the_same_files_give_the_same_pdf(
    first: str, second: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    require(second)
    folders = [written(small(), tmp_path / name) for name in ("a", "b, ö{%")]
    monkeypatch.setenv("TZ", "Asia/Tokyo")
    assert complaints(log_of(first, folders[0], runs=3)) == []
    monkeypatch.setenv("TZ", "America/New_York")
    before = sorted(folders[1].rglob("*"))
    made = compile_tex(str(folders[1]), "handbook", second)
    assert sorted(folders[1].rglob("*")) == before
    assert made == (folders[0] / "page.pdf").read_bytes()
    assert not re.search(rb"/CreationDate|PTEX\.|/tmp/|D:20", unpacked(made))


def trial(folder: Path, line: str, engine: str = "pdflatex", seconds: float = 60) -> bytes:
    text = f"\\documentclass{{article}}\\begin{{document}}\n{line} x\n\\end{{document}}\n"
    (folder / "trial.tex").write_text(text, encoding="utf-8")
    return compile_tex(str(folder), "trial", engine, seconds=seconds)


@pytest.mark.parametrize(
    ("line", "sentence"),
    [
        (r"\nothing", "pdflatex cannot set trial.tex: Undefined control sequence."),
        (r"\input{missing}", "pdflatex cannot set trial.tex: LaTeX Error: File `missing.tex' not found."),
        (
            r"\input{/etc/hostname}",
            "pdflatex cannot set trial.tex: LaTeX Error: File `/etc/hostname.tex' not found.",
        ),
        (r"\input{../secret}", "pdflatex cannot set trial.tex: LaTeX Error: File `../secret.tex' not found."),
        (
            r"\newwrite\w\immediate\openout\w=../out.txt",
            "pdflatex cannot set trial.tex: I can't write on file `../out.txt'.",
        ),
    ],
)
def test_a_failure_is_a_sentence_with_the_first_error(line: str, sentence: str, tmp_path: Path) -> None:
    require("pdflatex")
    (tmp_path / "secret.tex").write_text("secret", encoding="utf-8")
    folder = tmp_path / "out"
    folder.mkdir()
    with pytest.raises(TexError) as caught:
        trial(folder, line)
    assert str(caught.value) == sentence


def test_tex_runs_no_program(tmp_path: Path) -> None:
    require("pdflatex")
    trial(tmp_path, rf"\immediate\write18{{touch {tmp_path}/ran}}")
    assert not (tmp_path / "ran").exists()


def test_a_document_without_end_is_stopped(tmp_path: Path) -> None:
    require("pdflatex")
    with pytest.raises(TexError, match=r"^pdflatex did not finish trial.tex within 0.5 seconds$"):
        trial(tmp_path, r"\loop\iftrue\repeat", seconds=0.5)


def test_a_missing_engine_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(TexError) as caught:
        compile_tex(str(tmp_path), "handbook", "lualatex")
    assert str(caught.value) == "--pdf-engine lualatex needs TeX: there is no lualatex on this machine"
