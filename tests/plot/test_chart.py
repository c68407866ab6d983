"""What is named in drawings of curves: areas, swings, strokes, extremes; where it stands, in which size."""

from __future__ import annotations

import math
import re
from functools import cache
from itertools import combinations, pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from drawings import SVG, Paper, drawn
from numpy.typing import NDArray
from tools import require_library

import kurbel

if TYPE_CHECKING:
    from collections.abc import Callable

    from matplotlib.axes import Axes
    from matplotlib.lines import Line2D
    from matplotlib.text import Text


@pytest.fixture(autouse=True)
def library() -> None:
    require_library("matplotlib")


@cache
def motion(**given: Any) -> kurbel.Drawing:
    return drawn(kurbel.table, "1:5", step=3, **given)


@cache
def waves() -> kurbel.Drawing:
    """T = 1000 + 500 sin 2φ against its mean: W = 250 (1 - cos 2φ), in N m and J."""
    return drawn(kurbel.turning, torque="1000 + 500 sin(2φ)", step=1, lang="en")


@cache
def pins() -> kurbel.Drawing:
    return drawn(kurbel.forces, eps=4, polar=True, ratio="1:5", step=2, lang="en")


def words(drawing: kurbel.Drawing) -> list[str]:
    return [one.get_text() for one in texts(drawing)]


def texts(drawing: kurbel.Drawing) -> list[Text]:
    from matplotlib.text import Text

    return [one for one in drawing.figure.findobj(Text) if one.get_text()]


def lines(drawing: kurbel.Drawing, name: str) -> list[Line2D]:
    from matplotlib.lines import Line2D

    found = drawing.figure.findobj(Line2D)
    return [one for one in found if re.fullmatch(name, str(one.get_gid()))]


def points(line: Line2D) -> NDArray[np.float64]:
    return np.stack([np.asarray(side, float) for side in line.get_data()], axis=1)


