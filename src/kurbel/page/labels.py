"""The notation for labels: prose with formulas between dollar signs and note marks such as [^a].

Kolbenweg $x/R$          a formula in prose, in the grammar of `formula.py`
Hingang[^a]              a mark that points to the note a
5 \\$                     a dollar sign in prose
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from functools import lru_cache
from itertools import groupby
from typing import NamedTuple

from kurbel.errors import LayoutError
from kurbel.page.formula import Formula, MalformedError, parse_formula
from kurbel.page.plain import escape_text, formula_plain, mark_text


class Prose(NamedTuple):
    text: str


class Mark(NamedTuple):
    """A mark that points to a note."""

    text: str


Part = Prose | Formula | Mark

_PART = re.compile(r"\\(?P<dollar>\$)|\$(?P<formula>[^$]*)(?P<end>\$?)|\[\^(?P<mark>[^\]]+)\]")
# Everything that breaks or jumps within a line; the no-break and thin spaces of typography stay.
WHITE = re.compile(r"[\t-\r\x1c-\x20\x85\u2028\u2029]+")
# Minutes and seconds of an angle typed with quotation marks.
_MINUTES = re.compile(r"(°[0-9.,]+)'(?:([0-9.,]+)\")?")


@lru_cache(maxsize=1024)
def parse(label: str) -> tuple[Part, ...]:
    """Return the parts of a label. Neighbouring pieces of prose are one part; white space is one space.

    Raises LayoutError, naming the label, if a formula is not closed or not understood.
    """
    try:
        return tuple(_joined(_parts(WHITE.sub(" ", label))))
    except MalformedError as error:
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
            raise MalformedError(r"a formula needs a second $; a dollar sign in prose is written \$")
        else:
            yield parse_formula(match["formula"])
    yield Prose(label[done:])


def _joined(parts: Iterable[Part]) -> Iterator[Part]:
    for is_prose, run in groupby(parts, key=lambda part: isinstance(part, Prose)):
        if not is_prose:
            yield from run
        elif prose := "".join(part.text for part in run if isinstance(part, Prose)):
            yield Prose(primed(prose))


def primed(prose: str) -> str:
    """Return prose with the primes of its angles: 2°30' becomes 2°30′."""
    return _MINUTES.sub(_primes, prose)


def _primes(angle: re.Match[str]) -> str:
    minutes, seconds = angle.groups()
    return f"{minutes}′{seconds}″" if seconds else f"{minutes}′"


def plain(label: str, mark: str = ".") -> str:
    """Return a label as Unicode text."""
    return set_label(label, escape_text, lambda formula: formula_plain(formula, mark), mark_text)


def set_label(
    label: str,
    escape: Callable[[str], str],
    formula: Callable[[Formula], str],
    note: Callable[[str], str],
) -> str:
    """Return a label in a notation given by the three functions that set its prose, formulas and marks."""
    pieces = []
    for part in parse(label):
        match part:
            case Prose(text):
                pieces.append(escape(text))
            case Formula():
                pieces.append(formula(part))
            case Mark(text):
                pieces.append(note(text))
    return "".join(pieces)
