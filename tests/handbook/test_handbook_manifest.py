"""The manifest of a handbook: what it says, and a sentence with file, line and nearest name for all else."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from cli import refusal
from hypothesis import given, settings
from hypothesis import strategies as st
from manifests import built, chapter, handbook, keys_of, write

import kurbel
from kurbel.reading.toml_file import key_lines

SCHEMA = Path(kurbel.__file__).parent / "handbook" / "handbook.schema.json"
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


def listed(folder: Path, text: str) -> str:
    return handbook("list", write(folder, text)).out


def test_a_part_inherits_what_the_handbook_and_its_chapter_say(tmp_path: Path) -> None:
    """The text has lines that look like keys; the machine is none of what a part says of itself."""
    (tmp_path / "engine.toml").write_text('[crank]\nratio = "1:4"\n')
    pages = built(tmp_path, GOOD)
    assert [path.name for path in sorted((pages / "tables").iterdir()) if path.suffix == ".csv"] == [
        "delta.csv",
        "table-step-15.csv",
    ]
    assert ",0.0408," in (pages / "tables/table-step-15.csv").read_text()
    assert ",1.282" in (pages / "tables/delta.csv").read_text()
    page = (pages / "handbook.html").read_text()
    assert "titel =" in page
    assert 'id="sec-groesse"' in page and 'id="sec-engine"' in page


def refused(folder: Path, content: bytes) -> str:
    """Return what is said of a manifest, of which nothing is built."""
    (folder / "handbook.toml").write_bytes(content)
    done = handbook("build", folder)
    assert (done.code, done.out) == (1, "")
    assert not (folder / "pages").exists()
    return done.err.removesuffix("\n").removeprefix("kurbel: ")


@pytest.mark.parametrize(
    "wrong", ['machine = "../e.toml"', 'machine = "/e.toml"', 'templates = "C:\\\\x"', 'output = "a/../../b"']
)
def test_a_path_that_leads_out_of_the_folder_is_refused(tmp_path: Path, wrong: str) -> None:
    sentence = refused(tmp_path, GOOD.replace('machine = "engine.toml"', wrong).encode())
    assert sentence.startswith(f"{tmp_path}/handbook.toml, line 4: ")
    assert "without .. and without a root" in sentence


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
    sentence = refused(tmp_path, content)
    assert said in sentence
    assert f"{tmp_path}/handbook.toml" in sentence


def test_a_missing_manifest_is_answered_with_a_sentence(tmp_path: Path) -> None:
    said = refusal("handbook", "list", str(tmp_path / "x.toml"), code=1)
    assert said == f"{tmp_path} has no x.toml; kurbel handbook init {tmp_path} writes a first one"


def test_the_schema_knows_every_key(tmp_path: Path) -> None:
    """Who writes a wrong one is told of all that there are."""
    whole = json.loads(SCHEMA.read_text(encoding="utf-8"))["properties"]
    part = whole["chapter"]["items"]["properties"]["part"]["items"]["properties"]
    for keys, good in ((whole, "title ="), (whole["chapter"]["items"]["properties"], "lang = \"en\""),
                       (part, "name = \"delta\""), (whole["pdf"]["properties"], "[defaults]")):  # fmt: skip
        wrong = "[pdf]\nzz = 3\n[defaults]" if good == "[defaults]" else f"zz = 3\n{good}"
        assert (
            refused(tmp_path, GOOD.replace(good, wrong, 1).encode())
            .partition("\n")[0]
            .endswith(f"; choose from {', '.join(keys)}")
        )


@given(st.lists(st.text(st.characters(exclude_categories=("C", "Z")), min_size=1, max_size=40), min_size=2))
@settings(max_examples=15)
def test_every_command_has_a_name_that_files_may_have(
    tmp_path_factory: pytest.TempPathFactory, words: list[str]
) -> None:
    quoted = [text.replace("'", "").replace('"', "").replace("\\", "") + "x" for text in dict.fromkeys(words)]
    runs = [f"table '{one}'" for one in dict.fromkeys(quoted)]
    parts = (f"[[chapter.part]]\n{keys_of(run=run)}" for run in runs)
    done = handbook("list", write(tmp_path_factory.mktemp("names"), f'title = "T"\n{chapter("C", *parts)}'))
    names = [line.split()[0] for line in done.out.splitlines()[3:]]
    for name in names:
        assert 0 < len(name) <= 64
        assert all(one.isascii() and (one.isalnum() or one == "-") for one in name)
        assert not name.startswith("-")
    # Else two have one name, which is said.
    assert len({*names}) == len(runs) or "is taken in line" in done.err


def test_names_of_long_texts_differ(tmp_path: Path) -> None:
    words = "table --ratio " + ";".join(f"1:{n}" for n in range(3, 40))
    parts = (f"[[chapter.part]]\n{keys_of(run=run)}" for run in (words, f"{words};1:40"))
    names = [
        line.split()[0] for line in listed(tmp_path, f'title = "T"\n{chapter("C", *parts)}').splitlines()[3:]
    ]
    assert len({*names}) == 2


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
@settings(max_examples=50)
def test_no_content_ends_in_anything_but_a_sentence(
    tmp_path_factory: pytest.TempPathFactory, content: bytes
) -> None:
    refused(tmp_path_factory.mktemp("manifest"), content)
