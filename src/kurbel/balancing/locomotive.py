"""What the cranks of a locomotive leave unbalanced, with masses in the wheels for a share of what goes to and
fro.

The masses in the wheels turn: they balance what turns with the cranks wholly, of what goes to and fro the
share c along the slides, and what they have for that presses the wheels on the rails and lifts them, the
hammer blow. Along the slides the rest, 1 - c, pulls at the train and turns the frame about its upright.
Forces of the first order, of an infinite rod. Standard theory, re-derived.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import NamedTuple

from kurbel.balancing.arrangement import listed_once
from kurbel.balancing.rotor import Mass, PlacedMass, force, moment, shares
from kurbel.balancing.rotor_page import number_of
from kurbel.balancing.vector import Vector, omega
from kurbel.drive.at import known
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, Number, figure
from kurbel.exact.real import PI, Real
from kurbel.motion.notes import turns_label
from kurbel.page.axes import ColumnAxis, ListAxis, Place, angle_text
from kurbel.page.quantity import Column, Formula, Need, Quantity, Texts, entry
from kurbel.page.subject import Question, Subject
from kurbel.page.table import Field
from kurbel.reading.amounts import amount
from kurbel.reading.notation import about, check_bounds
from kurbel.reading.units import Speed

MOST_CYLINDERS = 8
LARGEST = 10**9
_UNKNOWN = Mass(None, None, None, None)


class Crank(NamedTuple):
    """A crank: its angle in degrees, the place of its cylinder's centre line in m across the engine, and the
    masses in kg that go to and fro and that turn with it, at its radius."""

    angle: Fraction
    place: Fraction
    reciprocating: Fraction
    revolving: Fraction


@dataclass(frozen=True, slots=True)
class Locomotive:
    """The cranks on an axle, their radius and the distance of the planes of its wheels, in m.

    Of several coupled `axles` each has an equal part of what balances the reciprocating masses; the revolving
    ones are those of the axle with the cranks.
    """

    cranks: tuple[Crank, ...]
    radius: Fraction
    gauge: Fraction
    axles: int = 1

    def __post_init__(self) -> None:
        if not 1 <= len(self.cranks) <= MOST_CYLINDERS:
            raise ProblemError(f"{len(self.cranks)} cranks were given; an axle has 1 to {MOST_CYLINDERS}")
        for what, size in (("gauge", self.gauge), ("crank radius", self.radius)):
            if not 0 < size <= LARGEST:
                raise ProblemError(f"the {what} is {about(size)} m; it must be above 0")
        if not any(one.reciprocating for one in self.cranks):
            raise ProblemError("no mass goes to and fro; add that of a cylinder, --reciprocating 300kg")

    @property
    def planes(self) -> tuple[Fraction, Fraction]:
        return -self.gauge / 2, self.gauge / 2

    def _placed(self, masses: Iterable[Fraction]) -> list[PlacedMass]:
        return [
            PlacedMass(Vector.ray(one.angle, mass * self.radius), Real.of(one.place), _UNKNOWN)
            for one, mass in zip(self.cranks, masses, strict=True)
        ]

    def balance(self, share: Fraction) -> tuple[Vector, ...]:
        """Return the unbalances in kg m of the masses in the left and the right wheel."""
        masses = (one.revolving + share / self.axles * one.reciprocating for one in self.cranks)
        return tuple(one * Fraction(-1) for one in shares(self._placed(masses), self.planes))

    def blows(self, share: Fraction) -> tuple[Vector, ...]:
        """Return those of them that are for what goes to and fro; times ω² they are the hammer blows."""
        masses = (share / self.axles * one.reciprocating for one in self.cranks)
        return shares(self._placed(masses), self.planes)

    def blow(self, share: Fraction) -> Vector:
        """Return the greater one."""
        left, right = self.blows(share)
        return right if float(right.square()) > float(left.square()) else left

    def left(self, share: Fraction) -> list[PlacedMass]:
        """Return what pulls along the slides at φ = 0; it turns with the axle."""
        return self._placed((1 - share) * one.reciprocating for one in self.cranks)

    def pull(self, share: Fraction) -> Vector:
        """Return the sum of that, in kg m."""
        return force(self.left(share))

    def sway(self, share: Fraction) -> Vector:
        """Return its moment about the middle of the axle, in kg m²."""
        return moment(self.left(share), Fraction(0))


class Run(NamedTuple):
    """How it runs, as far as that is known: ω as a speed of the axle or by the train's in m/s, the diameter
    of the wheels in m, the load of a wheel and the greatest hammer blow allowed in N, and the radius of the
    balancing masses in m."""

    speed: Speed | None = None
    velocity: Fraction | None = None
    wheel: Fraction | None = None
    load: Fraction | None = None
    limit: Fraction | None = None
    radius: Fraction | None = None

    @property
    def omega(self) -> Real | None:
        """ω in 1/s, None where it is not known."""
        if self.speed is not None:
            return omega(self.speed)
        if self.velocity is None or self.wheel is None:
            return None
        return Real.of(2 * self.velocity / self.wheel)


ANGLE_DECIMALS = 2
# What quantities need to be known.
SPEED = Need(lambda question: question.run.omega is not None, ("--speed",))
WHEEL = Need(lambda question: question.run.wheel is not None, ("--wheel",))
RADIUS = Need(lambda question: question.run.radius is not None, ("--balance-radius",))
LOAD = Need(lambda question: question.run.load is not None, ("--wheel-load",))
LIMIT = Need(lambda question: not question.run.limit is question.run.load is None, ("--hammer-blow",))
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


Row = tuple[str, str, Label, str, Callable[[At], "Real | Vector | None"], *tuple[Need, ...]]


def _of_side(side: int, key: str, de: str) -> tuple[Row, ...]:
    def balance(at: At) -> Vector:
        return at.engine.balance(at.share)[side]

    return (
        (f"balance_{key}_kgm", f"Ausgleich {de}|Balance {key}", "$B b$", "kg m",
         lambda at: balance(at).length()),
        (f"mass_{key}_kg", f"Ausgleichmasse {de}|Balancing mass {key}", "$B$", "kg",
         lambda at: balance(at).length() / known(at.run.radius), RADIUS),
        (f"angle_{key}", f"Richtung {de}|Direction {key}", "", "°", balance),
    )  # fmt: skip


_ROWS: tuple[Row, ...] = (
    ("speed", "Drehzahl|Speed", "$n$", PER_MINUTE, lambda at: _minutes(at.omega), SPEED),
    ("velocity_kmh", "Fahrgeschwindigkeit|Speed of the train", "$v$", "km/h",
     lambda at: at.kilometres(at.omega), SPEED, WHEEL),
    *_of_side(0, "left", "links"),
    *_of_side(1, "right", "rechts"),
    ("blow_left_n", "Hammerschlag links|Hammer blow left", "", "N",
     lambda at: at.turning(at.engine.blows(at.share)[0]), SPEED),
    ("blow_right_n", "Hammerschlag rechts|Hammer blow right", "", "N",
     lambda at: at.turning(at.engine.blows(at.share)[1]), SPEED),
    ("load_least_n", "kleinster Raddruck|Least load of a wheel", "", "N",
     lambda at: known(at.run.load) - at.blow, SPEED, LOAD),
    ("load_greatest_n", "größter Raddruck|Greatest load of a wheel", "", "N",
     lambda at: known(at.run.load) + at.blow, SPEED, LOAD),
    ("lift_speed", "Drehzahl des Abhebens|Speed of lifting", "", PER_MINUTE,
     lambda at: _minutes(at.lifting()), LOAD),
    ("lift_velocity_kmh", "Fahrgeschwindigkeit des Abhebens|Speed of the train at lifting", "", "km/h",
     lambda at: at.kilometres(at.lifting()), LOAD, WHEEL),
    ("pull_n", "Zucken, größte Kraft ±|Variation of tractive force ±", "", "N",
     lambda at: at.turning(at.engine.pull(at.share)), SPEED),
    ("pull_phi", "größte Zugkraft bei φ|greatest at φ", "", "°",
     lambda at: _mirrored(at.engine.pull(at.share))),
    ("sway_nm", "Schlingermoment ±|Swaying couple ±", "", "N m",
     lambda at: at.turning(at.engine.sway(at.share)), SPEED),
    ("sway_phi", "größtes Moment bei φ|greatest couple at φ", "", "°",
     lambda at: _mirrored(at.engine.sway(at.share))),
    ("share_most", "größter Teil nach dem erlaubten Raddruck|Largest share by the allowed blow", "$c$", "",
     At.largest, SPEED, LIMIT),
)  # fmt: skip


@cache
def quantities() -> Mapping[str, Quantity]:
    """Return the rows by their keys."""
    return {
        key: entry(
            key, name, symbol, unit, ANGLE_DECIMALS if unit == "°" else None,
            {"exact": Formula(kernel)}, needs=tuple(needs),
        )
        for key, name, symbol, unit, kernel, *needs in _ROWS
    }  # fmt: skip


WORDS = Texts("balancing", "locomotive")


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class LocomotiveRequest(Question):
    """What is asked for: a locomotive that runs, with several shares of its masses balanced."""

    engine: Locomotive
    run: Run
    shares: tuple[Fraction, ...]

    no_column = "there is no column beside the axes; add one, such as blow_left_n"

    def check(self) -> None:
        for share in self.shares:
            check_bounds(
                "share of the balanced masses", share,
                "lie within 0..1, for it is a share of the reciprocating mass",
            )  # fmt: skip

    def entry(self, key: str) -> Quantity:
        one = super().entry(key)
        # The page's last column has the units.
        named = {lang: f"{name} {one.symbol}".rstrip() for lang, name in one.name.items()}
        return one._replace(spanners=(), heading=named)


def _number(question: LocomotiveRequest, column: Column, place: Place, times: int) -> Number | None:
    return number_of(question, column, At(question.engine, question.run, question.shares[place["share"]]))


def _share_axis(question: LocomotiveRequest) -> ListAxis:
    """The shares of the masses that go to and fro that are balanced."""
    return ListAxis(
        question.shares,
        Field("share", WORDS["share"][question.lang], "$c$"),
        figure,
        lambda share: f"$c = {figure(share)}$",
    )


def _notes(question: LocomotiveRequest) -> Iterator[Label]:
    lang, engine = question.lang, question.engine
    cranks = "; ".join(f"${angle_text(one.angle)}$" for one in engine.cranks)
    places = _listed([one.place for one in engine.cranks], "mm")
    yield (
        WORDS["cranks"][lang] + cranks + WORDS["places"][lang] + places + WORDS["wheels"][lang]
        + _listed(engine.planes, "mm") + f"; $R = {amount(engine.radius, 'mm')}$"
    )  # fmt: skip
    revolving = [one.revolving for one in engine.cranks]
    masses = WORDS["reciprocating"][lang] + listed_once([one.reciprocating for one in engine.cranks])
    yield masses + (WORDS["revolving"][lang] + listed_once(revolving) if any(revolving) else "")
    if run := "; ".join(_said_of_run(question.run, lang)):
        yield run
    if engine.axles > 1:
        yield WORDS["axles"][lang].format(axles=engine.axles)
    yield WORDS["order"][lang]
    yield WORDS["angles"][lang]


def _said_of_run(run: Run, lang: str) -> Iterator[Label]:
    if run.speed is not None:
        yield turns_label(run.speed)
    if run.velocity is not None:
        yield f"$v = {amount(run.velocity, 'km/h')}$"
    for key, value, unit in (
        ("wheel", run.wheel, "mm"),
        ("load", run.load, "N"),
        ("limit", run.limit, "N"),
        ("radius", run.radius, "mm"),
    ):
        if value is not None:
            yield f"{WORDS[key][lang]}${amount(value, unit)}$"


def _listed(values: list[Fraction] | tuple[Fraction, ...], unit: str) -> Label:
    return "; ".join(f"${amount(value, unit)}$" for value in values)


SUBJECT = Subject(
    key="locomotive",
    layout="locomotive",
    command="locomotive",
    axes={"share": _share_axis, "column": ColumnAxis},
    axis_keys=("share",),
    own_first=False,
    quantities=quantities,
    number=_number,
    notes=_notes,
)
