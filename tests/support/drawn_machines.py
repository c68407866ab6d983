"""Random machines of every drive under every load, and how far off machines.py kurbel prints them."""

from __future__ import annotations

import argparse
import math
import random
from typing import Any

from machines import machine
from strokes import number, pressure_of

import kurbel

MECHANISMS = ("straight", "offset", "arc", "beam")
LOADS = ("steam", "compressor", "pump", "gas")
DIGITS = 5


class Draw:
    """Random machines as kurbel's options. Numbers are as they are typed: floats of few decimals."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)

    def number(self, low: float, high: float, places: int = 3) -> str:
        return f"{self.random.uniform(low, high):.{places}f}"

    def machine(self, mechanism: str, load: str) -> dict[str, Any]:
        """Return the options of a machine of this drive under this load."""
        options: dict[str, Any] = getattr(self, f"_{mechanism}")() | getattr(self, f"_{load}")()
        cranks = self.random.choice(("0", "0", "0;90", "0;120;240", "0;77.5"))
        if cranks != "0":
            options["cranks"] = cranks
        if self.random.random() < 0.4:
            return options | self.masses(load, options)
        if options.get("pump") == "double":
            # Without a bore nothing is counted in them.
            del options["suction_pressure"], options["delivery_pressure"]
        return options

    def _straight(self) -> dict[str, Any]:
        return {"ratio": f"1:{self.number(2.2, 8)}"}

    def _offset(self) -> dict[str, Any]:
        return {"ratio": f"1:{self.number(3, 8)}", "offset": self.number(-1.6, 1.6)}

    def _arc(self) -> dict[str, Any]:
        return {
            "mechanism": "arc", "ratio": f"1:{self.number(3, 6)}", "rocker": self.number(3, 9),
            "offset": self.number(-0.8, 0.8),
        }  # fmt: skip

    def _beam(self) -> dict[str, Any]:
        return {"mechanism": "beam", "ratio": f"1:{self.number(4, 8)}", "beam": self.number(2, 6)}

    def _steam(self) -> dict[str, Any]:
        return {
            "eps": self.number(1.1, 6, 2), "back": self.number(0, 0.12, 2),
            "exponent": self.random.choice(("1", "1", "1.13", "1.3")), "clearance": self.number(0, 0.1, 2),
            "single_acting": self.random.random() < 0.4,
        }  # fmt: skip

    def _compressor(self) -> dict[str, Any]:
        losses = self.random.choice((("0", "0"), (self.number(0, 0.1, 2), self.number(0, 0.1, 2))))
        left = {"clearance": self.number(0.01, 0.1, 2), "expansion_exponent": "1.15"}
        return {
            "pressure_ratio": self.number(1.5, 6, 2), "exponent": self.random.choice(("1", "1.2", "1.35")),
            **self.random.choice(({}, left)),
            "suction_loss": losses[0], "delivery_loss": losses[1],
            "single_acting": self.random.random() < 0.4,
        }  # fmt: skip

    def _pump(self) -> dict[str, Any]:
        kind = self.random.choice(("double", "single", "differential"))
        options = {
            "pump": kind, "suction_pressure": f"{self.number(-0.6, 0.6, 2)}bar",
            "delivery_pressure": f"{self.number(1, 9, 2)}bar",
        }  # fmt: skip
        return options | {"small_area": self.number(0.2, 0.7, 2)} if kind == "differential" else options

    def _gas(self) -> dict[str, Any]:
        compression, exponent = self.number(4, 9, 1), self.number(1.2, 1.4, 2)
        peak = float(compression) ** float(exponent) * self.random.uniform(1.5, 3)
        return {
            "compression": compression, "cycle": "dual", "peak_pressure": f"{peak:.1f}",
            "cut_off": self.number(1, 2, 2), "exponent": exponent,
            "expansion_exponent": self.number(1.15, 1.4, 2), "exhaust_pressure": self.number(1, 1.2, 2),
        }  # fmt: skip

    def masses(self, load: str, options: dict[str, Any]) -> dict[str, Any]:
        """Return masses whose forces are a share of the load's, and what weighs them."""
        given = {
            "stroke": f"{self.number(0.3, 1.5, 2)}m", "bore": f"{self.number(0.2, 0.6, 2)}m",
            "speed": f"{self.number(5, 20, 1)}rad/s", "centre": self.number(0.4, 0.8, 2),
            "gyration": self.number(0.2, 0.4, 2),
        }  # fmt: skip
        if load != "pump":
            given |= {"pressure": "8bar"} if load == "steam" else {"suction_pressure": "1bar"}
        whole = math.pi / 4 * number(given["bore"]) ** 2 * pressure_of(options | given)
        unit = whole / (number(given["stroke"]) / 2 * number(given["speed"]) ** 2)
        share = self.random.uniform(0.02, 0.2)
        return given | {"reciprocating": f"{unit * share:.1f}kg", "rod_mass": f"{unit * share / 2:.1f}kg"}


def compared(options: dict[str, Any]) -> float:
    """Return by how many units of the last place the worse of mean force and δ is printed off."""
    page = kurbel.delta(**options, columns="mean_force,delta", digits=DIGITS)
    found = kurbel.typeset(page, "csv").splitlines()[-1].split(",")[-2:]
    turn = machine(**options).turn
    pairs = zip(map(float, found), (turn.mean, turn.delta), strict=True)
    return max(abs(one - other) for one, other in pairs) * 10.0**DIGITS


def main() -> int:
    parser = argparse.ArgumentParser()
    for name, default in (("machines", 200), ("seed", 1)):
        parser.add_argument(f"--{name}", type=int, default=default)
    asked = parser.parse_args()
    draw, worst = Draw(asked.seed), 0.0
    for index in range(asked.machines):
        mechanism = MECHANISMS[index % len(MECHANISMS)]
        load = LOADS[index // len(MECHANISMS) % len(LOADS)]
        options = draw.machine(mechanism, load)
        off = compared(options)
        worst = max(worst, off)
        if off > 0.51:
            print(f"{mechanism}, {load}: off by {off:.2f}: {options}")
    print(f"{asked.machines} machines: at most {worst:.3f} of the last place")
    return int(worst > 0.51)
