"""What a drive is seen as from its side, for a drawing to scale: points in units of R from the shaft."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple, Protocol

from kurbel.page.quantity import Words

Point = tuple[float, float]


class Stand(NamedTuple):
    """A drive at a crank angle: its links by their names, cranks called so, and the pins between them.

    `chains` are the same lines from joint to joint, `letters` those of links, each at a share of its length,
    `lengths` are from x to x along the line of shafts.
    """

    links: Mapping[str, tuple[Point, Point]]
    pins: tuple[Point, ...]
    chains: tuple[tuple[Point, ...], ...]
    letters: tuple[tuple[str, str, float], ...] = ()
    lengths: tuple[tuple[float, float, str], ...] = ()


class Outline(NamedTuple):
    """What does not move: the shafts, about each of which a crank turns, and how far links reach to the left
    and to the right; `stand` is of the place of the crank pin."""

    title: Words
    shafts: tuple[Point, ...]
    left: float
    right: float
    stand: Callable[[Point], Stand]


class Outlined(Protocol):
    """A drive that is drawn by its outline."""

    def outline(self) -> Outline: ...
