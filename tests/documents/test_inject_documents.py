"""`kurbel inject`: tables come into documents of every kind and stay true there; mistakes change nothing."""

from __future__ import annotations

import os
import re
import time
from importlib import import_module
from itertools import pairwise
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any
from unittest import mock

import pytest
from apart import apart, as_nobody
from cli import Result, kurbel, printed, refusal
from markdown_it import MarkdownIt
from places import TRANSCRIPTS
from tex import compiled, complaints
from tools import require_library

MARKERS = {
    ".md": ("<!-- kurbel: {} -->", "<!-- /kurbel -->"),
    ".html": ("<!-- kurbel: {} -->", "<!-- /kurbel -->"),
    ".tex": ("% kurbel: {}", "% /kurbel"),
    ".typ": ("// kurbel: {}", "// /kurbel"),
}
FORMATS = {".md": "markdown", ".html": "html", ".tex": "latex", ".typ": "typst"}
TABLE = "table --ratio 1:4 --step 60 --lang en"
OLD = "old\n"
each_suffix = pytest.mark.parametrize("suffix", MARKERS)


def place(suffix: str, words: str = TABLE, old: str = "") -> str:
    opening, closing = MARKERS[suffix]
    return f"{opening.format(words)}\n{old}{closing}\n"


def written(folder: Path, text: str | bytes, name: str = "notes.md") -> Path:
    path = folder / name
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return path


def refused(path: Path) -> str:
    """Return the sentence of a document that must stay as it is, by its name and without kurbel's."""
    before, when = path.read_bytes(), path.stat().st_mtime_ns
    said = [refusal("inject", *words, str(path), code=1) for words in ((), ("--check",))]
    assert (path.read_bytes(), path.stat().st_mtime_ns) == (before, when)
    assert said[0] == said[1]
    return said[0].replace(str(path), path.name)


def refreshed(path: Path) -> bytes:
    result = kurbel("inject", str(path))
    assert (result.code, result.out) == (0, ""), result.err
    assert result.err in (
        f"kurbel: {count} in {path} refreshed\n" for count in ("1 place", "2 places", "3 places")
    )
    return path.read_bytes()


# What comes into a document.


@each_suffix
def test_a_table_is_that_of_the_command_in_the_format_of_the_document(suffix: str, tmp_path: Path) -> None:
    path = written(tmp_path, f"before\n\n{place(suffix, old=OLD)}\nafter", f"notes{suffix}")
    # The only table of its layout has the layout's label.
    table = printed(*TABLE.split(), "--label=kinematics", "-f", FORMATS[suffix]).out
    blank = "\n" if suffix == ".md" else ""
    expected = place(suffix, old=f"{blank}{table}{blank}")
    assert refreshed(path).decode() == f"before\n\n{expected}\nafter"
    # A second time nothing is written or said.
    os.utime(path, ns=(1, 1))
    assert printed("inject", str(path)).out == ""
    assert printed("inject", "--check", str(path)).out == ""
    assert path.stat().st_mtime_ns == 1


@each_suffix
def test_check_shows_what_inject_writes_and_how_to_mend_it(suffix: str, tmp_path: Path) -> None:
    path = written(tmp_path, f"a\n{place(suffix, old=OLD)}b\n", f"my notes{suffix}")
    before = path.read_bytes()
    result = kurbel("inject", "--check", str(path))
    assert result.code == 1
    assert result.err.splitlines() == [
        f"kurbel: {path}:2: what stands between the markers is stale",
        f"kurbel: {path} is stale; mend with: kurbel inject '{path}'",
    ]
    assert path.read_bytes() == before
    after = refreshed(path).decode().splitlines()
    assert result.out.splitlines()[:2] == [f"--- {path}", f"+++ {path}"]
    added = [line[1:] for line in result.out.splitlines()[2:] if line.startswith("+")]
    assert added == after[2:-2]
    assert "-old" in result.out


