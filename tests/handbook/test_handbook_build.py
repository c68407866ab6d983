"""A handbook is built from its manifest: what is made, made anew, left alone, removed, and what fails."""

from __future__ import annotations

import fcntl
import hashlib
import json
import os
import pty
import re
import shutil
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Mapping
from contextlib import suppress
from functools import partial
from itertools import takewhile
from pathlib import Path
from typing import Any

import pytest
from cli import Result, kurbel, refusal
from manifests import MACHINE, handbook, write
from manifests import made as files
from programs import Programs, is_alone, wait_until
from tools import require_library

from kurbel.formats.registry import FORMATS
from kurbel.handbook.pool import BuiltFiles, WorkPiece, worked
from kurbel.page import build as page

MANIFEST = """\
title = "Tafeln"
formats = ["text", "latex", "markdown", "html", "csv", "json"]

[[chapter]]
title = "Wege"

[[chapter.part]]
text = "Siehe [](#wege) und [](#schwung)."

[[chapter.part]]
run = "table --ratio 1:5 --step 45"
name = "wege"

[[chapter]]
title = "Engine"
lang = "en"

[[chapter.part]]
run = "flywheel --machine engine.toml"
name = "schwung"
"""


def book(folder: Path, manifest: str = MANIFEST) -> Path:
    return write(folder, manifest, {"engine.toml": MACHINE})


def build(folder: Path, *words: str) -> Result:
    return handbook("build", folder, *words)


def counts(result: Result) -> list[int]:
    """Return how many files were written, unchanged and removed."""
    last = result.err.splitlines()[-1]
    return [int(word) for word in last.replace(",", "").split() if word.isdigit()]


def test_every_table_is_in_every_format_and_every_document_whole(tmp_path: Path) -> None:
    result = build(book(tmp_path / "my book"))
    assert (result.code, result.out) == (0, "")
    made = files(tmp_path / "my book")
    tables = {
        f"tables/{name}.{end}"
        for name in ("wege", "schwung")
        for end in ("txt", "tex", "md", "html", "csv", "json")
    }
    documents = {"handbook.tex", "appendix.tex", "handbook.html", "handbook.txt", "contents.json"}
    pages = {f"markdown/{name}.md" for name in ("index", "01-wege", "02-engine")}
    assert set(made) == tables | documents | pages
    assert counts(result) == [len(made) - 1, 0]
    # The machine's power and irregularity: M = P/(ω³δ) of the energy swing; here only that it was read.
    assert b"50" in made["tables/schwung.html"]
    assert b'lang="en"' in made["tables/schwung.html"]
    listed = json.loads(made["contents.json"])["files"]
    assert listed == {
        path: hashlib.sha256(content).hexdigest() for path, content in made.items() if path != "contents.json"
    }


def test_a_handbook_in_plain_text_has_its_chapters_texts_and_tables(tmp_path: Path) -> None:
    folder = book(tmp_path, re.sub("formats = .*", 'formats = ["text"]', MANIFEST))
    assert build(folder).code == 0
    made = {path: content.decode() for path, content in files(folder).items()}
    page = made["handbook.txt"]
    parts = ("Inhalt", "1  Wege", "Siehe Tabelle 1 und Tabelle 2.", made["tables/wege.txt"], "2  Engine")
    places = [page.rindex(part.rstrip("\n")) for part in (*parts, made["tables/schwung.txt"])]
    assert places == sorted(places)
    assert " Tabelle 1\n Kolbenweg" in page
    assert " Table 2\n" in page


def test_a_handbook_for_sphinx_is_a_project_with_a_page_a_chapter(tmp_path: Path) -> None:
    folder = book(tmp_path, re.sub("formats = .*", 'formats = ["rst"]', MANIFEST))
    assert build(folder).code == 0
    made = files(folder)
    pages = {f"rst/{name}" for name in ("index.rst", "01-wege.rst", "02-engine.rst", "conf.py", "kurbel.css")}
    assert set(made) == pages | {"tables/wege.rst", "tables/schwung.rst", "contents.json"}
    assert b"Siehe :ref:`Tabelle 1 <tab-wege>`" in made["rst/01-wege.rst"]


