"""An engine: its crank drive, its load, its masses, and its cranks or unlike cylinders."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from copy import copy
from dataclasses import replace
from fractions import Fraction
from os import PathLike
from typing import TYPE_CHECKING, TypedDict

from kurbel.commands.options import FILE, FLAG, Choice, Kind, Option, alone, measure
from kurbel.commands.part import Part, flag_of
from kurbel.commands.parts.drive import LENGTHS, AnyDrive, Speed, settle_sizes
from kurbel.commands.parts.effort import RODS, Friction, with_effort
from kurbel.commands.parts.loads import KINDS, Loads, on_page
from kurbel.commands.parts.masses import OF_ROD, Masses, Rotating, Weight
from kurbel.drive.moved import Drive
from kurbel.errors import KurbelError, NotationError, ProblemError
from kurbel.motion.mechanism import Mechanism, of_other_mechanisms, uncomputed
from kurbel.page.layouts import Layout
from kurbel.reading.given import as_angle, as_crank_angles, as_number, choose
from kurbel.reading.notation import about

if TYPE_CHECKING:
    from kurbel.drive.load import Load as Acting
    from kurbel.engine.engine import Assembly, Load
    from kurbel.engine.engine import Engine as Part_

EXAMPLE = "angle=90 bore=500mm pressure=3bar eps=2"
# How what is said or not is written in a text.
TRUTH: Mapping[object, bool] = {"true": True, "false": False, True: True, False: False}
# What sets the place of a cylinder.
PLACE: Mapping[str, str] = {
    "angle": "angle in degrees by which its crank follows the first",
    "bank": "angle by which its axis leans, in the sense of rotation",
    "fires": "its place in the firing order, 1 for the first",
}


class Engines(TypedDict, total=False):
    """Engines that are asked for, by the fields of `kurbel.engine.request:EngineRequest`."""

    steams: Sequence[Acting]
    drives: Sequence[Drive]
    mechanism: Mechanism
    double: bool
    load: Load | None


class EnginesOfPage(Engines, total=False):
    """The same with all that a page about them is of."""

    layout: Layout
    cranks: Sequence[Fraction]
    methods: tuple[str, ...]
    assembly: Assembly | None
    numbers: tuple[int, ...]


class OneCylinder(Kind):
    """The entries of a cylinder, each as the option of its name is written: angle=90 bore=500mm eps=2."""

    name = "cylinder"
    python = "str | dict"

    def read(self, text: object, typed: Mapping[str, object]) -> Mapping[str, object]:
        if isinstance(text, Mapping):
            return text
        entries: dict[str, object] = {}
        for part in str(text).split():
            key, equals, value = part.partition("=")
            key = key.replace("-", "_")
            if key in entries:
                raise NotationError(f"{key} of a cylinder is given twice; leave one out")
            entries[key] = value if equals else True
        if not entries:
            raise NotationError(
                f"a cylinder has no entries; write it as '{EXAMPLE}', or leave --cylinder out"
            )
        return _checked(entries)

    def taken(self, value: object, name: str) -> Mapping[str, object]:
        if isinstance(value, str):
            return self.read(value, {})
        if not isinstance(value, Mapping):
            raise NotationError(f"{name} is {str(value)[:40]}; give each as a mapping, or as {EXAMPLE}")
        return _checked(dict(value))

    def with_files(self, value: object, file: Callable[[object], object]) -> object:
        # A cylinder of a machine's file knows where it stands there.
        found = copy(value)
        assert isinstance(found, dict)
        for name, one in Cylinder.entries().items():
            if one.kind is FILE and (named := found.get(name)) is not None:
                found[name] = file(named) if isinstance(named, str | PathLike) else [*map(file, named)]
        return found


def _checked(entries: dict[str, object]) -> Mapping[str, object]:
    """Return the entries if a cylinder has such ones."""
    from kurbel.reading.foreign import ours

    own = Cylinder.entries()
    flags = [name for name, one in own.items() if one.kind is FLAG]
    for key, value in entries.items():
        meaning, written = ours(key, str(value), own) if key not in own else ("", "")
        if meaning:
            raise NotationError(f'there is no entry of a cylinder, "{key}"; write {meaning}={written}')
        choose(key, (*PLACE, *own), "entry of a cylinder,")
        if value is True and key not in flags:
            raise NotationError(f"{key} of a cylinder has no value; write it as {EXAMPLE}")
        if key in flags and value not in TRUTH:
            raise NotationError(f"{key} of a cylinder is {str(value)[:40]}; it must be true or false")
    return {key: TRUTH[value] if key in flags else value for key, value in entries.items()}


class Cylinder(Loads, Friction, Masses, AnyDrive, Speed):
    """One cylinder: its drive, its load, its masses."""

    @classmethod
    def entries(cls) -> Mapping[str, Option[object]]:
        """Return the options that may be a cylinder's own, and not of the shaft or of the whole engine."""
        shared = Speed.options() | Weight.options()
        options = cls.options() | Rotating.options()
        return {name: one for name, one in options.items() if one.machine and name not in shared}

    def shared(self) -> Collection[str]:
        return ("stroke", "speed", "method", "acceleration")

    def is_sized(self) -> bool:
        """Whether lengths count: for newton metres, for masses, or to compare another length with."""
        return self.compares_lengths() or self.is_heavy() or self.says("cylinder", "bore")

    def engines(self, page: Layout) -> Engines:
        """Return the loads, drives and sizes of the engines that are described."""
        apart = ("speed", "method", "acceleration", *self.lone_lengths())
        chosen, described = self.described(beside=("stroke",), leaving=apart)
        loads = self.loads(page)
        if sentence := uncomputed(chosen, loads[0].name) if loads else "":
            raise ProblemError(sentence)
        drives = self.weighed(chosen, chosen.drives(described, page.ratios), *self.weighing(), even=True)
        drives = self.with_friction(chosen, drives)
        sized = bool(drives) and chosen.crank(drives[0]).radius is not None
        if sized and not self.is_heavy() and self.has_speed():
            speed = self.speed
            drives = [drive.of(replace(chosen.crank(drive), speed=speed)) for drive in drives]
        double = getattr(loads[0], "double", None) if loads else True
        return {
            "steams": loads, "drives": drives, "mechanism": chosen, "load": self.newtons(),
            "double": not self.single_acting if double is None else double,
        }  # fmt: skip

    def lone_lengths(self) -> Collection[str]:
        """Return the lengths that alone say nothing: both together give a ratio."""
        together = self.says("stroke") == self.says("rod")
        return () if together or self.is_sized() else ("stroke", "rod")

    def has_speed(self) -> bool:
        """Whether the speed says something without masses."""
        return self.says("speed")

    def with_friction(self, chosen: Mechanism, drives: Sequence[Drive]) -> list[Drive]:
        """Return the drives of an engine with the rods of its piston and its friction."""
        rods = [name for name in RODS if self.says(name)]
        if not (rods or self.says("friction")):
            return list(drives)
        if not self.says("bore"):
            name = "friction" if self.says("friction") else rods[0]
            raise ProblemError(f"{flag_of(name)} is weighed against the load by the bore; add --bore")
        from kurbel.drive.effort import Effort

        friction = self.friction or Fraction(0)
        return with_effort(chosen, drives, Effort(None, friction, self.piston_areas() if rods else None))

    def unread(self, option: Option[object]) -> str:
        name = option.name
        if name in ("stroke", "rod") and self.lone_lengths():
            other = "rod" if name == "stroke" else "stroke"
            if name == "stroke" and self.load_names() and not self.says("bore"):
                return "--stroke makes newton metres of the load only with --bore; add that"
            return f"--{name} gives the ratio with --{other}; add that, or leave --{name} out"
        if name == "speed" and not self.is_heavy():
            return f"--speed is for {Masses.title}; add {Masses.add}"
        return ""


