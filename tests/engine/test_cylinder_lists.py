"""Engines of unlike cylinders from their files: against the torques of textbooks, summed over the angle."""

from __future__ import annotations

import re
import shlex
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from cli import printed
from machines import machine
from places import ROOT

import kurbel

SAMPLES = 400_000
MACHINES = ROOT / "examples" / "machines"


# By machine its cylinders: the angle by which each follows, its bore and stroke in m, its unit of
# pressure in bar and what else is said of it.
CYLINDERS: dict[str, list[tuple[float, float, float, float, dict[str, Any]]]] = {
    "compound": [
        (0, 0.4, 0.8, 9, {"eps": "2.5", "back": "0.3", "ratio": "1:5", "reciprocating": "400kg"}),
        (90, 0.64, 0.8, 2.7, {"eps": "2", "back": "0.08", "ratio": "1:5", "reciprocating": "520kg"}),
    ],
    "charged": [
        (0, 0.25, 0.4, 1.2, {
            "compression": "5", "peak_pressure": "20", "two_stroke": True, "ratio": "1:4.5",
        }),
        (100, 0.24, 0.3, 1, {
            "pressure_ratio": "1.3", "exponent": "1.3", "clearance": "0.06", "ratio": "1:4.5",
        }),
    ],
    # On one pin the second fires 45° after its first chance, a turn later.
    "v2": [
        (lag, 0.08, 0.09, 1, {"compression": "6", "peak_pressure": "30", "ratio": "1:4"}) for lag in (0, 405)
    ],
}  # fmt: skip


def torque(name: str, degrees: Any, only: int | None = None) -> Any:
    """Return the torque on the shaft in N m of a machine as its file describes it, or of one cylinder."""
    total = np.zeros_like(degrees)
    for number, (lag, bore, stroke, pressure, said) in enumerate(CYLINDERS[name]):
        sizes = {"bore": f"{bore}m", "stroke": f"{stroke}m"}
        kind = "pressure" if "eps" in said else "suction_pressure"
        speed = {"speed": "90/min"} if "reciprocating" in said else {}
        own = machine(**said, **sizes, **speed, **{kind: f"{pressure}bar"})
        if only in (None, number):
            unit = np.pi / 4 * bore**2 * pressure * 1e5 * stroke / 2
            total += own.force((degrees - lag) % own.cycle) * unit
    return total


@pytest.mark.parametrize(("name", "turns"), [("compound", 1), ("charged", 1), ("v2", 2)])
def test_a_machine_of_unlike_cylinders_turns_as_its_torques_add_up(name: str, turns: int) -> None:
    machine = ("--machine", str(MACHINES / f"{name}.toml"))
    degrees = (np.arange(SAMPLES) + 0.5) * 360 * turns / SAMPLES
    moments = torque(name, degrees)
    work = np.cumsum(moments - moments.mean()) * (2 * np.pi * turns / SAMPLES)
    (row,) = printed(
        "flywheel", *machine, "--delta=1:50", "--columns=mean_torque,swing", "-f", "csv"
    ).records()
    assert float(row["mean_torque"]) == pytest.approx(moments.mean(), rel=6e-5)
    assert float(row["swing"]) == pytest.approx(np.ptp(work), rel=6e-5)
    columns = "--columns=phi,tangential,energy"
    page = printed(
        "turning", *machine, columns, "--angle=20;130;250;330", "--digits=6", "-f", "csv"
    ).records()
    scale = moments.mean() / float(
        printed("delta", *machine, "--columns=mean_force", "--digits=9", "-f", "csv").records()[0][
            "mean_force"
        ]
    )
    for one in page:
        at = np.array([float(one["phi"])])
        assert float(one["tangential"]) == pytest.approx(torque(name, at)[0] / scale, abs=3e-6, rel=1e-5)
        assert float(one["energy"]) == pytest.approx(
            np.interp(at, degrees, work)[0] / scale, abs=2e-5, rel=1e-4
        )


@pytest.mark.parametrize(
    ("number", "own"),
    [
        ("1", ("--eps=2.5", "--back=30%", "--bore=400mm", "--pressure=9bar", "--reciprocating=400kg")),
        ("2", ("--eps=2", "--back=8%", "--bore=640mm", "--pressure=2.7bar", "--reciprocating=520kg")),
    ],
)
def test_forces_of_a_cylinder_are_those_that_it_has_alone(number: str, own: tuple[str, ...]) -> None:
    words = ("--angle=50;200", "--columns=phi,rod_force_n", "-f", "csv")
    of = ("--machine", str(MACHINES / "compound.toml"), f"--of={number}")
    several = printed("forces", *of, *words).records()
    common = ("--stroke=800mm", "--ratio=1:5", "--speed=90/min")
    alone = printed("forces", *own, *common, *words).records()
    assert [one["rod_force_n"] for one in several] == [one["rod_force_n"] for one in alone]