def test_what_a_table_says_is_what_its_command_prints(tmp_path: Path) -> None:
    build(book(tmp_path))
    for name, end in (("csv", "csv"), ("text", "txt"), ("latex", "tex")):
        words = ("table", "--ratio", "1:5", "--step", "45", "--label", "wege", "-f", name)
        assert files(tmp_path)[f"tables/wege.{end}"].decode() == kurbel(*words).out


def made_anew(folder: Path) -> set[str]:
    """Return the files that the next build writes, those of tables by their names alone."""
    before = {path: (folder / "pages" / path).stat().st_mtime_ns for path in files(folder)}
    assert build(folder).code == 0
    written = {one for one in files(folder) if before.get(one) != (folder / "pages" / one).stat().st_mtime_ns}
    tables = {Path(one).stem for one in written if one.startswith("tables/")}
    # A table is made in every format or in none.
    assert len([one for one in written if one.startswith("tables/")]) == 6 * len(tables)
    return {one for one in written if not one.startswith("tables/")} | tables


def test_what_changed_is_made_anew_and_nothing_else(tmp_path: Path) -> None:
    documents = {"handbook.html", "markdown/01-wege.md", "contents.json"}
    build(book(tmp_path))
    assert made_anew(tmp_path) == set()
    book(tmp_path, MANIFEST.replace("--step 45", "--step 90"))
    command = made_anew(tmp_path)
    assert (documents <= command, command & {"wege", "schwung"}) == (True, {"wege"})
    (tmp_path / "engine.toml").write_text(MACHINE.replace("1:100", "1:80"), encoding="utf-8")
    assert made_anew(tmp_path) & {"wege", "schwung"} == {"schwung"}
    text = MANIFEST.replace("--step 45", "--step 90").replace("Siehe", "Vergleiche")
    write(tmp_path, text)
    changed = made_anew(tmp_path)
    assert (documents <= changed, changed & {"wege", "schwung"}) == (True, set())


@pytest.mark.parametrize("path", ["tables/wege.tex", "handbook.html", "contents.json", ".kurbel/state.json"])
def test_what_somebody_spoilt_is_made_anew(tmp_path: Path, path: str) -> None:
    build(book(tmp_path))
    before = files(tmp_path)
    spoilt = tmp_path / "pages" / path
    for content in (b"", b"\xff{]", b"[]", b'{"a": 3}', None):
        spoilt.unlink() if content is None else spoilt.write_bytes(content)
        assert build(tmp_path).code == 0
        assert files(tmp_path) == before, content


def test_what_is_no_longer_in_the_manifest_is_removed_unless_it_was_changed(tmp_path: Path) -> None:
    build(book(tmp_path))
    (tmp_path / "pages/tables/schwung.csv").write_text("my own\n")
    (tmp_path / "pages/own.txt").write_text("my own\n")
    # As after a fresh clone, where only what is committed is there.
    shutil.rmtree(tmp_path / "pages/.kurbel")
    book(
        tmp_path, MANIFEST[: MANIFEST.index('[[chapter]]\ntitle = "Engine"')].replace("und [](#schwung)", "")
    )
    result = build(tmp_path)
    left = set(files(tmp_path))
    assert {"own.txt", "tables/schwung.csv"} <= left
    assert not {"tables/schwung.tex", "markdown/02-engine.md"} & left
    assert counts(result)[2] == 6


def test_a_part_that_fails_is_reported_and_the_others_are_built(tmp_path: Path) -> None:
    wrong = MANIFEST.replace("--step 45", "--stepp 45").replace("[](#wege) und", "")
    result = build(book(tmp_path, wrong))
    assert result.code == 1
    first, last = result.err.splitlines()
    assert first == (
        f"kurbel: {tmp_path}/handbook.toml, line 11, wege:"
        ' there is no option "--stepp" (did you mean --step?); see kurbel table --help'
    )
    assert last.endswith(", 1 failed")
    made = files(tmp_path)
    assert "tables/schwung.html" in made
    assert "tables/wege.html" not in made
    assert "Fehlt: kurbel table" in made["handbook.html"].decode()
    assert "Fehlt: kurbel table" in made["markdown/01-wege.md"].decode()
    assert b"schwung" in made["handbook.html"]


