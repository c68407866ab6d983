"""The pages for developers: their steps, done in a copy of the house, give what they say.

A page states its steps in blocks: ```python append=FILE, ```python before="TEXT" in=FILE, ```python
replace="TEXT" in=FILE, ```toml new=FILE, and what is typed then in ```console. KURBEL_PROMOTE=1 writes anew
what the commands print.
"""

from __future__ import annotations

import ast
import math
import os
import re
import shlex
import shutil
import subprocess
import sys
import textwrap
import tomllib
from fractions import Fraction
from pathlib import Path

import pytest
from mpmath import mp
from places import ROOT

PAGES = ROOT / "docs" / "developers"
BLOCK = re.compile(r"^( *)```(\w+)(?: ([^\n]*))?\n(.*?)^ *```$", re.DOTALL | re.MULTILINE)
COMMAND = re.compile(r"^\$ (.+)\n", re.MULTILINE)
HANDBOOK = 'title = "Tafel"\nlang = "de"\n[[chapter]]\ntitle = "Neu"\n[[chapter.part]]\nrun = "{run}"\n'


class House:
    """A copy of what is installed and of what makes the reference."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        for part in ("src", "templates", "docs"):
            shutil.copytree(ROOT / part, folder / part, ignore=shutil.ignore_patterns("__pycache__"))
        self.desk = folder / "desk"
        self.desk.mkdir()

    def do(self, step: str, text: str) -> None:
        """Do what a block says."""
        said = dict(one.split("=", 1) for one in shlex.split(step))
        path = self.folder / (said.get("new") or said.get("append") or said["in"])
        if "new" in said:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
            return
        own = path.read_text(encoding="utf-8")
        if "append" in said:
            path.write_text(f"{own}\n\n{text}", encoding="utf-8")
            return
        place = said.get("before") or said["replace"]
        assert own.count(place) == 1, f"{path.name} has {own.count(place)} places {place!r}"
        text = f"{text}\n\n{place}" if "before" in said else text.rstrip("\n")
        path.write_text(own.replace(place, text), encoding="utf-8")

    def run(self, *words: str) -> str:
        # Compiled once, the copy is read as fast as what is installed.
        left_out = ("KURBEL", "DONTWRITEBYTECODE")
        environment = {
            name: text for name, text in os.environ.items() if not any(one in name for one in left_out)
        }
        done = subprocess.run(
            [sys.executable, *words],
            cwd=self.desk,
            env=environment | {"PYTHONPATH": str(self.folder / "src")},
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stderr
        return done.stdout + done.stderr

    def kurbel(self, command: str) -> str:
        program, *words = shlex.split(command)
        assert program == "kurbel"
        return self.run("-m", "kurbel", *words)

    def reference(self) -> str:
        return self.run(str(self.folder / "docs" / "generate" / "reference.py"))

    def handbook(self, run: str) -> str:
        """Build a handbook with one part and return its HTML page."""
        (self.desk / "handbook.toml").write_text(HANDBOOK.format(run=run), encoding="utf-8")
        self.kurbel("kurbel handbook build .")
        return (self.desk / "pages" / "handbook.html").read_text(encoding="utf-8")


def built(name: str, folder: Path, typed: bool = True) -> House:
    """Return the house after the steps of a page; what is typed there must print what stands there."""
    house, page = House(folder), PAGES / f"{name}.md"
    text = page.read_text(encoding="utf-8")
    for indent, kind, step, block in BLOCK.findall(text):
        block = textwrap.dedent(block)
        if step:
            house.do(step, block)
        elif kind == "console" and typed:
            shown = "".join(f"$ {command}\n{house.kurbel(command)}" for command in COMMAND.findall(block))
            if os.environ.get("KURBEL_PROMOTE") == "1":
                page.write_text(
                    page.read_text(encoding="utf-8").replace(
                        textwrap.indent(block, indent), textwrap.indent(shown, indent)
                    ),
                    encoding="utf-8",
                )
            else:
                assert block == shown
    return house


@pytest.fixture(scope="module")
def jerk(tmp_path_factory: pytest.TempPathFactory) -> House:
    return built("quantity", tmp_path_factory.mktemp("quantity"))


@pytest.mark.parametrize("stroke", [0, 1])
def test_the_jerk_is_the_slope_of_the_acceleration(jerk: House, stroke: int) -> None:
    ratio, columns = Fraction(3, 7), ("jerk", "jerk_return")
    printed = jerk.kurbel(f"kurbel table --ratio 3:7 --angle 25;115;155 --columns {','.join(columns)} -f csv")
    with mp.workdps(40):
        for line in printed.splitlines()[1:]:
            angle, *row = map(mp.mpf, line.split(","))
            turned = mp.radians(angle + 180 * stroke)
            slope = mp.diff(lambda phi: _path(phi, mp.mpf(ratio.numerator) / ratio.denominator), turned, 3)
            assert abs(row[stroke] - slope * (-1) ** stroke) <= mp.mpf("0.00005")


def _path(phi: object, ratio: object) -> object:
    """The piston path in units of R, by Rötscher's eq. (285)."""
    return 1 - mp.cos(phi) + (1 - mp.sqrt(1 - (ratio * mp.sin(phi)) ** 2)) / ratio


