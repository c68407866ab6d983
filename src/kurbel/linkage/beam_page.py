"""Beam engines and a layout become a table of their dead centres."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction

from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, Number, degrees_text, nearest
from kurbel.linkage.beam import MINUTES, BeamEngine, BeamQuantity, certified, registry
from kurbel.page import axes as page_axes
from kurbel.page.angles import angle_decimals
from kurbel.page.arrange import Axis, Grid, Place, check_size
from kurbel.page.old_axes import ColumnAxis
from kurbel.page.sheet import Heads, LetteredRatioAxis, Sheet, records_of, table_of
from kurbel.page.table import Cell, Field, Table, Value
from kurbel.reading.choices import choose
from kurbel.reading.notation import plain, ratio_text

AXIS_KEYS = ("arm", "ratio")
# A page prints degrees and minutes, records degrees.
DEGREE_DECIMALS = 4
FORMULAS = "$μ = r^2/(4 a (l + r))$, $ν = r^2/(4 a (l - r))$, $σ_1 = r (1 - cos μ)$, $σ_2 = r (1 - cos ν)$"
WORDS: Mapping[str, Mapping[str, str]] = {
    "approximate": {"de": "Näherungen des § 149", "en": "approximations of § 149"},
    "exact": {"de": "wahre Gestalt des Getriebes", "en": "true geometry of the linkage"},
    "formulas": {"de": FORMULAS, "en": FORMULAS},
    "symbols": {
        "de": "$r$ Kurbelhalbmesser, $l$ Stangenlänge, $a$ Arm des Balanciers; die Welle liegt unter der"
        " Mitte der Pfeilhöhe seines Bogens",
        "en": "$r$ crank radius, $l$ length of the rod, $a$ arm of the beam; the shaft lies below the middle"
        " of the sagitta of its arc",
    },
    "sides": {
        "de": "Strecklage: Stange und Kurbel gestreckt; der Abstand $180° + (ν - μ)$ liegt auf der Seite des"
        " Drehpunkts; Wege bis zur senkrechten Kurbel",
        "en": "stretched: rod and crank in line; the distance $180° + (ν - μ)$ lies on the side of the pivot;"
        " paths up to the vertical crank",
    },
    "true": {
        "de": "der Balancier schwingt gleich weit über und unter die Waagrechte; Wege auf seinem Bogen",
        "en": "the beam swings alike above and below the horizontal; paths along its arc",
    },
    "arm": {"de": "Arm des Balanciers a/r", "en": "Arm of the beam a/r"},
}


@dataclass(frozen=True, kw_only=True)
class BeamRequest(Sheet):
    """What is asked for: the beam engines of all arms (outer) and crank ratios (inner)."""

    arms: tuple[Fraction, ...]
    ratios: tuple[Fraction, ...]
    exact: bool = False

    def __post_init__(self) -> None:
        super().__post_init__()
        for key in self.columns:
            choose(key, beam_column_keys(), "column")
        for place in self.places():
            self.engine(place)

    def __len__(self) -> int:
        """How many records there are."""
        return len(self.arms) * len(self.ratios)

    def places(self) -> Iterator[Place]:
        for arm in range(len(self.arms)):
            for ratio in range(len(self.ratios)):
                yield {"arm": arm, "ratio": ratio}

    def engine(self, place: Place) -> BeamEngine:
        return BeamEngine(self.arms[place["arm"]], self.ratios[place["ratio"]])

    @property
    def quantities(self) -> tuple[BeamQuantity, ...]:
        chosen = tuple(registry()[key] for key in self.chosen() if key not in AXIS_KEYS)
        if not chosen:
            raise ProblemError("there is no column beside the axes; add one, such as mu")
        return chosen


def beam_column_keys() -> tuple[str, ...]:
    """Return what --columns can choose from."""
    return (*AXIS_KEYS, *registry())


class _ArmAxis(Axis):
    """The arms of the beam in crank radii."""

    def __init__(self, request: BeamRequest) -> None:
        super().__init__(len(request.arms))
        self.request = request

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (f"$a = {plain(self.request.arms[place['arm']])} r$",)


def build_beam(request: BeamRequest, pages: bool = True) -> Table:
    """Return the table that was asked for; without `pages` only its records."""
    lang = request.lang
    caption = request.layout.caption[lang].replace("{method}", WORDS[_method(request)][lang])
    names = request.columns or (*AXIS_KEYS, *(quantity.key for quantity in request.quantities))
    records = records_of(len(request), names, _fields(request), lambda: _records(request))
    notes = (WORDS[key][lang] for key in _notes(request))
    return table_of(request, caption, _grid(request) if pages else None, records, notes)


def _method(request: BeamRequest) -> str:
    return "exact" if request.exact else "approximate"


def _notes(request: BeamRequest) -> Iterator[str]:
    if not request.exact:
        yield "formulas"
    yield "symbols"
    yield "sides"
    if request.exact:
        yield "true"


def _grid(request: BeamRequest) -> Grid:
    layout, lang, quantities = request.layout, request.lang, request.quantities
    headed = [Heads((), (f"{one.name[lang]} {one.symbol}",)) for one in quantities]
    axes = {
        "arm": _ArmAxis(request),
        "ratio": LetteredRatioAxis(layout, request.ratios, lang),
        "column": ColumnAxis(layout, headed, request.ratios, lang),
    }
    check_size(layout, {name: axis.size for name, axis in axes.items()})

    def cell(place: Place) -> Cell:
        return _cell(request, quantities[place["column"]], request.engine(place))

    def unit(place: Place) -> Label:
        one = quantities[place["column"]]
        return "" if one.unit == MINUTES else f"${one.unit}$"

    return Grid(axes, cell, unit if layout.unit else None)


def _cell(request: BeamRequest, quantity: BeamQuantity, engine: BeamEngine) -> Cell:
    if quantity.unit == MINUTES:
        minutes = certified(quantity, engine, request.exact, 0, request.rounding)
        return Cell(f"${degrees_text(Fraction(minutes.scaled, 60))}$")
    decimals = request.decimals_of(quantity.decimals)
    return Cell(certified(quantity, engine, request.exact, decimals, request.rounding))


def _records(request: BeamRequest) -> Iterator[Mapping[str, Value]]:
    """One for each beam engine."""
    for place in request.places():
        engine = request.engine(place)
        axes = {"arm": _arm(request, engine), "ratio": f"${ratio_text(engine.ratio)}$"}
        yield axes | {quantity.key: _record(request, quantity, engine) for quantity in request.quantities}


def _arm(request: BeamRequest, engine: BeamEngine) -> Value:
    decimals = angle_decimals(request.arms)
    return f"${plain(engine.arm)}$" if decimals is None else nearest(engine.arm, decimals)


def _record(request: BeamRequest, quantity: BeamQuantity, engine: BeamEngine) -> Number:
    decimals = _decimals(request, quantity)
    return certified(_in_degrees(quantity), engine, request.exact, decimals, request.rounding)


def _in_degrees(quantity: BeamQuantity) -> BeamQuantity:
    if quantity.unit != MINUTES:
        return quantity
    return quantity._replace(formula=lambda engine, exact, side: quantity.formula(engine, exact, side) / 60)


def _decimals(request: BeamRequest, quantity: BeamQuantity) -> int:
    return request.decimals_of(DEGREE_DECIMALS if quantity.unit == MINUTES else quantity.decimals)


def _fields(request: BeamRequest) -> Mapping[str, Field]:
    lang = request.lang
    fields = {
        "arm": Field("arm", WORDS["arm"][lang], "$a$", "r", angle_decimals(request.arms)),
        "ratio": Field("ratio", page_axes.RATIO[lang], f"${request.layout.ratio_symbol}$"),
    }
    for one in request.quantities:
        fields[one.key] = Field(
            one.key, one.name[lang], one.symbol, one.shown_unit, _decimals(request, one), _method(request)
        )
    return fields
