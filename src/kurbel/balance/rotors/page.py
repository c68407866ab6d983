"""Rotating masses and a layout become a table of what they leave and of what balances them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from typing import Any

from kurbel.balance.rotors.lines import Line, Places, lines, on
from kurbel.balance.rotors.rotor import Rotor
from kurbel.balance.rotors.unknown import Solution, solved
from kurbel.balance.vector import EXACT_ZERO, ONE, Scale, Vector, direction, is_zero, printed
from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Label, Number, given
from kurbel.motion.captions import turns_label
from kurbel.page.axes import ColumnAxis, ListAxis, Place
from kurbel.page.quantity import Column, Formula, Quantity, Words, entry, words
from kurbel.page.subject import Question, Subject
from kurbel.page.table import Field
from kurbel.reading.amounts import amount
from kurbel.reading.units import Speed

ANGLE = "angle"
ANGLE_DECIMALS = 2
# Units of pages over those of the SI.
_SCALES = {"radius_mm": Fraction(1000), "plane_mm": Fraction(1000)}
# What planes and a speed tell.
_OF_PLANES, _OF_SPEED = "planes", "speed"
NEEDS: Mapping[str, tuple[str, ...]] = {_OF_PLANES: ("--planes",), _OF_SPEED: ("--speed",)}
_COUPLES = ("couple", "left_couple")
WORDS: Mapping[str, Words] = {
    "line": words("Masse|Mass"),
    "mass": words("{number}"),
    "unbalance": words("Unwucht|Unbalance"),
    "couple": words("Moment|Couple"),
    "balance": words("Ausgleich {number}|Balance {number}"),
    "left_unbalance": words("bleibende Unwucht|Unbalance left"),
    "left_couple": words("bleibendes Moment|Couple left"),
    "bearing": words("Lager {number}|Bearing {number}"),
    "solution": words("Lösung|Solution"),
    "what_left": words(": Unwucht|: unbalance"),
    "what_balanced": words(": Ausgleich in gegebenen Ebenen|: balance in given planes"),
    "what_static": words(": Ausgleich der Kräfte|: static balance"),
    "what_complete": words(": vollständiger Ausgleich|: complete balance"),
    "angles": words(
        "Winkel zählen im Drehsinn von der Richtung 0°|Angles count in the sense of rotation from the"
        " direction 0°"
    ),
    "planes": words(
        "; Momente um die Ebene bei {about}, in der Richtung der Kräfte des Paares"
        "|; moments about the plane at {about}, in the direction of the forces of the couple"
    ),
    "speed": words(
        "Kräfte und Momente auf die Welle mit $ω^2$: {speed}"
        "|Forces and moments on the shaft with $ω^2$: {speed}"
    ),
    "zero": words("0 ohne Dezimalen ist genau 0|0 without decimals is exactly 0"),
}


@cache
def quantities() -> Mapping[str, Quantity]:
    """Return the columns by their keys."""
    rows = (
        ("mass_kg", "Masse|Mass", "$m$", "kg", None, ""),
        ("radius_mm", "Halbmesser des Schwerpunkts|Radius of the centre of mass", "$r$", "mm", None, ""),
        (ANGLE, "Winkel|Angle", "$α$", "°", ANGLE_DECIMALS, ""),
        ("plane_mm", "Lage der Ebene|Position of the plane", "$z$", "mm", None, _OF_PLANES),
        ("unbalance_kgm", "Unwucht|Unbalance", "$m r$", "kg m", None, ""),
        ("moment_kgm2", "Moment der Unwucht|Moment of the unbalance", "$m r l$", "kg m²", None, _OF_PLANES),
        ("unbalance_n", "Fliehkraft|Centrifugal force", "$m r ω^2$", "N", None, _OF_SPEED),
        (
            "moment_nm", "Moment der Fliehkraft|Moment of the centrifugal force", "$m r l ω^2$", "N m", None,
            _OF_SPEED,
        ),
    )  # fmt: skip
    found = {}
    for key, name, symbol, unit, decimals, needs in rows:
        field = key.partition("_")[0]
        formulas = {"exact": Formula(_field(field))}
        found[key] = entry(key, name, symbol, unit, decimals, formulas, needs=needs)
    return found


def _field(name: str) -> Any:
    return lambda line: getattr(line, name)


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class RotorRequest(Question):
    """What is asked for: the lines of the masses of a shaft; `planar` where their planes are not known."""

    rotor: Rotor
    places: Places
    speed: Speed | None = None
    planar: bool = False

    no_column = "there is no column beside the axes; add one, such as unbalance_kgm"

    def check(self) -> None:
        _ = self.lines

    @cached_property
    def solutions(self) -> tuple[Solution, ...]:
        return solved(self.rotor.masses)

    @cached_property
    def lines(self) -> tuple[tuple[Line, ...], ...]:
        """The lines of every solution."""
        return tuple(
            tuple(
                one
                for one in lines(self.rotor, solution, self.places)
                if not (self.planar and one.key in _COUPLES)
            )
            for solution in self.solutions
        )

    def missing(self, quantity: Quantity) -> str:
        lacks = [_OF_PLANES] * (self.planar and quantity.key in ("plane_mm", "moment_kgm2", "moment_nm"))
        lacks += [_OF_SPEED] * (quantity.needs == _OF_SPEED and self.speed is None)
        if not lacks:
            return ""
        return f"column {quantity.key} needs {' and '.join(one for lack in lacks for one in NEEDS[lack])}"


def _number(question: RotorRequest, column: Column, place: Place, times: int) -> Number | None:
    line = question.lines[place["solution"]][place["line"]]
    key = column.quantity.key
    own = quantities()[key]
    value = own.formulas["exact"].kernel(line)
    if value is None:
        return None
    if key == ANGLE:
        return _angle(value, column.places, question.rounding)
    scale = ONE
    if own.needs == _OF_SPEED:
        assert question.speed is not None
        scale = Scale.speed(question.speed, 2)
    unit = _SCALES.get(key, Fraction(1)) * question.of_page(own.unit["en"])
    return known_number(value, scale.times(unit), column.decimals, question.rounding)


def _angle(value: Fraction | Vector, decimals: int, rounding: str) -> Number | None:
    if isinstance(value, Vector):
        return direction(value, decimals, rounding)
    exact = given(value, None, rounding)
    return exact if exact.decimals <= decimals else given(value, decimals, rounding)


def known_number(value: Any, scale: Scale, decimals: int | None, rounding: str) -> Number:
    """Return a value that is known, times a scale, correctly rounded; 0 where it is proved to be 0.

    With a transcendental factor in its scale it is not 0.
    """
    if isinstance(value, Fraction):
        if not value:
            return EXACT_ZERO
        if not scale.turns:
            return given(value * scale.value, decimals, rounding)
    elif scale.factor is None and is_zero(value):
        return EXACT_ZERO

    def scaled(kind: Kind) -> Any:
        return scale.on(kind) * on(value, kind)

    return printed(scaled, decimals, rounding, not scale.turns)


def _solution_axis(question: RotorRequest) -> ListAxis:
    """The ways in which the masses can stand."""
    name = WORDS["solution"][question.lang]
    return ListAxis(
        range(1, len(question.solutions) + 1),
        Field("solution", name, "", "", 0),
        lambda number: Number(number, 0),
        lambda number: f"{name} {number}",
    )


def _line_axis(question: RotorRequest) -> ListAxis:
    """Masses, balancing masses, bearings and sums, of which every solution has the same."""
    return ListAxis(
        question.lines[0],
        Field("line", WORDS["line"][question.lang]),
        lambda line: f"{line.key}_{line.number}" if line.number else line.key,
        lambda line: WORDS[line.key][question.lang].format(number=line.number),
    )


def _caption(question: RotorRequest) -> Label:
    what = "left"
    if question.places.balance:
        what = "balanced"
    elif any(None in one for one in question.rotor.masses):
        what = "complete" if _is_complete(question) else "static"
    return question.layout.caption[question.lang].replace("{what}", WORDS[f"what_{what}"][question.lang])


def _is_complete(question: RotorRequest) -> bool:
    """Whether neither a force nor a couple is left."""
    (*_, couple) = (
        (line for line in question.lines[0] if line.key == "couple") if not question.planar else (None,)
    )
    return couple is not None and couple.moment == 0


def _notes(question: RotorRequest) -> Iterator[Label]:
    lang, about = question.lang, question.rotor.about
    planes = ""
    if not question.planar:
        planes = WORDS["planes"][lang].format(about=f"$z = {amount(about, 'mm')}$")
    yield WORDS["angles"][lang] + planes
    if question.speed is not None:
        yield WORDS["speed"][lang].format(speed=turns_label(question.speed))
    yield WORDS["zero"][lang]


SUBJECT = Subject(
    key="rotor",
    layout="rotor",
    command="rotor",
    axes={"solution": _solution_axis, "line": _line_axis, "column": ColumnAxis},
    axis_keys=("solution", "line"),
    own_first=False,
    quantities=quantities,
    number=_number,
    caption=_caption,
    notes=_notes,
    options=NEEDS,
)
