"""What was asked for, as kurbel reads it: its drive, its load and its bodies for `kurbel.verify`."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from typing import Any

from kurbel import verify
from kurbel.commands.engine import EngineWithWheel
from kurbel.commands.motion import OverPath
from kurbel.commands.options import Option
from kurbel.commands.part import Values
from kurbel.commands.parts.drive import Turning
from kurbel.commands.parts.effort import PRESSING, Effort, PinFriction
from kurbel.commands.parts.masses import each, place_on_rod
from kurbel.commands.recomputed import Row, nearest
from kurbel.drive.crank import DescribedDrive, radii
from kurbel.drive.rod_file import rod_sections
from kurbel.engine.card.card import AngleCard, PistonCard
from kurbel.engine.card.file import read_card
from kurbel.errors import ProblemError
from kurbel.motion.mechanism import mechanism
from kurbel.page.layouts import Layout, layout
from kurbel.reading.amounts import STANDARD_GRAVITY
from kurbel.reading.given import (
    as_angular_acceleration,
    as_expansions,
    as_mass,
    as_number,
    as_pressure,
    as_share_or_length,
    as_share_or_pressure,
    as_signed_force,
    as_speed,
    of_given,
)
from kurbel.reading.notation import number, ratio_text
from kurbel.verify.bodies import Force, lying, swung
from kurbel.verify.loads import Stroke, constant, disc
from kurbel.verify.numbers import Number
from kurbel.verify.numbers import number as exactly
from kurbel.verify.zeros import FoundAngle

# Of each load its options, which the second computation calls likewise.
AIR = ("exponent", "clearance", "single_acting", "suction_loss", "delivery_loss", "expansion_exponent")
STEAM = (*AIR[:3], "release", "cushion", "lead")
GAS = ("cycle", "exponent", "expansion_exponent", "heat", "cut_off", "two_stroke")
# How near a point of a card its curve passes, in the greatest pressure.
THROUGH = 1e-12
# Columns that say which load a row is of.
Moments = Callable[[], list[Number]]
LOADED = ("epsilon", "pressure_ratio", "pump", "compression")


class Figure(str):
    """A number of a file as it is written there."""


class KnownOptions(OverPath, EngineWithWheel, Effort, PinFriction, Turning):
    """All options that the second computation knows; by which method it computes each column says itself."""

    method: Option[Any] = EngineWithWheel.method


class RequestedPage:
    """What was asked for."""

    def __init__(self, command: str, options: Mapping[str, object], key: str) -> None:
        self.command, self.key = command, key
        self.written = {name: _given(value) for name, value in options.items()}
        known = {one.name: one for one in KnownOptions.options().values() if one.name != "method"}
        self.options = {
            name: known[name].taken(value) if name in known else value for name, value in self.written.items()
        }
        values = Values({**dict.fromkeys(known), **self.options}, {})
        for part in KnownOptions.parts():
            if "settle" in vars(part):
                part.settle(values)
        self.asked = KnownOptions(values)
        self._kept: dict[object, verify.Bodies] = {}
        self._turns: dict[object, verify.Turn] = {}
        self._found: dict[object, object] = {}
        self._spots: dict[object, FoundAngle] = {}

    def unit(self) -> tuple[Fraction, Fraction | None]:
        """The bore, and the pressure that makes Q of its area, where both are known."""
        asked = self.asked
        if asked.says("card"):
            return asked.bore or Fraction(1), Fraction(self.card.admission)
        if asked.bore is None:
            return Fraction(1), None
        if asked.says("pump"):
            delivery, suction = asked.delivery_pressure, asked.suction_pressure or 0
            return asked.bore, delivery and delivery - suction
        return asked.bore, asked.pressure if asked.says("pressure") else asked.suction_pressure

    @cached_property
    def card(self) -> PistonCard:
        """The indicator card."""
        given = self.asked.card
        files = given if isinstance(given, Sequence) and not isinstance(given, str) else [given]
        if len(files) != 1:
            raise ProblemError("of several cards the row does not say which it is of")
        found = read_card(files[0])
        if isinstance(found, AngleCard):
            raise ProblemError("cards over the crank angle are not computed a second time")
        return found

    def measured(self, card: PistonCard | None = None) -> verify.Load:
        """The card, or one of a part of its points, as a load: kurbel's cubics, where they pass through the
        points, in the unit of the whole."""
        from kurbel.engine.card.force import curve

        asked, scale, courses = self.asked, self.card.admission, []
        for shares, pressures in (card or self.card).courses():
            heights = [one / scale for one in pressures]
            cubics = curve(shares, heights)
            if any(abs(cubics.pressure(one) - p) > THROUGH for one, p in zip(shares, heights, strict=True)):
                raise ProblemError("the curve of the card misses one of its points")
            begins, terms = cubics.knots[:-1].tolist(), cubics.powers[::-1].T.tolist()
            courses.append(
                [[*map(Fraction, (begin, *one))] for begin, one in zip(begins, terms, strict=True)]
            )
        other = asked.other_side and asked.other_side / Fraction(scale)
        own = {name: getattr(asked, name) for name in ("bore", "piston_rod", "tail_rod") if asked.says(name)}
        return of_given(verify.card, courses, other=other, **own)

    def push(self) -> Fraction | Force:
        """What pushes the piston towards the shaft where no engine does, in N."""
        asked = self.asked
        if not asked.says(*PRESSING):
            return as_signed_force(asked.raw("force") or 0, "force")
        bore, difference = asked.bore, asked.pressure_difference
        assert bore is not None
        tail, rod = (asked.tail_rod or 0, asked.piston_rod or 0) if difference is None else (0, 0)
        head, crank = (
            (asked.head_pressure or 0, asked.crank_pressure or 0) if difference is None else (difference, 0)
        )
        # π/4 stands once before all.
        force = (bore**2 - tail**2) * head - (bore**2 - rod**2) * crank
        return lambda _: disc(1) * force

    @property
    def gain(self) -> Fraction:
        """The crank's angular acceleration."""
        given = self.asked.raw("acceleration")
        return as_angular_acceleration(0 if given is None else given, "acceleration")

    def bodies(self, drive: verify.Drive, force: Fraction | Force, row: Row) -> verify.Bodies:
        # All functions are of the one load of the page.
        key = (drive, None if callable(force) else force, *(str(row.get(name)) for name in LOADED))
        if key not in self._kept:
            asked = self.asked
            known: dict[str, object] = {
                "reciprocating": asked.reciprocating, "rotating": asked.rotating,
                "inertia": asked.rocker_inertia, "friction": asked.friction, "gravity": asked.gravity,
                "slope": asked.slope, "acceleration": self.gain,
            }  # fmt: skip
            if asked.says("rod_mass", "rod_file"):
                known["rod"] = self.rod(drive.rod_length, "", row, True)
            if asked.pin_friction:
                pins = asked.crosshead_pin, asked.crank_pin, asked.shaft
                known["pins"] = tuple(one or Fraction(0) for one in pins)
                known["pin_friction"] = asked.pin_friction
            self._kept[key] = verify.bodies(drive, force=force, **known)
        return self._kept[key]

    def rod(self, length: Fraction | None, model: str, row: Row, weighed: bool = False) -> Moments:
        """What tells the mass, its own or 1, and the moments of the rod of a row, of so many metres; of two
        masses at its pins both are the same, and by the railways' rule 6/10 of it are at the crank pin."""
        asked = self.asked

        def given(name: str) -> object:
            values = each(asked.raw(name))
            return values[(int(row.get("rod", "1")) - 1) % len(values)]

        mass = as_mass(given("rod_mass"), "rod") if asked.says("rod_mass") else None
        centre, gyration = (_of_rod(given(one), length) for one in ("centre", "gyration"))
        file = asked.rod_file
        sections, in_kilograms = ((), False) if file is None else rod_sections(file, length)

        def described() -> tuple[Number, Number, Number]:
            """The mass, its centre and k², in lengths of the rod."""
            own, at, square = exactly(mass or 1), exactly(centre or 0), exactly(gyration or 0)
            if sections:
                whole, at, square = lying([(1 - one.end, 1 - one.start, one.mass) for one in sections])
                return whole if in_kilograms and mass is None else own, at, square
            if asked.says("pendulum"):
                swings = [(exactly(one.place), one.time) for one in asked.swings(length)]
                gravity = STANDARD_GRAVITY if asked.gravity is None else asked.gravity
                return own, *swung(swings, gravity / (length or 1), centre)
            if asked.says("rod_inertia"):
                about = asked.rod_inertia_about
                apart = at * 0 if about is None else at - place_on_rod(about, length, "point")
                return own, at, (asked.rod_inertia or 0) / (own * (length or 1) ** 2) - apart * apart
            return own, at, square * square

        def moments() -> list[Number]:
            whole, at, square = described()
            whole = whole if weighed else exactly(1)
            at = exactly("3/5") if model == "railway" else at
            return [whole, whole * at, whole * (at if model else at * at + square)]

        return moments

    @cached_property
    def _layout(self) -> Layout:
        """The layout, whose own values count where a row does not say them."""
        # A rim is of an engine whose own page is the flywheel's.
        return layout("flywheel" if self.key == "flywheel-sizing" else self.key)

    @property
    def arms(self) -> Sequence[str]:
        """Those of a beam that the layout has."""
        return self._layout.arms

    def drive(self, row: Row) -> verify.Drive:
        raw = self.asked.raw
        if self.key == "forces-slotted" or "slotted" in (self.asked.mechanism, self.key):
            return self._slotted()
        parallel = "parallel" in (self.asked.mechanism, raw("layout"))
        rodless = parallel or "yoke" in (self.asked.mechanism, self.key)
        printed = row.get("ratio", "1:∞" if rodless else "")
        described = DescribedDrive.of({name: raw(name) for name in ("stroke", "rod", "offset", "ratio")})
        cranks = described.cranks((printed,) if printed else self._layout.ratios)
        found = [one for one in cranks if printed in ("", ratio_text(one.ratio))]
        if len(found) != 1:
            raise ProblemError("the row does not say its crank ratio as it was asked for")
        crank, radius = found[0], found[0].radius
        speed = None if raw("speed") is None else as_speed(raw("speed"))
        place = str(raw("pivot")).split(";") if raw("pivot") else None
        return of_given(
            verify.drive,
            crank.ratio,
            crank.offset,
            radius=radius,
            speed=speed and speed.value,
            turns=speed and speed.turns,
            parallel=parallel,
            circuit=int(number(str(raw("circuit") or 1))),
            pivot=place and tuple(radii(one, "pivot", radius) for one in place),
            **{
                name: radii(length, name, radius)
                for name in ("beam", "rocker")
                # Of a list of beams the row has its arm.
                if (length := raw(name)) is not None and "arm" not in row
            },
        )

    def _slotted(self) -> verify.Drive:
        """The slotted lever by its lengths."""
        raw = self.asked.raw
        names = ("stroke", "rod", "speed", "offset", "rocker", "pivot", "circuit")
        (lever,) = mechanism("slotted").drives(DescribedDrive.of({name: raw(name) for name in names}), ())
        speed = lever.crank.speed
        return of_given(
            verify.SlottedLever,
            Fraction(0),
            pivot_below=lever.pivot,
            arm=lever.arm,
            ram_rod=lever.rod,
            height=lever.height,
            circuit=int(lever.circuit),
            radius=lever.crank.radius,
            speed=speed and speed.value,
            turns=speed and speed.turns,
        )

    def pushed(self, row: Row) -> verify.Drive:
        """The drive with the force that is given."""
        force, drive = self.asked.raw("force"), self.drive(row)
        return drive if force is None else replace(drive, force=as_signed_force(force, "force"))

    def with_friction(self, load: verify.Load) -> verify.Load:
        """A load less the friction of piston and crosshead, in Q."""
        friction, (bore, pressure) = self.asked.friction or Fraction(0), self.unit()
        if not pressure:
            raise ProblemError("friction needs what Q is in N")

        def less() -> tuple[Stroke, ...]:
            against = Fraction(-1), constant(friction / (disc(bore) * pressure))
            return tuple(Stroke((*one.sides, against)) for one in load())

        return less

    def of_row(self, row: Row, key: str, given: Sequence[Fraction] | None) -> Fraction:
        """What a row says of its load, or the one value that was asked for."""
        if key in row:
            return nearest(row[key], given or ())
        listed = as_expansions(self._layout.expansions) if given is None else given
        if len(listed) != 1:
            raise ProblemError(f"the row does not say its load; add {key} to the columns")
        return listed[0]

    def load(self, row: Row) -> verify.Load:
        asked, raw = self.asked, self.asked.raw

        def of(names: Sequence[str]) -> Mapping[str, object]:
            return {name: getattr(asked, name) for name in names if asked.says(name)}

        if asked.says("card"):
            return self.measured()
        if asked.says("pressure_ratio"):
            ratio = self.of_row(row, "pressure_ratio", asked.pressure_ratio)
            other = asked.other_side and asked.other_side / (asked.suction_pressure or 1)
            return of_given(verify.compressor, ratio, other=other, **of(AIR))
        if asked.says("pump"):
            return of_given(
                verify.pump,
                "single" if asked.single_acting else asked.pump or "double",
                suction=asked.suction_pressure,
                delivery=asked.delivery_pressure,
                small_area=asked.small_area,
            )
        if asked.says("compression"):
            peaks = {
                name: _in(given, name, asked.suction_pressure)
                for name in ("peak", "exhaust")
                if (given := raw(f"{name}_pressure")) is not None
            }
            compression = self.of_row(row, "compression", asked.compression)
            own = {**of(GAS), "cut_off": asked.cut_off_of(compression)}
            return of_given(verify.gas, compression, **peaks, **own)
        back = raw("back")
        if back is not None:
            back = as_share_or_pressure(back, "back pressure", raw("pressure"))
        # Of a bore that is found the mean pressure does not ask by how much rods lessen the area.
        sizes = () if raw("bore") is None else ("bore", "piston_rod", "tail_rod")
        own = {**of((*STEAM, *sizes)), "cushion": asked.cushioned(), "back": back}
        return of_given(verify.steam, self.of_row(row, "epsilon", asked.eps), **own)


def _of_rod(value: object, rod: Fraction | None) -> Fraction | None:
    return None if value is None else as_share_or_length(value, "share", rod, "the rod's is not")


def _in(value: object, name: str, suction: Fraction | None) -> Fraction:
    """Return a pressure in suction pressures."""
    if suction and isinstance(value, str) and any(map(str.isalpha, value)):
        return as_pressure(value, name) / suction
    return as_number(value, name)


def _given(value: object) -> object:
    """Return the value of an option as Python gives it."""
    if isinstance(value, Figure):
        return Fraction(value)
    return tuple(map(_given, value)) if isinstance(value, list) else value