def in_mm(axes: Axes, values: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray(axes.transData.transform(values)) / axes.figure.dpi * 25.4


# Areas and the swing --------------------------------------------------------------------------------------


@pytest.mark.parametrize(("name", "above"), [("above", True), ("below", False)])
def test_areas_are_hatched_where_the_torque_is_above_its_mean_and_the_other_way_below(
    name: str, above: bool
) -> None:
    (hatch,) = lines(waves(), f"area-1-{name}")
    axes = waves().figure.axes[0]
    drawn = points(hatch)
    angles, torque = drawn[~np.isnan(drawn).any(axis=1)].T
    within = 1000 + 500 * np.sin(np.radians(2 * angles))
    low, high = (np.full_like(within, 1000), within) if above else (within, np.full_like(within, 1000))
    assert (torque >= low - 5).all() and (torque <= high + 5).all()
    starts, ends = in_mm(axes, drawn[::3]), in_mm(axes, drawn[1::3])
    along, up = (ends - starts).T
    np.testing.assert_allclose(up, along if above else -along, rtol=1e-6, atol=1e-6)
    # Evenly apart they cover the area but for what labels take: 500 N m over two half waves of 90°.
    levels = np.sort((starts[:, 1] - starts[:, 0] if above else starts.sum(axis=1)) / math.sqrt(2))
    apart = np.diff(levels)[np.diff(levels) > 0.01]
    spacing = apart.min()
    np.testing.assert_allclose(apart / spacing, np.round(apart / spacing), rtol=0, atol=0.01)
    assert 1 < spacing < 2
    one = in_mm(axes, np.asarray([(0.0, 0.0), (np.degrees(1), 1000.0)]))
    area = math.prod(one[1] - one[0])
    assert 0.9 * area < np.hypot(along, up).sum() * spacing < 1.03 * area


def test_mean_swing_and_places_are_those_of_the_waves() -> None:
    said = words(waves())
    assert any("T_" in one and r"=1000.0\,\text{N m}$" in one for one in said)
    assert [one for one in said if r"\Delta" in one] == [r"$\Delta W=500.00\,\text{J}$"]
    assert {"$90$°", "$270$°", "$0$°", "$180$°"} <= set(said)
    assert "ΔW = 500.00 J" in waves().image().decode().split("<desc>")[1]


def test_the_arrow_of_the_swing_stands_beside_the_frame_and_reaches_from_least_to_greatest() -> None:
    axes = waves().figure.axes[1]
    right = in_mm(axes, np.asarray([(360.0, 0.0)]))[0, 0]
    upright = [in_mm(axes, points(one)) for one in axes.lines if one.get_gid() is None]
    arrows = [one for one in upright if len(one) == 2 and one[:, 0].min() > right + 1]
    (arrow,) = (one for one in arrows if one[0, 0] == pytest.approx(one[1, 0]))
    ends = in_mm(axes, np.asarray([(0.0, 0.0), (0.0, 500.0)]))[:, 1]
    assert sorted(arrow[:, 1]) == pytest.approx(ends, abs=0.01)
    # Its heads point outwards from there, three times as long as they are broad.
    heads = [in_mm(axes, one.get_xy()) for one in axes.patches if type(one).__name__ == "Polygon"]
    heads = [one for one in heads if abs(one[0, 0] - arrow[0, 0]) < 0.01]
    assert sorted(one[0, 1] for one in heads) == pytest.approx(ends, abs=0.01)
    for tip, *base in (one[:3] for one in heads):
        length = math.dist(tip, (base[0] + base[1]) / 2)
        assert length == pytest.approx(3 * math.dist(*base), rel=0.05)
        assert 1.5 < length < 2.5
        assert ends[0] < base[0][1] < ends[1]
    (text,) = (one for one in texts(waves()) if r"\Delta" in one.get_text())
    box = text.get_window_extent()
    assert axes.bbox.x1 < box.x0 and box.x1 <= waves().figure.bbox.x1


def test_part_of_a_cycle_without_the_least_has_no_swing() -> None:
    part = drawn(kurbel.turning, torque="1000 + 500 sin(2φ)", angle="20..160:5")
    assert not [one for one in words(part) if r"\Delta" in one]


# Motion ---------------------------------------------------------------------------------------------------


def test_extremes_stand_beside_their_places_with_their_values() -> None:
    # c/v = sin φ + λ sin φ cos φ/cos ψ, greatest where the piston is not accelerated.
    fine = np.radians(np.linspace(78, 80, 2_000_001))
    slant = np.sqrt(1 - (np.sin(fine) / 5) ** 2)
    velocity = np.sin(fine) + np.sin(fine) * np.cos(fine) / 5 / slant
    degrees, minutes = divmod(round(60 * math.degrees(fine[velocity.argmax()])), 60)
    value = f"{velocity.max():.4f}".replace(".", "{,}")
    assert f"${value}$ bei {degrees}°{minutes}′" in words(motion())
    assert f"$-{value}$ bei {359 - degrees}°{60 - minutes}′" in words(motion())
    # p R/v² is 1 + λ and -(1 - λ) at the dead centres, x twice R.
    assert {"$2{,}0000$ bei 180°", "$1{,}2000$ bei 0°", "$-0{,}8000$ bei 180°"} <= set(words(motion()))


@pytest.mark.parametrize(
    ("span", "named"),
    [
        ({"to": 720}, ["$-0{,}8000$ bei 180°", "$1{,}2000$ bei 0°"]),
        ({"from_": 90, "to": 720}, ["$-0{,}8000$ bei 180°", "$1{,}2000$ bei 360°"]),
        ({"from_": 200, "to": 500}, ["$1{,}2000$ bei 360°"]),
    ],
)
def test_an_extreme_that_comes_again_is_named_once(span: dict[str, int], named: list[str]) -> None:
    assert sorted(one for one in words(motion(columns="p", **span)) if " bei " in one) == named


def test_motion_names_its_ratio_strokes_and_dead_centres() -> None:
    said = words(motion())
    assert [said.count(one) for one in ("Hingang", "Rückgang", "innerer Totpunkt", "äußerer Totpunkt")] == [
        1, 1, 2, 1,
    ]  # fmt: skip
    assert said.count(r"$R\text{:}L=1\text{:}5$") == 1


def test_the_dead_centres_of_an_offset_crank_are_where_crank_and_rod_are_in_line() -> None:
    drawing = drawn(kurbel.table, "1:4", offset=0.4, step=10)
    inner, outer = (math.degrees(math.asin(0.4 / (4 + way))) + 90 * (1 - way) for way in (1, -1))
    for axes in drawing.figure.axes:
        upright = [points(one)[:, 0] for one in axes.lines if len(one.get_xdata()) == 2 and one.is_dashed()]
        assert sorted({one[0] for one in upright if one[0] == one[1]}) == pytest.approx([inner, outer])


def test_the_infinite_rod_is_dotted_beside_the_other() -> None:
    drawing = motion(infinite=True)
    (dotted,) = lines(drawing, "curve-1-2")
    phi, x = points(dotted).T
    np.testing.assert_allclose(x, 1 - np.cos(np.radians(phi)), rtol=0, atol=1e-14)
    assert {one.is_dashed() for one in lines(drawing, "curve-[123]-2")} == {True}
    assert {one.is_dashed() for one in lines(drawing, "curve-[123]-1")} == {False}
    assert r"$R\text{:}L=1\text{:}\infty$" in words(drawing)
    assert "$2{,}0000$ bei 180°" in words(drawing)


# The frame, the labels, the lines -------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("given", "low", "high"),
    [
        ({"columns": "x"}, True, False),
        ({"columns": "c", "from_": 180}, False, True),
        ({"columns": "p"}, False, False),
    ],
)
def test_the_frame_is_the_zero_line_where_all_is_on_one_side_of_it(
    given: dict[str, Any], low: bool, high: bool
) -> None:
    drawing = drawn(kurbel.table, "1:5", step=5, **given)
    least, greatest = drawing.figure.axes[0].get_ylim()
    assert ((least == 0), (greatest == 0)) == (low, high)
    values = points(lines(drawing, "curve-1-1")[0])[:, 1]
    assert least <= values.min() and values.max() <= greatest


