"""Several handbooks at once, parts of one by name, what is said of them, and all mistakes of a manifest."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import pytest
from cli import Result, refusal
from manifests import handbook as run
from manifests import made as files
from tools import require_library

from kurbel.cli.asking import make_part

MANIFEST = """\
title = "TITLE"
formats = ["csv", "markdown"]

[[chapter]]
title = "Wege"

[[chapter.part]]
run = "table --ratio RATIO --angle 30"
name = "weg"

[[chapter.part]]
run = "table --ratio RATIO --angle 60 --columns c"
name = "geschwindigkeit"

[[chapter]]
title = "Engine"

[[chapter.part]]
text = "See [](#weg)."

[[chapter.part]]
run = "delta --eps 2 --ratio RATIO"
name = "delta"
"""


def book(folder: Path, ratio: str = "1:5", manifest: str = MANIFEST) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    text = manifest.replace("TITLE", folder.name).replace("RATIO", ratio)
    (folder / "handbook.toml").write_text(text, encoding="utf-8")
    return folder


@pytest.fixture
def pair(tmp_path: Path) -> tuple[Path, Path]:
    return book(tmp_path / "one"), book(tmp_path / "two", "1:4")


def test_several_at_once_are_the_same_bytes_as_one_by_one(tmp_path: Path, pair: tuple[Path, Path]) -> None:
    apart = [shutil.copytree(one, tmp_path / "apart" / one.name) for one in pair]
    for one in apart:
        assert run("build", one).code == 0
    # Each once, however often it is named.
    together = run("build", *pair, pair[0] / "handbook.toml")
    assert together.code == 0
    assert [files(one) for one in pair] == [files(one) for one in apart]
    first, second = map(len, map(files, pair))
    *each, summary = together.err.splitlines()
    assert each == [f"kurbel: {one}/pages: {len(files(one)) - 1} written, 0 unchanged" for one in pair]
    assert summary == f"kurbel: 2 handbooks: {first + second - 2} written, 0 unchanged"
    assert run("check", *pair).code == 0


def test_one_that_cannot_be_built_keeps_no_other_from_it(tmp_path: Path, pair: tuple[Path, Path]) -> None:
    (pair[0] / "pages").write_text("a file")
    broken = book(tmp_path / "three", manifest=MANIFEST.replace("title", "titel", 1))
    result = run("build", pair[0], broken, tmp_path / "none", pair[1])
    assert result.code == 1
    assert f"{pair[0]}/pages is a file; the handbook is built into a folder" in result.err
    assert f"{broken}/handbook.toml, line 1: " in result.err
    assert f"there is no folder {tmp_path}/none; kurbel handbook init" in result.err
    assert "tables/delta.csv" in files(pair[1])


def test_two_that_would_remove_each_others_files_are_refused(pair: tuple[Path, Path]) -> None:
    other = pair[0] / "other.toml"
    shutil.copy(pair[1] / "handbook.toml", other)
    result = run("build", pair[0], other)
    assert result.code == 1
    assert f"{other} and {pair[0]}/handbook.toml are both built into {pair[0]}/pages" in result.err
    assert b"0.1590" in files(pair[0])["tables/weg.csv"]


def test_only_what_is_named_is_made(pair: tuple[Path, Path]) -> None:
    one, two = pair
    run("build", one)
    before = files(one)
    book(one, "1:3")
    result = run("build", one, "--only", "weg")
    assert (result.code, result.err) == (0, f"kurbel: {one}/pages: 2 written, 0 unchanged\n")
    changed = {path for path, content in files(one).items() if before[path] != content}
    assert changed == {"tables/weg.csv", "tables/weg.md", "contents.json"}
    # A chapter is all that is in it; of several handbooks those that have it.
    assert run("check", one, "--only", "weg").code == 0
    stale = run("check", one, "--only", "engine")
    assert stale.code == 1
    assert {line.split("/")[-1] for line in stale.out.splitlines() if not line.startswith(" ")} == {
        "delta.csv: differs",
        "delta.md: differs",
    }
    assert f"kurbel handbook build {one} --only engine" in stale.err
    assert run("build", one).code == 0
    run("build", book(two, "1:3"))
    assert {path: content for path, content in files(one).items() if path.startswith("tables")} == {
        path: content for path, content in files(two).items() if path.startswith("tables")
    }


def test_only_in_an_empty_folder_leaves_the_rest_to_the_next_build(pair: tuple[Path, Path]) -> None:
    one, _ = pair
    assert run("build", one, "--only", "delta", "--only", "weg").code == 0
    assert set(files(one)) == {
        "contents.json",
        *(f"tables/{name}.{end}" for name in ("delta", "weg") for end in ("csv", "md")),
    }
    assert run("build", one).code == 0
    assert {"markdown/index.md", "tables/geschwindigkeit.csv"} <= set(files(one))


def test_a_name_that_nothing_has_is_answered_with_the_nearest(pair: tuple[Path, Path]) -> None:
    said = refusal("handbook", "build", *map(str, pair), "--only", "detla", code=2)
    assert 'there is no table, figure or chapter "detla" (did you mean delta?)' in said
    assert not (pair[0] / "pages").exists()


def test_quiet_says_only_what_is_wrong(pair: tuple[Path, Path]) -> None:
    one, two = pair
    assert run("build", one, two, "--quiet") == run("check", one, two, "-q")
    assert run("build", one, "-q") == Result(0, "", "")
    (one / "pages/tables/weg.csv").write_text("mine\n")
    failed = run("check", one, two, "-q")
    assert (failed.code, failed.out) == (1, f"{one}/pages/tables/weg.csv: differs\n")
    assert failed.err.splitlines() == [
        f"kurbel: {one}/pages/tables/weg.csv, line 1: it is not what a build would write",
        f"kurbel: {one}/pages: 1 file is stale; this mends it: kurbel handbook build {one}",
    ]
    book(two, manifest=MANIFEST.replace("--eps 2", "--eps 3"))
    run("build", one, two, "-q")
    book(two, manifest=MANIFEST.replace("--eps 2", "--eps 4"))
    assert f"{two}/handbook.toml, line 22, delta: tables/delta.csv is stale, and so is one more" in (
        run("check", two, "-q").err
    )
    book(two, manifest=MANIFEST.replace("--eps 2", "--esp 2"))
    assert "line 22, delta: " in run("build", two, "-q").err


def test_a_document_that_differs_by_its_text_alone_is_named_with_its_line(pair: tuple[Path, Path]) -> None:
    one, _ = pair
    run("build", one)
    book(one, manifest=MANIFEST.replace("See", "Compare"))
    said = run("check", one).err.splitlines()
    lines = (one / "pages/markdown/02-engine.md").read_text().splitlines()
    (line,) = (number for number, text in enumerate(lines, 1) if text.startswith("See"))
    assert (
        f"kurbel: {one}/pages/markdown/02-engine.md, line {line}: it is not what a build would write" in said
    )


def test_an_interrupted_build_leaves_old_or_new_files(
    pair: tuple[Path, Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    run("build", *pair)
    old = [files(one) for one in pair]
    for one in pair:
        book(one, "1:3")
    made: list[str] = []

    def make(task: Any) -> Any:
        if len(made) == 4:
            raise KeyboardInterrupt
        made.append(task.part.name)
        return make_part(task)

    with monkeypatch.context() as patch:
        patch.setattr("kurbel.cli.handbook.make_part", make)
        assert run("build", *pair).code == 130
    left = [files(one) for one in pair]
    assert left != old
    assert run("build", *pair).code == 0
    new = [files(one) for one in pair]
    for was, now, at in zip(old, new, left, strict=True):
        assert all(at[path] in (was[path], now[path]) for path in was)
        assert {path for path in was if was[path] != now[path]} >= {"tables/weg.csv", "markdown/01-wege.md"}


def test_nothing_is_made_anew_in_whatever_order_the_parts_were_made(
    pair: tuple[Path, Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    require_library("typst")
    one, _ = pair
    book(one, manifest=MANIFEST.replace('"csv", "markdown"', '"pdf"'))
    with monkeypatch.context() as patch:
        # As other processes may be done with them.
        patch.setattr("kurbel.cli.handbook._bar", lambda steps, count: reversed([*steps]))
        assert run("build", one).code == 0
    monkeypatch.setattr("kurbel.cli.handbook.make_part", None)
    assert run("build", one).err.endswith(f": 0 written, {len(files(one)) - 1} unchanged\n")


def test_all_mistakes_of_a_manifest_are_reported_at_once(tmp_path: Path) -> None:
    wrong = MANIFEST.replace("TITLE", "a").replace("RATIO", "1:5")
    for good, bad in (
        ("formats", "formts"),
        ('name = "geschwindigkeit"', 'name = "weg"\nvariant = 0'),
        ('title = "Engine"', 'title = "Engine $x"'),
        ('text = "See', 'run = "\'"\ntext = "See'),
        ('name = "delta"', 'lang = "fr"\ncaption = 3'),
    ):
        assert wrong.count(good) == 1
        wrong = wrong.replace(good, bad)
    folder = book(tmp_path / "a", manifest=wrong + "[defaults]\ndigts = 3\n[[chapter]]\n[[chapter.part]]\n")
    lines = (folder / "handbook.toml").read_text().splitlines()
    result = run("build", folder)
    assert result.code == 1
    said = [one.removeprefix(f"kurbel: {folder}/handbook.toml, line ") for one in result.err.splitlines()]
    shown = [(lines[int(one.split(":")[0]) - 1], one.split(": ", 1)[1]) for one in said]
    assert [line for line, _ in shown] == [
        'formts = ["csv", "markdown"]',
        'name = "weg"',
        "variant = 0",
        'title = "Engine $x"',
        "[[chapter.part]]",
        'lang = "fr"',
        "caption = 3",
        "digts = 3",
        "[[chapter]]",
        "[[chapter.part]]",
    ]
    reasons = ("mean formats?", "is taken in line", "from 1 to 1000", "second $", "run and text", "fr")
    more = ("caption is 3", "mean digits?", "no title", "none of them")
    for (_, sentence), part in zip(shown, reasons + more, strict=True):
        assert part in sentence
    assert not (folder / "pages").exists()


def test_a_table_bears_the_name_of_its_part_whatever_its_options(tmp_path: Path) -> None:
    run_of = "rotor --masses '12;9kg' --radii 50mm --angles '0;70' --planes '0;300mm'"
    folder = book(tmp_path / "a", manifest=MANIFEST.replace("delta --eps 2 --ratio RATIO", run_of))
    book(
        folder,
        manifest=(folder / "handbook.toml").read_text().replace('"csv", "markdown"', '"latex", "html"'),
    )
    assert run("build", folder).code == 0
    assert b"\\label{tab:delta}" in files(folder)["tables/delta.tex"]
    assert b'id="tab-delta"' in files(folder)["tables/delta.html"]
