"""Drawings of mechanisms on paper: links to scale, what texts cover in pixels, lines by their standard."""

from __future__ import annotations

import cmath
import math
import random
import re
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import pytest
from cli import records
from drawings import MM, Paper, Points, plotted
from numpy.typing import NDArray
from tools import require_library

import kurbel
from kurbel import verify
from kurbel.plot.style import style

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from matplotlib.text import Text

Pixels = NDArray[np.bool_]
# Dots per mm of the pictures that are measured: a narrow line of 0.13 mm is one of them.
DOTS = 8


@pytest.fixture(autouse=True)
def library() -> None:
    require_library("matplotlib")


def drawing(
    kind: str, angles: Sequence[float], lang: str = "en", ratio: Any = "1:4", offset: float = 0
) -> kurbel.Drawing:
    about: dict[str, Any] = {"mechanism": kind}
    if kind == "straight":
        about = {"ratio": ratio} | ({"offset": offset} if offset else {})
    elif kind != "parallel":
        about |= {"ratio": min(Fraction(str(ratio).replace(":", "/")), Fraction(1, 3))}
        about |= {"rocker": 4} if kind == "arc" else {"beam": 3}
    found: kurbel.Drawing = kurbel.plot_mechanism(angles, lang=lang, **about)
    return found


def drawings(seed: int, count: int) -> Iterator[tuple[str, list[int], Figure]]:
    """Yield drawings of drives at one to twelve angles."""
    chance = random.Random(seed)
    for _ in range(count):
        kind = chance.choice(("straight", "straight", "arc", "beam", "parallel"))
        ratio = Fraction(1, chance.choice((2, 3, 4, 5, 6, 8, 12)))
        offset = chance.choice((0, 0, 1, -1)) * chance.randrange(10) / 20
        angles = chance.sample(range(0, 360, 5), chance.choice((1, 2, 3, 4, 6, 12)))
        lang = chance.choice(("de", "en"))
        figure = drawing(kind, angles, lang, ratio, offset).figure
        yield f"{kind} {ratio} {offset} {angles} {lang}", angles, figure


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
        # What stands near has ink of its own.
        near = place.padded(3).count_overlaps(places) > 1
        own = pixels(figure, [*others, *(text for text in texts if text is not one)]) if near else letters
        ink = own[low : int(place.y1) + 3, left : int(place.x1) + 3]
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


# Links ------------------------------------------------------------------------------------------------

# Words, rod and, of an arc crank, rocker and its pivot, all in R.
DRIVES: list[tuple[str, float, float, complex]] = [
    ("--ratio=1:5", 5, 0, 0),
    ("--ratio=0.4 --offset=0.7", 2.5, 0, 0.7j),
    ("--ratio=1:3 --offset=-1.1", 3, 0, -1.1j),
    ("--mechanism=arc --ratio=1:5 --rocker=6", 5, 6, 5 + 6j),
    ("--mechanism=arc --ratio=1:4 --offset=0.3 --rocker=3", 4, 3, 4 + 3.3j),
    ("--mechanism=arc --ratio=1:5 --rocker=4 --pivot=4;-3.5", 5, 4, 4 - 3.5j),
    ("--mechanism=arc --ratio=1:3 --rocker=3 --pivot=3.6;0", 3, 3, 3.6),
]


@pytest.mark.parametrize(("words", "rod", "rocker", "pivot"), DRIVES)
def test_links_are_drawn_true_to_scale_where_the_table_has_them(
    words: str, rod: float, rocker: float, pivot: complex
) -> None:
    for angle in (37, 201.5):
        paper = plotted("plot", f"--positions={angle}", *words.split())
        shaft, pin = paper.points("crank")
        radius = abs(pin - shaft)
        pin, start, head = ((one - shaft) / radius for one in (pin, *paper.points("rod")))
        assert pin == pytest.approx(cmath.rect(1, math.radians(angle)), abs=1e-5)
        assert start == pytest.approx(pin, abs=1e-5)
        assert abs(head - pin) == pytest.approx(rod, abs=1e-5)
        key = "rocker" if rocker else "x"
        (row,) = records("table", *words.split(), f"--angle={angle}", f"--columns={key}", "--digits=9")
        if not rocker:
            dead = math.sqrt((rod + 1) ** 2 - pivot.imag**2)
            assert head == pytest.approx(dead - float(row["x"]) + pivot, abs=1e-5)
            continue
        end, fixed = ((one - shaft) / radius for one in paper.points("rocker"))
        # The rocker's angle counts from where it hangs down, or stands up.
        down = -1j if pivot.imag >= 0 else 1j
        turned = cmath.rect(1, math.radians(float(row["rocker"])))
        assert (end, fixed) == (pytest.approx(head, abs=1e-5), pytest.approx(pivot, abs=1e-5))
        assert head - pivot == pytest.approx(rocker * down * turned, abs=1e-4)
        # The path has gaps behind pins, whose ends lie on chords.
        arc = (paper.points("arc") - shaft) / radius
        np.testing.assert_allclose(np.abs(arc - pivot), rocker, rtol=1e-3)
        assert np.abs(arc - head).min() < 0.05 * rocker


