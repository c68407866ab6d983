"""TOML files that users write: read whole, with the lines of their keys for sentences about what is amiss."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, ClassVar, NamedTuple, Self, TypeAlias, TypeVar

from kurbel.errors import KurbelError
from kurbel.reading.given import allowed_name

if TYPE_CHECKING:
    from msgspec import Meta

Place: TypeAlias = tuple[str | int, ...]
Model = TypeVar("Model")
A_TEXT = "a text in quotation marks"
# Python writes out no whole number of more than 4,300 digits.
MOST_BITS = 4000


class TomlKind(NamedTuple):
    """What a file is called, what is wrong with it, how large it may be, what it has, and a name for one."""

    name: str
    error: type[KurbelError]
    largest: int
    shape: str
    example: str


class Fault(KurbelError):
    """What a value must be; the sentence has its name and the value before that."""


def about(text: str, example: object = None, schema: dict[str, object] | None = None) -> Meta:
    """Return what is said of a field, to editors too, an example of it, and its JSON Schema where its type
    does not say it."""
    from msgspec import Meta

    examples = None if example is None else [example]
    return Meta(description=text, examples=examples, extra_json_schema=schema)


def within(least: int, most: int) -> Meta:
    """Return the bounds of a whole number."""
    from msgspec import Meta

    return Meta(ge=least, le=most)


class TextChoice(str):
    """A text that must be one of a few."""

    what: ClassVar[str]
    allowed: ClassVar[Sequence[str]]
    SCHEMA: ClassVar[Mapping[str, object]]

    def __init_subclass__(cls, what: str, allowed: Iterable[str]) -> None:
        cls.what, cls.allowed = what, [*allowed]
        cls.SCHEMA = {"type": "string", "enum": cls.allowed}

    @classmethod
    def read(cls, given: object, _: str) -> Self:
        if not isinstance(given, str):
            raise Fault(A_TEXT)
        return cls(allowed_name(given, cls.allowed, cls.what))


class TomlFile:
    """A file that was read: its text, what it says, and where."""

    def __init__(self, path: str | os.PathLike[str], kind: TomlKind) -> None:
        self.path = path
        self.kind = kind
        self.text = _text_of(path, kind)
        self.given = _parsed(path, kind, self.text)

    @cached_property
    def lines(self) -> Mapping[Place, int]:
        """The lines of the keys; of what is only written part by part, as a.b, that of the first."""
        lines = key_lines(self.text)
        for place, line in [*lines.items()]:
            for end in range(1, len(place)):
                lines.setdefault(place[:end], line)
        return lines

    def line(self, place: Place) -> int:
        """Return the line of a key or, where it has none, of what it lies in."""
        while place and place not in self.lines:
            place = place[:-1]
        return self.lines.get(place, 1)

    def error(self, place: Place, said: object) -> KurbelError:
        """Return the kind's error with the file, the line of the place, and what is to be said."""
        return self.kind.error(f"{self.path}, line {self.line(place)}: {said}")

    def read(self, model: type[Model]) -> Model:
        """Return what the file says as its model; raise the kind's error for the first thing amiss."""
        from kurbel.reading.toml_model import read_model

        return read_model(self, model)

    def read_rest(self, model: type[Model]) -> tuple[Model, list[tuple[Place, str]]]:
        """Return the model of all that is right, and of what is amiss the places and the sentences."""
        from kurbel.reading.toml_model import read_rest

        return read_rest(self, model)


def _parsed(path: str | os.PathLike[str], kind: TomlKind, text: str) -> dict[str, object]:
    """Return what the text of the file says."""
    import tomllib

    if re.search(_LONG_KEY, text):
        raise kind.error(f"{path} has a key of very many parts; {kind.shape}")
    try:
        return tomllib.loads(text)
    except RecursionError:
        raise kind.error(f"{path} is nested too deeply; {kind.shape}") from None
    except ValueError as error:
        # A malformed file is a ValueError that says the line.
        line = int(found[1]) if (found := re.search(r"at line (\d+)", str(error))) else 0
        if line and (bare := re.fullmatch(_BARE, text.split("\n")[line - 1])):
            name, value = bare.groups()
            written = value.lower() if value in ("True", "False") else f'"{value}"'
            said = "" if written[0] != '"' else ", without quotes"
            raise kind.error(
                f"{path}, line {line}: {name} is {value}{said}; write {name} = {written}"
            ) from None
        raise kind.error(f"cannot read the {kind.name} {path}: {error}") from None


# A value that is a text and stands without its quotes, such as 1:5 or 600mm, perhaps before a comment.
_BARE = r"\s*([\w-]{1,40})\s*=\s*([^\s\"'\[{#][^\"'\\#]{0,60}?)\s*(?:#.*)?"
# The parser takes minutes over them.
_LONG_KEY = r"(?:[A-Za-z0-9_\"'-]{1,50}[ \t]{0,9}\.[ \t]{0,9}){200}"


