"""`kurbel help`: what there is for what one wants, the help of a command or a topic, pages, and a search."""

from __future__ import annotations

import shlex
from collections.abc import Sequence

import click

from kurbel.cli import COMMANDS
from kurbel.cli.app import HELP_OPTIONS, command_of
from kurbel.cli.manual.command import TopicCommand, show_text
from kurbel.cli.manual.help import short_text, topic_text, write_examples
from kurbel.cli.manual.topics import TOPICS, Purpose, topics_of, wants
from kurbel.reading.given import allowed_name

MORE = (
    ("kurbel help WORD", "one of these, a command, a topic; else a search"),
    ("kurbel help --search WORD", "options, quantities, commands, pages, problems"),
    ("kurbel --help", "all commands"),
)


def _offered(context: click.Context, parameter: click.Parameter, begun: str) -> list[str]:
    known = [*(want.name for want in wants()), *COMMANDS, *(topic.name for topic in TOPICS)]
    return [name for name in dict.fromkeys(known) if name.startswith(begun)]


@click.command()
@click.argument("words", nargs=-1, metavar="[WORD]...", shell_complete=_offered)
@click.option(
    "--search",
    metavar="WORDS",
    help="Search commands, options, quantities, layouts, pages and problems of textbooks: 'rolling mill'.",
)
def help(words: tuple[str, ...], search: str | None) -> None:
    """Say what there is for what one has or wants, or search for a word.

    WORD is one of what `kurbel help` lists, a command, a command and a topic of it, a page, or a problem that
    a search finds.

    \b
    kurbel help
    kurbel help steam
    kurbel help table
    kurbel help forces masses
    kurbel help subjects/forces
    kurbel help --search pressure
    kurbel help wheels-lift
    """
    formatter = click.Context(help, terminal_width=None, max_content_width=None).make_formatter()
    if search is not None:
        _write_search(" ".join((search, *words)), formatter)
    elif not words:
        _write_wants(formatter)
    elif words[0] in COMMANDS:
        show_text(_of_command(words))
        return
    else:
        _write_word(" ".join(words), formatter)
    show_text(formatter.getvalue())


def _of_command(words: Sequence[str]) -> str:
    """Return the short help of a command, or of a topic that is named behind it."""
    context = click.Context(
        command_of(words[0]), info_name=f"kurbel {words[0]}", help_option_names=HELP_OPTIONS
    )
    rest = words[1:]
    if rest and isinstance(context.command, click.Group):
        name = allowed_name(rest[0], context.command.list_commands(context), f"command of kurbel {words[0]}")
        below = context.command.get_command(context, name)
        assert below
        context, rest = click.Context(below, context, info_name=name), rest[1:]
    if isinstance(context.command, TopicCommand):
        return topic_text(context, rest[0]) if rest else short_text(context)
    return context.get_help()


def _write_wants(formatter: click.HelpFormatter) -> None:
    formatter.write_text("kurbel help WORD, for what you have or want:")
    with formatter.indentation():
        formatter.write_dl([(want.name, want.sentence) for want in wants()])
    with formatter.section("More"):
        formatter.write_dl(MORE, 40)


def _write_word(word: str, formatter: click.HelpFormatter) -> None:
    """Write what a word is: a want, a topic, a page, a problem, or what a search for it finds."""
    from kurbel.cli.manual.search import page_names, page_text, problems

    name = word.removeprefix("docs/").removesuffix(".md")
    wanted = next((want for want in wants() if want.name == word), None)
    if wanted:
        _write_want(wanted, formatter)
    elif any(topic.name == word for topic in TOPICS):
        _write_topic(word, formatter)
    elif name in page_names():
        formatter.write(page_text(name))
    elif problem := next((one for one in problems() if one.name == word), None):
        formatter.write_text(problem.text)
        formatter.write_paragraph()
        write_examples([(shlex.join(("kurbel", *problem.words)), "")], formatter)
    else:
        _write_search(word, formatter)


def _write_want(want: Purpose, formatter: click.HelpFormatter) -> None:
    with formatter.section(want.sentence):
        write_examples(want.lines, formatter)
    names = dict.fromkeys(line.split()[1] for line, _ in want.lines)
    told = [(f"kurbel {name} -h", COMMANDS[name][1]) for name in names]
    with formatter.section("More"):
        formatter.write_dl([*told, *((f"kurbel help {page}", "to read") for page in want.pages.split())], 40)
    if any(topic.name == want.name for topic in TOPICS):
        _write_topic(want.name, formatter)


def _write_topic(name: str, formatter: click.HelpFormatter) -> None:
    """Write where the options of a topic are told, and which these are."""
    [topic] = [topic for topic in TOPICS if topic.name == name]
    having = []
    for command in COMMANDS:
        found = command_of(command)
        if isinstance(found, TopicCommand) and any(one == topic for one, _ in topics_of(found)):
            having.append(command)
    with formatter.section(f"{topic.title}, its options"):
        first, *others = having or ["sweep table"]
        further = f"; and so with {', '.join(others)}" if others else ""
        formatter.write_text(f"kurbel {first} --help {name}{further}")


def _write_search(text: str, formatter: click.HelpFormatter) -> None:
    from kurbel.cli.manual.search import search, write_found

    told, found = search(text)
    if told:
        formatter.write_text(told)
    write_found(found, formatter)
