"""What a page of the arc crank or the parallel crank says of itself, in both languages."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from kurbel.exact.kind import Kind, balls
from kurbel.exact.numerals import Label, Number, finite_decimals, number_text
from kurbel.linkage import evaluation as linkage
from kurbel.linkage.arc import ArcCrank
from kurbel.linkage.parallel import CHANGE_POINTS
from kurbel.linkage.quantities import FORCE, LEFT
from kurbel.motion.captions import WORDS as MOTION_WORDS
from kurbel.motion.drive_notes import drive_notes, force_note
from kurbel.motion.evaluation import OUT, RETURN
from kurbel.page.quantity import AND, Formula, Quantity, Words, enumerated, filled, words
from kurbel.reading.notation import plain, ratio_text

if TYPE_CHECKING:
    from kurbel.linkage.page import LinkageRequest

# {±} belongs to the stroke, {β±} to the stroke and the side of the pivot, {β+} and {β-} to that side alone.
CLOSURE = "${lead}R cos φ + L cos ψ = D {β+} B sin θ$, ${lead}R sin φ - L sin ψ = H {β-} B cos θ$"
SIGNS = {("", 1): "+", ("", -1): "-", ("both", 1): "±", ("both", -1): "∓"}
WORDS: Mapping[str, Words] = {
    "for": words(" für {drive}| for {drive}"),
    "closure": words(
        "{closure}; Schwinge $B$, ihr Drehpunkt von der Welle $D$ längs und $H$ quer zur Schubrichtung"
        "|{closure}; rocker $B$, its pivot $D$ along and $H$ across the slide direction from the shaft"
    ),
    "angles": words(
        "$θ$ im Drehsinn der Kurbel von der Lage der Schwinge quer zur Schubrichtung, $ψ$ im "
        "entgegengesetzten von der Schubrichtung"
        "|$θ$ in the crank's sense from the rocker's position square to the slide direction, $ψ$ in the "
        "opposite one from the slide direction"
    ),
    "radians": words("; in $x$ im Bogenmaß|; in $x$ in radians"),
    "dead_centres": words(
        "{drive}: Totlagen $φ_i = {inner}°$ und $φ_o = {outer}°$, Schwingungswinkel ${swing}°$, Hub auf dem "
        "Bogen ${stroke} R$, Zeitverhältnis Hingang zu Rückgang ${times}:1$, kleinster Übertragungswinkel "
        "${least}°$"
        "|{drive}: dead centres at $φ_i = {inner}°$ and $φ_o = {outer}°$, swing ${swing}°$, stroke along "
        "the arc ${stroke} R$, times of outstroke and return ${times}:1$, least transmission angle "
        "${least}°$"
    ),
    "coupler": words(
        "Jeder Punkt der Koppel läuft auf einem Kreis vom Halbmesser $R$; $y$ ist zur Seite des "
        "Kurbelzapfens beim Hingang gerechnet"
        "|Every point of the coupling rod moves on a circle of radius $R$; $y$ counts to the side of the "
        "crank pin during the outstroke"
    ),
    "arc_force": words(
        "$F$ längs des Bogens, in der Richtung des Hubes|$F$ along the arc, in the direction of the stroke"
    ),
    "coupler_force": words(
        "$F$ von der Koppel auf den Kurbelzapfen, längs der Wellenlinie, positiv wie der Weg beim Hingang"
        "|$F$ of the coupling rod on the crank pin, along the line of shafts, positive as the path of the "
        "outstroke"
    ),
    "change_points": words(
        "Bei {points} liegen alle Glieder in einer Linie; dort kann die zweite Kurbel umschlagen "
        "(Antiparallelkurbel)"
        "|At {points} all links lie in line; there the second crank may turn back (antiparallel crank)"
    ),
}


def caption(request: LinkageRequest) -> Label:
    """Return the layout's caption with its quantities and the lengths that all drives have in common."""
    lang = request.lang
    parts = {
        "{quantities}": enumerated((one.quantity.name[lang] for one in request.page_columns), lang),
        "{for_drive}": WORDS["for"][lang].format(drive=_common(request)) if request.cranks else "",
    }
    return filled(request.layout.caption[lang], parts.items())


def _common(request: LinkageRequest) -> Label:
    crank = request.cranks[0]
    ratio = [f"$R:L = {ratio_text(crank.crank.ratio)}$"] if len(request.cranks) == 1 else []
    return ", ".join([*ratio, f"$B = {_length(crank.rocker)} R$"])


def notes(request: LinkageRequest) -> Iterator[Label]:
    """Yield the lines below the table: the formulas, and what each drive does between its dead centres."""
    if not request.cranks:
        yield from _coupler_notes(request)
        yield from _force_notes(request)
        return
    yield from _formula_lines(request)
    yield from _force_notes(request)
    yield from (_dead_centres(crank, request.lang) for crank in request.cranks)


def _force_notes(request: LinkageRequest) -> Iterator[Label]:
    """Yield in which directions forces are positive, and what makes newtons of them."""
    lang, shown = request.lang, [column.quantity for column in request.page_columns]
    if any(one.of == FORCE for one in shown):
        said = WORDS["arc_force" if request.cranks else "coupler_force"][lang]
        yield "; ".join(dict.fromkeys([said, *(one.direction[lang] for one in shown if one.direction)]))
    cranks = [replace(drive.crank, offset=Fraction(0)) for drive in request.drives]
    yield from drive_notes(cranks, lang)
    yield from dict.fromkeys(force_note(crank.force) for crank in cranks if crank.force is not None)


