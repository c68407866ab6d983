"""`kurbel sources`, `kurbel collate` and `kurbel example`: the books, their tables and worked examples."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

import click

from kurbel.books.example import example as worked
from kurbel.books.example import numbers_of, source, source_keys
from kurbel.books.source import books
from kurbel.cli.listing import Entry, Heading, Listing, form_of_list, list_format, show_list
from kurbel.cli.options import Option, TypedOptions, click_option, lang_option
from kurbel.cli.tables import CollateCommand, PrintOptions, TableCommand
from kurbel.commands import books as pages
from kurbel.commands import motion
from kurbel.errors import ProblemError
from kurbel.page.subject import Question
from kurbel.reading.given import File

if TYPE_CHECKING:
    from kurbel.commands.shown import Drawing
    from kurbel.page.table import Table

# Of what a source says about itself, and the heads of the lists.
WORDS = {
    "stated": {"de": "Belegt", "en": "Stated"},
    "inferred": {"de": "Erschlossen", "en": "Inferred"},
}
HEADS: Mapping[str, Mapping[str, Sequence[str]]] = {
    "sources": {
        "de": ("Tafel", "Inhalt; kurbel collate vergleicht sie"),
        "en": ("table", "contents; kurbel collate compares them"),
    },
    "example": {
        "de": ("Quelle", "Nr.", "Beispiel", "nimmt"),
        "en": ("source", "no.", "example", "takes"),
    },
}
_OF_COLLATION = {one.name: one for one in pages.collate.command.parameters.values()}


@click.command(params=[click_option(_OF_COLLATION["sources"]), list_format(), lang_option("list")])
def sources(sources: File | None, form: str, lang: str) -> None:
    """List the books that kurbel knows, with their tables."""
    # All are read before any is listed.
    known = tuple(books(sources))
    entries: list[Entry | Heading] = []
    plain, rows = [], []
    for book in known:
        own = {name: getattr(book, name)[lang] for name in WORDS}
        about = [f"{WORDS[name][lang]}: {text}" for name, text in own.items() if text]
        title = f"{book.key}: {book.citation[lang]}"
        tables = [(table.key, table.title[lang]) for table in book.all_tables]
        entries += [Heading(title, about), *tables]
        plain += [title, *(f"    {line}" for line in (*about, *map("  ".join, tables)))]
        rows += [(book.key, book.citation[lang], *own.values(), *table) for table in tables or [("", "")]]
    keys = ("source", "citation", *WORDS, "table", "title")
    show_list(Listing("sources", lang, keys, rows, HEADS["sources"][lang], entries), form, plain)


class ExampleCommand(TableCommand):
    """`kurbel example`, which lists the examples where none is named."""

    def run(self, given: TypedOptions) -> int:
        if given.values["number"] is not None:
            return super().run(given)
        key, lang = given.text("book"), given.text("lang")
        keys = source_keys() if not key else [source(key).key]
        form = form_of_list(given, ("book", "number", "lang"), "the page of an example", "blau 33")
        rows = [row for one in keys for row in _rows(one, lang)]
        own = ("source", "number", "title", "options")
        show_list(Listing("examples", lang, own, rows, HEADS["example"][lang], rows), form)
        return 0

    def made(self, given: TypedOptions) -> Table | Drawing:
        if given.values["number"] is None:
            words = " ".join(filter(None, ("example", given.text("book"))))
            raise ProblemError(f'"{words[:60]}" prints a list; a document needs a table')
        return super().made(given)

    def print(self, question: Question, printing: PrintOptions, given: TypedOptions) -> None:
        printing.print(self.made_by.built(question, given))


def _rows(key: str, lang: str) -> Iterator[tuple[str, ...]]:
    for number in numbers_of(key):
        one = worked(key, number)
        yield key, number, one.page.title[lang], " ".join(f"--{name}" for name in one.page.takes)


_OF_TABLES = {one.name: one for one in motion.table.command.parameters.values()}
collate = CollateCommand(
    "collate",
    pages.collate.command,
    {
        "columns": [
            Option(
                ["--strict"], is_flag=True, topic="question", help="Exit with 1 if a printed value deviates."
            )
        ],
        "": [click_option(_OF_TABLES[name]) for name in ("digits", "rounding")],
    },
)
example = ExampleCommand("example", pages.example.command)
