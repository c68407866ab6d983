"""What a page can show: one kind of entry, whatever the page is about."""

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction
from functools import cache
from typing import Any, NamedTuple, TypeAlias

from kurbel.exact.numerals import Label, Number, figures
from kurbel.kernel.circle import Numeric
from kurbel.page.labels import plain
from kurbel.reading.notation import ratio_text

_HERE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
# A text in every language.
Words = Mapping[str, str]


def words(text: str) -> Words:
    """Return "German|English", or one text for both, by language."""
    de, _, en = text.partition("|")
    return {"de": de, "en": en or de}


class Texts(Mapping[str, Words]):
    """What pages of a package such as "engine.loads" say: a section of its texts.toml, by key; read when the
    first of them is said.

    A text is `key.de` and `key.en` there, or `key` alone if it is the same in both languages.
    """

    def __init__(self, package: str, section: str) -> None:
        self._package, self._section = package, section

    def __getitem__(self, key: str) -> Words:
        return _in_both(self._texts[key])

    def __iter__(self) -> Iterator[str]:
        return iter(self._texts)

    def __len__(self) -> int:
        return len(self._texts)

    @property
    def _texts(self) -> Mapping[str, Words | str]:
        return _read(self._package)[self._section]


@cache
def _read(package: str) -> Mapping[str, Mapping[str, Words | str]]:
    import tomllib

    with open(os.path.join(_HERE, *package.split("."), "texts.toml"), "rb") as stream:
        return tomllib.load(stream)


def _in_both(text: Words | str) -> Words:
    return {"de": text, "en": text} if isinstance(text, str) else text


AND = words(" und | and ")
FOR = words(" für | for ")


class Formula(NamedTuple):
    """The kernel's formula of a quantity by one method, and as pages print it below their tables.

    What the kernel call takes, the subject says; `printed` has places in braces that its page fills, and is
    empty where a line does not hold the formula. `symbols` say what it leaves to be said of its letters.
    """

    kernel: Callable[..., Any]
    printed: Label = ""
    symbols: tuple[Label, ...] = ()


@dataclass(frozen=True, eq=False)
class Need:
    """What must be known before a quantity can be computed; the same only as itself.

    `is_known` tells whether it is, of what the subject has it of: a crank, or the question itself. `options`
    give it, and lists of quantities have them; refusals have `words` where the options do not say it.
    """

    is_known: Callable[[Any], object]
    options: tuple[str, ...] = ()
    words: str = ""

    def __str__(self) -> str:
        return self.words or " and ".join(self.options)


Of = Enum(
    "Of",
    "ANY TURN STROKE LEAST GREATEST ANGLE CRANK CYLINDER ORDER SPEED EVENNESS FLYWHEEL FORCE PLACE SPAN SHARE"
    " ERROR AMOUNT DIRECTION",
)
"""What a number is of: ANY where its subject knows it."""


class Quantity(NamedTuple):
    """An entry: what a column shows, all that is said of it, and how it is computed.

    `symbol`, `unit`, `heading` and `spanners` are labels. `part` sets it apart from others of its name: a
    stroke, a direction, a model. `decimals` None prints five figures; with `minutes` pages print degrees and
    minutes and records degrees to so many decimals.

    `formulas` are by method. `scale` makes the quantity's unit of the kernel's. `bound` is how far a float
    can lie from the true value, in units of the subject's own bound. `needs` are what must be known of the
    drive or the load, `of` is what it is a number of: a turn, a stroke, an angle. `model` is that of the rod
    by which it is computed. `names` are those under which conditions know it; `rises` tells that between the
    dead centres it only rises or only falls. `direction` says in which direction it counts. Where `exists` is
    not above 0 there is no such number.
    """

    key: str
    name: Words
    symbol: Label
    unit: Words
    decimals: int | None
    formulas: Mapping[str, Formula]
    heading: Words
    spanners: tuple[Words, ...] = ()
    part: Words | None = None
    minutes: bool = False
    stroke: int = 1
    scale: Callable[..., Numeric] | None = None
    bound: float = 1.0
    needs: tuple[Need, ...] = ()
    of: Of = Of.ANY
    model: str = ""
    names: tuple[str, ...] = ()
    rises: bool = False
    direction: Words | None = None
    exists: Callable[[Any], Any] | None = None

    @property
    def options(self) -> tuple[str, ...]:
        """The options that give what it needs."""
        return tuple(option for need in self.needs for option in need.options)

    @property
    def in_degrees(self) -> bool:
        return self.unit["en"] == "°"

    def plain_unit(self, lang: str) -> str:
        """Return the unit as text."""
        return plain(self.unit[lang])

    def unit_beside(self, lang: str) -> Label:
        """Return the unit that stands beside a number; degrees and minutes have theirs within."""
        return "" if self.minutes else self.unit[lang]

    def full_name(self, lang: str) -> str:
        """Return the name with what sets it apart."""
        return f"{self.name[lang]}, {self.part[lang]}" if self.part else self.name[lang]


