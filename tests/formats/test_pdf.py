"""PDF from the command line and from Python: whole, the same on every day, and refused with a sentence."""

from __future__ import annotations

import itertools
import json
import os
import pty
import re
import socketserver
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from cli import kurbel as ran
from cli import printed, refusal
from everything import everything, tall
from tools import require, require_library
from typeset import broken_formulas, has_pauses, words_of_pdf
from verapdf import validate

import kurbel
from kurbel.formats.pdf import STANDARDS, writer
from kurbel.formats.pdf.writer import FONTS, LETTERS, compile_typst, offline
from kurbel.reading.environment import how_to_install

require_library("typst")
HELP = "see kurbel table --help"
NO_PACKAGES = "it imports a package (@...); packages come from the network and are not used"
# Dates in the old dictionary and in the XML of a PDF.
_DATE = re.compile(rb"(?:Creation|Mod)Date\(D:(\d{14})|<xmp:(?:Create|Modify)Date>([^<]+)")


@pytest.fixture(autouse=True)
def _no_date_of_the_tester(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("SOURCE_DATE_EPOCH", raising=False)


def dates(made: bytes) -> set[bytes]:
    return {old or new for old, new in _DATE.findall(made)}


def in_pipe(folder: Path, **environment: str) -> bytes:
    """Run `kurbel table -f pdf` in another process, in that folder, and return what it prints."""
    command = [sys.executable, "-m", "kurbel", "table", "--ratio", "1:5", "--angle", "0..90:30", "-f", "pdf"]
    clean = {name: text for name, text in os.environ.items() if "KURBEL" not in name}
    return subprocess.run(
        command, stdout=subprocess.PIPE, check=True, cwd=folder, env=clean | environment
    ).stdout


def test_the_same_table_is_the_same_file_on_every_day_in_every_zone_locale_and_folder(tmp_path: Path) -> None:
    first = in_pipe(Path("/"), TZ="Asia/Tokyo", LC_ALL="de_DE.UTF-8")
    # The clock of a PDF counts seconds.
    time.sleep(1)
    assert in_pipe(tmp_path, TZ="America/New_York", LC_ALL="C") == first
    assert first.startswith(b"%PDF-")
    assert dates(first) == set()


def test_the_date_of_the_file_is_the_one_of_the_sources() -> None:
    stamped = in_pipe(Path("/"), SOURCE_DATE_EPOCH="1000000000", TZ="Asia/Tokyo")
    assert dates(stamped) == {b"20010909014640", b"2001-09-09T01:46:40+00:00"}


def test_an_archive_demands_a_date(monkeypatch: pytest.MonkeyPatch) -> None:
    made = kurbel.typeset_pdf(everything(), standards=["a-2b", "ua-1"])
    assert dates(made) == {b"19700101000000", b"1970-01-01T00:00:00+00:00"}
    assert b"<pdfaid:part>2</pdfaid:part>" in made
    assert b"<pdfuaid:part>1</pdfuaid:part>" in made
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "86400")
    assert b"19700102000000" in dates(kurbel.typeset_pdf(everything(), standards=["a-2b"]))


def test_page_with_every_part_complies_with_every_standard() -> None:
    for standard in STANDARDS:
        assert kurbel.typeset_pdf(everything(), standards=[standard]).startswith(b"%PDF-")


def test_python_and_the_command_line_make_the_same_file(tmp_path: Path) -> None:
    assert kurbel.typeset_pdf(kurbel.table("1:5", angle="0..90:30")) == in_pipe(tmp_path)


@pytest.mark.parametrize(
    "words", [("table", "--standalone"), ("collate", "blau-33"), ("example", "blau", "33")], ids=" ".join
)
def test_commands_write_pdf(words: tuple[str, ...], tmp_path: Path) -> None:
    path = tmp_path / "tafel.PDF"
    assert printed(*words, "-o", str(path)).out == ""
    assert path.read_bytes().startswith(b"%PDF-")


