"""Drawings: ticks, units and labels on their axes, legends, lines apart; and files of the same bytes."""

from __future__ import annotations

import hashlib
import os
import re
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from drawings import drawn, plotted
from places import SUPPORT
from tools import require_library

import kurbel
from kurbel.page.formula import FUNCTIONS, GREEK, SIGNS, SYMBOLS
from kurbel.plot.style import size_of, style, text_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from matplotlib.text import Text


@pytest.fixture(autouse=True)
def library() -> None:
    require_library("matplotlib")


DRAWINGS: dict[str, Callable[[], kurbel.Drawing]] = {
    "curves": lambda: drawn(kurbel.table, "1:5", step=10, columns="x,c"),
    "polar": lambda: drawn(kurbel.forces, "1:5", step=10, polar=True),
    "mechanism": lambda: kurbel.plot_mechanism([75, 150, 300], ratio="1:4", offset=0.3),
    "arc": lambda: kurbel.plot_mechanism([75, 150, 300], ratio="1:5", mechanism="arc", rocker=6),
    "parallel": lambda: kurbel.plot_mechanism([75, 150, 300], mechanism="parallel"),
    "steam": lambda: drawn(kurbel.turning, 4, ratio="1:5", step=10),
}
FORMATS = {"svg": b"<?xml", "png": b"\x89PNG", "pdf": b"%PDF", "pgf": b"% "}


@cache
def file_of(name: str, form: str) -> bytes:
    return DRAWINGS[name]().image(form)


def texts(figure: Figure) -> list[Text]:
    from matplotlib.text import Text

    return [one for one in figure.findobj(Text) if isinstance(one, Text) and one.get_text()]


# Files ------------------------------------------------------------------------------------------------

HASHES = """
import hashlib, sys
sys.path[:0] = sys.argv[1:]
from test_plotting import DRAWINGS, FORMATS, file_of
for name in DRAWINGS:
    for form in FORMATS:
        print(name, form, hashlib.sha256(file_of(name, form)).hexdigest())
assert "matplotlib.pyplot" not in sys.modules
"""
HOSTILE = "font.family: DejaVu Sans\nlines.linewidth: 9\nsvg.fonttype: none\n"


