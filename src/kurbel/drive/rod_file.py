"""The connecting rod as it is given: by its centre of mass and gyration, by the time in which it swings about
a pin, or by a CSV file of its masses.

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

import os
import re
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from kurbel.drive.rod import Rod, Section, Swing, check_centre, check_section, rod_of_sections
from kurbel.errors import NotationError, ProblemError, RodError
from kurbel.reading.csv_file import (
    Column,
    Head,
    Kind,
    check_once,
    clipped,
    digits_and_unit,
    place,
    read_head,
    read_rows,
    shown,
)
from kurbel.reading.notation import about, number
from kurbel.reading.units import unit_in

KIND = Kind("rod", "section", RodError)

_POINTS, _SECTIONS = ("position", "mass"), ("from", "to", "mass")
_NAMES = ("position", "from", "to", "mass")
_UNIT = re.compile(r"[A-Za-zµ]{1,20}")
_SHARES = {"": Fraction(1), "1": Fraction(1), "-": Fraction(1), "%": Fraction(1, 100)}
_LENGTHS = _SHARES | {"L": Fraction(1)}
# Of π², far beyond the 50 decimals that are printed at most.
BITS = 600
# A position beyond so many rods is more likely in millimetres.
_LONGEST = 5


def rod_sections(
    path: str | os.PathLike[str], length: Fraction | None = None
) -> tuple[Sequence[Section], bool]:
    """Return the sections of the rod in a CSV file, and whether their masses are in kg; the text above says
    how it is written.

    length is the rod's in metres, between the pins; positions with units need it. Raises RodError for a file
    that is none, with its name and line, and MissingExtraError without pint.
    """
    name = shown(path)

    def row_of(texts: list[str], head: Head, line: int) -> tuple[int, Section, bool]:
        return line, *_section(texts, head, length)

    starts = "a rod starts with its heads, from, to, mass or position, mass"
    sections, measured = [], set()
    for line, section, in_kilograms in read_rows(path, KIND, _head, row_of, starts, refused=ProblemError):
        measured.add(in_kilograms)
        if len(measured) > 1:
            raise RodError(f"{place(name, line)}: some masses have a unit and some have none; give all one")
        sections.append(section)
    return sections, measured == {True}


def read_rod(path: str | os.PathLike[str], length: Fraction | None = None) -> Rod:
    """Return the rod of a file. Raises what `rod_sections` does."""
    sections, in_kilograms = rod_sections(path, length)
    try:
        return rod_of_sections(sections, in_kilograms)
    except ProblemError as error:
        raise RodError(f"{shown(path)}: {error}") from None


def _section(texts: Sequence[str], head: Head, length: Fraction | None) -> tuple[Section, bool]:
    *places, mass = (
        _value(text, column, head.delimiter) for text, column in zip(texts, head.columns, strict=True)
    )
    ends = [value * _position_unit(unit, length) for value, unit in places]
    section = Section(ends[0], ends[-1], mass[0] * _mass_unit(mass[1]))
    try:
        check_section(section)
    except ProblemError as error:
        far = any(not unit and abs(value) > _LONGEST for value, unit in places)
        bare = [f"{one.name} [mm]" for one, (_, unit) in zip(head.columns, places, strict=False) if not unit]
        hint = f"; in millimetres its head is {', '.join(bare)}" if far else ""
        raise ProblemError(f"{error}{hint}") from None
    return section, mass[1] not in _SHARES


def _value(text: str, column: Column, delimiter: str) -> tuple[Fraction, str]:
    """Return the value and its unit, "" if there is none."""
    digits, unit = digits_and_unit(text, column, delimiter, "8.4")
    return number(digits, column.name), unit


def _position_unit(unit: str, length: Fraction | None) -> Fraction:
    """Return the share of the rod's length that the unit is."""
    if unit in _LENGTHS:
        return _LENGTHS[unit]
    metres = _factor(unit, "position", "m", "length", "mm, cm, m, inch")
    if length is None:
        raise NotationError(
            f"the position is in {clipped(unit)} and the rod's length is not known; add --rod 600mm, or"
            " --stroke and one --ratio, or write positions as shares of the length"
        )
    return metres / length


def _mass_unit(unit: str) -> Fraction:
    return _SHARES[unit] if unit in _SHARES else _factor(unit, "mass", "kg", "mass", "kg, g, t, lb")


def _factor(unit: str, what: str, base: str, dimension: str, examples: str) -> Fraction:
    factor = unit_in(unit, base) if _UNIT.fullmatch(unit) else None
    if factor is None:
        raise NotationError(
            f'the {what} has the unit "{clipped(unit)}", which is no {dimension}; write {examples} or %'
        )
    return factor


def _head(line: str) -> Head:
    head, fields = read_head(line, _NAMES)
    check_once(head, KIND.noun)
    if {column.name for column in head.columns} not in (set(_POINTS), set(_SECTIONS)):
        heads = clipped(", ".join(fields), 60)
        raise NotationError(
            f"the heads are {heads}; a rod has either position and mass, or from, to and mass, with units in"
            " brackets: position [mm], mass [kg]"
        )
    return head


