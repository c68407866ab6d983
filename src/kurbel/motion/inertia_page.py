"""Connecting rods and a layout become a sheet of the greatest forces of a turn and of the models' errors."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache
from typing import Any, NamedTuple

from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact.certify import NEVER_TIES, TieBits, rounded
from kurbel.exact.numerals import Label, Number, degrees_text, nearest, number_text
from kurbel.exact.separation import Separation
from kurbel.kernel.rod import Masses
from kurbel.motion.drive_notes import drive_notes, rod_notes
from kurbel.motion.evaluation import NEEDS, Numbers, numbers_of_balls
from kurbel.motion.inertia import ROD_FORCES, ROD_MODELS, RodForce
from kurbel.motion.inertia_peak import Peak
from kurbel.motion.question import Request
from kurbel.page import axes as page_axes
from kurbel.page import words as page_words
from kurbel.page.arrange import Axis, Grid, Place, check_size
from kurbel.page.layouts import layout
from kurbel.page.old_axes import ColumnAxis, RatioAxis
from kurbel.page.sheet import Heads, Sheet, records_of, table_of
from kurbel.page.table import Cell, Field, Table, Value
from kurbel.page.words import for_ratio
from kurbel.reading.choices import choose
from kurbel.reading.notation import ratio_text

AXIS_KEYS = ("ratio", "force", "model")
FORCES, MODELS = tuple(ROD_FORCES.values()), tuple(ROD_MODELS)
EXACT = "exact"
SHEET = "inertia-errors"
# A page prints degrees and minutes, records degrees.
DEGREE_DECIMALS = 4
WORDS: Mapping[str, Mapping[str, str]] = {
    "force": {"de": "Kraft", "en": "Force"},
    "errors": {
        "de": "größter Fehler in % der größten genauen Kraft der Umdrehung{where}: ",
        "en": "greatest error in % of the greatest exact force of the turn{where}: ",
    },
    "model": {"de": "Ersatz der Stange", "en": "In place of the rod"},
}


class ErrorColumn(NamedTuple):
    """A column of the sheet: of the greatest force of a model, or of its greatest error."""

    key: str
    heading: Mapping[str, Label]
    unit: str
    decimals: int
    of_error: bool = False
    needs: str = "rod"

    @property
    def is_angle(self) -> bool:
        return self.unit == "°"


@cache
def error_columns() -> Mapping[str, ErrorColumn]:
    """Return what the sheet can show, by keys."""
    at = {"de": "bei $φ$", "en": "at $φ$"}
    rows = (
        ErrorColumn("greatest", {"de": "größter Betrag", "en": "greatest"}, "", 4),
        ErrorColumn("greatest_n", {"de": "in N, N m", "en": "in N, N m"}, "N, N m", 1, needs="inertia"),
        ErrorColumn("greatest_phi", at, "°", DEGREE_DECIMALS),
        ErrorColumn("error", {"de": "größter Fehler", "en": "greatest error"}, "", 4, True),
        ErrorColumn(
            "error_percent", {"de": "größter Fehler in %", "en": "greatest error in %"}, "%", 2, True
        ),
        ErrorColumn("error_phi", at, "°", DEGREE_DECIMALS, True),
    )
    return {row.key: row for row in rows}


def error_column_keys() -> tuple[str, ...]:
    """Return what --columns can choose from."""
    return (*AXIS_KEYS, *error_columns())


@dataclass(frozen=True, kw_only=True)
class ErrorsRequest(Sheet):
    """What is asked for: the greatest forces and errors of the rods of these cranks."""

    cranks: tuple[Crank, ...]
    peaks: dict[tuple[int, str, str, bool], Peak] = field(default_factory=dict, compare=False, repr=False)

    def __post_init__(self) -> None:
        super().__post_init__()
        if not self.cranks:
            raise ProblemError("no crank ratio was given; write one as --ratio 1:5")
        for key in self.columns:
            column = error_columns().get(choose(key, error_column_keys(), "column"))
            if column is not None and not self._knows(column):
                options = " and ".join(NEEDS[column.needs])
                raise ProblemError(f"column {key} is in {column.unit} and needs {options}")

    def __len__(self) -> int:
        """How many records there are."""
        return len(self.cranks) * len(FORCES) * len(MODELS)

    def places(self) -> Iterator[Place]:
        for ratio in range(len(self.cranks)):
            for force in range(len(FORCES)):
                for model in range(len(MODELS)):
                    yield {"ratio": ratio, "force": force, "model": model}

    @property
    def shown(self) -> tuple[ErrorColumn, ...]:
        columns = (error_columns()[key] for key in self.chosen() if key not in AXIS_KEYS)
        chosen = tuple(column for column in columns if self._knows(column))
        if not chosen:
            raise ProblemError("there is no column beside the axes; add one, such as greatest")
        return chosen

    def _knows(self, column: ErrorColumn) -> bool:
        known = (crank.rod is not None and crank.rod.mass is not None for crank in self.cranks)
        return column.needs == "rod" or (all(known) and all(crank.speed for crank in self.cranks))

    def peak(self, ratio: int, force: RodForce, model: str, of_error: bool) -> Peak:
        """Return where the force, or the error of the model, is greatest."""
        key = ratio, force.key, model, of_error
        if key not in self.peaks:
            rod = self.cranks[ratio].rod
            assert rod is not None
            masses = rod.masses(model, Fraction)
            if of_error:
                # Forces are sums of shares of the masses, and so are errors.
                true = rod.masses(EXACT, Fraction)
                masses = Masses(*(one - other for one, other in zip(masses, true, strict=True)))
            self.peaks[key] = Peak(force, self.cranks[ratio], masses)
        return self.peaks[key]


def error_notes(request: Request) -> Iterator[Label]:
    """Yield the greatest errors of what a page of forces shows beside the exact ones, a line a crank."""
    shown = [column.quantity for column in request.page_columns]
    models = [model for model in MODELS if model != EXACT and any(one.of == model for one in shown)]
    names = {force.name["en"] for force in FORCES} & {one.name["en"] for one in shown if one.of}
    if not models:
        return
    sheet = ErrorsRequest(
        layout=layout(SHEET), cranks=request.cranks, lang=request.lang, rounding=request.rounding
    )
    column = error_columns()["error_percent"]
    for ratio, crank in enumerate(request.cranks):
        said = []
        for model in models:
            at = {"ratio": ratio, "model": MODELS.index(model)}
            numbers = [
                (force, _number(sheet, column, {**at, "force": place}))
                for place, force in enumerate(FORCES)
                if force.name["en"] in names
            ]
            errors = ", ".join(f"${one.letter}$ ${number_text(error)}$" for one, error in numbers if error)
            said.append(f"{ROD_MODELS[model][request.lang]} {errors}")
        several = len(request.cranks) > 1
        where = for_ratio(crank.ratio, request.lang, request.layout.ratio_symbol) if several else ""
        yield WORDS["errors"][request.lang].format(where=where) + "; ".join(said)


class _ForceAxis(Axis):
    """The forces with their letters and units."""

    def __init__(self, lang: str) -> None:
        super().__init__(len(FORCES))
        self.lang = lang

    def heads(self, place: Place) -> tuple[Label, ...]:
        force = FORCES[place["force"]]
        return (f"{force.name[self.lang]} ${force.letter}/({force.unit})$",)


class _ModelAxis(Axis):
    """The rod itself and what stands in for it."""

    def __init__(self, lang: str) -> None:
        super().__init__(len(MODELS))
        self.lang = lang

    def stub_heading(self) -> Label:
        return ""

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (ROD_MODELS[MODELS[place["model"]]][self.lang],)


def build_errors(request: ErrorsRequest, pages: bool = True) -> Table:
    """Return the sheet that was asked for; without `pages` only its records."""
    caption = request.layout.caption[request.lang].replace("{for_ratio}", _for_ratio(request))
    names = request.columns or (*AXIS_KEYS, *(column.key for column in request.shown))
    records = records_of(len(request), names, _fields(request), lambda: _records(request))
    return table_of(request, caption, _grid(request) if pages else None, records, _notes(request))


def _for_ratio(request: ErrorsRequest) -> Label:
    if len(request.cranks) > 1:
        return ""
    return page_words.for_ratio(request.cranks[0].ratio, request.lang, request.layout.ratio_symbol)


def _notes(request: ErrorsRequest) -> Iterator[Label]:
    yield from (note[request.lang] for note in request.layout.notes)
    yield from drive_notes(request.cranks, request.lang)
    yield from rod_notes(request.cranks, request.lang, [force.letter for force in FORCES])


def _grid(request: ErrorsRequest) -> Grid:
    layout, lang, columns = request.layout, request.lang, request.shown
    ratios = [crank.ratio for crank in request.cranks]
    axes: dict[str, Axis] = {
        "ratio": RatioAxis(layout, ratios, lang),
        "force": _ForceAxis(lang),
        "model": _ModelAxis(lang),
        "column": ColumnAxis(layout, [Heads((), (one.heading[lang],)) for one in columns], ratios, lang),
    }
    check_size(layout, {name: axis.size for name, axis in axes.items()})

    def cell(place: Place) -> Cell:
        column = columns[place["column"]]
        if not column.is_angle:
            return Cell(_number(request, column, place))
        degrees = _angle(request, column, place, 60, 0)
        return Cell(None if degrees is None else f"${degrees_text(Fraction(degrees.scaled, 60))}$")

    return Grid(axes, cell)


def _records(request: ErrorsRequest) -> Iterator[Mapping[str, Value]]:
    """One for each crank, force and model."""
    for place in request.places():
        axes: dict[str, Value] = {
            "ratio": f"${ratio_text(request.cranks[place['ratio']].ratio)}$",
            "force": FORCES[place["force"]].key,
            "model": MODELS[place["model"]],
        }
        yield axes | {column.key: _record(request, column, place) for column in request.shown}


def _record(request: ErrorsRequest, column: ErrorColumn, place: Place) -> Number | None:
    if column.is_angle:
        return _angle(request, column, place, 1, _decimals(request, column))
    return _number(request, column, place)


def _fields(request: ErrorsRequest) -> Mapping[str, Field]:
    lang = request.lang
    fields = {
        "ratio": Field("ratio", page_axes.RATIO[lang], f"${request.layout.ratio_symbol}$"),
        "force": Field("force", WORDS["force"][lang]),
        "model": Field("model", WORDS["model"][lang]),
    }
    for one in request.shown:
        unit = one.unit or "M R ω², M R² ω²"
        fields[one.key] = Field(one.key, full_name(one, lang), "", unit, _decimals(request, one), EXACT)
    return fields


def full_name(column: ErrorColumn, lang: str) -> str:
    """The heading, which needs that of its neighbour where it says too little."""
    first = error_columns()["error" if column.of_error else "greatest"]
    heading = column.heading[lang].replace("$", "")
    own = first.heading[lang]
    return heading if heading.startswith(own) else f"{own} {heading}"


def _decimals(request: ErrorsRequest, column: ErrorColumn) -> int:
    return request.decimals_of(column.decimals)


def _peak(request: ErrorsRequest, column: ErrorColumn, place: Place) -> Peak | None:
    """Return the peak that the column is about; the exact model has no error."""
    model = MODELS[place["model"]]
    if column.of_error and model == EXACT:
        return None
    return request.peak(place["ratio"], FORCES[place["force"]], model, column.of_error)


def _number(request: ErrorsRequest, column: ErrorColumn, place: Place) -> Number | None:
    peak, decimals = _peak(request, column, place), _decimals(request, column)
    if peak is None:
        return None
    whole = request.peak(place["ratio"], peak.force, EXACT, False)
    if column.unit == "%":
        if whole.vanishes:
            return None
        share = peak.share_of(whole)
        if share is not None:
            return nearest(100 * share, decimals, request.rounding)

    def value(numbers: Numbers, of: Any) -> Any:
        if column.unit == "%":
            return 100 * of(peak) / of(whole)
        return of(peak) * peak.force.scale(peak.crank, numbers) if column.needs == "inertia" else of(peak)

    concerned = (peak, whole) if column.unit == "%" else (peak,)
    exact = all(one.separation() is not None for one in concerned) and not _by_turns(column, peak.crank)

    def tie_bits(boundary: Fraction) -> float:
        bound = value(Numbers(Separation.rational), Peak.separation)
        return float((bound - Separation.rational(boundary)).bits())

    ties: TieBits | None = tie_bits if exact else NEVER_TIES
    scaled = rounded(lambda: value(numbers_of_balls(), Peak.value), decimals, request.rounding, ties)
    return Number(scaled, decimals)


def _by_turns(column: ErrorColumn, crank: Crank) -> bool:
    """Whether the value has a factor π², which no algebraic number makes up for."""
    return column.needs == "inertia" and crank.speed is not None and crank.speed.turns


def _angle(
    request: ErrorsRequest, column: ErrorColumn, place: Place, share: int, decimals: int
) -> Number | None:
    """Return where it is greatest, in parts of a degree."""
    peak = _peak(request, column, place)
    if peak is None or peak.is_level:
        return None
    exact = peak.exact_degrees
    if exact is not None:
        return nearest(share * exact, decimals, request.rounding)

    def scaled() -> Any:
        return share * peak.degrees()

    return Number(rounded(scaled, decimals, request.rounding, NEVER_TIES), decimals)
