"""What a page is about, as data, and what is asked of it: layout, language, digits and columns."""

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache, cached_property
from math import prod
from operator import attrgetter
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, ClassVar, Generic, NamedTuple, Self, TypeAlias, TypeVar

from kurbel.errors import ChoiceError, ProblemError
from kurbel.exact.numerals import MOST_DIGITS, ROUNDINGS, Label, Number
from kurbel.page.axes import Axis, Grid, PageAxis, Place
from kurbel.page.labels import plain
from kurbel.page.layouts import SUBJECTS, Layout, LayoutColumn
from kurbel.page.quantity import (
    Column,
    Known,
    Need,
    Of,
    Quantity,
    enumerated,
    filled,
    for_ratio,
    is_short,
    known_at,
)
from kurbel.page.table import Field, Note, Records, Tone, Value, Worded, check_label
from kurbel.reading.given import FrozenValue, allowed_name, choose, found_at
from kurbel.reading.names import others, otherwise
from kurbel.reading.notation import MOST_ROWS

if TYPE_CHECKING:
    from kurbel.page.steps import Scene
    from kurbel.reading.amounts import Units

Limit: TypeAlias = Callable[[Fraction], object]
Q = TypeVar("Q", contravariant=True)
# What draws a page over one of its axes.
OVER_AXES = "kurbel.plot.pages:over_axes"
# How refusals of a column end that what is known does not make.
LEAVE_OUT = "; leave it out, or give that"
# What a question finds once and depends on its units and columns; all else that was found stays.
OF_COLUMNS = ("page_columns", "axes", "full", "for_data", "values", "long", "known")


def _everywhere(question: object, place: Place) -> bool:
    return True


class Subject(NamedTuple, Generic[Q]):
    """What pages of one kind are about, as data; grid, records, fields, keys and checks follow from it.

    `axes` by their names, outermost first, each made of the question; "column" is that of the quantities.
    `number` is what stands at a place, times a factor; the question keeps what it computed once. `layout`
    is the default layout, `command` what prints its pages. `of` is what the quantities are numbers of that
    a layout can show beside its own, all if it is empty; its own stand first in lists unless all come in
    the order of the quantities. `exists` leaves out places that a grid has too many, `marks` are those of
    notes at a place, `tone` is how that is to be taken which stands there, `beside` the columns that follow
    one in records, `rows` the records where they are long or others than the page's, and `grid` the page
    where it is that of another layout.

    Lists of quantities name those that are `listed`, each with the command that prints it, by default all
    that any of its layouts can show; with `letters` the symbol stands beside the name. `limits` raise
    KurbelError for a value of an axis that is beyond them, whatever else is given. `drawn` is the place of
    what makes the picture of a question.
    """

    key: str
    layout: str
    command: str
    axes: Mapping[str, Callable[[Q], PageAxis]]
    axis_keys: tuple[str, ...]
    quantities: Callable[[], Mapping[str, Quantity]]
    number: Callable[[Q, Column, Place, int], Value]
    notes: Callable[[Q], Iterable[Label | Note]]
    caption: Callable[[Q], Label] = attrgetter("filled_caption")
    page_notes: Callable[[Q], Iterable[Label]] = lambda question: ()
    own_first: bool = True
    of: tuple[Of, ...] = ()
    exists: Callable[[Q, Place], bool] = _everywhere
    marks: Callable[[Q, Column, Place], tuple[str, ...]] = lambda question, column, place: ()
    tone: Callable[[Q, Column, Place], Tone] = lambda question, column, place: ""
    beside: Callable[[Q, Column], tuple[Column, ...]] = lambda question, column: ()
    rows: Callable[[Q], Records] | None = None
    grid: Callable[[Q], tuple[Layout, Grid]] | None = None
    listed: Callable[[], Iterable[tuple[str, Quantity]]] | None = None
    letters: bool = False
    limits: Mapping[str, Limit] = MappingProxyType({})
    drawn: str = OVER_AXES

    @property
    def whole(self) -> bool:
        """Whether its axes belong together, for at some of their places there is nothing."""
        return self.exists is not _everywhere

    def fitting(self) -> list[str]:
        """Return the keys of the quantities that any layout can show."""
        return [key for key, one in self.quantities().items() if not self.of or one.of in self.of]

    def entries(self) -> Iterator[tuple[Quantity, str]]:
        """Yield the quantities that lists name here, each with what prints it, and its options."""
        fitting = ((self.command, self.quantities()[key]) for key in self.fitting())
        for command, one in self.listed() if self.listed else fitting:
            yield one, " ".join((command, *one.options))

    def name_of(self, quantity: Quantity, lang: str) -> str:
        """Return what lists call a quantity."""
        name = quantity.full_name(lang)
        return f"{name} {plain(quantity.symbol)}".rstrip() if self.letters else name

    def column_keys(self, layout: Layout) -> tuple[str, ...]:
        """Return what --columns can choose from; a page whose heads state formulas has its own only."""
        own = [column.key for column in layout.columns]
        others = [] if layout.fixed else self.fitting()
        keys = [*own, *others] if self.own_first or layout.fixed else others
        return tuple(dict.fromkeys((*self.axis_keys, *keys)))


