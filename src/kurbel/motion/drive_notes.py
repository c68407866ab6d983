"""What pages say of the drive below their tables: lengths, speed, dead centres, masses, in both languages."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from kurbel.drive.crank import Crank, known
from kurbel.drive.load import figure
from kurbel.exact.certify import Kind, ball_degrees, settled
from kurbel.exact.numerals import Label, Number, finite_decimals, number_text
from kurbel.kernel import kinematics
from kurbel.motion.evaluation import OUT, RETURN
from kurbel.page.quantity import Words, enumerated_letters, words
from kurbel.reading.notation import ratio_text

if TYPE_CHECKING:
    from kurbel.drive.rod import Rod

WORDS: Mapping[str, Words] = {
    "offset": words(
        "Geschränkt, $e = {offset} R$, $R:L = {ratio}$: Totlagen $φ_i = {inner}°$ und $φ_o = {outer}°$, Hub "
        "${stroke} R$"
        "|Offset $e = {offset} R$, $R:L = {ratio}$: dead centres at $φ_i = {inner}°$ and $φ_o = {outer}°$, "
        "stroke ${stroke} R$"
    ),
    "machine": words('$R = {radius} "mm"${rod}{speed}'),
    "rod": words(', $L = {rod} "mm"$'),
    "speed": words(
        '; {turns}$v = {pin} "m/s"$, mittlere Kolbengeschwindigkeit $c_m = {mean} "m/s"$, $v:c_m = '
        "{quotient}$"
        '|; {turns}$v = {pin} "m/s"$, mean piston speed $c_m = {mean} "m/s"$, $v:c_m = {quotient}$'
    ),
    "masses": words("Massen: |Masses: "),
    "reciprocating": words("Kolben und Kreuzkopf|piston and crosshead"),
    "rotating": words("Kurbel weniger Gegengewicht, am Zapfen|crank less counterweight, at its pin"),
    "connecting_rod": words(
        "Schubstange: Schwerpunkt $a = {centre} {length}$ vom Kreuzkopfzapfen, $k = {gyration} {length}$, "
        "$k^2 - a b = {couple} {length}^2${mass}"
        "|Rod: centre of mass $a = {centre} {length}$ from the crosshead pin, $k = {gyration} {length}$, "
        "$k^2 - a b = {couple} {length}^2${mass}"
    ),
    "mirrored": words("bei $360° - φ$ |at $360° - φ$ "),
    "same": words("{letters} gleich|{letters} the same"),
    "opposite": words("{letters} entgegengesetzt|{letters} opposite"),
}


def drive_notes(cranks: Sequence[Crank], lang: str) -> list[Label]:
    """Return the lines about lengths and speeds, and those about offsets."""
    lines = [_machine(crank, lang) for crank in cranks if crank.radius is not None]
    return lines + [_offset(crank, lang) for crank in cranks if crank.offset and crank.ratio]


def force_notes(cranks: Sequence[Crank], lang: str) -> Iterable[Label]:
    """Return the lines about the piston forces."""
    return dict.fromkeys(crank.force.note(lang) for crank in cranks if crank.force is not None)


def rod_notes(cranks: Sequence[Crank], lang: str, shown: Collection[str]) -> Iterator[Label]:
    """Yield the lines about the connecting rods, and where cranks are straight the symmetry of the letters
    shown."""
    yield from dict.fromkeys(connecting_rod(crank.rod, lang) for crank in cranks if crank.rod is not None)
    if any(crank.offset for crank in cranks):
        return
    said = [
        WORDS[key][lang].format(letters=enumerated_letters([one for one in letters if one in shown], lang))
        for key, letters in (("same", ("X", "P")), ("opposite", ("N", "Y", "M_d")))
        if set(letters) & set(shown)
    ]
    if said:
        yield WORDS["mirrored"][lang] + ", ".join(said)


def moving_notes(crank: Crank, ratio_symbol: str, lang: str) -> Iterator[Label]:
    """Yield the lines about the moving masses, with the size and the speed that make forces of them."""
    moving, speed, radius = known(crank.moving), known(crank.speed), ratio_symbol[0]
    said = {"reciprocating": moving.reciprocating, "rotating": moving.rotating}
    parts = [f'{WORDS[key][lang]} ${figure(mass)} "kg"$' for key, mass in said.items() if mass]
    value = figure(60 * speed.value if speed.turns else speed.value)
    turns = f'n = {value} "min"^(-1)' if speed.turns else f'ω = {value} "rad/s"'
    parts += [f'${radius} = {figure(1000 * known(crank.radius))} "mm"$', f"${turns}$"]
    yield WORDS["masses"][lang] + ", ".join(parts)
    if moving.rod is not None:
        yield connecting_rod(moving.rod, lang, ratio_symbol[-1])


def connecting_rod(rod: Rod, lang: str, length: str = "L") -> Label:
    """Return the line about a rod: where its masses are, and its mass if that is known."""
    from kurbel.kernel.circle import root

    def gyration(numbers: Kind) -> Any:
        return root(numbers.of(rod.gyration_square))

    return WORDS["connecting_rod"][lang].format(
        length=length,
        centre=figure(1 - rod.centre),
        gyration=_root(rod.gyration_square) or _certified(gyration, 4, algebraic=True),
        couple=figure(rod.couple),
        mass=f', $M = {figure(rod.mass)} "kg"$' if rod.mass is not None else "",
    )


def _root(square: Fraction) -> str:
    """The square root of a fraction that has a short one, else nothing."""
    from math import isqrt

    root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    return figure(root) if root * root == square and finite_decimals(root) is not None else ""


def _machine(crank: Crank, lang: str) -> Label:
    radius = 1000 * known(crank.radius)
    rod = WORDS["rod"][lang].format(rod=figure(radius / crank.ratio)) if crank.ratio else ""
    speed = _speed(crank, lang) if crank.speed else ""
    return WORDS["machine"][lang].format(radius=figure(radius), rod=rod, speed=speed)


def _speed(crank: Crank, lang: str) -> str:
    speed = known(crank.speed)
    turns, radians = f'$n = {figure(speed.value * 60)} "min"^(-1)$', f'$ω = {figure(speed.value)} "rad/s"$'
    quotient = _certified(lambda numbers: numbers.pi / crank.stroke(numbers), 4, algebraic=False)
    return WORDS["speed"][lang].format(
        turns=f"{turns if speed.turns else radians}, ",
        pin=_certified(crank.pin_velocity, 3, algebraic=not speed.turns),
        mean=_certified(lambda numbers: _mean_speed(crank, numbers), 3, algebraic=speed.turns),
        quotient=quotient if crank.offset else "π:2",
    )


def _mean_speed(crank: Crank, numbers: Kind) -> Any:
    """c_m in m/s. Of turns it is S n/30, without the π that the crank-pin velocity has."""
    speed = known(crank.speed)
    if speed.turns:
        stroke = crank.stroke(numbers) * numbers.of(known(crank.radius))
        return kinematics.mean_piston_speed(stroke, numbers.of(60 * speed.value))
    return crank.pin_velocity(numbers) * kinematics.mean_piston_velocity(crank.stroke(numbers), numbers.pi)


def _offset(crank: Crank, lang: str) -> Label:
    def dead_centre(sign: int) -> Any:
        def degrees(numbers: Any) -> Any:
            sine = kinematics.dead_centre_sine(
                numbers.of(sign * crank.ratio), numbers.of(sign * crank.offset)
            )
            return ball_degrees(sine) + (0 if sign == OUT else 180)

        return degrees

    return WORDS["offset"][lang].format(
        offset=figure(crank.offset),
        ratio=ratio_text(crank.ratio),
        inner=_certified(dead_centre(OUT), 3, algebraic=False),
        outer=_certified(dead_centre(RETURN), 3, algebraic=False),
        stroke=_certified(crank.stroke, 4, algebraic=True),
    )


def _certified(value: Callable[[Kind], Any], decimals: int, algebraic: bool) -> str:
    """The digits of a value that is either algebraic or an arc or a multiple or fraction of π."""
    return number_text(Number(settled(value, decimals, algebraic=algebraic), decimals))
