"""A function in the words of the command line: called it makes the table, and `question` is what it asks."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Collection, Mapping
from dataclasses import replace
from functools import partial, wraps
from os import fspath
from typing import TYPE_CHECKING, Any, NamedTuple, ParamSpec, Protocol, TypeVar, cast

from kurbel.commands.in_python import described, plain_signature
from kurbel.commands.options import FILE, TEXT, Parameter, is_given, parameters_of, signature_of
from kurbel.errors import ProblemError
from kurbel.reading.given import File, found_at
from kurbel.reading.keywords import bound

if TYPE_CHECKING:
    from kurbel.commands.shown import Table
    from kurbel.page.table import Table as Page
    from kurbel.page.table import Variant
    from kurbel.reading.amounts import Units

Words = ParamSpec("Words")
Question = TypeVar("Question", covariant=True)
Drawn = TypeVar("Drawn", covariant=True)
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
# Options that stand for another, the stroke.
SPELLED = ("crank", "true_stroke", "time_ratio")


def spelling(values: Mapping[str, Any]) -> str:
    """Return the name of the option that gives the stroke."""
    return next((name for name in SPELLED if is_given(values.get(name))), "stroke")


def _none(values: Mapping[str, Any]) -> Mapping[str, str]:
    return {}


class Command(NamedTuple):
    """What stands behind a function.

    `ask` reads the values and returns what is asked for, or drawn; `built` makes a page of that. `foreign`
    names the options that belong to other cases than the one that the values are about, and `needless` those
    that say nothing in this one; each with its sentence. A default from elsewhere that is foreign is dropped,
    one that is needless is left to `ask`.
    """

    ask: Callable[..., Any]
    signature: inspect.Signature
    parameters: Mapping[str, Parameter]
    foreign: Refusals
    needless: Refusals = _none
    builder: str = ""

    @classmethod
    def of(
        cls,
        ask: Callable[..., Any],
        order: str = "",
        *about: Any,
    ) -> Command:
        signature = signature_of(ask, order)
        parameters = parameters_of(signature)
        parameters.pop(MACHINE, None)
        return cls(ask, signature, parameters, *about)

    @property
    def machine(self) -> bool:
        """Whether a machine's file may describe what it is about."""
        return MACHINE in self.signature.parameters

    @property
    def name(self) -> str:
        """What the command is called."""
        return self.ask.__name__.removesuffix("_table")

    def settled(self, values: Mapping[str, Any]) -> Mapping[str, Any]:
        """Return the values with those that are given in another way under the name of their option, and
        the units of the page as it takes them."""
        if any(is_given(values.get(name)) for name in OWN_WORDS):
            from kurbel.page.wording import own_words

            values = own_words(values)
        if "units" in values:
            values = {**values, "units": self._units(values)}
        if not any(is_given(values.get(name)) for name in SPELLED):
            return values
        from kurbel.drive.size.given import in_strokes

        return in_strokes(values)

    def _units(self, values: Mapping[str, Any]) -> Units | None:
        """Return the units that are asked for, else imperial ones where all measures are given in such."""
        asked = values["units"]
        names = {one.name for one in self.parameters.values() if one.option.unit or one.option.kind is TEXT}
        read = (names | {"cylinder"}) - UNTOLD - UNMEASURED
        measured = [values[name] for name in sorted(read) if is_given(values.get(name))]
        texts = str(measured) if measured else ""
        if not (texts or is_given(asked)):
            return None
        if not is_given(asked) and (re.search(_METRIC, texts) or not re.search(_IMPERIAL, texts)):
            return None
        from kurbel.reading.amounts import IMPERIAL, read_units

        return read_units(asked) if is_given(asked) else read_units(IMPERIAL)._replace(data=False)

    def built(self, question: Any, values: Mapping[str, Any]) -> Page:
        """Return the table that was asked for, which these values of the options name."""
        page = cast("Page", found_at(self.builder)(question))
        return replace(page, variant=variant(page.key, self.parameters, values))

    def refuse(
        self, values: Mapping[str, Any], given: Callable[[str], bool], spelled: str = "stroke"
    ) -> None:
        """Raise ProblemError for what was given in vain, which may be a stroke by another option."""
        for refusals in (self.foreign, self.needless):
            for name, sentence in refusals(values).items():
                if given(name):
                    raise ProblemError(sentence.replace("--stroke", f"--{spelled.replace('_', '-')}"))

    def arguments(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Return the values as the function takes them, by its parameters' names."""
        return {key: values[one.name] for key, one in self.parameters.items() if one.name not in SPELLED}


class Asking(Protocol[Words, Question]):
    """A function that makes a table."""

    command: Command

    def __call__(self, *args: Words.args, **kwargs: Words.kwargs) -> Table: ...
    def question(self, *args: Words.args, **kwargs: Words.kwargs) -> Question:
        """Return what is asked for, checked, without making the table."""

    def interactive(self, *args: Words.args, **kwargs: Words.kwargs) -> Table:
        """Return the table of an interactive page, to be saved as HTML, with a slider for several values."""


class Drawing(Protocol[Words, Drawn]):
    """A function that draws."""

    command: Command

    def __call__(self, *args: Words.args, **kwargs: Words.kwargs) -> Drawn: ...


def makes_table(
    *,
    foreign: Refusals = _none,
    needless: Refusals = _none,
    build: str = "kurbel.page.build:build",
    order: str = "",
) -> Callable[[Callable[Words, Question]], Asking[Words, Question]]:
    """Make of what returns a question a function that returns its table; the order is that of its options."""

    def decorate(ask: Callable[Words, Question]) -> Asking[Words, Question]:
        command = Command.of(ask, order, foreign, needless, build)
        question = _checked(command)

        @wraps(ask)
        def make(*args: Any, **kwargs: Any) -> Table:
            from kurbel.commands.shown import Table

            values = _given(command, args, kwargs)
            return Table.of(command.built(command.ask(**command.arguments(values)), values))

        more = {"question": question, "interactive": _interactive(command)}
        return cast("Asking[Words, Question]", _documented(make, command, **more))

    return decorate


def draws(
    *, foreign: Refusals = _none, needless: Refusals = _none
) -> Callable[[Callable[Words, Drawn]], Drawing[Words, Drawn]]:
    """Check what a function is given that draws."""

    def decorate(ask: Callable[Words, Drawn]) -> Drawing[Words, Drawn]:
        command = Command.of(ask, "", foreign, needless)
        return cast("Drawing[Words, Drawn]", _documented(_checked(command), command))

    return decorate


def _checked(command: Command) -> Callable[..., Any]:
    """Return the command's function with its options checked, all of which were given by hand."""

    @wraps(command.ask)
    def asked(*args: Any, **kwargs: Any) -> Any:
        return command.ask(**command.arguments(_given(command, args, kwargs)))

    return asked


def _interactive(command: Command) -> Callable[..., Table]:
    """Return what makes the table of the command with all its steps."""

    @wraps(command.ask)
    def make(*args: Any, **kwargs: Any) -> Table:
        from kurbel.commands.shown import Table
        from kurbel.commands.steps.stepped import NOTHING, stepped

        values = _given(command, args, kwargs)
        page = stepped(command, values, values)
        if page.steps is None:
            raise ProblemError(NOTHING)
        return Table.of(page)

    return make


def _given(command: Command, args: tuple[Any, ...], kwargs: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return the values of all options, settled and checked, by their names."""
    by_hand = bound(command.name, command.signature, args, kwargs).arguments
    machine = by_hand.pop(MACHINE, None)
    # None says nothing, also of an option with another default.
    given = {
        one.name: one.taken(by_hand[key])
        for key, one in command.parameters.items()
        if key in by_hand and (by_hand[key] is not None or one.required)
    }
    defaults = {one.name: one.default for one in command.parameters.values()}
    if machine is not None:
        return _on_machine(command, machine, defaults, given)
    values = {**defaults, **given}
    settled = command.settled(values)
    command.refuse(settled, lambda name: is_given(settled.get(name)), spelling(values))
    return settled


def of_machine(command: Command, file: Any) -> dict[str, Any]:
    """Return the options of the command that a machine's file gives. Raises KurbelError."""
    from kurbel.commands.machine_file import machine_defaults

    options = {one.name: one for one in command.parameters.values()}
    many = {name: one.option.many for name, one in options.items()}
    named = File(fspath(FILE.taken(file, MACHINE)))
    found = machine_defaults(command.name, many, named)
    return {name: options[name].taken(value) for name, value in found.items()}


def _on_machine(
    command: Command, file: Any, defaults: Mapping[str, Any], given: Mapping[str, Any]
) -> Mapping[str, Any]:
    """Return the values of all options where a machine's file gives what is not given by hand."""
    from kurbel.commands.precedence import RIVALS, Origin, Values

    found = of_machine(command, file)
    values = {**defaults, **found, **given}
    origins = {**dict.fromkeys(defaults), **dict.fromkeys(found, Origin.MACHINE)}
    told = Values(values, {**origins, **{name: Origin.TYPED for name in given if is_given(given[name])}})
    return told.resolved(
        command, RIVALS.get("plot" if command.name.startswith("plot_") else command.name, ())
    )


def _documented(function: Callable[..., Any], command: Command, **more: Any) -> Callable[..., Any]:
    function.__doc__ = described(command.ask.__doc__ or "", command.signature)
    returned = "Table" if command.builder else "Drawing"
    vars(function).update(command=command, __signature__=plain_signature(command.signature, returned), **more)
    return function


def variant(key: str, parameters: Mapping[str, Parameter], values: Mapping[str, Any]) -> Variant | None:
    """Return what gives the page its name, such as "kinematics-ratio-1-4" or "kinematics-method-series"; None
    for one with its defaults, or with a label of the author's own."""
    if values.get("label"):
        return None
    told = [one for one in parameters.values() if one.name not in UNTOLD and _is_other(one, values)]
    words = [("" if one.option.positional else f"{one.name} ") + _text(values[one.name]) for one in told]
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


def _is_other(one: Parameter, values: Mapping[str, Any]) -> bool:
    value = values.get(one.name)
    return is_given(value) and (not is_given(one.default) or _text(value) != _text(one.default))


def _text(value: Any) -> str:
    if value is True:
        return ""
    if isinstance(value, str) or not isinstance(value, Collection):
        return str(value)
    return ";".join(map(_text, value))
