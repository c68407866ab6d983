"""Compressors, pumps and the cycles of gas engines, as options describe them."""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, TypedDict

from kurbel.commands.options import FLAG, Choice, Option, is_given
from kurbel.drive.load import CARD, COMPRESSOR, GAS, LOADS, PUMP, STEAM
from kurbel.errors import ProblemError
from kurbel.page.layouts import Layout
from kurbel.reading.given import Exact, as_number, as_pressure, as_share, as_shares

if TYPE_CHECKING:
    from kurbel.drive.load import Load as Acting
    from kurbel.engine.engine import Load

# The option that names a load, and those that describe it further.
OWN: Mapping[str, tuple[str, tuple[str, ...]]] = {
    "eps": (STEAM, ("back", "exponent", "clearance", "single_acting", "pressure")),
    "card": (CARD, ("other_side", "single_acting")),
    "pressure_ratio": (
        COMPRESSOR,
        ("exponent", "clearance", "suction_loss", "delivery_loss", "suction_pressure", "other_side",
         "single_acting"),
    ),
    "pump": (PUMP, ("small_area", "suction_pressure", "delivery_pressure", "single_acting")),
    "compression": (
        GAS,
        ("cycle", "peak_pressure", "cut_off", "heat", "exponent", "expansion_exponent", "exhaust_pressure",
         "two_stroke", "suction_pressure"),
    ),
}  # fmt: skip
# Those that steam and cards do not have.
FURTHER = tuple(
    dict.fromkeys(
        name
        for key in OWN
        for name in (key, *OWN[key][1])
        if name not in ("eps", "card", *OWN["eps"][1], *OWN["card"][1])
    )
)
# Of these those that name a load, and those that do not.
NAMES = tuple(key for key in OWN if key in FURTHER)
PARTS = tuple(name for name in FURTHER if name not in OWN)
# The layouts of their irregularity, unless it is named.
LAYOUTS = {"pressure_ratio": "compressor", "pump": "pump", "compression": "gas-cycle"}
_Several = Annotated[
    Exact | Iterable[Exact] | None,
    Option("Compressor: pressure ratio p₂/p₁: 4; lists '2;3;4', ranges 2..6.", "Π", many=True),
]


def _share(help: str) -> Option[Any]:
    return Option(help, "SHARE")


class Loads(TypedDict, total=False):
    """What acts on the piston in place of steam."""

    pressure_ratio: _Several
    suction_loss: Annotated[
        Exact | None, _share("Compressor: loss of the suction valves, a share of the suction pressure: 4%.")
    ]
    delivery_loss: Annotated[
        Exact | None,
        _share("Compressor: loss of the delivery valves, a share of the delivery pressure: 5%."),
    ]
    pump: Annotated[
        str | None,
        Option(
            "Pump: double (by itself), single or differential.",
            "KIND",
            Choice("pump", "kurbel.engine.loads.pump:KINDS"),
            bare="double",
        ),
    ]
    small_area: Annotated[
        Exact | None, _share("Differential pump: its ring as a share of the piston's area; default 1/2.")
    ]
    suction_pressure: Annotated[
        Exact | None,
        Option(
            "Suction pressure of a compressor or gas engine: 1bar; of a pump above that on the other face:"
            " -0.3bar.",
            "PRESSURE",
            unit="Pa",
        ),
    ]
    delivery_pressure: Annotated[
        Exact | None,
        Option("Delivery pressure of a pump, above that on the other face: 6bar.", "PRESSURE", unit="Pa"),
    ]
    compression: Annotated[
        Exact | Iterable[Exact] | None,
        Option("Gas engine: compression ratio: 6; lists '5;6;7', ranges 5..8.", "ε", many=True),
    ]
    cycle: Annotated[
        str | None,
        Option(
            "Gas engine: otto (default), diesel or dual cycle.",
            kind=Choice("cycle", "kurbel.engine.loads.gas:CYCLES"),
        ),
    ]
    peak_pressure: Annotated[
        Exact | None,
        Option(
            "Otto and dual cycle: greatest pressure in suction pressures, 30, or beside --suction-pressure"
            " 34.5bar.",
            "RATIO",
        ),
    ]
    cut_off: Annotated[
        Exact | None,
        Option("Diesel and dual cycle: volume when the heat is supplied, in least volumes: 2.", "RATIO"),
    ]
    heat: Annotated[Exact | None, Option("Gas engine: heat supplied in R T₁, for a kilogram: 10.", "RATIO")]
    expansion_exponent: Annotated[
        Exact | None, Option("Gas engine: n of the expansion; default that of --exponent, 1.4.", "N")
    ]
    exhaust_pressure: Annotated[
        Exact | None, Option("Gas engine: exhaust pressure likewise; default 1.", "RATIO")
    ]
    two_stroke: Annotated[bool, Option("Gas engine: in two strokes.", kind=FLAG, default=False)]


