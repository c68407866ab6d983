"""Text of SVG that is formulas in part: letters, of which matplotlib places each alone, joined to words."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from html import unescape
from typing import NamedTuple

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
    return _TEXT.sub(lambda text: f"{text[1]}{''.join(_pieces(_letters(text[2])))}{text[3]}", svg)


def _letters(spans: str) -> list[_Letter]:
    found = [_Letter(float(x), *rest) for x, *rest in _LETTER.findall(spans)]
    return sorted(found, key=lambda letter: letter.x)


def _pieces(letters: Sequence[_Letter]) -> Iterator[str]:
    run: list[_Letter] = []
    for letter in letters:
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
