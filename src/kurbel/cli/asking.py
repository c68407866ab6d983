"""A command's words become the table or the drawing that it would print: for handbooks and marked places.

Nothing from outside counts but the words and the defaults that are given with them: neither KURBEL_ variables
nor the folder in which kurbel runs.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

import click
from click.core import ParameterSource, augment_usage_errors

from kurbel.cli import COMMANDS
from kurbel.cli.app import command_of
from kurbel.cli.options import MACHINE, Document, FileName, Type, TypedOptions, defaults_by_machine
from kurbel.cli.tables import MakingCommand
from kurbel.errors import ChoiceError, FailedError, ProblemError
from kurbel.formats.registry import (
    DRAWINGS,
    DRAWN,
    FORMATS,
    BytesFormat,
    DocumentFormat,
    PageFormat,
    WorkbookFormat,
)
from kurbel.formats.render import as_one_page, render
from kurbel.handbook.matter import terse
from kurbel.handbook.pages import INSIDE, PAGE, SHEET, kept
from kurbel.handbook.pool import BuiltFiles, ListEntry, Task, Verified
from kurbel.page.labels import plain, unprompted
from kurbel.page.table import Note, Table
from kurbel.reading.given import HANDBOOK, File, allowed_name

if TYPE_CHECKING:
    from kurbel.commands.shown import Drawing
    from kurbel.exact.numerals import Label
    from kurbel.page.steps import Steps

# Those that print lists, or work on whole files.
NO_TABLES = frozenset(("sources", "layouts", "quantities", "verify", "handbook", "inject", "help", "sweep"))
# A document decides these for all of its tables; those of a single format, for which files it has.
ONLY_PRINTING = ("output", "format", "standalone", "excel")
SET_ELSEWHERE = (*ONLY_PRINTING, "longtable", "siunitx", "plain", "label", "layouts", "templates")
# Keys of a handbook. The numbers of a book's page are the book's: its commands take no others by default.
OF_THE_PAGE = frozenset(("lang", "decimal", "layouts"))


class CommandLine(NamedTuple):
    """What the words ask for: a table or a drawing, its language and decimal mark, the files read for it.

    `longtable` tells that LaTeX may break the table over pages. With `siunitx` LaTeX leaves the numbers to
    that package, and `plain` is what an author would type; `rounding` is that of the table's.
    """

    made: Table | Drawing
    lang: str
    decimal: str | None
    files: tuple[str, ...]
    longtable: bool = False
    siunitx: bool = False
    plain: bool = False
    rounding: str = ""


def printing_commands() -> tuple[str, ...]:
    """Return the names of the commands that print a table or draw."""
    return tuple(name for name in COMMANDS if name not in NO_TABLES)


def option_names() -> frozenset[str]:
    """Return the options of all these commands for which there may be defaults."""
    return frozenset(
        one.name
        for name in printing_commands()
        for one in command_of(name).params
        if isinstance(one, click.Option) and one.name and one.name not in (*SET_ELSEWHERE, *OF_THE_PAGE)
    )


def asked(
    words: Sequence[str],
    defaults: Mapping[str, object],
    machine: str | None = None,
    format: str | None = None,
    folder: str = "",
    inside: str = "",
) -> CommandLine:
    """Return what the words, a command and its options, ask for.

    `defaults` are options by their names, for those commands that have them; `machine` is a machine's file,
    which they outdo. Names of files count from the folder, in which they lie if they are to be `inside`, of a
    handbook or a document. With a format the table is for this one only, and the words may say what else is
    set for a document at once: its label, and for LaTeX that it may break over pages. Raises KurbelError,
    also for a mistake that click finds.
    """
    words = words[1:] if words[:1] in (["kurbel"], ("kurbel",)) else words
    if not words:
        raise ChoiceError(f"there is no command; write one of {', '.join(printing_commands())}")
    command = command_of(allowed_name(words[0], printing_commands(), "command"))
    assert isinstance(command, MakingCommand)
    document = Document(folder, inside)
    own = None if machine is None else document.file(machine)
    given = _defaults(command, defaults, own)
    if format is not None and "longtable" in {one.name for one in command.params}:
        given["format"] = format
    name = f"kurbel {words[0]}"
    try:
        context = command.make_context(name, [*words[1:]], obj=document, default_map=given)
        for one in SET_ELSEWHERE if format is None else ONLY_PRINTING:
            drawn = one == "format" and context.params[one] in (*DRAWINGS, DRAWN)
            if context.get_parameter_source(one) is ParameterSource.COMMANDLINE and not drawn:
                raise ProblemError(f"--{one} is for single tables; a document sets it by itself")
        with augment_usage_errors(context):
            made = command.made(TypedOptions(context))
    except click.ClickException as error:
        from kurbel.cli.misplaced import one_line

        raise ProblemError(one_line(error, words)) from None
    if isinstance(made, Table):
        made = _unprompted(made)
    values = context.params
    wishes = {one: values[one] for one in ("longtable", "siunitx", "plain", "rounding") if one in values}
    return CommandLine(made, values["lang"], values["decimal"], _files(context, own), **wishes)


def _unprompted(table: Table) -> Table:
    """Return a table of a document, whose readers have no options."""

    def quiet(notes: Iterable[Note]) -> tuple[Note, ...]:
        return tuple(note._replace(text=unprompted(note.text)) for note in notes)

    told = table.told and (table.told[0], quiet(table.told[1]))
    steps = table.steps and table.steps.named(_unprompted)
    return replace(table, notes=quiet(table.notes), told=told, steps=steps)


def _defaults(
    command: click.Command, defaults: Mapping[str, object], machine: File | None
) -> dict[str, object]:
    params = {one.name: one for one in command.params if isinstance(one, click.Option)}
    allowed = set(params) if "machine" in params else OF_THE_PAGE & set(params)
    given: dict[str, object] = {}
    if machine is not None and "machine" in params:
        given |= defaults_by_machine(command, machine)
    for name, value in defaults.items():
        if name in allowed:
            given[name] = _value(params[name], value)
    return given


def _value(param: click.Option, value: object) -> object:
    """Return a default as click takes it: a list for an option that may be repeated."""
    if isinstance(value, bool):
        return value
    if param.multiple:
        return [str(one) for one in value] if isinstance(value, list) else [str(value)]
    return ";".join(map(str, value)) if isinstance(value, list) else str(value)


def _files(context: click.Context, machine: File | None) -> tuple[str, ...]:
    """Return the files and folders that the options name, as they are named."""
    found: list[object] = [machine] if machine else []
    found += [context.meta[MACHINE]] if MACHINE in context.meta else []
    for param in context.command.params:
        value = context.params.get(param.name or "")
        if value and isinstance(param.type, FileName | Type):
            for one in value if param.multiple else (value,):
                param.type.kind.with_files(one, found.append)
    return tuple(dict.fromkeys(map(str, found)))


def make_part(task: Task) -> BuiltFiles:
    """Return the files of the part; raise KurbelError if it cannot be made.

    It is made in the manifest's folder, beside which the files lie that its command names.
    """
    part = task.part
    options = {**part.options, "label": part.name}
    inside = "" if task.outside else HANDBOOK
    answer = asked(part.words, options, task.machine, folder=task.folder, inside=inside)
    made = answer.made
    return _table(task, answer, made) if isinstance(made, Table) else _figure(task, answer, made)


def _table(task: Task, answer: CommandLine, table: Table) -> BuiltFiles:
    part = task.part
    caption, layout = part.caption or table.caption, table.layout or table.key
    # Records are computed as they are run through: once for all formats.
    records = table.records._replace(rows=[*table.records.rows])
    # The manifest's names are all different, also where one is that of a layout.
    named = replace(table, key=part.name, layout=layout, variant=None, records=records)
    told = table.told and (part.caption or table.told[0], table.told[1])
    data = replace(named, caption=caption, told=told)
    named = replace(named, caption=_caption(task, table.caption, table.lang), steps=_steps(task, table))
    with as_one_page(task.templates or table.templates):
        files = {
            f"tables/{part.name}{FORMATS[name].suffixes[0]}": _text(
                data if FORMATS[name].kind == "records" else named, name, answer.decimal, task.templates
            )
            for name in task.formats
            if not isinstance(FORMATS[name], BytesFormat)
        }
        files |= _waiting(task, named, answer.decimal)
    about = ListEntry(
        "table", named.caption, named.lang, named.letters(), plain(named.source), answer.rounding
    )
    if task.verify:
        about = about._replace(verified=_verified(_text(data, "json", None, task.templates).decode()))
    return BuiltFiles(files, answer.files, about)


def _verified(page: str) -> Verified:
    """Return what a second computation confirms of a page in JSON. Raises FailedError for a wrong number."""
    from kurbel.commands.verified import checked, page_of
    from kurbel.verify import CONFIRMED, WRONG

    cells = [*checked(page_of(page, "the page"))]
    for cell in cells:
        if cell.verdict == WRONG:
            raise FailedError(f"a second computation finds a number wrong: {cell}")
    return Verified(sum(cell.verdict == CONFIRMED for cell in cells), len(cells))


def _steps(task: Task, table: Table) -> Steps | None:
    """Return the steps of an interactive table, called as it is in the handbook."""

    def called(one: Table) -> Table:
        caption = _caption(task, one.caption, one.lang)
        return replace(one, key=task.part.name, layout=one.layout or one.key, caption=caption, variant=None)

    return table.steps and table.steps.named(called)


def _waiting(task: Task, table: Table, decimal: str | None) -> dict[str, bytes]:
    """Return what the documents of the handbook are made of that do not take its tables as they lie there."""
    files = {}
    for form in (FORMATS[name] for name in task.formats):
        if isinstance(form, DocumentFormat):
            content = form.writer.kept(table, decimal, task.templates).encode()
            files[PAGE.format(task.part.name)] = content
        elif isinstance(form, PageFormat) and form.own_pages:
            page = render(table, form.name, decimal=decimal, templates=task.templates, place="handbook")
            files[INSIDE.format(task.part.name)] = page.encode()
        elif isinstance(form, WorkbookFormat) and not any(name.endswith(".json") for name in files):
            from kurbel.formats.workbook import page_sheet

            sheet = page_sheet(table, form.decimal_mark(table.lang, decimal), "")
            files[SHEET.format(task.part.name)] = kept(sheet)
    return files


def _caption(task: Task, own: Label, lang: str) -> Label:
    """Return the caption in a handbook: its own words, or what the command says."""
    if task.part.caption or not task.terse:
        return task.part.caption or own
    return terse(own, lang)


def _text(table: Table, name: str, decimal: str | None, templates: str | None) -> bytes:
    if FORMATS[name].kind == "records":
        # Data keep the point, so that programs need not know the language of the page.
        return render(table, name, templates=templates).encode()
    longtable = FORMATS[name].is_tall(table)
    return render(table, name, decimal=decimal, longtable=longtable, templates=templates).encode()


def _figure(task: Task, answer: CommandLine, drawing: Drawing) -> BuiltFiles:
    part = task.part
    caption = _caption(task, drawing.title, answer.lang)
    titled = replace(drawing, title=caption)
    files = {f"figures/{part.name}.{name}": titled.image(name) for name in task.figures}
    return BuiltFiles(files, answer.files, ListEntry("figure", caption, answer.lang))
