"""Words and turns of phrase that captions and notes of all pages share."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction

from kurbel.exact.numerals import Label
from kurbel.page.quantity import words
from kurbel.reading.notation import ratio_text

AND = words(" und | and ")
FOR = words(" für | for ")


def for_ratio(ratio: Fraction, lang: str, symbol: str = "R:L") -> Label:
    """Return " für $R:L = 1:5$"."""
    return f"{FOR[lang]}${symbol} = {ratio_text(ratio)}$"


def enumerated(quantities: Iterable[str], lang: str) -> str:
    """Return their names, each once: Kolbenweg, Kolbengeschwindigkeit und Kolbenbeschleunigung."""
    names = list(dict.fromkeys(quantities))
    if lang == "en":
        names[1:] = [name.lower() for name in names[1:]]
    return AND[lang].join(part for part in (", ".join(names[:-1]), names[-1]) if part)


def enumerated_letters(letters: Sequence[str], lang: str) -> Label:
    """Return "$X$ and $P$"."""
    *others, last = (f"${letter}$" for letter in letters)
    return ", ".join(others) + AND[lang] + last if others else last


def filled(text: Label, parts: Iterable[tuple[str, str]]) -> Label:
    """Return a text with its places in braces filled; what braces are left belong to formulas."""
    for place, part in parts:
        text = text.replace(place, part)
    return text
