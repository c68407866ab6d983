"""Random and Sobol designs: combinations between the ends of ranges, which can be typed again."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import floor, log10
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kurbel.commands.options import Option
from kurbel.commands.steps.several import figures, parted, several
from kurbel.errors import NotationError, ProblemError
from kurbel.reading import notation
from kurbel.reading.given import meant
from kurbel.sweeps.plan import Axis

KINDS = ("random", "sobol", "halton", "lhs")
MOST_POINTS = 10**6
# So many steps between the ends of a range: a value has about six figures.
STEPS = 6
_RANGE = re.compile(r"(1\s*[:/∶])?(.+?)\.\.(?:1\s*[:/∶](?=.))?([^:]+)(:.+)?")


@dataclass(frozen=True)
class Design:
    """How points are chosen: of which kind, how many, and by which seed."""

    kind: str
    size: int
    seed: int

    def __str__(self) -> str:
        return f"{self.kind}:{self.size}, seed {self.seed}"

    @classmethod
    def read(cls, text: str, seed: int) -> Design:
        """Return the design of a text such as sobol:1024. Raises KurbelError."""
        name, _, count = text.partition(":")
        kind = meant(name.strip(), KINDS, "design")
        size = int(count) if re.fullmatch(r"[0-9]{1,9}", count.strip()) else 0
        if not 1 <= size <= MOST_POINTS:
            raise NotationError(
                f'design "{text[:40]}" does not say how many points; write a number from 1 to 10^6 behind a'
                f" colon: {kind}:1024"
            )
        if kind == "sobol" and size & (size - 1):
            below = 1 << (size.bit_length() - 1)
            raise ProblemError(
                f"a Sobol design of {size} points is out of balance; take a power of two, {below} or"
                f" {2 * below}"
            )
        return cls(kind, size, seed)

    def unit(self, dimensions: int) -> NDArray[np.float64]:
        """Return the points in the unit cube, a row each."""
        if self.kind == "random":
            return np.random.default_rng(self.seed).random((self.size, dimensions))
        from scipy.stats import qmc

        makers = {"sobol": qmc.Sobol, "halton": qmc.Halton, "lhs": qmc.LatinHypercube}
        found: NDArray[np.float64] = makers[self.kind](dimensions, seed=self.seed).random(self.size)
        return found


class _Range(NamedTuple):
    """The ends between which values lie, to so many decimals; of rods they are the lengths L/R."""

    first: Fraction
    last: Fraction
    unit: str
    rods: bool

    def at(self, share: float) -> Any:
        decimals = self._decimals
        value = Fraction(round((self.first + (self.last - self.first) * Fraction(share)) * 10**decimals))
        value = min(max(value / 10**decimals, self.first), self.last)
        return 1 / value if self.rods else f"{figures(value)}{self.unit}"

    @property
    def _decimals(self) -> int:
        return max(0, STEPS - floor(log10(self.last - self.first)))


def sampled(design: Design, options: Mapping[str, tuple[Option[Any], Any]]) -> tuple[Axis, ...]:
    """Return linked axes with the values of a design: between the ends of ranges, and of lists any."""
    spaces = {name: _space(one, given) for name, (one, given) in options.items()}
    points = design.unit(len(spaces)).T
    return tuple(
        Axis(name, tuple(_value(space, share) for share in shares.tolist()))
        for (name, space), shares in zip(spaces.items(), points, strict=True)
    )


def is_varied(parameter: Option[Any], given: Any) -> bool:
    """Whether an option has several values, or a range without a step."""
    texts = given if isinstance(given, list | tuple) else [given]
    if parameter.whole:
        return len(texts) > 1 and not parameter.many
    return len(texts) > 1 or (isinstance(texts[0], str) and (";" in texts[0] or ".." in texts[0]))


def _space(parameter: Option[Any], given: Any) -> _Range | Sequence[Any]:
    texts = given if isinstance(given, list | tuple) else [given]
    one = texts[0]
    if len(texts) > 1 or not isinstance(one, str) or ";" in one or parameter.whole:
        return several(parameter, texts)
    name = parameter.name
    match = _RANGE.fullmatch(one.strip())
    if match is None:
        raise NotationError(f"{name} {notation.quoted(one)} is not a range; write it as 2..6")
    rods, first, last, step = match.groups()
    if step:
        raise ProblemError(
            f"--{name.replace('_', '-')} {one} has a step, and a sample takes any value between the ends;"
            f" write {one.removesuffix(step)}"
        )
    if parameter.unit == "degrees":
        ends, unit = [notation.angle(first), notation.angle(last)], ""
    else:
        parts = [parted(first), parted(last)]
        units = dict.fromkeys(unit for _, unit in parts if unit)
        if len(units) > 1:
            raise NotationError(f"{name} {notation.quoted(one)} has two units; give both ends in one")
        ends, unit = [notation.number(shown, name) for shown, _ in parts], next(iter(units), "")
    if not ends[0] < ends[1]:
        raise NotationError(f"{name} {notation.quoted(one)} has its end before its start")
    if rods and ends[0] <= 0:
        raise NotationError(f"crank ratio {notation.quoted(one)} contains 1:0; the rod must have a length")
    return _Range(ends[0], ends[1], unit, bool(rods))


def _value(space: _Range | Sequence[Any], share: float) -> Any:
    return space.at(share) if isinstance(space, _Range) else space[int(share * len(space))]
