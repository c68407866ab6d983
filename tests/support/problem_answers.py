"""The problems of examples/problems solved by laws of mechanics, not by the formulas that kurbel prints.

A solution takes the values of a problem in SI units, angles in degrees, and returns what the page must show,
by the keys of its records, of its rows in their order.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence

from mpmath import mp, mpf

Rows = Sequence[Mapping[str, mpf | int | float]]
SOLUTIONS: dict[str, Callable[..., Rows]] = {}
UNITS = {
    "": mpf(1),
    "%": mpf(1) / 100,
    "°": mpf(1),
    "mm": mpf("0.001"),
    "m": mpf(1),
    "/min": 2 * mp.pi / 60,
    "/h": mpf(1) / 3600,
    "rad/s": mpf(1),
    "rad/s2": mpf(1),
    "m/s": mpf(1),
    "m/s²": mpf(1),
    "km/h": mpf(1) / mpf("3.6"),
    "s": mpf(1),
    "kg": mpf(1),
    "t": mpf(1000),
    "N": mpf(1),
    "kN": mpf(1000),
    "K": mpf(1),
    "Nm": mpf(1),
    "kNm": mpf(1000),
    "J": mpf(1),
    "kJ": mpf(1000),
    "W": mpf(1),
    "kW": mpf(1000),
    "bar": mpf(10) ** 5,
    "MPa": mpf(10) ** 6,
    "kPa": mpf(1000),
    "m3/kg": mpf(1),
    "kg m2": mpf(1),
    "kgm2": mpf(1),
    "kg/m3": mpf(1),
    "m3/min": mpf(1) / 60,
    "kg/min": mpf(1) / 60,
    "kJ/kg": mpf(1000),
    "J/mm²": mpf(10) ** 6,
    "l": mpf("0.001"),
    "cm": mpf("0.01"),
    "cm²": mpf("0.0001"),
}


def solution(solve: Callable[..., Rows]) -> Callable[..., Rows]:
    """Enter a solution under the name of its problem."""
    SOLUTIONS[solve.__name__.replace("_", "-")] = solve
    return solve


def in_si(value: str) -> mpf | list[mpf]:
    """Return a value as problems have it: '1.5 kN', '20%', '1/3', '1:4' as a ratio, '1;2' as a list."""
    if ";" in value:
        return [one for part in value.split(";") if isinstance(one := in_si(part.strip()), mpf)]
    if ":" in value:
        first, second = value.split(":")
        return mpf(first) / mpf(second)
    found = re.fullmatch(r"(-?[\d.]+)(?:/([\d.]+))? ?(.*)", value)
    assert found, value
    number, parts, unit = found.groups()
    return mpf(number) / mpf(parts or 1) * UNITS[unit]
