"""The flywheel that keeps an engine even, and that of a problem without an engine."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from kurbel.commands.engine import ENGINE_ORDER, EXAMPLE, LOAD_ORDER, WITH_MASSES
from kurbel.commands.options import Choice, Option, measure, word
from kurbel.commands.part import CommandOptions, flag_of
from kurbel.commands.parts.diagram import Diagram
from kurbel.commands.parts.effort import RODS
from kurbel.commands.parts.engine import Engine
from kurbel.commands.parts.press import Press
from kurbel.commands.parts.sheet import Layouts, Sheet, columns_option, layout_option
from kurbel.commands.parts.wheel import FIGURES, PLAIN, SPEEDS, Body, Rim, Swing, Wheel
from kurbel.commands.subject import function
from kurbel.drive.at import known
from kurbel.drive.wheel import Flywheel, check_irregularity
from kurbel.engine.captions import caption
from kurbel.engine.cylinder import TurnPlace
from kurbel.engine.diagram.excess import ExcessTorque
from kurbel.engine.diagram.fluctuation import Areas, Fluctuation
from kurbel.engine.diagram.relations import SHOWN, registry
from kurbel.engine.diagram.sizing import Known, SizedFlywheel, gathered, sized, told_by
from kurbel.engine.diagram.wheel_page import WheelRequest
from kurbel.engine.engine_quantities import engine_registry, value
from kurbel.engine.notes import engine_notes
from kurbel.engine.request import EngineRequest
from kurbel.errors import ProblemError
from kurbel.exact.kind import floats
from kurbel.exact.real import Product
from kurbel.page.layouts import Layout, layout_of
from kurbel.page.subject import Question
from kurbel.reading.given import as_angle
from kurbel.reading.names import enumerated

ENGINE, SIZING = "flywheel", "flywheel sizing"
PAGE_OF_SIZES = "flywheel-sizing"
AT_ANGLE = (
    "speed, torque and energy at an angle are those of kurbel turning --angle 30 --flywheel 50 --speed"
    " 120/min --columns omega,torque_nm,energy"
)
# What an engine's flywheel is not given by.
ALONE = (Diagram, Swing, Press, Body)


class FlywheelOptions(Engine, Diagram, Wheel, Layouts, Sheet, CommandOptions):
    """Print the flywheel that keeps an engine or a driven machine even: energy swing, moment of inertia,
    mass.

    Without an engine what is given of swing, speed, irregularity, flywheel and rim finds the rest.

    \b
    kurbel flywheel --power 50kW --speed 120/min --delta 1:100 --eps 4  # steam
    kurbel flywheel --swing 5kJ --speed 300/min --delta ±1% --radius 1m  # a swing
    kurbel flywheel --areas '+52;-124;+72' --area-scale '500 N m; 6°' --speed 600/min \
