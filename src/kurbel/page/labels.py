"""The notation for labels: prose with formulas between dollar signs and note marks such as [^a].

Kolbenweg $x/R$          a formula in prose, in the grammar of `formula.py`
Hingang[^a]              a mark that points to the note a
5 \\$                     a dollar sign in prose

And words in columns: how wide each column may be, and the lines of a text in so much room.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import lru_cache
from itertools import groupby
from textwrap import wrap
from typing import NamedTuple

from kurbel.errors import LayoutError
from kurbel.page import formula as tree


class Prose(NamedTuple):
    text: str


class Mark(NamedTuple):
    """A mark that points to a note."""

    text: str


Part = Prose | tree.Formula | Mark

_PART = re.compile(r"\\(?P<dollar>\$)|\$(?P<formula>[^$]*)(?P<end>\$?)|\[\^(?P<mark>[^\]]+)\]")
# Everything that breaks or jumps within a line; the no-break and thin spaces of typography stay.
WHITE = re.compile(r"[\t-\r\x1c-\x20\x85\u2028\u2029]+")
# Options behind what is assumed without them: (--suction-loss, --delivery-loss); after "else" such as name
# another choice.
_OPTIONS = re.compile(r" \((sonst |else )?--[a-z -]+(, --[a-z-]+)*\)")
# Minutes and seconds of an angle typed with quotation marks.
_MINUTES = re.compile(r"(°[0-9.,]+)'(?:([0-9.,]+)\")?")


@lru_cache(maxsize=1024)
def parse(label: str) -> tuple[Part, ...]:
    """Return the parts of a label. Neighbouring pieces of prose are one part; white space is one space.

    Raises LayoutError, naming the label, if a formula is not closed or not understood.
    """
    try:
        return tuple(_joined(_parts(WHITE.sub(" ", label))))
    except tree.MalformedError as error:
        raise LayoutError(f'the label "{label}" cannot be set: {error}') from None


def _parts(label: str) -> Iterator[Part]:
    done = 0
    for match in _PART.finditer(label):
        yield Prose(label[done : match.start()])
        done = match.end()
        if match["dollar"]:
            yield Prose("$")
        elif match["mark"]:
            yield Mark(match["mark"])
        elif not match["end"]:
            raise tree.MalformedError(r"a formula needs a second $; a dollar sign in prose is written \$")
        else:
            yield tree.parse_formula(match["formula"])
    yield Prose(label[done:])


def _joined(parts: Iterable[Part]) -> Iterator[Part]:
    for is_prose, run in groupby(parts, key=lambda part: isinstance(part, Prose)):
        if not is_prose:
            yield from run
        elif prose := "".join(part.text for part in run if isinstance(part, Prose)):
            yield Prose(primed(prose))


def primed(prose: str) -> str:
    """Return prose with the primes of its angles: 2°30' becomes 2°30′."""
    return _MINUTES.sub(lambda angle: f"{angle[1]}′" + (f"{angle[2]}″" if angle[2] else ""), prose)


def plain(label: str, mark: str = ".") -> str:
    """Return a label as Unicode text."""
    return set_label(label, str, lambda formula: formula_plain(formula, mark), mark_text)


def unprompted(label: str) -> str:
    """Return a label without the options in brackets that change what it says is assumed."""
    return _OPTIONS.sub("", label)


def set_label(
    label: str,
    escape: Callable[[str], str],
    formula: Callable[[tree.Formula], str],
    note: Callable[[str], str],
) -> str:
    """Return a label in a notation given by the three functions that set its prose, formulas and marks."""
    pieces = []
    for part in parse(label):
        match part:
            case Prose(text):
                pieces.append(escape(text))
            case tree.Formula():
                pieces.append(formula(part))
            case Mark(text):
                pieces.append(note(text))
    return "".join(pieces)


# Characters that Unicode has raised.
POWERS = dict(
    zip(
        "0123456789−+)abcdefghijklmnoprstuvwxyz",
        "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺⁾ᵃᵇᶜᵈᵉᶠᵍʰⁱʲᵏˡᵐⁿᵒᵖʳˢᵗᵘᵛʷˣʸᶻ",
        strict=True,
    )
)


def mark_text(mark: str) -> str:
    """Return a mark raised, ᵃ⁾, or as it is, *), where Unicode has no raised character."""
    closed = f"{mark})"
    return "".join(POWERS[character] for character in closed) if set(closed) <= POWERS.keys() else closed


def formula_plain(formula: tree.Formula, mark: str = ".") -> str:
    """Return a formula in one line of Unicode: sin(φ±ψ)/cos ψ, xₘ, φ²."""
    return _text(formula.content, mark)


def _text(nodes: tree.Nodes, mark: str) -> str:
    return "".join(_text_node(nodes, place, mark) for place in range(len(nodes)))


