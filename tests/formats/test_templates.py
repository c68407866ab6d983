"""A user's folder of templates: it outdoes ours, can do no harm, and its mistakes are named with line."""

from __future__ import annotations

import csv
import io
import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest
from cli import kurbel as typed
from cli import printed, refusal
from everything import everything
from golden import assert_golden
from hypothesis import given
from hypothesis import strategies as st
from jinja2 import meta
from manifests import built, chapter, keys_of, run
from manifests import made as files
from manifests import text as prose
from places import ROOT

import kurbel
from kurbel import KurbelError
from kurbel.formats.csv.writer import quoted
from kurbel.formats.registry import FORMATS, PageFormat, RecordsFormat, by_name
from kurbel.formats.render import environment_of, render
from kurbel.formats.templates import page_templates
from kurbel.page.layouts import template_folder
from kurbel.page.table import Value

NAMES = [name for name, form in FORMATS.items() if form.kind == "page"]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "mine/base").mkdir(parents=True)
    return tmp_path / "mine"


@pytest.fixture
def little_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("kurbel.formats.templates.GIGABYTES", 0.7)


def made(folder: Path, template: str) -> str:
    (folder / "base/markdown.jinja").write_text(template, encoding="utf-8")
    return render(everything(), "markdown", templates=str(folder))


def test_a_row_of_ones_own_stands_in_the_pieces_for_telephones_too(folder: Path) -> None:
    row = '{% block row %}<tr class="mine"><td>{{ row[0].text }}</td></tr>{% endblock %}'
    (folder / "base/html.jinja").write_text('{% extends "kurbel/base/html.jinja" %}' + row, encoding="utf-8")
    page = kurbel.forces("1:5", force="10kN", angle="0..90:30")
    made = [render(page, "html", templates=str(folder), standalone=alone) for alone in (False, True)]
    # The whole table, and two pieces of it where the page is ours.
    assert [one.count('"mine"') for one in made] == [4, 12]


@pytest.mark.parametrize("name", NAMES)
def test_our_own_templates_print_the_same_in_the_sandbox(name: str, folder: Path) -> None:
    for standalone in (False, True):
        ours = render(everything(), name, standalone=standalone)
        assert render(everything(), name, standalone=standalone, templates=str(folder)) == ours


BOOK = chapter("Wege, $x$", prose("Siehe [](#weg)."), run("weg", "table --ratio 1:5"), name="wege")


def test_our_own_templates_set_the_same_handbook_in_the_sandbox(folder: Path) -> None:
    (folder / "base/unused.css").touch()
    top = keys_of(title="Tafeln") + 'formats = ["latex", "markdown"]\n'
    built(folder.parent, top + BOOK)
    ours = files(folder.parent)
    built(folder.parent, keys_of(templates="mine") + top + BOOK)
    assert files(folder.parent) == ours


def test_a_template_of_the_same_name_outdoes_ours(folder: Path) -> None:
    assert made(folder, "{{ page.caption }}, {{ page.key }}\n").endswith(", everything\n")
    os.unlink(folder / "base/markdown.jinja")
    (folder / "base/index.markdown.jinja").write_text("{{ title }}!\n", encoding="utf-8")
    top = keys_of(title="Tafeln", templates="mine") + 'formats = ["markdown"]\n'
    pages = built(folder.parent, top + BOOK) / "markdown"
    assert (pages / "index.md").read_text(encoding="utf-8") == "Tafeln!\n"
    assert (pages / "01-wege.md").read_text(encoding="utf-8").startswith('<a id="sec-wege">')


def test_a_changed_template_is_read_again(folder: Path) -> None:
    assert made(folder, "one") == "one"
    assert made(folder, "three") == "three"
    os.unlink(folder / "base/markdown.jinja")
    assert render(everything(), "markdown", templates=str(folder)) == render(everything(), "markdown")


MISTAKES = (
    "a\n{{ pge }}",
    "a\nb\n{% for %}",
    "{{ page.nothing }}",
    "\n\n\n{{ 1 / 0 }}",
    "{{ page.key | shout }}",
    "{% include 'base/markdown.jinja' %}",
    "{% macro m() %}{{ m() }}{% endmacro %}{{ m() }}",
    "{% include '../secret' %}",
    "{% include 'base/nothing.jinja' %}",
    "{% include '/etc/passwd' %}",
    "{% include 'base/nothing.jinja' %}",
    "{{ page.__class__ }}",
    "{{ page._replace(key='x') }}",
    "{{ '{0.__class__}'.format(page) }}",
    "\n{{ page.words.keys }}",
    "{{ 'words: ' ~ [page.words.keys] }}",
    "{{ page.words.update(a=1) }}",
)


