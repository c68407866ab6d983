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

A part is a text in Markdown, what a command prints or draws, or problems. `kurbel.handbook.model` has
its keys.
"""

from __future__ import annotations

import os
import shlex
from collections.abc import Iterator, Mapping, Sequence
from importlib.util import find_spec
from typing import NamedTuple

from msgspec.structs import asdict

from kurbel.errors import HandbookError, OutputError, OutsideError
from kurbel.formats.render import whole_file
from kurbel.handbook.model import (
    LONGEST_NAME,
    ChapterKeys,
    HandbookKeys,
    PartKeys,
    default_options,
    is_file_name,
    slug,
)
from kurbel.handbook.problems import problems_of
from kurbel.reading.given import HANDBOOK, is_inside
from kurbel.reading.names import did_you_mean
from kurbel.reading.toml_file import Place, TomlFile, TomlKind, shown

NAME = "handbook.toml"
KIND = TomlKind("handbook", HandbookError, 2_000_000, "a handbook has chapters with parts", "appendix/")
MOST_PARTS = 10_000
_OF_A_TEXT = dict.fromkeys(("name", "caption"), "for tables and figures, and this part is a text")
_OF_PROBLEMS = dict.fromkeys(("shows", "variant"), "for problems, and this part has none")
# What is said of keys that do not go with what a part has.
FOREIGN = {
    "run": _OF_PROBLEMS,
    "text": _OF_A_TEXT | _OF_PROBLEMS,
    "file": _OF_A_TEXT | _OF_PROBLEMS,
    "problems": {"caption": "for a table or a figure by itself; those of problems have their commands'"},
}


class Part(NamedTuple):
    """A text (of the manifest, or of a file) or a command's words; `options` are its defaults.

    `problems` is the file of problems that it is of.
    """

    line: int
    name: str = ""
    words: tuple[str, ...] = ()
    text: str = ""
    file: str = ""
    caption: str = ""
    problems: str = ""
    options: Mapping[str, object] = {}

    @property
    def shown(self) -> str:
        """The command as it would be typed."""
        return shlex.join(("kurbel", *self.words))


class ChapterPlan(NamedTuple):
    title: str
    name: str
    lang: str
    parts: tuple[Part, ...]


class Manifest(HandbookKeys, frozen=True, kw_only=True):
    """All that the file says; `path` is as it was given.

    Files that it names may lie `outside` of its folder where that is allowed.
    """

    path: str
    chapters: tuple[ChapterPlan, ...]
    outside: bool

    @property
    def folder(self) -> str:
        return os.path.dirname(self.path) or "."

    def parts(self) -> Iterator[Part]:
        for chapter in self.chapters:
            yield from chapter.parts


def manifest_path(given: str) -> str:
    """Return the manifest's file for a folder or for the file itself."""
    return os.path.normpath(os.path.join(given, NAME) if os.path.isdir(given) else given)


class ManifestError(HandbookError):
    """All mistakes of a manifest, each a sentence."""

    def __init__(self, mistakes: Sequence[str]) -> None:
        super().__init__("\n".join(mistakes))
        self.mistakes = mistakes


def read_manifest(path: str, outside: bool = False) -> Manifest:
    """Return what the file says; with `outside` the files that it names may lie anywhere.

    Raises ManifestError with file, line, what is allowed and the nearest name of each mistake.
    """
    if not os.path.lexists(path):
        folder, name = os.path.split(path) if path.endswith(".toml") else (path, "folder")
        where = (
            f"there is no {name} {folder}" if name == "folder" else f"{folder or 'this folder'} has no {name}"
        )
        raise HandbookError(
            f"{where}; kurbel handbook init{f' {folder}' if folder else ''} writes a first one"
        )
    reader = _Reader(TomlFile(path, KIND), outside)
    manifest = reader.manifest()
    if reader.mistakes:
        raise ManifestError([said for _, said in sorted(reader.mistakes, key=lambda one: one[0])])
    return manifest


