"""The dead centres of a crank drive, or of a beam engine by the formulas of the books."""

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from kurbel.commands.options import Columns, Option, flag, measure
from kurbel.commands.part import CommandOptions
from kurbel.commands.parts.drive import Linked, Speed
from kurbel.commands.parts.sheet import Layouts, Sheet, columns_option, layout_option
from kurbel.commands.subject import function
from kurbel.drive.crank import Described
from kurbel.errors import ProblemError
from kurbel.page.subject import Question
from kurbel.reading.given import as_numbers

BEAM, DRIVE = "dead centres", "drive dead centres"
_OF_DRIVES = ("mechanism", "offset", "rocker", "pivot", "circuit", "speed")
_LENGTHS = ("stroke", "rod")


class DeadCentresOptions(Linked, Speed, Layouts, Sheet, CommandOptions):
    """Print the dead centres of a beam engine: angles μ and ν of the rod, their distance, the small paths.

    Of another crank drive that is described: its dead centres, stroke and times, and with --stroke and
    --speed the crank-pin velocity and the mean piston speed.

    \b
    kurbel deadcentres --beam 3 --ratio 1:5
    kurbel deadcentres --beam 3 --ratio 1:5 --exact
    kurbel deadcentres --mechanism arc --ratio 1:5 --rocker 6
    kurbel deadcentres --ratio 1:4 --offset 0.5 --stroke 600mm --speed 120/min
    \f
    >>> import kurbel
    >>> page = kurbel.deadcentres(3, ratio="1:5", columns="mu,path_1")
    >>> print(kurbel.typeset(page, "csv"), end="")
    mu,path_1
    0.7958,0.00010
    >>> page = kurbel.deadcentres(ratio="1:4", offset=0.5, columns="phi_i,phi_o,time_ratio")
    >>> print(kurbel.typeset(page, "csv"), end="")
    phi_i,phi_o,time_ratio
    5.739,189.594,1.0438
    """

    unnamed = "beam"
    sequence = (
        "ratio exact mechanism offset rocker pivot circuit stroke crank true_stroke time_ratio rod speed"
        " columns"
    )

    beam: Option[Sequence[Fraction] | None] = measure(
        as_numbers, "Arm of the beam in crank radii: 3; lists '3;4', ranges 3..6:0.5.", "A:R", many=True,
        what="beam arm",
    )  # fmt: skip
    ratio = Linked.ratio.but(help="Crank ratio: 1:5; lists and ranges 1:3..6.")
    exact = flag("From the true geometry of the linkage; default: the formulas of § 149.")
    speed = Speed.speed.but(help="Speed, for columns in m/s: 120/min, 12.5rad/s.")
    columns = columns_option("weisbach-149", "mu,nu,path_1", ".").but(
        kind=Columns("weisbach-149", "dead-centres")
    )
    layout = layout_option(BEAM, DRIVE)

    def question(self) -> Question:
        if self._of_beam():
            return self._beam()
        from kurbel.linkage.dead_centres import DeadCentresRequest, drives_of

        page = self.page("dead-centres", DRIVE)
        arm = self._arm() if "beam" in self.drive().takes else None
        drive = Linked(self.values.instead({"beam": arm}))
        chosen, described = drive.described(beside=("stroke", "speed"))
        return DeadCentresRequest(
            layout=page,
            mechanism=chosen.name,
            drives=drives_of(chosen, described, page.ratios),
            columns=self.names("phi_i,phi_o"),
            **self.printed(),
        )

    def _of_beam(self) -> bool:
        """Whether dead centres are those of a beam engine, and not of a crank drive that is described."""
        if self.layout:
            return self.page("", BEAM, DRIVE).subject == BEAM
        if self.says("mechanism"):
            return False
        return self.says("beam", "exact") or not self.says(*_OF_DRIVES, *_LENGTHS)

    def _beam(self) -> Question:
        from kurbel.linkage.beam.page import BeamRequest

        page = self.page("weisbach-149", BEAM)
        known = all(map(self.says, _LENGTHS))
        lengths = map(self.raw, _LENGTHS) if known else ()
        return BeamRequest(
            layout=page,
            arms=as_numbers(page.arms, "beam arm") if self.beam is None else tuple(self.beam),
            ratios=tuple(one.ratio for one in Described(self.ratio, *lengths).cranks(page.ratios)),
            exact=self.exact,
            columns=self.names("mu,nu"),
            **self.printed(),
        )

    def _arm(self) -> Fraction | None:
        """Return the arm of a beam engine that is described as a crank drive."""
        first, *others = self.beam or (None,)
        if others:
            raise ProblemError(
                f"--mechanism beam is one engine, and {1 + len(others)} arms were given; leave --mechanism"
                " out for the angles of § 149"
            )
        return first

    def unread(self, option: Option[Any]) -> str:
        name = option.name
        if not self._of_beam():
            of_beam = name in ("beam", "exact")
            why = "is for the beam engine, and a crank drive was described; leave one of the two out"
            return f"--{name} {why}" if of_beam else super().unread(option)
        if name in _OF_DRIVES:
            return (
                f"--{name} does not belong to the beam engine; leave --beam and --exact out for a crank drive"
            )
        return (
            f"--{name} gives the ratio of the beam engine only where both are known, --stroke and --rod;"
            " add the other"
        )


deadcentres = function(DeadCentresOptions, "deadcentres")
