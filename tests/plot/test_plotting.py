"""Drawings: what is drawn is what was given, labels follow the language, and files are the same bytes."""

from __future__ import annotations

import hashlib
import math
import os
import re
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest
from places import SUPPORT
from tools import require_library

import kurbel
from kurbel.drive.crank import Crank
from kurbel.errors import ChoiceError, MissingExtraError, ProblemError
from kurbel.linkage.arc.crank import ArcCrank
from kurbel.linkage.parallel import SHAFTS, ParallelCrank
from kurbel.page.formula import FUNCTIONS, GREEK, SIGNS, SYMBOLS
from kurbel.plot import style as plot_style
from kurbel.plot.arc import arc_mechanism, arc_position
from kurbel.plot.chart.model import Curve, Panel
from kurbel.plot.chart.vector import PinForce, Vector
from kurbel.plot.links import outlined
from kurbel.plot.mechanism import LONGEST_ROD, mechanism, position
from kurbel.plot.place import BESIDE, around, beside, densely, freest
from kurbel.plot.plotting import curves
from kurbel.plot.polar import polar
from kurbel.plot.sketch import Point
from kurbel.plot.style import LINES, image, text_of
from kurbel.plot.ticks import angle_ticks, axis_label, measure, power_of_thousand, round_step, value_ticks
from kurbel.reading.extras import how_to_install

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D
    from matplotlib.text import Text


@pytest.fixture
def library() -> None:
    """Skip a test without matplotlib, or fail it where nothing may be missing."""
    require_library("matplotlib")


drawn = pytest.mark.usefixtures("library")

ANGLES = [float(angle) for angle in range(0, 361, 5)]
SINES = [1.25 * math.sin(math.radians(angle)) for angle in ANGLES]
COSINES = [0.75 * math.cos(math.radians(angle + 20)) for angle in ANGLES]
PANEL = Panel([Curve("$c/v$", ANGLES, SINES), Curve("$x/R$", ANGLES, COSINES)], "")


# Rockers above and below the slide, with pivots of their own, and one that swings far.
ARCS = (
    ArcCrank(Crank(Fraction(1, 5)), Fraction(6)),
    ArcCrank(Crank(Fraction(1, 4), Fraction(3, 10)), Fraction(3)),
    ArcCrank(Crank(Fraction(1, 5)), Fraction(4), Fraction(4), Fraction(-7, 2)),
    ArcCrank(Crank(Fraction(1, 3)), Fraction(3), Fraction(18, 5), Fraction(0)),
    ArcCrank(Crank(Fraction(1, 12)), Fraction(12)),
)


def two_panels(mark: str = ",") -> Figure:
    return curves([PANEL, Panel([Curve("", ANGLES, SINES)], "$M$", "N m")], "de", mark)


def polar_of(
    vector: Vector, across: str, up: str, unit: str, mark: str, ways: tuple[str, str] = ("", "")
) -> Figure:
    return polar(PinForce(vector, (across, up), unit), mark, ways)


def diagram() -> Figure:
    return polar_of(Vector(ANGLES, SINES, COSINES), "$X$", "$Y$", "kN", ",")


def sketch() -> Figure:
    return mechanism(0.25, 0.3, [Fraction(75), 150, 300], "de", ",")


def arc_sketch() -> Figure:
    return arc_mechanism(ARCS[0], [Fraction(75), 150, 300], "de", ",")


def parallel_sketch() -> Figure:
    return outlined(ParallelCrank().outline(), [Fraction(75), 150, 300], ",")


DRAWINGS: dict[str, Callable[[], Figure]] = {
    "curves": two_panels,
    "polar": diagram,
    "mechanism": sketch,
    "arc": arc_sketch,
    "parallel": parallel_sketch,
}


def artist(figure: Figure, name: str) -> Line2D:
    from matplotlib.lines import Line2D

    found = figure.findobj(lambda one: one.get_gid() == name)
    assert len(found) == 1
    assert isinstance(found[0], Line2D)
    return found[0]


def texts(figure: Figure) -> list[str]:
    return [one.get_text() for one in texts_of(figure)]


def texts_of(figure: Figure) -> list[Text]:
    from matplotlib.text import Text

    return [one for one in figure.findobj(Text) if isinstance(one, Text) and one.get_text()]


def drawn_length(line: Line2D) -> float:
    (x0, x1), (y0, y1) = np.asarray(line.get_xdata()), np.asarray(line.get_ydata())
    return math.dist((x0, y0), (x1, y1))


# Files ------------------------------------------------------------------------------------------------


TITLE = "Kurbeltrieb"
HASHES = """
import hashlib, sys
sys.path[:0] = sys.argv[1:]
from test_plotting import DRAWINGS, file_of
from kurbel.plot.style import FORMATS
for name in DRAWINGS:
    for form in FORMATS:
        print(name, form, hashlib.sha256(file_of(name, form)).hexdigest())
assert "matplotlib.pyplot" not in sys.modules
"""
HOSTILE = "font.family: DejaVu Sans\nlines.linewidth: 9\nsvg.fonttype: none\n"


