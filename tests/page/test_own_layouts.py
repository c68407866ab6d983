"""Layouts of one's own: what they print, and a sentence with file and line for what cannot be used."""

from __future__ import annotations

import dataclasses
import json
import shlex
import shutil
from pathlib import Path

import pytest
from cli import kurbel as kurbel_in
from cli import printed, refusal
from golden import assert_golden
from hypothesis import example, given, settings
from hypothesis import strategies as st
from places import GOLDEN

import kurbel
from kurbel import KurbelError
from kurbel.page.layout_check import check
from kurbel.page.layouts import (
    KIND,
    LANGUAGES,
    SUBJECTS,
    LayoutFile,
    layout,
    layout_file,
    layout_names,
    placed,
    template_folder,
)
from kurbel.page.subject import subject
from kurbel.reading.toml_file import TomlFile

FIELDS = [field.name for field in dataclasses.fields(LayoutFile)]
GOOD = """\
title = "Winkel|Angle"
caption = "{quantities}; {method}"
ratios = ["1:4", "1:5"]
angles = ["0..180:60"]
down = ["angle"]
stub = ["angle"]
across = ["column", "ratio"]
notes = { de = ["Anmerkung"], en = ["Note"] }
stub_headings = { angle = "$φ$" }
columns = [
    { quantity = "psi", spanners = ["Winkel|Angle"], heading = ["$ψ$"], decimals = 1 },
    { quantity = "x", method = "series", key = "x_series", heading = ["$x/R$"] },
]
"""


def own(folder: Path, text: str = GOOD, name: str = "mine") -> str:
    path = folder / "pages" / name / "layout.toml"
    path.parent.mkdir(parents=True)
    path.write_text(text, encoding="utf-8")
    return str(folder / "pages")


def test_a_page_is_printed_in_a_layout_of_ones_own(tmp_path: Path) -> None:
    folder = own(tmp_path)
    (record, *_) = printed("table", "--layouts", folder, "--layout", "mine", "-f", "csv").records()
    assert record == {"ratio": "1:4", "phi": "0", "psi": "0.0", "x_series": "0.0000"}
    page = printed("table", "--layouts", folder, "--layout", "mine", "--lang", "en").out
    # The caption may end a line between the words.
    assert " ".join(page.split()).startswith("Rod angle and piston path; exact formulas and first-order")
    assert str(kurbel.table(layout="mine", layouts=folder, lang="en")) == page
    assert repr(kurbel.table(layout="mine", layouts=Path(folder))).startswith("<kurbel.Table mine: ")


def test_spanners_are_said_once_for_the_columns_below_them(tmp_path: Path) -> None:
    heads = ("$ψ$", "$x$", "$c$")
    first, second, third = (
        f'quantity = "{name}", heading = ["{head}"]'
        for name, head in zip(("psi", "x", "c"), heads, strict=True)
    )
    grouped = f"""columns = [
    {{ spanners = ["Hingang|Outstroke"], columns = [
        {{ {first} }},
        {{ spanners = ["Kolben|Piston"], columns = [
            {{ {second} }},
            {{ {third}, spanners = ["Fahrt|Speed"] }},
        ] }},
    ] }},
]
"""
    one_by_one = f"""columns = [
    {{ {first}, spanners = ["Hingang|Outstroke"] }},
    {{ {second}, spanners = ["Hingang|Outstroke", "Kolben|Piston"] }},
    {{ {third}, spanners = ["Hingang|Outstroke", "Kolben|Piston", "Fahrt|Speed"] }},
]
"""
    pages = [
        printed(
            "table",
            "--layouts",
            own(tmp_path / name, GOOD.partition("columns =")[0] + text),
            "--layout",
            "mine",
        )
        for name, text in (("grouped", grouped), ("one", one_by_one))
    ]
    assert pages[0].out == pages[1].out
    assert "Kolben" in pages[0].out and "Fahrt" in pages[0].out


