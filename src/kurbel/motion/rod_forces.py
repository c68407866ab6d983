"""The forces of the rod in A and in B for each part of its acceleration, and Mollier's along the slide."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from fractions import Fraction
from functools import partial
from itertools import product
from typing import NamedTuple

from kurbel.drive.at import At, known
from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.kernel.circle import Numeric
from kurbel.kernel.parts import AccelerationParts, moving_force, parted
from kurbel.kernel.rod import LoadedCrank, Parts, Vector
from kurbel.motion.entries import measured
from kurbel.motion.evaluation import OFFSET, Needs
from kurbel.motion.rod_accelerations import ACROSS, ALONG, entry_of_rod
from kurbel.page.quantity import Column, Formula, Need, Quantity, Words, words

COMMON, TURNING, STRETCHING = PARTS = Parts._fields
EXACT = "exact"
UNIT, TORQUE = "M R ω^2", "M R^2 ω^2"
# The accelerations of which the parts are.
NUMBERS: Mapping[str, str] = {COMMON: "2", TURNING: "4", STRETCHING: "5"}
NAMES: Mapping[str, Words] = {
    COMMON: words("1. gemeinsam|1. common"),
    TURNING: words("2. Drehung|2. turning"),
    STRETCHING: words("3. Dehnung|3. stretching"),
    "": words("Summe|sum"),
}
_IN = "Kraft in {0}|Force in {0}"

# Of the rod at a place, in parts.
Kernel = Callable[[AccelerationParts], Numeric]


class Share(NamedTuple):
    """A force of the rod for a part of its acceleration: key, letter, name, what sets it apart, formula."""

    key: str
    letter: str
    name: Words
    part: Words
    kernel: Kernel
    unit: str = UNIT


def _joined(one: Words, other: Words) -> Words:
    return {lang: f"{one[lang]}, {other[lang]}" for lang in one}


def _ends(slide: bool) -> Iterator[Share]:
    """Yield the forces in A and B: of each part in its own direction, then along and across the slide.

    Where B does not slide, p₂ has no direction of its own, and its letter is G, for B is the rocker.
    """
    for key, letter in (("a", "A"), ("b", "B" if slide else "G")):
        name = words(_IN.format(letter))
        for part in PARTS if slide else (TURNING, STRETCHING):
            yield Share(
                f"inertia_{key}_{part}", f"{letter}_{NUMBERS[part]}", name, NAMES[part], _own(key, part)
            )
        for part in PARTS if key == "a" else (COMMON, TURNING):
            yield from _components(key, letter, name, part)
        yield from _components(key, letter, name, "")
        yield Share(
            f"inertia_{key}", letter, name, _joined(NAMES[""], words("Betrag|magnitude")), _amount(key)
        )


def _components(key: str, letter: str, name: Words, part: str) -> Iterator[Share]:
    stem, number = (f"inertia_{key}_{part}", NUMBERS[part]) if part else (f"inertia_{key}", "")
    for index, mark, said in ((0, "x", ALONG), (1, "y", ACROSS)):
        of = f"{letter}_{number}^{mark}" if number else f"{letter}_{mark}"
        yield Share(f"{stem}_{mark}", of, name, _joined(NAMES[part], said), _component(key, part, index))


def _end(key: str, rod: AccelerationParts, part: str = "") -> Vector[Numeric]:
    return rod.in_pin(part) if key == "a" else rod.in_crosshead(part)


def _own(key: str, part: str) -> Kernel:
    """A part's force in its own direction: with X, square to the rod with Y, along the rod with X."""

    def kernel(rod: AccelerationParts) -> Numeric:
        mass = rod.mass_in_pin(part) if key == "a" else rod.mass_in_crosshead(part)
        if part == STRETCHING:
            return mass * rod.stretching + 0
        return 0 - mass * (rod.common.along if part == COMMON else rod.turning)

    return kernel


def _component(key: str, part: str, index: int) -> Kernel:
    return lambda rod: _end(key, rod, part)[index] + 0


def _amount(key: str) -> Kernel:
    return lambda rod: _end(key, rod).size()


def _drive() -> Iterator[Share]:
    """Yield what each part adds to the forces of the drive."""
    for key, letter, name, formula, unit in (
        ("guide", "N", "Führungsdruck|Guide force", lambda rod, part: rod.guide(part), UNIT),
        ("pin_x", "X", "Zapfenkraft längs|Pin force along", lambda rod, part: rod.at_pin(part).along, UNIT),
        ("pin_y", "Y", "Zapfenkraft quer|Pin force across", lambda rod, part: rod.at_pin(part).across, UNIT),
        ("torque", "M", "Drehmoment|Torque", lambda rod, part: rod.torque(part), TORQUE),
    ):
        for part in PARTS:
            kernel = partial(formula, part=part)
            yield Share(
                f"inertia_{key}_{part}", f"{letter}_{NUMBERS[part]}", words(name), NAMES[part], kernel, unit
            )


def part_entries(parted_of: Callable[[At], AccelerationParts], slide: bool = True) -> Iterator[Quantity]:
    """Yield every force of a part in units of the rod's mass and in newtons, of the rod at a place."""
    for share in (*_ends(slide), *_drive()):
        yield from _in_both_units(_entry(share, _of_rod(share.kernel, parted_of), EXACT))


def _of_rod(kernel: Kernel, parted_of: Callable[[At], AccelerationParts]) -> Callable[[At], Numeric]:
    return lambda at: kernel(parted_of(at))


def held(at: At) -> AccelerationParts:
    """Return the rod between crank and crosshead at a place, with its masses."""
    masses = known(at.crank.rod).masses(EXACT, at.numbers.of)
    return parted(LoadedCrank(at.circle, at.ratio, masses, at.offset, by=at.by))


def mollier_entries(models: Mapping[str, Words]) -> Iterator[Quantity]:
    """Yield Mollier's force by every model of the rod."""
    name = words("Kraft am Kreuzkopf nach Mollier|Force at the crosshead after Mollier")
    for model, said in models.items():
        key = "inertia_mollier" + ("" if model == EXACT else f"_{model.replace('-', '_')}")
        share = Share(key, "H", name, said, lambda _: 0)
        yield from _in_both_units(_entry(share, _moving(model), model), Needs.EVEN)


def _moving(model: str) -> Callable[[At], Numeric]:
    def moving(at: At) -> Numeric:
        rod = known(at.crank.rod)
        masses = rod.masses(model, at.numbers.of)
        if model == EXACT and rod.couple:
            return _without_warning(lambda: moving_force(at.circle, at.ratio, masses, at.offset), at)
        # Two masses have no poles, which nothing times something boundless would hide.
        return masses.crosshead * at.by.piston(at.circle, at.ratio, at.offset)

    return moving


def _without_warning(force: Callable[[], Numeric], at: At) -> Numeric:
    """Return the force; in arrays what is boundless is infinite, as `kurbel.compute` says of it."""
    if at.offset is None or not hasattr(at.circle.sine, "dtype"):
        return force()
    import numpy as np

    with np.errstate(divide="ignore", invalid="ignore"):
        return force()


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


def _entry(share: Share, kernel: Callable[[At], Numeric], model: str) -> Quantity:
    # Parts of first order do not add up to p₁.
    formulas = dict.fromkeys(("exact", "infinite", OFFSET), Formula(kernel))
    return entry_of_rod(share.key, share.letter, share.name, share.part, formulas, share.unit, model)


def _in_both_units(share: Quantity, *needs: Need) -> Iterator[Quantity]:
    own = share._replace(needs=(Needs.ROD, *needs))
    yield from (own, measured(own))
