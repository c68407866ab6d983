"""What a locomotive's page can show: each a value with the scale that makes its unit, or a direction."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import cache
from typing import Any, NamedTuple

from kurbel.balance.locomotives.locomotive import Locomotive, Run, lifting
from kurbel.balance.vector import ONE, Scale, Value, Vector
from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Label
from kurbel.page.quantity import Formula, Quantity, entry

ANGLE_DECIMALS = 2
# What a quantity needs to be known, with the options that say so.
SPEED, WHEEL, RADIUS, LOAD, TRAIN, LIFT, LIMIT = "speed", "wheel", "radius", "load", "train", "lift", "limit"
NEEDS: Mapping[str, tuple[str, ...]] = {
    SPEED: ("--speed",),
    WHEEL: ("--wheel",),
    RADIUS: ("--balance-radius",),
    LOAD: ("--speed", "--wheel-load"),
    TRAIN: ("--speed", "--wheel"),
    LIFT: ("--wheel-load", "--wheel"),
    "lift alone": ("--wheel-load",),
    LIMIT: ("--speed", "--hammer-blow"),
}
KILOMETRES_AN_HOUR = Fraction(36, 10)


class Known(NamedTuple):
    """A rational number or what is known on every kind of number, times a scale."""

    value: Fraction | Value
    scale: Scale = ONE


class At(NamedTuple):
    """A locomotive that runs, and the share of its masses that is balanced."""

    engine: Locomotive
    run: Run
    share: Fraction

    @property
    def square(self) -> Scale:
        found = self.run.omega(2)
        assert found is not None
        return found


# A number, a direction, or None where there is no such.
Found = Known | Vector | None
Kernel = Callable[[At], Found]


def _length(vector: Vector, scale: Scale = ONE) -> Known:
    return Known(Fraction(0), scale) if vector.vanishes() else Known(vector.length(), scale)


def _balance(side: int) -> Kernel:
    return lambda at: _length(at.engine.balance(at.share)[side])


def _mass(side: int) -> Kernel:
    def kernel(at: At) -> Known:
        assert at.run.radius is not None
        return _length(at.engine.balance(at.share)[side], Scale(1 / at.run.radius))

    return kernel


def _blow(side: int) -> Kernel:
    return lambda at: _length(at.engine.blows(at.share)[side], at.square)


def _load(sign: int) -> Kernel:
    """The greatest and the least load of the wheel with the greater blow, in N; below 0 it would lift."""

    def kernel(at: At) -> Known:
        own, blow, scale = at.run.load, at.engine.blow(at.share), at.square
        assert own is not None
        if blow.vanishes():
            return Known(own)
        length = blow.length()

        def value(kind: Kind) -> Any:
            return kind.of(own) + sign * scale.on(kind) * length(kind)

        return Known(value, Scale(turns=0, factor=_one if scale.turns else None))

    return kernel


def _one(kind: Kind) -> Any:
    """1, of a product that is not algebraic."""
    return kind.of(Fraction(1))


def _lift(of: Callable[[Run], Scale]) -> Kernel:
    def kernel(at: At) -> Known | None:
        blow = at.engine.blow(at.share)
        assert at.run.load is not None
        return None if blow.vanishes() else Known(lifting(blow, at.run.load), of(at.run))

    return kernel


def _kilometres(run: Run) -> Scale:
    assert run.wheel is not None
    return Scale(run.wheel / 2 * KILOMETRES_AN_HOUR)


def _speed(at: At) -> Known:
    omega = at.run.omega()
    assert omega is not None
    return Known(Fraction(1), Scale(omega.value * 30, omega.turns - 1))


def _velocity(at: At) -> Known:
    omega = at.run.omega()
    assert omega is not None
    return Known(Fraction(1), omega.times(_kilometres(at.run).value))


def _share_most(at: At) -> Known | None:
    """The share at which the greater hammer blow is the allowed one, or the load of the wheel; at most 1."""
    whole = at.engine.blow(Fraction(1))
    allowed = at.run.limit if at.run.limit is not None else at.run.load
    assert allowed is not None
    if whole.vanishes():
        return None
    length, scale = whole.length(), at.square

    def value(kind: Kind) -> Any:
        return kind.of(allowed) / (length(kind) * scale.on(kind))

    return Known(value, Scale(turns=0, factor=_one if scale.turns else None))


def _mirrored(vector: Vector) -> Vector:
    return Vector(vector.star.mirrored())


_ROWS: tuple[tuple[str, str, Label, str, Kernel, str], ...] = (
    ("speed", "Drehzahl|Speed", "$n$", '$"min"^(-1)$', _speed, SPEED),
    ("velocity_kmh", "Fahrgeschwindigkeit|Speed of the train", "$v$", "km/h", _velocity, TRAIN),
    ("balance_left_kgm", "Ausgleich links|Balance left", "$B b$", "kg m", _balance(0), ""),
    ("mass_left_kg", "Ausgleichmasse links|Balancing mass left", "$B$", "kg", _mass(0), RADIUS),
    ("angle_left", "Richtung links|Direction left", "", "°", lambda at: at.engine.balance(at.share)[0], ""),
    ("balance_right_kgm", "Ausgleich rechts|Balance right", "$B b$", "kg m", _balance(1), ""),
    ("mass_right_kg", "Ausgleichmasse rechts|Balancing mass right", "$B$", "kg", _mass(1), RADIUS),
    (
        "angle_right", "Richtung rechts|Direction right", "", "°",
        lambda at: at.engine.balance(at.share)[1], "",
    ),
    ("blow_left_n", "Hammerschlag links|Hammer blow left", "", "N", _blow(0), SPEED),
    ("blow_right_n", "Hammerschlag rechts|Hammer blow right", "", "N", _blow(1), SPEED),
    ("load_least_n", "kleinster Raddruck|Least load of a wheel", "", "N", _load(-1), LOAD),
    ("load_greatest_n", "größter Raddruck|Greatest load of a wheel", "", "N", _load(1), LOAD),
    (
        "lift_speed", "Drehzahl des Abhebens|Speed of lifting", "", '$"min"^(-1)$',
        _lift(lambda run: Scale(Fraction(30), -1)), "lift alone",
    ),
    (
        "lift_velocity_kmh", "Fahrgeschwindigkeit des Abhebens|Speed of the train at lifting", "", "km/h",
        _lift(_kilometres), LIFT,
    ),
    (
        "pull_n", "Zucken, größte Kraft ±|Variation of tractive force ±", "", "N",
        lambda at: _length(at.engine.pull(at.share), at.square), SPEED,
    ),
    ("pull_phi", "größte Zugkraft bei φ|greatest at φ", "", "°",
     lambda at: _mirrored(at.engine.pull(at.share)), ""),
    (
        "sway_nm", "Schlingermoment ±|Swaying couple ±", "", "N m",
        lambda at: _length(at.engine.sway(at.share), at.square), SPEED,
    ),
    ("sway_phi", "größtes Moment bei φ|greatest couple at φ", "", "°",
     lambda at: _mirrored(at.engine.sway(at.share)), ""),
    (
        "share_most", "größter Teil nach dem erlaubten Raddruck|Largest share by the allowed blow", "$c$", "",
        _share_most, LIMIT,
    ),
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
