"""Documents of Word: what stands in the file, and what LibreOffice shows of it beside the page in HTML."""

from __future__ import annotations

import io
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from xml.etree.ElementTree import Element, fromstring
from zipfile import ZipFile

import manifests
import numpy as np
import pytest
from browser import Viewer
from cli import kurbel, printed, refusal
from everything import everything, tall, wide
from office import converted
from pages import default_page
from places import ROOT
from rows import assert_rows_stand_in, lines_of_pdf
from tools import require
from typeset import Word, words_of_pdf

from kurbel.errors import KurbelError
from kurbel.formats.registry import FORMATS, BytesFormat
from kurbel.formats.render import render
from kurbel.page.layouts import layout_names
from kurbel.page.table import Note, Table

W = "{http://schemas.openxmlformats.org/wordprocessingml/2006/main}"
M = "{http://schemas.openxmlformats.org/officeDocument/2006/math}"


@pytest.fixture(autouse=True)
def pandoc() -> None:
    require("pandoc")


def content(page: Table) -> bytes:
    form = FORMATS["docx"]
    assert isinstance(form, BytesFormat)
    return form.content(page, None)


def part(document: bytes, name: str = "document") -> Element:
    with ZipFile(io.BytesIO(document)) as file:
        return fromstring(file.read(f"word/{name}.xml"))


def text(element: Element) -> str:
    return "".join(one.text or "" for one in element.iter() if one.tag in (f"{W}t", f"{M}t"))


def of(element: Element, path: str, name: str = "val") -> list[str]:
    """Return an attribute of all elements at a path of Word's names."""
    steps = "/".join(f"{W}{step}" for step in path.split("/"))
    return [one.get(f"{W}{name}", "") for one in element.iterfind(f".//{steps}")]


def papers(document: Element) -> list[str]:
    return [orient or "portrait" for orient in of(document, "sectPr/pgSz", "orient")]


def test_heads_are_merged_and_every_formula_is_an_equation() -> None:
    made = part(content(everything()))
    first, second = made.iter(f"{W}tbl")
    head = [row for row in first.iter(f"{W}tr") if row.find(f"{W}trPr/{W}tblHeader") is not None]
    spans = [
        [(text(cell), int(span.get(f"{W}val", 0)))]
        for row in head
        for cell in row.iter(f"{W}tc")
        if (span := cell.find(f"{W}tcPr/{W}gridSpan")) is not None and span.get(f"{W}val") != "1"
    ]
    assert spans == [[("Genaue Wertea)", 4)], [("Kolbenweg", 2)]]
    assert of(first, "vMerge").count("restart") == 3 + 1 + 2
    equations = [text(one) for one in made.iter(f"{M}oMath")]
    assert [one for one in ("R:L", "φ", "x/R", "c/v", "ψ", "λ=1/5") if one not in equations] == []
    assert len(head) == 3
    assert "1:4,5" in text(first)
    assert "0°0′" in text(first)
    assert not [*made.iter(f"{W}numPr")], "a note has a bullet"
    for note in ("a) Auf", "Quelle: F. Rötscher"):
        (paragraph,) = (one for one in made.iter(f"{W}p") if text(one).startswith(note))
        assert of(paragraph, "pPr/spacing", "after") == [], "notes are apart"
    last = [*second.iter(f"{W}tr")][-1]
    assert [text(cell) for cell in last.iter(f"{W}tc")] == ["", "90", "−0,014", "–"]
    assert [*last.iter(f"{W}keepNext")], "notes may stand on a page of their own"
    notes = [one for one in made.iter(f"{W}p") if of(one, "pStyle") == ["TableNotes"]]
    kept = [bool([*one.iter(f"{W}keepNext")]) for one in notes]
    assert kept == [True] * (len(notes) - 1) + [False], "a table takes what stands below it to its page"
    # The mark of a note leads to it.
    targets = {*of(made, "bookmarkStart", "name")}
    links = of(made, "hyperlink", "anchor")
    assert len(links) == 4
    assert targets.issuperset(links)
    # What the filter hands over stays nowhere.
    assert not [*made.iter(f"{W}kurbel")]


@pytest.mark.parametrize(("lang", "word"), [("de", "Tabelle"), ("en", "Table")])
def test_captions_are_numbered_by_a_field(lang: str, word: str) -> None:
    made = part(content(tall(3) if lang == "en" else everything()))
    captions = [one for one in made.iter(f"{W}p") if of(one, "pStyle") == ["TableCaption"]]
    assert of(captions[0], "fldSimple", "instr") == [f" SEQ {word} \\* ARABIC "]
    assert text(captions[0]).startswith(f"{word}\u00a01: ")
    # Below itself a page goes on under the same number.
    assert [of(one, "fldSimple", "instr") for one in captions[1:]] == [[]]


