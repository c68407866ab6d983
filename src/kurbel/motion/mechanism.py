"""What commands ask of a crank drive, whichever it is; the straight and the offset crank."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Collection, Iterable, Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any, ClassVar

from kurbel.drive.crank import Crank, DescribedDrive
from kurbel.drive.load import CARD, COMPRESSOR, FORCE, GAS, LOADS, MASSES, PUMP, STEAM
from kurbel.drive.mechanisms import MECHANISMS
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label
from kurbel.motion.notes import drive_notes, loaded_notes, offset_notes
from kurbel.page.quantity import Column, Quantity
from kurbel.reading.given import found_at

if TYPE_CHECKING:
    from kurbel.motion.drives import Drive, SlideDrive
    from kurbel.motion.motion_page import AngleQuestion, Request
    from kurbel.motion.point_quantities import RodEnds

_LENGTHS = ("stroke", "rod", "speed")


class Mechanism(ABC):
    """A crank drive: what its pages are about, the options that describe it, and what it makes of them.

    What it makes of a description are its drives, alike but for their ratios. `takes` are the options that
    describe it on its pages of motion; those of forces also take the stroke. `motion` and `forces` are what
    is drawn unless columns are named: each quantity, and what stands for it where its unit is known.
    `examples` are columns for messages, by command. `drawing` makes the drawing to scale, of a drive, angles,
    language, decimal mark and size, `moving` what moves on interactive pages, of a drive. A drive with a
    `crosshead` has its pages of forces in common with engines, and a polar diagram; of one that is `heavy`
    the forces of moving masses are computed. Of one with a `quick` return no page is over the path: both
    strokes would stand beside one velocity. `rod` finds the ends of its connecting rod, for points on that.
    """

    name: ClassVar[str]
    title: ClassVar[str]
    layout: ClassVar[str]
    forces_layout: ClassVar[str]
    takes: ClassVar[tuple[str, ...]] = ()
    loads: ClassVar[tuple[str, ...]] = ()
    motion: ClassVar[tuple[tuple[str, str], ...]] = ()
    forces: ClassVar[tuple[tuple[str, str], ...]] = ()
    examples: ClassVar[Mapping[str, str]]
    drawing: ClassVar[str]
    moving: ClassVar[str]
    crosshead: ClassVar[bool] = False
    heavy: ClassVar[bool] = True
    quick: ClassVar[bool] = False
    rod: ClassVar[str] = ""

    @property
    def subject(self) -> str:
        return MECHANISMS[self.name].subject

    def check(self, said: DescribedDrive) -> None:
        """Raise ProblemError for a description without what makes it this drive."""
        pushed = uncomputed(self, said.force.name) if said.force else ""
        if sentence := self.lacking(said) or pushed:
            raise ProblemError(sentence)

    def lacking(self, said: DescribedDrive) -> str:
        """Return the sentence that refuses such a description, nothing for others."""
        return ""

    @abstractmethod
    def drives(self, said: DescribedDrive, ratios: Sequence[str]) -> tuple[Any, ...]:
        """Return the drives that were described, of a layout's ratios if nothing gives one."""

    def crank(self, drive: Any) -> Crank:
        """Return what is known of a drive's radius, speed and force."""
        found: Crank = drive.crank
        return found

    def loaded_notes(self, drives: Sequence[Any], lang: str) -> Sequence[Label]:
        """Return what pages of engines say of their drives."""
        return ()

    def masses_notes(
        self, crank: Crank, ratio_symbol: str, lang: str, shown: Collection[str] = ()
    ) -> Iterable[Label]:
        """Return what pages that show quantities of these keys say of the moving masses, and of what else
        acts on the piston."""
        return loaded_notes(crank, ratio_symbol, lang)

    def named(self, quantity: Quantity) -> Quantity:
        """Return a quantity of an engine as it is called in this drive."""
        return quantity

    def headed(self, column: Column) -> Column:
        """Return a column of a page about engines under the heads of this drive."""
        return column

    def rod_ends(self) -> RodEnds:
        """Return what finds the ends of its connecting rod, for points on that."""
        if not self.rod:
            raise ProblemError(
                f"{self.title} has no connecting rod whose points are computed; leave --point out"
            )
        found: RodEnds = found_at(self.rod)
        return found

    def rod_notes(self, drives: Sequence[Any], lang: str) -> Iterable[Label]:
        """Return what pages of points of the rod say of their drives."""
        return drive_notes([self.crank(one) for one in drives], lang)

    @abstractmethod
    def question(self, drives: Sequence[Any], method: str | None = None, **asked: Any) -> AngleQuestion:
        """Return what is asked for of drives at crank angles."""

    @abstractmethod
    def solved(self, drives: Sequence[Any], method: str | None) -> tuple[Drive, ...]:
        """Return the drives for conditions; raise ProblemError where there are none."""

    @abstractmethod
    def conditions(self) -> Mapping[str, Quantity]:
        """Return what can be shown where a condition holds, and can be asked for by its names."""


