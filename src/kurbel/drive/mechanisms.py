"""The crank drives that --mechanism chooses between, a line each; motion/mechanism.py says what one knows."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple


class Pages(NamedTuple):
    """Where it stands what pages are about, and what prints one, with all that it needs."""

    place: str
    sample: str


class Registered(NamedTuple):
    """What the pages of a mechanism are about, where it stands, and what sets it apart in the help.

    A module that has it beside a SUBJECT of its own registers that too, whose pages need those `options`.
    """

    subject: str
    place: str
    note: str = ""
    options: str = ""


MECHANISMS: Mapping[str, Registered] = {
    "straight": Registered("motion", "kurbel.motion.mechanism:STRAIGHT", "default"),
    "offset": Registered("motion", "kurbel.motion.mechanism:OFFSET"),
    "arc": Registered(
        "arc crank", "kurbel.linkage.arc_mechanism:MECHANISM", "the rod moves a rocker", " --rocker 6"
    ),
    "parallel": Registered("parallel crank", "kurbel.linkage.parallel:MECHANISM", "two equal cranks"),
    "beam": Registered("beam engine", "kurbel.linkage.beam:MECHANISM", "a beam engine", " --beam 3"),
    "yoke": Registered("Scotch yoke", "kurbel.linkage.yoke:MECHANISM", "a pin in a slot"),
    "slotted": Registered("slotted lever", "kurbel.linkage.slotted:MECHANISM", "quick return", " --pivot 2"),
    # Another mechanism is one more line here.
}
# The crank drives without a crosshead, whose pages are their own.
LINKAGES = tuple(name for name, one in MECHANISMS.items() if one.subject != "motion")
# What pages about the motion of a mechanism can be about.
MOTIONS = tuple(dict.fromkeys(one.subject for one in MECHANISMS.values()))
# The subjects of the linkages.
SUBJECTS: Mapping[str, Pages] = {
    one.subject: Pages(f"{one.place.partition(':')[0]}:SUBJECT", f"table --mechanism {name}{one.options}")
    for name, one in MECHANISMS.items()
    if name in LINKAGES
}


def described() -> str:
    """Return the help of the choice: straight (default), offset or arc (the rod moves a rocker)."""
    *first, last = (f"{name} ({one.note})" if one.note else name for name, one in MECHANISMS.items())
    return f"{', '.join(first)} or {last}."
