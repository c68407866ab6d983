"""Drives, shares of the stroke and a layout become a table over the piston's path, both strokes side by side.

other.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property

from kurbel.conditions.solve import Root, at_share
from kurbel.conditions.solve_page import DEGREE_DECIMALS, counted
from kurbel.drive.mechanisms import MECHANISMS
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, Number, exact_text
from kurbel.motion.captions import formula_lines, signed, strokes_of
from kurbel.motion.drives import Drive
from kurbel.motion.evaluation import OUT, RETURN, STROKES, TURN, method_named, unknown
from kurbel.motion.mechanism import mechanism
from kurbel.motion.motion_page import DriveQuestion
from kurbel.motion.motion_quantities import registry
from kurbel.page.axes import Axis, ColumnAxis, Place, RatioAxis, angle_decimals, angle_number
from kurbel.page.layouts import LayoutColumn
from kurbel.page.quantity import Column, Quantity, Texts, bare, filled, words
from kurbel.page.subject import Subject, subject
from kurbel.page.table import Field
from kurbel.reading.notation import about

WORDS = Texts("conditions", "over")
# The angle at a path by the triangle of crank, rod and slide; of the return stroke it is the outer angle.
_TRIANGLE = {
    "+": "$cos {angle} = (R^2 + y^2 - L^2)/(2 R y)$, $y = R + L - x$",
    "-": "$cos {angle} = (L^2 - R^2 - y^2)/(2 R y)$, $y = L - R + x$",
    "±": "$cos {angle} = ±(R^2 + y^2 - L^2)/(2 R y)$, $y = L ± (R - x)$",
}


def notes(question: PathRequest) -> Iterator[Label]:
    """Yield the lines below the table: from where it counts, how the angle follows, formulas, lengths."""
    lang, drives, layout = question.lang, question.drives, question.layout
    yield counted(WORDS, drives, lang)
    if layout.formulas:
        yield from _formulas(question)
    if mechanism(question.mechanism).crosshead:
        # Pages of the others say it among their own lines.
        said = (one.quantity.direction[lang] for one in question.page_columns if one.quantity.direction)
        if directions := "; ".join(dict.fromkeys(said)):
            yield directions
    yield from drives[0].closing_lines(question)


def _formulas(question: PathRequest) -> Iterator[Label]:
    """Yield how the angle follows from the path, then the formulas of the columns."""
    known = registry()
    strokes = {column.quantity.stroke for column in question.page_columns}
    paths = (known[key] for key in ("x", "x_return") if known[key].stroke in strokes)
    shown = [bare(one, question.method, one.decimals) for one in paths]
    columns: list[Column] = [*shown, *(one for one in question.page_columns if one.key in known)]
    drive = question.drives[0]
    finite = any(one.ratio for one in question.drives)
    if drive.is_straight and drive.method == "exact" and finite and question.mechanism == "straight":
        _, sign = strokes_of(shown)
        yield signed(_TRIANGLE[sign], question, sign, False) + WORDS["between"][question.lang]
    if mechanism(question.mechanism).crosshead:
        yield from formula_lines(question, columns)


# Every row takes two roots; beyond these it is minutes.
MOST_SHARES = 10_001
_BACK = "_return"
_PHI, _TURN = "phi", "phi_turn"


def _angle(key: str, stroke: int, name: str) -> Quantity:
    part = STROKES[stroke]
    return Quantity(
        key=key,
        name=words(name),
        symbol="$φ$",
        unit=words("°"),
        decimals=DEGREE_DECIMALS,
        formulas={},
        heading=words("$φ$"),
        spanners=(words(name), part),
        part=part,
        minutes=True,
        stroke=stroke,
    )


ANGLES: Mapping[str, Quantity] = {
    f"{key}{back}": _angle(f"{key}{back}", stroke, name)
    for key, name in (
        (_PHI, "Kurbelwinkel|Crank angle"),
        (_TURN, "Kurbelwinkel in der Umdrehung|Crank angle over the turn"),
    )
    for back, stroke in (("", OUT), (_BACK, RETURN))
}
"""The angles at which the path is reached, of the stroke and over the turn."""


@cache
def quantities_of(name: str) -> Mapping[str, Quantity]:
    """Return what can stand over the path of a mechanism, on both strokes."""
    chosen = mechanism(name)
    outward = chosen.conditions()
    known = {**subject(chosen.subject).quantities(), **outward}
    return {
        key: one for key, one in known.items() if one.stroke != TURN and key.replace(_BACK, "") in outward
    }


@cache
def quantities() -> Mapping[str, Quantity]:
    """Return what pages can show of all drives."""
    found = dict(ANGLES)
    for name in MECHANISMS:
        for key, one in quantities_of(name).items():
            # What several have is called as the first of them calls it.
            found.setdefault(key, one)
    return found


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class PathRequest(DriveQuestion):
    """What is asked for: drives, alike but for their ratios, at shares of both strokes."""

    drives: tuple[Drive, ...]
    shares: Sequence[Fraction]
    mechanism: str = "straight"

    no_column = "there is no column beside the share of the stroke; add one, such as phi or c"

    def check(self) -> None:
        super().check()
        if not self.shares:
            raise ProblemError("no share of the stroke was given; write them as '0;50%;100%' or --step 5%")
        if len(self.shares) > MOST_SHARES:
            raise ProblemError(
                f"{len(self.shares)} shares of the stroke were asked for; at most {MOST_SHARES} are solved,"
                " so make the step larger"
            )
        for share in self.shares:
            if not 0 <= share <= 1:
                percent = f"; write {about(share)}%" if 2 <= share <= 100 else ""
                raise ProblemError(
                    f"share of the stroke is {about(share)}; it must lie within 0..1, that is 0%..100%"
                    f"{percent}"
                )

    @property
    def method(self) -> str:
        return self.drives[0].method

    def too_long(self) -> str:
        return f"{len(self.drives)} ratios at {len(self.shares)} shares make a table of {len(self)} rows"

    @cached_property
    def _found(self) -> dict[tuple[int, int, int], Root]:
        return {}

    def root(self, ratio: int, share: int, stroke: int) -> Root:
        """Return where the piston has gone a share of a stroke."""
        key = (ratio, share, stroke)
        if key not in self._found:
            self._found[key] = at_share(self.drives[ratio], self.shares[share], stroke)
        return self._found[key]

    def entry(self, key: str) -> Quantity:
        return ANGLES.get(key) or quantities_of(self.mechanism).get(key) or super().entry(key)

    def missing(self, quantity: Quantity) -> str:
        if self.knows(quantity.key):
            return ""
        if quantity.key in quantities_of(self.mechanism):
            formulaless = f'method "{self.method}" has no formula for {quantity.key}; use exact'
            return unknown(quantity) if quantity.needs else formulaless
        return f"column {quantity.key} belongs to another mechanism; leave it out"

    def knows(self, key: str) -> bool:
        return key in ANGLES or (
            key in quantities_of(self.mechanism) and key.replace(_BACK, "") in self.drives[0].columns
        )

    def methods_of(self, column: LayoutColumn) -> tuple[str, ...]:
        return (self.method,)

    @property
    def caption_parts(self) -> Mapping[str, Label]:
        return {**super().caption_parts, "{method}": method_named(self.method).caption[self.lang]}

    @property
    def filled_caption(self) -> Label:
        """The layout's caption, or one for columns that are not the layout's, which that may not know."""
        own = {column.key for column in self.layout.columns}
        if not self.columns or {column.key for column in self.page_columns} <= own:
            return super().filled_caption
        return filled(WORDS["caption"][self.lang], self.caption_parts.items())


class _ShareAxis(Axis):
    """Shares of the stroke, on pages in hundredths."""

    key = "share"

    def __init__(self, question: PathRequest) -> None:
        super().__init__(len(question.shares))
        self.shares, self.lang = question.shares, question.lang
        self.decimals = angle_decimals(self.shares)
        self.hundredths = angle_decimals([100 * share for share in self.shares])

    def field(self) -> Field:
        return Field("share", WORDS["share"][self.lang], "$x/S$", "", self.decimals)

    def value(self, place: Place) -> Number:
        return angle_number(self.shares[place["share"]], self.decimals)

    def stub_heading(self) -> Label:
        return "$x/S$ in %"

    def heads(self, place: Place) -> tuple[Label, ...]:
        share = self.shares[place["share"]]
        return (f"$x/S = {exact_text(100 * share)} %$",)

    def stub(self, place: Place) -> Number | Label:
        share = 100 * self.shares[place["share"]]
        return f"${exact_text(share)}$" if self.hundredths is None else angle_number(share, self.hundredths)


def _number(question: PathRequest, column: Column, place: Place, times: int) -> Number:
    root = question.root(place["ratio"], place["share"], column.quantity.stroke)
    if column.key in ANGLES:
        return root.angle(column.key.startswith(_TURN), times, column.places, question.rounding)
    units, own = question.units, question.entry(column.key).plain_unit("en")
    parts = Fraction(1) if units is None else units.times(own)
    return root.number(column.key.replace(_BACK, ""), column.places, question.rounding, times * parts)


def _listed() -> Iterator[tuple[str, Quantity]]:
    yield from (("table --angle s=50%", one) for one in ANGLES.values())


MOTION = Subject(
    key="over path",
    layout="over-path",
    command="table --angle s=50%",
    axes={"ratio": RatioAxis, "share": _ShareAxis, "column": ColumnAxis},
    axis_keys=("ratio", "share"),
    quantities=quantities,
    number=_number,
    notes=notes,
    listed=_listed,
    drawn="kurbel.plot.over_path:over_path",
)
# The same of forces.
FORCES = MOTION._replace(
    key="forces over path", layout="forces-path", command="forces --angle s=50%", listed=tuple
)
