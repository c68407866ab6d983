"""What captions say of engines, and pages of an engine with unlike cylinders: one line for each of these."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from kurbel.engine.engine import Assembly, Engine
from kurbel.engine.engine_quantities import ENGINE_METHODS, OF_RUNS
from kurbel.engine.loads.words import lettered, load_text, words_of
from kurbel.engine.request import EngineRequest
from kurbel.exact.numerals import Label
from kurbel.motion import notes as motion
from kurbel.page.axes import angle_text
from kurbel.page.labels import unprompted
from kurbel.page.quantity import AND, FOR, Texts, filled, words
from kurbel.reading.amounts import amount
from kurbel.reading.notation import plain, ratio_text

if TYPE_CHECKING:
    from kurbel.engine.power.power_page import PowerRequest

CYLINDERS = Texts("engine", "cylinders")

PLAIN_CAPTION = words("{quantities} {machine}{for_engine}; {method}")
FIRST_ORDER = words("erste Ordnung nach Weisbach|first order by Weisbach")
DRIVEN = words("der Arbeitsmaschine|of the driven machine")
NAMES = ("Otto", "Diesel")


def caption(request: EngineRequest) -> Label:
    """Return the layout's caption with what all its engines have in common, and the method."""
    methods = dict.fromkeys(method for column in request.page_columns for method in column.methods)
    parts = {"{quantities}": ", ".join(_names(request)), **about_engines(request, methods)}
    text = PLAIN_CAPTION if request.columns else request.layout.caption
    return filled(text[request.lang], parts.items())


def about_engines(request: EngineRequest, methods: Iterable[str]) -> Mapping[str, Label]:
    """Return what captions say of the engines, by the places where they say it."""
    lang = request.lang
    return {
        "{machine}": (DRIVEN if request.carded and request.driven else request.words.machine)[lang],
        "{for_engine}": joined(list(common(request)), lang),
        "{method}": AND[lang].join(_method(request, one) for one in methods),
    }


def _method(request: EngineRequest, method: str) -> Label:
    """What captions say of a method; Weisbach's speed takes none of his equations for the angles."""
    of_angles = any(column.quantity.of not in OF_RUNS for column in request.page_columns)
    said = ENGINE_METHODS[method].caption if method != "weisbach" or of_angles else FIRST_ORDER
    return said[request.lang]


def _names(request: EngineRequest) -> list[str]:
    names = [
        f"{column.quantity.name[request.lang]} {column.quantity.symbol}" for column in request.page_columns
    ]
    first, *others = dict.fromkeys(names)
    return [first[:1].upper() + first[1:], *(inner(name, request.lang) for name in others)]


def inner(name: str, lang: str) -> str:
    """Return a name as it is within a sentence: German nouns keep their capital."""
    return name[:1].lower() + name[1:] if lang == "en" else name


def joined(parts: list[str], lang: str) -> str:
    return FOR[lang] + ", ".join(parts) if parts else ""


def common(request: EngineRequest) -> Iterator[Label]:
    shown = (*request.layout.across, *request.layout.stub)
    if len(request.steams) == 1 and "expansion" not in shown and request.words.captioned:
        yield named_load(request, 0)
    if len(request.ratios) == 1 and "ratio" not in shown and request.assembly is None:
        yield named_ratio(request, 0)


def named_ratio(request: EngineRequest, index: int) -> Label:
    return f"${request.layout.ratio_symbol} = {ratio_text(request.ratios[index])}$"


def load_label(request: EngineRequest | PowerRequest, index: int) -> Label:
    """Return what tells a load from others as pages print it: a number or a name."""
    return request.words.label(request.steams[index], request.lang)


def named_load(request: EngineRequest | PowerRequest, index: int) -> Label:
    """Return the same with its letter, if it has one."""
    return lettered(request.words, request.steams[index], request.lang)


def cylinder_notes(assembly: Assembly, numbers: Sequence[int], lang: str) -> Iterator[Label]:
    """Yield a line for each cylinder: its size, its place, its load; and which of them the shaft drives."""
    numbers = numbers or range(1, len(assembly.parts) + 1)
    numbered = [*zip(numbers, assembly.parts, strict=True)]
    for number, part in numbered:
        yield CYLINDERS["cylinder"][lang].format(number=number) + "; ".join(_said(part, numbers[0], lang))
    driven = [str(number) for number, part in numbered if part.steam.driven]
    if 0 < len(driven) < len(numbered):
        yield CYLINDERS["driven"][lang].format(numbers=", ".join(driven))


def masses_notes(request: EngineRequest, lang: str) -> Iterator[Label]:
    """Yield the masses, those of each cylinder with its number where they differ."""
    numbers = request.numbers or range(1, len(request.first.parts) + 1)
    every = zip(numbers, request.first.parts, strict=True)
    parts = [(number, part.crank) for number, part in every if part.crank.loaded]
    same, weightless = len({crank for _, crank in parts}) == 1, motion.WORDS["weightless"][lang]
    noted = False
    for number, crank in parts[:1] if same else parts:
        prefix = "" if same else CYLINDERS["cylinder"][lang].format(number=number)
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
    load = words_of(part.steam.name)
    if part.load is not None:
        yield load.newtons(part.steam, part.load)
    sizes = f"$R:L = {ratio_text(part.crank.ratio)}$"
    if part.crank.radius is not None:
        sizes = f"{CYLINDERS['stroke'][lang]} ${amount(2 * part.crank.radius, 'mm', plain)}$, {sizes}"
    yield sizes
    if part.lag:
        yield CYLINDERS["lag"][lang].format(angle=f"${angle_text(part.lag)}$", number=first)
    if load.captioned:
        yield load_text(part.steam, lang)
    # What is assumed is said by an entry of the cylinder.
    yield from (within(unprompted(line), lang) for line in load.lines([part.steam], part, lang))
    if load.halved:
        yield CYLINDERS["double" if part.double else "single"][lang]