@pytest.mark.parametrize("angle", [37, 201.5])
def test_a_beam_is_drawn_true_to_scale_with_its_pivot_in_its_middle(angle: float) -> None:
    paper = plotted("plot", f"--positions={angle}", "--mechanism=beam", "--ratio=1:5", "--beam=3")
    shaft, pin = paper.points("crank")
    pin, start, head, joint, other = (
        (one - shaft) / abs(pin - shaft) for one in (pin, *paper.points("rod"), *paper.points("rocker"))
    )
    assert (pin, joint) == (pytest.approx(start, abs=1e-5), pytest.approx(head, abs=1e-5))
    assert pin == pytest.approx(cmath.rect(1, math.radians(angle)), abs=1e-5)
    with verify.enclose.working(100):
        drive = verify.drive("1:5", beam="3")
        true = drive.driven(drive.pin(Fraction(angle)))
        meant = complex(float(true.x.value), float(true.y.value))
    assert head == pytest.approx(meant, abs=1e-5)
    assert (abs(head - pin), abs(other - head)) == (pytest.approx(5, abs=1e-5), pytest.approx(6, abs=1e-5))


def test_the_two_cranks_of_a_parallel_crank_turn_angle_for_angle() -> None:
    paper = plotted("plot", "--positions=201.5;20", "--mechanism=parallel")
    (shaft, pin), (other, second) = (paper.points(one) for one in ("crank", "second-crank"))
    assert (pin - shaft) / abs(pin - shaft) == pytest.approx(cmath.rect(1, math.radians(201.5)), abs=1e-5)
    assert second - other == pytest.approx(pin - shaft, abs=1e-5)
    assert paper.points("rod").tolist() == pytest.approx([pin, second], abs=1e-5)
    # Centre lines are level or upright.
    chains = [one.points for one in paper.lines() if "stroke-dasharray" in one.look and one.name != "further"]
    ways = [points[1] - points[0] for points in chains if len(points) == 2]
    assert ways
    assert all(min(abs(way.real), abs(way.imag)) < 1e-4 for way in ways)


@pytest.mark.parametrize(
    ("words", "points"),
    [
        ("--ratio=1:5", ("0.4",)),
        ("--ratio=1:3 --offset=-0.6", ("0.3", "1.2,0.4", "-0.2")),
        ("--mechanism=arc --ratio=2:9 --rocker=7 --offset=0.7", ("0.5,-0.2",)),
    ],
)
def test_a_path_goes_through_the_places_of_its_point(words: str, points: tuple[str, ...]) -> None:
    paper = plotted("plot", "--positions=40", *words.split(), f"--point={';'.join(points)}")
    shaft, pin = paper.points("crank")
    end, head = paper.points("rod")
    for number, point in enumerate(points, 1):
        rows = records("table", *words.split(), f"--point={point}", "--angle=40;15..345:30",
                       "--columns=path_along,path_across", "--digits=9")  # fmt: skip
        here, *others = (complex(-float(row["path_along"]), float(row["path_across"])) for row in rows)
        share, _, beside = point.partition(",")
        place = head + complex(float(share), -float(beside or 0)) * (end - head)
        apart = [
            to_line(paper.points(f"path-{number}"), place + abs(pin - shaft) * (one - here)) for one in others
        ]
        # Marks hide the line at a few of them.
        assert sorted(apart)[8] < 0.01, apart
        assert max(apart) < 1.5


def to_line(line: Points, point: complex) -> float:
    """Return how far a point is from a line of straight pieces."""
    start, way = line[:-1], np.diff(line)
    along = np.clip(((point - start) / np.where(way, way, 1)).real, 0, 1)
    return float(abs(start + along * way - point).min())


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
            assert (
                one.left >= 0 and one.right <= lines.shape[1] and one.low >= 0 and one.top <= lines.shape[0]
            )
        for one, other in combinations(texts, 2):
            apart = one.right <= other.left or other.right <= one.left
            assert apart or one.top <= other.low or other.top <= one.low, (name, one.text, other.text)
        assert lines.shape[1] <= 120 * DOTS + 1 and lines.shape[0] <= 150 * DOTS + 1
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


def test_a_name_for_which_the_page_is_too_small_is_left_out() -> None:
    points = ("0.123456789012345678901234567890123456789", "0.11")
    words = plotted("plot", "--positions=30;60;90;120", f"--point={';'.join(points)}", "--width=56").words
    assert "s = 0,11" in words
    assert not [one for one in words if "0,1234" in one]


def test_the_letter_of_a_length_stands_above_its_line_to_be_read_from_below_or_the_right() -> None:
    """ISO 129-1: above a line across the page, left of a line up the page and turned to it."""
    figure = drawing("straight", [80], offset=0.6).figure
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


