"""What an option is, on the command line and in Python: stated once, in the annotation of a parameter.

    ratio: Annotated[Given | None, Option("Crank ratio: 1:5.", "R:L", short="-r", many=True)] = None

The parameter gives the name, `--ratio`, the default and the place in the help. Options that functions share
are the keys of a TypedDict, and each function has them as `**given: Unpack[Shared]`: before its own keywords,
or behind them if they are `last`. Their default is in the Option.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, NamedTuple, get_args

from kurbel.reading.given import choose


class Kind:
    """How a value is written: as text, which in Python may be a number."""


TEXT = Kind()
# Said or not.
FLAG = Kind()
# A file or a folder that is read.
FILE = Kind()


class Choice(Kind):
    """One of a few names."""

    def __init__(self, what: str, names: Callable[[], Iterable[str]]) -> None:
        self.what = what
        self.names = names


class Count(Kind):
    """A whole number within bounds."""

    def __init__(self, what: str, least: int, most: int) -> None:
        self.what = what
        self.least = least
        self.most = most


class Columns(Kind):
    """Names of columns, parted by commas; which there are depends on the layout, by default this one."""

    def __init__(self, layout: str) -> None:
        self.layout = layout


class LayoutName(Kind):
    """A layout about one of these subjects."""

    def __init__(self, subjects: tuple[str, ...]) -> None:
        self.subjects = subjects


class Option(NamedTuple):
    """A sentence of help, what stands for the value there, and what kind of value it is.

    `unit` is that of bare numbers in Python; `many` options may be repeated. A positional one has no dashes.
    `environment` is a variable for all commands, beside that of the command's own option. What is `first` is
    read before the others, which need it. `default` and `last` are for options that functions share.
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


class Parameter(NamedTuple):
    """An option of one function: its name on the command line, with underscores, and its default there."""

    name: str
    option: Option
    default: Any
    required: bool

    @property
    def flag(self) -> str:
        return f"--{self.name.replace('_', '-')}"


def signature_of(function: Callable[..., Any]) -> inspect.Signature:
    """Return the signature of a function, with the options that it shares one by one."""
    signature = inspect.signature(function)
    own = [*signature.parameters.values()]
    if own[-1].kind is not inspect.Parameter.VAR_KEYWORD:
        return signature
    (group,) = get_args(own.pop().annotation)
    shared = [
        inspect.Parameter(
            name, inspect.Parameter.KEYWORD_ONLY, default=_option(kind).default, annotation=kind
        )
        for name, kind in group.__annotations__.items()
    ]
    keywords = sum(one.kind is inspect.Parameter.KEYWORD_ONLY for one in own)
    place = len(own) - keywords
    own[place:place] = [one for one in shared if not _option(one.annotation).last]
    return signature.replace(parameters=[*own, *(one for one in shared if one not in own)])


def _option(annotation: Any) -> Option:
    (option,) = (one for one in annotation.__metadata__ if isinstance(one, Option))
    return option


def parameters_of(signature: inspect.Signature) -> Mapping[str, Parameter]:
    """Return the options of a function by its parameters' names, in their order."""
    found = {}
    for name, one in signature.parameters.items():
        required = one.default is one.empty
        default = None if required else one.default
        found[name] = Parameter(name.rstrip("_"), _option(one.annotation), default, required)
    return found


def check_choices(parameters: Iterable[Parameter], values: Mapping[str, Any]) -> None:
    """Raise ChoiceError for a name that is none of those allowed."""
    for parameter in parameters:
        kind, value = parameter.option.kind, values[parameter.name]
        if isinstance(kind, Choice) and is_given(value):
            for one in [value] if isinstance(value, str) or not parameter.option.many else value:
                choose(one, kind.names(), kind.what)


def is_given(value: Any) -> bool:
    """Whether a value says anything."""
    if value is None or value is False:
        return False
    return not isinstance(value, Sequence) or isinstance(value, str) or len(value) > 0


def described(text: str, parameters: Mapping[str, Parameter]) -> str:
    """Return the docstring for Python of a function whose docstring is the help of a command.

    Examples of the command line stand behind a \\b there, those of Python behind a \\f.
    """
    about, _, examples = inspect.cleandoc(text).partition("\f")
    lines = [
        about.replace("\b\n", "").rstrip(),
        "",
        "Values are text as on the command line, or numbers.",
        "",
    ]
    for name, parameter in parameters.items():
        unit = f" A bare number is in {parameter.option.unit}." if parameter.option.unit else ""
        lines.append(f"{name}: {parameter.option.help}{unit}")
    return "\n".join([*lines, examples.rstrip()]) + "\n"
