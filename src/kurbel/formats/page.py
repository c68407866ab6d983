"""A table made ready for a page: every part as finished text, every span and alignment worked out.

Templates read these objects and only arrange them. What a template does not need to know, such as the
notation of labels or the decimal mark, ends here.
"""

import re
from collections.abc import Iterable, Iterator, Sequence, Set
from itertools import accumulate, chain, islice, pairwise, zip_longest
from typing import Literal, NamedTuple, Self

from kurbel.exact.numerals import Label, Number, number_text
from kurbel.formats.spacing import gaps, held, panel_pauses
from kurbel.formats.writer import PageWriter
from kurbel.page.labels import plain
from kurbel.page.table import DITTO, Cell, HeadCell, Panel, Table, Tone, head_rows

# What no layout says.
WORDS = {
    "de": {"source": "Quelle", "continued": "Fortsetzung", "missing": "kein Wert", "babel": "ngerman"},
    "en": {"source": "Source", "continued": "continued", "missing": "no value", "babel": "english"},
}

# On a telephone anything longer would hide the figures that scroll behind it.
_LONGEST_NAME = 24


class PageCell(NamedTuple):
    """A cell as text, its note marks apart so that they can hang beside an aligned number.

    What reaches `across` the empty cells beside it is a label, too, where there is no room for it otherwise.
    `tail` is what a number lacks to the longest fraction of its column, such as "00" or ",000".
    `down` counts the rows a stub cell covers: 0 for one that belongs to the cell above, whose text it
    repeats.
    """

    text: str
    marks: str
    kind: Literal["number", "label", "missing", "across"]
    tail: str = ""
    down: int = 1
    tone: Tone = ""


class PageColumn(NamedTuple):
    """A column; `gap` is the space before it, in em."""

    heading: tuple[str, ...]
    align: Literal["left", "right"]
    gap: float


class PageGroup(NamedTuple):
    """Rows; `pauses` are those, counted from 0, before which a small space stands, and before those that are
    `held` no page ends."""

    label: str
    rows: tuple[tuple[PageCell, ...], ...]
    pauses: frozenset[int]
    held: frozenset[int] = frozenset()

    @property
    def spanned_rows(self) -> Iterator[tuple[tuple[PageCell, ...], int]]:
        """Each row and how many from it on no page ends between, 0 for those that are held."""
        free = [row for row in range(len(self.rows)) if row not in self.held]
        ends = dict(pairwise((*free, len(self.rows))))
        return ((cells, ends.get(row, row) - row) for row, cells in enumerate(self.rows))


class PagePanel(NamedTuple):
    """`head` holds one row a spanner level and, last, the row of the headings; a heading under fewer
    spanners than its neighbours starts in a higher row and reaches down.

    `names` is the column of the stub whose cells are short enough to stand beside their rows wherever a
    reader has scrolled to: the last, or None.
    """

    columns: tuple[PageColumn, ...]
    stubs: int
    names: int | None
    head: tuple[tuple[HeadCell, ...], ...]
    groups: tuple[PageGroup, ...]

    @property
    def rows(self) -> tuple[tuple[PageCell, ...], ...]:
        """The rows of all groups."""
        return tuple(chain.from_iterable(group.rows for group in self.groups))

    def with_rows(self, rows: Iterable[tuple[PageCell, ...]]) -> Self:
        """Return the same panel with other cells in its rows."""
        lines = iter(rows)
        groups = (group._replace(rows=tuple(islice(lines, len(group.rows)))) for group in self.groups)
        return self._replace(groups=tuple(groups))

    @property
    def spanners(self) -> tuple[tuple[HeadCell, ...], ...]:
        """The spanners of each level, without the headings that reach down beside them."""
        return tuple(tuple(cell for cell in row if cell.kind == "spanner") for row in self.head[:-1])

    @property
    def column_groups(self) -> tuple[range, ...]:
        """The columns that belong together: those of the stub, then those below each outermost spanner."""
        outermost = self.spanners[0] if self.spanners else ()
        ends = {edge for cell in outermost for edge in (cell.first, cell.last + 1)}
        edges = sorted({0, self.stubs, len(self.columns)} | ends)
        return tuple(range(start, end) for start, end in pairwise(edges))

    @property
    def heading_lines(self) -> tuple[tuple[str, ...], ...]:
        """The lines of all headings side by side; short headings stand at the bottom."""
        deepest = max(len(column.heading) for column in self.columns)
        padded = [("",) * (deepest - len(column.heading)) + column.heading for column in self.columns]
        return tuple(zip(*padded, strict=True))


class PageNote(NamedTuple):
    text: str
    mark: str
    target: str


class Page(NamedTuple):
    """`widths` are the characters of the longest figure in each column of any panel, so that the columns of
    several panels can stand in line; 0 for a column of words."""

    key: str
    anchor: str
    lang: str
    caption: str
    panels: tuple[PagePanel, ...]
    widths: tuple[int, ...]
    notes: tuple[PageNote, ...]
    source: str
    words: dict[str, str]


def page(table: Table, writer: PageWriter, mark: str) -> Page:
    """Return the table as text in one format, with the given decimal mark."""
    setter = Setter(table, writer, mark)
    panels = tuple(setter.panel(panel) for panel in table.panels)
    return Page(
        key=writer.escape(table.key),
        anchor=writer.escape(setter.anchor),
        lang=writer.escape(table.lang),
        caption=setter.label(table.caption),
        panels=panels,
        widths=tuple(map(max, zip_longest(*map(_figure_widths, panels), fillvalue=0))),
        notes=tuple(setter.notes()),
        source=setter.label(table.source),
        # English stands in for a language we do not speak.
        words=WORDS.get(table.lang, WORDS["en"]),
    )


