"""What is known of the moving connecting rod at a place, each in units of its own and in metric ones.

Its forces, by the rod itself and by the masses that stand in for it; Ensslin's accelerations of its ends, p₁
of A, p₂ of B and what replaces p₁ beside p₂; forces in A and B for each part of these; Mollier's force.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache
from itertools import product
from operator import attrgetter, methodcaller
from typing import Any, NamedTuple

from kurbel.drive.at import At, known
from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label
from kurbel.kernel.circle import Numeric
from kurbel.kernel.moving import Masses
from kurbel.kernel.parts import COMMON, PARTS, STRETCHING, AccelerationParts, moving_force, parted
from kurbel.kernel.rod import LoadedCrank, magnitude
from kurbel.motion.entries import OF_ROD, Measure, measure_of, measured
from kurbel.motion.evaluation import OFFSET, ROD_MODELS, Needs
from kurbel.page.quantity import Column, Formula, Quantity, Words, words

EXACT = "exact"
ACCELERATION, FORCE, TORQUE, COUPLE = "R ω^2", "M R ω^2", "M R^2 ω^2", "M R L ω^2"
AMOUNT, ALONG, ACROSS = words("Betrag|magnitude"), words("längs|along"), words("quer|across")
# Of a loaded drive; others than the slide's know the same forces by these names.
RodFormula = Callable[[LoadedCrank], Numeric]
Kernel = Callable[[At], Numeric]
# Of the rod in parts of its acceleration, and of such a part or of none.
PartFormula = Callable[..., Any]
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
    unit: Label = FORCE

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


def _force(
    key: str, letter: Label, name: str, formula: RodFormula, shares: Coefficients, unit: Label = FORCE
) -> RodForce:
    return RodForce(key, letter, words(name), formula, formula, shares, shares, unit)


ROD_FORCES: Mapping[str, RodForce] = {
    force.key: force
    for force in (
        _force("guide", "N", "Führungsdruck|Guide force", methodcaller("guide_force"), _GUIDE),
        _force("pin_x", "X", "Zapfenkraft längs|Pin force along", methodcaller("pin_force_along"), _ALONG),
        _force("pin_y", "Y", "Zapfenkraft quer|Pin force across", methodcaller("pin_force_across"), _ACROSS),
        _force("pin", "P", "Zapfenkraft|Pin force", methodcaller("pin_force"), _BOTH)._replace(
            smooth=_pin_square, changes=_CHANGES
        ),
        _force("torque", "M_d", "Drehmoment|Torque", methodcaller("torque"), _TORQUE, TORQUE),
    )
}


def _couple(loaded: LoadedCrank) -> Numeric:
    """-I ψ̈ of the rod about its centre of mass, by its masses at the pins and the couple they lack."""
    pin, crosshead, couple, *_ = loaded.masses
    return (pin * crosshead + couple) * loaded.swing + 0


# The couples of the rod's inertia. They have no share in pages of errors.
ROD_COUPLES = (
    _force("couple", "M_J", "Trägheitspaar der Stange|Inertia couple of the rod", _couple, _GUIDE, COUPLE),
    _force(
        "correction", "ΔM_J", "Ergänzungspaar der zwei Massen|Correction couple of the two masses",
        methodcaller("couple"), _GUIDE, COUPLE,
    ),
)  # fmt: skip


def _resultant(loaded: LoadedCrank) -> Numeric:
    """Return the magnitude of M a_S, that of all forces of the pins and the guide on the rod."""
    return magnitude(loaded.pin_force_along(), loaded.pin_force_across() + loaded.guide_force())


def _arm(loaded: LoadedCrank) -> Numeric:
    """Return how far the line of the inertia force passes by the centre of mass, in L."""
    return abs(_couple(loaded)) / _resultant(loaded)


@cache
def inertia_registry(slide: bool = True) -> Mapping[str, Quantity]:
    """Return every force by every model: inertia_guide, inertia_guide_two_mass, inertia_guide_railway_n; the
    accelerations of which they come, and the forces of each part of these.

    Where B does not slide, p₂ has no direction of its own, and the letter of its force is G, for B is the
    rocker.
    """
    resultants, mollier = (_resultants(), _mollier()) if slide else ((), ())
    found = (*_forces(), *resultants, *_accelerations(slide), *_forces_of_parts(slide), *mollier)
    return {one.key: one for one in found}


def _rod(at: At, model: str = EXACT) -> LoadedCrank:
    """Return the drive at a place with the masses of its rod alone, by a model."""
    return at.bearing(known(at.crank.rod).masses(model, at.numbers.of))


def _in_both(
    key: str,
    letter: str,
    name: Words,
    part: Words,
    kernel: Kernel,
    unit: str = FORCE,
    model: str = EXACT,
    methods: Iterable[str] = (EXACT, "infinite", OFFSET),
) -> tuple[Quantity, Quantity]:
    """Return what is known of a rod by one of its models, in units of its mass and in metric ones.

    What has several models or parts stands under its letter.
    """
    share = Quantity(
        key=key if model == EXACT else f"{key}_{model.replace('-', '_')}",
        name=name,
        symbol=f"${letter}$",
        unit=words(unit.replace("^2", "²")),
        decimals=4,
        formulas=dict.fromkeys(methods, Formula(kernel)),
        spanners=(name, words(f"${letter}/({unit})$")),
        heading=part,
        part=part,
        needs=(Needs.ROD,),
        model=model,
    )
    return share, measured(share)


def _by_model(force: RodForce, model: str = EXACT) -> tuple[Quantity, Quantity]:
    """Return a force by a model. The exact formulas hold for the infinite rod too, and all are of how masses
    are accelerated."""

    def kernel(at: At) -> Numeric:
        return force.formula(_rod(at, model))

    methods, key = (EXACT, "series", "infinite", OFFSET), f"inertia_{force.key}"
    return _in_both(key, force.letter, force.name, ROD_MODELS[model], kernel, force.unit, model, methods)


def _forces() -> Iterator[Quantity]:
    for force in (*ROD_FORCES.values(), *ROD_COUPLES):
        # Two masses lack what they are given in addition.
        for model in (EXACT,) if force.key == "correction" else ROD_MODELS:
            for one in _by_model(force, model):
                yield one._replace(direction=OF_ROD) if force.unit == COUPLE else one


def _resultants() -> Iterator[Quantity]:
    """Yield the inertia force of the rod in one, and the arm of its line."""
    name = "Massenkraft der Stange|Inertia force of the rod"
    yield from _by_model(_force("resultant", "F_S", name, _resultant, _BOTH))
    name = "Hebelarm der Massenkraft|Arm of the inertia force"
    share, sized = _by_model(_force("arm", "h", name, _arm, _BOTH, "L"))
    direction = words(
        "$h$ vom Schwerpunkt der Stange zur Linie ihrer Massenkraft"
        "|$h$ from the rod's centre of mass to the line of its inertia force"
    )
    yield share._replace(needs=(Needs.ARM,), direction=direction)
    # No longer arm than that of a rod that has a length.
    yield sized._replace(needs=(Needs.ARM, Needs.LENGTH, Needs.FINITE), direction=direction)


class Part(NamedTuple):
    """A part of the acceleration of A: its number, name and what its forces are called; its formulas as they
    are printed, by the methods exact, series and infinite and of the offset crank."""

    number: str
    name: Words
    forces: Words
    printed: tuple[str, str, str, str]


_PARTS: Mapping[str, Part] = {
    "common": Part(
        "2", words("gemeinsame Beschleunigung|Common acceleration"), words("1. gemeinsam|1. common"),
        (
            "cos {angle} + λ (cos 2 {angle} + λ^2 sin^4 {angle})/(cos^3 ψ)",
            "cos {angle} + λ cos 2 {angle}", "cos {angle}",
            "cos {angle} - sin {angle} tan ψ + λ (cos^2 {angle})/(cos^3 ψ)",
        ),
    ),
    "turning": Part(
        "4", words("Drehbeschleunigung|Turning acceleration"), words("2. Drehung|2. turning"),
        (
            "((1 - λ^2) sin {angle})/(cos^3 ψ)", "sin {angle}", "sin {angle}",
            "(sin {angle} - λ sin ψ (1 - e/R sin {angle}))/(cos^3 ψ)",
        ),
    ),
    "stretching": Part(
        "5", words("Dehnungsbeschleunigung|Stretching acceleration"), words("3. Dehnung|3. stretching"),
        ("λ (cos^2 {angle})/(cos^2 ψ)", "λ cos^2 {angle}", "0", "λ (cos^2 {angle})/(cos^2 ψ)"),
    ),
}  # fmt: skip
_SUM = words("Summe|sum")
_AXES = (("along", "x", ALONG), ("across", "y", ACROSS))


def _own_parts(slide: bool) -> Mapping[str, Part]:
    """Return the parts that have a direction of their own."""
    return {key: one for key, one in _PARTS.items() if slide or key != COMMON}


def _of_parts(formula: PartFormula, *of: Any) -> Kernel:
    """Return what a formula says of the rod in parts, and of what else it takes."""
    # No zero is to have a sign.
    return lambda at: formula(parted(_rod(at)), *of) + 0


def _component(rod: AccelerationParts, axis: str, vector: PartFormula, *part: str) -> Numeric:
    found: Numeric = getattr(vector(rod, *part), axis)
    return found


def _size(rod: AccelerationParts, vector: PartFormula) -> Numeric:
    found: Numeric = vector(rod).size()
    return found


def _own(rod: AccelerationParts, part: str, mass: Callable[[AccelerationParts, str], Numeric]) -> Numeric:
    """A part's force in its own direction: with X, square to the rod with Y, along the rod with X."""
    if part == STRETCHING:
        return mass(rod, part) * rod.stretching
    return 0 - mass(rod, part) * (rod.common.along if part == COMMON else rod.turning)


