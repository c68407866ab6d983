"""Files of problems: what a handbook prints of them, in either language, for one variant or another."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from manifests import built, handbook, write
from places import ROOT

PROBLEM = """
letter = "F"
[[problem]]
name = "heavy"
run = "table --stroke '{stroke}' --rod 2m --angle {angle}"
text = { de = "Hub {stroke}.", en = "Stroke {stroke}." }
checked = { de = "Bei {angle}°.", en = "At {angle}°." }
values = { stroke = ["0.5 m", "0.75 m3"], angle = "20" }
"""


def manifest(**keys: object) -> str:
    more = "".join(f"{key} = {value!r}\n" for key, value in keys.items())
    top = 'title = "T"\nlang = "en"\nformats = ["markdown", "csv"]\n[[chapter]]\ntitle = "C"\n'
    return f'{top}[[chapter.part]]\nproblems = "own.toml"\n{more}'


def page(folder: Path, problem: str = PROBLEM, **keys: object) -> str:
    """Return the page of a handbook that has this problem, without its tables."""
    pages = built(folder, manifest(**keys), {"own.toml": problem})
    text = (pages / "markdown/01-c.md").read_text(encoding="utf-8")
    return "\n".join(line for line in text.splitlines() if not line.startswith("|"))


def test_a_problem_is_its_text_its_command_and_its_page(tmp_path: Path) -> None:
    text = page(tmp_path)
    assert "<strong>Problem F1.</strong> Stroke 0.5\N{NO-BREAK SPACE}m.\n" in text
    command = "kurbel table --stroke '0.5 m' --rod 2m --angle 20"
    assert f"<strong>Solution F1.</strong> `{command}`\n\nChecked: At 20°.\n" in text
    # R = 0.25 m, R:L = 1:8.
    assert (tmp_path / "pages/tables/heavy.csv").exists()
    assert "1:8" in text


def test_a_variant_has_its_own_numbers_and_a_language_its_own_words(tmp_path: Path) -> None:
    text = page(tmp_path / "a", variant=2, lang="de", shows="problems")
    assert "<strong>Aufgabe F1.</strong> Hub 0,75\N{NO-BREAK SPACE}m³.\n" in text
    page(tmp_path / "b", PROBLEM.replace("m3", "m"), variant=2, name="b")
    # R = 0.375 m, L = 2 m.
    assert (tmp_path / "b/pages/tables/b-heavy.csv").read_text().splitlines()[1].startswith("3:16,20,")


def test_problems_or_solutions_stand_alone_in_the_one_language_that_they_have(tmp_path: Path) -> None:
    german = PROBLEM.replace(', en = "Stroke {stroke}."', "").replace(', en = "At {angle}°."', "")
    posed = page(tmp_path / "a", german, lang="de", shows="problems")
    assert ("<strong>Aufgabe F1.</strong> Hub" in posed, "Lösung" in posed) == (True, False)
    solved = page(tmp_path / "b", shows="solutions")
    assert ("<strong>Problem" in solved, "<strong>Solution" in solved) == (False, True)


def test_each_save_of_a_file_of_problems_is_built_also_after_a_mistake(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    own = write(tmp_path, manifest(), {"own.toml": PROBLEM}) / "own.toml"
    saves = iter([PROBLEM.replace('"20"', '"40"'), "[[problem]", PROBLEM.replace('"20"', '"60"'), ""])
    shown = []

    def saved(_: float) -> None:
        page = tmp_path / "pages/tables/heavy.csv"
        shown.append(page.read_text(encoding="utf-8").splitlines()[1].split(",")[1])
        if not (text := next(saves)):
            raise KeyboardInterrupt
        own.write_text(text, encoding="utf-8")

    monkeypatch.setattr("kurbel.cli.handbook.time.sleep", saved)
    result = handbook("watch", tmp_path)
    assert (result.code, shown) == (130, ["20", "40", "40", "60"])
    assert "own.toml" in result.err and "(at line 1, column 10)" in result.err


def test_the_sheet_of_the_guide_builds(tmp_path: Path) -> None:
    guide = (ROOT / "docs" / "subjects" / "teaching.md").read_text(encoding="utf-8")
    for text in re.findall(r"```toml\n(.*?)```", guide, re.DOTALL):
        (tmp_path / text.split()[1]).write_text(text.replace('"pdf", "html"', '"text"'), encoding="utf-8")
    done = handbook("build", tmp_path)
    assert (done.code, done.out) == (0, "")
    sheet = (tmp_path / "pages" / "handbook.txt").read_text(encoding="utf-8")
    assert "Problem K1. The plunger of a pump has a stroke of 260" in sheet
    assert "Solution" not in sheet