@pytest.mark.parametrize("name", layout_names()[::3])
def test_the_list_has_a_command_that_prints_the_layout_by_another_name_too(name: str, tmp_path: Path) -> None:
    (line,) = (line for line in printed("layouts").out.splitlines() if line.split()[0] == name)
    command = [*shlex.split(line[line.index("  kurbel ") :])[1:], "--label=a", f"--layouts={tmp_path}"]
    shutil.copytree(Path(template_folder()) / name, tmp_path / "mine")
    usual, place = printed(*command).out, command.index("--layout") + 1
    assert usual == printed(*command[:place], "mine", *command[place + 1 :]).out


def test_a_layout_of_ones_own_says_what_its_page_is_about(tmp_path: Path) -> None:
    shutil.copytree(Path(template_folder()) / "torques", tmp_path / "mine")
    assert "no torque was given" in refusal("turning", "--layout=mine", f"--layouts={tmp_path}")


def test_the_command_of_a_layout_of_ones_own_names_its_folder(tmp_path: Path) -> None:
    folder = own(tmp_path)
    (line,) = (one for one in printed("layouts", "--layouts", folder).out.splitlines() if "mine" in one)
    assert line.endswith(f"kurbel table --layouts {folder} --layout mine")


def test_a_layout_with_the_name_of_one_of_kurbels_takes_its_place_where_its_folder_is_named(
    tmp_path: Path,
) -> None:
    words = ("table", "--angle", "0", "-f", "csv")
    usual, folder = printed(*words).out, own(tmp_path, name="kinematics")
    (first, *_) = printed(*words, "--layouts", folder).records()
    assert [*first] == ["ratio", "phi", "psi", "x_series"]
    assert printed(*words, KURBEL_LAYOUTS=folder).records()[0] == first
    assert printed(*words).out == usual


@pytest.mark.parametrize("name", layout_names())
def test_kurbels_own_layouts_could_be_a_users(name: str) -> None:
    file = TomlFile(layout_file(template_folder(), name), KIND)
    by_the_model = file.read(LayoutFile)
    columns = dict(placed(by_the_model.columns))
    check(file, layout(name), columns)
    assert layout(name).columns == tuple(columns.values())
    for key in {*FIELDS} - {"columns"}:
        assert getattr(by_the_model, key) == getattr(layout(name), key), key


def test_a_template_beside_a_layout_sets_its_pages(tmp_path: Path) -> None:
    folder = own(tmp_path)
    (tmp_path / "pages" / "mine" / "html.jinja").write_text("<b>{{ page.caption }}</b>\n", encoding="utf-8")
    words = ("table", "--layouts", folder, "-f", "html")
    assert printed(*words, "--layout", "mine").out.startswith("<b>Schubstangenwinkel und Kolbenweg; ")
    assert printed(*words, "--layout", "kinematics").out == printed("table", "-f", "html").out
    (tmp_path / "pages" / "mine" / "html.jinja").write_text("{{ page.captoin }}\n", encoding="utf-8")
    assert "mine/html.jinja, line 1 cannot be used" in refusal(*words, "--layout", "mine", code=1)


def test_a_mistake_is_answered_with_file_line_and_reason(tmp_path: Path) -> None:
    """Each block of the file replaces a piece of GOOD by another; ¶ ends a line."""
    found = []
    for place, block in enumerate((GOLDEN / "mistakes-in-layouts.txt").read_text("utf-8").split("\n\n")):
        taken, put = block.splitlines()[:2]
        old, new = (line[2:].replace("¶", "\n") for line in (taken, put))
        assert old in GOOD
        folder = own(tmp_path / str(place), GOOD.replace(old, new, 1))
        sentence = refusal("table", "--layouts", folder, "--layout", "mine", code=1)
        found.append(f"{taken}\n{put}\n{sentence.removeprefix(f'{folder}/')}")
    assert_golden("mistakes-in-layouts.txt", "\n\n".join(found) + "\n")


def test_a_layout_is_offered_to_commands_of_its_subject(tmp_path: Path) -> None:
    words = ("--layouts", own(tmp_path), "--layout")
    assert "mine" in refusal("table", *words, "mien")
    assert "mine" not in refusal("delta", *words, "mien").split("choose from")[1]
    assert "layout mine is about something else" in refusal("delta", *words, "mine")


def test_the_schema_knows_every_key_and_subject() -> None:
    path = Path(kurbel.__file__).parent / "page" / "layout.schema.json"
    properties = json.loads(path.read_text(encoding="utf-8"))["properties"]
    assert {*FIELDS} == {*properties}
    assert {*properties["subject"]["enum"]} == {*SUBJECTS}


