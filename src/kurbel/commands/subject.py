"""A command as a function in the words of the command line: called it makes the table, and `question` is what
it asks."""

from __future__ import annotations

import inspect
import re
from abc import ABC, abstractmethod
from collections.abc import Callable, Collection, Mapping
from dataclasses import replace
from functools import cached_property, partial
from os import fspath
from typing import TYPE_CHECKING, Any, Protocol, cast

from kurbel.commands.in_python import described, plain_signature
from kurbel.commands.options import FILE, TEXT, Option, is_given
from kurbel.commands.part import CommandOptions, Origin, Values
from kurbel.errors import ProblemError
from kurbel.page.table import Request
from kurbel.reading.given import File, found_at
from kurbel.reading.keywords import bound

if TYPE_CHECKING:
    from kurbel.commands.shown import Table
    from kurbel.page.table import Table as Page
    from kurbel.page.table import Variant
    from kurbel.reading.amounts import Units

# From the values of all options to the sentences that refuse some of them.
Refusals = Callable[[Mapping[str, Any]], Mapping[str, str]]
# Units that follow a number; of time there is one kind.
_MARK = r"(?<=[\d. *·/])(?:%s)(?![A-Za-z])"
_IMPERIAL = _MARK % "in|inch|inches|Zoll|ft|foot|feet|lbs?|lbf?(?:ft)?|psi|hp|mph"
_METRIC = _MARK % "[cdkmµ]?m|[km]?gm?|t|[kM]?Nm?|[hkM]?Pa|m?bar|atm?|[kM]?W|PS|[kM]?J|kp|kgf"
# Options with words of one's own.
OWN_WORDS = ("caption", "note", "source")
# What a page is called or where its layout lies, and its language, which its document has, too.
UNTOLD = frozenset(("label", "caption", "note", "source", "layouts", "layout", "lang", "templates"))
# What has units, but not those of the drive.
UNMEASURED = frozenset(("units", "width", "height"))
# A longer name nobody would type.
LONGEST = 40
# The parameter of Python that names the file of a machine.
MACHINE = "machine"
_FIGURES = r"[A-Za-z0-9.,:;/% -]*"
_MINUS = r"(?<![\w.])-(?=[0-9.])"
_PARTS = r"[^A-Za-z0-9.]+"
_PLACED, _NAMED = inspect.Parameter.POSITIONAL_OR_KEYWORD, inspect.Parameter.KEYWORD_ONLY
# Options that stand for another, the stroke.
SPELLED = ("crank", "true_stroke", "time_ratio")


