"""A formula as tokens, taken one after the other, and what is said of one that is wrong, with its place."""

from __future__ import annotations

import re
from fractions import Fraction
from typing import NamedTuple, NoReturn

from kurbel.errors import NotationError
from kurbel.reading import notation

EXAMPLE = "5000 + 1500 sin(3φ)"
ANGLES = ("φ", "ϕ", "θ", "ϑ", "phi", "theta")
PI = ("π", "pi")
DEEPEST = 30

_TOKEN = re.compile(
    r"\s*(?:(?P<number>\d+(?:[.,]\d+)?)|(?P<word>[A-Za-zµ]+|[φϕθϑπ])|(?P<sign>\*\*|[-+−*·×/()\[\]^°²³]))"
)
_SIGNS = {"−": "-", "·": "*", "×": "*", "**": "^", "[": "(", "]": ")"}
# 5,000 is five thousand in one half of the world.
_THOUSANDS = re.compile(r"[1-9]\d{0,2},\d{3}")


class Token(NamedTuple):
    """A number, a word or a sign, and where in the text it begins, from 1; the end has no text."""

    kind: str
    text: str
    place: int


class Tokens:
    """What is left of a text, which is the formula of something."""

    def __init__(self, text: str, what: str) -> None:
        self.text, self.what, self.depth = text, what, 0
        self.tokens = [*self._tokens()]
        self.next = 0

    def _tokens(self) -> list[Token]:
        found, place = [], 0
        while match := _TOKEN.match(self.text, place):
            kind = match.lastgroup or ""
            word = match[kind]
            found.append(Token(kind, _SIGNS.get(word, word), match.start(kind) + 1))
            place = match.end()
        rest = self.text[place:]
        if rest.strip():
            begun = place + len(rest) - len(rest.lstrip()) + 1
            sign = rest.strip()[0]
            angle = "; the crank angle is φ or phi" if sign.isalpha() else ""
            self.refuse(f'has "{sign}" at place {begun}, which no formula has{angle}')
        return [*found, Token("end", "", len(self.text) + 1)]

    @property
    def token(self) -> Token:
        return self.tokens[self.next]

    def took(self, *texts: str) -> str:
        """Return the token if it is one of these, and go on behind it."""
        text = self.token.text
        if text not in texts or not text:
            return ""
        self.next += 1
        return text

    def number(self) -> Fraction:
        """Return the token, a number, and go on behind it."""
        text, place = self.token.text, self.token.place
        if _THOUSANDS.fullmatch(text):
            self.refuse(
                f"has {text} at place {place}, which may be {text.replace(',', '')} or"
                f" {text.replace(',', '.')}; write one of them"
            )
        self.next += 1
        return notation.number(text, f"{self.what}: number")

    def open(self) -> int:
        """Return the place of a bracket that was just opened."""
        self.depth += 1
        if self.depth > DEEPEST:
            self.refuse(f"has more than {DEEPEST} brackets within each other")
        return self.tokens[self.next - 1].place

    def refuse_angle(self) -> None:
        """Refuse a token that is another word for the crank angle."""
        kind, text, place = self.token
        if kind == "word" and text not in (*ANGLES, *PI):
            self.refuse(f'has "{text}" at place {place}; write the crank angle as φ or phi, {EXAMPLE}')

    def close(self, opened: int) -> None:
        if not self.took(")"):
            before = f' before "{self.token.text}" at place {self.token.place}' if self.token.text else ""
            self.refuse(f"has a bracket at place {opened} that is not closed{before}")
        self.depth -= 1

    def refuse_token(self) -> NoReturn:
        """Refuse the token, which cannot stand where it does."""
        kind, text, place = self.token
        if kind == "end":
            self.refuse(f"ends where a number or a sine is missing; write it as {EXAMPLE}")
        if text in (*ANGLES, *PI):
            self.refuse(
                f"has {text} at place {place} outside of a sine or cosine; a torque in straight lines is"
                " written as points, 0:0; 60:90; 180:0"
            )
        if kind == "word":
            self.refuse(
                f'has "{text}" at place {place}, which is neither sin, cos nor φ, nor at the end a unit of'
                f" torque; write it as {EXAMPLE}"
            )
        self.refuse(f'has "{text}" at place {place}, where none can stand')

    def refuse(self, why: str) -> NoReturn:
        raise NotationError(f"the formula of the {self.what}, {notation.quoted(self.text)}, {why}")