def named(given: Mapping[str, Any]) -> list[str]:
    """Return the options that name loads, or cylinders with theirs, as far as they are given."""
    return [key for key in (*OWN, "cylinder") if is_given(given.get(key))]


def loads_of(given: Mapping[str, Any]) -> Sequence["Acting"]:
    """Return the loads of what steam and cards do not have. Raises ProblemError for what says nothing."""
    key = _key(given)
    for name in dict.fromkeys(option for _, own in OWN.values() for option in own):
        if name not in OWN[key][1] and is_given(given.get(name)):
            raise ProblemError(
                f"{_flag(name)} does not belong to {LOADS[OWN[key][0]].title}; it is for {_owners(name)}"
            )
    return _READERS[key](given)


def uncounted(given: Mapping[str, Any]) -> Mapping[str, str]:
    """Refuse the pressures of a load in which nothing is counted: they make newtons with a bore."""
    if is_given(given["card"]):
        return {"pressure": "--pressure is that of ideal steam, and a card has its own; leave it out"}
    if is_given(given.get("cylinder")) or given["bore"] is not None:
        return {}
    why = "makes newtons of the load only with --bore; add that"
    return {name: f"{_flag(name)} {why}" for name in _uncounted(given)}


def _uncounted(given: Mapping[str, Any]) -> tuple[str, ...]:
    """Return the pressures that neither an end of a pump nor another pressure is compared with."""
    if not is_given(given["pump"]):
        others = (given["other_side"], given["peak_pressure"], given["exhaust_pressure"])
        return () if any(re.search("[a-z]", str(one or "")) for one in others) else ("suction_pressure",)
    if given["pump"] == "double" and not given["single_acting"]:
        return ("suction_pressure", "delivery_pressure")
    return ("delivery_pressure",) if given["suction_pressure"] is None else ()


def load_of(given: Mapping[str, Any]) -> "Load | None":
    """Return what makes newtons of the force on their pistons, None if it is not known."""
    if given.get("bore") is None:
        return None
    for name in pressures_of(given):
        if given.get(name) is None:
            raise ProblemError(f"newtons need the bore and the pressure; add {_flag(name)}")
    from kurbel.engine.engine import Load
    from kurbel.reading.given import as_length

    known = _known(given, ("suction_pressure", as_pressure), ("delivery_pressure", as_pressure))
    suction = known.get("suction_pressure", Fraction(0))
    pressure = known["delivery_pressure"] - suction if is_given(given["pump"]) else suction
    return Load(as_length(given["bore"], "bore"), pressure)


def whole_cycle(given: Mapping[str, Any]) -> Fraction:
    """Return the degrees after which everything comes again: of a four-stroke cycle two turns."""
    return Fraction(720 if is_given(given.get("compression")) and not given["two_stroke"] else 360)


def layout_of_load(given: Mapping[str, Any]) -> str:
    """Return the layout of the irregularity under a load, nothing where none is named."""
    return next((layout for key, layout in LAYOUTS.items() if is_given(given.get(key))), "")


def on_page(page: Layout) -> Layout:
    """Return a layout without the heading of its own for expansion ratios."""
    headings = {name: heading for name, heading in page.stub_headings.items() if name != "expansion"}
    return Layout(**{**vars(page), "stub_headings": headings})


def pressures_of(given: Mapping[str, Any]) -> tuple[str, ...]:
    """Return the pressures without which Q is not known."""
    return ("delivery_pressure",) if is_given(given["pump"]) else ("suction_pressure",)


def _key(given: Mapping[str, Any]) -> str:
    found = named(given)
    if len(found) > 1:
        raise ProblemError(f"{_flag(found[0])} and {_flag(found[1])} describe two loads; leave one out")
    if not found or found[0] in ("eps", "card"):
        raise ProblemError(astray(next(name for name in FURTHER if is_given(given.get(name)))))
    return found[0]


def astray(name: str) -> str:
    """Return the sentence that refuses an option of loads of which none is named."""
    steam = "; steam cut off after a quarter of the stroke is --eps 4" if name == "cut_off" else ""
    return (
        f"{_flag(name)} is for {_owners(name)}; add {' or '.join(_flag(key) for key in _keys(name))}{steam}"
    )


def _keys(name: str) -> list[str]:
    return [key for key, (_, own) in OWN.items() if name in own]


