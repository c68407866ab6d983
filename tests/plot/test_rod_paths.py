"""Paths of points of the rod, read back from drawings: those of closed links, at the drawing's scale."""

from __future__ import annotations

import csv
import re
import xml.etree.ElementTree as ET
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from cli import kurbel as typed
from links import arc_crank
from numpy.testing import assert_allclose
from numpy.typing import NDArray
from rod_points import position
from tools import require_library

import kurbel
from kurbel.drive.crank import Crank
from kurbel.linkage.arc.crank import ArcCrank

SVG = "{http://www.w3.org/2000/svg}"
MM = 72 / 25.4
Points = NDArray[np.complex128]


@pytest.fixture(autouse=True)
def library() -> None:
    require_library("matplotlib")


def lines(svg: bytes) -> dict[str, Points]:
    """Return the points of the lines that have a name, in mm from the lower left corner."""
    found = {}
    for group in ET.fromstring(svg).iter(f"{SVG}g"):
        paths = [one.get("d", "") for one in group.iter(f"{SVG}path")]
        if re.fullmatch(r"crank|rod|path-\d+", group.get("id", "")):
            pairs = re.findall(r"[ML] (-?[\d.]+) (-?[\d.]+)", " ".join(paths))
            places = [complex(float(x), -float(y)) / MM for x, y in pairs]
            found[group.get("id", "")] = np.array(places, dtype=np.complex128)
    return found


@pytest.mark.parametrize(
    ("about", "drive", "points"),
    [
        ({"ratio": "1:5"}, Crank(Fraction(1, 5)), ["0.5"]),
        (
            {"ratio": "1:3", "offset": "-0.6"},
            Crank(Fraction(1, 3), Fraction(-3, 5)),
            ["0.3", "1.2,0.4", "-0.2"],
        ),
        (
            {"ratio": "2:9", "mechanism": "arc", "rocker": 7, "offset": "0.7"},
            arc_crank("4.5", "7", offset="0.7"),
            ["0.5,-0.2"],
        ),
    ],
)
def test_a_path_goes_through_the_places_of_its_point(
    about: dict[str, Any], drive: Crank | ArcCrank, points: list[str]
) -> None:
    drawn = lines(kurbel.plot_mechanism(40, point=points, **about).image("svg"))
    shaft, pin = drawn["crank"]
    for number, point in enumerate(points):
        share, _, beside = point.partition(",")
        place, path = position(drive, Fraction(share), Fraction(beside or 0)), drawn[f"path-{number + 1}"]
        # Half-way between two marks, which hide the line.
        true = [complex(place(np.radians(turn))) for turn in range(15, 360, 30)]
        apart = [to_line(path, shaft + abs(pin - shaft) * one) for one in true]
        assert sorted(apart)[8] < 0.01, apart
        assert max(apart) < 1.5


def to_line(line: Points, point: complex) -> float:
    """Return how far a point is from a line of straight pieces."""
    start, way = line[:-1], np.diff(line)
    along = np.clip(((point - start) / np.where(way, way, 1)).real, 0, 1)
    return float(abs(start + along * way - point).min())


def test_what_cannot_be_drawn_of_a_point_is_said() -> None:
    for words, sentence in (
        (("--point=0.5", "--ratio=1:4;1:5"), "--point draws one crank drive, and 2 ratios were given"),
        (("--point=50",), "too small to be seen; give one nearer to the rod, or --columns"),
        (("--point=0.5", "--forces"), "--point says nothing about the forces"),
        (("--point=0.5", "--over=path"), "over the crank angle; leave --over out"),
        (("--point=0.5", "--columns=velocity", "--force=1kN"), "--force says nothing about points"),
        (("--point=0..1:0.05",), "at most 12 can be told apart"),
    ):
        result = typed("plot", *words, "-f", "svg", "-o", "never.svg")
        assert result.code in (1, 2)
        assert sentence in result.err


def test_curves_of_points_are_the_numbers_of_their_table() -> None:
    keys = ["path_along", "path_across", "velocity", "velocity_direction", "acceleration"]
    angles = [5, 100, 215, 340]
    about: dict[str, Any] = {"ratio": "1:4", "point": ["0.5", "0.3,0.2"], "columns": keys}
    question: Any = kurbel.table.question(angle=[0], **about)
    drawn = question.curves(np.array(angles, dtype=float))
    rows = csv.DictReader(kurbel.typeset(kurbel.table(angle=angles, digits=12, **about), "csv").splitlines())
    table = np.array([[float(row[key]) for key in keys] for row in rows]).reshape(2, 4, 5)
    found = np.array(drawn).transpose(1, 2, 0)
    # Directions go on beyond a turn.
    found[:, :, 3] %= 360
    assert_allclose(found, table, rtol=0, atol=1e-11)
