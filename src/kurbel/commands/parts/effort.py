"""What acts on piston and crosshead beside the load of an engine: a force, pressures, friction; the pins."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

from kurbel.commands.options import Option, amount, measure
from kurbel.commands.part import Part, flag_of
from kurbel.commands.parts.masses import Masses, Rotating
from kurbel.drive import load
from kurbel.errors import ProblemError
from kurbel.reading.given import as_force, as_inertia, as_length, as_power, as_pressure, as_share

if TYPE_CHECKING:
    from kurbel.drive.effort import Areas, Pins, Pressures, Shaft
    from kurbel.drive.effort import Effort as Efforts
    from kurbel.drive.moved import Drive
    from kurbel.motion.mechanism import Mechanism

RODS = ("piston_rod", "tail_rod")
PRESSING = ("head_pressure", "crank_pressure", "pressure_difference")
PINS = ("crosshead_pin", "crank_pin", "shaft")
PINNED = ("pin_friction", *PINS)


class Piston(Part):
    """The piston on which a pressure acts, and its rods, which lessen its areas."""

    title, add = "a piston on which a pressure acts", "--head-pressure or --crank-pressure"
    topic = "piston"

    bore = measure(as_length, "Bore of the cylinder: 300mm.", "LENGTH", machine="steam compressor pump gas")
    piston_rod = measure(
        as_length,
        "Diameter of the piston rod, which lessens the area on the side of the crank: 50mm.", "LENGTH",
        machine="steam",
    )  # fmt: skip
    tail_rod = measure(
        as_length,
        "Diameter of a rod through the cover, on the other side: 40mm.",
        "LENGTH",
        machine="steam",
    )

    def piston_areas(self) -> Areas:
        """Return the areas of the piston, whose bore is known."""
        from kurbel.drive.effort import Areas

        bore = self.bore
        assert bore is not None
        return Areas(bore, self.piston_rod or Fraction(0), self.tail_rod or Fraction(0))


class Friction(Part):
    """What acts against the motion of piston and crosshead."""

    title, add = "a piston that a force acts on", "--force, --head-pressure or masses"
    topic = "friction"

    friction = measure(
        as_force,
        "Friction of piston and crosshead, against their motion: 500N.",
        "FORCE",
        machine="masses",
    )


class PistonPressures(Part):
    """The pressures on both sides of the piston."""

    title, add = "pressures on both sides of the piston", "--head-pressure 0.3bar"
    topic = "piston"

    head_pressure = measure(
        as_pressure,
        "With --bore: pressure on the piston's side of the cover, above the surroundings: 0.3bar. It acts as"
        " long as the crank turns; without --crank-pressure none is on the other side.",
        "PRESSURE",
    )  # fmt: skip
    crank_pressure = measure(
        as_pressure,
        "The same on the side of the crank, on the area less that of the --piston-rod: 1.5kPa.", "PRESSURE",
    )  # fmt: skip
    pressure_difference = measure(
        as_pressure,
        "In place of both: by how much the pressure of the cover's side is higher, on the full area: 2.5bar;"
        " -2.5bar where it is lower.",
        "PRESSURE",
    )  # fmt: skip


class PinFriction(Part):
    """The friction of the pins, by their circles of friction."""

    title, add = "the friction of the pins", "--pin-friction, for example --pin-friction 0.06"
    topic = "friction"

    pin_friction = measure(
        as_share,
        "Coefficient of friction of the pins, for the torque less their friction: 0.06. A pin without a"
        " diameter has none.",
        "μ",
    )  # fmt: skip
    crosshead_pin = measure(as_length, "With --pin-friction: diameter of the crosshead pin: 80mm.", "LENGTH")
    crank_pin = measure(as_length, "The same of the crank pin: 120mm.", "LENGTH")
    shaft = measure(as_length, "The same of the shaft: 140mm.", "LENGTH")

    def pins(self) -> Pins | None:
        """Return the pins with their friction, None without any."""
        if not self.says("pin_friction"):
            return None
        if not self.says(*PINS):
            names = ", ".join(map(flag_of, PINS))
            raise ProblemError(f"--pin-friction needs the diameter of a pin; add one of {names}")
        from kurbel.drive.effort import Pins

        friction = self.pin_friction
        assert friction is not None
        return Pins(
            friction, *(one or Fraction(0) for one in (self.crosshead_pin, self.crank_pin, self.shaft))
        )


class TurningShaft(Part):
    """What turns with the shaft, and what is taken off it."""

    title, add = "the acceleration of the shaft by a force's torque", "--force, --head-pressure or masses"
    topic = "wheel"

    inertia = measure(
        as_inertia,
        "Moment of inertia of flywheel and shaft, for the angular acceleration of the shaft: '21.6 kg m²'.",
        "J", what="moment of inertia",
    )  # fmt: skip
    power = measure(as_power, "With --inertia: power that is taken off the shaft at --speed: 20kW.", "POWER")

    def accelerates(self) -> bool:
        """Whether the shaft is accelerated; of the flywheel of a machine that is said by its column."""
        columns = str(self.values.values.get("columns") or "")
        return self.says("inertia") and (self.values.typed("inertia") or "angular_acceleration" in columns)

    def turned(self) -> Shaft | None:
        """Return what the torque accelerates, None without --inertia."""
        inertia = self.inertia if self.accelerates() else None
        if inertia is None:
            return None
        if self.says("power") and not self.says("speed"):
            raise ProblemError("--power becomes a torque by the speed; add --speed, for example 120/min")
        from kurbel.drive.effort import Shaft

        return Shaft(inertia, self.power or Fraction(0))


class Effort(Piston, Friction, PistonPressures, Masses, Rotating):
    """All that acts on piston and crosshead where no engine does: a force, pressures, friction, masses."""

    force = amount(
        f"Piston force, for columns in N and N m: {load.examples()}; -5kN is against the stroke.",
        "FORCE", unit="N",
    )  # fmt: skip

    def is_pushed(self) -> bool:
        """Whether a force acts on the piston, that of moving masses among them."""
        return self.says("force", *PRESSING) or self.is_heavy()

    def has_parts(self) -> bool:
        """Whether more than a force and masses makes the effort on the piston."""
        turning = self.as_part(TurningShaft).accelerates()
        beside = (turning or self.says(*PRESSING, "friction", *PINNED)) and self.is_pushed()
        return beside or (self.is_heavy() and self.stands())

    def check_pins(self) -> None:
        """Raise ProblemError for a rod with a mass beside the friction of pins."""
        for name in ("rod_mass", "rod_file", "rotating"):
            if self.says("pin_friction") and self.says(name):
                raise ProblemError(
                    f"{flag_of(name)} does not go with --pin-friction, whose line of thrust is that of a rod"
                    " without mass; leave one out"
                )

    def pushed(self, chosen: Mechanism, drives: Sequence[Drive]) -> list[Drive]:
        """Return drives with what acts on piston and crosshead beside a given force."""
        # What lessens a force is not read where there is none.
        effort = self.effort() if self.is_pushed() else None
        if effort is None:
            return list(drives)
        if effort.pins is not None:
            for drive in drives:
                crank = chosen.crank(drive)
                if crank.radius is None:
                    raise ProblemError("--pin-friction needs the size of the crank; add --stroke")
                effort.pins.check(crank.radius, crank.ratio)
        if effort.shaft is not None and any(chosen.crank(drive).radius is None for drive in drives):
            raise ProblemError("--inertia needs the size of the crank, by which forces turn it; add --stroke")
        return with_effort(chosen, drives, effort)

    def effort(self) -> Efforts | None:
        """Return the pressures, the friction and the pins that are given, None without any."""
        pressures, pins, friction = self.pressures(), self.as_part(PinFriction).pins(), self.friction
        shaft = self.as_part(TurningShaft).turned()
        if pressures is None and pins is None and friction is None and shaft is None:
            return None
        from kurbel.drive.effort import Effort as Efforts

        return Efforts(pressures, friction or Fraction(0), pins=pins, shaft=shaft)

    def pressures(self) -> Pressures | None:
        """Return the pressures on both sides. Raises ProblemError without the area on which they act."""
        first = next((name for name in PRESSING if self.says(name)), "")
        if not first:
            return None
        if self.says("force"):
            raise ProblemError(f"--force and {flag_of(first)} are two forces on one piston; leave one out")
        if not self.says("bore"):
            raise ProblemError(
                f"{flag_of(first)} needs the area on which it acts; add --bore, for example --bore 300mm"
            )
        from kurbel.drive.effort import Areas, Pressures

        if (difference := self.pressure_difference) is None:
            return Pressures(
                self.piston_areas(), self.head_pressure or Fraction(0), self.crank_pressure or Fraction(0)
            )
        bore = self.bore
        assert bore is not None
        # It acts on the full area, which no rod lessens.
        return Pressures(Areas(bore), difference, Fraction(0), difference=True)

    def unread(self, option: Option[object]) -> str:
        name = option.name
        if not self.says("pressure_difference") or name == "pressure_difference":
            return ""
        if name in ("head_pressure", "crank_pressure"):
            return (
                f"{flag_of(name)} and --pressure-difference are given for the same pressures; leave one out"
            )
        if name in RODS:
            return (
                f"{flag_of(name)} does not lessen the full area on which --pressure-difference acts; give"
                " --head-pressure and --crank-pressure in its place"
            )
        return ""


def with_effort(chosen: Mechanism, drives: Sequence[Drive], effort: Efforts) -> list[Drive]:
    """Return the drives with an effort. Raises ProblemError for drives of which it is not computed."""
    if not chosen.crosshead:
        beside = "--inertia on its shaft" if effort.shaft else "friction or pressures on its piston"
        raise ProblemError(
            f"{chosen.title} with {beside} is not computed; leave out what gives these, or add --mechanism"
            " straight"
        )
    return [drive.of(replace(chosen.crank(drive), effort=effort)) for drive in drives]
