"""Drawings read from their SVG files as from paper: places in mm, values by the ticks, parts that move."""

from __future__ import annotations

import json
import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from cli import printed
from numpy.typing import NDArray

import kurbel

SVG = "{http://www.w3.org/2000/svg}"
# Units of a file, 1/72 inch, in a millimetre.
MM = 72 / 25.4
Floats = NDArray[np.float64]
Points = NDArray[np.complex128]
Point = tuple[float, float]
OF_DRAWINGS = ("width", "height", "polar", "over_path", "infinite", "animate", "seconds")
_POINT = re.compile(r"[ML] (\S+) (\S+)")
_FRAMES = re.compile(r"@keyframes ([\w-]+)\{((?:[\d.]+%\{[^}]*\})+)\}")
_FRAME = re.compile(r"([\d.]+)%\{([^}]*)\}")
_NUMBER = re.compile(r"-?\d+(?:\.\d+)?")


class Line(NamedTuple):
    """A line: the id of its group, its path, its style, and its corners in mm, the imaginary part upward."""

    name: str
    path: str
    look: Mapping[str, str]
    points: Points


class Paper:
    """A drawing: the groups of its file by their ids."""

    def __init__(self, svg: bytes | str) -> None:
        self.root = ET.fromstring(svg)
        self.groups = {key: one for one in self.root.iter() if (key := one.get("id"))}

    @cached_property
    def title(self) -> str:
        return self.root.findtext(f"{SVG}title") or ""

    @cached_property
    def words(self) -> list[str]:
        """Return what is written on it, of a drawing with --text."""
        return ["".join(one.itertext()) for one in self.root.iter(f"{SVG}text")]

    def names(self, pattern: str) -> list[str]:
        """Return the ids that a pattern fits, in the order of the file."""
        return [name for name in self.groups if re.fullmatch(pattern, name)]

    def line(self, name: str) -> Line:
        """Return the first line of a group."""
        return next(one for one in self.lines(self.groups[name]))

    def points(self, name: str) -> Points:
        return self.line(name).points

    def lines(self, within: ET.Element | None = None) -> Iterator[Line]:
        """Yield the lines of the groups that bear names."""
        for group in (self.root if within is None else within).iter(f"{SVG}g"):
            for path in group.findall(f"{SVG}path"):
                drawn = path.get("d", "")
                pairs = np.asarray(_POINT.findall(drawn), float).reshape(-1, 2) / MM
                look = dict(re.findall(r"([a-z-]+): ([^;]+)", path.get("style", "")))
                yield Line(group.get("id", ""), drawn, look, np.asarray(pairs[:, 0] - 1j * pairs[:, 1]))

    def values(self, name: str) -> tuple[Floats, Floats]:
        """Return the values of a curve across and up, as the ticks of its axes say, of one with --text."""
        panels = [one for key, one in self.groups.items() if key.startswith("axes_")]
        own = next(one for one in panels if self.groups[name] in one.iter())
        points = self.points(name)
        across = next(scale for one in (own, *panels) if (scale := _scale(one, "x")) is not None)
        up = _scale(own, "y")
        assert up is not None
        return np.asarray(np.polyval(across, points.real)), np.asarray(np.polyval(up, points.imag))


def _scale(panel: ET.Element, axis: str) -> Floats | None:
    """Return slope and start of the values on an axis by its first and last tick; None without any text."""
    places, values = [], []
    for one in panel.iter():
        text = one.find(f".//{SVG}text")
        line = one.find(f".//{SVG}path")
        if re.match(f"{axis}tick_", one.get("id", "")) and text is not None and line is not None:
            x, y = map(float, _POINT.findall(line.get("d", ""))[0])
            places.append(x / MM if axis == "x" else -y / MM)
            said = "".join(text.itertext()).rstrip("°").replace(",", ".").replace("\u2212", "-")
            values.append(float(said))
    if len(places) < 2:
        return None
    slope = (values[-1] - values[0]) / (places[-1] - places[0])
    return np.asarray((slope, values[0] - slope * places[0]))


