r"""A handbook in LaTeX: an appendix for \input, and an article around it; and its free text.

The appendix numbers nothing by itself: its sections, tables and figures take the numbers of the document
that inputs it, and its lists are made of references, so that they hold what is in the appendix and leave
\listoftables to that document. Text needs amsmath for formulas, array and booktabs for tables, hyperref for
links.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from kurbel.documents import prose
from kurbel.documents.document import WORDS, Item
from kurbel.documents.inject import Code, Kind
from kurbel.documents.prose import Grid, Index
from kurbel.exact.numerals import Label
from kurbel.formats.documents import DocumentMaker, DocumentTitle, ProsePrinter, Reference, is_own
from kurbel.formats.latex.writer import DEGREE, escape, string

_LITERAL = rb"verbatim|[BL]?Verbatim|lstlisting|minted|comment|alltt|filecontents"
_BEGIN = re.compile(rb"\\begin[ \t]*\{((?:" + _LITERAL + rb")\*?)\}")
_VERB = re.compile(rb"\\(?:verb\*?|lstinline(?:\[[^]\n]*\])?)([^A-Za-z\s*])(?:(?!\1).)*\1")
_TEX_TEXT = re.compile(rb"(?:[^\\%]|\\.)*", re.DOTALL)


class LatexCode(Code):
    """Verbatim environments of LaTeX, fancyvrb, listings, minted and verbatim."""

    def __init__(self) -> None:
        self.end = b""

    def holds(self, line: bytes) -> bool:
        if self.end:
            if self.end in line:
                self.end = b""
            return True
        if b"\\begin" not in line:
            return False
        text = _TEX_TEXT.match(self.without_inline(line))
        assert text
        for begin in _BEGIN.finditer(text[0]):
            end = b"\\end{" + begin[1] + b"}"
            if end not in line[line.rfind(begin[0]) :]:
                self.end = end
        return bool(self.end)

    def without_inline(self, line: bytes) -> bytes:
        return _VERB.sub(b"", line) if b"\\verb" in line or b"\\lstinline" in line else line


KIND = Kind(
    name="LaTeX",
    suffixes=(".tex", ".ltx"),
    left="%",
    right="",
    # The first percent sign that no backslash makes a sign begins the comment.
    comment=re.compile(rb"\A(?:[^\\%]|\\.)*%[ \t]*(?:kurbel:|/kurbel\b)", re.DOTALL),
    code=LatexCode,
)


_SECTIONS = ("chapter", "section", "subsection", "subsubsection", "paragraph")
_COUNTERS = ("enumi", "enumii", "enumiii", "enumiv")
_COLUMNS = {None: "l", "left": "l", "center": "c", "right": "r"}
_RAGGED = {None: r"\raggedright", "left": r"\raggedright", "center": r"\centering", "right": r"\raggedleft"}
# Characters of a line, and of a column whose lines are not broken.
_LINE, _SHORT = 75, 15
_NAMES = {"table": r"\tablename", "figure": r"\figurename", "chapter": r"\S"}
# A word of code that no line end may cut would run off a narrow line.
_LONG_WORD = re.compile(r"[^ \u00a0]{20,}")
_PARTED = re.compile(r"([-,'<>])\{\}(?=\1)")
# No text has this character.
_HERE = "\0"
_PIECES = {_HERE: r"\penalty500 ", "'": r"\textquotesingle{}"}
_ADDRESS = str.maketrans(
    {"%": r"\%", "#": r"\#", "&": r"\&", "~": r"\%7E", "$": r"\%24", "_": r"\_", "^": r"\%5E", '"': r"\%22"}
    | {"{": r"\%7B", "}": r"\%7D", "\\": r"\%5C"}
)


class Printer(ProsePrinter):
    emphasised, strong = (r"\emph{", "}"), (r"\textbf{", "}")
    quoted = ("\\begin{quote}\n", "\n\\end{quote}")
    rule, line_end = r"\par\noindent\rule{\linewidth}{0.4pt}\par", "\\newline\n"
    numbered = 0

    def heading(self, level: int, content: prose.Inlines) -> str:
        section = _SECTIONS[max(1, min(level, len(_SECTIONS))) - 1]
        title = self.inlines(content)
        # Bookmarks hold nothing but characters.
        bookmark = string(self.plain(content))
        if bookmark != title:
            title = rf"\texorpdfstring{{{title}}}{{{bookmark}}}"
        return rf"\{section}{{{title}}}"

    def code_block(self, lines: tuple[str, ...]) -> str:
        return _lines(lines).join(self.quoted)

    def listing(self, listing: prose.Listing) -> str:
        if listing.start is None:
            return f"\\begin{{itemize}}\n{self._items(listing)}\n\\end{{itemize}}"
        counter = _COUNTERS[self.numbered]
        start = "" if listing.start == 1 else f"\\setcounter{{{counter}}}{{{listing.start - 1}}}\n"
        items = self.but(numbered=self.numbered + 1)._items(listing)
        return f"\\begin{{enumerate}}\n{start}{items}\n\\end{{enumerate}}"

    def _items(self, listing: prose.Listing) -> str:
        close = "\\setlength{\\itemsep}{0pt}\\setlength{\\parsep}{0pt}\n" if listing.tight else ""
        return close + "\n".join(rf"\item {self._item(item)}" for item in listing.items)

    def _item(self, item: prose.Blocks) -> str:
        """Return an item so that its mark stands on its first line."""
        match item:
            case (prose.CodeBlock(lines), *rest):
                return f"{{{_lines(lines)}\\par}}\n\n{self.blocks(tuple(rest))}"
            case (prose.Paragraph() | prose.Listing() | prose.Quote(), *_) | ():
                return self.blocks(item)
        return rf"\mbox{{}}{self.blocks(item)}"

    def grid(self, grid: prose.Grid) -> str:
        columns = "".join(self._columns(grid))
        rows = "".join(f"{self._row(row)}\n" for row in grid.rows)
        if grid.long:
            # A longtable counts as one, also without a caption: this one by a counter of its own.
            return (
                f"{{\\def\\LTcaptype{{kurbeluncounted}}\\begin{{longtable}}{{{columns}}}\n\\toprule\n"
                f"{self._row(grid.head)}\n\\midrule\n\\endhead\n\\bottomrule\n\\endfoot\n"
                f"{rows}\\end{{longtable}}}}"
            )
        return (
            f"\\begin{{center}}\n\\begin{{tabular}}{{{columns}}}\n\\toprule\n"
            f"{self._row(grid.head)}\n\\midrule\n{rows}\\bottomrule\n\\end{{tabular}}\n\\end{{center}}"
        )

    def _columns(self, grid: prose.Grid) -> Iterator[str]:
        """Yield the columns; where the rows are longer than a line, those of sentences break their lines."""
        rows = (grid.head, *grid.rows)
        widths = [max(len(self.plain(cell)) for cell in cells) for cells in zip(*rows, strict=True)]
        fits = sum(widths) + 2 * len(widths) <= _LINE
        long = sum(width for width in widths if width > _SHORT)
        room = _LINE - sum(width + 2 for width in widths if width <= _SHORT)
        for align, width in zip(grid.aligns, widths, strict=True):
            if fits or width <= _SHORT:
                yield _COLUMNS[align]
            else:
                share = max(0.05, 0.9 * width / long * room / _LINE)
                yield rf">{{{_RAGGED[align]}\arraybackslash}}p{{{share:.3f}\linewidth}}"

    def _row(self, cells: tuple[prose.Inlines, ...]) -> str:
        return " & ".join(self.inlines(cell) for cell in cells) + r" \\"

    def index(self, index: prose.Index) -> str:
        groups = "\n".join(
            f"\\kurbelletter{{{_escaped(letter)}}}\n" + "\n".join(map(self._term, terms))
            for letter, terms in index.groups
        )
        return f"\\begin{{multicols}}{{2}}\\kurbelindex\n{groups}\n\\end{{multicols}}"

    def _term(self, term: prose.Term) -> str:
        targets = ",".join(self.refer(name).target for name in term.places)
        more = f" {_escaped(term.more)}" if term.more else ""
        return rf"\kurbelterm{{{_escaped(term.words)}}}{{{targets}}}{{{more}}}"

    def marked(self, place: Reference, words: str) -> str:
        return rf"\label{{{place.target}}}{words}"

    def paragraph(self, content: prose.Inlines) -> str:
        # Above the first line there is none to end.
        return r"\leavevmode" * _breaks_first(content) + self.inlines(content)

    def text(self, text: str) -> str:
        return _escaped(text)

    def code(self, text: str) -> str:
        return rf"\texttt{{{_code(text)}}}"

    def link(self, address: str, content: prose.Inlines) -> str:
        return rf"\href{{{address.translate(_ADDRESS)}}}{{{self._shown(address, content)}}}"

    def _shown(self, address: str, content: prose.Inlines) -> str:
        """Return the words of a link; an address may be broken at any character."""
        return _breakable(self.plain(content)) if is_own(address, content) else self.inlines(content)

    def reference(self, reference: Reference, content: prose.Inlines) -> str:
        label = reference.target
        text = self.inlines(content) or rf"{_NAMES[reference.kind]}~\ref*{{{label}}}"
        return rf"\hyperref[{label}]{{{text}}}"


def _breaks_first(content: prose.Inlines) -> bool:
    """Tell whether the first thing printed is the end of a line."""
    match content:
        case (prose.Break(), *_):
            return True
        case (prose.Emphasis(inner) | prose.Strong(inner) | prose.Link(_, inner) | prose.Refer(_, inner), *_):
            return _breaks_first(inner)
        case (prose.Indexed(_, inner), *_):
            return _breaks_first(inner)
    return False


def _escaped(text: str) -> str:
    """Return text whose characters stay what they are in LuaLaTeX too.

    There an empty group does not part --, and any straight quotation mark but that of \\textquotedbl is bent.
    """
    escaped = escape(text).replace(r"\char34{}", r"\textquotedbl{}")
    # Who searches a text for a degree sign finds this one only.
    escaped = escaped.replace(DEGREE, r"\textdegree{}")
    return _PARTED.sub(r"\1{\\kern0pt}", escaped)


def _lines(lines: tuple[str, ...]) -> str:
    """Return lines of code. verbatim would neither break a long one nor stand in an argument."""
    code = "\\\\\n".join(rf"\mbox{{}}{_code(line)}" for line in lines) or r"\mbox{}"
    return f"\\ttfamily\\raggedright\n{code}"


def _code(text: str) -> str:
    """Return code whose spaces are kept and whose quotation marks are straight."""
    pieces = (piece for piece in re.split("( )", text) if piece)
    return "".join(r"\ " if piece == " " else _breakable(piece) for piece in pieces)


def _breakable(text: str) -> str:
    """Return code or an address in which a long word may be broken, if need be, at any character."""
    marked = _LONG_WORD.sub(lambda word: _HERE.join(word.group()), text)
    return "".join(_PIECES.get(piece) or _escaped(piece) for piece in re.split(f"({_HERE}|')", marked))


class TexPart(NamedTuple):
    r"""A text, table or figure. `language` is that of babel where it is not the document's.

    A `long` table is no float and may not overtake those that wait.
    """

    kind: str
    name: str
    label: str
    text: str
    language: str
    long: bool


class Maker(DocumentMaker):
    joint = ":"
    # A chapter is a section, and what stands below it a subsection.
    level = 2
    places = True

    def files(self) -> dict[str, str]:
        """Return appendix.tex and handbook.tex, which input the fragments."""
        values = self.values()
        blocks = [block for item in self.document.items("text") for block in item.blocks]
        uncounted = any(isinstance(block, Grid) and block.long for block in blocks)
        values |= {
            "author": self.title(self.document.author),
            "languages": self.languages(),
            "long": uncounted or any(part.long for chapter in values["chapters"] for part in chapter.parts),
            "wide": any(r"\begin{landscape}" in text for text in self.fragments.values()),
            "linked": any(self.document.items("text")),
            "indexed": any(isinstance(block, Index) for block in blocks),
            "uncounted": uncounted,
        }
        return {f"{name}.tex": self.filled(name, values) for name in ("appendix", "handbook")}

    def text_part(self, item: Item) -> TexPart:
        return TexPart("text", "", "", self.text(item), self.language(item), False)

    def part(self, item: Item) -> TexPart:
        long = item.kind == "table" and r"\begin{longtable}" in self.fragments[item.name]
        caption = self.titled(item.caption, item.lang)
        return TexPart(item.kind, item.name, self.label(item), caption, self.language(item), long)

    def language(self, item: Item) -> str:
        lang = self.other(item.lang)
        return WORDS[lang]["babel"] if lang else ""

    def languages(self) -> str:
        """Return the options of babel, the document's own language last."""
        others = {self.language(item) for item in self.document.items("text", "table", "figure")} - {""}
        return ",".join([*sorted(others), f"main={self.document.words['babel']}"])

    def title(self, label: Label, lang: str = "") -> DocumentTitle:
        return self.titles(label, lang, string)
