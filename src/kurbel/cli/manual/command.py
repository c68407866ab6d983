"""A command that says of itself what one needs first, `-h`, the options of one topic, or the whole."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import click
from click.core import augment_usage_errors

from kurbel.cli.app import show
from kurbel.cli.options import Document
from kurbel.errors import ProblemError

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

WHOLE = "all"
# An example of the help, and what it is, which -h says.
_EXAMPLE = re.compile(r"^(kurbel .*?)  # (.*)$", re.MULTILINE)


class TopicName(click.ParamType):  # type: ignore[type-arg]
    """A topic of the help."""

    name = "topic"

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        from click.shell_completion import CompletionItem

        from kurbel.cli.manual.topics import topics_of

        return [
            CompletionItem(topic.name, help=topic.title)
            for topic, _ in topics_of(ctx.command)
            if topic.name.startswith(incomplete)
        ]


class HelpOption(click.Option):
    """`--help`, with the name of a topic or without; the help lists it with `-h`."""

    def __init__(self) -> None:
        super().__init__(
            ["help_topic", "--help"],
            is_flag=False,
            flag_value=WHOLE,
            type=TopicName(),
            metavar="[TOPIC]",
            is_eager=True,
            expose_value=False,
            allow_from_autoenv=False,
            callback=_show,
            help="What one needs first, -h; all options; or those of a topic.",
        )

    def get_help_record(self, ctx: click.Context) -> tuple[str, str]:
        assert self.help
        return "-h, --help [TOPIC]", self.help


class TopicCommand(click.Command):
    """A command whose options stand in topics, `in_short` those that one needs first. What it asks for has no
    words but behind options. Of the examples of its help -h has those that say what they are."""

    def __init__(self, name: str, help: str, in_short: str, **more: Any) -> None:
        text, self.examples = with_examples(help)
        super().__init__(name, help=text, **more)
        self.in_short = in_short
        self.add_help_option = False
        short = click.Option(
            ["help_short", "-h"], is_flag=True, is_eager=True, expose_value=False, hidden=True,
            allow_from_autoenv=False, callback=_show_short,
        )  # fmt: skip
        self._helps = [short, HelpOption()]

    def get_params(self, ctx: click.Context) -> list[click.Parameter]:
        return [*super().get_params(ctx), *self._helps]

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        ctx.allow_extra_args = True
        with augment_usage_errors(ctx):
            left = super().parse_args(ctx, [*args])
        if left and not ctx.resilient_parsing:
            from kurbel.cli.misplaced import stray

            raise click.UsageError(stray(left[0], self, args), ctx)
        return left

    def format_help_text(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        from kurbel.cli.manual.help import write_text

        write_text(self.help or "", formatter)

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        from kurbel.cli.manual.help import write_options

        write_options(self, ctx, formatter)


def with_examples(help: str) -> tuple[str, list[tuple[str, str]]]:
    """Return a help without what its examples are, and those that say it."""
    return _EXAMPLE.sub(r"\1", help), _EXAMPLE.findall(help)


def _show(context: click.Context, parameter: click.Parameter, asked: str | None) -> None:
    if asked is not None and not context.resilient_parsing:
        from kurbel.cli.manual.help import topic_text

        _end(context, lambda: context.get_help() if asked == WHOLE else topic_text(context, asked))


def _show_short(context: click.Context, parameter: click.Parameter, asked: bool) -> None:
    if asked and not context.resilient_parsing:
        from kurbel.cli.manual.help import short_text

        _end(context, lambda: short_text(context))


def _end(context: click.Context, text: Callable[[], str]) -> None:
    if context.find_object(Document):
        raise ProblemError(f"{context.info_name} was asked for its help; a document needs a table")
    show_text(text())
    context.exit()


def show_text(text: str) -> None:
    """Print a text, on a terminal through a pager what is long."""
    show([f"{text.rstrip()}\n".encode(sys.stdout.encoding, errors="replace")], has_words=False)
