"""The crank drive: which one it is, its lengths, how it turns."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from typing import Any, ClassVar

from kurbel.commands.options import Choice, Option, alone, amount, file, measure, word
from kurbel.commands.part import Origin, Part, Values
from kurbel.commands.parts.angles import OVER_PATH
from kurbel.commands.parts.sheet import Layouts
from kurbel.drive import mechanisms as registered
from kurbel.drive.crank import DescribedDrive, Diameters
from kurbel.drive.mechanisms import MECHANISMS, MOTIONS
from kurbel.drive.moved import Drive
from kurbel.errors import ProblemError
from kurbel.motion.evaluation import REACH, series_of
from kurbel.motion.mechanism import Mechanism, mechanism, of_other_mechanisms
from kurbel.page.layouts import layout_of
from kurbel.reading.given import Exact, as_crank_angles, as_length, as_numbers, as_ratios, as_speed
from kurbel.reading.notation import plain, ratio_text

# Of pages of approximations, and of pages about points of the rod.
APPROXIMATE, POINTS = ("series errors", "successive"), "rod points"
# The highest order of a series.
HIGHEST = max(REACH.values())
# Two of these give the third.
LENGTHS = ("ratio", "stroke", "rod")


class MachineKeys(Part):
    """What a machine's file may say."""

    machine = file(
        "Machine in a TOML file: its crank, load, masses, flywheel; what is given beside it outdoes it.",
        last=True,
    )  # fmt: skip


class Linked(MachineKeys):
    """A crank drive."""

    topic = "crank"
    section = "crank"

    # Where no mechanism is named, a layout about one of these names it if it is of one alone.
    abouts: ClassVar[Sequence[str]] = (*MOTIONS, OVER_PATH, POINTS, *APPROXIMATE)

    ratio: Option[Sequence[Exact] | Exact | None] = Option(
        "Crank ratio: 1:5, 1:4,5, 0.2; lists '1:4;1:5' and ranges 1:3..6:0.5; 1:∞ is the infinite rod.",
        "R:L", short="-r", many=True,
    )  # fmt: skip
    offset = amount(
        "Offset crank: e as a share of R, or as a length with --stroke. Of a slotted lever that of the ram's"
        " line from the shaft, away from the pivot.",
        "E", unit="R",
    )  # fmt: skip
    stroke = amount(
        "2R: 600mm; or R, crank:300mm. Of an offset crank, whose piston goes further, also by its way,"
        " true:600mm, from which R follows with --rod or --ratio.",
        "LENGTH", unit="m",
    )  # fmt: skip
    time_ratio = amount(
        "With --stroke true:600mm and --offset as a length: time of the outstroke over that of the return,"
        " from which R and L follow: 1.2.",
        "Q",
    )  # fmt: skip
    rod = amount("Rod length L, which with --stroke gives the ratio: 1500mm.", "LENGTH", unit="m")
    mechanism = word(registered.described(), kind=Choice("mechanism", MECHANISMS), topic="linkage")
    rocker = amount(
        "Arc crank: length of the rocker in units of R, or a length with --stroke. Of a slotted lever that of"
        " its arm, to the rod of the ram; default: as long as the block needs.",
        "B",
        unit="R",
        topic="linkage",
    )
    pivot = amount(
        "Arc crank: the rocker's pivot along and across the slide, in units of R or as lengths; default:"
        " as far as the rod is long, and B above the slide line. With 'D;0' angles count from the line of"
        " centres, as of a four-bar. Of a slotted lever how far it is from the shaft, square to the slide.",
        "D;H", unit="R", whole=True, topic="linkage",
    )  # fmt: skip
    circuit = amount(
        "Arc crank: 1 or -1, the two ways to assemble the links; default 1. Of a four-bar with its pivot at"
        " 'D;0' the open one is -1. Of a slotted lever -1 has the ram behind it on the outstroke.",
        "WAY", topic="linkage",
    )  # fmt: skip

    @classmethod
    def settle(cls, values: Values) -> None:
        settle_sizes(values)
        _settle_lengths(values)

    def shared(self) -> Collection[str]:
        """Return what is of other drives on their pages of motion, and here says something of all."""
        return ()

    def compares_lengths(self) -> bool:
        """Whether a length of the drive is given as one, which is compared with the crank."""
        compared = (self.values.values.get(name) for name in ("offset", "rocker", "pivot", "beam"))
        return any(isinstance(one, str) and any(map(str.isalpha, one)) for one in compared)

    def drive(self, layout: str | None = None) -> Mechanism:
        """Return which crank drive is described: where it is not said, by the layout, else by the offset."""
        name = self.mechanism
        if not name and layout is not None:
            about = layout_of(layout, self.abouts, self.as_part(Layouts).layouts).subject
            fitting = [known for known, one in MECHANISMS.items() if one.subject == about]
            name = fitting[0] if len(fitting) == 1 else None
        return mechanism(name or ("offset" if self.says("offset") else "straight"))

    def described(
        self, layout: str | None = None, beside: Collection[str] = (), leaving: Collection[str] = ()
    ) -> tuple[Mechanism, DescribedDrive]:
        """Return which crank drive is described, and how: what describes it on its pages of motion, and what
        stands `beside` that, but for what is `leaving` it. Raises ProblemError if that is not enough."""
        chosen = self.drive(layout)
        taken = {*chosen.takes, *beside}.difference(leaving)
        # The inertia of a rocker is one of the masses.
        known = self.values.values.keys() & taken - {"rocker_inertia"}
        names = [name for name in DescribedDrive._fields if name in known]
        typed = [name for name in self.values.values if self.values.typed(name) and self.says(name)]
        foreign = of_other_mechanisms(chosen, [one for one in typed if one not in taken], self.shared())
        for sentence in foreign.values():
            raise ProblemError(sentence)
        described = DescribedDrive.of({name: self.raw(name) for name in names})
        chosen.check(described)
        return chosen, described

    def unread(self, option: Option[object]) -> str:
        found = of_other_mechanisms(self.drive(), [option.name], self.shared())
        return found.get(option.name, "")


