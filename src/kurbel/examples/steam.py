"""The formulas behind Weisbach's example of the expansion engine, by his own equations for the angles.

Source: Weisbach-Herrmann, § 150; the turn is that of `kurbel delta --method weisbach`.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import lru_cache
from typing import Any

from kurbel.drive.crank import Crank
from kurbel.engine.engine import Engine, Steam
from kurbel.engine.quantities import OUTSTROKE, RETURN_STROKE, WHOLE
from kurbel.engine.turn import WeisbachTurn
from kurbel.errors import ProblemError
from kurbel.examples.kinds import Formula, Given
from kurbel.reading.notation import about


@lru_cache(maxsize=16)
def _turn(ratio: Fraction, expansion: Fraction, back: Fraction | None) -> WeisbachTurn:
    return WeisbachTurn(Engine(Crank(ratio), Steam(expansion, back)), "weisbach")


def engine_turn(given: Given) -> WeisbachTurn:
    """Return the turn; raise ProblemError for steam that drives nothing."""
    if given["eps"] <= 1:
        raise ProblemError("the way of § 150 is for expanding steam; give an expansion ratio above 1")
    return _turn(given["ratio"], given["eps"], given.get("back"))


def check_steam(given: Given) -> None:
    """Raise ProblemError where the book's equation for α₂ does not hold."""
    if not engine_turn(given).expands_first:
        raise ProblemError(
            f"at ε = {about(given['eps'])} the speed is greatest before the cut-off, where the equation of"
            " § 150 for α₂ does not hold; give a larger expansion ratio"
        )


def _of(value: Callable[[WeisbachTurn], Any]) -> Formula:
    return lambda given, kind: value(engine_turn(given))


def _angle(greatest: bool, stroke: int) -> Formula:
    return _of(lambda turn: 180 * turn.extreme(greatest, stroke).place)


def _speed(greatest: bool, stroke: int | None) -> Formula:
    """v/v₁ - 1 at the extreme, in Q r/(m₁ v₁²)."""
    return _of(lambda turn: turn.extreme(greatest, stroke).energy)


STEPS: dict[str, Formula] = {
    "alpha_min_return": _angle(False, RETURN_STROKE),
    "alpha_min": _angle(False, OUTSTROKE),
    "v_min_return": _speed(False, RETURN_STROKE),
    "v_min": _speed(False, OUTSTROKE),
    "alpha_max_return": _angle(True, RETURN_STROKE),
    "alpha_max": _angle(True, OUTSTROKE),
    "v_max_return": _speed(True, RETURN_STROKE),
    "v_max": _speed(True, OUTSTROKE),
    "greatest": _speed(True, WHOLE),
    "least": _speed(False, WHOLE),
    "sum": _of(lambda turn: turn.irregularity() * turn.mean_force()),
    "mean_force": _of(lambda turn: turn.mean_force()),
    "divisor": _of(lambda turn: turn.mean_force()),
    "delta": _of(lambda turn: turn.irregularity()),
}


def is_best(given: Given) -> bool:
    """Whether the back pressure is that of the steam at the end of the stroke, R = Q/ε."""
    return given.get("back") in (None, 1 / given["eps"])
