"""The model of a handbook's manifest: its keys, the types of their values, and the JSON Schema of both."""

from __future__ import annotations

import hashlib
import json
import os
import re
from collections.abc import Iterable, Mapping
from datetime import date, datetime
from functools import cache
from typing import Annotated, Any, ClassVar, Self
from unicodedata import category, combining, normalize

from msgspec import Meta, Struct

from kurbel.errors import HandbookError, LayoutError
from kurbel.exact.numerals import DECIMALS
from kurbel.formats.registry import FORMATS, compiled_format
from kurbel.page.labels import Mark, parse
from kurbel.page.layouts import LANGUAGES
from kurbel.reading.toml_file import A_TEXT, Fault, TextChoice, about, within

SCHEMA = "handbook.schema.json"
COMPILED = compiled_format()
LONGEST_NAME = 60


@cache
def default_options() -> tuple[str, ...]:
    """Return the options for which there may be defaults, as the published schema lists them.

    To ask the commands themselves would take the time in which a handbook without changes is done.
    """
    with open(os.path.join(os.path.dirname(__file__), SCHEMA), encoding="utf-8") as file:
        return tuple(json.load(file)["properties"]["defaults"]["properties"])


FORMATS_OF_A_HANDBOOK = sorted(
    (name for name, form in FORMATS.items() if form.usual),
    key=lambda name: (FORMATS[name].kind == "records", name),
)


class Lang(TextChoice, what="language", allowed=LANGUAGES):
    """A language of a handbook or of a part of it."""


class Decimal(TextChoice, what="decimal mark", allowed=DECIMALS):
    """A decimal mark."""


class Choices(tuple[str, ...]):
    """Texts that must be some of a few."""

    one: ClassVar[type[TextChoice]]
    SCHEMA: ClassVar[Mapping[str, object]]

    def __init_subclass__(cls, what: str, allowed: Iterable[str]) -> None:
        cls.one = type(what, (TextChoice,), {}, what=what, allowed=allowed)
        cls.SCHEMA = {"type": "array", "items": cls.one.SCHEMA}

    @classmethod
    def read(cls, given: object, name: str) -> Self:
        if not isinstance(given, list) or not all(isinstance(one, str) for one in given):
            raise Fault("a list of texts")
        # Plain texts go to other processes.
        return cls(str(cls.one.read(one, name)) for one in given)


class Formats(Choices, what="format", allowed=FORMATS):
    """What is built."""


class Standards(Choices, what="standard", allowed=COMPILED.standards):
    """What a PDF keeps."""


class ProblemContent(TextChoice, what="part of problems", allowed=("both", "problems", "solutions")):
    """What is printed of problems."""


class Matter(Choices, what="matter of a book", allowed=("notation", "symbols", "index", "colophon")):
    """What a book has before and behind its chapters."""


class Day(date):
    """A day, as 2026-11-22."""

    SCHEMA: ClassVar[Mapping[str, object]] = {"type": "string", "format": "date"}

    @classmethod
    def read(cls, given: object, name: str) -> Day:
        try:
            day = date.fromisoformat(given) if isinstance(given, str) else given
        except ValueError:
            day = None
        if not isinstance(day, date) or isinstance(day, datetime):
            raise Fault("a day, such as 2026-11-22")
        return cls(day.year, day.month, day.day)


class Heading(str):
    """A text in which formulas stand between dollar signs."""

    SCHEMA: ClassVar[Mapping[str, object]] = {"type": "string"}

    @classmethod
    def read(cls, given: object, name: str) -> Heading:
        if not isinstance(given, str):
            raise Fault(A_TEXT)
        if control := next((one for one in given if category(one) == "Cc"), ""):
            raise LayoutError(
                f"{name} has the character U+{ord(control):04X}, which is a control and not printed"
            )
        try:
            marks = [part.text for part in parse(given) if isinstance(part, Mark)]
        except LayoutError as error:
            raise LayoutError(str(error).replace("the label", f"the {name}", 1)) from None
        if marks:
            raise LayoutError(f"{name} has the mark [^{marks[0]}], for which there is no note")
        return cls(given)


class InnerPath(str):
    """A path to something in the manifest's folder."""

    SCHEMA: ClassVar[Mapping[str, object]] = {"type": "string"}

    @classmethod
    def read(cls, given: object, name: str) -> InnerPath:
        if not isinstance(given, str):
            raise Fault(A_TEXT)
        parts = given.replace("\\", "/").split("/")
        if not given.strip() or os.path.isabs(given) or ".." in parts or ":" in parts[0] or "\0" in given:
            raise HandbookError(
                f'{name} is "{given[:60]}"; it must be a path inside of the manifest\'s folder,'
                " without .. and without a root"
            )
        plain = "/".join(part for part in parts if part not in ("", "."))
        if not plain:
            raise HandbookError(f"{name} is the manifest's own folder; name one inside of it")
        return cls(plain)


LANGUAGE = about("language: de or en")
Language = Annotated[Lang | None, LANGUAGE]
Defaults = Annotated[
    dict[str, Any], about("options for every table of it that has them, as on the command line")
]


