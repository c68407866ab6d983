"""Lists of measures, as a book has them: 200kg;300kg, or 0;400;800mm, with a ? for what is asked."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from fractions import Fraction
from typing import Any

from kurbel.errors import NotationError
from kurbel.reading.given import Exact, as_angle, as_crank_angles, as_fraction
from kurbel.reading.notation import quoted

UNKNOWN = "?"
# More are not written by hand.
LONGEST = 10_000


def as_measures(given: Exact | Iterable[Exact], measure: str, what: str) -> tuple[Fraction, ...]:
    """Return the values of a list in the unit of the SI; `measure` is a name of `reading.units`.

    Where the last value that is given is the only one with a unit, it is that of all. Raises NotationError
    for a value that is asked for with a ?.
    """
    found = as_measures_or_unknown(given, measure, what)
    return tuple(_known(value, what) for value in found)


def as_masses(given: Exact | Iterable[Exact], what: str) -> tuple[Fraction, ...]:
    """Return masses in kg. Raises NotationError."""
    return as_measures(given, "mass", what)


def _known(value: Fraction | None, what: str) -> Fraction:
    if value is None:
        raise NotationError(f"{what} has a ?, but it is not found from the others; give it")
    return value


def as_measures_or_unknown(
    given: Exact | Iterable[Exact], measure: str, what: str
) -> tuple[Fraction | None, ...]:
    """Return the same, None where a ? stands."""
    from kurbel.reading import units

    read = getattr(units, measure)
    parts = _parts(given, what)
    if isinstance(given, str):
        parts = _with_unit(parts, units.is_measure, read.unit)
    return tuple(_one(part, lambda text: read(text, what)) for part in parts)


def as_angles_or_unknown(given: Exact | Iterable[Exact]) -> tuple[Fraction | None, ...]:
    """Return angles in degrees, several of which may be equal, None where a ? stands."""
    if isinstance(given, str) and UNKNOWN not in given:
        return tuple(as_crank_angles(given))
    return tuple(_one(part, as_angle) for part in _parts(given, "angle"))


def _parts(given: Exact | Iterable[Exact], what: str) -> list[Any]:
    if not isinstance(given, str):
        return [*given] if isinstance(given, Iterable) else [given]
    if len(given) > LONGEST:
        raise NotationError(f"{what} {quoted(given)} has {len(given)} characters; at most {LONGEST} are read")
    parts = [part.strip() for part in given.split(";")]
    if not all(parts):
        raise NotationError(f"{what} {quoted(given)} has an empty place; write a list as '2;3;4'")
    return parts


def _with_unit(parts: list[str], has_unit: Callable[[str], bool], zero: str) -> list[str]:
    """Return the parts with the unit of the last, 4kg or ?kg, where it is the only one; 0 needs none."""
    asked = parts[-1].removeprefix(UNKNOWN).strip() if parts[-1].startswith(UNKNOWN) else ""
    if asked:
        parts = [*parts[:-1], UNKNOWN]
    known = [part for part in parts if part != UNKNOWN]
    unit = asked
    if measured := [part for part in known if has_unit(part)]:
        last = known[-1].lstrip("+-−0123456789., ")
        unit = last if measured == known[-1:] and asked in ("", last) else ""
    named = [part + unit if part != UNKNOWN and not has_unit(part) else part for part in parts]
    return [f"0{zero}" if part == "0" else part for part in named]


def _one(part: Any, read: Callable[[str], Fraction]) -> Fraction | None:
    if not isinstance(part, str):
        return as_fraction(part)
    return None if part.strip() == UNKNOWN else read(part)