@cache
def file_of(name: str, form: str) -> bytes:
    return image(DRAWINGS[name](), form, TITLE)


@pytest.mark.slow
@drawn
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
        for form in plot_style.FORMATS
    ]


@drawn
def test_drawing_in_threads_changes_no_byte() -> None:
    with ThreadPoolExecutor(3) as pool:
        together = list(pool.map(lambda draw: image(draw(), "svg", TITLE), DRAWINGS.values()))
    assert together == [file_of(name, "svg") for name in DRAWINGS]


@drawn
def test_saving_twice_gives_the_same_bytes() -> None:
    figure = sketch()
    for form in ("pdf", "svg", "png", "pdf", "png"):
        assert image(figure, form) == image(sketch(), form)


@drawn
def test_matplotlibs_settings_are_as_they_were() -> None:
    import matplotlib

    before = dict(matplotlib.rcParams)
    image(two_panels(), "svg")
    assert dict(matplotlib.rcParams) == before


@drawn
@pytest.mark.parametrize(("form", "start"), [("svg", b"<?xml"), ("png", b"\x89PNG"), ("pdf", b"%PDF")])
@pytest.mark.parametrize("name", DRAWINGS)
def test_a_file_tells_its_title_but_neither_date_nor_version(name: str, form: str, start: bytes) -> None:
    file = file_of(name, form)
    assert file.startswith(start)
    assert TITLE.encode() in file
    for word in (
        b"Date",
        b"dc:date",
        b"Software",
        b"Matplotlib",
        b"matplotlib.org",
        str(Path.home()).encode() + b"/",
    ):
        assert word not in file


@drawn
def test_type_is_embedded_in_pdf_and_outlined_in_svg() -> None:
    file = image(two_panels(), "pdf")
    fonts = re.findall(rb"/BaseFont /([A-Z]{6}\+)?(\S+)", file)
    assert {(bool(subset), name.split(b"-")[0]) for subset, name in fonts} == {(True, b"STIXGeneral")}
    assert b"/FontFile2" in file
    assert b"<text" not in image(two_panels(), "svg")


@drawn
def test_the_fonts_are_those_that_matplotlib_brings_along() -> None:
    import matplotlib
    from matplotlib.font_manager import findfont

    own = Path(matplotlib.get_data_path())
    with plot_style.style():
        for family in ("STIXGeneral", "STIXGeneral:italic", "STIXSizeOneSym"):
            assert own in Path(findfont(family)).parents


def test_without_matplotlib_the_command_that_installs_it_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    for draw in DRAWINGS.values():
        with pytest.raises(MissingExtraError) as error:
            draw()
        sentence = f"drawings need matplotlib; install it with: {how_to_install('plot')}"
        assert str(error.value) == sentence


@drawn
def test_an_unknown_format_is_named() -> None:
    with pytest.raises(ChoiceError, match=r'there is no drawing format "gif".*; choose from svg, png, pdf'):
        image(sketch(), "gif")


# Curves -----------------------------------------------------------------------------------------------


@drawn
def test_the_points_of_a_curve_are_those_that_were_given() -> None:
    figure = two_panels()
    for name, values in (("curve-1-1", SINES), ("curve-1-2", COSINES), ("curve-2-1", SINES)):
        line = artist(figure, name)
        assert list(np.asarray(line.get_xdata())) == ANGLES
        assert list(np.asarray(line.get_ydata())) == values


@drawn
def test_svg_has_a_stroke_for_every_point() -> None:
    angles = [angle / 10 for angle in range(3601)]
    panel = Panel([Curve("", angles, [math.sin(math.radians(angle)) for angle in angles])], "$c/v$")
    file = image(curves([panel], "de", ","), "svg").decode()
    path = file[file.index('id="curve-1-1"') :]
    assert path[: path.index("clip")].count("\nL ") >= 3600 or path[: path.index("/>")].count("\nL ") == 3600


@drawn
@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
def test_a_value_that_is_no_number_is_a_gap(bad: float) -> None:
    values = [*SINES[:10], bad, *SINES[11:]]
    figure = curves([Panel([Curve("", ANGLES, values)], "$c/v$")], "de", ",")
    shown = np.asarray(artist(figure, "curve-1-1").get_ydata(), float)
    assert list(np.flatnonzero(np.isnan(shown))) == [10]
    assert all(map(math.isfinite, figure.axes[0].get_ylim()))


LEAP = Curve("$F$", [0.0, 90.0, 180.0, 180.0, 270.0, 360.0, 360.0], [3.0, 2.0, 1.0, -3.0, -2.0, -1.0, 3.0])


