"""Random sweeps of every command, and what the single command says of each of their cells.

By hand: .venv/bin/python tests/support/random_sweeps.py --count 200 --seed 7
"""

from __future__ import annotations

import argparse
import csv
import shlex
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from decimal import Decimal
from itertools import accumulate, product
from math import isnan
from pathlib import Path
from random import Random
from typing import Any, NamedTuple

from cli import kurbel

# Figures of the single command, of which the nearest float is made.
DIGITS = 40
# Without a bound a float of an array is as good as this.
SHARE = 1e-11
MISSING = "there is no such record of this combination"
# How the columns are called that the options have for themselves.
KEYS = {"eps": "epsilon", "angle": "phi"}


class Asked(NamedTuple):
    """A command, its options that are the same everywhere, and the values of those that vary, as typed."""

    command: str
    fixed: Sequence[str]
    axes: Mapping[str, Sequence[str]]

    def words(self) -> list[str]:
        """The words of the sweep."""
        varied = [f"--{name}={text}" for name, values in self.axes.items() for text in _listed(name, values)]
        return [self.command, *self.fixed, *varied]

    def single(self) -> Iterator[list[str]]:
        """Yield the words of the single command at each point, the last axis fastest."""
        for values in product(*self.axes.values()):
            told = [f"--{name}={value}" for name, value in zip(self.axes, values, strict=True)]
            yield [self.command, *self.fixed, *told]


def _listed(name: str, values: Sequence[str]) -> Sequence[str]:
    # What is itself a list is repeated.
    return values if name == "cranks" else [";".join(values)]


class Span(NamedTuple):
    """A few different values of a few figures between two."""

    low: float
    high: float
    unit: str = ""
    most: int = 3
    before: str = ""

    def drawn(self, random: Random) -> list[str]:
        count = random.randint(1, self.most)
        found = {f"{Decimal(f'{random.uniform(self.low, self.high):.3g}'):f}" for _ in range(count)}
        return [f"{self.before}{one}{self.unit}" for one in sorted(found)]


class Kind(NamedTuple):
    """A command with what is the same everywhere, and its axes, of which some may be left out."""

    line: str
    axes: Mapping[str, Span | Sequence[str]]
    # Values that are refused, or limits, of which one may stand beside those of an axis.
    odd: Mapping[str, Sequence[str]] = {}
    optional: frozenset[str] = frozenset()

    def __call__(self, random: Random) -> Asked:
        left_out = {name for name in self.optional if random.random() < 0.5}
        names = [name for name in self.axes if name not in left_out]
        axes: dict[str, Sequence[str]] = {}
        for name in random.sample(names, len(names)):
            axis = self.axes[name]
            odd = random.sample(
                self.odd.get(name, ()), min(random.randint(0, 1), len(self.odd.get(name, ())))
            )
            axes[name] = [*(axis.drawn(random) if isinstance(axis, Span) else axis), *odd]
        command, *fixed = shlex.split(self.line)
        return Asked(command, fixed, axes)


