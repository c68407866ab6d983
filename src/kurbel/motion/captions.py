"""What pages about motion say, in both languages: caption, formulas, signs, what is known of the drive."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Any, Protocol

from kurbel.drive.at import known
from kurbel.drive.crank import Crank
from kurbel.drive.load import figure
from kurbel.exact.kind import Kind, settled
from kurbel.exact.numerals import Label, Number, number_text
from kurbel.motion.evaluation import (
    DIFFERENCE,
    LOADED,
    OFFSET,
    OUT,
    REACH,
    RETURN,
    STROKES,
    TURN,
    method_named,
)
from kurbel.page.quantity import (
    AND,
    Column,
    Quantity,
    Words,
    enumerated,
    filled,
    for_ratio,
    words,
)
from kurbel.reading.amounts import amount, unit_of_page
from kurbel.reading.notation import ratio_text

if TYPE_CHECKING:
    from kurbel.motion.page import AngleQuestion, Request
    from kurbel.page.layouts import Layout
    from kurbel.reading.units import Speed


class Formulated(Protocol):
    """What formulas are printed for: cranks, on a page with its letters and its language."""

    @property
    def cranks(self) -> tuple[Crank, ...]: ...
    @property
    def layout(self) -> Layout: ...
    @property
    def lang(self) -> str: ...


# Below the formulas of a method; {ψ} as in motion/quantities.py.
SYMBOLS = {
    "exact": "$sin ψ = {ψ}λ sin {angle}$, $λ = {ratio}$",
    "series": "$λ = {ratio}$",
    "infinite": "",
    **dict.fromkeys(REACH, "$λ = {ratio}$"),
    "offset": "$sin ψ = λ (sin {angle} - e/R)$, $λ = {ratio}$",
}
# What differs between the strokes in printed formulas, as motion/entries.py and quantities.py say.
_SIGNED = ("{±}", "{sign}", "{turned}", "{ψ}", "{guide}", "{slant}")
# For columns that the layout's own caption does not know.
PLAIN_CAPTION = "{quantities}{for_ratio}; {method}"
WORDS: Mapping[str, Words] = {
    "offset": words(
        "Geschränkt, $e = {offset} R$, $R:L = {ratio}$: Totlagen $φ_i = {inner}°$ und $φ_o = {outer}°$, Hub "
        "${stroke} R$"
        "|Offset $e = {offset} R$, $R:L = {ratio}$: dead centres at $φ_i = {inner}°$ and $φ_o = {outer}°$, "
        "stroke ${stroke} R$"
    ),
    "speed": words(
        "; {turns}$v = {pin} {unit}$, mittlere Kolbengeschwindigkeit $c_m = {mean} {unit}$, $v:c_m = "
        "{quotient}$"
        "|; {turns}$v = {pin} {unit}$, mean piston speed $c_m = {mean} {unit}$, $v:c_m = {quotient}$"
    ),
    "masses": words("Massen: |Masses: "),
    "weightless": words(
        "Gewicht der Massen nicht gerechnet (--slope)|Weight of the masses left out (--slope)"
    ),
    "reciprocating": words("Kolben und Kreuzkopf|piston and crosshead"),
    "rotating": words("Kurbel weniger Gegengewicht, am Zapfen|crank less counterweight, at its pin"),
    "connecting_rod": words(
        "Schubstange: Schwerpunkt $a = {centre} {length}$ vom Kreuzkopfzapfen, $k = {gyration} {length}$, "
        "$k^2 - a b = {couple} {length}^2${mass}"
        "|Rod: centre of mass $a = {centre} {length}$ from the crosshead pin, $k = {gyration} {length}$, "
        "$k^2 - a b = {couple} {length}^2${mass}"
    ),
    "swing": words(
        '; $k$ aus der Dauer ${time} "s"$ einer Schwingung hin und her um {pin}'
        '|; $k$ from the time ${time} "s"$ of a swing to and fro about {pin}'
    ),
    "swing_crosshead": words("den Kreuzkopfzapfen|the crosshead pin"),
    "swing_crank": words("den Kurbelzapfen|the crank pin"),
    "outward": words(
        "jenseits des äußeren Totpunkts bleiben die Richtungen die des Hingangs"
        "|beyond the outer dead centre directions remain those of the outstroke"
    ),
    "difference": words(
        "Unterschied: genauer Wert weniger Näherung, vor dem Runden gebildet."
        "|Difference: exact value less first order, taken before rounding."
    ),
    "signs": words(
        "oberes Zeichen: Hingang, unteres Zeichen: Rückgang|upper sign: outstroke, lower sign: return stroke"
    ),
    "offset_return": words(
        "Rückgang bei $180° + {angle}$, vom äußeren Totpunkt und in Richtung des Rückgangs gerechnet"
        "|Return at $180° + {angle}$, counted from the outer dead centre in the direction of the return"
    ),
}


def caption(question: Request, chosen: bool | None = None) -> Label:
    """Return the layout's caption with its quantities, the ratio, if there is only one, and the methods.

    A page whose columns the user chose has a caption of its own, for the layout's may speak of others; so it
    has for drawings.
    """
    layout, lang, columns = question.layout, question.lang, question.page_columns
    methods = dict.fromkeys(method for column in columns for method in _methods_of(column.method))
    folded = question.method == "infinite" and not question.cranks[0].ratio
    one = len(question.cranks) == 1 and not folded
    # What is called that of a stroke does not fit a page of whole turns.
    of_stroke = question.whole_turns and STROKES[OUT][lang] in layout.caption[lang]
    own = of_stroke or _is_chosen(question) if chosen is None else chosen
    parts = {
        "{quantities}": enumerated((column.quantity.name[lang] for column in columns), lang),
        "{for_ratio}": for_ratio(question.cranks[0].ratio, lang, layout.ratio_symbol) if one else "",
        "{method}": AND[lang].join(method_named(key).caption[lang] for key in methods),
    }
    return filled(PLAIN_CAPTION if own else layout.caption[lang], parts.items())


def _is_chosen(question: Request) -> bool:
    """Whether the layout's caption does not fit the columns that were chosen."""
    shown = {column.key for column in question.page_columns}
    own = {column.key for column in question.layout.columns}
    # All forces of the rod are what the caption of a page about them speaks of.
    own |= {key for key, quantity in question.subject.quantities().items() if quantity.of}
    # A fixed page's caption names its formulas, all of them.
    return bool(question.columns) and (not shown <= own or (question.layout.fixed and shown < own))