def test_a_new_quantity_is_in_reference_handbook_drawing_and_list(jerk: House) -> None:
    assert "| `jerk` | Piston jerk, Outstroke | v³/R² | 4 |" in jerk.reference()
    assert "Kolbenruck" in jerk.handbook("table --ratio 1:5 --columns phi,jerk")
    assert "<svg" in (jerk.desk / "jerk.svg").read_text(encoding="utf-8")
    assert re.search(
        r"^jerk_return +Kolbenruck, Rückgang +v³/R² +table", jerk.kurbel("kurbel quantities"), re.M
    )


def test_a_new_quantity_without_a_formula_is_refused_with_a_sentence(jerk: House) -> None:
    with pytest.raises(AssertionError, match="jerk has no formula for an offset crank; leave the offset out"):
        jerk.kurbel("kurbel table --ratio 1:5 --offset 0.3 --columns phi,jerk")
    with pytest.raises(AssertionError, match='method "series" has no formula for jerk; use exact'):
        jerk.kurbel("kurbel table --ratio 1:5 --method series --columns phi,jerk")


def test_a_new_book_is_listed_collated_and_in_a_handbook(tmp_path: Path) -> None:
    house = built("source", tmp_path)
    assert "lehrheft-wege" in house.kurbel("kurbel sources --lang en")
    page = house.handbook("collate lehrheft-wege")
    assert "1,879" in page
    assert "Zahlendreher" in page or "vertauscht" in page


def test_the_page_of_the_house_has_every_floor_in_its_order_with_its_sentence() -> None:
    text = (PAGES / "README.md").read_text(encoding="utf-8")
    rules = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"]
    package = ROOT / "src" / "kurbel"
    floors = [name for name in rules["contracts"][0]["layers"] if (package / name).is_dir()]
    rows = []
    for name in floors:
        tree = ast.parse((package / name / "__init__.py").read_text(encoding="utf-8"))
        rows.append((name, (ast.get_docstring(tree) or "").splitlines()[0]))
    assert re.findall(r"^\| `(\w+)/` \| (.*) \|$", text, re.MULTILINE) == rows
    assert {path.name for path in package.iterdir() if path.is_dir()} - {"__pycache__"} == set(floors)


def test_a_newcomer_reads_the_house_from_its_folders() -> None:
    package = ROOT / "src" / "kurbel"
    names = [path.name for path in package.iterdir() if path.name != "__pycache__"]
    assert len(names) <= 22, names
    crowded = {path.name: len([*path.glob("*.py")]) - 1 for path in package.iterdir() if path.is_dir()}
    del crowded["cli"]
    assert max(crowded.values()) <= 16, crowded


def test_a_new_format_is_a_folder(tmp_path: Path) -> None:
    house = built("format", tmp_path)
    assert "|0,9083" in (house.desk / "solve.adoc").read_text(encoding="utf-8")
    assert "asciidoc" in house.reference()
    (house.desk / "handbook.toml").write_text(
        'formats = ["asciidoc"]\n' + HANDBOOK.format(run="table --ratio 1:5"), encoding="utf-8"
    )
    said = house.kurbel("kurbel handbook build .")
    assert "written" in said, said
    (page,) = (house.desk / "pages").rglob("*.adoc")
    assert ".Kolbenweg" in page.read_text(encoding="utf-8")


def test_a_new_layout_is_a_folder(tmp_path: Path) -> None:
    house = built("layout", tmp_path)
    assert "| `hubwege` | Piston paths in strokes, ratios side by side |" in house.reference()
    assert re.search(
        r"^hubwege +Kolbenwege in Teilen des Hubes", house.kurbel("kurbel layouts"), re.MULTILINE
    )
    assert "in Teilen des Hubes" in house.handbook("table --layout hubwege")


@pytest.fixture(scope="module")
def yoke(tmp_path_factory: pytest.TempPathFactory) -> House:
    return built("mechanism", tmp_path_factory.mktemp("mechanism"))


