"""A torque as a formula in the crank angle: 5000 + 1500 sin(3φ), 200 sin² φ cos φ, (12,5 + 3 sin 2φ) kN m.

There are numbers, + - * / ( ), powers of whole numbers, sin and cos, and φ or θ within them; a factor needs
no sign before what follows it. Angles are in degrees, π is 180°. A unit of torque may stand at the end, for
all of it; without one it is in N m. The result is a sum of waves, exactly; what is wrong is refused with its
place.
"""

from __future__ import annotations

import re
from fractions import Fraction
from typing import NamedTuple, NoReturn

from kurbel.engine.diagram.torque import QUARTER, Waves
from kurbel.errors import NotationError
from kurbel.exact.separation import TooLargeError
from kurbel.reading import notation, units
from kurbel.reading.notation import quoted

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
LONGEST_FORMULA = 1000
MOST_WAVES, MOST_ORDER, MOST_POWER = 400, 200, 20
_WAVES = {"sin": -QUARTER, "cos": Fraction(0)}
_SQUARES = {"²": 2, "³": 3}


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
            written = notation.in_shell(re.sub(rf"(?<![A-Za-z]){text}(?![A-Za-z])", "φ", self.text))
            written = EXAMPLE if self.tokens[self.next - 1].text in ANGLES else written
            self.refuse(f'has "{text}" at place {place}; write the crank angle as φ or phi, {written}')

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


class _Angle(NamedTuple):
    """kφ + α."""

    order: Fraction = Fraction(0)
    phase: Fraction = Fraction(0)

    def scaled(self, factor: Fraction) -> _Angle:
        return _Angle(self.order * factor, self.phase * factor)


def torque_of(text: str, what: str) -> Waves:
    """Return the torque in N m that a formula says. Raises NotationError with the place of what is wrong."""
    if len(text) > LONGEST_FORMULA:
        raise NotationError(
            f"the formula of the {what} has {len(text)} characters; at most {LONGEST_FORMULA} are read"
        )
    reader = _Reader(text, what)
    try:
        found = reader.sum()
        return found.times(reader.unit(found.rational))
    except TooLargeError as error:
        raise NotationError(f"the formula of the {what}, {quoted(text)}: {error}") from None


