"""What an option is, on the command line, in Python, in a machine's file: declared once, in its part.

    class Lying(Part):
        slope = measure(as_angle, "Angle by which the slide rises: 30.", "ANGLE", unit="degrees")

The attribute gives the name, `--slope`. `measure` is of what is read, `word` of a name or a text as it
stands, `flag` of what is said or not.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from copy import copy
from dataclasses import dataclass, field
from os import PathLike
from types import MappingProxyType
from typing import TYPE_CHECKING, Generic, Self, TypeAlias, TypeVar, cast, overload

from kurbel.errors import NotationError
from kurbel.reading import given
from kurbel.reading.given import Exact, allowed_name, found_at

if TYPE_CHECKING:
    from typing import TypedDict, Unpack

    from kurbel.commands.part import Part

    class OptionWords(TypedDict, total=False):
        """What is said of an option beside its help and its kind, as Option has it."""

        short: str
        unit: str
        many: bool
        positional: bool
        environment: str
        first: bool
        last: bool
        bare: str
        required: bool
        whole: bool
        numbers: bool
        what: str
        machine: str
        usual: str
        topic: str


Value = TypeVar("Value")
Made = TypeVar("Made", covariant=True)
Path: TypeAlias = str | PathLike[str]
# The sections of a machine's file, of which some are loads.
LOADS = ("steam", "compressor", "pump", "gas")
SECTIONS = ("crank", *LOADS, "masses", "flywheel")
# In a machine's file an option stands in the section of its part, if it names none.
OF_PART = "of the part"


class Kind:
    """How a value is written: as text, which in Python may be a number.

    `typed` are the values of other options of the command line, of those at least that are `first`.
    """

    name = "text"
    python = "str | float"

    def read(self, text: str, typed: Mapping[str, object]) -> object:
        """Return what was typed as a value. Raises KurbelError."""
        return text

    def taken(self, value: object, name: str) -> object:
        """Return what Python gave as a value of the option with this name. Raises KurbelError."""
        if isinstance(value, bytes | bool):
            said = "bytes" if isinstance(value, bytes) else str(value)
            raise NotationError(f"{name} is {said}; give text or numbers")
        return value

    def with_files(self, value: object, file: Callable[[object], object]) -> object:
        """Return a value with what `file` makes of each file that it names."""
        return value

    def known(self, typed: Mapping[str, object]) -> Iterable[str]:
        """Return the texts that shells offer."""
        return ()

    def offered(self, begun: str, typed: Mapping[str, object]) -> Iterable[str]:
        """Return those of them that begin so."""
        return (text for text in self.known(typed) if text.startswith(begun))


TEXT = Kind()


class Prose(Kind):
    """Words of one's own, which are no number."""

    python = "str"


PROSE = Prose()


class Flag(Kind):
    """Said or not."""

    python = "bool"

    def taken(self, value: object, name: str) -> object:
        if not isinstance(value, bool):
            raise NotationError(f"{name} is {str(value)[:40]}; it must be True or False")
        return value


FLAG = Flag()


class File(Kind):
    """A file or a folder that is read."""

    python = "str | Path"

    def taken(self, value: object, name: str) -> object:
        if not isinstance(value, str | PathLike) or "\0" in str(value):
            said = str(value)[:40].replace("\0", "\\0")
            raise NotationError(f"{name} is {said}, which is not the name of a file or a folder")
        return value

    def with_files(self, value: object, file: Callable[[object], object]) -> object:
        return file(value)


FILE = File()


class Choice(Kind):
    """One of a few names, which may stand elsewhere as "module:NAME"; a wrong one is told the nearest."""

    python = "str"

    def __init__(self, name: str, names: Iterable[str] | Callable[[], Iterable[str]] | str) -> None:
        self.name = name
        self._names = names

    @property
    def names(self) -> Iterable[str]:
        found = self._names
        if isinstance(found, str):
            found = cast("Iterable[str]", found_at(found))
        return found() if callable(found) else found

    def read(self, text: str, typed: Mapping[str, object]) -> str:
        return allowed_name(text, self.names, self.name)

    def taken(self, value: object, name: str) -> object:
        return self.read(value if isinstance(value, str) else allowed_name(value, self.names, self.name), {})

    def known(self, typed: Mapping[str, object]) -> Iterable[str]:
        return self.names


