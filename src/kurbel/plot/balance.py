"""What is drawn of an engine's free forces or moments: their vector over the turn of the shaft."""

from __future__ import annotations

from dataclasses import fields
from fractions import Fraction

from kurbel.balancing.angles.page import AngleRequest
from kurbel.balancing.newtons import IN_NEWTONS
from kurbel.balancing.page import RESIDUALS, BalanceRequest
from kurbel.balancing.words import UNITS, WORDS
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Number
from kurbel.page.axes import Place
from kurbel.page.quantity import Column, words
from kurbel.plot.chart.vector import PinForce, Vector
from kurbel.plot.picture import Picture, Wish, check_one, drawing_layout, refuse, smooth

# The steps of the turn; each takes exact numbers.
STEPS = 120
# A share of the greatest value that is none.
NEARLY = 1e-3
NEWTONS = {"force": "N", "moment": "N m"}
ALONG, ACROSS = "along", "across"
TITLE = words("Polardiagramm: {residual}, {caption}|Polar diagram: {residual}, {caption}")


def unbalanced(request: BalanceRequest, wish: Wish) -> Picture:
    """Return the free force over the turn, of an engine without one the free moment, of all orders together.

    Raises ProblemError where both are balanced.
    """
    sentence = "free forces are drawn as their vector; leave {} out"
    refuse(wish, infinite=sentence.format("--infinite"), over_path=sentence.format("--over-path"))
    check_one(len(request.ratios), "crank ratios")
    own = {one.name: getattr(request, one.name) for one in fields(BalanceRequest)}
    newtons = IN_NEWTONS if request.weighed is not None else ""
    angles = smooth((Fraction(0), Fraction(360)), STEPS)
    asked = AngleRequest(
        **{
            **own,
            "layout": drawing_layout("balance-angle"),
            "columns": (ACROSS + newtons, ALONG + newtons),
            "digits": None,
            "angles": angles,
        }
    )
    found = {key: _force(asked, place, newtons) for place, key in enumerate(RESIDUALS)}
    most = {key: max(map(abs, (*one.vector.across, *one.vector.up))) for key, one in found.items()}
    if not any(most.values()):
        raise ProblemError(
            "all free forces and moments of this engine are balanced; there is nothing to draw"
        )
    # What is left of high orders alone is not drawn.
    key = next(key for key in RESIDUALS if most[key] > NEARLY * max(most.values()))
    caption = asked.subject.caption(asked)
    title = TITLE[request.lang].format(residual=WORDS[key][request.lang], caption=caption)
    return Picture(asked, force=found[key], title=title)


def _force(asked: AngleRequest, residual: int, newtons: str) -> PinForce:
    """Return the vector of all orders together over the angles."""
    key, last = RESIDUALS[residual], len(asked.lines) - 1
    places = [
        {"ratio": 0, "residual": residual, "angle": angle, "order": last}
        for angle in range(len(asked.angles))
    ]

    def value(column: Column, place: Place) -> float:
        found = asked.number(column, place)
        return float(found.scaled) / 10**found.decimals if isinstance(found, Number) else 0.0

    across, up = ([value(column, place) for place in places] for column in asked.page_columns)
    name, words = WORDS[key][asked.lang], [one.quantity.heading[asked.lang] for one in asked.page_columns]
    names = f"{name} {words[0].partition(' in ')[0]}", f"{name} {words[1].partition(' in ')[0]}"
    unit = NEWTONS[key] if newtons else UNITS[key]
    return PinForce(Vector([*map(float, asked.angles)], across, up), names, unit, ways=("", ""))