RATIO, ANGLE, EPS = Span(1.3, 8, before="1:"), Span(0, 360), Span(1.5, 8)
TWO = RATIO._replace(most=2)
SPEED, BORE = Span(60, 300, "/min"), Span(400, 600, "mm", 2)
STROKE = "--stroke=1m --pressure=5bar --speed=100/min"
METHODS = ("exact", "series", "infinite")
ENGINE_METHODS = ("exact", "series", "weisbach")
KINDS: dict[str, Kind] = {
    "motion": Kind(
        "table --columns x,c,p,psi", {"ratio": RATIO, "angle": Span(-20, 380), "method": METHODS},
        optional=frozenset({"method"}),
    ),
    # The return stroke ends at 180°.
    "both_strokes": Kind(
        "table --columns x_return,c,p_return,psi_return", {"ratio": RATIO, "angle": Span(0, 180)}
    ),
    "refused_motion": Kind(
        "table --columns x,p", {"ratio": ("1:4", "1:3"), "angle": ANGLE},
        {"ratio": ("1", "1.2", "-0.25"), "angle": ("1e10",)},
    ),
    "sized_motion": Kind(
        "table --stroke=600mm --ratio=1:4 --columns=x_mm,c_mps,p_mps2",
        {"offset": Span(-0.4, 0.4), "speed": SPEED, "angle": ANGLE},
    ),
    "other_drives": Kind(
        "table --mechanism=arc --columns=path,velocity",
        {"rocker": Span(4, 9), "ratio": RATIO, "angle": ANGLE},
    ),
    "forces": Kind(
        "forces --stroke=400mm", {"ratio": RATIO, "force": Span(1, 50, "kN"), "angle": Span(1, 179)}
    ),
    "forces_of_steam": Kind("forces", {"eps": EPS, "ratio": RATIO, "angle": Span(1, 359)}),
    "forces_of_masses": Kind(
        "forces --stroke=600mm --ratio=1:5",
        {"reciprocating": Span(50, 400, "kg"), "speed": SPEED, "angle": ANGLE},
    ),
    "inertia": Kind(
        "inertia --gyration=0.3 --rod-mass=100kg --stroke=600mm --speed=120/min",
        {"centre": Span(0.4, 0.7), "ratio": TWO, "angle": ANGLE},
    ),
    "delta": Kind(
        "delta",
        {"eps": Span(1.1, 9), "ratio": RATIO, "back": Span(0, 0.5), "method": ENGINE_METHODS},
        {"eps": ("1", "0.5"), "ratio": ("1", "1:∞"), "back": ("1.5", "-0.1")},
        frozenset({"back", "method"}),
    ),
    "delta_with_clearance": Kind(
        "delta --ratio=1:5",
        {"clearance": Span(0, 10, "%"), "exponent": Span(1.05, 1.4), "eps": EPS._replace(most=2)},
    ),
    "delta_of_cranks": Kind("delta --ratio=1:5", {"cranks": ("0;90", "0;120;240"), "eps": EPS}),
    "delta_of_single_acting_cranks": Kind(
        "delta --ratio=1:5 --single-acting", {"cranks": ("0;90", "0;120;240"), "eps": EPS}
    ),
    "delta_of_strokes": Kind("delta --detail", {"eps": EPS, "ratio": TWO}),
    "compressor": Kind(
        "delta --ratio=1:5", {"pressure-ratio": Span(1.5, 6), "clearance": Span(1, 60, "%")}
    ),
    "pump": Kind("delta --pump", {"ratio": RATIO, "cranks": ("0", "0;90")}),
    "turning": Kind("turning", {"eps": EPS, "ratio": TWO, "angle": ANGLE}),
    "torques": Kind(
        "turning --torque='5000 + 1500 sin(3φ)' --load-torque='5000 + 600 sin φ'", {"angle": ANGLE}
    ),
    "pressures": Kind(
        f"pressures {STROKE} --reciprocating=100kg --ratio=1:5", {"eps": Span(1.5, 5), "bore": BORE}
    ),
    "power": Kind(f"power {STROKE}", {"eps": Span(1.5, 5), "bore": BORE, "back": Span(0, 9, "%")}),
    "flywheel": Kind(
        "flywheel --eps=3 --ratio=1:5",
        {"delta": ("1:50", "1:100"), "power": Span(10, 90, "kW"), "speed": Span(60, 200, "/min")},
    ),
    "dead_centres": Kind("deadcentres", {"offset": Span(-0.5, 0.5), "ratio": RATIO}),
    "harmonics": Kind("harmonics", {"ratio": RATIO, "orders": ("2", "5")}),
    "balance": Kind("balance", {"engine": ("inline-3", "inline-4"), "ratio": TWO}),
    "rotor": Kind(
        "rotor --masses=10kg;12kg --radii=100mm;120mm --angles=0;75",
        {"speed": Span(60, 900, "/min")},
    ),
    "locomotive": Kind(
        # Shares are rows of its page, at each point all of them.
        "locomotive --gauge=1.5m --stroke=60cm --reciprocating=300kg --wheel=1.8m --wheel-load=30kN"
        " --share=0;1/2",
        {"spacing": Span(0.5, 0.9, "m"), "speed": SPEED},
    ),
    "firing": Kind("firing", {"cranks": ("0;180;180;0", "0;120;240;240;120;0")}),
    "firing_of_strokes": Kind("firing", {"strokes": ("2", "4")}),
    "roots": Kind("solve --where=s=30%", {"ratio": RATIO}),
}  # fmt: skip


def alone(asked: Asked) -> Iterator[Asked]:
    """Yield the same with each of its axes alone, the others at their first value."""
    for name in asked.axes:
        others = [f"--{one}={values[0]}" for one, values in asked.axes.items() if one != name]
        yield asked._replace(fixed=[*asked.fixed, *others], axes={name: asked.axes[name]})


