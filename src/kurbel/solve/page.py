"""Conditions on crank drives and a layout become a table of the crank angles at which they hold."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, degrees_text
from kurbel.linkage.arc_drive import PATH_SHARE
from kurbel.linkage.quantities import arc_registry
from kurbel.motion.drives import Drive, Shown, SlideDrive
from kurbel.motion.evaluation import NEEDS, OUT, RETURN, STROKES
from kurbel.motion.quantities import registry
from kurbel.page import axes as page_axes
from kurbel.page.arrange import Axis, Grid, Place, check_size
from kurbel.page.old_axes import ColumnAxis, RatioAxis
from kurbel.page.sheet import Heads, Sheet, records_of, table_of
from kurbel.page.table import Cell, Field, Table, Value
from kurbel.reading.choices import choose
from kurbel.reading.notation import ratio_text
from kurbel.reading.where import Condition
from kurbel.solve import captions
from kurbel.solve.solve import MEASURES, Root, column_of, solve

AXIS_KEYS = ("ratio", "condition", "stroke", "phi")
PHI, TURN = "phi", "phi_turn"
# What stands for a stroke in records.
STROKE_KEYS = {OUT: "outstroke", RETURN: "return"}
# A page prints degrees and minutes, records degrees.
DEGREE_DECIMALS = 4


@dataclass(frozen=True, kw_only=True)
class SolveRequest(Sheet):
    """What is asked for: where these drives, alike but for their ratios, fulfil the conditions."""

    drives: tuple[Drive, ...]
    conditions: tuple[Condition, ...]

    def __post_init__(self) -> None:
        super().__post_init__()
        if not self.drives:
            raise ProblemError("no crank ratio was given; write one as --ratio 1:5")
        if not self.conditions:
            raise ProblemError('no condition was given; write one as --where p=0 or --where "s = 25%"')
        for key in self.columns:
            if choose(key, solve_column_keys(), "column") not in (*AXIS_KEYS, TURN, *self._known):
                raise ProblemError(_unknown(key))
        for condition in self.conditions:
            self._check(condition)

    def __len__(self) -> int:
        """How many records there are."""
        return sum(map(len, self.found.values()))

    @property
    def method(self) -> str:
        return self.drives[0].method

    @property
    def cranks(self) -> tuple[Crank, ...]:
        """The straight or offset cranks."""
        return tuple(drive.crank for drive in self.drives if isinstance(drive, SlideDrive))

    @property
    def shown(self) -> tuple[str, ...]:
        """Return the columns of values: those asked for, else the layout's and those of the conditions."""
        if self.columns:
            return tuple(key for key in dict.fromkeys(self.columns) if key not in AXIS_KEYS)
        asked = (column_of(self.drives[0], condition) for condition in self.conditions)
        own = (column.quantity for column in self.layout.columns if column.unless not in self._known)
        return tuple(dict.fromkeys(key for key in (*own, *asked) if key == TURN or key in self._known))

    @cached_property
    def found(self) -> Mapping[tuple[int, int, int], Sequence[Root]]:
        """Return what was found by the places of ratio and condition, and the stroke."""
        found: dict[tuple[int, int, int], list[Root]] = {}
        for ratio, drive in enumerate(self.drives):
            for condition, asked in enumerate(self.conditions):
                for root in solve(drive, asked):
                    found.setdefault((ratio, condition, root.stroke), []).append(root)
        return found

    @property
    def _known(self) -> Mapping[str, Shown]:
        return self.drives[0].columns

    def _check(self, condition: Condition) -> None:
        quantity = condition.quantity
        if condition.unit and MEASURES[quantity].column not in self._known:
            options = " and ".join(NEEDS[registry()[MEASURES[quantity].column].needs])
            raise ProblemError(f'condition "{condition}" is in {condition.unit} and needs {options}')
        if self.drives[0].column_of(quantity) not in self._known:
            raise ProblemError(f'method "{self.method}" has no formula for {quantity}; use exact')


def _unknown(key: str) -> str:
    """Return why a column cannot be shown."""
    quantity = registry().get(key)
    if quantity is None or not quantity.needs:
        return f"column {key} belongs to another mechanism or method; leave it out"
    return f"column {key} is in {quantity.unit['en']} and needs {' and '.join(NEEDS[quantity.needs])}"


def solve_column_keys() -> tuple[str, ...]:
    """Return what --columns can choose from; everything counts from the dead centre of its stroke."""
    of_slide = (key for key, quantity in registry().items() if quantity.stroke == OUT)
    of_arc = (key for key, quantity in arc_registry().items() if quantity.stroke == OUT)
    return (*AXIS_KEYS, TURN, *of_slide, *of_arc, PATH_SHARE)


def own_columns() -> Mapping[str, Mapping[str, str]]:
    """Return the columns that no other page has, with their names."""
    keys = ("condition", "stroke", TURN, PATH_SHARE)
    return {key: captions.WORDS[key] for key in keys}


class _ConditionAxis(Axis):
    """The conditions in letters."""

    def __init__(self, request: SolveRequest) -> None:
        super().__init__(len(request.conditions))
        self.request = request

    def heads(self, place: Place) -> tuple[Label, ...]:
        condition = self.request.conditions[place["condition"]]
        return (captions.condition_label(condition, self.request.drives[0], self.request.lang),)


