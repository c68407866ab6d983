"""What a handbook has before and behind its chapters, made of its tables, its texts and its manifest."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from cli import kurbel
from manifests import run

MANIFEST = """\
title = "Tafeln"
lang = "{lang}"
formats = ["markdown", "json"]
{keys}
[[chapter]]
title = "Wege"
[[chapter.part]]
text = "Die [geschränkte Kurbel](<index:Kurbel, geschränkte>), der [Balancier](index:); siehe [](#{page})."

""" + "".join(
    run(name, command)
    for name, command in {
        "wege": "table --ratio 1:5 --step 90",
        "reihe": "table --ratio 1:5 --step 90 --method series",
        "kraefte": "forces --ratio 1:5 --step 90",
        "lueger": "table --layout lueger-kolbenbewegung",
        "balancier": "collate weisbach-149",
    }.items()
)
ALL = 'matter = ["notation", "symbols", "index", "colophon"]\n'


def built(folder: Path, keys: str = "", lang: str = "de", page: str = "wege", **environment: str) -> Path:
    folder.mkdir(exist_ok=True)
    text = MANIFEST.format(keys=keys, lang=lang, page=page)
    (folder / "handbook.toml").write_text(text, encoding="utf-8")
    done = kurbel("handbook", "build", str(folder), "--jobs", "1", **environment)
    assert done.code == 0, done.err
    return folder / "pages"


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("matter") / "book", ALL, page="symbols")


def text_of(pages: Path, name: str) -> str:
    return (pages / "markdown" / f"{name}.md").read_text(encoding="utf-8")


def records(pages: Path, name: str) -> list[dict[str, str]]:
    columns: list[dict[str, str]] = json.loads((pages / "tables" / f"{name}.json").read_text())["columns"]
    return columns


def test_every_reference_finds_its_label_also_where_a_part_is_called_as_its_layout(tmp_path: Path) -> None:
    (tmp_path / "handbook.toml").write_text(
        'title = "T"\nformats = ["typst", "latex", "html"]\n[[chapter]]\ntitle = "C"\n[[chapter.part]]\n'
        'text = "[](#rotor)"\n[[chapter.part]]\nrun = "rotor --masses 12kg --radii 50mm --angles 20"\n'
        'name = "rotor"\n',
        encoding="utf-8",
    )
    assert kurbel("handbook", "build", str(tmp_path), "--jobs", "1").code == 0
    pages = tmp_path / "pages"
    assert '#label("tab-rotor")' in (pages / "tables/rotor.typ").read_text(encoding="utf-8")
    assert "\\label{tab:rotor}" in (pages / "tables/rotor.tex").read_text(encoding="utf-8")
    assert 'id="tab-rotor"' in (pages / "handbook.html").read_text(encoding="utf-8")


def test_symbols_are_those_of_the_tables_each_with_the_first(pages: Path) -> None:
    rows = [
        [cell.strip() for cell in line.strip("|").split(" | ")]
        for line in text_of(pages, "00-symbols").splitlines()
        if line.startswith("| ") and "#tab-" in line
    ]
    listed = {(symbol, name): (unit, at.split("#tab-")[1].rstrip(">)")) for symbol, name, unit, at in rows}
    assert len(listed) == len(rows)
    # The names of columns have what sets them apart from others of the quantity behind a comma.
    first: dict[tuple[str, str], str] = {}
    for table in ("wege", "reihe", "kraefte", "lueger"):
        for one in records(pages, table):
            if one["symbol"]:
                first.setdefault((one["symbol"], one["name"].split(", ")[0]), table)
    assert {key: at for key, (_, at) in listed.items()} == first
    assert listed["x", "Kolbenweg"][0].split(", ") == ["R", "% des Hubes"]


def test_the_index_has_quantities_authors_and_marked_words(pages: Path) -> None:
    text = text_of(pages, "02-index")
    entries = dict(re.findall(r"^- (.+?), (\[.*)$", text, re.MULTILINE))
    assert "#tab-kraefte>" in entries["Stangenkraft"]
    assert "#tab-wege>" in entries["Kolbenweg"]
    assert "#tab-balancier>" in entries["Weisbach-Herrmann"]
    assert "[§ 1](<01-wege.md#sec-wege>)" in entries["Balancier"]
    assert "Kurbel, geschränkte, [§ 1]" in text
    assert "Die geschränkte Kurbel, der" in text_of(pages, "01-wege")
    assert "index:" not in text_of(pages, "01-wege")
    letters = re.findall(r"^\*\*(.)\*\*$", text, re.MULTILINE)
    assert letters == sorted(letters)


def test_the_index_names_all_tables_of_a_quantity(pages: Path) -> None:
    entries = dict(re.findall(r"^- (.+?), (\[.*)$", text_of(pages, "02-index"), re.MULTILINE))
    named: dict[str, list[str]] = {}
    for table in ("wege", "reihe", "kraefte", "lueger"):
        for name in dict.fromkeys(one["name"].split(", ")[0] for one in records(pages, table)):
            named.setdefault(name.removesuffix(" R:L"), []).append(table)
    assert "Kolbenweg" in named
    for name, tables in named.items():
        assert re.findall("#tab-(.*?)>", entries[name]) == tables, name


@pytest.mark.parametrize(("lang", "more"), [("de", "u. ö."), ("en", "and often")])
def test_of_what_is_on_more_than_fifteen_pages_the_index_has_three(
    lang: str, more: str, tmp_path: Path
) -> None:
    chapters = (
        f'[[chapter]]\ntitle = "C{number}"\nname = "c{number}"\n[[chapter.part]]\ntext = "{words}"\n'
        for number in range(1, 17)
        for words in ["[Everywhere](index:)" + " and [nearly](index:)." * (number > 1)]
    )
    top = f'title = "T"\nlang = "{lang}"\nformats = ["markdown"]\nmatter = ["index"]\n'
    (tmp_path / "handbook.toml").write_text(top + "".join(chapters), encoding="utf-8")
    assert kurbel("handbook", "build", str(tmp_path), "--jobs", "1").code == 0
    entries = re.findall(r"^- (\w+), (.*)$", text_of(tmp_path / "pages", "17-index"), re.MULTILINE)
    found = {word: (re.findall(r"#sec-(c\d+)", links), links.rpartition(")")[2]) for word, links in entries}
    assert found == {
        "Everywhere": (["c1", "c2", "c3"], f" {more}"),
        "Nearly": ([f"c{number}" for number in range(2, 17)], ""),
    }


def test_captions_name_the_exceptions_alone_and_records_stay(pages: Path, tmp_path: Path) -> None:
    captions = re.findall(r"^\*\*([^*]{12,})\*\*$", text_of(pages, "01-wege"), re.MULTILINE)
    ends = [caption.partition("; ")[2] for caption in captions]
    assert ends == ["", "Näherung erster Ordnung", "", "genaue Formeln und Näherung erster Ordnung", ""]
    assert "gelten die genauen Formeln" in " ".join(text_of(pages, "00-notation").split())
    plain = built(tmp_path / "plain")
    assert text_of(plain, "01-wege").count("; genaue Formeln**") == 2
    for table in ("wege", "reihe", "kraefte", "lueger"):
        name = f"tables/{table}.json"
        assert (plain / name).read_bytes() == (pages / name).read_bytes()
    assert not [*(plain / "markdown").glob("*index*-*")]
    assert sorted(path.name for path in (plain / "markdown").iterdir()) == ["01-wege.md", "index.md"]


@pytest.mark.parametrize(
    ("lang", "keys", "rounding", "mark"),
    [
        ("en", "", "the one further from zero is printed", "point, as in 0.5"),
        (
            "en",
            '[defaults]\nrounding = "half-even"',
            "the one whose last digit is even is printed",
            "point, as",
        ),
        ("en", 'decimal = "comma"', "the one further from zero is printed", "comma, as in 0,5"),
        ("de", "", "die vom Nullpunkt entferntere", "trennt ein Komma, wie in 0,5"),
        ("de", 'decimal = "point"', "die vom Nullpunkt entferntere", "trennt ein Punkt, wie in 0.5"),
    ],
)
def test_the_page_on_notation_says_how_these_tables_are_rounded_and_counted(
    lang: str, keys: str, rounding: str, mark: str, tmp_path: Path
) -> None:
    arc = "forces --mechanism arc --rocker 6 --step 90 --columns rod_force"
    slide, turn = "forces --step 90 --columns phi,rod_force", "table --step 90 --columns x,rod_velocity"
    book = f'title = "T"\nlang = "{lang}"\nformats = ["markdown"]\nmatter = ["notation"]\n{keys}\n'
    book += '[[chapter]]\ntitle = "C"\n'
    said = {}
    for name, runs in (("all", (arc, slide, f"{slide} --ratio 1:4", turn)), ("none", ("collate blau-31",))):
        folder = tmp_path / name
        folder.mkdir()
        parts = "".join(f'[[chapter.part]]\nrun = "{run}"\n' for run in runs)
        (folder / "handbook.toml").write_text(book + parts, encoding="utf-8")
        assert kurbel("handbook", "build", str(folder), "--jobs", "1").code == 0
        said[name] = text_of(folder / "pages", "00-notation")
    whole = " ".join(said["all"].split())
    assert rounding in whole
    assert mark in whole
    # Of S most tables count it at the crosshead; what no letter begins is told of its own.
    *_, signs = said["all"].split("</strong>")
    listed = re.findall(r"^- (.*)", signs, re.MULTILINE)
    assert [one.split(" ")[0] for one in listed] == ["S", r"ω\_L:"]
    assert ("crosshead" if lang == "en" else "Kreuzkopf") in listed[0]
    of_books = ("Werte aus Büchern", "Values of books")
    assert [any(one in said[name] for one in of_books) for name in said] == [False, True]
    assert ("Signs." in said["none"], "Vorzeichen." in said["none"]) == (False, False)


def test_the_page_on_notation_knows_the_rounding_of_every_run(tmp_path: Path) -> None:
    runs = ("table --step 90", "forces --step 90", "collate blau-31", "table --step 90 --ratio 1:4")
    book = (
        'title = "T"\nlang = "en"\nformats = ["markdown"]\nmatter = ["notation"]\n[[chapter]]\ntitle = "C"\n'
    )
    even = "--rounding half-even"
    for words, said in (
        (
            (even, even.replace(" ", "="), "", even),
            "two numbers, the one whose last digit is even is printed. The",
        ),
        (
            (even, "", "", ""),
            "further from zero is printed; in [Table 1](<01-c.md#tab-t0>) the one whose last",
        ),
        (("", "", "", ""), "two numbers, the one further from zero is printed. The"),
    ):
        listed = enumerate(zip(runs, words, strict=True))
        parts = "".join(f'[[chapter.part]]\nname = "t{n}"\nrun = "{" ".join(one)}"\n' for n, one in listed)
        (tmp_path / "handbook.toml").write_text(book + parts, encoding="utf-8")
        assert kurbel("handbook", "build", str(tmp_path), "--jobs", "1").code == 0
        assert said in " ".join(text_of(tmp_path / "pages", "00-notation").split())


def test_a_page_of_the_matter_is_referred_to_by_its_title(pages: Path) -> None:
    assert "siehe [Formelzeichen](<00-symbols.md#sec-symbols>)." in text_of(pages, "01-wege")


def test_the_day_is_that_of_the_manifest_else_of_the_environment_and_never_the_clock(tmp_path: Path) -> None:
    keys = 'matter = ["colophon"]\nversion = "2, with $x/R$"\n'
    # 22 November 2026, a second before midnight in UTC.
    epoch = {"SOURCE_DATE_EPOCH": "1795391999"}
    assert "Version 2, with x/R\n" in text_of(built(tmp_path / "a", keys, "en"), "02-colophon")
    assert "x/R, 22 November 2026\n" in text_of(built(tmp_path / "b", keys, "en", **epoch), "02-colophon")
    dated = f"{keys}date = 1905-03-01\n"
    assert "x/R vom 1. März 1905\n" in text_of(built(tmp_path / "c", dated, "de", **epoch), "02-colophon")
