"""The library: its examples are true, and it has the words, sentences and pages of the command line."""

from __future__ import annotations

import doctest
import inspect
import pydoc
import re
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from operator import attrgetter
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from cli import kurbel as kurbel_line
from cli import printed, refusal
from completion import PRINTING, described

import kurbel
from kurbel.reading.names import as_keywords

EXAMPLES = Path(__file__).parents[2] / "examples"
TABLES: dict[str, Callable[..., Any]] = {
    name: getattr(kurbel, name) for name in (*PRINTING, "collate", "example")
}
ONLY_TYPED = {
    *("format", "output", "decimal", "standalone", "longtable", "siunitx", "plain", "excel", "strict"),
    *("interactive", "help", "text", "width", "height", "polar", "over_path", "infinite", "animate"),
    "seconds",
}


# What no checker of types lets pass, and what is read all the same.
UNUSUAL: dict[str, Any] = {"digits": np.int64(3), **dict.fromkeys(("lang", "rounding", "label"))}
AS_TEXT: dict[str, Any] = {"digits": "3"}
SIXTH: dict[str, Any] = {"orders": "6"}


def typed(command: str) -> set[str]:
    return {one.removeprefix("--").replace("-", "_") for one in described(command, "--")} - ONLY_TYPED


def taken(function: Callable[..., Any]) -> set[str]:
    return {key.rstrip("_") for key in inspect.signature(function).parameters}


def test_a_function_has_the_options_of_its_command() -> None:
    for name, function in TABLES.items():
        # Sources and numbers of examples stand behind no option.
        arguments = {"collate": {"table"}, "example": {"book", "number"}}.get(name, set())
        counted = {"digits", "rounding"} if name == "collate" else set()
        assert taken(function) - arguments == typed(name) - counted, name
    assert taken(kurbel.plot_mechanism) - ONLY_TYPED == typed("plot")


@pytest.mark.parametrize("function", [*TABLES.values(), kurbel.plot_mechanism], ids=lambda one: one.__name__)
def test_the_help_of_python_describes_every_parameter(function: Any) -> None:
    text = pydoc.plain(pydoc.render_doc(function))
    for name, parameter in inspect.signature(function).parameters.items():
        assert f"    {name} ({parameter.annotation}" in text
    for key, one in function.command.parameters.items():
        assert re.search(rf"^    {key} \([^\n]*\): {re.escape(one.help)}", text, re.MULTILINE), key
    assert not {"\b", "\f"} & set(text)
    assert text.count("\n") <= 150
    assert "Annotated" not in text


def test_types_are_plain_and_every_number_may_be_a_float() -> None:
    parameters = inspect.signature(kurbel.forces).parameters
    found = {
        name: parameters[name].annotation
        for name in ("ratio", "columns", "stroke", "single_acting", "digits")
    }
    assert found == {
        "ratio": "str | float | list",
        "columns": "str | list",
        "stroke": "str | float",
        "single_acting": "bool",
        "digits": "int",
    }
    assert parameters["machine"].annotation == parameters["layouts"].annotation == "str | Path"
    assert pydoc.plain(pydoc.render_doc(kurbel.forces)).splitlines()[2] == (
        "forces(ratio=None, **options) -> Table"
    )


