"""The values of an option that is given several, and which options of a page are sliders, by which steps."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from math import prod
from typing import Any, NamedTuple, overload

from kurbel.commands.options import TEXT, Option, is_given
from kurbel.drive.size import is_written
from kurbel.errors import NotationError, ProblemError
from kurbel.exact.numerals import Label, finite_decimals, ratio_text
from kurbel.page.build import MOST_CELLS
from kurbel.page.quantity import Words, words
from kurbel.page.steps import Slider
from kurbel.reading import notation
from kurbel.reading.given import as_ratios
from kurbel.reading.notation import Progression, check_length, number, plain, progression, quoted

# Two hundred pages of the usual size are some seconds and about half a megabyte.
MOST_STEPS = 1000
RATIOS = tuple(Fraction(2, length) for length in range(6, 13))
"""1:3 to 1:6, by half radii of the rod: the steps where nothing is said of the ratio."""
CUT_OFFS = tuple(map(Fraction, range(2, 7)))
"""ε of 2 to 6, likewise, on pages of steam over the crank angle."""
# What can be chosen, by the names of options.
WORDS: Mapping[str, Words] = {
    "ratio": words("Kurbelverhältnis ${ratio}$|Crank ratio ${ratio}$"),
    "offset": words("Schränkung $e/R$|Offset $e/R$"),
    "rocker": words("Schwinge $B/R$|Rocker $B/R$"),
    "beam": words("Balancierarm $a/R$|Beam arm $a/R$"),
    "eps": words("Expansionsverhältnis $ε$|Expansion ratio $ε$"),
    "back": words("Gegendruck|Back pressure"),
    "exponent": words("Exponent $n$|Exponent $n$"),
    "clearance": words("Schädlicher Raum|Clearance"),
    "pressure": words("Dampfdruck|Steam pressure"),
    "force": words("Kolbenkraft $F$|Piston force $F$"),
    "stroke": words("Hub|Stroke"),
    "rod": words("Schubstange $L$|Connecting rod $L$"),
    "bore": words("Bohrung|Bore"),
    "speed": words("Drehzahl|Speed"),
    "reciprocating": words("Hin- und hergehende Masse|Reciprocating mass"),
    "acceleration": words("Winkelbeschleunigung der Kurbel|Angular acceleration of the crank"),
    "flywheel": words("Schwungrad|Flywheel"),
}
LONGEST = 10**6
_MEASURE = re.compile(r"([-−+]?[\d.,]+(?:[eE][+-]?\d+)?(?:/\d+)?)\s*(.*)")
_RANGE = re.compile(r"(.+?)\.\.([^:]+)(?::(.+))?")


class SliderOption(NamedTuple):
    """An option that is a slider: its values as the command takes them, and how each is written."""

    name: str
    values: tuple[object, ...]
    texts: tuple[Label, ...]
    start: int = 0

    def slider(self, lang: str, ratio: Label) -> Slider:
        """Return it as pages of a language show it, which write the ratio so."""
        label = WORDS[self.name][lang].replace("{ratio}", ratio)
        return Slider(self.name, label, self.texts, self.start)


def choices(options: Mapping[str, Option[object]], values: Mapping[str, object]) -> list[SliderOption]:
    """Return the sliders of a command's values: the options that have several. Raises KurbelError for what
    cannot be read.

    Expansion ratios are steps of a page over the crank angle, and the rows of others.
    """
    names = [name for name in WORDS if name in options and is_given(values.get(name))]
    return [choice for name in names if (choice := _choice(name, options, values[name]))]


def usual_ratios(own: Sequence[Fraction], turns: Callable[[Fraction], bool]) -> SliderOption:
    """Return the crank ratios of a page of which nothing is said: if it has one of its own, the usual ones
    around it with which the drive `turns`."""
    if len(own) > 1:
        return _of_ratios(own)
    ratios = sorted({own[0], *filter(turns, RATIOS)}, reverse=True)
    return _of_ratios(ratios)._replace(start=ratios.index(own[0]))


def usual_cut_offs(own: Sequence[Fraction]) -> SliderOption:
    """Return the expansion ratios of a page of which nothing is said, its own one among them."""
    numbers = own if len(own) > 1 else sorted({*own, *CUT_OFFS})
    texts = tuple(map(figures, numbers))
    return SliderOption("eps", texts, tuple(map(_written, texts)), numbers.index(own[0]))


def check_count(found: Sequence[SliderOption]) -> None:
    """Raise ProblemError for too many steps."""
    if (count := prod(len(one.values) for one in found)) > MOST_STEPS:
        said = " x ".join(f"{len(one.values)} of --{one.name}" for one in found)
        raise ProblemError(
            f"an interactive page of {count} steps ({said}) is too large; at most {MOST_STEPS} are allowed,"
            " so give fewer values, such as a range with a wider step"
        )


def check_numbers(numbers: int, found: Sequence[SliderOption]) -> None:
    """Raise ProblemError for steps of so many numbers that no browser shows them at once."""
    if (count := prod([numbers, *(len(one.values) for one in found)])) > MOST_CELLS:
        raise ProblemError(
            f"an interactive page of {count} numbers in all its steps is too large; at most {MOST_CELLS} are"
            " allowed, so give fewer angles, such as --step 10, or fewer steps"
        )


def steps(found: Sequence[SliderOption]) -> Iterator[tuple[dict[str, object], str]]:
    """Yield the values of each step by their options, and the step in words."""
    for places in product(*(range(len(one.values)) for one in found)):
        chosen = list(zip(found, places, strict=True))
        said = ", ".join(f"--{one.name} {one.texts[place].strip('$')}" for one, place in chosen)
        yield {one.name: one.values[place] for one, place in chosen}, said


def _of_ratios(ratios: Sequence[Fraction]) -> SliderOption:
    return SliderOption("ratio", tuple(ratios), tuple(f"${ratio_text(one)}$" for one in ratios))


def _choice(name: str, known: Mapping[str, Option[object]], given: object) -> SliderOption | None:
    """Return a slider, nothing for one value."""
    if name == "ratio":
        ratios = as_ratios(given)
        return _of_ratios(ratios) if len(ratios) > 1 else None
    if known[name].many and not (name == "eps" and "angle" in known):
        return None
    texts = [str(one) for one in given] if isinstance(given, list | tuple) else [str(given)]
    found = values_of(name, texts)
    check_length(len(found), MOST_STEPS, f"steps of --{name}")
    return SliderOption(name, tuple(found), tuple(map(_written, found))) if len(found) > 1 else None


def _written(text: str) -> Label:
    """Return a value as pages write it: a number, and the unit as it was given."""
    shown, unit = parted(text)
    if not is_measured(text):
        return text.replace("$", "")
    space = " " if unit and not unit.startswith(("/", "°")) else ""
    return f"${figures(number(shown))}${space}{unit.replace('$', '')}"


@dataclass(frozen=True, slots=True)
class SpacedValues(Sequence[str]):
    """Equally spaced numbers as one types them, with the unit of their range: 100/min, 120/min."""

    numbers: Progression
    unit: str

    def __len__(self) -> int:
        return self.numbers.size

    @overload
    def __getitem__(self, index: int) -> str: ...
    @overload
    def __getitem__(self, index: slice) -> SpacedValues: ...
    def __getitem__(self, index: int | slice) -> str | SpacedValues:
        if isinstance(index, slice):
            return SpacedValues(self.numbers[index], self.unit)
        return f"{figures(self.numbers[index])}{self.unit}"


def several(option: Option[object], texts: Iterable[Any]) -> Sequence[object]:
    """Return the values that the texts list, each once, as the command takes them one at a time.

    A range is never written out. Raises NotationError.
    """
    name, given = option.name, list(texts)
    if option.whole:
        return tuple(dict.fromkeys(given))
    if not all(isinstance(one, str) for one in given):
        return tuple(dict.fromkeys(given))
    if name == "ratio":
        return notation.ratios(given, LONGEST)
    if option.unit == "degrees":
        return notation.angles(given) if any(";" in one or ".." in one for one in given) else tuple(given)
    values = values_of(name, given)
    if option.kind is TEXT:
        return values
    return tuple(dict.fromkeys(option.kind.read(one, {}) for one in values))


def values_of(name: str, texts: Sequence[str]) -> Sequence[str]:
    """Return the values of lists and ranges of numbers with or without units, each once."""
    if way := next(filter(is_written, texts), "").partition(":")[0]:
        # All are written so: crank:200..400mm:100.
        rests = [text.removeprefix(f"{way}:") for text in texts]
        return tuple(f"{way}:{one}" for one in values_of(name, rests))
    parts = [part.strip() for text in texts for part in text.split(";")]
    if len(parts) > 1 and not all(parts):
        raise NotationError(f"{name} {quoted(';'.join(texts))} has an empty place; write a list as '2;3;4'")
    parts = _in_one_unit(parts)
    if len(parts) == 1:
        return _range(parts[0], name) if ".." in parts[0] else tuple(parts)
    found: list[str] = []
    for part in parts:
        values: Sequence[str] = _range(part, name) if ".." in part else (part,)
        check_length(len(found) + len(values), LONGEST, f"values of --{name.replace('_', '-')}")
        found += values
    return tuple(dict.fromkeys(found))


def _in_one_unit(parts: list[str]) -> list[str]:
    """Return the parts with the unit that stands behind the last one alone: 100;120/min."""
    unit = parted(parts[-1])[1]
    bare = all(not parted(one)[1] and is_measured(one) for one in parts[:-1])
    if len(parts) == 1 or not bare or not unit or unit in ("%", "°") or ".." in parts[-1]:
        return parts
    return [*(f"{one}{unit}" for one in parts[:-1]), parts[-1]]


def _range(text: str, name: str) -> SpacedValues:
    """Return the values of a range, whose unit may stand at each of its parts or once: 100..140:20/min."""
    match = _RANGE.fullmatch(text)
    if match is None:
        raise NotationError(f"{name} {quoted(text)} is not a range; write it as 2..6 or 2..6:0.5")
    parts = [parted(part) for part in match.groups("1")]
    units = dict.fromkeys(unit for _, unit in parts if unit)
    if len(units) > 1:
        raise NotationError(
            f"{name} {quoted(text)} has the units {' and '.join(units)}; give its ends and its step in one"
        )
    first, last, step = (number(shown, name) for shown, _ in parts)
    return SpacedValues(progression(first, last, step, name), next(iter(units), ""))


def parted(text: str) -> tuple[str, str]:
    """Return the figures of a value, and its unit; what has no figures is all figures."""
    match = _MEASURE.fullmatch(text.strip())
    return (match[1], match[2]) if match else (text, "")


def is_measured(text: str) -> bool:
    """Whether the text begins with figures."""
    return _MEASURE.fullmatch(text) is not None


def figures(value: Fraction) -> str:
    return str(value) if finite_decimals(value) is None else plain(value)
