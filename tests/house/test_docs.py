"""The pages of the documentation: what they link to is there, and the reference leaves no option out."""

from __future__ import annotations

import re
import runpy
from collections.abc import Iterator

import click
import pytest
from places import ROOT

import kurbel
from kurbel.cli import COMMANDS
from kurbel.cli.app import command_of

DOCS = ROOT / "docs"
GENERATE = DOCS / "generate"


def options(command: click.Command) -> Iterator[tuple[str, str]]:
    """Every command that has no commands of its own, with its options."""
    if isinstance(command, click.Group):
        for inner in command.commands.values():
            yield from options(inner)
    for parameter in command.params:
        if isinstance(parameter, click.Option) and not parameter.hidden:
            yield str(command.name), parameter.opts[-1]


@pytest.fixture(scope="module")
def pages() -> Iterator[dict[str, str]]:
    """The pages of the reference by their places."""
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(GENERATE)
        yield runpy.run_path(str(GENERATE / "reference.py"))["pages"]()


def test_the_reference_describes_every_option_of_every_command(pages: dict[str, str]) -> None:
    for name in COMMANDS:
        described = pages[f"reference/command-line/{name}.md"]
        for one, option in options(command_of(name)):
            written = rf"^:+{{option}} (-\w, )?{option}\b"
            assert re.search(written, described, re.MULTILINE), (name, one, option)


def test_the_reference_describes_every_name_of_the_library(pages: dict[str, str]) -> None:
    described = "".join(text for name, text in pages.items() if name.startswith("reference/python/"))
    for name in set(kurbel.__all__) - {"__version__"}:
        assert re.search(rf"^:+{{py:\w+}} {name}\b", described, re.MULTILINE), name


def test_links_lead_to_pages_that_there_are(pages: dict[str, str]) -> None:
    """Those that are made with the site stand in no folder; the gallery is made of pictures."""
    made = {(DOCS / name).resolve() for name in pages} | {DOCS / "gallery" / "index.md"}
    for page in (ROOT / "README.md", *DOCS.rglob("*.md")):
        text = re.sub(r"```.*?```|`[^`\n]*`", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
        for target in re.findall(r"\]\((?!https?:)([^)#\s]+)", text):
            leads_to = (page.parent / target).resolve()
            assert leads_to.exists() or leads_to in made, f"{page.relative_to(ROOT)} links to {target}"