def _text_of(path: str | os.PathLike[str], kind: TomlKind) -> str:
    """Return the text of the file."""
    if not os.fspath(path):
        raise kind.error(f"the {kind.name}'s file has no name; give one, such as {kind.example}")
    if os.path.exists(path) and not os.path.isfile(path):
        raise kind.error(
            f"cannot read the {kind.name} {path}: it is a directory or a device; name a TOML file"
        )
    try:
        with open(path, "rb") as file:
            content = file.read(kind.largest + 1)
    except FileNotFoundError:
        raise kind.error(f"cannot read the {kind.name} {path}: there is no such file") from None
    except (OSError, ValueError) as error:
        said = getattr(error, "strerror", None) or error
        raise kind.error(f"cannot read the {kind.name} {path}: {said}") from None
    if len(content) > kind.largest:
        raise kind.error(f"{path} has more than {kind.largest} bytes; no {kind.name} needs them")
    try:
        # An editor may have put a mark before the text.
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        raise kind.error(
            f"{path}, line {line}: the byte 0x{content[error.start]:02x} is not UTF-8;"
            f" save the {kind.name} so"
        ) from None


def shown(value: object) -> str:
    """What a value is, in the words of a TOML file."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, dict):
        return "a table"
    if isinstance(value, list):
        return "a list" if value else "an empty list"
    if isinstance(value, int) and value.bit_length() > MOST_BITS:
        return "a number of very many digits"
    return f'"{value}"'[:42] if isinstance(value, str) else str(value)[:40]


# Possessive quantifiers, which Python 3.11 brought, match wrongly before 3.11.5; loops unrolled do without.
_TOKEN = (
    r'(?P<text>"""[^"\\]*(?:(?:\\.|"(?!""))[^"\\]*)*"{3,5}|\'\'\'[^\']*(?:\'(?!\'\')[^\']*)*\'{3,5}'
    r'|"[^"\\\n]*(?:\\.[^"\\\n]*)*"|\'[^\'\n]*\')'
    r"|(?P<mark>\[|\]|\{|\}|,|=|\.|\n)"
    r"|(?P<word>[^\s\"'\[\]{},=.#]+)"
    r"|#[^\n]*"
)


def key_lines(text: str) -> dict[Place, int]:
    """Return the line, from 1, of each key, section and entry of a list, of a file that was read.

    The place of a key is its path: ("chapter", 0, "part", 2, "run").
    """
    return _Lines(text).lines


class _Lines:
    """Goes through the tokens of a file once."""

    def __init__(self, text: str) -> None:
        self.lines: dict[Place, int] = {}
        self.counts: dict[Place, int] = {}
        self.tokens = _tokens(text)
        self.line, self.token = 1, "\n"
        section: Place = ()
        while self.token:
            if self.token == "[":
                section = self.section()
            elif self.token == "\n":
                self.step()
            else:
                self.entry(section)

    def step(self) -> str:
        """Go on to the next token, which is nothing at the end, and return the one left."""
        left = self.token
        self.line, self.token = next(self.tokens, (self.line, ""))
        return left

    def section(self) -> Place:
        """Return the place that [a.b] or [[a.b]] opens; in a list of sections, with its number."""
        line = self.line
        self.step()
        several = self.token == "["
        if several:
            self.step()
        names = self.names("]")
        self.step()
        place: Place = ()
        for number, name in enumerate(names, 1):
            place += (name,)
            if number == len(names) and several:
                self.counts[place] = self.counts.get(place, -1) + 1
            if place in self.counts:
                place += (self.counts[place],)
        self.lines[place] = line
        return place

    def names(self, end: str) -> list[str]:
        """Return the parts of a key up to the mark behind it, and step over that."""
        names = []
        while self.token not in (end, ""):
            if (token := self.step()) not in (".", "\n"):
                names.append(token.strip("\"'"))
        self.step()
        return names

    def entry(self, section: Place) -> None:
        """Note a key and what its value has."""
        line = self.line
        place = (*section, *self.names("="))
        self.lines.setdefault(place, line)
        self.value(place)

    def value(self, place: Place) -> None:
        if self.token == "[":
            self.step()
            index = 0
            while self.token not in ("]", ""):
                if self.token == ",":
                    index += 1
                if self.token in (",", "\n"):
                    self.step()
                    continue
                self.lines[*place, index] = self.line
                self.value((*place, index))
            self.step()
        elif self.token == "{":
            self.step()
            while self.token not in ("}", ""):
                if self.token in (",", "\n"):
                    self.step()
                else:
                    self.entry(place)
            self.step()
        else:
            while self.token not in (",", "]", "}", "\n", ""):
                self.step()


def _tokens(text: str) -> Iterator[tuple[int, str]]:
    """Yield the tokens, but for comments, each with the line that it begins in."""
    line, counted = 1, 0
    for found in re.finditer(_TOKEN, text, re.DOTALL):
        if found.lastgroup:
            line += text.count("\n", counted, found.start())
            counted = found.start()
            yield line, found[0]
