"""The pages of the piston's motion and of the forces of the drive: what is asked for, records, subject."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeAlias

from kurbel.drive.crank import Crank, check_angles, ends
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind, floats
from kurbel.exact.numerals import Label, Number
from kurbel.kernel.circle import Circle, Numeric, circle
from kurbel.motion import captions
from kurbel.motion.bulk import RecordRows, columns_in_floats, is_long, on_floats, scaled_number, worthwhile
from kurbel.motion.evaluation import (
    DIFFERENCE,
    LOADED,
    OUT,
    PAGE_CELLS,
    RETURN,
    STROKES,
    Needs,
    columns_in_balls,
    fits_page,
    typed,
    unknown,
    value,
)
from kurbel.motion.motion_quantities import effort_keys, registry
from kurbel.page.axes import (
    AngleAxis,
    ColumnAxis,
    Place,
    RatioAxis,
    angle_pairs,
)
from kurbel.page.build import records_of
from kurbel.page.layouts import Layout, LayoutColumn
from kurbel.page.quantity import Column, Need, Quantity
from kurbel.page.subject import Question, Subject
from kurbel.page.table import Records
from kurbel.reading.notation import ratio_text

if TYPE_CHECKING:
    import numpy as np

    from kurbel.motion.drives import Drive
    from kurbel.motion.long import LongColumns


# What is printed of a column over the angle, times 10 to its decimals; an array, or None where nothing is.
Digits: TypeAlias = "Sequence[int | None] | np.ndarray"


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class DriveQuestion(Question):
    """What is asked for of these drives, alike but for their ratios."""

    drives: tuple[Any, ...]

    def check(self) -> None:
        if not self.drives:
            raise ProblemError("no crank ratio was given; write one as --ratio 1:5")

    @property
    def cranks(self) -> tuple[Crank, ...]:
        """What is known of the cranks."""
        return tuple(one.crank for one in self.drives)

    @property
    def ratios(self) -> list[Fraction]:
        """The ratios of the drives, where they have one."""
        return [crank.ratio for crank in self.cranks] if "ratio" in self.subject.axes else []

    def lacks(self, need: Need) -> bool:
        return not all(need.is_known(crank) for crank in self.cranks)

    def missing(self, quantity: Quantity) -> str:
        return unknown(quantity) if any(map(self.lacks, quantity.needs)) else ""


class CrankQuestion(DriveQuestion):
    """What is asked for of straight or offset cranks."""

    @property
    def moving(self) -> tuple[str, Drive]:
        return "straight", self.drives[0]


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class AngleQuestion(DriveQuestion):
    """What is asked for of drives at crank angles.

    Both strokes stand side by side from 0° to 180°, each from the dead centre where it begins. A page of
    `whole_turns` has one column a quantity, that of the outstroke, which goes on through the return, and no
    head of it names a stroke.
    """

    angles: Sequence[Fraction]
    whole_turns: bool = False

    def check(self) -> None:
        check_angles(self.angles)
        super().check()

    @property
    def places(self) -> list[dict[str, int]]:
        """The places on all axes but those of angles and columns, in the order of records."""
        return [{"ratio": drive} for drive in range(len(self.drives))]

    def value(self, column: Column, place: Mapping[str, int], point: Circle[Any], kind: Kind) -> Numeric:
        """Return a column on any kind of number, NotImplemented where it has no such formulas."""
        return value(column.quantity, "exact", self.drives[place.get("ratio", 0)], point, kind)

    def curves(self, degrees: Numeric) -> list[list[Any]]:
        """Return the values of every column for every drive at an array of angles, in arrays of floats."""
        point, kind = circle(degrees), floats()
        return [
            [self.curve(column, place, point, kind) for place in self.places] for column in self.page_columns
        ]

    def curve(self, column: Column, place: Mapping[str, int], point: Circle[Any], kind: Kind) -> Numeric:
        """Return a column over the crank angle, as floats."""
        return self.value(column, place, point, kind)

    @cached_property
    def long(self) -> LongColumns | None:
        if len(self.page_columns) * len(self) <= PAGE_CELLS:
            return None
        found: LongColumns | None = worthwhile(self, "kurbel.motion.long:AngleColumns")
        return found

    @property
    def told(self) -> list[tuple[Label, ...]]:
        """What tells the drives of curves from each other."""
        return [(f"$R:L = {ratio_text(ratio)}$",) for ratio in self.ratios] or [()]

    def solved(self) -> tuple[Drive, ...]:
        """Return the drives as conditions see them, none where these know nothing of the page."""
        return ()

    @property
    def has_return(self) -> bool:
        """Whether the return stroke has columns of its own."""
        return any(column.quantity.stroke == RETURN for column in self.page_columns)

    def missing(self, quantity: Quantity) -> str:
        if not self.whole_turns or quantity.stroke != RETURN:
            return super().missing(quantity)
        return (
            f"column {quantity.key} is of the return stroke, which ends at 180°, and other angles were given;"
            f" leave it out, for {quantity.key.replace('_return', '')} goes on through the whole turn"
        )

    def entry(self, key: str) -> Quantity:
        one = super().entry(key)
        if not self.whole_turns or one.part != STROKES.get(one.stroke):
            return one
        return one._replace(part=None, spanners=tuple(label for label in one.spanners if label != one.part))

    def column(self, column: LayoutColumn) -> Column:
        own = super().column(column)
        if not self.whole_turns:
            return own
        stroke, known = STROKES[OUT][self.lang], self.subject.quantities()
        spanners, heading = (
            tuple(label for label in labels if label != stroke) for labels in (own.spanners, own.heading)
        )
        beside = any(
            (one.method, known[one.quantity].stroke, known[one.quantity].name)
            == (column.method, RETURN, own.quantity.name)
            for one in self.layout.columns
        )
        if beside and (spanners, heading) == (own.spanners, own.heading):
            # What a layout calls the outstroke in words of its own.
            return super().column(replace(column, spanners=None, heading=None))
        return own._replace(spanners=spanners, heading=heading)


def is_beyond(angles: Sequence[Fraction]) -> bool:
    """Whether some of the angles are none of a stroke, which begins at 0° and ends at 180°."""
    return min(ends(angles)) < 0 or max(ends(angles)) > 180


def check_pairs(layout: Layout, drives: str) -> None:
    """Raise ProblemError for a layout that takes drives for symmetrical that are not."""
    if layout.pairs:
        raise ProblemError(
            f"layout {layout.key} sets an angle over its mirror image, and {drives} do not stand alike at"
            " both; leave pairs out"
        )


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class Request(CrankQuestion, AngleQuestion):
    """What is asked for of these cranks at these angles. `method` None leaves it to the layout.

    By the method of the infinite rod all ratios are 1:∞, but for a page that also has other formulas.
    """

    method: str | None = None

    no_column = "--columns names no quantity; add one, for example --columns phi,x,c,p"

    def check(self) -> None:
        super().check()
        if self.method and self.layout.fixed:
            raise ProblemError(
                f"layout {self.layout.key} states its formulas in its heads and takes no method;"
                f" use --layout {self._plain} to choose one"
            )
        self._check_masses()
        if any(crank.offset for crank in self.cranks):
            self._check_offset()
        if any(crank.acceleration for crank in self.cranks):
            check_pairs(self.layout, "drives whose crank is accelerated")
            if any(Needs.TIME in column.quantity.needs for column in self.page_columns):
                raise ProblemError("a time is that of a crank that turns evenly; leave --acceleration out")
        if self.method == "infinite" and all(column.method is None for column in self.layout.columns):
            cranks = (replace(crank, ratio=Fraction(0)) for crank in self.cranks)
            object.__setattr__(self, "drives", tuple(dict.fromkeys(cranks)))

    @property
    def _plain(self) -> str:
        """The layout that takes a method."""
        return "forces" if self.layout.subject == MASSES.key else MOTION.layout

    def _check_masses(self) -> None:
        """Forces are of first order by those of moving masses alone."""
        known, approximate = self.subject.quantities(), ("series", DIFFERENCE)
        heavy = [one for one in self.layout.columns if one.method in approximate]
        bare = all(crank.moving is None for crank in self.cranks)
        if bare and any(LOADED in known[one.quantity].formulas for one in heavy):
            raise ProblemError(
                f"layout {self.layout.key} has forces of moving masses to first order; give these, such as"
                " --reciprocating 200kg"
            )

    def _check_offset(self) -> None:
        if self.method not in (None, "exact"):
            raise ProblemError(
                f'method "{typed(self.method)}" has no formulas for an offset crank;'
                " use exact, or leave the offset out"
            )
        if any(column.method not in (None, "exact") for column in self.layout.columns):
            raise ProblemError(
                f"layout {self.layout.key} prints first-order formulas, which an offset crank does not have;"
                f" use --layout {self._plain} or leave the offset out"
            )
        check_pairs(self.layout, "offset cranks")
        if any(Needs.EVEN in column.quantity.needs for column in self.page_columns):
            # Its module is large, and few pages have such a force.
            from kurbel.motion.inertia import check_poles

            check_poles(self.page_columns, self.cranks, self.angles)

    def too_long(self) -> str:
        return f"{len(self.cranks)} ratios at {len(self.angles)} angles make a table of {len(self)} rows"

    def chosen(self, keys: Sequence[str]) -> list[LayoutColumn]:
        # Beside foreign columns the layout's heads say too little, such as "Hingang" where all are paths.
        own, known = {column.key for column in self.layout.columns}, self.subject.quantities()
        if own >= set(keys):
            return super().chosen(keys)
        bare = {key: LayoutColumn(key, key) for key in known}
        return [bare.get(key) or super(Request, self).chosen([key])[0] for key in keys]

    def methods_of(self, column: LayoutColumn) -> tuple[str, ...]:
        return (column.method or self.method or "exact",)

    @cached_property
    def bulk(self) -> bool:
        """Whether so many cells are computed in arrays."""
        if fits_page(self.page_columns, self.cranks, self.angles):
            return False
        return is_long(self.page_columns, self.cranks, self.angles)

    @cached_property
    def values(self) -> list[Sequence[Digits]]:
        """The scaled digits of the page by crank, column and angle."""
        angles = angle_pairs(self.angles) if self.layout.pairs else self.angles
        return [self.scaled(crank, angles) for crank in self.cranks]

    def scaled(self, crank: Crank, angles: Sequence[Fraction]) -> Sequence[Digits]:
        """Return the scaled digits of every column at these angles."""
        return self.digits_of(self.page_columns, crank, angles)

    def digits_of(
        self, columns: Sequence[Column], crank: Crank, angles: Sequence[Fraction]
    ) -> Sequence[Digits]:
        """Return those of some columns."""
        by = columns_in_floats if self.bulk else columns_in_balls
        return by(columns, crank, angles, self.rounding)

    def solved(self) -> tuple[Drive, ...]:
        from kurbel.motion.drives import slide_drives

        even = not any(crank.acceleration for crank in self.cranks)
        return slide_drives(self.cranks, self.method or "exact") if even else ()

    def curves(self, degrees: Any) -> list[list[Any]]:
        from kurbel.exact.bulk import evaluate

        found = [
            evaluate([on_floats(column, crank) for column in self.page_columns], degrees)
            for crank in self.cranks
        ]
        return [list(of_cranks) for of_cranks in zip(*found, strict=True)]


# What draws whatever has curves over the crank angle.
CURVES = "kurbel.plot.curves:over_angle"


def motion_records(question: Request) -> Records:
    """Return one record for each ratio and angle."""
    fields = records_of(question).fields
    return Records(fields, RecordRows(question, [field.key for field in fields]))


def _number(question: Request, column: Column, place: Place, times: int) -> Number | None:
    scaled = question.values[place["ratio"]][place["column"]][place["angle"]]
    return scaled_number(scaled, column.places, times)


MOTION = Subject(
    key="motion",
    layout="kinematics",
    command="table",
    axes={"ratio": RatioAxis, "angle": AngleAxis, "column": ColumnAxis},
    axis_keys=("ratio", "phi"),
    quantities=registry,
    number=_number,
    caption=captions.caption,
    notes=captions.notes,
    rows=motion_records,
    listed=lambda: [("table", one) for key, one in registry().items() if key not in effort_keys()],
    drawn=CURVES,
)
# The same with the parts of what acts on the piston.
EFFORT = MOTION._replace(
    key="effort",
    layout="forces-effort",
    command="forces",
    listed=lambda: [("forces", registry()[key]) for key in effort_keys()],
)
# The same of moving masses, exact and to first order.
MASSES = MOTION._replace(
    key="mass forces", layout="forces-verfahren", command="forces --layout forces-verfahren", listed=tuple
)