def notes(question: Request) -> Iterator[Label]:
    """Yield the lines below the table: its own, the formulas, the machine, the offset."""
    layout, lang, columns = question.layout, question.lang, question.page_columns
    yield from (note[lang] for note in layout.notes)
    if any(column.method == DIFFERENCE for column in columns):
        yield WORDS["difference"][lang]
    if layout.formulas:
        yield from formula_lines(question, columns)
    if said := dict.fromkeys(one.quantity.direction[lang] for one in columns if one.quantity.direction):
        yield "; ".join(said)
        yield from direction_notes(question, columns)
    sizes = drive_notes(question.cranks, lang)
    yield from sizes
    first_order = any(one.method in ("series", DIFFERENCE) for one in columns)
    if first_order or any(crank.acceleration for crank in question.cranks):
        from kurbel.motion.notes.accelerated import lines

        yield from lines(question, columns)
    yield from force_notes(question.cranks, lang)
    for crank in question.cranks[:1]:
        yield from loaded_notes(crank, layout.ratio_symbol, lang, sizes)


def direction_notes(question: AngleQuestion, columns: Sequence[Column]) -> Iterator[Label]:
    """Yield the line about columns of the outstroke at angles of the return."""
    by_stroke = any(one.stroke == RETURN for one in question.subject.quantities().values())
    directed = any(one.quantity.stroke == OUT and one.quantity.direction for one in columns)
    if by_stroke and directed and question.whole_turns:
        yield WORDS["outward"][question.lang]


