"""Interactive pages: what they deliver for a step is what the command prints for it, letter by letter."""

from __future__ import annotations

import json
import math
import re
from base64 import b64encode
from hashlib import sha256
from itertools import product
from pathlib import Path
from typing import Any

import pytest
from cli import kurbel as run
from cli import printed
from hypothesis import given, settings
from hypothesis import strategies as st

import kurbel
from kurbel.formats.html.live import packed

DATA = re.compile(r'<script type="application/json" class="live-data">(.*?)</script>', re.DOTALL)
SHOWN = re.compile(r'<div class="live-page">\n(.*?)</div>\n<script', re.DOTALL)
MAIN = re.compile(r"<h1.*?</h1>\n(.*?)</main>", re.DOTALL)


def delivered(*words: str) -> tuple[str, dict[str, Any]]:
    """Return an interactive page and its data."""
    page = printed(*words, "--interactive", "-f", "html").out
    data: dict[str, Any] = json.loads(DATA.findall(page)[0])
    return page, data


def static(*words: str) -> str:
    """Return the table of a page that is not interactive, as it stands there."""
    (main,) = MAIN.findall(printed(*words, "-f", "html", "--standalone").out)
    return str(main)


def unpacked(data: dict[str, Any]) -> list[str]:
    """Return the tables of which these are the data."""
    own = [text.split(data["by"]) for text in data["texts"]]
    shapes = [data["shapes"][kind] for kind in data["kinds"]]
    return [
        "".join(gaps[piece] if isinstance(piece, int) else piece for piece in shape)
        for shape, gaps in zip(shapes, own, strict=True)
    ]


# A command with all that it needs, and its options with their steps.
PAGES = [
    ("table --label a --angle 205", {"ratio": ["1:4", "1:4.5"], "offset": ["0.25", "-0.5"]}),
    pytest.param(
        "turning --label a --angle 0;30;60",
        {"ratio": ["1:4", "1:∞"], "eps": ["2", "4"]},
        marks=pytest.mark.slow,
    ),
]


def steps(options: dict[str, list[str]]) -> list[list[str]]:
    """Return the words for each step in the order of a page, the last option first to change."""
    return [*map(list, product(*([f"--{name}={one}" for one in own] for name, own in options.items())))]


@pytest.mark.parametrize(("words", "options"), PAGES)
def test_the_table_of_every_step_is_the_one_that_is_printed_for_it(
    words: str, options: dict[str, list[str]]
) -> None:
    page, data = delivered(*words.split(), *(f"--{name}={';'.join(own)}" for name, own in options.items()))
    assert data["keys"] == list(options)
    expected = [static(*words.split(), *step) for step in steps(options)]
    assert unpacked(data["pages"]) == expected
    # Without JavaScript the page is that of the first step.
    assert SHOWN.findall(page) == [expected[data["start"]]]


