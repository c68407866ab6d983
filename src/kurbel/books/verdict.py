"""What a printed value is found to be, from evidence alone and in a fixed order.

A verdict says how the characters relate to the recomputed value. Whether compositor, author or transcriber
set them so, no value tells.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

from kurbel.books.printed_value import NEXT_PLACE, Printed, Units
from kurbel.page.quantity import Words, words
from kurbel.page.table import Tone

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


def columns_or(own: tuple[str, ...], asked: tuple[str, ...]) -> tuple[str, ...]:
    """Return the columns of records that were asked for, else a page's own; the place tells them apart."""
    return (*("place",) * ("place" not in asked), *asked) if asked else own


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

    printed: Printed
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
