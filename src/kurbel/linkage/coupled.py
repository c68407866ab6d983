"""Coupled axles: the share of each in the effort of the driven one, and what the coupling rods carry of it.

All cranks stand alike, and a coupling rod presses along the line of shafts only: of the force F on the driven
pin the rod passes on what turns the axles beyond it, F times the sum of their shares, and to each pin stays
its own share of F. Rötscher names the drive (coupled axles of locomotives, Abb. 1045); re-derived here.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any

from kurbel.drive.at import At, known
from kurbel.drive.load import FORCE
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind, settled
from kurbel.exact.numerals import Label, Number, finite_decimals
from kurbel.kernel.circle import Numeric
from kurbel.linkage.linkage import LinkageRequest, force_lines, formula_line, linkage_subject
from kurbel.linkage.parallel import parallel_registry
from kurbel.motion.evaluation import value
from kurbel.motion.motion_quantities import Force, force_entries
from kurbel.page.axes import AngleAxis, ColumnAxis, ListAxis, Place
from kurbel.page.quantity import Column, Formula, Quantity, Words, filled, words
from kurbel.page.subject import OVER_AXES
from kurbel.page.table import Field
from kurbel.reading.given import as_number, as_places
from kurbel.reading.notation import about, plain

MOST_AXLES = 12
COUPLING = ("coupling_force", "coupling_force_n")
SHARED = ("tangential_force", "tangential_force_n", "radial_force", "radial_force_n", "torque", "torque_nm")
AXLE = words("Achse|Axle")
WORDS: Mapping[str, Words] = {
    "force": words(
        "$F$ auf den Zapfen der getriebenen Achse, längs der Wellenlinie, positiv wie der Weg beim Hingang"
        "|$F$ on the pin of the driven axle, along the line of shafts, positive as the path of the outstroke"
    ),
    "rods": words(
        "Jede Kuppelstange trägt den Anteil der Achsen jenseits von ihr, von der getriebenen aus; $S$ steht"
        " bei der Achse, die sie mit der nächsten verbindet"
        "|Each coupling rod carries the share of the axles beyond it, seen from the driven one; $S$ stands at"
        " the axle that it joins to the next"
    ),
    "points": words(
        "Bei $0°$ und $180°$ gibt eine Kuppelstange kein Drehmoment weiter; dort trägt die der anderen Seite,"
        " deren Kurbeln um $90°$ versetzt sind"
        "|At $0°$ and $180°$ a coupling rod passes on no torque; there that of the other side carries, whose"
        " cranks stand $90°$ apart"
    ),
}


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
    rods = {one.key: one for one in force_entries(COUPLING[0], force, whole, whole, of=FORCE)}
    return {**own, **rods}


def _whole(at: At) -> Numeric:
    return at.numbers.of(Fraction(1))


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class CoupledRequest(LinkageRequest):
    """What is asked for: the forces of coupled axles at crank angles."""

    axles: Axles


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


def _number(question: CoupledRequest, column: Column, place: Place, times: int) -> Number | None:
    """The printed number."""
    (drive,), angle, quantity = question.drives, question.angles[place["angle"]], column.quantity
    share = question.axles.factor(quantity.key, place["axle"])
    if share is None:
        return None

    def at(kind: Kind) -> Numeric:
        found = value(quantity, "exact", drive, kind.circle(angle), kind)
        return found * kind.of(known(share) * times)

    return Number(settled(at, column.places, question.rounding), column.places)


def _caption(question: Any) -> Label:
    axles = question.axles
    parts = {"{axles}": str(len(axles.shares)), "{driven}": str(axles.driven)}
    return filled(question.layout.caption[question.lang], parts.items())


def _notes(question: Any) -> Iterator[Label]:
    shown = [column.quantity.formulas["exact"] for column in question.page_columns]
    if line := formula_line(shown):
        yield line
    yield WORDS["rods"][question.lang]
    yield WORDS["points"][question.lang]
    yield from force_lines(question, WORDS["force"])


SUBJECT = linkage_subject(
    "coupled axles",
    layout="forces-coupled",
    command="table --mechanism parallel --axles",
    quantities=coupled_registry,
    notes=_notes,
    caption=_caption,
)._replace(
    axes={"angle": AngleAxis, "axle": _axle_axis, "column": ColumnAxis},
    axis_keys=("phi", "axle"),
    number=_number,
    drawn=OVER_AXES,
)