def _owners(name: str) -> str:
    return " or ".join(LOADS[load].title for load, own in OWN.values() if name in own)


def _flag(name: str) -> str:
    return f"--{name.replace('_', '-')}"


def _read(given: Mapping[str, Any], name: str, reader: Callable[..., Fraction]) -> Fraction | None:
    return None if given[name] is None else reader(given[name], name.replace("_", " "))


def _known(given: Mapping[str, Any], *readers: tuple[str, Callable[..., Fraction]]) -> dict[str, Fraction]:
    """Return those of the numbers that are given, by their names."""
    found = {name: _read(given, name, reader) for name, reader in readers}
    return {name: value for name, value in found.items() if value is not None}


def _compressors(given: Mapping[str, Any]) -> Sequence["Acting"]:
    from kurbel.engine.loads.compressor import Compressor

    known = _known(
        given,
        ("exponent", as_number), ("clearance", as_share), ("suction_loss", as_share),
        ("delivery_loss", as_share), ("other_side", as_pressure),
    )  # fmt: skip
    if "other_side" in known:
        if not given["single_acting"]:
            raise ProblemError(
                "--other-side is for --single-acting; double-acting, the other end works as well"
            )
        if given["suction_pressure"] is None:
            raise ProblemError("--other-side is compared with the suction pressure; add --suction-pressure")
        known["other_side"] /= _above_zero(as_pressure(given["suction_pressure"], "suction pressure"))
    ratios = as_shares(given["pressure_ratio"], "pressure ratio")
    return [Compressor(ratio, **known) for ratio in ratios]


def _pumps(given: Mapping[str, Any]) -> Sequence["Acting"]:
    from kurbel.engine.loads.pump import DIFFERENTIAL, DOUBLE, SINGLE, Pump

    kind = given["pump"]
    if given["single_acting"]:
        if kind == DIFFERENTIAL:
            raise ProblemError("--single-acting and --pump differential are two pumps; leave one out")
        kind = SINGLE
    if given["small_area"] is not None and kind != DIFFERENTIAL:
        raise ProblemError("--small-area is for --pump differential, which has a ring")
    known = _known(given, ("suction_pressure", as_pressure), ("delivery_pressure", as_pressure))
    suction = known.get("suction_pressure", Fraction(0))
    if suction and "delivery_pressure" not in known and kind != DOUBLE:
        raise ProblemError("--suction-pressure is compared with what the pump makes; add --delivery-pressure")
    makes = known.get("delivery_pressure", suction + 1) - suction
    if makes <= 0:
        raise ProblemError(
            f"the delivery pressure {given['delivery_pressure']} is not above the suction pressure"
            f" {given['suction_pressure'] or 0}; a pump raises the pressure"
        )
    ring = _known(given, ("small_area", as_share))
    return [Pump(kind, suction / makes if "delivery_pressure" in known else Fraction(0), **ring)]


def _cycles(given: Mapping[str, Any]) -> Sequence["Acting"]:
    from kurbel.engine.loads.gas import OTTO, GasCycle

    names = {"peak_pressure": "peak", "exhaust_pressure": "exhaust"}
    numbers = ("exponent", "expansion_exponent", "cut_off", "heat")
    in_suctions = partial(_in_suctions, given["suction_pressure"])
    found = _known(given, *((name, as_number) for name in numbers), *((name, in_suctions) for name in names))
    known: dict[str, Any] = {names.get(name, name): value for name, value in found.items()}
    cycle, ratios = given["cycle"] or OTTO, as_shares(given["compression"], "compression ratio")
    return [GasCycle(ratio, cycle, two_stroke=given["two_stroke"], **known) for ratio in ratios]


def _in_suctions(suction: Exact | None, pressure: Exact, what: str) -> Fraction:
    """Return a pressure in suction pressures, which is given so or as a measure."""
    from kurbel.reading.units import is_measure

    if not isinstance(pressure, str) or not is_measure(pressure):
        return as_number(pressure, what)
    if suction is None:
        raise ProblemError(
            f"the {what} {pressure[:40]} is compared with the suction pressure; add --suction-pressure"
        )
    return as_pressure(pressure, what) / _above_zero(as_pressure(suction, "suction pressure"))


def _above_zero(pressure: Fraction) -> Fraction:
    if pressure <= 0:
        raise ProblemError("the suction pressure must be above 0, that above vacuum")
    return pressure


_READERS: Mapping[str, Callable[[Mapping[str, Any]], Sequence["Acting"]]] = {
    "pressure_ratio": _compressors,
    "pump": _pumps,
    "compression": _cycles,
}