CROWDED: dict[str, Callable[[], kurbel.Drawing]] = {
    "motion": lambda: motion(infinite=True),
    "steam": lambda: drawn(kurbel.turning, 4, ratio="1:5", width=90, step=2),
    "gas": lambda: drawn(kurbel.turning, compression=6, heat=10, cranks="0;180;360;540"),
    "press": lambda: drawn(kurbel.turning, load_torque="0:10kNm; 36:10kNm; 36:0; 360:0"),
    "english": lambda: drawn(kurbel.table, "1:4", infinite=True, lang="en"),
}


@pytest.mark.parametrize(
    "name",
    [pytest.param(one, marks=[] if one in ("motion", "steam") else pytest.mark.slow) for one in CROWDED],
)
def test_no_word_covers_a_curve_a_mark_or_another_word(name: str) -> None:
    drawing = CROWDED[name]()
    drawing.figure.canvas.draw()
    for axes in drawing.figure.axes:
        boxes = [one.get_window_extent() for one in axes.texts]
        assert not [pair for pair in combinations(boxes, 2) if pair[0].overlaps(pair[1])]
        for line in axes.lines:
            if not re.match("curve|jumps", str(line.get_gid())) and line.get_marker() != "o":
                continue
            path = axes.transData.transform(points(line))
            dense = np.concatenate([path[:1], *(np.linspace(*ends, 40) for ends in pairwise(path))])
            for box in boxes:
                inside = (dense[:, 0] > box.x0) & (dense[:, 0] < box.x1)
                assert not (inside & (dense[:, 1] > box.y0) & (dense[:, 1] < box.y1)).any()


def test_the_strokes_of_a_polar_diagram_differ_without_colour_and_have_names() -> None:
    first, second = lines(pins(), "curve-[12]")
    assert (first.is_dashed(), second.is_dashed()) == (False, True)
    legend = pins().figure.axes[0].get_legend()
    assert legend is not None
    assert [one.get_text() for one in legend.get_texts()] == ["Outstroke", "Return"]
    # The steam presses on either stroke so that the crank turns on.
    for line in (first, second):
        across = points(line)[:, 0]
        assert (across[np.isfinite(across)] > -1e-9).all()
    four = drawn(kurbel.forces, polar=True, compression=6, heat=10, ratio="1:4", step=10)
    # matplotlib has no getter of patterns.
    looks = {str(vars(one)["_unscaled_dash_pattern"]) for one in lines(four, "curve-.*")}
    assert len(looks) == len(lines(four, "curve-.*")) > 2


# Files ----------------------------------------------------------------------------------------------------


def test_svg_says_what_it_is_and_has_neither_ground_nor_black() -> None:
    for drawing in (waves(), pins(), to_scale()):
        text = drawing.image().decode()
        root = Paper(text).root
        assert (root.get("role"), root.get("fill")) == ("img", "currentColor")
        assert [one.text for one in root.findall(f"{SVG}title")] == [drawing.plain_title]
        assert len(root.findall(f"{SVG}desc")) == 1
        assert not {"#ffffff", "#000000"} & set(re.findall("#[0-9a-f]{6}", text))
        assert "opacity: 0;" not in text


def test_svg_has_words_for_its_text_on_request_alone() -> None:
    paper = Paper(waves().image(text=True))
    said = paper.words
    assert {"Excess energy W in J", "TL = 1000.0 N m", "ΔW = 500.00 J", "Crank angle φ", "270°"} <= set(said)
    assert not Paper(waves().image()).words
    # In wider fonts no piece runs into the next.
    formulas = [one.findall(f"{SVG}tspan") for one in paper.root.iter(f"{SVG}text")]
    pairs = [
        (one, after) for row in formulas for one, after in pairwise(row) if one.get("y") == after.get("y")
    ]
    assert len(pairs) > 5
    for one, after in pairs:
        start, length, following = (
            float(part.get(name, "nan")) for part, name in ((one, "x"), (one, "textLength"), (after, "x"))
        )
        assert 0 < length < following - start + 0.5


def turning(**size: Any) -> kurbel.Drawing:
    return drawn(kurbel.turning, 4, ratio="1:5", step=10, **size)


