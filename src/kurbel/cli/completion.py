"""Completion in fish for lists such as phi,x,c: click's script cuts every candidate at its first comma."""

from __future__ import annotations

from click.shell_completion import FishComplete, add_completion_class


class ListFishComplete(FishComplete):
    """click's completion for fish, parting only the kind of a candidate from the rest."""

    source_template = FishComplete.source_template.replace('string split ","', 'string split --max 1 ","')


add_completion_class(ListFishComplete)
