"""Layouts of one's own: what they print, and a sentence with file and line for what cannot be used."""

from __future__ import annotations

import dataclasses
import json
import shlex
from pathlib import Path

import pytest
from cli import kurbel as kurbel_in
from cli import printed, refusal
from hypothesis import example, given, settings
from hypothesis import strategies as st

import kurbel
from kurbel.errors import KurbelError, LayoutError
from kurbel.page.layout_check import check
from kurbel.page.layouts import (
    KIND,
    LANGUAGES,
    LayoutFile,
    layout,
    layout_file,
    layout_names,
    template_folder,
)
from kurbel.page.subject import subject
from kurbel.page.subjects import SUBJECTS
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


def test_the_environment_names_the_folder(tmp_path: Path) -> None:
    folder = own(tmp_path)
    assert "mine  " in printed("layouts", KURBEL_LAYOUTS=folder).out
    page, same = (printed(one, "--layout", "mine", KURBEL_LAYOUTS=folder).out for one in ("table", "forces"))
    assert page == same


@pytest.mark.parametrize("name", layout_names())
def test_the_list_has_a_command_that_prints_the_layout(name: str) -> None:
    (line,) = (line for line in printed("layouts").out.splitlines() if line.split()[0] == name)
    command = shlex.split(line[line.index("  kurbel ") :])
    assert printed(*command[1:], "-f", "json").out


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
    check(file, layout(name))
    by_the_model = file.read(LayoutFile)
    assert [getattr(by_the_model, key) for key in FIELDS] == [getattr(layout(name), key) for key in FIELDS]


def test_a_template_beside_a_layout_sets_its_pages(tmp_path: Path) -> None:
    folder = own(tmp_path)
    (tmp_path / "pages" / "mine" / "html.jinja").write_text("<b>{{ page.caption }}</b>\n", encoding="utf-8")
    words = ("table", "--layouts", folder, "-f", "html")
    assert printed(*words, "--layout", "mine").out.startswith("<b>Schubstangenwinkel und Kolbenweg; ")
    assert printed(*words, "--layout", "kinematics").out == printed("table", "-f", "html").out
    (tmp_path / "pages" / "mine" / "html.jinja").write_text("{{ page.captoin }}\n", encoding="utf-8")
    assert "mine/html.jinja, line 1 cannot be used" in refusal(*words, "--layout", "mine", code=1)


