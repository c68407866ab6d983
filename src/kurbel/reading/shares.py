"""Shares as people write them: 0,1, 10 %, 1/10 and 1:10; and what is no expansion ratio, for it is one."""

from __future__ import annotations

import re
from collections.abc import Iterable
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING

from kurbel.errors import NotationError, ProblemError
from kurbel.exact.numerals import exact_text
from kurbel.reading import notation
from kurbel.reading.notation import quoted

if TYPE_CHECKING:
    from kurbel.reading.given import Exact

_PARTS = re.compile(r"(.*?)\s*(%|‰|percent|per cent|Prozent|v\. ?H\.)", re.DOTALL | re.IGNORECASE)
_THOUSANDTHS = "‰"
# The comma of a decimal: of few lists of shares the second is a whole number.
_DECIMAL = re.compile(r"(?<![\d.,])0,(?=\d)")


def share(text: str, what: str = "share") -> Fraction:
    """Return a share: "0.05", "0,05", "1/20", "1:20", "5%", "5 %"."""
    stripped = text.strip()
    part = _PARTS.fullmatch(stripped)
    above, colon, below = stripped.partition(":")
    try:
        if part:
            return notation.number(part[1], what) / (1000 if part[2] == _THOUSANDTHS else 100)
        if colon:
            return notation.number(above, what) / notation.number(below, what)
    except (NotationError, ZeroDivisionError):
        raise NotationError(
            f"{what} {quoted(text)} is not a share; write it as 0.05, 5%, 1/20 or 1:20"
        ) from None
    return notation.number(stripped, what)


def shares(texts: Iterable[str], what: str = "share") -> tuple[Fraction, ...]:
    """Return the shares of lists and ranges, each once: "2/3", "50%;60%", "0..1:0.1", "0,5"."""
    decimals = (_DECIMAL.sub("0.", text) for text in texts)
    return tuple(dict.fromkeys(notation.each_number(decimals, what, partial(share, what=what))))


def refuse_cut_off(given: Exact | Iterable[Exact]) -> None:
    """Raise ProblemError for an expansion ratio that is the share of the stroke before the cut-off."""
    values = [given] if isinstance(given, str) or not isinstance(given, Iterable) else given
    for text in (part for value in values for part in str(value).split(";")):
        try:
            # Of 2:6 a range is more likely to be meant.
            found = share(text) if ":" not in text or text.strip().startswith("1:") else Fraction(1)
        except NotationError:
            continue
        if 0 < found < 1:
            raise ProblemError(too_small(found))


def too_small(expansion: Fraction) -> str:
    """Return the sentence that refuses an expansion ratio below 1."""
    meant = f": after {exact_text(expansion)} of it, ε = {exact_text(1 / expansion)}" if expansion > 0 else ""
    return (
        f"expansion ratio ε is {notation.about(expansion)}; it must be 1 (no expansion) or more,"
        f" for the cut-off comes after the share 1/ε of the stroke{meant}"
    )
