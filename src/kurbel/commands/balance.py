"""What engines leave unbalanced, and their firing orders."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import ClassVar

from kurbel.balancing.angles import AngleRequest
from kurbel.balancing.arrangement import CrankWithMasses, usual
from kurbel.balancing.balance_page import BalanceRequest, arranged
from kurbel.balancing.firing import FiringRequest, asked, read_order
from kurbel.balancing.greatest import ExtremesRequest
from kurbel.balancing.harmonics import MOST_ORDERS
from kurbel.commands.harmonics import HarmonicsOptions
from kurbel.commands.options import Choice, Count, Option, alone, amount, measure, word
from kurbel.commands.part import CommandOptions, Part, Rivals, Values, flag_of
from kurbel.commands.parts.angles import Angles, in_degrees
from kurbel.commands.parts.drive import Linked, MachineKeys, Speed, settle_cranks
from kurbel.commands.parts.masses import Masses, MovingRod
from kurbel.commands.parts.sheet import Layouts, PlainPrinting, Sheet, columns_option, layout_option
from kurbel.commands.subject import function
from kurbel.drive.at import known
from kurbel.drive.crank import Crank, DescribedDrive
from kurbel.errors import ProblemError
from kurbel.motion.mechanism import mechanism
from kurbel.page.layouts import Layout
from kurbel.page.subject import Question
from kurbel.reading.given import as_angles, as_crank_angles, as_length, as_number, as_places, as_share
from kurbel.reading.units import displacement, is_measure, mass

NEWTONS = ("stroke", "speed")
AT_ANGLES = "balance at angles"
EXTREMES = "balance extremes"
SUBJECTS = ("balance", AT_ANGLES, EXTREMES)


class CrankArrangement(Part):
    """An engine with several cranks."""

    topic = "cylinders"

    engine = word(
        "inline-1, inline-2-180, inline-2-360, inline-3 to inline-6, v2-90, v6-90, v8-90, v12-60,"
        " boxer-2, boxer-4; default: inline-4, with masses inline-1.",
        kind=Choice("engine", usual),
    )
    cranks: Option[Sequence[Fraction]] = Option(
        "Another engine: the crank of every cylinder, '0;180;180;0'.", "ANGLES", unit="degrees",
        read=alone(as_crank_angles), whole=True,
    )  # fmt: skip
    banks: Option[Sequence[Fraction]] = Option(
        "Directions of its cylinders, counted as the cranks: '-45;45'; default 0.", "ANGLES", unit="degrees",
        read=alone(as_crank_angles), whole=True,
    )  # fmt: skip

    @classmethod
    def settle(cls, values: Values) -> None:
        settle_cranks(values)


class FiringOptions(CrankArrangement, MachineKeys, Layouts, PlainPrinting, CommandOptions):
    """Print the firing orders that an engine's cranks allow; with --order the cranks that it needs.

    \b
    kurbel firing --engine inline-4  # all orders
    kurbel firing --engine inline-6 --order 1-5-3-6-2-4  # one order
    kurbel firing --cranks '0;180;180;0'  # by its cranks
    kurbel firing --engine v8-90
    kurbel firing --order 1-2 --banks '0;45' --intervals '405;315'
    \f
    >>> import kurbel
    >>> page = kurbel.firing(cranks="0;180;180;0", columns="firing_order")
    >>> print(kurbel.typeset(page, "csv"), end="")
    number,firing_order
    1,1-2-4-3
    2,1-3-4-2
    """

    topic = "question"

    unnamed = "engine"
    sequence = "cranks banks order intervals strokes columns"
    in_short = "engine cranks machine strokes order intervals columns"

    order = word("Firing order whose cranks are sought, or of these cranks: 1-3-4-2.", "ORDER", whole=True)
    intervals = measure(
        alone(as_crank_angles),
        "With --order: the angles from each firing to the next, '315;405'; default: equal ones.", "ANGLES",
        unit="degrees", whole=True,
    )  # fmt: skip
    strokes: Option[int] = Option(
        "Strokes of a cycle: 4 (default) or 2.",
        "N",
        Count("number of strokes", 2, 4),
        default=4,
        topic="cylinders",
    )
    columns = columns_option("firing-orders", "number,firing_order,longest")
    layout = layout_option("firing orders", "firing")

    def question(self) -> Question:
        order, strokes = self.order, self.strokes
        sought = () if order is None else read_order(order)
        page = self.page("firing" if order else "firing-orders", "firing orders", "firing")
        name, arrangement = asked(
            self.engine, self.cranks or (), self.banks or (), sought, strokes, self.intervals or ()
        )
        return FiringRequest(
            arrangement=arrangement,
            strokes=strokes,
            order=sought,
            engine=name,
            **self.on_page(page, "firing_order" if order is None else "crank,fires_at"),
        )


firing = function(FiringOptions, "firing")


class Revolving(Part):
    """Masses that turn with the cranks, and their counterweights."""

    topic = "counterweights"

    revolving = measure(
        mass.each,
        "Mass that turns with each crank at its radius: 1.5kg, or '1.5;2kg'; default: balanced apart.",
        "MASSES", unit="kg", what="revolving mass", whole=True, topic="masses",
    )  # fmt: skip
    revolving_share = measure(
        as_share, "Share of it that counterweights balance: 1, 50%; default 0.", "SHARE"
    )
    balance_radius = measure(as_length, "Radius of the counterweights, for their masses: 300mm.", "LENGTH")


class BalanceOptions(
    CrankArrangement, MachineKeys, MovingRod, Revolving, Speed, Layouts, Sheet, CommandOptions
):
    """Print the free forces and moments of an engine by orders.

    In units of m R ω²; with masses, --stroke and --speed in newtons, moments with --spacing or positions in
    millimetres in N m. With --angle at angles of the shaft, by orders and together; layout
    balance-greatest has the greatest over the turn.

    \b
    kurbel balance --engine inline-4  # an engine by its name
    kurbel balance --cranks '0;180;180;0' --spacing 100mm --reciprocating 1kg --speed 50/s \
