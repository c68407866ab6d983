"""What all drawings share: type, lines, sizes in millimetres, and files of identical bytes.

Needs the extra `plot`. Drawings never touch pyplot, which keeps global state and may open windows.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import lru_cache
from io import BytesIO
from threading import RLock
from types import MappingProxyType
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from kurbel.errors import ChoiceError
from kurbel.exact.numerals import Label
from kurbel.formats.formula import TexMath
from kurbel.page.formula import Formula
from kurbel.page.labels import mark_text, rows_of, set_label
from kurbel.reading.given import choose

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.patches import Patch
    from matplotlib.typing import RcKeyType

    from kurbel.page.steps import Point
    from kurbel.plot.place import Points

# The type area of a book of octavo or A5 size; a drawing is included at its own size.
WIDTH = 120.0
MM_PER_INCH = 25.4
# A millimetre in points, matplotlib's unit of type and lines.
MM = 72 / MM_PER_INCH
DOTS_PER_INCH = 300
DOTS_PER_MM = DOTS_PER_INCH / MM_PER_INCH

TEXT_SIZE = 9.0
SMALL_TEXT = 8.0
# Widths of lines in points, of the series of ISO 128-2, which has steps of √2 in mm. Narrow, wide and
# extra-wide lines are there as 1 : 2 : 4; HEAVY is a step wider.
THIN, MEDIUM, STRONG, HEAVY = (width * MM for width in (0.13, 0.25, 0.5, 0.7))
BLACK, GREY, PALE, WHITE = "#000000", "#8c8c8c", "#d9d9d9", "#ffffff"

# Patterns of ISO 128-2 in widths of the line: line 04 for centre lines, 05 for further positions.
LONG_DASH_DOT = (24.0, 3.0, 0.5, 3.0)
LONG_DASH_DOUBLE_DOT = (24.0, 3.0, 0.5, 3.0, 0.5, 3.0)


Dashes: TypeAlias = str | tuple[float, tuple[float, ...]]
"""A pattern of a line: its name, or where it begins and the lengths of dashes and gaps in points."""


class Size(NamedTuple):
    """Width and height of a drawing in mm; without a height it has the one that it needs. A drawing to scale
    may be narrower unless its width is `exact`."""

    width: float = WIDTH
    height: float | None = None
    exact: bool = False


USUAL = Size()

STYLE: Mapping[RcKeyType, object] = {
    # matplotlib brings these fonts along: text and formulas match, and look the same on every machine.
    "font.family": ["STIXGeneral"],
    "mathtext.fontset": "stix",
    "font.size": TEXT_SIZE,
    "figure.dpi": DOTS_PER_INCH,
    "savefig.dpi": DOTS_PER_INCH,
    "axes.linewidth": THIN,
    # The ground is that of the page.
    "axes.facecolor": "none",
    # Every given point is drawn, in every format.
    "path.simplify": False,
    # Ids in SVG are hashes with a salt, by default a random one.
    "svg.hashsalt": "kurbel",
    # Outlines instead of letters: a page without the STIX fonts, which is nearly every one, would set other
    # letters of other widths.
    "svg.fonttype": "path",
    # TrueType, which printers' checks accept and readers can search; by default it is Type 3.
    "pdf.fonttype": 42,
}
OWN_FONTS: Mapping[RcKeyType, object] = {"svg.fonttype": "none"}
# Settings of the process, not of a drawing: a change would have effects outside.
_PROCESS = frozenset(("backend", "backend_fallback", "interactive", "toolbar", "timezone", "date.epoch"))

FORMATS: Mapping[str, Mapping[str, str | None]] = {
    # No date and no version: the same drawing is the same file.
    "svg": {"Date": None, "Creator": None},
    "png": {"Software": None},
    "pdf": {"CreationDate": None, "Creator": "kurbel", "Producer": None},
    "pgf": {},
}
# The formats of drawings that move, and those of all.
MOVING = ("html", "svg", "gif")
FILES = dict.fromkeys((*FORMATS, *MOVING))
_LOCK = RLock()


class Line(NamedTuple):
    """A colour, a pattern in units of the line's width, and a width in points."""

    colour: str
    dashes: tuple[float, ...]
    width: float


