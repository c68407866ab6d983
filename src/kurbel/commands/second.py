"""What was asked for, computed a second time: its drive, its load and its turn as `kurbel.verify` has them.

The request is read as kurbel reads it; which value a cell has, `recomputed` and `related` say.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from typing import Any, TypedDict

from kurbel import verify
from kurbel.commands.engine import EngineWithWheel
from kurbel.commands.motion import OverPath
from kurbel.commands.options import Option
from kurbel.commands.part import Values, flag_of
from kurbel.commands.parts.angles import in_degrees
from kurbel.commands.parts.drive import Turning
from kurbel.commands.parts.effort import PINNED, PRESSING, Effort, PinFriction
from kurbel.commands.recomputed import PAGES, Row, nearest
from kurbel.commands.related import MODULES, SUMMED
from kurbel.drive.crank import Described, radii
from kurbel.engine.card.card import AngleCard
from kurbel.engine.card.file import read_card
from kurbel.errors import KurbelError, ProblemError
from kurbel.motion.mechanism import mechanism
from kurbel.page.axes import shifted
from kurbel.page.layouts import Layout, layout
from kurbel.reading.amounts import UNITS
from kurbel.reading.given import (
    as_angular_acceleration,
    as_expansions,
    as_number,
    as_pressure,
    as_share_or_length,
    as_share_or_pressure,
    as_shares,
    as_signed_force,
    as_speed,
    found_at,
    of_given,
)
from kurbel.reading.notation import number, ratio_text
from kurbel.verify import UNDECIDED, WRONG, Value, enclose
from kurbel.verify.bodies import Force
from kurbel.verify.loads import Stroke, constant, disc
from kurbel.verify.turn import Running
from kurbel.verify.zeros import TOO_WIDE, Spot

# Unit of a key that is not one of the second computation, and that in which it computes.
OWN = {"length": "mm", "velocity": "mps", "acceleration": "mps2", "force": "n", "torque": "nm"}
# Of each load its options, which the second computation calls likewise.
AIR = ("exponent", "clearance", "single_acting", "suction_loss", "delivery_loss")
STEAM = (*AIR[:3], "release", "cushion", "lead")
GAS = ("cycle", "exponent", "expansion_exponent", "heat", "cut_off", "two_stroke")
# Options that the second computation knows, and those of looks, of which there is nothing to know.
KNOWN = frozenset((
    "ratio", "stroke", "rod", "offset", "mechanism", "rocker", "pivot",
    "circuit", "beam", "speed", "acceleration", "method", "order", "point", "shares", "at",
    "axles", "driven", "force", "friction", "bore", "piston_rod", "tail_rod", "reciprocating",
    "rod_mass", "centre", "gyration", "rotating", "rocker_inertia", "slope", "gravity",
    "eps", "card", "other_side", "back", "pressure", "pressure_ratio", "suction_pressure",
    "delivery_pressure", "small_area", "pump", "compression", "peak_pressure", "exhaust_pressure",
    "cranks", "cylinder",
    "detail", "exact", "where", "flywheel", "inertia", "power", "resistance", "orders", "quantity",
    "engine", "positions", "banks", "share", "spacing", "angle", "from", "to", "step", "zero",
    "columns", "digits", "rounding", "units", "layout", "decimal", "templates",
    *PRESSING, *PINNED, *STEAM, *AIR, *GAS,
))  # fmt: skip
# How near a point of a card its curve passes, in the greatest pressure.
THROUGH = 1e-12
# Columns that say which load a row is of.
LOADED = ("epsilon", "pressure_ratio", "pump", "compression")


class Figure(str):
    """A number of a file as it is written there."""


class Head(TypedDict):
    """A column of a page in JSON."""

    key: str
    unit: str
    method: str


class Asked(OverPath, EngineWithWheel, Effort, PinFriction, Turning):
    """All options that the second computation knows; by which method it computes each column says itself."""

    method: Option[Any] = EngineWithWheel.method


class Second:
    """What was asked for, computed a second time."""

    def __init__(self, command: str, options: Mapping[str, object], key: str) -> None:
        self.command, self.key = command, key
        self.written = {name: _given(value) for name, value in options.items()}
        known = {one.name: one for one in Asked.options().values() if one.name != "method"}
        self.options = {
            name: known[name].taken(value) if name in known else value for name, value in self.written.items()
        }
        values = Values({**dict.fromkeys(known), **self.options}, {})
        for part in Asked.parts():
            if "settle" in vars(part):
                part.settle(values)
        self.asked = Asked(values)
        self._kept: dict[Any, verify.Bodies] = {}
        self._turns: dict[Any, verify.Turn] = {}
        self._found: dict[Any, Any] = {}
        self._spots: dict[Any, Spot] = {}

    def verdict(self, key: str, column: Head, row: Row) -> tuple[str, str]:
        """Return whether a cell is confirmed, and else its right digits, or why it is not computed."""
        rounding = str(self.options.get("rounding", "half-away"))
        printed = row[key]
        try:
            value = self.value(key, column, row)
            found = value.confirms(printed, rounding)
            if found == WRONG and self.asked.says("card"):
                found = _to_tens(value, printed, rounding)
            if found != WRONG:
                return found, ""
            return WRONG, value.digits(len(printed.partition(".")[2]), rounding)
        except KurbelError as error:
            return UNDECIDED, str(error)
        except LookupError as error:
            return UNDECIDED, f"the page lacks {error}, which others of its command have"
        except TOO_WIDE as error:
            # Links that do not close, or numbers that no precision tells apart.
            return UNDECIDED, f"the second computation meets {error}"

    def value(self, key: str, column: Head, row: Row) -> Value:
        """Return the value of a cell. Raises KurbelError for what is not computed a second time."""
        if key.endswith("_error") and "card" in self.options:
            raise ProblemError("how far a card lets a number be off is an estimate, not a number to enclose")
        if (name := self.command) in SUMMED or (name := self.key) in SUMMED:
            stem, times = in_si(key.removesuffix(f"_{column['method']}"), column["unit"])
            plain = stem.removesuffix("_nm").removesuffix("_n")
            # A page in other units has other endings.
            if not any(one.key.startswith(plain) for one in self.question.page_columns):
                raise ProblemError(f"{key} is no column of such a page")
            return SUMMED[name](self, stem, column["method"], row) * times
        if self.command not in PAGES:
            raise ProblemError(f"pages of {self.command} are not computed a second time")
        for name in self.options.keys() - KNOWN:
            raise ProblemError(f"{flag_of(name)} is not known to the second computation")
        own, times = in_own_unit(key.removesuffix(f"_{column['method']}"), column["unit"])
        found = PAGES[self.command](self, own, column["method"], row)
        return found * times

    @property
    def function(self) -> Any:
        """The command for Python."""
        return found_at(f"kurbel.commands.{MODULES.get(self.command, self.command)}:{self.command}")

    @cached_property
    def question(self) -> Any:
        """What is asked for, as kurbel reads it."""
        return self.function.question(**self.written)

    def values(self) -> Values:
        """The options of the command as they are written."""
        command = self.function.command
        found = Values({**command.defaults, **self.written}, {})
        command.settle(found)
        return found

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
    def card(self) -> Any:
        """The indicator card."""
        given: Any = self.asked.card
        files = [given] if isinstance(given, str) else given
        if len(files) != 1:
            raise ProblemError("of several cards the row does not say which it is of")
        found = read_card(files[0])
        if isinstance(found, AngleCard):
            raise ProblemError("cards over the crank angle are not computed a second time")
        return found

    def measured(self) -> verify.Load:
        """The card as a load: kurbel's cubics, where they pass through the points of the file."""
        from kurbel.engine.card.force import curve

        asked, scale, courses = self.asked, self.card.admission, []
        for shares, pressures in self.card.courses():
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

    def bodies(self, drive: verify.Drive, force: Fraction | Force, row: Row) -> verify.Bodies:
        key = (drive, *(str(row.get(name)) for name in LOADED))
        if key not in self._kept:
            asked, rod = self.asked, drive.radius / drive.ratio if drive.ratio else None
            known: dict[str, Any] = {
                "reciprocating": asked.reciprocating, "rod_mass": asked.rod_mass, "rotating": asked.rotating,
                "inertia": asked.rocker_inertia, "friction": asked.friction, "gravity": asked.gravity,
                "centre": _of_rod(asked.raw("centre"), rod), "gyration": _of_rod(asked.raw("gyration"), rod),
                "slope": asked.slope,
            }  # fmt: skip
            if (gain := asked.raw("acceleration")) is not None:
                known["acceleration"] = as_angular_acceleration(gain, "acceleration")
            if asked.pin_friction:
                pins = asked.crosshead_pin, asked.crank_pin, asked.shaft
                known["pins"] = tuple(one or Fraction(0) for one in pins)
                known["pin_friction"] = asked.pin_friction
            self._kept[key] = verify.bodies(drive, force=force, **known)
        return self._kept[key]

    def spot(self, key: Any, find: Callable[[], Spot]) -> Spot:
        """A place, found once for all columns of a row."""
        if key not in self._spots:
            self._spots[key] = find()
        return self._spots[key]

    def once(self, row: Row, find: Callable[[], Any]) -> Any:
        """What is found of a row, once for all its columns with the working bits."""
        place = tuple(row.get(name) for name in (*LOADED, "ratio", "target")), enclose.Working.bits
        if place not in self._found:
            self._found[place] = find()
        return self._found[place]

    def rod(self, drive: verify.Drive, model: str, weighed: bool) -> verify.Bodies:
        """The rod alone, of a mass of 1 or its own; of two masses k² = a b, and by the railways' rule 6/10
        of it are at the crank pin."""
        key = (drive, model, weighed)
        if key not in self._kept:
            asked, long = self.asked, drive.radius / drive.ratio if drive.ratio else None
            centre = _of_rod(asked.raw("centre"), long) or Fraction(0)
            known: dict[str, Any] = {"gyration": _of_rod(asked.raw("gyration"), long)}
            if model:
                centre = Fraction(3, 5) if model == "railway" else centre
                known = {"gyration_square": centre * (1 - centre)}
            if weighed and (gain := asked.raw("acceleration")) is not None:
                known["acceleration"] = as_angular_acceleration(gain, "acceleration")
            mass = asked.rod_mass if weighed else Fraction(1)
            self._kept[key] = verify.bodies(drive, rod_mass=mass, centre=centre, **known)
        return self._kept[key]

    def running(self, turn: verify.Turn) -> Running:
        """The flywheel on a turn."""
        asked = self.asked
        if turn.bodies or asked.raw("resistance") not in (None, "constant"):
            raise ProblemError("speeds of moving masses, and others than a constant torque, are not computed")
        if asked.says("flywheel"):
            return Running(turn, as_number(asked.raw("flywheel"), "flywheel"))
        if not asked.says("power"):
            raise ProblemError("a flywheel without a power is not known to the second computation")
        return Running(turn, None, asked.inertia or Fraction(0), asked.power or Fraction(0))

    def degrees(self, row: Row) -> Fraction:
        """The crank angle of a row, as exactly as it was asked for."""
        if "phi" in row:
            return nearest(row["phi"], self._listed) + self.asked.zero_angle
        if self.command in ("delta", "deadcentres"):
            return Fraction(0)
        if len(self._listed) != 1:
            raise ProblemError("the row does not say its crank angle; add phi to the columns")
        return self._listed[0] + self.asked.zero_angle

    @cached_property
    def _layout(self) -> Layout:
        """The layout, whose own values count where a row does not say them."""
        # A rim is of an engine whose own page is the flywheel's.
        return layout("flywheel" if self.key == "flywheel-sizing" else self.key)

    @cached_property
    def shares(self) -> Sequence[Fraction]:
        """Those of a page over the stroke."""
        given = self.options.get("shares")
        return as_shares("0..1:0.1" if given is None else given, "share")

    @cached_property
    def _listed(self) -> Sequence[Fraction]:
        given, zero = self.asked.angle or (), self.asked.zero_angle
        return shifted(in_degrees(given, self.asked.values, self._layout.ratios, zero=zero), -zero)

    def drive(self, row: Row) -> verify.Drive:
        raw = self.asked.raw
        if self.key == "forces-slotted" or "slotted" in (self.asked.mechanism, self.key):
            return self._slotted()
        parallel = "parallel" in (self.asked.mechanism, raw("layout"))
        rodless = parallel or "yoke" in (self.asked.mechanism, self.key)
        printed = row.get("ratio", "1:∞" if rodless else "")
        described = Described.of({name: raw(name) for name in ("stroke", "rod", "offset", "ratio")})
        cranks = described.cranks((printed,) if printed else self._layout.ratios)
        found = [one for one in cranks if ratio_text(one.ratio) == printed] or cranks
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
        (lever,) = mechanism("slotted").drives(Described.of({name: raw(name) for name in names}), ())
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

    def turn(self, method: str, row: Row, alone: bool = False) -> verify.Turn:
        """The turn of the page, or that of one crank `alone`, without its masses."""
        asked, drive, load = self.asked, self.drive(row), self.load(row)
        key = (drive, method, alone, *(str(row.get(name)) for name in LOADED))
        if key not in self._turns:
            if asked.says("cylinder"):
                raise ProblemError("engines of unlike cylinders are not computed a second time")
            cranks = tuple(asked.cranks or (Fraction(0),))
            if asked.is_heavy() and method != "exact":
                raise ProblemError("moving masses by a series are not computed a second time")
            if asked.says("friction") and not alone:
                load = self.rubbed(load)
            if alone:
                self._turns[key] = verify.turn(drive, load, method=method)
            elif not asked.is_heavy():
                self._turns[key] = verify.turn(drive, load, cranks=cranks, method=method)
            else:
                bore, pressure = self.unit()
                self._turns[key] = verify.turn(
                    drive, load, cranks=cranks, method=method, bore=bore, pressure=pressure,
                    bodies=self.bodies(drive, Fraction(0), row),
                )  # fmt: skip
        return self._turns[key]

    def rubbed(self, load: verify.Load) -> verify.Load:
        """A load less the friction of piston and crosshead, in Q."""
        friction, (bore, pressure) = self.asked.friction, self.unit()
        if not pressure:
            raise ProblemError("friction needs what Q is in N")

        def less() -> tuple[Stroke, ...]:
            against = Fraction(-1), constant(friction / (disc(bore) * pressure))
            return tuple(Stroke((*one.sides, against)) for one in load())

        return less

    def load(self, row: Row) -> verify.Load:
        asked, raw = self.asked, self.asked.raw

        def of(names: Sequence[str]) -> Mapping[str, object]:
            return {name: getattr(asked, name) for name in names if asked.says(name)}

        def of_row(key: str, given: Sequence[Fraction] | None) -> Fraction:
            if key in row:
                return nearest(row[key], given or ())
            listed = as_expansions(self._layout.expansions) if given is None else given
            if len(listed) != 1:
                raise ProblemError(f"the row does not say its load; add {key} to the columns")
            return listed[0]

        if asked.says("card"):
            return self.measured()
        if asked.says("pressure_ratio"):
            ratio = of_row("pressure_ratio", asked.pressure_ratio)
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
            return of_given(verify.gas, of_row("compression", asked.compression), **peaks, **of(GAS))
        back = raw("back")
        if back is not None:
            back = as_share_or_pressure(back, "back pressure", raw("pressure"))
        own = of((*STEAM, "bore", "piston_rod", "tail_rod"))
        return of_given(verify.steam, of_row("epsilon", asked.eps), back=back, **own)


