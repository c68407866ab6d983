"""What was computed becomes the target: parts go in order into one file, partitions into a folder."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator

import pyarrow as pa
import pyarrow.compute as compute

from kurbel.sweeps.columns import MISSING
from kurbel.sweeps.files.arrow import REASON, with_options
from kurbel.sweeps.files.forms import PARTITIONS, Form
from kurbel.sweeps.files.parquet import gather, reasons_of
from kurbel.sweeps.rows import Sweep
from kurbel.sweeps.work.task import Unit
from kurbel.sweeps.work.units import Partitions, Parts

# Of so many kinds of refused rows is told how many there are of each, of all others together.
MOST_REASONS = 100
OTHERS = "other reasons"


def unit_of(sweep: Sweep, form: Form) -> Unit:
    """Return what is computed at once, which depends on the plan and the form alone."""
    return Partitions(sweep) if form is PARTITIONS and sweep.in_threads else Parts(sweep)


def joined(
    unit: Unit, form: Form, paths: Iterator[str], target: str, scratch: str, refused: Counter[str]
) -> int:
    """Write the target of the files of all units, in order, and count what was refused; return how many rows
    it has. Only a form of arrays has places for records that are not there."""
    if unit.suffix == Partitions.suffix:
        gather(_noted(paths, refused), target, scratch)
        return len(unit.sweep)
    rows = 0

    def batches() -> Iterator[pa.RecordBatch]:
        nonlocal rows
        for batch in _batches(unit, paths, refused):
            found = batch if form.in_places else _there(unit.sweep, batch)
            rows += found.num_rows
            yield found

    form.write(unit.sweep, batches(), target, scratch)
    return rows


def _there(sweep: Sweep, batch: pa.RecordBatch) -> pa.RecordBatch:
    """Return the rows without those that belong to no record; a refused combination has nothing that tells
    records apart."""
    reasons = batch[REASON]
    if reasons.null_count == len(reasons):
        return batch
    there = compute.fill_null(compute.not_equal(reasons, MISSING), True)
    refused = reasons.is_valid()
    for place, column in enumerate(sweep.columns):
        if column.role == "axis" and not column.option:
            known = compute.if_else(refused, None, batch.column(place))
            batch = batch.set_column(place, batch.schema.field(place), known)
    return batch.filter(there)


def _noted(paths: Iterator[str], refused: Counter[str]) -> Iterator[str]:
    for path in paths:
        _count(reasons_of(path, REASON), refused)
        yield path


def _batches(unit: Unit, paths: Iterator[str], refused: Counter[str]) -> Iterator[pa.RecordBatch]:
    for number, path in enumerate(paths):
        with pa.memory_map(path) as file:
            batch = pa.ipc.open_file(file).get_batch(0)
            if REASON in batch.schema.names:
                _count([batch[REASON]], refused)
            yield with_options(unit.sweep, batch, number * unit.rows)


def _count(reasons: Iterable[pa.Array], refused: Counter[str]) -> None:
    for some in reasons:
        for one in compute.value_counts(some.filter(compute.not_equal(some, MISSING))):
            reason = one["values"].as_py()
            known = reason in refused or len(refused) < MOST_REASONS
            refused[reason if known else OTHERS] += one["counts"].as_py()
