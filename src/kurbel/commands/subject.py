"""A command as a function in the words of the command line: called it makes the table, and `question` is what
it asks; what a machine's file says of its options, and how Python shows it."""

from __future__ import annotations

import inspect
import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, Protocol, cast

from kurbel.commands.options import FILE, TEXT, Choice, Option, alone_of, is_given
from kurbel.commands.part import CommandOptions, Origin, Values, flag_of
from kurbel.commands.parts.drawing import DrawingOptions
from kurbel.errors import KurbelError, MachineError, ProblemError
from kurbel.page.subject import Question
from kurbel.page.table import Request, own_words
from kurbel.reading.given import File, found_at
from kurbel.reading.names import bound, spelling_keywords

if TYPE_CHECKING:
    from kurbel.commands.shown import Table
    from kurbel.page.table import Table as Page
    from kurbel.page.table import Variant
    from kurbel.reading.amounts import Units

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
# What those commands are about that a list of unlike cylinders says nothing to.
_ALIKE = {
    "pressures": "one",
    "construct": "one",
    **dict.fromkeys(("power", "balance", "locomotive", "firing"), "cylinders alike"),
}
# Lines of the command line, which stand behind a \\b.
_COMMAND_LINES = re.compile(r"\n*\x08\n(?:.+\n?)*")


class Command:
    """What stands behind a function: its parts, their options in the order of its parameters, what is asked
    for by their values, and what is made of that."""

    def __init__(self, asks: type[CommandOptions], name: str) -> None:
        self.asks, self.name, self.doc, self.builder = asks, name, inspect.getdoc(asks) or "", asks.builder
        ranks = {key: rank for rank, key in enumerate(asks.sequence.split())}
        first = asks.unnamed.split()

        def place(one: tuple[str, Option[object]]) -> tuple[bool, bool, int]:
            return one[0] not in first, one[1].last, ranks.get(one[0], len(ranks))

        parameters = dict(sorted(asks.options().items(), key=place))
        self.signature = inspect.Signature(
            [
                inspect.Parameter(
                    key,
                    inspect.Parameter.POSITIONAL_OR_KEYWORD
                    if key in first
                    else inspect.Parameter.KEYWORD_ONLY,
                    # What is required may be the machine's.
                    default=inspect.Parameter.empty
                    if one.required and MACHINE not in parameters
                    else one.default,
                    annotation=one,
                )
                for key, one in parameters.items()
            ]
        )
        self.parameters = {key: one for key, one in parameters.items() if key != MACHINE}

    @property
    def machine(self) -> bool:
        """Whether a machine's file may describe what it is about."""
        return MACHINE in self.signature.parameters

    @cached_property
    def options(self) -> Mapping[str, Option[object]]:
        """The options by their names on the command line, with underscores."""
        return {one.name: one for one in self.parameters.values()}

    def keywords(self) -> Mapping[str, Collection[str]]:
        """Return the keywords of the function, each with those of its values that are words."""
        words = {
            key: [*one.kind.names] if isinstance(one.kind, Choice) else []
            for key, one in self.parameters.items()
        }
        return {**dict.fromkeys(DrawingOptions.options(), ()), MACHINE: (), "interactive": (), **words}

    @cached_property
    def defaults(self) -> Mapping[str, object]:
        return {name: one.default for name, one in self.options.items()}

    def settle(self, values: Values) -> None:
        """Settle the values with one another: what was typed outdoes what comes from elsewhere. Raises
        KurbelError."""
        for name, default in self.defaults.items():
            value = values.values.get(name)
            # What may be repeated and was not given.
            if isinstance(value, tuple) and not value and not values.origins.get(name):
                values.values[name] = default
        for one in self.options.values():
            if one.required and not values.says(one.name):
                raise ProblemError(f"{one.flag} is missing, without which there is nothing to compute")
        for part in self.asks.parts():
            values.outdo(part.rivals)
            if "settle" in vars(part):
                part.settle(values)
        if values.says(*OWN_WORDS):
            values.values.update(own_words(values.values))
        if "units" in values.values:
            values.values["units"] = self._units(values.values["units"], values.written)

    def question(self, values: Values) -> Any:
        """Return what is asked for, or drawn, by values that are settled. Raises KurbelError."""
        asked = self.asks(values)
        question = asked.question()
        for name, one in self.options.items():
            if name not in values.read and values.typed(name) and values.says(name):
                raise ProblemError(asked.refusal(one))
        return question

    def ask(self, values: Values) -> Any:
        """Return what is asked for by these values, which it settles. Raises KurbelError."""
        with self.naming_places(values):
            self.settle(values)
            return self.question(values)

    @contextmanager
    def naming_places(self, values: Values) -> Iterator[None]:
        """Have a sentence say where the value stands without which it were not said, or which it names."""
        try:
            yield
        except KurbelError as error:
            found = [name for name in values.places if self._asks_without(name, values)]
            found += [one for one in values.places if _names(str(error), one, values.written.get(one))]
            place = values.places[found[0]] if found else ""
            # Of a cylinder a sentence begins with file and line.
            if place.rpartition(" ")[2] not in str(error):
                error.args = (f"{place}: {error}", *error.args[1:])
            raise

    def _asks_without(self, name: str, values: Values) -> bool:
        """Whether there is a question without the value of an option."""
        others = {**self.defaults, **values.written, name: self.defaults.get(name)}
        alone = Values(others, {**values.origins, name: None})
        try:
            self.settle(alone)
            self.question(alone)
        except KurbelError:
            return False
        return True

    def built(self, question: Question, values: Values) -> Page:
        """Return the table that was asked for, which these values of the options name."""
        page = cast("Page", found_at(self.builder)(question))
        named = variant(page.key, self.parameters, values.values)
        return replace(page, variant=named, request=self.request(question, values))

    def request(self, question: Question, values: Values) -> Request:
        """Return what counted of the values of a question, as they were written."""
        written = values.written
        counted = {
            name: alone_of(written[name])
            for name, one in self.options.items()
            if name in values.read - UNTOLD and _is_other(one, written)
        }
        # A page with a label of its author's does not say by its name which layout it has.
        if "layout" in self.options and question.label:
            counted["layout"] = question.layout.key
        return Request(self.name, counted)

    def _units(self, asked: object, values: Mapping[str, object]) -> Units | None:
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

        if not is_given(asked):
            return read_units(IMPERIAL)._replace(data=False)
        several = asked if isinstance(asked, Iterable) and not isinstance(asked, str) else [asked]
        return read_units(";".join(map(str, several)))


