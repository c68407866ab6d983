"""Where kurbel runs: the date for what is made, SOURCE_DATE_EPOCH, and what installs a library."""

from __future__ import annotations

import json
import os
import shlex
import sys
from collections.abc import Mapping
from importlib.util import find_spec
from typing import TypedDict

from kurbel.errors import MissingExtraError, NotationError

# A browser has none but its own.
HAS_PROCESSES = sys.platform != "emscripten"
EPOCH = "SOURCE_DATE_EPOCH"
# The last second of the year 9999, with which dates in a PDF end.
LAST = 253402300799


def source_date_epoch() -> int | None:
    """Return the date that the environment sets for what is made, in seconds since 1970, if it does."""
    text = os.environ.get(EPOCH, "")
    if not text:
        return None
    if not (text.isascii() and text.isdigit() and int(text[:20]) <= LAST):
        raise NotationError(
            f'{EPOCH} is "{text[:40]}"; it must be a number of seconds from 1970 up to the year 9999'
        )
    return int(text)


def missing_extra(sentence: str, extra: str) -> MissingExtraError:
    """Return the error that says what is needed and what installs it."""
    return MissingExtraError(f"{sentence}; install it with: {how_to_install(extra)}")


def missing_library(sentence: str, library: str) -> MissingExtraError:
    """Return the error for a library of the reader's own choice, which belongs to no extra."""
    return MissingExtraError(f"{sentence}; install it with: {_installer()} {library}")


def need(what: str, extra: str, *libraries: str) -> None:
    """Raise MissingExtraError if one of the libraries, which the extra brings, is not installed."""
    for library in libraries:
        if find_spec(library) is None:
            raise missing_extra(f"{what} needs {library}", extra)


def how_to_install(extra: str) -> str:
    """Return the command that adds the extra to this installation.

    It names where kurbel was installed from, as the installer noted it (direct_url.json, PEP 610), never the
    bare name kurbel; where nothing is noted, the libraries of the extra.
    """
    return f"{_installer()} {' '.join(_quoted(word) for word in _wanted(extra))}"


def _wanted(extra: str) -> list[str]:
    # Nothing else asks what is installed.
    from importlib.metadata import PackageNotFoundError, distribution

    try:
        installed = distribution("kurbel")
    except PackageNotFoundError:
        return [f".[{extra}]"]
    noted = installed.read_text("direct_url.json")
    if noted:
        return _from_source(json.loads(noted), extra)
    return [
        needed.partition(";")[0].strip()
        for needed in installed.requires or ()
        if f"extra == '{extra}'" in needed.replace('"', "'")
    ]


class InstallNote(TypedDict, total=False):
    """What pip notes of a library that came from a checkout or from a repository."""

    url: str
    vcs_info: Mapping[str, str]
    dir_info: Mapping[str, bool]


def _from_source(noted: InstallNote, extra: str) -> list[str]:
    url = noted["url"]
    if "vcs_info" in noted:
        vcs = noted["vcs_info"]
        return [f"kurbel[{extra}] @ {vcs['vcs']}+{url}@{vcs['commit_id']}"]
    if "dir_info" not in noted:
        return [f"kurbel[{extra}] @ {url}"]
    folder = f"{_path(url)}[{extra}]"
    return ["--editable", folder] if noted["dir_info"].get("editable") else [folder]


def _path(url: str) -> str:
    from urllib.parse import urlsplit
    from urllib.request import url2pathname

    return url2pathname(urlsplit(url).path)


def _installer() -> str:
    python = _quoted(sys.executable)
    return f"{python} -m pip install" if find_spec("pip") else f"uv pip install --python {python}"


def _quoted(word: str) -> str:
    """Return a word as a shell takes it: quotes that cmd and PowerShell know too on Windows."""
    if os.name == "nt":
        return f'"{word}"' if set(word) & set(" []@;<>=") else word
    return shlex.quote(word)
