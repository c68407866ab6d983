"""A sweep is run: its parts are computed, and become a file that is whole or absent."""

from __future__ import annotations

from collections import Counter
from typing import NamedTuple

from kurbel.sweeps.files.parquet import write
from kurbel.sweeps.rows import Sweep


class Outcome(NamedTuple):
    """How many rows were written, and how many of them were refused, by the sentence."""

    rows: int
    refused: Counter[str]


def run(sweep: Sweep, target: str) -> Outcome:
    """Write the sweep to a file. Raises KurbelError."""
    write(sweep, target)
    return Outcome(len(sweep), Counter())
