"""Engines and driven machines, and how evenly they turn."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, ClassVar

from kurbel.commands.options import Option, flag
from kurbel.commands.part import CommandOptions, flag_of
from kurbel.commands.parts.angles import FULL_TURN, STEP, Angles, in_degrees
from kurbel.commands.parts.diagram import DIAGRAMS, DRIVES, LOADS, Diagram
from kurbel.commands.parts.drive import Speed
from kurbel.commands.parts.effort import RODS
from kurbel.commands.parts.engine import Engine
from kurbel.commands.parts.loads import KINDS
from kurbel.commands.parts.masses import Masses
from kurbel.commands.parts.performance import Flywheel
from kurbel.commands.parts.sheet import Layouts, Sheet, columns_option, layout_option
from kurbel.commands.subject import function
from kurbel.engine.engine_quantities import Needs, engine_registry
from kurbel.engine.request import EngineRequest
from kurbel.errors import ProblemError
from kurbel.reading import notation
from kurbel.reading.given import as_angles, as_ratios

if TYPE_CHECKING:
    from kurbel.drive.wheel import Wheel
    from kurbel.page.layouts import Layout
    from kurbel.page.quantity import Need
    from kurbel.page.subject import Question

EXAMPLE, DETAIL = "epsilon,delta", "delta-detail"
WITH_MASSES = "with masses the power follows from pressure, bore, stroke and speed; leave --power out"
# The order of what engines have in common, before other loads and behind them.
ENGINE_ORDER = (
    "ratio back exponent clearance card other_side single_acting cranks method reciprocating rod_mass centre"
    " gyration rod_file slope gravity friction stroke time_ratio rod"
    " bore pressure piston_rod tail_rod offset mechanism rocker pivot circuit beam rocker_inertia"
)
LOAD_ORDER = (
    "pressure_ratio suction_loss delivery_loss pump small_area suction_pressure delivery_pressure compression"
    " cycle peak_pressure cut_off heat expansion_exponent exhaust_pressure two_stroke cylinder pendulum"
    " pendulum_from"
)
# Pages of an engine, and those of one with its flywheel.
DELTA = ("irregularity", "strokes", "evenness", "compressor", "pump", "gas cycle", "cylinders")
TURNING = ("turning", "speed")
WITH_WHEEL = ("speed", "evenness")
# Pages of a diagram without an engine.
TORQUES, AREAS = "torques", "areas"
# What counts beside masses, or in columns; what these need, beside bore and pressures of the load.
SIZES = ("stroke", "rod", "speed", "bore", "pressure")
NEEDS: Mapping[Need, tuple[str, ...]] = {
    Needs.LOAD: (), Needs.STROKE: ("stroke",), Needs.TORQUE: ("stroke",), Needs.POWER: ("stroke", "speed")
}  # fmt: skip


class EngineWithWheel(Flywheel, Engine, Layouts, Sheet, CommandOptions):
    """An engine with its flywheel."""

    # Columns for which bore, stroke and speed are.
    of_sizes: ClassVar[tuple[str, ...]] = ()
    # A column that has to do with the flywheel.
    of_wheel: ClassVar[str] = ""

    speed = Speed.speed.but(help="Speed: 120/min, 12.5rad/s.")

    def is_sized(self) -> bool:
        # Whether they count, the columns say.
        return True

    def asked_wheel(self, page: Layout, names: Collection[str]) -> Wheel | None:
        """Return the flywheel of a page on which it says something. Raises ProblemError if no column does."""
        if page.subject not in WITH_WHEEL:
            return None
        from kurbel.engine.speed.speed_page import of_runs

        found = self.wheel(self.is_heavy())
        if names and not of_runs() & {*names}:
            self.refuse("flywheel", "inertia")
        return found

    def checked(self, question: EngineRequest) -> EngineRequest:
        """Return what is asked for. Raises ProblemError for a size that was typed and counts in nothing."""
        shown = [one.quantity for one in question.page_columns]
        used = {name for one in shown for name in self._needed(one.needs)}
        if question.columns and any(one.key == "mean_pressure_kpa" for one in shown):
            # The bore of a cylinder is given with its stroke.
            used |= {*self._needed((Needs.STROKE,))}
        for name in SIZES:
            typed = self.values.typed(name) and self.says(name)
            if typed and name not in used and not self._counts(name):
                lacking = [] if question.columns else self._lacking(question, name)
                flag = flag_of(name)
                sentence = f"{flag} says nothing on this page by itself; add {', '.join(lacking)}"
                raise ProblemError(sentence if lacking else self.refusal(self.options()[name]))
        return question

    def _counts(self, name: str) -> bool:
        """Whether a size counts without any column."""
        if self.is_heavy() or self.is_several():
            return True
        # A flywheel without a power is weighed against the load.
        if self.says("inertia") and not self.says("power"):
            return True
        if name in ("stroke", "rod"):
            return self.says("stroke") == self.says("rod") or self.compares_lengths()
        if name == "speed":
            return self.has_wheel()
        return self.says("friction", *RODS) or (name == "pressure" and self._back_is_pressure())

    def _needed(self, needs: Iterable[Need]) -> Sequence[str]:
        """Return the options that make such a column known; the rod gives the stroke by the ratio."""
        of_sizes = [need for need in needs if need in NEEDS]
        length = "rod" if self.says("rod") and not self.says("stroke") else "stroke"
        own = [length if name == "stroke" else name for need in of_sizes for name in NEEDS[need]]
        return own if {*of_sizes} <= {Needs.STROKE} else [*own, *self.weighing()]

    def _lacking(self, question: EngineRequest, name: str) -> list[str]:
        """Return what the nearest column of the page lacks that a size is for, none if no column is."""
        needs = [self._needed(question.entry(one.quantity).needs) for one in question.layout.columns]
        found = [[flag_of(one) for one in each if not self.says(one)] for each in needs if name in each]
        return min(found, key=len, default=[])

    def unread(self, option: Option[object]) -> str:
        name, flag = option.name, flag_of(option.name)
        if name in ("flywheel", "inertia"):
            return f"{flag} says nothing on this page; {self._of_wheel()}"
        if name == "power":
            if self.is_heavy():
                return WITH_MASSES
            return "--power is for --inertia, whose flywheel is weighed against it; leave it out"
        if name == "resistance":
            return "--resistance is for a flywheel; add --flywheel or --inertia"
        if name == "rod":
            return "--rod gives the ratio with --stroke; add that, or leave --rod out"
        if name in SIZES and name not in (() if self.says("eps") else ("pressure",)):
            for key in self.of_sizes:
                if name in self._needed(engine_registry()[key].needs):
                    return f"{flag} says nothing on this page; add --reciprocating, or a column such as {key}"
            return f"{flag} is for {Masses.title}; add {Masses.add}"
        return ""

    def _of_wheel(self) -> str:
        """Return how a flywheel would be used, where nothing that is asked for has to do with it."""
        if self.layout and self.layout_subject not in WITH_WHEEL:
            return f"leave --layout {self.layout} or the flywheel out"
        return f"add a column such as {self.of_wheel}"


class DeltaOptions(EngineWithWheel):
    """Print the degree of irregularity δ of an engine or a driven machine: of steam over the expansion
    ratio ε, of a compressor over its pressure ratio, of a pump, of the cycle of a gas engine.

    \b
    kurbel delta --eps 4 --ratio 1:5  # cut-off after a quarter
    kurbel delta --eps 2..6 --ratio '1:4;1:5'  # a table of both
    kurbel delta --machine engine.toml  # with its masses
    kurbel delta --pressure-ratio 4 --clearance 5%  # a compressor
    kurbel delta --pump --cranks '0;90'
    kurbel delta --compression 5..8 --heat 10
    kurbel delta --eps 2 --detail
    kurbel delta --eps 2..6 --method exact --method series --method weisbach
    kurbel delta --eps 2..8 --ratio '1:4;1:5;1:∞' --back 0.1 -f latex -o anhang.tex
    kurbel delta --eps 4 --cranks '0;90' --detail
    kurbel delta --eps 2..6 --flywheel 50
    kurbel delta --eps 4 --inertia 3584.3kgm2 --power 50kW --speed 120/min
    \f
    >>> import kurbel
    >>> print(kurbel.typeset(kurbel.delta("2..4"), "csv"), end="")
    epsilon,ratio,delta
    2,1:5,1.282
    3,1:5,1.374
    4,1:5,1.423
    >>> page = kurbel.delta(pressure_ratio="2..4", columns="pressure_ratio,mean_force,delta")
    >>> print(kurbel.typeset(page, "csv"), end="")
    pressure_ratio,mean_force,delta
    2,-0.4413,1.282
    3,-0.6994,1.374
    4,-0.8825,1.423
    """

    topic = "question"

    unnamed = "eps"
    sequence = f"{ENGINE_ORDER} {LOAD_ORDER} flywheel inertia power resistance speed detail columns"
    in_short = "eps back bore pressure card ratio machine pressure_ratio compression cranks flywheel detail"

    of_sizes: ClassVar[tuple[str, ...]] = ("indicated_power",)
    of_wheel = "delta_mean"

    detail = flag("All that leads to δ: angles and speeds of both strokes.")
    columns = columns_option("weisbach-150", "epsilon,delta,mean_force", chosen={"detail": DETAIL})
    layout = layout_option(*DELTA)

    def question(self) -> Question:
        names = self.names(EXAMPLE)
        if self.detail and self.layout not in (None, DETAIL):
            raise ProblemError(
                f"--detail is layout {DETAIL}, and --layout names {self.layout}; leave one out"
            )
        page = self.page(self._usual(names), *DELTA)
        asked = EngineRequest
        if page.subject == "cylinders":
            from kurbel.engine.cylinders import CylindersRequest

            asked = CylindersRequest
        wheel = self.asked_wheel(page, names)
        return self.checked(asked(**self.of_page(page), wheel=wheel, columns=names, **self.printed()))

    def _usual(self, names: Collection[str]) -> str:
        """Return the layout, for columns of these names if there are any."""
        if self.has_wheel() and not self.detail:
            return "delta-flywheel"
        methods, ratio = self.method or (), self.raw("ratio")
        several = not isinstance(methods, str) and len({*methods}) > 1
        if self.detail or (not several and (self.says("card") or "alpha_cutoff" in names)):
            return DETAIL
        if several:
            return "delta-verfahren"
        if self.is_several():
            return DETAIL
        many = len(as_ratios(() if ratio is None else ratio)) > 1
        return self.usual_layout() or ("delta-tafel" if many else "weisbach-150")

    def _of_wheel(self) -> str:
        return "leave --detail or the flywheel out" if self.detail else super()._of_wheel()


delta = function(DeltaOptions, "delta")


class TurningOptions(EngineWithWheel, Diagram):
    """Print the turning effort of an engine or a driven machine: tangential force and excess energy over the
    crank angle; without an engine a turning-moment diagram, by its torque or its areas.

    \b
    kurbel turning --eps 4 --ratio 1:5  # without dimensions
    kurbel turning --machine engine.toml  # a machine, in N and J
    kurbel turning --eps 4 --cranks '0;90'  # two cylinders
    kurbel turning --torque '5000 + 1500 sin(3φ)'  # a diagram without an engine
    kurbel turning --pressure-ratio 3 --clearance 5%
    kurbel turning --eps 4 --step 0.5 -f csv -o drehkraft.csv
    kurbel turning --eps 4 --flywheel 50 --columns phi,speed
    kurbel turning --torque '5000 + 1500 sin(3φ)' --load-torque '5000 + 600 sin φ'
    kurbel turning --torque '0:0; 60:90; 180:0; 360:0' --cranks '0;120;240'
    kurbel turning --areas '+52;-124;+92;-140;+85;-72;+107' --area-scale '500 N m; 6°'
    """

    unnamed = "eps"
    sequence = (
        f"{ENGINE_ORDER} {LOAD_ORDER} flywheel inertia power resistance torque torque_file triangles"
        " load_torque load_torque_file turns areas area_scale speed angle step columns"
    )
    in_short = "eps back bore pressure card ratio stroke machine torque cranks step columns"
    of_sizes: ClassVar[tuple[str, ...]] = ("pin_path_mm", "tangential_kpa")
    of_wheel = "speed"

    angle = Angles.angle.but(
        help="Crank angles in degrees: 22.5, 2°30', lists '0;45;90', ranges 0..360:10; or what holds there:"
        " 's=10%', 'x=120mm', torque=max."
    )
    step = Angles.step.but(help="Step of the angles through the whole turn; default 10.")
    columns = columns_option(
        "turning",
        "phi,tangential,energy",
        chosen={"areas": AREAS, **dict.fromkeys((*DRIVES, *LOADS), TORQUES), "flywheel": "speed"},
    )
    layout = layout_option(*TURNING, TORQUES, AREAS)

    def question(self) -> Question:
        if self.is_diagram() or self.layout_subject in (TORQUES, AREAS):
            return self._diagram()
        if not self.is_engine():
            # What acts on the piston would be missing first.
            self.refuse("turns", "area_scale")
        names = self.names(EXAMPLE)
        page = self.page("speed" if self.has_wheel() else "turning", *TURNING)
        return self.checked(
            EngineRequest(
                angles=self._angles(self.turn(), page),
                wheel=self.asked_wheel(page, names),
                columns=names,
                **self.of_page(page),
                **self.printed(),
            )
        )

    def unread(self, option: Option[object]) -> str:
        if found := Diagram.unread(self, option):
            return found
        if not self.is_diagram():
            return super().unread(option)
        named = next(name for name in DIAGRAMS if self.says(name))
        return (
            f"{flag_of(option.name)} describes an engine, and {flag_of(named)} a diagram without one; leave"
            " one of them out"
        )

    def _diagram(self) -> Question:
        """Return what is asked for of a diagram without an engine. Raises KurbelError."""
        from kurbel.engine.diagram.diagram_page import AreasRequest, TorquesRequest

        if self.is_diagram():
            self.refuse(*KINDS, "cylinder")
        subject = AREAS if self.says("areas") or self.layout_subject == AREAS else TORQUES
        page, mean, inertia = self.page(subject, subject), self.speed, self.inertia
        if subject == AREAS:
            return AreasRequest(
                areas=self.whole_areas(),
                inertia=inertia,
                speed=mean,
                **self.on_page(page, "point,excess_energy"),
            )
        excess = self.excess()
        return TorquesRequest(
            excess=excess,
            angles=self._angles(excess.cycle),
            constant=self.constant(),
            cranks=self.crank_angles(),
            inertia=inertia,
            speed=mean,
            **self.on_page(page, "phi,excess_energy"),
        )

    def _angles(self, cycle: Fraction, page: Layout | None = None) -> Sequence[Fraction]:
        """Return the crank angles, by themselves over the whole cycle, or those of a page of one turn."""
        angles, step = self.angle, self.step
        if angles is not None and step is not None:
            raise ProblemError(
                "--angle lists the angles and --step runs through the turn; use one or the other"
            )
        if angles is not None:
            if page is None and any(isinstance(one, str) for one in angles):
                raise ProblemError(
                    "a turning-moment diagram has no piston whose place gives the angle; write --angle in"
                    " degrees"
                )
            return in_degrees(angles, self.values, () if page is None else page.ratios, cycle)
        if step is None and page is not None and cycle <= FULL_TURN:
            return as_angles(page.angles)
        return notation.progression(Fraction(0), cycle, min(STEP, cycle) if step is None else step)


turning = function(TurningOptions, "turning")
