"""Records in chunks of bytes: column-wise text for long tables, row by row for the rest."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import chain, islice
from typing import TYPE_CHECKING

from kurbel.drive.crank import largest
from kurbel.exact.numerals import Number
from kurbel.formats.render import folders_of, has_template, template_of
from kurbel.motion.bulk import CHUNK, RecordRows, integer_angles
from kurbel.motion.evaluation import MOST_DECIMALS
from kurbel.page.axes import angle_decimals, angle_number, shifted
from kurbel.page.build import build
from kurbel.page.labels import plain
from kurbel.page.subject import Question
from kurbel.page.table import Request, Value
from kurbel.reading.notation import Progression

if TYPE_CHECKING:
    from kurbel.formats.columns import Scaled
    from kurbel.formats.registry import RecordsFormat


# Text of another axis that is one word in every format.
_WORD = re.compile(r"[\w:.,/∞-]*")


def record_chunks(question: Question, request: Request, form: RecordsFormat, decimal: str) -> Iterator[bytes]:
    """Yield the table's records in a format, a chunk of rows at a time."""
    table = replace(build(question, pages=False), request=request)
    rows = table.records.rows
    folders = folders_of(*table.templates)
    own = has_template(folders, template_of(table, form.name, folders))
    if isinstance(rows, RecordRows) and rows.bulk and _fits(rows) and not own:
        yield from form.writer.bulk(table, rows.keys, partial(_fields, rows), decimal)
        return
    lines = form.writer.rows(table, decimal, folders)
    for line in lines:
        yield "".join(chain([line], islice(lines, CHUNK - 1))).encode()


def _fields(rows: RecordRows, mark: str) -> Iterator[dict[str, Scaled | bytes]]:
    """Yield the columns of each chunk by their keys."""
    from kurbel.formats.columns import Scaled

    of_angles, zero = angle_decimals(rows.counted) or 0, rows.question.zero
    for others, angles, scaled, decimals in rows.chunks():
        fields: dict[str, Scaled | bytes] = {
            key: Scaled(scaled[key], decimals[key], mark.encode()) for key in scaled
        }
        for key, value in others.items():
            fields[key] = _same(value, len(angles), mark)
        fields["phi"] = _scaled_angles(shifted(angles, -zero), of_angles, mark.encode())
        yield fields


def _same(value: Value, size: int, mark: str) -> Scaled | bytes:
    """Return what stands alike in so many rows."""
    if not isinstance(value, Number):
        return plain(value or "", mark).encode()
    import numpy as np

    from kurbel.formats.columns import Scaled

    return Scaled(np.full(size, value.scaled, dtype=np.int64), value.decimals, mark.encode())


def _fits(rows: RecordRows) -> bool:
    """Whether every angle is a finite decimal that fits an int64, and what other axes say a word or such a
    number."""
    angles, decimals = rows.counted, angle_decimals(rows.counted)
    fits = decimals is not None and decimals <= MOST_DECIMALS and largest(angles) * 10**decimals < 2**62
    return fits and all(
        abs(one.scaled) < 2**62 if isinstance(one, Number) else _WORD.fullmatch(plain(str(one)))
        for one in rows.stub_values
    )


def _scaled_angles(angles: Sequence[Fraction], decimals: int, mark: bytes) -> Scaled:
    import numpy as np

    from kurbel.formats.columns import Scaled

    if isinstance(angles, Progression):
        numerators, denominator = integer_angles(angles)
        # A denominator of tens only divides the power of ten.
        scaled = numerators * (10**decimals // denominator)
    else:
        scaled = np.array([angle_number(angle, decimals).scaled for angle in angles], dtype=np.int64)
    return Scaled(scaled.astype(np.int64), decimals, mark)
