"""Every printed value of the books against kurbel's digits, each cell a test that bears its address."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import pytest
import textbook
from places import SOURCES
from registers import register

from kurbel.drive.crank import Crank
from kurbel.exact.numerals import Number, number_text
from kurbel.motion.evaluation import certified
from kurbel.motion.page import Request
from kurbel.motion.quantities import registry
from kurbel.page.build import build
from kurbel.page.layouts import layout
from kurbel.reading.notation import angles, ratio

FOLDER = SOURCES
FIFTY_DIGITS = 170


@dataclass(frozen=True)
class Printed:
    """One printed value and what the record says of it."""

    place: str
    method: str
    cell: str
    computed: str
    record: str
    printed: str

    @property
    def ratio(self) -> Fraction:
        return ratio(self.place.split("/")[1])

    @property
    def angles(self) -> tuple[Fraction, ...]:
        """The angle, or the angle and its mirror image."""
        return tuple(map(Fraction, self.place.split("/")[2].split("-")))

    @property
    def quantity(self) -> str:
        return self.place.split("/")[3]

    @property
    def decimals(self) -> int:
        return len(self.printed.partition(",")[2])

    def kurbel(self, angle: Fraction) -> str:
        """Return what kurbel prints, to as many decimals as the book."""
        crank = Crank(self.ratio)
        scaled = certified(registry()[self.quantity], self.method, crank, angle, self.decimals)
        return number_text(Number(scaled, self.decimals), ",")


def printed_values() -> list[Printed]:
    found = []
    for path in sorted(FOLDER.glob("*.csv")):
        for row in register(path):
            assert row["place"].startswith(f"{path.stem}/")
            found.append(Printed(**row))
    return found


CELLS = printed_values()
each_cell = pytest.mark.parametrize("cell", CELLS, ids=[cell.place for cell in CELLS])


@each_cell
def test_kurbel_prints_the_computed_value_and_the_book_as_recorded(cell: Printed) -> None:
    assert cell.kurbel(cell.angles[0]) == cell.computed
    assert cell.record == ("agrees" if cell.printed == cell.computed else "differs")


@each_cell
def test_computed_value_is_that_of_the_textbook_formula(cell: Printed) -> None:
    value = textbook.evaluate(
        cell.quantity, cell.method, textbook.Drive(cell.ratio), cell.angles[0], bits=FIFTY_DIGITS
    )
    scaled = textbook.rounded(value, cell.decimals, bits=FIFTY_DIGITS)
    if scaled is None:
        # R/L = 1/4 at 90°: (1 + 1/8)/2 is 0.5625, which no digits of mpmath decide.
        assert (cell.place, cell.computed) == ("blau-32/1:4/90/x_stroke", "0,563")
    else:
        assert textbook.printed(scaled, cell.decimals, ",") == cell.computed


MIRRORED = [cell for cell in CELLS if len(cell.angles) == 2]


@pytest.mark.parametrize("cell", MIRRORED, ids=[cell.place for cell in MIRRORED])
def test_mirrored_angle_has_the_same_acceleration_and_the_opposite_velocity(cell: Printed) -> None:
    sign = "-" if cell.quantity == "c" and cell.angles[0] else ""
    assert cell.kurbel(cell.angles[1]) == sign + cell.computed


def test_every_value_of_the_sources_is_there() -> None:
    places = [cell.place for cell in CELLS]
    halves = range(0, 90, 10)
    assert places == [
        *(f"blau-31/1:5/{angle}/{key}" for angle in (45, 90, 135) for key in ("x", "x_stroke")),
        *(f"blau-32/1:4/{angle}/{key}" for angle in (45, 90, 135) for key in ("x", "x_stroke")),
        *(
            f"roetscher-112/{shown}/{angle}-{360 - angle}/{key}"
            for shown in ("1:5", "1:4,5", "1:4")
            for key in ("p", "c")
            for angle in halves
        ),
    ]
    assert len(places) == 12 + 54


def test_the_page_of_roetscher_112_holds_the_computed_values() -> None:
    page = layout("roetscher-112")
    cranks = tuple(Crank(ratio(text)) for text in page.ratios)
    block = build(Request(layout=page, cranks=cranks, angles=angles(page.angles))).panels[0]
    values = [cell.value for row in block.rows() for cell in row.cells]
    shown = [number_text(value, ",") for value in values if isinstance(value, Number)]
    computed = [cell.computed for cell in CELLS if cell.place.startswith("roetscher-112/")]
    assert shown == ["0,000" if text == "0" else text for text in computed]
