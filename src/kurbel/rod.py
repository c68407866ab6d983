"""The connecting rod that a table is about, checked once, and its masses from a CSV file.

    # comment
    from [mm];to [mm];mass [kg]
    -60;70;8,4
    70;520;6,1
    520;600;3,3

Each line is a section over which its mass is spread evenly; where `from` is `to` it is a point. A file with
the heads `position` and `mass` holds points alone. Positions count from the crank pin along the rod, those
beyond it are negative; they are shares of the rod's length, percent (%) or lengths with a unit. Masses have a
unit, or else are shares. A unit stands in the head, as `mass [kg]`, or behind each value, as `8,4 kg`; units
need pint (extra `units`). The extent of the masses across the rod is left out of k: where it
matters, as it does for k from the time of swing, give a and k themselves.

Columns are in any order, more of them are ignored. Semicolons, tabs or commas part them; a decimal comma is
read where commas do not part. Empty lines, comments (#), quotes, BOM and CRLF are allowed.
"""

from __future__ import annotations

import csv
import os
import re
import stat
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple

from kurbel.card_lines import place, shown
from kurbel.errors import NotationError, ProblemError, RodError
from kurbel.kernel.rod import Masses, rod_masses, two_masses
from kurbel.notation import about, number

# Sections end within half a rod's length of its pins.
REACH = Fraction(1, 2)
LARGEST_MASS = 10**9
# The share of the rod that railway engineers count as reciprocating.
RAILWAY_CROSSHEAD = Fraction(4, 10)
LARGEST_FILE = 10**6

_CONTROL = re.compile(r"[\x00-\x08\x0a-\x1f\x7f]")
_BLANKS = ";,\t "
_HEAD = re.compile(
    r"(?P<name>\w+)\s*(?:\[(?P<square>[^\]]*)\]|/?\s*\((?P<round>[^)]*)\)|(?:/|\bin\b)?(?P<bare>.*))"
)
_VALUE = re.compile(r"([+−-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d{1,3})?)\s*([A-Za-zµ%]*)", re.ASCII)
_UNIT = re.compile(r"[A-Za-zµ]{1,20}")
_POINTS, _SECTIONS = ("position", "mass"), ("from", "to", "mass")
_SHARES = {"": Fraction(1), "1": Fraction(1), "-": Fraction(1), "%": Fraction(1, 100)}
_LENGTHS = _SHARES | {"L": Fraction(1)}


@dataclass(frozen=True, slots=True)
class Rod:
    """A rod by its centre of mass, a/L from the crank pin, its k²/L² about it, and its mass in kg if known.

    k² and not k is kept, for of fractions it is a fraction. The centre lies on the line between the pins,
    0 <= a <= L. k² above a (L - a) is for rods that reach beyond their pins or far to the side; valid up to
    that of two masses half a length beyond the pins.
    """

    centre: Fraction
    gyration_square: Fraction
    mass: Fraction | None = None

    def __post_init__(self) -> None:
        if not 0 <= self.centre <= 1:
            raise ProblemError(
                f"the rod's centre of mass is {about(self.centre)} L from the crank pin; it must lie within"
                " 0..1, between the pins, for no rod has most of its mass beyond one"
            )
        if self.gyration_square <= 0:
            raise ProblemError(
                f"the rod's k² is {about(self.gyration_square)} L²; it must be above 0,"
                " for no rod has all its mass in one point"
            )
        if self.gyration_square > self._greatest_square():
            raise ProblemError(
                f"the rod's k² is {about(self.gyration_square)} L²; with the centre of mass"
                f" {about(self.centre)} L from the crank pin it must be at most"
                f" {about(self._greatest_square())} L², for no rod reaches half its length beyond both pins"
            )
        if self.mass is not None and not 0 < self.mass <= LARGEST_MASS:
            raise ProblemError(
                f"the rod's mass is {about(self.mass)} kg; it must be above 0 and at most 10^9 kg"
            )

    @classmethod
    def of_gyration(cls, centre: Fraction, gyration: Fraction, mass: Fraction | None = None) -> Rod:
        """Return the rod with this a/L and k/L."""
        if gyration <= 0:
            raise ProblemError(
                f"the rod's radius of gyration k is {about(gyration)} L; it must be above 0,"
                " for no rod has all its mass in one point"
            )
        return cls(centre, gyration * gyration, mass)

    @classmethod
    def from_crosshead(cls, centre: Fraction, gyration: Fraction, mass: Fraction | None = None) -> Rod:
        """Return the rod with this a/L and k/L, a counted from the crosshead pin as Ensslin does."""
        if not 0 <= centre <= 1:
            raise ProblemError(
                f"the rod's centre of mass is {about(centre)} L from the crosshead pin; it must lie within"
                " 0..1, between the pins, for no rod has most of its mass beyond one"
            )
        return cls.of_gyration(1 - centre, gyration, mass)

    @property
    def couple(self) -> Fraction:
        """(k² - a b)/L²: 0 if two masses replace the rod exactly, below 0 for rods between their pins."""
        return self.gyration_square - self.centre * (1 - self.centre)

    def masses(self, model: str, of: Callable[[Fraction], Any]) -> Masses[Any]:
        """Return the masses that a model puts for a rod of mass 1, on the kind of number that `of` makes."""
        return Masses(*(of(Fraction(part)) for part in MODELS[model](self)))

    def _greatest_square(self) -> Fraction:
        return (self.centre + REACH) * (1 - self.centre + REACH)


