"""What filling the marked places would change, as a unified difference that `patch` takes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from difflib import SequenceMatcher

from kurbel.documents.inject import Place, filled

# Lines from one number to another, counted from 0, that become others.
Edit = tuple[int, int, int, int]
# So many lines are shown before and behind an edit.
AROUND = 3


def difference(
    name: str, document: bytes, found: Sequence[Place], contents: Sequence[bytes]
) -> Iterator[bytes]:
    """Yield the lines of the difference; nothing where nothing would change.

    Places are compared one by one, so that a long document costs little more than its tables.
    """
    hunks = _hunks(_edits(document, found, contents))
    if not hunks:
        return
    old, new = _lines(document), _lines(filled(document, found, contents))
    yield from (f"{sign} {_shown(name)}\n".encode() for sign in ("---", "+++"))
    for edits in hunks:
        begin, end = max(edits[0][0] - AROUND, 0), min(edits[-1][1] + AROUND, len(old))
        begin_new, end_new = edits[0][2] - edits[0][0] + begin, edits[-1][3] - edits[-1][1] + end
        yield f"@@ -{_range(begin, end)} +{_range(begin_new, end_new)} @@\n".encode()
        for first, last, first_new, last_new in edits:
            yield from (b" " + line for line in old[begin:first])
            yield from (b"-" + line for line in old[first:last])
            yield from (b"+" + line for line in new[first_new:last_new])
            begin = last
        yield from (b" " + line for line in old[begin:end])


def _edits(document: bytes, found: Sequence[Place], contents: Sequence[bytes]) -> Iterator[Edit]:
    shift = 0
    for place, content in zip(found, contents, strict=True):
        lines, new = _lines(document[place.begin : place.end]), _lines(content)
        for tag, *ends in SequenceMatcher(None, lines, new, autojunk=False).get_opcodes():
            # The number of the marker's line is the place of the line behind it, counted from 0.
            first, last, first_new, last_new = (place.line + end for end in ends)
            if tag != "equal":
                yield first, last, first_new + shift, last_new + shift
        shift += len(new) - len(lines)


def _hunks(edits: Iterable[Edit]) -> list[list[Edit]]:
    """Return the edits, together those between which all lines are shown."""
    hunks: list[list[Edit]] = []
    for edit in edits:
        if hunks and edit[0] - hunks[-1][-1][1] <= 2 * AROUND:
            hunks[-1].append(edit)
        else:
            hunks.append([edit])
    return hunks


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
