"""The plan of velocities turned round by 90°, from which the velocity of the crosshead is read off.

Steps and C are those of Schmolke, Dinglers Polytechnisches Journal 330 (1915), 476, Abb. 3; O, P and Q are
those of his Abb. 4.
"""

from __future__ import annotations

from kurbel.books.constructions.geometry import Point, plus, turned
from kurbel.books.constructions.model import (
    GIVEN,
    Arrow,
    Construction,
    Measure,
    Placed,
    Points,
    RightAngle,
)
from kurbel.books.constructions.rates import plan
from kurbel.books.constructions.rates.rocker import OF_ROCKER
from kurbel.page.quantity import words


def _points(at: Placed) -> Points:
    pin, head, shaft, c = at.pin, at.crosshead, at.shaft, plan.turned_plan(at)
    return {
        "O": shaft,
        "P": pin,
        "Q": head,
        "C": c,
        "V": plus(pin, turned(pin)),
        "W": plus(head, turned(c)),
        "across": Point(head.x, shaft.y),
        "above": Point(shaft.x, head.y),
    }


VELOCITY = Construction(
    name="velocity",
    title=words(
        "Kolbengeschwindigkeit aus dem gedrehten Geschwindigkeitsplan"
        "|Velocity of the piston, from the turned-round plan of velocities"
    ),
    source=plan.SCHMOLKE,
    points=_points,
    angle_symbol="$φ$",
    holds=("straight", "offset", "arc"),
    steps=(
        plan.drive_step("P", "Q", Arrow("P", "V", "$v$", GIVEN), RightAngle("P", "O", "V")),
        plan.plan_step("P", "Q", "C", Measure("PC", look=GIVEN), Measure("OC")),
        plan.BACK,
    ),
    variants={"arc": OF_ROCKER},
    notes=(
        words(
            "$c$ ist im Hingang positiv, $u/ω$ der Betrag der Formel"
            "|$c$ is positive on the outstroke, $u/ω$ the amount of its formula"
        ),
    ),
    lengths=(plan.velocity_length("O", "C"), plan.swing_length("P", "C", "Q")),
)
