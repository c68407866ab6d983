"""Engines of unlike cylinders: each cylinder is what all have in common, with what is its own."""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from kurbel.commands.loads import OWN, named
from kurbel.commands.options import is_given
from kurbel.errors import KurbelError, ProblemError
from kurbel.page.layouts import Layout
from kurbel.reading.given import as_angle, as_number
from kurbel.reading.notation import about

if TYPE_CHECKING:
    from kurbel.engine.assembly import Assembly
    from kurbel.engine.engine import Engine

LENGTHS = ("ratio", "stroke", "rod")
ROD = ("rod_mass", "centre", "gyration", "pendulum", "pendulum_from")
PLACE = ("angle", "bank", "fires")
# What an option is that was not given.
_NOTHING: Mapping[str, Any] = {"card": None, "single_acting": False, "two_stroke": False}


def assembly_of(page: Layout, given: Mapping[str, Any]) -> "Assembly":
    """Return the engine of the cylinders that options describe. Raises ProblemError with their number."""
    from kurbel.engine.assembly import Assembly

    if is_given(given.get("cranks")):
        raise ProblemError(
            "--cranks are those of cylinders alike, and each --cylinder has its angle; leave one out"
        )
    described = given["cylinder"]
    _check_used(given, described)
    parts = [
        _part(_title(number, own), page, merged(given, own), own) for number, own in enumerate(described, 1)
    ]
    lags = lags_of(described, [part.steam for part in parts])
    return Assembly(tuple(_behind(part, lag) for part, lag in zip(parts, lags, strict=True)))


def seen_from(assembly: "Assembly", chosen: Any) -> tuple["Assembly", tuple[int, ...]]:
    """Return the engine with a cylinder, by its number, in the first place, and the numbers of all."""
    from kurbel.engine.assembly import Assembly

    parts, number = assembly.parts, as_number(chosen, "cylinder")
    if number not in range(1, len(parts) + 1):
        raise ProblemError(f"cylinder {about(number)} was asked for, and the engine has {len(parts)}")
    index = int(number) - 1
    cycle = 180 * max(getattr(part.steam, "strokes_of_cycle", 2) for part in parts)
    order = [index, *(one for one in range(len(parts)) if one != index)]
    turned = (_behind(parts[one], (parts[one].lag - parts[index].lag) % cycle) for one in order)
    return Assembly(tuple(turned)), tuple(one + 1 for one in order)


def whole_cycle(given: Mapping[str, Any]) -> Fraction:
    """Return the degrees after which everything comes again: of any four-stroke cylinder two turns."""
    from kurbel.commands import machines

    options = (merged(given, own) for own in given["cylinder"])
    return max((machines.whole_cycle({**one, "cylinder": None}) for one in options), default=Fraction(360))


def merged(given: Mapping[str, Any], own: Mapping[str, Any]) -> dict[str, Any]:
    """Return what all cylinders have in common, without what one's own entries outdo, and these."""
    common = {name: value for name, value in given.items() if name not in ("cylinder", "cranks")}
    dropped = [*_other_loads(common, own), *_other_lengths(common, own)]
    if "rod_file" in own:
        dropped += ROD
    elif any(name in own for name in ROD):
        dropped.append("rod_file")
    left = {name: _NOTHING.get(name) if name in dropped else value for name, value in common.items()}
    kept = {name: value for name, value in own.items() if name not in PLACE}
    # By its bank the weight of a cylinder has another direction.
    return {**left, **kept, "bank": own.get("bank")}


def _other_loads(common: Mapping[str, Any], own: Mapping[str, Any]) -> list[str]:
    """Return the options of loads that are not the cylinder's."""
    keys = named(own)
    if not keys:
        return []
    kept = {key for one in keys for key in (one, *OWN[one][1])}
    return [name for key, (_, others) in OWN.items() for name in (key, *others) if name not in kept]


def _check_used(given: Mapping[str, Any], cylinders: Sequence[Mapping[str, Any]]) -> None:
    """Refuse what describes a load that none of the cylinders has."""
    unused = [_other_loads(given, own) for own in cylinders]
    for name in unused[0] if unused else ():
        if is_given(given.get(name)) and all(name in others for others in unused):
            flag = f"--{name.replace('_', '-')}"
            raise ProblemError(
                f"{flag} says nothing about the cylinders, which have other loads; leave it out"
            )


def _other_lengths(common: Mapping[str, Any], own: Mapping[str, Any]) -> list[str]:
    """Return those of ratio, stroke and rod that two others of the cylinder's outdo."""
    if not all(is_given(own.get(name, common.get(name))) for name in LENGTHS):
        return []
    return [name for name in ("ratio", "rod", "stroke") if name not in own][:1]


def _title(number: int, own: Mapping[str, Any]) -> str:
    """Return what a cylinder is called in sentences, with the line of its file."""
    where = getattr(own, "where", "")
    return f"{where}: cylinder {number}" if where else f"cylinder {number}"


def _part(title: str, page: Layout, given: Mapping[str, Any], own: Mapping[str, Any]) -> "Engine":
    from kurbel.commands.machines import described_engines
    from kurbel.commands.old_motion import meant, of_other_mechanisms
    from kurbel.engine.engine import Engine

    if not named(given):
        raise ProblemError(f"{title} has no load; give it eps, card, pressure_ratio, pump or compression")
    try:
        # What all cylinders have in common may be of the drives of others.
        foreign = of_other_mechanisms(own, meant(given, layout=None), ("stroke", "speed", "method"))
        for sentence in foreign.values():
            raise ProblemError(sentence)
        found = described_engines(page, given)
        for name, what in (("steams", "load"), ("drives", "crank ratio")):
            if len(found[name]) != 1:
                raise ProblemError(f"it has {len(found[name])} {what}s; a cylinder has one")
        return Engine(found["drives"][0], found["steams"][0], found["double"], load=found["load"])
    except KurbelError as error:
        raise type(error)(f"{title}: {error}") from None


def lags_of(cylinders: Sequence[Mapping[str, Any]], loads: Sequence[Any]) -> list[Fraction]:
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
    ordered: Sequence[Any],
    loads: Sequence[Any],
    titles: Sequence[str],
) -> list[Fraction]:
    from kurbel.balance.arrangement import Cylinder
    from kurbel.balance.firing import PERIODS, fitting

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


def _angle(cylinder: Mapping[str, Any], name: str, title: str) -> Fraction:
    return as_angle(cylinder.get(name, 0), f"{title}: {name}")


def _behind(part: "Engine", lag: Fraction) -> "Engine":
    from dataclasses import replace

    return replace(part, lag=lag)
