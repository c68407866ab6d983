"""What an option is, on the command line and in Python: stated once, in the annotation of a parameter.

    ratio: Annotated[Given | None, Option("Crank ratio: 1:5.", "R:L", short="-r", many=True)] = None

The parameter gives the name, `--ratio`, the default and the place in the help. Options that functions share
are the keys of a TypedDict, and each function has them as `**given: Unpack[Shared]`: before its own keywords,
or behind them if they are `last`, unless it has an order of its own. Their default is in the Option.
"""

import inspect
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from os import PathLike
from typing import Any, NamedTuple, cast, get_args

from kurbel.errors import NotationError
from kurbel.reading import given
from kurbel.reading.given import found_at, meant


class Kind:
    """How a value is written: as text, which in Python may be a number.

    `typed` are the values of other options of the command line, of those at least that are `first`.
    """

    name = "text"

    def read(self, text: str, typed: Mapping[str, Any]) -> Any:
        """Return what was typed as a value. Raises KurbelError."""
        return text

    def taken(self, value: Any, name: str) -> Any:
        """Return what Python gave as a value of the option with this name. Raises KurbelError."""
        if isinstance(value, bytes):
            raise NotationError(f"{name} is bytes; give text or numbers")
        return value

    def with_files(self, value: Any, file: Callable[[Any], Any]) -> Any:
        """Return a value with what `file` makes of each file that it names."""
        return value

    def known(self, typed: Mapping[str, Any]) -> Iterable[str]:
        """Return the texts that shells offer."""
        return ()

    def offered(self, begun: str, typed: Mapping[str, Any]) -> Iterable[str]:
        """Return those of them that begin so."""
        return (text for text in self.known(typed) if text.startswith(begun))


TEXT = Kind()


class Flag(Kind):
    """Said or not."""

    def taken(self, value: Any, name: str) -> Any:
        if not isinstance(value, bool):
            raise NotationError(f"{name} is {str(value)[:40]}; it must be True or False")
        return value


FLAG = Flag()


class File(Kind):
    """A file or a folder that is read."""

    def taken(self, value: Any, name: str) -> Any:
        if not isinstance(value, str | PathLike) or "\0" in str(value):
            said = str(value)[:40].replace("\0", "\\0")
            raise NotationError(f"{name} is {said}, which is not the name of a file or a folder")
        return value

    def with_files(self, value: Any, file: Callable[[Any], Any]) -> Any:
        return file(value)


FILE = File()


class Choice(Kind):
    """One of a few names, which may stand elsewhere as "module:NAME"; a wrong one is told the nearest."""

    def __init__(self, name: str, names: Iterable[str] | Callable[[], Iterable[str]] | str) -> None:
        self.name = name
        self._names = names

    @property
    def names(self) -> Iterable[str]:
        found = self._names
        if isinstance(found, str):
            found = cast("Iterable[str]", found_at(found))
        return found() if callable(found) else found

    def read(self, text: str, typed: Mapping[str, Any]) -> str:
        return meant(text, self.names, self.name)

    def taken(self, value: Any, name: str) -> Any:
        return self.read(value, {})

    def known(self, typed: Mapping[str, Any]) -> Iterable[str]:
        return self.names


class Count(Kind):
    """A whole number within bounds; `wrong` says of another text what it is."""

    name = "number"

    def __init__(self, what: str, least: int, most: int, wrong: str = "is no such number") -> None:
        self.what = what
        self.wrong = wrong
        self.allowed = {str(count): count for count in range(least, most + 1)}
        self.bounds = f"{least} to {most}"

    def read(self, text: str, typed: Mapping[str, Any]) -> int:
        if str(text) not in self.allowed:
            raise NotationError(
                f'{self.what} "{text[:40]}" {self.wrong}; write a whole number from {self.bounds}'
            )
        return self.allowed[str(text)]

    def taken(self, value: Any, name: str) -> Any:
        # Others are refused where they are used.
        return self.allowed.get(str(value), value)


class Columns(Kind):
    """Names of columns, parted by commas; which there are depends on the layout, by default this one, or that
    of a page that is the same for every mechanism."""

    name = "names"

    def __init__(self, layout: str, of_mechanisms: str = "") -> None:
        self.layout, self.of_mechanisms = layout, of_mechanisms

    def offered(self, begun: str, typed: Mapping[str, Any]) -> Iterable[str]:
        from kurbel.page.layouts import layout
        from kurbel.page.subject import subject

        before, comma, last = begun.rpartition(",")
        chosen = before.split(",")
        page = layout(typed.get("layout") or self._default(typed), _folder(typed))
        keys = subject(page.subject).column_keys(page)
        return (before + comma + key for key in keys if key.startswith(last) and key not in chosen)

    def _default(self, typed: Mapping[str, Any]) -> str:
        """The layout that the other options choose."""
        if typed.get("point"):
            return "rod-points"
        if mechanism := typed.get("mechanism"):
            from kurbel.motion.mechanism import mechanism as mechanism_of

            return self.of_mechanisms or mechanism_of(mechanism).layout
        from kurbel.commands.loads import OWN

        if typed.get("forces") and any(map(typed.get, OWN)):
            return "engine-forces"
        return "delta-detail" if typed.get("detail") else self.layout


