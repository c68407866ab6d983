"""The pages of the connecting rod that moves a rocker: its forces, by the rod itself and by two masses."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

from kurbel.drive.at import At, known
from kurbel.exact.numerals import Label
from kurbel.kernel.parts import Parted, parted_rocker
from kurbel.kernel.rocker import LoadedRocker
from kurbel.linkage.arc.rocker import RockerCrank
from kurbel.linkage.question import LinkageRequest, linkage_subject
from kurbel.motion.captions import size_notes, turns_label
from kurbel.motion.inertia import RodForce, rod_entries
from kurbel.motion.mechanism import mechanism
from kurbel.motion.notes.rod import connecting_rod
from kurbel.motion.parts.accelerations import rocker_entries
from kurbel.motion.parts.forces import part_entries
from kurbel.page.quantity import Quantity


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class RockerInertiaRequest(LinkageRequest):
    """What is asked for of these drives with their rods, each called as in its own mechanism."""

    def entry(self, key: str) -> Quantity:
        called: Quantity = _moved(self.drives[0]).named(super().entry(key))
        return called


@cache
def rocker_inertia_registry() -> Mapping[str, Quantity]:
    """Return every force by every model, as of a rod between crank and crosshead, and Ensslin's parts."""
    parts = (*rocker_entries(_parted), *part_entries(_parted, slide=False))
    return {one.key: one for one in (*rod_entries(_kernel), *parts)}


def _parted(at: At) -> Parted:
    masses = known(at.drive.crank.rod).masses("exact", at.numbers.of)
    return parted_rocker(at.circle, at.place, at.arc, masses)


def _kernel(force: RodForce, model: str) -> Callable[[At], Any]:
    def kernel(at: At) -> Any:
        masses = known(at.drive.crank.rod).masses(model, at.numbers.of)
        return force.formula(LoadedRocker(at.circle, at.place, at.arc, masses))

    return kernel


def _moved(drive: RockerCrank) -> Any:
    return mechanism(drive.mechanism)


def _caption(request: LinkageRequest) -> Label:
    caption: Label = _moved(request.drives[0]).speech.caption(request)
    return caption


def _notes(request: LinkageRequest) -> Iterator[Label]:
    lang, drives = request.lang, request.drives
    yield from (note[lang] for note in request.layout.notes)
    yield from size_notes(request.cranks)
    speech = _moved(drives[0]).speech
    yield from dict.fromkeys(turns_label(one.crank.speed) for one in drives if one.crank.speed)
    yield from dict.fromkeys(connecting_rod(known(one.crank.rod), lang, "L", speech.words) for one in drives)
    yield from (speech.dead_centres(drive, lang) for drive in drives)


# Its quantities are listed as those of the slide.
SUBJECT = linkage_subject(
    "rocker inertia",
    layout="inertia-rocker",
    command="inertia --mechanism arc --rocker 6",
    quantities=rocker_inertia_registry,
    caption=_caption,
    notes=_notes,
    ratios=True,
)._replace(listed=tuple)
