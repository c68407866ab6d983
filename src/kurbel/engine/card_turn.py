"""A turn of an engine whose piston force comes from an indicator card: in floats, with an error estimate.

What the points of a card do not say, no arithmetic knows. The same turn is therefore computed from every
second point, twice; by how far those results differ from the result of all points tells how many digits the
card supports.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from math import pi
from typing import TYPE_CHECKING, Any

from kurbel.drive.crank_forces import CrankForce, Weights
from kurbel.engine.card_force import CardStroke, card_strokes
from kurbel.engine.engine import Diagram, Engine
from kurbel.engine.quantities import Peak
from kurbel.errors import CardError, ProblemError
from kurbel.kernel import inertia, turning
from kurbel.kernel.circle import circle
from kurbel.kernel.rod import Loaded
from kurbel.motion.evaluation import OUT, RETURN

if TYPE_CHECKING:
    from kurbel.kernel.turning import Motion

# Between two samples of half a degree the excess has one zero at most, unless the card is all noise; that a
# pair of zeros is missed costs less than the interpolation, for the energy hardly changes between them.
SAMPLES = 721
# Of the excess force and its zeros; the energy there is off by the square of it.
ZERO_TOLERANCE = 1e-13
EQUAL_ENERGY = 1e-12
LEAST_FORCE = 1e-9
# Cubics gain a factor of 16 with twice the points; noise may seem to gain 8 by chance.
MOST_GAIN = 8.0
NOTHING = 1e-300
# Half turns over which a slope is taken.
BESIDE = 1e-3


class CardTurn:
    """One turn by a method: exact or series kinematics."""

    pi = pi

    def __init__(self, engine: Engine, method: str, unit: float | None = None) -> None:
        if method == "weisbach":
            raise ProblemError(
                'method "weisbach" has no equations for an indicator card; use exact or series'
            )
        assert isinstance(engine.steam, Diagram)
        self.engine = engine
        self.diagram = engine.steam
        self.unit = self.diagram.card.admission if unit is None else unit
        self.method = method
        self.motion: Motion = turning.EXACT if method == "exact" else turning.FIRST_ORDER
        # Half a card, in the unit of the whole, may well do no work.
        if unit is None and self.mean < LEAST_FORCE:
            raise CardError(
                f"{self.diagram.card.name} does no work: the mean tangential force is {self.mean:.3g} Q,"
                " and it must be above 0; p_forward drives the piston, p_return resists it"
            )

    @cached_property
    def coarser(self) -> tuple[CardTurn, ...]:
        """The turns of the two cards that have every second point of this one's, in the same Q."""
        diagrams = [Diagram(card, self.diagram.other_side) for card in self.diagram.card.halves()]
        return tuple(
            CardTurn(replace(self.engine, steam=diagram), self.method, self.unit) for diagram in diagrams
        )

    @cached_property
    def gain(self) -> float:
        """How many times nearer to the truth twice the points have come; 1 for noise."""
        before = max(half.work_apart for half in self.coarser)
        return min(max(before / (self.work_apart + NOTHING), 1.0), MOST_GAIN)

    @cached_property
    def work_apart(self) -> float:
        """The greatest difference of work from the coarser cards', at any share of the strokes, in 2 Q R."""
        import numpy as np

        shares = np.linspace(0, 1, SAMPLES)
        return max(
            float(abs(own.work(shares) - other.work(shares)).max())
            for half in self.coarser
            for own, other in zip(self.strokes, half.strokes, strict=True)
        )

    @cached_property
    def force_apart(self) -> float:
        """The mean difference of force from the coarser cards', and the step of the pressures, in Q."""
        import numpy as np

        shares = np.linspace(0, 1, SAMPLES)
        differences = [
            own.force(shares) - other.force(shares)
            for half in self.coarser
            for own, other in zip(self.strokes, half.strokes, strict=True)
        ]
        return float(np.sqrt(np.mean(np.square(differences)))) + self.step

    @property
    def step(self) -> float:
        """The last place of the pressures as written, in Q."""
        return self.diagram.card.resolution / self.unit

    def place_error(self, greatest: bool, stroke: int | None) -> float:
        """How far the place of an extreme may be off, in half turns.

        Where the tangential force passes its mean at a small angle, little of it moves the place far.
        """
        place = self.extreme(greatest, stroke).place + (stroke or 0)
        slope = (self.excess(place + BESIDE) - self.excess(place - BESIDE)) / (2 * BESIDE)
        halves = (half.extreme(greatest, stroke).place + (stroke or 0) for half in self.coarser)
        apart = max(abs(place - half) for half in halves)
        return float(max(apart, 2 * self.force_apart / (abs(slope) + NOTHING)))

    @cached_property
    def strokes(self) -> tuple[CardStroke, CardStroke]:
        return card_strokes(self.diagram.card, self.engine.double, self.diagram.other_side, self.unit)

    @cached_property
    def mean(self) -> float:
        """The mean tangential force of one crank."""
        return float(turning.mean_force(self.strokes, pi))

    def of(self, value: Fraction) -> float:
        return float(value)

    def mean_force(self) -> float:
        """P/Q, the mean tangential force of all cranks together."""
        return self.mean * len(self.engine.cranks)

    def tangential_force(self, half_turns: Fraction | float) -> float:
        """The tangential force T/Q of all cranks."""
        return self.excess(half_turns) + self.mean_force()

    def excess(self, half_turns: Fraction | float) -> float:
        total = 0.0
        for stroke, angle in self._cranks(half_turns):
            total += float(self._tangential(stroke, angle)) - self.mean
        return total

    def _tangential(self, stroke: int, angle: Any) -> Any:
        """The tangential force of one crank, at half turns or an array of them since its dead centre."""
        ratio = float(self.engine.crank.ratio) * (RETURN if stroke else OUT)
        at = circle(180.0 * angle)
        steam = turning.tangential_force(self.strokes[stroke], self.motion, at, ratio)
        return steam if self.weights is None else steam + Loaded(at, ratio, self.weights.masses).torque()

    @cached_property
    def weights(self) -> Weights | None:
        """The moving masses in units of Q/(R ω²)."""
        return self.engine.weights(float, pi, Fraction(self.unit))

    def force_unit(self) -> float:
        """The force Q in newtons, of the greatest pressure of the card."""
        assert self.engine.load is not None
        return self.unit * float(self.engine.load.bore) ** 2 / 4 * pi

    def radius(self) -> float:
        """The crank radius in metres."""
        assert self.engine.crank.radius is not None
        return float(self.engine.crank.radius)

    def _excesses(self, places: Any) -> Any:
        """The excess at an array of half turns."""
        import numpy as np

        total = np.full(len(places), -self.mean_force())
        for start in self.engine.cranks:
            since = (places - float(start / 180)) % 2
            back = since >= 1
            total += np.where(back, self._tangential(1, since - 1.0), self._tangential(0, since))
        return total

    def crank_force(self, force: CrankForce, half_turns: Fraction) -> float:
        """A force of the first crank in Q."""
        stroke, angle = next(self._cranks(half_turns))
        at, ratio = circle(180.0 * angle), float(self.engine.crank.ratio) * (RETURN if stroke else OUT)
        net = self.strokes[stroke].force(self.motion.path(at, ratio) / 2)
        sign = (RETURN if stroke else OUT) if force.framed else 1
        return float(force.of(at, ratio, self.weights, net)) * sign

    def crank_force_error(self, force: CrankForce, half_turns: Fraction) -> float:
        """How far such a force may be off, in Q: as far as the net pressure there, by the rod's slant."""
        stroke, angle = next(self._cranks(half_turns))
        at, ratio = circle(180.0 * angle), float(self.engine.crank.ratio) * (RETURN if stroke else OUT)
        share = self.motion.path(at, ratio) / 2
        own = self.strokes[stroke].force(share)
        apart = max(abs(float(own - half.strokes[stroke].force(share))) for half in self.coarser)
        return max(apart, self.force_apart) * abs(float(force.bare(at, ratio, None)))

    def energy_at(self, half_turns: Fraction | float) -> float:
        """The excess work W/(Q R) since the first crank's inner dead centre."""
        return self._energy(half_turns) - self._energy(0.0)

    def _energy(self, half_turns: Fraction | float) -> float:
        total = 0.0
        for stroke, angle in self._cranks(half_turns):
            ratio = float(self.engine.crank.ratio) * (RETURN if stroke else OUT)
            before = 2 * self.strokes[0].work(1.0) if stroke else 0.0
            work = turning.work_done(self.strokes[stroke], self.motion, circle(180.0 * angle), ratio)
            total += before + work - self.mean * (angle + stroke) * pi
            if self.weights is not None:
                total -= inertia.kinetic_energy(circle(180.0 * angle), ratio, self.weights.masses)
        return float(total)

    def _cranks(self, half_turns: Fraction | float) -> Iterator[tuple[int, float]]:
        """Each crank's stroke, and the half turns since that began."""
        for stroke, since in self.engine.positions(Fraction(half_turns)):
            yield stroke, float(since)

    @cached_property
    def extrema(self) -> tuple[Peak, ...]:
        """Every place at which the speed is least or greatest over the turn, in order."""
        import numpy as np
        from scipy.optimize import brentq

        places = sorted({2 * index / (SAMPLES - 1) for index in range(SAMPLES)} | set(self._dead_centres()))
        forces = self._excesses(np.array(places)).tolist()
        samples = zip(places, forces, strict=True)
        zeros = [
            brentq(self.excess, low, high, xtol=ZERO_TOLERANCE)
            for (low, before), (high, after) in pairwise(samples)
            if before * after < 0
        ]
        zeros += [place for place, force in zip(places, forces, strict=True) if force == 0]
        return tuple(Peak(zero, self.energy_at(zero)) for zero in sorted(zeros))

    def _dead_centres(self) -> Iterator[float]:
        for start in self.engine.cranks:
            yield from (float(start / 180 % 2), float((start / 180 + 1) % 2))

    def extreme(self, greatest: bool, stroke: int | None = None) -> Peak:
        """Return where in the turn, or in a stroke of the one crank, the speed is least or greatest."""
        first = self._extremes(greatest, stroke)[0]
        return Peak(first.place - (stroke or 0), first.energy)

    def _extremes(self, greatest: bool, stroke: int | None) -> list[Peak]:
        """The extremes of a span, several where theirs cannot be told apart, as with an infinite rod."""
        within = [peak for peak in self.extrema if stroke is None or int(peak.place) == stroke]
        if not within:
            raise CardError(
                f"{self.diagram.card.name}: the tangential force passes its mean in a peak too narrow to be"
                " followed; give a card without it"
            )
        energies = [peak.energy for peak in within]
        chosen = max(energies) if greatest else min(energies)
        return [peak for peak in within if abs(peak.energy - chosen) < EQUAL_ENERGY]

    def extreme_strokes(self, greatest: bool) -> frozenset[int]:
        """Return the stroke of the one crank in which the turn's least or greatest speed lies."""
        return frozenset(int(peak.place) for peak in self._extremes(greatest, None))

    def irregularity(self) -> float:
        """Return δ in units of P R/(m₁ v₁²)."""
        return float(self.extreme(True).energy - self.extreme(False).energy) / self.mean_force()