class Command(ABC):
    """What stands behind a function: its options, what is asked for by their values, what is made of that."""

    name: str
    doc: str
    signature: inspect.Signature
    parameters: Mapping[str, Option[Any]]
    builder = ""

    @property
    def machine(self) -> bool:
        """Whether a machine's file may describe what it is about."""
        return MACHINE in self.signature.parameters

    @cached_property
    def options(self) -> Mapping[str, Option[Any]]:
        """The options by their names on the command line, with underscores."""
        return {one.name: one for one in self.parameters.values()}

    @cached_property
    def defaults(self) -> Mapping[str, Any]:
        return {name: one.default for name, one in self.options.items()}

    @abstractmethod
    def settle(self, values: Values) -> None:
        """Settle the values with one another: what was typed outdoes what comes from elsewhere. Raises
        KurbelError."""

    @abstractmethod
    def question(self, values: Values) -> Any:
        """Return what is asked for, or drawn, by values that are settled. Raises KurbelError."""

    def ask(self, values: Values) -> Any:
        """Return what is asked for by these values, which it settles. Raises KurbelError."""
        self.settle(values)
        return self.question(values)

    def built(self, question: Any, values: Values) -> Page:
        """Return the table that was asked for, which these values of the options name."""
        page = cast("Page", found_at(self.builder)(question))
        named = variant(page.key, self.parameters, values.values)
        return replace(page, variant=named, request=self.request(values))

    def request(self, values: Values) -> Request:
        """Return what counted of the values of a question, as they were written."""
        written = values.written
        counted = {
            name: written[name]
            for name, one in self.options.items()
            if name in values.read - UNTOLD and _is_other(one, written)
        }
        return Request(self.name, counted)

    def _with_defaults(self, values: Values) -> None:
        """Give the default to what may be repeated and was not given."""
        for name, default in self.defaults.items():
            value = values.values.get(name)
            if isinstance(value, tuple) and not value and not values.origins.get(name):
                values.values[name] = default

    def _settle_words(self, values: Values) -> None:
        """Give the page's own words and its units as it takes them."""
        if values.says(*OWN_WORDS):
            from kurbel.page.wording import own_words

            values.values.update(own_words(values.values))
        if "units" in values.values:
            values.values["units"] = self._units(values.values["units"], values.written)

    def _units(self, asked: Any, values: Mapping[str, Any]) -> Units | None:
        """Return the units that are asked for, else imperial ones where all measures are given in such."""
        names = {name for name, one in self.options.items() if one.unit or one.kind is TEXT}
        read = (names | {"cylinder"}) - UNTOLD - UNMEASURED
        measured = [values[name] for name in sorted(read) if is_given(values.get(name))]
        texts = str(measured) if measured else ""
        if not (texts or is_given(asked)):
            return None
        if not is_given(asked) and (re.search(_METRIC, texts) or not re.search(_IMPERIAL, texts)):
            return None
        from kurbel.reading.amounts import IMPERIAL, read_units

        return read_units(asked) if is_given(asked) else read_units(IMPERIAL)._replace(data=False)


class PartsCommand(Command):
    """A command that is made of parts."""

    def __init__(self, asks: type[CommandOptions], name: str) -> None:
        self.asks, self.name, self.doc, self.builder = asks, name, inspect.getdoc(asks) or "", asks.builder
        self.signature = self._signature()
        self.parameters = {
            key: one.annotation for key, one in self.signature.parameters.items() if key != MACHINE
        }

    def _signature(self) -> inspect.Signature:
        ranks = {name: rank for rank, name in enumerate(self.asks.sequence.split())}
        first = self.asks.unnamed.split()

        def place(one: tuple[str, Option[Any]]) -> tuple[bool, bool, int]:
            return one[0] not in first, one[1].last, ranks.get(one[0], len(ranks))

        return inspect.Signature(
            [
                inspect.Parameter(
                    name,
                    inspect.Parameter.POSITIONAL_OR_KEYWORD
                    if name in first
                    else inspect.Parameter.KEYWORD_ONLY,
                    default=inspect.Parameter.empty if one.required else one.default,
                    annotation=one,
                )
                for name, one in sorted(self.asks.options().items(), key=place)
            ]
        )

    def settle(self, values: Values) -> None:
        self._with_defaults(values)
        for one in self.options.values():
            if one.required and not values.says(one.name):
                raise ProblemError(f"{one.flag} is missing, without which there is nothing to compute")
        for part in self.asks.parts():
            values.outdo(part.rivals)
            if "settle" in vars(part):
                part.settle(values)
        self._settle_words(values)

    def question(self, values: Values) -> Any:
        asked = self.asks(values)
        question = asked.question()
        for name, one in self.options.items():
            if name not in values.read and values.typed(name) and values.says(name):
                raise ProblemError(asked.refusal(one))
        return question


class Function(Protocol):
    """A command as a function of Python, in the words of the command line; some draw."""

    command: Command
    __name__: str

    def __call__(self, *args: Any, **options: Any) -> Any: ...
    def question(self, *args: Any, **options: Any) -> Any:
        """Return what is asked for, checked, without making the table."""

    def interactive(self, *args: Any, **options: Any) -> Table:
        """Return the table of an interactive page, to be saved as HTML, with a slider for several values."""


