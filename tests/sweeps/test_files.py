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
from decimal import Decimal, localcontext
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
from cli import kurbel, printed
from hypothesis import given, settings
from hypothesis import strategies as st
from small_parts import SmallParts

import kurbel as library
from kurbel.errors import KurbelError, NotationError, OutputError
from kurbel.sweeps.asked import planned
from kurbel.sweeps.columns import Column
from kurbel.sweeps.files.arrow import batch_of, in_sizes
from kurbel.sweeps.files.cf import udunits
from kurbel.sweeps.files.csv import lines_of
from kurbel.sweeps.files.decimals import decimals_of, texts_of
from kurbel.sweeps.files.forms import form_of
from kurbel.sweeps.files.grid import chunks_of
from kurbel.sweeps.lazy import dataset_of
from kurbel.sweeps.rows import Part, Sweep

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


def numbers(found: xarray.Dataset, expansion: float, ratio: float) -> list[float]:
    place = found.sel(epsilon=expansion, ratio=ratio)
    return [float(place["delta"]), float(place["delta_bound"])]


def reason_at(found: xarray.Dataset, expansion: float, ratio: float) -> str | None:
    reason = found["reason"].sel(epsilon=expansion, ratio=ratio).values[()]
    return str(found["reason_text"].values[reason] if "reason_text" in found else reason) or None


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


@pytest.mark.parametrize("digits", [25, 40])
def test_decimals_have_the_digits_of_the_command(tmp_path: Path, digits: int) -> None:
    name, asked = f"{tmp_path}/a", ("--eps", "2;4", "--back", "0;0,1", "--digits", str(digits))
    for suffix in ("parquet", "csv"):
        assert kurbel("sweep", "delta", *asked, "--columns", "delta", "-o", f"{name}.{suffix}").code == 0
    single = [
        printed("delta", "--eps", e, "--back", b, "--digits", str(digits), "-f", "csv").records()[0]["delta"]
        for e in ("2", "4")
        for b in ("0", "0,1")
    ]
    read = pyarrow.parquet.read_table(f"{name}.parquet")["delta"]
    assert read.to_pylist() == [Decimal(text) for text in single]
    assert polars.read_csv(f"{name}.csv", infer_schema=False)["delta"].to_list() == single
    if digits <= 28:
        found = asked_of_duckdb(f"SELECT delta FROM '{name}.parquet'")
        assert [one for (one,) in found] == [Decimal(text) for text in single]


@given(st.lists(st.none() | st.integers(-(10**45), 10**45), min_size=1, max_size=5), st.integers(0, 50))
@settings(deadline=None, max_examples=15)
def test_decimals_are_whole_numbers_of_their_last_place(scaled: list[int | None], decimals: int) -> None:
    column = Column("x", "decimal", decimals=decimals)
    if decimals <= 28 and any(abs(one or 0) >= 10**38 for one in scaled):
        with pytest.raises(OutputError, match="more than 38 digits"):
            decimals_of(column, scaled)
        return
    array = decimals_of(column, scaled)
    array.validate(full=True)
    true = [None if one is None else f"{one:0{decimals + 1 + (one < 0)}d}" for one in scaled]
    true = [t and f"{t[:-decimals]}.{t[-decimals:]}" if decimals else t for t in true]
    assert texts_of(array).to_pylist() == true
    assert array.to_pylist() == [None if one is None else Decimal(one) for one in true]


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


@pytest.mark.parametrize(
    ("unit", "known"),
    [("m/s²", "m s-2"), ("N m", "N m"), ("min⁻¹", "minute-1"), ("kg/kWh", "kg kW-1 hour-1"), ("°", "degree"),
     ("% of the stroke", "percent"), ("M R ω²", "1"), ("", "1"), ("v²/R", "1"), ("m³/min", "m3 minute-1")],
)  # fmt: skip
def test_units_are_spelled_as_udunits_does(unit: str, known: str) -> None:
    assert udunits(unit) == known