# What each part adds to the forces of the drive.
_ADDED: Mapping[str, PartFormula] = {
    "guide": AccelerationParts.guide,
    "pin_x": lambda rod, part: rod.at_pin(part).along,
    "pin_y": lambda rod, part: rod.at_pin(part).across,
    "torque": AccelerationParts.torque,
}


def _joined(one: Words, other: Words) -> Words:
    return {lang: f"{one[lang]}, {other[lang]}" for lang in one}


_VECTORS: tuple[tuple[str, str, Words, PartFormula, PartFormula | None, str], ...] = (
    ("pin_acceleration", "p_1", words("Beschleunigung von A|Acceleration of A"),
     attrgetter("pin"), lambda rod: rod.pin.size(), ""),
    ("common_acceleration", "p_2", _PARTS[COMMON].name, attrgetter("common"), None, ""),
    ("replaced_acceleration", "p_3", words("Ersatzbeschleunigung|Replacing acceleration"),
     AccelerationParts.replaced, AccelerationParts.replaced_size, "$p_3^2 = p_4^2 + p_5^2$"),
)  # fmt: skip


def _accelerations(slide: bool) -> Iterator[Quantity]:
    """Yield the accelerations, those that other pages have had first."""
    own = [_acceleration(key, one) for key, one in _own_parts(slide).items()]
    yield from own
    for key, letter, name, vector, amount, line in _VECTORS:
        if amount is not None:
            share, _ = _in_both(key, letter, name, AMOUNT, _of_parts(amount), ACCELERATION)
            yield from _printed(share, dict.fromkeys(share.formulas, line))
        for axis, mark, said in _AXES:
            kernel = _of_parts(_component, axis, vector)
            yield from _in_both(f"{key}_{axis}", f"{letter}^{mark}", name, said, kernel, ACCELERATION)
    yield from map(measured, own)