def test_mistakes_are_sentences_with_file_and_line(folder: Path) -> None:
    (folder / "secret").write_text("secret", encoding="utf-8")
    found = []
    for template in MISTAKES:
        with pytest.raises(KurbelError) as caught:
            made(folder, template)
        found.append(f"{template}\n    {str(caught.value).replace(str(folder), 'mine')}\n")
    assert_golden("mistakes-in-templates.txt", "\n".join(found))


@pytest.mark.usefixtures("little_memory")
@pytest.mark.parametrize(
    "template",
    [
        "{{ 'a' * 10**10 }}",
        "{{ '{:{}}'.format(1, 10**10) }}",
        "{{ ('a' * 10**6)|replace('a', 'b' * 10**6) }}",
        "{% for i in range(9999) %}{{ 'a' * 10**6 }}{% endfor %}",
    ],
)
def test_what_needs_too_much_memory_is_a_mistake(template: str, folder: Path) -> None:
    with pytest.raises(KurbelError, match=r"markdown\.jinja(, line 1)? cannot be used: it needs more mem"):
        made(folder, template)


def test_a_page_has_an_end(folder: Path) -> None:
    assert len(made(folder, "{{ 'a' * 10**7 }}")) == 10**7
    with pytest.raises(
        KurbelError, match=r"markdown\.jinja cannot be used: .* more than 10000000 characters$"
    ):
        made(folder, "b{{ 'a' * 10**7 }}")


def test_no_file_outside_the_folder_is_read(folder: Path, tmp_path: Path) -> None:
    (tmp_path / "secret.jinja").write_text("secret", encoding="utf-8")
    (folder / "base/markdown.jinja").symlink_to(tmp_path / "secret.jinja")
    with pytest.raises(KurbelError, match=r"base/markdown.jinja is a link that leads out of .*mine$"):
        render(everything(), "markdown", templates=str(folder))
    # One within the folder is followed.
    os.unlink(folder / "base/markdown.jinja")
    (folder / "common").write_text("common", encoding="utf-8")
    (folder / "base/markdown.jinja").symlink_to(folder / "common")
    assert render(everything(), "markdown", templates=str(folder)) == "common"
    os.unlink(folder / "base/markdown.jinja")
    os.rmdir(folder / "base")
    (tmp_path / "elsewhere").mkdir()
    (folder / "base").symlink_to(tmp_path / "elsewhere")
    (tmp_path / "elsewhere/markdown.jinja").write_text("secret", encoding="utf-8")
    with pytest.raises(KurbelError, match="is a link that leads out of"):
        render(everything(), "markdown", templates=str(folder))


def test_what_is_no_text_is_refused(folder: Path) -> None:
    (folder / "base/markdown.jinja").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(
        KurbelError, match=r"^the template .*base/markdown.jinja cannot be used: 'utf-8' codec"
    ):
        render(everything(), "markdown", templates=str(folder))
    (folder / "base/markdown.jinja").write_text("x" * 2_000_000, encoding="utf-8")
    with pytest.raises(KurbelError, match=r"markdown\.jinja is longer than 1000000 characters$"):
        render(everything(), "markdown", templates=str(folder))


# Typed


def write(folder: Path, **templates: str) -> Path:
    """Write templates; in their names __ stands for the slash, and all end with .jinja."""
    for name, text in templates.items():
        path = folder / f"{name.replace('__', '/').replace('_', '-')}.jinja"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return folder


SMALL = ("table", "--ratio", "1:5", "--angle", "0;90", "--columns", "x", "-f", "markdown")


@pytest.mark.parametrize(
    "command",
    [
        "table", "collate weisbach-149", "example blau 33", "construct blau-9 --table",
    ],
)  # fmt: skip
def test_every_command_that_prints_a_page_takes_templates(command: str, tmp_path: Path) -> None:
    folder = write(tmp_path / "mine", base__text="own: {{ page.key }}\n")
    assert typed(*command.split(), "--templates", str(folder)).out.startswith("own: ")


