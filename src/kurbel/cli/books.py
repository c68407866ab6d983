"""`kurbel sources`, `kurbel collate` and `kurbel example`: the books, their tables and worked examples."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import click

from kurbel.cli.listing import Entry, Heading, Listing, list_format, list_formats, plain_lines, show_list
from kurbel.cli.options import Given, Option, click_option, lang_option
from kurbel.cli.tables import CollateCommand, Printing, TableCommand
from kurbel.commands import books as pages
from kurbel.commands import motion
from kurbel.errors import ProblemError
from kurbel.formats.registry import DEFAULT
from kurbel.reading.given import File

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
    from kurbel.books.source import books

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

    def run(self, given: Given) -> int:
        if given.values["number"] is not None:
            return super().run(given)
        keys = _keys(given.values["book"])
        _refuse_options(given)
        form = given.values["format"] if given.typed("format") else DEFAULT
        _print_list(keys, given.values["lang"], form)
        return 0

    def made(self, given: Given) -> Any:
        if given.values["number"] is None:
            words = " ".join(filter(None, ("example", given.values["book"])))
            raise ProblemError(f'"{words[:60]}" prints a list; a document needs a table')
        return super().made(given)

    def print(self, question: Any, printing: Printing, given: Given) -> None:
        printing.print(self.made_by.built(question, given))


def _keys(key: str | None) -> Sequence[str]:
    """Return the source of that key alone, or all."""
    from kurbel.books.examples.source import source, source_keys

    return source_keys() if key is None else [source(key).key]


def _refuse_options(given: Given) -> None:
    """Raise ProblemError for an option that the list of the examples has no use for."""
    listed = ["book", "number", "lang"]
    if given.values["format"] in list_formats():
        listed.append("format")
    for name in given.values:
        if name not in listed and given.typed(name):
            raise ProblemError(
                f"--{name} is for the page of an example, and none is named; name one, such as blau 33, or"
                f" leave --{name} out for the list"
            )


def _print_list(keys: Sequence[str], lang: str, form: str) -> None:
    """Print the examples of sources."""
    rows = [row for one in keys for row in _rows(one, lang)]
    own = ("source", "number", "title", "options")
    show_list(Listing("examples", lang, own, rows, HEADS["example"][lang], rows), form, plain_lines(rows))


def _rows(key: str, lang: str) -> Iterator[tuple[str, ...]]:
    from kurbel.books.examples.source import example, numbers_of

    for number in numbers_of(key):
        one = example(key, number)
        yield key, number, one.page.title[lang], " ".join(f"--{name}" for name in one.page.takes)


_OF_TABLES = {one.name: one for one in motion.table.command.parameters.values()}
collate = CollateCommand(
    "collate",
    pages.collate.command,
    {
        "columns": [Option(["--strict"], is_flag=True, help="Exit with 1 if a printed value deviates.")],
        "": [click_option(_OF_TABLES[name]) for name in ("digits", "rounding")],
    },
)
example = ExampleCommand("example", pages.example.command)
