"""Drawings that move: where their parts are at any time, measured in the file against the geometry."""

from __future__ import annotations

import cmath
import math
import random
import re
from fractions import Fraction
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from cli import kurbel as kurbel_run
from cli import printed, records
from drawings import Film, film_data
from tools import require_library

import kurbel

# In mm on paper: the most by which a moving part may leave its place, and the way along a drawn line, which
# matplotlib writes with six decimals.
TOLERANCE, EXACT = 0.01, 0.002


@pytest.fixture(autouse=True)
def library() -> None:
    require_library("matplotlib")


def film_of(*words: str) -> Film:
    command, *options = words
    return Film(printed(command, "--animate", *options, "-f", "svg").out)


def still(film: Film, key: str) -> list[complex]:
    return [complex(one) for one in film.points(film.first(key))]


@pytest.mark.parametrize(
    ("rod", "offset"), [(1.0001, 0.0), (2.7, -0.3), pytest.param(8.0, 0.0, marks=pytest.mark.slow)]
)
def test_rod_and_crosshead_are_where_the_crank_leads_them_at_any_time(rod: float, offset: float) -> None:
    chance = random.Random(rod)
    words = [f"--ratio={1 / Fraction(str(rod))}", *([f"--offset={offset}"] if offset else [])]
    film = film_of("plot", *words, f"--positions={chance.randrange(360)}")
    shaft, pin = still(film, "crank")
    radius, drawn = abs(pin - shaft), still(film, "rod")
    assert abs(drawn[1] - drawn[0]) == pytest.approx(rod * radius, abs=EXACT)
    corners = []
    for angle in (film.run[2], *(chance.uniform(0, 360) for _ in range(60))):
        turned = cmath.rect(1, math.radians(angle))
        true = complex(turned.real + math.sqrt(rod**2 - (turned.imag - offset) ** 2), offset)
        ends = film.at("rod", angle)
        # Rigid, so that its length is right between keyframes too; and at both ends where it should be.
        assert abs(ends[1] - ends[0]) == pytest.approx(rod * radius, abs=EXACT)
        assert abs(ends[0] - shaft - radius * turned) < TOLERANCE
        assert abs(ends[1] - shaft - radius * true) < TOLERANCE
        assert abs(film.at("crank", angle)[1] - shaft - radius * turned) < EXACT
        (corner, *_) = film.at("head", angle)
        corners.append(corner - radius * true)
    # What does not turn is not turned in its style sheet.
    assert [len(film.numbers(part, 0)) for part in ("crank", "rod", "head")] == [3, 3, 2]
    assert max(abs(one - corners[0]) for one in corners) < TOLERANCE


@pytest.mark.parametrize(
    "words",
    [
        ("--mechanism=arc", "--rocker=6"),
        pytest.param(("--mechanism=beam", "--beam=3", "--ratio=1:4"), marks=pytest.mark.slow),
    ],
)
def test_links_of_a_rocker_meet_and_keep_their_length(words: tuple[str, ...]) -> None:
    film, chance = film_of("plot", *words, "--positions=40"), random.Random(7)
    shaft, pin = still(film, "crank")
    rod, rocker = (still(film, one) for one in ("rod", "rocker"))
    lengths = abs(rod[1] - rod[0]), abs(rocker[1] - rocker[0])
    pivot = rocker[1] if words[0].endswith("arc") else (rocker[0] + rocker[1]) / 2
    for angle in (chance.uniform(0, 360) for _ in range(60)):
        rods = film.at("rod", angle)
        rockers = film.at("rocker", angle)
        turned = cmath.rect(abs(pin - shaft), math.radians(angle))
        middle = rockers[1] if words[0].endswith("arc") else (rockers[0] + rockers[1]) / 2
        assert abs(rods[0] - shaft - turned) < TOLERANCE
        assert abs(rods[1] - rockers[0]) < 2 * TOLERANCE
        assert abs(middle - pivot) < TOLERANCE
        assert (abs(rods[1] - rods[0]), abs(rockers[1] - rockers[0])) == pytest.approx(lengths, abs=EXACT)


@pytest.mark.parametrize(("point", "joined"), [("0.5,0.2", 2), ("1.3", 1), ("0.4", 0), ("0", 0), ("1", 0)])
def test_a_point_that_is_not_on_the_rod_hangs_on_its_ends(point: str, joined: int) -> None:
    film, chance = film_of("plot", "--ratio=1:3", f"--point={point}", "--positions=40"), random.Random(point)
    arms = [f"point-1-arm-{number + 1}" for number in range(joined)]
    assert sum("-arm-" in name for name in film.frames) == joined
    share, beside = (float(one) for one in f"{point},0".split(",")[:2])
    for angle in (chance.uniform(0, 360) for _ in range(30)):
        pin, head = film.at("rod", angle)
        place = head + complex(share, -beside) * (pin - head)
        for arm, end in zip(arms, (pin, head), strict=False):
            start, tip = film.at(arm, angle)
            assert abs(start - end) < TOLERANCE
            assert abs(tip - place) < 2 * TOLERANCE


def test_dots_run_on_their_curves() -> None:
    film, chance = film_of("table", "--ratio=1:3"), random.Random(3)
    for number in (1, 2, 3):
        line = film.points(f"curve-{number}-1")
        for angle in (0, 360, *(chance.uniform(0, 360) for _ in range(40))):
            (dot,) = film.at(f"dot-{number}-1", angle)
            assert dot.real == pytest.approx(
                line[0].real + angle / 360 * (line[-1].real - line[0].real), abs=TOLERANCE
            )
            assert abs(dot.imag - np.interp(dot.real, line.real, line.imag)) < TOLERANCE


