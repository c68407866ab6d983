"""`kurbel sources`, `kurbel collate` and `kurbel example`: the books, their tables and worked examples."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import click
from click.shell_completion import CompletionItem

from kurbel.cli.lists import lang_option
from kurbel.cli.options import FileName, Option, click_option
from kurbel.cli.printing import Printing, print_made
from kurbel.cli.rivals import Given
from kurbel.cli.tables import CollateCommand, TableCommand
from kurbel.commands import motion
from kurbel.commands.books import collation_table, example_table
from kurbel.errors import ProblemError
from kurbel.reading.given import File

# Of what a source says about itself.
WORDS = {
    "stated": {"de": "Belegt", "en": "Stated"},
    "inferred": {"de": "Erschlossen", "en": "Inferred"},
}


@click.command()
@click.option(
    "--sources", metavar="DIR", type=FileName(), help="A folder with books of your own, a folder each."
)
@lang_option
def sources(sources: File | None, lang: str) -> None:
    """List the books that kurbel knows, with their tables."""
    from kurbel.books.source import books

    # All are read before any is listed.
    for book in tuple(books(sources)):
        click.echo(f"{book.key}: {book.citation[lang]}")
        for name, text in (("stated", book.stated), ("inferred", book.inferred)):
            if text[lang]:
                click.echo(f"    {WORDS[name][lang]}: {text[lang]}")
        for table in book.tables:
            click.echo(f"    {table.key}  {table.title[lang]}")


# Generic from click 8.5 on, and not to be subscripted before.
class _Source(click.ParamType):  # type: ignore[type-arg]
    """The key of a source; the page itself refuses a wrong one."""

    name = "source"

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        from kurbel.examples.source import source_keys

        return [CompletionItem(key) for key in source_keys() if key.startswith(incomplete)]


class _Number(click.ParamType):  # type: ignore[type-arg]
    """The number of an example; which there are depends on the source."""

    name = "number"

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        from kurbel.examples.source import numbers_of, source_keys

        key = ctx.params.get("source")
        numbers = numbers_of(key) if key in source_keys() else ()
        return [CompletionItem(number) for number in numbers if number.startswith(incomplete)]


class ExampleCommand(TableCommand):
    """`kurbel example`, which lists the examples where none is named."""

    def __init__(self) -> None:
        super().__init__("example", example_table.command)
        for param in self.params:
            if param.name in ("source", "number"):
                param.type = _Source() if param.name == "source" else _Number()

    def run(self, given: Given) -> int:
        if given.values["number"] is not None:
            return super().run(given)
        _print_list(given.values["source"], given.values["lang"])
        return 0

    def made(self, given: Given) -> Any:
        if given.values["number"] is None:
            words = " ".join(filter(None, ("example", given.values["source"])))
            raise ProblemError(f'"{words[:60]}" prints a list; a document needs a table')
        return super().made(given)

    def print(self, question: Any, printing: Printing) -> None:
        print_made(self.made_by.built(question), printing)


def _print_list(key: str | None, lang: str) -> None:
    """Print the examples of a source, or of all, a line each."""
    from tabulate import tabulate

    from kurbel.examples.source import source, source_keys

    keys = source_keys() if key is None else [source(key).key]
    rows = [row for one in keys for row in _rows(one, lang)]
    click.echo(tabulate(rows, tablefmt="plain", disable_numparse=True))


def _rows(key: str, lang: str) -> Iterator[tuple[str, ...]]:
    from kurbel.examples.source import example, numbers_of

    for number in numbers_of(key):
        one = example(key, number)
        yield key, number, one.title[lang], " ".join(f"--{name}" for name in one.takes)


_OF_TABLES = {one.name: one for one in motion.table.command.parameters.values()}
collate = CollateCommand(
    "collate",
    collation_table.command,
    {
        "columns": [Option(["--strict"], is_flag=True, help="Exit with 1 if a printed value deviates.")],
        "": [click_option(_OF_TABLES[name]) for name in ("digits", "rounding")],
    },
)
example = ExampleCommand()
