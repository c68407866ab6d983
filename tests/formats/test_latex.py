"""LaTeX pages compile with both engines, without a single warning."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest
from everything import everything
from tools import require

from kurbel.exact.numerals import Number
from kurbel.formats.render import render
from kurbel.page.table import Cell, Column, Group, Panel, Records, Row, Table

ENGINES = ("pdflatex", "lualatex")
_COMPLAINT = re.compile(r"^(?:!|.*\b(?:Warning|Overfull|Underfull|Missing character)\b).*", re.MULTILINE)


def compiled(engine: str, text: str, folder: Path, runs: int = 1) -> str:
    """Return the log of the last run."""
    program = require(engine)
    (folder / "page.tex").write_text(text, encoding="utf-8")
    for _ in range(runs):
        subprocess.run(
            [program, "-interaction=nonstopmode", "-halt-on-error", "page.tex"],
            cwd=folder,
            capture_output=True,
            timeout=120,
            check=False,
        )
    return (folder / "page.log").read_text(encoding="utf-8", errors="replace")


def complaints(log: str) -> list[str]:
    return [found.group() for found in _COMPLAINT.finditer(log) if "Package: infwarerr" not in found.group()]


def wide(decimals: int) -> Table:
    """Twelve columns of figures, each of them with its sign."""
    columns = tuple(
        Column(str(place), ("Kopf", f"$x_{place % 10}$"), (f"Gruppe {place // 4}",)) for place in range(12)
    )
    rows = tuple(
        Row(
            (Cell(Number(10 * line, 0)),),
            tuple(Cell(Number(-(10**decimals) - 7 * line - place, decimals)) for place in range(12)),
        )
        for line in range(4)
    )
    panel = Panel((Column("phi", ("$φ$",)),), columns, (Group(rows),))
    return Table("wide", "de", "Breit", (panel,), Records((), ()))


def tall(rows: int = 90) -> Table:
    body = tuple(Row((Cell(Number(line, 0)),), (Cell(Number(line, 3)),)) for line in range(rows))
    panel = Panel((Column("phi", ("$φ$",)),), (Column("x", ("$x/R$",)),), (Group(body, "Gruppe"),))
    return Table("tall", "en", "Tall", (panel, panel), Records((), ()), source="Nowhere")


@pytest.mark.parametrize("engine", ENGINES)
def test_page_with_every_part_compiles_without_warnings(engine: str, tmp_path: Path) -> None:
    # The label of the table needs a second run.
    log = compiled(engine, render(everything(), "latex", standalone=True), tmp_path, runs=2)
    assert complaints(log) == []
    assert "Output written on page.pdf (1 page" in log


@pytest.mark.parametrize("decimals", [4, 6, 8])
def test_twelve_columns_fit_the_page(decimals: int, tmp_path: Path) -> None:
    log = compiled("pdflatex", render(wide(decimals), "latex", standalone=True), tmp_path, runs=2)
    assert complaints(log) == []


def test_table_longer_than_a_page_breaks_and_repeats_its_head(tmp_path: Path) -> None:
    text = render(tall(), "latex", standalone=True)
    assert text.count(r"\begin{longtable}") == 2
    assert r"\tablename~\thetable\ (continued)" in text
    log = compiled("pdflatex", text, tmp_path, runs=3)
    assert complaints(log) == []
    assert "(4 pages" in log


def test_longtable_has_every_part_too(tmp_path: Path) -> None:
    text = render(everything(), "latex", standalone=True, longtable=True)
    assert complaints(compiled("pdflatex", text, tmp_path, runs=3)) == []


def test_fragment_names_the_packages_it_needs() -> None:
    assert render(everything(), "latex").startswith("% Packages: amsmath, array, booktabs, graphicx\n")
    assert render(everything(), "latex", longtable=True).startswith(
        "% Packages: amsmath, array, booktabs, longtable\n"
    )


def test_awkward_prose_is_printed_as_it_was_written(tmp_path: Path) -> None:
    program = require("pdftotext")
    compiled("pdflatex", render(everything(), "latex", standalone=True), tmp_path)
    subprocess.run([program, "-layout", "page.pdf"], cwd=tmp_path, check=True)
    text = " ".join((tmp_path / "page.txt").read_text(encoding="utf-8").split())
    assert r"50 % & $, a|b, #_{}~^\, <script>alert(1)</script>, [x] *y* `z` -" in text
