"""Tables, questions and errors go to another process, and copies of them are whole."""

from __future__ import annotations

import copy
import copyreg
import importlib
import pickle
import pkgutil
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import pytest
from pages import FUNCTIONS
from places import ROOT

import kurbel
from kurbel.page.build import build
from kurbel.page.layouts import layout, layout_names

MACHINE: dict[str, Any] = {
    "ratio": "1:5",
    "stroke": 0.6,
    "speed": 2,
    "eps": 4,
    "bore": 0.3,
    "pressure": 800_000,
}
LAYOUTS: dict[Any, str] = {layout(name).subject: name for name in layout_names()}
FEW = {"angle": "0;150"}
OVER_ANGLE = {about for about, name in LAYOUTS.items() if "angle" in layout(name).down + layout(name).across}
# A page of each subject, and such with what these have not: the function, and what it is given.
ASKED: dict[str, tuple[Any, dict[str, Any]]] = {
    about: (function, {"layout": LAYOUTS[about], **(FEW if about in OVER_ANGLE else {}), **given})
    for about, (function, given) in FUNCTIONS.items() if about != "formulas"
} | {
    "a machine": (kurbel.forces, MACHINE | {"reciprocating": 300, "friction": 500}),
    "its conditions": (kurbel.solve, MACHINE | {"reciprocating": 300, "where": "torque=max"}),
    "a card": (kurbel.delta, {"card": str(ROOT / "tests" / "cards" / "ideal-2.csv")}),
    "an unknown speed": (kurbel.solve, {
        "unknown": "speed", "ratio": "1:5", "stroke": "600mm", "angle": "c=max", "where": "c = 4 m/s",
    }),
    "an arc crank": (kurbel.solve, {"mechanism": "arc", "rocker": 6, "where": "s=25%"}),
    "a construction": (kurbel.construct, {"name": "ensslin-5", "mechanism": "arc", "rocker": 6}),
    "formulas that are wrong": (kurbel.collate, {"table": "weisbach-150", "only": "deviations"}),
    "a long table": (kurbel.table, {"ratio": "1:5", "step": "0.5"}),
}  # fmt: skip


def elsewhere(one: Any) -> Any:
    """Return a copy of what another process has."""
    return copy.deepcopy(pickle.loads(pickle.dumps(one)))


@pytest.mark.parametrize("name", ASKED)
def test_a_table_and_what_it_asks_are_the_same_elsewhere(name: str) -> None:
    function, given = ASKED[name]
    table, question = function(**given), function.question(**given)
    again = elsewhere(table)
    assert type(again) is type(table)
    assert (str(again), again.anchor, again.letters()) == (str(table), table.anchor, table.letters())
    text = kurbel.typeset(table, "json")
    assert kurbel.typeset(again, "json") == text
    # What was found meanwhile is not carried along; which options a question was made of, the table says.
    built = build(elsewhere(question))
    again = replace(elsewhere(built), request=table.request)
    assert type(again) is type(built)
    assert kurbel.typeset(again, "json") == text


def test_an_interactive_table_has_all_its_steps_elsewhere() -> None:
    table = kurbel.table.interactive(ratio="1:4;1:5", step=90)
    assert kurbel.typeset(elsewhere(table), "html") == kurbel.typeset(table, "html")


def errors(kind: type[kurbel.KurbelError] = kurbel.KurbelError) -> Iterator[type[kurbel.KurbelError]]:
    yield kind
    for one in kind.__subclasses__():
        yield from errors(one)


def test_every_error_says_the_same_elsewhere(monkeypatch: pytest.MonkeyPatch) -> None:
    for module in pkgutil.walk_packages(kurbel.__path__, "kurbel."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)
    for kind in errors():
        # Dask brings a way of its own for all errors that are known by then.
        monkeypatch.delitem(copyreg.dispatch_table, kind, raising=False)
        # Some are made of more than their sentence.
        needed = kind.__init__.__code__.co_argcount - 1 if "__init__" in vars(kind) else 1
        error = kind(*(f"part {place}" for place in range(needed)))
        again = elsewhere(error)
        assert (type(again), str(again), vars(again)) == (kind, str(error), vars(error))
        assert again.exit_code == error.exit_code
