"""The parallel crank: two equal cranks, joined by a rod as long as their shafts are apart.

Coupled axles: the share of each in the effort of the driven one, and what the coupling rods carry of it.

All cranks stand alike, and a coupling rod presses along the line of shafts only: of the force F on the driven
pin the rod passes on what turns the axles beyond it, F times the sum of their shares, and to each pin stays
its own share of F. Rötscher names the drive (coupled axles of locomotives, Abb. 1045); re-derived here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import NoReturn

from kurbel.drive.at import At, known
from kurbel.drive.crank import RODLESS, Crank, DescribedDrive
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind, settled
from kurbel.exact.numerals import Label, Number, finite_decimals
from kurbel.kernel.circle import Circle, Numeric
from kurbel.kernel.coupler import Rod, crank_pin
from kurbel.kernel.linkage import Place, coupler_place
from kurbel.linkage.linkage import (
    Linkage,
    LinkageMechanism,
    LinkagePosition,
    LinkageRequest,
    Outline,
    Point,
    force_lines,
    formula_line,
    linkage_subject,
    plain_notes,
    sine_forces,
)
from kurbel.motion import motion_quantities
from kurbel.motion.entries import spanned
from kurbel.motion.evaluation import value
from kurbel.motion.motion_quantities import Force
from kurbel.page.axes import AngleAxis, ColumnAxis, ListAxis
from kurbel.page.quantity import AND, Column, Formula, Of, Quantity, Texts, words
from kurbel.page.subject import OVER_AXES
from kurbel.page.table import Field
from kurbel.reading.given import as_number, as_places
from kurbel.reading.notation import about, plain

CHANGE_POINTS = (Fraction(0), Fraction(180))
"""The angles from the line of shafts at which a parallel crank may fold into the antiparallel crank."""
# In units of R. The motion is the same whatever the distance of the shafts; this one parts the circles.
SHAFTS = 3.0
TITLE = words("Parallelkurbel|Parallel crank")


@dataclass(frozen=True, slots=True)
class ParallelCrank(Linkage):
    """A parallel crank; its motion in units of R is that of a crank with an infinite rod, square to it too.

    The radius R in metres and the force of the rod on a crank in newtons may be known. The motion depends on
    no length.
    """

    crank: Crank = RODLESS

    def place(self, stroke: int, circle: Circle[Numeric], kind: Kind) -> Place[Numeric]:
        """Return where any point of the rod stands, which moves alike on both strokes."""
        return coupler_place(circle)

    def outline(self) -> Outline:
        return Outline(TITLE, ((0, 0), (SHAFTS, 0)), -1, SHAFTS + 1, _stand)


def _stand(pin: Point) -> LinkagePosition:
    shaft, other, second = (0.0, 0.0), (SHAFTS, 0.0), (pin[0] + SHAFTS, pin[1])
    return LinkagePosition(
        {"crank": (shaft, pin), "second_crank": (other, second), "rod": (pin, second)},
        (pin, second),
        ((shaft, pin, second, other),),
        (("second_crank", "$R$", 0.68), ("rod", "$L$", 0.5)),
        ((0, SHAFTS, "$L$"),),
    )


_ALONG = "längs der Wellenlinie|along the line of shafts"
_ACROSS = "quer zur Wellenlinie|square to the line of shafts"
_PATH, _SPEED, _GAIN = "Weg|Path", "Geschwindigkeit|Velocity", "Beschleunigung|Acceleration"
# Key, direction, name, symbol, heading, value, unit, formula.
_COUPLER: tuple[tuple[str, str, str, str, str, str, str, Callable[[At], Numeric]], ...] = (
    ("path", _ALONG, _PATH, "x", "x/R", "1 - cos φ", "$R$", lambda at: at.place.along),
    ("velocity", _ALONG, _SPEED, "c_x", "c_x/v", "sin φ", "$v$", lambda at: at.place.sine),
    ("acceleration", _ALONG, _GAIN, "p_x", "(p_x R)/v^2", "cos φ", "$v^2/R$", lambda at: at.place.cosine),
    ("rise", _ACROSS, _PATH, "y", "y/R", "sin φ", "$R$", lambda at: at.place.sine),
    ("rise_velocity", _ACROSS, _SPEED, "c_y", "c_y/v", "cos φ", "$v$", lambda at: at.place.cosine),
    ("rise_acceleration", _ACROSS, _GAIN, "p_y", "(p_y R)/v^2", "-sin φ", "$v^2/R$",
     lambda at: -at.place.sine),
)  # fmt: skip


@cache
def parallel_registry() -> Mapping[str, Quantity]:
    """Return every quantity of the parallel crank by its key."""
    return {one.key: one for one in (*_coupler_entries(), *_rod_entries(), *sine_forces())}


def _coupler_entries() -> Iterator[Quantity]:
    for key, part, name, symbol, heading, printed, unit, kernel in _COUPLER:
        formula = Formula(kernel, f"${heading} = {printed}$")
        one = spanned(f"coupler_{key}", name, f"${symbol}$", f"${heading}$", unit, 4, {"exact": formula})
        yield one._replace(spanners=(words(part), *one.spanners), part=words(part))


def _rod_entries() -> Iterator[Quantity]:
    """Yield the turning of the rod, which stays parallel to the line of shafts."""
    for key, name, letter, unit in (
        ("rod_velocity", "Winkelgeschwindigkeit|Angular velocity", "ω_L", "ω"),
        ("rod_acceleration", "Winkelbeschleunigung|Angular acceleration", "ε_L", "ω²"),
    ):
        none = Formula(lambda at: at.numbers.of(Fraction(0)), f"${letter} = 0$")
        head = f"${letter}/{unit.replace('²', '^2')}$"
        yield spanned(key, name, f"${letter}$", head, unit, 4, {"exact": none})


_POINTS = tuple(f"${plain(angle)}°$" for angle in CHANGE_POINTS)
SUBJECT = linkage_subject(
    "parallel crank",
    layout="parallel",
    command="table --mechanism parallel",
    quantities=parallel_registry,
    notes=plain_notes(
        words(
            "$F$ von der Koppel auf den Kurbelzapfen, längs der Wellenlinie, positiv wie der Weg beim Hingang"
            "|$F$ of the coupling rod on the crank pin, along the line of shafts, positive as the path of the"
            " outstroke"
        ),
        words(
            "Jeder Punkt der Koppel läuft auf einem Kreis vom Halbmesser $R$; $y$ ist zur Seite des"
            " Kurbelzapfens beim Hingang gerechnet"
            "|Every point of the coupling rod moves on a circle of radius $R$; $y$ counts to the side of the"
            " crank pin during the outstroke"
        ),
        words(
            f"Bei {AND['de'].join(_POINTS)} liegen alle Glieder in einer Linie; dort kann die zweite Kurbel"
            " umschlagen (Antiparallelkurbel)"
            f"|At {AND['en'].join(_POINTS)} all links lie in line; there the second crank may turn back"
            " (antiparallel crank)"
        ),
    ),
)


class Parallel(LinkageMechanism):
    name = "parallel"
    title = "the parallel crank"
    layout = "parallel"
    forces_layout = "forces-parallel"
    heavy = False
    rod = "kurbel.linkage.parallel:rod_ends"

    def drives(self, said: DescribedDrive, ratios: Sequence[str]) -> tuple[ParallelCrank, ...]:
        return (ParallelCrank(said.rodless),)

    def solved(self, drives: Sequence[Linkage], method: str | None) -> NoReturn:
        raise ProblemError(
            "the rod of the parallel crank moves as the piston with a rod of infinite length;"
            " leave --mechanism out and use --method infinite"
        )

    def conditions(self) -> Mapping[str, Quantity]:
        return {}


def rod_ends(
    drive: ParallelCrank, method: str, circle: Circle[Numeric], kind: Kind, beside: bool
) -> tuple[Rod[Numeric], None]:
    """Return the ends of the rod, which move alike, as all its points."""
    end = crank_pin(circle, circle.versine)
    return Rod(end, end), None


MECHANISM = Parallel()


MOST_AXLES = 12
COUPLING = ("coupling_force", "coupling_force_n")
SHARED = ("tangential_force", "tangential_force_n", "radial_force", "radial_force_n", "torque", "torque_nm")
AXLE = words("Achse|Axle")
WORDS = Texts("linkage", "parallel")


@dataclass(frozen=True, slots=True)
class Axles:
    """The shares of the axles in the effort, which add up to 1, in their order; `driven` counts from 1."""

    shares: tuple[Fraction, ...]
    driven: int = 1

    def __post_init__(self) -> None:
        count = len(self.shares)
        if not 2 <= count <= MOST_AXLES:
            raise ProblemError(f"the number of axles is {count}; coupled axles are 2 to {MOST_AXLES}")
        if not 1 <= self.driven <= count:
            raise ProblemError(
                f"the driven axle is {self.driven}; it must be one of the {count}, 1 to {count}"
            )

    @classmethod
    def of(cls, given: Sequence[Fraction], driven: int = 1) -> Axles:
        """Return the axles of one number, how many alike there are, or of several, the weights on them."""
        if len(given) == 1:
            (count,) = given
            if count.denominator > 1 or not 2 <= count <= MOST_AXLES:
                raise ProblemError(
                    f"the number of axles is {about(count)}; it must be a whole number from 2 to"
                    f" {MOST_AXLES}, or give the weights on them, for example '14;15;14'"
                )
            given = (Fraction(1),) * int(count)
        if low := [weight for weight in given if weight <= 0]:
            raise ProblemError(
                f"the weight on an axle is {about(low[0])}; it must be above 0, for its share goes by it"
            )
        return cls(tuple(weight / sum(given) for weight in given), driven)

    def beyond(self, axle: int) -> Fraction | None:
        """Return what the rod from this axle (from 0) to the next carries of F; None of the last."""
        if axle + 1 == len(self.shares):
            return None
        ahead = axle + 1 >= self.driven
        return sum(self.shares[axle + 1 :] if ahead else self.shares[: axle + 1], Fraction(0))

    def factor(self, key: str, axle: int) -> Fraction | None:
        """Return by what a quantity of the driven crank alone becomes that of an axle."""
        return self.beyond(axle) if key in COUPLING else self.shares[axle]


def axles_of(given: object, driven: object) -> Axles:
    """Return what options say of the axles, by default two alike of which the first is driven."""
    weights = (Fraction(2),) if given is None else as_places(given, "weight on an axle")
    first = Fraction(1) if driven is None else as_number(driven, "driven axle")
    if first.denominator > 1:
        raise ProblemError(f"the driven axle is {about(first)}; it must be the number of one, such as 2")
    return Axles.of(weights, int(first))


@cache
def coupled_registry() -> Mapping[str, Quantity]:
    """Return every quantity of coupled axles by its key, before it is shared out."""
    alone = {key: parallel_registry()[key] for key in SHARED}
    formulas = {
        key: {"exact": one.formulas["exact"]._replace(printed=printed)}
        for (key, one), printed in zip(
            alone.items(),
            ("$T/F = s sin φ$", "$T/F = s sin φ$", "$Z/F = s cos φ$", "$Z/F = s cos φ$", "", ""),
            strict=True,
        )
    }
    own = {key: one._replace(formulas=formulas[key]) for key, one in alone.items()}
    force = Force("Kuppelstangenkraft|Coupling-rod force", "S", "$S$ wie $F$|$S$ as $F$")
    whole = {"exact": Formula(_whole)}
    rods = {
        one.key: one for one in motion_quantities.force_entries(COUPLING[0], force, whole, whole, of=Of.FORCE)
    }
    return {**own, **rods}


def _whole(at: At) -> Numeric:
    return at.numbers.of(Fraction(1))


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class CoupledRequest(LinkageRequest):
    """What is asked for: the forces of coupled axles at crank angles."""

    axles: Axles

    @property
    def caption_parts(self) -> Mapping[str, Label]:
        axles, driven = str(len(self.axles.shares)), str(self.axles.driven)
        return {**super().caption_parts, "{axles}": axles, "{driven}": driven}


def _axle_axis(question: CoupledRequest) -> ListAxis:
    shares, name = question.axles.shares, AXLE[question.lang]

    def head(index: int) -> Label:
        return f"{name} {index + 1}, $s = {_share(shares[index])}$"

    return ListAxis(
        range(len(shares)), Field("axle", name, "", "", 0), lambda index: Number(index + 1, 0), head
    )


def _share(share: Fraction) -> str:
    decimals = finite_decimals(share)
    return plain(share) if decimals is not None and decimals <= 4 else str(share)


def _number(question: CoupledRequest, column: Column, place: Mapping[str, int], times: int) -> Number | None:
    """The printed number."""
    (drive,), angle, quantity = question.drives, question.angles[place["angle"]], column.quantity
    share = question.axles.factor(quantity.key, place["axle"])
    if share is None:
        return None

    def at(kind: Kind) -> Numeric:
        found = value(quantity, "exact", drive, kind.circle(angle), kind)
        return found * kind.of(known(share) * times)

    return Number(settled(at, column.places, question.rounding), column.places)


def _notes(question: CoupledRequest) -> Iterator[Label]:
    shown = [column.quantity.formulas["exact"] for column in question.page_columns]
    if line := formula_line(shown):
        yield line
    yield WORDS["rods"][question.lang]
    yield WORDS["points"][question.lang]
    yield from force_lines(question, WORDS["force"])


COUPLED = linkage_subject(
    "coupled axles",
    layout="forces-coupled",
    command="table --mechanism parallel --axles",
    quantities=coupled_registry,
    notes=_notes,
)._replace(
    axes={"angle": AngleAxis, "axle": _axle_axis, "column": ColumnAxis},
    axis_keys=("phi", "axle"),
    number=_number,
    drawn=OVER_AXES,
)