def test_templates_are_named_by_an_option_a_variable_python_and_a_manifest(tmp_path: Path) -> None:
    folder = write(tmp_path / "mine", base__markdown="own: {{ page.caption }}\n")
    own = "own: Kolbenweg für R:L = 1:5; genaue Formeln\n"
    assert printed(*SMALL, "--templates", str(folder)).out == own
    assert printed(*SMALL, KURBEL_TEMPLATES=str(folder)).out == own
    page = kurbel.table(ratio="1:5", angle="0;90", columns="x", templates=folder)
    assert kurbel.typeset(page, "markdown") == own
    (tmp_path / "handbook.toml").write_text(
        'title = "T"\nlang = "de"\ntemplates = "mine"\nformats = ["markdown", "csv"]\n'
        '[[chapter]]\ntitle = "C"\n[[chapter.part]]\nname = "p"\nrun = "table --ratio 1:5 --columns x"\n',
        encoding="utf-8",
    )
    write(folder, base__csv="own\n")
    assert typed("handbook", "build", str(tmp_path)).code == 0
    tables = tmp_path / "pages" / "tables"
    assert (tables / "p.md").read_text(encoding="utf-8") == own
    assert (tables / "p.csv").read_text(encoding="utf-8") == "own\n"


def test_a_document_names_templates_in_its_folder_and_a_part_of_a_handbook_none(tmp_path: Path) -> None:
    write(tmp_path / "mine", base__markdown="own: {{ page.caption }}\n")
    document, words = tmp_path / "notes.md", "table --ratio 1:5 --columns x --templates"
    document.write_text(f"<!-- kurbel: {words} mine -->\n<!-- /kurbel -->\n", encoding="utf-8")
    assert typed("inject", str(document)).code == 0
    assert "\nown: Kolbenweg" in document.read_text(encoding="utf-8")
    assert typed("inject", "--check", str(document)).code == 0
    write(tmp_path / "mine", base__markdown="other: {{ page.caption }}\n")
    assert typed("inject", "--check", str(document)).code == 1
    document.write_text(f"<!-- kurbel: {words} .. -->\n<!-- /kurbel -->\n", encoding="utf-8")
    assert "leads out of the folder of the document" in refusal("inject", str(document), code=1)
    (tmp_path / "handbook.toml").write_text(
        f'title = "T"\n[[chapter]]\ntitle = "C"\n[[chapter.part]]\nrun = "{words} mine"\n', encoding="utf-8"
    )
    result = typed("handbook", "build", str(tmp_path))
    assert result.code == 1
    assert "--templates is for single tables; a document sets it by itself" in result.err


def test_the_layouts_own_template_comes_first_then_the_base_and_templates_before_layouts(
    tmp_path: Path,
) -> None:
    layout = Path(template_folder()) / "kinematics" / "layout.toml"
    (tmp_path / "second" / "kinematics").mkdir(parents=True)
    (tmp_path / "first").mkdir()
    shutil.copy(layout, tmp_path / "second" / "kinematics")
    folders = ("--templates", str(tmp_path / "first"), "--layouts", str(tmp_path / "second"))
    # Each is taken before those that are there already.
    for place in ("second/base", "first/base", "second/kinematics", "first/kinematics"):
        write(tmp_path, **{f"{place.replace('/', '__')}__markdown": place})
        assert printed(*SMALL, *folders).out == place
    assert printed(*SMALL).out.startswith("**Kolbenweg")


def test_a_template_extends_one_of_ours_by_its_blocks(tmp_path: Path) -> None:
    usual = printed(*SMALL).out
    folder = write(
        tmp_path,
        base__markdown='{% extends "kurbel/base/markdown.jinja" %}'
        "{% block source %}The house\n{% endblock %}",
        kinematics__markdown='{% extends "base/markdown.jinja" %}{% block caption %}K\n\n{% endblock %}',
    )
    changed = printed(*SMALL, "--templates", str(folder)).out
    assert changed == re.sub(r"^\*\*.*\*\*$", "K", usual, count=1, flags=re.MULTILINE) + "The house\n"