WRONG = [
    ("caption =", "captoin =", 2, 'no key of a layout "captoin" (did you mean caption?); choose from title'),
    (
        'caption = "{quantities}; {method}"\n',
        "",
        1,
        'no caption; write caption = "{quantities}{for_ratio}; {',
    ),
    ('ratios = ["1:4", "1:5"]', 'ratios = "1:4"', 3, 'ratios is "1:4"; it must be a list of texts'),
    ('"1:4", "1:5"', '"1:4", 0.2', 3, "entry 2 of ratios is 0.2; it must be a text in quotation marks"),
    ('"1:4", "1:5"', '"1:4", "one"', 3, '"one"'),
    ('"1:4", "1:5"', "", 3, "ratios is empty; a page about motion needs them"),
    ('"1:4", "1:5"', '"1:4", "1:1"', 3, "crank ratio R:L is 1; it must be below 1"),
    ('"1:4", "1:5"', '"1:0.5"', 3, "crank ratio R:L is 2; it must be below 1"),
    ('"1:4", "1:5"', '"1:-5"', 3, "crank ratio R:L is -0.2; it must not be negative"),
    ("0..180:60", "1e400", 4, "an angle is beyond 1000000°; give it within one turn, 0..360"),
    ("0..180:60", "0..x", 4, 'angle "x" is not an angle'),
    ('down = ["angle"]', 'down = ["angel"]', 5, 'no axis of motion "angel" (did you mean angle?)'),
    (
        'down = ["angle"]',
        "down = []",
        5,
        "down and across must share out ratio, angle, column; angle is missing",
    ),
    ('down = ["angle"]', 'down = ["angle", "ratio"]', 5, "the axis ratio is there twice"),
    ('"column", "ratio"]', '"column"]', 5, "ratio is missing"),
    (
        'stub = ["angle"]',
        "stub = []",
        6,
        'stub must have the innermost of the axes that run down, as ["angle"]',
    ),
    ('stub = ["angle"]', 'stub = ["ratio"]', 6, "stub must have the innermost"),
    ('["Anmerkung"]', "[]", 8, "notes has more texts in one language than in the other"),
    ('["Anmerkung"]', "[1]", 8, "notes is a table; it must be lists of texts"),
    ('["Anmerkung"]', '["{x}"]', 8, "{x} is a place, and none is filled here; write words"),
    ("{ angle =", "{ ratio =", 9, 'no axis in the stub "ratio"'),
    ('quantity = "psi"', 'quantity = "psy"', 11, 'no quantity of motion "psy" (did you mean psi?)'),
    ('quantity = "psi"', "quantity = 3", 11, "quantity is 3; it must be a text in quotation marks"),
    ('quantity = "psi", ', "", 11, 'there is no quantity; write quantity = "x"'),
    ("spanners =", "spaners =", 11, 'no key of a column "spaners" (did you mean spanners?)'),
    ('["Winkel|Angle"]', '"Winkel|Angle"', 11, "; it must be a list of texts"),
    ('["Winkel|Angle"]', '["a|b|c"]', 11, 'it must be a text, "German|English" or { de = '),
    ('["$ψ$"]', '["$ψ"]', 11, "a formula needs a second $"),
    ('["$ψ$"]', '["ψ[^a]"]', 11, "the mark [^a] points to no note"),
    ('["$ψ$"]', '["{angle}"]', 11, 'no place "{angle}"; choose from {ratio}'),
    ("decimals = 1", "decimals = 51", 11, "decimals is 51; it must be a whole number from 0 to 50"),
    ("decimals = 1", "decimals = 1.0", 11, "decimals is 1.0; it must be a whole number"),
    ("decimals = 1", 'unless = "xs"', 11, 'no quantity of motion "xs" (did you mean x?)'),
    ('"series"', '"seris"', 12, 'no method of x "seris" (did you mean series?)'),
    ('"x_series"', '"psi"', 12, "the key psi is there twice"),
    ('"x_series"', '"phi"', 12, 'the key "phi" cannot be that of a column'),
    ('"x_series"', '"a b"', 12, 'the key "a b" cannot be that of a column'),
    ('heading = ["$x/R$"]', "heading = [], spanners = []", 12, "nothing else stands over the column"),
    ("{method}", "{methode}", 2, 'no place "{methode}" (did you mean {method}?)'),
    ("title =", 'block = "three"\ntitle =', 1, 'block is "three"; it must be a whole number from 0 to 500'),
    ("title =", "pairs = 1\ntitle =", 1, "pairs is 1; it must be true or false"),
    ("title =", "pairs = true\ntitle =", 1, "pairs is for angles that run across"),
    ("title =", "unit = true\ntitle =", 1, "unit is for quantities that run down"),
    ("title =", 'angle_symbol = "$"\ntitle =', 1, 'angle_symbol is "$"; it must be a letter'),
    ("title =", 'ratio_symbol = "rl"\ntitle =', 1, 'ratio_symbol is "rl"; it must be two letters, as R:L'),
    ("title =", 'subject = "motoin"\ntitle =', 1, 'no subject "motoin" (did you mean motion?)'),
    ('title = "Winkel|Angle"', 'title = { de = "Winkel" }', 1, "title is a table; it must be a text"),
    (
        "columns = [\n",
        "columns = [\n3,\n",
        11,
        'columns is 3; it must be a table, such as { quantity = "x" }',
    ),
]


@pytest.mark.parametrize(
    ("good", "wrong", "line", "said"), WRONG, ids=[f"{wrong} {said}" for _, wrong, _, said in WRONG]
)
def test_a_mistake_is_answered_with_file_line_and_reason(
    tmp_path: Path, good: str, wrong: str, line: int, said: str
) -> None:
    assert good in GOOD
    folder = own(tmp_path, GOOD.replace(good, wrong, 1))
    sentence = refusal("table", "--layouts", folder, "--layout", "mine", code=1)
    assert sentence.startswith(f"{folder}/mine/layout.toml, line {line}: ")
    assert said in sentence


