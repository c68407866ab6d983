"""The quantities of a table as a handbook lists them: their letters, names and units."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

from kurbel.documents import prose
from kurbel.exact.numerals import Label
from kurbel.page.labels import Mark, Prose, parse, primed
from kurbel.page.quantity import Words, words
from kurbel.page.table import Table


class Letter(NamedTuple):
    """A quantity: `symbol`, `unit` and `direction`, which says how it counts, are labels and may be empty."""

    name: str
    symbol: Label
    unit: Label
    direction: Label = ""


# What a quantity of a head such as "greatest speed at" or "thrust over" is.
_AT: Mapping[str, tuple[str, ...]] = {"de": (" bei", " über"), "en": (" at", " over")}
_ANGLE: Words = words("Winkel: {}|angle: {}")


def letters_of(table: Table) -> tuple[Letter, ...]:
    """Return the quantities of a table, its axes first; what has neither a letter nor a unit is none."""
    lang = table.lang
    # Columns are computed by a method, and axes are not.
    axes = (
        Letter(field.name, field.symbol, field.unit)
        for field in table.records.fields
        if field.symbol and not field.method
    )
    columns = (
        Letter(
            named(one.name[lang], lang),
            one.symbol,
            one.unit[lang],
            one.direction[lang] if one.direction else "",
        )
        for one in table.quantities
        if one.symbol or one.unit[lang]
    )
    return tuple(dict.fromkeys((*axes, *columns)))


def named(name: str, lang: str) -> str:
    """Return the name of a quantity outside of its head."""
    end = next((one for one in _AT[lang] if name.endswith(one)), "")
    return _ANGLE[lang].format(name.removesuffix(end)) if end else name


def inlines(label: Label) -> prose.Inlines:
    """Return a label as words and formulas of a text."""
    return tuple(_inlines(label))


def _inlines(label: Label) -> Iterator[prose.Inline]:
    for part in parse(label):
        if isinstance(part, Prose):
            yield prose.Text(primed(part.text))
        elif not isinstance(part, Mark):
            yield part


def text(words: str) -> prose.Paragraph:
    """Return words as a paragraph."""
    return prose.Paragraph((prose.Text(words),))


def parted(labels: Iterable[Label], by: str) -> prose.Inlines:
    """Return labels one behind another."""
    between = prose.Text(by)
    found = (one for label in labels for one in (between, *inlines(label)))
    return tuple(found)[1:]
