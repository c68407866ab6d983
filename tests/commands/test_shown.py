"""A table shows itself, is saved whole, and becomes arrays and frames; a drawing shows itself, too."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pandas
import polars
import polars.testing
import pyarrow
import pytest
from drawings import drawn

import kurbel
from kurbel.exact.numerals import Number, number_text

PAGE = kurbel.table("1:4;1:4,5", angle="0;22,5;90", columns="ratio,phi,x,p", lang="en")
KEYS = ["ratio", "phi", "x", "p"]


def printed_numbers(key: str) -> list[str]:
    place = KEYS.index(key)
    found = [row[place] for row in PAGE.records.rows]
    assert all(isinstance(value, Number) for value in found)
    return [number_text(value) for value in found if isinstance(value, Number)]


def test_a_table_prints_as_text_and_has_a_short_name() -> None:
    assert str(PAGE) == kurbel.typeset(PAGE)
    assert repr(PAGE) == "<kurbel.Table kinematics: Piston path and piston acceleration; exact formulas>"


def test_a_notebook_shows_it_as_the_formats_set_it() -> None:
    assert kurbel.typeset(PAGE, "html").partition("<figure")[2] in PAGE._repr_html_()
    assert PAGE._repr_latex_() == kurbel.typeset(PAGE, "latex")
    assert PAGE._repr_markdown_() == kurbel.typeset(PAGE, "markdown")


@pytest.mark.parametrize("suffix", ["txt", "md", "tex", "html", "typ", "csv", "json"])
def test_it_is_saved_in_the_format_of_the_suffix(suffix: str, tmp_path: Path) -> None:
    names = {"txt": "text", "md": "markdown", "tex": "latex", "typ": "typst"}
    path = tmp_path / f"page.{suffix}"
    PAGE.save(path)
    assert path.read_text(encoding="utf-8") == kurbel.typeset(PAGE, names.get(suffix, suffix))


def test_it_is_saved_with_the_options_of_printing_and_as_pdf(tmp_path: Path) -> None:
    PAGE.save(tmp_path / "page.tex", decimal="comma", standalone=True, longtable=True)
    expected = kurbel.typeset(PAGE, "latex", decimal="comma", standalone=True, longtable=True)
    assert (tmp_path / "page.tex").read_text(encoding="utf-8") == expected
    PAGE.save(str(tmp_path / "page.pdf"))
    assert (tmp_path / "page.pdf").read_bytes().startswith(b"%PDF")


def test_what_cannot_be_saved_leaves_the_old_file(tmp_path: Path) -> None:
    path = tmp_path / "page.csv"
    path.write_text("old")
    with pytest.raises(kurbel.KurbelError, match='no decimal mark "dot"'):
        PAGE.save(path, decimal="dot")
    with pytest.raises(kurbel.KurbelError, match=r"the file name '.*page.doc' names no format"):
        PAGE.save(tmp_path / "page.doc")
    assert [(one.name, one.read_text()) for one in tmp_path.iterdir()] == [("page.csv", "old")]


def test_arrays_and_frames_have_the_printed_numbers_and_what_they_mean() -> None:
    array, arrow, exact = PAGE.to_numpy(), pyarrow.table(PAGE), PAGE.to_pandas(exact=True)
    frames = (PAGE.to_pandas(), PAGE.to_polars(), polars.DataFrame(PAGE), pandas.DataFrame.from_arrow(PAGE))
    assert [*array.dtype.names] == arrow.column_names == KEYS
    assert all([*frame.columns] == KEYS for frame in frames)
    for key in KEYS[1:]:
        printed = printed_numbers(key)
        values = [float(text) for text in printed]
        assert array[key].dtype == np.float64
        assert array[key].tolist() == arrow[key].to_pylist() == values
        assert all([*frame[key]] == values for frame in frames)
        assert [*map(str, exact[key])] == [*map(str, PAGE.to_polars(exact=True)[key])] == printed
    ratios = ["1:4"] * 3 + ["1:4.5"] * 3
    assert array["ratio"].tolist() == arrow["ratio"].to_pylist() == [*frames[0]["ratio"]] == ratios
    assert frames[1].schema == {"ratio": polars.String, **dict.fromkeys(KEYS[1:], polars.Float64)}
    assert frames[0].attrs["phi"] == {"name": "Crank angle", "symbol": "φ", "unit": "°", "decimals": "1"}
    assert arrow.schema.field("phi").metadata[b"unit"] == "°".encode()
    assert arrow.schema.metadata[b"table"] == b"kinematics"


def test_a_page_is_as_long_as_its_records_and_has_rows_and_columns() -> None:
    assert len(PAGE) == 6
    assert PAGE
    for key in KEYS[1:]:
        assert [f"{value:.{4 if key != 'phi' else 1}f}" for value in PAGE[key]] == printed_numbers(key)
    assert PAGE["ratio"].tolist() == ["1:4"] * 3 + ["1:4.5"] * 3
    assert PAGE["acceleration"].tolist() == PAGE["p"].tolist()
    rows = [*PAGE]
    assert [row._fields for row in rows] == [tuple(KEYS)] * 6
    assert [*zip(*rows, strict=True)] == [tuple(PAGE[key].tolist()) for key in KEYS]
    with pytest.raises(kurbel.KurbelError, match=r'no column "phl" \(did you mean phi\?\)'):
        PAGE["phl"]


def test_a_frame_is_made_of_the_page_itself() -> None:
    missing = kurbel.inertia(
        centre=0.9, gyration=0.3, layout="inertia-errors", columns="force,model,error,error_phi"
    )
    for page in (PAGE, missing, kurbel.example("blau", 35)):
        pandas.testing.assert_frame_equal(pandas.DataFrame(page), page.to_pandas())
        polars.testing.assert_frame_equal(polars.DataFrame(page), page.to_polars())


def test_missing_values_stay_missing_and_mixed_columns_are_text() -> None:
    page = kurbel.inertia(
        centre=0.9, gyration=0.3, layout="inertia-errors", columns="force,model,error,error_phi"
    )
    frame = page.to_polars()
    assert frame["error"].to_list()[0] is None
    assert np.isnan(page.to_numpy()["error"][0])
    assert page.to_pandas()["error"].isna()[0]
    assert pyarrow.table(page)["error"].to_pylist() == frame["error"].to_list()
    example = kurbel.example("blau", 35).to_polars()
    assert example["printed"].dtype == polars.String
    assert example["printed"].to_list()[-1] == "−5/2"


@pytest.mark.parametrize(
    ("module", "convert", "package"),
    [
        ("pandas", lambda: PAGE.to_pandas(), "pandas"),
        ("polars", lambda: PAGE.to_polars(), "polars"),
        ("arro3.core", lambda: PAGE.__arrow_c_stream__(), r"\[arrow\].*'"),
    ],
)
def test_a_missing_library_is_one_sentence(
    module: str, convert: object, package: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    assert callable(convert)
    with pytest.raises(kurbel.KurbelError, match=rf"; install it with: \S+ -m pip install .*{package}$"):
        convert()


def test_a_drawing_shows_itself_and_is_saved(tmp_path: Path) -> None:
    drawing = drawn(kurbel.table, "1:5", columns="x", step=10, lang="en")
    assert repr(drawing) == "<kurbel.Drawing: Piston path for R:L = 1:5; exact formulas>"
    assert drawing._repr_svg_().startswith("<?xml")
    drawing.save(tmp_path / "path.svg")
    assert (tmp_path / "path.svg").read_text(encoding="utf-8") == drawing._repr_svg_()
    drawing.save(tmp_path / "path.png")
    assert (tmp_path / "path.png").read_bytes().startswith(b"\x89PNG")
    with pytest.raises(kurbel.KurbelError, match=r"names no drawing; its suffix must be one of \.svg"):
        drawing.save(tmp_path / "path.txt")