# Okabe and Ito's colours, which colour-blind eyes tell apart, without those too pale for thin lines. The
# pattern alone tells the first six lines apart, pattern and width twelve.
_COLOURS = (BLACK, "#0072b2", "#d55e00", "#009e73", "#a8508c", "#8f6b00")
_PATTERNS: tuple[tuple[float, ...], ...] = (
    (),
    (6, 2),
    (7, 2, 1.2, 2),
    (1.2, 1.6),
    (12, 2.5),
    (7, 2, 1.2, 2, 1.2, 2),
)
LINES = tuple(
    Line(colour, dashes, width)
    for width in (STRONG, MEDIUM)
    for colour, dashes in zip(_COLOURS, _PATTERNS, strict=True)
)


@contextmanager
def style(more: Mapping[RcKeyType, object] = MappingProxyType({})) -> Iterator[None]:
    """Draw in kurbel's style, whatever a matplotlibrc says; raise MissingExtraError without matplotlib.

    matplotlib's settings belong to the whole process: they are set for the time of the block, in one thread
    after the other.
    """
    _without_notes()
    try:
        import matplotlib
    except ImportError:
        from kurbel.reading.environment import missing_extra

        raise missing_extra("drawings need matplotlib", "plot") from None
    with _LOCK, matplotlib.rc_context():
        defaults = matplotlib.rcParamsDefault
        matplotlib.rcParams.update({name: defaults[name] for name in defaults if name not in _PROCESS})
        matplotlib.rcParams.update({**STYLE, **more})
        with _own_fonts():
            yield


@contextmanager
def _own_fonts() -> Iterator[None]:
    """Have matplotlib look for fonts among those that it brings along, not among all of the machine."""
    from matplotlib import font_manager, get_data_path

    manager, every = font_manager.fontManager, font_manager.fontManager.ttflist
    manager.ttflist = [font for font in every if font.fname.startswith(get_data_path())]
    try:
        yield
    finally:
        manager.ttflist = every


def _without_notes() -> None:
    """Keep matplotlib's notes of its caches from standard error, unless another one uses it already."""
    if "matplotlib" not in sys.modules:
        import logging

        logging.getLogger("matplotlib").addHandler(logging.NullHandler())


