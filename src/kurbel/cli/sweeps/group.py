"""`kurbel sweep` and what can be swept: the commands that print tables of a machine."""

from __future__ import annotations

import click

from kurbel.cli import COMMANDS
from kurbel.cli.app import Group, command_of

# Those of books have nothing that varies.
TABLES = tuple(name for name, (place, _) in COMMANDS.items() if ":" in place)


class _Commands(Group):
    what = "command that can be swept"

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(TABLES)

    def get_command(self, ctx: click.Context, name: str) -> click.Command | None:
        if name not in TABLES:
            return None
        from kurbel.cli.sweeps.command import SweepCommand
        from kurbel.cli.tables import TableCommand

        table = command_of(name)
        assert isinstance(table, TableCommand)
        return SweepCommand(name, COMMANDS[name][0], table.made_by)


@click.group(cls=_Commands)
def sweep() -> None:
    """Compute a command at every combination of what its options are given, into a file of columns.

    \b
    kurbel sweep delta --eps 1..10:0.01 --ratio 1:3..8:0.05 -o delta.parquet
    kurbel sweep table --ratio 1:3..8:0.05 --step 0.01 --columns x,c,p -o motion.parquet
    """
