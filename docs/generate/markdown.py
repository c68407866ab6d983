"""Markdown as the pages of the reference need it: text as it stands, examples, directives, tables."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

_SPECIAL = re.compile(r"([\\*_<>\[\]$#~|&])")


def plain(text: str) -> str:
    """Return a text of which Markdown takes nothing for its own but `code`."""
    parts = " ".join(text.split()).split("`")
    return "`".join(part if at % 2 else _SPECIAL.sub(r"\\\1", part) for at, part in enumerate(parts))


def fenced(kind: str, lines: Iterable[str]) -> str:
    return "\n".join((f"```{kind}", *lines, "```"))


def directive(name: str, argument: str, body: str) -> str:
    """Return a directive, whose colons are more than those of any in it."""
    deepest = max((len(found) for found in re.findall(r"^:+(?=\{)", body, re.MULTILINE)), default=2)
    colons = ":" * (deepest + 1)
    return f"{colons}{{{name}}} {argument}\n{body}\n{colons}"


def toctree(pages: Iterable[str], *options: str) -> str:
    return fenced("{toctree}", (*options, "", *pages))


def table(head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    lines = (head, ["---"] * len(head), *rows)
    return "\n".join(f"| {' | '.join(map(str, line))} |" for line in lines)


def described(text: str) -> Iterator[str]:
    """Yield the paragraphs of a docstring: examples of the command line stand behind a \\b, those of Python
    behind >>>, formulas are indented."""
    for paragraph in re.split(r"\n\s*\n", text.strip("\n")):
        lines = paragraph.splitlines()
        if lines[0].strip() == "\b":
            typed = [line.strip() for line in lines[1:]]
            yield fenced("sh" if typed[0].startswith("kurbel ") else "text", typed)
        elif lines[0].lstrip().startswith(">>>"):
            yield fenced("pycon", lines)
        else:
            yield from _prose(lines)


def _prose(lines: Sequence[str]) -> Iterator[str]:
    """A paragraph, whose first lines may be a formula."""
    formula = [line for line in lines if line.startswith("    ")]
    if formula:
        yield fenced("text", (line.strip() for line in formula))
    if text := " ".join(line for line in lines if line not in formula):
        yield plain(text)
