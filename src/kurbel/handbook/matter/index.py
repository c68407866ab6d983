"""The index: quantities, what tables are of, authors of sources, and words that the texts mark."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from itertools import groupby
from unicodedata import combining, normalize

from kurbel.documents import prose
from kurbel.documents.document import Chapter
from kurbel.exact.numerals import Label
from kurbel.page.quantity import Letter

LONGEST = 44
MOST, MORE = 15, {"de": "u. ö.", "en": "and often"}
# Behind it a caption says of which drive and by which formulas.
_HEAD = re.compile(r"; | für | for | mit | with |[:,$(]")
_NUMBERED = re.compile(r"[0-9§]")
_RATIO = " R:L"


def index(
    letters: Mapping[str, Iterable[Letter]],
    captions: Mapping[str, Label],
    authors: Mapping[str, str],
    chapters: Iterable[Chapter],
    lang: str,
) -> prose.Blocks:
    """Return the index; the mappings are by the names of tables and figures, in their order."""
    found: dict[str, dict[str, None]] = {}
    for name, caption in captions.items():
        for words in dict.fromkeys(_words(name, caption, letters, authors)):
            found.setdefault(words, {}).setdefault(name)
    for chapter in chapters:
        for item in chapter.items:
            for term in prose.terms(tuple(item.blocks)):
                found.setdefault(_capital(term.term), {}).setdefault(term.place)
    terms = (_term(words, tuple(found[words]), lang) for words in sorted(found, key=_key))
    groups = groupby(terms, key=lambda term: _key(term.words)[0][:1].upper())
    made = tuple((letter, tuple(own)) for letter, own in groups)
    return (prose.Index(made),) if made else ()


def _term(words: str, places: tuple[str, ...], lang: str) -> prose.Term:
    """Return a term; of what is nearly everywhere only the first places help."""
    return prose.Term(words, places) if len(places) <= MOST else prose.Term(words, places[:3], MORE[lang])


def _words(
    name: str, caption: Label, letters: Mapping[str, Iterable[Letter]], authors: Mapping[str, str]
) -> Iterator[str]:
    for one in letters.get(name, ()):
        # What follows a colon is no name by itself, nor is a number.
        if ":" not in (words := one.name.removesuffix(_RATIO).removesuffix(" ±")) and words[0].isalpha():
            yield _capital(turned(words))
    head = _HEAD.split(caption)[0].strip()
    # Of several quantities each is listed by itself; a number is that of a page of a book.
    if len(head) <= LONGEST and not caption.startswith(f"{head},") and not _NUMBERED.search(head):
        yield head
    if name in authors:
        yield authors[name]


def turned(name: str) -> str:
    """Return a name with its noun first: "mittlerer Druck" becomes "Druck, mittlerer"."""
    words = name.split()
    noun = next((place for place, word in enumerate(words) if word[0].isupper()), 0)
    # Only of adjectives alone: "Kosinusglied der Harmonischen" stays, and so does English.
    return f"{' '.join(words[noun:])}, {' '.join(words[:noun])}" if noun else name


def author_of(citation: str) -> str:
    """Return the author of a citation, surname first, or its title where it names none."""
    first = citation.split(",")[0].strip()
    if first[:1] in '„“"':
        return first.strip('„“”"')
    *given, surname = first.split(" ")
    return f"{surname}, {' '.join(given)}" if given else surname


def _capital(words: str) -> str:
    return words[:1].upper() + words[1:]


def _key(words: str) -> tuple[str, str]:
    """Return what the index is sorted by: letters without their accents, then the words."""
    plain = "".join(one for one in normalize("NFKD", words.casefold()) if not combining(one))
    letters = "".join(one for one in plain if one.isalnum() or one == " ").strip()
    return letters, words
