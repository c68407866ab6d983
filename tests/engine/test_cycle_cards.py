"""Cards over two turns: against gas engines written from the textbook and summed over the crank angle."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from cli import printed, refusal
from gas import Gas, drawn

from kurbel.drive.crank import Crank, known
from kurbel.engine.card.file import read_card
from kurbel.engine.engine import Diagram, Engine
from kurbel.engine.turn import turn_of

SAMPLES = 400_000
BAR = 1e5


class Summed(NamedTuple):
    """Mean tangential force in Q, δ, and the excess energy at an angle, by sums over the angle."""

    mean: float
    delta: float
    energy: Callable[[float], float]


def summed(gas: Gas, other: float, turns: int = 2) -> Summed:
    """Sum over a cycle of so many turns, of which the first two are the engine's."""
    begin = gas.dead_centres[0]
    degrees = begin + (np.arange(SAMPLES) + 0.5) * 360 * turns / SAMPLES
    pressure, slope = gas.over_angle(degrees)
    force = (pressure - other) / gas.peak * slope
    energy = np.concatenate([[0.0], np.cumsum(force - force.mean())]) * (2 * np.pi * turns / SAMPLES)
    ends = begin + np.arange(SAMPLES + 1) * 360 * turns / SAMPLES
    return Summed(
        float(force.mean()),
        float((energy.max() - energy.min()) / force.mean()),
        lambda angle: float(np.interp(angle, ends, energy)),
    )


HEAD = "position,p_expansion [bar],p_exhaust [bar],p_suction [bar],p_compression [bar]"


def by_position(gas: Gas, count: int, decimals: int = 5) -> str:
    def line(position: float) -> str:
        travelled = (position, 1 - position, position, 1 - position)
        pressures = (gas.pressure(stroke, share) for stroke, share in enumerate(travelled))
        return ",".join([f"{position:.8f}", *(f"{one:.{decimals}f}" for one in pressures)])

    # Nearer together about the dead centre, where the expansion is steep.
    return "\n".join([HEAD, *(line((index / count) ** 2) for index in range(count + 1))])


def by_angle(gas: Gas, step: float, first: float, head: str = "angle [°],p [bar]") -> str:
    begin = gas.dead_centres[0]
    degrees = np.arange(first, first + 720, step)
    pressure, _ = gas.over_angle((degrees - begin) % 720 + begin)
    return "\n".join([head, *(f"{one:.4f},{bar:.5f}" for one, bar in zip(degrees, pressure, strict=True))])


def written(folder: Path, text: str) -> str:
    path = folder / "gas.csv"
    path.write_text(text, encoding="utf-8")
    return str(path)


def options(gas: Gas, card: str) -> Sequence[str]:
    return (f"--card={card}", "--single-acting", "--other-side=1bar", f"--ratio={gas.ratio!r}", "-f", "csv")


def check(record: dict[str, str], key: str, truth: float) -> None:
    """Check that the error covers the truth, and that not all is given up."""
    value, error = float(record[key]), float(record[f"{key}_error"])
    decimals = len(record[key].partition(".")[2])
    assert abs(value - truth) <= error + 0.5 * 10.0**-decimals
    assert error < 0.02 * max(abs(truth), 0.05)


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("form", ["position", "angle from 0°", "angle from -360°"])
def test_a_card_over_two_turns_turns_the_engine_as_the_textbook(seed: int, form: str, tmp_path: Path) -> None:
    gas = drawn(seed)
    text = by_position(gas, 40 + 20 * seed) if form == "position" else by_angle(
        gas, 1.0, 0.0 if form.endswith(" 0°") else -360.0
    )  # fmt: skip
    card, truth = written(tmp_path, text), summed(gas, 1.0)
    columns = "--columns=mean_force,delta"
    (record,) = printed("delta", *options(gas, card), columns, "--digits=7").records()
    check(record, "mean_force", truth.mean)
    check(record, "delta", truth.delta)
    angles = (50, 200, 410, 660)
    page = printed(
        "turning", *options(gas, card), "--angle=50;200;410;660", "--columns=phi,energy", "--digits=7"
    )
    for angle, one in zip(angles, page.records(), strict=True):
        check(one, "energy", truth.energy(angle))


