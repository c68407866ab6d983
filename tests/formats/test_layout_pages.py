"""Golden pages: every layout as text in both languages, read by eye against the books and the formulas."""

from __future__ import annotations

import pytest
from cli import printed
from golden import assert_golden
from pages import (
    BALANCES,
    BEAMS,
    COLLATIONS,
    ENGINES,
    LINKAGES,
    RODS,
    SOLVED,
    command,
    default_page,
    each_layout,
)  # fmt: skip
from places import GOLDEN

from kurbel.formats.registry import FORMATS
from kurbel.formats.render import render
from kurbel.page.folders import LANGUAGES, layout_names

MACHINE = ("table", "--stroke=600mm", "--rod=1500mm", "--speed=120/min")
OFFSET = ("table", "--ratio=1:4", "--offset=0,5", "--step=15")
BELOW = ("table", "--mechanism=arc", "--ratio=1:4;3:10", "--rocker=5", "--pivot=4.2;-5.1", "--step=30")
STEAM = ("--back=10%", "--exponent=1,13", "--clearance=5%")
ROD_MACHINE = ("--stroke=600mm", "--rod=1500mm", "--speed=120/min", "--rod-mass=100kg")
ROD = ("--centre=0,6", "--gyration=0,48", *ROD_MACHINE)
BLAU = ("--where=p=0", "--where=p = 1/6 of dead centre", "--where=p = -1/6 of dead centre")
SOLVE_MACHINE = ("--stroke=600mm", "--rod=1500mm", "--speed=120/min")
CRANKS = ("delta", "--detail", "--eps=4", "--ratio=1:4;1:5", "--cranks=0;90", "--single-acting", *STEAM)
TEXTS = {
    **{name: command(name) for name in layout_names()},
    "kinematics-units": MACHINE,
    "forces-units": ("forces", "--force=10kN", "--stroke=600mm", "--step=30", "--to=180"),
    "kinematics-offset": OFFSET,
    "arc-below": (*BELOW, "--columns=phi,path,acceleration,turn,turn_velocity,rod_velocity"),
    "delta-cranks": CRANKS,
    "harmonics-path": ("harmonics", "--quantity=x", "--ratio=1:4;1:5", "--orders=10", "--digits=9"),
    "balance-v": ("balance", "--engine=v2-90", "--share=0.5", "--orders=6"),
    "inertia-units": ("inertia", *ROD, "--offset=0.2", "--step=30"),
    "inertia-errors-units": ("inertia", "--layout=inertia-errors", *ROD),
    "forces-tangent-units": ("forces", "--at=tangent", "--ratio=1:5;1:4", "--force=10kN", "--stroke=600mm"),
    "solve-blau": ("solve", "--ratio=1:5;1:4", "--method=series", *BLAU),
    "solve-units": ("solve", *SOLVE_MACHINE, "--where=c = 3 m/s", "--where=x = 200 mm"),
    "solve-offset": ("solve", "--ratio=1:4", "--offset=0.5", "--where=s=25%", "--where=psi=2°30'"),
    "solve-arc": ("solve", "--mechanism=arc", "--rocker=6", "--where=acceleration=0", "--where=rocker=0"),
    "collate-blau-33": ("collate", "blau-33"),
    **{f"collate-{key}": ("collate", key) for key in ("blau-31", "blau-32", "blau-34", "blau-35")},
    "collate-weisbach-149": ("collate", "weisbach-149"),
    "collate-weisbach-150": ("collate", "weisbach-150"),
    "collate-deviations": ("collate", "weisbach-150", "--only=deviations"),
    "weisbach-150-weisbach": ("delta", "--method=weisbach"),
}
# Pages whose cells are not all alike: angles beside numbers, notes, units and places without a value.
RICH = ("delta-detail", "flywheel", "forces-tangent", "collation", "solve")
SUFFIXES = {entry.suffixes[0]: name for name, entry in FORMATS.items() if name not in ("text", "csv", "pdf")}
PAGES = {
    **{f"{name}.{lang}.txt": (*text, f"--lang={lang}") for name, text in TEXTS.items() for lang in LANGUAGES},
    **{
        f"{name}.csv": (*command(name), "-f", "csv")
        for name in ("kinematics", *ENGINES, *BEAMS, *BALANCES, *LINKAGES, *RODS, *COLLATIONS, *SOLVED)
    },
    **{f"{name}{suffix}": (*command(name), "-f", form) for name in RICH for suffix, form in SUFFIXES.items()},
}


@pytest.mark.parametrize("name", PAGES)
def test_page_is_golden(name: str) -> None:
    assert_golden(f"layouts/{name}", printed(*PAGES[name]).out)


def test_no_golden_page_is_left_behind() -> None:
    assert {path.name for path in (GOLDEN / "layouts").iterdir()} == set(PAGES)


@each_layout
def test_page_from_python_is_that_of_the_command_line(name: str, lang: str) -> None:
    assert printed(*command(name), f"--lang={lang}").out == render(default_page(name, lang), "text")
