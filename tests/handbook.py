"""A handbook of tables, drawings and texts in both languages, as its documents see it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache
from typing import Any, NamedTuple

from kurbel.cli.asking import asked
from kurbel.document import Chapter, Document, Item
from kurbel.render import render
from kurbel.table import Table

# What the chapters hold: a name, a language and the words of a command.
Words = tuple[str, str, str]


class Handbook(NamedTuple):
    """The document, its tables and the SVG files of its figures, by their names."""

    document: Document
    tables: Mapping[str, Table]
    drawings: Mapping[str, str]

    def fragments(self) -> dict[str, str]:
        """Return each table as HTML, and each figure as SVG."""
        return {name: render(table, "html") for name, table in self.tables.items()} | dict(self.drawings)


def handbook(lang: str, chapters: Sequence[tuple[str, Sequence[Words | tuple[Any, ...]]]]) -> Handbook:
    """Make a handbook; a chapter's entry that is no words is the blocks of a text."""
    tables: dict[str, Table] = {}
    drawings: dict[str, str] = {}
    made = []
    for number, (title, entries) in enumerate(chapters, 1):
        items = []
        for entry in entries:
            items.append(_item(entry, lang, tables, drawings))
        made.append(Chapter(title, f"chapter-{number}", number, tuple(items)))
    document = Document(
        "Tafeln des Kurbeltriebs", lang, "comma" if lang == "de" else "point", tuple(made),
        "Kolbenwege, Geschwindigkeiten und Kräfte für $R:L = 1:3$ bis $1:8$", "Gustav Herrmann",
    )  # fmt: skip
    return Handbook(document, tables, drawings)


def _item(entry: Any, lang: str, tables: dict[str, Table], drawings: dict[str, str]) -> Item:
    if len(entry) == 2:
        return Item("text", lang=entry[0], blocks=entry[1])
    name, own, words = entry
    made = asked(words.split(), {"lang": own}).made
    if isinstance(made, Table):
        tables[name] = replace(made, key=name, layout=made.layout or made.key)
        return Item("table", name, len(tables), own, made.caption)
    from kurbel.plot_style import image

    drawings[name] = image(made.figure, "svg", "").decode()
    return Item("figure", name, len(drawings), own, made.title)
