"""What pages can be about, and page layouts, as layout.toml has them: axes, columns and words."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Annotated, Any, ClassVar, TypeAlias

from kurbel.drive import mechanisms
from kurbel.drive.mechanisms import Pages
from kurbel.errors import ChoiceError, LayoutError
from kurbel.exact.numerals import MOST_DIGITS, Label
from kurbel.reading.given import File, choose
from kurbel.reading.toml_file import Fault, Place, TextChoice, TomlFile, TomlKind, about, within

_INERTIA = "inertia --centre 0.65 --gyration 0.35"
_MACHINE = "forces --eps 4 --bore 300mm --pressure 8bar --stroke 600mm --speed 120/min --reciprocating 300kg"
_EFFORT = "forces --bore 300mm --pressure-difference 2bar --stroke 600mm --friction 500N"
_HEAVY = "forces --stroke 600mm --speed 120/min --reciprocating 300kg"
_ARC = "--mechanism arc --rocker 6"
_PRESSED = _MACHINE.replace("forces", "pressures")
_LISTED = "delta --eps 4 --cranks 0;90"
_EXCITED = "harmonics --quantity torque --eps 4 --bore 300mm --pressure 8bar --stroke 600mm --speed 120/min"
_AXLE = "--spacing 0.7m --gauge 1.5m --stroke 600mm --reciprocating 300kg"
_ROTOR = "--masses 3;4kg --radii 1m --angles 0;90 --planes 0;1m"
_EVEN = "--power 50kW --speed 120/min --delta 1:100"
# What pages can be about, by its name.
SUBJECTS: Mapping[str, Pages] = {
    "motion": Pages("kurbel.motion.motion_page:MOTION", "table"),
    "effort": Pages("kurbel.motion.motion_page:EFFORT", _EFFORT),
    "mass forces": Pages("kurbel.motion.motion_page:MASSES", _HEAVY),
    "series errors": Pages("kurbel.motion.series_errors:SUBJECT", "table --layout series-errors"),
    "successive": Pages("kurbel.motion.chord_page:SUBJECT", "table --layout roetscher-gf"),
    "tangent": Pages("kurbel.motion.tangent_page:SUBJECT", "forces --at tangent"),
    "irregularity": Pages("kurbel.engine.engine_page:IRREGULARITY", "delta"),
    "strokes": Pages("kurbel.engine.engine_page:STROKES", "delta --eps 2"),
    "cylinders": Pages("kurbel.engine.cylinders:SUBJECT", _LISTED),
    "compressor": Pages("kurbel.engine.engine_page:COMPRESSOR", "delta --pressure-ratio 2..6"),
    "pump": Pages("kurbel.engine.engine_page:PUMP", "delta --pump"),
    "gas cycle": Pages("kurbel.engine.engine_page:GAS_CYCLE", "delta --compression 5..8 --heat 10"),
    "power": Pages("kurbel.engine.power.power_page:SUBJECT", "power --eps 3 --pressure 8bar"),
    "turning": Pages("kurbel.engine.engine_page:TURNING", "turning --eps 4"),
    "torques": Pages("kurbel.engine.diagram.diagram_page:OF_TORQUES", "turning --torque 5000+1500sin(3φ)"),
    "areas": Pages("kurbel.engine.diagram.diagram_page:OF_AREAS", "turning --areas +52J;-124J;+72J"),
    "speed": Pages("kurbel.engine.speed.speed_page:SPEED", "turning --eps 4 --flywheel 50 --speed 120/min"),
    "evenness": Pages("kurbel.engine.speed.speed_page:EVENNESS", "delta --flywheel 50"),
    "crank forces": Pages("kurbel.engine.engine_page:CRANK_FORCES", "forces --eps 4"),
    "machine": Pages("kurbel.engine.engine_page:MACHINE", _MACHINE),
    "rod load": Pages("kurbel.engine.rod_load_page:SUBJECT", "forces --eps 4"),
    "flywheel": Pages("kurbel.engine.engine_page:FLYWHEEL", f"flywheel --eps 4 {_EVEN}"),
    "flywheel sizing": Pages(
        "kurbel.engine.diagram.wheel_page:SUBJECT", "flywheel --swing 5kJ --speed 300/min --delta 1:50"
    ),
    "pressures": Pages("kurbel.engine.pressures:PRESSURES", _PRESSED),
    "pressures over the angle": Pages("kurbel.engine.pressures:PRESSURES_OVER_ANGLE", _PRESSED),
    "dead centres": Pages("kurbel.linkage.beam_engine:SUBJECT", "deadcentres"),
    "drive dead centres": Pages("kurbel.linkage.dead_centres:SUBJECT", f"deadcentres {_ARC}"),
    "harmonics": Pages("kurbel.balancing.harmonics:SUBJECT", "harmonics"),
    "torque": Pages("kurbel.engine.torque_harmonics:TORQUE", "harmonics --quantity torque --eps 4"),
    "excitation": Pages("kurbel.engine.torque_harmonics:EXCITING", _EXCITED),
    "balance": Pages("kurbel.balancing.balance_page:SUBJECT", "balance"),
    "balance at angles": Pages("kurbel.balancing.angles:AT_ANGLES", "balance --angle 30"),
    "balance extremes": Pages("kurbel.balancing.greatest:EXTREMES", "balance"),
    "rotor": Pages("kurbel.balancing.rotor_page:SUBJECT", f"rotor {_ROTOR}"),
    "locomotive": Pages("kurbel.balancing.locomotive:SUBJECT", f"locomotive {_AXLE}"),
    "firing orders": Pages("kurbel.balancing.firing:ORDERS", "firing"),
    "firing": Pages("kurbel.balancing.firing:FIRING", "firing --order 1-3-4-2"),
    **mechanisms.SUBJECTS,
    "coupled axles": Pages("kurbel.linkage.parallel:COUPLED", "forces --mechanism parallel --axles 3"),
    "rod points": Pages("kurbel.motion.points_page:SUBJECT", "table --point 0.5"),
    "inertia": Pages("kurbel.motion.inertia_page:INERTIA", _INERTIA),
    "inertia errors": Pages("kurbel.motion.inertia_page:SUBJECT", _INERTIA),
    "rod masses": Pages("kurbel.motion.rod_masses:SUBJECT", _INERTIA),
    "pin masses": Pages("kurbel.motion.rod_masses:PINS", _INERTIA),
    "rocker inertia": Pages("kurbel.linkage.arc_quantities:SUBJECT", f"{_INERTIA} {_ARC}"),
    "roots": Pages("kurbel.conditions.solve_page:SUBJECT", "solve --where p=0"),
    "over path": Pages("kurbel.conditions.over:MOTION", "table --angle s=50%"),
    "forces over path": Pages("kurbel.conditions.over:FORCES", "forces --angle s=50%"),
    "unknown": Pages("kurbel.conditions.unknown:SUBJECT", "solve --unknown ratio --angle 80 --where c=max"),
    "loaded roots": Pages("kurbel.conditions.loaded:SUBJECT", "solve --eps 4 --where torque=max"),
    "construction": Pages("kurbel.books.constructions.construction_page:SUBJECT", "construct blau-9 --table"),
    "collation": Pages("kurbel.books.collate_page:SUBJECT", "collate roetscher-112"),
    "formulas": Pages("kurbel.books.formula_page:SUBJECT", "collate blau-equations"),
}
LANGUAGES = ("de", "en")
Folder: TypeAlias = str | os.PathLike[str]
KIND = TomlKind("layout", LayoutError, 200_000, "a layout has axes and columns", "pages/mine/layout.toml")


def _of_languages(entry: Mapping[str, object]) -> Mapping[str, object]:
    """Return the JSON Schema of a table that has such an entry in each language."""
    return {
        "type": "object",
        "additionalProperties": False,
        "properties": dict.fromkeys(LANGUAGES, entry),
        "required": [*LANGUAGES],
    }


class Words(dict[str, Label]):
    """A text in each language, in a file { de = "...", en = "..." }, or one for both."""

    MUST = 'a text, or { de = "...", en = "..." }'
    SCHEMA: ClassVar[Mapping[str, object]] = {
        "anyOf": [{"type": "string"}, _of_languages({"type": "string"})]
    }

    @classmethod
    def read(cls, given: object, _: str) -> Words:
        texts = cls.texts(given) if isinstance(given, str) else given
        kinds = {key: type(text) for key, text in texts.items()} if isinstance(texts, dict) else {}
        if not isinstance(texts, dict) or kinds != dict.fromkeys(LANGUAGES, str):
            raise Fault(cls.MUST)
        return cls(texts)

    @classmethod
    def texts(cls, text: str) -> dict[str, str]:
        return dict.fromkeys(LANGUAGES, text)


class Head(Words):
    """The same, also as "German|English"."""

    MUST = 'a text, "German|English" or { de = "...", en = "..." }'

    @classmethod
    def texts(cls, text: str) -> dict[str, str]:
        parts = text.split("|")
        if len(parts) == 1:
            return super().texts(text)
        return dict(zip(LANGUAGES, parts, strict=True)) if len(parts) == len(LANGUAGES) else {}


class Notes(tuple[Words, ...]):
    """Lines below the table, in a file { de = ["..."], en = ["..."] }."""

    SCHEMA: ClassVar[Mapping[str, object]] = _of_languages({"type": "array", "items": {"type": "string"}})

    @classmethod
    def read(cls, given: object, name: str) -> Notes:
        known = given if isinstance(given, dict) and len(given) == len(LANGUAGES) else {}
        lists: list[Any] = [known.get(one) for one in LANGUAGES]
        if not all(isinstance(one, list) and all(isinstance(text, str) for text in one) for one in lists):
            raise Fault('lists of texts, de = ["..."] and en = ["..."]')
        if len({*map(len, lists)}) > 1:
            raise LayoutError(f"{name} has more texts in one language than in the other")
        return cls(Words(zip(LANGUAGES, texts, strict=True)) for texts in zip(*lists, strict=True))


class Subject(TextChoice, what="subject", allowed=SUBJECTS):
    """What a page is about."""


_MOTION, _NO_NOTES = Subject("motion"), Notes()
Names = tuple[str, ...]
LARGEST_BLOCK = 500
_NAME = r"[A-Za-z0-9]+(?:-+[A-Za-z0-9]+)*"


_COLUMNS = {"type": "array", "items": {"$ref": "#/properties/columns/items"}}


@dataclass(frozen=True, repr=False)
class LayoutColumn:
    """A column of a layout, or `columns` side by side whose spanners are said once. `method` None leaves the
    formulas to the user; spanners and heading None to the quantity. A column gives way to the quantity
    `unless` where that is known, to `unless_printed` so on pages alone."""

    NOUN: ClassVar[str] = "key of a column"
    SHAPE: ClassVar[str] = 'a table, such as { quantity = "x" }'

    quantity: Annotated[str, about("quantity; `kurbel quantities` lists them", example="x")] = ""
    key: Annotated[str, about("name in CSV, JSON and --columns; default: the quantity")] = ""
    method: Annotated[str | None, about("method of its formulas; columns of all methods leave no choice")] = (
        None
    )
    spanners: Annotated[
        tuple[Head, ...] | None, about("heads above the heading, or above `columns`; default: the quantity's")
    ] = None
    heading: Annotated[tuple[Head, ...] | None, about("lines of its head; default: the quantity's")] = None
    decimals: Annotated[Annotated[int, within(0, MOST_DIGITS)] | None, about("default: the quantity's")] = (
        None
    )
    unless: Annotated[str, about("quantity to which it gives way where that is known")] = ""
    unless_printed: Annotated[
        str, about("quantity to which it gives way on pages where that is known; CSV and JSON have both")
    ] = ""
    columns: Annotated[
        tuple[LayoutColumn, ...],
        about("in place of all but spanners: the columns below these", schema=_COLUMNS),
    ] = ()

    def __post_init__(self) -> None:
        if not self.key:
            object.__setattr__(self, "key", self.quantity)


def placed(
    columns: Sequence[LayoutColumn], above: Place = ("columns",)
) -> Iterator[tuple[Place, LayoutColumn]]:
    """Yield the columns of a list that may have them in groups: where each stands, and with all its
    spanners."""
    for index, one in enumerate(columns):
        place = (*above, index)
        if not one.columns:
            yield place, one
        for inner, column in placed(one.columns, (*place, "columns")):
            yield inner, replace(column, spanners=(*(one.spanners or ()), *(column.spanners or ())))


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class LayoutFile:
    """An arrangement of the axes of its subject.

    `down` lists the axes that run down, outermost first; those in `stub` are printed in the stub, the
    others head a group of rows. `across` lists the axes of the columns, outermost first. `block` is the
    largest number of columns of one panel, 0 for no limit. With `pairs` an angle stands over its mirror
    image. `formulas` has the formulas printed below the table; pages whose heads state them do without.
    `unit` adds a last column with the unit of each row.
    """

    NOUN: ClassVar[str] = "key of a layout"

    title: Annotated[Head, about("what `kurbel layouts` says of it", example="Piston path")]
    caption: Annotated[
        Head,
        about(
            "caption, with places such as {quantities}, {for_ratio} and {method}",
            example="{quantities}{for_ratio}; {method}",
        ),
    ]
    down: Annotated[Names, about("axes that run down, the outermost first", example=["ratio", "angle"])]
    stub: Annotated[Names, about("those of them in the stub", example=["angle"])]
    across: Annotated[Names, about("axes that run across, the outermost first", example=["column"])]
    columns: Annotated[tuple[LayoutColumn, ...], about("the columns", example=[{"quantity": "x"}])]
    subject: Annotated[Subject, about("what the page is about; default: motion")] = _MOTION
    ratios: Annotated[Names, about('crank ratios without --ratio, as "1:5"')] = ()
    angles: Annotated[Names, about('crank angles without --angle and --step, as "0..180:10"')] = ()
    expansions: Annotated[Names, about('expansion ratios without --eps, as "2..6"')] = ()
    arms: Annotated[Names, about('arms of the beam without --arm, as "3"')] = ()
    source: Annotated[Head, about("line on the source, below the table")] = field(
        default_factory=lambda: Head(Head.texts(""))
    )
    notes: Annotated[Notes, about("lines below the table, as notes.de and notes.en")] = _NO_NOTES
    stub_headings: Annotated[dict[str, Head], about("heads over the columns of the stub, by their axes")] = (
        field(default_factory=dict)
    )
    angle_symbol: Annotated[str, about("letter of the crank angle; default: φ")] = "φ"
    ratio_symbol: Annotated[str, about("letters of the crank ratio; default: R:L")] = "R:L"
    block: Annotated[
        Annotated[int, within(0, LARGEST_BLOCK)], about("most columns of one panel; 0: no limit")
    ] = 0
    pairs: Annotated[bool, about("whether an angle stands over its mirror image")] = False
    bare_zeros: Annotated[bool, about("whether what is exactly zero is printed as 0, without decimals")] = (
        False
    )
    formulas: Annotated[bool, about("whether formulas stand below the table")] = True
    pause: Annotated[
        Annotated[int, within(0, LARGEST_BLOCK)] | None,
        about("rows between small spaces, 0 for none; default: three or five by the step"),
    ] = None
    unit: Annotated[bool, about("whether a last column has the unit of each row")] = False


class Layout(LayoutFile):
    """A layout with its name; `folder` is the user's folder that it lies in, nothing for kurbel's own."""

    key: str
    folder: str

    def __init__(self, key: str, folder: str = "", **given: Any) -> None:
        super().__init__(**given)
        vars(self).update(key=key, folder=folder)

    @property
    def fixed(self) -> bool:
        """Whether the page's heads state formulas, so that neither columns nor method can be chosen."""
        return all(column.method is not None for column in self.columns)