class _Reader:
    """Reads one file, knows where its keys stand, and notes all mistakes."""

    def __init__(self, file: TomlFile, outside: bool) -> None:
        self.file = file
        self.outside = outside
        self.line = file.line
        self.mistakes: list[tuple[int, str]] = []
        # Sections of which a key is left out: what they lack may be that.
        self.torn: set[Place] = set()
        # A chapter may be called as its table is: their labels begin otherwise.
        self.chapter_names: dict[str, int] = {}
        self.part_names: dict[str, int] = {}

    def wrong(self, place: Place, said: object) -> None:
        """Note a mistake."""
        self.mistakes.append((self.line(place), str(self.file.error(place, said))))

    def lacking(self, section: Place, said: str, key: str = "") -> None:
        """Note what a section lacks, unless that is among its mistakes."""
        if section not in self.torn:
            self.wrong((*section, key), said)

    def manifest(self) -> Manifest:
        given, faults = self.file.read_rest(HandbookKeys)
        for place, said in faults:
            self.wrong(place, said)
            self.torn.add(place[:-1])
        if not given.title.strip():
            self.lacking((), 'the handbook has no title; write title = "..." at the top', "title")
        defaults: dict[str, object] = {"lang": given.lang, "decimal": given.decimal, "layouts": given.layouts}
        defaults = {name: value for name, value in defaults.items() if value is not None}
        defaults |= self.options(("defaults",), given.defaults)
        self.check_apart("layouts", given.layouts, given.output)
        self.check_apart("templates", given.templates, given.output)
        # They are names of pages, as those of chapters are.
        self.chapter_names |= dict.fromkeys(given.matter, self.line(("matter",)))
        chapters = tuple(self.chapters(given.chapter, defaults))
        if not chapters:
            self.lacking((), "the handbook has no chapter; write [[chapter]] and below it its title")
        if sum(len(chapter.parts) for chapter in chapters) > MOST_PARTS:
            self.wrong((), f"the handbook has more than {MOST_PARTS} parts; make two of it")
        once = {"formats": tuple(dict.fromkeys(given.formats)), "outside": self.outside}
        return Manifest(path=os.fspath(self.file.path), chapters=chapters, **asdict(given) | once)

    def check_apart(self, key: str, own: str | None, output: str) -> None:
        """Note a folder that lies in that of the output, or that in it."""
        if own and (f"{output}/".startswith(f"{own}/") or f"{own}/".startswith(f"{output}/")):
            self.wrong((key,), f"{key} {own} and output {output} lie in one another; part them")

    def chapters(self, given: Sequence[ChapterKeys], defaults: Mapping[str, object]) -> Iterator[ChapterPlan]:
        for number, one in enumerate(given):
            place: Place = ("chapter", number)
            name = one.name or slug(one.title)
            if one.title.strip():
                self.check_name((*place, "name"), name, self.chapter_names)
            else:
                self.lacking(place, 'a chapter has no title; write title = "..."')
            own = {**defaults, "lang": one.lang or defaults["lang"]}
            own |= self.options((*place, "defaults"), one.defaults)
            yield ChapterPlan(one.title, name, str(own["lang"]), tuple(self.parts(place, one.part, own)))

    def parts(
        self, chapter: Place, given: Sequence[PartKeys], defaults: Mapping[str, object]
    ) -> Iterator[Part]:
        for number, one in enumerate(given):
            place: Place = (*chapter, "part", number)
            contents = [key for key in ("run", "text", "file", "problems") if getattr(one, key) is not None]
            if len(contents) != 1:
                found = " and ".join(contents) or "none of them"
                self.lacking(
                    place, f"a part has one of run, text, file and problems, and this one has {found}"
                )
                continue
            options = {**defaults, "lang": one.lang or defaults["lang"]}
            for key in (key for key in FOREIGN[contents[0]] if getattr(one, key) is not None):
                self.wrong((*place, key), f"{key} is {FOREIGN[contents[0]][key]}")
            if one.run is not None:
                yield from self.table(place, one.run, one, options)
            elif one.problems is not None:
                yield from self.problems(place, one.problems, one, options)
            else:
                line = self.line((*place, contents[0]))
                yield Part(line, text=one.text or "", file=one.file or "", options=options)

    def problems(
        self, place: Place, inside: str, given: PartKeys, options: Mapping[str, object]
    ) -> Iterator[Part]:
        """Yield the texts of problems, and the pages that answer them."""
        line = self.line((*place, "problems"))
        path = os.path.join(os.path.dirname(self.file.path), inside)
        mark = {"comma": ",", "point": "."}.get(str(options.get("decimal")), "")
        if not self.outside and not is_inside(path, os.path.dirname(self.file.path)):
            self.wrong((*place, "problems"), OutsideError(inside, HANDBOOK))
            return
        try:
            problems = [*problems_of(path, str(options["lang"]), given.variant or 1, mark)]
        except HandbookError as error:
            self.mistakes.append((line, str(error)))
            return
        for one in problems:
            if given.shows != "solutions":
                yield Part(line, text=one.posed, problems=inside, options=options)
            if given.shows != "problems":
                yield Part(line, text=one.solved, problems=inside, options=options)
                name = f"{given.name}-{one.name}" if given.name else one.name
                self.check_name((*place, "problems"), name, self.part_names)
                yield Part(line, name, one.words, problems=inside, options=options)

    def table(self, place: Place, run: str, given: PartKeys, options: Mapping[str, object]) -> Iterator[Part]:
        place_of_run = (*place, "run")
        try:
            words = tuple(shlex.split(run))
        except ValueError:
            self.wrong(place_of_run, "run has a quotation mark without its partner")
            return
        words = words[1:] if words[:1] == ("kurbel",) else words
        if not words:
            self.wrong(place_of_run, 'run is empty; write a command, such as run = "table --ratio 1:5"')
            return
        name = given.name or slug(" ".join(words))
        self.check_name((*place, "name"), name, self.part_names)
        yield Part(self.line(place_of_run), name, words, caption=given.caption or "", options=options)

    def check_name(self, place: Place, name: str, taken: dict[str, int]) -> None:
        """Note a name by which no files may be called, or which something else has."""
        if not is_file_name(name):
            self.wrong(
                place,
                f'the name "{name[:40]}" cannot be that of a file; it may have letters from a to z, digits'
                f" and hyphens, {LONGEST_NAME} at the most",
            )
        elif name.lower() in taken:
            self.wrong(
                place,
                f'the name "{name}" is taken in line {taken[name.lower()]};'
                ' give one of the two another with name = "..."',
            )
        else:
            taken[name.lower()] = self.line(place)

    def options(self, place: Place, given: Mapping[str, object]) -> dict[str, object]:
        """Return defaults of options by their names, with underscores."""
        options = {}
        for key, value in given.items():
            here = (*place, key)
            name, known = key.replace("_", "-"), default_options()
            values = value if isinstance(value, list) else [value]
            if name not in known:
                self.wrong(
                    here,
                    f'there is no option for which there are defaults "{name[:60]}"'
                    f"{did_you_mean(name, known)}; the help of each command lists its options",
                )
            elif not values or not all(isinstance(one, str | int | float) for one in values):
                self.wrong(here, f"{key} is {shown(value)}; it must be a text, a number or a list of them")
            else:
                options[name.replace("-", "_")] = value
        return options


