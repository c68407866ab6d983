"""Arc cranks, or the parallel crank, and a layout become a table over the crank angle."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from kurbel.drive.crank import check_angles
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Number
from kurbel.linkage import captions
from kurbel.linkage.arc import ArcCrank
from kurbel.linkage.quantities import LinkageQuantity, arc_registry, parallel_registry
from kurbel.page import axes as page_axes
from kurbel.page.angles import angle_decimals, angle_number
from kurbel.page.arrange import Axis, Grid, Place, check_size
from kurbel.page.layouts import Layout
from kurbel.page.old_axes import AngleAxis, ColumnAxis, RatioAxis
from kurbel.page.sheet import Heads, Sheet, records_of, table_of
from kurbel.page.table import Cell, Field, Table, Value
from kurbel.reading.choices import choose
from kurbel.reading.notation import MOST_ROWS, ratio_text

# By the subject of the layout; the parallel crank has no ratio.
REGISTRIES = {"arc crank": arc_registry, "parallel crank": parallel_registry}
AXIS_KEYS = {"arc crank": ("ratio", "phi"), "parallel crank": ("phi",)}


@dataclass(frozen=True, kw_only=True)
class LinkageRequest(Sheet):
    """What is asked for: the arc cranks, alike but for their ratios, or none for the parallel crank."""

    angles: Sequence[Fraction]
    cranks: tuple[ArcCrank, ...] = ()

    def __post_init__(self) -> None:
        super().__post_init__()
        check_angles(self.angles)
        if "ratio" in self.axis_keys and not self.cranks:
            raise ProblemError("no crank ratio was given; write one as --ratio 1:5")
        if len(self) > MOST_ROWS:
            raise ProblemError(f"the table has {len(self)} rows; at most 10^9 are allowed")
        for key in self.columns:
            choose(key, linkage_column_keys(self.layout), "column")
        if not self.quantities:
            raise ProblemError(
                f"there is no column beside the axes; add one, such as {next(iter(self.registry))}"
            )

    def __len__(self) -> int:
        """How many records there are."""
        return len(self.drives) * len(self.angles)

    @property
    def drives(self) -> tuple[ArcCrank | None, ...]:
        return self.cranks or (None,)

    @property
    def axis_keys(self) -> tuple[str, ...]:
        return AXIS_KEYS[self.layout.subject]

    @property
    def registry(self) -> Mapping[str, LinkageQuantity]:
        return REGISTRIES[self.layout.subject]()

    @property
    def quantities(self) -> tuple[LinkageQuantity, ...]:
        return tuple(self.registry[key] for key in dict.fromkeys(self.chosen()) if key not in self.axis_keys)

    def number(self, quantity: LinkageQuantity, drive: ArcCrank | None, angle: Fraction) -> Number:
        decimals = self.decimals(quantity)
        return Number(quantity.digits(drive, angle, decimals, self.rounding), decimals)

    def decimals(self, quantity: LinkageQuantity) -> int:
        return self.decimals_of(quantity.decimals)


def linkage_column_keys(layout: Layout) -> tuple[str, ...]:
    """Return what --columns can choose from."""
    return (*AXIS_KEYS[layout.subject], *REGISTRIES[layout.subject]())


def build_linkage(request: LinkageRequest, pages: bool = True) -> Table:
    """Return the table that was asked for; without `pages` only its records."""
    names = request.columns or (*request.axis_keys, *(one.key for one in request.quantities))
    records = records_of(len(request), names, _fields(request), lambda: _records(request))
    grid = _grid(request) if pages else None
    return table_of(request, captions.caption(request), grid, records, captions.notes(request))


def _grid(request: LinkageRequest) -> Grid:
    layout, lang, quantities, drives = request.layout, request.lang, request.quantities, request.drives
    ratios = [crank.crank.ratio for crank in request.cranks]
    headed = [Heads(tuple(spanner[lang] for spanner in one.spanners), (one.heading,)) for one in quantities]
    axes: dict[str, Axis] = {
        "angle": AngleAxis(layout, request.angles, lang),
        "column": ColumnAxis(layout, headed, ratios, lang),
    }
    if ratios:
        axes["ratio"] = RatioAxis(layout, ratios, lang)
    check_size(layout, {name: axis.size for name, axis in axes.items()})

    def cell(place: Place) -> Cell:
        quantity, angle = quantities[place["column"]], request.angles[place["angle"]]
        return Cell(request.number(quantity, drives[place.get("ratio", 0)], angle))

    return Grid(axes, cell)


def _records(request: LinkageRequest) -> Iterator[Mapping[str, Value]]:
    """One for each drive and angle."""
    of_angles = angle_decimals(request.angles)
    for drive in request.drives:
        ratio = f"${ratio_text(drive.crank.ratio)}$" if drive else None
        for angle in request.angles:
            axes: dict[str, Value] = {"ratio": ratio, "phi": angle_number(angle, of_angles)}
            yield axes | {one.key: request.number(one, drive, angle) for one in request.quantities}


def _fields(request: LinkageRequest) -> Mapping[str, Field]:
    lang, layout, decimals = request.lang, request.layout, angle_decimals(request.angles)
    fields = {
        "ratio": Field("ratio", page_axes.RATIO[lang], f"${layout.ratio_symbol}$"),
        "phi": Field("phi", page_axes.PHI[lang], f"${layout.angle_symbol}$", "°", decimals),
    }
    for one in request.quantities:
        fields[one.key] = Field(
            one.key, one.full_name(lang), one.symbol, one.unit, request.decimals(one), "exact"
        )
    return fields
