"""Long tables as text, column by column: rounding floats to scaled integers, and their digits.

A cell costs no Python object. All rows of a chunk share one layout, as wide as their longest number; each
column is looked up four digits at a time and stored at its place in every row, and the bytes that shorter
numbers leave over are deleted in one pass.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

Integers: TypeAlias = NDArray[np.int64]

# Rows that share a layout: large enough to hide the calls, small enough for the second-level cache.
CHUNK = 32768

# Left over in front of a short number, and deleted at the end; it occurs in no text.
FILLER = b"\0"
GROUP = 10_000


class Scaled(NamedTuple):
    """A column of numbers scaled / 10**decimals, with the byte that marks the decimals."""

    scaled: Integers
    decimals: int
    mark: bytes = b"."


Field: TypeAlias = Scaled | bytes


def csv_lines(columns: Sequence[Field], separator: bytes) -> bytes:
    """Return the lines of a chunk, each ended by a newline; constant fields are repeated in every line.

    At least one column must be `Scaled`; all of them have the same length, best at most CHUNK. Numbers
    look like -0.123, 12.500 and 7: ASCII minus, no padding, no sign for zero.
    """
    row, rows = _layout(columns, separator)
    page = np.empty((rows, sum(part.width for part in row)), np.uint8)
    end = page.shape[1]
    # From right to left: a group of four digits may reach beyond its number on the left, where the
    # neighbour then overwrites it.
    for part in reversed(row):
        part.write(page, end)
        end -= part.width
    text = page.tobytes()
    return text.translate(None, FILLER) if any(part.ragged for part in row) else text


class _Constant:
    ragged = False

    def __init__(self, text: bytes) -> None:
        self.text = text
        self.width = len(text)

    def write(self, page: NDArray[np.uint8], end: int) -> None:
        for place, byte in enumerate(self.text, end - self.width):
            page[:, place] = byte


class _Digits:
    """The digits of non-negative integers: all of `width` places, or without leading zeros."""

    def __init__(self, numbers: Integers, width: int, leading_zeros: bool) -> None:
        self.numbers = numbers
        self.width = width
        self.leading_zeros = leading_zeros
        self.ragged = not leading_zeros and width > 1 and bool(numbers.min() < 10 ** (width - 1))

    def write(self, page: NDArray[np.uint8], end: int) -> None:
        rest = self.numbers
        for place in range(end, end - self.width, -4):
            last = place - 4 <= end - self.width
            above, group = (None, rest) if last else _split(rest, GROUP)
            _store(page, place - 4, end - self.width, self._text(group, above, place == end))
            if above is not None:
                rest = above

    def _text(self, group: Integers, above: Integers | None, units: bool) -> NDArray[np.uint32]:
        full = ZEROS_SHOWN.take(group, mode="clip")
        if self.leading_zeros:
            return full
        hidden = (ZERO_SHOWN if units else ZERO_HIDDEN).take(group, mode="clip")
        return hidden if above is None else np.where(above > 0, full, hidden)


class _Sign:
    ragged = True
    width = 1

    def __init__(self, scaled: Integers) -> None:
        self.scaled = scaled

    def write(self, page: NDArray[np.uint8], end: int) -> None:
        np.multiply(self.scaled < 0, np.uint8(ord("-")), out=page[:, end - 1])


Part: TypeAlias = _Constant | _Digits | _Sign


def _layout(columns: Sequence[Field], separator: bytes) -> tuple[list[Part], int]:
    row: list[Part] = []
    rows = 0
    for column in columns:
        if row:
            row.append(_Constant(separator))
        if isinstance(column, bytes):
            row.append(_Constant(column))
        else:
            rows = len(column.scaled)
            row.extend(_number(column))
    row.append(_Constant(b"\n"))
    return row, rows


def _number(column: Scaled) -> Iterator[Part]:
    scaled, decimals, mark = column
    if not len(scaled):
        return
    if scaled.min() < 0:
        yield _Sign(scaled)
    whole = np.abs(scaled)
    if not decimals:
        yield _Digits(whole, len(str(whole.max())), leading_zeros=False)
        return
    whole, fraction = _split(whole, 10**decimals)
    yield _Digits(whole, len(str(whole.max())), leading_zeros=False)
    yield _Constant(mark)
    yield _Digits(fraction, decimals, leading_zeros=True)


def _split(numbers: Integers, divisor: int) -> tuple[Integers, Integers]:
    """Return quotients and remainders; np.divmod takes four times as long."""
    quotient = numbers // np.int64(divisor)
    remainder = quotient * np.int64(-divisor)
    remainder += numbers
    return quotient, remainder


def _store(page: NDArray[np.uint8], start: int, first: int, groups: NDArray[np.uint32]) -> None:
    """Put the four digits of every group into its row from `start`; only those from `first` on matter."""
    if start >= 0:
        np.ndarray(len(page), np.uint32, page, start, page.strides[:1])[:] = groups
        return
    digits = groups.view(np.uint8).reshape(-1, 4)
    for place in range(first, start + 4):
        page[:, place] = digits[:, place - start]


def _groups(texts: Iterator[str]) -> NDArray[np.uint32]:
    return np.frombuffer("".join(texts).encode(), np.uint32)


ZEROS_SHOWN = _groups(f"{group:04}" for group in range(GROUP))
ZERO_SHOWN = _groups(str(group).rjust(4, "\0") for group in range(GROUP))
ZERO_HIDDEN = _groups(str(group or "").rjust(4, "\0") for group in range(GROUP))
