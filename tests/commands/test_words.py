"""The functions of Python have the words of the command line: options, defaults, sentences and pages."""

from __future__ import annotations

import doctest
import inspect
import pydoc
import re
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from cli import printed, refusal

import kurbel
from kurbel.cli.app import command_of
from kurbel.errors import KurbelError
from kurbel.page.subject import Question

TABLES: Mapping[str, Callable[..., Any]] = {
    "table": kurbel.table,
    "forces": kurbel.forces_table,
    "inertia": kurbel.inertia_table,
    "solve": kurbel.solve_table,
    "delta": kurbel.delta_table,
    "turning": kurbel.turning_table,
    "power": kurbel.power_table,
    "pressures": kurbel.pressures_table,
    "flywheel": kurbel.flywheel_table,
    "deadcentres": kurbel.dead_centres_table,
    "harmonics": kurbel.harmonics_table,
    "balance": kurbel.balance_table,
    "rotor": kurbel.rotor_table,
    "locomotive": kurbel.locomotive_table,
    "firing": kurbel.firing_table,
    "collate": kurbel.collation_table,
    "example": kurbel.example_table,
}
PLOTS: Sequence[Callable[..., Any]] = (
    kurbel.plot_motion,
    kurbel.plot_mechanism,
    kurbel.plot_forces,
    kurbel.plot_polar,
    kurbel.plot_engine_forces,
    kurbel.plot_engine_polar,
    kurbel.plot_pressures,
    kurbel.plot_turning,
)
ONLY_TYPED = {
    "machine",
    "format",
    "output",
    "decimal",
    "standalone",
    "longtable",
    "siunitx",
    "excel",
    "strict",
    "interactive",
}


@pytest.mark.parametrize("name", TABLES)
def test_a_function_has_the_options_of_its_command(name: str) -> None:
    options = {param.name for param in command_of(name).params} - ONLY_TYPED
    if name == "collate":
        options -= {"digits", "rounding"}
    assert {key.rstrip("_") for key in inspect.signature(TABLES[name]).parameters} == options


def test_every_option_of_plot_belongs_to_a_function() -> None:
    options = {param.name for param in command_of("plot").params}
    known = {name.rstrip("_") for plot in PLOTS for name in inspect.signature(plot).parameters}
    assert (
        known | {"machine", "format", "output", "text", "forces", "polar", "pressures", "turning"} == options
    )


@pytest.mark.parametrize("function", [*TABLES.values(), *PLOTS], ids=lambda function: function.__name__)
def test_the_help_of_python_describes_every_parameter(function: Any) -> None:
    text = pydoc.plain(pydoc.render_doc(function))
    for name, parameter in inspect.signature(function).parameters.items():
        (option,) = parameter.annotation.__metadata__
        assert f"{name}: {option.help}" in text
    assert not {"\b", "\f"} & set(text)


@pytest.mark.parametrize("name", TABLES)
def test_the_examples_of_the_functions_are_true(name: str) -> None:
    function = TABLES[name]
    tests = doctest.DocTestParser().get_doctest(function.__doc__ or "", {}, name, None, None)
    result = doctest.DocTestRunner().run(tests)
    assert result.failed == 0
    assert (result.attempted > 0) == (name != "turning")


