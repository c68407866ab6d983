"""The manifest of a handbook, handbook.toml: what it says, checked, with defaults handed down.

    title = "Tafeln des Kurbeltriebs"
    formats = ["latex", "html", "pdf", "csv"]

    [defaults]
    ratio = "1:5"

    [[chapter]]
    title = "Kolbenbewegung"

    [[chapter.part]]
    text = "Der Kolbenweg $x$ zählt vom Totpunkt."

    [[chapter.part]]
    run = "table --step 15"
    name = "kolbenbewegung"

A part is a text in Markdown or what a command prints or draws. `handbook_keys.schema` describes the file
for editors.
"""

from __future__ import annotations

import hashlib
import os
import re
import shlex
import unicodedata
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from kurbel.errors import ChoiceError, HandbookError, LayoutError
from kurbel.formats.registry import FORMATS
from kurbel.handbook.keys import ENGINES, KEYS, Key, default_options
from kurbel.page.labels import Mark, parse
from kurbel.page.layouts import LANGUAGES
from kurbel.reading.choices import choose
from kurbel.reading.toml_file import Place, TomlKind, key_lines, parsed, shown, text_of

NAME = "handbook.toml"
KIND = TomlKind("handbook", HandbookError, 2_000_000, "a handbook has chapters with parts", "appendix/")
FORMATS_OF_A_HANDBOOK = tuple(
    sorted(
        (name for name, form in FORMATS.items() if form.usual),
        key=lambda name: (FORMATS[name].kind == "records", name),
    )
)
MOST_PARTS = 10_000
LONGEST_NAME = 60


class Part(NamedTuple):
    """A text (of the manifest, or of a file) or a command's words; `options` are its defaults."""

    line: int
    name: str = ""
    words: tuple[str, ...] = ()
    text: str = ""
    file: str = ""
    caption: str = ""
    options: Mapping[str, Any] = {}

    @property
    def shown(self) -> str:
        """The command as it would be typed."""
        return shlex.join(("kurbel", *self.words))


class ChapterPlan(NamedTuple):
    title: str
    name: str
    lang: str
    parts: tuple[Part, ...]


class Manifest(NamedTuple):
    """All that the file says; `path` is as it was given."""

    path: str
    title: str
    subtitle: str
    author: str
    lang: str
    decimal: str
    formats: tuple[str, ...]
    output: str
    machine: str | None
    templates: str | None
    engine: str
    standards: tuple[str, ...]
    chapters: tuple[ChapterPlan, ...]

    @property
    def folder(self) -> str:
        return os.path.dirname(self.path) or "."

    def parts(self) -> Iterator[Part]:
        for chapter in self.chapters:
            yield from chapter.parts


def check_engine(engine: str, standards: Sequence[str], templates: str | None) -> None:
    """Raise HandbookError if the engine cannot keep the standards, or would obey templates too well."""
    if standards and ENGINES[engine].source != "typst":
        raise HandbookError(f"{engine} keeps no standards such as {standards[0]}; they are for typst")
    if templates and engine == "lualatex":
        raise HandbookError(
            "lualatex runs whatever programs in Lua templates of one's own write, also into other folders;"
            " set their PDF with typst or latexmk"
        )


def manifest_path(given: str) -> str:
    """Return the manifest's file for a folder or for the file itself."""
    return os.path.normpath(os.path.join(given, NAME) if os.path.isdir(given) else given)


def read_manifest(path: str) -> Manifest:
    """Return what the file says.

    Raises HandbookError with file, line, what is allowed and the nearest name.
    """
    if not os.path.lexists(path):
        raise HandbookError(f"there is no {path}; kurbel handbook init writes a first one")
    text = text_of(path, KIND)
    return _Reader(path, text).manifest(parsed(path, KIND, text))


