"""The columns of power: each a product of what is found of a duty, in SI units."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import cache, partial
from typing import Any

from kurbel.engine.loads.driven import AIR
from kurbel.engine.power.duty import (
    BORE,
    CONSUMED,
    EFFICIENCY,
    FACTOR,
    HALF,
    HEAT,
    POWER,
    PRESSURE,
    SPEED,
    STROKE,
    THERMAL,
    UNITS,
    Duty,
    Results,
)
from kurbel.exact.real import Term, number
from kurbel.page.quantity import Formula, Need, Quantity, entry, with_symbol


def _of_air(holds: Callable[[Any, Duty], object], words: str) -> Need:
    """Return what only compressors have, told of one and of what else is given."""
    return Need(lambda asked: asked.compressor and holds(asked.compressor, asked.duty), words=words)


def _of_duty(holds: Callable[[Duty], object], words: str) -> Need:
    return Need(lambda asked: holds(asked.duty), words=words)


def _sought(name: str) -> Need:
    return _of_duty(lambda duty: duty.unknown == name, f"--unknown {name}")


class Needs:
    """What a quantity needs of the power that is asked for, beside the variables in it."""

    ACTING = Need(lambda asked: asked.acting, words="what acts on the piston")
    STEAM = Need(lambda asked: asked.acting and asked.acting.steamed, words="steam with --eps")
    DELIVERY = Need(lambda asked: hasattr(asked.machine, "delivered"), words="a compressor or a pump")
    AIR = _of_air(lambda load, duty: True, "a compressor, --pressure-ratio")
    STAGES = _of_air(lambda load, duty: load.stages > 1, "--stages 2")
    COLD = _of_air(
        lambda load, duty: 1 < load.exponent < AIR and load.expansion_exponent is None,
        "a compressor with --exponent above 1 and below 1.4, of compression and expansion",
    )
    COOLED = _of_air(
        lambda load, duty: load.cooled != 1 or load.between is not None,
        "--intercooling or --intermediate-pressure",
    )
    WARM = _of_air(
        lambda load, duty: duty.suction_temperature is not None, "a compressor with --suction-temperature"
    )
    FREE = _of_air(lambda load, duty: duty.free_air is not None, "a compressor with --free-air")
    EFFICIENCY = _of_duty(lambda duty: duty.shafted, "the mechanical efficiency, --efficiency")
    BRAKED = _of_duty(lambda duty: duty.braked and duty.efficiency is None, "--brake-power or --brake-torque")
    FUEL = _of_duty(lambda duty: duty.burnt, "--consumption, or --heating-value with --thermal-efficiency")
    SUCTION = _of_duty(lambda duty: duty.pressure is not None, "--suction-pressure")
    COMPOUND = _of_duty(lambda duty: duty.compound is not None, "--compound")
    FACTOR = _of_duty(lambda duty: duty.diagram_factor != 1 or duty.factor_asked, "--diagram-factor")
    ASKED = _of_duty(lambda duty: duty.factor_asked, "--unknown diagram_factor")


@cache
def registry() -> Mapping[str, Quantity]:
    """Return every quantity by its key; a kernel takes what is found and returns a product in SI units."""
    return {one.key: one._replace(spanners=(one.name,)) for one in _entries()}


def _entries() -> Iterator[Quantity]:
    theory = "theoretischer mittlerer Druck|Theoretical mean pressure"
    yield _entry("expansion", "Expansionsverhältnis|Expansion ratio", "$ε$", "", 1,
                 lambda found: number(1) / found.sought(), _sought("eps"))  # fmt: skip
    yield _entry("cut_off", "Füllung|Cut-off", "$1/ε$", "", 1, Results.sought, _sought("eps"))
    yield _entry(
        "ratio", "Druckverhältnis|Pressure ratio", "$Π$", "", 1, Results.sought, _sought("pressure_ratio")
    )
    yield _entry("steam_pressure", "Dampfdruck|Steam pressure", "$p$", "bar", UNITS[PRESSURE],
                 partial(_variable, PRESSURE), _sought("pressure"))  # fmt: skip
    yield _entry("back", "Gegendruck|Back pressure", "$p_b$", "bar", UNITS[PRESSURE],
                 lambda found: found.sought() * found.of(PRESSURE), _sought("back"))  # fmt: skip
    yield _entry("back_share", "Gegendruck, bezogen|Relative back pressure", "$p_b/p$", "", 1, Results.sought,
                 _sought("back"))  # fmt: skip
    yield _entry(
        "clearance", "schädlicher Raum|Clearance", "$κ$", "", 1, Results.sought, _sought("clearance")
    )
    yield _entry("relative_pressure", "bezogener mittlerer Druck|Relative mean pressure", "$p_m/p$", "",
                 1, lambda found: found.mean(), Needs.ACTING)  # fmt: skip
    yield _entry("theoretical_pressure", theory, "$p_m$", "bar", UNITS[PRESSURE],
                 lambda found: found.of(PRESSURE) * found.mean(), Needs.FACTOR)  # fmt: skip
    yield _entry("diagram_factor", "Völligkeitsgrad des Diagramms|Diagram factor", "$φ_d$", "", 1,
                 partial(_variable, FACTOR), Needs.ASKED)  # fmt: skip
    yield _entry("mean_pressure", "mittlerer indizierter Druck|Mean effective pressure", "$p_i$", "bar",
                 UNITS[PRESSURE], Results.pressure)  # fmt: skip
    for key, name, symbol, unit in (
        (PRESSURE, "Druck|Pressure", "$p$", "bar"),
        (BORE, "Bohrung|Bore", "$d$", "mm"),
        (STROKE, "Hub|Stroke", "$S$", "mm"),
        (SPEED, "Drehzahl|Speed", "$n$", '$"min"^(-1)$'),
    ):
        yield _entry(key, name, symbol, unit, UNITS[key], partial(_variable, key))
    yield _entry("piston_speed", "mittlere Kolbengeschwindigkeit|Mean piston speed", "$c_m$", "m/s", 1,
                 Results.piston_speed)  # fmt: skip
    yield _entry("stroke_work", "Arbeit eines wirksamen Hubes|Work of a working stroke", "$A_h$", "J", 1,
                 lambda found: found.pressure() * found.swept())  # fmt: skip
    yield _entry("indicated_power", "indizierte Leistung|Indicated power", "$N_i$", "kW", UNITS[POWER],
                 lambda found: found.of(POWER))  # fmt: skip
    yield _entry("brake_power", "Leistung an der Welle|Power at the shaft", "$N_e$", "kW", UNITS[POWER],
                 lambda found: found.of(POWER) * found.brake(), Needs.EFFICIENCY)  # fmt: skip
    yield _entry("brake_pressure", "mittlerer effektiver Druck|Brake mean effective pressure", "$p_e$", "bar",
                 UNITS[PRESSURE], lambda found: found.pressure() * found.brake(),
                 Needs.EFFICIENCY)  # fmt: skip
    yield _entry("mean_torque", "mittleres Drehmoment an der Welle|Mean torque at the shaft", "$M_e$", "N m",
                 1, Results.torque, Needs.EFFICIENCY)  # fmt: skip
    yield _entry("efficiency", "mechanischer Wirkungsgrad|Mechanical efficiency", "$η$", "", 1,
                 partial(_variable, EFFICIENCY), Needs.BRAKED)  # fmt: skip
    kwh = Fraction(1, 3600 * 1000)
    yield _entry("consumption", "Verbrauch|Consumption", "$B$", "kg/h", Fraction(1, 3600),
                 partial(_variable, CONSUMED), Needs.FUEL)  # fmt: skip
    yield _entry("consumption_per_kwh", "Verbrauch je kWh, indiziert|Consumption per kWh, indicated",
                 "$B/N_i$", "kg/kWh", kwh, lambda found: found.of(CONSUMED) / found.of(POWER),
                 Needs.FUEL)  # fmt: skip
    yield _entry("consumption_per_brake_kwh",
                 "Verbrauch je kWh an der Welle|Consumption per kWh at the shaft", "$B/N_e$", "kg/kWh", kwh,
                 lambda found: found.of(CONSUMED) / found.of(POWER) / found.brake(),
                 Needs.FUEL, Needs.EFFICIENCY)  # fmt: skip
    yield _entry("heating_value", "Heizwert|Heating value", "$H$", "kJ/kg", 1000, partial(_variable, HEAT),
                 Needs.FUEL)  # fmt: skip
    yield _entry("indicated_thermal", "thermischer Wirkungsgrad, indiziert|Indicated thermal efficiency",
                 "$η_i$", "", 1, lambda found: found.of(THERMAL) / found.of_work(), Needs.FUEL)  # fmt: skip
    yield _entry("brake_thermal", "thermischer Wirkungsgrad an der Welle|Brake thermal efficiency", "$η_e$",
                 "", 1, lambda found: found.of(THERMAL) * found.brake() / found.of_work(),
                 Needs.FUEL, Needs.EFFICIENCY)  # fmt: skip
    yield _entry("steam", "Dampfverbrauch|Steam taken", "$D$", "kg/h", Fraction(1, 3600), Results.steam,
                 Needs.STEAM)  # fmt: skip
    yield _entry("steam_per_kwh", "Dampf je kWh, indiziert|Steam per kWh, indicated", "$D/N_i$", "kg/kWh",
                 kwh, Results.steam_of_work, Needs.STEAM)  # fmt: skip
    yield _entry("steam_per_brake_kwh", "Dampf je kWh an der Welle|Steam per kWh at the shaft", "$D/N_e$",
                 "kg/kWh", kwh, lambda found: found.steam_of_work() / found.brake(),
                 Needs.STEAM, Needs.EFFICIENCY)  # fmt: skip
    yield _entry("swept_volume", "Hubraum eines Zylinders|Swept volume of a cylinder", "$V_h$", "l",
                 Fraction(1, 1000), Results.swept)  # fmt: skip
    yield from _air_entries()
    yield from _compound_entries()


def _air_entries() -> Iterator[Quantity]:
    """Yield what is of a compressor, or of a pump."""
    yield _entry("air_mass", "geförderte Masse|Mass delivered", '$"ṁ"$', "kg/min", Fraction(1, 60),
                 lambda found: found.delivery() * found.duty.mass_of_air(), Needs.WARM,
                 Needs.SUCTION)  # fmt: skip
    yield _entry("work_per_mass", "Arbeit je kg|Work per kg", "$w$", "kJ/kg", 1000,
                 lambda found: found.of(POWER) / (found.delivery() * found.duty.mass_of_air()),
                 Needs.WARM, Needs.SUCTION)  # fmt: skip
    yield _entry("delivery", "Fördermenge|Delivery", "$V$", "m³/min", Fraction(1, 60),
                 Results.delivery, Needs.DELIVERY)  # fmt: skip
    yield _entry("free_delivery", "Fördermenge, freie Luft|Delivery of free air", "$V_f$", "m³/min",
                 Fraction(1, 60), lambda found: found.delivery() * found.duty.freed(),
                 Needs.FREE)  # fmt: skip
    yield _entry("volumetric_efficiency", "Liefergrad|Volumetric efficiency", "$η_v$", "", 1,
                 lambda found: found.of_load("volumetric_efficiency"), Needs.AIR)  # fmt: skip
    yield _entry("free_efficiency", "Liefergrad, freie Luft|Volumetric efficiency by free air", "$η_f$", "",
                 1, lambda found: Term(found.acting.delivered) * found.duty.freed(), Needs.FREE)  # fmt: skip
    yield _entry("isothermal_power", "isothermische Leistung|Isothermal power", '$N_"is"$', "kW",
                 UNITS[POWER], lambda found: found.ideal("isothermal"), Needs.AIR)  # fmt: skip
    yield _entry("isothermal_efficiency", "isothermischer Wirkungsgrad|Isothermal efficiency", '$N_"is"/N_i$',
                 "", 1, lambda found: found.in_work("isothermal"), Needs.AIR)  # fmt: skip
    yield _entry("adiabatic_efficiency", "adiabatischer Wirkungsgrad|Adiabatic efficiency", '$N_"ad"/N_i$',
                 "", 1, lambda found: found.in_work("adiabatic"), Needs.AIR)  # fmt: skip
    yield _entry("intermediate_pressure", "Zwischendruck|Intermediate pressure", "$p_z$", "bar",
                 UNITS[PRESSURE], lambda found: found.of(PRESSURE) * found.of_load("stage_ratio"),
                 Needs.STAGES)  # fmt: skip
    yield _entry("second_bore", "Bohrung der zweiten Stufe|Bore of the second stage", "$d_2$", "mm",
                 UNITS[BORE], lambda found: found.of(BORE) * found.of_load("later_area") ** HALF,
                 Needs.STAGES)  # fmt: skip
    for key, name, symbol, value, need in (
        ("second_swept_volume", "Hubraum der zweiten Stufe|Swept volume of the second stage", '$V_"h2"$',
         lambda found: found.swept() * found.of_load("later_area"), Needs.STAGES),
        ("cylinder_volume",
         "Zylinder mit schädlichem Raum|Cylinder with its clearance",
         "$V_z$", lambda found: found.swept() * found.of_load("filled"), Needs.AIR),
        ("second_cylinder_volume",
         "Zylinder der zweiten Stufe mit diesem|Cylinder of the second stage, likewise", '$V_"z2"$',
         lambda found: found.swept() * found.of_load("later_area") * found.of_load("later_filled"),
         Needs.STAGES),
    ):  # fmt: skip
        yield _entry(key, name, symbol, "l", Fraction(1, 1000), value, need)
    yield _entry("delivered_volume", "Volumen hinter der Verdichtung, eines Hubes"
                 "|Volume of a stroke behind compression", "$V_2$", "l", Fraction(1, 1000),
                 lambda found: found.swept() * found.of_load("delivered_hot"), Needs.AIR)  # fmt: skip
    yield _entry("compression_heat", "Wärme der Verdichtung, einer Stufe|Heat of compression, of a stage",
                 "$Q_v$", "kW", UNITS[POWER], lambda found: found.ideal("compression_heat"),
                 Needs.COLD)  # fmt: skip
    yield _entry("cooler_heat", "Wärme eines Zwischenkühlers|Heat of an intercooler", "$Q_z$", "kW",
                 UNITS[POWER], lambda found: found.ideal("cooler_heat"), Needs.STAGES,
                 Needs.COLD)  # fmt: skip
    for key, name, symbol, *needs in (
        ("against_one_stage", "Arbeit gegen eine Stufe|Work against one stage", "$N_i/N_1$", Needs.STAGES),
        ("against_perfect", "Arbeit gegen vollkommene Zwischenkühlung|Work against perfect intercooling",
         '$N_i/N_"vk"$', Needs.STAGES, Needs.COOLED),
        ("perfect_against_one", "vollkommene Zwischenkühlung gegen eine Stufe"
         "|Perfect intercooling against one stage", '$N_"vk"/N_1$', Needs.STAGES),
    ):  # fmt: skip
        yield _entry(key, name, symbol, "", 1, partial(_of_load, key), *needs)
    yield _entry("end_temperature", "Temperatur der Verdichtung|Temperature of compression", "$T_2$", "K", 1,
                 lambda found: number(found.duty.suction_temperature or 1) * found.of_load("heated"),
                 Needs.WARM)  # fmt: skip


def _compound_entries() -> Iterator[Quantity]:
    """Yield what is of the two cylinders of a compound engine."""
    yield _entry("high_expansion", "Expansion im Hochdruckzylinder|Expansion in the high-pressure cylinder",
                 "$ε_h$", "", 1, Results.expanded, Needs.COMPOUND)  # fmt: skip
    yield _entry("low_cut_off", "Füllung des Niederdruckzylinders|Cut-off of the low-pressure cylinder",
                 "$V_h/V_n$", "", 1, Results.filled, Needs.COMPOUND)  # fmt: skip
    yield _entry("receiver_pressure", "Druck im Aufnehmer|Receiver pressure", "$p_a$", "bar", UNITS[PRESSURE],
                 lambda found: found.of(PRESSURE) / found.expanded(), Needs.COMPOUND)  # fmt: skip
    yield _entry("high_bore", "Bohrung des Hochdruckzylinders|High-pressure bore", "$d_h$", "mm", UNITS[BORE],
                 lambda found: found.of(BORE) * found.filled() ** HALF, Needs.COMPOUND)  # fmt: skip
    for key, name, letter, high in (
        ("high", "des Hochdruckzylinders|of the high-pressure cylinder", "h", True),
        ("low", "des Niederdruckzylinders|of the low-pressure cylinder", "n", False),
    ):
        german, english = name.split("|")
        yield _entry(f"{key}_share", f"Arbeitsanteil {german}|Share {english} in the work", f"$A_{letter}$",
                     "", 1, partial(Results.shared, high=high), Needs.COMPOUND)  # fmt: skip
        yield _entry(f"{key}_mean_pressure", f"mittlerer Druck {german}|Mean pressure {english}",
                     f'$p_"i{letter}"$', "bar", UNITS[PRESSURE], partial(Results.pressed, high=high),
                     Needs.COMPOUND)  # fmt: skip
        yield _entry(f"{key}_power", f"Leistung {german}|Power {english}", f"$N_{letter}$", "kW",
                     UNITS[POWER], partial(Results.worked_in, high=high), Needs.COMPOUND)  # fmt: skip


def _variable(name: str, found: Results) -> Term:
    return found.duty.whole_bore(found.of(name)) if name == BORE else found.of(name)


def _of_load(name: str, found: Results) -> Term:
    return found.of_load(name)


def _entry(
    key: str, name: str, symbol: str, unit: str, size: Fraction | int, kernel: Callable[[Results], Term],
    *needs: Need,
) -> Quantity:  # fmt: skip
    formula = Formula(lambda found: kernel(found) / number(size))
    own = entry(key, name, symbol, unit, None, {"exact": formula}, needs=needs)
    return own._replace(heading=with_symbol(own))