def formula_lines(page: Formulated, columns: Sequence[Column]) -> Iterator[Label]:
    """Yield the formulas of the columns, each once, and what their signs mean."""
    finite = [crank for crank in page.cranks if crank.ratio]
    offset = any(crank.offset for crank in finite)
    if any(crank.loaded for crank in page.cranks):
        # What the masses add has no formula that a line holds.
        columns = [column for column in columns if LOADED not in column.quantity.formulas]
    if not columns:
        return
    strokes, sign = strokes_of(columns)
    shown = {
        # Where no rod is finite, the formulas that divide by λ say nothing.
        (method if finite else "infinite", column.quantity.symbol): column.quantity
        for column in columns
        for method in _methods_of(column.method)
    }
    methods = dict.fromkeys(method for method, _ in shown)
    for method in methods:
        key = OFFSET if offset else method
        formulas = [_printed(quantity, key) for (one, _), quantity in shown.items() if one == method]
        line = ", ".join(part for part in (*formulas, SYMBOLS[key]) if part)
        name = f"{method_named(method).caption[page.lang]}: " if len(methods) > 1 else ""
        yield name + signed(line, page, sign, (method, "$ψ$") in shown)
    if RETURN in strokes and offset:
        yield signed(WORDS["offset_return"][page.lang], page, sign, False)
    elif sign == "±" and any(_has_signs(_printed(one, method)) for (method, _), one in shown.items()):
        yield WORDS["signs"][page.lang]


def strokes_of(columns: Sequence[Column]) -> tuple[set[int], str]:
    """Return the strokes of the columns, and the sign that formulas of these have."""
    strokes = {column.quantity.stroke for column in columns} - {TURN}
    return strokes, "±" if len(strokes) > 1 else "+" if strokes == {OUT} else "-"


def _printed(quantity: Quantity, key: str) -> Label:
    found = quantity.formulas.get(key)
    if found and key in REACH:
        from kurbel.motion.series.printed import with_terms

        return with_terms(found.printed, REACH[key])
    return found.printed if found else ""


def _has_signs(formula: Label) -> bool:
    """Whether the strokes differ in the formula; of what states none, in those that it follows from."""
    return not formula or any(place in formula for place in _SIGNED)


def _methods_of(method: str) -> tuple[str, ...]:
    return ("exact", "series") if method == DIFFERENCE else (method,)


def signed(line: Label, page: Formulated, sign: str, rod_angle: bool) -> Label:
    # A rod angle with a sign of its own needs none in the formulas that have it.
    signed = f"{sign} " if sign != "+" else ""
    parts = {
        "{±}": sign,
        "{sign}": signed,
        "{turned}": {"+": "-", "-": "", "±": "∓ "}[sign],
        "{ψ}": signed if rod_angle else "",
        "{guide}": "" if rod_angle else signed,
        "{slant}": "+" if rod_angle else sign,
        "{angle}": page.layout.angle_symbol,
        "{ratio}": page.layout.ratio_symbol.replace(":", "/"),
    }
    return filled(line, parts.items())


def drive_notes(cranks: Sequence[Crank], lang: str) -> list[Label]:
    """Return the lines about lengths and speeds, and those about offsets."""
    speeds = [_speed(crank, lang) if crank.speed else "" for crank in cranks if crank.radius is not None]
    lines = [size + speed for size, speed in zip(size_notes(cranks), speeds, strict=True)]
    return lines + offset_notes(cranks, lang)


def size_notes(cranks: Iterable[Crank]) -> list[Label]:
    """Return the lines about lengths alone, of drives of which neither offset nor mean speed is a slide's."""
    return [_size(crank, crank.radius) for crank in cranks if crank.radius is not None]


def offset_notes(cranks: Sequence[Crank], lang: str) -> list[Label]:
    """Return the lines about offsets: the dead centres and the stroke."""
    return [_offset(crank, lang) for crank in cranks if crank.offset and crank.ratio]


