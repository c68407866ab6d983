"""Manual pages: one for each command and each file that is read, with all that help and schemas say."""

from __future__ import annotations

import json
import os
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import click
import pytest
from cli import kurbel, refusal
from places import ROOT
from terminals import own_terminal
from tools import require

from kurbel.cli import COMMANDS
from kurbel.cli.app import command_of
from kurbel.cli.manual.pages import FILES, pages

COMMON = {"kurbel", *FILES}


def commands() -> Iterator[tuple[str, click.Command]]:
    for name in COMMANDS:
        yield name, (command := command_of(name))
        if isinstance(command, click.Group):
            yield from ((f"{name}-{one}", inner) for one, inner in command.commands.items())


def plain(page: bytes) -> str:
    """Return the text of a page without the notation of man(7)."""
    text = re.sub(r"\\f[BIR]|\\&|^\.\w+ ?", "", page.decode(), flags=re.MULTILINE)
    text = re.sub(r"\\\[u([0-9A-F]{4,})\]", lambda one: chr(int(one[1], 16)), text)
    for sign, written in (("-", "\\-"), ("'", "\\(aq"), ("`", "\\(ga"), ("^", "\\(ha"), ("~", "\\(ti")):
        text = text.replace(written, sign)
    return text.replace("\\e", "\\")


def test_there_is_a_page_for_each_command_and_each_file() -> None:
    assert set(pages()) == COMMON | {name for name, _ in commands()}


@pytest.mark.parametrize(("name", "command"), [*commands()], ids=lambda one: str(one))
def test_a_page_says_of_every_option_what_the_help_says(name: str, command: click.Command) -> None:
    page = pages()[name].text()
    said = " ".join(plain(page).split())
    for one in command.get_params(click.Context(command)):
        if isinstance(one, click.Option) and not one.hidden:
            # Copied from a page that is typeset it is still an option, and no word with hyphens.
            assert rb"\fB" + max(one.opts, key=len).replace("-", r"\-").encode() in page
            assert " ".join((one.help or "").split()) in said


@pytest.mark.parametrize("name", FILES)
def test_a_page_of_a_file_has_every_key_of_its_schema(name: str) -> None:
    said = " ".join(plain(pages()[name].text()).split())
    schema = json.loads((ROOT / "src/kurbel" / FILES[name][0]).read_text(encoding="utf-8"))

    def check(section: Any) -> None:
        for key, one in section.get("properties", {}).items():
            assert key in said
            if key != "defaults":
                check(one)
                check(one.get("items", {}))

    check(schema)
    assert "[[chapter.part]]" in said or name != "handbook.toml"


def test_pages_are_written_where_man_finds_them(tmp_path: Path) -> None:
    result = kurbel("man", "-o", str(tmp_path / "new"))
    written = {str(one.relative_to(tmp_path / "new")) for one in tmp_path.rglob("*") if one.is_file()}
    assert written == {one.file for one in pages().values()}
    assert {"man1/kurbel-table.1", "man1/kurbel-handbook-build.1", "man5/kurbel-handbook.toml.5"} < written
    assert (result.code, result.out) == (0, "")
    assert result.err == (
        f"kurbel: {len(written)} manual pages are written; man finds them with:"
        f" MANPATH={tmp_path / 'new'}: man kurbel-table\n"
    )
    assert kurbel("man", "handbook", "build").out.encode() == pages()["handbook-build"].text()


def test_what_cannot_be_shown_or_written_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert 'there is no manual page "tabel" (did you mean table?)' in refusal("man", "tabel")
    (tmp_path / "file").write_text("")
    folder = str(tmp_path / "file" / "below")
    assert refusal("man", "-o", folder, code=1) == f"cannot make the folder {folder}: Not a directory"
    monkeypatch.setenv("PATH", "/nowhere")
    with own_terminal(80, 24, PATH="/nowhere"):
        from kurbel.cli.man import man

        with pytest.raises(Exception, match="kurbel table --help says the same"):
            man.main(["table"], standalone_mode=False)


def test_a_page_is_found_by_the_name_that_man_has_for_it() -> None:
    assert kurbel("man", "kurbel-handbook-build").out == kurbel("man", "handbook build").out
    assert (
        kurbel("man", "kurbel").out
        != kurbel("man", "kurbel-handbook.toml").out
        == kurbel("man", "handbook.toml").out
    )


def test_shells_complete_the_names_of_pages() -> None:
    words = {"_KURBEL_COMPLETE": "bash_complete", "COMP_WORDS": "kurbel man handbook", "COMP_CWORD": "2"}
    offered = [line.split(",")[1] for line in kurbel(**words).out.splitlines()]
    assert offered == [name for name in pages() if name.startswith("handbook")]


@pytest.mark.slow
def test_man_and_mandoc_show_every_page_without_a_warning(tmp_path: Path) -> None:
    kurbel("man", "-o", str(tmp_path))
    files = sorted(map(str, tmp_path.rglob("*.[15]")))
    said = subprocess.run([require("mandoc"), "-T", "lint", "-W", "warning", *files], capture_output=True)
    assert (said.returncode, said.stdout, said.stderr) == (0, b"", b"")
    settings = os.environ | {"LC_ALL": "C.UTF-8", "MANWIDTH": "80", "MANPAGER": "cat"}
    for file in files:
        done = subprocess.run([require("man"), "--warnings", "-l", file], capture_output=True, env=settings)
        assert (done.returncode, done.stderr) == (0, b""), file
        assert max(map(len, done.stdout.decode().splitlines())) <= 80
