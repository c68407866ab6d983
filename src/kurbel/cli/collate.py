"""`kurbel sources` and `kurbel collate`: the books, and their printed values against recomputed ones."""

from __future__ import annotations

from typing import Any

import click

from kurbel.books.verdict import ONLY
from kurbel.cli.lists import lang_option
from kurbel.cli.options import Columns, Name, layout_option, output_options, sheet_of
from kurbel.errors import ProblemError
from kurbel.exact.numerals import ROUNDINGS

# Of what a source says about itself.
WORDS = {
    "stated": {"de": "Belegt", "en": "Stated"},
    "inferred": {"de": "Erschlossen", "en": "Inferred"},
}

folder_option = click.option(
    "--sources", metavar="DIR", type=click.Path(), help="A folder with books of your own, a folder each."
)


@click.command()
@folder_option
@lang_option
def sources(sources: str | None, lang: str) -> None:
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


@click.command()
@click.argument("table", required=False)
@click.option(
    "--csv",
    metavar="FILE",
    type=click.Path(),
    help="Your own transcription: phi, epsilon or arm, and printed values.",
)
@click.option("--quantity", metavar="KEY", help="With --csv: what is printed, such as x, c, p or delta.")
@click.option("-r", "--ratio", metavar="R:L", help="With --csv: crank ratio, such as 1:4,5.")
@click.option(
    "--method", metavar="METHOD", help="With --csv: exact (default), series, infinite, weisbach, approximate."
)
@click.option(
    "--only", type=Name("choice", lambda: ONLY), default="all", show_default=True,
    help="all, or deviations: what is not right.",
)  # fmt: skip
@click.option("--strict", is_flag=True, help="Exit with 1 if a printed value deviates.")
@click.option("--columns", type=Columns("collation"), multiple=True, metavar="NAMES",
              help="Keys of CSV and JSON and their order: place,printed,recomputed,verdict.")  # fmt: skip
@folder_option
@layout_option("collation", "collation")
@output_options
def collate(**options: Any) -> int:
    """Print a table of a book, or your own transcription, with the values that it should have.

    \b
    kurbel collate roetscher-112
    kurbel collate weisbach-150 --only deviations --lang en
    kurbel collate --csv scan.csv --quantity p --ratio 1:4 --method series --strict
    """  # fmt: skip
    from kurbel.books.collate_page import CollateRequest
    from kurbel.books.transcription import collated_table
    from kurbel.cli.printing import Printing, print_table
    from kurbel.page.layouts import layout_of

    if options["csv"] is not None and options["table"] is not None:
        raise ProblemError("--csv is a table of your own, and one of a book is named too; leave one out")
    if options["digits"] is not None:
        raise ProblemError("--digits has no use here: a value is recomputed to as many places as are printed")
    if options["rounding"] != ROUNDINGS[0]:
        raise ProblemError("--rounding has no use here: printed values are held against half rounded away")
    printing = Printing.chosen(options)
    names = ("table", "csv", "quantity", "ratio", "method", "sources")
    table, collated = collated_table(*(options[name] for name in names))
    request = CollateRequest(
        layout=layout_of(options["layout"], ("collation",)),
        table=table,
        collated=collated,
        only=options["only"],
        **sheet_of(options, "place,printed,recomputed"),
    )
    print_table(request, printing)
    return int(options["strict"] and bool(request.deviations))