class AnyDrive(Linked):
    """A crank drive of any kind, the beam engine among them."""

    beam = amount(
        "Beam engine: arm of the beam in units of R, or a length.",
        "A",
        unit="R",
        machine="crank",
        topic="linkage",
    )


class Speed(Part):
    """How fast the crank turns."""

    topic = "crank"

    speed = measure(
        alone(as_speed),
        "Speed, for columns in m/s and m/s²: 120/min, 12.5rad/s.",
        "SPEED",
        unit="turns a second",
        machine="crank",
    )


class PinSizes(Part):
    """The diameters of the pins, by which they rub."""

    title, add = "rubbing velocities of pins", "--columns phi,crank_pin_rubbing_mps"
    topic = "crank"

    crosshead_pin = measure(
        as_length, "Diameter of the crosshead pin, for its rubbing velocity: 80mm.", "LENGTH", unit="m"
    )
    crank_pin = measure(as_length, "The same of the crank pin: 120mm.", "LENGTH", unit="m")
    shaft = measure(as_length, "The same of the shaft: 140mm.", "LENGTH", unit="m")


def with_pins(options: Any, chosen: Mechanism, drives: Sequence[Drive]) -> Sequence[Drive]:
    """Return drives with the diameters of their pins among options. Raises ProblemError for other drives."""
    if not options.says(*Diameters._fields):
        return drives
    if not chosen.crosshead:
        raise ProblemError(
            f"rubbing velocities of {chosen.title} are not computed; leave the diameters of its pins out"
        )
    pins = Diameters(options.crosshead_pin, options.crank_pin, options.shaft)
    return [drive.of(replace(chosen.crank(drive), diameters=pins)) for drive in drives]


class Method(Part):
    """By which formulas the motion is computed."""

    topic = "crank"

    method = word(
        "exact (default), series (first order, as Blau prints) or infinite (rod of infinite length).",
        kind=Choice("method", "kurbel.motion.evaluation:METHODS"),
    )


