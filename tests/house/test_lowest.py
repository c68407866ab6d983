"""With the lowest versions of all dependencies that pyproject.toml allows, each does what it is there for."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from places import ROOT

# Files whose tests go through every dependency: units, drawings, PDF, workbooks, frames, sweeps and numba.
TESTED = (
    "reading/test_units.py",
    "commands/test_shown.py",
    "formats/test_workbook.py",
    "formats/test_pdf.py",
    "plot/test_plotting.py",
    "sweeps/test_files.py",
    "kernel/test_fast.py",
)


@pytest.mark.slow
def test_the_lowest_versions_suffice(tmp_path: Path) -> None:
    lowest, python = tmp_path / "lowest.txt", tmp_path / "environment" / "bin" / "python"
    project = str(ROOT / "pyproject.toml")

    # As pip does, it trusts whom the system trusts.
    trusting = os.environ | {"UV_SYSTEM_CERTS": "true", "UV_NATIVE_TLS": "true"}

    def uv(*words: str) -> None:
        done = subprocess.run(
            [sys.executable, "-m", "uv", *words],
            cwd=ROOT, env=trusting, capture_output=True, text=True, check=False,
        )  # fmt: skip
        assert done.returncode == 0, done.stderr

    # What needs a compiler is not for users; the tools of the tests themselves may be as new as they are.
    direct = ("--resolution", "lowest-direct", "--only-binary", ":all:", "--python", sys.executable)
    uv("pip", "compile", "--quiet", *direct, "--all-extras", project, "--output-file", str(lowest))
    uv("venv", "--quiet", "--seed", "--python", sys.executable, str(python.parents[1]))
    environment = ("--python", str(python), "--constraint", str(lowest), "--group", "dev", "--all-extras")
    uv("pip", "install", "--quiet", *environment, "--requirement", project, "--editable", str(ROOT))
    clean = {name: text for name, text in os.environ.items() if "KURBEL" not in name}
    tests = [str(ROOT / "tests" / name) for name in TESTED]
    run = subprocess.run(
        [str(python), "-m", "pytest", "-q", "-p", "no:cacheprovider", "-m", "not slow", *tests],
        cwd=ROOT, env=clean, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert run.returncode == 0, run.stdout[-4000:]
