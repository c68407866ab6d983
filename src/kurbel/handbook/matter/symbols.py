"""The list of symbols: letter, name, unit and the first table of each quantity that the handbook prints."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from unicodedata import name

from kurbel.documents import prose
from kurbel.exact.numerals import Label
from kurbel.handbook.matter.inlines import inlines, parted
from kurbel.page.labels import plain
from kurbel.page.quantity import Letter, words

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
    return "GREEK" in name(letter, ""), letter.casefold(), letter.swapcase() + shown, said