def deviations(asked: Asked, more: Sequence[str], folder: Path, form: str) -> Iterator[str]:
    """Run a sweep with more options, and yield where a cell is not what the single command says."""
    target = folder / f"sweep.{form}"
    result = kurbel("sweep", *asked.words(), *more, "-o", str(target))
    points = [_single(words, more) for words in asked.single()]
    if result.code:
        if not all(isinstance(one, str) for one in points):
            yield f"{' '.join(asked.words())}: {result.err}"
        return
    rows = READERS[form](target)
    target.unlink()
    # Arrays have as many places at every point.
    sizes = [1 if isinstance(one, str) else len(one) for one in points]
    if form == "nc":
        sizes = [len(rows) // len(points)] * len(points)
    if sum(sizes) != len(rows):
        yield f"{' '.join(asked.words())}: {len(rows)} rows, and {sum(sizes)} records"
        return
    ends = accumulate(sizes)
    for end, size, single, words in zip(ends, sizes, points, asked.single(), strict=True):
        own = rows[end - size : end]
        for said in _compared(own, single, {KEYS.get(one, one) for one in asked.axes}):
            yield f"{' '.join(words)} {' '.join(more)}: {said}"


def _single(words: Sequence[str], more: Sequence[str]) -> list[dict[str, str]] | str:
    """Return the records of the single command, or why it refuses."""
    digits = more[more.index("--digits") + 1] if "--digits" in more else str(DIGITS)
    result = kurbel(*words, "--digits", digits, "-f", "csv")
    if result.code:
        return result.err.removeprefix("kurbel: ").removesuffix("\n")
    return list(csv.DictReader(result.out.splitlines()))


def _compared(
    rows: Sequence[Mapping[str, Any]], single: list[dict[str, str]] | str, axes: set[str]
) -> Iterator[str]:
    if isinstance(single, str):
        reasons = [row["reason"] for row in rows]
        if reasons != [single, *[MISSING] * (len(rows) - 1)]:
            yield f"reasons {reasons!r} for {single!r}"
        return
    there = [row for row in rows if row["reason"] != MISSING]
    if len(there) != len(single):
        yield f"{len(there)} records for {len(single)}"
        return
    for row, record in zip(there, single, strict=True):
        if row["reason"]:
            yield f"reason {row['reason']!r} for {record}"
            continue
        for key, value in row.items():
            if key not in axes and key in record and not _same(value, record[key], row.get(f"{key}_bound")):
                yield f"{key} is {value!r} for {record[key]!r}, bound {row.get(f'{key}_bound')}"


def _same(value: Any, text: str, bound: float | None) -> bool:
    if value is None or (isinstance(value, float) and isnan(value)):
        return text == ""
    if isinstance(value, str):
        return value == text
    if isinstance(value, Decimal):
        return value == Decimal(text)
    if text == "":
        return False
    true = Decimal(text)
    if bound is not None:
        return abs(Decimal(value) - true) <= Decimal(bound) + Decimal(1).scaleb(-DIGITS)
    return float(true) == value or abs(Decimal(value) - true) <= Decimal(SHARE) * max(abs(true), Decimal(1))


def _by_duckdb(target: Path) -> list[dict[str, Any]]:
    import duckdb

    with duckdb.connect() as connection:
        found = connection.execute(f"select * from '{target}'")
        names = [one[0] for one in found.description or ()]
        return [dict(zip(names, row, strict=True)) for row in found.fetchall()]


def _by_polars(target: Path) -> list[dict[str, Any]]:
    import polars

    return polars.read_ipc(target).to_dicts()


def _by_xarray(target: Path) -> list[dict[str, Any]]:
    import xarray

    with xarray.open_dataset(target, engine="h5netcdf") as found:
        texts = found["reason_text"].values.tolist() if "reason_text" in found else [""]
        rows = found.drop_dims("reason_number", errors="ignore")
        # A frame needs an axis, also where nothing varies.
        rows = rows if rows.sizes else rows.expand_dims("point")
        order = [str(dim) for dim in rows["reason"].dims] if "reason" in rows else None
        records = rows.to_dataframe(dim_order=order).reset_index().to_dict("records")
    return [
        {**{str(key): value for key, value in row.items()}, "reason": texts[int(row.get("reason", 0))]}
        for row in records
    ]


READERS: Mapping[str, Callable[[Path], list[dict[str, Any]]]] = {
    "parquet": _by_duckdb,
    "arrow": _by_polars,
    "nc": _by_xarray,
}


def drawn(random: Random, name: str) -> tuple[Asked, list[str], str]:
    """Return a random sweep of a kind, with how its numbers are wanted, and a form of files."""
    more = random.choice([[], ["--bounds"], ["--digits", str(random.choice([3, 8, 20]))]])
    # Arrays have no decimals.
    forms = [one for one in READERS if one != "nc" or "--digits" not in more]
    asked = KINDS[name](random)
    # All options together, or one of them.
    return random.choice([asked, *alone(asked)]), more, random.choice(forms)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    random = Random(given.seed)
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        for number in range(given.count):
            name = [*KINDS][number % len(KINDS)]
            asked, more, form = drawn(random, name)
            for said in deviations(asked, more, Path(folder), form):
                wrong += 1
                print(f"{name}: {said[:600]}")
    print(f"{given.count} sweeps, {wrong} cells differ")


if __name__ == "__main__":
    main()
