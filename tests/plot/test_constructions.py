"""Lengths read back from the drawing, held against their true values on paper."""

import random
import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any

import numpy as np
import pytest
from cli import printed
from drawings import Paper
from matplotlib.textpath import TextPath

import kurbel
from kurbel.exact.numerals import Number
from kurbel.page.labels import plain

# In mm on paper; a point of SVG is 1/72 in. How far lines are from letters.
PAPER, POINT, CLEAR = 0.01, 25.4 / 72, 0.3
# Indices of letters, C₁, which ids write C_1.
SMALL = {ord(small): f"_{digit}" for digit, small in enumerate("₀₁₂₃₄₅₆₇₈₉")}


# What some constructions take beside their drive, from dice; the rods have their mass between their pins.
TAKEN: Mapping[str, Callable[[random.Random], Any]] = {
    "point": lambda dice: dice.randint(-100, 200) / 100,
    "centre": lambda dice: dice.randint(30, 80) / 100,
    "gyration": lambda dice: dice.randint(10, 40) / 100,
    "eps": lambda dice: dice.randint(100, 600) / 100,
}
TAKES = {
    **dict.fromkeys(("ensslin-2", "ensslin-4", "ensslin-velocities"), ("point",)),
    **dict.fromkeys(("ensslin-5", "ensslin-6", "ensslin-7"), ("centre", "gyration")),
    "radinger": ("eps",),
}
STRAIGHT = ("blau-9", "roetscher-1047-circle", "rittershaus", "autenrieth", "kuhn")
OFFSET = ("forces", "klein", "radinger")
ANY = (
    *("roetscher-1047-line", "velocity", "acceleration", "ensslin-velocities"),
    *(f"ensslin-{number}" for number in range(1, 8)),
)
# What describes drives of a mechanism, at any of the ratios.
OTHERS: Mapping[str, Mapping[str, str]] = {
    "straight": {},
    "offset": {"offset": "-0.15"},
    "arc": {"rocker": "6"},
    "beam": {"beam": "3.7"},
    "slotted": {"pivot": "1.6", "rocker": "2.9"},
    "yoke": {},
}
ASKED = [
    *((name, "straight") for name in (*STRAIGHT, *OFFSET, *ANY)),
    *((name, "offset") for name in (*OFFSET, *ANY)),
    *((name, "arc") for name in ANY),
    ("weisbach-149", "beam"),
    ("slotted-lever", "slotted"),
    ("scotch-yoke", "yoke"),
]
APPROXIMATE = ("kuhn", "weisbach-149")


def test_each_construction_of_the_list_is_asked() -> None:
    names = [line.split()[0] for line in printed("construct").out.splitlines()]
    assert {*names} == {name for name, _ in ASKED}


def drives(name: str, mechanism: str, count: int = 1) -> Iterator[dict[str, Any]]:
    """Yield what a construction is asked of: ratios and angles, also beyond 180°, the same in every run."""
    dice = random.Random(name)
    for _ in range(count):
        asked: dict[str, Any] = {"mechanism": mechanism, **OTHERS[mechanism]}
        # The crank of a beam engine turns with a longer rod alone.
        if mechanism not in ("slotted", "yoke"):
            asked["ratio"] = f"1:{dice.randint(200 if mechanism == 'beam' else 120, 600) / 100}"
        if mechanism != "beam":
            asked["angle"] = str(dice.randint(1, 3599) / 10)
        yield asked | {key: str(TAKEN[key](dice)) for key in TAKES.get(name, ())}


# One drive of each, of the mechanisms by turns.
OWN = [[pair for pair in ASKED if pair[0] == name] for name in dict(ASKED)]
DRAWN = [pairs[place % len(pairs)] for place, pairs in enumerate(OWN)]