def _figure_widths(panel: PagePanel) -> Iterator[int]:
    rows = panel.rows
    for place, column in enumerate(panel.columns):
        texts = [row[place].text + row[place].tail for row in rows if row[place].kind == "number"]
        yield max(map(len, texts), default=0) if column.align == "right" else 0


class Setter:
    """Sets the parts of one table in one format."""

    def __init__(self, table: Table, writer: PageWriter, mark: str) -> None:
        self.table = table
        self.writer = writer
        self.mark = mark
        self.anchor = table.anchor if writer.linked else table.key
        # Notes are numbered, since a mark such as * cannot be part of every kind of link.
        self.targets = {note.mark: f"{self.anchor}-note-{place}" for place, note in enumerate(table.notes, 1)}

    def label(self, label: Label, display: bool = False) -> str:
        return self.writer.label(label, self.mark, display, self.note_mark)

    def labels(self, labels: Iterable[Label]) -> tuple[str, ...]:
        return tuple(self.label(label) for label in labels)

    def note_mark(self, mark: str) -> str:
        return self.writer.note_mark(mark, self.targets.get(mark, ""))

    def notes(self) -> Iterator[PageNote]:
        for place, note in enumerate(self.table.notes, 1):
            mark = self.writer.note_mark(note.mark, "") if note.mark else ""
            # Readers calculate with the formulas below a table: small fractions are no help.
            text = self.label(note.text, display=True)
            yield PageNote(text, mark, self.writer.escape(f"{self.anchor}-note-{place}"))

    def panel(self, panel: Panel) -> PagePanel:
        model = panel.stub + panel.columns
        rows = tuple(panel.rows())
        by_column = [[(row.stub + row.cells)[place] for row in rows] for place in range(len(model))]
        starts = set(accumulate((len(group.rows) for group in panel.groups), initial=0))
        body = [self.cells(cells, starts) for cells in by_column]
        lines = iter(zip(*body, strict=True))
        head = tuple(
            tuple(cell._replace(lines=self.labels(cell.lines)) for cell in row) for row in head_rows(panel)
        )
        stub = [cell.value for cell in by_column[len(panel.stub) - 1]] if panel.stub else []
        short = all(len(plain(name)) <= _LONGEST_NAME for name in stub if isinstance(name, str))
        headings = {cell.first: cell.lines for row in head for cell in row if cell.kind != "spanner"}
        return PagePanel(
            columns=tuple(
                PageColumn(headings[place], alignment(cells), gap)
                for place, (cells, gap) in enumerate(zip(by_column, gaps(panel), strict=True))
            ),
            stubs=len(panel.stub),
            names=len(panel.stub) - 1 if panel.stub and short else None,
            head=head,
            groups=tuple(
                PageGroup(self.label(group.label), tuple(islice(lines, len(group.rows))), pauses, held(group))
                for group, pauses in zip(panel.groups, panel_pauses(panel, self.table.pause), strict=True)
            ),
        )

    def cells(self, cells: Sequence[Cell], starts: Set[int]) -> list[PageCell]:
        """Return the cells of one column; `starts` are the rows that begin a group."""
        decimals = max((cell.value.decimals for cell in cells if isinstance(cell.value, Number)), default=0)
        done: list[PageCell] = []
        owner = 0
        for place, cell in enumerate(cells):
            if cell.value is not DITTO or not done:
                done.append(self.cell(cell, decimals))
                owner = place
            elif place in starts:
                # A cell cannot reach over the rule between two groups: it begins anew.
                done.append(done[owner]._replace(down=1))
                owner = place
            else:
                done.append(done[owner]._replace(down=0))
                done[owner] = done[owner]._replace(down=done[owner].down + 1)
        return done

    def cell(self, cell: Cell, decimals: int) -> PageCell:
        marks = "".join(map(self.note_mark, cell.notes))
        match cell.value:
            case Number() as number:
                text = number_text(number, self.mark, self.writer.minus)
                return PageCell(text, marks, "number", self.tail(number, decimals), tone=cell.tone)
            case str() as label:
                return PageCell(self.label(label, display=True), marks, "label", tone=cell.tone)
            case None:
                return PageCell(self.writer.missing, marks, "missing")
            case _:
                return PageCell("", marks, "label")

    def tail(self, number: Number, decimals: int) -> str:
        lacking = "0" * (decimals - number.decimals)
        return f"{self.mark}{lacking}" if lacking and not number.decimals else lacking


_BLANKS = str.maketrans({"0": "\u2007", ",": "\u2008", ".": "\u2008"})


def blank(tail: str) -> str:
    """Return the spaces of typography that are as wide as the digits and the mark of a tail."""
    return tail.translate(_BLANKS)


# Angles and the like, which a compositor sets as he sets numbers: 2°30', 32°51½', 5/4, 15 %; and nothing.
_FIGURES = r"(?:[-+−]?[0-9][0-9.,°'′″½/ ]*%?)?"


def alignment(cells: Iterable[Cell]) -> Literal["left", "right"]:
    """Return "right" for a column of figures, "left" for one with any words or formulas."""
    words = [plain(cell.value) for cell in cells if isinstance(cell.value, str)]
    return "right" if all(re.fullmatch(_FIGURES, word) for word in words) else "left"
