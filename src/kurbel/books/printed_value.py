"""Printed values as characters, and what they are found to be, from evidence alone and in a fixed order."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import NamedTuple

from kurbel.errors import NotationError
from kurbel.exact.numerals import Label, Number, number_text
from kurbel.page.quantity import Words, words
from kurbel.page.table import Tone

LONGEST = 100
# Units of the last place in one of the next.
NEXT_PLACE = 10
_DECIMAL = re.compile(r"([-−]?)([0-9]+)(?:([.,])([0-9]+))?")
_ARC = re.compile(r"([-−]?)([0-9]+)°\s*(?:([0-9]+)(½)?['′])?")
_QUOTIENT = re.compile(r"([-−]?)([0-9]+)/([0-9]+)")


# Of what is printed, whole ones; a quotient in place of a quotient need not be.
Units = int | Fraction


class PrintedValue(NamedTuple):
    """A printed value: scaled · unit, where the unit is that of its last place.

    `form` says how it is written: with a decimal "," or ".", as "°", "'" (degrees and minutes), "½'" (half
    minutes counted), or as "/", a quotient, which has no last place but is exact.
    """

    text: str
    scaled: int
    unit: Fraction
    form: str

    @property
    def value(self) -> Fraction:
        return self.scaled * self.unit

    @property
    def exact(self) -> bool:
        return self.form == "/"

    def standing_for(self, scaled: Units) -> str:
        """Return how a value of so many units would be printed in its place."""
        if self.exact:
            return self.text if scaled == self.scaled else str(scaled * self.unit)
        assert isinstance(scaled, int)
        if self.form in (",", "."):
            return number_text(Number(scaled, self.decimals), self.form)
        sign = "-" if scaled < 0 else ""
        size = abs(scaled)
        if self.form == "°":
            return f"{sign}{size}°"
        halves = 2 if self.form == "½'" else 1
        degrees, rest = divmod(size, 60 * halves)
        minutes, half = divmod(rest, halves)
        return f"{sign}{degrees}°{minutes}{'½' if half else ''}'"

    def with_units(self, scaled: Units) -> PrintedValue:
        """Return the value of so many units, printed in its place."""
        text = self.standing_for(scaled)
        if self.exact:
            value = scaled * self.unit
            return PrintedValue(text, value.numerator, Fraction(1, value.denominator), self.form)
        return self._replace(text=text, scaled=int(scaled))

    @property
    def in_tens(self) -> bool:
        """Whether it may be meant to ten minutes: 79°20'. A decimal fraction promises all its places."""
        return self.form == "'" and self.scaled % NEXT_PLACE == 0

    def coarser(self) -> PrintedValue:
        """Return the value in units ten times as great; one in tens is the same."""
        return self._replace(scaled=self.scaled // NEXT_PLACE, unit=self.unit * NEXT_PLACE)

    def in_formula(self) -> str:
        """Return the value for a formula, with a decimal point: 0.343, 79°20', 5/4; for prose 32°51½′."""
        # The notation of formulas has no ½, nor has that of prose a prime after it.
        return self.standing_for(self.scaled).replace(",", ".").replace("½'", "½′")

    def cell(self) -> Number | Label:
        """Return the value for a table."""
        if self.form in (",", "."):
            return Number(self.scaled, self.decimals)
        text = self.in_formula()
        return text if "½" in text else f"${text}$"

    @property
    def decimals(self) -> int:
        """How many decimals are printed."""
        return len(str(self.unit.denominator)) - 1 if self.form in (",", ".") else 0


def printed_value(text: str) -> PrintedValue:
    """Return what the characters say: "0,981", "-0.025", "32°51½'", "77°", "1/72"."""
    stripped = text.strip()
    if len(stripped) > LONGEST:
        raise NotationError(
            f"a printed value of {len(stripped)} characters is too long; {LONGEST} are allowed"
        )
    if match := _DECIMAL.fullmatch(stripped):
        sign, whole, mark, rest = match.groups()
        rest = rest or ""
        scaled = int(whole + rest) * (-1 if sign else 1)
        return PrintedValue(stripped, scaled, Fraction(1, 10 ** len(rest)), mark or ",")
    if match := _ARC.fullmatch(stripped):
        sign, degrees, minutes, half = match.groups()
        if minutes is None:
            return PrintedValue(stripped, int(degrees) * (-1 if sign else 1), Fraction(1), "°")
        halves = 2 if half else 1
        scaled = (int(degrees) * 60 + int(minutes)) * halves + bool(half)
        form = "½'" if half else "'"
        return PrintedValue(stripped, scaled * (-1 if sign else 1), Fraction(1, 60 * halves), form)
    if match := _QUOTIENT.fullmatch(stripped):
        sign, top, bottom = match.groups()
        if int(bottom):
            value = Fraction(int(top), int(bottom)) * (-1 if sign else 1)
            return PrintedValue(stripped, value.numerator, Fraction(1, value.denominator), "/")
    raise NotationError(
        f'"{text[:40]}" is no printed value; write 0,981 or 0.981, an angle as 32°51\' or a quotient as 1/72'
    )


RIGHT, LAST_PLACE, ON_THE_WAY, OTHER_FORMULA = "right", "last_place", "rounded_on_the_way", "other_formula"
COARSER = "coarser_place"
SIGN, DIGIT, EXCHANGED, CARRIED, UNEXPLAINED = "sign", "digit", "exchanged", "carried_over", "unexplained"
# Which of the values a page shows.
ALL, DEVIATIONS = "all", "deviations"
ONLY = (ALL, DEVIATIONS)
# Of a last place that the printed intermediates give.
FOLLOWS = "follows"
# What is a rounding, and no slip that other values could carry on.
ROUNDINGS = (RIGHT, LAST_PLACE, ON_THE_WAY, COARSER)
# In the order in which they are tried.
VERDICTS: Mapping[str, Words] = {
    RIGHT: words("richtig|right"),
    LAST_PLACE: words("letzte Stelle|last place"),
    ON_THE_WAY: words("unterwegs gerundet|rounded on the way"),
    OTHER_FORMULA: words("andere Formel|another formula"),
    COARSER: words("richtig auf gröbere Stelle|right to a coarser place"),
    SIGN: words("Vorzeichen|sign"),
    DIGIT: words("eine Ziffer|one digit"),
    EXCHANGED: words("zwei Ziffern vertauscht|two digits exchanged"),
    CARRIED: words("Fehler übernommen|slip carried over"),
    UNEXPLAINED: words("ungeklärt|unexplained"),
}


def tone_of(kind: str) -> Tone:
    """Return how a verdict is to be taken."""
    if kind == RIGHT:
        return "right"
    if kind == OTHER_FORMULA:
        return "other"
    return "near" if kind in ROUNDINGS else "wrong"


class Verdict(NamedTuple):
    """A verdict, and what it is about: the other method, the coarser place, the digit, the cell that the slip
    is in."""

    kind: str
    detail: str = ""


class Evidence(NamedTuple):
    """What is known of a printed value: recomputed in its unit, the same by other methods, and in what cells.

    `right` is None for what no quotient is, where one is printed. `on_the_way` is the value from the
    intermediates as printed, None without any; `slips` are those of them that are neither right nor merely
    rounded. `coarsely` is the value in units of 10'.
    """

    printed: PrintedValue
    right: Units | None
    others: Mapping[str, Callable[[], Units | None]]
    on_the_way: Units | None = None
    slips: tuple[str, ...] = ()
    coarsely: Callable[[], Units | None] = lambda: None


def verdict(evidence: Evidence) -> Verdict:
    """Return the first verdict that the evidence bears out; a quotient has no last place."""
    printed, right = evidence.printed, evidence.right
    if printed.scaled == right:
        return Verdict(RIGHT)
    reproduced = evidence.on_the_way is not None and evidence.on_the_way == printed.scaled
    if right is not None and not printed.exact and abs(printed.scaled - right) == 1:
        return Verdict(LAST_PLACE, FOLLOWS if reproduced and not evidence.slips else "")
    if reproduced and not evidence.slips:
        return Verdict(ON_THE_WAY)
    for method, value in evidence.others.items():
        if value() == printed.scaled:
            return Verdict(OTHER_FORMULA, method)
    if printed.in_tens and evidence.coarsely() == printed.coarser().scaled:
        return Verdict(COARSER, printed.standing_for(NEXT_PLACE))
    if right is not None:
        if printed.scaled == -right:
            return Verdict(SIGN)
        if digit := _one_digit(printed.text, printed.standing_for(right)):
            return Verdict(DIGIT, digit)
        if _exchanged(printed.text, printed.standing_for(right)):
            return Verdict(EXCHANGED)
    return Verdict(CARRIED, ", ".join(evidence.slips)) if reproduced else Verdict(UNEXPLAINED)


def _one_digit(printed: str, right: str) -> str:
    """Return "8 for 9" where one digit differs, "1 too many" or "1 missing", nothing otherwise."""
    printed, right = printed.replace("−", "-"), right.replace("−", "-")
    if len(printed) == len(right):
        pairs = [(one, other) for one, other in zip(printed, right, strict=True) if one != other]
        if len(pairs) == 1 and all(char.isdigit() for char in pairs[0]):
            return f"{pairs[0][0]}:{pairs[0][1]}"
        return ""
    longer, shorter = sorted((printed, right), key=len, reverse=True)
    if len(longer) - len(shorter) == 1:
        for place, char in enumerate(longer):
            if char.isdigit() and longer[:place] + longer[place + 1 :] == shorter:
                return f"{char}+" if longer == printed else f"{char}-"
    return ""


def _exchanged(printed: str, right: str) -> bool:
    printed, right = printed.replace("−", "-"), right.replace("−", "-")
    if len(printed) != len(right):
        return False
    places = [index for index, (one, other) in enumerate(zip(printed, right, strict=True)) if one != other]
    if len(places) != 2:
        return False
    first, second = places
    between = printed[first + 1 : second]
    neighbours = not any(char.isdigit() for char in between)
    return neighbours and (printed[first], printed[second]) == (right[second], right[first])