class Function(Protocol):
    """A command as a function of Python, in the words of the command line; some draw."""

    command: Command
    __name__: str

    def __call__(self, *args: object, **options: object) -> Any: ...
    def question(self, *args: object, **options: object) -> Any:
        """Return what is asked for, checked, without making the table."""

    def interactive(self, *args: object, **options: object) -> Table:
        """Return the table of an interactive page, to be saved as HTML, with a slider for several values."""


def function(asks: type[CommandOptions], name: str, drawn: bool = False) -> Function:
    """Return the function of a command that is made of parts."""
    command = Command(asks, name)

    def question(*args: object, **options: object) -> Any:
        with spelling_keywords(command.keywords):
            return command.ask(_values(command, args, options))

    def make(*args: object, **options: object) -> Table:
        with spelling_keywords(command.keywords):
            values = _values(command, args, options)
            asked = command.ask(values)
            return _table(command.built(asked, values), asked)

    def interactive(*args: object, **options: object) -> Table:
        from kurbel.commands.stepped import NOTHING, stepped

        with spelling_keywords(command.keywords):
            page = stepped(command, _values(command, args, options))
            if page.steps is None:
                raise ProblemError(NOTHING)
            return _table(page)

    found = question if drawn else make
    found.__name__ = found.__qualname__ = name
    found.__module__ = asks.__module__
    found.__doc__ = described(command.doc, command.signature)
    vars(found).update(
        command=command,
        __signature__=plain_signature(command.signature, "Drawing" if drawn else "Table"),
        **({} if drawn else {"question": question, "interactive": interactive}),
    )
    return cast("Function", found)


def _values(command: Command, args: tuple[object, ...], options: Mapping[str, object]) -> Values:
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
    places = {name: f"{name} of {machine}" for name in found if name not in given}
    return Values({**command.defaults, **found, **given}, origins, places)


def _table(page: Page, asked: Question | None = None) -> Table:
    from kurbel.commands.shown import Table

    return Table.of(page, asked)


