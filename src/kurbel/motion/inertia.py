"""Forces of the moving connecting rod, each by the rod itself and by the masses that stand in for it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache
from operator import methodcaller
from typing import NamedTuple

from kurbel.drive.at import At, known
from kurbel.exact.numerals import Label
from kurbel.kernel.circle import Numeric
from kurbel.kernel.moving import Masses
from kurbel.kernel.rod import LoadedCrank, magnitude
from kurbel.motion.entries import OF_ROD, Measure, measure_of, measured
from kurbel.motion.evaluation import OFFSET, ROD_MODELS, Needs
from kurbel.motion.rod_accelerations import acceleration_entries
from kurbel.motion.rod_forces import TORQUE, UNIT, held, mollier_entries, part_entries
from kurbel.page.quantity import Formula, Quantity, Words, words

COUPLE = "M R L ω^2"
# Of a loaded drive; others than the slide's know the same forces by these names.
RodFormula = Callable[[LoadedCrank], Numeric]
Coefficients = Callable[[Masses[Fraction], bool], Sequence[Fraction | int]]


class RodForce(NamedTuple):
    """A force of the rod, or its torque. `formula` takes the drive with its masses.

    `smooth` is greatest where the force's magnitude is, or least, and has slopes throughout: the force
    itself or its square. Of given masses and a rod that is infinite or not, the force is zero throughout if
    its `coefficients` are, and only then: each multiplies a function of the angle that no sum of the others
    makes up. It has one magnitude throughout if its `changes` are zero.
    """

    key: str
    letter: Label
    name: Words
    formula: RodFormula
    smooth: RodFormula
    coefficients: Coefficients
    changes: Coefficients
    unit: Label = UNIT

    @property
    def measure(self) -> Measure:
        """What the rod's mass makes of the unit."""
        return measure_of(self.unit)


def _pin_square(loaded: LoadedCrank) -> Numeric:
    along, across = loaded.pin_force_along(), loaded.pin_force_across()
    return along * along + across * across


def _shares(
    finite: Callable[[Masses[Fraction]], Sequence[Fraction | int]],
    infinite: Callable[[Masses[Fraction]], Sequence[Fraction | int]],
) -> Coefficients:
    return lambda masses, endless: (infinite if endless else finite)(masses)


_ALONG = _shares(lambda one: one[:2], lambda one: (one.pin + one.crosshead,))
_ACROSS = _shares(lambda one: one, lambda one: (one.pin + one.couple,))
_GUIDE = _shares(lambda one: one[1:], lambda one: (one.couple,))
_TORQUE = _shares(lambda one: one[1:], lambda one: (one.crosshead - one.couple,))
_BOTH = _shares(lambda one: (*one[:2], *one), lambda one: (one.pin + one.crosshead, one.pin + one.couple))
# A mass that only rotates presses alike everywhere, and so do equal amplitudes of sine and cosine.
_CHANGES = _shares(
    lambda one: one[1:], lambda one: ((one.pin + one.crosshead) ** 2 - (one.pin + one.couple) ** 2,)
)


def _force(key: str, letter: Label, name: str, formula: RodFormula, shares: Coefficients) -> RodForce:
    return RodForce(key, letter, words(name), formula, formula, shares, shares)


ROD_FORCES: Mapping[str, RodForce] = {
    force.key: force
    for force in (
        _force("guide", "N", "Führungsdruck|Guide force", methodcaller("guide_force"), _GUIDE),
        _force("pin_x", "X", "Zapfenkraft längs|Pin force along", methodcaller("pin_force_along"), _ALONG),
        _force("pin_y", "Y", "Zapfenkraft quer|Pin force across", methodcaller("pin_force_across"), _ACROSS),
        RodForce(
            "pin",
            "P",
            words("Zapfenkraft|Pin force"),
            methodcaller("pin_force"),
            _pin_square,
            _BOTH,
            _CHANGES,
        ),
        _force("torque", "M_d", "Drehmoment|Torque", methodcaller("torque"), _TORQUE)._replace(unit=TORQUE),
    )
}


def _couple(loaded: LoadedCrank) -> Numeric:
    """-I ψ̈ of the rod about its centre of mass, by its masses at the pins and the couple they lack."""
    pin, crosshead, couple, *_ = loaded.masses
    return (pin * crosshead + couple) * loaded.swing + 0


