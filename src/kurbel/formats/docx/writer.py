"""Documents of Word: HTML as pandoc translates it, its tables laid out anew.

A folder of one's own templates may have the styles of a publisher's: `base/reference.docx`.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from base64 import b64encode
from collections.abc import Mapping, Sequence
from dataclasses import replace
from io import BytesIO
from tempfile import TemporaryDirectory
from xml.etree import ElementTree
from xml.sax.saxutils import escape
from zipfile import ZipFile

from kurbel.documents.document import Document, Item
from kurbel.errors import LayoutError, MissingExtraError, OutputError
from kurbel.formats.documents import DocumentMaker, DocumentPart
from kurbel.formats.docx import FORMAT
from kurbel.formats.docx.tables import W, laid_out
from kurbel.formats.registry import FORMATS, PageFormat
from kurbel.formats.render import folders_of, render
from kurbel.formats.workbook import epoch, zipped
from kurbel.formats.writer import DocumentWriter
from kurbel.page.labels import plain
from kurbel.page.table import Table


def page_of(document: Document, fragments: Mapping[str, bytes], templates: str | None) -> str:
    """Return the page, of tables in HTML and of drawings by their names."""
    form = FORMATS["html"]
    assert isinstance(form, PageFormat)
    tables = {item.name for item in document.items("table")}
    texts = {
        name: content.decode() if name in tables else f"data:image/png;base64,{b64encode(content).decode()}"
        for name, content in fragments.items()
    }
    return Maker(form, document, texts, templates).files()["word"]


class Maker(DocumentMaker):
    places = True

    def files(self) -> dict[str, str]:
        """Return the page by the name of its template."""
        return {"word": self.filled("word", self.values())}

    def page(self, chapter: object) -> str:
        return "#"

    def part(self, item: Item) -> DocumentPart:
        part: DocumentPart = super().part(item)
        return part._replace(text=self.fragments[item.name])


FILTER = os.path.join(os.path.dirname(__file__), "word.lua")
STYLES = os.path.join(os.path.dirname(__file__), "styles.xml")
REFERENCE = "base/reference.docx"
SECONDS = 300.0
# Of so many cells pandoc makes a document in 1.6 GB of memory.
MOST_CELLS = 50_000
# Pandoc would fetch what stands in a frame.
_FRAME = re.compile("<(?=/?iframe)", re.IGNORECASE)


class Writer(DocumentWriter):
    def written(self, table: Table, decimal: str | None) -> bytes:
        html = self.kept(table, decimal)
        return document_of(
            html, plain(table.caption, FORMAT.decimal_mark(table.lang, decimal)), table.lang, table.templates
        )

    def kept(self, table: Table, decimal: str | None, templates: str | None = None) -> str:
        return render(replace(table, steps=None), "html", decimal=decimal, templates=templates)

    def whole(self, document: Document, fragments: Mapping[str, bytes], templates: str | None) -> bytes:
        mark = document.mark()
        titles = {"title": document.title, "subtitle": document.subtitle, "author": document.author}
        words = [f"--metadata={name}:{plain(label, mark)}" for name, label in titles.items() if label]
        words += ["--toc", "--toc-depth=1", f"--metadata=toc-title:{document.words['contents']}"]
        html = page_of(document, fragments, templates)
        return document_of(html, plain(document.title, mark), document.lang, (templates,), *words)


def document_of(html: str, title: str, lang: str, folders: Sequence[str | None], *words: str) -> bytes:
    """Return a document of Word that says what the HTML does; `words` are more of pandoc's options.

    Raises KurbelError where there is no pandoc, or one that cannot.
    """
    if (cells := html.count("<td")) > MOST_CELLS:
        raise LayoutError(
            f"a document of Word of {cells} cells is too long; at most {MOST_CELLS} are set, use -f xlsx"
        )
    reference = next(
        (path for one in folders_of(*folders) if os.path.exists(path := f"{one}/{REFERENCE}")), ""
    )
    own = [f"--reference-doc={os.path.abspath(reference)}"] if reference else []
    made = _by_pandoc(_without_figures(html), *own, *words)
    with ZipFile(BytesIO(made)) as old:
        files = {name: old.read(name) for name in old.namelist()}
    files["word/document.xml"] = laid_out(files["word/document.xml"], bool(reference))
    with open(STYLES, "rb") as file:
        ours = file.read().replace(b'"en-GB"', b'"%s"' % {"de": b"de-DE"}.get(lang, b"en-GB"))
    theirs = files["word/styles.xml"]
    files["word/styles.xml"] = _joined(theirs, ours) if reference else _joined(ours, theirs)
    titled = b"<dc:title>%s</dc:title>" % escape(title).encode()
    files["docProps/core.xml"] = files["docProps/core.xml"].replace(b"<dc:title></dc:title>", titled)
    return zipped({name: [content] for name, content in files.items()}, epoch())


def _without_figures(html: str) -> str:
    """Return HTML that every pandoc reads alike, for figures are what some read as pictures."""
    plain_text = re.sub(r"<(/?)figure\b", r"<\1div", html)
    return _FRAME.sub("&lt;", re.sub(r'<p class="source">(.*?)</p>', r"<div>\1</div>", plain_text))


def _by_pandoc(html: str, *words: str) -> bytes:
    command = shutil.which("pandoc")
    if command is None:
        raise MissingExtraError(
            "Word needs pandoc, and there is none on this machine; install it from https://pandoc.org/installing"
            ".html, or take -f html"
        )
    line = [command, "-f", "html", "-t", "docx", "-L", FILTER, *words, "-o", "-"]
    environment = os.environ | {"SOURCE_DATE_EPOCH": str(epoch())}
    with TemporaryDirectory(prefix="kurbel-") as place:
        try:
            done = subprocess.run(
                line,
                input=html.encode(),
                capture_output=True,
                check=False,
                cwd=place,
                env=environment,
                timeout=SECONDS,
            )
        except subprocess.TimeoutExpired:
            raise OutputError(f"pandoc did not finish the document within {SECONDS:g} seconds") from None
    if done.returncode:
        sentence = " ".join(done.stderr.decode("utf-8", "replace").split())[:300]
        raise OutputError(f"pandoc (2.17 or newer) cannot make the document: {sentence}")
    return done.stdout


def _joined(first: bytes, second: bytes) -> bytes:
    """Return styles with those of others that are not among them."""
    styles = ElementTree.fromstring(first)
    known = {style.get(f"{W}styleId") for style in styles.iter(f"{W}style")}
    more = ElementTree.fromstring(second)
    styles.extend(style for style in more.iter(f"{W}style") if style.get(f"{W}styleId") not in known)
    made: bytes = ElementTree.tostring(styles, "utf-8", xml_declaration=True)
    return made
