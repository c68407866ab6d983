"""What a command is that makes a table or a drawing: it can be printed, or handed to a document."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click
from click.core import augment_usage_errors

from kurbel.cli.options import Document, Option
from kurbel.cli.rivals import Given
from kurbel.errors import ProblemError

if TYPE_CHECKING:
    from kurbel.commands.shown import Drawing
    from kurbel.page.table import Table


class MakingCommand(click.Command):
    """A command of which a document can ask what it makes."""

    def made(self, given: Given) -> tuple[Table | Drawing, int]:
        """Return the table or the drawing, and what the command would end with. Raises KurbelError."""
        raise NotImplementedError

    def run(self, given: Given) -> int:
        """Print what the options say, and return the exit code."""
        raise NotImplementedError

    def invoke(self, ctx: click.Context) -> int:
        with augment_usage_errors(ctx):
            return self.run(Given(ctx))

    def get_help_option(self, ctx: click.Context) -> click.Option | None:
        if not ctx.find_object(Document):
            return super().get_help_option(ctx)
        return Option(["-h", "--help"], is_flag=True, is_eager=True, expose_value=False, callback=_no_help)


def _no_help(context: click.Context, parameter: click.Parameter, asked: bool) -> None:
    if asked:
        raise ProblemError(f"{context.info_name} was asked for its help; a document needs a table")
