"""What filling the marked places would change, as a unified difference that `patch` takes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from difflib import SequenceMatcher

from kurbel.inject import Place

CONTEXT = 3


def difference(
    name: str, document: bytes, found: Sequence[Place], contents: Sequence[bytes]
) -> Iterator[bytes]:
    """Yield the lines of the difference; nothing where nothing would change.

    Places are compared one by one, so that a long document costs no more than its tables.
    """
    shift = 0
    heading = [f"{sign} {_shown(name)}\n".encode() for sign in ("---", "+++")]
    for place, content in zip(found, contents, strict=True):
        # The markers stand around what changes.
        around = document[place.opening : place.begin], document[place.end : place.closing]
        old = _lines(document[place.opening : place.closing])
        new = _lines(content.join(around))
        if old != new:
            yield from heading
            heading = []
            yield from _hunks(old, new, place.line, shift)
        shift += len(new) - len(old)


def _lines(text: bytes) -> list[bytes]:
    """Return the lines, whole ones; the last one of a document may lack its end, which is said."""
    lines = text.splitlines(keepends=True)
    if lines and not lines[-1].endswith((b"\n", b"\r")):
        lines[-1] += b"\n\\ No newline at end of file\n"
    return lines


def _hunks(old: Sequence[bytes], new: Sequence[bytes], first: int, shift: int) -> Iterator[bytes]:
    for group in SequenceMatcher(None, old, new, autojunk=False).get_grouped_opcodes(CONTEXT):
        begin_old, end_old, begin_new, end_new = group[0][1], group[-1][2], group[0][3], group[-1][4]
        before = _range(first + begin_old, end_old - begin_old)
        after = _range(first + shift + begin_new, end_new - begin_new)
        yield f"@@ -{before} +{after} @@\n".encode()
        for tag, from_old, to_old, from_new, to_new in group:
            if tag == "equal":
                yield from (b" " + line for line in old[from_old:to_old])
                continue
            yield from (b"-" + line for line in old[from_old:to_old])
            yield from (b"+" + line for line in new[from_new:to_new])


def _range(first: int, count: int) -> str:
    # An empty range is named by the line before it.
    return f"{first},{count}" if count else f"{first - 1},0"


def _shown(name: str) -> str:
    # A name may have line ends, and bytes that are no text.
    return "".join(one if one.isprintable() else ascii(one)[1:-1] for one in name)