class _Reader(Tokens):
    """Reads sums of products, the angles of sines, and the unit at the end."""

    def sum(self) -> Waves:
        sign = self._sign()
        total = self._product().times(sign)
        while self.token.text in ("+", "-"):
            sign = self._sign()
            total = total + self._product().times(sign)
        return total

    def unit(self, amount: Fraction | None) -> Fraction:
        """Return the unit of torque at the end, in N m, of a formula that may be so much of it."""
        if self.token.kind == "end":
            return Fraction(1)
        if self.token.kind != "word" or self.token.text in (*ANGLES, *PI):
            self.refuse_token()
        unit = re.sub(r"\s+", "*", self.text[self.token.place - 1 :].strip())
        try:
            return units.signed_torque(f"1 {unit}", f"unit of the {self.what}")
        except NotationError:
            before, written = (
                one.strip() for one in (self.text[: self.token.place - 1], self.text[self.token.place - 1 :])
            )
            if hint := units.in_forces(written, units.signed_torque.unit, amount or before):
                self.refuse(f'has the unit "{written}" at place {self.token.place}; write {hint}')
            if self.tokens[self.next - 2].text in _WAVES:
                self.refuse_angle()
            self.refuse_token()

    def _sign(self) -> Fraction:
        return Fraction(-1 if self.took("+", "-") == "-" else 1)

    def _product(self) -> Waves:
        total = self._factor()
        while True:
            if self.took("*"):
                total = self._checked(total * self._factor())
            elif self.took("/"):
                total = total.times(1 / self._divisor())
            elif self.token.kind == "number":
                self.refuse(f"has two numbers side by side at place {self.token.place}; write 16000 or 2*3")
            elif self.token.text == "(" or self.token.text in _WAVES:
                total = self._checked(total * self._factor())
            else:
                return total

    def _divisor(self) -> Fraction:
        place = self.token.place
        value = self._factor().rational
        if value is None:
            self.refuse(f"divides by a function of φ at place {place}; it may divide by numbers alone")
        if not value:
            self.refuse(f"divides by 0 at place {place}")
        return value

    def _factor(self) -> Waves:
        token = self.token
        if token.kind == "number":
            found = Waves.constant(self.number())
        elif self.took("("):
            opened = self.open()
            found = self.sum()
            self.close(opened)
        elif self.took(*_WAVES):
            return self._wave(token)
        else:
            self.refuse_token()
        return self._raised(found, self._power())

    def _wave(self, function: Token) -> Waves:
        """Return a sine or cosine, whose power may stand before or behind its angle."""
        power, behind = self._power(), 1
        if self.took("("):
            opened = self.open()
            angle = self._angle()
            self.refuse_angle()
            self.close(opened)
            behind = self._power()
        else:
            angle = self._bare_angle(function)
        if power > 1 and behind > 1:
            self.refuse(f"has two powers of the {function.text} at place {function.place}")
        return self._raised(
            Waves.cosine(angle.order, angle.phase + _WAVES[function.text]), max(power, behind)
        )

    def _bare_angle(self, function: Token) -> _Angle:
        """Return the angle of sin 2φ."""
        name, numbered = function.text, self.token.kind == "number"
        factor = self.number() if numbered else Fraction(1)
        is_angle = bool(self.took(*ANGLES))
        if not (is_angle or numbered):
            self.refuse_angle()
            self.refuse(f"has no angle behind the {name} at place {function.place}; write {name}(3φ)")
        if not is_angle:
            self.took("°")
        if self.token.text in ("/", "°", "^", *_SQUARES) or (self.token.text == "(" and not is_angle):
            self.refuse(
                f'has a "{self.token.text}" at place {self.token.place} that may belong to the angle or not;'
                f" write {name}(φ/2) or {name}(φ)/2, {name}(2(φ - 30))"
            )
        return _Angle(factor) if is_angle else _Angle(phase=factor)

    def _angle(self) -> _Angle:
        """Return the angle in brackets: 3φ + 30°, φ/2, 2(φ - 120)."""
        sign = self._sign()
        total = self._angle_product().scaled(sign)
        while self.token.text in ("+", "-"):
            sign = self._sign()
            other = self._angle_product().scaled(sign)
            total = _Angle(total.order + other.order, total.phase + other.phase)
        if abs(total.order) > MOST_ORDER:
            self.refuse(f"has a wave of an order above {MOST_ORDER}")
        return total

    def _angle_product(self) -> _Angle:
        total, is_angle = self._angle_factor()
        while True:
            times = self.took("*")
            if not times and self.took("/"):
                total = total.scaled(1 / self._angle_divisor())
            elif times or self.token.text in (*ANGLES, *PI, "("):
                other, other_is = self._angle_factor()
                if is_angle and other_is:
                    self.refuse(f"multiplies two angles before place {self.token.place}")
                total = other.scaled(total.phase) if other_is else total.scaled(other.phase)
                is_angle = is_angle or other_is
            elif self.token.kind == "number":
                self.refuse(f"has two numbers side by side at place {self.token.place}")
            else:
                return total

    def _angle_divisor(self) -> Fraction:
        place = self.token.place
        divisor, is_angle = self._angle_factor()
        if is_angle or not divisor.phase:
            self.refuse(f"divides an angle by an angle or by 0 at place {place}")
        return divisor.phase

    def _angle_factor(self) -> tuple[_Angle, bool]:
        """Return a part of an angle, and whether it is one: φ, π, 30°; a bare number may be a factor."""
        if self.token.kind == "number":
            return _Angle(phase=self.number()), bool(self.took("°"))
        if self.took(*ANGLES):
            return _Angle(order=Fraction(1)), True
        if self.took(*PI):
            return _Angle(phase=Fraction(180)), True
        if self.took("("):
            opened = self.open()
            found = self._angle()
            self.close(opened)
            return found, bool(found.order)
        self.refuse_angle()
        self.refuse_token()

    def _power(self) -> int:
        """Return the power that follows, 1 if none does."""
        text = self.token.text
        if self.took(*_SQUARES):
            return _SQUARES[text]
        if not self.took("^"):
            return 1
        text, place = self.token.text, self.token.place
        if not text.isdecimal() or not 1 <= int(text[:4]) <= MOST_POWER:
            self.refuse(f"has a power at place {place} that is no whole number from 1 to {MOST_POWER}")
        self.next += 1
        return int(text)

    def _raised(self, factor: Waves, power: int) -> Waves:
        total = self._checked(factor)
        for _ in range(power - 1):
            total = self._checked(total * factor)
        return total

    def _checked(self, waves: Waves) -> Waves:
        """Return the waves, unless they are more than can be told apart."""
        if len(waves.amplitudes) > MOST_WAVES or any(order > MOST_ORDER for order in waves.orders):
            self.refuse(f"has more than {MOST_WAVES} waves, or one of an order above {MOST_ORDER}")
        return waves
