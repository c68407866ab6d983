"""Drawings that move as a browser moves them: parts of an SVG file at any time, by its style sheet alone."""

from __future__ import annotations

import json
import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

SVG = "{http://www.w3.org/2000/svg}"
# Points of a path of straight pieces, in units of the file: 1/72 inch.
_POINT = re.compile(r"[ML] (\S+) (\S+)")
_FRAMES = re.compile(r"@keyframes ([\w-]+)\{((?:[\d.]+%\{[^}]*\})+)\}")
_FRAME = re.compile(r"([\d.]+)%\{([^}]*)\}")
_NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
MM = 72 / 25.4
Point = tuple[float, float]


class Film(NamedTuple):
    """The elements by their ids, what the style sheet says of these, and its keyframes by their names: shares
    of the run with the numbers of a rule."""

    root: ET.Element
    sheet: str
    run: tuple[float, float, float, float]
    elements: Mapping[str, ET.Element]
    rules: Mapping[str, str]
    frames: Mapping[str, Sequence[tuple[float, tuple[float, ...]]]]

    def points(self, key: str) -> list[Point]:
        """Return the points of the path of an element, the first of its part, where it is drawn."""
        path = self.elements[self.first(key)].find(f".//{SVG}path")
        assert path is not None
        return [(float(x), float(y)) for x, y in _POINT.findall(path.get("d", ""))]

    def first(self, key: str) -> str:
        """Return the id of the first element of a part."""
        return f"film-{key}" if f"film-{key}" in self.elements else f"film-{key}-1"

    def numbers(self, name: str, angle: float) -> tuple[float, ...]:
        """Return the numbers of keyframes at an angle, on a straight line between two."""
        first, last, _, _ = self.run
        share, frames = (angle - first) / (last - first), self.frames[f"film-{name}"]
        for (begin, start), (end, stop) in pairwise(frames):
            if begin <= share <= end:
                part = (share - begin) / (end - begin)
                return tuple(a + part * (b - a) for a, b in zip(start, stop, strict=True))
        raise AssertionError(f"{name} says nothing of {angle}°")

    def moved(self, key: str, points: Sequence[Point], angle: float) -> list[Point]:
        """Return where points of a part are at an angle: shifted, and turned about its origin."""
        across, down, *turn = self.numbers(key, angle)
        if not turn:
            return [(x + across, y + down) for x, y in points]
        origin = re.search(r"transform-origin:(\S+)px (\S+)px", self.rules[self.first(key)])
        assert origin is not None
        x0, y0 = map(float, origin.groups())
        cosine, sine = math.cos(math.radians(turn[0])), math.sin(math.radians(turn[0]))
        return [
            (
                x0 + across + cosine * (x - x0) - sine * (y - y0),
                y0 + down + sine * (x - x0) + cosine * (y - y0),
            )
            for x, y in points
        ]

    def at(self, key: str, angle: float) -> list[Point]:
        """Return where the points of a part are at an angle."""
        return self.moved(key, self.points(key), angle)


def read(svg: bytes | str) -> Film:
    """Return the film of a file."""
    root = ET.fromstring(svg)
    sheet = "".join(one.text or "" for one in root.iter(f"{SVG}style") if one.get("class") == "film-style")
    elements = {key: one for one in root.iter() if (key := one.get("id", "")).startswith("film-")}
    rules = dict(re.findall(r"^#([\w-]+)\{(animation-name[^}]*)\}", sheet, re.MULTILINE))
    frames = {
        name: [
            (float(percent) / 100, tuple(map(float, _NUMBER.findall(said))))
            for percent, said in _FRAME.findall(body)
        ]
        for name, body in _FRAMES.findall(sheet)
    }
    first, last, at, seconds = map(float, root.get("data-film", "").split())
    return Film(root, sheet, (first, last, at, seconds), elements, rules, frames)


def data(page: str) -> Mapping[str, Any]:
    """Return what the script of a page reads."""
    found = re.search(r'class="film-data">(.*?)</script>', page, re.DOTALL)
    assert found is not None
    told: Mapping[str, Any] = json.loads(found[1])
    return told
