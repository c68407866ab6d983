"""The pressures on the piston of one cylinder, over the stroke or the crank angle."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from kurbel.commands.options import alone, measure
from kurbel.commands.part import CommandOptions
from kurbel.commands.parts.angles import SHARE
from kurbel.commands.parts.engine import Cylinder
from kurbel.commands.parts.sheet import Layouts, Sheet, columns_option, layout_option
from kurbel.commands.subject import function
from kurbel.drive.load import MASSES
from kurbel.errors import ProblemError
from kurbel.motion.mechanism import uncomputed
from kurbel.page.layouts import Layout, layout
from kurbel.page.subject import Question
from kurbel.reading.given import as_angles, as_shares

if TYPE_CHECKING:
    from kurbel.engine.pressures.pressed import Pressed

# The layouts over the stroke and over the crank angle, and what they are about.
PRESSURES, ABOUT = ("pressures", "pressures-turn"), ("pressures", "pressures over the angle")


class PressuresOptions(Cylinder, Layouts, Sheet, CommandOptions):
    """Print the acceleration pressure over the stroke, beside the pressure on the piston.

    The masses that go to and fro take it from steam or gas, per piston area, and give it back; without
    --eps or --card it stands alone.

    \b
    kurbel pressures --machine engine.toml
    kurbel pressures --reciprocating 300kg --stroke 600mm --bore 300mm --speed 120/min
    kurbel pressures --machine engine.toml --angle 0..360:15
    \f
    >>> import kurbel
    >>> masses = {"reciprocating": 300, "stroke": 0.6, "bore": 0.3, "speed": 2}
    >>> page = kurbel.pressures("1:5", shares="0;0.5;1", columns="share,inertia_pressure", **masses)
    >>> print(kurbel.typeset(page, "csv"), end="")
    stroke,share,inertia_pressure
    1,0.0,2.413
    1,0.5,-0.201
    1,1.0,-1.608
    2,0.0,1.608
    2,0.5,0.201
    2,1.0,-2.413
    """

    # What the acceleration pressure has nothing of.
    without = (
        *("friction", "piston_rod", "tail_rod", "rotating", "rocker_inertia"),
        *("vertical", "slope", "gravity"),
    )
    unnamed = "ratio"
    sequence = (
        "eps back exponent clearance card other_side single_acting bore pressure ratio mechanism offset"
        " rocker pivot circuit beam stroke crank true_stroke time_ratio rod speed reciprocating rod_mass"
        " centre gyration rod_file shares angle columns"
    )

    columns = columns_option("pressures", "share,gas_pressure,inertia_pressure")
    speed = Cylinder.speed.but(help="Speed, for the masses: 120/min, 12.5rad/s.")
    shares = measure(
        as_shares,
        "Shares of the stroke: 0.25, lists '0;0.5;1', ranges; default 0..1:0.1.", "SHARES", many=True,
        what=SHARE,
    )  # fmt: skip
    angle = measure(
        alone(as_angles),
        "Crank angles in place of these, with layout pressures-turn: 0..360:10.", "ANGLES", unit="degrees",
        many=True,
    )  # fmt: skip
    layout = layout_option(*ABOUT)

    def question(self) -> Question:
        from kurbel.engine.pressures.page import PressuresRequest

        if self.says("shares") and self.says("angle"):
            raise ProblemError(
                "--shares and --angle are two pages, over the stroke or the angle; leave one out"
            )
        page = self.page(PRESSURES[self.says("angle")], *ABOUT)
        over_angle = page.subject == ABOUT[1]
        other, axis = ("shares", "crank angle") if over_angle else ("angle", "stroke")
        if self.says(other):
            raise ProblemError(
                f"layout {page.key} is over the {axis}; leave --{other} out, or use --layout"
                f" {PRESSURES[not over_angle]}"
            )
        shares, angles = self.shares, self.angle
        return PressuresRequest(
            layout=page,
            pressed=self._pressed(page),
            shares=as_shares("0..1:0.1", SHARE) if shares is None else shares,
            angles=as_angles(page.angles or "0") if angles is None else angles,
            columns=self.names("share,inertia_pressure"),
            **self.printed(),
        )

    def _pressed(self, page: Layout) -> Pressed:
        """Return the one cylinder that is described, with its masses, its load or both."""
        from kurbel.engine.pressures.pressed import Pressed
        from kurbel.engine.request import EngineRequest

        if self.load_names():
            engines = self.engines(layout("engine-forces"))
            about = EngineRequest(layout=layout("engine-forces"), **engines)
            _check_one(about.steams, "loads")
            _check_one(about.drives, "crank ratios")
            return Pressed(about.drives[0], self.bore, about.first.parts[0])
        chosen, described = self.described(
            beside=("stroke",), leaving=("speed", "method", *self.lone_lengths())
        )
        if sentence := uncomputed(chosen, MASSES):
            raise ProblemError(sentence)
        drives = self.weighed(chosen, chosen.drives(described, page.ratios), "bore", even=True)
        _check_one(drives, "crank ratios")
        return Pressed(drives[0], self.bore)

    def is_sized(self) -> bool:
        return self.compares_lengths() or self.is_heavy()

    def has_speed(self) -> bool:
        return False


def _check_one(found: Sequence[Any], what: str) -> None:
    if len(found) != 1:
        raise ProblemError(
            f"pressures are those of one cylinder, and {len(found)} {what} were given; give one"
        )


pressures = function(PressuresOptions, "pressures")