@pytest.mark.slow
def test_a_drawing_is_the_same_bytes_wherever_and_whenever_it_is_made(tmp_path: Path) -> None:
    paths = (Path(kurbel.__file__).parents[1], Path(__file__).parent, SUPPORT)
    environment = os.environ | {"PYTHONPATH": str(paths[0]), "TZ": "America/Lima", "PYTHONHASHSEED": "2"}
    environment |= {"LC_ALL": "de_DE.UTF-8", "LANG": "de_DE.UTF-8", "SOURCE_DATE_EPOCH": "1000000000"}
    environment |= {"MATPLOTLIBRC": "matplotlibrc"}
    (tmp_path / "matplotlibrc").write_text(HOSTILE)
    code = [sys.executable, "-c", HASHES, *map(str, paths[1:])]
    done = subprocess.run(code, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines() == [
        f"{name} {form} {hashlib.sha256(file_of(name, form)).hexdigest()}"
        for name in DRAWINGS
        for form in FORMATS
    ]


def test_drawing_in_threads_or_twice_changes_no_byte_and_no_setting() -> None:
    import matplotlib

    before = dict(matplotlib.rcParams)
    with ThreadPoolExecutor(3) as pool:
        together = list(pool.map(lambda name: DRAWINGS[name]().image("svg"), ("curves", "polar", "arc")))
    assert together == [file_of(name, "svg") for name in ("curves", "polar", "arc")]
    drawing = DRAWINGS["curves"]()
    assert drawing.image("pdf") == file_of("curves", "pdf") == drawing.image("pdf")
    assert drawing.image("svg") == file_of("curves", "svg")
    assert dict(matplotlib.rcParams) == before


@pytest.mark.parametrize("form", ["svg", "png", "pdf"])
def test_a_file_tells_its_title_but_neither_date_nor_version_nor_home(form: str) -> None:
    file = file_of("parallel", form)
    assert file.startswith(FORMATS[form])
    assert b"Parallelkurbel" in file
    home = f"{Path.home()}/".encode()
    for word in (b"Date", b"dc:date", b"Software", b"Matplotlib", b"matplotlib.org", home):
        assert word not in file


def test_type_is_embedded_in_pdf_and_outlined_in_svg_and_comes_with_matplotlib() -> None:
    import matplotlib
    from matplotlib.font_manager import findfont

    fonts = re.findall(rb"/BaseFont /([A-Z]{6}\+)?(\S+)", file_of("curves", "pdf"))
    assert {(bool(subset), name.split(b"-")[0]) for subset, name in fonts} == {(True, b"STIXGeneral")}
    assert b"/FontFile2" in file_of("curves", "pdf")
    assert b"<text" not in file_of("curves", "svg")
    with style():
        for family in ("STIXGeneral", "STIXGeneral:italic", "STIXSizeOneSym"):
            assert Path(matplotlib.get_data_path()).resolve() in Path(findfont(family)).resolve().parents


# Curves -----------------------------------------------------------------------------------------------


def test_a_value_that_is_no_number_is_a_gap() -> None:
    # At dead centres the crosshead stands, and its velocity has no direction; that of another point turns.
    paper = plotted("table", "--point=0;0.3", "--columns=velocity_direction")
    angles, directions = paper.values("curve-1-1")
    inner = np.arange(0.5, 180, 0.5)
    np.testing.assert_allclose(angles, [*inner, *(180 + inner)], rtol=0, atol=1e-4)
    np.testing.assert_allclose(directions, 359 * [180] + 359 * [0], rtol=0, atol=1e-3)
    assert [paper.line(f"curve-1-{number}").path.count("M") for number in (1, 2)] == [2, 1]
    # A gap takes no room from the labels beside the curves.
    assert not paper.names("legend.*")
    assert {"s = 0", "s = 0,3"} <= set(paper.words)


def test_lines_are_told_apart_without_colour_and_seen_on_white_and_on_dark_paper() -> None:
    paper = plotted("table", "--ratio=1:2..13", "--columns=x")
    looks = [paper.line(name).look for name in paper.names(r"curve-1-\d+")]
    assert len({(one.get("stroke-dasharray"), one["stroke-width"]) for one in looks}) == len(looks) == 12
    assert len({one.get("stroke-dasharray") for one in looks[:6]}) == 6
    for colour in {one["stroke"] for one in looks} - {"currentColor"}:
        # A contrast of 3 is what WCAG 2.1, 1.4.11, asks of lines, here on the paper of dark pages, too.
        assert 1.05 / (luminance(colour) + 0.05) >= 3
        assert (luminance(colour) + 0.05) / (luminance("#1b1b1b") + 0.05) >= 3


def luminance(colour: str) -> float:
    """Return the relative luminance of WCAG 2.1."""
    parts = (int(colour[place : place + 2], 16) / 255 for place in (1, 3, 5))
    linear = (part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts)
    return sum(weight * part for weight, part in zip((0.2126, 0.7152, 0.0722), linear, strict=True))


def test_the_angle_axis_is_shared_and_named_once() -> None:
    drawing = drawn(kurbel.table, "1:5", step=30)
    assert [one.get_text() for one in texts(drawing.figure)].count("Kurbelwinkel $\\varphi$") == 1
    first, *_, last = drawing.figure.axes
    assert list(first.get_xticks()) == list(last.get_xticks()) == list(range(0, 361, 30))
    assert not any(text.get_text() for text in first.get_xticklabels())
    assert first.get_xlim() == last.get_xlim() == (0, 360)
    assert drawing.figure.get_figwidth() * 25.4 == pytest.approx(120)


# Many curves, or few that lie near one another, are named in the legend of the first panel.
CROWDS = {
    "ratios": lambda: drawn(kurbel.table, "1:3..10", columns="x,c", step=15),
    "narrow": lambda: drawn(kurbel.table, "1:3..10", columns="rod_force", width=60, step=15),
    "forces": lambda: drawn(
        kurbel.forces,
        eps=[6, 7, 8, 9],
        ratio="1:5",
        columns="piston_force,crank_pin_force",
        width=85,
        step=15,
    ),
    "heading": lambda: drawn(kurbel.forces, "1:5", force="10kN", stroke="600mm", width=60, step=15),
}


@pytest.mark.parametrize("name", CROWDS)
def test_legends_and_headings_cover_nothing_and_are_read_along_their_rows(name: str) -> None:
    figure = CROWDS[name]().figure
    figure.canvas.draw()
    tops = [figure.bbox.y1, *(axes.bbox.y0 for axes in figure.axes)]
    for axes, above in zip(figure.axes, tops, strict=False):
        headings = [one for one in texts(figure) if one.get_text() == axes.get_title(loc="left")]
        boxes = [one.get_window_extent() for one in headings]
        legend = axes.get_legend()
        assert (legend is not None) == (axes is figure.axes[0] and name != "heading")
        if legend is not None:
            named = legend.get_texts()
            places = [(-round(one.get_window_extent().y0), one.get_window_extent().x0) for one in named]
            numbers = [int(re.findall(r"\d+", one.get_text())[-1]) for one in named]
            order = [number for _, number in sorted(zip(places, numbers, strict=True))]
            assert order == ([6, 7, 8, 9] if name == "forces" else [*range(3, 11)])
            boxes.append(legend.get_window_extent())
        for low, high in pairwise(reversed(boxes)):
            assert not low.overlaps(high)
        for box in boxes:
            assert axes.bbox.y1 - 1 <= box.y0 and box.y1 <= above
            assert figure.bbox.x0 <= box.x0 and box.x1 <= figure.bbox.x1
    if name == "heading":
        assert figure.axes[0].get_title(loc="left").count("\n") >= 1


# Ticks and labels -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("low", "high", "step"),
    [(0, 180, 15), (0, 720, 60), (-90, 270, 30), (0, 90, 10), (0, 7200, 720), (-30, 30, 5)],
)
def test_angle_ticks_divide_the_turn(low: int, high: int, step: float) -> None:
    words = plotted(
        "table", "--columns=x", f"--from={low}", f"--to={high}", f"--step={(high - low) / 16:g}"
    ).words
    found = [one.removesuffix("°") for one in words if re.fullmatch(r"[−\d,]+°", one)]
    ticks = [f"{one:g}".replace(".", ",").replace("-", "−") for one in np.arange(low, high + step / 2, step)]
    assert found[: len(ticks)] == ticks


