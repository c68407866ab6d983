"""The beam engine, checked once, and the page of its dead centres with certified digits.

Each quantity by the book's approximation or from the true geometry (`exact`); see kernel/beam.py. A page
prints degrees and minutes, records degrees.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import TypeAlias

from flint import arb

from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact.certify import ball, ball_degrees, pi
from kurbel.exact.kind import settled
from kurbel.exact.numerals import Label, Number, nearest
from kurbel.kernel import beam
from kurbel.page.axes import ColumnAxis, LetteredRatioAxis, ListAxis, Place, angle_decimals
from kurbel.page.layouts import LayoutColumn
from kurbel.page.quantity import Column, Formula, Quantity, entry, words
from kurbel.page.subject import Question, Subject
from kurbel.page.table import Field
from kurbel.reading.notation import about, plain, ratio_text

UPPER, LOWER = 1, -1
APPROXIMATE, EXACT = "approximate", "exact"
DEGREE_DECIMALS, PATH_DECIMALS = 4, 5
# From the beam engine and the dead centre to a ball.
Kernel: TypeAlias = "Callable[[BeamEngine, int], arb]"
# The least arm in a message is a multiple of this, rounded up.
_ARM_STEP = Fraction(1, 10**6)
_LONGEST_RATIO = 40


@dataclass(frozen=True, slots=True)
class BeamEngine:
    """A beam engine: arm a/r of the beam and ratio λ = r/l of crank and rod; λ = 0 is the infinite rod.

    An infinite rod stays vertical: then μ = ν = 0 and the dead centres lie opposite each other. Valid for
    0 <= λ < 1 and an arm with which the crank turns (`turning_margin`), always above r.
    """

    arm: Fraction
    ratio: Fraction

    def __post_init__(self) -> None:
        Crank(self.ratio)  # refuses what no crank may have
        if self.arm <= 1:
            raise ProblemError(
                f"beam arm a is {about(self.arm)} r; it must be longer than the crank radius r,"
                " for the beam's end rises and falls by r at least"
            )
        if beam.turning_margin(self.arm, self.ratio) <= 0:
            raise ProblemError(
                f"beam arm a = {about(self.arm)} r is too short for r:l = {_shown(self.ratio)};"
                f" the crank turns with an arm of {about(_least_arm(self.ratio))} r or a longer rod,"
                " otherwise beam, pivot and shaft come into line"
            )

    def numbers(self, side: int = UPPER) -> tuple[arb, arb]:
        """Return a/r and λ, for LOWER with the other sign, as balls."""
        return ball(self.arm), ball(side * self.ratio)


def _shown(ratio: Fraction) -> str:
    text = ratio_text(ratio)
    return text if len(text) <= _LONGEST_RATIO else about(ratio)


def _least_arm(ratio: Fraction) -> Fraction:
    """Return an arm a/r with which the crank turns, at most a step above the shortest."""
    short, long = 10**6, 2 * 10**6
    while beam.turning_margin(long * _ARM_STEP, ratio) <= 0:
        short, long = long, 2 * long
    while long - short > 1:
        middle = (short + long) // 2
        if beam.turning_margin(middle * _ARM_STEP, ratio) > 0:
            long = middle
        else:
            short = middle
    return long * _ARM_STEP


def chord_square(engine: BeamEngine) -> arb:
    """Return q²/r² of the half chord in the true geometry, a ball at the precision in force.

    The ball holds it for certain: `closure` is concave and rises up to the root, so that a tangent below the
    root meets zero before it and a rising chord across the root after it (Dandelin); both are balls.
    """
    if not engine.ratio:
        return ball(1)
    highest = min(1 / engine.ratio, beam.highest_square(engine.arm, engine.ratio))
    arm, ratio = engine.numbers()
    below, above = ball(1), ball(highest).upper()
    while (nearer := _nearer(below, above, arm, ratio)) != (below, above):
        below, above = nearer
    return below.union(above)


def _nearer(below: arb, above: arb, arm: arb, ratio: arb) -> tuple[arb, arb]:
    """Return bounds of the root of `closure` that are no farther from it than these."""
    value = ball(beam.closure(below, arm, ratio))
    tangent = ball(below - value / beam.closure_slope(below, arm, ratio)).lower()
    rise = ball(beam.closure(above, arm, ratio)) - value
    chord = (below - value * (above - below) / rise).upper()
    # Where too few bits are left to divide, or to know that the chord rises, the bounds stay.
    return (tangent if tangent > below else below), (chord if rise > 0 and chord < above else above)


def _exact_lean(engine: BeamEngine, side: int) -> arb:
    """Return μ (UPPER) or ν (LOWER) in degrees."""
    return ball_degrees(ball(beam.lean_sine(chord_square(engine), *engine.numbers(side))))


def _lean(engine: BeamEngine, side: int) -> arb:
    """Return the same by the formula of the book."""
    return ball(beam.approximate_lean(*engine.numbers(side))) * 180 / pi()


def _exact_path(engine: BeamEngine, side: int) -> arb:
    """Return the beam's path between a dead centre and the vertical crank."""
    return 2 * ball(engine.arm) * ball(beam.swing_tangent(chord_square(engine), *engine.numbers(side))).atan()


