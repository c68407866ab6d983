"""The ideal cycles of gas engines: Otto, Diesel and dual, in four strokes or two."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import ClassVar, NamedTuple

from kurbel.drive.load import GAS
from kurbel.engine.loads.ideal import LEAST_WORK, check_exponent
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind, floats
from kurbel.kernel.circle import Numeric
from kurbel.kernel.law import Constant, Law, Piece, Polytrope, Stroke
from kurbel.kernel.steam import power
from kurbel.reading.given import choose
from kurbel.reading.notation import about, check_bounds, plain

OTTO, DIESEL, DUAL = CYCLES = ("otto", "diesel", "dual")
LARGEST_COMPRESSION = 1000
HIGHEST = 10**9
# What each cycle is told by: the heat, or these.
TOLD_BY = {OTTO: ("peak",), DIESEL: ("cut_off",), DUAL: ("peak", "cut_off")}
OPTIONS = {"peak": "--peak-pressure", "cut_off": "--cut-off", "heat": "--heat"}


class _Points(NamedTuple):
    """The corners of a cycle on a kind of number: pressures in p₁, volumes as shares of the swept one."""

    compressed: Numeric
    peak: Numeric
    clearance: Numeric
    # How many times its volume the gas fills when the heat has been supplied.
    cut_off: Numeric
    compression: Numeric
    expansion: Numeric


@dataclass(frozen=True, slots=True)
class GasCycle:
    """Compression ratio ε, exponents of compression and expansion, and how much heat is supplied.

    The Otto cycle has it at one volume, up to the pressure `peak`; the Diesel cycle at one pressure, until
    the volume has grown `cut_off` times; the dual cycle (Seiliger) both. In place of the last of these `heat`
    gives it as q/(R T₁), per kilogram, of a gas whose adiabatic exponent that of both curves is. Pressures
    are in units of the suction pressure p₁, which is also that on the other face; Q is p₁ times the piston's
    area. The turn begins with the expansion. In two strokes the charge is changed in the outer dead centre.
    Derived by us from the textbook's cycles.
    """

    name: ClassVar[str] = GAS
    driven: ClassVar[bool] = False
    # It works in one end.
    double: ClassVar[bool] = False

    compression: Fraction
    cycle: str = OTTO
    peak: Fraction | None = None
    cut_off: Fraction | None = None
    heat: Fraction | None = None
    exponent: Fraction = Fraction(7, 5)
    expansion_exponent: Fraction | None = None
    exhaust: Fraction = Fraction(1)
    two_stroke: bool = False

    def __post_init__(self) -> None:
        check_bounds(
            "compression ratio ε", self.compression,
            f"be above 1 and at most {LARGEST_COMPRESSION}, for it is the greatest volume in least ones",
        )  # fmt: skip
        choose(self.cycle, CYCLES, "cycle")
        check_exponent(self.exponent, "exponent n")
        if self.expansion_exponent is not None:
            check_exponent(self.expansion_exponent, "expansion exponent")
        check_bounds(
            "exhaust pressure", self.exhaust, "be above 0 and at most 10^9", " times the suction pressure"
        )
        self._check_heat()
        self._check_points()

    @property
    def strokes_of_cycle(self) -> int:
        """How many strokes a cycle has."""
        return 2 if self.two_stroke else 4

    def strokes(self, kind: Kind, double: bool) -> tuple[Stroke, ...]:
        """Return the expansion, the exhaust, the suction and the compression; of two strokes the first and
        the last."""
        points, atmosphere = self._points(kind), Constant(kind.of(Fraction(1)))
        whole = 1 + points.clearance
        compressed = Polytrope(kind.of(Fraction(1)), whole, points.compression, whole, -1)
        expansion = Stroke(self._expansion(points), atmosphere)
        compression = Stroke(atmosphere, compressed)
        if self.two_stroke:
            return expansion, compression
        exhaust = Stroke(atmosphere, Constant(kind.of(self.exhaust)))
        return expansion, exhaust, Stroke(atmosphere, atmosphere), compression

    def efficiency(self, kind: Kind) -> Numeric:
        """Return the share of the heat that becomes work, the change of the charge not counted.

        1 - (ξ ρ^n - 1)/(ε^(n - 1) (ξ - 1 + n ξ (ρ - 1))), ξ the rise of the pressure at one volume. It has a
        meaning where both curves are adiabatic.
        """
        points = self._points(kind)
        rise, cut_off, exponent = points.peak / points.compressed, points.cut_off, points.compression
        supplied = rise - 1 + exponent * rise * (cut_off - 1)
        lost = rise * power(cut_off, exponent) - 1
        return 1 - lost * kind.of(self.compression) / (points.compressed * supplied)

    @property
    def adiabatic(self) -> bool:
        """Whether both curves have one exponent, above 1, as adiabatic ones of a gas have."""
        return self.expansion_exponent in (None, self.exponent) and self.exponent > 1

    def _expansion(self, points: _Points) -> Piece | Law:
        volume = points.clearance * points.cut_off
        expanding = Polytrope(points.peak, volume, points.expansion, points.clearance, 1)
        if self.cycle == OTTO:
            return expanding
        return Law((Constant(points.peak), expanding), (volume - points.clearance,))

    def _points(self, kind: Kind) -> _Points:
        compression = kind.exponent(self.exponent)
        expansion = kind.exponent(self.expansion_exponent or self.exponent)
        compressed = power(kind.of(self.compression), compression)
        peak = compressed if self.peak is None else kind.of(self.peak)
        cut_off = kind.of(Fraction(1) if self.cut_off is None else self.cut_off)
        if self.heat is not None:
            supplied = kind.of(self.heat * self.compression * (self.exponent - 1))
            if self.cycle == OTTO:
                peak = compressed + supplied
            else:
                cut_off = 1 + (supplied - (peak - compressed)) / (compression * peak)
        return _Points(compressed, peak, kind.of(1 / (self.compression - 1)), cut_off, compression, expansion)

    def _check_heat(self) -> None:
        needed = TOLD_BY[self.cycle]
        given = [one for one in ("peak", "cut_off", "heat") if getattr(self, one) is not None]
        told = {needed, (*needed[:-1], "heat")}
        if tuple(given) not in told:
            ways = " or ".join(sorted(map(_options, told)))
            said = f"given was {_options(given)}" if given else "none was given"
            name = self.cycle if self.cycle == DUAL else self.cycle.capitalize()
            raise ProblemError(f"the {name} cycle needs {ways}, for example {_EXAMPLES[self.cycle]}; {said}")
        if self.heat is not None:
            if not self.adiabatic:
                raise ProblemError(
                    "--heat needs one exponent above 1, the gas's adiabatic one, for both curves; leave"
                    " --expansion-exponent out, or tell the cycle by its pressure and cut-off"
                )
            check_bounds("heat", self.heat, "be above 0 and at most 10^9, for it is q/(R T₁)")

    def _check_points(self) -> None:
        points = self._points(floats())
        if self.peak is not None and not points.compressed <= self.peak <= HIGHEST:
            raise ProblemError(
                f"peak pressure is {about(self.peak)} times the suction pressure; it must be at least the"
                f" {points.compressed:.6g} times of the gas compressed ε = {plain(self.compression)} times,"
                " and at most 10^9"
            )
        if not 1 <= points.cut_off <= self.compression:
            raise ProblemError(
                f"the cut-off ratio is {points.cut_off:.6g}; it must lie within 1..{plain(self.compression)},"
                " for the heat is supplied after the dead centre and within the stroke"
            )
        work = sum(one.work(1.0) for one in self.strokes(floats(), double=False))
        if work < LEAST_WORK:
            raise ProblemError(
                f"the {self.cycle} cycle leaves no work at ε = {plain(self.compression)}; supply more heat or"
                " lower the exhaust pressure"
            )


def _options(names: Iterable[str]) -> str:
    return " and ".join(OPTIONS[one] for one in names)


_EXAMPLES = {
    OTTO: "--peak-pressure 30",
    DIESEL: "--cut-off 2",
    DUAL: "--peak-pressure 60 --cut-off 1.5",
}
