"""The columns of power: each a product of what is found of a duty, in SI units."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import cache, partial

from kurbel.engine.power.duty import (
    AIRY,
    ASKED,
    BORE,
    BRAKED,
    COLD,
    COMPOUND,
    CONSUMED,
    COOLED,
    EFFICIENCY,
    EFFICIENT,
    FACTOR,
    FACTORED,
    FREE,
    FUELLED,
    GIVES,
    HALF,
    HEAT,
    POWER,
    PRESSURE,
    SPEED,
    STAGED,
    STEAMED,
    STROKE,
    THERMAL,
    UNITLESS,
    UNITS,
    WARM,
    WEIGHED,
    Found,
)
from kurbel.exact.real import Term, number
from kurbel.page.quantity import Formula, Quantity, entry, with_symbol


@cache
def registry() -> Mapping[str, Quantity]:
    """Return every quantity by its key; a kernel takes what is found and returns a product in SI units."""
    return {one.key: one._replace(spanners=(one.name,)) for one in _entries()}


def _entries() -> Iterator[Quantity]:
    theory = "theoretischer mittlerer Druck|Theoretical mean pressure"
    yield _entry("expansion", "Expansionsverhältnis|Expansion ratio", "$ε$", "", 1,
                 lambda found: number(1) / found.sought(), "eps")  # fmt: skip
    yield _entry("cut_off", "Füllung|Cut-off", "$1/ε$", "", 1, Found.sought, "eps")
    yield _entry("ratio", "Druckverhältnis|Pressure ratio", "$Π$", "", 1, Found.sought, "pressure_ratio")
    yield _entry("steam_pressure", "Dampfdruck|Steam pressure", "$p$", "bar", UNITS[PRESSURE],
                 partial(_variable, PRESSURE), "pressure")  # fmt: skip
    yield _entry("back", "Gegendruck|Back pressure", "$p_b$", "bar", UNITS[PRESSURE],
                 lambda found: found.sought() * found.of(PRESSURE), "back")  # fmt: skip
    yield _entry("back_share", "Gegendruck, bezogen|Relative back pressure", "$p_b/p$", "", 1, Found.sought,
                 "back")  # fmt: skip
    yield _entry("clearance", "schädlicher Raum|Clearance", "$κ$", "", 1, Found.sought, "clearance")
    yield _entry("relative_pressure", "bezogener mittlerer Druck|Relative mean pressure", "$p_m/p$", "",
                 1, lambda found: found.mean(), UNITLESS)  # fmt: skip
    yield _entry("theoretical_pressure", theory, "$p_m$", "bar", UNITS[PRESSURE],
                 lambda found: found.of(PRESSURE) * found.mean(), FACTORED)  # fmt: skip
    yield _entry("diagram_factor", "Völligkeitsgrad des Diagramms|Diagram factor", "$φ_d$", "", 1,
                 partial(_variable, FACTOR), ASKED)  # fmt: skip
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
    yield _entry("efficiency", "mechanischer Wirkungsgrad|Mechanical efficiency", "$η$", "", 1,
                 partial(_variable, EFFICIENCY), BRAKED)  # fmt: skip
    kwh = Fraction(1, 3600 * 1000)
    yield _entry("consumption", "Verbrauch|Consumption", "$B$", "kg/h", Fraction(1, 3600),
                 partial(_variable, CONSUMED), FUELLED)  # fmt: skip
    yield _entry("consumption_per_kwh", "Verbrauch je kWh, indiziert|Consumption per kWh, indicated",
                 "$B/N_i$", "kg/kWh", kwh, lambda found: found.of(CONSUMED) / found.of(POWER),
                 FUELLED)  # fmt: skip
    yield _entry("consumption_per_brake_kwh",
                 "Verbrauch je kWh an der Welle|Consumption per kWh at the shaft", "$B/N_e$", "kg/kWh", kwh,
                 lambda found: found.of(CONSUMED) / found.of(POWER) / found.brake(),
                 f"{FUELLED} {EFFICIENT}")  # fmt: skip
    yield _entry("heating_value", "Heizwert|Heating value", "$H$", "kJ/kg", 1000, partial(_variable, HEAT),
                 FUELLED)  # fmt: skip
    yield _entry("indicated_thermal", "thermischer Wirkungsgrad, indiziert|Indicated thermal efficiency",
                 "$η_i$", "", 1, lambda found: found.of(THERMAL) / found.of_work(), FUELLED)  # fmt: skip
    yield _entry("brake_thermal", "thermischer Wirkungsgrad an der Welle|Brake thermal efficiency", "$η_e$",
                 "", 1, lambda found: found.of(THERMAL) * found.brake() / found.of_work(),
                 f"{FUELLED} {EFFICIENT}")  # fmt: skip
    yield _entry("steam", "Dampfverbrauch|Steam taken", "$D$", "kg/h", Fraction(1, 3600), Found.steam,
                 STEAMED)  # fmt: skip
    yield _entry("steam_per_kwh", "Dampf je kWh, indiziert|Steam per kWh, indicated", "$D/N_i$", "kg/kWh",
                 kwh, Found.steam_of_work, STEAMED)  # fmt: skip
    yield _entry("steam_per_brake_kwh", "Dampf je kWh an der Welle|Steam per kWh at the shaft", "$D/N_e$",
                 "kg/kWh", kwh, lambda found: found.steam_of_work() / found.brake(),
                 f"{STEAMED} {EFFICIENT}")  # fmt: skip
    yield _entry("swept_volume", "Hubraum eines Zylinders|Swept volume of a cylinder", "$V_h$", "l",
                 Fraction(1, 1000), Found.swept)  # fmt: skip
    yield from _air_entries()
    yield from _compound_entries()


def _air_entries() -> Iterator[Quantity]:
    """Yield what is of a compressor, or of a pump."""
    yield _entry("air_mass", "geförderte Masse|Mass delivered", '$"ṁ"$', "kg/min", Fraction(1, 60),
                 lambda found: found.delivery() * found.duty.mass_of_air(), f"{WARM} {WEIGHED}")  # fmt: skip
    yield _entry("work_per_mass", "Arbeit je kg|Work per kg", "$w$", "kJ/kg", 1000, Found.work_per_mass,
                 f"{WARM} {WEIGHED}")  # fmt: skip
    yield _entry("delivery", "Fördermenge|Delivery", "$V$", "m³/min", Fraction(1, 60),
                 Found.delivery, GIVES)  # fmt: skip
    yield _entry("free_delivery", "Fördermenge, freie Luft|Delivery of free air", "$V_f$", "m³/min",
                 Fraction(1, 60), lambda found: found.delivery() * found.duty.freed(), FREE)  # fmt: skip
    yield _entry("volumetric_efficiency", "Liefergrad|Volumetric efficiency", "$η_v$", "", 1,
                 lambda found: found.of_load("volumetric_efficiency"), AIRY)  # fmt: skip
    yield _entry("free_efficiency", "Liefergrad, freie Luft|Volumetric efficiency by free air", "$η_f$", "",
                 1, lambda found: Term(found.acting.delivered) * found.duty.freed(), FREE)  # fmt: skip
    yield _entry("isothermal_power", "isothermische Leistung|Isothermal power", '$N_"is"$', "kW",
                 UNITS[POWER], lambda found: found.ideal("isothermal"), AIRY)  # fmt: skip
    yield _entry("isothermal_efficiency", "isothermischer Wirkungsgrad|Isothermal efficiency", '$N_"is"/N_i$',
                 "", 1, lambda found: found.of_load("isothermal") / found.mean(), AIRY)  # fmt: skip
    yield _entry("adiabatic_efficiency", "adiabatischer Wirkungsgrad|Adiabatic efficiency", '$N_"ad"/N_i$',
                 "", 1, lambda found: found.of_load("adiabatic") / found.mean(), AIRY)  # fmt: skip
    yield _entry("intermediate_pressure", "Zwischendruck|Intermediate pressure", "$p_z$", "bar",
                 UNITS[PRESSURE], lambda found: found.of(PRESSURE) * found.of_load("stage_ratio"),
                 STAGED)  # fmt: skip
    yield _entry("second_bore", "Bohrung der zweiten Stufe|Bore of the second stage", "$d_2$", "mm",
                 UNITS[BORE], lambda found: found.of(BORE) * found.of_load("later_area") ** HALF,
                 STAGED)  # fmt: skip
    yield _entry("delivered_volume", "Volumen hinter der Verdichtung, eines Hubes"
                 "|Volume of a stroke behind compression", "$V_2$", "l", Fraction(1, 1000),
                 lambda found: found.swept() * found.of_load("delivered_hot"), AIRY)  # fmt: skip
    yield _entry("compression_heat", "Wärme der Verdichtung, einer Stufe|Heat of compression, of a stage",
                 "$Q_v$", "kW", UNITS[POWER], lambda found: found.ideal("compression_heat"),
                 COLD)  # fmt: skip
    yield _entry("cooler_heat", "Wärme eines Zwischenkühlers|Heat of an intercooler", "$Q_z$", "kW",
                 UNITS[POWER], lambda found: found.ideal("cooler_heat"), f"{STAGED} {COLD}")  # fmt: skip
    for key, name, symbol, needs in (
        ("against_one_stage", "Arbeit gegen eine Stufe|Work against one stage", "$N_i/N_1$", STAGED),
        ("against_perfect", "Arbeit gegen vollkommene Zwischenkühlung|Work against perfect intercooling",
         '$N_i/N_"vk"$', f"{STAGED} {COOLED}"),
        ("perfect_against_one", "vollkommene Zwischenkühlung gegen eine Stufe"
         "|Perfect intercooling against one stage", '$N_"vk"/N_1$', STAGED),
    ):  # fmt: skip
        yield _entry(key, name, symbol, "", 1, partial(_of_load, key), needs)
    yield _entry("end_temperature", "Temperatur der Verdichtung|Temperature of compression", "$T_2$", "K", 1,
                 lambda found: number(found.duty.suction_temperature or 1) * found.of_load("heated"),
                 WARM)  # fmt: skip


def _compound_entries() -> Iterator[Quantity]:
    """Yield what is of the two cylinders of a compound engine."""
    yield _entry("high_expansion", "Expansion im Hochdruckzylinder|Expansion in the high-pressure cylinder",
                 "$ε_h$", "", 1, Found.expanded, COMPOUND)  # fmt: skip
    yield _entry("low_cut_off", "Füllung des Niederdruckzylinders|Cut-off of the low-pressure cylinder",
                 "$V_h/V_n$", "", 1, Found.filled, COMPOUND)  # fmt: skip
    yield _entry("receiver_pressure", "Druck im Aufnehmer|Receiver pressure", "$p_a$", "bar", UNITS[PRESSURE],
                 lambda found: found.of(PRESSURE) / found.expanded(), COMPOUND)  # fmt: skip
    yield _entry("high_bore", "Bohrung des Hochdruckzylinders|High-pressure bore", "$d_h$", "mm", UNITS[BORE],
                 lambda found: found.of(BORE) * found.filled() ** HALF, COMPOUND)  # fmt: skip
    for key, name, letter, high in (
        ("high", "des Hochdruckzylinders|of the high-pressure cylinder", "h", True),
        ("low", "des Niederdruckzylinders|of the low-pressure cylinder", "n", False),
    ):
        german, english = name.split("|")
        yield _entry(f"{key}_share", f"Arbeitsanteil {german}|Share {english} in the work", f"$A_{letter}$",
                     "", 1, partial(Found.shared, high=high), COMPOUND)  # fmt: skip
        yield _entry(f"{key}_mean_pressure", f"mittlerer Druck {german}|Mean pressure {english}",
                     f'$p_"i{letter}"$', "bar", UNITS[PRESSURE], partial(Found.pressed, high=high),
                     COMPOUND)  # fmt: skip
        yield _entry(f"{key}_power", f"Leistung {german}|Power {english}", f"$N_{letter}$", "kW",
                     UNITS[POWER], partial(Found.worked_in, high=high), COMPOUND)  # fmt: skip


def _variable(name: str, found: Found) -> Term:
    return found.duty.whole_bore(found.of(name)) if name == BORE else found.of(name)


def _of_load(name: str, found: Found) -> Term:
    return found.of_load(name)


def _entry(
    key: str, name: str, symbol: str, unit: str, size: Fraction | int, kernel: Callable[[Found], Term],
    needs: str = "",
) -> Quantity:  # fmt: skip
    formula = Formula(lambda found: kernel(found) / number(size))
    own = entry(key, name, symbol, unit, None, {"exact": formula}, needs=needs)
    return own._replace(heading=with_symbol(own))
