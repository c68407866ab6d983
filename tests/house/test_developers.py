"""The pages for developers: their steps, done in one copy of the house, give what they say.

A page states its steps in blocks: ```python append=FILE, ```python before="TEXT" in=FILE, ```python
replace="TEXT" in=FILE, ```toml new=FILE, and what is typed then in ```console. KURBEL_PROMOTE=1 writes anew
what the commands print.
"""

from __future__ import annotations

import ast
import cmath
import json
import math
import os
import re
import shlex
import shutil
import subprocess
import sys
import textwrap
import tomllib
from collections.abc import Iterator
from itertools import zip_longest
from pathlib import Path

import pytest
from mpmath import mp
from places import ROOT, SUPPORT

from kurbel.books.constructions.file import SHAPES
from kurbel.books.constructions.formula_names import FUNCTIONS_OF_DRIVE, KNOWN
from kurbel.books.constructions.formulas import FUNCTIONS

DOCS = ROOT / "docs" / "developers"
PAGES = ("quantity", "source", "format", "layout", "mechanism", "load", "option", "construction")
BLOCK = re.compile(r"^( *)```(\w+)(?: ([^\n]*))?\n(.*?)^ *```$", re.DOTALL | re.MULTILINE)
COMMAND = re.compile(r"^\$ (.+)\n", re.MULTILINE)
# What is new stands in a handbook of these parts.
PARTS = (
    *("table --ratio 1:5 --columns phi,jerk", "collate lehrheft-wege", "table --layout hubwege"),
    *("table --mechanism cardan", "forces --force 10kN..4kN", "construct momentanpol"),
)
WORKER = """import json, sys
from cli import kurbel
for line in sys.stdin:
    result = kurbel(*json.loads(line))
    print(json.dumps([result.code, result.out, result.err]), flush=True)
"""
# Compiled once, the copy is read as fast as what is installed.
CLEAN = {name: text for name, text in os.environ.items() if "KURBEL" not in name and "DONTWRITE" not in name}


class House:
    """A copy of what is installed and of what makes the reference, with one process that runs commands."""

    def __init__(self, folder: Path, source: Path = ROOT) -> None:
        self.folder, self.desk = folder, folder / "desk"
        for part in ("src", "templates", "docs"):
            shutil.copytree(source / part, folder / part)
        self.desk.mkdir()
        self.environment = CLEAN | {"PYTHONPATH": os.pathsep.join([str(folder / "src"), str(SUPPORT)])}
        self._worker: subprocess.Popen[str] | None = None

    def do(self, step: str, text: str) -> None:
        """Do what a block says."""
        self.end()
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
        indent = own[: own.index(place)].rpartition("\n")[2]
        among = textwrap.indent(text, indent).lstrip() + (indent or "\n\n") + place
        text = among if "before" in said else text.rstrip("\n")
        path.write_text(own.replace(place, text), encoding="utf-8")

    def ran(self, command: str) -> tuple[int, str]:
        """Return the exit code and what is printed, on either stream."""
        if self._worker is None:
            self._worker = subprocess.Popen(
                [sys.executable, "-c", WORKER], cwd=self.desk, env=self.environment, text=True,
                stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            )  # fmt: skip
        assert self._worker.stdin and self._worker.stdout
        program, *words = shlex.split(command)
        assert program == "kurbel"
        print(json.dumps(words), file=self._worker.stdin, flush=True)
        code, out, err = json.loads(self._worker.stdout.readline())
        return code, out + err

    def kurbel(self, command: str) -> str:
        code, shown = self.ran(command)
        assert code == 0, shown
        return shown

    def records(self, command: str) -> list[list[str]]:
        return [line.split(",") for line in self.kurbel(f"{command} -f csv").splitlines()[1:]]

    def refusal(self, command: str) -> str:
        code, shown = self.ran(command)
        assert code, command
        return shown

    def end(self) -> None:
        if self._worker is not None:
            self._worker.communicate()
            self._worker = None


def stages(name: str) -> Iterator[list[tuple[str, str, str, str]]]:
    """Yield the blocks of a page up to each that is typed."""
    found: list[tuple[str, str, str, str]] = []
    for block in BLOCK.findall((DOCS / f"{name}.md").read_text(encoding="utf-8")):
        found.append(block)
        if block[1] == "console":
            yield found
            found = []
    yield found


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> Iterator[House]:
    """The house after the steps of all pages; what is typed there must print what stands there."""
    house = House(tmp_path_factory.mktemp("a house") / "copy")
    for stage in zip_longest(*map(stages, PAGES), fillvalue=[]):
        for _, _, step, text in (block for blocks in stage for block in blocks):
            if step:
                house.do(step, textwrap.dedent(text))
        for name, blocks in zip(PAGES, stage, strict=True):
            for indent, kind, _, text in blocks:
                if kind == "console":
                    typed(house, DOCS / f"{name}.md", indent, textwrap.dedent(text))
    yield house
    house.end()


