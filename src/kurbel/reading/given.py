"""What was typed, or given in Python: files, names that must be one of a few, exact numbers, places.

A number may be text, an integer, a fraction or a float; bare numbers are in units of the SI, in degrees, or
in turns a second.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, fields
from decimal import Decimal
from fractions import Fraction
from importlib import import_module
from itertools import chain
from typing import TYPE_CHECKING, Any, ParamSpec, TypeAlias, TypeVar, cast

from kurbel.errors import ChoiceError, NotationError, OutsideError
from kurbel.reading import notation
from kurbel.reading.names import did_you_mean, otherwise

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from kurbel.reading.units import MassFlow, Speed

# A float is read by its shortest decimal, so that 0.2 is 1/5; text as on the command line.
Exact: TypeAlias = str | int | float | Fraction | Decimal
P = ParamSpec("P")
Made = TypeVar("Made")
# Whose folder it is in which files have to lie.
HANDBOOK, DOCUMENT = "handbook", "document"
# Where one name is near, no more of others are read.
_LISTED = 20
_EITHER_WAY = r"\s*(?:±|\+/?[-−])\s*(?=[\d.,])"


class FrozenValue:
    """A frozen dataclass that is pickled and copied as what was given; what it found since is found again."""

    def __getstate__(self) -> dict[str, object]:
        return {field.name: getattr(self, field.name) for field in fields(cast("Any", self))}


class File(os.PathLike[str]):
    """A file by its name, which counts from a folder; no folder is the one in which kurbel runs.

    One that is `inside`, of a handbook or a document, is refused where it is opened elsewhere, and so is what
    it names beside itself.
    """

    __slots__ = ("folder", "inside", "name")

    def __init__(self, name: str, folder: str = "", inside: str = "") -> None:
        self.name = name
        self.folder = folder
        self.inside = inside

    def __fspath__(self) -> str:
        path = os.path.join(self.folder, self.name)
        if self.inside:
            check_inside(path, self.folder, self.name, self.inside)
        return path

    def __bool__(self) -> bool:
        return bool(self.name)

    def __str__(self) -> str:
        return self.name

    def __repr__(self) -> str:
        return f"File({self.name!r}, {self.folder!r}, {self.inside!r})"

    def beside(self, name: str) -> File:
        """Return the file of a name that counts from where this one lies."""
        return self.named(os.path.join(os.path.dirname(self.name), name))

    def named(self, name: str) -> File:
        """Return the file of a name that counts from the same folder."""
        return File(name, self.folder, self.inside)


def is_inside(path: str, folder: str) -> bool:
    """Tell whether a file lies in a folder."""
    home = os.path.join(os.path.realpath(folder or "."), "")
    return os.path.join(os.path.realpath(path), "").startswith(home)


def check_inside(path: str, folder: str, name: str, whose: str = HANDBOOK) -> None:
    """Raise OutsideError for a file that lies outside of the folder; `name` is what it was called.

    `whose` the folder is: that of a handbook or of a document.
    """
    if not is_inside(path, folder):
        raise OutsideError(name, whose)


def check_below(path: str, folder: str, name: str, whose: str) -> None:
    """Raise the same for a folder that has something in it which leads out; a file has nothing in it."""
    for way, folders, files in os.walk(path):
        for one in (*folders, *files):
            file = os.path.join(way, one)
            check_inside(file, folder, os.path.join(name, os.path.relpath(file, path)), whose)


def found_at(place: str) -> Any:
    """Return what stands at a place as registries have it, "module:name"."""
    module, _, name = place.partition(":")
    return getattr(import_module(module), name)


def of_given(make: Callable[..., Made], *args: object, **given: object) -> Made:
    """Return what is made of what is given; what is None the maker has by itself."""
    return make(*args, **{name: value for name, value in given.items() if value is not None})


def choose(name: str, allowed: Iterable[str], what: str) -> str:
    """Return the name if it is allowed, else raise ChoiceError with the nearest name, or all of them."""
    return _chosen(name, [*allowed], what)


def allowed_name(name: object, allowed: Iterable[str], what: str) -> str:
    """Return the name that is meant, which may be written with capitals or by another word for it."""
    names = [*allowed]
    if isinstance(name, str) and name not in names:
        name = otherwise(name, names) or name
    return _chosen(name, names, what, words=True)


def _chosen(name: object, names: Sequence[str], what: str, words: bool = False) -> str:
    if not isinstance(name, str):
        raise ChoiceError(f"{what} is {name!r}; choose from {', '.join(names)}")
    if name in names:
        return name
    near = did_you_mean(name, names, words)
    listed = "" if near and len(names) > _LISTED else f"; choose from {', '.join(names)}"
    raise ChoiceError(f'there is no {what} "{name[:60]}"{near}{listed}')


def read_values(
    given: object,
    texts: Callable[[Iterable[str]], Sequence[Fraction]],
    one: Callable[[object], Fraction],
) -> Sequence[Fraction]:
    """Read one value or many; text may hold lists and ranges, as on the command line."""
    values = [given] if isinstance(given, str) or not isinstance(given, Iterable) else list(given)
    as_text = [value for value in values if isinstance(value, str)]
    return texts(as_text) if len(as_text) == len(values) else tuple(dict.fromkeys(map(one, values)))


def as_ratios(given: object) -> tuple[Fraction, ...]:
    return tuple(read_values(given, notation.ratios, as_ratio))


def as_ratio_array(given: Any) -> NDArray[np.object_]:
    """Read crank ratios in an array, text or numbers; those of a text that holds several stand in a row."""
    import numpy as np

    if isinstance(given, str):
        found = as_ratios(given)
        return np.array(found if len(found) > 1 else found[0], dtype=object)
    values = given if hasattr(given, "dtype") else np.array(given, dtype=object)
    return np.array(np.frompyfunc(as_ratio, 1, 1)(values), dtype=object)


def as_angles(given: object) -> Sequence[Fraction]:
    return read_values(given, notation.angles, as_angle)


def as_numbers(given: object, what: str) -> tuple[Fraction, ...]:
    return tuple(read_values(given, lambda texts: notation.numbers(texts, what), as_fraction))


# What asks for a share of the stroke, s=25%.
SHARE = "s"


def as_shares(given: object, what: str) -> tuple[Fraction, ...]:
    """Read shares, each once."""
    return tuple(read_values(given, lambda texts: notation.shares(texts, what), as_fraction))


def as_expansions(given: object) -> tuple[Fraction, ...]:
    """Read expansion ratios; the share of the stroke before the cut-off is answered with the ratio it is."""
    try:
        return as_numbers(given, "expansion ratio")
    except NotationError:
        notation.refuse_cut_off(given)
        raise


def as_crank_angles(given: object) -> Sequence[Fraction]:
    """Read the angles of cranks, several of which may be equal."""
    return notation.angles([given], repeated=True) if isinstance(given, str) else _each(given, as_angle)


def as_places(given: object, what: str) -> Sequence[Fraction]:
    """Read numbers, several of which may be equal."""
    return notation.each_number([given], what) if isinstance(given, str) else _each(given, as_fraction)


def _each(given: object, one: Callable[[object], Fraction]) -> tuple[Fraction, ...]:
    return tuple(map(one, given if isinstance(given, Iterable) else [given]))


def as_irregularities(given: object) -> Sequence[Fraction]:
    """Read degrees of irregularity: "1:100", "0.01;1/150", "1%"; "±1%" of the mean is one of 2%."""
    return read_values(given, _irregularities, as_ratio)


def _irregularities(texts: Iterable[str]) -> Sequence[Fraction]:
    # None is 0, so that 0,01 can only be a decimal.
    decimals = (re.sub(r"\b0,(?=\d)", "0.", text) for text in texts)
    parts = [*notation.parts_of(decimals, _irregularity, "degree of irregularity")]
    notation.check_length(len(parts), notation.LONGEST_LIST, "degrees of irregularity")
    return tuple(dict.fromkeys(map(_irregularity, parts)))


def _irregularity(text: str) -> Fraction:
    either_way = re.match(_EITHER_WAY, text)
    if either_way:
        return 2 * _irregularity(text[either_way.end() :])
    try:
        return notation.share(text) if text.strip().endswith("%") else notation.ratio(text)
    except NotationError:
        raise NotationError(
            f"degree of irregularity {notation.quoted(text)} cannot be read; write it as 1:100, 0.01 or 1%"
        ) from None


def as_names(given: object, example: str = "phi,x,c,p") -> tuple[str, ...]:
    """Read the names of columns, each once."""
    if given is None:
        return ()
    if not isinstance(given, Iterable):
        raise NotationError(f"columns is {given!r}; write names as {example} or in a list")
    texts = [given] if isinstance(given, str) else list(given)
    if not all(isinstance(text, str) for text in texts):
        # What is no text is answered where the columns are chosen.
        return (*texts,)
    parts = {text: [part.strip() for part in text.replace(";", ",").split(",")] for text in texts}
    for text, names in parts.items():
        if not all(names):
            raise NotationError(f"columns {notation.quoted(text)} has an empty place; write it as {example}")
    return tuple(dict.fromkeys(chain.from_iterable(parts.values())))


def as_fraction(value: object) -> Fraction:
    if isinstance(value, Fraction):
        return value
    return Fraction(value) if isinstance(value, int) else notation.number(str(value))


@dataclass(frozen=True)
class Reader:
    """What reads a value of either kind, text in its way; a bare number is in the unit."""

    text: Callable[..., Fraction]
    unit: str = ""

    def __call__(self, value: object, *what: str) -> Fraction:
        return self.text(value, *what) if isinstance(value, str) else as_fraction(value)


as_ratio = Reader(notation.ratio)
as_angle = Reader(notation.angle, "degrees")
as_number = Reader(notation.number)
as_share = Reader(notation.share)


def _measured(name: str, unit: str) -> Reader:
    """Return the reader of a measure; units are loaded where there are any."""

    def read(text: str, what: str = "") -> Fraction:
        from kurbel.reading import units

        value: Fraction = getattr(units, name)(text, what)
        return value

    return Reader(read, unit)


as_length = _measured("length", "m")
as_mass = _measured("mass", "kg")
as_signed_mass = _measured("signed_mass", "kg")
as_inertia = _measured("moment_of_inertia", "kg m²")
as_pressure = _measured("pressure", "Pa")
as_mean_pressure = _measured("mean_pressure", "Pa")
as_force = _measured("force", "N")
as_signed_force = _measured("signed_force", "N")
as_power = _measured("power", "W")
as_torque = _measured("signed_torque", "N m")
as_duration = _measured("duration", "s")
# Against the direction that counts it is below 0.
as_displacement = _measured("displacement", "m")
as_angular_acceleration = _measured("angular_acceleration", "rad/s²")
as_velocity = _measured("velocity", "m/s")
as_acceleration = _measured("acceleration", "m/s²")
as_specific_volume = _measured("specific_volume", "m³/kg")
as_density = _measured("density", "kg/m³")
as_heating_value = _measured("heating_value", "J/kg")
as_brake_torque = _measured("brake_torque", "N m")
as_temperature = _measured("temperature", "K")
as_energy = _measured("energy", "J")
as_work = _measured("work", "J")
as_volume = _measured("volume_swept", "m³")
as_stress = _measured("stress", "Pa")
as_area = _measured("area", "m²")
as_energy_an_area = _measured("energy_an_area", "J/m²")


def as_share_or_pressure(value: object, what: str, whole: object) -> Fraction:
    """Return a share, or what a pressure is of the whole one, which is written likewise."""
    from kurbel.reading import units

    if not isinstance(value, str) or not units.is_measure(value):
        return as_share(value, what)
    if whole is None:
        raise NotationError(
            f'{what} "{value[:40]}" is a pressure, which counts in the steam pressure; add --pressure'
        )
    measured, steam = units.pressure(value, what), as_pressure(whole, "pressure")
    if not 0 <= measured <= steam:
        raise NotationError(
            f'{what} "{value[:40]}" must lie within 0 and the steam pressure {str(whole)[:40]}, both above'
            " vacuum"
        )
    return measured / steam if steam else measured


def as_gravity(value: object) -> Fraction:
    """Return an acceleration in m/s², which of text needs no unit."""
    if isinstance(value, str):
        from kurbel.reading import units

        if units.is_measure(value):
            return units.acceleration(value, "gravity")
    return as_number(value, "gravity")


def as_speed(value: object) -> Speed:
    """Return a speed of rotation; a bare number counts turns a second."""
    from kurbel.reading import units

    return units.speed(value) if isinstance(value, str) else units.Speed(as_fraction(value))


def as_free_air(value: object, what: str) -> tuple[Fraction, Fraction]:
    """Return the pressure in Pa and the temperature in K of a state of air, which is always text."""
    from kurbel.reading import units

    return units.free_air(str(value), what)


def as_consumption(value: object, what: str) -> MassFlow:
    """Return a mass in a second or for a joule; a bare number is in kg/s."""
    from kurbel.reading import units

    return units.consumption(value, what) if isinstance(value, str) else units.MassFlow(as_fraction(value))


def as_delivery(value: object, what: str) -> Fraction | MassFlow:
    """Return a volume in a second, or its mass; a bare number is in m³/s."""
    from kurbel.reading import units

    return units.delivery(value, what) if isinstance(value, str) else as_fraction(value)


def as_share_or_length(value: object, what: str, whole: Fraction | None, unknown: str) -> Fraction:
    """Return a share, or what a length is of the whole in metres; `unknown` says how to make that known."""
    from kurbel.reading import units

    if not isinstance(value, str) or not units.is_measure(value):
        return as_share(value, what)
    measured = units.length(value, what)
    if whole is None:
        raise NotationError(f'{what} "{value[:40]}" is a length, but {unknown}')
    return measured / whole
