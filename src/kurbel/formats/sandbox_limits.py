"""What templates of users may not make: texts and lists so long that they fill the memory.

Each function looks at what goes in, before anything long is made. What takes long without being long is
stopped by others.
"""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Iterable, Sequence, Sized
from typing import Any

LONGEST = 10_000_000
"""Characters of a text, items of a list."""
WIDEST = 10_000
_BITS = 100_000
# A width or a precision with five digits or of a variable.
_WIDE = re.compile(r"[0-9]{5,}|%[-+ #0-9.]*\*|\{[^{}]*\{")


class TooLongError(Exception):
    """A sentence for the author of the template."""

    def __init__(self) -> None:
        super().__init__(f"the result would have more than {LONGEST} characters")


def limited(length: int) -> None:
    """Raise TooLongError for more than any page has."""
    if length > LONGEST:
        raise TooLongError


def concatenated(pieces: Iterable[Any]) -> str:
    """Return the pieces as one text."""
    texts: list[str] = []
    length = 0
    for piece in pieces:
        texts.append(str(piece))
        length += len(texts[-1])
        limited(length)
    return "".join(texts)


def _product(left: Any, right: Any) -> Any:
    for text, count in ((left, right), (right, left)):
        if isinstance(text, Sequence) and isinstance(count, int):
            limited(len(text) * count)
    if isinstance(left, int) and isinstance(right, int):
        _limit_bits(left.bit_length() + right.bit_length())
    return left * right


def _power(left: Any, right: Any) -> Any:
    if isinstance(left, int) and isinstance(right, int):
        _limit_bits(left.bit_length() * abs(right))
    return left**right


def _limit_bits(bits: int) -> None:
    if bits > _BITS:
        raise TooLongError


def _sum(left: Any, right: Any) -> Any:
    if isinstance(left, Sized) and isinstance(right, Sized):
        limited(len(left) + len(right))
    return left + right


def _remainder(left: Any, right: Any) -> Any:
    if isinstance(left, str):
        check_call(left, "format", (), {})
    return left % right


OPERATORS: dict[str, Callable[[Any, Any], Any]] = {
    "*": _product,
    "**": _power,
    "+": _sum,
    "%": _remainder,
    "-": operator.sub,
}


def check_call(value: Any, name: str, args: Sequence[Any], named: dict[str, Any]) -> None:
    """Raise TooLongError if a filter or a method of that name could make something long of the value.

    A text may be repeated as often as the largest number given, or may have a text given put in at each of
    its characters; a list may be joined by one.
    """
    given = [*args, *named.values()]
    numbers = [abs(one) for one in given if isinstance(one, int)]
    texts = [len(one) for one in given if isinstance(one, str)]
    if isinstance(value, str):
        if name.startswith("format") and (len(value) > WIDEST or _WIDE.search(value)):
            raise TooLongError
        if name.startswith("format"):
            numbers = []
        limited((len(value) + 1) * (1 + max([0, *numbers, *texts])))
        if name == "join" and args:
            _check_join(args[0], len(value))
    elif isinstance(value, Sized | Iterable) and name in ("join", "sum", "string"):
        _check_join(value, max(texts, default=0))
    if max(numbers, default=0) > LONGEST or (name in ("batch", "slice") and max(numbers, default=0) > WIDEST):
        raise TooLongError


def _check_join(pieces: Any, between: int) -> None:
    if isinstance(pieces, list | tuple):
        limited(sum(between + (len(one) if isinstance(one, Sized) else 1) for one in pieces))
