"""Constructions of one's own are drawn as kurbel's are; what is amiss in a file is said with its line."""

from __future__ import annotations

import math
import pickle
from pathlib import Path

import pytest
from cli import kurbel as run
from cli import printed

import kurbel
from kurbel.errors import ConstructionError

MINE = """\
title = "Dreieck|Triangle"
takes = ["point"]
points = \"\"\"
O = shaft
C = pin
D = near(share, 10)*C
F = (x(C), 0)
# Left of the shaft on the one half of the turn, right on the other.
G = (1 if x(C) > 0 else -1)*along
\"\"\"
lengths = [
    { ends = "C F", true = "abs(sine)" },
    { ends = "O D", true = "share" },
    { ends = "F G", true = "1 - abs(cosine)" },
]

[[steps]]
de = "Lot $C F$"
en = "Perpendicular $C F$"
draw = "line O C link; line C F; square F C O; measure CF -1"
points = "O C D F G"
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "mine.toml").write_text(MINE, encoding="utf-8")
    return tmp_path


def test_it_is_drawn_printed_and_listed_wherever_its_folder_is_named(folder: Path) -> None:
    words = ("construct", "mine", "--angle=130", "--point=0.3", "--columns=drawn,true,error")
    by_option = printed(*words, f"--constructions={folder}", "--table", "-f", "csv").out
    assert printed(*words, "--table", "-f", "csv", KURBEL_CONSTRUCTIONS=str(folder)).out == by_option
    rows = [line.split(",") for line in by_option.splitlines()[1:]]
    turn = math.radians(130)
    true = [math.sin(turn), 0.3, 1 + math.cos(turn)]
    assert [float(row[1]) for row in rows] == pytest.approx(true, abs=0.51e-5)
    assert [(row[1], row[3]) for row in rows] == [(row[2], "0") for row in rows]
    listed = printed("construct", f"--constructions={folder}").out.splitlines()
    assert "mine" in {line.split()[0] for line in listed} > {"klein"}
    drawing = kurbel.plot_construction("mine", constructions=folder, angle=130, lang="en")
    assert drawing.plain_title.startswith("Triangle for R:L = 1:5")
    assert 'id="length-CF"' in drawing.image().decode()
    page = kurbel.construct("mine", constructions=folder, angle=130)
    assert str(pickle.loads(pickle.dumps(page))) == str(page)


def test_one_of_the_name_of_kurbels_takes_its_place(folder: Path) -> None:
    (folder / "mine.toml").rename(folder / "klein.toml")
    words = ("construct", "klein", f"--constructions={folder}", "--lang=en")
    assert printed(*words).out.startswith(" Triangle for R:L")
    (folder / "mohr.toml").write_text(MINE, encoding="utf-8")
    assert printed("construct", "mohr", *words[2:]).out.startswith(" Triangle for R:L")


@pytest.mark.parametrize(
    ("old", "new", "line", "said"),
    [
        ("C = pin", "pin = shaft", 5, 'the point "pin" would hide what formulas know by this name'),
        ("C = pin", "O = pin", 5, 'the point "O" is there twice'),
        ("C = pin", "C+ = pin", 5, '"C+" cannot be the name of a point'),
        ("C = pin", "C: pin", 3, '"C: pin" is no point; write it as M = O + 1/2*(P - O)'),
        ("F = (x(C), 0)", "F = x(C)", 7, '"x(C)" is a number, and must be a point'),
        ("F = (x(C), 0)", "F = (x(Q), 0)", 7, 'there is no point or number "Q"'),
        ("F = (x(C), 0)", "F = pivot", 7, 'there is no point or number "pivot"'),
        ("F = (x(C), 0)", "F = C*C", 7, "has a point and a point where they cannot be combined"),
        ("F = (x(C), 0)", "F = max(1, 2)*C", 7, "has max or min, which floats alone tell"),
        ("F = (x(C), 0)", "F = open(C)", 7, 'there is no function "open"'),
        ("F = (x(C), 0)", "F = C.x*C", 7, "has what no formula may"),
        ("F = (x(C), 0)", "F = meet(C, O)", 7, "write meet(point, point, point, point)"),
        ("F = (x(C), 0)", f"F = C{' + C' * 220}", 7, "has 881 characters; at most 500 are read"),
        ('"C F", true', '"C H", true', 12, 'there is no point "H"'),
        ('"abs(sine)"', '"C"', 12, '"C" is a point, and must be a number'),
        ('"abs(sine)"', '"sine", unit = "$v$"', 12, 'the unit "$v$" has no scale; write it into scales'),
        ("line C F;", "lin C F;", 20, 'there is no element "lin" (did you mean line?)'),
        ("line C F;", "line C;", 20, '"line C" has 1 names; line takes 2'),
        ("line C F;", "line C F turning;", 20, "has a sense, which line does not take"),
        ("measure CF", "measure AB", 20, 'there is no length "AB"'),
        ("$C F$", "$C F", 18, "a formula needs a second $"),
        ('takes = ["point"]', 'takes = ["points"]', 2, 'there is no option of constructions "points"'),
        ('takes = ["point"]', 'holds = ["bent"]', 2, 'there is no mechanism "bent"'),
        ('takes = ["point"]', 'like = "others"', 2, "there is no such file"),
        ('takes = ["point"]', "like = 3", 2, "like is 3; it must be a text in quotation marks"),
        ('takes = ["point"]', 'of = "arc"', 2, 'of is "arc"; it must be a table'),
        ('takes = ["point"]', 'of.arc = "x"', 2, 'of.arc is "x"; it must be a table'),
        ('takes = ["point"]', 'of.ark.angle = "5"', 2, 'there is no mechanism "ark" (did you mean arc?)'),
        ('takes = ["point"]', "letters.pin = 5", 2, "letters.pin is 5; it must be a text"),
    ],
)  # fmt: skip
def test_what_is_amiss_is_said_with_its_line(folder: Path, old: str, new: str, line: int, said: str) -> None:
    file = folder / "mine.toml"
    file.write_text(MINE.replace(old, new, 1), encoding="utf-8")
    result = run("construct", "mine", f"--constructions={folder}", "--table")
    assert result.code == 1
    assert f"{file}, line {line}: " in result.err
    assert said in result.err
    assert len(result.err.splitlines()) == 1


def test_points_that_are_not_there_and_deep_formulas_are_sentences(folder: Path) -> None:
    file = folder / "mine.toml"
    file.write_text(MINE.replace("(x(C), 0)", "1/sine*C"), encoding="utf-8")
    printed("construct", "mine", f"--constructions={folder}", "--angle=1")
    for output in ("--table", f"--output={folder}/a.svg"):
        result = run("construct", "mine", f"--constructions={folder}", "--angle=0", output)
        assert "construction mine has no F here: its formula divides by zero" in result.err
    chain = "\n".join(f"Q_{at} = Q_{at - 1} + C" for at in range(1, 90))
    file.write_text(MINE.replace("D =", f"Q_0 = C\n{chain}\nD ="), encoding="utf-8")
    assert "deep; at most 200 are computed" in run("construct", "mine", f"--constructions={folder}").err


def test_a_folder_without_constructions_is_a_sentence(tmp_path: Path) -> None:
    for folder, said in ((tmp_path, "has no constructions"), (tmp_path / "none", "there is no such folder")):
        with pytest.raises(ConstructionError, match=said):
            kurbel.construct("mine", constructions=folder)
    (tmp_path / "my own.toml").write_text(MINE, encoding="utf-8")
    assert "use letters, digits and -" in run("construct", f"--constructions={tmp_path}").err