# The rod itself, and the two masses that stand in for it.
MODELS: Mapping[str, Callable[[Rod], Masses[Fraction]]] = {
    "exact": lambda rod: rod_masses(rod.centre, rod.gyration_square),
    "two-mass": lambda rod: two_masses(rod.centre),
    "railway": lambda rod: two_masses(RAILWAY_CROSSHEAD),
}


class Section(NamedTuple):
    """A mass spread evenly from `start` to `end`, both in L from the crank pin; a point if they agree."""

    start: Fraction
    end: Fraction
    mass: Fraction


def rod_of_points(points: Iterable[tuple[Fraction, Fraction]], kilograms: bool = False) -> Rod:
    """Return the rod made of masses at positions, (position, mass) each."""
    return rod_of_sections([Section(position, position, mass) for position, mass in points], kilograms)


def rod_of_sections(sections: Sequence[Section], kilograms: bool = False) -> Rod:
    """Return the rod made of sections; the masses are in kg or else shares, of which it has no mass."""
    for section in sections:
        _check_section(section)
    places = len({end for section in sections for end in section[:2]})
    if places < 2:
        raise ProblemError(
            f"masses are given at {places} of the rod's places; at least 2 are needed, from pin to pin"
        )
    mass, first, second = (sum(moments) for moments in zip(*map(_moments, sections), strict=True))
    centre = first / mass
    return Rod(centre, second / mass - centre * centre, mass if kilograms else None)


def _moments(section: Section) -> tuple[Fraction, Fraction, Fraction]:
    """Return the mass, its first and its second moment about the crank pin."""
    middle, span = (section.start + section.end) / 2, section.end - section.start
    return section.mass, section.mass * middle, section.mass * (middle * middle + span * span / 12)


def _check_section(section: Section) -> None:
    for position in section[:2]:
        if not -REACH <= position <= 1 + REACH:
            raise ProblemError(
                f"position {about(position)} L is outside -0.5..1.5; positions count from the crank pin,"
                " and no rod reaches farther than half its length beyond a pin"
            )
    if section.end < section.start:
        raise ProblemError(
            f"the section runs from {about(section.start)} L to {about(section.end)} L;"
            " its end must not lie before its start"
        )
    if section.mass <= 0:
        raise ProblemError(f"mass {about(section.mass)} must be above 0, for no part of a rod weighs nothing")


class _Column(NamedTuple):
    """A column that the rod needs: its place in the row and the unit in its head, "" if there is none."""

    name: str
    place: int
    unit: str


class _Head(NamedTuple):
    columns: tuple[_Column, ...]
    delimiter: str
    width: int