class Count(Kind):
    """A whole number within bounds; `wrong` says of another text what it is."""

    name, python = "number", "int"

    def __init__(self, what: str, least: int, most: int, wrong: str = "is no such number") -> None:
        self.what = what
        self.wrong = wrong
        self.within = least, most
        self.allowed = {str(count): count for count in range(least, most + 1)}

    def read(self, text: str, typed: Mapping[str, object]) -> int:
        if str(text) not in self.allowed:
            least, most = self.within
            raise NotationError(
                f'{self.what} "{text[:40]}" {self.wrong}; write a whole number from {least} to {most}'
            )
        return self.allowed[str(text)]

    def taken(self, value: object, name: str) -> object:
        return self.read(str(value), {})


class Columns(Kind):
    """Names of columns, parted by commas; which there are depends on the layout, by default this one, that of
    the first option of `chosen` that was typed, or that of a page that is the same for every mechanism."""

    name, python = "names", "str"

    def __init__(
        self, layout: str, of_mechanisms: str = "", chosen: Mapping[str, str] = MappingProxyType({})
    ) -> None:
        self.layout, self.of_mechanisms, self.chosen = layout, of_mechanisms, chosen

    def offered(self, begun: str, typed: Mapping[str, object]) -> Iterable[str]:
        from kurbel.page.layouts import layout
        from kurbel.page.subject import subject

        before, comma, last = begun.rpartition(",")
        chosen = before.split(",")
        page = layout(str(typed.get("layout") or self._default(typed)), _folder(typed))
        keys = subject(page.subject).column_keys(page)
        return (before + comma + key for key in keys if key.startswith(last) and key not in chosen)

    def _default(self, typed: Mapping[str, object]) -> str:
        """The layout that the other options choose."""
        if found := next((page for name, page in self.chosen.items() if typed.get(name)), ""):
            return found
        if mechanism := typed.get("mechanism"):
            from kurbel.motion.mechanism import mechanism as mechanism_of

            return self.of_mechanisms or mechanism_of(str(mechanism)).layout
        return self.layout


class LayoutName(Kind):
    """A layout about one of these subjects; others are read, too, but not offered."""

    name, python = "layout", "str"

    def __init__(self, subjects: tuple[str, ...]) -> None:
        self.subjects = subjects

    def read(self, text: str, typed: Mapping[str, object]) -> str:
        from kurbel.page.layouts import layout_names

        return (
            text if text in layout_names(_folder(typed)) else allowed_name(text, self.known(typed), self.name)
        )

    def taken(self, value: object, name: str) -> object:
        if not isinstance(value, str):
            raise NotationError(f"{name} is {str(value)[:40]}, which is not the name of a layout")
        return value

    def known(self, typed: Mapping[str, object]) -> Iterable[str]:
        from kurbel.page.layouts import layout, layout_names

        folder = _folder(typed)
        return [name for name in layout_names(folder) if layout(name, folder).subject in self.subjects]


def _folder(typed: Mapping[str, object]) -> given.File | None:
    """Return the folder of --layouts."""
    # While it parses, click has a mark of its own for what was not given.
    folder = typed.get("layouts")
    return folder if isinstance(folder, given.File) else None


