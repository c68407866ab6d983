"""The help of a command: in short, of one topic, and the whole; examples fit the terminal."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator, Mapping, Sequence

import click

from kurbel.cli import LANGUAGES
from kurbel.cli.manual.command import TopicCommand
from kurbel.cli.manual.topics import (
    DEFAULTS,
    SHORTER,
    Topic,
    first_of,
    flag_of,
    is_sweep,
    options_of,
    topical,
    topics_of,
)
from kurbel.reading.given import choose

# What an option takes in the first column; a longer one has its sentence below it.
WIDEST = 26
# What stands before a line that goes on an example of the shell.
FURTHER = 4
INDENT, GAP, APART = 2, 2, 3
# What stands before topics and ways on.
HEAD = 8
# Where a sentence of an option ends, and where one of its clauses begins.
_SENTENCE = re.compile(r"; |\.(?: |$)")
_CLAUSE = re.compile(r"(?=[,:;] | \()")
_DEFAULT = re.compile(r"[;.] default:? (.+?)(?=[;,(]|\.(?: |$)|$)", re.IGNORECASE)
# A list, which a shell takes for one word in quotes alone.
_LIST = re.compile(r"(?<![\w';.])[\w.:/-]+(?:;[\w.:/-]+)+(?!')")
# Where such a line can begin: at an option.
_OPTION = re.compile(r" (?=--?[a-z])")


def write_text(text: str, formatter: click.HelpFormatter) -> None:
    """Write what the command does, and how pages come to be in English."""
    formatter.write_paragraph()
    with formatter.indentation():
        formatter.write_text(folded(text, formatter.width - formatter.current_indent))
        formatter.write_paragraph()
        formatter.write_text(LANGUAGES)


def folded(text: str, width: int) -> str:
    """Return the text with examples of the shell on as many lines as they need."""
    return "\n".join(
        line
        for one in text.split("\n")
        for line in (_folded(one, width) if one.startswith("kurbel ") else (one,))
    )


def _folded(example: str, width: int) -> Iterator[str]:
    first, *options = _OPTION.split(example)
    line = first
    for place, option in enumerate(options):
        # The backslash that goes on needs two columns, but behind the last option.
        room = width - (2 if place < len(options) - 1 else 0)
        if len(line) + 1 + len(option) > room:
            yield f"{line} \\"
            line = " " * FURTHER + option
        else:
            line += f" {option}"
    yield line


def write_options(command: click.Command, context: click.Context, formatter: click.HelpFormatter) -> None:
    """Write the options in their topics, their sentences below each other throughout."""
    found = [(topic, list(_records(options, context))) for topic, options in topics_of(command)]
    width = _column([written for _, rows in found for written, _ in rows])
    for topic, rows in found:
        _write_records(topic.title, rows, width, formatter)


def _column(written: Sequence[str]) -> int:
    """Return how wide the first column is."""
    return max((len(one) for one in written if len(one) <= WIDEST), default=0)


def _write_records(
    title: str, rows: Sequence[tuple[str, str]], width: int, formatter: click.HelpFormatter
) -> None:
    (written, told), *others = rows
    with formatter.section(title):
        # click makes the column as wide as what stands in it.
        formatter.write_dl([(written.ljust(width), told), *others], col_max=WIDEST)


def _records(options: Sequence[click.Option], context: click.Context) -> Iterator[tuple[str, str]]:
    for one in options:
        if record := one.get_help_record(context):
            yield record


def topic_text(context: click.Context, name: str) -> str:
    """Return the options of one topic, with an example and its keys in a machine's file. Raises
    ChoiceError."""
    command = context.command
    found = {topic.name: (topic, options) for topic, options in topics_of(command)}
    topic, options = found[choose(name, found, f"topic of {context.command_path}")]
    formatter = context.make_formatter()
    rows = list(_records(options, context))
    _write_records(topic.title, rows, _column([written for written, _ in rows]), formatter)
    if words := topical(command, topic.name, options):
        with formatter.section("An example"):
            write_examples([(f"{context.command_path} {words}", "")], formatter)
    if keys := [*_machine_keys(command, options)]:
        with formatter.section("In a machine file, --machine engine.toml"):
            formatter.write_dl(keys)
    if beside := _beside(command, topic):
        with formatter.section("Options of other topics go with these"):
            formatter.write_dl(beside)
    formatter.write_paragraph()
    formatter.write_text(f"Topics: {' '.join(found)}")
    return formatter.getvalue()


def _machine_keys(command: click.Command, options: Sequence[click.Option]) -> Iterator[tuple[str, str]]:
    """Yield the sections of a machine's file that have keys for these options, with those."""
    if not any(one.name == "machine" for one in command.params):
        return
    from kurbel.commands.machine_file import machine_keys

    for title, section in machine_keys().items():
        keys = {option.name: key for key, option in section.items()}
        if found := [keys[one.name] for one in options if one.name in keys]:
            yield f"[{title}]", " ".join(found)