def function(asks: type[CommandOptions], name: str, drawn: bool = False) -> Function:
    """Return the function of a command that is made of parts."""
    return _function(PartsCommand(asks, name), name, asks.__module__, drawn)


def _function(command: Command, name: str, module: str, drawn: bool = False) -> Function:
    def question(*args: Any, **options: Any) -> Any:
        return command.ask(_values(command, args, options))

    def make(*args: Any, **options: Any) -> Table:
        values = _values(command, args, options)
        asked = command.ask(values)
        return _table(command.built(asked, values), asked)

    def interactive(*args: Any, **options: Any) -> Table:
        from kurbel.commands.steps.stepped import NOTHING, stepped

        page = stepped(command, _values(command, args, options))
        if page.steps is None:
            raise ProblemError(NOTHING)
        return _table(page)

    found = question if drawn else make
    found.__name__ = found.__qualname__ = name
    found.__module__ = module
    found.__doc__ = described(command.doc, command.signature)
    vars(found).update(
        command=command,
        __signature__=plain_signature(command.signature, "Drawing" if drawn else "Table"),
        **({} if drawn else {"question": question, "interactive": interactive}),
    )
    return cast("Function", found)


def _values(command: Command, args: tuple[Any, ...], options: Mapping[str, Any]) -> Values:
    """Return what is given by hand, and what a machine's file says."""
    by_hand = bound(command.name, command.signature, args, options).arguments
    machine = by_hand.pop(MACHINE, None)
    # None says nothing, also of an option with another default.
    given = {
        one.name: one.taken(by_hand[key])
        for key, one in command.parameters.items()
        if key in by_hand and (by_hand[key] is not None or one.required)
    }
    found = {} if machine is None else of_machine(command, machine)
    origins = {**dict.fromkeys(found, Origin.MACHINE), **dict.fromkeys(given, Origin.TYPED)}
    return Values({**command.defaults, **found, **given}, origins)


def _table(page: Page, asked: Any = None) -> Table:
    from kurbel.commands.shown import Table

    return Table.of(page, asked)


def of_machine(command: Command, file: Any) -> dict[str, Any]:
    """Return the options of the command that a machine's file gives. Raises KurbelError."""
    from kurbel.commands.machine_file import machine_defaults

    many = {name: one.many for name, one in command.options.items()}
    named = File(fspath(FILE.taken(file, MACHINE)))
    found = machine_defaults(command.name, many, named)
    return {name: command.options[name].taken(value) for name, value in found.items()}


def variant(key: str, parameters: Mapping[str, Option[Any]], values: Mapping[str, Any]) -> Variant | None:
    """Return what gives the page its name, such as "kinematics-ratio-1-4" or "kinematics-method-series"; None
    for one with its defaults, or with a label of the author's own."""
    if values.get("label"):
        return None
    told = [one for one in parameters.values() if one.name not in UNTOLD and _is_other(one, values)]
    words = [("" if one.positional else f"{one.name} ") + _text(values[one.name]) for one in told]
    said = " ".join(words)
    signed = re.sub(_MINUS, "minus ", said.replace(",", ".").replace("%", " percent"))
    name = re.sub(_PARTS, "-", signed).strip("-.")
    return None if name in ("", key) else partial(_variant_name, f"{key}-", name, said)


def _variant_name(key: str, name: str, said: str) -> str:
    """Return the name; one that is long, or cannot say all of a value, ends with figures from all of it."""
    if len(name) <= LONGEST and re.fullmatch(_FIGURES, said):
        return key + name
    from hashlib import sha256

    return f"{key}{name[:LONGEST].rstrip('-.')}-{sha256(said.encode()).hexdigest()[:6]}"


def _is_other(one: Option[Any], values: Mapping[str, Any]) -> bool:
    value = values.get(one.name)
    return is_given(value) and (not is_given(one.default) or _text(value) != _text(one.default))


def _text(value: Any) -> str:
    if value is True:
        return ""
    if isinstance(value, str) or not isinstance(value, Collection):
        return str(value)
    return ";".join(map(_text, value))
