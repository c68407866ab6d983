"""The names of a function's values: what cannot be one is refused by a sentence that says the nearest."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Collection, Mapping, Sequence
from functools import wraps
from typing import Any, ParamSpec, TypeVar

from kurbel.errors import KeywordError
from kurbel.reading.given import did_you_mean

Words = ParamSpec("Words")
Answer = TypeVar("Answer")
# What says how a page is written, and not what stands on it.
WRITING = frozenset(("format", "decimal", "output", "standalone", "longtable", "siunitx", "plain", "excel"))


def checks_keywords(function: Callable[Words, Answer]) -> Callable[Words, Answer]:
    """Refuse wrong names of the function's values by KeywordError."""

    @wraps(function)
    def called(*args: Words.args, **kwargs: Words.kwargs) -> Answer:
        try:
            return function(*args, **kwargs)
        except TypeError:
            bound(function.__name__, inspect.signature(function), args, kwargs)
            raise

    return called


def bound(
    name: str, signature: inspect.Signature, args: Sequence[Any], kwargs: Mapping[str, Any]
) -> inspect.BoundArguments:
    """Return the values by the names of a function's parameters. Raises KeywordError."""
    try:
        return signature.bind(*args, **kwargs)
    except TypeError:
        raise KeywordError(_sentence(name, signature, args, kwargs)) from None


def unknown(function: str, keyword: str, known: Collection[str], listed: str = "") -> KeywordError:
    """Return the error of a keyword that the function has not; `listed` says where those are that it has."""
    if keyword in WRITING:
        value = '"latex"' if keyword == "format" else f"{keyword}=…"
        return KeywordError(
            f"kurbel.{function} has no keyword {keyword}, which is for a page once it is made:"
            f" kurbel.typeset(page, {value}), or page.save"
        )
    near = did_you_mean(keyword, known, words=True)
    listed = listed or f"help(kurbel.{function}) lists its keywords"
    return KeywordError(f'kurbel.{function} has no keyword "{keyword[:60]}"{near}; {listed}')


def _sentence(name: str, signature: inspect.Signature, args: Sequence[Any], kwargs: Mapping[str, Any]) -> str:
    parameters = signature.parameters
    wrong = next((one for one in kwargs if one not in parameters), None)
    if wrong is not None:
        return str(unknown(name, wrong, parameters))
    first = [one.name for one in parameters.values() if one.kind is one.POSITIONAL_OR_KEYWORD]
    if len(args) > len(first):
        named = f"{', '.join(first)} can stand without a name" if first else "all have names"
        return f"kurbel.{name} is given {len(args)} values without a name; {named}, others as name=value"
    twice = next((one for one in first[: len(args)] if one in kwargs), None)
    if twice is not None:
        return f"kurbel.{name} is given {twice} twice, by its place and by its name; leave one out"
    missing = next(
        one.name
        for place, one in enumerate(parameters.values())
        if one.default is one.empty and one.name not in kwargs and place >= len(args)
    )
    return f"kurbel.{name} needs {missing}; help(kurbel.{name}) says what it is"
