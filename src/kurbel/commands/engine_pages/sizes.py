"""What bore, stroke, pressure and speed say on a page without moving masses."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from kurbel.commands.cylinder.effort import RODS, RUBBING
from kurbel.commands.loads import NAMES, pressures_of
from kurbel.commands.machines import EXAMPLE, for_masses, lone_lengths
from kurbel.commands.options import is_given
from kurbel.page.layouts import Layout
from kurbel.reading.given import as_names

# The columns that they are for.
OF_SIZE: Mapping[str, tuple[str, ...]] = {
    "indicated_power": ("stroke", "speed", "bore", "pressure"),
    "delivery": ("stroke", "speed", "bore", "pressure"),
    "mean_pressure_kpa": ("bore", "pressure"),
    "pin_path_mm": ("stroke",),
    "tangential_kpa": ("bore", "pressure"),
    "torque_nm": ("stroke", "bore", "pressure"),
}
# These make a ratio, or with the crank one of another length.
LENGTHS = ("stroke", "rod")
# What may stand beside them, by columns: the bore of a cylinder is given with its stroke.
BESIDE = {"mean_pressure_kpa": ("stroke",)}


def needless_sizes(
    values: Mapping[str, Any], names: Sequence[str], page: Callable[[Sequence[str]], Layout]
) -> Mapping[str, str]:
    """Return what refuses those of these options that neither masses nor columns take.

    Of columns that are asked for each option may be one; those of a layout are shown where all are given.
    """
    # Friction and rods are weighed against the load.
    weighed = ("bore", "pressure") if any(is_given(values.get(one)) for one in (*RUBBING, *RODS)) else ()
    refused = for_masses(*(name for name in names if name not in weighed))(values)
    lone = lone_lengths(values)
    refused = {**refused, "rod": lone.get("rod", "")}
    refused = {
        name: said
        for name, said in refused.items()
        if values[name] is not None and (name in lone or name not in LENGTHS)
    }
    if not refused:
        return {}
    asked = as_names(values["columns"], EXAMPLE)
    if asked:
        sizes = [one for name in asked for one in (*OF_SIZE.get(name, ()), *BESIDE.get(name, ()))]
        used = _needs(values, sizes)
        return {name: said for name, said in refused.items() if name not in used}
    needs = [_needs(values, OF_SIZE[one.key]) for one in page(asked).columns if one.key in OF_SIZE]
    shown = {name for need in needs if all(values[one] is not None for one in need) for name in need}
    return {name: _said(values, name, needs) or said for name, said in refused.items() if name not in shown}


def _needs(values: Mapping[str, Any], sizes: Sequence[str]) -> list[str]:
    """Return the options that make a column known, with that of the pressure in question."""
    # The rod gives the stroke by the ratio.
    length = "rod" if values["stroke"] is None and values["rod"] is not None else "stroke"
    instead = {"pressure": _pressures(values), "stroke": (length,)}
    return [option for name in sizes for option in instead.get(name, (name,))]


def _pressures(values: Mapping[str, Any]) -> Sequence[str]:
    if any(is_given(values.get(name)) for name in NAMES):
        return pressures_of(values)
    return () if is_given(values["card"]) else ("pressure",)


def _said(values: Mapping[str, Any], name: str, needs: Sequence[Sequence[str]]) -> str:
    """Return what would make the page say something of an option, nothing where no column takes it."""
    lacking = [[*_lacking(values, need)] for need in needs if name in need]
    if not lacking:
        return _of_others(values, name)
    others = min(lacking, key=len)
    return f"--{name} says nothing on this page by itself; add {', '.join(others)}"


def _of_others(values: Mapping[str, Any], name: str) -> str:
    """Return the same of a page of another load than steam and cards, none of whose columns takes it."""
    pages = ("pin_path_mm", "tangential_kpa") if "angle" in values else ("indicated_power",)
    column = next((one for one in pages if name in OF_SIZE[one]), "")
    if not column or not any(is_given(values.get(one)) for one in NAMES):
        return ""
    return f"--{name} says nothing on this page; add --reciprocating, or a column such as {column}"


def _lacking(values: Mapping[str, Any], need: Sequence[str]) -> Iterator[str]:
    yield from (f"--{one.replace('_', '-')}" for one in need if values[one] is None)