@pytest.mark.parametrize(
    ("name", "args", "more", "sentence"),
    [
        ("table", (), {"stroek": "600mm"}, r'kurbel.table has no keyword "stroek" \(did you mean stroke\?\)'),
        ("forces", (), {"rpm": 120}, r'kurbel.forces has no keyword "rpm" \(did you mean speed\?\)'),
        ("table.question", (), {"colums": "x"}, r"\(did you mean columns\?\)"),
        ("table", (), {"format": "csv"}, r'kurbel.typeset\(page, "latex"\), or page.save$'),
        ("table", ("1:5", "1:4"), {}, r"is given 2 values without a name; ratio can stand without"),
        ("table", ("1:5",), {"ratio": "1:4"}, r"is given ratio twice, by its place and by its name"),
        ("certified", ("x",), {"angle": 60}, r"^kurbel.certified needs ratio; help\(kurbel.certified\) says"),
        ("compute", ([1], "1:5"), {"ofset": 1}, r"\(did you mean offset\?\)"),
        ("compute", ([1], "1:5", "torque_nm"), {"forse": 1}, r"\(did you mean force\?\)"),
        ("sweep", ("delta",), {"epss": [1, 2]}, r"\(did you mean eps\?\)"),
        ("typeset", (kurbel.table(), 3), {}, "^format is 3; it must be text$"),
        ("Table.save", (kurbel.table(), 3), {}, "^path is 3; it must be the name of a file$"),
        ("Drawing.save", (kurbel.table().plot(),), {}, r"^kurbel.Drawing.save needs path; help\("),
    ],
)
def test_a_wrong_keyword_is_told_the_nearest(
    name: str, args: tuple[Any, ...], more: dict[str, Any], sentence: str
) -> None:
    with pytest.raises(kurbel.KurbelError, match=sentence) as raised:
        attrgetter(name)(kurbel)(*args, **more)
    assert isinstance(raised.value, TypeError)


MACHINES = ("engine.toml", "blower.toml", "gas-engine.toml", "pump.toml", "machines/*.toml")


# What a machine does not say.
NEEDED = {
    "rotor": {"masses": "3;5kg", "radii": "20mm", "angles": "0;90"},
    "locomotive": {"gauge": "1.5m", "spacing": "0.7m", "reciprocating": "300kg"},
}


@pytest.mark.parametrize(
    "file",
    [str(one) for names in MACHINES for one in sorted(EXAMPLES.glob(names))],
    ids=lambda one: Path(one).stem,
)
def test_a_machine_gives_what_is_not_given_by_hand(file: str) -> None:
    """Each function makes the page of its command, or says the same sentence, with keywords for options."""
    pages = 0
    for name, function in TABLES.items():
        if function.command.machine:  # type: ignore[attr-defined]
            more = {"step": "90"} if name in ("table", "forces", "turning", "inertia") else {}
            # Cylinders that have strokes of their own take no other.
            apart = "[[cylinder]]\nstroke" in Path(file).read_text(encoding="utf-8")
            wanted = "stroke" in taken(function) and not (apart and "cylinder" in taken(function))
            more |= {"stroke": "610mm"} if wanted else {}
            more |= NEEDED.get(name, {})
            line = kurbel_line(name, f"--machine={file}", *(f"--{key}={one}" for key, one in more.items()))
            try:
                page = str(function(machine=file, **more))
            except kurbel.KurbelError as error:
                words = function.command.keywords()  # type: ignore[attr-defined]
                assert as_keywords(line.err, words) == f"kurbel: {error}\n", name
            else:
                assert page == line.out, name
                pages += 1
    assert pages >= 5


def test_sweeps_are_of_a_machine_too(tmp_path: Path) -> None:
    file = str(EXAMPLES / "engine.toml")
    found = kurbel.sweep("delta", machine=file, eps="2..4", method="series", digits=6, lang="en")
    words = ("sweep", "delta", f"--machine={file}", "--eps=2..4", "--method=series")
    assert kurbel_line(*words, "-o", str(tmp_path / "a.csv")).code == 0
    lines = (tmp_path / "a.csv").read_text(encoding="utf-8").splitlines()
    column = lines[0].split(",").index("delta")
    assert found["delta"].dims == ("epsilon",)
    values = [float(line.split(",")[column]) for line in lines[1:]]
    assert [float(value) for value in found["delta"].values.ravel()] == pytest.approx(values, abs=1e-6)


def test_arrays_are_of_a_machine_too() -> None:
    file = EXAMPLES / "engine.toml"
    page = kurbel.forces(machine=file, angle="30;60", columns="torque_nm", digits=6).to_numpy()
    found = kurbel.compute([30, 60], columns="torque_nm", machine=file)["torque_nm"]
    np.testing.assert_allclose(found, page["torque_nm"], rtol=0, atol=5.1e-7)