def test_a_fault_of_the_program_costs_the_part_in_which_it_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    build_page = page.build

    def faulty(question: Any) -> Any:
        if question.subject.command == "table":
            raise ZeroDivisionError("division\nby zero")
        return build_page(question)

    monkeypatch.setattr("kurbel.page.build.build", faulty)
    result = build(book(tmp_path))
    line, last = result.err.splitlines()
    assert line.startswith(f"kurbel: {tmp_path}/handbook.toml, line 11, wege: ZeroDivisionError: division by")
    assert line.endswith(
        "which is a fault of kurbel: please report it with the command or the text of this part"
    )
    assert (result.code, result.out, last.rpartition(", ")[2]) == (1, "", "1 failed")
    made = files(tmp_path)
    assert {"tables/schwung.txt", "handbook.txt"} < {*made} and "tables/wege.txt" not in made


def test_what_was_built_before_stays_where_its_part_fails(tmp_path: Path) -> None:
    build(book(tmp_path))
    before = files(tmp_path)
    book(tmp_path, MANIFEST.replace("--step 45", "--stepp 45"))
    assert build(tmp_path).code == 1
    assert files(tmp_path) == before
    # And it is tried again, though nothing changed.
    assert build(tmp_path).code == 1


def test_a_part_that_fails_is_missing_in_a_new_format_alone(tmp_path: Path) -> None:
    build(book(tmp_path, MANIFEST.replace(', "csv", "json"', "").replace('"latex", ', "")))
    before = files(tmp_path)
    wrong = MANIFEST.replace(', "csv", "json"', "").replace("--step 45", "--stepp 45")
    result = build(book(tmp_path, wrong))
    assert result.code == 1
    assert "document in latex: tables/wege.tex could not be made\n" in result.err
    made = files(tmp_path)
    assert {path: made[path] for path in before if path != "contents.json"} == {
        path: content for path, content in before.items() if path != "contents.json"
    }
    assert {*made} - {*before} == {"tables/schwung.tex"}


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("[](#schwung)", "[](#schwng)", "(did you mean schwung?)"),
        ("flywheel --machine engine.toml", "collate blau-33 --strict", "printed values deviate"),
    ],
)
def test_what_cannot_be_right_fails_and_the_tables_are_built(
    old: str, new: str, said: str, tmp_path: Path
) -> None:
    result = build(book(tmp_path, MANIFEST.replace(old, new)))
    assert (result.code, said in result.err) == (1, True)
    assert "tables/wege.tex" in files(tmp_path)


SETTINGS: tuple[Mapping[str, str], ...] = (
    {
        "TZ": "Pacific/Kiritimati",
        "LC_ALL": "C",
        "PYTHONHASHSEED": "1",
        "KURBEL_LANG": "en",
        "KURBEL_DECIMAL": "point",
    },
    {"TZ": "America/Anchorage", "LC_ALL": "de_DE.UTF-8", "PYTHONHASHSEED": "2", "KURBEL_TABLE_DIGITS": "7"},
)


