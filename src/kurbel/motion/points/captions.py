"""What a page about points of the rod says of itself, in both languages."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from kurbel.exact.numerals import Label
from kurbel.motion.captions import formula_lines
from kurbel.motion.evaluation import METHODS, OFFSET
from kurbel.motion.points.quantities import (
    BESIDE,
    DIRECTION,
    Vectorial,
    acceleration,
    path,
    vector_of,
    velocity,
)
from kurbel.motion.quantities import registry
from kurbel.page.quantity import Quantity, Words, bare, enumerated, filled, for_ratio, words

if TYPE_CHECKING:
    from kurbel.motion.points.page import PointsRequest

WORDS: Mapping[str, Words] = {
    "one": words("des Punktes {point} der {rod}|of the point {point} of the {rod}"),
    "several": words("von Punkten der {rod}|of points of the {rod}"),
    "rod": words("Schubstange|connecting rod"),
    "parallel": words("Koppel|coupling rod"),
    "point": words(
        "$s$ vom {driven} $B$ ($s = 0$) zum Kurbelzapfen $A$ ($s = 1$), in Stangenlängen"
        "|$s$ from the {driven} $B$ ($s = 0$) to the crank pin $A$ ($s = 1$), in rod lengths"
    ),
    "beside": words(
        "; $t$ quer zur Stange, ebenso, nach der Seite des Kurbelzapfens beim Hingang"
        "|; $t$ beside its axis, likewise, on the side of the crank pin during the outstroke"
    ),
    "crosshead": words("Kreuzkopfzapfen|crosshead pin"),
    "rocker": words("Zapfen der Schwinge|pin of the rocker"),
    "along": words(
        "$ξ$ längs der Schubrichtung nach der Welle hin, vom Ort des Punktes im inneren Totpunkt an"
        "|$ξ$ along the slide towards the shaft, from where the point is at the inner dead centre"
    ),
    "across": words(
        "$η$ von der Geraden durch die Welle in der Schubrichtung an, nach der Seite des Kurbelzapfens beim"
        " Hingang"
        "|$η$ from the line through the shaft along the slide, to the side of the crank pin during the"
        " outstroke"
    ),
    "shafts": words(
        "$ξ$ längs der Wellenlinie, von $φ = 0$ an in der Richtung des Hinganges; $η$ quer, nach der Seite"
        " des Kurbelzapfens beim Hingang"
        "|$ξ$ along the line of shafts, from $φ = 0$ in the direction of the outstroke; $η$ square to it, to"
        " the side of the crank pin during the outstroke"
    ),
    "signs": words(
        "Geschwindigkeiten und Beschleunigungen in denselben Richtungen positiv"
        "|velocities and accelerations positive in the same directions"
    ),
    "directions": words(
        "$γ$ wie $φ$ gezählt, von der Richtung der Welle zum inneren Totpunkt im Drehsinn der Kurbel"
        "|$γ$ counted as $φ$, from the direction of the shaft to the inner dead centre, as the crank turns"
    ),
    "ellipse": words(
        "Die Punkte einer unendlich langen Stange laufen auf Ellipsen mit den Halbachsen $R$ längs und $s R$"
        " quer"
        "|The points of an infinitely long rod run on ellipses of the semi-axes $R$ along and $s R$ across"
    ),
    "vectors": words(
        "Jeder Vektor des Punktes ist $1 - s$ mal der des Endes $B$ und $s$ mal der des Kurbelzapfens $A$"
        "|Every vector of the point is $1 - s$ times that of the end $B$ and $s$ times that of the crank pin"
        " $A$"
    ),
    "turned": words(
        ", dazu $t$ mal der von $B$ nach $A$, um $90°$ gedreht"
        "|, and $t$ times that from $B$ to $A$, turned by $90°$"
    ),
    "circle": words(
        "Jeder Punkt der Koppel läuft wie der Kurbelzapfen, auf einem Kreis vom Halbmesser $R$; $η$ zählt von"
        " dessen Mitte an"
        "|Every point of the coupling rod moves as the crank pin, on a circle of radius $R$; $η$ counts from"
        " its centre"
    ),
}


def caption(question: PointsRequest) -> Label:
    """Return the layout's caption with its quantities, the point or points, the ratio and the method."""
    lang, layout, points = question.lang, question.layout, question.points
    rod = WORDS["rod" if question.has_ratio else "parallel"][lang]
    of = WORDS["one" if len(points) == 1 else "several"][lang].format(point=points[0].label, rod=rod)
    ratios = question.ratios
    one = len(ratios) == 1 and question.method != "infinite"
    parts = {
        "{quantities}": enumerated((column.quantity.name[lang] for column in question.page_columns), lang),
        "{points}": of,
        "{for_ratio}": for_ratio(ratios[0], lang, layout.ratio_symbol) if one else "",
        "{method}": METHODS[question.method or "exact"].caption[lang],
    }
    return filled(layout.caption[lang], parts.items())


def notes(question: PointsRequest) -> Iterator[Label]:
    """Yield the lines below the table: where the point is, formulas, zeros and signs, the machine."""
    lang, layout = question.lang, question.layout
    yield from (note[lang] for note in layout.notes)
    shown = [column.quantity for column in question.page_columns]
    beside = any(one.beside for one in question.points)
    driven = WORDS["crosshead" if question.mechanism.crosshead else "rocker"][lang]
    if question.has_ratio:
        said = WORDS["point"][lang].format(driven=driven)
        yield said + (WORDS["beside"][lang] if beside else "")
    if layout.formulas:
        yield from _formulas(question, shown)
    yield from _directions(question, shown)
    yield from question.mechanism.rod_notes(question.drives, lang)
    if question.mechanism.crosshead and not all(question.ratios):
        yield WORDS["ellipse"][lang]


def _formulas(question: PointsRequest, shown: Sequence[Quantity]) -> Iterator[Label]:
    """Yield how the point's vectors follow from those of the ends of the rod."""
    lang, beside = question.lang, any(one.beside for one in question.points)
    if not question.has_ratio:
        yield WORDS["circle"][lang]
        return
    if question.mechanism.crosshead:
        offset = any(one.crank.offset for one in question.drives)
        key = (OFFSET if offset else "exact") + (BESIDE if beside else "")
        yield ", ".join(dict.fromkeys(one.formulas[key].printed for one in shown))
        yield from _of_crosshead(question, shown)
        return
    yield WORDS["vectors"][lang] + (WORDS["turned"][lang] if beside else "")
    own = dict.fromkeys(one.formulas["exact"].printed for one in shown if one.of)
    if own:
        yield ", ".join(own)


_CROSSHEAD: Mapping[Vectorial, str] = {path: "x", velocity: "c", acceleration: "p"}


def _of_crosshead(question: PointsRequest, shown: Sequence[Quantity]) -> Iterator[Label]:
    """Yield the formulas of the crosshead's motion that stand in these, as pages of that print them."""
    keys = dict.fromkeys(_CROSSHEAD[vector_of(one)] for one in shown)
    columns = [bare(registry()[key], question.method or "exact", None) for key in keys]
    yield from formula_lines(question, columns)


def _directions(question: PointsRequest, shown: Sequence[Quantity]) -> Iterator[Label]:
    """Yield from where and in which directions vectors count."""
    lang = question.lang
    ways = ("along", "across") if question.has_ratio else ("shafts",)
    yield "; ".join(WORDS[key][lang] for key in (*ways, "signs"))
    if any(one.of == DIRECTION for one in shown):
        yield WORDS["directions"][lang]
