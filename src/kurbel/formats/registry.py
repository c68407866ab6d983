"""The registry of output formats: the folders beside this file, each with its `FORMAT`."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, cast

import kurbel.formats
from kurbel.errors import ChoiceError
from kurbel.exact.numerals import DECIMAL_OF_LANGUAGE as DECIMAL_OF_LANGUAGE
from kurbel.exact.numerals import DECIMALS as DECIMALS
from kurbel.formats.format import CompiledFormat, PageFormat
from kurbel.formats.format import Format as Format

if TYPE_CHECKING:
    from kurbel.documents.inject import Kind

# What is printed where nobody asks for a format.
DEFAULT = "text"


class _Formats(Mapping[str, Format]):
    """The formats by their names, in their order; asked for by name, only its own folder is read.

    A folder elsewhere joins them once its parent is on `kurbel.formats.__path__`.
    """

    def __getitem__(self, name: str) -> Format:
        if name not in _folders(*kurbel.formats.__path__):
            raise KeyError(name)
        return _format(name)

    def __iter__(self) -> Iterator[str]:
        return iter(_in_order(*kurbel.formats.__path__))

    def __len__(self) -> int:
        return len(_folders(*kurbel.formats.__path__))


@cache
def _folders(*path: str) -> frozenset[str]:
    return frozenset(
        entry.name
        for place in path
        for entry in os.scandir(place)
        if os.path.exists(f"{entry.path}/__init__.py")
    )


@cache
def _in_order(*path: str) -> tuple[str, ...]:
    return tuple(sorted(_folders(*path), key=lambda name: _format(name).rank))


def _format(name: str) -> Format:
    return cast("Format", import_module(f"kurbel.formats.{name}").FORMAT)


FORMATS: Mapping[str, Format] = _Formats()


def by_name(name: str) -> Format:
    """Return the format of that name; raise ChoiceError if there is none."""
    if name not in FORMATS:
        raise ChoiceError(f"format is {name!r}; it must be one of {', '.join(FORMATS)}")
    return FORMATS[name]


def page_format(name: str) -> PageFormat:
    """Return the format of pages of that name; raise ChoiceError if there is none."""
    form = by_name(name)
    if not isinstance(form, PageFormat):
        raise ChoiceError(f"{name} is no format of pages")
    return form


def compiled_format() -> CompiledFormat:
    """Return the format of bytes in which handbooks are set."""
    return next(form for form in FORMATS.values() if isinstance(form, CompiledFormat))


def for_suffix(path: str) -> Format:
    """Return the format that a file name asks for; raise ChoiceError if its suffix belongs to none."""
    suffix = os.path.splitext(path)[1].lower()
    for entry in FORMATS.values():
        if suffix in entry.suffixes:
            return entry
    known = ", ".join(suffix for entry in FORMATS.values() for suffix in entry.suffixes)
    raise ChoiceError(f"the file name {str(path)!r} names no format; its suffix must be one of {known}")


def kinds() -> list[tuple[PageFormat, Kind]]:
    """Return the formats whose documents can have marked places; those whose comments have an end first."""
    pages = [form for form in FORMATS.values() if isinstance(form, PageFormat)]
    found = [(form, kind) for form in pages if (kind := form.marked())]
    return sorted(found, key=lambda one: not one[1].right)


def kind_of(path: str) -> tuple[PageFormat, Kind]:
    """Return the format of a document with marked places, and its kind, by the suffix of its name."""
    suffix = os.path.splitext(path)[1].lower()
    for form, kind in kinds():
        if suffix in kind.suffixes:
            return form, kind
    known = ", ".join(suffix for _, kind in kinds() for suffix in kind.suffixes)
    raise ChoiceError(
        f'the name "{path[-60:]}" tells no kind of document with markers; its suffix must be one of {known}'
    )