def pin_force(**size: Any) -> kurbel.Drawing:
    return drawn(kurbel.forces, eps=4, polar=True, ratio="1:5", step=10, **size)


def to_scale(**size: Any) -> kurbel.Drawing:
    found: kurbel.Drawing = kurbel.plot_mechanism([30, 150], ratio="1:4", **size)
    return found


def arc_to_scale(**size: Any) -> kurbel.Drawing:
    found: kurbel.Drawing = kurbel.plot_mechanism(60, ratio="1:4", mechanism="arc", rocker=5, **size)
    return found


SIZED = [
    (turning, {"width": 80, "height": 90}),
    (to_scale, {"width": "3.5in", "height": "11cm"}),
    pytest.param(pin_force, {"width": "3.5in", "height": "11cm"}, marks=pytest.mark.slow),
    pytest.param(arc_to_scale, {"width": 80, "height": 90}, marks=pytest.mark.slow),
]


@pytest.mark.parametrize(("draw", "given"), SIZED)
def test_a_drawing_is_as_large_as_was_asked_in_every_format(
    draw: Callable[..., kurbel.Drawing], given: dict[str, Any]
) -> None:
    drawing = draw(**given)
    mm = {80: 80, 90: 90, "3.5in": 88.9, "11cm": 110}
    pdf, svg, png = (drawing.image(form) for form in ("pdf", "svg", "png"))
    box = [float(one) for one in re.findall(rb"/MediaBox \[ 0 0 ([\d.]+) ([\d.]+) \]", pdf)[0]]
    root = Paper(svg).root
    pixels = [int.from_bytes(png[at : at + 4], "big") for at in (16, 20)]
    for number, side in enumerate(("width", "height")):
        meant, points_wide = mm[given[side]], float((root.get(side) or "").removesuffix("pt"))
        assert box[number] / 72 * 25.4 == pytest.approx(meant, abs=0.01)
        assert points_wide / 72 * 25.4 == pytest.approx(meant, abs=0.01)
        assert pixels[number] / 300 * 25.4 == pytest.approx(meant, abs=0.1)
    assert {one.get_fontsize() for one in texts(drawing)} <= {8.0, 9.0}
    drawing.figure.canvas.draw()
    for one in texts(drawing):
        extent = one.get_window_extent()
        assert extent.x0 >= -1 and extent.x1 <= drawing.figure.bbox.x1 + 1


@pytest.mark.parametrize("given", [{"width": 45}, {"width": 60, "height": 80}])
def test_a_narrow_polar_diagram_has_all_of_its_words_on_the_page_and_none_on_another(
    given: dict[str, Any],
) -> None:
    drawing = drawn(kurbel.forces, eps=4, polar=True, ratio="1:5", step=10, lang="en", **given)
    drawing.figure.canvas.draw()
    page = drawing.figure.bbox
    boxes = [one.get_window_extent() for one in texts(drawing) if one.get_visible()]
    assert all(page.x0 <= one.x0 and one.x1 <= page.x1 for one in boxes)
    assert all(page.y0 <= one.y0 and one.y1 <= page.y1 for one in boxes)
    assert not [pair for pair in combinations(boxes, 2) if pair[0].overlaps(pair[1])]


def test_each_angle_of_a_small_polar_diagram_stands_nearest_to_its_own_vector() -> None:
    drawing = drawn(kurbel.forces, "1:5", polar=True, step=10, width=45)
    drawing.figure.canvas.draw()
    (axes,) = drawing.figure.axes
    named = [(one, re.fullmatch(r"(\d+)°", one.get_text())) for one in axes.texts]
    angles = np.radians(np.arange(0, 360, 30))
    rod = np.arcsin(np.sin(angles) / 5)
    # The force in a rod under a constant force on the piston, by its components at the crank.
    heads = np.stack((np.sin(angles + rod), np.cos(angles + rod)), axis=1) / np.cos(rod)[:, None]
    places = axes.transData.transform(heads)
    found = [(one.get_window_extent(), int(angle[1])) for one, angle in named if angle]
    assert len(found) > 8
    for box, angle in found:
        away = places - np.clip(places, (box.x0, box.y0), (box.x1, box.y1))
        assert 30 * np.hypot(*away.T).argmin() == angle % 360


def test_a_mechanism_too_small_to_be_seen_is_refused_with_a_size_that_will_do() -> None:
    with pytest.raises(kurbel.KurbelError, match="to scale this one needs") as error:
        to_scale(width=20)
    least = [int(one) for one in re.findall(r"(\d+) mm", str(error.value))[-2:]]
    assert to_scale(width=least[0], height=least[1]).figure.get_figwidth() * 25.4 == pytest.approx(least[0])
