"""The steam engine that a table is about, checked once: cut-off, expansion, back pressure, cranks."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import floor
from typing import TYPE_CHECKING, Any, ClassVar

from kurbel.drive.at import Weights
from kurbel.drive.crank import Crank
from kurbel.drive.load import STEAM
from kurbel.drive.load import Load as Acting
from kurbel.drive.moved import Drive
from kurbel.engine.card.card import Diagram
from kurbel.engine.loads import effort
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind
from kurbel.kernel.circle import Number
from kurbel.kernel.steam import Expansion, IdleStroke, best_back
from kurbel.kernel.turning import Stroke
from kurbel.reading.notation import about, plain, too_small

if TYPE_CHECKING:
    pass

LARGEST_EXPANSION = 10**6
LARGEST_EXPONENT = 10
LARGEST_CLEARANCE = 10
# The work of the expansion is a quotient by n - 1.
LEAST_CURVE = Fraction(1, 10**6)
# Nearer to 1 the piston of the exact motion stands still but for an instant.
LARGEST_RATIO = 1 - Fraction(1, 10**12)
MOST_CRANKS = 24
HIGHEST = 10**12
# Below this share of Q no mean force drives anything, and δ, counted in it, grows beyond all bounds.
LEAST_WORK = 1e-9


@dataclass(frozen=True, slots=True)
class Steam:
    """Expansion ratio ε (cut-off after the share 1/ε of the stroke), back pressure b = R/Q, exponent n of
    p V^n = const, clearance as a share of the stroke.

    `back` None is the best back pressure, that of the steam at the end of the stroke: 1/ε for n = 1 without
    clearance. Valid for ε >= 1, 0 <= b <= 1, n > 0, κ >= 0, as long as work is left.
    """

    name: ClassVar[str] = STEAM
    driven: ClassVar[bool] = False

    expansion: Fraction
    back: Fraction | None = None
    exponent: Fraction = Fraction(1)
    clearance: Fraction = Fraction(0)

    def strokes(self, kind: Kind, double: bool) -> tuple[Stroke, Stroke]:
        """Return the force of both strokes, on a kind of number; single-acting, the return idles."""
        acting: Stroke = self.numbers(kind.of, kind.exponent)
        return acting, acting if double else IdleStroke()

    def __post_init__(self) -> None:
        if self.expansion < 1:
            raise ProblemError(too_small(self.expansion))
        if self.expansion > LARGEST_EXPANSION:
            raise ProblemError(
                f"expansion ratio ε is {about(self.expansion)}; at most {LARGEST_EXPANSION} is allowed"
            )
        if self.back is not None and not 0 <= self.back <= 1:
            raise ProblemError(
                f"back pressure b is {about(self.back)}; it must lie within 0..1,"
                " for it is a share of the steam pressure before cut-off"
            )
        if not 0 < self.exponent <= LARGEST_EXPONENT:
            raise ProblemError(
                f"exponent n is {about(self.exponent)}; it must be above 0 and at most {LARGEST_EXPONENT},"
                " for the pressure falls as the steam expands"
            )
        if 0 < abs(self.exponent - 1) < LEAST_CURVE:
            raise ProblemError(
                f"exponent n is {about(self.exponent)}, nearer to 1 than 10^-6; write 1, Mariotte's law,"
                " whose results have the same six figures"
            )
        if not 0 <= self.clearance <= LARGEST_CLEARANCE:
            raise ProblemError(
                f"clearance is {about(self.clearance)}; it must lie within 0..{LARGEST_CLEARANCE},"
                " for it is a share of the volume swept in a stroke"
            )
        self._check_work()

    def numbers(
        self, of: Callable[[Fraction], Any], exponent_of: Callable[[Fraction], Any] | None = None
    ) -> Expansion:
        """Return the same in a kind of number, which may want its exponents in another."""
        cut_off, clearance = of(1 / self.expansion), of(self.clearance)
        exponent = (exponent_of or of)(self.exponent)
        back = best_back(cut_off, exponent, clearance) if self.back is None else of(self.back)
        return Expansion(cut_off, back, exponent, clearance)

    def _check_work(self) -> None:
        acting = self.numbers(float)
        if acting.work(1.0) > LEAST_WORK:
            return
        ratio = plain(self.expansion)
        limit = floor(1e6 * acting._replace(back=0.0).work(1.0)) / 1e6
        if self.back is None:
            raise ProblemError(
                f"expansion ratio ε = {ratio} at its best back pressure, that of the steam at the end of the"
                " stroke, leaves no work; give a lower one, for example --back 0"
            )
        raise ProblemError(
            f"back pressure b = {about(self.back)} leaves no work at ε = {ratio}; b must be below"
            f" {limit:g}, or the mean force P would not be above 0"
        )


@dataclass(frozen=True, slots=True)
class Load:
    """What makes newtons of Q: the bore in metres and the steam pressure before cut-off in pascals. An
    indicator card has its pressures itself.
    """

    bore: Fraction
    pressure: Fraction | None = None

    def __post_init__(self) -> None:
        if self.bore <= 0:
            raise ProblemError(f"the bore is {about(self.bore)} m; it must be above 0")
        if self.pressure is not None and not 0 < self.pressure <= HIGHEST:
            raise ProblemError(
                f"the pressure is {about(self.pressure)} Pa; it must be above 0 and at most 10^12 Pa"
            )


@dataclass(frozen=True, slots=True)
class Engine:
    """A crank drive under a load on its piston, double-acting or not, on one crank or several.

    `cranks` are the angles in degrees by which each crank follows the first; all have cylinders alike. A
    double-acting cylinder works on both strokes; of another the load says what its return stroke does. `lag`
    are the degrees by which the first crank follows that of an engine which this one is a part of.
    """

    drive: Drive
    steam: Acting
    double: bool = True
    cranks: tuple[Fraction, ...] = (Fraction(0),)
    load: Load | None = None
    lag: Fraction = Fraction(0)

    def __post_init__(self) -> None:
        if isinstance(self.steam, Diagram):
            object.__setattr__(self, "steam", self.steam.on(self.drive))
        self._check_load()
        if self.crank.ratio > LARGEST_RATIO:
            raise ProblemError("crank ratio R:L is nearer to 1 than 10^-12; no engine is built so")
        check_count(len(self.cranks))
        if self.crank.effort is not None:
            effort.check(self)
        if self.cranks[0] != 0:
            raise ProblemError(
                f"the first crank is at {about(self.cranks[0])}°; angles count from the first crank,"
                " write them as '0;90'"
            )

    @property
    def crank(self) -> Crank:
        """What is known of the crank."""
        return self.drive.crank

    @property
    def parts(self) -> tuple[Engine, ...]:
        """The engines whose cylinders are alike."""
        return (self,)

    @property
    def starts(self) -> tuple[Fraction, ...]:
        """The half turns by which the cranks follow the first of the whole engine."""
        return tuple((self.lag + crank) / 180 for crank in self.cranks)

    def at_speed(self, factor: Fraction) -> Engine:
        """Return the engine at so many times its speed, that of its masses."""
        crank = self.crank
        assert crank.speed is not None
        faster = replace(crank, speed=replace(crank.speed, value=crank.speed.value * factor))
        return replace(self, drive=self.drive.of(faster))

    @property
    def pressure(self) -> Fraction | None:
        """The pressure in Pa that Q is of, None where it is not known."""
        if isinstance(self.steam, Diagram):
            return Fraction(self.steam.pressure)
        return None if self.load is None else self.load.pressure

    def strokes(self, kind: Kind) -> Sequence[Stroke]:
        """Return the strokes of the load on the piston as it is, with its rods and its friction."""
        if self.crank.effort is None:
            return self.steam.strokes(kind, self.double)
        return effort.rubbed(self, kind)

    def friction(self, kind: Kind) -> Number | None:
        """Return the friction of piston and crosshead in Q, None where there is none."""
        if not self.crank.rubbed:
            return None
        return effort.friction_of(self, kind)

    def weights(self, kind: Kind) -> Weights | None:
        """Return the masses in units of Q/(R ω²), in a kind of number."""
        crank, pressure = self.crank, self.pressure
        if crank.moving is None or pressure is None:
            return None
        assert self.load is not None
        assert crank.radius is not None
        assert crank.speed is not None
        # Q = π/4 d² p; ω has the factor 2π where it counts turns.
        scale = 4 * crank.radius * crank.speed.value**2 / (self.load.bore**2 * pressure)
        turned = kind.of(4 * scale) * kind.pi if crank.speed.turns else kind.of(scale) / kind.pi
        newton = 1
        if crank.moving.slope is not None:
            newton = kind.of(4 / (self.load.bore**2 * pressure)) / kind.pi
        return crank.moving.weights(kind, turned, newton)

    def _check_load(self) -> None:
        if self.load is None:
            if self.crank.moving is not None:
                raise ProblemError(
                    "masses need the bore to be weighed against the steam; add it, for example --bore 300mm"
                )
        elif self.carded and self.load.pressure is not None:
            raise ProblemError("the indicator card has its own pressures; leave the steam pressure out")
        elif not self.carded and self.load.pressure is None:
            raise ProblemError("the bore makes newtons of the steam only with its pressure; add that")

    @property
    def carded(self) -> bool:
        """Whether the piston force comes from an indicator card."""
        return isinstance(self.steam, Diagram)

    @property
    def ideal(self) -> Steam:
        """The steam of an engine that has no indicator card."""
        assert isinstance(self.steam, Steam)
        return self.steam

    @property
    def plain(self) -> bool:
        """Whether it has one crank and is double-acting, as the book's."""
        return self.double and len(self.cranks) == 1


def check_count(cranks: int) -> None:
    """Raise ProblemError unless an engine can have so many cranks."""
    if not 1 <= cranks <= MOST_CRANKS:
        raise ProblemError(f"the engine has {cranks} cranks; 1 to {MOST_CRANKS} are allowed")