@pytest.mark.parametrize("name", ["kurbel", *kurbel.__all__])
def test_the_examples_of_the_docstrings_are_true(name: str) -> None:
    known = {one: getattr(kurbel, one) for one in kurbel.__all__} | {"kurbel": kurbel}
    text = (kurbel if name == "kurbel" else getattr(kurbel, name)).__doc__ or ""
    tests = doctest.DocTestParser().get_doctest(text, known, name, None, None)
    result = doctest.DocTestRunner().run(tests)
    assert result.failed == 0
    tables = {one.__name__ for one in TABLES.values()} - {"turning"}
    assert result.attempted or name not in {"kurbel", "certified", "compute", "typeset", *tables}


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
        (
            "table --ratio=1:4;1:5 --angle=0;90 --columns=phi,x --digits=3 --rounding=half-away",
            lambda: kurbel.table(
                (one for one in ("1:4", "1:5")), angle=iter((0, 90)), columns=map(str, ("phi", "x")),
                **UNUSUAL,
            ),
        ),
        ("table --angle=90 --digits=3", lambda: kurbel.table(np.array(0.2), angle=np.array(90), **AS_TEXT)),
        ("table --stroke=600mm --rod=1500mm", lambda: kurbel.table(stroke="600mm", rod=1.5)),
        (
            "table --mechanism=arc --rocker=6 --pivot=4;6.5",
            lambda: kurbel.table(mechanism="arc", rocker=6, pivot=(4, 6.5)),
        ),
        (
            "forces --eps=4 --bore=300mm --pressure=8bar --stroke=60cm --reciprocating=0.3t --speed=2Hz",
            lambda: kurbel.forces(
                eps=4, bore=0.3, pressure=800_000, stroke=0.6, reciprocating=300, speed=2
            ),
        ),
        (
            "flywheel --eps=4 --power=50kW --speed=120/min --delta=1:100 --radius=1.5m --cranks=0;90",
            lambda: kurbel.flywheel(
                4, power=50_000, speed=2, delta=0.01, radius=1.5, cranks=[0, 90]
            ),
        ),
        ("delta --eps=2;3 --back=10% --single-acting", lambda: kurbel.delta(
            [2, 3], back=0.1, single_acting=True
        )),
        ("solve --where=p=0 --where=c=max", lambda: kurbel.solve(["p=0", "c=max"])),
        ("harmonics --ratio=1:5 --orders=6", lambda: kurbel.harmonics("1:5", **SIXTH)),
        ("example blau 33 --ratio=1:4", lambda: kurbel.example("blau", 33, ratio=0.25)),
    ],
)  # fmt: skip
def test_numbers_and_text_make_the_page_of_the_command_line(words: str, page: Any) -> None:
    assert str(page()) == printed(*words.split(" ")).out


@pytest.mark.parametrize(
    ("words", "page"),
    [
        (("table",), lambda: kurbel.table(lang="en")),
        (("table", "--ratio", "1:4", "--ratio", "1:5"), lambda: kurbel.table(ratio=["1:4", "1:5"])),
        (("table", "--method=series", "--digits=5"), lambda: kurbel.table(digits=5, method="series")),
        (("delta", "--eps=4.5"), lambda: kurbel.delta("4.5")),
        (("turning", "--torque=5 + sin(φ)"), lambda: kurbel.turning(torque="5 + sin(φ)")),
        (("collate", "blau-33"), lambda: kurbel.collate("blau-33")),
    ],
)
def test_a_page_has_one_name_for_references_whoever_made_it(words: tuple[str, ...], page: Any) -> None:
    assert rf"\label{{tab:{page().anchor}}}" in printed(*words, "-f", "latex").out
    assert re.fullmatch(r"[A-Za-z0-9.-]{1,80}", page().anchor)


