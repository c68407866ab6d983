"""LaTeX documents compiled, and what the log complains of."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest
from programs import PATIENCE
from tools import require

each_engine = pytest.mark.parametrize(
    "engine", ["pdflatex", pytest.param("lualatex", marks=pytest.mark.slow)]
)
each_kind_of_table = pytest.mark.parametrize(
    "longtable", [False, pytest.param(True, marks=pytest.mark.slow)], ids=["table", "longtable"]
)
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
            timeout=PATIENCE,
            check=False,
        )
    return (folder / "page.log").read_text(encoding="utf-8", errors="replace")


def complaints(log: str) -> list[str]:
    return [found.group() for found in _COMPLAINT.finditer(log) if "Package: infwarerr" not in found.group()]


PREAMBLE = r"""\documentclass{article}
\usepackage{iftex}
\iftutex\usepackage{fontspec}\else\usepackage[T1]{fontenc}\usepackage[utf8]{inputenc}\fi
\usepackage{lmodern}
\usepackage[a4paper,textwidth=16cm,textheight=25cm]{geometry}
\usepackage[english,ngerman]{babel}
\usepackage{amsmath,array,booktabs,graphicx,longtable}
\begin{document}
"""
