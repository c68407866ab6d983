"""The crank angle of a condition: in degrees, or where a quantity of the motion is greatest."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from kurbel.commands.loads import OWN
from kurbel.commands.old_motion import described, some
from kurbel.commands.options import is_given
from kurbel.errors import ProblemError
from kurbel.page.layouts import layout
from kurbel.reading.given import as_angles
from kurbel.reading.where import MAX

# What makes a crank of its own.
MOTION = ("ratio", "stroke", "rod", "offset", "mechanism", "rocker", "pivot", "beam", "force", "layouts")


class Angle:
    """The crank angle: one in degrees, or where a quantity of the motion is greatest on the outstroke."""

    def __init__(self, degrees: Fraction | None, text: str, half_turns: Callable[[], Any] | None) -> None:
        self.degrees, self.text, self.half_turns = degrees, text, half_turns

    @classmethod
    def read(cls, angle: Any, unknown: str, given: Mapping[str, Any]) -> Angle:
        if angle is None:
            raise ProblemError(
                "--unknown asks for a number with which a condition holds at a crank angle; add that as"
                " --angle 30, or --angle c=max"
            )
        if not isinstance(angle, str) or "=" not in angle:
            angles = as_angles(angle)
            if len(angles) != 1:
                raise ProblemError(f"{len(angles)} crank angles were given; --unknown takes one --angle")
            return cls(angles[0], "", None)
        if unknown == "ratio":
            raise ProblemError(f"--angle {angle} depends on the ratio that is asked for; give it in degrees")
        if any(is_given(given[name]) for name in (*OWN, "cylinder")):
            raise ProblemError(f"--angle {angle} is of the motion alone; under a load give it in degrees")
        return cls._greatest(angle, given)

    @classmethod
    def _greatest(cls, text: str, given: Mapping[str, Any]) -> Angle:
        from kurbel.solve.solve import read_on, solve

        known = {name: value for name, value in given.items() if name in MOTION}
        chosen, said = described({**dict.fromkeys(MOTION), **known, "speed": None, "layout": None})
        ratios = layout(chosen.layout, given["layouts"]).ratios
        drive = chosen.solved(some(chosen.drives(said, ratios)), "exact")[0]
        condition = read_on(drive, text)
        if condition.kind != MAX:
            raise ProblemError(
                f"--angle {text} must be an angle such as 30, or as c=max where one is greatest"
            )
        place = next(root.place for root in solve(drive, condition) if root.stroke == 1)
        return cls(place.degrees, text, place.half_turns)

    def circle(self, kind: Any) -> Any:
        from kurbel.exact.certify import half_turn_circle

        if self.degrees is not None or self.half_turns is None:
            return kind.circle(self.degrees)
        return half_turn_circle(self.half_turns())

    def label(self, lang: str) -> str:
        from kurbel.page.axes import angle_text
        from kurbel.page.quantity import words

        if self.degrees is not None:
            return f"$φ = {angle_text(self.degrees)}$"
        quantity = self.text.partition("=")[0].strip()
        return words(f"dem größten ${quantity}$|the greatest ${quantity}$")[lang]