def sweep_of(**options: Any) -> Sweep:
    return SmallParts(planned("kurbel.commands.engine:delta_table", options))


def test_a_large_dataset_computes_what_is_asked_of_it(monkeypatch: pytest.MonkeyPatch) -> None:
    sweep = sweep_of(eps=["2;3;4;1/2"], ratio=["1:4;1:5;1:6"])
    lazy = dataset_of(sweep)
    assert max(lazy["delta"].data.chunksize) <= 2
    starts: list[int] = []
    computed = SmallParts.computed

    def noted(self: SmallParts, start: int, stop: int) -> Part:
        starts.append(start)
        return computed(self, start, stop)

    monkeypatch.setattr(SmallParts, "computed", noted)
    one = lazy.sel(epsilon=3, ratio=0.2).compute()
    assert len(starts) == 1
    small = dataset_of(Sweep(sweep.plan))
    assert one["delta"].item() == small["delta"].sel(epsilon=3, ratio=0.2).item()
    whole = lazy.compute()
    assert whole["refused"].values.tolist() == [[False] * 3] * 3 + [[True] * 3]
    xarray.testing.assert_identical(whole, small.drop_vars("reason"))


def test_options_are_given_as_python_has_them() -> None:
    one = library.sweep("balance", cranks=[0, 120, 240], ratio=["1:4", 0.2])
    assert (one.sizes["ratio"], one["ratio"].values.tolist()) == (2, [0.25, 0.2])
    assert one["order"].values.tolist() == [1, 2, 1, 2]
    several = library.sweep(library.balance_table, cranks=["0;180", "0;90"], ratio="1:4")
    assert several["cranks"].values.tolist() == ["0;180", "0;90"]
    linked = library.sweep("delta", eps=range(2, 5), back=["0", "0.1", "0.2"], zip="eps,back", only="eps < 4")
    assert (linked["epsilon"].values.tolist(), linked["back"].values.tolist()) == ([2, 3], [0, 0.1])
    assert linked["delta"].dims == ("point",)
    with pytest.raises(NotationError, match="write each of them as text: '0;120;240'"):
        library.sweep("balance", cranks=[[0, 180], [0, 90]])
    with pytest.raises(NotationError, match="resume and restart are for an output"):
        library.sweep("delta", eps=2, resume=True)
    with pytest.raises(NotationError, match="no function that makes a table of a machine"):
        library.sweep(library.compute, ratio=[0.2])


def batches_of(sweep: Sweep, rows: int) -> Iterator[pa.RecordBatch]:
    for start in range(0, rows, 2):
        yield batch_of(sweep, sweep.part(start, start + 2))


@pytest.mark.parametrize("name", FILES)
def test_what_ends_half_written_leaves_what_was_there(tmp_path: Path, name: str) -> None:
    sweep, target = sweep_of(eps=["2;3"], ratio=["1:4;1:5;1:6"]), f"{tmp_path}/{name}"
    (scratch := tmp_path / "scratch").mkdir()
    form = form_of(target)

    def ended() -> Iterator[pa.RecordBatch]:
        yield from batches_of(sweep, 4)
        raise OSError(28, "No space left on device")

    with pytest.raises(OutputError, match=r"cannot write .*No space left on device"):
        form.write(sweep, ended(), target, str(scratch))
    assert os.listdir(tmp_path) == ["scratch"] and os.listdir(scratch) == []
    form.write(sweep, batches_of(sweep, 6), target, str(scratch))
    first = content_of(Path(target))
    with pytest.raises(OutputError, match="No space left on device"):
        form.write(sweep, ended(), target, str(scratch))
    assert content_of(Path(target)) == first and os.listdir(scratch) == []
    form.write(sweep, batches_of(sweep, 6), target, str(scratch))
    assert content_of(Path(target)) == first and os.listdir(scratch) == []