class _Reader:
    """Reads one file and knows where its keys stand."""

    def __init__(self, path: str, text: str) -> None:
        self.path = path
        self.text = text
        self.lines = key_lines(text)
        # A chapter may be called as its table is: their labels begin otherwise.
        self.chapter_names: dict[str, int] = {}
        self.part_names: dict[str, int] = {}

    def line(self, place: Place) -> int:
        """Return the line of a key or, where it has none, of what it lies in."""
        while place and place not in self.lines:
            # Of a list of sections, the first.
            place = (*place, 0) if (*place, 0) in self.lines else place[:-1]
        return self.lines.get(place, 1)

    def error(self, place: Place, said: object) -> HandbookError:
        return HandbookError(f"{self.path}, line {self.line(place)}: {said}")

    def manifest(self, given: dict[str, Any]) -> Manifest:
        values = self.section("handbook", (), given)
        if not values.get("title", "").strip():
            raise self.error(("title",), 'the handbook has no title; write title = "..." at the top')
        lang = values.get("lang", LANGUAGES[0])
        pdf = values.get("pdf", {})
        defaults = {"lang": lang, **_picked(values, "decimal"), **values.get("defaults", {})}
        chapters = tuple(self.chapters(values.get("chapter", ()), defaults))
        if not chapters:
            raise self.error((), "the handbook has no chapter; write [[chapter]] and below it its title")
        if sum(len(chapter.parts) for chapter in chapters) > MOST_PARTS:
            raise self.error((), f"the handbook has more than {MOST_PARTS} parts; make two of it")
        output = self.inside(("output",), values.get("output", "pages"))
        templates = self.inside(("templates",), values["templates"]) if "templates" in values else None
        if templates and (
            f"{output}/".startswith(f"{templates}/") or f"{templates}/".startswith(f"{output}/")
        ):
            raise self.error(
                ("templates",), f"templates {templates} and output {output} lie in one another; part them"
            )
        return Manifest(
            path=self.path,
            title=values["title"],
            subtitle=values.get("subtitle", ""),
            author=values.get("author", ""),
            lang=lang,
            decimal=values.get("decimal", ""),
            formats=tuple(dict.fromkeys(values.get("formats", FORMATS_OF_A_HANDBOOK))),
            output=output,
            machine=self.inside(("machine",), values["machine"]) if "machine" in values else None,
            templates=templates,
            engine=self.engine(pdf, templates),
            standards=tuple(pdf.get("standards", ())),
            chapters=chapters,
        )

    def engine(self, pdf: Mapping[str, Any], templates: str | None) -> str:
        """Return what sets the PDF; raise HandbookError for one that cannot do what it is to do."""
        engine: str = pdf.get("engine", next(iter(ENGINES)))
        try:
            check_engine(engine, pdf.get("standards", ()), templates)
        except HandbookError as error:
            raise self.error(("pdf", "engine"), error) from None
        return engine

    def chapters(self, given: Sequence[Any], defaults: Mapping[str, Any]) -> Iterator[ChapterPlan]:
        for number, one in enumerate(given):
            place: Place = ("chapter", number)
            values = self.section("chapter", place, one)
            if not values.get("title", "").strip():
                raise self.error(place, 'a chapter has no title; write title = "..."')
            name = values.get("name") or slug(values["title"])
            self.check_name((*place, "name"), name, self.chapter_names)
            own = {**defaults, **_picked(values, "lang"), **values.get("defaults", {})}
            parts = tuple(self.parts(place, values.get("part", ()), own))
            yield ChapterPlan(values["title"], name, own["lang"], parts)

    def parts(self, chapter: Place, given: Sequence[Any], defaults: Mapping[str, Any]) -> Iterator[Part]:
        for number, one in enumerate(given):
            place: Place = (*chapter, "part", number)
            values = self.section("part", place, one)
            contents = [key for key in ("run", "text", "file") if key in values]
            if len(contents) != 1:
                found = " and ".join(contents) or "none of them"
                raise self.error(place, f"a part has one of run, text and file, and this one has {found}")
            if contents == ["run"]:
                yield self.table(place, values, {**defaults, **_picked(values, "lang")})
                continue
            for key in (key for key in values if key not in (*contents, "lang")):
                raise self.error((*place, key), f"{key} is for tables and figures, and this part is a text")
            file = self.inside((*place, "file"), values["file"]) if "file" in values else ""
            options = {**defaults, **_picked(values, "lang")}
            yield Part(
                self.line((*place, contents[0])), text=values.get("text", ""), file=file, options=options
            )

    def table(self, place: Place, values: Mapping[str, Any], options: Mapping[str, Any]) -> Part:
        place_of_run = (*place, "run")
        try:
            words = tuple(shlex.split(values["run"]))
        except ValueError:
            raise self.error(place_of_run, "run has a quotation mark without its partner") from None
        words = words[1:] if words[:1] == ("kurbel",) else words
        if not words:
            raise self.error(place_of_run, 'run is empty; write a command, such as run = "table --ratio 1:5"')
        name = values.get("name") or slug(" ".join(words))
        self.check_name((*place, "name"), name, self.part_names)
        return Part(self.line(place_of_run), name, words, caption=values.get("caption", ""), options=options)

    def check_name(self, place: Place, name: str, taken: dict[str, int]) -> None:
        """Raise HandbookError unless files may be called so and nothing else has the name."""
        if not _NAME.fullmatch(name) or len(name) > LONGEST_NAME or name.lower() in _DEVICES:
            raise self.error(
                place,
                f'the name "{name[:40]}" cannot be that of a file; it may have letters from a to z, digits'
                f" and hyphens, {LONGEST_NAME} at the most",
            )
        if name.lower() in taken:
            raise self.error(
                place,
                f'the name "{name}" is taken in line {taken[name.lower()]};'
                ' give one of the two another with name = "..."',
            )
        taken[name.lower()] = self.line(place)

    def inside(self, place: Place, path: str) -> str:
        """Return a path if it leads to something in the manifest's folder."""
        parts = path.replace("\\", "/").split("/")
        if not path.strip() or os.path.isabs(path) or ".." in parts or ":" in parts[0] or "\0" in path:
            raise self.error(
                place,
                f'{place[-1]} is "{path[:60]}"; it must be a path inside of the manifest\'s folder,'
                " without .. and without a root",
            )
        plain = "/".join(part for part in parts if part not in ("", "."))
        if not plain:
            raise self.error(place, f"{place[-1]} is the manifest's own folder; name one inside of it")
        return plain

    def section(self, name: str, place: Place, given: Any) -> dict[str, Any]:
        """Return a section with its keys and the types of their values checked."""
        if not isinstance(given, dict):
            raise self.error(place, f"{name} is {shown(given)}; it must be a section")
        values = {}
        for key, value in given.items():
            here = (*place, key)
            try:
                choose(key, KEYS[name], f"key of the {name}" if name != "pdf" else "key of [pdf]")
            except ChoiceError as error:
                raise self.error(here, error) from None
            values[key] = self.value(here, KEYS[name][key], value)
        return values

    def value(self, place: Place, key: Key, value: Any) -> Any:
        """Return a value of the type that the key has."""
        match key.kind:
            case "pdf":
                return self.section("pdf", place, value)
            case "options":
                return self.options_of(place, value)
            case "chapters" | "parts":
                if not isinstance(value, list):
                    raise self.error(place, f"{place[-1]} is {shown(value)}; write [[{_dotted(place)}]]")
                return value
            case "texts":
                if not isinstance(value, list) or not all(isinstance(one, str) for one in value):
                    raise self.error(place, f"{place[-1]} is {shown(value)}; it must be a list of texts")
                return [self.one_of(place, key, one) for one in value]
        if not isinstance(value, str):
            raise self.error(place, f"{place[-1]} is {shown(value)}; it must be a text in quotation marks")
        if key.label:
            self.check_label(place, value)
        return self.one_of(place, key, value) if key.allowed else value

    def one_of(self, place: Place, key: Key, value: str) -> str:
        what = {"lang": "language", "decimal": "decimal mark", "formats": "format"}.get(
            str(place[-1]), str(place[-1]).removesuffix("s")
        )
        try:
            return choose(value, key.allowed, what)
        except ChoiceError as error:
            raise self.error(place, error) from None

    def check_label(self, place: Place, text: str) -> None:
        if control := next((one for one in text if unicodedata.category(one) == "Cc"), ""):
            raise self.error(
                place,
                f"{place[-1]} has the character U+{ord(control):04X}, which is a control and not printed",
            )
        try:
            marks = [part.text for part in parse(text) if isinstance(part, Mark)]
        except LayoutError as error:
            raise self.error(place, str(error).replace("the label", f"the {place[-1]}", 1)) from None
        if marks:
            raise self.error(place, f"{place[-1]} has the mark [^{marks[0]}], for which there is no note")

    def options_of(self, place: Place, given: Any) -> dict[str, Any]:
        """Return defaults of options by their names, with underscores."""
        if not isinstance(given, dict):
            raise self.error(place, f"{place[-1]} is {shown(given)}; write [{_dotted(place)}]")
        options = {}
        for key, value in given.items():
            here = (*place, key)
            try:
                name = choose(key.replace("_", "-"), default_options(), "option for which there are defaults")
            except ChoiceError as error:
                raise self.error(here, error) from None
            values = value if isinstance(value, list) else [value]
            if not values or not all(isinstance(one, str | int | float) for one in values):
                raise self.error(
                    here, f"{key} is {shown(value)}; it must be a text, a number or a list of them"
                )
            options[name.replace("-", "_")] = value
        return options


