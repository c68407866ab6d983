"""What is said of columns by the names of the conventions for climate and forecast data (CF)."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from typing import Any

from kurbel.sweeps.files.about import About
from kurbel.sweeps.rows import Column

# Units as udunits spells them, where that is not the letter itself.
SPELLED: Mapping[str, str] = {
    "°": "degree",
    "%": "percent",
    "rad": "radian",
    "min": "minute",
    "h": "hour",
}
OWN = frozenset(("m", "mm", "cm", "km", "kg", "s", "N", "J", "W", "kW", "Pa", "kPa", "MPa", "bar", "Hz"))
_POWERS = str.maketrans("⁻¹²³", "-123")
_UNIT = re.compile(r"(?P<letters>[^\d\s⁻¹²³]+)(?P<power>[⁻¹²³]*)")


def cf_of_file(about: About) -> dict[str, str]:
    """Return the attributes of a file."""
    said = about.file()
    return {
        "Conventions": "CF-1.11",
        "title": said["title"],
        "source": f"kurbel {said['kurbel']}",
        "kurbel": json.dumps(said, ensure_ascii=False),
    }


def cf_of(about: About, column: Column) -> dict[str, Any]:
    """Return the attributes of an array. `units` are those of udunits, "1" where the unit is one of the drive
    itself, such as R; `unit` is that as pages print it."""
    said: dict[str, Any] = {**about.column(column)}
    said.pop("role")
    if "name" in said:
        said["long_name"] = said.pop("name")
    if column.kind == "number":
        said["units"] = udunits(said.get("unit", ""))
    if "source" in said:
        said["references"] = said.pop("source")
    return said


def udunits(unit: str) -> str:
    """Return a unit as udunits spells it: m/s² is "m s-2"; "1" for one that it does not know."""
    above, _, below = unit.partition("/")
    factors = [*_factors(above, 1), *_factors(below, -1)]
    if unit.startswith("%"):
        return "percent"
    if not unit or None in factors:
        return "1"
    return " ".join(one for one in factors if one)


def _factors(text: str, sign: int) -> list[str | None]:
    return [_factor(word, sign) for word in text.split()]


def _factor(word: str, sign: int) -> str | None:
    found = _UNIT.fullmatch(word)
    if word == "kWh":
        return "kW hour" if sign > 0 else "kW-1 hour-1"
    if found is None:
        return None
    letters, power = found["letters"], sign * int(found["power"].translate(_POWERS) or 1)
    if letters not in OWN and letters not in SPELLED:
        return None
    name = SPELLED.get(letters, letters)
    return name if power == 1 else f"{name}{power}"
