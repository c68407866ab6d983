"""What pages say of each kind of load, and what tells one from another of the same page."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.drive.at import known
from kurbel.drive.load import CARD, COMPRESSOR, GAS, PUMP, STEAM
from kurbel.exact.numerals import Label, exact_text, figure
from kurbel.page.quantity import Texts, Words, words
from kurbel.reading.amounts import amount
from kurbel.reading.given import found_at
from kurbel.reading.notation import plain

if TYPE_CHECKING:
    from kurbel.engine.engine import Assembly, Engine, Load
    from kurbel.engine.loads.driven import Compressor, Pump
    from kurbel.engine.loads.gas import GasCycle

CYCLES = Texts("engine.loads", "cycles")
OF_STEAM = Texts("engine.loads", "of_steam")
OTHERS = Texts("engine.loads", "others")
PUMP_KINDS = Texts("engine.loads", "pump_kinds")
PUMPS = Texts("engine.loads", "pumps")
CYLINDERS = Texts("engine", "cylinders")


class LoadWords(NamedTuple):
    """What pages say of a kind of load, and what tells one from another of the same page.

    `key` is that of its field, `symbol` its letter, if it has one. `number` is what varies, None where that
    is no number, `label` how it is written. `machine` is what is driven by it or drives it, in the genitive,
    `several` what loads are called in sentences. `forces` says what Q is, `newtons` what it is of, and
    `lines` yields what there is to be said of loads, the first of which is that of an engine; `layout` is
    that of its irregularity, `halved` tells that a single-acting one is called so, `captioned` that what
    tells it from others stands in captions, `tag` what stands for it in records where that is not what is
    written, `pressure` the end of
    a list of options that make newtons of the force.
    """

    key: str
    name: Words
    symbol: Label
    number: Callable[[Any], Fraction | None]
    label: Callable[[Any, str], Label]
    machine: Words
    several: str
    forces: Words
    newtons: Callable[[Any, Load], Label]
    lines: Callable[[Sequence[Any], Engine, str], Iterator[Label]]
    layout: str = "delta-detail"
    halved: bool = True
    captioned: bool = True
    tag: Callable[[Any], Label] | None = None
    pressure: str = " and, but for a card, --pressure"


SAID: Mapping[str, str] = {
    STEAM: "kurbel.engine.loads.words:STEAM_WORDS",
    CARD: "kurbel.engine.loads.words:CARD_WORDS",
    COMPRESSOR: "kurbel.engine.loads.words:COMPRESSOR_WORDS",
    PUMP: "kurbel.engine.loads.words:PUMP_WORDS",
    GAS: "kurbel.engine.loads.words:GAS_WORDS",
}


@cache
def words_of(load: str) -> LoadWords:
    """Return what is said of a load, by its name."""
    found = found_at(SAID[load])
    assert isinstance(found, LoadWords)
    return found


def lettered(said: LoadWords, load: Any, lang: str) -> Label:
    """Return what tells a load from others with its letter, if it has one: $ε = 4$, card.csv."""
    label, letter = said.label(load, lang), said.symbol.strip("$")
    return f"${letter} = {label.strip('$')}$" if letter else label


def load_text(load: Any, lang: str) -> Label:
    """Return the same of a load by itself."""
    return lettered(words_of(load.name), load, lang)


def number_label(number: Fraction) -> Label:
    """Return a number as pages print it: 2, 2.5 or, of no finite decimal, 7/3."""
    shown = plain(number)
    return f"${shown if len(shown) <= 8 else f'{number.numerator}/{number.denominator}'}$"


def millimetres(length: Fraction) -> Label:
    """Return a length as it stands in a formula."""
    return amount(length, "mm", exact_text)


def kilopascals(load: Load, times: Fraction = Fraction(1)) -> Label:
    """Return the pressure that Q is of, or a multiple of it, as it stands in a formula."""
    return amount(known(load.pressure) * times, "kPa", exact_text)


def _steam_lines(steams: Sequence[Any], _: Engine, lang: str) -> Iterator[Label]:
    steam = steams[0]
    if all(one.expansion == 1 for one in steams):
        yield OF_STEAM["uncut"][lang]
    elif steam.exponent == 1:
        yield OF_STEAM["mariotte"][lang]
    else:
        yield OF_STEAM["polytropic"][lang].format(exponent=exact_text(steam.exponent))
    if steam.clearance:
        yield OF_STEAM["clearance"][lang].format(clearance=exact_text(steam.clearance))
    elif any(one.expansion != 1 for one in steams):
        yield OF_STEAM["unclear"][lang]
    if steam.back is not None:
        yield OF_STEAM["back"][lang].format(back=f"{exact_text(steam.back)} Q" if steam.back else "0")
    else:
        yield best_back(steam, "R_b", "Q", lang)
    yield from valve_lines(steam, lang)


def valve_lines(steam: object, lang: str) -> Iterator[Label]:
    """Yield what there is to be said of the points at which valves open and close, beside the cut-off."""
    for name, usual in (("release", 1), ("cushion", 1), ("lead", 0)):
        if (share := getattr(steam, name)) != usual:
            yield OF_STEAM[name][lang].format(share=f"${figure(share)}$")


def best_back(steam: Any, back: Label, full: Label, lang: str) -> Label:
    """Return what pages say of the back pressure that is taken where none is given, in these letters."""
    said = "best" if steam.exponent == 1 and not steam.clearance else "best_end"
    return OF_STEAM[said][lang].format(back=back, full=full)


def engine_lines(loads: Sequence[Any], engine: Engine, lang: str) -> Iterator[Label]:
    """Yield what there is to be said of an engine under the first of some loads: of these, its sides and its
    cranks."""
    said = words_of(loads[0].name)
    yield from said.lines(loads, engine, lang)
    if said.halved:
        yield OF_STEAM["double" if engine.double else "single"][lang]
    if len(engine.cranks) > 1:
        angles = ", ".join(f"${plain(angle)}°$" for angle in engine.cranks[1:])
        yield OF_STEAM["cranks"][lang].format(angles=angles)


STEAM_WORDS = LoadWords(
    key="epsilon",
    name=words("Expansionsverhältnis|Expansion ratio"),
    symbol="$ε$",
    number=lambda steam: steam.expansion,
    label=lambda steam, lang: number_label(steam.expansion),
    machine=words("der Dampfmaschine|of the steam engine"),
    several="expansion ratios",
    forces=words(
        "$Q$ Dampfkraft auf den Kolben vor der Absperrung, $r$ Kurbelhalbmesser"
        "|$Q$ steam force on the piston before cut-off, $r$ crank radius"
    ),
    newtons=lambda steam, load: f"$Q = π/4 d^2 p$, $d = {millimetres(load.bore)}$, $p = {kilopascals(load)}$",
    lines=_steam_lines,
)


CARD_WORDS = LoadWords(
    key="card",
    name=words("Diagramm|Card"),
    symbol="",
    number=lambda diagram: None,
    label=lambda diagram, lang: os.path.basename(diagram.card.name).replace("$", "\\$"),
    machine=STEAM_WORDS.machine,
    several="cards",
    forces=words(
        "$Q$ größter Druck des Diagramms mal Kolbenfläche, $r$ Kurbelhalbmesser"
        "|$Q$ greatest pressure of the card times piston area, $r$ crank radius"
    ),
    newtons=lambda diagram, load: f"$d = {millimetres(load.bore)}$",
    lines=lambda loads, engine, lang: iter([OF_STEAM["card"][lang]]),
)


def _compressor_lines(loads: Sequence[Compressor], engine: Engine, lang: str) -> Iterator[Label]:
    load = loads[0]
    if load.expansion_exponent is not None:
        yield _apart(load.exponent, load.expansion_exponent, lang)
    elif load.exponent == 1:
        yield OTHERS["isothermal"][lang]
    else:
        yield OTHERS["polytropic"][lang].format(exponent=figure(load.exponent))
    if load.clearance:
        yield OTHERS["clearance"][lang].format(clearance=figure(load.clearance))
    else:
        yield OTHERS["unclear"][lang]
    if load.suction_loss:
        yield OTHERS["suction_loss"][lang].format(share=figure(load.suction_loss))
    if load.delivery_loss:
        yield OTHERS["delivery_loss"][lang].format(share=figure(load.delivery_loss))
    if not (load.suction_loss or load.delivery_loss):
        yield OTHERS["lossless"][lang]
    if not engine.double:
        said = "same_side" if load.other_side == 1 else "other_side"
        yield OTHERS[said][lang].format(share=figure(load.other_side))


def _apart(compression: Fraction, expansion: Fraction, lang: str) -> Label:
    return OTHERS["apart"][lang].format(compression=figure(compression), expansion=figure(expansion))


def _pump_lines(loads: Sequence[Pump], engine: Engine, lang: str) -> Iterator[Label]:
    load = loads[0]
    yield PUMPS[load.kind][lang]
    if load.differential:
        usual = " (--small-area)" if load.small_area == Fraction(1, 2) else ""
        yield OTHERS["ring"][lang].format(share=figure(load.small_area), usual=usual)
    if not load.double:
        yield _suction(load, engine.load, lang)


def _suction(pump: Pump, known: Load | None, lang: str) -> Label:
    """The suction pressure against that on the other face: in kPa, or in what the pump makes."""
    if not pump.suction:
        return OTHERS["no_suction_head"][lang]
    head = abs(pump.suction)
    said = f"{figure(head)} (p_d - p_s)" if known is None else kilopascals(known, head)
    return OTHERS["above" if pump.suction > 0 else "below"][lang].format(head=said)


def _gas_lines(loads: Sequence[GasCycle], _: Engine, lang: str) -> Iterator[Label]:
    load = loads[0]
    yield CYCLES[load.cycle][lang]
    yield OTHERS["two" if load.two_stroke else "four"][lang]
    for key in ("peak", "cut_off", "heat"):
        if (value := getattr(load, key)) is not None:
            yield OTHERS[key][lang].format(**{key: figure(value)})
    if load.expansion_exponent in (None, load.exponent):
        usual = " (--exponent)" if load.exponent == Fraction(7, 5) else ""
        yield OTHERS["both"][lang].format(exponent=figure(load.exponent)) + usual
    else:
        yield _apart(load.exponent, known(load.expansion_exponent), lang)
    if not load.two_stroke:
        said = "unraised" if load.exhaust == 1 else "exhaust"
        yield OTHERS[said][lang].format(exhaust=figure(load.exhaust))


def _of_suction(_: object, load: Load) -> Label:
    return f"$Q = π/4 d^2 p_1$, $d = {millimetres(load.bore)}$, $p_1 = {kilopascals(load)}$"


def _of_pump(pump: Pump, load: Load) -> Label:
    return (
        f"$Q = π/4 d^2 (p_d - p_s)$, $d = {millimetres(load.bore)}$,"
        f" $p_s = {kilopascals(load, pump.suction)}$, $p_d = {kilopascals(load, pump.suction + 1)}$"
    )


COMPRESSOR_WORDS = LoadWords(
    key="pressure_ratio",
    name=words("Druckverhältnis|Pressure ratio"),
    symbol="$Π$",
    number=lambda load: load.ratio,
    label=lambda load, lang: number_label(load.ratio),
    machine=words("des Kompressors|of the compressor"),
    several="pressure ratios",
    forces=words(
        "$Q$ Saugdruck $p_1$ mal Kolbenfläche, $Π = p_2/p_1$, $r$ Kurbelhalbmesser"
        "|$Q$ suction pressure $p_1$ times piston area, $Π = p_2/p_1$, $r$ crank radius"
    ),
    newtons=_of_suction,
    lines=_compressor_lines,
    layout="compressor",
    pressure=" and --suction-pressure",
)


PUMP_WORDS = LoadWords(
    key="pump",
    name=words("Pumpe|Pump"),
    symbol="",
    number=lambda load: None,
    label=lambda load, lang: PUMP_KINDS[load.kind][lang],
    machine=words("der Kolbenpumpe|of the piston pump"),
    several="pumps",
    forces=words(
        "$Q$ Förderdruck $p_d$ weniger Saugdruck $p_s$, mal Kolbenfläche, $r$ Kurbelhalbmesser"
        "|$Q$ delivery pressure $p_d$ less suction pressure $p_s$, times piston area, $r$ crank radius"
    ),
    newtons=_of_pump,
    lines=_pump_lines,
    halved=False,
    captioned=False,
    tag=lambda load: load.kind,
    layout="pump",
    pressure=" and --delivery-pressure",
)


GAS_WORDS = LoadWords(
    key="compression",
    name=words("Verdichtungsverhältnis|Compression ratio"),
    symbol="$ε$",
    number=lambda load: load.compression,
    label=lambda load, lang: number_label(load.compression),
    machine=words("der Gasmaschine|of the gas engine"),
    several="compression ratios",
    forces=words(
        "$Q$ Saugdruck $p_1$ mal Kolbenfläche, $r$ Kurbelhalbmesser"
        "|$Q$ suction pressure $p_1$ times piston area, $r$ crank radius"
    ),
    newtons=_of_suction,
    lines=_gas_lines,
    layout="gas-cycle",
    halved=False,
    pressure=" and --suction-pressure",
)


def words_of_cylinders(assembly: Assembly) -> LoadWords:
    """Return what is said of the cylinders of an engine."""
    own, count = words_of(assembly.parts[0].steam.name), len(assembly.cranks)
    machine = CYLINDERS["of_several" if count > 1 else "of_one"]
    forces = {lang: said + CYLINDERS["of_first"][lang] for lang, said in own.forces.items()}

    return LoadWords(
        key="cylinders",
        name=words("Zylinder|Cylinders"),
        symbol="",
        number=lambda load: Fraction(count),
        label=lambda load, lang: CYLINDERS["count" if count > 1 else "one"][lang].format(count=count),
        machine={lang: text.format(count=count) for lang, text in machine.items()},
        several="engines",
        forces=forces,
        newtons=own.newtons,
        lines=own.lines,
        captioned=False,
        tag=lambda load: f"{count} cylinders" if count > 1 else "1 cylinder",
        pressure=own.pressure,
    )