class Engine(Cylinder):
    """An engine of so many cylinders alike, or of unlike ones."""

    topic = "cylinders"

    cranks = measure(
        alone(as_crank_angles),
        "Angles by which the cranks follow the first, with cylinders alike: '0;90' or '0;120;240'.", "ANGLES",
        unit="degrees", whole=True, machine="crank.angles",
    )  # fmt: skip
    cylinder: Option[Sequence[Mapping[str, object]]] = Option(
        f"A cylinder of an engine of unlike ones, in the words of the options: '{EXAMPLE}'; beside it all"
        " options say what the cylinders have in common. Machines have them as [[cylinder]].",
        "ENTRIES", OneCylinder(), many=True, whole=True,
    )  # fmt: skip
    method: Option[Sequence[str] | str | None] = Option(
        "exact (default), series (first order) or weisbach (his equations of § 150).",
        kind=Choice("method", "kurbel.engine.engine_quantities:ENGINE_METHODS"), many=True, default=(),
        topic="crank",
    )  # fmt: skip

    def is_several(self) -> bool:
        """Whether the cylinders are given one by one."""
        return self.says("cylinder")

    def is_engine(self) -> bool:
        """Whether any load is named, by an option or by a cylinder."""
        return bool(self.load_names()) or self.is_several()

    def turn(self) -> Fraction:
        """Return the degrees after which everything comes again: of any four-stroke cylinder two turns."""
        if not self.is_several():
            return self.whole_cycle()
        return max((self._merged(own).whole_cycle() for own in self.cylinder), default=Fraction(360))

    def of_page(self, page: Layout) -> EnginesOfPage:
        """Return the engines of a page, with their masses, under their loads. Raises KurbelError."""
        methods = self.method or ()
        found: EnginesOfPage = {
            "layout": on_page(page) if self.is_several() or self.usual_layout() else page,
            "methods": tuple(dict.fromkeys((methods,) if isinstance(methods, str) else methods)),
        }
        if not self.is_several():
            cranks = (Fraction(0),) if self.cranks is None else self.cranks
            return {**found, **self.engines(page), "cranks": cranks}
        assembly, numbers = self._seen(self.assembly(page))
        first, own = assembly.parts[0], self.cylinder[numbers[0] - 1 if numbers else 0]
        return {
            **found, "mechanism": self._merged(own).drive(), "steams": [first.steam], "drives": [first.drive],
            "double": first.double, "load": first.load, "assembly": assembly, "cranks": assembly.cranks,
            "numbers": numbers,
        }  # fmt: skip

    def assembly(self, page: Layout) -> Assembly:
        """Return the engine of the cylinders that are described. Raises ProblemError with their number."""
        from kurbel.engine.engine import Assembly

        if self.says("cranks"):
            raise ProblemError(
                "--cranks are those of cylinders alike, and each --cylinder has its angle; leave one out"
            )
        described = self.cylinder
        parts = [
            self._merged(own).made(_title(number, own), page, own) for number, own in enumerate(described, 1)
        ]
        lags = lags_of(described, [part.steam for part in parts])
        return Assembly(tuple(replace(part, lag=lag) for part, lag in zip(parts, lags, strict=True)))

    def _seen(self, assembly: Assembly) -> tuple[Assembly, tuple[int, ...]]:
        """Return the engine with a cylinder, by its number, in the first place, and the numbers of all."""
        from kurbel.engine.engine import Assembly

        if not self.says("of"):
            return assembly, ()
        parts, number = assembly.parts, self.as_part(ReferenceCylinder).of or Fraction(0)
        if number not in range(1, len(parts) + 1):
            raise ProblemError(f"cylinder {about(number)} was asked for, and the engine has {len(parts)}")
        index = int(number) - 1
        cycle = 180 * max(getattr(part.steam, "strokes_of_cycle", 2) for part in parts)
        order = [index, *(one for one in range(len(parts)) if one != index)]
        turned = (replace(parts[one], lag=(parts[one].lag - parts[index].lag) % cycle) for one in order)
        return Assembly(tuple(turned)), tuple(one + 1 for one in order)

    def _merged(self, own: Mapping[str, object]) -> UnlikeCylinder:
        """Return a cylinder: what all have in common, without what its own entries outdo, and these."""
        dropped = [*self._other_loads(own), *self._other_lengths(own)]
        if "rod_file" in own:
            dropped += [name for name in OF_ROD if name != "rod_file"]
        elif any(name in own for name in OF_ROD):
            dropped.append("rod_file")
        left = dict.fromkeys((*dropped, "cylinder", "cranks"))
        kept = {name: value for name, value in own.items() if name not in PLACE}
        # By its bank the weight of a cylinder has another direction.
        return UnlikeCylinder(self.values.instead({**left, **kept, "bank": own.get("bank")}, own=True))

    def _other_loads(self, own: Mapping[str, object]) -> list[str]:
        """Return the options of loads that are not the cylinder's."""
        keys = [key for key in KINDS if own.get(key) not in (None, False, ())]
        if not keys:
            return []
        kept = {name for key in keys for name in (key, *KINDS[key].options)}
        return [name for key, kind in KINDS.items() for name in (key, *kind.options) if name not in kept]

    def _other_lengths(self, own: Mapping[str, object]) -> list[str]:
        """Return those of ratio, stroke and rod that two others of the cylinder's outdo."""
        if not all(name in own or self.says(name) for name in LENGTHS):
            return []
        return [name for name in ("ratio", "rod", "stroke") if name not in own][:1]

    def unread(self, option: Option[object]) -> str:
        if not self.is_several():
            return ""
        why = f"{flag_of(option.name)} says nothing about the cylinders"
        if all(option.name in one for one in self.cylinder):
            return f"{why}, each of which has its own; leave it out"
        if any(option.name in (key, *kind.options) for key, kind in KINDS.items()):
            return f"{why}, which have other loads; leave it out"
        return ""


