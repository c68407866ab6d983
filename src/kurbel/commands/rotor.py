"""Rotating masses and locomotives: what they leave unbalanced, and what balances them."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TypeAlias

from kurbel.balancing.locomotive import Crank, Locomotive, LocomotiveRequest, Run
from kurbel.balancing.rotor import Mass, Places, Rotor
from kurbel.balancing.rotor_page import RotorRequest
from kurbel.commands.options import Count, Option, alone, measure
from kurbel.commands.part import CommandOptions, Values, flag_of
from kurbel.commands.parts.drive import Linked, MachineKeys, Speed, settle_cranks, settle_sizes
from kurbel.commands.parts.sheet import Layouts, Sheet, columns_option, layout_option
from kurbel.commands.subject import function
from kurbel.errors import NotationError, ProblemError
from kurbel.page.subject import Question
from kurbel.reading.given import as_crank_angles, as_force, as_length, as_ratios, as_shares, as_velocity
from kurbel.reading.units import as_angles_or_unknown, displacement, length, mass

# One of each mass, None for what is asked for.
Sought: TypeAlias = Sequence[Fraction | None]
MOST_PLANES = 2


def _planes(given: object, what: str) -> tuple[Fraction, ...]:
    planes = displacement.each(given, "plane")
    if len(planes) > MOST_PLANES:
        raise ProblemError(f"{len(planes)} planes of {what} were given; two are enough")
    return planes


def _bearings(given: object, what: str) -> tuple[Fraction, ...]:
    held = _planes(given, what)
    if len(held) == 1:
        raise ProblemError("one bearing was given; the forces are shared by two, --bearings '0;1.8m'")
    return held


def _place(given: object, what: str) -> Fraction:
    lengths = displacement.each(given, what)
    if len(lengths) != 1:
        raise NotationError(f"{what} is a list of {len(lengths)}; give one length")
    return lengths[0]


def _ratio(given: object) -> Fraction:
    ratios = as_ratios(given)
    if len(ratios) != 1:
        raise ProblemError(f"{len(ratios)} crank ratios were given; the pistons of one shaft have one")
    return ratios[0]


class RotorOptions(MachineKeys, Speed, Layouts, Sheet, CommandOptions):
    """Print what rotating masses leave unbalanced, and what balances them.

    Balancing masses in one plane balance the forces, in two the couples too. What is asked for is a ?: a mass
    with its angle or two angles for static balance, two masses with their angles or one and two angles for
    complete balance, and two planes in place of a mass with its angle.

    \b
    kurbel rotor --masses '2kg;3kg' --radii '100mm;80mm' --angles '0;120' --planes '0;200mm' \
