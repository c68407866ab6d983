"""A turning-moment diagram that no engine makes: by its torque, its triangles or its areas."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from kurbel.commands.options import Option, file, measure, word
from kurbel.commands.part import Part, flag_of
from kurbel.errors import ProblemError
from kurbel.reading.given import as_crank_angles, as_energy, as_fraction, as_power, as_share, as_speed
from kurbel.reading.notation import about, each_number

if TYPE_CHECKING:
    from kurbel.engine.diagram.excess import ExcessTorque
    from kurbel.engine.diagram.fluctuation import Areas, Fluctuation
    from kurbel.engine.diagram.torque import Torque

MOST_TURNS = 100
DRIVES, LOADS = ("torque", "torque_file", "triangles"), ("load_torque", "load_torque_file")
# The options that describe a diagram, each by itself.
DIAGRAMS = (*DRIVES, *LOADS, "areas")


class Diagram(Part):
    """A turning-moment diagram that no engine makes."""

    topic = "diagram"

    torque = word(
        "Diagram without an engine: torque over the crank angle, as a formula, '5000 + 1500 sin(3φ)', or"
        " points, '0:0; 60:90; 180:0' or 'every 30°: 0; 45; 90', which straight lines join.",
        "T", unit="N m", whole=True,
    )  # fmt: skip
    torque_file = file("The same from a CSV file with the columns angle and torque [N m].")
    triangles: Option[Sequence[str]] = Option(
        "Diagram of triangles alike in width, as of the strokes of a gas engine, by their areas from the"
        " line of no torque: '-350;-1400;+3550;-500', with --turns and --area-scale, or --power and"
        " --speed.",
        "AREAS",
        whole=True,
        read=lambda value, what: _texts(value),
    )
    load_torque = word(
        "Torque of the load, a formula or points; default: the mean of the drive. Alone, the drive has"
        " its mean.",
        "T", unit="N m", whole=True,
    )  # fmt: skip
    load_torque_file = file("The same from a CSV file.")
    turns = measure(
        lambda value, what: _turns(value),
        "Turns after which a diagram comes again: 1, 2, 1/3; default: as its formula, or to its last point.",
        "N",
    )
    areas: Option[Sequence[str]] = Option(
        "Diagram by the areas between it and its mean line, in order, those above positive: '+52;-124;+72'.",
        "AREAS",
        whole=True,
        read=lambda value, what: _texts(value),
    )
    area_scale = word(
        "What a unit of these areas stands for: 52.36J, or the units of torque and angle, '500 N m; 6°'.",
        "SCALE",
        whole=True,
    )

    def is_diagram(self) -> bool:
        """Whether a diagram is described."""
        return self.says(*DIAGRAMS)

    def fluctuation(self) -> Fluctuation:
        """Return how the energy varies by the diagram. Raises KurbelError."""
        return self.whole_areas(self.turns) if self.says("areas") else self.excess()

    def whole_areas(self, turns: Fraction | None = None) -> Areas:
        """Return the areas of a diagram, of a cycle of so many turns where these are known."""
        from kurbel.engine.diagram.fluctuation import given_areas

        if not self.says("areas"):
            raise ProblemError("no areas were given; add --areas '+52;-124;+72' with --area-scale 52.36J")
        return given_areas(self.areas, self.area_scale, turns)

    def excess(self) -> ExcessTorque:
        """Return the excess of the drive's torque over that of the load. Raises KurbelError."""
        from kurbel.engine.diagram.excess import ExcessTorque

        turns = self.turns
        drive, load = self._torque(DRIVES, turns, "torque"), self._torque(LOADS, turns, "torque of the load")
        if cranks := self.crank_angles():
            if drive is None:
                raise ProblemError("--cranks are those of the drive; add its --torque, or leave them out")
            drive = drive.superposed(cranks)
        return ExcessTorque.between(drive, load, self.says("triangles"))

    def crank_angles(self) -> Sequence[Fraction]:
        """Return the angles of the cranks that have the torque, none where these were not given."""
        return as_crank_angles(self.raw("cranks")) if self.says("cranks") else ()

    def constant(self) -> str:
        """Return which torque was not given and is the mean of the other, "load" or "drive"."""
        return ("" if self.says(*LOADS) else "load") if self.says(*DRIVES) else "drive"

    def unread(self, option: Option[object]) -> str:
        name, flag = option.name, flag_of(option.name)
        if name == "area_scale" and not self.says("areas", "triangles"):
            return "--area-scale is for --areas or --triangles; add these, or leave it out"
        if self.says("areas"):
            if name == "turns":
                return "--turns is of a diagram over the crank angle, and --areas have none; leave it out"
            if name in ("angle", "step"):
                return f"{flag} is of crank angles, which areas do not have; leave it out"
            if name in (*DRIVES, *LOADS, "cranks"):
                return f"--areas is a whole diagram, and {flag} says of another one; leave one out"
        if name == "power" and self.says("triangles"):
            return "--power gives the scale of triangles, and these have one; leave it out"
        if name == "turns" and not self.is_diagram():
            return "--turns is for a diagram without an engine; add --torque, or leave it out"
        return ""

    def _torque(self, names: tuple[str, ...], turns: Fraction | None, what: str) -> Torque | None:
        own = [name for name in names if self.says(name)]
        if len(own) > 1:
            raise ProblemError(f"{' and '.join(map(flag_of, own))} give the {what} twice; leave one out")
        if own == ["triangles"]:
            return self._triangles(turns)
        text, file = self.raw(names[0]), self.torque_file if names is DRIVES else self.load_torque_file
        if file is not None:
            from kurbel.engine.diagram.points import read_points, torque_through

            return torque_through(read_points(file), turns, what)
        if text is None:
            return None
        if str(text).lower().endswith(".csv"):
            flag = flag_of(names[0])
            raise ProblemError(f"{flag} {str(text)[:40]} is a file; name it as {flag}-file")
        if ":" in str(text):
            from kurbel.engine.diagram.points import points_of, torque_through

            return torque_through(points_of(str(text), what), turns, what)
        from kurbel.engine.diagram.formula import torque_of
        from kurbel.engine.diagram.torque import Torque, own_cycle

        waves = torque_of(str(text), what)
        return Torque.of(waves, own_cycle(waves, turns, what))

    def _triangles(self, turns: Fraction | None) -> Torque:
        from kurbel.engine.diagram.fluctuation import scaled_areas
        from kurbel.engine.diagram.points import triangles

        if load := next((name for name in LOADS if self.says(name)), ""):
            raise ProblemError(
                f"--triangles are against a constant load, and {flag_of(load)} gives another; leave one out,"
                " or write the triangles as points of --torque"
            )
        if turns is None:
            raise ProblemError("--triangles need the turns of their cycle; add --turns 2 for four strokes")
        texts = self.triangles
        if not self.says("area_scale") and not any(map(str.isalpha, "".join(texts))):
            return triangles([*self._by_work(texts, turns)], turns)
        areas, scale, _ = scaled_areas(texts, self.area_scale, "triangles")
        if scale.of_pi:
            raise ProblemError(
                "--triangles need the energy of a unit of area, --area-scale 3J; a torque and an angle in"
                " degrees would make one with π, write the angle in rad"
            )
        return triangles([area * scale.energy for area in areas], turns)

    def _by_work(self, texts: Sequence[str], turns: Fraction) -> Iterator[Fraction]:
        """Yield the areas of triangles in J, of which all together are the work of the cycle."""
        areas = each_number(texts, "area")
        total, work = sum(areas, Fraction(0)), self._cycle_work(turns)
        if total <= 0:
            raise ProblemError(
                f"the triangles sum to {about(total)}; they are the work of a cycle and must sum to more"
                " than 0"
            )
        cranks = len(self.crank_angles()) or 1
        yield from (area * work / total / cranks for area in areas)

    def _cycle_work(self, turns: Fraction) -> Fraction:
        """Return the work of a cycle in J, given or by power and speed."""
        if (work := self.raw("work")) is not None:
            return as_energy(work, "work of a cycle")
        power, speed, efficiency = map(self.raw, ("power", "speed", "efficiency"))
        if power is None or speed is None:
            raise ProblemError(
                "the triangles have no scale; add the energy of a unit of area, --area-scale 3J, or --power"
                " and --speed, which give the work of the cycle, or write their unit: '-350J;+3550J'"
            )
        if ".." in str(speed):
            raise ProblemError(
                f"the work of a cycle needs the mean speed, and {str(speed)[:40]} is a range; write it as"
                " --speed 300/min with --delta"
            )
        mean = as_speed(speed)
        if not mean.turns:
            raise ProblemError(
                f"the speed {speed} makes a scale of the triangles with π; write it in turns, as 300/min"
            )
        share = 1 if efficiency is None else as_share(efficiency, "efficiency")
        return as_power(power) * share * turns / mean.value


def _turns(given: object) -> Fraction:
    """Return the turns of a cycle. Raises KurbelError."""
    turns = as_fraction(given)
    if not 0 < turns <= MOST_TURNS:
        raise ProblemError(f"a cycle of {turns} turns was given; it must be above 0 and at most {MOST_TURNS}")
    return turns


def _texts(areas: object) -> list[str]:
    if isinstance(areas, str) or not isinstance(areas, Iterable):
        return [str(areas)]
    return [*map(str, areas)]
