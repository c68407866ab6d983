"""Files of problems: what a handbook prints of them, in either language, for one variant or another."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from cli import kurbel
from places import ROOT

from kurbel.errors import HandbookError
from kurbel.handbook.inputs import glance_at
from kurbel.handbook.manifest import Part, read_manifest

PROBLEM = """
letter = "F"
[[problem]]
name = "heavy"
run = "table --stroke '{stroke}' --rod 2m --angle {angle}"
text = { de = "Hub {stroke}.", en = "Stroke {stroke}." }
checked = { de = "Bei {angle}°.", en = "At {angle}°." }
values = { stroke = ["0.5 m", "0.75 m3"], angle = "20" }
"""


def parts(folder: Path, problem: str = PROBLEM, **keys: object) -> tuple[Part, ...]:
    """Return the parts of a handbook that has this problem."""
    (folder / "own.toml").write_text(problem, encoding="utf-8")
    more = "".join(f"{key} = {value!r}\n" for key, value in keys.items())
    text = (
        f'title = "T"\nlang = "en"\n[[chapter]]\ntitle = "C"\n[[chapter.part]]\nproblems = "own.toml"\n{more}'
    )
    (folder / "handbook.toml").write_text(text, encoding="utf-8")
    return tuple(read_manifest(str(folder / "handbook.toml")).parts())


def test_a_problem_is_its_text_its_command_and_its_page(tmp_path: Path) -> None:
    posed, solved, page = parts(tmp_path)
    assert posed.text == "**Problem F1.** Stroke 0.5\N{NO-BREAK SPACE}m.\n"
    command = "kurbel table --stroke '0.5 m' --rod 2m --angle 20"
    assert solved.text == f"**Solution F1.** `{command}`\n\nChecked: At 20°.\n"
    assert (page.name, page.shown) == ("heavy", command)


def test_a_variant_has_its_own_numbers_and_a_language_its_own_words(tmp_path: Path) -> None:
    posed, page = (parts(tmp_path, variant=2, lang="de", name="b")[index] for index in (0, 2))
    assert posed.text == "**Aufgabe F1.** Hub 0,75\N{NO-BREAK SPACE}m³.\n"
    assert (page.name, page.words[2], page.options["lang"]) == ("b-heavy", "0.75 m3", "de")


def test_a_problem_may_have_the_language_of_its_handbook_alone(tmp_path: Path) -> None:
    german = PROBLEM.replace(', en = "Stroke {stroke}."', "").replace(', en = "At {angle}°."', "")
    assert parts(tmp_path, german, lang="de")[0].text.startswith("**Aufgabe F1.** Hub")


def test_problems_or_solutions_stand_alone(tmp_path: Path) -> None:
    assert [part.text[:9] for part in parts(tmp_path, shows="problems")] == ["**Problem"]
    assert [part.text[:10] for part in parts(tmp_path, shows="solutions")] == ["**Solution", ""]


@pytest.mark.parametrize(
    ("old", "new", "keys", "said"),
    [
        ("--angle {angle}", "--angle {angel}", {}, "line 5: there is no value {angel}; [problem.values] has"),
        ("", "", {"variant": 3}, "line 8: stroke has values for 2 variants, and 3 is asked for"),
        ('"20"', "20", {}, "angle is 20; it must be a text, or a list of texts"),
        ("rod 2m", "rod '2m", {}, "line 5: run has a quotation mark without its partner"),
        ("[[problem]]", "[problem]", {}, "problem is a table; write [[problem]]"),
        ('name = "heavy"\n', "", {}, "line 3: there is no name"),
        ('en = "Stroke {stroke}."', 'en = " "', {}, 'line 6: text has nothing in en; write en = "..."'),
        ("text = {", "text = 1 #", {}, "text is 1; it must be a section with de and en"),
        (PROBLEM, 'letter = "F"', {}, "the file has no problem"),
        ("", "", {"caption": "x"}, "caption is for a table or a figure by itself"),
        ("", "", {"shows": "all"}, "choose from both, problems, solutions"),
    ],
)
def test_what_is_amiss_is_said_with_its_line(
    tmp_path: Path, old: str, new: str, keys: dict[str, object], said: str
) -> None:
    with pytest.raises(HandbookError, match=re.escape(said)):
        parts(tmp_path, PROBLEM.replace(old, new) if old else PROBLEM, **keys)


def test_a_watcher_sees_the_problems_and_what_is_amiss_in_them(tmp_path: Path) -> None:
    parts(tmp_path)
    assert str(tmp_path / "own.toml") in glance_at(str(tmp_path))
    (tmp_path / "own.toml").write_text("letter =", encoding="utf-8")
    assert str(tmp_path / "own.toml") in glance_at(str(tmp_path))


def test_the_sheet_of_the_guide_builds(tmp_path: Path) -> None:
    guide = (ROOT / "docs" / "subjects" / "teaching.md").read_text(encoding="utf-8")
    for text in re.findall(r"```toml\n(.*?)```", guide, re.DOTALL):
        (tmp_path / text.split()[1]).write_text(text.replace('"pdf", "html"', '"text"'), encoding="utf-8")
    done = kurbel("handbook", "build", str(tmp_path), "--jobs", "1")
    assert (done.code, done.out) == (0, "")
    sheet = (tmp_path / "pages" / "handbook.txt").read_text(encoding="utf-8")
    assert "Problem K1. The plunger of a pump has a stroke of 260" in sheet
    assert "Solution" not in sheet
