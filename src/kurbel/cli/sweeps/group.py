"""`kurbel sweep` and what can be swept: the commands that print tables of a machine."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import click

from kurbel.cli import COMMANDS
from kurbel.cli.app import Group, command_of

# Those of books have nothing that varies.
TABLES = tuple(name for name, (place, _) in COMMANDS.items() if ":" in place)


class _Commands(Group):
    what = "command that can be swept"

    def further(self) -> Mapping[str, Sequence[click.Option]]:
        """Return the options of every sweep, by the heads below which manuals have them."""
        from kurbel.cli.manual.topics import topics_of
        from kurbel.cli.sweeps.options import sweep_options
        from kurbel.cli.sweeps.running import running_options

        own = click.Command("sweep", params=[*sweep_options(), *running_options()], add_help_option=False)
        return {topic.title: options for topic, options in topics_of(own)}

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(TABLES)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        from kurbel.cli.sweeps.from_file import FILE, SUFFIX, words_of

        if not args[0].endswith(SUFFIX) or ctx.resilient_parsing:
            return super().resolve_command(ctx, args)
        from kurbel.cli.sweeps.command import SweepCommand
        from kurbel.sweeps.sweep_file import ReadFile

        read = ReadFile(args[0])
        command = self.get_command(ctx, read.said.command)
        assert isinstance(command, SweepCommand)
        words, ctx.meta[FILE] = words_of(read, command, args[1:])
        return args[0], command, words

    def get_command(self, ctx: click.Context, name: str) -> click.Command | None:
        if name not in TABLES:
            return None
        from kurbel.cli.sweeps.command import SweepCommand
        from kurbel.cli.tables import TableCommand

        table = command_of(name)
        assert isinstance(table, TableCommand)
        return SweepCommand(name, COMMANDS[name][0], table.made_by)


@click.group(cls=_Commands, subcommand_metavar="COMMAND|FILE.toml [OPTIONS]...")
def sweep() -> None:
    """Compute a command at every combination of what its options are given, into a file of columns.

    \b
    kurbel sweep delta --eps 1..10:0.01 --ratio 1:3..8:0.05 -o delta.parquet
    kurbel sweep table --ratio 1:3..8 --step 0.01 --columns x,c -o motion.parquet
    kurbel sweep sweep.toml --dry-run

    COMMAND has the options that it has by itself, and each takes several values: lists '2;3;4', ranges
    2..6:0.5 with units, words. A file sweep.toml says the same: command, [axes], [options], output; what is
    typed outdoes it.
    """
