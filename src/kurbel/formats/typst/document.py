"""A handbook in Typst: one source that includes the tables and draws in the figures beside it. Free text is
calls of functions, so that no character of it stands where it is markup."""

from __future__ import annotations

import re
from typing import NamedTuple

from kurbel.documents import prose
from kurbel.documents.document import WORDS, Chapter, Item
from kurbel.documents.inject import Code, Kind, without_raw
from kurbel.documents.prose import Index
from kurbel.exact.numerals import Label
from kurbel.formats.documents import DocumentChapter, DocumentMaker, DocumentTitle, ProsePrinter, Reference
from kurbel.formats.typst.writer import paper, string

_SIGN = re.compile(rb"`+|/\*|\*/|(?<!:)//")


class TypstCode(Code):
    """Raw text between backticks, and comments between /* and */, which may be nested."""

    def __init__(self) -> None:
        self.ticks = 0
        self.depth = 0

    def holds(self, line: bytes) -> bool:
        held = bool(self.ticks or self.depth)
        for match in _SIGN.finditer(line):
            sign = match[0]
            if sign.startswith(b"`"):
                self._raw(len(sign))
            elif self.ticks:
                continue
            elif sign == b"//":
                if not self.depth:
                    break
            elif sign == b"/*":
                self.depth += 1
            elif self.depth:
                self.depth -= 1
        return held

    def _raw(self, ticks: int) -> None:
        if self.depth:
            return
        if not self.ticks:
            # Two are an empty text, three and more begin a block.
            self.ticks = 0 if ticks == 2 else ticks
        elif ticks >= self.ticks:
            self.ticks = 0

    def without_inline(self, line: bytes) -> bytes:
        return without_raw(line)


KIND = Kind(
    name="Typst",
    suffixes=(".typ",),
    left="//",
    right="",
    # Two slashes behind a colon are those of an address.
    comment=re.compile(rb"\A(?:(?!(?<!:)//).)*(?<!:)//[ \t]*(?:kurbel:|/kurbel\b)", re.DOTALL),
    code=TypstCode,
)


_ALIGNS = {None: "left", "left": "left", "center": "center", "right": "right"}
_LONG_WORD = re.compile(r"\S{30}")
_BREAK = r'show regex("\S{30,}"): it => it.text.clusters().join(box())'