def page(height: float, width: float = WIDTH) -> Figure:
    """Return an empty figure of a size in mm. Only inside `style`."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width / MM_PER_INCH, height / MM_PER_INCH))
    FigureCanvasAgg(figure)
    return figure


def fitted(pattern: Sequence[float], widths: float, begun: float = 0, open: float = 0) -> Dashes:
    """Return a chain for a line of so many widths that begins and ends with a dash, as ISO 128-2 has it.

    Of the first and of the last dash a share may be left out. The pattern is stretched; a line too short for
    two dashes is solid.
    """
    dash, period = pattern[0], sum(pattern)
    ends = dash * (1 - begun - open)
    count = round((widths - ends) / period)
    if count < 1:
        return "solid"
    stretch = widths / (count * period + ends)
    return begun * dash * stretch, tuple(part * stretch for part in pattern)


def arrowhead(
    axes: Axes,
    tip: Points | Point,
    direction: Points | Point,
    mm: float,
    size: float = 1.9,
    slim: float = 0.132,
    level: float = 6,
) -> Patch:
    """Draw a filled arrowhead of a length in mm, of 15° as in ISO 129-1, and return it; mm is a millimetre of
    the axes."""
    import numpy as np

    along = np.asarray(direction) / np.hypot(*direction) * size * mm
    side = np.asarray((-along[1], along[0])) * slim
    base = np.asarray(tip) - along
    corners = np.stack((np.asarray(tip), base + side, base - side))
    return axes.fill(*corners.T, color=BLACK, linewidth=0, zorder=level, clip_on=False)[0]


def image(figure: Figure, name: str, title: str = "", about: str = "", text: bool = False) -> bytes:
    """Return a figure as a file of the format svg, png, pdf or pgf.

    The ground of SVG and PDF is transparent, and SVG black is the colour of the text around it. With `text`
    SVG has letters in the reader's fonts in place of their outlines; raises ChoiceError for other formats.

    The same figure is the same bytes in every process, time zone, locale and folder, given one version of
    matplotlib and its libraries: the file has no date, hence none that SOURCE_DATE_EPOCH would have to fix.
    The title and what is told about the drawing, plain text, are for readers that do not see it.
    """
    if text and name != "svg":
        raise ChoiceError(
            f"--text is for SVG, whose letters are outlines without it; leave it out for {name}"
        )
    metadata = dict(FORMATS[choose(name, FORMATS, "drawing format")])
    if title:
        metadata["Title"] = title
    stream = BytesIO()
    with style(OWN_FONTS if text else {}):
        if name == "pgf":
            from kurbel.plot.paper import pgf

            return pgf(figure, title)
        figure.savefig(stream, format=name, metadata=metadata, facecolor=WHITE if name == "png" else "none")
        if name != "svg":
            return stream.getvalue()
        from kurbel.plot.paper import finished

        return finished(stream.getvalue().decode(), about, text).encode()


def format_of(path: str, moves: bool = False) -> str:
    """Return the format that a file name asks for; raise ChoiceError if its suffix is that of no drawing, or
    of one that moves and this does not."""
    suffix = os.path.splitext(path)[1].lower()
    known = FILES if moves else FORMATS
    if suffix.removeprefix(".") not in known:
        listed = ", ".join(f".{one}" for one in known)
        said = f'the file name "{path[-60:]}" names no drawing; its suffix must be one of {listed}'
        if suffix.removeprefix(".") in FILES:
            said = f"{suffix} is for drawings that move, plot --animate; else take one of {listed}"
        raise ChoiceError(said)
    return suffix[1:]


# What mathtext obeys in upright text.
_OBEYED = str.maketrans({character: f"\\{character}" for character in "#$%&_{}"})
# mathtext sets a colon as a relation, with wide spaces, even in braces.
_COLON = r"\text{:}"
# An index is upright where it stands for a word or a body, by ISO 80000-1, 7.1.3; running numbers and
# coordinates are not.
_NAMED = re.compile(r"_\{?([A-Za-hlmo-wA-Z])(?![A-Za-z])\}?")
# Behind an empty group a prime would touch a slanted letter.
_PRIMED = re.compile(r"(?<=[A-Za-z])\{\}(?=\^\{\\prime)")
_SHORT = re.compile(r"\\(le|ge)(?![A-Za-z])")


def text_of(label: Label, mark: str) -> str:
    """Return a label in matplotlib's notation: prose as it is, formulas in mathtext."""
    return set_label(label, _prose, lambda formula: _mathtext(formula, mark), mark_text)


def _prose(text: str) -> str:
    # The ² and ³ of the fonts are far bolder than their letters.
    return text.replace("$", r"\$").replace("²", "$^2$").replace("³", "$^3$")


def _mathtext(formula: Formula, mark: str) -> str:
    """Return a formula in mathtext, which is TeX's but for a few commands."""
    tex = TexMath(mark, lambda text: text.translate(_OBEYED)).set(formula.content)
    tex = _NAMED.sub(r"_\\mathrm{\1}", _PRIMED.sub("", tex))
    return "$" + _SHORT.sub(r"\g<0>q", tex.replace("{:}", _COLON)) + "$"


@lru_cache(maxsize=512)
def size_of(text: str, points: float = TEXT_SIZE) -> tuple[float, float]:
    """Return width and height in mm of a text in matplotlib's notation. Only inside `style`."""
    figure = page(1)
    box = figure.text(0, 0, text, fontsize=points).get_window_extent()
    return box.width / DOTS_PER_MM, box.height / DOTS_PER_MM


def in_rows(text: str, width: float) -> str:
    """Return a text in rows not wider than so many mm, broken at spaces outside of formulas. Only inside
    `style`."""
    return "\n".join(rows_of(text, width, lambda one: size_of(one)[0]))
