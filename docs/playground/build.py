"""Build the playground, kurbel in the browser: python docs/playground/build.py build/site/playground.

The folder needs nothing from elsewhere: it has Pyodide, which is Python for browsers, kurbel of this checkout
and the libraries of wheels.txt. These are fetched once, by npm and pip, into build/playground; --fetch does
only that.
"""

from __future__ import annotations

import gzip
import hashlib
import io
import shutil
import subprocess
import sys
import tarfile
import tempfile
from collections.abc import Iterator
from pathlib import Path
from zipfile import ZipFile

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
PARTS = ROOT / "build" / "playground"
LOCKS = ("package.json", "package-lock.json", "wheels.txt")
PYODIDE = ("pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip")
# What wheels.txt is for: the Python of Pyodide, and for markupsafe any other.
FOR_BROWSERS = (
    "--platform=pyemscripten_2026_0_wasm32",
    "--platform=manylinux_2_17_x86_64",
    "--python-version=3.14",
    "--implementation=cp",
    *("--abi=cp314", "--abi=abi3", "--abi=none"),
)
# Loaded by itself, when a PDF is asked for: it is as large as all the rest.
LATER = "typst"
NOT_RUN = ("/test/", "/tests/", ".pyi", ".pxd", ".c", ".linux-gnu.so", "RECORD", "py.typed", "/sboms/")


def main(words: list[str]) -> int:
    if words == ["--fetch"]:
        fetch()
    elif len(words) == 1:
        build(Path(words[0]).absolute())
    else:
        print(f"usage: python {sys.argv[0]} FOLDER, or --fetch", file=sys.stderr)
        return 2
    return 0


def fetch() -> None:
    """Have npm and pip fetch what is locked, unless it is there."""
    locked = hashlib.sha256(b"".join((HERE / name).read_bytes() for name in LOCKS)).hexdigest()
    done = PARTS / "locked"
    if done.exists() and done.read_text() == locked:
        return
    shutil.rmtree(PARTS, ignore_errors=True)
    PARTS.mkdir(parents=True)
    for name in LOCKS:
        shutil.copy(HERE / name, PARTS)
    npm = shutil.which("npm") or sys.exit("npm, which fetches Pyodide, is not installed")
    _run(npm, "ci", "--prefix", PARTS, "--ignore-scripts", "--no-audit", "--no-fund", "--silent")
    wheels = ("--dest", PARTS / "wheels", "--requirement", PARTS / "wheels.txt", "--require-hashes")
    _pip("download", *wheels, "--no-deps", "--only-binary=:all:", *FOR_BROWSERS)
    done.write_text(locked)


def build(target: Path) -> None:
    """Write the folder, whole or not at all."""
    fetch()
    target.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=target.parent, prefix=".playground-") as name:
        folder, old = Path(name, "new"), Path(name, "old")
        shutil.copytree(HERE / "page", folder)
        (folder / "pyodide").mkdir()
        for file in PYODIDE:
            shutil.copyfile(PARTS / "node_modules" / "pyodide" / file, folder / "pyodide" / file)
        _pack(folder, Path(name, "packages"))
        _write_names(folder)
        if target.exists():
            target.rename(old)
        folder.rename(target)


def _pack(folder: Path, packages: Path) -> None:
    """Pack kurbel and its libraries, compiled by the Python that will run them."""
    for wheel in sorted((PARTS / "wheels").glob("*.whl")):
        is_later = wheel.name.startswith(f"{LATER}-")
        _unpack(wheel, packages / ("later" if is_later else "first") / "packages")
    with tempfile.TemporaryDirectory() as made:
        _pip("wheel", "--no-deps", "--no-build-isolation", "--wheel-dir", made, ROOT)
        (wheel,) = Path(made).glob("*.whl")
        _unpack(wheel, packages / "first" / "packages")
    shutil.copyfile(HERE / "console.py", packages / "first" / "packages" / "console.py")
    node = shutil.which("node") or sys.exit("Node.js, which compiles kurbel for browsers, is not installed")
    pyodide = PARTS / "node_modules" / "pyodide" / "pyodide.mjs"
    for one in ("first", "later"):
        _run(node, HERE / "compile.mjs", pyodide, packages / one / "packages")
    made_there = shutil.ignore_patterns("pages*", "sheet")
    shutil.copytree(ROOT / "examples", packages / "first" / "work" / "examples", ignore=made_there)
    for name, made_of in (("kurbel", "first"), (LATER, "later")):
        (folder / f"{name}.tar.gz").write_bytes(_tar(packages / made_of))


def _unpack(wheel: Path, folder: Path) -> None:
    with ZipFile(wheel) as archive:
        for name in archive.namelist():
            if not any(part in name if part.startswith("/") else name.endswith(part) for part in NOT_RUN):
                archive.extract(name, folder)


def _tar(folder: Path) -> bytes:
    """Return the files of a folder as an archive, the same for the same files."""
    packed = io.BytesIO()
    # No other format is read by as few lines: a name is in one place.
    with tarfile.open(fileobj=packed, mode="w", format=tarfile.USTAR_FORMAT) as archive:
        for path in _files(folder):
            content = path.read_bytes()
            about = tarfile.TarInfo(path.relative_to(folder).as_posix())
            about.size = len(content)
            archive.addfile(about, io.BytesIO(content))
    return gzip.compress(packed.getvalue(), mtime=0)


def _write_names(folder: Path) -> None:
    """Tell the service worker what to keep, under a name that changes with it."""
    files = [path for path in _files(folder) if path.name != "service.js"]
    content = hashlib.sha256()
    for path in files:
        content.update(path.read_bytes())
    names = [path.relative_to(folder).as_posix() for path in files if LATER not in path.name]
    service = folder / "service.js"
    text = service.read_text(encoding="utf-8")
    kept = text.replace("VERSION", content.hexdigest()[:16]).replace('"FILES"', str(names))
    service.write_text(kept, encoding="utf-8")


def _files(folder: Path) -> Iterator[Path]:
    return (path for path in sorted(folder.rglob("*")) if path.is_file())


def _pip(command: str, *words: str | Path) -> None:
    _run(sys.executable, "-m", "pip", command, "--quiet", "--disable-pip-version-check", *words)


def _run(*words: str | Path) -> None:
    subprocess.run([str(word) for word in words], check=True)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