@pytest.mark.parametrize("epoch", [pytest.param("", marks=pytest.mark.slow), "1000000000"])
def test_two_builds_are_the_same_bytes(tmp_path: Path, epoch: str) -> None:
    require_library("typst")
    require_library("matplotlib")
    require_library("xlsxwriter")
    # The date is that of the PDF and of workbooks alone.
    every = '"pdf", "xlsx", "ods"' if epoch else ", ".join(f'"{name}"' for name in FORMATS)
    text = MANIFEST.replace('"text", "latex", "markdown", "html", "csv", "json"', every)
    text += '\n[[chapter.part]]\nrun = "table --ratio 1:5 --columns p -f drawing"\nname = "bild"\n'
    made: list[dict[str, bytes]] = []
    for place, setting in zip(("one", "two/three four"), SETTINGS, strict=True):
        folder = book(tmp_path / place, text)
        words = [
            sys.executable,
            "-m",
            "kurbel",
            "handbook",
            "build",
            "--jobs",
            str(len(made) + 1),
            str(folder),
        ]
        environment = {**os.environ, **setting, **({"SOURCE_DATE_EPOCH": epoch} if epoch else {})}
        done = subprocess.run(words, env=environment, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        made.append(files(folder))
        if len(made) == 1:
            # The clock of a workbook counts by two seconds.
            time.sleep(2)
    assert made[0] == made[1]
    assert any(path.endswith(".pdf") and path.startswith("handbook") for path in made[0])
    for path, content in made[0].items():
        assert str(tmp_path).encode() not in content, path


def test_check_passes_where_all_is_built_and_says_what_is_stale(tmp_path: Path) -> None:
    build(book(tmp_path))
    before = files(tmp_path)
    passed = handbook("check", tmp_path)
    assert (passed.code, passed.out) == (0, "")
    assert "all 19 files are what the manifest says" in passed.err
    (tmp_path / "pages/tables/wege.md").unlink()
    csv = tmp_path / "pages/tables/wege.csv"
    csv.write_text(csv.read_text().replace("1.0000", "1.0001"))
    failed = handbook("check", tmp_path)
    assert failed.code == 1
    lines = failed.out.splitlines()
    assert lines[0] == f"{tmp_path}/pages/tables/wege.md: missing"
    assert lines[1] == f"{tmp_path}/pages/tables/wege.csv: differs"
    assert any(line.startswith("    -") and "1.0001" in line for line in lines)
    assert f"2 files are stale; this mends it: kurbel handbook build {tmp_path}" in failed.err
    assert not (tmp_path / "pages/tables/wege.md").exists()
    build(tmp_path)
    assert files(tmp_path) == before
    (tmp_path / "pages/contents.json").write_text("{}\n", encoding="utf-8")
    failed = handbook("check", tmp_path)
    assert (failed.code, failed.out) == (1, f"{tmp_path}/pages/contents.json: differs\n")


def test_check_needs_no_state_and_finds_what_is_left_over(tmp_path: Path) -> None:
    build(book(tmp_path))
    shutil.rmtree(tmp_path / "pages/.kurbel")
    assert handbook("check", tmp_path).code == 0
    assert not (tmp_path / "pages/.kurbel").exists()
    book(
        tmp_path, MANIFEST[: MANIFEST.index('[[chapter]]\ntitle = "Engine"')].replace("und [](#schwung)", "")
    )
    failed = handbook("check", tmp_path)
    assert failed.code == 1
    assert f"{tmp_path}/pages/tables/schwung.csv: left over: nothing in the manifest makes it" in failed.out


def test_check_before_any_build_says_that_all_is_missing(tmp_path: Path) -> None:
    failed = handbook("check", book(tmp_path))
    assert failed.code == 1
    assert failed.out.count(": missing\n") == 19
    assert not (tmp_path / "pages").exists()


@pytest.mark.parametrize("lang", ["de", pytest.param("en", marks=pytest.mark.slow)])
def test_the_manifest_of_init_builds_at_once(tmp_path: Path, lang: str) -> None:
    assert kurbel("handbook", "init", str(tmp_path / "a/b"), "--lang", lang).code == 0
    result = build(tmp_path / "a/b")
    assert result.code == 0, result.err
    assert {"handbook.html", "appendix.tex", "handbook.typ", "handbook.pdf"} <= set(files(tmp_path / "a/b"))
    said = refusal("handbook", "init", str(tmp_path / "a/b"), code=1)
    assert said == f"{tmp_path}/a/b/handbook.toml is there already; kurbel handbook build builds it"


def test_init_leaves_out_what_needs_an_extra_that_is_missing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("kurbel.handbook.manifest.find_spec", lambda name: None)
    kurbel("handbook", "init", str(tmp_path))
    text = (tmp_path / "handbook.toml").read_text(encoding="utf-8")
    assert "in kurbel's checkout: pip install '.[pdf]'" in text
    assert "in kurbel's checkout: pip install '.[plot]'" in text
    assert build(tmp_path).code == 0
    assert not any("figures/" in path or path.endswith(".pdf") for path in files(tmp_path))


def test_list_says_what_would_be_made(tmp_path: Path) -> None:
    build(book(tmp_path))
    book(tmp_path, MANIFEST.replace("--step 45", "--step 90").replace("schwung", "rad"))
    listed = kurbel("handbook", "list", str(tmp_path))
    assert listed.out.splitlines() == [
        f"{tmp_path}/pages: text, latex, markdown, html, csv, json",
        "",
        "1 Wege (wege)",
        "    text  Siehe [](#wege) und [](#rad).",
        "    wege  kurbel table --ratio 1:5 --step 90  changed",
        "",
        "2 Engine (engine)",
        "    rad  kurbel flywheel --machine engine.toml  new",
    ]


def test_the_output_leads_nowhere_else(tmp_path: Path) -> None:
    outside = tmp_path / "outside"
    outside.mkdir()
    folder = book(tmp_path / "book")
    (folder / "pages").symlink_to(outside)
    assert "is a link, which may lead anywhere" in refusal("handbook", "build", str(folder), code=1)
    (folder / "pages").unlink()
    (folder / "pages").mkdir()
    (folder / "pages/tables").symlink_to(outside)
    result = build(folder)
    assert result.code == 1
    assert "is a link, which may lead anywhere" in result.err
    (folder / "pages/tables").unlink()
    (folder / "pages/handbook.html").unlink()
    (folder / "pages/handbook.html").symlink_to(outside / "victim")
    (outside / "victim").write_text("precious")
    assert "is a link, which may lead anywhere" in build(folder).err
    assert [path.name for path in outside.iterdir()] == ["victim"]
    assert (outside / "victim").read_text() == "precious"


def test_a_full_disk_leaves_the_old_files_and_no_halves(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    build(book(tmp_path))
    before = files(tmp_path)

    def full(number: int) -> None:
        raise OSError(28, "No space left on device")

    book(tmp_path, MANIFEST.replace("--step 45", "--step 90"))
    monkeypatch.setattr("os.fsync", full)
    result = build(tmp_path)
    assert result.code == 1
    assert "No space left on device" in result.err
    assert "Traceback" not in result.err
    assert files(tmp_path) == before


def test_a_process_that_ends_costs_its_own_part_and_after_three_the_rest_is_not_tried() -> None:
    ends: Any = partial(os._exit, 1)
    pieces = [
        WorkPiece(str(place), "", partial(BuiltFiles, {}) if place == 1 else ends, None) for place in range(6)
    ]
    ended = "its process was ended, for want of memory or from outside"
    untried = "not tried, for others like it were stopped"
    found = {piece.name: became for piece, became in worked(pieces, 2)}
    assert found.pop("1") == BuiltFiles({})
    # Which of two that run at once ends first, the system says.
    assert Counter(found.values()) == {ended: 3, untried: 2}


def run(programs: Programs, folder: Path) -> subprocess.Popen[bytes]:
    return programs.kurbel("handbook", "build", str(folder), "--jobs", "2", stdout=subprocess.PIPE)


MANY = 'title = "Tafeln"\nformats = ["latex", "html", "csv"]\n[[chapter]]\ntitle = "Wege"\n' + "".join(
    f'[[chapter.part]]\nrun = "table --ratio 1:{n} --step STEP"\nname = "t{n}"\n' for n in range(3, 23)
)


@pytest.mark.slow
def test_a_build_killed_at_any_moment_leaves_old_or_new_files(programs: Programs, tmp_path: Path) -> None:
    folder = book(tmp_path / "a", MANY.replace("STEP", "45"))
    build(folder)
    old = files(folder)
    new_book = book(tmp_path / "b", MANY.replace("STEP", "60"))
    build(new_book)
    new = files(new_book)
    assert old.keys() == new.keys()
    book(folder, MANY.replace("STEP", "60"))
    for count in (0, 1, 4, 20, 41):
        process = run(programs, folder)
        await_renewed(folder, old, count, process)
        process.kill()
        process.communicate()
        for path, content in files(folder).items():
            if not path.endswith(".part"):
                assert content in (old[path], new[path]), path
    assert build(folder).code == 0
    assert files(folder) == new


def await_renewed(folder: Path, old: dict[str, bytes], count: int, process: subprocess.Popen[bytes]) -> None:
    """Wait for so many files that are no longer as they were, parts of files among them, or for the end."""

    def renewed() -> bool:
        # A part of a file may be gone before it is read.
        with suppress(FileNotFoundError):
            made = files(folder).items()
            return sum(old.get(path) != content for path, content in made) >= count
        return False

    wait_until(lambda: renewed() or process.poll() is not None)


def test_a_build_waits_for_another_of_the_same_handbook(programs: Programs, tmp_path: Path) -> None:
    folder = book(tmp_path)
    (folder / "pages/.kurbel").mkdir(parents=True)
    with (folder / "pages/.kurbel/lock").open("w") as lock:
        # Also of one that only reads, so that no two builds share it.
        fcntl.flock(lock, fcntl.LOCK_SH)
        process = run(programs, folder)
        assert process.stderr
        assert b"another build of this handbook is under way" in process.stderr.readline()
        assert not (folder / "pages/tables").exists()
    assert b"19 written" in process.communicate()[1]


@pytest.mark.slow
def test_two_builds_at_once_do_not_disturb_one_another(programs: Programs, tmp_path: Path) -> None:
    folder = book(tmp_path / "a", MANY.replace("STEP", "45"))
    both = [run(programs, folder), run(programs, folder)]
    said = [process.communicate()[1].decode() for process in both]
    assert [process.returncode for process in both] == [0, 0], said
    alone = book(tmp_path / "b", MANY.replace("STEP", "45"))
    build(alone)
    assert files(folder) == files(alone)


def test_ctrl_c_ends_a_build_and_its_processes(programs: Programs, tmp_path: Path) -> None:
    folder = book(tmp_path, MANY.replace("STEP", "1"))
    process = run(programs, folder)
    wait_until(lambda: any((folder / "pages/tables").glob("t*")) or process.poll() is not None)
    process.send_signal(signal.SIGINT)
    process.communicate()
    assert process.returncode == 130
    wait_until(lambda: is_alone(process))
    made = files(folder)
    assert 0 < len(made) < 60
    assert not [path for path in made if path.endswith(".part")]


def test_saving_a_file_builds_again_while_one_watches(programs: Programs, tmp_path: Path) -> None:
    folder = book(tmp_path)
    watching = programs.kurbel("handbook", "watch", str(folder), "--jobs", "1")

    def awaited(text: bytes) -> bool:
        assert watching.stderr
        # What fails is said, and would be waited for without end.
        return any(text in line for line in takewhile(lambda one: b"failed" not in one, watching.stderr))

    assert awaited(b"Ctrl-C")
    assert awaited(b"19 written, 0 unchanged")
    (folder / "engine.toml").write_text(MACHINE.replace("1:100", "1:80"), encoding="utf-8")
    assert awaited(b" unchanged")
    assert b"0.0125" in (folder / "pages/tables/schwung.csv").read_bytes()
    (folder / "handbook.toml").write_text("title = 3", encoding="utf-8")
    assert awaited(b"title is 3; it must be a text")
    book(tmp_path)
    assert awaited(b" unchanged")
    watching.send_signal(signal.SIGINT)
    assert watching.wait() == 130


def test_a_bar_shows_on_a_terminal_how_far_it_is(programs: Programs, tmp_path: Path) -> None:
    folder = book(tmp_path)
    ours, terminal = pty.openpty()
    process = programs.kurbel("handbook", "build", str(folder), "--jobs", "1", stderr=terminal)
    os.close(terminal)
    said = b""
    while True:
        try:
            said += os.read(ours, 1000)
        except OSError:
            break
    assert process.wait() == 0
    os.close(ours)
    assert b"2 parts" in said
    assert b"100%" in said


@pytest.mark.parametrize(
    ("template", "said"),
    [
        pytest.param(
            "{% for i in range(99999) %}{% for j in range(99999) %}{% endfor %}{% endfor %}",
            "were stopped after",
            marks=pytest.mark.slow,
        ),
        # One long operation, which no watch in Python would end.
        ("{{ 10 ** (10 ** 10) }}", "were stopped after"),
        ("{{ ''.__class__ }}", "cannot be used"),
        ("{{ pge }}", "'pge' is undefined"),
        ("{% include '../../handbook.toml' %}", "there is no template"),
    ],
)
def test_a_template_that_misbehaves_fails_its_tables_and_no_others(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, template: str, said: str
) -> None:
    monkeypatch.setattr("kurbel.formats.templates.PATIENCE", 1.0)
    text = MANIFEST.replace('title = "Tafeln"', 'title = "Tafeln"\ntemplates = "mine"')
    folder = book(
        tmp_path, text.replace('"text", "latex", "markdown", "html", "csv", "json"', '"markdown", "csv"')
    )
    (folder / "mine/kinematics").mkdir(parents=True)
    (folder / "mine/kinematics/markdown.jinja").write_text(template)
    result = build(folder)
    assert result.code == 1
    assert "line 12, wege: " in result.err
    assert said in result.err
    assert "tables/schwung.md" in files(folder)
    assert "tables/wege.md" not in files(folder)


def test_a_template_of_ones_own_sets_its_tables(tmp_path: Path) -> None:
    text = MANIFEST.replace('title = "Tafeln"', 'title = "Tafeln"\ntemplates = "mine"')
    folder = book(tmp_path, text)
    (folder / "mine/base").mkdir(parents=True)
    own = folder / "mine/base/markdown.jinja"
    own.write_text("My own: {{ page.caption }}\n")
    assert build(folder).code == 0
    assert files(folder)["tables/wege.md"].startswith(b"My own: Kolbenweg")
    own.write_text("My other: {{ page.caption }}\n")
    assert build(folder).code == 0
    assert files(folder)["tables/wege.md"].startswith(b"My other: Kolbenweg")


LAYOUT = """\
title = "Winkel|Angle"
caption = "Stangenwinkel"
ratios = ["1:4", "1:5"]
angles = ["0..180:60"]
down = ["angle"]
stub = ["angle"]
across = ["column", "ratio"]
stub_headings = { angle = "$φ$" }
columns = [{ quantity = "psi", heading = ["$ψ$"], decimals = 1 }]
"""


@pytest.mark.slow
def test_a_layout_of_ones_own_makes_its_tables_and_makes_them_anew_when_it_changes(tmp_path: Path) -> None:
    text = MANIFEST.replace('title = "Tafeln"', 'title = "Tafeln"\nlayouts = "mine"')
    folder = book(tmp_path, text.replace("--ratio 1:5 --step 45", "--layout angle"))
    own = folder / "mine" / "angle" / "layout.toml"
    own.parent.mkdir(parents=True)
    own.write_text(LAYOUT)
    assert build(folder).code == 0
    # sin ψ = λ sin φ: at 60° 12.5039° for 1:4 and 9.9741° for 1:5.
    assert "12,5" in files(folder)["tables/wege.txt"].decode()
    assert kurbel("handbook", "check", str(folder)).code == 0
    own.write_text(LAYOUT.replace("decimals = 1", "decimals = 3"))
    assert kurbel("handbook", "check", str(folder)).code == 1
    assert build(folder).code == 0
    assert "12,504" in files(folder)["tables/wege.txt"].decode()
    own.write_text(LAYOUT.replace('"psi"', '"pso"'))
    came = build(folder)
    assert came.code == 1
    assert "mine/angle/layout.toml, line 9: " in came.err
    assert '"pso" (did you mean psi?)' in came.err
    shutil.rmtree(folder / "mine")
    came = build(folder)
    assert came.code == 1
    assert "handbook.toml, line " in came.err
    assert "mine" in came.err


def test_a_handbook_whose_pdf_takes_much_memory_says_so_before_it_begins(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from kurbel.formats.pdf import writer

    (tmp_path / "handbook.toml").write_text(
        'title = "T"\nformats = ["pdf"]\n[[chapter]]\ntitle = "A"\n'
        '[[chapter.part]]\nrun = "table --ratio 1:5"\nname = "a"\n',
        encoding="utf-8",
    )
    monkeypatch.setattr(writer, "MUCH", 1 << 20)
    said, *rest = build(tmp_path).err.splitlines()
    assert re.fullmatch(r"kurbel: .*/pages: a PDF of \d+ cells takes Typst about 0\.1 GB of memory", said)
    assert rest
    # What need not be set anew takes none.
    assert "memory" not in build(tmp_path).err
