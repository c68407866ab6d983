"""docs/howto/handbook.md: its example builds, and every key of the manifest is described."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import pytest
from cli import refusal
from manifests import built
from places import ROOT

import kurbel

SCHEMA = Path(kurbel.__file__).parent / "handbook" / "handbook.schema.json"
WHOLE = json.loads(SCHEMA.read_text(encoding="utf-8"))
CHAPTER = WHOLE["properties"]["chapter"]["items"]
SECTIONS = {
    "handbook": WHOLE["properties"],
    "chapter": CHAPTER["properties"],
    "part": CHAPTER["properties"]["part"]["items"]["properties"],
    "pdf": WHOLE["properties"]["pdf"]["properties"],
}
GUIDE = (ROOT / "docs" / "howto" / "handbook.md").read_text(encoding="utf-8")
HEADINGS = {"handbook": "At the top"}


def example() -> str:
    found = re.search(r"```toml\n(.*?)```", GUIDE, re.DOTALL)
    assert found
    return found[1]


def described(section: str) -> str:
    """Return the section of the guide on these keys."""
    heading = f"\n### {HEADINGS.get(section, section)}\n"
    assert heading in GUIDE
    return re.split(r"\n##+ ", GUIDE.split(heading)[1])[0]


@pytest.mark.parametrize("section", SECTIONS)
def test_every_key_is_described_and_no_other(section: str) -> None:
    names = set()
    for line in re.findall(r"^\| (`.+?`) \|", described(section), re.MULTILINE):
        names |= {name.strip("[]`").split(".")[-1] for name in line.split(", ")}
    assert names == {*SECTIONS[section]}


def test_values_that_a_key_may_have_are_named() -> None:
    for section, keys in SECTIONS.items():
        text = described(section)
        for name, key in keys.items():
            if name not in ("standards", "lang"):
                allowed = key.get("items", key).get("enum", ())
                assert not [one for one in allowed if f"`{one}`" not in text], name


def test_every_command_is_described() -> None:
    names = refusal("handbook", "x").partition("choose from ")[2].split(", ")
    assert {"build", "check", "watch"} < {*names}
    for name in names:
        assert f"kurbel handbook {name} " in GUIDE


def test_the_example_has_every_key_but_few_and_builds(tmp_path: Path) -> None:
    folder = tmp_path / "appendix"
    folder.mkdir()
    (folder / "motion.md").write_text("See [](#paths) and [](#acceleration).\n", encoding="utf-8")
    shutil.copy(ROOT / "examples" / "engine.toml", folder)
    teaching = (ROOT / "docs" / "subjects" / "teaching.md").read_text(encoding="utf-8")
    problems = re.search(r"```toml\n(# problems.toml\n.*?)```", teaching, re.DOTALL)
    assert problems
    (folder / "problems.toml").write_text(problems[1], encoding="utf-8")
    names = {name for section in SECTIONS.values() for name in section}
    unused = {name for name in names if not re.search(rf"\b{name}\b", example())}
    assert unused == {"templates", "layouts", "pdf", "standards", "verify"}
    pages = built(folder, example())
    named = {"tables/paths.tex", "figures/acceleration.svg", "handbook.html", "appendix.tex"}
    for name in named | {"handbook.tex", "markdown/index.md", "markdown/01-motion.md", "contents.json"}:
        assert (pages / name).is_file(), name
    appendix = (pages / "appendix.tex").read_text(encoding="utf-8")
    for label in re.findall(r"cref\{(.+?)\}", GUIDE):
        if label.startswith("tab"):
            table = (pages / f"tables/{label[4:]}.tex").read_text(encoding="utf-8")
            assert f"\\label{{{label}}}" in table
        else:
            assert f"\\label{{{label}}}" in appendix