_TEXTS = {
    "de": {
        "title": "Tafeln des Kurbeltriebs",
        "motion": "Kolbenbewegung",
        "intro": "Der Kolbenweg $x$ zählt vom Totpunkt. [](#kolbenbewegung) gilt für $R:L = 1:5$.",
        "table": "kolbenbewegung",
        "figure": "beschleunigung",
        "engine": "Dampfmaschine",
        "delta": "ungleichfoermigkeit",
        "books": "Bücher",
    },
    "en": {
        "title": "Tables of the crank drive",
        "motion": "Motion of the piston",
        "intro": "The piston's path $x$ counts from the dead centre. [](#motion) is for $R:L = 1:5$.",
        "table": "motion",
        "figure": "acceleration",
        "engine": "Steam engine",
        "delta": "irregularity",
        "books": "Books",
    },
}


def write_first_manifest(folder: str, lang: str) -> str:
    """Write a manifest in the language into a folder, which is made, and return its path."""
    path = os.path.join(folder, NAME)
    if os.path.lexists(path):
        raise HandbookError(f"{path} is there already; kurbel handbook build builds it")
    try:
        os.makedirs(folder, exist_ok=True)
    except OSError as error:
        raise OutputError(f"cannot make the folder {folder}: {error.strerror}") from error
    with whole_file(path) as stream:
        stream.write(first_manifest(lang).encode())
    return path


def first_manifest(lang: str) -> str:
    """Return the text of a manifest in the language; what needs an extra that is missing is commented out."""
    plot, pdf = find_spec("matplotlib") is not None, find_spec("typst") is not None
    with open(os.path.join(os.path.dirname(__file__), "first_manifest.txt"), encoding="utf-8") as file:
        manifest = file.read()
    return manifest.format(
        lang=lang,
        pdf='"pdf", ' if pdf else "",
        pdf_hint="" if pdf else "# \"pdf\" needs an extra; in kurbel's checkout: pip install '.[pdf]'\n",
        hash="" if plot else "# ",
        figure_hint="" if plot else "\n# Drawings need an extra; in kurbel's checkout: pip install '.[plot]'",
        **_TEXTS[lang],
    )