@dataclass(eq=False)
class Option(Generic[Made]):
    """An option: a sentence of help, what stands for the value there, what kind of value it is, and how that
    is read.

    One value is a list as a `whole`, as the angles of cranks are, and sweeps have several of those; else the
    values of a list are `numbers`, unless it says otherwise.

    `unit` is that of bare numbers in Python; `many` options may be repeated. A positional one has no dashes.
    `machine` are the sections of a machine's file in which it stands, "steam compressor", with the key behind
    a dot where that is not its name: "masses.rod"; `usual` is the unit in which it mostly stands there.

    In the help it stands in the topic of its part, or in an own `topic`.

    `environment` is a variable for all commands, beside that of the command's own option. What is `first` is
    parsed before the others, which need it; what is `last` stands behind the command's own. Without a value,
    and True in Python, an option is `bare`. `what` it is called in sentences, if not by its name.

    `name` is that on the command line, with underscores, and `default` the value where none is given. It is
    declared in a part, and belongs to the first one that does. To ask a part for it reads it, once, and
    notes that it was read.
    """

    help: str
    metavar: str | None = None
    kind: Kind = TEXT
    short: str = ""
    unit: str = ""
    many: bool = False
    positional: bool = False
    environment: str = ""
    first: bool = False
    default: object = None
    last: bool = False
    bare: str = ""
    required: bool = False
    whole: bool = False
    numbers: bool = True
    read: Callable[[object, str], object] | None = None
    what: str = ""
    machine: str = OF_PART
    usual: str = ""
    topic: str = ""
    name: str = field(default="", init=False)
    home: type[Part] | None = field(default=None, init=False)

    def but(self, **changes: object) -> Self:
        """Return the same option with another help, another default: as it is in one command."""
        found = copy(self)
        vars(found).update(changes)
        return found

    def read_as(self, read: Callable[[object, str], Value], **changes: object) -> Option[Value | None]:
        """Return the same, read in another way, None where it is not given."""
        return cast("Option[Value | None]", self.but(read=read, **changes))

    def __set_name__(self, owner: type[Part], name: str) -> None:
        # In Python a name that is a keyword has a line behind it.
        self.name = name.rstrip("_")
        if self.home is None:
            self.home, self.topic = owner, self.topic or owner.topic
            if self.machine == OF_PART:
                self.machine = vars(owner).get("section", "")

    @property
    def flag(self) -> str:
        return f"--{self.name.replace('_', '-')}"

    def taken(self, value: object) -> object:
        """Return what Python gave, an iterator as a list. Raises KurbelError for another kind."""
        if isinstance(value, Iterator):
            value = tuple(value)
        elif getattr(value, "shape", None) == () and (item := getattr(value, "item", None)):
            # An array of no dimension is a number.
            value = item()
        if value is True and self.bare:
            return self.bare
        kind = self.kind
        one = isinstance(value, str | bytes | PathLike | Mapping) or not isinstance(value, Iterable)
        if not self.many or (one and kind is TEXT):
            return kind.taken(value, self.name)
        several = [value] if one or not isinstance(value, Iterable) else value
        return several if kind is TEXT else [kind.taken(each, self.name) for each in several]

    @overload
    def __get__(self, part: None, owner: type[Part]) -> Self: ...
    @overload
    def __get__(self, part: Part, owner: type[Part]) -> Made: ...
    def __get__(self, part: Part | None, owner: type[Part]) -> object:
        return self if part is None else part.values.parsed(self)


def measure(
    read: Callable[[object, str], Value], help: str, metavar: str | None = None, **more: Unpack[OptionWords]
) -> Option[Value | None]:
    """Return an option that is read, None where it is not given; `read` takes it, and what it is called. A
    bare number is in the unit of the reader, if it has one."""
    more.setdefault("unit", getattr(read, "unit", ""))
    return Option(help, metavar, read=read, **more)


def alone(read: Callable[[object], Value]) -> Callable[[object, str], Value]:
    """Return a reader that needs not to know what the value is called."""
    return lambda value, what: read(value)


@overload
def word(
    help: str, metavar: str | None = ..., kind: Kind = ..., *, default: str, **more: Unpack[OptionWords]
) -> Option[str]: ...
@overload
def word(
    help: str, metavar: str | None = ..., kind: Kind = ..., **more: Unpack[OptionWords]
) -> Option[str | None]: ...
def word(
    help: str,
    metavar: str | None = None,
    kind: Kind = TEXT,
    default: object = None,
    **more: Unpack[OptionWords],
) -> Option[object]:
    """Return an option that is a name or a text, as it stands."""
    return Option(help, metavar, kind, default=default, **more)


def amount(help: str, metavar: str | None = None, **more: Unpack[OptionWords]) -> Option[Exact | None]:
    """Return an option that can be read only beside others, as an offset in crank radii or as a length."""
    return Option(help, metavar, **more)


def file(help: str, metavar: str = "FILE", **more: Unpack[OptionWords]) -> Option[Path | None]:
    """Return an option that is a file or a folder."""
    return Option(help, metavar, FILE, **more)


def flag(help: str, **more: Unpack[OptionWords]) -> Option[bool]:
    """Return an option that is said or not."""
    return Option(help, kind=FLAG, default=False, **more)


def alone_of(value: object) -> object:
    """Return the one value of a list of one, which the command line makes of options that may be repeated."""
    return value[0] if isinstance(value, list | tuple) and len(value) == 1 else value


def is_given(value: object) -> bool:
    """Whether a value says anything."""
    if value is None or value is False:
        return False
    return isinstance(value, str) or not isinstance(value, Collection) or len(value) > 0
