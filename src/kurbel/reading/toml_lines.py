"""Where the keys of a TOML file stand, which the parser of the standard library does not tell."""

from __future__ import annotations

import re
from collections.abc import Iterator

Place = tuple[str | int, ...]

_TOKEN = re.compile(
    r'(?P<text>"""(?:[^"\\]|\\.|"(?!""))*+"{3,5}|\'\'\'(?:[^\']|\'(?!\'\'))*+\'{3,5}'
    r'|"(?:[^"\\\n]|\\.)*+"|\'[^\'\n]*+\')'
    r"|(?P<mark>\[|\]|\{|\}|,|=|\.|\n)"
    r"|(?P<word>[^\s\"'\[\]{},=.#]++)"
    r"|#[^\n]*+",
    re.DOTALL,
)


def key_lines(text: str) -> dict[Place, int]:
    """Return the line, from 1, of each key, section and entry of a list, of a file that was read.

    The place of a key is its path: ("chapter", 0, "part", 2, "run").
    """
    return _Lines(text).lines


class _Lines:
    """Goes through the tokens of a file once."""

    def __init__(self, text: str) -> None:
        self.lines: dict[Place, int] = {}
        self.counts: dict[Place, int] = {}
        self.tokens = _tokens(text)
        self.line, self.token = 1, "\n"
        section: Place = ()
        while self.token:
            if self.token == "[":
                section = self.section()
            elif self.token == "\n":
                self.step()
            else:
                self.entry(section)

    def step(self) -> str:
        """Go on to the next token, which is nothing at the end, and return the one left."""
        left = self.token
        self.line, self.token = next(self.tokens, (self.line, ""))
        return left

    def section(self) -> Place:
        """Return the place that [a.b] or [[a.b]] opens; in a list of sections, with its number."""
        line = self.line
        self.step()
        several = self.token == "["
        if several:
            self.step()
        names = self.names("]")
        self.step()
        place: Place = ()
        for number, name in enumerate(names, 1):
            place += (name,)
            if number == len(names) and several:
                self.counts[place] = self.counts.get(place, -1) + 1
            if place in self.counts:
                place += (self.counts[place],)
        self.lines[place] = line
        return place

    def names(self, end: str) -> list[str]:
        """Return the parts of a key up to the mark behind it, and step over that."""
        names = []
        while self.token not in (end, ""):
            if (token := self.step()) not in (".", "\n"):
                names.append(token.strip("\"'"))
        self.step()
        return names

    def entry(self, section: Place) -> None:
        """Note a key and what its value has."""
        line = self.line
        place = (*section, *self.names("="))
        self.lines.setdefault(place, line)
        self.value(place)

    def value(self, place: Place) -> None:
        if self.token == "[":
            self.step()
            index = 0
            while self.token not in ("]", ""):
                if self.token == ",":
                    index += 1
                if self.token in (",", "\n"):
                    self.step()
                    continue
                self.lines[*place, index] = self.line
                self.value((*place, index))
            self.step()
        elif self.token == "{":
            self.step()
            while self.token not in ("}", ""):
                if self.token in (",", "\n"):
                    self.step()
                else:
                    self.entry(place)
            self.step()
        else:
            while self.token not in (",", "]", "}", "\n", ""):
                self.step()


def _tokens(text: str) -> Iterator[tuple[int, str]]:
    """Yield the tokens, but for comments, each with the line that it begins in."""
    line, counted = 1, 0
    for found in _TOKEN.finditer(text):
        if found.lastgroup:
            line += text.count("\n", counted, found.start())
            counted = found.start()
            yield line, found[0]