def _path(engine: BeamEngine, side: int) -> arb:
    """Return the same by the formula of the book."""
    return ball(beam.approximate_path((ball(beam.approximate_lean(*engine.numbers(side))) / 2).sin()))


def _distance(lean: Kernel) -> Kernel:
    """Return 180° ± (ν - μ) of a lean."""
    return lambda engine, side: 180 + side * (lean(engine, LOWER) - lean(engine, UPPER))


@cache
def registry() -> Mapping[str, Quantity]:
    """Return every quantity by its key, in the order of the book.

    A kernel call takes the beam engine and the dead centre, UPPER (crank and rod stretched) or LOWER
    (folded); of the two distances UPPER is the angle on the pivot's side of the shaft.
    """
    distance = "Abstand der Totpunkte|Distance of the dead centres"
    entries = (
        _entry(
            "mu", "μ", "Stangenneigung, Strecklage|Angle of the rod, stretched", UPPER,
            _lean, _exact_lean, "r^2/(4 a (l + r))",
        ),
        _entry(
            "nu", "ν", "Stangenneigung, Decklage|Angle of the rod, folded", LOWER,
            _lean, _exact_lean, "r^2/(4 a (l - r))",
        ),
        _entry("distance_1", "180° + (ν - μ)", distance, UPPER, _distance(_lean), _distance(_exact_lean)),
        _entry("distance_2", "180° - (ν - μ)", distance, LOWER, _distance(_lean), _distance(_exact_lean)),
        _entry(
            "path_1", "σ_1", "Weg des Balanciers, Strecklage|Path of the beam, stretched", UPPER,
            _path, _exact_path, "r (1 - cos μ)", PATH_DECIMALS,
        ),
        _entry(
            "path_2", "σ_2", "Weg des Balanciers, Decklage|Path of the beam, folded", LOWER,
            _path, _exact_path, "r (1 - cos ν)", PATH_DECIMALS,
        ),
    )  # fmt: skip
    return {one.key: one for one in entries}


def _entry(
    key: str, letter: str, name: str, side: int, book: Kernel, true: Kernel, printed: str = "",
    decimals: int | None = None,
) -> Quantity:  # fmt: skip
    """An entry, of an angle unless it has decimals of its own."""
    symbol, formula = f"${letter}$", f"${letter} = {printed}$" if printed else ""
    formulas = {APPROXIMATE: Formula(book, formula), EXACT: Formula(true)}
    heading = "|".join(f"{one} {symbol}" for one in name.split("|"))
    return entry(
        key, name, symbol, "°" if decimals is None else "$r$",
        DEGREE_DECIMALS if decimals is None else decimals, formulas, heading,
        minutes=decimals is None, stroke=side,
    )  # fmt: skip


def value(quantity: Quantity, engine: BeamEngine, method: str) -> arb:
    """Return the quantity in its unit, in degrees or radii, at the precision in force."""
    return ball(quantity.formulas[method].kernel(engine, quantity.stroke))


