"""Labels in HTML, and what its tables need: where heads break, how wide letters are, the ids of heads, and
the widths from which the style sheet reckons gaps and sizes; which panels stand there in pieces, too, for
telephones, and which pages have sliders."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING, Literal, NamedTuple
from zlib import crc32

from kurbel.formats.formula import has_bar, mathml
from kurbel.formats.page import Setter, page
from kurbel.formats.spacing import (
    StretchableWidth,
    added,
    bodies,
    headings,
    overhangs,
    partings,
    shared,
    spans,
    widest,
)
from kurbel.formats.writer import PLAIN, PageWriter
from kurbel.page.formula import Formula
from kurbel.page.table import HeadCell

if TYPE_CHECKING:
    from kurbel.formats.html.live import Live
    from kurbel.formats.page import Page, PageCell, PageGroup, PagePanel
    from kurbel.formats.writer import Place, WriteOptions
    from kurbel.page.table import Panel, Table

WORDS: Mapping[str, str] = {
    "de": """
        Ab-stand Ab-stände Aus-geglichener Balancier-kraft Balancier-winkel Be-lastung Beschleu-nigung
        Beschleunigungs-druck Dreh-moment Dreh-zahl Druck-verhältnis Expansions-verhältnis
        Führungs-druck Geschwin-digkeit Haupt-lager Hebel-winkel Hin-gang Kolben-beschleunigung
        Kolben-druck Kolben-geschwindigkeit Kolben-kraft Kolben-weg Kolben-wege Kreuz-kopf
        Kreuzkopf-zapfen Kurbel-verhältnis Kurbel-winkel Kurbel-zapfen Kurbel-zapfens Liefe-rung
        Massen-kraft Massen-kräfte Mechanis-mus Nach-lauf Radial-kraft Rück-gang Schubstangen-winkel
        Schwer-punkt Schwingen-kraft Schwingen-winkel Stangen-kraft Stangen-verhältnis Tangen-tial-kraft
        Um-drehung Umfangs-kraft Ungleich-förmigkeits-grad Unter-schied ver-bleibender
        Verdichtungs-verhältnis Wellen-linie Winkel-beschleunigung Wirkungs-grad Zapfen-kraft Zünd-folge
        Zünd-winkel Über-schuss Überschuss-arbeit
    """,
    "en": """
        Accelera-tion accelera-tion Ampli-tude Compres-sion Cross-head cross-head Cylin-der Deliv-ery
        Differ-ence direc-tion Effi-ciency Expan-sion Inter-val Inter-vals irregu-larity Magni-tude
        magni-tude Out-stroke Pres-sure pres-sure Remain-ing Tangen-tial tangen-tial Veloc-ity veloc-ity
    """,
}

# In em, of DejaVu Serif, by and large.
_CHARACTERS = (
    ("ijltfI.,:;'|!()[]/ \u00a0\u2008°′", 0.38),
    ("mwMW−±+=<>", 0.9),
    ("ABCDEGHKLNOPQRUVXYÄÖÜΔ", 0.77),
)
WIDTHS = {character: width for characters, width in _CHARACTERS for character in characters}
OTHERS = 0.62


REMARK = (
    "<!-- No style of its own: figures want text-align: right and tabular-nums; .words are left, .spanner"
    " centred, a space is before .pause. -->\n"
)
LIVE, FILM = 'class="live-data"', 'class="film-data"'
# What the file of a drawing that moves says of its run.
RUNS = 'data-film="'


def live_of(fragments: Iterable[str]) -> Live | None:
    """Return the same of a page that is made of these tables and of files of drawings."""
    texts = [*fragments]
    found = [mark for mark, begun in ((LIVE, LIVE), (FILM, RUNS)) if any(begun in one for one in texts)]
    return live_in(" ".join(found))


def live_in(page: str) -> Live | None:
    """Return the script and the style of interactive tables and of drawings that move if there are any on a
    page."""
    kinds = tuple(name for name, mark in (("live", LIVE), ("film", FILM)) if mark in page)
    if not kinds:
        return None
    from kurbel.formats.html.live import live

    return live(kinds)


class Writer(PageWriter):
    def escape(self, prose: str) -> str:
        return escape(prose)

    def note_mark(self, mark: str, target: str = "") -> str:
        text = f"{escape(mark)})"
        return f'<sup><a href="#{escape(target)}">{text}</a></sup>' if target else f"<sup>{text}</sup>"

    def formula(self, formula: Formula, mark: str, display: bool = False) -> str:
        style = ' displaystyle="true"' if display and has_bar(formula.content) else ""
        return f"<math{style}>{mathml(formula.content, mark)}</math>"

    def finish(self, label: str) -> str:
        """Return a label that was set, with every formula on one line with the signs that touch it."""
        return beside(label)

    def filters(self) -> Mapping[str, Callable[..., object]]:
        return {
            "heads": Heads,
            "hyphenated": hyphenated,
            "measures": measures,
            # In copies of what 0.2.0 had around a page.
            "panelled": str,
            "live": live_in,
        }

    def values(self, table: Table, ready: Page, mark: str, wishes: WriteOptions) -> dict[str, object]:
        setter = Setter(table, self, mark)
        return {"views": [*views(setter, ready, wishes.place)], "remark": "" if wishes.place else REMARK}

    def stepped(
        self, table: Table, fragment: str, page: Callable[[Table], str], mark: str, place: Place
    ) -> dict[str, object]:
        from kurbel.formats.html.live import block

        around = block(table, fragment, page, self, mark)
        return around | {"remark": REMARK if place == "step" else ""}

    def drawing(self, svg: str, name: str, title: str) -> str:
        from kurbel.formats.html.document import inline

        return inline(svg, name, title, own_page=False)


_HTML = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"})


def escape(prose: str) -> str:
    """Return prose of which every character is printed and none obeyed."""
    return prose.translate(_HTML)


# Browsers break a line between a formula and a sign beside it, whatever the sign.
_BESIDE_FORMULA = re.compile(r"(?<![^\s<>])(?:[^\s<>]*<math.*?</math>)+[^\s<>]*")


def beside(text: str) -> str:
    """Return a text that was set, in which signs that touch a formula stay on its line."""
    return _BESIDE_FORMULA.sub(_kept, text)


def _kept(match: re.Match[str]) -> str:
    text = match[0]
    alone = text.startswith("<math") and text.endswith("</math>")
    return text if alone else f'<span class="kept">{text}</span>'


# Its hyphen is of the style sheet: copied and searched, a word is whole.
BREAK = '<span class="shy"></span>'


@cache
def _breaks(lang: str) -> tuple[re.Pattern[str], Mapping[str, str]]:
    words = {word.replace("-", ""): word.replace("-", BREAK) for word in WORDS.get(lang, "").split()}
    return re.compile(rf"\b(?:{'|'.join(sorted(words))})\b"), words


def hyphenated(text: str, lang: str) -> str:
    """Return a heading with the places at which its words may break; a unit stays with its "in"."""
    pattern, words = _breaks(lang)
    kept = text.replace(" in ", " in\u00a0")
    return pattern.sub(lambda found: words[found[0]], kept) if words else kept


# A table with fewer rows is seen at a glance: nobody needs to go from group to group.
_FEWEST = 12
_LONGEST = 12


class Row(NamedTuple):
    """`names` are the ids of the cells of the stub, `heads` what all cells of the row have in common."""

    names: tuple[str, ...]
    heads: str


class Heads:
    """The ids of the heads of a page's panel with this number: weg-h1, weg-g1, weg-r1 and so on; those of a
    `piece` of it end otherwise."""

    def __init__(self, panel: PagePanel, key: str, number: int, piece: str = "") -> None:
        self.panel = panel
        # Each cell has several ids: the long name of a table would make most of the page.
        self.key = key if len(key) <= _LONGEST else f"t{crc32(key.encode()):08x}"
        self.end = f"-{number}{piece}" if number > 1 else piece
        labels = [group.label for group in panel.groups if group.label]
        # Below one row of heads scopes say it all, and ids would make the page thrice as long.
        self.needed = len(panel.head) > 1 or bool(labels)
        self.reached = len(labels) > 1 and len(panel.rows) >= _FEWEST
        self.cells = [cell for row in panel.head for cell in row if cell.text]

    def _id(self, kind: str, number: int) -> str:
        return f"{self.key}-{kind}{number}{self.end}"

    def name(self, cell: HeadCell) -> str:
        """Return the id of a cell of the head, nothing where it needs none."""
        return self._id("h", self.cells.index(cell) + 1) if self.needed else ""

    def group(self, number: int) -> str:
        """Return the id of the label of a group, counted from 1."""
        return self._id("g", number)

    @property
    def columns(self) -> tuple[str, ...]:
        """The ids of all heads above each column, from the top."""
        return tuple(
            " ".join(self.name(cell) for cell in self.cells if cell.first <= place <= cell.last)
            for place in range(len(self.panel.columns))
        )

    def rows(self) -> Iterator[tuple[Row, ...]]:
        """Yield the ids of the rows of each group."""
        above = 0
        for place, group in enumerate(self.panel.groups, 1):
            yield tuple(self._rows(group, above, f"{self.group(place)} " if group.label else ""))
            above += len(group.rows)

    def _rows(self, group: PageGroup, above: int, label: str) -> Iterator[Row]:
        names: tuple[str, ...] = ("",) * self.panel.stubs
        for number, row in enumerate(group.rows, above + 1):
            names = tuple(self._row_names(row, names, number))
            yield Row(names, label + " ".join(names))

    def _row_names(self, row: Sequence[PageCell], above: tuple[str, ...], number: int) -> Iterator[str]:
        for place, (cell, name) in enumerate(zip(row, above, strict=False)):
            # The last column of the stub has r, the one before it q.
            kind = chr(ord("r") - len(above) + 1 + place)
            yield self._id(kind, number) if cell.down else name


_TAG = re.compile(r"<[^>]*>")
# No no-break space.
_PIECES = re.compile(r"[ \n]")


# A table that needs no more fits beside the contents of a handbook on every desktop; one that needs no more
# where heads break and gaps are of the least unit, as the style sheet has them, fits 344 px in type of 12 px.
_SLIM, _TELEPHONE = 51, 344 / 12
_LEAST_UNIT = 0.3
# The mark of a note hangs in the gap, which is twice as wide then, and beside the last column.
_MARK = 1.0


class Widths(NamedTuple):
    """`wide` is that of the columns side by side without their gaps, `leasts` those of each where heads break
    and long texts wrap. `shifts` move the figures of each column to the middle below its heading. `left` and
    `right` are what spanners need beside their columns, `mores` what headings that break alike lack."""

    wide: float
    leasts: tuple[float, ...]
    gaps: tuple[float, ...]
    shifts: tuple[float, ...]
    mores: tuple[float, ...]
    left: Sequence[StretchableWidth]
    right: Sequence[StretchableWidth]

    def of(self, columns: Sequence[int]) -> Widths:
        """Return those of some of the columns, of which no whole heads are known."""
        every = (self.leasts, self.gaps, self.shifts, self.mores)
        leasts, gaps, shifts, mores = (tuple(one[place] for place in columns) for one in every)
        beside = [StretchableWidth(0.0)] * len(leasts)
        return Widths(added(leasts), leasts, gaps, shifts, mores, beside, beside)

    @property
    def slim(self) -> bool:
        beside = added(room.at() for room in (*self.left, *self.right))
        return self.wide + added(self.gaps) + beside <= _SLIM

    @property
    def broad(self) -> bool:
        return added(self.leasts) + _LEAST_UNIT * added(self.gaps) > _TELEPHONE

    @property
    def style(self) -> str:
        """Return them as the style sheet reads them, columns counted from the last one."""
        beside = (*self.left, *self.right)
        said = {"wide": self.wide + added(room.em for room in beside), "least": added(self.leasts)}
        said |= {"gaps": max(added(self.gaps), 0.1), "taken": added(-room.gaps for room in beside)}
        said["more"] = added(self.mores)
        for kind, rooms in {"g": self.gaps, "s": self.shifts, "l": self.leasts, "m": self.mores}.items():
            said |= {f"{kind}{place}": room for place, room in enumerate(reversed(rooms), 1) if any(rooms)}
        lengths = [
            f"--{side}{place}: max(0em, {room.em:.2f}em - {-room.gaps:.2f} * var(--unit))"
            for side, rooms in (("a", self.left), ("z", self.right))
            for place, room in enumerate(reversed(rooms), 1)
            if room
        ]
        return "; ".join([*(f"--{name}: {round(value, 2):g}" for name, value in said.items()), *lengths])

    @property
    def alike(self) -> bool:
        """Whether headings break that can be wholly or not at all."""
        return any(self.mores)

    def head(self, cell: HeadCell) -> str:
        """Return the measures of a cell of the head; a spanner has the room beside its columns for itself."""
        said, place = f"--gap: {self.gaps[cell.first]:g}", len(self.gaps) - cell.first
        if cell.kind == "spanner":
            return said
        left = f"; --left: var(--a{place})" if self.left[cell.first] else ""
        return said + left + (f"; --right: var(--z{place})" if self.right[cell.first] else "")


def measures(panel: PagePanel, lang: str) -> Widths:
    """Return about how wide a panel in a language is, by its plain text, in units of the size of its type.

    Rather too wide than too narrow: letters and figures are those of the widest face of the style sheet.
    """

    def broken(head: str) -> float:
        return _whole(_longest(hyphenated(head, lang)))

    gaps, whole = tuple(column.gap for column in panel.columns), bodies(panel, _whole)
    wide = widest((whole, headings(panel, _whole)))
    left, right = overhangs(wide, spans(panel, lambda spanner: _whole(spanner.text)), gaps)
    figures = [column.align == "right" for column in panel.columns]
    shifts = tuple((room - own) / 2 * right for room, own, right in zip(wide, whole, figures, strict=True))
    words = bodies(panel, lambda text: _whole(_longest(text)))
    wrapping = [own if right else word for own, word, right in zip(whole, words, figures, strict=True)]
    above = spans(panel, lambda spanner: broken(spanner.text))
    least = shared(widest((wrapping, headings(panel, broken))), above, gaps)
    if any(row[-1].marks for row in panel.rows):
        wide[-1], least[-1] = wide[-1] + _MARK, least[-1] + _MARK
    if any(cell.marks for row in panel.rows for cell in row[panel.stubs :]):
        least = [room + _LEAST_UNIT * gap for room, gap in zip(least, gaps, strict=True)]
    one_word = not any(" " in line for column in panel.columns[panel.stubs :] for line in column.heading)
    mores = tuple(max(whole - room, 0.0) * one_word for whole, room in zip(wide, least, strict=True))
    return Widths(added(wide), tuple(least), gaps, shifts, mores, left, right)


def _whole(text: str) -> float:
    """Return the width of a text, whose tags have none."""
    lines = _TAG.sub("", text).split("\n")
    return max(added(WIDTHS.get(character, OTHERS) for character in line) for line in lines)


def _longest(text: str) -> str:
    """Return the longest part of a text that does not break."""
    return max(_PIECES.split(_TAG.sub("", text.replace(BREAK, "- "))), key=_whole)


class View(NamedTuple):
    """A panel of a page as it stands there, or a piece of one, which the style sheet shows on telephones.

    `name` is the id of its caption, `called` are the ids of all that calls it.
    """

    panel: PagePanel
    heads: Heads
    sizes: Widths
    look: Literal["", "slim", "broad", "narrow"]
    name: str
    called: str
    caption: str


def views(setter: Setter, ready: Page, place: Place) -> Iterator[View]:
    """Yield the panels of a page, in a document of ours those too wide for a telephone with their pieces."""
    first, number_above = f"tab-{ready.anchor}-caption", f"tab-{ready.anchor}-number "
    plain = page(setter.table, PLAIN, setter.mark).panels
    for number, (model, panel) in enumerate(zip(setter.table.panels, ready.panels, strict=True), 1):
        name = first if number == 1 else f"{first}-{number}"
        called = name if number == 1 else f"{first} {name}"
        sizes = measures(plain[number - 1], ready.lang)
        whole = View(
            panel,
            Heads(panel, ready.anchor, number),
            sizes,
            "broad" if sizes.broad else "slim" if sizes.slim else "",
            name,
            number_above + called if place == "handbook" else called,
            ready.caption if number == 1 else f"({ready.words['continued']})",
        )
        yield whole
        if sizes.broad and place in ("document", "handbook"):
            yield from _pieces(setter, ready, model, number, whole)


def _pieces(setter: Setter, ready: Page, model: Panel, number: int, whole: View) -> Iterator[View]:
    """Yield the pieces of a panel, as few as fit a telephone; none where not even single columns do."""
    every = model.stub + model.columns
    for parts in partings([model]):
        of_parts = [[every.index(column) for column in part.stub + part.columns] for part in parts]
        widths = [whole.sizes.of(columns) for columns in of_parts]
        if not any(one.broad for one in widths):
            break
    else:
        return
    counted = len(ready.panels) > 1 or len(parts) > 2
    for place, (part, sizes) in enumerate(zip(parts, widths, strict=True)):
        panel = setter.panel(part)
        name = f"{whole.name}-s{place + 1}"
        heads = Heads(panel, ready.anchor, number, f"-s{place + 1}")
        goes_on = f"({ready.words['continued']}{f' {place}' if counted else ''})"
        called = f"{whole.called} {name}" if place else whole.called
        yield View(panel, heads, sizes, "narrow", name, called, goes_on if place else whole.caption)
