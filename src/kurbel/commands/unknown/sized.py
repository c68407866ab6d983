"""A speed, force, pressure, mass or length for which a condition holds at an angle."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import cache, cached_property
from typing import Any

from kurbel.commands.loads import OWN
from kurbel.commands.old_motion import meant
from kurbel.commands.options import is_given
from kurbel.commands.unknown.place import Angle
from kurbel.errors import ProblemError
from kurbel.reading.where import VALUE, Condition

# Of these conditions the square of the formula is a polynomial.
MAGNITUDES = ("crosshead_pin_force", "crank_pin_force", "bearing_force")
FORCES = (
    *("rod_force", "guide_force", "tangential_force", "radial_force", "bearing_along", "bearing_across"),
    *("crosshead_load", "piston_force", "inertia_force"),
)
CHECKED_BITS = 400
# What the page of the unknown has itself.
OF_PAGE = ("columns", "layout", "label")


class Sized:
    """A speed, a force, a pressure, a mass or a length that a force or the motion is a polynomial of."""

    def __init__(self, unknown: str, angle: Any, text: str, given: Mapping[str, Any]) -> None:
        from kurbel.solve.unknown import UNKNOWNS

        self.asked = (unknown, angle, text, given)
        self.place = Angle.read(angle, unknown, given)
        self.unknown, self.given, self.about = unknown, given, UNKNOWNS[unknown]
        self.loaded = any(is_given(given.get(name)) for name in (*OWN, "cylinder"))
        if is_given(given.get("card")):
            raise ProblemError(
                "--unknown under an indicator card is not solved: between its points nothing is proved; give"
                " ideal steam, such as --eps 4"
            )
        if not self.loaded and not meant({**given, "layout": None}).crosshead:
            raise ProblemError(
                "--unknown is of the straight and the offset crank, and of others under the load of an engine"
            )
        if unknown == "stroke" and is_given(given.get("rod")):
            raise ProblemError("--unknown stroke is at a crank ratio; give --ratio in place of --rod")
        if self.loaded and self.place.degrees is None:
            raise ProblemError("under a load the angle is one in degrees; write it as --angle 30")
        if self.loaded and given.get("method") not in (None, "exact"):
            raise ProblemError("--unknown under a load is solved by the exact formulas; leave --method out")
        self.condition, self.column = self._read(text)
        self.question = cache(self._question)
        if (count := len(self.question(self.about.probe))) != 1:
            raise ProblemError(f"--unknown is of one drive under one load, and {count} were given; give one")

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), self.asked

    def _read(self, text: str) -> tuple[Condition, str]:
        """Return the condition and the column that shows what it is about, in N, N m or a unit of motion."""
        from kurbel.reading.where import read_condition
        from kurbel.solve.loaded import ASKED, MEASURED, NAMES

        if self.loaded:
            found = read_condition(text, NAMES, MEASURED, "torque and the forces of the crank drive")
            return self._valued(found, ASKED[found.quantity].measured)
        from kurbel.solve.solve import MEASURES, TORQUE

        names = {name: name for name in (*MEASURES, *FORCES, *MAGNITUDES, TORQUE)}
        found = read_condition(text, names, names, "motion and forces")
        if found.quantity in MEASURES:
            return self._valued(found, MEASURES[found.quantity].column)
        return self._valued(
            found, f"{found.quantity}_nm" if found.quantity == TORQUE else f"{found.quantity}_n"
        )

    def _valued(self, condition: Condition, column: str) -> tuple[Condition, str]:
        if condition.kind != VALUE:
            raise ProblemError(f'condition "{condition}" has no value; --unknown needs one, such as torque=0')
        if not column:
            raise ProblemError(f"{condition.quantity} has no unit of force; ask for torque or a force")
        if condition.value and not condition.unit:
            raise ProblemError(
                f'condition "{condition}" needs a unit, for what is asked for has one; write it in N,'
                " N m, mm, m/s or m/s²"
            )
        return condition, column

    def _question(self, value: Fraction) -> Any:
        """Return the question of the drive with a value of the unknown, at the angle."""
        from kurbel.commands.forces import forces_table
        from kurbel.commands.motion import table

        moved = not self.loaded and self.column.endswith(("_mm", "_mps", "_mps2"))
        function = table if moved else forces_table
        known = {
            name: given
            for name, given in {**self.given, self.unknown: value, "units": "metric"}.items()
            if name in function.command.signature.parameters and is_given(given) and name not in OF_PAGE
        }
        angle = self.place.degrees if self.place.degrees is not None else Fraction(0)
        return function.question(angle=[angle], columns=[self.column], **known)

    def value(self, number: Fraction) -> Any:
        """Return the force or motion at a value of the unknown, in balls."""
        question = self.question(number)
        column = question.page_columns[0]
        if self.loaded:
            from kurbel.engine.quantities import value

            turn = question.turn(0, 0, "exact")
            place = {name: 0 for name in question.axes}
            return value(column.quantity, turn, question.where(place))
        from kurbel.exact.kind import balls
        from kurbel.motion.evaluation import value as at

        kind = balls()
        return at(column.quantity, column.method, question.cranks[0], self.place.circle(kind), kind)

    @cached_property
    def found(self) -> list[Any]:
        from kurbel.exact.certify import ball
        from kurbel.solve.unknown import Polynomial

        square = self.condition.quantity in MAGNITUDES
        if square and self.condition.value < 0:
            raise ProblemError(f'condition "{self.condition}" is of a magnitude, which is not below 0')
        polynomial = Polynomial(
            self.value, lambda: ball(self._target()), self.about.probe, self._power(), self._degree(), square
        )
        found = polynomial.roots()
        for root in found:
            self._check(root)
        return found

    def _check(self, root: Callable[[], Any]) -> None:
        """Raise ProblemError for a value that no drive has, or one with which the formula is another."""
        import flint

        from kurbel.exact.certify import ball
        from kurbel.exact.place import fraction

        with flint.ctx.workprec(CHECKED_BITS):
            near = fraction(root().mid())
            apart = self.value(near) - ball(self._target())
            scale = abs(self.value(near)) + abs(self.value(self.about.probe))
            if not abs(apart) < scale * flint.arb(2) ** (-CHECKED_BITS // 4):
                name = self.unknown.replace("_", " ")
                raise ProblemError(
                    f"{self.condition} depends on the {name} in more than one way, as by friction; this is"
                    " not solved"
                )

    def _target(self) -> Fraction:
        from kurbel.solve.loaded import measured
        from kurbel.solve.solve import MEASURES, TORQUE

        if not self.condition.unit:
            return Fraction(0)
        if self.condition.quantity in MEASURES:
            one = MEASURES[self.condition.quantity]
            return one.parts * one.metres(self.condition)
        if self.loaded or self.condition.quantity != TORQUE:
            return measured(self.condition)
        from kurbel.exact.numerals import exact_text
        from kurbel.reading import units

        return units.signed_torque(f"{exact_text(self.condition.value)} {self.condition.unit}", TORQUE)

    def _power(self) -> int:
        return 1 if self.column.endswith("_mps") else self.about.power

    def _degree(self) -> int:
        return 2 if self.unknown == "stroke" and self.condition.quantity == "torque" else 1

    def label(self, lang: str) -> str:
        from kurbel.exact.numerals import exact_text

        symbol = self.question(self.about.probe).page_columns[0].quantity.symbol.strip("$")
        unit = f' "{self.condition.unit}"' if self.condition.unit else ""
        unit = unit.replace('²"', '"^2').replace('m^2"', 'm"^2')
        return f"${symbol} = {exact_text(self.condition.value)}{unit}$"

    def lines(self, lang: str) -> list[str]:
        """Return what the page of the force or the motion says, with the first value that was found."""
        import flint

        from kurbel.exact.numerals import figures, nearest
        from kurbel.exact.place import fraction
        from kurbel.solve.unknown_page import WORDS

        with flint.ctx.workprec(CHECKED_BITS):
            near = fraction(self.found[0]().mid()) / self.about.size
        shown = nearest(near, figures(float(near)))
        value = Fraction(shown.scaled, 10**shown.decimals) * self.about.size
        question = self.question(value)
        return [
            WORDS["all"][lang],
            *(one for one in question.subject.notes(question) if isinstance(one, str)),
        ]
