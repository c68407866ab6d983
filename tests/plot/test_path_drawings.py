"""Drawings over the path: points of the file lie on the curve of crank and rod, R, v, v²/R to one scale."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest
from cli import kurbel, printed, refusal
from numpy.typing import NDArray
from tools import require_library

Points = NDArray[np.float64]
MM = 25.4 / 72
# Nobody sees so little on paper.
NEAR = 0.01


@pytest.fixture(autouse=True)
def _library() -> None:
    require_library("matplotlib")


def drawing(folder: Path, *words: str) -> str:
    file = folder / "plot.svg"
    assert kurbel("plot", "--over=path", *words, "--text", "-o", str(file)).code == 0
    return file.read_text(encoding="utf-8")


def points(svg: str, name: str) -> Points:
    """Return the points of a curve in mm, the second upward."""
    found = re.search(rf'id="{name}">\s*<path d="([^"]*)"', svg)
    assert found
    pairs = re.findall(r"[ML] (\S+) (\S+)", found[1])
    return np.asarray(pairs, float) * (MM, -MM)


def acceleration(cosine: Points, ratio: float) -> Points:
    """Return p R/v² at angles, by the closed form of textbooks, as one and the same root."""
    square = 1 - cosine**2
    root = np.sqrt(1 - ratio**2 * square)
    return np.asarray(cosine + ratio * (2 * cosine**2 - 1 + ratio**2 * square**2) / root**3)


def cosine_at(path: Points, ratio: float) -> Points:
    """Return cos φ by the triangle of R, L and the way from the shaft to the crosshead."""
    way = 1 + 1 / ratio - path
    return np.asarray(np.clip((1 + way**2 - 1 / ratio**2) / (2 * way), -1, 1))


def test_points_of_the_file_lie_on_both_curves_to_one_scale(tmp_path: Path) -> None:
    for ratio in (0.2, 0.37):
        svg = drawing(tmp_path, f"--ratio={ratio}")
        curve = points(svg, "curve-1-1")
        radius = float(np.ptp(curve[:, 0])) / 2
        assert radius > 25
        path, speed = ((curve - curve[0]) / radius).T
        cosine = cosine_at(path, ratio)
        sine = np.sqrt(1 - cosine**2)
        # Of the dead centres the angle is not well known from the path.
        velocity = sine + ratio * sine * cosine / np.sqrt(1 - (ratio * sine) ** 2)
        off = np.abs(np.abs(speed) - velocity) * radius
        assert off[(path > 1e-3) & (path < 2 - 1e-3)].max() < NEAR
        assert (speed[: len(speed) // 2] > -1e-9).all() and (speed[len(speed) // 2 :] < 1e-9).all()
        curve = points(svg, "curve-2-1")
        path, drawn = ((curve - curve[0]) / radius).T
        assert np.abs(drawn + 1 + ratio - acceleration(cosine_at(path, ratio), ratio)).max() * radius < NEAR


def test_the_infinite_rod_draws_a_circle_and_a_straight_line(tmp_path: Path) -> None:
    for words in (("--ratio=1:∞",), ("--ratio=1:∞", "--stroke=600mm", "--speed=120/min", "--width=85")):
        svg = drawing(tmp_path, *words)
        circle, line = points(svg, "curve-1-1"), points(svg, "curve-2-1")
        radius, middle = np.ptp(circle[:, 0]) / 2, (circle.min(axis=0) + circle.max(axis=0)) / 2
        assert np.abs(np.hypot(*(circle - middle).T) - radius).max() < NEAR
        fallen = line[0] - line
        assert np.abs(fallen[:, 0] + fallen[:, 1]).max() < NEAR
        assert abs(np.ptp(line[:, 0]) - 2 * radius) < NEAR


def test_an_offset_crank_has_its_own_branches_and_dead_centres(tmp_path: Path) -> None:
    offset = 0.6
    svg = drawing(tmp_path, "--ratio=1:3", f"--offset={offset}", "--columns=p")
    curve = points(svg, "curve-1-1")
    ends = math.asin(offset / 4), math.pi + math.asin(offset / 2)

    def place(angle: Points) -> Points:
        return np.asarray(np.cos(angle) + np.sqrt(9 - (np.sin(angle) - offset) ** 2))

    stroke = place(np.asarray(ends[0])) - place(np.asarray(ends[1]))
    radius = float(np.ptp(curve[:, 0]) / stroke)
    # The first point is at φ = 0, then half a degree each, with the dead centres among them.
    angles = np.union1d(np.radians(np.arange(0, 360.1, 0.5)), ends)
    assert len(angles) == len(curve)
    gone = place(np.asarray(ends[0])) - place(angles)
    assert np.abs((curve[:, 0] - curve[:, 0].min()) - gone * radius).max() < NEAR
    step = 1e-4
    bend = -(place(angles + step) - 2 * place(angles) + place(angles - step)) / step**2
    assert np.abs((curve[:, 1] - curve[0, 1]) / radius - (bend - bend[0])).max() * radius < NEAR


def test_what_is_named_is_what_conditions_find(tmp_path: Path) -> None:
    svg = drawing(tmp_path, "--ratio=1:5", "--lang=en")
    solved = printed("solve", "--where=p=0", "--where=c=max", "--columns=phi_turn,c", "--lang=en").out
    assert "79°6′" in solved and "280°54′" in solved and "1.0198" in solved
    for text in (
        "79°6′",
        "280°54′",
        "1.0198",
        "inner dead centre",
        "outer dead centre",
        "Outstroke",
        "Return",
    ):
        assert text in svg


def test_series_of_higher_order_are_drawn_and_said(tmp_path: Path) -> None:
    words = ("--ratio=1:5", "--method=series", "--order=3", "--lang=en", "--columns=p")
    svg = drawing(tmp_path, *words)
    assert "piston path" in svg.partition("</title>")[0] and "third-order" in svg.partition("</title>")[0]
    curve = points(svg, "curve-1-1")
    # p = cos φ + λ cos 2φ + ½ λ³ sin² φ (3 cos² φ - sin² φ), of which the first and the last place are 1 ± λ.
    assert abs((curve[0, 1] - curve[-1, 1]) / np.ptp(curve[:, 0]) - 1) < 1e-6


def test_forces_of_an_engine_lie_over_its_stroke(tmp_path: Path) -> None:
    file = tmp_path / "forces.svg"
    words = ("plot", "--forces", "--eps=4", "--back=10%", "--over=path", "--columns=piston_force")
    assert kurbel(*words, "-o", str(file)).code == 0
    curve = points(file.read_text(encoding="utf-8"), "curve-1-1")
    share = (curve[:, 0] - curve[:, 0].min()) / np.ptp(curve[:, 0])
    out = slice(0, np.flatnonzero(share >= 1 - 1e-9)[0] + 1)
    force = curve[out, 1]
    full = np.abs(force - force[0]) < 1e-6
    # Full pressure up to the cut-off at a quarter of the stroke; behind it p x is constant (Mariotte).
    assert (share[out][full] <= 0.25 + 1e-6).all() and abs(share[out][full].max() - 0.25) < 1e-6
    products = (force[~full] - force[-1]) / (force[0] - force[-1])
    assert np.abs(products - (0.25 / share[out][~full] - 0.25) / 0.75).max() < 1e-4


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("--columns x", "a straight line"),
        ("--columns c_return", "write c"),
        ("--mechanism parallel", "no piston"),
        ("--positions 30", "says nothing about the mechanism"),
        ("--height 40", "to scale"),
        ("--width 40", "the width is 40 mm"),
    ],
)
def test_what_has_no_curve_over_the_path_is_refused(words: str, said: str, tmp_path: Path) -> None:
    file = tmp_path / "none.svg"
    assert said in refusal("plot", "--over=path", *words.split(), "-o", str(file))
    assert not file.exists()