class PartKeys(Struct, frozen=True, forbid_unknown_fields=True):
    NOUN: ClassVar = "key of the part"
    SHAPE: ClassVar = "a section"

    run: Annotated[
        str | None,
        about('a command that prints a table or draws: "table --ratio 1:5", "table --ratio 1:5 -f drawing"'),
    ] = None
    text: Annotated[str | None, about("a text in Markdown")] = None
    file: Annotated[InnerPath | None, about("a file with a text in Markdown")] = None
    problems: Annotated[InnerPath | None, about("a file of problems, with the commands that answer them")] = (
        None
    )
    shows: Annotated[
        ProblemContent | None, about("of problems: both, problems or solutions; default: both")
    ] = None
    variant: Annotated[
        Annotated[int, within(1, 1000)] | None, about("of problems: which of their variants; default: 1")
    ] = None
    name: Annotated[str | None, about("name for references and files; default: from the command")] = None
    caption: Annotated[
        Heading | None,
        about("caption in place of the command's own, with formulas between dollar signs"),
    ] = None
    lang: Language = None


ONE_OF = [{"required": [key]} for key in ("run", "text", "file", "problems")]


class ChapterKeys(Struct, frozen=True, forbid_unknown_fields=True):
    NOUN: ClassVar = "key of the chapter"
    SHAPE: ClassVar = "a section"

    title: Annotated[Heading, about("title, with formulas between dollar signs")] = Heading()
    name: Annotated[str | None, about("name for references and files; default: from the title")] = None
    lang: Language = None
    defaults: Defaults = {}
    part: Annotated[
        tuple[Annotated[PartKeys, Meta(extra_json_schema={"oneOf": ONE_OF})], ...],
        about("texts, tables and figures, in their order"),
    ] = ()


class PdfKeys(Struct, frozen=True, forbid_unknown_fields=True):
    NOUN: ClassVar = "key of [pdf]"
    GONE: ClassVar = {"engine": "Typst sets the PDF; for that of a TeX, let it compile handbook.tex"}
    SHAPE: ClassVar = "a section"

    standards: Annotated[Standards, about("standards that the PDF keeps")] = Standards()


class HandbookKeys(Struct, frozen=True, forbid_unknown_fields=True):
    NOUN: ClassVar = "key of the handbook"

    title: Annotated[Heading, about("title, with formulas between dollar signs")] = Heading()
    subtitle: Annotated[Heading, about("line below the title")] = Heading()
    author: Annotated[Heading, about("author, below the title")] = Heading()
    lang: Annotated[Lang, LANGUAGE] = Lang(LANGUAGES[0])
    decimal: Annotated[Decimal | None, about("decimal mark: comma or point; default: by the language")] = None
    version: Annotated[Heading, about("version of the handbook, for the colophon")] = Heading()
    date: Annotated[Day | None, about("its day, for the colophon; default: that of SOURCE_DATE_EPOCH")] = None
    matter: Annotated[
        Matter,
        about(
            "what stands before and behind the chapters: notation and signs, symbols, an index, a colophon"
        ),
    ] = Matter()
    verify: Annotated[
        bool,
        about("compute the numbers of all tables a second time, as kurbel verify does; see the colophon"),
    ] = False
    formats: Annotated[Formats, about("what is built")] = Formats(FORMATS_OF_A_HANDBOOK)
    output: Annotated[InnerPath, about("folder for what is built, inside of the manifest's folder")] = (
        InnerPath("pages")
    )
    machine: Annotated[InnerPath | None, about("machine's file, for every command that takes --machine")] = (
        None
    )
    templates: Annotated[InnerPath | None, about("folder with templates of one's own")] = None
    layouts: Annotated[InnerPath | None, about("folder with layouts of one's own")] = None
    pdf: Annotated[PdfKeys, about("how the PDF is made")] = PdfKeys()
    defaults: Defaults = {}
    chapter: Annotated[tuple[ChapterKeys, ...], about("chapters")] = ()


SECTIONS: Mapping[str, type[Struct]] = {
    "handbook": HandbookKeys,
    "pdf": PdfKeys,
    "chapter": ChapterKeys,
    "part": PartKeys,
}


_NAME = re.compile(r"[A-Za-z0-9]+(?:-+[A-Za-z0-9]+)*")
# Names that are devices where Windows reads the files.
_DEVICES = frozenset(
    ("con", "prn", "aux", "nul", *(f"{one}{n}" for one in ("com", "lpt") for n in range(1, 10)))
)
_LETTERS = str.maketrans(
    {"ä": "ae", "ö": "oe", "ü": "ue", "ß": "ss", "λ": "lambda", "φ": "phi", "δ": "delta"}
)


def is_file_name(name: str) -> bool:
    """Tell whether files may be called so."""
    return bool(_NAME.fullmatch(name)) and len(name) <= LONGEST_NAME and name.lower() not in _DEVICES


def slug(text: str) -> str:
    """Return a name for files and labels: "delta --eps 2..6" -> "delta-eps-2-6".

    A long one is cut and ends with a few digits that tell it from others.
    """
    plain = normalize("NFKD", text.lower().translate(_LETTERS))
    name = re.sub(r"[^a-z0-9]+", "-", "".join(one for one in plain if not combining(one))).strip("-")
    if 0 < len(name) <= LONGEST_NAME - 20:
        return name
    tail = hashlib.sha256(text.encode()).hexdigest()[:6]
    return f"{name[: LONGEST_NAME - 20].rstrip('-')}-{tail}".lstrip("-")