@pytest.mark.parametrize("name", ["json", "ods"])
def test_a_format_without_templates_refuses_them_where_they_are_typed(name: str, tmp_path: Path) -> None:
    folder = str(write(tmp_path / "mine", base__csv="own"))
    words = ("table", "--ratio", "1:5", "-o", str(tmp_path / f"page.{name}"))
    assert refusal(*words, "--templates", folder) == (
        f"--templates sets no {name}, which has no template; leave it out; see kurbel table --help"
    )
    assert printed(*words, KURBEL_TEMPLATES=folder).out == ""
    assert (tmp_path / f"page.{name}").stat().st_size > 100


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("kinematics/markdwon.jinja", "is a template of nothing (did you mean markdown.jinja?); what others"),
        ("kinematics/handbook.html.jinja", "is a template of nothing"),
        ("kinmatics/text.jinja", "is of no layout (did you mean kinematics?); --layouts names the folder"),
    ],
)
def test_a_template_that_would_never_be_used_is_a_sentence(name: str, said: str, tmp_path: Path) -> None:
    write(tmp_path, **{name.removesuffix(".jinja").replace("/", "__"): ""})
    (tmp_path / name).parent.mkdir(exist_ok=True)
    (tmp_path / name).touch()
    for form in ("text", "csv"):
        sentence = refusal("table", "--templates", str(tmp_path), "-f", form, code=1)
        assert sentence.startswith(f"{tmp_path}/{name} {said}")
    assert refusal("table", "--templates", f"{tmp_path}/x", code=1) == (
        f"there is no folder {tmp_path}/x with templates"
    )


def test_a_template_may_be_for_a_layout_of_another_folder(tmp_path: Path) -> None:
    folder = write(tmp_path, slant__markdown="own")
    words = ("--templates", str(folder), "--layouts", str(ROOT / "examples" / "layouts"))
    assert printed(*SMALL, *words).out == printed(*SMALL).out
    assert printed(*SMALL[:-4], "-f", "markdown", "--layout", "slant", *words).out == "own"


# Copies

COPIED = {"roetscher-112": "table --layout roetscher-112", "balance": "balance --layout balance"}


@pytest.mark.parametrize("name", COPIED)
def test_a_copy_prints_the_same_page_in_every_format_until_it_is_changed(name: str, tmp_path: Path) -> None:
    folder = str(tmp_path / "mine")
    assert typed("layouts", "--copy", name, folder).err == (
        f"kurbel: {folder}/{name} is a copy; --layouts {shlex.quote(folder)} takes it in place of kurbel's\n"
    )
    words, copy = COPIED[name].split(), ("--layouts", folder)
    assert {path.name for path in (tmp_path / "mine" / name).iterdir()} == {"layout.toml", *page_templates()}
    for form in (*NAMES, "csv", "json"):
        for more in ((), ("--standalone",)) if "standalone" in FORMATS[form].takes else ((),):
            typing = (*words, "-f", form, *more)
            assert typed(*typing, *copy).out == typed(*typing).out
    for form in (*NAMES, "csv"):
        path = tmp_path / "mine" / name / f"{form}.jinja"
        path.write_text(path.read_text(encoding="utf-8") + "changed\n", encoding="utf-8")
        assert typed(*words, "-f", form, *copy).out == typed(*words, "-f", form).out + "changed\n"