def read_rod(path: str | os.PathLike[str], length: Fraction | None = None) -> Rod:
    """Return the rod in a CSV file; the text above says how it is written.

    length is the rod's in metres, between the pins; positions with units need it. Raises RodError for a file
    that is none, with its name and line, and MissingExtraError without pint.
    """
    name = shown(path)
    sections, measured = [], set()
    for line, section, in_kilograms in _read_sections(path, length):
        measured.add(in_kilograms)
        if len(measured) > 1:
            raise RodError(f"{place(name, line)}: some masses have a unit and some have none; give all one")
        sections.append(section)
    try:
        return rod_of_sections(sections, measured == {True})
    except ProblemError as error:
        raise RodError(f"{name}: {error}") from None


def _read_sections(
    path: str | os.PathLike[str], length: Fraction | None
) -> Iterator[tuple[int, Section, bool]]:
    """Yield the number of each line, its section, and whether its mass is in kg."""
    name, head, marks = shown(path), None, ""
    for line_number, line in _said_lines(path):
        try:
            if head is None:
                head = _head(line)
                continue
            texts = _row(line, head)
            marks = _decimal_marks("".join(texts), marks)
            section, in_kilograms = _section(texts, head, length)
            _check_section(section)
        except (NotationError, ProblemError) as error:
            raise RodError(f"{place(name, line_number)}: {error}") from None
        yield line_number, section, in_kilograms
    if head is None:
        raise RodError(f"{name} is empty; a rod starts with its heads, from, to, mass or position, mass")


def _section(texts: Sequence[str], head: _Head, length: Fraction | None) -> tuple[Section, bool]:
    *places, mass = (
        _value(text, column, head.delimiter) for text, column in zip(texts, head.columns, strict=True)
    )
    ends = [value * _position_unit(unit, length) for value, unit in places]
    return Section(ends[0], ends[-1], mass[0] * _mass_unit(mass[1])), mass[1] not in _SHARES


def _value(text: str, column: _Column, delimiter: str) -> tuple[Fraction, str]:
    """Return the value and its unit, "" if there is none."""
    match = _VALUE.fullmatch(text)
    if match is None or (delimiter == "," and "," in match[1]):
        raise NotationError(f'{column.name} "{_clipped(text)}" is not a number; write it as 8.4')
    if match[2] and column.unit:
        raise NotationError(
            f'{column.name} "{_clipped(text)}" has a unit behind the value and one in the head,'
            f" {_clipped(column.unit)}; write it once"
        )
    return number(match[1], column.name), match[2] or column.unit


def _position_unit(unit: str, length: Fraction | None) -> Fraction:
    """Return the share of the rod's length that the unit is."""
    if unit in _LENGTHS:
        return _LENGTHS[unit]
    metres = _factor(unit, "m", "[length]")
    if metres is None:
        raise NotationError(
            f'the position has the unit "{_clipped(unit)}", which is no length; write mm, cm, m, inch or %'
        )
    if length is None:
        raise NotationError(
            f"the position is in {_clipped(unit)} and the rod's length is not known; give the length,"
            " or positions as shares of it"
        )
    return metres / length


def _mass_unit(unit: str) -> Fraction:
    if unit in _SHARES:
        return _SHARES[unit]
    kilograms = _factor(unit, "kg", "[mass]")
    if kilograms is None:
        raise NotationError(
            f'the mass has the unit "{_clipped(unit)}", which is no mass; write kg, g, t, lb or %'
        )
    return kilograms


def _factor(unit: str, base: str, dimension: str) -> Fraction | None:
    """Return the unit in the base unit, None if pint does not know it or it is of another dimension."""
    if not _UNIT.fullmatch(unit):
        return None
    from kurbel.units import registry

    try:
        quantity = registry().Quantity(Fraction(1), unit)
    except (AttributeError, ValueError, TypeError, AssertionError):
        # pint answers an unknown unit with an AttributeError of its own.
        return None
    return Fraction(quantity.to(base).magnitude) if quantity.check(dimension) else None


def _head(line: str) -> _Head:
    # The delimiter that parts the head into most of the columns sought, or into most columns.
    parted = {delimiter: _fields(line, delimiter, strict=False) for delimiter in ";\t,"}
    delimiter = max(parted, key=lambda one: (len(_columns(parted[one])), len(parted[one])))
    fields = _fields(line, delimiter)
    return _Head(_needed(_columns(fields), fields), delimiter, len(fields))


