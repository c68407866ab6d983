"""What filling the marked places would change, as a unified difference that `patch` takes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from difflib import SequenceMatcher

from kurbel.documents.inject import Place, filled

# What happens to the lines from one number to another, and which new ones belong to them.
Change = tuple[str, int, int, int, int]


class _Known(SequenceMatcher[bytes]):
    """A comparison whose result is known; only its lines of context are left to find."""

    def __init__(self, changes: list[Change]) -> None:
        super().__init__(None, (), ())
        self.changes = changes

    def get_opcodes(self) -> list[Change]:  # type: ignore[override]
        return self.changes


def difference(
    name: str, document: bytes, found: Sequence[Place], contents: Sequence[bytes]
) -> Iterator[bytes]:
    """Yield the lines of the difference; nothing where nothing would change.

    Places are compared one by one, so that a long document costs little more than its tables.
    """
    old, new = _lines(document), _lines(filled(document, found, contents))
    changes = _changes(document, found, contents, len(old))
    if all(change[0] == "equal" for change in changes):
        return
    yield from (f"{sign} {_shown(name)}\n".encode() for sign in ("---", "+++"))
    for group in _Known(changes).get_grouped_opcodes():
        (_, first, _, first_new, _), (_, _, end, _, end_new) = group[0], group[-1]
        yield f"@@ -{_range(first, end)} +{_range(first_new, end_new)} @@\n".encode()
        for tag, from_old, to_old, from_new, to_new in group:
            if tag == "equal":
                yield from (b" " + line for line in old[from_old:to_old])
            else:
                yield from (b"-" + line for line in old[from_old:to_old])
                yield from (b"+" + line for line in new[from_new:to_new])


def _changes(document: bytes, found: Sequence[Place], contents: Sequence[bytes], length: int) -> list[Change]:
    """Return the changes of the whole document; those that keep lines take turns with others."""
    parts: list[Change] = []
    shift = done = 0
    for place, content in zip(found, contents, strict=True):
        # The number of the marker's line is the place of the line behind it, counted from 0.
        begin, lines, new = place.line, _lines(document[place.begin : place.end]), _lines(content)
        parts.append(("equal", done, begin, done + shift, begin + shift))
        for tag, *ends in SequenceMatcher(None, lines, new, autojunk=False).get_opcodes():
            one, other, this, that = ends
            parts.append((tag, begin + one, begin + other, begin + shift + this, begin + shift + that))
        done, shift = begin + len(lines), shift + len(new) - len(lines)
    parts.append(("equal", done, length, done + shift, length + shift))
    return _joined(parts)


def _joined(parts: Sequence[Change]) -> list[Change]:
    joined: list[Change] = []
    for part in parts:
        if joined and joined[-1][0] == part[0] == "equal":
            before = joined.pop()
            part = ("equal", before[1], part[2], before[3], part[4])
        joined.append(part)
    return joined


def _lines(text: bytes) -> list[bytes]:
    """Return the lines, whole ones; the last one of a document may lack its end, which is said."""
    lines = text.splitlines(keepends=True)
    if lines and not lines[-1].endswith((b"\n", b"\r")):
        lines[-1] += b"\n\\ No newline at end of file\n"
    return lines


def _range(first: int, end: int) -> str:
    # Lines are counted from 1; an empty range is named by the line before it.
    return f"{first + 1},{end - first}" if end > first else f"{first},0"


def _shown(name: str) -> str:
    # A name may have line ends, and bytes that are no text.
    return "".join(one if one.isprintable() else ascii(one)[1:-1] for one in name)
