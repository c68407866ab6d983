"""Ensslin's accelerations of the rod's ends: p₁ of A, p₂ of B, and what replaces p₁ beside p₂."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

from kurbel.drive.at import At
from kurbel.kernel.circle import Numeric
from kurbel.kernel.moving import Masses
from kurbel.kernel.parts import AccelerationParts, parted
from kurbel.kernel.rod import LoadedCrank, Vector
from kurbel.motion.entries import measured
from kurbel.motion.evaluation import OFFSET, Needs
from kurbel.page.quantity import Formula, Quantity, Words, words

UNIT = "R ω^2"
EXACT = words("genau|exact")
NOTHING: Masses[int] = Masses(0, 0)


class Part(NamedTuple):
    """A part of the acceleration of A: key of `rod.Parts`, letter, name, and its formula by each method."""

    key: str
    letter: str
    name: Words
    printed: Mapping[str, str]


def _formulas(exact: str, series: str, infinite: str, offset: str) -> Mapping[str, str]:
    return {"exact": exact, "series": series, "infinite": infinite, OFFSET: offset}


PARTS = (
    Part(
        "common", "p_2", words("gemeinsame Beschleunigung|Common acceleration"),
        _formulas(
            "cos {angle} + λ (cos 2 {angle} + λ^2 sin^4 {angle})/(cos^3 ψ)",
            "cos {angle} + λ cos 2 {angle}", "cos {angle}",
            "cos {angle} - sin {angle} tan ψ + λ (cos^2 {angle})/(cos^3 ψ)",
        ),
    ),
    Part(
        "turning", "p_4", words("Drehbeschleunigung|Turning acceleration"),
        _formulas(
            "((1 - λ^2) sin {angle})/(cos^3 ψ)", "sin {angle}", "sin {angle}",
            "(sin {angle} - λ sin ψ (1 - e/R sin {angle}))/(cos^3 ψ)",
        ),
    ),
    Part(
        "stretching", "p_5", words("Dehnungsbeschleunigung|Stretching acceleration"),
        _formulas("λ (cos^2 {angle})/(cos^2 ψ)", "λ cos^2 {angle}", "0", "λ (cos^2 {angle})/(cos^2 ψ)"),
    ),
)  # fmt: skip


class Component(NamedTuple):
    """What else is shown of an acceleration: the end of its key, its sign in letters, its name."""

    end: str
    mark: str
    part: Words
    kernel: Callable[[AccelerationParts], Numeric]


OF_A, REPLACING = (
    words("Beschleunigung von A|Acceleration of A"),
    words("Ersatzbeschleunigung|Replacing acceleration"),
)
AMOUNT, ALONG, ACROSS = words("Betrag|magnitude"), words("längs|along"), words("quer|across")


def _components(of: Callable[[AccelerationParts], Vector[Numeric]]) -> tuple[Component, Component]:
    return (
        Component("_along", "^x", ALONG, lambda rod: of(rod).along),
        Component("_across", "^y", ACROSS, lambda rod: of(rod).across),
    )


COMMON, *_ = PARTS
_OTHERS: tuple[tuple[str, str, Words, str, tuple[Component, ...]], ...] = (
    (
        "pin_acceleration", "p_1", OF_A, "",
        (Component("", "", AMOUNT, lambda rod: rod.pin.size()), *_components(lambda rod: rod.pin)),
    ),
    ("common_acceleration", "p_2", COMMON.name, "", _components(lambda rod: rod.common)),
    (
        "replaced_acceleration", "p_3", REPLACING, "$p_3^2 = p_4^2 + p_5^2$",
        (
            Component("", "", AMOUNT, lambda rod: rod.replaced_size()),
            *_components(lambda rod: rod.replaced()),
        ),
    ),
)  # fmt: skip


def moved(at: At) -> AccelerationParts:
    """Return the rod at a place by its motion alone."""
    return parted(_moving(at))


def _moving(at: At) -> LoadedCrank:
    return LoadedCrank(at.circle, at.ratio, NOTHING, at.offset, by=at.by)


def acceleration_entries() -> Iterator[Quantity]:
    """Yield the accelerations in R ω² and in m/s², those that other pages have had first."""
    own = [_part(one) for one in PARTS]
    yield from (*own, *component_entries(moved), *map(measured, own))


def component_entries(parted_of: Callable[[At], AccelerationParts]) -> Iterator[Quantity]:
    """Yield the amounts and components of the rod at a place."""
    for key, letter, name, printed, components in _OTHERS:
        for component in components:
            share = _component(key, letter, name, printed, component, parted_of)
            yield from (share, measured(share))


def rocker_entries(parted_of: Callable[[At], AccelerationParts]) -> Iterator[Quantity]:
    """Yield the accelerations of a rod whose end B does not slide."""
    yield from component_entries(parted_of)
    for part in PARTS[1:]:
        formulas = {"exact": Formula(_of_rod(part.key, parted_of))}
        share = entry_of_rod(f"{part.key}_acceleration", part.letter, part.name, EXACT, formulas)
        yield from (share, measured(share))


def _of_rod(key: str, parted_of: Callable[[At], AccelerationParts]) -> Callable[[At], Numeric]:
    return lambda at: getattr(parted_of(at), key)


def _part(part: Part) -> Quantity:
    """A part that p₁ is made of, by any method."""

    def kernel(at: At) -> Numeric:
        found: Numeric = getattr(_moving(at).parts, part.key)
        return found

    head = f"${part.letter}/({UNIT}) = "
    formulas = {method: Formula(kernel, f"{head}{said}$") for method, said in part.printed.items()}
    return entry_of_rod(f"{part.key}_acceleration", part.letter, part.name, EXACT, formulas)


def _component(
    key: str,
    letter: str,
    name: Words,
    printed: str,
    one: Component,
    parted_of: Callable[[At], AccelerationParts],
) -> Quantity:
    def kernel(at: At) -> Numeric:
        return one.kernel(parted_of(at)) + 0

    formulas = dict.fromkeys(("exact", "infinite", OFFSET), Formula(kernel, printed if not one.end else ""))
    return entry_of_rod(f"{key}{one.end}", f"{letter}{one.mark}", name, one.part, formulas)


def entry_of_rod(
    key: str, letter: str, name: Words, part: Words, formulas: Mapping[str, Formula], unit: str = UNIT,
    model: str = "exact",
) -> Quantity:  # fmt: skip
    """Return what is known of a rod in a unit by one of its models: all of them stand under the letter."""
    return Quantity(
        key=key,
        name=name,
        symbol=f"${letter}$",
        unit=words(unit.replace("^2", "²")),
        decimals=4,
        formulas=formulas,
        spanners=(name, words(f"${letter}/({unit})$")),
        heading=part,
        part=part,
        needs=(Needs.ROD,),
        model=model,
    )
