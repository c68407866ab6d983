"""The formulas of a book become a page: each as printed, with what is found of its step from another.

A long one stands in several lines, as a book breaks it: at relations, sums, products, then within brackets. A
bracket that is closed in another line than it is opened stands as prose, for a formula has both.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from functools import cache, cached_property
from itertools import chain, groupby, takewhile
from typing import NamedTuple

from flint import arb

from kurbel.books.collate_page import BookQuestion, kernels, titled
from kurbel.books.equation import (
    AGREES,
    BITS,
    FACTOR,
    FAR,
    FINE,
    HOLDS,
    KINDS,
    NO_ROOT,
    ONLY_NEARLY,
    ORDER,
    OTHER,
    POINTS,
    STARTS,
    UNSETTLED,
    WRONG,
)
from kurbel.books.source import CollatedFormula, FormulaTable
from kurbel.exact.certify import at_bits
from kurbel.exact.numerals import Label, nearest, number_text
from kurbel.page.axes import ColumnAxis, PageAxis, Place
from kurbel.page.formula import FENCES, ROOT, SIGNS, tokens
from kurbel.page.labels import plain, rows_of
from kurbel.page.quantity import Column, Quantity, Words, words
from kurbel.page.subject import Subject
from kurbel.page.table import DITTO, Ditto, Note, Tone, Value

KEYS = ("table", "place", "printed", "follows", "relation", "letter", "verdict", "detail")
# Of the two sides at a point.
FIGURES = 4
# The power of ten of one that is written out.
LONGEST_POWER = 6
# Of sides that differ in later figures.
ALIKE = "alike"
WORDS: Mapping[str, Words] = {
    "place": words("Stelle|Place"),
    "printed": words("gedruckt|printed"),
    "verdict": words("Befund|verdict"),
    "follows": words("folgt aus|follows from"),
    "relation": words("Beziehung|relation"),
    "letter": words("Buchstabe|letter"),
    "detail": words("Einzelheit|detail"),
    "table": words("Tafel|Table"),
    "summary": words("{steps} Schritte: {verdicts}|{steps} steps: {verdicts}"),
    "one": words("{steps} Schritt: {verdicts}|{steps} step: {verdicts}"),
    "at": words("bei {point}|at {point}"),
    "no_letter": words("ausgerechnet|worked out"),
    "proof": words(
        "bewiesen: beide Seiten sind derselbe Quotient von Polynomen in den Buchstaben, Sinus und Kosinus, "
        "$π$ und Logarithmen; Buchstaben sind positiv, $±$ gilt mit beiden Zeichen"
        "|proved: both sides are the same quotient of polynomials in the letters, sine and cosine, $π$ and "
        "logarithms; letters are positive, $±$ holds with both signs"
    ),
    "order": words(
        "Ordnung: des relativen Unterschieds beider Seiten|order: of the relative difference of both sides"
    ),
}
# What is found, by kind: in the count, and with what belongs to it.
VERDICTS: Mapping[str, tuple[Words, Words]] = {
    HOLDS: (words("bewiesen|proved"), words("bewiesen|proved")),
    AGREES: (
        words("nicht widerlegt|not refuted"),
        words("an {points} Stellen gleich, nicht bewiesen|equal at {points} points, not proved"),
    ),
    ORDER: (words("Näherung|approximation"), words("Näherung, Ordnung {order}|approximation, order {order}")),
    ONLY_NEARLY: (
        words("nur Näherung|an approximation only"),
        words("nur Näherung, Ordnung {order}|an approximation only, order {order}"),
    ),
    UNSETTLED: (words("nicht entschieden|not settled"), words("nicht entschieden|not settled")),
    FAR: (words("falsch|wrong"), words("falsch: keine Näherung|wrong: no approximation")),
    FACTOR: (words("falsch|wrong"), words("falsch: {factor} mal so groß|wrong: {factor} times as great")),
    WRONG: (
        words("falsch|wrong"),
        words("falsch: {at} wird {right}, nicht {left}|wrong: {at} it is {right}, not {left}"),
    ),
    ALIKE: (
        words("falsch|wrong"),
        words(
            "falsch: {at} sind beide Seiten etwa {left}, ihr Unterschied ist {apart}"
            "|wrong: {at} both sides are about {left}, their difference is {apart}"
        ),
    ),
    OTHER: (words("falsch|wrong"), words("falsch: eine andere Gleichung|wrong: another equation")),
    NO_ROOT: (
        words("falsch|wrong"),
        words("falsch: keine Wurzel, die linke Seite ist {left}|wrong: no root, the left side is {left}"),
    ),
}
# What is as it should be, or nearly so; all else is wrong.
TONES: Mapping[str, Tone] = {
    HOLDS: "right", AGREES: "right", ORDER: "near", ONLY_NEARLY: "other", UNSETTLED: "other", STARTS: "",
}  # fmt: skip


class Line(NamedTuple):
    """A line of the page: of a formula, which may go on in the next, and of what is found of it."""

    place: Label
    first: bool
    printed: Label
    verdict: Label | None
    tone: Tone


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class FormulaRequest(BookQuestion):
    """What is asked for: the formulas of a table, all or those that are not as they should be."""

    keys = KEYS
    words = WORDS
    table: FormulaTable
    collated: Sequence[CollatedFormula]

    @cached_property
    def deviations(self) -> list[CollatedFormula]:
        return [one for one in self.collated if one.finding.kind not in FINE]

    @cached_property
    def labels(self) -> Mapping[str, Label]:
        """The printed places of all formulas; one without a label has that of the formula above."""
        labels: dict[str, Label] = {}
        label = ""
        for row, _ in self.collated:
            label = labels[row.place] = row.label or label
        return labels

    @cached_property
    def lines(self) -> Sequence[Line]:
        """The lines of the page."""
        printed = [formula_lines(one.row.printed) for one in self.shown]
        room = room_beside(chain.from_iterable(printed))
        return [
            line
            for one, lines in zip(self.shown, printed, strict=True)
            for line in _lines(one, lines, room, self)
        ]

    def record(self, one: CollatedFormula) -> Mapping[str, Value]:
        row, found = one
        details = {FACTOR: str(found.factor), ORDER: str(found.order), ONLY_NEARLY: str(found.order)}
        point = " ".join(f"{name}={value}" for name, value in found.point.items())
        return {
            "table": self.table.key,
            "place": row.place,
            "printed": row.printed,
            "follows": row.follows or None,
            "relation": row.relation or None,
            "letter": row.letter or None,
            "verdict": None if found.kind == STARTS else found.kind,
            "detail": details.get(found.kind) or point or None,
        }


class _PlaceAxis(PageAxis):
    """The lines; the place of a formula stands before all of its lines."""

    def __init__(self, request: FormulaRequest) -> None:
        super().__init__(len(request.lines), len(request.shown))
        self.request = request

    def stub_heading(self) -> Label:
        return WORDS["place"][self.request.lang]

    def heads(self, place: Place) -> tuple[Label, ...]:
        return (self.request.lines[place["place"]].place,)

    def stub(self, place: Place) -> Label | Ditto:
        return self.heads(place)[0] if self.request.lines[place["place"]].first else DITTO


def _lines(
    one: CollatedFormula, printed: Sequence[Label], room: int, request: FormulaRequest
) -> Iterator[Line]:
    """Yield the lines of a formula; what is found of it begins in its last."""
    *lines, last = printed
    verdict = verdict_text(one, request.table, request.lang)
    first, *further = (None,) if verdict is None else rows_of(verdict, room, _letters)
    parts = [*((line, "") for line in lines), (last, first), *(("", line) for line in further)]
    place = request.labels[one.row.place]
    tone = TONES.get(one.finding.kind, "wrong")
    yield from (Line(place, not number, *part, tone) for number, part in enumerate(parts))


def verdict_text(one: CollatedFormula, table: FormulaTable, lang: str) -> Label | None:
    """Return what is found of a formula, None of one that begins."""
    found = one.finding
    kind = found.kind
    if kind == STARTS:
        return None
    parts: dict[str, Label] = {"points": str(POINTS), "factor": f"${found.factor}$"}
    if found.order:
        parts["order"] = _power(table.letter_label(one.row.letter), found.order)
    if found.sides:
        point = ", ".join(f"${table.letter_label(name)} = {value}$" for name, value in found.point.items())
        left, right = map(_figures, found.sides)
        at = WORDS["at" if point else "no_letter"][lang].format(point=point)
        parts |= {"at": at, "left": left, "right": right}
        if kind == WRONG and left == right:
            with at_bits(BITS):
                kind, parts["apart"] = ALIKE, _figures(abs(found.sides[1] - found.sides[0]))
    return VERDICTS[kind][1][lang].format(**parts)


def _power(letter: Label, order: int) -> Label:
    if order == 1:
        return f"${letter}$"
    return f"${letter}^{order}$" if letter.isalpha() else f"$({letter})^{order}$"


def _figures(value: arb) -> Label:
    """Return a ball, which is small, with so many figures, and what is long or little by a power of ten."""
    exact = Decimal(value.mid().str(60, radius=False))
    if abs(exact.adjusted()) > LONGEST_POWER:
        mantissa, _, power = f"{exact:.{FIGURES - 1}E}".partition("E")
        return f"${mantissa} · 10^{int(power)}$" if int(power) >= 0 else f"${mantissa} · 10^({int(power)})$"
    decimals = max(FIGURES - 1 - exact.adjusted(), 0) if exact else FIGURES
    return f"${number_text(nearest(Fraction(exact), decimals))}$"


@cache
def quantities() -> Mapping[str, Quantity]:
    """Return what stands beside a place."""
    return kernels(WORDS, printed=lambda line: line.printed, verdict=lambda line: line.verdict)


def _shown(request: FormulaRequest, column: Column, place: Place, times: int) -> Value:
    shown: Value = column.quantity.formulas[""].kernel(request.lines[place["place"]])
    return shown


def _notes(request: FormulaRequest) -> Iterator[Note]:
    lang = request.lang
    found = [one.finding.kind for one in request.collated if one.finding.kind != STARTS]
    counted = Counter(VERDICTS[kind][0][lang] for kind in sorted(found, key=KINDS.index))
    verdicts = ", ".join(f"{count} {name}" for name, count in counted.items())
    yield Note(
        WORDS["one" if len(found) == 1 else "summary"][lang].format(steps=len(found), verdicts=verdicts)
    )
    yield from (Note(note) for note in request.table.notes[lang])
    yield Note(WORDS["proof"][lang])
    if {ORDER, ONLY_NEARLY} & {*found}:
        yield Note(WORDS["order"][lang])


SUBJECT = Subject(
    key="formulas",
    layout="formulas",
    command="collate",
    axes={"place": _PlaceAxis, "column": ColumnAxis},
    axis_keys=KEYS,
    own_first=False,
    quantities=quantities,
    listed=tuple,
    number=_shown,
    tone=lambda request, column, place: (
        request.lines[place["place"]].tone if column.quantity.key == "verdict" else ""
    ),
    caption=titled,
    notes=_notes,
    rows=FormulaRequest.records,
)


# Characters of a line of a formula, of both columns together, and of words that have less room.
LONGEST, BOTH, LEAST_WORDS = 50, 68, 16
# Characters of a line, and of a bracket, that are worth a break.
SHORTEST, SHORTEST_BRACKET = 9, 12
_CLOSING = frozenset(FENCES.values())
_OVER, _SCRIPTS, _SPACE = "/", ("_", "^"), " "
_KINDS = (("=", "<", ">", "≤", "≥", "≈", ":"), ("+", "-", "−", "±", "∓"), ("·", "×", _OVER))


class _Break(NamedTuple):
    """A place between two tokens; the outer ones are better, and among these those of the looser sign."""

    rank: int
    at: int


def formula_lines(printed: str, longest: int = LONGEST) -> tuple[Label, ...]:
    """Return a printed formula as one label, or as one a line where it has more than so many characters."""
    words = tokens(printed)
    pairs = _pairs(words)
    breaks = tuple(_breaks(words, pairs))
    lines: list[Label] = []
    start = 0
    while _length(words, pairs, start, len(words)) > longest:
        ahead = [one for one in breaks if one.at > start]
        sizes = ((one, _length(words, pairs, start, one.at)) for one in ahead)
        fitting = dict(takewhile(lambda sized: sized[1] <= longest, sizes))
        long = [one for one, size in fitting.items() if size >= SHORTEST]
        if not ahead:
            break
        best = min(long or [*fitting][-1:] or ahead[:1], key=lambda one: (one.rank, -one.at))
        lines.append(_label(words, pairs, start, best.at))
        start = best.at
    return (*lines, _label(words, pairs, start, len(words)))


def room_beside(lines: Iterable[Label]) -> int:
    """Return how many characters the words beside such lines may have."""
    longest = max(map(_letters, lines), default=0)
    return min(max(BOTH - longest, LEAST_WORDS), LONGEST)


def _letters(label: Label) -> int:
    return len(plain(label))


def _pairs(words: Sequence[str]) -> dict[int, int]:
    """Return where each bracket is closed, and where opened."""
    pairs: dict[int, int] = {}
    opened: list[int] = []
    for at, word in enumerate(words):
        if word in FENCES:
            opened.append(at)
        elif word in _CLOSING:
            first = opened.pop()
            pairs |= {first: at, at: first}
    return pairs


def _breaks(words: Sequence[str], pairs: dict[int, int]) -> Iterator[_Break]:
    """Yield the places before signs between two terms, in brackets that may be broken."""
    depth, at = 0, 0
    while at < len(words):
        word, before = words[at], _before(words, at)
        if word in FENCES:
            if _is_whole(words, pairs, at):
                at = pairs[at]
            else:
                depth += 1
        elif word in _CLOSING:
            depth -= 1
        elif before and before not in SIGNS and before not in FENCES:
            kind = next((kind for kind, signs in enumerate(_KINDS) if word in signs), None)
            if kind is not None and not _is_in_term(words, pairs, at):
                yield _Break(depth * len(_KINDS) + kind, at)
        at += 1


def _is_whole(words: Sequence[str], pairs: dict[int, int], at: int) -> bool:
    """Tell whether a bracket is an index, a power or has one, or is not worth a break."""
    end = pairs[at] + 1
    scripted = words[at - 1] in _SCRIPTS or "".join(words[end : end + 1]) in _SCRIPTS
    return scripted or _length(words, pairs, at, end) < SHORTEST_BRACKET


def _is_in_term(words: Sequence[str], pairs: dict[int, int], at: int) -> bool:
    """Tell whether a sign is one of 1:5, or of a fraction with little below the stroke."""
    if words[at] == ":":
        return words[at - 1] != _SPACE
    below = at + 1 + (words[at + 1] == _SPACE)
    return words[at] == _OVER and (
        below not in pairs or _length(words, pairs, below, pairs[below] + 1) < SHORTEST_BRACKET
    )


def _before(words: Sequence[str], at: int) -> str:
    """Return the token before another, and before a space."""
    return next((word for word in reversed(words[max(at - 2, 0) : at]) if word != _SPACE), "")


def _length(words: Sequence[str], pairs: dict[int, int], start: int, end: int) -> int:
    return _letters(_label(words, pairs, start, end))


def _label(words: Sequence[str], pairs: dict[int, int], start: int, end: int) -> Label:
    """Return the tokens as a label; brackets that lack their partner, and what clings to them, are prose."""

    def lone(at: int) -> bool:
        return start <= at < end and at in pairs and not start <= pairs[at] < end

    def is_prose(at: int) -> bool:
        root = words[at] == ROOT and lone(at + 1)
        return lone(at) or root or (words[at] == _OVER and (at == start or lone(at - 1) or lone(at + 1)))

    pieces = []
    for prose, run in groupby(range(start, end), is_prose):
        text = "".join(words[at] for at in run)
        if prose:
            pieces.append(text.replace(ROOT, "√"))
        elif text.strip():
            before, after = (" " * text.startswith(" "), " " * text.endswith(" "))
            pieces.append(f"{before}${text.strip()}${after}")
    return "".join(pieces).strip()