def test_other_values_give_other_names_for_references() -> None:
    pages = (
        *(kurbel.table(ratio=ratio, angle=60) for ratio in ("1:4", "1:4.5", ["1:4", "1:5"], "1:45")),
        *(kurbel.table(ratio="1:4", angle=60, offset=offset) for offset in ("0.1", "-0.1")),
        *(kurbel.delta(eps=eps) for eps in ("4;5", "4.5")),
        *(kurbel.turning(torque=f"5 {sign} sin(φ)") for sign in "+-"),
    )
    assert len({page.anchor for page in pages}) == len(pages)
    assert kurbel.table().anchor == kurbel.table(lang="en").anchor == "kinematics"
    assert kurbel.table(ratio="1:4").anchor == "kinematics-ratio-1-4"
    # What programs read of a table stays as it is.
    assert '"table": "kinematics"' in kurbel.table(ratio="1:4").typeset("json")


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: kurbel.table("1:5", stroke=1, rod=2), "table --ratio=1:5 --stroke=1m --rod=2m"),
        (lambda: kurbel.table(mechanism="parallel", ratio="1:5"), "table --mechanism=parallel --ratio=1:5"),
        (lambda: kurbel.table(rocker=6), "table --rocker=6"),
        (lambda: kurbel.table(mechanism="beam"), "table --mechanism=beam"),
        (lambda: kurbel.table(method="fast"), "table --method=fast"),
        (lambda: kurbel.table(angle=10, step=5), "table --angle=10 --step=5"),
        (lambda: kurbel.table(stroke="6"), "table --stroke=6"),
        (lambda: kurbel.delta(4, stroke=1), "delta --eps=4 --stroke=1m"),
        (lambda: kurbel.forces(back=0.1), "forces --back=0.1"),
        (lambda: kurbel.forces(eps=4, force=1), "forces --eps=4 --force=1N"),
        (lambda: kurbel.flywheel(speed=2, delta=0.1), "flywheel --speed=2Hz --delta=0.1"),
        (lambda: kurbel.delta(card="x", eps=4), "delta --card=x --eps=4"),
        (lambda: kurbel.balance("v2-90", cranks=[0, 180]), "balance --engine=v2-90 --cranks=0;180"),
        (lambda: kurbel.plot_mechanism(ratio="1:5"), "plot --ratio=1:5 -fsvg"),
        (lambda: kurbel.table(mechanism="arc", rocker=6).plot(polar=True),
         "table --mechanism=arc --rocker=6 --polar -fsvg"),
        (lambda: kurbel.delta(4).plot(), "delta --eps=4 -fsvg"),
        (lambda: kurbel.table().plot(seconds=3), "table --seconds=3 -fsvg"),
        (lambda: kurbel.table().plot(width=5000), "table --width=5000 -fsvg"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused_in_the_words_of_the_command_line(call: Any, words: str) -> None:
    """The sentences are those of the command line, with keywords for its options."""
    with pytest.raises(kurbel.KurbelError) as raised:
        call()
    name, *options = words.split(" ")
    sentence = refusal(name, *options, code=raised.value.exit_code)
    function = getattr(kurbel, "plot_mechanism" if name == "plot" else name)
    assert str(raised.value) == as_keywords(sentence, function.command.keywords())


def test_a_question_is_what_would_be_made() -> None:
    question = kurbel.table.question("1:5", step=90)
    assert len(question) == 3
    with pytest.raises(AttributeError):
        question.lang = "en"


def test_variables_are_for_the_command_line(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("KURBEL_TABLE_RATIO", "1:4")
    monkeypatch.setenv("KURBEL_LANG", "en")
    assert "1:5" in kurbel.table().caption


def test_digits_beyond_the_default_precision_of_decimals_are_kept() -> None:
    # A float is read by its shortest decimal.
    assert kurbel.certified("x", 0.2, 90, digits=50) == kurbel.certified("x", "1:5", "90", digits=50)
    assert kurbel.certified("x", "1:5", 90, digits=50).as_tuple().exponent == -50
    assert kurbel.certified("c", "1:5", 90, digits=50) == Decimal(1)


def test_arrays_keep_their_shape_and_agree_with_certified_digits() -> None:
    angles = np.array([[0.0, 12.5, 90.0], [179.0, 180.0, 251.25]])
    for key, array in kurbel.compute(angles, "2:9", ["x", "c", "p", "psi"], offset="0.1").items():
        exact = kurbel.table("2:9", offset="0.1", angle=angles.ravel(), columns=f"phi,{key}", digits=30)
        assert array.shape == angles.shape
        np.testing.assert_allclose(array.ravel(), exact.to_numpy()[key], rtol=1e-14, atol=1e-15)
    assert kurbel.compute(90, "1:5")["c"].shape == ()
    assert kurbel.compute("0;90", "1:5", "c")["c"].tolist() == [0.0, 1.0]