def _text_node(nodes: tree.Nodes, place: int, mark: str) -> str:
    match nodes[place]:
        case tree.Sign(text):
            return tree.SIGNS[text][0]
        case tree.Symbol(text):
            return tree.SYMBOLS[text][0]
        case tree.Numeral(text):
            return text.replace(".", mark)
        case tree.Space():
            return " "
        case tree.Group(content, fences):
            return f"{fences[0]}{_text(content, mark)}{fences[1]}"
        case tree.Root((tree.Numeral(text),)) if text.isdigit():
            return f"√{text}"
        case tree.Root(content):
            return f"√({_text(content, mark)})"
        case tree.Overline(content):
            return _text(tuple(node for node in content if not isinstance(node, tree.Space)), mark)
        case tree.Fraction(top, bottom):
            return _text_fraction(nodes, place, top, bottom, mark)
        case tree.Script(tree.Root(content), index, power):
            scripts = _small(index, "_", _INDICES, mark) + _small(power, "^", POWERS, mark)
            return f"√({_text(content, mark)}){scripts}"
        case tree.Script(base, index, power):
            scripts = _small(index, "_", _INDICES, mark) + _small(power, "^", POWERS, mark)
            return _text((base,), mark) + scripts
        case tree.Word(text) | tree.Variable(text) | tree.Upright(text):
            return text


def _text_fraction(nodes: tree.Nodes, place: int, top: tree.Nodes, bottom: tree.Nodes, mark: str) -> str:
    """Write a fraction with a stroke, and with parentheses where the stroke alone would be misread."""
    alone_before = place == 0 or isinstance(beside(nodes, place, -1), tree.Sign)
    alone_after = place == len(nodes) - 1 or isinstance(beside(nodes, place, 1), tree.Sign)
    above, below = _text(top, mark), _text(bottom, mark)
    if is_sum(top) or _is_open(top) or (len(top) > 1 and not alone_before):
        above = f"({above})"
    if is_sum(bottom) or (len(bottom) > 1 and not (alone_after and tree.is_function(bottom[0]))):
        below = f"({below})"
    return f"{above}/{below}"


def _is_open(nodes: tree.Nodes) -> bool:
    """Tell whether the argument of a function has no parentheses: (cos φ)/2 is not cos φ/2."""
    return any(
        tree.is_function(node) and not isinstance(after, tree.Group)
        for node, after in zip(nodes, (*nodes[1:], None), strict=True)
    )


def beside(nodes: tree.Nodes, place: int, step: int) -> tree.Node:
    """Return the next node that is not a space; spaces never end a sequence."""
    place += step
    return nodes[place + step] if isinstance(nodes[place], tree.Space) else nodes[place]


def is_sum(nodes: tree.Nodes) -> bool:
    return any(isinstance(node, tree.Sign | tree.Fraction) for node in nodes)


_INDICES = dict(zip("0123456789aehijklmnoprstuvxβγρφχ", "₀₁₂₃₄₅₆₇₈₉ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓᵦᵧᵨᵩᵪ", strict=True))


def _small(nodes: tree.Nodes, sign: str, small: dict[str, str], mark: str) -> str:
    if not nodes:
        return ""
    text = _text(nodes, mark)
    if all(character in small for character in text):
        return "".join(small[character] for character in text)
    return f"{sign}{text}" if len(text) == 1 else f"{sign}({text})"


def fitted(widths: Sequence[int], least: Sequence[int], room: int) -> list[int] | None:
    """Return widths that have room together; the widest give way first, none below its least.

    None if not even the least widths have room.
    """
    fitting = list(widths)
    for _ in range(sum(widths) - room):
        places = [place for place, width in enumerate(fitting) if width > least[place]]
        if not places:
            return None
        # Of columns alike the last gives way, which is the one with the longest texts.
        fitting[max(places, key=lambda place: (fitting[place], place))] -= 1
    return fitting


def lines_of(text: str, room: int, further: str = "") -> list[str]:
    """Return the lines of a text, of which no word is broken; the second and later ones begin anew."""
    room = max(room, 1)
    return wrap(text, room, subsequent_indent=further, break_on_hyphens=False, break_long_words=False) or [""]


def longest_word(text: str) -> int:
    """Return the least room that a text needs."""
    return max(map(len, text.split(" ")))


# Spaces outside of formulas.
_BETWEEN = re.compile(r" (?=(?:[^$]*\$[^$]*\$)*[^$]*$)")


def rows_of(label: str, room: float, width: Callable[[str], float]) -> list[str]:
    """Return a label in rows that are no wider than the room; its formulas are not broken."""
    rows = [""]
    for word in _BETWEEN.split(label):
        longer = f"{rows[-1]} {word}".lstrip()
        if rows[-1] and width(longer) > room:
            rows.append(word)
        else:
            rows[-1] = longer
    return rows
