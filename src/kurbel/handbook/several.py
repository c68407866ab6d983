"""Several handbooks at once, and what is asked for of them by name."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence

from kurbel.errors import ChoiceError, HandbookError
from kurbel.handbook.build import Handbook
from kurbel.handbook.manifest import Manifest
from kurbel.reading.given import did_you_mean


def part_from(one: Handbook, others: Iterable[Handbook]) -> None:
    """Raise HandbookError if another is built into the same folder: each would remove the other's files."""
    for other in others:
        if os.path.realpath(other.folder.path) == os.path.realpath(one.folder.path):
            raise HandbookError(
                f"{one.manifest.path} and {other.manifest.path} are both built into {one.folder.path};"
                ' give one of them another folder with output = "..."'
            )


def chosen(handbooks: Sequence[Handbook], names: Sequence[str]) -> list[Handbook]:
    """Return the handbooks which have something of these names, and that only; without names all of them."""
    if not names:
        return [*handbooks]
    known = [_parts(one.manifest) for one in handbooks]
    for name in names:
        if not any(name in parts for parts in known):
            near = did_you_mean(name, [one for parts in known for one in parts])
            raise ChoiceError(
                f'--only: there is no table, figure or chapter "{name[:60]}"{near}; kurbel handbook list'
                " names them"
            )
    found = [
        (one, parts, tuple(filter(parts.__contains__, names)))
        for one, parts in zip(handbooks, known, strict=True)
    ]
    return [
        one._replace(names=own, only=frozenset().union(*(parts[name] for name in own)))
        for one, parts, own in found
        if own
    ]


def _parts(manifest: Manifest) -> Mapping[str, frozenset[str]]:
    """Return tables and figures by their names, and those of a chapter by its own, if no other has that."""
    own = {part.name: frozenset((part.name,)) for part in manifest.parts() if part.words}
    return {
        chapter.name: frozenset(part.name for part in chapter.parts if part.words)
        for chapter in manifest.chapters
    } | own
