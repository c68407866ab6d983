"""What a drawing becomes on the page: SVG, whose letters are joined to words, with what it shows in words and
black in the colour of the page's text; PGF, for \\input in a LaTeX document, whose own fonts set its letters.

matplotlib measures the texts of PGF by running LaTeX. Here their places are already found, in the fonts of
all drawings, and each text is set from the same anchor: no LaTeX is run, and the file is the same everywhere.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from functools import cache
from html import escape as escape_html
from html import unescape
from io import StringIO
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.formats.latex.writer import escape
from kurbel.plot.style import BLACK, PALE

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_TEXT = re.compile(r"(<text>)\s*((?:<tspan[^>]*>[^<]*</tspan>\s*)+)(</text>)")
_LETTER = re.compile(r'<tspan x="([-\d.]+)" y="([-\d.]+)" style="([^"]*)">([^<]*)</tspan>')
_SIZE = re.compile(r"font-size: ([\d.]+)px")
# What matplotlib sets for a space beside formulas.
NO_BREAK = "\N{NO-BREAK SPACE}"
_ITALIC = "font-style: italic"
# In em: letters so far apart are one word, and from here on a space is between them.
_TOGETHER, _SPACE = 0.03, 0.1


class _Letter(NamedTuple):
    x: float
    y: str
    style: str
    text: str

    @property
    def size(self) -> float:
        found = _SIZE.search(self.style)
        return float(found[1]) if found else 1.0

    def end(self) -> float:
        return self.x + _advance(unescape(self.text), _ITALIC in self.style) * self.size


def joined(svg: str) -> str:
    """Return the file with texts in reading order, letter beside letter of one kind in one piece.

    Each piece stands where its first letter stood and is as long as it was, in the reader's fonts, too: a
    wider one would run into the next. Only inside `style`.
    """
    return _TEXT.sub(lambda text: f"{text[1]}{''.join(_pieces(text[2]))}{text[3]}", svg)


def _pieces(spans: str) -> Iterator[str]:
    letters = [_Letter(float(x), *rest) for x, *rest in _LETTER.findall(spans)]
    run: list[_Letter] = []
    for letter in sorted(letters, key=lambda letter: letter.x):
        gap = (letter.x - run[-1].end()) / letter.size if run else 0.0
        alike = not run or (letter.y, letter.style) == (run[-1].y, run[-1].style)
        if not alike or abs(gap) > _TOGETHER:
            yield _piece(run, " ", letter.x) if gap >= _SPACE else _piece(run, "", run[-1].end())
            run = []
        run.append(letter)
    yield _piece(run, "", run[-1].end())


def _piece(run: Sequence[_Letter], space: str, end: float) -> str:
    text = "".join(letter.text for letter in run).replace(NO_BREAK, " ") + space
    length = f'textLength="{end - run[0].x:g}" lengthAdjust="spacingAndGlyphs"'
    return f'<tspan x="{run[0].x:g}" y="{run[0].y}" {length} style="{run[0].style}">{text}</tspan>'


def _advance(letter: str, italic: bool) -> float:
    """Return how far a letter leads on, in em."""
    from matplotlib.font_manager import findfont, get_font
    from matplotlib.ft2font import LoadFlags

    font = get_font(findfont(f"STIXGeneral{':italic' if italic else ''}"))
    font.set_size(1000, 72)
    return float(font.load_char(ord(letter), flags=LoadFlags.NO_HINTING).linearHoriAdvance) / 65536 / 1000


_ROOT = re.compile(r"<svg\b[^>]*>")
# Light lines and areas are black ones that hardly cover, so that they are faint on dark pages too.
_FAINT = "{0}: currentColor; {0}-opacity: 0.16"
# Fonts like those of the drawing, for text that is set anew where these are not to be had.
_FACE, _LIKE = "'STIXGeneral'", "'STIXGeneral', 'STIX Two Text', 'Times New Roman', serif"


def finished(svg: str, about: str, text: bool) -> str:
    """Return the file with a description for readers that do not see it, beside the title that it has, and,
    where it has `text`, with that in words. Only inside `style`.

    Lines and letters that were black have the colour of the text of a page that the file is part of; by
    itself they are black.
    """
    svg = joined(svg) if text else svg
    for part in ("stroke", "fill"):
        svg = svg.replace(f"{part}: {PALE}", _FAINT.format(part))
    svg = svg.replace(BLACK, "currentColor").replace(_FACE, _LIKE)
    svg = _ROOT.sub(lambda root: f'{root[0][:-1]} role="img" fill="currentColor">', svg, count=1)
    told = f" <desc>{escape_html(about, quote=False)}</desc>\n" if about else ""
    return svg.replace(" <metadata>", f"{told} <metadata>", 1)


HEAD = r"""% {title}
% For \input{{...}} in a document with \usepackage{{pgf}} and \usepackage{{amsmath}}.
\begingroup%
\makeatletter%
\begin{{pgfpicture}}%
\pgfpathrectangle{{\pgfpointorigin}}{{\pgfqpoint{{{width:f}in}}{{{height:f}in}}}}%
\pgfusepath{{use as bounding box, clip}}%
"""
END = "\\end{pgfpicture}%\n\\makeatother%\n\\endgroup%\n"
# Formulas of a text in mathtext, and a dollar sign in its prose.
_FORMULA = re.compile(r"(?<!\\)(\$[^$]*(?<!\\)\$)")
_DOLLAR = "\\$"
# What places a text by its anchor, as PGF calls it.
_ACROSS = {"left": "left", "right": "right", "center": ""}
_UP = {"top": "top", "bottom": "bottom", "baseline": "base", "center": "", "center_baseline": ""}


def pgf(figure: Figure, title: str) -> bytes:
    """Return the figure; only inside `style`."""
    from matplotlib.backends import backend_mixed

    mixed: Any = backend_mixed
    width, height = figure.get_figwidth(), figure.get_figheight()
    stream = StringIO()
    stream.write(HEAD.format(title=" ".join(title.split()), width=width, height=height))
    ground = figure.get_facecolor()
    figure.set_facecolor("none")
    try:
        renderer = _renderer()(figure, stream)
        figure.draw(mixed.MixedModeRenderer(figure, width, height, figure.dpi, renderer))
    finally:
        figure.set_facecolor(ground)
    return (stream.getvalue() + END).encode()


@cache
def _renderer() -> Any:
    """Return what draws PGF, made of matplotlib's own."""
    from matplotlib.backends import backend_agg, backend_pgf
    from matplotlib.colors import to_hex

    agg: Any = backend_agg

    class Renderer(backend_pgf.RendererPgf):
        def __init__(self, figure: Figure, stream: StringIO) -> None:
            super().__init__(figure, stream)  # type: ignore[no-untyped-call]
            self.stream = stream
            self.measuring = agg.RendererAgg(1, 1, figure.dpi)

        def get_text_width_height_descent(self, s: str, prop: object, ismath: object) -> Any:
            return self.measuring.get_text_width_height_descent(s, prop, ismath)

        def draw_text(
            self, gc: Any, x: float, y: float, s: str, prop: Any, angle: float, ismath: object = False,
            mtext: Any = None,
        ) -> None:  # fmt: skip
            place = ["left", "base"]
            if mtext and mtext.get_rotation_mode() == "anchor":
                # Its place was sought for its middle: there it stays in wider or narrower letters.
                half = self.get_text_width_height_descent(s, prop, ismath)[0] / 2
                turn = math.radians(angle)
                x, y = x + half * math.cos(turn), y + half * math.sin(turn)
                place = ["base"]
            elif mtext and angle == 0:
                x, y = mtext.get_transform().transform(mtext.get_unitless_position())
                place = [_ACROSS[mtext.get_horizontalalignment()], _UP[mtext.get_verticalalignment()]]
            dots = self.figure.dpi
            words = [f"x={x / dots:f}in", f"y={y / dots:f}in", *filter(None, place)]
            words += [f"rotate={angle:g}"] if angle else []
            size, colour = prop.get_size_in_points(), to_hex(gc.get_rgb())
            self.stream.write("\\begin{pgfscope}%\n")
            text = f"\\fontsize{{{size:g}bp}}{{{1.2 * size:g}bp}}\\selectfont {tex(s)}"
            if colour != BLACK:
                self.stream.write(f"\\definecolor{{kurbel}}{{HTML}}{{{colour[1:].upper()}}}%\n")
                text = f"\\color{{kurbel}}{text}"
            self.stream.write(f"\\pgftext[{','.join(words)}]{{{text}}}%\n\\end{{pgfscope}}%\n")

    return Renderer


def tex(text: str) -> str:
    """Return a text in mathtext as LaTeX: formulas as they are, prose of which nothing is obeyed."""
    return "".join(
        piece if place % 2 else escape(piece.replace(_DOLLAR, "$"))
        for place, piece in enumerate(_FORMULA.split(text))
    )