--delta ±1.5%  # a diagram
    kurbel flywheel --power 50kW --speed 120/min --delta '1:50;1:100' --eps 4 --radius 1.5m
    kurbel flywheel --swing 56kJ --speed 120/min --mass 6.5t --radius 1.8m
    kurbel flywheel --power 300kW --speed 90/min --energy-fluctuation 0.1 --delta ±0.5% --radius 2m
    kurbel flywheel --torque '5000 + 1500 sin(3φ)' --speed 300/min --inertia 200kgm2
    kurbel flywheel --power 3kW --work 10kJ --duration 1s --greatest-speed 300/min --mass 150kg --radius 0.6m
    kurbel flywheel --work 10kJ --strokes 30/min --share 1/4 --speed 200..225/min --radius 0.5m
    kurbel flywheel --swing 56kJ --speed 120/min --delta 1:60 --rim-diameter 3m --density 7200kg/m³
    \f
    >>> import kurbel
    >>> page = kurbel.flywheel(swing=5000, speed="300/min", delta="±1%", columns="delta,inertia")
    >>> print(kurbel.typeset(page, "csv"), end="")
    delta,inertia
    0.02,253.30
    """

    unnamed = "eps"
    sequence = (
        f"{ENGINE_ORDER} torque torque_file triangles load_torque load_torque_file turns areas area_scale"
        " angle swing energy_fluctuation work strokes share duration hole punch_stroke shear_energy"
        " shear_strength efficiency greatest_speed least_speed inertia run_up_torque run_up_time run_up_turns"
        " mass rim_diameter rim_speed rim_section rim_breadth"
        " rim_thickness density hoop_stress rim_share disc_diameter disc_thickness"
        f" {LOAD_ORDER} power speed delta radius columns unknown"
    )
    in_short = "delta power speed swing inertia mass radius eps ratio machine torque areas"

    angle = measure(
        as_angle,
        "Crank angle of a diagram at which the angular acceleration of the flywheel stands: 45.",
        "ANGLE",
        topic="diagram",
    )
    unknown = word(
        "What is asked for: disc_diameter, rim_mass, delta; says what is missing where it does not follow.",
        kind=Choice("unknown", "kurbel.engine.diagram.relations:SHOWN"),
        topic="question",
    )
    columns = columns_option("flywheel", "target,swing,inertia")
    layout = layout_option(ENGINE, SIZING)

    def question(self) -> Question:
        return self._of_engine() if self.is_engine() else self._alone()

    def is_engine(self) -> bool:
        """Whether the flywheel is that of an engine, which what acts on its pistons or the layout says."""
        return super().is_engine() or self.layout_subject == ENGINE

    def has_turns(self) -> bool:
        return not self.is_diagram() and super().has_turns()

    def is_driven(self) -> bool:
        return super().is_driven() or (self.is_diagram() and not self.says("areas"))

    def unread(self, option: Option[object]) -> str:
        return self._beside_engine(option) if self.is_engine() else self._without_engine(option)

    def _beside_engine(self, option: Option[object]) -> str:
        name, flag = option.name, flag_of(option.name)
        if name == "angle":
            return f"--angle is a place on a diagram without an engine; {AT_ANGLE}"
        if option.home in ALONE:
            return (
                f"{flag} is of a flywheel without an engine, and one is described; leave one of the two out"
            )
        if name == "power":
            if self.is_heavy():
                return WITH_MASSES
            return "the power of unlike cylinders follows from their sizes; leave --power out"
        if self.says("power") and name in (*self.weighing(), "stroke"):
            why = "is for the power of the engine, which --power gives; leave one of the two out"
            return f"{flag_of(name)} {why}"
        return ""

    def _without_engine(self, option: Option[object]) -> str:
        name = option.name
        if name == "angle":
            return f"--angle is a place on a diagram by --torque; {AT_ANGLE}"
        if name == "turns":
            return (
                "--turns is of the cycle of a diagram or of a work; add --torque, --work or --power, or leave"
                " it out"
            )
        if sentence := Diagram.unread(self, option) or Press.unread(self, option):
            return sentence
        return (
            f"{flag_of(name)} is of an engine, and none is described; add --eps, --card"
            " or another load, or leave it out"
        )

    def _of_engine(self) -> Question:
        """Return the page of an engine's flywheel, with a rim that of its sizes."""
        # Else more would be asked of an engine that is not meant.
        self.refuse(*(name for part in ALONE for name in part.options()))
        heavy = self.is_heavy() or self.is_several()
        if heavy:
            self.refuse("power")
        for name, example in (("speed", "120/min"), ("delta", "1:100")):
            if self.raw(name) is None:
                raise ProblemError(
                    f"the flywheel of an engine needs --{name}; add it, for example --{name} {example}"
                )
        # With masses it follows from the load, against which they are weighed.
        power = None if heavy else self._power()
        self._refuse_sizes(power)
        turns, radius = self.speed, self.radius
        assert turns is not None
        wheels = tuple(Flywheel(power, turns, each, radius) for each in self.delta or ())
        if self.says(*(one.name for one in Rim.options().values())):
            page = self.page(PAGE_OF_SIZES, SIZING)
            engines = self.of_page(layout_of(ENGINE, (ENGINE,)))
            engine = EngineRequest(**engines, flywheels=wheels, **self.printed())
            return self._with_rim(engine, page)
        page, names = self.page(ENGINE, ENGINE), self.names(EXAMPLE)
        return EngineRequest(**self.of_page(page), flywheels=wheels, columns=names, **self.printed())

    def _power(self) -> Fraction | None:
        """Return the power, None where it follows from the load. Raises ProblemError for neither."""
        if (power := self.power) is not None:
            return power
        sized = self.says("stroke", "rod")
        missing = [name for name in self.weighing() if not self.says(name)]
        if not sized or missing:
            sizes = enumerated(map(flag_of, (*([] if sized else ["stroke"]), *missing)))
            raise ProblemError(
                "a flywheel needs the power of the engine; add --power, for example --power 50kW, or"
                f" {sizes}, from which it follows"
            )
        return None

    def _refuse_sizes(self, power: Fraction | None) -> None:
        """Raise ProblemError for a size that makes the power, where that is given and nothing needs it."""
        if power is None:
            return
        if not self.says("friction", *RODS):
            sizes = self.weighing()
            self.refuse(*(sizes[:1] if self._back_is_pressure() else sizes))
        if not self.says("rod"):
            self.refuse("stroke")
        elif not (self.says("stroke") or self.compares_lengths()):
            self.refuse("rod")

    def _with_rim(self, engine: EngineRequest, page: Layout) -> WheelRequest:
        """Return what is asked for of one engine. Raises ProblemError for several, and for cards."""
        if engine.carded:
            raise ProblemError(
                "the swing by an indicator card is an estimate, and a rim has certified digits; give what"
                " kurbel flywheel prints of it as --swing"
            )
        engines = len(engine.steams) * len(engine.ratios)
        if engines != 1 or len(engine.methods) > 1:
            raise ProblemError(f"a rim is that of one engine by one method; {engines} engines were given")
        return WheelRequest(
            wheels=tuple(self._rim(engine, one) for one in engine.flywheels),
            targets=tuple(one.irregularity for one in engine.flywheels),
            engine=(caption(engine), *engine_notes(engine)),
            **self.on_page(page, EXAMPLE),
        )

    def _rim(self, engine: EngineRequest, wheel: Flywheel) -> SizedFlywheel:
        sizes = [name for name in PLAIN if name in Rim.options()]
        given = self.figures("radius", *sizes, "speed", "rim_section")
        figures = gathered((*given, *_of_engine(engine, wheel)))
        return sized(figures, figures.pop("hoop_stress", None))

    def _alone(self) -> WheelRequest:
        """Return what is asked for without an engine, one flywheel for each irregularity to keep."""
        page = self.page(PAGE_OF_SIZES, ENGINE, SIZING)
        diagram = self.fluctuation() if self.is_diagram() else None
        of_diagram = _of_diagram(diagram) if diagram else ()
        figures = gathered((*self.figures(), *self.of_press(), *of_diagram))
        share = self.share_of(figures)
        if share is not None:
            swing = Known(share.rest, (share.option,))
            figures = gathered((*figures.items(), ("energy_fluctuation", swing)))
        limit, targets = figures.pop("hoop_stress", None), self.delta or ()
        for target in targets:
            check_irregularity(target)
        wheels = [
            sized(gathered((*figures.items(), ("delta", Known(Product.of(target), ("--delta",))))), limit)
            for target in targets
        ] or [sized(figures, limit)]
        for wheel in wheels:
            self._check_unknown(wheel)
        return WheelRequest(
            wheels=tuple(wheels),
            targets=tuple(targets),
            known_from=self._source(),
            fluctuation=diagram,
            press=(share.working, share.rest) if share else None,
            angle=self.angle if isinstance(diagram, ExcessTorque) else None,
            **self.on_page(page, EXAMPLE),
        )

    def _check_unknown(self, wheel: SizedFlywheel) -> None:
        """Raise ProblemError for what is asked for and does not follow, with what would tell it."""
        unknown = self.unknown
        if unknown is None or wheel.knows(unknown):
            return
        options = {FIGURES.get(name, name): flag_of(name) for name in PLAIN}
        options |= {figure: flag_of(name) for name, figure in SPEEDS.items()} | {"delta": "--delta"}
        of = SHOWN[unknown].figure
        ways = [
            flag for figure, flag in options.items() if figure != of and told_by(wheel.figures, figure, of)
        ]
        name, more = registry()[unknown].name["en"], " or ".join(ways) or "more of the wheel"
        raise ProblemError(f"{name} does not follow from what is given; add {more}")

    def _source(self) -> str:
        """Return what the swing is known from, for the caption."""
        sources = {
            "areas": self.says("areas"),
            "torque": self.is_diagram(),
            "swing": self.says("swing"),
            "press": self.says("share", "duration", "punch_stroke"),
            "fluctuation": self.says("energy_fluctuation"),
        }
        return next((source for source, known in sources.items() if known), "")


