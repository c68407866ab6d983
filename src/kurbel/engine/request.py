"""What is asked for of an engine, with all choices made: layout, engines, methods and the columns."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import NamedTuple

from kurbel.drive.crank import Crank, check_angles
from kurbel.drive.flywheel import Flywheel
from kurbel.engine.engine import MOST_CRANKS, Diagram, Engine, Load, Steam
from kurbel.engine.quantities import OUTSTROKE, RETURN_STROKE, WHOLE, EngineQuantity, engine_registry
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label
from kurbel.motion.evaluation import Method
from kurbel.page.angles import angle_decimals
from kurbel.page.layouts import Layout, LayoutColumn
from kurbel.page.sheet import Sheet
from kurbel.reading.choices import choose
from kurbel.reading.notation import MOST_ROWS

ENGINE_METHODS: Mapping[str, Method] = {
    method.key: method
    for method in (
        Method(
            "exact",
            {"de": "genaue Formeln", "en": "exact formulas, true extremes of the speed"},
            {"de": "genaue Formeln", "en": "exact formulas"},
        ),
        Method(
            "series",
            {"de": "Näherung erster Ordnung", "en": "first-order motion of the piston, true extremes"},
            {"de": "Näherung erster Ordnung", "en": "first-order formulas"},
        ),
        Method(
            "weisbach",
            {"de": "Weisbachs Gleichungen", "en": "first order, angles by the equations of § 150"},
            {
                "de": "nach Weisbachs Gleichungen für $α_1$ und $α_2$",
                "en": "by Weisbach's equations for $α_1$ and $α_2$",
            },
        ),
    )
}
# What pages of a run of crank angles are about.
OVER_ANGLE = ("turning", "crank forces", "machine")
# The quantities that a page can show, by what it is about.
SCOPES: Mapping[str, tuple[str, ...]] = {
    "irregularity": ("turn", "span"),
    "strokes": ("turn", "span", "stroke"),
    "turning": ("angle", "turn"),
    **dict.fromkeys(("crank forces", "machine"), ("crank", "angle")),
    "flywheel": ("flywheel",),
}
# The keys of the axes in records, and on the command line.
ENGINE_AXES: Mapping[str, tuple[str, ...]] = {
    "irregularity": ("epsilon", "ratio"),
    "strokes": ("epsilon", "ratio", "stroke"),
    **dict.fromkeys(OVER_ANGLE, ("epsilon", "ratio", "phi")),
    "flywheel": ("epsilon", "ratio", "target"),
}


# What a quantity needs to be known.
UNKNOWN: Mapping[str, str] = {
    "steam": "an ideal card, with an expansion ratio",
    "radius": "the radius at which the mass is, --radius",
    "load": "--bore and, but for a card, --pressure",
    "torque": "--stroke, --bore and, but for a card, --pressure",
}


class EngineColumn(NamedTuple):
    """A column of the page with all choices made. `methods` are one, or two whose difference is shown."""

    key: str
    quantity: EngineQuantity
    methods: tuple[str, ...]
    decimals: int | None
    spanners: tuple[Label, ...]
    heading: tuple[Label, ...]


@dataclass(frozen=True, kw_only=True)
class EngineRequest(Sheet):
    """What is asked for: the engines of all steams or cards (outer) and crank drives (inner).

    `double` and `cranks` are those of Engine. `methods` empty leaves them to the layout, or is exact.
    """

    steams: Sequence[Steam | Diagram]
    drives: Sequence[Crank]
    double: bool = True
    cranks: Sequence[Fraction] = (Fraction(0),)
    methods: tuple[str, ...] = ()
    angles: Sequence[Fraction] = (Fraction(0),)
    flywheels: tuple[Flywheel, ...] = ()
    load: Load | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        self._check_lists()
        check_angles(self.angles)
        for method in self.methods:
            choose(method, ENGINE_METHODS, "method")
        if len(self.methods) > 1 and not self.layout.fixed:
            compared = self.layout.subject in ("irregularity", "strokes")
            raise ProblemError(
                f"layout {self.layout.key} shows one method, and {len(self.methods)} were given;"
                f" {'use --layout delta-verfahren' if compared else 'leave the others out'}"
            )
        if self.layout.subject in OVER_ANGLE and "weisbach" in self.methods:
            raise ProblemError(
                'method "weisbach" is about the angles of the extremes, which a turning effort has not;'
                " use series"
            )
        if self.carded and "expansion" in self.layout.across:
            raise ProblemError(
                f"layout {self.layout.key} is over ε, which an indicator card does not have;"
                " use --layout delta-detail"
            )
        if len(self) > MOST_ROWS:
            raise ProblemError(f"the table would have {len(self)} rows; at most 10^9 are allowed")

    def _check_lists(self) -> None:
        if not self.steams:
            raise ProblemError("no expansion ratio was given; write them as 4, 2;3;4 or 2..6")
        if not self.drives:
            raise ProblemError("no crank ratio was given; write one as 1:5")
        # A range of angles may be too long to be written out.
        if not 1 <= len(self.cranks) <= MOST_CRANKS:
            raise ProblemError(f"the engine has {len(self.cranks)} cranks; 1 to {MOST_CRANKS} are allowed")
        for ratio in range(len(self.drives)):
            self.engine(0, ratio)
        if self.layout.subject == "machine" and self.first.crank.moving is None:
            raise ProblemError(
                f"layout {self.layout.key} is of an engine with its masses; give one, such as --reciprocating"
                " 300kg, or use --layout engine-forces"
            )
        if self.layout.subject == "flywheel" and not self.flywheels:
            raise ProblemError("no degree of irregularity was given; write one as 1:100")

    def __len__(self) -> int:
        """How many records there are."""
        count = len(self.steams) * len(self.drives)
        angles = dict.fromkeys(OVER_ANGLE, len(self.angles))
        spans = {"strokes": len(self.spans), "flywheel": len(self.flywheels), **angles}
        return count * spans.get(self.layout.subject, 1)

    def engine(self, steam: int, drive: int) -> Engine:
        return Engine(
            self.drives[drive],
            self.steams[steam],
            self.double,
            tuple(self.cranks),
            self.load,
        )

    @cached_property
    def first(self) -> Engine:
        return self.engine(0, 0)

    @cached_property
    def angle_decimals(self) -> int | None:
        """How many decimals write every crank angle exactly, None if no number of them does."""
        return angle_decimals(self.angles)

    @cached_property
    def expansion_decimals(self) -> int | None:
        """The same of every ε; None of cards."""
        expansions = [steam.expansion for steam in self.steams if isinstance(steam, Steam)]
        return angle_decimals(expansions) if expansions else None

    @property
    def carded(self) -> bool:
        """Whether the piston force comes from an indicator card."""
        return self.first.carded

    @property
    def ratios(self) -> list[Fraction]:
        return [drive.ratio for drive in self.drives]

    @property
    def spans(self) -> tuple[int | None, ...]:
        """The strokes have extremes of their own where one crank turns by one double-acting cylinder."""
        return (OUTSTROKE, RETURN_STROKE, WHOLE) if self.first.plain else (WHOLE,)

    @cached_property
    def page_columns(self) -> tuple[EngineColumn, ...]:
        """The columns asked for, or the layout's own as far as they are known."""
        own = {column.key: column for column in self.layout.columns}
        shown = [column for column in self.layout.columns if self._shown(column)]
        if not self.columns:
            if not shown:
                raise ProblemError(
                    f"layout {self.layout.key} has no column by method {', '.join(self.methods)} for this"
                    " engine; use exact or series"
                )
            return tuple(self._column(column) for column in shown)
        axes = self.axis_keys
        allowed = (*axes, *engine_column_keys(self.layout)[len(axes) :])
        keys = [choose(key, allowed, "column") for key in self.columns]
        chosen = [own.get(key, LayoutColumn(key, key)) for key in dict.fromkeys(keys) if key not in axes]
        if not chosen:
            example = (shown or self.layout.columns)[-1].key
            raise ProblemError(f"there is no column beside the axes; add one, such as {example}")
        for column in chosen:
            missing = self._missing(engine_registry()[column.quantity])
            if missing:
                raise ProblemError(f"column {column.key} needs {missing}; leave it out, or give that")
        return tuple(map(self._column, chosen))

    @property
    def mean_column(self) -> EngineColumn:
        """The mean force, by the first method."""
        quantity, methods = engine_registry()["mean_force"], (self.methods or ("exact",))[:1]
        return EngineColumn("mean_force", quantity, methods, quantity.decimals, (), ())

    @property
    def axis_keys(self) -> tuple[str, ...]:
        """The keys of the axes in records: a card stands in the place of ε."""
        keys = ENGINE_AXES[self.layout.subject]
        return ("card", *keys[1:]) if self.carded else keys

    def _shown(self, column: LayoutColumn) -> bool:
        methods = _methods(column.method)
        if self.carded and "weisbach" in methods:
            return False
        asked = not methods or not self.methods or set(methods) <= set(self.methods)
        if column.unless and not self._missing(engine_registry()[column.unless]):
            return False
        return asked and not self._missing(engine_registry()[column.quantity])

    def _missing(self, quantity: EngineQuantity) -> str:
        """What the quantity needs and this engine does not have, nothing if it is known."""
        if quantity.scope == "stroke" and not self.first.plain:
            return "one double-acting crank"
        unknown = {
            "steam": self.carded,
            "load": self.load is None,
            "torque": self.load is None or self.first.crank.radius is None,
            "radius": not self.flywheels or self.flywheels[0].radius is None,
        }
        return UNKNOWN[quantity.needs] if unknown.get(quantity.needs) else ""

    def _column(self, column: LayoutColumn) -> EngineColumn:
        quantity, lang = engine_registry()[column.quantity], self.lang
        decimals = quantity.decimals if column.decimals is None else column.decimals
        name = quantity.name[lang]
        down = "column" in self.layout.down
        spanners = () if down else (f"{name}",)
        heading = (f"{name} {quantity.symbol}",) if down else (f"{quantity.symbol} in {quantity.unit}",)
        return EngineColumn(
            column.key,
            quantity,
            _methods(column.method) or self.methods or ("exact",),
            decimals if self.digits is None else self.digits,
            spanners if column.spanners is None else tuple(one[lang] for one in column.spanners),
            heading if column.heading is None else tuple(one[lang] for one in column.heading),
        )


def engine_column_keys(layout: Layout) -> tuple[str, ...]:
    """Return what --columns can choose from; a page whose heads state methods has only its own columns."""
    scopes = SCOPES[layout.subject]
    own = [column.key for column in layout.columns]
    fitting = [key for key, quantity in engine_registry().items() if quantity.scope in scopes]
    return tuple(dict.fromkeys((*ENGINE_AXES[layout.subject], *own, *([] if layout.fixed else fitting))))


def _methods(method: str | None) -> tuple[str, ...]:
    """exact-series is the difference of two methods."""
    return tuple(method.split("-")) if method else ()
