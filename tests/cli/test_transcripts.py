"""Lines as they are typed, and below each all that it prints, or the one sentence by which it is refused.

`tests/transcripts/refused` and `printed` have a file a command. A new line, `$ kurbel forces --eps 0.5` or
`>>> kurbel.forces(eps="0.5")`, gets what stands below it from `make golden`; read it. `exit 1: ` before
a sentence says that a job failed. A block begins with a comment after `# ` or with files that its lines read,
each as `file NAME` and its lines, indented by four spaces. Lines run in a folder that has these files and the
folders `cards`, `examples` and `sources`. Pages stand here for their words and their look: that figures are
right is proved elsewhere.
"""

from __future__ import annotations

import os
import shlex
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from cli import kurbel as run
from places import CARDS, ROOT, SOURCES, TRANSCRIPTS

import kurbel

SHELL, PYTHON, FILE, COMMENT, INDENT, FAILED = "$ ", ">>> ", "file ", "# ", "    ", "exit 1: "


@dataclass
class Block:
    """Lines that are tried in one folder: what stands before them, its files, each line and its output."""

    head: list[str] = field(default_factory=list)
    files: dict[str, str] = field(default_factory=dict)
    lines: list[str] = field(default_factory=list)
    outputs: list[str] = field(default_factory=list)


def blocks(text: str) -> list[Block]:
    found = [Block()]
    for line in text.splitlines():
        if line.startswith((SHELL, PYTHON)):
            found[-1].lines.append(line)
            found[-1].outputs.append("")
            continue
        if line.startswith((FILE, COMMENT)) and found[-1].lines:
            found.append(Block())
        block = found[-1]
        if block.lines:
            block.outputs[-1] += line + "\n"
            continue
        block.head.append(line)
        if line.startswith(FILE):
            name = line.removeprefix(FILE)
            block.files[name] = ""
        elif line.startswith(INDENT):
            block.files[name] += line.removeprefix(INDENT) + "\n"
    return found


def refused(line: str) -> str:
    """Return the sentence, after the exit code where that is not 2."""
    if line.startswith(PYTHON):
        try:
            eval(line.removeprefix(PYTHON), {"kurbel": kurbel})
        except kurbel.KurbelError as error:
            code, sentence = error.exit_code, str(error)
        else:
            raise AssertionError(f"not refused: {line}")
    else:
        code, out, err = shell(line)
        assert code, f"not refused: {line}"
        assert out == "", line
        prefix, sentence = err.split(": ", 1)
        assert prefix == "kurbel", err
        sentence = sentence.removesuffix("\n")
    assert code in (1, 2)
    assert sentence
    assert sentence.isprintable(), sentence
    assert not sentence.endswith("."), sentence
    assert ". " not in sentence, sentence
    return f"{FAILED if code == 1 else ''}{sentence}\n"


def printed(line: str) -> str:
    code, out, err = shell(line)
    assert (code, err) == (0, ""), line
    return out


def shell(line: str) -> tuple[int, str, str]:
    words = shlex.split(line.removeprefix(SHELL))
    name = words.index("kurbel")
    result = run(*words[name + 1 :], **dict(word.split("=", 1) for word in words[:name]))
    return result.code, result.out, result.err


@pytest.mark.parametrize(
    "path", sorted(TRANSCRIPTS.glob("*/*.txt")), ids=lambda path: f"{path.parent.name}-{path.stem}"
)
def test_each_line_prints_what_stands_below_it(
    path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    outcome = {"refused": refused, "printed": printed}[path.parent.name]
    found = []
    for number, block in enumerate(blocks(path.read_text(encoding="utf-8"))):
        folder = tmp_path / str(number)
        folder.mkdir()
        for name, place in (("cards", CARDS), ("sources", SOURCES), ("examples", ROOT / "examples")):
            (folder / name).symlink_to(place)
        for name, content in block.files.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(content, encoding="utf-8")
        before = sorted(folder.rglob("*"))
        monkeypatch.chdir(folder)
        found += block.head
        for line in block.lines:
            found += [line, *outcome(line).splitlines(), ""]
        assert sorted(folder.rglob("*")) == before, f"something is left behind by {block.lines}"
    if os.environ.get("KURBEL_PROMOTE") == "1":
        path.write_text("\n".join(found), encoding="utf-8")
    assert found == [*path.read_text(encoding="utf-8").splitlines(), ""]