def test_pressures_over_the_angle_count_by_the_dead_centres_of_an_offset_crank(tmp_path: Path) -> None:
    gas = drawn(3)._replace(ratio=0.25, offset=0.5)
    diagram = Diagram(read_card(written(tmp_path, by_angle(gas, 0.5, 0.0))), BAR)
    engine = Engine(Crank(Fraction(1, 4), Fraction(1, 2)), diagram, double=False)
    turn, truth = turn_of(engine, "exact"), summed(gas, 1.0)
    scale = gas.peak * BAR / float(known(engine.pressure))
    assert float(turn.mean_force()) / scale == pytest.approx(truth.mean, rel=2e-3)
    assert float(turn.irregularity()) == pytest.approx(truth.delta, rel=2e-3)


def test_a_card_of_one_turn_followed_by_an_idle_turn_halves_the_mean_force(tmp_path: Path) -> None:
    gas = drawn(1)
    lines = by_position(gas, 60).splitlines()[1:]
    idle = [",".join([*line.split(",")[:3], "1.00000", "1.00000"]) for line in lines]
    working = [",".join(line.split(",")[:3]) for line in lines]
    head = "position,p_forward [bar],p_return [bar]"
    means = []
    for text in ("\n".join([HEAD, *idle]), "\n".join([head, *working])):
        given = options(gas, written(tmp_path, text))
        (record,) = printed("delta", *given, "--columns=mean_force", "--digits=5").records()
        means.append(float(record["mean_force"]))
    assert means[0] == pytest.approx(means[1] / 2, abs=6e-6)


@pytest.mark.parametrize("turns", [1, 2])
def test_smooth_pressures_over_the_angle_do_the_work_of_their_sum(turns: int, tmp_path: Path) -> None:
    gas = drawn(2)

    def pressure(degrees: Any) -> Any:
        angle = np.radians(degrees)
        whole = 6 + 3 * np.cos(angle) + 1.5 * np.sin(angle) + 0.7 * np.sin(3 * angle)
        return whole + (turns - 1) * np.sin(angle / 2 + 0.3)

    degrees = np.arange(0.3, 360 * turns, 1.0)
    rows = (f"{one:.1f};{bar:.6f}" for one, bar in zip(degrees, pressure(degrees), strict=True))
    card = written(tmp_path, "\n".join(["angle [°];p [bar]", *rows]))
    (record,) = printed("delta", *options(gas, card), "--columns=mean_force", "--digits=7").records()
    fine = (np.arange(SAMPLES) + 0.5) * 360 * turns / SAMPLES
    greatest = max(pressure(degrees))
    check(record, "mean_force", float(((pressure(fine) - 1) / greatest * gas.place(fine)[1]).mean()))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("angle,p [bar]\n" + "\n".join(f"{one},3" for one in range(0, 300, 10)),
         "the angles cover 0°..290°; they must cover one turn, 360°, or the two turns of four strokes, 720°"),
        ("angle,p [bar]\n" + "\n".join(f"{one % 50},3" for one in range(0, 720, 10)),
         "line 7: angle 0° comes after 40°; angles must rise"),
        ("angle [rad],p [bar]\n0,1", 'angle has the unit "rad"; crank angles are in degrees, °'),
        ("angle,q [bar]\n0,1", "there is no column p; the heads are angle, q [bar], and a card needs"),
        (HEAD.replace(",p_suction [bar]", ""), "there is no column p_suction"),
        ("\n".join([HEAD, *(f"{one / 9:.4f},3,1,1,1" for one in range(9))]), "the positions cover 0..0.8889"),
        ("angle,p [bar]\n" + "\n".join(f"{one},0" for one in range(0, 720, 10)), "the greatest p is 0 Pa"),
    ],
)  # fmt: skip
def test_what_is_no_cycle_is_refused_with_its_line(text: str, said: str, tmp_path: Path) -> None:
    card = written(tmp_path, text)
    assert said in refusal("delta", f"--card={card}", "--single-acting", "--other-side=1bar", code=1)


def test_a_card_over_two_turns_is_of_one_side_of_the_piston(tmp_path: Path) -> None:
    card = written(tmp_path, by_angle(drawn(0), 2.0, 0.0))
    assert "works on one side of the piston; add --single-acting" in refusal("delta", f"--card={card}")