def test_wide_tables_stand_on_turned_pages() -> None:
    narrow, broad = part(content(everything())), part(content(wide(5)))
    assert papers(narrow) == ["portrait"]
    assert papers(broad) == ["landscape"]
    assert {*of(narrow, "tc/p/r/rPr/sz")} == {"20"}
    # So are formulas of its cells.
    formulas = [one for cell in narrow.iter(f"{W}tc") for one in cell.iter(f"{M}r")]
    assert {size for one in formulas for size in of(one, "rPr/sz")} == {"20"}
    for made, room in ((narrow, 11906 - 2 * 1134), (broad, 16838 - 2 * 1134)):
        for table in made.iter(f"{W}tbl"):
            (width,) = of(table, "tblPr/tblW", "w")
            columns = [int(one) for one in of(table, "gridCol", "w")]
            assert abs(sum(columns) - int(width)) <= len(columns)
            assert int(width) <= room
    # Figures and signs have at most 0.56 em in Times, Arial and Cambria.
    points = [int(one) / 20 for one in of(broad, "gridCol", "w")]
    size = int(of(broad, "tc/p/r/rPr/sz")[-1]) / 2
    needed = len("−1,00000") * 0.56 * size
    assert needed < min(points[1:])
    assert max(points[1:]) < 2 * needed


def test_a_table_that_no_page_has_room_for_is_a_sentence() -> None:
    with pytest.raises(KurbelError, match=r"a table needs \d+ cm at 7 pt, .*; print fewer of its columns"):
        content(wide(30))


def test_a_document_that_is_too_long_is_refused_before_it_is_made(tmp_path: Path) -> None:
    words = ("table", "--ratio=1:5", "--step=0.02", "--to=180", "-o", str(tmp_path / "long.docx"))
    assert refusal(*words, code=1) == (
        "a document of Word of 54006 cells is too long; at most 50000 are set, use -f xlsx"
    )


