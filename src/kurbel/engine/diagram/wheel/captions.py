"""What pages of flywheels without an engine say of themselves, in both languages."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from kurbel.engine.diagram.excess import Excess
from kurbel.engine.diagram.fluctuation import Extreme
from kurbel.engine.diagram.wheel.sizing import LIMIT, ONE_TURN, RIM_ALONE
from kurbel.exact.kind import settled
from kurbel.exact.numerals import Label, Number, finite_decimals, nearest, number_text
from kurbel.exact.product import Product
from kurbel.page.quantity import Words, words
from kurbel.reading.amounts import unit_of_page
from kurbel.reading.notation import plain

if TYPE_CHECKING:
    from kurbel.engine.diagram.wheel.page import WheelRequest

SWING, FLUCTUATION, PRESS, AREAS, TORQUE = "swing", "fluctuation", "press", "areas", "torque"
# What the energy swing is known from.
SOURCES: Mapping[str, Words] = {
    SWING: words("Schwungrad nach dem Arbeitsüberschuss|Flywheel by the energy swing"),
    FLUCTUATION: words(
        "Schwungrad nach dem Anteil des Arbeitsüberschusses"
        "|Flywheel by the coefficient of fluctuation of energy"
    ),
    PRESS: words("Schwungrad einer Presse|Flywheel of a press"),
    AREAS: words(
        "Schwungrad nach den Flächen des Drehmomentdiagramms"
        "|Flywheel by the areas of the turning-moment diagram"
    ),
    TORQUE: words("Schwungrad nach dem Verlauf des Drehmoments|Flywheel by the turning-moment diagram"),
    "": words("Schwungrad|Flywheel"),
}
WORDS: Mapping[str, Words] = {
    "speeds": words(
        '$ΔW = J ω^2 δ$ mit $ω = (ω_"max" + ω_"min")/2$ und $δ = (ω_"max" - ω_"min")/ω${exactly}'
        '|$ΔW = J ω^2 δ$ with $ω = (ω_"max" + ω_"min")/2$ and $δ = (ω_"max" - ω_"min")/ω${exactly}'
    ),
    "rim_speeds": words(
        '{swing} $= m_R v^2 δ$ mit $v = (v_"max" + v_"min")/2$ und $δ = (v_"max" - v_"min")/v$, genau: die'
        " Masse im mittleren Durchmesser, $v$ ihre Geschwindigkeit"
        '|{swing} $= m_R v^2 δ$ with $v = (v_"max" + v_"min")/2$ and $δ = (v_"max" - v_"min")/v$, exactly:'
        " the mass at the mean diameter, $v$ its speed"
    ),
    "exactly": words(", genau|, exactly"),
    "mass": words("$J = m k^2$"),
    "cycle": words(
        "$W$ Arbeit eines Spiels von {turns}|$W$ work of a cycle of {turns}"
    ),
    "turn": words("einer Umdrehung|one turn"),
    "turns": words("${turns}$ Umdrehungen|${turns}$ turns"),
    "press": words(
        "die Presse arbeitet während des Teils ${share}$ des Spiels, der Motor gibt stets die Leistung $N$:"
        " $ΔW = {rest} W$"
        "|the press works during the share ${share}$ of the cycle, the motor gives the power $N$ throughout:"
        " $ΔW = {rest} W$"
    ),
    "blow": words(
        "das Schwungrad leistet die Arbeit allein: $ΔW = W$|the flywheel does the work alone: $ΔW = W$"
    ),
    "stress": words("$v = ω D/2$, $σ = ρ v^2$"),
    "rim": words(
        "$m_R = ρ A π D$, $J_R = m_R D^2/4$: die Masse im mittleren Durchmesser"
        "|$m_R = ρ A π D$, $J_R = m_R D^2/4$: the mass at the mean diameter"
    ),
    "density": words("$ρ = {density} {unit}$"),
    LIMIT: words(
        "der Kranz hat den größten Durchmesser, den $σ$ erlaubt"
        "|the rim has the greatest diameter that $σ$ allows"
    ),
    RIM_ALONE: words(
        "Arme und Nabe sind nicht gerechnet (--rim-share)|arms and hub are not counted (--rim-share)"
    ),
    "disc": words("Scheibe: $J = m D^2/8$, $m = ρ π D^2 t/4$|disc: $J = m D^2/8$, $m = ρ π D^2 t/4$"),
    "places": words("Geschwindigkeit am größten bei {high}, am kleinsten bei {low}"
                      "|speed greatest at {high}, least at {low}"),
    "letters": words(
        "$a$ vor der ersten Fläche, $b$ hinter ihr und so fort"
        "|$a$ before the first area, $b$ behind it, and so on"
    ),
}  # fmt: skip
ANGLE_DECIMALS = 2
# More places of one speed are left out.
MOST_PLACES = 8
# A longer fraction is written as a decimal.
LONGEST = 9


def caption(question: WheelRequest) -> Label:
    text = question.layout.caption[question.lang]
    if question.engine:
        return text.replace("{flywheel}", question.engine[0])
    return text.replace("{flywheel}", SOURCES[question.known_from][question.lang])


def notes(question: WheelRequest) -> Iterator[Label]:
    """Yield the lines below the table: its formulas, what was taken, where the speed is greatest."""
    lang, wheel = question.lang, question.wheels[0]
    yield from (note[lang] for note in question.layout.notes)
    if "delta" in wheel.figures and "rim_mass" in wheel.figures and "omega" not in wheel.figures:
        swing = "$ΔW$" if wheel.figures["rim_share"].value.rational == 1 else "$J_R/J ΔW$"
        yield WORDS["rim_speeds"][lang].replace("{swing}", swing)
    elif "delta" in wheel.figures:
        # Masses that move have an energy of their own, which varies.
        exactly = "" if question.engine else WORDS["exactly"][lang]
        yield WORDS["speeds"][lang].replace("{exactly}", exactly)
    if question.fluctuation is not None:
        yield from _places(question)
        yield from _accelerated(question)
    if question.known_from in (FLUCTUATION, TORQUE) and "turns" in wheel.figures:
        yield _cycle(question)
    if question.press is not None:
        yield _press(*question.press, lang)
    if "mass" in wheel.figures and "disc_diameter" not in wheel.figures:
        yield WORDS["mass"][lang]
    yield from _rim(question)
    yield from question.engine[1:]


def _cycle(question: WheelRequest) -> Label:
    """Return how long the cycle is whose work is W."""
    lang, turns = question.lang, question.wheels[0].figures["turns"].value
    said = WORDS["turn"] if turns.rational == 1 else WORDS["turns"]
    number = number_text(turns.number(None, question.rounding))
    usual = " (--turns)" if ONE_TURN in question.wheels[0].taken else ""
    return WORDS["cycle"][lang].format(turns=said[lang].format(turns=number)) + usual


def _press(working: Product | None, rest: Product, lang: str) -> Label:
    """Return what the motor gives while the press works."""
    if working is None:
        return WORDS["blow"][lang]
    return WORDS["press"][lang].format(share=_fraction(working), rest=_fraction(rest))


def _rim(question: WheelRequest) -> Iterator[Label]:
    lang, wheel = question.lang, question.wheels[0]
    said = [WORDS[key][lang] for key in (LIMIT, RIM_ALONE) if key in wheel.taken]
    turning = "omega" in wheel.figures
    formulas = [WORDS["stress"][lang]] if "rim_speed" in wheel.figures and turning else []
    formulas += [WORDS["rim"][lang]] if "rim_mass" in wheel.figures and turning else []
    if formulas:
        yield ", ".join(formulas)
    if "disc_diameter" in wheel.figures:
        yield WORDS["disc"][lang]
    if "density" in wheel.figures:
        times, unit = unit_of_page("kg/m³")
        density = wheel.figures["density"].value * Product.of(times)
        number = number_text(density.number(None, question.rounding))
        said.insert(0, WORDS["density"][lang].format(density=number, unit=unit))
    if said:
        yield "; ".join(said)


def _places(question: WheelRequest) -> Iterator[Label]:
    """Yield where the speed is greatest and where least."""
    assert question.fluctuation is not None
    high, low = (question.fluctuation.extremes(greatest=greatest) for greatest in (True, False))
    names = {"high": _listed(high, question), "low": _listed(low, question)}
    yield WORDS["places"][question.lang].format(**names)
    if high[0].letter:
        yield WORDS["letters"][question.lang]


def _accelerated(question: WheelRequest) -> Iterator[Label]:
    """Yield the greatest and the least angular acceleration, where torques are known."""
    inertias = [wheel.figures["inertia"].value for wheel in question.wheels if "inertia" in wheel.figures]
    if isinstance(question.fluctuation, Excess) and inertias:
        from kurbel.engine.diagram.acceleration import acceleration_line

        yield from acceleration_line(question.fluctuation, inertias, question.rounding, question.lang)


def _listed(places: Sequence[Extreme], question: WheelRequest) -> Label:
    first, *others = (_place(one, question.rounding) for one in places[:MOST_PLACES])
    begun = f"${first}$" if places[0].letter else f"$φ = {first}$"
    more = ["..."] if len(places) > MOST_PLACES else []
    return ", ".join([begun, *(f"${one}$" for one in others), *more])


def _place(place: Extreme, rounding: str) -> str:
    """Return a letter or an angle as it stands in a formula."""
    if place.degrees is None:
        return place.letter
    if place.exact is not None:
        return f"{plain(nearest_short(place.exact, rounding))}°"
    number = Number(settled(place.degrees, ANGLE_DECIMALS, rounding), ANGLE_DECIMALS)
    return f"{number_text(number)}°"


def nearest_short(angle: Fraction, rounding: str) -> Fraction:
    """Return an angle to as many decimals as others have, a shorter one as it is."""
    number = nearest(angle, ANGLE_DECIMALS, rounding)
    return Fraction(number.scaled, 10**number.decimals)


def _fraction(product: Product) -> str:
    """Return a share as it stands in a formula: 0.25, 1/3, or to five figures."""
    value = product.rational
    if value is None or len(str(value)) > LONGEST:
        return number_text(product.number(None, "half-away"))
    return plain(value) if finite_decimals(value) is not None else f"{value.numerator}/{value.denominator}"
