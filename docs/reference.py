"""Write docs/reference.md from registries, layouts and help texts; --check fails when it is stale."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import click

import kurbel
from kurbel.balance.harmonics_page import quantities as harmonics_registry
from kurbel.balance.request import DECIMALS, balance_registry
from kurbel.cli import COMMANDS
from kurbel.cli.app import command_of
from kurbel.commands.subject import Command
from kurbel.engine.page import printed_by
from kurbel.engine.quantities import ENGINE_METHODS, engine_registry
from kurbel.examples.source import example, numbers_of, source_keys
from kurbel.formats.registry import FORMATS
from kurbel.linkage.arc_drive import arc_names
from kurbel.linkage.beam import registry as beam_registry
from kurbel.linkage.quantities import arc_registry, page_command, parallel_registry
from kurbel.motion.drives import slide_names
from kurbel.motion.evaluation import METHODS, NEEDS
from kurbel.motion.inertia import inertia_registry
from kurbel.motion.inertia_page import SUBJECT as ERRORS
from kurbel.motion.inertia_page import UNITS, error_columns
from kurbel.motion.quantities import registry
from kurbel.page.labels import plain
from kurbel.page.layouts import layout, layout_names
from kurbel.plot.style import FORMATS as DRAWINGS
from kurbel.reading.notation import ratio_text, ratios
from kurbel.solve.page import own_columns

PAGE = Path(__file__).with_name("reference.md")


def reference() -> str:
    """Return the whole page."""
    parts = (_commands, _functions, _quantities, _layouts, _examples, _formats, _methods)
    return "\n".join(line for part in parts for line in part()) + "\n"


def _commands() -> Iterator[str]:
    yield "# Reference\n\nWritten by `make docs` from the program itself.\n\n## Commands"
    for name, (_, line) in COMMANDS.items():
        command = command_of(name)
        yield f"\n### kurbel {name}\n\n{line}\n\n{_help(command, f'kurbel {name}')}"
        if isinstance(command, click.Group):
            for one, inner in command.commands.items():
                yield f"\n#### kurbel {name} {one}\n\n{_help(inner, f'kurbel {name} {one}')}"


def _help(command: click.Command, name: str) -> str:
    context = click.Context(command, info_name=name, terminal_width=98, max_content_width=98)
    context.help_option_names = ["-h", "--help"]
    return f"```text\n{command.get_help(context)}\n```"


def _functions() -> Iterator[str]:
    yield "\n## Functions\n\nOf `import kurbel`; they return a `Table` or a `Drawing`. Parameters mean what"
    yield "the options of the same names do, and `help` of a function describes them."
    yield "\n| function | parameters |\n| --- | --- |"
    units: dict[str, set[str]] = {}
    for name in kurbel.__all__:
        command = getattr(getattr(kurbel, name), "command", None)
        if isinstance(command, Command):
            yield f"| `{name}` | {', '.join(f'`{one}`' for one in command.parameters)} |"
            for key, one in command.parameters.items():
                if one.option.unit:
                    units.setdefault(one.option.unit, set()).add(key)
    yield "\nText is read as on the command line.\n\n| bare numbers of | are in |\n| --- | --- |"
    for unit, keys in units.items():
        yield f"| {', '.join(f'`{key}`' for key in sorted(keys))} | {unit} |"


def _quantities() -> Iterator[str]:
    yield "\n## Quantities\n\nKeys of `--columns`, of CSV headers and of JSON; they stay stable.\n"
    yield "| key | quantity | unit | decimals | needs |\n| --- | --- | --- | ---: | --- |"
    yield "| `ratio` | Crank ratio R:L | | | |"
    yield "| `phi` | Crank angle from the dead centre of the stroke | ° | | |"
    for key, quantity in registry().items():
        name, unit = quantity.full_name("en"), quantity.plain_unit("en")
        options = " ".join(f"`{option}`" for option in NEEDS[quantity.needs])
        yield f"| `{key}` | {name} | {unit} | {quantity.decimals} | {options} |"
    yield from _engine_quantities()
    yield from _rod_quantities()
    yield from _solved()


def _engine_quantities() -> Iterator[str]:
    yield "\n### Of engines\n"
    yield "Beside them stand `epsilon` or `card`, `ratio`, and `stroke`, `phi` or `target`.\n"
    yield "| key | quantity | unit | decimals | command |\n| --- | --- | --- | ---: | --- |"
    for key, one in engine_registry().items():
        decimals = "5 figures" if one.decimals is None else one.decimals
        name, unit = f"{one.name['en']} {plain(one.symbol)}", one.plain_unit("en")
        yield f"| `{key}` | {name} | {unit} | {decimals} | `{printed_by(one)}` |"
    for key, beam in beam_registry().items():
        name = f"{beam.name['en']} {plain(beam.symbol)}"
        yield f"| `{key}` | {name} | {beam.plain_unit('en')} | {beam.decimals} | `deadcentres` |"
    yield from _balance_quantities()


def _balance_quantities() -> Iterator[str]:
    yield "\n### Of harmonics and balance\n"
    yield "Beside them stand `order` and `ratio`, for `balance` also `residual`: `force`, or `moment` in that"
    yield "unit times a.\n"
    yield "| key | quantity | unit | decimals | command |\n| --- | --- | --- | ---: | --- |"
    decimals = layout("harmonics").columns[0].decimals
    for key, harmonic in harmonics_registry().items():
        name, unit = f"{harmonic.name['en']} {plain(harmonic.symbol)}", harmonic.plain_unit("en")
        yield f"| `value` | {name} | {unit} | {decimals} | `harmonics --quantity {key}` |"
    for key, column in balance_registry().items():
        yield f"| `{key}` | {column.name['en']} | {column.plain_unit('en')} | {DECIMALS} | `balance` |"
    yield from _linkage_quantities()


def _linkage_quantities() -> Iterator[str]:
    yield "\n### Of the arc crank and the parallel crank\n"
    yield "Beside them stand `ratio`, for the arc crank, and `phi`.\n"
    for mechanism, linkage in (("arc", arc_registry()), ("parallel", parallel_registry())):
        for key, one in linkage.items():
            name = f"{one.full_name('en')} {plain(one.symbol)}"
            options = "".join(f" {option}" for option in NEEDS[one.needs])
            command = f"{page_command(one)} --mechanism {mechanism}{options}"
            yield f"| `{key}` | {name} | {one.plain_unit('en')} | {one.decimals} | `{command}` |"


def _rod_quantities() -> Iterator[str]:
    yield "\n### Of the connecting rod\n"
    yield "Printed by `kurbel inertia`, with a rod of `--centre` and `--gyration` or `--rod-file`.\n"
    yield "| key | quantity | unit | decimals | needs |\n| --- | --- | --- | ---: | --- |"
    for key, quantity in inertia_registry().items():
        options = " ".join(f"`{option}`" for option in NEEDS[quantity.needs])
        name = quantity.full_name("en")
        yield f"| `{key}` | {name} | {quantity.plain_unit('en')} | {quantity.decimals} | {options} |"
    axes = ", ".join(f"`{key}`" for key in ERRORS.axis_keys)
    yield f"\nOf the layout `inertia-errors`, beside {axes}:\n"
    yield "| key | quantity | unit | decimals | needs |\n| --- | --- | --- | ---: | --- |"
    for key, column in error_columns().items():
        options = " ".join(f"`{option}`" for option in NEEDS[column.needs])
        unit = column.plain_unit("en") or UNITS
        yield f"| `{key}` | {column.full_name('en')} | {unit} | {column.decimals} | {options} |"


def _solved() -> Iterator[str]:
    yield "\n### Of solved conditions\n"
    yield "Printed by `kurbel solve` beside `ratio`, `phi` and keys from above without `_return`, which stand"
    yield "there for either stroke.\n"
    yield "| key | quantity |\n| --- | --- |"
    for key, name in own_columns().items():
        yield f"| `{key}` | {name['en']} |"
    yield "\nConditions, by the mechanism, are about:\n"
    for mechanism, names in (("straight and offset", slide_names()), ("arc", arc_names())):
        yield f"- {mechanism} crank: {', '.join(f'`{name}`' for name in names)}"


def _layouts() -> Iterator[str]:
    yield "\n## Layouts\n\n| name | page | about | ratios | angles, ε or a/r | columns |"
    yield "| --- | --- | --- | --- | --- | --- |"
    for name in layout_names():
        page = layout(name)
        defaults = ", ".join(ratio_text(ratio) for ratio in ratios(page.ratios))
        others = "; ".join((*page.expansions, *page.arms, *page.angles))
        columns = ", ".join(f"`{column.key}`" for column in page.columns)
        yield f"| `{name}` | {page.title['en']} | {page.subject} | {defaults} | {others} | {columns} |"


def _examples() -> Iterator[str]:
    yield "\n## Worked examples\n\nOf `kurbel example`.\n\n| source | number | title | takes |"
    yield "| --- | --- | --- | --- |"
    for key in source_keys():
        for number in numbers_of(key):
            one = example(key, number)
            takes = " ".join(f"`--{name}`" for name in one.takes)
            yield f"| `{key}` | `{number}` | {one.title['en']} | {takes} |"


def _formats() -> Iterator[str]:
    yield "\n## Formats\n\n| name | suffix | what it is |\n| --- | --- | --- |"
    for form in FORMATS.values():
        yield f"| `{form.name}` | {' '.join(form.suffixes)} | {form.media} |"
    drawings = ", ".join(f"`{name}`" for name in DRAWINGS)
    yield (
        "\nText in CSV that begins with =, +, - or @ and is not a mere figure such as -0,0667 or -2°30' has"
        "\nan apostrophe before it, so that no spreadsheet runs it. Numbers are written as printed."
    )
    yield f"\nOf drawings: {drawings}, 120 mm wide; suffixes alike."


def _methods() -> Iterator[str]:
    yield "\n## Methods\n\n| name | formulas |\n| --- | --- |"
    for method in METHODS.values():
        yield f"| `{method.key}` | {method.name['en']} |"
    yield "\nOf engines:\n\n| name | formulas |\n| --- | --- |"
    for method in ENGINE_METHODS.values():
        yield f"| `{method.key}` | {method.name['en']} |"


def main() -> int:
    text = reference()
    if "--check" not in sys.argv:
        PAGE.write_text(text, encoding="utf-8")
        return 0
    if PAGE.exists() and PAGE.read_text(encoding="utf-8") == text:
        return 0
    print("docs/reference.md is stale; write it anew with: make docs", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
