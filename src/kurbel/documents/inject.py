"""Marked places of an author's document: found in its bytes, and filled anew.

Nothing outside of them is read as text, so whatever stands there, in whatever encoding, stays as it is.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from difflib import SequenceMatcher
from typing import NamedTuple

from kurbel.errors import MarkerError

BOM = b"\xef\xbb\xbf"
# The encodings of two bytes a letter, whichever comes first.
_WIDE = "kurbel".encode("utf-16-le")[:-1]
_RUN = re.compile(rb"`+")
# The comments of markup languages.
MARKUP_COMMENT = re.compile(rb"<!--[ \t]*(?:kurbel:|/kurbel\b)")


class Code:
    """What of a document is code, in which markers are only shown; it goes through the document line by line.

    This is that of a kind that shows markers only with other letters, as HTML does.
    """

    def holds(self, line: bytes) -> bool:
        """Whether the line, the next one of the document, is of a block of code."""
        return False

    def without_inline(self, line: bytes) -> bytes:
        """Return the line without the code in it."""
        return line


class Kind(NamedTuple):
    """A kind of document: how its comments begin and end, and which of its lines are code.

    `comment` finds a marker in a line, with other text or without. `apart` tells that blank lines part a
    table from its markers, `labelled` that its tables have labels, which no two of a document may share.
    """

    name: str
    suffixes: tuple[str, ...]
    left: str
    right: str
    comment: re.Pattern[bytes]
    code: Callable[[], Code] = Code
    apart: bool = False
    labelled: bool = True

    @property
    def opening(self) -> str:
        """An opening marker, as an example."""
        return " ".join(filter(None, (self.left, "kurbel: table --ratio 1:5", self.right)))

    @property
    def closing(self) -> str:
        return " ".join(filter(None, (self.left, "/kurbel", self.right)))


class Place(NamedTuple):
    """A marked place: the words of its marker, and where between the markers its content begins and ends.

    `line` is the number of the opening marker's line, from 1; `indent` and `newline` are those of that line.
    """

    words: str
    line: int
    begin: int
    end: int
    indent: bytes
    newline: bytes


def places(document: bytes, kind: Kind, name: str) -> tuple[Place, ...]:
    """Return the marked places in their order.

    Raises MarkerError, naming the document and the line, for a marker beside other text, and for one that is
    unclosed, nested or closes nothing.
    """
    if _WIDE in document:
        raise MarkerError(f"{name} is in UTF-16; save it in UTF-8, in which its tables are written")
    return tuple(_places(document, kind, name)) if b"kurbel" in document else ()


def _places(document: bytes, kind: Kind, name: str) -> Iterator[Place]:
    code = kind.code()
    opened: Place | None = None
    end = len(BOM) if document.startswith(BOM) else 0
    # A document may have millions of lines: nothing is made of those that cannot have a marker.
    for number, line in enumerate(document[end : _last_end(document)].splitlines(keepends=True), 1):
        begin, end = end, end + len(line)
        # What stands in a marked place is no code of the author's.
        if (opened is None and code.holds(line)) or b"kurbel" not in line:
            continue
        where = f"{name}:{number}"
        words = _marker(line, kind, where, code.without_inline(line))
        if words and opened:
            raise MarkerError(
                f"{where}: the marker is nested in the one of line {opened.line}, which is still open;"
                f" write {kind.closing} before it"
            )
        if words:
            indent, newline = line[: -len(line.lstrip(b" \t"))], line[len(line.rstrip(b"\r\n")) :]
            opened = Place(words, number, end, end, indent, newline)
        elif words is not None and opened:
            yield opened._replace(end=begin)
            opened = None
        elif words is not None:
            raise MarkerError(f"{where}: {kind.closing} closes nothing; write {kind.opening} before it")
    if opened:
        raise MarkerError(
            f"{name}:{opened.line}: the marker is unclosed; write {kind.closing} on a line behind it"
        )


def _last_end(document: bytes) -> int:
    """Return an end of a line behind the last that can have a marker."""
    last = document.find(b"\n", document.rfind(b"kurbel"))
    return len(document) if last < 0 else last + 1


def _marker(line: bytes, kind: Kind, where: str, bare: bytes) -> str | None:
    """Return the words of an opening marker, "" for a closing one, None for a line that is none."""
    left, right = kind.left.encode(), kind.right.encode()
    marker = re.escape(left) + rb"[ \t]*(?:/kurbel[ \t]*|kurbel:(.*))" + re.escape(right)
    found = re.fullmatch(marker, line.strip(b" \t\r\n\f"), re.DOTALL)
    if found and found[1] is None:
        return ""
    if found and not (right and right in found[1]):
        return _words(found[1], kind, where)
    if kind.comment.search(bare):
        raise MarkerError(
            f"{where}: a marker stands alone on its line, whole, as {kind.opening} or {kind.closing}"
        )
    return None


def _words(text: bytes, kind: Kind, where: str) -> str:
    try:
        words = text.decode().strip()
    except UnicodeDecodeError:
        raise MarkerError(f"{where}: the marker is not in UTF-8; save the document in UTF-8") from None
    if not words:
        raise MarkerError(f"{where}: the marker has no command; write one such as {kind.opening}")
    if not words.replace("\t", " ").isprintable():
        raise MarkerError(f"{where}: the marker has characters that cannot be seen; write it anew")
    return words


def without_raw(line: bytes) -> bytes:
    """Return a line without what stands between equal runs of backticks."""
    runs = [(run.start(), run.end()) for run in _RUN.finditer(line)]
    last_of_length = {end - start: place for place, (start, end) in enumerate(runs)}
    pieces, done, place = [], 0, 0
    while place < len(runs):
        start, end = runs[place]
        place += 1
        if last_of_length[end - start] < place:
            continue
        while runs[place][1] - runs[place][0] != end - start:
            place += 1
        pieces.append(line[done:start])
        done = runs[place][1]
        place += 1
    return b"".join((*pieces, line[done:]))


def content(text: str, place: Place, kind: Kind) -> bytes:
    """Return a table as it stands in a place: indented as the marker is, with the ends of its lines."""
    lines = [line.encode() for line in text.rstrip("\n").split("\n")]
    if kind.apart:
        lines = [b"", *lines, b""]
    return b"".join((place.indent + line if line else b"") + place.newline for line in lines)


def filled(document: bytes, found: Sequence[Place], contents: Sequence[bytes]) -> bytes:
    """Return the document with new contents of its places; all else is kept by the byte."""
    pieces = []
    done = 0
    for place, new in zip(found, contents, strict=True):
        pieces += [document[done : place.begin], new]
        done = place.end
    return b"".join((*pieces, document[done:]))


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