--balance-planes '50mm;150mm' --balance-radii 100mm  # what balances two masses
    kurbel rotor --masses '200;300;400kg' --radii '80;70;60mm' --angles '0;45;115'
    kurbel rotor --masses '?;9;5;4kg' --radii 10cm --angles '?;0;?;?' --planes '0;0.6;1.2;1.8m'
    kurbel rotor --masses 3kg --radii 2cm --angles 0 --planes 20cm --bearings '0;1m' --speed 900/min
    \f
    >>> import kurbel
    >>> page = kurbel.rotor([3, 4], radii=0.1, angles=[0, 90], columns="line,unbalance_kgm,angle")
    >>> print(kurbel.typeset(page, "csv"), end="")
    line,unbalance_kgm,angle
    mass_1,0.3,0
    mass_2,0.4,90
    unbalance,0.50000,53.13
    """

    topic = "masses"

    unnamed = "masses"
    sequence = "masses radii angles planes balance_planes balance_radii bearings speed about ratio"
    in_short = "masses radii angles planes bearings speed machine balance_planes balance_radii columns digits"

    masses: Option[Sought] = Option(
        "The masses: '200kg;300kg', or '200;300kg'; a ? for one that is asked for.", "MASSES", unit="kg",
        required=True, read=mass.each_or_unknown, what="mass",
        whole=True,
    )  # fmt: skip
    radii = measure(
        length.each,
        "Radii of their centres of mass: '200;150mm', or one for all.", "LENGTHS", unit="m", what="radius",
        whole=True,
    )  # fmt: skip
    angles: Option[Sought] = Option(
        "Their directions, in the sense of rotation: '0;45;120'; a ? for what is asked.", "ANGLES",
        unit="degrees", required=True, read=alone(as_angles_or_unknown), whole=True,
    )  # fmt: skip
    planes: Option[Sought | None] = Option(
        "Their planes along the shaft: '0;400;800mm'; a ? for what is asked.", "LENGTHS", unit="m",
        read=displacement.each_or_unknown, what="plane",
        whole=True,
    )  # fmt: skip
    balance_planes: Option[tuple[Fraction, ...]] = Option(
        "Planes of balancing masses, one or two: '100;1100mm'.", "LENGTHS", unit="m", read=_planes,
        what="balancing masses", whole=True, topic="counterweights",
    )  # fmt: skip
    balance_radii = measure(
        length.each,
        "Radii of the balancing masses: 100mm; without them m r is printed.", "LENGTHS", unit="m", whole=True,
        topic="counterweights",
    )  # fmt: skip
    bearings: Option[tuple[Fraction, ...]] = Option(
        "Places of the two bearings along the shaft: '0;1.8m'.",
        "LENGTHS",
        unit="m",
        read=_bearings,
        whole=True,
    )
    speed = Speed.speed.but(help="Speed, for forces in N: 300/min, 12.5rad/s.", topic="masses")
    about = measure(
        _place,
        "Plane about which moments are taken: 400mm; default: where planes count from.", "LENGTH", unit="m",
    )  # fmt: skip
    ratio = Linked.ratio.read_as(
        alone(_ratio),
        help="Crank ratio where the masses go to and fro, with pistons in one line, 1:4: what they leave of"
        " the second order.",
        topic="masses",
    )
    columns = columns_option("rotor", "line,unbalance_kgm,angle")
    layout = layout_option("rotor")

    def question(self) -> Question:
        page, masses = self.page("rotor", "rotor"), self._masses()
        along = self.says("planes")
        about = self.about if along else None
        # That of a machine's file does not say that these masses go to and fro.
        ratio = self.ratio if self.values.typed("ratio") else None
        return RotorRequest(
            rotor=Rotor(masses, about or Fraction(0), ratio),
            places=self._places(),
            speed=self.speed,
            planar=not along,
            **self.on_page(page, "line,unbalance_kgm,angle"),
        )

    def _masses(self) -> tuple[Mass, ...]:
        masses, directions = self.masses, self.angles
        count = len(masses)
        radii, planes = self.radii, self.planes
        lengths: Sought = (None,) * count if radii is None else _for_all(radii, count)
        places: Sought = (Fraction(0),) * count if planes is None else planes
        for what, values in (("radii", lengths), ("angles", directions), ("planes", places)):
            if len(values) != count:
                raise ProblemError(
                    f"the number of {what} is {len(values)} and that of masses {count}; every mass needs one"
                    " of each"
                )
        return tuple(map(Mass, masses, lengths, directions, places))

    def _places(self) -> Places:
        """Return where what balances and what holds the shaft lies; in one plane nothing does."""
        if not self.says("planes"):
            return Places((), (), ())
        planes = self.balance_planes or ()
        radii: Sought = (None,) * len(planes)
        if planes and (lengths := self.balance_radii) is not None:
            radii = _for_all(lengths, len(planes))
        if len(radii) != len(planes):
            raise ProblemError(
                f"the number of balance radii is {len(radii)} and that of balance planes {len(planes)}; give"
                " one of each, or one radius for all"
            )
        return Places(planes, tuple(radii), self.bearings or ())

    def unread(self, option: Option[object]) -> str:
        if option.name == "balance_radii":
            return (
                "--balance-radii is of the masses in --balance-planes; add these, such as --balance-planes"
                " '100;1100mm' beside --planes, or in one plane ask for a mass with its angle by a ? and give"
                " its radius among --radii"
            )
        return f"{flag_of(option.name)} needs the planes of the masses; add --planes"


rotor = function(RotorOptions, "rotor")


def _for_all(values: Sequence[Fraction], count: int) -> Sequence[Fraction]:
    """Return one value as that of all."""
    return (values[0],) * count if len(values) == 1 else values


class LocomotiveOptions(MachineKeys, Speed, Layouts, Sheet, CommandOptions):
    """Print balancing masses in the wheels, hammer blow, swaying couple and variation of tractive force.

    By the share of the reciprocating masses that is balanced; with --wheel-load the speed at which wheels
    lift, and the largest share.

    \b
    kurbel locomotive --spacing 0.7m --gauge 1.5m --stroke 60cm --reciprocating 300kg \
--speed 300/min  # by shares
    kurbel locomotive --spacing 2m --gauge 1.5m --stroke crank:30cm --reciprocating 240kg \
