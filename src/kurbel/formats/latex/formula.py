"""Formulas in LaTeX."""

from __future__ import annotations

from kurbel.formats.formula_shape import has_bar
from kurbel.formats.latex.escapes import escape
from kurbel.formats.tex_math import TexMath
from kurbel.page.formula import Formula


def math(formula: Formula, mark: str = ".", display: bool = False) -> str:
    r"""Return a formula with its dollar signs: $x/R$, $\frac{1}{4{,}5}\cos\varphi$. Needs amsmath.

    `display` gives fractions their full size, and the line the height for it.
    """
    content = TexMath(mark, escape).set(formula.content)
    if display and has_bar(formula.content):
        return f"$\\displaystyle {content}\\rule[-1.05em]{{0pt}}{{2.7em}}$"
    return f"${content}$"
