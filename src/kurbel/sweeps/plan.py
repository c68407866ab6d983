"""What a sweep is: a command, the options that are the same everywhere, and the axes of those that vary."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import prod
from typing import Any, NamedTuple

# More rows than these nobody waits for.
MOST_ROWS = 10**12


class Axis(NamedTuple):
    """An option that varies, by its name, and its values as the command takes them, one at a time.

    `values` may be any sequence that is never written out, such as a `Progression`; they are exact.
    """

    option: str
    values: Sequence[Any]


@dataclass(frozen=True)
class Plan:
    """A sweep as it was asked for.

    `command` is the place of the function, "kurbel.commands.engine:delta_table", and `given` are the values
    of its options by their names, without those that vary. The axes of a group are linked: they go through
    their values together. The rows are the product of the groups, of which the last varies fastest. `digits`
    asks for certified decimals in place of floats, `bounds` for a column beside each of floats that says how
    far from the true value they may lie.
    """

    command: str
    given: Mapping[str, Any]
    groups: tuple[tuple[Axis, ...], ...]
    digits: int | None = None
    bounds: bool = False

    @property
    def sizes(self) -> tuple[int, ...]:
        """How many places each group has."""
        return tuple(len(group[0].values) for group in self.groups)

    def __len__(self) -> int:
        return prod(self.sizes)

    def at(self, point: int) -> dict[str, Any]:
        """Return the values of the options that vary, at a point."""
        found: dict[str, Any] = {}
        for group, size in zip(reversed(self.groups), reversed(self.sizes), strict=True):
            point, place = divmod(point, size)
            found |= {axis.option: axis.values[place] for axis in group}
        return found
