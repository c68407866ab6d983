"""Long columns in floats: their digits are those of balls, whatever forces act and however many are asked."""

from __future__ import annotations

from fractions import Fraction

import pytest

from kurbel.drive.crank import Crank
from kurbel.drive.load import PistonForce
from kurbel.drive.rod import Moving, Rod
from kurbel.motion.bulk import columns_in_floats
from kurbel.motion.evaluation import LOADED, columns_in_balls
from kurbel.motion.quantities import registry
from kurbel.page.quantity import bare
from kurbel.reading.notation import Progression
from kurbel.reading.units import Speed

ROD = Rod(Fraction("0.6"), Fraction("0.09"), Fraction(150))
ONE_A_SECOND = Speed(Fraction(1), turns=False)


def machine(force: Fraction | None, moving: Moving) -> Crank:
    """Return a crank of 1 m at 1 rad/s: a mass of m kg calls up forces of about m N."""
    push = None if force is None else PistonForce(force)
    return Crank(Fraction(1, 4), radius=Fraction(1), speed=ONE_A_SECOND, force=push, moving=moving)


# A force alone is as large as the masses' together, and masses as large as their counterweights.
MACHINES = {
    "no force": machine(None, Moving(Fraction(300), ROD, Fraction(40))),
    "as much force": machine(Fraction(812), Moving(Fraction(300), ROD, Fraction(40))),
    "counterweights": machine(None, Moving(Fraction(300), ROD, Fraction(-772))),
}


@pytest.mark.parametrize("name", MACHINES)
def test_forces_in_floats_have_the_digits_of_balls_however_many(name: str) -> None:
    crank = MACHINES[name]
    angles = Progression(Fraction(-17), Fraction(119, 17), 55)
    keys = [key for key, entry in registry().items() if LOADED in entry.formulas]
    assert len(keys) > 8
    # Of some hundred newtons floats have the twelfth decimal only now and then.
    columns = [bare(registry()[key], "exact", 12) for key in keys]
    floats = columns_in_floats(columns, crank, angles, "half-away")
    balls = columns_in_balls(columns, crank, angles, "half-away")
    for column, found, true in zip(columns, floats, balls, strict=True):
        assert found.tolist() == true, column.quantity.key