def _picked(values: Mapping[str, Any], key: str) -> dict[str, Any]:
    return {key: values[key]} if key in values else {}


def _dotted(place: Place) -> str:
    return ".".join(part for part in place if isinstance(part, str))


_NAME = re.compile(r"[A-Za-z0-9]+(?:-+[A-Za-z0-9]+)*")
# Names that are devices where Windows reads the files.
_DEVICES = frozenset(
    ("con", "prn", "aux", "nul", *(f"{one}{n}" for one in ("com", "lpt") for n in range(1, 10)))
)
_LETTERS = str.maketrans(
    {"ä": "ae", "ö": "oe", "ü": "ue", "ß": "ss", "λ": "lambda", "φ": "phi", "δ": "delta"}
)


def slug(text: str) -> str:
    """Return a name for files and labels: "delta --eps 2..6" -> "delta-eps-2-6".

    A long one is cut and ends with a few digits that tell it from others.
    """
    plain = unicodedata.normalize("NFKD", text.lower().translate(_LETTERS))
    name = re.sub(r"[^a-z0-9]+", "-", "".join(one for one in plain if not unicodedata.combining(one))).strip(
        "-"
    )
    if 0 < len(name) <= LONGEST_NAME - 20:
        return name
    tail = hashlib.sha256(text.encode()).hexdigest()[:6]
    return f"{name[: LONGEST_NAME - 20].rstrip('-')}-{tail}".lstrip("-")