@drawn
def test_where_a_value_jumps_the_curve_is_broken_and_a_thin_line_joins_its_ends() -> None:
    figure = curves([Panel([LEAP], "$F$")], "de", ",")
    curve, jumps = artist(figure, "curve-1-1"), artist(figure, "jumps-1-1")
    assert list(np.asarray(curve.get_xdata())) == [0, 90, 180, 180, 180, 270, 360, 360, 360]
    np.testing.assert_array_equal(
        np.asarray(curve.get_ydata(), float), [3, 2, 1, math.nan, -3, -2, -1, math.nan, 3]
    )
    assert list(np.asarray(jumps.get_xdata())) == [180, 180, 180, 360, 360, 360]
    np.testing.assert_array_equal(np.asarray(jumps.get_ydata(), float), [1, -3, math.nan, -1, 3, math.nan])
    assert jumps.get_linewidth() < curve.get_linewidth() / 2
    assert jumps.get_color() == curve.get_color()
    assert not two_panels().findobj(lambda one: str(one.get_gid()).startswith("jumps"))


@drawn
@pytest.mark.parametrize("labelled", [True, False])
def test_a_heading_wider_than_the_panel_is_set_in_rows(labelled: bool) -> None:
    names = [f"$F_{number}$" if labelled else "" for number in range(5)]
    crowd = [Curve(name, ANGLES, [value + 3 * n for value in SINES]) for n, name in enumerate(names)]
    heading = "Kolbenkraft, Führungsdruck, Tangentialkraft, Radialkraft und Kraft am Kurbelzapfen in $10^3$ N"
    figure = curves([PANEL, Panel(crowd, heading)], "de", ",")
    figure.canvas.draw()
    above, axes = figure.axes
    (title,) = (one for one in texts_of(figure) if one.get_text() == axes.get_title(loc="left"))
    assert title.get_text().count("\n") == 1
    assert title.get_text().replace("\n", " ") == text_of(heading, ",")
    box = title.get_window_extent()
    assert box.x1 <= figure.bbox.x1
    tops = [box.y1]
    if legend := axes.get_legend():
        tops.append(legend.get_window_extent().y1)
        assert box.y1 <= legend.get_window_extent().y0 + 1
    assert (legend is not None) == labelled
    assert max(tops) <= above.bbox.y0


def test_a_panel_without_any_number_is_refused() -> None:
    empty = Panel([Curve("", [0.0, 1.0], [math.nan, math.inf])], "$c/v$")
    with pytest.raises(ProblemError, match="no finite value"):
        curves([empty], "de", ",")


def test_a_single_angle_is_refused() -> None:
    with pytest.raises(ProblemError, match="the only crank angle is 30°; a curve needs two"):
        curves([Panel([Curve("", [30.0], [1.0])], "")], "de", ",")


@drawn
@pytest.mark.parametrize(("mark", "half"), [(",", "−0,5"), (".", "−0.5")])
def test_numbers_have_the_mark_of_the_language_and_a_true_minus(mark: str, half: str) -> None:
    words = texts(two_panels(mark))
    assert half in words
    for word in words:
        assert not re.search(r"-\d", word)
        assert not re.search(rf"\d[{',.'.replace(mark, '')}]\d", word)


@drawn
def test_the_angle_axis_is_shared_and_named_once() -> None:
    figure = two_panels()
    assert texts(figure).count("Kurbelwinkel $\\varphi$") == 1
    first, last = figure.axes
    assert list(first.get_xticks()) == list(last.get_xticks()) == list(range(0, 361, 30))
    assert [text.get_text() for text in last.get_xticklabels()][:3] == ["0°", "30°", "60°"]
    assert not any(text.get_text() for text in first.get_xticklabels())
    assert first.get_xlim() == last.get_xlim() == (0, 360)


@drawn
@pytest.mark.parametrize("count", [1, 2, 3])
def test_a_drawing_is_as_wide_as_the_type_area(count: int) -> None:
    for figure in (curves([PANEL] * count, "en", "."), sketch()):
        assert figure.get_figwidth() * 25.4 == pytest.approx(120)


@drawn
def test_a_few_curves_are_labelled_beside_them_and_many_in_a_legend() -> None:
    assert curves([PANEL], "de", ",").axes[0].get_legend() is None
    crowd = [Curve(f"$1:{n}$", ANGLES, [value + n / 99 for value in SINES]) for n in range(3, 6)]
    legend = curves([Panel(crowd, "$c/v$")], "de", ",").axes[0].get_legend()
    assert legend is not None
    assert [text.get_text() for text in legend.get_texts()] == [rf"$1\text{{:}}{n}$" for n in (3, 4, 5)]


@drawn
def test_a_legend_is_read_along_its_rows() -> None:
    crowd = [Curve(f"curve number {n}", ANGLES, [value + n / 99 for value in SINES]) for n in range(8)]
    figure = curves([Panel(crowd, "$c/v$")], "de", ",")
    image(figure, "svg")
    legend = figure.axes[0].get_legend()
    assert legend is not None
    places = [
        (-round(text.get_window_extent().y0), text.get_window_extent().x0) for text in legend.get_texts()
    ]
    names = [text.get_text() for text in legend.get_texts()]
    assert [name for _, name in sorted(zip(places, names, strict=True))] == [one.label for one in crowd]


