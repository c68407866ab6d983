"""Lengths read back from the drawing, held against their true values on paper."""

import math
import random
import re
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import pytest

import kurbel
from kurbel.books.constructions.registry import CONSTRUCTIONS, construction
from kurbel.exact.numerals import Number
from kurbel.page.labels import plain

# In mm on paper; a point of SVG is 1/72 in.
PAPER, POINT = 0.01, 25.4 / 72
# Indices of letters, C₁, which ids write C_1.
SMALL = {ord(small): f"_{digit}" for digit, small in enumerate("₀₁₂₃₄₅₆₇₈₉")}
PATH = r'<g id="length-{}">\s*<path d="M ([-\d.]+) ([-\d.]+)\s*L ([-\d.]+) ([-\d.]+)'


def drives(name: str, count: int) -> list[tuple[str, str]]:
    """Return ratios and angles, also beyond 180° and at dead centres, the same in every run."""
    dice = random.Random(name)
    some = [(Fraction(dice.randint(120, 600), 100), dice.randint(1, 3599)) for _ in range(count)]
    return [(f"1:{float(rod)}", str(angle / 10)) for rod, angle in some]


# What describes drives of a mechanism, at any of the ratios.
OTHERS: Mapping[str, Mapping[str, str]] = {"offset": {"offset": "-0.15"}, "arc": {"rocker": "6"}}
ASKED = [
    (name, mechanism)
    for name in CONSTRUCTIONS
    for mechanism in construction(name).holds
    if mechanism == "straight" or mechanism in OTHERS
]


@pytest.mark.parametrize(("name", "mechanism"), ASKED)
def test_a_length_on_paper_is_the_printed_one(name: str, mechanism: str) -> None:
    drive: dict[str, Any] = {"mechanism": mechanism, **OTHERS.get(mechanism, {})}
    for ratio, angle in drives(name, 3 if mechanism == "straight" else 1):
        drawing = kurbel.plot_construction(name, ratio=ratio, angle=angle, **drive)
        svg = drawing.image().decode()
        # "R = 15 mm, F = 30 mm; 1. …"
        scales = dict(re.findall(r"(\S+) = ([\d.e-]+) mm", drawing.about.partition(";")[0]))
        page = kurbel.construction_table(
            name, ratio=ratio, angle=angle, columns="length,drawn,unit", digits=12, **drive
        )
        for letters, printed, unit in page.records.rows:
            if unit == "°":
                continue
            assert isinstance(printed, Number) and isinstance(letters, str)
            written = plain(letters).replace("′", "'").translate(SMALL)
            found = re.search(PATH.format(re.escape(written)), svg)
            assert found, (name, ratio, angle, written)
            x, y, to_x, to_y = map(float, found.groups())
            assert math.hypot(to_x - x, to_y - y) * POINT == pytest.approx(
                abs(printed.scaled) / 10**printed.decimals * float(scales[plain(str(unit))]), abs=PAPER
            ), (name, ratio, angle, written)
