"""The page on notation: what holds for all tables, said once."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping

from kurbel.documents import prose
from kurbel.documents.markdown import parse_prose
from kurbel.exact.numerals import DECIMALS, Label
from kurbel.handbook.matter.inlines import inlines
from kurbel.handbook.matter.symbols import LETTERS
from kurbel.page.quantity import Letter

ROUNDINGS = {
    "half-away": {"de": "die vom Nullpunkt entferntere", "en": "the one further from zero is printed"},
    "half-even": {
        "de": "die mit der geraden letzten Ziffer",
        "en": "the one whose last digit is even is printed",
    },
}
MARKS = {"de": {",": "Komma", ".": "Punkt"}, "en": {",": "comma", ".": "point"}}
BOOKS = {
    "de": " Werte aus Büchern stehen so, wie das Buch sie druckt.",
    "en": " Values of books stand as the book prints them.",
}
DIRECTIONS = {
    "de": "**Vorzeichen.** Wo eine Tabelle nichts anderes sagt, zählen ihre Größen so:",
    "en": "**Signs.** Where a table says nothing else, its quantities count so:",
}


def notation(
    letters: Iterable[Letter], mark: str, rounded: Mapping[str, str], books: bool, lang: str
) -> prose.Blocks:
    """Return the page: the directions are those of the letters that the handbook prints.

    `mark` is the decimal mark, `rounded` has the rounding of tables by their names; with `books` there are
    printed values of books.
    """
    with open(os.path.join(os.path.dirname(__file__), f"notation.{lang}.md"), encoding="utf-8") as file:
        text = file.read()
    text = text.format(
        mark=MARKS[lang][DECIMALS.get(mark, mark)],
        rounding=_rounding(rounded, lang),
        books=BOOKS[lang] if books else "",
    )
    drive = (_line(symbol, said[lang]) for symbol, said in LETTERS.items())
    directions = dict.fromkeys(_directions(letters))
    blocks = (*parse_prose(text), _list(drive))
    if directions:
        blocks += (*parse_prose(DIRECTIONS[lang]), _list(map(_item, directions)))
    return blocks


def _rounding(rounded: Mapping[str, str], lang: str) -> str:
    """Return how most tables are rounded, and those that are not so."""
    usual, *others = [one for one, _ in Counter(rounded.values()).most_common()] or ["half-away"]
    said = [ROUNDINGS[usual][lang]]
    for other in others:
        tables = ", ".join(f"[](#{name})" for name, one in rounded.items() if one == other)
        said.append(f"in {tables} {ROUNDINGS[other][lang]}")
    return "; ".join(said)


def terse(caption: Label, lang: str) -> Label:
    """Return a caption without the rule of formulas that the page states."""
    from kurbel.motion.evaluation import METHODS

    return caption.removesuffix(f"; {METHODS['exact'].caption[lang]}")


def _directions(letters: Iterable[Letter]) -> Iterator[Label]:
    """Yield the direction of each letter that most tables count in; the others say their own below them."""
    counts: dict[Label, Counter[Label]] = {}
    for one in letters:
        if one.direction:
            counts.setdefault(one.symbol, Counter()).update((one.direction,))
    for symbol, count in counts.items():
        ((direction, _),) = count.most_common(1)
        yield direction if direction.startswith("$") else f"{symbol}: {direction}"


def _item(label: Label) -> prose.Blocks:
    return (prose.Paragraph(inlines(label)),)


def _line(symbol: Label, said: str) -> prose.Blocks:
    return _item(f"{symbol} {said}")


def _list(items: Iterable[prose.Blocks]) -> prose.Listing:
    return prose.Listing(None, True, tuple(items))
