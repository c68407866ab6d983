"""Values given in Python, to exact numbers: text as on the command line, integers, fractions, floats."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import TypeAlias

from kurbel.errors import NotationError
from kurbel.reading import notation

# A float is read by its shortest decimal, so that 0.2 is 1/5; text as on the command line.
Exact: TypeAlias = str | int | float | Fraction | Decimal


def read_values(
    given: Exact | Iterable[Exact],
    texts: Callable[[Iterable[str]], Sequence[Fraction]],
    one: Callable[[Exact], Fraction],
) -> Sequence[Fraction]:
    """Read one value or many; text may hold lists and ranges, as on the command line."""
    values = [given] if isinstance(given, str) or not isinstance(given, Iterable) else list(given)
    as_text = [value for value in values if isinstance(value, str)]
    return texts(as_text) if len(as_text) == len(values) else tuple(dict.fromkeys(map(one, values)))


def read_each(given: Exact | Iterable[Exact], one: Callable[[Exact], Fraction]) -> tuple[Fraction, ...]:
    """Read one value or many, equal ones too."""
    values = [given] if isinstance(given, str) or not isinstance(given, Iterable) else given
    return tuple(map(one, values))


def as_names(given: str | Iterable[str]) -> tuple[str, ...]:
    if isinstance(given, str):
        return notation.names([given], "columns", "phi,x,c,p")
    if not isinstance(given, Iterable):
        raise NotationError(f"columns is {given!r}; write names as phi,x,c,p or in a list")
    return tuple(given)


def as_ratio(value: Exact) -> Fraction:
    return notation.ratio(value) if isinstance(value, str) else as_fraction(value)


def as_angle(value: Exact) -> Fraction:
    return notation.angle(value) if isinstance(value, str) else as_fraction(value)


def as_fraction(value: Exact) -> Fraction:
    return Fraction(value) if isinstance(value, (int, Fraction)) else notation.number(str(value))


def as_share(value: Exact) -> Fraction:
    return notation.share(value, "share") if isinstance(value, str) else as_fraction(value)
