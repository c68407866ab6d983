"""The turn of `kurbel.verify` that kurbel's own options describe, written as they are typed."""

from __future__ import annotations

import re
from fractions import Fraction
from typing import Any

from kurbel import verify
from kurbel.verify import Turn

UNITS = {
    "mm": Fraction(1, 1000), "cm": Fraction(1, 100), "m": Fraction(1), "bar": Fraction(10**5),
    "kg": Fraction(1), "%": Fraction(1, 100), "rad/s": Fraction(1), "": Fraction(1),
}  # fmt: skip
# Kurbel's options, and what `kurbel.verify` calls them.
STEAM = ("back", "exponent", "clearance", "single_acting", "bore", "piston_rod", "tail_rod")
AIR = (*("exponent", "clearance", "suction_loss", "delivery_loss", "single_acting"), "expansion_exponent")
GAS = {
    "cycle": "cycle", "exponent": "exponent", "expansion_exponent": "expansion_exponent", "heat": "heat",
    "peak_pressure": "peak", "cut_off": "cut_off", "exhaust_pressure": "exhaust", "two_stroke": "two_stroke",
}  # fmt: skip


def exact(typed: Any) -> Any:
    """Return what is typed in SI units as a fraction; words and switches as they are."""
    found = re.fullmatch(r"(-?[\d./]+)\s*(\D*)", str(typed))
    return Fraction(found[1]) * UNITS[found[2]] if found else typed


def words(options: dict[str, Any]) -> list[str]:
    """Return the options as a command line has them."""
    named = ((f"--{key.replace('_', '-')}", one) for key, one in options.items() if one is not False)
    return [name if one is True else f"{name}={one}" for name, one in named]


def verified(**options: Any) -> Turn:
    given = {key: exact(one) for key, one in options.items() if key not in ("ratio", "cranks")}
    size: dict[str, Any] = (
        {"radius": given["stroke"] / 2, "speed": given["speed"]} if "stroke" in given else {}
    )
    links: dict[str, Any] = {key: given.get(key) for key in ("rocker", "beam")}
    ratio = str(options.get("ratio", "1:5")).replace("1:∞", "0").replace("/", ":")
    drive = verify.drive(ratio, given.get("offset", 0), **links, **size)
    bodies, unit = None, {}
    if "reciprocating" in given:
        masses = ("reciprocating", "rod_mass", "centre", "gyration", "slope")
        bodies = verify.bodies(drive, inertia=given.get("rocker_inertia"), **_kept(given, masses))
        unit = {"bore": given["bore"], "pressure": _pressure(given)}
    cranks = tuple(str(options.get("cranks", "0")).split(";"))
    method = given.get("method", "exact")
    return verify.turn(drive, _load(given), cranks=cranks, method=method, bodies=bodies, **unit)


def _kept(given: dict[str, Any], names: tuple[str, ...]) -> dict[str, Any]:
    return {name: given[name] for name in names if name in given}


def _pressure(given: dict[str, Any]) -> Fraction:
    """Return the pressure that Q is of, in Pa."""
    if "pump" in given:
        span: Fraction = given["delivery_pressure"] - given["suction_pressure"]
        return span
    return Fraction(given["pressure" if "pressure" in given else "suction_pressure"])


def _load(given: dict[str, Any]) -> verify.Load:
    if "pressure_ratio" in given:
        return verify.compressor(given["pressure_ratio"], **_kept(given, AIR))
    if "pump" in given:
        area = _kept(given, ("small_area",))
        low, high = (given.get(f"{side}_pressure") for side in ("suction", "delivery"))
        return verify.pump(given["pump"], suction=low or 0, delivery=high or 1, **area)
    if "compression" in given:
        renamed = {GAS[key]: one for key, one in given.items() if key in GAS}
        return verify.gas(given["compression"], **renamed)
    return verify.steam(given["eps"], **_kept(given, STEAM))