def typed(house: House, page: Path, indent: str, block: str) -> None:
    shown = "".join(f"$ {command}\n{house.ran(command)[1]}" for command in COMMAND.findall(block))
    if os.environ.get("KURBEL_PROMOTE") == "1":
        old, new = (textwrap.indent(text, indent) for text in (block, shown))
        page.write_text(page.read_text(encoding="utf-8").replace(old, new), encoding="utf-8")
    else:
        assert block == shown


def test_the_jerk_is_the_slope_of_the_acceleration(house: House) -> None:
    def path(phi: object) -> object:
        """By Rötscher's eq. (285), of R:L = 3:7."""
        return 1 - mp.cos(phi) + (1 - mp.sqrt(1 - (3 * mp.sin(phi) / 7) ** 2)) / (mp.mpf(3) / 7)

    rows = house.records("kurbel table --ratio 3:7 --angle 25;115;155 --columns phi,jerk,jerk_return")
    with mp.workdps(40):
        for angle, *row in (map(mp.mpf, row) for row in rows):
            for sign, turned, value in zip((1, -1), (angle, angle + 180), row, strict=True):
                assert abs(value - sign * mp.diff(path, mp.radians(turned), 3)) <= mp.mpf("0.00005")


def test_a_new_option_counts_on_the_shaft(house: House) -> None:
    """Friction beside friction: both are taken from the force on the piston."""
    words = "--ratio 1:4 --stroke 600mm --force 10kN --angle 70 --columns phi,torque_nm --digits 6"
    bare, rubbed = (
        float(house.records(f"kurbel forces {words} {more}")[0][1])
        for more in ("", "--friction 300N --stuffing-box 200N")
    )
    assert rubbed / bare == pytest.approx(9_500 / 10_000, rel=1e-6)


def test_what_is_new_is_in_reference_handbook_drawings_lists_and_help(house: House) -> None:
    done = subprocess.run(
        [sys.executable, str(house.folder / "docs" / "generate" / "reference.py")],
        cwd=house.desk, env=house.environment, capture_output=True, text=True, check=True,
    )  # fmt: skip
    for line in (
        "| `jerk` | Piston jerk, Outstroke | v³/R² | 4 |",
        "asciidoc",
        "| `hubwege` | Piston paths in strokes, ratios side by side |",
        "`tangential_force_n` | Tangential force: T as the crank turns | N | 1"
        " | `forces --mechanism cardan --force` |",
        "- Cardan gear: `path`, `s`, `velocity`, `acceleration`",
        "| a linear force | `10kN..4kN` | straight, offset |",
    ):
        assert line in done.stdout
    parts = "".join(f'[[chapter.part]]\nrun = "{run}"\nname = "p{at}"\n' for at, run in enumerate(PARTS))
    manifest = 'title = "Tafel"\nlang = "de"\nformats = ["html", "asciidoc"]\n[[chapter]]\ntitle = "Neu"\n'
    (house.desk / "handbook.toml").write_text(manifest + parts, encoding="utf-8")
    house.kurbel("kurbel handbook build . --jobs 1")
    page = (house.desk / "pages" / "handbook.html").read_text(encoding="utf-8")
    for words in (
        *("Kolbenruck", "1,879", "in Teilen des Hubes", "linear über den Hub"),
        "Weg, Geschwindigkeit und Beschleunigung am Radkranz eines Kardangetriebes",
    ):
        assert words in page
    assert "Zahlendreher" in page or "vertauscht" in page
    assert any(
        ".Kolbenweg" in one.read_text(encoding="utf-8") for one in (house.desk / "pages").rglob("*.adoc")
    )
    for name in ("jerk", "motion", "cardan", "forces"):
        assert "<svg" in (house.desk / f"{name}.svg").read_text(encoding="utf-8")
    assert 'id="spoke"' in (house.desk / "cardan.svg").read_text(encoding="utf-8")
    assert "|0,9083" in (house.desk / "solve.adoc").read_text(encoding="utf-8")
    for command, line in (
        ("quantities", r"^jerk_return +Kolbenruck, Rückgang +v³/R² +table"),
        ("quantities", r"^velocity +Geschwindigkeit +v +table --mechanism cardan"),
        ("layouts", r"^hubwege +Kolbenwege in Teilen des Hubes"),
        ("layouts", r"^cardan +Kardangetriebe"),
        ("sources", r"^ *lehrheft-wege "),
        ("construct", r"^momentanpol +Momentanpol der Schubstange"),
        ("table --help", r"slotted\s+\(quick\s+return\)\s+or\s+cardan\s+\(a\s+wheel\s+in\s+a\s+ring\)"),
        ("forces --help", r"10kN,\s+10kN\.\.4kN"),
    ):
        assert re.search(line, house.kurbel(f"kurbel {command}"), re.MULTILINE), line