class LayoutName(Kind):
    """A layout about one of these subjects; others are read, too, but not offered."""

    name = "layout"

    def __init__(self, subjects: tuple[str, ...]) -> None:
        self.subjects = subjects

    def read(self, text: str, typed: Mapping[str, Any]) -> str:
        from kurbel.page.layouts import layout_names

        return text if text in layout_names(_folder(typed)) else meant(text, self.known(typed), self.name)

    def taken(self, value: Any, name: str) -> Any:
        if not isinstance(value, str):
            raise NotationError(f"{name} is {str(value)[:40]}, which is not the name of a layout")
        return value

    def known(self, typed: Mapping[str, Any]) -> Iterable[str]:
        from kurbel.page.layouts import layout, layout_names

        folder = _folder(typed)
        return [name for name in layout_names(folder) if layout(name, folder).subject in self.subjects]


def _folder(typed: Mapping[str, Any]) -> given.File | None:
    """Return the folder of --layouts."""
    # While it parses, click has a mark of its own for what was not given.
    folder = typed.get("layouts")
    return folder if isinstance(folder, given.File) else None


class Option(NamedTuple):
    """A sentence of help, what stands for the value there, and what kind of value it is.

    `unit` is that of bare numbers in Python; `many` options may be repeated. A positional one has no dashes.
    `environment` is a variable for all commands, beside that of the command's own option. What is `first` is
    read before the others, which need it. `default` and `last` are for options that functions share. Without
    a value, and True in Python, an option is `bare`.
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
    default: Any = None
    last: bool = False
    bare: str = ""


class Parameter(NamedTuple):
    """An option of one function: its name on the command line, with underscores, and its default there."""

    name: str
    option: Option
    default: Any
    required: bool

    @property
    def flag(self) -> str:
        return f"--{self.name.replace('_', '-')}"

    def taken(self, value: Any) -> Any:
        """Return what Python gave, an iterator as a list. Raises KurbelError for another kind."""
        if isinstance(value, Iterator):
            value = tuple(value)
        elif getattr(value, "shape", None) == ():
            # An array of no dimension is a number.
            value = value.item()
        if value is None or value is False:
            return value
        if value is True and self.option.bare:
            return self.option.bare
        kind, one = self.option.kind, isinstance(value, str | bytes | PathLike | Mapping)
        one = one or not isinstance(value, Iterable)
        if not self.option.many or (one and kind is TEXT):
            return kind.taken(value, self.name)
        several = [value] if one else value
        return several if kind is TEXT else [kind.taken(each, self.name) for each in several]


def signature_of(function: Callable[..., Any], order: str = "") -> inspect.Signature:
    """Return the signature of a function, with the options that it shares one by one.

    First of its keywords stand those that the order names.
    """
    signature = inspect.signature(function)
    own = [*signature.parameters.values()]
    if own[-1].kind is not inspect.Parameter.VAR_KEYWORD:
        return signature
    (group,) = get_args(own.pop().annotation)
    shared = [
        inspect.Parameter(
            name, inspect.Parameter.KEYWORD_ONLY, default=option_of(kind).default, annotation=kind
        )
        for name, kind in group.__annotations__.items()
    ]
    ranks = {name: rank for rank, name in enumerate(order.split())}

    def place(one: inspect.Parameter) -> tuple[bool, bool, int]:
        by_name = one.kind is inspect.Parameter.KEYWORD_ONLY
        return by_name, by_name and option_of(one.annotation).last, ranks.get(one.name, len(ranks))

    return signature.replace(parameters=sorted([*shared, *own], key=place))


def option_of(annotation: Any) -> Option:
    """Return the option that the annotation of a parameter holds."""
    (option,) = (one for one in annotation.__metadata__ if isinstance(one, Option))
    return option


def parameters_of(signature: inspect.Signature) -> dict[str, Parameter]:
    """Return the options of a function by its parameters' names, in their order."""
    found = {}
    for name, one in signature.parameters.items():
        required = one.default is one.empty
        default = None if required else one.default
        found[name] = Parameter(name.rstrip("_"), option_of(one.annotation), default, required)
    return found


def is_given(value: Any) -> bool:
    """Whether a value says anything."""
    if value is None or value is False:
        return False
    return isinstance(value, str) or not isinstance(value, Collection) or len(value) > 0
