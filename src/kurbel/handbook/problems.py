"""Files of problems: texts in both languages, commands that answer them, numbers for several variants.

letter = "F"

[[problem]]
name = "stamping-press"
run = "flywheel --work '{work}' --speed {speed}"
[problem.text]
de = "Eine Presse braucht {work} ..."
en = "A press needs {work} ..."
[problem.values]
work = ["12 kJ", "9.5 kJ"]
speed = "240/min"
"""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator, Mapping
from typing import Annotated, Any, ClassVar, NamedTuple

from msgspec import Struct

from kurbel.errors import HandbookError
from kurbel.reading.toml_file import Place, TomlFile, TomlKind, about, shown

KIND = TomlKind("file of problems", HandbookError, 2_000_000, "it has [[problem]]s", "problems.toml")
WORDS = {
    "de": {"problem": "Aufgabe", "solution": "Lösung", "checked": "Geprüft", "mark": ","},
    "en": {"problem": "Problem", "solution": "Solution", "checked": "Checked", "mark": "."},
}


class Bilingual(Struct, frozen=True, forbid_unknown_fields=True):
    """A text in Markdown in both languages, or in that of the handbooks which print it."""

    NOUN: ClassVar = "language of the text"
    SHAPE: ClassVar = "a section with de and en"

    de: Annotated[str, about("in German")] = ""
    en: Annotated[str, about("in English")] = ""


class ProblemKeys(Struct, frozen=True, forbid_unknown_fields=True):
    NOUN: ClassVar = "key of the problem"
    SHAPE: ClassVar = "a section"

    name: Annotated[str, about("name for references and files", "stamping-press")]
    run: Annotated[str, about("the command that answers it", "table --ratio 1:5")]
    text: Annotated[Bilingual, about("the problem", "[problem.text]")]
    checked: Annotated[Bilingual | None, about("how the answer was checked")] = None
    values: Annotated[
        dict[str, Any], about("what stands in braces: a text, or a list with a text a variant")
    ] = {}


class FileKeys(Struct, frozen=True, forbid_unknown_fields=True):
    NOUN: ClassVar = "key of the file of problems"

    letter: Annotated[str, about("what stands before the numbers of its problems")] = ""
    problem: Annotated[tuple[ProblemKeys, ...], about("the problems, in their order")] = ()


class Problem(NamedTuple):
    """One problem with the numbers of one variant, in one language."""

    number: str
    name: str
    words: tuple[str, ...]
    text: str
    checked: str
    lang: str

    @property
    def posed(self) -> str:
        """What a sheet of problems has of it, in Markdown."""
        return f"**{WORDS[self.lang]['problem']} {self.number}.** {self.text.strip()}\n"

    @property
    def solved(self) -> str:
        """What stands above the page that answers it, in Markdown."""
        words = WORDS[self.lang]
        command = shlex.join(("kurbel", *self.words))
        checked = f"\n{words['checked']}: {self.checked.strip()}\n" if self.checked else ""
        return f"**{words['solution']} {self.number}.** `{command}`\n{checked}"


def problems_of(path: str, lang: str, variant: int = 1, mark: str = "") -> Iterator[Problem]:
    """Yield the problems of a file in a language, with the numbers of a variant, counted from 1.

    `mark` is the decimal mark of the texts, by default that of the language. Raises HandbookError with the
    file's line for what is amiss.
    """
    file = TomlFile(path, KIND)
    given = file.read(FileKeys)
    if not given.problem:
        raise file.error((), "the file has no problem; write [[problem]] and below it its name, run and text")
    for number, keys in enumerate(given.problem, 1):
        one = _Filled(file, ("problem", number - 1), keys, variant)
        yield Problem(
            f"{given.letter}{number}",
            keys.name,
            one.words(),
            one.text("text", keys.text, lang, mark or WORDS[lang]["mark"]),
            one.text("checked", keys.checked, lang, mark or WORDS[lang]["mark"]) if keys.checked else "",
            lang,
        )


class _Filled:
    """Puts the values of a variant where their names stand in braces."""

    def __init__(self, file: TomlFile, place: Place, keys: ProblemKeys, variant: int) -> None:
        self.file, self.place, self.keys = file, place, keys
        self.values = {name: self.value(name, given, variant) for name, given in keys.values.items()}

    def value(self, name: str, given: object, variant: int) -> str:
        place = (*self.place, "values", name)
        several = given if isinstance(given, list) else [given]
        if not several or not all(isinstance(one, str) and one.strip() for one in several):
            raise self.file.error(place, f"{name} is {shown(given)}; it must be a text, or a list of texts")
        if isinstance(given, str):
            return given
        if variant > len(several):
            raise self.file.error(
                place, f"{name} has values for {len(several)} variants, and {variant} is asked for"
            )
        return str(several[variant - 1])

    def words(self) -> tuple[str, ...]:
        """Return the words of the command, without kurbel; a value is one word or a part of one."""
        place = (*self.place, "run")
        try:
            words = shlex.split(self.keys.run)
        except ValueError:
            raise self.file.error(place, "run has a quotation mark without its partner") from None
        if not (words := words[1:] if words[:1] == ["kurbel"] else words):
            raise self.file.error(place, 'run is empty; write a command, such as run = "table --ratio 1:5"')
        return tuple(self.filled(place, word, self.values) for word in words)

    def text(self, key: str, given: Bilingual, lang: str, mark: str) -> str:
        text: str = getattr(given, lang)
        if not text.strip():
            raise self.file.error((*self.place, key), f'{key} has nothing in {lang}; write {lang} = "..."')
        spaced = {name: printed(value, mark) for name, value in self.values.items()}
        return self.filled((*self.place, key, lang), text, spaced)

    def filled(self, place: Place, text: str, values: Mapping[str, str]) -> str:
        if unknown := [name for name in _IN_BRACES.findall(text) if name not in values]:
            known = ", ".join(values) or "none"
            raise self.file.error(place, f"there is no value {{{unknown[0]}}}; [problem.values] has {known}")
        return _IN_BRACES.sub(lambda found: values[found[1]], text)


_IN_BRACES = re.compile(r"\{(\w+)\}")


def printed(value: str, mark: str) -> str:
    """Return a value as texts have it: with their decimal mark, m² for m2, and its unit on its line."""
    marked = re.sub(r"(?<=\d)\.(?=\d)", mark, value)
    raised = re.sub(r"(?<=[a-z])[23](?!\d)", lambda power: _RAISED[power[0]], marked)
    return re.sub(r"(?<=\d) (?=[^\W\d])", "\N{NO-BREAK SPACE}", raised)


_RAISED = {"2": "²", "3": "³"}