def test_a_terminal_gets_a_sentence_instead_of_bytes() -> None:
    ours, terminal = pty.openpty()
    command = [sys.executable, "-m", "kurbel", "table", "-f", "pdf"]
    done = subprocess.run(command, stdout=terminal, stderr=subprocess.PIPE, text=True, check=False)
    os.close(terminal)
    os.close(ours)
    sentence = f"a terminal shows no pdf; name a file, such as -o kurbel.pdf; {HELP}"
    assert (done.returncode, done.stderr) == (2, f"kurbel: {sentence}\n")


def test_without_the_extra_a_sentence_says_what_to_install(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setitem(sys.modules, "typst", None)
    sentence = f"PDF needs typst; install it with: {how_to_install('pdf')}"
    assert refusal("table", "-o", str(tmp_path / "tafel.pdf"), code=1) == sentence
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: compile_typst("Text\n#foo"), "Typst cannot set the document, line 2: unknown variable: foo"),
        (
            lambda: compile_typst('#panic("a\nb")', standards=["a-2b"]),
            "Typst cannot set the document, line 1: panicked with: a b",
        ),
        (
            lambda: compile_typst('#import "@preview/x:1.0.0": *'),
            f"Typst cannot set the document, line 1: {NO_PACKAGES}",
        ),
    ],
)
def test_mistakes_are_sentences(call: Callable[[], object], sentence: str) -> None:
    with pytest.raises(kurbel.KurbelError) as caught:
        call()
    assert str(caught.value) == sentence