class _StrokeAxis(Axis):
    """Outstroke and return stroke."""

    def __init__(self, lang: str) -> None:
        super().__init__(len(STROKES))
        self.lang = lang

    def stub_heading(self) -> Label:
        return ""

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (STROKES[_stroke(place)][self.lang],)


class _RootAxis(Axis):
    """The crank angles on a stroke, in degrees and minutes."""

    def __init__(self, request: SolveRequest) -> None:
        super().__init__(max(map(len, request.found.values())))
        self.request = request

    def stub_heading(self) -> Label:
        return f"${self.request.layout.angle_symbol}$"

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (_minutes(self.request, place, over_turn=False),)


class _RootGrid(Grid):
    """A grid with the places that there are: not every stroke has as many roots."""

    def __init__(self, request: SolveRequest, axes: Mapping[str, Axis]) -> None:
        super().__init__(axes, lambda place: _cell(request, place))
        self.request = request

    def places(self, names: Sequence[str]) -> list[Place]:
        places = super().places(names)
        if "root" not in names:
            return places
        return [place for place in places if place["root"] < len(_roots(self.request, place))]


def build_solve(request: SolveRequest, pages: bool = True) -> Table:
    """Return the table that was asked for; without `pages` only its records."""
    names = request.columns or (*AXIS_KEYS, *request.shown)
    records = records_of(len(request), names, _fields(request), lambda: _records(request))
    grid = _grid(request) if pages else None
    return table_of(request, captions.caption(request), grid, records, captions.notes(request))


def _grid(request: SolveRequest) -> Grid:
    layout, lang = request.layout, request.lang
    ratios = [drive.ratio for drive in request.drives]
    if not request.shown:
        raise ProblemError("there is no column beside the angle; add one, such as phi_turn or x")
    axes: dict[str, Axis] = {
        "ratio": RatioAxis(layout, ratios, lang),
        "condition": _ConditionAxis(request),
        "stroke": _StrokeAxis(lang),
        "root": _RootAxis(request),
        "column": ColumnAxis(
            layout, [Heads((), _heading(request, key)) for key in request.shown], ratios, lang
        ),
    }
    check_size(layout, {name: axis.size for name, axis in axes.items()})
    return _RootGrid(request, axes)


def _heading(request: SolveRequest, key: str) -> tuple[Label, ...]:
    own = {column.quantity: column.heading for column in request.layout.columns}
    lines = own.get(key)
    if lines is not None:
        return tuple(line[request.lang] for line in lines)
    return (request.drives[0].columns[key].heading[request.lang],)


def _stroke(place: Place) -> int:
    return tuple(STROKES)[place["stroke"]]


def _roots(request: SolveRequest, place: Place) -> Sequence[Root]:
    return request.found.get((place["ratio"], place["condition"], _stroke(place)), ())


def _cell(request: SolveRequest, place: Place) -> Cell:
    key = request.shown[place["column"]]
    if key == TURN:
        return Cell(_minutes(request, place, over_turn=True))
    root = _roots(request, place)[place["root"]]
    return Cell(root.number(key, _decimals(request, key), request.rounding))


def _minutes(request: SolveRequest, place: Place, over_turn: bool) -> Label:
    root = _roots(request, place)[place["root"]]
    minutes = root.angle(over_turn, 60, 0, request.rounding)
    return f"${degrees_text(Fraction(minutes.scaled, 60))}$"


def _records(request: SolveRequest) -> Iterator[Mapping[str, Value]]:
    """One for each root, in the order of ratios, conditions and the turn."""
    decimals = _decimals(request, PHI)
    for (ratio, condition, stroke), roots in request.found.items():
        for root in roots:
            values: dict[str, Value] = {
                "ratio": f"${ratio_text(request.drives[ratio].ratio)}$",
                "condition": str(request.conditions[condition]),
                "stroke": STROKE_KEYS[stroke],
                PHI: root.angle(False, 1, decimals, request.rounding),
                TURN: root.angle(True, 1, decimals, request.rounding),
            }
            for key in request.shown:
                if key != TURN:
                    values[key] = root.number(key, _decimals(request, key), request.rounding)
            yield values


def _fields(request: SolveRequest) -> Mapping[str, Field]:
    lang, symbol = request.lang, f"${request.layout.angle_symbol}$"
    decimals, method = _decimals(request, PHI), request.method
    fields = {
        "ratio": Field("ratio", page_axes.RATIO[lang], f"${request.layout.ratio_symbol}$"),
        "condition": Field("condition", captions.WORDS["condition"][lang]),
        "stroke": Field("stroke", captions.WORDS["stroke"][lang]),
        PHI: Field(PHI, page_axes.PHI[lang], symbol, "°", decimals, method),
        TURN: Field(TURN, captions.WORDS[TURN][lang], symbol, "°", decimals, method),
    }
    for key in request.shown:
        if key != TURN:
            one = request.drives[0].columns[key]
            fields[key] = Field(
                key, one.name[lang], one.symbol, one.unit[lang], _decimals(request, key), method
            )
    return fields


def _decimals(request: SolveRequest, key: str) -> int:
    return request.decimals_of(
        DEGREE_DECIMALS if key in (PHI, TURN) else request.drives[0].columns[key].decimals
    )
