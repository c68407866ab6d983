"""What options say of a flywheel, as the figures of relations.py; each in units of the SI."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

from kurbel.engine.diagram.wheel.sizing import Known
from kurbel.errors import NotationError, ProblemError
from kurbel.exact.numerals import about
from kurbel.exact.product import Product
from kurbel.reading.given import (
    as_area,
    as_density,
    as_energy,
    as_inertia,
    as_length,
    as_mass,
    as_number,
    as_power,
    as_ratio,
    as_share,
    as_speed,
    as_stress,
    as_velocity,
)
from kurbel.reading.units import is_measure, split

# By the option the figure that it gives, what errors call it, its unit in the SI, and how it is read.
_PLAIN: Mapping[str, tuple[str, str, str, Callable[..., Fraction]]] = {
    "swing": ("swing", "energy swing", "J", as_energy),
    "energy_fluctuation": ("energy_fluctuation", "coefficient of fluctuation of energy", "", as_share),
    "work": ("work", "work of a cycle", "J", as_energy),
    "turns": ("turns", "number of turns of a cycle", "", as_number),
    "power": ("power", "power", "W", as_power),
    "inertia": ("inertia", "moment of inertia", "kg m²", as_inertia),
    "mass": ("mass", "mass", "kg", as_mass),
    "radius": ("radius", "radius", "m", as_length),
    "rim_diameter": ("rim_diameter", "mean diameter of the rim", "m", as_length),
    "rim_speed": ("rim_speed", "speed of the rim", "m/s", as_velocity),
    "rim_breadth": ("breadth", "breadth of the rim", "m", as_length),
    "rim_thickness": ("thickness", "thickness of the rim", "m", as_length),
    "density": ("density", "density", "kg/m³", as_density),
    "hoop_stress": ("hoop_stress", "hoop stress", "Pa", as_stress),
    "rim_share": ("rim_share", "share of the rim", "", as_share),
    "disc_diameter": ("disc_diameter", "diameter of the disc", "m", as_length),
    "disc_thickness": ("disc_thickness", "thickness of the disc", "m", as_length),
}
_SPEEDS = {"speed": "omega", "greatest_speed": "omega_max", "least_speed": "omega_min"}
_RANGE = re.compile(r"(.+?)\.\.(.+)")
_SQUARE = re.compile(r"(?<=[a-z])2$")


def figures_of(given: Mapping[str, Any], names: Collection[str] = ()) -> Iterator[tuple[str, Known]]:
    """Yield the figures that options give, or those of them with these names, but for δ and what a diagram
    gives. Raises KurbelError."""
    taken = {name: value if not names or name in names else None for name, value in given.items()}
    for figure, value, option in _all(taken):
        yield figure, Known(value, (f"--{option.replace('_', '-')}",))


def _all(given: Mapping[str, Any]) -> Iterator[tuple[str, Product, str]]:
    for option, (figure, name, unit, read) in _PLAIN.items():
        if option == "rim_speed" and (ends := _ends(given[option])):
            yield from ((figure, value, option) for figure, value in _of_rim_speeds(ends))
        elif given[option] is not None:
            # What a motor gives is more than what the press takes.
            figure = "motor" if option == "power" and given["efficiency"] is not None else figure
            number = read(given[option], name)
            if option == "rim_share" and number > 1:
                raise ProblemError(f"the {name} is {about(number)}; it must be at most 1, the whole flywheel")
            yield figure, _above_zero(number, name, unit), option
    for option, figure, value in _speeds(given):
        yield figure, value, option
    for figure, value in _section(given["rim_section"]):
        yield figure, value, "rim_section"


def _above_zero(value: Fraction, name: str, unit: str) -> Product:
    if value <= 0:
        raise ProblemError(f"the {name} is {f'{about(value)} {unit}'.strip()}; it must be above 0")
    return Product.of(value)


def _speeds(given: Mapping[str, Any]) -> Iterator[tuple[str, str, Product]]:
    ends = _ends(given["speed"])
    for option, figure in _SPEEDS.items():
        if given[option] is not None and not (ends and option == "speed"):
            yield option, figure, omega_of(given[option])
    if ends:
        one, other = map(omega_of, ends)
        low, high = (other, one) if one.exceeds(other) else (one, other)
        yield "speed", "omega_min", low
        yield "speed", "omega_max", high


def _ends(speed: Any) -> list[str]:
    """Return the two speeds of "200..225/min", none of another text."""
    ends = _RANGE.fullmatch(speed) if isinstance(speed, str) else None
    return in_one_unit(ends.groups()) if ends else []


def _of_rim_speeds(ends: Sequence[str]) -> Iterator[tuple[str, Product]]:
    """Yield the mean speed of a rim and δ, of its least and its greatest speed."""
    low, high = sorted(as_velocity(end, "speed of the rim") for end in ends)
    if low <= 0 or low == high:
        raise ProblemError(
            f"the speed of the rim runs from {about(low)} m/s to {about(high)} m/s; the least must be above 0"
            " and below the greatest"
        )
    yield "rim_speed", Product.of((low + high) / 2)
    yield "delta", Product.of(2 * (high - low) / (low + high))


def in_one_unit(texts: Sequence[str]) -> list[str]:
    """Return measures of which the last alone may have a unit, each with it: 200 and 225/min."""
    *others, last = (text.strip() for text in texts)
    unit = split(last)[1] if is_measure(last) else ""
    return [*(text if is_measure(text) else f"{text}{unit}" for text in others), last]


def omega_of(speed: Any) -> Product:
    """Return ω in 1/s of a speed of rotation."""
    turns = as_speed(speed)
    return Product.of(2 * turns.value, 1) if turns.turns else Product.of(turns.value)


def sides_of(given: Any) -> list[str]:
    """Return the two lengths of "400mm x 200mm" or "400 x 200 mm", none of another text."""
    sides = re.split(r"[x×]", given) if isinstance(given, str) else []
    return in_one_unit(sides) if len(sides) == 2 else []


def _section(given: Any) -> Iterator[tuple[str, Product]]:
    """Yield what the section of a rim gives: breadth and thickness, its area, or the ratio of both."""
    if given is None:
        return
    name = "section of the rim"
    if sides := sides_of(given):
        for figure, side in zip(("breadth", "thickness"), sides, strict=True):
            yield figure, _above_zero(as_length(side, f"{figure} of the rim"), f"{figure} of the rim", "m")
    elif isinstance(given, str) and any(map(str.isalpha, given)):
        area = as_area(_SQUARE.sub("²", given.strip()), name)
        yield "section", _above_zero(area, name, "m²")
    else:
        yield "proportion", _above_zero(_ratio(given), "ratio of breadth to thickness of the rim", "")


def _ratio(given: Any) -> Fraction:
    try:
        return as_ratio(given)
    except NotationError:
        raise NotationError(
            f'section of the rim "{str(given)[:40]}" cannot be read; write breadth to thickness, 2:1, both,'
            " 400mm x 200mm, or 800cm²"
        ) from None
