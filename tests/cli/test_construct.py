"""`kurbel construct`: which file is a drawing and which a table; refusals and the list are transcripts."""

from __future__ import annotations

from pathlib import Path

import pytest
from cli import printed

STARTS = {"png": b"\x89PNG", "pdf": b"%PDF", "pgf": b"% ", "svg": b"<?xml"}


@pytest.mark.parametrize("suffix", ["svg", "png", "pdf", "pgf", "html", "htm"])
def test_a_file_of_a_drawing_is_one(suffix: str, tmp_path: Path) -> None:
    path = tmp_path / f"fig.{suffix}"
    printed("construct", "forces", "--ratio=1:3", "-o", str(path))
    content = path.read_bytes()
    assert content.startswith(STARTS.get(suffix, b"<!DOCTYPE html>"))
    assert suffix != "svg" or b"<table" not in content


def test_the_table_is_that_of_a_drawing_format_where_it_is_asked_for(tmp_path: Path) -> None:
    path = tmp_path / "fig.html"
    printed("construct", "blau-9", "--table", "-o", str(path))
    page = path.read_text(encoding="utf-8")
    assert page.count("<table") == 1
    assert "<svg" not in page


def test_a_file_says_its_format_also_where_the_environment_has_another(tmp_path: Path) -> None:
    assert printed("construct", "blau-9", KURBEL_FORMAT="csv").out.startswith("length,symbol,")
    printed("construct", "blau-9", "-o", str(tmp_path / "fig.svg"), KURBEL_FORMAT="csv")
    assert (tmp_path / "fig.svg").read_bytes().startswith(b"<?xml")
