"""Files of columns as other programs read them, and datasets."""

from __future__ import annotations

import csv
import io
import json
import os
import resource
import subprocess
import sys
from collections.abc import Callable, Iterator
from decimal import Decimal
from itertools import islice
from math import isnan
from pathlib import Path
from typing import Any

import duckdb
import numpy as np
import polars
import pyarrow as pa
import pyarrow.dataset
import pyarrow.parquet
import pytest
import xarray
from cli import kurbel, printed, records
from cli import refusal as refusal_of
from hypothesis import given, settings
from hypothesis import strategies as st
from places import CARDS
from random_sweeps import Asked
from small_parts import SmallParts, Sweep, small

import kurbel as library
from kurbel.sweeps.arrow import batch_of, in_sizes
from kurbel.sweeps.dataset import dataset_of
from kurbel.sweeps.grid import chunks_of
from kurbel.sweeps.parts import form_of

ASKED = ("delta", "--eps", "2;1/2;4", "--ratio", "1:4;1:5", "--bounds")
SUPPORT = Path(__file__).parent.parent / "support"
FILES = ("a.parquet", "a.arrow", "a.csv", "folder/", "a.nc", "a.zarr")
COLUMNS = ["epsilon", "ratio", "delta", "delta_bound", "reason"]
Row = tuple[float, float, float | None, float | None, str | None]


