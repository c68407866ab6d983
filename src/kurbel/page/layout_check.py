"""Whether pages can be printed in a layout of the user's, as far as its model alone does not say."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial
from itertools import chain

from kurbel.drive.crank import Crank, check_angles
from kurbel.errors import KurbelError, LayoutError
from kurbel.page.formula import GREEK
from kurbel.page.labels import Mark, parse
from kurbel.page.layouts import LANGUAGES, Layout, LayoutColumn, layout, layout_names
from kurbel.page.subject import Limit, subject
from kurbel.reading import notation
from kurbel.reading.given import choose
from kurbel.reading.toml_file import Place, TomlFile

# The axes whose values a layout gives where the command line does not: by which key, and how they are read.
VALUES: Mapping[str, tuple[str, Callable[[Sequence[str]], Sequence[Fraction]]]] = {
    "ratio": ("ratios", notation.ratios),
    "angle": ("angles", notation.angles),
    "expansion": ("expansions", lambda texts: notation.numbers(texts, "expansion ratio")),
    "arm": ("arms", lambda texts: notation.numbers(texts, "arm")),
}
METHODS = ("exact", "series", "series-3", "series-5", "series-7", "series-9", "infinite", "weisbach")
_PLACE = re.compile(r"\{[^{}]*\}")
_KEY = re.compile(r"[A-Za-z][A-Za-z0-9_]*")


def check(file: TomlFile, page: Layout, columns: Mapping[Place, LayoutColumn]) -> None:
    """Raise LayoutError, with the line, unless pages can be printed in the layout; `columns` has its columns
    by where they stand."""
    faults = (
        _faults_of_axes(page),
        _faults_of_values(page),
        _faults_of_groups(file.given["columns"]),
        _faults_of_columns(page, columns),
        _faults_of_words(page, columns),
    )
    for place, said in chain.from_iterable(faults):
        raise file.error(place, said)


def _faults_of_axes(page: Layout) -> Iterator[tuple[Place, str]]:
    """Yield what is amiss: where it stands, and the sentence; the others do likewise."""
    axes = [*subject(page.subject).axes]
    shared = (*page.down, *page.across)
    for key, names in (("down", page.down), ("across", page.across)):
        for index, name in enumerate(names):
            yield from _unknown((key, index), name, axes, f"axis of {page.subject}")
            if shared.count(name) > 1:
                yield (key, index), f"the axis {name} is there twice; down and across share the axes out"
    if missing := [name for name in axes if name not in shared]:
        yield ("down",), f"down and across must share out {', '.join(axes)}; {missing[0]} is missing"
    if subject(page.subject).whole and page.across != ("column",):
        yield ("across",), f'across must be ["column"]; the other axes of {page.subject} belong together'
    if not page.across:
        yield ("across",), "across is an empty list; it must have an axis"
    if not page.stub or page.stub != page.down[-len(page.stub) :]:
        inner = json.dumps(page.down[-1:])
        yield ("stub",), f"stub must have the innermost of the axes that run down, as {inner}"
    for name in page.stub_headings:
        yield from _unknown(("stub_headings", name), name, page.stub, "axis in the stub")
    if page.pairs and "angle" not in page.across:
        yield ("pairs",), "pairs is for angles that run across"
    if page.unit and "column" not in page.down:
        yield ("unit",), "unit is for quantities that run down; down has no column"


def _faults_of_values(page: Layout) -> Iterator[tuple[Place, str]]:
    limits: Mapping[str, Limit] = {"ratio": Crank, **subject(page.subject).limits}
    for axis, (key, _) in VALUES.items():
        texts: tuple[str, ...] = getattr(page, key)
        for index, text in enumerate(texts):
            yield from _refused((key, index), partial(_within, limits, axis, [text]))
        # Without expansion ratios a page asks for one.
        if axis != "expansion" and axis in subject(page.subject).axes and not texts:
            yield (key,), f"{key} is empty; a page about {page.subject} needs them where none are typed"
    if not _is_letter(page.angle_symbol):
        yield ("angle_symbol",), f'angle_symbol is "{page.angle_symbol[:20]}"; it must be a letter'
    first, colon, second = page.ratio_symbol.partition(":")
    if not (colon and _is_letter(first) and _is_letter(second)):
        yield ("ratio_symbol",), f'ratio_symbol is "{page.ratio_symbol[:20]}"; it must be two letters, as R:L'


def _within(limits: Mapping[str, Limit], axis: str, texts: Sequence[str]) -> None:
    """Raise KurbelError for values of an axis that cannot be read, or that no drive has."""
    values = VALUES[axis][1](texts)
    if axis == "angle":
        check_angles(values)
    elif limit := limits.get(axis):
        for value in values:
            limit(value)


def _is_letter(text: str) -> bool:
    """Whether formulas have the letter."""
    return text in GREEK or (len(text) == 1 and text.isascii() and text.isalpha())


def _faults_of_groups(given: object, above: Place = ("columns",)) -> Iterator[tuple[Place, str]]:
    """Yield what is amiss in columns, as the file has them: a quantity is missing, or is beside columns."""
    assert isinstance(given, list)
    for index, one in enumerate(given):
        place = (*above, index)
        beside = next((name for name in one if name not in ("spanners", "columns")), "")
        if not one.get("columns"):
            if "quantity" not in one:
                yield place, 'there is no quantity; write quantity = "x"'
        elif beside:
            yield (*place, beside), f"{beside} stands beside columns; write it in each that it is about"
        else:
            yield from _faults_of_groups(one["columns"], (*place, "columns"))


def _faults_of_columns(page: Layout, columns: Mapping[Place, LayoutColumn]) -> Iterator[tuple[Place, str]]:
    about = subject(page.subject)
    quantities = about.quantities()
    fitting = about.fitting()
    keys = [column.key for column in page.columns]
    if not keys:
        yield ("columns",), "columns is an empty list; it must have a column"
    for index, (place, column) in enumerate(columns.items()):
        for key in ("quantity", "unless", "unless_printed"):
            if (name := getattr(column, key)) or key == "quantity":
                yield from _unknown((*place, key), name, fitting, f"quantity of {page.subject}")
        if column.method is not None and column.quantity in quantities:
            allowed = _methods(quantities[column.quantity].formulas)
            yield from _unknown((*place, "method"), column.method, allowed, f"method of {column.quantity}")
        if not _KEY.fullmatch(column.key) or column.key in {*about.axis_keys} - {column.quantity}:
            yield (*place, "key"), f'the key "{column.key[:40]}" cannot be that of a column; write it as x_2'
        if keys.index(column.key) != index:
            yield place, f"the key {column.key} is there twice; give one of the columns another"
        if column.heading == () and ("column" in page.down or column.spanners == ()):
            yield (*place, "heading"), "heading is an empty list; nothing else stands over the column"


def _methods(formulas: Collection[str]) -> list[str]:
    # Of a straight crank with its masses, which alone has an infinite rod, all methods have one formula.
    every = formulas if not {"infinite", "loaded"} <= {*formulas} else {*formulas, "series"}
    known = [method for method in METHODS if method in every] or ["exact"]
    if "weisbach" in known:
        return [*known, *(f"exact-{other}" for other in known if other != "exact")]
    return [*known, *(["difference"] if {"exact", "series"} <= {*known} else [])]


def _faults_of_words(page: Layout, columns: Mapping[Place, LayoutColumn]) -> Iterator[tuple[Place, str]]:
    alike = [one for one in map(layout, layout_names()) if one.subject == page.subject]
    filled = {place for one in alike for lang in LANGUAGES for place in _PLACE.findall(one.caption[lang])}
    heads = ["{ratio}"] if "ratio" in subject(page.subject).axes else []
    known = {"caption": sorted(filled), "columns": heads}
    for lang in LANGUAGES:
        for place, text in _labels(page, columns, lang):
            for found in _PLACE.findall(text):
                if places := known.get(str(place[0])):
                    yield from _unknown(place, found, places, "place")
                else:
                    yield place, f"{found[:60]} is a place, and none is filled here; write words"
            yield from _refused(place, partial(_check_label, text))


def _labels(page: Layout, columns: Mapping[Place, LayoutColumn], lang: str) -> Iterator[tuple[Place, str]]:
    """Yield the labels of a page in a language, with their places."""
    yield ("caption", lang), page.caption[lang]
    yield ("source", lang), page.source[lang]
    for index, note in enumerate(page.notes):
        yield ("notes", lang, index), note[lang]
    for name, heading in page.stub_headings.items():
        yield ("stub_headings", name), heading[lang]
    for place, column in columns.items():
        for key, lines in (("spanners", column.spanners), ("heading", column.heading)):
            for index, line in enumerate(lines or ()):
                yield (*place, key, index), line[lang]


def _check_label(text: str) -> None:
    """Raise LayoutError for a label that cannot be set; places in it are filled."""
    marks = [part.text for part in parse(_PLACE.sub("1", text)) if isinstance(part, Mark)]
    if marks:
        raise LayoutError(f"the mark [^{marks[0]}] points to no note")


def _unknown(place: Place, name: str, allowed: Iterable[str], what: str) -> Iterator[tuple[Place, str]]:
    yield from _refused(place, partial(choose, name, allowed, what))


def _refused(place: Place, read: Callable[[], object]) -> Iterator[tuple[Place, str]]:
    try:
        read()
    except KurbelError as error:
        yield place, str(error)
