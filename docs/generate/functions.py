"""The pages of `import kurbel`, a page a function, made of the functions themselves."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator
from typing import Any

from markdown import described, directive, plain, table, toctree

import kurbel
from kurbel import errors
from kurbel.commands.options import Option
from kurbel.commands.shown import Drawing, Table
from kurbel.commands.subject import Command

FOLDER = "reference/python"
_MODULE = "```{py:currentmodule} kurbel\n```"


def pages() -> Iterator[tuple[str, str]]:
    yield f"{FOLDER}/index.md", _joined(_overview())
    yield f"{FOLDER}/objects.md", _joined(_objects())
    for name in functions():
        yield f"{FOLDER}/{name}.md", _joined(_function(name))


def functions() -> list[str]:
    return [name for name in kurbel.__all__ if inspect.isfunction(getattr(kurbel, name))]


def _joined(parts: Iterator[str]) -> str:
    return "\n\n".join(parts) + "\n"


def _overview() -> Iterator[str]:
    yield "# Python\n\n```{py:module} kurbel\n```"
    yield from described(inspect.cleandoc(kurbel.__doc__ or ""))
    rows = [(f"[`{name}`]({name}.md)", plain(_first_line(getattr(kurbel, name)))) for name in functions()]
    yield table(("function", "what it does"), rows)
    yield "What they return and raise is [on a page of its own](objects.md)."
    yield "## Units\n\nText is read as on the command line; numbers without a unit are in these:"
    yield table(("bare numbers of", "are in"), _units())
    yield toctree((*functions(), "objects"), ":hidden:")


def _units() -> list[tuple[str, str]]:
    units: dict[str, set[str]] = {}
    for name in functions():
        command = _command(name)
        for key, one in command.parameters.items() if command else ():
            if one.unit:
                units.setdefault(one.unit, set()).add(key)
    return [(", ".join(f"`{key}`" for key in sorted(keys)), plain(unit)) for unit, keys in units.items()]


def _first_line(found: Callable[..., Any]) -> str:
    return inspect.cleandoc(found.__doc__ or "").split("\n\n")[0]


def _command(name: str) -> Command | None:
    found = getattr(getattr(kurbel, name), "command", None)
    return found if isinstance(found, Command) else None


def _function(name: str) -> Iterator[str]:
    yield f"# kurbel.{name}\n\n{_MODULE}"
    function, command = getattr(kurbel, name), _command(name)
    if not command:
        yield directive(
            "py:function", f"{name}{_signature(function)}", "\n\n".join(described(_doc(function)))
        )
        return
    about, _, behind = inspect.cleandoc(command.doc).partition("\f")
    parts = [*described(about)]
    parts.append("Values are text as on the command line, or numbers, lists of them, and arrays.")
    if behind.strip():
        parts.extend(described(inspect.cleandoc(behind)))
    returned = "Drawing" if name.startswith("plot_") else "Table"
    fields = [_field(key, one.annotation) for key, one in command.signature.parameters.items()]
    fields += [f":returns: a {{py:class}}`{returned}`", ":raises KurbelError: what was given cannot be"]
    parts.append("\n".join(fields))
    yield directive("py:function", f"{name}{_bare(command.signature)}", "\n\n".join(parts))


def _doc(found: Any) -> str:
    return inspect.cleandoc(found.__doc__ or "")


def _field(name: str, option: Option[Any]) -> str:
    unit = f" A bare number is in {option.unit}." if option.unit else ""
    return f":param {name}: {plain(option.help + unit)}"


def _bare(signature: inspect.Signature) -> str:
    """Return the signature of a command's function without its annotations, which are the options."""
    bare = [one.replace(annotation=one.empty) for one in signature.parameters.values()]
    return str(inspect.Signature(bare))


def _signature(function: Callable[..., Any]) -> str:
    return str(inspect.signature(function)).replace("'", "")


def _objects() -> Iterator[str]:
    yield f"# What the functions return and raise\n\n{_MODULE}"
    for kind in (Table, Drawing):
        members = [_member(name, one) for name, one in vars(kind).items() if _is_public(name, one)]
        yield f"## {kind.__name__}"
        yield directive("py:class", kind.__name__, "\n\n".join((*described(_doc(kind)), *members)))
    yield "## Errors"
    yield plain(
        "Every error is a `KurbelError` with one sentence, which the command line prints; it ends with the"
        " `exit_code`."
    )
    for error in vars(errors).values():
        if inspect.isclass(error) and issubclass(error, errors.KurbelError):
            about = "\n\n".join((*described(_doc(error)), f"`exit_code` is {error.exit_code}."))
            place = error.__name__ if error is errors.KurbelError else f"kurbel.errors.{error.__name__}"
            yield directive("py:exception", place, about)


def _is_public(name: str, one: object) -> bool:
    return not name.startswith("_") and (inspect.isfunction(one) or isinstance(one, property))


def _member(name: str, one: Any) -> str:
    about = "\n\n".join(described(_doc(one)))
    if isinstance(one, property):
        return directive("py:property", name, about)
    signature = inspect.signature(one)
    own = signature.replace(parameters=[*signature.parameters.values()][1:])
    return directive("py:method", f"{name}{own}".replace("'", ""), about)
