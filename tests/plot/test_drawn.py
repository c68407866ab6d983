"""Every line and text of drawings of each kind: where it is, how it looks, and what it lies upon."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from decimal import Decimal
from itertools import groupby

import pytest
from drawings import SVG, plotted
from golden import assert_golden
from tools import require_library

# Of these all that is drawn stands in tests/golden/drawn, but grid and ticks.
DRAWN = {
    "motion": "table --ratio=1:4",
    "drives": "table --ratio=1:4;1:5 --columns=x,c --lang=en",
    "over-path": "table --layout=over-path --ratio=1:5 --columns=x,psi,c --stroke=600mm",
    "angle-over-path": "table --layout=over-path --ratio=1:5 --columns=x,psi --stroke=600mm",
    "forces": "forces --eps=4 --ratio=1:∞ --columns=piston_force,tangential_force",
    "polar": "forces --polar --eps=4",
    "compressor": "forces --polar --pressure-ratio=3 --clearance=5%",
    "turning": "turning --eps=3 --ratio=1:4",
    "offset": "plot --positions=40;200 --ratio=1:4 --offset=0.5 --point=0.5;0.3",
    "arc": "plot --positions=30;150 --mechanism=arc --rocker=5.5",
    "arc-below": "plot --positions=30 --mechanism=arc --ratio=1:5 --rocker=4 --pivot=4;-3.5",
    "beam": "plot --positions=30 --mechanism=beam --ratio=1:5 --beam=3",
    "parallel": "plot --positions=30;100 --mechanism=parallel",
    "blau-9": "construct blau-9 --angle=50",
    "blau-9-short": "construct blau-9 --angle=10",
    "radinger": "construct radinger",
}


def told(group: str, one: ET.Element) -> str:
    """Return an element in one line: its group, its box or place in 1/72 inch, and its look."""
    tag = one.tag.removeprefix(SVG)
    if tag == "text":
        return f"{rounded(one.get('transform', group))} {''.join(one.itertext())}"
    look = rounded(one.get("style", ""))
    if tag == "use":
        place = f"{one.get('x')} {one.get('y')}"
        return f"{group} mark {rounded(place)} {look}"
    pairs = re.findall(r"([\d.-]+) ([\d.-]+)(?=\s)", one.get("d", "") + " ")
    across, up = (sorted(map(float, values)) for values in zip(*pairs, strict=True))
    box = f"{across[0]} {up[0]} {across[-1]} {up[-1]}"
    return f"{group} {len(pairs)} points {rounded(box)} from {rounded(' '.join(pairs[0]))} {look}"


def rounded(text: str) -> str:
    return re.sub(r"-?\d+\.\d+", lambda found: f"{Decimal(found[0]):.1f}".replace("-0.0", "0.0"), text)


def elements(group: ET.Element) -> Iterator[tuple[str, ET.Element]]:
    """Yield what is drawn with the name of its group, or the place of that, in the order of the file."""
    name = re.sub(r"_\d+$", "", group.get("id") or group.get("transform") or "")
    for one in group:
        tag = one.tag.removeprefix(SVG)
        if tag in ("path", "use", "text"):
            yield name, one
        elif tag != "defs" and name not in ("xtick", "ytick"):
            yield from elements(one)


@pytest.mark.parametrize("name", DRAWN)
def test_each_line_and_text_is_drawn_where_it_stands_in_the_golden_file(name: str) -> None:
    """Of what is drawn alike in a row the first and the last stand there."""
    require_library("matplotlib")
    command, *options = DRAWN[name].split()
    found = [told(*one) for one in elements(plotted(command, *options).root)]
    text = f"$ kurbel {DRAWN[name]}\n"
    for _, rows in groupby(found, lambda row: re.sub(r"[\d.-]+ [\d.-]+", "", row)):
        row = [*rows]
        text += "\n".join(row if len(row) < 4 else [row[0], f"... {len(row)} alike", row[-1]]) + "\n"
    assert_golden(f"drawn/{name}.txt", text)