@cache
def subject(key: str) -> Subject[Any]:
    """Return what pages are about that say so."""
    found = found_at(SUBJECTS[key].place)
    assert isinstance(found, Subject)
    return found


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class Question(Worded, FrozenValue):
    """A layout that is asked for, with the digits, the language and the columns of its page.

    `digits` None leaves the decimals to the layout and the quantities, no `columns` the columns to the
    layout. Angles of the page count from φ = `zero`; `units` None are the metric ones of the quantities. For
    `data` the layout has the columns, too, that give way on pages. What a subject asks beside that are the
    fields of its own question.
    """

    layout: Layout
    digits: int | None = None
    rounding: str = "half-away"
    lang: str = "de"
    columns: tuple[str, ...] = ()
    label: str = ""
    units: "Units | None" = None
    zero: Fraction = Fraction(0)
    data: bool = False

    # What to do with a page of one place that was to be drawn, whose axes take no other values.
    undrawn: ClassVar[str] = "print it, as text or LaTeX"
    # What a refusal of a column ends with that needs what is not known.
    advice: ClassVar[str] = ""
    # Whether records of the axes alone say something.
    axes_suffice: ClassVar[bool] = False
    # Numbers that need not be computed.
    known: ClassVar[Mapping[Known, Number]] = MappingProxyType({})
    # What computes columns over very many crank angles at once; it knows the numbers of some columns.
    long: ClassVar[Any] = None

    def __post_init__(self) -> None:
        check_rounding(self.digits, self.rounding)
        check_label(self.label)
        self.check()
        if not self.page_columns and not self.axes_suffice:
            raise ProblemError(self.columnless)
        if len(self) > MOST_ROWS:
            raise ProblemError(f"{self.too_long()}; at most 10^9 are allowed")

    def too_long(self) -> str:
        """Return the half of a sentence that refuses so many records."""
        return f"the table would have {len(self)} rows"

    def check(self) -> None:
        """Raise a KurbelError for what the subject cannot answer."""

    def lacks(self, need: Need) -> bool:
        """Whether what quantities need is not known."""
        return not need.is_known(self)

    def missing(self, quantity: Quantity) -> str:
        """Return the sentence that refuses a column of the quantity, nothing if it is known."""
        return self.needing(quantity, (str(need) for need in quantity.needs if self.lacks(need)))

    def needing(self, quantity: Quantity, lacking: Iterable[str]) -> str:
        """Return the sentence that refuses a column by what it lacks, nothing if that is nothing."""
        named = " and ".join(lacking)
        return named and f"column {quantity.key} needs {named}{self.advice}"

    @cached_property
    def for_data(self) -> Self:
        """The same for records, which are in metric units unless others were asked for."""
        full = self.full
        return full if self.units is None or self.units.data else full.varied(units=None)

    @cached_property
    def full(self) -> Self:
        """The same with the columns that give way on pages."""
        giving_way = not (self.data or self.columns) and any(
            one.unless_printed and self.knows(one.unless_printed) for one in self.layout.columns
        )
        return self.varied(data=True) if giving_way else self

    def varied(self, **changed: object) -> Self:
        """Return the same in other units or columns, with all that it found which does not depend on them."""
        other = copy(self)
        for name in OF_COLUMNS:
            vars(other).pop(name, None)
        vars(other).update(changed)
        return other

    @property
    def subject(self) -> Subject[Self]:
        return subject(self.layout.subject)

    @property
    def moving(self) -> tuple[str, Any] | None:
        """The mechanism, by its name, and the drive of which it is asked; of several the first."""
        return None

    def carrying(
        self, scene: "Scene | None", whole: "Callable[[], Scene | None] | None" = None
    ) -> "Scene | None":
        """Return what moves with what the page shows of it besides; `whole` makes it of a whole turn."""
        return scene

    @property
    def columnless(self) -> str:
        """Why this page, which has no column beside its axes, is refused."""
        hidden = [] if self.columns else [self._hidden(column) for column in self.layout.columns]
        if hidden and all(hidden):
            return f"layout {self.layout.key} has no column to show: {hidden[0]}"
        return self.no_column

    @property
    def no_column(self) -> str:
        """Why a page without a column beside its axes is refused, with an example."""
        return f"there is no column beside the axes; add one, such as {next(iter(self.subject.quantities()))}"

    @property
    def axis_keys(self) -> tuple[str, ...]:
        """The keys of the axes in records."""
        return self.subject.axis_keys

    @property
    def key(self) -> str:
        """The name of the table for cross references."""
        return self.label or self.layout.key

    @property
    def origin(self) -> Label:
        """The line that says where the page comes from."""
        return self.layout.source[self.lang]

    @cached_property
    def axes(self) -> Mapping[str, PageAxis]:
        return {name: axis(self) for name, axis in self.subject.axes.items()}

    @property
    def apart(self) -> list[str]:
        """The keys of the axes that tell records apart."""
        return [one.key for one in self.axes.values() if isinstance(one, Axis) and one.tells_apart]

    @property
    def caption_parts(self) -> Mapping[str, Label]:
        """What stands for the places in braces of a caption: quantities, and the ratio if there is one."""
        lang, ratios = self.lang, {*getattr(self, "ratios", ())}
        one = len(ratios) == 1 and getattr(self, "method", None) != "infinite"
        return {
            "{quantities}": enumerated((column.quantity.name[lang] for column in self.page_columns), lang),
            "{for_ratio}": for_ratio(ratios.pop(), lang, self.layout.ratio_symbol) if one else "",
        }

    @property
    def filled_caption(self) -> Label:
        """The layout's caption with its places in braces filled."""
        return filled(self.layout.caption[self.lang], self.caption_parts.items())

    def below(self) -> Iterator[Label | Note]:
        """Yield the lines below the table: those of the layout, then what its subject says."""
        yield from (note[self.lang] for note in self.layout.notes)
        yield from self.subject.notes(self)

    def __len__(self) -> int:
        """How many records there are."""
        return prod(axis.count for name, axis in self.axes.items() if name != "column")

    @cached_property
    def page_columns(self) -> tuple[Column, ...]:
        """The columns asked for, else the layout's as far as they are known."""
        if not self.columns:
            return tuple(self.printed(one) for one in self.layout.columns if self.shows(one))
        chosen = self.chosen([key for key in self.named if key not in self.axis_keys])
        for column in chosen:
            if missing := self.missing(self.entry(column.quantity)):
                raise ProblemError(missing)
        return tuple(map(self.printed, chosen))

    @cached_property
    def named(self) -> tuple[str, ...]:
        """The keys of the columns that are asked for, by whatever words for them, and of axes among them."""
        if not self.columns:
            return ()
        # The axes of the question may have other keys than its subject states.
        further = self.subject.column_keys(self.layout)[len(self.subject.axis_keys) :]
        allowed = dict.fromkeys((*self.axis_keys, *further))
        return tuple(dict.fromkeys(self._meant(name, allowed) for name in self.columns))

    def _meant(self, name: str, allowed: Collection[str]) -> str:
        """Return the key that is meant; of two of one meaning, for drives of two kinds, that of this one."""
        if isinstance(name, str) and name.startswith("+"):
            whole = ",".join([*(one.key for one in self.layout.columns), name[1:]])
            raise ChoiceError(f"--columns names all columns, and adds none to them; write --columns {whole}")
        try:
            key = allowed_name(name, allowed, "column")
        except ChoiceError as error:
            if "did you mean" not in str(error) and (line := self._elsewhere(name)):
                raise ChoiceError(f'there is no column "{name}" on this page; kurbel {line} has it') from None
            raise
        if key in self.axis_keys or not self._is_missing(key):
            return key
        known = (one for one in others(key, allowed) if one not in self.axis_keys)
        return next((one for one in known if not self._is_missing(one)), key)

    def _elsewhere(self, name: str) -> str:
        """Return the line that prints a column which this page has not, of the same command if it can,
        nothing if none does."""
        command = self.subject.command.partition(" ")[0]
        lines = [
            ((line.partition(" ")[0] != command, one.axis_keys != self.subject.axis_keys), line)
            for one in map(subject, SUBJECTS)
            for quantity, line in one.entries()
            if line != command and quantity.key == otherwise(str(name), [quantity.key])
        ]
        return min(lines, key=lambda found: found[0], default=((), ""))[1]

    def _is_missing(self, key: str) -> bool:
        (column,) = self.chosen([key])
        return bool(self.missing(self.entry(column.quantity)))

    def of_page(self, unit: Label) -> Fraction:
        """Return how many units of the page one of metric pages is."""
        return Fraction(1) if self.units is None else self.units.times(unit)

    def printed(self, column: LayoutColumn) -> Column:
        """Return a column in the units of the page."""
        own = self.column(column)
        if self.units is None:
            return own
        from kurbel.page.units import in_units

        return in_units(own, self.units, self.lang, self.digits is not None)

    def shows(self, column: LayoutColumn) -> bool:
        """Whether the layout's column is shown where none were asked for."""
        return self.knows(column.quantity) and not self._rival(column)

    def _hidden(self, column: LayoutColumn) -> str:
        """Return why the layout's column cannot be shown, nothing if it can."""
        if other := self._rival(column):
            return f"column {column.key} gives way to {other}"
        return self.missing(self.entry(column.quantity))

    def _rival(self, column: LayoutColumn) -> str:
        """Return the known quantity to which the layout's column gives way, if there is one."""
        others = (column.unless, "" if self.data else column.unless_printed)
        return next((one for one in others if one and self.knows(one)), "")

    def knows(self, key: str) -> bool:
        """Whether a quantity is known."""
        return not self.missing(self.entry(key))

    def chosen(self, keys: Sequence[str]) -> list[LayoutColumn]:
        """Return the columns of these keys, with the heads of the layout where they are its own."""
        own = {column.key: column for column in self.layout.columns}
        return [own.get(key, LayoutColumn(key, key)) for key in keys]

    def entry(self, key: str) -> Quantity:
        return self.subject.quantities()[key]

    def methods_of(self, column: LayoutColumn) -> tuple[str, ...]:
        """Return the methods by which a column is computed."""
        return ("exact",)

    def column(self, column: LayoutColumn) -> Column:
        quantity, lang = self.entry(column.quantity), self.lang
        spanners = quantity.spanners if column.spanners is None else column.spanners
        heading = (quantity.heading,) if column.heading is None else column.heading
        return Column(
            column.key,
            quantity,
            self.methods_of(column),
            self.decimals(column, quantity),
            tuple(one[lang] for one in spanners),
            tuple(one[lang] for one in heading),
        )

    def decimals(self, column: LayoutColumn, quantity: Quantity) -> int | None:
        """Return the decimals asked for, else the layout's, else the quantity's own."""
        own = quantity.decimals if column.decimals is None else column.decimals
        return own if self.digits is None else self.digits

    def field(self, column: Column) -> Field:
        """Return what a column is in records."""
        one, lang = column.quantity, self.lang
        return Field(
            column.key,
            one.full_name(lang),
            one.symbol,
            one.plain_unit(lang),
            column.decimals,
            " - ".join(column.methods),
        )

    @cached_property
    def finest(self) -> "Question":
        """The same to as many decimals as can be asked for."""
        return replace(self, digits=MOST_DIGITS)

    def number(self, column: Column, place: Place, times: int = 1) -> Value:
        """Return what stands at a place, times a factor; None where the column says nothing of it."""
        if self.known and times == 1 and (number := self.known.get(known_at(column, place))) is not None:
            return number
        if times == 1 and self.long is not None:
            at_once: Number | None = self.long.number(column, place)
            if at_once is not None:
                return at_once
        found = self.subject.number(self, column, place, times)
        if column.least and isinstance(found, Number) and is_short(found, column):
            return self.subject.number(self, column._replace(decimals=column.least), place, times)
        return found


def check_rounding(digits: int | None, rounding: str) -> None:
    """Raise a KurbelError unless so many decimals can be printed, and rounded in this way."""
    if digits is not None and (not isinstance(digits, int) or not 0 <= digits <= MOST_DIGITS):
        raise ProblemError(f"digits is {digits}; it must be a whole number from 0 to {MOST_DIGITS}")
    choose(rounding, ROUNDINGS, "rounding")
