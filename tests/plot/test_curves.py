"""Curves read from their drawings by the ticks: they are the columns of the table of the same words."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from cli import printed, records
from drawings import Floats, Paper, plotted
from machines import machine
from places import CARDS
from tools import require_library

TURN = ("--from=0", "--to=360", "--step=15")
STEAM = "--eps=3 --back=0.1 --ratio=1:4"
LOAD = f"{STEAM} --bore=300mm --pressure=8bar --stroke=600mm --speed=120/min"
MASSES = "--reciprocating=200kg --rod-mass=150kg --centre=0.4 --gyration=0.3"
ALL_FORCES = "--columns=piston_force,rod_force,guide_force,tangential_force,radial_force"
RUN = "tangential,mean_force,energy,rpm"
PIN_FORCES = "--columns=crank_pin_force_n,guide_force_n,torque_nm"
# The command, and words of drawing and table; columns stand where they are not those of the words.
CURVES = {
    "motion": ("table", "--ratio=1:4,5 --columns=x,c,p,psi", ""),
    "series": ("table", "--ratio=1:4 --method=series --order=3 --columns=x,c,p", ""),
    "strokes": ("table", "--ratio=1:4 --to=90 --columns=x,x_return,c,c_return", ""),
    "offset": ("table", "--ratio=1:4 --offset=0.3 --columns=x,c,p", ""),
    "ratios": ("table", "--ratio=1:4;1:5;1:∞ --columns=x,rod_force,guide_force", ""),
    "machine": ("table", "--stroke=600mm --rod=1500mm --speed=120/min", "x_mm,c_mps,p_mps2"),
    "forces": ("forces", "--force=10kN --stroke=600mm --columns=rod_force_n,torque_nm", ""),
    "moving masses": (
        "forces", "--stroke=600mm --speed=120/min --reciprocating=200kg"
        " --columns=crosshead_load_n,rod_force_n,tangential_force_n", "",
    ),
    "arc": ("table", "--mechanism=arc --rocker=3 --ratio=1:5;1:4 --columns=path,velocity,rod", ""),
    "beam": ("table", "--mechanism=beam --beam=3", "path,velocity,acceleration,rocker,rod"),
    "parallel": (
        "table", "--mechanism=parallel",
        "coupler_path,coupler_rise,coupler_velocity,coupler_rise_velocity,"
        "coupler_acceleration,coupler_rise_acceleration",
    ),
    "points": ("table", "--ratio=1:4 --point=0.5;0.3,0.2 --columns=path_along,path_across,velocity", ""),
    "steam": ("forces", f"{STEAM} {ALL_FORCES}", ""),
    "single": ("forces", f"{STEAM} --single-acting {ALL_FORCES}", ""),
    "engines": ("forces", "--eps=3;2 --columns=piston_force,tangential_force", ""),
    "newtons": ("forces", f"{LOAD} {MASSES} {PIN_FORCES}", ""),
    "on an arc": ("forces", f"--eps=4 --mechanism=arc --rocker=6 {ALL_FORCES}", ""),
    "turning": ("turning", "--eps=4 --back=0.1", "tangential,mean_force,energy"),
    "masses": ("turning", f"{LOAD} {MASSES} --cranks=0;90", "tangential,mean_force,energy"),
    "efforts": ("turning", "--eps=2;4 --ratio=1:4;1:5", "tangential,energy"),
    "card": ("turning", f"--card={CARDS / 'ideal-2.csv'}", "tangential,mean_force,energy"),
    "flywheel": ("turning", f"--eps=3 --flywheel=50 --speed=120/min --columns={RUN}", RUN),
}  # fmt: skip


@pytest.fixture(autouse=True)
def library() -> None:
    require_library("matplotlib")


def drives(rows: list[dict[str, str]]) -> list[list[dict[str, str]]]:
    """Return the rows of each drive, engine or point, which columns before the angle tell apart."""
    found: dict[tuple[str, ...], list[dict[str, str]]] = {}
    for row in rows:
        found.setdefault(tuple(row.values())[: [*row].index("phi")], []).append(row)
    return [*found.values()]


def test_the_title_over_the_path_names_the_ratio_of_one_drive_alone() -> None:
    one, several = (
        printed("table", "--layout=over-path", f"--ratio={ratios}", "-f", "svg").out
        for ratios in ("1:4", "1:4;1:5")
    )
    assert "über dem Kolbenweg für R:L = 1:4; genaue Formeln" in one
    assert "über dem Kolbenweg; genaue Formeln" in several


@pytest.mark.parametrize("name", CURVES)
def test_curves_are_the_columns_of_their_table(name: str) -> None:
    command, words, keys = CURVES[name]
    columns = (keys or words.rpartition("--columns=")[2]).split(",")
    asked = [one for one in words.split() if not (keys and one.startswith("--columns"))]
    span = ("--step=15",) if "return" in words else TURN
    paper = plotted(command, *asked, *(span if command != "turning" else ()))
    apart = drives(
        records(command, *words.split(), *(span if command != "turning" else span[2:]), "--digits=9")
    )
    curves = paper.names(r"curve-\d+-\d+")
    wanted = [(key, rows) for key in columns for rows in apart]
    # The mean speed is drawn, too.
    assert len(curves) == len(wanted) + (name == "flywheel")
    for curve, (key, rows) in zip(curves, wanted, strict=False):
        angles, values = paper.values(curve)
        meant = np.asarray([float(row[key]) for row in rows])
        # Of an axis in kN.
        power = round(math.log10(max(abs(meant)) / max(abs(values))) / 3) * 3 if meant.any() else 0
        for row, true in zip(rows, meant, strict=True):
            if command == "forces" and "eps" in words and row["phi"] == "360":
                # Where the next turn begins, the steam has changed sides.
                continue
            there = np.abs(angles - float(row["phi"])) < 1e-4
            assert there.any() or key == "mean_force", (name, key, row)
            off = np.abs((values if key == "mean_force" else values[there]) * 10.0**power - true)
            assert off.min() <= 1e-6 * max(abs(meant)), (name, key, row)


def curve(paper: Paper, name: str) -> list[tuple[float, float]]:
    return [*zip(*(side.tolist() for side in paper.values(name)), strict=True)]


def test_where_the_steam_changes_sides_a_force_has_both_its_values_and_a_thin_line_joins_them() -> None:
    keys = ("piston_force", "tangential_force", "radial_force")
    paper = plotted("forces", *STEAM.split(), f"--columns={','.join(keys)}", "--step=7", "--to=357")
    end = 1 / 3 - 0.1
    for number, sign in ((1, 1), (3, -1)):
        points = curve(paper, f"curve-1-{number}")
        # A force on the pin counts towards the shaft.
        first = 0.9
        assert points[0] == pytest.approx((0, first), abs=1e-6)
        both = [value for angle, value in points if abs(angle - 180) < 1e-4]
        assert both == pytest.approx([sign * end, -sign * 0.9], abs=1e-6)
        assert paper.line(f"curve-1-{number}").path.count("M") == 2
        assert [value for _, value in curve(paper, f"jumps-1-{number}")] == pytest.approx(both, abs=1e-6)
        width, thin = (
            float(paper.line(f"{one}-1-{number}").look["stroke-width"]) for one in ("curve", "jumps")
        )
        assert thin < width / 2
        # Cut-off after a third of the stroke, 2/3 R, counted from either dead centre, whatever the step.
        for side in (1, -1):
            head = 4 + side * (1 - 2 / 3)
            corner = math.degrees(math.acos(side * (head**2 + 1 - 16) / (2 * head))) + 180 * (side < 0)
            assert min(abs(angle - corner) for angle, _ in points) < 1e-4
    # Across the crank there is no force at the dead centre, and no jump.
    angles, values = paper.values("curve-1-2")
    assert (np.diff(angles) > 0).all()
    assert not paper.names("jumps-1-2")
    assert values[np.abs(angles - 180).argmin()] == pytest.approx(0, abs=1e-6)


def test_a_cut_off_at_an_angle_of_the_curve_is_no_jump() -> None:
    # After a quarter of the stroke the crank of an infinite rod is at 60°, and at 240°.
    paper = plotted("forces", "--eps=4", "--ratio=1:∞", "--columns=piston_force", "--step=15")
    angles = paper.values("curve-1-1")[0].round(3).tolist()
    assert [one for one, after in pairwise(angles) if one == after] == [180]


def in_crank(paper: Paper) -> Floats:
    """Return the force on the pin along and across the crank, stroke after stroke."""
    return np.concatenate([np.stack(paper.values(one), axis=1) for one in paper.names(r"curve-\d")])


@pytest.mark.parametrize(
    ("words", "table"),
    [
        ("--ratio=1:3", "forces --ratio=1:3 --force=1N"),
        ("--ratio=1:4 --offset=0.3", "forces --ratio=1:4 --offset=0.3 --force=1N"),
        (STEAM, f"forces {STEAM}"),
        (f"{LOAD} {MASSES}", f"forces {LOAD} {MASSES}"),
    ],
)
def test_the_polar_diagram_is_the_force_on_the_pin_at_every_angle_in_one_scale(
    words: str, table: str
) -> None:
    paper = plotted("forces", "--polar", *words.split(), *TURN)
    unit = "_n" if "N" in table or "bore" in table else ""
    rows = records(*table.split(), *TURN, "--digits=9")
    meant = np.asarray(
        [[float(row[f"{key}{unit}"]) for key in ("tangential_force", "radial_force")] for row in rows]
    )
    found = in_crank(paper)
    scale = 10.0 ** (round(math.log10(np.abs(meant).max() / np.abs(found).max()) / 3) * 3)
    for row in meant:
        assert np.hypot(*(found * scale - row).T).min() < 1e-5 * np.abs(meant).max(), row
    (x0, x1), (y0, y1) = ((one.min(), one.max()) for one in found.T)
    drawn = np.concatenate([paper.points(one) for one in paper.names(r"curve-\d")])
    assert np.ptp(drawn.real) / (x1 - x0) == pytest.approx(np.ptp(drawn.imag) / (y1 - y0), rel=1e-6)


def test_a_polar_diagram_leaps_along_the_crank_at_dead_centres_of_a_whole_turn() -> None:
    paper = plotted("forces", "--polar", *STEAM.split(), "--step=10")
    before, after = (curve(paper, f"curve-{number}") for number in (1, 2))
    end = 1 / 3 - 0.1
    assert [before[0], before[-1]] == [pytest.approx(one, abs=1e-6) for one in ((0, 0.9), (0, -end))]
    assert [after[0], after[-1]] == [pytest.approx(one, abs=1e-6) for one in ((0, 0.9), (0, -end))]
    for number in (1, 2):
        assert "stroke-dasharray" in paper.line(f"chord-{number}").look
        ends = paper.points(f"chord-{number}")
        assert sorted(ends.imag) == pytest.approx(sorted(paper.points("curve-1")[[0, -1]].imag), abs=1e-4)
    # Where the jump is one point of the curve it has a mark at either end.
    assert [paper.words.count(f"{angle}°") for angle in (30, 180)] == [1, 2]
    # The bar of the scale is a step of the axes long.
    assert "0,2 " in paper.words
    # A part of a turn does not return, and a force that never leaps has nothing to join.
    for words in (f"{STEAM} --to=170", "--ratio=1:3"):
        assert not plotted("forces", "--polar", *words.split(), "--step=10").names("chord.*")


def test_the_mean_of_the_speed_lies_between_its_extremes() -> None:
    for words, letter in ((("--speed=120/min",), "n/min−1"), ((), "v/v1")):
        paper = plotted("turning", "--eps=3", "--flywheel=50", *words, "--step=2")
        assert letter in paper.words
        speed, mean = (paper.values(f"curve-3-{number}")[1] for number in (1, 2))
        # The extremes lie between the angles that are drawn.
        np.testing.assert_allclose(mean, (speed.max() + speed.min()) / 2, rtol=1e-4)
        assert mean == pytest.approx([120 if words else mean[0]] * 2)


@pytest.mark.parametrize(
    ("words", "more", "stroke"),
    [
        (("--ratio=0.37",), (), 2),
        (("--ratio=1:3", "--offset=0.6"), (), math.sqrt(4**2 - 0.6**2) - math.sqrt(2**2 - 0.6**2)),
        (("--ratio=1:5", "--method=series", "--order=3"), (), 2),
        (("--ratio=1:∞",), ("--stroke=600mm", "--speed=120/min", "--width=85"), 2),
    ],
)
def test_over_the_path_curves_are_the_columns_of_the_table_to_one_scale(
    words: tuple[str, ...], more: tuple[str, ...], stroke: float
) -> None:
    paper = plotted("table", "--layout=over-path", *words, *more)
    rows = records("table", "--columns=x,c,p", *words, "--from=0", "--to=360", "--step=7.5", "--digits=9")
    x, *courses = (np.asarray([float(row[key]) for row in rows]) for key in ("x", "c", "p"))
    for number, true in enumerate(courses, 1):
        drawn = paper.points(f"curve-{number}-1")
        drawn -= drawn[0]
        # R, v and v²/R are of one length.
        radius = np.ptp(drawn.real) / stroke
        meant = radius * (x - x[0] + 1j * (true - true[0]))
        assert max(np.abs(drawn - one).min() for one in meant) < 0.01


def test_forces_of_an_engine_with_masses_are_those_of_its_bodies() -> None:
    """By Newton and Euler, at angles without a corner of the steam; Q = 8 bar on a bore of 300 mm."""
    options = dict(word.removeprefix("--").split("=") for word in f"{LOAD} {MASSES}".split())
    engine = machine(**{key.replace("-", "_"): value for key, value in options.items()})
    full = 8e5 * math.pi / 4 * 0.3**2 / 1000
    paper = plotted("forces", *LOAD.split(), *MASSES.split(), PIN_FORCES, "--step=7", "--to=357")
    polar = plotted("forces", "--polar", *LOAD.split(), *MASSES.split(), "--step=7", "--to=357")
    places = np.concatenate([np.stack(polar.values(one), axis=1) for one in polar.names(r"curve-\d")])
    for angle in (7, 56, 126, 203, 301):
        true = {key: float(value) * full for key, value in engine.rod(angle).items()}
        true["torque"] = 0.3 * true["tangential_force"]
        for name, key in (("1-1", "crank_pin_force"), ("1-2", "guide_force"), ("2-1", "torque")):
            angles, values = paper.values(f"curve-{name}")
            assert values[np.abs(angles - angle).argmin()] == pytest.approx(true[key], abs=2e-5 * full), key
        there = true["tangential_force"], true["radial_force"]
        assert np.hypot(*(places - there).T).min() < 2e-5 * full


def test_pressures_on_the_piston_are_those_of_the_indicator_and_of_the_masses() -> None:
    words = "--eps=4 --back=0.1 --pressure=9bar --bore=300mm --ratio=1:∞ --stroke=600mm --speed=120/min"
    paper = plotted("pressures", *words.split(), "--reciprocating=300kg")
    # An infinite rod moves the piston by 300 (1 - cos φ) mm; m R ω² on the area of the bore, in bar.
    greatest = 300 * 0.3 * (4 * math.pi) ** 2 / (math.pi / 4 * 0.3**2) / 1e5
    for panel, sign in ((1, 1), (2, -1)):
        share = paper.values(f"curve-{panel}-1")[0]
        gone = share if sign > 0 else 1 - share
        steam = 9 * np.minimum(1, 0.25 / np.maximum(gone, 0.1)) - 0.9
        masses = sign * greatest * (1 - 2 * share)
        for number, meant in enumerate((steam, masses, steam - masses), 1):
            np.testing.assert_allclose(paper.values(f"curve-{panel}-{number}")[1], meant, rtol=0, atol=1e-4)


def test_forces_over_the_path_are_full_up_to_the_cut_off_and_fall_by_mariotte() -> None:
    paper = plotted("forces", "--eps=4", "--back=10%", "--over-path", "--columns=piston_force")
    share, force = paper.values("curve-1-1")
    out = slice(0, np.flatnonzero(share >= 1 - 1e-6)[0] + 1)
    meant = np.minimum(1, 0.25 / np.maximum(share[out], 0.1)) - 0.1
    np.testing.assert_allclose(force[out], meant, atol=1e-5)
    assert np.abs(share[out] - 0.25).min() < 1e-6


def test_what_is_named_over_the_path_is_what_conditions_find() -> None:
    solved = printed("solve", "--where=p=0", "--where=c=max", "--columns=phi_turn,c", "--lang=en").out
    assert all(one in solved for one in ("79°6′", "280°54′", "1.0198"))
    said = " ".join(plotted("table", "--layout=over-path", "--ratio=1:5", "--lang=en").words)
    for text in (
        "79°6′",
        "280°54′",
        "1.0198",
        "inner dead centre",
        "outer dead centre",
        "Outstroke",
        "Return",
    ):
        assert text in said


def test_what_is_asked_for_in_place_of_an_angle_is_drawn_over_the_angles() -> None:
    # The rod leans by 10° where R/L sin φ = sin 10°.
    angle, ratio = plotted("solve", "--unknown=ratio", "--angle=30..150:20", "--where=psi=10").values(
        "curve-1-1"
    )
    assert len(angle) == 7
    np.testing.assert_allclose(ratio * np.sin(np.radians(angle)), np.sin(np.radians(10)), rtol=0, atol=1e-4)


@pytest.mark.parametrize("load", ["--pressure-ratio=3;4", "--compression=6;7 --heat=10"])
def test_a_unit_with_words_is_written_out_at_its_axis(load: str) -> None:
    assert "je Kolbenfläche" in printed("delta", *load.split(), "-f", "svg", "--text").out


@pytest.mark.parametrize(
    "line", ["table --layout=over-path", "table --over-path", "forces --layout=forces-path"]
)
def test_a_caption_of_ones_own_is_that_of_the_drawing(line: str) -> None:
    assert "<title>Eigenes</title>" in printed(*line.split(), "--caption=Eigenes", "-f", "svg").out


def test_a_curve_with_two_greatest_places_that_no_ball_tells_apart_is_drawn() -> None:
    effort = (
        "--bore=300mm",
        "--head-pressure=2bar",
        "--stroke=600mm",
        "--crank-pin=80mm",
        "--pin-friction=0.1",
    )
    paper = printed("forces", *effort, "--columns=rod_force_n", "-f", "svg").out
    assert "Stangenkraft" in paper