def test_conditions_are_on_the_forces_of_the_cylinder_that_is_named() -> None:
    machine, words = ("--machine", str(MACHINES / "compound.toml")), ("--where=guide_force=max", "-f", "csv")
    columns = "--columns=phi,guide_force_n"
    of_second = printed("solve", *machine, "--of=2", columns, *words).records()
    alone = printed(
        "solve", "--eps=2", "--back=8%", "--bore=640mm", "--pressure=2.7bar", "--reciprocating=520kg",
        "--stroke=800mm", "--ratio=1:5", "--speed=90/min", columns, *words,
    ).records()  # fmt: skip
    assert [(one["phi"], one["guide_force_n"]) for one in of_second] == [
        (one["phi"], one["guide_force_n"]) for one in alone
    ]
    # Of all cylinders, the second of which follows by 90°.
    first, second = (
        printed("solve", *machine, f"--of={number}", "--where=torque=max", "--columns=phi,torque_nm",
                "-f", "csv").records()[0] for number in (1, 2)
    )  # fmt: skip
    assert first["torque_nm"] == second["torque_nm"]
    assert (float(first["phi"]) - float(second["phi"])) % 360 == pytest.approx(90, abs=1e-4)
    assert "Forces and φ of cylinder 1; torque" in printed("solve", *machine, words[0], "--lang=en").out


def test_a_file_a_text_and_python_describe_one_engine(tmp_path: Path) -> None:
    entries = (
        "bore=400mm pressure=9bar eps=2.5 back=0.3",
        "angle=90 bore=640mm pressure=2.7bar eps=2 back=0.08",
    )
    common = ("--ratio=1:5", "--stroke=800mm")
    words = ("--columns=delta", "--digits=7", "-f", "csv")
    typed = printed("delta", *common, *(f"--cylinder={one}" for one in entries), *words).out
    described = [dict(entry.split("=") for entry in one.split()) for one in entries]
    numbers: list[dict[str, Any]] = [
        {"bore": 0.4, "pressure": 9e5, "eps": 2.5, "back": 0.3},
        {"angle": 90, **described[1]},
    ]
    assert kurbel.delta(ratio="1:5", stroke=0.8, cylinder=numbers, digits=7).records.rows
    table = kurbel.delta(ratio="1:5", stroke=0.8, cylinder=described, columns="delta", digits=7)
    assert kurbel.typeset(table, "csv") == typed
    tables = (
        "\n".join(["[[cylinder]]", *(f'{key} = "{value}"' for key, value in one.items())])
        for one in described
    )
    path = tmp_path / "machine.toml"
    path.write_text("\n".join(['[crank]\nratio = "1:5"\nstroke = "800mm"', *tables]), encoding="utf-8")
    assert printed("delta", "--machine", str(path), *words).out == typed


def test_cylinders_alike_are_those_of_cranks() -> None:
    common = ("--ratio=1:5", "--stroke=800mm", "--bore=400mm", "--pressure=9bar", "--eps=3")
    words = ("--columns=delta,mean_force", "--digits=6", "-f", "csv")
    listed = [f"--cylinder=angle={angle}" for angle in (0, 120, 240)]
    (several,) = printed("delta", *common, *listed, *words).records()
    (alike,) = printed("delta", "--ratio=1:5", "--eps=3", "--cranks=0;120;240", *words).records()
    assert (several["delta"], several["mean_force"]) == (alike["delta"], alike["mean_force"])


@pytest.mark.parametrize("fires", [("1", "2", "4", "3"), ("1", "4", "2", "3")])
def test_places_in_the_firing_order_choose_the_turn_of_each_cylinder(fires: tuple[str, ...]) -> None:
    # Cranks 0, 180, 180, 0 fire as 1-2-4-3 and 1-3-4-2: by the cylinders' places 1, 2, 4, 3 and 1, 4, 2, 3.
    common = ("--ratio=1:4", "--stroke=90mm", "--bore=80mm", "--suction-pressure=1bar", "--compression=6",
              "--peak-pressure=30", "--columns=delta", "--digits=6", "-f", "csv")  # fmt: skip
    listed = [
        f"--cylinder=angle={angle} fires={place}"
        for angle, place in zip((0, 180, 180, 0), fires, strict=True)
    ]
    lags = [180 * (int(place) - 1) for place in fires]
    (several,) = printed("delta", *common, *listed).records()
    (explicit,) = printed("delta", *common, *(f"--cylinder=angle={lag}" for lag in lags)).records()
    assert several["delta"] == explicit["delta"]


