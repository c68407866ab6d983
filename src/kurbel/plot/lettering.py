"""The texts of a drawing of a mechanism: each seeks a place that is free of lines. In mm on the page."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kurbel.plot.place import (
    CLEAR,
    GAP,
    Chosen,
    Ink,
    Labelled,
    LabelPlace,
    Points,
    beside,
    box_points,
    densely,
    spot,
    touching,
)
from kurbel.plot.style import BLACK, DOTS_PER_MM, MM, SMALL_TEXT, TEXT_SIZE, THIN

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# In mm. The ends of lines are found as exactly as that, within the outline that is before them.
STEP = 0.02


class Hole(NamedTuple):
    """What hides lines below its level: a disc, or a box, by its centre and half its sides."""

    centre: Points
    half: Points
    is_round: bool
    level: float

    def hides(self, points: Points) -> Points:
        away = np.abs(points - self.centre)
        if self.is_round:
            return np.asarray(np.hypot(*away.T) < self.half[0] - STEP / 2)
        return np.asarray((away < self.half - STEP / 2).all(axis=1))


def cut(line: Points, holes: Sequence[Hole]) -> Points | None:
    """Return a line with gaps (NaN) where holes hide it, or None if none does."""
    low, high = line.min(axis=0), line.max(axis=0)
    near = [one for one in holes if ((one.centre + one.half > low) & (one.centre - one.half < high)).all()]
    if not near:
        return None
    dense, is_corner = _dense(line)
    hidden = np.logical_or.reduce([one.hides(dense) for one in near])
    if not hidden.any():
        return None
    # Of what is seen the corners stay, and both ends of each piece.
    ends = np.diff(hidden.astype(int), prepend=1, append=1)
    kept = ~hidden & (is_corner | (ends[:-1] == -1) | (ends[1:] == 1))
    dense[hidden & (ends[:-1] == 1)] = np.nan
    kept |= np.isnan(dense).any(axis=1)
    return dense[kept] if kept.any() else np.full((1, 2), np.nan)


def _dense(line: Points) -> tuple[Points, Points]:
    """Return points so close together on a line, and which of them are its own."""
    lengths = np.hypot(*np.diff(line, axis=0).T)
    pieces, corners = [], []
    for start, end, length in zip(line[:-1], line[1:], lengths, strict=True):
        share = np.linspace(0, 1, max(2, int(length / STEP)), endpoint=False)[:, None]
        pieces.append(start + share * (end - start))
        corners.append(share[:, 0] == 0)
    return np.concatenate([*pieces, line[-1:]]), np.concatenate([*corners, [True]])


Size = tuple[float, float]

# How far the ground of a text reaches beyond it, and what other texts leave free about it, across and up.
GROUND, SPACE = 0.2, (1.6, 0.4)
# The level of the grounds, before all but the strong links.
IN_FRONT = 5.5
# Nearer than that no line leads to a text.
LEAST_LEADER = 4.2
# The width of lines of which both edges count.
STRONG_LINE = 0.4
# How far texts are from the edge of the page.
MARGIN = 0.5
# By how much broader a text is taken beside a line of the widest, and where there is no room there.
BROAD = (0.4, 2.0, 4.0)
# The place on the other side of a line is as good as one so much farther along it.
OTHER_SIDE = 8.0
# Beside a line no text is nearer to its end than this share of it.
NEAR_END = 0.1
# How much farther than touching it texts are from a point, and where they are at the end of a leader line.
NEARER, FARTHER = (0.1, 0.7, 1.3, 2.0, 3.0), (4.5, 6.0, 8.0, 10.0, 13.0)
# What covering a line, a solid part and another text counts, for each point of them.
WEIGHTS = {"line": 1.0, "part": 2.0, "text": 20.0}


class Letters(NamedTuple):
    """A text with the size of its ink, and the way from where it is set to the middle of that."""

    text: str
    look: dict[str, object]
    size: Size
    middle: Points

    @classmethod
    def of(cls, text: str, points: float, turned: bool = False) -> Letters:
        from matplotlib.textpath import TextPath

        outline = TextPath((0, 0), text, size=points / MM)
        # Where a contour closes there is no point of it.
        corners = np.asarray(outline.vertices)[np.asarray(outline.codes) != TextPath.CLOSEPOLY]
        low, high = corners.min(axis=0), corners.max(axis=0)
        size, middle = (float(high[0] - low[0]), float(high[1] - low[1])), (low + high) / 2
        if turned:
            size, middle = size[::-1], np.asarray((-middle[1], middle[0]))
        return cls(text, {"fontsize": points, "rotation": 90 * turned}, size, middle)


class Text(NamedTuple):
    """Letters, the centres of their box to choose from in groups, the best first, and what they belong to.

    A leader line leads from a point to a text that does not touch it, if there is one; to one of those `far`
    only where it would cover something in all groups. `name` is its id in SVG, if it has one.
    """

    letters: Letters
    groups: Sequence[Points]
    own: Labelled
    leader: Points | None = None
    name: str = ""
    far: Points | None = None


class Lettering:
    """The texts that a drawing is to have, and their places once all else is drawn; the grounds of those that
    cover a line. Texts that are asked for while there is a `name` have it in SVG, with a number."""

    def __init__(self, axes: Axes) -> None:
        self.axes = axes
        self.name = ""
        self.texts: list[Text] = []
        self.grounds: list[Hole] = []

    def on_page(self, *points: tuple[float, float]) -> Points:
        """Return points of the axes in mm from the lower left corner of the page."""
        return np.asarray(self.axes.transData.transform(points)) / DOTS_PER_MM

    def beside_line(
        self,
        points: Points,
        text: str,
        share: float,
        side: int,
        turned: bool = False,
        ends: bool = False,
        led: bool = False,
    ) -> None:
        """Ask for a text beside a line, on its left (1) or right (-1), at best at a share of its length.

        With `ends` it may stand around one of them where there is no other room, the first at best, and one
        that may be `led` at the end of a leader line from there. A turned text is read from the right.
        """
        letters = Letters.of(text, TEXT_SIZE, turned)
        line = densely(points, min(0.5, _length(points) / 12))
        count = len(line)
        middle = line[int(NEAR_END * count) : count - int(NEAR_END * count)]
        along = 0.5 * np.abs(np.arange(len(middle)) - share * len(middle))
        rank = np.concatenate([along + OTHER_SIDE * (side < 0), along + OTHER_SIDE * (side > 0)])
        near, *far = (
            beside(middle, (letters.size[0] + broad, letters.size[1] + broad))[rank.argsort(kind="stable")]
            for broad in BROAD
        )
        beyond = [touching(end, letters.size, end - line[count // 2], NEARER) for end in (line[0], line[-1])]
        asked = Text(letters, (near, *(beyond if ends else ()), *far), Labelled(line, CLEAR))
        if led:
            at, along = line[int(share * (count - 1))], line[-1] - line[0]
            away = touching(at, letters.size, side * np.asarray((-along[1], along[0])), FARTHER)
            asked = asked._replace(leader=at, far=away[_across(away - at, along)])
        self._ask(asked)

    def beside_point(self, point: Points, outward: Points, text: str, clear: float) -> None:
        """Ask for a small text beside a point, at best in a direction, and so far from it."""
        letters = Letters.of(text, SMALL_TEXT)
        near = touching(point, letters.size, outward, NEARER)
        far = touching(point, letters.size, outward, FARTHER)
        ahead = [one[_ahead(one - point, outward)] for one in (near, far)]
        self._ask(Text(letters, (*ahead, near, far), Labelled(point[None], clear), point))

    def at_end(self, end: Points, side: int, text: str, other: Points) -> None:
        """Ask for a small text at the upper (1) or lower (-1) end of an upright line, as near to its middle
        as there is room; where there is none it stands at another end of the line."""
        letters = Letters.of(text, SMALL_TEXT)
        half, up = letters.size[0] / 2, side * (letters.size[1] / 2 + GAP)
        across = np.asarray(sorted(np.arange(-half - SPACE[0], half + SPACE[0] + 0.1, 0.4), key=abs))[
            :, None
        ] * (1, 0)
        row, opposite = end + across + (0, up), other + across - (0, up)
        lower = np.concatenate([row + side * np.asarray((0, more)) for more in (1.0, 2.5, 4.0)])
        far = touching(end, letters.size, np.asarray((0.0, side)), FARTHER)
        self._ask(Text(letters, (row, lower, opposite, far), Labelled(end[None], CLEAR), end))

    def _ask(self, text: Text) -> None:
        name = f"{self.name}-text-{len(self.texts)}" if self.name else ""
        self.texts.append(text._replace(name=name))

    def write(self, width: float, height: float) -> None:
        """Write all texts on a page of a size, one after the other, where they cover least."""
        frame = (MARGIN, MARGIN, width - MARGIN, height - MARGIN)
        ink, written = self._ink(), np.empty((0, 2, 2))
        # What a line is called stands near it: letters of points have room farther away, too.
        for one in sorted(self.texts, key=lambda text: text.far is None):
            size, led = one.letters.size, one.leader if one.far is None else None
            allowed = partial(_unhindered, point=led, size=size, written=written)
            place = spot(one.groups, size, one.own, ink, frame, allowed)
            if one.far is not None and (place is None or place.covers):
                allowed = partial(_unhindered, point=one.leader, size=size, written=written)
                away = spot((one.far,), size, one.own, ink, frame, allowed)
                if away is not None and not away.covers:
                    place, led = away, one.leader
            if place is None:
                continue
            taken = size[0] + SPACE[0], size[1] + SPACE[1]
            ink = ink.more(box_points(place.centre, taken, 0.5), WEIGHTS["text"])
            box = np.stack((place.centre, np.asarray(taken) / 2))
            written = np.concatenate((written, box[None]))
            self._set(one, place)
            if led is not None and not place.covers:
                leader = np.stack((led, led + _leaders(led, place.centre, size)))
                if _length(leader) > LEAST_LEADER:
                    ink = ink.more(densely(leader), WEIGHTS["line"])
                    drawn = self.axes.plot(*self.on_axes(leader).T, color=BLACK, linewidth=THIN, zorder=3)
                    drawn[0].set_gid(f"{one.name}-leader" if one.name else None)

    def _set(self, one: Text, place: LabelPlace) -> None:
        """Set letters; those that cover a line have a ground before it, unless it is a strong one."""
        letters = one.letters
        x, y = map(float, self.on_axes((place.centre - letters.middle)[None])[0])
        look: dict[str, Any] = {"ha": "left", "va": "baseline", "rotation_mode": "anchor", "zorder": 8}
        self.axes.text(x, y, letters.text, **(look | letters.look)).set_gid(one.name or None)
        if place.covers:
            self.grounds.append(Hole(place.centre, np.asarray(letters.size) / 2 + GROUND, False, IN_FRONT))

    def _ink(self) -> Ink:
        """Return the lines of the drawing and the areas of its solid parts."""
        ink = Ink(np.empty((0, 2)), np.empty(0))
        for line in self.axes.lines:
            points = self.on_page(*np.asarray(line.get_xydata()))
            for edge in _edges(points, line.get_linewidth() / MM):
                ink = ink.more(densely(edge), WEIGHTS["line"])
        for patch in self.axes.patches:
            corners = np.asarray(patch.get_verts()) / DOTS_PER_MM
            low, high = corners.min(axis=0), corners.max(axis=0)
            ink = ink.more(box_points((low + high) / 2, tuple(high - low), 0.5), WEIGHTS["part"])
        return ink

    def on_axes(self, points: Points) -> Points:
        """Return points of the axes from those on the page."""
        return np.asarray(self.axes.transData.inverted().transform(points * DOTS_PER_MM))


def _edges(points: Points, width: float) -> list[Points]:
    """Return a line, of a strong straight one its two edges."""
    if width < STRONG_LINE or len(points) > 2:
        return [points]
    (across, up) = (points[1] - points[0]) / (_length(points) or 1) * width / 2
    return [points + np.asarray((-up, across)) * side for side in (1, -1)]


def _length(points: Points) -> float:
    return float(np.hypot(*np.diff(points, axis=0).T).sum())


def _across(ways: Points, along: Points) -> Chosen:
    """Return which ways lead rather away from a line than along it."""
    return np.asarray(np.abs(ways @ along) <= 0.8 * np.hypot(*ways.T) * np.hypot(*along))


def _ahead(ways: Points, outward: Points) -> Chosen:
    """Return which ways are not backwards from a direction."""
    return np.asarray(ways @ outward >= -0.2 * np.hypot(*ways.T) * np.hypot(*outward))


def _leaders(point: Points, centres: Points, size: Size) -> Points:
    """Return the ways from a point to boxes of texts."""
    half = np.asarray(size) / 2 + 0.3
    return np.asarray(np.clip(point, centres - half, centres + half) - point)


def _unhindered(centres: Points, point: Points | None, size: Size, written: Points) -> Chosen:
    """Return which texts would have a leader line that crosses no other text; of these boxes are given."""
    if point is None:
        return np.ones(len(centres), bool)
    ways = _leaders(point, centres, size)
    half, (x, y) = np.abs(ways[:, None]) / 2, np.moveaxis(ways, 1, 0)[:, :, None]
    apart = (point + ways / 2)[:, None] - written[None, :, 0]
    across = np.abs(x * apart[..., 1] - y * apart[..., 0]) / 2
    # Line and box are apart if they are along an axis of the page, or square to the line.
    beside = (np.abs(apart) > half + written[None, :, 1]).any(axis=2)
    beside |= across > half[..., 1] * written[None, :, 1, 0] + half[..., 0] * written[None, :, 1, 1]
    return np.asarray(beside.all(axis=1) | (np.hypot(*ways.T) < LEAST_LEADER))
