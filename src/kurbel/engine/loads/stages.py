"""The work of steam in the stages of a stroke: before the cut-off, of the expansion, of the back pressure."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from kurbel.engine.cylinder import AnyTurn
from kurbel.kernel.steam import Expansion

# Keys, names and Weisbach's letters.
NAMES = (
    ("full_pressure_work", "Volldruckarbeit eines Hubes|Work at full pressure in a stroke", "$A_1$"),
    ("expansion_work", "Expansionsarbeit eines Hubes|Work of the expansion in a stroke", "$A_2$"),
    ("back_work", "Gegendruckarbeit eines Hubes|Work of the back pressure in a stroke", "$A_3$"),
)


def work(key: str, turn: AnyTurn, where: Any) -> Any:
    """Return the work of a stage in Q R, a fraction where it is rational; A₁ + A₂ - A₃ is that of a stroke.

    A₁ = 2/ε, A₂ = 2 ln ε/ε, A₃ = 2 b of a straight crank by Mariotte's law. Source: Weisbach-Herrmann,
    § 150; the exponent, the clearance and other strokes than 2 R are ours.
    """
    kind, steam = turn.cylinder.kind, turn.engine.parts[0].ideal
    length = turn.cylinder.drive.length
    exact = isinstance(length, int) and steam.exponent.denominator == 1
    rational = exact and (key != "expansion_work" or steam.exponent != 1)
    numbers = steam.numbers(*((_itself, _itself) if rational else (kind.of, kind.exponent)))
    return length * _FORMULAS[key](numbers, Fraction(1) if rational else kind.of(Fraction(1)))


def _itself(value: Fraction) -> Fraction:
    return value


def _expansion(steam: Expansion, whole: Any) -> Any:
    return steam.work(whole) - steam.full_pressure_work(whole)


_FORMULAS: dict[str, Callable[[Expansion, Any], Any]] = {
    "full_pressure_work": lambda steam, whole: steam.cut_off * whole,
    "expansion_work": _expansion,
    "back_work": lambda steam, whole: steam.back * whole,
}