flywheel = function(FlywheelOptions, "flywheel")


def _of_engine(engine: EngineRequest, wheel: Flywheel) -> Iterator[tuple[str, Known]]:
    """Yield the figures that the engine gives, its swing and its power."""
    turn = engine.turn(0, 0, engine.page_columns[0].method)
    where, registry = TurnPlace(flywheel=wheel), engine_registry()

    def enclosed(key: str) -> Product:
        return Product.about(lambda kind: value(registry[key], turn, where))

    yield "delta", Known(Product.of(wheel.irregularity), ("--delta",))
    yield "swing", Known(enclosed("swing"), ("the engine",))
    power = enclosed("power") if wheel.power is None else Product.of(wheel.power)
    yield "power", Known(power, ("--power",))


def _of_diagram(diagram: Fluctuation) -> Iterator[tuple[str, Known]]:
    """Yield the figures that a diagram gives."""
    options = ("--areas",) if isinstance(diagram, Areas) else ("the torque",)
    yield "swing", Known(_swing(diagram), options)
    if diagram.turns is not None:
        yield "turns", Known(Product.of(diagram.turns), options)
    mean = diagram.mean_torque(floats())
    # That of a shaft which is driven back has no power of its own to print.
    if mean is not None and mean > 0:
        torque = Product.reduced(lambda kind: known(diagram.mean_torque(kind)))
        # Of a torque with π the work has none.
        work = Product.about(lambda kind: known(diagram.work(kind)))
        yield ("work", Known(work, options)) if torque.pi else ("mean_torque", Known(torque, options))


def _swing(diagram: Fluctuation) -> Product:
    if isinstance(diagram, Areas):
        scale = diagram.scale
        return Product.of((max(diagram.levels) - min(diagram.levels)) * scale.energy, int(scale.of_pi))
    return Product.reduced(diagram.swing)
