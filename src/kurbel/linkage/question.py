"""What is asked for of crank drives without a crosshead, and what their pages have in common."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from kurbel.drive.crank import Crank
from kurbel.drive.mechanisms import LINKAGES, MECHANISMS
from kurbel.exact.numerals import Label, Number
from kurbel.linkage.quantities import FORCE
from kurbel.motion.captions import direction_notes, force_notes, moving_notes, size_notes, turns_label
from kurbel.motion.evaluation import NEEDS, certified
from kurbel.motion.page import CURVES, AngleQuestion, check_pairs, long_records
from kurbel.page.axes import AngleAxis, ColumnAxis, Place, RatioAxis
from kurbel.page.quantity import Column, Formula, Quantity, Words, enumerated, filled, for_ratio
from kurbel.page.subject import Subject

if TYPE_CHECKING:
    from kurbel.motion.drives import Drive


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class LinkageRequest(AngleQuestion):
    """What is asked for of these drives, alike but for their ratios, at these angles."""

    def check(self) -> None:
        super().check()
        check_pairs(self.layout, f"{self.subject.key}s")

    def too_long(self) -> str:
        return f"the table has {len(self)} rows"

    @property
    def moving(self) -> tuple[str, Any]:
        # Coupled axles are parallel cranks.
        own = (name for name in LINKAGES if MECHANISMS[name].subject == self.subject.key)
        return next(own, "parallel"), self.drives[0]

    def solved(self) -> tuple[Drive, ...]:
        from kurbel.motion.mechanism import mechanism

        chosen = mechanism(self.moving[0])
        of_motion = self.subject.key == chosen.subject and chosen.conditions()
        return chosen.solved(self.drives, None) if of_motion else ()


def linkage_subject(
    key: str,
    layout: str,
    command: str,
    quantities: Callable[[], Mapping[str, Quantity]],
    notes: Callable[[LinkageRequest], Iterator[Label]],
    caption: Callable[[LinkageRequest], Label] | None = None,
    ratios: bool = False,
) -> Subject:
    """Return what pages of a drive are about; `ratios` if it has a rod."""

    def listed() -> Iterator[tuple[str, Quantity]]:
        for one in quantities().values():
            yield command.replace("table", "forces") if one.of == FORCE else command, one

    over_angle = {"angle": AngleAxis, "column": ColumnAxis}
    return Subject(
        key=key,
        layout=layout,
        command=command,
        axes={"ratio": RatioAxis, **over_angle} if ratios else over_angle,
        axis_keys=("ratio", "phi") if ratios else ("phi",),
        quantities=quantities,
        number=_number,
        caption=caption or captioned,
        notes=notes,
        listed=listed,
        rows=long_records,
        options=NEEDS,
        drawn=CURVES,
    )


def _number(question: LinkageRequest, column: Column, place: Place, times: int) -> Number:
    drive, angle = question.drives[place.get("ratio", 0)], question.angles[place["angle"]]
    scaled = certified(column.quantity, "exact", drive, angle, column.places, question.rounding)
    return Number(scaled * times, column.places)


def captioned(question: LinkageRequest, for_drive: Label | None = None) -> Label:
    """Return the layout's caption with its quantities and what tells the drive, else its one ratio.

    The ratio stands at the end of a caption without a place for it, unless rows or heads have it.
    """
    lang, layout = question.lang, question.layout
    names = enumerated((one.quantity.name[lang] for one in question.page_columns), lang)
    caption = layout.caption[lang]
    if for_drive is None:
        one = len(question.ratios) == 1
        for_drive = for_ratio(question.ratios[0], lang, layout.ratio_symbol) if one else ""
        if "{for_drive}" not in caption and "ratio" not in (*layout.stub, *layout.across):
            caption += "{for_drive}"
    return filled(caption, [("{quantities}", names), ("{for_drive}", for_drive)])


def plain_notes(force: Words, motion: Words, *further: Words) -> Callable[[LinkageRequest], Iterator[Label]]:
    """Return what yields the lines below the pages of a drive without a rod: its formulas, what is to be said
    of its motion and of all its pages, and which force it is that acts on it."""

    def notes(question: LinkageRequest) -> Iterator[Label]:
        # A page says what its layout shows, though not all of it was chosen.
        own = (question.entry(column.quantity) for column in question.layout.columns)
        shown = [one for one in own if not question.missing(one)]
        shown += (column.quantity for column in question.page_columns)
        if line := formula_line([one.formulas["exact"] for one in shown]):
            yield line
        if any(one.of != FORCE for one in shown):
            yield motion[question.lang]
        yield from (one[question.lang] for one in further)
        yield from force_lines(question, force)

    return notes


def formula_line(formulas: Sequence[Formula]) -> Label:
    """Return these formulas as they are printed, each once, then what is to be said of their letters."""
    printed = (one.printed for one in formulas)
    symbols = (symbol for one in formulas for symbol in one.symbols)
    return ", ".join(filter(None, dict.fromkeys((*printed, *symbols))))


def force_lines(
    question: LinkageRequest, force: Words, named: Mapping[str, Words] = MappingProxyType({})
) -> Iterator[Label]:
    """Yield in which directions forces are positive, and what makes newtons of them.

    Of a drive that may have masses, `named` says where they are.
    """
    lang, shown = question.lang, [column.quantity for column in question.page_columns]
    first: Crank = question.drives[0].crank
    if any(one.of == FORCE for one in shown):
        acting = [force[lang]] if first.force or not first.moving else []
        said = (one.direction[lang] for one in shown if one.of == FORCE and one.direction)
        yield "; ".join(dict.fromkeys([*acting, *said]))
        columns = [column for column in question.page_columns if column.quantity.of == FORCE]
        yield from direction_notes(question, columns)
    sizes = size_notes(question.cranks)
    if first.speed is not None and any(one.needs == "speed" for one in shown):
        sizes.append(turns_label(first.speed))
    yield from sizes
    yield from force_notes(question.cranks, lang)
    if first.moving is not None:
        yield from moving_notes(first, question.layout.ratio_symbol, lang, named, sizes)
