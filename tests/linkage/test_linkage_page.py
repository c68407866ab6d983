"""Pages of drives with a rocker: their formulas give their numbers, their links may be lengths, ways to ask.

What else they say stands in transcripts.
"""

from __future__ import annotations

import math

import pytest
from cli import printed, records
from drives import ARCS, Drive, arc

from kurbel.verify import CONFIRMED

ARC = ("table", "--mechanism=arc")
OUT, RETURN = 1, -1


@pytest.mark.parametrize("drive", [ARCS[0], ARCS[2], ARCS[3]], ids=str)
@pytest.mark.parametrize("stroke", [OUT, RETURN])
def test_the_formulas_below_the_table_give_its_numbers(drive: Drive, stroke: int) -> None:
    keys = ("path", "velocity", "acceleration", "rocker", "rod", "slant")
    end, angles = ("", "7..367:30") if stroke == OUT else ("_return", "7..177:17")
    columns = ",".join(f"{key}{end}" for key in keys)
    rows = records("table", *drive.words, f"--angle={angles}", f"--columns=phi,{columns}", "--digits=14")
    pivot, rod = drive.true.bearing, 1 / float(drive.true.ratio)
    rocker, distance, height = float(drive.true.rocker or 0), float(pivot.x), float(pivot.y)
    side = 1 if height >= 0 else -1
    arm = drive.true.dead(stroke).minus(pivot)
    start = math.degrees(math.atan2(side * float(arm.x), -side * float(arm.y)))
    for row in rows:
        phi, x, c, p, theta, psi, tau = map(float, row.values())
        assert tau == pytest.approx(psi + theta, abs=1e-12)
        assert x == pytest.approx(stroke * side * rocker * math.radians(start - theta), abs=1e-12)
        zeta, τ = math.radians(phi - theta), math.radians(tau)
        assert c == pytest.approx(math.sin(zeta + τ) / math.cos(τ), abs=1e-12)
        bent = math.sin(zeta) + stroke * side / rocker * c**2
        turned = math.cos(zeta) + stroke / rod * math.cos(zeta) ** 2 / math.cos(τ) ** 3
        assert p == pytest.approx(turned - bent * math.tan(τ), abs=1e-12)
        φ, ψ, θ = (math.radians(angle) for angle in (phi, psi, theta))
        along = stroke * math.cos(φ) + rod * math.cos(ψ)
        across = stroke * math.sin(φ) - rod * math.sin(ψ)
        assert along == pytest.approx(distance + side * rocker * math.sin(θ), abs=1e-12)
        assert across == pytest.approx(height - side * rocker * math.cos(θ), abs=1e-12)
    text = " ".join(printed("table", *drive.words, "--angle=30", f"--columns={columns}").out.split())
    sign, bow, back = "+−"[stroke != OUT], "−+"[stroke * side > 0], "−+"[side < 0]
    assert f"cos ζ {sign} λ (cos² ζ)/cos³ τ − (sin ζ {bow} β c²/v²) tan τ" in text
    lead = "" if stroke == OUT else "− "
    assert f"{lead}R cos φ + L cos ψ = D {'−+'[side > 0]} B sin θ" in text
    assert f", {lead}R sin φ − L sin ψ = H {back} B cos θ" in text
    starts = {(OUT, 1): "θᵢ − θ", (OUT, -1): "θ − θᵢ", (RETURN, 1): "θ − θₒ", (RETURN, -1): "θₒ − θ"}
    assert f"x = B ({starts[stroke, side]})" in text


SIZED = (
    "path_mm", "velocity_mps", "acceleration_mps2", "turn_velocity_radps", "turn_acceleration_radps2",
    "rod_velocity_radps", "rod_acceleration_radps2",
)  # fmt: skip


@pytest.mark.parametrize("circuit", [1, -1])
def test_links_are_given_in_millimetres_and_printed_so(circuit: int) -> None:
    """A four-bar whose angles count from the line of centres."""
    lengths = (
        "--stroke=crank:40mm",
        "--rod=15cm",
        "--rocker=80mm",
        "--pivot=150mm;0",
        f"--circuit={circuit}",
    )
    asked = ("--speed=90/min", "--angle=60", f"--columns={','.join(SIZED)}", "--digits=9")
    (row,) = records(*ARC, *lengths, *asked)
    # All lengths over that of the crank, R = 40 mm and n = 3/2 s.
    links = arc("15/4", "2", "15/4;0", circuit, radius="0.04", speed="1.5", turns=True).true
    for key in SIZED:
        assert links.value(key, 60).confirms(row[key]) == CONFIRMED, key


def test_the_page_of_forces_says_the_size_once() -> None:
    run = ("--reciprocating=85kg", "--stroke=0.64m", "--speed=90/min", "--force=7kN", "--angle=40")
    page = " ".join(printed("forces", "--mechanism=arc", "--rocker=6", *run, "--lang=en").out.split())
    assert page.count("R = 320 mm") == page.count("n = 90 min⁻¹") == 1


def test_one_page_may_be_asked_for_in_several_ways() -> None:
    straight, rocker = printed("table").out, printed(*ARC, "--rocker=6").out
    assert printed("table", "--mechanism=straight").out == straight
    offset = ("--offset=0.5", "--ratio=1:4")
    assert printed("table", "--mechanism=offset", *offset).out == printed("table", *offset).out
    # The layout tells the mechanism.
    assert printed("table", "--layout=arc", "--rocker=6R", "--pivot=5; 6R").out == rocker
    assert printed("table", "--layout=parallel").out == printed("table", "--mechanism=parallel").out
    # What is typed goes before the environment.
    crank = {"KURBEL_TABLE_BEAM": "3", "KURBEL_TABLE_LAYOUT": "forces"}
    assert printed(*ARC, "--rocker=6", **crank).out == rocker
    linkage = {"KURBEL_TABLE_MECHANISM": "arc", "KURBEL_TABLE_ROCKER": "6"}
    assert printed("table", **linkage).out == rocker
    assert printed("table", "--layout=kinematics", **linkage).out == straight
    assert printed("table", "--mechanism=parallel", **linkage).out.startswith(" Weg, Geschwindigkeit")
