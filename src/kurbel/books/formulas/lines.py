"""A long formula in several lines, as a book breaks it: at relations, sums, products, then within brackets.

A bracket that is closed in another line than it is opened stands as prose, for a formula has both.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby, takewhile
from typing import NamedTuple

from kurbel.exact.numerals import Label
from kurbel.page.formula import FENCES, ROOT, SIGNS, tokens
from kurbel.page.labels import plain

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
    longest = max((len(plain(line)) for line in lines), default=0)
    return min(max(BOTH - longest, LEAST_WORDS), LONGEST)


def word_lines(label: Label, longest: int) -> tuple[Label, ...]:
    """Return a label in lines of so many characters; its formulas are not broken."""
    lines: list[Label] = []
    for word in _words(label):
        longer = f"{lines[-1]} {word}" if lines else word
        if lines and len(plain(longer)) <= longest:
            lines[-1] = longer
        else:
            lines.append(word)
    return tuple(lines)


def _words(label: Label) -> Iterator[Label]:
    word = ""
    for place, part in enumerate(label.split("$")):
        if place % 2:
            word += f"${part}$"
            continue
        first, *others = part.split(" ")
        word += first
        for other in others:
            yield word
            word = other
    yield word


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
    return len(plain(_label(words, pairs, start, end)))


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
