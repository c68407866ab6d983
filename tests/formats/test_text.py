"""Plain text: what belongs together shows in gaps and pauses, stands side by side, is told by colours."""

from __future__ import annotations

import re
from itertools import pairwise

import pytest

from kurbel import collation_table, example_table, solve_table, table
from kurbel.formats.render import render
from kurbel.page.layouts import LANGUAGES
from kurbel.page.table import Table

CODE = re.compile("\x1b\\[[0-9;]*m")
HALVES = {"de": ["Hingang", "Rückgang"], "en": ["Outstroke", "Return"]}
# What a light rule and a heavy one are made of.
RULES = {"─", "━"}


def lines(page: Table, width: int | None = None) -> list[str]:
    return render(page, "text", width=width).splitlines()


def figures_at(line: str) -> list[tuple[int, int]]:
    """Return where the words of a line begin and end."""
    return [match.span() for match in re.finditer(r"\S+", line)]


def body(text: list[str]) -> list[str]:
    """Return the lines between the rule below the head and the one at the end."""
    rules = [place for place, line in enumerate(text) if line and set(line) <= RULES]
    return text[rules[1] + 1 : rules[2]]


@pytest.mark.parametrize("lang", LANGUAGES)
def test_pairs_stand_together_and_apart_from_the_next_pair(lang: str) -> None:
    text = lines(table(lang=lang))
    (under,) = (line for line in text if "─ " in line)
    pairs = [match.span() for match in re.finditer("─+", under)]
    assert len(pairs) == 3
    assert [after[0] - before[1] for before, after in pairwise(pairs)] == [4, 4]
    (heading,) = (line for line in text if line.split()[-6:] == HALVES[lang] * 3)
    stub, *halves = figures_at(heading.replace(" in ", "_in_"))
    gaps = [after[0] - before[1] for before, after in zip(halves[::2], halves[1::2], strict=True)]
    assert min(gaps) == 2
    assert pairs[0][0] - stub[1] == 4
    # The symbol of a pair stands once, above both.
    assert sum(line.count("x/R") for line in text[:9]) == 1


def test_a_pause_stands_before_every_30_degrees() -> None:
    text = body(lines(table()))
    after = [int(text[place + 1].split()[0]) for place, line in enumerate(text) if not line]
    assert after == [30, 60, 90, 120, 150, 180]
    assert "" not in body(lines(table(angle="0;30;60")))


def test_all_six_columns_stand_side_by_side_in_80_columns() -> None:
    text = lines(table(), width=80)
    assert max(map(len, text)) <= 80
    assert {len(line.split()) for line in body(text) if line} == {7}


def test_the_label_of_a_group_stands_at_the_left_of_its_rows() -> None:
    text = body(lines(table(ratio="1:4;1:5", angle="0;90")))
    labels = [place for place, line in enumerate(text) if line.startswith(" R:L = 1:")]
    assert labels == [0, 4]
    assert (text[3], len(text)) == ("", 7)


@pytest.mark.parametrize(("columns", "width"), [("phi,x", None), ("phi,x,c,p,psi", None), ("phi,x,c,p", 70)])
def test_captions_are_balanced_and_no_wider_than_the_table(columns: str, width: int | None) -> None:
    text = lines(table(columns=columns), width)
    caption = text[: text.index("")]
    rule = max(len(line) for line in text if line and set(line) <= RULES)
    assert max(map(len, caption)) <= min(max(rule, 30), 0.85 * (width or 100))
    # The first word of a line had no room in the line above it, were that no longer than the longest line.
    longest = max(map(len, caption))
    assert all(len(line) + len(after.split()[0]) + 1 > longest for line, after in pairwise(caption))
    assert len(caption) > 1


@pytest.mark.parametrize("lang", LANGUAGES)
@pytest.mark.parametrize("width", [60, 80, 100, 120])
def test_printed_recomputed_and_difference_stand_side_by_side(width: int, lang: str) -> None:
    page = collation_table("blau-33", lang=lang)
    text = lines(page, width)
    assert max(map(len, text)) <= width
    printed, recomputed, difference = (
        ("gedruckt", "berechnet", "Unterschied") if lang == "de" else ("printed", "recomputed", "difference")
    )
    head = text[next(place for place, line in enumerate(text) if line and set(line) == {"─"}) - 1]
    assert printed in head.split()
    assert recomputed in head.split()
    assert difference in head.split()
    (angle,) = (line for line in text if "79°20′" in line)
    assert angle.index("79°16′") > angle.index("79°20′")
    assert re.search(r"79°16′ +4\b", angle)
    # Nothing that is found is lost, wherever it stands.
    said = " ".join(" ".join(text).split())
    assert ("eine Ziffer: 4 für 2" if lang == "de" else "one digit: 4 for 2") in said


@pytest.mark.parametrize("lang", LANGUAGES)
def test_a_collation_is_one_table_on_a_narrow_terminal(lang: str) -> None:
    text = lines(collation_table("weisbach-150", lang=lang), 60)
    assert max(map(len, text)) <= 60
    assert len([line for line in text if set(line) == {"━"}]) == 2


def test_long_formulas_go_on_in_further_lines_of_their_column() -> None:
    page = collation_table("blau-equations")

    def printed(width: int | None) -> str:
        text = lines(page, width)
        assert len([line for line in text if line and set(line) == {"━"}]) == 2
        (head,) = (line for line in text if "gedruckt" in line)
        column = slice(head.index("gedruckt"), head.index("Befund"))
        return re.sub(r"\s", "", "".join(line[column] for line in body(text)))

    # In 52 characters some go on within brackets.
    assert printed(None) == printed(60) == printed(52)
    assert "⁾" not in printed(60)


def test_long_texts_become_notes_where_they_have_no_room() -> None:
    text = lines(collation_table("blau-33"), 60)
    (row,) = (line for line in text if "79°20′" in line)
    mark = row.split()[-1]
    assert any(line.startswith(f" {mark} richtig auf gröbere Stelle: 10′") for line in text)
    assert sum(line.endswith("richtig") for line in body(text)) == 15


def test_colours_name_verdicts_and_move_nothing() -> None:
    for name in ("blau-33", "roetscher-112"):
        page = collation_table(name)
        coloured = render(page, "text", width=60, colours=True)
        assert CODE.sub("", coloured) == render(page, "text", width=60)
        ends = [line.count("\x1b[0m") for line in coloured.splitlines()]
        assert [len(CODE.findall(line)) for line in coloured.splitlines()] == [2 * count for count in ends]
    verdicts = render(collation_table("blau-33"), "text", colours=True)
    told = dict(re.findall("\x1b\\[([0-9;]+)m(richtig|letzte|eine)\\b", verdicts))
    assert len(told) == 3
    assert "\x1b" not in render(solve_table("p=0"), "text", colours=True)


def test_names_of_rows_stand_above_them_where_they_have_no_room_beside() -> None:
    text = lines(example_table("blau", "33"), 60)
    assert max(map(len, text)) <= 60
    place = text.index(" cos² α + 5/4 cos α − 1/2 = 0")
    assert text[place + 1].split() == ["L/(2R)", "5/4", "5/2ᵃ⁾"]
