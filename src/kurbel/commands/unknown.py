"""A number other than the crank angle for which a condition holds: speed, force, pressure, mass, ratio."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache, cached_property
from typing import Any, NamedTuple

import flint

from kurbel.commands.forces import ForcesOptions
from kurbel.commands.motion import MotionOptions
from kurbel.commands.part import flag_of
from kurbel.commands.parts.angles import as_positions, in_degrees
from kurbel.commands.parts.effort import PRESSING
from kurbel.commands.solve import SolveOptions
from kurbel.conditions.loaded import ASKED, MEASURED, NAMES, measured
from kurbel.conditions.solve import MEASURES, TORQUE, read_on, target_of
from kurbel.conditions.solve_page import SolveRequest, condition_label
from kurbel.conditions.unknown import UNKNOWNS, WORDS, Polynomial, of_ratio
from kurbel.drive.at import At
from kurbel.engine.engine_quantities import value
from kurbel.errors import ProblemError
from kurbel.exact.certify import at_bits, ball
from kurbel.exact.course import Target
from kurbel.exact.kind import FoundAngle, balls
from kurbel.exact.numerals import exact_text, figure, figures, nearest
from kurbel.exact.place import fraction
from kurbel.motion.evaluation import kernel_of
from kurbel.motion.evaluation import value as at
from kurbel.page.axes import angle_text
from kurbel.page.layouts import layout
from kurbel.page.quantity import words
from kurbel.reading import units
from kurbel.reading.names import enumerated
from kurbel.reading.where import MAX, VALUE, Condition, read_condition

GREATEST_RATIO = Fraction(999, 1000)
MASSES = ("reciprocating", "rod_mass", "rotating", "rod_file")
# What makes a force of these unknowns, where others take --force.
MOVING = {"bore": "--head-pressure", "speed": "--reciprocating"}
FLAG = re.compile("--[a-z-]+")
# Of conditions on the motion: x = 200 mm.
_WITH_UNIT = re.compile(r"=\s*[-+−]?[\d.,/]+\s*[a-z]")
# Of these conditions the square of the formula is a polynomial.
MAGNITUDES = ("crosshead_pin_force", "crank_pin_force", "bearing_force")
FORCES = (
    *("rod_force", "guide_force", "tangential_force", "radial_force", "bearing_along", "bearing_across"),
    *("crosshead_load", "piston_force", "inertia_force"),
)
CHECKED_BITS = 400
# Each takes some hundredths of a second.
MOST_ANGLES = 1000


class Angle(NamedTuple):
    """The crank angle φ in degrees, on the outstroke where a condition on the motion gives it."""

    degrees: Fraction

    @classmethod
    def read(cls, angle: Fraction | str, unknown: str, asked: SolveOptions) -> Angle:
        if isinstance(angle, Fraction):
            return cls(angle)
        if unknown == "ratio":
            raise ProblemError(f"--angle {angle} depends on the ratio that is asked for; give it in degrees")
        chosen = asked.drive()
        return cls(in_degrees((angle,), asked.values, layout(chosen.layout, asked.layouts).ratios)[0])

    def label(self, lang: str) -> str:
        found = self.degrees
        asked = found.held.asked if isinstance(found, FoundAngle) else None
        if not isinstance(asked, SolveRequest):
            return f"$φ = {angle_text(found)}$"
        condition = asked.conditions[0]
        if condition.kind == MAX:
            return words(f"dem größten ${condition.quantity}$|the greatest ${condition.quantity}$")[lang]
        return condition_label(condition, asked.drives[0], lang)


def angles_of(angle: object) -> Sequence[Fraction | str]:
    """Return the crank angles, or conditions that hold there as they are written. Raises KurbelError."""
    if angle is None:
        raise ProblemError(
            "--unknown asks for a number with which a condition holds at a crank angle; add that as"
            " --angle 30, or as what holds there, --angle c=max or s=10%"
        )
    angles = as_positions(angle)
    if len(angles) > MOST_ANGLES:
        raise ProblemError(
            f"{len(angles)} crank angles were given, and --unknown is solved at {MOST_ANGLES} at most; give a"
            " wider step"
        )
    return angles


class RatioUnknown:
    """The crank ratio of the straight or offset crank, its crosshead's motion known by formulas."""

    def __init__(self, unknown: str, angle: Fraction | str, text: str, asked: SolveOptions) -> None:
        self.asked, self.place = (unknown, angle, text, asked), Angle.read(angle, unknown, asked)
        if asked.is_engine() or asked.says("force", "rod", *MASSES):
            raise ProblemError(
                "--unknown ratio is of the motion of the piston, without rod length, forces and masses; leave"
                " these out"
            )
        # A stroke counts where a length is compared with it.
        lone = () if _WITH_UNIT.search(text) or asked.says("offset") else ("stroke",)
        any_ratio = SolveOptions(asked.values.instead({"ratio": "1:4"}, own=True))
        chosen, described = any_ratio.described(leaving=lone)
        if not chosen.crosshead:
            raise ProblemError("--unknown ratio is of the straight and the offset crank")
        if described.method == "infinite":
            raise ProblemError("--method infinite is of a rod without a ratio; leave it out")
        self.drive = chosen.solved(chosen.drives(described, ()), asked.series())[0]
        self.condition = read_on(self.drive, text)
        if (
            self.condition.unit
            and (column := MEASURES[self.condition.quantity].column) not in self.drive.columns
        ):
            needs = " and ".join(self.drive.entries[column].options)
            raise ProblemError(f'condition "{self.condition}" is in {self.condition.unit} and needs {needs}')
        if self.condition.kind not in (VALUE, MAX) or (
            self.condition.kind == MAX and self.condition.quantity != "c"
        ):
            raise ProblemError("--unknown ratio takes a value, such as x=1.1 or psi=15, or c=max")

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), self.asked

    @property
    def greatest(self) -> Fraction:
        return GREATEST_RATIO / (1 + abs(self.drive.crank.offset))

    @cached_property
    def found(self) -> list[Callable[[], flint.arb]]:
        drive, condition = self.drive, self.condition
        if condition.kind == MAX:
            # The acceleration is zero once on the outstroke, where the velocity is greatest.
            if drive.crank.offset:
                raise ProblemError("c=max with --unknown ratio is of the straight crank; leave --offset out")
            if not 0 < self.place.degrees < 180:
                raise ProblemError("the velocity is greatest within the outstroke; give an angle in 0..180")
            condition, target = replace(condition, quantity="p"), Target.rational(Fraction(0))
        else:
            target = target_of(drive, condition, 1)
        kernel = kernel_of(drive.asked(condition.quantity, 1), drive.method, drive.crank)
        scale = drive.asked(condition.quantity, 1).scale

        def formula(ratio: object) -> object:
            kind = balls()
            offset = kind.of(drive.crank.offset) if drive.crank.offset else None
            found = kernel(At(kind.circle(self.place.degrees), drive.crank, kind, 1, ratio, offset))
            return found * scale(drive.crank, kind) if scale else found

        return of_ratio(formula, target.ball, self.greatest)

    def label(self, lang: str) -> str:
        return condition_label(self.condition, self.drive, lang)

    def lines(self, lang: str) -> list[str]:
        return [WORDS["ratio"][lang].format(greatest=f"${figure(self.greatest)}$")]