def test_a_new_mechanism_is_one_package_and_a_line(yoke: House) -> None:
    assert len([*(yoke.folder / "src" / "kurbel" / "linkage" / "yoke").glob("*.py")]) <= 8
    shown = yoke.kurbel("kurbel table --help")
    assert "beam (a beam engine) or yoke (a pin in a slot)" in " ".join(shown.split())
    page = yoke.kurbel("kurbel table --mechanism yoke --angle 25;115;205 --columns path,velocity -f csv")
    with mp.workdps(40):
        for row in page.splitlines()[1:]:
            angle, *found = map(mp.mpf, row.split(","))
            way = [mp.diff(lambda phi: 1 - mp.cos(phi), mp.radians(angle), order) for order in (0, 1)]
            for value, true in zip(found, way, strict=True):
                assert abs(value - true) <= mp.mpf("0.00005")


def test_the_force_on_the_pin_of_a_new_mechanism_does_the_work(yoke: House) -> None:
    """F times the way of the yoke is the torque times the angle: 10 kN over 600 mm of a stroke."""
    words = "--force 10kN --stroke 600mm --from 0 --to 180 --step 0.5 --columns torque_nm --digits 6"
    rows = yoke.kurbel(f"kurbel forces --mechanism yoke {words} -f csv").splitlines()[1:]
    torques = [float(row.split(",")[1]) for row in rows]
    # Simpson's rule, whose error is some 1e-9 of the whole here.
    weights = [1, *([4, 2] * len(torques))[: len(torques) - 2], 1]
    work = (
        math.fsum(weight * one for weight, one in zip(weights, torques, strict=True)) * math.radians(0.5) / 3
    )
    assert work == pytest.approx(10_000 * 0.6, rel=1e-7)


def test_a_new_mechanism_is_in_reference_handbook_drawings_and_lists(yoke: House) -> None:
    reference = yoke.reference()
    assert (
        "`tangential_force_n` | Tangential force: T as the crank turns | N | 1"
        " | `forces --mechanism yoke --force` |"
    ) in reference
    assert "- Scotch yoke: `path`, `s`, `velocity`, `acceleration`" in reference
    page = yoke.handbook("table --mechanism yoke")
    assert "Weg, Geschwindigkeit und Beschleunigung der Schleife einer Kreuzschubkurbel" in page
    for name in ("motion", "yoke", "forces"):
        assert "<svg" in (yoke.desk / f"{name}.svg").read_text(encoding="utf-8")
    assert 'id="slot"' in (yoke.desk / "yoke.svg").read_text(encoding="utf-8")
    assert re.search(r"^yoke +Kreuzschubkurbel", yoke.kurbel("kurbel layouts"), re.M)
    assert re.search(
        r"^velocity +Geschwindigkeit +v +table --mechanism yoke", yoke.kurbel("kurbel quantities"), re.M
    )


def test_what_a_new_mechanism_does_not_have_is_refused_with_a_sentence(yoke: House) -> None:
    with pytest.raises(AssertionError, match="--ratio does not belong to the Scotch yoke"):
        yoke.kurbel("kurbel table --mechanism yoke --ratio 1:5")
    with pytest.raises(AssertionError, match="the Scotch yoke under steam is not computed"):
        yoke.kurbel("kurbel forces --mechanism yoke --eps 4")
    with pytest.raises(AssertionError, match="the polar diagram of the Scotch yoke is not drawn"):
        yoke.kurbel("kurbel plot --polar --mechanism yoke -o polar.svg")


@pytest.fixture(scope="module")
def double(tmp_path_factory: pytest.TempPathFactory) -> House:
    """The yoke with a stroke, a ratio and a letter of its own."""
    house = built("mechanism", tmp_path_factory.mktemp("double"), typed=False)
    changed = {
        "src/kurbel/linkage/yoke/quantities.py": {
            '"$x/R = 1 - cos φ$")': '"$x/R = 1 - cos φ$", ("$φ$ von innen",))',
        },
        "src/kurbel/linkage/yoke/yoke.py": {"    def outline(": '    stroke = "4 R"\n\n    def outline('},
        "src/kurbel/linkage/yoke/mechanism.py": {
            "quantities=yoke_registry,": "quantities=yoke_registry, ratios=True,",
            "def drives(": 'takes = ("ratio",)\n\n    def drives(',
            "return (Yoke(said.rodless),)": "return tuple(map(Yoke, said.cranks(ratios)))",
        },
        "templates/yoke/layout.toml": {
            'down = ["angle"]': 'ratios = ["1:5"]\ndown = ["ratio", "angle"]',
        },
    }
    for path, parts in changed.items():
        for old, new in parts.items():
            house.do(f"replace={shlex.quote(old)} in={path}", new)
    return house