def test_where_steam_changes_sides_dots_jump_and_in_a_polar_diagram_one_runs() -> None:
    film = film_of("forces", "--eps=4", "--ratio=1:4", "--columns=piston_force")
    (before, after) = (film.at("dot-1-1", 180 + step)[0] for step in (-0.01, 0.01))
    # From Q of expanded steam behind the piston to Q of fresh steam before it.
    assert before.imag - after.imag > 20
    polar = film_of("forces", "--polar", "--ratio=1:4")
    places = {angle: polar.at("dot", angle)[0] for angle in (0, 90, 180, 77.3)}
    # At both dead centres the force is radial; at right angles its radial part is that of the slanted rod.
    unit = (places[180] - places[0]) / 2
    for angle in (90, 77.3):
        (row,) = records("forces", "--ratio=1:4", "--force=1N", f"--angle={angle}", "--digits=9")
        tangential, radial = (float(row[f"{key}_force_n"]) for key in ("tangential", "radial"))
        assert abs(places[angle] - places[0] - unit + unit * radial - unit * 1j * tangential) < TOLERANCE


def test_a_film_stands_still_for_those_who_ask_for_that_and_is_the_same_file_every_time() -> None:
    words = ("plot", "--animate", "--positions=30;120", "--ratio=1:4", "--seconds=4", "-f", "svg")
    file = printed(*words).out
    film = Film(file)
    assert film.run == (0, 360, 30, 4)
    reduced = re.search(
        r"@media \(prefers-reduced-motion:reduce\)\{(.*)\{animation-play-state:paused\}\}", film.sheet
    )
    assert reduced is not None
    assert {*reduced[1].replace("#", "").split(",")} == film.moving == film.rules.keys()
    # It begins where it is drawn: 30° are a twelfth of 4 s.
    assert "animation:4s linear -0.333333s infinite" in film.sheet
    assert film.title
    assert "<script" not in file
    assert printed(*words).out == file


def test_a_turn_takes_as_long_wherever_it_begins() -> None:
    words = ("table", "--ratio=1:4", "--animate", "--seconds=4", "-f", "svg")
    for ends, seconds in (((0, 360), 4), ((360, 720), 4), ((90, 810), 8)):
        film = Film(
            printed(*words, *(f"--{name}={end}" for name, end in zip(("from", "to"), ends, strict=True))).out
        )
        assert f"animation:{seconds}s linear" in film.sheet, ends
    # The arc of the angle, full at 720°, begins anew at 360°.
    assert film.numbers("arc", 360.1)[0] == pytest.approx(2 * film.numbers("arc", 540)[0], rel=1e-3)


def test_a_gif_has_the_pictures_of_a_turn_and_links_of_their_length(tmp_path: Path) -> None:
    from PIL import Image

    drawing = kurbel.plot_mechanism(0, ratio="1:3", animate=True, seconds=1, width=90)
    content = drawing.image("gif")
    assert content == drawing.image("gif")
    with Image.open(BytesIO(content)) as picture:
        assert (getattr(picture, "n_frames", 1), picture.info["loop"]) == (20, 0)
        shaft, pin = still(Film(drawing.image("svg")), "crank")
        # Dots per mm.
        scale = 150 / 25.4
        times = 0
        for number in range(20):
            picture.seek(number)
            times += picture.info["duration"]
            grey = np.asarray(picture.convert("L"), float)
            angle = math.radians(18 * number)
            radius = abs(pin - shaft)
            start = shaft + cmath.rect(radius, angle)
            end = shaft + radius * (math.cos(angle) + math.sqrt(9 - math.sin(angle) ** 2))
            along = (end - start) / abs(end - start)
            for share in (0.25, 0.5, 0.75):
                place = start + share * (end - start)
                # Across the rod, the darkest of a row of points is on it: half a dot is 0.08 mm.
                row = [place + along * 1j * step / 4 / scale for step in range(-24, 25)]
                dark = [grey[int(-one.imag * scale), int(one.real * scale)] for one in row]
                assert min(dark[20:29]) < 90, (number, share)
        assert times == 1000


def test_numbers_beside_the_slider_are_those_of_the_table() -> None:
    words = ("plot", "--animate", "--positions=0", "--ratio=1:4", "-f", "html", "--lang=en")
    page = printed(*words).out
    assert printed(*words).out == page
    assert 'aria-label="Values at the crank angle"' in page
    rows = records("table", "--ratio=1:4", "--columns=x,c,p", "--angle=0..360:1")
    told = [[one.replace("\u2212", "-") for one in values] for values in film_data(page)["values"]]
    assert told == [[row[key] for row in rows] for key in ("x", "c", "p")]


MANIFEST = """
title = "Turns"
lang = "en"
formats = ["html", "latex"]
[[chapter]]
title = "Cranks"
[[chapter.part]]
run = "plot --animate --positions 30 --ratio 1:4"
name = "turn"
caption = "The drive turns"
"""


def test_a_handbook_in_html_takes_it_and_in_print_it_stands_still(tmp_path: Path) -> None:
    (tmp_path / "handbook.toml").write_text(MANIFEST, encoding="utf-8")
    assert kurbel_run("handbook", "build", str(tmp_path)).code == 0
    page = (tmp_path / "pages" / "handbook.html").read_text(encoding="utf-8")
    assert film_data(page)["start"] == 30
    names = re.findall(r'id="([\w-]+-film-[\w-]+)"', page)
    assert "fig-turn-film-rod-1" in names
    for name in names:
        assert f"#{name}{{animation-name:" in page
    assert 'aria-labelledby="fig-turn-title"' in page
    assert "'unsafe-inline'; script-src 'sha256-" in page
    assert (tmp_path / "pages" / "figures" / "turn.pdf").read_bytes().startswith(b"%PDF")