@pytest.mark.parametrize(
    ("command", "sentence"),
    [
        ("table --ratio 1:5 --offset 0.3 --columns phi,jerk",
         "jerk has no formula for an offset crank; leave the offset out"),
        ("table --ratio 1:5 --method series --columns phi,jerk",
         'method "series" has no formula for jerk; use exact'),
        ("table --mechanism cardan --ratio 1:5", "--ratio does not belong to the Cardan gear"),
        ("forces --mechanism cardan --eps 4", "the Cardan gear under steam is not computed"),
        ("forces --polar --mechanism cardan -o p.svg", "the polar diagram of the Cardan gear is not drawn"),
        ("forces --mechanism arc --rocker 6 --force 10kN..4kN",
         "the arc crank under a linear force is not computed"),
    ],
)  # fmt: skip
def test_what_is_new_and_has_no_formula_is_refused(house: House, command: str, sentence: str) -> None:
    assert sentence in house.refusal(f"kurbel {command}")


def test_the_page_of_the_house_has_every_floor_in_its_order_with_its_sentence() -> None:
    text = (DOCS / "README.md").read_text(encoding="utf-8")
    rules = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"]
    package = ROOT / "src" / "kurbel"
    floors = [name for name in rules["contracts"][0]["layers"] if (package / name).is_dir()]
    rows = []
    for name in floors:
        tree = ast.parse((package / name / "__init__.py").read_text(encoding="utf-8"))
        rows.append((name, (ast.get_docstring(tree) or "").splitlines()[0]))
    assert re.findall(r"^\| `(\w+)/` \| (.*) \|$", text, re.MULTILINE) == rows
    assert {path.name for path in package.iterdir() if path.is_dir()} - {"__pycache__"} == set(floors)


def test_pages_for_developers_name_files_that_there_are_and_what_stands_in_them() -> None:
    missing = []
    for page in DOCS.glob("*.md"):
        # What a page adds is not there yet, and a name in capitals stands for any.
        text = page.read_text(encoding="utf-8")
        new = set(re.findall(r"(?:new|append|in)=(?:src/kurbel/)?(\S+)", text))
        for name, path in re.findall(r"(?:`([\w.]+)`,? in\s+)?`([a-z_/]+/\w+\.(?:py|toml|jinja))`", text):
            file = next((one for one in (ROOT / "src" / "kurbel" / path, ROOT / path) if one.is_file()), None)
            known = file and name.rpartition(".")[2] in file.read_text(encoding="utf-8")
            if not known and path not in new and not Path(path).stem.isupper():
                missing.append((page.name, name, path))
    assert not missing


def test_the_motion_of_a_new_mechanism_is_that_of_its_pin(house: House) -> None:
    rows = house.records("kurbel table --mechanism cardan --angle 25;115;205 --columns phi,path,velocity")
    for angle, path, velocity in (map(float, row) for row in rows):
        phi = math.radians(angle)
        assert (path, velocity) == pytest.approx((2 - 2 * math.cos(phi), 2 * math.sin(phi)), abs=0.51e-4)


def test_the_rod_turns_about_the_centre_of_a_new_construction(house: House) -> None:
    """How far its ends are from there is as their velocities are, by differences of the end's position."""

    def end(turn: float) -> complex:
        """Of R:L = 1:4 and e = 0.2 R."""
        pin = cmath.rect(1, turn)
        return complex(pin.real + math.sqrt(16 - (pin.imag - 0.2) ** 2), 0.2)

    drive = "kurbel construct momentanpol --ratio 1:4 --offset 0.2 --digits 9"
    for angle in (25, 130, 250):
        turn = math.radians(angle)
        of_pin, of_end = (float(row[3]) for row in house.records(f"{drive} --angle {angle}"))
        slope = abs(end(turn + 1e-6) - end(turn - 1e-6)) / 2e-6
        assert of_end / of_pin == pytest.approx(slope, rel=1e-7)
        # Both lie on the crank and on the perpendicular to the slide.
        centre = cmath.rect(1 + of_pin, turn) if math.cos(turn) > 0 else cmath.rect(1 - of_pin, turn)
        assert abs(centre - end(turn)) == pytest.approx(of_end, rel=1e-7)
    rows = house.records("kurbel construct momentanpol --mechanism arc --rocker 4 --columns drawn,true,error")
    assert [row[-1] for row in rows] == ["0", "0"]
    assert "infinitely far away" in house.refusal("kurbel construct momentanpol --angle 90")