@pytest.mark.parametrize(("stroke", "step"), [(60, 10), (96, 20), (200, 25), (400, 50), (480, 100)])
def test_ticks_of_values_are_multiples_of_the_least_round_number_that_leaves_them_room(
    stroke: int, step: int
) -> None:
    paper = plotted("table", f"--stroke={stroke}mm", "--columns=x_mm")
    said = ["".join(paper.groups[one].itertext()).strip() for one in paper.names(r"ytick_\d+")]
    assert said == [str(one) for one in range(0, int(said[-1]) + 1, step)]
    # A number needs 7.5 mm; the next smaller round number leaves less.
    length = np.ptp(paper.points("curve-1-1").imag) / stroke
    smaller = {10: 5, 20: 10, 25: 20, 50: 25, 100: 50}
    assert smaller[step] * length < 7.5 <= step * length


@pytest.mark.parametrize(
    ("words", "heading"),
    [
        ("table --stroke=0.004mm --columns=x_mm", "Kolbenweg x in µm"),
        ("forces --eps=3 --pressure=800bar --bore=3m --columns=tangential_kpa", "Tangentialdruck T/A in MPa"),
        ("pressures --eps=4 --pressure=90000bar --bore=3m", "Hingang: Kolbendruck in 103 bar"),
        ("turning --eps=3 --flywheel=50 --speed=300/min", "Drehzahl n/min−1, Mittel nm"),
        ("turning --torque 12000+5000*sin(φ)", "Drehmomente in kN m"),
        ("turning --torque 2500000000+5000*sin(φ)", "Drehmomente in GN m"),
        ("table --stroke=60m --columns=x_mm", "Kolbenweg x in m"),
        ("table --stroke=600mm --speed=6000/min --columns=p_mps2", "Kolbenbeschleunigung p in 103 m/s2"),
        ("table --columns=x", "Kolbenweg x/R"),
        ("table --columns=psi", "Schubstangenwinkel ψ in °"),
    ],
)
def test_a_power_of_ten_goes_to_the_unit_where_it_takes_a_prefix(words: str, heading: str) -> None:
    said = plotted(*words.split()).words
    assert heading in said, said


