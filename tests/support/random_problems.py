"""The problems of examples/problems with random values, answered by kurbel and by their solutions.

By hand: .venv/bin/python tests/support/random_problems.py --count 200 --seed 7
"""

from __future__ import annotations

import argparse
import json
import re
import shlex
import tomllib
from collections.abc import Callable, Mapping
from decimal import Decimal
from importlib import import_module
from inspect import signature
from random import Random
from typing import Any

from cli import printed
from mpmath import mp, mpf
from places import ROOT
from problem_answers import SOLUTIONS, Rows, in_si

FOLDER = ROOT / "examples" / "problems"
BOOKS = ("handbook", "english", "sheet")
FILES = {path.stem: path for path in sorted(FOLDER.glob("*.toml")) if path.stem not in BOOKS}
for _name in FILES:
    import_module(f"answers_{_name}")
PROBLEMS: dict[str, dict[str, Any]] = {
    one["name"]: one
    for path in FILES.values()
    for one in tomllib.loads(path.read_text(encoding="utf-8"))["problem"]
}
# What of a value may vary: the sizes of waves, the torques of a diagram, else every number before its unit.
NUMBERS = {"φ": r"\d+(?= (?:sin|cos))", ":": r"(?<=:)\d+", "": r"(?<![a-z\d.])\d+(?:\.\d+)?"}
# Areas are 0 together, a load has the mean of its drive; cylinders, fractions and scales are whole numbers.
KEPT = re.compile(r"\d/\d|[+-]\d+;|^\d(\d{3})?$|;.*°$")


# What lists of a rotor lie between.
SPANS = {"masses": (1, 30), "radii": (40, 300), "angles": (0, 359), "planes": (0, 900)}
# What a solution or a load fixes: four masses, cycles of four strokes, three cranks' corners at 60°.
KEPT_SHAPES: Mapping[str, tuple[str, ...]] = {
    "complete-balance": ("masses", "radii", "planes"),
    "inner-cranks": ("planes",),
    "four-strokes": ("areas",),
    "three-cranks": ("points",),
    "load-over-three-turns": ("points",),
    "load-reverses": ("angle",),
}


def values_of(name: str, variant: int) -> dict[str, str]:
    """Return the values of a problem's variant as they are typed."""
    given = PROBLEMS[name]["values"]
    return {key: one if isinstance(one, str) else one[variant - 1] for key, one in given.items()}


def random_values(name: str, random: Random) -> dict[str, str]:
    """Return the values of a variant, each number up to 6 % less than its own; what is equal stays so."""

    def varied(value: str) -> str:
        if KEPT.search(value):
            return value
        kind = next(sign for sign in NUMBERS if sign in value and (sign != ":" or ";" in value))
        # Solutions read formulas with whole numbers.
        figures = 3 if kind == "φ" else 4
        share = {found: random.uniform(0.94, 1) for found in sorted(re.findall(NUMBERS[kind], value))}
        return re.sub(
            NUMBERS[kind], lambda one: f"{Decimal(f'{float(one[0]) * share[one[0]]:.{figures}g}'):f}", value
        )

    return {key: varied(value) for key, value in values_of(name, random.choice((1, 2))).items()}


def reshaped(name: str, random: Random) -> dict[str, str]:
    """Return random values of another structure: more or fewer masses, areas and waves, any angle."""
    values, count = random_values(name, random), random.randint(2, 6)
    waves = [f"{random.randint(100, 900)} {wave}({order}φ)" for wave in ("sin", "cos") for order in (2, 3, 4)]
    some = " - ".join(random.sample(waves, random.randint(1, 4)))
    areas = [random.randint(-300, 300) for _ in range(count)]
    corners = sorted(random.sample(range(10, 350), count))
    shapes = {
        "angle": f"{random.randint(1, 3599) / 10}",
        "torque": f"{values.get('torque', '').partition(' ')[0]} + {some}",
        "areas": "; ".join(f"{one:+d}" for one in (*areas, -sum(areas)) if one),
        "points": "; ".join(["0:0", *(f"{at}:{random.randint(0, 2000)}" for at in corners), "360:0"]),
        **{key: "; ".join(str(random.randint(*span)) for _ in range(count)) for key, span in SPANS.items()},
    }
    kept = KEPT_SHAPES.get(name, ())
    return {key: shapes[key] if key in shapes and key not in kept else one for key, one in values.items()}


def check(name: str, values: Mapping[str, str]) -> None:
    """Assert that the command of a problem prints the digits of its solution, computed with 30."""
    words = [word.format(**values) for word in shlex.split(PROBLEMS[name]["run"])]
    solve: Callable[..., Rows] = SOLUTIONS[name]
    # A solution reads itself what is no number with a unit.
    typed = {key for key, one in signature(solve).parameters.items() if one.annotation == "str"}
    rows = json.loads(
        printed(*words, "-f", "json", KURBEL_LANG="en").out, parse_float=Decimal, parse_int=Decimal
    )["rows"]
    with mp.workdps(30):
        expected = solve(**{key: one if key in typed else in_si(one) for key, one in values.items()})
        assert len(rows) == len(expected), words
        for row, wanted in zip(rows, expected, strict=True):
            for key, value in wanted.items():
                unit = mpf(10) ** row[key].as_tuple().exponent
                assert abs(mpf(str(row[key])) - value) <= unit * mpf("0.500001"), (
                    words,
                    key,
                    row[key],
                    value,
                )


def main() -> None:
    options = argparse.ArgumentParser()
    options.add_argument("--count", type=int, default=100)
    options.add_argument("--seed", default="1")
    given = options.parse_args()
    for name in PROBLEMS:
        for index in range(given.count):
            random = Random(f"{given.seed} {index}")
            check(name, random_values(name, random))
            check(name, reshaped(name, random))
        print(f"{given.count} of {name}: every digit as computed")


if __name__ == "__main__":
    main()