def _columns(fields: Sequence[str]) -> list[_Column]:
    found = []
    for index, field in enumerate(fields):
        match = _HEAD.fullmatch(field.strip())
        if match is not None and match["name"].casefold() in {*_POINTS, *_SECTIONS}:
            unit = next(unit for unit in match.group("square", "round", "bare") if unit is not None)
            found.append(_Column(match["name"].casefold(), index, unit.strip()))
    return found


def _needed(columns: Sequence[_Column], fields: Sequence[str]) -> tuple[_Column, ...]:
    """Return the columns in the order of _POINTS or _SECTIONS."""
    names = [column.name for column in columns]
    for name in names:
        if names.count(name) > 1:
            raise NotationError(f"{names.count(name)} columns are headed {name}; a rod has one")
    for needed in (_POINTS, _SECTIONS):
        if set(names) == set(needed):
            return tuple(sorted(columns, key=lambda column: needed.index(column.name)))
    heads = _clipped(", ".join(field.strip() for field in fields), 60)
    raise NotationError(f"the heads are {heads}; a rod has either position and mass, or from, to and mass")


def _row(line: str, head: _Head) -> list[str]:
    fields = _fields(line, head.delimiter)
    if len(fields) != head.width:
        advice = "; with decimal commas, part the columns by semicolons" if head.delimiter == "," else ""
        raise NotationError(f"the row has {len(fields)} fields where the head has {head.width}{advice}")
    return [fields[column.place].strip() for column in head.columns]


def _fields(line: str, delimiter: str, strict: bool = True) -> list[str]:
    try:
        return next(csv.reader([line], delimiter=delimiter, skipinitialspace=True, strict=strict))
    except csv.Error as error:
        raise NotationError(f"the quotes do not match ({error})") from None


def _decimal_marks(texts: str, known: str) -> str:
    """Return the decimal mark seen so far; a file has one, for beside commas 1.013 may be a thousand."""
    marks = "".join(mark for mark in ".," if mark in known or mark in texts)
    if len(marks) > 1:
        raise NotationError(
            "decimal points and decimal commas are mixed from here on; write one of them,"
            " and no thousands marks"
        )
    return marks


def _said_lines(path: str | os.PathLike[str]) -> Iterator[tuple[int, str]]:
    """Yield the lines that are neither empty nor comments, each with its number from 1, without its end."""
    name = shown(path)
    for line_number, raw in enumerate(_content(path, name).split(b"\n"), 1):
        try:
            line = raw.rstrip(b"\r").decode()
        except UnicodeDecodeError as error:
            raise RodError(
                f"{place(name, line_number)}: the byte 0x{raw[error.start]:02x} is not UTF-8;"
                " save the rod as CSV in UTF-8"
            ) from None
        if control := _CONTROL.search(line):
            raise RodError(
                f"{place(name, line_number)}: the character U+{ord(control[0]):04X} is in no text file;"
                " a rod is a CSV file, with lines that end in LF or CRLF"
            )
        said = line.strip(_BLANKS)
        if said and not said.startswith("#"):
            yield line_number, line


def _content(path: str | os.PathLike[str], name: str) -> bytes:
    try:
        # A device or a pipe may never end.
        if not stat.S_ISREG(os.stat(path).st_mode):
            raise RodError(f"cannot read the rod {name}: it is a directory or a device; name a CSV file")
        with open(path, "rb") as file:
            content = file.read(LARGEST_FILE + 1)
    except OSError as error:
        raise RodError(f"cannot read the rod {name}: {error.strerror or error}") from error
    except ValueError:
        # Python's answer to a NUL in a path.
        raise RodError(f"cannot read the rod {name}: no file can have that name") from None
    if len(content) > LARGEST_FILE:
        raise RodError(f"cannot read the rod {name}: it has more than {LARGEST_FILE // 10**6} MB")
    return content.removeprefix(b"\xef\xbb\xbf")


def _clipped(text: str, most: int = 40) -> str:
    return text if len(text) <= most else f"{text[: most - 3]}..."