def given_rod(
    centre: Fraction | None,
    gyration: Fraction | None,
    file: str | os.PathLike[str] | None,
    mass: Fraction | None,
    length: Fraction | None,
) -> Rod:
    """Return the rod: a/L from the crosshead pin and k/L, or a file; its mass in kg and length in metres."""
    if file is None:
        if centre is None or gyration is None:
            raise ProblemError(
                "the rod's masses are not known; give its centre and its gyration, such as"
                " --centre 0.6 --gyration 0.4, or --rod-file"
            )
        return Rod.from_crosshead(centre, gyration, mass)
    if centre is not None or gyration is not None:
        raise ProblemError("the rod's file has its masses; leave centre and gyration out")
    rod = read_rod(file, length)
    if mass is None:
        return rod
    if rod.mass is not None:
        raise ProblemError("the rod's file has its mass in kg; leave the mass out")
    return replace(rod, mass=mass)


def weighed_rod(
    inertia: Fraction, about_place: Fraction | None, centre: Fraction | None, length: Fraction | None,
    mass: Fraction | None,
) -> Rod:  # fmt: skip
    """Return the rod with a moment of inertia in kg m² about a point, in L from the crosshead pin, or about
    its centre of mass. k² = J/M - d², d the distance of the point from the centre of mass."""
    if centre is None or length is None or mass is None:
        raise ProblemError(
            "--rod-inertia needs the rod's mass, its length and its centre of mass; add --rod-mass, --rod and"
            " --centre"
        )
    check_centre(centre)
    distance = Fraction(0) if about_place is None else centre - about_place
    square = inertia / mass / length**2 - distance**2
    if square <= 0:
        least = about(mass * (distance * length) ** 2)
        raise ProblemError(
            f"a moment of inertia of {about(inertia)} kg m² is too small: with all its mass in its centre the"
            f" rod would have {least} kg m² about that point"
        )
    return Rod(1 - centre, square, mass)


def swung_rod(
    swings: Sequence[Swing], centre: Fraction | None, length: Fraction | None, mass: Fraction | None = None
) -> Rod:
    """Return the rod with its centre of mass a/L from the crosshead pin, of so many metres between its pins;
    of two swings, about points on both sides of it, the centre of mass follows.

    k² = g d T²/(4 π²) - d², d the distance of the centre of mass from the point about which it swings, T the
    time of a small swing to and fro. Valid for d > 0 and where k² is above 0. Of two, l = g T²/(4 π²) and D
    apart, d₁ (l₁ - d₁) = d₂ (l₂ - d₂) gives d₁ = D (l₂ - D)/(l₁ + l₂ - 2 D). Re-derived.
    """
    if length is None:
        raise ProblemError("--pendulum needs the length of the rod; add --stroke and one --ratio, or --rod")
    first, *others = sorted(swings, key=lambda one: one.place)
    if others:
        if centre is not None:
            raise ProblemError("the times of two swings give the centre of mass; leave --centre out")
        centre = _between(first, others[0], length)
    elif centre is None:
        raise ProblemError("--pendulum needs the centre of mass, about which k is taken; add --centre")
    check_centre(centre)
    distance = abs(centre - first.place) * length
    if distance <= 0:
        raise ProblemError("the rod does not swing about the point where its centre of mass is")
    square = distance * _pendulum(first) - distance**2
    if square <= 0:
        shortest = 2 * (float(distance / first.gravity) * float(1 / _per_pi_square())) ** 0.5
        raise ProblemError(
            f"a swing of {about(first.time)} s is too short: with all its mass {about(distance)} m from the"
            f" point the rod would take {shortest:.4g} s; the time is that of a full swing, to and fro"
        )
    return Rod(1 - centre, square / length**2, mass, tuple(swings))


def _pendulum(swing: Swing) -> Fraction:
    """Return the length in metres of a mass on a thread that swings as fast."""
    return swing.gravity * swing.time**2 / 4 * _per_pi_square()


def _between(first: Swing, second: Swing, length: Fraction) -> Fraction:
    """Return the centre of mass, in L from the crosshead pin, between the points of two swings."""
    apart = (second.place - first.place) * length
    one, other = _pendulum(first) - apart, _pendulum(second) - apart
    distance = apart * other / (one + other) if one + other else Fraction(0)
    if not 0 < distance < apart:
        raise ProblemError(
            "no centre of mass between the two points has these times of its swings; the points lie on both"
            " sides of it, and the times are those of full swings, to and fro"
        )
    return first.place + distance / length


def _per_pi_square() -> Fraction:
    """Return 1/π² to so many bits."""
    import flint

    from kurbel.exact.certify import at_bits

    with at_bits(BITS):
        mantissa, exponent = (1 / flint.arb.pi() ** 2).mid().man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
