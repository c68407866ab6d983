"""A user's folder of templates: it outdoes ours, can do no harm, and its mistakes are named with line."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from everything import everything
from handbook import document, fragments, table

from kurbel.errors import LayoutError
from kurbel.formats.documents import document_files
from kurbel.formats.registry import FORMATS
from kurbel.formats.render import render

NAMES = [name for name, form in FORMATS.items() if form.kind == "page"]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "mine/base").mkdir(parents=True)
    return tmp_path / "mine"


@pytest.fixture
def little_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("kurbel.formats.apart.GIGABYTES", 0.7)


def made(folder: Path, template: str) -> str:
    (folder / "base/markdown.jinja").write_text(template, encoding="utf-8")
    return render(everything(), "markdown", templates=str(folder))


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("standalone", [False, True])
def test_our_own_templates_print_the_same_in_the_sandbox(name: str, standalone: bool, folder: Path) -> None:
    ours = render(everything(), name, standalone=standalone)
    assert render(everything(), name, standalone=standalone, templates=str(folder)) == ours


@pytest.mark.parametrize("name", ["latex", "markdown"])
def test_our_documents_are_the_same_in_the_sandbox(name: str, folder: Path) -> None:
    ours = document_files(document(), name, fragments(name))
    assert document_files(document(), name, fragments(name), str(folder)) == ours


def test_a_template_of_the_same_name_outdoes_ours(folder: Path) -> None:
    assert made(folder, "{{ page.caption }}, {{ page.key }}\n").endswith(", everything\n")
    (folder / "base/index.markdown.jinja").write_text("{{ title }}!\n", encoding="utf-8")
    pages = document_files(document(), "markdown", fragments("markdown"), str(folder))
    assert pages["markdown/index.md"] == "Tafeln des Kurbeltriebs!\n"
    assert pages["markdown/01-bewegung.md"].startswith('<a id="sec-bewegung">')


def test_a_template_of_a_layout_is_for_that_layout_only(folder: Path) -> None:
    (folder / "roetscher-112").mkdir()
    (folder / "roetscher-112/latex.jinja").write_text(
        "<< page.key >>: <% if 1 %>x<% endif %>", encoding="utf-8"
    )
    assert render(table("zusammenstellung"), "latex", templates=str(folder)) == "zusammenstellung: x"
    assert render(table("weg"), "latex", templates=str(folder)) == render(table("weg"), "latex")


def test_plain_text_has_a_template_if_the_user_gives_one(folder: Path) -> None:
    (folder / "base/text.jinja").write_text("{{ page.lang }}\n", encoding="utf-8")
    assert render(everything(), "text", templates=str(folder)) == "de\n"


def test_a_changed_template_is_read_again(folder: Path) -> None:
    assert made(folder, "one") == "one"
    assert made(folder, "three") == "three"
    os.unlink(folder / "base/markdown.jinja")
    assert render(everything(), "markdown", templates=str(folder)) == render(everything(), "markdown")


WITH_ADDRESS = "it prints an object with its place in memory, which is another one every time"


@pytest.mark.parametrize(
    ("template", "line", "reason"),
    [
        ("a\n{{ pge }}", 2, "'pge' is undefined"),
        ("a\nb\n{% for %}", 3, "Expected an expression, got 'end of statement block'"),
        ("{{ page.nothing }}", 1, "'kurbel.formats.page.Page object' has no attribute 'nothing'"),
        ("\n\n\n{{ 1 / 0 }}", 4, "division by zero"),
        ("{{ page.key | shout }}", 1, "No filter named 'shout'."),
        ("{% include 'base/markdown.jinja' %}", 1, "it calls itself without end"),
        ("{% macro m() %}{{ m() }}{% endmacro %}{{ m() }}", 1, "it calls itself without end"),
        ("{% include '../secret' %}", 1, "there is no template ../secret"),
        ("{% include '/etc/passwd' %}", 1, "there is no template /etc/passwd"),
        ("{{ page.__class__ }}", 1, "access to attribute '__class__' of 'Page' object is unsafe."),
        ("{{ page._replace(key='x') }}", 1, "access to attribute '_replace' of 'Page' object is unsafe."),
        (
            "{{ '{0.__class__}'.format(page) }}",
            1,
            "access to attribute '__class__' of 'Page' object is unsafe.",
        ),
        ("\n{{ page.words.keys }}", 2, WITH_ADDRESS),
        ("{{ 'words: ' ~ [page.words.keys] }}", 1, WITH_ADDRESS),
        ("{{ page.words.update(a=1) }}", 1, "access to attribute 'update' of 'dict' object is unsafe."),
    ],
)
def test_a_mistake_is_a_sentence_with_file_and_line(
    template: str, line: int, reason: str, folder: Path
) -> None:
    (folder / "secret").write_text("secret", encoding="utf-8")
    with pytest.raises(LayoutError) as caught:
        made(folder, template)
    assert (
        str(caught.value)
        == f"the template {folder}/base/markdown.jinja, line {line} cannot be used: {reason}"
    )


@pytest.mark.usefixtures("little_memory")
@pytest.mark.parametrize(
    "template",
    [
        "{{ 'a' * 10**10 }}",
        "{{ 'a'|center(10**10) }}",
        "{{ '{:{}}'.format(1, 10**10) }}",
        "{{ 'ab'|batch(10**10, 'x')|list }}",
        "{{ ('a' * 10**6)|replace('a', 'b' * 10**6) }}",
        "{% set n = namespace(x='ab') %}{% for i in range(60) %}{% set n.x = n.x ~ n.x %}{% endfor %}",
        "{% for i in range(9999) %}{{ 'a' * 10**6 }}{% endfor %}",
    ],
)
def test_what_needs_too_much_memory_is_a_mistake(template: str, folder: Path) -> None:
    with pytest.raises(LayoutError, match=r"markdown\.jinja(, line 1)? cannot be used: it needs more mem"):
        made(folder, template)


def test_a_page_has_an_end(folder: Path) -> None:
    assert len(made(folder, "{{ 'a' * 10**7 }}")) == 10**7
    with pytest.raises(
        LayoutError, match=r"markdown\.jinja cannot be used: .* more than 10000000 characters$"
    ):
        made(folder, "b{{ 'a' * 10**7 }}")


def test_no_file_outside_the_folder_is_read(folder: Path, tmp_path: Path) -> None:
    (tmp_path / "secret.jinja").write_text("secret", encoding="utf-8")
    (folder / "base/markdown.jinja").symlink_to(tmp_path / "secret.jinja")
    with pytest.raises(LayoutError, match=r"base/markdown.jinja is a link that leads out of .*mine$"):
        render(everything(), "markdown", templates=str(folder))
    os.unlink(folder / "base/markdown.jinja")
    os.rmdir(folder / "base")
    (folder / "base").symlink_to(tmp_path)
    (tmp_path / "markdown.jinja").write_text("secret", encoding="utf-8")
    with pytest.raises(LayoutError, match="is a link that leads out of"):
        render(everything(), "markdown", templates=str(folder))


def test_a_link_within_the_folder_is_followed(folder: Path) -> None:
    (folder / "common").write_text("common", encoding="utf-8")
    (folder / "base/markdown.jinja").symlink_to(folder / "common")
    assert render(everything(), "markdown", templates=str(folder)) == "common"


def test_what_is_no_text_is_refused(folder: Path) -> None:
    (folder / "base/markdown.jinja").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(
        LayoutError, match=r"^the template .*base/markdown.jinja cannot be used: 'utf-8' codec"
    ):
        render(everything(), "markdown", templates=str(folder))
    (folder / "base/markdown.jinja").write_text("x" * 2_000_000, encoding="utf-8")
    with pytest.raises(LayoutError, match=r"markdown\.jinja is longer than 1000000 characters$"):
        render(everything(), "markdown", templates=str(folder))
