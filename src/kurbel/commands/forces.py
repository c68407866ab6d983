"""What a piston force, the steam of an engine or the moving rod calls up in rod, guide and crank pin."""

from __future__ import annotations

from collections.abc import Sequence

from kurbel.commands.motion import OverPath
from kurbel.commands.options import Choice, LayoutName, Option, measure, word
from kurbel.commands.part import CommandOptions, flag_of
from kurbel.commands.parts.angles import ENDS, FORCES_OVER_PATH, FULL_TURN, OVER_PATH
from kurbel.commands.parts.drive import OF_MASSES, Turning, with_pins
from kurbel.commands.parts.effort import PINNED, PRESSING, Effort, PinFriction, TurningShaft
from kurbel.commands.parts.engine import Engine, ReferenceCylinder
from kurbel.commands.parts.loads import FURTHER, KINDS
from kurbel.commands.parts.masses import Masses
from kurbel.commands.parts.sheet import columns_over_angle
from kurbel.commands.subject import function
from kurbel.drive.crank import DescribedDrive
from kurbel.drive.mechanisms import LINKAGES, SUBJECTS
from kurbel.drive.moved import Drive
from kurbel.errors import ProblemError
from kurbel.motion.mechanism import Mechanism, mechanism
from kurbel.page.subject import Question
from kurbel.reading.given import as_number, as_places

ROD_LOAD, COUPLED, TANGENT = "rod load", "coupled axles", "tangent"
OF_DRIVES = ("motion", "effort", "mass forces")
OF_ENGINES = ("crank forces", "machine", ROD_LOAD)


