"""What belongs together stands together: gaps between columns, pauses between rows, symbols in spanners."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

import pytest

import kurbel
from kurbel.exact.numerals import Number
from kurbel.formats.latex.writer import TIGHT, whole_pairs, widths
from kurbel.formats.page import page
from kurbel.formats.spacing import gaps, panel_pauses
from kurbel.formats.writer import PLAIN
from kurbel.page.table import DITTO, Cell, Column, Group, Panel, Row, shared_symbols

Stub: TypeAlias = Sequence[Cell] | Sequence[tuple[Cell, ...]]


def panel(stub: Stub, *columns: Column, key: str = "angle") -> Panel:
    cells = [(one,) if isinstance(one, Cell) else one for one in stub]
    rows = tuple(Row(tuple(one), (Cell(None),) * len(columns)) for one in cells)
    names = tuple(Column(f"{key}{place}" if place else key, (key,)) for place in range(len(cells[0])))
    return Panel(names[::-1], columns, (Group(rows),))


def numbers(start: int, stop: int, step: int, decimals: int = 0) -> list[Cell]:
    return [Cell(Number(one, decimals)) for one in range(start, stop + 1, step)]


def before(cells: Stub, key: str = "angle", every: int | None = None) -> list[int]:
    """Return the rows before which there is a pause."""
    (pauses,) = panel_pauses(panel(cells, Column("x", ("x",)), key=key), every)
    return sorted(pauses)


X, C = ("Kolbenweg",), ("Kolbengeschwindigkeit",)


@pytest.mark.parametrize(
    ("paths", "wanted"),
    [
        ((X, X, C, C), [2.6, 1.3, 2.6, 1.3]),
        # Halves under one outer spanner stand closer than strangers; without spanners gaps are even.
        ((("Rod", "x"), ("Rod", "x"), ("Rod", "c"), ("Pin", "c")), [2.6, 1.3, 2.0, 2.6]),
        (((), (), ()), [2.0, 2.0, 2.0]),
    ],
)
def test_gaps_are_half_as_wide_within_a_pair_as_between_pairs(
    paths: tuple[tuple[str, ...], ...], wanted: list[float]
) -> None:
    columns = [Column(str(place), ("Hingang",), path) for place, path in enumerate(paths)]
    assert [*gaps(panel(numbers(0, 20, 10), *columns))] == [0, *wanted]


@pytest.mark.parametrize(
    ("start", "stop", "step", "decimals", "stride"),
    [
        (0, 180, 10, 0, 30),
        (0, 90, 2, 0, 10),
        (0, 360, 15, 0, 45),
        (0, 360, 30, 0, 90),
        (0, 50, 1, 1, 5),
        (5, 175, 10, 0, 30),
    ],
)
def test_angles_pause_at_round_ones(start: int, stop: int, step: int, decimals: int, stride: int) -> None:
    wanted = [place for place, one in enumerate(range(start, stop + 1, step)) if place and not one % stride]
    assert before(numbers(start, stop, step, decimals)) == wanted


def test_pauses_of_other_rows() -> None:
    # 2,0 to 6,0 in steps of 0,2: a pause before each whole number.
    assert before(numbers(20, 60, 2, 1), "expansion") == [5, 10, 15, 20]
    halves = [Cell(f"${half // 2}°{30 * (half % 2)}'$") for half in range(13)]
    assert before(halves) == before(numbers(0, 60, 5, 1)) != []
    # Short tables, words and uneven steps have none; rows of one cell of the stub stay together.
    for stub in (numbers(0, 100, 10), [Cell(one) for one in "abcdefghijklmnop"],
                 [*numbers(0, 120, 10), *numbers(125, 180, 5)]):  # fmt: skip
        assert before(stub) == []
    pairs = [(Cell(DITTO if place % 4 else f"1:{place}"), Cell(f"row {place}")) for place in range(16)]
    assert before(pairs) == [4, 8, 12]
    # A layout says after how many rows.
    assert before(numbers(0, 70, 10), every=4) == [4]
    assert before(numbers(0, 180, 10), every=0) == []


def heads(*columns: tuple[tuple[str, ...], tuple[str, ...]]) -> dict[tuple[str, ...], str]:
    made = (Column(str(place), heading, path) for place, (path, heading) in enumerate(columns))
    return shared_symbols(panel(numbers(0, 20, 10), *made))


def test_a_symbol_that_all_columns_below_share_stands_in_the_spanner() -> None:
    shared = heads(
        (X, ("Hingang", "$x/R$")), (X, ("Rückgang", "$x/R$")), (C, ("Hingang", "$c/v$")), (C, ("R", "$c/v$"))
    )
    assert shared == {X: "$x/R$", C: "$c/v$"}


@pytest.mark.parametrize("odd", ["$x$ in mm", "mm"])
def test_symbols_stay_where_a_line_of_the_head_would_remain(odd: str) -> None:
    assert not heads((X, ("Hingang", "$x/R$")), (X, ("Hingang", odd)), (C, ("H", "$c$")), (C, ("R", "$c$")))
    # Nothing else would be left of the heading.
    assert not heads((X, ("$x/R$",)), (X, ("$x/R$",)))


def test_a_gap_below_a_wide_spanner_is_whole_and_costs_no_width() -> None:
    ready = page(kurbel.table("1:5"), PLAIN, ",")
    before = widths(ready, stacked=False)
    after = whole_pairs(ready, before)
    # φ; x, x; c, c; p, p: "Kolbenweg x/R" is hardly wider than its pair.
    assert [*after.gaps] == [0, 2.6, 1.3, 2.6, 0, 2.6, 0]
    assert (after.left[4], after.left[6]) == (1.3, 1.3)
    # On the line on which gaps are half as wide, the page has the width that it had.
    assert after.all + TIGHT * sum(after.gaps) == pytest.approx(before.all + TIGHT * sum(before.gaps))
    assert min(*after.left, *after.right) >= 0