def _beside(command: click.Command, topic: Topic) -> Sequence[tuple[str, str]]:
    """Return the options of other topics that go with those of one, by their topics."""
    from kurbel.commands.machine_file import machine_keys

    homes = {one.name: other.name for other, listed in topics_of(command) for one in listed}
    options, parts = options_of(command), dict[str, str]()
    for name in (*topic.also.split(), *(one.name for one in machine_keys().get(topic.name, {}).values())):
        if homes.get(name, topic.name) != topic.name:
            parts[homes[name]] = f"{parts.get(homes[name], '')} {flag_of(options[name])}".strip()
    return [*parts.items()]


def short_text(context: click.Context) -> str:
    """Return what one needs first: what is printed, examples with what they are, some options, all topics."""
    command, path = context.command, context.command_path
    assert isinstance(command, TopicCommand)
    formatter = context.make_formatter()
    command.format_usage(context, formatter)
    formatter.write_paragraph()
    with formatter.indentation():
        formatter.write_text(inspect.cleandoc(command.help or "").partition("\n\n")[0])
    with formatter.section("Examples"):
        write_examples(command.examples, formatter)
    options = first_of(command)
    records = [(one, record[0]) for one in options if (record := one.get_help_record(context))]
    width = min(max(len(written) for _, written in records), WIDEST)
    with formatter.section("First"):
        for one, written in records:
            room = formatter.width - INDENT - max(width, len(written)) - GAP
            formatter.write(f"{'':{INDENT}}{written:{width}}{'':{GAP}}{brief(one, context, room)}\n")
    formatter.write_paragraph()
    _write_headed("Topics:", [" ".join(topic.name for topic, _ in topics_of(command))], formatter)
    more = (
        (f"{path} --help TOPIC", "one topic, with an example"),
        (f"{path} --help", "all options"),
        ("kurbel help --search WORD", "what you do not know the name of"),
    )
    column = max(len(line) for line, _ in more)
    _write_headed("More:", [f"{line:{column}}   {what}" for line, what in more], formatter)
    return formatter.getvalue()


def _write_headed(head: str, lines: Sequence[str], formatter: click.HelpFormatter) -> None:
    for line in lines:
        text = click.formatting.wrap_text(line, formatter.width - HEAD) if head == "Topics:" else line
        for one in text.split("\n"):
            formatter.write(f"{head:{HEAD}}{one}\n")
            head = ""


def write_examples(lines: Sequence[tuple[str, str]], formatter: click.HelpFormatter) -> None:
    """Write lines and what each is: in a column behind them, right behind one that is longer, or below."""
    width = formatter.width - INDENT
    room = width - max(len(what) for _, what in lines)
    column = max((len(line) + APART for line, _ in lines if len(line) + APART <= room), default=FURTHER)
    for line, what in lines:
        *before, last = folded(line, width).split("\n")
        place = max(column, len(last) + APART)
        if what and place + len(what) > width:
            before, last, place = [*before, last], "", column
        for one in (*before, f"{last:{place}}{what}".rstrip()):
            formatter.write(f"{'':{INDENT}}{one}\n")


def brief(option: click.Option, context: click.Context, room: int) -> str:
    """Return the beginning of what an option says, as far as there is room, and its default."""
    text = _own(SHORTER, option, context) or _SENTENCE.split(option.help or "")[0]
    default = _default(option, context)
    end = f"  [{default}]" if default and not (";" in default and default in text) else ""
    text, end = (_LIST.sub(r"'\g<0>'", one) for one in (text, end))
    while len(text) + len(end) > room and (parts := _CLAUSE.split(text))[1:]:
        text = text[: -len(parts[-1])].rstrip(" ,:;(")
    return f"{text}{end}"


def _default(option: click.Option, context: click.Context) -> str:
    """Return the value of an option that is not typed."""
    own = _own(DEFAULTS, option, context)
    if own is not None:
        return own
    if option.show_default and option.default is not None:
        return str(option.default)
    found = _DEFAULT.search(option.help or "")
    return found[1] if found else ""


def _own(texts: Mapping[str, str], option: click.Option, context: click.Context) -> str | None:
    """Return a text on an option, of the command or of all."""
    if is_sweep(context.command) and f"sweep.{option.name}" in texts:
        return texts[f"sweep.{option.name}"]
    return texts.get(f"{context.command.name}.{option.name}", texts.get(option.name or ""))
