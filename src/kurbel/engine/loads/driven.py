"""What the shaft drives: the compressor, or blowing engine, and the piston pump.

A compressor sucks air, compresses it and pushes it out; a pump has a constant resistance on each stroke, by
what acts on the faces of its piston.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from math import floor
from typing import ClassVar, NamedTuple

from kurbel.drive.load import COMPRESSOR, PUMP
from kurbel.engine.loads.ideal import LEAST_WORK, check_clearance, check_exponent
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind, floats
from kurbel.kernel.circle import Numeric
from kurbel.kernel.law import Constant, Law, Piece, Polytrope, Stroke
from kurbel.kernel.steam import expansion_work, logarithm, power
from kurbel.reading.given import choose
from kurbel.reading.notation import about, check_bounds, plain

# A share of the stroke that is left for delivery, below which there is none.
LEAST_DELIVERY = 1e-9
DOUBLE, SINGLE, DIFFERENTIAL = KINDS = ("double", "single", "differential")
# Beyond this multiple of the pressure that the pump makes there is no suction head nor feed.
LARGEST_HEAD = 10**6
LARGEST_RATIO = 10**6
LARGEST_LOSS = 10
# The adiabatic exponent of air.
AIR = Fraction(7, 5)


class _Ends(NamedTuple):
    """The pressures in the cylinder in units of the suction pressure, on a kind of number."""

    suction: Numeric
    delivery: Numeric
    exponent: Numeric
    clearance: Numeric
    # The volume at suction pressure of what has one volume at delivery pressure, of what is compressed
    growth: Numeric
    # and, with an exponent of its own, of what is left.
    regrowth: Numeric
    left_exponent: Numeric
    # Whether there is a clearance, in which something of the delivery is left.
    kept: bool

    def sucked(self) -> Numeric:
        """Return the share of the stroke on which air is sucked."""
        return 1 + self.clearance * (1 - self.regrowth)

    def leaving(self) -> Piece | Law:
        """Return the pressure in the end that the piston leaves: what is left expands, then air is sucked."""
        suction = Constant(self.suction)
        if not self.kept:
            return suction
        expanding = Polytrope(self.delivery, self.clearance, self.left_exponent, self.clearance, 1)
        return Law((expanding, suction), (self.clearance * (self.regrowth - 1),))

    def coming(self) -> Law:
        """Return the pressure in the other end: the air is compressed, then pushed out."""
        whole = 1 + self.clearance
        compressed = Polytrope(self.suction, whole, self.exponent, whole, -1)
        return Law((compressed, Constant(self.delivery)), (whole * (1 - 1 / self.growth),))


@dataclass(frozen=True, slots=True)
class Compressor:
    """Pressure ratio Π = p₂/p₁, exponent n of p V^n = const, clearance as a share of the stroke's volume; the
    air that is left in it expands by `expansion_exponent` where that is given.

    The losses of the valves are shares of the pressures outside: in the cylinder it is p₁ (1 - ζ_s) at
    suction, p₂ (1 + ζ_d) at delivery. Q is p₁ times the piston's area. A single-acting piston has
    `other_side` p₁ on its other face, by default p₁ itself. Of several `stages` the intermediate pressures
    are those with which each raises the pressure by the root of Π, or of two is `between` in p₁; between them
    the air is `cooled` to so many times its first temperature. The strokes are those of the first stage.
    With 1, perfect intercooling, these pressures are the best. Valid for Π > 1, n > 0, as long as something
    is delivered. Derived by us from p V^n = const; the volumetric
    efficiency is the textbook's.
    """

    name: ClassVar[str] = COMPRESSOR
    driven: ClassVar[bool] = True

    ratio: Fraction
    exponent: Fraction = Fraction(1)
    clearance: Fraction = Fraction(0)
    suction_loss: Fraction = Fraction(0)
    delivery_loss: Fraction = Fraction(0)
    other_side: Fraction = Fraction(1)
    stages: int = 1
    cooled: Fraction = Fraction(1)
    between: Fraction | None = None
    expansion_exponent: Fraction | None = None
    later_clearance: Fraction | None = None

    def __post_init__(self) -> None:
        check_bounds(
            "pressure ratio Π", self.ratio, "be above 1, for it is the delivery pressure in suction pressures"
        )
        if self.ratio > LARGEST_RATIO:
            raise ProblemError(f"pressure ratio Π is {about(self.ratio)}; at most {LARGEST_RATIO} is allowed")
        check_exponent(self.exponent, "exponent n")
        check_clearance(self.clearance)
        if self.expansion_exponent is not None:
            self._check_expansion(self.expansion_exponent)
        if self.later_clearance is not None:
            check_clearance(self.later_clearance)
        if self.between is not None and not 1 < self.between < self.ratio:
            raise ProblemError(
                f"the intermediate pressure is {about(self.between)} times the suction pressure; it must be"
                f" above 1 and below Π = {plain(self.ratio)}"
            )
        check_bounds(
            "suction loss", self.suction_loss,
            "be 0 or more and below 1, for it is the share of the suction pressure that is lost in the "
            "valve",
        )  # fmt: skip
        check_bounds(
            "delivery loss", self.delivery_loss,
            f"lie within 0..{LARGEST_LOSS}, for it is the share of the delivery pressure by which the "
            "valve raises it",
        )  # fmt: skip
        self._check_delivery()
        if self.stages > 1:
            self._check_later()

    def _check_expansion(self, exponent: Fraction) -> None:
        check_exponent(exponent, "exponent of the expansion")
        if not self.clearance:
            raise ProblemError("--expansion-exponent is of the air left in the clearance; add --clearance 5%")
        if self.stages > 1:
            raise ProblemError(
                f"--expansion-exponent is computed for one stage, and {self.stages} were given; leave it out"
            )

    def strokes(self, kind: Kind, double: bool) -> tuple[Stroke, Stroke]:
        """Return both strokes; single-acting, air is sucked on the outstroke and compressed on the return."""
        ends = self._ends(kind)
        if double:
            both = Stroke(ends.leaving(), ends.coming())
            return both, both
        other = Constant(kind.of(self.other_side))
        return Stroke(ends.leaving(), other), Stroke(other, ends.coming())

    def volumetric_efficiency(self, kind: Kind, **found: Numeric) -> Numeric:
        """Return the share of the stroke on which air is sucked: 1 + κ - κ Π'^(1/n), Π' in the cylinder and n
        that of the expansion."""
        return self._ends(kind, **found).sucked()

    def delivered(self, kind: Kind, **found: Numeric) -> Numeric:
        """Return the volume that a stroke delivers, as a share of the swept one, at p₁ and the temperature
        of the air that is sucked, with `found` numbers in the place of ratio or clearance."""
        return self.volumetric_efficiency(kind, **found) * kind.of(1 - self.suction_loss)

    def mean(self, kind: Kind, **found: Numeric) -> Numeric:
        """Return the mean pressure that a stroke takes: η_v n/(n - 1) (Π'^((n - 1)/n) - 1), in the cylinder's
        suction pressure, of all stages on the piston of the first; with `found` numbers in the place of ratio
        or clearance. Of two exponents it is what the compression takes less what the expansion gives."""
        ends = self._ends(kind, **found)
        if self.expansion_exponent is not None:
            taken = (1 + ends.clearance) * ends.exponent * self._of_stages(kind, **found)
            given = ends.left_exponent * expansion_work(1 / ends.regrowth, ends.left_exponent)
            return ends.suction * (ends.clearance * ends.regrowth * given - taken)
        return -ends.suction * ends.sucked() * ends.exponent * self._of_stages(kind, **found)

    def _of_stages(self, kind: Kind, **found: Numeric) -> Numeric:
        """Return the work of all stages on what has the volume 1 at the first, without its exponent."""
        ends = self._ends(kind, **found)
        first = expansion_work(1 / ends.growth, ends.exponent)
        if self.stages == 1:
            return first
        later = expansion_work(1 / self._later(kind, **found), ends.exponent)
        return first + kind.of((self.stages - 1) * self.cooled) * later

    def _later(self, kind: Kind, **found: Numeric) -> Numeric:
        """Return how much larger the volume is at which a later stage sucks than that which it delivers."""
        ends = self._ends(kind, **found)
        if self.between is None:
            return ends.growth
        whole = found.get("ratio", kind.of(self.ratio)) * kind.of(self._inside)
        return power(whole / kind.of(self.between), kind.exponent(1 / self.exponent))

    def against_one_stage(self, kind: Kind, **found: Numeric) -> Numeric:
        """Return the work of all stages in that of one, on the same air."""
        whole = found.get("ratio", kind.of(self.ratio)) * kind.of(self._inside)
        exponent = kind.exponent(self.exponent)
        grown = power(whole, kind.exponent(1 / self.exponent))
        return self._of_stages(kind, **found) / expansion_work(1 / grown, exponent)

    def against_perfect(self, kind: Kind, **found: Numeric) -> Numeric:
        """Return the same in that with perfect intercooling at the best pressures."""
        return self._of_stages(kind, **found) / self._best()._of_stages(kind, **found)

    def perfect_against_one(self, kind: Kind, **found: Numeric) -> Numeric:
        """Return the work with perfect intercooling at the best pressures in that of one stage."""
        return self._best().against_one_stage(kind, **found)

    def _best(self) -> Compressor:
        return replace(self, cooled=Fraction(1), between=None)

    def later_area(self, kind: Kind, **found: Numeric) -> Numeric:
        """Return the area of the second stage's piston in that of the first, by what each sucks."""
        ends, later = self._ends(kind, **found), self._later(kind, **found)
        room = ends.clearance if self.later_clearance is None else kind.of(self.later_clearance)
        own = self.between is not None or self.later_clearance is not None
        sucks = ends.sucked() / (1 + room * (1 - later)) if own else 1
        return kind.of(self.cooled) * sucks / self.stage_ratio(kind, **found)

    def filled(self, kind: Kind, **found: Numeric) -> Numeric:
        """Return the volume of a cylinder with its clearance, in the swept one."""
        return 1 + self._ends(kind, **found).clearance

    def later_filled(self, kind: Kind, **found: Numeric) -> Numeric:
        """Return the same of the second stage."""
        return (
            self.filled(kind, **found) if self.later_clearance is None else kind.of(1 + self.later_clearance)
        )

    @property
    def _inside(self) -> Fraction:
        """How many times the pressures in the cylinder are farther apart than outside."""
        return (1 + self.delivery_loss) / (1 - self.suction_loss)

    def isothermal(self, kind: Kind, **found: Numeric) -> Numeric:
        """Return the work at the temperature of suction on what a stroke delivers, over p₁ and the volume
        that it sweeps: v ln Π."""
        ratio = found.get("ratio", kind.of(self.ratio))
        return self.delivered(kind, **found) * logarithm(ratio)

    def adiabatic(self, kind: Kind, **found: Numeric) -> Numeric:
        """Return the same without heat, in one stage: v γ/(γ - 1) (Π^((γ - 1)/γ) - 1) with γ = 1.4 of air."""
        ratio, part = found.get("ratio", kind.of(self.ratio)), 1 - 1 / AIR
        return self.delivered(kind, **found) * (ratio ** kind.exponent(part) - 1) / kind.of(part)

    def stage_ratio(self, kind: Kind, **found: Numeric) -> Numeric:
        """Return by how many times the first stage raises the pressure."""
        if self.between is not None:
            return kind.of(self.between)
        ratio = found.get("ratio", kind.of(self.ratio))
        return power(ratio, kind.exponent(Fraction(1, self.stages)))

    def heated(self, kind: Kind, **found: Numeric) -> Numeric:
        """Return the temperature at the end of the compression, of the last stage, in that of suction."""
        raised, exponent = self.stage_ratio(kind, **found), kind.exponent(1 - 1 / self.exponent)
        if self.between is not None:
            raised = found.get("ratio", kind.of(self.ratio)) / raised
        hot = power(raised * kind.of(self._inside), exponent)
        return hot if self.cooled == 1 else kind.of(self.cooled) * hot

    def delivered_hot(self, kind: Kind, **found: Numeric) -> Numeric:
        """Return the volume of what a stroke delivers behind the compression, in the swept one."""
        ratio = found.get("ratio", kind.of(self.ratio))
        return self.delivered(kind, **found) * self.heated(kind, **found) / ratio

    def compression_heat(self, kind: Kind, **found: Numeric) -> Numeric:
        """Return the heat that the first stage gives off as it compresses, over p₁ and the swept volume.

        The work less c_p (T₂ - T₁), c_p = γ/(γ - 1) R: v (n/(n - 1) - γ/(γ - 1)) (T₂/T₁ - 1). Above 0 for
        1 < n < γ.
        """
        share = 1 / (1 - 1 / self.exponent) - 1 / (1 - 1 / AIR)
        return self.delivered(kind, **found) * kind.of(share) * (self._first_heat(kind, **found) - 1)

    def cooler_heat(self, kind: Kind, **found: Numeric) -> Numeric:
        """Return the heat that the cooler behind the first stage takes, likewise."""
        left = self._first_heat(kind, **found) - kind.of(self.cooled)
        return self.delivered(kind, **found) * kind.of(1 / (1 - 1 / AIR)) * left

    def _first_heat(self, kind: Kind, **found: Numeric) -> Numeric:
        raised = self.stage_ratio(kind, **found) * kind.of(self._inside)
        return power(raised, kind.exponent(1 - 1 / self.exponent))

    def _ends(self, kind: Kind, ratio: Numeric | None = None, clearance: Numeric | None = None) -> _Ends:
        inside = 1 - self.suction_loss, self.ratio * (1 + self.delivery_loss)
        if self.stages > 1:
            ratio = self.stage_ratio(kind, **({} if ratio is None else {"ratio": ratio}))
        raised, delivery = kind.of(inside[1] / inside[0]), kind.of(inside[1])
        if ratio is not None:
            raised, delivery = (
                ratio * kind.of(one / self.ratio) for one in (inside[1] / inside[0], inside[1])
            )
        growth = power(raised, kind.exponent(1 / self.exponent))
        left = self.expansion_exponent or self.exponent
        regrowth = growth if left == self.exponent else power(raised, kind.exponent(1 / left))
        exponent, room = kind.exponent(self.exponent), kind.of(self.clearance)
        kept = self.clearance > 0 or clearance is not None
        room = room if clearance is None else clearance
        again = regrowth, kind.exponent(left)
        return _Ends(kind.of(inside[0]), delivery, exponent, room, growth, *again, kept)

    def _check_delivery(self) -> None:
        growth = float(self._ends(floats()).regrowth)
        if 1 - float(self.clearance) * (growth - 1) < LEAST_DELIVERY:
            least, most = 1 / (growth - 1), self._largest_ratio()
            raise ProblemError(
                f"clearance {about(self.clearance)} leaves nothing to deliver at Π = {plain(self.ratio)}: the"
                f" air left in it fills the whole stroke again; it must be below {_down(least)}, or Π below"
                f" {_down(most)}"
            )
        if -self.strokes(floats(), True)[0].work(1.0) < LEAST_WORK:
            raise ProblemError(
                f"pressure ratio Π = {about(self.ratio)} leaves no work; it must be farther above 1"
            )

    def _check_later(self) -> None:
        """Raise ProblemError for a later stage that its clearance fills again."""
        room = self.clearance if self.later_clearance is None else self.later_clearance
        growth = float(self._later(floats()))
        if 1 - float(room) * (growth - 1) < LEAST_DELIVERY:
            raise ProblemError(
                f"clearance {about(room)} leaves the second stage nothing to deliver; it must be below"
                f" {_down(1 / (growth - 1))}"
            )

    def _largest_ratio(self) -> float:
        """The pressure ratio at which this clearance delivers nothing any more."""
        inside: float = float(1 + 1 / self.clearance) ** float(self.expansion_exponent or self.exponent)
        return (inside * float((1 - self.suction_loss) / (1 + self.delivery_loss))) ** self.stages


def _down(bound: float) -> str:
    """Return a bound to six decimals, rounded down, or to its first figures."""
    return f"{floor(1e6 * bound) / 1e6:g}" if bound > 1e-4 else f"{bound:.3g}"


@dataclass(frozen=True, slots=True)
class Pump:
    """A pump of a kind: double-acting, single-acting or differential, with a stepped piston.

    Q is the delivery pressure less the suction pressure, times the piston's area; pressures are in units of
    that difference, above that on the other face. `suction` is the suction pressure: below 0 the water
    is lifted, above 0 it is fed. The differential pump has on its other side a ring, `small_area` of the
    piston's area, in a chamber that is open to the delivery: it takes part of what the piston delivers, and
    delivers it on the outstroke. With ½ both strokes deliver alike. Derived by us.
    """

    name: ClassVar[str] = PUMP
    driven: ClassVar[bool] = True

    kind: str = DOUBLE
    suction: Fraction = Fraction(0)
    small_area: Fraction = Fraction(1, 2)

    def __post_init__(self) -> None:
        choose(self.kind, KINDS, "pump")
        check_bounds(
            "the small area", self.small_area,
            "be above 0 and below 1, for it is a share of the piston's area",
        )  # fmt: skip
        if abs(self.suction) > LARGEST_HEAD:
            raise ProblemError(
                f"the suction pressure is {about(self.suction)} times what the pump makes, the delivery"
                f" pressure less it; at most {LARGEST_HEAD} times is allowed"
            )

    def delivered(self, kind: Kind) -> Numeric:
        """Return the volume that a stroke of the piston delivers, as a share of the swept one: all of it."""
        return kind.of(Fraction(1))

    @property
    def double(self) -> bool:
        """Whether both strokes do the same."""
        return self.kind == DOUBLE

    @property
    def differential(self) -> bool:
        """Whether its other side is a ring."""
        return self.kind == DIFFERENTIAL

    def strokes(self, kind: Kind, double: bool) -> tuple[Stroke, Stroke]:
        """Return both strokes; but for the double-acting pump the outstroke sucks, the return delivers."""
        filling, other = Constant(kind.of(self.suction)), Constant(kind.of(Fraction(0)))
        emptying = Constant(kind.of(self.suction + 1))
        if self.double:
            return Stroke(filling, emptying), Stroke(filling, emptying)
        if self.differential:
            # The ring has the delivery pressure on both strokes.
            other = Constant(kind.of(self.small_area * (self.suction + 1)))
        return Stroke(filling, other), Stroke(other, emptying)