def in_own_unit(key: str, symbol: str) -> tuple[str, Fraction]:
    """Return a key in the unit of the second computation, and how many of the printed one that is."""
    unit = UNITS.get(symbol)
    if unit is None or unit.ending == (own := OWN.get(unit.dimension, "")):
        return key, Fraction(1)
    if not own:
        return key.removesuffix(f"_{unit.ending}"), 1 / unit.size
    size = next(one.size for one in UNITS.values() if one.ending == own)
    return f"{key.removesuffix(unit.ending)}{own}", size / unit.size


def in_si(key: str, symbol: str) -> tuple[str, Fraction]:
    """Return a key without its unit, and how many of the printed unit one of the SI is, of turns a second."""
    unit = UNITS.get(symbol)
    if unit is None:
        return key, Fraction(60 if symbol.startswith("min") else 1)
    kept = {"force": "_n", "torque": "_nm"}.get(unit.dimension, "")
    stem = key.removesuffix(f"_{unit.ending}")
    return stem if stem == key else f"{stem}{kept}", 1 / unit.size


def _to_tens(value: Value, printed: str, rounding: str) -> str:
    """Whether a number without decimals is the value rounded to tens or hundreds."""
    zeros = len(printed) - len(printed.rstrip("0")) if "." not in printed else 0
    tried = ((value * Fraction(1, 10**k)).confirms(printed[:-k], rounding) for k in range(1, zeros + 1))
    return next((one for one in tried if one != WRONG), WRONG)


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
