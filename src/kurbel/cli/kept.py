"""What a command made, kept for a handbook or a marked place instead of being written."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import click


@dataclass
class Kept:
    """Takes the table or the drawing that a command would print, and how: language, decimal mark, and whether
    LaTeX may break it over pages."""

    made: Any = None
    lang: str = ""
    decimal: str | None = None
    longtable: bool = False


def keeper() -> Kept | None:
    """Return what takes the place of the output, if the command does not print."""
    return click.get_current_context().find_object(Kept)
