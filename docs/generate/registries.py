"""The pages of the reference about quantities, layouts, worked examples, formats, methods and loads."""

from __future__ import annotations

from collections.abc import Iterator

from kurbel.books.example import example, numbers_of, source_keys
from kurbel.drive.load import LOADS
from kurbel.drive.mechanisms import MECHANISMS
from kurbel.engine.engine_quantities import ENGINE_METHODS
from kurbel.formats.registry import FORMATS
from kurbel.motion.drives import condition_names
from kurbel.motion.evaluation import METHODS
from kurbel.motion.mechanism import mechanism, uncomputed
from kurbel.page.labels import plain
from kurbel.page.layouts import SUBJECTS, layout, layout_names
from kurbel.page.subject import subject
from kurbel.plot.style import FORMATS as DRAWINGS
from kurbel.reading.notation import ratio_text, ratios

FOLDER = "reference"


def pages() -> Iterator[tuple[str, str]]:
    for name, lines in (
        ("quantities", _quantities()),
        ("layouts", _layouts()),
        ("examples", _examples()),
        ("formats", _formats()),
        ("methods", _methods()),
        ("loads", _loads()),
    ):
        yield f"{FOLDER}/{name}.md", "\n".join(lines) + "\n"


def _quantities() -> Iterator[str]:
    yield "# Quantities\n"
    yield "Keys of `--columns`, of CSV headers and of JSON; they stay stable. `ratio` is the crank ratio"
    yield "R:L, `phi` the crank angle in degrees from the dead centre of its stroke, of the offset crank, the"
    yield "arc crank and the beam engine from the slide direction. `card` stands in place of `epsilon` where"
    yield "there is one, and the unit of a residual `moment` is that of a `force` times a. Behind a colon is"
    yield "said how a quantity counts. Beside its own keys `kurbel solve` has those of `kurbel table` without"
    yield "`_return`, which stand for either stroke."
    rows: dict[str, list[str]] = {}
    axes: dict[str, list[str]] = {}
    for about in map(subject, SUBJECTS):
        for one, command in about.entries():
            name, unit = about.name_of(one, "en"), one.plain_unit("en")
            decimals = "" if not one.formulas else "5 figures" if one.decimals is None else one.decimals
            counts = f": {plain(one.direction['en'])}" if one.direction else ""
            row = f"| `{one.key}` | {name}{counts} | {unit} | {decimals} | `{command}` |"
            rows.setdefault(command.split()[0], []).append(row)
        axes.setdefault(about.command.split()[0], []).extend(about.axis_keys)
    for command, lines in rows.items():
        keys = ", ".join(f"`{key}`" for key in dict.fromkeys(axes[command]))
        yield f"\n## Of kurbel {command}\n\nBeside {keys}:\n"
        yield "| key | quantity | unit | decimals | command |\n| --- | --- | --- | ---: | --- |"
        yield from lines
    yield "\nConditions of `kurbel solve`, by the mechanism, are about:\n"
    asked: dict[tuple[str, ...], list[str]] = {}
    for drive in map(mechanism, MECHANISMS):
        if names := tuple(condition_names(drive.conditions().values())):
            asked.setdefault(names, []).append(drive.title.removeprefix("the "))
    for names, titles in asked.items():
        yield f"- {' and '.join(titles)}: {', '.join(f'`{name}`' for name in names)}"


def _layouts() -> Iterator[str]:
    yield "# Layouts\n\n| name | page | about | ratios | angles, ε or a/r | columns |"
    yield "| --- | --- | --- | --- | --- | --- |"
    for name in layout_names():
        page = layout(name)
        defaults = ", ".join(ratio_text(ratio) for ratio in ratios(page.ratios))
        others = "; ".join((*page.expansions, *page.arms, *page.angles))
        columns = ", ".join(f"`{column.key}`" for column in page.columns)
        yield f"| `{name}` | {page.title['en']} | {page.subject} | {defaults} | {others} | {columns} |"


def _examples() -> Iterator[str]:
    yield "# Worked examples\n\nOf `kurbel example`.\n\n| source | number | title | takes |"
    yield "| --- | --- | --- | --- |"
    for key in source_keys():
        for number in numbers_of(key):
            one = example(key, number)
            takes = " ".join(f"`--{name}`" for name in one.page.takes)
            yield f"| `{key}` | `{number}` | {one.page.title['en']} | {takes} |"


def _formats() -> Iterator[str]:
    yield "# Formats\n\n| name | suffix | what it is |\n| --- | --- | --- |"
    for form in FORMATS.values():
        yield f"| `{form.name}` | {' '.join(form.suffixes)} | {form.media} |"
    drawings = ", ".join(f"`{name}`" for name in DRAWINGS)
    yield (
        "\nText in CSV that begins with =, +, - or @ and is not a mere figure such as -0,0667 or -2°30' has"
        "\nan apostrophe before it, so that no spreadsheet runs it. Numbers are written as printed."
    )
    yield f"\nOf drawings: {drawings}, 120 mm wide; suffixes alike."


def _loads() -> Iterator[str]:
    yield "# Loads\n\nOf `kurbel forces` and its drawings; those that are written so, of `--force`.\n"
    yield "| load | written | mechanisms |\n| --- | --- | --- |"
    for load, one in LOADS.items():
        takers = [name for name in MECHANISMS if not uncomputed(mechanism(name), load)]
        yield f"| {one.title} | {one.example and f'`{one.example}`'} | {', '.join(takers)} |"


def _methods() -> Iterator[str]:
    yield "# Methods\n\n| name | formulas |\n| --- | --- |"
    for method in METHODS.values():
        yield f"| `{method.key}` | {method.name['en']} |"
    yield "\nOf engines:\n\n| name | formulas |\n| --- | --- |"
    for method in ENGINE_METHODS.values():
        yield f"| `{method.key}` | {method.name['en']} |"
