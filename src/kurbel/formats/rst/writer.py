r"""Labels in reStructuredText, and what its templates read.

Markup stands apart from letters beside it. What is set here has an escaped space, which is not printed, on
both sides; `finish` removes those that are not needed: "x\ :math:`R`\ , y" becomes "x\ :math:`R`, y".
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

from kurbel.formats.formula import TEX_OBEYED, TexMath, has_bar
from kurbel.formats.page import Page
from kurbel.formats.writer import PageWriter, Wishes
from kurbel.page.formula import Formula
from kurbel.page.table import Table


class Writer(PageWriter):
    def escape(self, prose: str) -> str:
        return escape(prose)

    def note_mark(self, mark: str, target: str = "") -> str:
        """Return a raised mark without a link: a name of a note could be used but once in a document."""
        return role("sup", f"{escape(mark)})")

    def formula(self, formula: Formula, mark: str, display: bool = False) -> str:
        r"""Return a formula in TeX's notation in its role: :math:`x/R`, :math:`\frac{1}{4{,}5}\cos\varphi`.

        `display` gives fractions their full size.
        """
        size = r"\displaystyle " if display and has_bar(formula.content) else ""
        # docutils, which makes MathML of formulas, does not know \dots.
        tex = TexMath(mark, lambda text: text.translate(_UPRIGHT), dots=r"\ldots")
        return role("math", size + tex.set(formula.content))

    def finish(self, label: str) -> str:
        return finish(label)

    def filters(self) -> Mapping[str, Callable[..., Any]]:
        from kurbel.formats.rst.grid import grid_table, left_columns

        return {"finish": finish, "grid_table": grid_table, "left_columns": left_columns}

    def values(self, table: Table, ready: Page, mark: str, wishes: Wishes) -> dict[str, Any]:
        # The value of an option is no prose.
        return {"name": table.key}


# In a role it would end the formula.
_UPRIGHT = str.maketrans(TEX_OBEYED | {"`": "‘"})
_OBEYED = re.compile(r"[\\*`|_]|:(?=:)|(?<=\S)@(?=\S)|(?<=http|ttps|ilto|:ftp|file):(?=\S)")
# At the start of a line these make a list, a field, an option, a comment or a line across the page.
_START = re.compile(
    r"^ *(?=(?:[-+•‣⁃]|\.\.|>>>)(?: |$)|:[^:]|--?[A-Za-z]|/[A-Za-z]|=+ |\+-"
    r"|([!-/:-@\[\]^{-~])(?:\1{3}|\1*$)|\(?(?:[0-9]+|#|[A-Za-z]|[ivxlcdmIVXLCDM]+)[.)](?: |$))"
)
_ESCAPED = re.compile(r"\\(.)", re.DOTALL)
_TWICE = re.compile(r"(?<=[`*_])(?:\\ )+(?=\\ [:`*])")
_OPENING = re.compile(r":[a-z]+:`|[`*]")
# What may touch markup before it and behind it.
_BEFORE, _BEHIND = frozenset(("", *" \n'\"([{<-/:")), frozenset(("", *" \n'\")]}>-/\\:.,;!?"))


def escape(prose: str) -> str:
    """Return prose of which every character is printed and none obeyed."""
    escaped = _START.sub(r"\g<0>\\", _OBEYED.sub(r"\\\g<0>", prose))
    # Nothing but backslashes would be a line across the page.
    return escaped if escaped.strip("\\ ") or not escaped.strip() else f"\\ {escaped}"


def role(name: str, text: str) -> str:
    """Return text in a role, such as sup, apart from what stands beside it."""
    return f"\\ :{name}:`{text}`\\ "


def finish(text: str) -> str:
    """Return what was set without the escaped spaces that nothing needs."""
    single = _TWICE.sub("", text)

    def kept(match: re.Match[str]) -> str:
        if match[1] != " ":
            return match[0]
        before, behind = single[: match.start()][-1:], single[match.end() :][:1]
        opens, closes = bool(_OPENING.match(single, match.end())), before in ("`", "*", "_")
        apart = (opens and before not in _BEFORE) or (closes and behind not in _BEHIND)
        return match[0] if apart or not (opens or closes) else ""

    return _ESCAPED.sub(kept, single)
