"""A press: its strokes, their work, and how long of a cycle it works."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import NamedTuple

from kurbel.commands.options import Option, measure
from kurbel.commands.part import Part, flag_of
from kurbel.engine.diagram.relations import figures_of
from kurbel.engine.diagram.sizing import Figures, Known, completed
from kurbel.errors import NotationError, ProblemError
from kurbel.exact.numerals import about
from kurbel.exact.real import Product
from kurbel.reading.given import as_duration, as_energy_an_area, as_length, as_share, as_speed, as_stress
from kurbel.reading.units import is_measure, split

_HALF = Fraction(1, 2)


class Share(NamedTuple):
    """The share of a cycle in which a press works, None of a blow, the rest of it, and what gives them."""

    working: Product | None
    rest: Product
    option: str


class Press(Part):
    """A press, between whose strokes the motor makes good what they took of the flywheel."""

    topic = "press"

    strokes = measure(
        lambda value, what: _strokes(value), "Press: working strokes, 30/min.", "SPEED",
        unit="strokes a second",
    )  # fmt: skip
    share = measure(
        as_share, "Press: share of the cycle in which it works, 1/4; 0 for a blow.", "SHARE",
        what="share of the cycle",
    )  # fmt: skip
    duration = measure(
        as_duration, "Press: how long a stroke takes, in place of the share: 1s.", "TIME",
        what="duration of a stroke",
    )  # fmt: skip
    hole = measure(
        lambda value, what: _hole(value),
        "Press: diameter of the hole and thickness of the plate, whose work it does: '38mm x 32mm'.",
        "SIZES",
        whole=True,
    )
    punch_stroke = measure(
        as_length,
        "Press: stroke of the punch, up and down in a cycle; with --hole it works while it goes through the"
        " plate, of which the share follows: 100mm.",
        "LENGTH", what="stroke of the punch",
    )  # fmt: skip
    shear_energy = measure(
        as_energy_an_area, "Press: energy of a sheared area, for --hole: 7J/mm².", "ENERGY"
    )
    shear_strength = measure(
        as_stress, "Press: strength of the plate, for --hole, whose work is ½ π d t² τ: 300MPa.", "STRESS",
    )  # fmt: skip
    efficiency = measure(
        as_share, "Press: efficiency from the motor, whose power is --power: 95%.", "SHARE", topic="work"
    )

    def of_press(self) -> Iterator[tuple[str, Known]]:
        """Yield the figures of the press, but for the share of its swing. Raises KurbelError."""
        if (strokes := self.strokes) is not None:
            yield "cycles", Known(Product.of(strokes), ("--strokes",))
        if self.is_driven() and (efficiency := self.efficiency) is not None:
            if not 0 < efficiency <= 1:
                raise ProblemError(f"the efficiency is {about(efficiency)}; it must be above 0 and at most 1")
            yield "efficiency", Known(Product.of(efficiency), ("--efficiency",))
        if self.says("hole"):
            yield "work", self._punched()
        share, duration = self._working(), self._stroke()
        if share and duration is not None:
            yield "cycles", Known(Product.of(share / duration), ("--share", "--duration"))

    def is_driven(self) -> bool:
        """Whether a motor drives what the flywheel is for, with an efficiency."""
        return self.says("power", "work", "hole", "energy_fluctuation")

    def share_of(self, figures: Figures) -> Share | None:
        """Return the share of a cycle in which the press works, None of what is no press."""
        share, duration = self._working(), self._stroke()
        if share is not None:
            option = flag_of("punch_stroke" if self.says("punch_stroke") else "share")
            return Share(Product.of(share) if share else None, Product.of(1 - share), option)
        if duration is None:
            return None
        if (cycles := completed(figures).get("cycles")) is None:
            raise ProblemError(
                "--duration is a share of the time between two strokes; add --strokes, or --power and --work"
            )
        part, between = Product.of(duration) * cycles.value, Product.of(1) / cycles.value
        if not Product.of(1).exceeds(part):
            raise ProblemError(
                f"a stroke takes {about(duration)} s and comes again after {figures_of(between)} s; it must"
                " take less than that"
            )
        return Share(part, Product.of(1).plus(part, -1), "--duration")

    def unread(self, option: Option[object]) -> str:
        if option.name in ("shear_energy", "shear_strength"):
            return f"{flag_of(option.name)} is for the work of a --hole; add that, or give --work"
        if option.name == "punch_stroke":
            return "--punch-stroke is for the time that a --hole takes; add that, or give --share"
        if option.name == "efficiency":
            return (
                "--efficiency is that between a motor and its press; add --power, or --work and --strokes, or"
                " leave it out"
            )
        return ""

    def _working(self) -> Fraction | None:
        share, hole = self.share, self.hole
        if hole is not None and (stroke := self.punch_stroke) is not None:
            # It goes down and up again evenly, and works through the plate.
            if share is not None:
                raise ProblemError("--share and --punch-stroke say the same; leave one out")
            if hole[1] > stroke:
                raise ProblemError(
                    f"the plate is {about(1000 * hole[1])} mm thick and the stroke of the punch"
                    f" {about(1000 * stroke)} mm; it must go through the plate"
                )
            share = hole[1] / (2 * stroke)
        if share is not None and not 0 <= share < 1:
            raise ProblemError(
                f"the share of the cycle in which the press works is {about(share)}; it must be 0 or more,"
                " for a blow, and below 1, at which the motor does all the work at once"
            )
        return share

    def _stroke(self) -> Fraction | None:
        duration = self.duration
        if duration is not None and duration <= 0:
            raise ProblemError(f"the duration of a stroke is {about(duration)} s; it must be above 0")
        return duration

    def _punched(self) -> Known:
        """Return the work of a hole: the energy of an area times that which is sheared, π d t; of a strength
        τ half the greatest force, π d t τ, times the thickness."""
        energy, strength = self.shear_energy, self.shear_strength
        if (energy is None) == (strength is None):
            raise ProblemError(
                "--hole needs the energy of the sheared area, --shear-energy 7J/mm², or the strength of the"
                " plate, --shear-strength 300MPa; give one of the two"
            )
        assert self.hole is not None
        diameter, thickness = self.hole
        area = diameter * thickness
        if energy is not None:
            return Known(Product.of(energy * area, 1), ("--hole", "--shear-energy"))
        assert strength is not None
        return Known(Product.of(strength * area * thickness * _HALF, 1), ("--hole", "--shear-strength"))


def _strokes(given: object) -> Fraction:
    """Return strokes a second. Raises KurbelError."""
    turns = as_speed(given)
    if not turns.turns:
        raise NotationError(f"the strokes are {given}; they count a minute or a second, as 30/min")
    return turns.value


def _hole(given: object) -> tuple[Fraction, Fraction]:
    """Return the diameter of a hole and the thickness of the plate in metres. Raises KurbelError."""
    if not (sides := sides_of(given)):
        raise NotationError(
            f'hole "{str(given)[:40]}" is not a diameter and the thickness of the plate, 38mm x 32mm'
        )
    diameter, thickness = (as_length(one, "hole") for one in sides)
    return diameter, thickness


def sides_of(sizes: object) -> list[str]:
    """Return the two lengths of "400mm x 200mm" or "400 x 200 mm", none of another text."""
    sides = re.split(r"[x×]", sizes) if isinstance(sizes, str) else []
    return in_one_unit(sides) if len(sides) == 2 else []


def in_one_unit(texts: Sequence[str]) -> list[str]:
    """Return measures of which the last alone may have a unit, each with it: 200 and 225/min."""
    *others, last = (text.strip() for text in texts)
    unit = split(last)[1] if is_measure(last) else ""
    return [*(text if is_measure(text) else f"{text}{unit}" for text in others), last]
