"""The pages of the documentation: what they link to is there, and the reference leaves no option out."""

from __future__ import annotations

import re
import runpy
import shlex
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from cli import kurbel
from completion import EVERY, described
from places import ROOT

import kurbel as library

DOCS = ROOT / "docs"
GENERATE = DOCS / "generate"
# What the examples of the help name, beside the examples.
NAMED = {
    "rod.csv": "from [mm];to [mm];mass [kg]\n-120;140;16,8\n140;1350;24,2\n1350;1580;9,1\n",
    # The acceleration to the first order at R:L = 1:4, cos φ + cos 2φ/4.
    "scan.csv": "phi;p\n0;1,250\n60;0,375\n90;-0,250\n180;-0,750\n",
    "notes.md": "<!-- kurbel: table --ratio 1:5 -->\n<!-- /kurbel -->\n",
    "sweep.toml": 'command = "delta"\noutput = "delta.parquet"\n[axes]\neps = "2..6"\n',
    "lectures/first.tex": "% kurbel: table\n% /kurbel\n",
}


@pytest.fixture(scope="module")
def pages() -> Iterator[dict[str, str]]:
    """The pages of the reference by their places."""
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(GENERATE)
        yield runpy.run_path(str(GENERATE / "reference.py"))["pages"]()


def test_the_reference_describes_every_option_of_every_command(pages: dict[str, str]) -> None:
    for words in EVERY:
        page = pages[f"reference/command-line/{words[0]}.md"]
        # Those of a sweep are those of its command.
        for option in described(*words, "--") if words[0] != "sweep" else ():
            written = rf"^:+{{option}} (-\w, )?{option}\b"
            assert option == "--help" or re.search(written, page, re.MULTILINE), (words, option)


def test_every_command_and_every_file_has_a_manual_page(pages: dict[str, str]) -> None:
    manual = runpy.run_path(str(DOCS / "conf.py"))["man_pages"]
    files = [name for name in pages if re.match(r"reference/files/(?!index)\w+\.md", name)]
    assert {f"{place}.md" for place, *_ in manual} == {
        "reference/command-line/kurbel.md",
        *(f"reference/command-line/{words[0]}.md" for words in EVERY),
        *files,
    }
    assert {(name, section) for _, name, _, _, section in manual} == {
        ("kurbel", 1),
        *((f"kurbel-{words[0]}", 1) for words in EVERY),
        *((f"kurbel-{Path(name).stem}.toml", 5) for name in files),
    }


def test_the_reference_describes_every_name_of_the_library(pages: dict[str, str]) -> None:
    described = "".join(text for name, text in pages.items() if name.startswith("reference/python/"))
    for name in set(library.__all__) - {"__version__"}:
        assert re.search(rf"^:+{{py:\w+}} {name}\b", described, re.MULTILINE), name


def test_the_reference_says_how_quantities_count(pages: dict[str, str]) -> None:
    rows = pages["reference/quantities.md"].splitlines()
    for key, command, said in (
        (
            "turn_velocity",
            "table --mechanism arc",
            "turning of the rocker positive in the direction of the stroke",
        ),
        ("turn_acceleration", "table --mechanism beam", "turning of the beam positive in the direction"),
        ("rod_acceleration", "table", "turning of the rod positive against the sense of the crank"),
        ("guide_force", "table", "on the crosshead, towards the side on which the crank pin runs"),
    ):
        [row] = [row for row in rows if row.startswith(f"| `{key}` |") and row.endswith(f"`{command}` |")]
        assert said in row


def test_links_lead_to_pages_that_there_are(pages: dict[str, str]) -> None:
    """Those that are made with the site stand in no folder; the gallery is made of pictures."""
    made = {(DOCS / name).resolve() for name in pages} | {DOCS / "gallery" / "index.md"}
    for page in (ROOT / "README.md", *DOCS.rglob("*.md")):
        text = re.sub(r"```.*?```|`[^`\n]*`", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
        for target in re.findall(r"\]\((?!https?:)([^)#\s]+)", text):
            leads_to = (page.parent / target).resolve()
            assert leads_to.exists() or leads_to in made, f"{page.relative_to(ROOT)} links to {target}"


@pytest.mark.slow
def test_every_example_of_the_reference_runs(
    pages: dict[str, str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In turn, in a folder with the files that they name; but for what runs until it is ended."""
    monkeypatch.chdir(shutil.copytree(ROOT / "examples", tmp_path / "examples"))
    shutil.rmtree("appendix")
    for name, text in NAMED.items():
        Path(name).parent.mkdir(exist_ok=True)
        Path(name).write_text(text, encoding="utf-8")
    shown = "".join(text for name, text in pages.items() if "command-line" in name)
    lines = [
        line for block in re.findall(r"```sh\n(.*?)```", shown, re.DOTALL) for line in block.splitlines()
    ]
    typed = [line for line in lines if " watch " not in line]
    assert len(typed) > 100
    assert kurbel("handbook", "init", "lectures").code == 0
    assert kurbel("handbook", "build", "lectures", "--jobs", "1").code == 0
    for line in typed:
        words = shlex.split(line.replace("*.tex", "first.tex"))
        assert words[0] == "kurbel", line
        own = ("--jobs", "1") if words[1:3] == ["handbook", "build"] else ()
        result = kurbel(*words[1:], *own)
        assert result.code == 0, (line, result.err)


def test_lines_of_prose_have_at_most_120_characters() -> None:
    """What programs print is as wide as it is, and a row of a table cannot be broken."""
    pages = [*ROOT.glob("*.md"), *DOCS.rglob("*.md")]
    assert len(pages) > 60
    for page in pages:
        text = re.sub(r"^( *```).*?^\1", "", page.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)
        long = [line for line in text.splitlines() if len(line) > 120 and not line.startswith("|")]
        assert not long, (page, long)
