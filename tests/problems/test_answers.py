"""The problems of examples/problems: each command answers with the digits of an independent solution."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from functools import partial
from importlib import import_module
from inspect import signature
from pathlib import Path
from typing import Any

import pytest
from places import ROOT
from problem_answers import SOLUTIONS, Rows, in_si
from random_problems import compare

from kurbel.documents.markdown import parse_prose
from kurbel.handbook.problems import problems_of
from kurbel.page.layouts import LANGUAGES

FOLDER = ROOT / "examples" / "problems"
BOOKS = ("handbook", "english", "sheet")
FILES = {path.stem: path for path in sorted(FOLDER.glob("*.toml")) if path.stem not in BOOKS}
for name in FILES:
    import_module(f"answers_{name}")


@pytest.mark.parametrize("variant", [1, 2])
@pytest.mark.parametrize("file", FILES)
def test_every_answer_has_the_digits_of_an_independent_solution(file: str, variant: int) -> None:
    for problem in problems_of(str(FILES[file]), "en", variant):
        values = as_asked(SOLUTIONS[problem.name], values_of(FILES[file], problem.name, variant))
        compare(problem.words, partial(SOLUTIONS[problem.name], **values))


def as_asked(solve: Callable[..., Rows], typed: dict[str, str]) -> dict[str, Any]:
    """Return the values in SI units; those that a solution reads itself as they are typed."""
    asked = signature(solve).parameters
    return {name: one if asked[name].annotation == "str" else in_si(one) for name, one in typed.items()}


def values_of(path: Path, name: str, variant: int) -> dict[str, str]:
    """Return the values of a problem's variant as they are typed."""
    given = tomllib.loads(path.read_text(encoding="utf-8"))["problem"]
    values: dict[str, Any] = next(one["values"] for one in given if one["name"] == name)
    return {key: one if isinstance(one, str) else one[variant - 1] for key, one in values.items()}


def test_every_problem_is_solved_and_no_name_stands_twice() -> None:
    names = [problem.name for path in FILES.values() for problem in problems_of(str(path), "de")]
    assert sorted(names) == sorted(SOLUTIONS)


@pytest.mark.parametrize("lang", LANGUAGES)
@pytest.mark.parametrize("file", FILES)
def test_the_texts_of_every_problem_can_be_set(file: str, lang: str) -> None:
    for problem in problems_of(str(FILES[file]), lang, 2):
        for text in (problem.posed, problem.solved):
            parse_prose(text)


@pytest.mark.parametrize(("book", "lang"), [("handbook", "de"), ("english", "en")])
def test_the_book_of_a_language_has_every_file_in_it_alone(book: str, lang: str) -> None:
    manifest = tomllib.loads((FOLDER / f"{book}.toml").read_text(encoding="utf-8"))
    found = {
        (chapter.get("lang", manifest["lang"]), part["problems"])
        for chapter in manifest["chapter"]
        for part in chapter["part"]
    }
    assert found == {(lang, path.name) for path in FILES.values()}
