"""The pages of the dead centres of crank drives: where they lie, the way between them and its times."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial
from typing import Any

from kurbel.drive.at import turn_time
from kurbel.drive.crank import Crank, DescribedDrive
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind, settled
from kurbel.exact.numerals import Label, Number, figure
from kurbel.kernel.circle import Numeric
from kurbel.linkage.linkage import Linkage
from kurbel.motion.evaluation import Needs
from kurbel.motion.mechanism import Mechanism, mechanism
from kurbel.motion.motion_page import DriveQuestion
from kurbel.motion.notes import size_notes, turns_label
from kurbel.page.axes import ColumnAxis, LetteredRatioAxis, Place
from kurbel.page.quantity import Column, Formula, Need, Quantity, Texts, Words, entry, words
from kurbel.page.subject import Subject
from kurbel.reading.given import as_speed

ANGLES, SHARES, LENGTHS, TIMES = 3, 4, 2, 5
NAMES: Mapping[str, Words] = {
    "straight": words("gerader Kurbeltrieb|straight crank"),
    "offset": words("geschränkter Kurbeltrieb|offset crank"),
    "arc": words("Bogenschubkurbel|arc crank"),
    "beam": words("Balanciermaschine|beam engine"),
    "slotted": words("Kurbelschleife|slotted lever"),
    "yoke": words("Kreuzschubkurbel|Scotch yoke"),
}
# What of these swings.
SWINGING = ("arc", "beam", "slotted")
ROCKER = Need(lambda mechanism: mechanism in SWINGING)
WORDS = Texts("linkage", "dead_centres")


def drives_of(chosen: Mechanism, said: DescribedDrive, ratios: Sequence[str]) -> tuple[Linkage | Crank, ...]:
    """Return the drives that were described, with their speed.

    Raises ProblemError for a mechanism whose links have no dead centres.
    """
    if chosen.name not in NAMES:
        *others, last = (mechanism(name).title for name in NAMES)
        raise ProblemError(
            f"dead centres of {chosen.title} are not computed; those of {', '.join(others)} and {last} are"
        )
    drives = chosen.drives(said, ratios)
    if not drives or isinstance(drives[0], Crank) or said.speed is None:
        return drives
    turns = as_speed(said.speed)
    return tuple(replace(drive, crank=replace(drive.crank, speed=turns)) for drive in drives)


def _time(sign: int, drive: Linkage | Crank, kind: Kind) -> Numeric:
    """Return the time of the outstroke (1) or of the return (-1) in seconds, the crank turning uniformly."""
    return (180 + sign * drive.lead(kind)) / 360 * turn_time(drive.crank, kind)


# Of a drive and a kind of number.
Kernel = Callable[[Any, Kind], Numeric]
Row = tuple[str, str, Label, str, int, Kernel, tuple[Need, ...]]
_ROWS: tuple[Row, ...] = (
    ("phi_i", "innere Totlage|Inner dead centre", "φ_i", "°", ANGLES,
     lambda drive, kind: drive.inner(kind), ()),
    ("phi_o", "äußere Totlage|Outer dead centre", "φ_o", "°", ANGLES,
     lambda drive, kind: drive.outer(kind), ()),
    ("lead", "Kurbelwinkel des Hingangs über 180°|Crank angle of the outstroke above 180°", "Δ", "°", ANGLES,
     lambda drive, kind: drive.lead(kind), ()),
    ("time_ratio", "Zeitverhältnis Hingang zu Rückgang|Time of the outstroke to that of the return",
     "t_h:t_r", "", SHARES, lambda drive, kind: drive.time_ratio(kind), ()),
    ("outstroke_time", "Zeit des Hingangs|Time of the outstroke", "t_h", "s", TIMES, partial(_time, 1),
     (Needs.TIME,)),
    ("return_time", "Zeit des Rückgangs|Time of the return", "t_r", "s", TIMES, partial(_time, -1),
     (Needs.TIME,)),
    ("stroke", "Hub|Stroke", "S", "R", SHARES, lambda drive, kind: drive.way(kind), ()),
    ("stroke_mm", "Hub|Stroke", "S", "mm", LENGTHS,
     lambda drive, kind: drive.way(kind) * drive.crank.millimetres(kind), (Needs.LENGTH,)),
    ("swing", "Schwingungswinkel|Swing", "Δ θ", "°", ANGLES,
     lambda drive, kind: drive.swing(kind), (ROCKER,)),
    ("transmission", "kleinster Übertragungswinkel|Least transmission angle", "μ_(min)", "°", ANGLES,
     lambda drive, kind: drive.least_transmission(kind), ()),
    ("v_mps", "Kurbelzapfengeschwindigkeit|Crank-pin velocity", "v", "m/s", ANGLES,
     lambda drive, kind: drive.crank.pin_velocity(kind), (Needs.SPEED,)),
    ("c_m_mps", "mittlere Kolbengeschwindigkeit|Mean piston speed", "c_m", "m/s", ANGLES,
     lambda drive, kind: drive.crank.mean_velocity(kind, drive.way(kind)), (Needs.MEAN_SPEED,)),
    ("v_c_m", "Verhältnis der Geschwindigkeiten|Ratio of the velocities", "v:c_m", "", SHARES,
     lambda drive, kind: kind.pi / drive.way(kind), ()),
)  # fmt: skip


@cache
def registry() -> Mapping[str, Quantity]:
    """Return every quantity by its key, in the order of the page; a kernel call takes drive and kind."""
    entries = (_entry(*row) for row in _ROWS)
    return {one.key: one for one in entries}


def _entry(
    key: str, name: str, letter: Label, unit: str, decimals: int, kernel: Kernel,
    needs: tuple[Need, ...],
) -> Quantity:  # fmt: skip
    symbol = f"${letter}$"
    heading = "|".join(f"{one} {symbol}" for one in name.split("|"))
    return entry(
        key, name, symbol, f"${unit}$" if unit == "R" else unit, decimals, {"exact": Formula(kernel)},
        heading, needs=needs,
    )  # fmt: skip


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class DeadCentresRequest(DriveQuestion):
    """What is asked for: the dead centres of drives of one mechanism, alike but for their ratios."""

    mechanism: str

    @property
    def caption_parts(self) -> Mapping[str, Label]:
        return {**super().caption_parts, "{drive}": NAMES[self.mechanism][self.lang]}

    def missing(self, quantity: Quantity) -> str:
        if ROCKER in quantity.needs:
            if ROCKER.is_known(self.mechanism):
                return ""
            return f"column {quantity.key} is of a rocker; add --mechanism arc, for example with --rocker 6"
        return super().missing(quantity)


def _number(question: DeadCentresRequest, column: Column, place: Place, times: int) -> Number:
    """The printed number; for the boundaries see linkage/arc_mechanism.py, and for fewer decimals the error
    of one that is not settled."""
    quantity, drive = column.quantity, question.drives[place["ratio"]]
    kernel: Kernel = quantity.formulas["exact"].kernel

    def value(kind: Kind) -> Numeric:
        return times * kernel(drive, kind)

    return Number(settled(value, column.places, question.rounding), column.places)


def _notes(question: DeadCentresRequest) -> Iterator[Label]:
    lang, drives = question.lang, question.drives
    yield WORDS["angles"][lang]
    yield WORDS[question.mechanism if question.mechanism in WORDS else "slide"][lang]
    yield from dict.fromkeys(line for drive in drives for line in _sizes(question, drive))


def _sizes(question: DeadCentresRequest, drive: Linkage | Crank) -> Iterator[Label]:
    """Yield the lines with what was given of a drive beside its ratio."""
    crank = drive.crank
    if not isinstance(drive, Crank):
        moved: Any = mechanism(question.mechanism)
        if said := ", ".join(moved.lengths(drive)):
            yield said
    elif crank.offset:
        yield f"$e = {figure(crank.offset)} R$"
    if crank.radius is None:
        return
    # The speeds that it makes stand in the table.
    turns = [] if crank.speed is None else [turns_label(crank.speed)]
    yield "; ".join([*size_notes([crank]), *turns])


SUBJECT = Subject(
    key="drive dead centres",
    layout="dead-centres",
    command="deadcentres --mechanism arc --rocker 6",
    axes={"ratio": LetteredRatioAxis, "column": ColumnAxis},
    axis_keys=("ratio",),
    quantities=registry,
    number=_number,
    notes=_notes,
)
