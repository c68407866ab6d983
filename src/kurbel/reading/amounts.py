"""Units as people write them, in one spelling: kg*m*m of kg m^2, /min of min⁻¹, N/mm/mm of N·mm⁻²; and
amounts as pages print them: in metric units, or in those that were typed or asked for.

Every factor is an exact rational number, so that a converted digit is as certain as another.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from fractions import Fraction
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
POUND_FORCE = POUND * Fraction("9.80665")
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


class Unit(NamedTuple):
    """A unit: as pages and --units write it, its dimension, what it is in that of the SI, what keys of
    columns in it end with, and what heads call it where that is another word."""

    symbol: str
    dimension: str
    size: Fraction
    ending: str
    named: Mapping[str, str] | None = None

    def heading(self, lang: str) -> str:
        """Return what heads call it."""
        return self.named[lang] if self.named else self.symbol


def _units() -> Iterable[Unit]:
    thousand, pound_foot = Fraction(1000), POUND_FORCE * FOOT
    yield Unit("mm", "length", 1 / thousand, "mm")
    yield Unit("cm", "length", Fraction(1, 100), "cm")
    yield Unit("m", "length", Fraction(1), "m")
    yield Unit("in", "length", INCH, "in", {"de": "Zoll", "en": "inches"})
    yield Unit("ft", "length", FOOT, "ft")
    yield Unit("m/s", "velocity", Fraction(1), "mps")
    yield Unit("ft/s", "velocity", FOOT, "ftps")
    yield Unit("in/s", "velocity", INCH, "inps")
    yield Unit("km/h", "speed of a train", Fraction(5, 18), "kmh")
    yield Unit("mph", "speed of a train", 5280 * FOOT / 3600, "mph")
    yield Unit("m/s²", "acceleration", Fraction(1), "mps2")
    yield Unit("ft/s²", "acceleration", FOOT, "ftps2")
    yield Unit("in/s²", "acceleration", INCH, "inps2")
    yield Unit("N", "force", Fraction(1), "n")
    yield Unit("kN", "force", thousand, "kn")
    yield Unit("MN", "force", thousand**2, "mn")
    yield Unit("lbf", "force", POUND_FORCE, "lbf")
    yield Unit("N m", "torque", Fraction(1), "nm")
    yield Unit("kN m", "torque", thousand, "knm")
    yield Unit("MN m", "torque", thousand**2, "mnm")
    yield Unit("lbf ft", "torque", pound_foot, "lbfft")
    yield Unit("lbf in", "torque", POUND_FORCE * INCH, "lbfin")
    yield Unit("J", "energy", Fraction(1), "j")
    yield Unit("kJ", "energy", thousand, "kj")
    yield Unit("MJ", "energy", thousand**2, "mj")
    yield Unit("ft lbf", "energy", pound_foot, "ftlbf")
    yield Unit("W", "power", Fraction(1), "w")
    yield Unit("kW", "power", thousand, "kw")
    yield Unit("MW", "power", thousand**2, "mw")
    yield Unit("hp", "power", 550 * pound_foot, "hp")
    yield Unit("kPa", "pressure", thousand, "kpa")
    yield Unit("bar", "pressure", 100 * thousand, "bar")
    yield Unit("MPa", "pressure", thousand**2, "mpa")
    yield Unit("psi", "pressure", POUND_FORCE / INCH**2, "psi")
    yield Unit("kg", "mass", Fraction(1), "kg")
    yield Unit("t", "mass", thousand, "t")
    yield Unit("lb", "mass", POUND, "lb")
    yield Unit("kg m", "unbalance", Fraction(1), "kgm")
    yield Unit("lb ft", "unbalance", POUND * FOOT, "lbft")
    yield Unit("lb in", "unbalance", POUND * INCH, "lbin")
    yield Unit("kg m²", "moment of inertia", Fraction(1), "kgm2")
    yield Unit("lb ft²", "moment of inertia", POUND * FOOT**2, "lbft2")
    yield Unit("cm²", "area", Fraction(1, 10_000), "cm2")
    yield Unit("in²", "area", INCH**2, "in2")
    yield Unit("kg/m³", "density", Fraction(1), "kgm3")
    yield Unit("lb/in³", "density", POUND / INCH**3, "lbin3")
    yield Unit("m³/min", "flow", Fraction(1, 60), "m3min")
    yield Unit("ft³/min", "flow", FOOT**3 / 60, "ft3min")
    yield Unit("m³/kg", "specific volume", Fraction(1), "m3kg")
    yield Unit("ft³/lb", "specific volume", FOOT**3 / POUND, "ft3lb")
    yield Unit("kg/h", "mass flow", Fraction(1, 3600), "kgh")
    yield Unit("kg/min", "mass flow", Fraction(1, 60), "kgmin")
    yield Unit("lb/h", "mass flow", POUND / 3600, "lbh")
    yield Unit("kg/kWh", "mass per work", 1 / (3600 * thousand), "kwh")
    yield Unit("lb/(hp h)", "mass per work", POUND / (3600 * 550 * pound_foot), "hph")
    yield Unit("kJ/kg", "work per mass", thousand, "kjkg")
    yield Unit("ft lbf/lb", "work per mass", pound_foot / POUND, "ftlbflb")
    yield Unit("l", "volume", 1 / thousand, "l")
    yield Unit("in³", "volume", INCH**3, "in3")


UNITS: Mapping[str, Unit] = {one.symbol: one for one in _units()}
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
        for name, power in _factors(text.translate(_SUPERSCRIPTS).strip()):
            (above if power > 0 else below).extend([name] * abs(power))
    except ValueError:
        return None
    if not 0 < len(above) + len(below) <= _MOST:
        return None
    found = "*".join(above) + "".join(f"/{name}" for name in below)
    return _WHOLE.get(found, found)


def _factors(text: str) -> Iterator[tuple[str, int]]:
    """Yield the names and their powers; raise ValueError for anything else."""
    rest, sign = re.sub(r"^1\s*(?=/)", "", text), 1
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
