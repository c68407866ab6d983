"""What templates compiled ahead need of Jinja, which to load takes as long as a table does.

They are functions that Jinja's compiler wrote (scripts/made_ahead.py), one in each format's `ahead`; here is
what these call, by Jinja's names. A name or a field that there is not raises an error, as in StrictUndefined.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from types import SimpleNamespace
from typing import Any, NoReturn
from zlib import crc32

from kurbel.formats.page import blank
from kurbel.formats.registry import PageFormat

missing = object()


def filled(form: PageFormat, values: Mapping[str, object]) -> str | None:
    """Return what the template of the format's pages makes of the values; None if it was not compiled ahead.

    One that was changed since has another checksum.
    """
    if not os.path.exists(f"{form.templates}/../ahead.py"):
        return None
    with open(f"{form.templates}/{form.name}.jinja", "rb") as file:
        root = form.module("ahead").TEMPLATES.get(crc32(file.read()))
    return None if root is None else "".join(root(Context(values), Environment(form)))


class Environment:
    """What a template knows beside its values."""

    concat = "".join

    def __init__(self, form: PageFormat) -> None:
        self.filters = {**FILTERS, **form.writer.filters()}

    @staticmethod
    def getattr(of: Any, name: str) -> Any:
        try:
            return getattr(of, name)
        except AttributeError:
            return of[name]

    @staticmethod
    def getitem(of: Any, key: Any) -> Any:
        return of[key]

    @staticmethod
    def undefined(said: str = "", name: str = "") -> NoReturn:
        raise NameError(said or f"there is no {name}")


class Context:
    """The values of a page, and what the template sets itself."""

    def __init__(self, values: Mapping[str, object]) -> None:
        self.values = values
        self.vars: dict[str, object] = {}
        self.exported_vars: set[str] = set()
        self.eval_ctx = SimpleNamespace(autoescape=False)

    def resolve_or_missing(self, name: str) -> object:
        return self.values.get(name, missing)

    @staticmethod
    def call(called: Callable[..., Any], *given: Any, _loop_vars: object = None) -> Any:
        return called(*given)


class Macro:
    """A macro of a template, by its names for what it is given."""

    def __init__(
        self, _: Environment, body: Callable[..., str], name: str, names: tuple[str, ...], *more: Any
    ) -> None:
        self.body = body
        self.names = names

    def __call__(self, *given: Any) -> str:
        return self.body(*given, *[missing] * (len(self.names) - len(given)))


class LoopContext:
    """The values of a loop, each with the loop: where it is, and whether it goes on."""

    def __init__(self, values: Iterable[Any], _: object) -> None:
        self.values = iter(values)
        self.following = next(self.values, missing)
        self.index0 = -1

    def __iter__(self) -> Iterator[tuple[Any, LoopContext]]:
        while self.following is not missing:
            value, self.following = self.following, next(self.values, missing)
            self.index0 += 1
            yield value, self

    @property
    def index(self) -> int:
        return self.index0 + 1

    @property
    def first(self) -> bool:
        return not self.index0

    @property
    def last(self) -> bool:
        return self.following is missing


def Undefined(said: str) -> str:
    """The value of an if without an else."""
    return ""


# Of a block that is set; nothing is escaped here.
Markup = identity = str


def str_join(parts: Iterable[object]) -> str:
    return "".join(map(str, parts))


FILTERS: Mapping[str, Callable[..., Any]] = {
    "blank": blank,
    "dictsort": lambda values: sorted(values.items()),
    "format": lambda text, *values: str(text) % values,
    "join": lambda values, between="": between.join(map(str, values)),
    "length": len,
    "list": list,
    "rejectattr": lambda values, name: (one for one in values if not getattr(one, name)),
    "select": lambda values: filter(None, values),
    "trim": lambda text, signs=None: str(text).strip(signs),
}
