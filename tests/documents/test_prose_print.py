"""Free text on paper: it compiles without a warning, and the page shows the characters of the text."""

from __future__ import annotations

import random
import re
import string
import subprocess
from pathlib import Path

from prose_sample import SAMPLE, parsed, set_in, shown
from tex import compiled, complaints, each_engine
from tools import require, require_library

_LATEX = r"""\documentclass[a4paper]{report}
\usepackage{iftex}
\ifpdftex
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\fi
\usepackage{lmodern}
\usepackage[ngerman]{babel}
\usepackage[textwidth=16cm,textheight=24cm]{geometry}
\usepackage{amsmath,array,booktabs}
\usepackage[hidelinks]{hyperref}
\begin{document}
\chapter{Eins}\chapter{Anfang}\label{ch:start}
\begin{table}\caption{T}\label{tab:delta}\end{table}
\begin{figure}\caption{F}\label{fig:drive}\end{figure}
"""
_TYPST = """#set text(lang: "de")
#set heading(numbering: "1.1")
= Anfang <ch-start>
#figure(table[a], caption: [T]) <tab-delta>
#figure(rect(), kind: image, caption: [F]) <fig-drive>
"""
# What a page of the sample shows in every format, white space apart.
_SHOWN = (
    "eiltbei2°30",
    r"""50%&3$,a|b,#_{}~^\,<b>fett</b>&lt;"so"'so'-----<<>>?`!`[x]@delta//x/y/*z*""",
    r"""ab$x$\o/"q"'q'--~^""",
    """if(a<b){x="y";}#100%weiter,mit'Größe'--und\\n`~^_""",
    "0123456789" * 10,
    string.punctuation[:15] + string.digits + string.punctuation[15:22],
    string.ascii_lowercase + "{|}~äöüÄÖÜß",
)


def characters(text: str) -> str:
    """Return what is read on a page, without white space, with straight apostrophes."""
    return "".join(text.replace("’", "'").split())


def paper(folder: Path) -> str:
    """Return the text of page.pdf."""
    subprocess.run([require("pdftotext"), "-layout", "page.pdf"], cwd=folder, check=True)
    return (folder / "page.txt").read_text(encoding="utf-8")


def typeset(source: str, folder: Path) -> None:
    """Compile a source of Typst without a warning."""
    require_library("typst")
    import typst

    (folder / "page.typ").write_text(source, encoding="utf-8")
    _, warnings = typst.compile_with_warnings(
        str(folder / "page.typ"), output=str(folder / "page.pdf"), ignore_system_fonts=True
    )
    assert warnings == []


@each_engine
def test_sample_is_printed_by_latex(engine: str, tmp_path: Path) -> None:
    heading = "\n\n# λ \"q\" 'x' \\` ~^\\\\ {}% `a_b` [](#delta)\n"
    text = f"{_LATEX}{set_in('latex', SAMPLE + heading)}\\end{{document}}\n"
    assert complaints(compiled(engine, text, tmp_path, runs=2)) == []
    page = characters(paper(tmp_path))
    for characters_of_line in _SHOWN:
        assert characters_of_line in page
    assert "sieheTabelle2.1,dieSkizzeund§2." in page
    assert "2.2λ\"q\"'x'`~^\\{}%a_bTabelle2.1" in page


def test_sentences_in_a_table_stay_on_the_page(tmp_path: Path) -> None:
    sentence = "Der Kolben eilt vor und kehrt am Totpunkt um. " * 4
    rows = f"| Teil | Was er *tut* | Mehr |\n|:--|---|--:|\n| $x/R$ | {sentence} | {sentence} |\n"
    assert (
        complaints(
            compiled("pdflatex", f"{_LATEX}{set_in('latex', rows)}\\end{{document}}\n", tmp_path, runs=2)
        )
        == []
    )
    assert characters(paper(tmp_path)).count("Kolben") == 8


def test_sample_is_printed_by_typst(tmp_path: Path) -> None:
    typeset(_TYPST + set_in("typst", SAMPLE), tmp_path)
    page = characters(paper(tmp_path))
    for characters_of_line in _SHOWN:
        assert characters_of_line in page
    assert "sieheTabelle1,dieSkizzeundAbschnitt1." in page


def nasty_texts(count: int) -> list[str]:
    """Return texts of characters that are markup somewhere, and that our Markdown does not refuse."""
    chance = random.Random(6)
    pieces = [*string.punctuation, *string.punctuation, *"  \naBü7", "- ", "1. ", "\n> "]
    texts = (
        "".join(chance.choices(pieces, k=chance.randint(1, 30))).replace("$", r"\$") for _ in range(9999)
    )
    found = [text for text in texts if parsed(text) and shown(set_in("html", text))]
    return found[:count]


def between(page: str, count: int) -> list[str]:
    """Return what stands before each of the marks QQ0QQ, QQ1QQ ..."""
    parts = re.split(r"QQ\d+QQ", characters(page))
    assert len(parts) == count + 1
    return parts[:-1]


# Marks of lists and quotations are set by the engines.
_LIST = re.compile(r"<(?:li|ol|ul|hr)\b")


@each_engine
def test_nasty_text_is_printed_by_latex(engine: str, tmp_path: Path) -> None:
    texts = [text for text in nasty_texts(60) if not _LIST.search(set_in("html", text))]
    pieces = "\n\n".join(f"{set_in('latex', text)}\n\nQQ{place}QQ\n" for place, text in enumerate(texts))
    head = _LATEX[: _LATEX.index(r"\chapter")] + "\\pagestyle{empty}\\setcounter{secnumdepth}{-2}\n"
    log = compiled(engine, f"{head}{pieces}\\end{{document}}\n", tmp_path)
    assert "Output written" in log
    assert not re.findall(r"^!.*|.*Missing character.*", log, re.MULTILINE)
    for text, printed in zip(texts, between(paper(tmp_path), len(texts)), strict=True):
        assert printed == characters(shown(set_in("html", text))), text


def test_nasty_text_is_printed_by_typst(tmp_path: Path) -> None:
    texts = [text for text in nasty_texts(60) if not _LIST.search(set_in("html", text))]
    pieces = "\n".join(f"{set_in('typst', text)}\nQQ{place}QQ\n" for place, text in enumerate(texts))
    typeset(pieces, tmp_path)
    for text, printed in zip(texts, between(paper(tmp_path), len(texts)), strict=True):
        assert printed == characters(shown(set_in("html", text))), text
