"""A part of what a command asks for: options that stand together, each declared once, and what they make.

A command is a class made of its parts. To ask a part for an option reads it and notes that; what was typed
and was not read when the question is whole is refused, by one sentence made from where the option belongs.
Whether an option is given, which only decides what is asked, is looked up by `says`, which reads nothing.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from enum import Enum
from types import MappingProxyType
from typing import Any, ClassVar, TypeAlias, TypeVar

from kurbel.commands.options import Option, is_given
from kurbel.errors import ProblemError

Kin = TypeVar("Kin", bound="Part")
# An option, and another that outdoes it where that is typed and the first is not.
Rivals: TypeAlias = Sequence[tuple[str, str]]


class Origin(Enum):
    """Where the value of an option comes from, if it is not the default."""

    TYPED = "typed"
    ENVIRONMENT = "environment"
    MACHINE = "machine"


class Values:
    """The values of a command's options by their names, where they come from, and which of them were read.

    `places` are what sentences call those that were not typed: by a variable, or a machine's file.
    """

    def __init__(
        self,
        values: Mapping[str, object],
        origins: Mapping[str, Origin | None],
        places: Mapping[str, str] = MappingProxyType({}),
    ) -> None:
        self.values, self.origins, self.places = dict(values), dict(origins), places
        # As it was written, before one option took the place of another.
        self.written = dict(values)
        self.read: set[str] = set()
        self.own: frozenset[str] = frozenset()
        self._parsed: dict[str, object] = {}

    def __getitem__(self, name: str) -> object:
        """Return the value of an option as it was given, and note that it was read."""
        if name not in self.own:
            self.read.add(name)
        return self.values.get(name)

    def says(self, *names: str) -> bool:
        """Whether one of the options says anything, by which none of them counts as read."""
        return any(is_given(self.values.get(name)) for name in names)

    def parsed(self, option: Option[object]) -> object:
        """Return the value of an option as it is read, once. Raises KurbelError."""
        value, name = self[option.name], option.name
        if value is None or value is False:
            return option.default
        if option.read is None:
            return value
        if name not in self._parsed:
            self._parsed[name] = option.read(value, option.what or name.replace("_", " "))
        return self._parsed[name]

    def typed(self, name: str) -> bool:
        """Whether an option was typed, or given in Python; a default from elsewhere gives way."""
        return self.origins.get(name) is Origin.TYPED

    def drop(self, *names: str) -> None:
        """Make options such as were not given."""
        for name in names:
            self.written.pop(name, None)
            if name in self.values:
                self.values[name] = False if self.values[name] is True else None

    def outdo(self, rivals: Rivals) -> None:
        """Drop what is outdone by what was typed."""
        for name, other in rivals:
            if name in self.values and not self.typed(name) and self.typed(other):
                self.drop(name)

    def instead(self, values: Mapping[str, object], own: bool = False) -> Values:
        """Return the same with others in place of some. What is read of them counts as read here, too, but of
        those that are `own`, as the entries of a cylinder are."""
        found = Values({**self.values, **values}, self.origins)
        found.read, found.own = self.read, self.own | values.keys() if own else self.own
        return found


class Part:
    """Options that stand together. `title` is what they describe, and `add` what one types to have it.

    In the help its options stand in its `topic`, but for those with an own one. It is made `without` some
    options of its parts.

    In a machine's file the options that it declares stand in its `section`, but for those with an own one.

    `rivals` are options of which one that is typed outdoes the other where that comes from elsewhere.
    """

    title: ClassVar[str] = ""
    add: ClassVar[str] = ""
    topic: ClassVar[str] = ""
    section: ClassVar[str] = ""
    without: ClassVar[Collection[str]] = ()
    rivals: ClassVar[Rivals] = ()

    def __init__(self, values: Values) -> None:
        self.values = values

    @classmethod
    def options(cls) -> dict[str, Option[object]]:
        """Return the options by their attributes: those of its parts in their order, then its own."""
        found = {
            name: one
            for base in cls.__bases__
            if issubclass(base, Part)
            for name, one in base.options().items()
        }
        found |= {name: one for name, one in vars(cls).items() if isinstance(one, Option)}
        return {name: one for name, one in found.items() if name not in cls.without}

    @classmethod
    def parts(cls) -> Iterator[type[Part]]:
        """Yield the part and those that it is made of, these first."""
        return (one for one in reversed(cls.__mro__) if issubclass(one, Part))

    @classmethod
    def settle(cls, values: Values) -> None:
        """Settle what its options say together: what was typed outdoes what comes from elsewhere. Raises
        KurbelError."""

    @classmethod
    def named_by(cls) -> Iterator[str]:
        """Yield the names of the options of which one has to be given for the others to say anything."""
        return (one.name for one in cls.options().values())

    def says(self, *names: str) -> bool:
        """Whether one of the options says anything, by which none of them counts as read."""
        return self.values.says(*names)

    def raw(self, name: str) -> object:
        """Return the value of an option as it was given, and note that it was read."""
        return self.values[name]

    def as_part(self, part: type[Kin]) -> Kin:
        """Return the same values as another part."""
        return part(self.values)

    def unread(self, option: Option[object]) -> str:
        """Return the sentence that refuses one of its options, which was typed and was not read; nothing
        where it depends on the command alone."""
        others = [name for name in self.named_by() if name != option.name]
        if not self.title or self.says(*others):
            return ""
        return f"{flag_of(option.name)} is for {self.title}; add {self.add}"

    def check_one(self, what: str, *several: Sequence[str]) -> None:
        """Raise ProblemError where options of more than one of these name what there is only one of."""
        found = [next(name for name in names if self.says(name)) for names in several if self.says(*names)]
        if len(found) > 1:
            raise ProblemError(f"{flag_of(found[0])} and {flag_of(found[1])} are two {what}; leave one out")


class CommandOptions(Part):
    """A command, made of its parts: what it asks for.

    `unnamed` are the options that need no name in Python, and `sequence` those that stand before others there
    and in the names of pages; `in_short` are those that one needs first, of which the topic of the first one
    leads the help; `builder` is the place of what makes a page of a question.
    """

    builder: ClassVar[str] = "kurbel.page.build:build"
    unnamed: ClassVar[str] = ""
    sequence: ClassVar[str] = ""
    in_short: ClassVar[str] = ""

    def question(self) -> Any:
        """Return what is asked for, or drawn. Raises KurbelError."""
        raise NotImplementedError

    def case(self) -> str:
        """Return what decides which options count, as it is typed, such as --eps; nothing where all do."""
        return ""

    def refuse(self, *names: str) -> None:
        """Raise ProblemError for the first of these options that was typed, which the question does not need:
        where something else would be missing first."""
        for option in self.options().values():
            if option.name in names and self.values.typed(option.name) and self.says(option.name):
                raise ProblemError(self.refusal(option))

    def refusal(self, option: Option[object]) -> str:
        """Return the sentence that refuses an option that was typed, and that the question did not read."""
        knowing = [part for part in type(self).__mro__ if issubclass(part, Part) and "unread" in vars(part)]
        for part in knowing[:-1]:
            if sentence := part.unread(self, option):
                return sentence
        if option.home and (sentence := Part.unread(self.as_part(option.home), option)):
            return sentence
        flag = flag_of(option.name)
        if case := self.case():
            return f"{flag} does not go with {case}; leave one of the two out"
        return f"{flag} says nothing on this page; leave it out"


def flag_of(name: str) -> str:
    """Return the name of an option as it is typed."""
    return f"--{name.rstrip('_').replace('_', '-')}"