@pytest.mark.parametrize(
    ("words", "page"),
    [
        (
            "table --ratio=1:4;1:5 --from=10 --to=50 --step=20 --stroke=600mm --speed=120/min",
            lambda: kurbel.table(["1:4", 0.2], from_=10, to=50, step="20", stroke=0.6, speed=2),
        ),
        (
            "table --ratio=1:5 --offset=60mm --stroke=600mm --angle=30",
            lambda: kurbel.table(Fraction(1, 5), offset=0.2, stroke=0.6, angle=np.array([30.0])),
        ),
        ("table --stroke=600mm --rod=1500mm", lambda: kurbel.table(stroke="600mm", rod=1.5)),
        (
            "table --mechanism=arc --rocker=6 --pivot=4;6.5",
            lambda: kurbel.table(mechanism="arc", rocker=6, pivot=(4, 6.5)),
        ),
        (
            "forces --eps=4 --bore=300mm --pressure=8bar --stroke=60cm --reciprocating=0.3t --speed=2Hz",
            lambda: kurbel.forces_table(
                eps=4, bore=0.3, pressure=800_000, stroke=0.6, reciprocating=300, speed=2
            ),
        ),
        ("forces --force=10kN", lambda: kurbel.forces_table(force=10_000)),
        (
            "flywheel --eps=4 --power=50kW --speed=120/min --delta=1:100 --radius=1.5m --cranks=0;90",
            lambda: kurbel.flywheel_table(
                4, power=50_000, speed=2, delta=0.01, radius=1.5, cranks=[0, 90]
            ),
        ),
        ("delta --eps=2;3 --back=10% --single-acting", lambda: kurbel.delta_table(
            [2, 3], back=0.1, single_acting=True
        )),
        ("delta --eps=2..4 --detail", lambda: kurbel.delta_table("2..4", detail=True)),
        (
            "inertia --centre=65% --gyration=0.35 --lang=en",
            lambda: kurbel.inertia_table(centre=0.65, gyration="35%", lang="en"),
        ),
        ("solve --where=p=0 --where=c=max", lambda: kurbel.solve_table(["p=0", "c=max"])),
        (
            "balance --cranks=0;0;90;90 --banks=-45;45;-45;45",
            lambda: kurbel.balance_table(cranks=[0, 0, 90, 90], banks="-45;45;-45;45"),
        ),
        ("collate roetscher-112 --only=deviations", lambda: kurbel.collation_table(
            "roetscher-112", only="deviations"
        )),
        ("example blau 33 --ratio=1:4", lambda: kurbel.example_table("blau", 33, ratio=0.25)),
    ],
)  # fmt: skip
def test_numbers_and_text_make_the_page_of_the_command_line(words: str, page: Any) -> None:
    assert str(page()) == printed(*words.split(" ")).out


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: kurbel.table("1:5", stroke=1, rod=2), "table --ratio=1:5 --stroke=1m --rod=2m"),
        (lambda: kurbel.table(mechanism="parallel", ratio="1:5"), "table --mechanism=parallel --ratio=1:5"),
        (lambda: kurbel.table(rocker=6), "table --rocker=6"),
        (lambda: kurbel.table(mechanism="offset"), "table --mechanism=offset"),
        (lambda: kurbel.table(mechanism="beam"), "table --mechanism=beam"),
        (lambda: kurbel.table(method="fast"), "table --method=fast"),
        (lambda: kurbel.table(lang="fr"), "table --lang=fr"),
        (lambda: kurbel.table(angle=10, step=5), "table --angle=10 --step=5"),
        (lambda: kurbel.table(stroke="6"), "table --stroke=6"),
        (lambda: kurbel.delta_table(4, stroke=1), "delta --eps=4 --stroke=1m"),
        (lambda: kurbel.forces_table(back=0.1), "forces --back=0.1"),
        (lambda: kurbel.forces_table(eps=4, force=1), "forces --eps=4 --force=1N"),
        (lambda: kurbel.forces_table(at="tangent", step=1), "forces --at=tangent --step=1"),
        (lambda: kurbel.flywheel_table(speed=2, delta=0.1), "flywheel --speed=2Hz --delta=0.1"),
        (lambda: kurbel.delta_table(card="x", eps=4), "delta --card=x --eps=4"),
        (lambda: kurbel.balance_table("v2-90", cranks=[0, 180]), "balance --engine=v2-90 --cranks=0;180"),
        (lambda: kurbel.plot_turning(4, method="infinite"), "plot --turning --eps=4 --method=infinite -fsvg"),
        (lambda: kurbel.plot_polar(mechanism="arc"), "plot --polar --mechanism=arc -fsvg"),
        (lambda: kurbel.plot_motion(mechanism="parallel", force=1),
         "plot --mechanism=parallel --force=1N -fsvg"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused_in_the_words_of_the_command_line(call: Any, words: str) -> None:
    with pytest.raises(kurbel.KurbelError) as raised:
        call()
    assert str(raised.value) == refusal(*words.split(" "), code=raised.value.exit_code)


def test_a_question_is_what_would_be_made() -> None:
    question = kurbel.table.question("1:5", step=90)
    assert isinstance(question, Question)
    assert len(question) == 3
    with pytest.raises(AttributeError):
        question.lang = "en"  # type: ignore[misc]


def test_machines_and_variables_are_for_the_command_line(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("KURBEL_TABLE_RATIO", "1:4")
    monkeypatch.setenv("KURBEL_LANG", "en")
    assert "1:5" in kurbel.table().caption


WRONG: list[tuple[Any, dict[str, Any], str]] = [
    (kurbel.table, {"lang": []}, "lang"),
    (kurbel.table, {"layout": {}}, "not the name of a layout"),
    (kurbel.table, {"layouts": 5}, "layouts is 5, which is not the name of a file or a folder"),
    (kurbel.delta_table, {"card": 5}, "card is 5"),
    (kurbel.delta_table, {"card": [None]}, "card is None"),
    (kurbel.delta_table, {"method": 2.0}, "choose from"),
    (kurbel.collation_table, {"sources": 1.5}, "sources is 1.5"),
    (kurbel.solve_table, {"where": 5}, "a condition is text"),
    (kurbel.dead_centres_table, {"beam": []}, "no beam arm was given"),
    (kurbel.plot_motion, {"ratio": []}, "no crank ratio was given"),
    (kurbel.plot_polar, {"ratio": ()}, "no crank ratio was given"),
    (kurbel.table, {"angle": b"0"}, "angle is bytes; give text or numbers"),
    (kurbel.table, {"label": 5}, "label is 5; it must be text"),
    (kurbel.table, {"digits": "x"}, "digits is x; it must be a whole number from 0 to 50"),
    (kurbel.delta_table, {"single_acting": "no"}, "single_acting is no; it must be True or False"),
    (kurbel.delta_table, {"card": "a\0b"}, "card is a\\0b, which is not the name of a file"),
    (kurbel.table, {"columns": (one for one in ("phi", "nope"))}, "nope"),
]


@pytest.mark.parametrize(("function", "given", "said"), WRONG, ids=[one[2] for one in WRONG])
def test_values_of_another_kind_are_answered_with_a_sentence(
    function: Any, given: dict[str, Any], said: str
) -> None:
    with pytest.raises(KurbelError, match=re.escape(said)):
        function(**given)


def test_none_leaves_an_option_out() -> None:
    nothing: dict[str, Any] = dict.fromkeys(("lang", "rounding", "label"))
    assert str(kurbel.table("1:5", step=90, **nothing)) == str(kurbel.table("1:5", step=90))


SAME: list[tuple[Callable[..., Any], dict[str, Any], dict[str, Any]]] = [
    (kurbel.table, {"angle": iter((0, 90))}, {"angle": "0;90"}),
    (kurbel.table, {"ratio": (one for one in ("1:4", "1:5"))}, {"ratio": "1:4;1:5"}),
    (kurbel.table, {"columns": map(str, ("phi", "x"))}, {"columns": "phi,x"}),
    (kurbel.table, {"angle": np.array(90), "ratio": np.array(0.2)}, {"angle": 90, "ratio": "1:5"}),
    (kurbel.table, {"digits": "3"}, {"digits": 3}),
    (kurbel.table, {"digits": np.int64(3)}, {"digits": 3}),
    (kurbel.delta_table, {"eps": 4, "method": iter(("weisbach",))}, {"eps": 4, "method": "weisbach"}),
    (kurbel.harmonics_table, {"ratio": "1:5", "orders": "6"}, {"ratio": "1:5", "orders": 6}),
]


@pytest.mark.parametrize(("function", "given", "plain"), SAME, ids=[str(one[2]) for one in SAME])
def test_iterators_numbers_as_text_and_arrays_of_one_number_are_read(
    function: Callable[..., Any], given: dict[str, Any], plain: dict[str, Any]
) -> None:
    assert str(function(**given)) == str(function(**plain))


def test_a_name_with_a_nul_is_refused(tmp_path: Path) -> None:
    with pytest.raises(KurbelError, match="a NUL in its name"):
        kurbel.table("1:5").save(str(tmp_path / "a\0.tex"))