--stroke 80mm  # in N
    kurbel balance --cranks '0;90' --ratio 1:5  # by its cranks
    kurbel balance --engine v2-90 --share 0.5 --orders 6
    kurbel balance --cranks '0;0;90;90' --positions '0;0;1;1' --banks '-45;45;-45;45'
    kurbel balance --reciprocating 2kg --stroke 90mm --speed 3000/min --spacing 100mm
    kurbel balance --engine inline-1 --machine engine.toml
    kurbel balance --engine v2-90 --angle '0;30' --method series
    kurbel balance --cranks '0;90' --positions '0;40cm' --reciprocating '3;2kg' --stroke 20cm --speed 9/s
    \f
    >>> import kurbel
    >>> page = kurbel.balance("inline-4", ratio="1:5", columns="residual,order,along,across")
    >>> print(kurbel.typeset(page, "csv"), end="")
    residual,order,along,across
    force,1,0,0
    force,2,0.8082,0
    moment,1,0,0
    moment,2,0,0
    """

    topic = "cylinders"

    unnamed = "engine"
    sequence = (
        "cranks positions about banks share angle ratio orders method reciprocating rod_mass centre gyration"
        " rod_file revolving revolving_share balance_radius stroke rod speed spacing columns"
    )
    in_short = (
        "engine cranks positions spacing orders ratio stroke speed machine reciprocating revolving columns"
    )
    rivals: ClassVar[Rivals] = (
        ("engine", "cranks"),
        *((name, "engine") for name in ("cranks", "positions", "banks")),
    )

    positions = measure(
        lambda value, what: positions_of(value),
        "Where its cylinders lie along the shaft: '0;1;2;3', which is the default, or '0;400;800mm'.",
        "NUMBERS", unit="a unit of your own", whole=True,
    )  # fmt: skip
    about = amount(
        "Position about which moments are taken: 1, 400mm; default: the middle.", "NUMBER",
        unit="that of the positions",
    )  # fmt: skip
    share: Option[Fraction] = Option(
        "Share of each reciprocating mass that counterweights balance: 0.5, 50%.", "SHARE", default="0",
        read=as_share, topic="counterweights",
    )  # fmt: skip
    ratio = HarmonicsOptions.ratio
    orders: Option[int] = Option(
        f"Orders up to N, 1 to {MOST_ORDERS}; odd ones above 1 are 0 and left out.", "N",
        Count("orders", 1, MOST_ORDERS, "does not say up to which one"), default=2, topic="question",
    )  # fmt: skip
    method = HarmonicsOptions.method
    angle = Angles.angle.but(
        help="Angles of the shaft at which forces are printed: 30, '0;30', 0..180:10, or what holds there:"
        " 's=10%'."
    )
    reciprocating = measure(
        mass.each,
        "Mass of piston and crosshead of a cylinder: 2kg; or of each: '2;2.5kg'. Masses need --stroke and"
        " --speed.",
        "MASSES", unit="kg", what="reciprocating mass", whole=True, topic="masses",
    )  # fmt: skip
    stroke, rod = Linked.stroke, Linked.rod
    speed = Speed.speed.but(help="Speed, for the masses: 120/min, 12.5rad/s.")
    spacing = measure(as_length, "Unit of the positions, for moments in N m: 100mm.", "LENGTH")
    columns = columns_option("balance", "order,along,forward")
    layout = layout_option(*SUBJECTS)

    @classmethod
    def settle(cls, values: Values) -> None:
        Linked.settle(values)

    def question(self) -> Question:
        angles = self.angle
        page = self.page("balance" if angles is None else "balance-angle", *SUBJECTS)
        if angles is not None and page.subject != AT_ANGLES:
            raise ProblemError(f"layout {page.key} is of the whole turn; leave --angle out")
        self._check_known()
        places, in_metres = self.positions or ((), False)
        weights = self._weighed(page, in_metres)
        about = self.about if self.says("positions") else None
        centre = None if about is None else position_of(about, in_metres)
        # Masses are those of one cylinder, and a machine that says no more has one.
        alone = weights is not None and not self.says("engine", "cranks")
        name, arrangement = arranged(
            "inline-1" if alone else self.engine,
            self.cranks or (),
            places,
            self.banks or (),
            self.share,
            centre,
        )
        request: Callable[..., Question] = BalanceRequest
        if page.subject == AT_ANGLES:
            given = as_angles(page.angles) if angles is None else angles
            request = partial(AngleRequest, angles=in_degrees(given, self.values, page.ratios))
        elif page.subject == EXTREMES:
            request = ExtremesRequest
        return request(
            about=centre,
            metres=in_metres,
            arrangement=arrangement if weights is None else weights.on(arrangement),
            ratios=tuple(one.ratio for one in self._straight(page)),
            engine=name,
            last_order=self.orders,
            method=self.method,
            weighed=weights,
            **self.on_page(page, "order,along"),
        )

    def _check_known(self) -> None:
        """Raise ProblemError for what is asked for by a ?, with the command that finds it."""
        for name in ("cranks", "positions", "reciprocating"):
            value = self.values.values[name]
            if isinstance(value, str | Sequence) and any("?" in str(one) for one in value):
                raise ProblemError(
                    f"--{name} has a ?, which kurbel rotor finds: in the first order masses that go to and"
                    " fro balance like masses at their cranks; give them there as --masses, --radii, --angles"
                    " and --planes, then here what was found"
                )

    def _straight(self, page: Layout) -> tuple[Crank, ...]:
        """Return the cranks by their ratios, as given or of stroke and rod, or by the layout's own."""
        lengths = (self.stroke, self.rod) if self.says("rod") and self.says("stroke") else ()
        return tuple(DescribedDrive(self.ratio, *lengths).cranks(page.ratios))

    def _is_heavy(self) -> bool:
        return self.as_part(Masses).is_heavy()

    def _weighed(self, page: Layout, in_metres: bool) -> CrankWithMasses | None:
        """Return what makes newtons, None where what is given does not say enough."""
        if not self._is_heavy() or not all(map(self.says, NEWTONS)):
            return None
        cranks = DescribedDrive(self.ratio, self.stroke, self.rod).cranks(page.ratios)
        masses = self.reciprocating or ()
        first = Masses(self.values.instead({"reciprocating": masses[0] if masses else None}))
        straight = mechanism("straight")
        crank = straight.crank(first.weighed(straight, cranks)[0])
        if in_metres and self.says("spacing"):
            raise ProblemError("the positions are lengths, and --spacing gives their unit; leave one out")
        unit = Fraction(1) if in_metres else self.spacing
        joined = known(crank.moving).joined
        weighed = CrankWithMasses(crank, unit)
        if len(masses) > 1:
            share = joined.crosshead - masses[0]
            weighed = replace(weighed, each=tuple(mass + share for mass in masses))
        if not self.says("reciprocating", "rod_mass"):
            return weighed
        if (turning := self.revolving) is not None:
            turning = tuple(mass + joined.pin for mass in turning)
            weighed = replace(weighed, revolving=turning, revolving_share=self.revolving_share or Fraction(0))
        if self.share or self.says("revolving_share"):
            weighed = replace(weighed, balance_radius=self.balance_radius)
        return weighed

    def unread(self, option: Option[object]) -> str:
        name, heavy = option.name, self._is_heavy()
        flag = flag_of(name)
        if name == "about":
            return "--about is a position; give these, --positions"
        if name in Revolving.options():
            if not self.says("reciprocating", "rod_mass"):
                return (
                    f"{flag} is for moving masses; add --reciprocating, or take kurbel rotor for masses that"
                    " only turn"
                )
            if name == "revolving_share" and not self.says("revolving"):
                return "--revolving-share is of --revolving; add that"
        if not heavy:
            if name == "rod":
                return "--rod gives the ratio with the length of the crank; add --stroke"
            return f"{flag} is for moving masses; add --reciprocating or a rod, --rod-mass"
        if missing := [flag_of(one) for one in NEWTONS if not self.says(one)]:
            return f"{flag} needs {' and '.join(missing)} to become a force"
        return (
            f"{flag} is that of counterweights, which balance a share of the masses; add --share 0.5 or"
            " --revolving-share 1"
        )


balance = function(BalanceOptions, "balance")


def positions_of(positions: object) -> tuple[tuple[Fraction, ...], bool]:
    """Return the positions, and whether they were given as lengths and are in metres."""
    several = positions if isinstance(positions, Iterable) else ()
    parts = positions.split(";") if isinstance(positions, str) else several
    if any(isinstance(part, str) and is_measure(part) for part in parts):
        return displacement.each(positions, "position"), True
    return tuple(as_places(positions, "position")), False


def position_of(about: object, in_metres: bool) -> Fraction:
    """Return one position in the unit of the others."""
    if in_metres:
        (position,) = displacement.each(about, "about")
        return position
    if positions_of(about)[1]:
        raise ProblemError(f"--about {about} is a length, and the positions are numbers; give both alike")
    return as_number(about, "about")