class PolynomialUnknown:
    """A speed, a force, a pressure, a mass or a length that a force or the motion is a polynomial of."""

    def __init__(self, unknown: str, angle: Fraction | str, text: str, asked: SolveOptions) -> None:
        self.asked = (unknown, angle, text, asked)
        self.place = Angle.read(angle, unknown, asked)
        self.unknown, self.values, self.about = unknown, asked.values, UNKNOWNS[unknown]
        self.loaded = asked.is_engine()
        if asked.says("card"):
            raise ProblemError(
                "--unknown under an indicator card is not solved: between its points nothing is proved; give"
                " ideal steam, such as --eps 4"
            )
        if not self.loaded and not asked.drive().crosshead:
            raise ProblemError(
                "--unknown is of the straight and the offset crank, and of others under the load of an engine"
            )
        if unknown == "pressure" and not self.loaded:
            raise ProblemError(
                "--unknown pressure is that of an engine's steam; add its expansion ratio, --eps 4, or ask"
                " for the force on the piston, --unknown force"
            )
        if unknown == "force" and (given := next((one for one in PRESSING if asked.says(one)), "")):
            raise ProblemError(
                f"--unknown force asks for the force on the piston, and {flag_of(given)} gives it; leave one"
                " of the two out"
            )
        if unknown == "stroke" and asked.says("rod"):
            raise ProblemError("--unknown stroke is at a crank ratio; give --ratio in place of --rod")
        if self.loaded and asked.method not in (None, "exact"):
            raise ProblemError("--unknown under a load is solved by the exact formulas; leave --method out")
        self.condition, self.column = self._read(text)
        self.question = cache(self._question)
        if (count := len(self._first())) != 1:
            raise ProblemError(f"--unknown is of one drive under one load, and {count} were given; give one")

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), self.asked

    def _first(self) -> Any:
        """Return the question with the first value that is tried. Raises ProblemError for what the condition
        needs beside that."""
        try:
            return self.question(self.about.probe)
        except ProblemError as error:
            pushed = ("force",) if self.values.says(*PRESSING, *MASSES) else ()
            own = (self.unknown, *pushed, *(one for one in self.values.values if self.values.says(one)))
            flags = (
                MOVING.get(self.unknown, one) if one == "--force" else one for one in FLAG.findall(str(error))
            )
            needed = [one for one in flags if one not in map(flag_of, own)]
            if not (needed and str(error).startswith(f"column {self.column}")):
                raise
            raise ProblemError(f'condition "{self.condition}" needs {enumerated(needed)}') from None

    def _read(self, text: str) -> tuple[Condition, str]:
        """Return the condition and the column that shows what it is about, in N, N m or a unit of motion."""
        if self.loaded:
            found = read_condition(text, NAMES, MEASURED, "torque and the forces of the crank drive")
            return self._valued(found, ASKED[found.quantity].measured)
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
        moved = not self.loaded and self.column.endswith(("_mm", "_mps", "_mps2"))
        own = {"angle": [self.place.degrees], "columns": [self.column], "layout": None, "units": None}
        values = self.values.instead({**own, self.unknown: value})
        return (MotionOptions if moved else ForcesOptions)(values).question()

    def value(self, number: Fraction) -> Any:
        """Return the force or motion at a value of the unknown, in balls."""
        question = self.question(number)
        column = question.page_columns[0]
        if self.loaded:
            turn = question.turn(0, 0, "exact")
            place = {name: 0 for name in question.axes}
            return value(column.quantity, turn, question.where(place))
        kind = balls()
        return at(column.quantity, column.method, question.cranks[0], kind.circle(self.place.degrees), kind)

    @cached_property
    def found(self) -> list[Callable[[], flint.arb]]:
        square = self.condition.quantity in MAGNITUDES
        if square and self.condition.value < 0:
            raise ProblemError(f'condition "{self.condition}" is of a magnitude, which is not below 0')
        power = 1 if self.column.endswith("_mps") else self.about.power
        degree = 2 if self.unknown == "stroke" and self.condition.quantity == "torque" else 1
        polynomial = Polynomial(
            self.value, lambda: ball(self._target()), self.about.probe, power, degree, square
        )
        found = polynomial.roots()
        for root in found:
            self._check(root)
        return found

    def _check(self, root: Callable[[], flint.arb]) -> None:
        """Raise ProblemError for a value that no drive has, or one with which the formula is another."""
        with at_bits(CHECKED_BITS):
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
        if not self.condition.unit:
            return Fraction(0)
        if self.condition.quantity in MEASURES:
            one = MEASURES[self.condition.quantity]
            return one.parts * one.metres(self.condition)
        if self.loaded or self.condition.quantity != TORQUE:
            return measured(self.condition)
        return units.signed_torque(f"{exact_text(self.condition.value)} {self.condition.unit}", TORQUE)

    def label(self, lang: str) -> str:
        symbol = self.question(self.about.probe).page_columns[0].quantity.symbol.strip("$")
        unit = f' "{self.condition.unit}"' if self.condition.unit else ""
        unit = unit.replace('²"', '"^2').replace('m^2"', 'm"^2')
        return f"${symbol} = {exact_text(self.condition.value)}{unit}$"

    def lines(self, lang: str) -> list[str]:
        """Return what the page of the force or the motion says, with the first value that was found."""
        with at_bits(CHECKED_BITS):
            near = fraction(self.found[0]().mid()) / self.about.size
        shown = nearest(near, figures(float(near)))
        value = Fraction(shown.scaled, 10**shown.decimals) * self.about.size
        question = self.question(value)
        return [
            WORDS["all"][lang],
            *(one for one in question.below() if isinstance(one, str)),
        ]