def test_a_file_that_is_no_toml_is_answered_with_a_sentence(tmp_path: Path) -> None:
    folder = own(tmp_path, "title = \n")
    said = refusal("table", "--layouts", folder, "--layout", "mine", code=1)
    assert said.startswith(f"cannot read the layout {folder}/mine/layout.toml: ")
    assert "line 1" in said


def test_a_folder_that_cannot_be_used_is_answered_with_a_sentence(tmp_path: Path) -> None:
    nowhere = str(tmp_path / "nowhere")
    assert refusal("layouts", "--layouts", nowhere, code=1) == (
        f"cannot read the layouts {nowhere}: there is no such folder"
    )
    assert refusal("layouts", "--layouts", "", code=1) == (
        "the folder of layouts has no name; give one, such as pages"
    )
    assert refusal("layouts", "--layouts", str(tmp_path), code=1) == (
        f"{tmp_path} has no layouts: no folder in it has a layout.toml"
    )


@pytest.mark.parametrize(
    ("command", "own_layout", "key", "value", "said"),
    [
        ("delta", "weisbach-150", "expansions", "0.5", "expansion ratio ε is 0.5; it must be 1"),
        ("delta", "delta-tafel", "expansions", "1e9", "expansion ratio ε is 1000000000; at most"),
        (
            "deadcentres",
            "weisbach-149",
            "arms",
            "1",
            "beam arm a is 1 r; it must be longer than the crank radius r",
        ),
    ],
)
def test_values_that_no_engine_has_are_answered_with_file_and_line(
    tmp_path: Path, command: str, own_layout: str, key: str, value: str, said: str
) -> None:
    usual = Path(str(layout_file(template_folder(), own_layout))).read_text(encoding="utf-8")
    others = [line for line in usual.splitlines() if not line.startswith(f"{key} =")]
    folder = own(tmp_path, "\n".join((f'{key} = ["{value}"]', *others)))
    for words in ((command, "--layout", "mine"), ("layouts",)):
        sentence = refusal(*words, "--layouts", folder, code=1)
        assert sentence.startswith(f"{folder}/mine/layout.toml, line 1: {said}")


@pytest.mark.parametrize(
    ("column", "typed", "said"),
    [
        ('quantity = "x_mm"', (), "column x_mm is in mm and needs --stroke"),
        ('quantity = "x", unless = "x_mm"', ("--stroke=1m",), "column x gives way to x_mm"),
    ],
)
def test_a_layout_without_a_column_to_show_says_what_it_needs(
    tmp_path: Path, column: str, typed: tuple[str, ...], said: str
) -> None:
    folder = own(tmp_path, GOOD.partition("columns =")[0] + f"columns = [{{ {column} }}]\n")
    words = ("table", "--layouts", folder, "--layout", "mine")
    assert refusal(*words, *typed) == f"layout mine has no column to show: {said}"
    shown = () if typed else ("--stroke=1m",)
    assert printed(*words, *shown).out


def test_a_name_that_no_label_may_have_is_refused(tmp_path: Path) -> None:
    folder = own(tmp_path, name="my page")
    assert "use letters, digits and -" in refusal("layouts", "--layouts", folder, code=1)


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
        st.lists(inner, max_size=3) | st.dictionaries(st.sampled_from(("de", "en", "quantity")), inner)
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


@settings(max_examples=300, deadline=None)
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
    except LayoutError as error:
        assert "mine/layout.toml" in str(error)
        assert "line " in str(error)
    except KurbelError as error:
        # The command prints no pages about that.
        assert key == "subject", error


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
    text = "\n".join((*(f"{name} = {json.dumps(names)}" for name, names in shared.items()), *others))
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
    for name in ("text", "html", "latex"):
        assert kurbel_in(*words, "--layouts", folder, "--layout", "mine", "-f", name).code == 0
