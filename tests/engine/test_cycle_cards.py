"""Cards over two turns: against gas engines written from the textbook and integrated over the crank angle."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from random import Random
from typing import Any, NamedTuple

import numpy as np
import pytest
from cli import printed
from machines import Machine, Slide
from strokes import Stroke

SAMPLES = 400_000


class Gas(NamedTuple):
    """A four-stroke cylinder: volumes compressed, exponent, pressures in bar; rod ratio and offset."""

    compression: float
    exponent: float
    peak: float
    exhaust: float
    suction: float
    ratio: float
    offset: float = 0.0

    def pressure(self, stroke: int, share: Any) -> Any:
        """The pressure at a share of the stroke in the direction of travel."""
        clearance = 1 / (self.compression - 1)
        if stroke == 0:
            return self.peak * (clearance / (clearance + share)) ** self.exponent
        if stroke == 3:
            whole = 1 + clearance
            return self.suction * (whole / (whole - share)) ** self.exponent
        return (self.exhaust if stroke == 1 else self.suction) + 0 * share

    @property
    def machine(self) -> Machine:
        """The engine against 1 bar on the other side, in units of its greatest pressure."""

        def stroke(index: int) -> Stroke:
            return Stroke(lambda share: (-1) ** index * (self.pressure(index, share) - 1) / self.peak)

        return Machine(Slide(1 / self.ratio, self.offset), tuple(map(stroke, range(4))), {})


def drawn(seed: int) -> Gas:
    random = Random(seed)
    compression, exponent = random.uniform(4, 12), random.uniform(1.1, 1.4)
    return Gas(
        compression, exponent, random.uniform(1.5, 3) * compression**exponent, random.uniform(1.02, 1.2),
        random.uniform(0.8, 0.98), 1 / random.randint(3, 6),
    )  # fmt: skip


HEAD = "position,p_expansion [bar],p_exhaust [bar],p_suction [bar],p_compression [bar]"


def by_position(gas: Gas, count: int, decimals: int = 5) -> str:
    def line(position: float) -> str:
        travelled = (position, 1 - position, position, 1 - position)
        pressures = (gas.pressure(stroke, share) for stroke, share in enumerate(travelled))
        return ",".join([f"{position:.8f}", *(f"{one:.{decimals}f}" for one in pressures)])

    # Nearer together about the dead centre, where the expansion is steep.
    return "\n".join([HEAD, *(line((index / count) ** 2) for index in range(count + 1))])


def by_angle(gas: Gas, step: float, first: float, head: str = "angle [°],p [bar]") -> str:
    degrees = np.arange(first, first + 720, step)
    stroke, share = gas.machine.stroke(degrees)
    pressure = np.choose(stroke, [gas.pressure(one, share) for one in range(4)])
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
    assert abs(value - truth) <= error + 0.5 * 10.0 ** -len(record[key].partition(".")[2])
    assert error < 0.02 * max(abs(truth), 0.05)


@pytest.mark.parametrize("seed", [1, 4])
@pytest.mark.parametrize("form", ["position", "angle from 0°", "angle from -360°"])
def test_a_card_over_two_turns_turns_the_engine_as_the_textbook(seed: int, form: str, tmp_path: Path) -> None:
    gas = drawn(seed)
    text = by_position(gas, 40 + 20 * seed) if form == "position" else by_angle(
        gas, 1.0, 0.0 if form.endswith(" 0°") else -360.0
    )  # fmt: skip
    card, truth = written(tmp_path, text), gas.machine.turn
    columns = "--columns=mean_force,delta"
    (record,) = printed("delta", *options(gas, card), columns, "--digits=7").records()
    check(record, "mean_force", truth.mean)
    check(record, "delta", truth.delta)
    angles = (50, 200, 410, 660)
    page = printed(
        "turning", *options(gas, card), "--angle=50;200;410;660", "--columns=phi,energy", "--digits=7"
    )
    for energy, one in zip(truth.at(truth.energy, angles), page.records(), strict=True):
        check(one, "energy", energy)


def test_pressures_over_the_angle_count_by_the_dead_centres_of_an_offset_crank(tmp_path: Path) -> None:
    gas = drawn(3)._replace(ratio=0.25, offset=0.5)
    card, truth = written(tmp_path, by_angle(gas, 0.5, 0.0)), gas.machine.turn
    columns = ("--offset=0.5", "--columns=mean_force,delta", "--digits=7")
    (record,) = printed("delta", *options(gas, card), *columns).records()
    check(record, "mean_force", truth.mean)
    check(record, "delta", truth.delta)


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
    rows = [f"{one:.1f};{bar:.6f}" for one, bar in zip(degrees, pressure(degrees), strict=True)]
    # The first angle of the next cycle may be written or not.
    closed = f"{360 * turns + 0.3:.1f};{rows[0].partition(';')[2]}"
    (record,), again = (
        printed("delta", *options(gas, card), "--columns=mean_force", "--digits=7").records()
        for end in ([], [closed])
        if (card := written(tmp_path, "\n".join(["angle [°];p [bar]", *rows, *end])))
    )
    assert again == [record]
    fine = (np.arange(SAMPLES) + 0.5) * 360 * turns / SAMPLES
    greatest, speed = max(pressure(degrees)), gas.machine.drive.motion(np.radians(fine)).speed
    check(record, "mean_force", float(((pressure(fine) - 1) / greatest * speed).mean()))