@pytest.mark.parametrize("epoch", ["gestern", "-1", "253402300800"])
def test_a_date_that_is_none_is_refused(epoch: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOURCE_DATE_EPOCH", epoch)
    with pytest.raises(kurbel.KurbelError) as caught:
        compile_typst("Text")
    sentence = f'SOURCE_DATE_EPOCH is "{epoch}"; it must be a number of seconds from 1970 up to the year 9999'
    assert str(caught.value) == sentence


def test_a_document_reads_the_files_of_its_folder_and_no_others(tmp_path: Path) -> None:
    root = tmp_path / "book"
    root.mkdir()
    (tmp_path / "secret.typ").write_text("geheim")
    (root / "table.typ").write_text("Zeile\n#bar")
    (root / "whole.typ").write_text("Zeile")
    assert compile_typst('#include "whole.typ"', root=str(root)).startswith(b"%PDF-")
    for source, kind, start in (
        ('#include "table.typ"', str(root), "Typst cannot set the document, table.typ, line 2: unknown"),
        ('#include "../secret.typ"', str(root), "Typst cannot set the document, line 1: "),
        (f'#read("{root / "whole.typ"}")', None, "Typst cannot set the document, line 1: file not found"),
        ("Text", str(tmp_path / "nowhere"), f"the folder {tmp_path / 'nowhere'} does not exist"),
    ):
        with pytest.raises(kurbel.KurbelError) as caught:
            compile_typst(source, root=kind)
        assert str(caught.value).startswith(start)


def test_nothing_that_a_document_includes_reaches_the_network(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    import typst

    (tmp_path / "plain.typ").write_text('\n#import "@preview/x:1.0.0": *')
    (tmp_path / "built.typ").write_text('#import ("@pre" + "view/x:1.0.0"): *')
    package = tmp_path / "data/typst/packages/local/own/1.0.0"
    package.mkdir(parents=True)
    (package / "typst.toml").write_text(
        '[package]\nname = "own"\nversion = "1.0.0"\nentrypoint = "own.typ"\n'
    )
    (package / "own.typ").write_text("Text")
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    asked: list[object] = []

    class Refused(socketserver.BaseRequestHandler):
        def handle(self) -> None:
            asked.append(self.request.recv(100))

    with socketserver.ThreadingTCPServer(("127.0.0.1", 0), Refused) as listening:
        threading.Thread(target=listening.serve_forever, args=[0.01], daemon=True).start()
        # The way out of this machine, for those who have no other.
        proxy = f"http://127.0.0.1:{listening.server_address[1]}"
        monkeypatch.setenv("HTTPS_PROXY", proxy)
        monkeypatch.setenv("NO_PROXY", "localhost")
        for source, place in (
            ('#include "plain.typ"', "plain.typ, line 2"),
            ('#include "built.typ"', "built.typ, line 1"),
            ('#import "@local/own:1.0.0"', "line 1"),
        ):
            with pytest.raises(kurbel.KurbelError) as caught:
                compile_typst(source, root=str(tmp_path))
            assert str(caught.value) == f"Typst cannot set the document, {place}: {NO_PACKAGES}"
        # Not even a name was looked up: Typst has no such proxies.
        with offline(), pytest.raises(typst.TypstError, match="SOCKS"):
            typst.compile(b'#import "@preview/x:1.0.0"', package_path=tmp_path, package_cache_path=tmp_path)
        listening.shutdown()
    assert asked == []
    # Programs that are started later have the proxy again.
    assert subprocess.run(["env"], capture_output=True, text=True, check=True).stdout.count(proxy) == 1


def structure(made: bytes, folder: Path) -> list[str]:
    """Return the lines of the tagged structure, without how deep they lie."""
    (folder / "page.pdf").write_bytes(made)
    command = [require("pdfinfo"), "-struct", "page.pdf"]
    done = subprocess.run(command, cwd=folder, capture_output=True, check=True, encoding="utf-8")
    return [line.strip() for line in done.stdout.splitlines()]


def test_labels_of_rows_are_headers_to_which_the_cells_of_their_row_refer(tmp_path: Path) -> None:
    page = kurbel.table(["1:5", "1:4"], angle="0..90:30", layout="roetscher-112")
    lines = structure(kurbel.typeset_pdf(page), tmp_path)
    lines = lines[lines.index("TBody") :]
    starts = [place for place, line in enumerate(lines) if line == "TR"]
    rows = [lines[start:end] for start, end in itertools.pairwise([*starts, len(lines)])]
    body = [row for row in rows if "/Scope /Row" in row]
    # Two ratios, each with a row of cosines and one of sines.
    assert len(body) == 4
    for row, labels in zip(body, (2, 1, 2, 1), strict=True):
        names = [found[1] for line in row if (found := re.fullmatch(r"TH <(\w+)>:", line))]
        assert len(names) == labels == row.count("/Scope /Row")
        cells = "\n".join(row).split("\nTD")[1:]
        assert len(cells) == len(page.panels[0].columns) + (2 - labels)
        assert all(f"({name})" in cell for name in names for cell in cells)


def test_the_table_of_places_says_where_each_object_begins() -> None:
    made = kurbel.typeset_pdf(everything())
    at = int(made.rpartition(b"startxref\n")[2].split()[0])
    assert made[at:].startswith(b"xref\n")
    places = re.findall(rb"(\d{10}) \d{5} n", made[at:])
    assert places
    for place in map(int, places):
        assert re.match(rb"\d+ 0 obj", made[place:]), place


def test_poppler_finds_nothing_wrong(tmp_path: Path) -> None:
    (tmp_path / "page.pdf").write_bytes(kurbel.typeset_pdf(everything(), standards=["a-2a", "ua-1"]))
    for command in (["pdfinfo", "page.pdf"], ["pdftotext", "page.pdf", "-"], ["pdffonts", "page.pdf"]):
        done = subprocess.run(
            [require(command[0]), *command[1:]], cwd=tmp_path, capture_output=True, check=True
        )
        assert done.stderr == b""


def test_no_formula_breaks_that_a_line_end_meets(tmp_path: Path) -> None:
    page = kurbel.table("1:5", angle="0..90:30", columns="phi,x,c,p")
    (tmp_path / "page.pdf").write_bytes(kurbel.typeset_pdf(page))
    words = words_of_pdf(tmp_path / "page.pdf")
    assert any("cos" in word.text for word in words)
    assert list(broken_formulas(words)) == []


def test_formulas_are_of_the_family_of_the_text(tmp_path: Path) -> None:
    (tmp_path / "page.pdf").write_bytes(kurbel.typeset_pdf(kurbel.table("1:5", angle="0..90:30")))
    listed = subprocess.run(
        [require("pdffonts"), "page.pdf"], cwd=tmp_path, capture_output=True, check=True, encoding="utf-8"
    ).stdout
    names = {line.split()[0].partition("+")[2].split("-")[0] for line in listed.splitlines()[2:]}
    # The third has only signs such as ± and =.
    assert names == {"LibertinusSerif", "LibertinusMath", "NewCMMath"}


@pytest.mark.slow
def test_an_independent_validator_finds_archivable_and_accessible_what_claims_to_be(tmp_path: Path) -> None:
    pages = {"everything": everything(), "tall": tall(60), "halves": kurbel.table(layout="roetscher-112")}
    for name, page in pages.items():
        path = tmp_path / f"{name}.pdf"
        path.write_bytes(kurbel.typeset_pdf(page, standards=["a-2a", "ua-1"]))
        assert validate(path, "ua1", "2a") == {"ua1": [], "2a": []}
    plain = tmp_path / "plain.pdf"
    plain.write_bytes(kurbel.typeset_pdf(everything()))
    assert [rule for rule in validate(plain, "ua1")["ua1"] if "PDF/UA version" in rule]


def test_indices_of_the_letters_of_formulas_stand_below_the_line() -> None:
    import typst

    document = f"""
#show math.equation: set text(font: ("{LETTERS}", "New Computer Modern Math"), bottom-edge: "bounds")
#context for it in ($x$, $x_m$) [#metadata(measure(it).height / 1em.to-absolute()) <found>]
"""
    fonts = typst.Fonts(include_system_fonts=False, font_paths=[FONTS])
    found = typst.query(document.encode(), "<found>", field="value", font_paths=fonts)
    letter, with_index = json.loads(found)
    assert with_index > letter + 0.1


def test_rows_pause_before_every_30_degrees(tmp_path: Path) -> None:
    page = tmp_path / "page.pdf"
    kurbel.table(lang="en").save(page)
    assert has_pauses(words_of_pdf(page), least=2)


def test_what_takes_much_memory_says_so_before_it_begins_and_what_takes_too_much_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # 10,000 rows of seven columns took 2.6 GB.
    monkeypatch.setattr(writer, "free_memory", lambda: None)
    assert [*writer.remarks(70_007)] == ["a PDF of 70007 cells takes Typst about 2.7 GB of memory"]
    # A handbook of 200 tables took 1.65 GB.
    assert [*writer.remarks(33_422, 201)] == ["a PDF of 33422 cells takes Typst about 1.6 GB of memory"]
    assert [*writer.remarks(7_000)] == []
    target = tmp_path / "page.pdf"
    words = ("table", "--ratio=1:5", "--step=10", "--to=180", "-o", str(target))
    monkeypatch.setattr(writer, "MUCH", 1 << 20)
    assert "kurbel: a PDF of 133 cells takes Typst about 0.1 GB of memory\n" in ran(*words).err
    monkeypatch.setattr(writer, "free_memory", lambda: 1 << 20)
    assert re.fullmatch(
        r"a PDF of about \d+ cells takes Typst 0\.1 GB of memory, and 0\.0 GB are free; make several of it,"
        r" print fewer rows, or have a TeX set its LaTeX",
        refusal(*words, code=1),
    )
    # What it includes is counted too.
    (tmp_path / "tables").mkdir()
    (tmp_path / "tables" / "a.typ").write_text("[" * 5000, encoding="utf-8")
    with pytest.raises(kurbel.KurbelError, match="about 5000 cells"):
        compile_typst('#include "tables/a.typ"', root=str(tmp_path))
