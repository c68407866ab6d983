"""Drawings of mechanisms on paper: what their texts cover is measured in pixels, lines in their SVG."""

from __future__ import annotations

import math
import random
import re
import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray
from tools import require_library

from kurbel.drive.crank import Crank
from kurbel.linkage.arc.crank import ArcCrank
from kurbel.linkage.beam.crank import BeamCrank
from kurbel.linkage.parallel import ParallelCrank
from kurbel.plot.arc import arc_mechanism
from kurbel.plot.links import outlined
from kurbel.plot.mechanism import mechanism
from kurbel.plot.style import image, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from matplotlib.text import Text

Pixels = NDArray[np.bool_]
SVG = "{http://www.w3.org/2000/svg}"
# Dots per mm of the pictures that are measured: a narrow line of 0.13 mm is one of them.
DOTS = 8
ARC = ArcCrank(Crank(Fraction(1, 4)), Fraction(4))


@pytest.fixture(autouse=True)
def library() -> None:
    require_library("matplotlib")


def drawing(kind: str, angles: list[Fraction], lang: str, ratio: Fraction, offset: Fraction) -> Figure:
    if kind == "parallel":
        return outlined(ParallelCrank().outline(), angles, ",")
    if kind == "straight":
        return mechanism(float(ratio), float(offset), angles, lang, ",")
    crank = min(ratio, Fraction(1, 3))
    drives = {"arc": ArcCrank(Crank(crank), Fraction(4)), "beam": BeamCrank(Crank(crank), Fraction(3))}
    return arc_mechanism(drives[kind], angles, lang, ",")


def drawings(seed: int, count: int) -> Iterator[tuple[str, list[Fraction], Figure]]:
    """Yield drawings of drives at one to twelve angles."""
    chance = random.Random(seed)
    for _ in range(count):
        kind = chance.choice(("straight", "straight", "arc", "beam", "parallel"))
        ratio = Fraction(1, chance.choice((2, 3, 4, 5, 6, 8, 12)))
        offset = chance.choice((0, 0, 1, -1)) * Fraction(chance.randrange(10), 20)
        places = chance.sample(range(0, 360, 5), chance.choice((1, 2, 3, 4, 6, 12)))
        angles = [Fraction(place) for place in places]
        lang = chance.choice(("de", "en"))
        yield f"{kind} {ratio} {offset} {places} {lang}", angles, drawing(kind, angles, lang, ratio, offset)


class Letters(NamedTuple):
    """A text in pixels: left, bottom, right and top of its ink."""

    text: str
    left: int
    low: int
    right: int
    top: int


def on_paper(figure: Figure) -> tuple[Pixels, list[Letters]]:
    """Return all lines of a drawing, and its texts, in pixels from the lower left corner."""
    axes = figure.axes[0]
    texts, others = texts_of(figure), [*axes.lines, *axes.patches]
    places = [one.get_window_extent() for one in texts]
    lines, letters = pixels(figure, texts), pixels(figure, others)
    found = []
    for one, place in zip(texts, places, strict=True):
        left, low = (max(0, int(side) - 2) for side in (place.x0, place.y0))
        ink = letters[low : int(place.y1) + 3, left : int(place.x1) + 3]
        rows, columns = np.flatnonzero(ink.any(axis=1)), np.flatnonzero(ink.any(axis=0))
        sides = left + columns[0], low + rows[0], left + columns[-1] + 1, low + rows[-1] + 1
        found.append(Letters(one.get_text(), *map(int, sides)))
    return lines, found


def pixels(figure: Figure, hidden: list[Any]) -> Pixels:
    for one in hidden:
        one.set_visible(False)
    with style():
        figure.canvas.draw()
    for one in hidden:
        one.set_visible(True)
    canvas: Any = figure.canvas
    return np.asarray(np.asarray(canvas.buffer_rgba())[::-1, :, 0] < 190)


def texts_of(figure: Figure) -> list[Text]:
    return [one for one in figure.axes[0].texts if one.get_text()]


# Texts ------------------------------------------------------------------------------------------------


def check_texts(seed: int, count: int) -> tuple[int, int]:
    """Check that no text covers a line unless it must; return how many do, and how many there are."""
    covering, written = 0, 0
    for name, angles, figure in drawings(seed, count):
        figure.set_dpi(DOTS * 25.4)
        lines, texts = on_paper(figure)
        for one in texts:
            if lines[one.low : one.top, one.left : one.right].any():
                covering += 1
                assert not free_near(lines, texts, one), (name, one.text)
        names = [one.text for one in texts]
        assert sum("°" in one for one in names) == (len(angles) if len(angles) > 1 else 0), name
        written += len(texts)
    return covering, written


