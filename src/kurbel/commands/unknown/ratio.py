"""The crank ratio for which a condition on the motion holds at an angle."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

from kurbel.commands.cylinder.effort import PRESSING, RODS, RUBBING
from kurbel.commands.cylinder.slope import LYING
from kurbel.commands.loads import OWN
from kurbel.commands.machines import MASSES as ALL_MASSES
from kurbel.commands.machines import STEAM
from kurbel.commands.old_motion import described, method_of
from kurbel.commands.options import is_given
from kurbel.commands.unknown.place import MOTION, Angle
from kurbel.errors import ProblemError
from kurbel.reading.where import MAX, VALUE

GREATEST_RATIO = Fraction(999, 1000)
MASSES = ("reciprocating", "rod_mass", "rotating", "rod_file")
# Of conditions on the motion: x = 200 mm.
_WITH_UNIT = re.compile(r"=\s*[-+−]?[\d.,/]+\s*[a-z]")
OF_FORCES = (*STEAM, "bore", "pressure", "cranks", "of", *ALL_MASSES, *LYING, *PRESSING, *RODS, *RUBBING)


def needless_of_ratio(values: Mapping[str, Any], texts: Sequence[Any]) -> Mapping[str, str]:
    """Return the sentences that refuse what says nothing of a ratio that is asked for."""
    why = "is of forces, and --unknown ratio is of the motion of the piston; leave it out"
    own = (*OWN, "cylinder", *MASSES)
    refused = {name: f"--{name.replace('_', '-')} {why}" for name in OF_FORCES if name not in own}
    if not (any(_WITH_UNIT.search(str(text)) for text in texts) or is_given(values["offset"])):
        why = "gives lengths in mm, and the condition has none; leave it out, or write one as 'x = 200 mm'"
        refused["stroke"] = f"--stroke {why}"
    return refused


def needless_of_motion() -> Mapping[str, str]:
    """Return the sentences that refuse what says nothing of a condition on the motion."""
    why = "is of forces, and the condition is on the motion of the piston; leave it out"
    return {name: f"--{name.replace('_', '-')} {why}" for name in ("force", *OF_FORCES)}


class OfRatio:
    """The crank ratio of the straight or offset crank, its crosshead's motion known by formulas."""

    def __init__(self, unknown: str, angle: Any, text: str, given: Mapping[str, Any]) -> None:
        from kurbel.motion.evaluation import NEEDS
        from kurbel.solve.solve import MEASURES, read_on

        self.asked, self.place = (unknown, angle, text, given), Angle.read(angle, unknown, given)
        if any(is_given(given.get(name)) for name in (*OWN, "cylinder", "force", "rod", *MASSES)):
            raise ProblemError(
                "--unknown ratio is of the motion of the piston, without rod length, forces and masses; leave"
                " these out"
            )
        known = {name: value for name, value in given.items() if name in (*MOTION, "speed", "method")}
        chosen, said = described({**known, "ratio": "1:4", "layout": None})
        if not chosen.crosshead:
            raise ProblemError("--unknown ratio is of the straight and the offset crank")
        if said.method == "infinite":
            raise ProblemError("--method infinite is of a rod without a ratio; leave it out")
        self.drive = chosen.solved(chosen.drives(said, ()), method_of(given))[0]
        self.condition = read_on(self.drive, text)
        if (
            self.condition.unit
            and (column := MEASURES[self.condition.quantity].column) not in self.drive.columns
        ):
            needs = " and ".join(NEEDS[self.drive.entries[column].needs])
            raise ProblemError(f'condition "{self.condition}" is in {self.condition.unit} and needs {needs}')
        if self.condition.kind not in (VALUE, MAX) or (
            self.condition.kind == MAX and self.condition.quantity != "c"
        ):
            raise ProblemError("--unknown ratio takes a value, such as x=1.1 or psi=15, or c=max")

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), self.asked

    @property
    def greatest(self) -> Fraction:
        return GREATEST_RATIO / (1 + abs(self.drive.crank.offset))

    @cached_property
    def found(self) -> list[Any]:
        from dataclasses import replace

        from kurbel.exact.course import Target
        from kurbel.exact.kind import balls
        from kurbel.motion.evaluation import At, kernel_of
        from kurbel.solve.solve import target_of
        from kurbel.solve.unknown import of_ratio

        drive, condition = self.drive, self.condition
        if condition.kind == MAX:
            # The acceleration is zero once on the outstroke, where the velocity is greatest.
            if drive.crank.offset:
                raise ProblemError("c=max with --unknown ratio is of the straight crank; leave --offset out")
            if not 0 < (self.place.degrees or 0) < 180:
                raise ProblemError("the velocity is greatest within the outstroke; give an angle in 0..180")
            condition, target = replace(condition, quantity="p"), Target.rational(Fraction(0))
        else:
            target = target_of(drive, condition, 1)
        kernel = kernel_of(drive.asked(condition.quantity, 1), drive.method, drive.crank)
        scale = drive.asked(condition.quantity, 1).scale

        def formula(ratio: Any) -> Any:
            kind = balls()
            offset = kind.of(drive.crank.offset) if drive.crank.offset else None
            found = kernel(At(self.place.circle(kind), ratio, offset, drive.crank, kind))
            return found * scale(drive.crank, kind) if scale else found

        return of_ratio(formula, target.ball, self.greatest)

    def label(self, lang: str) -> str:
        from kurbel.solve.captions import condition_label

        return condition_label(self.condition, self.drive, lang)

    def lines(self, lang: str) -> list[str]:
        from kurbel.drive.load import figure
        from kurbel.solve.unknown_page import WORDS

        return [WORDS["ratio"][lang].format(greatest=f"${figure(self.greatest)}$")]
