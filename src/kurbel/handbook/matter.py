"""What a book has before and behind its chapters: notation, symbols, index, colophon."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from datetime import UTC, date, datetime
from itertools import groupby
from pkgutil import resolve_name
from typing import TYPE_CHECKING
from unicodedata import combining, normalize
from unicodedata import name as name_of

from kurbel.documents import prose
from kurbel.documents.document import Chapter, Document, Item
from kurbel.exact.numerals import DECIMAL_OF_LANGUAGE, DECIMALS, Label
from kurbel.page.labels import Mark, Prose, parse, plain, primed
from kurbel.page.quantity import Letter, words
from kurbel.reading.environment import source_date_epoch

if TYPE_CHECKING:
    from kurbel.handbook.manifest import Manifest
    from kurbel.handbook.pool import ListEntry, Verified


def inlines(label: Label) -> prose.Inlines:
    """Return a label as words and formulas of a text."""
    parts = (part for part in parse(label) if not isinstance(part, Mark))
    return tuple(prose.Text(primed(one.text)) if isinstance(one, Prose) else one for one in parts)


def text(words: str) -> prose.Paragraph:
    """Return words as a paragraph."""
    return prose.Paragraph((prose.Text(words),))


def parted(labels: Iterable[Label], by: str) -> prose.Inlines:
    """Return labels one behind another."""
    between = prose.Text(by)
    found = (one for label in labels for one in (between, *inlines(label)))
    return tuple(found)[1:]


HEADS = {"de": ("Zeichen", "Größe", "Einheit", "zuerst"), "en": ("symbol", "quantity", "unit", "first in")}
NOTATION = words("Schreibweise|notation")
# Letters of the drive, in which units and other letters are said; the page of notation has them.
LETTERS: Mapping[Label, Mapping[str, str]] = {
    "$R$": words("Kurbelhalbmesser|crank radius"),
    "$L$": words("Länge der Schubstange|length of the connecting rod"),
    "$r$": words("Kurbelhalbmesser, auf Seiten von Maschinen|crank radius, on pages of engines"),
    "$l$": words("Länge der Schubstange, auf Seiten von Maschinen|length of the rod, on pages of engines"),
    "$v$": words("Geschwindigkeit des Kurbelzapfens|velocity of the crank pin"),
    "$v_1$": words(
        "Geschwindigkeit des Kurbelzapfens im inneren Totpunkt"
        "|velocity of the crank pin at the inner dead centre"
    ),
    "$m_1$": words("auf den Kurbelkreis bezogene Masse|mass referred to the crank circle"),
    "$Q$": words("Bezugskraft, die jede Tabelle nennt|force of reference, which each table states"),
}
_LETTER = re.compile(r"[^\W\d_](?:_\w)?")


def symbols(tables: Mapping[str, Sequence[Letter]], lang: str, notation: str) -> prose.Blocks:
    """Return the list, made of the quantities by the names of the tables; nothing if none has a symbol.

    `notation` is the name of the page that says what the letters of the drive are, empty where there is none.
    """
    first: dict[tuple[Label, str], str] = {}
    units: dict[tuple[Label, str], dict[Label, None]] = {}
    for table, letters in tables.items():
        for one in letters:
            if one.symbol:
                first.setdefault((one.symbol, one.name), table)
                units.setdefault((one.symbol, one.name), {}).setdefault(one.unit)
    drive = _of_the_drive((*first, *((unit, "") for found in units.values() for unit in found)))
    first |= {(symbol, LETTERS[symbol][lang]): notation for symbol in drive}
    rows = tuple(
        (
            inlines(symbol),
            (prose.Text(said),),
            parted(_once(units.get((symbol, said), ())), ", "),
            _at(table, notation, lang),
        )
        for (symbol, said), table in sorted(first.items(), key=_place)
    )
    head = tuple((prose.Text(one),) for one in HEADS[lang])
    return (prose.Grid(("left", "left", "left", "left"), head, rows, long=True),) if rows else ()


def _once(units: Iterable[Label]) -> list[Label]:
    """Return the units, each once, as a formula where it is one in any table."""
    found: dict[str, Label] = {}
    for unit in filter(None, units):
        if "$" in unit or plain(unit) not in found:
            found[plain(unit)] = unit
    return [*found.values()]


def _at(table: str, notation: str, lang: str) -> prose.Inlines:
    words = (prose.Text(NOTATION[lang]),) if table == notation else ()
    return (prose.Refer(table, words),) if table else ()


def _of_the_drive(used: Iterable[tuple[Label, str]]) -> list[Label]:
    """Return the letters of the drive that symbols and units use, but those that are symbols themselves."""
    used = [*used]
    own = {symbol for symbol, _ in used}
    found = {letter for label, _ in used for letter in _LETTER.findall(" ".join(label.split("$")[1::2]))}
    return [one for one in LETTERS if one not in own and one.strip("$") in found]


def _place(entry: tuple[tuple[Label, str], str]) -> tuple[bool, str, str, str]:
    """Return where a symbol stands: Latin letters, then Greek ones, whatever stands before them."""
    (symbol, said), _ = entry
    shown = plain(symbol)
    letter = next((one for one in shown if one.isalpha()), "")
    return "GREEK" in name_of(letter, ""), letter.casefold(), letter.swapcase() + shown, said


ROUNDINGS = {
    "half-away": {"de": "die vom Nullpunkt entferntere", "en": "the one further from zero is printed"},
    "half-even": {
        "de": "die mit der geraden letzten Ziffer",
        "en": "the one whose last digit is even is printed",
    },
}
MARKS = {"de": {",": "Komma", ".": "Punkt"}, "en": {",": "comma", ".": "point"}}
BOOKS = {
    "de": " Werte aus Büchern stehen so, wie das Buch sie druckt.",
    "en": " Values of books stand as the book prints them.",
}
DIRECTIONS = {
    "de": "**Vorzeichen.** Wo eine Tabelle nichts anderes sagt, zählen ihre Größen so:",
    "en": "**Signs.** Where a table says nothing else, its quantities count so:",
}


def notation(
    letters: Iterable[Letter], mark: str, rounded: Mapping[str, str], books: bool, lang: str
) -> prose.Blocks:
    """Return the page: the directions are those of the letters that the handbook prints.

    `mark` is the decimal mark, `rounded` has the rounding of tables by their names; with `books` there are
    printed values of books.
    """
    with open(os.path.join(os.path.dirname(__file__), f"notation.{lang}.md"), encoding="utf-8") as file:
        text = file.read()
    text = text.format(
        mark=MARKS[lang][DECIMALS.get(mark, mark)],
        rounding=_rounding(rounded, lang),
        books=BOOKS[lang] if books else "",
    )
    from kurbel.documents.markdown import parse_prose

    drive = (_item(f"{symbol} {said[lang]}") for symbol, said in LETTERS.items())
    directions = dict.fromkeys(_directions(letters))
    blocks = (*parse_prose(text), _list(drive))
    if directions:
        blocks += (*parse_prose(DIRECTIONS[lang]), _list(map(_item, directions)))
    return blocks


def _rounding(rounded: Mapping[str, str], lang: str) -> str:
    """Return how most tables are rounded, and those that are not so."""
    usual, *others = [one for one, _ in Counter(rounded.values()).most_common()] or ["half-away"]
    said = [ROUNDINGS[usual][lang]]
    for other in others:
        tables = ", ".join(f"[](#{name})" for name, one in rounded.items() if one == other)
        said.append(f"in {tables} {ROUNDINGS[other][lang]}")
    return "; ".join(said)


def terse(caption: Label, lang: str) -> Label:
    """Return a caption without the rule of formulas that the page states."""
    from kurbel.motion.evaluation import METHODS

    return caption.removesuffix(f"; {METHODS['exact'].caption[lang]}")


def _directions(letters: Iterable[Letter]) -> Iterator[Label]:
    """Yield the direction of each letter that most tables count in; the others say their own below them."""
    counts: dict[Label, Counter[Label]] = {}
    for one in letters:
        if one.direction:
            counts.setdefault(one.symbol, Counter()).update((one.direction,))
    for symbol, count in counts.items():
        ((direction, _),) = count.most_common(1)
        yield direction if direction.startswith("$") else f"{symbol}: {direction}"


def _item(label: Label) -> prose.Blocks:
    return (prose.Paragraph(inlines(label)),)


def _list(items: Iterable[prose.Blocks]) -> prose.Listing:
    return prose.Listing(None, True, tuple(items))


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
        for entry in dict.fromkeys(_words(name, caption, letters, authors)):
            found.setdefault(entry, {}).setdefault(name)
    for chapter in chapters:
        for item in chapter.items:
            for term in prose.terms(tuple(item.blocks)):
                found.setdefault(_capital(term.term), {}).setdefault(term.place)
    terms = (_term(entry, tuple(found[entry]), lang) for entry in sorted(found, key=_key))
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


MONTHS = tuple(
    map(
        words,
        (
            "Januar|January", "Februar|February", "März|March", "April", "Mai|May", "Juni|June",
            "Juli|July", "August", "September", "Oktober|October", "November", "Dezember|December",
        ),
    )
)  # fmt: skip
WORDS = {
    "de": {
        "version": "Fassung {version}",
        "day": "{day}. {month} {year}",
        "both": "{version} vom {day}",
        "made": "Berechnet und gesetzt mit kurbel {kurbel}. {count}",
        "verified": "{confirmed} von {cells} Zahlen der Tabellen sind von einer zweiten Rechnung mit anderen"
        " Formeln bestätigt.",
        "left": " Nicht ein zweites Mal berechnet: ",
        "of": "{} in ",
        "same": "Dasselbe Manuskript ergibt mit derselben Fassung von kurbel dieselbe Datei, Byte für Byte.",
        "table": ("eine Tabelle", "{} Tabellen"),
        "figure": ("eine Abbildung", "{} Abbildungen"),
        "and": " und ",
    },
    "en": {
        "version": "Version {version}",
        "day": "{day} {month} {year}",
        "both": "{version}, {day}",
        "made": "Computed and set with kurbel {kurbel}. {count}",
        "verified": "{confirmed} of {cells} numbers of the tables are confirmed by a second computation with"
        " other formulas.",
        "left": " Not computed a second time: ",
        "of": "{} in ",
        "same": "The same manuscript gives, with the same version of kurbel, the same file, byte by byte.",
        "table": ("one table", "{} tables"),
        "figure": ("one figure", "{} figures"),
        "and": " and ",
    },
}


def colophon(
    title: Label, author: Label, version: Label, day: date | None, counts: dict[str, int], lang: str
) -> prose.Blocks:
    """Return the colophon; `counts` are the numbers of tables and figures."""
    said = WORDS[lang]
    heads = [prose.Paragraph((prose.Emphasis(inlines(title)),))]
    if author:
        heads.append(prose.Paragraph(inlines(author)))
    edition = [str(said["version"]).format(version=version)] if version else []
    if day:
        edition.append(str(said["day"]).format(day=day.day, month=MONTHS[day.month - 1][lang], year=day.year))
    if edition:
        whole = str(said["both"]).format(version=edition[0], day=edition[-1])
        heads.append(prose.Paragraph(inlines(whole if len(edition) > 1 else edition[0])))
    counted = str(said["and"]).join(
        said[kind][count > 1].format(count) for kind, count in counts.items() if count
    )
    sentence = f"{counted[:1].upper()}{counted[1:]}." if counted else ""
    # The package's own module knows all of kurbel, and this floor may not.
    made = str(said["made"]).format(kurbel=resolve_name("kurbel:__version__"), count=sentence).strip()
    return (*heads, text(made), text(str(said["same"])))


def _confirmed(verified: Mapping[str, Verified], lang: str) -> prose.Paragraph:
    """Return what a second computation says of tables, by their names."""
    said = WORDS[lang]
    confirmed, cells = map(sum, zip(*verified.values(), strict=True))
    found: list[prose.Inline] = [prose.Text(str(said["verified"]).format(confirmed=confirmed, cells=cells))]
    before = str(said["left"])
    for name, (sure, whole) in verified.items():
        if whole > sure:
            found += [prose.Text(before + str(said["of"]).format(whole - sure)), prose.Refer(name, ())]
            before = ", "
    return prose.Paragraph((*found, *([prose.Text(".")] if len(found) > 1 else [])))


def day_of(given: date | None) -> date | None:
    """Return the day that the manifest names, else that of SOURCE_DATE_EPOCH; never that of the clock."""
    if given:
        return given
    epoch = source_date_epoch()
    return None if epoch is None else datetime.fromtimestamp(epoch, UTC).date()


TITLES = {
    "notation": words("Schreibweise und Vorzeichen|Notation and signs"),
    "symbols": words("Formelzeichen|Symbols"),
    "index": words("Register|Index"),
    "colophon": words("Kolophon|Colophon"),
}
FRONT, BACK = ("notation", "symbols"), ("index", "colophon")
# Their pages show values that books print.
OF_BOOKS = ("example", "collate")


def with_matter(document: Document, manifest: Manifest, made: Mapping[str, ListEntry]) -> Document:
    """Return the document with its matter; `made` has what is to know of tables and figures by name."""
    of = _Matter(document, manifest, made)
    return document._replace(chapters=(*of.chapters_of(FRONT), *document.chapters, *of.chapters_of(BACK)))


class _Matter:
    """Makes what stands before and behind the chapters of a document."""

    def __init__(self, document: Document, manifest: Manifest, made: Mapping[str, ListEntry]) -> None:
        self.document = document
        self.manifest = manifest
        self.lang = document.lang
        self.abouts = {item.name: made[item.name] for item in document.items("table", "figure")}
        # In another language their quantities have other names.
        own = {name: about for name, about in self.abouts.items() if about.lang == self.lang}
        self.letters: dict[str, tuple[Letter, ...]] = {name: about.letters for name, about in own.items()}

    def chapters_of(self, names: tuple[str, ...]) -> Iterator[Chapter]:
        for name in (name for name in names if name in self.manifest.matter):
            if blocks := getattr(self, name)():
                item = Item("text", lang=self.lang, blocks=blocks)
                yield Chapter(TITLES[name][self.lang], name, 0, (item,), self.lang)

    def notation(self) -> prose.Blocks:
        parts = [part for part in self.manifest.parts() if part.words]
        books = {part.name for part in parts if part.words[0] in OF_BOOKS}
        own = {name: about for name, about in self.abouts.items() if name not in books}
        rounded = {name: about.rounding for name, about in own.items() if about.rounding}
        mark = self.document.decimal or DECIMAL_OF_LANGUAGE[self.lang]
        letters = (one for own in self.letters.values() for one in own)
        return notation(letters, mark, rounded, bool(books), self.lang)

    def symbols(self) -> prose.Blocks:
        return symbols(self.letters, self.lang, "notation" if "notation" in self.manifest.matter else "")

    def index(self) -> prose.Blocks:
        captions = {name: about.caption for name, about in self.abouts.items() if about.lang == self.lang}
        return index(self.letters, captions, self.authors(), self.document.chapters, self.lang)

    def authors(self) -> dict[str, str]:
        """Return the authors after whom tables are, as an index has them."""
        from kurbel.books.source import books

        known = {author_of(book.citation[self.lang]) for book in books()}
        return {
            name: author
            for name, about in self.abouts.items()
            for author in sorted(known)
            if author.split(",")[0] in about.source
        }

    def colophon(self) -> prose.Blocks:
        manifest = self.manifest
        counts = {kind: len([*self.document.items(kind)]) for kind in ("table", "figure")}
        day = day_of(manifest.date)
        verified = {name: one.verified for name, one in self.abouts.items() if one.verified is not None}
        found = colophon(manifest.title, manifest.author, manifest.version, day, counts, self.lang)
        return (*found[:-1], _confirmed(verified, self.lang), found[-1]) if verified else found
