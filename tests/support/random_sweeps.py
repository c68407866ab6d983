"""Random sweeps of every command, and what the single command says of each of their cells.

By hand: .venv/bin/python tests/support/random_sweeps.py --count 200 --seed 7
"""

from __future__ import annotations

import argparse
import csv
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


Draw = Callable[[Random], Asked]
KINDS: dict[str, Draw] = {}


def kind(draw: Draw) -> Draw:
    KINDS[draw.__name__] = draw
    return draw


def some(random: Random, low: float, high: float, unit: str = "", most: int = 3) -> list[str]:
    """A few different values of a few figures."""
    found = {f"{Decimal(f'{random.uniform(low, high):.3g}'):f}{unit}" for _ in range(random.randint(1, most))}
    return sorted(found)


def ratios(random: Random, most: int = 3) -> list[str]:
    return [f"1:{one}" for one in some(random, 1.3, 8, most=most)]


def shuffled(random: Random, axes: Mapping[str, Sequence[str]]) -> dict[str, Sequence[str]]:
    names = random.sample([*axes], len(axes))
    return {name: axes[name] for name in names}


@kind
def motion(random: Random) -> Asked:
    keys, angles = ["x", "c", "p", "psi"], some(random, -20, 380)
    if random.random() < 0.5:
        # The return stroke ends at 180°.
        keys, angles = [*keys, *(f"{key}_return" for key in keys)], some(random, 0, 180)
    axes: dict[str, Sequence[str]] = {"ratio": ratios(random), "angle": angles}
    if random.random() < 0.3:
        axes["method"] = random.sample(["exact", "series", "infinite"], 2)
    columns = random.sample(keys, 3)
    return Asked("table", ["--columns", ",".join(columns)], shuffled(random, axes))


@kind
def refused_motion(random: Random) -> Asked:
    ratio = ["1:4", random.choice(["1", "1.2", "-0.25"])]
    axes = {"ratio": ratio, "angle": [*some(random, 0, 360), "1e10"]}
    return Asked("table", ["--columns", "x,p"], shuffled(random, axes))


@kind
def sized_motion(random: Random) -> Asked:
    axes = {
        "offset": some(random, -0.4, 0.4),
        "speed": some(random, 60, 300, "/min"),
        "angle": some(random, 0, 360),
    }
    return Asked(
        "table", ["--stroke=600mm", "--ratio=1:4", "--columns=x_mm,c_mps,p_mps2"], shuffled(random, axes)
    )


@kind
def other_drives(random: Random) -> Asked:
    axes = {"rocker": some(random, 4, 9), "ratio": ratios(random), "angle": some(random, 0, 360)}
    return Asked("table", ["--mechanism=arc", "--columns=path,velocity"], shuffled(random, axes))


@kind
def forces(random: Random) -> Asked:
    axes = {
        "ratio": ratios(random),
        "force": some(random, 1, 50, "kN"),
        "angle": some(random, 1, 179),
    }
    return Asked("forces", ["--stroke=400mm"], shuffled(random, axes))


@kind
def forces_of_steam(random: Random) -> Asked:
    axes = {"eps": some(random, 1.5, 8), "ratio": ratios(random), "angle": some(random, 1, 359)}
    return Asked("forces", [], shuffled(random, axes))


@kind
def forces_of_masses(random: Random) -> Asked:
    axes = {
        "reciprocating": some(random, 50, 400, "kg"),
        "speed": some(random, 60, 300, "/min"),
        "angle": some(random, 0, 360),
    }
    return Asked("forces", ["--stroke=600mm", "--ratio=1:5"], shuffled(random, axes))


@kind
def inertia(random: Random) -> Asked:
    axes = {"centre": some(random, 0.4, 0.7), "ratio": ratios(random, 2), "angle": some(random, 0, 360)}
    fixed = ["--gyration=0.3", "--rod-mass=100kg", "--stroke=600mm", "--speed=120/min"]
    return Asked("inertia", fixed, shuffled(random, axes))


@kind
def delta(random: Random) -> Asked:
    axes: dict[str, Sequence[str]] = {
        "eps": [*some(random, 1.1, 9), *random.choice([[], ["1"], ["0.5"]])],
        "ratio": [*ratios(random), *random.choice([[], ["1"], ["1:∞"]])],
    }
    if random.random() < 0.6:
        axes["back"] = [*some(random, 0, 0.5), *random.choice([[], ["1.5"], ["-0.1"]])]
    if random.random() < 0.3:
        axes["method"] = ["exact", "series", "weisbach"]
    return Asked("delta", [], shuffled(random, axes))


