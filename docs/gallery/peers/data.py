"""The tables that all set, in German: the usual one, and a tall, a wide and a long one."""

from __future__ import annotations

from functools import cached_property
from typing import NamedTuple

import kurbel

CAPTION = "Kolbenweg, Kolbengeschwindigkeit und Kolbenbeschleunigung; genaue Formeln"
# A spanner, and its symbol in HTML and in TeX.
SPANNERS = (
    ("Kolbenweg", "<i>x</i>/<i>R</i>", "x/R"),
    ("Kolbengeschwindigkeit", "<i>c</i>/<i>v</i>", "c/v"),
    ("Kolbenbeschleunigung", "<i>pR</i>/<i>v</i><sup>2</sup>", "pR/v^2"),
)


class Row(NamedTuple):
    """A row: the ratio as text, the angle, and certified values as they are printed, with a point."""

    ratio: str
    phi: int
    values: tuple[str, ...]


class Case:
    """Path, velocity and acceleration for some ratios, four decimals: the page, and what peers set of it.

    They compute nothing, and have the same digits as we. Below each spanner there are the same `heads`.
    """

    def __init__(
        self, ratios: tuple[str, ...], angle: str, ends: tuple[str, ...], heads: tuple[str, ...], layout: str
    ) -> None:
        self.ratios, self.heads = ratios, heads
        self.keys = [tuple(f"{letter}{end}" for end in ends) for letter in "xcp"]
        self.page: kurbel.Table = kurbel.table(ratios, angle=angle, layout=layout)

    @property
    def columns(self) -> list[str]:
        return [key for keys in self.keys for key in keys]

    @cached_property
    def rows(self) -> list[Row]:
        frame = self.page.to_pandas(exact=True)
        return [
            Row(one.ratio, int(one.phi), tuple(str(getattr(one, key)) for key in self.columns))
            for one in frame.itertuples()
        ]

    def of(self, ratio: str) -> list[Row]:
        return [row for row in self.rows if row.ratio == ratio]


_STROKES = ("", "_return"), ("Hingang", "Rückgang"), "kinematics"
_METHODS = ("_exact", "_series", "_difference"), ("genau", "1. Ordnung", "Unterschied"), "verfahren"
USUAL = Case(("1:5", "1:4"), "0..180:10", *_STROKES)
TALL = Case(("1:6", "1:5", "1:4"), "0..180:10", *_STROKES)
WIDE = Case(("1:5",), "0..180:10", *_METHODS)
LONG = Case(("1:5",), "0..180:1", *_STROKES)


def comma(value: str) -> str:
    return value.replace(".", ",").replace("-", "−")
