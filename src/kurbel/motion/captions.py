"""What a page says about itself: caption, formulas, lengths and dead centres, in both languages."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Protocol

from kurbel.drive.crank import Crank
from kurbel.exact.numerals import Label, Number, finite_decimals, nearest, number_text
from kurbel.kernel import kinematics
from kurbel.motion.quantities import (
    DIFFERENCE,
    METHODS,
    OUT,
    RETURN,
    Numbers,
    Quantity,
    numbers_of_balls,
    pin_velocity,
)
from kurbel.motion.request import Request
from kurbel.page.table import Field
from kurbel.reading.notation import plain, ratio_text

if TYPE_CHECKING:
    from kurbel.drive.rod import Rod
    from kurbel.motion.digits import Digits
    from kurbel.page.layouts import Layout


class Formulated(Protocol):
    """What formulas are printed for: cranks, on a page with its letters and its language."""

    @property
    def cranks(self) -> tuple[Crank, ...]: ...
    @property
    def layout(self) -> Layout: ...
    @property
    def lang(self) -> str: ...


# {±} is the sign that the return stroke changes, {ψ} the same where ψ itself is printed (cos ψ knows no
# sign), {angle} the letter of the crank angle.
FORMULAS: Mapping[str, Mapping[str, str]] = {
    "exact": {
        "x": "$x/R = 1 - cos {angle} {±} (1 - cos ψ)/λ$",
        "c": "$c/v = sin {angle} {±} (λ sin {angle} cos {angle})/(cos ψ)$",
        "p": "$(p R)/v^2 = cos {angle} {±} λ (cos 2 {angle} + λ^2 sin^4 {angle})/(cos^3 ψ)$",
        "S": "$S/F = 1/(cos ψ)$",
        "N": "$N/F = {guide}tan ψ$",
        "T": "$T/F = sin({angle} {slant} ψ)/(cos ψ)$",
        "Z": "$Z/F = cos({angle} {slant} ψ)/(cos ψ)$",
        "M_d": "$M_d/(F R) = T/F$",
    },
    "series": {
        "x": "$x/R = 1 - cos {angle} {±} 1/2 λ sin^2 {angle}$",
        "c": "$c/v = sin {angle} {±} 1/2 λ sin 2 {angle}$",
        "p": "$(p R)/v^2 = cos {angle} {±} λ cos 2 {angle}$",
        "ψ": "$sin ψ = {ψ}λ sin {angle}$",
    },
    "infinite": {
        "x": "$x/R = 1 - cos {angle}$",
        "c": "$c/v = sin {angle}$",
        "p": "$(p R)/v^2 = cos {angle}$",
        "ψ": "$ψ = 0$",
    },
}
OFFSET_FORMULAS = {
    "x": "$x/R = (cos φ_i - cos {angle}) + (cos ψ_i - cos ψ)/λ$",
    "c": "$c/v = sin {angle} + cos {angle} tan ψ$",
    "p": "$(p R)/v^2 = cos {angle} - sin {angle} tan ψ + λ (cos^2 {angle})/(cos^3 ψ)$",
    "S": "$S/F = 1/(cos ψ)$",
    "N": "$N/F = tan ψ$",
    "T": "$T/F = sin({angle} + ψ)/(cos ψ)$",
    "Z": "$Z/F = cos({angle} + ψ)/(cos ψ)$",
    "M_d": "$M_d/(F R) = T/F$",
}
SYMBOLS = {
    "exact": "$sin ψ = {ψ}λ sin {angle}$, $λ = {ratio}$",
    "series": "$λ = {ratio}$",
    "infinite": "",
    "offset": "$sin ψ = λ (sin {angle} - e/R)$, $λ = {ratio}$",
}
# Of a stroke: what the forces act on, and in which direction they are positive.
FORCE_SIGNS: Mapping[str, Mapping[str, str]] = {
    "S": {
        "de": "$S$ am Kreuzkopf, auf dem Hingang Druck, auf dem Rückgang Zug",
        "en": "$S$ at the crosshead, thrust on the outstroke, pull on the return",
    },
    "N": {
        "de": "$N$ auf den Kreuzkopf, nach der Seite, auf der in diesem Hub der Kurbelzapfen läuft",
        "en": "$N$ on the crosshead, towards the side on which the crank pin runs in that stroke",
    },
    "T": {"de": "$T$ im Drehsinn", "en": "$T$ as the crank turns"},
    "Z": {"de": "$Z$ nach der Welle hin", "en": "$Z$ towards the shaft"},
    "K": {"de": "$K$ Betrag am Kurbelzapfen", "en": "$K$ magnitude at the crank pin"},
    "B": {"de": "$B$ Betrag am Kreuzkopfzapfen", "en": "$B$ magnitude at the crosshead pin"},
    "H": {"de": "$H$ Betrag am Hauptlager", "en": "$H$ magnitude at the main bearing"},
    "H_x": {
        "de": "$H_x$ auf das Hauptlager, in der Richtung des Hubes",
        "en": "$H_x$ on the main bearing, in the direction of the stroke",
    },
    "H_y": {
        "de": "$H_y$ auf das Hauptlager, nach der Seite des Kurbelzapfens",
        "en": "$H_y$ on the main bearing, towards the side of the crank pin",
    },
}
# For columns that the layout's own caption does not know.
PLAIN_CAPTION = "{quantities}{for_ratio}; {method}"
WORDS: Mapping[str, Mapping[str, str]] = {
    "difference": {
        "de": "Unterschied: genauer Wert weniger Näherung, vor dem Runden gebildet.",
        "en": "Difference: exact value less first order, taken before rounding.",
    },
    "and": {"de": " und ", "en": " and "},
    "for_ratio": {"de": " für ${symbol} = {ratio}$", "en": " for ${symbol} = {ratio}$"},
    "signs": {
        "de": "oberes Zeichen: Hingang, unteres Zeichen: Rückgang",
        "en": "upper sign: outstroke, lower sign: return stroke",
    },
    "offset_return": {
        "de": "Rückgang bei $180° + {angle}$, vom äußeren Totpunkt und in Richtung des Rückgangs gerechnet",
        "en": "Return at $180° + {angle}$, counted from the outer dead centre in the direction of the return",
    },
    "offset": {
        "de": "Geschränkt, $e = {offset} R$, $R:L = {ratio}$:"
        " Totlagen $φ_i = {inner}°$ und $φ_o = {outer}°$, Hub ${stroke} R$",
        "en": "Offset $e = {offset} R$, $R:L = {ratio}$:"
        " dead centres at $φ_i = {inner}°$ and $φ_o = {outer}°$, stroke ${stroke} R$",
    },
    "machine": {
        "de": '$R = {radius} "mm"${rod}{speed}',
        "en": '$R = {radius} "mm"${rod}{speed}',
    },
    "rod": {"de": ', $L = {rod} "mm"$', "en": ', $L = {rod} "mm"$'},
    "speed": {
        "de": '; {turns}$v = {pin} "m/s"$, mittlere Kolbengeschwindigkeit $c_m = {mean} "m/s"$,'
        " $v:c_m = {quotient}$",
        "en": '; {turns}$v = {pin} "m/s"$, mean piston speed $c_m = {mean} "m/s"$, $v:c_m = {quotient}$',
    },
    "masses": {"de": "Massen: ", "en": "Masses: "},
    "reciprocating": {"de": "Kolben und Kreuzkopf", "en": "piston and crosshead"},
    "rotating": {
        "de": "Kurbel weniger Gegengewicht, am Zapfen",
        "en": "crank less counterweight, at its pin",
    },
    "connecting_rod": {
        "de": "Schubstange: Schwerpunkt $a = {centre} {length}$ vom Kreuzkopfzapfen,"
        " $k = {gyration} {length}$, $k^2 - a b = {couple} {length}^2${mass}",
        "en": "Rod: centre of mass $a = {centre} {length}$ from the crosshead pin,"
        " $k = {gyration} {length}$, $k^2 - a b = {couple} {length}^2${mass}",
    },
    "mirrored": {"de": "bei $360° - φ$ ", "en": "at $360° - φ$ "},
    "same": {"de": "{letters} gleich", "en": "{letters} the same"},
    "opposite": {"de": "{letters} entgegengesetzt", "en": "{letters} opposite"},
    "phi": {"de": "Kurbelwinkel", "en": "Crank angle"},
    "ratio": {"de": "Kurbelverhältnis R:L", "en": "Crank ratio R:L"},
}


def caption(request: Request, columns: Sequence[Digits], chosen: bool) -> Label:
    """Return the layout's caption with its quantities, the ratio, if there is only one, and the methods.

    A page whose columns the user chose has a caption of its own, for the layout's may speak of others.
    """
    words = for_ratio(request.cranks[0].ratio, request.lang, request.layout.ratio_symbol)
    methods = dict.fromkeys(method for column in columns for method in _methods_of(column.method))
    folded = request.method == "infinite" and not request.cranks[0].ratio
    parts = {
        "{quantities}": enumerated((column.quantity.name[request.lang] for column in columns), request.lang),
        "{for_ratio}": words if len(request.cranks) == 1 and not folded else "",
        "{method}": WORDS["and"][request.lang].join(METHODS[one].caption[request.lang] for one in methods),
    }
    text = PLAIN_CAPTION if chosen else request.layout.caption[request.lang]
    for place, part in parts.items():
        text = text.replace(place, part)
    return text


def for_ratio(ratio: Fraction, lang: str, symbol: str = "R:L") -> Label:
    """Return " für $R:L = 1:5$"."""
    return WORDS["for_ratio"][lang].format(symbol=symbol, ratio=ratio_text(ratio))


def enumerated(quantities: Iterable[str], lang: str) -> str:
    """Return their names, each once: Kolbenweg, Kolbengeschwindigkeit und Kolbenbeschleunigung."""
    names = list(dict.fromkeys(quantities))
    if lang == "en":
        names[1:] = [name.lower() for name in names[1:]]
    return WORDS["and"][lang].join(part for part in (", ".join(names[:-1]), names[-1]) if part)


def notes(request: Request, columns: Sequence[Digits]) -> list[Label]:
    """Return the lines below the table: its own, the formulas, the machine, the offset."""
    lines = [note[request.lang] for note in request.layout.notes]
    if any(column.method == DIFFERENCE for column in columns):
        lines.append(WORDS["difference"][request.lang])
    if request.layout.formulas:
        lines += formula_lines(request, columns)
    lines += _sign_notes(columns, request.lang)
    lines += drive_notes(request.cranks, request.lang)
    lines += dict.fromkeys(force_note(crank.force) for crank in request.cranks if crank.force is not None)
    for crank in request.cranks[:1]:
        if crank.moving is not None:
            lines += moving_notes(crank, request.layout.ratio_symbol, request.lang)
    if request.layout.subject == "inertia":
        shown = {column.quantity.symbol.strip("$") for column in columns}
        lines += rod_notes(request.cranks, request.lang, shown)
    return lines


def _sign_notes(columns: Sequence[Digits], lang: str) -> list[Label]:
    """Return the line about the directions of the forces shown, if there are any."""
    shown = dict.fromkeys(column.quantity.symbol.strip("$") for column in columns if column.quantity.is_force)
    said = [FORCE_SIGNS[letter][lang] for letter in shown if letter in FORCE_SIGNS]
    return ["; ".join(said)] if said else []


def drive_notes(cranks: Sequence[Crank], lang: str) -> list[Label]:
    """Return the lines about lengths and speeds, and those about offsets."""
    lines = [_machine(crank, lang) for crank in cranks if crank.radius is not None]
    return lines + [_offset(crank, lang) for crank in cranks if crank.offset and crank.ratio]


def force_note(force: Fraction) -> Label:
    """Return the line about the piston force in newtons."""
    return f'$F = {_plain(force)} "N"$'


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


def enumerated_letters(letters: Sequence[str], lang: str) -> Label:
    """Return "$X$ and $P$"."""
    *others, last = (f"${letter}$" for letter in letters)
    return ", ".join(others) + WORDS["and"][lang] + last if others else last


def moving_notes(crank: Crank, ratio_symbol: str, lang: str) -> Iterator[Label]:
    """Yield the lines about the moving masses, with the size and the speed that make forces of them."""
    moving, speed, radius = crank.moving, crank.speed, ratio_symbol[0]
    assert moving is not None
    assert speed is not None
    assert crank.radius is not None
    said = {"reciprocating": moving.reciprocating, "rotating": moving.rotating}
    parts = [f'{WORDS[key][lang]} ${_plain(mass)} "kg"$' for key, mass in said.items() if mass]
    value = _plain(60 * speed.value if speed.turns else speed.value)
    turns = f'n = {value} "min"^(-1)' if speed.turns else f'ω = {value} "rad/s"'
    parts += [f'${radius} = {_plain(1000 * crank.radius)} "mm"$', f"${turns}$"]
    yield WORDS["masses"][lang] + ", ".join(parts)
    if moving.rod is not None:
        yield connecting_rod(moving.rod, lang, ratio_symbol[-1])


def connecting_rod(rod: Rod, lang: str, length: str = "L") -> Label:
    """Return the line about a rod: where its masses are, and its mass if that is known."""
    from kurbel.kernel.circle import root

    def gyration(numbers: Numbers) -> Any:
        return root(numbers.of(rod.gyration_square))

    return WORDS["connecting_rod"][lang].format(
        length=length,
        centre=_plain(1 - rod.centre),
        gyration=_root(rod.gyration_square) or _certified(gyration, 4, algebraic=True),
        couple=_plain(rod.couple),
        mass=f', $M = {_plain(rod.mass)} "kg"$' if rod.mass is not None else "",
    )


def _root(square: Fraction) -> str:
    """The square root of a fraction that has a short one, else nothing."""
    from math import isqrt

    root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    return _plain(root) if root * root == square and finite_decimals(root) is not None else ""


def axis_fields(request: Request, decimals: int | None) -> dict[str, Field]:
    lang = request.lang
    return {
        "ratio": Field("ratio", WORDS["ratio"][lang], f"${request.layout.ratio_symbol}$"),
        "phi": Field("phi", WORDS["phi"][lang], f"${request.layout.angle_symbol}$", "°", decimals),
    }


def quantity_name(quantity: Quantity, lang: str) -> str:
    return f"{quantity.name[lang]}, {quantity.part[lang]}"


def formula_lines(request: Formulated, columns: Sequence[Digits]) -> Iterator[Label]:
    """Yield the formulas of the columns, each once, and what their signs mean."""
    finite = [crank for crank in request.cranks if crank.ratio]
    offset = any(crank.offset for crank in finite)
    if any(crank.moving for crank in request.cranks):
        # What the masses add has no formula that a line holds.
        columns = [column for column in columns if column.quantity.loaded is None]
    if not columns:
        return
    strokes = {column.quantity.stroke for column in columns}
    sign = "±" if len(strokes) > 1 else "+" if strokes == {OUT} else "-"
    pairs = dict.fromkeys(
        # Where no rod is finite, the formulas that divide by λ say nothing.
        (method if finite else "infinite", column.quantity.symbol.strip("$"))
        for column in columns
        for method in _methods_of(column.method)
    )
    methods = dict.fromkeys(method for method, _ in pairs)
    for method in methods:
        table = OFFSET_FORMULAS if offset else FORMULAS[method]
        formulas = [table.get(symbol, "") for one, symbol in pairs if one == method]
        line = ", ".join(part for part in (*formulas, SYMBOLS["offset" if offset else method]) if part)
        name = f"{METHODS[method].caption[request.lang]}: " if len(methods) > 1 else ""
        yield name + _filled(line, request, sign, (method, "ψ") in pairs)
    if RETURN in strokes and offset:
        yield _filled(WORDS["offset_return"][request.lang], request, sign, False)
    elif sign == "±" and any(_has_signs(FORMULAS[method].get(symbol, "{±}")) for method, symbol in pairs):
        yield WORDS["signs"][request.lang]


def _has_signs(formula: str) -> bool:
    return any(place in formula for place in ("{±}", "{ψ}", "{guide}", "{slant}"))


def _methods_of(method: str) -> tuple[str, ...]:
    return ("exact", "series") if method == DIFFERENCE else (method,)


def _filled(line: str, request: Formulated, sign: str, rod_angle: bool) -> Label:
    # A rod angle with a sign of its own needs none in the formulas that have it.
    signed = f"{sign} " if sign != "+" else ""
    parts = {
        "{±}": sign,
        "{ψ}": signed if rod_angle else "",
        "{guide}": "" if rod_angle else signed,
        "{slant}": "+" if rod_angle else sign,
        "{angle}": request.layout.angle_symbol,
        "{ratio}": request.layout.ratio_symbol.replace(":", "/"),
    }
    for place, part in parts.items():
        line = line.replace(place, part)
    return line


def _machine(crank: Crank, lang: str) -> Label:
    assert crank.radius is not None
    rod = WORDS["rod"][lang].format(rod=_plain(1000 * crank.radius / crank.ratio)) if crank.ratio else ""
    speed = _speed(crank, lang) if crank.speed else ""
    return WORDS["machine"][lang].format(radius=_plain(1000 * crank.radius), rod=rod, speed=speed)


def _speed(crank: Crank, lang: str) -> str:
    speed = crank.speed
    assert speed is not None
    turns, radians = f'$n = {_plain(speed.value * 60)} "min"^(-1)$', f'$ω = {_plain(speed.value)} "rad/s"$'
    quotient = _certified(lambda numbers: numbers.pi / _stroke(crank, numbers), 4, algebraic=False)
    return WORDS["speed"][lang].format(
        turns=f"{turns if speed.turns else radians}, ",
        pin=_certified(lambda numbers: pin_velocity(crank, numbers), 3, algebraic=not speed.turns),
        mean=_certified(lambda numbers: _mean_speed(crank, numbers), 3, algebraic=speed.turns),
        quotient=quotient if crank.offset else "π:2",
    )


def _mean_speed(crank: Crank, numbers: Numbers) -> Any:
    """c_m in m/s. Of turns it is S n/30, without the π that the crank-pin velocity has."""
    speed, radius = crank.speed, crank.radius
    assert speed is not None
    assert radius is not None
    if speed.turns:
        stroke = _stroke(crank, numbers) * numbers.of(radius)
        return kinematics.mean_piston_speed(stroke, numbers.of(60 * speed.value))
    return pin_velocity(crank, numbers) * kinematics.mean_piston_velocity(_stroke(crank, numbers), numbers.pi)


def _stroke(crank: Crank, numbers: Numbers) -> Any:
    if not crank.offset:
        return numbers.of(Fraction(2))
    return kinematics.stroke(numbers.of(crank.ratio), numbers.of(crank.offset))


def _offset(crank: Crank, lang: str) -> Label:
    from kurbel.exact.certify import ball_degrees

    def dead_centre(sign: int) -> Any:
        def degrees(numbers: Any) -> Any:
            sine = kinematics.dead_centre_sine(
                numbers.of(sign * crank.ratio), numbers.of(sign * crank.offset)
            )
            return ball_degrees(sine) + (0 if sign == OUT else 180)

        return degrees

    return WORDS["offset"][lang].format(
        offset=_plain(crank.offset),
        ratio=ratio_text(crank.ratio),
        inner=_certified(dead_centre(OUT), 3, algebraic=False),
        outer=_certified(dead_centre(RETURN), 3, algebraic=False),
        stroke=_certified(lambda numbers: _stroke(crank, numbers), 4, algebraic=True),
    )


def _certified(value: Callable[[Numbers], Any], decimals: int, algebraic: bool) -> str:
    """The digits of a value that is either algebraic or an arc or a multiple or fraction of π."""
    from kurbel.exact.certify import NEVER_TIES, rounded
    from kurbel.exact.separation import Separation

    def tie_bits(boundary: Fraction) -> float:
        bound = value(Numbers(Separation.rational)) - Separation.rational(boundary)
        return float(bound.bits())

    scaled = rounded(
        lambda: value(numbers_of_balls()), decimals, "half-away", tie_bits if algebraic else NEVER_TIES
    )
    return number_text(Number(scaled, decimals))


def _plain(value: Fraction) -> str:
    """The exact decimal or fraction where there is a short one, else three places."""
    decimals = finite_decimals(value)
    if decimals is not None and decimals <= 6:
        return plain(value)
    if value.denominator < 1000:
        return f"{value.numerator}/{value.denominator}"
    return number_text(nearest(value, 3))
