"""`kurbel table --mechanism`: which crank drive a table is about, and the options that describe it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple, TypeVar

import click

from kurbel.cli.options import Name, without_foreign, without_outdone
from kurbel.errors import ProblemError

Command = TypeVar("Command", bound=Callable[..., Any])


class Mechanism(NamedTuple):
    """A crank drive: what its pages are about, their default layout, the options that describe it alone."""

    subject: str
    layout: str
    takes: tuple[str, ...]


_SLIDE = ("ratio", "stroke", "rod", "speed", "method")
MECHANISMS = {
    "straight": Mechanism("motion", "kinematics", _SLIDE),
    "offset": Mechanism("motion", "kinematics", (*_SLIDE, "offset")),
    "arc": Mechanism("arc crank", "arc", ("ratio", "offset", "rocker", "pivot", "method")),
    "parallel": Mechanism("parallel crank", "parallel", ()),
}
_NEEDED = {"offset": ("offset", "offset e", "0.5"), "arc": ("rocker", "length of its rocker", "6")}
_LENGTHS = ("stroke", "rod", "speed")
RIVALS = (("mechanism", {"layout"}), ("layout", {"mechanism"}))


def mechanism_options(command: Command) -> Command:
    """Add --mechanism, --rocker and --pivot."""
    options = (
        click.option("--mechanism", type=Name("mechanism", lambda: MECHANISMS),
                     help="straight (default), offset, arc (the rod moves a rocker) or parallel (two equal"
                     " cranks)."),
        click.option("--rocker", metavar="B",
                     help="Arc crank: length of the rocker in units of R."),
        click.option("--pivot", metavar="D;H",
                     help="Arc crank: the rocker's pivot along and across the slide, in units of R; default:"
                     " as far as the rod is long, and B above the slide line."),
    )  # fmt: skip
    for option in reversed(options):
        command = option(command)
    return command


def chosen_mechanism(options: dict[str, Any]) -> tuple[str, dict[str, Any]]:
    """Return the mechanism and its options; those of others are refused where they were typed.

    Without --mechanism the layout tells it, else --offset.
    """
    options = without_outdone(options, RIVALS)
    name = options["mechanism"] or _by_layout(options["layout"]) or _by_offset(options["offset"])
    options = without_foreign(options, dict(_foreign(name)))
    if name in _NEEDED and options[_NEEDED[name][0]] is None:
        option, what, example = _NEEDED[name]
        raise ProblemError(
            f"the {name} crank needs the {what}; add --{option}, for example --{option} {example}"
        )
    return name, {**options, "layout": options["layout"] or MECHANISMS[name].layout}


def _by_layout(layout: str | None) -> str | None:
    from kurbel.page.layouts import layout_of

    if layout is None:
        return None
    subject = layout_of(layout, [one.subject for one in MECHANISMS.values()]).subject
    fitting = [name for name, one in MECHANISMS.items() if one.subject == subject]
    return fitting[0] if len(fitting) == 1 else None


def _by_offset(offset: str | None) -> str:
    return "straight" if offset is None else "offset"


def _foreign(name: str) -> Iterator[tuple[str, str]]:
    """Yield the options of other mechanisms, each with the sentence that refuses it."""
    for option in {option: None for one in MECHANISMS.values() for option in one.takes}:
        takers = [other for other, one in MECHANISMS.items() if option in one.takes]
        if name not in takers:
            unit = ", whose page is in units of R and v" if option in _LENGTHS else ""
            others = " or ".join(filter(None, (", ".join(takers[:-1]), takers[-1])))
            yield (
                option,
                f"--{option} does not belong to the {name} crank{unit}; it is for --mechanism {others}",
            )
