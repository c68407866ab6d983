"""Crank drives without a crosshead: how they stand, their forces and pages, and what conditions ask."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cached_property, lru_cache
from types import MappingProxyType
from typing import Any, ClassVar, NamedTuple, TypeVar

from kurbel.drive.at import At
from kurbel.drive.crank import Crank
from kurbel.drive.load import FORCE
from kurbel.drive.mechanisms import LINKAGES, MECHANISMS
from kurbel.drive.moved import DeadCentres
from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Label, Number, figure
from kurbel.kernel import linkage
from kurbel.kernel.circle import Circle, Numeric
from kurbel.motion import motion_quantities
from kurbel.motion.bulk import long_records
from kurbel.motion.captions import direction_notes
from kurbel.motion.drives import Drive
from kurbel.motion.entries import Formulas, on_return
from kurbel.motion.evaluation import OUT, Needs, Places, certified_at
from kurbel.motion.mechanism import FORCES as IN_DRAWINGS
from kurbel.motion.mechanism import Mechanism, mechanism
from kurbel.motion.motion_page import CURVES, AngleQuestion, check_pairs
from kurbel.motion.motion_quantities import Force
from kurbel.motion.notes import force_notes, moving_notes, size_notes, turns_label
from kurbel.page.axes import AngleAxis, ColumnAxis, Place, RatioAxis
from kurbel.page.layouts import layout
from kurbel.page.quantity import Column, Formula, Of, Quantity, Words, filled, words
from kurbel.page.subject import Subject, subject

Point = tuple[float, float]


class LinkagePosition(NamedTuple):
    """A drive at a crank angle, in units of R from the shaft: its links by their names, cranks called so, and
    the pins between them. `chains` are the same lines from joint to joint, `letters` those of links, each at
    a share of its length, `lengths` are from x to x along the line of shafts.
    """

    links: Mapping[str, tuple[Point, Point]]
    pins: tuple[Point, ...]
    chains: tuple[tuple[Point, ...], ...]
    letters: tuple[tuple[str, str, float], ...] = ()
    lengths: tuple[tuple[float, float, str], ...] = ()


class Outline(NamedTuple):
    """What does not move: the shafts, about each of which a crank turns, and how far links reach to the left
    and to the right, down and up; `stand` is of the place of the crank pin. About `pivots` links turn; what
    slides does so along `lines` at these heights."""

    title: Words
    shafts: tuple[Point, ...]
    left: float
    right: float
    stand: Callable[[Point], LinkagePosition]
    low: float = -1.0
    high: float = 1.0
    pivots: tuple[Point, ...] = ()
    lines: tuple[float, ...] = (0.0,)


class Linkage(DeadCentres, ABC):
    """A crank drive without a crosshead: what moves, on any kind of number.

    A stroke is OUT (1) or RETURN (-1); everything on it counts from the dead centre where it begins and in
    its direction. The circle is that of the crank angle φ, on RETURN of φ less 180°.
    """

    __slots__ = ()

    crank: Crank
    # The stroke of one that turns evenly to and fro, in units of R.
    reach: ClassVar[int] = 2

    def of(self, crank: Crank) -> Linkage:
        """Return the drive with what else is known of its crank."""
        own: Any = self
        changed: Linkage = replace(own, crank=crank)
        return changed

    @property
    def stroke(self) -> Label:
        """The stroke as pages of conditions print it, nothing where no line holds it."""
        return f"{self.reach} R"

    def way(self, kind: Kind) -> Numeric:
        """Return the way between the dead centres in units of R."""
        return kind.of(Fraction(self.reach))

    @abstractmethod
    def place(self, stroke: int, circle: Circle[Numeric], kind: Kind) -> linkage.Place[Numeric]:
        """Return where the driven end is: its way, its velocity, the slants of rod and crank against it."""

    def at(self, stroke: int, circle: Circle[Numeric], numbers: Kind, method: str, of: object = None) -> At:
        """Return what kernel calls take. What quantities are `of`, where that is known, may choose formulas
        with few roots for them."""
        return At(circle, self, numbers, stroke, place=self.place(stroke, circle, numbers))

    def outline(self) -> Outline | None:
        """Return what it is seen as from its side, unless a drawing of its own knows."""
        return None


def in_strokes(path: Quantity) -> Quantity:
    """Return the path as a share of the stroke of its drive."""
    head, unit = words("in Teilen des Hubes|in strokes"), words("Hub|stroke")
    shares = {"exact": share_of(path.formulas["exact"])}
    return path._replace(key="path_stroke", heading=head, unit=unit, names=("s",), formulas=shares)


def share_of(whole: Formula) -> Formula:
    """Return the formula of a path as a share of the stroke."""
    return whole._replace(kernel=lambda at: whole.kernel(at) / at.drive.way(at.numbers))


Linked = TypeVar("Linked", bound="LinkageRequest")
FORCES: Mapping[str, Force] = {
    **{key: one for key, one in motion_quantities.FORCES.items() if key not in motion_quantities.EFFORT},
    "rod_force": Force(
        "Stangenkraft|Rod force", "S",
        "$S$ am Stangenende, auf dem Hingang Druck, auf dem Rückgang Zug"
        "|$S$ at the rod's end, thrust on the outstroke, pull on the return",
    ),
    "guide_force": Force(
        "Schwingenkraft|Rocker force", "N",
        "$N$ längs der Schwinge auf das Stangenende, nach der Seite, auf der in diesem Hub der Kurbelzapfen"
        " läuft"
        "|$N$ along the rocker on the rod's end, towards the side on which the crank pin runs in that stroke",
    ),
    "crosshead_pin_force": Force(
        "Kraft am Schwingenzapfen|Rocker-pin force", "G",
        "$G$ Betrag am Zapfen von Stange und Schwinge|$G$ magnitude at the pin of rod and rocker",
    ),
}  # fmt: skip
_KERNELS: Mapping[str, Callable[[linkage.Place[Numeric]], Numeric]] = {
    "rod_force": linkage.rod_force,
    "guide_force": linkage.rocker_force,
    "tangential_force": linkage.tangential_force,
    "radial_force": linkage.radial_force,
}


def force_formula(key: str, printed: Label, symbols: tuple[Label, ...] = ()) -> Formula:
    """Return the formula of a force as a page prints it."""
    kernel = _KERNELS[key]
    return Formula(lambda at: kernel(at.place), printed, symbols)


def force_entries(printed: Mapping[str, Formula], masses: bool = False) -> Iterator[Quantity]:
    """Yield the forces with these formulas as shares of F and in newtons, and the torque that they make.

    A drive that may have moving `masses` has also the forces that these alone show.
    """
    newton = motion_quantities.in_newtons if masses else _alone
    for key in {**printed, **(FORCES if masses else {})}:
        shares = {"exact": printed[key]} if key in printed else {}
        yield from motion_quantities.force_entries(key, FORCES[key], shares, newton(key, shares), of=Of.FORCE)
    torque = {"exact": force_formula("tangential_force", "$M_d/(F R) = T/F$")}
    yield from motion_quantities.torque_entries(torque, newton("tangential_force", torque), of=Of.FORCE)


def sine_forces() -> Iterator[Quantity]:
    """Yield the forces of a drive whose slide goes as the crank pin does along its way."""
    return force_entries(
        {
            "tangential_force": force_formula("tangential_force", "$T/F = sin φ$"),
            "radial_force": force_formula("radial_force", "$Z/F = cos φ$"),
        }
    )


def _alone(key: str, shares: Formulas) -> Formulas:
    return shares


class LinkageRequest(AngleQuestion):
    """What is asked for of these drives, alike but for their ratios, at these angles."""

    def check(self) -> None:
        super().check()
        check_pairs(self.layout, f"{self.subject.key}s")

    def too_long(self) -> str:
        return f"the table has {len(self)} rows"

    @cached_property
    def at(self) -> Callable[[int, int], Places]:
        """Return the places of a drive at an angle, which the columns of a row share."""
        return lru_cache(1)(lambda drive, angle: Places(self.drives[drive], self.angles[angle]))

    @property
    def moving(self) -> tuple[str, Any]:
        # Coupled axles are parallel cranks.
        own = (name for name in LINKAGES if MECHANISMS[name].subject == self.subject.key)
        return next(own, "parallel"), self.drives[0]

    def solved(self) -> tuple[Drive, ...]:
        chosen = mechanism(self.moving[0])
        of_motion = self.subject.key == chosen.subject and chosen.conditions()
        return chosen.solved(self.drives, None) if of_motion else ()


def linkage_subject(
    key: str,
    layout: str,
    command: str,
    quantities: Callable[[], Mapping[str, Quantity]],
    notes: Callable[[Linked], Iterator[Label]],
    caption: Callable[[Linked], Label] | None = None,
    ratios: bool = False,
) -> Subject[Linked]:
    """Return what pages of a drive are about; `ratios` if it has a rod."""

    def listed() -> Iterator[tuple[str, Quantity]]:
        for one in quantities().values():
            yield command.replace("table", "forces") if one.of is Of.FORCE else command, one

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
        drawn=CURVES,
    )


def _number(question: LinkageRequest, column: Column, place: Place, times: int) -> Number:
    places = question.at(place.get("ratio", 0), place["angle"])
    scaled = certified_at(column.quantity, "exact", places, column.places, question.rounding)
    return Number(scaled * times, column.places)


def captioned(question: LinkageRequest, for_drive: Label | None = None) -> Label:
    """Return the layout's caption with its quantities and what tells the drive, else its one ratio.

    The ratio stands at the end of a caption without a place for it, unless rows or heads have it.
    """
    parts, layout = question.caption_parts, question.layout
    caption = layout.caption[question.lang]
    if for_drive is None:
        for_drive = parts["{for_ratio}"]
        if "{for_drive}" not in caption and "ratio" not in (*layout.stub, *layout.across):
            caption += "{for_drive}"
    return filled(caption, {**parts, "{for_drive}": for_drive}.items())


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
        if any(one.of is not Of.FORCE for one in shown):
            yield motion[question.lang]
        yield from (one[question.lang] for one in further)
        yield from force_lines(question, force)

    return notes


def formula_line(formulas: Sequence[Formula]) -> Label:
    """Return these formulas as they are printed, each once, then what is to be said of their letters."""
    printed = (one.printed for one in formulas)
    symbols = (symbol for one in formulas for symbol in one.symbols)
    return ", ".join(filter(None, dict.fromkeys((*printed, *symbols))))


GAIN = words(
    ", zu jeder Beschleunigung kommt $α/ω^2$ mal die Geschwindigkeit"
    "|, to every acceleration comes $α/ω^2$ times the velocity"
)


def gain_label(crank: Crank, lang: str) -> Label:
    """Return the angular acceleration of a crank, and what it adds."""
    return f'$α = {figure(crank.acceleration)} "rad/s"^2${GAIN[lang]}'


def force_lines(
    question: LinkageRequest, force: Words, named: Mapping[str, Words] = MappingProxyType({})
) -> Iterator[Label]:
    """Yield in which directions forces are positive, and what makes newtons of them.

    Of a drive that may have masses, `named` says where they are.
    """
    lang, shown = question.lang, [column.quantity for column in question.page_columns]
    first: Crank = question.drives[0].crank
    if any(one.of is Of.FORCE for one in shown):
        acting = [force[lang]] if first.force or not first.moving else []
        said = (one.direction[lang] for one in shown if one.of is Of.FORCE and one.direction)
        yield "; ".join(dict.fromkeys([*acting, *said]))
        columns = [column for column in question.page_columns if column.quantity.of is Of.FORCE]
        yield from direction_notes(question, columns)
    sizes = size_notes(question.cranks)
    if first.speed is not None and any(Needs.SPEED in one.needs for one in shown):
        sizes.append(turns_label(first.speed))
    if first.acceleration:
        sizes.append(gain_label(first, lang))
    yield from sizes
    yield from force_notes(question.cranks, lang)
    if first.moving is not None:
        yield from moving_notes(first, question.layout.ratio_symbol, lang, named, sizes)


class LinkageDrive(Drive):
    """A drive with dead centres at 0° and 180°, and the layout whose page speaks of it.

    It has a rod if its pages are of ratios.
    """

    def __init__(self, drive: Linkage, page: str) -> None:
        super().__init__(drive, self.columns_of(page))
        self.page = page
        self.has_rod = "ratio" in subject(layout(page).subject).axes

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (self.drive, self.page)

    @staticmethod
    def columns_of(page: str) -> Mapping[str, Quantity]:
        """Return the outstroke's quantities of such pages, which stand for either stroke."""
        known = subject(layout(page).subject).quantities()
        return {key: one for key, one in known.items() if one.stroke == OUT}

    @property
    def stroke(self) -> Label:
        found: Label = self.drive.stroke
        return found

    def closing_lines(self, question: Any) -> Iterator[Label]:
        """Yield what pages of the drive say of it, on both strokes."""
        page = layout(self.page)
        drives = tuple(one.drive for one in question.drives)
        known = subject(page.subject).quantities()
        keys = [column.key for column in question.page_columns if column.key in known]
        both = (each for key in keys or ["path"] for each in (key, on_return(key)) if each in known)
        request = LinkageRequest(
            layout=page, angles=(Fraction(0),), drives=drives, columns=tuple(both), lang=question.lang
        )
        for said in request.subject.notes(request):
            assert isinstance(said, str)
            yield said


