"""The greatest and the least excess torque over a cycle, by which a flywheel has its angular acceleration.

Of sums of waves it lies where their slope is zero, of straight lines at their ends; of both together in one
diagram it is not sought. Re-derived; closed form, with every digit certified.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from kurbel.engine.diagram.captions import places
from kurbel.engine.diagram.excess import Excess
from kurbel.engine.diagram.fluctuation import Extreme
from kurbel.engine.diagram.torque import Line, Torque
from kurbel.engine.diagram.waves import Waves
from kurbel.engine.diagram.zeros import Zero, is_plain, over_cycle, waves_at, zeros
from kurbel.exact.kind import Kind, balls
from kurbel.exact.numerals import Label, number_text
from kurbel.exact.product import Product
from kurbel.page.quantity import words

WORDS = words(
    'Winkelbeschleunigung $α = (T - T_L)/J$ am größten {most} $"rad"/"s"^2$ bei {high}, am kleinsten'
    ' {least} $"rad"/"s"^2$ bei {low}'
    '|angular acceleration $α = (T - T_L)/J$ greatest {most} $"rad"/"s"^2$ at {high}, least'
    ' {least} $"rad"/"s"^2$ at {low}'
)
_FROM = words("{start} bis {end}|{start} to {end}")


class Peak(NamedTuple):
    """The magnitude of the greatest or the least excess torque in N m, and the places where it is so: each
    from one angle to another, which may be the same."""

    torque: Product
    places: Sequence[tuple[Extreme, Extreme]]


def acceleration_line(
    excess: Excess, inertias: Sequence[Product], rounding: str, lang: str
) -> Iterator[Label]:
    """Yield what is said of the acceleration of flywheels of these moments of inertia in kg m²."""
    peaks = [peak_of(excess, greatest=greatest) for greatest in (True, False)]
    if None in peaks:
        return
    high, low = (peak for peak in peaks if peak is not None)
    figures = [
        "; ".join(
            f"${sign}{number_text((peak.torque / inertia).number(None, rounding))}$" for inertia in inertias
        )
        for peak, sign in ((high, ""), (low, "-"))
    ]
    listed = ["; ".join(_listed(peak, lang)) for peak in (high, low)]
    yield WORDS[lang].format(most=figures[0], least=figures[1], high=listed[0], low=listed[1])


def peak_of(excess: Excess, *, greatest: bool) -> Peak | None:
    """Return the greatest or the least excess torque, None where it is not sought."""
    own, sign = excess.excess, 1 if greatest else -1
    if not own.waves:
        return _of_lines(own.lines, sign, excess)
    return _of_waves(own.waves, sign, excess.cycle) if is_plain(own) else None


def _of_lines(lines: Sequence[Line], sign: int, excess: Excess) -> Peak:
    most = max(sign * value for one in lines for value in (one.first, one.last))
    spans: list[tuple[Fraction, Fraction]] = []
    for one in lines:
        ends = [at for at, value in ((one.start, one.first), (one.end, one.last)) if sign * value == most]
        if ends and spans and spans[-1][1] == ends[0]:
            spans[-1] = (spans[-1][0], ends[-1])
        elif ends:
            spans.append((ends[0], ends[-1]))
    # The end of the cycle is its beginning.
    if len(spans) > 1 and spans[0][0] == 0 and spans[-1] == (excess.cycle, excess.cycle):
        del spans[-1]
    torque = Product.of(most * 180, -1) if excess.by_degree else Product.of(most)
    return Peak(torque, [(_exact(start), _exact(end)) for start, end in spans])


def _of_waves(waves: Waves, sign: int, cycle: Fraction) -> Peak | None:
    from kurbel.exact.search import greatest

    slope = waves.slope
    steepness = Torque(slope, (Line(Fraction(0), cycle, Fraction(0)),))

    def torque(zero: Zero, kind: Kind) -> Any:
        value = waves_at(waves, zero, slope, kind)
        return value if sign > 0 else kind.of(Fraction(0)) - value

    found = greatest(zeros(steepness), lambda one: torque(one, balls()))
    if any(one.is_open for one in found):
        return None
    return Peak(
        Product.reduced(_of(torque, found[0])), [(one, one) for one in over_cycle(found, steepness, cycle)]
    )


def _of(torque: Callable[[Zero, Kind], Any], zero: Zero) -> Callable[[Kind], Any]:
    return lambda kind: torque(zero, kind)


def _exact(angle: Fraction) -> Extreme:
    return Extreme(degrees=lambda kind: kind.of(angle), exact=angle)


def _listed(peak: Peak, lang: str) -> Iterator[Label]:
    if all(start is end or start.exact == end.exact for start, end in peak.places):
        yield places([start for start, _ in peak.places])
        return
    for start, end in peak.places:
        one, other = places([start]), places([end])
        yield one if one == other else _FROM[lang].format(start=one, end=other)
