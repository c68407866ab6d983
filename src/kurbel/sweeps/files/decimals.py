"""Certified decimals as Arrow has them: whole numbers of the last place, 16 or 32 bytes each."""

from __future__ import annotations

from collections.abc import Sequence

import pyarrow as pa
import pyarrow.compute as compute

from kurbel.errors import OutputError
from kurbel.sweeps.rows import Column

# The digits of the two kinds, and how many of them are to be left before the point.
SHORT, LONG, BEFORE = 38, 76, 10


def decimal_type(column: Column) -> pa.DataType:
    """Return the type of a column: 38 digits, or 76 where fewer than ten would stand before the point."""
    assert column.decimals is not None
    is_short = column.decimals + BEFORE <= SHORT
    return pa.decimal128(SHORT, column.decimals) if is_short else pa.decimal256(LONG, column.decimals)


def decimals_of(column: Column, scaled: Sequence[int | None]) -> pa.Array:
    """Return whole numbers of the last place, None where there is nothing, as decimals."""
    kind = decimal_type(column)
    width = kind.bit_width // 8
    limit = 10**kind.precision
    if any(one is not None and abs(one) >= limit for one in scaled):
        raise OutputError(
            f"{column.key} has numbers of more than {kind.precision} digits, which no file of decimals holds;"
            " ask for fewer --digits"
        )
    packed = b"".join(int(one or 0).to_bytes(width, "little", signed=True) for one in scaled)
    known = pa.array([one is not None for one in scaled], pa.bool_()).buffers()[1] if None in scaled else None
    return pa.Array.from_buffers(kind, len(scaled), [known, pa.py_buffer(packed)])


def texts_of(decimals: pa.Array) -> pa.Array:
    """Return all digits as text, also those of 0.0000001, which Arrow would write as 1E-7."""
    places = decimals.type.scale
    whole = type(decimals.type)
    kind = pa.decimal128(SHORT, 0) if whole is pa.Decimal128Type else pa.decimal256(LONG, 0)
    units = pa.Array.from_buffers(kind, len(decimals), decimals.buffers(), offset=decimals.offset)
    text = compute.cast(units, pa.string())
    if not places:
        return text
    sign = compute.if_else(compute.starts_with(text, "-"), "-", "")
    digits = compute.utf8_lpad(compute.utf8_ltrim(text, "-"), places + 1, "0")
    before = compute.utf8_slice_codeunits(digits, 0, -places)
    behind = compute.utf8_slice_codeunits(digits, -places)
    return compute.binary_join_element_wise(compute.binary_join_element_wise(sign, before, ""), behind, ".")
