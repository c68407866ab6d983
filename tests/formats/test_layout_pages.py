"""Golden pages: every layout as text in both languages, read by eye against the books and the formulas."""

from __future__ import annotations

import pytest
from cli import printed
from golden import assert_golden
from pages import (
    APPROXIMATED,
    BALANCES,
    BEAMS,
    COLLATIONS,
    CONSTRUCTED,
    EFFORTS,
    ENGINES,
    LINKAGES,
    OVER_PATH,
    POWERS,
    PRESSED,
    RODS,
    SOLVED,
    SOLVED_LOADED,
    TURNED,
    command,
    default_page,
)  # fmt: skip
from places import GOLDEN

from kurbel.formats.registry import FORMATS, BytesFormat
from kurbel.formats.render import render
from kurbel.page.layouts import LANGUAGES, layout_names

# Two rows show how a page is laid out; that its figures are right is tested where they are computed.
ROWS = {
    "forces-coupled": ("--angle=0;60",),
    **dict.fromkeys(("over-path", "forces-path"), ("--shares=0;0.3",)),
    "pressures": ("--shares=0;0.3",),
    "pressures-turn": ("--angle=0;60",),
    "roetscher-gf": ("--angle=0;60",),
    "series-errors": ("--order=1;3",),
    "kolbenwege": ("--angle=0;60", "--ratio=1:5;1:4"),
    "roetscher-112": ("--angle=0;60", "--ratio=1:5;1:4"),
    "delta-tafel": ("--eps=2;4",),
    "delta-verfahren": ("--eps=4",),
    "delta-flywheel": ("--eps=2;4",),
    "weisbach-150": ("--eps=4",),
    "collation": ("--only=deviations",),
    "formulas": ("--only=deviations",),
    "harmonics": ("--orders=2",),
    "torque-harmonics": ("--orders=2",),
    "excitation": ("--orders=2",),
    "balance": ("--orders=2",),
}
OVER_ANGLES = (
    "blau-fd", "ordnungen",
    "arc", "blau-kolbenwege", "engine-forces", "forces", "forces-arc", "forces-effort",
    "forces-parallel", "forces-verfahren", "inertia", "ensslin-parts", "ensslin-forces", "inertia-parts",
    "ensslin-parts-rocker", "ensslin-forces-rocker", "mollier",
    "kinematics", "lueger-kolbenbewegung", "machine-forces", "parallel", "rod-load-turn", "speed",
    "rod-points", "torques", "turning", "turning-path",
    "verfahren",
)  # fmt: skip
ROWS |= {name: ("--angle=0;60",) for name in OVER_ANGLES}
MACHINE = ("--stroke=600mm", "--rod=1500mm", "--speed=120/min")
ROD_MACHINE = ("--centre=0,6", "--gyration=0,48", *MACHINE, "--rod-mass=100kg")
BELOW = ("table", "--mechanism=arc", "--ratio=3:10", "--rocker=5", "--pivot=4.2;-5.1", "--angle=30")
STEAM = ("--back=10%", "--exponent=1,13", "--clearance=5%", "--single-acting")
# What else a page may say, each in one language.
OTHERS = {
    "kinematics-units.en": ("table", *MACHINE, "--angle=60"),
    "kinematics-offset.de": ("table", "--ratio=1:4", "--offset=0,5", "--angle=60"),
    "rod-points-units.en": ("table", "--point=0;0.5,0.1", *MACHINE, "--angle=0;60"),
    "rod-points-arc.de": ("table", "--point=0.5,0.1", *BELOW[1:]),
    "forces-units.en": ("forces", "--force=10kN", "--stroke=600mm", "--angle=60"),
    "forces-arc-units.en": ("forces", *BELOW[1:], "--force=10kN", "--stroke=600mm"),
    "forces-parallel-units.de": ("forces", "--mechanism=parallel", "--force=10kN", "--angle=30"),
    "arc-below.de": (*BELOW, "--columns=phi,path,turn_velocity"),
    "delta-cranks.en": ("delta", "--detail", "--eps=4", "--ratio=1:4;1:5", "--cranks=0;90", *STEAM),
    "delta-pump.de": ("delta", "--pump=differential", "--cranks=0;90", "--columns=delta,work,mean_pressure"),
    "turning-compressor.en": (
        "turning",
        "--pressure-ratio=3",
        "--angle=0;60",
        *STEAM[1:3],
        "--suction-loss=4%",
    ),
    "harmonics-path.de": ("harmonics", "--quantity=x", "--ratio=1:4;1:5", "--orders=4", "--digits=9"),
    "balance-v.en": ("balance", "--engine=v2-90", "--share=0.5", "--orders=2"),
    "inertia-units.de": ("inertia", *ROD_MACHINE, "--offset=0.2", "--angle=60"),
    "ensslin-forces-units.de": (
        "inertia",
        "--layout=ensslin-forces",
        *ROD_MACHINE,
        "--offset=0.2",
        "--angle=60",
    ),
    "ensslin-parts-units.en": (
        "inertia",
        "--layout=ensslin-parts",
        *ROD_MACHINE,
        "--acceleration=20rad/s2",
        "--angle=60",
    ),
    "forces-tangent-units.de": ("forces", "--at=tangent", "--force=10kN", "--stroke=600mm"),
    "solve-blau.en": ("solve", "--ratio=1:5;1:4", "--method=series", "--where=p = 1/6 of dead centre"),
    "kinematics-third-order.de": (
        "table",
        *MACHINE,
        "--angle=60",
        "--method=series",
        "--order=3",
        "--columns=phi,x_mm,x_return_mm,fd_mm,c_mps,p",
    ),
    "kinematics-ninth-order.en": ("table", "--angle=60", "--method=series", "--order=9"),
    "solve-units.de": ("solve", *MACHINE, "--where=c = 3 m/s"),
    "solve-offset.en": ("solve", "--ratio=1:4", "--offset=0.5", "--where=psi=2°30'"),
    "over-path-units.en": ("table", "--over=path", *MACHINE, "--offset=50mm", "--step=50%"),
    "over-path-arc.de": ("table", "--over=path", "--mechanism=arc", "--rocker=6", "--step=50%"),
    "construct-line.en": ("construct", "roetscher-1047-line", "--ratio=1:4", "--offset=0.3", "--angle=60"),
    "construct-circle.de": ("construct", "roetscher-1047-circle", "--ratio=1:4", "--angle=60"),
    "construct-forces.de": ("construct", "forces", "--ratio=1:4"),
    "construct-forces.en": ("construct", "forces", "--ratio=1:4", "--angle=200"),
    "solve-arc.de": ("solve", "--mechanism=arc", "--rocker=6", "--where=rocker=0"),
    "collate-weisbach-149.en": ("collate", "weisbach-149", "--only=deviations"),
    "collate-blau-35.de": ("collate", "blau-35"),
    "weisbach-150-weisbach.en": ("delta", "--method=weisbach", "--eps=4"),
}
# A page whose cells are not all alike: angles beside numbers, a note, units and places without a value.
RICH = "delta-detail"
SUFFIXES = {
    entry.suffixes[0]: name
    for name, entry in FORMATS.items()
    if name not in ("text", "csv") and not isinstance(entry, BytesFormat)
}
PAGES = {
    **{
        f"{name}.{lang}.txt": (*command(name), *ROWS.get(name, ()), f"--lang={lang}")
        for name in layout_names()
        for lang in LANGUAGES
    },
    **{f"{name}.txt": (*words, f"--lang={name[-2:]}") for name, words in OTHERS.items()},
    **{
        f"{name}.csv": (*command(name), *ROWS.get(name, ()), "-f", "csv")
        for name in (
            "kinematics",
            *ENGINES,
            *POWERS,
            *BEAMS,
            *BALANCES,
            *TURNED,
            *EFFORTS,
            *LINKAGES,
            *RODS,
            *PRESSED,
            *COLLATIONS,
            *SOLVED,
            *OVER_PATH,
            *APPROXIMATED,
            *CONSTRUCTED,
            *SOLVED_LOADED,
        )
    },
    **{f"{RICH}{suffix}": (*command(RICH), "-f", form) for suffix, form in SUFFIXES.items()},
}


@pytest.mark.parametrize("name", PAGES)
def test_page_is_golden(name: str) -> None:
    assert_golden(f"layouts/{name}", printed(*PAGES[name]).out)


def test_no_golden_page_is_left_behind() -> None:
    assert {path.name for path in (GOLDEN / "layouts").iterdir()} == set(PAGES)


@pytest.mark.parametrize("name", layout_names())
def test_page_from_python_is_that_of_the_command_line_in_both_languages(name: str) -> None:
    german, english = (printed(*command(name), f"--lang={lang}").out for lang in LANGUAGES)
    assert [german, english] == [render(default_page(name, lang), "text") for lang in LANGUAGES]
    assert german != english
    assert min(german.count("\n"), english.count("\n")) > 5