@pytest.mark.parametrize(
    ("name", "mechanism", "count"),
    [*((*pair, 1) for pair in DRAWN), *(pytest.param(*pair, 12, marks=pytest.mark.slow) for pair in ASKED)],
)
def test_a_length_on_paper_is_the_printed_one(name: str, mechanism: str, count: int) -> None:
    for asked in drives(name, mechanism, count):
        drawing = kurbel.plot_construction(name, **asked)
        paper = Paper(drawing.image())
        # "R = 15 mm, M v²/R = 30 mm; 1. …"
        scales = dict(re.findall(r"(?:^|, )([^=]+) = ([\d.e-]+) mm", drawing.about.partition(";")[0]))
        page = kurbel.construct(name, **asked, columns="length,drawn,unit", digits=12)
        for letters, printed_one, unit in page.records.rows:
            if unit == "°":
                continue
            assert isinstance(printed_one, Number) and isinstance(letters, str)
            written = plain(letters).replace("′", "'").translate(SMALL)
            start, end = paper.points(f"length-{written}")[:2]
            length = abs(printed_one.scaled) / 10**printed_one.decimals * float(scales[plain(str(unit))])
            assert abs(end - start) == pytest.approx(length, abs=PAPER), (name, asked, written)


@pytest.mark.parametrize("name", ["acceleration", "klein", "autenrieth"])
def test_where_the_rod_does_not_turn_circles_are_points(name: str) -> None:
    svg = kurbel.plot_construction(name, ratio="1:4", angle=90).image().decode()
    assert 'id="step-6-' in svg


def test_hidden_lines_are_dashed_with_the_gaps_of_iso_128() -> None:
    looks = [one.look for one in Paper(kurbel.plot_construction("ensslin-5").image()).lines()]
    gaps = [
        float(found[1]) / float(look["stroke-width"])
        for look in looks
        if (found := re.fullmatch(r"[\d.]+,([\d.]+)", look.get("stroke-dasharray", "")))
    ]
    assert gaps == [pytest.approx(3)]


@pytest.mark.parametrize(("name", "mechanism"), ASKED)
def test_an_exact_length_is_the_true_one_to_the_last_digit(name: str, mechanism: str) -> None:
    """By its points and by the kernel; of an approximate one the error is between them."""
    for asked in drives(name, mechanism, 3):
        page = kurbel.construct(name, **asked, columns="drawn,true,error", digits=15)
        for row in page.records.rows:
            drawn, true, error = (one.scaled for one in row if isinstance(one, Number))
            assert abs(drawn - true - error) <= (name in APPROXIMATE), (name, asked, row)
            assert not error or name in APPROXIMATE


# Where many lines cross about the crank, or about the crosshead.
CROWDED = [
    ("klein", 44),
    ("klein", 55),
    ("klein", 224),
    ("rittershaus", 62),
    ("autenrieth", 80),
    ("autenrieth", 314),
    ("ensslin-2", 53),
    ("acceleration", 75),
    ("blau-9", 50),
    ("blau-9", 70),
    ("blau-9", 160),
    ("blau-9", 300),
]


@pytest.mark.parametrize(("name", "angle"), CROWDED)
def test_no_letter_stands_on_a_line_or_on_another(name: str, angle: int) -> None:
    figure = kurbel.plot_construction(name, ratio="1:4", angle=angle).figure
    (axes,) = figure.axes
    to_mm = 25.4 / figure.dpi

    def on_page(points: Any) -> Any:
        return axes.transData.transform(points) * to_mm

    boxes = []
    for text in axes.texts:
        outline = TextPath((0, 0), text.get_text(), size=text.get_fontsize(), prop=text.get_fontproperties())
        # Where a contour closes no point is drawn.
        ink = outline.vertices[outline.codes != TextPath.CLOSEPOLY] * POINT
        low, high = (edge + on_page([text.get_position()])[0] for edge in (ink.min(0), ink.max(0)))
        boxes.append(((low + high) / 2, (high - low) / 2))
    for place, (middle, half) in enumerate(boxes):
        own = f"{axes.texts[place].get_gid()}-leader"
        for line in (one for one in axes.lines if one.get_gid() != own):
            corners = on_page(np.asarray(line.get_xydata()))
            shares = np.linspace(0, 1, 200)[:, None, None]
            points = (corners[:-1] + shares * np.diff(corners, axis=0)).reshape(-1, 2)
            away = np.hypot(*np.maximum(np.abs(points - middle) - half, 0).T)
            assert np.nanmin(away) > CLEAR, (axes.texts[place].get_text(), line.get_gid())
        for other, other_half in boxes[:place]:
            assert (np.abs(middle - other) > half + other_half).any(), axes.texts[place].get_text()
