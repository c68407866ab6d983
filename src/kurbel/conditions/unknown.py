"""A number other than the crank angle for which a condition holds at one, each with proof, and its page.

A force at an angle is a polynomial of the piston force, the pressure, a mass or the speed, of degree 1 in
itself or in its square, and so is a velocity; the torque is one of degree 2 in the stroke. A few values of
the formula therefore tell it for all. The crank ratio enters with roots: there all zeros of the formula are
enclosed by interval arithmetic (exact/search).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property, partial
from typing import Any, NamedTuple, Protocol

import flint
from flint import arb

from kurbel.conditions.solve_page import exists
from kurbel.errors import NoRootError, ProblemError
from kurbel.exact.certify import NEVER_TIES, at_bits, ball, rounded
from kurbel.exact.numerals import Label, Number, figures
from kurbel.exact.search import Jet, isolate
from kurbel.kernel.circle import Numeric
from kurbel.page.axes import (
    PHI,
    Axis,
    ColumnAxis,
    ListAxis,
    Place,
    angle_decimals,
    angle_number,
    angle_text,
    method_of,
)
from kurbel.page.quantity import Column, Formula, Quantity, Texts, Words, words
from kurbel.page.subject import Question, Subject
from kurbel.page.table import Field

# At which a formula is evaluated to find its polynomial, in times of the probe of an unknown.
PROBES = (Fraction(1), Fraction(2), Fraction(3), Fraction(5, 2))
# So many bits must decide whether a coefficient is zero.
DECIDING_BITS = 512


class Unknown(NamedTuple):
    """What can be asked for beside the angle: its name, letter, unit on pages and that in SI units, a value
    with which every drive and engine is one, the power of it in which forces are of degree 1, and the
    option that says what drives."""

    name: Words
    symbol: str
    unit: str
    size: Fraction
    probe: Fraction
    power: int = 1


UNKNOWNS = {
    "speed": Unknown(
        words("Drehzahl|Speed"), "$n$", '$"min"^(-1)$', Fraction(1, 60), Fraction(1), 2
    ),
    "force": Unknown(words("Kolbenkraft|Piston force"), "$F$", "N", Fraction(1), Fraction(1000)),
    # Above every back pressure.
    "pressure": Unknown(
        words("Dampfdruck|Steam pressure"), "$p$", "bar", Fraction(10**5), Fraction(10**10)
    ),
    "bore": Unknown(words("Bohrung|Bore"), "$d$", "mm", Fraction(1, 1000), Fraction(1), 2),
    "reciprocating": Unknown(
        words("hin- und hergehende Masse|Reciprocating mass"), "$m$", "kg", Fraction(1), Fraction(100)
    ),
    "rod_mass": Unknown(words("Masse der Stange|Mass of the rod"), "$M$", "kg", Fraction(1), Fraction(100)),
    "stroke": Unknown(words("Hub, 2 R|Stroke, 2 R"), "$2 R$", "mm", Fraction(1, 1000), Fraction(1)),
    "ratio": Unknown(words("Kurbelverhältnis|Crank ratio"), "$R/L$", "", Fraction(1), Fraction(1, 4)),
}  # fmt: skip


@dataclass(frozen=True)
class Polynomial:
    """A formula as a polynomial of a power of the unknown.

    `value` evaluates it at an exact value of the unknown, at the precision in force; where it is the
    magnitude of a force, which is a square root of a polynomial, its `square` is taken.
    """

    value: Callable[[Fraction], arb]
    target: Callable[[], arb]
    probe: Fraction
    power: int
    degree: int
    square: bool = False

    def coefficients(self) -> list[arb]:
        """Return the coefficients of the polynomial less the target, from the constant one on.

        By divided differences; one more value is compared with them.
        """
        count = (2 if self.square else 1) * self.degree + 1
        nodes = [self.probe * factor for factor in PROBES]
        places = [ball(node**self.power) for node in nodes]
        values = [self._at(node) for node in nodes]
        table, found = values[:count], []
        for order in range(count):
            found.append(table[0])
            table = [
                (table[at + 1] - table[at]) / (places[at + 1 + order] - places[at])
                for at in range(len(table) - 1)
            ]
        polynomial = [arb(0)]
        for order in reversed(range(count)):
            # Newton's form, by Horner: times (t - t_k), plus the difference of this order.
            shifted = [arb(0), *polynomial]
            polynomial = [
                one - places[order] * other for one, other in zip(shifted, [*polynomial, arb(0)], strict=True)
            ]
            polynomial[0] += found[order]
        polynomial = polynomial[:count]
        checked = sum((one * places[-1] ** power for power, one in enumerate(polynomial)), arb(0))
        if not (checked - values[-1]).contains(0):
            raise ProblemError("this unknown enters otherwise than by a square at most; ask for another one")
        polynomial[0] -= self.target() ** 2 if self.square else self.target()
        return polynomial

    def _at(self, node: Fraction) -> arb:
        value = self.value(node)
        return value**2 if self.square else value

    def roots(self) -> list[Callable[[], arb]]:
        """Return all positive values of the unknown with which the value is the target, in order."""
        with at_bits(DECIDING_BITS):
            exact = self._real()
            count = len(exact)
            order = sorted(range(count), key=lambda index: float(exact[index].mid()))
        return [_chosen(self, index) for index in order if exact[index] > 0]

    def _real(self) -> list[arb]:
        """Return the real zeros over the power of the unknown, in the order of the formula."""
        constant, *others = self.coefficients()
        # So many bits tell a coefficient from zero that is not zero by the sizes of the drive.
        while others and others[-1].contains(0):
            others.pop()
        if not others:
            raise ProblemError(
                "at an angle that was given, such as a dead centre, the condition does not depend on what is"
                " asked for; leave that angle out, or ask for another unknown"
            )
        if len(others) == 1:
            return [-constant / others[0]]
        linear, square = others
        below = linear * linear - 4 * square * constant
        if below < 0:
            return []
        if below.contains(0):
            raise ProblemError(
                "whether the condition is just reached is not settled; alter its value a little"
            )
        root = below.sqrt()
        return [(-linear + sign * root) / (2 * square) for sign in (-1, 1)]


def _chosen(polynomial: Polynomial, index: int) -> Callable[[], arb]:
    def root() -> arb:
        with at_bits(max(flint.ctx.prec, DECIDING_BITS)):
            found = polynomial._real()[index]
            return found if polynomial.power == 1 else found.root(polynomial.power)

    return root


def of_ratio(
    formula: Callable[[Any], Any], target: Callable[[], arb], greatest: Fraction
) -> list[Callable[[], arb]]:
    """Return all crank ratios above 0 and up to the greatest with which a formula, that takes numbers or jets
    over the ratio, has the target; each to be refined at the precision in force."""

    def function(ratio: arb) -> arb:
        found: arb = formula(ratio) - target()
        return found

    def slope(ratio: arb) -> arb:
        found: arb = formula(Jet(ratio, arb(1), arb(0))).slope
        return arb(found)

    least = greatest / 2**20
    found = []
    for zero in isolate(function, slope, least, greatest):
        if zero.rising is None:
            raise ProblemError("the condition holds at more ratios than can be told apart; alter its value")
        found.append(zero.place)
    return found


NEAR_BITS = 120
WORDS = Texts("conditions", "unknown")

# What stands for an unknown in a German sentence, where it is not "die".
_WHICH = {"pressure": "den", "stroke": "den", "ratio": "das"}


@cache
def registry() -> Mapping[str, Quantity]:
    """Return every unknown by its key; L/R stands beside R/L."""
    found = {}
    for key, one in UNKNOWNS.items():
        heading = f"{one.symbol} in {one.unit}" if one.unit else one.symbol
        formulas = {"exact": Formula(partial(_in_unit, one.size))}
        found[key] = Quantity(key, one.name, one.symbol, words(one.unit), None, formulas, words(heading))
        found[key] = found[key]._replace(spanners=(one.name,))
    rod = words("Stangenverhältnis|Rod ratio")
    formulas = {"exact": Formula(lambda found: 1 / found)}
    found["rod_ratio"] = Quantity(
        "rod_ratio", rod, "$L/R$", words(""), None, formulas, words("$L/R$"), spanners=(rod,)
    )
    return found


def _in_unit(size: Fraction, found: Numeric) -> Numeric:
    return found / ball(size)


class SoughtNumber(Protocol):
    """A number and the condition by which it is found, at an angle: its values in SI units, at the precision
    in force, the labels of condition and angle, and what else there is to say."""

    condition: Any
    place: Any

    @property
    def found(self) -> Sequence[Callable[[], arb]]: ...

    def label(self, lang: str) -> Label: ...

    def lines(self, lang: str) -> Sequence[Label]: ...


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class UnknownRequest(Question):
    """What is asked for: all values of an unknown, which `asked` finds, each at its angle."""

    unknown: str
    asked: tuple[SoughtNumber, ...]

    no_column = "there is no column beside the number; add one, such as speed"
    undrawn = "give several angles, --angle 0..90:15"

    def check(self) -> None:
        if not any(self.found):
            name, where = (
                self.unknown.replace("_", " "),
                "any of these angles" if self.asked[1:] else "this angle",
            )
            condition = self.asked[0].condition
            raise NoRootError(
                f"{condition} is reached with no {name} above 0 at {where}; check signs and sizes"
            )

    def __len__(self) -> int:
        return sum(map(len, self.found))

    @property
    def axis_keys(self) -> tuple[str, ...]:
        # What is of one angle says so in its caption.
        return ("phi", "solution") if self.asked[1:] else ("solution",)

    @cached_property
    def found(self) -> Sequence[Sequence[Callable[[], arb]]]:
        """The values at each angle."""
        return [one.found for one in self.asked]

    def roots(self, place: Place) -> Sequence[Callable[[], arb]]:
        return self.found[place["phi"]]

    def missing(self, quantity: Quantity) -> str:
        own = (self.unknown, "rod_ratio") if self.unknown == "ratio" else (self.unknown,)
        if quantity.key in own:
            return ""
        return f"column {quantity.key} is not asked for; leave it out, or write --unknown {quantity.key}"

    def value(self, place: Place, column: Column) -> arb:
        """Return a value in the unit of a column, at the precision in force."""
        return ball(column.quantity.formulas["exact"].kernel(self.roots(place)[place["root"]]()))


def _angle_axis(question: UnknownRequest) -> ListAxis:
    angles = [one.place.degrees for one in question.asked]
    decimals = angle_decimals(angles)
    return ListAxis(
        angles,
        Field("phi", PHI[question.lang], "$φ$", "°", decimals, method_of(angles)),
        lambda angle: angle_number(angle, decimals),
        lambda angle: f"$φ = {angle_text(angle)}$",
    )


class _RootAxis(Axis):
    """The values, numbered."""

    key = "solution"

    def __init__(self, question: UnknownRequest) -> None:
        super().__init__(max(map(len, question.found)))
        self.lang = question.lang

    def field(self) -> Field:
        return Field("solution", WORDS["number"][self.lang], "", "", 0)

    def value(self, place: Place) -> Number:
        return Number(place["root"] + 1, 0)

    def stub(self, place: Place) -> Number:
        return self.value(place)

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (str(place["root"] + 1),)


def _number(question: UnknownRequest, column: Column, place: Place, times: int) -> Number:
    decimals = column.decimals
    if decimals is None:
        with at_bits(NEAR_BITS):
            decimals = figures(float(question.value(place, column).mid()))
    scaled = rounded(lambda: times * question.value(place, column), decimals, question.rounding, NEVER_TIES)
    return Number(scaled, decimals)


def _caption(question: UnknownRequest) -> Label:
    lang, first = question.lang, question.asked[0]
    text = question.layout.caption[lang]
    for place, said in (
        ("{unknown}", UNKNOWNS[question.unknown].name[lang]),
        ("{which}", _WHICH.get(question.unknown, "die")),
        ("{condition}", first.label(lang)),
        ("{angle}", WORDS["angles"][lang] if question.asked[1:] else first.place.label(lang)),
    ):
        text = text.replace(place, said)
    return text


def _notes(question: UnknownRequest) -> Iterator[Label]:
    of_all, *of_first = next(one for one in question.asked if one.found).lines(question.lang)
    yield of_all
    if not all(one.found for one in question.asked):
        yield WORDS["none"][question.lang]
    if question.asked[1:] and of_first:
        yield WORDS["first"][question.lang]
    yield from of_first


SUBJECT = Subject(
    key="unknown",
    layout="solve-unknown",
    command="solve --unknown speed",
    axes={"phi": _angle_axis, "root": _RootAxis, "column": ColumnAxis},
    axis_keys=("phi", "solution"),
    quantities=registry,
    number=_number,
    caption=_caption,
    notes=_notes,
    exists=exists,
    letters=True,
)
