"""Tables, questions and errors go to another process, and copies of them are whole."""

from __future__ import annotations

import copy
import copyreg
import importlib
import pickle
import pkgutil
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from pages import FUNCTIONS
from places import ROOT

import kurbel
from kurbel.errors import KurbelError
from kurbel.page.build import build
from kurbel.page.layouts import layout, layout_names

WAYS: dict[str, Callable[[Any], Any]] = {
    "pickled": lambda one: pickle.loads(pickle.dumps(one)),
    "copied": copy.deepcopy,
}
MACHINE: dict[str, Any] = {
    "ratio": "1:5",
    "stroke": 0.6,
    "speed": 2,
    "eps": 4,
    "bore": 0.3,
    "pressure": 800_000,
}
# Pages of each layout, and such with what these have not: the function, and what it is given.
ASKED: dict[str, tuple[Any, dict[str, Any]]] = {
    name: (FUNCTIONS[layout(name).subject][0], {"layout": name, **FUNCTIONS[layout(name).subject][1]})
    for name in layout_names()
} | {
    "a machine": (kurbel.forces_table, MACHINE | {"reciprocating": 300, "friction": 500}),
    "its conditions": (kurbel.solve_table, MACHINE | {"reciprocating": 300, "where": "torque=max"}),
    "a card": (kurbel.delta_table, {"card": str(ROOT / "tests" / "cards" / "ideal-2.csv")}),
    "an unknown speed": (kurbel.solve_table, {
        "unknown": "speed", "ratio": "1:5", "stroke": "600mm", "angle": "c=max", "where": "c = 4 m/s",
    }),
    "an arc crank": (kurbel.solve_table, {"mechanism": "arc", "rocker": 6, "where": "s=25%"}),
    "a construction": (kurbel.construction_table, {"name": "ensslin-5", "mechanism": "arc", "rocker": 6}),
    "formulas that are wrong": (kurbel.collation_table, {"table": "weisbach-150", "only": "deviations"}),
    "a long table": (kurbel.table, {"ratio": "1:5", "step": "0.5"}),
}  # fmt: skip


def pages(table: Any) -> list[str]:
    return [kurbel.typeset(table, form) for form in ("text", "json")]


@pytest.mark.parametrize("name", ASKED)
def test_a_table_and_what_it_asks_are_the_same_elsewhere(name: str) -> None:
    function, given = ASKED[name]
    question = function.question(**given)
    tables = {"asked": function(**given), "built": build(question)}
    for kind, table in tables.items():
        expected, known = pages(table), (table.anchor, table.letters())
        for way in WAYS.values():
            again = way(table)
            assert type(again) is type(table), kind
            assert (pages(again), (again.anchor, again.letters())) == (expected, known), kind
    # What was found meanwhile is not carried along.
    asked = [way(question) for way in WAYS.values()]
    assert {type(one) for one in asked} == {type(question)}
    assert pages(build(asked[0])) == pages(tables["built"])


def test_an_interactive_table_has_all_its_steps_elsewhere() -> None:
    table = kurbel.table.interactive(ratio="1:4;1:5", step=90)
    for way in WAYS.values():
        assert kurbel.typeset(way(table), "html") == kurbel.typeset(table, "html")


def errors(kind: type[KurbelError] = KurbelError) -> Iterator[type[KurbelError]]:
    yield kind
    for one in kind.__subclasses__():
        yield from errors(one)


@pytest.mark.parametrize("way", WAYS)
def test_every_error_says_the_same_elsewhere(way: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for module in pkgutil.walk_packages(kurbel.__path__, "kurbel."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)
    for kind in errors():
        # Dask brings a way of its own for all errors that are known by then.
        monkeypatch.delitem(copyreg.dispatch_table, kind, raising=False)
        # Some are made of more than their sentence.
        needed = kind.__init__.__code__.co_argcount - 1 if "__init__" in vars(kind) else 1
        error = kind(*(f"part {place}" for place in range(needed)))
        again = WAYS[way](error)
        assert (type(again), str(again), vars(again)) == (kind, str(error), vars(error))
        assert again.exit_code == error.exit_code
