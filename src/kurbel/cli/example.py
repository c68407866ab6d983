"""`kurbel example`: the worked examples of the books, as printed and recomputed, or with other numbers."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

import click
from click.shell_completion import CompletionItem

from kurbel.cli.options import page_options
from kurbel.cli.table import RATIO
from kurbel.reading import notation

READERS: Mapping[str, Callable[[Any], Sequence[Fraction]]] = {
    "ratio": notation.ratios,
    "angle": notation.angles,
    "beam": lambda texts: notation.numbers(texts, "beam arm"),
    "force": lambda text: (_newtons(text),),
    "eps": lambda texts: notation.numbers(texts, "expansion ratio"),
    "back": lambda text: (notation.share(text, "back pressure"),),
}


def _newtons(text: str) -> Fraction:
    from kurbel.reading.units import force

    return force(text)


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


@click.command()
@click.argument("source", type=_Source(), required=False)
@click.argument("number", type=_Number(), required=False)
@RATIO
@click.option(
    "--angle",
    multiple=True,
    metavar="ANGLES",
    help="Crank angles in degrees, where the example starts from them: 60, lists 30;60.",
)
@click.option("--beam", multiple=True, metavar="A:R", help="Arm of the beam in crank radii: 3; lists 3;4.")
@click.option("--eps", multiple=True, metavar="ε", help="Expansion ratio ε: 4; lists 2;4, ranges 2..6.")
@click.option("--back", metavar="B", help="Back pressure R/Q: 0.1, 10%; default: the best, 1/ε.")
@click.option("--force", metavar="FORCE", help="Piston force, for newtons: 10kN.")
@page_options
def example(**options: Any) -> None:
    """Print a worked example of a book in its steps: each figure as printed, and what it should be.

    With numbers of one's own the same steps are worked with these. Without NUMBER the examples are listed.

    \b
    kurbel example
    kurbel example blau 33
    kurbel example blau 33 --ratio 1:4,5
    """  # fmt: skip
    if options["number"] is None:
        _print_list(options["source"], options["lang"])
        return
    from kurbel.cli.printing import Printing, print_made
    from kurbel.examples.page import build_example
    from kurbel.examples.request import ExampleRequest

    printing = Printing.chosen(options)
    request = ExampleRequest(
        source=options["source"],
        number=options["number"],
        own={name: read(options[name]) for name, read in READERS.items() if options[name]},
        lang=options["lang"],
        label=options["label"],
    )
    print_made(build_example(request), printing)


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