class Turning(Speed, Method):
    """How the crank turns, and by which formulas its motion is computed."""

    acceleration = amount(
        "Angular acceleration of the crank at these angles, at its --speed: 50rad/s², -20rad/s².", "ALPHA",
        unit="rad/s²",
    )  # fmt: skip


OF_MASSES = Turning.method.but(
    help="Of moving masses: exact (default), series (accelerated to first order, the rod at its true"
    " angle) or infinite (rod of infinite length)."
)


class Series(Method):
    """The same, of a series with its order."""

    order = measure(
        lambda value, what: _orders(value),
        "With --method series the highest power of λ in x/R, 1 (default, the books') to 9; even powers add"
        " nothing, and c and p are its slopes.",
        "N", many=True,
    )  # fmt: skip

    def series(self) -> str | None:
        """Return the method, of a series by its order. Raises ProblemError for several, or for none."""
        method, orders = self.method, self.order
        if orders is None:
            return method
        if method != "series":
            raise ProblemError(
                "--order is the highest power of λ of a series; add --method series, or leave --order out"
            )
        if len(orders) != 1:
            raise ProblemError(
                f"a page is of one order, and {len(orders)} were given; choose one, or see the greatest"
                " errors of several by --layout series-errors"
            )
        return series_of(orders[0])


def _orders(given: object) -> tuple[int, ...]:
    """Return the orders of series that are asked for. Raises KurbelError."""
    found = as_numbers(given, "order")
    for one in found:
        if one not in range(1, HIGHEST + 1):
            raise ProblemError(
                f"order {plain(one)} is not the highest power of λ of a series; write a whole number from 1"
                f" to {HIGHEST}"
            )
    return tuple(map(int, found))


def settle_sizes(values: Values) -> None:
    """Give the stroke as a length where it is written in another way, and the rod that the time ratio makes.
    Raises KurbelError."""
    if not values.says("stroke") and not values.says("time_ratio"):
        return
    from kurbel.drive.size import in_strokes, is_written

    if is_written(values.values.get("stroke")) or values.says("time_ratio"):
        values.values.update(in_strokes(values.values))
        values.read.add("time_ratio")


def settle_cranks(values: Values) -> None:
    """Give the cranks of a machine's file by directions in the sense of rotation, where it says by which
    angles they follow the first. Raises KurbelError."""
    if values.says("cranks") and values.origins.get("cranks") is Origin.MACHINE:
        values.values["cranks"] = tuple(-one % 360 for one in as_crank_angles(values.values["cranks"]))


def _settle_lengths(values: Values) -> None:
    """Keep two of crank ratio, stroke and length of the rod at the most, for two give the third.

    Raises ProblemError where what is left says two different things.
    """
    if not values.values.keys() >= {*LENGTHS}:
        return
    if values.typed("ratio") and values.origins.get("rod") is Origin.ENVIRONMENT:
        values.drop("rod")
    if not all(map(values.says, LENGTHS)):
        return
    if not values.typed("ratio"):
        if not (values.typed("stroke") or values.typed("rod")):
            _check_agreement(values)
        values.drop("ratio")
    elif values.typed("stroke") != values.typed("rod"):
        values.drop("rod" if values.typed("stroke") else "stroke")
    elif not values.typed("rod"):
        raise ProblemError(
            "stroke and rod are known and give the ratio; beside --ratio give the stroke or the rod as well"
        )


def _check_agreement(values: Values) -> None:
    ratio, stroke, rod = (values.values[name] for name in LENGTHS)
    share = as_length(stroke, "stroke") / 2 / as_length(rod, "rod")
    if {*(ratios := as_ratios(ratio))} != {share}:
        raise ProblemError(
            f"stroke {stroke} and rod {rod} give R:L = {ratio_text(share)},"
            f" and the ratio is {';'.join(map(ratio_text, ratios))}; leave one of the three out"
        )