@cache
def template_folder() -> str:
    """Return the folder of templates: in the installed package, else in the checkout.

    An editable install holds no copy of the templates; the checkout's folder serves it.
    """
    package = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    for folder in (f"{package}/templates", f"{package}/../../templates"):
        if os.path.isdir(folder):
            return os.path.normpath(folder)
    raise LayoutError(f"there are no templates beside {package}; the installation is not complete")


@cache
def template_text(name: str) -> str:
    """Return a file that stands beside the templates of pages and is none, such as live.js."""
    with open(os.path.join(template_folder(), "base", name), encoding="utf-8") as file:
        return file.read()


def layout_names(folder: Folder | None = None) -> tuple[str, ...]:
    """Return the names of kurbel's layouts, and of those in a folder of the user's.

    Raises LayoutError for a folder that has none.
    """
    own = _names(template_folder())
    if folder is None:
        return own
    if not os.fspath(folder):
        raise LayoutError("the folder of layouts has no name; give one, such as pages")
    if not os.path.isdir(folder):
        raise LayoutError(f"cannot read the layouts {folder}: there is no such folder")
    if not (theirs := _names(folder)):
        raise LayoutError(f"{folder} has no layouts: no folder in it has a layout.toml")
    for name in theirs:
        if not re.fullmatch(_NAME, name):
            file = layout_file(folder, name)
            raise LayoutError(f"{file}: the folder {name[:60]} names the layout; use letters, digits and -")
    return tuple(sorted({*own, *theirs}))


