"""What options say of a press: its strokes, their work, and how long of a cycle it works."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Any, NamedTuple

from kurbel.commands.flywheels.figures import sides_of
from kurbel.engine.diagram.wheel.relations import figures_of
from kurbel.engine.diagram.wheel.sizing import Figures, Known, completed
from kurbel.errors import NotationError, ProblemError
from kurbel.exact.numerals import about
from kurbel.exact.product import Product
from kurbel.reading.given import (
    as_duration,
    as_energy_an_area,
    as_length,
    as_share,
    as_speed,
    as_stress,
)

_HALF = Fraction(1, 2)


class Share(NamedTuple):
    """The share of a cycle in which a press works, None of a blow, the rest of it, and what gives them."""

    working: Product | None
    rest: Product
    option: str


def press_of(given: Mapping[str, Any]) -> Iterator[tuple[str, Known]]:
    """Yield the figures that options give of a press, but for the share of its swing. Raises KurbelError."""
    if given["strokes"] is not None:
        yield "cycles", Known(_strokes(given["strokes"]), ("--strokes",))
    if given["efficiency"] is not None:
        yield "efficiency", Known(_efficiency(given["efficiency"]), ("--efficiency",))
    if given["hole"] is not None:
        yield "work", _punched(given)
    for name in ("shear_energy", "shear_strength"):
        if given["hole"] is None and given[name] is not None:
            raise ProblemError(
                f"--{name.replace('_', '-')} is for the work of a --hole; add that, or give --work"
            )
    if given["share"] is not None and given["duration"] is not None:
        cycles = _share(given["share"]) / _duration(given["duration"])
        if cycles:
            yield "cycles", Known(Product.of(cycles), ("--share", "--duration"))


def share_of(given: Mapping[str, Any], figures: Figures) -> Share | None:
    """Return the share of a cycle in which the press works, None of what is no press."""
    if given["share"] is not None:
        share = _share(given["share"])
        return Share(Product.of(share) if share else None, Product.of(1 - share), "--share")
    if given["duration"] is None:
        return None
    duration, cycles = _duration(given["duration"]), completed(figures).get("cycles")
    if cycles is None:
        raise ProblemError(
            "--duration is a share of the time between two strokes; add --strokes, or --power and --work"
        )
    part, between = Product.of(duration) * cycles.value, Product.of(1) / cycles.value
    if not Product.of(1).exceeds(part):
        raise ProblemError(
            f"a stroke takes {about(duration)} s and comes again after {figures_of(between)} s; it must take"
            " less than that"
        )
    return Share(part, Product.of(1).plus(part, -1), "--duration")


def _share(given: Any) -> Fraction:
    share = as_share(given, "share of the cycle")
    if not 0 <= share < 1:
        raise ProblemError(
            f"the share of the cycle in which the press works is {about(share)}; it must be 0 or more, for a"
            " blow, and below 1, at which the motor does all the work at once"
        )
    return share


def _duration(given: Any) -> Fraction:
    duration = as_duration(given, "duration of a stroke")
    if duration <= 0:
        raise ProblemError(f"the duration of a stroke is {about(duration)} s; it must be above 0")
    return duration


def _efficiency(given: Any) -> Product:
    efficiency = as_share(given, "efficiency")
    if not 0 < efficiency <= 1:
        raise ProblemError(f"the efficiency is {about(efficiency)}; it must be above 0 and at most 1")
    return Product.of(efficiency)


def _strokes(given: Any) -> Product:
    turns = as_speed(given)
    if not turns.turns:
        raise NotationError(f"the strokes are {given}; they count a minute or a second, as 30/min")
    return Product.of(turns.value)


def _punched(given: Mapping[str, Any]) -> Known:
    """Return the work of a hole: the energy of an area times that which is sheared, π d t; of a strength τ
    half the greatest force, π d t τ, times the thickness."""
    energy, strength = given["shear_energy"], given["shear_strength"]
    if (energy is None) == (strength is None):
        raise ProblemError(
            "--hole needs the energy of the sheared area, --shear-energy 7J/mm², or the strength of the"
            " plate, --shear-strength 300MPa; give one of the two"
        )
    sides = sides_of(given["hole"])
    if not sides:
        raise NotationError(
            f'hole "{str(given["hole"])[:40]}" is not a diameter and the thickness of the plate, 38mm x 32mm'
        )
    diameter, thickness = (as_length(one, "hole") for one in sides)
    area = diameter * thickness
    if energy is not None:
        return Known(
            Product.of(as_energy_an_area(energy, "shear energy") * area, 1), ("--hole", "--shear-energy")
        )
    work = as_stress(strength, "shear strength") * area * thickness * _HALF
    return Known(Product.of(work, 1), ("--hole", "--shear-strength"))
