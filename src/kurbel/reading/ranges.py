"""Ranges and lists of other spellings, 0-180, 0:10:180, linspace(0, 180, 19), 0 45 90, in kurbel's.

Loaded where a text is no number and no range, or has a comma.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from fractions import Fraction

from kurbel.errors import NotationError
from kurbel.exact.numerals import exact_text
from kurbel.reading.notation import angle, clipped, in_shell, quoted

# A number, or an angle with its marks.
_NUMBER = r"\d+(?:[.,]\d+)?"
_ONE = rf"[+−-]?{_NUMBER}(?:/{_NUMBER})?(?:\s*(?:°|deg\b)(?:\s*{_NUMBER}\s*['′’])?)?"
_TO = r"\s*(?:\.{2,}|…|[-–—]|\b(?:to|bis|until|through)\b)\s*"
_BY = r"\s*(?:\.{2,}|…|:|,|;|\b(?:by|in steps of|steps? of|step|in Schritten von|Schritt|alle)\b)\s*"
_FROM_TO = re.compile(rf"({_ONE}){_TO}({_ONE})(?:{_BY}({_ONE}))?", re.IGNORECASE)
_COLONS = re.compile(rf"({_ONE})\s*:\s*({_ONE})(?:\s*:\s*({_ONE}))?")
_MEMBER = rf"(?:1[:/])?{_ONE}"
_LIST = re.compile(rf"{_MEMBER}(?:(?:\s+|\s*\|\s*){_MEMBER})+|{_MEMBER}(?:\s*[-–—]\s*{_MEMBER}){{2,}}")
_TWO = re.compile(rf"{_ONE}\s*[-–—]\s*{_ONE}")
_BETWEEN = re.compile(r"\s*[-–—|]\s*|\s+")
_CALL = re.compile(r"(?:\w+\.)?(linspace|arange|range)\s*\(([^()]*)\)")
_IN_BRACKETS = re.compile(r"[\[({]\s*(.*?)\s*[\])}]")
# Of a ratio the second part ranges; 1: may stand before its end, too.
_RATIO = re.compile(r"(1\s*[:/])\s*(.*)")
_AGAIN = re.compile(r"((?:\.{2,}|…|[-–—]|\bto\b|\bbis\b)\s*)1\s*[:/]\s*")
_LONGEST = 120
_WHOLE = re.compile(r"[+-]?\d+", re.ASCII)


def respelled(text: str, ratios: bool = False, lists: bool = False) -> str:
    """Return a range or list of another spelling in kurbel's, nothing for a text that is neither.

    Two numbers with a dash are a range, or one of the `lists`.
    """
    text = text.strip()
    if len(text) > _LONGEST:
        return ""
    if called := _CALL.fullmatch(text):
        return _of_call(called[1], [part.strip() for part in called[2].split(",")])
    bracketed = _IN_BRACKETS.fullmatch(text)
    inner = bracketed[1] if bracketed else text
    if lists and _TWO.fullmatch(inner):
        return ";".join(_BETWEEN.split(inner))
    if ratios and (start := _RATIO.fullmatch(inner)):
        found = _range(_AGAIN.sub(r"\1", start[2]), colons=False)
        found = f"{start[1]}{found}" if found else ""
    else:
        found = _range(inner, colons=not ratios)
    if not found and _LIST.fullmatch(inner):
        return ";".join(_BETWEEN.split(inner))
    if not found and bracketed and re.search("[,;]", inner):
        return ";".join(part.strip() for part in re.split("[,;]", inner))
    return found


def check_commas(text: str, read: Callable[[str], Fraction], what: str) -> None:
    """Raise NotationError if commas could part a list: 2,3 or 1:4,1:5; in 1:4,5 they cannot."""
    parts = [part.strip() for part in text.split(",")]
    if len(parts) == 1 or not all(_is_read(part, read) for part in parts):
        return
    listed = in_shell(clipped(";".join(parts)))
    if not _is_read(text, read):
        raise NotationError(
            f"{what} {quoted(text)} has commas between its values; write the list as {listed}"
        )
    if all(_WHOLE.fullmatch(part) for part in parts):
        decimal = ".".join(parts)
        raise NotationError(
            f"{what} {quoted(text)} can be read as the number {decimal} or the list {listed};"
            f" write {decimal} or {listed}"
        )


def _is_read(text: str, read: Callable[[str], Fraction]) -> bool:
    try:
        read(text)
    except NotationError:
        return False
    return True


def _range(text: str, colons: bool) -> str:
    match = _FROM_TO.fullmatch(text)
    if match is None and colons and (match := _COLONS.fullmatch(text)):
        first, middle, last = match.groups()
        if last is None:
            # 3:1 is a ratio.
            return f"{first}..{middle}" if _steps("0", first, middle) else ""
        return _written(first, last, middle) if _steps(first, middle, last) else _written(first, middle, last)
    return _written(*match.groups()) if match else ""


def _written(first: str, last: str, step: str | None) -> str:
    if step is None and "/" in last and "/" not in first:
        # The step of 0-180/10.
        last, step = last.split("/")
    found = f"{first.strip()}..{last.strip()}"
    return f"{found}:{step.strip()}" if step else found


def _steps(first: str, step: str, last: str) -> bool:
    """Whether the middle of three numbers is the step: 0:10:180, but not 0:180:10."""
    try:
        return angle(step) <= angle(last) - angle(first)
    except NotationError:
        return True


def _of_call(name: str, parts: Sequence[str]) -> str:
    """Return the range of linspace(first, last, count), or of arange(first, beyond, step)."""
    try:
        numbers = [Fraction(part) for part in parts]
        if name == "linspace" and len(numbers) == 3:
            first, last, count = numbers
            return _written(parts[0], parts[1], exact_text((last - first) / (count - 1)))
        if name != "linspace" and len(numbers) in (2, 3):
            first, beyond = numbers[:2]
            step = numbers[2] if len(numbers) == 3 else Fraction(1)
            whole = first + step * (-(-(beyond - first) // step) - 1)
            return _written(parts[0], exact_text(whole), exact_text(step))
    except (ValueError, ZeroDivisionError):
        return ""
    return ""
