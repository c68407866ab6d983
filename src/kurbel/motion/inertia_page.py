"""The pages of the connecting rod: its forces, their greatest over a turn and the models' errors."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from fractions import Fraction
from functools import cache, cached_property

from kurbel.drive.at import known
from kurbel.drive.crank import Crank
from kurbel.exact.kind import Kind, settled
from kurbel.exact.numerals import Label, Number, figure, nearest, number_text
from kurbel.kernel.circle import Numeric
from kurbel.kernel.moving import Masses
from kurbel.motion.captions import notes
from kurbel.motion.evaluation import ROD_MODELS, Needs
from kurbel.motion.inertia import ROD_FORCES, inertia_registry
from kurbel.motion.inertia_peak import Peak
from kurbel.motion.motion_page import MOTION, CrankQuestion, Request
from kurbel.motion.motion_quantities import registry
from kurbel.motion.notes import connecting_rod, drive_notes, gyration_text
from kurbel.page.axes import ColumnAxis, ListAxis, Place, RatioAxis
from kurbel.page.layouts import layout
from kurbel.page.quantity import (
    Column,
    Formula,
    Of,
    Quantity,
    Texts,
    bare,
    entry,
    enumerated_letters,
    for_ratio,
)
from kurbel.page.subject import Subject
from kurbel.page.table import Field

FORCES, MODELS = tuple(ROD_FORCES.values()), tuple(ROD_MODELS)
EXACT = "exact"
SHEET = "inertia-errors"
DEGREE_DECIMALS = 4
PERCENT_DECIMALS = 2
PERCENT = "%"
GREATEST, ERROR = "greatest", "error"
# Letters of what the straight crank has again at 360° - φ, and has there with the other sign.
SAME = ("X", "P", "A_2", "A_5", "A_x", "A", "B_2", "B_x", "B", "H")
OPPOSITE = ("N", "Y", "M_d", "A_4", "A_y", "B_4", "B_y")
# Of what is in no unit of its own.
UNITS = "M R ω², M R² ω²"
WORDS = Texts("motion", "inertia")


# A kernel call takes the peak of a force or of an error, that of the exact force, and a kind of number.
def _itself(peak: Peak, whole: Peak, numbers: Kind) -> Numeric:
    return peak.on(numbers)


def _in_newtons(peak: Peak, whole: Peak, numbers: Kind) -> Numeric:
    return peak.on(numbers) * peak.force.measure.scale(peak.crank, numbers)


def _in_percent(peak: Peak, whole: Peak, numbers: Kind) -> Numeric:
    return 100 * peak.on(numbers) / whole.on(numbers)


@cache
def error_columns() -> Mapping[str, Quantity]:
    """Return what the sheet can show, by keys: greatest forces of a model, its greatest errors, and where."""
    greatest, error = "größter Betrag|greatest", "größter Fehler|greatest error"
    percent, at = "größter Fehler in %|greatest error in %", "bei $φ$|at $φ$"
    names = "größter Betrag in N, N m|greatest in N, N m", "größter Betrag bei φ|greatest at φ"
    error_at = "größter Fehler bei φ|greatest error at φ"
    rows = (
        ("greatest", greatest, greatest, "", 4, Of.GREATEST, _itself),
        ("greatest_n", names[0], "in N, N m", "N, N m", 1, Of.GREATEST, _in_newtons),
        ("greatest_phi", names[1], at, "°", DEGREE_DECIMALS, Of.GREATEST, _itself),
        ("error", error, error, "", 4, Of.ERROR, _itself),
        ("error_percent", percent, percent, PERCENT, PERCENT_DECIMALS, Of.ERROR, _in_percent),
        ("error_phi", error_at, at, "°", DEGREE_DECIMALS, Of.ERROR, _itself),
    )
    return {row[0]: _entry(*row) for row in rows}


def _entry(
    key: str, name: str, heading: str, unit: str, decimals: int, of: Of, kernel: Callable[..., Numeric]
) -> Quantity:
    needs, formulas = (Needs.INERTIA,) if kernel is _in_newtons else (), {EXACT: Formula(kernel)}
    return entry(key, name, "", unit, decimals, formulas, heading, minutes=unit == "°", needs=needs, of=of)


class RodAxis(RatioAxis):
    """The crank ratios or, where there are several rods at one, these."""

    def __init__(self, question: CrankQuestion) -> None:
        super().__init__(question)
        self.cranks = question.cranks
        if several_rods(question):
            self.key = "rod"

    def field(self) -> Field:
        return Field("rod", WORDS["rod"][self.lang]) if self.key == "rod" else super().field()

    def value(self, place: Place) -> Label:
        return str(place["ratio"] + 1) if self.key == "rod" else super().value(place)

    def stub_heading(self) -> Label:
        return WORDS["rod"][self.lang] if self.key == "rod" else super().stub_heading()

    def over_group(self, place: Place) -> Label:
        if self.key != "rod":
            return super().over_group(place)
        return rod_named(self.cranks[place["ratio"]], self.lang)


def several_rods(question: CrankQuestion) -> bool:
    """Whether unlike rods stand beside each other, all at one crank ratio."""
    return len(question.cranks) > 1 and len({*question.ratios}) == 1


def rod_named(crank: Crank, lang: str) -> Label:
    """Return what tells a rod from others: Stange mit a = 0.6 L, k = 0.3 L."""
    rod = known(crank.rod)
    return f"{WORDS['rod'][lang]} $a = {figure(1 - rod.centre)} L$, $k = {gyration_text(rod)} L$"


class InertiaRequest(Request):
    """What is asked for of the rods of these cranks at these angles."""

    @property
    def axis_keys(self) -> tuple[str, ...]:
        return ("rod" if several_rods(self) else "ratio", *super().axis_keys[1:])

    @property
    def told(self) -> list[tuple[Label, ...]]:
        return [(rod_named(one, self.lang),) for one in self.cranks] if several_rods(self) else super().told


class ErrorsRequest(CrankQuestion):
    """What is asked for: the greatest forces and errors of the rods of these cranks."""

    no_column = "there is no column beside the axes; add one, such as greatest"

    @property
    def axis_keys(self) -> tuple[str, ...]:
        return ("rod" if several_rods(self) else "ratio", *super().axis_keys[1:])

    def field(self, column: Column) -> Field:
        own = super().field(column)
        return own if own.unit else own._replace(unit=UNITS)

    @cached_property
    def peak(self) -> Callable[[int, int, str, bool], Peak]:
        """Find where a force, or the error of a model, is greatest, each once."""
        return cache(self._peak)

    def _peak(self, ratio: int, force: int, model: str, of_error: bool) -> Peak:
        rod = known(self.cranks[ratio].rod)
        masses = rod.masses(model, Fraction)
        if of_error:
            # Forces are sums of shares of the masses, and so are errors.
            true = rod.masses(EXACT, Fraction)
            masses = Masses(*(Fraction(one - other) for one, other in zip(masses, true, strict=True)))
        return Peak(FORCES[force], self.cranks[ratio], masses)


def _error_notes(request: Request) -> Iterator[Label]:
    """Yield the greatest errors of what a page of forces shows beside the exact ones, a line a crank."""
    shown = [column.quantity for column in request.page_columns]
    models = [model for model in MODELS if model != EXACT and any(one.model == model for one in shown)]
    names = {force.name["en"] for force in FORCES} & {one.name["en"] for one in shown if one.model in models}
    if not (models and names) or request.method or any(crank.acceleration for crank in request.cranks):
        return
    sheet = ErrorsRequest(
        layout=layout(SHEET), drives=request.drives, lang=request.lang, rounding=request.rounding
    )
    column = bare(error_columns()["error_percent"], EXACT, PERCENT_DECIMALS)
    for ratio, crank in enumerate(request.cranks):
        said = []
        for model in models:
            at = {"ratio": ratio, "model": MODELS.index(model)}
            numbers = [
                (force, _number(sheet, column, {**at, "force": place}, 1))
                for place, force in enumerate(FORCES)
                if force.name["en"] in names
            ]
            errors = ", ".join(f"${one.letter}$ ${number_text(error)}$" for one, error in numbers if error)
            said.append(f"{ROD_MODELS[model][request.lang]} {errors}")
        several = len(request.cranks) > 1
        where = for_ratio(crank.ratio, request.lang, request.layout.ratio_symbol) if several else ""
        if several_rods(request):
            where = f", {rod_named(crank, request.lang)}"
        yield WORDS["errors"][request.lang].format(where=where) + "; ".join(said)


def _force_axis(question: ErrorsRequest) -> ListAxis:
    """The forces with their letters and units."""
    lang = question.lang
    return ListAxis(
        FORCES,
        Field("force", WORDS["force"][lang]),
        lambda force: force.key,
        lambda force: f"{force.name[lang]} ${force.letter}/({force.unit})$",
    )


def _model_axis(question: ErrorsRequest) -> ListAxis:
    """The rod itself and what stands in for it."""
    field = Field("model", WORDS["model"][question.lang])
    return ListAxis(MODELS, field, str, lambda model: ROD_MODELS[model][question.lang], "")


def _rod_notes(question: CrankQuestion, shown: Collection[str]) -> Iterator[Label]:
    """Yield the lines about the connecting rods, and where cranks are straight the symmetry of the letters
    shown."""
    cranks, lang = question.cranks, question.lang
    yield from dict.fromkeys(connecting_rod(crank.rod, lang) for crank in cranks if crank.rod is not None)
    if any(crank.offset or crank.acceleration for crank in cranks):
        return
    said = [
        WORDS[key][lang].format(letters=enumerated_letters([one for one in letters if one in shown], lang))
        for key, letters in (("same", SAME), ("opposite", OPPOSITE))
        if set(letters) & set(shown)
    ]
    if said:
        yield WORDS["mirrored"][lang] + ", ".join(said)


def _notes(question: ErrorsRequest) -> Iterator[Label]:
    yield from drive_notes(question.cranks, question.lang)
    yield from _rod_notes(question, [force.letter for force in FORCES])


def _number(question: ErrorsRequest, column: Column, place: Place, times: int) -> Number | None:
    quantity, decimals, rounding = column.quantity, column.places, question.rounding
    where, model = (place["ratio"], place["force"]), MODELS[place["model"]]
    if quantity.of is Of.ERROR and model == EXACT:
        return None
    peak, whole = question.peak(*where, model, quantity.of is Of.ERROR), question.peak(*where, EXACT, False)
    if quantity.minutes:
        return _angle(peak, times, decimals, rounding)
    if quantity.unit["en"] == PERCENT:
        if whole.vanishes:
            return None
        share = peak.share_of(whole)
        if share is not None:
            return nearest(100 * share, decimals, rounding)
    kernel, unit = quantity.formulas[EXACT].kernel, Fraction(1)
    if quantity.needs:
        unit = question.of_page(peak.force.measure.unit)
    return Number(
        settled(lambda kind: kind.of(unit) * kernel(peak, whole, kind), decimals, rounding), decimals
    )


def _angle(peak: Peak, share: int, decimals: int, rounding: str) -> Number | None:
    """Return where it is greatest, in parts of a degree."""
    if peak.is_level:
        return None
    if peak.exact_degrees is not None:
        return nearest(share * peak.exact_degrees, decimals, rounding)
    return Number(settled(lambda _: share * peak.degrees(), decimals, rounding), decimals)


SUBJECT = Subject(
    key="inertia errors",
    layout=SHEET,
    command=f"inertia --layout {SHEET}",
    axes={"ratio": RodAxis, "force": _force_axis, "model": _model_axis, "column": ColumnAxis},
    axis_keys=("ratio", "force", "model"),
    own_first=False,
    quantities=error_columns,
    number=_number,
    notes=_notes,
)


@cache
def _with_rods() -> Mapping[str, Quantity]:
    """The quantities of the crank drive, and those of the moving rod."""
    return {**registry(), **inertia_registry()}


def _forces_notes(question: Request) -> Iterator[Label]:
    yield from notes(question)
    shown = {column.quantity.symbol.strip("$") for column in question.page_columns}
    yield from _rod_notes(question, shown)


INERTIA = MOTION._replace(
    key="inertia",
    layout="inertia",
    command="inertia",
    quantities=_with_rods,
    axes={**MOTION.axes, "ratio": RodAxis},
    notes=_forces_notes,
    page_notes=_error_notes,
    listed=lambda: (("inertia", one) for one in inertia_registry().values()),
)