class Letter(NamedTuple):
    """What lists say of a quantity: `symbol`, `unit` and how it counts are labels and may be empty."""

    name: str
    symbol: Label
    unit: Label
    direction: Label = ""


# What a quantity of a head such as "greatest speed at" or "thrust over" is.
_AT: Mapping[str, tuple[str, ...]] = {"de": (" bei", " über"), "en": (" at", " over")}
_ANGLE = words("Winkel: {}|angle: {}")


def named(name: str, lang: str) -> str:
    """Return the name of a quantity outside of its head."""
    end = next((one for one in _AT[lang] if name.endswith(one)), "")
    return _ANGLE[lang].format(name.removesuffix(end)) if end else name


def letter(quantity: Quantity, lang: str) -> Letter:
    """Return what lists say of a quantity."""
    direction = quantity.direction[lang] if quantity.direction else ""
    return Letter(named(quantity.name[lang], lang), quantity.symbol, quantity.unit[lang], direction)


def entry(
    key: str,
    name: str,
    symbol: Label,
    unit: Label,
    decimals: int | None,
    formulas: Mapping[str, Formula],
    heading: str = "",
    **rest: Any,
) -> Quantity:
    """Return an entry from texts "German|English", headed by symbol and unit where nothing else is said."""
    heading = heading or (f"{symbol} in {unit}" if unit else symbol)
    return Quantity(key, words(name), symbol, words(unit), decimals, formulas, words(heading), **rest)


def with_symbol(quantity: Quantity) -> Words:
    """Return the name with the symbol behind it, as a stub has them."""
    return {lang: f"{name} {quantity.symbol}".rstrip() for lang, name in quantity.name.items()}


def multiplied(quantity: Quantity, times: Fraction) -> Quantity:
    """Return a quantity whose numbers are so many times those of another."""
    if times == 1:
        return quantity
    above, below = times.numerator, times.denominator

    def scaled(function: Callable[..., Any]) -> Callable[..., Any]:
        def call(*at: object) -> object:
            found = function(*at)
            return found if found is None else found * above / below

        return call

    # Two more roundings of floats.
    changed = quantity._replace(bound=2 * quantity.bound)
    if quantity.scale is not None:
        return changed._replace(scale=scaled(quantity.scale))
    formulas = {key: one._replace(kernel=scaled(one.kernel)) for key, one in quantity.formulas.items()}
    return changed._replace(formulas=formulas)


class Column(NamedTuple):
    """A column of a page with all choices made. `methods` are one, or two whose difference is shown. A number
    of five figures has so many decimals at the `least`."""

    key: str
    quantity: Quantity
    methods: tuple[str, ...]
    decimals: int | None
    spanners: tuple[Label, ...]
    heading: tuple[Label, ...]
    least: int = 0

    @property
    def method(self) -> str:
        return self.methods[0]

    @property
    def places(self) -> int:
        """The decimals of a quantity that has so many of its own."""
        assert self.decimals is not None
        return self.decimals


# A number of a page: the key of its column, and its place.
Known: TypeAlias = tuple[str, frozenset[tuple[str, int]]]


def known_at(column: Column, place: Mapping[str, int]) -> Known:
    return column.key, frozenset(place.items())


def is_short(number: Number, column: Column) -> bool:
    """Whether a number of five figures has fewer decimals than the column has at the least.

    What is printed to fewer figures is exact.
    """
    return number.decimals < column.least and number.decimals == figures(number.scaled / 10**number.decimals)


def bare(quantity: Quantity, method: str, decimals: int | None) -> Column:
    """Return a column without heads, of a number that stands alone."""
    return Column(quantity.key, quantity, (method,), decimals, (), ())


def for_ratio(ratio: Fraction, lang: str, symbol: str = "R:L") -> Label:
    """Return " für $R:L = 1:5$"."""
    return f"{FOR[lang]}${symbol} = {ratio_text(ratio)}$"


def enumerated(quantities: Iterable[str], lang: str) -> str:
    """Return their names, each once: Kolbenweg, Kolbengeschwindigkeit und Kolbenbeschleunigung."""
    names = list(dict.fromkeys(quantities))
    if lang == "en":
        names[1:] = [name.lower() for name in names[1:]]
    # German names that begin with an adjective have a small letter: mittlere Kolbengeschwindigkeit.
    names[:1] = [name[:1].upper() + name[1:] for name in names[:1]]
    return AND[lang].join(part for part in (", ".join(names[:-1]), names[-1]) if part)


def enumerated_letters(letters: Sequence[str], lang: str) -> Label:
    """Return "$X$ and $P$"."""
    *others, last = (f"${letter}$" for letter in letters)
    return ", ".join(others) + AND[lang] + last if others else last


def filled(text: Label, parts: Iterable[tuple[str, str]]) -> Label:
    """Return a text with its places in braces filled; what braces are left belong to formulas."""
    for place, part in parts:
        text = text.replace(place, part)
    return text
