"""Engines of unlike cylinders from their files: against the torques of textbooks, summed over the angle."""

from __future__ import annotations

import re
import shlex
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from cli import printed, refusal
from gas import Gas
from places import ROOT

import kurbel
from kurbel.cli import COMMANDS
from kurbel.cli.app import command_of

SAMPLES = 400_000
MACHINES = ROOT / "examples" / "machines"


def path_and_speed(degrees: Any, ratio: float) -> tuple[Any, Any]:
    """The share of the stroke from the inner dead centre, and the piston's speed in R a radian."""
    angle = np.radians(degrees)
    slant = np.sqrt(1 - (ratio * np.sin(angle)) ** 2)
    return (1 - np.cos(angle) + (1 - slant) / ratio) / 2, np.sin(angle) * (1 + ratio * np.cos(angle) / slant)


def steam(degrees: Any, ratio: float, expansion: float, back: float) -> Any:
    """T in the force before cut-off, double-acting, by Mariotte's law."""
    share, speed = path_and_speed(degrees, ratio)
    share = np.where(degrees % 360 < 180, share, 1 - share)
    return (np.minimum(1.0, 1 / (expansion * np.maximum(share, 1e-12))) - back) * np.abs(speed)


def two_stroke(degrees: Any, ratio: float, compression: float, peak: float) -> Any:
    share, speed = path_and_speed(degrees, ratio)
    clearance = 1 / (compression - 1)
    out = peak * (clearance / (clearance + share)) ** 1.4
    back = ((1 + clearance) / (clearance + share)) ** 1.4
    return (np.where(degrees % 360 < 180, out, back) - 1) * speed


def compressor(degrees: Any, ratio: float, pressures: float, exponent: float, clearance: float) -> Any:
    """T in the suction pressure times the area, both ends alike."""
    share, speed = path_and_speed(degrees, ratio)
    behind = np.where(degrees % 360 < 180, share, 1 - share)
    expanding = pressures * (clearance / (clearance + behind)) ** exponent
    compressed = ((1 + clearance) / (clearance + 1 - behind)) ** exponent
    return (np.maximum(1.0, expanding) - np.minimum(pressures, compressed)) * np.abs(speed)


def inertia(degrees: Any, ratio: float) -> Any:
    """T of a reciprocating mass in m R² ω²."""
    angle = np.radians(degrees)
    _, speed = path_and_speed(degrees, ratio)
    step = 1e-5
    ahead, behind = (path_and_speed(degrees + np.degrees(one), ratio)[1] for one in (step, -step))
    assert angle.shape == speed.shape
    return -(ahead - behind) / (2 * step) * speed


def torque(name: str, degrees: Any) -> Any:
    """The torque on the shaft in N m of a machine as its file describes it."""
    if name == "compound":
        omega = 90 * np.pi / 30
        total = np.zeros_like(degrees)
        for lag, bore, pascals, expansion, back, mass in (
            (0, 0.4, 9e5, 2.5, 0.3, 400), (90, 0.64, 2.7e5, 2, 0.08, 520),
        ):  # fmt: skip
            own = (degrees - lag) % 360
            force = np.pi / 4 * bore**2 * pascals * steam(own, 0.2, expansion, back)
            total += 0.4 * (force + mass * 0.4 * omega**2 * inertia(own, 0.2))
        return total
    if name == "charged":
        engine = np.pi / 4 * 0.25**2 * 1.2e5 * 0.2 * two_stroke(degrees % 360, 1 / 4.5, 5, 20)
        pump = np.pi / 4 * 0.24**2 * 1e5 * 0.15 * compressor((degrees - 100) % 360, 1 / 4.5, 1.3, 1.3, 0.06)
        return engine + pump
    gas = Gas(6, 1.4, 30, 1, 1, 0.25)
    # On one pin the second fires 45° after its first chance, a turn later.
    total = np.zeros_like(degrees)
    for lag in (0, 405):
        pressure, slope = gas.over_angle((degrees - lag) % 720)
        total += np.pi / 4 * 0.08**2 * 1e5 * 0.045 * (pressure - 1) * slope
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


def test_the_whole_cycle_of_a_four_stroke_machine_is_printed() -> None:
    page = printed("turning", "--machine", str(MACHINES / "v2.toml"), "--step=90", "-f", "csv")
    assert [record["phi"] for record in page.records()] == [str(90 * step) for step in range(9)]


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
    assert kurbel.delta_table(ratio="1:5", stroke=0.8, cylinder=numbers, digits=7).records.rows
    table = kurbel.delta_table(ratio="1:5", stroke=0.8, cylinder=described, columns="delta", digits=7)
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