class UnlikeCylinder(Cylinder):
    """A cylinder of an engine of unlike ones."""

    def made(self, title: str, page: Layout, own: Mapping[str, object]) -> Part_:
        """Return the cylinder with its load. Raises KurbelError with its title."""
        from kurbel.engine.engine import Engine

        if not self.load_names():
            raise ProblemError(f"{title} has no load; give it eps, card, pressure_ratio, pump or compression")
        try:
            settle_sizes(self.values)
            # What all cylinders have in common may be of the drives of others.
            foreign = of_other_mechanisms(self.drive(), list(own), ("stroke", "speed", "method"))
            for sentence in foreign.values():
                raise ProblemError(sentence)
            found = self.engines(page)
            for several, what in ((found["steams"], "load"), (found["drives"], "crank ratio")):
                if len(several) != 1:
                    raise ProblemError(f"it has {len(several)} {what}s; a cylinder has one")
            return Engine(found["drives"][0], found["steams"][0], found["double"], load=found["load"])
        except KurbelError as error:
            raise type(error)(f"{title}: {error}") from None


class ReferenceCylinder(Part):
    """From which of several cylinders an engine is seen."""

    topic = "cylinders"

    title, add = "one of several cylinders", "each as --cylinder"

    of: Option[Fraction | None] = measure(
        as_number,
        "Of several cylinders unlike: the one whose forces these are; default 1, the first.", "NUMBER",
        what="cylinder", topic="question",
    )  # fmt: skip


