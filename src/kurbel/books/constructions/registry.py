"""The constructions by their names on the command line: kurbel's own, and those in a folder of the user's."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from functools import cache

from kurbel.books.constructions.file import HOUSE, read_construction
from kurbel.books.constructions.model import Construction
from kurbel.errors import ChoiceError, ConstructionError
from kurbel.page.layouts import Folder
from kurbel.reading.given import File, choose

_NAME = r"[A-Za-z0-9]+(?:-+[A-Za-z0-9]+)*"
# Ensslin (1907) names these, too; no text that says their steps was found, so they are not drawn.
UNFOUND: Mapping[str, str] = {
    "mohr": "Mohr",
    "mehmke": "Mehmke",
    "bour-pröll": "Bour and Pröll",
    "bour-proell": "Bour and Pröll",
    "pröll": "Bour and Pröll",
    "proell": "Bour and Pröll",
    "bour": "Bour and Pröll",
}


def unfound(name: object) -> str:
    """Return the sentence for a construction that has no source, nothing for others."""
    author = UNFOUND.get(name.casefold()) if isinstance(name, str) else None
    if author is None:
        return ""
    return (
        f"the construction of {author} is not drawn, for no source that says its steps was found; klein,"
        " rittershaus and autenrieth give the same length"
    )


def construction_names(folder: Folder | None = None) -> tuple[str, ...]:
    """Return the names of kurbel's constructions, and of those in a folder of the user's.

    Raises ConstructionError for a folder that has none.
    """
    own = _names(HOUSE)
    if folder is None:
        return own
    if not os.fspath(folder):
        raise ConstructionError("the folder of constructions has no name; give one, such as figures")
    if not os.path.isdir(folder):
        raise ConstructionError(f"cannot read the constructions {folder}: there is no such folder")
    if not (theirs := _names(folder)):
        raise ConstructionError(f"{folder} has no constructions: no file in it ends in .toml")
    for name in theirs:
        if not re.fullmatch(_NAME, name):
            raise ConstructionError(
                f"{_file(folder, name)}: the file {name[:60]} names it; use letters, digits and -"
            )
    return tuple(dict.fromkeys((*own, *theirs)))


def _names(folder: Folder) -> tuple[str, ...]:
    try:
        files = sorted(name for name in os.listdir(folder) if name.endswith(".toml"))
    except OSError as error:
        raise ConstructionError(f"cannot read the constructions {folder}: {error.strerror}") from None
    return tuple(name.removesuffix(".toml") for name in files)


def _file(folder: Folder, name: str) -> Folder:
    file = os.path.join(str(folder), f"{name}.toml")
    return folder.named(file) if isinstance(folder, File) else file


def construction(name: str, folder: Folder | None = None, mechanism: str = "") -> Construction:
    """Return the construction of that name, as it is of a mechanism, by default the first for which it holds.

    `folder` is one of the user's, whose constructions stand beside kurbel's own and outdo those of their
    names. Raises ChoiceError where there is none of that name, ConstructionError with file and line for one
    that cannot be used.
    """
    if folder is not None and os.path.exists(_file(folder, name)) and name in construction_names(folder):
        return read_construction(_file(folder, name), name, os.path.abspath(folder), mechanism)
    if sentence := unfound(name):
        raise ChoiceError(sentence)
    return _own(choose(name, construction_names(folder), "construction"), mechanism)


@cache
def _own(name: str, mechanism: str) -> Construction:
    return read_construction(_file(HOUSE, name), name, None, mechanism)