# What goes with an arrangement.
ARRANGED = ("unit", "pairs", "stub_headings")
# What a user may write for any key.
VALUES = st.recursive(
    st.none()
    | st.booleans()
    | st.integers(-3, 10**6)
    | st.floats(allow_nan=False, allow_infinity=False)
    | st.sampled_from(
        ("", "x", "1:5", "0..180:30", "angle", "column", "ratio", "{ratio}", "$x$", "$", "a|b", "[^a]")
    )
    | st.text(max_size=6),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(st.sampled_from(("de", "en", "quantity", "columns", "spanners")), inner)
    ),
    max_leaves=6,
)


def toml(value: object) -> str:
    match value:
        case dict():
            return (
                "{" + ", ".join(f"{key} = {toml(one)}" for key, one in value.items() if one is not None) + "}"
            )
        case list():
            return "[" + ", ".join(toml(one) for one in value if one is not None) + "]"
    return json.dumps(value)


@settings(max_examples=100, deadline=None)
@given(key=st.sampled_from(FIELDS), value=VALUES.filter(lambda value: value is not None))
@example(key="angle_symbol", value="²")
@example(key="angle_symbol", value="µ")
@example(key="ratio_symbol", value="R:²")
def test_no_value_of_a_key_ends_in_anything_but_a_page_or_a_sentence(
    tmp_path_factory: pytest.TempPathFactory, key: str, value: object
) -> None:
    lines = [line for line in GOOD.partition("columns =")[0].splitlines() if not line.startswith(f"{key} =")]
    columns = "" if key == "columns" else "columns" + GOOD.partition("columns")[2]
    folder = own(tmp_path_factory.mktemp("fuzz"), "\n".join((f"{key} = {toml(value)}", *lines, columns)))
    try:
        for lang in LANGUAGES:
            page = kurbel.table(layout="mine", layouts=folder, lang=lang, angle="0;30")
            for name in ("text", "html", "latex", "csv"):
                assert kurbel.typeset(page, name)
    except KurbelError as error:
        # Of some subjects the command prints no pages.
        assert key == "subject" or ("mine/layout.toml" in str(error) and "line " in str(error)), error


@pytest.mark.slow
@settings(max_examples=60, deadline=None)
@given(data=st.data(), key=st.sampled_from([*SUBJECTS]))
def test_every_way_to_share_out_the_axes_makes_a_page(
    tmp_path_factory: pytest.TempPathFactory, data: st.DataObject, key: str
) -> None:
    about = subject(key)
    usual = Path(str(layout_file(template_folder(), about.layout))).read_text(encoding="utf-8")
    axes = data.draw(st.permutations([*about.axes]))
    end = data.draw(st.integers(1, len(axes) - 1))
    first = data.draw(st.integers(0, end - 1))
    shared = {"down": axes[:end], "stub": axes[first:end], "across": axes[end:]}
    others = [line for line in usual.splitlines() if line.split(" =")[0] not in (*shared, *ARRANGED)]
    noted = () if "\nnotes." in usual else ('notes = { de = ["Anmerkung"], en = ["Note"] }',)
    text = "\n".join((*(f"{name} = {json.dumps(names)}" for name, names in shared.items()), *noted, *others))
    folder = own(tmp_path_factory.mktemp("axes"), text)
    words = SUBJECTS[key].sample.replace(f" --layout {about.layout}", "").split()
    if about.whole and axes[end:] != ["column"]:
        said = refusal(*words, "--layouts", folder, "--layout", "mine", code=1)
        assert f'line 3: across must be ["column"]; the other axes of {key} belong together' in said
        return
    page, own_page = (
        printed(*words, "-f", "json", *layout).out
        for layout in (("--layouts", folder, "--layout", "mine"), ("--layout", about.layout))
    )
    assert json.loads(page)["rows"] == json.loads(own_page)["rows"]
    assert not noted or "Anmerkung" in [one["text"] for one in json.loads(page)["notes"]]
    for name in ("text", "html", "latex"):
        assert kurbel_in(*words, "--layouts", folder, "--layout", "mine", "-f", name).code == 0
