"""What a table of an engine can show: each quantity with its symbol, unit and evaluation.

Each is a number of a turn: of a stroke of it, of the whole turn, at a crank angle, or of a flywheel. Its
kernel takes the turn and where in it, and returns a number of the turn's kind or, where it is rational, a
fraction. What it is `of`: a turn, a stroke, "least" or "greatest" (the extremes of the speed, in a stroke or
in the turn), an angle (of all cranks), a crank (the first one, at an angle) or a flywheel.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache, partial
from typing import Any

from kurbel.drive.at import CRANK_FORCES
from kurbel.drive.load import COMPRESSOR
from kurbel.engine import work
from kurbel.engine.cylinder import OUTSTROKE, RETURN_STROKE, WHOLE, AnyTurn, TurnPlace
from kurbel.exact.numerals import Label
from kurbel.kernel.circle import Numeric
from kurbel.motion.evaluation import Method
from kurbel.motion.motion_quantities import FORCES, Force
from kurbel.page.quantity import Formula, Need, Of, Quantity, Texts, Words, entry, words

_IDEAL = "an ideal card, with an expansion ratio"


class Needs:
    """What a quantity needs to be known of an engine that is asked for; {pressure} is how its load has it."""

    STEAM = Need(lambda asked: asked.steamed, words=_IDEAL)
    CURVE = Need(lambda asked: hasattr(asked.acting, "exponent"), words=_IDEAL)
    CLEARANCE = Need(lambda asked: hasattr(asked.acting, "clearance"), words=_IDEAL)
    COMPRESSOR = Need(
        lambda asked: asked.acting is not None and asked.acting.name == COMPRESSOR,
        words="a compressor, with --pressure-ratio",
    )
    HEAT = Need(
        lambda asked: getattr(asked.acting, "adiabatic", False),
        words="the cycle of a gas engine, --compression, with one adiabatic exponent",
    )
    LOAD = Need(lambda asked: asked.load is not None, words="--bore{pressure}")
    STROKE = Need(lambda asked: asked.first.crank.radius is not None, words="--stroke")
    TORQUE = Need(lambda asked: asked.sized, words="--stroke, --bore{pressure}")
    POWER = Need(
        lambda asked: asked.sized and asked.first.crank.speed is not None,
        words="--stroke, --speed, --bore{pressure}",
    )
    FLOW = Need(
        lambda asked: hasattr(asked.acting, "delivered"),
        words="a compressor or a pump, --pressure-ratio or --pump",
    )
    MASSES = Need(
        lambda asked: any(part.crank.moving is not None for part in asked.first.parts),
        words="moving masses, such as --reciprocating 300kg",
    )
    RADIUS = Need(
        lambda asked: asked.flywheels and asked.flywheels[0].radius is not None,
        words="the radius at which the mass is, --radius",
    )
    TURNS = Need(lambda asked: asked.wheel and asked.wheel.speed, words="the mean speed, --speed")
    INERTIA = Need(lambda asked: asked.wheel and asked.wheel.inertia, words="the flywheel by its --inertia")


SPANS: Mapping[int | None, tuple[str, Words]] = {
    OUTSTROKE: ("outstroke", words("Hingang|Outstroke")),
    RETURN_STROKE: ("return", words("Rückgang|Return")),
    WHOLE: ("turn", words("Umdrehung|Whole turn")),
}
ENGINE_METHODS: Mapping[str, Method] = {
    method.key: method
    for method in (
        Method(
            "exact",
            words("genaue Formeln|exact formulas, true extremes of the speed"),
            words("genaue Formeln|exact formulas"),
        ),
        Method(
            "series",
            words("Näherung erster Ordnung|first-order motion of the piston, true extremes"),
            words("Näherung erster Ordnung|first-order formulas"),
        ),
        Method(
            "weisbach",
            words("Weisbachs Gleichungen|first order, angles by the equations of § 150"),
            words(
                "nach Weisbachs Gleichungen für $α_1$ und $α_2$|by Weisbach's equations for $α_1$ and $α_2$"
            ),
        ),
    )
}
# What the extremes of the speed are called, and which of them is the greatest.
EXTREMES = {Of.LEAST: False, Of.GREATEST: True}
# What is of a crank angle, of an order or of a cylinder has no least and no greatest place.
AT_ANGLE = (Of.ANGLE, Of.CRANK, Of.SPEED, Of.ORDER, Of.CYLINDER)
# What is of the speed under a given flywheel.
OF_RUNS = (Of.SPEED, Of.EVENNESS)


# Keys, names and Weisbach's letters.
_STAGES = (
    ("full_pressure_work", "Volldruckarbeit eines Hubes|Work at full pressure in a stroke", "$A_1$"),
    ("expansion_work", "Expansionsarbeit eines Hubes|Work of the expansion in a stroke", "$A_2$"),
    ("back_work", "Gegendruckarbeit eines Hubes|Work of the back pressure in a stroke", "$A_3$"),
)


def value(quantity: Quantity, turn: AnyTurn, where: TurnPlace) -> Numeric:
    """Return the quantity in its unit, on the kind of number of the turn."""
    found: Numeric = quantity.formulas[turn.method].kernel(turn, where)
    return found * quantity.scale(turn) if quantity.scale else found


def applies(quantity: Quantity, where: TurnPlace) -> bool:
    """Whether there is such a number of this span."""
    if quantity.of is Of.STROKE:
        return where.stroke is not WHOLE
    return where.stroke is WHOLE or quantity.of in EXTREMES


@cache
def engine_registry() -> Mapping[str, Quantity]:
    """Return every quantity by its key, in the order in which `kurbel quantities` lists them."""
    entries = (
        *_turn_entries(),
        *_path_entries(),
        *_work_entries(),
        *_flywheel_entries(),
        *_force_entries(),
    )
    return {entry.key: entry for entry in entries}


def row(
    key: str, name: str, symbol: Label, unit: Label, of: Of, decimals: int | None,
    kernel: Callable[..., Numeric], **rest: Any,
) -> Quantity:  # fmt: skip
    formulas = dict.fromkeys(ENGINE_METHODS, Formula(kernel))
    return entry(key, name, symbol, unit, decimals, formulas, spanners=(words(name),), of=of, **rest)


def _extreme(name: str, of: Of, index: str) -> Iterator[Quantity]:
    greatest = EXTREMES[of]
    de, en = name.split("|")
    yield row(
        f"alpha_{index}", f"{de} bei|{en} at", f"$α_{1 + greatest}$", "°", of, 3,
        lambda turn, where: 180 * turn.extreme(greatest, where.stroke).place, minutes=True,
    )  # fmt: skip
    yield row(
        f"v_{index}", name, f'$v_"{index}"/v_1 - 1$', "$(Q r)/(m_1 v_1^2)$", of, 4,
        lambda turn, where: turn.extreme(greatest, where.stroke).energy,
    )  # fmt: skip


def _turn_entries() -> Iterator[Quantity]:
    yield row("delta", "Ungleichförmigkeitsgrad|Degree of irregularity", "$δ$", "$(P r)/(m_1 v_1^2)$",
              Of.TURN, 3, lambda turn, where: turn.irregularity())  # fmt: skip
    yield row("mean_force", "mittlere Umfangskraft|Mean tangential force", "$P$", "$Q$", Of.TURN, 5,
              lambda turn, where: turn.mean_force())  # fmt: skip
    yield row("back", "Gegendruck|Back pressure", "$R_b$", "$Q$", Of.TURN, 4,
              lambda turn, where: turn.back(), needs=(Needs.STEAM,))  # fmt: skip
    yield row("exponent", "Exponent der Expansion|Exponent of the expansion", "$n$", "", Of.TURN, None,
              lambda turn, where: turn.part.steam.exponent, needs=(Needs.CURVE,))  # fmt: skip
    yield row("clearance", "schädlicher Raum|Clearance", "$κ$", "", Of.TURN, None,
              lambda turn, where: turn.part.steam.clearance, needs=(Needs.CLEARANCE,))  # fmt: skip
    yield row("alpha_cutoff", "Absperrung bei|Cut-off at", "$α_ε$", "°", Of.STROKE, 3,
              lambda turn, where: 180 * turn.cut_off(where.stroke), minutes=True, needs=(Needs.STEAM,),
              )  # fmt: skip
    yield from _extreme("kleinste Geschwindigkeit|Least speed", Of.LEAST, "min")
    yield from _extreme("größte Geschwindigkeit|Greatest speed", Of.GREATEST, "max")
    yield row("tangential", "Tangentialkraft|Tangential force", "$T$", "$Q$", Of.ANGLE, 4,
              lambda turn, where: turn.tangential_force(where.half_turns))  # fmt: skip
    yield row("tangential_excess", "Überschuss über die mittlere|Excess over the mean", "$T - P$", "$Q$",
              Of.ANGLE, 4,
              lambda turn, where: turn.tangential_force(where.half_turns) - turn.mean_force(),
              )  # fmt: skip
    yield row("energy", "Überschussarbeit|Excess energy", "$W$", "$Q r$", Of.ANGLE, 4,
              lambda turn, where: turn.energy_at(where.half_turns),
              direction=words("$W$ Arbeit des Überschusses seit dem inneren Totpunkt der ersten Kurbel"
                              "|$W$ work of the excess since the inner dead centre of the first crank"),
              )  # fmt: skip


def _path_entries() -> Iterator[Quantity]:
    """The way of the first crank pin on its circle, developed, and the tangential force over the area."""
    path, along = "Weg des Kurbelzapfens|Path of the crank pin", lambda turn, where: turn.of(where.half_turns)
    for key, unit, decimals, scale, needs in (
        ("pin_path", "$r$", 4, lambda turn: turn.pi, ()),
        ("pin_path_mm", "mm", 2, lambda turn: turn.of(1000 * turn.engine.crank.radius) * turn.pi,
         (Needs.STROKE,)),
    ):  # fmt: skip
        yield row(key, path, "$s$", unit, Of.ANGLE, decimals, along, scale=scale, needs=needs)
    yield row("tangential_kpa", "Tangentialdruck|Tangential pressure", "$T/A$", "kPa", Of.ANGLE, 1,
              lambda turn, where: turn.tangential_force(where.half_turns), needs=(Needs.LOAD,),
              scale=work.kilopascals)  # fmt: skip


def _work_entries() -> Iterator[Quantity]:
    yield row("work", "Arbeit einer Umdrehung|Work of a turn", "$A$", "$Q r$", Of.TURN, 4, work.work)
    for key, name, letter in _STAGES:
        yield row(
            key, name, letter, "$Q r$", Of.TURN, None, partial(work.stage_work, key), needs=(Needs.STEAM,)
        )
    per_area = "$Q$ je Kolbenfläche|$Q$ per piston area"
    heading = "|".join(f"$p_m$ in {unit}" for unit in per_area.split("|"))
    mean = row("mean_pressure", "mittlerer Druck|Mean pressure", "$p_m$", per_area, Of.TURN, 4,
               work.mean_pressure, heading=heading)  # fmt: skip
    yield mean
    yield mean._replace(
        key="mean_pressure_kpa", unit=words("kPa"), decimals=1, heading=words("$p_m$ in kPa"),
        scale=work.kilopascals, needs=(Needs.LOAD,),
    )  # fmt: skip
    yield row("indicated_power", "indizierte Leistung|Indicated power", "$N_i$", "kW", Of.TURN, None,
              work.power, scale=work.kilowatts, needs=(Needs.POWER,))  # fmt: skip
    yield row("volumetric_efficiency", "volumetrischer Wirkungsgrad|Volumetric efficiency", "$η_v$", "",
              Of.TURN, 4, partial(work.of_load, "volumetric_efficiency"),
              needs=(Needs.COMPRESSOR,))  # fmt: skip
    yield row("delivered", "Fördervolumen|Delivered volume", "$V/V_h$", "", Of.TURN, 4,
              partial(work.of_load, "delivered"), needs=(Needs.COMPRESSOR,))  # fmt: skip
    yield row("delivery", "Fördermenge|Delivery", "$V$", "m³/min", Of.TURN, None, work.flow,
              needs=(Needs.FLOW, Needs.POWER))  # fmt: skip
    yield row("efficiency", "idealer Wirkungsgrad|Ideal efficiency", "$η$", "", Of.TURN, 4,
              partial(work.of_load, "efficiency"), needs=(Needs.HEAT,))  # fmt: skip


def _flywheel_entries() -> Iterator[Quantity]:
    for key, name, symbol, unit, decimals, kernel, *needs in _FLYWHEEL:
        yield row(key, name, symbol, unit, Of.FLYWHEEL, decimals, kernel, needs=tuple(needs))


_SWING = "Arbeitsüberschuss|Energy swing"


_FLYWHEEL: tuple[tuple[str, str, str, str, int | None, Callable[..., Numeric], *tuple[Need, ...]], ...] = (
    ("power", "Leistung|Power", "$N$", "W", None, work.power_of),
    ("speed", "Drehzahl|Speed", "$n$", '$"min"^(-1)$', None, work.turns_a_minute),
    ("omega", "Winkelgeschwindigkeit|Angular velocity", "$ω$", "rad/s", None, work.speed),
    ("mean_torque", "mittleres Drehmoment|Mean torque", "$P r$", "N m", None, work.mean_torque),
    ("swing_share", _SWING, "$(ΔW)/(P r)$", "", 4, lambda turn, where: turn.irregularity()),
    ("swing", _SWING, "$ΔW$", "J", None, work.swing),
    ("inertia", "Trägheitsmoment|Moment of inertia", "$J$", "kg m²", None, work.inertia),
    (
        "inertia_true",
        "Trägheitsmoment, Massen bei wahrer Geschwindigkeit|Moment of inertia, masses at their true speed",
        "$J_δ$", "kg m²", None, work.true_inertia, Needs.MASSES,
    ),
    ("mass", "Schwungmasse am Halbmesser|Mass at the radius", "$J/ρ^2$", "kg", None, work.mass, Needs.RADIUS),
)  # fmt: skip


# Of forces, in the order in which pages say them.
DIRECTIONS = Texts("engine", "directions")
AT_CRANK = Force("Stangenkraft an der Kurbel|Rod force at the crank", "S_A", "")


def _force_entries() -> Iterator[Quantity]:
    for key, acting in CRANK_FORCES.items():
        one = FORCES.get(key, AT_CRANK)
        in_steam = row(
            key, one.name, f"${one.letter}$", "$Q$", Of.CRANK, 4,
            lambda turn, where, force=acting: turn.crank_force(force, where.half_turns),
            direction=DIRECTIONS.get(key),
        )  # fmt: skip
        yield in_steam
        yield in_steam._replace(
            key=f"{key}_n", unit=words("N"), decimals=1, heading=words(f"{in_steam.symbol} in N"),
            scale=AnyTurn.force_unit, needs=(Needs.LOAD,),
        )  # fmt: skip
    yield row(
        "torque_nm", "Drehmoment|Torque", "$M_d$", "N m", Of.ANGLE, 1,
        lambda turn, where: turn.tangential_force(where.half_turns),
        scale=AnyTurn.torque_unit, needs=(Needs.TORQUE,),
        direction=words("$M_d$ an der Welle|$M_d$ on the shaft"),
    )  # fmt: skip
