"""What was asked for, computed a second time.

What it is `requested` says; which value a cell has, `recomputed` and `related`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from pathlib import Path
from typing import Any, TypedDict

from kurbel import verify
from kurbel.commands.card_errors import error_of
from kurbel.commands.conditioned import angle_at, of_condition, of_unknown
from kurbel.commands.part import Values, flag_of
from kurbel.commands.parts.angles import in_degrees
from kurbel.commands.parts.effort import PINNED, PRESSING
from kurbel.commands.parts.masses import SWUNG, WEIGHED
from kurbel.commands.recomputed import PAGES, Row, nearest
from kurbel.commands.related import MODULES, SUMMED
from kurbel.commands.requested import AIR, GAS, LOADED, STEAM, RequestedPage
from kurbel.engine.card.card import PistonCard
from kurbel.errors import KurbelError, ProblemError
from kurbel.exact.kind import FoundAngle as SolvedAngle
from kurbel.page.axes import shifted
from kurbel.reading.amounts import UNITS
from kurbel.reading.given import as_number, as_shares, found_at
from kurbel.reading.notation import number
from kurbel.verify import CONFIRMED, UNDECIDED, WRONG, Number, Value, enclose
from kurbel.verify.drives import Degrees, place_of
from kurbel.verify.loads import disc
from kurbel.verify.turn import Running
from kurbel.verify.zeros import TOO_WIDE, FoundAngle

# Unit of a key that is not one of the second computation, and that in which it computes.
OWN = {"length": "mm", "velocity": "mps", "acceleration": "mps2", "force": "n", "torque": "nm"}
COMPUTED = {**PAGES, "solve": of_condition}
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
    "unknown", "columns", "digits", "rounding", "units", "layout", "decimal", "templates",
    "rod_file", "rod_acceleration", *SWUNG, *WEIGHED, *PRESSING, *PINNED, *STEAM, *AIR, *GAS,
))  # fmt: skip


class Head(TypedDict):
    """A column of a page in JSON."""

    key: str
    unit: str
    method: str


class SecondComputation(RequestedPage):
    """What was asked for, computed a second time."""

    @cached_property
    def _cards(self) -> dict[str, SecondComputation]:
        return {}

    def verdict(self, key: str, column: Head, row: Row) -> tuple[str, str]:
        """Return whether a cell is confirmed, and else its right digits, or why it is not computed."""
        error = key.endswith("_error") and self.asked.says("card")
        rounding = "up" if error else str(self.options.get("rounding", "half-away"))
        printed = row[key]
        try:
            value = self.value(key, column, row)
            found = value.confirms(printed, rounding)
            if found == WRONG and self.asked.says("card"):
                found = _to_tens(value, printed, rounding)
            if found != WRONG:
                return found, "" if found == CONFIRMED else "the second computation cannot tell its digits"
            return WRONG, value.digits(len(printed.partition(".")[2]), rounding)
        except KurbelError as error:
            return UNDECIDED, str(error)
        except KeyError as error:
            return UNDECIDED, f"the page lacks {error}, which others of its command have"
        except IndexError:
            return UNDECIDED, "the row is of nothing that was asked for"
        except TOO_WIDE as error:
            # Links that do not close, or numbers that no precision tells apart.
            return UNDECIDED, f"the second computation meets {error}"

    def value(self, key: str, column: Head, row: Row) -> Value:
        """Return the value of a cell. Raises KurbelError for what is not computed a second time."""
        cards = self.written.get("card")
        if isinstance(cards, tuple) and len(cards) > 1 and "card" in row:
            return self.with_card(cards, row["card"]).value(key, column, row)
        if (name := self.command) in SUMMED or (name := self.key) in SUMMED:
            stem, times = in_si(key.removesuffix(f"_{column['method']}"), column["unit"])
            plain = stem.removesuffix("_nm").removesuffix("_n")
            # A page in other units has other endings.
            if not any(one.key.startswith(plain) for one in self.question.page_columns):
                raise ProblemError(f"{key} is no column of such a page")
            return SUMMED[name](self, stem, column["method"], row) * times
        if self.command not in COMPUTED:
            raise ProblemError(f"pages of {self.command} are not computed a second time")
        for name in self.options.keys() - KNOWN:
            raise ProblemError(f"{flag_of(name)} is not known to the second computation")
        own, times = in_own_unit(key.removesuffix(f"_{column['method']}"), column["unit"])
        whole = self.instead({}) if "unknown" in self.options else self
        if own == "phi" and "share" not in row and whole.asked.angle is not None:
            return whole.angle(row) * times
        if whole is not self:
            _, times = in_si(key, column["unit"])
            return of_unknown(self, key, number(row[key]) / times, row) * times
        if own.endswith("_error") and "card" in self.options:
            return error_of(self, own.removesuffix("_error"), column["method"], row) * times
        found = COMPUTED[self.command](self, own, column["method"], row)
        return found * times

    @property
    def function(self) -> Any:
        """The command for Python."""
        return found_at(f"kurbel.commands.{MODULES.get(self.command, self.command)}:{self.command}")

    @cached_property
    def question(self) -> Any:
        """What is asked for, as kurbel reads it."""
        return self.function.question(**{"layout": self.key, **self.written})

    def values(self) -> Values:
        """The options of the command as they are written."""
        command = self.function.command
        found = Values({**command.defaults, **self.written}, {})
        command.settle(found)
        return found

    def instead(self, options: Mapping[str, object]) -> SecondComputation:
        """The same with other options, of forces and motion at an angle in the place of a condition."""
        apart = ("unknown", "where", "units")
        kept = {name: value for name, value in self.written.items() if name not in apart}
        return SecondComputation("forces", {**kept, **options}, "forces")

    def with_card(self, cards: Sequence[object], name: str) -> SecondComputation:
        """The same of one of several cards."""
        if name not in self._cards:
            named = [one for one in cards if Path(str(one)).name == name]
            self._cards[name] = SecondComputation(self.command, {**self.written, "card": named}, self.key)
        return self._cards[name]

    def spot(self, key: object, find: Callable[[], FoundAngle]) -> FoundAngle:
        """A place, found once for all columns of a row."""
        if key not in self._spots:
            self._spots[key] = find()
        return self._spots[key]

    def once(self, row: Row, find: Callable[[], object], *own: object) -> Any:
        """What is found of a row, once for all its columns with the working bits."""
        place = (
            *own,
            *(row.get(name) for name in (*LOADED, "ratio", "target", "rod")),
            enclose.WorkingPrecision.bits,
        )
        if place not in self._found:
            self._found[place] = find()
        return self._found[place]

    def torque(self, turn: verify.Turn) -> Number:
        """What Q R is in N m."""
        bore, pressure = self.unit()
        if pressure is None:
            raise ProblemError("torque and power need what Q is in N")
        return disc(bore) * (pressure * turn.drive.radius)

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

    def place(self, row: Row) -> Degrees:
        """The crank angle of a row; where a condition gives it, what finds it."""
        return self.placed(self.degrees(row), row)

    def angle(self, row: Row) -> Value:
        """That of a row among others that conditions give."""
        at, zero = self.place(row), self.asked.zero_angle
        if not callable(at) and Fraction(at) - zero not in (self.asked.angle or ()):
            raise ProblemError("an angle that a condition gives exactly is not computed a second time")
        return Value(lambda: place_of(at).angle - zero)

    def placed(self, degrees: Fraction, row: Row) -> Degrees:
        if not isinstance(degrees, SolvedAngle):
            return degrees
        condition = degrees.held.asked.conditions[0]
        return self.spot((condition, degrees), lambda: angle_at(self, condition, Fraction(degrees), row))

    def degrees(self, row: Row) -> Fraction:
        """The crank angle of a row, as exactly as it was asked for."""
        if "phi" in row:
            return nearest(row["phi"], self.listed) + self.asked.zero_angle
        if self.command in ("delta", "deadcentres"):
            return Fraction(0)
        if len(self.listed) != 1:
            raise ProblemError("the row does not say its crank angle; add phi to the columns")
        return self.listed[0] + self.asked.zero_angle

    @cached_property
    def shares(self) -> Sequence[Fraction]:
        """Those of a page over the stroke."""
        given = self.options.get("shares")
        return as_shares("0..1:0.1" if given is None else given, "share")

    @cached_property
    def listed(self) -> Sequence[Fraction]:
        asked, zero = self.asked, self.asked.zero_angle
        turn = Fraction(720 if asked.says("compression") and not asked.two_stroke else 360)
        found = in_degrees(asked.angle or (), asked.values, self._layout.ratios, turn, zero)
        return shifted(found, -zero)

    def turn(self, method: str, row: Row, alone: bool = False, card: PistonCard | None = None) -> verify.Turn:
        """The turn of the page, that of one crank `alone`, without its masses, or that of part of a card."""
        asked, drive, load = self.asked, self.drive(row), self.measured(card) if card else self.load(row)
        key = (drive, method, alone, card, *(str(row.get(name)) for name in LOADED))
        if key not in self._turns:
            if asked.says("cylinder"):
                raise ProblemError("engines of unlike cylinders are not computed a second time")
            cranks = tuple(asked.cranks or (Fraction(0),))
            if asked.says("friction") and not alone:
                load = self.with_friction(load)
            if alone:
                self._turns[key] = verify.turn(drive, load, method=method)
            elif not asked.is_heavy():
                self._turns[key] = verify.turn(drive, load, cranks=cranks, method=method)
            else:
                bore, pressure = self.unit()
                self._turns[key] = verify.turn(
                    drive, load, cranks=cranks, method=method, bore=bore, pressure=pressure,
                    bodies=replace(self.bodies(drive, Fraction(0), row), method=method, friction=Fraction(0)),
                )  # fmt: skip
        return self._turns[key]


def in_own_unit(key: str, symbol: str) -> tuple[str, Fraction]:
    """Return a key in the unit of the second computation, and how many of the printed one that is."""
    unit = UNITS.get(symbol)
    if unit is None or unit.ending == (own := OWN.get(unit.dimension, "")):
        return key, Fraction(1)
    if not own:
        stem = key.removesuffix(f"_{unit.ending}")
        return f"{stem}_pa" if unit.dimension == "pressure" and stem != key else stem, 1 / unit.size
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
