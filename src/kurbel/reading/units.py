"""Lengths, speeds and powers with their units, exact: 600mm, 3/8 in, 120/min, 12.5 rad/s; lists of them.

The units of everyday are known; all others need the extra `units`, whose registry takes a second to load.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from typing import Any, NamedTuple

from kurbel.errors import NotationError, ProblemError
from kurbel.exact.numerals import exact_text
from kurbel.kernel.circle import Numeric
from kurbel.reading.amounts import FACTORS, known_unit, plain_unit
from kurbel.reading.given import as_angle, as_crank_angles, as_fraction
from kurbel.reading.names import did_you_mean
from kurbel.reading.notation import BEFORE_UNIT, about, in_shell, number, quoted, share

# The number is read by kurbel, for pint would evaluate 9**9**9; the unit may not compute either.
_MEASURE = rf"\s*({BEFORE_UNIT})\s*((?:(?:1\s*)?/\s*)?[A-Za-zµμ].*?)?\s*"
# 2' 6", 24", 2ft 6in
_FEET = r"""(?:(\d+)\s*(?:'|′|’|ft|feet)\s*)?(?:([\d./ ]*\d)\s*(?:"|″|”|''|in|inch|inches))?"""
_LONGEST = 80
# Lists of more characters are not written by hand; what is asked for in one.
LONGEST_LIST = 10_000
UNKNOWN = "?"
# With which pint answers what is no unit; an unknown one with an AttributeError of its own.
PINT_ERRORS = (AttributeError, ValueError, TypeError, AssertionError)
_LARGEST = 10**9

# Turns a second, of which radians are none.
TURNS = {"/s": Fraction(1), "Hz": Fraction(1), "/min": Fraction(1, 60), "rpm": Fraction(1, 60)}
RADIANS = "rad/s"


# Units of mass, or unknown ones, that are taken for others, and how many of these they are, of two tons.
_FORCES: Mapping[str, tuple[str, Mapping[str, int]]] = {
    **dict.fromkeys(("lb", "lbs", "pound", "pounds"), ("lbf", {})),
    **dict.fromkeys(("kg", "kp"), ("kgf", {})),
    **dict.fromkeys(("kgm", "mkg", "kpm", "mkp"), ("kgf m", {})),
    "ata": ("at", {}),
    **dict.fromkeys(("ton", "tons", "tonf", "tonsf"), ("lbf", {"short": 2000, "long": 2240})),
}


@dataclass(frozen=True, slots=True)
class Speed:
    """Angular velocity ω = value (2π)^turns in 1/s: turns per second are exact, and so are radians."""

    value: Fraction
    turns: bool = True

    def __post_init__(self) -> None:
        if self.value <= 0:
            raise ProblemError(f"the speed is {about(self.value)}/s; it must be above 0")

    def omega(self, numbers: Any) -> Numeric:
        """Return ω in 1/s, on a kind of number."""
        found: Numeric = numbers.of(2 * self.value) * numbers.pi if self.turns else numbers.of(self.value)
        return found


@dataclass(frozen=True, slots=True)
class Measure:
    """A kind of quantity, which reads texts of its own: an example, and the unit it is read in.

    What has a `most` must be above 0 and not above that; else it may be 0 or negative. `name` is what errors
    call it unless they are told.
    """

    example: str
    unit: str
    most: int = 0
    name: str = ""

    def __call__(self, text: str, what: str = "") -> Fraction:
        """Return the exact value in the unit."""
        what = what or self.name
        digits, unit, _ = _parts(text)
        times = known_in(unit, self.unit) if unit else None
        value = number(digits, what) * times if times else _quantity(text, what, self.example, self.unit)
        return _checked(value, text, what, self.unit, self.most) if self.most else value

    def each(self, given: object, what: str) -> tuple[Fraction, ...]:
        """Return the values of a list, as a book has them: 200kg;300kg, or 0;400;800mm.

        Where the last value that is given is the only one with a unit, it is that of all. Raises
        NotationError for a value that is asked for with a ?.
        """
        found = self.each_or_unknown(given, what)
        known = tuple(value for value in found if value is not None)
        if len(known) < len(found):
            raise NotationError(f"{what} has a ?, but it is not found from the others; give it")
        return known

    def each_or_unknown(self, given: object, what: str) -> tuple[Fraction | None, ...]:
        """Return the same, None where a ? stands."""
        parts = _entries(given, what)
        if isinstance(given, str):
            parts = _with_unit(parts, self.unit)
        return tuple(_entry(part, lambda text: self(text, what)) for part in parts)


# "600mm", "0,6 m", "23.5 inch"; "-20mm"
length = Measure("a length such as 600mm", "m", _LARGEST)
displacement = replace(length, most=0)
velocity = Measure("a velocity such as 3 m/s", "m/s")
acceleration = Measure("an acceleration such as 50 m/s²", "m/s**2")
# "50kW", "68 PS"
power = Measure("a power such as 50kW or 68PS", "W", 10**12, "power")
# "200kg", "0.3 t"; "-40kg" where a counterweight outweighs it
mass = Measure("a mass such as 200kg", "kg", _LARGEST)
signed_mass = Measure("a mass such as -40kg", "kg")
# "20kg m²", "20 kg*m**2"
moment_of_inertia = Measure("a moment of inertia such as 20kg m²", "kg*m**2", _LARGEST)
# "10kN", "1000 kgf"
force = Measure("a force such as 10kN", "N", 10**12, "force")
# "-10kN" where it points the other way; "12 kN m", "300Nm"
signed_force = replace(force, most=0)
signed_torque = Measure("a torque such as 12kNm", "N*m")
# "5kJ", "-410 J" below a mean line
energy = Measure("an energy such as 5kJ", "J")
# "1.8s"
duration = Measure("a time such as 1.8s", "s", _LARGEST, "time")
volume = Measure("a specific volume such as 0.24 m³/kg", "m**3/kg", _LARGEST)
# "2 m³/min", "40 l/s"
flow = Measure("a flow such as 2 m³/min", "m**3/s", _LARGEST)
density = Measure("a density such as 4.2 kg/m³", "kg/m**3", _LARGEST)
# "1.013bar"; below 0 where it counts from the atmosphere
pressure = Measure("a pressure such as 1bar", "Pa")
# "6MPa", "6 N/mm²"
stress = Measure("a stress such as 6MPa", "Pa", 10**12)
# "7J/mm²"
energy_an_area = Measure("an energy of an area such as 7J/mm²", "J/m**2", 10**12)
# "800cm²"
area = Measure("an area such as 800cm²", "m**2", _LARGEST)


def specific_volume(text: str, what: str) -> Fraction:
    """Return a specific volume in m³/kg, of a density its reciprocal: "0.24 m³/kg", "4.2 kg/m³"."""
    unit = _parts(text)[2]
    dense = unit and not _is_of(unit, volume.unit) and _is_of(unit, density.unit)
    return 1 / density(text, what) if dense else volume(text, what)


# "0.25 kg/kWh"; "43 MJ/kg"
mass_of_work = Measure("a mass for a work such as 0.25 kg/kWh", "kg/J", _LARGEST)
heating_value = Measure("a heat such as 43 MJ/kg", "J/kg", 10**12)


# Between two factors, none of which begins with a letter, and before what is taken away.
_TIMES = re.compile(r"\s*(?<!\*)[x×*·]\s*(?=[\d.,])")
_LESS = re.compile(r"\s+[-−]\s+|(?<=[A-DF-Za-df-z])[-−](?=[\d.,])")
# The area of a card by its length, times the scale of its spring.
_CARD = re.compile(r"(.+?)/\s*([^/]+?)\s*[x×*·]\s*(.+)/\s*([a-zµμ]+)\s*")


def mean_pressure(text: str, what: str) -> Fraction:
    """Return a pressure in Pa, also of a card: "1200mm² / 75mm x 0.15bar/mm"."""
    card = _CARD.fullmatch(text)
    if card is None:
        return pressure(text, what)
    height = area(card[1].strip(), "area of the card") / length(card[2], "length of the card")
    return height * pressure(card[3].strip(), "scale of the spring") / length(f"1{card[4]}", what)


class MassFlow(NamedTuple):
    """A mass in a second, in kg, or for a joule of work, in the place of a volume."""

    mass: Fraction
    of_work: bool = False


def consumption(text: str, what: str) -> MassFlow:
    """Return what is taken in a second, of "4 kg/h", or for a joule of work, of "0.25 kg/kWh"."""
    unit = _parts(text)[2]
    if unit and _is_of(unit, mass_of_work.unit):
        return MassFlow(mass_of_work(text, what), of_work=True)
    example = "a consumption such as 4 kg/h or 0.25 kg/kWh"
    return MassFlow(Measure(example, "kg/s", _LARGEST)(text, what))


def delivery(text: str, what: str) -> Fraction | MassFlow:
    """Return a flow in m³/s, or of "4 kg/min" its mass."""
    unit = _parts(text)[2]
    return consumption(text, what) if unit and _is_of(unit, "kg/s") else flow(text, what)


def brake_torque(text: str, what: str) -> Fraction:
    """Return a torque in N m, also of a load on an arm, less that of a spring: "1370N - 145N x 0.61m"."""
    load, *arm = _TIMES.split(text, maxsplit=1)
    if not arm:
        return replace(signed_torque, most=10**12)(text, what)
    loads = [replace(force, most=0)(one, what) for one in _LESS.split(load)]
    return _checked((loads[0] - sum(loads[1:])) * length(arm[0], what), text, what, "N m", 10**12)


class OfTurns(NamedTuple):
    """An energy in J over π."""

    share: Fraction


# What makes a work by its factors, beside numbers.
_FACTORS: Mapping[str, Measure] = {
    "force": force,
    "torque": signed_torque,
    "energy_an_area": energy_an_area,
    "speed": Measure("a speed such as 144/min", "1/s"),
    "length": length,
    "area": area,
    "duration": duration,
}
_WORKS = (
    *(("force", "length"), ("energy_an_area", "area"), ("energy_an_area", "length", "length")),
    ("torque", "speed", "duration"),
)


def work(text: str, what: str) -> Fraction | OfTurns:
    """Return an energy in J, also by its factors: "350kN x 200mm x 15%", "1200J/cm² x 8cm x 2cm"; of a torque
    on a shaft that turns, "2.1kNm x 144/min x 0.6s", its share of π."""
    factors = _TIMES.split(text)
    if len(factors) == 1:
        return energy(text, what)
    kinds, found, turns = list[str](), Fraction(1), False
    for one in factors:
        unit = _parts(one)[2]
        name = next((key for key, kind in _FACTORS.items() if unit and _is_of(unit, kind.unit)), "")
        if name == "speed":
            turning = speed(one)
            found, turns = found * turning.value * (2 if turning.turns else 1), turning.turns
        elif name or not unit:
            found *= _FACTORS[name](one, what) if name else share(one, what)
        kinds += [name or "other"] if unit else []
    if tuple(sorted(kinds, key=[*_FACTORS, "other"].index)) not in _WORKS:
        raise NotationError(
            f'{what} "{text[:60]}" is no energy; write 10kJ, a force on a way, 350kN x 30mm, an energy of an'
            " area, 1200J/cm² x 16cm², or a torque, 2kNm x 144/min x 0.6s"
        )
    return OfTurns(found) if turns else found


def volume_swept(text: str, what: str) -> Fraction:
    """Return a volume in m³: "1.5 l", "700cm³"."""
    return Measure("a volume such as 1.5 l or 700cm³", "m**3", _LARGEST)(text, what)


def temperature(text: str, what: str) -> Fraction:
    """Return an absolute temperature in K: "30 °C", "303K"."""
    found = re.fullmatch(rf"\s*({BEFORE_UNIT})\s*(°\s*C|C|K)\s*", text) if len(text) <= _LONGEST else None
    if found is None:
        raise NotationError(f'{what} "{text[:40]}" cannot be read; write a temperature such as 30°C or 303K')
    kelvin = number(found[1], what) + (0 if found[2] == "K" else Fraction("273.15"))
    return _checked(kelvin, text, what, "K", 10**6)


def free_air(text: str, what: str) -> tuple[Fraction, Fraction]:
    """Return the pressure in Pa and the temperature in K of "1.013bar 15°C"."""
    parts = text.replace(" °", "°").split()
    if len(parts) != 2:
        raise NotationError(f'{what} "{text[:40]}" is not a pressure and a temperature; write 1.013bar 15°C')
    return replace(pressure, most=10**12)(parts[0], what), temperature(parts[1], what)


def speed(text: str) -> Speed:
    """Return a speed of rotation: "120/min", "2 Hz", "720 deg/s" in turns, "12.5 rad/s" in radians."""
    example = "a speed of rotation such as 120/min, 120rpm or 12.5rad/s"
    for units, turns in ((TURNS, True), ({RADIANS: Fraction(1)}, False)):
        known = _known(text, "speed", units)
        if known is not None:
            unit = "turns a second" if turns else RADIANS
            return Speed(_checked(known, text, "speed", unit), turns)
    quantity = _pint(text, "speed", example, "1/s")
    name, root = _name(quantity, text), _name(quantity.to_root_units(), text)
    if root not in ("1 / second", "radian / second"):
        # Becquerel and baud count other things than turns.
        raise NotationError(f'speed "{text[:40]}" is in {name}; it must be {example}')
    if "radian" in name:
        return Speed(_checked(quantity.to("rad/s").magnitude, text, "speed", "rad/s"), turns=False)
    # Degrees and revolutions are a rational part of pint's turn, though its π is not exact.
    per_second = "1/s" if root == "1 / second" else "turn/s"
    return Speed(_checked(quantity.to(per_second).magnitude, text, "speed", "turns a second"))


def angular_acceleration(text: str, what: str) -> Fraction:
    """Return an angular acceleration in rad/s²: "50 rad/s²", below 0 where the crank slows down."""
    # Of other units of angle none is a rational part of the radian.
    value = _known(text, what, {f"{RADIANS}/s": Fraction(1)})
    if value is None:
        raise NotationError(
            f'{what} "{text[:40]}" cannot be read; write an angular acceleration such as 50rad/s²'
        )
    return value


def is_measure(text: str) -> bool:
    """Whether the text has a unit."""
    return _parts(text)[1] is not None


def split(text: str) -> tuple[Fraction, str]:
    """Return the number and the unit, as it is written, of what was read as a measure."""
    digits, _, written = _parts(text)
    return number(digits), written


def _parts(text: str) -> tuple[str, str | None, str]:
    """Return the number, nothing of what is no measure, and the unit, as pint reads it and as written."""
    match = re.fullmatch(_MEASURE, text) if len(text) <= _LONGEST else None
    if match is None:
        return "", None, ""
    digits, written = match.groups()
    if written is None:
        return digits, None, ""
    unit = plain_unit(written)
    return (digits, unit, written) if unit else ("", None, "")


def _known(text: str, what: str, units: Mapping[str, Fraction]) -> Fraction | None:
    """Return the value, None if its unit is none of these."""
    digits, unit, _ = _parts(text)
    factor = units.get(unit or "")
    return number(digits, what) * factor if factor else None


def _quantity(text: str, what: str, example: str, base: str) -> Fraction:
    return Fraction(_pint(text, what, example, base).to(base).magnitude)


def _pint(text: str, what: str, example: str, base: str) -> Any:
    """Return what pint reads, which can be converted to the unit."""
    digits, unit, written = _parts(text)
    if base == "m" and (inches := _inches(text)):
        raise NotationError(f"{what} {quoted(text)} has feet and inches or their marks; write {inches}in")
    if not digits:
        raise NotationError(f'{what} "{text[:40]}" is not {example}')
    if unit is None:
        raise NotationError(f'{what} "{text[:40]}" has no unit; write {example}')
    try:
        quantity = registry().Quantity(number(digits, what), "1" + unit if unit.startswith("/") else unit)
    except PINT_ERRORS:
        hint = in_forces(written, base, number(digits, what))
        near = "" if hint else did_you_mean(written, _units_of(base))
        raise NotationError(
            f'{what} "{text[:40]}" has the unknown unit {written}{near}; write {hint or example}'
        ) from None
    if not quantity.check(base):
        hint = in_forces(written, base, number(digits, what))
        wanted = f"write {hint}, with a force in place of the mass" if hint else f"it must be {example}"
        raise NotationError(f'{what} "{text[:40]}" is in {_name(quantity, written)}; {wanted}')
    return quantity


def _inches(text: str) -> str:
    """Return how many inches a length of feet and inches has, or one with their marks; nothing for others."""
    match = re.fullmatch(_FEET, text.strip()) if len(text) <= _LONGEST else None
    if match is None or not (all(match.groups()) or re.search("[^\\w./ ]", text)):
        return ""
    return exact_text(12 * number(match[1] or "0") + number(match[2] or "0"))


def in_forces(written: str, base: str, amount: Fraction | str) -> str:
    """Return a unit, with its amount, a number or a formula, of which a mass is meant as a force, as it is
    written; nothing for what is no such unit like the base."""
    found = re.sub("[A-Za-z]+", lambda name: _FORCES.get(name[0], (name[0],))[0], written)
    if found == written or not _is_of(found, base):
        return ""
    sizes = next((own[1] for word in re.findall("[A-Za-z]+", written) if (own := _FORCES.get(word))), {})

    def so_many(size: int) -> str:
        if isinstance(amount, str):
            return in_shell(f"{amount} {found}" if size == 1 else f"{size}({amount}) {found}")
        return f"{exact_text(amount * size)} {found}"

    return " or ".join(f"{so_many(size)} for {name} tons" for name, size in sizes.items()) or so_many(1)


def _units_of(base: str) -> Sequence[str]:
    """Return the units like the base that are known without pint, turns among them."""
    return [*(unit for unit in FACTORS if known_in(unit, base)), *(TURNS if base == "1/s" else ())]


def _is_of(unit: str, base: str) -> bool:
    """Whether a unit can be converted to the base, which of turns a second is 1/s."""
    return (base == "1/s" and plain_unit(unit) in TURNS) or unit_in(unit, base) is not None


def _name(quantity: Any, written: str) -> str:
    """Return pint's name of the unit, or the one written: before Python 3.12 pint cannot name squares."""
    try:
        return str(quantity.units)
    except TypeError:
        return written


def _checked(value: Fraction, text: str, what: str, unit: str, most: int = _LARGEST) -> Fraction:
    if not 0 < value <= most:
        power = len(str(most)) - 1
        raise NotationError(
            f'{what} "{text[:40]}" is out of range; it must be above 0 and at most 10^{power} {unit}'
        )
    return value


def known_in(unit: str, base: str) -> Fraction | None:
    """Return the unit in the base unit, None if it measures another thing or is not known without pint."""
    known, own = known_unit(unit), known_unit(base)
    return known.size / own.size if known and own and known.powers == own.powers else None


def unit_in(unit: str, base: str) -> Fraction | None:
    """Return the unit in the base unit, None if pint does not know it or it measures another thing."""
    if known_unit(unit) and known_unit(base):
        return known_in(unit, base)
    try:
        return Fraction(registry().Quantity(Fraction(1), plain_unit(unit) or unit).to(base).magnitude)
    except PINT_ERRORS:
        return None


@cache
def registry() -> Any:
    """Return pint's units, which count in fractions."""
    try:
        import pint
    except ImportError:
        from kurbel.reading.environment import missing_extra

        raise missing_extra("quantities with units need pint", "units") from None
    return pint.UnitRegistry(non_int_type=Fraction)


def as_angles_or_unknown(given: object) -> tuple[Fraction | None, ...]:
    """Return angles in degrees, several of which may be equal, None where a ? stands."""
    if isinstance(given, str) and UNKNOWN not in given:
        return tuple(as_crank_angles(given))
    return tuple(_entry(part, as_angle) for part in _entries(given, "angle"))


def _entries(given: object, what: str) -> list[Any]:
    if not isinstance(given, str):
        return [*given] if isinstance(given, Iterable) else [given]
    if len(given) > LONGEST_LIST:
        raise NotationError(
            f"{what} {quoted(given)} has {len(given)} characters; at most {LONGEST_LIST} are read"
        )
    parts = [part.strip() for part in given.split(";")]
    if not all(parts):
        raise NotationError(f"{what} {quoted(given)} has an empty place; write a list as '2;3;4'")
    return parts


def _with_unit(parts: list[str], zero: str) -> list[str]:
    """Return the parts with the unit of the last, 4kg or ?kg, where it is the only one; 0 needs none."""
    asked = parts[-1].removeprefix(UNKNOWN).strip() if parts[-1].startswith(UNKNOWN) else ""
    if asked:
        parts = [*parts[:-1], UNKNOWN]
    known = [part for part in parts if part != UNKNOWN]
    unit = asked
    if measured := [part for part in known if is_measure(part)]:
        last = known[-1].lstrip("+-−0123456789., ")
        unit = last if measured == known[-1:] and asked in ("", last) else ""
    named = [part + unit if part != UNKNOWN and not is_measure(part) else part for part in parts]
    return [f"0{zero}" if part == "0" else part for part in named]


def _entry(part: object, read: Callable[[str], Fraction]) -> Fraction | None:
    if not isinstance(part, str):
        return as_fraction(part)
    return None if part.strip() == UNKNOWN else read(part)
