"""The LaTeX of a handbook: it compiles without a warning, says what it was given, and obeys none of it."""

from __future__ import annotations

import re
import shutil
import zlib
from pathlib import Path

import pytest
from manifests import ENGLISH, TABLES, built, chapter, keys_of, pages_of, run, text
from tex import compiled, complaints
from tools import require

from kurbel.page.labels import plain

NASTY = (
    r"\input{/etc/passwd} \$x",
    "a # b <script>alert(1)</script>",
    "[a](javascript:alert) | % & _ ^ ~ `",
    "Größe φ λ ² − ° {x} *y* \\\\[1em] -- ,, <<",
    "Wort " * 60,
)
SMALL = f"""
title = "Kleine Tafeln"
formats = ["latex"]
{chapter("Kurz, $x/R$", text("Siehe [](#path), [](#stellung) und [](#kurz)."), name="kurz")}
{run("path", TABLES["path"], lang="en")}
{run("stellung", "plot --positions 30 --ratio 1:5", lang="en")}
"""


def log_of(engine: str, pages: Path, runs: int = 3) -> str:
    return compiled(engine, "\\input{handbook}\n", pages, runs)


def unpacked(pdf: bytes) -> bytes:
    """Return all that the streams of a PDF hold."""
    streams = re.findall(rb"/FlateDecode\s*>>\s*stream\r?\n(.*?)\r?\nendstream", pdf, re.DOTALL)
    return pdf + b"".join(zlib.decompressobj().decompress(stream) for stream in streams)


def test_the_article_has_every_digit_and_every_reference(sample: Path, tmp_path: Path) -> None:
    folder = tmp_path / "article"
    shutil.copytree(sample, folder)
    assert complaints(log_of("pdflatex", folder)) == []
    pages = pages_of(folder / "page.pdf")
    text = " ".join(pages)
    words = set(text.split())
    for name in ("weg", "path", "feinweg", "delta"):
        mark = "." if name in ENGLISH else ","
        numbers = re.findall(r"-?\d+\.\d+", (folder / f"tables/{name}.csv").read_text())
        assert len(numbers) > 4
        assert {number.replace("-", "−").replace(".", mark) for number in numbers} <= words, name
    assert "für andere Verhältnisse gilt Tabelle 2. Den Verlauf zeigt Abbildung 1, und" in text
    assert "siehe Tabelle 5 und Tabelle 3." in text
    # A caption speaks the language of its table.
    assert "Table 3: Piston path" in text
    assert "Figure 2: Crank drive" in text
    captions = [f"{'Table' if name in ENGLISH else 'Tabelle'} {n}:" for n, name in enumerate(TABLES, 1)]
    places = [text.index(caption) for caption in captions]
    assert places == sorted(places)
    listed = re.search(r"6 Dead centres of the beam engine; approximations of § 149[ .]+([0-9]+) 7 ", text)

    def first(words: str) -> int:
        return next(number for number, page in enumerate(pages, 1) if words in page)

    assert listed and int(listed[1]) == first("Table 6: Dead centres")
    assert f"Füllung, {first('hängt von der Füllung ab')}" in pages[-1]
    assert "Zeichen Größe Einheit zuerst" in text
    # A long table has its head on each of its pages.
    head = "φ in ◦" + " Hingang Rückgang" * 3
    long = pages[first("Tabelle 4: ") - 1 : first("Table 6: Dead centres")]
    starts = [page.partition(head)[0] for page in long if "Tabelle 4 (Fortsetzung)" in page]
    assert len(starts) == 4
    # Its notes stand below three rows at least, which go to the next page with them.
    assert re.search("178 .* 179 .* 180 .*oberes Zeichen: Hingang", long[4])
    assert all("Tabelle 4 (Fortsetzung) Kolbenweg" in start for start in starts)


def test_what_the_manifest_says_is_printed_and_not_obeyed(tmp_path: Path) -> None:
    require("pdflatex")
    figure = run("kurven", "table --ratio 1:5 -f drawing", caption=NASTY[0] + NASTY[2])
    first = chapter(NASTY[0], text("# Kopf -- ,, <<"), figure, run("lang", "delta", caption="Lang"))
    top = keys_of(title=NASTY[3], subtitle=NASTY[2], author=NASTY[1])
    manifest = f'{top}formats = ["latex"]\n{first}{"".join(map(chapter, NASTY[1:]))}'
    pages = built(tmp_path, manifest)
    # Longer than the page, which is scaled to it and not printed over its foot.
    long = "\\begin{table}\n\\caption{Lang}\\label{tab:lang}\n\\rule{1cm}{240mm}\n\\end{table}\n"
    (pages / "tables/lang.tex").write_text(long, encoding="utf-8")
    # TeX says of a line of sixty equal words that it is not full.
    assert [line for line in complaints(log_of("pdflatex", pages)) if "Underfull" not in line] == []
    printed = " ".join(pages_of(pages / "page.pdf"))
    for words in NASTY[:3]:
        assert printed.count(" ".join(plain(words).split())) >= 2, words
    assert r"{x} *y* \\[1em] -- ,, <<" in printed
    assert "Kopf -- ,, <<" in printed
    assert "root:" not in printed


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
\newcommand{\kurbelpath}{book/pages/}
\input{\kurbelpath appendix}
\end{document}
"""


@pytest.mark.slow
def test_the_appendix_goes_into_a_report_from_another_folder(tmp_path: Path) -> None:
    built(tmp_path / "book", SMALL)
    assert complaints(compiled("pdflatex", HOST, tmp_path, runs=3)) == []
    text = " ".join(pages_of(tmp_path / "page.pdf"))
    # The host's babel does not have the language of the table.
    assert "Tabelle A.1.: Piston path" in text
    assert "Siehe Tabelle A.1, Abb. A.1 und Anhang A.1." in text
    # The host's own list has all tables, the appendix's list its own.
    first, second = (place.start() for place in re.finditer("Tabellenverzeichnis", text))
    assert "Eigene" in text[first:second]
    assert re.match(r"Tabellenverzeichnis A\.1\. Piston path", text[second:])


def test_thirty_tables_in_a_row_are_not_too_many(tmp_path: Path) -> None:
    """They are floats here, in a class that does not print them where they are."""
    parts = (
        run(f"t{number}", f"table --angle 0..{number}:1 --columns x", caption="Viel")
        for number in range(1, 31)
    )
    pages = built(tmp_path, f'title = "Viele"\nformats = ["latex"]\n{chapter("Viele", *parts)}')
    packages = "amsmath,array,booktabs,longtable"
    host = (
        f"\\documentclass{{article}}\n\\usepackage{{{packages}}}\n\\begin{{document}}\n\\input{{appendix}}\n"
    )
    assert not re.search(
        r"^!.*", compiled("pdflatex", f"{host}\\end{{document}}\n", pages, runs=2), re.MULTILINE
    )
    text = " ".join(pages_of(pages / "page.pdf"))
    places = [text.index(f"Table {number}: Viel") for number in range(1, 31)]
    assert places == sorted(places)