@pytest.mark.parametrize("kind", ["straight", "beam"])
def test_angles_and_dead_centres_are_read_from_below(kind: str) -> None:
    turned = [one.get_rotation() for one in texts_of(drawing(kind, [65, 200, 340]).figure)
              if len(one.get_text().strip("$")) > 1]  # fmt: skip
    assert len(turned) >= 5
    assert set(turned) == {0}


def test_what_a_text_or_a_pin_hides_is_no_line_and_nothing_is_painted_over_it() -> None:
    """On a dark page white grounds would be blots: the drawing has no white, and its lines have gaps."""
    shown = drawing("straight", range(0, 360, 30), ratio="1:12")
    written, figure = shown.image("svg").decode(), shown.figure
    figure.set_dpi(DOTS * 25.4)
    lines, texts = on_paper(figure)
    for one in texts:
        assert not lines[one.low : one.top, one.left : one.right].any(), one.text
    assert not re.search("#fff|#d9d9d9|white", written)
    x, y = np.asarray(figure.axes[0].transData.transform((0, 0))).round().astype(int)
    # Between the shaft's dot and its edge, 0.6 to 1.3 mm from the middle.
    ring = lines[y - 10 : y + 11, x - 10 : x + 11]
    away = np.hypot(*np.mgrid[-10:11, -10:11])
    assert not ring[(away > 0.7 * DOTS) & (away < 1.25 * DOTS)].any()


# Lines --------------------------------------------------------------------------------------------------


class Stroke(NamedTuple):
    """A line of a drawing in mm: its width, its pattern, its corners; and the id of its group."""

    name: str
    width: float
    pattern: list[float]
    points: Points


def strokes(kind: str) -> list[Stroke]:
    paper = Paper(drawing(kind, [70, 160, 300], offset=0.3 if kind == "straight" else 0).image("svg"))
    assert float((paper.root.get("width") or "").removesuffix("pt")) / MM == pytest.approx(120, abs=0.01)
    found = []
    for name, _, look, points in paper.lines():
        width = float(look.get("stroke-width", 1)) / MM
        if look.get("stroke", "none") != "none" and width:
            pattern = [float(one) / MM for one in re.findall(r"[\d.]+", look.get("stroke-dasharray", ""))]
            found.append(Stroke(name, width, pattern, points))
    return found


KINDS = ("straight", "arc", "beam", "parallel")


@pytest.mark.usefixtures("whole_lines")
@pytest.mark.parametrize("kind", KINDS)
def test_lines_have_the_widths_and_chains_of_iso_128(kind: str) -> None:
    """ISO 128-2: widths 0.13, 0.25, 0.5 and 0.7 mm; dashes of 24 widths, gaps of 3, dots of half a width."""
    found = strokes(kind)
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
    return float(np.abs(np.diff(stroke.points)).sum())


@pytest.mark.parametrize("kind", KINDS)
def test_all_hatches_rise_to_the_right_by_45_degrees(kind: str) -> None:
    hatches = [one for one in strokes(kind) if one.name == "hatch"]
    assert len(hatches) >= 6
    for one in hatches:
        way = one.points[1] - one.points[0]
        assert math.degrees(math.atan(way.imag / way.real)) == pytest.approx(45, abs=0.1)
        assert one.width == pytest.approx(0.13, abs=0.001)


@pytest.mark.parametrize(("kind", "offset"), [("straight", 0), ("straight", 0.8), ("arc", 0)])
def test_dead_centres_are_dots_where_crank_and_rod_are_in_line(kind: str, offset: float) -> None:
    """A mark as high as wide, and far wider than any line there: no dash is taken for it."""
    figure = drawing(kind, [70], offset=offset).figure
    figure.set_dpi(20 * 25.4)
    lines = pixels(figure, [])
    heads = [complex(math.sqrt((4 + way) ** 2 - offset**2), offset) for way in (1, -1)]
    if kind == "arc":
        # Where the circle of 5 R or 3 R about the shaft meets that of 4 R about the pivot, at 4 R + 4 R i.
        shares = [(16 + reach**2) / 64 for reach in (5, 3)]
        heads = [
            (4 + 4j) * (share - 1j * math.sqrt(reach**2 / 32 - share**2))
            for share, reach in zip(shares, (5, 3), strict=True)
        ]
    # The arrow of e stands beside the outer one.
    for place in (*heads[: 1 if offset else 2], heads[0] / abs(heads[0]), -heads[1] / abs(heads[1])):
        there = (place.real, place.imag)
        x, y = np.asarray(figure.axes[0].transData.transform(there)).round().astype(int)
        # What is solid over 0.3 mm in both directions: lines of 0.13 mm are not.
        part = lines[y - 30 : y + 31, x - 30 : x + 31]
        windows: Any = np.lib.stride_tricks.sliding_window_view(part, (7, 7))
        solid = windows.all(axis=(2, 3))
        rows, columns = np.flatnonzero(solid.any(axis=1)), np.flatnonzero(solid.any(axis=0))
        assert 0.5 <= len(rows) / 20 <= 1
        assert len(rows) == pytest.approx(len(columns), abs=2)
