"""The crank angles at which path, velocity, forces and the like fulfil a condition, as a page and for --angle
's=10%'; or another number with which one holds."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from kurbel.commands.forces import ForcesOptions
from kurbel.commands.motion import some
from kurbel.commands.options import Choice, Option, amount, word
from kurbel.commands.part import CommandOptions, Values, flag_of
from kurbel.commands.parts.drive import Series, Turning
from kurbel.commands.parts.effort import PRESSING, RODS, Effort
from kurbel.commands.parts.engine import Engine, ReferenceCylinder
from kurbel.commands.parts.loads import KINDS
from kurbel.commands.parts.masses import Masses, Weight
from kurbel.commands.parts.sheet import Layouts, Sheet, columns_option, layout_option
from kurbel.commands.subject import function
from kurbel.conditions.solve import read_on
from kurbel.conditions.solve_page import SolveRequest
from kurbel.drive.moved import Drive
from kurbel.errors import NotationError, ProblemError
from kurbel.exact.kind import FoundAngle
from kurbel.exact.place import Place
from kurbel.motion.evaluation import RETURN
from kurbel.motion.mechanism import Mechanism
from kurbel.page.subject import Question
from kurbel.reading.where import ACCELERATIONS, read_condition

# What conditions on the motion are about, of any crank drive.
OF_MOTION = (
    *("x", "s", "fd", "c", "p", "psi", "ψ", "path", "velocity", "acceleration", "rocker", "θ"),
    *("rod_velocity", "rod_acceleration", "turn_velocity", "turn_acceleration"),
)
# The options of loads, and those of masses and of their weight.
OF_LOADS = frozenset(
    name for key, kind in KINDS.items() for name in (key, *kind.options, "cranks", "cylinder", "of")
)
OF_MASSES = frozenset((*Masses.masses(), *(one.name for one in Weight.options().values())))


def as_conditions(where: object, what: str) -> tuple[str, ...]:
    """Return the conditions as they are written."""
    given = [where] if isinstance(where, str) or not isinstance(where, Iterable) else [*where]
    texts = tuple(text for text in given if isinstance(text, str))
    if len(texts) < len(given):
        raise NotationError('a condition is text, such as "p = 0"')
    return texts


class SolveOptions(Engine, ReferenceCylinder, Effort, Series, Layouts, Sheet, CommandOptions):
    """Print all crank angles of the turn at which a condition holds, on both strokes.

    Path, velocity and acceleration count on either stroke from the dead centre where it begins, in its
    direction; max and min are those of each stroke, and psi=max is where the rod leans furthest to either
    side. Forces of an engine, by --eps and the like, count over the whole turn. --unknown asks for another
    number than the angle, with which a condition holds at one.

    \b
    kurbel solve --ratio 1:5 --where p=0  # no acceleration
    kurbel solve --ratio 1:5 --where c=max  # the greatest velocity
    kurbel solve --ratio 1:5 --where 's = 25%'  # a quarter of the stroke
    kurbel solve --machine engine.toml --where torque=max  # the greatest torque
    kurbel solve --ratio '1:4;1:5' --where s=25% --where c=max
    kurbel solve --stroke 600mm --rod 1500mm --speed 120/min --where "c = 3 m/s"
    kurbel solve --ratio 1:5 --mechanism arc --rocker 6 --where acceleration=0
    kurbel solve --eps 4 --where torque=max --where tangential=0.5
    kurbel solve --machine engine.toml --unknown speed --angle 30 --where crosshead_load=0
    kurbel solve --unknown ratio --angle 80 --where c=max
    \f
    >>> import kurbel
    >>> page = kurbel.solve("p = 0", ratio="1:5", method="series", columns="stroke,phi,x")
    >>> print(kurbel.typeset(page, "csv"), end="")
    stroke,phi,x
    outstroke,79.2724,0.9104
    return,100.7276,1.0896
    """

    topic = "question"

    unnamed = "where"
    sequence = (
        "ratio columns offset stroke time_ratio rod method order speed mechanism rocker"
        " pivot circuit beam force eps back exponent clearance card other_side single_acting cranks bore"
        " pressure reciprocating rod_mass centre gyration rod_file rotating rocker_inertia slope"
        " gravity"
    )
    in_short = "where unknown angle ratio stroke rod speed machine force eps bore pressure"

    where: Option[Sequence[str]] = Option(
        'Condition: p=0, s=25% (share of the stroke), x=1.1, "x = 200 mm", "c = 3 m/s", c=max, p=min,'
        ' "p = 1/6 of dead centre", psi=5; of an engine torque=max, tangential=0.5, "rod_force = 10 kN";'
        " repeated for several.",
        "CONDITION",
        many=True,
        default=(),
        whole=True,
    )
    columns = columns_option(
        "solve", "stroke,phi,phi_turn,x,c,p", ". Pages keep the stroke and φ at the left."
    )
    unknown = word(
        "What is asked for in place of the angle: speed, force, pressure, bore, reciprocating, rod_mass,"
        " stroke or ratio; with --angle and one condition.",
        kind=Choice("unknown", "kurbel.conditions.unknown:UNKNOWNS"),
    )
    angle = amount(
        "With --unknown the crank angles at which the condition holds: 30, 0..90:15, or what holds there on"
        " the outstroke: c=max, 's=10%'.",
        "ANGLES",
        unit="degrees",
        topic="angles",
    )
    layout = layout_option("roots", "loaded roots", "unknown")
    method = Turning.method.but()

    @classmethod
    def settle(cls, values: Values) -> None:
        """Drop what is asked for as --unknown, where it comes from elsewhere."""
        unknown = values.values.get("unknown")
        if isinstance(unknown, str) and not values.typed(unknown):
            values.drop(unknown)

    def question(self) -> Question:
        if self.unknown is not None:
            return self._unknown(self.unknown)
        if self.of_engine():
            return self._of_engine()
        self.refuse(*PRESSING)
        page = self.page("solve", "roots")
        chosen, described = self.described(beside=("force",))
        drives = some(chosen.drives(described, page.ratios))
        if self.of_forces():
            drives = self._moving(chosen, drives)
        solved = chosen.solved(drives, self.series())
        return SolveRequest(
            drives=solved,
            conditions=tuple(dict.fromkeys(read_on(solved[0], text) for text in self.conditions)),
            **self.on_page(page, "stroke,phi,x"),
        )

    @property
    def conditions(self) -> Sequence[str]:
        """The conditions as they are written. Raises NotationError."""
        # What runs only once is kept.
        self.values.values["where"] = found = as_conditions(self.where, "condition")
        return found

    def shared(self) -> Collection[str]:
        # No layout tells the mechanism. Forces have newtons on every drive.
        return super().shared() if self.unknown or self.of_engine() else ()

    def of_engine(self) -> bool:
        """Whether conditions are about the forces under the load of an engine, or nothing says what about."""
        return self.is_engine() and (not self.conditions or self.of_forces())

    def of_forces(self) -> bool:
        """Whether a condition is about forces."""
        return any(text.partition("=")[0].strip() not in OF_MOTION for text in self.conditions)

    def unread(self, option: Option[object]) -> str:
        name, flag = option.name, flag_of(option.name)
        if self.unknown is not None:
            return self._unread_of_unknown(option)
        if name == "angle":
            return "--angle is for --unknown; conditions find the angles themselves"
        if name in PRESSING:
            return (
                f"{flag} is for --unknown, such as --unknown bore --angle 30, and for kurbel forces;"
                " conditions on angles are under the load of an engine, such as --eps 4"
            )
        if self.of_engine():
            return {
                "force": "--force does not go with the load of an engine; leave it out",
                "order": "--order is of a series of the motion, and the condition is on forces; leave it out",
            }.get(name, "")
        why = "is for conditions on the forces of an engine"
        if name in OF_LOADS or name in ("bore", *RODS, "friction"):
            if self.is_engine():
                return f"{flag} {why}, such as torque=max; leave it out"
            return f"{flag} {why}; add its load, such as --eps 4"
        if name in OF_MASSES and not self.of_forces():
            if self.is_engine():
                return f"{flag} {why}, such as torque=max; leave it out"
            return f"{flag} is for conditions on forces, such as torque=max; leave it out"
        return ""

    def _unread_of_unknown(self, option: Option[object]) -> str:
        """Return the sentence that refuses an option beside --unknown: that of the page of the forces."""
        name, flag = option.name, flag_of(option.name)
        if self.unknown == "ratio":
            if name == "stroke":
                return (
                    "--stroke gives lengths in mm, and the condition has none; leave it out, or write one as"
                    " 'x = 200 mm'"
                )
            return f"{flag} is of forces, and --unknown ratio is of the motion of the piston; leave it out"
        if not (self.is_engine() or self.of_forces()):
            return f"{flag} is of forces, and the condition is on the motion of the piston; leave it out"
        return self.as_part(ForcesOptions).refusal(option)

    def _moving(self, chosen: Mechanism, drives: Sequence[Drive]) -> Sequence[Drive]:
        """Return the drives with their masses, where conditions on their forces are solved."""
        if not self.is_heavy():
            return drives
        if not chosen.crosshead:
            raise ProblemError(
                f"conditions on the forces of moving masses are not solved for {chosen.title}; print them"
                " over the turn, kurbel forces"
            )
        if self.method not in (None, "exact"):
            raise ProblemError(
                f'method "{self.method}" has no conditions on the forces of moving masses; use exact'
            )
        return self.weighed(chosen, drives)

    def _of_engine(self) -> Question:
        """Return what is asked of the forces of an engine."""
        from kurbel.conditions.loaded import MEASURED, NAMES, LoadedRequest

        self.refuse("force", "order", *PRESSING)
        page = self.page("solve-load", "loaded roots")
        about = "torque and the forces of the crank drive"
        read = (read_condition(text, NAMES, MEASURED, about) for text in self.conditions)
        return LoadedRequest(
            **self.of_page(page),
            conditions=tuple(dict.fromkeys(read)),
            columns=self.names("phi,torque"),
            **self.printed(),
        )

    def _unknown(self, unknown: str) -> Question:
        """Return what is asked for: all values of the unknown by which the condition holds."""
        from kurbel.commands.unknown import PolynomialUnknown, RatioUnknown, angles_of
        from kurbel.conditions.unknown import UnknownRequest

        page = self.page("solve-unknown", "unknown")
        if self.says(unknown):
            raise ProblemError(
                f"{flag_of(unknown)} is given and asked for, as --unknown; leave one of the two out"
            )
        if len(self.conditions) != 1:
            raise ProblemError(
                f"--unknown takes one condition, and {len(self.conditions)} were given; write one --where"
            )
        kind, condition = RatioUnknown if unknown == "ratio" else PolynomialUnknown, self.conditions[0]
        asked = tuple(kind(unknown, angle, condition, self) for angle in angles_of(self.angle))
        return UnknownRequest(unknown=unknown, asked=asked, **self.on_page(page, "speed"))


solve = function(SolveOptions, "solve")


HALF_TURN, FULL_TURN = Fraction(180), Fraction(360)
# What is asked for beside the angles, and where a condition is on the motion also what acts there.
APART = ("unknown", "angle", "columns", "layout", "units", "digits")
ACTING = ("force", "eps", *PRESSING)


@dataclass(frozen=True)
class ConditionPlace:
    """A place at which a condition holds, by its number among all of what was asked for."""

    asked: object
    number: int

    def __call__(self) -> Place:
        return places_of(self.asked)[self.number][0]


def angles_of(text: str, values: Values, ratios: Sequence[str], cycle: Fraction) -> tuple[Fraction, ...]:
    """Return the crank angles of the cycle at which a condition holds, in their order.

    A drive that no option gives is one of these `ratios`. Raises KurbelError.
    """
    of_motion = text.partition("=")[0].strip() in OF_MOTION
    own: dict[str, object] = {"where": (text,), **dict.fromkeys(APART)}
    method = values.values.get("method")
    if isinstance(method, Sequence) and not isinstance(method, str):
        own["method"] = method[0] if method else None
    if not values.says("ratio", "rod"):
        own["ratio"] = tuple(ratios)
    if of_motion:
        own |= dict.fromkeys((*ACTING, "acceleration"))
        # Without a unit such as m/s the speed says nothing here.
        own["speed"] = values.values.get("speed") if "/s" in text else None
    asked: Any = SolveOptions(values.instead(own, own=True)).question()
    if len(asked.drives) != 1:
        raise ProblemError(
            f"--angle {text} is at other angles for each crank ratio, and {len(asked.drives)} were given;"
            " give one, or kurbel sweep with the ratios"
        )
    if values.says("acceleration") and asked.conditions[0].quantity in ACCELERATIONS:
        raise ProblemError(
            f"--angle {text} is that of a crank that turns evenly; leave --acceleration out, or give the"
            " angle in degrees"
        )
    found = [_turned(asked, number, *one) for number, one in enumerate(places_of(asked))]
    turns = int(cycle // FULL_TURN) if of_motion else 1
    return tuple(one + FULL_TURN * turn for turn in range(max(turns, 1)) for one in sorted(found))


def places_of(asked: Any) -> list[tuple[Place, Fraction]]:
    """Return all places that a question of conditions has, and by how many degrees each is to be turned."""
    if isinstance(asked, SolveRequest):
        roots = [root for found in asked.found.values() for root in found]
        return [(one.place, HALF_TURN if one.stroke == RETURN else Fraction(0)) for one in roots]
    roots = asked.roots({"expansion": 0, "ratio": 0, "condition": 0})
    return [(one.place, Fraction(0)) for one in roots]


def _turned(asked: object, number: int, place: Place, turned: Fraction) -> Fraction:
    degrees = place.degrees
    found = FoundAngle(ConditionPlace(asked, number), HALF_TURN) if degrees is None else degrees
    return found + turned
