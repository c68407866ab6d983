"""The commands that print a table: each is made from the function that makes the table in Python."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import click

from kurbel.cli.machine import machine_option
from kurbel.cli.making import MakingCommand
from kurbel.cli.options import click_option, help_of, printing_options
from kurbel.cli.printing import Printing, print_table
from kurbel.cli.rivals import RIVALS, Given, resolved
from kurbel.commands.subject import Command

if TYPE_CHECKING:
    from kurbel.page.table import Table


class TableCommand(MakingCommand):
    """The command of a function; `more` options, by what they stand before, are of the command line alone."""

    def __init__(
        self, name: str, command: Command, more: Mapping[str, Sequence[click.Parameter]] | None = None
    ) -> None:
        super().__init__(name, params=_params(name, command, more or {}), help=help_of(command.ask))
        self.made_by = command

    def question(self, given: Given) -> Any:
        """Return what is asked for. Raises KurbelError."""
        return self.made_by.ask(**resolved(self.made_by, given, RIVALS.get(self.name or "", ())))

    def exit_code(self, given: Given, question: Any) -> int:
        """Return what the command ends with, once it has printed."""
        return 0

    def made(self, given: Given) -> tuple[Table, int]:
        """Return the table and the exit code, for a document."""
        # What cannot be printed so is refused, too.
        Printing.chosen(given)
        question = self.question(given)
        return self.made_by.built(question), self.exit_code(given, question)

    def run(self, given: Given) -> int:
        printing = Printing.chosen(given)
        question = self.question(given)
        self.print(question, printing)
        return self.exit_code(given, question)

    def print(self, question: Any, printing: Printing) -> None:
        print_table(question, printing)


class CollateCommand(TableCommand):
    """`kurbel collate`, which may end with 1, and takes neither digits nor rounding."""

    def question(self, given: Given) -> Any:
        from kurbel.errors import ProblemError
        from kurbel.exact.numerals import ROUNDINGS

        if given.values["digits"] is not None:
            raise ProblemError(
                "--digits has no use here: a value is recomputed to as many places as are printed"
            )
        if given.values["rounding"] != ROUNDINGS[0]:
            raise ProblemError(
                "--rounding has no use here: printed values are held against half rounded away"
            )
        return super().question(given)

    def exit_code(self, given: Given, question: Any) -> int:
        return int(given.values["strict"] and bool(question.deviations))


def _params(
    name: str, command: Command, more: Mapping[str, Sequence[click.Parameter]]
) -> list[click.Parameter]:
    own = {one.name: click_option(one) for one in command.parameters.values()}
    last = printing_options(name, {**own, **{one.name or "": one for one in more.get("", ())}})
    params: list[click.Parameter] = [machine_option()] if command.machine else []
    for key, param in own.items():
        if param not in last:
            params += [*more.get(key, ()), param]
    return params + last