class ForcesOptions(
    OverPath, Engine, ReferenceCylinder, Effort, PinFriction, TurningShaft, Turning, CommandOptions
):
    """Print the forces of the crank drive: rod, guide, tangential and radial force, torque.

    Per unit piston force, under a force of so many newtons and with moving masses, or over the turn of a
    steam engine.

    \b
    kurbel forces --force 10kN --stroke 600mm  # in N and N m
    kurbel forces --eps 4 --bore 300mm --pressure 8bar  # a steam engine
    kurbel forces --machine engine.toml --angle '30;60'  # at two angles
    kurbel forces --mechanism arc --ratio 1:5 --rocker 6  # of a rocker
    kurbel forces --ratio 1:5
    kurbel forces --ratio 1:5 --at tangent
    kurbel forces --mechanism parallel --axles '14;15;14' --driven 2
    kurbel forces --pressure-ratio 4 --bore 300mm --suction-pressure 1bar
    kurbel forces --eps 4 --layout rod-load
    \f
    >>> import kurbel
    >>> page = kurbel.forces("3:4", at="tangent", columns="phi,rod_force,guide_force")
    >>> print(kurbel.typeset(page, "csv"), end="")
    phi,rod_force,guide_force
    53.1301,1.2500,0.7500
    >>> page = kurbel.forces("1:5", mechanism="arc", rocker=6, angle=90, columns="rod_force,torque")
    >>> print(kurbel.typeset(page, "csv"), end="")
    rod_force,torque
    1.0172,0.9967
    """

    topic = "question"

    unnamed = "ratio"
    sequence = (
        "angle from_ to step zero columns offset stroke time_ratio rod"
        " mechanism rocker pivot circuit beam axles driven force at eps back exponent clearance card"
        " other_side single_acting cranks bore pressure reciprocating rod_mass centre gyration rod_file"
        " rotating rocker_inertia slope gravity head_pressure crank_pressure pressure_difference"
        " piston_rod tail_rod friction pin_friction crosshead_pin crank_pin shaft speed acceleration method"
    )
    in_short = "ratio stroke rod speed machine force eps bore pressure reciprocating angle columns"
    # A force that is typed outdoes the load of a machine.
    rivals = tuple((key, "force") for key in ("eps", "card", *FURTHER))

    columns = columns_over_angle(
        "forces", "phi,rod_force,guide_force,torque", **dict.fromkeys(KINDS, "engine-forces")
    )
    axles = measure(
        as_places,
        "Parallel crank: so many coupled axles alike, 3, or the weights on them, by which they share the"
        " effort: '14;15;14'.",
        "WEIGHTS",
        what="weight on an axle",
        whole=True,
        topic="linkage",
    )
    driven = measure(
        as_number, "With --axles: which of them the force F drives; default 1, the first.", "N",
        what="driven axle", topic="linkage",
    )  # fmt: skip
    at = word(
        "tangent: a sheet of the position in which the rod touches the crank circle, with closed forms.",
        kind=Choice("position", (TANGENT,)),
    )
    speed = Turning.speed.but(help="Speed, for the masses: 120/min, 12.5rad/s.")
    method = OF_MASSES.but()
    layout = word(
        "Page layout; default: forces, with weight, friction or pressures forces-effort;"
        " with --eps or --card engine-forces, with masses machine-forces,"
        " and rod-load for extremes and reversal of the rod's load;"
        f" of the {' or '.join(LINKAGES)} crank {', '.join(f'forces-{name}' for name in LINKAGES)}.",
        kind=LayoutName((*OF_DRIVES, *OF_ENGINES, TANGENT, *SUBJECTS, COUPLED, FORCES_OVER_PATH, OVER_PATH)),
        topic="page",
    )

    def question(self) -> Question:
        chosen = self.drive(self._layout_of_drive())
        if self.is_tangent() and chosen.crosshead:
            return self._tangent(chosen)
        if chosen.name == "parallel" and (self.says("axles") or self.layout_subject == COUPLED):
            return self._coupled()
        if self.of_engine():
            return self._engine()
        if self.says("at"):
            raise ProblemError(f"--at does not belong to {chosen.title}; it is for --mechanism straight")
        self.check_pins()
        chosen, described = self._described()
        if self.is_over_path():
            return self._over_path(chosen, described)
        name = "forces-effort" if chosen.crosshead and self.has_parts() else chosen.forces_layout
        page = self.page(name, *((*OF_DRIVES, *OF_ENGINES) if chosen.crosshead else (chosen.subject,)))
        if page.subject in OF_ENGINES:
            raise ProblemError(f"layout {page.key} is of a steam engine; add --eps or --card")
        drives: Sequence[Drive] = chosen.drives(described, page.ratios)
        if "rubbing" in str(self.values.values.get("columns")):
            drives = with_pins(self, chosen, drives)
        question = chosen.question(
            self.pushed(chosen, self.weighed(chosen, drives)),
            self.method if self.is_heavy() else None,
            angles=self.angles(page),
            zero=self.zero_angle,
            **self.on_page(page, chosen.examples["forces"]),
        )
        return self.over_strokes(question)

    def drive(self, layout: str | None = None) -> Mechanism:
        if self.layout_subject == COUPLED and not self.mechanism:
            return mechanism("parallel")
        return super().drive(layout)

    def is_tangent(self) -> bool:
        """Whether the position is meant in which the rod touches the crank circle."""
        return self.says("at") or self.layout_subject == TANGENT

    def of_engine(self) -> bool:
        """Whether the load of an engine is meant."""
        return self.is_engine() and self.layout_subject not in OF_DRIVES

    def case(self) -> str:
        if self.is_tangent():
            return "--at tangent, a position with an angle of its own under one piston force"
        if not self.of_engine():
            return ""
        return (
            "the steam of an engine, --eps or --card" if self.says("eps", "card") else "the load of an engine"
        )

    def unread(self, option: Option[object]) -> str:
        name, flag = option.name, flag_of(option.name)
        if name == "at":
            chosen = self.drive(self._layout_of_drive())
            return f"--at does not belong to {chosen.title}; it is for --mechanism straight"
        if name == "driven":
            return "--driven is for coupled axles; add --axles 3"
        if name == "axles":
            chosen = self.drive(self._layout_of_drive())
            return f"--axles does not belong to {chosen.title}; it is for --mechanism parallel"
        if self.is_tangent():
            if name in ("angle", *ENDS):
                return (
                    f"{flag} does not go with --at tangent, a position with an angle of its own; leave it out"
                )
            why = "a position under one piston force, --force"
            return f"{flag} does not go with --at tangent, {why}; leave it out"
        if not self.of_engine():
            if named := [key for key in self.load_names() if name in (key, *KINDS[key].options)]:
                return f"{flag_of(named[0])} says nothing on layout {self.layout}; leave one out"
            if name in ("speed", "acceleration", "method") and not self.is_heavy():
                return f"{flag} is for {Masses.title}; add {Masses.add}"
            if name in ("bore", "cranks"):
                return f"{flag} is for the steam of an engine; add --eps or --card"
            if name == "power" and not self.says("inertia"):
                return "--power is what is taken off the shaft, beside its --inertia; add that"
            if name == "friction":
                return "--friction lessens a force; add --force, --head-pressure or masses"
            return ""
        if name in ("inertia", "power"):
            return (
                f"{flag} does not go with {self.case()}; the acceleration of its shaft has kurbel turning"
                " --flywheel 50 --speed 120/min --columns phi,angular_acceleration"
            )
        if name == "force":
            return f"--force does not go with {self.case()}; leave it out"
        if name == "acceleration":
            return f"{flag} does not go with the load of an engine, whose crank turns evenly; leave it out"
        if name in PRESSING:
            return (
                f"{flag} does not go with the load of an engine, which has its own pressures; leave one of"
                " the two out"
            )
        if name in PINNED:
            return f"{flag} is for a given force or pressures; the turn of an engine with it is not computed"
        return ""

    def _described(self) -> tuple[Mechanism, DescribedDrive]:
        # A speed alone makes no force, and a method is that of masses.
        moving = ("speed", "acceleration", "method")
        taken = self.is_pushed() and self.accelerates() and self.says("power")
        beside, leaving = (("speed",), ()) if self.is_heavy() or taken else ((), moving)
        return self.described(self._layout_of_drive(), ("stroke", "force", *beside), leaving)

    def _layout_of_drive(self) -> str | None:
        return self.layout if self.layout_subject in SUBJECTS else None

    def _tangent(self, chosen: Mechanism) -> Question:
        from kurbel.motion.tangent_page import TangentRequest

        assert self.at in (None, TANGENT)
        page = self.page("forces-tangent", TANGENT)
        _, described = self.described(None, ("stroke", "force"), ("speed", "acceleration", "method"))
        return TangentRequest(
            drives=described.cranks(page.ratios), zero=self.zero_angle,
            **self.on_page(page, "phi,rod_force"),
        )  # fmt: skip

    def _coupled(self) -> Question:
        from kurbel.linkage.parallel import CoupledRequest, axles_of

        if self.is_over_path():
            raise ProblemError("coupled axles have no piston; give --angle in degrees, or leave --axles out")
        page = self.page("forces-coupled", COUPLED)
        chosen, described = self._described()
        return CoupledRequest(
            drives=tuple(chosen.drives(described, page.ratios)),
            axles=axles_of(self.axles, self.driven),
            angles=self.angles(page),
            zero=self.zero_angle,
            **self.on_page(page, chosen.examples["forces"]),
        )

    def _engine(self) -> Question:
        """Return what is asked for of the first crank of an engine."""
        from kurbel.engine.request import EngineRequest

        if self.layout_subject in (OVER_PATH, FORCES_OVER_PATH):
            raise ProblemError(
                f"layout {self.layout} is not of an engine; give --angle 's=0..100%:5%' without it, and a"
                " drawing with --over-path has the forces over the path"
            )
        self.refuse("force", *PRESSING, *PINNED)
        page = self.page("machine-forces" if self.is_heavy() else "engine-forces", *OF_ENGINES)
        if self.method == "infinite":
            raise ProblemError("--method infinite is not one of engines; write --ratio 1:∞")
        engines = self.of_page(page)
        if page.subject == ROD_LOAD:
            self.check_whole(page)
            names = self.names("thrust,reversal_angle")
            return EngineRequest(**engines, columns=names, **self.printed())
        angles = self.angles(page, max(self.turn(), FULL_TURN))
        names = self.names("epsilon,delta")
        return EngineRequest(**engines, angles=angles, columns=names, zero=self.zero_angle, **self.printed())

    def _over_path(self, chosen: Mechanism, described: DescribedDrive) -> Question:
        """Return what is asked for of the forces in drives over the piston's path, with their masses."""
        if self.is_heavy() and not chosen.crosshead:
            raise ProblemError(
                f"forces of moving masses are not set over the path for {chosen.title}; print them over the"
                " turn, with --angle in degrees"
            )
        page = self.page("forces-path", FORCES_OVER_PATH, OVER_PATH)
        drives = self.weighed(chosen, chosen.drives(described, page.ratios))
        method = self.method if self.is_heavy() else None
        return self.over_path(chosen, described, page, method, self.pushed(chosen, drives))


forces = function(ForcesOptions, "forces")
