"""What pages say below their tables of a drive: its size, speed, forces, masses, rod, weight and friction."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from math import isqrt
from typing import TYPE_CHECKING

from kurbel.drive.at import known
from kurbel.drive.crank import Crank
from kurbel.exact.kind import Kind, settled
from kurbel.exact.numerals import Label, Number, figure, finite_decimals, nearest, number_text
from kurbel.kernel.circle import Numeric, root
from kurbel.page.quantity import Texts, Words
from kurbel.reading.amounts import STANDARD_GRAVITY, amount, unit_of_page
from kurbel.reading.notation import ratio_text

if TYPE_CHECKING:
    from kurbel.drive.effort import Areas, Effort
    from kurbel.drive.rod import MovingMasses, Rod, Slope
    from kurbel.reading.units import Speed

WORDS = Texts("motion", "notes")


def drive_notes(cranks: Sequence[Crank], lang: str) -> list[Label]:
    """Return the lines about lengths and speeds, and those about offsets."""
    speeds = [_speed(crank, lang) if crank.speed else "" for crank in cranks if crank.radius is not None]
    lines = [size + speed for size, speed in zip(size_notes(cranks), speeds, strict=True)]
    return lines + _pin_notes(cranks) + offset_notes(cranks, lang)


def _pin_notes(cranks: Sequence[Crank]) -> list[Label]:
    """Return the line about the diameters of pins, which all have alike."""
    pins = zip("BKH", cranks[0].diameters or (), strict=False)
    known = [f"$d_{letter} = {amount(size, 'mm')}$" for letter, size in pins if size is not None]
    return [", ".join(known)] if known else []


def size_notes(cranks: Iterable[Crank]) -> list[Label]:
    """Return the lines about lengths alone, of drives of which neither offset nor mean speed is a slide's."""
    return [_size(crank, crank.radius) for crank in cranks if crank.radius is not None]


def offset_notes(cranks: Sequence[Crank], lang: str) -> list[Label]:
    """Return the lines about offsets: the dead centres and the stroke."""
    return [_offset(crank, lang) for crank in cranks if crank.offset and crank.ratio]


def force_notes(cranks: Sequence[Crank], lang: str) -> Iterable[Label]:
    """Return the lines about the piston forces."""
    return dict.fromkeys(crank.force.note(lang) for crank in cranks if crank.force is not None)


def loaded_notes(crank: Crank, ratio_symbol: str, lang: str, sizes: Iterable[Label] = ()) -> Iterator[Label]:
    """Yield the lines about what acts on piston and crosshead beside a given force, and about the masses."""
    if crank.effort is not None:
        yield from effort_notes(crank.effort, lang)
    if crank.moving is not None:
        yield from moving_notes(crank, ratio_symbol, lang, sizes=sizes)
        if crank.moving.slope is None and (crank.moving.rod or crank.moving.reciprocating):
            yield WORDS["weightless"][lang]


def moving_notes(
    crank: Crank,
    ratio_symbol: str,
    lang: str,
    named: Mapping[str, Words] = WORDS,
    sizes: Iterable[Label] = (),
) -> Iterator[Label]:
    """Yield the lines about the moving masses, with the size and the speed that make forces of them, unless
    the lines above with `sizes` have these.

    A drive without a crosshead has names of its own for where they are.
    """
    moving, speed, radius = known(crank.moving), known(crank.speed), ratio_symbol[0]
    said = {"reciprocating": moving.reciprocating, "rotating": moving.rotating}
    parts = [f"{named[key][lang]} ${amount(mass, 'kg')}$" for key, mass in said.items() if mass]
    if moving.rocker:
        parts.append(f"{named['rocker'][lang]} $J = {amount(moving.rocker, 'kg m²')}$")
    makes_forces = f"${radius} = {amount(known(crank.radius), 'mm')}$", turns_label(speed)
    parts += (one for one in makes_forces if not any(one in line for line in sizes))
    yield WORDS["masses"][lang] + ", ".join(parts)
    if moving.rod is not None:
        yield connecting_rod(moving.rod, lang, ratio_symbol[-1], named)
    if moving.slope is not None:
        yield from weight_notes(moving, lang)


def _size(crank: Crank, radius: Fraction) -> Label:
    rod = f", $L = {amount(radius / crank.ratio, 'mm')}$" if crank.ratio else ""
    return f"$R = {amount(radius, 'mm')}${rod}"


def _speed(crank: Crank, lang: str) -> str:
    speed = known(crank.speed)
    quotient = digits_text(crank.pin_to_mean, 4)
    times, unit = unit_of_page("m/s")
    return WORDS["speed"][lang].format(
        unit=unit,
        turns=f"{turns_label(speed)}, ",
        pin=digits_text(_times(crank.pin_velocity, times), 3),
        mean=digits_text(_times(crank.mean_velocity, times), 3),
        quotient=quotient if crank.offset else "π:2",
    )


def _times(value: Callable[[Kind], Numeric], factor: Fraction) -> Callable[[Kind], Numeric]:
    return value if factor == 1 else lambda numbers: value(numbers) * numbers.of(factor)


def turns_label(speed: Speed) -> Label:
    """Return the speed as it was given, as n or ω."""
    value = figure(60 * speed.value if speed.turns else speed.value)
    return f'$n = {value} "min"^(-1)$' if speed.turns else f'$ω = {value} "rad/s"$'


