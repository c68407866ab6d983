"""The shipped layouts: on every page each cell stands under the heads of its own row and quantity.

What belongs there is read from the records, which know no page; that these are right is tested where they are
computed, and the look of the pages stands in tests/golden/layouts and tests/transcripts/printed.
"""

from __future__ import annotations

import re
from decimal import Decimal

import numpy as np
import pytest
from cli import printed, records, refusal
from pages import MOTION, Address, addressed, cells, default_page, page_of, shown

import kurbel
from kurbel.page.labels import plain
from kurbel.page.layouts import LANGUAGES, layout, layout_names
from kurbel.page.table import Table

# Collations have columns that pages leave out, and tests of their own.
NAMES = [name for name in layout_names() if name not in ("collation", "formulas")]
AXES = {"phi": "angle", "epsilon": "expansion"}
TOLD = ("ratio", "phi", "order", "compression", "pressure_ratio")


def grid(table: Table) -> list[tuple[Address, str]]:
    """Return the cells row by row; blocks below each other are parts of one table."""
    blocks = []
    for panel in table.panels:
        count = sum(1 for _ in panel.rows())
        found = [*addressed(panel)]
        width = len(found) // count
        blocks.append([found[width * row : width * (row + 1)] for row in range(count)])
    return [cell for rows in zip(*blocks, strict=True) for row in rows for cell in row]


def alike(cell: str, record: str) -> bool:
    """Tell whether a cell has what a record has, in minutes of arc or in a unit a thousand times as large."""
    if angle := re.fullmatch(r"\$(\d+)°(\d+)'\$", cell):
        return abs(int(angle[1]) + int(angle[2]) / 60 - float(record)) <= 1 / 120 + 1e-4
    return cell == record or Decimal(cell).scaleb(3) == Decimal(record)


def check(table: Table) -> None:
    form = layout(table.layout)
    rows = [[shown(value) for value in row] for row in table.records.rows]
    found = grid(table)
    count, rest = divmod(len(found), len(rows))
    assert rest == 0
    first = len(table.records.fields) - count
    keys = [AXES.get(field.key, field.key) for field in table.records.fields[:first]]
    places = np.arange(len(found))
    if form.across != ("column",):
        sizes = [len({row[place] for row in rows}) for place in range(first)]
        order = [name for name in (*form.down, *form.across) if name in (*keys, "column")]
        order += [] if "column" in order else ["column"]
        outer = [name for name in keys if name not in order]
        axes = [[*keys, "column"].index(name) for name in (*outer, *order)]
        places = places.reshape(*sizes, count).transpose(axes).ravel()
    for (address, text), place in zip(found, places, strict=True):
        row, field = rows[place // count], table.records.fields[first + place % count]
        assert alike(text, row[first + place % count]), (address, row)
        heads = plain(" ".join(address))
        for name, value in zip(keys, row, strict=False):
            told = name in TOLD and form.subject not in ("roots", "loaded roots")
            assert not told or plain(value) in f"{table.caption} {heads}", (address, row)
        if not any(one.spanners or one.heading for one in form.columns):
            words = [plain(part).lower() for part in field.name.split(", ")]
            assert all(word in heads.lower() for word in words) or plain(field.symbol) in heads, field


@pytest.mark.parametrize(("place", "name"), [*enumerate(NAMES)])
def test_every_cell_stands_under_its_heads(place: int, name: str) -> None:
    lang = LANGUAGES[place % 2]
    table = default_page(name, lang)
    assert (table.lang, table.layout) == (lang, name)
    check(table)
    for text in (table.caption, table.source, *(note.text for note in table.notes)):
        assert "{" not in text


@pytest.mark.parametrize("name", MOTION)
def test_cells_of_several_ratios_and_odd_angles_stand_under_theirs(name: str) -> None:
    ratios, angles = ["1:4", "1:3.5", "1:7"], ["17.5", "30.5", "77.5", "123.5"]
    for lang in LANGUAGES:
        check(page_of(name, lang=lang, ratio=ratios, angle=angles))
    # Its own ratios and angles are those of a page of which nothing is asked.
    own = layout(name)
    assert cells(page_of(name, ratio=own.ratios, angle=own.angles)) == cells(default_page(name))


def test_pages_are_parted_into_as_few_blocks_as_needed() -> None:
    for angles, sizes in (("0..90:10", [10]), ("0..180:5", [9, 9, 9, 10]), ("0..100:10", [5, 6])):
        panels = kurbel.table(layout="roetscher-112", angle=angles).panels
        assert [len(panel.columns) for panel in panels] == sizes


def test_what_is_exactly_zero_is_printed_as_in_the_book_and_what_is_nearly_zero_is_not() -> None:
    # Rötscher, Zusammenstellung 112: 0 at 0°, 0,206 at 10°.
    page = kurbel.table("1:5", layout="roetscher-112", angle="0;0.001;10;180", lang="en")
    velocity = [*page.panels[0].rows()][1].cells
    assert [shown(cell.value) for cell in velocity] == ["0", "0.000", "0.208", "0"]
    # Programs have the decimals of the column.
    words = ("table", "--layout=roetscher-112", "--ratio=1:5", "--angle=0;10")
    assert [record["c"] for record in records(*words)] == ["0.000", "0.208"]


def test_a_page_has_at_most_500_columns() -> None:
    words = ("table", "--layout=kolbenwege", "--angle=30", "-f", "html")
    assert printed(*words, "--ratio=1:3..252").out.count("<td") == 500
    sentence = "a page of 502 columns is too wide; at most 500 are set, use -f csv or -f json"
    assert refusal(*words, "--ratio=1:3..253") == sentence


def test_the_mean_piston_speed_in_the_notes_is_the_stroke_in_half_a_turn() -> None:
    # Of a crank of 0.3 m that turns with 2.5 rad/s, half a turn takes π/2.5 s.
    (stroke,) = records("deadcentres", "--ratio=1:4", "--offset=0.5", "--digits=9")
    (note,) = (
        note.text
        for note in kurbel.table("1:4", stroke="600mm", offset="0.5R", speed="2.5rad/s", lang="en").notes
        if "mean piston speed" in note.text
    )
    found = re.search(r'c_m = ([\d.]+) "m/s"', note)
    assert found
    assert float(found[1]) == pytest.approx(float(stroke["stroke"]) * 0.3 * 2.5 / np.pi, abs=6e-4)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        # c_m = S n/30 = 0.075 · 125/30 = 0.3125 m/s and v = R ω = 0.3 · 12.345 = 3.7035 m/s are ties.
        ("--ratio 1:5 --stroke 75mm --speed 125/min", "cₘ = 0.313 m/s"),
        ("--ratio 1:5 --stroke 600mm --speed 12.345rad/s", "v = 3.704 m/s"),
        ("--ratio 1:4 --stroke 93mm --speed 2005/min", "cₘ = 6.216 m/s"),
    ],
)
def test_ties_in_the_notes_are_settled(words: str, said: str) -> None:
    page = printed("table", *words.split(), "--angle=90", "--lang=en").out
    assert said in " ".join(page.split())


def test_digits_go_for_every_column() -> None:
    found = cells(kurbel.table(layout="lueger-kolbenbewegung", angle=77, digits=30))
    path, bracket = found.values()
    assert path == str(kurbel.certified("x_percent", "1:5", 77, digits=30))
    assert bracket == str(kurbel.certified("p", "1:5", 77, digits=30, method="series"))


def test_a_label_names_the_table_and_keeps_the_templates_of_its_layout() -> None:
    page = kurbel.table(label="eins", angle=90)
    assert (page.key, page.layout) == ("eins", "kinematics")
