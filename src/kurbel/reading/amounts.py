"""Units as people write them, in one spelling: kg*m*m of kg m^2, /min of min⁻¹, N/mm/mm of N·mm⁻²; and
amounts as pages print them: in metric units, or in those that were typed or asked for.

Every factor is an exact rational number, so that a converted digit is as certain as another.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple

from kurbel.errors import NotationError
from kurbel.exact.numerals import (
    FIGURES,
    Label,
    figure,
    figures,
    finite_decimals,
    nearest,
    number_text,
    plain,
)
from kurbel.reading.notation import quoted

INCH, FOOT, POUND = Fraction("0.0254"), Fraction("0.3048"), Fraction("0.45359237")
# By definition, of the third general conference on weights and measures, in m/s².
STANDARD_GRAVITY = Fraction(980665, 100000)
POUND_FORCE = POUND * STANDARD_GRAVITY
METRIC, IMPERIAL = "metric", "imperial"
# Of a column with forces in some rows and moments in others.
BOTH = "N, N m"
_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻−", "0123456789+--")
_FACTOR = (
    r"\s*(?P<name>[A-Za-zµμ_]+)"
    r"(?:\s*(?:\^|\*\*)\s*(?P<power>\(\s*[+-]?[1-9]\s*\)|[+-]?[1-9])(?!\d)|(?P<behind>[+-]?[1-9])(?!\d))?"
)
_SIGN = r"\s*([*·×⋅/]|-(?=[A-Za-z])|)\s*"
_OVER = frozenset(("/", "per", "je", "pro"))
# Two units written as one, of which only the last has the power.
_JOINED = r"([kMm]?N|kg)(m)|(lbf?)(ft)"
# Umdrehungen and Pferdestärken, as German data sheets write them: pint's U is the unit of enzymes, and its PS
# are petasiemens.
_NAMES = {
    "μm": "µm", "U": "turn", "Umdr": "turn", "rev": "turn", "PS": "metric_horsepower", "Zoll": "in",
    "sec": "s", "sek": "s", "Sek": "s", "Upm": "rpm", "UPM": "rpm", "RPM": "rpm", "r": "turn",
}  # fmt: skip
_WHOLE = {"turn/min": "rpm", "turn/s": "/s"}
# Longer ones are not written; their powers are multiplied out.
_MOST = 12


# What products of units are made of, with their sizes in units of the SI: by the powers of the metre, the
# kilogram and the second in these.
_MADE_OF: Mapping[tuple[int, int, int], Mapping[str, Fraction | str | int]] = {
    (1, 0, 0): {
        **{"m": 1, "km": 1000, "dm": "1/10", "cm": "1/100", "mm": "1/1000"},
        **{"in": INCH, "inch": INCH, "ft": FOOT},
    },
    (0, 1, 0): {"kg": 1, "g": "1/1000", "t": 1000, "lb": POUND},
    (0, 0, 1): {"s": 1, "ms": "1/1000", "min": 60, "h": 3600},
    (1, 0, -1): {"mph": 5280 * FOOT / 3600},
    (1, 1, -2): {"N": 1, "kN": 1000, "MN": 10**6, "kgf": "9.80665", "lbf": POUND_FORCE},
    (2, 1, -2): {"J": 1, "kJ": 1000, "MJ": 10**6, "kWh": 3_600_000},
    (2, 1, -3): {"W": 1, "kW": 1000, "MW": 10**6, "hp": 550 * FOOT * POUND_FORCE},
    (-1, 1, -2): {
        **{"Pa": 1, "kPa": 1000, "MPa": 10**6, "bar": 10**5, "mbar": 100},
        **{"psi": POUND_FORCE / INCH**2, "at": "98066.5", "atm": 101325},
    },
    (3, 0, 0): {"l": "1/1000", "L": "1/1000"},
}


class KnownUnit(NamedTuple):
    """The size of a unit in that of the SI, with the powers of the metre, the kilogram and the second."""

    size: Fraction
    powers: tuple[int, ...]


FACTORS: Mapping[str, KnownUnit] = {
    name: KnownUnit(Fraction(size), powers)
    for powers, sizes in _MADE_OF.items()
    for name, size in sizes.items()
}


@lru_cache(maxsize=256)
def known_unit(text: str) -> KnownUnit | None:
    """Return a product of units, None for one that has others than those of everyday."""
    factors = re.findall("(/?)([^*/]+)", plain_unit(text) or "")
    if not factors or not all(name in FACTORS for _, name in factors):
        return None
    size = Fraction(1)
    powers: tuple[int, ...] = (0, 0, 0)
    for over, name in factors:
        own, sign = FACTORS[name], -1 if over else 1
        size *= own.size**sign
        powers = tuple(one + sign * other for one, other in zip(powers, own.powers, strict=True))
    return KnownUnit(size, powers)


class Unit(NamedTuple):
    """A unit: as pages and --units write it, its dimension, and what keys of columns in it end with."""

    symbol: str
    dimension: str
    ending: str

    @property
    def size(self) -> Fraction:
        """What it is in that of the SI; of forces and moments that of the forces."""
        known = known_unit(self.symbol.partition(",")[0])
        assert known is not None
        return known.size

    def heading(self, lang: str) -> str:
        """Return what heads call it."""
        return {"de": "Zoll", "en": "inches"}[lang] if self.symbol == "in" else self.symbol


# Units of pages by their dimensions.
_OF_PAGES: Mapping[str, str] = {
    "length": "mm; cm; m; in; ft",
    "velocity": "m/s; ft/s; in/s",
    "speed of a train": "km/h; mph",
    "acceleration": "m/s²; ft/s²; in/s²",
    "force": "N; kN; MN; lbf",
    "torque": "N m; kN m; MN m; lbf ft; lbf in",
    "energy": "J; kJ; MJ; ft lbf",
    "power": "W; kW; MW; hp",
    "pressure": "kPa; bar; MPa; psi",
    "mass": "kg; t; lb",
    "unbalance": "kg m; lb ft; lb in",
    "moment of inertia": "kg m²; lb ft²",
    "area": "cm²; in²",
    "density": "kg/m³; lb/in³",
    "flow": "m³/min; ft³/min",
    "specific volume": "m³/kg; ft³/lb",
    "mass flow": "kg/h; kg/min; lb/h",
    "mass per work": "kg/kWh; lb/(hp h)",
    "work per mass": "kJ/kg; ft lbf/lb",
    "volume": "l; in³",
}
# What keys of columns end with where that is not the letters and figures of the unit.
_ENDINGS = {"kg/kWh": "kwh", "lb/(hp h)": "hph"}


def _ending(symbol: str) -> str:
    letters = symbol.replace("/s", "ps").translate(_SUPERSCRIPTS).lower()
    return _ENDINGS.get(symbol, re.sub("[^a-z0-9]", "", letters))


UNITS: Mapping[str, Unit] = {
    symbol: Unit(symbol, dimension, _ending(symbol))
    for dimension, symbols in _OF_PAGES.items()
    for symbol in symbols.split("; ")
}
NEWTON, NEWTON_METRE = (UNITS[one] for one in BOTH.split(", "))
# What pages have in place of a unit in which a number has five digits before the decimal mark.
LARGER: Mapping[str, str] = {
    **{"N": "kN", "kN": "MN", "N m": "kN m", "kN m": "MN m"},
    **{"J": "kJ", "kJ": "MJ", "W": "kW", "kW": "MW", "kPa": "MPa"},
}
LONG = 10_000
OF_SYSTEM = {
    IMPERIAL: "in; ft/s; ft/s²; mph; lbf; lbf ft; ft lbf; hp; psi; lb; lb ft; lb ft²; in²; lb/in³; ft³/min;"
    " ft³/lb; lb/h; lb/(hp h)",
    METRIC: "",
}


class Units(NamedTuple):
    """The unit of every dimension that has another one than the metric pages; `data` whether records have
    them, too, whose keys then say so. Those that are `taken` nobody asked for; no digit is lost in them."""

    chosen: Mapping[str, Unit]
    data: bool = True
    taken: frozenset[str] = frozenset()

    def of(self, symbol: Label) -> tuple[Unit, Unit] | None:
        """Return a unit of metric pages and the one in its place, None where it stays."""
        if symbol == BOTH:
            pair = _both(NEWTON, NEWTON_METRE), _both(*map(self.instead, (NEWTON, NEWTON_METRE)))
        elif (own := UNITS.get(symbol)) is not None:
            pair = own, self.instead(own)
        else:
            return None
        return None if pair[0] == pair[1] else pair

    def instead(self, own: Unit) -> Unit:
        """Return the unit of the dimension of a metric one, which may be that."""
        return self.chosen.get(own.dimension, own)

    def times(self, symbol: Label) -> Fraction:
        """Return how many of the unit in its place one of metric pages is."""
        own = UNITS.get(symbol)
        return own.size / self.instead(own).size if own else Fraction(1)

    def key(self, key: str, unit: str) -> str:
        """Return the key under which records in these units have a column, whose unit is this one now."""
        pair = self.of(BOTH)
        other = next((one for one in (*self.chosen.values(), *(pair or ())[1:]) if one.symbol == unit), None)
        if other is None:
            return key
        endings = "|".join(one.ending for one in UNITS.values() if one.dimension == other.dimension)
        return f"{re.sub(f'_(?:{endings})$', '', key)}_{other.ending}"


def _both(force: Unit, torque: Unit) -> Unit:
    """Return the unit of a column with forces in some rows and moments in others: of these each has its own
    size. Keys end as those of forces where the unit of moments is of the same kind, else as those of both."""
    alike = torque.ending in (f"{force.ending}m", f"{force.ending}ft")
    ending = force.ending if alike else f"{force.ending}_{torque.ending}"
    return force._replace(symbol=f"{force.symbol}, {torque.symbol}", ending=ending)


def read_units(text: str) -> Units:
    """Return the units of a system, metric or imperial, or those of a list: in; ft/s; lbf."""
    written = {plain_unit(symbol): symbol for symbol in UNITS}
    listed = OF_SYSTEM.get(text.strip().lower(), text)
    chosen: dict[str, Unit] = {}
    for name in filter(None, (part.strip() for part in re.split("[;,]", listed))):
        unit = UNITS.get(name) or UNITS.get(written.get(plain_unit(name), ""))
        if unit is None:
            raise NotationError(
                f"units {quoted(text)} has the unit {quoted(name)}; write metric, imperial or a list of"
                f" {', '.join(UNITS)}"
            )
        if chosen.setdefault(unit.dimension, unit) != unit:
            raise NotationError(
                f"units {quoted(text)} has {chosen[unit.dimension].symbol} and {unit.symbol}, both of"
                f" {unit.dimension}; leave one out"
            )
    return Units(chosen)


def larger(symbol: str, value: Fraction) -> str:
    """Return the unit in which a value in this one has four digits before the decimal mark, or fewer."""
    while symbol in LARGER and abs(value) >= LONG:
        symbol, value = LARGER[symbol], value / 1000
    return symbol


# The units of the page that is being made.
_OF_PAGE: ContextVar[Units | None] = ContextVar("units", default=None)
# The larger units that the page has taken by itself; None where no amount of it has such.
TAKEN: ContextVar[set[str] | None] = ContextVar("larger units", default=None)


@contextmanager
def printed_in(units: Units) -> Iterator[None]:
    """Have the amounts below and above a table in these units."""
    token = _OF_PAGE.set(units)
    try:
        yield
    finally:
        _OF_PAGE.reset(token)


def amount(value: Fraction, symbol: str, shown: Callable[[Fraction], str] = figure) -> Label:
    """Return an amount of the SI as it stands in a formula, on metric pages in this unit or a larger one."""
    value /= UNITS[symbol].size
    times, label = unit_of_page(symbol, value)
    return f"{digits(value, times, shown)} {label}"


def digits(value: Fraction, times: Fraction, shown: Callable[[Fraction], str] = figure) -> str:
    """Return the digits of an amount in a unit of the page, of which its own is so many.

    In a unit that it was not given in it is exact where six decimals write it, else it has three, and three
    figures of what is small: of an inch a millimetre is 5/127, which tells no reader its size.
    """
    text = shown(value)
    if times == 1:
        return text
    is_power_of_ten = times == Fraction(1, 10 ** (len(str(1 / times)) - 1))
    if is_power_of_ten and "/" not in text:
        return moved(text, times, exact=Fraction(text) == value)
    value *= times
    exact = finite_decimals(value)
    decimals = exact if exact is not None and exact <= 6 else max(3, figures(float(value)) - FIGURES + 3)
    return number_text(nearest(value, decimals))


def moved(text: str, times: Fraction, exact: bool) -> str:
    """Return the digits of a number in a unit that is a power of ten larger, all unless it is exact."""
    if times == 1:
        return text
    places = len(text.partition(".")[2]) + len(str(1 / times)) - 1
    return plain(times * Fraction(text)) if exact else number_text(nearest(times * Fraction(text), places))


def unit_of_page(symbol: str, value: Fraction = Fraction(0)) -> tuple[Fraction, Label]:
    """Return how many units of the page a metric one is, and the label of that as it stands in a formula.

    A page that was asked for no unit has a larger one for a long value, whatever its columns have.
    """
    units, taken = _OF_PAGE.get(), TAKEN.get()
    pair = None if units is None or _is_own(symbol) else units.of(symbol)
    printed = pair[1].symbol if pair else symbol
    if taken is not None and _is_own(symbol) and (longer := larger(symbol, value)) != symbol:
        printed = longer
        taken.add(longer)
    label = f'"{printed}"'.replace("³/", '"^3/"').replace('²"', '"^2')
    return UNITS[symbol].size / UNITS[printed].size, label


def _is_own(symbol: str) -> bool:
    """Whether no unit was asked for in place of a metric one."""
    units, dimension = _OF_PAGE.get(), UNITS[symbol].dimension
    return units is None or dimension not in units.chosen or dimension in units.taken


def plain_unit(text: str) -> str | None:
    """Return a unit as factors without powers, N/mm/mm, or None for what is no product of units.

    A stroke is over the next factor only.
    """
    above: list[str] = []
    below: list[str] = []
    try:
        for name, power in factors_of(text):
            (above if power > 0 else below).extend([name] * abs(power))
    except ValueError:
        return None
    if not 0 < len(above) + len(below) <= _MOST:
        return None
    found = "*".join(above) + "".join(f"/{name}" for name in below)
    return _WHOLE.get(found, found)


def factors_of(text: str) -> Iterator[tuple[str, int]]:
    """Yield the names in a product of units and their powers; raise ValueError for anything else."""
    text = text.translate(_SUPERSCRIPTS).strip()
    # What a stroke is over in brackets is over one by one: lb/(hp h).
    rest, sign = re.sub(r"/\s*\((\w+)[\s*·]+(\w+)\)", r"/\1/\2", re.sub(r"^1\s*(?=/)", "", text)), 1
    if rest.startswith("/"):
        rest, sign = rest[1:], -1
    while rest:
        match = re.match(_FACTOR, rest)
        if match is None:
            raise ValueError(text)
        name, rest = match["name"], rest[match.end() :]
        if name in _OVER:
            sign = -1
            continue
        power = sign * int((match["power"] or match["behind"] or "1").strip("() "))
        joined = re.fullmatch(_JOINED, name)
        first, last = [one for one in joined.groups() if one] if joined else ("", name)
        if first:
            yield first, sign
        yield _NAMES.get(last, last), power
        between = re.match(_SIGN, rest)
        assert between is not None
        sign, rest = -1 if between[1] in _OVER else 1, rest[between.end() :]
        if between[1] and not rest:
            raise ValueError(text)
