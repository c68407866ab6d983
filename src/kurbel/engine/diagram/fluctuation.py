"""How the energy of a machine varies over a cycle in steady state, wherever that is known from.

Torques count as the shaft turns: the torque that drives it less that of the load is the excess torque, and
its integral over the angle the excess energy, which is greatest where the speed is. Energies are in J,
torques in N m.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any, NamedTuple, Protocol

from kurbel.exact.kind import Kind


class Extreme(NamedTuple):
    """Where the speed is greatest or least: the letter of a point of a diagram, or the crank angle.

    `degrees` gives it on a kind of number, None where a letter is all that is known; `exact` is the angle
    where it is a rational number of degrees.
    """

    letter: str = ""
    degrees: Callable[[Kind], Any] | None = None
    exact: Fraction | None = None


class Fluctuation(Protocol):
    """The excess energy over a cycle: its swing from the least to the greatest, and what is known beside it.

    Numbers are of the kind that is asked for.
    """

    @property
    def turns(self) -> Fraction | None:
        """The turns of a cycle; None where they are not known."""

    def swing(self, kind: Kind) -> Any:
        """Return the greatest excess energy less the least, in J."""

    def mean_torque(self, kind: Kind) -> Any | None:
        """Return the mean torque that drives the shaft in N m, None where it is not known."""

    def work(self, kind: Kind) -> Any | None:
        """Return the work of a cycle in J, of the mean torque over its turns; None where it is not known."""

    def extremes(self, *, greatest: bool) -> tuple[Extreme, ...]:
        """Return where the speed is greatest, or least: several places only where it is so at all of them."""


def work_of(mean: Any, turns: Fraction, kind: Kind) -> Any:
    """Return the work in J of a mean torque in N m over so many turns."""
    return mean * kind.of(2 * turns) * kind.pi