def test_what_a_cylinder_says_outdoes_what_all_have(tmp_path: Path) -> None:
    path = tmp_path / "machine.toml"
    path.write_text(
        '[crank]\nstroke = "800mm"\nrod = "2000mm"\n[steam]\neps = 3\nback = "10%"\nbore = "300mm"\n'
        'pressure = "8bar"\n[[cylinder]]\n[[cylinder]]\nratio = "1:4"\nangle = 90\npressure_ratio = 2\n'
        'suction_pressure = "1bar"\n',
        encoding="utf-8",
    )
    notes = printed("delta", "--machine", str(path), "--lang=en").out
    flat = " ".join(notes.split())
    assert "Cylinder 1: Q = π/4 d² p, d = 300 mm, p = 800 kPa; stroke 800 mm, R:L = 1:5; ε = 3" in flat
    assert "Cylinder 2: Q = π/4 d² p₁, d = 300 mm, p₁ = 100 kPa; stroke 800 mm, R:L = 1:4; 90° behind" in flat


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("[[cylinder]]\neps = 2\n[[cylinder]]\nboer = 3\n",
         'line 4: there is no entry of [cylinder], "boer" (did you mean bore?)'),
        ("[[cylinder]]\neps = 2\n[[cylinder]]\nbore = true\n",
         'line 4: cylinder.bore is true; it must be text such as "600mm", a number'),
        ("[cylinder]\neps = 2\n", "cylinder is a table; write [[cylinder]]"),
        ("cylinder = []\n", "cylinder is empty; write a [[cylinder]] for each"),
    ],
)  # fmt: skip
def test_what_a_file_says_amiss_of_a_cylinder_is_named_with_its_line(
    text: str, said: str, tmp_path: Path
) -> None:
    path = tmp_path / "machine.toml"
    path.write_text(text, encoding="utf-8")
    sentence = refusal("delta", "--machine", str(path), code=1)
    assert sentence.startswith(str(path))
    assert said in sentence


@pytest.mark.parametrize(
    ("entry", "said"),
    [
        ("eps = 0.5", "expansion ratio ε is 0.5; it must be 1"),
        ('eps = 2\nangle = "x"', 'angle "x" is not an angle in degrees'),
        ('eps = 2\nbank = "x"', 'bank "x" is not an angle in degrees'),
    ],
)
def test_a_cylinder_that_cannot_be_is_named_with_its_line(entry: str, said: str, tmp_path: Path) -> None:
    path = tmp_path / "machine.toml"
    path.write_text(f"[[cylinder]]\neps = 2\n\n[[cylinder]]\n{entry}\n", encoding="utf-8")
    sentence = refusal("delta", "--machine", str(path))
    assert sentence.startswith(f"{path}, line 4: cylinder 2: {said}")


def test_an_engine_of_one_cylinder_is_called_so() -> None:
    assert " der Maschine mit einem Zylinder;" in " ".join(printed("delta", "--cylinder=eps=4").out.split())


@pytest.mark.parametrize(
    ("cylinders", "said"),
    [
        (("bore=400mm",), "cylinder 1 has no load; give it eps, card, pressure_ratio, pump or compression"),
        (("eps=4", "eps=3"), "cylinder 1 needs its bore, its pressure and its stroke to be compared"),
        (("eps=4 back=2", "eps=3"), "cylinder 1: back pressure b is 2; it must lie within 0..1"),
        (("eps=2..4",), "cylinder 1: it has 3 loads; a cylinder has one"),
        (("eps=2 fires=1", "eps=2"), "cylinder 2 has no fires; give all their places, or none"),
        (("eps=2 fires=1", "eps=2 fires=3"), "fires has the places 1, 3; each of 1 to 2 must be there"),
        (("eps=2 fires=1", "compression=6 peak_pressure=30 fires=2"), "whose cycles have as many strokes"),
        (("eps=4 rocker=6",), "cylinder 1: --rocker does not belong to the straight crank; it is for"),
        (("eps",), "eps of a cylinder has no value"),
        (("eps=4 bore=1m eps=3",), "eps of a cylinder is given twice; leave one out"),
        (("eps=4 single-acting=no",), "single_acting of a cylinder is no; it must be true or false"),
        (("epsilon=4",), 'there is no entry of a cylinder, "epsilon"'),
    ],
)  # fmt: skip
def test_cylinders_that_are_none_are_refused(cylinders: tuple[str, ...], said: str) -> None:
    assert said in refusal("delta", *(f"--cylinder={one}" for one in cylinders))


