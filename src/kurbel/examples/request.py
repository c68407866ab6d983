"""What is asked for of a worked example: which one, and with which numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import product
from math import prod

from kurbel.books.quantities import engine_turn
from kurbel.drive.crank import Crank, check_angles
from kurbel.errors import ProblemError
from kurbel.examples.source import Example, Part, example
from kurbel.linkage.beam import BeamEngine
from kurbel.page.layouts import LANGUAGES
from kurbel.page.subject import check_label
from kurbel.reading.given import choose
from kurbel.reading.notation import about

MOST = 100


@dataclass(frozen=True, kw_only=True)
class ExampleRequest:
    """What is asked for: an example, with numbers of one's own by option where they are given."""

    source: str
    number: str
    own: Mapping[str, Sequence[Fraction]]
    lang: str = "de"
    label: str = ""

    def __post_init__(self) -> None:
        choose(self.lang, LANGUAGES, "language")
        check_label(self.label)
        for name in self.own:
            if name not in self.example.takes:
                takes = ", ".join(self.example.takes)
                raise ProblemError(
                    f"example {self.source} {self.number} takes no {name} of your own; it takes {takes}"
                )
        count = prod(max(len(values), 1) for values in self.own.values())
        if count > MOST:
            raise ProblemError(f"that makes {count} examples; at most {MOST} are printed at once")
        for part in self.parts:
            _check(part.given)

    @cached_property
    def example(self) -> Example:
        return example(self.source, self.number)

    @cached_property
    def parts(self) -> tuple[Part, ...]:
        """The parts of the book, or those of one's own numbers; the book's where it has the same ones."""
        if not self.own:
            return self.example.parts
        return tuple(part for given in self._given() for part in self._parts(given))

    def _given(self) -> Iterator[dict[str, Fraction]]:
        """Yield the numbers in all combinations, the book's where there are none of one's own."""
        choices = {name: self.own.get(name) or self._known(name) for name in self.example.takes}
        names = [name for name, values in choices.items() if values]
        for values in product(*(choices[name] for name in names)):
            yield dict(zip(names, values, strict=True))

    def _known(self, name: str) -> tuple[Fraction, ...]:
        return tuple(dict.fromkeys(part.given[name] for part in self.example.parts if name in part.given))

    def _parts(self, given: Mapping[str, Fraction]) -> tuple[Part, ...]:
        """Return the parts that these numbers make: the book's own, or the way for other numbers."""
        same = tuple(part for part in self.example.parts if part.given == given)
        if same:
            return same
        if self.example.own:
            return (Part("", given, self.example.own, {}, {}),)
        return tuple(part._replace(given=given, printed={}) for part in self.example.parts)


def _check(given: Mapping[str, Fraction]) -> None:
    """Raise ProblemError for numbers that no crank may have or that the books' ways cannot take."""
    if "ratio" in given:
        Crank(given["ratio"])
        if not given["ratio"]:
            raise ProblemError("the worked examples are of a finite rod; give a ratio such as 1:5")
    if "angle" in given:
        check_angles([given["angle"]])
    if "beam" in given:
        BeamEngine(given["beam"], given["ratio"])
    if "eps" in given:
        _check_steam(given)
    if "force" in given:
        if "ratio" not in given:
            raise ProblemError("a force becomes newtons with a ratio only; add one, such as 1:5")
        Crank(given["ratio"], force=given["force"])


def _check_steam(given: Mapping[str, Fraction]) -> None:
    """Raise ProblemError where the equation of § 150 for α₂ does not hold."""
    if given["eps"] <= 1:
        raise ProblemError("the way of § 150 is for expanding steam; give an expansion ratio above 1")
    turn = engine_turn(given["ratio"], given["eps"], given.get("back"), "weisbach")
    if not turn.expands_first:
        raise ProblemError(
            f"at ε = {about(given['eps'])} the speed is greatest before the cut-off, where the equation of"
            " § 150 for α₂ does not hold; give a larger expansion ratio"
        )