@drawn
@pytest.mark.parametrize(
    "heading", ["a heading", "a heading that is nearly as wide as the panel, and then some"]
)
def test_a_legend_covers_neither_heading_nor_panel(heading: str) -> None:
    crowd = [Curve(f"curve number {n}", ANGLES, [value + n / 99 for value in SINES]) for n in range(8)]
    figure = curves([PANEL, Panel(crowd, heading)], "de", ",")
    image(figure, "svg")
    above, axes = figure.axes
    legend = axes.get_legend()
    assert legend is not None
    box = legend.get_window_extent()
    (title,) = (one for one in texts_of(figure) if one.get_text() == axes.get_title(loc="left"))
    assert not box.overlaps(title.get_window_extent())
    assert axes.bbox.y1 - 1 <= box.y0
    assert box.y1 <= above.bbox.y0
    assert figure.bbox.x0 <= box.x0 and box.x1 <= figure.bbox.x1


@drawn
def test_panels_of_like_curves_share_the_legend_of_the_first() -> None:
    near = [curve._replace(values=[value / 99 for value in SINES]) for curve in PANEL.curves]
    first, second = curves([PANEL, Panel(near, "$x/R$")], "de", ",").axes
    assert first.get_legend() is not None
    assert second.get_legend() is None
    assert not first.texts and not second.texts
    for axes in curves([PANEL, PANEL], "de", ",").axes:
        assert axes.get_legend() is None
        assert len(axes.texts) == 2


def test_more_curves_than_can_be_told_apart_are_refused() -> None:
    crowd = [Curve(str(number), ANGLES, SINES) for number in range(len(LINES) + 1)]
    with pytest.raises(ProblemError, match="a panel of 13 curves was asked for; at most 12"):
        curves([Panel(crowd, "")], "de", ",")


# The paper of dark pages, as browsers and editors have it.
DARK = "#1b1b1b"


def test_lines_are_told_apart_without_colour_and_seen_on_white_and_on_dark_paper() -> None:
    assert len({(line.dashes, line.width) for line in LINES}) == len(LINES) == 12
    assert len({line.dashes for line in LINES[:6]}) == 6
    for line in LINES:
        # A contrast of 3 is what WCAG 2.1, 1.4.11, asks of lines.
        assert 1.05 / (luminance(line.colour) + 0.05) >= 3
        # SVG's black is there the colour of the text.
        dark = (luminance(line.colour) + 0.05) / (luminance(DARK) + 0.05)
        assert dark >= 3 or line.colour == plot_style.BLACK


def luminance(colour: str) -> float:
    """Return the relative luminance of WCAG 2.1."""
    parts = (int(colour[place : place + 2], 16) / 255 for place in (1, 3, 5))
    linear = (part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts)
    return sum(weight * part for weight, part in zip((0.2126, 0.7152, 0.0722), linear, strict=True))


# Ticks and labels -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("least", "step"),
    [(0.11, "0.2"), (0.2, "0.2"), (0.21, "0.25"), (0.3, "0.5"), (6.0, "10"), (1e-9, "1e-9")],
)
def test_steps_are_round(least: float, step: str) -> None:
    assert float(round_step(least)) == pytest.approx(float(step), rel=1e-12)


def test_ticks_are_exact() -> None:
    ticks = value_ticks(-0.31, 0.3, Fraction(1, 10), 0, ",")
    assert ticks.places == (-0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3)
    assert ticks.texts == ("−0,3", "−0,2", "−0,1", "0,0", "0,1", "0,2", "0,3")


@pytest.mark.parametrize(
    ("low", "high", "step"),
    [(0, 360, 30), (0, 180, 15), (0, 720, 60), (-90, 270, 30), (0, 90, 10), (0, 7200, 720), (0, 4, 0.5)],
)
def test_angle_ticks_divide_the_turn(low: float, high: float, step: float) -> None:
    places = angle_ticks(low, high, ",").places
    assert places == tuple(np.arange(low, high + step / 2, step))


def test_angles_have_signs_and_marks_of_print() -> None:
    assert angle_ticks(-30, 30, ",").texts[0] == "−30°"
    assert angle_ticks(0, 4, ",").texts[1] == "0,5°"


@pytest.mark.parametrize(
    ("values", "power", "label"),
    [
        ((3.0, -900.0), 0, "$M$ in N m"),
        ((12_000.0,), 3, "$M$ in kN m"),
        ((2.5e6,), 6, "$M$ in MN m"),
        ((4e-4,), -6, "$M$ in µN m"),
        ((0.0,), 0, "$M$ in N m"),
    ],
)
def test_a_power_of_ten_goes_to_the_unit(values: tuple[float, ...], power: int, label: str) -> None:
    assert power_of_thousand(values) == power
    assert axis_label("$M$", "N m", power) == label


