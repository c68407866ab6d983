"""A handbook of three chapters in both languages, with every kind of item, for the tests of its documents."""

from __future__ import annotations

import shlex
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

from kurbel.cli.asking import asked
from kurbel.commands.shown import Drawing
from kurbel.documents import prose
from kurbel.documents.document import Chapter, Document, Item
from kurbel.documents.markdown import parse_prose
from kurbel.formats.registry import by_name
from kurbel.formats.render import render
from kurbel.page.formula import parse_formula
from kurbel.page.table import Table
from kurbel.plot.style import image

TABLES = {
    "weg": "table --ratio 1:5",
    "zusammenstellung": "table --layout roetscher-112 --ratio 1:5 --ratio 1:4,5 --ratio 1:4",
    "path": "table --ratio 1:4 --step 15 --lang en",
    "feinweg": "table --ratio 1:5 --step 1",
    "delta": "delta --eps 2..6",
    "dead-centres": "deadcentres --lang en",
    "harmonische": "harmonics",
    "blau": "example blau 33",
}
FIGURES = {"kurven": "plot --ratio 1:5", "stellung": "plot --positions 30 --ratio 1:5 --lang en"}

_FIRST = """
Die Tafeln dieses Abschnitts geben Weg, Geschwindigkeit und Beschleunigung des Kolbens in Einheiten von $R$,
$v$ und $v^2/R$. Die Stange ist *fünfmal* so lang wie die Kurbel, $λ = R/L = 1/5$; für andere Verhältnisse
gilt [](#zusammenstellung). Den Verlauf zeigt [](#kurven), und was daraus folgt, steht in
[dem Abschnitt über den Gleichgang](#gleichgang).

# Zum Gebrauch

- Winkel zählen vom inneren Totpunkt, auf dem Rückgang vom äußeren.
- Zwischenwerte: geradlinig, mit einem Fehler unter $0.001$.

| Größe | Einheit |
|-------|---------|
| Weg $x$ | $R$ |
| Geschwindigkeit $c$ | $v$ |
"""
_SECOND = """
Der Ungleichförmigkeitsgrad $δ$ hängt von der [Füllung](index:) ab; siehe [](#delta) und [](#path).
Wörter hat das [](#register).
"""
_TO_THE_FIRST = (prose.Refer("weg", ()),)
# So many that they go on over pages.
_SYMBOLS = (
    prose.Grid(
        ("left", "left", "left", "left"),
        tuple((prose.Text(head),) for head in ("Zeichen", "Größe", "Einheit", "zuerst")),
        tuple(
            (
                (parse_formula(f"x_{number}"),),
                (prose.Text(f"Weg {number}"),),
                (prose.Text("mm"),),
                _TO_THE_FIRST,
            )
            for number in range(90)
        ),
        long=True,
    ),
)
_INDEX = (
    prose.Index(
        (
            ("F", (prose.Term("Füllung", ("@1",)),)),
            ("K", (prose.Term("Kolbenweg", ("weg", "zusammenstellung", "kurven"), "u. ö."),)),
        )
    ),
)


@cache
def table(name: str) -> Table:
    """Return a table of the handbook."""
    made = asked(shlex.split(TABLES[name]), {}).made
    assert isinstance(made, Table)
    return replace(made, key=name, layout=made.layout or made.key)


@cache
def figure(name: str, form: str) -> bytes:
    """Return a figure of the handbook."""
    made = asked(shlex.split(FIGURES[name]), {}).made
    assert isinstance(made, Drawing)
    return image(made.figure, form)


def document(**changes: Any) -> Document:
    """Return the handbook; `changes` are other fields of it."""
    tables = {
        name: Item("table", name, number, table(name).lang, table(name).caption)
        for number, name in enumerate(TABLES, 1)
    }
    figures = {
        "kurven": Item("figure", "kurven", 1, "de", "Weg, Geschwindigkeit und Beschleunigung, $R:L = 1:5$"),
        "stellung": Item("figure", "stellung", 2, "en", "The drive at $φ = 30°$"),
    }
    chapters = (
        Chapter(
            "Bewegung des Kolbens, $x/R$",
            "bewegung",
            1,
            (
                Item("text", blocks=parse_prose(_FIRST)),
                *(tables[name] for name in ("weg", "zusammenstellung")),
                figures["kurven"],
                *(tables[name] for name in ("path", "feinweg")),
            ),
        ),
        Chapter(
            "Gleichgang",
            "gleichgang",
            2,
            (
                Item("text", blocks=prose.with_places(parse_prose(_SECOND), iter(("@1",)))),
                tables["delta"],
                tables["dead-centres"],
                figures["stellung"],
            ),
        ),
        Chapter("Beispiele und Reihen", "beispiele", 3, (tables["harmonische"], tables["blau"])),
        Chapter("Formelzeichen", "zeichen", 0, (Item("text", lang="de", blocks=_SYMBOLS),)),
        Chapter("Register", "register", 0, (Item("text", lang="de", blocks=_INDEX),)),
    )
    whole = Document(
        "Tafeln des Kurbeltriebs", "de", "comma", chapters, "für Handbücher und Vorlesungen", "A. Setzer"
    )
    return whole._replace(**changes)


def small() -> Document:
    """Return a handbook of one chapter: a text, an English table and a figure."""
    text = Item("text", blocks=parse_prose("Siehe [](#path), [](#stellung) und [](#kurz)."))
    number = {"path": 1, "stellung": 1}
    items = tuple(
        item._replace(number=number[item.name])
        for item in document().items("table", "figure")
        if item.name in number
    )
    chapter = Chapter("Kurz, $x/R$", "kurz", 1, (text, *items))
    return Document("Kleine Tafeln", "de", "comma", (chapter,))


def fragments(format: str) -> dict[str, str]:
    """Return the tables in a format."""
    return {
        name: render(table(name), format, longtable=by_name(format).is_tall(table(name))) for name in TABLES
    }


def write_folder(folder: Path, pages: dict[str, str], tables: dict[str, str], suffix: str) -> None:
    """Write pages, tables and figures as they stand in the output folder of a handbook."""
    texts = pages | {f"tables/{name}{suffix}": text for name, text in tables.items()}
    for path, text in texts.items():
        target = folder / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    (folder / "figures").mkdir(exist_ok=True)
    for name in FIGURES:
        for form in ("svg", "pdf"):
            (folder / f"figures/{name}.{form}").write_bytes(figure(name, form))