@kind
def delta_with_clearance(random: Random) -> Asked:
    axes = {
        "clearance": some(random, 0, 10, "%"),
        "exponent": some(random, 1.05, 1.4),
        "eps": some(random, 1.5, 8, most=2),
    }
    return Asked("delta", ["--ratio=1:5"], shuffled(random, axes))


@kind
def delta_of_cranks(random: Random) -> Asked:
    axes = {"cranks": ["0;90", "0;120;240"], "eps": some(random, 1.5, 8)}
    return Asked("delta", ["--ratio=1:5", *random.choice([[], ["--single-acting"]])], shuffled(random, axes))


@kind
def delta_of_strokes(random: Random) -> Asked:
    axes = {"eps": some(random, 1.5, 8), "ratio": ratios(random, 2)}
    return Asked("delta", ["--detail"], shuffled(random, axes))


@kind
def compressor(random: Random) -> Asked:
    axes = {"pressure-ratio": some(random, 1.5, 6), "clearance": some(random, 1, 60, "%")}
    return Asked("delta", ["--ratio=1:5"], shuffled(random, axes))


@kind
def pump(random: Random) -> Asked:
    return Asked("delta", ["--pump"], {"ratio": ratios(random), "cranks": ["0", "0;90"]})


@kind
def turning(random: Random) -> Asked:
    axes = {"eps": some(random, 1.5, 8), "ratio": ratios(random, 2), "angle": some(random, 0, 360)}
    return Asked("turning", [], shuffled(random, axes))


@kind
def torques(random: Random) -> Asked:
    axes = {"angle": some(random, 0, 360)}
    return Asked("turning", ["--torque=5000 + 1500 sin(3φ)", "--load-torque=5000 + 600 sin φ"], axes)


@kind
def pressures(random: Random) -> Asked:
    fixed = ["--stroke=1m", "--pressure=5bar", "--speed=100/min", "--reciprocating=100kg", "--ratio=1:5"]
    return Asked("pressures", fixed, {"eps": some(random, 1.5, 5), "bore": some(random, 400, 600, "mm", 2)})


@kind
def power(random: Random) -> Asked:
    axes = {
        "eps": some(random, 1.5, 5),
        "bore": some(random, 400, 600, "mm", 2),
        "back": some(random, 0, 9, "%"),
    }
    return Asked("power", ["--stroke=1m", "--pressure=5bar", "--speed=100/min"], shuffled(random, axes))


@kind
def flywheel(random: Random) -> Asked:
    axes = {
        "delta": ["1:50", "1:100"],
        "power": some(random, 10, 90, "kW"),
        "speed": some(random, 60, 200, "/min"),
    }
    return Asked("flywheel", ["--eps=3", "--ratio=1:5"], shuffled(random, axes))


@kind
def dead_centres(random: Random) -> Asked:
    axes = {"offset": some(random, -0.5, 0.5), "ratio": ratios(random)}
    return Asked("deadcentres", [], shuffled(random, axes))


@kind
def harmonics(random: Random) -> Asked:
    return Asked("harmonics", [], {"ratio": ratios(random), "orders": ["2", "5"]})


@kind
def balance(random: Random) -> Asked:
    return Asked("balance", [], {"engine": ["inline-3", "inline-4"], "ratio": ratios(random, 2)})


@kind
def rotor(random: Random) -> Asked:
    fixed = ["--masses=10kg;12kg", "--radii=100mm;120mm", "--angles=0;75"]
    return Asked("rotor", fixed, {"speed": some(random, 60, 900, "/min")})


@kind
def roots(random: Random) -> Asked:
    return Asked("solve", ["--where=s=30%"], {"ratio": ratios(random)})


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
    return KINDS[name](random), more, random.choice(forms)


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
            for said in deviations(*_ordered(drawn(random, name), Path(folder))):
                wrong += 1
                print(f"{name}: {said[:600]}")
    print(f"{given.count} sweeps, {wrong} cells differ")


def _ordered(asked: tuple[Asked, list[str], str], folder: Path) -> tuple[Asked, list[str], Path, str]:
    return asked[0], asked[1], folder, asked[2]


if __name__ == "__main__":
    main()
