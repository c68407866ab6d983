"""Pages in the formats that are text alone, and what they share; LaTeX and HTML are also run elsewhere."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from html.parser import HTMLParser
from xml.etree import ElementTree

import pytest
from everything import everything, n
from golden import assert_golden
from page_formats import page_format
from places import SUPPORT
from readers import fragment, markdown_tables, model_cells

from kurbel.exact.numerals import Number
from kurbel.formats.page import page
from kurbel.formats.registry import FORMATS, by_name
from kurbel.formats.render import render
from kurbel.page.table import DITTO, Cell, Column, Group, Note, Panel, Records, Row, Table

PAGES = [entry.name for entry in FORMATS.values() if entry.kind == "page"]


def table_of(columns: tuple[Column, ...], *rows: Row, stub: tuple[Column, ...] = ()) -> Table:
    return Table("small", "de", "Klein", (Panel(stub, columns, (Group(rows),)),), Records((), ()))


@pytest.mark.parametrize("name", PAGES)
def test_page_with_every_part_is_golden(name: str) -> None:
    assert_golden(f"everything{by_name(name).suffixes[0]}", render(everything(), name))


@pytest.mark.parametrize("name", PAGES)
def test_every_format_has_the_users_decimal_mark_and_clean_lines(name: str) -> None:
    german, english = render(everything(), name), render(everything(), name, decimal="point")
    assert ("0,576" in german, "0.576" in german) == (True, False)
    assert ("0,576" in english, "0.576" in english) == (False, True)
    assert render(everything(lang="en"), name).count("0.576") == 1
    assert german.endswith("\n")
    assert not german.endswith("\n\n")
    assert "\n\n\n" not in german
    assert not [line for line in german.splitlines() if line != line.rstrip()]
    bare = replace(everything(), caption="", source="", panels=everything().panels[1:], notes=())
    assert "1,200" in render(bare, name)
    assert "Quelle" not in render(bare, name)


def test_text_needs_no_numpy_and_no_scipy() -> None:
    code = (
        "import sys; sys.path.insert(0, sys.argv[1]);"
        "from everything import everything; from kurbel.formats.render import render;"
        "render(everything(), 'text');"
        "print([name for name in ('numpy', 'scipy', 'flint') if name in sys.modules])"
    )
    command = [sys.executable, "-c", code, str(SUPPORT)]
    assert subprocess.check_output(command, text=True) == "[]\n"


# Text


def test_decimal_marks_stand_in_line_whatever_the_digits() -> None:
    cells = (n(5), n(-12500), n(7, 0), n(25, 1), Cell(Number(1, 3), ("a",)), Cell(None))
    panel = Panel(
        (), (Column("x", ("Ein breiter Kopf",)),), (Group(tuple(Row((), (cell,)) for cell in cells)),)
    )
    table = replace(table_of(()), panels=(panel,), notes=(Note("Hinweis", "a"),))
    body = render(table, "text").splitlines()[5:-2]
    assert [line.strip() for line in body] == ["0,005", "−12,500", "7", "2,5", "0,001ᵃ⁾", "–"]
    assert {line.index(",") for line in body if "," in line} == {8}
    assert body[2].index("7") == 7


def test_spanner_wider_than_its_columns_is_shared_out_evenly() -> None:
    columns = tuple(Column(key, (key,), ("Kolbengeschwindigkeit",)) for key in "ab")
    lines = render(table_of(columns, Row((), (n(1), n(2)))), "text").splitlines()
    assert lines[2] == "━" * 23
    assert lines[3:5] == [" Kolbengeschwindigkeit", " " + "─" * 21]
    first, second = lines[-2].index("0,001"), lines[-2].index("0,002")
    assert abs((first - 1) - (22 - (second + 5))) <= 1


def test_wide_page_of_text_closes_its_gaps_before_it_leaves_the_terminal() -> None:
    columns = tuple(Column(str(place), ("Kopf",)) for place in range(13))
    lines = render(table_of(columns, Row((), tuple(n(-1234) for _ in columns))), "text").splitlines()
    assert max(map(len, lines)) <= 100


def test_no_line_end_cuts_a_formula_in_text() -> None:
    label = "Ein Satz, dessen Formel am Ende der Zeile stünde, nämlich $R:L = 1:5$"
    table = replace(table_of((Column("x", ("x",)),), Row((), (n(1),))), notes=(Note(label),))
    text = render(table, "text")
    assert "\n R:L = 1:5\n" in text
    assert "\u00a0" not in text


# Markdown


def test_markdown_readers_see_every_cell_of_the_model() -> None:
    table = everything()
    expected = [rows for panel in table.panels for rows in model_cells(panel)]
    found = markdown_tables(render(table, "markdown"))
    assert [rows[1:] for rows in found] == expected
    assert found[0][0][2] == "Genaue Werteᵃ⁾ Kolbenweg Hingang x/R"
    assert found[2][0][2:] == ["0 / 360", "10 / 350"]


def test_groups_without_labels_share_one_markdown_table() -> None:
    (panel,) = table_of((Column("x", ("x",)),), Row((), (n(1),)), Row((), (n(2),))).panels
    groups = tuple(Group((row,)) for row in panel.rows())
    table = replace(table_of(()), panels=(replace(panel, groups=groups),))
    assert markdown_tables(render(table, "markdown")) == [[["x"], ["0,001"], ["0,002"]]]


# HTML


def laid_out(table: ElementTree.Element) -> list[list[ElementTree.Element | None]]:
    """Return the cell at every place of the grid, as a browser lays spans out."""
    grid: dict[tuple[int, int], ElementTree.Element] = {}
    rows = list(table.iter("tr"))
    for y, row in enumerate(rows):
        x = 0
        for cell in row:
            while (y, x) in grid:
                x += 1
            for down in range(int(cell.get("rowspan", "1"))):
                for across in range(int(cell.get("colspan", "1"))):
                    assert (y + down, x + across) not in grid, "two cells overlap"
                    grid[y + down, x + across] = cell
    width = max(x for _, x in grid) + 1
    assert all((y, x) in grid for y in range(len(rows)) for x in range(width)), "the grid has a hole"
    return [[grid.get((y, x)) for x in range(width)] for y in range(len(rows))]


def test_html_grid_has_no_holes_and_every_head_its_scope() -> None:
    for table in fragment(everything()).iter("table"):
        laid_out(table)
        assert {cell.get("scope") for cell in table.iter("th")} <= {"col", "colgroup", "row", "rowgroup"}
        for row in table.findall("thead/tr"):
            assert all(cell.get("scope") in ("col", "colgroup") for cell in row)


def test_html_links_and_references_have_their_targets() -> None:
    tree = fragment(everything())
    targets = [element.get("id") for element in tree.iter() if element.get("id")]
    heads = [element.get("id") for element in tree.iter("th") if element.get("id")]
    # The figure, a caption for each of two panels, three notes.
    assert len(set(targets) - set(heads)) == 6
    assert len(targets) == len(set(targets)) == 6 + len(heads)
    links = [str(link.get("href")).removeprefix("#") for link in tree.iter("a")]
    labelled = [name for element in tree.iter() for name in element.get("aria-labelledby", "").split()]
    # The second panel is called by the table's caption and its own.
    assert (len(links), len(labelled)) == (4, 3)
    assert set(links) | set(labelled) <= set(targets)


def test_html_cells_name_all_heads_above_and_before_them() -> None:
    """By where the cells stand: heads in the column, the label of the group, names in the row."""
    table = next(fragment(everything()).iter("table"))
    grid, named = laid_out(table), 0
    labels = {row: group[0][0] for group in table.findall("tbody") for row in group}
    for row, cells in zip(table.iter("tr"), grid, strict=True):
        for place, cell in enumerate(cells):
            if cell is None or cell.tag != "td" or row not in labels:
                continue
            heads = [above[place] for above in grid[: len(table.findall("thead/tr"))]]
            around = [one for one in (*heads, labels[row], *cells) if one is not None and one.tag == "th"]
            wanted = {one.get("id") for one in around if one.get("id")}
            assert set(cell.get("headers", "").split()) == wanted
            assert len(wanted) >= 4
            named += 1
    assert named == 25


class _Tags(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []

    def handle_starttag(self, tag: str, attrs: object) -> None:
        if tag not in ("meta", "br", "col", "mspace"):
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        if tag != "mspace":
            assert self.open.pop() == tag


def test_html_document_closes_what_it_opens_and_has_no_script() -> None:
    text = render(everything(), "html", standalone=True)
    parser = _Tags()
    parser.feed(text)
    assert parser.open == []
    assert "<script" not in text
    assert text.startswith('<!DOCTYPE html>\n<html lang="de">')


# The page, which all formats share


def test_ditto_at_the_start_of_a_group_begins_anew() -> None:
    rows = (Row((Cell("a"),), (n(1),)), Row((Cell(DITTO),), (n(2),)))
    panel = Panel((Column("s", ("S",)),), (Column("x", ("x",)),), tuple(Group((row,)) for row in rows))
    table = replace(table_of(()), panels=(panel,))
    stubs = [group.rows[0][0] for group in page(table, page_format("text").writer, ",").panels[0].groups]
    assert [(cell.text, cell.down) for cell in stubs] == [("a", 1), ("a", 1)]


def test_columns_of_figures_are_right_and_columns_of_words_left() -> None:
    columns = tuple(Column(key, (key,)) for key in "abcd")
    rows = (
        Row((), (n(1), Cell("2°30'"), Cell("$1:5$"), Cell(None))),
        Row((), (Cell(None), Cell("15 %"), n(1), Cell(None))),
    )
    (panel,) = page(table_of(columns, *rows), page_format("text").writer, ",").panels
    assert [column.align for column in panel.columns] == ["right", "right", "left", "right"]


def test_only_neighbours_under_the_same_outer_spanner_share_an_inner_one() -> None:
    columns = (
        Column("a", ("a",), ("A", "x")),
        Column("b", ("b",), ("B", "x")),
        Column("c", ("c",), ("B", "x")),
    )
    (panel,) = page(table_of(columns, Row((), (n(1), n(2), n(3)))), page_format("text").writer, ",").panels
    assert [[(cell.first, cell.last) for cell in row] for row in panel.spanners] == [[(0, 0), (1, 2)]] * 2