def free_near(lines: Pixels, texts: list[Letters], one: Letters, reach: float = 2.0) -> list[tuple[int, int]]:
    """Return shifts to places about a text, so many mm away at most, that are free by 0.6 mm all round."""
    taken, margin, steps = lines.copy(), round(0.6 * DOTS), round(reach * DOTS)
    for other in texts:
        if other is not one:
            taken[other.low : other.top, other.left : other.right] = True
    found = []
    for up in range(-steps, steps + 1):
        for right in range(-steps, steps + 1):
            low, left = one.low + up - margin, one.left + right - margin
            high, end = one.top + up + margin, one.right + right + margin
            on_page = low >= 0 <= left and high <= len(taken) and end <= taken.shape[1]
            if on_page and not taken[low:high, left:end].any():
                found.append((right, up))
    return found


@pytest.fixture
def whole_lines(monkeypatch: pytest.MonkeyPatch) -> None:
    """Draw lines also where something stands before them, a text that hides them among that."""
    monkeypatch.setattr("kurbel.plot.sketch.cut", lambda line, holes: None)


@pytest.mark.usefixtures("whole_lines")
def test_a_text_covers_a_line_only_where_no_place_beside_it_is_free() -> None:
    covering, written = check_texts(7, 8)
    assert written > 60
    assert covering <= 0.01 * written


@pytest.mark.slow
@pytest.mark.usefixtures("whole_lines")
def test_of_many_drawings_few_have_a_text_that_covers_a_line() -> None:
    covering, written = check_texts(3, 100)
    assert covering <= 0.01 * written


def test_the_letter_of_a_length_stands_above_its_line_to_be_read_from_below_or_the_right() -> None:
    """ISO 129-1: above a line across the page, left of a line up the page and turned to it."""
    figure = mechanism(0.25, 0.6, [Fraction(80)], "de", ",")
    _, letters = on_paper(figure)
    spans = [np.asarray(line.get_window_extent().extents) for line in figure.axes[0].lines]
    turned = {one.get_text(): one.get_rotation() for one in texts_of(figure)}
    dpm = figure.dpi / 25.4
    for text in ("$S$", "$x$", "$e$"):
        (one,) = (found for found in letters if found.text == text)
        if text == "$e$":
            gaps = [x0 - one.right for x0, y0, x1, y1 in spans if x0 == x1 and y0 < one.low and one.top < y1]
        else:
            gaps = [one.low - y0 for x0, y0, x1, y1 in spans if y0 == y1 and x0 < one.left and one.right < x1]
        assert turned[text] == (90 if text == "$e$" else 0)
        assert any(0.4 <= gap / dpm <= 2 for gap in gaps), text


def test_what_a_text_or_a_pin_hides_is_no_line_and_nothing_is_painted_over_it() -> None:
    """On a dark page white grounds would be blots: the drawing has no white, and its lines have gaps."""
    angles = [Fraction(step) for step in range(0, 360, 30)]
    figure = mechanism(1 / 12, 0, angles, "en", ".")
    figure.set_dpi(DOTS * 25.4)
    lines, texts = on_paper(figure)
    for one in texts:
        assert not lines[one.low : one.top, one.left : one.right].any(), one.text
    written = image(figure, "svg").decode()
    assert not re.search("#fff|#d9d9d9|white", written)
    x, y = np.asarray(figure.axes[0].transData.transform((0, 0))).round().astype(int)
    # Between the shaft's dot and its edge, 0.6 to 1.3 mm from the middle.
    ring = lines[y - 10 : y + 11, x - 10 : x + 11]
    away = np.hypot(*np.mgrid[-10:11, -10:11])
    assert not ring[(away > 0.7 * DOTS) & (away < 1.25 * DOTS)].any()


# Lines --------------------------------------------------------------------------------------------------


class Stroke(NamedTuple):
    """A stroke of an SVG in mm: its width, its pattern, its points; and the id of its group."""

    name: str
    width: float
    pattern: list[float]
    points: NDArray[np.float64]