def test_the_same_page_is_the_same_file(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("SOURCE_DATE_EPOCH", raising=False)
    assert content(everything()) == content(everything())


def test_without_pandoc_one_sentence_says_what_to_install(tmp_path: Path) -> None:
    target = tmp_path / "page.docx"
    sentence = refusal("table", "--ratio=1:5", "-o", str(target), code=1, PATH=str(tmp_path))
    assert sentence.startswith(
        "Word needs pandoc, and there is none on this machine; install it from https://"
    )
    assert not target.exists()


def test_templates_may_bring_the_styles_of_a_publisher(tmp_path: Path) -> None:
    folder = tmp_path / "mine"
    (folder / "base").mkdir(parents=True)
    with (
        ZipFile(io.BytesIO(content(everything()))) as ours,
        ZipFile(folder / "base/reference.docx", "w") as file,
    ):
        for name in ours.namelist():
            kept = ours.read(name)
            if name == "word/styles.xml":
                kept = kept.replace(b'w:ascii="Times New Roman"', b'w:ascii="Garamond"')
            file.writestr(name, kept.replace(b'w:w="11906" w:h="16838"', b'w:w="9000" w:h="12000"'))
    target = tmp_path / "page.docx"
    printed("table", "--ratio=1:5", "--columns=phi,x", "--templates", str(folder), "-o", str(target))
    made = target.read_bytes()
    assert of(part(made, "styles"), "rPrDefault/rPr/rFonts", "ascii") == ["Garamond"]
    paper = part(made)
    assert of(paper, "pgSz", "w") == ["9000"]
    assert int(of(paper, "tblPr/tblW", "w")[0]) <= 9000 - 2 * 1134


def test_no_template_brings_files_of_the_machine_along(tmp_path: Path) -> None:
    picture = tmp_path / "secret.png"
    picture.write_bytes((ROOT / "docs/_static/logo-light.svg").read_bytes())
    (tmp_path / "base").mkdir()
    (tmp_path / "base/html.jinja").write_text(
        f'<figure class="kurbel"><p><img src="{picture}"> <IFRAME src="{picture}"></IFRAME> done</p></figure>'
    )
    target = tmp_path / "page.docx"
    printed("table", "--ratio=1:5", "--templates", str(tmp_path), "-o", str(target))
    with ZipFile(target) as file:
        assert not [name for name in file.namelist() if "media" in name]
        assert "done" in text(fromstring(file.read("word/document.xml")))


PARTS = (
    manifests.text("Siehe [](#wege)."),
    manifests.run("wege", "table --ratio 1:5 --angle 0;90"),
    manifests.run("breit", "table --layout kolbenwege"),
    manifests.run("bild", "table --columns p --ratio 1:5 -f drawing"),
    manifests.text("Zum Schluss."),
)
MANIFEST = 'title = "Tafeln & mehr"\nformats = ["docx"]\n' + manifests.chapter("Wege für $R:L$", *PARTS)


def test_a_handbook_is_one_document_with_its_texts_and_drawings(tmp_path: Path) -> None:
    (tmp_path / "handbook.toml").write_text(MANIFEST, encoding="utf-8")
    assert "2 written, 0 unchanged" in kurbel("handbook", "build", str(tmp_path), "--jobs", "1").err
    document = (tmp_path / "pages/handbook.docx").read_bytes()
    made = part(document)
    assert papers(made) == ["portrait", "landscape", "portrait"]
    whole = text(made)
    for words in ("Tafeln & mehr", "1 Wege für R:L", "Siehe Tabelle 1.", "Zum Schluss."):
        assert words in whole
    assert [one.strip() for one in of(made, "fldSimple", "instr")] == [
        "SEQ Tabelle \\* ARABIC",
        "SEQ Tabelle \\* ARABIC",
        "SEQ Abbildung \\* ARABIC",
    ]
    assert {"tab-wege", "tab-breit", "fig-bild"} <= {*of(made, "bookmarkStart", "name")}
    with ZipFile(io.BytesIO(document)) as file:
        assert [name for name in file.namelist() if name.startswith("word/media/")]
    assert "0 written, 2 unchanged" in kurbel("handbook", "build", str(tmp_path), "--jobs", "1").err


# Each row of figures in HTML, and where they end.
ROWS = """() => [...document.querySelectorAll('.scroll:not(.narrow) tbody tr:not(.group)')].map(
    row => [...row.children].filter(cell => !cell.matches('.words, .missing') && !cell.querySelector('math'))
        .map(cell => [cell.textContent.replace(/[\\u2007\\u2008]/g, ''), cell.getBoundingClientRect().right])
)"""
# Pairs below spanners; two lines of heads, at 9 pt; two panels on a turned page.
THREE = ("kinematics", "machine-forces", "kolbenwege")


def in_lines(words: list[Word]) -> list[list[Word]]:
    """Return words by their lines, from left to right; rows are further apart than letters are uneven."""
    lines: list[list[Word]] = []
    for word in sorted(words, key=lambda one: (one.page, one.bottom)):
        last = lines[-1][-1] if lines else None
        if last is None or last.page != word.page or word.bottom - last.bottom > 1.5:
            lines.append([])
        lines[-1].append(word)
    return [sorted(line, key=lambda one: one.left) for line in lines]


def test_libreoffice_shows_the_rows_of_the_page_in_html(tmp_path: Path, viewer: Viewer) -> None:
    require("soffice")
    for name in THREE:
        (tmp_path / f"{name}.docx").write_bytes(content(default_page(name)))
    converted([tmp_path / f"{name}.docx" for name in THREE], "pdf", tmp_path)
    for name in THREE:
        shown = viewer.open(render(default_page(name), "html", standalone=True)).evaluate(ROWS)
        lines = iter(in_lines(words_of_pdf(tmp_path / f"{name}.pdf")))
        ends: list[list[float]] = [[] for _ in shown[0]]
        for row in shown:
            # Figures stand in the order of the page, each whole and on the line of its row.
            figures = [one for one, _ in row]
            line = next((line for line in lines if [word.text for word in line] == figures), None)
            assert line, f"{name} has no line {row}"
            assert all(left.right < right.left for left, right in pairwise(line))
            for column, word in zip(ends, line, strict=True):
                column.append(word.right)
        # They end below each other, and columns lie as they do in the browser, by shares of the table.
        assert all(max(column) - min(column) < 1.0 for column in ends)
        places = np.array([[column[0] for column in ends], [end for _, end in shown[0]]])
        shares = (places - places[:, :1]) / (places[:, -1:] - places[:, :1])
        assert np.abs(shares[0] - shares[1]).max() < 0.06


def test_a_mark_hangs_beside_its_figure(tmp_path: Path) -> None:
    require("soffice")
    page = replace(tall(3), source="", notes=(Note("Nowhere", "a"),))
    rows = page.panels[0].groups[0].rows
    marked = rows[1]._replace(cells=(rows[1].cells[0]._replace(notes=("a",)),))
    group = page.panels[0].groups[0]._replace(rows=(rows[0], marked, rows[2]))
    panel = replace(page.panels[0], groups=(group,))
    (tmp_path / "page.docx").write_bytes(content(replace(page, panels=(panel,))))
    converted([tmp_path / "page.docx"], "pdf", tmp_path)
    figures = [word for word in words_of_pdf(tmp_path / "page.pdf") if word.text.startswith("0.00")]
    assert len(figures) == 3
    assert figures[1].left == pytest.approx(figures[0].left, abs=1.0)


@pytest.mark.slow
def test_every_row_of_every_layout_has_its_figures_in_a_line(tmp_path: Path) -> None:
    require("soffice")
    # Where a formula has two lines, so have the words beside it.
    names = [name for name in layout_names() if name != "formulas"]
    for name in names:
        (tmp_path / f"{name}.docx").write_bytes(content(default_page(name)))
    converted([tmp_path / f"{name}.docx" for name in names], "pdf", tmp_path)
    for name in names:
        folder = tmp_path / name
        folder.mkdir()
        (tmp_path / f"{name}.pdf").rename(folder / "page.pdf")
        lines = [line for page in lines_of_pdf(folder) for line in page]
        assert_rows_stand_in(lines, default_page(name))