@pytest.mark.parametrize(
    ("words", "columns"),
    [
        ("table --ratio 1:4;1:5 --offset 0.3 --to 180 --zero 30 --lang en", "x,c,p"),
        (
            "table --mechanism beam --beam 3 --ratio 1:4;1:5 --lang en",
            "path,velocity,acceleration,rocker,rod",
        ),
        ("forces --eps 2..3 --lang en --ratio 1:4", "piston_force,rod_force,guide_force,tangential_force"),
    ],
)
def test_what_stands_beside_the_mechanism_is_what_csv_prints_for_the_angle(words: str, columns: str) -> None:
    """At every fifth degree of the turn, which the table itself has not."""
    _, data = delivered(*words.split())
    bare = words.replace(" --to 180", "").replace("2..3", "2")
    records = printed(*bare.split(), "--angle=0..360:5", f"--columns={columns}", "-f", "csv").records()
    expected = [[record[key].replace("-", "−") for record in records] for key in columns.split(",")]
    tracks = [data["tracks"][track].split(data["by"]) for step in data["of"] for track in step]
    size, per_step = 73, len(data["of"][0])
    places = [(step, column) for step in range(len(records) // size) for column in range(len(expected))]
    assert [tracks[step * per_step + column] for step, column in places] == [
        expected[column][step * size : (step + 1) * size] for step, column in places
    ]


@pytest.mark.slow
def test_figures_beside_a_mechanism_are_in_the_units_of_its_table() -> None:
    """Long forces stand there in kN, and at the rows of the table they are the same figures."""
    words = ("--stroke=600mm", "--bore=300mm", "--columns=rod_force_n", "--angle=30;90")
    _, data = delivered("forces", "--eps=4", "--ratio=1:5", "--pressure=1bar;8bar", *words)
    assert [data["units"][unit] for unit in data["measured"]] == [[" N"], [" kN"]]
    for step, page in enumerate(unpacked(data["pages"])):
        (track,) = data["of"][step]
        figures = data["tracks"][track].split(data["by"])
        assert [figures[6], figures[18]] == re.findall(r"<td[^>]*>([^<]*)</td>", page)


@pytest.mark.slow
def test_the_links_of_a_mechanism_keep_their_lengths_all_the_turn() -> None:
    """Crank, rod and rocker, from the joints that are delivered, in thousandths of R."""
    for words, lengths in [
        ("table --ratio 1:4 --offset 0,5", {"crank": 1, "rod": 4}),
        ("table --ratio 1:5 --mechanism arc --rocker 6", {"crank": 1, "rod": 5, "rocker": 6}),
        ("table --ratio 1:5 --mechanism beam --beam 3", {"crank": 1, "rod": 5, "rocker": 6}),
        ("table --mechanism parallel", {"crank": 1, "rod": 3}),
    ]:
        _, data = delivered(*words.split())
        joints = [list(zip(flat[::2], flat[1::2], strict=True)) for flat in data["joints"]]
        for kind, start, end, _ in data["scenes"][0]["links"]:
            ends = [joints[end][place % len(joints[end])] for place in range(120)]
            starts = [joints[start][place % len(joints[start])] for place in range(120)]
            found = [math.dist(*pair) / 1000 for pair in zip(starts, ends, strict=True)]
            assert found == pytest.approx([lengths[kind]] * 120, abs=2e-3)
    # The crosshead of the first stays on its way.
    _, data = delivered("table", "--ratio=1:4", "--offset=0,5")
    assert {*data["joints"][data["scenes"][0]["heads"][0]][1::2]} == {500}


def test_a_page_allows_its_own_script_and_nothing_from_elsewhere() -> None:
    page, _ = delivered("table", "--angle=0;90")
    (script,) = re.findall(r"<script>(.*?)</script>", page, re.DOTALL)
    own = b64encode(sha256(script.encode()).digest()).decode()
    (policy,) = re.findall(r'Content-Security-Policy" content="([^"]*)"', page)
    assert policy.startswith("default-src 'none';")
    assert f"script-src 'sha256-{own}';" in policy
    assert not re.search(r"(?:src|href)=\"(?!#|data:,)", page)


def test_the_rows_of_a_page_are_found_by_the_angle_on_both_strokes() -> None:
    _, data = delivered("table", "--ratio=1:5", "--angle=0..180:30")
    rows = dict(zip(data["cursor"]["texts"], data["cursor"]["rows"], strict=True))
    assert [rows[angle] for angle in ("0", "40", "90", "180", "210", "275", "350")] == [0, 1, 3, 6, 1, 3, 6]
    _, data = delivered("table", "--ratio=1:5", "--layout=kolbenwege", "--digits=1")
    assert data["cursor"]["rows"][-1] == 18


@pytest.mark.slow
def test_a_range_of_measures_has_its_unit_once() -> None:
    words = ("table", "--ratio=1:5", "--stroke=0,6m", "--angle=90", "--columns=c_mps")
    _, data = delivered(*words, "--speed=100..140:20/min")
    assert data["texts"] == [["100/min", "120/min", "140/min"]]
    speeds = [printed(*words, f"--speed={one}/min", "-f", "csv").records()[0] for one in (100, 120, 140)]
    assert [data["tracks"][track].split(data["by"])[18] for (track,) in data["of"]] == [
        one["c_mps"].replace(".", ",") for one in speeds
    ]


def test_a_place_in_a_document_of_ones_own_is_not_interactive(tmp_path: Path) -> None:
    document = tmp_path / "own.html"
    document.write_text("<!-- kurbel: table --interactive -->\n<!-- /kurbel -->\n", encoding="utf-8")
    before = document.read_bytes()
    refused = run("inject", str(document))
    assert refused.code == 1
    assert "not for places in a document of your own" in refused.err
    assert document.read_bytes() == before


def test_the_usual_ratios_leave_out_those_with_which_the_drive_does_not_turn() -> None:
    _, data = delivered("table", "--offset=2.5", "--angle=0")
    assert data["texts"] == [["1:4", "1:4,5", "1:5", "1:5,5", "1:6"]]
    assert data["texts"][0][data["start"]] == "1:5"


def test_python_saves_the_page_that_the_command_prints(tmp_path: Path) -> None:
    page = kurbel.table.interactive(["1:5", "1:4"], offset="0.2", angle=[0, 90])
    page.save(tmp_path / "page.html")
    words = ("--ratio=1:5;1:4", "--offset=0.2", "--angle=0;90", "--interactive", "-f", "html")
    assert (tmp_path / "page.html").read_text(encoding="utf-8") == printed("table", *words).out
    assert "live" not in page._repr_html_()


@settings(max_examples=30)
@given(st.lists(st.lists(st.sampled_from(["<td>", "</td>", "0,5", "0|5", "~", "\n", " ", "é"]), max_size=9)))
def test_pages_come_out_of_their_packing_as_they_went_in(pages: list[list[str]]) -> None:
    texts = ["".join(page) for page in pages]
    assert unpacked(json.loads(json.dumps(packed(texts)))) == texts
