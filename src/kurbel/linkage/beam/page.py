"""The pages of beam engines: their dead centres."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, Number, nearest
from kurbel.linkage.beam.engine import APPROXIMATE, EXACT, BeamEngine, certified, registry
from kurbel.page.axes import ColumnAxis, LetteredRatioAxis, ListAxis, Place, angle_decimals
from kurbel.page.layouts import LayoutColumn
from kurbel.page.quantity import Column, filled, words
from kurbel.page.subject import Question, Subject
from kurbel.page.table import Field
from kurbel.reading.notation import plain

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


def _caption(question: BeamRequest) -> Label:
    lang = question.lang
    return filled(question.layout.caption[lang], [("{method}", METHODS[question.method][lang])])


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
    caption=_caption,
    notes=_notes,
    limits={"arm": lambda arm: BeamEngine(arm, Fraction(0))},
)
