"""What a locomotive's page can show: a value each, or a direction."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import cache
from typing import NamedTuple

from kurbel.balancing.locomotives.locomotive import Locomotive, Run
from kurbel.balancing.vector import Vector
from kurbel.drive.at import known
from kurbel.exact.numerals import Label
from kurbel.exact.real import PI, Real
from kurbel.page.quantity import Formula, Quantity, entry

ANGLE_DECIMALS = 2
# What a quantity needs to be known, with the options that say so.
NEEDS: Mapping[str, tuple[str, ...]] = {
    "speed": ("--speed",),
    "wheel": ("--wheel",),
    "radius": ("--balance-radius",),
    "load": ("--speed", "--wheel-load"),
    "train": ("--speed", "--wheel"),
    "lift": ("--wheel-load", "--wheel"),
    "lift alone": ("--wheel-load",),
    "limit": ("--speed", "--hammer-blow"),
}
PER_MINUTE = '$"min"^(-1)$'


class At(NamedTuple):
    """A locomotive that runs, and the share of its masses that is balanced."""

    engine: Locomotive
    run: Run
    share: Fraction

    @property
    def omega(self) -> Real:
        return known(self.run.omega)

    def turning(self, vector: Vector) -> Real:
        """Return the force of an unbalance, ω² times it."""
        return vector.length() * self.omega * self.omega

    @property
    def blow(self) -> Real:
        """The greater hammer blow."""
        return self.turning(self.engine.blow(self.share))

    def lifting(self) -> Real | None:
        """Return ω at which the hammer blow is the load of the wheel."""
        blow = self.engine.blow(self.share)
        return None if blow.vanishes() else (known(self.run.load) / blow.length()).root()

    def kilometres(self, omega: Real | None) -> Real | None:
        """Return the speed of the train in km/h."""
        return omega and omega * (known(self.run.wheel) / 2 * Fraction(36, 10))

    def largest(self) -> Real | None:
        """Return the share at which the greater blow is the allowed one, or the load of the wheel."""
        whole = self.engine.blow(Fraction(1))
        allowed = self.run.limit if self.run.limit is not None else known(self.run.load)
        return None if whole.vanishes() else allowed / self.turning(whole)


def _minutes(omega: Real | None) -> Real | None:
    return omega and omega * 30 / PI


def _mirrored(vector: Vector) -> Vector:
    return Vector(vector.star.mirrored())


Row = tuple[str, str, Label, str, Callable[[At], "Real | Vector | None"], str]


def _of_side(side: int, key: str, de: str) -> tuple[Row, ...]:
    def balance(at: At) -> Vector:
        return at.engine.balance(at.share)[side]

    return (
        (f"balance_{key}_kgm", f"Ausgleich {de}|Balance {key}", "$B b$", "kg m",
         lambda at: balance(at).length(), ""),
        (f"mass_{key}_kg", f"Ausgleichmasse {de}|Balancing mass {key}", "$B$", "kg",
         lambda at: balance(at).length() / known(at.run.radius), "radius"),
        (f"angle_{key}", f"Richtung {de}|Direction {key}", "", "°", balance, ""),
    )  # fmt: skip


_ROWS: tuple[Row, ...] = (
    ("speed", "Drehzahl|Speed", "$n$", PER_MINUTE, lambda at: _minutes(at.omega), "speed"),
    ("velocity_kmh", "Fahrgeschwindigkeit|Speed of the train", "$v$", "km/h",
     lambda at: at.kilometres(at.omega), "train"),
    *_of_side(0, "left", "links"),
    *_of_side(1, "right", "rechts"),
    ("blow_left_n", "Hammerschlag links|Hammer blow left", "", "N",
     lambda at: at.turning(at.engine.blows(at.share)[0]), "speed"),
    ("blow_right_n", "Hammerschlag rechts|Hammer blow right", "", "N",
     lambda at: at.turning(at.engine.blows(at.share)[1]), "speed"),
    ("load_least_n", "kleinster Raddruck|Least load of a wheel", "", "N",
     lambda at: known(at.run.load) - at.blow, "load"),
    ("load_greatest_n", "größter Raddruck|Greatest load of a wheel", "", "N",
     lambda at: known(at.run.load) + at.blow, "load"),
    ("lift_speed", "Drehzahl des Abhebens|Speed of lifting", "", PER_MINUTE,
     lambda at: _minutes(at.lifting()), "lift alone"),
    ("lift_velocity_kmh", "Fahrgeschwindigkeit des Abhebens|Speed of the train at lifting", "", "km/h",
     lambda at: at.kilometres(at.lifting()), "lift"),
    ("pull_n", "Zucken, größte Kraft ±|Variation of tractive force ±", "", "N",
     lambda at: at.turning(at.engine.pull(at.share)), "speed"),
    ("pull_phi", "größte Zugkraft bei φ|greatest at φ", "", "°",
     lambda at: _mirrored(at.engine.pull(at.share)), ""),
    ("sway_nm", "Schlingermoment ±|Swaying couple ±", "", "N m",
     lambda at: at.turning(at.engine.sway(at.share)), "speed"),
    ("sway_phi", "größtes Moment bei φ|greatest couple at φ", "", "°",
     lambda at: _mirrored(at.engine.sway(at.share)), ""),
    ("share_most", "größter Teil nach dem erlaubten Raddruck|Largest share by the allowed blow", "$c$", "",
     At.largest, "limit"),
)  # fmt: skip


@cache
def quantities() -> Mapping[str, Quantity]:
    """Return the rows by their keys."""
    return {
        key: entry(
            key, name, symbol, unit, ANGLE_DECIMALS if unit == "°" else None,
            {"exact": Formula(kernel)}, needs=needs,
        )
        for key, name, symbol, unit, kernel, needs in _ROWS
    }  # fmt: skip
