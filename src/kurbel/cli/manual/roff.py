"""Text in the notation of manual pages, man(7), for any program that shows them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from kurbel import __version__

# That of the version, so that two builds of it have the same pages.
DAY = "2026-11-22"
# Signs that typesetters take for others than those of the keyboard.
_SIGNS = {"\\": "\\e", "-": "\\-", "'": "\\(aq", "`": "\\(ga", "^": "\\(ha", "~": "\\(ti"}
_SIGN = re.compile(r"[\\\-'`^~]|[^\x00-\x7f]")


def escaped(text: str) -> str:
    """Return text of which no sign is a command."""
    shown = _SIGN.sub(lambda one: _SIGNS.get(one[0]) or f"\\[u{ord(one[0]):04X}]", text)
    # A dot that begins a line begins a command.
    return f"\\&{shown}" if shown.startswith(".") else shown


def bold(text: str) -> str:
    return f"\\fB{escaped(text)}\\fR"


def italic(text: str) -> str:
    return f"\\fI{escaped(text)}\\fR"


def title(name: str, section: int, line: str) -> Iterator[str]:
    """Yield how a page begins: its name, and what that is."""
    yield f'.TH "{escaped(name.upper())}" "{section}" "{DAY}" "kurbel {__version__}" "kurbel"'
    yield from heading("Name")
    yield f"{escaped(name)} \\- {escaped(line)}"


def heading(text: str) -> Iterator[str]:
    yield f'.SH "{escaped(text.upper())}"'


def section(text: str) -> Iterator[str]:
    yield f'.SS "{escaped(text)}"'


def paragraph(text: str) -> Iterator[str]:
    yield from (".PP", escaped(" ".join(text.split())))


def verbatim(lines: Iterable[str]) -> Iterator[str]:
    """Yield lines that stay as they are."""
    yield from (".PP", ".RS 4", ".nf", *map(escaped, lines), ".fi", ".RE")


def entry(head: str, text: str) -> Iterator[str]:
    """Yield a head, which is in this notation already, and what is said of it."""
    yield from (".TP", head, escaped(" ".join(text.split())))


def whole(lines: Iterable[str]) -> bytes:
    """Return the lines as a page, in which a head begins its first paragraph."""
    kept: list[str] = []
    for line in lines:
        if line != ".PP" or not (kept and kept[-1].startswith((".SH", ".SS"))):
            kept.append(line)
    return "".join(f"{line}\n" for line in kept).encode("ascii")
