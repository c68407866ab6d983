"""Records in chunks of bytes: column-wise text for long tables, row by row for the rest."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import partial
from itertools import chain, islice
from typing import TYPE_CHECKING

from kurbel.drive.crank import largest
from kurbel.motion.evaluation import MOST_DECIMALS
from kurbel.motion.page import CHUNK, RecordRows
from kurbel.page.axes import angle_decimals, angle_number, shifted
from kurbel.page.build import build
from kurbel.page.subject import Question
from kurbel.reading.notation import Progression, ratio_text

if TYPE_CHECKING:
    from kurbel.formats.columns import Scaled
    from kurbel.formats.registry import RecordsFormat


def record_chunks(request: Question, form: RecordsFormat, decimal: str) -> Iterator[bytes]:
    """Yield the table's records in a format, a chunk of rows at a time."""
    table = build(request, pages=False)
    rows = table.records.rows
    if isinstance(rows, RecordRows) and rows.question.bulk and _fits(_counted(rows)):
        yield from form.writer.bulk(table, rows.keys, partial(_fields, rows), decimal)
        return
    lines = form.writer.rows(table, decimal)
    for line in lines:
        yield "".join(chain([line], islice(lines, CHUNK - 1))).encode()


def _fields(rows: RecordRows, mark: str) -> Iterator[dict[str, Scaled | bytes]]:
    """Yield the columns of each chunk by their keys."""
    from kurbel.formats.columns import Scaled

    decimals = {key: column.places for key, column in rows.columns.items()}
    of_angles, zero = angle_decimals(_counted(rows)) or 0, rows.question.zero
    for crank, angles, values in rows.chunks():
        fields: dict[str, Scaled | bytes] = {
            key: Scaled(values[key], decimals[key], mark.encode()) for key in values
        }
        fields["ratio"] = ratio_text(crank.ratio, mark).encode()
        fields["phi"] = _scaled_angles(shifted(angles, -zero), of_angles, mark.encode())
        yield fields


def _counted(rows: RecordRows) -> Sequence[Fraction]:
    """Return the angles as the page counts them."""
    return shifted(rows.question.angles, -rows.question.zero)


def _fits(angles: Sequence[Fraction]) -> bool:
    """Whether every angle is a finite decimal that fits an int64."""
    decimals = angle_decimals(angles)
    return decimals is not None and decimals <= MOST_DECIMALS and largest(angles) * 10**decimals < 2**62


def _scaled_angles(angles: Sequence[Fraction], decimals: int, mark: bytes) -> Scaled:
    import numpy as np

    from kurbel.formats.columns import Scaled
    from kurbel.motion.bulk import integer_angles

    if isinstance(angles, Progression):
        numerators, denominator = integer_angles(angles)
        # A denominator of tens only divides the power of ten.
        scaled = numerators * (10**decimals // denominator)
    else:
        scaled = np.array([angle_number(angle, decimals).scaled for angle in angles], dtype=np.int64)
    return Scaled(scaled.astype(np.int64), decimals, mark)
