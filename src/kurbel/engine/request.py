"""What is asked for of an engine, with all choices made: layout, engines, methods and the columns."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

from kurbel.drive.crank import check_angles
from kurbel.drive.load import COMPRESSOR, GAS, LOADS, PUMP, STEAM
from kurbel.drive.load import Load as Acting
from kurbel.engine.cylinder import OUTSTROKE, RETURN_STROKE, WHOLE, AnyTurn, TurnPlace
from kurbel.engine.digits import check_card
from kurbel.engine.engine import Assembly, Engine, Load, check_count
from kurbel.engine.engine_quantities import ENGINE_METHODS
from kurbel.engine.loads.words import LoadWords, words_of, words_of_cylinders
from kurbel.engine.turn import turn_of
from kurbel.errors import ProblemError
from kurbel.motion.bulk import worthwhile
from kurbel.motion.evaluation import PAGE_CELLS
from kurbel.motion.mechanism import STRAIGHT, Mechanism
from kurbel.page.quantity import Column, Of, Quantity, with_symbol, words
from kurbel.page.subject import LEAVE_OUT, Question
from kurbel.reading.given import choose

if TYPE_CHECKING:
    from kurbel.drive.moved import Drive
    from kurbel.drive.wheel import Flywheel, Wheel
    from kurbel.engine.arrays import Irregularities
    from kurbel.motion.long import LongColumns
    from kurbel.page.axes import Place
    from kurbel.page.layouts import LayoutColumn
    from kurbel.page.table import Field

# So many engines take balls as long as NumPy and its formulas take for the first.
PAGE_ENGINES = 200

# What pages of a run of crank angles are about.
OVER_ANGLE = ("turning", "speed", "crank forces", "machine")
# And those of forces, over the whole turn.
OF_FORCES = ("rod load", "loaded roots")
# What pages of a given flywheel are about.
WITH_FLYWHEEL = ("speed", "evenness")
BY_STROKE = ("strokes", "pump")
OF_IRREGULARITY = ("irregularity", *BY_STROKE, "compressor", "gas cycle")
# Those of one load alone, and the options that name it.
OF_LOAD: Mapping[str, tuple[str, str]] = {
    "compressor": (COMPRESSOR, "--pressure-ratio"),
    "pump": (PUMP, "--pump"),
    "gas cycle": (GAS, "--compression"),
}
# What is of one kind of cylinder.
OF_ALIKE = ("mean_pressure", "mean_pressure_kpa")
# Turns take tens of kilobytes each, and records may be of a million engines. A page has its own at hand.
KEPT_TURNS = 512
SUPPLIED = words("zugeführtes mittleres Drehmoment|Mean torque supplied")
DIFFERENCE = words(", Unterschied|, difference")


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class EngineRequest(Question):
    """What is asked for: the engines of all steams, cards or other loads (outer) and crank drives (inner).

    `double` and `cranks` are those of Engine. `methods` empty leaves them to the layout, or is exact.
    `flywheels` are what is asked for, `wheel` is the one given. An engine of unlike cylinders is an
    `assembly`; `numbers` are those of its cylinders where they are in another order.
    """

    steams: Sequence[Acting]
    drives: Sequence[Drive]
    mechanism: Mechanism = STRAIGHT
    double: bool = True
    cranks: Sequence[Fraction] = (Fraction(0),)
    methods: tuple[str, ...] = ()
    angles: Sequence[Fraction] = (Fraction(0),)
    flywheels: tuple[Flywheel, ...] = ()
    wheel: Wheel | None = None
    load: Load | None = None
    assembly: Assembly | None = None
    numbers: tuple[int, ...] = ()

    advice = LEAVE_OUT

    def check(self) -> None:
        self._check_lists()
        check_angles(self.angles)
        self._check_methods()
        load, option = OF_LOAD.get(self.layout.subject, ("", ""))
        over_loads = bool(load) or "expansion" in self.layout.across
        if self.assembly is not None and over_loads:
            raise ProblemError(
                f"layout {self.layout.key} is of cylinders alike; use --layout {self.words.layout}"
            )
        if load and load != self.steams[0].name:
            raise ProblemError(f"layout {self.layout.key} is of {LOADS[load].title}; add {option}")
        if not (load or self.steamed) and "expansion" in self.layout.across:
            raise ProblemError(
                f"layout {self.layout.key} is over ε, which {LOADS[self.steams[0].name].title} does not have;"
                f" use --layout {self.words.layout}"
            )

    def _check_lists(self) -> None:
        if not self.steams:
            raise ProblemError("no expansion ratio was given; write them as 4, '2;3;4' or 2..6")
        if not self.drives:
            raise ProblemError("no crank ratio was given; write one as 1:5")
        # A range of angles may be too long to be written out.
        check_count(len(self.cranks))
        for ratio in range(len(self.drives)):
            self.engine(0, ratio)
        if self.layout.subject == "machine" and self.first.crank.moving is None:
            raise ProblemError(
                f"layout {self.layout.key} is of an engine with its masses; give one, such as --reciprocating"
                " 300kg, or use --layout engine-forces"
            )
        if self.layout.subject == "flywheel" and not self.flywheels:
            raise ProblemError("no degree of irregularity was given; write one as 1:100")
        if self.layout.subject in WITH_FLYWHEEL:
            self._check_wheel()

    def _check_wheel(self) -> None:
        if self.wheel is None:
            raise ProblemError(
                f"layout {self.layout.key} is of an engine with its flywheel; give that as --flywheel 50, its"
                " number m₁v₁²/(P r), or as --inertia 1200kgm2"
            )
        weighed = self.wheel.power is not None or (self.load and self.first.crank.radius)
        if self.wheel.inertia is not None and not weighed:
            raise ProblemError(
                "--inertia needs the mean torque that it takes up; add --power, or --stroke, --bore and the"
                " pressure"
            )

    def _check_methods(self) -> None:
        for method in self.methods:
            choose(method, ENGINE_METHODS, "method")
        if len(self.methods) > 1 and not self.layout.fixed:
            compared = self.layout.subject in OF_IRREGULARITY
            raise ProblemError(
                f"layout {self.layout.key} shows one method, and {len(self.methods)} were given;"
                f" {'use --layout delta-verfahren' if compared else 'leave the others out'}"
            )
        over_angle = self.layout.subject in (*OVER_ANGLE, *OF_FORCES)
        if over_angle and "weisbach" in self.methods and self.wheel is None:
            raise ProblemError(
                'method "weisbach" is about the angles of the extremes, which a turning effort has not;'
                " use series"
            )

    def engine(self, steam: int, drive: int) -> Engine | Assembly:
        if self.assembly is not None:
            return self.assembly
        return Engine(self.drives[drive], self.steams[steam], self.double, tuple(self.cranks), self.load)

    @cached_property
    def first(self) -> Engine | Assembly:
        return self.engine(0, 0)

    @cached_property
    def turn(self) -> Callable[[int, int, str], AnyTurn]:
        """Return the turn of an engine by a method; the latest ones are kept."""
        return lru_cache(KEPT_TURNS)(self._turn)

    def _turn(self, steam: int, drive: int, method: str) -> AnyTurn:
        turn = turn_of(self.engine(steam, drive), method)
        if self.carded:
            check_card(turn, self.rounding)
        return turn

    @cached_property
    def long(self) -> LongColumns | Irregularities | None:
        over_angle = "angle" in self.axes
        few = PAGE_CELLS if over_angle else PAGE_ENGINES
        if len(self.page_columns) * len(self) <= few or self.carded:
            return None
        own = "EngineColumns" if over_angle else "Irregularities"
        found: LongColumns | Irregularities | None = worthwhile(self, f"kurbel.engine.arrays:{own}")
        return found

    def where(self, place: Place) -> TurnPlace:
        return TurnPlace(
            self.spans[place["stroke"]] if "stroke" in place else WHOLE,
            self.angles[place["angle"]] / 180 if "angle" in place else Fraction(0),
            self.flywheels[place["target"]] if "target" in place else None,
        )

    @property
    def carded(self) -> bool:
        """Whether the piston force comes from an indicator card."""
        return self.first.carded

    @property
    def steamed(self) -> bool:
        """Whether steam with an expansion ratio drives the piston."""
        return self.steams[0].name == STEAM and self.assembly is None

    @cached_property
    def words(self) -> LoadWords:
        """What is said of the loads, which are of one kind, or of the cylinders."""
        if self.assembly is not None:
            return words_of_cylinders(self.assembly)
        return words_of(self.steams[0].name)

    @cached_property
    def driven(self) -> bool:
        """Whether the shaft drives the piston; of a card, and of several cylinders, their work says so."""
        if self.carded or self.assembly is not None:
            return self.turn(0, 0, "exact").mean_sign < 0
        return self.steams[0].driven

    @property
    def ratios(self) -> list[Fraction]:
        return [drive.crank.ratio for drive in self.drives]

    @property
    def moving(self) -> tuple[str, Drive]:
        return self.mechanism.name, self.drives[0]

    @property
    def spans(self) -> tuple[int | None, ...]:
        """The strokes have extremes of their own where one crank turns by one double-acting cylinder."""
        return (OUTSTROKE, RETURN_STROKE, WHOLE) if self.first.plain else (WHOLE,)

    @property
    def axis_keys(self) -> tuple[str, ...]:
        """The keys of the axes in records: another load stands in the place of ε."""
        return (self.words.key, *self.subject.axis_keys[1:])

    @property
    def no_column(self) -> str:
        if not self.columns:
            return (
                f"layout {self.layout.key} has no column by method {', '.join(self.methods)} for this"
                " engine; use exact or series"
            )
        shown = [column for column in self.layout.columns if self.shows(column)]
        example = (shown or self.layout.columns)[-1].key
        return f"there is no column beside the axes; add one, such as {example}"

    def entry(self, key: str) -> Quantity:
        one = self.mechanism.named(super().entry(key))
        if (one.of, key) == (Of.FLYWHEEL, "mean_torque") and self.driven:
            one = one._replace(name=SUPPLIED)
        if not self.layout.unit:
            return one
        # The page's last column has the units.
        return one._replace(spanners=(), heading=with_symbol(one))

    def column(self, column: LayoutColumn) -> Column:
        return self.mechanism.headed(super().column(column))

    def shows(self, column: LayoutColumn) -> bool:
        methods = _methods(column.method)
        if not self.steamed and "weisbach" in methods:
            return False
        asked = not methods or not self.methods or set(methods) <= set(self.methods)
        return asked and super().shows(column)

    @property
    def acting(self) -> Acting | None:
        """The load, where it is that of all cylinders."""
        return self.steams[0] if self.assembly is None else None

    @property
    def sized(self) -> bool:
        """Whether the load and the size of the crank make a torque known."""
        return self.load is not None and self.first.crank.radius is not None

    def missing(self, quantity: Quantity) -> str:
        lacking = [str(one).format(pressure=self.words.pressure) for one in quantity.needs if self.lacks(one)]
        if quantity.of is Of.STROKE and not self.first.plain:
            lacking = ["one double-acting crank"]
        if self.assembly is not None and quantity.key in OF_ALIKE:
            lacking = ["cylinders alike"]
        return self.needing(quantity, lacking[:1])

    def methods_of(self, column: LayoutColumn) -> tuple[str, ...]:
        return _methods(column.method) or self.methods or ("exact",)

    def field(self, column: Column) -> Field:
        own = super().field(column)
        return own._replace(name=own.name + DIFFERENCE[self.lang]) if len(column.methods) > 1 else own


def _methods(method: str | None) -> tuple[str, ...]:
    """exact-series is the difference of two methods."""
    return tuple(method.split("-")) if method else ()