def force_notes(cranks: Sequence[Crank], lang: str) -> Iterable[Label]:
    """Return the lines about the piston forces."""
    return dict.fromkeys(crank.force.note(lang) for crank in cranks if crank.force is not None)


def loaded_notes(crank: Crank, ratio_symbol: str, lang: str, sizes: Iterable[Label] = ()) -> Iterator[Label]:
    """Yield the lines about what acts on piston and crosshead beside a given force, and about the masses."""
    if crank.effort is not None:
        from kurbel.motion.notes.effort import effort_notes

        yield from effort_notes(crank.effort, lang)
    if crank.moving is not None:
        yield from moving_notes(crank, ratio_symbol, lang, sizes=sizes)
        if crank.moving.slope is None and (crank.moving.rod or crank.moving.reciprocating):
            yield WORDS["weightless"][lang]


def moving_notes(
    crank: Crank,
    ratio_symbol: str,
    lang: str,
    named: Mapping[str, Words] = WORDS,
    sizes: Iterable[Label] = (),
) -> Iterator[Label]:
    """Yield the lines about the moving masses, with the size and the speed that make forces of them, unless
    the lines above with `sizes` have these.

    A drive without a crosshead has names of its own for where they are.
    """
    moving, speed, radius = known(crank.moving), known(crank.speed), ratio_symbol[0]
    said = {"reciprocating": moving.reciprocating, "rotating": moving.rotating}
    parts = [f"{named[key][lang]} ${amount(mass, 'kg')}$" for key, mass in said.items() if mass]
    if moving.rocker:
        parts.append(f"{named['rocker'][lang]} $J = {amount(moving.rocker, 'kg m²')}$")
    makes_forces = f"${radius} = {amount(known(crank.radius), 'mm')}$", turns_label(speed)
    parts += (one for one in makes_forces if not any(one in line for line in sizes))
    yield WORDS["masses"][lang] + ", ".join(parts)
    if moving.rod is not None:
        from kurbel.motion.notes.rod import connecting_rod

        yield connecting_rod(moving.rod, lang, ratio_symbol[-1], named)
    if moving.slope is not None:
        from kurbel.motion.notes.effort import weight_notes

        yield from weight_notes(moving, lang)


def _size(crank: Crank, radius: Fraction) -> Label:
    rod = f", $L = {amount(radius / crank.ratio, 'mm')}$" if crank.ratio else ""
    return f"$R = {amount(radius, 'mm')}${rod}"


def _speed(crank: Crank, lang: str) -> str:
    speed = known(crank.speed)
    quotient = digits_text(crank.pin_to_mean, 4)
    times, unit = unit_of_page("m/s")
    return WORDS["speed"][lang].format(
        unit=unit,
        turns=f"{turns_label(speed)}, ",
        pin=digits_text(_times(crank.pin_velocity, times), 3),
        mean=digits_text(_times(crank.mean_velocity, times), 3),
        quotient=quotient if crank.offset else "π:2",
    )


def _times(value: Callable[[Kind], Any], factor: Fraction) -> Callable[[Kind], Any]:
    return value if factor == 1 else lambda numbers: value(numbers) * numbers.of(factor)


def turns_label(speed: Speed) -> Label:
    """Return the speed as it was given, as n or ω."""
    value = figure(60 * speed.value if speed.turns else speed.value)
    return f'$n = {value} "min"^(-1)$' if speed.turns else f'$ω = {value} "rad/s"$'


def _offset(crank: Crank, lang: str) -> Label:
    def outer(numbers: Kind) -> Any:
        return crank.dead_angle(RETURN, numbers) + 180

    return WORDS["offset"][lang].format(
        offset=figure(crank.offset),
        ratio=ratio_text(crank.ratio),
        inner=digits_text(partial(crank.dead_angle, OUT), 3),
        outer=digits_text(outer, 3),
        stroke=digits_text(crank.stroke, 4),
    )


def digits_text(value: Callable[[Kind], Any], decimals: int) -> str:
    """Return the digits of a value."""
    return number_text(Number(settled(value, decimals), decimals))
