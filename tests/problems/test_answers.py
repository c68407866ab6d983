"""The problems of examples/problems: each command answers with the digits of an independent solution."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from random import Random

import pytest
from manifests import built, chapter, keys_of
from problem_answers import SOLUTIONS
from random_problems import FILES, FOLDER, PROBLEMS, check, reshaped, values_of


@pytest.mark.parametrize("name", PROBLEMS)
def test_every_answer_has_the_digits_of_an_independent_solution(name: str) -> None:
    for variant in (1, 2):
        check(name, values_of(name, variant))
    # The same problem, far from round numbers, and of another structure.
    random = Random(name)
    check(name, reshaped(name, random))


@pytest.mark.parametrize(("lang", "word"), [("de", "Aufgabe"), ("en", "Problem")])
def test_the_text_of_every_problem_can_be_set(lang: str, word: str, tmp_path: Path) -> None:
    parts = (chapter(name, f'[[chapter.part]]\nproblems = "{name}.toml"\n') for name in FILES)
    manifest = f'{keys_of(title="T", lang=lang)}formats = ["text"]\n{"".join(parts)}'
    texts = {f"{name}.toml": path.read_text(encoding="utf-8") for name, path in FILES.items()}
    page = (built(tmp_path, manifest, texts) / "handbook.txt").read_text(encoding="utf-8")
    assert len(re.findall(rf"^ *{word} [A-Z]\d+\. \S", page, re.MULTILINE)) == len(PROBLEMS)
    assert "{" not in page


def test_every_problem_is_solved_and_no_name_stands_twice() -> None:
    texts = [path.read_text(encoding="utf-8") for path in FILES.values()]
    names = [one["name"] for text in texts for one in tomllib.loads(text)["problem"]]
    assert sorted(names) == sorted(SOLUTIONS)


@pytest.mark.parametrize(("book", "lang"), [("handbook", "de"), ("english", "en")])
def test_the_book_of_a_language_has_every_file_in_it_alone(book: str, lang: str) -> None:
    manifest = tomllib.loads((FOLDER / f"{book}.toml").read_text(encoding="utf-8"))
    found = {
        (chapter.get("lang", manifest["lang"]), part["problems"])
        for chapter in manifest["chapter"]
        for part in chapter["part"]
    }
    assert found == {(lang, path.name) for path in FILES.values()}
