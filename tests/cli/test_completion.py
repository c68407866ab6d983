"""Shells complete commands, layouts, formats and the columns of the layout that was typed."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from cli import Result, kurbel, printed
from pages import BEAMS, DRIVES, about
from tools import require

from kurbel.cli import COMMANDS
from kurbel.engine.quantities import ENGINE_METHODS, engine_registry
from kurbel.formats.registry import FORMATS
from kurbel.linkage.arc.quantities import arc_registry
from kurbel.motion.evaluation import METHODS
from kurbel.motion.quantities import registry
from kurbel.page.layouts import LANGUAGES, layout

SHELLS = ("bash", "zsh", "fish")


def asked(shell: str, *words: str) -> Result:
    """Ask as the shell does: the last word is the incomplete one."""
    environment = {"_KURBEL_COMPLETE": f"{shell}_complete", "COMP_WORDS": " ".join(("kurbel", *words))}
    # fish passes the incomplete word itself, bash and zsh its place.
    environment["COMP_CWORD"] = words[-1] if shell == "fish" else str(len(words))
    return kurbel(**environment)


def completed(shell: str, *words: str) -> list[str]:
    """What the shell would offer, in its own notation taken apart."""
    result = asked(shell, *words)
    assert (result.code, result.err) == (0, "")
    lines = [line for line in result.out.splitlines() if line]
    if shell == "zsh":
        # Three lines an entry: kind, word, description.
        assert lines[::3] == ["plain"] * (len(lines) // 3)
        return lines[1::3]
    return [line.split(",", 1)[1].split("\t")[0] for line in lines]


@pytest.mark.parametrize("shell", SHELLS)
def test_layouts_formats_and_columns_are_completed(shell: str) -> None:
    assert completed(shell, "table", "--layout", "") == DRIVES
    assert completed(shell, "table", "--layout", "kin") == ["kinematics"]
    assert completed(shell, "table", "--format", "") == list(FORMATS)
    assert completed(shell, "table", "-f", "m") == ["markdown"]
    assert set(completed(shell, "table", "--columns", "")) == {"ratio", "phi", *registry()}
    assert completed(shell, "table", "--columns", "x_m") == ["x_mm"]
    assert completed(shell, "plot", "--format", "") == ["svg", "png", "pdf", "pgf", "html", "gif"]
    assert completed(shell, "plot", "--columns", "x,c_mp") == ["x,c_mps"]


@pytest.mark.parametrize("shell", SHELLS)
def test_commands_and_options_are_completed(shell: str) -> None:
    assert completed(shell, "") == list(COMMANDS)
    assert completed(shell, "table", "--lay") == ["--layouts", "--layout"]


@pytest.mark.parametrize("shell", SHELLS)
def test_commands_of_a_handbook_and_their_options_are_completed(shell: str) -> None:
    assert set(completed(shell, "handbook", "")) == {"init", "build", "check", "list", "watch"}
    assert completed(shell, "handbook", "bu") == ["build"]
    assert completed(shell, "handbook", "build", "--pdf") == ["--pdf-engine"]
    assert completed(shell, "handbook", "check", "--pdf-engine", "lua") == ["lualatex"]
    assert completed(shell, "inject", "--ch") == ["--check"]


def test_sources_and_numbers_of_examples_are_completed() -> None:
    assert completed("bash", "example", "") == ["blau", "uebung", "weisbach"]
    assert completed("bash", "example", "blau", "") == ["31", "32", "33", "34", "35"]
    assert completed("bash", "example", "weisbach", "14") == ["149"]
    assert completed("bash", "example", "unknown", "") == []


def test_a_list_of_columns_is_completed_after_the_comma_without_those_it_has() -> None:
    assert completed("bash", "table", "--columns", "phi,psi,ps") == ["phi,psi,psi_return"]
    assert completed("bash", "table", "--columns", "phi,x_mm,x_m") == []


def test_the_columns_are_those_of_the_layout_that_was_typed() -> None:
    own = {"ratio", "phi", *(column.key for column in layout("verfahren").columns)}
    assert set(completed("bash", "table", "--layout", "verfahren", "--columns", "")) == own
    assert completed("bash", "table", "--layout", "verfahren", "--columns", "p_d") == ["p_difference"]


def test_a_command_completes_the_layouts_of_its_subject_only() -> None:
    assert completed("bash", "delta", "--layout", "") == about(
        "irregularity", "strokes", "evenness", "compressor", "pump", "gas cycle", "cylinders"
    )
    assert completed("bash", "turning", "--layout", "") == [
        "areas", "speed", "torques", "turning", "turning-path",
    ]  # fmt: skip
    assert completed("bash", "flywheel", "--layout", "") == ["flywheel", "flywheel-sizing"]
    assert completed("bash", "deadcentres", "--layout", "") == BEAMS
    assert completed("bash", "harmonics", "--layout", "h") == ["harmonics"]
    assert completed("bash", "balance", "--layout", "") == ["balance", "balance-angle", "balance-greatest"]
    assert completed("bash", "inertia", "--layout", "") == about(
        "inertia", "inertia errors", "rod masses", "pin masses", "rocker inertia"
    )
    assert completed("bash", "forces", "--layout", "") == about(
        "motion",
        "effort",
        "mass forces",
        "crank forces",
        "machine",
        "rod load",
        "tangent",
        "arc crank",
        "parallel crank",
        "coupled axles",
        "beam engine",
        "over path",
        "forces over path",
    )


def test_the_columns_are_those_of_the_mechanism_that_was_typed() -> None:
    words = ("table", "--mechanism", "arc", "--columns", "")
    assert set(completed("bash", *words)) == {"ratio", "phi", *arc_registry()}
    assert completed("bash", "table", "--layout", "parallel", "--columns", "p") == ["phi"]
    assert completed("bash", "table", "--mechanism", "p") == ["parallel"]
    points = ("table", "--mechanism", "arc", "--point", "0.5", "--columns", "path_al")
    assert completed("bash", *points) == ["path_along", "path_along_mm"]
    assert completed("bash", "plot", "--mechanism", "parallel", "--columns", "coupler_p") == ["coupler_path"]
    forces = ("plot", "--forces", "--eps", "4", "--columns", "crank_pin")
    assert completed("bash", *forces) == ["crank_pin_force", "crank_pin_force_n"]


def test_columns_of_an_engine_are_those_that_its_page_can_show() -> None:
    scopes = {key: quantity.of for key, quantity in engine_registry().items()}

    def keys(*chosen: str) -> set[str]:
        return {key for key, scope in scopes.items() if scope in chosen}

    axes = {"epsilon", "ratio"}
    assert set(completed("bash", "delta", "--columns", "")) == axes | keys("turn", "least", "greatest")
    assert set(completed("bash", "turning", "--columns", "")) == axes | {"phi"} | keys("angle", "turn")
    assert set(completed("bash", "flywheel", "--columns", "")) == axes | {"target"} | keys("flywheel")
    detail = axes | {"stroke"} | keys("turn", "least", "greatest", "stroke")
    assert set(completed("bash", "delta", "--layout", "delta-detail", "--columns", "")) == detail
    assert set(completed("bash", "delta", "--detail", "--columns", "")) == detail
    own = {column.key for column in layout("delta-verfahren").columns}
    words = ("delta", "--layout", "delta-verfahren", "--columns", "")
    assert set(completed("bash", *words)) == axes | own
    assert completed("bash", "delta", "--columns", "epsilon,mean") == [
        f"epsilon,{key}" for key in ("mean_force", "mean_pressure", "mean_pressure_kpa")
    ]


def test_engines_and_columns_of_the_balance_are_completed() -> None:
    assert completed("bash", "balance", "--engine", "box") == ["boxer-2", "boxer-4"]
    assert completed("bash", "balance", "--columns", "order,gr") == ["order,greatest", "order,greatest_n"]
    assert completed("bash", "harmonics", "--quantity", "") == ["x", "c", "p", "torque"]
    assert completed("bash", "table", "--layout", "harmonics", "--columns", "v") == ["value"]


def test_methods_of_an_engine_are_completed() -> None:
    assert completed("bash", "delta", "--method", "") == list(ENGINE_METHODS)
    assert completed("bash", "turning", "--meth") == ["--method"]


def test_names_of_the_other_options_are_completed() -> None:
    assert completed("bash", "table", "--lang", "") == list(LANGUAGES)
    assert completed("bash", "table", "--method", "") == list(METHODS)
    assert completed("bash", "table", "--decimal", "c") == ["comma"]
    assert completed("bash", "table", "--rounding", "half-e") == ["half-even"]
    assert completed("bash", "layouts", "--lang", "e") == ["en"]


@pytest.mark.parametrize(
    "words",
    [
        ("tabel", ""),
        ("table", "--layout", "nonsense", "--columns", "x_m"),
        ("table", "--ratio", "1:1", "--digits", "many", "--lang", "xx", "-f", "h"),
        ("table", "--foo", "--layout", ""),
    ],
)
def test_a_line_with_mistakes_is_completed_without_a_word_about_them(words: tuple[str, ...]) -> None:
    result = asked("bash", *words)
    assert (result.code, result.err) == (0, "")


@pytest.mark.parametrize("shell", SHELLS)
def test_every_shell_gets_its_script(shell: str) -> None:
    script = printed(_KURBEL_COMPLETE=f"{shell}_source").out
    assert f"_KURBEL_COMPLETE={shell}_complete" in script
    assert "python" not in script
    if shutil.which(shell):
        subprocess.run([shell, "-n"], input=script, text=True, check=True, capture_output=True)


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("kurbel table --layout roetscher-1", ["roetscher-112"]),
        ("kurbel table --columns phi,x_m", ["phi,x_mm"]),
        ("kurbel table --columns phi,x,psi_", ["phi,x,psi_return"]),
        ("kurbel table -f mark", ["markdown"]),
    ],
)
def test_fish_itself_completes(line: str, expected: list[str]) -> None:
    program = require("fish")
    script = f"_KURBEL_COMPLETE=fish_source kurbel | source; complete -C '{line}'"
    folder = Path(sys.executable).parent
    environment = {name: value for name, value in os.environ.items() if "KURBEL" not in name}
    environment["PATH"] = f"{folder}:{environment['PATH']}"
    run = subprocess.run(
        [program, "--no-config", "-c", script], check=True, capture_output=True, text=True, env=environment
    )
    assert run.stdout.split() == expected
