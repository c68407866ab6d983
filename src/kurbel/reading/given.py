"""Values that were typed, or given in Python, to exact numbers: text, integers, fractions, floats.

A parameter of either kind goes through one of these functions. Bare numbers are in units of the SI, in
degrees, or in turns a second.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import TypeAlias

from kurbel.errors import NotationError
from kurbel.reading import notation, units
from kurbel.reading.speed import Speed

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


def as_ratios(given: Exact | Iterable[Exact]) -> tuple[Fraction, ...]:
    return tuple(read_values(given, notation.ratios, as_ratio))


def as_angles(given: Exact | Iterable[Exact]) -> Sequence[Fraction]:
    return read_values(given, notation.angles, as_angle)


def as_numbers(given: Exact | Iterable[Exact], what: str) -> tuple[Fraction, ...]:
    return tuple(read_values(given, lambda texts: notation.numbers(texts, what), as_fraction))


def as_crank_angles(given: Exact | Iterable[Exact]) -> Sequence[Fraction]:
    """Read the angles of cranks, several of which may be equal."""
    return notation.crank_angles(given) if isinstance(given, str) else _each(given, as_angle)


def as_places(given: Exact | Iterable[Exact], what: str) -> Sequence[Fraction]:
    """Read numbers, several of which may be equal."""
    return notation.each_number([given], what) if isinstance(given, str) else _each(given, as_fraction)


def _each(given: Exact | Iterable[Exact], one: Callable[[Exact], Fraction]) -> tuple[Fraction, ...]:
    return tuple(map(one, given if isinstance(given, Iterable) else [given]))


def as_names(given: str | Iterable[str] | None, example: str = "phi,x,c,p") -> tuple[str, ...]:
    """Read the names of columns."""
    if given is None:
        return ()
    if not isinstance(given, Iterable):
        raise NotationError(f"columns is {given!r}; write names as {example} or in a list")
    names = [given] if isinstance(given, str) else list(given)
    # What is no text is answered where the columns are chosen.
    return (
        notation.names(names, "columns", example) if all(isinstance(one, str) for one in names) else (*names,)
    )


def as_ratio(value: Exact) -> Fraction:
    return notation.ratio(value) if isinstance(value, str) else as_fraction(value)


def as_angle(value: Exact, what: str = "angle") -> Fraction:
    return notation.angle(value, what) if isinstance(value, str) else as_fraction(value)


def as_fraction(value: Exact) -> Fraction:
    return Fraction(value) if isinstance(value, (int, Fraction)) else notation.number(str(value))


def as_number(value: Exact, what: str) -> Fraction:
    return notation.number(value, what) if isinstance(value, str) else as_fraction(value)


def as_share(value: Exact, what: str = "share") -> Fraction:
    return notation.share(value, what) if isinstance(value, str) else as_fraction(value)


def as_length(value: Exact, what: str) -> Fraction:
    """Return metres."""
    return units.length(value, what) if isinstance(value, str) else as_fraction(value)


def as_mass(value: Exact, what: str) -> Fraction:
    """Return kilograms; those with a unit must be above 0."""
    return units.mass(value, what) if isinstance(value, str) else as_fraction(value)


def as_signed_mass(value: Exact, what: str) -> Fraction:
    """Return kilograms, which may be below 0."""
    return units.signed_mass(value, what) if isinstance(value, str) else as_fraction(value)


def as_pressure(value: Exact, what: str) -> Fraction:
    """Return pascals."""
    return units.pressure(value, what) if isinstance(value, str) else as_fraction(value)


def as_force(value: Exact) -> Fraction:
    """Return newtons."""
    return units.force(value) if isinstance(value, str) else as_fraction(value)


def as_power(value: Exact) -> Fraction:
    """Return watts."""
    return units.power(value) if isinstance(value, str) else as_fraction(value)


def as_speed(value: Exact) -> Speed:
    """Return a speed of rotation; a bare number counts turns a second."""
    return units.speed(value) if isinstance(value, str) else Speed(as_fraction(value))


def as_share_or_length(value: Exact, what: str, whole: Fraction | None, unknown: str) -> Fraction:
    """Return a share, or what a length is of the whole in metres; `unknown` says how to make that known."""
    if not isinstance(value, str) or not units.is_measure(value):
        return as_share(value, what)
    measured = units.length(value, what)
    if whole is None:
        raise NotationError(f'{what} "{value[:40]}" is a length, but {unknown}')
    return measured / whole
