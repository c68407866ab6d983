"""What pages over the path say of themselves: caption, formulas, what is known of the drive."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from kurbel.exact.numerals import Label
from kurbel.motion.captions import force_notes, formula_lines, loaded_notes, signed, strokes_of
from kurbel.motion.drives import Drive
from kurbel.motion.evaluation import method_named
from kurbel.motion.mechanism import mechanism
from kurbel.motion.quantities import registry
from kurbel.page.quantity import Column, Words, bare, enumerated, filled, for_ratio, words

if TYPE_CHECKING:
    from kurbel.conditions.over.page import PathRequest

WORDS: Mapping[str, Words] = {
    "caption": words(
        "{quantities} über dem Kolbenweg{for_ratio}; {method}"
        "|{quantities} over the piston path{for_ratio}; {method}"
    ),
    "share": words("Kolbenweg in Teilen des Hubes|Piston path in strokes"),
    "straight": words(
        "$x$ und $φ$ von dem Totpunkt an, in dem der Hub beginnt; {stroke}"
        "|$x$ and $φ$ from the dead centre where the stroke begins; {stroke}"
    ),
    "oblique": words(
        "$x$ von dem Totpunkt an, in dem der Hub beginnt, $φ$ von der Schubrichtung an; {stroke}"
        "|$x$ from the dead centre where the stroke begins, $φ$ from the slide direction; {stroke}"
    ),
    "length": words("$S$ Hub|$S$ stroke"),
    "between": words(", $y$ zwischen Welle und Kreuzkopf|, $y$ between shaft and crosshead"),
}
# The angle at a path by the triangle of crank, rod and slide; of the return stroke it is the outer angle.
_TRIANGLE = {
    "+": "$cos {angle} = (R^2 + y^2 - L^2)/(2 R y)$, $y = R + L - x$",
    "-": "$cos {angle} = (L^2 - R^2 - y^2)/(2 R y)$, $y = L - R + x$",
    "±": "$cos {angle} = ±(R^2 + y^2 - L^2)/(2 R y)$, $y = L ± (R - x)$",
}


def caption(question: PathRequest) -> Label:
    """Return the layout's caption with its quantities, the ratio, if there is only one, and the method; of
    columns that are not the layout's, which its caption may not know, a caption of their own."""
    layout, lang, drives = question.layout, question.lang, question.drives
    own = {column.key for column in layout.columns}
    foreign = bool(question.columns) and not {column.key for column in question.page_columns} <= own
    one = len(drives) == 1 and question.method != "infinite"
    parts = {
        "{quantities}": enumerated((column.quantity.name[lang] for column in question.page_columns), lang),
        "{for_ratio}": for_ratio(drives[0].ratio, lang, layout.ratio_symbol) if one else "",
        "{method}": method_named(question.method).caption[lang],
    }
    return filled((WORDS["caption"] if foreign else layout.caption)[lang], parts.items())


def notes(question: PathRequest) -> Iterator[Label]:
    """Yield the lines below the table: from where it counts, how the angle follows, formulas, lengths."""
    lang, drives, layout = question.lang, question.drives, question.layout
    yield from (note[lang] for note in layout.notes)
    yield _counted(drives, lang)
    if layout.formulas:
        yield from _formulas(question)
    if mechanism(question.mechanism).crosshead:
        # Pages of the others say it among their own lines.
        yield from _acting(question)
    yield from drives[0].closing_lines(question)


def _counted(drives: tuple[Drive, ...], lang: str) -> Label:
    """Return the line about where path and angle count from."""
    straight = all(one.is_straight for one in drives)
    strokes = {one.stroke if straight else "" for one in drives}
    said = f"$S = {strokes.pop()}$" if len(strokes) == 1 and all(strokes) else WORDS["length"][lang]
    return WORDS["straight" if straight else "oblique"][lang].format(stroke=said)


def _acting(question: PathRequest) -> Iterator[Label]:
    """Yield in which directions forces are positive, and what calls them up."""
    lang, crank = question.lang, question.drives[0].crank
    said = (one.quantity.direction[lang] for one in question.page_columns if one.quantity.direction)
    if directions := "; ".join(dict.fromkeys(said)):
        yield directions
    yield from force_notes(question.cranks, lang)
    if crank.loaded:
        yield from loaded_notes(crank, question.layout.ratio_symbol, lang)


def _formulas(question: PathRequest) -> Iterator[Label]:
    """Yield how the angle follows from the path, then the formulas of the columns."""
    known = registry()
    strokes = {column.quantity.stroke for column in question.page_columns}
    paths = (known[key] for key in ("x", "x_return") if known[key].stroke in strokes)
    shown = [bare(one, question.method, one.decimals) for one in paths]
    columns: list[Column] = [*shown, *(one for one in question.page_columns if one.key in known)]
    drive = question.drives[0]
    finite = any(one.ratio for one in question.drives)
    if drive.is_straight and drive.method == "exact" and finite and question.mechanism == "straight":
        _, sign = strokes_of(shown)
        yield signed(_TRIANGLE[sign], question, sign, False) + WORDS["between"][question.lang]
    if mechanism(question.mechanism).crosshead:
        yield from formula_lines(question, columns)