def _offset(crank: Crank, lang: str) -> Label:
    return WORDS["offset"][lang].format(
        offset=figure(crank.offset),
        ratio=ratio_text(crank.ratio),
        inner=digits_text(crank.inner, 3),
        outer=digits_text(crank.outer, 3),
        stroke=digits_text(crank.way, 4),
    )


def digits_text(value: Callable[[Kind], Numeric], decimals: int) -> str:
    """Return the digits of a value."""
    return number_text(Number(settled(value, decimals), decimals))


def connecting_rod(rod: Rod, lang: str, length: str = "L", named: Mapping[str, Words] = WORDS) -> Label:
    """Return the line about a rod: where its masses are, and its mass if that is known."""
    said = named["connecting_rod"][lang].format(
        length=length,
        centre=_share(1 - rod.centre) if rod.swings[1:] else figure(1 - rod.centre),
        gyration=gyration_text(rod),
        couple=figure(rod.couple),
        mass=f", $M = {amount(rod.mass, 'kg')}$" if rod.mass is not None else "",
    )
    return said + _swing(rod, lang, length)


def _swing(rod: Rod, lang: str, length: str) -> Label:
    """Return from which swings the radius of gyration is, nothing where it was given."""
    if not rod.swings:
        return ""
    said, found = "", WORDS["swing_both"][lang] if rod.swings[1:] else "$k$"
    for time, place, _ in rod.swings:
        point = WORDS.get(f"swing_{place}", WORDS["swing_at"])[lang]
        said += WORDS["swing_too" if said else "swing"][lang].format(
            found=found, time=figure(time), point=point.format(place=_share(place), length=length)
        )
    gravity = rod.swings[0].gravity
    return f"{said}, $g = {amount(gravity, 'm/s²')}$" + usual_gravity(gravity)


def gyration_text(rod: Rod) -> str:
    """Return k/L."""
    square = rod.gyration_square
    return _root(square) or digits_text(lambda numbers: root(numbers.of(square)), 4)


def _share(value: Fraction) -> str:
    """A share of the rod that was measured, to four places where it has no end."""
    return number_text(nearest(value, 4)) if finite_decimals(value) is None else figure(value)


def _root(square: Fraction) -> str:
    """The square root of a fraction that has a short one, else nothing."""
    found = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    return figure(found) if found * found == square and finite_decimals(found) is not None else ""


ACTING = Texts("motion", "acting")


def weight_notes(moving: MovingMasses, lang: str) -> Iterator[Label]:
    """Yield the line about the weight of moving masses, if it counts."""
    if moving.slope is None:
        return
    parts = "all" if moving.rod and moving.reciprocating else "rod" if moving.rod else "reciprocating"
    said = ACTING["weight"][lang].format(
        parts=ACTING[parts][lang],
        angle=figure(moving.slope.angle),
        where=_where(moving.slope, lang),
        gravity=amount(moving.slope.gravity, "m/s²"),
    )
    yield said + usual_gravity(moving.slope.gravity)


def usual_gravity(gravity: Fraction) -> str:
    """Return the option that gives another acceleration of gravity than the standard one."""
    return " (--gravity)" if gravity == STANDARD_GRAVITY else ""


def _where(slope: Slope, lang: str) -> str:
    # What is below has a negative sine.
    side = slope.angle % 360
    height = "level" if side in (0, 180) else "above" if side < 180 else "below"
    turning = "" if slope.upright else ACTING["over" if slope.over else "under"][lang]
    return ACTING[height][lang] + turning


def effort_notes(effort: Effort, lang: str) -> Iterator[Label]:
    """Yield the lines about pressures on the piston and about friction."""
    pressures = effort.pressures
    if pressures is not None:
        areas = pressures.areas
        yield ", ".join(_areas(areas))
        yield ACTING["difference" if pressures.difference else "pressures"][lang].format(
            cover="(d^2 - d_D^2)" if areas.tail else "d^2",
            other="(d^2 - d_K^2)" if areas.rod else "d^2",
            head=amount(pressures.head, "kPa"),
            crank=amount(pressures.crank, "kPa"),
        )
    if effort.areas is not None:
        yield ACTING["rods"][lang].format(rods=", ".join([*_areas(effort.areas)][1:]))
    if effort.pins is not None:
        yield ACTING["pins"][lang].format(
            friction=figure(effort.pins.friction),
            **{name: amount(getattr(effort.pins, name), "mm") for name in ("crosshead", "crank", "shaft")},
        )
    if effort.shaft is not None:
        power, torque = effort.shaft.power, "M_R" if effort.pins else "M_d"
        yield ACTING["shaft"][lang].format(
            torque=f"({torque} - P/ω)" if power else torque,
            inertia=amount(effort.shaft.inertia, "kg m²"),
            power=f", $P = {amount(power, 'W')}$" if power else "",
        )
    if effort.friction:
        yield ACTING["friction"][lang].format(force=amount(effort.friction, "N"))


def _areas(areas: Areas) -> Iterator[Label]:
    yield f"$d = {amount(areas.bore, 'mm')}$"
    if areas.rod:
        yield f"$d_K = {amount(areas.rod, 'mm')}$"
    if areas.tail:
        yield f"$d_D = {amount(areas.tail, 'mm')}$"
