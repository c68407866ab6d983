"""What acts in a cylinder: steam, an indicator card, a compressor, a pump, the cycle of a gas engine."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal, localcontext
from fractions import Fraction
from os import PathLike
from typing import TYPE_CHECKING, ClassVar, NamedTuple

from kurbel.commands.options import FILE, Choice, Option, Path, amount, flag, measure, word
from kurbel.commands.part import Rivals, Values, flag_of
from kurbel.commands.parts.effort import Piston
from kurbel.drive.load import CARD, COMPRESSOR, GAS, LOADS, PUMP, STEAM
from kurbel.errors import ProblemError
from kurbel.page.layouts import Layout
from kurbel.reading.given import (
    as_expansions,
    as_number,
    as_pressure,
    as_share,
    as_share_or_pressure,
    as_shares,
    of_given,
)

if TYPE_CHECKING:
    from kurbel.drive.load import Load as Acting
    from kurbel.engine.engine import Load


# What an ideal card is described by, and a measured one is not.
IDEAL = ("eps", "back", "exponent", "clearance", "release", "cushion", "lead")
FURTHER = ("pressure_ratio", "pump", "compression")
NEEDED = (
    "what acts on the piston is not known; add the expansion ratio of its steam, --eps 4, or --card,"
    " --pressure-ratio, --pump or --compression"
)


def _share(help: str, load: str) -> Option[Fraction | None]:
    return measure(as_share, help, "SHARE", machine=load, topic=load)


class CushionPressure(NamedTuple):
    """The pressure at the end of cushioning, as it was written, in the place of a share of the stroke."""

    pressure: str


def _cushion(given: object, what: str) -> Fraction | CushionPressure:
    return CushionPressure(str(given)) if _is_measure(given) else as_share(given, what)


class ClearanceShare(NamedTuple):
    """A share of the stroke, in the place of a volume in least volumes."""

    share: Fraction


def _cut_off(given: object, what: str) -> Fraction | ClearanceShare:
    shared = isinstance(given, str) and given.strip().endswith("%")
    return ClearanceShare(as_share(given, what)) if shared else as_number(given, what)


def _in_units_of_suction(help: str) -> Option[object]:
    return Option(help, "RATIO", machine="gas", topic="gas")


class Loads(Piston):
    """What acts on the piston, and what makes newtons of it.

    `others` of the options are of loads that nobody named where one that is typed outdoes them.
    """

    title, add = "the load of an engine", "--eps or --card"
    topic = "steam"
    rivals: ClassVar[Rivals] = (*((name, "card") for name in (*IDEAL, "pressure")), ("card", "eps"))

    eps = measure(
        lambda value, what: as_expansions(value),
        "Expansion ratio, cut-off after 1/ε of the stroke: 4; lists '2;3;4', ranges 2..6.", "ε", many=True,
        machine="steam",
    )  # fmt: skip
    back = amount(
        "Back pressure as a share of the steam pressure: 0.1, 10%, or beside --pressure as a pressure, both"
        " above vacuum: 1.1bar; default: the best, to which the steam expands.",
        "B",
        machine="steam",
    )
    exponent = measure(
        as_number,
        "n of p Vⁿ = const.; default 1, Mariotte's law, of gas engines 1.4.",
        "N",
        machine="steam compressor gas",
    )
    clearance = measure(
        as_share, "Clearance as a share of the swept volume: 0.05, 5%.", "C", machine="steam compressor"
    )
    release = _share(
        "Share of the stroke at which the exhaust opens: 90%; from there pressure falls evenly to --back.",
        "steam",
    )  # fmt: skip
    cushion = measure(
        _cushion,
        "Share of the return stroke at which the exhaust closes: 80%, or the pressure to which what is left"
        " in the clearance is compressed: 6bar.",
        "SHARE",
        machine="steam",
        topic="steam",
    )
    lead = _share("Share of the stroke before its dead centre at which steam enters: 1%.", "steam")
    card: Option[Sequence[Path] | Path] = Option(
        "Indicator card: CSV with position, p_forward [bar], p_return [bar], or angle, p [bar].",
        "FILE",
        FILE,
        many=True,
        machine="steam",
    )
    other_side = measure(
        as_pressure,
        "With --single-acting and --card or --pressure-ratio: pressure on the piston's other face, 1bar.",
        "PRESSURE", machine="steam compressor", topic="piston",
    )  # fmt: skip
    single_acting = flag(
        "One end works: steam on the outstroke only, and on the return both faces have the back pressure; a"
        " compressor sucks on the outstroke and delivers on the return.",
        machine="steam compressor",
        topic="piston",
    )
    pressure = measure(
        as_pressure,
        "Steam pressure before cut-off: 8bar; an indicator card has its own.", "PRESSURE",
        machine="steam",
    )  # fmt: skip
    pressure_ratio = measure(
        as_shares,
        "Compressor: pressure ratio p₂/p₁: 4; lists '2;3;4', ranges 2..6.",
        "Π",
        many=True,
        machine="compressor",
        topic="compressor",
    )
    suction_loss = _share(
        "Compressor: loss of the suction valves, a share of the suction pressure: 4%.", "compressor"
    )
    delivery_loss = _share(
        "Compressor: loss of the delivery valves, a share of the delivery pressure: 5%.", "compressor"
    )
    pump = word(
        "Pump: double (by itself), single or differential.",
        "KIND",
        Choice("pump", "kurbel.engine.loads.driven:KINDS"),
        bare="double",
        machine="pump.kind",
        topic="pump",
    )
    small_area = _share("Differential pump: its ring as a share of the piston's area; default 1/2.", "pump")
    suction_pressure = measure(
        as_pressure,
        "Suction pressure of a compressor or gas engine: 1bar; of a pump above that on the other face:"
        " -0.3bar.",
        "PRESSURE", machine="compressor pump gas", topic="compressor",
    )  # fmt: skip
    delivery_pressure = measure(
        as_pressure,
        "Delivery pressure of a pump, above that on the other face: 6bar.", "PRESSURE",
        machine="pump", topic="pump",
    )  # fmt: skip
    compression = measure(
        as_shares, "Gas engine: compression ratio: 6; lists '5;6;7', ranges 5..8.", "ε", many=True,
        what="compression ratio", machine="gas", topic="gas",
    )  # fmt: skip
    cycle = word(
        "Gas engine: otto (default), diesel or dual cycle.",
        kind=Choice("cycle", "kurbel.engine.loads.gas:CYCLES"),
        machine="gas",
        topic="gas",
    )
    peak_pressure = _in_units_of_suction(
        "Otto and dual cycle: greatest pressure in suction pressures, 30, or beside --suction-pressure"
        " 34.5bar."
    )
    cut_off = measure(
        lambda value, what: _cut_off(value, what),
        "Diesel and dual cycle: volume when the heat is supplied, in least volumes: 2, or a share of the"
        " stroke, 10%.", "RATIO",
        machine="gas", topic="gas",
    )  # fmt: skip
    heat = measure(
        as_number,
        "Gas engine: heat supplied in R T₁, for a kilogram: 10.",
        "RATIO",
        machine="gas",
        topic="gas",
    )
    expansion_exponent = measure(
        as_number,
        "n of the expansion, of a compressor that of the air left in its clearance; default that of"
        " --exponent, of a gas engine 1.4.",
        "N",
        machine="gas compressor",
        topic="gas",
    )
    exhaust_pressure = _in_units_of_suction("Gas engine: exhaust pressure in suction pressures; default 1.")
    two_stroke = flag("Gas engine: in two strokes.", machine="gas", topic="gas")

    @classmethod
    def settle(cls, values: Values) -> None:
        """Drop the loads that one which was typed outdoes, with all that describes them alone."""
        typed = [key for key in KINDS if values.typed(key) and values.says(key)]
        if not typed or not values.says(*FURTHER):
            return
        others = [key for key in KINDS if key not in typed and values.says(key)]
        values.drop(
            *(name for key in others for name in (key, *KINDS[key].options) if not values.typed(name))
        )

    def load_names(self) -> list[str]:
        """Return the options that name loads, as far as they are given."""
        return [key for key in KINDS if self.says(key)]

    @property
    def kind(self) -> str:
        """The option that names the load, nothing where none is named. Raises ProblemError for two."""
        found = self.load_names()
        if "card" in found and self.says(*IDEAL):
            name = next(one for one in IDEAL if self.says(one))
            raise ProblemError(
                f"{flag_of(name)} describes an ideal card, and --card gives a measured one; leave one out"
            )
        if len(found) > 1:
            raise ProblemError(
                f"{flag_of(found[0])} and {flag_of(found[1])} describe two loads; leave one out"
            )
        return found[0] if found else ""

    def loads(self, page: Layout) -> Sequence[Acting]:
        """Return the loads, those of all expansion or pressure ratios; steam is a layout's own if nothing is
        named. Raises ProblemError."""
        match self.kind:
            case "card":
                return self._cards()
            case "pressure_ratio":
                return self._compressors()
            case "pump":
                return [self._pump()]
            case "compression":
                return self._gas_cycles()
        return self._steams(page)

    def _steams(self, page: Layout) -> Sequence[Acting]:
        from kurbel.engine.loads.ideal import Steam

        back, pressure = self.back, self.raw("pressure") if self._back_is_pressure() else None
        share = None if back is None else as_share_or_pressure(back, "back pressure", pressure)
        exponent, clearance = self.exponent, self.clearance
        expansions = self.eps
        if expansions is None:
            if not page.expansions:
                raise ProblemError(NEEDED)
            expansions = as_expansions(page.expansions)
        exponent = Fraction(1) if exponent is None else exponent
        valves = {name: getattr(self, name) for name in ("release", "lead") if self.says(name)}
        if (cushion := self.cushioned()) is not None:
            valves["cushion"] = cushion
        return [Steam(one, share, exponent, clearance or Fraction(0), **valves) for one in expansions]

    def cushioned(self) -> Fraction | None:
        """Return the share of the return stroke at which the exhaust closes, also by the pressure reached.

        From p_b on p Vⁿ is constant, up to the clearance κ and the lead l: 1 - c + κ = (κ + l) (p/p_b)^(1/n),
        to 150 decimals, so that 50 are printed right. Raises KurbelError.
        """
        found = self.cushion
        if not isinstance(found, CushionPressure):
            return found
        if (back := self.back) is None:
            raise ProblemError(f"--cushion {found.pressure} is reached from the back pressure; add --back")
        steam, room = self.raw("pressure"), self.clearance or Fraction(0)
        end = as_share_or_pressure(found.pressure, "pressure of cushioning", steam)
        low = as_share_or_pressure(back, "back pressure", steam if self._back_is_pressure() else None)
        if not 0 < low < end:
            raise ProblemError(
                f"--cushion {found.pressure} must be above the back pressure, and that above 0"
            )
        with localcontext(prec=200):
            times, power = end / low, 1 / (self.exponent or Fraction(1))
            ratio = Decimal(times.numerator) / times.denominator
            grown = Fraction(round(ratio ** (Decimal(power.numerator) / power.denominator), 150))
        return 1 + room - (room + (self.lead or 0)) * (times if power == 1 else grown)

    def _back_is_pressure(self) -> bool:
        """Whether the back pressure is given as a pressure, which counts in that of the steam."""
        return _is_measure(self.values.values.get("back"))

    def _cards(self) -> Sequence[Acting]:
        """Return the indicator cards."""
        from kurbel.engine.card.card import Diagram
        from kurbel.engine.card.file import read_card

        other, single, files = self.other_side, self.single_acting, self.card
        if other is not None and not single:
            raise ProblemError(
                "--other-side is for --single-acting; double-acting, the other end works as well"
            )
        side = None if other is None else float(other)
        return [
            Diagram(read_card(file), side)
            for file in ([files] if isinstance(files, str | PathLike) else files)
        ]

    def _compressors(self) -> Sequence[Acting]:
        from kurbel.engine.loads.driven import Compressor

        other = self.other_side
        if other is not None:
            if not self.single_acting:
                raise ProblemError(
                    "--other-side is for --single-acting; double-acting, the other end works as well"
                )
            if (suction := self.suction_pressure) is None:
                raise ProblemError(
                    "--other-side is compared with the suction pressure; add --suction-pressure"
                )
            other /= _above_zero(suction)
        return [
            of_given(
                Compressor, ratio, exponent=self.exponent, clearance=self.clearance, other_side=other,
                suction_loss=self.suction_loss, delivery_loss=self.delivery_loss,
                expansion_exponent=self.expansion_exponent, **self.staged(),
            )
            for ratio in self.pressure_ratio or ()
        ]  # fmt: skip

    def staged(self) -> Mapping[str, object]:
        """Return the stages of a compressor, and what is between them."""
        return {}

    def _pump(self) -> Acting:
        from kurbel.engine.loads.driven import DIFFERENTIAL, DOUBLE, SINGLE, Pump

        kind = self.pump or DOUBLE
        if self.single_acting:
            if kind == DIFFERENTIAL:
                raise ProblemError("--single-acting and --pump differential are two pumps; leave one out")
            kind = SINGLE
        ring = self.small_area
        if ring is not None and kind != DIFFERENTIAL:
            raise ProblemError(
                "--small-area is for --pump differential, which has a ring; write that, or leave it out"
            )
        # Where newtons are not asked for, a double-acting pump, whose ends work alike, compares no pressures.
        counts = self.says("bore") or (kind != DOUBLE and self.says("suction_pressure"))
        suction, delivery = (self.suction_pressure, self.delivery_pressure) if counts else (None, None)
        if suction and delivery is None and kind != DOUBLE:
            raise ProblemError(
                "--suction-pressure is compared with what the pump makes; add --delivery-pressure"
            )
        makes = (suction or Fraction(0)) + 1 if delivery is None else delivery
        makes -= suction or Fraction(0)
        if makes <= 0:
            raise ProblemError(
                f"the delivery pressure {self.raw('delivery_pressure')} is not above the suction pressure"
                f" {self.raw('suction_pressure') or 0}; a pump raises the pressure"
            )
        share = Fraction(0) if delivery is None else (suction or Fraction(0)) / makes
        return Pump(kind, share) if ring is None else Pump(kind, share, ring)

    def _gas_cycles(self) -> Sequence[Acting]:
        from kurbel.engine.loads.gas import OTTO, GasCycle

        peak, exhaust = self._in_suctions("peak_pressure"), self._in_suctions("exhaust_pressure")
        return [
            of_given(
                GasCycle, ratio, self.cycle or OTTO, exponent=self.exponent, cut_off=self.cut_off_of(ratio),
                expansion_exponent=self.expansion_exponent, heat=self.heat, peak=peak, exhaust=exhaust,
                two_stroke=self.two_stroke,
            )
            for ratio in self.compression or ()
        ]  # fmt: skip

    def cut_off_of(self, compression: Fraction) -> Fraction | None:
        """Return the volume when the heat is supplied in the least one, also of a share of the stroke."""
        given = self.cut_off
        return 1 + given.share * (compression - 1) if isinstance(given, ClearanceShare) else given

    def _in_suctions(self, name: str) -> Fraction | None:
        """Return a pressure in suction pressures, which is given so or as a measure."""
        value, what = self.raw(name), name.replace("_", " ")
        if value is None:
            return None
        if not _is_measure(value):
            return as_number(value, what)
        if (suction := self.suction_pressure) is None:
            raise ProblemError(
                f"the {what} {str(value)[:40]} is compared with the suction pressure; add --suction-pressure"
            )
        return as_pressure(value, what) / _above_zero(suction)

    def newtons(self) -> Load | None:
        """Return what makes newtons of the force on the piston, None if it is not known."""
        kind = self.kind
        missing = [name for name in self.weighing() if not self.says(name)]
        if kind in FURTHER:
            if not self.says("bore"):
                return None
            if missing:
                raise ProblemError(f"newtons need the bore and the pressure; add {flag_of(missing[0])}")
        elif not self.says("bore") and (
            kind == "card" or not self.says("pressure") or self._back_is_pressure()
        ):
            return None
        elif missing:
            raise ProblemError(f"newtons need the bore and the steam pressure; add {flag_of(missing[0])}")
        from kurbel.engine.engine import Load

        bore = self.bore
        assert bore is not None
        if kind == "card":
            return Load(bore, None)
        if kind not in FURTHER:
            return Load(bore, self.pressure)
        suction = self.suction_pressure or Fraction(0)
        delivery = self.delivery_pressure if kind == "pump" else None
        return Load(bore, suction if delivery is None else delivery - suction)

    def weighing(self) -> tuple[str, ...]:
        """Return the options that make newtons of the load, against which masses are weighed."""
        return {
            "card": ("bore",), "pump": ("bore", "delivery_pressure"),
            **dict.fromkeys(("pressure_ratio", "compression"), ("bore", "suction_pressure")),
        }.get(self.kind, ("bore", "pressure"))  # fmt: skip

    def whole_cycle(self) -> Fraction:
        """Return the degrees after which everything comes again."""
        kind = self.kind
        if kind == "compression":
            return Fraction(360 if self.two_stroke else 720)
        if kind != "card":
            return Fraction(360)
        return Fraction(180 * max((getattr(one, "strokes_of_cycle", 2) for one in self._cards()), default=2))

    def usual_layout(self) -> str:
        """Return the layout of the irregularity under the load, nothing for steam and cards."""
        return next((KINDS[key].layout for key in FURTHER if self.says(key)), "")

    def unread(self, option: Option[object]) -> str:
        name, named = option.name, self.load_names()
        owners = [key for key, kind in KINDS.items() if name in kind.options]
        if name in KINDS or not owners:
            return ""
        steam = "; steam cut off after a quarter of the stroke is --eps 4" if name == "cut_off" else ""
        if not named:
            if owners in (["eps"], ["eps", "card"]):
                return f"{flag_of(name)} is for the steam of an engine; add --eps or --card"
            return f"{flag_of(name)} is for {_titles(owners)}; add {' or '.join(map(flag_of, owners))}{steam}"
        if "card" in named and name == "pressure":
            return "--pressure is that of ideal steam, and a card has its own; leave it out"
        if not set(named) & set(owners):
            title, steam = LOADS[KINDS[named[0]].load].title, steam if named == ["eps"] else ""
            return f"{flag_of(name)} is for {_titles(owners)}, not for {title}; leave it out{steam}"
        if name.endswith("pressure") and not self.says("bore"):
            return f"{flag_of(name)} makes newtons of the load only with --bore; add that"
        return ""


class Kind(NamedTuple):
    """A kind of load, the options that describe it further, and the layout of its irregularity."""

    load: str
    options: tuple[str, ...]
    layout: str = ""


def _of(section: str, *without: str, also: str = "") -> tuple[str, ...]:
    """Return the options that a section of a machine's file has of a load, without those that name one."""
    own = {
        one.name: {place.partition(".")[0] for place in one.machine.split()}
        for one in vars(Loads).values()
        if isinstance(one, Option) and one.name not in ("eps", "card", *FURTHER, *without)
    }
    return tuple(name for name, sections in own.items() if section in sections or name == also)


# By the option that names it.
KINDS: Mapping[str, Kind] = {
    "eps": Kind(STEAM, _of("steam", "other_side")),
    "card": Kind(CARD, _of("steam", *IDEAL, "pressure")),
    "pressure_ratio": Kind(COMPRESSOR, _of("compressor"), "compressor"),
    "pump": Kind(PUMP, _of("pump", also="single_acting"), "pump"),
    "compression": Kind(GAS, _of("gas"), "gas-cycle"),
}


def _is_measure(value: object) -> bool:
    # A unit has letters.
    if not isinstance(value, str) or not any(map(str.isalpha, value)):
        return False
    from kurbel.reading.units import is_measure

    return is_measure(value)


def _titles(keys: Sequence[str]) -> str:
    return " or ".join(LOADS[KINDS[key].load].title for key in keys)


def _above_zero(pressure: Fraction) -> Fraction:
    if pressure <= 0:
        raise ProblemError("the suction pressure must be above 0, that above vacuum")
    return pressure


def on_page(page: Layout) -> Layout:
    """Return a layout without the heading of its own for expansion ratios."""
    headings = {name: heading for name, heading in page.stub_headings.items() if name != "expansion"}
    return Layout(**{**vars(page), "stub_headings": headings})