@pytest.mark.parametrize("name", FILES)
def test_a_full_disk_is_one_sentence_and_leaves_nothing(tmp_path: Path, name: str) -> None:
    sweep = sweep_of(eps=["2;3"], ratio=["1:4;1:5;1:6"])
    (scratch := tmp_path / "scratch").mkdir()
    batches = list(batches_of(sweep, 6))
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, limits[1]))
    try:
        with pytest.raises(OutputError, match=r"cannot write \S+: File too large$"):
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
        ("a.xlsx", r"\.xlsx is no form of columns; name a file with \.parquet"),
        ("-", "standard output has no suffix"),
    ],
)
def test_no_file_of_other_content_is_removed(tmp_path: Path, target: str, said: str) -> None:
    for name in ("own", "own.zarr", "own.nc"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "letter.txt").write_text("mine")
    with pytest.raises(KurbelError, match=said):
        library.sweep("delta", eps=2, output=target if target == "-" else f"{tmp_path}/{target}")
    assert sorted(os.listdir(tmp_path)) == ["own", "own.nc", "own.zarr"]
    assert (tmp_path / "own" / "letter.txt").read_text() == "mine"


@pytest.mark.parametrize("place", ["folder/letter.txt", "a.zarr/letter.txt", "a.zarr/delta/c/letter.txt"])
def test_a_folder_of_a_sweep_keeps_what_somebody_put_there(tmp_path: Path, place: str) -> None:
    sweep, target = sweep_of(eps=["2;3"], ratio=["1:4;1:5"]), f"{tmp_path}/{place.partition('/')[0]}"
    (scratch := tmp_path / "scratch").mkdir()
    form = form_of(f"{target}/")
    form.write(sweep, batches_of(sweep, 4), target, str(scratch))
    (tmp_path / place).write_text("mine")
    before = content_of(tmp_path)

    def late() -> Iterator[pa.RecordBatch]:
        (tmp_path / place).write_text("mine")
        yield from batches_of(sweep, 4)

    with pytest.raises(OutputError, match="the folder has other files"):
        form.write(sweep, batches_of(sweep, 4), target, str(scratch))
    (tmp_path / place).unlink()
    with pytest.raises(OutputError, match="the folder has other files"):
        form.write(sweep, late(), target, str(scratch))
    assert content_of(tmp_path) == before


def test_csv_quotes_what_needs_it() -> None:
    texts = ['a "b"', "c,d", "e\nf", "g"]
    batch = pa.record_batch({"x": pa.array(texts), "y": pa.array([1.5, None, 1e-7, 1e22])})
    read = list(csv.reader(io.StringIO(lines_of(batch).to_pybytes().decode(), newline="")))
    assert [row[0] for row in read] == texts
    assert [row[1] and float(row[1]) for row in read] == [1.5, "", 1e-7, 1e22]


@pytest.mark.slow
def test_the_bytes_are_the_same_in_every_process(folder: Path, tmp_path: Path) -> None:
    code = "import sys\nfrom cli import kurbel\nfor name in sys.argv[1:]:\n kurbel(*%r, '-o', name)"
    words = [f"{tmp_path}/{name}" for name in FILES]
    environment = {**os.environ, "PYTHONHASHSEED": "7", "PYTHONPATH": str(SUPPORT)}
    subprocess.run([sys.executable, "-c", code % (("sweep", *ASKED),), *words], check=True, env=environment)
    assert content_of(tmp_path) == content_of(folder)


@given(st.lists(st.integers(-(2**62), 2**62), min_size=1, max_size=9), st.sampled_from([0, 3, 20, 30]))
@settings(deadline=None, max_examples=40)
def test_decimals_of_arrays_are_the_whole_numbers_of_the_last_place(scaled: list[int], places: int) -> None:
    column = Column("x", "decimal", decimals=places)
    found = decimals_of(column, np.array(scaled, np.int64)).to_pylist()
    with localcontext() as context:
        context.prec = 80
        assert [int(one.scaleb(places)) for one in found] == scaled