def refusal(expansion: str) -> str:
    """What the command itself says of an expansion ratio that it refuses."""
    refused = kurbel("delta", "--eps", expansion, "--lang", "en")
    assert refused.code == 2
    return refused.err.strip().removeprefix("kurbel: ")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the sweep in every form."""
    path = tmp_path_factory.mktemp("files")
    for name in FILES:
        assert kurbel("sweep", *ASKED, "-o", f"{path}/{name}").code == 0
    assert sorted(os.listdir(path)) == sorted(name.strip("/") for name in FILES)
    return path


@pytest.fixture(scope="module")
def expected() -> dict[tuple[float, float], Decimal | str]:
    """By ε and ratio what the single command says: a number, or why there is none."""
    rows: dict[tuple[float, float], Decimal | str] = dict.fromkeys([(0.5, 0.25), (0.5, 0.2)], refusal("1/2"))
    for row in printed(
        "delta", "--eps", "2;4", "--ratio", "1:4;1:5", "--digits", "40", "-f", "csv"
    ).records():
        ratio = 1 / float(row["ratio"].removeprefix("1:"))
        rows[float(row["epsilon"]), ratio] = Decimal(row["delta"])
    return rows


def check(rows: list[Row], expected: dict[tuple[float, float], Decimal | str]) -> None:
    assert [row[:2] for row in rows] == [(e, r) for e in (2, 0.5, 4) for r in (0.25, 0.2)]
    for expansion, ratio, delta, bound, reason in rows:
        said = expected[expansion, ratio]
        if isinstance(said, str):
            assert (delta, bound, reason) == (None, None, said)
        else:
            assert delta is not None and bound is not None and not reason
            assert 0 < abs(Decimal(delta) - said) <= Decimal(bound) < Decimal("1e-12")


def asked_of_duckdb(question: str) -> list[Any]:
    found = duckdb.sql(question)
    assert found is not None
    return found.fetchall()


def by_duckdb(source: str) -> Callable[[Path], list[Row]]:
    return lambda folder: asked_of_duckdb(f"SELECT {', '.join(COLUMNS)} FROM '{folder}/{source}'")


READERS: dict[str, Callable[[Path], list[Row]]] = {
    "duckdb parquet": by_duckdb("a.parquet"),
    "duckdb csv": by_duckdb("a.csv"),
    "duckdb folder": by_duckdb("folder/*.parquet"),
    "polars parquet": lambda folder: polars.read_parquet(folder / "a.parquet").rows(),
    "polars arrow": lambda folder: polars.read_ipc(folder / "a.arrow").rows(),
    "polars csv": lambda folder: polars.read_csv(folder / "a.csv").rows(),
    "polars folder": lambda folder: polars.read_parquet(folder / "folder").rows(),
}


@pytest.mark.parametrize("reader", READERS)
def test_other_programs_read_the_rows(
    folder: Path, expected: dict[tuple[float, float], Decimal | str], reader: str
) -> None:
    check(READERS[reader](folder), expected)


@pytest.mark.parametrize("source", ["a.nc", "a.zarr", "kurbel.sweep"])
def test_xarray_has_the_axes_as_coordinates(
    folder: Path, expected: dict[tuple[float, float], Decimal | str], source: str
) -> None:
    opened = {
        "a.nc": lambda: xarray.open_dataset(folder / "a.nc"),
        "a.zarr": lambda: xarray.open_dataset(folder / "a.zarr", engine="zarr"),
        "kurbel.sweep": lambda: library.sweep(
            "delta", eps=[2, "1/2", 4], ratio=np.array([0.25, 0.2]), bounds=True
        ),
    }
    with opened[source]() as found:
        assert dict(found["delta"].sizes) == {"epsilon": 3, "ratio": 2}
        assert found["delta"].attrs["units"] == "1"
        assert found["delta"].attrs["long_name"] == "Degree of irregularity"
        assert json.loads(found.attrs["kurbel"])["inputs"]["command"] == "delta"
        rows = [
            (e, r, *[None if isnan(one) else one for one in numbers(found, e, r)], reason_at(found, e, r))
            for e in (2, 0.5, 4)
            for r in (0.25, 0.2)
        ]
    check(rows, expected)  # type: ignore[arg-type]


def test_numbers_of_a_netcdf_file_are_packed(folder: Path) -> None:
    with xarray.open_dataset(folder / "a.nc") as found:
        assert found["delta"].encoding["zlib"]


def numbers(found: xarray.Dataset, expansion: float, ratio: float) -> list[float]:
    place = found.sel(epsilon=expansion, ratio=ratio)
    return [float(place["delta"]), float(place["delta_bound"])]


def reason_at(found: xarray.Dataset, expansion: float, ratio: float) -> str | None:
    reason = found["reason"].sel(epsilon=expansion, ratio=ratio).values[()]
    return str(found["reason_text"].values[reason] if "reason_text" in found else reason) or None


def test_numbers_are_packed_in_netcdf(folder: Path) -> None:
    with xarray.open_dataset(folder / "a.nc") as data:
        assert {one.encoding["zlib"] for one in (data["delta"], data["delta_bound"])} == {True}


@pytest.mark.parametrize("name", ["a.nc", "a.zarr"])
def test_whole_numbers_of_reasons_have_their_sentences_as_flags(folder: Path, name: str) -> None:
    opened = xarray.open_zarr(folder / name) if name.endswith("zarr") else xarray.open_dataset(folder / name)
    with opened as data:
        about = data["reason"].attrs
        assert [*about["flag_values"]] == [*range(len(about["flag_values"]))]
        assert len(about["flag_meanings"].split()) == len(about["flag_values"]) > 1


def test_what_a_file_says_of_its_inputs_makes_it_again(folder: Path, tmp_path: Path) -> None:
    inputs = json.loads(pyarrow.parquet.read_schema(folder / "a.parquet").metadata[b"kurbel"])["inputs"]
    assert inputs.pop("bounds")
    axes = [word for group in inputs["axes"] for name, values in group.items()
            for word in (f"--{name}", ";".join(values))]  # fmt: skip
    again = f"{tmp_path}/again.parquet"
    assert kurbel("sweep", inputs["command"], *axes, "--bounds", "-o", again).code == 0
    assert Path(again).read_bytes() == (folder / "a.parquet").read_bytes()


def test_a_file_says_what_its_columns_are(tmp_path: Path) -> None:
    plan = ("table", "--ratio", "1:4;1:5", "--angle", "30;60", "--columns", "x,c_mps")
    name = f"{tmp_path}/a.parquet"
    assert kurbel("sweep", *plan, "--stroke", "0,6m", "--speed", "2/s", "-o", name, "--lang", "de").code == 0
    schema = pyarrow.parquet.read_schema(name)
    said = {field.name: field.metadata for field in schema if field.metadata}
    assert (said["c_mps"][b"symbol"], said["c_mps"][b"unit"]) == (b"c", b"m/s")
    assert said["phi"][b"unit"].decode() == "°"
    assert "Kolbengeschwindigkeit" in said["c_mps"][b"name"].decode()
    # Rötscher, eq. (285), of the outstroke.
    assert said["x"][b"formula"].decode() == "x/R = 1 − cos φ + (1 − cos ψ)/λ, sin ψ = λ sin φ, λ = R/L"
    about = json.loads(schema.metadata[b"kurbel"])
    assert about["kurbel"] == library.__version__
    assert any(note.startswith("x/R = 1 − cos φ") for note in about["notes"])


def test_a_column_has_a_formula_where_a_line_holds_it(tmp_path: Path) -> None:
    name, asked = f"{tmp_path}/a.parquet", ("--angle", "30;60", "--centre", "0.6", "--gyration", "0.4")
    for command, key, formula, words in (
        ("forces", "guide_force_return", "N/F = − tan ψ, sin ψ = λ sin φ, λ = R/L", asked[:2]),
        ("inertia", "inertia_guide", "", asked),
    ):
        assert kurbel("sweep", command, "--ratio", "1:4;1:5", "--columns", key, *words, "-o", name).code == 0
        metadata = pyarrow.parquet.read_schema(name).field(key).metadata
        assert metadata.get(b"formula", b"").decode() == formula


@pytest.mark.parametrize("digits", [0, 25, 40])
@pytest.mark.parametrize(
    "asked",
    [
        Asked("delta", ["--columns=delta"], {"eps": ("2", "4"), "back": ("0", "0,1")}),
        # Below zero, and between 0 and -1.
        Asked("table", ["--ratio=1:4", "--columns=p"], {"angle": ("0", "80", "90", "180")}),
    ],
)
def test_decimals_have_the_digits_of_the_command(tmp_path: Path, asked: Asked, digits: int) -> None:
    key, name, more = asked.fixed[-1].removeprefix("--columns="), f"{tmp_path}/a", f"--digits={digits}"
    for suffix in ("parquet", "csv"):
        assert kurbel("sweep", *asked.words(), more, "-o", f"{name}.{suffix}").code == 0
    single = [records(*words, more)[0][key] for words in asked.single()]
    assert pyarrow.parquet.read_table(f"{name}.parquet")[key].to_pylist() == [*map(Decimal, single)]
    assert polars.read_csv(f"{name}.csv", infer_schema=False)[key].to_list() == single
    if digits <= 28:
        found = asked_of_duckdb(f"SELECT {key} FROM '{name}.parquet'")
        assert [one for (one,) in found] == [*map(Decimal, single)]


def test_decimals_of_more_digits_than_a_file_holds_are_refused(tmp_path: Path) -> None:
    sizes = ["--eps=2", "--stroke=100m", "--pressure=100bar", "--speed=100/min", "--columns=indicated_power"]
    asked, name = Asked("power", sizes, {"bore": ("100m", "200m")}), f"{tmp_path}/a.parquet"
    # With 28 decimals there are ten places before the point, with more a wider kind of numbers.
    said = refusal_of("sweep", *asked.words(), "--digits=28", "-o", name, code=1)
    assert said == (
        "indicated_power has numbers of more than 38 digits, which no file of decimals holds;"
        " ask for fewer --digits"
    )
    for digits in ("--digits=27", "--digits=29"):
        assert kurbel("sweep", *asked.words(), digits, "-o", name).code == 0
        single = [Decimal(records(*words, digits)[0]["indicated_power"]) for words in asked.single()]
        assert pyarrow.parquet.read_table(name)["indicated_power"].to_pylist() == single
        assert single[0] < 10**10 < single[1]


def test_csv_quotes_what_others_would_take_for_fields(tmp_path: Path) -> None:
    names = ['a "b", c.csv', "d;e.csv"]
    for name in names:
        (tmp_path / name).write_bytes((CARDS / "ideal-2.csv").read_bytes())
    words = ("sweep", "delta", *(f"--card={tmp_path}/{name}" for name in names), "--ratio=1:4;3:1")
    text = kurbel(*words, "-f", "csv", "-o", "-").out
    rows = [*csv.reader(text.splitlines())]
    assert [*dict.fromkeys(row[0] for row in rows[1:])] == [f"{tmp_path}/{name}" for name in names]
    assert {row[-1] for row in rows[1:]} == {
        "",
        refusal_of("delta", f"--card={CARDS}/ideal-2.csv", "--ratio=3:1"),
    }
    written = io.StringIO(newline="")
    csv.writer(written, lineterminator="\n").writerows(rows)
    assert text == written.getvalue()


@given(st.lists(st.integers(0, 7), max_size=6), st.lists(st.integers(1, 9), min_size=30, max_size=30))
@settings(deadline=None, max_examples=15)
def test_rows_stay_in_their_order_in_batches_of_other_sizes(own: list[int], sizes: list[int]) -> None:
    rows = iter(range(sum(own)))
    batches = [pa.record_batch({"row": pa.array(list(islice(rows, size)), pa.int64())}) for size in own]
    found = list(in_sizes(batches, iter(sizes)))
    assert [row for batch in found for row in batch["row"].to_pylist()] == list(range(sum(own)))
    assert [len(batch) for batch in found[:-1]] == sizes[: max(0, len(found) - 1)]


@given(st.lists(st.integers(1, 9), max_size=4).map(tuple), st.integers(1, 50))
@settings(deadline=None, max_examples=20)
def test_a_chunk_is_a_run_of_rows(sizes: tuple[int, ...], rows: int) -> None:
    chunks = chunks_of(sizes, rows)
    assert len(chunks) == len(sizes) and np.prod(chunks, dtype=int) <= rows
    whole = np.arange(np.prod(sizes, dtype=int)).reshape(sizes)
    counts = [-(-size // chunk) for size, chunk in zip(sizes, chunks, strict=True)]
    places = [
        tuple(slice(n * c, (n + 1) * c) for n, c in zip(number, chunks, strict=True))
        for number in np.ndindex(*counts)
    ]
    assert np.concatenate([whole[place].ravel() for place in places]).tolist() == whole.ravel().tolist()


def test_units_are_spelled_as_udunits_does() -> None:
    asked: dict[str, dict[str, Any]] = {
        "table": dict(stroke="600mm", speed="90/min", angle="30;60", columns="x,x_percent,c_mps,p,p_mps2"),
        "flywheel": dict(eps="3;4", power="50kW", speed="90/min", delta="1:100"),
        "power": dict(eps="2;3", pressure="8bar", specific_volume="0.24 m3/kg", columns="steam_per_kwh"),
        "delta": dict(
            pressure_ratio="3;4",
            stroke="600mm",
            bore="300mm",
            speed="90/min",
            suction_pressure="1bar",
            columns="delivery",
        ),
    }
    units = {
        name: column.attrs["units"]
        for command, options in asked.items()
        for name, column in library.sweep(command, **options).variables.items()
        if column.attrs.get("units", "1") != "1"
    }
    assert units == {
        "x_percent": "percent", "c_mps": "m s-1", "p_mps2": "m s-2", "phi": "degree", "power": "W",
        "speed": "minute-1", "omega": "radian s-1", "mean_torque": "N m", "swing": "J", "inertia": "kg m2",
        "steam_per_kwh": "kg kW-1 hour-1", "delivery": "m3 minute-1",
    }  # fmt: skip


def test_a_large_dataset_computes_what_is_asked_of_it(monkeypatch: pytest.MonkeyPatch) -> None:
    sweep = small(eps=["2;3;4;1/2"], ratio=["1:4;1:5;1:6"])
    lazy = dataset_of(sweep)
    assert max(lazy["delta"].data.chunksize) <= 2
    starts: list[int] = []
    computed = SmallParts.computed

    def noted(self: SmallParts, start: int, stop: int) -> Any:
        starts.append(start)
        return computed(self, start, stop)

    monkeypatch.setattr(SmallParts, "computed", noted)
    one = lazy.sel(epsilon=3, ratio=0.2).compute()
    assert len(starts) == 1
    other = dataset_of(Sweep(sweep.plan))
    assert one["delta"].item() == other["delta"].sel(epsilon=3, ratio=0.2).item()
    whole = lazy.compute()
    assert whole["refused"].values.tolist() == [[False] * 3] * 3 + [[True] * 3]
    xarray.testing.assert_identical(whole, other.drop_vars("reason"))


def test_options_are_given_as_python_has_them() -> None:
    one = library.sweep("balance", cranks=[0, 120, 240], ratio=["1:4", 0.2])
    assert (one.sizes["ratio"], one["ratio"].values.tolist()) == (2, [0.25, 0.2])
    assert one["order"].values.tolist() == [1, 2, 1, 2]
    several = library.sweep(library.balance, cranks=["0;180", "0;90"], ratio="1:4")
    assert several["cranks"].values.tolist() == ["0;180", "0;90"]
    linked = library.sweep("delta", eps=range(2, 5), back=["0", "0.1", "0.2"], zip="eps,back", only="eps < 4")
    assert (linked["epsilon"].values.tolist(), linked["back"].values.tolist()) == ([2, 3], [0, 0.1])
    assert linked["delta"].dims == ("point",)


def batches_of(sweep: Sweep, rows: int) -> Iterator[pa.RecordBatch]:
    for start in range(0, rows, 2):
        yield batch_of(sweep, sweep.part(start, start + 2))


@pytest.mark.parametrize("name", FILES)
def test_what_ends_half_written_leaves_what_was_there(tmp_path: Path, name: str) -> None:
    sweep, target = small(eps=["2;3"], ratio=["1:4;1:5;1:6"]), f"{tmp_path}/{name}"
    (scratch := tmp_path / "scratch").mkdir()
    form = form_of(target)

    def ended() -> Iterator[pa.RecordBatch]:
        yield from batches_of(sweep, 4)
        raise OSError(28, "No space left on device")

    with pytest.raises(library.KurbelError, match=r"cannot write .*No space left on device"):
        form.write(sweep, ended(), target, str(scratch))
    assert os.listdir(tmp_path) == ["scratch"] and os.listdir(scratch) == []
    form.write(sweep, batches_of(sweep, 6), target, str(scratch))
    first = content_of(Path(target))
    with pytest.raises(library.KurbelError, match="No space left on device"):
        form.write(sweep, ended(), target, str(scratch))
    assert content_of(Path(target)) == first and os.listdir(scratch) == []
    form.write(sweep, batches_of(sweep, 6), target, str(scratch))
    assert content_of(Path(target)) == first and os.listdir(scratch) == []


@pytest.mark.parametrize("name", FILES)
def test_a_full_disk_is_one_sentence_and_leaves_nothing(tmp_path: Path, name: str) -> None:
    sweep = small(eps=["2;3"], ratio=["1:4;1:5;1:6"])
    (scratch := tmp_path / "scratch").mkdir()
    batches = list(batches_of(sweep, 6))
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, limits[1]))
    try:
        with pytest.raises(library.KurbelError, match=r"cannot write \S+: File too large$"):
            form_of(f"{tmp_path}/{name}").write(sweep, iter(batches), f"{tmp_path}/{name}", str(scratch))
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert os.listdir(tmp_path) == ["scratch"] and os.listdir(scratch) == []


def content_of(path: Path) -> dict[str, bytes]:
    files = [one for one in path.rglob("*") if one.is_file()] if path.is_dir() else [path]
    return {str(one.relative_to(path)): one.read_bytes() for one in files}


@pytest.mark.parametrize(
    ("target", "said"),
    [
        ("own/", "the folder has other files; name a new one"),
        ("own.zarr", "the folder has other files; name a new one"),
        ("own.nc", "it is a directory; name a file in it"),
        ("none/a.nc", "the directory .*none does not exist"),
    ],
)
def test_no_file_of_other_content_is_removed(tmp_path: Path, target: str, said: str) -> None:
    for name in ("own", "own.zarr", "own.nc"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "letter.txt").write_text("mine")
    with pytest.raises(library.KurbelError, match=said):
        library.sweep("delta", eps=2, output=f"{tmp_path}/{target}")
    assert sorted(os.listdir(tmp_path)) == ["own", "own.nc", "own.zarr"]
    assert (tmp_path / "own" / "letter.txt").read_text() == "mine"


@pytest.mark.parametrize("place", ["folder/letter.txt", "a.zarr/letter.txt", "a.zarr/delta/c/letter.txt"])
def test_a_folder_of_a_sweep_keeps_what_somebody_put_there(tmp_path: Path, place: str) -> None:
    sweep, target = small(eps=["2;3"], ratio=["1:4;1:5"]), f"{tmp_path}/{place.partition('/')[0]}"
    (scratch := tmp_path / "scratch").mkdir()
    form = form_of(f"{target}/")
    form.write(sweep, batches_of(sweep, 4), target, str(scratch))
    (tmp_path / place).write_text("mine")
    before = content_of(tmp_path)

    def late() -> Iterator[pa.RecordBatch]:
        (tmp_path / place).write_text("mine")
        yield from batches_of(sweep, 4)

    with pytest.raises(library.KurbelError, match="the folder has other files"):
        form.write(sweep, batches_of(sweep, 4), target, str(scratch))
    (tmp_path / place).unlink()
    with pytest.raises(library.KurbelError, match="the folder has other files"):
        form.write(sweep, late(), target, str(scratch))
    assert content_of(tmp_path) == before


@pytest.mark.slow
def test_the_bytes_are_the_same_in_every_process(folder: Path, tmp_path: Path) -> None:
    code = "import sys\nfrom cli import kurbel\nfor name in sys.argv[1:]:\n kurbel(*%r, '-o', name)"
    words = [f"{tmp_path}/{name}" for name in FILES]
    environment = {**os.environ, "PYTHONHASHSEED": "7", "PYTHONPATH": str(SUPPORT)}
    subprocess.run([sys.executable, "-c", code % (("sweep", *ASKED),), *words], check=True, env=environment)
    assert content_of(tmp_path) == content_of(folder)