def strokes(figure: Figure) -> list[Stroke]:
    root = ET.fromstring(image(figure, "svg"))
    box = [float(side) for side in (root.get("viewBox") or "").split()]
    size = re.fullmatch(r"([\d.]+)pt", root.get("width") or "")
    assert size
    # The nominal width of the page, in mm of the unit of the paths.
    scale = float(size[1]) / 72 * 25.4 / box[2]
    assert box[2] * scale == pytest.approx(120, abs=0.01)
    found = []
    for group in root.iter(f"{SVG}g"):
        for path in group.findall(f"{SVG}path"):
            look = dict(re.findall(r"([a-z-]+): ([^;]+)", path.get("style") or ""))
            if look.get("stroke", "none") != "none" and "stroke-width: 0;" not in f"{path.get('style')};":
                pattern = [
                    float(one) * scale for one in re.findall(r"[\d.]+", look.get("stroke-dasharray", ""))
                ]
                numbers = [float(one) for one in re.findall(r"-?[\d.]+", path.get("d") or "")]
                points = np.asarray(numbers).reshape(-1, 2) * scale
                width = float(look.get("stroke-width", 1)) * scale
                found.append(Stroke(group.get("id") or "", width, pattern, points))
    return found


FIGURES: dict[str, Callable[[], Figure]] = {
    kind: lambda kind=kind: drawing(  # type: ignore[misc]
        kind, [Fraction(70), Fraction(160), Fraction(300)], "en", Fraction(1, 4), Fraction(3, 10)
    )
    for kind in ("straight", "arc", "beam", "parallel")
}


@pytest.mark.usefixtures("whole_lines")
@pytest.mark.parametrize("kind", FIGURES)
def test_lines_have_the_widths_and_chains_of_iso_128(kind: str) -> None:
    """ISO 128-2: widths 0.13, 0.25, 0.5 and 0.7 mm; dashes of 24 widths, gaps of 3, dots of half a width."""
    found = strokes(FIGURES[kind]())
    widths = {round(one.width, 3) for one in found}
    assert widths == {0.13, 0.25, 0.5, 0.7}
    chains: set[int] = set()
    for one in found:
        if not one.pattern:
            assert one.name != "further" or length(one) < (24 + 9.5 + 24) * 0.13, "too short for a chain"
            continue
        assert one.width == pytest.approx(0.13, abs=0.001)
        dash, *rest = one.pattern
        assert rest == pytest.approx(
            [dash * share / 24 for share in ([3, 0.5, 3] * 2)[: len(rest)]], rel=1e-3
        ) or (rest == pytest.approx([dash * share / 24 for share in (3, 0.5, 3, 0.5, 3)], rel=1e-3))
        assert 0.6 <= dash / (24 * 0.13) <= 1.5
        chains.add(len(one.pattern))
        if one.name == "further":
            assert len(one.pattern) == 6
            # It begins and ends with a dash.
            assert (length(one) - dash) % sum(one.pattern) == pytest.approx(0, abs=0.02) or (
                (length(one) - dash) % sum(one.pattern) == pytest.approx(sum(one.pattern), abs=0.02)
            )
    assert chains == {4, 6}


def length(stroke: Stroke) -> float:
    return float(np.hypot(*np.diff(stroke.points, axis=0).T).sum())


@pytest.mark.parametrize("kind", FIGURES)
def test_all_hatches_rise_to_the_right_by_45_degrees(kind: str) -> None:
    hatches = [one for one in strokes(FIGURES[kind]()) if one.name == "hatch"]
    assert len(hatches) >= 6
    for one in hatches:
        # In SVG, y goes down.
        across, down = one.points[1] - one.points[0]
        assert math.degrees(math.atan(-down / across)) == pytest.approx(45, abs=0.1)
        assert one.width == pytest.approx(0.13, abs=0.001)


def test_dead_centres_are_dots_on_the_circle() -> None:
    """A mark as high as wide, and far wider than any line there: no dash is taken for it."""
    figure = mechanism(0.25, 0, [Fraction(70)], "en", ".")
    figure.set_dpi(20 * 25.4)
    lines = pixels(figure, [])
    for place in ((-1, 0), (1, 0), (3, 0), (5, 0)):
        x, y = np.asarray(figure.axes[0].transData.transform(place)).round().astype(int)
        # What is solid over 0.3 mm in both directions: lines of 0.13 mm are not.
        part = lines[y - 30 : y + 31, x - 30 : x + 31]
        windows: Any = np.lib.stride_tricks.sliding_window_view(part, (7, 7))
        solid = windows.all(axis=(2, 3))
        rows, columns = np.flatnonzero(solid.any(axis=1)), np.flatnonzero(solid.any(axis=0))
        assert 0.5 <= len(rows) / 20 <= 1
        assert len(rows) == pytest.approx(len(columns), abs=2)