def _names(folder: Folder) -> tuple[str, ...]:
    try:
        names = sorted(os.listdir(folder))
    except OSError as error:
        raise LayoutError(f"cannot read the layouts {folder}: {error.strerror}") from None
    return tuple(name for name in names if os.path.exists(layout_file(folder, name)))


def layout_file(folder: Folder, name: str) -> Folder:
    """Return where the layout of that name in a folder is described."""
    file = os.path.join(str(folder), name, "layout.toml")
    return folder.named(file) if isinstance(folder, File) else file


def layout_of(name: str, subjects: Sequence[str], folder: Folder | None = None) -> Layout:
    """Return the layout of that name if it is about one of the subjects; `folder` is as in `layout`."""
    page = layout(name, folder)
    if page.subject not in subjects:
        fitting = [other for other in layout_names(folder) if layout(other, folder).subject in subjects]
        raise ChoiceError(f"layout {name} is about something else; choose from {', '.join(fitting)}")
    return page


def layout(name: str, folder: Folder | None = None) -> Layout:
    """Return the layout of that name; an unknown name is answered with the nearest and the list.

    `folder` is one of the user's, whose layouts stand beside kurbel's own and outdo those of their names.
    Raises LayoutError with file and line for one that cannot be used.
    """
    if folder is None:
        return _own(name)
    if not os.path.exists(layout_file(folder, choose(name, layout_names(folder), "layout"))):
        return Layout(**vars(_own(name)) | {"folder": os.path.abspath(folder)})
    from kurbel.page.layout_check import check

    file = TomlFile(layout_file(folder, name), KIND)
    given = vars(file.read(LayoutFile))
    columns = dict(placed(given["columns"]))
    page = Layout(name, os.path.abspath(folder), **given | {"columns": tuple(columns.values())})
    check(file, page, columns)
    return page


@cache
def _own(name: str) -> Layout:
    import tomllib

    file = layout_file(template_folder(), choose(name, layout_names(), "layout"))
    with open(file, "rb") as stream:
        return Layout(key=name, **_values(tomllib.load(stream)))


def _values(given: Mapping[str, object]) -> dict[str, Any]:
    """Return what a file of kurbel's own says, as by its model; to load msgspec costs as much as a page."""
    return {key: _READ.get(key, _plain)(value) for key, value in given.items()}


def _plain(value: object) -> object:
    return tuple(value) if isinstance(value, list) else value


def _heads(given: Sequence[object]) -> tuple[Words, ...]:
    return tuple(Head.read(one, "") for one in given)


_READ: Mapping[str, Callable[[Any], object]] = {
    "columns": lambda given: tuple(dict(placed([LayoutColumn(**_values(one)) for one in given])).values()),
    "notes": lambda given: Notes.read(given, ""),
    "stub_headings": lambda given: dict(zip(given, _heads([*given.values()]), strict=True)),
    **dict.fromkeys(("title", "caption", "source"), lambda given: Head.read(given, "")),
    **dict.fromkeys(("spanners", "heading"), _heads),
}
