"""What `kurbel handbook list` shows: chapters and parts, and what a build would make anew."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from kurbel.cli import screen
from kurbel.cli.listing import Entry, Heading, Shell, plain_lines, set_list, show_lines
from kurbel.handbook.build import Build
from kurbel.handbook.folder import Folder
from kurbel.handbook.manifest import Manifest, Part
from kurbel.page.wrap import lines_of

# So many characters of a text tell which it is.
MOST_SHOWN = 50


def show_handbook(manifest: Manifest, output: Folder) -> None:
    one = Build(manifest, output)
    chapters = {
        f"{number} {chapter.title} ({chapter.name})": [_row(one, part) for part in chapter.parts]
        for number, chapter in enumerate(manifest.chapters, 1)
    }
    first, width = f"{output.path}: {', '.join(manifest.formats)}", screen.width()
    if width is None:
        show_lines(_plain_list(first, chapters))
        return
    entries: list[Entry | Heading] = []
    for title, rows in chapters.items():
        entries += [Heading(title), *rows]
    show_lines([*lines_of(first, width), "", *set_list(("part", "made by", "state"), entries, width)])


def _plain_list(first: str, chapters: Mapping[str, Sequence[Sequence[str]]]) -> Iterator[str]:
    yield first
    for title, rows in chapters.items():
        yield from ("", title, *(f"    {line}" for line in plain_lines(rows)))


def _row(one: Build, part: Part) -> tuple[str, ...]:
    """Return what the list says of a part: its name, what it is made of, whether it would be made anew."""
    if not part.words:
        return "text", part.file or " ".join(part.text.split())[:MOST_SHOWN], ""
    return part.name, Shell(part.shown), one.novelty(part)