@pytest.mark.parametrize(
    "option", ["--pressure-ratio=3", "--heat=5", "--suction-loss=3%", "--pump", "--two-stroke"]
)
def test_what_describes_a_load_that_no_cylinder_has_is_refused(option: str) -> None:
    name = option.partition("=")[0]
    assert f"{name} says nothing about the cylinders" in refusal("delta", "--cylinder=eps=4", option)


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
    if name == "compound":
        own = [np.pi / 4 * 0.4**2 * 9e5 * 0.4 * steam(degrees, 0.2, 2.5, 0.3).mean(), None]
        assert [(row["lag"], row["bore_mm"], row["stroke_mm"]) for row in rows[:2]] == [
            ("0", "400", "800"), ("90", "640", "800"),
        ]  # fmt: skip
        turns = 90 / 60
    else:
        own = [np.pi / 4 * 0.25**2 * 1.2e5 * 0.2 * two_stroke(degrees, 1 / 4.5, 5, 20).mean(), None]
        turns = 200 / 60
    own[1] = whole - own[0]
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


def test_every_command_takes_the_cylinders_of_a_machine_or_refuses_them(tmp_path: Path) -> None:
    options = {name: {param.name for param in command_of(name).params} for name in COMMANDS}
    one = [name for name, own in options.items() if {"machine", "eps"} <= own and "cylinder" not in own]
    assert one == ["pressures", "power", "construct"]
    machine = ("--machine", str(MACHINES / "compound.toml"))
    as_said = tmp_path / "as-said.toml"
    crank = '[crank]\nratio = "1:5"\nstroke = "8dm"\nspeed = "2/s"\n'
    as_said.write_text(
        crank + '[steam]\nbore = "4dm"\npressure = "9bar"\neps = 2\n[masses]\nreciprocating = "9kg"\n'
    )
    for words in (("pressures",), ("construct", "radinger"), ("power",)):
        assert "bore into [steam] and reciprocating into [masses]" in refusal(*words, *machine, code=1)
        assert not printed(*words, "--machine", str(as_said)).err
    for words in (("pressures",), ("construct", "radinger")):
        assert "is about one" in refusal(*words, *machine, code=1)
    for name in ("balance", "power"):
        assert "is about cylinders alike" in refusal(name, *machine, code=1)
    assert "are of one cylinder" in refusal("plot", "--pressures", *machine, "-o", "none.svg")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("--eps=4 --of=2", "--of names one of several cylinders; add each as --cylinder, or leave it out"),
        ("--cylinder=eps=4 --of=2", "cylinder 2 was asked for, and the engine has 1"),
    ],
)
def test_a_cylinder_that_there_is_not_has_no_forces(words: str, said: str) -> None:
    assert said in refusal("forces", *words.split())


def test_lists_of_cylinders_have_no_cranks_and_no_layout_of_a_load() -> None:
    assert "leave one out" in refusal("delta", "--cylinder=eps=2", "--cranks=0;90")
    assert "is of cylinders alike; use --layout delta-detail" in refusal(
        "delta", "--cylinder=eps=2", "--layout=weisbach-150"
    )


def test_the_commands_of_the_page_on_cylinders_print(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    text = (ROOT / "docs" / "subjects" / "cylinders.md").read_text(encoding="utf-8").replace("\\\n", " ")
    commands = [line for line in text.splitlines() if line.startswith("kurbel ")]
    assert len(commands) == 6
    for command in commands:
        assert printed(*shlex.split(command)[1:]).out
    ((typed, shown),) = re.findall(r"```console\n\$ kurbel (.*)\n((?:.*\n)*?)```", text)
    assert printed(*shlex.split(typed)).out == shown


def test_a_cylinder_that_the_shaft_drives_is_named_beside_one_that_drives() -> None:
    machine = str(ROOT / "examples" / "machines" / "charged.toml")
    for command in ("delta", "turning"):
        notes = " ".join(printed(command, "--machine", machine, "--lang=en").out.split())
        assert "The shaft drives the piston of cylinder 2: T counts as the crank turns" in notes
        assert "; compression by p Vⁿ" in notes
    engine = str(ROOT / "examples" / "machines" / "v2.toml")
    assert "shaft drives" not in printed("delta", "--machine", engine, "--lang=en").out