@pytest.mark.parametrize(
    ("unit", "power", "shown"),
    [
        ("kPa", 3, "MPa"), ("mm", 3, "m"), ("mm", -3, "µm"), ("kW", -3, "W"), ("N m", 15, "$10^15$ N m"),
        ("m/s²", 3, "$10^3$ m/s²"), ("min⁻¹", 3, "$10^3$ min⁻¹"), ("bar", -3, "$10^(-3)$ bar"),
        ("", 3, "$10^3$"),
    ],
)  # fmt: skip
def test_the_power_is_a_prefix_of_the_unit_where_it_takes_one(unit: str, power: int, shown: str) -> None:
    assert measure(unit, power) == shown


def test_a_label_without_unit_or_name_has_no_in() -> None:
    assert (axis_label("$x/R$", ""), axis_label("", "kN")) == ("$x/R$", "kN")


@pytest.mark.parametrize(
    ("label", "text"),
    [
        ("Kolbenweg $x/R$", "Kolbenweg $x/R$"),
        ("$λ = 1/4.5$", r"$\lambda=1/4{,}5$"),
        ("$a ≤ b$", r"$a\leq b$"),
        ("$φ$", r"$\varphi$"),
        ('$5 "°C"$', r"$5\,\text{°C}$"),
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
FORMULAS = [*ATOMS, *(f"{one} x + {one}(y)" for one in sorted(FUNCTIONS)), *WHOLE]


@drawn
def test_every_formula_that_labels_may_have_can_be_set() -> None:
    with plot_style.style():
        for formula in FORMULAS:
            width, height = plot_style.size_of(text_of(f"${formula}$", ","))
            assert 0 < width < 60, formula
            assert 0 < height < 15, formula


# Places of labels -------------------------------------------------------------------------------------


def test_a_label_is_put_where_most_room_is() -> None:
    line = densely(np.asarray([(0.0, 10.0), (40.0, 10.0)]))
    other = densely(np.asarray([(0.0, 16.0), (40.0, 11.0)]))
    size = (4.0, 2.0)
    place = freest(beside(line, size), size, line, other, (0, 0, 40, 40), BESIDE)
    assert place is not None
    assert place[1] < 10
    assert abs(place[1] - 10) - 1 >= 0.6


def test_a_label_without_room_is_not_put() -> None:
    line = densely(np.asarray([(0.0, 10.0), (40.0, 10.0)]))
    walls = [densely(np.asarray([(0.0, y), (40.0, y)])) for y in (8.0, 12.0)]
    size = (4.0, 2.0)
    assert freest(beside(line, size), size, line, np.concatenate(walls), (0, 0, 40, 40), BESIDE) is None


def test_a_label_around_a_point_begins_outward() -> None:
    first = around(np.asarray((5.0, 5.0)), (3.0, 2.0), np.asarray((0.0, -2.0)))[0]
    assert first == pytest.approx((5.0, 5.0 - 1.0 - 0.8))


def test_points_on_a_line_are_neither_far_apart_nor_crowded() -> None:
    for count in (2, 7, 5000):
        points = densely(np.stack((np.linspace(0, 40, count), np.zeros(count)), axis=1), 0.5)
        assert 75 <= len(points) <= 90
        assert np.diff(points[:, 0]).max() <= 1.0


def test_points_on_a_line_leave_out_its_gaps() -> None:
    points = densely(np.asarray([(0.0, 0.0), (2.0, 0.0), (math.nan, math.nan), (8.0, 0.0), (9.0, 0.0)]))
    assert np.isfinite(points).all()
    assert not ((points[:, 0] > 2) & (points[:, 0] < 8)).any()


# Polar diagram ----------------------------------------------------------------------------------------


@drawn
def test_the_polar_curve_goes_through_the_given_vectors() -> None:
    line = artist(diagram(), "curve")
    assert list(np.asarray(line.get_xdata())) == SINES
    assert list(np.asarray(line.get_ydata())) == COSINES


@drawn
@pytest.mark.parametrize("sign", [1, -1])
def test_curve_and_origin_lie_within_the_polar_diagram(sign: int) -> None:
    across, up = ([sign * (value + 3) for value in component] for component in (SINES, COSINES))
    figure = polar_of(Vector(ANGLES, across, up), "$X$", "$Y$", "kN", ",")
    for values, (low, high) in ((across, figure.axes[0].get_xlim()), (up, figure.axes[0].get_ylim())):
        assert low < min(*values, 0) and max(*values, 0) < high
    width, height = figure.get_size_inches() * 25.4
    assert width <= 120.001
    assert height <= 130


@drawn
def test_both_axes_of_the_polar_diagram_have_one_scale() -> None:
    for across, up in ((SINES, COSINES), (SINES, [0.1 * one for one in COSINES]), ([0.0] * 73, SINES)):
        axes = polar_of(Vector(ANGLES, across, up), "$X$", "$Y$", "kN", ",").axes[0]
        (x0, y0), (x1, y1) = axes.transData.transform([(0, 0), (1, 1)])
        assert x1 - x0 == pytest.approx(y1 - y0, rel=1e-9)
        steps = np.concatenate((np.diff(axes.get_xticks()), np.diff(axes.get_yticks())))
        assert steps == pytest.approx(steps[0])


@drawn
def test_every_thirty_degrees_there_is_a_mark_on_the_curve() -> None:
    figure = diagram()
    from matplotlib.lines import Line2D

    marks = [one for one in figure.findobj(Line2D) if isinstance(one, Line2D) and one.get_marker() == "o"]
    shown = {(float(np.asarray(one.get_xdata())[0]), float(np.asarray(one.get_ydata())[0])) for one in marks}
    places = [ANGLES.index(angle) for angle in range(0, 331, 30)]
    assert shown == {(SINES[place], COSINES[place]) for place in places}
    assert {f"{angle}°" for angle in range(0, 331, 30)} <= set(texts(figure))


@drawn
def test_gaps_in_the_force_stay_gaps() -> None:
    across = [*SINES[:6], math.inf, *SINES[7:]]
    figure = polar_of(Vector(ANGLES, across, COSINES), "$X$", "$Y$", "kN", ",")
    line = artist(figure, "curve")
    assert list(np.flatnonzero(np.isnan(np.asarray(line.get_ydata(), float)))) == [6]
    assert "30°" not in texts(figure)


LEAPS = Vector(
    [0.0, 60.0, 120.0, 180.0, 180.0, 240.0, 300.0, 360.0],
    [0.0, 2.0, 1.5, 0.0, 0.0, 1.5, 1.0, 0.0],
    [3.0, 1.5, -0.5, -1.0, 4.0, 1.5, -1.0, -2.0],
)


@drawn
def test_where_the_force_jumps_a_chord_leads_from_end_to_end() -> None:
    figure = polar_of(LEAPS, "$X$", "$Y$", "kN", ",")
    line = artist(figure, "curve")
    assert list(np.flatnonzero(np.isnan(np.asarray(line.get_ydata(), float)))) == [4]
    ends = {"chord-1": [-1, 4], "chord-2": [-2, 3]}
    for name, up in ends.items():
        chord = artist(figure, name)
        assert list(np.asarray(chord.get_xdata())) == [0, 0]
        assert list(np.asarray(chord.get_ydata())) == up
        assert chord.is_dashed()
    words = texts(figure)
    assert [words.count(f"{angle}°") for angle in (0, 30, 150, 180, 210, 360)] == [1, 1, 1, 2, 1, 1]


@drawn
def test_part_of_a_turn_has_no_chord_back_to_its_beginning() -> None:
    part = Vector(*(component[:4] for component in LEAPS))
    assert not polar_of(part, "$X$", "$Y$", "kN", ",").findobj(lambda one: "chord" in str(one.get_gid()))


@drawn
def test_a_force_that_rests_has_no_marks() -> None:
    idle = Vector([0.0, 90.0, 180.0, 180.0, 360.0], [0, 2, 0, 0, 0], [3, 1, -1, 0, 0])
    words = texts(polar_of(idle, "$X$", "$Y$", "kN", ","))
    assert {"0°", "90°", "180°"} <= set(words)
    assert not {"210°", "270°", "360°"} & set(words)
    assert words.count("180°") == 1


@drawn
@pytest.mark.parametrize("name", ["$Z$", "Radial force $Z$ in some very long words"])
def test_the_scale_of_forces_leaves_the_name_of_the_axis_free(name: str) -> None:
    figure = polar_of(
        Vector(ANGLES, [0.1 * one for one in SINES], COSINES), "$T$", name, "kN", ",", ("", "up")
    )
    figure.canvas.draw()
    (heading,) = (one for one in texts_of(figure) if "Z" in one.get_text())
    assert heading.get_text().endswith("kN, up")
    (scale,) = (one for one in texts_of(figure) if one.get_text().endswith("$ kN"))
    assert not heading.get_window_extent().overlaps(scale.get_window_extent())
    assert scale.get_window_extent().y1 <= figure.bbox.y1


@drawn
@pytest.mark.parametrize("value", [0.0, math.nan])
def test_a_force_that_is_nowhere_is_refused(value: float) -> None:
    with pytest.raises(ProblemError, match="nothing can be drawn"):
        polar_of(Vector([0.0, 90.0], [value] * 2, [value] * 2), "$X$", "$Y$", "kN", ",")


# Mechanism --------------------------------------------------------------------------------------------

DRIVES = [(0.2, 0.0), (0.4, 0.0), (0.25, 0.7), (0.3, -1.1), (1 / 12, 0.0)]


@drawn
@pytest.mark.parametrize(("ratio", "offset"), DRIVES)
@pytest.mark.parametrize("angle", [0, 37, 90, 180, 201.5, 340])
def test_crank_and_rod_are_drawn_true_to_scale(ratio: float, offset: float, angle: float) -> None:
    figure = mechanism(ratio, offset, [angle], "en", ".")
    crank, rod = artist(figure, "crank"), artist(figure, "rod")
    assert drawn_length(crank) == pytest.approx(1, rel=1e-12)
    assert drawn_length(rod) == pytest.approx(1 / ratio, rel=1e-12)
    assert np.asarray(rod.get_ydata())[1] == pytest.approx(offset, abs=1e-12)
    pin = (math.cos(math.radians(angle)), math.sin(math.radians(angle)))
    assert (np.asarray(crank.get_xdata())[1], np.asarray(crank.get_ydata())[1]) == pytest.approx(pin)
    (x0, y0), (x1, y1) = figure.axes[0].transData.transform([(0, 0), (1, 1)])
    assert x1 - x0 == pytest.approx(y1 - y0, rel=1e-9)


@pytest.mark.parametrize(("ratio", "offset"), DRIVES)
def test_the_rod_angle_is_that_of_the_drawn_rod(ratio: float, offset: float) -> None:
    for angle in (20.0, 110.0, 250.0):
        one = position(ratio, offset, angle)
        lean = math.atan2(one.pin[1] - one.head[1], one.head[0] - one.pin[0])
        assert one.lean == pytest.approx(math.degrees(lean), abs=1e-9)


@drawn
def test_at_the_dead_centres_of_an_offset_drive_crank_and_rod_are_in_line() -> None:
    from kurbel.plot.mechanism import _drive

    drive = _drive(0.3, 0.8)
    for dead in (drive.inner, drive.outer):
        cross = dead.pin[0] * (dead.head[1] - dead.pin[1]) - dead.pin[1] * (dead.head[0] - dead.pin[0])
        assert cross == pytest.approx(0, abs=1e-12)
    assert math.hypot(*drive.inner.head) == pytest.approx(1 / 0.3 + 1)
    assert math.hypot(*drive.outer.head) == pytest.approx(1 / 0.3 - 1)


@drawn
def test_a_drawing_speaks_its_language() -> None:
    assert {"innerer Totpunkt", "äußerer Totpunkt", "$R$", "$L$"} <= set(
        texts(mechanism(0.2, 0, [40], "de", ","))
    )
    words = texts(mechanism(0.2, 0.5, [62.5, 120], "en", "."))
    assert {"inner dead centre", "outer dead centre", "$e$", "62.5°"} <= set(words)
    assert "62,5°" in texts(mechanism(0.2, 0.5, [62.5, 120], "de", ","))


@drawn
@pytest.mark.parametrize(("ratio", "offset"), DRIVES)
def test_nothing_written_leaves_the_page(ratio: float, offset: float) -> None:
    for angles in ([45], [225], [60, 0, 180, 300]):
        figure = mechanism(ratio, offset, angles, "en", ".")
        for text in figure.axes[0].texts:
            box = text.get_window_extent()
            assert figure.bbox.x0 <= box.x0 and box.x1 <= figure.bbox.x1, (angles, text)
            assert figure.bbox.y0 <= box.y0 and box.y1 <= figure.bbox.y1, (angles, text)


@pytest.mark.parametrize(("ratio", "rod"), [(0.0, "infinite"), (0.05, "20 R")])
def test_a_rod_too_long_for_the_page_is_refused(ratio: float, rod: str) -> None:
    with pytest.raises(ProblemError) as error:
        mechanism(ratio, 0, [30], "de", ",")
    assert f"the length of the rod is {rod}; drawn to scale it may be at most {LONGEST_ROD} R" in str(
        error.value
    )


# Arc crank and parallel crank ---------------------------------------------------------------------------


def ends(figure: Figure, name: str) -> tuple[Point, Point]:
    line = artist(figure, name)
    x, y = (np.asarray(side, float).tolist() for side in (line.get_xdata(), line.get_ydata()))
    return (x[0], y[0]), (x[1], y[1])


@drawn
@pytest.mark.parametrize("crank", ARCS)
@pytest.mark.parametrize("angle", [0, 37, 90, 180, 201.5, 340])
def test_crank_rod_and_rocker_are_drawn_true_to_scale(crank: ArcCrank, angle: float) -> None:
    figure = arc_mechanism(crank, [angle], "en", ".")
    (shaft, pin), (start, head), (end, pivot) = (ends(figure, name) for name in ("crank", "rod", "rocker"))
    assert (shaft, start, end) == ((0, 0), pin, head)
    assert pin == pytest.approx((math.cos(math.radians(angle)), math.sin(math.radians(angle))), abs=1e-12)
    assert math.dist(pin, head) == pytest.approx(1 / float(crank.crank.ratio), rel=1e-12)
    assert math.dist(head, pivot) == pytest.approx(float(crank.rocker), rel=1e-12)
    rod = 1 / crank.crank.ratio
    height = crank.crank.offset + crank.rocker if crank.height is None else crank.height
    assert pivot == pytest.approx((float(crank.distance or rod), float(height)))
    (x0, y0), (x1, y1) = figure.axes[0].transData.transform([(0, 0), (1, 1)])
    assert x1 - x0 == pytest.approx(y1 - y0, rel=1e-9)
    path = np.stack((artist(figure, "arc").get_xdata(), artist(figure, "arc").get_ydata()), axis=1)
    # It has a gap behind each pin, the ends of which lie on chords.
    seen = np.isfinite(path).all(axis=1)
    within = seen & np.roll(seen, 1) & np.roll(seen, -1)
    assert np.hypot(*(path[within] - pivot).T) == pytest.approx(float(crank.rocker), rel=1e-12)
    assert np.hypot(*(path[seen] - pivot).T) == pytest.approx(float(crank.rocker), rel=1e-3)
    path = path[seen]
    assert np.hypot(*(path - head).T).min() < 0.05 * float(crank.rocker)


@pytest.mark.parametrize("crank", ARCS)
def test_the_rods_end_stays_on_its_side_of_pin_and_pivot(crank: ArcCrank) -> None:
    sides = set()
    for angle in range(0, 360, 5):
        one = arc_position(crank, angle)
        pivot = np.asarray((float(crank.distance or 1 / crank.crank.ratio), float(crank.pivot_height)))
        (x, y), (across, up) = pivot - one.pin, np.asarray(one.head) - one.pin
        sides.add(x * up - y * across > 0)
    assert sides == {crank.pivot_height < 0}


@pytest.mark.parametrize("crank", ARCS)
def test_at_the_dead_centres_of_an_arc_crank_rod_and_crank_are_in_line(crank: ArcCrank) -> None:
    from kurbel.plot.arc import _drive

    drive, rod = _drive(crank), 1 / float(crank.crank.ratio)
    assert math.hypot(*drive.inner.head) == pytest.approx(rod + 1)
    assert math.hypot(*drive.outer.head) == pytest.approx(rod - 1)


@drawn
@pytest.mark.parametrize("crank", ARCS)
def test_nothing_written_of_an_arc_crank_leaves_the_page(crank: ArcCrank) -> None:
    for angles in ([45], [225], [60, 0, 180, 300]):
        figure = arc_mechanism(crank, angles, "de", ",")
        assert {"innerer Totpunkt", "äußerer Totpunkt", "$B$", "$D$"} <= set(texts(figure))
        assert ("$H$" in texts(figure)) == (crank.pivot_height != 0)
        boxes = [text.get_window_extent() for text in figure.axes[0].texts]
        for number, box in enumerate(boxes):
            assert figure.bbox.x0 <= box.x0 and box.x1 <= figure.bbox.x1, angles
            assert figure.bbox.y0 <= box.y0 and box.y1 <= figure.bbox.y1, angles
            assert not any(box.overlaps(other) for other in boxes[:number]), (angles, texts(figure))
        assert figure.get_figwidth() * 25.4 <= 120.001
        assert figure.get_figheight() * 25.4 <= 150.001


@drawn
@pytest.mark.parametrize("angle", [0, 37, 90, 180, 201.5, 340])
def test_the_two_cranks_of_a_parallel_crank_turn_angle_for_angle(angle: float) -> None:
    figure = outlined(ParallelCrank().outline(), [angle, 20], ".")
    (shaft, pin), (other, second), rod = (ends(figure, name) for name in ("crank", "second-crank", "rod"))
    way = (math.cos(math.radians(angle)), math.sin(math.radians(angle)))
    assert (shaft, other, rod) == ((0, 0), (SHAFTS, 0), (pin, second))
    assert pin == pytest.approx(way, abs=1e-12)
    assert second == pytest.approx((SHAFTS + way[0], way[1]), abs=1e-12)
    assert texts(figure).count("$R$") == texts(figure).count("$L$") == 2
    (x0, y0), (x1, y1) = figure.axes[0].transData.transform([(0, 0), (1, 1)])
    assert x1 - x0 == pytest.approx(y1 - y0, rel=1e-9)


@pytest.mark.parametrize(
    ("ratio", "rocker", "rod"), [((1, 5), 13, "5 R"), ((1, 13), 6, "13 R"), ((0, 1), 6, "infinite")]
)
def test_links_too_long_for_the_page_are_refused(ratio: tuple[int, int], rocker: int, rod: str) -> None:
    with pytest.raises(ProblemError) as error:
        arc_mechanism(ArcCrank(Crank(Fraction(*ratio)), Fraction(rocker)), [30], "de", ",")
    assert str(error.value) == (
        f"the length of the rod is {rod}, that of the rocker {rocker} R; drawn to scale they may be at most"
        f" {LONGEST_ROD} R, or the crank is too small to be seen"
    )