def _acceleration(key: str, part: Part) -> Quantity:
    """A part that p₁ is made of, by any method."""
    kernel, letter = _of_parts(attrgetter("common.along" if key == COMMON else key)), f"p_{part.number}"
    share, _ = _in_both(f"{key}_acceleration", letter, part.name, words("genau|exact"), kernel, ACCELERATION)
    lines = (f"${letter}/({ACCELERATION}) = {line}$" for line in part.printed)
    methods = (EXACT, "series", "infinite", OFFSET)
    return _printed(share, dict(zip(methods, lines, strict=True)))[0]


def _printed(share: Quantity, lines: Mapping[str, str]) -> tuple[Quantity, Quantity]:
    """Return a quantity with its formulas as pages print them, by the methods that it has."""
    formula = share.formulas[EXACT]
    own = share._replace(formulas={key: formula._replace(printed=line) for key, line in lines.items()})
    return own, measured(own)


def _forces_of_parts(slide: bool) -> Iterator[Quantity]:
    """Yield the forces in A and B: of each part in its own direction, then along and across the slide; then
    what each part adds to the forces of the drive. Parts of first order do not add up to p₁."""
    for end, letter, vector, mass in (
        ("a", "A", AccelerationParts.in_pin, AccelerationParts.mass_in_pin),
        (
            "b", "B" if slide else "G",
            AccelerationParts.in_crosshead, AccelerationParts.mass_in_crosshead,
        ),
    ):  # fmt: skip
        name, stem = words(f"Kraft in {letter}|Force in {letter}"), f"inertia_{end}"
        for key, one in _own_parts(slide).items():
            kernel = _of_parts(_own, key, mass)
            yield from _in_both(f"{stem}_{key}", f"{letter}_{one.number}", name, one.forces, kernel)
        # Nothing in B stretches the rod.
        for key in (*PARTS[: 3 if end == "a" else 2], ""):
            before, of = f"{stem}_{key}" if key else stem, f"{_PARTS[key].number}^" if key else ""
            for axis, mark, said in _AXES:
                apart = _joined(_PARTS[key].forces if key else _SUM, said)
                kernel = _of_parts(_component, axis, vector, key)
                yield from _in_both(f"{before}_{mark}", f"{letter}_{of}{mark}", name, apart, kernel)
        kernel = _of_parts(_size, vector)
        yield from _in_both(stem, letter, name, _joined(_SUM, AMOUNT), kernel)
    for key, formula in _ADDED.items():
        force = ROD_FORCES[key]
        for part, one in _PARTS.items():
            letter, kernel = f"{force.letter[0]}_{one.number}", _of_parts(formula, part)
            yield from _in_both(f"inertia_{key}_{part}", letter, force.name, one.forces, kernel, force.unit)


