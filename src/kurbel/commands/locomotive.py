"""Locomotives: what their wheels and their frames bear of what goes to and fro."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from kurbel.commands.options import Count, Option, alone, measure
from kurbel.commands.part import CommandOptions, Values
from kurbel.commands.parts.drive import Linked, Speed
from kurbel.commands.parts.sheet import Layouts, Sheet, columns_option, layout_option
from kurbel.commands.subject import function
from kurbel.errors import ProblemError
from kurbel.page.subject import Question
from kurbel.reading.given import as_crank_angles, as_force, as_length, as_shares, as_speed, as_velocity
from kurbel.reading.measures import as_masses, as_measures

if TYPE_CHECKING:
    from kurbel.balancing.locomotives.locomotive import Crank


class LocomotiveOptions(Speed, Layouts, Sheet, CommandOptions):
    """Print balancing masses in the wheels, hammer blow, swaying couple and variation of tractive force.

    By the share of the reciprocating masses that is balanced; with --wheel-load the speed at which wheels
    lift, and the largest share.

    \b
    kurbel locomotive --spacing 0.7m --gauge 1.5m --stroke 60cm --reciprocating 300kg --speed 300/min
    kurbel locomotive --spacing 2m --gauge 1.5m --crank 30cm --reciprocating 240kg --share 2/3
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

    sequence = (
        "cranks spacing positions gauge stroke crank reciprocating revolving share axles balance_radius speed"
        " velocity wheel wheel_load hammer_blow"
    )

    cranks: Option[Sequence[Fraction]] = Option(
        "Angles of the cranks: '0;90', or '0;120;240'.", "ANGLES", unit="degrees", default="0;90",
        read=alone(as_crank_angles), whole=True,
    )  # fmt: skip
    spacing = measure(
        as_length, "Distance of the centre lines of neighbouring cylinders: 0.7m.", "LENGTH", unit="m"
    )
    positions = measure(
        lambda given, what: as_measures(given, "displacement", what),
        "Their places from the middle in place of that: '-0.4;0.4m'.", "LENGTHS", unit="m", what="position",
        whole=True,
    )  # fmt: skip
    gauge: Option[Fraction] = Option(
        "Distance of the planes of the wheels: 1.5m.", "LENGTH", unit="m", required=True, read=as_length
    )
    stroke = Linked.stroke.but(read=as_length)
    crank = Linked.crank
    reciprocating: Option[tuple[Fraction, ...]] = Option(
        "Mass that goes to and fro in a cylinder: 300kg, or each.", "MASSES", unit="kg", required=True,
        read=as_masses, what="reciprocating mass", whole=True,
    )  # fmt: skip
    revolving = measure(
        as_masses, "Mass that turns with a crank at its radius: 160kg, or each.", "MASSES", unit="kg",
        what="revolving mass", whole=True,
    )  # fmt: skip
    axles: Option[int] = Option(
        "Coupled axles that balance equal parts of the share, 1 to 12.", "N", Count("axles", 1, 12), default=1
    )
    share: Option[Sequence[Fraction]] = Option(
        "Shares of the reciprocating masses that are balanced: 2/3, '0.5;0.6'.", "SHARES",
        default="0;1/2;2/3;1", read=as_shares, whole=True,
    )  # fmt: skip
    balance_radius = measure(as_length, "Radius of the balancing masses: 600mm.", "LENGTH", unit="m")
    speed = Speed.speed.but(help="Speed of the axle: 300/min, 31rad/s.", read=alone(as_speed))
    velocity = measure(
        as_velocity, "Speed of the train in its place, with --wheel: 96km/h.", "SPEED", unit="m/s"
    )
    wheel = measure(as_length, "Diameter of the wheels: 1.8m.", "LENGTH", unit="m")
    wheel_load = measure(as_force, "Load of a wheel at rest: 30kN.", "FORCE", unit="N")
    hammer_blow = measure(
        as_force, "Hammer blow that is allowed: 40kN; default: the load.", "FORCE", unit="N"
    )
    columns = columns_option("locomotive", "share,blow_left_n,sway_nm")
    layout = layout_option("locomotive")

    @classmethod
    def settle(cls, values: Values) -> None:
        from kurbel.commands.parts.drive import settle_sizes

        settle_sizes(values)

    def question(self) -> Question:
        from kurbel.balancing.locomotives.locomotive import Locomotive, Run
        from kurbel.balancing.locomotives.page import LocomotiveRequest

        speed, wheel = self.speed, self.wheel
        velocity = self.velocity if speed is None else None
        if velocity is not None and wheel is None:
            raise ProblemError(
                "--velocity needs the diameter of the wheels to turn the axle; add --wheel 1.8m"
            )
        page, cranks, stroke = self.page("locomotive", "locomotive"), self._cranks(), self.stroke
        if stroke is None:
            raise ProblemError(
                "the masses turn at the radius of the crank; add --stroke 600mm or --crank 300mm"
            )
        return LocomotiveRequest(
            layout=page,
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
            columns=self.names("share,blow_left_n"),
            **self.printed(),
        )

    def _cranks(self) -> tuple[Crank, ...]:
        from kurbel.balancing.locomotives.locomotive import Crank

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

    def unread(self, option: Option[Any]) -> str:
        if option.name == "spacing":
            return "--positions has the places of the cylinders; leave --spacing out"
        return "--speed is that of the axle and --velocity that of the train; leave one out"


locomotive = function(LocomotiveOptions, "locomotive")
