"""What moves in a drawing over a run of crank angles, and the film as SVG: the drawing as it stands at one of
them, and a style sheet by which its parts go their ways; and as pictures at equal steps of the run, in a GIF.

No script: CSS moves parts by turning and shifting them, so that links keep their length at every moment.
Between two keyframes, the fewest that do, a part leaves its true place by at most TOLERANCE, once along each
axis and once by its turn at its far end. For readers who ask for reduced motion all stands as it is drawn.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from copy import copy
from io import BytesIO
from itertools import chain, pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kurbel.plot.place import Chosen, Points
from kurbel.plot.style import DOTS_PER_MM, LINES, MM, WHITE

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D
    from matplotlib.transforms import Transform

# A turn in so many steps: between two of them a joint leaves a straight way by less than 0.001 mm.
STEPS = 720


class Way(NamedTuple):
    """Numbers at rising angles, a row for each; where an angle comes twice they jump."""

    angles: Points
    rows: Points

    def at(self, angle: float) -> Points:
        """Return the numbers at an angle, on the way between two rows; at a jump those before it."""
        return np.asarray([np.interp(angle, self.angles, column) for column in self.rows.T])


class Part(NamedTuple):
    """Artists of one axes that move as one, without a change of size.

    The way has the place of one of their points, in values of the axes, and by how many degrees they have
    turned, counter-clockwise; so many mm they reach beyond the point.
    """

    name: str
    artists: tuple[Artist, ...]
    axes: Axes
    way: Way
    reach: float = 0.0


class GrowingLine(NamedTuple):
    """A line of which a share from its beginning is seen."""

    name: str
    line: Line2D
    axes: Axes
    way: Way

    def points_at(self, angle: float) -> Points:
        """Return the points of what is seen of the whole line at an angle."""
        points = np.asarray(self.line.get_xydata())
        lengths = np.concatenate(((0,), np.hypot(*np.diff(points, axis=0).T).cumsum()))
        end = float(self.way.at(angle)[0]) * lengths[-1]
        tip = [np.interp(end, lengths, column) for column in points.T]
        return np.vstack((points[lengths < end], tip))


class VisibleArtists(NamedTuple):
    """Artists that are seen where their way is 1 and not where it is 0, which it becomes by jumps alone."""

    name: str
    artists: tuple[Artist, ...]
    way: Way


class Film(NamedTuple):
    """A run from one crank angle to another in so many seconds, over and over, drawn as it stands `at` one.

    `above` are artists that stand still before what moves.
    """

    first: float
    last: float
    at: float
    seconds: float
    parts: tuple[Part, ...] = ()
    grown: tuple[GrowingLine, ...] = ()
    seen: tuple[VisibleArtists, ...] = ()
    above: tuple[Artist, ...] = ()

    def share(self, angle: float) -> float:
        """Return the share of the run at an angle."""
        return (angle - self.first) / (self.last - self.first)


def straight_way(first: float, last: float, rows: tuple[tuple[float, ...], tuple[float, ...]]) -> Way:
    """Return the way that goes evenly from one row to another."""
    return Way(np.asarray((first, last)), np.asarray(rows))


def crossing(angles: Points, other: Chosen, first: Points, second: Points) -> tuple[Points, Points]:
    """Return the angles and the rows of what has the first rows, or where it is so the second ones; it jumps
    where that changes."""
    changes = np.flatnonzero(np.diff(other.astype(int))) + 1
    order = np.sort(np.concatenate((np.arange(len(angles)), changes)))
    is_other = other[order]
    # Of the two rows at a change the first has what was before.
    before = np.flatnonzero(np.diff(order) == 0)
    is_other[before] = ~is_other[before]
    return angles[order], np.where(is_other[:, None], second[order], first[order])


def toggled(angles: Points, seen: Chosen) -> Way:
    """Return the way of what is seen at some angles: it jumps at each of them where that changes."""
    unseen = np.zeros((len(angles), 1))
    return Way(*crossing(angles, seen, unseen, unseen + 1))


@contextmanager
def as_it_stands(film: Film) -> Iterator[None]:
    """Draw what is seen of a film where it stands: the shares of lines, and nothing that is unseen there."""
    whole = [(grown.line, np.array(grown.line.get_xydata())) for grown in film.grown]
    unseen = {one for seen in film.seen if not seen.way.at(film.at)[0] for one in seen.artists}
    try:
        for grown in film.grown:
            grown.line.set_data(*grown.points_at(film.at).T)
        for one in unseen:
            one.set_visible(False)
        yield
    finally:
        for line, points in whole:
            line.set_data(*points.T)
        for one in unseen:
            one.set_visible(True)


def keyframes(way: Way, scale: Points, tolerance: float) -> Way:
    """Return the rows of a way between which a straight line, evenly run through, leaves it by so little.

    Each number counts by its scale. Both rows of a jump are kept.
    """
    rows = way.rows * scale
    jumps = np.flatnonzero(np.diff(way.angles) == 0)
    ends = sorted({0, len(rows) - 1, *jumps.tolist(), *(jumps + 1).tolist()})
    kept, open_ = set(ends), list(pairwise(ends))
    while open_:
        begin, end = open_.pop()
        if end - begin < 2:
            continue
        angles = way.angles[begin + 1 : end]
        share = (angles - way.angles[begin]) / (way.angles[end] - way.angles[begin])
        line = rows[begin] + share[:, None] * (rows[end] - rows[begin])
        away = np.abs(rows[begin + 1 : end] - line).max(axis=1)
        if away.max() > tolerance:
            middle = begin + 1 + int(away.argmax())
            kept.add(middle)
            open_ += [(begin, middle), (middle, end)]
    order = sorted(kept)
    return Way(way.angles[order], way.rows[order])


# In mm.
TOLERANCE = 0.0035
# The share of the run between the two keyframes of a jump, in percent.
JUMP = 0.0001
PREFIX = "film-"
_DEFINITIONS = re.compile(r"(?= <defs>)")


class Rule(NamedTuple):
    """Keyframes, by their percents, of the artists with these ids; what is said of these besides."""

    name: str
    ids: tuple[str, ...]
    frames: tuple[tuple[str, str], ...]
    more: str = ""


def named(film: Film) -> None:
    """Give the artists of a film the ids by which its style sheet knows them."""
    for part in film.parts:
        for one, key in zip(part.artists, _ids(part.name, len(part.artists)), strict=True):
            one.set_gid(key)
    for grown in film.grown:
        grown.line.set_gid(*_ids(grown.name))


def moving(svg: str, film: Film, figure: Figure) -> str:
    """Return the file of the figure as it stands with the style sheet that moves it."""
    rules = [*_rules(film, figure)]
    sheet = "".join(_sheet(rules, film))
    style = f' <style type="text/css" class="film-style">{sheet}</style>\n'
    run = (film.first, film.last, film.at, film.seconds)
    svg = svg.replace("<svg ", f'<svg data-film="{" ".join(map(figures, run))}" ', 1)
    return _DEFINITIONS.sub(lambda place: style, svg, count=1)


def figures(value: float, decimals: int = 6) -> str:
    """Return a number as short as it can be with so many decimals."""
    text = f"{value:.{decimals}f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def _ids(name: str, count: int = 1) -> tuple[str, ...]:
    base = f"{PREFIX}{name}"
    return (base,) if count == 1 else tuple(f"{base}-{number}" for number in range(1, count + 1))


def _rules(film: Film, figure: Figure) -> Iterator[Rule]:
    height = figure.get_figheight() * 72
    for part in film.parts:
        yield _moved(part, film, height)
    for grown in film.grown:
        yield _grown(grown, film)
    for seen in film.seen:
        ids = tuple(str(one.get_gid()) for one in seen.artists)
        rows, (now,) = keyframes(seen.way, np.ones(1), 0.5), seen.way.at(film.at)
        frames = _frames(rows, film, lambda row: f"opacity:{figures(row[0])}")
        yield Rule(f"{PREFIX}{seen.name}", ids, frames, "" if now else "opacity:0")


def _moved(part: Part, film: Film, height: float) -> Rule:
    places = part.axes.transData.transform(part.way.rows[:, :2]) / DOTS_PER_MM
    way = Way(part.way.angles, np.column_stack((places, part.way.rows[:, 2])))
    rows = keyframes(way, np.asarray((1, 1, math.radians(part.reach))), TOLERANCE)
    (x, y, turn), turns = way.at(film.at), len({*way.rows[:, 2]}) > 1

    def pose(row: Points) -> str:
        shift = f"translate({figures((row[0] - x) * MM, 3)}px,{figures((y - row[1]) * MM, 3)}px)"
        return f"transform:{shift}" + (f" rotate({figures(turn - row[2], 4)}deg)" if turns else "")

    origin = f"transform-origin:{figures(x * MM, 3)}px {figures(height - y * MM, 3)}px" if turns else ""
    return Rule(f"{PREFIX}{part.name}", _ids(part.name, len(part.artists)), _frames(rows, film, pose), origin)


def _grown(grown: GrowingLine, film: Film) -> Rule:
    points = grown.axes.transData.transform(np.asarray(grown.line.get_xydata())) / DOTS_PER_MM
    length = float(np.hypot(*np.diff(points, axis=0).T).sum()) * MM
    rows = keyframes(grown.way, np.asarray((length / MM,)), TOLERANCE)
    frames = _frames(rows, film, lambda row: f"stroke-dashoffset:{figures(length * (1 - row[0]), 3)}px")
    (share,) = grown.way.at(film.at)
    dashes = f"stroke-dasharray:{figures(length, 3)}px {figures(length + 9, 3)}px"
    return Rule(
        f"{PREFIX}{grown.name}", _ids(grown.name), frames,
        f"{dashes};stroke-dashoffset:{figures(length * (1 - share), 3)}px",
    )  # fmt: skip


def _frames(way: Way, film: Film, said: Callable[[Points], str]) -> tuple[tuple[str, str], ...]:
    found = []
    for place, (angle, row) in enumerate(zip(way.angles, way.rows, strict=True)):
        percent = 100 * film.share(float(angle))
        if place + 1 < len(way.angles) and way.angles[place + 1] == angle:
            percent -= JUMP
        found.append((figures(percent, 4), said(row)))
    return tuple(found)


def _sheet(rules: Sequence[Rule], film: Film) -> Iterator[str]:
    """Yield the style sheet: what is the same of all parts, keyframes, and which parts have them."""
    of: dict[str, list[Rule]] = {}
    for rule in rules:
        yield "@keyframes {}{{{}}}\n".format(
            rule.name, "".join(f"{percent}%{{{said}}}" for percent, said in rule.frames)
        )
        for key in rule.ids:
            of.setdefault(key, []).append(rule)
    ids = ",".join(f"#{key}" for key in of)
    begun = figures(-film.seconds * film.share(film.at))
    yield f"{ids}{{animation:{figures(film.seconds)}s linear {begun}s infinite}}\n"
    for key, own in of.items():
        more = ";".join(rule.more for rule in own if rule.more)
        names = ",".join(rule.name for rule in own)
        yield f"#{key}{{animation-name:{names}{';' + more if more else ''}}}\n"
    yield f"@media (prefers-reduced-motion:reduce){{{ids}{{animation-play-state:paused}}}}\n"


# Pictures a second, of a run at most; a slower one has longer pictures.
RATE, MOST_FRAMES = 20, 240
# In an inch: a drawing 120 mm wide has 709 dots across; a large one has no more than so many either way.
GIF_DOTS, MOST_DOTS = 150, 1600
# From each colour of a drawing to white there are so many, from black as many more greys.
SHADES, GREYS = 7, 16


def gif(figure: Figure, film: Film) -> bytes:
    """Return the film as a GIF that runs without end, the same bytes every time. Only inside `style`."""
    from PIL import Image

    delays = frame_delays(film.seconds)
    count = len(delays)
    angles = [film.first + (film.last - film.first) * number / count for number in range(count)]
    palette = Image.new("P", (1, 1))
    palette.putpalette(bytes(chain.from_iterable(_palette())))
    plain = [
        Image.fromarray(one).quantize(palette=palette, dither=Image.Dither.NONE)
        for one in frames(figure, film, angles)
    ]
    stream = BytesIO()
    plain[0].save(
        stream, format="GIF", save_all=True, append_images=plain[1:], duration=[10 * one for one in delays],
        loop=0, disposal=1, optimize=True,
    )  # fmt: skip
    return stream.getvalue()


def _palette() -> Iterator[tuple[int, int, int]]:
    """Yield the colours of pictures: greys, and those of curves with what lies between them and white."""
    for number in range(GREYS):
        yield (255 * number // (GREYS - 1),) * 3
    for line in LINES[1:6]:
        colour = [int(line.colour[place : place + 2], 16) for place in (1, 3, 5)]
        for number in range(SHADES):
            red, green, blue = (255 - (255 - one) * (number + 1) // SHADES for one in colour)
            yield red, green, blue


def frame_delays(seconds: float) -> list[int]:
    """Return for how many hundredths of a second each picture stands, together as long as the run."""
    count = max(2, min(MOST_FRAMES, round(seconds * RATE)))
    ends = [round(100 * seconds * number / count) for number in range(count + 1)]
    return [later - earlier for earlier, later in pairwise(ends)]


def frames(figure: Figure, film: Film, angles: Sequence[float]) -> Iterator[NDArray[np.uint8]]:
    """Yield the drawing at angles, as arrays of red, green and blue. What stands still is drawn once."""
    canvas: Any = figure.canvas
    with _coarse(figure), _put_apart(film) as movers:
        canvas.draw()
        ground = canvas.copy_from_bbox(figure.bbox)
        for angle in angles:
            canvas.restore_region(ground)
            unseen = {one for seen in film.seen if seen.way.at(angle)[0] < 0.5 for one in seen.artists}
            for move in movers:
                move(angle)
            for one in _artists(film):
                if one not in unseen:
                    one.draw(canvas.get_renderer())
            yield np.asarray(canvas.buffer_rgba())[:, :, :3].copy()


@contextmanager
def _coarse(figure: Figure) -> Iterator[None]:
    """Draw with the dots of a GIF on white."""
    across = max(figure.get_size_inches())
    colour, dots = figure.get_facecolor(), figure.get_dpi()
    figure.set_dpi(min(GIF_DOTS, MOST_DOTS / across))
    figure.set_facecolor(WHITE)
    try:
        yield
    finally:
        figure.set_dpi(dots)
        figure.set_facecolor(colour)


@contextmanager
def _put_apart(film: Film) -> Iterator[list[Callable[[float], None]]]:
    """Leave what moves out of the drawing, and give what puts each part where it is at an angle."""
    from matplotlib.artist import Artist

    artists = _artists(film)
    known = [(one, Artist.get_transform(one)) for one in artists]
    lines = [(grown.line, np.array(grown.line.get_xydata())) for grown in film.grown]
    for one in artists:
        one.set_animated(True)
    try:
        transforms = dict(known)
        moved = [_mover(part, transforms, film.at) for part in film.parts]
        yield [*moved, *map(_grower, film.grown)]
    finally:
        for one, transform in known:
            one.set_transform(transform)
            one.set_animated(False)
        for line, points in lines:
            line.set_data(*points.T)


def _artists(film: Film) -> list[Artist]:
    """Return what is drawn anew in each picture, what is before it last."""
    found = [one for part in film.parts for one in part.artists]
    found += [grown.line for grown in film.grown]
    return sorted([*found, *film.above], key=lambda one: one.get_zorder())


def _mover(part: Part, transforms: Mapping[Artist, Transform], start: float) -> Callable[[float], None]:
    from matplotlib.transforms import Affine2D

    def place(angle: float) -> tuple[Points, float]:
        x, y, turn = part.way.at(angle)
        return part.axes.transData.transform((x, y)), float(turn)

    (x, y), turn = place(start)

    def move(angle: float) -> None:
        (right, up), turned = place(angle)
        shift = Affine2D().rotate_deg_around(x, y, turned - turn).translate(right - x, up - y)
        for one in part.artists:
            one.set_transform(transforms[one] + shift)

    return move


def _grower(grown: GrowingLine) -> Callable[[float], None]:
    whole = copy(grown.line)

    def grow(angle: float) -> None:
        grown.line.set_data(*grown._replace(line=whole).points_at(angle).T)

    return grow