def plotted(*words: str, **environment: str) -> Paper:
    """Return what a line draws, of which the first word is the command."""
    return Paper(printed(*words, "-f", "svg", "--text", **environment).out)


def drawn(command: Callable[..., Any], *args: Any, **given: Any) -> kurbel.Drawing:
    """Return the drawing of a page in Python; what its drawing is asked for stands among the options."""
    own = {name: given.pop(name) for name in [*given] if name in OF_DRAWINGS}
    page: kurbel.Table = command(*args, **given)
    return page.plot(**own)


class Film(Paper):
    """A drawing that moves as a browser moves it: its style sheet, and what that says of each part.

    `frames` are keyframes by their names: shares of the run with the numbers of a rule.
    """

    def __init__(self, svg: bytes | str) -> None:
        super().__init__(svg)
        sheets = (one for one in self.root.iter(f"{SVG}style") if one.get("class") == "film-style")
        self.sheet = "".join(one.text or "" for one in sheets)
        self.moving = {key for key in self.groups if key.startswith("film-")}
        self.rules = dict(re.findall(r"^#([\w-]+)\{(animation-name[^}]*)\}", self.sheet, re.MULTILINE))
        self.frames = {
            name: [
                (float(percent) / 100, tuple(map(float, _NUMBER.findall(said))))
                for percent, said in _FRAME.findall(body)
            ]
            for name, body in _FRAMES.findall(self.sheet)
        }
        first, last, at, seconds = map(float, self.root.get("data-film", "").split())
        self.run = first, last, at, seconds

    def first(self, key: str) -> str:
        """Return the id of the first element of a part."""
        return f"film-{key}" if f"film-{key}" in self.moving else f"film-{key}-1"

    def still(self, key: str) -> Sequence[Point]:
        """Return the points of a part where it is drawn, in units of the file, or of its mark."""
        marks = [*self.groups[self.first(key)].iter(f"{SVG}use")]
        if marks:
            return [(float(one.get("x", "")), float(one.get("y", ""))) for one in marks]
        return [(float(x), float(y)) for x, y in _POINT.findall(self.line(self.first(key)).path)]

    def numbers(self, name: str, angle: float) -> tuple[float, ...]:
        """Return the numbers of keyframes at an angle, on a straight line between two."""
        first, last, _, _ = self.run
        share, frames = (angle - first) / (last - first), self.frames[f"film-{name}"]
        for (begin, start), (end, stop) in pairwise(frames):
            if begin <= share <= end:
                part = (share - begin) / (end - begin)
                return tuple(a + part * (b - a) for a, b in zip(start, stop, strict=True))
        raise AssertionError(f"{name} says nothing of {angle}°")

    def at(self, key: str, angle: float) -> list[complex]:
        """Return where the points of a part are at an angle, in mm: shifted, and turned about its origin."""
        across, down, *turn = self.numbers(key, angle)
        x0 = y0 = 0.0
        if turn:
            origin = re.search(r"transform-origin:(\S+)px (\S+)px", self.rules[self.first(key)])
            assert origin is not None
            x0, y0 = map(float, origin.groups())
        cosine, sine = (part(math.radians(turn[0] if turn else 0)) for part in (math.cos, math.sin))
        return [
            complex(
                x0 + across + cosine * (x - x0) - sine * (y - y0),
                -(y0 + down + sine * (x - x0) + cosine * (y - y0)),
            )
            / MM
            for x, y in self.still(key)
        ]


def film_data(page: str) -> Mapping[str, Any]:
    """Return what the script of a page reads."""
    found = re.search(r'class="film-data">(.*?)</script>', page, re.DOTALL)
    assert found is not None
    told: Mapping[str, Any] = json.loads(found[1])
    return told
