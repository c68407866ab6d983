"""Text to exact numbers, and back, as engineers write them: 1:4,5  1/3  2..6:0.5  2°30'  0..180:10."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache, partial
from itertools import pairwise
from typing import Any, overload

from kurbel.errors import NotationError, ProblemError
from kurbel.exact.numerals import about as about
from kurbel.exact.numerals import exact_text
from kurbel.exact.numerals import plain as plain
from kurbel.exact.numerals import ratio_text as ratio_text

LONGEST_NUMBER = 60
# A range is three numbers; a longer text would keep the patterns of ranges busy for minutes.
LONGEST_RANGE = 4 * LONGEST_NUMBER
LONGEST_LIST = 10_000
LONGEST_ANGLE_LIST = 10**6
MOST_ROWS = 10**9
# What stands before a unit, read as a number or refused as one: in 10 1/s the fraction belongs to the unit.
BEFORE_UNIT = r"[+−-]?(?:\d+\s+(?=\d+/\d))?[\d.,]+(?:[eE][+-]?\d+)?(?:\s*/\s*[\d.,]+(?:[eE][+-]?\d+)?)?"

# What a value is that is beyond a bound.
_BEYOND: Mapping[str, Callable[[Any, Any], Any]] = {
    "above": operator.le, "least": operator.lt, "below": operator.ge, "most": operator.gt
}  # fmt: skip

# Pages print U+2212 for minus, and what is copied from them is read back.
_MINUS = ("-", "−")
_DECIMAL = r"(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d{1,3})?"
_SIGN = "[+−-]?"
_ENDLESS = r"[+-]?[0-9.,]+[eE][+-]?[0-9]{4,}"
_NUMERAL = rf"(?a)({_SIGN})(?:(\d+)\s+(?=\d+/\d+$))?({_DECIMAL})(?:\s*/\s*({_SIGN}{_DECIMAL}))?"
# A number without a sign where further text follows, such as the degrees before their mark.
_PART = r"(?:(?:\d+\s+)?\d+/\d+|\d+(?:[.,]\d+)?)"
_ANGLE = (
    rf"(?a)([+−-]?)(?:(?P<deg>{_PART})\s*(?:°|deg))?\s*"
    rf"(?:(?P<min>{_PART})\s*['′’])?\s*(?:(?P<sec>{_PART})\s*(?:\"|″|''))?"
)
# Before another ratio, and between its crank and its rod.
_COMMA, _COLON = r",\s*(?=\d+(?:\.\d+)?\s*[:∶])", "[:∶]"
_INFINITE = {"∞", "inf", "oo"}
_PERCENT = re.compile(r"(.*?)\s*(%|‰|percent|per cent|Prozent|v\. ?H\.)", re.DOTALL | re.IGNORECASE)
_PER_MILLE = "‰"
# The comma of a decimal: of few lists of shares the second is a whole number.
_ZERO_COMMA = re.compile(r"(?<![\d.,])0,(?=\d)")


@dataclass(frozen=True, slots=True)
class Progression(Sequence[Fraction]):
    """Equally spaced exact numbers: start, start + step, ...; a sequence that is never written out."""

    start: Fraction
    step: Fraction
    size: int

    def __len__(self) -> int:
        return self.size

    @overload
    def __getitem__(self, index: int) -> Fraction: ...
    @overload
    def __getitem__(self, index: slice) -> Progression: ...
    def __getitem__(self, index: int | slice) -> Fraction | Progression:
        if isinstance(index, slice):
            rows = range(self.size)[index]
            return Progression(self.start + rows.start * self.step, self.step * rows.step, len(rows))
        if not -self.size <= index < self.size:
            raise IndexError(index)
        return self.start + (index % self.size) * self.step


def check_bounds(what: str, value: Fraction | None, rule: str, unit: str = "") -> None:
    """Raise ProblemError for a value beyond the bounds that its rule says before the first comma.

    "lie within 0..1, for ...", "be 0 or more and below 1", "be above 0 and at most 10^12 Pa". None is not
    known, and beyond nothing.
    """
    if value is not None and any(beyond(value, bound) for beyond, bound in bounds(rule)):
        raise ProblemError(f"{what} is {about(value)}{unit}; it must {rule}")


@lru_cache(maxsize=256)
def bounds(rule: str) -> tuple[tuple[Callable[[Any, Any], Any], Fraction], ...]:
    """Return the bounds of a rule, each with what is beyond it; "be 1 (no expansion) or more" has one."""
    found: list[tuple[Callable[[Any, Any], Any], Fraction]] = []
    for word, number in pairwise(re.sub(r" \(.*?\)", "", rule.partition(",")[0]).split()):
        if word == "within":
            low, _, high = number.partition("..")
            found += [(operator.lt, _bound(low)), (operator.gt, _bound(high))]
        elif number == "or":
            found.append((operator.lt, _bound(word)))
        elif word in _BEYOND:
            found.append((_BEYOND[word], _bound(number)))
    return tuple(found)


def _bound(text: str) -> Fraction:
    base, _, power = text.partition("^")
    return Fraction(base) ** int(power or 1)


def number(text: str, what: str = "number") -> Fraction:
    """Return the exact value of a number: "4,5", "4.5", "-2e-3", "1/3", "1 1/2"."""
    stripped = text.strip()
    if max(map(len, stripped.split("/", 1))) > LONGEST_NUMBER:
        raise NotationError(
            f"{what} {quoted(text)} has {len(stripped)} characters; at most {LONGEST_NUMBER} are read"
        )
    if _is_plain(stripped):
        return Fraction(int(stripped))
    match = re.fullmatch(_NUMERAL, stripped)
    if match is None:
        if re.fullmatch(_ENDLESS, stripped):
            raise NotationError(f"{what} {quoted(text)} is beyond the numbers that are read, up to 10^999")
        raise NotationError(f"{what} {quoted(text)} is not a number; write it as 4.5 or 4,5")
    try:
        return _value_of(match)
    except ZeroDivisionError:
        raise NotationError(f"{what} {quoted(text)} is a fraction over 0, which is no number") from None


def _is_plain(text: str) -> bool:
    """Whether a text is digits alone, for which no pattern needs to be compiled."""
    return text.isascii() and text.isdigit()


def _value_of(match: re.Match[str]) -> Fraction:
    sign, whole, above, below = match.groups()
    value = int(whole or 0) + _decimal(above) / _decimal(below or "1")
    return -value if sign in _MINUS else value


def _decimal(text: str) -> Fraction:
    digits, _, exponent = text.replace(",", ".").replace("−", "-").lower().partition("e")
    return Fraction(digits) * Fraction(10) ** int(exponent or 0)


def ratio(text: str) -> Fraction:
    """Return λ = R/L from "1:5", "1:4,5", "1/4.5", "2:9", "1:10/3", "0.2"; "1:∞" is the infinite rod, 0."""
    # A slash parts R from L, too, but where a colon does it belongs to a fraction.
    said = text.strip().replace("∶", ":")
    parts = said.split(":" if ":" in said else "/")
    try:
        if len(parts) == 1:
            return number(parts[0])
        crank, rod = parts
        if rod.strip().lower() in _INFINITE:
            number(crank)
            return Fraction(0)
        length = number(rod)
        if not length:
            raise NotationError("the rod has no length")
        value = number(crank) / length
        # Two negative lengths are no ratio either; the sign lets the crank say so.
        return -abs(value) if length < 0 else value
    except (NotationError, ValueError):
        raise NotationError(
            f"crank ratio {quoted(text)} is not a ratio R:L; write it as 1:5, 1:4,5, 1/4.5 or 0.2,"
            " and 1:∞ or 1:inf for an infinite rod"
        ) from None


def angle(text: str, what: str = "angle") -> Fraction:
    """Return degrees from "45", "22.5", "2°30'", "79°20'15\"", with signs."""
    stripped = text.strip()
    if len(stripped) <= LONGEST_NUMBER and _is_plain(stripped):
        return Fraction(int(stripped))
    match = re.fullmatch(_ANGLE, stripped) if len(stripped) <= LONGEST_NUMBER else None
    if match is None or not any(match.group("deg", "min", "sec")):
        try:
            return number(text)
        except NotationError:
            raise NotationError(
                f"{what} {quoted(text)} is not an angle in degrees; write it as 22.5 or 22°30'"
            ) from None
    degrees, minutes, seconds = (number(part or "0") for part in match.group("deg", "min", "sec"))
    if minutes >= 60 or seconds >= 60:
        raise NotationError(f"{what} {quoted(text)} has 60 or more minutes or seconds; carry them over")
    value = degrees + minutes / 60 + seconds / 3600
    return -value if match.group(1) in _MINUS else value


def ratios(texts: Iterable[str], most: int = LONGEST_LIST) -> tuple[Fraction, ...]:
    """Return the ratios of lists and ranges: "1:5", "1:4;1:4,5", "1:4,1:5", "1:3..6:0.5", "0.2..0.3:0.05"."""
    parts = parts_of(map(_semicolons, texts), ratio, "crank ratio")
    return tuple(dict.fromkeys(_values(parts, ratio, partial(_ratio_range, most=most), most, "crank ratios")))


def angles(texts: Iterable[str], repeated: bool = False) -> Sequence[Fraction]:
    """Return the angles of lists and ranges: "0;30;60", "0..180:10", "2°30'..10°:2°30'".

    Each stands once, but for `repeated` ones, as of several cranks at one angle.
    """
    parts = [*parts_of(texts, angle, "angle")]
    if len(parts) == 1 and ".." in parts[0]:
        return _read(parts[0], angle, _angle_range, lists=False)
    values = _values(parts, angle, _angle_range, LONGEST_ANGLE_LIST, "angles in a list", repeated)
    return values if repeated else tuple(dict.fromkeys(values))


def numbers(texts: Iterable[str], what: str) -> tuple[Fraction, ...]:
    """Return the numbers of lists and ranges, each once: "4", "2;3;4", "2..6", "2..6:0.5"."""
    return tuple(dict.fromkeys(each_number(texts, what)))


def each_number(
    texts: Iterable[str], what: str, one: Callable[[str], Fraction] | None = None
) -> tuple[Fraction, ...]:
    """Return the numbers of lists and ranges, equal ones too: "0;0;1;1"; `one` reads each."""
    one = one or partial(number, what=what)
    several = partial(_range, what=what, one=one)
    return _values(parts_of(texts, one, what), one, several, LONGEST_LIST, f"{what}s")


def progression(start: Fraction, stop: Fraction, step: Fraction, what: str = "angle") -> Progression:
    """Return start, start + step, ... up to and including stop."""
    if stop < start:
        raise NotationError(
            f"the {what}s run from {about(start)} to {about(stop)}; the end must not lie before the start"
        )
    if step <= 0:
        raise NotationError(f"step {about(step)} leads nowhere; it must be above 0")
    if step > stop - start and stop > start:
        raise NotationError(
            f"step {about(step)} is larger than the range {about(start)}..{about(stop)};"
            f" at most {about(stop - start)} fits"
        )
    count = (stop - start) // step + 1
    if count > MOST_ROWS:
        raise NotationError(
            f"step {about(step)} makes a table of {about(Fraction(count))} rows; at most 10^9 are allowed"
        )
    return Progression(start, step, count)


def _values(
    parts: Iterable[str],
    one: Callable[[str], Fraction],
    several: Callable[[str], Sequence[Fraction]],
    most: int,
    what: str,
    lists: bool = False,
) -> tuple[Fraction, ...]:
    """Return the values of all parts, of which some are ranges; raise NotationError for too many.

    Where `lists` are more likely than ranges, sentences write what has dashes so.
    """
    found: list[Fraction] = []
    for part in parts:
        values = _read(part, one, several, lists)
        check_length(len(found) + len(values), most, what)
        found.extend(values)
    return tuple(found)


def _read(
    part: str,
    one: Callable[[str], Fraction],
    several: Callable[[str], Sequence[Fraction]],
    lists: bool,
) -> Sequence[Fraction]:
    """Return the values of a part; raise NotationError, for a range of another spelling with ours."""
    try:
        return several(part) if ".." in part else [one(part)]
    except NotationError:
        from kurbel.reading.foreign import respelled

        spelled = respelled(part, one is ratio, lists)
        if spelled in ("", part):
            raise
        for each in spelled.split(";"):
            several(each) if ".." in each else one(each)
        raise NotationError(
            f"{quoted(part)} is not how lists and ranges are written; write it as {in_shell(spelled)}"
        ) from None


def _semicolons(text: str) -> str:
    """Return a list of ratios 1:4,1:5 as 1:4;1:5; that of 1:4,5 is the comma of a decimal."""
    if "," not in text or ".." in text:
        return text
    parts = re.split(_COMMA, text)
    return ";".join(parts) if all(re.search(_COLON, part) for part in parts) else text


def parts_of(texts: Iterable[str], read: Callable[[str], Fraction], what: str) -> Iterator[str]:
    """Yield the parts of lists, each of which is one value or a range."""
    for text in texts:
        if "," in text:
            from kurbel.reading.foreign import check_commas

            check_commas(text, read, what)
        parts = [part.strip() for part in text.split(";")]
        if len(parts) > 1 and not all(parts):
            raise NotationError(f"{what} {quoted(text)} has an empty place; write a list as '2;3;4'")
        longest = max(parts, key=len)
        if len(longest) > LONGEST_RANGE:
            raise NotationError(
                f"{what} {quoted(longest)} has {len(longest)} characters; at most {LONGEST_RANGE} are read"
            )
        yield from parts


def _ratio_range(text: str, most: int) -> Sequence[Fraction]:
    """1:3..6:0.5 and 1:3..1:6 step the rod length L/R; 0.2..0.3:0.05 steps the ratio itself."""
    match = re.fullmatch(r"(?:(1)\s*[:/])?([^:/]+)\.\.(?:1\s*[:/](?=.))?([^:/]+)(?::([^:]+))?", text)
    if match is None:
        raise NotationError(
            f"crank ratio {quoted(text)} is not a range; write it as 1:3..6, 1:3..6:0.5 or 0.2..0.3:0.05"
        )
    by_length, first, last, step = match.groups()
    if by_length is None and step is None:
        raise NotationError(
            f"crank ratio {quoted(text)} needs a step; write 0.2..0.3:0.05, or 1:3..6 to step the rod length"
        )
    values = progression(number(first), number(last), number(step or "1"), "ratio")
    check_length(len(values), most, "crank ratios")
    if by_length and not all(values):
        raise NotationError(f"crank ratio {quoted(text)} contains 1:0; the rod must have a length")
    return [1 / value for value in values] if by_length else values


def _range(
    text: str, what: str, one: Callable[[str], Fraction], example: str = "2..6 or 2..6:0.5"
) -> Progression:
    """Return the numbers of a range, of which `one` reads the ends and the step."""
    match = re.fullmatch(r"([^:]+?)\.\.([^:]+)(?::([^:]+))?", text)
    if match is None:
        raise NotationError(f"{what} {quoted(text)} is not a range; write it as {example}")
    first, last, step = match.groups()
    return progression(one(first), one(last), one(step or "1"), what)


_angle_range = partial(_range, what="angle", one=angle, example="0..180:10")


def check_length(count: int, most: int, what: str) -> None:
    if count > most:
        raise NotationError(f"{count} {what} were given; at most {most} are allowed")


def in_shell(text: str) -> str:
    """Return a text as it is typed in a shell: in quotes where that would take a part of it for its own."""
    if re.fullmatch(r"[\w.,:/%=@+°²³·∞′″−-]+", text):
        return text
    if "'" in text and not re.search(r'["$`\\!]', text):
        return f'"{text}"'
    return "'" + text.replace("'", "'\"'\"'") + "'"


def quoted(text: str) -> str:
    return f'"{clipped(text)}"'


def clipped(text: str) -> str:
    return text if len(text) <= LONGEST_NUMBER else f"{text[:20]}..."


def share(text: str, what: str = "share") -> Fraction:
    """Return a share: "0.05", "0,05", "1/20", "1:20", "5%", "5 %"."""
    stripped = text.strip()
    part = _PERCENT.fullmatch(stripped)
    above, colon, below = stripped.partition(":")
    try:
        if part:
            return number(part[1], what) / (1000 if part[2] == _PER_MILLE else 100)
        if colon:
            return number(above, what) / number(below, what)
    except (NotationError, ZeroDivisionError):
        raise NotationError(
            f"{what} {quoted(text)} is not a share; write it as 0.05, 5%, 1/20 or 1:20"
        ) from None
    return number(stripped, what)


def shares(texts: Iterable[str], what: str) -> tuple[Fraction, ...]:
    """Return the shares of lists and ranges, each once: "2/3", "50%;60%", "0..1:0.1", "0,5"."""
    decimals = (_ZERO_COMMA.sub("0.", text) for text in texts)
    return tuple(dict.fromkeys(each_number(decimals, what, partial(share, what=what))))


def refuse_cut_off(given: object) -> None:
    """Raise ProblemError for an expansion ratio that is the share of the stroke before the cut-off."""
    values = [given] if isinstance(given, str) or not isinstance(given, Iterable) else given
    for text in (part for value in values for part in str(value).split(";")):
        try:
            # Of 2:6 a range is more likely to be meant.
            found = share(text) if ":" not in text or text.strip().startswith("1:") else Fraction(1)
        except NotationError:
            continue
        if 0 < found < 1:
            raise ProblemError(too_small(found))


def too_small(expansion: Fraction) -> str:
    """Return the sentence that refuses an expansion ratio below 1."""
    meant = f": after {exact_text(expansion)} of it, ε = {exact_text(1 / expansion)}" if expansion > 0 else ""
    return (
        f"expansion ratio ε is {about(expansion)}; it must be 1 (no expansion) or more,"
        f" for the cut-off comes after the share 1/ε of the stroke{meant}"
    )
