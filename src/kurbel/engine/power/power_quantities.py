"""The columns of power: each a product of what is found of a duty, in SI units."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache, partial
from typing import Any, TypeAlias

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
    SIZES,
    SPEED,
    STROKE,
    THERMAL,
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


Kernel: TypeAlias = Callable[[Results], Term]
# Key, name, symbol, unit, the variable that it is or what makes it of what is found, and what it needs.
_ROWS: tuple[tuple[str, str, str, str, str | Kernel, *tuple[Need, ...]], ...] = (
    ("expansion", "Expansionsverhältnis|Expansion ratio", "$ε$", "", lambda found: number(1) / found.sought(),
     _sought("eps")),
    ("cut_off", "Füllung|Cut-off", "$1/ε$", "", Results.sought, _sought("eps")),
    ("ratio", "Druckverhältnis|Pressure ratio", "$Π$", "", Results.sought, _sought("pressure_ratio")),
    ("steam_pressure", "Dampfdruck|Steam pressure", "$p$", "bar", PRESSURE, _sought("pressure")),
    ("back", "Gegendruck|Back pressure", "$p_b$", "bar", lambda found: found.sought() * found.of(PRESSURE),
     _sought("back")),
    ("back_share", "Gegendruck, bezogen|Relative back pressure", "$p_b/p$", "", Results.sought,
     _sought("back")),
    ("clearance", "schädlicher Raum|Clearance", "$κ$", "", Results.sought, _sought("clearance")),
    ("relative_pressure", "bezogener mittlerer Druck|Relative mean pressure", "$p_m/p$", "",
     lambda found: found.mean(), Needs.ACTING),
    ("theoretical_pressure", "theoretischer mittlerer Druck|Theoretical mean pressure", "$p_m$", "bar",
     lambda found: found.of(PRESSURE) * found.mean(), Needs.FACTOR),
    ("diagram_factor", "Völligkeitsgrad des Diagramms|Diagram factor", "$φ_d$", "", FACTOR, Needs.ASKED),
    ("mean_pressure", "mittlerer indizierter Druck|Mean effective pressure", "$p_i$", "bar",
     Results.pressure),
    (PRESSURE, "Druck|Pressure", "$p$", "bar", PRESSURE),
    (BORE, "Bohrung|Bore", "$d$", "mm", BORE),
    (STROKE, "Hub|Stroke", "$S$", "mm", STROKE),
    (SPEED, "Drehzahl|Speed", "$n$", '$"min"^(-1)$', SPEED),
    ("piston_speed", "mittlere Kolbengeschwindigkeit|Mean piston speed", "$c_m$", "m/s",
     Results.piston_speed),
    ("stroke_work", "Arbeit eines wirksamen Hubes|Work of a working stroke", "$A_h$", "J",
     lambda found: found.pressure() * found.swept()),
    ("indicated_power", "indizierte Leistung|Indicated power", "$N_i$", "kW", lambda found: found.of(POWER)),
    ("brake_power", "Leistung an der Welle|Power at the shaft", "$N_e$", "kW",
     lambda found: found.of(POWER) * found.brake(), Needs.EFFICIENCY),
    ("brake_pressure", "mittlerer effektiver Druck|Brake mean effective pressure", "$p_e$", "bar",
     lambda found: found.pressure() * found.brake(), Needs.EFFICIENCY),
    ("mean_torque", "mittleres Drehmoment an der Welle|Mean torque at the shaft", "$M_e$", "N m",
     Results.torque, Needs.EFFICIENCY),
    ("efficiency", "mechanischer Wirkungsgrad|Mechanical efficiency", "$η$", "", EFFICIENCY, Needs.BRAKED),
    ("consumption", "Verbrauch|Consumption", "$B$", "kg/h", CONSUMED, Needs.FUEL),
    ("consumption_per_kwh", "Verbrauch je kWh, indiziert|Consumption per kWh, indicated", "$B/N_i$", "kg/kWh",
     lambda found: found.of(CONSUMED) / found.of(POWER), Needs.FUEL),
    ("consumption_per_brake_kwh", "Verbrauch je kWh an der Welle|Consumption per kWh at the shaft", "$B/N_e$",
     "kg/kWh", lambda found: found.of(CONSUMED) / found.of(POWER) / found.brake(), Needs.FUEL,
     Needs.EFFICIENCY),
    ("heating_value", "Heizwert|Heating value", "$H$", "kJ/kg", HEAT, Needs.FUEL),
    ("indicated_thermal", "thermischer Wirkungsgrad, indiziert|Indicated thermal efficiency", "$η_i$", "",
     lambda found: found.of(THERMAL) / found.of_work(), Needs.FUEL),
    ("brake_thermal", "thermischer Wirkungsgrad an der Welle|Brake thermal efficiency", "$η_e$", "",
     lambda found: found.of(THERMAL) * found.brake() / found.of_work(), Needs.FUEL, Needs.EFFICIENCY),
    ("steam", "Dampfverbrauch|Steam taken", "$D$", "kg/h", Results.steam, Needs.STEAM),
    ("steam_per_kwh", "Dampf je kWh, indiziert|Steam per kWh, indicated", "$D/N_i$", "kg/kWh",
     Results.steam_of_work, Needs.STEAM),
    ("steam_per_brake_kwh", "Dampf je kWh an der Welle|Steam per kWh at the shaft", "$D/N_e$", "kg/kWh",
     lambda found: found.steam_of_work() / found.brake(), Needs.STEAM, Needs.EFFICIENCY),
    ("swept_volume", "Hubraum eines Zylinders|Swept volume of a cylinder", "$V_h$", "l", Results.swept),
    ("air_mass", "geförderte Masse|Mass delivered", '$"ṁ"$', "kg/min",
     lambda found: found.delivery() * found.duty.mass_of_air(), Needs.WARM, Needs.SUCTION),
    ("work_per_mass", "Arbeit je kg|Work per kg", "$w$", "kJ/kg",
     lambda found: found.of(POWER) / (found.delivery() * found.duty.mass_of_air()), Needs.WARM,
     Needs.SUCTION),
    ("delivery", "Fördermenge|Delivery", "$V$", "m³/min", Results.delivery, Needs.DELIVERY),
    ("free_delivery", "Fördermenge, freie Luft|Delivery of free air", "$V_f$", "m³/min",
     lambda found: found.delivery() * found.duty.freed(), Needs.FREE),
    ("volumetric_efficiency", "Liefergrad|Volumetric efficiency", "$η_v$", "",
     lambda found: found.of_load("volumetric_efficiency"), Needs.AIR),
    ("free_efficiency", "Liefergrad, freie Luft|Volumetric efficiency by free air", "$η_f$", "",
     lambda found: Term(found.acting.delivered) * found.duty.freed(), Needs.FREE),
    ("isothermal_power", "isothermische Leistung|Isothermal power", '$N_"is"$', "kW",
     lambda found: found.ideal("isothermal"), Needs.AIR),
    ("isothermal_efficiency", "isothermischer Wirkungsgrad|Isothermal efficiency", '$N_"is"/N_i$', "",
     lambda found: found.in_work("isothermal"), Needs.AIR),
    ("adiabatic_efficiency", "adiabatischer Wirkungsgrad|Adiabatic efficiency", '$N_"ad"/N_i$', "",
     lambda found: found.in_work("adiabatic"), Needs.AIR),
    ("intermediate_pressure", "Zwischendruck|Intermediate pressure", "$p_z$", "bar",
     lambda found: found.of(PRESSURE) * found.of_load("stage_ratio"), Needs.STAGES),
    ("second_bore", "Bohrung der zweiten Stufe|Bore of the second stage", "$d_2$", "mm",
     lambda found: found.of(BORE) * found.of_load("later_area") ** HALF, Needs.STAGES),
    ("second_swept_volume", "Hubraum der zweiten Stufe|Swept volume of the second stage", '$V_"h2"$', "l",
     lambda found: found.swept() * found.of_load("later_area"), Needs.STAGES),
    ("cylinder_volume", "Zylinder mit schädlichem Raum|Cylinder with its clearance", "$V_z$", "l",
     lambda found: found.swept() * found.of_load("filled"), Needs.AIR),
    ("second_cylinder_volume", "Zylinder der zweiten Stufe mit diesem|Cylinder of the second stage, likewise",
     '$V_"z2"$', "l",
     lambda found: found.swept() * found.of_load("later_area") * found.of_load("later_filled"), Needs.STAGES),
    ("delivered_volume", "Volumen hinter der Verdichtung, eines Hubes|Volume of a stroke behind compression",
     "$V_2$", "l", lambda found: found.swept() * found.of_load("delivered_hot"), Needs.AIR),
    ("compression_heat", "Wärme der Verdichtung, einer Stufe|Heat of compression, of a stage", "$Q_v$", "kW",
     lambda found: found.ideal("compression_heat"), Needs.COLD),
    ("cooler_heat", "Wärme eines Zwischenkühlers|Heat of an intercooler", "$Q_z$", "kW",
     lambda found: found.ideal("cooler_heat"), Needs.STAGES, Needs.COLD),
    ("against_one_stage", "Arbeit gegen eine Stufe|Work against one stage", "$N_i/N_1$", "",
     lambda found: found.of_load("against_one_stage"), Needs.STAGES),
    ("against_perfect", "Arbeit gegen vollkommene Zwischenkühlung|Work against perfect intercooling",
     '$N_i/N_"vk"$', "", lambda found: found.of_load("against_perfect"), Needs.STAGES, Needs.COOLED),
    ("perfect_against_one",
     "vollkommene Zwischenkühlung gegen eine Stufe|Perfect intercooling against one stage", '$N_"vk"/N_1$',
     "", lambda found: found.of_load("perfect_against_one"), Needs.STAGES),
    ("end_temperature", "Temperatur der Verdichtung|Temperature of compression", "$T_2$", "K",
     lambda found: number(found.duty.suction_temperature or 1) * found.of_load("heated"), Needs.WARM),
    ("high_expansion", "Expansion im Hochdruckzylinder|Expansion in the high-pressure cylinder", "$ε_h$", "",
     Results.expanded, Needs.COMPOUND),
    ("low_cut_off", "Füllung des Niederdruckzylinders|Cut-off of the low-pressure cylinder", "$V_h/V_n$", "",
     Results.filled, Needs.COMPOUND),
    ("receiver_pressure", "Druck im Aufnehmer|Receiver pressure", "$p_a$", "bar",
     lambda found: found.of(PRESSURE) / found.expanded(), Needs.COMPOUND),
    ("high_bore", "Bohrung des Hochdruckzylinders|High-pressure bore", "$d_h$", "mm",
     lambda found: found.of(BORE) * found.filled() ** HALF, Needs.COMPOUND),
    ("high_share", "Arbeitsanteil des Hochdruckzylinders|Share of the high-pressure cylinder in the work",
     "$A_h$", "", lambda found: found.shared(True), Needs.COMPOUND),
    ("high_mean_pressure",
     "mittlerer Druck des Hochdruckzylinders|Mean pressure of the high-pressure cylinder", '$p_"ih"$', "bar",
     lambda found: found.pressed(True), Needs.COMPOUND),
    ("high_power", "Leistung des Hochdruckzylinders|Power of the high-pressure cylinder", "$N_h$", "kW",
     lambda found: found.of(POWER) * found.shared(True), Needs.COMPOUND),
    ("low_share", "Arbeitsanteil des Niederdruckzylinders|Share of the low-pressure cylinder in the work",
     "$A_n$", "", lambda found: found.shared(False), Needs.COMPOUND),
    ("low_mean_pressure",
     "mittlerer Druck des Niederdruckzylinders|Mean pressure of the low-pressure cylinder", '$p_"in"$', "bar",
     lambda found: found.pressed(False), Needs.COMPOUND),
    ("low_power", "Leistung des Niederdruckzylinders|Power of the low-pressure cylinder", "$N_n$", "kW",
     lambda found: found.of(POWER) * found.shared(False), Needs.COMPOUND),
)  # fmt: skip


@cache
def registry() -> Mapping[str, Quantity]:
    """Return every quantity by its key; a kernel takes what is found and returns a product in SI units."""
    return {row[0]: _entry(*row) for row in _ROWS}


def _entry(key: str, name: str, symbol: str, unit: str, kernel: str | Kernel, *needs: Need) -> Quantity:
    value = partial(_variable, kernel) if isinstance(kernel, str) else kernel
    formula = Formula(lambda found: value(found) / number(SIZES.get(unit, 1)))
    own = entry(key, name, symbol, unit, None, {"exact": formula}, needs=needs)
    return own._replace(heading=with_symbol(own), spanners=(own.name,))


def _variable(name: str, found: Results) -> Term:
    return found.duty.whole_bore(found.of(name)) if name == BORE else found.of(name)