def _mollier() -> Iterator[Quantity]:
    """Yield Mollier's force by every model of the rod."""
    name = words("Kraft am Kreuzkopf nach Mollier|Force at the crosshead after Mollier")
    for model, said in ROD_MODELS.items():
        for one in _in_both("inertia_mollier", "H", name, said, _moving(model), model=model):
            yield one._replace(needs=(*one.needs, Needs.EVEN))


def _moving(model: str) -> Kernel:
    def moving(at: At) -> Numeric:
        drive = _rod(at, model)
        if model == EXACT and known(at.crank.rod).couple:
            return _without_warning(drive)
        # Two masses have no poles, which nothing times something boundless would hide.
        return drive.masses.crosshead * drive.acceleration

    return moving


def _without_warning(drive: LoadedCrank) -> Numeric:
    """Return the force; in arrays what is boundless is infinite, as `kurbel.compute` says of it."""
    drive_at = (drive.circle, drive.ratio, drive.masses, drive.offset)
    if drive.offset is None or not hasattr(drive.circle.sine, "dtype"):
        return moving_force(*drive_at)
    import numpy as np

    with np.errstate(divide="ignore", invalid="ignore"):
        return moving_force(*drive_at)


def has_poles(quantity: Quantity, crank: Crank) -> bool:
    """Whether a quantity grows beyond all bounds, so that no float of it has a bound of its own."""
    return bool(
        Needs.EVEN in quantity.needs and quantity.model == EXACT and crank.offset and known(crank.rod).couple
    )


# Angles with rational sines.
_SINES: dict[int, Fraction | int] = {0: 0, 30: Fraction(1, 2), 90: 1, 150: Fraction(1, 2), 180: 0}
_SINES |= {180 + angle: -sine for angle, sine in _SINES.items()}


def check_poles(columns: Iterable[Column], cranks: Iterable[Crank], angles: Collection[Fraction]) -> None:
    """Raise ProblemError where Mollier's force is asked for at a dead centre of an offset crank, for the rod
    turns there while the crosshead rests."""
    boundless = [(one.key, crank) for one in columns for crank in cranks if has_poles(one.quantity, crank)]
    for (key, crank), angle in product(boundless, angles if boundless else ()):
        if _rests(crank, angle % 360):
            raise ProblemError(
                f"at {angle}° this offset crank stands at a dead centre, where no force at the crosshead"
                f" moves the rod; leave the angle out, or the column {key}"
            )


def _rests(crank: Crank, angle: Fraction) -> bool:
    ratio, sine = crank.ratio, _SINES.get(int(angle)) if angle.denominator == 1 else None
    beyond = 90 <= angle <= 270
    return sine is not None and sine == crank.offset * ratio / (ratio - 1 if beyond else ratio + 1)
