"""The forms of files of columns, found by the suffix of the file, and how a file of one is written."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from importlib.util import find_spec
from pkgutil import resolve_name
from typing import TYPE_CHECKING, NamedTuple

from kurbel.errors import ChoiceError, OutputError
from kurbel.reading.given import meant

if TYPE_CHECKING:
    import pyarrow as pa

    from kurbel.sweeps.rows import Sweep


class Form(NamedTuple):
    """A form of files.

    `writer` is the place of the function that takes a sweep, its batches in order, the target, and a folder
    beside it for what is half written. `refuse` is that of the function that raises KurbelError for a sweep
    which such a file cannot hold. What `streams` can go to standard output; `needs` are the libraries that
    must be there. Arrays have rows `in_places`, also those that belong to no record.
    """

    name: str
    suffixes: tuple[str, ...]
    writer: str
    refuse: str = ""
    streams: bool = True
    needs: tuple[str, ...] = ("pyarrow",)
    in_places: bool = False

    def check(self, sweep: Sweep, target: str) -> None:
        """Raise KurbelError for a sweep or a target that cannot become such a file."""
        need(f"A file of columns ({self.name})", *self.needs)
        if not self.streams and (target == "-" or is_device(target)):
            raise OutputError(f"{self.name} cannot be written to {target}; name a file or a folder")
        if self.refuse:
            check: Callable[[Sweep], None] = resolve_name(self.refuse)
            check(sweep)

    def write(self, sweep: Sweep, batches: Iterable[pa.RecordBatch], target: str, scratch: str) -> None:
        """Write the batches, in order, to the target, whole or not at all. Raises KurbelError."""
        writer: Callable[..., None] = resolve_name(self.writer)
        writer(sweep, batches, target, scratch)


_HERE = "kurbel.sweeps.files"
_NETCDF, _ZARR = ("pyarrow", "h5netcdf", "h5py"), ("pyarrow", "zarr")
PARTITIONS = Form("partitions", ("/",), f"{_HERE}.parquet:write_folder", streams=False)
FORMS = (
    Form("parquet", (".parquet", ".pq"), f"{_HERE}.parquet:write"),
    PARTITIONS,
    Form("arrow", (".arrow", ".feather"), f"{_HERE}.ipc:write"),
    Form("csv", (".csv",), f"{_HERE}.csv:write"),
    Form("netcdf", (".nc",), f"{_HERE}.netcdf:write", f"{_HERE}.grid:refuse", False, _NETCDF, True),
    Form("zarr", (".zarr",), f"{_HERE}.zarr:write", f"{_HERE}.grid:refuse", False, _ZARR, True),
)
_KNOWN = ".parquet, .arrow, .feather, .csv, .nc, .zarr, or a folder such as delta/ for Parquet in partitions"


def form_of(target: str, name: str | None = None) -> Form:
    """Return the form of a file by its suffix, or by its name. Raises ChoiceError."""
    if name:
        known = {form.name: form for form in FORMS}
        form = known[meant(name, known, "format")]
        return PARTITIONS if form.name == "parquet" and _is_folder(target) else form
    if _is_folder(target):
        return PARTITIONS
    if target == "-":
        raise ChoiceError("standard output has no suffix; say the format by -f parquet, arrow or csv")
    for form in FORMS:
        if target.rstrip("/" + os.sep).lower().endswith(form.suffixes):
            return form
    if os.path.isdir(target):
        return PARTITIONS
    suffix = os.path.splitext(target)[1]
    raise ChoiceError(f"{suffix or target[-40:]} is no form of columns; name a file with {_KNOWN}")


def need(what: str, *libraries: str) -> None:
    """Raise MissingExtraError if one of the libraries is not installed."""
    for library in libraries:
        if find_spec(library) is None:
            from kurbel.reading.extras import missing_extra

            raise missing_extra(f"{what} needs {library}", "scale")


def _is_folder(target: str) -> bool:
    # One whose suffix says so is a Zarr.
    return target.endswith(("/", os.sep)) and not target.rstrip("/" + os.sep).lower().endswith(".zarr")


def is_device(target: str) -> bool:
    """Whether there is something that is neither a file nor a folder."""
    return os.path.exists(target) and not os.path.isfile(target) and not os.path.isdir(target)
