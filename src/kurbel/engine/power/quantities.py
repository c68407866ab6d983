"""What pages of the power can show: each a product of what is given and of what acts on the piston."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import cache, partial
from typing import NamedTuple

from kurbel.engine.power.duty import BORE, POWER, PRESSURE, SPEED, STROKE, UNITS, Duty
from kurbel.engine.power.duty import FACTOR as DIAGRAM_FACTOR
from kurbel.engine.power.relation import Term, number
from kurbel.engine.power.source import Acting, GivenPressure
from kurbel.page.quantity import Formula, Quantity, entry, words

# What a quantity needs beside the variables in it.
STEAMED, GIVES, EFFICIENT, FACTOR, UNITLESS = "steam", "delivery", "efficiency", "factor", "share"
ASKED = "asked"


class Found(NamedTuple):
    """What is found of a source: the variables, in terms of what is given."""

    duty: Duty
    source: Acting | GivenPressure
    variables: Mapping[str, Term]

    @property
    def acting(self) -> Acting:
        assert isinstance(self.source, Acting)
        return self.source

    def mean(self) -> Term:
        """Return the mean pressure in units of the pressure that Q is of."""
        return Term(self.source.mean)

    def rate(self) -> Term:
        """Return the working strokes of all cylinders in a second."""
        return self.of(SPEED) * number(self.source.strokes * self.duty.cylinders)

    def swept(self) -> Term:
        """Return the volume of a stroke in m³, the mean of both ends."""
        return number(self.duty.open_area / 4, pi=1) * self.of(BORE) ** Fraction(2) * self.of(STROKE)

    def pressure(self) -> Term:
        """Return the mean pressure in Pa."""
        return self.of(PRESSURE) * self.of(DIAGRAM_FACTOR) * self.mean()

    def brake(self) -> Term:
        """Return what times the indicated power is that at the shaft."""
        return self.duty.to_brake(self.source.driven)

    def steam(self) -> Term:
        """Return the steam of a second in kg."""
        volume = self.duty.specific_volume
        assert volume is not None
        return Term(self.acting.steam_taken) * self.swept() * self.rate() / number(volume)

    def steam_of_work(self) -> Term:
        """Return the steam of a joule of indicated work in kg."""
        return self.steam() / self.of(POWER)

    def delivery(self) -> Term:
        """Return what is delivered in a second in m³, in the state of suction."""
        return Term(self.acting.delivered) * self.swept() * self.rate()

    def of(self, name: str) -> Term:
        """Return a variable in its SI unit, the speed in turns a second."""
        return self.variables[name]


@cache
def registry() -> Mapping[str, Quantity]:
    """Return every quantity by its key; a kernel takes what is found and returns a product in SI units."""
    return {one.key: one._replace(spanners=(one.name,)) for one in _entries()}


def _entries() -> Iterator[Quantity]:
    theory = "theoretischer mittlerer Druck|Theoretical mean pressure"
    yield _entry("relative_pressure", "bezogener mittlerer Druck|Relative mean pressure", "$p_m/p$", "",
                 1, lambda found: found.mean(), UNITLESS)  # fmt: skip
    yield _entry("theoretical_pressure", theory, "$p_m$", "bar", UNITS[PRESSURE],
                 lambda found: found.of(PRESSURE) * found.mean(), FACTOR)  # fmt: skip
    yield _entry("diagram_factor", "Völligkeitsgrad des Diagramms|Diagram factor", "$φ_d$", "", 1,
                 partial(_variable, DIAGRAM_FACTOR), ASKED)  # fmt: skip
    yield _entry("mean_pressure", "mittlerer indizierter Druck|Mean effective pressure", "$p_i$", "bar",
                 UNITS[PRESSURE], Found.pressure)  # fmt: skip
    for key, name, symbol, unit in (
        (PRESSURE, "Druck|Pressure", "$p$", "bar"),
        (BORE, "Bohrung|Bore", "$d$", "mm"),
        (STROKE, "Hub|Stroke", "$S$", "mm"),
        (SPEED, "Drehzahl|Speed", "$n$", '$"min"^(-1)$'),
    ):
        yield _entry(key, name, symbol, unit, UNITS[key], partial(_variable, key))
    yield _entry("piston_speed", "mittlere Kolbengeschwindigkeit|Mean piston speed", "$c_m$", "m/s", 1,
                 lambda found: number(2) * found.of(STROKE) * found.of(SPEED))  # fmt: skip
    yield _entry("stroke_work", "Arbeit eines wirksamen Hubes|Work of a working stroke", "$A_h$", "J", 1,
                 lambda found: found.pressure() * found.swept())  # fmt: skip
    yield _entry("indicated_power", "indizierte Leistung|Indicated power", "$N_i$", "kW", UNITS[POWER],
                 lambda found: found.of(POWER))  # fmt: skip
    yield _entry("brake_power", "Leistung an der Welle|Power at the shaft", "$N_e$", "kW", UNITS[POWER],
                 lambda found: found.of(POWER) * found.brake(), EFFICIENT)  # fmt: skip
    yield _entry("brake_pressure", "mittlerer effektiver Druck|Brake mean effective pressure", "$p_e$", "bar",
                 UNITS[PRESSURE], lambda found: found.pressure() * found.brake(), EFFICIENT)  # fmt: skip
    yield _entry("mean_torque", "mittleres Drehmoment an der Welle|Mean torque at the shaft", "$M_e$", "N m",
                 1, lambda found: found.of(POWER) * found.brake() / found.of(SPEED) / number(2, pi=1),
                 EFFICIENT)  # fmt: skip
    yield _entry("steam", "Dampfverbrauch|Steam taken", "$D$", "kg/h", Fraction(1, 3600), Found.steam,
                 STEAMED)  # fmt: skip
    kwh = Fraction(1, 3600 * 1000)
    yield _entry("steam_per_kwh", "Dampf je kWh, indiziert|Steam per kWh, indicated", "$D/N_i$", "kg/kWh",
                 kwh, Found.steam_of_work, STEAMED)  # fmt: skip
    yield _entry("steam_per_brake_kwh", "Dampf je kWh an der Welle|Steam per kWh at the shaft", "$D/N_e$",
                 "kg/kWh", kwh, lambda found: found.steam_of_work() / found.brake(),
                 f"{STEAMED} {EFFICIENT}")  # fmt: skip
    yield _entry("delivery", "Fördermenge|Delivery", "$V$", "m³/min", Fraction(1, 60),
                 Found.delivery, GIVES)  # fmt: skip


def _variable(name: str, found: Found) -> Term:
    return found.of(name)


def _entry(
    key: str, name: str, symbol: str, unit: str, size: Fraction | int, kernel: Callable[[Found], Term],
    needs: str = "",
) -> Quantity:  # fmt: skip
    formula = Formula(lambda found: kernel(found) / number(size))
    own = entry(key, name, symbol, unit, None, {"exact": formula}, needs=needs)
    named = {lang: f"{said} {symbol}".rstrip() for lang, said in own.name.items()}
    return own._replace(heading=words("|".join(named[lang] for lang in ("de", "en"))))