def _title(number: int, own: Mapping[str, object]) -> str:
    """Return what a cylinder is called in sentences, with the line of its file."""
    where = getattr(own, "where", "")
    return f"{where}: cylinder {number}" if where else f"cylinder {number}"


def lags_of(cylinders: Sequence[Mapping[str, object]], loads: Sequence[object]) -> list[Fraction]:
    """Return the angles by which cylinders follow the first, from dead centre to dead centre.

    That of a crank and that by which its cylinder's axis leans add up; where all have a place in the firing
    order, those of four strokes fire in the turn that it says.
    """
    places = [
        (_angle(one, "angle", _title(number, one)), _angle(one, "bank", _title(number, one)))
        for number, one in enumerate(cylinders, 1)
    ]
    ordered = [one.get("fires") for one in cylinders]
    if any(place is not None for place in ordered):
        titles = [_title(number, one) for number, one in enumerate(cylinders, 1)]
        return _fired(places, ordered, loads, titles)
    first = sum(places[0])
    return [angle + bank - first for angle, bank in places]


def _fired(
    places: Sequence[tuple[Fraction, Fraction]],
    ordered: Sequence[object],
    loads: Sequence[object],
    titles: Sequence[str],
) -> list[Fraction]:
    from kurbel.balancing.arrangement import Cylinder
    from kurbel.balancing.firing import PERIODS, fitting

    if None in ordered:
        raise ProblemError(f"cylinder {ordered.index(None) + 1} has no fires; give all their places, or none")
    turns = [
        as_number(place, f"{title}: place in the firing order")
        for place, title in zip(ordered, titles, strict=True)
    ]
    strokes = {getattr(load, "strokes_of_cycle", 2) for load in loads}
    if len(strokes) > 1:
        raise ProblemError("fires is the order of cylinders whose cycles have as many strokes; leave it out")
    if sorted(turns) != [*range(1, len(turns) + 1)]:
        raise ProblemError(
            f"fires has the places {', '.join(map(str, ordered))}; each of 1 to {len(turns)} must be there"
        )
    order = tuple((1 + turns.index(Fraction(place)),) for place in range(1, len(turns) + 1))
    # A crank that follows the first by an angle lies so far behind it.
    shaft = [Cylinder(-angle, Fraction(0), bank) for angle, bank in places]
    firing = fitting(shaft, strokes.pop(), order)
    assert firing.period in PERIODS.values()
    angles = {number: at for group, at in zip(firing.order, firing.angles, strict=True) for number in group}
    return [angles[number] for number in range(1, len(turns) + 1)]


def _angle(cylinder: Mapping[str, object], name: str, title: str) -> Fraction:
    return as_angle(cylinder.get(name, 0), f"{title}: {name}")
