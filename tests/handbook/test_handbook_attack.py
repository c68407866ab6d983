"""Bad input and hostile surroundings of a handbook: what is in the way is named, nothing else is touched."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from cli import Result, kurbel
from manifests import handbook, write

import kurbel as library
from kurbel.cli.asking import make_part
from kurbel.handbook import build as handbook_build
from kurbel.handbook.pages import make_pdf

MANIFEST = """\
title = "Tafeln"
formats = ["markdown", "csv"]

[[chapter]]
title = "Wege"

[[chapter.part]]
run = "table --ratio 1:5 --step 45"
name = "wege"

[[chapter.part]]
run = "delta --eps 2..4"
name = "delta"
"""


def book(folder: Path, manifest: str = MANIFEST) -> Path:
    return write(folder, manifest)


def build(folder: Path, *options: str) -> Result:
    return handbook("build", folder, *options)


def in_the_way(path: Path, kind: str) -> None:
    path.unlink(missing_ok=True)
    match kind:
        case "folder":
            path.mkdir(parents=True)
        case "pipe":
            os.mkfifo(path)
        case "endless":
            path.symlink_to("/dev/zero")


@pytest.mark.parametrize(
    ("kind", "said"), [("folder", "is a folder"), ("pipe", "is a pipe or a device"), ("endless", "is a link")]
)
@pytest.mark.parametrize("path", ["tables/wege.csv", "contents.json", ".kurbel/state.json"])
def test_what_is_no_file_is_neither_read_nor_overwritten(
    tmp_path: Path, path: str, kind: str, said: str
) -> None:
    build(book(tmp_path))
    in_the_way(tmp_path / "pages" / path, kind)
    (tmp_path / "pages/tables/delta.csv").unlink()
    result = build(tmp_path)
    assert result.code == 1
    assert f"{path} {said}" in result.err
    assert "Traceback" not in result.err
    assert (tmp_path / "pages/tables/delta.csv").is_file()


FORGED = {
    "the folder itself": '{"files": {"": "x"}}',
    "a folder": '{"files": {"tables": "x"}}',
    "a zero in a name": '{"files": {"a\\u0000b": "x"}}',
    "half a character": '{"files": {"\\ud800": "x"}}',
    "a long name": json.dumps({"files": {"a" * 400: "x"}}),
    "depth": "[" * 100_000,
}


@pytest.mark.parametrize("path", ["contents.json", ".kurbel/state.json"])
@pytest.mark.parametrize("content", FORGED.values(), ids=FORGED)
def test_a_forged_list_is_written_anew(tmp_path: Path, path: str, content: str) -> None:
    build(book(tmp_path))
    before = (tmp_path / "pages/contents.json").read_bytes()
    if path != "contents.json" and content.startswith("{"):
        one = {"key": "k", "inputs": {}, "about": None, **json.loads(content)}
        content = json.dumps({"gone": one})
    (tmp_path / "pages" / path).write_text(content)
    result = build(tmp_path)
    assert (result.code, result.out) == (0, ""), result.err
    assert (tmp_path / "pages/contents.json").read_bytes() == before


def test_a_forged_list_removes_nothing_elsewhere(tmp_path: Path) -> None:
    folder = book(tmp_path / "book")
    build(folder)
    victim = tmp_path / "outside/victim"
    victim.parent.mkdir()
    victim.write_text("precious")
    (folder / "pages/way").symlink_to(victim.parent)
    listed = dict.fromkeys(
        ("way/victim", "../../outside/victim", str(victim)), hashlib.sha256(b"precious").hexdigest()
    )
    (folder / "pages/contents.json").write_text(json.dumps({"files": listed}))
    state = {"gone": {"key": "k", "inputs": {}, "files": listed, "about": None}}
    (folder / "pages/.kurbel/state.json").write_text(json.dumps(state))
    assert build(folder).code == 0
    assert victim.read_text() == "precious"


@pytest.mark.parametrize("about", [[], ["song", "", "de"], ["table"]], ids=str)
def test_a_forged_state_is_not_believed(tmp_path: Path, about: list[str]) -> None:
    build(book(tmp_path))
    path = tmp_path / "pages/.kurbel/state.json"
    state = json.loads(path.read_text())
    for one in state.values():
        one["about"] = about
    path.write_text(json.dumps(state))
    (tmp_path / "pages/markdown/index.md").unlink()
    assert build(tmp_path).code == 0


def test_what_a_killed_build_left_is_removed_here_and_nowhere_else(tmp_path: Path) -> None:
    left_over = ".own.0123456789ab.part"
    folder = book(tmp_path / "book")
    outside = tmp_path / "outside"
    outside.mkdir()
    (outside / left_over).write_text("precious")
    (folder / "pages/markdown" / left_over).mkdir(parents=True)
    (folder / "pages" / left_over).write_text("half")
    (folder / "pages/tables").symlink_to(outside)
    result = build(folder)
    assert "is a link, which may lead anywhere" in result.err
    assert (outside / left_over).read_text() == "precious"
    assert not (folder / "pages" / left_over).exists()
    assert "pages: " in result.err


@pytest.mark.parametrize("kind", ["folder", "pipe", "endless"])
def test_a_text_that_is_no_file_is_named(tmp_path: Path, kind: str) -> None:
    folder = book(tmp_path, MANIFEST + '[[chapter.part]]\nfile = "m.md"\n')
    in_the_way(folder / "m.md", kind)
    # The endless one is a link that leads outside, which would be refused before.
    result = build(folder, "--allow-outside")
    assert "m.md: it is a directory or a device; name a file" in result.err
    assert (folder / "pages/tables/wege.csv").is_file()


def test_a_text_larger_than_any_page_is_not_read_whole(tmp_path: Path) -> None:
    folder = book(tmp_path, MANIFEST + '[[chapter.part]]\nfile = "m.md"\n')
    with (folder / "m.md").open("wb") as file:
        file.truncate(1 << 40)
    assert "m.md has more than 200000 characters; make several of it" in build(folder).err


def test_a_command_with_a_control_character_fails_alone(tmp_path: Path) -> None:
    result = build(book(tmp_path, MANIFEST.replace("--step 45", "--step \\u0000")))
    assert "line 8, wege: " in result.err
    assert (tmp_path / "pages/tables/delta.csv").is_file()


def test_documents_are_not_made_of_files_that_are_gone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    build(book(tmp_path / "whole"))
    folder = book(tmp_path / "disturbed")
    document_of = vars(handbook_build)["document_of"]

    def disturbed(*given: Any) -> Any:
        (folder / "pages/tables/wege.md").unlink()
        return document_of(*given)

    with monkeypatch.context() as patch:
        patch.setattr(handbook_build, "document_of", disturbed)
        result = build(folder)
    assert result.code == 1
    assert "tables/wege.md was changed or removed while the handbook was built; build it again" in result.err
    assert build(folder).code == 0
    for path in ("markdown/01-wege.md", "contents.json"):
        assert (folder / "pages" / path).read_bytes() == (tmp_path / "whole/pages" / path).read_bytes()


def test_a_file_saved_during_the_build_is_read_again_by_the_next(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    machine = '[crank]\nspeed = "120/min"\n[steam]\neps = 4\n[flywheel]\npower = "50kW"\ndelta = "1:100"\n'
    folder = book(tmp_path, MANIFEST.replace("delta --eps 2..4", "flywheel --machine engine.toml"))
    (folder / "engine.toml").write_text(machine)

    def saved(task: Any) -> Any:
        made = make_part(task)
        if task.part.name == "delta":
            (folder / "engine.toml").write_text(machine.replace("1:100", "1:80"))
        return made

    with monkeypatch.context() as patch:
        patch.setattr("kurbel.cli.handbook.make_part", saved)
        assert build(folder).code == 0
    table = folder / "pages/tables/delta.csv"
    old = table.read_bytes()
    assert build(folder).code == 0
    assert table.read_bytes() != old
    new = table.read_bytes()
    assert build(folder).code == 0
    assert table.read_bytes() == new


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ('templates = "."', "line 1: templates is the manifest's own folder; name one inside of it"),
        ('templates = "pages/mine"', "templates pages/mine and output pages lie in one another; part them"),
        ('subtitle = "a\\u001b[2Jb"', "line 1: subtitle has the character U+001B, which is a control"),
    ],
)
def test_what_cannot_work_is_refused_with_its_line(tmp_path: Path, line: str, said: str) -> None:
    result = build(book(tmp_path, f"{line}\n{MANIFEST}"))
    assert result.code != 0
    assert said in result.err
    assert not (tmp_path / "pages").exists()


def test_a_pdf_of_ones_own_templates_has_a_time_of_its_own(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    counted: list[bool] = []

    @contextmanager
    def deadline(seconds: float, gigabytes: int) -> Iterator[None]:
        counted.append(True)
        yield

    monkeypatch.setattr("kurbel.formats.templates.deadline", deadline)
    with pytest.raises(library.KurbelError, match=r"handbook\.typ"):
        make_pdf(str(tmp_path), (), limited=True)
    assert counted == [True]


def test_a_file_that_no_system_opens_fails_its_table_alone(tmp_path: Path) -> None:
    longest = "n" * 300
    machine = '[crank]\nstroke = "1m"\nrod = "5m"\n[steam]\ncard = "a\\u0000b"\n'
    (tmp_path / "engine.toml").write_text(machine)
    said = {
        f"collate --sources {longest}": "File name too long",
        f"table --layouts {longest} --layout x": "there is no such folder",
        f"turning --card {longest}": "File name too long",
        f"turning --machine {longest}": "File name too long",
        "delta --card a\\u0000b": "the name of a file has a NUL",
        "turning --machine engine.toml": 'card is "a\\x00b"; it must be the name of a file',
    }
    parts = "".join(f'[[chapter.part]]\nname = "p{i}"\nrun = "{run}"\n' for i, run in enumerate(said))
    manifest = f'title = "T"\nformats = ["csv"]\n[[chapter]]\ntitle = "A"\n{parts}'
    (tmp_path / "handbook.toml").write_text(f'{manifest}[[chapter.part]]\nrun = "table"\n')
    came = kurbel("handbook", "build", "-j", "1", str(tmp_path))
    for number, sentence in enumerate(said.values()):
        line = next(line for line in came.err.splitlines() if f", p{number}: " in line)
        assert sentence in line
    assert "6 failed" in came.err
    assert (tmp_path / "pages/tables/table.csv").exists()