@pytest.mark.parametrize("closed", [False, True])
def test_templates_are_kept_compiled_where_python_keeps_modules(closed: bool, tmp_path: Path) -> None:
    prefix, words = tmp_path / "kept", [sys.executable, "-m", "kurbel", *SMALL]
    if closed:
        prefix.touch()
    known = {**os.environ, "PYTHONPYCACHEPREFIX": str(prefix)}
    for forbidden, kept in (("1", 0), ("", 1 - closed), ("", 1 - closed)):
        environment = {**known, "PYTHONDONTWRITEBYTECODE": forbidden}
        said = subprocess.run(words, env=environment, capture_output=True, check=True, encoding="utf-8")
        assert (said.stdout, said.stderr) == (printed(*SMALL).out, "")
        found = [*prefix.rglob("*.cache")]
        assert len(found) == kept
        # Cut off, it is compiled anew.
        for one in found:
            os.truncate(one, one.stat().st_size // 2)


def test_a_copy_changes_no_folder_that_is_there(tmp_path: Path) -> None:
    there = tmp_path / "kinematics"
    there.mkdir()
    assert refusal("layouts", "--copy", "kinematics", str(tmp_path), code=1) == (
        f"{there} is there already; name another folder, or remove it"
    )
    assert [*tmp_path.rglob("*")] == [there]
    assert "(did you mean kinematics?)" in refusal("layouts", "--copy", "kinematic", str(tmp_path))


# CSV

# Angles of two ratios and four columns that a page of 20,000 cells holds; with one more they come by columns.
MOST = 2500


@pytest.mark.parametrize("more", [("--decimal", "comma"), ("--excel", "--lang", "en")])
def test_a_long_table_streams_past_the_template_with_the_same_bytes(
    more: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    fields: list[str] = []

    def counted(text: str, separator: str, row: Sequence[Value]) -> str:
        fields.append(text)
        return quoted(text, separator, row)

    monkeypatch.setattr("kurbel.formats.csv.writer.quoted", counted)
    environment_of.cache_clear()
    words = ("table", "--ratio", "2:9;1:4", "--columns", "x,c,p,psi", "-f", "csv", *more)
    try:
        short, long = (
            printed(*words, "--angle", f"-37..{-37 + 0.125 * (count - 1)}:0.125").out.splitlines(True)
            for count in (MOST, MOST + 1)
        )
    finally:
        environment_of.cache_clear()
    assert long[: MOST + 1] + long[MOST + 2 : -1] == short
    # Only the short one is set by the template.
    assert len(fields) == 2 * MOST * 6


def test_a_template_of_ones_own_sets_long_tables_up_to_a_bound(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = write(tmp_path, base__csv="{{ rows|length }} rows, {{ fields|length }} fields\n")
    words = ("table", "--ratio", "1:5", "--columns", "x", "-f", "csv", "--templates", str(folder))
    assert printed(*words, "--angle", "0..210:0.01").out == "21001 rows, 2 fields\n"
    assert refusal(*words, "--angle", "0..360:0.0036", code=1).startswith(
        "a table of more than 100000 rows streams past templates, and base/csv.jinja would be ignored"
    )


@given(row=st.lists(st.text(st.sampled_from("a\",;\r\n \t'|é")), min_size=1), separator=st.sampled_from(",;"))
def test_fields_are_quoted_as_the_csv_module_does(row: list[str], separator: str) -> None:
    expected = io.StringIO(newline="")
    csv.writer(expected, delimiter=separator, lineterminator="\r\n").writerow(row)
    assert separator.join(quoted(text, separator, row) for text in row) + "\r\n" == expected.getvalue()


# What there is to read

BASE = Path(template_folder()) / "base"


@pytest.mark.parametrize("path", sorted(BASE.glob("*.jinja")), ids=lambda path: path.name)
def test_the_comment_at_the_top_names_all_that_a_template_is_given(path: Path) -> None:
    form = by_name(next(part for part in path.name.split(".") if part in FORMATS))
    assert isinstance(form, PageFormat | RecordsFormat)
    text = path.read_text(encoding="utf-8")
    comment = re.match(r"[{<]#\n(.*?)-?#[}>]\n", text, re.DOTALL)
    assert comment
    # A block also reads what the loops around it have.
    if "% block" not in text:
        for name in meta.find_undeclared_variables(environment_of(form, ()).parse(text)):
            assert f"`{name}`" in comment[1]


def test_the_howto_names_every_block_filter_and_template() -> None:
    text = (ROOT / "docs" / "howto" / "templates.md").read_text(encoding="utf-8")
    blocks = text.partition("### Blocks")[2].partition("### Values")[0]
    filters = text.partition("### Filters")[2]
    for name, form in FORMATS.items():
        if not isinstance(form, PageFormat | RecordsFormat) or not (BASE / f"{name}.jinja").exists():
            continue
        source = (BASE / f"{name}.jinja").read_text(encoding="utf-8")
        for block in re.findall(r"[%] block (\w+)", source):
            assert f"`{block}`" in blocks, (name, block)
        for one in form.writer.filters():
            assert re.search(rf"^\| `{one}\b.*\| `{name}` \|", filters, re.MULTILINE), (name, one)
    for template in BASE.glob("*.jinja"):
        whole, form_name = template.name.removesuffix(".jinja"), template.name.split(".")[0]
        assert f"`{whole}`" in text or form_name in ("film", "lesson", "typst"), whole