def test_check_shows_nothing_of_places_that_are_as_they_should_be(tmp_path: Path) -> None:
    words = ("delta --eps 2", TABLE, "delta --eps 3")
    path = written(tmp_path, "".join("text\n" * 4 + place(".md", one) for one in words))
    lines = refreshed(path).decode().splitlines()
    expected = []
    for shift, one in enumerate(("delta --eps 2", "delta --eps 3")):
        number = lines.index(f"<!-- kurbel: {one} -->") + 1
        lines.insert(number, "old")
        around = [f"{'-' if line == 'old' else ' '}{line}" for line in lines[number - 3 : number + 4]]
        expected += [f"@@ -{number - 2},7 +{number - 2 - shift},6 @@", *around]
    written(tmp_path, "".join(f"{line}\n" for line in lines))
    assert kurbel("inject", "--check", str(path)).out.splitlines()[2:] == expected


def test_check_names_all_stale_documents(tmp_path: Path) -> None:
    a, b = (
        written(tmp_path, lines + place(".md"), f"{name}.md") for name, lines in (("a", ""), ("b", "\n\n"))
    )
    result = kurbel("inject", "--check", str(a), str(b))
    assert result.err.splitlines() == [
        f"kurbel: {a}:1: what stands between the markers is stale",
        f"kurbel: {b}:3: what stands between the markers is stale",
        f"kurbel: {a} and {b} are stale; mend with: kurbel inject {a} {b}",
    ]


def cells_of(text: str) -> list[list[str]]:
    tokens = MarkdownIt("gfm-like", {"linkify": False}).parse(text)
    rows: list[list[str]] = []
    for before, token in pairwise(tokens):
        if token.type == "tr_open":
            rows.append([])
        if before.type in ("th_open", "td_open"):
            rows[-1].append(token.content)
    return rows


@pytest.mark.parametrize(
    ("before", "indent"), [("Text\n", 0), ("- item\n\n  - deeper\n\n", 4), ("1.  item\n", 4), ("- item\n", 2)]
)
def test_a_table_in_markdown_is_one_for_a_library_of_it(before: str, indent: int, tmp_path: Path) -> None:
    marked = "".join(f"{' ' * indent}{line}\n" for line in place(".md").splitlines())
    text = refreshed(written(tmp_path, f"{before}{marked}\nText behind it\n")).decode()
    rows = cells_of(text)
    records = printed(*TABLE.split(), "-f", "csv").records()
    for row, record in zip(rows[1:], records, strict=True):
        assert row == [value.replace("-", "−") for key, value in record.items() if key != "ratio"]
    html = MarkdownIt("gfm-like", {"linkify": False}).render(text)
    assert html.count("<table>") == 1
    assert "<pre>" not in html
    assert "<strong>Piston path" in html


def test_latex_with_several_places_compiles(tmp_path: Path) -> None:
    body = (
        place(".tex", f"{TABLE} --label one")
        + "Text.\n"
        + place(".tex", "table --ratio 1:4 --step 2 --longtable --label two --lang en")
        + "See \\ref{tab:one} and \\ref{tab:two}.\n"
    )
    packages = "amsmath,array,booktabs,graphicx,longtable"
    text = (
        "\\documentclass[a4paper]{article}\n\\usepackage[T1]{fontenc}\n\\usepackage{lmodern}\n"
        "\\usepackage[textwidth=16cm,textheight=24cm]{geometry}\n"
        f"\\usepackage{{{packages}}}\n\\begin{{document}}\n{body}\\end{{document}}\n"
    )
    path = written(tmp_path, text, "notes.tex")
    log = compiled("pdflatex", refreshed(path).decode(), tmp_path, runs=3)
    assert complaints(log) == []
    assert "Output written on page.pdf" in log