MOTION = (("x", "x_mm"), ("c", "c_mps"), ("p", "p_mps2"))
FORCES = (
    ("rod_force", "rod_force_n"),
    ("guide_force", "guide_force_n"),
    ("tangential_force", "tangential_force_n"),
    ("radial_force", "radial_force_n"),
    ("torque", "torque_nm"),
)


class StraightCrank(Mechanism):
    name = "straight"
    title = "the straight crank"
    layout = "kinematics"
    forces_layout = "forces"
    takes: ClassVar[tuple[str, ...]] = ("ratio", "stroke", "rod", "speed", "method", "acceleration")
    loads: ClassVar[tuple[str, ...]] = (FORCE, MASSES, STEAM, CARD, COMPRESSOR, PUMP, GAS)
    motion = MOTION
    forces = FORCES
    examples: ClassVar[Mapping[str, str]] = {
        "table": "phi,x,c,p",
        "forces": "phi,x,c,p",
        "plot": "x,c,p",
        "plot forces": "x,c,p",
    }
    drawing = "kurbel.plot.drawings:crank_standing"
    moving = "kurbel.plot.moving:slide_scene"
    crosshead = True
    rod = "kurbel.motion.point_quantities:rod"

    def drives(self, said: DescribedDrive, ratios: Sequence[str]) -> tuple[Crank, ...]:
        return said.cranks(ratios)

    def crank(self, drive: Crank) -> Crank:
        return drive

    def loaded_notes(self, drives: Sequence[Crank], lang: str) -> Sequence[Label]:
        return offset_notes(drives, lang) if any(drive.offset for drive in drives) else ()

    def question(self, drives: Sequence[Crank], method: str | None = None, **asked: Any) -> Request:
        from kurbel.motion.motion_page import Request

        return Request(drives=tuple(drives), method=method, **asked)

    def solved(self, drives: Sequence[Crank], method: str | None) -> tuple[SlideDrive, ...]:
        from kurbel.motion.drives import slide_drives

        return slide_drives(drives, method or "exact")

    def conditions(self) -> Mapping[str, Quantity]:
        from kurbel.motion.drives import slide_columns

        return slide_columns()


class OffsetCrank(StraightCrank):
    name = "offset"
    title = "the offset crank"
    takes = (*StraightCrank.takes, "offset")

    def lacking(self, said: DescribedDrive) -> str:
        if said.offset is not None:
            return ""
        return "the offset crank needs the offset e; add --offset, for example --offset 0.5"


STRAIGHT, OFFSET = StraightCrank(), OffsetCrank()


def mechanism(name: str) -> Mechanism:
    """Return the mechanism of that name."""
    return _at(MECHANISMS[name].place)


@cache
def _at(place: str) -> Mechanism:
    found = found_at(place)
    assert isinstance(found, Mechanism)
    return found


def of_other_mechanisms(
    chosen: Mechanism, given: Collection[str], shared: Collection[str] = ()
) -> dict[str, str]:
    """Return the options among those given that describe other crank drives alone, each with the sentence
    that refuses it; those that all of them share in a command are not among them."""
    refused = {}
    for option in DescribedDrive._fields:
        if option not in given or option in shared or option in chosen.takes:
            continue
        takers = [other for other in MECHANISMS if option in mechanism(other).takes]
        if takers:
            unit = ", whose page is in units of R and v" if option in _LENGTHS else ""
            others = " or ".join(filter(None, (", ".join(takers[:-1]), takers[-1])))
            refused[option] = (
                f"--{option.replace('_', '-')} does not belong to {chosen.title}{unit}; it is for"
                f" --mechanism {others}"
            )
    return refused


def uncomputed(chosen: Mechanism, load: str) -> str:
    """Return the sentence that refuses a mechanism under a load, nothing where it is computed."""
    if load in _loads(chosen):
        return ""
    known = [LOADS[one].title for one in _loads(chosen)] or ["no load"]
    takers = [one.title for one in map(mechanism, MECHANISMS) if load in _loads(one)]
    return (
        f"{chosen.title} under {LOADS[load].title} is not computed;"
        f" {LOADS[load].title} can act on {' or '.join(takers)}, and {chosen.title} takes"
        f" {' or '.join(known)}"
    )


def _loads(chosen: Mechanism) -> list[str]:
    """Return the loads of a mechanism: on a crosshead any force that is known of a share of its stroke."""
    forces = [load for load, one in LOADS.items() if one.place] if chosen.crosshead else []
    return list(dict.fromkeys((*chosen.loads, *forces)))