class Printer(ProsePrinter):
    emphasised, strong = ("#emph[", "];"), ("#strong[", "];")
    quoted = ("#quote(block: true)[\n", "\n];")
    rule, line_end = "#line(length: 100%);", "#linebreak();\n"

    # A semicolon ends each call: an opening parenthesis or a full stop after it would belong to it.
    def heading(self, level: int, content: prose.Inlines) -> str:
        return f"#heading(level: {max(level, 1)})[{self.inlines(content)}];"

    def code_block(self, lines: tuple[str, ...]) -> str:
        return _raw("\n".join(lines), ", block: true")

    def listing(self, listing: prose.Listing) -> str:
        tight = str(listing.tight).lower()
        kind = "list(" if listing.start is None else f"enum(start: {listing.start}, "
        items = ",\n".join(f"[{self.blocks(item)}]" for item in listing.items)
        return f"#{kind}tight: {tight},\n{items},\n);"

    def grid(self, grid: prose.Grid) -> str:
        aligns = "".join(f"{_ALIGNS[align]}, " for align in grid.aligns)
        rows = "".join(f"{self._row(row)},\n" for row in grid.rows)
        columns = f"({self._widths(grid)})" if grid.long else len(grid.aligns)
        table = (
            f"#align(center, table(columns: {columns}, align: ({aligns}), stroke: none,\n"
            f"table.hline(stroke: .08em), table.header({self._row(grid.head)}), table.hline(stroke: .05em),\n"
            f"{rows}table.hline(stroke: .08em)));"
        )
        return f"#[#set text(size: .9em);\n{table}];" if grid.long else table

    def _widths(self, grid: prose.Grid) -> str:
        """Return the widths of the columns of a long table, of which the widest has what the others leave."""
        rows = (grid.head, *grid.rows)
        letters = [sum(len(self.plain(cell)) for cell in cells) for cells in zip(*rows, strict=True)]
        return "".join("1fr, " if one == max(letters) else "auto, " for one in letters)

    def _row(self, cells: tuple[prose.Inlines, ...]) -> str:
        return ", ".join(f"[{self.inlines(cell)}]" for cell in cells)

    def index(self, index: prose.Index) -> str:
        groups = "".join(
            f"({string(letter)}, ({''.join(map(self._term, terms))})),\n" for letter, terms in index.groups
        )
        return f"#index((\n{groups}));"

    def _term(self, term: prose.Term) -> str:
        targets = "".join(f"{string(self.refer(name).target)}, " for name in term.places)
        return f"([{self.text(term.words)}], ({targets}), [{self.text(term.more)}]),\n"

    def marked(self, place: Reference, words: str) -> str:
        return f"#[#metadata(none)#label({string(place.target)})];{words}"

    def code(self, text: str) -> str:
        return _raw(text)

    def link(self, address: str, content: prose.Inlines) -> str:
        return f"#link({string(address)})[{self.inlines(content)}];"

    def reference(self, reference: Reference, content: prose.Inlines) -> str:
        """Return a reference; Typst itself names and counts what it points to."""
        label = f"<{reference.target}>"
        return f"#link({label})[{self.inlines(content)}];" if content else f"#ref({label});"


def _raw(code: str, options: str = "") -> str:
    """Return code in which a word that is longer than a line may be broken at any character."""
    call = f"raw({string(code)}{options})"
    return f"#{{ {_BREAK}; {call} }};" if _LONG_WORD.search(code) else f"#{call};"


# The width of the text in millimetres.
MEASURE = 140
# What a fragment says of its width.
_NARROW = re.compile(r"with narrow gaps ([0-9.]+)em")


class TypstPart(NamedTuple):
    """A table or a figure; `path`, `alt` and `label` are strings of code.

    `lang` is the language where it is not the document's; `alt` is the caption for readers that do not see
    the figure; `paper` is that of a table too wide for the pages of the text.
    """

    kind: str
    path: str
    label: str
    text: str
    alt: str
    lang: str
    paper: str = ""


class Maker(DocumentMaker):
    places = True

    def files(self) -> dict[str, str]:
        """Return handbook.typ, which includes the fragments as files of the folder tables."""
        document = self.document
        more = {
            "subtitle": self.title(document.subtitle),
            "author": self.title(document.author),
            "languages": WORDS,
            "indexed": any(
                isinstance(block, Index) for one in document.items("text") for block in one.blocks
            ),
            "kinds": sorted({item.kind for item in document.items("table", "figure")}),
        }
        return {"handbook.typ": self.filled("handbook", self.values() | more)}

    def chapter(self, chapter: Chapter) -> DocumentChapter:
        made: DocumentChapter = super().chapter(chapter)
        return made._replace(label=string(made.label))

    def title(self, label: Label, lang: str = "") -> DocumentTitle:
        return self.titles(label, lang, string)

    def part(self, item: Item) -> TypstPart:
        table = item.kind == "table"
        return TypstPart(
            item.kind,
            string(f"tables/{item.name}.typ" if table else f"figures/{item.name}.svg"),
            string(self.label(item)),
            self.titled(item.caption, item.lang),
            string(self.plain(item.caption, item.lang)),
            self.other(item.lang),
            _paper(self.fragments[item.name]) if table else "",
        )


def _paper(fragment: str) -> str:
    """Return the paper of a table's own page, if it needs one."""
    found = _NARROW.search(fragment)
    return paper(float(found[1]), MEASURE) if found else ""