def test_typst_with_a_table_compiles(tmp_path: Path) -> None:
    require_library("typst")
    import typst

    path = written(tmp_path, f"{place('.typ')}\nSee @tab-kinematics.\n", "notes.typ")
    refreshed(path)
    assert typst.compile(str(path), ignore_system_fonts=True).startswith(b"%PDF")


def test_a_table_of_latex_that_is_longer_than_a_page_is_pointed_out(tmp_path: Path) -> None:
    path = written(tmp_path, f"\n{place('.tex', 'table --step 2')}", "notes.tex")
    result = kurbel("inject", str(path))
    assert result.err.splitlines()[0] == (
        f"kurbel: {path}:2: the table is longer than a page;"
        " it is set in parts, with --longtable where it stands"
    )
    assert result.code == 0


def test_drawings_of_html_share_no_ids_and_no_style(tmp_path: Path) -> None:
    require_library("matplotlib")
    text = place(".html", "table --ratio 1:5 --columns p -f svg") * 2
    html = refreshed(written(tmp_path, text, "notes.html")).decode()
    ids = re.findall(r'\bid="([^"]+)"', html)
    assert len(ids) == len(set(ids)) > 10
    used = set(re.findall(r'href="#([^"]+)"', html)) | set(re.findall(r"url\(#([^)]+)\)", html))
    assert used
    assert used <= set(ids)
    assert html.count('role="img" aria-labelledby="kurbel-') == 2
    assert "var(--" not in html
    assert html.count("max-width: 100%; height: auto") == 2
    assert '<title id="kurbel-1-title">Kolbenbeschleunigung für R:L = 1:5; genaue Formeln</title>' in html
    assert "<style" not in html
    assert "<metadata" not in html
    assert "<?xml" not in html
    assert not re.search(r"[ \t]$", html, re.MULTILINE)


# Where files are, and what is not asked.


