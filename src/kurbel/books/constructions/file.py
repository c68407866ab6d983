"""A construction as its file says it: read, its names checked, its formulas made.

A file may be `like` another, of the folder `shared` beside it or of kurbel's own: it has the keys of that one
where it has none, its points before its own, and its steps, lengths and notes by their names. What stands in
`of.arc` is of that mechanism alone, in the whole file or in a step or a length, and takes the place of what
else stands there.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from operator import itemgetter
from typing import Any, NamedTuple

from kurbel.books.constructions import formulas as read_formulas
from kurbel.books.constructions import model
from kurbel.books.constructions.formula_names import KNOWN, NUMBER, POINT
from kurbel.books.constructions.formulas import NAME, TRUTH, Formula, Values
from kurbel.books.constructions.model import (
    Construction,
    ConstructionFile,
    CurveFile,
    Element,
    FailureRule,
    Length,
    LengthFile,
    Points,
    PositionFile,
    Step,
    StepFile,
)
from kurbel.books.constructions.placed import TAKEN, Position
from kurbel.drive.mechanisms import MECHANISMS
from kurbel.errors import ConstructionError, KurbelError, NotationError
from kurbel.exact.certify import Kept
from kurbel.page.labels import parse
from kurbel.page.layouts import Folder
from kurbel.reading.given import choose
from kurbel.reading.notation import angle, number
from kurbel.reading.toml_file import A_TEXT, Place, TomlFile, TomlKind, shown

KIND = TomlKind(
    "construction", ConstructionError, 100_000, "a construction has points and steps", "figures/mine.toml"
)
HOUSE, SHARED = os.path.join(os.path.dirname(__file__), "figures"), "shared"
# No construction has more.
MOST_STEPS, MOST_POINTS, MOST_LENGTHS, MOST_ELEMENTS = 20, 150, 30, 60
LOOKS = (model.LINK, model.GIVEN, model.AID, model.CENTRE, model.HIDDEN, model.RESULT)
# What keys that are tables look like.
TABLES = {"of": 'arc = { formula = "" }', "letters": 'pin = "C"'}


class ElementKind(NamedTuple):
    """An element: what it is made as, of how many names of points, a length or a curve, and the field that a
    number is of."""

    made: type
    names: int
    number: str = ""
    of: str = "point"


SHAPES: Mapping[str, ElementKind] = {
    "line": ElementKind(model.Line, 2, "beyond"),
    "arrow": ElementKind(model.Arrow, 2),
    "arc": ElementKind(model.Arc, 3, "beyond"),
    "circle": ElementKind(model.Circle, 2),
    "square": ElementKind(model.RightAngle, 3),
    "angle": ElementKind(model.Angle, 3, "at"),
    "curve": ElementKind(model.Curve, 1, of="curve"),
    "text": ElementKind(model.Text, 1),
    "scale": ElementKind(model.Scale, 2),
    "measure": ElementKind(model.Dimension, 1, "level", of="length"),
}
# Words that say more of an element: the field, and its value.
FLAGS: Mapping[str, tuple[str, object]] = {
    **{look: ("look", look) for look in LOOKS},
    "bare": ("written", False),
    "turning": ("sense", 1),
    "back": ("sense", -1),
}


def read_construction(path: Folder, name: str, folder: object, mechanism: str) -> Construction:
    """Return the construction of a file as it is of a mechanism, by default the first for which it holds.

    Raises ConstructionError with file and line for one that cannot be drawn.
    """
    file = TomlFile(path, KIND)
    _check_tables(file, file.given)
    shared = _shared(file)
    holds = file.given.get("holds", shared.get("holds"))
    if not mechanism:
        mechanism = str(holds[0]) if isinstance(holds, list) and holds else "straight"
    file.given = _together(file, _of_mechanism(shared, mechanism), _of_mechanism(file.given, mechanism))
    return _Maker(file, file.read(ConstructionFile), mechanism).made(name, folder)


def _shared(file: TomlFile) -> dict[str, Any]:
    """Return what the file that this one is like says."""
    like = file.given.pop("like", None)
    if like is None:
        return {}
    beside = os.path.join(os.path.dirname(os.fspath(file.path)), SHARED)
    places = [os.path.join(folder, f"{like}.toml") for folder in (beside, os.path.join(HOUSE, SHARED))]
    try:
        shared = TomlFile(next(filter(os.path.exists, places), places[0]), KIND)
    except ConstructionError as error:
        raise file.error(("like",), error) from None
    _check_tables(shared, shared.given)
    for key in ("steps", "lengths", "notes"):
        named = shared.given.get(key, {})
        if not (isinstance(named, dict) and all(isinstance(one, dict) for one in named.values())):
            raise shared.error((key,), f"shared {key} are tables by their names, such as [{key}.mine]")
    return shared.given


def _check_tables(file: TomlFile, given: Any, place: Place = ()) -> None:
    """Raise ConstructionError for an `of`, `like`, `letters` or `draw` that is none, wherever it stands."""
    if isinstance(given, list):
        for index, one in enumerate(given):
            _check_tables(file, one, (*place, index))
    if not isinstance(given, dict):
        return
    # Of a length `letters` is what it is called.
    for key, inner in (("of", dict), *((("letters", str),) if not place else ())):
        own = given.get(key, {})
        if not isinstance(own, dict):
            said = f"{key} is {shown(own)}; it must be a table, such as {key}.{TABLES[key]}"
            raise file.error((*place, key), said)
        for name, one in own.items():
            if not isinstance(one, inner):
                noun = "a table" if inner is dict else "a text"
                raise file.error((*place, key, name), f"{key}.{name} is {shown(one)}; it must be {noun}")
    for key in ("like", "draw"):
        if not isinstance(given.get(key, ""), str):
            raise file.error((*place, key), f"{key} is {shown(given[key])}; it must be {A_TEXT}")
    for name in given.get("of", {}):
        try:
            choose(name, MECHANISMS, "mechanism")
        except KurbelError as error:
            raise file.error((*place, "of", name), error) from None
    for key, one in given.items():
        _check_tables(file, one, (*place, key))


def _of_mechanism(given: Any, mechanism: str) -> Any:
    """Return what a file says as it is of a mechanism."""
    if isinstance(given, list):
        return [_of_mechanism(one, mechanism) for one in given]
    if not isinstance(given, dict):
        return given
    own: Any = given.get("of", {})
    found = {key: value for key, value in given.items() if key != "of"}
    return {key: _of_mechanism(one, mechanism) for key, one in (found | own.get(mechanism, {})).items()}


def _together(file: TomlFile, shared: Mapping[str, Any], own: Mapping[str, Any]) -> dict[str, Any]:
    """Return what a file says with what it shares: its keys before those of the other, the points of both,
    and in place of the name of a shared step, length or note that itself."""
    letters = own.get("letters", {})

    def entry(key: str, index: int, given: Any) -> Any:
        named = shared.get(key, {})
        like = given.get("like") if isinstance(given, dict) else given
        # A note may be a text of its own.
        if not isinstance(like, str) or (given is like and (key != "notes" or like not in named)):
            return given
        try:
            base = _lettered(named[choose(like, named, f"one of the shared {key}")], letters)
        except KurbelError as error:
            raise file.error((key, index), error) from None
        if isinstance(given, str):
            return base
        draw = ";".join(one["draw"] for one in (base, given) if "draw" in one)
        more = {name: value for name, value in given.items() if name != "like"}
        return {**base, **more, **({"draw": draw} if draw else {})}

    both = {**shared, **own}
    both.pop("letters", None)
    for key in ("steps", "lengths", "notes"):
        if isinstance(own.get(key), list):
            both[key] = [entry(key, index, one) for index, one in enumerate(own[key])]
        else:
            both.pop(key, None)
    if "points" in own:
        both["points"] = f"{shared.get('points', '')}\n{own['points']}"
    return both


def _lettered(shared: Any, letters: Mapping[str, str]) -> Any:
    """Return what is shared with the letters of the file in place of what they stand for, as {pin}."""
    if isinstance(shared, dict):
        return {key: _lettered(value, letters) for key, value in shared.items()}

    def letter(found: re.Match[str]) -> str:
        return letters[choose(found[1], letters, "of the letters")]

    return re.sub(r"\{(\w+)\}", letter, shared) if isinstance(shared, str) else shared


class _Maker:
    """Makes a construction of what its file says, and checks all names."""

    def __init__(self, file: TomlFile, given: ConstructionFile, mechanism: str) -> None:
        self.file, self.given, self.mechanism = file, given, mechanism
        self.formulas: dict[str, Formula] = {}
        self.known: dict[str, Formula] = {}

    def made(self, name: str, folder: object) -> Construction:
        given = self.given
        self.check_names()
        self.read_points()
        curves = {key: self.curve(key, one) for key, one in given.curves.items()}
        lengths = [self.length(index, one) for index, one in enumerate(given.lengths)]
        letters = [length.letters for length in lengths]
        steps = [self.step(index, one, letters) for index, one in enumerate(given.steps)]
        for index, note in enumerate(given.notes):
            self.check_label(("notes", index), *note.values())
        self.check_label(("title",), *given.title.values())
        self.check_label(("source",), *given.source.values())
        if given.angle:
            self.trying(("angle",), angle, given.angle)
        fails = [
            FailureRule(self.formula(("fails", index, "where"), one.where, (TRUTH,)), one.why)
            for index, one in enumerate(given.fails)
        ]
        position = self.position(given.position) if given.position else None
        scales = {unit: self.number(("scales", unit), text) for unit, text in given.scales.items()}
        return Construction(
            name,
            self.mechanism,
            given,
            self.formulas,
            steps,
            lengths,
            curves,
            fails,
            position,
            scales,
            folder,
        )

    def check_names(self) -> None:
        """Raise an error for mechanisms and options that there are not, and for too much of anything."""
        given = self.given
        for index, name in enumerate(given.holds):
            self.trying(("holds", index), choose, name, MECHANISMS, "mechanism")
        for index, name in enumerate(given.takes):
            self.trying(("takes", index), choose, name, TAKEN, "option of constructions")
        for key, most in (("steps", MOST_STEPS), ("lengths", MOST_LENGTHS)):
            if not 0 < len(getattr(given, key)) <= most:
                raise self.file.error(
                    (key,), f"{key} has {len(getattr(given, key))} entries; give 1 to {most}"
                )

    def trying(self, place: Place, read: Callable[..., Kept], *given: object) -> Kept:
        """Return what `read` makes of what is given; its errors get file and line."""
        try:
            return read(*given)
        except KurbelError as error:
            raise self.file.error(place, error) from None

    def read_points(self) -> None:
        """Read the formulas of the points, each of which may name those above it."""
        # Errors name the line of the point within the block.
        own = (line.partition(" = ")[0].strip() for line in self.file.text.splitlines())
        places = {("points", name): number for number, name in enumerate(own, 1)}
        self.file.lines = places | {**self.file.lines}
        lines = self.trying(("points",), read_formulas.lines_of, f"{self.given.given}\n{self.given.points}")
        if len(lines) > MOST_POINTS:
            raise self.file.error(
                ("points",), f"points has {len(lines)} formulas; at most {MOST_POINTS} are read"
            )
        for _, name, text in lines:
            self.trying(("points", name), self.check_new, name)
            formula = self.formula(
                ("points", name), text, (NUMBER, POINT) if name.startswith("_") else (POINT,)
            )
            # A letter with a star is the same once more, elsewhere; no formula can name it.
            self.formulas[name] = self.known[name] = formula

    def check_new(self, name: str) -> None:
        if not re.fullmatch(NAME + r"\*?", name):
            raise NotationError(
                f'"{name[:40]}" cannot be the name of a point; write it as C, C_1, C\' or _help'
            )
        if name in (*KNOWN, "first", "last") or (name == "t" and self.given.curves):
            raise NotationError(
                f'the point "{name}" would hide what formulas know by this name; call it otherwise'
            )
        if name in self.formulas:
            raise NotationError(f'the point "{name}" is there twice')

    def formula(self, place: Place, text: str, what: tuple[str, ...], more: str = "") -> Formula:
        """Return a formula that may name all points, and beside them one number `more`."""
        known = {**self.known, more: Formula(NUMBER, itemgetter(more))} if more else self.known
        found: Formula = self.trying(place, read_formulas.read, text, known, self.mechanism)
        if found.gives not in what:
            said = f'"{text[:60]}" is a {found.gives}, and must be a {" or a ".join(what)}'
            raise self.file.error(place, said)
        if found.in_floats and what in ((POINT,), (NUMBER,)):
            raise self.file.error(
                place,
                f'"{text[:60]}" has max or min, which floats alone tell; round it, as near(max(a, b), 20)',
            )
        return found

    def number(self, place: Place, text: str) -> Fraction:
        return self.trying(place, number, text)

    def position(self, given: PositionFile) -> Position:
        pin = self.trying(("position", "pin"), read_formulas.read, given.pin, {}, self.mechanism)
        return Position(lambda at: pin.value(Values(at, {})), {"de": given.de, "en": given.en})

    def curve(self, key: str, given: CurveFile) -> Points:
        def formula(name: str, *what: str) -> Formula | None:
            text = getattr(given, name)
            return self.formula(("curves", key, name), text, what, "t") if text else None

        at = formula("at", POINT)
        if at is None:
            raise self.file.error(("curves", key), f'the curve {key} has no points; write at = "(t, t^2)"')
        start = self.number(("curves", key, "start"), given.start) if given.start else Fraction(0)
        end = self.number(("curves", key, "end"), given.end)
        own = formula("same", NUMBER), formula("down_to", NUMBER)
        return Points(at, not given.start, start, end, given.steps, *own)

    def length(self, index: int, given: LengthFile) -> Length:
        place: Place = ("lengths", index)
        ends = given.ends.split()
        if len(ends) != 2:
            raise self.file.error(
                (*place, "ends"), f'the ends of a length are "{given.ends[:40]}"; write two points'
            )
        self.points((*place, "ends"), ends)
        if given.unit not in ("$R$", model.DEGREES, *self.given.scales):
            said = f'the unit "{given.unit[:40]}" has no scale; write it into scales'
            raise self.file.error((*place, "unit"), said)
        self.check_label(place, given.symbol, given.formula, given.offset_formula)
        first, last = ends
        drawn = re.sub(r"\bfirst\b", first, re.sub(r"\blast\b", last, given.drawn))
        return Length(
            given.letters or "".join(ends),
            (first, last),
            given.symbol,
            given.formula,
            self.formula((*place, "drawn"), drawn, (NUMBER,)),
            self.formula((*place, "true"), given.true, (NUMBER,)),
            given.unit,
            given.approximate,
            given.offset_formula,
        )

    def step(self, index: int, given: StepFile, lengths: Sequence[str]) -> Step:
        place: Place = ("steps", index)
        self.check_label((*place, "de"), given.de)
        self.check_label((*place, "en"), given.en)
        letters = given.points.split()
        self.points((*place, "points"), letters)
        drawn = [part.strip() for part in re.split(r"[;\n]", given.draw) if part.strip()]
        if len(drawn) > MOST_ELEMENTS:
            raise self.file.error(
                place, f"a step draws {len(drawn)} elements; at most {MOST_ELEMENTS} are drawn"
            )
        names = {"point": self.drawable(), "length": lengths, "curve": [*self.given.curves]}
        elements = [self.trying((*place, "draw"), element, text, names) for text in drawn]
        for one in elements:
            self.check_label((*place, "draw"), getattr(one, "symbol", ""), getattr(one, "text", ""))
        return Step({"de": given.de, "en": given.en}, elements, letters)

    def drawable(self) -> list[str]:
        return [name for name in self.formulas if not name.startswith("_")]

    def points(self, place: Place, names: Iterable[str]) -> None:
        for name in names:
            self.trying(place, choose, name, self.drawable(), "point")

    def check_label(self, place: Place, *labels: str) -> None:
        for label in labels:
            self.trying(place, parse, label)


def element(text: str, names: Mapping[str, Sequence[str]]) -> Element:
    """Return an element of what is drawn: line O A centre 4, arrow P T $F_T$, measure ad -1 bare.

    Raises KurbelError for what is none, and for a name that is not among `names` of its kind.
    """
    kind, *parts = re.findall(r"\$.*\$|\S+", text)
    shape = SHAPES[choose(kind, SHAPES, "element")]
    own, rest = parts[: shape.names], parts[shape.names :]
    if len(own) < shape.names:
        raise NotationError(f'"{text[:60]}" has {len(own)} names; {kind} takes {shape.names}')
    for name in own:
        choose(name, names[shape.of], shape.of)
    more: dict[str, object] = {}
    for part in rest:
        if part.startswith("$"):
            more["text" if shape.made is model.Text else "symbol"] = part
        elif part in FLAGS:
            more[FLAGS[part][0]] = FLAGS[part][1]
        elif shape.number and re.fullmatch(r"-?\d{1,3}(\.\d{1,3})?", part):
            more[shape.number] = int(part) if shape.number == "level" else float(part)
        else:
            raise NotationError(f'"{text[:60]}" has "{part[:20]}", which {kind} does not take')
    fields = shape.made._fields  # type: ignore[attr-defined]
    if wrong := [name for name in more if name not in fields]:
        raise NotationError(f'"{text[:60]}" has a {wrong[0]}, which {kind} does not take')
    made: Element = shape.made(*own, **more)
    return made