def test_the_page_of_constructions_has_every_name_that_formulas_know() -> None:
    text = (DOCS / "construction.md").read_text(encoding="utf-8")
    rows = "".join(line.split("|")[1] for line in text.splitlines() if line.startswith("| `"))
    assert {*KNOWN, *FUNCTIONS, *FUNCTIONS_OF_DRIVE, *SHAPES} <= set(re.findall(r"\w+", rows))


def simpson(values: list[float], step: float) -> float:
    weights = [1, *([4, 2] * len(values))[: len(values) - 2], 1]
    return math.fsum(map(math.prod, zip(weights, values, strict=True))) * step / 3


def test_the_force_on_the_pin_of_a_new_mechanism_does_the_work(house: House) -> None:
    """F times the way of the rim is the torque times the angle: 10 kN over 4 R, R half of 600 mm."""
    words = "--force 10kN --stroke 600mm --from 0 --to 180 --step 0.5 --columns phi,torque_nm --digits 6"
    torques = [float(row[1]) for row in house.records(f"kurbel forces --mechanism cardan {words}")]
    # Simpson's error is some 1e-9 of the whole here.
    assert simpson(torques, math.radians(0.5)) == pytest.approx(10_000 * 1.2, rel=1e-7)


@pytest.mark.parametrize("drive", ["--ratio 1:5", "--ratio 1:4 --offset 0.5"])
def test_a_new_load_does_its_work_on_the_shaft(house: House, drive: str) -> None:
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
        rows = house.records(
            f"kurbel forces {drive} --force 10kN..4kN --stroke 600mm --angle {angles!r}"
            f" --columns phi,{key} --digits 9"
        )
        work += simpson([float(row[1]) for row in rows], math.radians(end - begin) / 200)
    assert work == pytest.approx(true, rel=1e-6)


def test_long_tables_of_a_new_load_have_the_digits_of_short_ones(house: House) -> None:
    words = "kurbel forces --ratio 1:5 --force 10kN..4kN --columns rod_force_n,radial_force_n"
    long, short = (house.records(f"{words} --step {step} --to 360") for step in (0.01, 20))
    assert [row[1:] for row in long[::2000]] == [row[1:] for row in short]


@pytest.fixture(scope="module")
def double(house: House, tmp_path_factory: pytest.TempPathFactory) -> Iterator[House]:
    """The gear with a ratio and a letter of its own."""
    double = House(tmp_path_factory.mktemp("double") / "copy", house.folder)
    changed = {
        "src/kurbel/linkage/cardan.py": {
            '"$x/R = 2 (1 - cos φ)$")': '"$x/R = 2 (1 - cos φ)$", ("$φ$ von innen",))',
            "quantities=gear_registry,": "quantities=gear_registry, ratios=True,",
            "def drives(": 'takes = ("ratio",)\n\n    def drives(',
            "return (Gear(said.rodless),)": "return tuple(map(Gear, said.cranks(ratios)))",
        },
        "templates/cardan/layout.toml": {'down = ["angle"]': 'ratios = ["1:5"]\ndown = ["ratio", "angle"]'},
    }
    for path, parts in changed.items():
        for old, new in parts.items():
            double.do(f"replace={shlex.quote(old)} in={path}", new)
    yield double
    double.end()


def test_pages_of_a_new_mechanism_say_its_letters_its_stroke_and_its_ratio(double: House) -> None:
    table = "kurbel table --mechanism cardan --step 90"
    page = " ".join(double.kurbel(f"{table} --lang en --columns phi,path,velocity").split())
    assert "x/R = 2 (1 − cos φ), c/v = 2 sin φ, p R/v² = 2 cos φ, φ von innen" in page
    assert "Path and velocity of a Cardan gear for R:L = 1:5" in page
    many = double.kurbel(f"{table} --ratio '1:3;1:4' --lang en -f markdown")
    assert many.splitlines()[0] == "**Path, velocity and acceleration of a Cardan gear**"
    assert many.count("R:L = 1:3") == many.count("R:L = 1:4") == 1
    solved = "kurbel solve --mechanism cardan --ratio 1:3 --where"
    one = " ".join(double.kurbel(f"{solved} s=25% --lang en").split())
    assert "for R:L = 1:3, x/S = 25 %" in one
    assert "from the inner one; S = 4 R" in one
    double.kurbel("kurbel plot --mechanism cardan --ratio 1:3 --positions 50 --lang en -o double.svg")
    assert "Cardan gear for R:L = 1:3" in (double.desk / "double.svg").read_text(encoding="utf-8")
    # Whatever the ratio is, p is cos φ.
    assert [row[3] for row in double.records(f"{solved} 'p = 1/2 of dead centre'")] == ["60.0000"] * 2
