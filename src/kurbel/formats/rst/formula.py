"""Formulas in reStructuredText: the mathematics of LaTeX in a role."""

from __future__ import annotations

from kurbel.formats.formula_shape import has_bar
from kurbel.formats.rst.escapes import role
from kurbel.formats.tex_math import TexMath
from kurbel.page.formula import Formula

_UPRIGHT = str.maketrans(
    {character: f"\\{character}" for character in "#$%&_{}"}
    | {"\\": r"\textbackslash{}", "`": "‘", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}"}
)


def math(formula: Formula, mark: str = ".", display: bool = False) -> str:
    r"""Return a formula in its role: :math:`x/R`, :math:`\frac{1}{4{,}5}\cos\varphi`.

    `display` gives fractions their full size.
    """
    size = r"\displaystyle " if display and has_bar(formula.content) else ""
    return role("math", size + TexMath(mark, lambda text: text.translate(_UPRIGHT)).set(formula.content))
