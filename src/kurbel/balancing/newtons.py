"""Free forces in newtons and moments in newton metres: what mass, radius, speed and spacing make of them.

Along its slide a rod is exactly two masses at its pins that keep its centre of mass (Ensslin): to and fro
goes the share at the crosshead pin, and that at the crank pin turns.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from kurbel.balancing.arrangement import Arrangement
from kurbel.balancing.vector import pin_acceleration
from kurbel.drive.at import known
from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, figure
from kurbel.exact.real import Real
from kurbel.motion.notes import moving_notes, turns_label
from kurbel.page.quantity import Words, words
from kurbel.reading.amounts import Units, amount, digits, unit_of_page
from kurbel.reading.notation import about

IN_NEWTONS = "_n"
WORDS: Mapping[str, Words] = {
    "rod": words(
        " mit dem Teil der Schubstange am Kreuzkopfzapfen| with the rod's share at the crosshead pin"
    ),
    "each": words("Hin- und hergehende Massen: {masses}{rod}|Reciprocating masses: {masses}{rod}"),
    "revolving": words(
        "Umlaufende Massen am Kurbelhalbmesser: {masses}, davon ausgeglichen der Teil {share}"
        "|Revolving masses at the crank radius: {masses}, of which the share {share} is balanced"
    ),
    "counterweights": words(
        "Gegengewichte der Kurbel gegenüber, Masse mal Halbmesser in {unit}: {moments}"
        "|Counterweights opposite the crank, mass times radius in {unit}: {moments}"
    ),
    "at_radius": words("; am Halbmesser {radius}: {masses}|; at the radius {radius}: {masses}"),
}


@dataclass(frozen=True, slots=True)
class Weighed:
    """The crank of a cylinder with its masses, its radius and the speed; `spacing` is the unit of length
    of the positions in metres, None where it is not known.

    `each` are the masses in kg that go to and fro in the cylinders where these are not alike, and
    `revolving` those that turn with the cranks at their radius, where they are not balanced apart.
    Counterweights balance the share of the arrangement of the first and `revolving_share` of the second.
    """

    crank: Crank
    spacing: Fraction | None = None
    each: tuple[Fraction, ...] = ()
    revolving: tuple[Fraction, ...] = ()
    revolving_share: Fraction = Fraction(0)
    balance_radius: Fraction | None = None
    # Those of the page, None of one in newtons.
    units: Units | None = None

    def __post_init__(self) -> None:
        if self.spacing is not None and self.spacing <= 0:
            raise ProblemError(
                f"the spacing of the cranks is {about(self.spacing)} m; it must be above 0, for it is the"
                " unit of the positions"
            )
        if not self.mass:
            raise ProblemError(
                "no mass goes to and fro; add that of piston and crosshead, --reciprocating 300kg"
            )

    @property
    def mass(self) -> Fraction:
        """m in kg, what goes to and fro in a cylinder."""
        return Fraction(known(self.crank.moving).joined.crosshead)

    def knows(self, residual: str) -> bool:
        """Whether the unit of this residual is known."""
        return residual == "force" or self.spacing is not None

    def scale(self, residual: str) -> Real:
        """Return the unit m R ω² of a residual in newtons, of a moment in newton metres."""
        return pin_acceleration(self.crank) * (self.mass * self._arm(residual))

    def _arm(self, residual: str) -> Fraction:
        """Return by what a force in newtons becomes one in the unit of the page, or a moment."""
        arm, unit = (Fraction(1), "N") if residual == "force" else (known(self.spacing), "N m")
        return arm if self.units is None else arm * self.units.times(unit)

    def on(self, arrangement: Arrangement) -> Arrangement:
        """Return the arrangement with the masses of its cylinders, in units of m."""
        count = len(arrangement.cylinders)
        each, revolving = self.each or (self.mass,) * count, self._turning(count)
        for what, masses in (("reciprocating", each), ("revolving", revolving)):
            if len(masses) != count:
                raise ProblemError(
                    f"the number of {what} masses is {len(masses)} and that of cylinders {count}; give"
                    " one for each, or one for all"
                )
        free = 1 - self.revolving_share
        return replace(
            arrangement,
            cylinders=tuple(
                one._replace(mass=mass / self.mass, revolving=free * turning / self.mass)
                for one, mass, turning in zip(arrangement.cylinders, each, revolving, strict=True)
            ),
        )

    def _turning(self, count: int) -> tuple[Fraction, ...]:
        """Return the masses that turn with the cranks, of one that is given for all of them."""
        given = self.revolving or (Fraction(0),)
        return given * count if len(given) == 1 else given

    def counterweights(self, arrangement: Arrangement) -> tuple[Fraction, ...]:
        """Return mass times radius of the counterweights opposite the cranks, in kg m."""
        revolving, radius = self._turning(len(arrangement.cylinders)), known(self.crank.radius)
        return tuple(
            (arrangement.share * one.mass * self.mass + self.revolving_share * turning) * radius
            for one, turning in zip(arrangement.cylinders, revolving, strict=True)
        )

    def notes(
        self, arrangement: Arrangement, ratio_symbol: str, lang: str, metres: bool = False
    ) -> Iterator[Label]:
        """Yield the lines about masses, size and speed; positions in metres need no unit of their own."""
        if not self.each:
            yield from moving_notes(self.crank, ratio_symbol, lang)
        rod = WORDS["rod"][lang] if known(self.crank.moving).rod is not None else ""
        spacing = "" if self.spacing is None or metres else f"$a = {amount(self.spacing, 'mm')}$"
        if self.each:
            size = f"${ratio_symbol[0]} = {amount(known(self.crank.radius), 'mm')}$"
            yield WORDS["each"][lang].format(masses=_listed(self.each), rod=rod)
            yield ", ".join(filter(None, (size, turns_label(known(self.crank.speed)), spacing)))
        else:
            yield ", ".join(filter(None, (f"$m = {amount(self.mass, 'kg')}${rod}", spacing)))
        if self.revolving:
            yield WORDS["revolving"][lang].format(
                masses=_listed(self.revolving), share=f"${figure(self.revolving_share)}$"
            )
        told = self.revolving or self.balance_radius is not None
        if told and any(weights := self.counterweights(arrangement)):
            times, unit = unit_of_page("kg m")
            moments = "; ".join(f"${digits(one, times)}$" for one in dict.fromkeys(weights))
            said = WORDS["counterweights"][lang].format(unit=f"${unit}$", moments=moments)
            yield said + self._at_radius(weights, lang)

    def _at_radius(self, weights: Sequence[Fraction], lang: str) -> Label:
        if self.balance_radius is None:
            return ""
        masses = [one / self.balance_radius for one in weights]
        return WORDS["at_radius"][lang].format(
            radius=f"${amount(self.balance_radius, 'mm')}$", masses=_listed(masses)
        )


def _listed(masses: Sequence[Fraction]) -> Label:
    """Return masses in kg in a row, once where all are alike."""
    shown = masses[:1] if len(set(masses)) == 1 else masses
    return "; ".join(f"${amount(one, 'kg')}$" for one in shown)