def certified(
    quantity: Quantity, engine: BeamEngine, method: str, decimals: int, rounding: str, times: int
) -> Number:
    """Return the quantity in its unit, times a factor, correctly rounded to so many decimals.

    No value lies on a rounding boundary, other than the whole ones of an infinite rod. By the book's
    formulas an angle is a rational number over π and a path, 1 - cos of a rational number, transcendental
    (Lindemann). In the true geometry tan ½δ is algebraic, hence δ transcendental (Lindemann). The sagitta
    has at most degree 4 over the rationals, so has sin μ, and sin(ν - μ) has at most 16. A boundary, an odd
    multiple of ½ · 10^-d minutes, is a k/n of a turn with n a multiple of 64, its sine of degree φ(n)/2: 16
    for n = 64, else more. Nor can it be 16, for that field is cyclic and its only subfield of degree 8 would
    hold both cos μ and cos ν, hence sin(ν - μ).
    """
    scaled = settled(lambda _: times * value(quantity, engine, method), decimals, rounding)
    return Number(scaled, decimals)


METHODS = {
    APPROXIMATE: words("Näherungen des § 149|approximations of § 149"),
    EXACT: words("wahre Gestalt des Getriebes|true geometry of the linkage"),
}
ARM = words("Arm des Balanciers a/r|Arm of the beam a/r")
SYMBOLS = words(
    "$r$ Kurbelhalbmesser, $l$ Stangenlänge, $a$ Arm des Balanciers; die Welle liegt unter der Mitte der"
    " Pfeilhöhe seines Bogens"
    "|$r$ crank radius, $l$ length of the rod, $a$ arm of the beam; the shaft lies below the middle of the"
    " sagitta of its arc"
)
SIDES = words(
    "Strecklage: Stange und Kurbel gestreckt; der Abstand $180° + (ν - μ)$ liegt auf der Seite des"
    " Drehpunkts; Wege bis zur senkrechten Kurbel"
    "|stretched: rod and crank in line; the distance $180° + (ν - μ)$ lies on the side of the pivot; paths up"
    " to the vertical crank"
)
SWING = words(
    "der Balancier schwingt gleich weit über und unter die Waagrechte; Wege auf seinem Bogen"
    "|the beam swings alike above and below the horizontal; paths along its arc"
)


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class BeamRequest(Question):
    """What is asked for: the beam engines of all arms (outer) and crank ratios (inner)."""

    arms: tuple[Fraction, ...]
    ratios: tuple[Fraction, ...]
    exact: bool = False

    def check(self) -> None:
        if not self.arms:
            raise ProblemError("no beam arm was given; write one as --beam 3")
        for arm in self.arms:
            for ratio in self.ratios:
                BeamEngine(arm, ratio)

    @property
    def method(self) -> str:
        return EXACT if self.exact else APPROXIMATE

    def methods_of(self, column: LayoutColumn) -> tuple[str, ...]:
        return (self.method,)

    @property
    def caption_parts(self) -> Mapping[str, Label]:
        return {**super().caption_parts, "{method}": METHODS[self.method][self.lang]}


def _arm_axis(question: BeamRequest) -> ListAxis:
    """The arms of the beam in crank radii."""
    decimals = angle_decimals(question.arms)
    return ListAxis(
        question.arms,
        Field("arm", ARM[question.lang], "$a$", "r", decimals),
        lambda arm: f"${plain(arm)}$" if decimals is None else nearest(arm, decimals),
        lambda arm: f"$a = {plain(arm)} r$",
    )


def _number(question: BeamRequest, column: Column, place: Place, times: int) -> Number:
    engine = BeamEngine(question.arms[place["arm"]], question.ratios[place["ratio"]])
    return certified(column.quantity, engine, column.method, column.places, question.rounding, times=times)


def _notes(question: BeamRequest) -> Iterator[Label]:
    lang = question.lang
    if not question.exact:
        printed = (one.formulas[APPROXIMATE].printed for one in registry().values())
        yield ", ".join(filter(None, printed))
    yield SYMBOLS[lang]
    yield SIDES[lang]
    if question.exact:
        yield SWING[lang]


SUBJECT = Subject(
    key="dead centres",
    layout="weisbach-149",
    command="deadcentres",
    axes={"arm": _arm_axis, "ratio": LetteredRatioAxis, "column": ColumnAxis},
    axis_keys=("arm", "ratio"),
    quantities=registry,
    letters=True,
    number=_number,
    notes=_notes,
    limits={"arm": lambda arm: BeamEngine(arm, Fraction(0))},
)
