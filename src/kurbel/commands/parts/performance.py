"""What an engine does: its flywheel and what it turns against, and how it falls short of its ideal card."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from kurbel.commands.options import Choice, measure, word
from kurbel.commands.part import Part, Rivals
from kurbel.commands.parts.drive import Speed
from kurbel.errors import ProblemError
from kurbel.reading.given import as_inertia, as_number, as_power, as_share, as_specific_volume

if TYPE_CHECKING:
    from kurbel.drive.wheel import Wheel


class Flywheel(Part):
    """A flywheel of an engine, and what it turns against."""

    topic = "wheel"

    title, add = "a flywheel", "--flywheel or --inertia"
    rivals: ClassVar[Rivals] = (("flywheel", "inertia"), ("inertia", "flywheel"))

    flywheel = measure(
        as_number,
        "Flywheel, for the speed over the turn: its number m₁v₁²/(P r), 50.",
        "M",
        machine="flywheel.number",
    )
    inertia = measure(
        as_inertia,
        "The same by its moment of inertia: 1200kgm2. It needs --speed, and --power or the bore and the"
        " pressure.",
        "J", what="moment of inertia",
    )  # fmt: skip
    power = measure(as_power, "Power of the engine, for --inertia: 50kW, 68PS.", "POWER", topic="work")
    resistance = word(
        "Torque that the engine turns against: constant (default), or square of the speed.",
        kind=Choice("resistance", "kurbel.drive.wheel:RESISTANCES"),
        machine="flywheel",
    )

    def has_wheel(self) -> bool:
        return self.says("flywheel", "inertia")

    def wheel(self, heavy: bool) -> Wheel | None:
        """Return the flywheel, None if none is given.

        With masses, where the engine is `heavy`, its power follows from the pressures. Raises KurbelError.
        """
        from kurbel.drive.wheel import CONSTANT, Wheel

        if not self.has_wheel():
            return None
        number, inertia, speed = self.flywheel, self.inertia, self.as_part(Speed).speed
        if number is not None and inertia is not None:
            raise ProblemError("--flywheel and --inertia both describe the flywheel; leave one out")
        if inertia is not None and speed is None:
            raise ProblemError("--inertia needs the mean speed; add --speed, for example --speed 120/min")
        return Wheel(
            number,
            inertia,
            speed,
            None if heavy or inertia is None else self.power,
            self.resistance or CONSTANT,
        )


class Losses(Part):
    """How an engine falls short of its ideal card, at the shaft, and by the steam that it takes."""

    topic = "work"

    diagram_factor = measure(
        as_share,
        "Area of the real card in that of the ideal one: 0.8; default 1, the ideal card. --unknown finds it"
        " from a power.",
        "SHARE",
        machine="steam",
    )
    efficiency = measure(
        as_share, "Mechanical efficiency, for the power at the shaft: 85%.", "SHARE", machine="crank"
    )
    specific_volume = measure(
        as_specific_volume,
        "Of the steam before cut-off, for the steam taken: '0.24 m3/kg'; or its density, '4.16 kg/m3'.",
        "VOLUME",
        machine="steam",
    )  # fmt: skip
