"""A figure as PGF, for \\input in a LaTeX document, whose own fonts set its letters.

matplotlib measures the texts of PGF by running LaTeX. Here their places are already found, in the fonts of
all drawings, and each text is set from the same anchor: no LaTeX is run, and the file is the same everywhere.
"""

from __future__ import annotations

import math
import re
from functools import cache
from io import StringIO
from typing import TYPE_CHECKING, Any

from kurbel.plot.style import BLACK

if TYPE_CHECKING:
    from matplotlib.figure import Figure

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

        def get_text_width_height_descent(self, s: str, prop: Any, ismath: Any) -> Any:
            return self.measuring.get_text_width_height_descent(s, prop, ismath)

        def draw_text(
            self, gc: Any, x: float, y: float, s: str, prop: Any, angle: float, ismath: Any = False,
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
    from kurbel.formats.latex.writer import escape

    return "".join(
        piece if place % 2 else escape(piece.replace(_DOLLAR, "$"))
        for place, piece in enumerate(_FORMULA.split(text))
    )