def _coupler_notes(request: LinkageRequest) -> Iterator[Label]:
    lang = request.lang
    points = AND[lang].join(f"${plain(angle)}°$" for angle in CHANGE_POINTS)
    # A page says what its layout shows, though not all of it was chosen.
    own = (request.entry(column.quantity) for column in request.layout.columns)
    shown = (
        *(one for one in own if not request.missing(one)),
        *(column.quantity for column in request.page_columns),
    )
    yield ", ".join(dict.fromkeys(one.formulas["exact"].printed for one in shown))
    if any(one.of != FORCE for one in shown):
        yield WORDS["coupler"][lang]
    yield WORDS["change_points"][lang].format(points=points)


def _formula_lines(request: LinkageRequest) -> Iterator[Label]:
    lang, columns = request.lang, request.page_columns
    strokes = {column.quantity.stroke for column in columns}
    side = 1 if request.cranks[0].curvature > 0 else -1
    shown = [(column.quantity, _formula(column.quantity, side)) for column in columns]
    printed = [_with_stroke(formula.printed, one, lang) for one, formula in shown if formula.printed]
    # The path's, which tells the strokes apart by name, comes first.
    printed.sort(key=lambda line: line.startswith("$"))
    symbols = (symbol for _, formula in shown for symbol in formula.symbols)
    if line := ", ".join(dict.fromkeys((*printed, *symbols))):
        yield _signed(line, strokes, side)
    if any(crank.crank.ratio for crank in request.cranks):
        yield WORDS["closure"][lang].format(closure=_signed(CLOSURE, strokes, side))
    forces = all(column.quantity.of == FORCE for column in columns)
    yield WORDS["angles"][lang] + ("" if forces else WORDS["radians"][lang])
    if RETURN in strokes:
        yield MOTION_WORDS["offset_return"][lang].replace("{angle}", request.layout.angle_symbol)
    if len(strokes) > 1:
        yield MOTION_WORDS["signs"][lang]


def _formula(quantity: Quantity, side: int) -> Formula:
    """Return the formula as it is printed with the pivot on this side."""
    return quantity.formulas[LEFT if side < 0 and LEFT in quantity.formulas else "exact"]


def _with_stroke(printed: Label, quantity: Quantity, lang: str) -> Label:
    assert quantity.part is not None
    return printed.replace("{part}", quantity.part[lang])


def _signed(line: Label, strokes: set[int], side: int) -> Label:
    stroke, many = min(strokes), "both" if len(strokes) > 1 else ""
    upper = 1 if many else stroke
    parts = {
        "{±}": SIGNS[many, upper],
        "{lead}": "" if (many, upper) == ("", OUT) else f"{SIGNS[many, upper]} ",
        "{β±}": SIGNS[many, upper * side],
        "{β+}": SIGNS["", side],
        "{β-}": SIGNS["", -side],
    }
    return filled(line, parts.items())


def _dead_centres(crank: ArcCrank, lang: str) -> Label:
    angle, share = 3, 4
    return WORDS["dead_centres"][lang].format(
        drive=", ".join(_links(crank)),
        inner=_printed(lambda kind: linkage.dead_angle(crank, OUT, kind), angle),
        outer=_printed(lambda kind: linkage.dead_angle(crank, RETURN, kind) + 180, angle),
        swing=_printed(lambda kind: linkage.swing(crank, kind), angle),
        stroke=_printed(lambda kind: linkage.arc_stroke(crank, kind), share),
        times=_printed(lambda kind: linkage.time_ratio(crank, kind), share),
        least=_printed(lambda kind: linkage.least_transmission(crank, kind), angle),
    )


def _links(crank: ArcCrank) -> Sequence[Label]:
    ratio = crank.crank.ratio
    distance = crank.distance or (1 / ratio if ratio else None)
    lengths = {"B": crank.rocker, "D": distance, "H": crank.pivot_height}
    known = (f"${letter} = {_length(length)} R$" for letter, length in lengths.items() if length is not None)
    return [f"$R:L = {ratio_text(ratio)}$", *known]


def _length(length: Fraction) -> str:
    return (
        plain(length) if finite_decimals(length) is not None else f"{length.numerator}/{length.denominator}"
    )


def _printed(value: Callable[[Kind], Any], decimals: int) -> str:
    """The digits of an angle in degrees to 3 decimals, or of the stroke or the time ratio to 4.

    No value lies on a rounding boundary. Sine and cosine of the angles have at most degree 4 over the
    rationals, those of a boundary, a k/n of a turn with n a multiple of 128, at least 32. The stroke is
    transcendental (Lindemann). The time ratio (180° + Δ)/(180° - Δ) is transcendental (Gelfond-Schneider)
    or, where Δ is m/n of a turn, (n + 2 m)/(n - 2 m) with φ(n) <= 8, hence n <= 30: no denominator of a
    reduced one is a multiple of 32.
    """
    from kurbel.exact import certify

    scaled = certify.rounded(lambda: value(balls()), decimals, "half-away", certify.NEVER_TIES)
    return number_text(Number(scaled, decimals))
