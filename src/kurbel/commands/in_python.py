"""A function as Python shows it: its parameters with plain types, and what `help` says of each."""

from __future__ import annotations

import inspect
import re
from typing import Any

from kurbel.commands.options import Option

# Lines of the command line, which stand behind a \\b.
_COMMAND_LINES = re.compile(r"\n*\x08\n(?:.+\n?)*")


class _Brief(inspect.Signature):
    """A signature of many parameters, which is printed without those that have names; `help` lists them."""

    def __str__(self) -> str:
        placed = [one for one in self.parameters.values() if one.kind is not one.KEYWORD_ONLY]
        shown = [one.name if one.default is one.empty else f"{one.name}={one.default!r}" for one in placed]
        return f"({', '.join([*shown, '**options'])}) -> {self.return_annotation}"

    def format(self, **_: Any) -> str:
        return str(self)


def plain_signature(signature: inspect.Signature, returned: str) -> inspect.Signature:
    """Return the signature with the plain types of its parameters."""
    plain = [one.replace(annotation=plain_type(one.annotation)) for one in signature.parameters.values()]
    return _Brief(plain, return_annotation=returned)


def plain_type(option: Option[Any]) -> str:
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
        "",
    ]
    for name, one in signature.parameters.items():
        option: Option[Any] = one.annotation
        unit = f" A bare number is in {option.unit}." if option.unit else ""
        usual = "" if one.default in (None, False, "", (), one.empty) else f" = {one.default!r}"
        lines.append(f"{name} ({plain_type(one.annotation)}{usual}): {option.help}{unit}")
    return "\n".join([*lines, examples.rstrip()]) + "\n"
