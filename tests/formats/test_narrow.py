"""Pages on a narrow terminal: parted into panels, with nothing lost."""

from __future__ import annotations

import pytest
from pages import MOTION, default_page

from kurbel import table
from kurbel.formats.render import render
from kurbel.page.layouts import layout_names
from kurbel.page.table import Table

MACHINE = {"stroke": 2, "speed": 3}


def page(name: str, stroke: int | None = None, speed: int | None = None) -> Table:
    if name not in MOTION:
        return default_page(name)
    return table(layout=name, angle="30;90", stroke=stroke, speed=speed)


def figures(text: str) -> list[str]:
    return sorted(word for word in text.split() if word.removeprefix("−").replace(",", "").isdigit())


PAGES = [
    *((name, {}) for name in layout_names()),
    ("kinematics", MACHINE),
]


@pytest.mark.parametrize("width", [40, 60, 80, 120])
@pytest.mark.parametrize(("name", "machine"), PAGES)
def test_no_line_is_wider_than_the_terminal_and_no_figure_is_lost(
    name: str, machine: dict[str, int], width: int
) -> None:
    table = page(name, **machine)
    narrow = render(table, "text", width=width)
    assert max(map(len, narrow.splitlines())) <= width
    # The stub repeats in every panel.
    assert set(figures(narrow)) == set(figures(render(table, "text")))
    assert len(figures(narrow)) >= len(figures(render(table, "text")))


def test_a_wide_terminal_changes_nothing() -> None:
    for name in layout_names():
        assert render(page(name), "text", width=200) == render(page(name), "text")


def test_panels_are_parted_between_spanners() -> None:
    narrow = render(page("verfahren"), "text", width=80)
    assert narrow.count("Kolbengeschwindigkeit") == narrow.count("Kolbenbeschleunigung") == 1
    assert narrow.count("φ in °") == 2


def test_units_are_repeated_in_every_panel_that_has_room_for_them() -> None:
    for width, panels in ((44, 2), (36, 3)):
        narrow = render(page("delta-detail"), "text", width=width)
        # Two rules about each panel.
        assert narrow.count("━\n") == 2 * panels
        assert narrow.count("Q r/(m₁ v₁²)\n") == 2 * panels
        assert narrow.count("P r/(m₁ v₁²)\n") == panels
    # Without room they follow in a panel of their own.
    narrow = render(page("delta-detail"), "text", width=26)
    assert narrow.count("━\n") == 2 * 3
    assert narrow.count("Q r/(m₁ v₁²)\n") == 2


def test_a_page_that_fits_nowhere_is_printed_as_it_is() -> None:
    def ruled(text: str) -> str:
        return text[text.index("━") : text.rindex("━")]

    # Words are wrapped all the same.
    narrow = render(page("kinematics"), "text", width=10)
    assert ruled(narrow) == ruled(render(page("kinematics"), "text"))
    assert "Kolbenweg,\n" in narrow
