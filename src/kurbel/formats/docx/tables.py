"""Tables of a document of Word: as wide as what is in them, with their rules, on turned pages where wide.

Lengths are in points; the file has twips, of which a point has 20. Widths of letters are those of the widest
face that may stand in for the document's, so that no number breaks.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from copy import deepcopy
from functools import cached_property
from itertools import chain
from typing import NamedTuple
from xml.etree.ElementTree import Element, SubElement, fromstring, register_namespace, tostring

from kurbel.errors import LayoutError
from kurbel.formats.html.writer import OTHERS, WIDTHS
from kurbel.formats.spacing import Span, added, shared

_MAIN = "http://schemas.openxmlformats.org/wordprocessingml/2006/main"
_SPACES = {
    "w": _MAIN,
    "m": "http://schemas.openxmlformats.org/officeDocument/2006/math",
    "r": "http://schemas.openxmlformats.org/officeDocument/2006/relationships",
    "a": "http://schemas.openxmlformats.org/drawingml/2006/main",
    "pic": "http://schemas.openxmlformats.org/drawingml/2006/picture",
    "wp": "http://schemas.openxmlformats.org/drawingml/2006/wordprocessingDrawing",
}
for _prefix, _space in _SPACES.items():
    register_namespace(_prefix, _space)
W, M = f"{{{_MAIN}}}", f"{{{_SPACES['m']}}}"
MARK = f"{W}kurbel"
# A4 with margins of 20 mm, in twips.
SHORT, LONG, MARGIN = 11906, 16838, 1134
# In em: the gap before a column that has no measure, what is left of one unit of gaps where there is little
# room, and the most that a column of words takes.
USUAL_GAP, LEAST_GAP, WIDEST_WORDS = 1.3, 0.3, 30.0
# Sizes of type: those that a page has before it is turned, those of a turned page, and that of notes.
UPRIGHT, TURNED, SMALL = (10.0, 9.0), (10.0, 9.0, 8.0, 7.0), 9.0
# Rules in eighths of a point, and the space of rows that are set apart.
HEAVY, THIN = "12", "4"
APART, PAUSE = 4.0, 4.0
# How many rows at least stand above the notes on their page.
LAST_ROWS = 3
# In equations there is space around signs, and some programs do not set them in the size of their table.
EQUATION = 1.25
# How wide a mark of a note is to what it is reckoned: it is raised, and hangs in the document's own face.
RAISED = 0.45
_GAP = re.compile(r"--g([0-9]+): ([0-9.]+)")
_HYPHEN, _KEPT, _EMPTY = "\u00ad", "\u00a0", "\u200b"
_BREAKS = (" ", "\n", _HYPHEN)


def laid_out(document: bytes, keeps_paper: bool) -> bytes:
    """Return the document with its marked tables laid out; it `keeps_paper` where that is a publisher's.

    Raises LayoutError for a table that is too wide for any page.
    """
    root = fromstring(document)
    _mend_equations(root)
    body = root[0]
    section = body.find(f"{W}sectPr")
    if section is None:
        section = SubElement(body, f"{W}sectPr")
    if not keeps_paper:
        for name in ("pgSz", "pgMar"):
            for old in section.findall(f"{W}{name}"):
                section.remove(old)
        _put(section, "pgSz", w=SHORT, h=LONG)
        sides = dict.fromkeys(("top", "right", "bottom", "left"), MARGIN)
        _put(section, "pgMar", **sides, header=709, footer=709, gutter=0)
    children = [child for child in body if child is not section]
    body[:] = [*_in_sections(_pieces(children, _Paper(section)))]
    made: bytes = tostring(root, "utf-8", xml_declaration=True)
    return made


def _mend_equations(root: Element) -> None:
    """Give degrees no empty base to be raised above, ratios no space at their colon, and distances a bar."""
    for accent in root.iter(f"{M}acc"):
        accent.tag = f"{M}bar"
        accent[0].tag = f"{M}barPr"
        accent[0][:] = [Element(f"{M}pos", {f"{M}val": "top"})]
    for parent in root.iter():
        for place, child in enumerate(parent):
            if child.tag not in (f"{M}r", f"{M}sSup"):
                continue
            letters = "".join(one.text or "" for one in child.iter(f"{M}t"))
            raised = child.tag == f"{M}sSup" and letters[:1] == _EMPTY
            if raised or (child.tag == f"{M}r" and letters == ":"):
                run = Element(f"{M}r")
                SubElement(SubElement(run, f"{M}rPr"), f"{M}nor")
                SubElement(run, f"{M}t").text = letters.lstrip(_EMPTY).replace("∘", "°")
                parent[place] = run


class _Paper(NamedTuple):
    """A page as its section describes it."""

    section: Element

    def _of(self, name: str, attribute: str, usual: int) -> int:
        found = self.section.find(f"{W}{name}")
        return usual if found is None else int(found.get(f"{W}{attribute}", usual))

    @property
    def room(self) -> float:
        """The width of its text."""
        sides = self._of("pgMar", "left", MARGIN) + self._of("pgMar", "right", MARGIN)
        return (self._of("pgSz", "w", SHORT) - sides) / 20

    def turned(self) -> _Paper:
        """Return the page in landscape: itself if it lies already."""
        wide, high = self._of("pgSz", "w", SHORT), self._of("pgSz", "h", LONG)
        if wide >= high:
            return self
        section = deepcopy(self.section)
        for old in section.findall(f"{W}pgSz"):
            section.remove(old)
        section.insert(0, _made("pgSz", w=high, h=wide, orient="landscape"))
        # In their order: what comes before the size of a page stays before it.
        section[:] = sorted(section, key=lambda one: one.tag in (f"{W}pgSz", f"{W}pgMar", f"{W}cols"))
        return _Paper(section)


class _Piece(NamedTuple):
    """What stands on pages of one kind."""

    paper: _Paper
    content: list[Element]


def _pieces(children: Sequence[Element], upright: _Paper) -> Iterator[_Piece]:
    """Yield the text and the pages of tables; each of these has its marks around it."""
    turned = upright.turned()
    piece = _Piece(upright, [])
    for child in children:
        kind = child.get(f"{W}of") if child.tag == MARK else ""
        if kind == "page":
            yield piece
            piece = _Piece(upright, [])
        elif kind == "end":
            yield _Piece(_set_page(piece.content, upright, turned), piece.content)
            piece = _Piece(upright, [])
        else:
            piece.content.append(child)
    yield piece


def _in_sections(pieces: Iterator[_Piece]) -> Iterator[Element]:
    """Yield the content of all pieces, with the ends of sections where the paper is turned."""
    paper: _Paper | None = None
    for piece in pieces:
        # What is no text, such as the beginning of a place that links lead to, needs no page of its own.
        if any(one.tag in (f"{W}p", f"{W}tbl", f"{W}sdt") for one in piece.content):
            if paper is not None and paper is not piece.paper:
                yield _with_section(paper)
            paper = piece.paper
        yield from piece.content
    if paper is not None:
        yield paper.section


def _with_section(paper: _Paper) -> Element:
    """Return the paragraph that ends a section: one that is hardly seen."""
    paragraph = _made("p")
    properties = _put(paragraph, "pPr")
    _put(properties, "spacing", before=0, after=0, line=20, lineRule="exact")
    properties.append(deepcopy(paper.section))
    return paragraph


def _set_page(content: list[Element], upright: _Paper, turned: _Paper) -> _Paper:
    """Lay out the tables of a page and its notes, and return the paper that they need."""
    tables = []
    gaps: dict[int, float] = {}
    for element in [*content]:
        if element.tag == MARK:
            style = element.get(f"{W}what", "")
            gaps = {int(place): float(gap) for place, gap in _GAP.findall(style)}
            content.remove(element)
        elif element.tag == f"{W}tbl":
            tables.append(_Grid(element, gaps))
    ways = [(upright, size) for size in UPRIGHT] + [(turned, size) for size in TURNED]
    wanted = max((table.wanted for table in tables), default=0.0)
    least = max((table.least for table in tables), default=0.0)
    paper, size = next(
        ((paper, size) for paper, size in ways if wanted * size <= paper.room),
        next(((paper, size) for paper, size in ways if least * size <= paper.room), (turned, 0.0)),
    )
    if not size:
        raise LayoutError(
            f"a table needs {least * TURNED[-1] / 72 * 2.54:.0f} cm at {TURNED[-1]:g} pt, more than a turned"
            " page of Word has; print fewer of its columns (--columns), or take -f xlsx"
        )
    widest = max((table.set(size, paper.room) for table in tables), default=paper.room)
    notes = [one for one in content if one.tag == f"{W}p" and _style(one) == "TableNotes"]
    if tables and notes:
        tables[-1].keep_with_notes()
    for note in notes:
        # Notes are as wide as their table, or as a text that is read with ease.
        beside = max(0.0, (paper.room - max(widest, upright.room / 2)) / 2)
        _paragraph(note, left=beside, right=beside, keep=note is not notes[-1])
        _set_size(note, SMALL)
    return paper


class _Cell(NamedTuple):
    """A cell of the file that begins in a column; `continued` is what one above it reaches into."""

    element: Element
    column: int
    across: int
    continued: bool
    classes: Sequence[str]

    @property
    def marks(self) -> float:
        """The width of the marks of notes behind its figure, in em."""
        raised = (run for run in self.element.iter(f"{W}r") if run.find(f"{W}rPr/{W}vertAlign") is not None)
        return added(RAISED * _whole(run) for run in raised)


class _Grid:
    """A table of the file, with the gaps before its columns counted from the last one."""

    def __init__(self, element: Element, gaps: dict[int, float]) -> None:
        self.element = element
        self.count = len(element.findall(f"{W}tblGrid/{W}gridCol"))
        self.gaps = [gaps.get(self.count - place, USUAL_GAP * (place > 0)) for place in range(self.count)]
        rows = [(row, [*_cells(row)]) for row in element.findall(f"{W}tr")]
        self.head = [one for one in rows if one[0].find(f"{W}trPr/{W}tblHeader") is not None]
        self.body = rows[len(self.head) :]

    @cached_property
    def figures(self) -> list[float]:
        """The width of the widest text in the body of each column."""
        return self._widest(self.body, _whole)

    @cached_property
    def of_words(self) -> list[bool]:
        return [
            any(cell.column == place and "words" in cell.classes for _, row in self.body for cell in row)
            for place in range(self.count)
        ]

    def _widest(
        self, rows: Sequence[tuple[Element, Sequence[_Cell]]], width: Callable[[Element], float]
    ) -> list[float]:
        widest = [0.0] * self.count
        for _, row in rows:
            for cell in row:
                if cell.across == 1 and not cell.continued:
                    widest[cell.column] = max(widest[cell.column], width(cell.element))
        return widest

    def _columns(
        self, width: Callable[[Element], float], of_words: Callable[[Element], float]
    ) -> list[float]:
        """Return the widths of columns, with their shares of the spanners above them."""
        words = self._widest(self.body, of_words)
        heads = self._widest(self.head, width)
        columns = [
            max(words[place] if self.of_words[place] else self.figures[place], heads[place])
            for place in range(self.count)
        ]
        cells = chain.from_iterable(row for _, row in reversed(self.head))
        above = (Span(cell.column, cell.across, width(cell.element)) for cell in cells)
        return shared(columns, above, [LEAST_GAP * gap for gap in self.gaps])

    @cached_property
    def narrow(self) -> list[float]:
        """The least widths of the columns: heads and words go on in other lines, figures do not."""
        return self._columns(_longest, _longest)

    @cached_property
    def wide(self) -> list[float]:
        """The widths of the columns where only long texts go on in other lines."""
        return self._columns(_whole, lambda cell: max(min(_whole(cell), WIDEST_WORDS), _longest(cell)))

    @property
    def least(self) -> float:
        return added(self.narrow) + LEAST_GAP * added(self.gaps)

    @property
    def wanted(self) -> float:
        """The width with heads on their lines, and words on as many as need be."""
        columns = zip(self.of_words, self.narrow, self.wide, strict=True)
        return added(least if words else wide for words, least, wide in columns) + LEAST_GAP * added(
            self.gaps
        )

    def set(self, size: float, room: float) -> float:
        """Lay the table out in type of that size; return its width."""
        free = room / size - self.least
        lacking = [wide - least for wide, least in zip(self.wide, self.narrow, strict=True)]
        share = min(1.0, free / added(lacking)) if any(lacking) else 0.0
        columns = [least + share * more for least, more in zip(self.narrow, lacking, strict=True)]
        gaps = added(self.gaps)
        unit = min(1.0, (room / size - added(columns)) / gaps) if gaps else 0.0
        spaces = [size * unit * gap for gap in self.gaps]
        widths = [space + size * column for space, column in zip(spaces, columns, strict=True)]
        self._frame(widths)
        shifts = [size * (column - own) / 2 for column, own in zip(columns, self.figures, strict=True)]
        for place, (row, cells) in enumerate(self.head):
            _row(row, cells, widths)
            for cell in cells:
                self._head_cell(cell, spaces[cell.column], place == len(self.head) - 1)
        for place, (row, cells) in enumerate(self.body):
            _row(row, cells, widths)
            looks = cells[0].classes
            before = PAUSE if "pause" in looks else APART if place == 0 else 0.0
            after = APART if place == len(self.body) - 1 else 0.0
            for cell in cells:
                self._body_cell(cell, spaces[cell.column], shifts[cell.column], size, before, after)
            held = place + 1 < len(self.body) and "held" in self.body[place + 1][1][0].classes
            if place == 0 or held or cells[0].across == self.count > 1:
                _keep(row)
        _set_size(self.element, size)
        return added(widths)

    def keep_with_notes(self) -> None:
        """Keep the last rows on the page of what stands below the table."""
        for row, _ in self.body[-LAST_ROWS:]:
            _keep(row)

    def _frame(self, widths: Sequence[float]) -> None:
        properties = self.element.find(f"{W}tblPr")
        assert properties is not None
        kept = [one for one in properties if one.tag in (f"{W}tblStyle", f"{W}tblCaption")]
        rule, none = f'w:val="single" w:sz="{HEAVY}" w:space="0" w:color="auto"', 'w:w="0" w:type="dxa"'
        frame = f'''
            <w:tblW w:w="{_twips(added(widths))}" w:type="dxa"/><w:jc w:val="center"/>
            <w:tblBorders><w:top {rule}/><w:bottom {rule}/></w:tblBorders><w:tblLayout w:type="fixed"/>
            <w:tblCellMar><w:left {none}/><w:right {none}/></w:tblCellMar>
            <w:tblLook w:val="0000" w:firstRow="0" w:lastRow="0" w:firstColumn="0" w:lastColumn="0"
                w:noHBand="1" w:noVBand="1"/>'''
        within = " ".join(frame.split()).replace("> <", "><")
        properties[:] = [*kept[:1], *fromstring(f'<w:tblPr xmlns:w="{_MAIN}">{within}</w:tblPr>'), *kept[1:]]
        grid = self.element.find(f"{W}tblGrid")
        assert grid is not None
        grid[:] = [_made("gridCol", w=_twips(width)) for width in widths]

    def _head_cell(self, cell: _Cell, space: float, last: bool) -> None:
        properties = _cell_properties(cell.element)
        if last:
            _put(_put(properties, "tcBorders"), "bottom", val="single", sz=THIN, space=0, color="auto")
        _put(properties, "vAlign", val="bottom")
        for paragraph in cell.element.iter(f"{W}p"):
            words = self.of_words[cell.column] and "spanner" not in cell.classes
            formed = _paragraph(paragraph, "TableCell", space, align="left" if words else "center", keep=True)
            if "spanner" in cell.classes:
                rule = _made("pBdr")
                _put(rule, "bottom", val="single", sz=THIN, space=1, color="auto")
                formed.insert(2, rule)

    def _body_cell(
        self, cell: _Cell, space: float, shift: float, size: float, before: float, after: float
    ) -> None:
        whole_row = cell.across == self.count > 1
        right = 0.0
        if whole_row or "words" in cell.classes:
            align = "left"
        elif "missing" in cell.classes:
            align = "center"
        else:
            # A mark hangs beside its figure, so that figures stay in line.
            align, right = "right", shift - size * cell.marks
        for paragraph in cell.element.iter(f"{W}p"):
            apart = 2 * APART if whole_row else before
            _paragraph(paragraph, "TableCell", space, right, align, apart, after)


def _cells(row: Element) -> Iterator[_Cell]:
    """Yield the cells of a row, and take the marks out of them."""
    column = 0
    for element in row.findall(f"{W}tc"):
        mark = element.find(MARK)
        classes = () if mark is None else tuple(mark.get(f"{W}what", "").split())
        if mark is not None:
            element.remove(mark)
        span, merged = element.find(f"{W}tcPr/{W}gridSpan"), element.find(f"{W}tcPr/{W}vMerge")
        across = 1 if span is None else int(span.get(f"{W}val", 1))
        continued = merged is not None and merged.get(f"{W}val") != "restart"
        yield _Cell(element, column, across, continued, classes)
        column += across


def _letters(element: Element, size: float = 1.0) -> Iterator[tuple[str, float]]:
    """Yield the letters of an element with their widths in em; a formula does not break at its spaces."""
    for child in element:
        if child.tag in (f"{W}t", f"{M}t"):
            for letter in child.text or "":
                yield (
                    _KEPT if letter == " " and child.tag == f"{M}t" else letter,
                    size * WIDTHS.get(letter, OTHERS),
                )
        elif child.tag == f"{W}br":
            yield "\n", 0.0
        elif child.tag == f"{W}softHyphen":
            yield _HYPHEN, size * OTHERS
        else:
            yield from _letters(child, EQUATION if child.tag == f"{M}oMath" else size)


def _whole(cell: Element) -> float:
    """Return the width of the longest line."""
    lines = [0.0]
    for letter, width in _letters(cell):
        if letter == "\n":
            lines.append(0.0)
        elif letter != _HYPHEN:
            lines[-1] += width
    return max(lines)


def _longest(cell: Element) -> float:
    """Return the width of the longest part that does not break."""
    parts = [0.0]
    for letter, width in _letters(cell):
        if letter == _HYPHEN:
            parts[-1] += width
        if letter in _BREAKS:
            parts.append(0.0)
        else:
            parts[-1] += width
    return max(parts)


def _row(row: Element, cells: Sequence[_Cell], widths: Sequence[float]) -> None:
    """Keep a row on one page, and give its cells their widths."""
    properties = row.find(f"{W}trPr")
    if properties is None:
        properties = _made("trPr")
        row.insert(0, properties)
    properties.insert(0, _made("cantSplit"))
    for cell in cells:
        width = added(widths[cell.column : cell.column + cell.across])
        _cell_properties(cell.element).insert(0, _made("tcW", w=_twips(width), type="dxa"))


def _keep(row: Element) -> None:
    for properties in row.iter(f"{W}pPr"):
        if properties.find(f"{W}keepNext") is None:
            properties.insert(1, _made("keepNext"))


def _cell_properties(cell: Element) -> Element:
    found = cell.find(f"{W}tcPr")
    assert found is not None
    return found


def _style(paragraph: Element) -> str:
    found = paragraph.find(f"{W}pPr/{W}pStyle")
    return "" if found is None else found.get(f"{W}val", "")


def _paragraph(
    paragraph: Element,
    style: str = "",
    left: float = 0.0,
    right: float = 0.0,
    align: str = "",
    before: float = 0.0,
    after: float = 0.0,
    keep: bool = False,
) -> Element:
    """Give a paragraph its properties, in the order in which the schema has them; return these."""
    properties = _made("pPr")
    _put(properties, "pStyle", val=style or _style(paragraph))
    if keep:
        _put(properties, "keepNext")
    if before or after:
        _put(properties, "spacing", before=_twips(before + 1), after=_twips(after + 1))
    _put(properties, "ind", left=_twips(left), right=_twips(right))
    if align:
        _put(properties, "jc", val=align)
    old = paragraph.find(f"{W}pPr")
    if old is not None:
        paragraph.remove(old)
    paragraph.insert(0, properties)
    return properties


def _set_size(element: Element, size: float) -> None:
    """Set all letters in one size; those of formulas do not follow the style everywhere."""
    for run in [*element.iter(f"{W}r")]:
        properties = run.find(f"{W}rPr")
        if properties is None:
            properties = _made("rPr")
            run.insert(0, properties)
        before = [one for one in properties if one.tag in (f"{W}rStyle", f"{W}b", f"{W}i")]
        properties.insert(len(before), _made("sz", val=round(2 * size)))
    for run in [*element.iter(f"{M}r")]:
        properties = _made("rPr")
        _put(properties, "rFonts", ascii="Cambria Math", hAnsi="Cambria Math")
        _put(properties, "sz", val=round(2 * size))
        run.insert(1 if run.find(f"{M}rPr") is not None else 0, properties)


def _twips(points: float) -> int:
    return round(20 * points)


def _made(name: str, **attributes: object) -> Element:
    return Element(f"{W}{name}", {f"{W}{key}": str(value) for key, value in attributes.items()})


def _put(parent: Element, name: str, **attributes: object) -> Element:
    child = _made(name, **attributes)
    parent.append(child)
    return child
