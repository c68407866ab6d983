"""`kurbel sources`, `kurbel collate` and `kurbel example`: the books, their tables and worked examples."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import click

from kurbel.cli.options import Given, Option, click_option, lang_option
from kurbel.cli.tables import CollateCommand, Printing, TableCommand
from kurbel.commands import motion
from kurbel.commands.books import collation_table, example_table
from kurbel.errors import ProblemError
from kurbel.reading.given import File

# Of what a source says about itself.
WORDS = {
    "stated": {"de": "Belegt", "en": "Stated"},
    "inferred": {"de": "Erschlossen", "en": "Inferred"},
}


_OF_COLLATION = {one.name: one for one in collation_table.command.parameters.values()}


@click.command(params=[click_option(_OF_COLLATION["sources"]), lang_option("list")])
def sources(sources: File | None, lang: str) -> None:
    """List the books that kurbel knows, with their tables."""
    from kurbel.books.source import books

    # All are read before any is listed.
    for book in tuple(books(sources)):
        click.echo(f"{book.key}: {book.citation[lang]}")
        for name, text in (("stated", book.stated), ("inferred", book.inferred)):
            if text[lang]:
                click.echo(f"    {WORDS[name][lang]}: {text[lang]}")
        for table in book.all_tables:
            click.echo(f"    {table.key}  {table.title[lang]}")


class ExampleCommand(TableCommand):
    """`kurbel example`, which lists the examples where none is named."""

    def run(self, given: Given) -> int:
        if given.values["number"] is not None:
            return super().run(given)
        keys = _keys(given.values["book"])
        _refuse_options(given)
        _print_list(keys, given.values["lang"])
        return 0

    def made(self, given: Given) -> Any:
        if given.values["number"] is None:
            words = " ".join(filter(None, ("example", given.values["book"])))
            raise ProblemError(f'"{words[:60]}" prints a list; a document needs a table')
        return super().made(given)

    def print(self, question: Any, printing: Printing) -> None:
        printing.print(self.made_by.built(question))


def _keys(key: str | None) -> Sequence[str]:
    """Return the source of that key alone, or all."""
    from kurbel.examples.source import source, source_keys

    return source_keys() if key is None else [source(key).key]


def _refuse_options(given: Given) -> None:
    """Raise ProblemError for an option that the list of the examples has no use for."""
    for name in given.values:
        if name not in ("book", "number", "lang") and given.typed(name):
            raise ProblemError(
                f"--{name} is for the page of an example, and none is named; name one, such as blau 33, or"
                f" leave --{name} out for the list"
            )


def _print_list(keys: Sequence[str], lang: str) -> None:
    """Print the examples of sources, a line each."""
    from tabulate import tabulate

    rows = [row for one in keys for row in _rows(one, lang)]
    click.echo(tabulate(rows, tablefmt="plain", disable_numparse=True))


def _rows(key: str, lang: str) -> Iterator[tuple[str, ...]]:
    from kurbel.examples.source import example, numbers_of

    for number in numbers_of(key):
        one = example(key, number)
        yield key, number, one.page.title[lang], " ".join(f"--{name}" for name in one.page.takes)


_OF_TABLES = {one.name: one for one in motion.table.command.parameters.values()}
collate = CollateCommand(
    "collate",
    collation_table.command,
    {
        "columns": [Option(["--strict"], is_flag=True, help="Exit with 1 if a printed value deviates.")],
        "": [click_option(_OF_TABLES[name]) for name in ("digits", "rounding")],
    },
)
example = ExampleCommand("example", example_table.command)
