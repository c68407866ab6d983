"""The table that all set: path, velocity and acceleration for R:L = 1:5 and 1:4, four decimals, in German."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import kurbel

CAPTION = "Kolbenweg, Kolbengeschwindigkeit und Kolbenbeschleunigung; genaue Formeln"
RATIOS = ("1:5", "1:4")
# Spanner, symbol in HTML and in TeX, and the columns below it.
PAIRS = (
    ("Kolbenweg", "<i>x</i>/<i>R</i>", "x/R", ("x", "x_return")),
    ("Kolbengeschwindigkeit", "<i>c</i>/<i>v</i>", "c/v", ("c", "c_return")),
    ("Kolbenbeschleunigung", "<i>pR</i>/<i>v</i><sup>2</sup>", "pR/v^2", ("p", "p_return")),
)
STROKES = ("Hingang", "Rückgang")
KEYS = tuple(key for *_, keys in PAIRS for key in keys)


class Row(NamedTuple):
    """A row: the ratio as text, the angle, and six certified values as they are printed, with a point."""

    ratio: str
    phi: int
    values: tuple[str, ...]


@cache
def page() -> kurbel.Table:
    found: kurbel.Table = kurbel.table(RATIOS)
    return found


@cache
def rows() -> tuple[Row, ...]:
    """Return what peers set: they compute nothing, and have the same digits as we."""
    frame = page().to_pandas(exact=True)
    return tuple(
        Row(one.ratio, int(one.phi), tuple(str(getattr(one, key)) for key in KEYS))
        for one in frame.itertuples()
    )


def comma(value: str) -> str:
    return value.replace(".", ",").replace("-", "−")