@pytest.mark.parametrize(
    ("label", "text"),
    [
        ("Kolbenweg $x/R$", "Kolbenweg $x/R$"),
        ("$λ = 1/4.5$", r"$\lambda=1/4{,}5$"),
        ("$a ≤ b$", r"$a\leq b$"),
        ('$5 "kΩ"$', r"$5\,\text{kΩ}$"),
        (r"5 \$, 4 %, a_b", r"5 \$, 4 %, a_b"),
        ("$p$ in m/s²", "$p$ in m/s$^2$"),
        ("$T_L + n_m - H_x$", r"$T_\mathrm{L}+n_\mathrm{m}-H_{x}$"),
        ('$v_1 n_"max"$', r"$v_{1}n_{\text{max}}$"),
        ("Hingang[^a]", "Hingangᵃ⁾"),
    ],
)
def test_labels_become_mathtext(label: str, text: str) -> None:
    assert text_of(label, ",") == text


ATOMS = [f"{one}_1^2" for one in GREEK] + [f"a {one} b" for one in SIGNS] + [f"2{one}" for one in SYMBOLS]
WHOLE = [
    "(sin(φ±ψ))/(cos ψ)", "[1 - cos(α/2 + (a b)/c)]", 'x_("max")', '2.5 "m/s" + 1 "min"^(-1)', 
    "((p R)/v^2)/(a/b)",
]  # fmt: skip


def test_every_formula_that_labels_may_have_can_be_set() -> None:
    with style():
        for formula in [*ATOMS, *(f"{one} x + {one}(y)" for one in sorted(FUNCTIONS)), *WHOLE]:
            width, height = size_of(text_of(f"${formula}$", ","))
            assert 0 < width < 60, formula
            assert 0 < height < 15, formula


# Polar diagram ----------------------------------------------------------------------------------------


def test_every_thirty_degrees_there_is_a_mark_on_the_polar_curve() -> None:
    from matplotlib.lines import Line2D

    figure = drawn(kurbel.forces, "1:4", polar=True, step=10, lang="en").figure
    marks = [one for one in figure.findobj(Line2D) if isinstance(one, Line2D) and one.get_marker() == "o"]
    shown = [(float(np.asarray(one.get_xdata())[0]), float(np.asarray(one.get_ydata())[0])) for one in marks]
    force = kurbel.compute(range(0, 331, 30), "1:4", ["tangential_force", "radial_force"])
    for place in zip(*force.values(), strict=True):
        assert min(np.hypot(*(np.asarray(shown) - place).T)) < 1e-12
    assert len(shown) == 12
    assert {f"{angle}°" for angle in range(0, 331, 30)} <= {one.get_text() for one in texts(figure)}
    assert figure.get_figheight() * 25.4 <= 130


def test_a_force_that_rests_has_no_marks() -> None:
    words = plotted("forces", "--polar", "--eps=3", "--back=0.1", "--single-acting").words
    assert {"0°", "90°", "180°"} <= set(words)
    assert not {"210°", "270°", "360°"} & set(words)
    assert words.count("180°") == 1


@pytest.mark.parametrize(
    "given", [{"ratio": "1:5"}, {"ratio": "1:12", "lang": "en"}, {"eps": 4, "back": 0.1}]
)
def test_the_scale_of_forces_leaves_the_name_of_the_axis_free(given: dict[str, Any]) -> None:
    figure = drawn(kurbel.forces, **given, polar=True).figure
    figure.canvas.draw()
    (heading,) = (one for one in texts(figure) if "Z" in one.get_text())
    scale, *_ = (one for one in texts(figure) if re.fullmatch(r"\$?0[.,{}\d]+\$? ", one.get_text()))
    assert not heading.get_window_extent().overlaps(scale.get_window_extent())
    assert scale.get_window_extent().y1 <= figure.bbox.y1
