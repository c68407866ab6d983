"""The crank drives that --mechanism chooses between, a line each; motion/mechanism.py says what one knows."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple


class Registered(NamedTuple):
    """What the pages of a mechanism are about, where it stands, and what sets it apart in the help.

    A module that has it beside a SUBJECT of its own registers that too.
    """

    subject: str
    place: str
    note: str = ""


MECHANISMS: Mapping[str, Registered] = {
    "straight": Registered("motion", "kurbel.motion.mechanism:STRAIGHT", "default"),
    "offset": Registered("motion", "kurbel.motion.mechanism:OFFSET"),
    "arc": Registered("arc crank", "kurbel.linkage.arc.mechanism:MECHANISM", "the rod moves a rocker"),
    "parallel": Registered("parallel crank", "kurbel.linkage.parallel:MECHANISM", "two equal cranks"),
    # Another mechanism is one more line here.
}
# The crank drives without a crosshead, whose pages are their own.
LINKAGES = tuple(name for name, one in MECHANISMS.items() if one.subject != "motion")
# What pages about the motion of a mechanism can be about.
MOTIONS = tuple(dict.fromkeys(one.subject for one in MECHANISMS.values()))
# Where the subjects of the linkages stand.
SUBJECTS: Mapping[str, str] = {
    MECHANISMS[name].subject: f"{MECHANISMS[name].place.partition(':')[0]}:SUBJECT" for name in LINKAGES
}


def described() -> str:
    """Return the help of the choice: straight (default), offset or arc (the rod moves a rocker)."""
    *first, last = (f"{name} ({one.note})" if one.note else name for name, one in MECHANISMS.items())
    return f"{', '.join(first)} or {last}."