def of_machine(command: Command, file: object) -> dict[str, object]:
    """Return the options of the command that a machine's file gives. Raises KurbelError."""
    many = {name: one.many for name, one in command.options.items()}
    named = File(str(FILE.taken(file, MACHINE)))
    found = machine_defaults(command.name, many, named)
    return {name: command.options[name].taken(value) for name, value in found.items()}


def variant(
    key: str, parameters: Mapping[str, Option[object]], values: Mapping[str, object]
) -> Variant | None:
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


def _names(sentence: str, option: str, value: object) -> bool:
    several = value if isinstance(value, list | tuple) else [value]
    quoted = any(f'"{one}"' in sentence for one in several)
    return quoted or re.search(rf"{flag_of(option)}(?![\w-])", sentence) is not None


def _is_other(one: Option[object], values: Mapping[str, object]) -> bool:
    value = values.get(one.name)
    return is_given(value) and (not is_given(one.default) or _text(value) != _text(one.default))


def _text(value: object) -> str:
    if value is True:
        return ""
    if isinstance(value, str) or not isinstance(value, Collection):
        return str(value)
    return ";".join(map(_text, value))


def machine_defaults(command: str, options: Mapping[str, bool], file: File) -> dict[str, object]:
    """Return what the file says of the options of the command, by their names, with whether each may be
    repeated."""
    from kurbel.commands.machine_file import read_machine, with_ratio

    machine = read_machine(file)
    if "rod" not in options:
        machine = with_ratio(machine)
    # What knows neither of the two is not about the motion of a drive.
    for name in ("offset", "mechanism") if {"ratio", "stroke"} & {*options} else ():
        if machine.get(name, "straight") != "straight" and name not in options:
            raise MachineError(
                f"{file}: crank.{name} is {machine[name]}, and kurbel {command} is about the"
                f" straight crank; leave the {name} out of the machine"
            )
    if machine.get("cylinder") and "cylinder" not in options and (alike := _ALIKE.get(command)):
        raise MachineError(
            f"{file}: the machine has a list of cylinders, and kurbel {command} is about {alike}; take"
            " the list out, and write what one of them has into the sections, as bore into [steam] and"
            " reciprocating into [masses]"
        )
    # What may be repeated is a list, though the machine has one of it.
    return {
        name: [value] if options[name] and isinstance(value, str) else value
        for name, value in machine.items()
        if name in options
    }


class _Brief(inspect.Signature):
    """A signature of many parameters, which is printed without those that have names; `help` lists them."""

    def __str__(self) -> str:
        placed = [one for one in self.parameters.values() if one.kind is not one.KEYWORD_ONLY]
        shown = [one.name if one.default is one.empty else f"{one.name}={one.default!r}" for one in placed]
        return f"({', '.join([*shown, '**options'])}) -> {self.return_annotation}"

    def format(self, **_: object) -> str:
        return str(self)


def plain_signature(signature: inspect.Signature, returned: str) -> inspect.Signature:
    """Return the signature with the plain types of its parameters."""
    plain = [one.replace(annotation=plain_type(one.annotation)) for one in signature.parameters.values()]
    return _Brief(plain, return_annotation=returned)


def plain_type(option: Option[object]) -> str:
    """Return what an option takes in a few words, "str | float | list"."""
    return f"{option.kind.python} | list" if option.many else option.kind.python


def described(text: str, signature: inspect.Signature) -> str:
    """Return the docstring for Python of a function whose docstring is the help of a command.

    Examples of the command line stand behind a \\b there, those of Python behind a \\f.
    """
    about, _, examples = inspect.cleandoc(text).partition("\f")
    lines = [
        _COMMAND_LINES.sub("", about).rstrip(),
        "",
        "Values are text as on the command line, or numbers, lists of them, and arrays.",
        "Raises KurbelError, of one sentence, for what cannot be asked or answered.",
        "",
    ]
    for name, one in signature.parameters.items():
        option: Option[object] = one.annotation
        unit = f" A bare number is in {option.unit}." if option.unit else ""
        usual = "" if one.default in (None, False, "", (), one.empty) else f" = {one.default!r}"
        lines.append(f"{name} ({plain_type(one.annotation)}{usual}): {option.help}{unit}")
    return "\n".join([*lines, examples.rstrip()]) + "\n"