class LinkageMechanism(Mechanism):
    """A crank drive whose pages are of its own subject, under no load or a constant force."""

    loads: ClassVar[tuple[str, ...]] = (FORCE,)
    forces = IN_DRAWINGS
    drawing = "kurbel.plot.drawings:links_standing"
    moving = "kurbel.plot.moving:links_scene"
    examples: ClassVar[Mapping[str, str]] = {
        "table": "phi,path,rocker",
        "forces": "phi,tangential_force",
        "plot": "path,velocity",
        "plot forces": "rod_force,guide_force",
    }

    def question(self, drives: Sequence[Linkage], method: str | None = None, **asked: Any) -> LinkageRequest:
        return LinkageRequest(drives=tuple(drives), **asked)

    def rod_notes(self, drives: Sequence[Any], lang: str) -> Iterable[Label]:
        yield from size_notes(one.crank for one in drives)
        if (speed := drives[0].crank.speed) is not None:
            yield turns_label(speed)
        if drives[0].crank.acceleration:
            yield gain_label(drives[0].crank, lang)

    def solved(self, drives: Sequence[Any], method: str | None) -> tuple[Drive, ...]:
        return tuple(LinkageDrive(one, self.layout) for one in drives)

    def conditions(self) -> Mapping[str, Quantity]:
        return LinkageDrive.columns_of(self.layout)
