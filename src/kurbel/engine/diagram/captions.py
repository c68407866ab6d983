"""What pages of turning-moment diagrams say below the table: signs, what was taken, and what follows."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

from kurbel.engine.diagram.fluctuation import Extreme, Fluctuation
from kurbel.engine.diagram.steady import Steady
from kurbel.exact.kind import Kind, floats, settled
from kurbel.exact.numerals import Label, Number, figures, finite_decimals, nearest, number_text
from kurbel.page.quantity import Words, words
from kurbel.reading.amounts import moved, unit_of_page
from kurbel.reading.units import Speed

# So many places are named; more go on in the same steps.
MOST_PLACES = 6
# The decimals of an angle.
PLACES = 3
WORDS: Mapping[str, Words] = {
    "signs": words(
        "$T$ Drehmoment des Antriebs, $T_L$ der Last, positiv, wo sie ihn hemmt, $W$ Arbeit von $T - T_L$"
        " seit $0°$: am größten, wo die Drehzahl am größten ist"
        "|$T$ torque of the drive, $T_L$ of the load, positive where it resists, $W$ work of $T - T_L$ since"
        " $0°$: greatest where the speed is"
    ),
    "area_signs": words(
        "Flächen über der Mittellinie positiv, $a$ vor der ersten Fläche, $b$ hinter ihr; $W$ seit $a$, am"
        " größten, wo die Drehzahl am größten ist"
        "|areas above the mean line positive, $a$ before the first, $b$ behind it; $W$ since $a$, greatest"
        " where the speed is"
    ),
    "load": words("$T_L$ gleichbleibend, das Mittel von $T$|$T_L$ constant, the mean of $T$"),
    "drive": words("$T$ gleichbleibend, das Mittel von $T_L$|$T$ constant, the mean of $T_L$"),
    "lines": words("Punkte durch Geraden verbunden|points joined by straight lines"),
    "triangles": words(
        "Dreiecke gleicher Breite, ihre Spitzen in der Mitte"
        "|triangles alike in width, their peaks in the middle"
    ),
    "jumps": words("an Sprüngen der Wert dahinter|at jumps the value behind"),
    "cranks": words(
        "gleiche Diagramme, um {angles} versetzt, überlagert|diagrams alike, {angles} apart, superposed"
    ),
    "cycle": words("Spiel von ${turns}$ Umdrehungen|cycle of ${turns}$ turns"),
    "one_cycle": words("Spiel von einer Umdrehung|cycle of one turn"),
    "scale": words("eine Flächeneinheit ${scale}$|a unit of area ${scale}$"),
    "mean": words("mittleres Moment ${mean}$|mean torque ${mean}$"),
    "work": words("Arbeit des Spieles ${work}$|work of a cycle ${work}$"),
    "swing": words("Arbeitsüberschuss $ΔW = {swing}$|energy swing $ΔW = {swing}$"),
    "extremes": words(
        "Drehzahl am größten bei {greatest}, am kleinsten bei {least}"
        "|speed greatest at {greatest}, least at {least}"
    ),
    "power": words("Leistung ${power}$|power ${power}$"),
    "run": words(
        "$J = {inertia}$, {speed}, Mittel aus größter und kleinster"
        "|$J = {inertia}$, {speed}, mean of the greatest and the least"
    ),
    "irregularity": words(
        'Ungleichförmigkeitsgrad $δ = (ΔW)/(J ω^2) = {delta}$, $n_"max" = {most} "min"^(-1)$,'
        ' $n_"min" = {least} "min"^(-1)$'
        '|degree of irregularity $δ = (ΔW)/(J ω^2) = {delta}$, $n_"max" = {most} "min"^(-1)$,'
        ' $n_"min" = {least} "min"^(-1)$'
    ),
    "mass": words("$J = {inertia}$"),
}


def shown(value: Callable[[Kind], Any]) -> str:
    """Return a number to five figures, every digit of which is meant."""
    decimals = figures(float(value(floats())))
    return number_text(Number(settled(value, decimals), decimals))


def _amount(value: Callable[[Kind], Any], symbol: str) -> Label:
    """Return the same of an amount in this unit of metric pages, with the unit of the page."""
    times, unit = unit_of_page(symbol)
    text = shown(lambda kind: value(kind) * kind.of(times))
    if times == 1:
        # Every digit stays in a larger unit.
        times, unit = unit_of_page(symbol, Fraction(text))
        text = moved(text, times, exact=False)
    return f"{text} {unit}"


def outcome(
    fluctuation: Fluctuation, speed: Speed | None, steady: Steady | None, lang: str
) -> Iterator[Label]:
    """Yield what follows of a cycle: mean torque, work, swing, where the speed is greatest, the flywheel."""
    parts = []
    if fluctuation.mean_torque(floats()) is not None:
        parts.append(WORDS["mean"][lang].format(mean=_amount(fluctuation.mean_torque, "N m")))
        parts.append(WORDS["work"][lang].format(work=_amount(fluctuation.work, "J")))
    parts.append(WORDS["swing"][lang].format(swing=_amount(fluctuation.swing, "J")))
    if speed is not None and fluctuation.mean_torque(floats()) is not None:
        parts.append(WORDS["power"][lang].format(power=_amount(_power(fluctuation, speed), "W")))
    yield ", ".join(parts)
    greatest, least = (places(fluctuation.extremes(greatest=which)) for which in (True, False))
    yield WORDS["extremes"][lang].format(greatest=greatest, least=least)
    if steady is not None:
        most, low = (shown(_turns_a_minute(one)) for one in (steady.greatest, steady.least))
        delta = shown(steady.irregularity)
        yield WORDS["irregularity"][lang].format(delta=delta, most=most, least=low)


def places(extremes: Sequence[Extreme]) -> Label:
    """Return places in a row: $30°$; $150°$."""
    named = "; ".join(f"${place_text(one)}$" for one in extremes[:MOST_PLACES])
    return f"{named}; …" if len(extremes) > MOST_PLACES else named


def place_text(extreme: Extreme) -> str:
    if extreme.letter:
        return extreme.letter
    if extreme.exact is not None:
        decimals = finite_decimals(extreme.exact)
        return (
            f"{number_text(nearest(extreme.exact, PLACES if decimals is None else min(decimals, PLACES)))}°"
        )
    assert extreme.degrees is not None
    return f"{number_text(Number(settled(extreme.degrees, PLACES), PLACES))}°"


def _power(fluctuation: Fluctuation, speed: Speed) -> Callable[[Kind], Any]:
    def power(kind: Kind) -> Any:
        value = fluctuation.mean_torque(kind) * kind.of(speed.value)
        return value * 2 * kind.pi if speed.turns else value

    return power


def _turns_a_minute(omega: Callable[[Kind], Any]) -> Callable[[Kind], Any]:
    return lambda kind: 30 * omega(kind) / kind.pi
