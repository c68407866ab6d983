"""A drive by what it says of its outline, as it moves."""

from __future__ import annotations

from collections.abc import Sequence

from kurbel.kernel.circle import circle
from kurbel.linkage.linkage import Linkage, Outline
from kurbel.page.steps import Joint, Line, Link, Point, Scene
from kurbel.plot.moving.turn import TURN, crossed, joint


def links_scene(drive: Linkage, angles: Sequence[float] = TURN) -> Scene | None:
    """Return the drive, nothing for one without an outline."""
    outline = drive.outline()
    if outline is None:
        return None
    first = outline.stand(_crank_pin(0))
    letters = {name: letter.strip("$") for name, letter, _ in first.letters}
    return Scene(
        low=(outline.left - 0.3, -1.3),
        high=(outline.right + 0.3, 1.3),
        fixed=(
            Line("centre", ((outline.left - 0.3, 0), (outline.right + 0.3, 0))),
            *(line for shaft in outline.shafts for line in crossed(shaft)),
            *(Line("bearing", (shaft,)) for shaft in outline.shafts),
        ),
        links=tuple(
            Link(
                "crank" if "crank" in name else name,
                _end(outline, name, 0, angles),
                _end(outline, name, 1, angles),
                letter,
            )
            for name in first.links
            for letter in [letters.get(name, "")]
        ),
        pins=tuple(_pin(outline, number, angles) for number in range(len(first.pins))),
    )


def _end(outline: Outline, link: str, end: int, angles: Sequence[float]) -> Joint:
    return joint(lambda angle: outline.stand(_crank_pin(angle)).links[link][end], angles)


def _pin(outline: Outline, number: int, angles: Sequence[float]) -> Joint:
    return joint(lambda angle: outline.stand(_crank_pin(angle)).pins[number], angles)


def _crank_pin(angle: float) -> Point:
    point = circle(angle)
    return point.cosine, point.sine
