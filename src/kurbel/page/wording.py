"""Words of one's own on a page: its caption, further notes, and the line on its source."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields, replace
from typing import Any, TypeVar

from kurbel.errors import LayoutError, ProblemError
from kurbel.exact.numerals import Label
from kurbel.page.labels import WHITE, Mark, parse
from kurbel.page.table import Note, Table

# Whatever is longer is a text beside the table.
LONGEST = 2000
_MARKED = r"(?s)\s*\[\^([^\]\s]+)\]\s*(.*)"
Page = TypeVar("Page", bound=Table)


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class Worded:
    """What is said of a page in one's own words, in the notation of labels.

    None as `caption` or `source` leaves it to the page; an empty source leaves out the line. Each
    `note` stands below those of the page; a mark such as [^a] in a caption, a source or a note points to one.
    `templates` is a folder with templates of one's own.
    """

    caption: Label | None = None
    note: tuple[Note, ...] = ()
    source: Label | None = None
    templates: str | os.PathLike[str] | None = None

    def __repr__(self) -> str:
        # Written once for all questions: to compile it for each is a hundredth of a start.
        said = ", ".join(f"{one.name}={getattr(self, one.name)!r}" for one in fields(self))
        return f"{type(self).__qualname__}({said})"

    def worded(self, table: Table) -> Table:
        """Return the page with these words. Raises ProblemError for a mark without its note, or with two."""
        marks = [note.mark for note in (*table.notes, *self.note) if note.mark]
        if twice := [mark for mark in marks if marks.count(mark) > 1]:
            raise ProblemError(
                f"two notes have the mark {twice[0]}; give yours another, as --note '[^1] ...'"
            )
        for said in (self.caption or "", self.source or "", *(note.text for note in self.note)):
            for part in parse(said):
                if isinstance(part, Mark) and " " in part.text:
                    raise ProblemError(
                        f"the mark [^{part.text}] has a space; a mark is a word or a number, such as [^1]"
                    )
                if isinstance(part, Mark) and part.text not in marks:
                    raise ProblemError(
                        f"the mark [^{part.text}] has no note; give it one, as --note '[^{part.text}] ...'"
                    )
        return replace(
            table,
            caption=self.caption or table.caption,
            notes=(*table.notes, *self.note),
            source=table.source if self.source is None else self.source,
        )


def own_words(values: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return the options `caption`, `note` and `source` as a page takes them. Raises ProblemError."""
    caption, source, notes = values["caption"], values["source"], values["note"]
    if caption is not None and not _said(caption, "caption"):
        raise ProblemError("the caption is empty; give its words, or leave --caption out")
    several = notes if isinstance(notes, Iterable) and not isinstance(notes, str) else (notes,)
    return {
        **values,
        "caption": None if caption is None else _said(caption, "caption"),
        "note": tuple(_note(one) for one in several if one is not None),
        "source": None if source is None else _said(source, "source"),
    }


def _note(given: Any) -> Note:
    if isinstance(given, Note):
        return given
    said = _said(given, "note")
    marked = re.fullmatch(_MARKED, said)
    mark, text = (marked[1], marked[2]) if marked else ("", said)
    if not text:
        raise ProblemError("a note is empty; give its words, or leave --note out")
    return Note(text, mark)


def _said(given: Any, name: str) -> Label:
    """Return a text that can be set, white space as one space each."""
    if not isinstance(given, str):
        raise ProblemError(f"the {name} is {str(given)[:40]}; it must be text")
    text = WHITE.sub(" ", given).strip()
    if len(text) > LONGEST:
        raise ProblemError(f"the {name} has {len(text)} characters; at most {LONGEST} are set")
    from unicodedata import category

    if any(category(one) in ("Cc", "Cs") for one in text):
        raise ProblemError(f"the {name} has a character that cannot be printed; write letters and signs only")
    try:
        parse(text)
    except LayoutError as error:
        raise ProblemError(str(error).replace("the label", f"the {name}", 1)) from None
    return text
