"""What a manifest or a document names lies in its folder, wherever links lead, but with --allow-outside."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest
from cli import Result, kurbel

SECRET = "token-of-another-project"
MACHINE = (
    '[crank]\nstroke = "600mm"\nrod = "1.5m"\nspeed = "90/min"\n[steam]\nbore = "300mm"\npressure = "8bar"\n'
)
CARD = "position [%];p_forward [bar];p_return [bar]\n" + "".join(
    f"{share};8.0;1.5\n" for share in range(0, 101, 10)
)
SAID = "leads out of the folder of the handbook; put what it names into that folder, or add --allow-outside"
OF_A_DOCUMENT = SAID.replace("handbook", "document")
RUNS = {
    "beside": "collate --csv ../secret.csv",
    "by-its-root": "collate --csv {outside}/secret.csv",
    "by-a-link": "collate --csv link.csv",
    "by-a-way": "collate --csv way/secret.csv",
    "by-a-machine": "turning --machine engine.toml",
    "by-a-cylinder": "turning --machine cylinders.toml",
    "by-a-cylinder-in-words": "forces --cylinder card=../secret.csv",
    "by-a-cylinder-of-a-drawing": "turning --cylinder card=way/secret.csv -f drawing",
    "by-a-rod-of-a-cylinder": "delta --cylinder 'eps=4 rod-file=link.csv'",
    "by-a-rod": "inertia --rod-file ../secret.csv --stroke 1m --rod 2m --speed 1/s",
    "by-a-book": "collate --sources books",
    "by-layouts": "table --layouts pages-of-mine --layout mine",
    "by-a-folder-of-layouts": "table --layouts linked --layout mine",
    "by-a-torque": "flywheel --torque-file ../secret.csv --delta 1:100 --speed 1/s",
    "by-a-machine-elsewhere": "table --machine ../elsewhere.toml",
}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """The folder of a handbook, which leads in every way to files beside it."""
    (tmp_path / "secret.csv").write_text(f"{SECRET}\n")
    (tmp_path / "elsewhere.toml").write_text(MACHINE)
    (tmp_path / "outside/book").mkdir(parents=True)
    folder = tmp_path / "book"
    (tmp_path / "outside/layout.toml").write_text(SECRET)
    for made in ("books/one", "linked", "pages-of-mine/mine"):
        (folder / made).mkdir(parents=True)
    (folder / "link.csv").symlink_to("../secret.csv")
    (folder / "way").symlink_to("..")
    (folder / "linked/mine").symlink_to("../../outside")
    (folder / "books/one/source.toml").symlink_to(tmp_path / "secret.csv")
    (folder / "pages-of-mine/mine/layout.toml").symlink_to(tmp_path / "secret.csv")
    (folder / "engine.toml").write_text(f'{MACHINE}card = "../secret.csv"\n')
    cylinder = '[[cylinder]]\nangle = 0\ncard = "link.csv"\n[[cylinder]]\nangle = 90\neps = 3\n'
    (folder / "cylinders.toml").write_text(f"{MACHINE}eps = 4\n{cylinder}")
    return folder


def build(folder: Path, parts: str, *words: str, top: str = "", command: str = "build") -> Result:
    manifest = f'title = "T"\nformats = ["csv", "html"]\n{top}[[chapter]]\ntitle = "A"\n{parts}'
    (folder / "handbook.toml").write_text(manifest)
    return kurbel("handbook", command, str(folder), "--jobs", "1", *words)


@pytest.mark.parametrize("command", ["build", "check"])
def test_no_command_reads_outside(command: str, folder: Path) -> None:
    runs = {name: run.format(outside=folder.parent) for name, run in RUNS.items()}
    parts = "".join(f'[[chapter.part]]\nname = "{name}"\nrun = "{run}"\n' for name, run in runs.items())
    done = build(folder, parts, command=command)
    said = {name: line for name in runs for line in done.err.splitlines() if f", {name}: " in line}
    assert {name for name, line in said.items() if line.endswith(SAID)} == {*runs}
    assert SECRET not in done.err + done.out
    allowed = build(folder, parts, "--allow-outside", command=command)
    assert SAID not in allowed.err
    assert allowed.err.count(SECRET) > 3


@pytest.mark.parametrize("words", [("inject",), ("inject", "--check")])
@pytest.mark.parametrize("run", RUNS.values(), ids=RUNS)
def test_no_marker_reads_outside(run: str, words: Sequence[str], folder: Path) -> None:
    marker = f"<!-- kurbel: {run.format(outside=folder.parent)} -->\n<!-- /kurbel -->\n"
    notes = folder / "notes.md"
    notes.write_text(marker)
    done = kurbel(*words, str(notes))
    assert (done.code, done.err.startswith(f"kurbel: {notes}:1: ")) == (1, True)
    assert done.err.endswith(f"{OF_A_DOCUMENT}\n")
    assert SECRET not in done.err + done.out
    assert notes.read_text() == marker
    assert OF_A_DOCUMENT not in kurbel(*words, "--allow-outside", str(notes)).err


def test_a_document_reads_outside_where_that_is_allowed(folder: Path) -> None:
    notes = folder / "notes.md"
    notes.write_text(f"<!-- kurbel: {RUNS['by-a-machine-elsewhere']} -->\n<!-- /kurbel -->\n")
    assert kurbel("inject", "--allow-outside", str(notes)).code == 0
    assert "R:L = 1:5" in notes.read_text()


@pytest.mark.parametrize(
    ("parts", "top"),
    [
        ('[[chapter.part]]\nfile = "link.md"\n', ""),
        ('[[chapter.part]]\nproblems = "link.toml"\n', ""),
        ('[[chapter.part]]\nrun = "table"\n', 'templates = "link"\n'),
        ('[[chapter.part]]\nrun = "table"\n', 'layouts = "link"\n'),
        ('[[chapter.part]]\nrun = "table"\n', 'machine = "link.toml"\n'),
    ],
)
def test_no_key_reads_outside(parts: str, top: str, folder: Path) -> None:
    (folder.parent / "text.md").write_text(SECRET)
    (folder / "link.md").symlink_to("../text.md")
    (folder / "link.toml").symlink_to("../elsewhere.toml")
    (folder / "link").symlink_to("../outside")
    done = build(folder, parts, top=top)
    assert (done.code, SAID in done.err) == (1, True)
    assert not any(SECRET in path.read_text() for path in folder.glob("pages/**/*.html"))


def test_what_was_built_of_files_outside_is_no_longer_taken_for_built(folder: Path) -> None:
    part = '[[chapter.part]]\nname = "delta"\nrun = "table --machine ../elsewhere.toml"\n'
    assert build(folder, part, "--allow-outside").code == 0
    assert build(folder, part).code == 1
    assert build(folder, part, "--allow-outside").code == 0


def test_a_card_in_the_words_of_a_cylinder_lies_beside_the_manifest_and_is_noticed(folder: Path) -> None:
    card = folder / "card.csv"
    card.write_text(CARD)
    run = "delta --cylinder 'card=card.csv bore=300mm' --stroke 600mm --rod 1.5m"
    part = f'[[chapter.part]]\nname = "delta"\nrun = "{run}"\n'
    assert (build(folder, part).code, build(folder, part, command="check").code) == (0, 0)
    card.write_text(CARD.replace("8.0", "7.0"))
    assert build(folder, part, command="check").code == 1