def test_files_in_a_marker_are_those_beside_the_document(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "lectures"
    folder.mkdir()
    (folder / "engine.toml").write_text('[crank]\nratio = "1:3"\n', encoding="utf-8")
    path = written(folder, place(".md", "table --machine engine.toml --angle 60"))
    monkeypatch.chdir(tmp_path)
    assert "R:L = 1:3" in refreshed(path).decode()
    (tmp_path / "link.md").symlink_to(path)
    assert printed("inject", "--check", "link.md", os.path.relpath(path)).out == ""
    assert Path.cwd() == tmp_path


def test_variables_of_the_environment_change_nothing(tmp_path: Path) -> None:
    path = written(tmp_path, place(".md", "table --angle 60"))
    new = refreshed(path)
    variables = {"KURBEL_LANG": "en", "KURBEL_TABLE_RATIO": "1:3", "KURBEL_FORMAT": "csv"}
    assert printed("inject", "--check", str(path), **variables).out == ""
    assert path.read_bytes() == new


def test_a_link_stays_and_its_file_is_refreshed(tmp_path: Path) -> None:
    path = written(tmp_path, place(".md"))
    link = tmp_path / "link.md"
    link.symlink_to(path)
    result = kurbel("inject", str(link), str(path))
    assert result == Result(0, "", f"kurbel: 1 place in {link} refreshed\n")
    assert link.is_symlink()
    assert "| 60 |" in re.sub(" +", " ", path.read_text(encoding="utf-8"))


def test_each_document_is_done_or_not_by_itself(tmp_path: Path) -> None:
    good, bad = written(tmp_path, place(".md"), "good.md"), written(tmp_path, "<!-- /kurbel -->", "bad.md")
    result = kurbel("inject", str(bad), str(tmp_path / "missing.md"), str(good))
    assert result.code == 1
    assert [line.split(":")[1].strip() for line in result.err.splitlines()] == [
        str(bad), f"cannot read {tmp_path / 'missing.md'}", f"1 place in {good} refreshed",
    ]  # fmt: skip
    assert "Piston path" in good.read_text(encoding="utf-8")


# Mistakes. The document stays as it is.


def test_a_command_that_fails_in_the_second_place_leaves_the_first_alone(tmp_path: Path) -> None:
    path = written(tmp_path, place(".md") + place(".md", "table --ratio 2:1"))
    assert refused(path).startswith("notes.md:3: crank ratio R:L is 2; ")
    assert [one.name for one in tmp_path.iterdir()] == ["notes.md"]


def test_every_document_with_a_mistake_in_a_marker_stays_as_it_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = (TRANSCRIPTS / "refused/inject.txt").read_text(encoding="utf-8")
    for name, lines in re.findall(r"^file (.*)\n((?:    .*\n)*)", text, re.MULTILINE):
        written(tmp_path, re.sub("^    ", "", lines, flags=re.MULTILINE), name)
    monkeypatch.chdir(tmp_path)
    sentences = dict(re.findall(r"^\$ kurbel inject (\w.{1,99})\nexit 1: (.*)$", text, re.MULTILINE))
    assert {name: refused(Path(name)) for name in sentences} == sentences
    assert len(sentences) > 40


LAYOUT = """\
title = "Winkel|Angle"
caption = "Stangenwinkel"
ratios = ["1:4"]
angles = ["0..180:60"]
down = ["ratio", "angle"]
stub = ["angle"]
across = ["column"]
[[columns]]
quantity = "psi"
"""


@pytest.mark.parametrize(
    ("template", "sentence"),
    [
        # One long operation, which no watch in Python would end.
        ("{{ 10 ** (10 ** 10) }}", "were stopped after 1 s, or at 1 gigabytes"),
        ("{{ 'a' * 10**10 }}", "markdown.jinja, line 1 cannot be used: it needs more memory than there is"),
    ],
)
def test_a_template_in_a_marker_has_the_limits_of_handbooks(
    template: str, sentence: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("kurbel.formats.templates.PATIENCE", 1.0)
    monkeypatch.setattr("kurbel.formats.templates.GIGABYTES", 1)
    own = tmp_path / "mine/slant"
    own.mkdir(parents=True)
    (own / "layout.toml").write_text(LAYOUT)
    (own / "markdown.jinja").write_text("{{ page.caption }}!\n")
    path = written(tmp_path, place(".md", "table --layouts mine --layout slant"))
    assert "Stangenwinkel!" in refreshed(path).decode()
    (own / "markdown.jinja").write_text(template)
    words = ("table", "--layouts", f"{tmp_path}/mine", "--layout", "slant", "-f", "markdown")
    results = [kurbel("inject", str(path)), *([] if "**" in template else [kurbel(*words)])]
    for result in results:
        assert (result.code, sentence in result.err) == (1, True), result.err
    assert "Stangenwinkel!" in path.read_text()


def test_of_several_tables_of_a_layout_that_with_its_defaults_keeps_the_label(tmp_path: Path) -> None:
    labels = re.compile(rb"\\label\{tab:(.*?)\}")
    path = written(tmp_path, place(".tex") + place(".tex", "table --ratio 1:5"), "notes.tex")
    assert labels.findall(refreshed(path)) == [b"kinematics", b"kinematics-ratio-1-5"]
    assert refreshed(written(tmp_path, place(".md") * 2)).count(b"**Piston path") == 2
    path = written(tmp_path, place(".tex") + place(".tex", "table --lang en"), "notes.tex")
    assert labels.findall(refreshed(path)) == [b"kinematics-ratio-1-4-step-60", b"kinematics"]


def test_a_document_of_another_encoding_is_refused_where_the_table_is_no_ascii(tmp_path: Path) -> None:
    latin = f"Maß\n{place('.tex', 'table --ratio 1:4 --step 60')}".encode("latin-1")
    assert refused(written(tmp_path, latin, "notes.tex")) == (
        "notes.tex is not in UTF-8, in which its tables would be written; save it in UTF-8"
    )
    assert "is in UTF-16" in refused(written(tmp_path, place(".md").encode("utf-16")))
    for unread, said in ((b"\0", "cannot be seen"), (b" \xff", "not in UTF-8")):
        assert said in refused(
            written(tmp_path, b"<!-- kurbel: table" + unread + b" -->\n<!-- /kurbel -->\n")
        )
    english = written(tmp_path, f"Maß\n{place('.tex')}".encode("latin-1"), "english.tex")
    assert refreshed(english).startswith("Maß\n".encode("latin-1"))
    # What is not touched need not be read.
    path = written(tmp_path, b"\x89PNG\r\n\x00\xff", "image.md")
    assert kurbel("inject", str(path)).code == 0
    assert path.read_bytes() == b"\x89PNG\r\n\x00\xff"


def test_what_is_no_file_is_said_to_be_none(tmp_path: Path) -> None:
    (tmp_path / "folder.md").mkdir()
    os.mkfifo(tmp_path / "pipe.md")
    for name, sentence in (
        ("folder.md", "is a directory; name the documents in it"),
        ("pipe.md", "is no file that could be written anew; name a document"),
    ):
        result = kurbel("inject", str(tmp_path / name))
        assert result == Result(1, "", f"kurbel: {tmp_path / name} {sentence}\n")


def test_a_document_that_is_saved_meanwhile_keeps_what_was_saved(tmp_path: Path) -> None:
    path = written(tmp_path, place(".md"))

    asked = import_module("kurbel.cli.inject").asked

    def saved(*words: Any, **options: Any) -> Any:
        path.write_text("saved", encoding="utf-8")
        return asked(*words, **options)

    with mock.patch("kurbel.cli.inject.asked", saved):
        result = kurbel("inject", str(path))
    sentence = f"kurbel: {path} was changed while its tables were made; refresh it again\n"
    assert (result, path.read_text(encoding="utf-8")) == (Result(1, "", sentence), "saved")


@pytest.mark.parametrize(
    "text", ["<!-- kurbl: table -->\n", "<!-- kurbel table -->\n", "% kurbel: table\n", ""]
)
def test_a_document_without_markers_is_told_how_they_look(tmp_path: Path, text: str) -> None:
    path = written(tmp_path, text)
    for words in (("inject",), ("inject", "--check")):
        result = kurbel(*words, str(path))
        assert (result.code, result.out) == (0, "")
        assert "has no markers; they are <!-- kurbel: table --ratio 1:5 --> and " in result.err
    assert path.read_text() == text


def test_the_folder_in_which_kurbel_runs_does_not_matter(tmp_path: Path) -> None:
    path = written(tmp_path, place(".md"))

    def gone() -> None:
        (tmp_path / "gone").mkdir()
        os.chdir(tmp_path / "gone")
        (tmp_path / "gone").rmdir()
        assert kurbel("inject", str(path)) == Result(0, "", f"kurbel: 1 place in {path} refreshed\n")

    apart(gone)


def test_a_read_only_document_is_refused_only_where_it_is_stale() -> None:
    with TemporaryDirectory() as name:
        folder = Path(name)
        folder.chmod(0o755)
        path, fresh = (written(folder, place(".md"), one) for one in ("notes.md", "fresh.md"))
        refreshed(fresh)
        path.chmod(0o444)
        fresh.chmod(0o444)

        def tried() -> None:
            assert refusal("inject", str(path), code=1) == f"cannot write {path}: the file is read-only"
            assert printed("inject", str(fresh)).out == ""

        as_nobody(tried)


def test_ten_megabytes_are_gone_through_in_seconds(tmp_path: Path) -> None:
    line = b"A line of text such as a lecture has, with `code` and 1:5 in it, of eighty letters.\n"
    path = written(tmp_path, line * 124_000 + b"\n" + place(".md").encode() + b"\n" + line)
    begun = time.process_time()
    refreshed(path)
    assert time.process_time() - begun < 2
    assert path.stat().st_size > 10_000_000