@pytest.mark.parametrize(
    ("order", "banks"), [("1-3-2", (0, 0, 0)), ("1-5-2-4-3", (0, 0, 0, 0, 0)), ("1-2-4-3", (0, 60, 0, 60))]
)
def test_cranks_that_follow_as_an_order_of_firing_says_make_an_engine_that_fires_in_it(
    order: str, banks: tuple[int, ...]
) -> None:
    axes = ";".join(map(str, banks))
    star = printed("firing", "--order", order, f"--banks={axes}", "--columns=cylinder,follows", "-f", "csv")
    follows = {int(one["cylinder"]): one["follows"] for one in star.records()}
    common = ("--ratio=1:4", "--stroke=90mm", "--suction-pressure=1bar", "--compression=6", "--heat=8")
    bores = [60 + 10 * number for number in range(len(banks))]
    listed = [
        f"--cylinder=angle={follows[number]} bank={bank} bore={bore}mm"
        for number, (bank, bore) in enumerate(zip(banks, bores, strict=True), 1)
    ]
    words = ("--columns=phi,tangential", "--digits=8", "-f", "csv")
    several = printed("turning", *common, *listed, "--step=12", *words).records()
    single = printed("turning", *common, "--cylinder=bore=60mm", "--step=12", *words).records()
    alone = {float(one["phi"]): float(one["tangential"]) for one in single}
    # In the order every piston does what the first does, as many intervals later, by its own area.
    lags = {int(number): 720 * place / len(banks) for place, number in enumerate(order.split("-"))}
    for one in several:
        parts = [
            (bores[number - 1] / bores[0]) ** 2 * alone[(float(one["phi"]) - lag) % 720]
            for number, lag in lags.items()
        ]
        np.testing.assert_allclose(float(one["tangential"]), sum(parts), rtol=0, atol=1e-7)


@pytest.mark.parametrize(("said", "share"), [("false", 1), ("true", 0.5)])
def test_a_cylinder_that_is_said_not_to_be_single_acting_works_at_both_ends(said: str, share: float) -> None:
    own = printed("delta", f"--cylinder=eps=4 single_acting={said}", "--columns=mean_force", "-f", "csv")
    both = printed("delta", "--eps=4", "--columns=mean_force", "-f", "csv")
    found, whole = (float(one.records()[-1]["mean_force"]) for one in (own, both))
    assert found == pytest.approx(whole * share, abs=1e-5)


@pytest.mark.parametrize("name", ["compound", "charged"])
def test_the_list_of_cylinders_has_the_share_of_each_in_the_torque(name: str) -> None:
    machine = ("--machine", str(MACHINES / f"{name}.toml"))
    columns = "--columns=cylinder,lag,bore_mm,stroke_mm,mean_torque,power,mean_share"
    rows = printed("delta", "--layout=cylinders", *machine, columns, "-f", "csv").records()
    degrees = (np.arange(SAMPLES) + 0.5) * 360 / SAMPLES
    whole = float(torque(name, degrees).mean())
    own = [float(torque(name, degrees, number).mean()) for number in (0, 1)]
    turns = {"compound": 90, "charged": 200}[name] / 60
    for row, true in zip(rows, [*own, whole], strict=True):
        assert float(row["mean_torque"]) == pytest.approx(true, abs=0.06)
        assert float(row["power"]) == pytest.approx(true * 2 * np.pi * turns / 1000, abs=6e-4)
        assert float(row["mean_share"]) == pytest.approx(100 * true / whole, abs=6e-3)


def test_shares_of_cylinders_alike_are_exact() -> None:
    words = (
        "--eps=4",
        "--cranks=0;45;90;135;180;225;270;315",
        "--columns=mean_share",
        "--digits=0",
        "-f",
        "csv",
    )
    rows = printed("delta", "--layout=cylinders", *words).records()
    assert [row["mean_share"] for row in rows] == ["13"] * 8 + ["100"]


def test_the_torque_is_that_of_all_whichever_cylinder_is_seen() -> None:
    words = ("--machine", str(MACHINES / "compound.toml"), "--columns=phi,torque_nm", "-f", "csv")
    first = printed("forces", *words, "--angle=130").records()
    second = printed("forces", *words, "--of=2", "--angle=40").records()
    assert first[0]["torque_nm"] == second[0]["torque_nm"]


def test_the_commands_of_the_page_on_cylinders_print(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    text = (ROOT / "docs" / "subjects" / "cylinders.md").read_text(encoding="utf-8").replace("\\\n", " ")
    commands = [line for line in text.splitlines() if line.startswith("kurbel ")]
    assert len(commands) == 6
    for command in commands:
        assert printed(*shlex.split(command)[1:]).out
    ((typed, shown),) = re.findall(r"```console\n\$ kurbel (.*)\n((?:.*\n)*?)```", text)
    assert printed(*shlex.split(typed)).out == shown