--share 2/3  # for one share
    \f
    >>> import kurbel
    >>> page = kurbel.locomotive(
    ...     spacing=0.6, gauge=1.5, stroke=0.6, reciprocating=300, speed=5, share="2/3",
    ...     columns="pull_n,sway_nm",
    ... )
    >>> print(kurbel.typeset(page, "csv"), end="")
    pull_n,sway_nm
    41873,12562
    """

    topic = "axle"

    sequence = (
        "cranks spacing positions gauge stroke reciprocating revolving share axles balance_radius speed"
        " velocity wheel wheel_load hammer_blow"
    )
    in_short = (
        "reciprocating share gauge spacing cranks stroke revolving speed machine wheel_load wheel columns"
    )

    cranks: Option[Sequence[Fraction]] = Option(
        "Angles of the cranks: '0;90', or '0;120;240'.", "ANGLES", unit="degrees", default="0;90",
        read=alone(as_crank_angles), whole=True,
    )  # fmt: skip
    spacing = measure(as_length, "Distance of the centre lines of neighbouring cylinders: 0.7m.", "LENGTH")
    positions = measure(
        displacement.each,
        "Their places from the middle in place of that: '-0.4;0.4m'.", "LENGTHS", unit="m", what="position",
        whole=True,
    )  # fmt: skip
    gauge: Option[Fraction] = Option(
        "Distance of the planes of the wheels: 1.5m.", "LENGTH", unit="m", required=True, read=as_length
    )
    stroke = Linked.stroke.read_as(as_length, topic="axle")
    reciprocating: Option[tuple[Fraction, ...]] = Option(
        "Mass that goes to and fro in a cylinder: 300kg, or each.", "MASSES", unit="kg", required=True,
        read=mass.each, what="reciprocating mass", whole=True, topic="masses",
    )  # fmt: skip
    revolving = measure(
        mass.each, "Mass that turns with a crank at its radius: 160kg, or each.", "MASSES", unit="kg",
        what="revolving mass", whole=True, topic="masses",
    )  # fmt: skip
    axles: Option[int] = Option(
        "Coupled axles that balance equal parts of the share, 1 to 12.", "N", Count("axles", 1, 12), default=1
    )
    share: Option[Sequence[Fraction]] = Option(
        "Shares of the reciprocating masses that are balanced: 2/3, '0.5;0.6'.", "SHARES",
        default="0;1/2;2/3;1", read=as_shares, whole=True, topic="counterweights",
    )  # fmt: skip
    balance_radius = measure(
        as_length, "Radius of the balancing masses: 600mm.", "LENGTH", topic="counterweights"
    )
    speed = Speed.speed.but(help="Speed of the axle: 300/min, 31rad/s.", topic="axle")
    velocity = measure(as_velocity, "Speed of the train in its place, with --wheel: 96km/h.", "SPEED")
    wheel = measure(as_length, "Diameter of the wheels: 1.8m.", "LENGTH")
    wheel_load = measure(as_force, "Load of a wheel at rest: 30kN.", "FORCE")
    hammer_blow = measure(as_force, "Hammer blow that is allowed: 40kN; default: the load.", "FORCE")
    columns = columns_option("locomotive", "share,blow_left_n,sway_nm")
    layout = layout_option("locomotive")

    @classmethod
    def settle(cls, values: Values) -> None:
        settle_sizes(values)
        settle_cranks(values)

    def question(self) -> Question:
        speed, wheel = self.speed, self.wheel
        velocity = self.velocity if speed is None else None
        if velocity is not None and wheel is None:
            raise ProblemError(
                "--velocity needs the diameter of the wheels to turn the axle; add --wheel 1.8m"
            )
        page, cranks, stroke = self.page("locomotive", "locomotive"), self._cranks(), self.stroke
        if stroke is None:
            raise ProblemError(
                "the masses turn at the radius of the crank; add --stroke 600mm or --stroke crank:300mm"
            )
        return LocomotiveRequest(
            engine=Locomotive(cranks, stroke / 2, self.gauge, self.axles),
            run=Run(
                speed=speed,
                velocity=velocity,
                wheel=wheel,
                load=self.wheel_load,
                limit=self.hammer_blow,
                radius=self.balance_radius,
            ),
            shares=tuple(self.share),
            **self.on_page(page, "share,blow_left_n"),
        )

    def _cranks(self) -> tuple[Crank, ...]:
        angles, places = self.cranks, self.positions
        count = len(angles)
        if places is None:
            distance = self.spacing
            if distance is None:
                raise ProblemError(
                    "couples need the places of the cylinders; add their distance, --spacing 0.7m, or"
                    " --positions"
                )
            places = tuple(distance * Fraction(2 * number - count + 1, 2) for number in range(count))
        moved, turned = (
            masses * count if len(masses) == 1 else masses
            for masses in (self.reciprocating, self.revolving or (Fraction(0),))
        )
        for what, values in (
            ("positions", places),
            ("reciprocating masses", moved),
            ("revolving masses", turned),
        ):
            if len(values) != count:
                raise ProblemError(
                    f"the number of {what} is {len(values)} and that of cranks {count}; give one of each"
                )
        return tuple(map(Crank, angles, places, moved, turned))

    def unread(self, option: Option[object]) -> str:
        if option.name == "spacing":
            return "--positions has the places of the cylinders; leave --spacing out"
        return "--speed is that of the axle and --velocity that of the train; leave one out"


locomotive = function(LocomotiveOptions, "locomotive")
