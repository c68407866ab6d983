"""The wheel holds all that is needed: installed into an empty environment it prints a table anywhere."""

from __future__ import annotations

import shutil
import subprocess
import sys
import zipfile
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest
from places import ROOT


def built(checkout: Path, folder: Path) -> Path:
    words = ("-m", "build", "--wheel", "--no-isolation", "--outdir", str(folder), str(checkout))
    subprocess.run([sys.executable, *words], check=True, capture_output=True)
    (found,) = folder.glob("*.whl")
    return found


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(ROOT, tmp_path_factory.mktemp("wheel"))


def texts(wheel: Path, names: Iterable[str]) -> Iterator[tuple[str, str]]:
    """Yield what a wheel says of itself."""
    for name in names:
        if ".dist-info/" in name:
            yield name, zipfile.ZipFile(wheel).read(name).decode()


@pytest.mark.slow
def test_the_wheel_holds_templates_sources_and_types(wheel: Path) -> None:
    names = zipfile.ZipFile(wheel).namelist()
    assert "kurbel/py.typed" in names
    # The licence of the font, and who it is from, go along with that of kurbel.
    licences = {name: text for name, text in texts(wheel, names) if "/licenses/" in name}
    assert any(text.startswith("MIT License") for text in licences.values())
    assert any("The Libertinus Project Authors" in text for text in licences.values())
    (metadata,) = (text for name, text in texts(wheel, names) if name.endswith(".dist-info/METADATA"))
    assert "License-Expression: MIT AND OFL-1.1\n" in metadata
    assert metadata.count("License-File: ") == len(licences) == 2
    assert not any("__pycache__" in name for name in names)
    for layout in {*(ROOT / "templates").rglob("*.*")} - {*(ROOT / "templates").glob("__pycache__/*")}:
        assert f"kurbel/templates/{layout.relative_to(ROOT / 'templates').as_posix()}" in names
    # What `kurbel help` searches and shows.
    for page in (
        *ROOT.glob("docs/howto/*.md"),
        *ROOT.glob("docs/subjects/*.md"),
        *ROOT.glob("docs/books/*.md"),
        *ROOT.glob("examples/problems/*.toml"),
    ):
        assert f"kurbel/{page.relative_to(ROOT).as_posix()}" in names
    for file in (ROOT / "src" / "kurbel").glob("books/sources/**/*.*"):
        assert file.relative_to(ROOT / "src").as_posix() in names


@pytest.mark.slow
def test_the_wheel_has_the_same_bytes_from_another_folder_at_another_time(
    wheel: Path, tmp_path: Path
) -> None:
    checkout = tmp_path / "elsewhere"
    left_out = shutil.ignore_patterns(".git", ".venv", "build", "node_modules", "__pycache__")
    shutil.copytree(ROOT, checkout, ignore=left_out, copy_function=shutil.copyfile)
    again = built(checkout, tmp_path / "wheel")
    assert again.name == wheel.name
    assert again.read_bytes() == wheel.read_bytes()


@pytest.mark.slow
def test_an_installed_wheel_prints_a_table_from_another_directory(wheel: Path, tmp_path: Path) -> None:
    environment = tmp_path / "environment"
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", str(environment)], check=True)
    python = environment / "bin" / "python"
    # Compiling the modules of the libraries would take most of the time.
    pip = [sys.executable, "-m", "pip", "--python", str(python), "install", "--quiet", "--no-compile"]
    subprocess.run([*pip, str(wheel)], check=True, capture_output=True)
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    run = subprocess.run(
        [str(environment / "bin" / "kurbel"), "table", "--ratio", "1:5", "-f", "csv", "--angle", "90"],
        check=True, capture_output=True, text=True, cwd=elsewhere, env={},
    )  # fmt: skip
    assert run.stdout.splitlines() == [
        "ratio,phi,x,x_return,c,c_return,p,p_return",
        "1:5,90,1.1010,0.8990,1.0000,1.0000,-0.2041,0.2041",
    ]
    read = subprocess.run(
        [str(environment / "bin" / "kurbel"), "help", "subjects/forces"],
        check=True, capture_output=True, text=True, cwd=elsewhere, env={"PYTHONUTF8": "1"},
    )  # fmt: skip
    assert read.stdout == (ROOT / "docs" / "subjects" / "forces.md").read_text(encoding="utf-8")
    page = subprocess.run(
        [str(python), "-m", "kurbel", "table", "--layout", "roetscher-112", "-f", "latex"],
        check=True, capture_output=True, text=True, cwd=elsewhere, env={"PYTHONUTF8": "1"},
    )  # fmt: skip
    assert r"\toprule" in page.stdout
    worked = subprocess.run(
        [str(python), "-m", "kurbel", "example", "blau", "35", "-f", "csv"],
        check=True, capture_output=True, text=True, cwd=elsewhere, env={"PYTHONUTF8": "1"},
    )  # fmt: skip
    assert worked.stdout.splitlines()[-1].endswith("other,cos α,−5/2,−5/2,")
