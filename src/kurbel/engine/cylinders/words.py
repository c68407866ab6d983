"""What pages say of an engine of unlike cylinders: one line for each."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, cast

from kurbel.engine.axes import LoadWords, load_text, words_of
from kurbel.engine.captions import inner
from kurbel.exact.numerals import Label
from kurbel.motion import captions as motion
from kurbel.page.axes import angle_text
from kurbel.page.labels import unprompted
from kurbel.page.quantity import words
from kurbel.reading.amounts import amount
from kurbel.reading.notation import plain, ratio_text

if TYPE_CHECKING:
    from kurbel.engine.assembly import Assembly
    from kurbel.engine.engine import Engine
    from kurbel.engine.request import EngineRequest

WORDS = {
    "cylinder": words("Zylinder {number}: |Cylinder {number}: "),
    "stroke": words("Hub|stroke"),
    "lag": words("um {angle} hinter Zylinder {number}|{angle} behind cylinder {number}"),
    "driven": words(
        "Die Welle treibt den Kolben von Zylinder {numbers}: $T$ zählt in der Drehrichtung, Arbeit als"
        " abgegeben; dort sind das mittlere $T$ und die Arbeit negativ"
        "|The shaft drives the piston of cylinder {numbers}: $T$ counts as the crank turns, work as"
        " delivered; there the mean $T$ and the work are negative"
    ),
    "single": words("einfachwirkend|single-acting"),
    "double": words("doppeltwirkend|double-acting"),
    "count": words("{count} Zylinder|{count} cylinders"),
    "one": words("1 Zylinder|1 cylinder"),
}
NAMES = ("Otto", "Diesel")
_FORCES = words(
    "; $Q$, $r$ und $φ$ des zuerst genannten Zylinders, auf die alle Kräfte und Momente bezogen sind"
    "|; $Q$, $r$ and $φ$ of the cylinder named first, which all forces and moments are referred to"
)
_MACHINE = words("der Maschine mit {count} Zylindern|of the engine of {count} cylinders")
_SINGLE = words("der Maschine mit einem Zylinder|of the engine of one cylinder")


@dataclass(frozen=True)
class Alone:
    """A cylinder as a page of its own would know it."""

    first: Engine

    @property
    def steams(self) -> Sequence[Any]:
        return [self.first.steam]

    @property
    def words(self) -> LoadWords:
        return words_of(self.first.steam.name)

    @property
    def double(self) -> bool:
        return self.first.double


def words_of_cylinders(assembly: Assembly) -> LoadWords:
    """Return what is said of the cylinders of an engine."""
    own, count = words_of(assembly.steam.name), len(assembly.cranks)
    machine = _MACHINE if count > 1 else _SINGLE
    forces = {lang: said + _FORCES[lang] for lang, said in own.forces.items()}

    return LoadWords(
        key="cylinders",
        name=words("Zylinder|Cylinders"),
        symbol="",
        number=lambda load: Fraction(count),
        label=lambda load, lang: WORDS["count" if count > 1 else "one"][lang].format(count=count),
        machine={lang: text.format(count=count) for lang, text in machine.items()},
        several="engines",
        forces=forces,
        newtons=own.newtons,
        lines=own.lines,
        captioned=False,
        tag=lambda load: f"{count} cylinders" if count > 1 else "1 cylinder",
        pressure=own.pressure,
    )


def cylinder_notes(assembly: Assembly, numbers: Sequence[int], lang: str) -> Iterator[Label]:
    """Yield a line for each cylinder: its size, its place, its load; and which of them the shaft drives."""
    numbers = numbers or range(1, len(assembly.parts) + 1)
    numbered = [*zip(numbers, assembly.parts, strict=True)]
    for number, part in numbered:
        yield WORDS["cylinder"][lang].format(number=number) + "; ".join(_said(part, numbers[0], lang))
    driven = [str(number) for number, part in numbered if part.steam.driven]
    if 0 < len(driven) < len(numbered):
        yield WORDS["driven"][lang].format(numbers=", ".join(driven))


def masses_notes(request: EngineRequest, lang: str) -> Iterator[Label]:
    """Yield the masses, those of each cylinder with its number where they differ."""
    numbers = request.numbers or range(1, len(request.first.parts) + 1)
    every = zip(numbers, request.first.parts, strict=True)
    parts = [(number, part.crank) for number, part in every if part.crank.loaded]
    same, weightless = len({crank for _, crank in parts}) == 1, motion.WORDS["weightless"][lang]
    noted = False
    for number, crank in parts[:1] if same else parts:
        prefix = "" if same else WORDS["cylinder"][lang].format(number=number)
        for note in request.mechanism.masses_notes(crank, request.layout.ratio_symbol, lang):
            if note == weightless:
                noted = True
            else:
                yield prefix + note
    if noted:
        yield weightless


def within(line: Label, lang: str) -> Label:
    """Return a line as it is within a sentence; the names of Otto and Diesel keep their capital."""
    return line if line.startswith(NAMES) else inner(line, lang)


def _said(part: Engine, first: int, lang: str) -> Iterator[Label]:
    alone = Alone(part)
    if part.load is not None:
        yield alone.words.newtons(part.steam, part.load)
    sizes = f"$R:L = {ratio_text(part.crank.ratio)}$"
    if part.crank.radius is not None:
        sizes = f"{WORDS['stroke'][lang]} ${amount(2 * part.crank.radius, 'mm', plain)}$, {sizes}"
    yield sizes
    if part.lag:
        yield WORDS["lag"][lang].format(angle=f"${angle_text(part.lag)}$", number=first)
    if alone.words.captioned:
        yield load_text(part.steam, lang)
    lines = alone.words.lines(cast("EngineRequest", alone), lang)
    # What is assumed is said by an entry of the cylinder.
    yield from (within(unprompted(line), lang) for line in lines)
    if alone.words.halved:
        yield WORDS["double" if part.double else "single"][lang]
