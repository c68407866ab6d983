"""The shipped layouts as an editor uses them: fragments in one LaTeX document, HTML in a browser."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest
from test_latex import ENGINES, compiled, complaints

from kurbel import notation
from kurbel.build import build
from kurbel.layouts import LANGUAGES, layout, layout_names
from kurbel.problem import Crank, Speed
from kurbel.render import render
from kurbel.request import Request
from kurbel.table import Table

PREAMBLE = r"""\documentclass{article}
\usepackage{iftex}
\iftutex\usepackage{fontspec}\else\usepackage[T1]{fontenc}\usepackage[utf8]{inputenc}\fi
\usepackage{lmodern}
\usepackage[a4paper,textwidth=16cm,textheight=25cm]{geometry}
\usepackage[english,ngerman]{babel}
\usepackage{amsmath,array,booktabs,graphicx,longtable}
\begin{document}
"""


def shipped(name: str, lang: str, **machine: object) -> Table:
    page = layout(name)
    cranks = tuple(Crank(ratio, **machine) for ratio in notation.ratios(page.ratios))  # type: ignore[arg-type]
    label = "-".join((name, lang, *machine))
    return build(Request(page, cranks, notation.angles(page.angles), lang=lang, label=label))


def all_pages() -> list[Table]:
    pages = [shipped(name, lang) for name in layout_names() for lang in LANGUAGES]
    machine = {"radius": Fraction(3, 10), "speed": Speed(Fraction(2))}
    return [
        *pages,
        shipped("kinematics", "de", **machine),
        shipped("kinematics", "en", offset=Fraction(1, 10)),
    ]


@pytest.mark.parametrize("longtable", [False, True], ids=["table", "longtable"])
@pytest.mark.parametrize("engine", ENGINES)
def test_all_shipped_layouts_compile_in_one_document(engine: str, longtable: bool, tmp_path: Path) -> None:
    pages = all_pages()
    assert len(pages) >= 14
    for page in pages:
        text = render(page, "latex", longtable=longtable)
        (tmp_path / f"{page.key}.tex").write_text(text, encoding="utf-8")
    babel = {"de": "ngerman", "en": "english"}
    inputs = "".join(
        f"\\selectlanguage{{{babel[page.lang]}}}\n\\input{{{page.key}}}\n\\clearpage\n" for page in pages
    )
    log = compiled(engine, f"{PREAMBLE}{inputs}\\end{{document}}\n", tmp_path, runs=3 if longtable else 2)
    assert complaints(log) == []
    assert f"Output written on page.pdf ({len(pages)} pages" in log