# The couples of the rod's inertia. They have no share in pages of errors.
ROD_COUPLES: Mapping[str, RodForce] = {
    key: _force(key, letter, name, formula, _GUIDE)._replace(unit=COUPLE)
    for key, letter, name, formula in (
        ("couple", "M_J", "Trägheitspaar der Stange|Inertia couple of the rod", _couple),
        (
            "correction", "ΔM_J", "Ergänzungspaar der zwei Massen|Correction couple of the two masses",
            methodcaller("couple"),
        ),
    )
}  # fmt: skip


def _resultant(loaded: LoadedCrank) -> Numeric:
    """Return the magnitude of M a_S, that of all forces of the pins and the guide on the rod."""
    return magnitude(loaded.pin_force_along(), loaded.pin_force_across() + loaded.guide_force())


def _arm(loaded: LoadedCrank) -> Numeric:
    """Return how far the line of the inertia force passes by the centre of mass, in L."""
    return abs(_couple(loaded)) / _resultant(loaded)


def _resultant_entries() -> Iterator[Quantity]:
    """Yield the inertia force of the rod in one, and the arm of its line."""
    name = words("Massenkraft der Stange|Inertia force of the rod")
    force = RodForce("resultant", "F_S", name, _resultant, _resultant, _BOTH, _BOTH)
    yield from _entries(force, "exact", _of_slide(force, "exact"))
    name = words("Hebelarm der Massenkraft|Arm of the inertia force")
    arm = _entry("inertia_arm", "h", name, "L", "exact", _of_slide(force._replace(formula=_arm), "exact"))
    arm = arm._replace(needs=(Needs.ARM,), direction=words(
        "$h$ vom Schwerpunkt der Stange zur Linie ihrer Massenkraft"
        "|$h$ from the rod's centre of mass to the line of its inertia force"
    ))  # fmt: skip
    # No longer arm than that of a rod that has a length.
    sized = measured(arm)
    yield from (arm, sized._replace(needs=(*arm.needs, Needs.LENGTH, Needs.FINITE)))


@cache
def inertia_registry() -> Mapping[str, Quantity]:
    """Return every force by every model: inertia_guide, inertia_guide_two_mass, inertia_guide_railway_n; the
    parts of the acceleration, of which they come, and the forces of these."""
    parts = (*acceleration_entries(), *part_entries(held), *mollier_entries(ROD_MODELS))
    return {one.key: one for one in (*rod_entries(_of_slide), *_resultant_entries(), *parts)}


def _of_slide(force: RodForce, model: str) -> Callable[[At], Numeric]:
    def kernel(at: At) -> Numeric:
        masses = known(at.crank.rod).masses(model, at.numbers.of)
        return force.formula(LoadedCrank(at.circle, at.ratio, masses, at.offset, by=at.by))

    return kernel


def rod_entries(kernel_of: Callable[[RodForce, str], Callable[[At], Numeric]]) -> Iterator[Quantity]:
    """Yield every force by every model, by the kernel calls of a drive."""
    for force in (*ROD_FORCES.values(), *ROD_COUPLES.values()):
        # Two masses lack what they are given in addition.
        for model in ("exact",) if force.key == "correction" else ROD_MODELS:
            yield from _entries(force, model, kernel_of(force, model))


def _entries(force: RodForce, model: str, kernel: Callable[[At], Numeric]) -> Iterator[Quantity]:
    """Yield the force by a model in units of the rod's mass, and in newtons."""
    key = f"inertia_{force.key}" + ("" if model == "exact" else f"_{model.replace('-', '_')}")
    share = _entry(key, force.letter, force.name, force.unit, model, kernel)
    if force.unit == COUPLE:
        share = share._replace(direction=OF_ROD)
    yield from (share, measured(share))


def _entry(
    key: str, letter: str, name: Words, unit: Label, model: str, kernel: Callable[[At], Numeric]
) -> Quantity:
    return Quantity(
        key=key,
        name=name,
        symbol=f"${letter}$",
        unit=words(unit.replace("^2", "²")),
        decimals=4,
        # The exact formulas hold for the infinite rod too, and all are of how masses are accelerated.
        formulas=dict.fromkeys(("exact", "series", "infinite", OFFSET), Formula(kernel)),
        # One force by several models stands under its letter.
        spanners=(name, words(f"${letter}/({unit})$")),
        heading=ROD_MODELS[model],
        part=ROD_MODELS[model],
        needs=(Needs.ROD,),
        model=model,
    )
