"""The colophon: what the handbook is, which version of which day, and what it was made with."""

from __future__ import annotations

from datetime import UTC, date, datetime
from pkgutil import resolve_name

from kurbel.documents import prose
from kurbel.exact.numerals import Label
from kurbel.handbook.matter.inlines import inlines, text
from kurbel.page.quantity import words
from kurbel.reading.dates import source_date_epoch

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


def day_of(given: date | None) -> date | None:
    """Return the day that the manifest names, else that of SOURCE_DATE_EPOCH; never that of the clock."""
    if given:
        return given
    epoch = source_date_epoch()
    return None if epoch is None else datetime.fromtimestamp(epoch, UTC).date()
