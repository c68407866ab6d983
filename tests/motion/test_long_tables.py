"""Long tables, whose numbers come from floats, have the digits of short ones, whatever is computed."""

from __future__ import annotations

import re
from fractions import Fraction

import pytest
from cli import printed, records

# A crank of 1 m at 1 rad/s: a mass of m kg calls up forces of about m N.
HEAVY = (
    "forces --ratio=1:4 --stroke=2m --speed=1rad/s --reciprocating=300kg --rod-mass=150kg --centre=0.4"
    " --gyration=0.5 --digits=12"
)
ROD = "--centre=0.65 --gyration=0.35 --rod-mass=100kg --stroke=600mm --speed=2/s --digits=9"
PAGES = {
    # A force alone is as large as the masses' together, and masses as large as their counterweights. Of some
    # hundred newtons floats have the twelfth decimal only now and then.
    f"{HEAVY} --rotating=40kg": "_nm?$",
    f"{HEAVY} --rotating=40kg --force=812N --slope=vertical --friction=70N": "_nm?$",
    f"{HEAVY} --rotating=-772kg": "_nm?$",
    "table --ratio=1:4 --stroke=600mm --speed=2/s --digits=12": "",
    "table --ratio=1:4 --point=0.3,0.1": "^path|^velocity_across$|^acceleration$",
    **{f"inertia {rod} {ROD}": "" for rod in (
        "--ratio=1:5", "--ratio=1:5 --offset=0.3", "--ratio=0.99", "--ratio=1:∞",
    )},
}  # fmt: skip


def columns_of(words: str) -> list[str]:
    """Return the columns of the straight crank for which all is known that they need."""
    of, *typed = (word.partition("=")[0] for word in words.split())
    keys = []
    for row in records("quantities"):
        command, *needs = row["command"].split()
        options = {one for one in needs if one.startswith("--")}
        if of == "forces":
            # Masses call up all that a force does; what needs nothing is of engines.
            fits = command in ("table", of) and options and options - {"--force"} <= {*typed}
        else:
            fits = command == of and options <= {*typed}
        # A rod without end has no moment of inertia, an offset crank no Fehlerglied.
        none = ("∞" in words and "finite" in needs) or ("offset" in words and row["key"].startswith("fd"))
        if row["key"] not in ("ratio", "phi") and fits and re.search(PAGES[words], row["key"]) and not none:
            keys.append(row["key"])
    return list(dict.fromkeys(keys))


@pytest.mark.parametrize("words", PAGES)
def test_long_tables_have_the_digits_of_short_ones(words: str) -> None:
    columns = columns_of(words)
    assert len(columns) > 3
    asked = (*words.split(), f"--columns=phi,{','.join(columns)}")
    step = Fraction(180 * len(columns) // 25, 1000)
    long = records(*asked, "--to=180", f"--step={float(step)}")
    assert len(long) * len(columns) > 20_000
    some = long[:: len(long) // 7]
    short = records(*asked, f"--angle={';'.join(row['phi'] for row in some)}")
    for one, other in zip(short, some, strict=True):
        assert {**one, "phi": Fraction(one["phi"])} == {**other, "phi": Fraction(other["phi"])}


# Some 25,000 numbers of each; steps of whole degrees, right angles and odd ones among them.
ROCKERS = (
    "table --mechanism=arc --ratio=1:5 --rocker=6 --step=0.08",
    "table --mechanism=beam --beam=5 --stroke=600mm --speed=120/min --step=0.08",
    "forces --mechanism=arc --rocker=5 --force=10kN --stroke=1m --speed=2/s --reciprocating=9kg --step=0.08",
    "table --mechanism=parallel --columns=phi,coupler_path,coupler_velocity,coupler_rise --step=0.02",
)


@pytest.mark.parametrize("words", ROCKERS)
def test_long_tables_of_other_drives_have_the_digits_of_short_ones(words: str) -> None:
    long = records(*words.split(), "--to=180", "--digits=6")
    assert len(long) * (len(long[0]) - 1) > 20_000
    rows = {Fraction(record["phi"]): {**record, "phi": ""} for record in long}
    about = words.split()[:-1]
    for record in records(*about, "--digits=6", "--angle=0;12.32;77.12;90;111.04;180"):
        assert rows[Fraction(record["phi"])] == {**record, "phi": ""}


def test_a_long_turn_of_an_engine_has_the_digits_of_a_short_one_in_every_format() -> None:
    # At ten decimals floats leave a cell in a hundred to balls.
    about = ("turning", "--eps=4", "--digits=10", "--columns=phi,tangential,energy")
    long = records(*about, "--step=0.05")
    assert len(long) == 7201
    some = long[::800]
    short = records(*about, f"--angle={';'.join(row['phi'] for row in some)}")
    assert [{**row, "phi": ""} for row in short] == [{**row, "phi": ""} for row in some]
    page = printed(*about, "--step=0.05", "-f", "md", "--lang=en").out
    rows = [line.replace(" ", "").replace("−", "-").strip("|").split("|") for line in page.splitlines()]
    assert [row for row in rows if row[0].replace(".", "").isdigit()] == [list(row.values()) for row in long]
