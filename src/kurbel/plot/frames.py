"""A film as pictures: the drawing at equal steps of its run, and the GIF that they make."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from copy import copy
from io import BytesIO
from itertools import chain, pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.transforms import Affine2D

from kurbel.plot.film import Film, Grown, Part
from kurbel.plot.place import Points
from kurbel.plot.style import LINES, WHITE

if TYPE_CHECKING:
    from matplotlib.figure import Figure

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


def frames(figure: Figure, film: Film, angles: Sequence[float]) -> Iterator[Any]:
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


def _artists(film: Film) -> list[Any]:
    """Return what is drawn anew in each picture, what is before it last."""
    found = [one for part in film.parts for one in part.artists]
    found += [grown.line for grown in film.grown]
    return sorted([*found, *film.above], key=lambda one: one.get_zorder())


def _mover(part: Part, transforms: Mapping[Any, Any], start: float) -> Callable[[float], None]:
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


def _grower(grown: Grown) -> Callable[[float], None]:
    whole = copy(grown.line)

    def grow(angle: float) -> None:
        grown.line.set_data(*grown._replace(line=whole).points_at(angle).T)

    return grow