def test_pages_of_a_new_mechanism_say_its_letters_and_its_ratio(double: House) -> None:
    page = double.kurbel("kurbel table --mechanism yoke --lang en --step 90 --columns phi,path,velocity")
    assert "x/R = 1 − cos φ, c/v = sin φ, p R/v² = cos φ, φ von innen" in page
    assert "Path and velocity of a Scotch yoke for R:L = 1:5" in " ".join(page.split())
    assert "1:3" in double.kurbel("kurbel table --mechanism yoke --ratio 1:3 --step 90 -f markdown")
    many = double.kurbel("kurbel table --mechanism yoke --ratio '1:3;1:4' --lang en --step 90 -f markdown")
    assert many.splitlines()[0] == "**Path, velocity and acceleration of a Scotch yoke**"
    assert many.count("R:L = 1:3") == many.count("R:L = 1:4") == 1


def test_pages_of_conditions_say_the_stroke_and_the_ratio_of_a_new_mechanism(double: House) -> None:
    words = "kurbel solve --mechanism yoke --where s=25% --lang en --ratio"
    one = " ".join(double.kurbel(f"{words} 1:3").split())
    assert "for R:L = 1:3, x/S = 25 %" in one
    assert "from the inner one; S = 4 R" in one
    double.kurbel("kurbel plot --mechanism yoke --ratio 1:3 --positions 50 --lang en -o double.svg")
    drawn = (double.desk / "double.svg").read_text(encoding="utf-8")
    assert "Scotch yoke for R:L = 1:3" in drawn, re.findall("<title.*?</title>", drawn)
    # Whatever the ratio is, p is cos φ.
    share = double.kurbel("kurbel solve --mechanism yoke --ratio 1:3 --where 'p = 1/2 of dead centre' -f csv")
    assert [line.split(",")[3] for line in share.splitlines()[1:]] == ["60.0000", "60.0000"]


@pytest.fixture(scope="module")
def spring(tmp_path_factory: pytest.TempPathFactory) -> House:
    return built("load", tmp_path_factory.mktemp("load"))


@pytest.mark.parametrize("drive", ["--ratio 1:5", "--ratio 1:4 --offset 0.5"])
def test_a_new_load_does_its_work_on_the_shaft(spring: House, drive: str) -> None:
    """Over a way s of the stroke F s - ½ (F - F₁) s²/S; from its dead centre on, by Simpson's rule."""
    work = true = 0.0
    rod, offset = (5, 0.0) if "offset" not in drive else (4, 0.5)
    outer, inner = (math.sqrt((rod + side) ** 2 - offset**2) for side in (1, -1))
    for key, stroke in (("torque_nm", 1), ("torque_return_nm", -1)):
        # Stretched rod and crank, folded rod and crank: φ of the stroke at its ends, in degrees.
        dead = [math.degrees(math.asin(offset / (rod + side))) for side in (stroke, -stroke)]
        # Columns of the return end at 180°, where an offset crank has some of it left.
        begin, end = dead[0], 180 + (dead[1] if stroke == 1 else 0)
        share = 1 if stroke == 1 else (1 + math.sqrt(rod**2 - offset**2) - inner) / (outer - inner)
        true += (10_000 - 3_000 * share) * share * (outer - inner) * 0.3
        angles = ";".join(f"{begin + (end - begin) * index / 200:.9f}" for index in range(201))
        page = spring.kurbel(
            f"kurbel forces {drive} --force 10kN..4kN --stroke 600mm --angle {angles!r}"
            f" --columns {key} --digits 9 -f csv"
        )
        torques = [float(row.split(",")[1]) for row in page.splitlines()[1:]]
        weights = [1, *([4, 2] * 100)[:199], 1]
        step = math.radians(end - begin) / 200
        work += math.fsum(map(math.prod, zip(weights, torques, strict=True))) * step / 3
    assert work == pytest.approx(true, rel=1e-6)


def test_long_tables_of_a_new_load_have_the_digits_of_short_ones(spring: House) -> None:
    words = "kurbel forces --ratio 1:5 --force 10kN..4kN --columns rod_force_n,radial_force_n -f csv"
    long, short = (spring.kurbel(f"{words} --step {step} --to 360").splitlines() for step in (0.01, 20))
    assert [row.split(",")[1:] for row in long[1::2000]] == [row.split(",")[1:] for row in short[1:]]


def test_a_new_load_is_in_reference_handbook_drawing_and_help(spring: House) -> None:
    assert "| a linear force | `10kN..4kN` | straight, offset |" in spring.reference()
    assert "linear über den Hub" in spring.handbook("forces --force 10kN..4kN")
    assert "<svg" in (spring.desk / "forces.svg").read_text(encoding="utf-8")
    assert "10kN, 10kN..4kN" in " ".join(spring.kurbel("kurbel forces --help").split())
    with pytest.raises(AssertionError, match="the arc crank under a linear force is not computed"):
        spring.kurbel("kurbel forces --mechanism arc --rocker 6 --force 10kN..4kN")
