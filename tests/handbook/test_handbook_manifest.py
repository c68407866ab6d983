"""The manifest of a handbook: what it says, and a sentence with file, line and nearest name for all else."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

import kurbel
from kurbel.errors import HandbookError, KurbelError
from kurbel.handbook.manifest import Manifest, read_manifest
from kurbel.handbook.model import LONGEST_NAME, SCHEMA, SECTIONS, slug
from kurbel.reading.toml_file import key_lines

GOOD = """\
title = "Tafeln $x/R$"
lang = "de"
formats = ["html", "csv"]
machine = "engine.toml"

[defaults]
ratio = "1:5"
digits = 4

[[chapter]]
title = "Größe"

[[chapter.part]]
text = '''
[defaults]
titel = "no key, for it lies inside of a text"
'''

[[chapter.part]]
run = "kurbel table --step 15"
caption = "Wege $x$"

[[chapter]]
title = "Engine"
lang = "en"
[chapter.defaults]
digits = 3

[[chapter.part]]
run = "delta --eps '2;3'"
name = "delta"
lang = "de"
"""


def manifest(folder: Path, text: str) -> Manifest:
    path = folder / "handbook.toml"
    path.write_text(text, encoding="utf-8")
    return read_manifest(str(path))


def test_a_part_inherits_what_the_handbook_and_its_chapter_say(tmp_path: Path) -> None:
    first, second = manifest(tmp_path, GOOD).chapters
    assert (first.name, second.name) == ("groesse", "engine")
    text, table = first.parts
    assert text.text.startswith("[defaults]\n")
    assert text.options["lang"] == first.lang == "de"
    assert second.lang == "en"
    assert table.words == ("table", "--step", "15")
    assert table.name == "table-step-15"
    assert table.options == {"lang": "de", "ratio": "1:5", "digits": 4}
    assert table.line == 20
    (delta,) = second.parts
    assert delta.words == ("delta", "--eps", "2;3")
    assert delta.options == {"lang": "de", "ratio": "1:5", "digits": 3}


WRONG = [
    (
        "[defaults]",
        '[pdf]\nengine = "latexmk"\nstandards = ["ua-1"]\n[defaults]',
        7,
        "latexmk keeps no standards",
    ),
    ("[defaults]", 'templates = "mine"\n[pdf]\nengine = "lualatex"\n[defaults]', 8, "lualatex runs whatever"),
    ("title =", "titel =", 1, "(did you mean title?)"),
    ('formats = ["html", "csv"]', 'formats = ["html", "cvs"]', 3, 'no format "cvs" (did you mean csv?)'),
    ('formats = ["html", "csv"]', 'formats = "html"', 3, "must be a list of texts"),
    ("digits = 4", "digts = 4", 8, "(did you mean digits?)"),
    ("digits = 4", "digits = []", 8, "digits is an empty list"),
    ("digits = 4", "digits = {a = 1}", 8, "digits is a table"),
    ("digits = 3", "dig = 3", 27, "(did you mean digits?)"),
    ('lang = "en"', 'lang = "eng"', 25, "(did you mean en?)"),
    ('lang = "en"', "lang = 3", 25, "lang is 3; it must be a text in quotation marks"),
    ('name = "delta"', 'nam = "delta"', 31, "(did you mean name?)"),
    ('name = "delta"', 'name = "a/b"', 31, '"a/b" cannot be that of a file'),
    ('name = "delta"', 'name = ".."', 31, "cannot be that of a file"),
    ('name = "delta"', 'name = "Aux"', 31, "cannot be that of a file"),
    ('name = "delta"', 'name = "Table-step-15"', 31, "is taken in line 19"),
    ('title = "Engine"', 'title = "Engine"\nname = "groesse"', 25, "is taken in line 10"),
    ('caption = "Wege $x$"', 'caption = "Wege $x"', 21, "a formula needs a second $"),
    ('caption = "Wege $x$"', 'caption = "Wege[^a]"', 21, "the mark [^a], for which there is no note"),
    ("run = \"delta --eps '2;3'\"", 'run = "delta --eps \'2;3"', 30, "a quotation mark without its partner"),
    ("run = \"delta --eps '2;3'\"", 'run = "kurbel"', 30, "run is empty"),
    ("run = \"delta --eps '2;3'\"", "run = 5", 30, "run is 5"),
    ("run = \"delta --eps '2;3'\"", 'text = ""\nrun = "x"', 29, "this one has run and text"),
    ("run = \"delta --eps '2;3'\"", "", 29, "this one has none of them"),
    ("run = \"delta --eps '2;3'\"", 'text = "x"', 31, "name is for tables and figures"),
    ('machine = "engine.toml"', 'machine = "../engine.toml"', 4, "without .. and without a root"),
    ('machine = "engine.toml"', 'machine = "/engine.toml"', 4, "without .. and without a root"),
    ('machine = "engine.toml"', 'templates = "C:\\\\x"', 4, "without .. and without a root"),
    ('machine = "engine.toml"', 'output = "a/../../b"', 4, "without .. and without a root"),
    ('machine = "engine.toml"', 'output = "."', 4, "output is the manifest's own folder"),
    ('machine = "engine.toml"', "[pdf]\nengin = 3", 5, 'key of [pdf] "engin" (did you mean engine?)'),
    ('machine = "engine.toml"', '[pdf]\nengine = "word"', 5, 'no engine "word"'),
    ('machine = "engine.toml"', '[pdf]\nstandards = ["a-9"]', 5, 'no standard "a-9"'),
    ('[[chapter]]\ntitle = "Engine"', '[[chaptr]]\ntitle = "Engine"', 23, "(did you mean chapter?)"),
    ('title = "Engine"', "", 23, "a chapter has no title"),
    ('title = "Tafeln $x/R$"', 'title = " "', 1, "the handbook has no title"),
    ('[defaults]\nratio = "1:5"\ndigits = 4', "defaults = 3", 6, "defaults is 3; write [defaults]"),
]


@pytest.mark.parametrize(("good", "wrong", "line", "said"), WRONG, ids=[wrong[1] for wrong in WRONG])
def test_a_mistake_is_answered_with_file_line_and_reason(
    tmp_path: Path, good: str, wrong: str, line: int, said: str
) -> None:
    assert good in GOOD
    with pytest.raises(HandbookError) as caught:
        manifest(tmp_path, GOOD.replace(good, wrong, 1))
    sentence = str(caught.value)
    assert sentence.startswith(f"{tmp_path}/handbook.toml, line {line}: ")
    assert said in sentence
    assert "\n" not in sentence


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "the handbook has no title"),
        (b'title = "x"', "the handbook has no chapter; write [[chapter]]"),
        (b"\xff", "line 1: the byte 0xff is not UTF-8"),
        (b"\x00\x01", "cannot read the handbook"),
        (b"a = 1\na = 2", "cannot read the handbook"),
        (b"# " + b"x" * 2_000_000, "more than 2000000 bytes"),
        (b"x = " + b"[" * 5000, "nested too deeply"),
        (b".".join([b"a"] * 100_000) + b" = 1", "a key of very many parts"),
        (b'title = "x"\nchapter = 3', "chapter is 3; write [[chapter]]"),
        (b'title = "x"\n[[chapter]]\ntitle = "a"\npart = 3', "line 4: part is 3; write [[chapter.part]]"),
        (b'title = "x"\nchapter = [3]', "chapter is 3; it must be a section"),
        (b'title = "x"\n[chapter]\ntitle = "y"', "chapter is a table; write [[chapter]]"),
    ],
)
def test_a_file_that_is_no_manifest_is_answered_with_a_sentence(
    tmp_path: Path, content: bytes, said: str
) -> None:
    path = tmp_path / "handbook.toml"
    path.write_bytes(content)
    with pytest.raises(HandbookError) as caught:
        read_manifest(str(path))
    assert said in str(caught.value)
    assert str(path) in str(caught.value)


def test_a_missing_manifest_or_a_folder_is_answered_with_a_sentence(tmp_path: Path) -> None:
    for path, said in ((tmp_path / "x.toml", "kurbel handbook init writes"), (tmp_path, "it is a directory")):
        with pytest.raises(HandbookError, match=said):
            read_manifest(str(path))


def test_the_schema_knows_every_key() -> None:
    def keys(part: dict[str, object]) -> set[str]:
        own = part.get("properties", {})
        assert isinstance(own, dict)
        below = [one.get("items", one) for name, one in own.items() if name != "defaults"]
        return set(own) | {key for one in below for key in keys(one)}

    path = Path(kurbel.__file__).parent / "handbook" / SCHEMA
    assert keys(json.loads(path.read_text(encoding="utf-8"))) == {
        key for own in SECTIONS.values() for key in own.__struct_fields__
    }


@given(st.text(max_size=200))
def test_every_text_has_a_name_that_files_may_have(text: str) -> None:
    name = slug(text)
    assert 0 < len(name) <= LONGEST_NAME
    assert all(one.isascii() and (one.isalnum() or one == "-") for one in name)
    assert not name.startswith("-")


def test_names_of_long_texts_differ() -> None:
    words = "table --ratio " + ";".join(f"1:{n}" for n in range(3, 40))
    assert slug(words) != slug(words + ";1:40")


def test_the_lines_of_keys_count_sections_and_leave_out_texts() -> None:
    text = 'a = """\nb = 1\n"""\n[[c]]\nd.e = 2\n[[c.f]]\ng = 1\n[[c]]\n[[c.f]]\n[[c.f]]\n"h i" = 3\n'
    assert key_lines(text) == {
        ("a",): 1,
        ("c", 0): 4,
        ("c", 0, "d", "e"): 5,
        ("c", 0, "f", 0): 6,
        ("c", 0, "f", 0, "g"): 7,
        ("c", 1): 8,
        ("c", 1, "f", 0): 9,
        ("c", 1, "f", 1): 10,
        ("c", 1, "f", 1, "h i"): 11,
    }


@given(st.binary(max_size=300) | st.text(max_size=300).map(str.encode))
def test_no_content_ends_in_anything_but_a_sentence(
    tmp_path_factory: pytest.TempPathFactory, content: bytes
) -> None:
    path = tmp_path_factory.mktemp("manifest") / "handbook.toml"
    path.write_bytes(content)
    with pytest.raises(KurbelError):
        read_manifest(str(path))
